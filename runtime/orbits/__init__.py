"""One periodic orbit, or one at each of many parameter points: solved, refined, judged.

=======================  ========================================================================
`solve`                  `solve`: one orbit at one parameter point
`many`                   `solve_many`: many parameter points, in C and in threads
`problem`                `OrbitProblem`: what kernels and tables answer alike
`equations`              `OrbitEquations`: the equations near an orbit, at many points
`points`                 `OrbitPoints`: one orbit at many points of a chart
`orbit`                  `Orbit`: the record of a periodic orbit, and all that can be asked of it
`refine`                 `refine`: any number of digits, by Newton's method with growing precision
`stability`              Poincare map, multipliers and the trace criterion
`admissible`             whether a solution of the equations is a motion of the real system
`motion`                 the state at any time of an orbit, from the closed-form flows
`declared_kernels`       compiled kernels that stand in for a composed orbit's tables
`declared_many`          declared orbits without kernels at many parameter points
`declared_points`        such an orbit at the points of a chart, by compiled kernels
`declared_solve`         a declared orbit without kernels at one parameter point
`derivatives`            `OrbitDerivatives`: an orbit's derivatives by what was given
`directions`             how an orbit moves with what was given: the linear equations
`kernel_directions`      the same by kernels
`kernel_equations`       they, by kernels
`kernel_many`            many orbits by their kernels: compiled, or on NumPy
`kernel_points`          an orbit at the points of a chart, by its kernels
`kernel_problem`         `KernelProblem`: the answers of derived kernels
`kernel_solve`           one orbit by its kernels
`kernel_values`          kernels of an orbit at its own numbers
`many_derivatives`       derivatives of many orbits of one itinerary
`impact_losses`          energy that impacts take along an orbit
`local_extremes`         local extremes along an orbit, of which peaks are the largest
`motion_derivatives`     derivatives of what is seen along an orbit: extremes, margins, states
`nearby`                 the same orbit at other parameters, followed from where it is known
`orbit_arrays`           the record of the orbits of one itinerary at many parameter points
`orbit_function`         quantities of an orbit as functions with exact derivatives
`physical_parameters`    all parameters of an orbit's system; what the orbit leaves open is chosen
`routes`                 itineraries through coupled contacts: the routes of the law are listed
`table_admissible`       admissibility, by a system's tables
`table_digits`           how many digits rounding leaves of orbits by tables
`table_directions`       how an orbit moves with what was given, by tables
`table_directions_many`  the same at many points: compiled, or on NumPy
`table_equations`        they, by a system's tables
`table_limits`           which limit of admissibility an orbit fails first, by tables
`table_many`             many orbits of one itinerary, by their system's tables
`table_motion`           the motion along an orbit, as a trajectory
`table_phase_functions`  boundary functions and conditions along the phases, by tables
`table_points`           an orbit at the points of a chart, by tables
`table_problem`          `TableProblem`: the answers of a system's tables, for any itinerary
`table_refine`           any number of digits, by a system's tables
`table_solve`            one orbit of any itinerary, by its system's tables
=======================  ========================================================================
"""
