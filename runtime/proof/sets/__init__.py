"""Sets of states carried through the phases of a motion, in ball arithmetic.

======================  =====================================================================
`sections`              `MapSection`: where states are taken
`affine_sets`           `AffineSet`: an affine image of a cube, carried along a motion
`images`                `SectionMap`: images of sets on a section, and the transitions on the way
`branching`             `BranchingMap`: images of sets whose states go different ways
`parts`                 what affine conditions leave of sets, and sets of fewer sides
`visited_declaration`   the system as far as the motions visit it, for a file
======================  =====================================================================
"""
