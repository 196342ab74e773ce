/* Numerical support of the generated C: sine and cosine that vectorise, guaranteed maxima of
 * trigonometric sums
 *
 *     g(t) = a0 + a1 t + sum_j [ c_j cos(w_j t) + s_j sin(w_j t) ]
 *
 * and of affine functions along any linear motion y' = A y + b, and the functions of time of such
 * motions, divided differences of e^(lambda t).
 *
 * C99 with IEEE double arithmetic in round-to-nearest. Scalar, SSE2, AVX2 and AVX-512 builds give
 * the same bits when products and sums are not contracted (-ffp-contract=off). */
#ifndef NONSMOOTH_SUPPORT_H
#define NONSMOOTH_SUPPORT_H

#include <float.h>
#include <math.h>

/* One build serves processors with AVX-512, AVX2 and neither; all give the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
#define NONSMOOTH_MULTIVERSION __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define NONSMOOTH_MULTIVERSION
#endif

/* A function that is too long to be copied to where it is called, and may not be called at all. */
#if defined(__GNUC__)
#define NONSMOOTH_UNUSED __attribute__((unused, noinline))
#else
#define NONSMOOTH_UNUSED
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
    NONSMOOTH_SPLITS = 8192, /* bisections of the cells of a sum */
    NONSMOOTH_MORE = 16,     /* and for each of its cells */
    NONSMOOTH_NEWTON = 64,   /* iterations of one polish */
    NONSMOOTH_STATES = 16,   /* most states of a linear motion */
    NONSMOOTH_DEGREE = 16,   /* of Taylor's polynomial over a step of it */
    NONSMOOTH_BALANCING = 3  /* sweeps over its states */
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

/* A function of time, and what gives its value and derivatives. */
typedef struct {
    nonsmooth_jet (*evaluate)(const void *function, double time);
    const void *function;
} nonsmooth_curve;

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
static inline nonsmooth_jet nonsmooth_polish(nonsmooth_curve g, const nonsmooth_cell *cell,
                                             double slack)
{
    double low = cell->left.time, high = cell->right.time;
    const double width = high - low;
    double time = low + width * (cell->left.slope / (cell->left.slope - cell->right.slope));
    nonsmooth_jet jet = g.evaluate(g.function, time);
    for (int i = 0; i < NONSMOOTH_NEWTON && width * fabs(jet.slope) > slack; ++i) {
        if (jet.slope > 0.0)
            low = time;
        else
            high = time;
        time -= jet.slope / jet.curvature;
        if (!(time > low && time < high))
            time = 0.5 * (low + high);
        jet = g.evaluate(g.function, time);
    }
    return jet;
}

/* Raise *maximum to the maximum of g over the cell, to within slack. When the cells or the splits
 * run out the upper bound itself is taken, which errs on the safe side: each turn of the loop spends
 * a split or takes a cell that a split left, so that there are at most twice as many as splits. */
static inline void nonsmooth_refine(nonsmooth_curve g, nonsmooth_cell cell, double slack,
                                    double excess, long long *splits, double *maximum, double *time)
{
    nonsmooth_cell stack[NONSMOOTH_STACK];
    const double full = cell.right.time - cell.left.time;
    int waiting = 0;
    for (;;) {
        const double width = cell.right.time - cell.left.time, ratio = width / full;
        const double upper =
            nonsmooth_upper(cell.left.value, cell.left.slope, cell.right.value, cell.right.slope,
                            width, excess * (ratio * ratio) * (ratio * ratio));
        if (upper > *maximum + slack) {
            const double centre = cell.left.time + 0.5 * width;
            if (*splits > 0 && waiting < NONSMOOTH_STACK) {
                /* Split at the maximum: there both halves are discarded at once. A half is not
                 * polished again, or a maximum near its end would never leave it. */
                const int polished =
                    !cell.polished && cell.left.slope > 0.0 && cell.right.slope < 0.0;
                const nonsmooth_jet jet = polished ? nonsmooth_polish(g, &cell, slack)
                                                   : g.evaluate(g.function, centre);
                if (jet.value > *maximum) {
                    *maximum = jet.value;
                    *time = jet.time;
                }
                const nonsmooth_cell right = {jet, cell.right, polished};
                stack[waiting++] = right;
                cell.right = jet;
                cell.polished = polished;
                --*splits;
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
    long long splits = (long long)sums * (NONSMOOTH_SPLITS + (long long)NONSMOOTH_MORE * cells);
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
                    const nonsmooth_sum_data data = {terms, frequency, row};
                    const nonsmooth_curve g = {nonsmooth_evaluate_sum, &data};
                    nonsmooth_refine(g, cell, slack, excess, &splits, &maximum[i], &time[i]);
                }
        }
    }
}

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
    if (!(duration * motion.norm <= NONSMOOTH_PHASE_LIMIT))
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

/* As nonsmooth_rises. */
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

/* Guaranteed maxima along a motion of several functions g = n y + c, rows [n, c]: as
 * nonsmooth_maxima gives them, with nonsmooth_motion_rounding and with NaN where the motion has no
 * steps. A step is a cell of that search; where one is not decided g is Taylor's polynomial. */
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

/* Roots whose distance times t is at most NONSMOOTH_NEAR are taken together; terms of exponential
 * series for arguments up to 1, and up to that. */
#define NONSMOOTH_NEAR 3.0
enum { NONSMOOTH_SHORT = 22, NONSMOOTH_SERIES = 34 };

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

typedef struct {
    double re, im;
} nonsmooth_complex;

static inline nonsmooth_complex nonsmooth_number(double re, double im)
{
    const nonsmooth_complex z = {re, im};
    return z;
}

static inline nonsmooth_complex nonsmooth_sum(nonsmooth_complex x, nonsmooth_complex y)
{
    return nonsmooth_number(x.re + y.re, x.im + y.im);
}

static inline nonsmooth_complex nonsmooth_gap(nonsmooth_complex x, nonsmooth_complex y)
{
    return nonsmooth_number(x.re - y.re, x.im - y.im);
}

static inline nonsmooth_complex nonsmooth_scaled(double f, nonsmooth_complex x)
{
    return nonsmooth_number(f * x.re, f * x.im);
}

static inline nonsmooth_complex nonsmooth_product(nonsmooth_complex x, nonsmooth_complex y)
{
    return nonsmooth_number(x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re);
}

/* x/y without overflow of |y|^2 (Smith, 1962). */
static inline nonsmooth_complex nonsmooth_quotient(nonsmooth_complex x, nonsmooth_complex y)
{
    if (fabs(y.re) >= fabs(y.im)) {
        const double ratio = y.im / y.re, divisor = y.re + y.im * ratio;
        return nonsmooth_number((x.re + x.im * ratio) / divisor, (x.im - x.re * ratio) / divisor);
    }
    const double ratio = y.re / y.im, divisor = y.im + y.re * ratio;
    return nonsmooth_number((x.re * ratio + x.im) / divisor, (x.im * ratio - x.re) / divisor);
}

static inline nonsmooth_complex nonsmooth_exponential(nonsmooth_complex x, double t)
{
    double sine, cosine;
    const double growth = x.re == 0.0 ? 1.0 : exp(x.re * t);
    nonsmooth_turn(x.im * t, &sine, &cosine);
    return nonsmooth_number(growth * cosine, growth * sine);
}

static inline nonsmooth_complex nonsmooth_root_of(nonsmooth_complex x)
{
    const double size = hypot(x.re, x.im), re = sqrt(0.5 * (size + fabs(x.re)));
    if (re == 0.0)
        return nonsmooth_number(0.0, 0.0);
    if (x.re >= 0.0)
        return nonsmooth_number(re, 0.5 * x.im / re);
    return nonsmooth_number(0.5 * fabs(x.im) / re, x.im < 0.0 ? -re : re);
}

/* Roots counted with their multiplicity, at most. */
enum { NONSMOOTH_ROOTS = 16, NONSMOOTH_TURNS = 40 };

/* Eigenvalues of a complex Hessenberg matrix by the shifted QR method; what does not converge
 * within NONSMOOTH_TURNS steps for each is taken as it is. */
static inline void nonsmooth_eigenvalues(int size, nonsmooth_complex a[][NONSMOOTH_ROOTS],
                                         nonsmooth_complex *value)
{
    for (int last = size - 1, turn = 0; last >= 0;) {
        int first = last;
        for (; first > 0; --first) {
            const nonsmooth_complex x = a[first][first - 1], y = a[first][first],
                                    z = a[first - 1][first - 1];
            if (fabs(x.re) + fabs(x.im) <=
                0.5 * DBL_EPSILON * (fabs(y.re) + fabs(y.im) + fabs(z.re) + fabs(z.im)))
                break;
        }
        if (first == last || ++turn > NONSMOOTH_TURNS) {
            value[last] = a[last][last];
            --last;
            turn = 0;
            continue;
        }
        /* the eigenvalue of the last two rows that is nearer to the last entry */
        const nonsmooth_complex p = a[last - 1][last - 1], q = a[last][last];
        const nonsmooth_complex half = nonsmooth_scaled(0.5, nonsmooth_gap(p, q));
        const nonsmooth_complex below =
            nonsmooth_product(a[last - 1][last], a[last][last - 1]);
        const nonsmooth_complex root =
            nonsmooth_root_of(nonsmooth_sum(nonsmooth_product(half, half), below));
        const nonsmooth_complex one = nonsmooth_sum(half, root), two = nonsmooth_gap(half, root);
        const int larger = hypot(one.re, one.im) >= hypot(two.re, two.im);
        nonsmooth_complex shift = larger ? one : two;
        if (shift.re != 0.0 || shift.im != 0.0)
            shift = nonsmooth_gap(q, nonsmooth_quotient(below, shift));
        else
            shift = q;
        if (turn % 10 == 0) /* out of a cycle */
            shift = nonsmooth_sum(shift, nonsmooth_scaled(0.75, a[last][last - 1]));
        double cosine[NONSMOOTH_ROOTS];
        nonsmooth_complex sine[NONSMOOTH_ROOTS];
        for (int i = first; i <= last; ++i)
            a[i][i] = nonsmooth_gap(a[i][i], shift);
        for (int i = first; i < last; ++i) {
            const nonsmooth_complex x = a[i][i], y = a[i + 1][i];
            const double nx = hypot(x.re, x.im), length = hypot(nx, hypot(y.re, y.im));
            cosine[i] = length > 0.0 ? nx / length : 1.0;
            const nonsmooth_complex unit = nx > 0.0 ? nonsmooth_scaled(1.0 / nx, x)
                                                    : nonsmooth_number(1.0, 0.0);
            const nonsmooth_complex turned = nonsmooth_number(y.re, -y.im);
            sine[i] = length > 0.0
                          ? nonsmooth_scaled(1.0 / length, nonsmooth_product(unit, turned))
                          : nonsmooth_number(0.0, 0.0);
            const nonsmooth_complex conjugate = nonsmooth_number(sine[i].re, -sine[i].im);
            for (int j = i; j <= last; ++j) {
                const nonsmooth_complex u = a[i][j], v = a[i + 1][j];
                a[i][j] = nonsmooth_sum(nonsmooth_scaled(cosine[i], u), nonsmooth_product(sine[i], v));
                a[i + 1][j] =
                    nonsmooth_gap(nonsmooth_scaled(cosine[i], v), nonsmooth_product(conjugate, u));
            }
        }
        for (int j = first; j < last; ++j) {
            const nonsmooth_complex conjugate = nonsmooth_number(sine[j].re, -sine[j].im);
            const int end = j + 1 < last ? j + 1 : last;
            for (int i = first; i <= end; ++i) {
                const nonsmooth_complex u = a[i][j], v = a[i][j + 1];
                a[i][j] =
                    nonsmooth_sum(nonsmooth_scaled(cosine[j], u), nonsmooth_product(conjugate, v));
                a[i][j + 1] =
                    nonsmooth_gap(nonsmooth_scaled(cosine[j], v), nonsmooth_product(sine[j], u));
            }
        }
        for (int i = first; i <= last; ++i)
            a[i][i] = nonsmooth_sum(a[i][i], shift);
    }
}

/* Roots of the monic polynomial of a degree in s^step, from eigenvalues of its companion matrix. */
static inline void nonsmooth_roots_of(int degree, int step, const double *coefficient,
                                      nonsmooth_complex *root)
{
    if (degree == 1)
        root[0] = nonsmooth_number(-coefficient[0], 0.0);
    else if (degree == 2) {
        const nonsmooth_roots r = nonsmooth_quadratic(coefficient[0], coefficient[step]);
        const double im = r.square < 0.0 ? sqrt(-r.square) : 0.0;
        root[0] = nonsmooth_number(r.right, im);
        root[1] = nonsmooth_number(r.left, -im);
    } else {
        nonsmooth_complex a[NONSMOOTH_ROOTS][NONSMOOTH_ROOTS] = {{{0.0, 0.0}}};
        double unit = 0.0;
        for (int j = 0; j < degree; ++j)
            unit = fmax(unit, pow(fabs(coefficient[step * j]), 1.0 / (degree - j)));
        unit = unit > 0.0 ? unit : 1.0;
        for (int j = 0; j < degree; ++j) {
            a[0][degree - 1 - j].re = -coefficient[step * j] / pow(unit, degree - j);
            if (j + 1 < degree)
                a[j + 1][j].re = 1.0;
        }
        nonsmooth_eigenvalues(degree, a, root);
        for (int j = 0; j < degree; ++j)
            root[j] = nonsmooth_scaled(unit, root[j]);
    }
}

/* Roots of the monic polynomial of a degree; of an undamped motion's from their squares, which stay
 * real where they are. */
static inline void nonsmooth_polynomial_roots(int degree, const double *coefficient,
                                              nonsmooth_complex *root)
{
    int even = degree > 2 && degree % 2 == 0;
    for (int j = 1; even && j < degree; j += 2)
        even = coefficient[j] == 0.0;
    if (!even) {
        nonsmooth_roots_of(degree, 1, coefficient, root);
        return;
    }
    const int half = degree / 2;
    nonsmooth_roots_of(half, 2, coefficient, root);
    for (int j = 0; j < half; ++j) {
        root[j] = nonsmooth_root_of(root[j]);
        root[half + j] = nonsmooth_number(-root[j].re, -root[j].im);
    }
}

/* Sets of roots of which differences are known at once; 16 roots have some 500 that are needed. */
enum { NONSMOOTH_KNOWN = 1024 };

/* Divided differences of e^(lambda t) over sets of roots, a set being a mask, each known once. */
typedef struct {
    int count, sets;
    double time;
    nonsmooth_complex root[NONSMOOTH_ROOTS];
    unsigned set[NONSMOOTH_KNOWN]; /* 0 where there is none */
    nonsmooth_complex value[NONSMOOTH_KNOWN];
} nonsmooth_differences;

/* Where a set is, or would be: of at most ten roots at the place of its mask. */
static inline unsigned nonsmooth_place(const nonsmooth_differences *d, unsigned set)
{
    unsigned place = (set ^ set >> 10) & (NONSMOOTH_KNOWN - 1u);
    while (d->set[place] != 0u && d->set[place] != set)
        place = (place + 1u) & (NONSMOOTH_KNOWN - 1u);
    return place;
}

static inline int nonsmooth_knows(const nonsmooth_differences *d, unsigned set)
{
    return d->set[nonsmooth_place(d, set)] == set;
}

static inline nonsmooth_complex nonsmooth_known(const nonsmooth_differences *d, unsigned set)
{
    return d->value[nonsmooth_place(d, set)];
}

static inline void nonsmooth_learn(nonsmooth_differences *d, unsigned set, nonsmooth_complex value)
{
    const unsigned place = nonsmooth_place(d, set);
    d->set[place] = set;
    d->value[place] = value;
    ++d->sets;
}

/* The difference by the exponential series about the mean of the roots. */
static inline nonsmooth_complex nonsmooth_series(const nonsmooth_differences *d, unsigned set)
{
    nonsmooth_complex mean = {0.0, 0.0}, total = {0.0, 0.0}, degree[NONSMOOTH_SERIES];
    double unit = 0.0; /* of the distances, whose powers may overflow */
    int size = 0;
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1u) {
            mean = nonsmooth_sum(mean, d->root[i]);
            ++size;
        }
    mean = nonsmooth_scaled(1.0 / size, mean);
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1u) {
            const nonsmooth_complex gap = nonsmooth_gap(d->root[i], mean);
            unit = fmax(unit, hypot(gap.re, gap.im));
        }
    unit = unit > 0.0 ? unit : 1.0;
    for (int k = 0; k < NONSMOOTH_SERIES; ++k)
        degree[k] = nonsmooth_number(k == 0 ? 1.0 : 0.0, 0.0);
    /* complete homogeneous polynomials of the distances, degree by degree */
    for (int i = 0; i < d->count; ++i)
        if (set >> i & 1u) {
            const nonsmooth_complex gap =
                nonsmooth_scaled(1.0 / unit, nonsmooth_gap(d->root[i], mean));
            for (int k = 1; k < NONSMOOTH_SERIES; ++k)
                degree[k] = nonsmooth_sum(degree[k], nonsmooth_product(gap, degree[k - 1]));
        }
    for (int k = NONSMOOTH_SERIES - 1; k >= 0; --k)
        total = nonsmooth_sum(nonsmooth_scaled(unit * d->time / (size + k), total), degree[k]);
    double power = 1.0;
    for (int k = 1; k < size; ++k)
        power *= d->time / k;
    return nonsmooth_scaled(power, nonsmooth_product(nonsmooth_exponential(mean, d->time), total));
}

/* Forget all roots. */
static inline void nonsmooth_begin(nonsmooth_differences *d, double time)
{
    d->count = 0;
    d->sets = 0;
    d->time = time;
    d->set[0] = 0;
}

/* One more root, of NONSMOOTH_ROOTS at most. */
static inline void nonsmooth_add(nonsmooth_differences *d, double re, double im)
{
    d->root[d->count] = nonsmooth_number(re, im);
    for (int place = 1 << d->count; place < 2 << d->count && place < NONSMOOTH_KNOWN; ++place)
        d->set[place] = 0;
    ++d->count;
}

/* Largest distance of two roots of a set, and which they are; negative of a single one. */
static inline double nonsmooth_farthest(const nonsmooth_differences *d, unsigned set, int *one,
                                        int *two)
{
    double largest = -1.0;
    for (int i = 0; i < d->count; ++i)
        for (int j = i + 1; j < d->count; ++j)
            if (set >> i & set >> j & 1u) {
                const nonsmooth_complex gap = nonsmooth_gap(d->root[i], d->root[j]);
                const double distance = hypot(gap.re, gap.im);
                if (distance > largest) {
                    largest = distance;
                    *one = i;
                    *two = j;
                }
            }
    return largest;
}

/* The difference over a set: of the farthest roots, or by its series where none is far. A set waits
 * until the two that it is made of are known. NaN if too many are needed. */
static inline nonsmooth_complex nonsmooth_difference(nonsmooth_differences *d, unsigned wanted)
{
    unsigned waiting[NONSMOOTH_ROOTS];
    int count = 0;
    waiting[count++] = wanted;
    while (count > 0) {
        const unsigned set = waiting[count - 1];
        int one = 0, two = 0;
        if (nonsmooth_knows(d, set)) {
            --count;
        } else if (d->sets == NONSMOOTH_KNOWN - 1) {
            return nonsmooth_number((double)NAN, (double)NAN);
        } else if (set & (set - 1u) &&
                   nonsmooth_farthest(d, set, &one, &two) * fabs(d->time) > NONSMOOTH_NEAR) {
            const unsigned left = set & ~(1u << two), right = set & ~(1u << one);
            if (!nonsmooth_knows(d, left))
                waiting[count++] = left;
            else if (!nonsmooth_knows(d, right))
                waiting[count++] = right;
            else
                nonsmooth_learn(
                    d, set,
                    nonsmooth_quotient(
                        nonsmooth_gap(nonsmooth_known(d, left), nonsmooth_known(d, right)),
                        nonsmooth_gap(d->root[one], d->root[two])));
        } else
            nonsmooth_learn(d, set, nonsmooth_series(d, set));
    }
    return nonsmooth_known(d, wanted);
}

/* G of any factors, which have NONSMOOTH_ROOTS roots at most, else NaN; in front of each one's
 * coefficients, from the constant up, stands its degree. The orders are lowest + 0, 1, 2, 3. */
static nonsmooth_derivatives nonsmooth_any(double t, int lowest, int factors, const double *factor)
    NONSMOOTH_UNUSED;
static nonsmooth_derivatives nonsmooth_any(double t, int lowest, int factors, const double *factor)
{
    nonsmooth_complex root[NONSMOOTH_ROOTS];
    double found[4] = {(double)NAN, (double)NAN, (double)NAN, (double)NAN};
    int count = 0, valid = fabs(t) <= DBL_MAX;
    for (int i = 0; valid && i < factors; ++i) {
        const int degree = (int)factor[0];
        valid = count + degree <= NONSMOOTH_ROOTS;
        if (valid)
            nonsmooth_polynomial_roots(degree, factor + 1, root + count);
        count += degree;
        factor += 1 + degree;
    }
    for (int i = 0; valid && i < count; ++i)
        valid = fabs(root[i].re) <= DBL_MAX && fabs(root[i].im) <= DBL_MAX;
    if (valid) {
        nonsmooth_differences d;
        nonsmooth_begin(&d, t);
        /* The slowest last: its powers multiply what is largest. */
        for (int i = 0; i < count; ++i) {
            int largest = i;
            for (int j = i + 1; j < count; ++j)
                if (hypot(root[j].re, root[j].im) > hypot(root[largest].re, root[largest].im))
                    largest = j;
            const nonsmooth_complex next = root[largest];
            root[largest] = root[i];
            root[i] = next;
            nonsmooth_add(&d, next.re, next.im);
        }
        for (int i = 0; i < 4; ++i) {
            /* Leibniz' rule: of lambda^order the difference over the roots that e^ is without */
            const int order = lowest + i;
            found[i] = 0.0;
            for (int left = 0; left <= order && left < d.count; ++left) {
                nonsmooth_complex power[NONSMOOTH_ROOTS + 4];
                power[0] = nonsmooth_number(1.0, 0.0);
                for (int k = 1; k <= order - left; ++k)
                    power[k] = nonsmooth_number(0.0, 0.0);
                for (int j = d.count - left - 1; j < d.count; ++j)
                    for (int k = 1; k <= order - left; ++k)
                        power[k] =
                            nonsmooth_sum(power[k], nonsmooth_product(d.root[j], power[k - 1]));
                found[i] += nonsmooth_product(
                                power[order - left],
                                nonsmooth_difference(&d, (1u << (d.count - left)) - 1u))
                                .re;
            }
        }
    }
    const nonsmooth_derivatives g = {found[0], found[1], found[2], found[3]};
    return g;
}

/* G of {s^2 + c1 s + c0, s^2 + e0}: a damped coordinate under a harmonic force. Apart, at and near
 * resonance, and by the general way where roots are near each other but not by pairs. */
static inline nonsmooth_derivatives nonsmooth_pair_wave(double t, double c0, double c1, double e0)
{
    const nonsmooth_roots r = nonsmooth_quadratic(c0, c1);
    const double slower = r.square < 0.0 ? c0 : fmin(r.left * r.left, r.right * r.right);
    const double difference = c0 - e0, resultant = difference * difference + c1 * c1 * e0;
    nonsmooth_derivatives g;
    if (fmax(r.radius * r.radius, fabs(e0)) * t * t < 1.0)
        return nonsmooth_small(t, c0, c1, e0, 4);
    double sine, cosine;
    const double force = e0 > 0.0 ? sqrt(e0) : 0.0, natural = sqrt(fabs(r.square));
    /* squared distances of roots a = mean + i natural and b = i force, and of a and -b */
    const double beside = r.mean * r.mean + (natural - force) * (natural - force);
    const double across = r.mean * r.mean + (natural + force) * (natural + force);
    if (r.square < 0.0 && beside < 0.01 * across && e0 * t * t > 0.25) {
        const double apart = (difference - r.mean * r.mean) / (natural + force);
        const double half = 0.5 * apart * t, grown = expm1(r.mean * t), decay = grown + 1.0;
        double half_sine, half_cosine;
        nonsmooth_turn(force * t, &sine, &cosine);
        nonsmooth_turn(half, &half_sine, &half_cosine);
        const nonsmooth_complex a = {r.mean, natural}, b = {0.0, force};
        const nonsmooth_complex wave = {cosine, sine}, turn = {half_cosine, half_sine};
        const nonsmooth_complex middle = nonsmooth_product(wave, turn);
        const nonsmooth_complex at = nonsmooth_scaled(decay, nonsmooth_product(middle, turn));
        const nonsmooth_complex w = {0.5 * r.mean, 0.5 * apart};
        nonsmooth_complex between = {t, 0.0}; /* sinh(w t)/w e^(mean t/2) */
        if (w.re != 0.0 || w.im != 0.0)
            between = nonsmooth_quotient(
                nonsmooth_number(0.5 * grown * half_cosine, (0.5 * grown + 1.0) * half_sine), w);
        between = nonsmooth_product(middle, between);
        /* 1/((b - conj a)(b - conj b)) */
        const nonsmooth_complex second = nonsmooth_quotient(
            nonsmooth_number(0.0, -0.5 / force), nonsmooth_number(-r.mean, force + natural));
        /* -2i(natural + force)/((a - conj a)(a - conj b)) times that */
        const nonsmooth_complex first = nonsmooth_product(
            second, nonsmooth_quotient(nonsmooth_number(-(natural + force) / natural, 0.0),
                                       nonsmooth_number(r.mean, natural + force)));
        const nonsmooth_complex x =
            nonsmooth_sum(nonsmooth_product(at, first), nonsmooth_product(between, second));
        const nonsmooth_complex y = nonsmooth_sum(
            nonsmooth_product(
                at, nonsmooth_sum(nonsmooth_product(a, first), second)),
            nonsmooth_product(between, nonsmooth_product(b, second)));
        g.d0 = 2.0 * x.re;
        g.d1 = 2.0 * y.re;
        sine /= force;
    } else if (e0 > 0.0 && (r.square < 0.0 ? beside : slower + e0) * t * t > 0.25) {
        const nonsmooth_derivatives h = nonsmooth_pair_of(t, r);
        nonsmooth_turn(force * t, &sine, &cosine);
        sine /= force;
        g.d0 = (difference * sine - c1 * cosine + c1 * h.d1 + (c1 * c1 - difference) * h.d0) /
               resultant;
        g.d1 = (difference * (cosine - h.d1) + c1 * (e0 * sine - c0 * h.d0)) / resultant;
    } else {
        const double factor[] = {2.0, c0, c1, 2.0, e0, 0.0};
        return nonsmooth_any(t, 0, 2, factor);
    }
    g.d2 = sine - c1 * g.d1 - c0 * g.d0;
    g.d3 = cosine - c1 * g.d2 - c0 * g.d1;
    return g;
}

#endif
