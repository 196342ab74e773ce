"""Common to all tests: threads, signals, and what processes share."""

import ctypes
import gc
import os
import shutil
import signal
import sys
import tempfile
from functools import cache

import pytest
import sympy.core.cache
import typer.testing
from hypothesis import HealthCheck, find, settings, strategies

from tests.places import CHECKOUT
from tests.shared import FOLDER

LIBC = ctypes.CDLL(None) if sys.platform == "linux" else None
M_ARENA_MAX = -8  # malloc.h of glibc: other libraries have none of it
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the workers' threads would compete
if hasattr(LIBC, "mallopt"):  # each thread would keep a memory of its own
    LIBC.mallopt(M_ARENA_MAX, 1)
# a shell that starts programs beside itself has them ignore it, and all that they start
signal.signal(signal.SIGINT, signal.default_int_handler)
# commands are made of functions once, as in a program, not for each question of a test
typer.testing._get_command = cache(typer.testing._get_command)

# the same examples in every run, on a machine as busy as may be
settings.register_profile(
    "laws", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("laws")
providers = sys.modules.get("hypothesis.internal.conjecture.providers")  # of later versions
if hasattr(providers, "is_local_module_file"):  # of constants in modules that others loaded
    providers.is_local_module_file = lambda path: False

# modules that keep what was derived and what is known of a system
_REMEMBERING = ("nonsmooth.derive.", "nonsmooth.runtime.")
GENERATED = CHECKOUT / "generated"
SUFFIXES = (".c", ".h", ".md", ".py", ".json")


def pytest_configure(config):
    """Make the folder of shared files in the first process; the others are told by it."""
    if FOLDER not in os.environ:
        os.environ[FOLDER] = folder = tempfile.mkdtemp()
        os.environ.setdefault("NONSMOOTH_CACHE", f"{folder}/cache")
        config.add_cleanup(lambda: shutil.rmtree(os.environ.pop(FOLDER, folder)))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """All tests of a file run in one process: what they share is made once."""
    from xdist.scheduler import LoadFileScheduling

    config.option.loadscopereorder = False
    return LoadFileScheduling(config, log)


@pytest.fixture(autouse=True, scope="session")
def hypothesis_begun():
    """Hypothesis makes its random numbers at its first use, and looks at who holds them."""
    find(strategies.just(True), bool)


@pytest.fixture(autouse=True, scope="module")
def forgotten(request):
    """What a file keeps for its tests is given back to the machine behind its last test."""
    gc.freeze()  # what is loaded stays: searching all of it behind each file takes a second
    yield
    own = (request.module, *(m for n, m in sys.modules.items() if n.startswith(_REMEMBERING)))
    for module in own:
        for value in vars(module).values():
            if hasattr(value, "cache_clear") and value.__module__ == module.__name__:
                value.cache_clear()
    sympy.core.cache.clear_cache()
    if "matplotlib.pyplot" in sys.modules:  # figures that nobody closed
        sys.modules["matplotlib.pyplot"].close("all")
    gc.collect()
    if hasattr(LIBC, "malloc_trim"):
        LIBC.malloc_trim(0)


@pytest.fixture(params=[pytest.param("c", marks=pytest.mark.compiled), "numpy"])
def backend(request, monkeypatch):
    """Both engines, and kernels of both kinds, one after the other."""
    monkeypatch.setenv("NONSMOOTH_BACKEND", request.param)
    return str(request.param)


@pytest.fixture
def committed_derivation(monkeypatch):
    """The committed files by name, in place of a derivation of many seconds.

    That they are what the derivation gives, `scripts/regenerate.py --check` says.
    """
    from nonsmooth.derive.codegen import regenerate
    from nonsmooth.derive.systems import SYSTEMS

    texts = {
        path.name: path.read_text(encoding="utf-8")
        for path in sorted(GENERATED.iterdir())
        if path.suffix in SUFFIXES and path.name != "__init__.py"
    }

    def wanted(folder, system, progress):
        progress("deriving")
        others = tuple(f"{SYSTEMS[name]}." for name in SYSTEMS if system not in (None, name))
        return {name: text for name, text in texts.items() if not name.startswith(others or ("/",))}

    monkeypatch.setattr(regenerate, "_wanted", wanted)
    return texts


@pytest.fixture
def fewer_looks(monkeypatch):
    """The branch of a smooth worst is looked at in fewer places, which move no optimum."""
    monkeypatch.setattr("nonsmooth.runtime.explore.design.worst_over._LOOKS", 9)
    monkeypatch.setattr("nonsmooth.runtime.explore.design.worst_over._FINER", 2)


@pytest.fixture
def given_chaos(monkeypatch):
    """A short proof where two masses on a belt are asked for: tests/proof/test_chaos.py has theirs.

    Sets of others are looked for about fewer points.
    """
    from nonsmooth import certify
    from tests.horseshoes import FRICTION_DATA, folded_horseshoe

    prove = certify.chaos

    def given(system, values, start, *rest, exponents, **options):
        if system != "dry-friction":
            return prove(system, values, start, *rest, exponents=exponents, **options)
        assert {name: value.text for name, value in values.items()} == FRICTION_DATA
        assert [value.text for value in start.values()] == ["1.93", "7.18", "1.18", "1.18"]
        return folded_horseshoe(exponents=exponents)

    monkeypatch.setattr("nonsmooth.runtime.proof.chaos.certify_chaos.certify_chaos", given)
    monkeypatch.setattr("nonsmooth.runtime.proof.chaos.certify_chaos._BASES", 200)


@pytest.fixture
def empty_reproduction(monkeypatch):
    """A reproduction of the paper that writes one empty file; the whole is a test of its own."""
    from nonsmooth.runtime.present.paper import writing

    def write(out, formulas, begin, *, certified=False):
        begin("report")
        out.mkdir(exist_ok=True)
        (out / "results.json").write_text("{}")
        return (out / "results.json",)

    monkeypatch.setattr(writing, "reproduce", write)
