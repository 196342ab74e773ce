/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation ae6f2baf7aec83c1 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/ndarraytypes.h>
#include <numpy/ufuncobject.h>

#include "dry_friction.h"

enum { points = 64 };

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

static const char types_dry_friction_spectrum[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_spectrum(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 2];
        double a1[points * 7];
        double a2[points * 14];
        GATHER(double, a0, args[0], steps[0], steps + 3, 2, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_spectrum((a0 + 2 * point), (a1 + 7 * point), (a2 + 14 * point));
        SCATTER(double, a1, args[1], steps[1], steps + 4, 7, 0);
        SCATTER(double, a2, args[2], steps[2], steps + 5, 14, 2);
    }
}

static const char types_dry_friction_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_slip_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_slip_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_slip_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_slip_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_slip_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_stick_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_stick_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_stick_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_stick_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_stick_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_overshoot_slip((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_overshoot_stick((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_flow_overshoot_overshoot[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_flow_overshoot_overshoot(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 7];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 7, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_flow_overshoot_overshoot((a0 + 7 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_residual[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_residual(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_residual((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_global_stick_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 36 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 7, 36, 6);
    }
}

static const char types_dry_friction_global_stick_residual_and_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_residual_and_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 6];
        double a4[points * 36];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_residual_and_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 6 * point), (a4 + 36 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 8, 6, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 36, 6);
    }
}

static const char types_dry_friction_global_stick_parameter_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_parameter_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 30];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_parameter_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 30 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 10, 30, 5);
    }
}

static const char types_dry_friction_global_stick_poincare_jacobian[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_poincare_jacobian(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_poincare_jacobian((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 4 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 7, 4, 2);
    }
}

static const char types_dry_friction_global_stick_trace[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_trace(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_trace((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 1 * point));
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
    }
}

static const char types_dry_friction_global_stick_trace_gradient[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_trace_gradient(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 14];
        double a3[points * 6];
        double a4[points * 11];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 14, 2);
        GATHER(double, a3, args[3], steps[3], steps + 9, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_trace_gradient((a0 + 5 * point), (a1 + 7 * point), (a2 + 14 * point), (a3 + 6 * point), (a4 + 11 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 10, 11, 0);
    }
}

static const char types_dry_friction_global_stick_states[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_states(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 20];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_states((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 20 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 7, 20, 4);
    }
}

static const char types_dry_friction_global_stick_boundary_functions[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_boundary_functions(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 6];
        double a3[points * 44];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 6, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_boundary_functions((a0 + 5 * point), (a1 + 7 * point), (a2 + 6 * point), (a3 + 44 * point), (a4 + 4 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 8, 44, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_stick_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_stick_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_flow_stick_stick((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_slip_stick[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_slip_stick(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_flow_slip_stick((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_slip_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_slip_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_flow_slip_slip((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_flow_stick_slip[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_flow_stick_slip(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 1];
        double a3[points * 4];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], NULL, 1, 0);
        GATHER(double, a3, args[3], steps[3], steps + 7, 4, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_flow_stick_slip((a0 + 5 * point), (a1 + 7 * point), *(a2 + 1 * point), (a3 + 4 * point), (a4 + 4 * point));
        SCATTER(double, a4, args[4], steps[4], steps + 8, 4, 0);
    }
}

static const char types_dry_friction_global_stick_reduced[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_reduced(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 2];
        double a4[points * 4];
        GATHER(double, a0, args[0], steps[0], steps + 5, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 6, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 7, 2, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_reduced((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 2 * point), (a4 + 4 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 8, 2, 0);
        SCATTER(double, a4, args[4], steps[4], steps + 9, 4, 2);
    }
}

static const char types_dry_friction_global_stick_expand[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_expand(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 7];
        double a2[points * 2];
        double a3[points * 6];
        GATHER(double, a0, args[0], steps[0], steps + 4, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 5, 7, 0);
        GATHER(double, a2, args[2], steps[2], steps + 6, 2, 0);
        for (npy_intp point = 0; point < here; ++point)
            dry_friction_global_stick_expand((a0 + 5 * point), (a1 + 7 * point), (a2 + 2 * point), (a3 + 6 * point));
        SCATTER(double, a3, args[3], steps[3], steps + 7, 6, 0);
    }
}

static const char types_dry_friction_global_stick_solve[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_INT32};
static void loop_dry_friction_global_stick_solve(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 2];
        double a2[points * 6];
        double a3[points * 1];
        double a4[points * 1];
        int32_t a5[points * 1];
        int32_t a6[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 7, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 8, 2, 0);
        dry_friction_global_stick_solve(here, a0, a1, a2, a3, a4, a5, a6);
        SCATTER(double, a2, args[2], steps[2], steps + 9, 6, 0);
        SCATTER(double, a3, args[3], steps[3], NULL, 1, 0);
        SCATTER(double, a4, args[4], steps[4], NULL, 1, 0);
        SCATTER(int32_t, a5, args[5], steps[5], NULL, 1, 0);
        SCATTER(int32_t, a6, args[6], steps[6], NULL, 1, 0);
    }
}

static const char types_dry_friction_global_stick_admissible[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32, NPY_DOUBLE, NPY_DOUBLE};
static void loop_dry_friction_global_stick_admissible(
    char **args, npy_intp const *dimensions, npy_intp const *steps, void *unused)
{
    (void)unused;
    for (npy_intp start = 0; start < dimensions[0]; start += points) {
        const npy_intp left = dimensions[0] - start;
        const npy_intp here = left < points ? left : points;
        double a0[points * 5];
        double a1[points * 6];
        double a2[points * 2];
        int32_t a3[points * 1];
        double a4[points * 1];
        double a5[points * 1];
        GATHER(double, a0, args[0], steps[0], steps + 6, 5, 0);
        GATHER(double, a1, args[1], steps[1], steps + 7, 6, 0);
        dry_friction_global_stick_admissible(here, a0, a1, a2, a3, a4, a5);
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
    {"dry_friction_global_stick_solve", "(5),(2)->(6),(),(),(),()", loop_dry_friction_global_stick_solve,
     types_dry_friction_global_stick_solve, 2, 5},
    {"dry_friction_global_stick_admissible", "(5),(6)->(2),(),(),()", loop_dry_friction_global_stick_admissible,
     types_dry_friction_global_stick_admissible, 2, 4},
};
enum { function_count = sizeof functions / sizeof *functions };
static PyUFuncGenericFunction loops[function_count];
static void *data[function_count];

static int execute(PyObject *module)
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
    if (PyModule_AddStringConstant(module, "derivation_dry_friction", "589b5b148a78a35d") < 0)
        return -1;
    return 0;
}

static PyModuleDef_Slot slots[] = {{Py_mod_exec, execute}, {0, NULL}};
static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_kernels", "Compiled kernels.", 0, NULL, slots, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__kernels(void)
{
    return PyModuleDef_Init(&definition);
}
