/* Functions of time of linear motions with one or two characteristic factors: divided differences
 * of e^(lambda t). */
#ifndef NONSMOOTH_EXPONENTIALS_H
#define NONSMOOTH_EXPONENTIALS_H

#include <math.h>

#include "nonsmooth_trigonometry.h"

/* Derivatives by t, of the orders 0 to 3, of G(t) = L^-1[1/prod chi_i](t), the divided difference
 * of e^(lambda t) over all roots of monic polynomials chi_i. Below, c0 and c1 are of
 * s^2 + c1 s + c0. */
typedef struct {
    double d0, d1, d2, d3;
} nonsmooth_derivatives;

/* Sine and cosine of any finite x. */
static inline void nonsmooth_turn(double x, double *sine, double *cosine)
{
    if (fabs(x) <= NONSMOOTH_PHASE_LIMIT)
        nonsmooth_sincos(x, sine, cosine);
    else {
        *sine = sin(x);
        *cosine = cos(x);
    }
}

/* (e^(r t) - 1)/r. */
static inline double nonsmooth_growth(double r, double t)
{
    return r == 0.0 ? t : expm1(r * t) / r;
}

/* Roots of s^2 + c1 s + c0: mean +- sqrt(square), and the real ones, none of which cancels. */
typedef struct {
    double mean, square, right, left, radius; /* the last: largest modulus */
} nonsmooth_roots;

static inline nonsmooth_roots nonsmooth_quadratic(double c0, double c1)
{
    nonsmooth_roots r;
    r.mean = -0.5 * c1;
    r.square = r.mean * r.mean - c0;
    const double root = sqrt(fabs(r.square));
    r.left = r.right = r.mean;
    if (r.square < 0.0) {
        r.radius = sqrt(fabs(c0));
        return r;
    }
    if (r.mean > 0.0) {
        r.right = r.mean + root;
        r.left = c0 / r.right;
        r.radius = r.right;
    } else {
        r.left = r.mean - root;
        r.right = r.left == 0.0 ? 0.0 : c0 / r.left;
        r.radius = -r.left;
    }
    return r;
}

/* h = G and h' of {s^2 + c1 s + c0}. */
static inline nonsmooth_derivatives nonsmooth_pair_of(double t, nonsmooth_roots r)
{
    nonsmooth_derivatives g = {0.0, 0.0, 0.0, 0.0};
    const double root = sqrt(fabs(r.square));
    if (r.square < 0.0) {
        double sine, cosine;
        nonsmooth_turn(root * t, &sine, &cosine);
        const double decay = exp(r.mean * t);
        sine /= root;
        g.d0 = decay * sine;
        g.d1 = decay * (cosine + r.mean * sine);
    } else {
        g.d0 = exp(r.right * t) * nonsmooth_growth(-2.0 * root, t);
        g.d1 = exp(r.left * t) + r.right * g.d0;
    }
    return g;
}

static inline nonsmooth_derivatives nonsmooth_pair(double t, double c0, double c1)
{
    return nonsmooth_pair_of(t, nonsmooth_quadratic(c0, c1));
}

/* The same of {s - r, s}. */
static inline nonsmooth_derivatives nonsmooth_rate_load(double t, double c0)
{
    const nonsmooth_derivatives g = {nonsmooth_growth(-c0, t), exp(-c0 * t), 0.0, 0.0};
    return g;
}

/* Terms of exponential series for arguments up to 1. */
enum { NONSMOOTH_SHORT = 22 };

/* The same of {s^2 + c1 s + c0, s^2 + e0, s, ..., s} where all roots times t are below 1. */
static inline nonsmooth_derivatives nonsmooth_small(double t, double c0, double c1, double e0,
                                                    int degree)
{
    double term[4], before = 0.0, last = 1.0, coefficient = 1.0, older = 0.0, power = 1.0;
    double total[4] = {0.0, 0.0, 0.0, 0.0};
    /* term[i] = t^(j + degree - 1 - i)/(j + degree - 1 - i)! */
    for (int i = 0; i < 4; ++i)
        term[i] = 0.0;
    for (int i = 0; i < degree; ++i) {
        if (degree - 1 - i < 4)
            term[degree - 1 - i] = power;
        power *= t / (i + 1);
    }
    for (int j = 0;; ++j) {
        for (int i = 0; i < 4; ++i)
            total[i] += coefficient * term[i];
        if (j == NONSMOOTH_SHORT)
            break;
        for (int i = 3; i > 0; --i)
            term[i] = term[i - 1];
        term[0] *= t / (j + degree);
        /* complete homogeneous polynomials of the first two roots, then of all */
        const double next = -c1 * last - c0 * before;
        const double wider = next - e0 * older;
        before = last;
        last = next;
        older = coefficient;
        coefficient = wider;
    }
    const nonsmooth_derivatives g = {total[0], total[1], total[2], total[3]};
    return g;
}

/* The same of {s^2 + c1 s + c0, s}. */
static inline nonsmooth_derivatives nonsmooth_pair_load(double t, double c0, double c1)
{
    const nonsmooth_roots r = nonsmooth_quadratic(c0, c1);
    if (r.radius * fabs(t) < 1.0)
        return nonsmooth_small(t, c0, c1, 0.0, 3);
    const nonsmooth_derivatives h = nonsmooth_pair_of(t, r);
    nonsmooth_derivatives g = {0.0, h.d0, h.d1, 0.0};
    if (r.square < 0.0)
        g.d0 = (1.0 - h.d1 - c1 * h.d0) / c0;
    else {
        const double far = r.mean > 0.0 ? r.right : r.left, near = r.mean > 0.0 ? r.left : r.right;
        g.d0 = (h.d0 - nonsmooth_growth(near, t)) / far;
    }
    return g;
}

/* The same of {s^2 + c1 s + c0, s, s}. */
static inline nonsmooth_derivatives nonsmooth_pair_drift(double t, double c0, double c1)
{
    const nonsmooth_roots r = nonsmooth_quadratic(c0, c1);
    if (r.radius * fabs(t) < 1.0)
        return nonsmooth_small(t, c0, c1, 0.0, 4);
    const nonsmooth_derivatives h = nonsmooth_pair_load(t, c0, c1);
    nonsmooth_derivatives g = {0.0, h.d0, h.d1, h.d2};
    if (r.square < 0.0)
        g.d0 = (t - h.d1 - c1 * h.d0) / c0;
    else {
        const double far = r.mean > 0.0 ? r.right : r.left, near = r.mean > 0.0 ? r.left : r.right;
        const double slow = fabs(near * t) < 1.0
                                ? nonsmooth_small(t, 0.0, -near, 0.0, 3).d0
                                : (expm1(near * t) - near * t) / (near * near);
        g.d0 = (h.d0 - slow) / far;
    }
    return g;
}

#endif
