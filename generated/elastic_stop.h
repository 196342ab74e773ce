/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 6ce0fc264bd74082 */
#ifndef ELASTIC_STOP_H
#define ELASTIC_STOP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void elastic_stop_spectrum(
    const double parameters[5], double *spectrum, double *derivatives);
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
    const double parameters[5], const double spectrum[12], double *exponents, double *coefficients);
void elastic_stop_one_contact_equations(
    const double parameters[6], const double spectrum[12], const double unknowns[4], const double *spectrum_derivatives, double *residual, double *jacobian, double *parameter_jacobian);
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4], const double *spectrum_derivatives, double *trace, double *trace_gradient);
void elastic_stop_one_contact_passage(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *states, double *coefficients, double *frequencies);
void elastic_stop_one_contact_linearisation(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *poincare_jacobian, double *saltations, double *monodromy);
void elastic_stop_one_contact_flow_contact(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_one_contact_flow_free(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4]);
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1], double *unknowns, double *determinants, double *reduced_residual, double *reduced_jacobian);
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
