/* Divided differences of e^(lambda t) over any roots, up to sixteen. */
#ifndef NONSMOOTH_DIFFERENCES_H
#define NONSMOOTH_DIFFERENCES_H

#include <float.h>
#include <math.h>

#include "nonsmooth_exponentials.h"
#include "nonsmooth_trigonometry.h"

/* A function that is too long to be copied to where it is called, and may not be called at all. */
#if defined(__GNUC__)
#define NONSMOOTH_UNUSED __attribute__((unused, noinline))
#else
#define NONSMOOTH_UNUSED
#endif

/* Roots whose distance times t is at most NONSMOOTH_NEAR are taken together, by this many terms of
 * exponential series. */
#define NONSMOOTH_NEAR 3.0
enum { NONSMOOTH_SERIES = 34 };

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
