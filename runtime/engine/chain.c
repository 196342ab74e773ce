/* Functions of chains of modes whose exponents nearly meet, and their derivatives. */
#include "chain.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "support.h"

enum { TERMS = 22 }; /* of an exponential series whose argument is at most 1 */

/* What is known at one time, by sets of poles; a set is a mask. */
typedef struct {
    int count;
    double time;
    double complex pole[MOST_POLES];
    uint8_t known[1 << MOST_POLES];
    double complex value[1 << MOST_POLES];
} differences;

static double complex exponential(double complex pole, double time)
{
    double sine, cosine;
    const double rate = creal(pole), growth = rate == 0.0 ? 1.0 : exp(rate * time);
    nonsmooth_sincos(cimag(pole) * time, &sine, &cosine);
    return growth * cosine + growth * sine * I;
}

/* Largest distance of two poles of a set, and which they are; 0 of a single one. */
static double farthest(const differences *d, int set, int *one, int *two)
{
    double largest = -1.0;
    for (int i = 0; i < d->count; ++i)
        for (int j = i + 1; j < d->count; ++j) {
            const double distance = cabs(d->pole[i] - d->pole[j]);
            if (set >> i & set >> j & 1 && distance > largest) {
                largest = distance;
                *one = i;
                *two = j;
            }
        }
    return largest;
}

/* The divided difference by the exponential series about the middle of the poles. */
static double complex series(const differences *d, int set)
{
    const int size = __builtin_popcount((unsigned)set);
    double complex middle = 0.0, degree[TERMS] = {1.0}, total = 0.0;
    double unit = 0.0; /* of the distances, whose powers may overflow */
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1)
            middle += d->pole[i];
    middle /= size;
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1)
            unit = fmax(unit, cabs(d->pole[i] - middle));
    unit = unit > 0.0 ? unit : 1.0;
    /* complete homogeneous polynomials of the distances, degree by degree */
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1) {
            const double complex distance = (d->pole[i] - middle) / unit;
            for (int k = 1; k < TERMS; ++k)
                degree[k] += distance * degree[k - 1];
        }
    for (int k = TERMS - 1; k >= 0; --k)
        total = total * (unit * d->time / (size + k)) + degree[k];
    for (int k = 1; k < size; ++k)
        total *= d->time / k;
    return exponential(middle, d->time) * total;
}

/* The divided difference over a set: of the farthest poles, or by its series where none is far. */
static double complex difference(differences *d, int set)
{
    if (d->known[set])
        return d->value[set];
    double complex found;
    int one, two;
    if (!(set & (set - 1)))
        found = exponential(d->pole[__builtin_ctz((unsigned)set)], d->time);
    else if (farthest(d, set, &one, &two) * d->time > 1.0)
        found = (difference(d, set & ~(1 << two)) - difference(d, set & ~(1 << one))) /
                (d->pole[one] - d->pole[two]);
    else
        found = series(d, set);
    d->known[set] = 1;
    d->value[set] = found;
    return found;
}

/* Bound on its absolute value beside the growth of the fastest pole. */
static double bound(const differences *d, int set, double time)
{
    const int order = __builtin_popcount((unsigned)set) - 1;
    double found = 1.0;
    for (int k = 1; k <= order; ++k)
        found *= time / k;
    int one = 0, two = 0;
    const double distance = farthest(d, set, &one, &two);
    if (distance * time > 1.0) {
        const double both =
            bound(d, set & ~(1 << one), time) + bound(d, set & ~(1 << two), time);
        found = fmin(found, both / distance);
    }
    return found;
}

static void begin(differences *d, double time)
{
    d->count = 0;
    d->time = time;
    memset(d->known, 0, sizeof d->known);
}

static void add(differences *d, const mode *m)
{
    for (int k = 0; k < m->length; ++k)
        d->pole[d->count++] = m->rate + m->frequency * I;
}

static void add_conjugate(differences *d, const mode *m)
{
    if (m->paired)
        d->pole[d->count++] = m->rate - m->frequency * I;
}

void chain_functions(const mode *first, int modes, double time, double *functions)
{
    differences d;
    begin(&d, time);
    for (int i = 0; i < modes; ++i) {
        const mode *m = &first[i];
        double *at = functions + m->first;
        add(&d, m);
        if (i == 0 && !m->paired) {
            const double complex value = exponential(d.pole[0], time);
            double power = 1.0;
            for (int k = 0; k < m->length; ++k, power *= time) {
                *at++ = power * creal(value);
                if (m->oscillates)
                    *at++ = power * cimag(value);
            }
            continue;
        }
        const double complex value = difference(&d, (1 << d.count) - 1);
        at[0] = creal(value);
        if (m->paired) {
            add_conjugate(&d, m);
            at[1] = creal(difference(&d, (1 << d.count) - 1));
        } else if (m->oscillates)
            at[1] = cimag(value);
    }
}

void chain_bounds(const mode *first, int modes, double from, double to, double *bounds)
{
    differences d;
    begin(&d, to);
    double rate = first->rate;
    for (int i = 1; i < modes; ++i)
        rate = fmax(rate, first[i].rate);
    const double growth = rate == 0.0 ? 1.0 : exp(rate * (rate < 0.0 ? from : to));
    for (int i = 0; i < modes; ++i) {
        const mode *m = &first[i];
        double *at = bounds + m->first;
        add(&d, m);
        if (i == 0 && !m->paired) {
            double power = growth;
            for (int k = 0; k < m->length; ++k, power *= to) {
                *at++ = power;
                if (m->oscillates)
                    *at++ = power;
            }
            continue;
        }
        at[0] = growth * bound(&d, (1 << d.count) - 1, to);
        add_conjugate(&d, m);
        if (m->oscillates)
            at[1] = growth * bound(&d, (1 << d.count) - 1, to);
    }
}
