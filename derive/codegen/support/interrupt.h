/* Loops that work without Python's lock, and end when Python wants them to: at a signal such as
 * Ctrl-C, or in a thread whose work is called off. */
#ifndef NONSMOOTH_INTERRUPT_H
#define NONSMOOTH_INTERRUPT_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <time.h>

/* When it was last asked, and whether it is to end; all zero at first. */
typedef struct {
    struct timespec asked;
    int ended;
} nonsmooth_work;

static const double NONSMOOTH_PAUSE = 0.03; /* seconds between two questions */

/* Ask Python, whose lock is held: nonzero with an exception set if the work is to end. */
static inline int nonsmooth_called_off(void)
{
    if (PyErr_CheckSignals() != 0)
        return 1;
    /* where the package is in use it knows which threads are called off */
    PyObject *const name = PyUnicode_FromString("nonsmooth.runtime.core.parallel");
    PyObject *const module = name ? PyImport_GetModule(name) : NULL;
    Py_XDECREF(name);
    if (!module)
        return PyErr_Occurred() != NULL;
    PyObject *const answer = PyObject_CallMethod(module, "check_called_off", NULL);
    Py_DECREF(module);
    Py_XDECREF(answer);
    return answer == NULL;
}

/* Whether to end, with an exception set then. Costs the time to read a clock: Python is asked when
 * NONSMOOTH_PAUSE is over, and the lock is taken for that alone. */
static inline int nonsmooth_ends(nonsmooth_work *work)
{
    struct timespec now;
    if (work->ended || timespec_get(&now, TIME_UTC) != TIME_UTC)
        return work->ended;
    const double since = (double)(now.tv_sec - work->asked.tv_sec) +
                         1e-9 * (double)(now.tv_nsec - work->asked.tv_nsec);
    if (since >= 0.0 && since < NONSMOOTH_PAUSE) /* below 0 the clock was set back */
        return 0;
    if (work->asked.tv_sec != 0) {
        const PyGILState_STATE lock = PyGILState_Ensure();
        work->ended = nonsmooth_called_off();
        PyGILState_Release(lock);
    }
    work->asked = now;
    return work->ended;
}

/* The same of a loop whose caller does not look for exceptions: it is raised in this thread as soon
 * as that has returned. */
static inline int nonsmooth_ends_later(nonsmooth_work *work)
{
    if (work->ended || !nonsmooth_ends(work))
        return work->ended;
    const PyGILState_STATE lock = PyGILState_Ensure();
    PyObject *type, *value, *trace;
    PyErr_Fetch(&type, &value, &trace);
    PyThreadState_SetAsyncExc(PyThread_get_thread_ident(), type);
    Py_XDECREF(type);
    Py_XDECREF(value);
    Py_XDECREF(trace);
    PyGILState_Release(lock);
    return 1;
}

#endif
