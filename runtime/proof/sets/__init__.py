"""Sets of states proved: basins of attraction, trapping regions, and the sections of both."""
