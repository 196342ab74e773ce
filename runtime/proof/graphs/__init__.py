"""Graphs of boxes: where the motions of a region of a section may go, and where they stay."""
