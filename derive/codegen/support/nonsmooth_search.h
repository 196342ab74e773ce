/* Guaranteed maximum of a function of time within a cell, from a bound on its fourth derivative. */
#ifndef NONSMOOTH_SEARCH_H
#define NONSMOOTH_SEARCH_H

#include <math.h>

enum {
    NONSMOOTH_POINTS = 16,   /* of a block of cells */
    NONSMOOTH_STACK = 64,    /* cells waiting in one refinement */
    NONSMOOTH_SPLITS = 8192, /* bisections of the cells of a function */
    NONSMOOTH_MORE = 16,     /* and for each of its cells */
    NONSMOOTH_NEWTON = 64    /* iterations of one polish */
};

typedef struct {
    double time, value, slope, curvature;
} nonsmooth_jet;

typedef struct {
    nonsmooth_jet left, right;
    int polished;
} nonsmooth_cell;

/* A function of time, and what gives its value and derivatives. */
typedef struct {
    nonsmooth_jet (*evaluate)(const void *function, double time);
    const void *function;
} nonsmooth_curve;

/* Upper bound of g on a cell: the cubic Hermite interpolant as a quartic in Bernstein form. Its
 * error, at most M4 h^4/24 u^2 (1-u)^2 with |g''''| <= M4, is M4 h^4/144 = excess times the middle
 * Bernstein polynomial. */
static inline double nonsmooth_upper(double value0, double slope0, double value1, double slope1,
                                     double width, double excess)
{
    const double first = value0 + 0.25 * width * slope0;
    const double middle = 0.5 * (value0 + value1) + width * (slope0 - slope1) / 6.0 + excess;
    const double last = value1 - 0.25 * width * slope1;
    const double outer = value0 > value1 ? value0 : value1;
    const double inner = first > last ? first : last;
    const double most = outer > inner ? outer : inner;
    return most > middle ? most : middle;
}

/* The maximum of g inside a cell with g' > 0 on its left and g' < 0 on its right, by Newton kept in
 * the bracket, until the slope no longer matters to the bound over the cell. */
static inline nonsmooth_jet nonsmooth_polish(nonsmooth_curve g, const nonsmooth_cell *cell,
                                             double slack)
{
    double low = cell->left.time, high = cell->right.time;
    const double width = high - low;
    double time = low + width * (cell->left.slope / (cell->left.slope - cell->right.slope));
    nonsmooth_jet jet = g.evaluate(g.function, time);
    for (int i = 0; i < NONSMOOTH_NEWTON && width * fabs(jet.slope) > slack; ++i) {
        if (jet.slope > 0.0)
            low = time;
        else
            high = time;
        time -= jet.slope / jet.curvature;
        if (!(time > low && time < high))
            time = 0.5 * (low + high);
        jet = g.evaluate(g.function, time);
    }
    return jet;
}

/* Raise *maximum to the maximum of g over the cell, to within slack. When the cells or the splits
 * run out the upper bound itself is taken, which errs on the safe side: each turn of the loop spends
 * a split or takes a cell that a split left, so that there are at most twice as many as splits. */
static inline void nonsmooth_refine(nonsmooth_curve g, nonsmooth_cell cell, double slack,
                                    double excess, long long *splits, double *maximum, double *time)
{
    nonsmooth_cell stack[NONSMOOTH_STACK];
    const double full = cell.right.time - cell.left.time;
    int waiting = 0;
    for (;;) {
        const double width = cell.right.time - cell.left.time, ratio = width / full;
        const double upper =
            nonsmooth_upper(cell.left.value, cell.left.slope, cell.right.value, cell.right.slope,
                            width, excess * (ratio * ratio) * (ratio * ratio));
        if (upper > *maximum + slack) {
            const double centre = cell.left.time + 0.5 * width;
            if (*splits > 0 && waiting < NONSMOOTH_STACK) {
                /* Split at the maximum: there both halves are discarded at once. A half is not
                 * polished again, or a maximum near its end would never leave it. */
                const int polished =
                    !cell.polished && cell.left.slope > 0.0 && cell.right.slope < 0.0;
                const nonsmooth_jet jet = polished ? nonsmooth_polish(g, &cell, slack)
                                                   : g.evaluate(g.function, centre);
                if (jet.value > *maximum) {
                    *maximum = jet.value;
                    *time = jet.time;
                }
                const nonsmooth_cell right = {jet, cell.right, polished};
                stack[waiting++] = right;
                cell.right = jet;
                cell.polished = polished;
                --*splits;
                continue;
            }
            *maximum = upper;
            *time = centre;
        }
        if (waiting == 0)
            return;
        cell = stack[--waiting];
    }
}

#endif
