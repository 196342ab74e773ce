"""Chaos, proved: covering relations of sets on a section, and symbolic dynamics from them.

======================  =====================================================================
`certify_chaos`         `certify_chaos`: find sets that cover each other, and prove that they do
`chaos_certificate`     `ChaosCertificate`: what is proved
`search`                the sets, found in double precision along a chaotic motion
`float_sections`        the map of a section in double precision
`coverings`             which sets a set covers, proved
`h_sets`                `HSet`: a parallelepiped with a direction that is stretched
`entropy`               the spectral radius of a graph, from below
`images`                images of sets on a section, and the transitions on the way
`affine_sets`           sets of states that are carried along a motion
`sections`              where states are taken
`section_choice`        sections of a motion on which to look
`visited_declaration`   the system as far as the motions visit it, for the file
======================  =====================================================================
"""
