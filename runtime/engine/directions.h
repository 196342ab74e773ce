/* How a periodic orbit moves with the parameters of its system. */
#ifndef NONSMOOTH_DIRECTIONS_H
#define NONSMOOTH_DIRECTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "patience.h"

/* Which entries of the maps of a cycle change, phase by phase and within a phase direction by
 * direction; `start` has one entry more than there are pairs of both. An entry is counted through
 * the field (n, n + 1), the row (n + 1) and the reset (n, n + 1) of its phase, and `rate` is the
 * place of its derivative among those of a point. */
typedef struct {
    const int32_t *start, *entry, *rate;
} moving_entries;

/* An orbit at one point: affine maps phase by phase, fields and resets (n, n + 1), rows (n + 1). */
typedef struct {
    ptrdiff_t states, phases, directions;
    const double *field, *row, *reset;
    const double *dwell, *start; /* of each phase; of the first one */
    moving_entries moving;
    const double *rate;
    const int32_t *forcing; /* states c and s with c^2 + s^2 = 1, or NULL */
    int timed;              /* where it is one of a family: its period stays what it is */
} moving_orbit;

/* Its derivatives; NaN where there are none. */
typedef struct {
    double *dwell; /* (directions, phases) */
    double *start; /* (directions, n) */
    double *trace; /* (directions), over the states that are no forcing's */
    double *map;   /* (n, n), on the section at the start, with a forcing at fixed times; NULL
                      where it is not asked for, as what is next */
    double *moved; /* (directions, n, n) */
} orbit_moves;

/* Doubles that `move_orbit` works with. */
size_t moving_room(size_t states, size_t phases, size_t directions);

/* Differentiate an orbit. `order` has room for as many integers as there are states. Whether to go
 * on is asked direction by direction. */
void move_orbit(const moving_orbit *orbit, const orbit_moves *result, double *room, int *order,
                patience *patience);

#endif
