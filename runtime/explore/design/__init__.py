"""Parameters at which an orbit is best, or has wanted values."""
