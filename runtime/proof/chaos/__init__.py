"""Chaos, proved: covering relations of sets on a section, and symbolic dynamics from them.

======================  =====================================================================
`certify_chaos`         `certify_chaos`: find sets that cover each other, and prove that they do
`chaos_certificate`     `ChaosCertificate`: what is proved
`search`                the sets, found in double precision along a chaotic motion
`float_sections`        the map of a section in double precision
`coverings`             which sets a set covers, proved
`cone_conditions`       exponents and hyperbolicity by cones that are mapped into each other
`parts`                 parts into which an h-set is divided
`h_sets`                `HSet`: a parallelepiped with a direction that is stretched
`entropy`               the spectral radius of a graph, from below
`section_choice`        sections of a motion on which to look
======================  =====================================================================
"""
