/* The first crossing of the boundaries of a phase, which no step can jump over. */
#include "cell.h"

static const double SHORTEST = 1e-30; /* cells behind a start in which nothing can be told */

enum { FRESH = 32 }; /* cells after which samples are computed anew */

/* Whether a cubic with these ends, plus the error of interpolation, stays below -slack. */
static inline int stays_below(sample left, sample right, double h, double fourth, double slack,
                              int leaves)
{
    const double excess = fourth * (h * h) * (h * h) * (1.0 / 144.0);
    const double quarter = 0.25 * h;
    const double first = left.value + quarter * left.slope;
    const double last = right.value - quarter * right.slope;
    const double middle =
        0.5 * (left.value + right.value) + h * (left.slope - right.slope) * (1.0 / 6.0) + excess;
    const double start = leaves ? first : left.value;
    return (start < -slack) & (first < -slack) & (middle < -slack) & (last < -slack) &
           (right.value < -slack);
}

/* Whether g rises all over a cell: then its only zero is found by Newton's method. */
static inline int rises(sample left, sample right, double h, double fourth, double slack)
{
    const double between = 3.0 * (right.value - left.value) / h - left.slope - right.slope;
    const double loss = 0.0081 * fourth * h * h * h + slack / h;
    return left.slope > loss && right.slope > loss && between > loss;
}

/* Zero of the cubic with these ends, as a start for Newton's method. */
static double cubic_zero(sample left, sample right, double h)
{
    const double a = h * left.slope, d = right.value - left.value;
    const double quadratic = 3.0 * d - 2.0 * a - h * right.slope;
    const double cubic = a + h * right.slope - 2.0 * d;
    double u = -left.value / d;
    for (int i = 0; i < 4; ++i) {
        const double value = left.value + u * (a + u * (quadratic + u * cubic));
        u -= value / (a + u * (2.0 * quadratic + 3.0 * u * cubic));
        u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
    }
    return u * h;
}

/* Boundaries that hold at the event of boundary `b`: those within their errors of zero that do not
 * fall there. `error` is that of its value; the functions are those at the event. */
static void gather(phase *p, int b, double error, crossing *event)
{
    const double time = event->time;
    const double *functions = p->functions;
    const double slope = fabs(dot(p->c->functions, slope_of(p, b), functions));
    /* behind many radians a time is rounded by more than the function's error tells */
    event->time_error = 4.0 * DBL_EPSILON * time + (slope > 0.0 ? error / slope : 0.0);
    /* at a tangency the time is known to the root of the error only */
    const double second = second_bound(p, b, time, time);
    if (second > 0.0 && event->time_error > sqrt(4.0 * error / second))
        event->time_error = sqrt(4.0 * error / second);
    set_clear(p->event, p->words);
    set_put(p->event, b);
    for (int i = 0; i < p->watching; ++i) {
        const int other = p->watched[i];
        if (other == b)
            continue;
        const double value = dot(p->c->functions, value_of(p, other), functions);
        const double its_slope = dot(p->c->functions, slope_of(p, other), functions);
        const double its_error = error_at(p, other, time);
        const double allowed = its_error + fabs(its_slope) * event->time_error;
        if (fabs(value) > allowed)
            continue;
        const double flat = sqrt(8.0 * second_bound(p, other, time, time) * its_error);
        if (its_slope > flat || (p->reached[other] && its_slope > -flat))
            set_put(p->event, other);
    }
}

/* No trigonometric function: a zero of g = a0 + a1 t is explicit. */
static crossing search_linear(phase *p, double window)
{
    crossing event = {0};
    int first = -1;
    double time = window;
    for (int i = 0; i < p->watching; ++i) {
        const int b = p->watched[i];
        const double *value = value_of(p, b);
        const double slope = p->c->functions > 1 ? value[1] : 0.0;
        if (p->start_of[b] & LEAVING || !(slope > 0.0))
            continue;
        const double found = -value[0] / slope;
        if (found <= time && (first < 0 || found < time)) {
            time = found;
            first = b;
        }
    }
    if (first < 0)
        return event;
    event.found = 1;
    event.time = time;
    phase_functions(p->c, time, p->functions);
    gather(p, first, error_at(p, first, time), &event);
    return event;
}

/* Advance the functions by a cell, turning cosines and sines. */
static inline void advance(const configuration *c, double time, double *restrict cosine,
                           double *restrict sine, double *restrict functions)
{
    spread(&c->mode[0], time, 1.0, 0.0, functions); /* 1, t, ...: nothing turns */
    for (int i = 1; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const double one = cosine[i], two = sine[i];
        cosine[i] = one * m->cell_cosine - two * m->cell_sine;
        sine[i] = two * m->cell_cosine + one * m->cell_sine;
        if (m->length == 1) {
            functions[m->first] = cosine[i];
            if (m->oscillates)
                functions[m->first + 1] = sine[i];
        } else
            spread(m, time, cosine[i], sine[i], functions);
    }
}

/* Length of the first cell of polynomials: a power of two before which none has another zero than
 * that of its start. */
static double first_cell(const phase *p)
{
    double shortest = HUGE_VAL;
    for (int i = 0; i < p->watching; ++i) {
        const double *value = value_of(p, p->watched[i]);
        int lowest = p->start_of[p->watched[i]] & ZERO ? 1 : 0;
        while (lowest < p->c->functions && value[lowest] == 0.0)
            ++lowest;
        for (int k = lowest + 1; k < p->c->functions; ++k)
            if (value[k] != 0.0)
                shortest = fmin(shortest, pow(fabs(value[lowest] / value[k]) / p->c->functions,
                                              1.0 / (k - lowest)));
    }
    return shortest > 0.0 && shortest < HUGE_VAL ? ldexp(1.0, ilogb(shortest)) : 1.0;
}

crossing phase_search(phase *p, double window)
{
    const configuration *c = p->c;
    crossing event = {0};
    if (!(window > 0.0))
        return event;
    if (c->polynomial >= 0 && c->polynomial <= 1)
        return search_linear(p, window);

    double *cosine = p->waves, *sine = cosine + c->modes;
    double *functions = sine + c->modes, *there = functions + c->functions;
    cell_ends *const ends = p->ends;
    const int *const watched = p->watched, watching = p->watching;
    const size_t work = (size_t)c->boundaries * (size_t)c->functions;
    for (int i = 0; i < c->modes; ++i) {
        cosine[i] = 1.0;
        sine[i] = 0.0;
    }
    for (int i = 0; i < watching; ++i) {
        const int b = watched[i];
        cell_ends *const g = &ends[b];
        g->left = (sample){at_start(c, value_of(p, b)), at_start(c, slope_of(p, b))};
        if (p->start_of[b] & LEAVING)
            g->left.value = 0.0;
        g->base = g->slack = SAMPLE * p->size[b];
        g->drift = SAMPLE * p->drift[b];
        g->bound = p->fourth[b];
    }
    /* A window of LONGEST_WAIT radians has as many cells as radians. Where nothing sets a length,
     * the cells double, to what is no number: 2048 times. */
    const int doubling = c->polynomial >= 0 || !(c->fastest > 0.0);
    double time = 0.0, h = doubling ? first_cell(p) : c->cell;
    const double shortest = SHORTEST * h; /* powers of it do not underflow */
    for (long cell = 0; time < window; ++cell) {
        if (lost_after(p->patience, work)) {
            event.found = -1;
            return event;
        }
        double next = doubling ? time + h : (cell + 1) * h;
        const double from = time;
        if (next >= window || (cell + 1) % FRESH == 0 || doubling || c->chained) {
            next = next < window ? next : window;
            phase_functions(c, next, functions);
            for (int i = 0; i < c->modes; ++i) {
                cosine[i] = functions[c->mode[i].first];
                sine[i] = c->mode[i].oscillates ? functions[c->mode[i].first + 1] : 0.0;
            }
        } else
            advance(c, next, cosine, sine, functions);
        const double width = next - from;
        int suspects = 0;
        for (int i = 0; i < watching; ++i) {
            const int b = watched[i];
            cell_ends *const g = &ends[b];
            g->right = (sample){dot(c->functions, value_of(p, b), functions),
                                dot(c->functions, slope_of(p, b), functions)};
            const int leaves = cell == 0 && p->start_of[b] & LEAVING;
            g->slack = g->base + g->drift * next;
            if (!c->simple) {
                g->slack = SAMPLE_APART * sizes_on(p, b, from, next);
                g->bound = fourth_bound(p, b, from, next);
            }
            if (!stays_below(g->left, g->right, width, g->bound, g->slack, leaves) ||
                (leaves && p->start_of[b] & SLOW))
                p->suspect[suspects++] = b;
        }
        int first = -1, known = 0; /* whether the functions at the event are */
        double earliest = next, error = 0.0;
        for (int i = 0; i < suspects; ++i) {
            const int b = p->suspect[i];
            const cell_ends *const g = &ends[b];
            const int leaves = cell == 0 && p->start_of[b] & LEAVING;
            sampler s = {.p = p, .boundary = b};
            double found;
            int settles = 0;
            if (!leaves && g->left.value < -g->slack && g->right.value > g->slack &&
                rises(g->left, g->right, width, g->bound, g->slack))
            {
                const double guess = from + cubic_zero(g->left, g->right, width);
                found = c->harmonic ? cell_settled(p, b, from, next, guess, there) : HUGE_VAL;
                settles = found < HUGE_VAL;
                if (!settles)
                    found = cell_crossing(&s, from, next, guess);
            } else if (!leaves)
                found = cell_first(p, &s, from, earliest, from);
            else {
                cell_leave(&s);
                const double least = s.order > 0 ? cell_away(&s, next) : 0.0;
                const double away = least > shortest ? least : shortest;
                found = s.order == 0 || away >= next ? HUGE_VAL
                                                     : cell_first(p, &s, away, earliest, from);
            }
            if (isnan(found)) {
                event.found = -1;
                return event;
            }
            if (found <= earliest && (first < 0 || found < earliest)) {
                if (s.order)
                    cell_sample(&s, found, &error);
                else
                    error = error_at(p, b, found);
                earliest = found;
                first = b;
                known = settles;
                for (int f = 0; settles && f < c->functions; ++f)
                    p->functions[f] = there[f];
            }
        }
        if (first >= 0) {
            event.found = 1;
            event.time = earliest;
            if (!known)
                phase_functions(c, earliest, p->functions);
            gather(p, first, error, &event);
            return event;
        }
        for (int i = 0; i < watching; ++i) {
            cell_ends *const g = &ends[watched[i]];
            g->left = g->right;
            if (g->right.value < -g->slack)
                p->start_of[watched[i]] &= (unsigned char)~LEAVING;
        }
        time = next;
        if (doubling)
            h *= 2.0;
    }
    return event;
}
