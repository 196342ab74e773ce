/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 589b5b148a78a35d */
#ifndef DRY_FRICTION_H
#define DRY_FRICTION_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void dry_friction_spectrum(
    const double parameters[2], double spectrum[7], double derivatives[14]);
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
void dry_friction_global_stick_residual(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[6]);
void dry_friction_global_stick_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double jacobian[36]);
void dry_friction_global_stick_residual_and_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[6], double jacobian[36]);
void dry_friction_global_stick_parameter_jacobian(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double parameter_jacobian[30]);
void dry_friction_global_stick_poincare_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double poincare_jacobian[4]);
void dry_friction_global_stick_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *trace);
void dry_friction_global_stick_trace_gradient(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double trace_gradient[11]);
void dry_friction_global_stick_states(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double states[20]);
void dry_friction_global_stick_boundary_functions(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double coefficients[44], double frequencies[4]);
void dry_friction_global_stick_flow_stick_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_slip_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_slip_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_flow_stick_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_global_stick_reduced(
    const double parameters[5], const double spectrum[7], const double reduced[2], double residual[2], double jacobian[4]);
void dry_friction_global_stick_expand(
    const double parameters[5], const double spectrum[7], const double reduced[2], double unknowns[6]);
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant);

#ifdef __cplusplus
}
#endif

#endif
