/* Configurations of which some modes have factors instead of matrices: what takes the square of the
 * number of states, where matrices take its cube.
 *
 * Bounds of the sizes of what is summed are those of the products u v themselves, each factor's
 * parts taken by themselves: never below those of the matrices. */
#ifndef NONSMOOTH_FACTORED_H
#define NONSMOOTH_FACTORED_H

#include "phase.h"

/* A boundary's row times the factors u, the same of absolute values, and its bound of sizes by
 * those of the state, to which those of the matrices are added up already. */
void factored_boundary(const configuration *c, int n, const double *row, double *across,
                       double *spread, double *size);

/* Coefficients of the boundary functions of a phase, and its projections v . (y, 1). */
void factored_begin(phase *p, int n);

/* Bounds of the sizes of one boundary's coefficients. */
void factored_sizes(const phase *p, int b, double *sizes);

/* The state at a time of a phase's configuration, from that at its start, and bounds on the sizes
 * of what was summed, from bounds on the functions. */
void factored_flow(const phase *p, int n, const double *functions, const double *bounds,
                   double *restrict state, double *restrict magnitude);

#endif
