"""What a file states, read exactly: numbers, parameters, declarations, grids."""
