"""Where things are in the checkout."""

import re
from importlib import import_module
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]
GALLERY = CHECKOUT / "docs" / "gallery"


def records():
    """Records that public functions return and results hold, as the reference lists them."""
    page = (CHECKOUT / "docs" / "reference" / "python.rst").read_text(encoding="utf-8")
    found = (name.rpartition(".") for name in re.findall(r"^   ~(.*)$", page, re.MULTILINE))
    return {name: getattr(import_module(f"nonsmooth.{home}"), name) for home, _, name in found}
