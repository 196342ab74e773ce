"""How the documentation is built: ``python -m sphinx -j auto -W --keep-going docs build/site``."""

import os
import re
import sys
from importlib.metadata import version as version_of
from pathlib import Path

import nonsmooth
import nonsmooth.derive
import nonsmooth.jax
import nonsmooth.torch
from nonsmooth.derive.codegen import derived
from nonsmooth.derive.flows import resolvent
from nonsmooth.runtime.explore.continuation.event import KINDS
from nonsmooth.runtime.orbits.refine import MOST_DIGITS

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_extensions"))

# Names that have pages of their own: the public ones, what they return, all of `certify`.
PACKAGES = (nonsmooth, nonsmooth.derive, nonsmooth.jax, nonsmooth.torch)
DOCUMENTED = {f"{package.__name__}.{name}" for package in PACKAGES for name in package.__all__}
RECORDS = re.findall(r"^   ~(.*)$", (HERE / "reference" / "python.rst").read_text("utf-8"), re.M)
DOCUMENTED |= {f"nonsmooth.{record}" for record in RECORDS}
METHODS = {f"nonsmooth.certify.{name}" for name in vars(type(nonsmooth.certify))}
for page in (HERE / "reference" / "api").glob("*.rst"):
    if page.stem not in DOCUMENTED | METHODS:
        page.unlink()  # of a name that was there once

project = "nonsmooth"
author = "The nonsmooth developers"
copyright = author
version = release = version_of(project)

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "numpydoc",
    "myst_nb",
    "sphinx_design",
    "benchmark_tables",
    "docstring_references",
    "failing_commands",
    "file_schemas",
    "forked_kernels",
    "mathjax_files",
    "notebook_download",
    "typer_commands",
]
exclude_patterns = ["_*"]
templates_path = ["_templates"]
nitpicky = True

# docstrings
default_role = "py:obj"
add_module_names = False
autodoc_typehints = "none"
autodoc_member_order = "bysource"
autosummary_generate = True
numpydoc_show_class_members = False
numpydoc_xref_param_type = True
numpydoc_xref_ignore = "all"
numpydoc_xref_aliases = {name.rpartition(".")[2]: name for name in sorted(DOCUMENTED)}


def events_table(*, of_multipliers: bool) -> str:
    """Kinds of events of a branch, which multipliers show or boundaries do."""
    kinds = {name: kind for name, kind in KINDS.items() if bool(kind.test) == of_multipliers}
    rows = [f"| `{name}` | {kind.text} |" for name, kind in kinds.items()]
    return "\n".join(["| kind | what happens |", "| --- | --- |", *rows])


# pages: text in MyST, of which those that name a kernel are executed
myst_enable_extensions = [
    "amsmath",
    "attrs_inline",
    "colon_fence",
    "deflist",
    "dollarmath",
    "substitution",
]
myst_substitutions = {
    "most_phases": derived.MOST_PHASES,
    "most_kernel_states": derived.MOST_STATES,
    "most_roots": resolvent.MOST_ROOTS,
    "most_digits": MOST_DIGITS,
    "smooth_events": events_table(of_multipliers=True),
    "nonsmooth_events": events_table(of_multipliers=False),
}
myst_heading_anchors = 3
nb_execution_mode = "force"  # a cache is not safe with several processes
nb_execution_timeout = 120
nb_execution_raise_on_error = True
nb_merge_streams = True
# what they run are the commands of this environment, which answer in plain text
os.environ["PATH"] = os.pathsep.join((str(Path(sys.executable).parent), os.environ["PATH"]))
os.environ |= {"TERM": "dumb", "NO_COLOR": "1", "COLUMNS": "92"}

# the site
html_title = f"nonsmooth {release}"
html_theme = "pydata_sphinx_theme"
ALONE = ("architecture", "changelog", "glossary", "limits", "overview", "tutorial")
html_sidebars = {page: [] for page in ALONE}  # there is nothing to list beside them
html_static_path = ["_static"]
html_context = {"default_mode": "auto"}
html_css_files = ["nonsmooth.css"]
html_favicon = "_static/mark.svg"
html_theme_options = {
    "logo": {
        "image_light": "_static/mark.svg",
        "image_dark": "_static/mark.svg",
        "text": "nonsmooth",
    },
    "navbar_align": "left",
    "navigation_with_keys": False,
    "header_links_before_dropdown": 6,
    "secondary_sidebar_items": ["page-toc", "notebook-download", "sourcelink"],
    "footer_start": ["copyright"],
    "footer_end": ["sphinx-version"],
}
