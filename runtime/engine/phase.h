/* One stay in a configuration: its boundary functions g_b(t) = row . y(t) as sums of the
 * configuration's functions of time, and the guaranteed search for the first crossing. */
#ifndef NONSMOOTH_PHASE_H
#define NONSMOOTH_PHASE_H

#include "patience.h"
#include "tables.h"

/* A boundary touched and not crossed: g is zero within its error until `end`. */
typedef struct {
    double time, depth, end;
    int boundary;
} touch;

enum { MOST_TOUCHES = 256 }; /* of one stay; later ones are not reported */

typedef struct {
    double value, slope;
} sample;

/* A boundary's function in one cell of the search: at its ends, errors, and a bound on the fourth
 * derivative. */
typedef struct {
    sample left, right;
    double base, slack, drift, bound;
} cell_ends;

/* The start of a boundary's function. */
enum {
    ZERO = 1,    /* it holds within its error */
    LEAVING = 2, /* it holds and is left at once */
    SLOW = 4,    /* more slowly than in proportion to the time */
};

/* One stay, in memory that serves all stays of a run. The arrays have an entry for each boundary
 * or each function of the largest configuration, the sets a bit for each boundary. */
typedef struct {
    const configuration *c;
    const int32_t *reached;  /* boundaries that act when reached */
    const double *state;     /* at the start */
    const double *magnitude; /* of the sums that gave each state: its error is relative to it */
    double start;            /* error in time of the event that led here */
    int states, words;
    double *value;           /* coefficients of g, boundary by boundary */
    double *slope;           /* of g' */
    double *size;            /* of the products that make g up at the start */
    double *drift;           /* of those with t, if simple */
    double *weights;         /* of those with each function, if not simple */
    double *amplitude;       /* of its oscillations */
    double *second, *fourth; /* bounds on |g''| and |g''''|, if uniform */
    unsigned char *start_of; /* ZERO, LEAVING and SLOW, where they are so */
    int *watched;            /* boundaries that can be crossed, rising */
    int watching;            /* how many they are */
    uint32_t *known;         /* the set that was located at the instant of the start */
    uint32_t *event;         /* the set that is reached together */
    double *functions;       /* of the configuration, at the event */
    double *bounds;          /* on their absolute values */
    double *projected;       /* v . (y, 1) of each factor, at the start */
    double *projected_size;  /* of the products that make it up */
    patience *patience;
    int steps; /* inside the cells of this stay, until a transition ends it */
    int touches;
    touch touch[MOST_TOUCHES];
    /* what the search works with */
    int orders;      /* of the series by which a boundary is left */
    double *series;  /* [orders] */
    double *sampled; /* functions at the time of one sample */
    double *scratch; /* four times as many, of one function's derivatives */
    double *waves;   /* at the end of a cell: [2] of each mode, and [2] of each function */
    cell_ends *ends; /* of each boundary's function */
    int *suspect;
    uint32_t *spare, *sets;
    void *memory;
} phase;

typedef struct {
    int found; /* 1, or 0: none; -1: untold: numbers beyond those that are computed with, or
                  it was to end */
    double time;
    double time_error; /* of `time` */
} crossing;

/* Room for the phases of a system; 0, or -1 if there is no memory. */
int phase_create(phase *p, const layout *layout);

void phase_free(phase *p);

/* Order of the first derivative of a boundary's function at the start that is nonzero beyond its
 * error, and its sign; the sign is 0 if none is. */
typedef struct {
    int order, sign;
} beginning;

beginning phase_beginning(const phase *p, int b);

/* Values at `time` of the functions of a configuration, each within a few ulps. */
void phase_functions(const configuration *c, double time, double *functions);

/* Bounds on their absolute values at `time`. */
void phase_bounds(const configuration *c, double time, double *bounds);

/* Sizes of the products that make up the coefficient of each function of a boundary. */
void phase_sizes(const phase *p, int b, double *sizes);

/* Set up a phase of which `c` to `states`, `value` and `size` are filled in; whether boundaries
 * are crossed at once, which then are its event. */
int phase_begin(phase *p);

/* First time in (0, window] at which a boundary is reached; the event, its functions and what was
 * touched before are in the phase. */
crossing phase_search(phase *p, double window);

#endif
