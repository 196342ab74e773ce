/* Flows of affine fields: exp(G t) of the generator G = [A b; 0 0] without its last row.
 *
 * The state's units are balanced first (Parlett and Reinsch, 1969), so that the number of
 * squarings is a matter of the motion and not of its units. The series has degree 16, in four
 * blocks of four (Paterson and Stockmeyer, 1973); its derivative is taken product by product
 * (Al-Mohy and Higham, 2010). */
#include "exponential.h"

#include <math.h>
#include <string.h>

#include "support.h"
#include "tables.h"

enum { BLOCK = 4, POWERS = BLOCK, ARRAYS = POWERS + 2, SWEEPS = 20 };
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
    const size_t each = size_product(states, states + 1);
    return size_sum(size_product(2 * ARRAYS, each), states);
}

/* A matrix (n, n + 1) and its derivative, which is NULL or as large. */
typedef struct {
    double *value, *change;
} pair;

/* sum (n, n + 1) += the first n columns of `left` times `right`. */
static void add_product(const ptrdiff_t n, const double *left, const double *right,
                        double *restrict sum)
{
    const ptrdiff_t columns = n + 1;
    for (ptrdiff_t i = 0; i < n; ++i, left += columns, sum += columns) {
        const double *from = right;
        for (ptrdiff_t j = 0; j < n; ++j, from += columns) {
            const double factor = left[j];
            if (factor == 0.0) /* forcings depend on little */
                continue;
            for (ptrdiff_t k = 0; k < columns; ++k)
                sum[k] += factor * from[k];
        }
    }
}

/* result = left right of generators; of maps the constant of `left` is added. */
static void multiply(const ptrdiff_t n, const pair left, const pair right, const int maps,
                     const pair result)
{
    const ptrdiff_t columns = n + 1;
    const size_t bytes = (size_t)(n * columns) * sizeof(double);
    memset(result.value, 0, bytes);
    add_product(n, left.value, right.value, result.value);
    if (result.change) {
        memset(result.change, 0, bytes);
        add_product(n, left.change, right.value, result.change);
        add_product(n, left.value, right.change, result.change);
    }
    for (ptrdiff_t i = 0; maps && i < n; ++i) {
        result.value[i * columns + n] += left.value[i * columns + n];
        if (result.change)
            result.change[i * columns + n] += left.change[i * columns + n];
    }
}

/* sum += c0 + c1 X + c2 X^2 + c3 X^3 */
static void add_block(const ptrdiff_t n, const pair *power, const double *c, const pair sum)
{
    const ptrdiff_t columns = n + 1;
    for (ptrdiff_t i = 0; i < n * columns; ++i)
        sum.value[i] += c[3] * power[2].value[i] + (c[2] * power[1].value[i] + c[1] * power[0].value[i]);
    for (ptrdiff_t i = 0; i < n; ++i)
        sum.value[i * columns + i] += c[0];
    for (ptrdiff_t i = 0; sum.change && i < n * columns; ++i)
        sum.change[i] +=
            c[3] * power[2].change[i] + (c[2] * power[1].change[i] + c[1] * power[0].change[i]);
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

void exponential(const ptrdiff_t n, const double *field, const double *change, const double time,
                 double *flow, double *moved, double *room)
{
    const ptrdiff_t columns = n + 1, size = n * columns;
    double *const unit = room;
    pair power[POWERS], sum, next;
    room += n;
    for (int k = 0; k < POWERS; ++k, room += 2 * size)
        power[k] = (pair){room, change ? room + size : NULL};
    sum = (pair){room, change ? room + size : NULL};
    next = (pair){room + 2 * size, change ? room + 3 * size : NULL};
    memcpy(power[0].value, field, (size_t)size * sizeof(double));
    balance(n, power[0].value, unit);
    const double angle = fabs(time) * norm(n, power[0].value);
    if (!(angle <= FARTHEST)) {
        for (ptrdiff_t i = 0; i < size; ++i) {
            flow[i] = NAN;
            if (change)
                moved[i] = NAN;
        }
        return;
    }
    int halvings = 0;
    double step = time;
    for (double left = angle; left > REACH; left *= 0.5, ++halvings)
        step *= 0.5;
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < columns; ++k) {
            const ptrdiff_t at = i * columns + k;
            power[0].value[at] *= step;
            if (change)
                power[0].change[at] = change[at] * ((k < n ? unit[k] : 1.0) / unit[i]) * step;
        }
    for (int k = 1; k < POWERS; ++k) /* X^2, X^3, X^4 */
        multiply(n, power[k == 1 ? 0 : 1], power[k == 3 ? 1 : 0], 0, power[k]);
    for (ptrdiff_t i = 0; i < size; ++i) {
        sum.value[i] = INVERSE[16] * power[3].value[i];
        if (change)
            sum.change[i] = INVERSE[16] * power[3].change[i];
    }
    for (int first = 12;; first -= BLOCK) {
        add_block(n, power, INVERSE + first, sum);
        if (first == 0)
            break;
        multiply(n, sum, power[3], 0, next);
        const pair swapped = sum;
        sum = next;
        next = swapped;
    }
    for (; halvings > 0; --halvings) {
        multiply(n, sum, sum, 1, next);
        const pair swapped = sum;
        sum = next;
        next = swapped;
    }
    for (ptrdiff_t i = 0; i < n; ++i)
        for (ptrdiff_t k = 0; k < columns; ++k) {
            const ptrdiff_t at = i * columns + k;
            const double back = unit[i] / (k < n ? unit[k] : 1.0);
            flow[at] = sum.value[at] * back;
            if (change)
                moved[at] = sum.change[at] * back;
        }
}
