"""Proofs of whole branches: tiles that follow each other, and every event between them.

==================  =================================================================
`certify_branch`    `certify_branch`: both ways along a branch, tile after tile
`march`             steps that fit what can be proved, by the coordinate that leads on
`look`              the verdict on a tile, or one event and the verdicts beside it
`crossing`          one zero of a number along a tile, with a speed that is not zero
`passage`           the cycle along a branch, and the numbers whose zeros are events
`tube`              polynomials with exactly one orbit near them, by any coordinate
`short_phases`      equations divided by the dwell time of a phase that may vanish
`curve`             unknowns and parameter on one footing; derivatives along the branch
`certified_branch`  `CertifiedBranch`: what is proved
==================  =================================================================
"""
