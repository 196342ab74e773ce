/* One boundary function inside one cell of the search: where it is first zero, and how a boundary
 * on which a phase begins is left. */
#ifndef NONSMOOTH_CELL_H
#define NONSMOOTH_CELL_H

#include "sums.h"

/* Samples of a function: directly, or by the series with which its boundary is left. */
typedef struct {
    const phase *p;
    int boundary, order;    /* 0: directly */
    double error_of_series; /* of the leading coefficient */
} sampler;

/* Value and slope at a time, and the error of the value unless that is NULL. */
sample cell_sample(const sampler *s, double time, double *error);

/* Make the phase's series with which the boundary is left, g^(k)(0)/k! in the configuration's unit
 * of time; the order stays 0 if there is none. */
void cell_leave(sampler *s);

/* Time before which a boundary that is left cannot come back: half of where the bound on the next
 * derivative could undo the leading one. */
double cell_away(const sampler *s, double end);

/* First time in [from, to] at which the boundary is reached, or HUGE_VAL. NAN where nothing can be
 * told: numbers are not finite, no step gets on, or the search is to end. */
double cell_first(phase *p, const sampler *s, double from, double to, double cell_start);

/* Newton's method for a crossing in [low, high], g <= 0 at low and >= 0 at high, kept inside. */
double cell_crossing(const sampler *s, double low, double high, double time);

/* Newton's method for the only crossing in [low, high] of a harmonic configuration, from a good
 * start; leaves the functions at the crossing. HUGE_VAL if it does not converge at once. */
double cell_settled(const phase *p, int b, double low, double high, double time,
                    double *functions);

#endif
