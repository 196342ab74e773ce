"""The extension module: every C function as a NumPy generalized ufunc.

One loop serves all: it gathers a block of points into contiguous rows, or into columns for a
function of many points, calls the C function and scatters its results, so that any strides and
broadcasts work. NumPy releases the GIL around it; between two blocks it asks whether it is to end.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from string import Template
from typing import NamedTuple

from nonsmooth.derive.codegen.function import Function, listed
from nonsmooth.derive.codegen.naming import module_file
from nonsmooth.derive.equations.program import Array

_MOST_ENTRIES = 4096  # of one point: a block of 64 takes 2 MB at most, on the stack up to 32 kB


class Wrapped(NamedTuple):
    """A ufunc that gives the first outputs of a C function.

    In place of an array whose `since` is not below `wanted`, or that has no entries, C gets NULL,
    and the ufunc takes and gives none.
    """

    name: str
    function: Function
    wanted: int

    def used(self, arrays: Iterable[Array]) -> list[Array]:
        """Those of the C function's arrays that the ufunc takes or gives."""
        return [a for a in arrays if a.since < self.wanted and a.size > 0]

    @property
    def signature(self) -> str:
        """Signature of the generalized ufunc, with the core sizes frozen."""
        taken, given = (
            ",".join(f"({','.join(map(str, a.shape))})" for a in self.used(arrays))
            for arrays in (self.function.inputs, self.function.outputs)
        )
        return f"{taken}->{given}"


def wrapped(function: Function) -> list[Wrapped]:
    """The ufuncs of a C function that NumPy can take.

    Of a function of one point the one whose name ends in n gives the first n outputs. There are
    entries on both sides, and not too many of them.
    """
    found = [Wrapped(function.name, function, 1)]
    if not function.many:
        counts = range(1, len(function.outputs) + 1)
        found = [Wrapped(f"{function.name}_{n}", function, n) for n in counts]
    sides = ((each, each.used(function.inputs), each.used(function.outputs)) for each in found)
    return [
        each
        for each, taken, given in sides
        if taken and given and sum(a.size for a in (*taken, *given)) <= _MOST_ENTRIES
    ]


_MODULE = Template("""\
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
$includes

enum { most_points = 64, most_arrays = $most, on_stack = 4096 };

/* What NumPy is to do with an output: its own flags but NPY_ITER_OVERLAP_ASSUME_ELEMENTWISE, for a
 * point may be written before it is read as part of another. So memory that is shared with an input
 * is copied. */
enum {
    of_output = NPY_ITER_WRITEONLY | NPY_ITER_UPDATEIFCOPY | NPY_ITER_ALIGNED | NPY_ITER_ALLOCATE |
                NPY_ITER_NO_BROADCAST | NPY_ITER_NO_SUBTYPE
};

/* Order of the entries of a block: points one after the other, or columns of all points. */
enum layout { in_rows, in_columns, one_point };

/* Core of an argument or result: the first output that needs it, entries of a point, columns of a
 * table, axes. */
typedef struct {
    int since, size, columns, axes, type;
} array;
#define SCALAR(since) {since, 1, 0, 0, NPY_DOUBLE}
#define COUNT(since) {since, 1, 0, 0, NPY_INT32}
#define VECTOR(since, entries) {since, entries, 0, 1, NPY_DOUBLE}
#define TABLE(since, rows, columns) {since, (rows) * (columns), columns, 2, NPY_DOUBLE}

/* A C function, with what calls it for a block of points. */
typedef struct {
    void (*call)(npy_intp count, void *const *a, const array *of);
    enum layout layout;
    int inputs, outputs;
    array arrays[most_arrays];
} function;

/* A ufunc: it gives the `wanted` first outputs, and takes what these need. */
typedef struct {
    const char *name;
    const function *of;
    int wanted;
    const char *signature;
} wrapped;

/* The arrays of a ufunc: their places among those of the C function, and how many are inputs. */
typedef struct {
    const wrapped *ufunc;
    int inputs, count;
    int places[most_arrays];
} used;

/* Where an argument lies in NumPy's arrays, and in a block. */
typedef struct {
    char *base, *block;
    npy_intp step;
    const npy_intp *strides;
    int bytes; /* of an entry */
} located;

/* Place of a core entry of the first point, whatever its strides are. */
static char *entry_of(const array *a, const located *l, int index)
{
    if (a->axes == 0)
        return l->base;
    return a->axes == 1 ? l->base + index * l->strides[0]
                        : l->base + (index / a->columns) * l->strides[0] +
                              (index % a->columns) * l->strides[1];
}

/* Whether the entries of all points lie as in a block of rows. */
static int lies_in_rows(const array *a, const located *l)
{
    const npy_intp inner = a->axes == 0 ? l->bytes : l->strides[a->axes - 1];
    return inner == l->bytes && l->step == a->size * l->bytes &&
           (a->axes < 2 || l->strides[0] == a->columns * l->bytes);
}

static void copy(char *to, npy_intp to_step, const char *from, npy_intp from_step, npy_intp count,
                 int bytes)
{
    if (to_step == bytes && from_step == bytes)
        memcpy(to, from, (size_t)(count * bytes));
    else
        for (npy_intp i = 0; i < count; ++i)
            if (bytes == 8)
                memcpy(to + i * to_step, from + i * from_step, 8);
            else
                memcpy(to + i * to_step, from + i * from_step, (size_t)bytes);
}

/* Move `count` points between NumPy's array and the block: into it, or out of it. */
static void move(const array *a, const located *l, npy_intp count, enum layout layout, int into)
{
    if (l->block == l->base)
        return;
    const npy_intp next = layout == in_columns ? count : 1;
    const npy_intp step = layout == in_columns ? l->bytes : a->size * l->bytes;
    for (int i = 0; i < a->size; ++i) {
        char *const entry = entry_of(a, l, i), *const inside = l->block + i * next * l->bytes;
        if (into)
            copy(inside, step, entry, l->step, count, l->bytes);
        else
            copy(entry, l->step, inside, step, count, l->bytes);
    }
}

static void out_of_memory(void)
{
    const PyGILState_STATE lock = PyGILState_Ensure();
    PyErr_NoMemory();
    PyGILState_Release(lock);
}

/* The loop of every function; NumPy hands it over as `data`. */
static void loop(char **args, npy_intp const *dimensions, npy_intp const *steps, void *data)
{
    const used *const u = data;
    const function *const f = u->ufunc->of;
    const int count = u->count;
    const npy_intp most = f->layout == one_point ? 1 : most_points;
    const npy_intp points = dimensions[0] < most ? dimensions[0] : most;
    located at[most_arrays];
    void *blocks[most_arrays] = {NULL};
    double stack[on_stack];
    size_t total = 0;
    const array *arrays[most_arrays];
    for (int k = 0, axes = 0; k < count; axes += arrays[k++]->axes) {
        arrays[k] = &f->arrays[u->places[k]];
        const int bytes = arrays[k]->type == NPY_INT32 ? 4 : 8;
        at[k] = (located){args[k], NULL, steps[k], steps + count + axes, bytes};
        total += (size_t)(points * arrays[k]->size);
    }
    double *const memory = total <= on_stack ? stack : malloc(total * sizeof(double));
    if (!memory) {
        out_of_memory();
        return;
    }
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start, here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            break;
        double *rest = memory;
        for (int k = 0; k < count; ++k) {
            at[k].base = args[k] + start * steps[k];
            const int direct = f->layout == in_rows && lies_in_rows(arrays[k], &at[k]);
            at[k].block = direct ? at[k].base : (char *)rest;
            blocks[u->places[k]] = at[k].block;
            rest += points * arrays[k]->size;
        }
        for (int k = 0; k < u->inputs; ++k)
            move(arrays[k], &at[k], here, f->layout, 1);
        f->call(here, blocks, f->arrays);
        for (int k = u->inputs; k < count; ++k)
            move(arrays[k], &at[k], here, f->layout, 0);
    }
    if (memory != stack)
        free(memory);
}

/* Row of a point in a block; NULL where there is no block, as it is not wanted. */
static inline double *row(void *block, npy_intp point, int size)
{
    return block ? (double *)block + size * point : NULL;
}
#define ROW(place) row(a[place], i, of[place].size)

/* Callers of a function of one point, and of one of many. */
#define EACH_POINT(name, ...)                                                                \
    static void call_##name(npy_intp count, void *const *a, const array *of)                 \
    {                                                                                        \
        for (npy_intp i = 0; i < count; ++i)                                                 \
            name(__VA_ARGS__);                                                               \
    }
#define ALL_POINTS(name, ...)                                                                \
    static void call_##name(npy_intp count, void *const *a, const array *of)                 \
    {                                                                                        \
        (void)of;                                                                            \
        name(count, __VA_ARGS__);                                                            \
    }
#define FUNCTION(name, layout, inputs, outputs, ...)                                         \
    static const function of_##name = {call_##name, layout, inputs, outputs, {__VA_ARGS__}};

$functions

static const wrapped ufuncs[] = {
$table
};
enum { ufunc_count = sizeof ufuncs / sizeof *ufuncs };
static PyUFuncGenericFunction loops[ufunc_count];
static used uses[ufunc_count];
static void *data[ufunc_count];
static char types[ufunc_count][most_arrays];

static int add_all(PyObject *module)
{
    import_array1(-1);
    import_umath1(-1);
    for (int i = 0; i < ufunc_count; ++i) {
        const wrapped *const ufunc = &ufuncs[i];
        const function *const f = ufunc->of;
        used *const u = &uses[i];
        u->ufunc = ufunc;
        for (int place = 0; place < f->inputs + f->outputs; ++place)
            if (f->arrays[place].since < ufunc->wanted && f->arrays[place].size > 0) {
                types[i][u->count] = (char)f->arrays[place].type;
                u->places[u->count++] = place;
                u->inputs += place < f->inputs;
            }
        loops[i] = loop;
        data[i] = u;
        PyObject *const made = PyUFunc_FromFuncAndDataAndSignature(
            &loops[i], &data[i], types[i], 1, u->inputs, u->count - u->inputs, PyUFunc_None,
            ufunc->name, NULL, 0, ufunc->signature);
        if (!made || PyModule_AddObject(module, ufunc->name, made) < 0)
            return -1;
        for (int k = u->inputs; k < u->count; ++k)
            ((PyUFuncObject *)made)->op_flags[k] = of_output;
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


def extension_source(ufuncs: Sequence[Wrapped], derivations: Sequence[tuple[str, str]]) -> str:
    """C source of the extension module for all systems, without a stamp."""
    functions = dict.fromkeys(ufunc.function for ufunc in ufuncs)
    table = [
        f'    {{"{u.name}", &of_{u.function.name}, {u.wanted}, "{u.signature}"}},' for u in ufuncs
    ]
    constants = [
        f'    if (PyModule_AddStringConstant(module, "derivation_{module_file(name, "")}",'
        f' "{value}") < 0)\n        return -1;'
        for name, value in derivations
    ]
    return _MODULE.substitute(
        includes="\n".join(f'#include "{module_file(name, ".h")}"' for name, _ in derivations),
        most=max((len(f.inputs) + len(f.outputs) for f in functions), default=1),
        functions="\n".join(map(_function, functions)),
        table="\n".join(table),
        derivations="\n".join(constants),
    )


def _function(function: Function) -> str:
    """The lines of a C function: what calls it for a block of points, and its arrays."""
    arrays, inputs = (*function.inputs, *function.outputs), len(function.inputs)
    layout = "in_rows" if not function.many else "one_point" if function.long else "in_columns"
    caller = "ALL_POINTS" if function.many else "EACH_POINT"
    passed = [
        f"a[{place}]"
        if function.many
        else f"{'' if array.shape or place >= inputs else '*'}ROW({place})"
        for place, array in enumerate(arrays)
    ]
    sizes = [str(inputs), str(len(function.outputs)), *map(_array, arrays)]
    return "\n".join(
        [
            *listed(f"{caller}(", [function.name, *passed], ")"),
            *listed("FUNCTION(", [function.name, layout, *sizes], ")"),
        ]
    )


def _array(array: Array) -> str:
    kind = "COUNT" if array.ctype == "int32_t" else ("SCALAR", "VECTOR", "TABLE")[len(array.shape)]
    return f"{kind}({', '.join(map(str, (array.since, *array.shape)))})"
