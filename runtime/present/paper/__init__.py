"""The source paper reproduced: every number, figure and claim beside ours.

============  ======================================================================================
`writing`     all of the reproduction, into a folder
`chapters`    the report: chapters in the order of the paper
`records`     what a report is made of: chapters of text, equations, tables, figures and comparisons
`claims`      what the paper says without a number, and what we add to it, decided by computation
`comparing`   the paper's printed digits beside ours, and the verdict on the difference
`contact`     one-contact solutions for any stiffness in contact: a route of its own
`figures`     the paper's figures, and for each orbit its timing strip and its multipliers
`mathml`      LaTeX as MathML: latex2mathml's, mended where a browser would set it badly
`misprints`   the paper's misprints, each with the computation that shows it
`proofs`      what ball arithmetic proves of the paper's orbits: a chapter of its own
`schematics`  the paper's three schematics: the oscillator with a stop, the one on a belt
`writers`     reports as JSON, as Markdown and as one HTML page that needs no network
============  ======================================================================================
"""
