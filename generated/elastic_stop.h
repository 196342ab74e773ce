/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 34270e2de36ca60b */
#ifndef NONSMOOTH_SYSTEM_ELASTIC_STOP_H
#define NONSMOOTH_SYSTEM_ELASTIC_STOP_H

/* elastic-stop: two coupled oscillators, the first in front of an elastic stop (Sec. 2.2)
 *
 *     cc -std=c99 -O2 program.c elastic_stop.c -lm
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
 *     spectrum              gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6:
 *                           what elastic_stop_spectrum gives, once for each point of m1, m2, k1,
 *                           k2, k3
 *     spectrum_derivatives  of spectrum[i] by the j-th of m1, m2, k1, k2, k3
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
 *     reduced               unknowns from which all others follow, as `guess`: the orbit's comment
 *                           lists them
 *     reduced_residual      left-hand sides of the equations that are left for them
 *     reduced_jacobian      of reduced_residual[i] by reduced[j]
 *     directions            of unknowns[i], and of the trace in the last row, by parameters[j]
 *
 * Example:
 *
 *     #include <stdio.h>
 *     #include "elastic_stop.h"
 *
 *     int main(void)
 *     {
 *         const double parameters[ELASTIC_STOP_ONE_CONTACT_PARAMETERS] =
 *             {1.0, 2.0, 1.0, 5.0, 1.0, 6.283185307179586};
 *         const double guess[1] = {2.12};
 *         double unknowns[ELASTIC_STOP_ONE_CONTACT_UNKNOWNS], trace, residual;
 *         int32_t iterations, status;
 *         elastic_stop_one_contact_solve(
 *             1, parameters, guess, unknowns, &trace, &residual, &iterations, &status);
 *         printf("status %d, trace %.15g\n", (int)status, trace);
 *         for (int i = 0; i < ELASTIC_STOP_ONE_CONTACT_UNKNOWNS; ++i)
 *             printf("%.15g\n", unknowns[i]);
 *         return status != ELASTIC_STOP_CONVERGED;
 *     }
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { /* parameters of the system */
    ELASTIC_STOP_M1 = 0, /* first mass, in the user's consistent units; 0 < m1 */
    ELASTIC_STOP_M2 = 1, /* second mass; 0 < m2 */
    ELASTIC_STOP_K1 = 2, /* stiffness of the spring between the masses; 0 < k1 */
    /* stiffness of the spring between the second mass and the ground; 0 < k2 */
    ELASTIC_STOP_K2 = 3,
    ELASTIC_STOP_K3 = 4, /* stiffness of the stop; 0 < k3 */
    ELASTIC_STOP_PARAMETERS = 5 /* how many */
};

enum { /* state of the system */
    ELASTIC_STOP_X1 = 0,
    ELASTIC_STOP_X2 = 1,
    ELASTIC_STOP_V1 = 2,
    ELASTIC_STOP_V2 = 3,
    ELASTIC_STOP_STATES = 4 /* how many */
};

enum { /* status of a point that ..._solve gives */
    ELASTIC_STOP_CONVERGED = 0, /* a solution: ask ..._admissible whether it is a motion */
    ELASTIC_STOP_NOT_CONVERGED = 1, /* 32 steps were not enough: guess nearer */
    ELASTIC_STOP_NOT_FINITE = 2, /* no numbers: mind the domains, guess nearer */
    ELASTIC_STOP_NOT_POSITIVE = 3, /* a duration is not positive: no orbit, guess another */
    ELASTIC_STOP_SINGULAR = 5 /* the start is not determined: move a parameter */
};

enum { /* boundary that ..._admissible gives where it is no row */
    ELASTIC_STOP_ADMISSIBLE = -1, /* none is crossed inside a phase: a motion */
    ELASTIC_STOP_NO_DURATION = -2, /* a duration is not positive */
    ELASTIC_STOP_UNDECIDED = -3 /* data not finite, or too large for a guarantee */
};

/* Frequencies and projector coefficients, with their derivatives by the parameters. Its
 * `parameters` are m1, m2, k1, k2, k3, in this order. Gives spectrum (12), spectrum_derivatives
 * (12, 5). */
void elastic_stop_spectrum(
    const double parameters[5], double *spectrum, double *spectrum_derivatives);
/* State after a time in contact. */
void elastic_stop_flow_contact(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4]);
/* State after a time in free. */
void elastic_stop_flow_free(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4]);
/* Vector fields of the configurations, one below the other, offsets last. */
void elastic_stop_fields(
    const double parameters[5], double fields[40]);
/* Affine functions of the state: gradients, constants last. */
void elastic_stop_rows(
    const double parameters[5], double rows[25]);
/* Affine resets of the state, one below the other, offsets last. */
void elastic_stop_resets(
    const double parameters[5], double resets[20]);
/* Exponents of the modes; coefficients of their functions, offsets last. Gives exponents (6, 2),
 * coefficients (40, 5). */
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double *exponents, double *coefficients);

/* Orbit one-contact.
 *
 *     phases          1 contact for tau, until first-leaves-stop
 *                     2 free for T - tau, until first-reaches-stop
 *     state           x1, x2, v1, v2
 *     section         y, u, w
 *     residual        [0] v1 vanishes halfway through contact
 *                     [1] v2 vanishes halfway through contact
 *                     [2] v1 vanishes halfway through free
 *                     [3] v2 vanishes halfway through free
 *     guess, reduced  [0] tau
 *     boundary        in phase 1: [0] first-leaves-stop
 *                     in phase 2: [1] first-reaches-stop
 */

enum { /* parameters of this orbit */
    /* first mass, in the user's consistent units; 0 < m1; e.g. 1.0 */
    ELASTIC_STOP_ONE_CONTACT_M1 = 0,
    ELASTIC_STOP_ONE_CONTACT_M2 = 1, /* second mass; 0 < m2; e.g. 2.0 */
    /* stiffness of the spring between the masses; 0 < k1; e.g. 1.0 */
    ELASTIC_STOP_ONE_CONTACT_K1 = 2,
    /* stiffness of the spring between the second mass and the ground; 0 < k2; e.g. 5.0 */
    ELASTIC_STOP_ONE_CONTACT_K2 = 3,
    ELASTIC_STOP_ONE_CONTACT_K3 = 4, /* stiffness of the stop; 0 < k3; e.g. 1.0 */
    ELASTIC_STOP_ONE_CONTACT_T = 5, /* period of the orbit; 0 < T; e.g. 6.283185307179586 */
    ELASTIC_STOP_ONE_CONTACT_PARAMETERS = 6 /* how many */
};

enum { /* unknowns, columns of the jacobian */
    ELASTIC_STOP_ONE_CONTACT_Y = 0, /* x2 at the start; e.g. 0.42 */
    ELASTIC_STOP_ONE_CONTACT_U = 1, /* v1 at the start; e.g. 3.66 */
    ELASTIC_STOP_ONE_CONTACT_W = 2, /* v2 at the start; e.g. 0.59 */
    ELASTIC_STOP_ONE_CONTACT_TAU = 3, /* duration of phase 1, contact; e.g. 2.12 */
    ELASTIC_STOP_ONE_CONTACT_UNKNOWNS = 4 /* how many */
};

/* Newton's method on the reduced equations for `count` points, each from its guess: unknowns,
 * trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold
 * columns: entry i of a point stands at [i*count + point]. Where the equations have several
 * solutions the guess decides. */
void elastic_stop_one_contact_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status);
/* Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by
 * point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how much
 * the boundary's function exceeds zero, and how long after the start of the phase. */
void elastic_stop_one_contact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant);
/* Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points.
 * Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations
 * are singular. */
void elastic_stop_one_contact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
/* Switching and periodicity equations; their derivatives by the unknowns; those by the
 * parameters, in total, through the spectrum too. Gives residual (4), jacobian (4, 4),
 * parameter_jacobian (4, 6). Takes spectrum_derivatives (12, 5) for parameter_jacobian, else
 * NULL. */
void elastic_stop_one_contact_equations(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian);
/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the
 * parameters. Gives trace, trace_gradient (10). Takes spectrum_derivatives (12, 5) for
 * trace_gradient, else NULL. */
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    const double *spectrum_derivatives, double *trace, double *trace_gradient);
/* State at the start and behind each transition. Boundaries along the phases: constant, slope,
 * cosine and sine amplitudes, one after the other; and the frequencies of each phase. Gives
 * states (3, 4), coefficients (12), frequencies (4). */
void elastic_stop_one_contact_passage(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *states,
    double *coefficients, double *frequencies);
/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the
 * other; monodromy matrix. Gives poincare_jacobian (3, 3), saltations (8, 4), monodromy (4, 4). */
void elastic_stop_one_contact_linearisation(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double *poincare_jacobian, double *saltations, double *monodromy);
/* All unknowns from the reduced ones; how singular the linear equations for them are: 0 if they
 * are; the equations for these and their derivatives. Gives unknowns (4), determinants (1),
 * reduced_residual (1), reduced_jacobian (1, 1). */
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double *unknowns, double *determinants, double *reduced_residual, double *reduced_jacobian);

#ifdef __cplusplus
}
#endif

#endif
