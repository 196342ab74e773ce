"""The extension module: every C function as a NumPy generalized ufunc.

The loops gather a block of points into contiguous rows, or into columns for a function of
many points, call the C function and scatter its results, so that any strides and broadcasts
work. NumPy releases the GIL around them;
between two calls they ask whether they are to end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from string import Template

from nonsmooth.derive.codegen.naming import c_function, module_file
from nonsmooth.derive.equations.equation_system import EquationSystem
from nonsmooth.derive.equations.program import Kernel

__all__ = ["Array", "Wrapped", "extension_source", "wrapped_directions", "wrapped_functions"]


@dataclass(frozen=True)
class Array:
    """Core shape and C type of one argument or result."""

    shape: tuple[int, ...]
    ctype: str = "double"

    @property
    def size(self) -> int:
        """Number of core entries."""
        size = 1
        for extent in self.shape:
            size *= extent
        return size


@dataclass(frozen=True)
class Wrapped:
    """A C function to wrap; one call takes one point, or `many` with their count first.

    An input without entries is left out of the wrapper, since NumPy takes none: C gets
    NULL. A function is `long` if one point may take as much time as thousands of others: it
    gets one point at a time. Other functions of `many` points take and give columns.
    """

    name: str
    inputs: tuple[Array, ...]
    outputs: tuple[Array, ...]
    many: bool = False
    long: bool = False

    @property
    def arrays(self) -> tuple[Array, ...]:
        """Inputs that have entries, then outputs."""
        return (*(a for a in self.inputs if a.size), *self.outputs)

    @property
    def signature(self) -> str:
        """Signature of the generalized ufunc, with the core sizes frozen."""

        def text(arrays: Sequence[Array]) -> str:
            return ",".join(f"({','.join(map(str, a.shape))})" for a in arrays)

        given = len(self.arrays) - len(self.outputs)
        return f"{text(self.arrays[:given])}->{text(self.outputs)}"


def wrapped_functions(system: str, kernels: Sequence[tuple[Kernel, str | None]]) -> list[Wrapped]:
    """Wrappers of the plain kernels of a system."""
    return [
        Wrapped(
            c_function(system, kernel.name, orbit),
            tuple(Array(a.shape) for a in kernel.arguments),
            tuple(Array(o.shape) for o in kernel.outputs),
        )
        for kernel, orbit in kernels
    ]


def wrapped_solvers(orbit: EquationSystem) -> list[Wrapped]:
    """Wrappers of the compiled solver and admissibility test of an orbit."""
    system, name = orbit.system.name, orbit.itinerary.name
    parameters = Array((len(orbit.parameters),))
    unknowns = Array((len(orbit.unknowns),))
    scalar, count = Array(()), Array((), "int32_t")
    # NumPy takes no cores of no entries
    guess, bounds = (
        tuple(Array((len(symbols),)) for symbols in (group,) if symbols)
        for group in (orbit.reduction.unknowns, orbit.open_parameters)
    )
    return [
        Wrapped(
            c_function(system, "solve", name),
            (parameters, *guess),
            (unknowns, scalar, scalar, count, count),
            many=True,
        ),
        Wrapped(
            c_function(system, "admissible", name),
            (parameters, unknowns),
            (*bounds, count, scalar, scalar),
            many=True,
            long=True,
        ),
    ]


def wrapped_directions(orbit: EquationSystem) -> Wrapped:
    """Wrapper of the compiled derivatives of an orbit."""
    parameters, unknowns = len(orbit.parameters), len(orbit.unknowns)
    return Wrapped(
        c_function(orbit.system.name, "directions", orbit.itinerary.name),
        (Array((parameters,)), Array((unknowns,))),
        (Array((unknowns + 1, parameters)),),
        many=True,
    )


_MODULE = Template("""\
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include <string.h>

#include "interrupt.h"
$includes

enum { points = 64 }; /* of a block */

/* Core entries of one argument of one point, in rows, whatever its strides. */
static char *entry(char *base, const npy_intp *strides, int rows, int columns, int index)
{
    (void)rows;
    if (!strides)
        return base;
    return columns ? base + (index / columns) * strides[0] + (index % columns) * strides[1]
                   : base + index * strides[0];
}

#define GATHER(type, to, base, step, strides, size, columns) \\
    for (npy_intp point = 0; point < here; ++point) \\
        for (int i = 0; i < (size); ++i) \\
            (to)[(size) * point + i] = \\
                *(type *)entry((base) + (start + point) * (step), strides, size, columns, i)
#define SCATTER(type, from, base, step, strides, size, columns) \\
    for (npy_intp point = 0; point < here; ++point) \\
        for (int i = 0; i < (size); ++i) \\
            *(type *)entry((base) + (start + point) * (step), strides, size, columns, i) = \\
                (from)[(size) * point + i]

/* The same in columns: entry i of all points of the block side by side. */
#define GATHER_COLUMNS(type, to, base, step, strides, size, columns) \\
    for (int i = 0; i < (size); ++i) { \\
        const char *const from = entry((base) + start * (step), strides, size, columns, i); \\
        if ((step) == sizeof(type)) \\
            memcpy((to) + i * here, from, (size_t)here * sizeof(type)); \\
        else \\
            for (npy_intp point = 0; point < here; ++point) \\
                (to)[i * here + point] = *(const type *)(from + point * (step)); \\
    }
#define SCATTER_COLUMNS(type, from, base, step, strides, size, columns) \\
    for (int i = 0; i < (size); ++i) { \\
        char *const to = entry((base) + start * (step), strides, size, columns, i); \\
        if ((step) == sizeof(type)) \\
            memcpy(to, (from) + i * here, (size_t)here * sizeof(type)); \\
        else \\
            for (npy_intp point = 0; point < here; ++point) \\
                *(type *)(to + point * (step)) = (from)[i * here + point]; \\
    }

$loops

typedef struct {
    const char *name, *signature;
    PyUFuncGenericFunction loop;
    const char *types;
    int inputs, outputs;
} wrapped;

static const wrapped functions[] = {
$table
};
enum { function_count = sizeof functions / sizeof *functions };
static PyUFuncGenericFunction loops[function_count];
static void *data[function_count];

static int add_all(PyObject *module)
{
    import_array1(-1);
    import_umath1(-1);
    for (int i = 0; i < function_count; ++i) {
        const wrapped *const f = &functions[i];
        loops[i] = f->loop;
        PyObject *const ufunc = PyUFunc_FromFuncAndDataAndSignature(
            &loops[i], &data[i], (char *)f->types, 1, f->inputs, f->outputs, PyUFunc_None, f->name,
            NULL, 0, f->signature);
        if (!ufunc || PyModule_AddObject(module, f->name, ufunc) < 0)
            return -1;
    }
$derivations
    return 0;
}

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_kernels", "Compiled kernels.", -1, NULL, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__kernels(void)
{
    PyObject *const module = PyModule_Create(&definition);
    if (module && add_all(module) == 0)
        return module;
    Py_XDECREF(module);
    return NULL;
}
""")


def extension_source(functions: Sequence[Wrapped], derivations: Sequence[tuple[str, str]]) -> str:
    """C source of the extension module for all systems, without a stamp."""
    kinds = {"double": "NPY_DOUBLE", "int32_t": "NPY_INT32"}
    loops, table = [], []
    for function in functions:
        arrays = function.arrays
        types = ", ".join(kinds[a.ctype] for a in arrays)
        loops.append(f"static const char types_{function.name}[] = {{{types}}};\n{_loop(function)}")
        table.append(
            f'    {{"{function.name}", "{function.signature}", loop_{function.name},\n'
            f"     types_{function.name}, {len(arrays) - len(function.outputs)},"
            f" {len(function.outputs)}}},"
        )
    constants = [
        f'    if (PyModule_AddStringConstant(module, "derivation_{module_file(name, "")}",'
        f' "{value}") < 0)\n        return -1;'
        for name, value in derivations
    ]
    return _MODULE.substitute(
        includes="\n".join(f'#include "{module_file(name, ".h")}"' for name, _ in derivations),
        loops="\n\n".join(loops),
        table="\n".join(table),
        derivations="\n".join(constants),
    )


def _loop(function: Wrapped) -> str:
    arrays = function.arrays
    count = len(arrays)
    lines = [
        f"static void loop_{function.name}(",
        "    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)",
        "{",
        "    (void)unused;",
        "    nonsmooth_work work = {0};",
        "    for (npy_intp start = 0; start < dimensions[0]; start += points) {",
        "        const npy_intp left = dimensions[0] - start;",
        "        const npy_intp here = left < points ? left : points;",
        "        if (nonsmooth_ends_later(&work))",
        "            return;",
    ]
    strides, places = count, []
    for array in arrays:
        places.append(f"steps + {strides}" if array.shape else "NULL")
        strides += len(array.shape)
    names = [f"a{i}" for i in range(count)]
    lines += [
        f"        {a.ctype} {n}[points * {a.size}];" for n, a in zip(names, arrays, strict=True)
    ]

    def move(macro: str, index: int) -> str:
        array = arrays[index]
        columns = array.shape[1] if len(array.shape) == 2 else 0
        return (
            f"        {macro}({array.ctype}, {names[index]}, args[{index}], steps[{index}],"
            f" {places[index]}, {array.size}, {columns});"
        )

    inputs = count - len(function.outputs)
    together = function.many and not function.long
    layout = "_COLUMNS" if together else ""
    lines += [move(f"GATHER{layout}", i) for i in range(inputs)]
    if together:
        lines.append(f"        {function.name}(here, {', '.join(names)});")
    else:
        plain = [not a.shape and i < inputs and not function.many for i, a in enumerate(arrays)]
        given = iter(
            f"{'*' if scalar else ''}({n} + {a.size} * point)"
            for n, a, scalar in zip(names, arrays, plain, strict=True)
        )
        passed = ["1"] if function.many else []
        passed += [next(given) if a.size else "NULL" for a in function.inputs]
        passed += given
        lines.append("        for (npy_intp point = 0; point < here; ++point) {")
        if function.long:
            lines += ["            if (nonsmooth_ends_later(&work))", "                return;"]
        lines += [f"            {function.name}({', '.join(passed)});", "        }"]
    lines += [move(f"SCATTER{layout}", i) for i in range(inputs, count)]
    lines += ["    }", "}"]
    return "\n".join(lines)
