"""Motions from event to event, exactly, and what is observed along them."""
