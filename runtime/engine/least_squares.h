/* Few linear equations in the sense of least squares, rank revealing. */
#ifndef NONSMOOTH_LEAST_SQUARES_H
#define NONSMOOTH_LEAST_SQUARES_H

#include <float.h>
#include <math.h>

#include "tables.h"

/* Relative pivot below which equations are dependent. */
static const double LEAST = 1e-10;

/* A NaN that comes second is passed over. */
INLINED double larger(double a, double b)
{
    return b > a ? b : a;
}

INLINED double smaller(double a, double b)
{
    return b < a ? b : a;
}

/* Room for n unknowns. */
typedef struct {
    int *order;
    double *pivot, *unit;
} least_squares_room;

/* Solutions x (n, sides) of m >= n equations in the sense of least squares for right-hand sides
 * b (m, sides), by Householder reflections with column pivoting; what is not determined stays 0.
 * The smallest relative pivot; NaN where something is not finite. */
INLINED double least_squares_of(ptrdiff_t m, ptrdiff_t n, ptrdiff_t sides, double *a, double *b,
                                double *x, const least_squares_room *room)
{
    int *const order = room->order;
    double *const pivot = room->pivot, first = 0.0, least = 1.0;
    ptrdiff_t rank = 0;
    for (ptrdiff_t j = 0; j < n; ++j)
        order[j] = (int)j;
    for (ptrdiff_t k = 0; k < n; ++k) {
        double best = -1.0;
        ptrdiff_t chosen = k;
        for (ptrdiff_t j = k; j < n; ++j) {
            double sum = 0.0;
            for (ptrdiff_t i = k; i < m; ++i)
                sum += a[i * n + j] * a[i * n + j];
            if (!(sum <= DBL_MAX))
                return NAN;
            if (sum > best) {
                best = sum;
                chosen = j;
            }
        }
        const double norm = sqrt(best);
        if (k == 0)
            first = norm;
        const double relative = first > 0.0 ? norm / first : 0.0;
        least = relative < least ? relative : least;
        if (!(relative > LEAST))
            break;
        if (chosen != k) {
            for (ptrdiff_t i = 0; i < m; ++i) {
                const double kept = a[i * n + k];
                a[i * n + k] = a[i * n + chosen];
                a[i * n + chosen] = kept;
            }
            const int place = order[k];
            order[k] = order[chosen];
            order[chosen] = place;
        }
        const double head = a[k * n + k];
        const double alpha = head > 0.0 ? -norm : norm;
        a[k * n + k] = head - alpha;
        const double scale = 1.0 / (alpha * (head - alpha)); /* -2 / |v|^2 */
        for (ptrdiff_t j = k + 1; j < n; ++j) {
            double sum = 0.0;
            for (ptrdiff_t i = k; i < m; ++i)
                sum += a[i * n + k] * a[i * n + j];
            sum *= scale;
            for (ptrdiff_t i = k; i < m; ++i)
                a[i * n + j] += sum * a[i * n + k];
        }
        for (ptrdiff_t s = 0; s < sides; ++s) {
            double sum = 0.0;
            for (ptrdiff_t i = k; i < m; ++i)
                sum += a[i * n + k] * b[i * sides + s];
            sum *= scale;
            for (ptrdiff_t i = k; i < m; ++i)
                b[i * sides + s] += sum * a[i * n + k];
        }
        pivot[k] = alpha;
        ++rank;
    }
    for (ptrdiff_t k = n - 1; k >= 0; --k) {
        for (ptrdiff_t s = 0; s < sides; ++s) {
            double sum = k < rank ? b[k * sides + s] : 0.0;
            for (ptrdiff_t j = k + 1; j < rank; ++j)
                sum -= a[k * n + j] * x[order[j] * sides + s];
            x[order[k] * sides + s] = k < rank ? sum / pivot[k] : 0.0;
        }
    }
    return least;
}

/* The same for one right-hand side. */
INLINED double least_squares(ptrdiff_t m, ptrdiff_t n, double *a, double *b, double *x,
                             const least_squares_room *room)
{
    return least_squares_of(m, n, 1, a, b, x, room);
}

/* The same of `switches` equations of switching and n of closure, in no units: each in units of
 * the largest of its terms, each unknown in units of its largest coefficient. */
INLINED double balanced_least_squares(ptrdiff_t switches, ptrdiff_t n, double *a, double *b,
                                      double *x, const least_squares_room *room)
{
    double *const unit = room->unit;
    for (ptrdiff_t k = 0; k < n; ++k)
        unit[k] = 0.0;
    for (ptrdiff_t i = 0; i < switches + n; ++i) {
        double size = 0.0;
        for (ptrdiff_t k = 0; k < n; ++k) {
            const double one = i - switches == k ? 1.0 : 0.0;
            size = larger(size, fabs(a[i * n + k] - one) + one);
        }
        const double scale = size > 0.0 ? 1.0 / size : 1.0;
        for (ptrdiff_t k = 0; k < n; ++k) {
            a[i * n + k] *= scale;
            unit[k] = larger(unit[k], fabs(a[i * n + k]));
        }
        b[i] *= scale;
    }
    for (ptrdiff_t k = 0; k < n; ++k)
        unit[k] = unit[k] > 0.0 ? 1.0 / unit[k] : 1.0;
    for (ptrdiff_t i = 0; i < switches + n; ++i)
        for (ptrdiff_t k = 0; k < n; ++k)
            a[i * n + k] *= unit[k];
    const double least = least_squares(switches + n, n, a, b, x, room);
    for (ptrdiff_t k = 0; k < n; ++k)
        x[k] *= unit[k];
    return least;
}

#endif
