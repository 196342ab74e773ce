"""What every room needs and no room owns: exact values, arithmetics, errors, files, names.

=========================  ==================================================================
`values`                   exact values of parameters, and decimal printing
`arithmetic`               one set of functions for floats, mpmath and balls
`archives`                 arrays in .npz archives, unpacked only as far as is expected
`box_grid`                 grids of boxes, and which of them others meet
`complex_steps`            derivatives by tiny imaginary parts, in doubles and in any digits
`divided_grid`             the same with boxes of several sizes, some divided
`differentiable`           functions with exact derivatives, as optimisers take them
`errors`                   the exceptions of the package, under one root
`exponential_balls`        divided differences of the exponential in balls and Taylor models
`exponential_differences`  the same in doubles
`expressions`              functions as data, in one small grammar, over any arithmetic
`files`                    files that are written whole or not at all
`float_sets`               many affine sets at once, in doubles with bounds of all roundings
`float_flows`              linear flows of such sets, at many times at once
`irrational_numbers`       irrational numbers by few of them, and their exact relations
`jets`                     numbers with their derivatives along a direction, in balls
`json_codec`               records to JSON and back
`matrices`                 exponentials and eigenvalues of many small matrices at once
`matrix_chains`            products of many matrices of balls, in frames that turn with them
`processes`                work in several processes, in the order of its batches
`quadrature`               integrals by Gauss and Legendre's rule
`rational_functions`       exact arithmetic of rational functions of parameters
`registry`                 how records find the functions that show and keep them, by name
`result_files`             the codec of result files: format, version, checksum
`resuming`                 whether interrupted work asked the same
`showing`                  how results show themselves, in a few lines and as a table
`taylor_averages`          averages of Taylor models over an interval of one variable
`taylor_models`            functions of a few variables as polynomials with ball coefficients
`valid_json`               answers as JSON without NaN and Infinity
`vectorised`               any-arithmetic kernels as NumPy generalized ufuncs
`workload`                 how large a work is, before it begins
`threads`                  threads whose compiled loops end when their caller is interrupted
=========================  ==================================================================
"""
