/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation bc8b907cd6e5cf02 */
#ifndef ELASTIC_STOP_H
#define ELASTIC_STOP_H

/* elastic-stop: two coupled oscillators, the first in front of an elastic stop (Sec. 2.2)
 *
 *     cc -std=c99 -O2 program.c elastic_stop.c -lm
 *
 * Loops over points use vectors with -O3 -fopenmp-simd -DNONSMOOTH_OPENMP_SIMD.
 *
 * Functions write their results and nothing else, keep nothing between calls and allocate
 * no memory: any number of threads may call them. Results must not overlap arguments.
 *
 * The enums name the places in arrays. Matrices stand row by row: entry (i, j) of one with
 * n columns at [n*i + j]. Several functions share these arrays:
 *
 *     parameters            of the system, or of the orbit in the orbit's functions
 *     spectrum              gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6:
 *                           what elastic_stop_spectrum gives, once for each point of k1, k2, k3,
 *                           m1, m2
 *     spectrum_derivatives  its `derivatives`: of spectrum[i] by the j-th of k1, k2, k3, m1, m2
 *     state                 x1, x2, v1, v2; of an orbit as its comment says
 *     state_after           the same after `time`
 *     unknowns              of the orbit
 *     residual              left-hand sides of the equations, which the orbit's comment lists
 *     jacobian              of residual[i] by unknowns[j]; in functions that take `reduced`, by
 *                           reduced[j]
 *     parameter_jacobian    of residual[i] by parameters[j], in total
 *     poincare_jacobian     of the Poincare map in the coordinates of the orbit's section
 *     saltations            of the state, one matrix for each phase
 *     monodromy             of the state at the end by that at the start
 *     reduced               unknowns from which all others follow, as `guess`: the orbit's comment
 *                           lists them
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
 * `parameters` are k1, k2, k3, m1, m2, in this order. */
void elastic_stop_spectrum(
    const double parameters[5], double spectrum[12], double derivatives[60]);
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
/* Exponents of the modes; coefficients of their functions, offsets last. */
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double exponents[12],
    double coefficients[200]);

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
/* Switching and periodicity equations. */
void elastic_stop_one_contact_residual(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double residual[4]);
/* Derivatives of the equations by the unknowns. */
void elastic_stop_one_contact_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double jacobian[16]);
/* Equations and their derivatives by the unknowns, sharing all intermediate terms. */
void elastic_stop_one_contact_residual_and_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double residual[4], double jacobian[16]);
/* Total derivatives of the equations by the parameters, through the spectrum too. */
void elastic_stop_one_contact_parameter_jacobian(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60],
    const double unknowns[4], double parameter_jacobian[24]);
/* Jacobian of the Poincare map in the section's coordinates. */
void elastic_stop_one_contact_poincare_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double poincare_jacobian[9]);
/* Saltation matrices of the transitions, one below the other. */
void elastic_stop_one_contact_saltations(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double saltations[32]);
/* Monodromy matrix: the product of flows and saltation matrices over a period. */
void elastic_stop_one_contact_monodromy(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double monodromy[16]);
/* Trace of the Poincare map's Jacobian. */
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *trace);
/* Derivatives of the trace by the unknowns, then in total by the parameters. */
void elastic_stop_one_contact_trace_gradient(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60],
    const double unknowns[4], double trace_gradient[10]);
/* State at the start and behind each transition, row by row. */
void elastic_stop_one_contact_states(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double states[12]);
/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the
 * other; and the frequencies of each phase. */
void elastic_stop_one_contact_boundary_functions(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double coefficients[12], double frequencies[4]);
/* State after a time in contact. */
void elastic_stop_one_contact_flow_contact(
    const double parameters[6], const double spectrum[12], double time, const double state[4],
    double state_after[4]);
/* State after a time in free. */
void elastic_stop_one_contact_flow_free(
    const double parameters[6], const double spectrum[12], double time, const double state[4],
    double state_after[4]);
/* Reduced equations and their derivatives by the reduced unknowns. */
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double residual[1], double jacobian[1]);
/* All unknowns from the reduced ones, and how singular the linear equations for them are: 0 if
 * they are. */
void elastic_stop_one_contact_expand(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double unknowns[4], double determinants[1]);

#ifdef __cplusplus
}
#endif

#endif
