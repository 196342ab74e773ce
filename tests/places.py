"""Where things are in the checkout."""

from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]
GALLERY = CHECKOUT / "docs" / "gallery"
