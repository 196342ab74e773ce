"""How a configuration without a closed form moves: its modes, from its numbers."""
