/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support/nonsmooth_admissible_sums.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation a4b74783838526d4 */
/* Boundaries along phases of trigonometric motions: rows of nonsmooth_sums.h. */
#ifndef NONSMOOTH_ADMISSIBLE_SUMS_H
#define NONSMOOTH_ADMISSIBLE_SUMS_H

#include "nonsmooth_admissible.h"
#include "nonsmooth_sums.h"

/* The frequencies of all phases: how many each has, and where they begin. */
typedef struct {
    const int *terms, *first;
    const double *frequencies;
} nonsmooth_phase_sums;

static inline int nonsmooth_sums_length(const void *data, int phase)
{
    return 2 + 2 * ((const nonsmooth_phase_sums *)data)->terms[phase];
}

static inline double nonsmooth_sums_at_end(const void *data, int phase, const double *row,
                                           double duration)
{
    const nonsmooth_phase_sums *const sums = (const nonsmooth_phase_sums *)data;
    return nonsmooth_evaluate(sums->terms[phase], sums->frequencies + sums->first[phase], row,
                              duration)
        .value;
}

static inline double nonsmooth_sums_rounding(const void *data, int phase, const double *row,
                                             double duration)
{
    const nonsmooth_phase_sums *const sums = (const nonsmooth_phase_sums *)data;
    return nonsmooth_rounding(sums->terms[phase], sums->frequencies + sums->first[phase], row,
                              duration);
}

static inline int nonsmooth_sums_rises(const void *data, int phase, const double *row, double noise)
{
    const nonsmooth_phase_sums *const sums = (const nonsmooth_phase_sums *)data;
    return nonsmooth_rises(sums->terms[phase], sums->frequencies + sums->first[phase], row, noise);
}

static inline void nonsmooth_sums_maxima(const void *data, int phase, int count, const double *rows,
                                         double duration, const double *floor, double *maximum,
                                         double *time)
{
    const nonsmooth_phase_sums *const sums = (const nonsmooth_phase_sums *)data;
    nonsmooth_maxima(count, sums->terms[phase], sums->frequencies + sums->first[phase], rows,
                     duration, floor, maximum, time);
}

static NONSMOOTH_INLINE nonsmooth_along nonsmooth_along_sums(const nonsmooth_phase_sums *sums,
                                                             const double *durations,
                                                             const double *rows)
{
    const nonsmooth_along along = {sums,
                                   durations,
                                   rows,
                                   nonsmooth_sums_length,
                                   nonsmooth_sums_at_end,
                                   nonsmooth_sums_rounding,
                                   nonsmooth_sums_rises,
                                   nonsmooth_sums_maxima};
    return along;
}

#endif
