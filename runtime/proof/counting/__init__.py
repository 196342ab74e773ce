"""All orbits of an itinerary in a box: how many there are, each proved, and no other.

================  ============================================================
`sides`           the box that is asked about: bounds of dwell times
`reduced`         the reduced equations of a derived orbit, over boxes
`dwell`           the equations of any cycle in its dwell times, over boxes
`contraction`     what can be told of one box
`search`          branch and prune: all roots of a box
`problems`        which equations an itinerary is counted by
`asking`          from what a user gives to a box and such equations
`count`           all of it together
`census`          what was counted; JSON
`saved`           a census in a file
`comparing`       whether it is of the system that it names
================  ============================================================
"""
