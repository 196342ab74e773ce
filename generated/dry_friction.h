/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 1438dbb9032bd9e6 */
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
void dry_friction_fields(
    const double parameters[7], double fields[180]);
void dry_friction_rows(
    const double parameters[7], double rows[85]);
void dry_friction_resets(
    const double parameters[7], double resets[80]);
void dry_friction_modes(
    const double parameters[7], const double spectrum[7], double exponents[42], double coefficients[760]);
void dry_friction_symmetric_residual(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double residual[5]);
void dry_friction_symmetric_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double jacobian[25]);
void dry_friction_symmetric_residual_and_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double residual[5], double jacobian[25]);
void dry_friction_symmetric_parameter_jacobian(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[5], double parameter_jacobian[20]);
void dry_friction_symmetric_poincare_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double poincare_jacobian[4]);
void dry_friction_symmetric_saltations(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double saltations[32]);
void dry_friction_symmetric_monodromy(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double monodromy[16]);
void dry_friction_symmetric_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *trace);
void dry_friction_symmetric_trace_gradient(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[5], double trace_gradient[9]);
void dry_friction_symmetric_states(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double states[12]);
void dry_friction_symmetric_boundary_functions(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double coefficients[24], double frequencies[3]);
void dry_friction_symmetric_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_symmetric_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_symmetric_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[2], double residual[2], double jacobian[4]);
void dry_friction_symmetric_expand(
    const double parameters[4], const double spectrum[7], const double reduced[2], double unknowns[5], double determinants[1]);
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
void dry_friction_global_stick_saltations(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double saltations[64]);
void dry_friction_global_stick_monodromy(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double monodromy[16]);
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
void dry_friction_global_stick_period_map(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[4], double start[2], double map[20]);
void dry_friction_solution_ii_residual(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[6]);
void dry_friction_solution_ii_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double jacobian[36]);
void dry_friction_solution_ii_residual_and_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[6], double jacobian[36]);
void dry_friction_solution_ii_parameter_jacobian(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double parameter_jacobian[24]);
void dry_friction_solution_ii_poincare_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double poincare_jacobian[4]);
void dry_friction_solution_ii_saltations(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double saltations[64]);
void dry_friction_solution_ii_monodromy(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double monodromy[16]);
void dry_friction_solution_ii_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *trace);
void dry_friction_solution_ii_trace_gradient(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double trace_gradient[10]);
void dry_friction_solution_ii_states(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double states[20]);
void dry_friction_solution_ii_boundary_functions(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double coefficients[44], double frequencies[4]);
void dry_friction_solution_ii_flow_stick_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_flow_stick_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4]);
void dry_friction_solution_ii_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[3], double residual[3], double jacobian[9]);
void dry_friction_solution_ii_expand(
    const double parameters[4], const double spectrum[7], const double reduced[3], double unknowns[6]);
void dry_friction_solution_ii_period_map(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[4], double start[2], double map[20]);
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
