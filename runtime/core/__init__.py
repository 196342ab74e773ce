"""What every room needs and no room owns: exact values, arithmetics, errors, files, names."""
