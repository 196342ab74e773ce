/* Points side by side: entry i of lane l stands at [i*NONSMOOTH_LANES + l]. */
#ifndef NONSMOOTH_LANES_H
#define NONSMOOTH_LANES_H

#include <stddef.h>

#include "nonsmooth_compiler.h"

enum { NONSMOOTH_LANES = 16 };

/* Entries of the points from `start` on; the last of `count` points fills the lanes behind it. */
static NONSMOOTH_INLINE void nonsmooth_load(int entries, const double *columns, ptrdiff_t count,
                                            ptrdiff_t start, double *lanes)
{
    const ptrdiff_t left = count - start;
    for (int i = 0; i < entries; ++i) {
        const double *const given = columns + i * count + start;
        double *const taken = lanes + i * NONSMOOTH_LANES;
        if (left >= NONSMOOTH_LANES)
            for (int lane = 0; lane < NONSMOOTH_LANES; ++lane)
                taken[lane] = given[lane];
        else
            for (int lane = 0; lane < NONSMOOTH_LANES; ++lane)
                taken[lane] = given[lane < left ? lane : left - 1];
    }
}

/* The other way: entries of the lanes that are points. */
static NONSMOOTH_INLINE void nonsmooth_store(int entries, const double *lanes, ptrdiff_t count,
                                             ptrdiff_t start, double *columns)
{
    const ptrdiff_t left = count - start;
    for (int i = 0; i < entries; ++i) {
        const double *const given = lanes + i * NONSMOOTH_LANES;
        double *const taken = columns + i * count + start;
        if (left >= NONSMOOTH_LANES)
            for (int lane = 0; lane < NONSMOOTH_LANES; ++lane)
                taken[lane] = given[lane];
        else
            for (int lane = 0; lane < left; ++lane)
                taken[lane] = given[lane];
    }
}

#endif
