/* The shooting map of a chain of phases, and its derivatives by dwell times, start and a parameter. */
#ifndef NONSMOOTH_SHOOTING_H
#define NONSMOOTH_SHOOTING_H

#include <stddef.h>

/* Affine maps of each phase: field and reset (n, n + 1), row (n + 1). The first three are
 * (phases, ...); the others are their derivatives by a parameter, or NULL. */
typedef struct {
    ptrdiff_t states, phases;
    const double *field, *row, *reset, *field_change, *row_change, *reset_change;
} chain_of_phases;

/* Where the results go; unknowns are the dwell times, the start, and the parameter if there is one. */
typedef struct {
    double *starts;      /* (phases + 1, n), of which the first is given */
    double *ends;        /* (phases, n) */
    double *velocities;  /* (phases, n), at the ends */
    double *residual;    /* (phases): boundary functions at the ends */
    double *slopes;      /* (phases, unknowns): their derivatives */
    double *variational; /* (n, unknowns): derivative of the state behind the chain */
} shot;

size_t shooting_room(size_t states, size_t unknowns);

void shoot(const chain_of_phases *chain, const double *dwell, const shot *result, double *room);

#endif
