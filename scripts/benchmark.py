"""Measure the package against its peers: ratios within one run, medians and spread.

Peers that are not installed are left out, with a line that says so in the section `peers`; SciPy
and SymPy's lambdify always take part.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path

import numpy as np
from benchmarking.certify import boxed, certified, counted
from benchmarking.chart import chart
from benchmarking.continuation import branch
from benchmarking.declared import declared
from benchmarking.derivatives import derivatives
from benchmarking.fits import fits
from benchmarking.gradients import gradients
from benchmarking.measuring import Row, machine, timed
from benchmarking.peers import peers
from benchmarking.simulation import composed, many, sequences, simulation
from benchmarking.size import size
from rich.console import Console
from rich.table import Table

NAME = "dry-friction/global-stick"
POINT = {"chi": 0.5, "eta": 1.0, "V": 1.0, "e1": 3.0195, "e2": 0.4831}
GUESS = [1.18, -2.67, 1.0, 2.0, 1.57, 3.28]
DECLARATION = """
import sympy as sp
from nonsmooth.derive import Harmonic, Itinerary, Parameter, Reference, RigidStop, oscillator

zeta, Omega = Parameter("zeta", "damping ratio", lower=0, closed=True), Parameter("Omega", "")
gap = Parameter("gap", "place of the stop", lower=-sp.oo)
r = Parameter("r", "restitution", lower=0, upper=1, closed=True, upper_closed=True)
system = oscillator(
    "forced-impact", ["x"], mass=[[1]], stiffness=[[1]], damping=[[2 * zeta.symbol]],
    forcing=[Harmonic(Omega.symbol, cosine=[1])],
    elements=[RigidStop("x", at=gap.symbol, restitution=r.symbol, name="stop")],
    parameters=[zeta, Omega, gap, r],
)
data = Reference({"zeta": "0.05", "Omega": "2", "gap": "0", "r": "0.8"}, {"T": "3.1"})
orbits = [Itinerary("one-impact", system, [("free", "stop-reaches-stop", "T")], reference=data)]
"""
FLAGS = ["-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-std=c99"]


def batch(quick: bool) -> Iterator[Row]:
    """Solves over many parameter points, per solve and core."""
    import nonsmooth as ns

    for count in (10_000, 100_000 if quick else 1_000_000):
        eta = np.linspace(0.95, 1.05, count)
        for admissibility, must in ((False, 0.2e-6), (True, 1.5e-6)):

            def work(eta: np.ndarray = eta, admissibility: bool = admissibility) -> object:
                return ns.solve(NAME, {"eta": eta}, threads=1, admissibility=admissibility)

            label = f"{count:,} points, {'with' if admissibility else 'without'} admissibility"
            yield Row(label, timed(work, count), must)
    eta = np.linspace(0.95, 1.05, 10_000)
    ours = "10,000 points, without admissibility"
    yield Row("lambdify(cse), NumPy Newton", timed(lambdified(eta), len(eta), 3), against=ours)
    few = eta[:: 2500 if quick else 1000]
    yield Row("scipy.optimize.root, expm", timed(expm_root(few), len(few), 3), against=ours)
    for label, make in (("CasADi fast_newton", casadi_newton), ("heyoka cfunc", heyoka_newton)):
        if (peer := make(eta)) is not None:
            yield Row(label, timed(peer, len(eta), 3), against=ours)


def expanded() -> tuple[list, list, list, list]:
    """Parameters with spectrum entries, unknowns, residual and Jacobian without stages."""
    import sympy as sp

    from nonsmooth.derive import derive_equations, dry_friction
    from nonsmooth.derive.equations.program import evaluate

    orbit = derive_equations(dry_friction.global_stick)
    residual = evaluate(orbit.chain.stages, orbit.residual, {})
    jacobian = sp.Matrix(residual).jacobian(list(orbit.unknowns))
    inputs = [*orbit.parameters, *orbit.spectrum.symbols]
    return inputs, list(orbit.unknowns), residual, list(jacobian)


def lambdified(eta: np.ndarray) -> Callable[[], object]:
    """Vectorised Newton on SymPy's own NumPy code of the six equations."""
    import sympy as sp

    inputs, unknowns, residual, jacobian = expanded()
    # a flat list: nested ones silently lose the common subexpressions
    function = sp.lambdify([*inputs, *unknowns], [*residual, *jacobian], "numpy", cse=True)

    def evaluate(points: np.ndarray, spectrum: np.ndarray, x: np.ndarray) -> np.ndarray:
        values = function(*points, *spectrum, *x)
        return np.array([np.broadcast_to(v, eta.shape) for v in values])

    return numpy_newton(eta, evaluate)


def numpy_newton(eta: np.ndarray, evaluate: Callable[..., np.ndarray]) -> Callable[[], object]:
    """Vectorised Newton on a function that gives 6 residuals and 36 derivatives a point."""
    points, spectrum = data_of(eta)

    def work() -> np.ndarray:
        x = np.repeat(np.array(GUESS)[:, None], len(eta), axis=1)
        for _ in range(10):
            values = evaluate(points, spectrum, x)
            matrices = values[6:].reshape(6, 6, -1).transpose(2, 0, 1)
            step = np.linalg.solve(matrices, values[:6].T[..., None])
            x = x - step[..., 0].T
            if np.abs(step).max() < 1e-9:
                break
        return x

    return work


def data_of(eta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Parameters (5, n) and spectrum (7, n) of points that differ in eta."""
    from nonsmooth.runtime.model.kernels import load_orbit

    kernels = load_orbit(NAME)
    points = np.array([np.broadcast_to(POINT[n], eta.shape) for n in kernels.parameter_names])
    points[1] = eta
    return points, kernels.spectrum(points.T)[0].T


def heyoka_newton(eta: np.ndarray) -> Callable[[], object] | None:
    """Vectorised Newton on heyoka's compiled function of the same staged equations."""
    try:
        import heyoka
    except ImportError:
        return None
    from nonsmooth.runtime.model.kernels import load_orbit

    symbols = heyoka.make_vars(*(f"v{i}" for i in range(18)))
    at = (symbols[:5], symbols[5:12], symbols[12:])
    residual, jacobian = load_orbit(NAME).evaluate("residual", "jacobian", at=at, lib=heyoka)
    entries = [*residual, *(entry for row in jacobian for entry in row)]
    constant = heyoka.expression
    function = heyoka.cfunc(
        [e if isinstance(e, constant) else constant(float(e)) for e in entries], vars=symbols
    )
    return numpy_newton(eta, lambda *arrays: function(np.concatenate(arrays)))


def expm_root(points: np.ndarray) -> Callable[[], object]:
    """One scipy.optimize.root after the other, flows by scipy.linalg.expm."""
    from scipy.linalg import expm
    from scipy.optimize import root

    chi, v, e1, e2 = POINT["chi"], POINT["V"], POINT["e1"], POINT["e2"]

    def field(stiffness: list[list[float]]) -> np.ndarray:
        return np.block([[np.zeros((2, 2)), np.eye(2)], [-np.array(stiffness), np.zeros((2, 2))]])

    def equations(x: np.ndarray, eta: float) -> list[float]:
        stick = field([[0, 0], [0, 0]])
        slip_stick = field([[1, -chi], [0, 0]])
        slip = field([[1, -chi], [-chi * eta, chi * eta]])
        stick_slip = field([[0, 0], [-chi * eta, chi * eta]])
        a = expm(stick * x[2]) @ np.array([x[0], x[1], v, v])
        c = expm(slip_stick * x[3]) @ a
        d = expm(slip * x[4]) @ c
        e = expm(stick_slip * x[5]) @ d
        return [
            a[0] - chi * a[1] - e1,
            chi * (c[1] - c[0]) - e2,
            d[2] - v,
            e[3] - v,
            e[0] - x[0],
            e[1] - x[1],
        ]

    return lambda: [root(equations, GUESS, args=(eta,), tol=1e-10) for eta in points]


def casadi_newton(eta: np.ndarray) -> Callable[[], object] | None:
    """CasADi's fast_newton on the same staged equations."""
    try:
        import casadi
    except ImportError:
        return None
    from nonsmooth.runtime.model.kernels import load_orbit

    kernels = load_orbit(NAME)
    unknowns, inputs = casadi.SX.sym("x", 6), casadi.SX.sym("p", 12)
    point = [inputs[i] for i in range(5)]
    spectrum = [inputs[i] for i in range(5, 12)]
    residual = kernels.evaluate(
        "residual", at=(point, spectrum, [unknowns[i] for i in range(6)]), lib=casadi
    )
    problem = {"x": unknowns, "p": inputs, "g": casadi.vertcat(*residual)}
    solver = casadi.rootfinder("solve", "fast_newton", problem)
    data = np.vstack(data_of(eta))
    mapped = solver.map(len(eta))
    guess = np.repeat(np.array(GUESS)[:, None], len(eta), axis=1)
    return lambda: mapped(guess, data)


def kernel(quick: bool) -> Iterator[Row]:
    """Residual and Jacobian in C: ours against SymPy's cse of the expanded equations."""
    import sympy as sp

    from nonsmooth.derive.codegen.c import print_c
    from nonsmooth.runtime.model.kernels import load_orbit

    inputs, unknowns, residual, jacobian = expanded()
    common, reduced = sp.cse([*residual, *jacobian])
    arrays = (("p", inputs[:5]), ("s", inputs[5:]), ("x", unknowns))
    lines = [f"const double {s} = {a}[{i}];" for a, group in arrays for i, s in enumerate(group)]
    lines += [f"const double {symbol} = {print_c(e)};" for symbol, e in common]
    targets = [f"r[{i}]" for i in range(6)] + [f"j[{i}]" for i in range(36)]
    lines += [f"{target} = {print_c(e)};" for target, e in zip(targets, reduced, strict=True)]
    signature = "const double *p, const double *s, {}double *x, double *r, double *j"
    source = [
        "#include <math.h>",
        '#include "dry_friction.h"',
        f"static void plain({signature.format('const ')})",
        "{",
        *lines,
        "}",
    ]
    calls = {
        "ours": "dry_friction_global_stick_equations(p, s, x, NULL, r, j, NULL)",
        "plain": "plain(p, s, x, r, j)",
    }
    source += [
        f"void loop_{label}(long n, {signature.format('')})"
        f" {{ for (long i = 0; i < n; ++i) {{ {call}; x[3] += 1e-18*r[0]; }} }}"
        for label, call in calls.items()
    ]
    kernels = load_orbit(NAME)
    parameters = np.array([POINT[n] for n in kernels.parameter_names])
    spectrum, _ = kernels.spectrum(parameters)
    generated = Path(kernels.system.module.__file__ or "").resolve().parent
    count = 20_000 if quick else 200_000
    with tempfile.TemporaryDirectory() as folder:
        file, library = Path(folder) / "plain.c", Path(folder) / "plain.so"
        file.write_text("\n".join(source) + "\n")
        built = [str(file), str(generated / "dry_friction.c"), "-o", str(library), "-lm"]
        flags = [*FLAGS, "-fopenmp-simd", "-DNONSMOOTH_OPENMP_SIMD", "-shared", "-fPIC"]
        flags += [f"-I{generated}"]
        subprocess.run(["cc", *flags, *built], check=True)
        loaded = ctypes.CDLL(str(library))
        buffers = [parameters, spectrum, np.array(GUESS), np.zeros(6), np.zeros(36)]
        pointers = [ctypes.c_void_p(b.ctypes.data) for b in buffers]

        def measure(label: str) -> list[float]:
            return timed(lambda: loaded[f"loop_{label}"](ctypes.c_long(count), *pointers), count)

        yield Row("residual and Jacobian", measure("ours"))
        yield Row("plain SymPy cse", measure("plain"), against="residual and Jacobian")


def single(quick: bool) -> Iterator[Row]:
    """One orbit from Python."""
    import nonsmooth as ns
    from nonsmooth.runtime.model.kernels import load_orbit
    from nonsmooth.runtime.orbits.orbit import Orbit
    from nonsmooth.runtime.shooting.kernel_newton import solve_reduced

    kernels = load_orbit(NAME)
    parameters, guess = list(POINT.values()), [2.0, 1.568]
    repeat = range(20 if quick else 200)

    def numeric() -> None:
        for _ in repeat:
            solve_reduced(kernels, parameters, guess)

    def whole() -> None:
        for _ in repeat:
            ns.solve(NAME)

    yield Row("solve, numeric part", timed(numeric, len(repeat)), 100e-6)
    yield Row("solve, whole call", timed(whole, len(repeat)))

    def gradients(orbit: Orbit) -> Callable[[], object]:
        return lambda: [orbit.derivatives().trace for _ in repeat]

    orbit = ns.solve(NAME)
    tables = orbit.problem.by_tables(orbit)
    guess = [*tables.dwell_times, *tables.states[0]]

    def composed() -> None:
        for _ in repeat:
            ns.solve(orbit.system.name, tables.parameters, guess, itinerary=tables.itinerary)

    yield Row(
        "derivatives by all parameters",
        timed(gradients(orbit), len(repeat)),
        against="solve, whole call",
    )
    yield Row("solve by tables", timed(composed, len(repeat)))
    yield Row(
        "derivatives by all parameters, by tables",
        timed(gradients(tables), len(repeat)),
        against="solve by tables",
    )


def refine(quick: bool) -> Iterator[Row]:
    """One orbit to many digits."""
    import nonsmooth as ns
    from nonsmooth.runtime.core.arithmetic import Mpmath
    from nonsmooth.runtime.model.kernels import load_orbit

    orbit, kernels = ns.solve(NAME), load_orbit(NAME)
    runs = 3 if quick else 7
    for digits, must in ((50, 10e-3), (1000, 50e-3)):
        ours = f"{digits} digits"
        yield Row(ours, timed(lambda d=digits: ns.refine(orbit, d), 1, runs), must)
        check = timed(lambda d=digits: ns.refine(orbit, d, arithmetic="mpmath"), 1, runs)
        yield Row(f"{digits} digits by mpmath", check)
        lib = Mpmath(digits)

        def peer(lib: Mpmath = lib) -> object:
            parameters = [lib.number(v) for v in orbit.given.values()]
            spectrum, _ = kernels.spectrum(parameters, lib)
            return lib.mp.findroot(
                lambda *x: kernels.evaluate("residual", at=(parameters, spectrum, x), lib=lib),
                GUESS,
            )

        yield Row(f"mpmath findroot, {digits} digits", timed(peer, 1, runs), against=ours)


def derive(quick: bool) -> Iterator[Row]:
    """Derivation, emission and first answers in fresh processes, imports included."""
    module = "nonsmooth.derive.codegen.regenerate"
    code = f"from {module} import emit_systems; emit_systems(['dry-friction'])"
    yield Row(
        "derive and emit dry friction", timed(lambda: run([sys.executable, "-c", code]), 1, 3), 4.0
    )
    script = [sys.executable, str(Path(__file__).with_name("regenerate.py")), "--check"]
    yield Row("regenerate everything", timed(lambda: run(script), 1, 3), 8.0)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "oscillator.py"
        file.write_text(DECLARATION)
        first = [sys.executable, "-c", f"import nonsmooth; nonsmooth.solve('{file}:one-impact')"]
        for label, cache, must in (("nothing", "", 1.0), ("the cache", folder, 0.3)):
            found = timed(lambda c=cache: run(first, NONSMOOTH_CACHE=c), 1, 3 if quick else 7)
            yield Row(f"declared oscillator, first answer from {label}", found, must)


def process(quick: bool) -> Iterator[Row]:
    """Whole processes of the command line."""
    command = str(Path(sys.executable).with_name("nonsmooth"))
    runs = 3 if quick else 9
    yield Row("nonsmooth --help", timed(lambda: run([command, "--help"]), 1, runs), 0.3)
    verify = [command, "verify", NAME, "--digits", "50"]
    yield Row("nonsmooth verify --digits 50", timed(lambda: run(verify), 1, runs), 1.0)


def run(command: list[str], **environment: str) -> None:
    """Run a command and throw its output away."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    # modules keep their bytecode, as installed ones do
    given = os.environ | {"PYTHONDONTWRITEBYTECODE": ""} | environment
    subprocess.run(command, check=True, env=given, **quiet)


SECTIONS = {
    f.__name__: f
    for f in (
        *(batch, kernel, single, refine, derive, process),
        *(
            simulation,
            many,
            sequences,
            derivatives,
            composed,
            declared,
            certified,
            boxed,
            counted,
            chart,
            branch,
            size,
            gradients,
            fits,
            peers,
        ),
    )
}


def helped() -> str:
    """Each section's name with its one-line description."""
    return "\n".join(f"{name}: {section.__doc__}" for name, section in SECTIONS.items())


def main() -> None:
    """Run the sections asked for and print their tables."""
    layout = argparse.RawTextHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=layout)
    parser.add_argument("sections", nargs="*", metavar="SECTION", help=helped())
    parser.add_argument("--quick", action="store_true", help="fewer points and runs")
    parser.add_argument("--save", type=Path, metavar="FILE", help="put the sections into this JSON")
    chosen = parser.parse_args()
    for name in chosen.sections:
        if name not in SECTIONS:
            parser.error(f"no section {name!r} (known: {', '.join(SECTIONS)})")
    console = Console(width=110)
    for name in chosen.sections or SECTIONS:
        title = f"{name}: {SECTIONS[name].__doc__}"
        table = Table("what", "median", "min .. max", "must reach", "peer / ours", title=title)
        rows = {row.what: row for row in SECTIONS[name](chosen.quick)}
        for row in rows.values():
            spread = f"{pretty(min(row.seconds))} .. {pretty(max(row.seconds))}"
            must = "" if row.must is None else pretty(row.must)
            ratio = f"{row.median / rows[row.against].median:,.2f}" if row.against else ""
            what = f"{row.what}\n  {row.found}" if row.found else row.what
            table.add_row(what, pretty(row.median), spread, must, ratio)
        console.print(table)
        if chosen.save:
            save(chosen.save, name, list(rows.values()))


def save(file: Path, name: str, rows: list[Row]) -> None:
    """Write a section and the machine it was measured on into a file; other sections stay."""
    kept = json.loads(file.read_text("utf-8")) if file.exists() else {}
    kept[name] = {
        "about": SECTIONS[name].__doc__,
        "machine": machine(),
        "rows": [{**asdict(row), "seconds": sorted(row.seconds)} for row in rows],
    }
    kept = {section: kept[section] for section in SECTIONS if section in kept}
    file.write_text(json.dumps(kept, indent=1, ensure_ascii=False) + "\n", "utf-8")


def pretty(seconds: float) -> str:
    """A duration with a fitting unit."""
    for factor, unit in ((1, "s"), (1e3, "ms"), (1e6, "us"), (1e9, "ns")):
        if seconds * factor >= 1:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


if __name__ == "__main__":
    main()
