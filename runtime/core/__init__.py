"""What every room needs and no room owns: exact values, arithmetics, errors, files, names.

====================  ==================================================================
`values`              exact values of parameters, and decimal printing
`arithmetic`          one set of functions for floats, mpmath and balls
`errors`              the exceptions of the package, under one root
`files`               files that are written whole or not at all
`json_codec`          records to JSON and back
`matrices`            exponentials and eigenvalues of many small matrices at once
`rational_functions`  exact arithmetic of rational functions of parameters
`registry`            how records find the functions that show and keep them, by name
`result_files`        the codec of result files: format, version, checksum
`resuming`            whether interrupted work asked the same
`taylor_models`       functions of a few variables as polynomials with ball coefficients
`vectorised`          any-arithmetic kernels as NumPy generalized ufuncs
====================  ==================================================================
"""
