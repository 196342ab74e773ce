"""The command line: what each command reads, asks and shows.

======================  ===================================================================
`program`               `main`; `list`, `equations`, `solve`, `verify`, `plot`, `reproduce`
`application`           exit codes, errors in one line, JSON, values by name
`options`               arguments and options that commands share
`basin`                 `basin`
`keeping`               what long commands keep when they are interrupted
`certifying`            `certify` of one orbit, and its `--check`
`certifying_boxes`      `certify` over ranges of parameters
`certifying_branches`   `certify --branch` and `certify --doublings`
`certifying_events`     `certify --events`
`chaos`                 `chaos`
`charting`              `chart`
`continuing`            `continue`
`counting`              `certify --all`
`deriving`              the commands' way into the derivation
`display`               orbits for people, and progress
`designing`             `design`
`display_basins`        basins that are proved, for people
`display_branches`      branches for people
`display_census`        how many orbits there are, for people
`display_certificates`  certificates, maps and events for people
`display_checks`        checks of certificates for people
`display_fits`          fits for people
`display_graphs`        graphs of boxes for people
`display_motions`       motions and found orbits for people
`display_regions`       regions and curves of a map of two parameters
`doctor`                `doctor`
`fitting`               `fit`
`generating`            `generate`
`graphs`                `graph`
`long_proofs`           how proofs that may run for long are kept, drawn and shown
`motions`               `simulate`, `find`, `sweep`
`ranges`                ranges of parameters, and the orbit or branch in them
`report_motions`        motions as JSON
`resuming`              commands that go on by the file that `--save` wrote
`tables`                consoles and tables that are as wide as they need to be
`written`               files and pictures that a command writes, and what it shows of them
======================  ===================================================================
"""
