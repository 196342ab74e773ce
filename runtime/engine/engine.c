/* Follow one motion from event to event: cross, choose the transition, reset, go on. */
#include "engine.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "phase.h"

/* Radians of the fastest oscillation; the angle does not round up beyond NONSMOOTH_PHASE_LIMIT. */
static const double LONGEST_WAIT = 1e5 * (1.0 - 4.0 * DBL_EPSILON);
static const double LARGEST_STATE = 1e150; /* its squares are finite */
static const double RESOLUTION = 0x1p-104; /* of the clock: a shorter flight is none */
static const double ZERO = 16.0 * DBL_EPSILON;
static const double GROWTH = 100.0; /* exponent of the largest growth in a window */
static const double LONGEST_QUIET = 32e5 * (1.0 - 1e-9); /* radians of the fastest without event */
static const double FARTHEST = 1e11; /* radians to an end beyond which it is none */
enum { MOST_IMMEDIATE = 100 };

/* A sum of times with its rounding errors. */
typedef struct {
    double high, low;
} long_time;

static long_time later(long_time t, double duration)
{
    const double sum = t.high + duration, part = sum - t.high;
    const double low = t.low + ((t.high - (sum - part)) + (duration - part));
    const double high = sum + low;
    return (long_time){high, low - (high - sum)};
}

/* Coefficients and sizes of the boundary functions of a phase. */
INLINED void
fill_phase(phase *p, const configuration *c, const int n, const double *state,
           const double *magnitude)
{
    const int columns = n + 1;
    const double *row = c->boundary, *size = c->size;
    for (int i = 0; i < c->boundaries * c->functions; ++i, row += columns) {
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
    }
    p->c = c;
    p->state = state;
    p->magnitude = magnitude;
    p->states = n;
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

/* The state at a time of a configuration, and bounds on the sizes of what was summed. */
INLINED void
flow(const configuration *c, const int n, const double *functions, double *state,
     double *magnitude)
{
    const int columns = n + 1;
    double result[MOST_STATES] = {0}, largest = 1.0;
    const double *row = c->flow, *reach = c->reach;
    for (int f = 0; f < c->functions; ++f) {
        const double function = functions[f];
        largest = fabs(function) > largest ? fabs(function) : largest;
        for (int i = 0; i < n; ++i, row += columns) {
            double sum = row[n];
            for (int j = 0; j < n; ++j)
                sum += row[j] * state[j];
            result[i] += function * sum;
        }
    }
    const int simple = c->uniform && c->mode[0].length <= 2; /* only t can pass 1 */
    if ((largest > 1.0 || c->chained) && !simple) { /* each function counts by itself: one may be huge */
        for (int i = 0; i < n; ++i)
            magnitude[i] = 0.0;
        row = c->flow;
        for (int f = 0; f < c->functions; ++f)
            for (int i = 0; i < n; ++i, row += columns)
                magnitude[i] += fabs(functions[f]) * size_of(n, row, state);
    } else {
        const double *drift = c->flow + (size_t)n * columns; /* that of t, if there is one */
        for (int i = 0; i < n; ++i, reach += columns, drift += columns) {
            magnitude[i] = size_of(n, reach, state);
            if (largest > 1.0)
                magnitude[i] += (largest - 1.0) * size_of(n, drift, state);
        }
    }
    for (int i = 0; i < n; ++i)
        state[i] = result[i];
}

INLINED void
reset(const double *matrix, const int n, double *state, double *magnitude)
{
    double result[MOST_STATES], size[MOST_STATES];
    for (int i = 0; i < n; ++i, matrix += n + 1) {
        double sum = matrix[n], sizes = fabs(matrix[n]);
        for (int j = 0; j < n; ++j) {
            sum += matrix[j] * state[j];
            sizes += fabs(matrix[j]) * magnitude[j];
        }
        result[i] = sum;
        size[i] = sizes;
    }
    memcpy(state, result, (size_t)n * sizeof *state);
    memcpy(magnitude, size, (size_t)n * sizeof *magnitude);
}

/* What a state is known to, at an event. */
typedef struct {
    const double *state, *magnitude;
    double time_error;
    double moved[MOST_STATES]; /* change of the state over the error of the time */
} located_state;

/* Whether the first nonzero derivative of a pair's function is positive. The function itself is
 * zero where its boundary was just located. */
INLINED int
rises_first(const tables *t, const int n, int pair, int located, const located_state *at)
{
    const double *state = at->state, *magnitude = at->magnitude;
    const int columns = n + 1;
    const double *row = t->derivative + (size_t)pair * columns * columns;
    const double *size = t->bound + (size_t)pair * columns * columns;
    double value[MOST_STATES + 2];
    for (int k = 0; k < columns; ++k)
        value[k] = HUGE_VAL; /* not yet known */
    for (int k = 0; k < columns; ++k, size += columns) {
        for (int ahead = k; ahead < columns && ahead <= k + 1; ++ahead)
            if (value[ahead] == HUGE_VAL) {
                double sum = row[ahead * columns + n];
                for (int j = 0; j < n; ++j)
                    sum += row[ahead * columns + j] * state[j];
                value[ahead] = sum;
            }
        if (k == 0 && located)
            continue;
        double sizes = size[n];
        for (int j = 0; j < n; ++j)
            sizes += size[j] * magnitude[j];
        double drift = 0.0;
        for (int j = 0; j < n; ++j)
            drift += row[k * columns + j] * at->moved[j];
        const double next = k < n ? at->time_error * fabs(value[k + 1]) : 0.0;
        if (fabs(value[k]) > ZERO * sizes + fmax(next, fabs(drift)))
            return value[k] > 0.0;
    }
    return 0;
}

/* First declared transition that applies; -1 if none does. `located` are the boundaries of the set
 * that are known to be zero. */
INLINED int
choose(const tables *t, const int n, int source, uint32_t set, uint32_t located,
       const double *state, const double *magnitude, double time_error)
{
    const layout *l = t->layout;
    const double *field = t->fields + (size_t)source * n * (n + 1);
    located_state at = {state, magnitude, time_error, {0}};
    for (int i = 0; i < n; ++i, field += n + 1) {
        double rate = field[n];
        for (int j = 0; j < n; ++j)
            rate += field[j] * state[j];
        at.moved[i] = time_error * rate;
    }
    const int32_t *boundary_row = l->boundary_row + l->boundary_start[source];
    for (int i = l->transition_start[source]; i < l->transition_start[source + 1]; ++i) {
        if ((uint32_t)l->transition_set[i] != set)
            continue;
        int applies = 1;
        for (int k = l->condition_start[i]; applies && k < l->condition_start[i + 1]; ++k) {
            const int pair = l->condition_pair[k];
            int is_zero = 0;
            for (uint32_t rest = located; rest; rest &= rest - 1)
                is_zero |= boundary_row[lowest(rest)] == l->pair_row[pair];
            applies = rises_first(t, n, pair, is_zero, &at) == l->condition_holds[k];
        }
        if (applies)
            return i;
    }
    return -1;
}

/* Boundaries of a configuration whose functions are those of a set of another one's. */
static inline uint32_t same_functions(const layout *l, int source, uint32_t set, int target)
{
    const int32_t *row = l->boundary_row + l->boundary_start[target];
    const int count = l->boundary_start[target + 1] - l->boundary_start[target];
    uint32_t found = 0;
    for (; set; set &= set - 1) {
        const int32_t located = l->boundary_row[l->boundary_start[source] + lowest(set)];
        for (int b = 0; b < count; ++b)
            found |= (uint32_t)(row[b] == located) << b;
    }
    return found;
}

static void keep(const record *r, int64_t entry, int n, double time, int configuration,
                 const double *before, const double *state, uint32_t set)
{
    if (r->capacity == 0)
        return;
    const int64_t at = entry % r->capacity;
    r->times[at] = time;
    r->configurations[at] = configuration;
    if (r->states)
        memcpy(r->states + at * n, state, (size_t)n * sizeof *state);
    if (r->before)
        memcpy(r->before + at * n, before, (size_t)n * sizeof *before);
    if (r->sets)
        r->sets[at] = (int32_t)set;
}

static void keep_touches(const record *r, const phase *p, const crossing *event, double time,
                         int configuration, outcome *result)
{
    for (int i = 0; i < p->touches; ++i) {
        const touch *one = &p->touch[i];
        if (event->found && one->time > event->time)
            continue;
        if (result->grazings < r->grazing_capacity) {
            double *entry = r->grazings + 4 * result->grazings;
            entry[0] = time + one->time;
            entry[1] = configuration;
            entry[2] = one->boundary;
            entry[3] = one->depth;
        }
        ++result->grazings;
    }
}

static int is_finite(int n, const double *state)
{
    for (int i = 0; i < n; ++i)
        if (!(fabs(state[i]) < LARGEST_STATE))
            return 0;
    return 1;
}

INLINED outcome
run(const tables *t, const int n, double *state, int32_t *configuration_index, double until,
    int64_t limit, const record *r, const decider *d, patience *patience)
{
    const layout *l = t->layout;
    phase p;
    crossing event;
    double magnitude[MOST_STATES], before[MOST_STATES], last[MOST_STATES];
    long_time now = {0.0, 0.0};
    double waited = 0.0, last_time = 0.0; /* since the last transition, and its time */
    outcome result = {STATUS_TRANSITIONS, 0, 0, 0.0};
    int here = *configuration_index, immediate = 0;
    uint32_t located;
    for (int i = 0; i < n; ++i)
        magnitude[i] = fabs(state[i]);
    keep(r, 0, n, 0.0, here, state, state, 0);
    if (!is_finite(n, state)) {
        result.status = STATUS_OVERFLOW;
        return result;
    }
    p.start = 0.0;
    p.known = 0;
    p.patience = patience;
    p.steps = 0;
    /* Between two transitions there are at most FARTHEST / GROWTH windows; transitions without time
     * between them are MOST_IMMEDIATE at most, and the others as many as the caller allows. */
    while (result.transitions < limit) {
        if (lost(patience)) {
            result.status = STATUS_UNFINISHED;
            break;
        }
        const configuration *c = &t->configuration[here];
        const double left = (until - now.high) - now.low;
        if (!(c->fastest < HUGE_VAL)) {
            result.status = STATUS_OVERFLOW;
            break;
        }
        fill_phase(&p, c, n, state, magnitude);
        p.reached = l->boundary_reached + l->boundary_start[here];
        event.set = phase_begin(&p);
        if (event.set) {
            event.found = 1;
            event.time = 0.0;
            event.time_error = p.start;
            located = event.set & p.zero;
            p.known |= located;
            if (++immediate > MOST_IMMEDIATE + 1) {
                result.status = STATUS_IMMEDIATE;
                break;
            }
            memcpy(before, state, (size_t)n * sizeof *state);
        } else {
            double window = c->fastest > 0.0 ? LONGEST_WAIT / c->fastest : HUGE_VAL;
            if (c->growth * window > GROWTH)
                window = GROWTH / c->growth;
            window = left < window ? left : window;
            if (p.watched)
                event = phase_search(&p, window);
            else
                event.found = 0;
            if (event.found < 0) {
                result.status = patience->ended ? STATUS_UNFINISHED : STATUS_OVERFLOW;
                break;
            }
            keep_touches(r, &p, &event, now.high, here, &result);
            if (!event.found) {
                if (isinf(until) || left * c->fastest > FARTHEST) {
                    if (waited == 0.0) {
                        memcpy(last, state, (size_t)n * sizeof *state);
                        last_time = now.high;
                    }
                    waited += window;
                    /* a product that is no number ends the motion too */
                    if (!p.watched || waited * c->slowest >= LONGEST_WAIT * (1.0 - 1e-9) ||
                        !(waited * c->fastest < LONGEST_QUIET) || !(window < HUGE_VAL)) {
                        memcpy(state, last, (size_t)n * sizeof *state);
                        now = (long_time){last_time, 0.0};
                        result.status = STATUS_QUIET;
                        break;
                    }
                }
                /* the phase goes on from here, or ends with the simulation */
                const double step = window < left ? window : left;
                phase_functions(c, step, event.functions);
                flow(c, n, event.functions, state, magnitude);
                now = later(now, step);
                p.start = 4.0 * DBL_EPSILON * step;
                p.known = 0;
                if (!is_finite(n, state)) {
                    result.status = STATUS_OVERFLOW;
                    break;
                }
                if (step >= left) {
                    now = (long_time){until, 0.0};
                    result.status = STATUS_UNTIL;
                    break;
                }
                continue;
            }
            immediate = 0;
            located = p.known = event.set;
            flow(c, n, event.functions, state, magnitude);
            now = later(now, event.time);
            event.time_error = fmax(event.time_error, RESOLUTION * now.high);
            memcpy(before, state, (size_t)n * sizeof *state);
        }
        if (!is_finite(n, state)) {
            result.status = STATUS_OVERFLOW;
            break;
        }
        const int chosen = choose(t, n, here, event.set, located, state, magnitude,
                                  event.time_error);
        int32_t target, taken;
        if (chosen >= 0) {
            target = l->transition_target[chosen];
            taken = l->transition_reset[chosen];
        } else {
            const int status = d ? d->decide(d->context, here, event.set, state, magnitude,
                                             event.time_error, &target, &taken)
                                 : STATUS_UNDECLARED;
            if (status >= 0) {
                result.status = status;
                break;
            }
        }
        if (taken != 0)
            reset(t->resets + (size_t)taken * n * (n + 1), n, state, magnitude);
        p.known = same_functions(l, here, p.known, target);
        here = target;
        p.steps = 0;
        p.start = event.time_error;
        waited = 0.0;
        keep(r, ++result.transitions, n, now.high, here, before, state, event.set);
    }
    result.end = now.high;
    *configuration_index = here;
    return result;
}

outcome engine_run(const tables *t, double *state, int32_t *configuration, double until,
                   int64_t limit, const record *record, const decider *decider,
                   patience *patience)
{
    /* the sizes of the built-in systems are constants to the compiler */
    switch (t->layout->states) {
    case 2:
        return run(t, 2, state, configuration, until, limit, record, decider,
                   patience);
    case 4:
        return run(t, 4, state, configuration, until, limit, record, decider,
                   patience);
    default:
        return run(t, t->layout->states, state, configuration, until, limit, record, decider,
                   patience);
    }
}
