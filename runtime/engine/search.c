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
static void gather(const phase *p, int b, double error, crossing *event)
{
    const double time = event->time;
    const double *functions = event->functions;
    const double slope = fabs(dot(p->c->functions, slope_of(p, b), functions));
    event->time_error = 4.0 * DBL_EPSILON * time + (slope > 0.0 ? error / slope : 0.0);
    /* at a tangency the time is known to the root of the error only */
    const double second = second_bound(p, b, time, time);
    if (second > 0.0 && event->time_error > sqrt(4.0 * error / second))
        event->time_error = sqrt(4.0 * error / second);
    event->set = (uint32_t)1 << b;
    for (uint32_t rest = p->watched & ~event->set; rest; rest &= rest - 1) {
        const int other = lowest(rest);
        const double value = dot(p->c->functions, value_of(p, other), functions);
        const double its_slope = dot(p->c->functions, slope_of(p, other), functions);
        const double its_error = error_at(p, other, time);
        const double allowed = its_error + fabs(its_slope) * event->time_error;
        if (fabs(value) > allowed)
            continue;
        const double flat = sqrt(8.0 * second_bound(p, other, time, time) * its_error);
        if (its_slope > flat || (p->reached[other] && its_slope > -flat))
            event->set |= (uint32_t)1 << other;
    }
}

/* No trigonometric function: a zero of g = a0 + a1 t is explicit. */
static crossing search_linear(const phase *p, double window)
{
    crossing event;
    event.found = 0;
    int first = -1;
    double time = window;
    for (uint32_t rest = p->watched; rest; rest &= rest - 1) {
        const int b = lowest(rest);
        const double *value = value_of(p, b);
        const double slope = p->c->functions > 1 ? value[1] : 0.0;
        if (p->leaving & ((uint32_t)1 << b) || !(slope > 0.0))
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
    phase_functions(p->c, time, event.functions);
    gather(p, first, error_at(p, first, time), &event);
    return event;
}

crossing phase_search(phase *p, double window)
{
    const configuration *c = p->c;
    crossing event;
    event.found = 0;
    if (!p->watched || !(window > 0.0))
        return event;
    if (c->polynomial >= 0 && c->polynomial <= 1)
        return search_linear(p, window);

    double functions[MOST_FUNCTIONS], cosine[MOST_MODES], sine[MOST_MODES];
    sample left[MOST_BOUNDARIES], right[MOST_BOUNDARIES];
    double base[MOST_BOUNDARIES], slack[MOST_BOUNDARIES], drift[MOST_BOUNDARIES];
    double bound[MOST_BOUNDARIES]; /* on the fourth derivative */
    const int simple = c->uniform && c->mode[0].length <= 2;
    for (int i = 0; i < c->modes; ++i) {
        cosine[i] = 1.0;
        sine[i] = 0.0;
    }
    for (uint32_t rest = p->watched; rest; rest &= rest - 1) {
        const int b = lowest(rest);
        left[b] = (sample){at_start(c, value_of(p, b)), at_start(c, slope_of(p, b))};
        if (p->leaving >> b & 1)
            left[b].value = 0.0;
        base[b] = slack[b] = SAMPLE * p->size[b];
        drift[b] = simple && c->mode[0].length == 2 ? SAMPLE * fabs(value_of(p, b)[1]) : 0.0;
        bound[b] = p->fourth[b];
    }
    /* A window of LONGEST_WAIT radians has as many cells as radians. Where nothing sets a length,
     * the cells double, from 1 to what is no number: 1024 times. */
    const int doubling = c->polynomial >= 0 || !(c->fastest > 0.0);
    double time = 0.0, h = c->cell;
    for (long cell = 0; time < window; ++cell) {
        if (lost(p->patience)) {
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
            for (int i = 0; i < c->modes; ++i) {
                const mode *m = &c->mode[i];
                if (i == 0) { /* 1, t, ...: nothing turns */
                    spread(m, next, 1.0, 0.0, functions);
                    continue;
                }
                const double one = cosine[i], two = sine[i];
                cosine[i] = one * m->cell_cosine - two * m->cell_sine;
                sine[i] = two * m->cell_cosine + one * m->cell_sine;
                if (m->length == 1) {
                    functions[m->first] = cosine[i];
                    if (m->oscillates)
                        functions[m->first + 1] = sine[i];
                } else
                    spread(m, next, cosine[i], sine[i], functions);
            }
        const double width = next - from;
        uint32_t suspects = 0;
        for (uint32_t rest = p->watched; rest; rest &= rest - 1) {
            const int b = lowest(rest);
            right[b] = (sample){dot(c->functions, value_of(p, b), functions),
                                dot(c->functions, slope_of(p, b), functions)};
            const int leaves = cell == 0 && (p->leaving >> b & 1);
            slack[b] = base[b] + drift[b] * next;
            if (!simple) {
                slack[b] = SAMPLE / VALUE * error_at(p, b, next);
                bound[b] = fourth_bound(p, b, from, next);
            }
            if (!stays_below(left[b], right[b], width, bound[b], slack[b], leaves) ||
                (leaves && (p->slow >> b & 1)))
                suspects |= (uint32_t)1 << b;
        }
        int first = -1, known = 0; /* whether the functions at the event are */
        double earliest = next, error = 0.0;
        for (uint32_t rest = suspects; rest; rest &= rest - 1) {
            const int b = lowest(rest);
            const int leaves = cell == 0 && (p->leaving >> b & 1);
            sampler s = {.p = p, .boundary = b};
            double found, there[MOST_FUNCTIONS];
            int settles = 0;
            if (!leaves && left[b].value < -slack[b] && right[b].value > slack[b] &&
                rises(left[b], right[b], width, bound[b], slack[b]))
            {
                const double guess = from + cubic_zero(left[b], right[b], width);
                found = c->harmonic ? cell_settled(p, b, from, next, guess, there) : HUGE_VAL;
                settles = found < HUGE_VAL;
                if (!settles)
                    found = cell_crossing(&s, from, next, guess);
            } else if (!leaves)
                found = cell_first(p, &s, from, earliest, from);
            else {
                cell_leave(&s);
                const double shortest = SHORTEST * c->cell; /* powers of it do not underflow */
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
                    event.functions[f] = there[f];
            }
        }
        if (first >= 0) {
            event.found = 1;
            event.time = earliest;
            if (!known)
                phase_functions(c, earliest, event.functions);
            gather(p, first, error, &event);
            return event;
        }
        for (uint32_t rest = p->watched; rest; rest &= rest - 1) {
            const int b = lowest(rest);
            left[b] = right[b];
            if (right[b].value < -slack[b])
                p->leaving &= ~((uint32_t)1 << b);
        }
        time = next;
        if (doubling)
            h *= 2.0;
    }
    return event;
}
