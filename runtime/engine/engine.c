/* Follow one motion from event to event: cross, choose the transition, reset, go on. */
#include "engine.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "flow.h"
#include "engine_limits.h"

/* Radians of the fastest oscillation; the angle does not round up beyond NONSMOOTH_PHASE_LIMIT. */
static const double WINDOW = LONGEST_WAIT * (1.0 - 4.0 * DBL_EPSILON);
static const double RESOLUTION = 0x1p-104; /* of the clock: a shorter flight is none */
static const double ROUNDING = 16.0 * DBL_EPSILON;
static const double TURN = 6.283185307179586;

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

/* `kept`: states that stay as they are, or NULL. */
INLINED void
reset(const double *matrix, const unsigned char *kept, const int n, double *state,
      double *magnitude, double *room)
{
    double few[2 * FEW], *const result = n <= FEW ? few : room, *const size = result + n;
    for (int i = 0; i < n; ++i, matrix += n + 1) {
        if (kept && kept[i]) {
            result[i] = state[i];
            size[i] = magnitude[i];
            continue;
        }
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
    double *moved; /* change of the state over the error of the time */
} located_state;

INLINED double
affine(const int n, const double *row, const double *state)
{
    double sum = row[n];
    for (int j = 0; j < n; ++j)
        sum += row[j] * state[j];
    return sum;
}

/* Whether the first nonzero derivative of a pair's function is positive. The function itself is
 * zero where its boundary was just located. */
INLINED int
rises_first(const tables *t, const int n, int pair, int located, const located_state *at)
{
    const double *state = at->state, *magnitude = at->magnitude;
    const size_t columns = (size_t)n + 1;
    const double *row = t->derivative + (size_t)pair * columns * columns;
    const double *size = t->bound + (size_t)pair * columns * columns;
    const double unit = t->configuration[t->layout->pair_along[pair]].unit;
    double value = affine(n, row, state);
    for (int k = 0; k <= n; ++k, size += columns) {
        row += columns;
        const double following = k < n ? affine(n, row, state) : 0.0;
        if (k > 0 || !located) {
            double sizes = size[n], drift = 0.0;
            for (int j = 0; j < n; ++j)
                sizes += size[j] * magnitude[j];
            const double *own = row - columns;
            for (int j = 0; j < n; ++j)
                drift += own[j] * at->moved[j];
            /* where the configuration has just been entered another field led to the state, of
             * which the one behind the event may tell: the larger change counts */
            const double next = at->time_error * fabs(following) / unit;
            if (fabs(value) > ROUNDING * sizes + fmax(next, fabs(drift)))
                return value > 0.0;
        }
        value = following;
    }
    return 0;
}

/* First declared transition that applies; -1 if none does. `located` are the boundaries of the set
 * that are known to be zero. */
INLINED int
choose(const tables *t, const int n, int source, const uint32_t *set, const uint32_t *located,
       const located_state *at)
{
    const layout *l = t->layout;
    const int words = l->words;
    int moved = 0; /* whether that is known */
    const int32_t *boundary_row = l->boundary_row + l->boundary_start[source];
    for (int i = l->transition_start[source]; i < l->transition_start[source + 1]; ++i) {
        const int32_t *listed = l->transition_set + (size_t)i * (size_t)words;
        int applies = 1;
        for (int k = 0; applies && k < words; ++k)
            applies = (uint32_t)listed[k] == set[k];
        for (int k = l->condition_start[i]; applies && k < l->condition_start[i + 1]; ++k) {
            const int pair = l->condition_pair[k];
            const double *field = t->fields + (size_t)source * (size_t)n * (size_t)(n + 1);
            for (int j = 0; !moved && j < n; ++j, field += n + 1)
                at->moved[j] = at->time_error * affine(n, field, at->state);
            moved = 1;
            int is_zero = 0;
            for (members m = members_of(located, words); next_member(&m);)
                is_zero |= boundary_row[m.member] == l->pair_row[pair];
            applies = rises_first(t, n, pair, is_zero, at) == l->condition_holds[k];
        }
        if (applies)
            return i;
    }
    return -1;
}

/* Make of a set of boundaries that of another configuration's with the same functions. */
static void same_functions(const layout *l, int source, uint32_t *set, int target, uint32_t *spare)
{
    const int32_t *row = l->boundary_row + l->boundary_start[target];
    const int count = l->boundary_start[target + 1] - l->boundary_start[target];
    set_clear(spare, l->words);
    for (members m = members_of(set, l->words); next_member(&m);) {
        const int32_t located = l->boundary_row[l->boundary_start[source] + m.member];
        for (int b = 0; b < count; ++b)
            if (row[b] == located)
                set_put(spare, b);
    }
    set_copy(set, spare, l->words);
}

static void keep(const record *r, int64_t entry, int n, double time, int configuration,
                 const double *before, const double *state, const uint32_t *set, int words)
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
        set_copy(r->sets + at * words, set, words);
}

int engine_create(engine_room *room, const layout *l)
{
    const size_t n = (size_t)l->states;
    room->magnitude = calloc(6 * n, sizeof *room->magnitude);
    room->located = calloc((size_t)l->words, sizeof *room->located);
    if (phase_create(&room->phase, l) != 0 || !room->magnitude || !room->located) {
        engine_free(room);
        return -1;
    }
    room->result = room->magnitude + 3 * n;
    room->moved = room->result + 2 * n;
    return 0;
}

void engine_free(engine_room *room)
{
    phase_free(&room->phase);
    free(room->magnitude);
    free(room->located);
    room->magnitude = NULL;
    room->located = NULL;
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
    int64_t limit, const record *r, const decider *d, engine_room *room, patience *patience)
{
    const layout *l = t->layout;
    const int words = l->words;
    phase *const p = &room->phase;
    crossing event;
    double few[3 * FEW], *const magnitude = n <= FEW ? few : room->magnitude;
    double *const before = magnitude + n, *const last = before + n;
    uint32_t *const located = room->located;
    long_time now = {0.0, 0.0};
    double waited = 0.0, last_time = 0.0; /* since the last transition, and its time */
    outcome result = {STATUS_TRANSITIONS, 0, 0, 0.0};
    int here = *configuration_index, immediate = 0;
    for (int i = 0; i < n; ++i)
        magnitude[i] = fabs(state[i]);
    set_clear(p->event, words);
    set_clear(p->known, words);
    keep(r, 0, n, 0.0, here, state, state, p->event, words);
    if (!is_finite(n, state)) {
        result.status = STATUS_OVERFLOW;
        return result;
    }
    p->start = 0.0;
    p->patience = patience;
    p->steps = 0;
    /* Between two transitions there are at most FARTHEST_END / GROWTH windows; transitions without time
     * between them are MOST_AT_ONCE at most, and the others as many as the caller allows. */
    while (result.transitions < limit) {
        const configuration *c = &t->configuration[here];
        if (lost_after(patience, ((size_t)c->dense * (size_t)n + (size_t)c->factored) * (size_t)n)) {
            result.status = STATUS_UNFINISHED;
            break;
        }
        const double left = (until - now.high) - now.low;
        if (!(c->fastest < HUGE_VAL)) {
            result.status = STATUS_OVERFLOW;
            break;
        }
        fill_phase(p, c, n, state, magnitude);
        p->reached = l->boundary_reached + l->boundary_start[here];
        if (phase_begin(p)) {
            event.found = 1;
            event.time = 0.0;
            event.time_error = p->start;
            set_clear(located, words);
            for (members m = members_of(p->event, words); next_member(&m);)
                if (p->start_of[m.member] & ZERO) {
                    set_put(located, m.member);
                    set_put(p->known, m.member);
                }
            if (++immediate > MOST_AT_ONCE + 1) {
                result.status = STATUS_IMMEDIATE;
                break;
            }
            memcpy(before, state, (size_t)n * sizeof *state);
        } else {
            const int watched = p->watching > 0;
            double window = c->fastest > 0.0 ? WINDOW / c->fastest : HUGE_VAL;
            if (c->growth * window > GROWTH)
                window = GROWTH / c->growth;
            window = left < window ? left : window;
            event.found = 0;
            if (watched)
                event = phase_search(p, window);
            if (event.found < 0) {
                result.status = patience->ended ? STATUS_UNFINISHED : STATUS_OVERFLOW;
                break;
            }
            keep_touches(r, p, &event, now.high, here, &result);
            if (!event.found) {
                if (isinf(until) || left * c->fastest > FARTHEST_END) {
                    if (waited == 0.0) {
                        memcpy(last, state, (size_t)n * sizeof *state);
                        last_time = now.high;
                    }
                    waited += window;
                    if (watched && !(waited * c->fastest < LONGEST_QUIET) &&
                        waited * c->slowest < TURN && window < HUGE_VAL) {
                        result.status = STATUS_OVERFLOW; /* what is slow has hardly begun */
                        break;
                    }
                    /* a product that is no number ends the motion too */
                    if (!watched || waited * c->slowest >= LONGEST_WAIT * (1.0 - 1e-9) ||
                        !(waited * c->fastest < LONGEST_QUIET) || !(window < HUGE_VAL)) {
                        memcpy(state, last, (size_t)n * sizeof *state);
                        now = (long_time){last_time, 0.0};
                        result.status = STATUS_QUIET;
                        break;
                    }
                }
                /* the phase goes on from here, or ends with the simulation */
                const double step = window < left ? window : left;
                phase_functions(c, step, p->functions);
                flow(p, n, step, state, magnitude, room->result);
                now = later(now, step);
                p->start = 4.0 * DBL_EPSILON * step;
                set_clear(p->known, words);
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
            set_copy(located, p->event, words);
            set_copy(p->known, p->event, words);
            flow(p, n, event.time, state, magnitude, room->result);
            now = later(now, event.time);
            event.time_error = fmax(event.time_error, RESOLUTION * now.high);
            memcpy(before, state, (size_t)n * sizeof *state);
        }
        if (!is_finite(n, state)) {
            result.status = STATUS_OVERFLOW;
            break;
        }
        double few_moved[FEW], *const moved = n <= FEW ? few_moved : room->moved;
        const located_state at = {state, magnitude, event.time_error, moved};
        const int chosen = choose(t, n, here, p->event, located, &at);
        int32_t target, taken;
        if (chosen >= 0) {
            target = l->transition_target[chosen];
            taken = l->transition_reset[chosen];
        } else {
            const int status = d ? d->decide(d->context, here, p->event, state, magnitude,
                                             event.time_error, &target, &taken)
                                 : STATUS_UNDECLARED;
            if (status >= 0) {
                result.status = status;
                break;
            }
        }
        if (taken != 0)
            reset(t->resets + (size_t)taken * (size_t)n * (size_t)(n + 1),
                  l->most_factored ? t->kept + (size_t)taken * (size_t)n : NULL, n, state, magnitude,
                  room->result);
        same_functions(l, here, p->known, target, p->spare);
        here = target;
        p->steps = 0;
        p->start = event.time_error;
        waited = 0.0;
        keep(r, ++result.transitions, n, now.high, here, before, state, p->event,
             words);
    }
    result.end = now.high;
    *configuration_index = here;
    return result;
}

outcome engine_run(const tables *t, double *state, int32_t *configuration, double until,
                   int64_t limit, const record *record, const decider *decider,
                   engine_room *room, patience *patience)
{
    /* the sizes of the built-in systems are constants to the compiler */
    switch (t->layout->states) {
    case 2:
        return run(t, 2, state, configuration, until, limit, record, decider, room, patience);
    case 4:
        return run(t, 4, state, configuration, until, limit, record, decider, room, patience);
    default:
        return run(t, t->layout->states, state, configuration, until, limit, record, decider, room,
                   patience);
    }
}
