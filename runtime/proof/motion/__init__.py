"""Simulation in ball arithmetic: the sequence of configurations, proved.

================  ============================================================
`facts`           what is known exactly of a state
`flow`            the flow of an affine field in balls: exponentials and expansions
`enclosures`      a system: exact rows, fields and resets, and its flows
`asymptotics`     whether an affine function stays negative for ever
`first_crossing`  the first crossing of one phase, proved
`validate`        the motion: `validate`
`proof`           what is proved of it
================  ============================================================
"""
