/* A state along the flow of its configuration, and the boundary functions that begin with it. */
#ifndef NONSMOOTH_FLOW_H
#define NONSMOOTH_FLOW_H

#include <math.h>
#include <string.h>

#include "factored.h"
#include "phase.h"

/* Of so few states arrays are in registers, where their number is a constant: 3 % faster. */
enum { FEW = 4 };

/* Coefficients and sizes of the boundary functions of a phase. */
INLINED void
fill_phase(phase *p, const configuration *c, const int n, const double *state,
           const double *magnitude)
{
    const int columns = n + 1;
    const double *row = c->boundary, *size = c->size;
    const size_t products = c->factored ? 0 : (size_t)c->boundaries * (size_t)c->functions;
    for (size_t i = 0; i < products; ++i, row += columns) {
        double sum = row[n];
        for (int j = 0; j < n; ++j)
            sum += row[j] * state[j];
        p->value[i] = sum;
    }
    for (int b = 0; b < c->boundaries; ++b, size += columns) {
        double sum = size[n];
        for (int j = 0; j < n; ++j)
            sum += size[j] * magnitude[j];
        p->size[b] = sum;
        p->drift[b] = 0.0;
        if (c->simple && c->mode[0].length == 2) {
            const double *drift = c->weight + ((size_t)b * (size_t)c->dense + 1) * (size_t)columns;
            sum = drift[n];
            for (int j = 0; j < n; ++j)
                sum += drift[j] * magnitude[j];
            p->drift[b] = sum;
        }
    }
    p->c = c;
    p->state = state;
    p->magnitude = magnitude;
    p->states = n;
    if (c->factored)
        factored_begin(p, n);
    for (int b = 0; b < c->boundaries && !c->simple; ++b)
        phase_sizes(p, b, p->weights + (size_t)b * (size_t)c->functions);
}

/* Sum of absolute values of an affine function's products. */
INLINED double
size_of(const int n, const double *row, const double *state)
{
    double sum = fabs(row[n]);
    for (int j = 0; j < n; ++j)
        sum += fabs(row[j] * state[j]);
    return sum;
}

/* The state at the time of a phase's functions, and bounds on the sizes of what was summed. */
INLINED void
flow(const phase *p, const int n, const double time, double *state, double *magnitude, double *room)
{
    const configuration *c = p->c;
    const double *functions = p->functions;
    const int columns = n + 1;
    double few[FEW], *const result = n <= FEW ? few : room;
    if (!c->simple)
        phase_bounds(c, time, p->bounds);
    if (c->factored) {
        for (int f = 0; f < c->functions && c->simple; ++f)
            p->bounds[f] = f == 1 && c->mode[0].length == 2 ? time : 1.0;
        factored_flow(p, n, functions, p->bounds, result, magnitude);
        memcpy(state, result, (size_t)n * sizeof *state);
        return;
    }
    for (int i = 0; i < n; ++i)
        result[i] = 0.0;
    const double *row = c->flow, *reach = c->reach;
    for (int f = 0; f < c->functions; ++f) {
        const double function = functions[f];
        for (int i = 0; i < n; ++i, row += columns) {
            double sum = row[n];
            for (int j = 0; j < n; ++j)
                sum += row[j] * state[j];
            result[i] += function * sum;
        }
    }
    if (!c->simple) {
        /* each function counts by itself: each has a unit of its own */
        for (int i = 0; i < n; ++i)
            magnitude[i] = 0.0;
        row = c->flow;
        for (int f = 0; f < c->functions; ++f)
            for (int i = 0; i < n; ++i, row += columns)
                magnitude[i] += p->bounds[f] * size_of(n, row, state);
    } else {
        const int drifts = c->mode[0].length == 2;
        const double *drift = c->flow + (size_t)n * columns; /* that of t, if there is one */
        for (int i = 0; i < n; ++i, reach += columns, drift += columns) {
            magnitude[i] = size_of(n, reach, state);
            if (drifts)
                magnitude[i] += time * size_of(n, drift, state);
        }
    }
    for (int i = 0; i < n; ++i)
        state[i] = result[i];
}

#endif
