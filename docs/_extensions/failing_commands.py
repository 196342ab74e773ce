"""A command of a page that fails makes the build fail, with what it said on stderr."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any

__all__ = ["setup"]

_STARTUP = """\
def checked(shell):
    import tempfile
    run = shell.system

    def system(command):
        with tempfile.NamedTemporaryFile("r") as said:
            run(f"{{ {command}\\n}} 2>{said.name}")
            if shell.user_ns["_exit_code"]:
                raise RuntimeError(f"{command}: exit code {shell.user_ns['_exit_code']}:"
                                   f" {said.read()}")

    shell.system = system


checked(get_ipython())
del checked
"""


def setup(app: Any) -> dict[str, bool]:
    """Let the kernels that execute pages begin with the check."""
    folder = tempfile.TemporaryDirectory()
    startup = Path(folder.name, "profile_default", "startup")
    startup.mkdir(parents=True)
    (startup / "failing_commands.py").write_text(_STARTUP, encoding="utf-8")
    os.environ["IPYTHONDIR"] = folder.name
    app.connect("build-finished", lambda *_: folder.cleanup())
    return {"parallel_read_safe": True, "parallel_write_safe": True}
