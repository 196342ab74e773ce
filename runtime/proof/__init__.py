"""Certificates: a periodic orbit, its admissibility and its stability proved in balls.

================  ============================================================
`models`          Taylor models: balls that know how they depend on parameters
`quotients`       rational functions of parameters, exactly
`tables`          a system's numbers: at a parameter point, or as functions of parameters
`chain`           the equations of a cycle, their Jacobian and the Poincare map, in balls
`closing`         how a cycle closes: by its state, at a given period, or with a forcing
`existence`       Newton's method in balls, and Krawczyk's test on a box
`location`        the box in which an orbit is unique
`known`           which boundary functions are exactly zero where a phase begins or ends
`vanishing`       what is zero along one orbit because that closes
`plan`            what has to be shown of each phase, as far as exact arithmetic tells
`waves`           whether an affine function stays negative along a phase
`admissibility`   all boundaries for all times of all phases, and each transition
`multipliers`     trace, multipliers, and on which side of the unit circle they are
`subject`         what is to be proved: an orbit of any kind as a cycle of its system
`certify`         all of it together
`statement`       the exact system, as files state it
`certificate`     what is proved, with enclosures; JSON
`saved`           certificates in files
`comparing`       whether a certificate is of the system that it names
`checking`        the check of a file of any kind
`checker`         the sceptic's own proof, from the file alone: to be read in one sitting
================  ============================================================

and three rooms with maps of their own: `boxes`, an orbit for all parameters of a box;
`counting`, all orbits of an itinerary in a box; `events`, bifurcations enclosed.
"""
