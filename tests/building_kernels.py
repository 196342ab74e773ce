"""Kernels of a declared system in memory: what a simulation needs of it, without files."""

from __future__ import annotations

from types import ModuleType

from nonsmooth.derive.codegen.any_arithmetic import python_kernel
from nonsmooth.derive.codegen.tables import system_tables
from nonsmooth.derive.declaration import Declaration
from nonsmooth.derive.modal import Spectrum
from nonsmooth.derive.system import System
from nonsmooth.runtime.kernels import SystemKernels


def kernels_of(system: System) -> SystemKernels:
    """Tables and kernels of a system whose modes are found numerically."""
    declaration = Declaration(system, Spectrum(()), None)
    kernels = [(kernel, None) for kernel in declaration.kernels()]
    text = [system_tables(declaration, [], kernels), *(python_kernel(k, None) for k, _ in kernels)]
    module = ModuleType(system.name)
    exec("\n\n".join(text), module.__dict__)
    return SystemKernels(system.name, module, None)
