/* Newton's method on the start and the dwell times of an itinerary, over many points. */
#include "compose.h"

#include <math.h>
#include <stdlib.h>

#include "chain.h"
#include "least_squares.h"
#include "support.h"

/* The numbers of nonsmooth.runtime.shooting.table_newton. */
static const double TOLERANCE = 1e-9; /* of the last step, which Newton's method squares */
static const double MOST_RESIDUAL = 1e-9;
static const double SHORTEST = 1e-6; /* in units of the period: on the way to no time at all */
enum { MOST_ITERATIONS = 32 };

int compose_create(compose_room *room, const layout *l, int phases)
{
    const size_t n = (size_t)l->states, p = (size_t)phases;
    const size_t flow = p * n * (n + 1), rate = p * (n + 1), matrix = (p + n + 1) * n;
    double *memory = calloc(flow + rate + matrix + p + n + 1, sizeof *memory);
    *room = (compose_room){.memory = memory};
    if (!memory)
        return -1;
    room->flow = memory;
    room->rate = room->flow + flow;
    room->matrix = room->rate + rate;
    room->right = room->matrix + matrix;
    return 0;
}

void compose_free(compose_room *room)
{
    free(room->memory);
    room->memory = NULL;
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
static const double *add_chain(int size, const layout *l, const point *at, int first, int count,
                               double time, const double *part, double *flow)
{
    mode modes[MOST_POLES];
    double functions[MOST_FUNCTIONS];
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
        for (int i = 0; i < size; ++i)
            flow[i] += functions[f] * part[i];
    return part;
}

/* flow (n, n + 1) of a configuration at a time: matrix and constant. */
INLINED void flow_at(int n, const layout *l, const point *at, int c, double time, double *flow)
{
    const int size = n * (n + 1);
    const double *part = at->flows + (size_t)l->function_start[c] * (size_t)size;
    for (int i = 0; i < size; ++i)
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
        for (int k = 0; k < l->mode_length[m]; ++k) {
            const double even = power * cosine, odd = power * sine;
            if (l->mode_oscillates[m]) {
                for (int i = 0; i < size; ++i)
                    flow[i] += even * part[i] + odd * part[size + i];
                part += 2 * size;
            } else {
                for (int i = 0; i < size; ++i)
                    flow[i] += even * part[i];
                part += size;
            }
            power *= time;
        }
    }
}

/* after (n, w) = the matrix of an affine map (n, n + 1) times before; its constant is added to
 * the last column. */
INLINED void apply(int n, int w, const double *map, const double *before, double *after)
{
    for (int i = 0; i < n; ++i) {
        double *row = after + i * w;
        for (int k = 0; k < w; ++k)
            row[k] = 0.0;
        for (int j = 0; j < n; ++j) {
            const double factor = map[i * (n + 1) + j];
            for (int k = 0; k < w; ++k)
                row[k] += factor * before[j * w + k];
        }
        row[w - 1] += map[i * (n + 1) + n];
    }
}

INLINED void identity(int n, int w, double *block)
{
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < w; ++k)
            block[i * w + k] = i == k ? 1.0 : 0.0;
}

/* The start that fits given dwell times best: closure and switching are linear in it. */
INLINED double start_of(int n, const cycle *c, const point *at, compose_room *room, double *start)
{
    const int w = n + 1, count = c->phases;
    double from[MOST_STATES * (MOST_STATES + 1)], to[MOST_STATES * (MOST_STATES + 1)];
    identity(n, w, from);
    for (int i = 0; i < count; ++i) {
        const double *row = at->rows + c->row[i] * w;
        double *equation = room->matrix + i * n, right = -row[n];
        apply(n, w, room->flow + i * n * w, from, to);
        for (int k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k)
                equation[k] += row[j] * to[j * w + k];
            right -= row[j] * to[j * w + n];
        }
        room->right[i] = right;
        apply(n, w, at->resets + c->reset[i] * n * w, to, from);
    }
    for (int i = 0; i < n; ++i) {
        double *equation = room->matrix + (count + i) * n;
        for (int k = 0; k < n; ++k)
            equation[k] = (i == k ? 1.0 : 0.0) - from[i * w + k];
        room->right[count + i] = from[i * w + n];
    }
    return balanced_least_squares(count, n, room->matrix, room->right, start);
}

/* One passage of the cycle and its linearisation. */
typedef struct {
    double size[MOST_STATES];                  /* of each state along the cycle */
    double block[MOST_STATES * (MOST_STATES + 2)]; /* map, its constant, the state at the end */
    double residual, relative;
} passage;

INLINED void pass(int n, const cycle *c, const point *at, const double *dwell, double *starts,
                  compose_room *room, passage *result)
{
    const int w = n + 2, columns = n + 1;
    double ends[MOST_STATES * (MOST_STATES + 2)], *block = result->block, sum_of_all = 0.0;
    identity(n, w, block);
    for (int i = 0; i < n; ++i) {
        block[i * w + n + 1] = starts[i];
        result->size[i] = fabs(starts[i]);
    }
    result->residual = result->relative = 0.0;
    for (int i = 0; i < c->phases; ++i) {
        const double *row = at->rows + c->row[i] * columns;
        const double *field = at->fields + (size_t)(c->configuration[i] * n * columns);
        double *rate = room->rate + i * columns;
        double speed = 0.0, gap = row[n], scale = fabs(row[n]), velocity[MOST_STATES];
        for (int j = 0; j < n; ++j)
            starts[i * n + j] = block[j * w + n + 1];
        apply(n, w, room->flow + i * n * columns, block, ends);
        for (int k = 0; k < columns; ++k)
            rate[k] = 0.0;
        for (int j = 0; j < n; ++j) {
            const double state = ends[j * w + n + 1];
            double sum = field[j * columns + n];
            for (int k = 0; k < n; ++k)
                sum += field[j * columns + k] * ends[k * w + n + 1];
            velocity[j] = sum;
            speed += row[j] * sum;
            gap += row[j] * state;
            scale += fabs(row[j]) * larger(fabs(state), fabs(sum * dwell[i]));
            for (int k = 0; k < columns; ++k)
                rate[k] -= row[j] * ends[j * w + k];
            result->size[j] = larger(result->size[j], larger(fabs(state), fabs(sum * dwell[i])));
        }
        rate[n] -= gap;
        const double inverse = 1.0 / speed;
        for (int k = 0; k < columns; ++k)
            rate[k] *= inverse;
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < columns; ++k)
                ends[j * w + k] += velocity[j] * rate[k];
        sum_of_all += gap;
        result->residual = larger(result->residual, fabs(gap));
        result->relative = larger(result->relative, scale > 0.0 ? fabs(gap) / scale : 0.0);
        apply(n, w, at->resets + c->reset[i] * n * columns, ends, block);
    }
    for (int j = 0; j < n; ++j) {
        if (result->size[j] == 0.0)
            result->size[j] = 1.0;
        const double gap = fabs(block[j * w + n + 1] - starts[j]);
        sum_of_all += gap;
        result->residual = larger(result->residual, gap);
        result->relative = larger(result->relative, gap / result->size[j]);
    }
    if (isnan(sum_of_all)) /* which larger() passes over */
        result->residual = NAN;
}

/* Newton's step of the start in units of its size; the smallest relative pivot. */
INLINED double step_of(int n, const cycle *c, const double *start, double missing, double total,
                       compose_room *room, const passage *now, double *step)
{
    const int w = n + 2, columns = n + 1, timed = !isnan(missing);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k)
            room->matrix[i * n + k] =
                ((i == k ? 1.0 : 0.0) - now->block[i * w + k]) * (now->size[k] / now->size[i]);
        room->right[i] =
            (now->block[i * w + n + 1] - start[i] + now->block[i * w + n]) / now->size[i];
    }
    if (timed) {
        double *equation = room->matrix + n * n, right = missing;
        for (int k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (int i = 0; i < c->phases; ++i) {
            for (int k = 0; k < n; ++k)
                equation[k] += room->rate[i * columns + k];
            right -= room->rate[i * columns + n];
        }
        for (int k = 0; k < n; ++k)
            equation[k] *= now->size[k] / total;
        room->right[n] = right / total;
    }
    int equations = timed ? n + 1 : n;
    if (c->forcing) {
        double *equation = room->matrix + equations * n, right = 0.5;
        for (int k = 0; k < n; ++k)
            equation[k] = 0.0;
        for (int k = 0; k < 2; ++k) {
            const int state = c->forcing[k];
            equation[state] = start[state] * now->size[state];
            right -= 0.5 * start[state] * start[state];
        }
        room->right[equations++] = right;
    }
    return least_squares(equations, n, room->matrix, room->right, step);
}

INLINED composed solve(int n, const layout *l, const cycle *c, const double *numbers,
                       double period, int guided, double *dwell, double *starts, double *map,
                       compose_room *room, patience *patience)
{
    const point at = point_of(l, numbers);
    const int columns = n + 1, w = n + 2, count = c->phases;
    composed result = {.residual = NAN, .iterations = 0, .status = COMPOSE_STALLED};
    double step[MOST_STATES] = {0}, least = 1.0;
    passage now;
    for (;;) {
        double total = 0.0;
        for (int i = 0; i < count; ++i) {
            flow_at(n, l, &at, c->configuration[i], dwell[i], room->flow + i * n * columns);
            total += dwell[i];
            if (lost(patience))
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
        for (int j = 0; j < n; ++j)
            largest = larger(largest, fabs(step[j]));
        for (int i = 0; i < count; ++i) {
            double change = room->rate[i * columns + n];
            for (int k = 0; k < n; ++k)
                change += room->rate[i * columns + k] * (now.size[k] * step[k]);
            room->rate[i * columns] = change;
            largest = larger(largest, fabs(change) / total);
            if (change < -0.75 * dwell[i])
                fraction = smaller(fraction, 0.75 * dwell[i] / -change);
            else if (change > 3.0 * dwell[i])
                fraction = smaller(fraction, 3.0 * dwell[i] / change);
        }
        for (int j = 0; j < n; ++j)
            starts[j] += fraction * (now.size[j] * step[j]);
        for (int i = 0; i < count; ++i)
            dwell[i] += fraction * room->rate[i * columns];
        if (fraction == 1.0 && largest <= TOLERANCE)
            result.status = COMPOSE_CONVERGED;
    }
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            map[i * n + k] = now.block[i * w + k];
    double total = 0.0, shortest = INFINITY;
    for (int i = 0; i < count; ++i) {
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
