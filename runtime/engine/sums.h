/* Sums of a configuration's functions of time: values, derivatives, bounds, errors. */
#ifndef NONSMOOTH_SUMS_H
#define NONSMOOTH_SUMS_H

#include <float.h>
#include <math.h>

#include "chain.h"
#include "phase.h"

/* Errors in units of eps times the size of what is summed: of a value, of a sample that was
 * advanced by rotation, of a derivative at the start. */
static const double VALUE = 8.0 * DBL_EPSILON;
static const double SAMPLE = 96.0 * DBL_EPSILON;
static const double START = 16.0 * DBL_EPSILON;
/* Of a value and a sample where functions pass 1, and exponents that are rounded. */
static const double APART = 16.0 * DBL_EPSILON;
static const double SAMPLE_APART = 192.0 * DBL_EPSILON;

/* Functions of one mode from e^(st) cos(wt) and e^(st) sin(wt). */
static inline void spread(const mode *m, double time, double cosine, double sine, double *functions)
{
    double power = 1.0;
    for (int k = 0, f = m->first; k < m->length; ++k) {
        functions[f++] = power * cosine;
        if (m->oscillates)
            functions[f++] = power * sine;
        power *= time;
    }
}

/* What a joined mode adds to the derivative's coefficients of the mode in front of it. */
static inline void differentiate_joined(const mode *m, const double *from, double *to)
{
    const mode *before = m - 1;
    const int first = before->first, last = first + (before->length << before->oscillates) - 1;
    double factorial = 1.0;
    for (int k = 2; k < before->length; ++k)
        factorial *= k;
    if (before->oscillates && !before->paired) {
        to[first] += from[m->first];
        to[last] += from[m->first + 1];
    } else
        to[last] += from[m->first] / factorial;
}

/* Coefficients of the derivative. */
static inline void differentiate(const configuration *c, const double *from, double *to)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const int step = 1 + m->oscillates, end = m->first + m->length * step;
        for (int k = 1, f = m->first; f < end; ++k, f += step) {
            const int last = f + step == end;
            const double cosine = from[f], above = last ? 0.0 : k * from[f + step];
            if (m->oscillates) {
                const double sine = from[f + 1], next = last ? 0.0 : k * from[f + 3];
                to[f] = m->rate * cosine + m->frequency * sine + above;
                to[f + 1] = m->rate * sine - m->frequency * cosine + next;
            } else
                to[f] = m->rate * cosine + above;
        }
        if (m->paired) {
            const int f = m->first;
            to[f] = m->rate * from[f] + from[f + 1];
            to[f + 1] = m->rate * from[f + 1] - m->frequency * m->frequency * from[f];
        }
        if (m->joined)
            differentiate_joined(m, from, to);
    }
}

/* Bound on the sizes of a derivative's coefficients, from such bounds. */
static inline void differentiate_sizes(const configuration *c, const double *from, double *to)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const int step = 1 + m->oscillates, end = m->first + m->length * step;
        const double rate = fabs(m->rate), frequency = fabs(m->frequency);
        for (int k = 1, f = m->first; f < end; ++k, f += step) {
            const int last = f + step == end;
            for (int part = 0; part < step; ++part) {
                const double above = last ? 0.0 : k * from[f + part + step];
                to[f + part] = rate * from[f + part] + above;
                if (m->oscillates)
                    to[f + part] += frequency * from[f + 1 - part];
            }
        }
        if (m->paired) {
            const int f = m->first;
            to[f] = rate * from[f] + from[f + 1];
            to[f + 1] = rate * from[f + 1] + frequency * frequency * from[f];
        }
        if (m->joined)
            differentiate_joined(m, from, to);
    }
}

/* Value at 0: of every mode the coefficient of its first function. */
static inline double at_start(const configuration *c, const double *coefficients)
{
    double sum = 0.0;
    for (int i = 0; i < c->modes; ++i)
        if (!c->mode[i].joined)
            sum += coefficients[c->mode[i].first];
    return sum;
}

/* Bound on a sum of functions over [from, to]. */
static inline double bound_on(const configuration *c, const double *coefficients, double from, double to)
{
    double sum = 0.0;
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        if (m->chain > 0) {
            double bounds[2 * MOST_POLES];
            chain_bounds(m, m->chain, from, to, bounds);
            i += m->chain - 1;
            const mode *last = &c->mode[i];
            for (int f = m->first; f < last->first + (last->length << last->oscillates); ++f)
                sum += coefficients[f] != 0.0 ? fabs(coefficients[f]) * bounds[f - m->first] : 0.0;
            continue;
        }
        double part = 0.0, power = 1.0;
        for (int k = 0, f = m->first; k < m->length; ++k, f += 1 + m->oscillates, power *= to)
            part += power * (m->oscillates ? hypot(coefficients[f], coefficients[f + 1])
                                           : fabs(coefficients[f]));
        sum += m->rate == 0.0 ? part : part * exp(m->rate * (m->rate > 0.0 ? to : from));
    }
    return sum * (1.0 + 64.0 * DBL_EPSILON);
}

/* From so many on, four sums side by side are faster. */
enum { MANY = 32 };

static inline double dot(int count, const double *a, const double *b)
{
    double sum = 0.0;
    if (count >= MANY) {
        double part[4] = {0.0};
        for (; count >= 4; count -= 4, a += 4, b += 4)
            for (int k = 0; k < 4; ++k)
                part[k] += a[k] * b[k];
        sum = (part[0] + part[1]) + (part[2] + part[3]);
    }
    for (int i = 0; i < count; ++i)
        sum += a[i] * b[i];
    return sum;
}

static inline const double *value_of(const phase *p, int b)
{
    return p->value + (size_t)b * (size_t)p->c->functions;
}

static inline const double *slope_of(const phase *p, int b)
{
    return p->slope + (size_t)b * (size_t)p->c->functions;
}

static inline const double *weights_of(const phase *p, int b)
{
    return p->weights + (size_t)b * (size_t)p->c->functions;
}

/* Sizes of the products that make g_b up over [from, to], and what e^(st) adds to their errors. */
static inline double sizes_on(const phase *p, int b, double from, double to)
{
    return bound_on(p->c, weights_of(p, b), from, to) * (1.0 + 0.125 * p->c->steepest * to);
}

/* Error of g_b at a time that is not advanced by rotation. */
static inline double error_at(const phase *p, int b, double time)
{
    return p->c->simple ? VALUE * (p->size[b] + p->drift[b] * time)
                        : APART * sizes_on(p, b, time, time);
}

static inline double second_bound(const phase *p, int b, double from, double to)
{
    if (p->c->harmonic) /* where it decays, a bound at all times would stop the search */
        return p->second[b];
    double *curve = p->scratch;
    differentiate(p->c, slope_of(p, b), curve);
    return bound_on(p->c, curve, from, to);
}

static inline double third_bound(const phase *p, int b, double from, double to)
{
    double *second = p->scratch, *third = second + p->c->functions;
    differentiate(p->c, slope_of(p, b), second);
    differentiate(p->c, second, third);
    return bound_on(p->c, third, from, to);
}

static inline double fourth_bound(const phase *p, int b, double from, double to)
{
    if (p->c->uniform)
        return p->fourth[b];
    double *fourth = p->scratch, *third = fourth + p->c->functions;
    differentiate(p->c, slope_of(p, b), fourth);
    differentiate(p->c, fourth, third);
    differentiate(p->c, third, fourth);
    return bound_on(p->c, fourth, from, to);
}

static inline sample sample_at(const phase *p, int b, double time)
{
    phase_functions(p->c, time, p->sampled);
    return (sample){dot(p->c->functions, value_of(p, b), p->sampled),
                    dot(p->c->functions, slope_of(p, b), p->sampled)};
}

#endif
