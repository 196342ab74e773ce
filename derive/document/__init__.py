"""The derivation as a document, made of the derivation's own objects.

================  ==============================================================
`latex`           documents as LaTeX and PDF
`hypertext`       documents as Markdown and HTML
`describe`        documents of systems, orbits and itineraries
`sections`        their sections, each a template of sentences and formulas
`template`        what a template may say, and how it is filled
`view`            what a section describes: a system, equations, an itinerary
`notation`        words, relations and letters that all sections share
`printer`         symbols and expressions as LaTeX, in the order of reading
`symbols`         names as LaTeX, letters that no symbol has
`blocks`          headings, paragraphs, formulas, tables; where lines break
================  ==============================================================
"""
