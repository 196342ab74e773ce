"""Numerics: everything that runs on generated kernels and tables, without symbolic algebra.

============  ====================================================================================
`cli`         the command line: what each command reads, asks and shows
`present`     results for people and for files: JSON, pictures, notebooks, the report of the paper
`proof`       theorems about periodic orbits and motions, proved in ball arithmetic
`checker`     the check of certificates, from nothing but their files and ball arithmetic
`explore`     many orbits: branches and charts over parameters, and all that live in a system
`orbits`      one periodic orbit, or one at each of many parameter points: solved, refined, judged
`simulation`  motions from event to event, exactly, and what is observed along them
`events`      when a phase reaches a boundary, and what follows there
`shooting`    the equations of a periodic orbit, their linearisation, Newton's method
`model`       a system and its orbits as numbers: tables, kernels, parameters, closed-form flows
`core`        exact values, arithmetics, errors, files, names: what every room needs
============  ====================================================================================

A room uses those below it, never one above; `engine/` is the engine in C and `face/` the public
names of the package. docs/architecture.md leads through the rooms.
"""
