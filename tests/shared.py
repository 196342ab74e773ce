"""Results that many tests look at, made once in a run, whichever process asks first."""

import fcntl
import os
import pickle
from pathlib import Path
from urllib.parse import quote

FOLDER = "NONSMOOTH_SHARED_BY_TESTS"  # set by conftest.py, for all processes of a run


def shared_file(name, make):
    """The file of a result by its name, to be read; `make` gives a result that can be saved."""
    return _written(f"{quote(name, safe='')}.json", lambda path: make().save(path))


def shared_value(name, make):
    """A copy of a value by its name; `make` gives one that can be pickled."""

    def write(path):
        path.write_bytes(pickle.dumps(make()))

    return pickle.loads(_written(f"{quote(name, safe='')}.pickle", write).read_bytes())


def _written(name, write):
    """A file of the run's folder, written by the first that asks."""
    path = Path(os.environ[FOLDER]) / name
    with open(path.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not path.exists():
            write(path)
            path.chmod(0o444)
    return path
