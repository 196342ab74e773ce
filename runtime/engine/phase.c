/* Sums of the functions of time of one phase: values, derivatives and bounds. */
#include "phase.h"

#include "sums.h"
#include "support.h"

/* Impacts that accumulate leave the state where rounding puts it: each adds to what a function that
 * was located is off zero. */
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

beginning phase_beginning(const phase *p, int b)
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
        const int is_zero = order == 0 && (p->zero >> b & 1);
        if (!is_zero && fabs(d) > START * at_start(c, size) + p->start * fabs(following))
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
        const double slack = p->known & bit ? LOCATED : 1.0;
        if (fabs(g) <= slack * START * p->size[b] + p->start * fabs(rate)) {
            p->zero |= bit;
            /* the first derivative decides if it exceeds generous bounds on its error */
            const double rough = START * p->size[b] * (c->fastest + 1.0) + p->start * second;
            const beginning first = c->uniform && c->mode[0].length <= 2 && fabs(rate) > rough
                                        ? (beginning){1, rate > 0.0 ? 1 : -1}
                                        : phase_beginning(p, b);
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
