/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation e0db5a0cf84061ce */
#include "rigid_stop.h"

#include <math.h>

#include "nonsmooth_admissible.h"
#include "nonsmooth_admissible_sums.h"
#include "nonsmooth_compiler.h"
#include "nonsmooth_elimination.h"
#include "nonsmooth_lanes.h"
#include "nonsmooth_newton.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 177. Intermediate terms: 69. */
static NONSMOOTH_INLINE void rigid_stop_spectrum_in_lane(
    int lanes, int lane, const double *parameters, double *spectrum, double *spectrum_derivatives)
{
    const double m1 = parameters[lane], m2 = parameters[1*lanes + lane],
        k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane];
    /* spectrum */
    const double t0 = (1.0/(m1));
    const double t1 = k1*t0;
    const double t2 = (1.0/(m2));
    const double t3 = k1 + k2;
    const double t4 = t2*t3;
    const double t5 = t1 - t4;
    const double t6 = (k1*k1);
    const double t7 = 4*t2*t6;
    const double gap1 = sqrt(t0*t7 + (t5*t5));
    const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t1 + (1.0/2.0)*t4);
    const double t8 = (1.0/(omega1));
    const double t9 = (1.0/sqrt(m1));
    const double t10 = (1.0/sqrt(m2));
    const double t11 = sqrt(k2);
    const double t12 = sqrt(k1);
    const double t13 = t10*t11*t12;
    const double t14 = t13*t9;
    const double omega2 = t14*t8;
    const double t15 = (1.0/(gap1));
    const double t16 = (1.0/2.0)*t15;
    const double p1 = t16*t5 + 1.0/2.0;
    const double p2 = -t1*t15;
    const double t17 = t15*t2;
    const double p3 = -k1*t17;
    const double t18 = sqrt(t3);
    const double omega3 = t10*t18;
    if (spectrum) {
        spectrum[lane] = gap1;
        spectrum[1*lanes + lane] = omega1;
        spectrum[2*lanes + lane] = omega2;
        spectrum[3*lanes + lane] = p1;
        spectrum[4*lanes + lane] = p2;
        spectrum[5*lanes + lane] = p3;
        spectrum[6*lanes + lane] = omega3;
    }
    if (!spectrum_derivatives)
        return;
    /* d/dm1 of: spectrum */
    const double t19 = (1.0/(m1*m1));
    const double t20 = k1*t19;
    const double gap1_by_m1 = t16*(-t19*t7 - 2*t20*t5);
    const double t21 = (1.0/2.0)*t8;
    const double omega1_by_m1 = t21*((1.0/2.0)*gap1_by_m1 - 1.0/2.0*t20);
    const double t22 = t14/(omega1*omega1);
    const double omega2_by_m1 = -omega1_by_m1*t22 - t13*t21/(sqrt(m1)*sqrt(m1)*sqrt(m1));
    const double t23 = (1.0/(gap1*gap1));
    const double t24 = t23*t5;
    const double p1_by_m1 = -1.0/2.0*gap1_by_m1*t24 - t16*t20;
    const double t25 = gap1_by_m1*t23;
    const double p2_by_m1 = t1*t25 + t15*t20;
    const double t26 = k1*t2;
    const double p3_by_m1 = t25*t26;
    /* d/dm2 of: spectrum */
    const double t27 = (1.0/(m2*m2));
    const double gap1_by_m2 = t16*(-4*t0*t27*t6 + 2*t27*t3*t5);
    const double t28 = (1.0/2.0)*gap1_by_m2;
    const double omega1_by_m2 = t21*(-1.0/2.0*t27*t3 + t28);
    const double t29 = (1.0/(sqrt(m2)*sqrt(m2)*sqrt(m2)));
    const double omega2_by_m2 = -omega1_by_m2*t22 - t11*t12*t21*t29*t9;
    const double p1_by_m2 = (1.0/2.0)*t15*t27*t3 - t24*t28;
    const double t30 = gap1_by_m2*t23;
    const double p2_by_m2 = t1*t30;
    const double p3_by_m2 = k1*t15*t27 + t26*t30;
    const double omega3_by_m2 = -1.0/2.0*t18*t29;
    /* d/dk1 of: spectrum */
    const double gap1_by_k1 = t16*(8*t1*t2 + t5*(2*t0 - 2*t2));
    const double t31 = (1.0/2.0)*gap1_by_k1;
    const double t32 = (1.0/2.0)*t2;
    const double omega1_by_k1 = t21*((1.0/2.0)*t0 + t31 + t32);
    const double omega2_by_k1 = -omega1_by_k1*t22 + (1.0/2.0)*t10*t11*t8*t9/t12;
    const double p1_by_k1 = t16*(t0 - t2) - t24*t31;
    const double t33 = gap1_by_k1*t23;
    const double p2_by_k1 = -t0*t15 + t1*t33;
    const double p3_by_k1 = -t17 + t26*t33;
    const double omega3_by_k1 = (1.0/2.0)*t10/t18;
    /* d/dk2 of: spectrum */
    const double gap1_by_k2 = -t17*t5;
    const double t34 = (1.0/2.0)*gap1_by_k2;
    const double omega1_by_k2 = t21*(t32 + t34);
    const double omega2_by_k2 = -omega1_by_k2*t22 + (1.0/2.0)*t10*t12*t8*t9/t11;
    const double p1_by_k2 = -t15*t32 - t24*t34;
    const double t35 = gap1_by_k2*t23;
    const double p2_by_k2 = t1*t35;
    const double p3_by_k2 = t26*t35;
    if (spectrum_derivatives) {
        spectrum_derivatives[lane] = gap1_by_m1;
        spectrum_derivatives[1*lanes + lane] = gap1_by_m2;
        spectrum_derivatives[2*lanes + lane] = gap1_by_k1;
        spectrum_derivatives[3*lanes + lane] = gap1_by_k2;
        spectrum_derivatives[4*lanes + lane] = omega1_by_m1;
        spectrum_derivatives[5*lanes + lane] = omega1_by_m2;
        spectrum_derivatives[6*lanes + lane] = omega1_by_k1;
        spectrum_derivatives[7*lanes + lane] = omega1_by_k2;
        spectrum_derivatives[8*lanes + lane] = omega2_by_m1;
        spectrum_derivatives[9*lanes + lane] = omega2_by_m2;
        spectrum_derivatives[10*lanes + lane] = omega2_by_k1;
        spectrum_derivatives[11*lanes + lane] = omega2_by_k2;
        spectrum_derivatives[12*lanes + lane] = p1_by_m1;
        spectrum_derivatives[13*lanes + lane] = p1_by_m2;
        spectrum_derivatives[14*lanes + lane] = p1_by_k1;
        spectrum_derivatives[15*lanes + lane] = p1_by_k2;
        spectrum_derivatives[16*lanes + lane] = p2_by_m1;
        spectrum_derivatives[17*lanes + lane] = p2_by_m2;
        spectrum_derivatives[18*lanes + lane] = p2_by_k1;
        spectrum_derivatives[19*lanes + lane] = p2_by_k2;
        spectrum_derivatives[20*lanes + lane] = p3_by_m1;
        spectrum_derivatives[21*lanes + lane] = p3_by_m2;
        spectrum_derivatives[22*lanes + lane] = p3_by_k1;
        spectrum_derivatives[23*lanes + lane] = p3_by_k2;
        spectrum_derivatives[24*lanes + lane] = 0;
        spectrum_derivatives[25*lanes + lane] = omega3_by_m2;
        spectrum_derivatives[26*lanes + lane] = omega3_by_k1;
        spectrum_derivatives[27*lanes + lane] = omega3_by_k1;
    }
}

void rigid_stop_spectrum(
    const double parameters[4], double *spectrum, double *spectrum_derivatives)
{
    rigid_stop_spectrum_in_lane(1, 0, parameters, spectrum, spectrum_derivatives);
}

/* State after a time in free.
 * Operations: 77. Intermediate terms: 15. */
void rigid_stop_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega1*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega1;
    const double t3 = omega2*time;
    const double t4 = sin(t3);
    const double t5 = t4/omega2;
    const double t6 = 1 - p1;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p2*t7 + p2*t8;
    const double t10 = p1*t8 + t6*t7;
    const double t11 = p1*t7 + t6*t8;
    const double t12 = -p3*t7 + p3*t8;
    const double t13 = omega2*t4;
    const double t14 = omega1*t1;
    state_after[0] = t10*x1 + t9*x2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t11*x2 + t12*x1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6);
    state_after[2] = t10*v1 + t9*v2 + x1*(-p1*t14 - t13*t6) + x2*(p2*t13 - p2*t14);
    state_after[3] = t11*v2 + t12*v1 + x1*(p3*t13 - p3*t14) + x2*(-p1*t13 - t14*t6);
}

/* State after a time in contact.
 * Operations: 31. Intermediate terms: 8. */
void rigid_stop_flow_contact(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double k1 = parameters[2], k2 = parameters[3];
    const double omega3 = spectrum[6];
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = (1.0/((k1 + k2)));
    const double t1 = k1*t0;
    const double t2 = omega3*time;
    const double t3 = sin(t2);
    const double t4 = t3/omega3;
    const double t5 = cos(t2);
    const double t6 = k1*t0 - t1*t5;
    const double t7 = omega3*t3;
    state_after[0] = time*v1 + x1;
    state_after[1] = t4*v2 + t5*x2 + t6*x1 + v1*(-t1*t4 + t1*time);
    state_after[2] = v1;
    state_after[3] = t1*t7*x1 + t5*v2 + t6*v1 - t7*x2;
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Operations: 7. Intermediate terms: 4. */
void rigid_stop_fields(
    const double parameters[5], double fields[40])
{
    const double m1 = parameters[0], m2 = parameters[1], k1 = parameters[2], k2 = parameters[3];
    /* fields */
    const double t0 = k1/m1;
    const double t1 = (1.0/(m2));
    const double t2 = k1*t1;
    const double t3 = -t1*(k1 + k2);
    for (int i = 0; i < 40; ++i)
        fields[i] = 0.0;
    fields[2] = 1;
    fields[8] = 1;
    fields[10] = -t0;
    fields[11] = t0;
    fields[15] = t2;
    fields[16] = t3;
    fields[22] = 1;
    fields[28] = 1;
    fields[35] = t2;
    fields[36] = t3;
}

/* Affine functions of the state: gradients, constants last.
 * Operations: 3. Intermediate terms: 0. */
void rigid_stop_rows(
    const double parameters[5], double rows[25])
{
    const double k1 = parameters[2];
    for (int i = 0; i < 25; ++i)
        rows[i] = 0.0;
    rows[0] = 1;
    rows[4] = -1;
    rows[5] = k1;
    rows[6] = -k1;
    rows[12] = 1;
    rows[15] = -k1;
    rows[16] = k1;
}

/* Affine resets of the state, one below the other, offsets last.
 * Operations: 1. Intermediate terms: 0. */
void rigid_stop_resets(
    const double parameters[5], double resets[60])
{
    const double r = parameters[4];
    for (int i = 0; i < 60; ++i)
        resets[i] = 0.0;
    resets[0] = 1;
    resets[6] = 1;
    resets[12] = 1;
    resets[18] = 1;
    resets[20] = 1;
    resets[26] = 1;
    resets[32] = -r;
    resets[38] = 1;
    resets[44] = 1;
    resets[46] = 1;
    resets[58] = 1;
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Operations: 40. Intermediate terms: 5. */
void rigid_stop_modes(
    const double parameters[5], const double spectrum[7], double *exponents, double *coefficients)
{
    const double k1 = parameters[2], k2 = parameters[3];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    if (exponents) {
        for (int i = 0; i < 10; ++i)
            exponents[i] = 0.0;
        exponents[3] = omega1;
        exponents[5] = omega2;
        exponents[9] = omega3;
    }
    if (!coefficients)
        return;
    /* coefficients */
    const double t0 = 1 - p1;
    const double t1 = (1.0/(omega1));
    const double t2 = (1.0/(omega2));
    const double t3 = k1/(k1 + k2);
    const double t4 = (1.0/(omega3));
    if (coefficients) {
        for (int i = 0; i < 180; ++i)
            coefficients[i] = 0.0;
        coefficients[20] = p1;
        coefficients[21] = p2;
        coefficients[25] = p3;
        coefficients[26] = t0;
        coefficients[32] = p1;
        coefficients[33] = p2;
        coefficients[37] = p3;
        coefficients[38] = t0;
        coefficients[42] = p1*t1;
        coefficients[43] = p2*t1;
        coefficients[47] = p3*t1;
        coefficients[48] = t0*t1;
        coefficients[50] = -omega1*p1;
        coefficients[51] = -omega1*p2;
        coefficients[55] = -omega1*p3;
        coefficients[56] = -omega1*t0;
        coefficients[60] = t0;
        coefficients[61] = -p2;
        coefficients[65] = -p3;
        coefficients[66] = p1;
        coefficients[72] = t0;
        coefficients[73] = -p2;
        coefficients[77] = -p3;
        coefficients[78] = p1;
        coefficients[82] = t0*t2;
        coefficients[83] = -p2*t2;
        coefficients[87] = -p3*t2;
        coefficients[88] = p1*t2;
        coefficients[90] = -omega2*t0;
        coefficients[91] = omega2*p2;
        coefficients[95] = omega2*p3;
        coefficients[96] = -omega2*p1;
        coefficients[100] = 1;
        coefficients[105] = t3;
        coefficients[112] = 1;
        coefficients[117] = t3;
        coefficients[122] = 1;
        coefficients[127] = t3;
        coefficients[145] = -t3;
        coefficients[146] = 1;
        coefficients[157] = -t3;
        coefficients[158] = 1;
        coefficients[167] = -t3*t4;
        coefficients[168] = t4;
        coefficients[175] = omega3*t3;
        coefficients[176] = -omega3;
    }
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 239. Intermediate terms: 62. */
static NONSMOOTH_INLINE void rigid_stop_one_impact_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double T = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    const double y = unknowns[lane], u = unknowns[1*lanes + lane];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_T = wave_0.cosine;
    const double sin_omega1_half_T = wave_0.sine;
    const double t1 = half_T*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_T = wave_1.cosine;
    const double sin_omega2_half_T = wave_1.sine;
    /* residual */
    const double t2 = cos_omega1_half_T*p1;
    const double t3 = p2*y;
    const double t4 = p1 - 1;
    const double t5 = t3 + t4;
    const double t6 = omega2*sin_omega2_half_T;
    const double t7 = cos_omega2_half_T*t4;
    const double t8 = p1 + t3;
    const double t9 = omega1*sin_omega1_half_T;
    const double t10 = cos_omega1_half_T*p3;
    const double t11 = -p1*y + p3;
    const double t12 = -t11 - y;
    const double t13 = cos_omega2_half_T*p3;
    if (residual) {
        residual[lane] = t2*u + t5*t6 - t7*u - t8*t9;
        residual[1*lanes + lane] = t10*u + t11*t6 + t12*t9 - t13*u;
    }
    if (!jacobian && !parameter_jacobian)
        return;
    if (jacobian) {
        jacobian[lane] = p2*t6 - p2*t9;
        jacobian[1*lanes + lane] = t2 - t7;
        jacobian[2*lanes + lane] = omega1*sin_omega1_half_T*t4 - p1*t6;
        jacobian[3*lanes + lane] = t10 - t13;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_m1 = spectrum_derivatives[4*lanes + lane],
        omega1_by_m2 = spectrum_derivatives[5*lanes + lane],
        omega1_by_k1 = spectrum_derivatives[6*lanes + lane],
        omega1_by_k2 = spectrum_derivatives[7*lanes + lane],
        omega2_by_m1 = spectrum_derivatives[8*lanes + lane],
        omega2_by_m2 = spectrum_derivatives[9*lanes + lane],
        omega2_by_k1 = spectrum_derivatives[10*lanes + lane],
        omega2_by_k2 = spectrum_derivatives[11*lanes + lane],
        p1_by_m1 = spectrum_derivatives[12*lanes + lane],
        p1_by_m2 = spectrum_derivatives[13*lanes + lane],
        p1_by_k1 = spectrum_derivatives[14*lanes + lane],
        p1_by_k2 = spectrum_derivatives[15*lanes + lane],
        p2_by_m1 = spectrum_derivatives[16*lanes + lane],
        p2_by_m2 = spectrum_derivatives[17*lanes + lane],
        p2_by_k1 = spectrum_derivatives[18*lanes + lane],
        p2_by_k2 = spectrum_derivatives[19*lanes + lane],
        p3_by_m1 = spectrum_derivatives[20*lanes + lane],
        p3_by_m2 = spectrum_derivatives[21*lanes + lane],
        p3_by_k1 = spectrum_derivatives[22*lanes + lane],
        p3_by_k2 = spectrum_derivatives[23*lanes + lane];
    /* d/dm1 of: functions of half_T in free */
    const double t14 = half_T*omega1_by_m1;
    const double cos_omega1_half_T_by_m1 = -sin_omega1_half_T*t14;
    const double sin_omega1_half_T_by_m1 = cos_omega1_half_T*t14;
    const double t15 = half_T*omega2_by_m1;
    const double cos_omega2_half_T_by_m1 = -sin_omega2_half_T*t15;
    const double sin_omega2_half_T_by_m1 = cos_omega2_half_T*t15;
    /* d/dm2 of: functions of half_T in free */
    const double t16 = half_T*omega1_by_m2;
    const double cos_omega1_half_T_by_m2 = -sin_omega1_half_T*t16;
    const double sin_omega1_half_T_by_m2 = cos_omega1_half_T*t16;
    const double t17 = half_T*omega2_by_m2;
    const double cos_omega2_half_T_by_m2 = -sin_omega2_half_T*t17;
    const double sin_omega2_half_T_by_m2 = cos_omega2_half_T*t17;
    /* d/dk1 of: functions of half_T in free */
    const double t18 = half_T*omega1_by_k1;
    const double cos_omega1_half_T_by_k1 = -sin_omega1_half_T*t18;
    const double sin_omega1_half_T_by_k1 = cos_omega1_half_T*t18;
    const double t19 = half_T*omega2_by_k1;
    const double cos_omega2_half_T_by_k1 = -sin_omega2_half_T*t19;
    const double sin_omega2_half_T_by_k1 = cos_omega2_half_T*t19;
    /* d/dk2 of: functions of half_T in free */
    const double t20 = half_T*omega1_by_k2;
    const double cos_omega1_half_T_by_k2 = -sin_omega1_half_T*t20;
    const double sin_omega1_half_T_by_k2 = cos_omega1_half_T*t20;
    const double t21 = half_T*omega2_by_k2;
    const double cos_omega2_half_T_by_k2 = -sin_omega2_half_T*t21;
    const double sin_omega2_half_T_by_k2 = cos_omega2_half_T*t21;
    /* d/dT of: functions of half_T in free */
    const double t22 = (1.0/2.0)*omega1;
    const double cos_omega1_half_T_by_T = -sin_omega1_half_T*t22;
    const double sin_omega1_half_T_by_T = cos_omega1_half_T*t22;
    const double t23 = (1.0/2.0)*omega2;
    const double cos_omega2_half_T_by_T = -sin_omega2_half_T*t23;
    const double sin_omega2_half_T_by_T = cos_omega2_half_T*t23;
    /* parameter_jacobian */
    const double t24 = t6*y - t9*y;
    const double t25 = cos_omega1_half_T*u - cos_omega2_half_T*u + t6 - t9;
    const double t26 = p1*u;
    const double t27 = sin_omega2_half_T*t5;
    const double t28 = omega2*t5;
    const double t29 = t4*u;
    const double t30 = sin_omega1_half_T*t8;
    const double t31 = omega1*t8;
    const double t32 = p3*u;
    const double t33 = sin_omega1_half_T*t12;
    const double t34 = omega1*t12;
    const double t35 = -sin_omega2_half_T*t11;
    const double t36 = -omega2*t11;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = cos_omega1_half_T_by_m1*t26 - cos_omega2_half_T_by_m1*t29 - omega1_by_m1*t30 + omega2_by_m1*t27 + p1_by_m1*t25 + p2_by_m1*t24 - sin_omega1_half_T_by_m1*t31 + sin_omega2_half_T_by_m1*t28;
        parameter_jacobian[1*lanes + lane] = cos_omega1_half_T_by_m2*t26 - cos_omega2_half_T_by_m2*t29 - omega1_by_m2*t30 + omega2_by_m2*t27 + p1_by_m2*t25 + p2_by_m2*t24 - sin_omega1_half_T_by_m2*t31 + sin_omega2_half_T_by_m2*t28;
        parameter_jacobian[2*lanes + lane] = cos_omega1_half_T_by_k1*t26 - cos_omega2_half_T_by_k1*t29 - omega1_by_k1*t30 + omega2_by_k1*t27 + p1_by_k1*t25 + p2_by_k1*t24 - sin_omega1_half_T_by_k1*t31 + sin_omega2_half_T_by_k1*t28;
        parameter_jacobian[3*lanes + lane] = cos_omega1_half_T_by_k2*t26 - cos_omega2_half_T_by_k2*t29 - omega1_by_k2*t30 + omega2_by_k2*t27 + p1_by_k2*t25 + p2_by_k2*t24 - sin_omega1_half_T_by_k2*t31 + sin_omega2_half_T_by_k2*t28;
        parameter_jacobian[4*lanes + lane] = cos_omega1_half_T_by_T*t26 - cos_omega2_half_T_by_T*t29 - sin_omega1_half_T_by_T*t31 + sin_omega2_half_T_by_T*t28;
        parameter_jacobian[5*lanes + lane] = cos_omega1_half_T_by_m1*t32 - cos_omega2_half_T_by_m1*t32 + omega1_by_m1*t33 - omega2_by_m1*t35 - p1_by_m1*t24 + p3_by_m1*t25 + sin_omega1_half_T_by_m1*t34 - sin_omega2_half_T_by_m1*t36;
        parameter_jacobian[6*lanes + lane] = cos_omega1_half_T_by_m2*t32 - cos_omega2_half_T_by_m2*t32 + omega1_by_m2*t33 - omega2_by_m2*t35 - p1_by_m2*t24 + p3_by_m2*t25 + sin_omega1_half_T_by_m2*t34 - sin_omega2_half_T_by_m2*t36;
        parameter_jacobian[7*lanes + lane] = cos_omega1_half_T_by_k1*t32 - cos_omega2_half_T_by_k1*t32 + omega1_by_k1*t33 - omega2_by_k1*t35 - p1_by_k1*t24 + p3_by_k1*t25 + sin_omega1_half_T_by_k1*t34 - sin_omega2_half_T_by_k1*t36;
        parameter_jacobian[8*lanes + lane] = cos_omega1_half_T_by_k2*t32 - cos_omega2_half_T_by_k2*t32 + omega1_by_k2*t33 - omega2_by_k2*t35 - p1_by_k2*t24 + p3_by_k2*t25 + sin_omega1_half_T_by_k2*t34 - sin_omega2_half_T_by_k2*t36;
        parameter_jacobian[9*lanes + lane] = cos_omega1_half_T_by_T*t32 - cos_omega2_half_T_by_T*t32 + sin_omega1_half_T_by_T*t34 - sin_omega2_half_T_by_T*t36;
    }
}

NONSMOOTH_UNMERGED
void rigid_stop_one_impact_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    rigid_stop_one_impact_equations_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, residual, jacobian, parameter_jacobian);
}

/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the parameters.
 * Operations: 367. Intermediate terms: 95. */
static NONSMOOTH_INLINE void rigid_stop_one_impact_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double m1 = parameters[lane], m2 = parameters[1*lanes + lane],
        k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane],
        T = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    const double y = unknowns[lane], u = unknowns[1*lanes + lane];
    /* functions of T in free */
    const double t0 = T*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_T = wave_0.cosine;
    const double sin_omega1_T = wave_0.sine;
    const double t1 = T*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_T = wave_1.cosine;
    const double sin_omega2_T = wave_1.sine;
    /* free for T, until first-reaches-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_T*t2;
    const double t4 = p1 - 1;
    const double t5 = (1.0/(omega2));
    const double t6 = sin_omega2_T*t5;
    const double carried_x1_1_by_u = p1*t3 - t4*t6;
    const double carried_x1_1_by_y = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double carried_v1_1_by_u = cos_omega1_T*p1 - cos_omega2_T*t4;
    const double x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_y*y;
    const double t7 = p3*t3 - p3*t6;
    const double carried_x2_1_by_y = -cos_omega1_T*t4 + cos_omega2_T*p1;
    const double t8 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = carried_x2_1_by_y*y + t7*u + t8;
    const double t9 = omega2*sin_omega2_T;
    const double t10 = omega1*sin_omega1_T;
    const double t11 = -p2*t10 + p2*t9;
    const double t12 = omega1*p1;
    const double t13 = -omega2*t4;
    const double v1_1 = carried_v1_1_by_u*u - sin_omega1_T*t12 - sin_omega2_T*t13 + t11*y;
    const double t14 = -p1*t9 + t10*t4;
    const double t15 = omega2*p3;
    const double t16 = omega1*p3;
    const double v2_1 = -sin_omega1_T*t16 + sin_omega2_T*t15 + t14*y + t8*u;
    /* Phi along T */
    const double carried_x1_1_by_w = p2*t3 - p2*t6;
    /* derivatives of the time to the boundary after T */
    const double t17 = (1.0/(v1_1));
    const double delay_T_by_y = -carried_x1_1_by_y*t17;
    const double delay_T_by_u = -carried_x1_1_by_u*t17;
    const double delay_T_by_w = -carried_x1_1_by_w*t17;
    /* perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1;
    const double t18 = (1.0/(m1));
    const double t19 = t18*x1_1;
    const double slope_by_delay_T_by_u = -k1*t18*x2_1 + k1*t19;
    const double v1_1_on_boundary_by_u = -carried_v1_1_by_u + delay_T_by_u*slope_by_delay_T_by_u;
    const double t20 = (1.0/(m2));
    const double t21 = t20*x1_1;
    const double t22 = k1 + k2;
    const double t23 = t20*x2_1;
    const double slope_by_delay_T_by_w = k1*t21 - t22*t23;
    const double v2_1_on_boundary_by_w = carried_x2_1_by_y + delay_T_by_w*slope_by_delay_T_by_w;
    if (trace) {
        trace[lane] = v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_m1 = spectrum_derivatives[4*lanes + lane],
        omega1_by_m2 = spectrum_derivatives[5*lanes + lane],
        omega1_by_k1 = spectrum_derivatives[6*lanes + lane],
        omega1_by_k2 = spectrum_derivatives[7*lanes + lane],
        omega2_by_m1 = spectrum_derivatives[8*lanes + lane],
        omega2_by_m2 = spectrum_derivatives[9*lanes + lane],
        omega2_by_k1 = spectrum_derivatives[10*lanes + lane],
        omega2_by_k2 = spectrum_derivatives[11*lanes + lane],
        p1_by_m1 = spectrum_derivatives[12*lanes + lane],
        p1_by_m2 = spectrum_derivatives[13*lanes + lane],
        p1_by_k1 = spectrum_derivatives[14*lanes + lane],
        p1_by_k2 = spectrum_derivatives[15*lanes + lane],
        p2_by_m1 = spectrum_derivatives[16*lanes + lane],
        p2_by_m2 = spectrum_derivatives[17*lanes + lane],
        p2_by_k1 = spectrum_derivatives[18*lanes + lane],
        p2_by_k2 = spectrum_derivatives[19*lanes + lane],
        p3_by_m1 = spectrum_derivatives[20*lanes + lane],
        p3_by_m2 = spectrum_derivatives[21*lanes + lane],
        p3_by_k1 = spectrum_derivatives[22*lanes + lane],
        p3_by_k2 = spectrum_derivatives[23*lanes + lane];
    /* back through: Phi along T */
    const double slope_by_carried_x1_1_by_w = -slope_by_delay_T_by_w*t17;
    const double slope_by_carried_x1_1_by_u = -slope_by_delay_T_by_u*t17;
    const double slope_by_carried_x1_1_by_y = -t17*v2_1;
    /* back through: free for T, until first-reaches-stop */
    const double t24 = (1.0/(v1_1*v1_1));
    const double slope_by_v1_1 = carried_x1_1_by_u*slope_by_delay_T_by_u*t24 + carried_x1_1_by_w*slope_by_delay_T_by_w*t24 + carried_x1_1_by_y*t24*v2_1;
    const double t25 = delay_T_by_u*k1*t18;
    const double t26 = delay_T_by_w*t20;
    const double slope_by_x2_1 = -t22*t26 - t25;
    const double slope_by_x1_1 = k1*t26 + t25;
    /* back through: functions of T in free */
    const double t27 = p1*y;
    const double t28 = p2*y;
    const double t29 = -t4*t5;
    const double t30 = p2*slope_by_carried_x1_1_by_w;
    const double t31 = slope_by_x1_1*u;
    const double t32 = p3*u;
    const double t33 = slope_by_x2_1*t32;
    const double slope_by_sin_omega2_T = delay_T_by_y*(-omega2*t27 + t15) + slope_by_carried_x1_1_by_u*t29 + slope_by_v1_1*(omega2*t28 - t13) + t29*t31 - t30*t5 - t33*t5;
    const double t34 = 3*p1;
    const double t35 = p2*slope_by_carried_x1_1_by_y;
    const double t36 = slope_by_v1_1*u;
    const double t37 = delay_T_by_y*t32;
    const double slope_by_cos_omega2_T = slope_by_x1_1*(-t28 - t4) + slope_by_x2_1*(p1*y - p3) + t34 - t35 - t36*t4 - t37 - 1;
    const double t38 = -t4*y;
    const double t39 = p1*t2;
    const double slope_by_sin_omega1_T = delay_T_by_y*(-omega1*t38 - t16) + slope_by_carried_x1_1_by_u*t39 + slope_by_v1_1*(-omega1*t28 - t12) + t2*t30 + t2*t33 + t31*t39;
    const double slope_by_cos_omega1_T = p1*t36 + slope_by_x1_1*(p1 + t28) + slope_by_x2_1*(p3 + t38) - t34 + t35 + t37 + 2;
    /* trace_gradient */
    const double t40 = cos_omega1_T - cos_omega2_T;
    const double t41 = -t10 + t9;
    const double t42 = t40*u + t41;
    const double t43 = t3 - t6;
    const double t44 = t40 + t43*u;
    const double t45 = delay_T_by_y*t42 + slope_by_x2_1*t44;
    const double t46 = slope_by_carried_x1_1_by_w*t43 + slope_by_carried_x1_1_by_y*t40 + slope_by_v1_1*t41*y + slope_by_x1_1*t40*y;
    const double t47 = -3*cos_omega1_T + 3*cos_omega2_T - delay_T_by_y*t41*y + slope_by_carried_x1_1_by_u*t43 + slope_by_v1_1*t42 + slope_by_x1_1*t44 - slope_by_x2_1*t40*y;
    const double t48 = p3*sin_omega2_T;
    const double t49 = -sin_omega2_T*t4;
    const double t50 = cos_omega2_T*slope_by_sin_omega2_T;
    const double t51 = sin_omega2_T*slope_by_cos_omega2_T;
    const double t52 = (1.0/(omega2*omega2));
    const double t53 = t49*t52;
    const double t54 = slope_by_x2_1*u;
    const double t55 = T*t50 - T*t51 + delay_T_by_y*(-sin_omega2_T*t27 + t48) + sin_omega2_T*t30*t52 - slope_by_carried_x1_1_by_u*t53 + slope_by_v1_1*(sin_omega2_T*t28 - t49) - t31*t53 + t48*t52*t54;
    const double t56 = p3*sin_omega1_T;
    const double t57 = p1*sin_omega1_T;
    const double t58 = sin_omega1_T*slope_by_cos_omega1_T;
    const double t59 = (1.0/(omega1*omega1));
    const double t60 = t57*t59;
    const double t61 = T*cos_omega1_T*slope_by_sin_omega1_T - T*t58 + delay_T_by_y*(-sin_omega1_T*t38 - t56) - sin_omega1_T*t30*t59 - slope_by_carried_x1_1_by_u*t60 + slope_by_v1_1*(-sin_omega1_T*t28 - t57) - t31*t60 - t54*t56*t59;
    const double t62 = k1/(m1*m1);
    const double t63 = (1.0/(m2*m2));
    if (trace_gradient) {
        trace_gradient[lane] = carried_x1_1_by_y*slope_by_x1_1 + carried_x2_1_by_y*slope_by_x2_1 + delay_T_by_y*t14 + slope_by_v1_1*t11;
        trace_gradient[1*lanes + lane] = carried_v1_1_by_u*slope_by_v1_1 + carried_x1_1_by_u*slope_by_x1_1 + delay_T_by_y*t8 + slope_by_x2_1*t7;
        trace_gradient[2*lanes + lane] = -delay_T_by_u*(t62*x1_1 - t62*x2_1) + omega1_by_m1*t61 + omega2_by_m1*t55 + p1_by_m1*t47 + p2_by_m1*t46 + p3_by_m1*t45;
        trace_gradient[3*lanes + lane] = delay_T_by_w*(-k1*t63*x1_1 + t22*t63*x2_1) + omega1_by_m2*t61 + omega2_by_m2*t55 + p1_by_m2*t47 + p2_by_m2*t46 + p3_by_m2*t45;
        trace_gradient[4*lanes + lane] = -delay_T_by_u*(t18*x2_1 - t19) + delay_T_by_w*(t21 - t23) + omega1_by_k1*t61 + omega2_by_k1*t55 + p1_by_k1*t47 + p2_by_k1*t46 + p3_by_k1*t45;
        trace_gradient[5*lanes + lane] = -delay_T_by_w*t23 + omega1_by_k2*t61 + omega2_by_k2*t55 + p1_by_k2*t47 + p2_by_k2*t46 + p3_by_k2*t45;
        trace_gradient[6*lanes + lane] = cos_omega1_T*omega1*slope_by_sin_omega1_T - omega1*t58 + omega2*t50 - omega2*t51;
    }
}

NONSMOOTH_UNMERGED
void rigid_stop_one_impact_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    rigid_stop_one_impact_trace_in_lane(1, 0, parameters, spectrum, unknowns, spectrum_derivatives,
        trace, trace_gradient);
}

/* State at the start and behind each transition. Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after the other; and the frequencies of each phase.
 * Operations: 70. Intermediate terms: 21. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *states,
    double *coefficients, double *frequencies)
{
    const double T = parameters[4];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double y = unknowns[0], u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t1 = T*omega2;
    const double cos_omega2_T = cos(t1);
    const double sin_omega2_T = sin(t1);
    /* free for T, until first-reaches-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_T*t2;
    const double t4 = p1 - 1;
    const double t5 = (1.0/(omega2));
    const double t6 = sin_omega2_T*t5;
    const double t7 = cos_omega1_T*p1 - cos_omega2_T*t4;
    const double x1_1 = t7 + u*(p1*t3 - t4*t6) + y*(cos_omega1_T*p2 - cos_omega2_T*p2);
    const double t8 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t8 + u*(p3*t3 - p3*t6) + y*(-cos_omega1_T*t4 + cos_omega2_T*p1);
    const double t9 = omega2*sin_omega2_T;
    const double t10 = omega1*sin_omega1_T;
    const double v1_1 = -p1*t10 + t4*t9 + t7*u + y*(-p2*t10 + p2*t9);
    const double v2_1 = -p3*t10 + p3*t9 + t8*u + y*(-p1*t9 + t10*t4);
    /* transition to free */
    const double v1_1_reset = -v1_1;
    if (states) {
        states[0] = 1;
        states[1] = y;
        states[2] = u;
        states[3] = 0;
        states[4] = x1_1;
        states[5] = x2_1;
        states[6] = v1_1_reset;
        states[7] = v2_1;
    }
    if (!coefficients && !frequencies)
        return;
    /* coefficients */
    const double t11 = p2*y;
    if (coefficients) {
        coefficients[0] = -1;
        coefficients[1] = 0;
        coefficients[2] = p1 + t11;
        coefficients[3] = -t11 - t4;
        coefficients[4] = p1*t2*u;
        coefficients[5] = -t4*t5*u;
    }
    if (!frequencies)
        return;
    if (frequencies) {
        frequencies[0] = omega1;
        frequencies[1] = omega2;
    }
}

/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the other; monodromy matrix.
 * Operations: 137. Intermediate terms: 61. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double *poincare_jacobian, double *saltations, double *monodromy)
{
    const double m1 = parameters[0], m2 = parameters[1], k1 = parameters[2], k2 = parameters[3],
        T = parameters[4];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double y = unknowns[0], u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t1 = T*omega2;
    const double cos_omega2_T = cos(t1);
    const double sin_omega2_T = sin(t1);
    /* free for T, until first-reaches-stop */
    const double t2 = sin_omega1_T/omega1;
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_T/omega2;
    const double carried_x1_1_by_u = p1*t2 + t3*t4;
    const double carried_x1_1_by_y = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double carried_v1_1_by_u = cos_omega1_T*p1 + cos_omega2_T*t3;
    const double x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_y*y;
    const double carried_x2_1_by_u = p3*t2 - p3*t4;
    const double carried_x2_1_by_y = cos_omega1_T*t3 + cos_omega2_T*p1;
    const double carried_v2_1_by_u = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_y*y;
    const double t5 = omega2*sin_omega2_T;
    const double t6 = omega1*sin_omega1_T;
    const double carried_v1_1_by_y = p2*t5 - p2*t6;
    const double t7 = p1*t6 + t3*t5;
    const double v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y - t7;
    const double carried_v2_1_by_y = -p1*t5 - t3*t6;
    const double phi_1_30 = p3*t5 - p3*t6;
    const double v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + phi_1_30;
    /* Phi along T */
    const double carried_x1_1_by_w = p2*t2 - p2*t4;
    const double carried_x2_1_by_w = p1*t4 + t2*t3;
    /* derivatives of the time to the boundary after T */
    const double t8 = (1.0/(v1_1));
    const double delay_T_by_y = -carried_x1_1_by_y*t8;
    const double delay_T_by_u = -carried_x1_1_by_u*t8;
    const double delay_T_by_w = -carried_x1_1_by_w*t8;
    /* perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_T_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_T_by_w*v2_1;
    const double t9 = (1.0/(m1));
    const double before_v1_1 = -k1*t9*x1_1 + k1*t9*x2_1;
    const double v1_1_on_boundary_by_y = -before_v1_1*delay_T_by_y - carried_v1_1_by_y;
    const double v1_1_on_boundary_by_u = -before_v1_1*delay_T_by_u - carried_v1_1_by_u;
    const double v1_1_on_boundary_by_w = -before_v1_1*delay_T_by_w - carried_x1_1_by_y;
    const double t10 = (1.0/(m2));
    const double before_v2_1 = k1*t10*x1_1 - t10*x2_1*(k1 + k2);
    const double v2_1_on_boundary_by_y = before_v2_1*delay_T_by_y + carried_v2_1_by_y;
    const double v2_1_on_boundary_by_u = before_v2_1*delay_T_by_u + carried_v2_1_by_u;
    const double v2_1_on_boundary_by_w = before_v2_1*delay_T_by_w + carried_x2_1_by_y;
    if (poincare_jacobian) {
        poincare_jacobian[0] = x2_1_on_boundary_by_y;
        poincare_jacobian[1] = x2_1_on_boundary_by_u;
        poincare_jacobian[2] = x2_1_on_boundary_by_w;
        poincare_jacobian[3] = v1_1_on_boundary_by_y;
        poincare_jacobian[4] = v1_1_on_boundary_by_u;
        poincare_jacobian[5] = v1_1_on_boundary_by_w;
        poincare_jacobian[6] = v2_1_on_boundary_by_y;
        poincare_jacobian[7] = v2_1_on_boundary_by_u;
        poincare_jacobian[8] = v2_1_on_boundary_by_w;
    }
    if (!saltations && !monodromy)
        return;
    /* transition to free */
    const double v1_1_reset = -v1_1;
    /* saltations */
    const double t11 = t8*(-v1_1 + v1_1_reset) + 1;
    const double t12 = 2*before_v1_1;
    const double t13 = 0;
    if (saltations) {
        for (int i = 0; i < 16; ++i)
            saltations[i] = 0.0;
        saltations[0] = t11;
        saltations[5] = 1;
        saltations[8] = t12*t8;
        saltations[10] = -1;
        saltations[12] = t13;
        saltations[15] = 1;
    }
    if (!monodromy)
        return;
    /* Phi of phase 1 */
    const double phi_1_20 = -t7;
    /* saltation of phase 1 */
    const double saltation_1_00 = carried_v1_1_by_u*t11;
    const double saltation_1_01 = carried_x1_1_by_y*t11;
    const double saltation_1_02 = carried_x1_1_by_u*t11;
    const double saltation_1_03 = carried_x1_1_by_w*t11;
    const double saltation_1_20 = carried_v1_1_by_u*t12*t8 - phi_1_20;
    const double saltation_1_21 = -carried_v1_1_by_y + carried_x1_1_by_y*t12*t8;
    const double saltation_1_22 = -carried_v1_1_by_u + carried_x1_1_by_u*t12*t8;
    const double saltation_1_23 = carried_x1_1_by_w*t12*t8 - carried_x1_1_by_y;
    const double saltation_1_30 = carried_v1_1_by_u*t13 + phi_1_30;
    const double saltation_1_31 = carried_v2_1_by_y + carried_x1_1_by_y*t13;
    const double saltation_1_32 = carried_v2_1_by_u + carried_x1_1_by_u*t13;
    const double saltation_1_33 = carried_x1_1_by_w*t13 + carried_x2_1_by_y;
    if (monodromy) {
        monodromy[0] = saltation_1_00;
        monodromy[1] = saltation_1_01;
        monodromy[2] = saltation_1_02;
        monodromy[3] = saltation_1_03;
        monodromy[4] = carried_v2_1_by_u;
        monodromy[5] = carried_x2_1_by_y;
        monodromy[6] = carried_x2_1_by_u;
        monodromy[7] = carried_x2_1_by_w;
        monodromy[8] = saltation_1_20;
        monodromy[9] = saltation_1_21;
        monodromy[10] = saltation_1_22;
        monodromy[11] = saltation_1_23;
        monodromy[12] = saltation_1_30;
        monodromy[13] = saltation_1_31;
        monodromy[14] = saltation_1_32;
        monodromy[15] = saltation_1_33;
    }
}

/* All unknowns; how singular the linear equations for them are: 0 if they are.
 * Operations: 77. Intermediate terms: 28. */
static NONSMOOTH_INLINE void rigid_stop_one_impact_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *unknowns,
    double *determinants)
{
    const double T = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_T = wave_0.cosine;
    const double sin_omega1_half_T = wave_0.sine;
    const double t1 = half_T*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_T = wave_1.cosine;
    const double sin_omega2_half_T = wave_1.sine;
    /* coefficients of the linear equations */
    const double t2 = omega2*sin_omega2_half_T;
    const double t3 = omega1*sin_omega1_half_T;
    const double coefficient11 = p2*t2 - p2*t3;
    const double t4 = p1 - 1;
    const double coefficient12 = cos_omega1_half_T*p1 - cos_omega2_half_T*t4;
    const double coefficient21 = omega1*sin_omega1_half_T*t4 - p1*t2;
    const double coefficient22 = cos_omega1_half_T*p3 - cos_omega2_half_T*p3;
    /* right-hand sides of the linear equations */
    const double right1 = p1*t3 - t2*t4;
    const double right2 = omega1*p3*sin_omega1_half_T - p3*t2;
    /* determinant of the linear equations */
    const double determinant = coefficient11*coefficient22 - coefficient12*coefficient21;
    /* numerators of Cramer's rule */
    const double numerator1 = -coefficient12*right2 + coefficient22*right1;
    const double numerator2 = coefficient11*right2 - coefficient21*right1;
    /* y, u by Cramer's rule */
    const double t5 = (1.0/(determinant));
    const double y = numerator1*t5;
    const double u = numerator2*t5;
    if (unknowns) {
        unknowns[lane] = y;
        unknowns[1*lanes + lane] = u;
    }
    if (!determinants)
        return;
    /* determinants */
    const double t6 = (p1*p1);
    const double t7 = (half_T*half_T);
    const double t8 = 2*t7;
    const double t9 = (omega2*omega2*omega2*omega2)*t8/((omega2*omega2)*t7 + 1);
    const double t10 = (omega1*omega1*omega1*omega1)*t8/((omega1*omega1)*t7 + 1);
    const double t11 = (p2*p2);
    if (determinants) {
        determinants[lane] = determinant/(sqrt(2*(p3*p3) + t10*(t4*t4) + t6*t9)*sqrt(t10*t11 + t11*t9 + (t4*t4) + t6));
    }
}

NONSMOOTH_UNMERGED
void rigid_stop_one_impact_reduced(
    const double parameters[5], const double spectrum[7], double *unknowns, double *determinants)
{
    rigid_stop_one_impact_reduced_in_lane(1, 0, parameters, spectrum, unknowns, determinants);
}

/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
void rigid_stop_one_impact_solve(
    ptrdiff_t count, const double *parameters, double *unknowns, double *trace, double *residual,
    int32_t *iterations, int32_t *status)
{
    enum { lanes = 1, n = 2, p = 5, reduced = 0 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
        double determinant[1 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[4 * lanes], spectrum[7 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 3 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            rigid_stop_spectrum_in_lane(lanes, lane, own, spectrum, NULL);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            rigid_stop_one_impact_reduced_in_lane(lanes, lane, parameter, spectrum, unknown,
                determinant);
            rigid_stop_one_impact_trace_in_lane(lanes, lane, parameter, spectrum, unknown, NULL,
                slope, NULL);
        }
        nonsmooth_largest(lanes, reduced, NULL, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = RIGID_STOP_CONVERGED;
            code = ((parameter[4*lanes + lane] <= 0.0)) ? RIGID_STOP_NOT_POSITIVE : code;
            code = open[lane] != 0.0 ? RIGID_STOP_NOT_CONVERGED : code;
            code = doubt[lane] != 0.0 ? RIGID_STOP_NOT_FINITE : code;
            code = ((fabs(determinant[0*lanes + lane]) <= NONSMOOTH_SINGULAR)) ? RIGID_STOP_SINGULAR
                : code;
            ended[lane] = code;
        }
        nonsmooth_store(lanes, n, unknown, count, start, unknowns);
        nonsmooth_store(lanes, 1, slope, count, start, trace);
        nonsmooth_store(lanes, 1, largest, count, start, residual);
        for (int lane = 0; lane < here; ++lane) {
            iterations[start + lane] = taken[lane];
            status[start + lane] = ended[lane];
        }
    }
}

/* Is each of `count` orbits a motion of the real system? */
void rigid_stop_one_impact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant)
{
    static const int counts[] = {1}, at_once[] = {0}, exits[] = {0};
    static const int opened[] = {-1};
    static const int begins[] = {1};
    static const double per_unit[] = {0.0};
    static const nonsmooth_boundaries boundaries = {
        1, 0, counts, at_once, exits, opened, begins, per_unit};
    static const int terms[] = {2}, first[] = {0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 5 * point, *const u = unknowns + 2 * point;
        const double q[4] = {p[0], p[1], p[2], p[3]};
        const double durations[] = {p[4]};
        const double measures[] = {u[0], u[1]};
        double spectral[7], work[4], rows[6], frequencies[2];
        rigid_stop_spectrum(q, spectral, NULL);
        rigid_stop_one_impact_passage(p, spectral, u, NULL, rows, frequencies);
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, 2, measures, work, NULL);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}

/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. */
NONSMOOTH_MULTIVERSION
void rigid_stop_one_impact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = NONSMOOTH_LANES, n = 2, p = 5 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        double parameter[p * lanes], unknown[n * lanes];
        double jacobian[n * n * lanes], moved[n * p * lanes], slope[(n + p) * lanes];
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        nonsmooth_load(lanes, n, unknowns, count, start, unknown);
        double own[4 * lanes], spectrum[7 * lanes], spectrum_derivatives[28 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 3 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            rigid_stop_spectrum_in_lane(lanes, lane, own, spectrum, spectrum_derivatives);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            rigid_stop_one_impact_equations_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, jacobian, moved);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            rigid_stop_one_impact_trace_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, slope);
        nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
        nonsmooth_store(lanes, n * p, moved, count, start, directions);
        nonsmooth_store(lanes, p, slope + n * lanes, count, start, directions + n * p * count);
    }
}
