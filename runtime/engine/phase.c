/* Sums of the functions of time of one phase: values, derivatives and bounds. */
#include "phase.h"

#include <stdlib.h>

#include "factored.h"
#include "engine_limits.h"
#include "sums.h"
#include "nonsmooth_trigonometry.h"

/* Impacts that accumulate leave the state where rounding puts it: each adds to what a function that
 * was located is off zero. In 120,000 impacts of up to six masses none was off by more than one
 * rounding. */
static const double LOCATED = 1024.0;

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

void phase_functions(const configuration *c, double time, double *functions)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        if (m->chain > 0) {
            chain_functions(m, m->chain, time, functions);
            i += m->chain - 1;
            continue;
        }
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

void phase_bounds(const configuration *c, double time, double *bounds)
{
    for (int i = 0; i < c->modes; ++i) {
        const mode *m = &c->mode[i];
        if (m->chain > 0) {
            chain_bounds(m, m->chain, time, time, bounds + m->first);
            i += m->chain - 1;
            continue;
        }
        const double growth = m->rate != 0.0 ? exp(m->rate * time) : 1.0;
        spread(m, time, growth, growth, bounds);
    }
}

void phase_sizes(const phase *p, int b, double *sizes)
{
    const configuration *c = p->c;
    const int n = p->states;
    if (c->factored) {
        factored_sizes(p, b, sizes);
        return;
    }
    const double *weight = c->weight + (size_t)b * (size_t)c->dense * (size_t)(n + 1);
    for (int f = 0; f < c->functions; ++f, weight += n + 1) {
        sizes[f] = weight[n];
        for (int j = 0; j < n; ++j)
            sizes[f] += weight[j] * p->magnitude[j];
    }
}

beginning phase_beginning(const phase *p, int b)
{
    const configuration *c = p->c;
    const int n = p->states, count = c->functions;
    double *value = p->scratch, *next = value + count;
    double *size = next + count, *above = size + count;
    for (int f = 0; f < count; ++f)
        value[f] = value_of(p, b)[f];
    phase_sizes(p, b, size);
    double d = at_start(c, value);
    for (int order = 0; order <= n; ++order) {
        differentiate(c, value, next);
        differentiate_sizes(c, size, above);
        const double error = START * at_start(c, size);
        for (int f = 0; f < count; ++f) {
            value[f] = next[f] * c->unit;
            size[f] = above[f] * c->unit;
        }
        const double following = at_start(c, value);
        const int is_zero = order == 0 && p->start_of[b] & ZERO;
        if (!is_zero && fabs(d) > error + p->start * fabs(following) / c->unit)
            return (beginning){order, d > 0.0 ? 1 : -1};
        d = following;
    }
    return (beginning){0, 0};
}

int phase_begin(phase *p)
{
    const configuration *c = p->c;
    int crossed = 0;
    set_clear(p->event, p->words);
    p->touches = p->watching = 0;
    for (int b = 0; b < c->boundaries; ++b) {
        const double *value = value_of(p, b);
        differentiate(c, value, p->slope + (size_t)b * (size_t)c->functions);
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
        p->start_of[b] = 0;
        const double g = at_start(c, value);
        const double rate = at_start(c, slope_of(p, b));
        const double slack = set_has(p->known, b) ? LOCATED : 1.0;
        if (fabs(g) <= slack * START * p->size[b] + p->start * fabs(rate)) {
            p->start_of[b] = ZERO;
            /* the first derivative decides if it exceeds generous bounds on its error */
            const double rough =
                START * (p->size[b] * c->fastest + p->drift[b]) + p->start * second;
            const beginning first = c->simple && fabs(rate) > rough
                                        ? (beginning){1, rate > 0.0 ? 1 : -1}
                                        : phase_beginning(p, b);
            if (first.sign > 0) {
                set_put(p->event, b);
                crossed = 1;
            }
            if (first.sign >= 0)
                continue; /* g = 0 as far as can be told: the motion slides along it */
            p->start_of[b] = first.order == 1 ? ZERO | LEAVING : ZERO | LEAVING | SLOW;
        } else if (g > 0.0) {
            set_put(p->event, b);
            crossed = 1;
        }
        /* a sum that never rises to zero needs no search */
        if (c->simple) {
            const double drift = c->mode[0].length == 2 ? value[1] : 0.0;
            if (drift <= 0.0 && value[0] + amplitude < -SAMPLE * p->size[b])
                continue;
            if (amplitude == 0.0 && drift <= 0.0)
                continue;
        }
        p->watched[p->watching++] = b;
    }
    return crossed;
}

/* Orders of a series beside those of the leading one, which is below the number of states. */
enum { FEW_STATES = 16 };

enum { SETS = 3, ARRAYS = 16 };

int phase_create(phase *p, const layout *l)
{
    const size_t boundaries = (size_t)l->most_boundaries, functions = (size_t)l->most_functions;
    const size_t orders = ORDERS + (size_t)(l->states > FEW_STATES ? l->states : FEW_STATES);
    const size_t products = size_product(boundaries, functions), words = (size_t)l->words;
    const size_t factored = (size_t)l->most_factored;
    const size_t waves = 2 * (size_t)l->most_modes + 2 * functions;
    double **const array[ARRAYS] = {&p->value,  &p->slope,  &p->size,      &p->amplitude,
                                    &p->second, &p->fourth, &p->series,    &p->functions,
                                    &p->sampled, &p->scratch, &p->waves,     &p->projected,
                                    &p->projected_size, &p->drift, &p->weights, &p->bounds};
    const size_t size[ARRAYS] = {products,   products,   boundaries, boundaries,
                                 boundaries, boundaries, orders,     functions,
                                 functions,  4 * functions, waves,   factored,
                                 factored,   boundaries, products,   functions};
    size_t doubles = 0;
    for (int i = 0; i < ARRAYS; ++i)
        doubles = size_sum(doubles, size[i]);
    p->memory = calloc(doubles, sizeof(double));
    p->ends = calloc(boundaries + 1, sizeof *p->ends);
    p->sets = calloc(SETS * words, sizeof *p->sets);
    p->watched = calloc(2 * boundaries + 1, sizeof *p->watched);
    p->start_of = calloc(boundaries + 1, sizeof *p->start_of);
    if (!p->memory || !p->ends || !p->sets || !p->watched || !p->start_of) {
        phase_free(p);
        return -1;
    }
    double *at = p->memory;
    for (int i = 0; i < ARRAYS; ++i) {
        *array[i] = at;
        at += size[i];
    }
    p->suspect = p->watched + boundaries;
    p->known = p->sets;
    p->event = p->known + words;
    p->spare = p->event + words;
    p->words = l->words;
    p->orders = (int)orders;
    return 0;
}

void phase_free(phase *p)
{
    free(p->memory);
    free(p->ends);
    free(p->sets);
    free(p->watched);
    free(p->start_of);
    p->memory = NULL;
    p->ends = NULL;
    p->sets = NULL;
    p->watched = NULL;
    p->start_of = NULL;
}
