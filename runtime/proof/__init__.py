"""Theorems about periodic orbits and motions, proved in ball arithmetic.

==========================  =======================================================================
`basin`                     starts from which every motion tends to an orbit
`boxes`                     proofs for all parameters of a box
`branch`                    whole branches: every interval, every event, and that there is no other
`chaos`                     symbolic dynamics by sets that cover each other, and its entropy
`counting`                  all orbits of an itinerary in a box of dwell times, each proved
`doubling`                  orbits of twice the period beside flips, their side and stability
`events`                    events of branches, enclosed to any precision
`graphs`                    graphs of boxes: trapping regions, and where motions recur
`motion`                    the sequence of configurations of a simulated motion, proved
`sets`                      sets of states carried through the phases of a motion
`certify_orbit`             `certify`: existence, admissibility and stability of one orbit
`certificate`               `Certificate`: what is proved of an orbit, with enclosures
`admissibility`             whether a proved orbit is a motion of the real system
`admissibility_conditions`  what has to be shown of a cycle for it to be a motion, phase by phase
`contact_statement`         the contact law, as a certificate states it
`orbit_equations`           closure and switching in balls, their Jacobian, the Poincare map
`exact_closure`             closure conditions that make a cycle's equations square and nonsingular
`symplectic_form`           the form and the energies that a conservative cycle keeps
`enclosure`                 the box that contains exactly one orbit
`exact_tables`              a system's numbers, rational where the parameters are, else balls
`expansion`                 Taylor expansions of affine functions along a phase
`invariants`                affine functions that vanish where phases begin and end
`krawczyk`                  Newton's method towards a root, and the test that a box has exactly one
`multipliers`               trace and multipliers, and on which side of the unit circle they are
`orbit_claims`              what is claimed of one orbit: existence, admissibility, stability
`orbit_to_prove`            what is to be proved: an orbit of any kind as a cycle of its system
`parameter_derivatives`     how a proved orbit moves with its parameters
`parametric_declaration`    the declaration of a file, as functions of its parameters
`refusals`                  what the checker does not prove, asked before it is stated
`sign_along_phase`          whether an affine function stays negative along a phase
`statement`                 the exact system, as a certificate states it and the checker reads it
`vanishing`                 affine functions that vanish along one orbit because it closes
==========================  =======================================================================
"""
