/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support/nonsmooth_trigonometry.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 299106e830d6a50c */
/* Sine and cosine that vectorise, and the angle of a point.
 *
 * C99 with IEEE double arithmetic in round-to-nearest. Scalar, SSE2, AVX2 and AVX-512 builds give
 * the same bits when products and sums are not contracted (-ffp-contract=off). */
#ifndef NONSMOOTH_TRIGONOMETRY_H
#define NONSMOOTH_TRIGONOMETRY_H

#include <math.h>

#include "nonsmooth_compiler.h"

/* Largest argument of nonsmooth_sincos, hence also largest phase w T of nonsmooth_maxima. */
#define NONSMOOTH_PHASE_LIMIT 1e5

/* Sine and cosine of x, each within 0.9 ulp for |x| <= 1e5; both NaN for any other x. */
static NONSMOOTH_INLINE void nonsmooth_sincos(double x, double *sine, double *cosine)
{
    /* Adding and subtracting 1.5 * 2^52 rounds to an integer in every instruction set. */
    const double rounder = 0x1.8p52;
    x = fabs(x) <= NONSMOOTH_PHASE_LIMIT ? x : (double)NAN;
    const double turns = (x * 0x1.45f306dc9c883p-1 + rounder) - rounder;
    const double quadrant = turns - 4.0 * ((0.25 * turns + rounder) - rounder); /* -2 ... 2 */

    /* pi/2 in three parts; the first two products are exact because turns < 2^16. The exact errors
     * of the two rounded subtractions are what r exceeds the reduced argument by. */
    const double head = x - turns * 0x1.921fb54440000p+0;
    const double second = turns * 0x1.68c234c4c0000p-39;
    const double third = turns * 0x1.98a2e03707345p-77;
    const double partial = head - second;
    const double partial_back = partial - head;
    const double partial_excess = (second + partial_back) - (head - (partial - partial_back));
    const double r = partial - third;
    const double r_back = r - partial;
    const double excess = partial_excess + ((third + r_back) - (partial - (r - r_back)));

    /* Interpolants on |r| <= pi/4 with relative errors below 2^-56 and 2^-59. */
    const double z = r * r;
    const double half = 0.5 * z;
    const double sine_tail =
        -0.16666666666666627 +
        z * (0.008333333333321303 +
             z * (-0.00019841269829093668 +
                  z * (2.7557313482773228e-06 +
                       z * (-2.5050729581914156e-08 + z * 1.5895322558328287e-10))));
    const double cosine_tail =
        0.04166666666666666 +
        z * (-0.001388888888888512 +
             z * (2.480158729669849e-05 +
                  z * (-2.7557316505790436e-07 +
                       z * (2.0876022105420294e-09 - z * 1.1375313249835355e-11))));
    /* Subtracting from r keeps the sign of a zero. */
    const double leading = 1.0 - half;
    const double sine_r = r - (excess * leading - r * z * sine_tail);
    const double cosine_r =
        leading + (((1.0 - leading) - half) + (z * z * cosine_tail + r * excess));

    const int swapped = fabs(quadrant) == 1.0;
    const double s = swapped ? cosine_r : sine_r;
    const double c = swapped ? sine_r : cosine_r;
    *sine = fabs(quadrant - 0.5) > 1.0 ? -s : s;
    *cosine = fabs(quadrant + 0.5) > 1.0 ? -c : c;
}

typedef struct {
    double sine, cosine;
} nonsmooth_wave;

/* Sine and cosine: those of the C library for one lane, else those of nonsmooth_sincos. */
static NONSMOOTH_INLINE nonsmooth_wave nonsmooth_wave_of(int lanes, double x)
{
    nonsmooth_wave wave;
    if (lanes == 1) {
        wave.sine = sin(x);
        wave.cosine = cos(x);
    } else
        nonsmooth_sincos(x, &wave.sine, &wave.cosine);
    return wave;
}

/* Angle in [0, 2 pi) of the point (cosine, sine), within 4 ulp; NaN at the origin. */
static NONSMOOTH_INLINE double nonsmooth_angle(double sine, double cosine)
{
    const double a = fabs(sine), b = fabs(cosine);
    const double small = a < b ? a : b, large = a < b ? b : a;
    /* atan q = pi/4 + atan (q - 1)/(q + 1) halves the range of the polynomial */
    const int upper = small > 0x1.a827999fcef32p-2 * large;
    const double q = (upper ? small - large : small) / (upper ? small + large : large);
    const double z = q * q;
    const double tail =
        -0.3333333333333333 +
        z * (0.19999999999999804 +
             z * (-0.14285714285659828 +
                  z * (0.11111111105155447 +
                       z * (-0.09090908753500877 +
                            z * (0.07692296375032143 +
                                 z * (-0.06666424885738255 +
                                      z * (0.05878928997834775 +
                                           z * (-0.05230454270650244 +
                                                z * (0.04551593220626549 +
                                                     z * (-0.034570561981427744 +
                                                          z * 0.016285756855221028))))))))));
    const double octant = upper ? 0x1.921fb54442d18p-1 + (0x1.1a62633145c07p-55 + (q + q * z * tail))
                                : q + q * z * tail;
    const double quarter = a > b ? 0x1.921fb54442d18p+0 - (octant - 0x1.1a62633145c07p-54) : octant;
    const double half = cosine < 0.0 ? 0x1.921fb54442d18p+1 - (quarter - 0x1.1a62633145c07p-53) : quarter;
    return sine < 0.0 ? 0x1.921fb54442d18p+2 - (half - 0x1.1a62633145c07p-52) : half;
}

#endif
