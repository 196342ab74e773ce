"""A system and its orbits as numbers: tables, kernels, parameters, closed-form flows."""
