"""Motions from event to event, exactly, and what is observed along them.

========================  =====================================================================
`simulate`                `simulate`, `simulate_many`: one motion, or many in threads
`trajectory`              `Trajectory`: the transitions of a motion, and its state at any time
`starting`                a start by names, and the configuration that it belongs to
`visiting`                configurations that are made when motions visit them
`engines`                 the engine in C where it is built, else the one in Python
`stepping`                the engine in Python: the fallback, and the judge of the one in C
`extremes`                guaranteed extremes of affine functions of the state along a motion
`last_cycle`              `itinerary_of`: the cycle at the end of a motion
`lyapunov`                `lyapunov`: exponents of a motion, with their errors
`observables`             `observe`: peaks, averages, contact and friction forces
`observable_derivatives`  derivatives of extremes, averages, times in configurations
`one_sided`               where a motion has one-sided derivatives alone
`coming_apart`            boundaries reached together, in the order of the moved motion
`phase_functions`         affine functions of the state along the phases of a motion
`recurrence`              the phases after which a motion comes back
`returns`                 `poincare_map`: the Poincare map by simulation
`tangent`                 derivatives of a motion by its start
`derivatives`             `Trajectory.derivatives`: a motion by parameters and start, both ways
`motion_function`         `motion_function`: a motion as a function with exact derivatives
`flow_derivatives`        derivatives of flows by the entries of their fields
`motion_linearisation`    a motion's phases and transitions, linearised for all directions
`start_derivatives`       what a start may do: on constraints, at phases of forcings
`transition_derivatives`  velocities, jumps, rows and resets of a motion's transitions
========================  =====================================================================
"""
