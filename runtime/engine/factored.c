/* States and boundary functions of configurations whose modes have factors. */
#include "factored.h"

#include <math.h>
#include <string.h>

enum { LANES = 8 }; /* sums side by side, in a fixed order */

typedef struct {
    double value, size;
} product;

/* Add products and their absolute values to as many sums. */
#if defined(__GNUC__)
typedef double two __attribute__((vector_size(16)));
typedef int64_t two_integers __attribute__((vector_size(16)));

static inline void add_products(const double *a, const double *b, double *value, double *size)
{
    const two_integers all_but_sign = {INT64_MAX, INT64_MAX};
    for (int k = 0; k < LANES; k += 2) {
        two left, right, sum, sizes;
        memcpy(&left, a + k, sizeof left);
        memcpy(&right, b + k, sizeof right);
        memcpy(&sum, value + k, sizeof sum);
        memcpy(&sizes, size + k, sizeof sizes);
        const two one = left * right;
        sum += one;
        sizes += (two)((two_integers)one & all_but_sign);
        memcpy(value + k, &sum, sizeof sum);
        memcpy(size + k, &sizes, sizeof sizes);
    }
}
#else
static inline void add_products(const double *a, const double *b, double *value, double *size)
{
    for (int k = 0; k < LANES; ++k) {
        value[k] += a[k] * b[k];
        size[k] += fabs(a[k] * b[k]);
    }
}
#endif

/* v . (y, 1), and the sum of the absolute values. */
static product project(int n, const double *row, const double *state)
{
    double value[LANES] = {0.0}, size[LANES] = {0.0};
    const double *const end = row + n, *const last = row + n / LANES * LANES;
    product sum = {*end, fabs(*end)};
    for (; row < last; row += LANES, state += LANES)
        add_products(row, state, value, size);
    for (; row < end; ++row, ++state) {
        sum.value += *row * *state;
        sum.size += fabs(*row * *state);
    }
    for (int k = 0; k < LANES; ++k) {
        sum.value += value[k];
        sum.size += size[k];
    }
    return sum;
}

void factored_boundary(const configuration *c, int n, const double *row, double *across,
                       double *spread, double *size)
{
    const double constant = c->mode[0].factored ? row[n] : 0.0;
    const double *left = c->left;
    for (int f = 0; f < c->factored; ++f, left += n) {
        across[f] = spread[f] = 0.0;
        for (int i = 0; i < n; ++i) {
            across[f] += row[i] * left[i];
            spread[f] += fabs(row[i] * left[i]);
        }
    }
    across[c->factored] = constant;
    spread[c->factored] = fabs(constant);
    size[n] += fabs(constant);
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        if (!m->factored)
            continue;
        double both = 0.0; /* of cosine and sine together */
        for (int part = 0; part <= m->oscillates; ++part)
            both += spread[m->place + part];
        for (int part = 0; part <= m->oscillates; ++part) {
            const double *right = c->right + (size_t)(m->place + part) * (size_t)(n + 1);
            for (int j = 0; j <= n; ++j)
                size[j] += both * fabs(right[j]);
        }
    }
}

void factored_begin(phase *p, int n)
{
    const configuration *c = p->c;
    const double *right = c->right;
    for (int f = 0; f < c->factored; ++f, right += n + 1) {
        const product found = project(n, right, p->state);
        p->projected[f] = found.value;
        p->projected_size[f] = found.size;
    }
    const double *row = c->boundary, *across = c->across;
    double *value = p->value;
    for (int b = 0; b < c->boundaries; ++b, across += c->factored + 1, value += c->functions)
        for (int i = 0; i < c->modes; ++i) {
            const mode *m = &c->mode[i];
            if (!m->factored) {
                for (int f = 0; f < m->length << m->oscillates; ++f, row += n + 1)
                    value[m->first + f] = project(n, row, p->state).value;
                continue;
            }
            const double *u = across + m->place, *z = p->projected + m->place;
            if (m->oscillates) {
                value[m->first] = u[0] * z[0] + u[1] * z[1];
                value[m->first + 1] = u[1] * z[0] - u[0] * z[1];
            } else
                value[m->first] = u[0] * z[0] + (i == 0 ? across[c->factored] : 0.0);
        }
}

void factored_sizes(const phase *p, int b, double *sizes)
{
    const configuration *c = p->c;
    const int n = p->states;
    const double *row = c->weight + (size_t)b * (size_t)c->dense * (size_t)(n + 1);
    const double *spread = c->spread + (size_t)b * (size_t)(c->factored + 1);
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        if (!m->factored) {
            for (int f = 0; f < m->length << m->oscillates; ++f, row += n + 1)
                sizes[m->first + f] = project(n, row, p->magnitude).size;
            continue;
        }
        const double *right = c->right + (size_t)m->place * (size_t)(n + 1), *u = spread + m->place;
        const double one = project(n, right, p->magnitude).size;
        if (m->oscillates) {
            const double two = project(n, right + n + 1, p->magnitude).size;
            sizes[m->first] = u[0] * one + u[1] * two;
            sizes[m->first + 1] = u[1] * one + u[0] * two;
        } else
            sizes[m->first] = u[0] * one + (i == 0 ? spread[c->factored] : 0.0);
    }
}

/* Add the matrix of a function: what it adds to the state, and to the bounds. */
static void add_matrix(int n, const double *matrix, double function, double weight,
                       const double *start, double *restrict state, double *restrict magnitude)
{
    for (int i = 0; i < n; ++i, matrix += n + 1) {
        const product one = project(n, matrix, start);
        state[i] += function * one.value;
        magnitude[i] += weight * one.size;
    }
}

/* Add a factor u, or two. */
static void add_one(int n, const double *left, double by, double size, double *restrict state,
                    double *restrict magnitude)
{
    for (int i = 0; i < n; ++i) {
        state[i] += by * left[i];
        magnitude[i] += size * fabs(left[i]);
    }
}

static void add_two(int n, const double *left, const double *by, const double *size,
                    double *restrict state, double *restrict magnitude)
{
    const double *other = left + n;
    for (int i = 0; i < n; ++i) {
        state[i] += by[0] * left[i] + by[1] * other[i];
        magnitude[i] += size[0] * fabs(left[i]) + size[1] * fabs(other[i]);
    }
}

void factored_flow(const phase *p, int n, const double *functions, const double *bounds,
                   double *restrict state, double *restrict magnitude)
{
    const configuration *c = p->c;
    const double *matrix = c->flow;
    for (int i = 0; i < n; ++i)
        state[i] = magnitude[i] = 0.0;
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const double *phi = functions + m->first, *bound = bounds + m->first;
        if (!m->factored) {
            for (int f = 0; f < m->length << m->oscillates; ++f, matrix += (size_t)n * (size_t)(n + 1))
                add_matrix(n, matrix, phi[f], bound[f], p->state, state, magnitude);
            continue;
        }
        const double *left = c->left + (size_t)m->place * (size_t)n;
        const double *z = p->projected + m->place, *size = p->projected_size + m->place;
        if (m->oscillates) {
            const double cosine = bound[0], sine = bound[1];
            const double by[2] = {phi[0] * z[0] - phi[1] * z[1], phi[0] * z[1] + phi[1] * z[0]};
            const double sizes[2] = {cosine * size[0] + sine * size[1],
                                     cosine * size[1] + sine * size[0]};
            add_two(n, left, by, sizes, state, magnitude);
        } else
            add_one(n, left, phi[0] * z[0], bound[0] * size[0], state, magnitude);
    }
}
