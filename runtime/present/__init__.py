"""Results for people and for files: JSON, pictures, notebooks, the report of the paper.

===========  ===========================================================================
`checking`   claims of files of proofs, checked again and compared with their systems
`files`      results in files, with every digit and a checksum
`paper`      the source paper reproduced: every number, figure and claim beside ours
`pictures`   pictures of orbits, motions, branches, charts and proven maps, by matplotlib
`report`     orbits and systems as JSON
`notebook`   how an orbit shows itself in a notebook: a table, and formulas
`summaries`  what every result is, in a few lines and as a table
===========  ===========================================================================
"""
