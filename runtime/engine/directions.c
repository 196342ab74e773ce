/* Derivatives of a periodic orbit and of its linear map, in many directions at once.
 *
 * Dwell times are eliminated phase by phase, as in compose.c: changes of the start and of the
 * parameters are carried through the cycle, and what closure asks of them gives the start's. A
 * second passage carries the linear map. Both take the flows' derivatives from the first. */
#include "directions.h"

#include <math.h>
#include <string.h>

#include "exponential.h"
#include "least_squares.h"

static const double NOTHING = 1e-18;   /* that of compose.c */
static const double CONSISTENT = 1e-7; /* that of nonsmooth.runtime.orbits.directions */

enum { OF_FIELD = 1, OF_ROW = 2, OF_RESET = 4 };

typedef struct {
    double *flow, *moved;                /* (phases, map), (phases, directions, map) */
    double *field, *row, *reset;         /* changes of one phase in one direction */
    double *state, *end, *velocity;
    double *state_moved, *end_moved, *velocity_moved; /* (directions, n), (n), (n) */
    double *changes, *ends, *rate;       /* (n, n + directions), the same, (phases, ...) */
    double *size, *pivot, *unit;
    double *matrix, *kept;               /* (n + 2, n) */
    double *right, *sides;               /* (n + 2, directions) */
    double *step;                        /* (n, directions) */
    double *map, *mapped, *section, *slid; /* (n, n) */
    double *map_moved, *section_moved;   /* (directions, n, n), (n, n) */
    double *turn, *turn_moved;           /* (n) */
    double *scratch;
} arrays;

/* Lay all arrays out; how many doubles they are. Without memory they are counted alone. */
static size_t lay_out(size_t n, size_t phases, size_t directions, double *memory, arrays *a)
{
    enum { COUNT = 31 };
    const size_t map = size_product(n, n + 1), square = size_product(n, n), more = n + 2;
    const size_t wide = size_sum(n, directions), along = size_product(n, directions);
    double **const array[COUNT] = {
        &a->flow,  &a->moved,       &a->field,     &a->row,            &a->reset,   &a->state,
        &a->end,   &a->velocity,    &a->state_moved, &a->end_moved,    &a->velocity_moved,
        &a->changes, &a->ends,      &a->rate,      &a->size,           &a->pivot,   &a->unit,
        &a->matrix, &a->kept,       &a->right,     &a->sides,          &a->step,    &a->map,
        &a->mapped, &a->section,    &a->slid,      &a->map_moved,      &a->section_moved,
        &a->turn,  &a->turn_moved,  &a->scratch};
    const size_t size[COUNT] = {
        size_product(phases, map), size_product(size_product(phases, directions), map),
        map, n + 1, map, n,
        n, n, along, n, n,
        size_product(n, wide), size_product(n, wide), size_product(phases, wide), n, n, n,
        size_product(more, n), size_product(more, n), size_product(more, directions),
        size_product(more, directions), along, square,
        square, square, square, size_product(directions, square), square,
        n, n, exponential_room(n)};
    size_t doubles = 0;
    for (int i = 0; i < COUNT; ++i) {
        if (memory)
            *array[i] = memory + doubles;
        doubles = size_sum(doubles, size[i]);
    }
    return doubles;
}

size_t moving_room(size_t states, size_t phases, size_t directions)
{
    arrays unused;
    return lay_out(states, phases, directions, NULL, &unused);
}

/* A row of an affine map applied to a state. */
INLINED double applied(ptrdiff_t n, const double *row, const double *state)
{
    double sum = row[n];
    for (ptrdiff_t j = 0; j < n; ++j)
        sum += row[j] * state[j];
    return sum;
}

INLINED double product(ptrdiff_t n, const double *row, const double *vector)
{
    double sum = 0.0;
    for (ptrdiff_t j = 0; j < n; ++j)
        sum += row[j] * vector[j];
    return sum;
}

/* after (rows, w) = or += the linear part of a map (rows, n + 1) times before (n, w). */
INLINED void carry(ptrdiff_t rows, ptrdiff_t n, ptrdiff_t w, const double *map,
                   const double *before, int add, double *restrict after)
{
    for (ptrdiff_t i = 0; i < rows; ++i, map += n + 1, after += w) {
        for (ptrdiff_t k = 0; !add && k < w; ++k)
            after[k] = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j) {
            const double factor = map[j], *from = before + j * w;
            if (factor == 0.0)
                continue;
            for (ptrdiff_t k = 0; k < w; ++k)
                after[k] += factor * from[k];
        }
    }
}

/* Which maps of a phase change in a direction, with these changes, and in front of which column of
 * the field nothing does. */
INLINED int gather(ptrdiff_t n, const moving_orbit *o, ptrdiff_t p, ptrdiff_t d, const arrays *a,
                   ptrdiff_t *first)
{
    const ptrdiff_t columns = n + 1, map = n * columns, pair = p * o->directions + d;
    int found = 0;
    *first = n;
    for (int32_t i = o->moving.start[pair]; i < o->moving.start[pair + 1]; ++i) {
        const ptrdiff_t entry = o->moving.entry[i];
        const int kind = entry < map ? OF_FIELD : entry < map + columns ? OF_ROW : OF_RESET;
        double *const to = kind == OF_FIELD ? a->field : kind == OF_ROW ? a->row : a->reset;
        const ptrdiff_t place = entry - (kind == OF_FIELD ? 0 : kind == OF_ROW ? map : map + columns);
        if (!(found & kind))
            memset(to, 0, (size_t)(kind == OF_ROW ? columns : map) * sizeof(double));
        found |= kind;
        to[place] = o->rate[o->moving.rate[i]];
        if (kind == OF_FIELD && place % columns < *first)
            *first = 0;
    }
    return found;
}

/* The first passage: changes behind the cycle, rates of the dwell times, sizes of the states. */
INLINED void pass(ptrdiff_t n, const moving_orbit *o, const arrays *a, patience *patience)
{
    const ptrdiff_t columns = n + 1, map = n * columns, q = o->directions, w = n + q;
    const size_t cost = size_product(32 * (size_t)n, (size_t)map); /* of a flow's derivative */
    memset(a->changes, 0, (size_t)(n * w) * sizeof(double));
    for (ptrdiff_t i = 0; i < n; ++i) {
        a->changes[i * w + i] = 1.0;
        a->state[i] = o->start[i];
        a->size[i] = fabs(a->state[i]);
    }
    for (ptrdiff_t p = 0; p < o->phases; ++p) {
        const double *field = o->field + p * map, *row = o->row + p * columns;
        const double *reset = o->reset + p * map;
        double *flow = a->flow + p * map, *rate = a->rate + p * w, speed = 0.0;
        const expansion found = exponential(n, field, o->dwell[p], flow, a->scratch);
        for (ptrdiff_t i = 0; i < n; ++i)
            a->end[i] = applied(n, flow + i * columns, a->state);
        for (ptrdiff_t i = 0; i < n; ++i) {
            const double velocity = applied(n, field + i * columns, a->end);
            speed += row[i] * velocity;
            a->velocity[i] = velocity;
            a->size[i] = larger(a->size[i], larger(fabs(a->end[i]), fabs(velocity * o->dwell[p])));
        }
        carry(n, n, w, flow, a->changes, 0, a->ends);
        for (ptrdiff_t d = 0; d < q && !lost_after(patience, cost); ++d) {
            ptrdiff_t first;
            const int kinds = gather(n, o, p, d, a, &first);
            double *moved = a->moved + (p * q + d) * map;
            if (kinds & OF_FIELD) {
                exponential_moved(n, a->field, first, moved, &found);
                for (ptrdiff_t i = 0; i < n; ++i)
                    a->ends[i * w + n + d] += applied(n, moved + i * columns, a->state);
            }
            rate[n + d] = kinds & OF_ROW ? applied(n, a->row, a->end) : 0.0;
            for (ptrdiff_t i = 0; i < n; ++i)
                a->state_moved[d * n + i] =
                    kinds & OF_RESET ? applied(n, a->reset + i * columns, a->end) : 0.0;
        }
        for (ptrdiff_t k = 0; k < n; ++k)
            rate[k] = 0.0;
        carry(1, n, w, row, a->ends, 1, rate);
        const double inverse = -1.0 / speed;
        for (ptrdiff_t k = 0; k < w; ++k)
            rate[k] *= inverse;
        for (ptrdiff_t i = 0; i < n; ++i)
            for (ptrdiff_t k = 0; k < w; ++k)
                a->ends[i * w + k] += a->velocity[i] * rate[k];
        carry(n, n, w, reset, a->ends, 0, a->changes);
        for (ptrdiff_t i = 0; i < n; ++i) {
            for (ptrdiff_t d = 0; d < q; ++d)
                a->changes[i * w + n + d] += a->state_moved[d * n + i];
            a->state[i] = applied(n, reset + i * columns, a->end);
            a->size[i] = larger(a->size[i], fabs(a->state[i]));
        }
    }
    double largest = 0.0;
    for (ptrdiff_t i = 0; i < n; ++i)
        largest = larger(largest, a->size[i]);
    for (ptrdiff_t i = 0; i < n; ++i)
        a->size[i] = largest == 0.0 ? 1.0 : larger(a->size[i], NOTHING * largest);
}

/* Sum of the sizes of a row's terms, in units of the states' sizes. */
INLINED double term_sizes(ptrdiff_t n, const double *row, const double *size)
{
    double sum = fabs(row[n]);
    for (ptrdiff_t j = 0; j < n; ++j)
        sum += fabs(row[j]) * size[j];
    return sum;
}

/* Largest relative change of the maps of a cycle in a direction: what closure misses beside it is
 * rounding. */
INLINED double relative_change(ptrdiff_t n, const moving_orbit *o, ptrdiff_t d, const arrays *a)
{
    const ptrdiff_t columns = n + 1, map = n * columns;
    double largest = 0.0;
    for (ptrdiff_t p = 0; p < o->phases; ++p) {
        ptrdiff_t first;
        const int kinds = gather(n, o, p, d, a, &first);
        const struct {
            int kind;
            ptrdiff_t rows;
            const double *value, *change;
        } parts[] = {{OF_FIELD, n, o->field + p * map, a->field},
                     {OF_ROW, 1, o->row + p * columns, a->row},
                     {OF_RESET, n, o->reset + p * map, a->reset}};
        for (int part = 0; part < 3; ++part)
            for (ptrdiff_t i = 0; kinds & parts[part].kind && i < parts[part].rows; ++i) {
                const double whole = term_sizes(n, parts[part].value + i * columns, a->size);
                const double moved = term_sizes(n, parts[part].change + i * columns, a->size);
                largest = whole > 0.0 ? larger(largest, moved / whole) : largest;
            }
    }
    return largest;
}

/* Changes of the start in units of its size, for closure and where it is `timed` the period. The
 * smallest relative pivot; NaN where something is not finite. */
INLINED double solve(ptrdiff_t n, const moving_orbit *o, int timed, const arrays *a, int *order)
{
    const ptrdiff_t q = o->directions, w = n + q;
    ptrdiff_t m = n;
    for (ptrdiff_t i = 0; i < n; ++i) {
        for (ptrdiff_t k = 0; k < n; ++k)
            a->matrix[i * n + k] =
                ((i == k ? 1.0 : 0.0) - a->changes[i * w + k]) * (a->size[k] / a->size[i]);
        for (ptrdiff_t d = 0; d < q; ++d)
            a->right[i * q + d] = a->changes[i * w + n + d] / a->size[i];
    }
    if (timed) {
        double *equation = a->matrix + m * n, *right = a->right + m * q, total = 0.0;
        memset(equation, 0, (size_t)n * sizeof(double));
        memset(right, 0, (size_t)q * sizeof(double));
        for (ptrdiff_t p = 0; p < o->phases; ++p) {
            total += o->dwell[p];
            for (ptrdiff_t k = 0; k < n; ++k)
                equation[k] += a->rate[p * w + k] * a->size[k];
            for (ptrdiff_t d = 0; d < q; ++d)
                right[d] -= a->rate[p * w + n + d];
        }
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] /= total;
        for (ptrdiff_t d = 0; d < q; ++d)
            right[d] /= total;
        ++m;
    }
    if (o->forcing) {
        double *equation = a->matrix + m * n;
        memset(equation, 0, (size_t)n * sizeof(double));
        memset(a->right + m * q, 0, (size_t)q * sizeof(double));
        for (ptrdiff_t k = 0; k < 2; ++k)
            equation[o->forcing[k]] = o->start[o->forcing[k]] * a->size[o->forcing[k]];
        ++m;
    }
    for (ptrdiff_t i = 0; i < m * q; ++i)
        if (!isfinite(a->right[i]))
            return NAN;
    memcpy(a->kept, a->matrix, (size_t)(m * n) * sizeof(double));
    memcpy(a->sides, a->right, (size_t)(m * q) * sizeof(double));
    const least_squares_room room = {order, a->pivot, a->unit};
    const double least = least_squares_of(m, n, q, a->matrix, a->right, a->step, &room);
    for (ptrdiff_t d = 0; d < q; ++d) {
        double missed = 0.0, most = relative_change(n, o, d, a);
        for (ptrdiff_t i = 0; i < m; ++i) {
            double sum = -a->sides[i * q + d], terms = fabs(sum);
            for (ptrdiff_t k = 0; k < n; ++k) {
                const double term = a->kept[i * n + k] * a->step[k * q + d];
                sum += term;
                terms += fabs(term);
            }
            missed = larger(missed, fabs(sum));
            most = larger(most, terms);
        }
        for (ptrdiff_t k = 0; missed > CONSISTENT * most && k < n; ++k)
            a->step[k * q + d] = NAN;
    }
    return least;
}

/* The second passage: the map of the section at the start, and its derivatives. */
INLINED void pass_map(ptrdiff_t n, const moving_orbit *o, const double *dwell, const arrays *a,
                      patience *patience)
{
    const ptrdiff_t columns = n + 1, map = n * columns, q = o->directions;
    const size_t cost = size_product(4 * (size_t)n, (size_t)map);
    memset(a->map, 0, (size_t)(n * n) * sizeof(double));
    memset(a->map_moved, 0, (size_t)(q * n * n) * sizeof(double));
    for (ptrdiff_t i = 0; i < n; ++i) {
        a->map[i * n + i] = 1.0;
        a->state[i] = o->start[i];
    }
    for (ptrdiff_t p = 0; p < o->phases; ++p) {
        const double *field = o->field + p * map, *row = o->row + p * columns;
        const double *reset = o->reset + p * map, *flow = a->flow + p * map;
        double *const turn = a->turn;
        for (ptrdiff_t i = 0; i < n; ++i)
            a->end[i] = applied(n, flow + i * columns, a->state);
        for (ptrdiff_t i = 0; i < n; ++i)
            a->velocity[i] = applied(n, field + i * columns, a->end);
        const double inverse = -1.0 / product(n, row, a->velocity);
        carry(n, n, n, flow, a->map, 0, a->mapped);
        carry(n, n, n, field, a->mapped, 0, a->slid);
        carry(1, n, n, row, a->mapped, 0, turn);
        for (ptrdiff_t k = 0; k < n; ++k)
            turn[k] *= inverse;
        for (ptrdiff_t i = 0; i < n; ++i)
            for (ptrdiff_t k = 0; k < n; ++k)
                a->section[i * n + k] = a->mapped[i * n + k] + a->velocity[i] * turn[k];
        for (ptrdiff_t d = 0; d < q && !lost_after(patience, cost); ++d) {
            ptrdiff_t first;
            const int kinds = gather(n, o, p, d, a, &first);
            const double *moved = a->moved + (p * q + d) * map, wait = dwell[d * o->phases + p];
            double *const state = a->state_moved + d * n, *const own = a->map_moved + d * n * n;
            double *const end = a->end_moved, *const velocity = a->velocity_moved;
            double *const turned = a->turn_moved, *const section = a->section_moved;
            for (ptrdiff_t i = 0; i < n; ++i) {
                end[i] = product(n, flow + i * columns, state) + a->velocity[i] * wait;
                if (kinds & OF_FIELD)
                    end[i] += applied(n, moved + i * columns, a->state);
            }
            for (ptrdiff_t i = 0; i < n; ++i) {
                velocity[i] = product(n, field + i * columns, end);
                if (kinds & OF_FIELD)
                    velocity[i] += applied(n, a->field + i * columns, a->end);
            }
            double speed = product(n, row, velocity);
            if (kinds & OF_ROW)
                speed += product(n, a->row, a->velocity);
            for (ptrdiff_t i = 0; i < n * n; ++i)
                section[i] = a->slid[i] * wait;
            carry(n, n, n, flow, own, 1, section);
            if (kinds & OF_FIELD && first < n)
                carry(n, n, n, moved, a->map, 1, section);
            for (ptrdiff_t k = 0; k < n; ++k)
                turned[k] = turn[k] * speed;
            carry(1, n, n, row, section, 1, turned);
            if (kinds & OF_ROW)
                carry(1, n, n, a->row, a->mapped, 1, turned);
            for (ptrdiff_t k = 0; k < n; ++k)
                turned[k] *= inverse;
            for (ptrdiff_t i = 0; i < n; ++i)
                for (ptrdiff_t k = 0; k < n; ++k)
                    section[i * n + k] += velocity[i] * turn[k] + a->velocity[i] * turned[k];
            carry(n, n, n, reset, section, 0, own);
            for (ptrdiff_t i = 0; i < n; ++i) {
                state[i] = product(n, reset + i * columns, end);
                if (kinds & OF_RESET)
                    state[i] += applied(n, a->reset + i * columns, a->end);
            }
            if (kinds & OF_RESET)
                carry(n, n, n, a->reset, a->section, 1, own);
        }
        carry(n, n, n, reset, a->section, 0, a->map);
        for (ptrdiff_t i = 0; i < n; ++i)
            a->state[i] = applied(n, reset + i * columns, a->end);
    }
}

/* From the map of the section to that at fixed times, of which the forcing keeps the phase. */
INLINED void at_fixed_times(ptrdiff_t n, const moving_orbit *o, const double *starts,
                            const arrays *a)
{
    const ptrdiff_t columns = n + 1;
    const int32_t *const c = o->forcing;
    double *const velocity = a->velocity, *const moved = a->velocity_moved;
    double *const turn = a->turn, *const turned = a->turn_moved;
    for (ptrdiff_t i = 0; i < n; ++i)
        velocity[i] = applied(n, o->field + i * columns, o->start);
    const double one = velocity[c[0]], two = velocity[c[1]];
    const double inverse = -1.0 / (one * one + two * two);
    const double *const cosine = a->map + c[0] * n, *const sine = a->map + c[1] * n;
    for (ptrdiff_t k = 0; k < n; ++k)
        turn[k] = inverse * (one * cosine[k] + two * sine[k]);
    for (ptrdiff_t d = 0; d < o->directions; ++d) {
        ptrdiff_t first;
        const int kinds = gather(n, o, 0, d, a, &first);
        double *const own = a->map_moved + d * n * n;
        for (ptrdiff_t i = 0; i < n; ++i) {
            moved[i] = product(n, o->field + i * columns, starts + d * n);
            if (kinds & OF_FIELD)
                moved[i] += applied(n, a->field + i * columns, o->start);
        }
        const double growth = 2.0 * (one * moved[c[0]] + two * moved[c[1]]);
        for (ptrdiff_t k = 0; k < n; ++k)
            turned[k] = inverse * (moved[c[0]] * cosine[k] + moved[c[1]] * sine[k] +
                                   one * own[c[0] * n + k] + two * own[c[1] * n + k] +
                                   turn[k] * growth);
        for (ptrdiff_t i = 0; i < n; ++i)
            for (ptrdiff_t k = 0; k < n; ++k)
                own[i * n + k] += moved[i] * turn[k] + velocity[i] * turned[k];
    }
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < n; ++k)
            a->map[i * n + k] += velocity[i] * turn[k];
}

INLINED void move(ptrdiff_t n, const moving_orbit *o, const orbit_moves *result, double *room,
                  int *order, patience *patience)
{
    const ptrdiff_t q = o->directions, w = n + q;
    arrays all, *const a = &all;
    lay_out((size_t)n, (size_t)o->phases, (size_t)q, room, a);
    pass(n, o, a, patience);
    double least = solve(n, o, 0, a, order);
    if (o->timed && !(least > LEAST))
        least = solve(n, o, 1, a, order);
    for (ptrdiff_t d = 0; d < q; ++d) {
        for (ptrdiff_t k = 0; k < n; ++k)
            result->start[d * n + k] = least > LEAST ? a->step[k * q + d] * a->size[k] : NAN;
        for (ptrdiff_t p = 0; p < o->phases; ++p)
            result->dwell[d * o->phases + p] =
                a->rate[p * w + n + d] + product(n, a->rate + p * w, result->start + d * n);
    }
    memcpy(a->state_moved, result->start, (size_t)(q * n) * sizeof(double));
    pass_map(n, o, result->dwell, a, patience);
    if (o->forcing)
        at_fixed_times(n, o, result->start, a);
    for (ptrdiff_t d = 0; d < q; ++d) {
        result->trace[d] = 0.0;
        for (ptrdiff_t i = 0; i < n; ++i)
            if (!o->forcing || (i != o->forcing[0] && i != o->forcing[1]))
                result->trace[d] += a->map_moved[d * n * n + i * n + i];
    }
    if (!result->map)
        return;
    memcpy(result->map, a->map, (size_t)(n * n) * sizeof(double));
    memcpy(result->moved, a->map_moved, (size_t)(q * n * n) * sizeof(double));
}

void move_orbit(const moving_orbit *o, const orbit_moves *result, double *room, int *order,
                patience *patience)
{
    switch (o->states) {
    case 2:
        move(2, o, result, room, order, patience);
        break;
    case 4:
        move(4, o, result, room, order, patience);
        break;
    default:
        move(o->states, o, result, room, order, patience);
    }
}
