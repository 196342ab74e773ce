"""Events of branches enclosed: bifurcations and limits of admissibility, to any precision."""
