/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation ac22722cc176f8d2 */
#ifndef ELASTIC_STOP_H
#define ELASTIC_STOP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void elastic_stop_spectrum(
    const double parameters[5], double spectrum[12], double derivatives[60]);
void elastic_stop_flow_contact(
    const double parameters[5], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_flow_free(
    const double parameters[5], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_fields(
    const double parameters[5], double fields[40]);
void elastic_stop_rows(
    const double parameters[5], double rows[25]);
void elastic_stop_resets(
    const double parameters[5], double resets[20]);
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double exponents[12], double coefficients[200]);
void elastic_stop_one_contact_residual(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double residual[4]);
void elastic_stop_one_contact_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double jacobian[16]);
void elastic_stop_one_contact_residual_and_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double residual[4], double jacobian[16]);
void elastic_stop_one_contact_parameter_jacobian(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60], const double unknowns[4], double parameter_jacobian[24]);
void elastic_stop_one_contact_poincare_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double poincare_jacobian[9]);
void elastic_stop_one_contact_saltations(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double saltations[32]);
void elastic_stop_one_contact_monodromy(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double monodromy[16]);
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *trace);
void elastic_stop_one_contact_trace_gradient(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60], const double unknowns[4], double trace_gradient[10]);
void elastic_stop_one_contact_states(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double states[12]);
void elastic_stop_one_contact_boundary_functions(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double coefficients[12], double frequencies[4]);
void elastic_stop_one_contact_flow_contact(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_one_contact_flow_free(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1], double residual[1], double jacobian[1]);
void elastic_stop_one_contact_expand(
    const double parameters[6], const double spectrum[12], const double reduced[1], double unknowns[4], double determinants[1]);
void elastic_stop_one_contact_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status);
void elastic_stop_one_contact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns,
    int32_t *boundary, double *excess, double *instant);
void elastic_stop_one_contact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions);

#ifdef __cplusplus
}
#endif

#endif
