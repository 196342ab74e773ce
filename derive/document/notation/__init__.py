"""How the derivation is written: letters, symbols, the order of terms, and words.

==========  ==============================================================
`printer`   expressions as LaTeX, in the order that a person would choose
`symbols`   how symbols of the derivation are written, letters that none has
`wording`   words and lines that all sections share
==========  ==============================================================
"""
