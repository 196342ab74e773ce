/* Periodic orbits of an itinerary, by Newton's method on the start and the dwell times at once.
 *
 * Phase by phase the switching condition, linearised, gives the change of the dwell time as an
 * affine function of that of the start; what is left is closure, as many equations as states.
 * So a cycle costs its length times a constant, and its linear map is the Poincare map's. */
#ifndef NONSMOOTH_COMPOSE_H
#define NONSMOOTH_COMPOSE_H

#include "patience.h"
#include "tables.h"

/* Phase by phase, with the last transition leading back to the first phase. */
typedef struct {
    int phases;
    const int32_t *configuration, *row, *reset;
    const int32_t *forcing; /* states c and s with c^2 + s^2 = 1, or NULL */
} cycle;

/* The numbers of nonsmooth.runtime.shooting.newton. */
enum {
    COMPOSE_CONVERGED = 0,
    COMPOSE_STALLED = 1,
    COMPOSE_INVALID = 2,
    COMPOSE_NEGATIVE = 3,
    COMPOSE_SINGULAR = 5,
};

/* Room for one cycle of one layout. */
typedef struct {
    double *memory, *flow, *rate, *matrix, *right;
    double *block, *ends;            /* (states, states + 2) */
    double *size, *velocity, *step;  /* of each state */
    double *pivot, *unit;            /* of least squares */
    int *order;
} compose_room;

int compose_create(compose_room *room, const layout *l, int phases);
void compose_free(compose_room *room);

/* What one solve gives beside dwell times and states. */
typedef struct {
    double residual; /* largest absolute value of closure and switching */
    int iterations, status;
} composed;

/* Solve at one parameter point.
 *
 * period: the sum of the dwell times, or NaN if that is free.
 * guided: whether `starts` begins with a guess of the first; else the dwell times give one.
 * dwell (phases): guess, then result. starts (phases * states): the state at each phase's start.
 * map (states * states): derivative of the start behind one period by the start.
 * Whether to go on is asked phase by phase. */
composed compose_solve(const layout *l, const cycle *cycle, const double *numbers,
                       double period, int guided, double *dwell, double *starts, double *map,
                       compose_room *room, patience *patience);

#endif
