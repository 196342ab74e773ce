"""The commands: what they take, what they show; `nonsmooth.runtime.cli` runs them.

=================  ============================================================
`application`      exit codes, errors in one line, JSON, values by name
`options`          arguments and options that commands share
`motions`          simulate, find, sweep
`charting`         chart
`report_motions`   motions as JSON
`display`          orbits for people, progress
`display_motions`  motions and found orbits for people
`deriving`         the commands' way into the derivation
=================  ============================================================
"""
