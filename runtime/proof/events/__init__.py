"""Events of branches enclosed: bifurcations and limits of admissibility, to any precision.

===================  ========================================================
`certify_event`      `certify_event`: the event near a computed one, enclosed
`augmented_system`   an orbit's equations joined by what holds at an event
`event_certificate`  `EventCertificate`: what is proved of an event
===================  ========================================================
"""
