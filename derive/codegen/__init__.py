"""Emitters: kernels as any-arithmetic Python, C99, NumPy ufuncs and LaTeX.

naming          every emitted name
body            common subexpressions, eliminated once
any_arithmetic  Python over any arithmetic, and the tables of a system
c               C99 functions and their header
solver          Newton's method on the reduced equations, compiled over lanes of points
gufunc          NumPy generalized ufuncs around the C functions
document        the derivation as a document: LaTeX, Markdown, HTML, PDF
emit            the files of one system
"""
