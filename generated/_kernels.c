/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop, nonsmooth.derive.systems.elastic_stop, nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 3092e81478b20181 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include <string.h>

#include "interrupt.h"
#include "rigid_stop.h"
#include "elastic_stop.h"
#include "dry_friction.h"

enum { points = 64 }; /* of a block */

/* Core entries of one argument of one point, in rows, whatever its strides. */
static char *entry(char *base, const npy_intp *strides, int rows, int columns, int index)
{
    (void)rows;
    if (!strides)
        return base;
    return columns ? base + (index / columns) * strides[0] + (index % columns) * strides[1]
                   : base + index * strides[0];
}

#define GATHER(type, to, base, step, strides, size, columns) \
    for (npy_intp point = 0; point < here; ++point) \
        for (int i = 0; i < (size); ++i) \
            (to)[(size) * point + i] = \
                *(type *)entry((base) + (start + point) * (step), strides, size, columns, i)
#define SCATTER(type, from, base, step, strides, size, columns) \
    for (npy_intp point = 0; point < here; ++point) \
        for (int i = 0; i < (size); ++i) \
            *(type *)entry((base) + (start + point) * (step), strides, size, columns, i) = \
                (from)[(size) * point + i]

/* The same in columns: entry i of all points of the block side by side. */
#define GATHER_COLUMNS(type, to, base, step, strides, size, columns) \
    for (int i = 0; i < (size); ++i) { \
        const char *const from = entry((base) + start * (step), strides, size, columns, i); \
        if ((step) == sizeof(type)) \
            memcpy((to) + i * here, from, (size_t)here * sizeof(type)); \
        else \
            for (npy_intp point = 0; point < here; ++point) \
                (to)[i * here + point] = *(const type *)(from + point * (step)); \
    }
#define SCATTER_COLUMNS(type, from, base, step, strides, size, columns) \
    for (int i = 0; i < (size); ++i) { \
        char *const to = entry((base) + start * (step), strides, size, columns, i); \
        if ((step) == sizeof(type)) \
            memcpy(to, (from) + i * here, (size_t)here * sizeof(type)); \
        else \
            for (npy_intp point = 0; point < here; ++point) \
                *(type *)(to + point * (step)) = (from)[i * here + point]; \
    }

static const char types_rigid_stop_spectrum[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_spectrum(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 28];
        GATHER(double, a0, args[0], steps[0], steps + 3, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_spectrum((a0 + 4 * point), (a1 + 7 * point), (a2 + 28 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 4, 7, 0);
        SCATTER(double, a2, args[2], steps[2], steps + 5, 28, 4);
    }
}

static const char types_rigid_stop_flow_free[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_flow_free(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_flow_free((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_rigid_stop_flow_contact[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_flow_contact(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_flow_contact((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_rigid_stop_fields[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_fields(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 40];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_fields((a0 + 5 * point), (a1 + 40 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 40, 5);
    }
}

static const char types_rigid_stop_rows[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_rows(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 25];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_rows((a0 + 5 * point), (a1 + 25 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 25, 5);
    }
}

static const char types_rigid_stop_resets[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_resets(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 60];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_resets((a0 + 5 * point), (a1 + 60 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 60, 5);
    }
}

static const char types_rigid_stop_modes[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_modes(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 10];
        double a3[points * 180];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_modes((a0 + 5 * point), (a1 + 7 * point), (a2 + 10 * point), (a3 + 180 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 6, 10, 2);
        SCATTER(double, a3, args[3], steps[3], steps + 8, 180, 5);
    }
}

static const char types_rigid_stop_one_impact_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 2];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_residual((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 2 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 2, 0);
    }
}

static const char types_rigid_stop_one_impact_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 2);
    }
}

static const char types_rigid_stop_one_impact_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 2];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_residual_and_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 2 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 2, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 2);
    }
}

static const char types_rigid_stop_one_impact_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 28];
        double a3[points * 2];
        double a4[points * 10];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 28, 4);
        GATHER(double, a3, args[3], steps[3], steps + 9, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_parameter_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 28 * point), (a3 + 2 * point), (a4 + 10 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 10, 5);
    }
}

static const char types_rigid_stop_one_impact_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 9];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_poincare_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 9 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 9, 3);
    }
}

static const char types_rigid_stop_one_impact_saltations[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_saltations(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_saltations((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_rigid_stop_one_impact_monodromy[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_monodromy(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_monodromy((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_rigid_stop_one_impact_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_trace((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_rigid_stop_one_impact_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 28];
        double a3[points * 2];
        double a4[points * 7];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 28, 4);
        GATHER(double, a3, args[3], steps[3], steps + 9, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_trace_gradient((a0 + 5 * point), (a1 + 7 * point), (a2 + 28 * point), (a3 + 2 * point), (a4 + 7 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 7, 0);
    }
}

static const char types_rigid_stop_one_impact_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 8];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_states((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 8 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 8, 4);
    }
}

static const char types_rigid_stop_one_impact_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 6];
        double a4[points * 2];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_boundary_functions((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 6 * point), (a4 + 2 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 6, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 2, 0);
    }
}

static const char types_rigid_stop_one_impact_flow_free[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_flow_free(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_flow_free((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_rigid_stop_one_impact_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            rigid_stop_one_impact_expand((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 1 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        SCATTER(double, a3, args[3], steps[3], steps + 7, 1, 0);
    }
}

static const char types_rigid_stop_one_impact_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_rigid_stop_one_impact_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 2];
        double a2[points * 1];
        double a3[points * 1];
        int32_t a4[points * 1];
        int32_t a5[points * 1];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 6, 5, 0);
        rigid_stop_one_impact_solve(here, a0, a1, a2, a3, a4, a5);
        SCATTER_COLUMNS(double, a1, args[1], steps[1], steps + 7, 2, 0);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], NULL, 1, 0);
        SCATTER_COLUMNS(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a5, args[5], steps[5], NULL, 1, 0);
    }
}

static const char types_rigid_stop_one_impact_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 2];
        int32_t a2[points * 1];
        double a3[points * 1];
        double a4[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            if (nonsmooth_ends_later(&work))
                return;
            rigid_stop_one_impact_admissible(1, (a0 + 5 * point), (a1 + 2 * point), (a2 + 1 * point), (a3 + 1 * point), (a4 + 1 * point));
        }
        SCATTER(int32_t, a2, args[2], steps[2], NULL, 1, 0);
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
    }
}

static const char types_rigid_stop_one_impact_directions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_rigid_stop_one_impact_directions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 2];
        double a2[points * 15];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 3, 5, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 4, 2, 0);
        rigid_stop_one_impact_directions(here, a0, a1, a2);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 5, 15, 5);
    }
}

static const char types_elastic_stop_spectrum[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_spectrum(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 12];
        double a2[points * 60];
        GATHER(double, a0, args[0], steps[0], steps + 3, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_spectrum((a0 + 5 * point), (a1 + 12 * point), (a2 + 60 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 4, 12, 0);
        SCATTER(double, a2, args[2], steps[2], steps + 5, 60, 5);
    }
}

static const char types_elastic_stop_flow_contact[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_flow_contact(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_flow_contact((a0 + 5 * point), (a1 + 12 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_elastic_stop_flow_free[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_flow_free(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_flow_free((a0 + 5 * point), (a1 + 12 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_elastic_stop_fields[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_fields(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 40];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_fields((a0 + 5 * point), (a1 + 40 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 40, 5);
    }
}

static const char types_elastic_stop_rows[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_rows(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 25];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_rows((a0 + 5 * point), (a1 + 25 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 25, 5);
    }
}

static const char types_elastic_stop_resets[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_resets(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 2, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_resets((a0 + 5 * point), (a1 + 20 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 20, 5);
    }
}

static const char types_elastic_stop_modes[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_modes(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 12];
        double a2[points * 12];
        double a3[points * 200];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_modes((a0 + 5 * point), (a1 + 12 * point), (a2 + 12 * point), (a3 + 200 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 6, 12, 2);
        SCATTER(double, a3, args[3], steps[3], steps + 8, 200, 5);
    }
}

static const char types_elastic_stop_one_contact_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_residual((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 0);
    }
}

static const char types_elastic_stop_one_contact_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_jacobian((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_elastic_stop_one_contact_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 4];
        double a4[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_residual_and_jacobian((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 4 * point), (a4 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 4, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 16, 4);
    }
}

static const char types_elastic_stop_one_contact_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 60];
        double a3[points * 4];
        double a4[points * 24];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 60, 5);
        GATHER(double, a3, args[3], steps[3], steps + 9, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_parameter_jacobian((a0 + 6 * point), (a1 + 12 * point), (a2 + 60 * point), (a3 + 4 * point), (a4 + 24 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 24, 6);
    }
}

static const char types_elastic_stop_one_contact_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 9];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_poincare_jacobian((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 9 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 9, 3);
    }
}

static const char types_elastic_stop_one_contact_saltations[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_saltations(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 32];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_saltations((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 32 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 32, 4);
    }
}

static const char types_elastic_stop_one_contact_monodromy[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_monodromy(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_monodromy((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_elastic_stop_one_contact_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_trace((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_elastic_stop_one_contact_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 60];
        double a3[points * 4];
        double a4[points * 10];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 60, 5);
        GATHER(double, a3, args[3], steps[3], steps + 9, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_trace_gradient((a0 + 6 * point), (a1 + 12 * point), (a2 + 60 * point), (a3 + 4 * point), (a4 + 10 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 10, 0);
    }
}

static const char types_elastic_stop_one_contact_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 12];
        GATHER(double, a0, args[0], steps[0], steps + 4, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_states((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 12 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 12, 4);
    }
}

static const char types_elastic_stop_one_contact_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 4];
        double a3[points * 12];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_boundary_functions((a0 + 6 * point), (a1 + 12 * point), (a2 + 4 * point), (a3 + 12 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 12, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 0);
    }
}

static const char types_elastic_stop_one_contact_flow_contact[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_flow_contact(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_flow_contact((a0 + 6 * point), (a1 + 12 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_elastic_stop_one_contact_flow_free[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_flow_free(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_flow_free((a0 + 6 * point), (a1 + 12 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_elastic_stop_one_contact_reduced[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_reduced(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 1];
        double a4[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 1, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_reduced((a0 + 6 * point), (a1 + 12 * point), (a2 + 1 * point), (a3 + 1 * point), (a4 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 1, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 1, 1);
    }
}

static const char types_elastic_stop_one_contact_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 12];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 12, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 1, 0);
        for (npy_intp point = 0; point < here; ++point) {
            elastic_stop_one_contact_expand((a0 + 6 * point), (a1 + 12 * point), (a2 + 1 * point), (a3 + 4 * point), (a4 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 4, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 1, 0);
    }
}

static const char types_elastic_stop_one_contact_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_elastic_stop_one_contact_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 1];
        double a2[points * 4];
        double a3[points * 1];
        double a4[points * 1];
        int32_t a5[points * 1];
        int32_t a6[points * 1];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 7, 6, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 8, 1, 0);
        elastic_stop_one_contact_solve(here, a0, a1, a2, a3, a4, a5, a6);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 9, 4, 0);
        SCATTER_COLUMNS(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER_COLUMNS(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a5, args[5], steps[5], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a6, args[6], steps[6], NULL, 1, 0);
    }
}

static const char types_elastic_stop_one_contact_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 4];
        int32_t a2[points * 1];
        double a3[points * 1];
        double a4[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 5, 6, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            if (nonsmooth_ends_later(&work))
                return;
            elastic_stop_one_contact_admissible(1, (a0 + 6 * point), (a1 + 4 * point), (a2 + 1 * point), (a3 + 1 * point), (a4 + 1 * point));
        }
        SCATTER(int32_t, a2, args[2], steps[2], NULL, 1, 0);
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
    }
}

static const char types_elastic_stop_one_contact_directions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_elastic_stop_one_contact_directions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 6];
        double a1[points * 4];
        double a2[points * 30];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 3, 6, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 4, 4, 0);
        elastic_stop_one_contact_directions(here, a0, a1, a2);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 5, 30, 6);
    }
}

static const char types_dry_friction_spectrum[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_spectrum(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 2];
        double a1[points * 7];
        double a2[points * 14];
        GATHER(double, a0, args[0], steps[0], steps + 3, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_spectrum((a0 + 2 * point), (a1 + 7 * point), (a2 + 14 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 4, 7, 0);
        SCATTER(double, a2, args[2], steps[2], steps + 5, 14, 2);
    }
}

static const char types_dry_friction_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_slip_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_slip_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_slip_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_slip_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_stick_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_stick_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_stick_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_overshoot_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_overshoot_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_flow_overshoot_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_fields[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_fields(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 180];
        GATHER(double, a0, args[0], steps[0], steps + 2, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_fields((a0 + 7 * point), (a1 + 180 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 180, 5);
    }
}

static const char types_dry_friction_rows[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_rows(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 85];
        GATHER(double, a0, args[0], steps[0], steps + 2, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_rows((a0 + 7 * point), (a1 + 85 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 85, 5);
    }
}

static const char types_dry_friction_resets[] = {NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_resets(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 80];
        GATHER(double, a0, args[0], steps[0], steps + 2, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_resets((a0 + 7 * point), (a1 + 80 * point));
        }
        SCATTER(double, a1, args[1], steps[1], steps + 3, 80, 5);
    }
}

static const char types_dry_friction_modes[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_modes(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 42];
        double a3[points * 760];
        GATHER(double, a0, args[0], steps[0], steps + 4, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_modes((a0 + 7 * point), (a1 + 7 * point), (a2 + 42 * point), (a3 + 760 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 6, 42, 2);
        SCATTER(double, a3, args[3], steps[3], steps + 8, 760, 5);
    }
}

static const char types_dry_friction_symmetric_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 5];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_residual((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 5 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 5, 0);
    }
}

static const char types_dry_friction_symmetric_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 25];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 25 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 25, 5);
    }
}

static const char types_dry_friction_symmetric_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 5];
        double a4[points * 25];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_residual_and_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 5 * point), (a4 + 25 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 5, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 25, 5);
    }
}

static const char types_dry_friction_symmetric_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 5];
        double a4[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_parameter_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 5 * point), (a4 + 20 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 20, 4);
    }
}

static const char types_dry_friction_symmetric_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_poincare_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 2);
    }
}

static const char types_dry_friction_symmetric_saltations[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_saltations(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 32];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_saltations((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 32 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 32, 4);
    }
}

static const char types_dry_friction_symmetric_monodromy[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_monodromy(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_monodromy((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_dry_friction_symmetric_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_trace((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_dry_friction_symmetric_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 5];
        double a4[points * 9];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_trace_gradient((a0 + 4 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 5 * point), (a4 + 9 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 9, 0);
    }
}

static const char types_dry_friction_symmetric_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 12];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_states((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 12 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 12, 4);
    }
}

static const char types_dry_friction_symmetric_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 5];
        double a3[points * 24];
        double a4[points * 3];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_boundary_functions((a0 + 4 * point), (a1 + 7 * point), (a2 + 5 * point), (a3 + 24 * point), (a4 + 3 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 24, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 3, 0);
    }
}

static const char types_dry_friction_symmetric_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_flow_slip_slip((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_symmetric_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_flow_slip_stick((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_symmetric_reduced[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_reduced(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 2];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_reduced((a0 + 4 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 2 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 2, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 2);
    }
}

static const char types_dry_friction_symmetric_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 5];
        double a4[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_symmetric_expand((a0 + 4 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 5 * point), (a4 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 5, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 1, 0);
    }
}

static const char types_dry_friction_global_stick_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_residual((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_global_stick_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 36 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 36, 6);
    }
}

static const char types_dry_friction_global_stick_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        double a4[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_residual_and_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point), (a4 + 36 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 6, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 36, 6);
    }
}

static const char types_dry_friction_global_stick_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 30];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_parameter_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 30 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 30, 5);
    }
}

static const char types_dry_friction_global_stick_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_poincare_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 2);
    }
}

static const char types_dry_friction_global_stick_saltations[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_saltations(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 64];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_saltations((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 64 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 64, 4);
    }
}

static const char types_dry_friction_global_stick_monodromy[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_monodromy(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_monodromy((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_dry_friction_global_stick_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_trace((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_dry_friction_global_stick_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 11];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_trace_gradient((a0 + 5 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 11 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 11, 0);
    }
}

static const char types_dry_friction_global_stick_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_states((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 20 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 20, 4);
    }
}

static const char types_dry_friction_global_stick_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 44];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_boundary_functions((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 44 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 44, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_stick_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_stick_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_flow_stick_stick((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_flow_slip_stick((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_flow_slip_slip((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_stick_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_stick_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_flow_stick_slip((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_reduced[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_reduced(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 2];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_reduced((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 2 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 2, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 2);
    }
}

static const char types_dry_friction_global_stick_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_expand((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 6 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_global_stick_period_map[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_period_map(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 4];
        double a4[points * 2];
        double a5[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 6, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 8, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_global_stick_period_map((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 4 * point), (a4 + 2 * point), (a5 + 20 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 9, 4, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 10, 2, 0);
        SCATTER(double, a5, args[5], steps[5], steps + 11, 20, 5);
    }
}

static const char types_dry_friction_solution_ii_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_residual((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_solution_ii_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 36 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 36, 6);
    }
}

static const char types_dry_friction_solution_ii_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        double a4[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_residual_and_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point), (a4 + 36 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 6, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 36, 6);
    }
}

static const char types_dry_friction_solution_ii_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 24];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_parameter_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 24 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 24, 4);
    }
}

static const char types_dry_friction_solution_ii_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_poincare_jacobian((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 2);
    }
}

static const char types_dry_friction_solution_ii_saltations[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_saltations(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 64];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_saltations((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 64 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 64, 4);
    }
}

static const char types_dry_friction_solution_ii_monodromy[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_monodromy(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 16];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_monodromy((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 16 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 16, 4);
    }
}

static const char types_dry_friction_solution_ii_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_trace((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 1 * point));
        }
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_dry_friction_solution_ii_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 10];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_trace_gradient((a0 + 4 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 10 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 10, 10, 0);
    }
}

static const char types_dry_friction_solution_ii_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_states((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 20 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 20, 4);
    }
}

static const char types_dry_friction_solution_ii_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 44];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_boundary_functions((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 44 * point), (a4 + 4 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 44, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 0);
    }
}

static const char types_dry_friction_solution_ii_flow_stick_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_flow_stick_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_flow_stick_stick((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_solution_ii_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_flow_slip_stick((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_solution_ii_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_flow_slip_slip((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_solution_ii_flow_stick_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_flow_stick_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_flow_stick_slip((a0 + 4 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        }
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_solution_ii_reduced[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_reduced(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 3];
        double a3[points * 3];
        double a4[points * 9];
        GATHER(double, a0, args[0], steps[0], steps + 5, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 3, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_reduced((a0 + 4 * point), (a1 + 7 * point), (a2 + 3 * point), (a3 + 3 * point), (a4 + 9 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 8, 3, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 9, 3);
    }
}

static const char types_dry_friction_solution_ii_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 3];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 3, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_expand((a0 + 4 * point), (a1 + 7 * point), (a2 + 3 * point), (a3 + 6 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_solution_ii_period_map[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_period_map(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 4];
        double a4[points * 2];
        double a5[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 6, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 8, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            dry_friction_solution_ii_period_map((a0 + 4 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 4 * point), (a4 + 2 * point), (a5 + 20 * point));
        }
        SCATTER(double, a3, args[3], steps[3], steps + 9, 4, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 10, 2, 0);
        SCATTER(double, a5, args[5], steps[5], steps + 11, 20, 5);
    }
}

static const char types_dry_friction_symmetric_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_dry_friction_symmetric_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 2];
        double a2[points * 5];
        double a3[points * 1];
        double a4[points * 1];
        int32_t a5[points * 1];
        int32_t a6[points * 1];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 7, 4, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 8, 2, 0);
        dry_friction_symmetric_solve(here, a0, a1, a2, a3, a4, a5, a6);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 9, 5, 0);
        SCATTER_COLUMNS(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER_COLUMNS(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a5, args[5], steps[5], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a6, args[6], steps[6], NULL, 1, 0);
    }
}

static const char types_dry_friction_symmetric_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 5];
        double a2[points * 1];
        int32_t a3[points * 1];
        double a4[points * 1];
        double a5[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 6, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 5, 0);
        for (npy_intp point = 0; point < here; ++point) {
            if (nonsmooth_ends_later(&work))
                return;
            dry_friction_symmetric_admissible(1, (a0 + 4 * point), (a1 + 5 * point), (a2 + 1 * point), (a3 + 1 * point), (a4 + 1 * point), (a5 + 1 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 8, 1, 0);
        SCATTER(int32_t, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER(double, a5, args[5], steps[5], NULL, 1, 0);
    }
}

static const char types_dry_friction_symmetric_directions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_symmetric_directions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 5];
        double a2[points * 24];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 3, 4, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 4, 5, 0);
        dry_friction_symmetric_directions(here, a0, a1, a2);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 5, 24, 4);
    }
}

static const char types_dry_friction_global_stick_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_dry_friction_global_stick_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 2];
        double a2[points * 6];
        double a3[points * 1];
        double a4[points * 1];
        int32_t a5[points * 1];
        int32_t a6[points * 1];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 7, 5, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 8, 2, 0);
        dry_friction_global_stick_solve(here, a0, a1, a2, a3, a4, a5, a6);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 9, 6, 0);
        SCATTER_COLUMNS(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER_COLUMNS(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a5, args[5], steps[5], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a6, args[6], steps[6], NULL, 1, 0);
    }
}

static const char types_dry_friction_global_stick_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 6];
        double a2[points * 2];
        int32_t a3[points * 1];
        double a4[points * 1];
        double a5[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 6, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            if (nonsmooth_ends_later(&work))
                return;
            dry_friction_global_stick_admissible(1, (a0 + 5 * point), (a1 + 6 * point), (a2 + 2 * point), (a3 + 1 * point), (a4 + 1 * point), (a5 + 1 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 8, 2, 0);
        SCATTER(int32_t, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER(double, a5, args[5], steps[5], NULL, 1, 0);
    }
}

static const char types_dry_friction_global_stick_directions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_directions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 5];
        double a1[points * 6];
        double a2[points * 35];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 3, 5, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 4, 6, 0);
        dry_friction_global_stick_directions(here, a0, a1, a2);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 5, 35, 5);
    }
}

static const char types_dry_friction_solution_ii_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_dry_friction_solution_ii_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 3];
        double a2[points * 6];
        double a3[points * 1];
        double a4[points * 1];
        int32_t a5[points * 1];
        int32_t a6[points * 1];
        GATHER_COLUMNS(double, a0, args[0], steps[0], steps + 7, 4, 0);
        GATHER_COLUMNS(double, a1, args[1], steps[1], steps + 8, 3, 0);
        dry_friction_solution_ii_solve(here, a0, a1, a2, a3, a4, a5, a6);
        SCATTER_COLUMNS(double, a2, args[2], steps[2], steps + 9, 6, 0);
        SCATTER_COLUMNS(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER_COLUMNS(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a5, args[5], steps[5], NULL, 1, 0);
        SCATTER_COLUMNS(int32_t, a6, args[6], steps[6], NULL, 1, 0);
    }
}

static const char types_dry_friction_solution_ii_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_solution_ii_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    nonsmooth_work work = {0};
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        if (nonsmooth_ends_later(&work))
            return;
        double a0[points * 4];
        double a1[points * 6];
        double a2[points * 2];
        int32_t a3[points * 1];
        double a4[points * 1];
        double a5[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 6, 4, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point) {
            if (nonsmooth_ends_later(&work))
                return;
            dry_friction_solution_ii_admissible(1, (a0 + 4 * point), (a1 + 6 * point), (a2 + 2 * point), (a3 + 1 * point), (a4 + 1 * point), (a5 + 1 * point));
        }
        SCATTER(double, a2, args[2], steps[2], steps + 8, 2, 0);
        SCATTER(int32_t, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER(double, a5, args[5], steps[5], NULL, 1, 0);
    }
}

typedef struct {
    const char *name, *signature;
    PyUFuncGenericFunction loop;
    const char *types;
    int inputs, outputs;
} wrapped;

static const wrapped functions[] = {
    {"rigid_stop_spectrum", "(4)->(7),(7,4)", loop_rigid_stop_spectrum,
     types_rigid_stop_spectrum, 1, 2},
    {"rigid_stop_flow_free", "(5),(7),(),(4)->(4)", loop_rigid_stop_flow_free,
     types_rigid_stop_flow_free, 4, 1},
    {"rigid_stop_flow_contact", "(5),(7),(),(4)->(4)", loop_rigid_stop_flow_contact,
     types_rigid_stop_flow_contact, 4, 1},
    {"rigid_stop_fields", "(5)->(8,5)", loop_rigid_stop_fields,
     types_rigid_stop_fields, 1, 1},
    {"rigid_stop_rows", "(5)->(5,5)", loop_rigid_stop_rows,
     types_rigid_stop_rows, 1, 1},
    {"rigid_stop_resets", "(5)->(12,5)", loop_rigid_stop_resets,
     types_rigid_stop_resets, 1, 1},
    {"rigid_stop_modes", "(5),(7)->(5,2),(36,5)", loop_rigid_stop_modes,
     types_rigid_stop_modes, 2, 2},
    {"rigid_stop_one_impact_residual", "(5),(7),(2)->(2)", loop_rigid_stop_one_impact_residual,
     types_rigid_stop_one_impact_residual, 3, 1},
    {"rigid_stop_one_impact_jacobian", "(5),(7),(2)->(2,2)", loop_rigid_stop_one_impact_jacobian,
     types_rigid_stop_one_impact_jacobian, 3, 1},
    {"rigid_stop_one_impact_residual_and_jacobian", "(5),(7),(2)->(2),(2,2)", loop_rigid_stop_one_impact_residual_and_jacobian,
     types_rigid_stop_one_impact_residual_and_jacobian, 3, 2},
    {"rigid_stop_one_impact_parameter_jacobian", "(5),(7),(7,4),(2)->(2,5)", loop_rigid_stop_one_impact_parameter_jacobian,
     types_rigid_stop_one_impact_parameter_jacobian, 4, 1},
    {"rigid_stop_one_impact_poincare_jacobian", "(5),(7),(2)->(3,3)", loop_rigid_stop_one_impact_poincare_jacobian,
     types_rigid_stop_one_impact_poincare_jacobian, 3, 1},
    {"rigid_stop_one_impact_saltations", "(5),(7),(2)->(4,4)", loop_rigid_stop_one_impact_saltations,
     types_rigid_stop_one_impact_saltations, 3, 1},
    {"rigid_stop_one_impact_monodromy", "(5),(7),(2)->(4,4)", loop_rigid_stop_one_impact_monodromy,
     types_rigid_stop_one_impact_monodromy, 3, 1},
    {"rigid_stop_one_impact_trace", "(5),(7),(2)->()", loop_rigid_stop_one_impact_trace,
     types_rigid_stop_one_impact_trace, 3, 1},
    {"rigid_stop_one_impact_trace_gradient", "(5),(7),(7,4),(2)->(7)", loop_rigid_stop_one_impact_trace_gradient,
     types_rigid_stop_one_impact_trace_gradient, 4, 1},
    {"rigid_stop_one_impact_states", "(5),(7),(2)->(2,4)", loop_rigid_stop_one_impact_states,
     types_rigid_stop_one_impact_states, 3, 1},
    {"rigid_stop_one_impact_boundary_functions", "(5),(7),(2)->(6),(2)", loop_rigid_stop_one_impact_boundary_functions,
     types_rigid_stop_one_impact_boundary_functions, 3, 2},
    {"rigid_stop_one_impact_flow_free", "(5),(7),(),(4)->(4)", loop_rigid_stop_one_impact_flow_free,
     types_rigid_stop_one_impact_flow_free, 4, 1},
    {"rigid_stop_one_impact_expand", "(5),(7)->(2),(1)", loop_rigid_stop_one_impact_expand,
     types_rigid_stop_one_impact_expand, 2, 2},
    {"rigid_stop_one_impact_solve", "(5)->(2),(),(),(),()", loop_rigid_stop_one_impact_solve,
     types_rigid_stop_one_impact_solve, 1, 5},
    {"rigid_stop_one_impact_admissible", "(5),(2)->(),(),()", loop_rigid_stop_one_impact_admissible,
     types_rigid_stop_one_impact_admissible, 2, 3},
    {"rigid_stop_one_impact_directions", "(5),(2)->(3,5)", loop_rigid_stop_one_impact_directions,
     types_rigid_stop_one_impact_directions, 2, 1},
    {"elastic_stop_spectrum", "(5)->(12),(12,5)", loop_elastic_stop_spectrum,
     types_elastic_stop_spectrum, 1, 2},
    {"elastic_stop_flow_contact", "(5),(12),(),(4)->(4)", loop_elastic_stop_flow_contact,
     types_elastic_stop_flow_contact, 4, 1},
    {"elastic_stop_flow_free", "(5),(12),(),(4)->(4)", loop_elastic_stop_flow_free,
     types_elastic_stop_flow_free, 4, 1},
    {"elastic_stop_fields", "(5)->(8,5)", loop_elastic_stop_fields,
     types_elastic_stop_fields, 1, 1},
    {"elastic_stop_rows", "(5)->(5,5)", loop_elastic_stop_rows,
     types_elastic_stop_rows, 1, 1},
    {"elastic_stop_resets", "(5)->(4,5)", loop_elastic_stop_resets,
     types_elastic_stop_resets, 1, 1},
    {"elastic_stop_modes", "(5),(12)->(6,2),(40,5)", loop_elastic_stop_modes,
     types_elastic_stop_modes, 2, 2},
    {"elastic_stop_one_contact_residual", "(6),(12),(4)->(4)", loop_elastic_stop_one_contact_residual,
     types_elastic_stop_one_contact_residual, 3, 1},
    {"elastic_stop_one_contact_jacobian", "(6),(12),(4)->(4,4)", loop_elastic_stop_one_contact_jacobian,
     types_elastic_stop_one_contact_jacobian, 3, 1},
    {"elastic_stop_one_contact_residual_and_jacobian", "(6),(12),(4)->(4),(4,4)", loop_elastic_stop_one_contact_residual_and_jacobian,
     types_elastic_stop_one_contact_residual_and_jacobian, 3, 2},
    {"elastic_stop_one_contact_parameter_jacobian", "(6),(12),(12,5),(4)->(4,6)", loop_elastic_stop_one_contact_parameter_jacobian,
     types_elastic_stop_one_contact_parameter_jacobian, 4, 1},
    {"elastic_stop_one_contact_poincare_jacobian", "(6),(12),(4)->(3,3)", loop_elastic_stop_one_contact_poincare_jacobian,
     types_elastic_stop_one_contact_poincare_jacobian, 3, 1},
    {"elastic_stop_one_contact_saltations", "(6),(12),(4)->(8,4)", loop_elastic_stop_one_contact_saltations,
     types_elastic_stop_one_contact_saltations, 3, 1},
    {"elastic_stop_one_contact_monodromy", "(6),(12),(4)->(4,4)", loop_elastic_stop_one_contact_monodromy,
     types_elastic_stop_one_contact_monodromy, 3, 1},
    {"elastic_stop_one_contact_trace", "(6),(12),(4)->()", loop_elastic_stop_one_contact_trace,
     types_elastic_stop_one_contact_trace, 3, 1},
    {"elastic_stop_one_contact_trace_gradient", "(6),(12),(12,5),(4)->(10)", loop_elastic_stop_one_contact_trace_gradient,
     types_elastic_stop_one_contact_trace_gradient, 4, 1},
    {"elastic_stop_one_contact_states", "(6),(12),(4)->(3,4)", loop_elastic_stop_one_contact_states,
     types_elastic_stop_one_contact_states, 3, 1},
    {"elastic_stop_one_contact_boundary_functions", "(6),(12),(4)->(12),(4)", loop_elastic_stop_one_contact_boundary_functions,
     types_elastic_stop_one_contact_boundary_functions, 3, 2},
    {"elastic_stop_one_contact_flow_contact", "(6),(12),(),(4)->(4)", loop_elastic_stop_one_contact_flow_contact,
     types_elastic_stop_one_contact_flow_contact, 4, 1},
    {"elastic_stop_one_contact_flow_free", "(6),(12),(),(4)->(4)", loop_elastic_stop_one_contact_flow_free,
     types_elastic_stop_one_contact_flow_free, 4, 1},
    {"elastic_stop_one_contact_reduced", "(6),(12),(1)->(1),(1,1)", loop_elastic_stop_one_contact_reduced,
     types_elastic_stop_one_contact_reduced, 3, 2},
    {"elastic_stop_one_contact_expand", "(6),(12),(1)->(4),(1)", loop_elastic_stop_one_contact_expand,
     types_elastic_stop_one_contact_expand, 3, 2},
    {"elastic_stop_one_contact_solve", "(6),(1)->(4),(),(),(),()", loop_elastic_stop_one_contact_solve,
     types_elastic_stop_one_contact_solve, 2, 5},
    {"elastic_stop_one_contact_admissible", "(6),(4)->(),(),()", loop_elastic_stop_one_contact_admissible,
     types_elastic_stop_one_contact_admissible, 2, 3},
    {"elastic_stop_one_contact_directions", "(6),(4)->(5,6)", loop_elastic_stop_one_contact_directions,
     types_elastic_stop_one_contact_directions, 2, 1},
    {"dry_friction_spectrum", "(2)->(7),(7,2)", loop_dry_friction_spectrum,
     types_dry_friction_spectrum, 1, 2},
    {"dry_friction_flow_slip_slip", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_slip_slip,
     types_dry_friction_flow_slip_slip, 4, 1},
    {"dry_friction_flow_slip_stick", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_slip_stick,
     types_dry_friction_flow_slip_stick, 4, 1},
    {"dry_friction_flow_slip_overshoot", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_slip_overshoot,
     types_dry_friction_flow_slip_overshoot, 4, 1},
    {"dry_friction_flow_stick_slip", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_stick_slip,
     types_dry_friction_flow_stick_slip, 4, 1},
    {"dry_friction_flow_stick_stick", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_stick_stick,
     types_dry_friction_flow_stick_stick, 4, 1},
    {"dry_friction_flow_stick_overshoot", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_stick_overshoot,
     types_dry_friction_flow_stick_overshoot, 4, 1},
    {"dry_friction_flow_overshoot_slip", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_overshoot_slip,
     types_dry_friction_flow_overshoot_slip, 4, 1},
    {"dry_friction_flow_overshoot_stick", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_overshoot_stick,
     types_dry_friction_flow_overshoot_stick, 4, 1},
    {"dry_friction_flow_overshoot_overshoot", "(7),(7),(),(4)->(4)", loop_dry_friction_flow_overshoot_overshoot,
     types_dry_friction_flow_overshoot_overshoot, 4, 1},
    {"dry_friction_fields", "(7)->(36,5)", loop_dry_friction_fields,
     types_dry_friction_fields, 1, 1},
    {"dry_friction_rows", "(7)->(17,5)", loop_dry_friction_rows,
     types_dry_friction_rows, 1, 1},
    {"dry_friction_resets", "(7)->(16,5)", loop_dry_friction_resets,
     types_dry_friction_resets, 1, 1},
    {"dry_friction_modes", "(7),(7)->(21,2),(152,5)", loop_dry_friction_modes,
     types_dry_friction_modes, 2, 2},
    {"dry_friction_symmetric_residual", "(4),(7),(5)->(5)", loop_dry_friction_symmetric_residual,
     types_dry_friction_symmetric_residual, 3, 1},
    {"dry_friction_symmetric_jacobian", "(4),(7),(5)->(5,5)", loop_dry_friction_symmetric_jacobian,
     types_dry_friction_symmetric_jacobian, 3, 1},
    {"dry_friction_symmetric_residual_and_jacobian", "(4),(7),(5)->(5),(5,5)", loop_dry_friction_symmetric_residual_and_jacobian,
     types_dry_friction_symmetric_residual_and_jacobian, 3, 2},
    {"dry_friction_symmetric_parameter_jacobian", "(4),(7),(7,2),(5)->(5,4)", loop_dry_friction_symmetric_parameter_jacobian,
     types_dry_friction_symmetric_parameter_jacobian, 4, 1},
    {"dry_friction_symmetric_poincare_jacobian", "(4),(7),(5)->(2,2)", loop_dry_friction_symmetric_poincare_jacobian,
     types_dry_friction_symmetric_poincare_jacobian, 3, 1},
    {"dry_friction_symmetric_saltations", "(4),(7),(5)->(8,4)", loop_dry_friction_symmetric_saltations,
     types_dry_friction_symmetric_saltations, 3, 1},
    {"dry_friction_symmetric_monodromy", "(4),(7),(5)->(4,4)", loop_dry_friction_symmetric_monodromy,
     types_dry_friction_symmetric_monodromy, 3, 1},
    {"dry_friction_symmetric_trace", "(4),(7),(5)->()", loop_dry_friction_symmetric_trace,
     types_dry_friction_symmetric_trace, 3, 1},
    {"dry_friction_symmetric_trace_gradient", "(4),(7),(7,2),(5)->(9)", loop_dry_friction_symmetric_trace_gradient,
     types_dry_friction_symmetric_trace_gradient, 4, 1},
    {"dry_friction_symmetric_states", "(4),(7),(5)->(3,4)", loop_dry_friction_symmetric_states,
     types_dry_friction_symmetric_states, 3, 1},
    {"dry_friction_symmetric_boundary_functions", "(4),(7),(5)->(24),(3)", loop_dry_friction_symmetric_boundary_functions,
     types_dry_friction_symmetric_boundary_functions, 3, 2},
    {"dry_friction_symmetric_flow_slip_slip", "(4),(7),(),(4)->(4)", loop_dry_friction_symmetric_flow_slip_slip,
     types_dry_friction_symmetric_flow_slip_slip, 4, 1},
    {"dry_friction_symmetric_flow_slip_stick", "(4),(7),(),(4)->(4)", loop_dry_friction_symmetric_flow_slip_stick,
     types_dry_friction_symmetric_flow_slip_stick, 4, 1},
    {"dry_friction_symmetric_reduced", "(4),(7),(2)->(2),(2,2)", loop_dry_friction_symmetric_reduced,
     types_dry_friction_symmetric_reduced, 3, 2},
    {"dry_friction_symmetric_expand", "(4),(7),(2)->(5),(1)", loop_dry_friction_symmetric_expand,
     types_dry_friction_symmetric_expand, 3, 2},
    {"dry_friction_global_stick_residual", "(5),(7),(6)->(6)", loop_dry_friction_global_stick_residual,
     types_dry_friction_global_stick_residual, 3, 1},
    {"dry_friction_global_stick_jacobian", "(5),(7),(6)->(6,6)", loop_dry_friction_global_stick_jacobian,
     types_dry_friction_global_stick_jacobian, 3, 1},
    {"dry_friction_global_stick_residual_and_jacobian", "(5),(7),(6)->(6),(6,6)", loop_dry_friction_global_stick_residual_and_jacobian,
     types_dry_friction_global_stick_residual_and_jacobian, 3, 2},
    {"dry_friction_global_stick_parameter_jacobian", "(5),(7),(7,2),(6)->(6,5)", loop_dry_friction_global_stick_parameter_jacobian,
     types_dry_friction_global_stick_parameter_jacobian, 4, 1},
    {"dry_friction_global_stick_poincare_jacobian", "(5),(7),(6)->(2,2)", loop_dry_friction_global_stick_poincare_jacobian,
     types_dry_friction_global_stick_poincare_jacobian, 3, 1},
    {"dry_friction_global_stick_saltations", "(5),(7),(6)->(16,4)", loop_dry_friction_global_stick_saltations,
     types_dry_friction_global_stick_saltations, 3, 1},
    {"dry_friction_global_stick_monodromy", "(5),(7),(6)->(4,4)", loop_dry_friction_global_stick_monodromy,
     types_dry_friction_global_stick_monodromy, 3, 1},
    {"dry_friction_global_stick_trace", "(5),(7),(6)->()", loop_dry_friction_global_stick_trace,
     types_dry_friction_global_stick_trace, 3, 1},
    {"dry_friction_global_stick_trace_gradient", "(5),(7),(7,2),(6)->(11)", loop_dry_friction_global_stick_trace_gradient,
     types_dry_friction_global_stick_trace_gradient, 4, 1},
    {"dry_friction_global_stick_states", "(5),(7),(6)->(5,4)", loop_dry_friction_global_stick_states,
     types_dry_friction_global_stick_states, 3, 1},
    {"dry_friction_global_stick_boundary_functions", "(5),(7),(6)->(44),(4)", loop_dry_friction_global_stick_boundary_functions,
     types_dry_friction_global_stick_boundary_functions, 3, 2},
    {"dry_friction_global_stick_flow_stick_stick", "(5),(7),(),(4)->(4)", loop_dry_friction_global_stick_flow_stick_stick,
     types_dry_friction_global_stick_flow_stick_stick, 4, 1},
    {"dry_friction_global_stick_flow_slip_stick", "(5),(7),(),(4)->(4)", loop_dry_friction_global_stick_flow_slip_stick,
     types_dry_friction_global_stick_flow_slip_stick, 4, 1},
    {"dry_friction_global_stick_flow_slip_slip", "(5),(7),(),(4)->(4)", loop_dry_friction_global_stick_flow_slip_slip,
     types_dry_friction_global_stick_flow_slip_slip, 4, 1},
    {"dry_friction_global_stick_flow_stick_slip", "(5),(7),(),(4)->(4)", loop_dry_friction_global_stick_flow_stick_slip,
     types_dry_friction_global_stick_flow_stick_slip, 4, 1},
    {"dry_friction_global_stick_reduced", "(5),(7),(2)->(2),(2,2)", loop_dry_friction_global_stick_reduced,
     types_dry_friction_global_stick_reduced, 3, 2},
    {"dry_friction_global_stick_expand", "(5),(7),(2)->(6)", loop_dry_friction_global_stick_expand,
     types_dry_friction_global_stick_expand, 3, 1},
    {"dry_friction_global_stick_period_map", "(5),(7),(6)->(4),(2),(4,5)", loop_dry_friction_global_stick_period_map,
     types_dry_friction_global_stick_period_map, 3, 3},
    {"dry_friction_solution_ii_residual", "(4),(7),(6)->(6)", loop_dry_friction_solution_ii_residual,
     types_dry_friction_solution_ii_residual, 3, 1},
    {"dry_friction_solution_ii_jacobian", "(4),(7),(6)->(6,6)", loop_dry_friction_solution_ii_jacobian,
     types_dry_friction_solution_ii_jacobian, 3, 1},
    {"dry_friction_solution_ii_residual_and_jacobian", "(4),(7),(6)->(6),(6,6)", loop_dry_friction_solution_ii_residual_and_jacobian,
     types_dry_friction_solution_ii_residual_and_jacobian, 3, 2},
    {"dry_friction_solution_ii_parameter_jacobian", "(4),(7),(7,2),(6)->(6,4)", loop_dry_friction_solution_ii_parameter_jacobian,
     types_dry_friction_solution_ii_parameter_jacobian, 4, 1},
    {"dry_friction_solution_ii_poincare_jacobian", "(4),(7),(6)->(2,2)", loop_dry_friction_solution_ii_poincare_jacobian,
     types_dry_friction_solution_ii_poincare_jacobian, 3, 1},
    {"dry_friction_solution_ii_saltations", "(4),(7),(6)->(16,4)", loop_dry_friction_solution_ii_saltations,
     types_dry_friction_solution_ii_saltations, 3, 1},
    {"dry_friction_solution_ii_monodromy", "(4),(7),(6)->(4,4)", loop_dry_friction_solution_ii_monodromy,
     types_dry_friction_solution_ii_monodromy, 3, 1},
    {"dry_friction_solution_ii_trace", "(4),(7),(6)->()", loop_dry_friction_solution_ii_trace,
     types_dry_friction_solution_ii_trace, 3, 1},
    {"dry_friction_solution_ii_trace_gradient", "(4),(7),(7,2),(6)->(10)", loop_dry_friction_solution_ii_trace_gradient,
     types_dry_friction_solution_ii_trace_gradient, 4, 1},
    {"dry_friction_solution_ii_states", "(4),(7),(6)->(5,4)", loop_dry_friction_solution_ii_states,
     types_dry_friction_solution_ii_states, 3, 1},
    {"dry_friction_solution_ii_boundary_functions", "(4),(7),(6)->(44),(4)", loop_dry_friction_solution_ii_boundary_functions,
     types_dry_friction_solution_ii_boundary_functions, 3, 2},
    {"dry_friction_solution_ii_flow_stick_stick", "(4),(7),(),(4)->(4)", loop_dry_friction_solution_ii_flow_stick_stick,
     types_dry_friction_solution_ii_flow_stick_stick, 4, 1},
    {"dry_friction_solution_ii_flow_slip_stick", "(4),(7),(),(4)->(4)", loop_dry_friction_solution_ii_flow_slip_stick,
     types_dry_friction_solution_ii_flow_slip_stick, 4, 1},
    {"dry_friction_solution_ii_flow_slip_slip", "(4),(7),(),(4)->(4)", loop_dry_friction_solution_ii_flow_slip_slip,
     types_dry_friction_solution_ii_flow_slip_slip, 4, 1},
    {"dry_friction_solution_ii_flow_stick_slip", "(4),(7),(),(4)->(4)", loop_dry_friction_solution_ii_flow_stick_slip,
     types_dry_friction_solution_ii_flow_stick_slip, 4, 1},
    {"dry_friction_solution_ii_reduced", "(4),(7),(3)->(3),(3,3)", loop_dry_friction_solution_ii_reduced,
     types_dry_friction_solution_ii_reduced, 3, 2},
    {"dry_friction_solution_ii_expand", "(4),(7),(3)->(6)", loop_dry_friction_solution_ii_expand,
     types_dry_friction_solution_ii_expand, 3, 1},
    {"dry_friction_solution_ii_period_map", "(4),(7),(6)->(4),(2),(4,5)", loop_dry_friction_solution_ii_period_map,
     types_dry_friction_solution_ii_period_map, 3, 3},
    {"dry_friction_symmetric_solve", "(4),(2)->(5),(),(),(),()", loop_dry_friction_symmetric_solve,
     types_dry_friction_symmetric_solve, 2, 5},
    {"dry_friction_symmetric_admissible", "(4),(5)->(1),(),(),()", loop_dry_friction_symmetric_admissible,
     types_dry_friction_symmetric_admissible, 2, 4},
    {"dry_friction_symmetric_directions", "(4),(5)->(6,4)", loop_dry_friction_symmetric_directions,
     types_dry_friction_symmetric_directions, 2, 1},
    {"dry_friction_global_stick_solve", "(5),(2)->(6),(),(),(),()", loop_dry_friction_global_stick_solve,
     types_dry_friction_global_stick_solve, 2, 5},
    {"dry_friction_global_stick_admissible", "(5),(6)->(2),(),(),()", loop_dry_friction_global_stick_admissible,
     types_dry_friction_global_stick_admissible, 2, 4},
    {"dry_friction_global_stick_directions", "(5),(6)->(7,5)", loop_dry_friction_global_stick_directions,
     types_dry_friction_global_stick_directions, 2, 1},
    {"dry_friction_solution_ii_solve", "(4),(3)->(6),(),(),(),()", loop_dry_friction_solution_ii_solve,
     types_dry_friction_solution_ii_solve, 2, 5},
    {"dry_friction_solution_ii_admissible", "(4),(6)->(2),(),(),()", loop_dry_friction_solution_ii_admissible,
     types_dry_friction_solution_ii_admissible, 2, 4},
};
enum { function_count = sizeof functions / sizeof *functions };
static PyUFuncGenericFunction loops[function_count];
static void *data[function_count];

static int add_all(PyObject *module)
{
    import_array1(-1);
    import_umath1(-1);
    for (int i = 0; i < function_count; ++i) {
        const wrapped *const f = &functions[i];
        loops[i] = f->loop;
        PyObject *const ufunc = PyUFunc_FromFuncAndDataAndSignature(
            &loops[i], &data[i], (char *)f->types, 1, f->inputs, f->outputs, PyUFunc_None, f->name,
            NULL, 0, f->signature);
        if (!ufunc || PyModule_AddObject(module, f->name, ufunc) < 0)
            return -1;
    }
    if (PyModule_AddStringConstant(module, "derivation_rigid_stop", "55586efa21b91602") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_elastic_stop", "113e2b5e94516a32") < 0)
        return -1;
    if (PyModule_AddStringConstant(module, "derivation_dry_friction", "1438dbb9032bd9e6") < 0)
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
