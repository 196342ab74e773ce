"""All orbits of an itinerary in a box of dwell times: each proved, and no other."""
