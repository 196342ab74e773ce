"""Prove chaos: find h-sets that cover each other, and prove that they do."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import Any

from nonsmooth.runtime.checker.state_sets.chaos import StretchedSets, check_entropy
from nonsmooth.runtime.checker.stated.exact import Failure
from nonsmooth.runtime.core.errors import Interrupted, check_integer
from nonsmooth.runtime.core.json_codec import stated
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.proof.asking import REFUSED
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.chaos.cone_conditions import cone_condition
from nonsmooth.runtime.proof.chaos.h_sets import HSet, growth, logarithm_below, outline
from nonsmooth.runtime.proof.chaos.search import Horseshoe, candidates, orbits_on
from nonsmooth.runtime.proof.sets.section_choice import (
    FloatSection,
    check_one_forcing,
    sampled_sections,
)
from nonsmooth.runtime.proof.sets.sections import (
    MapSection,
    Way,
    named_way,
    reached_text,
    stated_section,
    visited_declaration,
)
from nonsmooth.runtime.proof.statement import ExactSystem, exact_system
from nonsmooth.runtime.simulation.simulate import simulate_one

_BITS = 80
_CONE_PARTS = 4  # times as many for derivatives
_BASES = 800  # points of the motion about which sets stand
_LEAST_GROWTH = 0.01  # of the logarithm of distances in one iterate: else it is no chaos
_FEWEST_BITS, _MOST_BITS = 64, 4096


def certify_chaos(
    system: str | SystemKernels | DeclaredSystem,
    parameters: Mapping[str, object],
    start: Mapping[str, object] | Sequence[object],
    configuration: str | None = None,
    *,
    iterates: int = 8,
    attempts: int = 12,
    parts: int = 3000,
    exponents: bool = False,
    bits: int = _BITS,
    progress: Callable[[int], object] = lambda done: None,
) -> ChaosCertificate:
    """Find a horseshoe along a chaotic motion, and prove it in ball arithmetic.

    Sections of the motion are chosen: with a forcing a phase of it, else a transition. On these
    short segments are mapped in double precision until parts of their images cross them. The
    sets about these parts are h-sets, and that they cover each other is proved: their images,
    enclosed through all impacts and switches on the way, lie across them from unstable side to
    unstable side. What is not proved is not claimed: where no attempt succeeds, `tried` says
    what was looked for.

    Parameters
    ----------
    system : str, System or SystemKernels
        With one harmonic forcing, or without any.
    parameters : mapping of str to str, number or Value
        All of them, rational.
    start : mapping of state to number, or sequence (N,)
        Of a motion that comes to the chaotic one.
    configuration : str, optional
        Where it starts; found by the system's own conditions when omitted.
    iterates : int
        The largest power of the map that is tried.
    attempts : int
        How many candidates are tried to be proved.
    parts : int
        Parts into which an h-set is divided, at most, on average over all of them.
    exponents : bool
        Whether a cone condition is looked for too, which bounds Lyapunov exponents: derivatives
        over small parts of the sets, several times as many images.
    bits : int
        Working precision of the proof, 64 to 4096.
    progress : callable
        Told how many images were enclosed.

    Returns
    -------
    ChaosCertificate
        Proved, or undecided with what was tried.

    Raises
    ------
    InputError
        For wrong names or numbers, a parameter that is not rational, or several forcings.
    Interrupted
        By Ctrl-C while a cone condition is looked for: its `partial` is the certificate
        without one.

    References
    ----------
    P. Zgliczynski and M. Gidea, Covering relations for multidimensional dynamical systems, J.
    Differential Equations 202 (2004) 32-58. H. Kokubu, D. Wilczak and P. Zgliczynski, Rigorous
    verification of cocoon bifurcations in the Michelson system, Nonlinearity 20 (2007) 2147-2174.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> data = {"chi": "0.5", "eta": "1", "V": "1", "us1": "1", "us2": "1", "ur1": "1", "ur2": "1"}
    >>> found = ns.certify.chaos("dry-friction", data, [5, 4, 0.5, 0.25], attempts=1)
    >>> found.claim, bool(found.reason)
    ('undecided', True)
    """
    for name, number, least, most in (
        ("iterates", iterates, 1, 64),
        ("attempts", attempts, 1, 10_000),
        ("parts", parts, 16, 1_000_000),
        ("bits", bits, _FEWEST_BITS, _MOST_BITS),
    ):
        check_integer(name, number, least, most)
    kernels = kernels_of(system)
    exact = exact_system(kernels, parameters)
    motion = simulate_one(kernels, parameters, start, configuration, transitions=1)
    with flint_precision(bits):
        check_one_forcing(exact, "chaos")
        question = _ChaosQuestion(kernels, exact, iterates, parts, exponents, bits, progress)
        left = attempts
        for section, candidate in question.candidates(motion):
            found = question.prove(section, candidate)
            if found is not None:
                return found
            left -= 1
            if not left:
                question.tried.append(f"that were {attempts} attempts")
                break
        return question.undecided()


@dataclass
class _ChaosQuestion:
    """One system at one parameter point, and what was tried."""

    kernels: SystemKernels
    system: ExactSystem
    iterates: int
    parts: int
    exponents: bool
    bits: int
    progress: Callable[[int], object]
    tried: list[str] = field(default_factory=list)
    images: int = 0

    def candidates(self, motion: Any) -> Iterator[tuple[MapSection, Horseshoe]]:
        """Yield sections of a motion, each with sets on it that seem to be a horseshoe."""
        visited = False
        for section, points, ranges in sampled_sections(self.system, motion):
            visited = True
            name = _told(self.system, section)
            floats = FloatSection(self.kernels, self.system, section)
            orbits = orbits_on(floats, points, ranges)
            if orbits is None:
                self.tried.append(f"{name}: the motion is one point, or does not stay")
                continue
            if orbits.growth < _LEAST_GROWTH:
                self.tried.append(
                    f"{name}: distances grow by exp({orbits.growth:.3g}) in one iterate: no chaos"
                )
                continue
            count = 0
            for candidate in candidates(floats, orbits, self.iterates, _BASES):
                count += 1
                yield section, candidate
            self.tried.append(f"{name}: {count} candidates of up to {self.iterates} iterates")
        if not visited:
            self.tried.append("the motion comes to no section often enough")

    def prove(self, section: MapSection, candidate: Horseshoe) -> ChaosCertificate | None:
        """The certificate of a candidate; None, with the reason in `tried`, if the proof fails."""
        told = f"{_told(self.system, section)}: {len(candidate.h_sets)} sets"
        told += f", {candidate.iterates} iterates"
        try:
            return self._proved(section, candidate)
        except REFUSED as failure:
            self.tried.append(f"{told}: {failure}")
            return None

    def _proved(self, section: MapSection, candidate: Horseshoe) -> ChaosCertificate:
        """The certificate of a candidate; `Failure` if the proof fails."""
        floats = FloatSection(self.kernels, self.system, section)
        names = [own.name for own in candidate.h_sets]
        ways = [floats.way(own.near[0], candidate.iterates) for own in candidate.h_sets]
        asked = self._certificate(section, candidate.iterates, candidate.h_sets, ways)
        if not asked.declaration:
            raise Failure("a contact law decides what follows")
        before, most = self.images, self.parts * len(names)
        sets = StretchedSets(stated(asked), most, self._tick)
        sets.check_apart()
        edges, images = list(candidate.edges), {}
        for k, name in enumerate(names):
            found = sets.covered(name, [names[j] for i, j in edges if i == k])
            images[name] = tuple(map(outline, found.parts))
            edges = [(i, j) for i, j in edges if i != k or names[j] in found.targets]
            if growth(len(names), edges)[0] <= 1:
                raise Failure(f"{name}: {next(iter(found.reasons.values()), 'no set is covered')}")
        bound, kept = growth(len(names), edges)
        h_sets = [candidate.h_sets[k] for k in kept]
        proved = replace(
            self._certificate(section, candidate.iterates, h_sets, [ways[k] for k in kept]),
            claim="proved",
            coverings=tuple((names[i], names[j]) for i, j in edges if i in kept and j in kept),
            growth=str(bound),
            entropy=logarithm_below(bound, candidate.iterates),
            images={own.name: images[own.name] for own in h_sets},
            parts=self.images - before,
        )
        sets = StretchedSets(stated(proved), _CONE_PARTS * most, self._tick)
        check_entropy(stated(proved), sets)
        return self._with_cones(proved, sets, floats) if self.exponents else proved

    def _with_cones(
        self, proved: ChaosCertificate, sets: StretchedSets, floats: FloatSection
    ) -> ChaosCertificate:
        """The certificate with a cone condition, or without one where none is proved.

        The reason goes to `tried` then.
        """
        before = self.images
        try:
            cones = cone_condition(sets, proved.h_sets, proved.coverings, floats)
        except REFUSED as failure:
            self.tried.append(f"no cone condition: {failure}")
            return replace(proved, tried=tuple(self.tried))
        except KeyboardInterrupt:
            told = (*self.tried, "no cone condition: interrupted")
            raise Interrupted(replace(proved, tried=told)) from None
        return replace(proved, cones=cones, parts=proved.parts + self.images - before)

    def _tick(self) -> None:
        self.images += 1
        self.progress(self.images)

    def _certificate(
        self,
        section: MapSection,
        iterates: int,
        sets: Sequence[HSet],
        ways: Sequence[Sequence[Way]],
    ) -> ChaosCertificate:
        """The certificate of sets and ways of which nothing is proved."""
        passages = [*chain(*ways)]
        if section.phase is None:
            passages.append((section.source, section.boundaries, section.configuration))
        return replace(
            self.undecided(),
            reason="",
            **stated_section(self.system, section),
            iterates=iterates,
            h_sets=tuple(sets),
            itineraries={
                own.name: named_way(self.system, way) for own, way in zip(sets, ways, strict=True)
            },
            declaration=visited_declaration(self.kernels, self.system, passages),
        )

    def undecided(self) -> ChaosCertificate:
        """The certificate that nothing is proved, after all attempts have failed."""
        return ChaosCertificate(
            system=self.system.structure.name,
            parameters=self.system.values,
            claim="undecided",
            reason="no horseshoe was found and proved",
            configuration="",
            phase=(),
            source="",
            boundary="",
            coordinates=(),
            iterates=0,
            h_sets=(),
            coverings=(),
            itineraries={},
            growth="0",
            entropy="0",
            cones=None,
            parts=0,
            tried=tuple(self.tried),
            bits=self.bits,
            declaration={},
        )


def _told(system: ExactSystem, section: MapSection) -> str:
    """A section in words."""
    names = system.structure.configurations
    here = names[section.configuration]
    if section.phase is not None:
        return f"{here} at the forcing's phase ({section.phase[0]}, {section.phase[1]})"
    by = reached_text(system, section.source, section.boundaries)
    return f"behind {names[section.source]} by {by} for {here}"
