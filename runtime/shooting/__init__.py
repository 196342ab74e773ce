"""The equations of a periodic orbit: a cycle of phases, its linearisation, Newton's method."""
