"""Motion inside one configuration, in closed form by modal analysis.

===========  ================================================================
`entire`     entire functions that never divide by an eigenvalue
`modal`      the flow of a configuration, and the spectrum that it is written in
`resolvent`  the flow of any linear motion, block by block
===========  ================================================================
"""
