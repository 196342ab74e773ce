/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation a9cad82ee1ca7804 */
#ifndef NONSMOOTH_SYSTEM_DRY_FRICTION_H
#define NONSMOOTH_SYSTEM_DRY_FRICTION_H

/* dry-friction: two coupled oscillators on a driving belt with dry friction (Sec. 3)
 *
 *     cc -std=c99 -O2 program.c dry_friction.c -lm
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
 *     spectrum              gap1, omega1, omega2, p1, p2, p3, omega3: what dry_friction_spectrum
 *                           gives, once for each point of chi, eta
 *     spectrum_derivatives  of spectrum[i] by the j-th of chi, eta
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
 *     #include "dry_friction.h"
 *
 *     int main(void)
 *     {
 *         const double parameters[DRY_FRICTION_SYMMETRIC_PARAMETERS] = {0.4, 4.0, 0.6773, 0.5};
 *         const double guess[2] = {2.651, 2.245};
 *         double unknowns[DRY_FRICTION_SYMMETRIC_UNKNOWNS], trace, residual;
 *         int32_t iterations, status;
 *         dry_friction_symmetric_solve(
 *             1, parameters, guess, unknowns, &trace, &residual, &iterations, &status);
 *         printf("status %d, trace %.15g\n", (int)status, trace);
 *         for (int i = 0; i < DRY_FRICTION_SYMMETRIC_UNKNOWNS; ++i)
 *             printf("%.15g\n", unknowns[i]);
 *         return status != DRY_FRICTION_CONVERGED;
 *     }
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { /* parameters of the system */
    DRY_FRICTION_CHI = 0, /* stiffness ratio k2/(k1 + k2), nondimensional; 0 < chi < 1 */
    DRY_FRICTION_ETA = 1, /* mass ratio m1/m2, nondimensional; 0 < eta */
    DRY_FRICTION_V = 2, /* velocity of the belt, nondimensional; 0 < V */
    DRY_FRICTION_US1 = 3, /* slipping friction force on the first mass, nondimensional; 0 < us1 */
    DRY_FRICTION_UR1 = 4, /* static friction force on the first mass, nondimensional; 0 < ur1 */
    DRY_FRICTION_US2 = 5, /* slipping friction force on the second mass, nondimensional; 0 < us2 */
    DRY_FRICTION_UR2 = 6, /* static friction force on the second mass, nondimensional; 0 < ur2 */
    DRY_FRICTION_PARAMETERS = 7 /* how many */
};

enum { /* state of the system */
    DRY_FRICTION_X1 = 0,
    DRY_FRICTION_X2 = 1,
    DRY_FRICTION_V1 = 2,
    DRY_FRICTION_V2 = 3,
    DRY_FRICTION_STATES = 4 /* how many */
};

enum { /* status of a point that ..._solve gives */
    DRY_FRICTION_CONVERGED = 0, /* a solution: ask ..._admissible whether it is a motion */
    DRY_FRICTION_NOT_CONVERGED = 1, /* 32 steps were not enough: guess nearer */
    DRY_FRICTION_NOT_FINITE = 2, /* no numbers: mind the domains, guess nearer */
    DRY_FRICTION_NOT_POSITIVE = 3, /* a duration is not positive: no orbit, guess another */
    DRY_FRICTION_SINGULAR = 5 /* the start is not determined: move a parameter */
};

enum { /* boundary that ..._admissible gives where it is no row */
    DRY_FRICTION_ADMISSIBLE = -1, /* none is crossed inside a phase: a motion */
    DRY_FRICTION_NO_DURATION = -2, /* a duration is not positive */
    DRY_FRICTION_UNDECIDED = -3 /* data not finite, or too large for a guarantee */
};

/* Frequencies and projector coefficients, with their derivatives by the parameters. Its
 * `parameters` are chi, eta, in this order. Gives spectrum (7), spectrum_derivatives (7, 2). */
void dry_friction_spectrum(
    const double parameters[2], double *spectrum, double *spectrum_derivatives);
/* State after a time in slip-slip. */
void dry_friction_flow_slip_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in slip-stick. */
void dry_friction_flow_slip_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in slip-overshoot. */
void dry_friction_flow_slip_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in stick-slip. */
void dry_friction_flow_stick_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in stick-stick. */
void dry_friction_flow_stick_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in stick-overshoot. */
void dry_friction_flow_stick_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in overshoot-slip. */
void dry_friction_flow_overshoot_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in overshoot-stick. */
void dry_friction_flow_overshoot_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in overshoot-overshoot. */
void dry_friction_flow_overshoot_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* Vector fields of the configurations, one below the other, offsets last. */
void dry_friction_fields(
    const double parameters[7], double fields[180]);
/* Affine functions of the state: gradients, constants last. */
void dry_friction_rows(
    const double parameters[7], double rows[85]);
/* Affine resets of the state, one below the other, offsets last. */
void dry_friction_resets(
    const double parameters[7], double resets[80]);
/* Exponents of the modes; coefficients of their functions, offsets last. Gives exponents (21,
 * 2), coefficients (152, 5). */
void dry_friction_modes(
    const double parameters[7], const double spectrum[7], double *exponents, double *coefficients);

/* Orbit symmetric.
 *
 *     phases          1 slip-slip for tau, until second-reaches-belt
 *                     2 slip-stick for tau1, until second-breaks-forward
 *     state           z1 = x1 - (us1 + us2)/(1 - chi), z2 = x2 - (chi*us1 + us2)/(chi*(1 - chi)),
 *                     v1, v2
 *     section         z20, v10
 *     residual        [0] z1 vanishes halfway through slip-slip
 *                     [1] z2 vanishes halfway through slip-slip
 *                     [2] z1 vanishes halfway through slip-stick
 *                     [3] z2 vanishes halfway through slip-stick
 *                     [4] second-breaks-forward ends slip-stick
 *     guess, reduced  [0] tau, [1] tau1
 *     bounds          [0] us2
 *     boundary        in phase 1: [0] first-reaches-belt, [1] second-reaches-belt
 *                     in phase 2: [2] first-reaches-belt, [3] second-breaks-forward,
 *                     [4] second-breaks-backward
 */

enum { /* parameters of this orbit */
    /* stiffness ratio k2/(k1 + k2), nondimensional; 0 < chi < 1; e.g. 0.4 */
    DRY_FRICTION_SYMMETRIC_CHI = 0,
    DRY_FRICTION_SYMMETRIC_ETA = 1, /* mass ratio m1/m2, nondimensional; 0 < eta; e.g. 4.0 */
    DRY_FRICTION_SYMMETRIC_V = 2, /* velocity of the belt, nondimensional; 0 < V; e.g. 0.6773 */
    /* excess ur2 - us2 of static over slipping friction; 0 <= e2; e.g. 0.5 */
    DRY_FRICTION_SYMMETRIC_E2 = 3,
    DRY_FRICTION_SYMMETRIC_PARAMETERS = 4 /* how many */
};

enum { /* unknowns, columns of the jacobian */
    DRY_FRICTION_SYMMETRIC_Z10 = 0, /* z1 at the start; e.g. -0.4898 */
    DRY_FRICTION_SYMMETRIC_Z20 = 1, /* z2 at the start; e.g. 0.7602 */
    DRY_FRICTION_SYMMETRIC_V10 = 2, /* v1 at the start; e.g. -0.111 */
    DRY_FRICTION_SYMMETRIC_TAU = 3, /* duration of phase 1, slip-slip; e.g. 2.651 */
    DRY_FRICTION_SYMMETRIC_TAU1 = 4, /* duration of phase 2, slip-stick; e.g. 2.245 */
    DRY_FRICTION_SYMMETRIC_UNKNOWNS = 5 /* how many */
};

/* Newton's method on the reduced equations for `count` points, each from its guess: unknowns,
 * trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold
 * columns: entry i of a point stands at [i*count + point]. Where the equations have several
 * solutions the guess decides. */
void dry_friction_symmetric_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status);
/* Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by
 * point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how much
 * the boundary's function exceeds zero, and how long after the start of the phase. `bounds` are
 * the least values of the open parameters under which it is a motion. */
void dry_friction_symmetric_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);
/* Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points.
 * Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations
 * are singular. */
void dry_friction_symmetric_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
/* Switching and periodicity equations; their derivatives by the unknowns; those by the
 * parameters, in total, through the spectrum too. Gives residual (5), jacobian (5, 5),
 * parameter_jacobian (5, 4). Takes spectrum_derivatives (7, 2) for parameter_jacobian, else
 * NULL. */
void dry_friction_symmetric_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian);
/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the
 * parameters. Gives trace, trace_gradient (9). Takes spectrum_derivatives (7, 2) for
 * trace_gradient, else NULL. */
void dry_friction_symmetric_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    const double *spectrum_derivatives, double *trace, double *trace_gradient);
/* State at the start and behind each transition. Boundaries along the phases: constant, slope,
 * cosine and sine amplitudes, one after the other; and the frequencies of each phase. Gives
 * states (3, 4), coefficients (24), frequencies (3). */
void dry_friction_symmetric_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *states,
    double *coefficients, double *frequencies);
/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the
 * other; monodromy matrix. Gives poincare_jacobian (2, 2), saltations (8, 4), monodromy (4, 4). */
void dry_friction_symmetric_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    double *poincare_jacobian, double *saltations, double *monodromy);
/* State after a time in slip-slip. */
void dry_friction_symmetric_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in slip-stick. */
void dry_friction_symmetric_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* All unknowns from the reduced ones; how singular the linear equations for them are: 0 if they
 * are; the equations for these and their derivatives. Gives unknowns (5), determinants (1),
 * reduced_residual (2), reduced_jacobian (2, 2). */
void dry_friction_symmetric_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[2], double *unknowns,
    double *determinants, double *reduced_residual, double *reduced_jacobian);

/* Orbit global-stick.
 *
 *     phases          1 stick-stick for ta, until first-breaks-forward
 *                     2 slip-stick for tau, until second-breaks-forward
 *                     3 slip-slip for tau1, until first-reaches-belt
 *                     4 stick-slip for tau2, until second-reaches-belt
 *     state           z1 = x1 - (us1 + us2)/(1 - chi), z2 = x2 - (chi*us1 + us2)/(chi*(1 - chi)),
 *                     v1, v2
 *     section         z10, z20
 *     residual        [0] first-breaks-forward ends stick-stick
 *                     [1] second-breaks-forward ends slip-stick
 *                     [2] first-reaches-belt ends slip-slip
 *                     [3] second-reaches-belt ends stick-slip
 *                     [4] z10 returns
 *                     [5] z20 returns
 *     guess, reduced  [0] tau, [1] tau1
 *     bounds          [0] us1, [1] us2
 *     boundary        in phase 1: [0] first-breaks-forward, [1] first-breaks-backward,
 *                     [2] second-breaks-forward, [3] second-breaks-backward
 *                     in phase 2: [4] first-reaches-belt, [5] second-breaks-forward,
 *                     [6] second-breaks-backward
 *                     in phase 3: [7] first-reaches-belt, [8] second-reaches-belt
 *                     in phase 4: [9] first-breaks-forward, [10] first-breaks-backward,
 *                     [11] second-reaches-belt
 */

enum { /* parameters of this orbit */
    /* stiffness ratio k2/(k1 + k2), nondimensional; 0 < chi < 1; e.g. 0.5 */
    DRY_FRICTION_GLOBAL_STICK_CHI = 0,
    DRY_FRICTION_GLOBAL_STICK_ETA = 1, /* mass ratio m1/m2, nondimensional; 0 < eta; e.g. 1.0 */
    DRY_FRICTION_GLOBAL_STICK_V = 2, /* velocity of the belt, nondimensional; 0 < V; e.g. 1.0 */
    /* excess ur1 - us1 of static over slipping friction; 0 <= e1; e.g. 3.0195 */
    DRY_FRICTION_GLOBAL_STICK_E1 = 3,
    /* excess ur2 - us2 of static over slipping friction; 0 <= e2; e.g. 0.4831 */
    DRY_FRICTION_GLOBAL_STICK_E2 = 4,
    DRY_FRICTION_GLOBAL_STICK_PARAMETERS = 5 /* how many */
};

enum { /* unknowns, columns of the jacobian */
    DRY_FRICTION_GLOBAL_STICK_Z10 = 0, /* z1 at the start; e.g. 1.1838 */
    DRY_FRICTION_GLOBAL_STICK_Z20 = 1, /* z2 at the start; e.g. -2.6715 */
    DRY_FRICTION_GLOBAL_STICK_TA = 2, /* duration of phase 1, stick-stick; e.g. 1.0 */
    DRY_FRICTION_GLOBAL_STICK_TAU = 3, /* duration of phase 2, slip-stick; e.g. 2.0 */
    DRY_FRICTION_GLOBAL_STICK_TAU1 = 4, /* duration of phase 3, slip-slip; e.g. 1.568 */
    DRY_FRICTION_GLOBAL_STICK_TAU2 = 5, /* duration of phase 4, stick-slip; e.g. 3.28 */
    DRY_FRICTION_GLOBAL_STICK_UNKNOWNS = 6 /* how many */
};

/* Newton's method on the reduced equations for `count` points, each from its guess: unknowns,
 * trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold
 * columns: entry i of a point stands at [i*count + point]. Where the equations have several
 * solutions the guess decides. */
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status);
/* Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by
 * point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how much
 * the boundary's function exceeds zero, and how long after the start of the phase. `bounds` are
 * the least values of the open parameters under which it is a motion. */
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);
/* Derivatives of the unknowns and the trace by the parameters, at solutions, for `count` points.
 * Arrays hold columns: entry i of a point stands at [i*count + point]. NaN where the equations
 * are singular. */
void dry_friction_global_stick_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
/* Switching and periodicity equations; their derivatives by the unknowns; those by the
 * parameters, in total, through the spectrum too. Gives residual (6), jacobian (6, 6),
 * parameter_jacobian (6, 5). Takes spectrum_derivatives (7, 2) for parameter_jacobian, else
 * NULL. */
void dry_friction_global_stick_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian);
/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the
 * parameters. Gives trace, trace_gradient (11). Takes spectrum_derivatives (7, 2) for
 * trace_gradient, else NULL. */
void dry_friction_global_stick_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *trace, double *trace_gradient);
/* State at the start and behind each transition. Boundaries along the phases: constant, slope,
 * cosine and sine amplitudes, one after the other; and the frequencies of each phase. Gives
 * states (5, 4), coefficients (44), frequencies (4). */
void dry_friction_global_stick_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *states,
    double *coefficients, double *frequencies);
/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the
 * other; monodromy matrix. Gives poincare_jacobian (2, 2), saltations (16, 4), monodromy (4, 4). */
void dry_friction_global_stick_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    double *poincare_jacobian, double *saltations, double *monodromy);
/* State after a time in slip-stick. */
void dry_friction_global_stick_flow_slip_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in slip-slip. */
void dry_friction_global_stick_flow_slip_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in stick-slip. */
void dry_friction_global_stick_flow_stick_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* All unknowns from the reduced ones; the equations for these and their derivatives. Gives
 * unknowns (6), reduced_residual (2), reduced_jacobian (2, 2). */
void dry_friction_global_stick_reduced(
    const double parameters[5], const double spectrum[7], const double reduced[2], double *unknowns,
    double *reduced_residual, double *reduced_jacobian);
/* Map [N, c] of a turn; the start that follows from the dwell times; compatibility and switching
 * conditions. The start among the unknowns is not read. Gives period_map (4, 5), linear_start
 * (2), compatibility (4). */
void dry_friction_global_stick_period_map(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    double *period_map, double *linear_start, double *compatibility);

/* Orbit solution-ii.
 *
 *     phases          1 stick-stick for 0, until first-breaks-forward
 *                     2 slip-stick for tau, until second-breaks-forward
 *                     3 slip-slip for tau1, until first-reaches-belt
 *                     4 stick-slip for tau2, until second-reaches-belt
 *     state           z1 = x1 - (us1 + us2)/(1 - chi), z2 = x2 - (chi*us1 + us2)/(chi*(1 - chi)),
 *                     v1, v2
 *     section         z10, z20
 *     residual        [0] first-breaks-forward ends stick-stick
 *                     [1] second-breaks-forward ends slip-stick
 *                     [2] first-reaches-belt ends slip-slip
 *                     [3] second-reaches-belt ends stick-slip
 *                     [4] z10 returns
 *                     [5] z20 returns
 *     guess, reduced  [0] tau, [1] tau1, [2] e1
 *     bounds          [0] us1, [1] us2
 *     boundary        in phase 1: [0] first-breaks-forward, [1] first-breaks-backward,
 *                     [2] second-breaks-forward, [3] second-breaks-backward
 *                     in phase 2: [4] first-reaches-belt, [5] second-breaks-forward,
 *                     [6] second-breaks-backward
 *                     in phase 3: [7] first-reaches-belt, [8] second-reaches-belt
 *                     in phase 4: [9] first-breaks-forward, [10] first-breaks-backward,
 *                     [11] second-reaches-belt
 */

enum { /* parameters of this orbit */
    /* stiffness ratio k2/(k1 + k2), nondimensional; 0 < chi < 1; e.g. 0.5 */
    DRY_FRICTION_SOLUTION_II_CHI = 0,
    DRY_FRICTION_SOLUTION_II_ETA = 1, /* mass ratio m1/m2, nondimensional; 0 < eta; e.g. 1.0 */
    DRY_FRICTION_SOLUTION_II_V = 2, /* velocity of the belt, nondimensional; 0 < V; e.g. 1.0 */
    /* excess ur2 - us2 of static over slipping friction; 0 <= e2; e.g. 0.4831 */
    DRY_FRICTION_SOLUTION_II_E2 = 3,
    DRY_FRICTION_SOLUTION_II_PARAMETERS = 4 /* how many */
};

enum { /* unknowns, columns of the jacobian */
    DRY_FRICTION_SOLUTION_II_Z10 = 0, /* z1 at the start; e.g. 2.0 */
    DRY_FRICTION_SOLUTION_II_Z20 = 1, /* z2 at the start; e.g. -3.0 */
    DRY_FRICTION_SOLUTION_II_TAU = 2, /* duration of phase 2, slip-stick; e.g. 2.0 */
    DRY_FRICTION_SOLUTION_II_TAU1 = 3, /* duration of phase 3, slip-slip; e.g. 1.568 */
    DRY_FRICTION_SOLUTION_II_TAU2 = 4, /* duration of phase 4, stick-slip; e.g. 3.28 */
    /* excess ur1 - us1 of static over slipping friction; e.g. 3.5 */
    DRY_FRICTION_SOLUTION_II_E1 = 5,
    DRY_FRICTION_SOLUTION_II_UNKNOWNS = 6 /* how many */
};

/* Newton's method on the reduced equations for `count` points, each from its guess: unknowns,
 * trace of poincare_jacobian, largest reduced residual, steps and a status of each. Arrays hold
 * columns: entry i of a point stands at [i*count + point]. Where the equations have several
 * solutions the guess decides. */
void dry_friction_solution_ii_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status);
/* Is each of `count` orbits a motion of the real system? Takes parameters and unknowns point by
 * point; gives the row of the boundary that is crossed inside a phase, or a verdict, by how much
 * the boundary's function exceeds zero, and how long after the start of the phase. `bounds` are
 * the least values of the open parameters under which it is a motion. */
void dry_friction_solution_ii_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);
/* Switching and periodicity equations; their derivatives by the unknowns; those by the
 * parameters, in total, through the spectrum too. Gives residual (6), jacobian (6, 6),
 * parameter_jacobian (6, 4). Takes spectrum_derivatives (7, 2) for parameter_jacobian, else
 * NULL. */
void dry_friction_solution_ii_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian);
/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the
 * parameters. Gives trace, trace_gradient (10). Takes spectrum_derivatives (7, 2) for
 * trace_gradient, else NULL. */
void dry_friction_solution_ii_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *trace, double *trace_gradient);
/* State at the start and behind each transition. Boundaries along the phases: constant, slope,
 * cosine and sine amplitudes, one after the other; and the frequencies of each phase. Gives
 * states (5, 4), coefficients (44), frequencies (4). */
void dry_friction_solution_ii_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *states,
    double *coefficients, double *frequencies);
/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the
 * other; monodromy matrix. Gives poincare_jacobian (2, 2), saltations (16, 4), monodromy (4, 4). */
void dry_friction_solution_ii_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    double *poincare_jacobian, double *saltations, double *monodromy);
/* State after a time in slip-stick. */
void dry_friction_solution_ii_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in slip-slip. */
void dry_friction_solution_ii_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* State after a time in stick-slip. */
void dry_friction_solution_ii_flow_stick_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4]);
/* All unknowns from the reduced ones; the equations for these and their derivatives. Gives
 * unknowns (6), reduced_residual (3), reduced_jacobian (3, 3). */
void dry_friction_solution_ii_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[3], double *unknowns,
    double *reduced_residual, double *reduced_jacobian);
/* Map [N, c] of a turn; the start that follows from the dwell times; compatibility and switching
 * conditions. The start among the unknowns is not read. Gives period_map (4, 5), linear_start
 * (2), compatibility (4). */
void dry_friction_solution_ii_period_map(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    double *period_map, double *linear_start, double *compatibility);

/* There is no dry_friction_solution_ii_directions: orbit 'solution-ii' is a border collision: it
 * has no derivatives. */

#ifdef __cplusplus
}
#endif

#endif
