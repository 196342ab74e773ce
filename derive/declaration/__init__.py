"""What an oscillator is and which orbit is meant: frozen records, checked when they are made.

===============  ==============================================================
`fields`         what a record is given, made what its annotations say
`formulas`       texts of formulas, read without executing them
`algebra`        normal forms of rational expressions
`real_numbers`   irrational numbers: whether they are real, and their texts
`parameter`      parameters with domains; what is positive on a whole domain
`dynamics`       the linear motion inside a configuration
`configuration`  Boundary, Configuration, Contact: one linear regime and where it ends
`transition`     Condition, Transition: what happens there; the law of coupled contacts
`system`         System: all of these together, and a hash that equal ones share
`soundness`      what a system must not be: wrong names and sizes, endings, wrong landings
`presentation`   Presentation: coordinates and parameters of an orbit's equations
`itinerary`      Itinerary: the phases of an orbit
`source`         Source: the publication that an orbit is taken from
`symmetry`       directions along which nothing changes; orbits declared by a part
===============  ==============================================================
"""
