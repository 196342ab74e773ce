/* Generated; do not edit.
 * Source: nonsmooth.derive.codegen/support/nonsmooth_lanes.h
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation b61fab6a87d9aeea */
/* Points side by side: of `lanes` points entry i of lane l stands at [i*lanes + l]. */
#ifndef NONSMOOTH_LANES_H
#define NONSMOOTH_LANES_H

#include <stddef.h>

#include "nonsmooth_compiler.h"

enum { NONSMOOTH_LANES = 16 };

/* Entries of the points from `start` on; the last of `count` points fills the lanes behind it. */
static NONSMOOTH_INLINE void nonsmooth_load(int lanes, int entries, const double *columns,
                                            ptrdiff_t count, ptrdiff_t start, double *block)
{
    const ptrdiff_t left = count - start;
    for (int i = 0; i < entries; ++i) {
        const double *const given = columns + i * count + start;
        double *const taken = block + i * lanes;
        if (left >= lanes)
            for (int lane = 0; lane < lanes; ++lane)
                taken[lane] = given[lane];
        else
            for (int lane = 0; lane < lanes; ++lane)
                taken[lane] = given[lane < left ? lane : left - 1];
    }
}

/* The other way: entries of the lanes that are points. */
static NONSMOOTH_INLINE void nonsmooth_store(int lanes, int entries, const double *block,
                                             ptrdiff_t count, ptrdiff_t start, double *columns)
{
    const ptrdiff_t left = count - start;
    for (int i = 0; i < entries; ++i) {
        const double *const given = block + i * lanes;
        double *const taken = columns + i * count + start;
        if (left >= lanes)
            for (int lane = 0; lane < lanes; ++lane)
                taken[lane] = given[lane];
        else
            for (int lane = 0; lane < left; ++lane)
                taken[lane] = given[lane];
    }
}

#endif
