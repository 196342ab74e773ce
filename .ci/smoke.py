"""What an installed wheel has to do: the main job and a motion, compiled, and the command line."""

import subprocess
import sys

import nonsmooth as ns
from nonsmooth.runtime import _engine
from nonsmooth.runtime.model.kernels import backend

DATA = dict(chi="0.4", eta=4, V="0.6773", us1="0.0127", ur1="0.0255", us2="0.5", ur2=1)

assert backend() == "c", backend()
orbit = ns.refine(ns.solve("dry-friction/global-stick"), 50)
assert orbit.stability.verdict == "stable"
motion = ns.simulate("dry-friction", DATA, {"x1": 0, "x2": 0, "v1": 0, "v2": 0}, transitions=40)
assert len(motion.times) == 41, motion.times
verify = [sys.executable, "-m", "nonsmooth", "verify", "dry-friction/global-stick"]
told = subprocess.run([*verify, "--digits", "50"], check=True, capture_output=True, text=True)
assert "conditionally stable" in told.stdout, told.stdout
print(ns.__file__, _engine.__file__, f"trace {orbit.trace}", sep="\n")
