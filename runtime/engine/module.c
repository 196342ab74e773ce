/* The Python module of the engine; arrays are checked here before C reads them. */
#include "module.h"

#include "interrupt.h"

void *module_buffer(PyObject *object, Py_buffer *view, const char *name, char format,
                    int writable)
{
    const int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, view, flags) != 0)
        return NULL;
    const Py_ssize_t size = format == 'i' ? 4 : 8;
    const char *found = view->format ? view->format : "B";
    const int same = found[0] == format || (format == 'q' && found[0] == 'l');
    if (!same || found[1] != '\0' || view->itemsize != size) {
        PyErr_Format(PyExc_ValueError, "%s: wrong type or size of array", name);
        PyBuffer_Release(view);
        return NULL;
    }
    return view->buf;
}

int module_layout(const Py_buffer *view, layout *result)
{
    if (layout_read(result, view->buf, (size_t)view->len / sizeof(int32_t)) == 0)
        return 0;
    PyErr_SetString(PyExc_ValueError, "layout: cut or foreign");
    return -1;
}

int module_ends(void *context)
{
    return nonsmooth_ends(context);
}

PyObject *py_compose(PyObject *self, PyObject *arguments);
PyObject *py_move(PyObject *self, PyObject *arguments);
PyObject *py_shoot(PyObject *self, PyObject *arguments);
PyObject *py_simulate(PyObject *self, PyObject *arguments);

static PyMethodDef methods[] = {
    {"compose", py_compose, METH_VARARGS, "Periodic orbits of an itinerary."},
    {"move", py_move, METH_VARARGS, "Derivatives of periodic orbits by parameters."},
    {"shoot", py_shoot, METH_VARARGS, "Shooting maps of itineraries, with derivatives."},
    {"simulate", py_simulate, METH_VARARGS, "Motions from event to event."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_engine",
    .m_doc = "The compiled engine of nonsmooth.",
    .m_size = -1,
    .m_methods = methods,
};

PyMODINIT_FUNC PyInit__engine(void)
{
    return PyModule_Create(&definition);
}
