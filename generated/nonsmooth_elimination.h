/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support/nonsmooth_elimination.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation c87c0c8f13b36941 */
/* Derivatives of implicit functions, for lanes side by side. */
#ifndef NONSMOOTH_ELIMINATION_H
#define NONSMOOTH_ELIMINATION_H

#include <math.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_lanes.h"

#define NONSMOOTH_LEAST_PIVOT 1e-10 /* in units of the matrix */

/* Exchange entries of two rows in the lanes where `wanted` is positive. */
static NONSMOOTH_INLINE void nonsmooth_exchange(int entries, const double *wanted, double *upper,
                                                double *lower)
{
    for (int j = 0; j < entries; ++j)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < NONSMOOTH_LANES; ++lane) {
            const int entry = j * NONSMOOTH_LANES + lane;
            const double above = upper[entry], below = lower[entry];
            upper[entry] = wanted[lane] > 0.0 ? below : above;
            lower[entry] = wanted[lane] > 0.0 ? above : below;
        }
}

/* Subtract a multiple of one row from another. */
static NONSMOOTH_INLINE void nonsmooth_subtract(int entries, const double *factor,
                                                const double *upper, double *lower)
{
    for (int j = 0; j < entries; ++j)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < NONSMOOTH_LANES; ++lane)
            lower[j * NONSMOOTH_LANES + lane] -= factor[lane] * upper[j * NONSMOOTH_LANES + lane];
}

/* Derivatives of n unknowns, and of a function of them, by p parameters.
 *
 * Taken are the derivatives of n equations by the unknowns (jacobian) and by the parameters
 * (moved), and those of the function by both (slope). In their place `moved` gets the derivatives
 * of the unknowns, and `slope` behind its first n entries those of the function. Gaussian
 * elimination with partial pivoting in each lane; NaN where a pivot is below
 * NONSMOOTH_LEAST_PIVOT times the matrix. */
static NONSMOOTH_INLINE void nonsmooth_implicit_derivatives(int n, int p, double *jacobian,
                                                            double *moved, double *slope)
{
    enum { lanes = NONSMOOTH_LANES };
    double size[lanes], least[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        size[lane] = 0.0;
        least[lane] = INFINITY;
    }
    for (int i = 0; i < n * n; ++i)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            size[lane] += jacobian[i * lanes + lane] * jacobian[i * lanes + lane];
    for (int k = 0; k < n; ++k) {
        double *const row = moved + k * p * lanes, *const pivot = jacobian + (k * n + k) * lanes;
        for (int i = k + 1; i < n; ++i) {
            double *const below = jacobian + (i * n + k) * lanes;
            double larger[lanes];
            for (int lane = 0; lane < lanes; ++lane)
                larger[lane] = fabs(below[lane]) - fabs(pivot[lane]);
            nonsmooth_exchange(n - k, larger, pivot, below);
            nonsmooth_exchange(p, larger, row, moved + i * p * lanes);
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double magnitude = fabs(pivot[lane]);
            least[lane] = magnitude < least[lane] ? magnitude : least[lane];
            pivot[lane] = 1.0 / pivot[lane];
        }
        for (int i = k + 1; i < n; ++i) {
            double *const below = jacobian + (i * n + k) * lanes;
            double factor[lanes];
            for (int lane = 0; lane < lanes; ++lane)
                factor[lane] = below[lane] * pivot[lane];
            nonsmooth_subtract(n - k - 1, factor, pivot + lanes, below + lanes);
            nonsmooth_subtract(p, factor, row, moved + i * p * lanes);
        }
    }
    for (int k = n - 1; k >= 0; --k)
        for (int j = 0; j < p; ++j) {
            double *const direction = moved + (k * p + j) * lanes;
            for (int l = k + 1; l < n; ++l)
                NONSMOOTH_SIMD
                for (int lane = 0; lane < lanes; ++lane)
                    direction[lane] +=
                        jacobian[(k * n + l) * lanes + lane] * moved[(l * p + j) * lanes + lane];
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                direction[lane] *= -jacobian[(k * n + k) * lanes + lane];
                slope[(n + j) * lanes + lane] += slope[k * lanes + lane] * direction[lane];
            }
        }
    double lost[lanes];
    for (int lane = 0; lane < lanes; ++lane)
        lost[lane] = least[lane] > NONSMOOTH_LEAST_PIVOT * sqrt(size[lane]) ? 0.0 : (double)NAN;
    for (int j = 0; j < n * p; ++j)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            moved[j * lanes + lane] += lost[lane];
    for (int j = n; j < n + p; ++j)
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            slope[j * lanes + lane] += lost[lane];
}

#endif
