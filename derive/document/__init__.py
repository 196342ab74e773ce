"""The derivation as a document, made of the derivation's own objects.

================  ==============================================================
`latex`           documents as LaTeX and PDF
`hypertext`       documents as Markdown and HTML
`describe`        documents of systems, orbits and itineraries
`sections`        their sections, each a template of sentences and formulas
`views`           what is described, prepared for it
`notation`        letters, symbols, the order of terms, words
`blocks`          headings, paragraphs, formulas, tables; where lines break
================  ==============================================================
"""
