/* The Python function `compose` of the engine. */
#include "compose.h"
#include "module.h"

PyObject *py_compose(PyObject *self, PyObject *arguments);

enum { BUFFERS = 10, MOST_PHASES = 1 << 16 };

/* Whether every phase names what the layout has. */
static int sound(const layout *l, const cycle *c)
{
    for (int i = 0; i < c->phases; ++i)
        if (c->configuration[i] < 0 || c->configuration[i] >= l->configurations ||
            c->row[i] < 0 || c->row[i] >= l->rows || c->reset[i] < 0 || c->reset[i] >= l->resets)
            return 0;
    return 1;
}

/* compose(layout, cycle, numbers, periods, guided, dwell, starts, maps, residuals, iterations,
 * statuses): one solve for each period, in place. */
PyObject *py_compose(PyObject *self, PyObject *arguments)
{
    (void)self;
    PyObject *object[BUFFERS], *result = NULL;
    int guided, held = 0;
    Py_buffer view[BUFFERS];
    if (!PyArg_ParseTuple(arguments, "OOOOpOOOOOO:compose", &object[0], &object[1], &object[2],
                          &object[3], &guided, &object[4], &object[5], &object[6], &object[7],
                          &object[8], &object[9]))
        return NULL;
    layout layout;
    void *data[BUFFERS];
    compose_room room = {0};
    static const char *const name[BUFFERS] = {"layout", "cycle",  "numbers",   "periods",    "dwell",
                                              "starts", "maps",   "residuals", "iterations", "statuses"};
    static const char format[BUFFERS] = {'i', 'i', 'd', 'd', 'd', 'd', 'd', 'd', 'i', 'i'};
    Py_ssize_t length[BUFFERS] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    static const int order[BUFFERS] = {0, 1, 3, 2, 4, 5, 6, 7, 8, 9};
    for (; held < BUFFERS; ++held) {
        const int k = order[held];
        data[k] = module_buffer(object[k], &view[held], name[k], format[k], length[k], k >= 4);
        if (!data[k])
            goto release;
        if (k == 0 && module_layout(&view[held], &layout) != 0) {
            ++held;
            goto release;
        }
        if (k != 3)
            continue;
        /* order[1] is the cycle, order[2] the periods: the other sizes follow */
        const Py_ssize_t phases = view[1].len / (Py_ssize_t)(3 * sizeof(int32_t));
        const Py_ssize_t points = view[2].len / (Py_ssize_t)sizeof(double), n = layout.states;
        if (phases < 1 || phases > MOST_PHASES || phases * 3 * 4 != view[1].len) {
            PyErr_SetString(PyExc_ValueError, "cycle: wrong type or size of array");
            ++held;
            goto release;
        }
        length[2] = points * (Py_ssize_t)layout_numbers(&layout);
        length[4] = points * phases;
        length[5] = points * phases * n;
        length[6] = points * n * n;
        length[7] = length[8] = length[9] = points;
    }
    const int phases = (int)(view[1].len / (Py_ssize_t)(3 * sizeof(int32_t)));
    const int32_t *integers = data[1];
    const cycle cycle = {phases, integers, integers + phases, integers + 2 * phases};
    if (!sound(&layout, &cycle)) {
        PyErr_SetString(PyExc_ValueError, "cycle: not of this layout");
        goto release;
    }
    if (compose_create(&room, &layout, phases) != 0) {
        PyErr_NoMemory();
        goto release;
    }
    const double *numbers = data[2], *periods = data[3];
    double *dwell = data[4], *starts = data[5], *maps = data[6], *residuals = data[7];
    int32_t *iterations = data[8], *statuses = data[9];
    const size_t points = (size_t)view[2].len / sizeof(double), size = layout_numbers(&layout);
    const size_t n = (size_t)layout.states, p = (size_t)phases;
    Py_BEGIN_ALLOW_THREADS
    for (size_t i = 0; i < points; ++i) {
        const composed found =
            compose_solve(&layout, &cycle, numbers + i * size, periods[i], guided, dwell + i * p,
                          starts + i * p * n, maps + i * n * n, &room);
        residuals[i] = found.residual;
        iterations[i] = found.iterations;
        statuses[i] = found.status;
    }
    Py_END_ALLOW_THREADS
    result = Py_NewRef(Py_None);
release:
    compose_free(&room);
    while (held > 0)
        PyBuffer_Release(&view[--held]);
    return result;
}
