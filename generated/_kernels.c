/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop, nonsmooth.derive.systems.elastic_stop, nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 61ee8a31c49812be */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include <stdlib.h>
#include <string.h>

#include "interrupt.h"
#include "rigid_stop.h"
#include "elastic_stop.h"
#include "dry_friction.h"

enum { most_points = 64, most_arrays = 7, on_stack = 4096 };

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
#define EACH_POINT(name, ...)                                                                    static void call_##name(npy_intp count, void *const *a, const array *of)                     {                                                                                                for (npy_intp i = 0; i < count; ++i)                                                             name(__VA_ARGS__);                                                                   }
#define ALL_POINTS(name, ...)                                                                    static void call_##name(npy_intp count, void *const *a, const array *of)                     {                                                                                                (void)of;                                                                                    name(count, __VA_ARGS__);                                                                }
#define FUNCTION(name, layout, inputs, outputs, ...)                                             static const function of_##name = {call_##name, layout, inputs, outputs, {__VA_ARGS__}};

EACH_POINT(rigid_stop_spectrum, ROW(0), ROW(1), ROW(2))
FUNCTION(rigid_stop_spectrum, in_rows, 1, 2, VECTOR(0, 4), VECTOR(0, 7), TABLE(1, 7, 4))
EACH_POINT(rigid_stop_flow_free, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(rigid_stop_flow_free, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 7), SCALAR(0), VECTOR(0, 4),
    VECTOR(0, 4))
EACH_POINT(rigid_stop_flow_contact, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(rigid_stop_flow_contact, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(rigid_stop_fields, ROW(0), ROW(1))
FUNCTION(rigid_stop_fields, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 8, 5))
EACH_POINT(rigid_stop_rows, ROW(0), ROW(1))
FUNCTION(rigid_stop_rows, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 5, 5))
EACH_POINT(rigid_stop_resets, ROW(0), ROW(1))
FUNCTION(rigid_stop_resets, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 12, 5))
EACH_POINT(rigid_stop_modes, ROW(0), ROW(1), ROW(2), ROW(3))
FUNCTION(rigid_stop_modes, in_rows, 2, 2, VECTOR(0, 5), VECTOR(0, 7), TABLE(0, 5, 2),
    TABLE(1, 36, 5))
EACH_POINT(rigid_stop_one_impact_equations, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5), ROW(6))
FUNCTION(rigid_stop_one_impact_equations, in_rows, 4, 3, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 2),
    TABLE(2, 7, 4), VECTOR(0, 2), TABLE(1, 2, 2), TABLE(2, 2, 5))
EACH_POINT(rigid_stop_one_impact_trace, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(rigid_stop_one_impact_trace, in_rows, 4, 2, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 2),
    TABLE(1, 7, 4), SCALAR(0), VECTOR(1, 7))
EACH_POINT(rigid_stop_one_impact_passage, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(rigid_stop_one_impact_passage, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 2),
    TABLE(0, 2, 4), VECTOR(1, 6), VECTOR(2, 2))
EACH_POINT(rigid_stop_one_impact_linearisation, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(rigid_stop_one_impact_linearisation, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7),
    VECTOR(0, 2), TABLE(0, 3, 3), TABLE(1, 4, 4), TABLE(2, 4, 4))
EACH_POINT(rigid_stop_one_impact_reduced, ROW(0), ROW(1), ROW(2), ROW(3))
FUNCTION(rigid_stop_one_impact_reduced, in_rows, 2, 2, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 2),
    VECTOR(1, 1))
ALL_POINTS(rigid_stop_one_impact_solve, a[0], a[1], a[2], a[3], a[4], a[5])
FUNCTION(rigid_stop_one_impact_solve, in_columns, 1, 5, VECTOR(0, 5), VECTOR(0, 2), SCALAR(0),
    SCALAR(0), COUNT(0), COUNT(0))
ALL_POINTS(rigid_stop_one_impact_admissible, a[0], a[1], a[2], a[3], a[4])
FUNCTION(rigid_stop_one_impact_admissible, one_point, 2, 3, VECTOR(0, 5), VECTOR(0, 2), COUNT(0),
    SCALAR(0), SCALAR(0))
ALL_POINTS(rigid_stop_one_impact_directions, a[0], a[1], a[2])
FUNCTION(rigid_stop_one_impact_directions, in_columns, 2, 1, VECTOR(0, 5), VECTOR(0, 2),
    TABLE(0, 3, 5))
EACH_POINT(elastic_stop_spectrum, ROW(0), ROW(1), ROW(2))
FUNCTION(elastic_stop_spectrum, in_rows, 1, 2, VECTOR(0, 5), VECTOR(0, 12), TABLE(1, 12, 5))
EACH_POINT(elastic_stop_flow_contact, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(elastic_stop_flow_contact, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 12), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(elastic_stop_flow_free, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(elastic_stop_flow_free, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 12), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(elastic_stop_fields, ROW(0), ROW(1))
FUNCTION(elastic_stop_fields, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 8, 5))
EACH_POINT(elastic_stop_rows, ROW(0), ROW(1))
FUNCTION(elastic_stop_rows, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 5, 5))
EACH_POINT(elastic_stop_resets, ROW(0), ROW(1))
FUNCTION(elastic_stop_resets, in_rows, 1, 1, VECTOR(0, 5), TABLE(0, 4, 5))
EACH_POINT(elastic_stop_modes, ROW(0), ROW(1), ROW(2), ROW(3))
FUNCTION(elastic_stop_modes, in_rows, 2, 2, VECTOR(0, 5), VECTOR(0, 12), TABLE(0, 6, 2),
    TABLE(1, 40, 5))
EACH_POINT(elastic_stop_one_contact_equations, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5),
    ROW(6))
FUNCTION(elastic_stop_one_contact_equations, in_rows, 4, 3, VECTOR(0, 6), VECTOR(0, 12),
    VECTOR(0, 4), TABLE(2, 12, 5), VECTOR(0, 4), TABLE(1, 4, 4), TABLE(2, 4, 6))
EACH_POINT(elastic_stop_one_contact_trace, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(elastic_stop_one_contact_trace, in_rows, 4, 2, VECTOR(0, 6), VECTOR(0, 12), VECTOR(0, 4),
    TABLE(1, 12, 5), SCALAR(0), VECTOR(1, 10))
EACH_POINT(elastic_stop_one_contact_passage, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(elastic_stop_one_contact_passage, in_rows, 3, 3, VECTOR(0, 6), VECTOR(0, 12), VECTOR(0, 4),
    TABLE(0, 3, 4), VECTOR(1, 12), VECTOR(2, 4))
EACH_POINT(elastic_stop_one_contact_linearisation, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(elastic_stop_one_contact_linearisation, in_rows, 3, 3, VECTOR(0, 6), VECTOR(0, 12),
    VECTOR(0, 4), TABLE(0, 3, 3), TABLE(1, 8, 4), TABLE(2, 4, 4))
EACH_POINT(elastic_stop_one_contact_reduced, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5), ROW(6))
FUNCTION(elastic_stop_one_contact_reduced, in_rows, 3, 4, VECTOR(0, 6), VECTOR(0, 12), VECTOR(0, 1),
    VECTOR(0, 4), VECTOR(1, 1), VECTOR(2, 1), TABLE(3, 1, 1))
ALL_POINTS(elastic_stop_one_contact_solve, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
FUNCTION(elastic_stop_one_contact_solve, in_columns, 2, 5, VECTOR(0, 6), VECTOR(0, 1), VECTOR(0, 4),
    SCALAR(0), SCALAR(0), COUNT(0), COUNT(0))
ALL_POINTS(elastic_stop_one_contact_admissible, a[0], a[1], a[2], a[3], a[4])
FUNCTION(elastic_stop_one_contact_admissible, one_point, 2, 3, VECTOR(0, 6), VECTOR(0, 4), COUNT(0),
    SCALAR(0), SCALAR(0))
ALL_POINTS(elastic_stop_one_contact_directions, a[0], a[1], a[2])
FUNCTION(elastic_stop_one_contact_directions, in_columns, 2, 1, VECTOR(0, 6), VECTOR(0, 4),
    TABLE(0, 5, 6))
EACH_POINT(dry_friction_spectrum, ROW(0), ROW(1), ROW(2))
FUNCTION(dry_friction_spectrum, in_rows, 1, 2, VECTOR(0, 2), VECTOR(0, 7), TABLE(1, 7, 2))
EACH_POINT(dry_friction_flow_slip_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_slip_slip, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_slip_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_slip_stick, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_slip_overshoot, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_slip_overshoot, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_stick_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_stick_slip, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_stick_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_stick_stick, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_stick_overshoot, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_stick_overshoot, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_overshoot_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_overshoot_slip, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_overshoot_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_overshoot_stick, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7), SCALAR(0),
    VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_flow_overshoot_overshoot, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_flow_overshoot_overshoot, in_rows, 4, 1, VECTOR(0, 7), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_fields, ROW(0), ROW(1))
FUNCTION(dry_friction_fields, in_rows, 1, 1, VECTOR(0, 7), TABLE(0, 36, 5))
EACH_POINT(dry_friction_rows, ROW(0), ROW(1))
FUNCTION(dry_friction_rows, in_rows, 1, 1, VECTOR(0, 7), TABLE(0, 17, 5))
EACH_POINT(dry_friction_resets, ROW(0), ROW(1))
FUNCTION(dry_friction_resets, in_rows, 1, 1, VECTOR(0, 7), TABLE(0, 16, 5))
EACH_POINT(dry_friction_modes, ROW(0), ROW(1), ROW(2), ROW(3))
FUNCTION(dry_friction_modes, in_rows, 2, 2, VECTOR(0, 7), VECTOR(0, 7), TABLE(0, 21, 2),
    TABLE(1, 152, 5))
EACH_POINT(dry_friction_symmetric_equations, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5), ROW(6))
FUNCTION(dry_friction_symmetric_equations, in_rows, 4, 3, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 5),
    TABLE(2, 7, 2), VECTOR(0, 5), TABLE(1, 5, 5), TABLE(2, 5, 4))
EACH_POINT(dry_friction_symmetric_trace, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_symmetric_trace, in_rows, 4, 2, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 5),
    TABLE(1, 7, 2), SCALAR(0), VECTOR(1, 9))
EACH_POINT(dry_friction_symmetric_passage, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_symmetric_passage, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 5),
    TABLE(0, 3, 4), VECTOR(1, 24), VECTOR(2, 3))
EACH_POINT(dry_friction_symmetric_linearisation, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_symmetric_linearisation, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7),
    VECTOR(0, 5), TABLE(0, 2, 2), TABLE(1, 8, 4), TABLE(2, 4, 4))
EACH_POINT(dry_friction_symmetric_flow_slip_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_symmetric_flow_slip_slip, in_rows, 4, 1, VECTOR(0, 4), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_symmetric_flow_slip_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_symmetric_flow_slip_stick, in_rows, 4, 1, VECTOR(0, 4), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_symmetric_reduced, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5), ROW(6))
FUNCTION(dry_friction_symmetric_reduced, in_rows, 3, 4, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 2),
    VECTOR(0, 5), VECTOR(1, 1), VECTOR(2, 2), TABLE(3, 2, 2))
EACH_POINT(dry_friction_global_stick_equations, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5),
    ROW(6))
FUNCTION(dry_friction_global_stick_equations, in_rows, 4, 3, VECTOR(0, 5), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(2, 7, 2), VECTOR(0, 6), TABLE(1, 6, 6), TABLE(2, 6, 5))
EACH_POINT(dry_friction_global_stick_trace, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_global_stick_trace, in_rows, 4, 2, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 6),
    TABLE(1, 7, 2), SCALAR(0), VECTOR(1, 11))
EACH_POINT(dry_friction_global_stick_passage, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_global_stick_passage, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 6),
    TABLE(0, 5, 4), VECTOR(1, 44), VECTOR(2, 4))
EACH_POINT(dry_friction_global_stick_linearisation, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_global_stick_linearisation, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(0, 2, 2), TABLE(1, 16, 4), TABLE(2, 4, 4))
EACH_POINT(dry_friction_global_stick_flow_slip_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_global_stick_flow_slip_stick, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_global_stick_flow_slip_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_global_stick_flow_slip_slip, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_global_stick_flow_stick_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_global_stick_flow_stick_slip, in_rows, 4, 1, VECTOR(0, 5), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_global_stick_reduced, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_global_stick_reduced, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7), VECTOR(0, 2),
    VECTOR(0, 6), VECTOR(1, 2), TABLE(2, 2, 2))
EACH_POINT(dry_friction_global_stick_period_map, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_global_stick_period_map, in_rows, 3, 3, VECTOR(0, 5), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(0, 4, 5), VECTOR(1, 2), VECTOR(2, 4))
EACH_POINT(dry_friction_solution_ii_equations, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5),
    ROW(6))
FUNCTION(dry_friction_solution_ii_equations, in_rows, 4, 3, VECTOR(0, 4), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(2, 7, 2), VECTOR(0, 6), TABLE(1, 6, 6), TABLE(2, 6, 4))
EACH_POINT(dry_friction_solution_ii_trace, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_solution_ii_trace, in_rows, 4, 2, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 6),
    TABLE(1, 7, 2), SCALAR(0), VECTOR(1, 10))
EACH_POINT(dry_friction_solution_ii_passage, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_solution_ii_passage, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 6),
    TABLE(0, 5, 4), VECTOR(1, 44), VECTOR(2, 4))
EACH_POINT(dry_friction_solution_ii_linearisation, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_solution_ii_linearisation, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(0, 2, 2), TABLE(1, 16, 4), TABLE(2, 4, 4))
EACH_POINT(dry_friction_solution_ii_flow_slip_stick, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_solution_ii_flow_slip_stick, in_rows, 4, 1, VECTOR(0, 4), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_solution_ii_flow_slip_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_solution_ii_flow_slip_slip, in_rows, 4, 1, VECTOR(0, 4), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_solution_ii_flow_stick_slip, ROW(0), ROW(1), *ROW(2), ROW(3), ROW(4))
FUNCTION(dry_friction_solution_ii_flow_stick_slip, in_rows, 4, 1, VECTOR(0, 4), VECTOR(0, 7),
    SCALAR(0), VECTOR(0, 4), VECTOR(0, 4))
EACH_POINT(dry_friction_solution_ii_reduced, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_solution_ii_reduced, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7), VECTOR(0, 3),
    VECTOR(0, 6), VECTOR(1, 3), TABLE(2, 3, 3))
EACH_POINT(dry_friction_solution_ii_period_map, ROW(0), ROW(1), ROW(2), ROW(3), ROW(4), ROW(5))
FUNCTION(dry_friction_solution_ii_period_map, in_rows, 3, 3, VECTOR(0, 4), VECTOR(0, 7),
    VECTOR(0, 6), TABLE(0, 4, 5), VECTOR(1, 2), VECTOR(2, 4))
ALL_POINTS(dry_friction_symmetric_solve, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
FUNCTION(dry_friction_symmetric_solve, in_columns, 2, 5, VECTOR(0, 4), VECTOR(0, 2), VECTOR(0, 5),
    SCALAR(0), SCALAR(0), COUNT(0), COUNT(0))
ALL_POINTS(dry_friction_symmetric_admissible, a[0], a[1], a[2], a[3], a[4], a[5])
FUNCTION(dry_friction_symmetric_admissible, one_point, 2, 4, VECTOR(0, 4), VECTOR(0, 5),
    VECTOR(0, 1), COUNT(0), SCALAR(0), SCALAR(0))
ALL_POINTS(dry_friction_symmetric_directions, a[0], a[1], a[2])
FUNCTION(dry_friction_symmetric_directions, in_columns, 2, 1, VECTOR(0, 4), VECTOR(0, 5),
    TABLE(0, 6, 4))
ALL_POINTS(dry_friction_global_stick_solve, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
FUNCTION(dry_friction_global_stick_solve, in_columns, 2, 5, VECTOR(0, 5), VECTOR(0, 2),
    VECTOR(0, 6), SCALAR(0), SCALAR(0), COUNT(0), COUNT(0))
ALL_POINTS(dry_friction_global_stick_admissible, a[0], a[1], a[2], a[3], a[4], a[5])
FUNCTION(dry_friction_global_stick_admissible, one_point, 2, 4, VECTOR(0, 5), VECTOR(0, 6),
    VECTOR(0, 2), COUNT(0), SCALAR(0), SCALAR(0))
ALL_POINTS(dry_friction_global_stick_directions, a[0], a[1], a[2])
FUNCTION(dry_friction_global_stick_directions, in_columns, 2, 1, VECTOR(0, 5), VECTOR(0, 6),
    TABLE(0, 7, 5))
ALL_POINTS(dry_friction_solution_ii_solve, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
FUNCTION(dry_friction_solution_ii_solve, in_columns, 2, 5, VECTOR(0, 4), VECTOR(0, 3), VECTOR(0, 6),
    SCALAR(0), SCALAR(0), COUNT(0), COUNT(0))
ALL_POINTS(dry_friction_solution_ii_admissible, a[0], a[1], a[2], a[3], a[4], a[5])
FUNCTION(dry_friction_solution_ii_admissible, one_point, 2, 4, VECTOR(0, 4), VECTOR(0, 6),
    VECTOR(0, 2), COUNT(0), SCALAR(0), SCALAR(0))

static const wrapped ufuncs[] = {
    {"rigid_stop_spectrum_1", &of_rigid_stop_spectrum, 1, "(4)->(7)"},
    {"rigid_stop_spectrum_2", &of_rigid_stop_spectrum, 2, "(4)->(7),(7,4)"},
    {"rigid_stop_flow_free_1", &of_rigid_stop_flow_free, 1, "(5),(7),(),(4)->(4)"},
    {"rigid_stop_flow_contact_1", &of_rigid_stop_flow_contact, 1, "(5),(7),(),(4)->(4)"},
    {"rigid_stop_fields_1", &of_rigid_stop_fields, 1, "(5)->(8,5)"},
    {"rigid_stop_rows_1", &of_rigid_stop_rows, 1, "(5)->(5,5)"},
    {"rigid_stop_resets_1", &of_rigid_stop_resets, 1, "(5)->(12,5)"},
    {"rigid_stop_modes_1", &of_rigid_stop_modes, 1, "(5),(7)->(5,2)"},
    {"rigid_stop_modes_2", &of_rigid_stop_modes, 2, "(5),(7)->(5,2),(36,5)"},
    {"rigid_stop_one_impact_equations_1", &of_rigid_stop_one_impact_equations, 1, "(5),(7),(2)->(2)"},
    {"rigid_stop_one_impact_equations_2", &of_rigid_stop_one_impact_equations, 2, "(5),(7),(2)->(2),(2,2)"},
    {"rigid_stop_one_impact_equations_3", &of_rigid_stop_one_impact_equations, 3, "(5),(7),(2),(7,4)->(2),(2,2),(2,5)"},
    {"rigid_stop_one_impact_trace_1", &of_rigid_stop_one_impact_trace, 1, "(5),(7),(2)->()"},
    {"rigid_stop_one_impact_trace_2", &of_rigid_stop_one_impact_trace, 2, "(5),(7),(2),(7,4)->(),(7)"},
    {"rigid_stop_one_impact_passage_1", &of_rigid_stop_one_impact_passage, 1, "(5),(7),(2)->(2,4)"},
    {"rigid_stop_one_impact_passage_2", &of_rigid_stop_one_impact_passage, 2, "(5),(7),(2)->(2,4),(6)"},
    {"rigid_stop_one_impact_passage_3", &of_rigid_stop_one_impact_passage, 3, "(5),(7),(2)->(2,4),(6),(2)"},
    {"rigid_stop_one_impact_linearisation_1", &of_rigid_stop_one_impact_linearisation, 1, "(5),(7),(2)->(3,3)"},
    {"rigid_stop_one_impact_linearisation_2", &of_rigid_stop_one_impact_linearisation, 2, "(5),(7),(2)->(3,3),(4,4)"},
    {"rigid_stop_one_impact_linearisation_3", &of_rigid_stop_one_impact_linearisation, 3, "(5),(7),(2)->(3,3),(4,4),(4,4)"},
    {"rigid_stop_one_impact_reduced_1", &of_rigid_stop_one_impact_reduced, 1, "(5),(7)->(2)"},
    {"rigid_stop_one_impact_reduced_2", &of_rigid_stop_one_impact_reduced, 2, "(5),(7)->(2),(1)"},
    {"rigid_stop_one_impact_solve", &of_rigid_stop_one_impact_solve, 1, "(5)->(2),(),(),(),()"},
    {"rigid_stop_one_impact_admissible", &of_rigid_stop_one_impact_admissible, 1, "(5),(2)->(),(),()"},
    {"rigid_stop_one_impact_directions", &of_rigid_stop_one_impact_directions, 1, "(5),(2)->(3,5)"},
    {"elastic_stop_spectrum_1", &of_elastic_stop_spectrum, 1, "(5)->(12)"},
    {"elastic_stop_spectrum_2", &of_elastic_stop_spectrum, 2, "(5)->(12),(12,5)"},
    {"elastic_stop_flow_contact_1", &of_elastic_stop_flow_contact, 1, "(5),(12),(),(4)->(4)"},
    {"elastic_stop_flow_free_1", &of_elastic_stop_flow_free, 1, "(5),(12),(),(4)->(4)"},
    {"elastic_stop_fields_1", &of_elastic_stop_fields, 1, "(5)->(8,5)"},
    {"elastic_stop_rows_1", &of_elastic_stop_rows, 1, "(5)->(5,5)"},
    {"elastic_stop_resets_1", &of_elastic_stop_resets, 1, "(5)->(4,5)"},
    {"elastic_stop_modes_1", &of_elastic_stop_modes, 1, "(5),(12)->(6,2)"},
    {"elastic_stop_modes_2", &of_elastic_stop_modes, 2, "(5),(12)->(6,2),(40,5)"},
    {"elastic_stop_one_contact_equations_1", &of_elastic_stop_one_contact_equations, 1, "(6),(12),(4)->(4)"},
    {"elastic_stop_one_contact_equations_2", &of_elastic_stop_one_contact_equations, 2, "(6),(12),(4)->(4),(4,4)"},
    {"elastic_stop_one_contact_equations_3", &of_elastic_stop_one_contact_equations, 3, "(6),(12),(4),(12,5)->(4),(4,4),(4,6)"},
    {"elastic_stop_one_contact_trace_1", &of_elastic_stop_one_contact_trace, 1, "(6),(12),(4)->()"},
    {"elastic_stop_one_contact_trace_2", &of_elastic_stop_one_contact_trace, 2, "(6),(12),(4),(12,5)->(),(10)"},
    {"elastic_stop_one_contact_passage_1", &of_elastic_stop_one_contact_passage, 1, "(6),(12),(4)->(3,4)"},
    {"elastic_stop_one_contact_passage_2", &of_elastic_stop_one_contact_passage, 2, "(6),(12),(4)->(3,4),(12)"},
    {"elastic_stop_one_contact_passage_3", &of_elastic_stop_one_contact_passage, 3, "(6),(12),(4)->(3,4),(12),(4)"},
    {"elastic_stop_one_contact_linearisation_1", &of_elastic_stop_one_contact_linearisation, 1, "(6),(12),(4)->(3,3)"},
    {"elastic_stop_one_contact_linearisation_2", &of_elastic_stop_one_contact_linearisation, 2, "(6),(12),(4)->(3,3),(8,4)"},
    {"elastic_stop_one_contact_linearisation_3", &of_elastic_stop_one_contact_linearisation, 3, "(6),(12),(4)->(3,3),(8,4),(4,4)"},
    {"elastic_stop_one_contact_reduced_1", &of_elastic_stop_one_contact_reduced, 1, "(6),(12),(1)->(4)"},
    {"elastic_stop_one_contact_reduced_2", &of_elastic_stop_one_contact_reduced, 2, "(6),(12),(1)->(4),(1)"},
    {"elastic_stop_one_contact_reduced_3", &of_elastic_stop_one_contact_reduced, 3, "(6),(12),(1)->(4),(1),(1)"},
    {"elastic_stop_one_contact_reduced_4", &of_elastic_stop_one_contact_reduced, 4, "(6),(12),(1)->(4),(1),(1),(1,1)"},
    {"elastic_stop_one_contact_solve", &of_elastic_stop_one_contact_solve, 1, "(6),(1)->(4),(),(),(),()"},
    {"elastic_stop_one_contact_admissible", &of_elastic_stop_one_contact_admissible, 1, "(6),(4)->(),(),()"},
    {"elastic_stop_one_contact_directions", &of_elastic_stop_one_contact_directions, 1, "(6),(4)->(5,6)"},
    {"dry_friction_spectrum_1", &of_dry_friction_spectrum, 1, "(2)->(7)"},
    {"dry_friction_spectrum_2", &of_dry_friction_spectrum, 2, "(2)->(7),(7,2)"},
    {"dry_friction_flow_slip_slip_1", &of_dry_friction_flow_slip_slip, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_slip_stick_1", &of_dry_friction_flow_slip_stick, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_slip_overshoot_1", &of_dry_friction_flow_slip_overshoot, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_stick_slip_1", &of_dry_friction_flow_stick_slip, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_stick_stick_1", &of_dry_friction_flow_stick_stick, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_stick_overshoot_1", &of_dry_friction_flow_stick_overshoot, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_overshoot_slip_1", &of_dry_friction_flow_overshoot_slip, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_overshoot_stick_1", &of_dry_friction_flow_overshoot_stick, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_flow_overshoot_overshoot_1", &of_dry_friction_flow_overshoot_overshoot, 1, "(7),(7),(),(4)->(4)"},
    {"dry_friction_fields_1", &of_dry_friction_fields, 1, "(7)->(36,5)"},
    {"dry_friction_rows_1", &of_dry_friction_rows, 1, "(7)->(17,5)"},
    {"dry_friction_resets_1", &of_dry_friction_resets, 1, "(7)->(16,5)"},
    {"dry_friction_modes_1", &of_dry_friction_modes, 1, "(7),(7)->(21,2)"},
    {"dry_friction_modes_2", &of_dry_friction_modes, 2, "(7),(7)->(21,2),(152,5)"},
    {"dry_friction_symmetric_equations_1", &of_dry_friction_symmetric_equations, 1, "(4),(7),(5)->(5)"},
    {"dry_friction_symmetric_equations_2", &of_dry_friction_symmetric_equations, 2, "(4),(7),(5)->(5),(5,5)"},
    {"dry_friction_symmetric_equations_3", &of_dry_friction_symmetric_equations, 3, "(4),(7),(5),(7,2)->(5),(5,5),(5,4)"},
    {"dry_friction_symmetric_trace_1", &of_dry_friction_symmetric_trace, 1, "(4),(7),(5)->()"},
    {"dry_friction_symmetric_trace_2", &of_dry_friction_symmetric_trace, 2, "(4),(7),(5),(7,2)->(),(9)"},
    {"dry_friction_symmetric_passage_1", &of_dry_friction_symmetric_passage, 1, "(4),(7),(5)->(3,4)"},
    {"dry_friction_symmetric_passage_2", &of_dry_friction_symmetric_passage, 2, "(4),(7),(5)->(3,4),(24)"},
    {"dry_friction_symmetric_passage_3", &of_dry_friction_symmetric_passage, 3, "(4),(7),(5)->(3,4),(24),(3)"},
    {"dry_friction_symmetric_linearisation_1", &of_dry_friction_symmetric_linearisation, 1, "(4),(7),(5)->(2,2)"},
    {"dry_friction_symmetric_linearisation_2", &of_dry_friction_symmetric_linearisation, 2, "(4),(7),(5)->(2,2),(8,4)"},
    {"dry_friction_symmetric_linearisation_3", &of_dry_friction_symmetric_linearisation, 3, "(4),(7),(5)->(2,2),(8,4),(4,4)"},
    {"dry_friction_symmetric_flow_slip_slip_1", &of_dry_friction_symmetric_flow_slip_slip, 1, "(4),(7),(),(4)->(4)"},
    {"dry_friction_symmetric_flow_slip_stick_1", &of_dry_friction_symmetric_flow_slip_stick, 1, "(4),(7),(),(4)->(4)"},
    {"dry_friction_symmetric_reduced_1", &of_dry_friction_symmetric_reduced, 1, "(4),(7),(2)->(5)"},
    {"dry_friction_symmetric_reduced_2", &of_dry_friction_symmetric_reduced, 2, "(4),(7),(2)->(5),(1)"},
    {"dry_friction_symmetric_reduced_3", &of_dry_friction_symmetric_reduced, 3, "(4),(7),(2)->(5),(1),(2)"},
    {"dry_friction_symmetric_reduced_4", &of_dry_friction_symmetric_reduced, 4, "(4),(7),(2)->(5),(1),(2),(2,2)"},
    {"dry_friction_global_stick_equations_1", &of_dry_friction_global_stick_equations, 1, "(5),(7),(6)->(6)"},
    {"dry_friction_global_stick_equations_2", &of_dry_friction_global_stick_equations, 2, "(5),(7),(6)->(6),(6,6)"},
    {"dry_friction_global_stick_equations_3", &of_dry_friction_global_stick_equations, 3, "(5),(7),(6),(7,2)->(6),(6,6),(6,5)"},
    {"dry_friction_global_stick_trace_1", &of_dry_friction_global_stick_trace, 1, "(5),(7),(6)->()"},
    {"dry_friction_global_stick_trace_2", &of_dry_friction_global_stick_trace, 2, "(5),(7),(6),(7,2)->(),(11)"},
    {"dry_friction_global_stick_passage_1", &of_dry_friction_global_stick_passage, 1, "(5),(7),(6)->(5,4)"},
    {"dry_friction_global_stick_passage_2", &of_dry_friction_global_stick_passage, 2, "(5),(7),(6)->(5,4),(44)"},
    {"dry_friction_global_stick_passage_3", &of_dry_friction_global_stick_passage, 3, "(5),(7),(6)->(5,4),(44),(4)"},
    {"dry_friction_global_stick_linearisation_1", &of_dry_friction_global_stick_linearisation, 1, "(5),(7),(6)->(2,2)"},
    {"dry_friction_global_stick_linearisation_2", &of_dry_friction_global_stick_linearisation, 2, "(5),(7),(6)->(2,2),(16,4)"},
    {"dry_friction_global_stick_linearisation_3", &of_dry_friction_global_stick_linearisation, 3, "(5),(7),(6)->(2,2),(16,4),(4,4)"},
    {"dry_friction_global_stick_flow_slip_stick_1", &of_dry_friction_global_stick_flow_slip_stick, 1, "(5),(7),(),(4)->(4)"},
    {"dry_friction_global_stick_flow_slip_slip_1", &of_dry_friction_global_stick_flow_slip_slip, 1, "(5),(7),(),(4)->(4)"},
    {"dry_friction_global_stick_flow_stick_slip_1", &of_dry_friction_global_stick_flow_stick_slip, 1, "(5),(7),(),(4)->(4)"},
    {"dry_friction_global_stick_reduced_1", &of_dry_friction_global_stick_reduced, 1, "(5),(7),(2)->(6)"},
    {"dry_friction_global_stick_reduced_2", &of_dry_friction_global_stick_reduced, 2, "(5),(7),(2)->(6),(2)"},
    {"dry_friction_global_stick_reduced_3", &of_dry_friction_global_stick_reduced, 3, "(5),(7),(2)->(6),(2),(2,2)"},
    {"dry_friction_global_stick_period_map_1", &of_dry_friction_global_stick_period_map, 1, "(5),(7),(6)->(4,5)"},
    {"dry_friction_global_stick_period_map_2", &of_dry_friction_global_stick_period_map, 2, "(5),(7),(6)->(4,5),(2)"},
    {"dry_friction_global_stick_period_map_3", &of_dry_friction_global_stick_period_map, 3, "(5),(7),(6)->(4,5),(2),(4)"},
    {"dry_friction_solution_ii_equations_1", &of_dry_friction_solution_ii_equations, 1, "(4),(7),(6)->(6)"},
    {"dry_friction_solution_ii_equations_2", &of_dry_friction_solution_ii_equations, 2, "(4),(7),(6)->(6),(6,6)"},
    {"dry_friction_solution_ii_equations_3", &of_dry_friction_solution_ii_equations, 3, "(4),(7),(6),(7,2)->(6),(6,6),(6,4)"},
    {"dry_friction_solution_ii_trace_1", &of_dry_friction_solution_ii_trace, 1, "(4),(7),(6)->()"},
    {"dry_friction_solution_ii_trace_2", &of_dry_friction_solution_ii_trace, 2, "(4),(7),(6),(7,2)->(),(10)"},
    {"dry_friction_solution_ii_passage_1", &of_dry_friction_solution_ii_passage, 1, "(4),(7),(6)->(5,4)"},
    {"dry_friction_solution_ii_passage_2", &of_dry_friction_solution_ii_passage, 2, "(4),(7),(6)->(5,4),(44)"},
    {"dry_friction_solution_ii_passage_3", &of_dry_friction_solution_ii_passage, 3, "(4),(7),(6)->(5,4),(44),(4)"},
    {"dry_friction_solution_ii_linearisation_1", &of_dry_friction_solution_ii_linearisation, 1, "(4),(7),(6)->(2,2)"},
    {"dry_friction_solution_ii_linearisation_2", &of_dry_friction_solution_ii_linearisation, 2, "(4),(7),(6)->(2,2),(16,4)"},
    {"dry_friction_solution_ii_linearisation_3", &of_dry_friction_solution_ii_linearisation, 3, "(4),(7),(6)->(2,2),(16,4),(4,4)"},
    {"dry_friction_solution_ii_flow_slip_stick_1", &of_dry_friction_solution_ii_flow_slip_stick, 1, "(4),(7),(),(4)->(4)"},
    {"dry_friction_solution_ii_flow_slip_slip_1", &of_dry_friction_solution_ii_flow_slip_slip, 1, "(4),(7),(),(4)->(4)"},
    {"dry_friction_solution_ii_flow_stick_slip_1", &of_dry_friction_solution_ii_flow_stick_slip, 1, "(4),(7),(),(4)->(4)"},
    {"dry_friction_solution_ii_reduced_1", &of_dry_friction_solution_ii_reduced, 1, "(4),(7),(3)->(6)"},
    {"dry_friction_solution_ii_reduced_2", &of_dry_friction_solution_ii_reduced, 2, "(4),(7),(3)->(6),(3)"},
    {"dry_friction_solution_ii_reduced_3", &of_dry_friction_solution_ii_reduced, 3, "(4),(7),(3)->(6),(3),(3,3)"},
    {"dry_friction_solution_ii_period_map_1", &of_dry_friction_solution_ii_period_map, 1, "(4),(7),(6)->(4,5)"},
    {"dry_friction_solution_ii_period_map_2", &of_dry_friction_solution_ii_period_map, 2, "(4),(7),(6)->(4,5),(2)"},
    {"dry_friction_solution_ii_period_map_3", &of_dry_friction_solution_ii_period_map, 3, "(4),(7),(6)->(4,5),(2),(4)"},
    {"dry_friction_symmetric_solve", &of_dry_friction_symmetric_solve, 1, "(4),(2)->(5),(),(),(),()"},
    {"dry_friction_symmetric_admissible", &of_dry_friction_symmetric_admissible, 1, "(4),(5)->(1),(),(),()"},
    {"dry_friction_symmetric_directions", &of_dry_friction_symmetric_directions, 1, "(4),(5)->(6,4)"},
    {"dry_friction_global_stick_solve", &of_dry_friction_global_stick_solve, 1, "(5),(2)->(6),(),(),(),()"},
    {"dry_friction_global_stick_admissible", &of_dry_friction_global_stick_admissible, 1, "(5),(6)->(2),(),(),()"},
    {"dry_friction_global_stick_directions", &of_dry_friction_global_stick_directions, 1, "(5),(6)->(7,5)"},
    {"dry_friction_solution_ii_solve", &of_dry_friction_solution_ii_solve, 1, "(4),(3)->(6),(),(),(),()"},
    {"dry_friction_solution_ii_admissible", &of_dry_friction_solution_ii_admissible, 1, "(4),(6)->(2),(),(),()"},
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
    if (PyModule_AddStringConstant(module, "derivation_rigid_stop", "e0db5a0cf84061ce") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_elastic_stop", "34270e2de36ca60b") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_dry_friction", "a9cad82ee1ca7804") < 0)
        return -1;
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
