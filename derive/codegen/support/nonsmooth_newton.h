/* Newton's method on up to three equations, for lanes side by side. */
#ifndef NONSMOOTH_NEWTON_H
#define NONSMOOTH_NEWTON_H

#include <math.h>
#include <stdint.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_lanes.h"

#define NONSMOOTH_STEP_TOLERANCE 1e-9 /* of the last step: Newton's method squares it */
#define NONSMOOTH_SINGULAR 1e-12      /* a determinant in units of its bound */

/* One step of an unknown, which is made if `open`: whether it is longer than
 * NONSMOOTH_STEP_TOLERANCE max(1, |x|). A positive unknown changes by a factor of four at most. */
static NONSMOOTH_INLINE int nonsmooth_step(int positive, int open, double change, double *unknown)
{
    const double x = *unknown, wanted = x - change;
    const double least = positive ? 0.25 * x : -(double)INFINITY;
    const double most = positive ? 4.0 * x : (double)INFINITY;
    const double next = wanted < least ? least : wanted > most ? most : wanted;
    const double size = fabs(next) > 1.0 ? fabs(next) : 1.0;
    *unknown = open ? next : x;
    return !(fabs(wanted - x) <= NONSMOOTH_STEP_TOLERANCE * size);
}

/* One step of the n unknowns of a lane by Cramer's rule.
 *
 * A lane is open (1) until a whole step is short, then 0: it keeps its values. */
static NONSMOOTH_INLINE void nonsmooth_newton_in_lane(int n, const int *positive, int lane,
                                                      const double *jacobian,
                                                      const double *residual, double *unknown,
                                                      double *open, int32_t *taken)
{
    enum { lanes = NONSMOOTH_LANES };
    const double *const j = jacobian + lane, *const r = residual + lane;
    double *const x = unknown + lane;
    const int moves = open[lane] != 0.0;
    int far;
    if (n == 1)
        far = nonsmooth_step(positive[0], moves, r[0] * (1.0 / j[0]), x);
    else if (n == 2) {
        const double inverse = 1.0 / (j[0] * j[3 * lanes] - j[lanes] * j[2 * lanes]);
        const double first = (j[3 * lanes] * r[0] - j[lanes] * r[lanes]) * inverse;
        const double second = (j[0] * r[lanes] - j[2 * lanes] * r[0]) * inverse;
        far = nonsmooth_step(positive[0], moves, first, x) |
              nonsmooth_step(positive[1], moves, second, x + lanes);
    } else {
        const double a = j[4 * lanes] * j[8 * lanes] - j[5 * lanes] * j[7 * lanes];
        const double b = j[2 * lanes] * j[7 * lanes] - j[lanes] * j[8 * lanes];
        const double c = j[lanes] * j[5 * lanes] - j[2 * lanes] * j[4 * lanes];
        const double d = j[5 * lanes] * j[6 * lanes] - j[3 * lanes] * j[8 * lanes];
        const double e = j[0] * j[8 * lanes] - j[2 * lanes] * j[6 * lanes];
        const double f = j[2 * lanes] * j[3 * lanes] - j[0] * j[5 * lanes];
        const double g = j[3 * lanes] * j[7 * lanes] - j[4 * lanes] * j[6 * lanes];
        const double h = j[lanes] * j[6 * lanes] - j[0] * j[7 * lanes];
        const double i = j[0] * j[4 * lanes] - j[lanes] * j[3 * lanes];
        const double inverse = 1.0 / (j[0] * a + j[lanes] * d + j[2 * lanes] * g);
        const double first = (a * r[0] + b * r[lanes] + c * r[2 * lanes]) * inverse;
        const double second = (d * r[0] + e * r[lanes] + f * r[2 * lanes]) * inverse;
        const double third = (g * r[0] + h * r[lanes] + i * r[2 * lanes]) * inverse;
        far = nonsmooth_step(positive[0], moves, first, x) |
              nonsmooth_step(positive[1], moves, second, x + lanes) |
              nonsmooth_step(positive[2], moves, third, x + 2 * lanes);
    }
    taken[lane] += moves;
    open[lane] = far ? open[lane] : 0.0;
}

/* Whether any lane is open. */
static NONSMOOTH_INLINE int nonsmooth_runs(int lanes, const double *open)
{
    double running = 0.0;
    NONSMOOTH_SIMD_SUM(running)
    for (int lane = 0; lane < lanes; ++lane)
        running += open[lane];
    return running != 0.0;
}

/* Largest of the magnitudes of n entries. */
static NONSMOOTH_INLINE void nonsmooth_largest(int lanes, int n, const double *entries,
                                               double *largest)
{
    for (int lane = 0; lane < lanes; ++lane)
        largest[lane] = 0.0;
    for (int i = 0; i < n; ++i)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double magnitude = fabs(entries[i * lanes + lane]);
            largest[lane] = magnitude > largest[lane] ? magnitude : largest[lane];
        }
}

/* 0 where n entries are numbers, else NaN, is added to `doubt`. */
static NONSMOOTH_INLINE void nonsmooth_doubt(int lanes, int n, const double *entries,
                                             double *doubt)
{
    for (int i = 0; i < n; ++i)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            doubt[lane] += entries[i * lanes + lane] - entries[i * lanes + lane];
}

#endif
