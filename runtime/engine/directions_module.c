/* The Python function `move` of the engine. */
#include "module.h"

#include "directions.h"
#include "interrupt.h"

#include <stdlib.h>

PyObject *py_move(PyObject *self, PyObject *arguments);

enum {
    PAIRS, ENTRIES, PLACES, FORCING, DWELL, STARTS, FIELDS, ROWS, RESETS, RATES,
    DWELL_MOVED, STARTS_MOVED, TRACES_MOVED, MAPS, MAPS_MOVED, BUFFERS
};

static const char *const NAMES[BUFFERS] = {
    "pairs",  "entries",     "places",       "forcing",      "dwell",
    "starts", "fields",      "rows",         "resets",       "rates",
    "dwell moved", "starts moved", "traces moved", "maps", "maps moved"};

/* Whether what is told of moving entries is so; else with a Python error. */
static int entries_hold(const Py_buffer *view, size_t pairs, size_t entries, size_t rates,
                        Py_ssize_t states)
{
    const int32_t *start = view[PAIRS].buf, *entry = view[ENTRIES].buf, *rate = view[PLACES].buf;
    const int32_t *forcing = view[FORCING].buf;
    const Py_ssize_t count = view[ENTRIES].len / (Py_ssize_t)sizeof(int32_t);
    int holds = module_holds(&view[PAIRS], 1, pairs + 1, sizeof(int32_t)) &&
                view[PLACES].len == view[ENTRIES].len && start[0] == 0 && start[pairs] == count &&
                (view[FORCING].len == 0 || module_holds(&view[FORCING], 1, 2, sizeof(int32_t)));
    for (size_t i = 0; holds && i < pairs; ++i)
        holds = start[i] <= start[i + 1];
    for (Py_ssize_t i = 0; holds && i < count; ++i)
        holds = entry[i] >= 0 && (size_t)entry[i] < entries && rate[i] >= 0 &&
                (size_t)rate[i] < rates;
    for (int k = 0; holds && view[FORCING].len > 0 && k < 2; ++k)
        holds = forcing[k] >= 0 && forcing[k] < states;
    if (!holds)
        PyErr_SetString(PyExc_ValueError, "entries: not of this cycle");
    return holds;
}

/* move(points, phases, states, directions, rates, timed, pairs, entries, places, forcing, dwell,
 * starts, fields, rows, resets, rates, dwell moved, starts moved, traces moved, maps, maps moved):
 * four arrays of int32, then arrays of doubles with the points as first axis. The last two are
 * both empty where they are not asked for. */
PyObject *py_move(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *object[BUFFERS], *result = NULL;
    Py_buffer view[BUFFERS];
    Py_ssize_t points, phases, states, directions, rates;
    int timed, held = 0;
    if (!PyArg_ParseTuple(arguments, "nnnnnpOOOOOOOOOOOOOOO:move", &points, &phases, &states,
                          &directions, &rates, &timed, &object[PAIRS], &object[ENTRIES],
                          &object[PLACES], &object[FORCING], &object[DWELL], &object[STARTS],
                          &object[FIELDS], &object[ROWS], &object[RESETS], &object[RATES],
                          &object[DWELL_MOVED], &object[STARTS_MOVED], &object[TRACES_MOVED],
                          &object[MAPS], &object[MAPS_MOVED]))
        return NULL;
    if (points < 0 || phases < 1 || states < 1 || directions < 0 || rates < 0) {
        PyErr_SetString(PyExc_ValueError, "points, phases, states, directions, rates: wrong numbers");
        return NULL;
    }
    for (; held < BUFFERS; ++held)
        if (!module_buffer(object[held], &view[held], NAMES[held], held < DWELL ? 'i' : 'd',
                           held >= DWELL_MOVED))
            goto release;
    const size_t n = (size_t)states, p = (size_t)phases, q = (size_t)directions;
    const size_t map = size_product(n, n + 1), square = size_product(n, n);
    const int mapped = view[MAPS].len > 0;
    const size_t each[BUFFERS] = {[DWELL] = p,
                                  [STARTS] = n,
                                  [FIELDS] = size_product(p, map),
                                  [ROWS] = size_product(p, n + 1),
                                  [RESETS] = size_product(p, map),
                                  [RATES] = (size_t)rates,
                                  [DWELL_MOVED] = size_product(q, p),
                                  [STARTS_MOVED] = size_product(q, n),
                                  [TRACES_MOVED] = q,
                                  [MAPS] = mapped ? square : 0,
                                  [MAPS_MOVED] = mapped ? size_product(q, square) : 0};
    for (int k = DWELL; k < BUFFERS; ++k)
        if (!module_holds(&view[k], points, each[k], sizeof(double))) {
            PyErr_Format(PyExc_ValueError, "%s: wrong size of array", NAMES[k]);
            goto release;
        }
    if (!entries_hold(view, size_product(p, q), 2 * map + n + 1, (size_t)rates, states))
        goto release;
    double *const room = calloc(moving_room(n, p, q), sizeof(double));
    int *const order = calloc(n, sizeof(int));
    if (!room || !order) {
        free(room);
        free(order);
        PyErr_NoMemory();
        goto release;
    }
    nonsmooth_work work = {0};
    patience patience = {.ends = module_ends, .context = &work};
    Py_BEGIN_ALLOW_THREADS
    double *at[BUFFERS];
    for (int k = DWELL; k < BUFFERS; ++k)
        at[k] = view[k].buf;
    for (Py_ssize_t i = 0; i < points && !patience.ended && !lost(&patience); ++i) {
        const moving_orbit orbit = {
            .states = states,
            .phases = phases,
            .directions = directions,
            .field = at[FIELDS],
            .row = at[ROWS],
            .reset = at[RESETS],
            .dwell = at[DWELL],
            .start = at[STARTS],
            .moving = {view[PAIRS].buf, view[ENTRIES].buf, view[PLACES].buf},
            .rate = at[RATES],
            .forcing = view[FORCING].len > 0 ? view[FORCING].buf : NULL,
            .timed = timed,
        };
        const orbit_moves moves = {at[DWELL_MOVED], at[STARTS_MOVED], at[TRACES_MOVED],
                                   mapped ? at[MAPS] : NULL, at[MAPS_MOVED]};
        move_orbit(&orbit, &moves, room, order, &patience);
        for (int k = DWELL; k < BUFFERS; ++k)
            at[k] += each[k];
    }
    Py_END_ALLOW_THREADS
    free(room);
    free(order);
    result = patience.ended ? NULL : Py_NewRef(Py_None);
release:
    while (held > 0)
        PyBuffer_Release(&view[--held]);
    return result;
}
