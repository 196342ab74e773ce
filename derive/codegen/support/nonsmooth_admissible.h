/* Is a periodic orbit a motion of the real system? The boundaries along its phases are judged, one
 * phase after another, whatever the functions of time are that describe them. */
#ifndef NONSMOOTH_ADMISSIBLE_H
#define NONSMOOTH_ADMISSIBLE_H

#include <float.h>
#include <math.h>

#include "nonsmooth_compiler.h"

/* What stands in place of the row of a boundary. */
enum {
    NONSMOOTH_IS_ADMISSIBLE = -1, /* none is crossed inside a phase */
    NONSMOOTH_NO_DURATION = -2,   /* a duration is not positive */
    NONSMOOTH_UNDECIDED = -3      /* data not finite, or too large for a guarantee */
};

/* The boundaries of an orbit. */
typedef struct {
    int phases, open;       /* how many phases and open parameters there are */
    const int *counts;      /* boundaries of each phase */
    const int *at_once;     /* whether a phase takes no time */
    const int *exits;       /* where in `rows` the boundary that ends each phase begins */
    const int *opened;      /* open parameter of each boundary, or -1 */
    const int *begins;      /* whether a phase begins on a boundary without an open parameter */
    const double *per_unit; /* by how much a unit of its open parameter lowers a boundary */
} nonsmooth_boundaries;

/* Their functions of time along the phases of one orbit, each given by a row of numbers. */
typedef struct {
    const void *data;
    const double *durations, *rows;
    int (*length)(const void *data, int phase); /* of a row */
    double (*at_end)(const void *data, int phase, const double *row, double duration);
    double (*rounding)(const void *data, int phase, const double *row, double duration);
    int (*rises)(const void *data, int phase, const double *row, double noise);
    void (*maxima)(const void *data, int phase, int count, const double *rows, double duration,
                   const double *floor, double *maximum, double *time);
} nonsmooth_along;

typedef struct {
    int boundary; /* row of the boundary that is crossed, or one of the words above */
    double excess, instant;
} nonsmooth_verdict;

/* The verdict on an orbit whose data have these measures. `work` has four numbers for each boundary
 * of the phase with the most of them; `least` gets, for each open parameter, the least value under
 * which the orbit is a motion. */
static NONSMOOTH_INLINE nonsmooth_verdict nonsmooth_judge(const nonsmooth_boundaries *of,
                                                          const nonsmooth_along *along, int count,
                                                          const double *measures, double *work,
                                                          double *least)
{
    nonsmooth_verdict found = {NONSMOOTH_IS_ADMISSIBLE, 0.0, 0.0};
    const double *rows = along->rows;
    double size = 0.0, missed = 0.0;
    int first = 0;
    /* the rows are differences of the data and carry their rounding */
    for (int i = 0; i < count; ++i)
        size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
    /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
    for (int phase = 0; phase < of->phases; ++phase) {
        const double miss = fabs(along->at_end(along->data, phase, rows + of->exits[phase],
                                               along->durations[phase]));
        missed = miss > missed ? miss : missed;
    }
    const double most_missed = 0x1p-30 * size;
    const double noise = 32.0 * DBL_EPSILON * size +
                         (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
    for (int i = 0; i < of->open; ++i)
        least[i] = 0.0;
    for (int phase = 0; phase < of->phases && found.boundary == NONSMOOTH_IS_ADMISSIBLE; ++phase) {
        const double duration = along->durations[phase];
        const int here = of->counts[phase], length = along->length(along->data, phase);
        double *const usual = work, *const floor = work + here;
        double *const maximum = work + 2 * here, *const time = work + 3 * here;
        if (!(duration > 0.0) && !of->at_once[phase])
            found.boundary = duration <= 0.0 ? NONSMOOTH_NO_DURATION : NONSMOOTH_UNDECIDED;
        for (int i = 0; i < here; ++i) {
            const double *const row = rows + i * length;
            const int opened = of->opened[first + i];
            usual[i] = opened < 0 ? noise + along->rounding(along->data, phase, row, duration)
                                  : least[opened] * of->per_unit[first + i];
            /* a phase that begins on a boundary and rises crosses it, however little */
            const int rises = of->begins[first + i] && duration > 0.0 &&
                              along->rises(along->data, phase, row, noise);
            floor[i] = rises ? -(double)INFINITY : usual[i];
        }
        along->maxima(along->data, phase, here, rows, duration, floor, maximum, time);
        for (int i = 0; i < here && found.boundary == NONSMOOTH_IS_ADMISSIBLE; ++i) {
            const int opened = of->opened[first + i];
            if (!(maximum[i] >= floor[i])) {
                found.boundary = NONSMOOTH_UNDECIDED;
            } else if (maximum[i] > floor[i] && opened >= 0) {
                least[opened] = maximum[i] / of->per_unit[first + i];
            } else if (maximum[i] > floor[i]) {
                found.boundary = first + i;
                found.excess = maximum[i] > 0.0 ? maximum[i] : 0.0;
                found.instant = maximum[i] > usual[i] ? time[i] : 0.0;
            }
        }
        first += here;
        rows += here * length;
    }
    return found;
}

#endif
