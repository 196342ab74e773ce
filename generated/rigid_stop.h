/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation e0db5a0cf84061ce */
#ifndef NONSMOOTH_SYSTEM_RIGID_STOP_H
#define NONSMOOTH_SYSTEM_RIGID_STOP_H

/* rigid-stop: two coupled oscillators, the first in front of a rigid stop (Sec. 2.1)
 *
 *     cc -std=c99 -O2 program.c rigid_stop.c -lm
 *
 * Loops over points use vectors with -O3 -fopenmp-simd -DNONSMOOTH_OPENMP_SIMD.
 *
 * Functions write their results and nothing else, keep nothing between calls and allocate
 * no memory: any number of threads may call them. Results must not overlap arguments.
 * Of several results of a function for one point any may be NULL: then it is not wanted,
 * and what is behind the last one that is wanted is not computed.
 *
 * The enums name the places in arrays. Matrices stand row by row: entry (i, j) of one with
 * n columns at [n*i + j]. Several functions share these arrays:
 *
 *     parameters            of the system, or of the orbit in the orbit's functions
 *     spectrum              gap1, omega1, omega2, p1, p2, p3, omega3: what rigid_stop_spectrum
 *                           gives, once for each point of m1, m2, k1, k2
 *     spectrum_derivatives  of spectrum[i] by the j-th of m1, m2, k1, k2
 *     state                 x1, x2, v1, v2; of an orbit as its comment says
 *     state_after           the same after `time`
 *     unknowns              of the orbit
 *     residual              left-hand sides of the equations, which the orbit's comment lists
 *     jacobian              of residual[i] by unknowns[j]
 *     parameter_jacobian    of residual[i] by parameters[j], in total
 *     poincare_jacobian     of the Poincare map in the coordinates of the orbit's section
 *     saltations            of the state, one matrix for each phase
 *     monodromy             of the state at the end by that at the start
 *     trace_gradient        of the trace by unknowns, then by parameters in total
 *     directions            of unknowns[i], and of the trace in the last row, by parameters[j]
 *
 * Example:
 *
 *     #include <stdio.h>
 *     #include "rigid_stop.h"
 *
 *     int main(void)
 *     {
 *         const double parameters[RIGID_STOP_ONE_IMPACT_PARAMETERS] =
 *             {1.0, 2.0, 1.0, 5.0, 6.283185307179586};
 *         double unknowns[RIGID_STOP_ONE_IMPACT_UNKNOWNS], trace, residual;
 *         int32_t iterations, status;
 *         rigid_stop_one_impact_solve(
 *             1, parameters, unknowns, &trace, &residual, &iterations, &status);
 *         printf("status %d, trace %.15g\n", (int)status, trace);
 *         for (int i = 0; i < RIGID_STOP_ONE_IMPACT_UNKNOWNS; ++i)
 *             printf("%.15g\n", unknowns[i]);
 *         return status != RIGID_STOP_CONVERGED;
 *     }
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { /* parameters of the system */
    RIGID_STOP_M1 = 0, /* first mass, in the user's consistent units; 0 < m1 */
    RIGID_STOP_M2 = 1, /* second mass; 0 < m2 */
    RIGID_STOP_K1 = 2, /* stiffness of the spring between the masses; 0 < k1 */
    RIGID_STOP_K2 = 3, /* stiffness of the spring between the second mass and the ground; 0 < k2 */
    RIGID_STOP_R = 4, /* coefficient of restitution, nondimensional; 0 <= r <= 1 */
    RIGID_STOP_PARAMETERS = 5 /* how many */
};

enum { /* state of the system */
    RIGID_STOP_X1 = 0,
    RIGID_STOP_X2 = 1,
    RIGID_STOP_V1 = 2,
    RIGID_STOP_V2 = 3,
    RIGID_STOP_STATES = 4 /* how many */
};

enum { /* status of a point that ..._solve gives */
    RIGID_STOP_CONVERGED = 0, /* a solution: ask ..._admissible whether it is a motion */
    RIGID_STOP_NOT_CONVERGED = 1, /* 32 steps were not enough: guess nearer */
    RIGID_STOP_NOT_FINITE = 2, /* no numbers: mind the domains, guess nearer */
    RIGID_STOP_NOT_POSITIVE = 3, /* a duration is not positive: no orbit, guess another */
    RIGID_STOP_SINGULAR = 5 /* the start is not determined: move a parameter */
};

enum { /* boundary that ..._admissible gives where it is no row */
    RIGID_STOP_ADMISSIBLE = -1, /* none is crossed inside a phase: a motion */
    RIGID_STOP_NO_DURATION = -2, /* a duration is not positive */
    RIGID_STOP_UNDECIDED = -3 /* data not finite, or too large for a guarantee */
};

/* Frequencies and projector coefficients, with their derivatives by the parameters. Its
 * `parameters` are m1, m2, k1, k2, in this order. Gives spectrum (7), spectrum_derivatives (7,
 * 4). */
void rigid_stop_spectrum(
    const double parameters[4], double *spectrum, double *spectrum_derivatives);
/* State after a time in free. */
void rigid_stop_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in contact. */
void rigid_stop_flow_contact(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* Vector fields of the configurations, one below the other, offsets last. */
void rigid_stop_fields(
    const double parameters[5], double fields[40]);
/* Affine functions of the state: gradients, constants last. */
void rigid_stop_rows(
    const double parameters[5], double rows[25]);
/* Affine resets of the state, one below the other, offsets last. */
void rigid_stop_resets(
    const double parameters[5], double resets[60]);
/* Exponents of the modes; coefficients of their functions, offsets last. Gives exponents (5, 2),
 * coefficients (36, 5). */
void rigid_stop_modes(
    const double parameters[5], const double spectrum[7], double *exponents, double *coefficients);

/* Orbit one-impact.
 *
 *     phases          1 free for T, until first-reaches-stop
 *     state           x1, x2, v1, v2
 *     section         y, u, w
 *     residual        [0] v1 vanishes halfway through free
 *                     [1] v2 vanishes halfway through free
 *     boundary        in phase 1: [0] first-reaches-stop
 */

enum { /* parameters of this orbit */
    RIGID_STOP_ONE_IMPACT_M1 = 0, /* first mass, in the user's consistent units; 0 < m1; e.g. 1.0 */
    RIGID_STOP_ONE_IMPACT_M2 = 1, /* second mass; 0 < m2; e.g. 2.0 */
    RIGID_STOP_ONE_IMPACT_K1 = 2, /* stiffness of the spring between the masses; 0 < k1; e.g. 1.0 */
    /* stiffness of the spring between the second mass and the ground; 0 < k2; e.g. 5.0 */
    RIGID_STOP_ONE_IMPACT_K2 = 3,
    RIGID_STOP_ONE_IMPACT_T = 4, /* period of the orbit; 0 < T; e.g. 6.283185307179586 */
    RIGID_STOP_ONE_IMPACT_PARAMETERS = 5 /* how many */
};

enum { /* unknowns, columns of the jacobian */
    RIGID_STOP_ONE_IMPACT_Y = 0, /* x2 at the start; e.g. 0.162 */
    RIGID_STOP_ONE_IMPACT_U = 1, /* v1 at the start; e.g. -0.372 */
    RIGID_STOP_ONE_IMPACT_UNKNOWNS = 2 /* how many */
};

/* Newton's method on the reduced equations for `count` points, each from its guess: unknowns,
 * trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold
 * columns: entry i of a point stands at [i*count + point]. Where the equations have several
 * solutions the guess decides. */
void rigid_stop_one_impact_solve(
    ptrdiff_t count, const double *parameters, double *unknowns, double *trace, double *residual,
    int32_t *iterations, int32_t *status);
/* Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by
 * point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how much
 * the boundary's function exceeds zero, and how long after the start of the phase. */
void rigid_stop_one_impact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant);
/* Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points.
 * Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations
 * are singular. */
void rigid_stop_one_impact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
/* Switching and periodicity equations; their derivatives by the unknowns; those by the
 * parameters, in total, through the spectrum too. Gives residual (2), jacobian (2, 2),
 * parameter_jacobian (2, 5). Takes spectrum_derivatives (7, 4) for parameter_jacobian, else
 * NULL. */
void rigid_stop_one_impact_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian);
/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the
 * parameters. Gives trace, trace_gradient (7). Takes spectrum_derivatives (7, 4) for
 * trace_gradient, else NULL. */
void rigid_stop_one_impact_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    const double *spectrum_derivatives, double *trace, double *trace_gradient);
/* State at the start and behind each transition. Boundaries along the phases: constant, slope,
 * cosine and sine amplitudes, one after the other; and the frequencies of each phase. Gives
 * states (2, 4), coefficients (6), frequencies (2). */
void rigid_stop_one_impact_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *states,
    double *coefficients, double *frequencies);
/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the
 * other; monodromy matrix. Gives poincare_jacobian (3, 3), saltations (4, 4), monodromy (4, 4). */
void rigid_stop_one_impact_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double *poincare_jacobian, double *saltations, double *monodromy);
/* All unknowns; how singular the linear equations for them are: 0 if they are. Gives unknowns
 * (2), determinants (1). */
void rigid_stop_one_impact_reduced(
    const double parameters[5], const double spectrum[7], double *unknowns, double *determinants);

#ifdef __cplusplus
}
#endif

#endif
