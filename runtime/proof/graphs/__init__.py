"""Graphs of boxes: where the motions of a region of a section may go, and where they stay.

======================  =====================================================================
`certify_graph`         `certify_graph`: enclose the images of boxes, and read the graph
`graph_certificate`     `GraphCertificate`, `Component`: what is proved
`box_graphs`            `BoxGraph`: boxes, edges, components, what lies forward of what
======================  =====================================================================
"""
