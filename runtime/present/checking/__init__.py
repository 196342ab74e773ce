"""What a file of a proof claims, checked again and compared with the system that it names.

======================  =======================================================================
`check_file`            the check of certificates, maps, events, censuses and chaos
`compare_declarations`  whether what a file proves is of the system and the orbit that it names
`named_orbits`          the system and the orbit that a file of a proof names
======================  =======================================================================
"""
