"""An orbit at parameter points: that there is one, its motion, stability, derivatives, events."""
