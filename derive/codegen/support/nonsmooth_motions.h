/* Guaranteed maxima of affine functions along any linear motion y' = A y + b. */
#ifndef NONSMOOTH_MOTIONS_H
#define NONSMOOTH_MOTIONS_H

#include <float.h>
#include <math.h>

#include "nonsmooth_search.h"
#include "nonsmooth_trigonometry.h"

enum {
    NONSMOOTH_STATES = 16,  /* most states of a linear motion */
    NONSMOOTH_DEGREE = 16,  /* of Taylor's polynomial over a step of it */
    NONSMOOTH_BALANCING = 3 /* sweeps over its states */
};

/* A linear motion y' = A y + b over [0, duration], cut into equal steps that are short against A.
 *
 * |y| below is max_i |y_i| / x_i with weights x > 0, and |A| the norm max_i sum_j |A_ij| x_j / x_i
 * that belongs to it, so that |y'| grows by e^(|A| h) at most over a time h. */
typedef struct {
    int states;
    const double *field, *start; /* rows [A, b], of states + 1 numbers each; the state at 0 */
    long long steps;             /* 0 where nothing can be guaranteed */
    double duration, width, norm;
    double size;                  /* largest |y| at the ends of the steps */
    double end[NONSMOOTH_STATES];
    double weight[NONSMOOTH_STATES];
    double step[NONSMOOTH_STATES * NONSMOOTH_STATES]; /* y(t + width) - y(t) = step y'(t) */
} nonsmooth_motion;

/* y' at a state. */
static inline void nonsmooth_rate(const nonsmooth_motion *motion, const double *state, double *rate)
{
    const int n = motion->states;
    for (int i = 0; i < n; ++i) {
        const double *const row = motion->field + i * (n + 1);
        rate[i] = row[n];
        for (int j = 0; j < n; ++j)
            rate[i] += row[j] * state[j];
    }
}

/* One step of a state, of which the rate is given too. */
static inline void nonsmooth_march(const nonsmooth_motion *motion, double *state, double *rate)
{
    const int n = motion->states;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            state[i] += motion->step[i * n + j] * rate[j];
    nonsmooth_rate(motion, state, rate);
}

/* |y|; NaN where y is. */
static inline double nonsmooth_size(const nonsmooth_motion *motion, const double *state)
{
    double size = 0.0;
    for (int i = 0; i < motion->states; ++i) {
        const double part = fabs(state[i]) / motion->weight[i];
        size = part > size || part != part ? part : size;
    }
    return size;
}

/* Weights and norm by Osborne's balancing (1960). What drives and is not driven, or is driven and
 * does not drive, is balanced against the duration. */
static inline void nonsmooth_balance(nonsmooth_motion *motion)
{
    const int n = motion->states;
    const double least = motion->duration > 0.0 ? 1.0 / motion->duration : 1.0;
    double *const x = motion->weight;
    for (int i = 0; i < n; ++i)
        x[i] = 1.0;
    for (int turn = 0; turn < NONSMOOTH_BALANCING; ++turn)
        for (int i = 0; i < n; ++i) {
            double row = 0.0, column = 0.0;
            for (int j = 0; j < n; ++j)
                if (j != i) {
                    row += fabs(motion->field[i * (n + 1) + j]) * x[j];
                    column += fabs(motion->field[j * (n + 1) + i]) / x[j];
                }
            x[i] *= sqrt((row / x[i] + least) / (column * x[i] + least));
        }
    motion->norm = 0.0;
    for (int i = 0; i < n; ++i) {
        double sum = 0.0;
        for (int j = 0; j < n; ++j)
            sum += fabs(motion->field[i * (n + 1) + j]) * x[j];
        sum /= x[i];
        motion->norm = sum > motion->norm || sum != sum ? sum : motion->norm;
    }
}

/* step = h sum_k (A h)^k / (k + 1)!, k = 0 ... 15, of which 6 products are taken (Paterson and
 * Stockmeyer 1973); the rest is below 0.6^17/17! of the whole. */
static inline void nonsmooth_transition(nonsmooth_motion *motion)
{
    enum { entries = NONSMOOTH_STATES * NONSMOOTH_STATES };
    const int n = motion->states;
    double power[5][entries], sum[entries];
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            power[0][i * n + j] = i == j ? 1.0 : 0.0;
            power[1][i * n + j] = motion->field[i * (n + 1) + j] * motion->width;
            sum[i * n + j] = 0.0;
        }
    for (int k = 2; k <= 4; ++k)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                double entry = 0.0;
                for (int l = 0; l < n; ++l)
                    entry += power[k - 1][i * n + l] * power[1][l * n + j];
                power[k][i * n + j] = entry;
            }
    static const double factor[] = {
        1.0,
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5040.0,
        1.0 / 40320.0,
        1.0 / 362880.0,
        1.0 / 3628800.0,
        1.0 / 39916800.0,
        1.0 / 479001600.0,
        1.0 / 6227020800.0,
        1.0 / 87178291200.0,
        1.0 / 1307674368000.0,
        1.0 / 20922789888000.0,
    };
    for (int group = 3; group >= 0; --group)
        for (int i = 0; i < n; ++i) {
            double row[NONSMOOTH_STATES];
            for (int j = 0; j < n; ++j) {
                row[j] = 0.0;
                for (int k = 3; k >= 0; --k)
                    row[j] += factor[4 * group + k] * power[k][i * n + j];
            }
            if (group < 3)
                for (int l = 0; l < n; ++l)
                    for (int j = 0; j < n; ++j)
                        row[j] += sum[i * n + l] * power[4][l * n + j];
            for (int j = 0; j < n; ++j)
                sum[i * n + j] = row[j];
        }
    for (int i = 0; i < n * n; ++i)
        motion->step[i] = motion->width * sum[i];
}

/* Prepare a motion of `states` <= NONSMOOTH_STATES. Nothing is guaranteed, and `steps` is 0, for a
 * negative duration, numbers that are not finite, states beyond 1e290, and a duration beyond
 * 1e5 / |A|, which also bounds the steps. */
static inline nonsmooth_motion nonsmooth_motion_of(int states, const double *field,
                                                   const double *start, double duration)
{
    nonsmooth_motion motion;
    motion.states = states;
    motion.field = field;
    motion.start = start;
    motion.duration = duration;
    motion.steps = 0;
    motion.size = (double)NAN;
    motion.norm = (double)NAN;
    motion.width = 0.0;
    for (int i = 0; i < states; ++i)
        motion.end[i] = (double)NAN;
    if (!(duration >= 0.0))
        return motion;
    nonsmooth_balance(&motion);
    if (!(duration * motion.norm <= NONSMOOTH_PHASE_LIMIT)) /* in units of 1 / |A| */
        return motion;
    const long long steps = 1 + (long long)(duration * motion.norm / 0.6);
    motion.width = duration / (double)steps;
    nonsmooth_transition(&motion);
    double rate[NONSMOOTH_STATES];
    for (int i = 0; i < states; ++i)
        motion.end[i] = start[i];
    nonsmooth_rate(&motion, motion.end, rate);
    motion.size = nonsmooth_size(&motion, motion.end);
    for (long long step = 0; step < steps; ++step) {
        nonsmooth_march(&motion, motion.end, rate);
        const double size = nonsmooth_size(&motion, motion.end);
        motion.size = size > motion.size || size != size ? size : motion.size;
    }
    if (motion.size < 1e290)
        motion.steps = steps;
    return motion;
}

/* g = n y + c at a state, row = [n, c]. */
static inline double nonsmooth_value(int states, const double *row, const double *state)
{
    double value = row[states];
    for (int i = 0; i < states; ++i)
        value += row[i] * state[i];
    return value;
}

/* Bound on the rounding error of g = n y + c along a motion, row = [n, c]:
 * 32 eps (|c| + sum_i |n_i| x_i |y|)(1 + |A| T). */
static inline double nonsmooth_motion_rounding(const nonsmooth_motion *motion, const double *row)
{
    double scale = 0.0;
    for (int i = 0; i < motion->states; ++i)
        scale += fabs(row[i]) * motion->weight[i];
    scale = scale * motion->size + fabs(row[motion->states]);
    return 32.0 * DBL_EPSILON * scale * (1.0 + motion->norm * motion->duration);
}

/* Does g rise at 0 beyond the error of its slope, where g itself is known to within noise? */
static inline int nonsmooth_motion_rises(const nonsmooth_motion *motion, const double *row,
                                         double noise)
{
    const int n = motion->states;
    double slope = 0.0, size = 0.0;
    for (int i = 0; i < n; ++i) {
        const double *const field = motion->field + i * (n + 1);
        double rate = field[n], parts = fabs(field[n]);
        for (int j = 0; j < n; ++j) {
            rate += field[j] * motion->start[j];
            parts += fabs(field[j] * motion->start[j]);
        }
        slope += row[i] * rate;
        size += fabs(row[i]) * parts;
    }
    return slope > 32.0 * DBL_EPSILON * size + motion->norm * noise;
}

/* Taylor's polynomial of g within a step that begins at `origin`. */
typedef struct {
    double origin, coefficient[NONSMOOTH_DEGREE + 1];
} nonsmooth_expansion;

static inline nonsmooth_jet nonsmooth_evaluate_expansion(const void *function, double time)
{
    const nonsmooth_expansion *const g = (const nonsmooth_expansion *)function;
    const double s = time - g->origin;
    nonsmooth_jet jet = {time, g->coefficient[NONSMOOTH_DEGREE], 0.0, 0.0};
    for (int k = NONSMOOTH_DEGREE - 1; k >= 0; --k) {
        jet.curvature = jet.curvature * s + 2.0 * jet.slope;
        jet.slope = jet.slope * s + jet.value;
        jet.value = jet.value * s + g->coefficient[k];
    }
    return jet;
}

/* That polynomial, from the state at the beginning of the step and its rate: of the degree 16 its
 * rest is below that of a step. */
static inline nonsmooth_expansion nonsmooth_expand(const nonsmooth_motion *motion,
                                                   const double *row, double origin,
                                                   const double *rate, double value)
{
    const int n = motion->states;
    nonsmooth_expansion g;
    double now[NONSMOOTH_STATES];
    for (int i = 0; i < n; ++i)
        now[i] = rate[i];
    g.origin = origin;
    g.coefficient[0] = value;
    for (int k = 1; k <= NONSMOOTH_DEGREE; ++k) {
        double next[NONSMOOTH_STATES], found = 0.0;
        for (int i = 0; i < n; ++i) {
            found += row[i] * now[i];
            next[i] = 0.0;
            for (int j = 0; j < n; ++j)
                next[i] += motion->field[i * (n + 1) + j] * now[j];
        }
        g.coefficient[k] = found / k;
        for (int i = 0; i < n; ++i)
            now[i] = next[i] / k;
    }
    return g;
}

/* |g''''| <= this times |y'| at the beginning of a step, all through the step: e^0.6 sum |n A^3| x. */
static inline double nonsmooth_bend(const nonsmooth_motion *motion, const double *row)
{
    const int n = motion->states;
    double now[NONSMOOTH_STATES], sum = 0.0;
    for (int i = 0; i < n; ++i)
        now[i] = row[i];
    for (int power = 0; power < 3; ++power) {
        double next[NONSMOOTH_STATES];
        for (int j = 0; j < n; ++j) {
            next[j] = 0.0;
            for (int i = 0; i < n; ++i)
                next[j] += now[i] * motion->field[i * (n + 1) + j];
        }
        for (int i = 0; i < n; ++i)
            now[i] = next[i];
    }
    for (int i = 0; i < n; ++i)
        sum += fabs(now[i]) * motion->weight[i];
    return 1.8221188003905091 * sum;
}

/* Guaranteed maxima along a motion of several functions g = n y + c, rows [n, c]: as those of
 * nonsmooth_sums.h, with nonsmooth_motion_rounding and with NaN where the motion has no steps. A
 * step is a cell of that search; where one is not decided g is Taylor's polynomial. */
static inline void nonsmooth_motion_maxima(const nonsmooth_motion *motion, int sums,
                                           const double *rows, const double *floor,
                                           double *maximum, double *time)
{
    const int n = motion->states;
    const double width = motion->width, fourth = width * width * (width * width) / 144.0;
    long long splits =
        (long long)sums * (NONSMOOTH_SPLITS + (long long)NONSMOOTH_MORE * motion->steps);
    double state[NONSMOOTH_POINTS][NONSMOOTH_STATES], rate[NONSMOOTH_POINTS][NONSMOOTH_STATES];
    double size[NONSMOOTH_POINTS];
    for (int i = 0; i < sums; ++i) {
        const int known =
            motion->steps > 0 && nonsmooth_motion_rounding(motion, rows + i * (n + 1)) < 1e290;
        maximum[i] = known ? floor[i] : (double)NAN;
        time[i] = (double)NAN;
    }
    for (int i = 0; i < n; ++i)
        state[0][i] = motion->start[i];
    nonsmooth_rate(motion, state[0], rate[0]);
    for (long long start = 0; start < motion->steps; start += NONSMOOTH_POINTS - 1) {
        const long long left = motion->steps - start;
        const int count = left < NONSMOOTH_POINTS - 1 ? (int)left : NONSMOOTH_POINTS - 1;
        double instant[NONSMOOTH_POINTS];
        for (int k = 0; k <= count; ++k)
            instant[k] = (double)(start + k) * width;
        if (count == left)
            instant[count] = motion->duration;
        for (int k = 0; k < count; ++k) {
            size[k] = nonsmooth_size(motion, rate[k]) * fourth;
            for (int i = 0; i < n; ++i) {
                state[k + 1][i] = state[k][i];
                rate[k + 1][i] = rate[k][i];
            }
            nonsmooth_march(motion, state[k + 1], rate[k + 1]);
        }
        for (int i = 0; i < sums; ++i) {
            const double *const row = rows + i * (n + 1);
            double value[NONSMOOTH_POINTS], slope[NONSMOOTH_POINTS], upper[NONSMOOTH_POINTS];
            if (maximum[i] != maximum[i])
                continue;
            for (int k = 0; k <= count; ++k) {
                value[k] = row[n];
                slope[k] = 0.0;
                for (int j = 0; j < n; ++j) {
                    value[k] += row[j] * state[k][j];
                    slope[k] += row[j] * rate[k][j];
                }
            }
            const double bend = nonsmooth_bend(motion, row), best = maximum[i];
            int above = 0;
            for (int k = 0; k < count; ++k) {
                upper[k] = nonsmooth_upper(value[k], slope[k], value[k + 1], slope[k + 1], width,
                                           bend * size[k]);
                above |= upper[k] > best;
            }
            if (!above)
                continue;
            for (int k = 0; k <= count; ++k)
                if (value[k] > maximum[i]) {
                    maximum[i] = value[k];
                    time[i] = instant[k];
                }
            const double slack = 0.25 * nonsmooth_motion_rounding(motion, row);
            for (int k = 0; k < count; ++k)
                if (upper[k] > maximum[i] + slack) {
                    const nonsmooth_cell cell = {{instant[k], value[k], slope[k], 0.0},
                                                 {instant[k + 1], value[k + 1], slope[k + 1], 0.0},
                                                 0};
                    const nonsmooth_expansion taylor =
                        nonsmooth_expand(motion, row, instant[k], rate[k], value[k]);
                    const nonsmooth_curve g = {nonsmooth_evaluate_expansion, &taylor};
                    nonsmooth_refine(g, cell, slack, bend * size[k], &splits, &maximum[i],
                                     &time[i]);
                }
        }
        for (int i = 0; i < n; ++i) {
            state[0][i] = state[count][i];
            rate[0][i] = rate[count][i];
        }
    }
}

#endif
