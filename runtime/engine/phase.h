/* One stay in a configuration: its boundary functions g_b(t) = row . y(t) as sums of the
 * configuration's functions of time, and the guaranteed search for the first crossing. */
#ifndef NONSMOOTH_PHASE_H
#define NONSMOOTH_PHASE_H

#include "patience.h"
#include "tables.h"

/* Orders of the series by which a boundary is left: the leading one and what it needs in a cell. */
enum { SERIES = MOST_STATES + 24 };

/* A boundary touched and not crossed: g is zero within its error until `end`. */
typedef struct {
    double time, depth, end;
    int boundary;
} touch;

enum { MOST_TOUCHES = 256 }; /* of one stay; later ones are not reported */

typedef struct {
    const configuration *c;
    const int32_t *reached; /* boundaries that act when reached */
    const double *state;      /* at the start */
    const double *magnitude;  /* of the sums that gave each state: its error is relative to it */
    double start;             /* error in time of the event that led here */
    int states;
    double value[MOST_BOUNDARIES * MOST_FUNCTIONS]; /* coefficients of g, boundary by boundary */
    double slope[MOST_BOUNDARIES * MOST_FUNCTIONS]; /* of g' */
    double size[MOST_BOUNDARIES];                   /* of the products that make g up */
    double amplitude[MOST_BOUNDARIES];              /* of its oscillations */
    double second[MOST_BOUNDARIES];                 /* bounds on |g''| and |g''''|, if uniform */
    double fourth[MOST_BOUNDARIES];
    uint32_t watched; /* boundaries that can be crossed */
    uint32_t zero;    /* those that hold at the start within its error */
    uint32_t known;   /* those that were located at the instant of the start */
    uint32_t leaving; /* those that hold at the start and are left at once */
    uint32_t slow;    /* those left more slowly than in proportion to the time */
    patience *patience;
    int steps; /* inside the cells of this stay, until a transition ends it */
    int touches;
    touch touch[MOST_TOUCHES];
} phase;

typedef struct {
    int found; /* 1, or 0: none; -1: untold: numbers beyond those that are computed with, or
                it was to end */
    double time;
    uint32_t set;      /* boundaries reached together */
    double time_error; /* of `time` */
    double functions[MOST_FUNCTIONS]; /* of the configuration, at `time` */
} crossing;

/* Order of the first derivative of a boundary's function at the start that is nonzero beyond its
 * error, and its sign; the sign is 0 if none is. */
typedef struct {
    int order, sign;
} beginning;

beginning phase_beginning(const phase *p, int b);

/* Values at `time` of the functions of a configuration, each within a few ulps. */
void phase_functions(const configuration *c, double time, double *functions);

/* Set up a phase of which `c` to `states`, `value` and `size` are filled in; gives the boundaries
 * that are crossed at once. */
uint32_t phase_begin(phase *p);

/* First time in (0, window] at which a boundary is reached; its touches are in the phase. */
crossing phase_search(phase *p, double window);

#endif
