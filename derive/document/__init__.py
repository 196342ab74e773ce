"""The derivation as a document, made of the derivation's own objects.

`describe` makes a Document of a system or an orbit; `latex`, `markdown` and `hypertext`
write it. Below them: `blocks` (the model), the sections in `describe_*`, `flows`, and how
things are named and set, in `symbols`, `printer`, `wording` and `layout`.
"""
