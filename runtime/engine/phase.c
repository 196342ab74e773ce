#include "phase.h"

#include <float.h>
#include <math.h>

#include "support.h"

/* Errors in units of eps times the size of what is summed: of a value, of a sample that was
 * advanced by rotation, of a derivative at the start. */
static const double VALUE = 8.0 * DBL_EPSILON;
static const double SAMPLE = 96.0 * DBL_EPSILON;
static const double START = 16.0 * DBL_EPSILON;

static const double SHORTEST = 1e-30; /* cells behind a start in which nothing can be told */

enum { FRESH = 32 }; /* cells after which samples are computed anew */

typedef struct {
    double value, slope;
} sample;

/* Sine and cosine of a product w t with the rounding error of the product taken in. */
static inline void turn(double w, double t, double *sine, double *cosine)
{
    const double angle = w * t;
    nonsmooth_sincos(angle, sine, cosine);
    if (angle > 8.0) {
        const double split = 0x1p27 + 1.0;
        const double a = split * w, b = split * t;
        const double wh = a - (a - w), wl = w - wh, th = b - (b - t), tl = t - th;
        const double rest = ((wh * th - angle) + wh * tl + wl * th) + wl * tl;
        const double s = *sine, c = *cosine;
        *sine = s + rest * c;
        *cosine = c - rest * s;
    }
}

/* Functions of one mode from e^(st) cos(wt) and e^(st) sin(wt). */
static inline void spread(const mode *m, double time, double cosine, double sine, double *functions)
{
    double power = 1.0;
    for (int k = 0, f = m->first; k < m->length; ++k) {
        functions[f++] = power * cosine;
        if (m->oscillates)
            functions[f++] = power * sine;
        power *= time;
    }
}

void phase_functions(const configuration *c, double time, double *functions)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        double cosine = 1.0, sine = 0.0;
        if (m->oscillates)
            turn(m->frequency, time, &sine, &cosine);
        if (m->rate != 0.0) {
            const double growth = exp(m->rate * time);
            cosine *= growth;
            sine *= growth;
        }
        spread(m, time, cosine, sine, functions);
    }
}

/* Coefficients of the derivative. */
static void differentiate(const configuration *c, const double *from, double *to)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const int step = 1 + m->oscillates, end = m->first + m->length * step;
        for (int k = 1, f = m->first; f < end; ++k, f += step) {
            const int last = f + step == end;
            const double cosine = from[f], above = last ? 0.0 : k * from[f + step];
            if (m->oscillates) {
                const double sine = from[f + 1], next = last ? 0.0 : k * from[f + 3];
                to[f] = m->rate * cosine + m->frequency * sine + above;
                to[f + 1] = m->rate * sine - m->frequency * cosine + next;
            } else
                to[f] = m->rate * cosine + above;
        }
    }
}

/* Bound on the sizes of a derivative's coefficients, from such bounds. */
static void differentiate_sizes(const configuration *c, const double *from, double *to)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        const int step = 1 + m->oscillates, end = m->first + m->length * step;
        const double rate = fabs(m->rate), frequency = fabs(m->frequency);
        for (int k = 1, f = m->first; f < end; ++k, f += step) {
            const int last = f + step == end;
            for (int part = 0; part < step; ++part) {
                const double above = last ? 0.0 : k * from[f + part + step];
                to[f + part] = rate * from[f + part] + above;
                if (m->oscillates)
                    to[f + part] += frequency * from[f + 1 - part];
            }
        }
    }
}

/* Value at 0: of every mode the coefficient of its first function. */
static double at_start(const configuration *c, const double *coefficients)
{
    double sum = 0.0;
    for (int i = 0; i < c->modes; ++i)
        sum += coefficients[c->mode[i].first];
    return sum;
}

/* Bound on a sum of functions over [from, to]. */
static double bound_on(const configuration *c, const double *coefficients, double from, double to)
{
    double sum = 0.0;
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        double part = 0.0, power = 1.0;
        for (int k = 0, f = m->first; k < m->length; ++k, f += 1 + m->oscillates, power *= to)
            part += power * (m->oscillates ? hypot(coefficients[f], coefficients[f + 1])
                                           : fabs(coefficients[f]));
        sum += m->rate == 0.0 ? part : part * exp(m->rate * (m->rate > 0.0 ? to : from));
    }
    return sum * (1.0 + 64.0 * DBL_EPSILON);
}

static double dot(int count, const double *a, const double *b)
{
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += a[i] * b[i];
    return sum;
}

static inline const double *value_of(const phase *p, int b)
{
    return p->value + b * p->c->functions;
}

static inline const double *slope_of(const phase *p, int b)
{
    return p->slope + b * p->c->functions;
}

/* Error of g_b at a time that is not advanced by rotation. */
static double error_at(const phase *p, int b, double time)
{
    const configuration *c = p->c;
    double size = p->size[b];
    if (c->uniform && c->mode[0].length == 2)
        size += fabs(value_of(p, b)[1]) * time;
    else if (!c->uniform || c->mode[0].length > 2)
        size += bound_on(c, value_of(p, b), time, time);
    return VALUE * size;
}

static double second_bound(const phase *p, int b, double from, double to)
{
    if (p->c->uniform && p->c->mode[0].length <= 2)
        return p->second[b];
    double curve[MOST_FUNCTIONS];
    differentiate(p->c, slope_of(p, b), curve);
    return bound_on(p->c, curve, from, to);
}

static double third_bound(const phase *p, int b, double from, double to)
{
    double second[MOST_FUNCTIONS], third[MOST_FUNCTIONS];
    differentiate(p->c, slope_of(p, b), second);
    differentiate(p->c, second, third);
    return bound_on(p->c, third, from, to);
}

static double fourth_bound(const phase *p, int b, double from, double to)
{
    if (p->c->uniform)
        return p->fourth[b];
    double third[MOST_FUNCTIONS], fourth[MOST_FUNCTIONS];
    differentiate(p->c, slope_of(p, b), fourth);
    differentiate(p->c, fourth, third);
    differentiate(p->c, third, fourth);
    return bound_on(p->c, fourth, from, to);
}

static sample sample_at(const phase *p, int b, double time)
{
    double functions[MOST_FUNCTIONS];
    phase_functions(p->c, time, functions);
    return (sample){dot(p->c->functions, value_of(p, b), functions),
                    dot(p->c->functions, slope_of(p, b), functions)};
}

/* Order of the first derivative of g_b at 0 that is nonzero beyond its error, and its sign; the
 * sign is 0 if none is. */
typedef struct {
    int order, sign;
} beginning;

static beginning begin(const phase *p, int b)
{
    const configuration *c = p->c;
    const int n = p->states;
    double value[MOST_FUNCTIONS], next[MOST_FUNCTIONS];
    double size[MOST_FUNCTIONS], above[MOST_FUNCTIONS];
    const double *weight = c->weight + (size_t)b * (size_t)c->functions * (size_t)(n + 1);
    for (int f = 0; f < c->functions; ++f) {
        value[f] = value_of(p, b)[f];
        size[f] = weight[f * (n + 1) + n];
        for (int j = 0; j < n; ++j)
            size[f] += weight[f * (n + 1) + j] * p->magnitude[j];
    }
    double d = at_start(c, value);
    for (int order = 0; order <= n; ++order) {
        differentiate(c, value, next);
        const double following = at_start(c, next);
        if (fabs(d) > START * at_start(c, size) + p->start * fabs(following))
            return (beginning){order, d > 0.0 ? 1 : -1};
        differentiate_sizes(c, size, above);
        for (int f = 0; f < c->functions; ++f) {
            value[f] = next[f];
            size[f] = above[f];
        }
        d = following;
    }
    return (beginning){0, 0};
}

uint32_t phase_begin(phase *p)
{
    const configuration *c = p->c;
    uint32_t crossed = 0;
    p->watched = p->zero = p->leaving = p->slow = 0;
    p->touches = 0;
    for (int b = 0; b < c->boundaries; ++b) {
        const uint32_t bit = (uint32_t)1 << b;
        const double *value = value_of(p, b);
        differentiate(c, value, p->slope + b * c->functions);
        double amplitude = 0.0, second = 0.0, fourth = 0.0;
        if (c->uniform)
            for (int i = 0; i < c->modes; ++i) {
                const mode *m = &c->mode[i];
                const double rate2 = m->rate * m->rate + m->frequency * m->frequency;
                if (rate2 == 0.0)
                    continue;
                const double one = value[m->first];
                const double two = m->oscillates ? value[m->first + 1] : 0.0;
                const double a = sqrt(one * one + two * two) * (1.0 + 8.0 * DBL_EPSILON);
                amplitude += a;
                second += a * rate2;
                fourth += a * rate2 * rate2;
            }
        p->amplitude[b] = amplitude;
        p->second[b] = second;
        p->fourth[b] = fourth;
        const double g = at_start(c, value);
        const double rate = at_start(c, slope_of(p, b));
        if (fabs(g) <= START * p->size[b] + p->start * fabs(rate)) {
            p->zero |= bit;
            /* the first derivative decides if it exceeds generous bounds on its error */
            const double rough = START * p->size[b] * (c->fastest + 1.0) + p->start * second;
            const beginning first = c->uniform && c->mode[0].length <= 2 && fabs(rate) > rough
                                        ? (beginning){1, rate > 0.0 ? 1 : -1}
                                        : begin(p, b);
            if (first.sign > 0)
                crossed |= bit;
            if (first.sign >= 0)
                continue; /* g = 0 as far as can be told: the motion slides along it */
            p->leaving |= bit;
            if (first.order != 1)
                p->slow |= bit;
        } else if (g > 0.0)
            crossed |= bit;
        /* a sum that never rises to zero needs no search */
        if (c->uniform && c->mode[0].length <= 2) {
            const double drift = c->mode[0].length == 2 ? value[1] : 0.0;
            if (drift <= 0.0 && value[0] + amplitude < -SAMPLE * p->size[b])
                continue;
            if (amplitude == 0.0 && drift <= 0.0)
                continue;
        }
        p->watched |= bit;
    }
    return crossed;
}

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
    s->order = begin(p, s->boundary).order;
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

/* First time in [from, to] at which boundary b is reached, or HUGE_VAL. */
static double first_in(phase *p, sampler *s, double from, double to, double cell_start)
{
    const int b = s->boundary;
    const double second = second_bound(p, b, cell_start, to);
    const double third = s->order ? third_bound(p, b, cell_start, to) : 0.0;
    double time = from, error;
    for (;;) {
        sample at = sampled(s, time, &error);
        while (at.value < -error) {
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
        while (at.value >= -error && at.value <= 2.0 * error && time < to) {
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
 * fall there. `error` is that of its value. */
static void gather(const phase *p, int b, double error, crossing *event)
{
    const double time = event->time;
    const double *functions = event->functions;
    phase_functions(p->c, time, event->functions);
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
    double slack[MOST_BOUNDARIES];
    for (int i = 0; i < c->modes; ++i) {
        cosine[i] = 1.0;
        sine[i] = 0.0;
    }
    for (uint32_t rest = p->watched; rest; rest &= rest - 1) {
        const int b = __builtin_ctz(rest);
        left[b] = (sample){at_start(c, value_of(p, b)), at_start(c, slope_of(p, b))};
        if (p->leaving >> b & 1)
            left[b].value = 0.0;
        slack[b] = SAMPLE * p->size[b];
    }
    double time = 0.0, h = c->cell;
    for (long cell = 0; time < window; ++cell) {
        double next = c->polynomial >= 0 ? time + h : (cell + 1) * h;
        const double from = time;
        if (next >= window || (cell + 1) % FRESH == 0 || c->polynomial >= 0) {
            next = next < window ? next : window;
            phase_functions(c, next, functions);
            for (int i = 0; i < c->modes; ++i) {
                cosine[i] = functions[c->mode[i].first];
                sine[i] = c->mode[i].oscillates ? functions[c->mode[i].first + 1] : 0.0;
            }
        } else
            for (int i = 0; i < c->modes; ++i) {
                const mode *m = &c->mode[i];
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
            const double fourth = fourth_bound(p, b, from, next);
            if (!c->uniform || c->mode[0].length > 1)
                slack[b] = SAMPLE / VALUE * error_at(p, b, next);
            if (!stays_below(left[b], right[b], width, fourth, slack[b], leaves) ||
                (leaves && (p->slow >> b & 1)))
                suspects |= (uint32_t)1 << b;
        }
        int first = -1;
        double earliest = next, error = 0.0;
        for (uint32_t rest = suspects; rest; rest &= rest - 1) {
            const int b = __builtin_ctz(rest);
            const int leaves = cell == 0 && (p->leaving >> b & 1);
            sampler s = {.p = p, .boundary = b};
            double found;
            if (!leaves && left[b].value < -slack[b] && right[b].value > slack[b] &&
                rises(left[b], right[b], width, fourth_bound(p, b, from, next), slack[b]))
                found = polished(&s, from, next, from + cubic_zero(left[b], right[b], width));
            else if (!leaves)
                found = first_in(p, &s, from, earliest, from);
            else {
                make_series(&s);
                const double shortest = SHORTEST * c->cell; /* powers of it do not underflow */
                const double least = s.order > 0 ? time_away(&s, next) : 0.0;
                const double away = least > shortest ? least : shortest;
                found = s.order == 0 || away >= next ? HUGE_VAL
                                                     : first_in(p, &s, away, earliest, from);
            }
            if (found <= earliest && (first < 0 || found < earliest)) {
                sampled(&s, found, &error);
                earliest = found;
                first = b;
            }
        }
        if (first >= 0) {
            event.found = 1;
            event.time = earliest;
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
