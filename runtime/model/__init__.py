"""A system and its orbits as numbers: tables, kernels, parameters, closed-form flows.

=====================  ============================================================================
`loading`              systems that users declare
`contacts`             contacts that the mass matrix couples
`kernels`              the one door to `generated/`: `load_system`, `load_orbit`
`kernel_records`       records of the emitted tables and kernels: of a system, and of an orbit
`parameters`           domains of parameters, and the constraints between those of a system
`completion`           from the parameters that are given to all that an orbit and its system take
`structure`            configurations, boundaries and transitions by index, without parameters
`piecewise`            a system at a parameter point: affine rows, fields, flows and resets
`boundary_sets`        sets of boundaries as masks
`engine_layout`        the integers and numbers that the compiled engine reads
`engine_run`           what an engine gives: the transitions of one motion, and why it ended
`exponential`          flows as exponentials of vector fields, in mpmath numbers
`flows`                states inside a configuration from its closed-form flow, at many times
`factored_flows`       flows of large configurations: factors in place of matrices
`large_modes`          modes of configurations with many states, as factors
`modes`                modes of a configuration from its numbers, where its flow has no closed form
`simple_modes`         the same of many at once, where eigenvalues are apart
`balancing`            which states depend on which; rows and columns of like size
`natural_units`        units of time and states in which a motion's numbers are near 1
`driven_modes`         modes of a structure that is driven by states which move by themselves
`naming`               names of unknowns, and names as people see them
`parameter_batches`    completion of many parameter points at once: arrays that broadcast
`projectors`           spectral projectors of clusters of eigenvalues, in the digits they need
`quasi_polynomials`    values, errors and bounds of sums of t^k e^(st)
`time_functions`       functions of time of a configuration's modes: values, derivatives and bounds
`units`                units as systems declare them, for the labels of pictures
`eigenvalue_clusters`  clusters of a matrix's eigenvalues whose sum is its exponential
`saved_orbit`          orbits as data, with their system: what a chart holds of what it is of
`saved_system`         systems as data: what result files hold of those that are not built in
`table_derivatives`    derivatives of fields, rows and resets by all parameters
=====================  ============================================================================
"""
