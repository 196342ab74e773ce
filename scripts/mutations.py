"""Bugs that the tests have to notice: mutate.py plants them one at a time."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["MUTATIONS", "Mutation"]


@dataclass(frozen=True)
class Mutation:
    """A bug: a piece of a function that is replaced by another one.

    Attributes
    ----------
    file : str
        In the checkout.
    function : str
        In which the piece is there once: `Class.method`, or `outer.inner`; of C a function's
        name. Empty for a piece that is there once in a whole module.
    before, after : str
        An expression or a statement of Python, compared as syntax trees; of C a text, whatever
        its blanks are.
    tests : tuple of str
        What of the suite concerns it: arguments of pytest.
    equivalent : str
        Why nothing can notice it; then it is only listed.
    """

    file: str
    function: str
    before: str
    after: str
    tests: tuple[str, ...]
    equivalent: str = ""

    def __str__(self) -> str:
        """Say where and what it is."""
        return f"{self.file} {self.function}: {self.before} -> {self.after}"


_EQUATIONS = "tests/derive/test_equations.py"
EQUATIONS = (_EQUATIONS, "-kbelt or bounce or clock or bilinear")
SALTATION = (_EQUATIONS, "-ksaltation or monodromy")
RETURN = (_EQUATIONS, "-kfirst_return")
ENERGY = ("tests/shooting/test_conservative.py", "-kenerg or which_orbits")
BUILDING = ("tests/derive/test_building.py", "tests/simulation/test_building_motions.py")
MODAL = ("tests/derive/test_modal.py",)
PRINTING = ("tests/derive/test_codegen.py", "-kpowers or fractions")
SOLVER_IN_C = (_EQUATIONS, "-ksolver_in_c")
SEARCH = ("tests/events/test_quasi.py",)
SUMS = ("tests/events/test_trigonometric_sums.py",)
STEPPING = ("tests/simulation/test_stepping.py", "tests/simulation/test_simulate.py")
CELLS = ("tests/events/test_engine_search.py",)
REFERENCE = ("tests/simulation/test_engine_stress.py", "-kfollow_the_reference")
TOGETHER = ("tests/simulation/test_events_together.py",)
EXACT = ("tests/simulation/test_stepping.py", "-kone_instant or straight or times_are or swing")
ENGINE = (
    *CELLS, "tests/simulation/test_engine_stress.py", "tests/simulation/test_simulate.py",
    "-knot numpy and not forty and not proof",
)  # fmt: skip
WITHIN = ("tests/orbits/test_friction_orbits.py", "-kwithin_its_error")
SOLVE = ("tests/shooting/test_newton.py",)
COMPOSED = ("tests/orbits/test_composed.py",)
STATUSES = (*COMPOSED, "-kvery_last or either_solver")
GRAZING = ("tests/orbits/test_stop_orbits.py", "-kgrazing")
MINIMUM = ("tests/simulation/test_contact_law.py", "-kthe_choice_is_the_minimum")
START = ("tests/events/test_quasi.py", "-kno_step_behind")
STABILITY = ("tests/shooting/test_stability.py", "tests/shooting/test_conservative.py")
SECTIONS = ("tests/shooting/test_poincare_maps.py", "tests/shooting/test_variational.py")
ADMISSIBLE = ("tests/orbits/test_admissible.py",)
CERTIFY = ("tests/proof/test_certify.py",)
BOXES = ("tests/proof/test_boxes.py",)
COUNTED = ("tests/proof/test_counting.py", "-kvery_numbers or circle or found_twice or done_with")
BRANCHES = ("tests/proof/test_branch.py",)
CHECKED_BRANCHES = ("tests/checker/test_checker_branch.py",)
PIECES = ("tests/proof/test_certify.py", "-krefuted_or_undecided or too_near or another_root")
COUNTING = ("tests/proof/test_counting.py",)
CHECKER = ("tests/checker/test_checker.py",)
TILES = ("tests/checker/test_checker_boxes.py",)
CENSUS = ("tests/checker/test_checker_census.py", "tests/checker/test_false_files.py")
EVENTS = ("tests/checker/test_checker_events.py",)
FILES = ("tests/core/test_files.py",)
RESULTS = ("tests/core/test_result_files.py", "tests/present/test_saved.py")
VALUES = ("tests/core/test_values.py",)
WORKLOAD = ("tests/core/test_workload.py", "-ktest_limits")  # the others begin endless work
DOOR = ("tests/cli/test_door.py", "-kgoes_wrong or given_once or picture")

_ASSEMBLY = "derive/building/assembly.py"
_CHAIN = "derive/equations/chain.py"
_FLOWS = "derive/flows/modal.py"
_CROSSING = "runtime/events/first_crossing.py"
_STEPPING = "runtime/simulation/stepping.py"
_TABLES = "runtime/shooting/table_newton.py"
_KERNELS = "runtime/shooting/kernel_newton.py"
_STABILITY = "runtime/orbits/stability.py"
_ADMISSIBLE = "runtime/orbits/admissible.py"
_KRAWCZYK = "runtime/proof/krawczyk.py"
_PROVEN = "runtime/proof/admissibility.py"
_MOTION = "runtime/checker/motion.py"
_TILES = "runtime/checker/tiles.py"
_FILES = "runtime/core/files.py"
_RESULTS = "runtime/core/result_files.py"
_DOOR = "runtime/cli/application.py"

DERIVATION = (
    Mutation("derive/equations/saltation.py", "saltation_matrix",
             "reset * before", "before", SALTATION),
    Mutation("derive/equations/saltation.py", "monodromy", "factor * product", "product * factor",
             SALTATION),
    Mutation("derive/equations/energy.py", "is_conservative",
             "(after - before).subs(on_boundary)", "(after - before).subs({})",
             ENERGY),
    Mutation("derive/equations/energy.py", "energy_of",
             "not (_symmetric(dynamics.mass) and _symmetric(dynamics.stiffness))"
             " or not dynamics.damping.is_zero_matrix",
             "not (_symmetric(dynamics.mass) and _symmetric(dynamics.stiffness))",
             ENERGY),
    Mutation(_CHAIN, "sensitivities", "link.reset * ends[-1]", "ends[-1]", EQUATIONS),
    Mutation(_CHAIN, "sensitivities",
             "sp.diff(link.duration, unknown) * link.velocity",
             "-sp.diff(link.duration, unknown) * link.velocity", EQUATIONS),
    Mutation(_CHAIN, "poincare_jacobian", "link.reset * projected", "projected", EQUATIONS),
    Mutation(_CHAIN, "poincare_jacobian", "-(link.normal * carried[:, j])[0] / speed",
             "(link.normal * carried[:, j])[0] / speed", EQUATIONS),
    Mutation(_CHAIN, "follow", "(normal * after)[0] + constant", "(normal * after)[0]", EQUATIONS),
    Mutation("derive/equations/explicit.py", "_first_return", "(b * s - a * c) / square",
             "(b * s + a * c) / square", RETURN),
    Mutation("derive/equations/explicit.py", "_first_return", "-(b * c + a * s) / square",
             "-(b * c - a * s) / square", RETURN),
    Mutation("derive/equations/section.py", "section_of",
             "constraints.append((row, -velocity))", "constraints.append((row, velocity))",
             EQUATIONS),
    Mutation(_FLOWS, "_positive_modes", "(1 + (a - d) / gap) / 2", "(1 - (a - d) / gap) / 2",
             MODAL),
    Mutation(_FLOWS, "_oscillating_terms", "-matrix * centre", "matrix * centre", MODAL),
    Mutation("derive/codegen/body.py", "_prepared",
             "_distributed(map_numbers(expression, Constant))", "map_numbers(expression, Constant)",
             ("tests/derive/test_codegen.py", "-knumber_in_front")),
    Mutation(_FLOWS, "_held_terms", '(TIME, "xh", "vh", identity)', '(one, "xh", "vh", identity)',
             MODAL),
    Mutation(_ASSEMBLY, "Assembly.impulse", "1 + part.restitution", "1 - part.restitution",
             BUILDING),
    Mutation(_ASSEMBLY, "Assembly.pressure", "-self.reaction(index, regimes)",
             "self.reaction(index, regimes)", BUILDING),
    Mutation(_ASSEMBLY, "Assembly.excesses", "-force - part.limit", "-force + part.limit",
             BUILDING),
    Mutation(_ASSEMBLY, "Assembly.boundaries", "-part.slides(regime)", "part.slides(regime)",
             BUILDING),
    Mutation(_ASSEMBLY, "Assembly._drift", "(weights * speeds)[0] - part.speed",
             "(weights * speeds)[0]",
             ("tests/derive/test_building.py", "tests/simulation/test_contact_law.py",
              "tests/simulation/test_friction_loads.py")),
    Mutation("derive/building/impacts.py", "_interact", "assembly.coupling(i, j) != 0", "False",
             ("tests/simulation/test_building_motions.py", "tests/proof/test_stops_together.py",
              "tests/derive/test_building.py", "tests/orbits/test_stop_orbits.py")),
    Mutation("derive/building/impacts.py", "_at_once", "1 + assembly.stop(i).restitution",
             "1", ("tests/simulation/test_building_motions.py", "tests/orbits/test_stop_orbits.py",
                   "tests/proof/test_stops_together.py")),
)  # fmt: skip

EMITTERS = (
    Mutation("derive/codegen/c.py", "_Printer._print_Pow", 'f"(1.0/({product}))"',
             'f"({product})"', PRINTING),
    Mutation("derive/codegen/any_arithmetic.py", "_Printer._print_Pow",
             'power if exponent > 0 else f"1/{power}"', "power", PRINTING),
    Mutation("derive/codegen/any_arithmetic.py", "_Printer._print_Rational",
             'f"lib.rational({expr.p}, {expr.q})"', 'f"{expr.p} / {expr.q}"', PRINTING),
    Mutation("derive/codegen/solver.py", "lane_sources",
             '"sine" if isinstance(line.expression, sp.sin) else "cosine"',
             '"cosine" if isinstance(line.expression, sp.sin) else "sine"',
             SOLVER_IN_C),
    Mutation("derive/codegen/solver.py", "_newton",
             'lines.append(f"open[lane] = ({small}) ? 0.0 : open[lane];")',
             'lines.append("open[lane] = 0.0;")', SOLVER_IN_C),
    Mutation("derive/codegen/solver.py", "_status", "link.duration != 0",
             "link.duration == link.dwell", SOLVER_IN_C),
    Mutation("derive/codegen/emit.py", "_wrapped", "all(a.size for a in results)", "True",
             ("tests/derive/test_codegen.py", "-kfunction_of_nothing")),
)  # fmt: skip

ENGINES = (
    Mutation(_CROSSING, "_root", "-2 * value / (slope + root)", "-value / slope", SEARCH),
    Mutation(_CROSSING, "Series.bend", "abs(c)", "c", START),
    Mutation(_CROSSING, "Start.of", "found.sign > 0", "found.sign < 0", SEARCH),
    Mutation(_CROSSING, "_Search.leave", "0.5 * (series.order + 1) * -series.lead / bound",
             "2.0 * (series.order + 1) * -series.lead / bound", START),
    Mutation(_CROSSING, "_Search.run", "function.ceiling(t) < -2 * error",
             "function.ceiling(t) < 1", SEARCH),
    Mutation(_CROSSING, "_Search.run", "2 * bend * near <= slope * slope",
             "bend * near <= 8 * slope * slope", SEARCH),
    Mutation(_CROSSING, "_Search.run",
             "curvature + UNIT * second + (third * wider if third else 0.0)",
             "curvature + UNIT * second", SEARCH),
    Mutation(_CROSSING, "_Search._bisected", "self.jet(middle)[0] < 0", "self.jet(middle)[0] > 0",
             SEARCH),
    Mutation("runtime/events/leading_derivative.py", "leading", "order >= first", "order > first",
             ("tests/events/test_transition_choice.py", *SEARCH)),
    Mutation("runtime/events/leading_derivative.py", "Located.leading",
             "max(ahead, abs(dot(row, self.moved)))", "0.0",
             ("tests/events/test_transition_choice.py", "-kerror_of_the_time")),
    Mutation("runtime/events/contact_choice.py", "_box", "(-limit, limit)", "(-limit, 0.0)",
             MINIMUM),
    Mutation("runtime/events/contact_choice.py", "Chooser._ways", "reached | slipping", "reached",
             ("tests/simulation/test_contact_law.py", "tests/events/test_transition_choice.py")),
    Mutation("runtime/events/guaranteed_maxima.py", "largest", "splits == 8192 * cells",
             "splits == cells", SUMS),
    Mutation("runtime/events/guaranteed_maxima.py", "_upper",
             "0.5 * (left.value + right.value) + width * (left.slope - right.slope) / 6 + excess",
             "0.5 * (left.value + right.value) + width * (left.slope - right.slope) / 6", SUMS),
    Mutation(_STEPPING, "_Stepper.event", "best[0] if best else math.inf", "math.inf",
             (*STEPPING, "-korder_of_boundaries")),
    Mutation(_STEPPING, "_together", "rounding + error * abs(slope)", "0.0", STEPPING),
    Mutation(_STEPPING, "run", "stepper.kept(transition, located)", "frozenset()",
             (*STEPPING, "-kwhat_was_located")),
    Mutation("runtime/engine/search.c", "stays_below", "* (1.0 / 144.0)", "* 0.0", CELLS),
    Mutation("runtime/engine/search.c", "rises", "left.slope > loss && right.slope > loss && "
             "between > loss", "1", CELLS),
    Mutation("runtime/engine/search.c", "gather", "its_error + fabs(its_slope) * event->time_error",
             "0.0", EXACT),
    Mutation("runtime/engine/search.c", "gather", "4.0 * DBL_EPSILON * time", "0.0", TOGETHER),
    Mutation("runtime/engine/search.c", "search_linear", "found < time", "found > time", EXACT),
    Mutation("runtime/engine/search.c", "phase_search",
             "found <= earliest && (first < 0 || found < earliest)",
             "found <= earliest && first < 0", ENGINE),
    Mutation("runtime/engine/cell.c", "safe_step", "2.0 * second * at.value", "second * at.value",
             CELLS),
    Mutation("runtime/engine/cell.c", "cell_first", "at.value > 2.0 * error", "0", CELLS),
    Mutation("runtime/engine/cell.c", "cell_leave", "factor /= k + 1;", "factor /= k + 2;",
             REFERENCE),
    Mutation("runtime/engine/engine.c", "later", "return (long_time){high, low - (high - sum)};",
             "return (long_time){sum, 0.0};", EXACT),
    Mutation("runtime/engine/engine.c", "reset", "double sum = matrix[n],", "double sum = 0.0,",
             ENGINE),
    Mutation("runtime/engine/engine.c", "choose", "== set[k]", "!= 0", ENGINE),
    Mutation("runtime/engine/engine.c", "rises_first", "return value > 0.0;",
             "return value < 0.0;", ENGINE),
    Mutation("runtime/engine/engine.c", "rises_first", "fmax(next, fabs(drift))", "fabs(drift)",
             TOGETHER),
    Mutation("runtime/engine/engine.c", "same_functions", "row[b] == located", "b == 0",
             ("tests/simulation/test_order_of_boundaries.py",),
             equivalent="what is known to be zero has a slack of 1024 times the rounding of its"
             " terms, others have 1: in 120,000 impacts of up to six masses, in both orders of"
             " declaration, no located value was off by more than that one"),
    Mutation("runtime/engine/phase.c", "turn", "angle > 8.0", "angle < 0.0", EXACT),
    Mutation("runtime/engine/phase.c", "phase_beginning", "d > 0.0 ? 1 : -1", "1", ENGINE),
    Mutation("runtime/engine/phase.c", "phase_begin", "else if (g > 0.0)", "else if (g < 0.0)",
             ENGINE),
)  # fmt: skip

NEWTON = (
    Mutation("runtime/shooting/newton.py", "damping", "change < 0", "change > 0", SOLVE),
    Mutation("runtime/shooting/newton.py", "damping", "np.minimum(1.0, bound.min(axis=-1, "
             "initial=math.inf))", "1.0 + 0.0 * bound.sum(axis=-1)", SOLVE),
    Mutation("runtime/shooting/newton.py", "climb", "not correction < 1e-3", "False",
             SOLVE),
    Mutation("runtime/shooting/newton.py", "climb",
             "not correction <= lib.mp.mpf(10) ** -(digits - MARGIN)", "False",
             SOLVE),
    Mutation("runtime/shooting/newton.py", "iterate", "ended = running[~going]",
             "ended = running[going]", SOLVE),
    Mutation("runtime/shooting/newton.py", "judged", "dwell > of_dwell", "dwell > -1e300", SOLVE),
    Mutation("runtime/shooting/newton.py", "judged", "dwell > of_dwell", "dwell > 0", WITHIN),
    Mutation(_KERNELS, "solve_full", "not error < DETERMINED", "False",
             SOLVE),
    Mutation(_KERNELS, "solve_full", "fraction == 1 and small", "small", SOLVE),
    Mutation(_KERNELS, "_solve_flat", "duration <= 0", "duration < 0", SOLVE),
    Mutation(_KERNELS, "_solve_flat.advance", "np.abs(wanted - here)", "np.abs(following - here)",
             SOLVE),
    Mutation(_TABLES, "solve_in_python", "status[~np.isfinite(residual)] = INVALID", "pass",
             STATUSES),
    Mutation(_TABLES, "solve_in_python", "~(missed <= MOST_RESIDUAL)", "(missed < 0)", STATUSES),
    Mutation(_TABLES, "solve_in_python", "~(least > LEAST)", "(least < 0)", STATUSES),
    Mutation("runtime/shooting/variational.py", "shooting_map",
             "-missed / arithmetic.number(speed)", "missed / arithmetic.number(speed)",
             (*COMPOSED, *SECTIONS)),
    Mutation("runtime/shooting/variational.py", "_Arrays.beside", "row[..., -1:] += value", "pass",
             (*COMPOSED, *SECTIONS)),
)  # fmt: skip

JUDGING = (
    Mutation("runtime/shooting/variational.py", "section_map",
             "behind - arithmetic.carry(phase.reset, velocity)", "behind - velocity", SECTIONS),
    Mutation("runtime/shooting/variational.py", "section_map",
             "linear - velocity * ahead / speed", "linear", SECTIONS),
    Mutation("runtime/shooting/section_map.py", "stroboscopic_maps",
             "-turned / (turn * turn).sum(axis=-1, keepdims=True)",
             "turned / (turn * turn).sum(axis=-1, keepdims=True)",
             (*SECTIONS, "tests/orbits/test_forced.py", "tests/explore/test_chart_composed.py")),
    Mutation(_STABILITY, "_assessed", "-round(float(_modulus(m, orbit)), 12)",
             "round(float(_modulus(m, orbit)), 12)", STABILITY),
    Mutation(_STABILITY, "_assessed", "2 - abs(trace - 1)", "2 - abs(trace)", STABILITY),
    Mutation(_STABILITY, "_assessed", "abs(distance) <= error", "False", STABILITY),
    Mutation(_STABILITY, "_assessed", "not m.trivial", "True", STABILITY,
             equivalent="the margin of a neutral orbit is 0; a multiplier beyond 1 is larger than"
                        " the trivial one, and one that grazes or is undecided is as large as"
                        " it, to rounding"),
    Mutation(_STABILITY, "_grazes", "abs(rate) <= error * size", "False", GRAZING),
    Mutation(_STABILITY, "_conservative", "1 / larger", "larger", STABILITY),
    Mutation(_STABILITY, "_conservative", "Multiplier(half, -height)", "Multiplier(half, height)",
             STABILITY),
    Mutation(_ADMISSIBLE, "assess_admissibility", "not duration > none", "duration < none",
             ADMISSIBLE),
    Mutation(_ADMISSIBLE, "assess_admissibility",
             "max(least[opened], found.value / -boundary.open_coefficient)",
             "found.value / -boundary.open_coefficient", ADMISSIBLE,
             equivalent="the maximum is at least its floor, which is the bound so far times the"
                        " coefficient: the quotient is that bound again, to rounding"),
    Mutation(_ADMISSIBLE, "assess_admissibility", "function.raised(shift)",
             "function.raised(-shift)", ADMISSIBLE),
    Mutation(_ADMISSIBLE, "assess_admissibility", "rises or found.value > floor",
             "found.value > 2 * abs(floor) + 1", ADMISSIBLE),
    Mutation(_ADMISSIBLE, "_admissible_numpy", "highest.value / unit", "highest.value",
             ADMISSIBLE),
    Mutation(_ADMISSIBLE, "_sums", "first_frequency[boundary.phase]", "first_frequency[0]",
             ADMISSIBLE),
)  # fmt: skip

PROOFS = (
    Mutation(_KRAWCZYK, "Krawczyk.__call__", "all(abs(d) < r for d, r in zip(moved, radii, "
             "strict=True))", "any(abs(d) < r for d, r in zip(moved, radii, strict=True))",
             CERTIFY),
    Mutation(_KRAWCZYK, "Krawczyk.__call__", "any(abs(d) > r for d, r in zip(moved, radii, "
             "strict=True))", "False", CERTIFY),
    Mutation(_KRAWCZYK, "Krawczyk._moved", "self.equations.linearised(box, self.flows)",
             "self.equations.linearised(self.centre, self.flows)", (*CERTIFY, *BOXES)),
    Mutation("runtime/proof/multipliers.py", "inside_circle", "product < 1", "True", CERTIFY),
    Mutation("runtime/proof/multipliers.py", "inside_circle", "abs(trace_of(power)) > size",
             "abs(trace_of(power)) > 0", CERTIFY),
    Mutation("runtime/proof/multipliers.py", "neutral_pairs", "abs(half) < 1", "abs(half) < 2",
             CERTIFY),
    Mutation("runtime/proof/multipliers.py", "apart", "abs(slope) > _LEAST_SLOPE", "True",
             PIECES),
    Mutation(_PROVEN, "_Phase.judged", "self.dwell < 0", "False", PIECES),
    Mutation(_PROVEN, "_Phase._speed", "speed < 0", "False", PIECES),
    Mutation(_PROVEN, "_Phase._first", "follower is not None and follower.wanted", "True",
             PIECES),
    Mutation(_PROVEN, "judge", 'Judgement("undecided", undecided, (), tuple(open_), touching)',
             'Judgement("proved", "", ())', CERTIFY),
    Mutation("runtime/proof/krawczyk.py", "joined",
             "krawczyk(equations, centre, [r.upper() for r in radii]).unique",
             "True", PIECES),
    Mutation("runtime/proof/branch/tube.py", "proved_piece", "not tube.holds(at, others)",
             "False", BRANCHES),
    Mutation("runtime/proof/branch/crossing.py", "crossing_of", "not (rate > 0 or rate < 0)",
             "False", BRANCHES),
    Mutation("runtime/proof/branch/crossing.py", "crossing_of", "not (below < 0 and above > 0)",
             "False", BRANCHES),
    Mutation("runtime/checker/branch_tile.py", "CheckedTile.holds", "abs(x - c) < r", "True",
             CHECKED_BRANCHES),
    Mutation("runtime/checker/branch.py", "_claimed", "same or tile[\"event\"]", "True",
             CHECKED_BRANCHES),
    Mutation("runtime/proof/counting/branch_and_prune.py", "search", "any(_same(root, other) for "
             "other in roots)", "False", COUNTED),
    Mutation("runtime/proof/counting/branch_and_prune.py", "_examined",
             "root is not None and inside(kept, root.unique)", "root is not None", COUNTED),
    Mutation("runtime/proof/counting/branch_and_prune.py", "search",
             "[sides for sides in left if not any(inside(sides, r.unique) for r in roots)]", "[]",
             COUNTING),
    Mutation("runtime/proof/counting/branch_and_prune.py", "untouched", "(tuple(problem.domain),)",
             "()", COUNTING),
    Mutation("runtime/cli/keeping.py", "worked",
             "_exchange(first, _keep_first)", "None",
             ("tests/cli/test_faults.py", "-kwhile_a_file")),
    Mutation("runtime/proof/counting/contraction.py", "contract", "unique and inside", "unique",
             COUNTED),
    Mutation("runtime/proof/counting/contraction.py", "excluding",
             "bool(determinant > 0 or determinant < 0)", "True", COUNTED),
    Mutation("runtime/proof/counting/contraction.py", "contract", "linear.trivial", "False",
             COUNTED),
)  # fmt: skip

CHECKS = (
    Mutation(_TILES, "MapTile._judge", 'demand(same, "another orbit is found on a part of it")',
             "None", TILES),
    Mutation(_TILES, "MapTile._all",
             'demand(near, "the orbit is not near the numbers that are stated")', "None", TILES),
    Mutation(_TILES, "check_whole", 'demand(_fill(places), "the tiles do not fill the box")',
             "None", TILES),
    Mutation(_TILES, "MapTile._orbit", "orbit.returns(self.energies)", "None", TILES),
    Mutation("runtime/checker/divided.py", "Division._beyond",
             'demand(missed < radius * abs(slope), "there may be an event beside its band")',
             "None", ("tests/proof/test_regions.py",)),
    Mutation("runtime/checker/divided.py", "checked_band",
             'demand(whole or abs(centre[1]) > bends, "a side may consist of several parts")',
             "None", ("tests/proof/test_regions.py",)),
    Mutation(_TILES, "_total",
             'demand(verdict == worst, f"{name} of the box is not that of the tiles")', "None",
             TILES),
    Mutation(_MOTION, "admissibility",
             'demand(all(m > 0 for m in stated.values()), "a margin is not positive")', "None",
             CHECKER),
    Mutation(_MOTION, "admissibility", 'demand(not stated, "a margin is stated of nothing")',
             "None", CHECKER),
    Mutation(_MOTION, "_phase.clear", "size > arb(least)", "size > 0", CHECKER),
    Mutation(_MOTION, "_first", "-1 if way.wanted else 1", "-1", CHECKER),
    Mutation(_MOTION, "_below", "value > 0", "False", CHECKER),
    Mutation(_MOTION, "_below", "arb(0).union(r * r / 2)", "arb(0)", CHECKER),
    Mutation("runtime/checker/orbit.py", "CheckedOrbit.locate",
             "all(abs(d) < r for d, r in zip(moved, tried, strict=True))", "True", CHECKER),
    Mutation("runtime/checker/orbit.py", "CheckedOrbit.returns",
             'demand(force > 0 or force < 0, "the energy does not give the coordinate left out")',
             "None", CHECKER),
    Mutation("runtime/checker/exact.py", "check_sum",
             'demand(content["sha256"] == digest, "edited or damaged: the checksum differs")',
             "None", CHECKER),
    Mutation("runtime/checker/exact.py", "agreed_claims",
             'demand(alone or reasons.keys() == missed, "there are reasons for other claims")',
             "None",
             ("tests/checker/test_false_files.py",)),
    Mutation("runtime/checker/stability.py", "_inside", "1 - last * last", "1", CHECKER),
    Mutation("runtime/checker/stability.py", "_inside", "abs(last) > 1", "False", CHECKER),
    Mutation("runtime/checker/stability.py", "check_multipliers",
             "any(first.overlaps(second) for first, second in combinations(discs, 2))", "False",
             CENSUS),
    Mutation("runtime/checker/stability.py", "paired", "first.imag.contains(0)", "False", EVENTS),
    Mutation("runtime/checker/census.py", "check_listed", 'demand(apart, "two orbits may be one")',
             "None", CENSUS),
    Mutation("runtime/checker/census.py", "_check_side", "value > low", "value >= low", CENSUS),
    Mutation("runtime/checker/census.py", "_check_place",
             'demand(inside, f"{name} is not where it was counted")', "None", CENSUS),
    Mutation("runtime/checker/events.py", "_roots",
             'demand(all(abs(e) < 1 for e in found), "there may be no such event in the box")',
             "None", EVENTS),
    Mutation("runtime/checker/events.py", "_event",
             'demand((n * (b * (b * y)))[0, 0] < 0, "the boundary is not touched from inside")',
             "None", EVENTS),
    Mutation("runtime/checker/events.py", "_multiplier",
             'demand(kind == "flip" or not orbit.declared.omega, "1 is always a multiplier")',
             "None", EVENTS),
    Mutation("runtime/checker/points.py", "check",
             'demand(inside(found[name], enclosure), f"{name} is not in its enclosure")', "None",
             CHECKER),
    Mutation("runtime/checker/stability.py", "check_multipliers",
             'demand(inside, "a stated multiplier is none")', "None", CHECKER),
)  # fmt: skip

_SHOOTING = ("tests/shooting/test_derivatives.py",)
_BATCHES = ("tests/orbits/test_many_derivatives.py",)
_DRIVEN = ("tests/model/test_driven_modes.py",)
BRANCHES = (
    Mutation("runtime/engine/shooting.c", "shoot", "ends[i * unknowns + p] += velocity[i]", "",
             _SHOOTING),
    Mutation("runtime/engine/shooting.c", "carry", "after[unknowns - 1] += applied",
             "after[unknowns - 1] += 0.0 * applied", _SHOOTING),
    Mutation("runtime/engine/exponential.c", "multiply_moved",
             "result[i * columns + n] += left_moved[i * columns + n]", "", _SHOOTING),
    Mutation("runtime/engine/directions.c", "pass", "a->velocity[i] * rate[k]",
             "0.0 * a->velocity[i] * rate[k]", _BATCHES),
    Mutation("runtime/engine/directions.c", "pass_map", "section[i] = a->slid[i] * wait",
             "section[i] = 0.0 * wait", _BATCHES),
    Mutation("runtime/engine/directions.c", "at_fixed_times", "turn[k] * growth", "0.0", _BATCHES),
    Mutation("runtime/orbits/table_directions_many.py", "_turn", "abs(sums) > _SAME * scales",
             "abs(sums) > scales", _BATCHES),
    Mutation("runtime/orbits/table_directions_many.py", "_moving", "inside += size", "None",
             _BATCHES),
    Mutation("runtime/shooting/multiplier_derivatives.py", "_reduced_of_many",
             "changed[:, :, :rank, :rank] + beside[:, None] @ across",
             "changed[:, :, :rank, :rank]", _BATCHES),
    Mutation("runtime/shooting/derivatives.py", "dependent_variational",
             "slopes[:, later] += found.slopes[:, later, place, None] * rate", "None", _SHOOTING),
    Mutation("runtime/model/driven_modes.py", "driven_modes", "(k + 1) * following",
             "following * 0", _DRIVEN),
    Mutation("runtime/explore/continuation/stepping.py", "_ended",
             "not _determined(curve, found[0], normal)", "False",
             ("tests/package/test_readme.py", "-ksession")),
    Mutation("runtime/explore/continuation/locating.py", "_root.value",
             "abs(found) > _ROUNDING * largest", "True", ("tests/explore/test_roots.py",)),
)  # fmt: skip

KEEPING = (
    Mutation(_FILES, "write_file", "os.replace(temporary, target)",
             "shutil.copyfile(temporary, target)", (*FILES, "tests/cli/test_faults.py")),
    Mutation(_FILES, "write_file", "temporary.unlink(missing_ok=True)", "None", FILES),
    Mutation(_FILES, "write_file", "check_target(path)", "None", FILES),
    Mutation(_FILES, "check_target", "not stat.S_ISREG(found.st_mode)", "False", FILES),
    Mutation(_FILES, "folder_made", "path.rmdir()", "None", FILES),
    Mutation(_FILES, "fill_file", "shutil.copymode(instead, file)", "None", FILES),
    Mutation(_FILES, "read_file", "len(found) > largest", "False", (*FILES, *RESULTS)),
    Mutation(_RESULTS, "FileFormat.check_sum",
             'content["sha256"] != checksum_of(content, *numbers)', "False", RESULTS),
    Mutation(_RESULTS, "_once", "len(found) < len(pairs)", "False",
             ("tests/checker/test_false_files.py",)),
    Mutation(_RESULTS, "checksum_of", "found.update(part)", "None",
             (*RESULTS, "tests/simulation/test_saved_trajectory.py")),
    Mutation("runtime/model/loading/caching.py", "_fault", "found.st_mode & others and not kept",
             "False", ("tests/model/test_loading.py", "tests/present/test_saved_systems.py")),
    Mutation("runtime/model/loading/caching.py", "stored",
             "first != _CHECKSUM + _checksum(text)", "False", ("tests/model/test_loading.py",)),
    Mutation("runtime/core/values.py", "Value.mpf", "bits < limit", "False", VALUES),
    Mutation("runtime/core/workload.py", "check_hours",
             "not yes and not seconds / 3600 / processors <= HOURS",
             "seconds > HOURS * 1e300", WORKLOAD),
    Mutation("runtime/core/workload.py", "check_memory", "not size <= there", "False",
             WORKLOAD),
)  # fmt: skip

COMMANDS = (
    Mutation(_DOOR, "fail", 'told if code == UNANSWERED else f"error: {told}"', "told", DOOR),
    Mutation(_DOOR, "_reason", "return UNANSWERED, one_line(str(problem))",
             "return WRONG_INPUT, one_line(str(problem))", DOOR),
    Mutation(_DOOR, "assignments", "name in found", "False", DOOR),
    Mutation(_DOOR, "ranges", "name in found", "False", DOOR),
    Mutation(_DOOR, "ranges", "3 if counts else 2", "len(parts)", DOOR),
    Mutation(_DOOR, "check_drawing", "check_target(path)", "None", DOOR),
    Mutation("runtime/cli/certifying.py", "_judged", "NOT_MET", "UNANSWERED",
             ("tests/cli/test_certify_command.py",)),
)  # fmt: skip

_FITTING = "runtime/explore/fitting"
_FITTED = ("tests/explore/test_fit.py",)
_RESPONSES = ("tests/explore/test_fit_responses.py",)
FITS = (
    Mutation(
        f"{_FITTING}/prediction.py",
        "predict",
        'jacobian[:, clock] = -np.einsum("mn,mn->m", rows[:, :-1], rates[places])',
        'jacobian[:, clock] = np.einsum("mn,mn->m", rows[:, :-1], rates[places])',
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/prediction.py",
        "predict",
        "output.terms",
        "not output.terms",
        _RESPONSES,
    ),
    Mutation(
        f"{_FITTING}/response_quantities.py",
        "_phase",
        "np.arctan2(-s, c)",
        "np.arctan2(s, c)",
        _RESPONSES,
    ),
    Mutation(
        "runtime/orbits/motion_derivatives.py",
        "OrbitMotionDerivatives.quadrature",
        "times = wait * nodes",
        "times = wait.real * nodes",
        _RESPONSES,
    ),
    Mutation(
        f"{_FITTING}/response_prediction.py",
        "predict_steady",
        "missed < best",
        "best == np.inf",
        _RESPONSES,
    ),
    Mutation(
        f"{_FITTING}/local_maxima.py",
        "_on_panels",
        "range(_ORDERS - 1)",
        "range(_ORDERS - 2)",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/prediction.py",
        "predict",
        "derivatives.event_times[reached - 1]",
        "derivatives.event_times[reached - 2]",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/prediction.py",
        "predict",
        "times_of_events(motion, series.expression)[series.places]",
        "times_of_events(motion, series.expression)[: len(series.places)]",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/prediction.py",
        "motion_under",
        "_LONGER if events else _LONGER[:1]",
        "_LONGER[:1]",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/residuals.py",
        "FitProblem.weighted",
        "np.eye(1, len(point), place) / deviation",
        "np.eye(1, len(point), place)",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/minimise.py", "_noise", "1 - leverage[here]", "1 + leverage[here]", _FITTED
    ),
    Mutation(
        f"{_FITTING}/statistics.py",
        "statistics",
        "inner[unknown, unknown] = np.inf",
        "inner[unknown, unknown] = 0.0",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/statistics.py",
        "_factor",
        "total / freedom / slope**2",
        "total / freedom * slope**2",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/nearest_grazing.py",
        "_gradients",
        "-(normal @ states[next(inside)] + tables.rows[:, row] @ at)",
        "-(tables.rows[:, row] @ at)",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/nearest_grazing.py",
        "_of_arrival",
        "speed * speeds / -bend + speed**2 * bends / (2 * bend**2)",
        "speed * speeds / bend",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/fit.py",
        "_same_sequence",
        "counts[each.expression] == each.places[-1] + 1",
        "counts[each.expression] > each.places[-1] + 1",
        _FITTED,
    ),
    Mutation(
        f"{_FITTING}/unknowns.py", "_guess", "lower <= value <= upper", "value <= upper", _FITTED
    ),
    Mutation(
        "runtime/cli/fitting.py",
        "_take_guesses",
        "known[name] = guess",
        "known[name] = 1",
        ("tests/cli/test_fit_command.py",),
    ),
)

_DESIGN = "runtime/explore/design"
_DESIGNED = ("tests/explore/test_design.py", "-klevel or derivatives")
_WORST = ("tests/explore/test_design_worst.py",)
DESIGNS = (
    Mutation(
        f"{_DESIGN}/largest.py",
        "radius_rows",
        "by_parameters += [-trace_rates, trace_rates]",
        "by_parameters += [trace_rates, trace_rates]",
        _DESIGNED,
    ),
    Mutation(
        f"{_DESIGN}/multiplier_pairs.py",
        "_plane",
        "np.abs(inside - z).min() < np.abs(outside - z).min(initial=np.inf)",
        "np.abs(inside - z).min() > np.abs(outside - z).min(initial=np.inf)",
        _DESIGNED,
    ),
    Mutation(
        f"{_DESIGN}/worst_over.py",
        "_looked",
        "aim.value(there) > level + _WORSE",
        "aim.value(there) > level + 1",
        _WORST,
    ),
)

MUTATIONS = (
    *DERIVATION, *EMITTERS, *ENGINES, *NEWTON, *JUDGING, *PROOFS, *CHECKS, *BRANCHES,
    *KEEPING, *COMMANDS, *FITS, *DESIGNS,
)  # fmt: skip
