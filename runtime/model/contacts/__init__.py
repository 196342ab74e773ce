"""Contacts that the mass matrix couples: which of them slip, hold or let go."""
