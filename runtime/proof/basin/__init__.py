"""What is proved to be attracted by an orbit.

====================  ===================================================================
`certify_basin`       `certify_basin`: from an orbit to tiles of starts that it attracts
`basin_certificate`   `BasinCertificate`: what is proved
`basin_section`       a section of the orbit, and where the orbit meets it
`attracting_core`     a set around that point that the map of the section contracts
`starting_tiles`      which tiles are looked at next, and which are proved
====================  ===================================================================
"""
