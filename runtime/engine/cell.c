/* The first zero of one boundary function in one cell, which no step can jump over. */
#include "cell.h"

/* In one stay, beside FREE_STEPS for each function in each cell. */
enum { MOST_STEPS = 1 << 20, FREE_STEPS = 64 };

/* Smallest positive root of g + g' s + M s^2/2, g < 0: no zero of a function lies before it whose
 * second derivative is at most M. */
static double safe_step(sample at, double second)
{
    if (second == 0.0)
        return at.slope > 0.0 ? -at.value / at.slope : HUGE_VAL;
    const double root = sqrt(at.slope * at.slope - 2.0 * second * at.value);
    return at.slope > 0.0 ? -2.0 * at.value / (at.slope + root) : (root - at.slope) / second;
}

sample cell_sample(const sampler *s, double time, double *error)
{
    if (s->order == 0) {
        if (error)
            *error = error_at(s->p, s->boundary, time);
        return sample_at(s->p, s->boundary, time);
    }
    const double *series = s->p->series, unit = s->p->c->unit, at = time / unit;
    double value = 0.0, slope = 0.0;
    for (int k = s->p->orders - 1; k >= s->order; --k) {
        value = value * at + series[k];
        slope = slope * at + k * series[k];
    }
    const double lower = pow(at, s->order - 1);
    if (error)
        *error = lower * at * s->error_of_series;
    return (sample){value * lower * at, slope * lower / unit};
}

void cell_leave(sampler *s)
{
    const phase *p = s->p;
    const configuration *c = p->c;
    s->order = phase_beginning(p, s->boundary).order;
    double *value = p->scratch, *next = value + c->functions, factor = 1.0;
    for (int f = 0; f < c->functions; ++f)
        value[f] = value_of(p, s->boundary)[f];
    for (int k = 0; k < p->orders; ++k) {
        p->series[k] = at_start(c, value) * factor;
        factor /= k + 1;
        differentiate(c, value, next);
        for (int f = 0; f < c->functions; ++f)
            value[f] = next[f] * c->unit;
    }
    s->error_of_series = VALUE * fabs(p->series[s->order]);
}

double cell_away(const sampler *s, double end)
{
    const phase *p = s->p;
    const configuration *c = p->c;
    double *value = p->scratch, *next = value + c->functions, factorial = 1.0;
    for (int f = 0; f < c->functions; ++f)
        value[f] = value_of(p, s->boundary)[f];
    for (int k = 0; k <= s->order; ++k) {
        factorial *= k > 0 ? k : 1;
        differentiate(c, value, next);
        for (int f = 0; f < c->functions; ++f)
            value[f] = next[f] * c->unit;
    }
    const double bound = bound_on(c, value, 0.0, end);
    const double leading = fabs(p->series[s->order]) * factorial;
    return bound > 0.0 ? 0.5 * (s->order + 1) * leading / bound * c->unit : HUGE_VAL;
}

/* A step that is safe behind a slow start, where the uniform bound on g'' hardly lets go on: no
 * longer than the time itself, over which g'' changes little. */
static double leaving_step(const sampler *s, sample at, double time, double third)
{
    const double *series = s->p->series, unit = s->p->c->unit, place = time / unit;
    double curve = 0.0, size = 0.0;
    for (int k = s->p->orders - 1; k >= 2; --k) {
        curve = curve * place + k * (k - 1) * series[k];
        size = size * place + k * (k - 1) * fabs(series[k]);
    }
    const double bend = (curve + SAMPLE * size) / (unit * unit) + third * time;
    const double step = safe_step(at, bend > 0.0 ? bend : 0.0);
    return step < time ? step : time;
}

double cell_crossing(const sampler *s, double low, double high, double time)
{
    const double second = second_bound(s->p, s->boundary, low, high);
    for (int i = 0; i < 80; ++i) {
        const sample at = cell_sample(s, time, NULL);
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

double cell_settled(const phase *p, int b, double low, double high, double time,
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

/* Whether a stay has taken more steps than it may, or is to end. */
static int has_to_end(phase *p)
{
    return ++p->steps > MOST_STEPS || lost(p->patience);
}

static int is_finite(sample at, double error)
{
    return fabs(at.value) + fabs(at.slope) + error < HUGE_VAL;
}

/* Each turn of each of its loops counts a step, so that MOST_STEPS ends them. */
double cell_first(phase *p, const sampler *s, double from, double to, double cell_start)
{
    const int b = s->boundary;
    const double second = second_bound(p, b, cell_start, to);
    const double third = s->order ? third_bound(p, b, cell_start, to) : 0.0;
    double time = from, error;
    if (!(second < HUGE_VAL))
        return NAN;
    p->steps = p->steps > FREE_STEPS ? p->steps - FREE_STEPS : 0;
    for (;;) {
        sample at = cell_sample(s, time, &error);
        for (;;) {
            if (!is_finite(at, error) || has_to_end(p))
                return NAN;
            if (!(at.value < -error))
                break;
            if (s->order == 0)
                p->start_of[b] &= (unsigned char)~LEAVING;
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
            at = cell_sample(s, time, &error);
        }
        /* the slope outlasts its change over the error: the crossing is transversal */
        if (at.slope > 0.0 && at.slope * at.slope > 8.0 * second * (error + fabs(at.value))) {
            const double reach = 2.0 * (error + fabs(at.value)) / at.slope;
            return cell_crossing(s, time > reach ? time - reach : 0.0, time + reach, time);
        }
        /* g is zero within its error: follow it in steps over which it changes no more */
        const double step = second > 0.0 ? sqrt(4.0 * error / second) : to - time;
        const double entered = time;
        double top = time, depth = at.value, before = time;
        while (at.value >= -error && at.value <= 2.0 * error && time < to) {
            if (has_to_end(p))
                return NAN;
            before = time;
            time = time + step > to ? to : time + step;
            if (!(time > before))
                time = nextafter(before, HUGE_VAL);
            at = cell_sample(s, time, &error);
            if (at.value > depth) {
                depth = at.value;
                top = time;
            }
        }
        if (at.value > 2.0 * error)
            return cell_crossing(s, before, time, 0.5 * (before + time));
        if (at.value >= -error && time >= to && at.slope > 0.0)
            return HUGE_VAL; /* the next cell begins here and decides */
        /* a start that is left so slowly that it takes more than a cell is no touch */
        if (s->order > 0 || !(p->start_of[b] & LEAVING)) {
            if (p->reached[b])
                return top;
            remember(p, b, entered, time, 0.5 * (entered + time), depth);
        }
        if (time >= to)
            return HUGE_VAL;
    }
}
