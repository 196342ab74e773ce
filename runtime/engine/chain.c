/* Functions of chains of modes whose exponents nearly meet, and their derivatives. */
#include "chain.h"

#include <math.h>

#include "nonsmooth_differences.h"

/* Bound on the absolute value of a difference beside the growth of the fastest pole. */
static double bound(const nonsmooth_differences *d, unsigned set, double time)
{
    int order = -1;
    for (unsigned rest = set; rest; rest &= rest - 1)
        ++order;
    double found = 1.0;
    for (int k = 1; k <= order; ++k)
        found *= time / k;
    int one = 0, two = 0;
    const double distance = nonsmooth_farthest(d, set, &one, &two);
    if (distance * time > 1.0) {
        const double both =
            bound(d, set & ~(1u << one), time) + bound(d, set & ~(1u << two), time);
        found = fmin(found, both / distance);
    }
    return found;
}

static void add(nonsmooth_differences *d, const mode *m)
{
    for (int k = 0; k < m->length; ++k)
        nonsmooth_add(d, m->rate, m->frequency);
}

static void add_conjugate(nonsmooth_differences *d, const mode *m)
{
    if (m->paired)
        nonsmooth_add(d, m->rate, -m->frequency);
}

void chain_functions(const mode *first, int modes, double time, double *functions)
{
    nonsmooth_differences d;
    nonsmooth_begin(&d, time);
    for (int i = 0; i < modes; ++i) {
        const mode *m = &first[i];
        double *at = functions + m->first;
        add(&d, m);
        if (i == 0 && !m->paired) {
            const nonsmooth_complex value = nonsmooth_exponential(d.root[0], time);
            double power = 1.0;
            for (int k = 0; k < m->length; ++k, power *= time) {
                *at++ = power * value.re;
                if (m->oscillates)
                    *at++ = power * value.im;
            }
            continue;
        }
        const nonsmooth_complex value = nonsmooth_difference(&d, (1u << d.count) - 1u);
        at[0] = value.re;
        if (m->paired) {
            add_conjugate(&d, m);
            at[1] = nonsmooth_difference(&d, (1u << d.count) - 1u).re;
        } else if (m->oscillates)
            at[1] = value.im;
    }
}

void chain_bounds(const mode *first, int modes, double from, double to, double *bounds)
{
    nonsmooth_differences d;
    nonsmooth_begin(&d, to);
    double rate = first->rate;
    for (int i = 1; i < modes; ++i)
        rate = fmax(rate, first[i].rate);
    const double growth = rate == 0.0 ? 1.0 : exp(rate * (rate < 0.0 ? from : to));
    for (int i = 0; i < modes; ++i) {
        const mode *m = &first[i];
        double *at = bounds + (m->first - first->first);
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
        at[0] = growth * bound(&d, (1u << d.count) - 1u, to);
        add_conjugate(&d, m);
        if (m->oscillates)
            at[1] = growth * bound(&d, (1u << d.count) - 1u, to);
    }
}
