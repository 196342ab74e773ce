"""When a phase reaches a boundary, and what follows there."""
