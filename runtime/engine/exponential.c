/* Flows of affine fields: exp(G t) of the generator G = [A b; 0 0] without its last row.
 *
 * The state's units are balanced first (Parlett and Reinsch, 1969), so that the number of
 * squarings is a matter of the motion and not of its units. The series has degree 16, in four
 * blocks of four (Paterson and Stockmeyer, 1973); its derivative is taken product by product
 * (Al-Mohy and Higham, 2010). */
#include "exponential.h"

#include <math.h>
#include <string.h>

#include "tables.h"

enum {
    BLOCK = 4,
    POWERS = BLOCK,
    SUMS = 4,         /* of 16 / BLOCK blocks */
    MOST_HALVINGS = 21, /* of FARTHEST to REACH */
    KEPT = POWERS + SUMS + MOST_HALVINGS,
    ARRAYS = KEPT + POWERS + 2,
    SWEEPS = 20
};
static const double REACH = 0.8;    /* 0.8^17 / 17! < 2^-53 */
static const double FARTHEST = 1e6; /* norm of G t */
/* 1 / k! */
static const double INVERSE[17] = {1.0,
                                   1.0,
                                   1.0 / 2,
                                   1.0 / 6,
                                   1.0 / 24,
                                   1.0 / 120,
                                   1.0 / 720,
                                   1.0 / 5040,
                                   1.0 / 40320,
                                   1.0 / 362880,
                                   1.0 / 3628800,
                                   1.0 / 39916800,
                                   1.0 / 479001600,
                                   1.0 / 6227020800,
                                   1.0 / 87178291200,
                                   1.0 / 1307674368000,
                                   1.0 / 20922789888000};

size_t exponential_room(size_t states)
{
    return size_sum(size_product(ARRAYS, size_product(states, states + 1)), states);
}

/* sum (n, n + 1) += the first n columns of `left` times the columns of `right` from `first` on. */
INLINED void add_product(const ptrdiff_t n, const ptrdiff_t first, const double *left,
                         const double *right, double *restrict sum)
{
    const ptrdiff_t columns = n + 1;
    for (ptrdiff_t i = 0; i < n; ++i, left += columns, sum += columns) {
        const double *from = right;
        for (ptrdiff_t j = 0; j < n; ++j, from += columns) {
            const double factor = left[j];
            if (factor == 0.0) /* forcings depend on little */
                continue;
            for (ptrdiff_t k = first; k < columns; ++k)
                sum[k] += factor * from[k];
        }
    }
}

/* result = left right of generators; of maps the constant of `left` is added. */
INLINED void multiply(const ptrdiff_t n, const double *left, const double *right, const int maps,
                      double *result)
{
    const ptrdiff_t columns = n + 1;
    memset(result, 0, (size_t)(n * columns) * sizeof(double));
    add_product(n, 0, left, right, result);
    for (ptrdiff_t i = 0; maps && i < n; ++i)
        result[i * columns + n] += left[i * columns + n];
}

/* The derivative of that product, where the derivatives of both are zero in front of a column. */
INLINED void multiply_moved(const ptrdiff_t n, const ptrdiff_t first, const double *left,
                            const double *left_moved, const double *right,
                            const double *right_moved, const int maps, double *result)
{
    const ptrdiff_t columns = n + 1;
    memset(result, 0, (size_t)(n * columns) * sizeof(double));
    if (first < n)
        add_product(n, 0, left_moved, right, result);
    add_product(n, first, left, right_moved, result);
    for (ptrdiff_t i = 0; maps && i < n; ++i)
        result[i * columns + n] += left_moved[i * columns + n];
}

/* sum += c1 X + c2 X^2 + c3 X^3 of n (n + 1) entries */
INLINED void add_block(const ptrdiff_t size, const double *power, const double *c, double *sum)
{
    const double *square = power + size, *cube = square + size;
    for (ptrdiff_t i = 0; i < size; ++i)
        sum[i] += c[3] * cube[i] + (c[2] * square[i] + c[1] * power[i]);
}

/* Units, powers of two, in which rows and columns are of like size; the 1 of constants has its own. */
static void balance(const ptrdiff_t n, double *matrix, double *unit)
{
    const ptrdiff_t columns = n + 1;
    for (ptrdiff_t i = 0; i < n; ++i)
        unit[i] = 1.0;
    int changed = 1;
    for (int sweep = 0; changed && sweep < SWEEPS; ++sweep) {
        changed = 0;
        for (ptrdiff_t i = 0; i < n; ++i) {
            double column = 0.0, row = 0.0;
            for (ptrdiff_t j = 0; j < n; ++j)
                column = fmax(column, fabs(matrix[j * columns + i]));
            for (ptrdiff_t j = 0; j < columns; ++j)
                row = fmax(row, fabs(matrix[i * columns + j]));
            if (!(column > 0.0 && row > 0.0 && isfinite(column) && isfinite(row)))
                continue;
            int exponent;
            frexp(row / column, &exponent);
            const double factor = ldexp(1.0, exponent >= 0 ? exponent / 2 : -((1 - exponent) / 2));
            if (!(factor * column + row / factor < 0.95 * (column + row)))
                continue;
            changed = 1;
            unit[i] *= factor;
            for (ptrdiff_t j = 0; j < columns; ++j)
                matrix[i * columns + j] /= factor;
            for (ptrdiff_t j = 0; j < n; ++j)
                matrix[j * columns + i] *= factor;
        }
    }
}

/* Largest sum of a column's absolute values. */
static double norm(const ptrdiff_t n, const double *matrix)
{
    double largest = 0.0;
    for (ptrdiff_t k = 0; k <= n; ++k) {
        double sum = 0.0;
        for (ptrdiff_t j = 0; j < n; ++j)
            sum += fabs(matrix[j * (n + 1) + k]);
        if (!(sum <= largest))
            largest = sum; /* NaN too */
    }
    return largest;
}

INLINED void expand(const ptrdiff_t n, const double *field, const double time, double *flow,
                    expansion *e)
{
    const ptrdiff_t columns = n + 1, size = n * columns;
    double *const unit = e->unit, *const power = e->kept, *const fourth = power + 3 * size;
    memcpy(power, field, (size_t)size * sizeof(double));
    balance(n, power, unit);
    const double angle = fabs(time) * norm(n, power);
    e->halvings = angle <= FARTHEST ? 0 : -1;
    if (e->halvings < 0) {
        for (ptrdiff_t i = 0; i < size; ++i)
            flow[i] = NAN;
        return;
    }
    e->step = time;
    for (double left = angle; left > REACH; left *= 0.5, ++e->halvings)
        e->step *= 0.5;
    for (ptrdiff_t i = 0; i < size; ++i)
        power[i] *= e->step;
    for (int k = 1; k < POWERS; ++k) /* X^2, X^3, X^4 */
        multiply(n, k == 1 ? power : power + size, k == 3 ? power + size : power, 0,
                 power + k * size);
    double *sum = power + POWERS * size;
    for (ptrdiff_t i = 0; i < size; ++i)
        sum[i] = INVERSE[16] * fourth[i];
    for (int first = 12;; first -= BLOCK) {
        add_block(size, power, INVERSE + first, sum);
        for (ptrdiff_t i = 0; i < n; ++i)
            sum[i * columns + i] += INVERSE[first];
        if (first == 0)
            break;
        multiply(n, sum, fourth, 0, sum + size);
        sum += size;
    }
    for (int k = 0; k < e->halvings; ++k, sum += size)
        multiply(n, sum, sum, 1, sum + size);
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < columns; ++k)
            flow[i * columns + k] = sum[i * columns + k] * (unit[i] / (k < n ? unit[k] : 1.0));
}

INLINED void expand_moved(const ptrdiff_t n, const double *change, const ptrdiff_t first,
                          double *moved, const expansion *e)
{
    const ptrdiff_t columns = n + 1, size = n * columns;
    if (e->halvings < 0) {
        for (ptrdiff_t i = 0; i < size; ++i)
            moved[i] = NAN;
        return;
    }
    const double *const unit = e->unit, *const power = e->kept, *const fourth = power + 3 * size;
    double *const own = e->kept + KEPT * size, *const own_fourth = own + 3 * size;
    double *sum_moved = own + POWERS * size, *next = sum_moved + size;
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < columns; ++k)
            own[i * columns + k] =
                change[i * columns + k] * ((k < n ? unit[k] : 1.0) / unit[i]) * e->step;
    for (int k = 1; k < POWERS; ++k) {
        const ptrdiff_t left = k == 1 ? 0 : size, right = k == 3 ? size : 0;
        multiply_moved(n, first, power + left, own + left, power + right, own + right, 0,
                       own + k * size);
    }
    for (ptrdiff_t i = 0; i < size; ++i)
        sum_moved[i] = INVERSE[16] * own_fourth[i];
    const double *sum = power + POWERS * size;
    for (int block = 12;; block -= BLOCK) {
        add_block(size, own, INVERSE + block, sum_moved);
        if (block == 0)
            break;
        multiply_moved(n, first, sum, sum_moved, fourth, own_fourth, 0, next);
        double *const swapped = sum_moved;
        sum_moved = next;
        next = swapped;
        sum += size;
    }
    for (int k = 0; k < e->halvings; ++k, sum += size) {
        multiply_moved(n, first, sum, sum_moved, sum, sum_moved, 1, next);
        double *const swapped = sum_moved;
        sum_moved = next;
        next = swapped;
    }
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < columns; ++k)
            moved[i * columns + k] =
                sum_moved[i * columns + k] * (unit[i] / (k < n ? unit[k] : 1.0));
}

expansion exponential(const ptrdiff_t n, const double *field, const double time, double *flow,
                      double *room)
{
    expansion found = {.unit = room, .kept = room + n};
    switch (n) {
    case 2:
        expand(2, field, time, flow, &found);
        break;
    case 4:
        expand(4, field, time, flow, &found);
        break;
    default:
        expand(n, field, time, flow, &found);
    }
    return found;
}

void exponential_moved(const ptrdiff_t n, const double *change, const ptrdiff_t first,
                       double *moved, const expansion *e)
{
    switch (n) {
    case 2:
        expand_moved(2, change, first, moved, e);
        break;
    case 4:
        expand_moved(4, change, first, moved, e);
        break;
    default:
        expand_moved(n, change, first, moved, e);
    }
}
