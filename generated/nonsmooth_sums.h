/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support/nonsmooth_sums.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 487269ce2fced30b */
/* Guaranteed maxima of trigonometric sums
 *
 *     g(t) = a0 + a1 t + sum_j [ c_j cos(w_j t) + s_j sin(w_j t) ]. */
#ifndef NONSMOOTH_SUMS_H
#define NONSMOOTH_SUMS_H

#include <float.h>
#include <math.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_search.h"
#include "nonsmooth_trigonometry.h"

enum {
    NONSMOOTH_TERMS = 8, /* most frequencies of a sum */
    NONSMOOTH_LEVELS = 4 /* points of a block are 2^levels */
};

/* Bound on the rounding error of a maximum over [0, duration]:
 * 32 eps (|a0| + |a1| T + sum_j (|c_j| + |s_j|)(1 + w_j T)), row = [a0, a1, c_1..., s_1...]. */
static inline double nonsmooth_rounding(int terms, const double *frequency, const double *row,
                                        double duration)
{
    double scale = fabs(row[0]) + fabs(row[1]) * duration;
    for (int j = 0; j < terms; ++j)
        scale += (fabs(row[2 + j]) + fabs(row[2 + terms + j])) * (1.0 + frequency[j] * duration);
    return 32.0 * DBL_EPSILON * scale;
}

static inline nonsmooth_jet nonsmooth_evaluate(int terms, const double *frequency,
                                               const double *row, double time)
{
    nonsmooth_jet jet = {time, row[0] + row[1] * time, row[1], 0.0};
    for (int j = 0; j < terms; ++j) {
        const double w = frequency[j], c = row[2 + j], s = row[2 + terms + j];
        double sine, cosine;
        nonsmooth_sincos(w * time, &sine, &cosine);
        const double wave = c * cosine + s * sine;
        jet.value += wave;
        jet.slope += w * (s * cosine - c * sine);
        jet.curvature -= w * w * wave;
    }
    return jet;
}

typedef struct {
    int terms;
    const double *frequency, *row;
} nonsmooth_sum_data;

static inline nonsmooth_jet nonsmooth_evaluate_sum(const void *function, double time)
{
    const nonsmooth_sum_data *const sum = (const nonsmooth_sum_data *)function;
    return nonsmooth_evaluate(sum->terms, sum->frequency, sum->row, time);
}

/* Does g rise at 0 beyond the error of its slope, where g itself is known to within noise? */
static inline int nonsmooth_rises(int terms, const double *frequency, const double *row,
                                  double noise)
{
    double slope = row[1], size = fabs(row[1]), fastest = 0.0;
    for (int j = 0; j < terms; ++j) {
        const double w = frequency[j];
        slope += w * row[2 + terms + j];
        size += w * (fabs(row[2 + j]) + fabs(row[2 + terms + j]));
        fastest = w > fastest ? w : fastest;
    }
    return slope > 32.0 * DBL_EPSILON * size + fastest * noise;
}

/* Guaranteed maxima over [0, duration] of several sums with common frequencies w_j >= 0.
 *
 * coefficients: one row [a0, a1, c_1..c_n, s_1..s_n] for each sum, n = terms <= 8.
 * maximum[i] = max(floor[i], max g_i) and time[i] where it is attained; where g_i stays at or below
 * floor[i], maximum[i] = floor[i] and time[i] is NaN. No value of g_i exceeds maximum[i] by more
 * than nonsmooth_rounding() of its row.
 *
 * The work grows as duration * max w, at 0.6 to a cell; beyond duration * max w = 1e5 the results
 * are NaN. So they are for NaN or infinite data, a negative duration or frequency, a NaN floor, or
 * more than 8 terms. */
static inline void nonsmooth_maxima(int sums, int terms, const double *frequency,
                                    const double *coefficients, double duration,
                                    const double *floor, double *maximum, double *time)
{
    const int length = 2 + 2 * terms;
    double fastest = 0.0;
    int valid = duration >= 0.0 && terms <= NONSMOOTH_TERMS;
    for (int j = 0; valid && j < terms; ++j) {
        valid = frequency[j] >= 0.0;
        fastest = frequency[j] > fastest ? frequency[j] : fastest;
    }
    valid = valid && duration * fastest <= NONSMOOTH_PHASE_LIMIT;
    for (int i = 0; i < sums; ++i) {
        /* Below 1e290 no later sum can overflow. */
        const int known =
            valid &&
            nonsmooth_rounding(terms, frequency, coefficients + i * length, duration) < 1e290;
        maximum[i] = known ? floor[i] : (double)NAN;
        time[i] = (double)NAN;
    }
    if (!valid)
        return;

    const int cells = 1 + (int)(duration * fastest / 0.6);
    const double width = duration / cells;
    long long splits = (long long)sums * (NONSMOOTH_SPLITS + (long long)NONSMOOTH_MORE * cells);
    double step_sine[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    double step_cosine[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    double phase[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    for (int j = 0; j < terms; ++j)
        for (int level = 0; level < NONSMOOTH_LEVELS; ++level)
            phase[NONSMOOTH_LEVELS * j + level] = frequency[j] * width * (1 << level);
    NONSMOOTH_SIMD
    for (int k = 0; k < NONSMOOTH_LEVELS * terms; ++k)
        nonsmooth_sincos(phase[k], &step_sine[k], &step_cosine[k]);

    for (int start = 0; start < cells; start += NONSMOOTH_POINTS - 1) {
        const int left = cells - start;
        const int count = left < NONSMOOTH_POINTS - 1 ? left : NONSMOOTH_POINTS - 1;
        double sine[NONSMOOTH_TERMS][NONSMOOTH_POINTS], cosine[NONSMOOTH_TERMS][NONSMOOTH_POINTS];
        double instant[NONSMOOTH_POINTS];
        for (int k = 0; k < NONSMOOTH_POINTS; ++k)
            instant[k] = (start + k) * width;
        if (count == left)
            instant[count] = duration;
        for (int j = 0; j < terms; ++j) {
            /* Four rotations at most lead from the anchor to a point, so no error builds up. */
            double *const c = cosine[j], *const s = sine[j];
            nonsmooth_sincos(frequency[j] * instant[0], &s[0], &c[0]);
            for (int level = 0; level < NONSMOOTH_LEVELS; ++level) {
                const int known = 1 << level;
                const double a = step_cosine[NONSMOOTH_LEVELS * j + level];
                const double b = step_sine[NONSMOOTH_LEVELS * j + level];
                for (int k = 0; k < known; ++k) {
                    c[known + k] = c[k] * a - s[k] * b;
                    s[known + k] = s[k] * a + c[k] * b;
                }
            }
        }
        for (int i = 0; i < sums; ++i) {
            const double *const row = coefficients + i * length;
            double value[NONSMOOTH_POINTS], slope[NONSMOOTH_POINTS], upper[NONSMOOTH_POINTS];
            double excess = 0.0;
            if (maximum[i] != maximum[i])
                continue;
            for (int k = 0; k < NONSMOOTH_POINTS; ++k) {
                value[k] = row[0] + row[1] * instant[k];
                slope[k] = row[1];
            }
            for (int j = 0; j < terms; ++j) {
                const double w = frequency[j], c = row[2 + j], s = row[2 + terms + j];
                const double angle = w * width;
                excess += (fabs(c) + fabs(s)) * (angle * angle) * (angle * angle) / 144.0;
                NONSMOOTH_SIMD
                for (int k = 0; k < NONSMOOTH_POINTS; ++k) {
                    value[k] += c * cosine[j][k] + s * sine[j][k];
                    slope[k] += w * (s * cosine[j][k] - c * sine[j][k]);
                }
            }
            double above = 0.0;
            const double best = maximum[i];
            NONSMOOTH_SIMD_SUM(above)
            for (int k = 0; k < count; ++k) {
                upper[k] =
                    nonsmooth_upper(value[k], slope[k], value[k + 1], slope[k + 1], width, excess);
                above += upper[k] > best ? 1.0 : 0.0;
            }
            if (above == 0.0)
                continue;
            for (int k = 0; k <= count; ++k)
                if (value[k] > maximum[i]) {
                    maximum[i] = value[k];
                    time[i] = instant[k];
                }
            /* A quarter of the tolerance ends the search, the rest covers rounding errors. */
            const double slack = 0.25 * nonsmooth_rounding(terms, frequency, row, duration);
            for (int k = 0; k < count; ++k)
                if (upper[k] > maximum[i] + slack) {
                    const nonsmooth_cell cell = {{instant[k], value[k], slope[k], 0.0},
                                                 {instant[k + 1], value[k + 1], slope[k + 1], 0.0},
                                                 0};
                    const nonsmooth_sum_data data = {terms, frequency, row};
                    const nonsmooth_curve g = {nonsmooth_evaluate_sum, &data};
                    nonsmooth_refine(g, cell, slack, excess, &splits, &maximum[i], &time[i]);
                }
        }
    }
}

#endif
