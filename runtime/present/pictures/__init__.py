"""Pictures of orbits, motions, branches, charts and proven maps, by matplotlib."""
