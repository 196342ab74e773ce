"""What the command that fits shows to people."""

from __future__ import annotations

import math
from collections import Counter

from rich.text import Text

from nonsmooth.runtime.cli.tables import console_as_wide, listing, show_table
from nonsmooth.runtime.explore.fitting.fit_record import Fit, FittedExperiment
from nonsmooth.runtime.explore.fitting.nearest_grazing import NearestGrazing
from nonsmooth.runtime.model.naming import shown_name
from nonsmooth.runtime.model.structure import FORCING_PHASE

__all__ = ["show_fit"]


def show_fit(fit: Fit) -> None:
    """Show estimates with their uncertainties, the misfit, and the phases of fitted motions."""
    out = console_as_wide()
    count = f"{len(fit.experiments)} experiment{'s' * (len(fit.experiments) != 1)}"
    out.print(Text(f"{shown_name(fit.system)}, {fit.data} numbers of {count}", style="bold"))
    table = listing(
        "found", "estimate", "standard error", "95 % interval", right=("estimate", "standard error")
    )
    errors = fit.standard_errors.tolist()
    for place, name in enumerate(fit.names):
        ends = f"{_number(fit.lower[place])} ... {_number(fit.upper[place])}"
        error = f"{errors[place]:.2g}" if math.isfinite(errors[place]) else ""
        table.add_row(name, f"{fit.estimates[place]:.10g}", error, fit.untold.get(name, ends))
    show_table(table, out)
    out.print(f"chi2 {fit.chi2:.6g} with {fit.degrees_of_freedom} degrees of freedom")
    for name, size in fit.noise.items():
        out.print(f"noise of {name}: {size:.3g}, estimated")
    for text in fit.unidentified:
        out.print(Text(f"nothing measured tells {text}", style="red"))
    weak = [each for each in fit.identified if 1 <= each[1] < math.inf]
    for text, _ in weak:
        out.print(f"hardly told: {text}")
    for each in fit.experiments:
        if each.responses:
            out.print(_responses_text(each))
            continue
        phases = len(each.configurations)
        sequence = {
            None: "",
            True: ", events in the order of the data",
            False: ", events not in the order or number of the data",
        }
        out.print(
            f"{shown_name(each.name)}: {phases} phase{'s' * (phases != 1)}"
            f"{sequence[each.same_sequence]}{_grazing_text(each.grazing)}"
        )
    tried = "" if len(fit.costs) < 2 else f", best of {len(fit.costs)} searches"
    out.print(f"{fit.status}: {fit.message}; {fit.evaluations} evaluations{tried}")


def _responses_text(experiment: FittedExperiment) -> str:
    """One line with the number of steady responses of an experiment, with and without events."""
    counts = Counter(
        "without an event" if each.itinerary[0][1] == FORCING_PHASE else "with events"
        for each in experiment.responses
    )
    told = " and ".join(f"{count} {kind}" for kind, count in counts.items())
    count = len(experiment.responses)
    return (
        f"{shown_name(experiment.name)}: {count} steady response{'s' * (count != 1)}, {told}"
        f"{_grazing_text(experiment.grazing)}"
    )


def _grazing_text(grazing: NearestGrazing | None) -> str:
    if grazing is None:
        return ""
    distance = grazing.standard_errors
    far = "" if not math.isfinite(distance) else f", {distance:.3g} standard errors away"
    return (
        f"; nearest grazing: {grazing.boundary}, {grazing.kind} at {grazing.time:.6g},"
        f" by {grazing.margin:.3g}{far}"
    )


def _number(value: float) -> str:
    return f"{value:.8g}"
