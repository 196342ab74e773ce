"""All orbits of an itinerary in a box of dwell times: each proved, and no other.

===================  ===================================================================
`certify_all`        `certify_all`: how many orbits an itinerary has in a box
`question`           from what a user gives to a box and the equations that are searched
`dwell_box`          the box of dwell times that is asked about
`problems`           which equations the orbits of an itinerary are counted by
`branch_and_prune`   every root of a system of equations in a box, each proved unique
`contraction`        what can be told of one box: no root, one root, or where roots are
`census`             `Census`: the record of what was counted
`dwell_equations`    the equations of any cycle in its dwell times, in balls
`reduced_equations`  the reduced equations of a derived orbit, over boxes
===================  ===================================================================
"""
