"""Periodic orbits of any itinerary, composed from a system's flows at run time.

============  ==============================================================
`passage`     one passage of a cycle and its linearisation, in any arithmetic
`newton`      Newton's method on start and dwell times: compiled, or in NumPy
`stability`   sections, multipliers, saltation matrices
`admissible`  whether a composed orbit is a motion of the real system
`symmetry`    orbits of which a symmetry closes a part
`composed`    one orbit: `compose`
`record`      `ComposedOrbit` and what can be asked of it
`motion`      the motion along it
`naming`      names of its unknowns
`named`       declared orbits without kernels
`recurring`   itineraries of simulated motions
`batch`       many parameter points: `compose_many`
`precise`     any number of digits
`report`      a composed orbit as JSON
`saved`       a composed orbit in a file
============  ==============================================================
"""
