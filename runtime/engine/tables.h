/* A piecewise-linear system as the engine reads it: integers that describe the declaration, and
 * numbers at one parameter point. nonsmooth.runtime.model.engine_layout packs both.
 *
 * The flow of a configuration is y(t) = sum_f phi_f(t) (B_f y(0) + beta_f). The functions phi_f
 * come mode by mode: t^k e^(st) cos(wt), then t^k e^(st) sin(wt) where the mode oscillates, for
 * k = 0, ..., length - 1. The first mode of a configuration is 1, t, ...: s = w = 0. Modes that are
 * joined to the one in front of them, or paired, are those of chain.h.
 *
 * Of a mode that is factored, of length 1 and by itself, the matrix is of rank one or two. With
 * z = v . (y(0), 1) it gives phi u z, or with a sine as well
 * phi_c (u_0 z_0 + u_1 z_1) + phi_s (u_1 z_0 - u_0 z_1): factored.h. */
#ifndef NONSMOOTH_TABLES_H
#define NONSMOOTH_TABLES_H

#include <stddef.h>
#include <stdint.h>

#include "sets.h"

/* The number of states is known to the compiler in the bodies made for it. */
#if defined(__GNUC__)
#define INLINED static inline __attribute__((always_inline))
#else
#define INLINED static inline
#endif

/* Integers; every `start` has one entry more than there are owners. */
typedef struct {
    int states, configurations, rows, resets, modes, functions, boundaries, transitions, pairs;
    int most_modes, most_functions, most_boundaries, most_factored; /* of one configuration */
    int words;                                       /* of a set of boundaries */
    const int32_t *mode_start, *mode_length, *mode_oscillates, *function_start; /* configurations */
    const int32_t *mode_joined, *mode_paired, *mode_factored;
    const int32_t *factored_start; /* functions of factored modes, by configurations */
    const int32_t *boundary_start, *boundary_row, *boundary_reached;
    const int32_t *transition_start, *transition_target, *transition_reset;
    const int32_t *transition_set; /* [transitions][words] */
    const int32_t *condition_start, *condition_pair, *condition_holds; /* of transitions */
    const int32_t *pair_row, *pair_along; /* a function, and the flow that gives its derivatives */
} layout;

/* Per mode. */
typedef struct {
    double rate, frequency;
    double cell_cosine, cell_sine; /* e^(sh) cos(wh), e^(sh) sin(wh): one cell further */
    int length, oscillates, first; /* first function, counted from that of the configuration */
    int joined, paired;            /* of a chain */
    int factored, place;           /* of its first function among those with factors, or without */
    int chain;                     /* modes of the chain that begins here, 0 for none */
} mode;

/* Per configuration. */
typedef struct {
    int modes, functions, boundaries;
    int factored, dense; /* functions with factors, and with matrices */
    int uniform;    /* derivatives are bounded by their amplitudes at every later time */
    int simple;     /* uniform, and no function but t passes 1 */
    int harmonic;   /* nothing but 1, t, cosines and sines */
    int chained;    /* some modes are a chain */
    int polynomial; /* largest power of t where there is no other function, else -1 */
    double fastest, slowest; /* largest |exponent|, smallest that is not zero */
    double growth;  /* largest real exponent, 0 if none is positive */
    double steepest; /* largest absolute value of a real part */
    double cell;    /* length h of a search cell */
    double unit;    /* of time, a power of two near it: that of derivatives of high order */
    const mode *mode;
    const double *flow;     /* [dense][state][states + 1]: B_f, beta_f */
    const double *boundary; /* [boundary][dense][states + 1]: its row times B_f, beta_f */
    const double *weight;   /* [boundary][dense][states + 1]: the same of absolute values */
    const double *size;     /* [boundary][states + 1]: sum of weight over functions of unit 1 */
    const double *reach;    /* [state][states + 1]: sum of |B_f|, |beta_f| over functions of unit
                               1; NULL where some have factors */
    const double *left;     /* [factored][states]: u */
    const double *right;    /* [factored][states + 1]: v */
    const double *across;   /* [boundary][factored + 1]: its row times u, then its constant, or 0
                               if the function 1 has a matrix */
    const double *spread;   /* [boundary][factored + 1]: the same of absolute values */
} configuration;

/* All at one parameter point. */
typedef struct {
    const layout *layout;
    const double *fields; /* [configuration][state][states + 1] */
    const double *resets; /* [reset][state][states + 1] */
    unsigned char *kept;  /* [reset][state]: whether it keeps the state as it is */
    configuration *configuration;
    double *derivative; /* [pair][states + 1][states + 1]: order by order along the flow, in its
                           configuration's unit of time */
    double *bound;      /* the same of absolute values */
    void *memory;
    mode *mode;
} tables;

enum { LAYOUT_HEADER = 11 };

/* Read a packed layout; 0, or -1 if the integers are too few or out of range. */
int layout_read(layout *result, const int32_t *integers, size_t count);

/* Numbers of the flows in front of those of a configuration: its matrices, then u, then v. */
size_t layout_flows(const layout *layout, int configuration);

/* Numbers that a parameter point has; SIZE_MAX if they are more than can be counted. */
size_t layout_numbers(const layout *layout);

/* Sums and products of sizes: SIZE_MAX, of which nothing has room, where they pass it. */
static inline size_t size_sum(size_t a, size_t b)
{
    return a > SIZE_MAX - b ? SIZE_MAX : a + b;
}

static inline size_t size_product(size_t a, size_t b)
{
    return b > 0 && a > SIZE_MAX / b ? SIZE_MAX : a * b;
}

/* Room for the tables of one parameter point; 0, or -1 if there is no memory. */
int tables_create(tables *result, const layout *layout);

/* Fill the tables from the numbers of a parameter point. `numbers` has to stay. */
void tables_fill(tables *tables, const double *numbers);

void tables_free(tables *tables);

#endif
