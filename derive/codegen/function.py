"""What a C function takes and gives, said once: its declaration, header and ufuncs follow."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from textwrap import wrap

from nonsmooth.derive.codegen.any_arithmetic import shape_text
from nonsmooth.derive.codegen.naming import c_function
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import Array, Kernel


@dataclass(frozen=True)
class Function:
    """A C function of one point, or of `many` with their count first.

    One of `many` points takes and gives columns; it is `long` if one point may take as much time
    as thousands of others, and then takes them one by one.
    """

    name: str
    orbit: str | None  # None for a function of the system
    text: str
    inputs: tuple[Array, ...]
    outputs: tuple[Array, ...]
    many: bool = False
    long: bool = False

    @property
    def prototype(self) -> str:
        """C declaration, without the semicolon."""
        if self.many:
            parameters = ["ptrdiff_t count", *(f"const double *{a.name}" for a in self.inputs)]
            parameters += [f"{a.ctype} *{a.name}" for a in self.outputs]
        else:
            some = len(self.outputs) > 1
            parameters = [
                f"const {_declared(a, optional=a.since > 0)}" if a.shape else f"double {a.name}"
                for a in self.inputs
            ]
            parameters += [_declared(a, optional=some) for a in self.outputs]
        return c_declaration(self.name, parameters)


def _declared(array: Array, *, optional: bool) -> str:
    sized = array.shape and array.size and not optional
    return f"double {array.name}[{array.size}]" if sized else f"double *{array.name}"


def c_declaration(name: str, parameters: Iterable[str]) -> str:
    """C declaration of a function without a result, without the semicolon."""
    return "\n".join([f"void {name}(", *listed("", parameters, "", "    ", "    ")]) + ")"


def c_statement(text: str, indent: str) -> list[str]:
    """Lines of a C statement."""
    return wrap(text, 100, initial_indent=indent, subsequent_indent=indent + "    ")


def listed(
    begin: str, entries: Iterable[str], end: str, indent: str = "", following: str = "    "
) -> list[str]:
    """Lines of a list between its begin and its end, broken between entries alone."""
    whole = begin + ", ".join(entry.replace(" ", "\0") for entry in entries) + end
    lines = wrap(
        whole,
        100,
        initial_indent=indent,
        subsequent_indent=following,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace("\0", " ") for line in lines]


def function_of_kernel(kernel: Kernel, system: str, orbit: str | None) -> Function:
    """The C function of a kernel."""
    text = kernel.title
    if kernel.name == "spectrum" and (symbols := kernel.arguments[0].entries):
        text += f" Its `parameters` are {', '.join(map(str, symbols))}, in this order."
    if len(kernel.outputs) > 1:
        text += f" Gives {', '.join(map(shape_text, kernel.outputs))}."
    for late in (a for a in kernel.arguments if a.since):
        text += f" Takes {shape_text(late)} for {kernel.outputs[late.since].name}, else NULL."
    return Function(
        c_function(system, kernel.name, orbit),
        orbit,
        text,
        kernel.arguments,
        tuple(replace(o, since=place) for place, o in enumerate(kernel.outputs)),
    )


def function_of_orbit(
    orbit: EquationSystem,
    name: str,
    text: str,
    inputs: Iterable[Array],
    outputs: Iterable[Array],
    *,
    long: bool = False,
) -> Function:
    """A C function of many points of an orbit; the orbit's parameters are its first argument."""
    parameters = Array("parameters", (len(orbit.parameters),))
    return Function(
        c_function(orbit.system.name, name, orbit.itinerary.name),
        orbit.itinerary.name,
        text,
        (parameters, *inputs),
        tuple(outputs),
        many=True,
        long=long,
    )
