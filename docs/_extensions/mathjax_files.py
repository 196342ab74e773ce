"""Serve MathJax and its fonts from the site: copied from the package sphinx-mathjax-offline."""

from importlib.metadata import distribution
from pathlib import Path

from sphinx.application import Sphinx

INSIDE = "sphinx-mathjax-offline/static/mathjax"
PARTS = ("tex-chtml.js", "input/tex/extensions/", "output/chtml/fonts/")


def copy_mathjax(app: Sphinx) -> None:
    """Copy what pages load, a tenth of the package, into ``_static/mathjax``."""
    if app.builder.format != "html":
        return
    for file in distribution("sphinx-mathjax-offline").files or ():
        place = file.as_posix().removeprefix(f"{INSIDE}/")
        if place.startswith(PARTS):
            target = Path(app.outdir, "_static", "mathjax", place)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(file.read_binary())


def setup(app: Sphinx) -> dict[str, bool]:
    """Name the script to the pages, and copy it once the builder is known."""
    app.config.mathjax_path = "mathjax/tex-chtml.js"
    app.connect("builder-inited", copy_mathjax)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
