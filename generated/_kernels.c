/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop, nonsmooth.derive.systems.elastic_stop, nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 06750a9e5aabab6d */
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

/* Core of one argument: its place among those of the C function, entries of a point, axes, columns
 * of a table. */
typedef struct {
    int place, size, axes, columns, type;
} array;

typedef struct {
    const char *name, *signature;
    void (*call)(npy_intp count, void *const *blocks);
    enum layout layout;
    int inputs, outputs;
    array arrays[most_arrays];
} wrapped;

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
    const wrapped *const f = data;
    const int count = f->inputs + f->outputs;
    const npy_intp most = f->layout == one_point ? 1 : most_points;
    const npy_intp points = dimensions[0] < most ? dimensions[0] : most;
    located at[most_arrays];
    void *blocks[most_arrays] = {NULL};
    double stack[on_stack];
    size_t total = 0;
    for (int k = 0, axes = 0; k < count; axes += f->arrays[k++].axes) {
        const int bytes = f->arrays[k].type == NPY_INT32 ? 4 : 8;
        at[k] = (located){args[k], NULL, steps[k], steps + count + axes, bytes};
        total += (size_t)(points * f->arrays[k].size);
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
            const int direct = f->layout == in_rows && lies_in_rows(&f->arrays[k], &at[k]);
            at[k].block = direct ? at[k].base : (char *)rest;
            blocks[f->arrays[k].place] = at[k].block;
            rest += points * f->arrays[k].size;
        }
        for (int k = 0; k < f->inputs; ++k)
            move(&f->arrays[k], &at[k], here, f->layout, 1);
        f->call(here, blocks);
        for (int k = f->inputs; k < count; ++k)
            move(&f->arrays[k], &at[k], here, f->layout, 0);
    }
    if (memory != stack)
        free(memory);
}

/* Row of a point in a block. */
static inline double *row(void *block, npy_intp point, int size)
{
    return (double *)block + size * point;
}

/* The same, or NULL in place of a block that is not wanted. */
static inline double *row_if_wanted(void *block, npy_intp point, int size)
{
    return block ? row(block, point, size) : NULL;
}

static void call_rigid_stop_spectrum(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_spectrum(row(a[0], i, 4), row(a[1], i, 7), row_if_wanted(a[2], i, 28));
}

static void call_rigid_stop_flow_free(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_flow_free(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_rigid_stop_flow_contact(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_flow_contact(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_rigid_stop_fields(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_fields(row(a[0], i, 5), row(a[1], i, 40));
}

static void call_rigid_stop_rows(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_rows(row(a[0], i, 5), row(a[1], i, 25));
}

static void call_rigid_stop_resets(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_resets(row(a[0], i, 5), row(a[1], i, 60));
}

static void call_rigid_stop_modes(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_modes(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 10), row_if_wanted(a[3], i, 180));
}

static void call_rigid_stop_one_impact_equations(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_equations(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row_if_wanted(a[3], i, 28), row(a[4], i, 2), row_if_wanted(a[5], i, 4), row_if_wanted(a[6], i, 10));
}

static void call_rigid_stop_one_impact_trace(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_trace(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row_if_wanted(a[3], i, 28), row(a[4], i, 1), row_if_wanted(a[5], i, 7));
}

static void call_rigid_stop_one_impact_passage(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_passage(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row(a[3], i, 8), row_if_wanted(a[4], i, 6), row_if_wanted(a[5], i, 2));
}

static void call_rigid_stop_one_impact_linearisation(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_linearisation(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row(a[3], i, 9), row_if_wanted(a[4], i, 16), row_if_wanted(a[5], i, 16));
}

static void call_rigid_stop_one_impact_flow_free(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_flow_free(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_rigid_stop_one_impact_reduced(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        rigid_stop_one_impact_reduced(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row_if_wanted(a[3], i, 1));
}

static void call_rigid_stop_one_impact_solve(npy_intp count, void *const *a)
{
    rigid_stop_one_impact_solve(count, a[0], a[1], a[2], a[3], a[4], a[5]);
}

static void call_rigid_stop_one_impact_admissible(npy_intp count, void *const *a)
{
    rigid_stop_one_impact_admissible(count, a[0], a[1], a[2], a[3], a[4]);
}

static void call_rigid_stop_one_impact_directions(npy_intp count, void *const *a)
{
    rigid_stop_one_impact_directions(count, a[0], a[1], a[2]);
}

static void call_elastic_stop_spectrum(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_spectrum(row(a[0], i, 5), row(a[1], i, 12), row_if_wanted(a[2], i, 60));
}

static void call_elastic_stop_flow_contact(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_flow_contact(row(a[0], i, 5), row(a[1], i, 12), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_elastic_stop_flow_free(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_flow_free(row(a[0], i, 5), row(a[1], i, 12), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_elastic_stop_fields(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_fields(row(a[0], i, 5), row(a[1], i, 40));
}

static void call_elastic_stop_rows(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_rows(row(a[0], i, 5), row(a[1], i, 25));
}

static void call_elastic_stop_resets(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_resets(row(a[0], i, 5), row(a[1], i, 20));
}

static void call_elastic_stop_modes(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_modes(row(a[0], i, 5), row(a[1], i, 12), row(a[2], i, 12), row_if_wanted(a[3], i, 200));
}

static void call_elastic_stop_one_contact_equations(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_equations(row(a[0], i, 6), row(a[1], i, 12), row(a[2], i, 4), row_if_wanted(a[3], i, 60), row(a[4], i, 4), row_if_wanted(a[5], i, 16), row_if_wanted(a[6], i, 24));
}

static void call_elastic_stop_one_contact_trace(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_trace(row(a[0], i, 6), row(a[1], i, 12), row(a[2], i, 4), row_if_wanted(a[3], i, 60), row(a[4], i, 1), row_if_wanted(a[5], i, 10));
}

static void call_elastic_stop_one_contact_passage(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_passage(row(a[0], i, 6), row(a[1], i, 12), row(a[2], i, 4), row(a[3], i, 12), row_if_wanted(a[4], i, 12), row_if_wanted(a[5], i, 4));
}

static void call_elastic_stop_one_contact_linearisation(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_linearisation(row(a[0], i, 6), row(a[1], i, 12), row(a[2], i, 4), row(a[3], i, 9), row_if_wanted(a[4], i, 32), row_if_wanted(a[5], i, 16));
}

static void call_elastic_stop_one_contact_flow_contact(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_flow_contact(row(a[0], i, 6), row(a[1], i, 12), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_elastic_stop_one_contact_flow_free(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_flow_free(row(a[0], i, 6), row(a[1], i, 12), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_elastic_stop_one_contact_reduced(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        elastic_stop_one_contact_reduced(row(a[0], i, 6), row(a[1], i, 12), row(a[2], i, 1), row(a[3], i, 4), row_if_wanted(a[4], i, 1), row_if_wanted(a[5], i, 1), row_if_wanted(a[6], i, 1));
}

static void call_elastic_stop_one_contact_solve(npy_intp count, void *const *a)
{
    elastic_stop_one_contact_solve(count, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
}

static void call_elastic_stop_one_contact_admissible(npy_intp count, void *const *a)
{
    elastic_stop_one_contact_admissible(count, a[0], a[1], a[2], a[3], a[4]);
}

static void call_elastic_stop_one_contact_directions(npy_intp count, void *const *a)
{
    elastic_stop_one_contact_directions(count, a[0], a[1], a[2]);
}

static void call_dry_friction_spectrum(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_spectrum(row(a[0], i, 2), row(a[1], i, 7), row_if_wanted(a[2], i, 14));
}

static void call_dry_friction_flow_slip_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_slip_slip(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_slip_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_slip_stick(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_slip_overshoot(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_slip_overshoot(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_stick_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_stick_slip(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_stick_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_stick_stick(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_stick_overshoot(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_stick_overshoot(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_overshoot_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_overshoot_slip(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_overshoot_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_overshoot_stick(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_flow_overshoot_overshoot(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_flow_overshoot_overshoot(row(a[0], i, 7), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_fields(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_fields(row(a[0], i, 7), row(a[1], i, 180));
}

static void call_dry_friction_rows(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_rows(row(a[0], i, 7), row(a[1], i, 85));
}

static void call_dry_friction_resets(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_resets(row(a[0], i, 7), row(a[1], i, 80));
}

static void call_dry_friction_modes(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_modes(row(a[0], i, 7), row(a[1], i, 7), row(a[2], i, 42), row_if_wanted(a[3], i, 760));
}

static void call_dry_friction_symmetric_equations(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_equations(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 5), row_if_wanted(a[3], i, 14), row(a[4], i, 5), row_if_wanted(a[5], i, 25), row_if_wanted(a[6], i, 20));
}

static void call_dry_friction_symmetric_trace(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_trace(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 5), row_if_wanted(a[3], i, 14), row(a[4], i, 1), row_if_wanted(a[5], i, 9));
}

static void call_dry_friction_symmetric_passage(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_passage(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 5), row(a[3], i, 12), row_if_wanted(a[4], i, 24), row_if_wanted(a[5], i, 3));
}

static void call_dry_friction_symmetric_linearisation(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_linearisation(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 5), row(a[3], i, 4), row_if_wanted(a[4], i, 32), row_if_wanted(a[5], i, 16));
}

static void call_dry_friction_symmetric_flow_slip_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_flow_slip_slip(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_symmetric_flow_slip_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_flow_slip_stick(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_symmetric_reduced(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_symmetric_reduced(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 2), row(a[3], i, 5), row_if_wanted(a[4], i, 1), row_if_wanted(a[5], i, 2), row_if_wanted(a[6], i, 4));
}

static void call_dry_friction_global_stick_equations(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_equations(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 6), row_if_wanted(a[3], i, 14), row(a[4], i, 6), row_if_wanted(a[5], i, 36), row_if_wanted(a[6], i, 30));
}

static void call_dry_friction_global_stick_trace(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_trace(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 6), row_if_wanted(a[3], i, 14), row(a[4], i, 1), row_if_wanted(a[5], i, 11));
}

static void call_dry_friction_global_stick_passage(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_passage(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 20), row_if_wanted(a[4], i, 44), row_if_wanted(a[5], i, 4));
}

static void call_dry_friction_global_stick_linearisation(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_linearisation(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 4), row_if_wanted(a[4], i, 64), row_if_wanted(a[5], i, 16));
}

static void call_dry_friction_global_stick_flow_stick_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_flow_stick_stick(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_global_stick_flow_slip_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_flow_slip_stick(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_global_stick_flow_slip_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_flow_slip_slip(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_global_stick_flow_stick_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_flow_stick_slip(row(a[0], i, 5), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_global_stick_reduced(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_reduced(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 2), row(a[3], i, 6), row_if_wanted(a[4], i, 2), row_if_wanted(a[5], i, 4));
}

static void call_dry_friction_global_stick_period_map(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_global_stick_period_map(row(a[0], i, 5), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 20), row_if_wanted(a[4], i, 2), row_if_wanted(a[5], i, 4));
}

static void call_dry_friction_solution_ii_equations(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_equations(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 6), row_if_wanted(a[3], i, 14), row(a[4], i, 6), row_if_wanted(a[5], i, 36), row_if_wanted(a[6], i, 24));
}

static void call_dry_friction_solution_ii_trace(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_trace(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 6), row_if_wanted(a[3], i, 14), row(a[4], i, 1), row_if_wanted(a[5], i, 10));
}

static void call_dry_friction_solution_ii_passage(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_passage(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 20), row_if_wanted(a[4], i, 44), row_if_wanted(a[5], i, 4));
}

static void call_dry_friction_solution_ii_linearisation(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_linearisation(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 4), row_if_wanted(a[4], i, 64), row_if_wanted(a[5], i, 16));
}

static void call_dry_friction_solution_ii_flow_stick_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_flow_stick_stick(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_solution_ii_flow_slip_stick(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_flow_slip_stick(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_solution_ii_flow_slip_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_flow_slip_slip(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_solution_ii_flow_stick_slip(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_flow_stick_slip(row(a[0], i, 4), row(a[1], i, 7), *row(a[2], i, 1), row(a[3], i, 4), row(a[4], i, 4));
}

static void call_dry_friction_solution_ii_reduced(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_reduced(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 3), row(a[3], i, 6), row_if_wanted(a[4], i, 3), row_if_wanted(a[5], i, 9));
}

static void call_dry_friction_solution_ii_period_map(npy_intp count, void *const *a)
{
    for (npy_intp i = 0; i < count; ++i)
        dry_friction_solution_ii_period_map(row(a[0], i, 4), row(a[1], i, 7), row(a[2], i, 6), row(a[3], i, 20), row_if_wanted(a[4], i, 2), row_if_wanted(a[5], i, 4));
}

static void call_dry_friction_symmetric_solve(npy_intp count, void *const *a)
{
    dry_friction_symmetric_solve(count, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
}

static void call_dry_friction_symmetric_admissible(npy_intp count, void *const *a)
{
    dry_friction_symmetric_admissible(count, a[0], a[1], a[2], a[3], a[4], a[5]);
}

static void call_dry_friction_symmetric_directions(npy_intp count, void *const *a)
{
    dry_friction_symmetric_directions(count, a[0], a[1], a[2]);
}

static void call_dry_friction_global_stick_solve(npy_intp count, void *const *a)
{
    dry_friction_global_stick_solve(count, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
}

static void call_dry_friction_global_stick_admissible(npy_intp count, void *const *a)
{
    dry_friction_global_stick_admissible(count, a[0], a[1], a[2], a[3], a[4], a[5]);
}

static void call_dry_friction_global_stick_directions(npy_intp count, void *const *a)
{
    dry_friction_global_stick_directions(count, a[0], a[1], a[2]);
}

static void call_dry_friction_solution_ii_solve(npy_intp count, void *const *a)
{
    dry_friction_solution_ii_solve(count, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
}

static void call_dry_friction_solution_ii_admissible(npy_intp count, void *const *a)
{
    dry_friction_solution_ii_admissible(count, a[0], a[1], a[2], a[3], a[4], a[5]);
}

static const wrapped functions[] = {
    {"rigid_stop_spectrum_1", "(4)->(7)",
     call_rigid_stop_spectrum, in_rows, 1, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_spectrum_2", "(4)->(7),(7,4)",
     call_rigid_stop_spectrum, in_rows, 1, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 28, 2, 4, NPY_DOUBLE}}},
    {"rigid_stop_flow_free_1", "(5),(7),(),(4)->(4)",
     call_rigid_stop_flow_free, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_flow_contact_1", "(5),(7),(),(4)->(4)",
     call_rigid_stop_flow_contact, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_fields_1", "(5)->(8,5)",
     call_rigid_stop_fields, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 40, 2, 5, NPY_DOUBLE}}},
    {"rigid_stop_rows_1", "(5)->(5,5)",
     call_rigid_stop_rows, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 25, 2, 5, NPY_DOUBLE}}},
    {"rigid_stop_resets_1", "(5)->(12,5)",
     call_rigid_stop_resets, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 60, 2, 5, NPY_DOUBLE}}},
    {"rigid_stop_modes_1", "(5),(7)->(5,2)",
     call_rigid_stop_modes, in_rows, 2, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 10, 2, 2, NPY_DOUBLE}}},
    {"rigid_stop_modes_2", "(5),(7)->(5,2),(36,5)",
     call_rigid_stop_modes, in_rows, 2, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 10, 2, 2, NPY_DOUBLE}, {3, 180, 2, 5, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_equations_1", "(5),(7),(2)->(2)",
     call_rigid_stop_one_impact_equations, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_equations_2", "(5),(7),(2)->(2),(2,2)",
     call_rigid_stop_one_impact_equations, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}, {5, 4, 2, 2, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_equations_3", "(5),(7),(2),(7,4)->(2),(2,2),(2,5)",
     call_rigid_stop_one_impact_equations, in_rows, 4, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 28, 2, 4, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}, {5, 4, 2, 2, NPY_DOUBLE}, {6, 10, 2, 5, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_trace_1", "(5),(7),(2)->()",
     call_rigid_stop_one_impact_trace, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_trace_2", "(5),(7),(2),(7,4)->(),(7)",
     call_rigid_stop_one_impact_trace, in_rows, 4, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 28, 2, 4, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 7, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_passage_1", "(5),(7),(2)->(2,4)",
     call_rigid_stop_one_impact_passage, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 8, 2, 4, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_passage_2", "(5),(7),(2)->(2,4),(6)",
     call_rigid_stop_one_impact_passage, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 8, 2, 4, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_passage_3", "(5),(7),(2)->(2,4),(6),(2)",
     call_rigid_stop_one_impact_passage, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 8, 2, 4, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}, {5, 2, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_linearisation_1", "(5),(7),(2)->(3,3)",
     call_rigid_stop_one_impact_linearisation, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_linearisation_2", "(5),(7),(2)->(3,3),(4,4)",
     call_rigid_stop_one_impact_linearisation, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}, {4, 16, 2, 4, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_linearisation_3", "(5),(7),(2)->(3,3),(4,4),(4,4)",
     call_rigid_stop_one_impact_linearisation, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}, {4, 16, 2, 4, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_flow_free_1", "(5),(7),(),(4)->(4)",
     call_rigid_stop_one_impact_flow_free, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_reduced_1", "(5),(7)->(2)",
     call_rigid_stop_one_impact_reduced, in_rows, 2, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_reduced_2", "(5),(7)->(2),(1)",
     call_rigid_stop_one_impact_reduced, in_rows, 2, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 1, 1, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_solve", "(5)->(2),(),(),(),()",
     call_rigid_stop_one_impact_solve, in_columns, 1, 5,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 2, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_INT32}, {5, 1, 0, 0, NPY_INT32}}},
    {"rigid_stop_one_impact_admissible", "(5),(2)->(),(),()",
     call_rigid_stop_one_impact_admissible, one_point, 2, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 2, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_INT32}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"rigid_stop_one_impact_directions", "(5),(2)->(3,5)",
     call_rigid_stop_one_impact_directions, in_columns, 2, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 2, 1, 0, NPY_DOUBLE}, {2, 15, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_spectrum_1", "(5)->(12)",
     call_elastic_stop_spectrum, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_spectrum_2", "(5)->(12),(12,5)",
     call_elastic_stop_spectrum, in_rows, 1, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 60, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_flow_contact_1", "(5),(12),(),(4)->(4)",
     call_elastic_stop_flow_contact, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_flow_free_1", "(5),(12),(),(4)->(4)",
     call_elastic_stop_flow_free, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_fields_1", "(5)->(8,5)",
     call_elastic_stop_fields, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 40, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_rows_1", "(5)->(5,5)",
     call_elastic_stop_rows, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 25, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_resets_1", "(5)->(4,5)",
     call_elastic_stop_resets, in_rows, 1, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 20, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_modes_1", "(5),(12)->(6,2)",
     call_elastic_stop_modes, in_rows, 2, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 12, 2, 2, NPY_DOUBLE}}},
    {"elastic_stop_modes_2", "(5),(12)->(6,2),(40,5)",
     call_elastic_stop_modes, in_rows, 2, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 12, 2, 2, NPY_DOUBLE}, {3, 200, 2, 5, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_equations_1", "(6),(12),(4)->(4)",
     call_elastic_stop_one_contact_equations, in_rows, 3, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_equations_2", "(6),(12),(4)->(4),(4,4)",
     call_elastic_stop_one_contact_equations, in_rows, 3, 2,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_equations_3", "(6),(12),(4),(12,5)->(4),(4,4),(4,6)",
     call_elastic_stop_one_contact_equations, in_rows, 4, 3,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 60, 2, 5, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}, {6, 24, 2, 6, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_trace_1", "(6),(12),(4)->()",
     call_elastic_stop_one_contact_trace, in_rows, 3, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_trace_2", "(6),(12),(4),(12,5)->(),(10)",
     call_elastic_stop_one_contact_trace, in_rows, 4, 2,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 60, 2, 5, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 10, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_passage_1", "(6),(12),(4)->(3,4)",
     call_elastic_stop_one_contact_passage, in_rows, 3, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_passage_2", "(6),(12),(4)->(3,4),(12)",
     call_elastic_stop_one_contact_passage, in_rows, 3, 2,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}, {4, 12, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_passage_3", "(6),(12),(4)->(3,4),(12),(4)",
     call_elastic_stop_one_contact_passage, in_rows, 3, 3,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}, {4, 12, 1, 0, NPY_DOUBLE}, {5, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_linearisation_1", "(6),(12),(4)->(3,3)",
     call_elastic_stop_one_contact_linearisation, in_rows, 3, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_linearisation_2", "(6),(12),(4)->(3,3),(8,4)",
     call_elastic_stop_one_contact_linearisation, in_rows, 3, 2,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}, {4, 32, 2, 4, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_linearisation_3", "(6),(12),(4)->(3,3),(8,4),(4,4)",
     call_elastic_stop_one_contact_linearisation, in_rows, 3, 3,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 9, 2, 3, NPY_DOUBLE}, {4, 32, 2, 4, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_flow_contact_1", "(6),(12),(),(4)->(4)",
     call_elastic_stop_one_contact_flow_contact, in_rows, 4, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_flow_free_1", "(6),(12),(),(4)->(4)",
     call_elastic_stop_one_contact_flow_free, in_rows, 4, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_reduced_1", "(6),(12),(1)->(4)",
     call_elastic_stop_one_contact_reduced, in_rows, 3, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 1, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_reduced_2", "(6),(12),(1)->(4),(1)",
     call_elastic_stop_one_contact_reduced, in_rows, 3, 2,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 1, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_reduced_3", "(6),(12),(1)->(4),(1),(1)",
     call_elastic_stop_one_contact_reduced, in_rows, 3, 3,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 1, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}, {5, 1, 1, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_reduced_4", "(6),(12),(1)->(4),(1),(1),(1,1)",
     call_elastic_stop_one_contact_reduced, in_rows, 3, 4,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 12, 1, 0, NPY_DOUBLE}, {2, 1, 1, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}, {5, 1, 1, 0, NPY_DOUBLE}, {6, 1, 2, 1, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_solve", "(6),(1)->(4),(),(),(),()",
     call_elastic_stop_one_contact_solve, in_columns, 2, 5,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 1, 1, 0, NPY_DOUBLE}, {2, 4, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_INT32}, {6, 1, 0, 0, NPY_INT32}}},
    {"elastic_stop_one_contact_admissible", "(6),(4)->(),(),()",
     call_elastic_stop_one_contact_admissible, one_point, 2, 3,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 4, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_INT32}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"elastic_stop_one_contact_directions", "(6),(4)->(5,6)",
     call_elastic_stop_one_contact_directions, in_columns, 2, 1,
     {{0, 6, 1, 0, NPY_DOUBLE}, {1, 4, 1, 0, NPY_DOUBLE}, {2, 30, 2, 6, NPY_DOUBLE}}},
    {"dry_friction_spectrum_1", "(2)->(7)",
     call_dry_friction_spectrum, in_rows, 1, 1,
     {{0, 2, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_spectrum_2", "(2)->(7),(7,2)",
     call_dry_friction_spectrum, in_rows, 1, 2,
     {{0, 2, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 14, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_flow_slip_slip_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_slip_slip, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_slip_stick_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_slip_stick, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_slip_overshoot_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_slip_overshoot, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_stick_slip_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_stick_slip, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_stick_stick_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_stick_stick, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_stick_overshoot_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_stick_overshoot, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_overshoot_slip_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_overshoot_slip, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_overshoot_stick_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_overshoot_stick, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_flow_overshoot_overshoot_1", "(7),(7),(),(4)->(4)",
     call_dry_friction_flow_overshoot_overshoot, in_rows, 4, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_fields_1", "(7)->(36,5)",
     call_dry_friction_fields, in_rows, 1, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 180, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_rows_1", "(7)->(17,5)",
     call_dry_friction_rows, in_rows, 1, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 85, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_resets_1", "(7)->(16,5)",
     call_dry_friction_resets, in_rows, 1, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 80, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_modes_1", "(7),(7)->(21,2)",
     call_dry_friction_modes, in_rows, 2, 1,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 42, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_modes_2", "(7),(7)->(21,2),(152,5)",
     call_dry_friction_modes, in_rows, 2, 2,
     {{0, 7, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 42, 2, 2, NPY_DOUBLE}, {3, 760, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_symmetric_equations_1", "(4),(7),(5)->(5)",
     call_dry_friction_symmetric_equations, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {4, 5, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_equations_2", "(4),(7),(5)->(5),(5,5)",
     call_dry_friction_symmetric_equations, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {4, 5, 1, 0, NPY_DOUBLE}, {5, 25, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_symmetric_equations_3", "(4),(7),(5),(7,2)->(5),(5,5),(5,4)",
     call_dry_friction_symmetric_equations, in_rows, 4, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 5, 1, 0, NPY_DOUBLE}, {5, 25, 2, 5, NPY_DOUBLE}, {6, 20, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_symmetric_trace_1", "(4),(7),(5)->()",
     call_dry_friction_symmetric_trace, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_trace_2", "(4),(7),(5),(7,2)->(),(9)",
     call_dry_friction_symmetric_trace, in_rows, 4, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 9, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_passage_1", "(4),(7),(5)->(3,4)",
     call_dry_friction_symmetric_passage, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_symmetric_passage_2", "(4),(7),(5)->(3,4),(24)",
     call_dry_friction_symmetric_passage, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}, {4, 24, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_passage_3", "(4),(7),(5)->(3,4),(24),(3)",
     call_dry_friction_symmetric_passage, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 12, 2, 4, NPY_DOUBLE}, {4, 24, 1, 0, NPY_DOUBLE}, {5, 3, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_linearisation_1", "(4),(7),(5)->(2,2)",
     call_dry_friction_symmetric_linearisation, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_symmetric_linearisation_2", "(4),(7),(5)->(2,2),(8,4)",
     call_dry_friction_symmetric_linearisation, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 32, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_symmetric_linearisation_3", "(4),(7),(5)->(2,2),(8,4),(4,4)",
     call_dry_friction_symmetric_linearisation, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 32, 2, 4, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_symmetric_flow_slip_slip_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_symmetric_flow_slip_slip, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_flow_slip_stick_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_symmetric_flow_slip_stick, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_reduced_1", "(4),(7),(2)->(5)",
     call_dry_friction_symmetric_reduced, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 5, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_reduced_2", "(4),(7),(2)->(5),(1)",
     call_dry_friction_symmetric_reduced, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 5, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_reduced_3", "(4),(7),(2)->(5),(1),(2)",
     call_dry_friction_symmetric_reduced, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 5, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}, {5, 2, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_reduced_4", "(4),(7),(2)->(5),(1),(2),(2,2)",
     call_dry_friction_symmetric_reduced, in_rows, 3, 4,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 5, 1, 0, NPY_DOUBLE}, {4, 1, 1, 0, NPY_DOUBLE}, {5, 2, 1, 0, NPY_DOUBLE}, {6, 4, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_global_stick_equations_1", "(5),(7),(6)->(6)",
     call_dry_friction_global_stick_equations, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_equations_2", "(5),(7),(6)->(6),(6,6)",
     call_dry_friction_global_stick_equations, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}, {5, 36, 2, 6, NPY_DOUBLE}}},
    {"dry_friction_global_stick_equations_3", "(5),(7),(6),(7,2)->(6),(6,6),(6,5)",
     call_dry_friction_global_stick_equations, in_rows, 4, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}, {5, 36, 2, 6, NPY_DOUBLE}, {6, 30, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_global_stick_trace_1", "(5),(7),(6)->()",
     call_dry_friction_global_stick_trace, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_trace_2", "(5),(7),(6),(7,2)->(),(11)",
     call_dry_friction_global_stick_trace, in_rows, 4, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 11, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_passage_1", "(5),(7),(6)->(5,4)",
     call_dry_friction_global_stick_passage, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_global_stick_passage_2", "(5),(7),(6)->(5,4),(44)",
     call_dry_friction_global_stick_passage, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}, {4, 44, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_passage_3", "(5),(7),(6)->(5,4),(44),(4)",
     call_dry_friction_global_stick_passage, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}, {4, 44, 1, 0, NPY_DOUBLE}, {5, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_linearisation_1", "(5),(7),(6)->(2,2)",
     call_dry_friction_global_stick_linearisation, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_global_stick_linearisation_2", "(5),(7),(6)->(2,2),(16,4)",
     call_dry_friction_global_stick_linearisation, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 64, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_global_stick_linearisation_3", "(5),(7),(6)->(2,2),(16,4),(4,4)",
     call_dry_friction_global_stick_linearisation, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 64, 2, 4, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_global_stick_flow_stick_stick_1", "(5),(7),(),(4)->(4)",
     call_dry_friction_global_stick_flow_stick_stick, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_flow_slip_stick_1", "(5),(7),(),(4)->(4)",
     call_dry_friction_global_stick_flow_slip_stick, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_flow_slip_slip_1", "(5),(7),(),(4)->(4)",
     call_dry_friction_global_stick_flow_slip_slip, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_flow_stick_slip_1", "(5),(7),(),(4)->(4)",
     call_dry_friction_global_stick_flow_stick_slip, in_rows, 4, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_reduced_1", "(5),(7),(2)->(6)",
     call_dry_friction_global_stick_reduced, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_reduced_2", "(5),(7),(2)->(6),(2)",
     call_dry_friction_global_stick_reduced, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_reduced_3", "(5),(7),(2)->(6),(2),(2,2)",
     call_dry_friction_global_stick_reduced, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}, {5, 4, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_global_stick_period_map_1", "(5),(7),(6)->(4,5)",
     call_dry_friction_global_stick_period_map, in_rows, 3, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_global_stick_period_map_2", "(5),(7),(6)->(4,5),(2)",
     call_dry_friction_global_stick_period_map, in_rows, 3, 2,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_period_map_3", "(5),(7),(6)->(4,5),(2),(4)",
     call_dry_friction_global_stick_period_map, in_rows, 3, 3,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}, {5, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_equations_1", "(4),(7),(6)->(6)",
     call_dry_friction_solution_ii_equations, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_equations_2", "(4),(7),(6)->(6),(6,6)",
     call_dry_friction_solution_ii_equations, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}, {5, 36, 2, 6, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_equations_3", "(4),(7),(6),(7,2)->(6),(6,6),(6,4)",
     call_dry_friction_solution_ii_equations, in_rows, 4, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 6, 1, 0, NPY_DOUBLE}, {5, 36, 2, 6, NPY_DOUBLE}, {6, 24, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_trace_1", "(4),(7),(6)->()",
     call_dry_friction_solution_ii_trace, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_trace_2", "(4),(7),(6),(7,2)->(),(10)",
     call_dry_friction_solution_ii_trace, in_rows, 4, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 14, 2, 2, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 10, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_passage_1", "(4),(7),(6)->(5,4)",
     call_dry_friction_solution_ii_passage, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_passage_2", "(4),(7),(6)->(5,4),(44)",
     call_dry_friction_solution_ii_passage, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}, {4, 44, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_passage_3", "(4),(7),(6)->(5,4),(44),(4)",
     call_dry_friction_solution_ii_passage, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 4, NPY_DOUBLE}, {4, 44, 1, 0, NPY_DOUBLE}, {5, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_linearisation_1", "(4),(7),(6)->(2,2)",
     call_dry_friction_solution_ii_linearisation, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_linearisation_2", "(4),(7),(6)->(2,2),(16,4)",
     call_dry_friction_solution_ii_linearisation, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 64, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_linearisation_3", "(4),(7),(6)->(2,2),(16,4),(4,4)",
     call_dry_friction_solution_ii_linearisation, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 4, 2, 2, NPY_DOUBLE}, {4, 64, 2, 4, NPY_DOUBLE}, {5, 16, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_flow_stick_stick_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_solution_ii_flow_stick_stick, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_flow_slip_stick_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_solution_ii_flow_slip_stick, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_flow_slip_slip_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_solution_ii_flow_slip_slip, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_flow_stick_slip_1", "(4),(7),(),(4)->(4)",
     call_dry_friction_solution_ii_flow_stick_slip, in_rows, 4, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 1, 0, 0, NPY_DOUBLE}, {3, 4, 1, 0, NPY_DOUBLE}, {4, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_reduced_1", "(4),(7),(3)->(6)",
     call_dry_friction_solution_ii_reduced, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 3, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_reduced_2", "(4),(7),(3)->(6),(3)",
     call_dry_friction_solution_ii_reduced, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 3, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}, {4, 3, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_reduced_3", "(4),(7),(3)->(6),(3),(3,3)",
     call_dry_friction_solution_ii_reduced, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 3, 1, 0, NPY_DOUBLE}, {3, 6, 1, 0, NPY_DOUBLE}, {4, 3, 1, 0, NPY_DOUBLE}, {5, 9, 2, 3, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_period_map_1", "(4),(7),(6)->(4,5)",
     call_dry_friction_solution_ii_period_map, in_rows, 3, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_period_map_2", "(4),(7),(6)->(4,5),(2)",
     call_dry_friction_solution_ii_period_map, in_rows, 3, 2,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_period_map_3", "(4),(7),(6)->(4,5),(2),(4)",
     call_dry_friction_solution_ii_period_map, in_rows, 3, 3,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 7, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 20, 2, 5, NPY_DOUBLE}, {4, 2, 1, 0, NPY_DOUBLE}, {5, 4, 1, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_solve", "(4),(2)->(5),(),(),(),()",
     call_dry_friction_symmetric_solve, in_columns, 2, 5,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 2, 1, 0, NPY_DOUBLE}, {2, 5, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_INT32}, {6, 1, 0, 0, NPY_INT32}}},
    {"dry_friction_symmetric_admissible", "(4),(5)->(1),(),(),()",
     call_dry_friction_symmetric_admissible, one_point, 2, 4,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 5, 1, 0, NPY_DOUBLE}, {2, 1, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_INT32}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_DOUBLE}}},
    {"dry_friction_symmetric_directions", "(4),(5)->(6,4)",
     call_dry_friction_symmetric_directions, in_columns, 2, 1,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 5, 1, 0, NPY_DOUBLE}, {2, 24, 2, 4, NPY_DOUBLE}}},
    {"dry_friction_global_stick_solve", "(5),(2)->(6),(),(),(),()",
     call_dry_friction_global_stick_solve, in_columns, 2, 5,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 2, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_INT32}, {6, 1, 0, 0, NPY_INT32}}},
    {"dry_friction_global_stick_admissible", "(5),(6)->(2),(),(),()",
     call_dry_friction_global_stick_admissible, one_point, 2, 4,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 6, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_INT32}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_DOUBLE}}},
    {"dry_friction_global_stick_directions", "(5),(6)->(7,5)",
     call_dry_friction_global_stick_directions, in_columns, 2, 1,
     {{0, 5, 1, 0, NPY_DOUBLE}, {1, 6, 1, 0, NPY_DOUBLE}, {2, 35, 2, 5, NPY_DOUBLE}}},
    {"dry_friction_solution_ii_solve", "(4),(3)->(6),(),(),(),()",
     call_dry_friction_solution_ii_solve, in_columns, 2, 5,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 3, 1, 0, NPY_DOUBLE}, {2, 6, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_DOUBLE}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_INT32}, {6, 1, 0, 0, NPY_INT32}}},
    {"dry_friction_solution_ii_admissible", "(4),(6)->(2),(),(),()",
     call_dry_friction_solution_ii_admissible, one_point, 2, 4,
     {{0, 4, 1, 0, NPY_DOUBLE}, {1, 6, 1, 0, NPY_DOUBLE}, {2, 2, 1, 0, NPY_DOUBLE}, {3, 1, 0, 0, NPY_INT32}, {4, 1, 0, 0, NPY_DOUBLE}, {5, 1, 0, 0, NPY_DOUBLE}}},
};
enum { function_count = sizeof functions / sizeof *functions };
static PyUFuncGenericFunction loops[function_count];
static void *data[function_count];
static char types[function_count][most_arrays];

static int add_all(PyObject *module)
{
    import_array1(-1);
    import_umath1(-1);
    for (int i = 0; i < function_count; ++i) {
        const wrapped *const f = &functions[i];
        loops[i] = loop;
        data[i] = (void *)f;
        for (int k = 0; k < f->inputs + f->outputs; ++k)
            types[i][k] = (char)f->arrays[k].type;
        PyObject *const ufunc = PyUFunc_FromFuncAndDataAndSignature(
            &loops[i], &data[i], types[i], 1, f->inputs, f->outputs, PyUFunc_None, f->name, NULL,
            0, f->signature);
        if (!ufunc || PyModule_AddObject(module, f->name, ufunc) < 0)
            return -1;
        for (int k = f->inputs; k < f->inputs + f->outputs; ++k)
            ((PyUFuncObject *)ufunc)->op_flags[k] = of_output;
    }
    if (PyModule_AddStringConstant(module, "derivation_rigid_stop", "6ab4b35d60128a25") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_elastic_stop", "be50ff9ea3fd87a3") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_dry_friction", "69dc208163fa82f5") < 0)
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
