"""The commands: what they take, what they show; `nonsmooth.runtime.cli.program` runs them.

======================  =======================================================
`application`           exit codes, errors in one line, JSON, values by name
`options`               arguments and options that commands share
`motions`               simulate, find, sweep
`continuing`            continue
`charting`              chart
`certifying`            certify
`certifying_boxes`      the same for ranges of parameters
`certifying_events`     the same for what happens along a range
`counting`              the same for all orbits of an itinerary
`generating`            generate
`report_motions`        motions as JSON
`display`               orbits for people, progress
`display_motions`       motions and found orbits for people
`display_branches`      branches for people
`display_certificates`  certificates, maps and events for people
`display_census`        how many orbits there are, for people
`deriving`              the commands' way into the derivation
======================  =======================================================
"""
