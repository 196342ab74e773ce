"""Contacts that the mass matrix couples: which of them slip, hold or let go.

===========  =======================================================================
`law`        the law of a system, by indices of its rows and resets
`stages`     one step of the choice between sticking and slipping, in any arithmetic
`unfolding`  kernels in which the transitions of the law are listed
===========  =======================================================================
"""
