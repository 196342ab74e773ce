/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 3d278f1eb7b963cc */
#ifndef RIGID_STOP_H
#define RIGID_STOP_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void rigid_stop_spectrum(
    const double parameters[4], double *spectrum, double *derivatives);
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
    const double parameters[5], const double spectrum[7], double *exponents, double *coefficients);
void rigid_stop_one_impact_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[2], const double *spectrum_derivatives, double *residual, double *jacobian, double *parameter_jacobian);
void rigid_stop_one_impact_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[2], const double *spectrum_derivatives, double *trace, double *trace_gradient);
void rigid_stop_one_impact_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *states, double *coefficients, double *frequencies);
void rigid_stop_one_impact_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *poincare_jacobian, double *saltations, double *monodromy);
void rigid_stop_one_impact_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4]);
void rigid_stop_one_impact_reduced(
    const double parameters[5], const double spectrum[7], double *unknowns, double *determinants);
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
