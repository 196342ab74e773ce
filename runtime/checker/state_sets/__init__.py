"""Sets of states through phases: basins, graphs of boxes, chaos."""
