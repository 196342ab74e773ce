"""Periodic orbits of any itinerary, composed from a system's flows at run time.

============  ==============================================================
`passage`     one passage of a cycle and its linearisation, in any arithmetic
`newton`      Newton's method on start and dwell times: compiled, or in NumPy
`stability`   sections, multipliers, saltation matrices
`admissible`  whether a composed orbit is a motion of the real system
`composed`    one orbit: `compose`, `ComposedOrbit`
`batch`       many parameter points: `compose_many`
`precise`     any number of digits
============  ==============================================================
"""
