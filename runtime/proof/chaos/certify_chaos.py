"""Prove chaos: find h-sets that cover each other, and prove that they do."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from nonsmooth.runtime.checker.chaos import check_chaos
from nonsmooth.runtime.core.errors import InputError, Interrupted
from nonsmooth.runtime.core.values import flint_precision
from nonsmooth.runtime.events.leading_derivative import Undecided
from nonsmooth.runtime.model.kernels import SystemKernels, kernels_of
from nonsmooth.runtime.model.loading.declared import DeclaredSystem
from nonsmooth.runtime.proof.chaos.chaos_certificate import ChaosCertificate
from nonsmooth.runtime.proof.chaos.cone_conditions import cone_condition
from nonsmooth.runtime.proof.chaos.coverings import Coverings, coverings
from nonsmooth.runtime.proof.chaos.entropy import growth, logarithm_below
from nonsmooth.runtime.proof.chaos.float_sections import FloatSection
from nonsmooth.runtime.proof.chaos.h_sets import HSet, apart
from nonsmooth.runtime.proof.chaos.search import Horseshoe, candidates, orbits_on
from nonsmooth.runtime.proof.chaos.section_choice import sampled_sections
from nonsmooth.runtime.proof.motion.enclosures import EnclosedSystem, enclosed_system
from nonsmooth.runtime.proof.refusals import as_file, refusal
from nonsmooth.runtime.proof.sets.images import PassedTransition, SectionMap
from nonsmooth.runtime.proof.sets.sections import MapSection
from nonsmooth.runtime.proof.sets.visited_declaration import visited_declaration
from nonsmooth.runtime.simulation.simulate import simulate

__all__ = ["certify_chaos"]

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
        Parts into which one h-set is divided, at most.
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
    >>> found = ns.certify_chaos("dry-friction", data, [5, 4, 0.5, 0.25], attempts=1)
    >>> found.claim, bool(found.reason)
    ('undecided', True)
    """
    for name, number, least, most in (
        ("iterates", iterates, 1, 64),
        ("attempts", attempts, 1, 10_000),
        ("parts", parts, 16, 1_000_000),
        ("bits", bits, _FEWEST_BITS, _MOST_BITS),
    ):
        if isinstance(number, bool) or not isinstance(number, int) or not least <= number <= most:
            raise InputError(f"{name} = {number!r} is not an integer from {least} to {most}")
    kernels = kernels_of(system)
    at = enclosed_system(kernels, parameters)
    motion = simulate(kernels, parameters, start, configuration, transitions=1)
    with flint_precision(bits):
        enclosed = at(bits)
        if len(enclosed.structure.forcing) > 1:
            raise InputError(f"{enclosed.structure.name} has several forcings: chaos needs one")
        question = _ChaosQuestion(kernels, enclosed, iterates, parts, exponents, progress)
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
    system: EnclosedSystem
    iterates: int
    parts: int
    exponents: bool
    progress: Callable[[int], object]
    tried: list[str] = field(default_factory=list)
    images: int = 0

    def candidates(self, motion: Any) -> Iterator[tuple[MapSection, Horseshoe]]:
        """Yield sections of a motion, each with sets on it that seem to be a horseshoe."""
        values = {name: float(value) for name, value in self.system.values.items()}
        visited = False
        for section, points, ranges in sampled_sections(self.system, motion):
            visited = True
            name = _told(self.system, section)
            period = float(section.period(self.system)) if section.phase is not None else 0.0
            floats = FloatSection(self.kernels, values, section, period)
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
        sets, edges = candidate.h_sets, list(candidate.edges)
        told = f"{_told(self.system, section)}: {len(sets)} sets, {candidate.iterates} iterates"
        if not all(apart(a, b) for k, a in enumerate(sets) for b in sets[:k]):
            self.tried.append(f"{told}: two sets meet")
            return None
        mapped, before = SectionMap(self.system, section, candidate.iterates), self.images
        found: list[Coverings] = []
        for k, h_set in enumerate(sets):
            wanted = [j for i, j in edges if i == k]
            proved = coverings(mapped, h_set, sets, wanted, self.parts, self._tick)
            found.append(proved)
            edges = [(i, j) for i, j in edges if i != k or j in proved.targets]
            if growth(len(sets), edges)[0] <= 1:
                self.tried.append(f"{told}: {h_set.name}: {proved.reason}")
                return None
        bound, kept, _ = growth(len(sets), edges)
        inner = [(i, j) for i, j in edges if i in kept and j in kept]
        number = {k: place for place, k in enumerate(kept)}
        own = [sets[k] for k in kept]
        between = [(number[i], number[j]) for i, j in inner]
        count = self.images - before
        whole = self._certificate(mapped, bound, own, between, [found[k] for k in kept], count)
        reason = _refused(whole)
        if reason:
            self.tried.append(f"{told}: {reason}")
            return None
        return self._with_cones(whole, mapped, between) if self.exponents else whole

    def _with_cones(
        self, proved: ChaosCertificate, mapped: SectionMap, edges: Sequence[tuple[int, int]]
    ) -> ChaosCertificate:
        """The certificate with a cone condition, or without one where none is proved.

        The reason goes to `tried` then.
        """
        most, before = _CONE_PARTS * self.parts, self.images
        try:
            cones = cone_condition(mapped, proved.h_sets, edges, most, self._tick)
            with_cones = replace(proved, cones=cones, parts=proved.parts + self.images - before)
            reason = _refused(with_cones)
            if not reason:
                return with_cones
        except Undecided as trouble:
            reason = trouble.reason
        except KeyboardInterrupt:
            told = (*self.tried, "no cone condition: interrupted")
            raise Interrupted(replace(proved, tried=told)) from None
        self.tried.append(f"no cone condition: {reason}")
        return replace(proved, tried=tuple(self.tried))

    def _tick(self) -> None:
        self.images += 1
        self.progress(self.images)

    def _certificate(
        self,
        mapped: SectionMap,
        bound: Fraction,
        sets: Sequence[HSet],
        edges: Sequence[tuple[int, int]],
        found: Sequence[Coverings],
        count: int,
    ) -> ChaosCertificate:
        section, structure = mapped.section, self.system.structure
        names = structure.configurations
        itineraries = {
            h_set.name: tuple(
                (names[p.source], _joined(self.system, p.source, p.boundaries), names[p.target])
                for p in own.passages
            )
            for h_set, own in zip(sets, found, strict=True)
        }
        phase = () if section.phase is None else tuple(map(str, section.phase))
        passages = [p for own in found for p in own.passages]
        if section.phase is None:
            reached = tuple(sorted(section.boundaries))
            passages.append(PassedTransition(section.source, reached, section.configuration))
        return ChaosCertificate(
            system=structure.name,
            parameters=self.system.values,
            claim="proved",
            reason="",
            configuration=names[section.configuration],
            phase=phase,
            source="" if section.phase else names[section.source],
            boundary=""
            if section.phase
            else _joined(self.system, section.source, tuple(sorted(section.boundaries))),
            coordinates=tuple(structure.states[k] for k in section.free),
            iterates=mapped.iterates,
            h_sets=tuple(sets),
            coverings=tuple((sets[i].name, sets[j].name) for i, j in edges),
            itineraries=itineraries,
            growth=str(bound),
            entropy=logarithm_below(bound, mapped.iterates),
            cones=None,
            images={own.name: of.parts for own, of in zip(sets, found, strict=True)},
            parts=count,
            tried=tuple(self.tried),
            bits=self.system.bits,
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
            images={},
            parts=0,
            tried=tuple(self.tried),
            bits=self.system.bits,
            declaration={},
        )


def _refused(found: ChaosCertificate) -> str:
    """Why the checker refuses a certificate; "" where it proves it, or no file can state it."""
    if not found.declaration:
        return ""
    told = {**found.to_json(), "tables": None, "declaration": dict(found.declaration)}
    return refusal(lambda: check_chaos(as_file(told)))


def _joined(system: EnclosedSystem, source: int, boundaries: Sequence[int]) -> str:
    shapes = system.structure.boundaries[source]
    return "+".join(sorted(shapes[b].name for b in boundaries))


def _told(system: EnclosedSystem, section: MapSection) -> str:
    """A section in words."""
    names = system.structure.configurations
    here = names[section.configuration]
    if section.phase is not None:
        return f"{here} at the forcing's phase ({section.phase[0]}, {section.phase[1]})"
    by = _joined(system, section.source, tuple(section.boundaries))
    return f"behind {names[section.source]} by {by} for {here}"
