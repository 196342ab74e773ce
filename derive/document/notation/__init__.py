"""How the derivation is written: letters, symbols, the order of terms, and words.

================  ==============================================================
`printer`         expressions as LaTeX, in the order that a person would choose
`symbols`         how symbols of the derivation are written
`arrange`         sums arranged function by function of time
`wording`         words and lines that all sections share
`letters`         letters for matrices and vectors that no symbol has
`characteristic`  characteristic polynomials that are short enough to read
================  ==============================================================
"""
