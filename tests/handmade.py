"""Systems whose tables and kernels are written by hand, without any derivation.

Masses between stops at both sides, driven by a rotating force of frequency Omega:
x'' + 2 zeta x' + x = F c and y'' + 2 zeta y' + y = F s, with impacts x' -> -r x'.
"""

from types import ModuleType

from nonsmooth.runtime.model.kernels import OrbitKernels, SystemKernels

DATA = {"Omega": "1.7", "zeta": "0.05", "r": "0.8", "d": "0.5", "F": "1"}
MIRROR = {"x": "-x", "v": "-v", "c": "-c", "s": "-s"}


def _parameter(name, upper=None):
    return {
        "name": name,
        "description": name,
        "lower": "0",
        "upper": upper,
        "closed": name in ("zeta", "r"),
        "upper_closed": upper is not None,
    }


def _module(name, states, boundaries, transitions, functions, forcing):
    """One configuration; boundaries are all reached, transitions take sets and resets."""
    size = len(states)
    module = ModuleType(f"handmade_{name.replace('-', '_')}")
    fields, rows, resets = functions
    counts = {"fields": size, "rows": len(boundaries), "resets": size * (len(transitions) + 1)}
    module.__dict__.update(
        SYSTEM={
            "name": name,
            "description": "made by hand",
            "states": states,
            "parameters": [
                _parameter(parameter, "1" if parameter == "r" else None) for parameter in DATA
            ],
            "constraints": [],
            "configurations": {"free": [{"name": b, "acts_when": "reached"} for b in boundaries]},
            "spectrum": [],
            "spectrum_parameters": [],
            "modes": None,
            "forcing": [list(forcing)],
            "coordinates": [
                list(pair)
                for pair in zip(states[: size // 2 - 1], states[size // 2 - 1 : -2], strict=True)
            ],
            "held": {"free": []},
            "constraint_rows": {"free": []},
            "boundary_rows": {"free": list(range(len(boundaries)))},
            "transitions": [
                {
                    "source": "free",
                    "boundaries": sorted(reached),
                    "conditions": [],
                    "reset": place + 1,
                    "target": "free",
                }
                for place, reached in enumerate(transitions)
            ],
            "contacts": {},
        },
        ORBITS={},
        KERNELS={
            kernel: ([((5,), 0)], [(kernel, (count, size + 1))]) for kernel, count in counts.items()
        },
        DERIVATION="by hand",
        fields=fields,
        rows=rows,
        resets=resets,
    )
    return module


def _reset(size, bounced, r):
    unit = [[int(i == j) for j in range(size + 1)] for i in range(size)]
    for place in bounced:
        unit[place][place] = -r
    return unit


def two_stops(asymmetry=0):
    """One mass between stops at d and -d (1 + asymmetry), driven by F c."""

    def fields(p, lib):
        omega, zeta, _, _, force = p
        return [
            [0, 1, 0, 0, 0],
            [-1, -2 * zeta, force, 0, 0],
            [0, 0, 0, -omega, 0],
            [0, 0, omega, 0, 0],
        ]

    def rows(p, lib):
        return [[1, 0, 0, 0, -p[3]], [-1, 0, 0, 0, -p[3] * (1 + asymmetry)]]

    def resets(p, lib):
        return [row for bounced in ((), (1,), (1,)) for row in _reset(4, bounced, p[2])]

    stops = ["reaches-right", "reaches-left"]
    functions = fields, rows, resets
    module = _module("two-stops", ["x", "v", "c", "s"], stops, [{s} for s in stops], functions,
                     ("c", "s"))  # fmt: skip
    return SystemKernels("two-stops", module, None)


def _plane(name, second, stops, transitions):
    """Two masses x and y, y driven by F times the state `second`."""
    states = ["x", "y", "v", "w", "c", "s"]
    signs = {"right": (1, 0), "left": (-1, 0), "up": (0, 1), "down": (0, -1)}

    def fields(p, lib):
        omega, zeta, _, _, force = p
        drive = [0] * 7
        drive[states.index(second)] = force
        below = [0, -1, 0, -2 * zeta, 0, 0, 0]
        return [
            [0, 0, 1, 0, 0, 0, 0],
            [0, 0, 0, 1, 0, 0, 0],
            [-1, 0, -2 * zeta, 0, force, 0, 0],
            [a + b for a, b in zip(below, drive, strict=True)],
            [0, 0, 0, 0, 0, -omega, 0],
            [0, 0, 0, 0, omega, 0, 0],
        ]

    def rows(p, lib):
        return [[*signs[stop], 0, 0, 0, 0, -p[3]] for stop in stops]

    def resets(p, lib):
        bounced = [tuple({2 if signs[s][0] else 3 for s in reached}) for reached in transitions]
        return [row for places in [(), *bounced] for row in _reset(6, places, p[2])]

    functions = fields, rows, resets
    return SystemKernels(name, _module(name, states, stops, transitions, functions, ("c", "s")),
                         None)  # fmt: skip


def box():
    """A mass in a square box, driven by a rotating force: a quarter turn is a symmetry."""
    stops = ["right", "up", "left", "down"]
    return _plane("box", "s", stops, [{stop} for stop in stops])


def pair():
    """Two equal masses, equally driven: they may reach their stops together."""
    stops = ["right", "left", "up", "down"]
    sets = [*({stop} for stop in stops), {"right", "up"}, {"left", "down"}]
    return _plane("pair", "c", stops, sets)


def declared(**changes):
    """The orbit ``two-stops/left-right``, which has no kernels of its own."""
    system = two_stops()
    system.module.ORBITS["left-right"] = {
        "derived": False,
        "phases": [("free", "reaches-right", "ta"), ("free", "reaches-left", "tb")],
        "reference": {"parameters": dict(DATA), "guess": {"ta": "1.8", "tb": "1.8"}},
        **changes,
    }
    return OrbitKernels(system, "left-right")
