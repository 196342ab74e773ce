/* Flows of affine fields, and their derivatives by parameters that the field depends on. */
#ifndef NONSMOOTH_EXPONENTIAL_H
#define NONSMOOTH_EXPONENTIAL_H

#include <stddef.h>

/* What is kept of a flow for its derivatives, in the room that it was found in. */
typedef struct {
    int halvings; /* negative where there is no flow */
    double step;
    double *unit, *kept;
} expansion;

/* Doubles that `exponential` works with, of so many states. */
size_t exponential_room(size_t states);

/* Flow of y' = A y + b over a time, by scaling, Taylor's series and squaring.
 *
 * field (n, n + 1): A, then b. flow (n, n + 1): matrix and constant; NaN where numbers are not
 * finite, or beyond those that it is told for. */
expansion exponential(ptrdiff_t n, const double *field, double time, double *flow, double *room);

/* Derivative of a flow along a change (n, n + 1) of its field, whose columns in front of `first`
 * are zero. */
void exponential_moved(ptrdiff_t n, const double *change, ptrdiff_t first, double *moved,
                       const expansion *flow);

#endif
