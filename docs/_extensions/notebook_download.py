"""Offer each executed page as a notebook, with its outputs."""

import shutil
from pathlib import Path
from typing import Any

from docutils.nodes import document
from sphinx.application import Sphinx


def offer_notebook(
    app: Sphinx, page: str, template: str, context: dict[str, Any], tree: document | None
) -> None:
    """Put the notebook of an executed page into the site and its address into the context."""
    if not app.env.nb_metadata[page].get("exec_data"):
        return
    place = f"_notebooks/{page}.ipynb"
    target = Path(app.outdir, place)
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(Path(app.env.mystnb_config.output_folder, f"{page}.ipynb"), target)
    context["notebook"] = context["pathto"](place, resource=True)


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to the making of pages."""
    app.connect("html-page-context", offer_notebook)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
