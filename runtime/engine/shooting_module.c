/* The Python function `shoot` of the engine. */
#include "module.h"

#include "interrupt.h"
#include "shooting.h"

#include <stdlib.h>

PyObject *py_shoot(PyObject *self, PyObject *arguments);

enum {
    DWELL, FIELDS, ROWS, RESETS, FIELD_CHANGES, ROW_CHANGES, RESET_CHANGES,
    STARTS, ENDS, VELOCITIES, RESIDUAL, SLOPES, VARIATIONAL, BUFFERS
};

static const char *const NAMES[BUFFERS] = {
    "dwell",  "fields", "rows",       "resets",   "field changes", "row changes", "reset changes",
    "starts", "ends",   "velocities", "residual", "slopes",        "variational"};

/* shoot(points, phases, states, dwell, fields, rows, resets, field changes, row changes,
 * reset changes, starts, ends, velocities, residual, slopes, variational): arrays of doubles with
 * the points as first axis. The three changes are all empty, or as large as what changes. The
 * first of the starts of each point is read; all else that follows is written. */
PyObject *py_shoot(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *object[BUFFERS], *result = NULL;
    Py_buffer view[BUFFERS];
    Py_ssize_t points, phases, states;
    int held = 0;
    if (!PyArg_ParseTuple(arguments, "nnnOOOOOOOOOOOOO:shoot", &points, &phases, &states,
                          &object[DWELL], &object[FIELDS], &object[ROWS], &object[RESETS],
                          &object[FIELD_CHANGES], &object[ROW_CHANGES], &object[RESET_CHANGES],
                          &object[STARTS], &object[ENDS], &object[VELOCITIES], &object[RESIDUAL],
                          &object[SLOPES], &object[VARIATIONAL]))
        return NULL;
    if (points < 0 || phases < 1 || states < 1) {
        PyErr_SetString(PyExc_ValueError, "points, phases and states: wrong numbers");
        return NULL;
    }
    for (; held < BUFFERS; ++held)
        if (!module_buffer(object[held], &view[held], NAMES[held], 'd', held >= STARTS))
            goto release;
    const int varied = view[FIELD_CHANGES].len > 0;
    const size_t n = (size_t)states, p = (size_t)phases;
    const size_t unknowns = size_sum(size_sum(p, n), (size_t)varied);
    const size_t map = size_product(n, n + 1), changed = varied ? p : 0;
    const size_t each[BUFFERS] = {p,
                                  size_product(p, map),
                                  size_product(p, n + 1),
                                  size_product(p, map),
                                  size_product(changed, map),
                                  size_product(changed, n + 1),
                                  size_product(changed, map),
                                  size_product(p + 1, n),
                                  size_product(p, n),
                                  size_product(p, n),
                                  p,
                                  size_product(p, unknowns),
                                  size_product(n, unknowns)};
    for (int k = 0; k < BUFFERS; ++k)
        if (!module_holds(&view[k], points, each[k], sizeof(double))) {
            PyErr_Format(PyExc_ValueError, "%s: wrong size of array", NAMES[k]);
            goto release;
        }
    double *const room = calloc(shooting_room(n, unknowns), sizeof(double));
    if (!room) {
        PyErr_NoMemory();
        goto release;
    }
    nonsmooth_work work = {0};
    patience patience = {.ends = module_ends, .context = &work};
    Py_BEGIN_ALLOW_THREADS
    double *at[BUFFERS];
    for (int k = 0; k < BUFFERS; ++k)
        at[k] = view[k].buf;
    for (Py_ssize_t i = 0; i < points && !lost_after(&patience, size_product(64 * p, n * map));
         ++i) {
        const chain_of_phases chain = {
            .states = states,
            .phases = phases,
            .field = at[FIELDS],
            .row = at[ROWS],
            .reset = at[RESETS],
            .field_change = varied ? at[FIELD_CHANGES] : NULL,
            .row_change = varied ? at[ROW_CHANGES] : NULL,
            .reset_change = varied ? at[RESET_CHANGES] : NULL,
        };
        const shot shot = {at[STARTS],   at[ENDS],   at[VELOCITIES],
                           at[RESIDUAL], at[SLOPES], at[VARIATIONAL]};
        shoot(&chain, at[DWELL], &shot, room);
        for (int k = 0; k < BUFFERS; ++k)
            at[k] += each[k];
    }
    Py_END_ALLOW_THREADS
    free(room);
    result = patience.ended ? NULL : Py_NewRef(Py_None);
release:
    while (held > 0)
        PyBuffer_Release(&view[--held]);
    return result;
}
