"""Proofs for all parameters of a box.

==============  ==============================================================
`place`         where a tile is
`dependence`    numbers as rational functions of a box's parameters
`region`        an orbit over a box of parameters: its system in rational functions of them
`tile`          the proof on one tile, in Taylor models
`certify`       tile after tile, halved until they are decided
`record`        the proven map: tiles with their claims; JSON
`saved`         maps in files
`comparing`     whether a saved map is of the system that it names
`drawing`       maps in pictures
==============  ==============================================================
"""
