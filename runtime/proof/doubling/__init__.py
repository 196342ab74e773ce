"""Proofs beyond a flip: the orbits of twice the period, and cascades of them.

====================  =================================================================
`certify_cascade`     `certify_cascade`: from flip to flip along the doubled branches
`cascade_steps`       one doubling after the other, as far as the time goes
`beside_flip`         the doubled orbits next to a flip, with their side and verdict
`doubling_tube`       polynomials of the amplitude with exactly one doubled orbit near
`doubled_equations`   the doubled orbits' equations, without the singularity at a flip
`certified_cascade`   `CertifiedCascade`: what is proved
====================  =================================================================
"""
