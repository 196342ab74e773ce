"""Emitters: kernels as any-arithmetic Python, C99 and NumPy ufuncs.

naming          every emitted name
body            common subexpressions, eliminated once
any_arithmetic  Python over any arithmetic, and the tables of a system
c               C99 functions and their header
function        what a C function takes and gives
solver          Newton's method and derivatives of an orbit, compiled over lanes of points
gufunc          NumPy generalized ufuncs around the C functions
admissibility   the compiled admissibility test
python_file     the Python file of one system: tables of names and domains, then kernels
piece           one configuration of a system that has too many to list
emit            the files of one system, and of the package
regenerate      write them, or check them against the derivation
"""
