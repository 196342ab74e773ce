"""Proofs of whole branches: tiles that follow each other, and every event between them.

==================  =================================================================
`certify_branch`    `certify_branch`: both ways along a branch, tile after tile
`beyond_border`     other itineraries that begin at a border: their side and verdict
`same_motion`       whether the events of two itineraries are one motion
`refusals`          what the checker does not prove of a tile, asked before it is stated
`march`             steps that fit what can be proved, by the coordinate that leads on
`look`              the verdict on a tile, or one event and the verdicts beside it
`crossing`          one zero of a number along a tile, with a speed that is not zero
`passage`           the cycle along a branch, and the numbers whose zeros are events
`tube`              polynomials with exactly one orbit near them, by any coordinate
`short_phases`      equations and maps that are regular where a phase vanishes
`curve`             unknowns and parameter on one footing; derivatives along the branch
`stating`           what was proved, in the records that are shown and kept
`certified_branch`  `CertifiedBranch`: what is proved
==================  =================================================================
"""
