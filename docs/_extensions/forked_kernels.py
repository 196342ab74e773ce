"""The kernels that execute pages are forked from one process, which has imported what they need."""

from __future__ import annotations

import json
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from importlib import import_module
from pathlib import Path
from typing import Any

__all__ = ["setup"]

_SPECIFICATION = {"language": "python", "display_name": "Python 3", "interrupt_mode": "message"}
_IMPORTED = ("ipykernel.kernelapp", "matplotlib.pyplot", "matplotlib_inline.backend_inline")


def _ask(address: str, *arguments: str) -> None:
    """Stand for a kernel: have it forked, and end when it ends."""
    with socket.socket(socket.AF_UNIX) as kernel:
        kernel.connect(address)
        wanted = json.dumps([arguments, os.getcwd(), dict(os.environ)]).encode()
        kernel.sendall(len(wanted).to_bytes(4, "big") + wanted)
        kernel.recv(1)


def _received(request: socket.socket, length: int) -> bytes:
    """As many bytes as are asked for."""
    data = b""
    while len(data) < length:
        part = request.recv(length - len(data))
        if not part:
            raise EOFError("whoever asked for a kernel is gone")
        data += part
    return data


def _become_kernel(request: socket.socket) -> None:
    """Run the kernel that is asked for, until it is shut down or nobody asks any more."""
    from ipykernel.kernelapp import IPKernelApp

    wanted = _received(request, int.from_bytes(_received(request, 4), "big"))
    arguments, folder, environment = json.loads(wanted)
    os.chdir(folder)
    os.environ.clear()
    os.environ.update(environment)
    threading.Thread(target=lambda: request.recv(1) or os._exit(1), daemon=True).start()
    parent = f"--IPKernelApp.parent_handle={os.getppid()}"  # a kernel ends with its parent
    IPKernelApp.launch_instance(argv=[*arguments, parent])


def _serve(listening: int) -> None:
    """Import what pages need, and fork a kernel for each that asks, until the build has ended."""
    for name in _IMPORTED:
        import_module(name)
    import nonsmooth
    import nonsmooth.derive

    assert nonsmooth.solve, nonsmooth.derive.oscillator  # names are imported when they are used
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for those that have ended
    with socket.socket(fileno=listening) as server:
        # its standard input is a pipe whose other end goes with the build, however that ends
        while sys.stdin not in select.select([server, sys.stdin], [], [])[0]:
            request, _ = server.accept()
            with request:
                if os.fork() == 0:
                    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                    server.close()
                    _become_kernel(request)
                    os._exit(0)


def setup(app: Any) -> dict[str, bool]:
    """Have the kernels of this build forked."""
    if not hasattr(os, "fork"):
        return {"parallel_read_safe": True, "parallel_write_safe": True}
    folder = tempfile.TemporaryDirectory()
    specification = Path(folder.name, "kernels", "python3", "kernel.json")
    specification.parent.mkdir(parents=True)
    address = f"{folder.name}/socket"
    argv = [sys.executable, "-S", __file__, address, "-f", "{connection_file}"]
    specification.write_text(json.dumps({**_SPECIFICATION, "argv": argv}), encoding="utf-8")
    others = [path for path in (os.environ.get("JUPYTER_PATH"),) if path]
    os.environ["JUPYTER_PATH"] = os.pathsep.join([folder.name, *others])
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(address)
        listening.listen()
        number = listening.fileno()
        server = subprocess.Popen(
            [sys.executable, __file__, str(number)], stdin=subprocess.PIPE, pass_fds=[number]
        )

    def finish(*_: object) -> None:
        server.communicate()
        folder.cleanup()

    app.connect("build-finished", finish)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    _ask(*sys.argv[1:]) if sys.argv[2:] else _serve(int(sys.argv[1]))
