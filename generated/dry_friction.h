/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation eea47122c16e574a */
#ifndef DRY_FRICTION_H
#define DRY_FRICTION_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void dry_friction_spectrum(
    const double parameters[2], double *spectrum, double *derivatives);
void dry_friction_flow_slip_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_slip_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_slip_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_stick_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_stick_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_stick_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_overshoot_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_overshoot_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_flow_overshoot_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_fields(
    const double parameters[7], double fields[180]);
void dry_friction_rows(
    const double parameters[7], double rows[85]);
void dry_friction_resets(
    const double parameters[7], double resets[80]);
void dry_friction_modes(
    const double parameters[7], const double spectrum[7], double *exponents, double *coefficients);
void dry_friction_symmetric_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[5], const double *spectrum_derivatives, double *residual, double *jacobian, double *parameter_jacobian);
void dry_friction_symmetric_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[5], const double *spectrum_derivatives, double *trace, double *trace_gradient);
void dry_friction_symmetric_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *states, double *coefficients, double *frequencies);
void dry_friction_symmetric_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *poincare_jacobian, double *saltations, double *monodromy);
void dry_friction_symmetric_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_symmetric_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_symmetric_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[2], double *unknowns, double *determinants, double *reduced_residual, double *reduced_jacobian);
void dry_friction_global_stick_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[6], const double *spectrum_derivatives, double *residual, double *jacobian, double *parameter_jacobian);
void dry_friction_global_stick_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[6], const double *spectrum_derivatives, double *trace, double *trace_gradient);
void dry_friction_global_stick_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *states, double *coefficients, double *frequencies);
void dry_friction_global_stick_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *poincare_jacobian, double *saltations, double *monodromy);
void dry_friction_global_stick_flow_stick_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_slip_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_slip_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_stick_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_reduced(
    const double parameters[5], const double spectrum[7], const double reduced[2], double *unknowns, double *reduced_residual, double *reduced_jacobian);
void dry_friction_solution_ii_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[6], const double *spectrum_derivatives, double *residual, double *jacobian, double *parameter_jacobian);
void dry_friction_solution_ii_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[6], const double *spectrum_derivatives, double *trace, double *trace_gradient);
void dry_friction_solution_ii_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *states, double *coefficients, double *frequencies);
void dry_friction_solution_ii_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *poincare_jacobian, double *saltations, double *monodromy);
void dry_friction_solution_ii_flow_stick_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_stick_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[3], double *unknowns, double *reduced_residual, double *reduced_jacobian);
void dry_friction_symmetric_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void dry_friction_symmetric_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);
void dry_friction_symmetric_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);
void dry_friction_global_stick_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);
void dry_friction_solution_ii_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void dry_friction_solution_ii_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);

#ifdef __cplusplus
}
#endif

#endif
