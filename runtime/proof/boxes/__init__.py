"""Proofs for all parameters of a box.

=================  ==================================================================
`certify_box`      `certify_box`: tile after tile, halved until they are decided
`tile`             the proof on one tile, in Taylor models of the parameters
`tile_event`       the curve of one event that divides a tile of two parameters
`tile_fold`        the curve on which two orbits meet, and both of them beside it
`refusals`         what the checker does not prove of a tile, asked before it is stated
`regions`          regions and curves of a map of two parameters
`tile_edges`       edges that tiles have in common, and what is joined by them
`tile_places`      the places of tiles: a box, halved again and again
`box_certificate`  `BoxCertificate`: what is proved, tile by tile
`dependence`       how a system's numbers depend on the parameters of a box
`orbit_over_box`   an orbit's system as rational functions of the parameters of a box
=================  ==================================================================
"""
