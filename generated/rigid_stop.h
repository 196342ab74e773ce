/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 76fb1bebde21ace6 */
#ifndef RIGID_STOP_H
#define RIGID_STOP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void rigid_stop_spectrum(
    const double parameters[4], double spectrum[7], double derivatives[28]);
void rigid_stop_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void rigid_stop_flow_contact(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void rigid_stop_fields(
    const double parameters[5], double fields[40]);
void rigid_stop_rows(
    const double parameters[5], double rows[25]);
void rigid_stop_resets(
    const double parameters[5], double resets[60]);
void rigid_stop_modes(
    const double parameters[5], const double spectrum[7], double exponents[10], double coefficients[180]);
void rigid_stop_one_impact_residual(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double residual[2]);
void rigid_stop_one_impact_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double jacobian[4]);
void rigid_stop_one_impact_residual_and_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double residual[2], double jacobian[4]);
void rigid_stop_one_impact_parameter_jacobian(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[28], const double unknowns[2], double parameter_jacobian[10]);
void rigid_stop_one_impact_poincare_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double poincare_jacobian[9]);
void rigid_stop_one_impact_saltations(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double saltations[16]);
void rigid_stop_one_impact_monodromy(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double monodromy[16]);
void rigid_stop_one_impact_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *trace);
void rigid_stop_one_impact_trace_gradient(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[28], const double unknowns[2], double trace_gradient[7]);
void rigid_stop_one_impact_states(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double states[8]);
void rigid_stop_one_impact_boundary_functions(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double coefficients[6], double frequencies[2]);
void rigid_stop_one_impact_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void rigid_stop_one_impact_expand(
    const double parameters[5], const double spectrum[7], double unknowns[2], double determinants[1]);
void rigid_stop_one_impact_solve(
    ptrdiff_t count, const double *parameters, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void rigid_stop_one_impact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns,
    int32_t *boundary, double *excess, double *instant);
void rigid_stop_one_impact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);

#ifdef __cplusplus
}
#endif

#endif
