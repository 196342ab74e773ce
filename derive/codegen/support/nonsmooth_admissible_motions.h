/* Boundaries along phases of any linear motion: rows of nonsmooth_motions.h. */
#ifndef NONSMOOTH_ADMISSIBLE_MOTIONS_H
#define NONSMOOTH_ADMISSIBLE_MOTIONS_H

#include "nonsmooth_admissible.h"
#include "nonsmooth_motions.h"

/* The data are an array of motions, one for each phase. */
static inline int nonsmooth_motions_length(const void *data, int phase)
{
    return ((const nonsmooth_motion *)data)[phase].states + 1;
}

static inline double nonsmooth_motions_at_end(const void *data, int phase, const double *row,
                                              double duration)
{
    const nonsmooth_motion *const motion = (const nonsmooth_motion *)data + phase;
    (void)duration;
    return nonsmooth_value(motion->states, row, motion->end);
}

static inline double nonsmooth_motions_rounding(const void *data, int phase, const double *row,
                                                double duration)
{
    (void)duration;
    return nonsmooth_motion_rounding((const nonsmooth_motion *)data + phase, row);
}

static inline int nonsmooth_motions_rises(const void *data, int phase, const double *row,
                                          double noise)
{
    return nonsmooth_motion_rises((const nonsmooth_motion *)data + phase, row, noise);
}

static inline void nonsmooth_motions_maxima(const void *data, int phase, int count,
                                            const double *rows, double duration,
                                            const double *floor, double *maximum, double *time)
{
    (void)duration;
    nonsmooth_motion_maxima((const nonsmooth_motion *)data + phase, count, rows, floor, maximum,
                            time);
}

static NONSMOOTH_INLINE nonsmooth_along nonsmooth_along_motions(const nonsmooth_motion *motions,
                                                                const double *durations,
                                                                const double *rows)
{
    const nonsmooth_along along = {motions,
                                   durations,
                                   rows,
                                   nonsmooth_motions_length,
                                   nonsmooth_motions_at_end,
                                   nonsmooth_motions_rounding,
                                   nonsmooth_motions_rises,
                                   nonsmooth_motions_maxima};
    return along;
}

#endif
