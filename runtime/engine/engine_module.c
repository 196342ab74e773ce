/* The Python function `simulate` of the engine: motions from arrays into arrays. */
#include "module.h"

#include "engine.h"
#include "interrupt.h"

#include <math.h>

PyObject *py_simulate(PyObject *self, PyObject *arguments);

enum { BUFFERS = 14 };

/* The function in Python that decides, and the point and the state's size that it is asked at. */
typedef struct {
    PyObject *function;
    const layout *shape;
    int32_t point;
    int failed;
} asking;

/* The members as a frozenset; NULL with an error. */
static PyObject *set_of(const uint32_t *set, int words)
{
    PyObject *found = PyFrozenSet_New(NULL);
    for (members m = members_of(set, words); found && next_member(&m);) {
        PyObject *member = PyLong_FromLong(m.member);
        if (!member || PySet_Add(found, member) != 0)
            Py_CLEAR(found);
        Py_XDECREF(member);
    }
    return found;
}

static int ask(void *context, int source, const uint32_t *set, const double *state,
               const double *magnitude, double time_error, int32_t *target, int32_t *reset)
{
    asking *asked = context;
    const Py_ssize_t size = (Py_ssize_t)asked->shape->states * (Py_ssize_t)sizeof(double);
    const PyGILState_STATE gil = PyGILState_Ensure();
    int status = STATUS_UNDECLARED;
    PyObject *boundaries = set_of(set, asked->shape->words);
    PyObject *answer =
        boundaries ? PyObject_CallFunction(asked->function, "iiNy#y#d", (int)asked->point, source,
                                           boundaries, (const char *)state, size,
                                           (const char *)magnitude, size, time_error)
                   : NULL;
    int found[3] = {0};
    if (answer && PyArg_ParseTuple(answer, "iii", &found[0], &found[1], &found[2])) {
        status = found[0];
        *target = found[1];
        *reset = found[2];
        if (status < 0 && (found[1] < 0 || found[1] >= asked->shape->configurations ||
                           found[2] < 0 || found[2] >= asked->shape->resets))
            PyErr_SetString(PyExc_ValueError, "decide: no such target or reset");
    }
    if (PyErr_Occurred()) {
        asked->failed = 1;
        status = STATUS_UNDECLARED;
    }
    Py_XDECREF(answer);
    PyGILState_Release(gil);
    return status;
}

/* simulate(layout, numbers, points, states, configurations, until, limit, times, kept, before,
 *          after, sets, grazings, counts, decide)
 * `points` says which row of numbers each motion takes. Each of the arrays of entries has the same
 * number of them for each motion; before, after and sets may have none. `counts` gets status,
 * transitions and grazings of each motion; `until` becomes its end. `decide` is None, or a function
 * of point, source, set, state, magnitudes and time error that answers status, target, reset. A
 * set is as many words as the layout has; to `decide` it is a frozenset. */
PyObject *py_simulate(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *objects[BUFFERS - 1], *function;
    long long limit;
    if (!PyArg_ParseTuple(arguments, "OOOOOOLOOOOOOOO", &objects[0], &objects[1], &objects[2],
                          &objects[3], &objects[4], &objects[5], &limit, &objects[6], &objects[7],
                          &objects[8], &objects[9], &objects[10], &objects[11], &objects[12], &function))
        return NULL;
    static const char *names[] = {"layout", "numbers", "points", "states", "configurations",
                                  "until",  "times",   "kept",   "before", "after",
                                  "sets",   "grazings", "counts"};
    static const char formats[] = {'i', 'd', 'i', 'd', 'i', 'd', 'd', 'i', 'd', 'd', 'i', 'd', 'q'};
    Py_buffer views[BUFFERS - 1];
    int held = 0;
    PyObject *answer = NULL;
    layout shape;
    tables tables = {0};
    engine_room room = {0};
    for (; held < BUFFERS - 1; ++held)
        if (!module_buffer(objects[held], &views[held], names[held], formats[held], held > 2))
            goto done;
    if (module_layout(&views[0], &shape) != 0)
        goto done;
    const size_t size = layout_numbers(&shape);
    const Py_ssize_t count = views[2].len / 4, n = shape.states, words = shape.words;
    const Py_ssize_t rows = (Py_ssize_t)((size_t)views[1].len / 8 / size);
    const Py_ssize_t capacity = count ? views[6].len / 8 / count : 0;
    const Py_ssize_t grazings = count ? views[11].len / 8 / 4 / count : 0;
    const Py_ssize_t all = count * capacity;
    const size_t state = (size_t)n * 8;
    int right = module_holds(&views[1], rows, size, 8) &&
                module_holds(&views[3], count, 1, state) &&
                module_holds(&views[4], count, 1, 4) && module_holds(&views[5], count, 1, 8) &&
                module_holds(&views[6], all, 1, 8) && module_holds(&views[7], all, 1, 4) &&
                (views[8].len == 0 || module_holds(&views[8], all, 1, state)) &&
                (views[9].len == 0 || module_holds(&views[9], all, 1, state)) &&
                (views[10].len == 0 || module_holds(&views[10], all, (size_t)words, 4)) &&
                module_holds(&views[11], count, (size_t)grazings, 32) &&
                module_holds(&views[12], count, 3, 8);
    const int32_t *points = views[2].buf;
    int32_t *configurations = views[4].buf;
    for (Py_ssize_t i = 0; right && i < count; ++i)
        right = points[i] >= 0 && points[i] < rows && configurations[i] >= 0 &&
                configurations[i] < shape.configurations;
    if (!right) {
        PyErr_SetString(PyExc_ValueError, "arrays of sizes that do not fit");
        goto done;
    }
    if (tables_create(&tables, &shape) != 0 || engine_create(&room, &shape) != 0) {
        PyErr_NoMemory();
        goto done;
    }
    asking asked = {function, &shape, 0, 0};
    const decider decider = {ask, &asked};
    nonsmooth_work work = {0};
    patience patience = {.ends = module_ends, .context = &work};
    Py_BEGIN_ALLOW_THREADS
    double *states = views[3].buf, *until = views[5].buf;
    int64_t *counts = views[12].buf;
    int32_t filled = -1;
    for (Py_ssize_t i = 0; i < count && !asked.failed && !patience.ended; ++i) {
        asked.point = points[i];
        if (points[i] != filled) {
            filled = points[i];
            tables_fill(&tables, (const double *)views[1].buf + (size_t)filled * size);
        }
        record record = {
            .capacity = capacity,
            .times = (double *)views[6].buf + i * capacity,
            .configurations = (int32_t *)views[7].buf + i * capacity,
            .before = views[8].len ? (double *)views[8].buf + i * capacity * n : NULL,
            .states = views[9].len ? (double *)views[9].buf + i * capacity * n : NULL,
            .sets = views[10].len ? (uint32_t *)views[10].buf + i * capacity * words : NULL,
            .grazing_capacity = grazings,
            .grazings = (double *)views[11].buf + i * grazings * 4,
        };
        const outcome end =
            engine_run(&tables, states + i * n, &configurations[i], until[i], limit, &record,
                       function == Py_None ? NULL : &decider, &room, &patience);
        until[i] = end.end;
        counts[3 * i] = end.status;
        counts[3 * i + 1] = end.transitions;
        counts[3 * i + 2] = end.grazings;
    }
    Py_END_ALLOW_THREADS
    answer = asked.failed || patience.ended ? NULL : Py_NewRef(Py_None);
done:
    engine_free(&room);
    tables_free(&tables);
    while (held > 0)
        PyBuffer_Release(&views[--held]);
    return answer;
}
