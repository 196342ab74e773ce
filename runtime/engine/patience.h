/* Loops that work without Python ask now and then whether they are to end. */
#ifndef NONSMOOTH_PATIENCE_H
#define NONSMOOTH_PATIENCE_H

#include <stddef.h>

/* Steps between two questions: a step takes 20 ns to 1 ms, as large as the system is. */
enum { PATIENCE = 64 };

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

#endif
