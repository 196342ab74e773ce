"""What a file of a proof claims, checked again and compared with the system that it names."""
