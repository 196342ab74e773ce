/* Newton's method on the start and the dwell times of an itinerary, over many points. */
#include "compose.h"

#include <math.h>
#include <stdlib.h>

#include "chain.h"
#include "least_squares.h"
#include "nonsmooth_trigonometry.h"

/* The numbers of nonsmooth.runtime.shooting.table_newton. */
static const double TOLERANCE = 1e-9; /* of the last step, which Newton's method squares */
static const double MOST_RESIDUAL = 1e-9;
static const double NOTHING = 1e-18; /* of the largest state: rounding of rounding is smaller */
static const double SHORTEST = 1e-6; /* in units of the period: on the way to no time at all */
enum { MOST_ITERATIONS = 32 };

/* Of so few states arrays are in registers, where their number is a constant. */
enum { FEW = 4 };

int compose_create(compose_room *room, const layout *l, int phases)
{
    enum { ARRAYS = 11 };
    const size_t n = (size_t)l->states, p = (size_t)phases;
    const size_t wide = size_product(n, n + 2);
    double **const array[ARRAYS] = {&room->flow,  &room->rate, &room->matrix,   &room->right,
                                    &room->block, &room->ends, &room->size,     &room->velocity,
                                    &room->step,  &room->pivot, &room->unit};
    const size_t size[ARRAYS] = {size_product(p, wide), size_product(p, n + 1),
                                 size_product(p + n + 1, n), p + n + 1, wide, wide, n, n, n, n, n};
    size_t doubles = 0;
    for (int i = 0; i < ARRAYS; ++i)
        doubles = size_sum(doubles, size[i]);
    *room = (compose_room){.memory = calloc(doubles, sizeof(double)),
                           .order = calloc(n, sizeof(int))};
    if (!room->memory || !room->order) {
        compose_free(room);
        return -1;
    }
    double *at = room->memory;
    for (int i = 0; i < ARRAYS; ++i) {
        *array[i] = at;
        at += size[i];
    }
    return 0;
}

void compose_free(compose_room *room)
{
    free(room->memory);
    free(room->order);
    room->memory = NULL;
    room->order = NULL;
}

/* The numbers of one parameter point, by kind. */
typedef struct {
    const double *fields, *rows, *resets, *exponents, *flows;
} point;

static point point_of(const layout *l, const double *numbers)
{
    const size_t n = (size_t)l->states, columns = n + 1;
    point found = {.fields = numbers};
    found.rows = found.fields + (size_t)l->configurations * n * columns;
    found.resets = found.rows + (size_t)l->rows * columns;
    found.exponents = found.resets + (size_t)l->resets * n * columns;
    found.flows = found.exponents + 2 * (size_t)l->modes;
    return found;
}

/* Modes of the chain that begins at a mode, 0 if none does. */
static inline int chain_from(const layout *l, int m, int end)
{
    int next = m + 1;
    while (next < end && l->mode_joined[next])
        ++next;
    return next > m + 1 || l->mode_paired[m] ? next - m : 0;
}

/* Add the functions of a chain times their matrices; gives what follows those. */
static const double *add_chain(size_t size, const layout *l, const point *at, int first, int count,
                               double time, const double *part, double *flow)
{
    mode modes[MOST_POLES];
    double functions[2 * MOST_POLES];
    int function = 0;
    for (int i = 0; i < count; ++i) {
        const int m = first + i;
        modes[i] = (mode){.rate = at->exponents[2 * m],
                          .frequency = at->exponents[2 * m + 1],
                          .length = l->mode_length[m],
                          .oscillates = l->mode_oscillates[m],
                          .first = function,
                          .joined = l->mode_joined[m],
                          .paired = l->mode_paired[m]};
        function += modes[i].length << modes[i].oscillates;
    }
    chain_functions(modes, count, time, functions);
    for (int f = 0; f < function; ++f, part += size)
        for (size_t i = 0; i < size; ++i)
            flow[i] += functions[f] * part[i];
    return part;
}

/* Add a mode that has factors: of n states, with the places of its u and v. */
static void add_factors(ptrdiff_t n, const double *left, const double *right, int oscillates,
                        double cosine, double sine, double *flow)
{
    for (ptrdiff_t i = 0; i < n; ++i, flow += n + 1) {
        if (!oscillates) {
            for (ptrdiff_t j = 0; j <= n; ++j)
                flow[j] += cosine * left[i] * right[j];
            continue;
        }
        const double one = cosine * left[i] + sine * left[n + i];
        const double two = cosine * left[n + i] - sine * left[i];
        for (ptrdiff_t j = 0; j <= n; ++j)
            flow[j] += one * right[j] + two * right[n + 1 + j];
    }
}

/* flow (n, n + 1) of a configuration at a time: matrix and constant. */
INLINED void flow_at(ptrdiff_t n, const layout *l, const point *at, int c, double time,
                     double *flow)
{
    const size_t size = (size_t)n * (size_t)(n + 1);
    const int factored = l->factored_start[c + 1] - l->factored_start[c];
    const int dense = l->function_start[c + 1] - l->function_start[c] - factored;
    const double *part = at->flows + layout_flows(l, c);
    const double *left = part + (size_t)dense * size, *right = left + (size_t)factored * (size_t)n;
    for (size_t i = 0; i < size; ++i)
        flow[i] = 0.0;
    for (int m = l->mode_start[c]; m < l->mode_start[c + 1]; ++m) {
        const int chain = chain_from(l, m, l->mode_start[c + 1]);
        if (chain > 0) {
            part = add_chain(size, l, at, m, chain, time, part, flow);
            m += chain - 1;
            continue;
        }
        const double rate = at->exponents[2 * m], frequency = at->exponents[2 * m + 1];
        double power = rate == 0.0 ? 1.0 : exp(rate * time);
        double sine = 0.0, cosine = 1.0;
        if (l->mode_oscillates[m])
            nonsmooth_sincos(frequency * time, &sine, &cosine);
        if (l->mode_factored[m]) {
            const int oscillates = l->mode_oscillates[m];
            add_factors(n, left, right, oscillates, power * cosine, power * sine, flow);
            left += n << oscillates;
            right += (n + 1) << oscillates;
            continue;
        }
        for (int k = 0; k < l->mode_length[m]; ++k) {
            const double even = power * cosine, odd = power * sine;
            if (l->mode_oscillates[m]) {
                for (size_t i = 0; i < size; ++i)
                    flow[i] += even * part[i] + odd * part[size + i];
                part += 2 * size;
            } else {
                for (size_t i = 0; i < size; ++i)
                    flow[i] += even * part[i];
                part += size;
            }
            power *= time;
        }
    }
}

/* after (n, w) = the matrix of an affine map (n, n + 1) times before; its constant is added to
 * the last column. */
INLINED void apply(ptrdiff_t n, ptrdiff_t w, const double *map, const double *before,
                   double *restrict after)
{
    for (ptrdiff_t i = 0; i < n; ++i, map += n + 1, after += w) {
        const double *from = before;
        for (ptrdiff_t k = 0; k < w; ++k)
            after[k] = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j, from += w) {
            const double factor = map[j];
            for (ptrdiff_t k = 0; k < w; ++k)
                after[k] += factor * from[k];
        }
        after[w - 1] += map[n];
    }
}

INLINED void identity(ptrdiff_t n, ptrdiff_t w, double *block)
{
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < w; ++k)
            block[i * w + k] = i == k ? 1.0 : 0.0;
}

/* The start that fits given dwell times best: closure and switching are linear in it. */
INLINED double start_of(ptrdiff_t n, const cycle *c, const point *at, compose_room *room,
                        double *start)
{
    const ptrdiff_t w = n + 1, count = c->phases;
    const least_squares_room scratch = {room->order, room->pivot, room->unit};
    double *const from = room->block, *const to = room->ends;
    identity(n, w, from);
    for (ptrdiff_t i = 0; i < count; ++i) {
        const double *row = at->rows + c->row[i] * w;
        double *equation = room->matrix + i * n, right = -row[n];
        apply(n, w, room->flow + i * n * w, from, to);
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j) {
            for (ptrdiff_t k = 0; k < n; ++k)
                equation[k] += row[j] * to[j * w + k];
            right -= row[j] * to[j * w + n];
        }
        room->right[i] = right;
        apply(n, w, at->resets + c->reset[i] * n * w, to, from);
    }
    for (ptrdiff_t i = 0; i < n; ++i) {
        double *equation = room->matrix + (count + i) * n;
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] = (i == k ? 1.0 : 0.0) - from[i * w + k];
        room->right[count + i] = from[i * w + n];
    }
    return balanced_least_squares(count, n, room->matrix, room->right, start, &scratch);
}

/* One passage of the cycle and its linearisation. */
typedef struct {
    double *size;  /* of each state along the cycle */
    double *block; /* map, its constant, the state at the end */
    double residual, relative;
} passage;

INLINED void pass(ptrdiff_t n, const cycle *c, const point *at, const double *dwell, double *starts,
                  compose_room *room, passage *result)
{
    const ptrdiff_t w = n + 2, columns = n + 1;
    double *const ends = room->ends, *const block = result->block, sum_of_all = 0.0;
    double *const velocity = room->velocity;
    identity(n, w, block);
    for (ptrdiff_t i = 0; i < n; ++i) {
        block[i * w + n + 1] = starts[i];
        result->size[i] = fabs(starts[i]);
    }
    result->residual = result->relative = 0.0;
    for (ptrdiff_t i = 0; i < c->phases; ++i) {
        const double *row = at->rows + c->row[i] * columns;
        const double *field = at->fields + (size_t)(c->configuration[i] * n * columns);
        double *rate = room->rate + i * columns;
        double speed = 0.0, gap = row[n], scale = fabs(row[n]);
        for (ptrdiff_t j = 0; j < n; ++j)
            starts[i * n + j] = block[j * w + n + 1];
        apply(n, w, room->flow + i * n * columns, block, ends);
        for (ptrdiff_t k = 0; k < columns; ++k)
            rate[k] = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j) {
            const double state = ends[j * w + n + 1];
            double sum = field[j * columns + n];
            for (ptrdiff_t k = 0; k < n; ++k)
                sum += field[j * columns + k] * ends[k * w + n + 1];
            velocity[j] = sum;
            speed += row[j] * sum;
            gap += row[j] * state;
            scale += fabs(row[j]) * larger(fabs(state), fabs(sum * dwell[i]));
            for (ptrdiff_t k = 0; k < columns; ++k)
                rate[k] -= row[j] * ends[j * w + k];
            result->size[j] = larger(result->size[j], larger(fabs(state), fabs(sum * dwell[i])));
        }
        rate[n] -= gap;
        const double inverse = 1.0 / speed;
        for (ptrdiff_t k = 0; k < columns; ++k)
            rate[k] *= inverse;
        for (ptrdiff_t j = 0; j < n; ++j)
            for (ptrdiff_t k = 0; k < columns; ++k)
                ends[j * w + k] += velocity[j] * rate[k];
        sum_of_all += gap;
        result->residual = larger(result->residual, fabs(gap));
        result->relative = larger(result->relative, scale > 0.0 ? fabs(gap) / scale : 0.0);
        apply(n, w, at->resets + c->reset[i] * n * columns, ends, block);
    }
    double largest = 0.0;
    for (ptrdiff_t j = 0; j < n; ++j)
        largest = larger(largest, result->size[j]);
    for (ptrdiff_t j = 0; j < n; ++j) {
        /* a state that decays to zero by itself has no size of its own */
        result->size[j] = largest == 0.0 ? 1.0 : larger(result->size[j], NOTHING * largest);
        const double gap = fabs(block[j * w + n + 1] - starts[j]);
        sum_of_all += gap;
        result->residual = larger(result->residual, gap);
        result->relative = larger(result->relative, gap / result->size[j]);
    }
    if (isnan(sum_of_all)) /* which larger() passes over */
        result->residual = NAN;
}

/* Newton's step of the start in units of its size; the smallest relative pivot. */
INLINED double step_of(ptrdiff_t n, const cycle *c, const double *start, double missing,
                       double total, compose_room *room, const passage *now, double *step)
{
    const ptrdiff_t w = n + 2, columns = n + 1;
    const int timed = !isnan(missing);
    for (ptrdiff_t i = 0; i < n; ++i) {
        for (ptrdiff_t k = 0; k < n; ++k)
            room->matrix[i * n + k] =
                ((i == k ? 1.0 : 0.0) - now->block[i * w + k]) * (now->size[k] / now->size[i]);
        room->right[i] =
            (now->block[i * w + n + 1] - start[i] + now->block[i * w + n]) / now->size[i];
    }
    if (timed) {
        double *equation = room->matrix + n * n, right = missing;
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (ptrdiff_t i = 0; i < c->phases; ++i) {
            for (ptrdiff_t k = 0; k < n; ++k)
                equation[k] += room->rate[i * columns + k];
            right -= room->rate[i * columns + n];
        }
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] *= now->size[k] / total;
        room->right[n] = right / total;
    }
    ptrdiff_t equations = timed ? n + 1 : n;
    if (c->forcing) {
        double *equation = room->matrix + equations * n, right = 0.5;
        for (ptrdiff_t k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (ptrdiff_t k = 0; k < 2; ++k) {
            const int state = c->forcing[k];
            equation[state] = start[state] * now->size[state];
            right -= 0.5 * start[state] * start[state];
        }
        room->right[equations++] = right;
    }
    const least_squares_room scratch = {room->order, room->pivot, room->unit};
    return least_squares(equations, n, room->matrix, room->right, step, &scratch);
}

INLINED composed solve(ptrdiff_t n, const layout *l, const cycle *c, const double *numbers,
                       double period, int guided, double *dwell, double *starts, double *map,
                       compose_room *memory, patience *patience)
{
    double few[2 * FEW * (FEW + 2)];
    int few_places[FEW];
    compose_room own = *memory, *const room = &own;
    if (n <= FEW) {
        own.block = few;
        own.ends = few + n * (n + 2);
        own.order = few_places;
    }
    const point at = point_of(l, numbers);
    const ptrdiff_t columns = n + 1, w = n + 2, count = c->phases;
    composed result = {.residual = NAN, .iterations = 0, .status = COMPOSE_STALLED};
    double *const step = room->step, least = 1.0;
    passage now = {.size = room->size, .block = room->block};
    for (;;) {
        double total = 0.0;
        for (ptrdiff_t i = 0; i < count; ++i) {
            flow_at(n, l, &at, c->configuration[i], dwell[i], room->flow + i * n * columns);
            total += dwell[i];
            if (lost_after(patience, (size_t)n * (size_t)n * (size_t)n))
                return result;
        }
        if (result.iterations == 0 && !guided)
            least = start_of(n, c, &at, room, starts);
        pass(n, c, &at, dwell, starts, room, &now);
        result.residual = now.residual;
        if (isnan(least) || !(now.residual <= DBL_MAX)) {
            result.status = COMPOSE_INVALID;
            break;
        }
        if (result.status == COMPOSE_CONVERGED || result.iterations == MOST_ITERATIONS)
            break;
        ++result.iterations;
        least = step_of(n, c, starts, period - total, total, room, &now, step);
        double largest = 0.0, fraction = 1.0;
        for (ptrdiff_t j = 0; j < n; ++j)
            largest = larger(largest, fabs(step[j]));
        for (ptrdiff_t i = 0; i < count; ++i) {
            double change = room->rate[i * columns + n];
            for (ptrdiff_t k = 0; k < n; ++k)
                change += room->rate[i * columns + k] * (now.size[k] * step[k]);
            room->rate[i * columns] = change;
            largest = larger(largest, fabs(change) / total);
            if (change < -0.75 * dwell[i])
                fraction = smaller(fraction, 0.75 * dwell[i] / -change);
            else if (change > 3.0 * dwell[i])
                fraction = smaller(fraction, 3.0 * dwell[i] / change);
        }
        for (ptrdiff_t j = 0; j < n; ++j)
            starts[j] += fraction * (now.size[j] * step[j]);
        for (ptrdiff_t i = 0; i < count; ++i)
            dwell[i] += fraction * room->rate[i * columns];
        if (fraction == 1.0 && largest <= TOLERANCE)
            result.status = COMPOSE_CONVERGED;
    }
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < n; ++k)
            map[i * n + k] = now.block[i * w + k];
    double total = 0.0, shortest = INFINITY;
    for (ptrdiff_t i = 0; i < count; ++i) {
        total += dwell[i];
        shortest = smaller(shortest, dwell[i]);
    }
    if (result.status == COMPOSE_CONVERGED)
        result.status = !(now.relative <= MOST_RESIDUAL) ? COMPOSE_STALLED
                        : !(least > LEAST)               ? COMPOSE_SINGULAR
                                                         : COMPOSE_CONVERGED;
    if (result.status == COMPOSE_STALLED && shortest < SHORTEST * total)
        result.status = COMPOSE_NEGATIVE;
    return result;
}

composed compose_solve(const layout *l, const cycle *c, const double *numbers, double period,
                       int guided, double *dwell, double *starts, double *map, compose_room *room,
                       patience *patience)
{
    switch (l->states) {
    case 2:
        return solve(2, l, c, numbers, period, guided, dwell, starts, map, room, patience);
    case 4:
        return solve(4, l, c, numbers, period, guided, dwell, starts, map, room, patience);
    default:
        return solve(l->states, l, c, numbers, period, guided, dwell, starts, map, room, patience);
    }
}
