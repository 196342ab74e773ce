"""The source paper reproduced: every number, figure and claim beside ours.

================  =============================================================
`records`         what a report is made of
`comparing`       printed digits beside ours
`claims`          what the paper says without a number
`misprints`       each with the computation that shows it
`contact`         one-contact orbits by a route of its own
`schematics`      the paper's drawings of the systems and of the Poincare map
`figures`         which picture shows what
`chapters`        the report in the order of the paper
`writers`         it as HTML, Markdown and JSON
`writing`         all of it into a folder
================  =============================================================
"""
