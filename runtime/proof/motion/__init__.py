"""Simulation in ball arithmetic: the sequence of configurations of a motion, proved.

================  ===============================================================================
`validate`        `validate`: every transition of a motion, proved
`motion_proof`    `Proof`: what is proved of a motion
`first_crossing`  the first boundary that a phase reaches, proved in balls
`asymptotics`     whether an affine function stays negative for ever
`ball_flow`       the flow of an exact affine field in balls
`enclosures`      a system at one parameter point, for proofs: exact rows, fields and resets
`exact_rows`      what is known exactly of a state: affine functions that are zero
`lawful`          what a contact law says at an event, proved: double precision guesses its steps
================  ===============================================================================
"""
