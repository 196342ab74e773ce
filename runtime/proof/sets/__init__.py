"""Sets of states carried through the phases of a motion, with bounds of all roundings."""
