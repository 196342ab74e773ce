"""Files of results that many tests look at, made once in a run, whichever process asks first."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import quote

FOLDER = "NONSMOOTH_SHARED_BY_TESTS"  # set by conftest.py, for all processes of a run


def shared_file(name: str, make: Callable[[], Any]) -> Path:
    """The file of a result by its name, to be read; `make` gives a result that can be saved."""
    folder = Path(os.environ[FOLDER])
    path = folder / f"{quote(name, safe='')}.json"
    with open(path.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not path.exists():
            make().save(path)
            path.chmod(0o444)
    return path
