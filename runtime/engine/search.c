/* The first crossing of the boundaries of a phase, which no step can jump over. */
#include "sums.h"

static const double SHORTEST = 1e-30; /* cells behind a start in which nothing can be told */

enum {
    FRESH = 32,         /* cells after which samples are computed anew */
    MOST_STEPS = 1 << 20, /* in one cell; more are those of numbers that are not finite or too small */
};

/* Smallest positive root of g + g' s + M s^2/2, g < 0: no zero of a function lies before it whose
 * second derivative is at most M. */
static double safe_step(sample at, double second)
{
    if (second == 0.0)
        return at.slope > 0.0 ? -at.value / at.slope : HUGE_VAL;
    const double root = sqrt(at.slope * at.slope - 2.0 * second * at.value);
    return at.slope > 0.0 ? -2.0 * at.value / (at.slope + root) : (root - at.slope) / second;
}

/* Samples of one boundary in one cell: directly, or by the series with which it is left. */
typedef struct {
    const phase *p;
    int boundary, order;    /* 0: directly */
    double series[SERIES];  /* g^(k)(0)/k! */
    double error_of_series; /* of the leading coefficient */
} sampler;

static sample sampled(const sampler *s, double time, double *error)
{
    if (s->order == 0) {
        if (error)
            *error = error_at(s->p, s->boundary, time);
        return sample_at(s->p, s->boundary, time);
    }
    double value = 0.0, slope = 0.0;
    for (int k = SERIES - 1; k >= s->order; --k) {
        value = value * time + s->series[k];
        slope = slope * time + k * s->series[k];
    }
    const double lower = pow(time, s->order - 1);
    if (error)
        *error = lower * time * s->error_of_series;
    return (sample){value * lower * time, slope * lower};
}

static void make_series(sampler *s)
{
    const phase *p = s->p;
    const configuration *c = p->c;
    double value[MOST_FUNCTIONS], next[MOST_FUNCTIONS], factor = 1.0;
    for (int f = 0; f < c->functions; ++f)
        value[f] = value_of(p, s->boundary)[f];
    s->order = phase_beginning(p, s->boundary).order;
    for (int k = 0; k < SERIES; ++k) {
        s->series[k] = at_start(c, value) * factor;
        factor /= k + 1;
        differentiate(c, value, next);
        for (int f = 0; f < c->functions; ++f)
            value[f] = next[f];
    }
    s->error_of_series = VALUE * fabs(s->series[s->order]);
}

/* Time before which a boundary that is left cannot come back: half of where the bound on the next
 * derivative could undo the leading one. */
static double time_away(const sampler *s, double end)
{
    const phase *p = s->p;
    const configuration *c = p->c;
    double value[MOST_FUNCTIONS], next[MOST_FUNCTIONS], factorial = 1.0;
    for (int f = 0; f < c->functions; ++f)
        value[f] = value_of(p, s->boundary)[f];
    for (int k = 0; k <= s->order; ++k) {
        factorial *= k > 0 ? k : 1;
        differentiate(c, value, next);
        for (int f = 0; f < c->functions; ++f)
            value[f] = next[f];
    }
    const double bound = bound_on(c, value, 0.0, end);
    const double leading = fabs(s->series[s->order]) * factorial;
    return bound > 0.0 ? 0.5 * (s->order + 1) * leading / bound : HUGE_VAL;
}

/* A step that is safe behind a slow start, where the uniform bound on g'' hardly lets go on: no
 * longer than the time itself, over which g'' changes little. */
static double leaving_step(const sampler *s, sample at, double time, double third)
{
    double curve = 0.0, size = 0.0;
    for (int k = SERIES - 1; k >= 2; --k) {
        curve = curve * time + k * (k - 1) * s->series[k];
        size = size * time + k * (k - 1) * fabs(s->series[k]);
    }
    const double bend = curve + SAMPLE * size + third * time;
    const double step = safe_step(at, bend > 0.0 ? bend : 0.0);
    return step < time ? step : time;
}

/* Newton's method for a crossing in [low, high], g <= 0 at low and >= 0 at high, kept inside. */
static double polished(const sampler *s, double low, double high, double time)
{
    const double second = second_bound(s->p, s->boundary, low, high);
    for (int i = 0; i < 80; ++i) {
        const sample at = sampled(s, time, NULL);
        if (at.value > 0.0)
            high = time;
        else
            low = time;
        double next = time - at.value / at.slope;
        if (!(next >= low && next <= high))
            next = 0.5 * (low + high);
        else { /* what Newton's next step would still change */
            const double change = next - time;
            if (change * change * second <= DBL_EPSILON * next * fabs(at.slope))
                return next;
        }
        if (next == low || next == high)
            return next;
        time = next;
    }
    return time;
}

/* Functions of a harmonic configuration a little later: by the angle's short series. */
static void shift(const configuration *c, double from, double step, double *functions)
{
    if (c->mode[0].length == 2)
        functions[1] = from + step;
    for (int i = 1; i < c->modes; ++i) {
        double *at = functions + c->mode[i].first;
        const double angle = c->mode[i].frequency * step, square = angle * angle;
        const double sine = angle - angle * square * (1.0 / 6.0 - square * (1.0 / 120.0));
        const double less = square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)));
        const double one = at[0], two = at[1];
        at[0] = one - (one * less + two * sine);
        at[1] = two + (one * sine - two * less);
    }
}

/* Newton's method for the only crossing in [low, high] of a harmonic configuration, from a good
 * start; leaves the functions at the crossing. HUGE_VAL if it does not converge at once. */
static double settled(const phase *p, int b, double low, double high, double time,
                      double *functions)
{
    const configuration *c = p->c;
    phase_functions(c, time, functions);
    for (int i = 0; i < 6; ++i) {
        const double slope = dot(c->functions, slope_of(p, b), functions);
        const double step = -dot(c->functions, value_of(p, b), functions) / slope;
        const double next = time + step;
        if (!(next >= low && next <= high))
            return HUGE_VAL;
        if (fabs(step) * c->fastest < 0.01)
            shift(c, time, step, functions);
        else
            phase_functions(c, next, functions);
        time = next;
        if (step * step * p->second[b] <= DBL_EPSILON * time * fabs(slope))
            return time;
    }
    return HUGE_VAL;
}

/* Record a touch of [from, to]; one that goes on from cell to cell is one. */
static void remember(phase *p, int boundary, double from, double to, double time, double depth)
{
    for (int i = 0; i < p->touches; ++i) {
        touch *known = &p->touch[i];
        if (known->boundary == boundary && from <= known->end) {
            known->end = to;
            if (depth > known->depth) {
                known->depth = depth;
                known->time = time;
            }
            return;
        }
    }
    if (p->touches < MOST_TOUCHES)
        p->touch[p->touches++] = (touch){time, depth, to, boundary};
}

/* First time in [from, to] at which boundary b is reached, or HUGE_VAL; NAN if no step gets on. */
static double first_in(phase *p, sampler *s, double from, double to, double cell_start)
{
    const int b = s->boundary;
    const double second = second_bound(p, b, cell_start, to);
    const double third = s->order ? third_bound(p, b, cell_start, to) : 0.0;
    double time = from, error;
    for (int steps = 0; steps < MOST_STEPS; ++steps) {
        sample at = sampled(s, time, &error);
        for (; at.value < -error; ++steps) {
            if (steps > MOST_STEPS)
                return NAN;
            if (s->order == 0)
                p->leaving &= ~((uint32_t)1 << b);
            if (time >= to)
                return HUGE_VAL;
            double step = safe_step(at, second);
            if (s->order && step < time) {
                const double slow = leaving_step(s, at, time, third);
                step = slow > step ? slow : step;
            }
            /* at least the next double: a step below it is within the error */
            const double next = time + step;
            time = next > to ? to : next > time ? next : nextafter(time, HUGE_VAL);
            at = sampled(s, time, &error);
        }
        /* the slope outlasts its change over the error: the crossing is transversal */
        if (at.slope > 0.0 && at.slope * at.slope > 8.0 * second * (error + fabs(at.value))) {
            const double reach = 2.0 * (error + fabs(at.value)) / at.slope;
            return polished(s, time > reach ? time - reach : 0.0, time + reach, time);
        }
        /* g is zero within its error: follow it in steps over which it changes no more */
        const double step = second > 0.0 ? sqrt(4.0 * error / second) : to - time;
        const double entered = time;
        double top = time, depth = at.value, before = time;
        for (; at.value >= -error && at.value <= 2.0 * error && time < to; ++steps) {
            if (steps > MOST_STEPS)
                return NAN;
            before = time;
            time = time + step > to ? to : time + step;
            if (!(time > before))
                time = nextafter(before, HUGE_VAL);
            at = sampled(s, time, &error);
            if (at.value > depth) {
                depth = at.value;
                top = time;
            }
        }
        if (at.value > 2.0 * error)
            return polished(s, before, time, 0.5 * (before + time));
        if (at.value >= -error && time >= to && at.slope > 0.0)
            return HUGE_VAL; /* the next cell begins here and decides */
        /* a start that is left so slowly that it takes more than a cell is no touch */
        if (s->order > 0 || !(p->leaving >> b & 1)) {
            if (p->reached[b])
                return top;
            remember(p, b, entered, time, 0.5 * (entered + time), depth);
        }
        if (time >= to)
            return HUGE_VAL;
    }
    return NAN;
}

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
        const int other = __builtin_ctz(rest);
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
        const int b = __builtin_ctz(rest);
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
        const int b = __builtin_ctz(rest);
        left[b] = (sample){at_start(c, value_of(p, b)), at_start(c, slope_of(p, b))};
        if (p->leaving >> b & 1)
            left[b].value = 0.0;
        base[b] = slack[b] = SAMPLE * p->size[b];
        drift[b] = simple && c->mode[0].length == 2 ? SAMPLE * fabs(value_of(p, b)[1]) : 0.0;
        bound[b] = p->fourth[b];
    }
    double time = 0.0, h = c->cell;
    for (long cell = 0; time < window; ++cell) {
        double next = c->polynomial >= 0 ? time + h : (cell + 1) * h;
        const double from = time;
        if (next >= window || (cell + 1) % FRESH == 0 || c->polynomial >= 0 || c->chained) {
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
            const int b = __builtin_ctz(rest);
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
            const int b = __builtin_ctz(rest);
            const int leaves = cell == 0 && (p->leaving >> b & 1);
            sampler s = {.p = p, .boundary = b};
            double found, there[MOST_FUNCTIONS];
            int settles = 0;
            if (!leaves && left[b].value < -slack[b] && right[b].value > slack[b] &&
                rises(left[b], right[b], width, bound[b], slack[b]))
            {
                const double guess = from + cubic_zero(left[b], right[b], width);
                found = c->harmonic ? settled(p, b, from, next, guess, there) : HUGE_VAL;
                settles = found < HUGE_VAL;
                if (!settles)
                    found = polished(&s, from, next, guess);
            } else if (!leaves)
                found = first_in(p, &s, from, earliest, from);
            else {
                make_series(&s);
                const double shortest = SHORTEST * c->cell; /* powers of it do not underflow */
                const double least = s.order > 0 ? time_away(&s, next) : 0.0;
                const double away = least > shortest ? least : shortest;
                found = s.order == 0 || away >= next ? HUGE_VAL
                                                     : first_in(p, &s, away, earliest, from);
            }
            if (isnan(found)) {
                event.found = -1;
                return event;
            }
            if (found <= earliest && (first < 0 || found < earliest)) {
                if (s.order)
                    sampled(&s, found, &error);
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
            const int b = __builtin_ctz(rest);
            left[b] = right[b];
            if (right[b].value < -slack[b])
                p->leaving &= ~((uint32_t)1 << b);
        }
        time = next;
        if (c->polynomial >= 0)
            h *= 2.0;
    }
    return event;
}
