"""One periodic orbit, or one at each of many parameter points: solved, refined, judged.

=====================  ============================================================================
`solve`                `solve`: one orbit at one parameter point
`many`                 `solve_many`: many parameter points, in C and in threads
`orbit`                `Orbit`: the record of a periodic orbit, and all that can be asked of it
`refine`               `refine`: any number of digits, by Newton's method with growing precision
`stability`            Poincare map, multipliers and the trace criterion
`admissible`           whether a solution of the equations is a motion of the real system
`motion`               the state at any time of an orbit, from the closed-form flows
`compose`              `compose`: an orbit of any itinerary, from its system's flows
`compose_many`         `compose_many`: the orbits of one itinerary at many parameter points
`composed_admissible`  whether a composed orbit is a motion of the real system, in double precision
`composed_motion`      the motion along a composed orbit
`composed_orbit`       `ComposedOrbit`: the record of a composed orbit
`composed_refine`      a composed orbit to any number of digits
`named`                declared orbits without kernels: composed from the numbers of their systems
`named_many`           declared orbits without kernels at many parameter points
`physical_parameters`  all parameters of an orbit's system; what the orbit leaves open is chosen
`routes`               itineraries through coupled contacts: the routes of the law are listed
=====================  ============================================================================
"""
