"""Parameters of the built-in systems, and an itinerary, along which many tests follow motions."""

CHAIN = {"m1": 1, "m2": 2, "k1": 1, "k2": 5}
# where both masses stick together, and where only the second one sticks
STICKING = {"chi": "0.5", "eta": 1, "V": 1, "us1": 1, "us2": 1, "ur1": "4.0195", "ur2": "1.4831"}
RUBBING = {
    "chi": "0.4", "eta": 4, "V": "0.6773", "us1": "0.0127", "ur1": "0.0255", "us2": "0.5", "ur2": 1
}  # fmt: skip
PHASES = [
    ("stick-stick", "first-breaks-forward"),
    ("slip-stick", "second-breaks-forward"),
    ("slip-slip", "first-reaches-belt"),
    ("stick-slip", "second-reaches-belt"),
]
SYSTEMS = {
    "dry-friction": RUBBING,
    "rigid-stop": CHAIN | {"r": "0.6"},
    "elastic-stop": CHAIN | {"k3": 40},
}
