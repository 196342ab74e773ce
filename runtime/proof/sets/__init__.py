"""Sets of states carried through the phases of a motion, with bounds of all roundings.

======================  =====================================================================
`sections`              `MapSection`: where states are taken
`affine_sets`           `AffineSet`: an affine image of a cube, carried along a motion
`images`                `SectionMap`: images of sets on a section, and the transitions on the way
`branching`             `BranchingMap`: images of many sets whose states go different ways
`set_parts`             parts of sets on their way, and what is known of them
`started_phase`         `StartedPhase`: what ends the phase that begins with some parts
`phase_ends`            where the sets of one phase reach boundaries
`told_question`         `ToldQuestion`: a system and a section, for other processes
`visited_declaration`   the system as far as the motions visit it, for a file
======================  =====================================================================
"""
