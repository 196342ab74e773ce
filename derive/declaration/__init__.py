"""What an oscillator is and which orbit is meant: frozen records, checked when they are made.

===============  ==============================================================
`algebra`        normal forms of rational expressions
`parameter`      parameters with domains; what is positive on a whole domain
`names`          names that a declaration may give, each once
`dynamics`       the linear motion inside a configuration
`configuration`  Boundary, Configuration, Contact: one linear regime and where it ends
`transition`     Condition, Transition: what happens there
`contact_law`    contacts that the mass matrix couples, as data
`system`         System: all of these together
`soundness`      what a system must not be: endings, dead transitions, wrong landings
`presentation`   Presentation: coordinates and parameters of an orbit's equations
`itinerary`      Itinerary: the phases of an orbit
`unfolding`      the whole of an orbit that is declared by a part and a symmetry
`translation`    directions along which nothing changes, as the angle of a rotor
`fingerprint`    a hash that equal declarations share
===============  ==============================================================
"""
