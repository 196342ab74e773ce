/* The shooting map of a chain of phases; see nonsmooth.runtime.shooting.shooting_map. */
#include "shooting.h"

#include <string.h>

#include "exponential.h"
#include "tables.h"

size_t shooting_room(size_t states, size_t unknowns)
{
    const size_t maps = size_product(2, size_product(states, states + 1));
    return size_sum(size_sum(exponential_room(states), maps), size_product(states, unknowns));
}

/* An affine map's row applied to a state. */
static double applied(ptrdiff_t n, const double *row, const double *state)
{
    double sum = row[n];
    for (ptrdiff_t j = 0; j < n; ++j)
        sum += row[j] * state[j];
    return sum;
}

/* after (rows, unknowns) = the linear part of a map (rows, n + 1) times before (n, unknowns); the
 * last of these changes by what a change of the map adds. */
static void carry(ptrdiff_t rows, ptrdiff_t n, ptrdiff_t unknowns, const double *map,
                  const double *change, const double *state, const double *before,
                  double *restrict after)
{
    for (ptrdiff_t i = 0; i < rows; ++i, map += n + 1, after += unknowns) {
        for (ptrdiff_t k = 0; k < unknowns; ++k)
            after[k] = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j) {
            const double factor = map[j], *from = before + j * unknowns;
            if (factor == 0.0)
                continue;
            for (ptrdiff_t k = 0; k < unknowns; ++k)
                after[k] += factor * from[k];
        }
        if (change)
            after[unknowns - 1] += applied(n, change + i * (n + 1), state);
    }
}

void shoot(const chain_of_phases *chain, const double *dwell, const shot *result, double *room)
{
    const ptrdiff_t n = chain->states, phases = chain->phases, size = n * (n + 1);
    const int varied = chain->field_change != NULL;
    const ptrdiff_t unknowns = phases + n + varied;
    double *const flow = room, *const moved = flow + size, *const ends = moved + size;
    double *const scratch = ends + n * unknowns, *const columns = result->variational;
    memset(columns, 0, (size_t)(n * unknowns) * sizeof(double));
    for (ptrdiff_t i = 0; i < n; ++i)
        columns[i * unknowns + phases + i] = 1.0;
    for (ptrdiff_t p = 0; p < phases; ++p) {
        const double *field = chain->field + p * size, *reset = chain->reset + p * size;
        const double *row = chain->row + p * (n + 1), *state = result->starts + p * n;
        const double *field_change = varied ? chain->field_change + p * size : NULL;
        const double *row_change = varied ? chain->row_change + p * (n + 1) : NULL;
        const double *reset_change = varied ? chain->reset_change + p * size : NULL;
        double *end = result->ends + p * n, *velocity = result->velocities + p * n;
        const expansion found = exponential(n, field, dwell[p], flow, scratch);
        if (varied)
            exponential_moved(n, field_change, 0, moved, &found);
        for (ptrdiff_t i = 0; i < n; ++i)
            end[i] = applied(n, flow + i * (n + 1), state);
        carry(n, n, unknowns, flow, varied ? moved : NULL, state, columns, ends);
        for (ptrdiff_t i = 0; i < n; ++i) {
            velocity[i] = applied(n, field + i * (n + 1), end);
            ends[i * unknowns + p] += velocity[i];
        }
        result->residual[p] = applied(n, row, end);
        carry(1, n, unknowns, row, row_change, end, ends, result->slopes + p * unknowns);
        for (ptrdiff_t i = 0; i < n; ++i)
            result->starts[(p + 1) * n + i] = applied(n, reset + i * (n + 1), end);
        carry(n, n, unknowns, reset, reset_change, end, ends, columns);
    }
}
