"""Draw the pictures of README.md and of the gallery's index into docs/pictures.

python scripts/development/pictures.py
"""

import argparse
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib
import numpy as np

matplotlib.use("agg")

from matplotlib.figure import Figure

import nonsmooth as ns
from nonsmooth.runtime.present.pictures.charts import chart_figure
from nonsmooth.runtime.present.pictures.plot import save_figure

CHECKOUT = Path(__file__).resolve().parents[2]

# what stands for a file of the gallery: an orbit, or a start and how long it is followed
ORBITS = {
    "backlash_gear": ("rattle", "phase"),
    "beam": ("one-contact", "phase"),
    "brake_pad": ("lifting", "phase"),
    "den_hartog": ("without-rest", "phase"),
    "impact_damper": ("struck-twice", "time"),
    "impact_oscillator": ("one-period", "phase"),
    "jenkins": ("yielding-both-ways", "velocity"),
    "mass_on_belt": ("stick-slip", "phase"),
    "piecewise_stiffness": ("doubled", "phase"),
    "switched_damping": ("limit-cycle", "phase"),
    "three_masses": ("two-each", "time"),
    "two_belts": ("both-stick", "velocity"),
    "two_stops": ("broken", "phase"),
}
MOTIONS = {
    "bouncing_ball": ({"gravity": 1, "r": "0.7"}, {"x": 1, "v": 0}, 9),
    "identification": (
        {"c": "0.05", "h": "0.2", "k": "2.5", "r": "0.8", "w": "2.1"},
        {"x": "-0.6", "v": "0.1"},
        25,
    ),
    "spring_and_ground": (
        {"m": "1e-3", "k": 100, "gravity": "9.81", "e": "0.9"},
        {"x": 1, "v": 0},
        0.06,
    ),
}


def declared_in_readme():
    """The system of README's first block of Python."""
    text = (CHECKOUT / "README.md").read_text(encoding="utf-8")
    names = {}
    exec(text.partition("```python\n")[2].partition("```")[0], names)
    return names["system"]


def response_and_basins(folder: Path) -> None:
    """The two pictures of README: a frequency response, and basins where two orbits attract."""
    system, data = declared_in_readme(), {"F": 2, "Omega": 26}
    found = ns.find_orbits(
        system, data, 200, transitions=500, box={"x": (-0.02, 0.02), "v": (-0.5, 0.5)}
    )
    striking, quiet = sorted(found.orbits, key=lambda entry: -len(entry.itinerary))[:2]
    figure = Figure(figsize=(5.6, 3.9), layout="constrained")
    axes = figure.add_subplot()
    branch = ns.continue_orbit(striking.orbit, "Omega", (16, 30))
    branch.plot("amplitude_x", axes=axes)
    below = ns.continue_orbit(quiet.orbit, "Omega", (16, 30), admissible=True)
    below.plot("amplitude_x", axes=axes)
    axes.set_title("", loc="left")
    figure.suptitle("a machine that strikes a rubber stop: frequency response", size="medium")
    save_figure(figure, folder / "response.svg")

    with TemporaryDirectory() as place:
        file = Path(place) / "found.json"
        found.save(file)
        x, v = np.linspace(-0.02, 0.02, 300), np.linspace(-0.5, 0.5, 300)
        figure = chart_figure(ns.chart(str(file), x=x, v=v))
    figure.set_size_inches(5.6, 3.9)
    save_figure(figure, folder / "basins.png")


def thumbnails(folder: Path) -> None:
    """One small picture for each file of the gallery."""
    for name in sorted(ORBITS | MOTIONS):
        figure = Figure(figsize=(3.2, 2.4), layout="constrained")
        axes = figure.add_subplot()
        file = str(CHECKOUT / "docs" / "gallery" / f"{name}.py")
        if name in ORBITS:
            orbit, kind = ORBITS[name]
            solved = ns.solve(f"{file}:{orbit}")
            solved.plot(kind, axes=axes, **({"masses": [0]} if kind == "phase" else {}))
        else:
            data, start, until = MOTIONS[name]
            ns.simulate(file, data, start, until=until).plot("time", axes=axes)
        for label in (axes.set_xlabel, axes.set_ylabel, axes.set_title):
            label("")
        axes.set_title("", loc="left")
        for legend in (axes.get_legend(), *figure.legends):
            if legend is not None:
                legend.remove()
        figure.savefig(folder / f"{name}.png", dpi=80, metadata={"Software": None})


def stablest(path: Path) -> None:
    """The spectral radius around the design of the page of that name."""
    orbit = ns.solve("dry-friction/symmetric")
    design = ns.design(orbit, minimise="spectral_radius", over={"V": (0.3, 3)})
    figure = design.plot()
    figure.axes[0].remove()
    figure.set_size_inches(3.2, 2.4)
    (axes,) = figure.axes
    axes.set_subplotspec(figure.add_gridspec(1, 1)[0])
    axes.legend_.remove()
    axes.set_xlabel("")
    figure.savefig(path, dpi=80, metadata={"Software": None})


def main() -> int:
    """Draw all pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=CHECKOUT / "docs" / "pictures")
    folder = parser.parse_args().out
    (folder / "gallery").mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context({"svg.hashsalt": "nonsmooth"}):
        response_and_basins(folder)
        thumbnails(folder / "gallery")
        stablest(folder / "gallery" / "stablest_belt.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
