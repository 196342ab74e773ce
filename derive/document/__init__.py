"""The derivation as a document, made of the derivation's own objects.

================  ==============================================================
`writers`         documents as LaTeX, Markdown, HTML
`equation_table`  the equations of an orbit in a notebook
`describe`        documents of systems, orbits and itineraries
`sections`        their sections, each a template of sentences and formulas
`views`           what is described, prepared for it
`notation`        letters, symbols, the order of terms, words
`blocks`          headings, paragraphs, formulas, tables
`layout`          widths of formulas, and where their lines break
================  ==============================================================
"""
