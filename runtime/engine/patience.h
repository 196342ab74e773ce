/* Loops that work without Python ask now and then whether they are to end. */
#ifndef NONSMOOTH_PATIENCE_H
#define NONSMOOTH_PATIENCE_H

#include <stddef.h>

/* Steps between two questions, and products that count as one more: a step takes 20 ns to some
 * microseconds, as large as the system is. */
enum { PATIENCE = 64, PRODUCTS = 1 << 14 };

typedef struct {
    int (*ends)(void *context); /* NULL: never */
    void *context;
    int left; /* steps until it is asked again */
    int ended;
} patience;

/* Count one step; whether it is to be the last one. */
static inline int lost(patience *p)
{
    if (--p->left > 0)
        return 0;
    p->left = PATIENCE;
    if (!p->ended && p->ends)
        p->ended = p->ends(p->context);
    return p->ended;
}

/* The same of a step that has so many products. */
static inline int lost_after(patience *p, size_t products)
{
    const size_t steps = products / PRODUCTS;
    p->left -= steps < PATIENCE ? (int)steps : PATIENCE;
    return lost(p);
}

#endif
