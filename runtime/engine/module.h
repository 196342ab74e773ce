/* What the Python functions of the engine share: arrays checked before C reads them. */
#ifndef NONSMOOTH_MODULE_H
#define NONSMOOTH_MODULE_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "patience.h"
#include "tables.h"

/* A contiguous buffer of one format ("d" double, "i" int32, "q" int64); NULL with a Python error
 * otherwise. Release `view` afterwards. */
void *module_buffer(PyObject *object, Py_buffer *view, const char *name, char format,
                    int writable);

/* Whether a buffer has so many times so many items of a size. */
static inline int module_holds(const Py_buffer *view, Py_ssize_t count, size_t each, size_t size)
{
    return (size_t)view->len == size_product(size_product((size_t)count, each), size);
}

/* Layout of a packed buffer; 0, or -1 with a Python error. */
int module_layout(const Py_buffer *view, layout *result);

/* Whether Python wants C to end, with an exception set then: what a patience asks, whose context is
 * a nonsmooth_work. */
int module_ends(void *context);

#endif
