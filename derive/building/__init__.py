"""Oscillators from matrices and elements: stops, friction, sliders, forcing.

====================  =========================================================
`oscillator`          the one function: matrices and elements to a System
`elements`            RigidStop, SoftStop, Friction, Slider, Regions, Harmonic
`matrices`            matrices of a chain of masses, as arrays of doubles, in files
`reduction`           large structures reduced to kept coordinates and modes
`structure_matrices`  their checked matrices, and lowest modes
`frame`               coordinates, states and parameters by name
`parts`               the elements as local regimes
`element_parts`       how each element becomes a part
`assembly`            motion, reactions and boundaries of the products of regimes
`transitions`         what follows boundaries that are reached at once; the law of contacts
`impacts`             Newton's and Moreau's laws of impact for any mass matrix
`resting`             contacts at rest, or that lift, land, are exhausted or recover
`growing`             systems whose configurations are made when they are visited
====================  =========================================================
"""
