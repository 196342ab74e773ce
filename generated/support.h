/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation cc596d300a5a17eb */
/* Numerical support of the generated C: sine and cosine that vectorise, and guaranteed maxima of
 * trigonometric sums
 *
 *     g(t) = a0 + a1 t + sum_j [ c_j cos(w_j t) + s_j sin(w_j t) ].
 *
 * C99 with IEEE double arithmetic in round-to-nearest. Scalar, SSE2 and AVX2 builds give the same
 * bits when products and sums are not contracted (-ffp-contract=off). */
#ifndef NONSMOOTH_SUPPORT_H
#define NONSMOOTH_SUPPORT_H

#include <float.h>
#include <math.h>

/* One build serves processors with and without AVX2; both give the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define NONSMOOTH_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define NONSMOOTH_MULTIVERSION
#endif

/* Largest argument of nonsmooth_sincos, hence also largest phase w T of nonsmooth_maxima. */
#define NONSMOOTH_PHASE_LIMIT 1e5

/* Sine and cosine of x, each within 0.9 ulp for |x| <= 1e5; both NaN for any other x. */
static inline void nonsmooth_sincos(double x, double *sine, double *cosine)
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

/* Angle in [0, 2 pi) of the point (cosine, sine), within 4 ulp; NaN at the origin. */
static inline double nonsmooth_angle(double sine, double cosine)
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

enum {
    NONSMOOTH_TERMS = 8,     /* most frequencies of a sum */
    NONSMOOTH_LEVELS = 4,    /* grid points of a block are 2^levels */
    NONSMOOTH_POINTS = 16,
    NONSMOOTH_STACK = 64,    /* cells waiting in one refinement */
    NONSMOOTH_SPLITS = 8192, /* bisections of one grid cell */
    NONSMOOTH_NEWTON = 64    /* iterations of one polish */
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

typedef struct {
    double time, value, slope, curvature;
} nonsmooth_jet;

typedef struct {
    nonsmooth_jet left, right;
    int polished;
} nonsmooth_cell;

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

/* Upper bound of g on a cell: the cubic Hermite interpolant as a quartic in Bernstein form. Its
 * error, at most M4 h^4/24 u^2 (1-u)^2 with |g''''| <= M4, is M4 h^4/144 = excess times the middle
 * Bernstein polynomial. */
static inline double nonsmooth_upper(double value0, double slope0, double value1, double slope1,
                                     double width, double excess)
{
    const double first = value0 + 0.25 * width * slope0;
    const double middle = 0.5 * (value0 + value1) + width * (slope0 - slope1) / 6.0 + excess;
    const double last = value1 - 0.25 * width * slope1;
    const double outer = value0 > value1 ? value0 : value1;
    const double inner = first > last ? first : last;
    const double most = outer > inner ? outer : inner;
    return most > middle ? most : middle;
}

/* The maximum of g inside a cell with g' > 0 on its left and g' < 0 on its right, by Newton kept in
 * the bracket, until the slope no longer matters to the bound over the cell. */
static inline nonsmooth_jet nonsmooth_polish(int terms, const double *frequency, const double *row,
                                             const nonsmooth_cell *cell, double slack)
{
    double low = cell->left.time, high = cell->right.time;
    const double width = high - low;
    double time = low + width * (cell->left.slope / (cell->left.slope - cell->right.slope));
    nonsmooth_jet jet = nonsmooth_evaluate(terms, frequency, row, time);
    for (int i = 0; i < NONSMOOTH_NEWTON && width * fabs(jet.slope) > slack; ++i) {
        if (jet.slope > 0.0)
            low = time;
        else
            high = time;
        time -= jet.slope / jet.curvature;
        if (!(time > low && time < high))
            time = 0.5 * (low + high);
        jet = nonsmooth_evaluate(terms, frequency, row, time);
    }
    return jet;
}

/* Raise *maximum to the maximum of g over the cell, to within slack. When the cells run out the
 * upper bound itself is taken, which errs on the safe side. */
static inline void nonsmooth_refine(int terms, const double *frequency, const double *row,
                                    nonsmooth_cell cell, double slack, double excess,
                                    double *maximum, double *time)
{
    nonsmooth_cell stack[NONSMOOTH_STACK];
    const double full = cell.right.time - cell.left.time;
    int waiting = 0, splits = 0;
    for (;;) {
        const double width = cell.right.time - cell.left.time, ratio = width / full;
        const double upper =
            nonsmooth_upper(cell.left.value, cell.left.slope, cell.right.value, cell.right.slope,
                            width, excess * (ratio * ratio) * (ratio * ratio));
        if (upper > *maximum + slack) {
            const double centre = cell.left.time + 0.5 * width;
            if (splits < NONSMOOTH_SPLITS && waiting < NONSMOOTH_STACK) {
                /* Split at the maximum: there both halves are discarded at once. A half is not
                 * polished again, or a maximum near its end would never leave it. */
                const int polished =
                    !cell.polished && cell.left.slope > 0.0 && cell.right.slope < 0.0;
                const nonsmooth_jet jet =
                    polished ? nonsmooth_polish(terms, frequency, row, &cell, slack)
                             : nonsmooth_evaluate(terms, frequency, row, centre);
                if (jet.value > *maximum) {
                    *maximum = jet.value;
                    *time = jet.time;
                }
                const nonsmooth_cell right = {jet, cell.right, polished};
                stack[waiting++] = right;
                cell.right = jet;
                cell.polished = polished;
                ++splits;
                continue;
            }
            *maximum = upper;
            *time = centre;
        }
        if (waiting == 0)
            return;
        cell = stack[--waiting];
    }
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
    double step_sine[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    double step_cosine[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    double phase[NONSMOOTH_TERMS * NONSMOOTH_LEVELS];
    for (int j = 0; j < terms; ++j)
        for (int level = 0; level < NONSMOOTH_LEVELS; ++level)
            phase[NONSMOOTH_LEVELS * j + level] = frequency[j] * width * (1 << level);
#pragma omp simd
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
#pragma omp simd
                for (int k = 0; k < NONSMOOTH_POINTS; ++k) {
                    value[k] += c * cosine[j][k] + s * sine[j][k];
                    slope[k] += w * (s * cosine[j][k] - c * sine[j][k]);
                }
            }
            double above = 0.0;
            const double best = maximum[i];
#pragma omp simd reduction(+ : above)
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
                    nonsmooth_refine(terms, frequency, row, cell, slack, excess, &maximum[i],
                                     &time[i]);
                }
        }
    }
}

#endif
