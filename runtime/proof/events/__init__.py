"""Events of branches enclosed: bifurcations and limits of admissibility, to any number of digits.

==============  ==============================================================
`augmented`     an orbit's equations joined by what holds at an event
`certify`       the event near a computed one, proved and enclosed
`record`        what is proved; JSON
`saved`         files of such certificates, and whether they are of the systems they name
==============  ==============================================================
"""
