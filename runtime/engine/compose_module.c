/* The Python function `compose` of the engine. */
#include "module.h"

#include "compose.h"
#include "interrupt.h"

PyObject *py_compose(PyObject *self, PyObject *arguments);

enum { LAYOUT, CYCLE, PERIODS, NUMBERS, DWELL, STARTS, MAPS, RESIDUALS, ITERATIONS, STATUSES };
enum { BUFFERS = STATUSES + 1, MOST_PHASES = 1 << 16 };

static const char *const NAMES[BUFFERS] = {"layout", "cycle",  "periods", "numbers",   "dwell",
                                           "starts", "maps",   "residuals", "iterations",
                                           "statuses"};
static const char FORMATS[BUFFERS] = {'i', 'i', 'd', 'd', 'd', 'd', 'd', 'd', 'i', 'i'};

/* Read a packed cycle; 0, or -1 with a Python error if it is not one of this layout. */
static int read_cycle(const Py_buffer *view, const layout *l, cycle *result)
{
    const Py_ssize_t count = view->len / (Py_ssize_t)sizeof(int32_t), phases = count / 3;
    const int forced = count % 3 == 2;
    if (phases < 1 || phases > MOST_PHASES || 3 * phases + 2 * forced != count) {
        PyErr_SetString(PyExc_ValueError, "cycle: wrong type or size of array");
        return -1;
    }
    const int32_t *all = view->buf, *last = all + 3 * phases;
    if (forced && (last[0] < 0 || last[0] >= l->states || last[1] < 0 || last[1] >= l->states)) {
        PyErr_SetString(PyExc_ValueError, "cycle: not of this layout");
        return -1;
    }
    *result = (cycle){(int)phases, all, all + phases, all + 2 * phases, forced ? last : NULL};
    for (Py_ssize_t i = 0; i < phases; ++i) {
        const int32_t c = result->configuration[i], row = result->row[i], reset = result->reset[i];
        if (c < 0 || c >= l->configurations || row < 0 || row >= l->rows || reset < 0 ||
            reset >= l->resets) {
            PyErr_SetString(PyExc_ValueError, "cycle: not of this layout");
            return -1;
        }
    }
    return 0;
}

/* compose(layout, cycle, periods, numbers, dwell, starts, maps, residuals, iterations, statuses,
 * guided): one solve for each period, in place. */
PyObject *py_compose(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *object[BUFFERS], *result = NULL;
    Py_buffer view[BUFFERS];
    int guided, held = 0;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOOOOp:compose", &object[0], &object[1], &object[2],
                          &object[3], &object[4], &object[5], &object[6], &object[7], &object[8],
                          &object[9], &guided))
        return NULL;
    layout layout;
    cycle cycle;
    compose_room room = {0};
    size_t each[BUFFERS] = {0}; /* items of one point */
    Py_ssize_t points = 0;
    while (held < BUFFERS) {
        const int k = held;
        if (!module_buffer(object[k], &view[k], NAMES[k], FORMATS[k], k >= DWELL))
            goto release;
        ++held;
        if (k > PERIODS && !module_holds(&view[k], points, each[k], (size_t)view[k].itemsize)) {
            PyErr_Format(PyExc_ValueError, "%s: wrong type or size of array", NAMES[k]);
            goto release;
        }
        if (k == LAYOUT && module_layout(&view[k], &layout) != 0)
            goto release;
        if (k == CYCLE && read_cycle(&view[k], &layout, &cycle) != 0)
            goto release;
        if (k != PERIODS)
            continue;
        const size_t n = (size_t)layout.states, phases = (size_t)cycle.phases;
        points = view[k].len / (Py_ssize_t)sizeof(double);
        each[NUMBERS] = layout_numbers(&layout);
        each[DWELL] = phases;
        each[STARTS] = size_product(phases, n);
        each[MAPS] = size_product(n, n);
        each[RESIDUALS] = each[ITERATIONS] = each[STATUSES] = 1;
    }
    if (compose_create(&room, &layout, cycle.phases) != 0) {
        PyErr_NoMemory();
        goto release;
    }
    const double *periods = view[PERIODS].buf, *numbers = view[NUMBERS].buf;
    double *dwell = view[DWELL].buf, *starts = view[STARTS].buf, *maps = view[MAPS].buf;
    double *residuals = view[RESIDUALS].buf;
    int32_t *iterations = view[ITERATIONS].buf, *statuses = view[STATUSES].buf;
    const size_t size = each[NUMBERS], n = (size_t)layout.states, phases = (size_t)cycle.phases;
    nonsmooth_work work = {0};
    patience patience = {.ends = module_ends, .context = &work};
    Py_BEGIN_ALLOW_THREADS
    for (size_t i = 0; i < (size_t)points && !patience.ended; ++i) {
        const composed found = compose_solve(
            &layout, &cycle, numbers + i * size, periods[i], guided, dwell + i * phases,
            starts + i * phases * n, maps + i * n * n, &room, &patience);
        residuals[i] = found.residual;
        iterations[i] = found.iterations;
        statuses[i] = found.status;
    }
    Py_END_ALLOW_THREADS
    result = patience.ended ? NULL : Py_NewRef(Py_None);
release:
    compose_free(&room);
    while (held > 0)
        PyBuffer_Release(&view[--held]);
    return result;
}
