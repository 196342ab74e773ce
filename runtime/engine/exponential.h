/* Flows of affine fields, and their derivative by a parameter that the field depends on. */
#ifndef NONSMOOTH_EXPONENTIAL_H
#define NONSMOOTH_EXPONENTIAL_H

#include <stddef.h>

/* Doubles that `exponential` works with, of so many states. */
size_t exponential_room(size_t states);

/* Flow of y' = A y + b over a time, by scaling, Taylor's series and squaring.
 *
 * field (n, n + 1): A, then b. change: its derivative by a parameter, or NULL.
 * flow (n, n + 1): matrix and constant; moved: their derivative, if `change` is given.
 * NaN where numbers are not finite, or beyond those that it is told for. */
void exponential(ptrdiff_t n, const double *field, const double *change, double time, double *flow,
                 double *moved, double *room);

#endif
