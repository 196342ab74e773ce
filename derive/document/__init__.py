"""The derivation as a document, made of the derivation's own objects.

================  ==============================================================
`latex`           documents as LaTeX and PDF
`hypertext`       documents as Markdown and HTML
`describe`        documents of systems, orbits and itineraries
`sections`        their sections, each a template of sentences and formulas
`view`            an orbit: its equations, how they are written, saltation matrices
`cycle`           an itinerary: the section at its start, transitions once each
`wording`         words and lines that all sections share
`printer`         expressions as LaTeX, in the order that a person would choose
`symbols`         how symbols of the derivation are written, letters that none has
`blocks`          headings, paragraphs, formulas, tables; where lines break
================  ==============================================================
"""
