"""Contacts that the mass matrix couples: which of them slip, hold or let go.

============  ==================================================================
`law`         the law of a system, by indices of its rows
`stages`      one step of the choice: the functions whose signs say that it holds
`unfolding`   kernels in which paths of the law are listed as transitions
============  ==================================================================
"""
