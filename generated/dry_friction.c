/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation a9cad82ee1ca7804 */
#include "dry_friction.h"

#include <math.h>

#include "nonsmooth_admissible.h"
#include "nonsmooth_admissible_sums.h"
#include "nonsmooth_compiler.h"
#include "nonsmooth_elimination.h"
#include "nonsmooth_lanes.h"
#include "nonsmooth_newton.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 97. Intermediate terms: 44. */
static NONSMOOTH_INLINE void dry_friction_spectrum_in_lane(
    int lanes, int lane, const double *parameters, double *spectrum, double *spectrum_derivatives)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane];
    /* spectrum */
    const double t0 = chi*eta;
    const double t1 = 1 - t0;
    const double t2 = 4*(chi*chi);
    const double gap1 = sqrt(eta*t2 + (t1*t1));
    const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t0 + 1.0/2.0);
    const double t3 = (1.0/(omega1));
    const double t4 = sqrt(1 - chi);
    const double t5 = sqrt(eta);
    const double t6 = sqrt(chi);
    const double omega3 = t5*t6;
    const double t7 = omega3*t4;
    const double omega2 = t3*t7;
    const double t8 = (1.0/(gap1));
    const double t9 = (1.0/2.0)*t8;
    const double p1 = t1*t9 + 1.0/2.0;
    const double t10 = chi*t8;
    const double p2 = -t10;
    const double p3 = -t0*t8;
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
    /* d/dchi of: spectrum */
    const double t11 = 2*t1;
    const double gap1_by_chi = t9*(-eta*t11 + 8*t0);
    const double t12 = (1.0/2.0)*gap1_by_chi;
    const double t13 = (1.0/2.0)*eta;
    const double t14 = (1.0/2.0)*t3;
    const double omega1_by_chi = t14*(t12 + t13);
    const double t15 = (1.0/(t6));
    const double t16 = t7/(omega1*omega1);
    const double omega2_by_chi = -omega1_by_chi*t16 - omega3*t14/t4 + (1.0/2.0)*t15*t3*t4*t5;
    const double t17 = (1.0/(gap1*gap1));
    const double t18 = t1*t17;
    const double p1_by_chi = -t12*t18 - t13*t8;
    const double t19 = chi*t17;
    const double p2_by_chi = gap1_by_chi*t19 - t8;
    const double t20 = t0*t17;
    const double p3_by_chi = -eta*t8 + gap1_by_chi*t20;
    const double omega3_by_chi = (1.0/2.0)*t15*t5;
    /* d/deta of: spectrum */
    const double gap1_by_eta = t9*(-chi*t11 + t2);
    const double t21 = (1.0/2.0)*gap1_by_eta;
    const double omega1_by_eta = t14*((1.0/2.0)*chi + t21);
    const double t22 = (1.0/(t5));
    const double omega2_by_eta = -omega1_by_eta*t16 + (1.0/2.0)*t22*t3*t4*t6;
    const double p1_by_eta = -1.0/2.0*t10 - t18*t21;
    const double p2_by_eta = gap1_by_eta*t19;
    const double p3_by_eta = gap1_by_eta*t20 - t10;
    const double omega3_by_eta = (1.0/2.0)*t22*t6;
    if (spectrum_derivatives) {
        spectrum_derivatives[lane] = gap1_by_chi;
        spectrum_derivatives[1*lanes + lane] = gap1_by_eta;
        spectrum_derivatives[2*lanes + lane] = omega1_by_chi;
        spectrum_derivatives[3*lanes + lane] = omega1_by_eta;
        spectrum_derivatives[4*lanes + lane] = omega2_by_chi;
        spectrum_derivatives[5*lanes + lane] = omega2_by_eta;
        spectrum_derivatives[6*lanes + lane] = p1_by_chi;
        spectrum_derivatives[7*lanes + lane] = p1_by_eta;
        spectrum_derivatives[8*lanes + lane] = p2_by_chi;
        spectrum_derivatives[9*lanes + lane] = p2_by_eta;
        spectrum_derivatives[10*lanes + lane] = p3_by_chi;
        spectrum_derivatives[11*lanes + lane] = p3_by_eta;
        spectrum_derivatives[12*lanes + lane] = omega3_by_chi;
        spectrum_derivatives[13*lanes + lane] = omega3_by_eta;
    }
}

void dry_friction_spectrum(
    const double parameters[2], double *spectrum, double *spectrum_derivatives)
{
    dry_friction_spectrum_in_lane(1, 0, parameters, spectrum, spectrum_derivatives);
}

/* State after a time in slip-slip.
 * Operations: 135. Intermediate terms: 24. */
void dry_friction_flow_slip_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3], us2 = parameters[5];
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
    const double t6 = p1 - 1;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p2*t7 + p2*t8;
    const double t10 = p1*t8 - t6*t7;
    const double t11 = (1.0/((chi - 1)));
    const double t12 = -us1 - us2;
    const double t13 = t11*t12;
    const double t14 = (1.0/(((chi*chi) - chi)));
    const double t15 = -chi*us1 - us2;
    const double t16 = t14*t15;
    const double t17 = p2*t16;
    const double t18 = p1*t13;
    const double t19 = p1*t7 - t6*t8;
    const double t20 = -p3*t7 + p3*t8;
    const double t21 = p3*t13;
    const double t22 = omega2*t4;
    const double t23 = omega1*t1;
    state_after[0] = t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6);
    state_after[2] = t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23);
    state_after[3] = t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6);
}

/* State after a time in slip-stick.
 * Operations: 28. Intermediate terms: 4. */
void dry_friction_flow_slip_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3];
    (void)spectrum;
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = sin(time);
    const double t1 = chi*t0;
    const double t2 = cos(time);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 - t2*us1 + t2*x1 + t3*x2 + us1 + v2*(chi*time - t1);
    state_after[1] = time*v2 + x2;
    state_after[2] = t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-overshoot.
 * Operations: 133. Intermediate terms: 24. */
void dry_friction_flow_slip_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3], us2 = parameters[5];
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
    const double t6 = p1 - 1;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p2*t7 + p2*t8;
    const double t10 = p1*t8 - t6*t7;
    const double t11 = (1.0/((chi - 1)));
    const double t12 = -us1 + us2;
    const double t13 = t11*t12;
    const double t14 = (1.0/(((chi*chi) - chi)));
    const double t15 = -chi*us1 + us2;
    const double t16 = t14*t15;
    const double t17 = p2*t16;
    const double t18 = p1*t13;
    const double t19 = p1*t7 - t6*t8;
    const double t20 = -p3*t7 + p3*t8;
    const double t21 = p3*t13;
    const double t22 = omega2*t4;
    const double t23 = omega1*t1;
    state_after[0] = t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6);
    state_after[2] = t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23);
    state_after[3] = t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6);
}

/* State after a time in stick-slip.
 * Operations: 29. Intermediate terms: 7. */
void dry_friction_flow_stick_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us2 = parameters[5];
    const double omega3 = spectrum[6];
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega3*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = us2/chi;
    const double t6 = omega3*t1;
    state_after[0] = time*v1 + x1;
    state_after[1] = t2*v2 - t3*t5 + t3*x2 + t4*x1 + t5 + v1*(-t2 + time);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*t6 + t6*x1 - t6*x2;
}

/* State after a time in stick-stick.
 * Operations: 4. Intermediate terms: 0. */
void dry_friction_flow_stick_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    (void)spectrum;
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    state_after[0] = time*v1 + x1;
    state_after[1] = time*v2 + x2;
    state_after[2] = v1;
    state_after[3] = v2;
}

/* State after a time in stick-overshoot.
 * Operations: 29. Intermediate terms: 7. */
void dry_friction_flow_stick_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us2 = parameters[5];
    const double omega3 = spectrum[6];
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega3*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = us2/chi;
    const double t6 = omega3*t1;
    state_after[0] = time*v1 + x1;
    state_after[1] = t2*v2 + t3*t5 + t3*x2 + t4*x1 - t5 + v1*(-t2 + time);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 - t5*t6 + t6*x1 - t6*x2;
}

/* State after a time in overshoot-slip.
 * Operations: 133. Intermediate terms: 24. */
void dry_friction_flow_overshoot_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3], us2 = parameters[5];
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
    const double t6 = p1 - 1;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p2*t7 + p2*t8;
    const double t10 = p1*t8 - t6*t7;
    const double t11 = (1.0/((chi - 1)));
    const double t12 = us1 - us2;
    const double t13 = t11*t12;
    const double t14 = (1.0/(((chi*chi) - chi)));
    const double t15 = chi*us1 - us2;
    const double t16 = t14*t15;
    const double t17 = p2*t16;
    const double t18 = p1*t13;
    const double t19 = p1*t7 - t6*t8;
    const double t20 = -p3*t7 + p3*t8;
    const double t21 = p3*t13;
    const double t22 = omega2*t4;
    const double t23 = omega1*t1;
    state_after[0] = t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6);
    state_after[2] = t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23);
    state_after[3] = t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6);
}

/* State after a time in overshoot-stick.
 * Operations: 28. Intermediate terms: 4. */
void dry_friction_flow_overshoot_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3];
    (void)spectrum;
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = sin(time);
    const double t1 = chi*t0;
    const double t2 = cos(time);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*us1 + t2*x1 + t3*x2 - us1 + v2*(chi*time - t1);
    state_after[1] = time*v2 + x2;
    state_after[2] = -t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in overshoot-overshoot.
 * Operations: 133. Intermediate terms: 24. */
void dry_friction_flow_overshoot_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0], us1 = parameters[3], us2 = parameters[5];
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
    const double t6 = p1 - 1;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p2*t7 + p2*t8;
    const double t10 = p1*t8 - t6*t7;
    const double t11 = (1.0/((chi - 1)));
    const double t12 = us1 + us2;
    const double t13 = t11*t12;
    const double t14 = (1.0/(((chi*chi) - chi)));
    const double t15 = chi*us1 + us2;
    const double t16 = t14*t15;
    const double t17 = p2*t16;
    const double t18 = p1*t13;
    const double t19 = p1*t7 - t6*t8;
    const double t20 = -p3*t7 + p3*t8;
    const double t21 = p3*t13;
    const double t22 = omega2*t4;
    const double t23 = omega1*t1;
    state_after[0] = t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6);
    state_after[2] = t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23);
    state_after[3] = t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6);
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Operations: 20. Intermediate terms: 2. */
void dry_friction_fields(
    const double parameters[7], double fields[180])
{
    const double chi = parameters[0], eta = parameters[1], us1 = parameters[3], us2 = parameters[5];
    /* fields */
    const double t0 = chi*eta;
    const double t1 = eta*us2;
    for (int i = 0; i < 180; ++i)
        fields[i] = 0.0;
    fields[2] = 1;
    fields[8] = 1;
    fields[10] = -1;
    fields[11] = chi;
    fields[14] = us1;
    fields[15] = t0;
    fields[16] = -t0;
    fields[19] = t1;
    fields[22] = 1;
    fields[28] = 1;
    fields[30] = -1;
    fields[31] = chi;
    fields[34] = us1;
    fields[42] = 1;
    fields[48] = 1;
    fields[50] = -1;
    fields[51] = chi;
    fields[54] = us1;
    fields[55] = t0;
    fields[56] = -t0;
    fields[59] = -t1;
    fields[62] = 1;
    fields[68] = 1;
    fields[75] = t0;
    fields[76] = -t0;
    fields[79] = t1;
    fields[82] = 1;
    fields[88] = 1;
    fields[102] = 1;
    fields[108] = 1;
    fields[115] = t0;
    fields[116] = -t0;
    fields[119] = -t1;
    fields[122] = 1;
    fields[128] = 1;
    fields[130] = -1;
    fields[131] = chi;
    fields[134] = -us1;
    fields[135] = t0;
    fields[136] = -t0;
    fields[139] = t1;
    fields[142] = 1;
    fields[148] = 1;
    fields[150] = -1;
    fields[151] = chi;
    fields[154] = -us1;
    fields[162] = 1;
    fields[168] = 1;
    fields[170] = -1;
    fields[171] = chi;
    fields[174] = -us1;
    fields[175] = t0;
    fields[176] = -t0;
    fields[179] = -t1;
}

/* Affine functions of the state: gradients, constants last.
 * Operations: 16. Intermediate terms: 0. */
void dry_friction_rows(
    const double parameters[7], double rows[85])
{
    const double chi = parameters[0], V = parameters[2], us1 = parameters[3], ur1 = parameters[4],
        us2 = parameters[5], ur2 = parameters[6];
    for (int i = 0; i < 85; ++i)
        rows[i] = 0.0;
    rows[2] = 1;
    rows[4] = -V;
    rows[8] = 1;
    rows[9] = -V;
    rows[10] = -chi;
    rows[11] = chi;
    rows[14] = -ur2;
    rows[15] = chi;
    rows[16] = -chi;
    rows[19] = -ur2;
    rows[23] = -1;
    rows[24] = V;
    rows[25] = 1;
    rows[26] = -chi;
    rows[29] = -ur1;
    rows[30] = -1;
    rows[31] = chi;
    rows[34] = -ur1;
    rows[37] = -1;
    rows[39] = V;
    rows[44] = us1;
    rows[45] = 1;
    rows[46] = -chi;
    rows[54] = -us1;
    rows[57] = 1;
    rows[64] = V;
    rows[69] = us2;
    rows[70] = -chi;
    rows[71] = chi;
    rows[79] = -us2;
    rows[83] = 1;
}

/* Affine resets of the state, one below the other, offsets last.
 * Operations: 0. Intermediate terms: 0. */
void dry_friction_resets(
    const double parameters[7], double resets[80])
{
    const double V = parameters[2];
    for (int i = 0; i < 80; ++i)
        resets[i] = 0.0;
    resets[0] = 1;
    resets[6] = 1;
    resets[12] = 1;
    resets[18] = 1;
    resets[20] = 1;
    resets[26] = 1;
    resets[32] = 1;
    resets[39] = V;
    resets[40] = 1;
    resets[46] = 1;
    resets[54] = V;
    resets[58] = 1;
    resets[60] = 1;
    resets[66] = 1;
    resets[74] = V;
    resets[79] = V;
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Operations: 238. Intermediate terms: 45. */
void dry_friction_modes(
    const double parameters[7], const double spectrum[7], double *exponents, double *coefficients)
{
    const double chi = parameters[0], us1 = parameters[3], us2 = parameters[5];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    if (exponents) {
        for (int i = 0; i < 42; ++i)
            exponents[i] = 0.0;
        exponents[3] = omega1;
        exponents[5] = omega2;
        exponents[9] = 1;
        exponents[13] = omega1;
        exponents[15] = omega2;
        exponents[19] = omega3;
        exponents[25] = omega3;
        exponents[29] = omega1;
        exponents[31] = omega2;
        exponents[35] = 1;
        exponents[39] = omega1;
        exponents[41] = omega2;
    }
    if (!coefficients)
        return;
    /* coefficients */
    const double t0 = (1.0/((chi - 1)));
    const double t1 = us1 + us2;
    const double t2 = -t0*t1;
    const double t3 = (1.0/(((chi*chi) - chi)));
    const double t4 = chi*us1;
    const double t5 = t4 + us2;
    const double t6 = -t3*t5;
    const double t7 = p2*t6;
    const double t8 = p1 - 1;
    const double t9 = p3*t2;
    const double t10 = (1.0/(omega1));
    const double t11 = p1*t10;
    const double t12 = p2*t10;
    const double t13 = p3*t10;
    const double t14 = -t10*t8;
    const double t15 = omega1*p1;
    const double t16 = omega1*p2;
    const double t17 = omega1*p3;
    const double t18 = -omega1*t8;
    const double t19 = (1.0/(omega2));
    const double t20 = -t19*t8;
    const double t21 = -p2*t19;
    const double t22 = -p3*t19;
    const double t23 = p1*t19;
    const double t24 = omega2*t8;
    const double t25 = omega2*p2;
    const double t26 = omega2*p3;
    const double t27 = -omega2*p1;
    const double t28 = -us1 + us2;
    const double t29 = t0*t28;
    const double t30 = -t4 + us2;
    const double t31 = t3*t30;
    const double t32 = p2*t31;
    const double t33 = p3*t29;
    const double t34 = us2/chi;
    const double t35 = (1.0/(omega3));
    const double t36 = omega3*t34;
    const double t37 = -t0*t28;
    const double t38 = -t3*t30;
    const double t39 = p2*t38;
    const double t40 = p3*t37;
    const double t41 = t0*t1;
    const double t42 = t3*t5;
    const double t43 = p2*t42;
    const double t44 = p3*t41;
    if (coefficients) {
        for (int i = 0; i < 760; ++i)
            coefficients[i] = 0.0;
        coefficients[4] = t2;
        coefficients[9] = t6;
        coefficients[20] = p1;
        coefficients[21] = p2;
        coefficients[24] = -p1*t2 - t7;
        coefficients[25] = p3;
        coefficients[26] = -t8;
        coefficients[29] = -t3*t5*t8 - t9;
        coefficients[32] = p1;
        coefficients[33] = p2;
        coefficients[37] = p3;
        coefficients[38] = -t8;
        coefficients[42] = t11;
        coefficients[43] = t12;
        coefficients[47] = t13;
        coefficients[48] = t14;
        coefficients[50] = -t15;
        coefficients[51] = -t16;
        coefficients[54] = t15*t2 + t16*t6;
        coefficients[55] = -t17;
        coefficients[56] = -t18;
        coefficients[59] = t17*t2 + t18*t6;
        coefficients[60] = -t8;
        coefficients[61] = -p2;
        coefficients[64] = t2*t8 + t7;
        coefficients[65] = -p3;
        coefficients[66] = p1;
        coefficients[69] = -p1*t6 + t9;
        coefficients[72] = -t8;
        coefficients[73] = -p2;
        coefficients[77] = -p3;
        coefficients[78] = p1;
        coefficients[82] = t20;
        coefficients[83] = t21;
        coefficients[87] = t22;
        coefficients[88] = t23;
        coefficients[90] = t24;
        coefficients[91] = t25;
        coefficients[94] = omega2*t0*t1*t8 - t25*t6;
        coefficients[95] = t26;
        coefficients[96] = t27;
        coefficients[99] = -omega2*p1*t3*t5 - t2*t26;
        coefficients[101] = chi;
        coefficients[104] = us1;
        coefficients[106] = 1;
        coefficients[113] = chi;
        coefficients[118] = 1;
        coefficients[123] = chi;
        coefficients[128] = 1;
        coefficients[140] = 1;
        coefficients[141] = -chi;
        coefficients[144] = -us1;
        coefficients[152] = 1;
        coefficients[153] = -chi;
        coefficients[162] = 1;
        coefficients[163] = -chi;
        coefficients[170] = -1;
        coefficients[171] = chi;
        coefficients[174] = us1;
        coefficients[184] = t29;
        coefficients[189] = t31;
        coefficients[200] = p1;
        coefficients[201] = p2;
        coefficients[204] = -p1*t29 - t32;
        coefficients[205] = p3;
        coefficients[206] = -t8;
        coefficients[209] = t3*t30*t8 - t33;
        coefficients[212] = p1;
        coefficients[213] = p2;
        coefficients[217] = p3;
        coefficients[218] = -t8;
        coefficients[222] = t11;
        coefficients[223] = t12;
        coefficients[227] = t13;
        coefficients[228] = t14;
        coefficients[230] = -t15;
        coefficients[231] = -t16;
        coefficients[234] = t15*t29 + t16*t31;
        coefficients[235] = -t17;
        coefficients[236] = -t18;
        coefficients[239] = t17*t29 + t18*t31;
        coefficients[240] = -t8;
        coefficients[241] = -p2;
        coefficients[244] = t29*t8 + t32;
        coefficients[245] = -p3;
        coefficients[246] = p1;
        coefficients[249] = -p1*t31 + t33;
        coefficients[252] = -t8;
        coefficients[253] = -p2;
        coefficients[257] = -p3;
        coefficients[258] = p1;
        coefficients[262] = t20;
        coefficients[263] = t21;
        coefficients[267] = t22;
        coefficients[268] = t23;
        coefficients[270] = t24;
        coefficients[271] = t25;
        coefficients[274] = -omega2*t0*t28*t8 - t25*t31;
        coefficients[275] = t26;
        coefficients[276] = t27;
        coefficients[279] = omega2*p1*t3*t30 - t26*t29;
        coefficients[280] = 1;
        coefficients[285] = 1;
        coefficients[289] = t34;
        coefficients[292] = 1;
        coefficients[297] = 1;
        coefficients[302] = 1;
        coefficients[307] = 1;
        coefficients[325] = -1;
        coefficients[326] = 1;
        coefficients[329] = -t34;
        coefficients[337] = -1;
        coefficients[338] = 1;
        coefficients[347] = -t35;
        coefficients[348] = t35;
        coefficients[355] = omega3;
        coefficients[356] = -omega3;
        coefficients[359] = t36;
        coefficients[360] = 1;
        coefficients[366] = 1;
        coefficients[372] = 1;
        coefficients[378] = 1;
        coefficients[382] = 1;
        coefficients[388] = 1;
        coefficients[400] = 1;
        coefficients[405] = 1;
        coefficients[409] = -t34;
        coefficients[412] = 1;
        coefficients[417] = 1;
        coefficients[422] = 1;
        coefficients[427] = 1;
        coefficients[445] = -1;
        coefficients[446] = 1;
        coefficients[449] = t34;
        coefficients[457] = -1;
        coefficients[458] = 1;
        coefficients[467] = -t35;
        coefficients[468] = t35;
        coefficients[475] = omega3;
        coefficients[476] = -omega3;
        coefficients[479] = -t36;
        coefficients[484] = t37;
        coefficients[489] = t38;
        coefficients[500] = p1;
        coefficients[501] = p2;
        coefficients[504] = -p1*t37 - t39;
        coefficients[505] = p3;
        coefficients[506] = -t8;
        coefficients[509] = -t3*t30*t8 - t40;
        coefficients[512] = p1;
        coefficients[513] = p2;
        coefficients[517] = p3;
        coefficients[518] = -t8;
        coefficients[522] = t11;
        coefficients[523] = t12;
        coefficients[527] = t13;
        coefficients[528] = t14;
        coefficients[530] = -t15;
        coefficients[531] = -t16;
        coefficients[534] = t15*t37 + t16*t38;
        coefficients[535] = -t17;
        coefficients[536] = -t18;
        coefficients[539] = t17*t37 + t18*t38;
        coefficients[540] = -t8;
        coefficients[541] = -p2;
        coefficients[544] = t37*t8 + t39;
        coefficients[545] = -p3;
        coefficients[546] = p1;
        coefficients[549] = -p1*t38 + t40;
        coefficients[552] = -t8;
        coefficients[553] = -p2;
        coefficients[557] = -p3;
        coefficients[558] = p1;
        coefficients[562] = t20;
        coefficients[563] = t21;
        coefficients[567] = t22;
        coefficients[568] = t23;
        coefficients[570] = t24;
        coefficients[571] = t25;
        coefficients[574] = omega2*t0*t28*t8 - t25*t38;
        coefficients[575] = t26;
        coefficients[576] = t27;
        coefficients[579] = -omega2*p1*t3*t30 - t26*t37;
        coefficients[581] = chi;
        coefficients[584] = -us1;
        coefficients[586] = 1;
        coefficients[593] = chi;
        coefficients[598] = 1;
        coefficients[603] = chi;
        coefficients[608] = 1;
        coefficients[620] = 1;
        coefficients[621] = -chi;
        coefficients[624] = us1;
        coefficients[632] = 1;
        coefficients[633] = -chi;
        coefficients[642] = 1;
        coefficients[643] = -chi;
        coefficients[650] = -1;
        coefficients[651] = chi;
        coefficients[654] = -us1;
        coefficients[664] = t41;
        coefficients[669] = t42;
        coefficients[680] = p1;
        coefficients[681] = p2;
        coefficients[684] = -p1*t41 - t43;
        coefficients[685] = p3;
        coefficients[686] = -t8;
        coefficients[689] = t3*t5*t8 - t44;
        coefficients[692] = p1;
        coefficients[693] = p2;
        coefficients[697] = p3;
        coefficients[698] = -t8;
        coefficients[702] = t11;
        coefficients[703] = t12;
        coefficients[707] = t13;
        coefficients[708] = t14;
        coefficients[710] = -t15;
        coefficients[711] = -t16;
        coefficients[714] = t15*t41 + t16*t42;
        coefficients[715] = -t17;
        coefficients[716] = -t18;
        coefficients[719] = t17*t41 + t18*t42;
        coefficients[720] = -t8;
        coefficients[721] = -p2;
        coefficients[724] = t41*t8 + t43;
        coefficients[725] = -p3;
        coefficients[726] = p1;
        coefficients[729] = -p1*t42 + t44;
        coefficients[732] = -t8;
        coefficients[733] = -p2;
        coefficients[737] = -p3;
        coefficients[738] = p1;
        coefficients[742] = t20;
        coefficients[743] = t21;
        coefficients[747] = t22;
        coefficients[748] = t23;
        coefficients[750] = t24;
        coefficients[751] = t25;
        coefficients[754] = -omega2*t0*t1*t8 - t25*t42;
        coefficients[755] = t26;
        coefficients[756] = t27;
        coefficients[759] = omega2*p1*t3*t5 - t26*t41;
    }
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 235. Intermediate terms: 63. */
static NONSMOOTH_INLINE void dry_friction_symmetric_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane],
        e2 = parameters[3*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    const double z10 = unknowns[lane], z20 = unknowns[1*lanes + lane],
        v10 = unknowns[2*lanes + lane], tau = unknowns[3*lanes + lane],
        tau1 = unknowns[4*lanes + lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t1 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, half_tau1);
    const double cos_half_tau1 = wave_2.cosine;
    const double sin_half_tau1 = wave_2.sine;
    /* residual */
    const double t2 = p1*z10 + p2*z20;
    const double t3 = -t2 + z10;
    const double t4 = V*p2 + p1*v10;
    const double t5 = (1.0/(omega1));
    const double t6 = sin_omega1_half_tau*t5;
    const double t7 = t4 - v10;
    const double t8 = (1.0/(omega2));
    const double t9 = sin_omega2_half_tau*t8;
    const double t10 = -p1*z20 + p3*z10;
    const double t11 = t10 + z20;
    const double t12 = p3*v10;
    const double t13 = V*p1 - t12;
    const double t14 = V*p1 - V - t12;
    const double t15 = chi*z20;
    const double t16 = t15 - z10;
    const double t17 = V*chi;
    const double t18 = -t17 + v10;
    const double t19 = V*half_tau1 - z20;
    if (residual) {
        residual[lane] = cos_omega1_half_tau*t2 + cos_omega2_half_tau*t3 + t4*t6 - t7*t9;
        residual[1*lanes + lane] = cos_omega1_half_tau*t11 - cos_omega2_half_tau*t10 + t13*t9 - t14*t6;
        residual[2*lanes + lane] = cos_half_tau1*t16 + half_tau1*t17 + sin_half_tau1*t18 - t15;
        residual[3*lanes + lane] = t19;
        residual[4*lanes + lane] = -chi*z10 - e2 + t15;
    }
    if (!jacobian && !parameter_jacobian)
        return;
    /* d/dtau of: functions of half_tau in slip-slip */
    const double t20 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t20;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t20;
    const double t21 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t21;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t21;
    /* d/dtau1 of: functions of half_tau1 in slip-stick */
    const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
    const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
    /* jacobian */
    const double t22 = p1 - 1;
    const double t23 = sin_omega1_half_tau_by_tau*t5;
    const double t24 = sin_omega2_half_tau_by_tau*t8;
    if (jacobian) {
        jacobian[lane] = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t22;
        jacobian[1*lanes + lane] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
        jacobian[2*lanes + lane] = p1*t6 - t22*t9;
        jacobian[3*lanes + lane] = cos_omega1_half_tau_by_tau*t2 + cos_omega2_half_tau_by_tau*t3 + t23*t4 - t24*t7;
        jacobian[4*lanes + lane] = 0;
        jacobian[5*lanes + lane] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
        jacobian[6*lanes + lane] = -cos_omega1_half_tau*t22 + cos_omega2_half_tau*p1;
        jacobian[7*lanes + lane] = p3*t6 - p3*t9;
        jacobian[8*lanes + lane] = cos_omega1_half_tau_by_tau*t11 - cos_omega2_half_tau_by_tau*t10 + t13*t24 - t14*t23;
        jacobian[9*lanes + lane] = 0;
        jacobian[10*lanes + lane] = -cos_half_tau1;
        jacobian[11*lanes + lane] = chi*cos_half_tau1 - chi;
        jacobian[12*lanes + lane] = sin_half_tau1;
        jacobian[13*lanes + lane] = 0;
        jacobian[14*lanes + lane] = cos_half_tau1_by_tau1*t16 + sin_half_tau1_by_tau1*t18 + (1.0/2.0)*t17;
        jacobian[15*lanes + lane] = 0;
        jacobian[16*lanes + lane] = -1;
        jacobian[17*lanes + lane] = 0;
        jacobian[18*lanes + lane] = 0;
        jacobian[19*lanes + lane] = (1.0/2.0)*V;
        jacobian[20*lanes + lane] = -chi;
        jacobian[21*lanes + lane] = chi;
        jacobian[22*lanes + lane] = 0;
        jacobian[23*lanes + lane] = 0;
        jacobian[24*lanes + lane] = 0;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane];
    /* d/dchi of: functions of half_tau in slip-slip */
    const double t25 = half_tau*omega1_by_chi;
    const double cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t25;
    const double sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t25;
    const double t26 = half_tau*omega2_by_chi;
    const double cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t26;
    const double sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t26;
    /* d/deta of: functions of half_tau in slip-slip */
    const double t27 = half_tau*omega1_by_eta;
    const double cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t27;
    const double sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t27;
    const double t28 = half_tau*omega2_by_eta;
    const double cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t28;
    const double sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t28;
    /* parameter_jacobian */
    const double t29 = V*t6 - V*t9 + cos_omega1_half_tau*z20 - cos_omega2_half_tau*z20;
    const double t30 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 + t6*v10 - t9*v10;
    const double t31 = t4*t5;
    const double t32 = t7*t8;
    const double t33 = sin_omega2_half_tau/(omega2*omega2);
    const double t34 = t33*t7;
    const double t35 = sin_omega1_half_tau/(omega1*omega1);
    const double t36 = t35*t4;
    const double t37 = t13*t8;
    const double t38 = t14*t5;
    const double t39 = t14*t35;
    const double t40 = t13*t33;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = cos_omega1_half_tau_by_chi*t2 + cos_omega2_half_tau_by_chi*t3 - omega1_by_chi*t36 + omega2_by_chi*t34 + p1_by_chi*t30 + p2_by_chi*t29 + sin_omega1_half_tau_by_chi*t31 - sin_omega2_half_tau_by_chi*t32;
        parameter_jacobian[1*lanes + lane] = cos_omega1_half_tau_by_eta*t2 + cos_omega2_half_tau_by_eta*t3 - omega1_by_eta*t36 + omega2_by_eta*t34 + p1_by_eta*t30 + p2_by_eta*t29 + sin_omega1_half_tau_by_eta*t31 - sin_omega2_half_tau_by_eta*t32;
        parameter_jacobian[2*lanes + lane] = p2*t6 - p2*t9;
        parameter_jacobian[3*lanes + lane] = 0;
        parameter_jacobian[4*lanes + lane] = cos_omega1_half_tau_by_chi*t11 - cos_omega2_half_tau_by_chi*t10 + omega1_by_chi*t39 - omega2_by_chi*t40 - p1_by_chi*t29 + p3_by_chi*t30 - sin_omega1_half_tau_by_chi*t38 + sin_omega2_half_tau_by_chi*t37;
        parameter_jacobian[5*lanes + lane] = cos_omega1_half_tau_by_eta*t11 - cos_omega2_half_tau_by_eta*t10 + omega1_by_eta*t39 - omega2_by_eta*t40 - p1_by_eta*t29 + p3_by_eta*t30 - sin_omega1_half_tau_by_eta*t38 + sin_omega2_half_tau_by_eta*t37;
        parameter_jacobian[6*lanes + lane] = p1*t9 - t22*t6;
        parameter_jacobian[7*lanes + lane] = 0;
        parameter_jacobian[8*lanes + lane] = -V*sin_half_tau1 + cos_half_tau1*z20 + t19;
        parameter_jacobian[9*lanes + lane] = 0;
        parameter_jacobian[10*lanes + lane] = chi*half_tau1 - chi*sin_half_tau1;
        parameter_jacobian[11*lanes + lane] = 0;
        parameter_jacobian[12*lanes + lane] = 0;
        parameter_jacobian[13*lanes + lane] = 0;
        parameter_jacobian[14*lanes + lane] = half_tau1;
        parameter_jacobian[15*lanes + lane] = 0;
        parameter_jacobian[16*lanes + lane] = -z10 + z20;
        parameter_jacobian[17*lanes + lane] = 0;
        parameter_jacobian[18*lanes + lane] = 0;
        parameter_jacobian[19*lanes + lane] = -1;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_symmetric_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    dry_friction_symmetric_equations_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, residual, jacobian, parameter_jacobian);
}

/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the parameters.
 * Operations: 667. Intermediate terms: 149. */
static NONSMOOTH_INLINE void dry_friction_symmetric_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    const double z10 = unknowns[lane], z20 = unknowns[1*lanes + lane],
        v10 = unknowns[2*lanes + lane], tau = unknowns[3*lanes + lane],
        tau1 = unknowns[4*lanes + lane];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_tau = wave_0.cosine;
    const double sin_omega1_tau = wave_0.sine;
    const double t1 = omega2*tau;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_tau = wave_1.cosine;
    const double sin_omega2_tau = wave_1.sine;
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = p1 - 1;
    const double t5 = (1.0/(omega2));
    const double t6 = sin_omega2_tau*t5;
    const double carried_z1_1_by_v10 = p1*t3 - t4*t6;
    const double t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double carried_v1_1_by_v10 = cos_omega1_tau*p1 - cos_omega2_tau*t4;
    const double t8 = p2*t3 - p2*t6;
    const double z1_1 = V*t8 + carried_v1_1_by_v10*z10 + carried_z1_1_by_v10*v10 + t7*z20;
    const double carried_z2_1_by_v10 = p3*t3 - p3*t6;
    const double t9 = -cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double carried_v2_1_by_v10 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t10 = p1*t6 - t3*t4;
    const double z2_1 = V*t10 + carried_v2_1_by_v10*z10 + carried_z2_1_by_v10*v10 + t9*z20;
    const double t11 = omega2*p2;
    const double t12 = omega1*p2;
    const double t13 = sin_omega1_tau*t12;
    const double t14 = sin_omega2_tau*t11 - t13;
    const double t15 = omega1*p1;
    const double t16 = -omega2*t4;
    const double t17 = sin_omega1_tau*t15 + sin_omega2_tau*t16;
    const double v1_1 = V*t7 + carried_v1_1_by_v10*v10 + t14*z20 - t17*z10;
    const double t18 = omega2*p1;
    const double t19 = -omega1*t4;
    const double t20 = sin_omega1_tau*t19 + sin_omega2_tau*t18;
    const double t21 = omega2*p3;
    const double t22 = omega1*p3;
    const double t23 = sin_omega1_tau*t22;
    const double t24 = sin_omega2_tau*t21 - t23;
    const double v2_1 = V*t9 + carried_v2_1_by_v10*v10 - t20*z20 + t24*z10;
    /* functions of tau1 in slip-stick */
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, tau1);
    const double cos_tau1 = wave_2.cosine;
    const double sin_tau1 = wave_2.sine;
    /* slip-stick for tau1, until second-breaks-forward */
    const double t25 = -chi*cos_tau1 + chi;
    const double t26 = chi*sin_tau1;
    const double t27 = chi*tau1 - t26;
    const double z1_2 = V*t27 + cos_tau1*z1_1 + sin_tau1*v1_1 + t25*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t25 + cos_tau1*v1_1 - sin_tau1*z1_1 + t26*z2_1;
    /* Phi along tau */
    const double carried_z1_1_by_z20 = carried_v1_1_by_v10 + t7;
    const double carried_z2_1_by_z20 = carried_v2_1_by_v10 + t9;
    const double carried_v1_1_by_z20 = omega2*p2*sin_omega2_tau - t13 - t17;
    const double carried_v2_1_by_z20 = omega2*p3*sin_omega2_tau - t20 - t23;
    /* rate of the exit boundary after tau */
    const double t28 = eta*z1_1;
    const double t29 = chi*z2_1;
    const double rate_1 = chi*t28 - eta*t29;
    /* derivatives of the time to the boundary after tau */
    const double t30 = (1.0/(rate_1));
    const double delay_tau_by_z20 = -carried_v2_1_by_z20*t30;
    const double delay_tau_by_v10 = -carried_v2_1_by_v10*t30;
    /* perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
    const double t31 = t29 - z1_1;
    const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t31;
    const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t31;
    /* Phi along tau1 */
    const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t25*z2_1_on_boundary_by_z20;
    const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t25*z2_1_on_boundary_by_v10;
    const double carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t26*z2_1_on_boundary_by_v10;
    /* rate of the exit boundary after tau1 */
    const double t32 = V*chi;
    const double rate_2 = -chi*v1_2 + t32;
    /* derivatives of the time to the boundary after tau1 */
    const double t33 = (1.0/(rate_2));
    const double t34 = chi*z2_1_on_boundary_by_z20;
    const double t35 = carried_z1_2_by_z20*chi - t34;
    const double delay_tau1_by_z20 = t33*t35;
    const double t36 = chi*z2_1_on_boundary_by_v10;
    const double t37 = carried_z1_2_by_v10*chi - t36;
    const double delay_tau1_by_v10 = t33*t37;
    /* perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20;
    const double slope_by_delay_tau1_by_v10 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*slope_by_delay_tau1_by_v10;
    if (trace) {
        trace[lane] = v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane];
    /* back through: rate of the exit boundary after tau1 */
    const double t38 = (1.0/(rate_2*rate_2));
    const double slope_by_rate_2 = -V*t35*t38 - slope_by_delay_tau1_by_v10*t37*t38;
    /* back through: Phi along tau1 */
    const double t39 = slope_by_delay_tau1_by_v10*t33;
    const double slope_by_carried_z1_2_by_v10 = chi*t39;
    const double slope_by_carried_z1_2_by_z20 = t32*t33;
    /* back through: perturbation on the boundary after tau */
    const double slope_by_v1_1_on_boundary_by_v10 = cos_tau1 + sin_tau1*slope_by_carried_z1_2_by_v10;
    const double slope_by_v1_1_on_boundary_by_z20 = sin_tau1*slope_by_carried_z1_2_by_z20;
    const double slope_by_z2_1_on_boundary_by_v10 = slope_by_carried_z1_2_by_v10*t25 - slope_by_carried_z1_2_by_v10 + t26;
    const double slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t25 - slope_by_carried_z1_2_by_z20 + 1;
    const double slope_by_z1_1_on_boundary_by_v10 = cos_tau1*slope_by_carried_z1_2_by_v10 - sin_tau1;
    const double slope_by_z1_1_on_boundary_by_z20 = cos_tau1*slope_by_carried_z1_2_by_z20;
    /* back through: derivatives of the time to the boundary after tau */
    const double slope_by_delay_tau_by_v10 = slope_by_v1_1_on_boundary_by_v10*t31 + slope_by_z1_1_on_boundary_by_v10*v1_1 + slope_by_z2_1_on_boundary_by_v10*v2_1;
    const double slope_by_delay_tau_by_z20 = slope_by_v1_1_on_boundary_by_z20*t31 + slope_by_z1_1_on_boundary_by_z20*v1_1 + slope_by_z2_1_on_boundary_by_z20*v2_1;
    /* back through: rate of the exit boundary after tau */
    const double t40 = (1.0/(rate_1*rate_1));
    const double slope_by_rate_1 = carried_v2_1_by_v10*slope_by_delay_tau_by_v10*t40 + carried_v2_1_by_z20*slope_by_delay_tau_by_z20*t40;
    /* back through: Phi along tau */
    const double slope_by_carried_v2_1_by_v10 = -slope_by_delay_tau_by_v10*t30;
    const double slope_by_carried_v2_1_by_z20 = -slope_by_delay_tau_by_z20*t30;
    /* back through: slip-stick for tau1, until second-breaks-forward */
    const double t41 = chi*slope_by_rate_2;
    const double slope_by_v1_2 = -t41;
    const double slope_by_z2_2 = chi*delay_tau1_by_v10;
    const double slope_by_z1_2 = -delay_tau1_by_v10;
    /* back through: functions of tau1 in slip-stick */
    const double t42 = -t32 + v1_1;
    const double t43 = t36 - z1_1_on_boundary_by_v10;
    const double slope_by_sin_tau1 = slope_by_carried_z1_2_by_v10*v1_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*v1_1_on_boundary_by_z20 + slope_by_v1_2*t31 + slope_by_z1_2*t42 + t43;
    const double slope_by_cos_tau1 = -slope_by_carried_z1_2_by_v10*t43 + slope_by_carried_z1_2_by_z20*(-t34 + z1_1_on_boundary_by_z20) + slope_by_v1_2*t42 - slope_by_z1_2*t31 + v1_1_on_boundary_by_v10;
    /* back through: slip-slip for tau, until second-reaches-belt */
    const double slope_by_v2_1 = delay_tau_by_v10*slope_by_z2_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z2_1_on_boundary_by_z20;
    const double slope_by_v1_1 = cos_tau1*slope_by_v1_2 + delay_tau_by_v10*slope_by_z1_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z1_1_on_boundary_by_z20 + sin_tau1*slope_by_z1_2;
    const double t44 = delay_tau_by_z20*slope_by_v1_1_on_boundary_by_z20;
    const double t45 = delay_tau_by_v10*slope_by_v1_1_on_boundary_by_v10;
    const double t46 = -chi*eta*slope_by_rate_1;
    const double slope_by_z2_1 = chi*t44 + chi*t45 + slope_by_v1_2*t26 + slope_by_z1_2*t25 + slope_by_z2_2 + t46;
    const double slope_by_z1_1 = cos_tau1*slope_by_z1_2 - sin_tau1*slope_by_v1_2 - t44 - t45 - t46;
    /* back through: functions of tau in slip-slip */
    const double t47 = V*p1;
    const double t48 = p3*v10;
    const double t49 = V*p2;
    const double t50 = p3*slope_by_z2_1_on_boundary_by_v10;
    const double slope_by_sin_omega2_tau = slope_by_carried_v2_1_by_z20*(-t18 + t21) + slope_by_v1_1*(t11*z20 - t16*z10) + slope_by_v1_1_on_boundary_by_z20*(t11 - t16) + slope_by_v2_1*(-t18*z20 + t21*z10) + slope_by_z1_1*(-t4*t5*v10 - t49*t5) - slope_by_z1_1_on_boundary_by_v10*t4*t5 + slope_by_z2_1*(t47*t5 - t48*t5) - t5*t50;
    const double t51 = -p1 + p3;
    const double t52 = p3*z10;
    const double t53 = p2*z20;
    const double t54 = p3*slope_by_carried_v2_1_by_v10;
    const double slope_by_cos_omega2_tau = slope_by_v1_1*(-t4*v10 - t49) - slope_by_v1_1_on_boundary_by_v10*t4 + slope_by_v2_1*(t47 - t48) + slope_by_z1_1*(-t4*z10 - t53) + slope_by_z1_1_on_boundary_by_z20*(-p2 - t4) + slope_by_z2_1*(p1*z20 - t52) - slope_by_z2_1_on_boundary_by_z20*t51 - t54;
    const double t55 = -V*t4;
    const double t56 = p1*v10;
    const double slope_by_sin_omega1_tau = p1*slope_by_z1_1_on_boundary_by_v10*t2 + slope_by_carried_v2_1_by_z20*(-t19 - t22) + slope_by_v1_1*(-omega1*t53 - t15*z10) + slope_by_v1_1_on_boundary_by_z20*(-t12 - t15) + slope_by_v2_1*(-omega1*t52 - t19*z20) + slope_by_z1_1*(t2*t49 + t2*t56) + slope_by_z2_1*(t2*t48 + t2*t55) + t2*t50;
    const double t57 = -t4*z20;
    const double t58 = p1*z10;
    const double slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_v10 + slope_by_v1_1*(t49 + t56) + slope_by_v2_1*(t48 + t55) + slope_by_z1_1*(t53 + t58) + slope_by_z1_1_on_boundary_by_z20*(p1 + p2) + slope_by_z2_1*(t52 + t57) + slope_by_z2_1_on_boundary_by_z20*(t51 + 1) + t54;
    /* trace_gradient */
    const double t59 = cos_omega2_tau*slope_by_sin_omega2_tau;
    const double t60 = cos_omega1_tau*slope_by_sin_omega1_tau;
    const double t61 = sin_omega2_tau*slope_by_cos_omega2_tau;
    const double t62 = sin_omega1_tau*slope_by_cos_omega1_tau;
    const double t63 = t3 - t6;
    const double t64 = cos_omega1_tau - cos_omega2_tau;
    const double t65 = -omega1*sin_omega1_tau + omega2*sin_omega2_tau;
    const double t66 = t64*v10 + t65*z10;
    const double t67 = t63*v10 + t64*z10;
    const double t68 = slope_by_carried_v2_1_by_v10*t64 + slope_by_carried_v2_1_by_z20*t65 + slope_by_v2_1*t66 + slope_by_z2_1*t67 + slope_by_z2_1_on_boundary_by_v10*t63 + slope_by_z2_1_on_boundary_by_z20*t64;
    const double t69 = slope_by_v1_1_on_boundary_by_z20*t65 + slope_by_z1_1_on_boundary_by_z20*t64;
    const double t70 = slope_by_v1_1*(V*t64 + t65*z20) + slope_by_z1_1*(V*t63 + t64*z20) + t69;
    const double t71 = -slope_by_carried_v2_1_by_z20*t65 + slope_by_v1_1*t66 + slope_by_v1_1_on_boundary_by_v10*t64 + slope_by_v2_1*(-V*t64 - t65*z20) + slope_by_z1_1*t67 + slope_by_z1_1_on_boundary_by_v10*t63 + slope_by_z2_1*(-V*t63 - t64*z20) - slope_by_z2_1_on_boundary_by_z20*t64 + t69;
    const double t72 = -sin_omega2_tau*t4;
    const double t73 = p3*sin_omega2_tau;
    const double t74 = (1.0/(omega2*omega2));
    const double t75 = sin_omega2_tau*t74;
    const double t76 = slope_by_carried_v2_1_by_z20*(-p1*sin_omega2_tau + t73) + slope_by_v1_1*(sin_omega2_tau*t4*z10 + sin_omega2_tau*t53) + slope_by_v1_1_on_boundary_by_z20*(p2*sin_omega2_tau - t72) + slope_by_v2_1*(-p1*sin_omega2_tau*z20 + sin_omega2_tau*t52) + slope_by_z1_1*(t4*t75*v10 + t49*t75) - slope_by_z1_1_on_boundary_by_v10*t72*t74 + slope_by_z2_1*(p3*sin_omega2_tau*t74*v10 - t47*t75) + slope_by_z2_1_on_boundary_by_v10*t73*t74 + t59*tau - t61*tau;
    const double t77 = p1*sin_omega1_tau;
    const double t78 = p3*sin_omega1_tau;
    const double t79 = (1.0/(omega1*omega1));
    const double t80 = sin_omega1_tau*t79;
    const double t81 = slope_by_carried_v2_1_by_z20*(sin_omega1_tau*t4 - t78) + slope_by_v1_1*(-sin_omega1_tau*t53 - sin_omega1_tau*t58) + slope_by_v1_1_on_boundary_by_z20*(-p2*sin_omega1_tau - t77) + slope_by_v2_1*(-sin_omega1_tau*t52 - sin_omega1_tau*t57) + slope_by_z1_1*(-t49*t80 - t56*t80) - slope_by_z1_1_on_boundary_by_v10*t77*t79 + slope_by_z2_1*(-t48*t80 - t55*t80) - slope_by_z2_1_on_boundary_by_v10*t78*t79 + t60*tau - t62*tau;
    const double t82 = 1 - cos_tau1;
    if (trace_gradient) {
        trace_gradient[lane] = carried_v1_1_by_v10*slope_by_z1_1 + carried_v2_1_by_v10*slope_by_z2_1 - slope_by_v1_1*t17 + slope_by_v2_1*t24;
        trace_gradient[1*lanes + lane] = slope_by_v1_1*t14 - slope_by_v2_1*t20 + slope_by_z1_1*t7 + slope_by_z2_1*t9;
        trace_gradient[2*lanes + lane] = carried_v1_1_by_v10*slope_by_v1_1 + carried_v2_1_by_v10*slope_by_v2_1 + carried_z1_1_by_v10*slope_by_z1_1 + carried_z2_1_by_v10*slope_by_z2_1;
        trace_gradient[3*lanes + lane] = omega1*t60 - omega1*t62 + omega2*t59 - omega2*t61;
        trace_gradient[4*lanes + lane] = V*slope_by_z2_2 + cos_tau1*slope_by_sin_tau1 - sin_tau1*slope_by_cos_tau1 + slope_by_z1_2*t32;
        trace_gradient[5*lanes + lane] = V*t33*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + delay_tau1_by_v10*z2_2 + omega1_by_chi*t81 + omega2_by_chi*t76 + p1_by_chi*t71 + p2_by_chi*t70 + p3_by_chi*t68 + sin_tau1*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_v10*t82*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*t82*z2_1_on_boundary_by_z20 + slope_by_rate_1*(-eta*z2_1 + t28) + slope_by_rate_2*(V - v1_2) + slope_by_v1_2*(V*t82 + sin_tau1*z2_1) + slope_by_z1_2*(V*(-sin_tau1 + tau1) + t82*z2_1) + t39*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10) + t44*z2_1 + t45*z2_1;
        trace_gradient[6*lanes + lane] = omega1_by_eta*t81 + omega2_by_eta*t76 + p1_by_eta*t71 + p2_by_eta*t70 + p3_by_eta*t68 + slope_by_rate_1*(chi*z1_1 - t29);
        trace_gradient[7*lanes + lane] = delay_tau1_by_z20 + slope_by_v1_1*t7 + slope_by_v1_2*t25 + slope_by_v2_1*t9 + slope_by_z1_1*t8 + slope_by_z1_2*t27 + slope_by_z2_1*t10 + slope_by_z2_2*tau1 + t41;
        trace_gradient[8*lanes + lane] = 0;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_symmetric_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    dry_friction_symmetric_trace_in_lane(1, 0, parameters, spectrum, unknowns, spectrum_derivatives,
        trace, trace_gradient);
}

/* State at the start and behind each transition. Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after the other; and the frequencies of each phase.
 * Operations: 136. Intermediate terms: 37. */
NONSMOOTH_UNMERGED
void dry_friction_symmetric_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *states,
    double *coefficients, double *frequencies)
{
    const double chi = parameters[0], V = parameters[2], e2 = parameters[3];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double z10 = unknowns[0], z20 = unknowns[1], v10 = unknowns[2], tau = unknowns[3],
        tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = sin_omega1_tau/omega1;
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_tau/omega2;
    const double t5 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t6 = cos_omega1_tau*p1 + cos_omega2_tau*t3;
    const double z1_1 = V*(p2*t2 - p2*t4) + t5*z20 + t6*z10 + v10*(p1*t2 + t3*t4);
    const double z2_1 = V*(p1*t4 + t2*t3) + v10*(p3*t2 - p3*t4) + z10*(cos_omega1_tau*p3 - cos_omega2_tau*p3) + z20*(cos_omega1_tau*t3 + cos_omega2_tau*p1);
    const double t7 = omega2*sin_omega2_tau;
    const double t8 = omega1*sin_omega1_tau;
    const double v1_1 = V*t5 + t6*v10 + z10*(-p1*t8 - t3*t7) + z20*(p2*t7 - p2*t8);
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t9 = -chi*cos_tau1 + chi;
    const double t10 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t10) + cos_tau1*z1_1 + sin_tau1*v1_1 + t9*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t9 + cos_tau1*v1_1 - sin_tau1*z1_1 + t10*z2_1;
    if (states) {
        states[0] = z10;
        states[1] = z20;
        states[2] = v10;
        states[3] = V;
        states[4] = z1_1;
        states[5] = z2_1;
        states[6] = v1_1;
        states[7] = V;
        states[8] = z1_2;
        states[9] = z2_2;
        states[10] = v1_2;
        states[11] = V;
    }
    if (!coefficients && !frequencies)
        return;
    /* coefficients */
    const double t11 = V*p2;
    const double t12 = p2*z20;
    const double t13 = omega1*z10;
    const double t14 = omega2*z10;
    const double t15 = p3*v10;
    const double t16 = V*chi;
    const double t17 = -t16 + v1_1;
    const double t18 = chi*z2_1;
    const double t19 = t18 - z1_1;
    const double t20 = (chi*chi);
    const double t21 = t20*z2_1;
    const double t22 = V*t20 - t16;
    const double t23 = -chi*t19;
    const double t24 = chi*t17;
    if (coefficients) {
        for (int i = 0; i < 24; ++i)
            coefficients[i] = 0.0;
        coefficients[0] = -V;
        coefficients[2] = p1*v10 + t11;
        coefficients[3] = -t11 + t3*v10;
        coefficients[4] = -omega1*t12 - p1*t13;
        coefficients[5] = omega2*t12 - t14*t3;
        coefficients[6] = -V;
        coefficients[8] = V*t3 + t15;
        coefficients[9] = V*p1 - t15;
        coefficients[10] = -omega1*t3*z20 - p3*t13;
        coefficients[11] = -omega2*p1*z20 + p3*t14;
        coefficients[12] = -V + t16;
        coefficients[14] = t17;
        coefficients[15] = t19;
        coefficients[16] = -e2 + t18 - t21;
        coefficients[17] = -t22;
        coefficients[18] = -t23;
        coefficients[19] = -t24;
        coefficients[20] = -e2 - t18 + t21;
        coefficients[21] = t22;
        coefficients[22] = t23;
        coefficients[23] = t24;
    }
    if (!frequencies)
        return;
    if (frequencies) {
        frequencies[0] = omega1;
        frequencies[1] = omega2;
        frequencies[2] = 1;
    }
}

/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the other; monodromy matrix.
 * Operations: 269. Intermediate terms: 100. */
NONSMOOTH_UNMERGED
void dry_friction_symmetric_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[5],
    double *poincare_jacobian, double *saltations, double *monodromy)
{
    const double chi = parameters[0], eta = parameters[1], V = parameters[2];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double z10 = unknowns[0], z20 = unknowns[1], v10 = unknowns[2], tau = unknowns[3],
        tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = sin_omega1_tau/omega1;
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_tau/omega2;
    const double carried_z1_1_by_v10 = p1*t2 + t3*t4;
    const double phi_1_01 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double carried_v1_1_by_v10 = cos_omega1_tau*p1 + cos_omega2_tau*t3;
    const double phi_1_03 = p2*t2 - p2*t4;
    const double z1_1 = V*phi_1_03 + carried_v1_1_by_v10*z10 + carried_z1_1_by_v10*v10 + phi_1_01*z20;
    const double carried_z2_1_by_v10 = p3*t2 - p3*t4;
    const double phi_1_11 = cos_omega1_tau*t3 + cos_omega2_tau*p1;
    const double carried_v2_1_by_v10 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double phi_1_13 = p1*t4 + t2*t3;
    const double z2_1 = V*phi_1_13 + carried_v2_1_by_v10*z10 + carried_z2_1_by_v10*v10 + phi_1_11*z20;
    const double t5 = omega2*sin_omega2_tau;
    const double t6 = omega1*sin_omega1_tau;
    const double t7 = p2*t6;
    const double phi_1_21 = p2*t5 - t7;
    const double t8 = p1*t6 + t3*t5;
    const double v1_1 = V*phi_1_01 + carried_v1_1_by_v10*v10 + phi_1_21*z20 - t8*z10;
    const double t9 = p1*t5 + t3*t6;
    const double t10 = p3*t6;
    const double phi_1_30 = p3*t5 - t10;
    const double v2_1 = V*phi_1_11 + carried_v2_1_by_v10*v10 + phi_1_30*z10 - t9*z20;
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t11 = -chi*cos_tau1 + chi;
    const double t12 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t12) + cos_tau1*z1_1 + sin_tau1*v1_1 + t11*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t11 + cos_tau1*v1_1 - sin_tau1*z1_1 + t12*z2_1;
    /* Phi along tau */
    const double carried_z1_1_by_z20 = carried_v1_1_by_v10 + phi_1_01;
    const double carried_z2_1_by_z20 = carried_v2_1_by_v10 + phi_1_11;
    const double carried_v1_1_by_z20 = omega2*p2*sin_omega2_tau - t7 - t8;
    const double carried_v2_1_by_z20 = omega2*p3*sin_omega2_tau - t10 - t9;
    /* rate of the exit boundary after tau */
    const double t13 = chi*eta;
    const double t14 = chi*z2_1;
    const double rate_1 = -eta*t14 + t13*z1_1;
    /* derivatives of the time to the boundary after tau */
    const double t15 = (1.0/(rate_1));
    const double delay_tau_by_z20 = -carried_v2_1_by_z20*t15;
    const double delay_tau_by_v10 = -carried_v2_1_by_v10*t15;
    /* perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
    const double before_v1_1 = t14 - z1_1;
    const double v1_1_on_boundary_by_z20 = before_v1_1*delay_tau_by_z20 + carried_v1_1_by_z20;
    const double v1_1_on_boundary_by_v10 = before_v1_1*delay_tau_by_v10 + carried_v1_1_by_v10;
    /* Phi along tau1 */
    const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t11*z2_1_on_boundary_by_z20;
    const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t11*z2_1_on_boundary_by_v10;
    const double carried_v1_2_by_z20 = cos_tau1*v1_1_on_boundary_by_z20 - sin_tau1*z1_1_on_boundary_by_z20 + t12*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t12*z2_1_on_boundary_by_v10;
    /* rate of the exit boundary after tau1 */
    const double rate_2 = V*chi - chi*v1_2;
    /* derivatives of the time to the boundary after tau1 */
    const double t16 = (1.0/(rate_2));
    const double delay_tau1_by_z20 = t16*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    const double delay_tau1_by_v10 = t16*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10);
    /* perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20;
    const double z2_2_on_boundary_by_v10 = V*delay_tau1_by_v10 + z2_1_on_boundary_by_v10;
    const double t17 = chi*z2_2;
    const double before_v1_2 = t17 - z1_2;
    const double v1_2_on_boundary_by_z20 = before_v1_2*delay_tau1_by_z20 + carried_v1_2_by_z20;
    const double v1_2_on_boundary_by_v10 = before_v1_2*delay_tau1_by_v10 + carried_v1_2_by_v10;
    if (poincare_jacobian) {
        poincare_jacobian[0] = z2_2_on_boundary_by_z20;
        poincare_jacobian[1] = z2_2_on_boundary_by_v10;
        poincare_jacobian[2] = v1_2_on_boundary_by_z20;
        poincare_jacobian[3] = v1_2_on_boundary_by_v10;
    }
    if (!saltations && !monodromy)
        return;
    /* vector fields at transition 2 */
    const double behind_v2_2 = -eta*t17 + t13*z1_2;
    /* saltations */
    const double t18 = (1.0/(rate_1));
    const double t19 = t18*(V - v2_1);
    const double t20 = 0;
    const double t21 = chi/rate_2;
    const double t22 = 0;
    const double t23 = behind_v2_2*t21;
    if (saltations) {
        for (int i = 0; i < 32; ++i)
            saltations[i] = 0.0;
        saltations[0] = 1;
        saltations[5] = 1;
        saltations[7] = t19;
        saltations[10] = 1;
        saltations[11] = t20;
        saltations[16] = 1;
        saltations[21] = 1;
        saltations[24] = -t22;
        saltations[25] = t22;
        saltations[26] = 1;
        saltations[28] = -t23;
        saltations[29] = t23;
        saltations[31] = 1;
    }
    if (!monodromy)
        return;
    /* Phi of phase 1 */
    const double phi_1_20 = -t8;
    const double phi_1_31 = -t9;
    /* saltation of phase 1 */
    const double saltation_1_10 = carried_v2_1_by_v10 + phi_1_30*t19;
    const double saltation_1_11 = phi_1_11 + phi_1_31*t19;
    const double saltation_1_12 = carried_v2_1_by_v10*t19 + carried_z2_1_by_v10;
    const double saltation_1_13 = phi_1_11*t19 + phi_1_13;
    const double saltation_1_20 = phi_1_20 + phi_1_30*t20;
    const double saltation_1_21 = phi_1_21 + phi_1_31*t20;
    const double saltation_1_22 = carried_v1_1_by_v10 + carried_v2_1_by_v10*t20;
    const double saltation_1_23 = phi_1_01 + phi_1_11*t20;
    /* Phi of phase 2 */
    const double phi_2_00 = carried_v1_1_by_v10*cos_tau1 + saltation_1_10*t11 + saltation_1_20*sin_tau1;
    const double phi_2_01 = cos_tau1*phi_1_01 + saltation_1_11*t11 + saltation_1_21*sin_tau1;
    const double phi_2_02 = carried_z1_1_by_v10*cos_tau1 + saltation_1_12*t11 + saltation_1_22*sin_tau1;
    const double phi_2_03 = cos_tau1*phi_1_03 + saltation_1_13*t11 + saltation_1_23*sin_tau1;
    const double phi_2_20 = -carried_v1_1_by_v10*sin_tau1 + cos_tau1*saltation_1_20 + saltation_1_10*t12;
    const double phi_2_21 = cos_tau1*saltation_1_21 - phi_1_01*sin_tau1 + saltation_1_11*t12;
    const double phi_2_22 = -carried_z1_1_by_v10*sin_tau1 + cos_tau1*saltation_1_22 + saltation_1_12*t12;
    const double phi_2_23 = cos_tau1*saltation_1_23 - phi_1_03*sin_tau1 + saltation_1_13*t12;
    /* saltation of phase 2 */
    const double saltation_2_20 = -phi_2_00*t22 + phi_2_20 + saltation_1_10*t22;
    const double saltation_2_21 = -phi_2_01*t22 + phi_2_21 + saltation_1_11*t22;
    const double saltation_2_22 = -phi_2_02*t22 + phi_2_22 + saltation_1_12*t22;
    const double saltation_2_23 = -phi_2_03*t22 + phi_2_23 + saltation_1_13*t22;
    const double saltation_2_30 = -phi_2_00*t23 + saltation_1_10*t23;
    const double saltation_2_31 = -phi_2_01*t23 + saltation_1_11*t23;
    const double saltation_2_32 = -phi_2_02*t23 + saltation_1_12*t23;
    const double saltation_2_33 = -phi_2_03*t23 + saltation_1_13*t23;
    if (monodromy) {
        monodromy[0] = phi_2_00;
        monodromy[1] = phi_2_01;
        monodromy[2] = phi_2_02;
        monodromy[3] = phi_2_03;
        monodromy[4] = saltation_1_10;
        monodromy[5] = saltation_1_11;
        monodromy[6] = saltation_1_12;
        monodromy[7] = saltation_1_13;
        monodromy[8] = saltation_2_20;
        monodromy[9] = saltation_2_21;
        monodromy[10] = saltation_2_22;
        monodromy[11] = saltation_2_23;
        monodromy[12] = saltation_2_30;
        monodromy[13] = saltation_2_31;
        monodromy[14] = saltation_2_32;
        monodromy[15] = saltation_2_33;
    }
}

/* State after a time in slip-slip.
 * Operations: 77. Intermediate terms: 15. */
NONSMOOTH_UNMERGED
void dry_friction_symmetric_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
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
    state_after[0] = t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6);
    state_after[2] = t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14);
    state_after[3] = t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6);
}

/* State after a time in slip-stick.
 * Operations: 23. Intermediate terms: 4. */
NONSMOOTH_UNMERGED
void dry_friction_symmetric_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = sin(time);
    const double t1 = chi*t0;
    const double t2 = cos(time);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1);
    state_after[1] = time*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* All unknowns from the reduced ones; how singular the linear equations for them are: 0 if they are; the equations for these and their derivatives.
 * Operations: 195. Intermediate terms: 61. */
static NONSMOOTH_INLINE void dry_friction_symmetric_reduced_fixed_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *fixed)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane],
        e2 = parameters[3*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    /* coefficients of the linear equations */
    const double t2 = (1.0/(omega2));
    const double t4 = (1.0/(omega1));
    const double t5 = p1*t4;
    /* right-hand sides of the linear equations */
    const double t7 = e2/chi;
    const double t10 = V*p2;
    const double t11 = p1*t7;
    const double t13 = V*t4;
    const double t24 = p3*t7;
    const double t26 = V*chi;
    /* d/dtau of: functions of half_tau in slip-slip */
    const double t27 = (1.0/2.0)*omega1;
    const double t28 = (1.0/2.0)*omega2;
    /* d/dtau of: coefficients of the linear equations */
    const double t29 = p1*t2;
    /* d/dtau1 of: right-hand sides of the linear equations */
    const double t31 = (1.0/2.0)*V;
    fixed[lane] = t2;
    fixed[1*lanes + lane] = t4;
    fixed[2*lanes + lane] = t5;
    fixed[3*lanes + lane] = t7;
    fixed[4*lanes + lane] = t10;
    fixed[5*lanes + lane] = t11;
    fixed[6*lanes + lane] = t13;
    fixed[7*lanes + lane] = t24;
    fixed[8*lanes + lane] = t26;
    fixed[9*lanes + lane] = t27;
    fixed[10*lanes + lane] = t28;
    fixed[11*lanes + lane] = t29;
    fixed[12*lanes + lane] = t31;
}

static NONSMOOTH_INLINE void dry_friction_symmetric_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *fixed,
    const double *reduced, double *unknowns, double *determinants, double *reduced_residual,
    double *reduced_jacobian)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane];
    const double t2 = fixed[lane], t4 = fixed[1*lanes + lane], t5 = fixed[2*lanes + lane],
        t7 = fixed[3*lanes + lane], t10 = fixed[4*lanes + lane], t11 = fixed[5*lanes + lane],
        t13 = fixed[6*lanes + lane], t24 = fixed[7*lanes + lane], t26 = fixed[8*lanes + lane],
        t27 = fixed[9*lanes + lane], t28 = fixed[10*lanes + lane], t29 = fixed[11*lanes + lane],
        t31 = fixed[12*lanes + lane];
    const double tau = reduced[lane], tau1 = reduced[1*lanes + lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t1 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    const double t3 = sin_omega2_half_tau*t2;
    const double t6 = p1*t3;
    const double coefficient11 = sin_omega1_half_tau*t5 + t3 - t6;
    const double t8 = cos_omega2_half_tau*t7;
    const double z20 = V*half_tau1;
    const double t9 = cos_omega2_half_tau*z20;
    const double t12 = p2*z20;
    const double t14 = sin_omega1_half_tau*t13;
    const double t15 = p1*z20;
    const double t16 = -cos_omega1_half_tau*t15 + p1*t9;
    const double right1 = cos_omega1_half_tau*t11 - cos_omega1_half_tau*t12 - p1*t8 - p2*t14 + p2*t9 + t10*t3 + t16 + t8 - t9;
    /* v10 by Cramer's rule */
    const double t17 = (1.0/(coefficient11));
    const double v10 = right1*t17;
    /* z10: linear in: second-breaks-forward ends slip-stick */
    const double t18 = t7 - z20;
    const double z10 = -t18;
    if (unknowns) {
        unknowns[lane] = z10;
        unknowns[1*lanes + lane] = z20;
        unknowns[2*lanes + lane] = v10;
        unknowns[3*lanes + lane] = tau;
        unknowns[4*lanes + lane] = tau1;
    }
    if (!determinants && !reduced_residual && !reduced_jacobian)
        return;
    /* determinants */
    const double t19 = (half_tau*half_tau);
    const double t20 = 2*t19;
    if (determinants) {
        determinants[lane] = coefficient11/sqrt((p1*p1)*t20/((omega1*omega1)*t19 + 1) + t20*((p1 - 1)*(p1 - 1))/((omega2*omega2)*t19 + 1));
    }
    if (!reduced_residual && !reduced_jacobian)
        return;
    /* functions of half_tau1 in slip-stick */
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, half_tau1);
    const double cos_half_tau1 = wave_2.cosine;
    const double sin_half_tau1 = wave_2.sine;
    /* reduced_residual */
    const double t21 = cos_omega1_half_tau*z20;
    const double t22 = p3*v10;
    const double t23 = t22*t4;
    const double t25 = cos_half_tau1*z20;
    if (reduced_residual) {
        reduced_residual[lane] = V*t6 - cos_omega1_half_tau*t24 - p1*t14 + p3*t21 + p3*t8 - p3*t9 + sin_omega1_half_tau*t23 + t14 + t16 + t21 - t22*t3;
        reduced_residual[1*lanes + lane] = chi*t25 + cos_half_tau1*t7 - sin_half_tau1*t26 + sin_half_tau1*v10 - t25;
    }
    if (!reduced_jacobian)
        return;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t27;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t27;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t28;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t28;
    /* d/dtau1 of: functions of half_tau1 in slip-stick */
    const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
    const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
    const double coefficient11_by_tau = sin_omega1_half_tau_by_tau*t5 + sin_omega2_half_tau_by_tau*(t2 - t29);
    /* d/dtau of: right-hand sides of the linear equations */
    const double t30 = -t11 + t12 + t15;
    const double right1_by_tau = -cos_omega1_half_tau_by_tau*t30 + cos_omega2_half_tau_by_tau*(t18 + t30) - p2*sin_omega1_half_tau_by_tau*t13 + sin_omega2_half_tau_by_tau*t10*t2;
    const double t32 = cos_omega2_half_tau*t31;
    const double t33 = cos_omega1_half_tau*t31;
    const double t34 = p1*t33;
    const double right1_by_tau1 = (1.0/2.0)*V*cos_omega2_half_tau*p1 + (1.0/2.0)*V*cos_omega2_half_tau*p2 - p2*t33 - t32 - t34;
    /* d/dtau of: v10 by Cramer's rule */
    const double v10_by_tau = right1_by_tau*t17 - coefficient11_by_tau*right1/(coefficient11*coefficient11);
    /* d/dtau1 of: v10 by Cramer's rule */
    const double v10_by_tau1 = right1_by_tau1*t17;
    /* reduced_jacobian */
    const double t35 = -p3*z20 + t15 + t24;
    const double t36 = p3*sin_omega1_half_tau*t4 - p3*t3;
    if (reduced_jacobian) {
        reduced_jacobian[lane] = cos_omega1_half_tau_by_tau*(-t35 + z20) + cos_omega2_half_tau_by_tau*t35 + sin_omega1_half_tau_by_tau*(-p1*t13 + t13 + t23) + sin_omega2_half_tau_by_tau*(V*t29 - t2*t22) + t36*v10_by_tau;
        reduced_jacobian[1*lanes + lane] = p1*t32 - p3*t32 + p3*t33 + t33 - t34 + t36*v10_by_tau1;
        reduced_jacobian[2*lanes + lane] = sin_half_tau1*v10_by_tau;
        reduced_jacobian[3*lanes + lane] = (1.0/2.0)*cos_half_tau1*t26 - cos_half_tau1*t31 + cos_half_tau1_by_tau1*(chi*z20 + t18) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t26 + v10);
    }
}

NONSMOOTH_UNMERGED
void dry_friction_symmetric_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[2], double *unknowns,
    double *determinants, double *reduced_residual, double *reduced_jacobian)
{
    double fixed[13];
    dry_friction_symmetric_reduced_fixed_in_lane(1, 0, parameters, spectrum, fixed);
    dry_friction_symmetric_reduced_in_lane(1, 0, parameters, spectrum, fixed, reduced, unknowns,
        determinants, reduced_residual, reduced_jacobian);
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 672. Intermediate terms: 195. */
static NONSMOOTH_INLINE void dry_friction_global_stick_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane], e1 = parameters[3*lanes + lane],
        e2 = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double z10 = unknowns[lane], z20 = unknowns[1*lanes + lane],
        ta = unknowns[2*lanes + lane], tau = unknowns[3*lanes + lane],
        tau1 = unknowns[4*lanes + lane], tau2 = unknowns[5*lanes + lane];
    /* stick-stick for ta, until first-breaks-forward */
    const double t0 = V*ta;
    const double z1_1 = t0 + z10;
    const double z2_1 = t0 + z20;
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* slip-stick for tau, until second-breaks-forward */
    const double t1 = chi*cos_tau;
    const double z1_2_by_z20 = chi - t1;
    const double t2 = V*sin_tau;
    const double v1_2_by_z20 = chi*sin_tau;
    const double t3 = chi*tau - v1_2_by_z20;
    const double z1_2 = V*t3 + cos_tau*z1_1 + t2 + z1_2_by_z20*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double z1_2_by_ta = V*cos_tau + V*z1_2_by_z20;
    const double v1_2 = -sin_tau*z1_1 + v1_2_by_z20*z2_1 + z1_2_by_ta;
    /* functions of tau1 in slip-slip */
    const double t4 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t4);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t5 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t5);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    /* slip-slip for tau1, until first-reaches-belt */
    const double t6 = 1 - p1;
    const double t7 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t9 = (1.0/(omega1));
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = (1.0/(omega2));
    const double t12 = sin_omega2_tau1*t11;
    const double t13 = p1*t10 + t12*t6;
    const double t14 = p2*t10 - p2*t12;
    const double z1_3 = V*t14 + t13*v1_2 + t7*z1_2 + t8*z2_2;
    const double t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t16 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double t17 = p3*t10 - p3*t12;
    const double t18 = p1*t12 + t10*t6;
    const double z2_3 = V*t18 + t15*z1_2 + t16*z2_2 + t17*v1_2;
    const double t19 = omega1*sin_omega1_tau1;
    const double t20 = omega2*sin_omega2_tau1;
    const double t21 = -p1*t19 - t20*t6;
    const double t22 = -p2*t19 + p2*t20;
    const double t23 = V*t8;
    const double t24 = t23 + t7*v1_2;
    const double v1_3 = t21*z1_2 + t22*z2_2 + t24;
    const double t25 = -p3*t19 + p3*t20;
    const double t26 = p1*t20 + t19*t6;
    const double t27 = V*t16;
    const double t28 = t15*v1_2 + t27;
    const double v2_3 = t25*z1_2 - t26*z2_2 + t28;
    /* functions of tau2 in stick-slip */
    const double t29 = omega3*tau2;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t29);
    const double cos_omega3_tau2 = wave_3.cosine;
    const double sin_omega3_tau2 = wave_3.sine;
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t30 = 1 - cos_omega3_tau2;
    const double t31 = (1.0/(omega3));
    const double t32 = sin_omega3_tau2*t31;
    const double t33 = -t32 + tau2;
    const double z2_4 = V*t33 + cos_omega3_tau2*z2_3 + t30*z1_3 + t32*v2_3;
    const double t34 = cos_omega3_tau2*v2_3;
    const double t35 = sin_omega3_tau2*z1_3;
    const double t36 = sin_omega3_tau2*z2_3;
    const double v2_4 = V*t30 + omega3*t35 - omega3*t36 + t34;
    if (residual) {
        residual[lane] = -chi*z2_1 - e1 + z1_1;
        residual[1*lanes + lane] = -chi*z1_2 + chi*z2_2 - e2;
        residual[2*lanes + lane] = -V + v1_3;
        residual[3*lanes + lane] = -V + v2_4;
        residual[4*lanes + lane] = -z10 + z1_4;
        residual[5*lanes + lane] = -z20 + z2_4;
    }
    if (!jacobian && !parameter_jacobian)
        return;
    /* derivatives of the state after tau */
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_ta = chi*t2 - t2;
    const double v1_2_by_tau = chi*z2_2 - z1_2;
    /* derivatives of the state after tau1 */
    const double z1_3_by_z10 = cos_tau*t7 + t13*v1_2_by_z10;
    const double z1_3_by_z20 = t13*v1_2_by_z20 + t7*z1_2_by_z20 + t8;
    const double z1_3_by_ta = t13*v1_2_by_ta + t23 + t7*z1_2_by_ta;
    const double z1_3_by_tau = t13*v1_2_by_tau + t24;
    const double z2_3_by_z10 = cos_tau*t15 + t17*v1_2_by_z10;
    const double z2_3_by_z20 = t15*z1_2_by_z20 + t16 + t17*v1_2_by_z20;
    const double z2_3_by_ta = t15*z1_2_by_ta + t17*v1_2_by_ta + t27;
    const double z2_3_by_tau = t17*v1_2_by_tau + t28;
    const double v1_3_by_z10 = cos_tau*t21 + t7*v1_2_by_z10;
    const double v1_3_by_z20 = t21*z1_2_by_z20 + t22 + t7*v1_2_by_z20;
    const double t37 = V*t22;
    const double v1_3_by_ta = t21*z1_2_by_ta + t37 + t7*v1_2_by_ta;
    const double v1_3_by_tau = t21*v1_2 + t37 + t7*v1_2_by_tau;
    const double t38 = chi*z2_3;
    const double v1_3_by_tau1 = t38 - z1_3;
    const double v2_3_by_z10 = cos_tau*t25 + t15*v1_2_by_z10;
    const double v2_3_by_z20 = t15*v1_2_by_z20 + t25*z1_2_by_z20 - t26;
    const double t39 = -V*t26;
    const double v2_3_by_ta = t15*v1_2_by_ta + t25*z1_2_by_ta + t39;
    const double v2_3_by_tau = t15*v1_2_by_tau + t25*v1_2 + t39;
    const double t40 = chi*eta;
    const double v2_3_by_tau1 = -eta*t38 + t40*z1_3;
    /* derivatives of the state after tau2 */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t30*z1_3_by_z10 + t32*v2_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t30*z1_3_by_z20 + t32*v2_3_by_z20;
    const double z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t30*z1_3_by_ta + t32*v2_3_by_ta;
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t30*z1_3_by_tau + t32*v2_3_by_tau;
    const double z2_4_by_tau1 = t30*v1_3 + t32*v2_3_by_tau1 + t34;
    const double t41 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t41*z1_3_by_z10 - t41*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t41*z1_3_by_z20 - t41*z2_3_by_z20;
    const double v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t41*z1_3_by_ta - t41*z2_3_by_ta;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t41*z1_3_by_tau - t41*z2_3_by_tau;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t41*v1_3 - t41*v2_3;
    const double v2_4_by_tau2 = t40*z1_4 - t40*z2_4;
    /* jacobian */
    const double t42 = V*chi;
    if (jacobian) {
        jacobian[lane] = 1;
        jacobian[1*lanes + lane] = -chi;
        jacobian[2*lanes + lane] = V - t42;
        jacobian[3*lanes + lane] = 0;
        jacobian[4*lanes + lane] = 0;
        jacobian[5*lanes + lane] = 0;
        jacobian[6*lanes + lane] = -t1;
        jacobian[7*lanes + lane] = -chi*z1_2_by_z20 + chi;
        jacobian[8*lanes + lane] = -chi*z1_2_by_ta + t42;
        jacobian[9*lanes + lane] = -chi*v1_2 + t42;
        jacobian[10*lanes + lane] = 0;
        jacobian[11*lanes + lane] = 0;
        jacobian[12*lanes + lane] = v1_3_by_z10;
        jacobian[13*lanes + lane] = v1_3_by_z20;
        jacobian[14*lanes + lane] = v1_3_by_ta;
        jacobian[15*lanes + lane] = v1_3_by_tau;
        jacobian[16*lanes + lane] = v1_3_by_tau1;
        jacobian[17*lanes + lane] = 0;
        jacobian[18*lanes + lane] = v2_4_by_z10;
        jacobian[19*lanes + lane] = v2_4_by_z20;
        jacobian[20*lanes + lane] = v2_4_by_ta;
        jacobian[21*lanes + lane] = v2_4_by_tau;
        jacobian[22*lanes + lane] = v2_4_by_tau1;
        jacobian[23*lanes + lane] = v2_4_by_tau2;
        jacobian[24*lanes + lane] = z1_3_by_z10 - 1;
        jacobian[25*lanes + lane] = z1_3_by_z20;
        jacobian[26*lanes + lane] = z1_3_by_ta;
        jacobian[27*lanes + lane] = z1_3_by_tau;
        jacobian[28*lanes + lane] = v1_3;
        jacobian[29*lanes + lane] = V;
        jacobian[30*lanes + lane] = z2_4_by_z10;
        jacobian[31*lanes + lane] = z2_4_by_z20 - 1;
        jacobian[32*lanes + lane] = z2_4_by_ta;
        jacobian[33*lanes + lane] = z2_4_by_tau;
        jacobian[34*lanes + lane] = z2_4_by_tau1;
        jacobian[35*lanes + lane] = v2_4;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane],
        omega3_by_chi = spectrum_derivatives[12*lanes + lane],
        omega3_by_eta = spectrum_derivatives[13*lanes + lane];
    /* d/dchi of: slip-stick for tau, until second-breaks-forward */
    const double t43 = 1 - cos_tau;
    const double z1_2_by_chi = V*(-sin_tau + tau) + t43*z2_1;
    const double v1_2_by_chi = V*t43 + sin_tau*z2_1;
    /* d/dV of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_V = cos_tau*ta + sin_tau + t3 + ta*z1_2_by_z20;
    const double z2_2_by_V = ta + tau;
    const double v1_2_by_V = chi + cos_tau - sin_tau*ta - t1 + ta*v1_2_by_z20;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t44 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t44;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t44;
    const double t45 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t45;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t45;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t46 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t46;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t46;
    const double t47 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t47;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t47;
    /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
    const double t48 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t49 = t10 - t12;
    const double t50 = V*t49 + t48*z2_2;
    const double t51 = t48*z1_2 + t49*v1_2;
    const double t52 = V*p2;
    const double t53 = (1.0/(omega2*omega2));
    const double t54 = sin_omega2_tau1*t53;
    const double t55 = t52*t54 - t54*t6*v1_2;
    const double t56 = sin_omega1_tau1/(omega1*omega1);
    const double t57 = p1*v1_2;
    const double t58 = -t52*t56 - t56*t57;
    const double t59 = p2*z2_2;
    const double t60 = p1*z1_2;
    const double t61 = t59 + t60;
    const double t62 = t52*t9 + t57*t9;
    const double t63 = -t59 + t6*z1_2;
    const double t64 = -t11*t52 + t11*t6*v1_2;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t61 + cos_omega2_tau1_by_chi*t63 + omega1_by_chi*t58 + omega2_by_chi*t55 + p1_by_chi*t51 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t62 + sin_omega2_tau1_by_chi*t64 + t13*v1_2_by_chi + t7*z1_2_by_chi;
    const double t65 = -V*t49 - t48*z2_2;
    const double t66 = V*p1;
    const double t67 = p3*sin_omega2_tau1*t53*v1_2 - t54*t66;
    const double t68 = p3*v1_2;
    const double t69 = V*t6;
    const double t70 = -t56*t68 - t56*t69;
    const double t71 = p3*z1_2;
    const double t72 = t6*z2_2;
    const double t73 = t71 + t72;
    const double t74 = t68*t9 + t69*t9;
    const double t75 = p1*z2_2 - t71;
    const double t76 = t11*t66 - t11*t68;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t73 + cos_omega2_tau1_by_chi*t75 + omega1_by_chi*t70 + omega2_by_chi*t67 + p1_by_chi*t65 + p3_by_chi*t51 + sin_omega1_tau1_by_chi*t74 + sin_omega2_tau1_by_chi*t76 + t15*z1_2_by_chi + t17*v1_2_by_chi;
    const double t77 = -t19 + t20;
    const double t78 = V*t48 + t77*z2_2;
    const double t79 = t48*v1_2 + t77*z1_2;
    const double t80 = t6*z1_2;
    const double t81 = sin_omega2_tau1*t59 - sin_omega2_tau1*t80;
    const double t82 = -sin_omega1_tau1*t59 - sin_omega1_tau1*t60;
    const double t83 = t52 + t57;
    const double t84 = -omega1*t59 - omega1*t60;
    const double t85 = -t52 + t6*v1_2;
    const double t86 = omega2*t59 - omega2*t80;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t83 + cos_omega2_tau1_by_chi*t85 + omega1_by_chi*t82 + omega2_by_chi*t81 + p1_by_chi*t79 + p2_by_chi*t78 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t86 + t21*z1_2_by_chi + t7*v1_2_by_chi;
    const double t87 = -V*t48 - t77*z2_2;
    const double t88 = p1*z2_2;
    const double t89 = sin_omega2_tau1*t71 - sin_omega2_tau1*t88;
    const double t90 = -sin_omega1_tau1*t71 - sin_omega1_tau1*t72;
    const double t91 = t68 + t69;
    const double t92 = -omega1*t71 - omega1*t72;
    const double t93 = t66 - t68;
    const double t94 = omega2*t71 - omega2*t88;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t91 + cos_omega2_tau1_by_chi*t93 + omega1_by_chi*t90 + omega2_by_chi*t89 + p1_by_chi*t87 + p3_by_chi*t79 + sin_omega1_tau1_by_chi*t92 + sin_omega2_tau1_by_chi*t94 + t15*v1_2_by_chi + t25*z1_2_by_chi;
    /* d/deta of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t61 + cos_omega2_tau1_by_eta*t63 + omega1_by_eta*t58 + omega2_by_eta*t55 + p1_by_eta*t51 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t62 + sin_omega2_tau1_by_eta*t64;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t73 + cos_omega2_tau1_by_eta*t75 + omega1_by_eta*t70 + omega2_by_eta*t67 + p1_by_eta*t65 + p3_by_eta*t51 + sin_omega1_tau1_by_eta*t74 + sin_omega2_tau1_by_eta*t76;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t83 + cos_omega2_tau1_by_eta*t85 + omega1_by_eta*t82 + omega2_by_eta*t81 + p1_by_eta*t79 + p2_by_eta*t78 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t86;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t91 + cos_omega2_tau1_by_eta*t93 + omega1_by_eta*t90 + omega2_by_eta*t89 + p1_by_eta*t87 + p3_by_eta*t79 + sin_omega1_tau1_by_eta*t92 + sin_omega2_tau1_by_eta*t94;
    /* d/dV of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_V = t13*v1_2_by_V + t14 + t7*z1_2_by_V + t8*z2_2_by_V;
    const double z2_3_by_V = t15*z1_2_by_V + t16*z2_2_by_V + t17*v1_2_by_V + t18;
    const double v1_3_by_V = t21*z1_2_by_V + t22*z2_2_by_V + t7*v1_2_by_V + t8;
    const double v2_3_by_V = t15*v1_2_by_V + t16 + t25*z1_2_by_V - t26*z2_2_by_V;
    /* d/dchi of: functions of tau2 in stick-slip */
    const double t95 = omega3_by_chi*tau2;
    const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t95;
    const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t95;
    /* d/deta of: functions of tau2 in stick-slip */
    const double t96 = omega3_by_eta*tau2;
    const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t96;
    const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t96;
    /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
    const double t97 = sin_omega3_tau2/(omega3*omega3);
    const double t98 = V*t97 - t97*v2_3;
    const double t99 = -z1_3 + z2_3;
    const double t100 = -V*t31 + t31*v2_3;
    const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t99 + omega3_by_chi*t98 + sin_omega3_tau2_by_chi*t100 + t30*z1_3_by_chi + t32*v2_3_by_chi;
    const double t101 = t35 - t36;
    const double t102 = -V + v2_3;
    const double t103 = omega3*z1_3 - omega3*z2_3;
    const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t102 + omega3_by_chi*t101 + sin_omega3_tau2_by_chi*t103 + t41*z1_3_by_chi - t41*z2_3_by_chi;
    /* d/deta of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t99 + omega3_by_eta*t98 + sin_omega3_tau2_by_eta*t100 + t30*z1_3_by_eta + t32*v2_3_by_eta;
    const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t102 + omega3_by_eta*t101 + sin_omega3_tau2_by_eta*t103 + t41*z1_3_by_eta - t41*z2_3_by_eta;
    /* d/dV of: stick-slip for tau2, until second-reaches-belt */
    const double z1_4_by_V = tau2 + z1_3_by_V;
    const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t30*z1_3_by_V + t32*v2_3_by_V + t33;
    const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t41*z1_3_by_V - t41*z2_3_by_V + 1;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = -z2_1;
        parameter_jacobian[1*lanes + lane] = 0;
        parameter_jacobian[2*lanes + lane] = -chi*ta + ta;
        parameter_jacobian[3*lanes + lane] = -1;
        parameter_jacobian[4*lanes + lane] = 0;
        parameter_jacobian[5*lanes + lane] = -chi*z1_2_by_chi - z1_2 + z2_2;
        parameter_jacobian[6*lanes + lane] = 0;
        parameter_jacobian[7*lanes + lane] = -chi*z1_2_by_V + chi*z2_2_by_V;
        parameter_jacobian[8*lanes + lane] = 0;
        parameter_jacobian[9*lanes + lane] = -1;
        parameter_jacobian[10*lanes + lane] = v1_3_by_chi;
        parameter_jacobian[11*lanes + lane] = v1_3_by_eta;
        parameter_jacobian[12*lanes + lane] = v1_3_by_V - 1;
        parameter_jacobian[13*lanes + lane] = 0;
        parameter_jacobian[14*lanes + lane] = 0;
        parameter_jacobian[15*lanes + lane] = v2_4_by_chi;
        parameter_jacobian[16*lanes + lane] = v2_4_by_eta;
        parameter_jacobian[17*lanes + lane] = v2_4_by_V - 1;
        parameter_jacobian[18*lanes + lane] = 0;
        parameter_jacobian[19*lanes + lane] = 0;
        parameter_jacobian[20*lanes + lane] = z1_3_by_chi;
        parameter_jacobian[21*lanes + lane] = z1_3_by_eta;
        parameter_jacobian[22*lanes + lane] = z1_4_by_V;
        parameter_jacobian[23*lanes + lane] = 0;
        parameter_jacobian[24*lanes + lane] = 0;
        parameter_jacobian[25*lanes + lane] = z2_4_by_chi;
        parameter_jacobian[26*lanes + lane] = z2_4_by_eta;
        parameter_jacobian[27*lanes + lane] = z2_4_by_V;
        parameter_jacobian[28*lanes + lane] = 0;
        parameter_jacobian[29*lanes + lane] = 0;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_global_stick_equations(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    dry_friction_global_stick_equations_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, residual, jacobian, parameter_jacobian);
}

/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the parameters.
 * Operations: 758. Intermediate terms: 175. */
static NONSMOOTH_INLINE void dry_friction_global_stick_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane], e1 = parameters[3*lanes + lane],
        e2 = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double tau = unknowns[3*lanes + lane], tau1 = unknowns[4*lanes + lane];
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* z2_1: linear in second-breaks-forward */
    const double t0 = V*tau;
    const double t1 = chi - 1;
    const double t2 = (1.0/(t1));
    const double t3 = e1*t2;
    const double t4 = (1.0/(chi));
    const double t5 = e2*t4;
    const double z2_1 = V*sin_tau - cos_tau*t3 - t0 - t2*t5;
    /* slip-stick for tau */
    const double t6 = chi*z2_1;
    const double t7 = e1 + t6;
    const double t8 = chi*cos_tau;
    const double t9 = chi - t8;
    const double t10 = -chi*sin_tau + chi*tau;
    const double z1_2 = V*sin_tau + V*t10 + cos_tau*t7 + t9*z2_1;
    const double z2_2 = t0 + z2_1;
    const double v1_2 = V*cos_tau + V*t9 + sin_tau*t6 - sin_tau*t7;
    /* functions of tau1 in slip-slip */
    const double t11 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t11);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t12 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t12);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    /* slip-slip for tau1 */
    const double t13 = 1 - p1;
    const double t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t13;
    const double t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t16 = (1.0/(omega1));
    const double t17 = sin_omega1_tau1*t16;
    const double t18 = (1.0/(omega2));
    const double t19 = sin_omega2_tau1*t18;
    const double t20 = p1*t17 + t13*t19;
    const double t21 = p2*t17 - p2*t19;
    const double z1_3 = V*t21 + t14*z1_2 + t15*z2_2 + t20*v1_2;
    const double t22 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t23 = cos_omega1_tau1*t13 + cos_omega2_tau1*p1;
    const double t24 = p3*t17 - p3*t19;
    const double t25 = p1*t19 + t13*t17;
    const double z2_3 = V*t25 + t22*z1_2 + t23*z2_2 + t24*v1_2;
    const double t26 = omega1*sin_omega1_tau1;
    const double t27 = omega2*sin_omega2_tau1;
    const double t28 = -p1*t26 - t13*t27;
    const double t29 = -p2*t26 + p2*t27;
    const double v1_3 = V*t15 + t14*v1_2 + t28*z1_2 + t29*z2_2;
    const double t30 = -p3*t26 + p3*t27;
    const double t31 = -p1*t27 - t13*t26;
    const double v2_3 = V*t23 + t22*v1_2 + t30*z1_2 + t31*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t32 = -V*cos_tau;
    const double t33 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = -V - t2*t33 - t32;
    /* d/dtau of: slip-stick for tau */
    const double t34 = V*chi;
    const double t35 = V - t34;
    const double z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t35 + t33 + t34;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t35;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t20*v1_2_by_tau;
    const double z2_3_by_tau = t22*z1_2_by_tau + t23*z2_2_by_tau + t24*v1_2_by_tau;
    const double v1_3_by_tau = t14*v1_2_by_tau + t28*z1_2_by_tau + t29*z2_2_by_tau;
    const double v2_3_by_tau = t22*v1_2_by_tau + t30*z1_2_by_tau + t31*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t36 = chi*z2_3;
    const double v1_3_by_tau1 = t36 - z1_3;
    const double t37 = eta*z1_3;
    const double v2_3_by_tau1 = chi*t37 - eta*t36;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/dtau of: first return of tau2 */
    const double t38 = 2*cosine_part_tau2;
    const double t39 = 2*sine_part_tau2;
    const double t40 = sine_part_tau2_by_tau*t39 + t38*v2_3_by_tau;
    const double t41 = (1.0/(amplitude_tau2));
    const double t42 = (1.0/2.0)*t41;
    const double amplitude_tau2_by_tau = t40*t42;
    /* d/dtau1 of: first return of tau2 */
    const double t43 = sine_part_tau2_by_tau1*t39 + t38*v2_3_by_tau1;
    const double amplitude_tau2_by_tau1 = t42*t43;
    /* trace */
    const double t44 = (1.0/(z2_1_by_tau));
    const double t45 = (1.0/(omega3));
    const double t46 = t2*t45;
    const double t47 = (1.0/(v1_3_by_tau1));
    const double t48 = amplitude_tau2_by_tau1*v1_3_by_tau;
    const double t49 = t47*t48;
    const double t50 = amplitude_tau2_by_tau*t2*t45 - t46*t49;
    if (trace) {
        trace[lane] = t44*t50;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane],
        omega3_by_chi = spectrum_derivatives[12*lanes + lane],
        omega3_by_eta = spectrum_derivatives[13*lanes + lane];
    /* back through: d/dtau1 of: first return of tau2 */
    const double slope_by_amplitude_tau2_by_tau = t44*t46;
    const double t51 = slope_by_amplitude_tau2_by_tau*t47;
    const double slope_by_amplitude_tau2_by_tau1 = -t51*v1_3_by_tau;
    /* back through: d/dtau1 of: first return of tau2 */
    const double t52 = sine_part_tau2*t41;
    const double slope_by_sine_part_tau2_by_tau1 = slope_by_amplitude_tau2_by_tau1*t52;
    /* back through: d/dtau of: first return of tau2 */
    const double slope_by_sine_part_tau2_by_tau = slope_by_amplitude_tau2_by_tau*t52;
    /* back through: d/dtau1 of: slip-slip for tau1 */
    const double t53 = cosine_part_tau2*t41;
    const double slope_by_v2_3_by_tau1 = slope_by_amplitude_tau2_by_tau1*t53;
    const double slope_by_v1_3_by_tau1 = slope_by_amplitude_tau2_by_tau*t48/(v1_3_by_tau1*v1_3_by_tau1);
    /* back through: d/dtau of: slip-slip for tau1 */
    const double slope_by_v2_3_by_tau = slope_by_amplitude_tau2_by_tau*t53;
    const double slope_by_v1_3_by_tau = -amplitude_tau2_by_tau1*t51;
    const double slope_by_z1_3_by_tau = omega3*slope_by_sine_part_tau2_by_tau;
    const double slope_by_z2_3_by_tau = -slope_by_z1_3_by_tau;
    /* back through: d/dtau of: slip-stick for tau */
    const double slope_by_v1_2_by_tau = slope_by_v1_3_by_tau*t14 + slope_by_v2_3_by_tau*t22 + slope_by_z1_3_by_tau*t20 + slope_by_z2_3_by_tau*t24;
    const double slope_by_z2_2_by_tau = slope_by_v1_3_by_tau*t29 + slope_by_v2_3_by_tau*t31 + slope_by_z1_3_by_tau*t15 + slope_by_z2_3_by_tau*t23;
    const double slope_by_z1_2_by_tau = slope_by_v1_3_by_tau*t28 + slope_by_v2_3_by_tau*t30 + slope_by_z1_3_by_tau*t14 + slope_by_z2_3_by_tau*t22;
    /* back through: d/dtau of: z2_1: linear in second-breaks-forward */
    const double slope_by_z2_1_by_tau = chi*slope_by_z1_2_by_tau + slope_by_z2_2_by_tau - t50/(z2_1_by_tau*z2_1_by_tau);
    /* back through: d/dtau of: functions of tau in slip-stick */
    const double slope_by_sin_tau_by_tau = V*slope_by_z2_1_by_tau - e1*slope_by_v1_2_by_tau + slope_by_z1_2_by_tau*t35;
    const double slope_by_cos_tau_by_tau = e1*slope_by_z1_2_by_tau + slope_by_v1_2_by_tau*t35 - slope_by_z2_1_by_tau*t3;
    /* back through: first return of tau2 */
    const double t54 = (1.0/2.0)/(amplitude_tau2*amplitude_tau2);
    const double slope_by_amplitude_tau2 = -slope_by_amplitude_tau2_by_tau*t40*t54 - slope_by_amplitude_tau2_by_tau1*t43*t54;
    /* back through: first return of tau2 */
    const double t55 = slope_by_amplitude_tau2_by_tau*t41;
    const double t56 = slope_by_amplitude_tau2_by_tau1*t41;
    const double slope_by_sine_part_tau2 = sine_part_tau2_by_tau*t55 + sine_part_tau2_by_tau1*t56 + slope_by_amplitude_tau2*t52;
    const double slope_by_cosine_part_tau2 = slope_by_amplitude_tau2*t53 + t55*v2_3_by_tau + t56*v2_3_by_tau1;
    /* back through: slip-slip for tau1 */
    const double slope_by_v1_3 = omega3*slope_by_sine_part_tau2_by_tau1;
    const double slope_by_v2_3 = slope_by_cosine_part_tau2 - slope_by_v1_3;
    const double t57 = chi*eta*slope_by_v2_3_by_tau1 + omega3*slope_by_sine_part_tau2;
    const double slope_by_z2_3 = chi*slope_by_v1_3_by_tau1 - t57;
    const double slope_by_z1_3 = -slope_by_v1_3_by_tau1 + t57;
    /* back through: functions of tau1 in slip-slip */
    const double t58 = p3*z1_2_by_tau;
    const double t59 = p1*z2_2_by_tau;
    const double t60 = p2*z2_2_by_tau;
    const double t61 = t13*z1_2_by_tau;
    const double t62 = p3*z1_2;
    const double t63 = p1*z2_2;
    const double t64 = p2*z2_2;
    const double t65 = t13*z1_2;
    const double t66 = V*p1;
    const double t67 = p3*v1_2;
    const double t68 = V*p2;
    const double t69 = slope_by_z1_3_by_tau*v1_2_by_tau;
    const double t70 = t13*t69;
    const double t71 = p3*v1_2_by_tau;
    const double t72 = slope_by_z2_3_by_tau*t71;
    const double slope_by_sin_omega2_tau1 = slope_by_v1_3*(omega2*t64 - omega2*t65) + slope_by_v1_3_by_tau*(omega2*t60 - omega2*t61) + slope_by_v2_3*(omega2*t62 - omega2*t63) + slope_by_v2_3_by_tau*(omega2*t58 - omega2*t59) + slope_by_z1_3*(t13*t18*v1_2 - t18*t68) + slope_by_z2_3*(t18*t66 - t18*t67) + t18*t70 - t18*t72;
    const double t73 = slope_by_v1_3_by_tau*v1_2_by_tau;
    const double t74 = slope_by_v2_3_by_tau*t71;
    const double slope_by_cos_omega2_tau1 = slope_by_v1_3*(t13*v1_2 - t68) + slope_by_v2_3*(t66 - t67) + slope_by_z1_3*(t13*z1_2 - t64) + slope_by_z1_3_by_tau*(t13*z1_2_by_tau - t60) + slope_by_z2_3*(p1*z2_2 - t62) + slope_by_z2_3_by_tau*(p1*z2_2_by_tau - t58) + t13*t73 - t74;
    const double t75 = t13*z2_2_by_tau;
    const double t76 = p1*z1_2_by_tau;
    const double t77 = t13*z2_2;
    const double t78 = p1*z1_2;
    const double t79 = V*t13;
    const double t80 = p1*v1_2;
    const double t81 = p1*t69;
    const double slope_by_sin_omega1_tau1 = slope_by_v1_3*(-omega1*t64 - omega1*t78) + slope_by_v1_3_by_tau*(-omega1*t60 - omega1*t76) + slope_by_v2_3*(-omega1*t62 - omega1*t77) + slope_by_v2_3_by_tau*(-omega1*t58 - omega1*t75) + slope_by_z1_3*(t16*t68 + t16*t80) + slope_by_z2_3*(t16*t67 + t16*t79) + t16*t72 + t16*t81;
    const double slope_by_cos_omega1_tau1 = p1*t73 + slope_by_v1_3*(t68 + t80) + slope_by_v2_3*(t67 + t79) + slope_by_z1_3*(t64 + t78) + slope_by_z1_3_by_tau*(t60 + t76) + slope_by_z2_3*(t62 + t77) + slope_by_z2_3_by_tau*(t58 + t75) + t74;
    /* back through: slip-stick for tau */
    const double slope_by_v1_2 = slope_by_v1_3*t14 + slope_by_v2_3*t22 + slope_by_z1_3*t20 + slope_by_z2_3*t24;
    const double slope_by_z2_2 = slope_by_v1_3*t29 + slope_by_v2_3*t31 + slope_by_z1_3*t15 + slope_by_z2_3*t23;
    const double slope_by_z1_2 = slope_by_v1_3*t28 + slope_by_v2_3*t30 + slope_by_z1_3*t14 + slope_by_z2_3*t22;
    /* back through: z2_1: linear in second-breaks-forward */
    const double slope_by_z2_1 = chi*slope_by_z1_2 + slope_by_z2_2;
    /* back through: functions of tau in slip-stick */
    const double t82 = V*slope_by_z2_1;
    const double slope_by_sin_tau = -e1*slope_by_v1_2 + slope_by_z1_2*t35 + t82;
    const double slope_by_cos_tau = e1*slope_by_z1_2 + slope_by_v1_2*t35 - slope_by_z2_1*t3;
    /* trace_gradient */
    const double t83 = cos_omega2_tau1*slope_by_sin_omega2_tau1;
    const double t84 = cos_omega1_tau1*slope_by_sin_omega1_tau1;
    const double t85 = sin_omega2_tau1*slope_by_cos_omega2_tau1;
    const double t86 = sin_omega1_tau1*slope_by_cos_omega1_tau1;
    const double t87 = t2/(omega3*omega3);
    const double t88 = slope_by_sine_part_tau2*(z1_3 - z2_3) + slope_by_sine_part_tau2_by_tau*(z1_3_by_tau - z2_3_by_tau) + slope_by_sine_part_tau2_by_tau1*(v1_3 - v2_3) + t44*(-amplitude_tau2_by_tau*t87 + t49*t87);
    const double t89 = -t26 + t27;
    const double t90 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t91 = t89*z1_2_by_tau + t90*v1_2_by_tau;
    const double t92 = t17 - t19;
    const double t93 = t90*z1_2_by_tau + t92*v1_2_by_tau;
    const double t94 = t89*z1_2 + t90*v1_2;
    const double t95 = t90*z1_2 + t92*v1_2;
    const double t96 = slope_by_v2_3*t94 + slope_by_v2_3_by_tau*t91 + slope_by_z2_3*t95 + slope_by_z2_3_by_tau*t93;
    const double t97 = slope_by_v1_3*(V*t90 + t89*z2_2) + slope_by_v1_3_by_tau*t89*z2_2_by_tau + slope_by_z1_3*(V*t92 + t90*z2_2) + slope_by_z1_3_by_tau*t90*z2_2_by_tau;
    const double t98 = slope_by_v1_3*t94 + slope_by_v1_3_by_tau*t91 + slope_by_v2_3*(-V*t90 - t89*z2_2) - slope_by_v2_3_by_tau*t89*z2_2_by_tau + slope_by_z1_3*t95 + slope_by_z1_3_by_tau*t93 + slope_by_z2_3*(-V*t92 - t90*z2_2) - slope_by_z2_3_by_tau*t90*z2_2_by_tau;
    const double t99 = (1.0/(omega2*omega2));
    const double t100 = sin_omega2_tau1*t99;
    const double t101 = slope_by_v1_3*(sin_omega2_tau1*t64 - sin_omega2_tau1*t65) + slope_by_v1_3_by_tau*(sin_omega2_tau1*t60 - sin_omega2_tau1*t61) + slope_by_v2_3*(sin_omega2_tau1*t62 - sin_omega2_tau1*t63) + slope_by_v2_3_by_tau*(sin_omega2_tau1*t58 - sin_omega2_tau1*t59) + slope_by_z1_3*(-t100*t13*v1_2 + t100*t68) + slope_by_z2_3*(p3*sin_omega2_tau1*t99*v1_2 - t100*t66) - t100*t70 + t100*t72 + t83*tau1 - t85*tau1;
    const double t102 = sin_omega1_tau1/(omega1*omega1);
    const double t103 = slope_by_v1_3*(-sin_omega1_tau1*t64 - sin_omega1_tau1*t78) + slope_by_v1_3_by_tau*(-sin_omega1_tau1*t60 - sin_omega1_tau1*t76) + slope_by_v2_3*(-sin_omega1_tau1*t62 - sin_omega1_tau1*t77) + slope_by_v2_3_by_tau*(-sin_omega1_tau1*t58 - sin_omega1_tau1*t75) + slope_by_z1_3*(-t102*t68 - t102*t80) + slope_by_z2_3*(-t102*t67 - t102*t79) - t102*t72 - t102*t81 + t84*tau1 - t86*tau1;
    const double t104 = 1 - cos_tau;
    const double t105 = -sin_tau + tau;
    const double t106 = (1.0/(t1*t1));
    const double t107 = t106*t45;
    const double t108 = cos_tau_by_tau*slope_by_v1_2_by_tau;
    const double t109 = slope_by_z2_1*t2;
    if (trace_gradient) {
        trace_gradient[lane] = 0;
        trace_gradient[1*lanes + lane] = 0;
        trace_gradient[2*lanes + lane] = 0;
        trace_gradient[3*lanes + lane] = V*chi*slope_by_z1_2 + V*slope_by_z2_2 - cos_tau*slope_by_cos_tau_by_tau + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau - sin_tau*slope_by_sin_tau_by_tau - t82;
        trace_gradient[4*lanes + lane] = omega1*t84 - omega1*t86 + omega2*t83 - omega2*t85;
        trace_gradient[5*lanes + lane] = 0;
        trace_gradient[6*lanes + lane] = V*slope_by_v1_2*t104 - V*t108 + omega1_by_chi*t103 + omega2_by_chi*t101 + omega3_by_chi*t88 + p1_by_chi*t98 + p2_by_chi*t97 + p3_by_chi*t96 + slope_by_v1_3_by_tau1*z2_3 + slope_by_v2_3_by_tau1*(-eta*z2_3 + t37) + slope_by_z1_2*(V*t105 + cos_tau*z2_1 + t104*z2_1) + slope_by_z1_2_by_tau*(t32 + z2_2_by_tau) + slope_by_z2_1*(cos_tau*e1*t106 + t106*t5 + e2*t2/(chi*chi)) + slope_by_z2_1_by_tau*t106*t33 + t44*(-amplitude_tau2_by_tau*t107 + t107*t49);
        trace_gradient[7*lanes + lane] = omega1_by_eta*t103 + omega2_by_eta*t101 + omega3_by_eta*t88 + p1_by_eta*t98 + p2_by_eta*t97 + p3_by_eta*t96 + slope_by_v2_3_by_tau1*(chi*z1_3 - t36);
        trace_gradient[8*lanes + lane] = -slope_by_cosine_part_tau2 + slope_by_v1_2*(chi + cos_tau - t8) + slope_by_v1_3*t15 + slope_by_v2_3*t23 + slope_by_z1_2*(sin_tau + t10) + slope_by_z1_2_by_tau*(chi - cos_tau*t1) + slope_by_z1_3*t21 - slope_by_z2_1*t105 + slope_by_z2_1_by_tau*(cos_tau - 1) + slope_by_z2_2*tau + slope_by_z2_2_by_tau + slope_by_z2_3*t25 - t1*t108;
        trace_gradient[9*lanes + lane] = -cos_tau*slope_by_v1_2_by_tau + cos_tau*slope_by_z1_2 - cos_tau*t109 + cos_tau_by_tau*slope_by_z1_2_by_tau - cos_tau_by_tau*slope_by_z2_1_by_tau*t2 - sin_tau*slope_by_v1_2;
        trace_gradient[10*lanes + lane] = -t109*t4;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_global_stick_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    dry_friction_global_stick_trace_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, trace, trace_gradient);
}

/* State at the start and behind each transition. Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after the other; and the frequencies of each phase.
 * Operations: 185. Intermediate terms: 52. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_passage(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *states,
    double *coefficients, double *frequencies)
{
    const double chi = parameters[0], V = parameters[2], e1 = parameters[3], e2 = parameters[4];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double z10 = unknowns[0], z20 = unknowns[1], ta = unknowns[2], tau = unknowns[3],
        tau1 = unknowns[4], tau2 = unknowns[5];
    /* stick-stick for ta, until first-breaks-forward */
    const double t0 = V*ta;
    const double z1_1 = t0 + z10;
    const double z2_1 = t0 + z20;
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t1 = -chi*cos_tau + chi;
    const double t2 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + t1*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double v1_2 = V*cos_tau + V*t1 - sin_tau*z1_1 + t2*z2_1;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t3);
    const double sin_omega1_tau1 = sin(t3);
    const double t4 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t4);
    const double sin_omega2_tau1 = sin(t4);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t5 = 1 - p1;
    const double t6 = sin_omega1_tau1/omega1;
    const double t7 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*t6 - p2*t7) + v1_2*(p1*t6 + t5*t7) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t5) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t8 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t9 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t8*z1_2 + t9*z2_2 + v1_2*(p3*t6 - p3*t7);
    const double t10 = omega2*sin_omega2_tau1;
    const double t11 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t9 + t8*v1_2 + z1_2*(p3*t10 - p3*t11) + z2_2*(-p1*t10 - t11*t5);
    /* functions of tau2 in stick-slip */
    const double t12 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t12);
    const double sin_omega3_tau2 = sin(t12);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t13 = (1.0/(omega3));
    const double t14 = sin_omega3_tau2*t13;
    const double z2_4 = V*(-t14 + tau2) + cos_omega3_tau2*z2_3 + t14*v2_3 + z1_3*(1 - cos_omega3_tau2);
    if (states) {
        states[0] = z10;
        states[1] = z20;
        states[2] = V;
        states[3] = V;
        states[4] = z1_1;
        states[5] = z2_1;
        states[6] = V;
        states[7] = V;
        states[8] = z1_2;
        states[9] = z2_2;
        states[10] = v1_2;
        states[11] = V;
        states[12] = z1_3;
        states[13] = z2_3;
        states[14] = V;
        states[15] = v2_3;
        states[16] = z1_4;
        states[17] = z2_4;
        states[18] = V;
        states[19] = V;
    }
    if (!coefficients && !frequencies)
        return;
    /* coefficients */
    const double t15 = chi*z20;
    const double t16 = V*chi;
    const double t17 = -V + t16;
    const double t18 = chi*z10;
    const double t19 = chi*z2_1;
    const double t20 = t19 - z1_1;
    const double t21 = (chi*chi);
    const double t22 = t21*z2_1;
    const double t23 = V*t21 - t16;
    const double t24 = -chi*t20;
    const double t25 = -chi*t17;
    const double t26 = V*p2;
    const double t27 = p2*z2_2;
    const double t28 = omega1*z1_2;
    const double t29 = omega2*z1_2;
    const double t30 = p3*v1_2;
    const double t31 = chi*z1_3;
    const double t32 = chi*(-z1_3 + z2_3);
    const double t33 = chi*(-V*t13 + t13*v2_3);
    if (coefficients) {
        for (int i = 0; i < 44; ++i)
            coefficients[i] = 0.0;
        coefficients[0] = -e1 - t15 + z10;
        coefficients[1] = -t17;
        coefficients[2] = -e1 + t15 - z10;
        coefficients[3] = t17;
        coefficients[4] = -e2 + t15 - t18;
        coefficients[6] = -e2 - t15 + t18;
        coefficients[8] = t17;
        coefficients[10] = -t17;
        coefficients[11] = t20;
        coefficients[12] = -e2 + t19 - t22;
        coefficients[13] = -t23;
        coefficients[14] = -t24;
        coefficients[15] = -t25;
        coefficients[16] = -e2 - t19 + t22;
        coefficients[17] = t23;
        coefficients[18] = t24;
        coefficients[19] = t25;
        coefficients[20] = -V;
        coefficients[22] = p1*v1_2 + t26;
        coefficients[23] = -t26 + t5*v1_2;
        coefficients[24] = -omega1*t27 - p1*t28;
        coefficients[25] = omega2*t27 - t29*t5;
        coefficients[26] = -V;
        coefficients[28] = V*t5 + t30;
        coefficients[29] = V*p1 - t30;
        coefficients[30] = -omega1*t5*z2_2 - p3*t28;
        coefficients[31] = -omega2*p1*z2_2 + p3*t29;
        coefficients[32] = -e1 - t31 + z1_3;
        coefficients[33] = -t17;
        coefficients[34] = -t32;
        coefficients[35] = -t33;
        coefficients[36] = -e1 + t31 - z1_3;
        coefficients[37] = t17;
        coefficients[38] = t32;
        coefficients[39] = t33;
        coefficients[42] = -V + v2_3;
        coefficients[43] = omega3*z1_3 - omega3*z2_3;
    }
    if (!frequencies)
        return;
    if (frequencies) {
        frequencies[0] = 1;
        frequencies[1] = omega1;
        frequencies[2] = omega2;
        frequencies[3] = omega3;
    }
}

/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the other; monodromy matrix.
 * Operations: 495. Intermediate terms: 176. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_linearisation(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    double *poincare_jacobian, double *saltations, double *monodromy)
{
    const double chi = parameters[0], eta = parameters[1], V = parameters[2];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double z10 = unknowns[0], z20 = unknowns[1], ta = unknowns[2], tau = unknowns[3],
        tau1 = unknowns[4], tau2 = unknowns[5];
    /* stick-stick for ta, until first-breaks-forward */
    const double t0 = V*ta;
    const double z1_1 = t0 + z10;
    const double z2_1 = t0 + z20;
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t1 = chi*cos_tau;
    const double t2 = chi - t1;
    const double t3 = chi*sin_tau;
    const double t4 = chi*tau - t3;
    const double z1_2 = V*sin_tau + V*t4 + cos_tau*z1_1 + t2*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double v1_2 = V*cos_tau + V*t2 - sin_tau*z1_1 + t3*z2_1;
    /* functions of tau1 in slip-slip */
    const double t5 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t5);
    const double sin_omega1_tau1 = sin(t5);
    const double t6 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t6);
    const double sin_omega2_tau1 = sin(t6);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t7 = 1 - p1;
    const double t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7;
    const double t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t10 = sin_omega1_tau1/omega1;
    const double t11 = sin_omega2_tau1/omega2;
    const double t12 = p1*t10 + t11*t7;
    const double t13 = p2*t10 - p2*t11;
    const double z1_3 = V*t13 + t12*v1_2 + t8*z1_2 + t9*z2_2;
    const double t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t15 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double t16 = p3*t10 - p3*t11;
    const double t17 = p1*t11 + t10*t7;
    const double z2_3 = V*t17 + t14*z1_2 + t15*z2_2 + t16*v1_2;
    const double t18 = omega1*sin_omega1_tau1;
    const double t19 = omega2*sin_omega2_tau1;
    const double t20 = -p1*t18 - t19*t7;
    const double t21 = -p2*t18 + p2*t19;
    const double v1_3 = V*t9 + t20*z1_2 + t21*z2_2 + t8*v1_2;
    const double t22 = -p3*t18 + p3*t19;
    const double t23 = p1*t19;
    const double t24 = t18*t7;
    const double t25 = -t23 - t24;
    const double v2_3 = V*t15 + t14*v1_2 + t22*z1_2 + t25*z2_2;
    /* functions of tau2 in stick-slip */
    const double t26 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t26);
    const double sin_omega3_tau2 = sin(t26);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t27 = 1 - cos_omega3_tau2;
    const double t28 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t28 + tau2) + cos_omega3_tau2*z2_3 + t27*z1_3 + t28*v2_3;
    const double t29 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t27 + cos_omega3_tau2*v2_3 + t29*z1_3 - t29*z2_3;
    /* rate of the exit boundary after ta */
    const double t30 = V*chi;
    const double rate_1 = V - t30;
    /* derivatives of the time to the boundary after ta */
    const double t31 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t31;
    const double delay_ta_by_z20 = chi*t31;
    /* perturbation on the boundary after ta */
    const double z2_1_on_boundary_by_z10 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t3*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t3*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t30;
    /* derivatives of the time to the boundary after tau */
    const double t32 = (1.0/(rate_2));
    const double delay_tau_by_z10 = t32*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20 = t32*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t33 = chi*z2_2;
    const double before_v1_2 = t33 - z1_2;
    const double v1_2_on_boundary_by_z10 = before_v1_2*delay_tau_by_z10 + carried_v1_2_by_z10;
    const double v1_2_on_boundary_by_z20 = before_v1_2*delay_tau_by_z20 + carried_v1_2_by_z20;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t8*z1_2_on_boundary_by_z10 + t9*z2_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t8*z1_2_on_boundary_by_z20 + t9*z2_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t14*z1_2_on_boundary_by_z10 + t15*z2_2_on_boundary_by_z10 + t16*v1_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t14*z1_2_on_boundary_by_z20 + t15*z2_2_on_boundary_by_z20 + t16*v1_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t20*z1_2_on_boundary_by_z10 + t21*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t20*z1_2_on_boundary_by_z20 + t21*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t14*v1_2_on_boundary_by_z10 + t22*z1_2_on_boundary_by_z10 + t25*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t14*v1_2_on_boundary_by_z20 + t22*z1_2_on_boundary_by_z20 + t25*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t34 = chi*z2_3;
    const double rate_3 = t34 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t35 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t35;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t35;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t36 = chi*eta;
    const double before_v2_3 = -eta*t34 + t36*z1_3;
    const double v2_3_on_boundary_by_z10 = before_v2_3*delay_tau1_by_z10 + carried_v2_3_by_z10;
    const double v2_3_on_boundary_by_z20 = before_v2_3*delay_tau1_by_z20 + carried_v2_3_by_z20;
    /* Phi along tau2 */
    const double carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t27*z1_3_on_boundary_by_z10 + t28*v2_3_on_boundary_by_z10;
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t27*z1_3_on_boundary_by_z20 + t28*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t29*z1_3_on_boundary_by_z10 - t29*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t29*z1_3_on_boundary_by_z20 - t29*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t36*z1_4 - t36*z2_4;
    /* derivatives of the time to the boundary after tau2 */
    const double t37 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t37;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t37;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20;
    const double z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    if (poincare_jacobian) {
        poincare_jacobian[0] = z1_4_on_boundary_by_z10;
        poincare_jacobian[1] = z1_4_on_boundary_by_z20;
        poincare_jacobian[2] = z2_4_on_boundary_by_z10;
        poincare_jacobian[3] = z2_4_on_boundary_by_z20;
    }
    if (!saltations && !monodromy)
        return;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z2_1 - z1_1;
    /* vector fields at transition 2 */
    const double behind_v2_2 = -eta*t33 + t36*z1_2;
    /* saltations */
    const double saltation_1_20 = behind_v1_1/rate_1;
    const double t38 = chi*saltation_1_20;
    const double t39 = chi/rate_2;
    const double t40 = 0;
    const double t41 = behind_v2_2*t39;
    const double t42 = (1.0/(rate_3));
    const double t43 = t42*(V - v1_3);
    const double t44 = 0;
    const double t45 = (V - v2_4)/rate_4;
    if (saltations) {
        for (int i = 0; i < 64; ++i)
            saltations[i] = 0.0;
        saltations[0] = 1;
        saltations[5] = 1;
        saltations[8] = saltation_1_20;
        saltations[9] = -t38;
        saltations[10] = 1;
        saltations[15] = 1;
        saltations[16] = 1;
        saltations[21] = 1;
        saltations[24] = -t40;
        saltations[25] = t40;
        saltations[26] = 1;
        saltations[28] = -t41;
        saltations[29] = t41;
        saltations[31] = 1;
        saltations[32] = 1;
        saltations[34] = t43;
        saltations[37] = 1;
        saltations[46] = t44;
        saltations[47] = 1;
        saltations[48] = 1;
        saltations[53] = 1;
        saltations[55] = t45;
        saltations[58] = 1;
    }
    if (!monodromy)
        return;
    /* saltation of phase 1 */
    const double saltation_1_21 = -t38;
    const double saltation_1_22 = saltation_1_20*ta + 1;
    const double saltation_1_23 = -t38*ta;
    /* Phi of phase 2 */
    const double phi_2_00 = cos_tau + saltation_1_20*sin_tau;
    const double t46 = chi - t1;
    const double phi_2_01 = saltation_1_21*sin_tau + t46;
    const double phi_2_02 = cos_tau*ta + saltation_1_22*sin_tau;
    const double phi_2_03 = saltation_1_23*sin_tau + t2*ta + t4;
    const double phi_2_13 = ta + tau;
    const double phi_2_20 = cos_tau*saltation_1_20 - sin_tau;
    const double phi_2_21 = cos_tau*saltation_1_21 + t3;
    const double phi_2_22 = cos_tau*saltation_1_22 - sin_tau*ta;
    const double phi_2_23 = cos_tau*saltation_1_23 + t3*ta + t46;
    /* saltation of phase 2 */
    const double saltation_2_20 = -phi_2_00*t40 + phi_2_20;
    const double saltation_2_21 = -phi_2_01*t40 + phi_2_21 + t40;
    const double saltation_2_22 = -phi_2_02*t40 + phi_2_22;
    const double saltation_2_23 = -phi_2_03*t40 + phi_2_13*t40 + phi_2_23;
    const double saltation_2_30 = -phi_2_00*t41;
    const double saltation_2_31 = -phi_2_01*t41 + t41;
    const double saltation_2_32 = -phi_2_02*t41;
    const double saltation_2_33 = -phi_2_03*t41 + phi_2_13*t41 + 1;
    /* Phi of phase 3 */
    const double phi_3_00 = phi_2_00*t8 + saltation_2_20*t12 + saltation_2_30*t13;
    const double phi_3_01 = phi_2_01*t8 + saltation_2_21*t12 + saltation_2_31*t13 + t9;
    const double phi_3_02 = phi_2_02*t8 + saltation_2_22*t12 + saltation_2_32*t13;
    const double phi_3_03 = phi_2_03*t8 + phi_2_13*t9 + saltation_2_23*t12 + saltation_2_33*t13;
    const double phi_3_10 = phi_2_00*t14 + saltation_2_20*t16 + saltation_2_30*t17;
    const double phi_3_11 = phi_2_01*t14 + saltation_2_21*t16 + saltation_2_31*t17 + t15;
    const double phi_3_12 = phi_2_02*t14 + saltation_2_22*t16 + saltation_2_32*t17;
    const double phi_3_13 = phi_2_03*t14 + phi_2_13*t15 + saltation_2_23*t16 + saltation_2_33*t17;
    const double phi_3_20 = phi_2_00*t20 + saltation_2_20*t8 + saltation_2_30*t9;
    const double phi_3_21 = phi_2_01*t20 + saltation_2_21*t8 + saltation_2_31*t9 + t21;
    const double phi_3_22 = phi_2_02*t20 + saltation_2_22*t8 + saltation_2_32*t9;
    const double phi_3_23 = phi_2_03*t20 + phi_2_13*t21 + saltation_2_23*t8 + saltation_2_33*t9;
    const double phi_3_30 = phi_2_00*t22 + saltation_2_20*t14 + saltation_2_30*t15;
    const double phi_3_31 = phi_2_01*t22 + saltation_2_21*t14 + saltation_2_31*t15 - t23 - t24;
    const double phi_3_32 = phi_2_02*t22 + saltation_2_22*t14 + saltation_2_32*t15;
    const double phi_3_33 = phi_2_03*t22 + phi_2_13*t25 + saltation_2_23*t14 + saltation_2_33*t15;
    /* saltation of phase 3 */
    const double saltation_3_00 = phi_3_00 + phi_3_20*t43;
    const double saltation_3_01 = phi_3_01 + phi_3_21*t43;
    const double saltation_3_02 = phi_3_02 + phi_3_22*t43;
    const double saltation_3_03 = phi_3_03 + phi_3_23*t43;
    const double saltation_3_30 = phi_3_20*t44 + phi_3_30;
    const double saltation_3_31 = phi_3_21*t44 + phi_3_31;
    const double saltation_3_32 = phi_3_22*t44 + phi_3_32;
    const double saltation_3_33 = phi_3_23*t44 + phi_3_33;
    /* Phi of phase 4 */
    const double phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t27 + saltation_3_30*t28;
    const double phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t27 + saltation_3_31*t28;
    const double phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t27 + saltation_3_32*t28;
    const double phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t27 + saltation_3_33*t28;
    const double phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t29 + saltation_3_00*t29;
    const double phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t29 + saltation_3_01*t29;
    const double phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t29 + saltation_3_02*t29;
    const double phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t29 + saltation_3_03*t29;
    /* saltation of phase 4 */
    const double saltation_4_10 = phi_4_10 + phi_4_30*t45;
    const double saltation_4_11 = phi_4_11 + phi_4_31*t45;
    const double saltation_4_12 = phi_4_12 + phi_4_32*t45;
    const double saltation_4_13 = phi_4_13 + phi_4_33*t45;
    if (monodromy) {
        for (int i = 0; i < 16; ++i)
            monodromy[i] = 0.0;
        monodromy[0] = saltation_3_00;
        monodromy[1] = saltation_3_01;
        monodromy[2] = saltation_3_02;
        monodromy[3] = saltation_3_03;
        monodromy[4] = saltation_4_10;
        monodromy[5] = saltation_4_11;
        monodromy[6] = saltation_4_12;
        monodromy[7] = saltation_4_13;
    }
}

/* State after a time in slip-stick.
 * Operations: 23. Intermediate terms: 4. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_flow_slip_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = sin(time);
    const double t1 = chi*t0;
    const double t2 = cos(time);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1);
    state_after[1] = time*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-slip.
 * Operations: 77. Intermediate terms: 15. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_flow_slip_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
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
    state_after[0] = t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6);
    state_after[2] = t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14);
    state_after[3] = t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6);
}

/* State after a time in stick-slip.
 * Operations: 23. Intermediate terms: 6. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_flow_stick_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[6];
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega3*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = omega3*t1;
    state_after[0] = time*v1 + z1;
    state_after[1] = t2*v2 + t3*z2 + t4*z1 + v1*(-t2 + time);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*z1 - t5*z2;
}

/* All unknowns from the reduced ones; the equations for these and their derivatives.
 * Operations: 217. Intermediate terms: 72. */
static NONSMOOTH_INLINE void dry_friction_global_stick_reduced_fixed_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *fixed)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane],
        e1 = parameters[3*lanes + lane];
    const double p1 = spectrum[3*lanes + lane], omega3 = spectrum[6*lanes + lane];
    const double t1 = (1.0/((chi - 1)));
    const double t2 = e1*t1;
    /* slip-slip for tau1 */
    const double t8 = 1 - p1;
    /* tau2: first return */
    const double t22 = (1.0/(omega3));
    /* d/dtau of: slip-stick for tau */
    const double t31 = V*chi;
    const double t32 = V - t31;
    fixed[lane] = t1;
    fixed[1*lanes + lane] = t2;
    fixed[2*lanes + lane] = t8;
    fixed[3*lanes + lane] = t22;
    fixed[4*lanes + lane] = t31;
    fixed[5*lanes + lane] = t32;
}

static NONSMOOTH_INLINE void dry_friction_global_stick_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *fixed,
    const double *reduced, double *unknowns, double *reduced_residual, double *reduced_jacobian)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane], e1 = parameters[3*lanes + lane],
        e2 = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double t1 = fixed[lane], t2 = fixed[1*lanes + lane], t8 = fixed[2*lanes + lane],
        t22 = fixed[3*lanes + lane], t31 = fixed[4*lanes + lane], t32 = fixed[5*lanes + lane];
    const double tau = reduced[lane], tau1 = reduced[1*lanes + lane];
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* z2_1: linear in second-breaks-forward */
    const double t0 = V*tau;
    const double z2_1 = V*sin_tau - cos_tau*t2 - t0 - e2*t1/chi;
    /* slip-stick for tau */
    const double t3 = chi*z2_1;
    const double t4 = e1 + t3;
    const double t5 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t4 + t5*z2_1;
    const double z2_2 = t0 + z2_1;
    const double v1_2 = V*cos_tau + V*t5 + sin_tau*t3 - sin_tau*t4;
    /* functions of tau1 in slip-slip */
    const double t6 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t6);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t7 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t7);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t11 = sin_omega1_tau1/omega1;
    const double t12 = sin_omega2_tau1/omega2;
    const double t13 = p1*t11 + t12*t8;
    const double z1_3 = V*(p2*t11 - p2*t12) + t10*z2_2 + t13*v1_2 + t9*z1_2;
    const double t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t15 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1;
    const double t16 = p3*t11 - p3*t12;
    const double z2_3 = V*(p1*t12 + t11*t8) + t14*z1_2 + t15*z2_2 + t16*v1_2;
    const double t17 = omega1*sin_omega1_tau1;
    const double t18 = omega2*sin_omega2_tau1;
    const double t19 = -p3*t17 + p3*t18;
    const double t20 = -p1*t18 - t17*t8;
    const double v2_3 = V*t15 + t14*v1_2 + t19*z1_2 + t20*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* first return of tau2 */
    const double t21 = (1.0/(amplitude_tau2));
    const double cos_tau2_return = sine_part_tau2*t21;
    const double sin_tau2_return = -cosine_part_tau2*t21;
    const double tau2 = t22*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
    /* ta: linear in time */
    const double t23 = chi*z2_3;
    const double t24 = sine_part_tau2*t22;
    const double t25 = V*tau2;
    const double t26 = amplitude_tau2*t22;
    const double ta = -t1*(chi*t24 + chi*t25 - chi*t26 + e1 + t23 - t24 - t25 - z2_3)/V;
    /* unknowns */
    const double t27 = t24 + t25 + z2_3;
    if (unknowns) {
        unknowns[lane] = t27;
        unknowns[1*lanes + lane] = -t26 + t27;
        unknowns[2*lanes + lane] = ta;
        unknowns[3*lanes + lane] = tau;
        unknowns[4*lanes + lane] = tau1;
        unknowns[5*lanes + lane] = tau2;
    }
    if (!reduced_residual && !reduced_jacobian)
        return;
    /* slip-slip for tau1 */
    const double t28 = -p1*t17 - t18*t8;
    const double t29 = -p2*t17 + p2*t18;
    const double v1_3 = V*t10 + t28*z1_2 + t29*z2_2 + t9*v1_2;
    if (reduced_residual) {
        reduced_residual[lane] = -V + v1_3;
        reduced_residual[1*lanes + lane] = amplitude_tau2*t1*t22 - t2 - z2_1;
    }
    if (!reduced_jacobian)
        return;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t30 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = V*cos_tau - V - t1*t30;
    const double z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t32 + t30 + t31;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t32;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t10*z2_2_by_tau + t13*v1_2_by_tau + t9*z1_2_by_tau;
    const double z2_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t16*v1_2_by_tau;
    const double v1_3_by_tau = t28*z1_2_by_tau + t29*z2_2_by_tau + t9*v1_2_by_tau;
    const double v2_3_by_tau = t14*v1_2_by_tau + t19*z1_2_by_tau + t20*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double v1_3_by_tau1 = t23 - z1_3;
    const double v2_3_by_tau1 = chi*eta*z1_3 - eta*t23;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/dtau of: first return of tau2 */
    const double t33 = 2*cosine_part_tau2;
    const double t34 = 2*sine_part_tau2;
    const double t35 = (1.0/2.0)*t21;
    const double amplitude_tau2_by_tau = t35*(sine_part_tau2_by_tau*t34 + t33*v2_3_by_tau);
    /* d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1 = t35*(sine_part_tau2_by_tau1*t34 + t33*v2_3_by_tau1);
    if (reduced_jacobian) {
        reduced_jacobian[lane] = v1_3_by_tau;
        reduced_jacobian[1*lanes + lane] = v1_3_by_tau1;
        reduced_jacobian[2*lanes + lane] = amplitude_tau2_by_tau*t1*t22 - z2_1_by_tau;
        reduced_jacobian[3*lanes + lane] = amplitude_tau2_by_tau1*t1*t22;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_global_stick_reduced(
    const double parameters[5], const double spectrum[7], const double reduced[2], double *unknowns,
    double *reduced_residual, double *reduced_jacobian)
{
    double fixed[6];
    dry_friction_global_stick_reduced_fixed_in_lane(1, 0, parameters, spectrum, fixed);
    dry_friction_global_stick_reduced_in_lane(1, 0, parameters, spectrum, fixed, reduced, unknowns,
        reduced_residual, reduced_jacobian);
}

/* Map [N, c] of a turn; the start that follows from the dwell times; compatibility and switching conditions. The start among the unknowns is not read.
 * Operations: 258. Intermediate terms: 83. */
NONSMOOTH_UNMERGED
void dry_friction_global_stick_period_map(
    const double parameters[5], const double spectrum[7], const double unknowns[6],
    double *period_map, double *linear_start, double *compatibility)
{
    const double chi = parameters[0], V = parameters[2], e1 = parameters[3], e2 = parameters[4];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double ta = unknowns[2], tau = unknowns[3], tau1 = unknowns[4], tau2 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick after tau, by the start */
    const double t0 = chi*cos_tau;
    const double z1_2_by_z20 = chi - t0;
    const double z1_2_by_v10 = cos_tau*ta + sin_tau;
    const double v1_2_by_z20 = chi*sin_tau;
    const double t1 = chi*tau - v1_2_by_z20;
    const double z1_2_by_v20 = t1 + ta*z1_2_by_z20;
    const double z2_2_by_v20 = ta + tau;
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_v10 = cos_tau - sin_tau*ta;
    const double v1_2_by_v20 = chi - t0 + ta*v1_2_by_z20;
    /* functions of tau1 in slip-slip */
    const double t2 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t2);
    const double sin_omega1_tau1 = sin(t2);
    const double t3 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t3);
    const double sin_omega2_tau1 = sin(t3);
    /* slip-slip after tau1, by the start */
    const double t4 = 1 - p1;
    const double t5 = cos_omega1_tau1*p1 + cos_omega2_tau1*t4;
    const double t6 = sin_omega1_tau1/omega1;
    const double t7 = sin_omega2_tau1/omega2;
    const double t8 = p1*t6 + t4*t7;
    const double z1_3_by_z10 = cos_tau*t5 + t8*v1_2_by_z10;
    const double t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3_by_z20 = t5*z1_2_by_z20 + t8*v1_2_by_z20 + t9;
    const double z1_3_by_v10 = t5*z1_2_by_v10 + t8*v1_2_by_v10;
    const double z1_3_by_v20 = p2*t6 - p2*t7 + t5*z1_2_by_v20 + t8*v1_2_by_v20 + t9*z2_2_by_v20;
    const double t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t11 = p3*t6 - p3*t7;
    const double z2_3_by_z10 = cos_tau*t10 + t11*v1_2_by_z10;
    const double t12 = cos_omega1_tau1*t4 + cos_omega2_tau1*p1;
    const double z2_3_by_z20 = t10*z1_2_by_z20 + t11*v1_2_by_z20 + t12;
    const double z2_3_by_v10 = t10*z1_2_by_v10 + t11*v1_2_by_v10;
    const double z2_3_by_v20 = p1*t7 + t10*z1_2_by_v20 + t11*v1_2_by_v20 + t12*z2_2_by_v20 + t4*t6;
    const double t13 = omega1*sin_omega1_tau1;
    const double t14 = omega2*sin_omega2_tau1;
    const double t15 = -p1*t13 - t14*t4;
    const double v1_3_by_z10 = cos_tau*t15 + t5*v1_2_by_z10;
    const double t16 = -p2*t13 + p2*t14;
    const double v1_3_by_z20 = t15*z1_2_by_z20 + t16 + t5*v1_2_by_z20;
    const double v1_3_by_v10 = t15*z1_2_by_v10 + t5*v1_2_by_v10;
    const double v1_3_by_v20 = t15*z1_2_by_v20 + t16*z2_2_by_v20 + t5*v1_2_by_v20 + t9;
    const double t17 = -p3*t13 + p3*t14;
    const double v2_3_by_z10 = cos_tau*t17 + t10*v1_2_by_z10;
    const double t18 = p1*t14 + t13*t4;
    const double v2_3_by_z20 = t10*v1_2_by_z20 + t17*z1_2_by_z20 - t18;
    const double v2_3_by_v10 = t10*v1_2_by_v10 + t17*z1_2_by_v10;
    const double v2_3_by_v20 = t10*v1_2_by_v20 + t12 + t17*z1_2_by_v20 - t18*z2_2_by_v20;
    /* functions of tau2 in stick-slip */
    const double t19 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t19);
    const double sin_omega3_tau2 = sin(t19);
    /* stick-slip after tau2, by the start */
    const double z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10;
    const double z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20;
    const double z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10;
    const double z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20;
    const double t20 = 1 - cos_omega3_tau2;
    const double t21 = sin_omega3_tau2/omega3;
    const double t22 = -t21 + tau2;
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t20*z1_3_by_z10 + t21*v2_3_by_z10 + t22*v1_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t20*z1_3_by_z20 + t21*v2_3_by_z20 + t22*v1_3_by_z20;
    const double z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t20*z1_3_by_v10 + t21*v2_3_by_v10 + t22*v1_3_by_v10;
    const double z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t20*z1_3_by_v20 + t21*v2_3_by_v20 + t22*v1_3_by_v20;
    const double t23 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t20*v1_3_by_z10 + t23*z1_3_by_z10 - t23*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t20*v1_3_by_z20 + t23*z1_3_by_z20 - t23*z2_3_by_z20;
    const double v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t20*v1_3_by_v10 + t23*z1_3_by_v10 - t23*z2_3_by_v10;
    const double v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t20*v1_3_by_v20 + t23*z1_3_by_v20 - t23*z2_3_by_v20;
    if (period_map) {
        for (int i = 0; i < 20; ++i)
            period_map[i] = 0.0;
        period_map[0] = z1_4_by_z10;
        period_map[1] = z1_4_by_z20;
        period_map[2] = z1_4_by_v10;
        period_map[3] = z1_4_by_v20;
        period_map[5] = z2_4_by_z10;
        period_map[6] = z2_4_by_z20;
        period_map[7] = z2_4_by_v10;
        period_map[8] = z2_4_by_v20;
        period_map[10] = v1_3_by_z10;
        period_map[11] = v1_3_by_z20;
        period_map[12] = v1_3_by_v10;
        period_map[13] = v1_3_by_v20;
        period_map[15] = v2_4_by_z10;
        period_map[16] = v2_4_by_z20;
        period_map[17] = v2_4_by_v10;
        period_map[18] = v2_4_by_v20;
    }
    if (!linear_start && !compatibility)
        return;
    /* coefficients of the linear equations */
    const double coefficient11 = z1_4_by_z10 - 1;
    const double coefficient22 = z2_4_by_z20 - 1;
    /* right-hand sides of the linear equations */
    const double right1 = -V*z1_4_by_v10 - V*z1_4_by_v20;
    const double right2 = -V*z2_4_by_v10 - V*z2_4_by_v20;
    /* determinant of the linear equations */
    const double determinant = coefficient11*coefficient22 - z1_4_by_z20*z2_4_by_z10;
    /* numerators of Cramer's rule */
    const double numerator1 = coefficient22*right1 - right2*z1_4_by_z20;
    const double numerator2 = coefficient11*right2 - right1*z2_4_by_z10;
    /* z10, z20 by Cramer's rule */
    const double t24 = (1.0/(determinant));
    const double z1_0 = numerator1*t24;
    const double z2_0 = numerator2*t24;
    if (linear_start) {
        linear_start[0] = z1_0;
        linear_start[1] = z2_0;
    }
    if (!compatibility)
        return;
    /* stick-stick for ta, until first-breaks-forward */
    const double t25 = V*ta;
    const double z1_1 = t25 + z1_0;
    const double z2_1 = t25 + z2_0;
    /* slip-stick for tau, until second-breaks-forward */
    const double z1_2 = V*sin_tau + V*t1 + cos_tau*z1_1 + z1_2_by_z20*z2_1;
    const double z2_2 = V*tau + z2_1;
    if (compatibility) {
        compatibility[0] = V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0;
        compatibility[1] = V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0;
        compatibility[2] = -chi*z2_1 - e1 + z1_1;
        compatibility[3] = -chi*z1_2 + chi*z2_2 - e2;
    }
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 673. Intermediate terms: 189. */
static NONSMOOTH_INLINE void dry_friction_solution_ii_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane],
        e2 = parameters[3*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double z10 = unknowns[lane], z20 = unknowns[1*lanes + lane],
        tau = unknowns[2*lanes + lane], tau1 = unknowns[3*lanes + lane],
        tau2 = unknowns[4*lanes + lane], e1 = unknowns[5*lanes + lane];
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* slip-stick for tau, until second-breaks-forward */
    const double t0 = chi*cos_tau;
    const double z1_2_by_z20 = chi - t0;
    const double t1 = chi*tau;
    const double v1_2_by_z20 = chi*sin_tau;
    const double t2 = t1 - v1_2_by_z20;
    const double z1_2 = V*sin_tau + V*t2 + cos_tau*z10 + z1_2_by_z20*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*z1_2_by_z20 - sin_tau*z10 + v1_2_by_z20*z20;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t4 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t4);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    /* slip-slip for tau1, until first-reaches-belt */
    const double t5 = 1 - p1;
    const double t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5;
    const double t7 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t8 = (1.0/(omega1));
    const double t9 = sin_omega1_tau1*t8;
    const double t10 = (1.0/(omega2));
    const double t11 = sin_omega2_tau1*t10;
    const double t12 = p1*t9 + t11*t5;
    const double t13 = -p2*t11 + p2*t9;
    const double z1_3 = V*t13 + t12*v1_2 + t6*z1_2 + t7*z2_2;
    const double t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t15 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1;
    const double t16 = -p3*t11 + p3*t9;
    const double t17 = p1*t11 + t5*t9;
    const double z2_3 = V*t17 + t14*z1_2 + t15*z2_2 + t16*v1_2;
    const double t18 = omega1*sin_omega1_tau1;
    const double t19 = omega2*sin_omega2_tau1;
    const double t20 = -p1*t18 - t19*t5;
    const double t21 = -p2*t18 + p2*t19;
    const double t22 = V*t7;
    const double v1_3 = t20*z1_2 + t21*z2_2 + t22 + t6*v1_2;
    const double t23 = -p3*t18 + p3*t19;
    const double t24 = p1*t19 + t18*t5;
    const double t25 = V*t15;
    const double v2_3 = t14*v1_2 + t23*z1_2 - t24*z2_2 + t25;
    /* functions of tau2 in stick-slip */
    const double t26 = omega3*tau2;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t26);
    const double cos_omega3_tau2 = wave_3.cosine;
    const double sin_omega3_tau2 = wave_3.sine;
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t27 = 1 - cos_omega3_tau2;
    const double t28 = (1.0/(omega3));
    const double t29 = sin_omega3_tau2*t28;
    const double t30 = -t29 + tau2;
    const double z2_4 = V*t30 + cos_omega3_tau2*z2_3 + t27*z1_3 + t29*v2_3;
    const double t31 = omega3*z1_3;
    const double t32 = omega3*z2_3;
    const double v2_4 = V*t27 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t31 - sin_omega3_tau2*t32;
    /* residual */
    const double t33 = chi*z20 - z10;
    if (residual) {
        residual[lane] = -e1 - t33;
        residual[1*lanes + lane] = -chi*z1_2 + chi*z2_2 - e2;
        residual[2*lanes + lane] = -V + v1_3;
        residual[3*lanes + lane] = -V + v2_4;
        residual[4*lanes + lane] = -z10 + z1_4;
        residual[5*lanes + lane] = -z20 + z2_4;
    }
    if (!jacobian && !parameter_jacobian)
        return;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    /* d/dz10 of: slip-stick for tau, until second-breaks-forward */
    const double v1_2_by_z10 = -sin_tau;
    /* d/dtau of: slip-stick for tau, until second-breaks-forward */
    const double t34 = V*chi;
    const double t35 = V - t34;
    const double z1_2_by_tau = cos_tau*t35 - cos_tau_by_tau*t33 + t34;
    const double v1_2_by_tau = cos_tau*t33 + cos_tau_by_tau*t35;
    /* d/dtau1 of: functions of tau1 in slip-slip */
    const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
    const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
    const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
    const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
    /* d/dz10 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z10 = cos_tau*t6 + t12*v1_2_by_z10;
    const double z2_3_by_z10 = cos_tau*t14 + t16*v1_2_by_z10;
    const double v1_3_by_z10 = cos_tau*t20 + t6*v1_2_by_z10;
    const double v2_3_by_z10 = cos_tau*t23 + t14*v1_2_by_z10;
    /* d/dz20 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z20 = t12*v1_2_by_z20 + t6*z1_2_by_z20 + t7;
    const double z2_3_by_z20 = t14*z1_2_by_z20 + t15 + t16*v1_2_by_z20;
    const double v1_3_by_z20 = t20*z1_2_by_z20 + t21 + t6*v1_2_by_z20;
    const double v2_3_by_z20 = t14*v1_2_by_z20 + t23*z1_2_by_z20 - t24;
    /* d/dtau of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_tau = t12*v1_2_by_tau + t22 + t6*z1_2_by_tau;
    const double z2_3_by_tau = t14*z1_2_by_tau + t16*v1_2_by_tau + t25;
    const double v1_3_by_tau = V*t21 + t20*z1_2_by_tau + t6*v1_2_by_tau;
    const double v2_3_by_tau = -V*t24 + t14*v1_2_by_tau + t23*z1_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1, until first-reaches-belt */
    const double t36 = p2*z2_2;
    const double t37 = p1*z1_2;
    const double t38 = t36 + t37;
    const double t39 = V*p2;
    const double t40 = p1*v1_2;
    const double t41 = t39*t8 + t40*t8;
    const double t42 = -t36 + t5*z1_2;
    const double t43 = -t10*t39 + t10*t5*v1_2;
    const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t38 + cos_omega2_tau1_by_tau1*t42 + sin_omega1_tau1_by_tau1*t41 + sin_omega2_tau1_by_tau1*t43;
    const double t44 = p3*z1_2;
    const double t45 = t5*z2_2;
    const double t46 = t44 + t45;
    const double t47 = p3*v1_2;
    const double t48 = V*t5;
    const double t49 = t47*t8 + t48*t8;
    const double t50 = p1*z2_2 - t44;
    const double t51 = V*p1;
    const double t52 = -t10*t47 + t10*t51;
    const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t46 + cos_omega2_tau1_by_tau1*t50 + sin_omega1_tau1_by_tau1*t49 + sin_omega2_tau1_by_tau1*t52;
    const double t53 = t39 + t40;
    const double t54 = -omega1*t36 - omega1*t37;
    const double t55 = -t39 + t5*v1_2;
    const double t56 = t5*z1_2;
    const double t57 = omega2*t36 - omega2*t56;
    const double v1_3_by_tau1 = cos_omega1_tau1_by_tau1*t53 + cos_omega2_tau1_by_tau1*t55 + sin_omega1_tau1_by_tau1*t54 + sin_omega2_tau1_by_tau1*t57;
    const double t58 = t47 + t48;
    const double t59 = -omega1*t44 - omega1*t45;
    const double t60 = -t47 + t51;
    const double t61 = p1*z2_2;
    const double t62 = omega2*t44 - omega2*t61;
    const double v2_3_by_tau1 = cos_omega1_tau1_by_tau1*t58 + cos_omega2_tau1_by_tau1*t60 + sin_omega1_tau1_by_tau1*t59 + sin_omega2_tau1_by_tau1*t62;
    /* d/dtau2 of: functions of tau2 in stick-slip */
    const double cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2;
    const double sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3;
    /* d/dz10 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t27*z1_3_by_z10 + t29*v2_3_by_z10;
    const double t63 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t63*z1_3_by_z10 - t63*z2_3_by_z10;
    /* d/dz20 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t27*z1_3_by_z20 + t29*v2_3_by_z20;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t63*z1_3_by_z20 - t63*z2_3_by_z20;
    /* d/dtau of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t27*z1_3_by_tau + t29*v2_3_by_tau;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t63*z1_3_by_tau - t63*z2_3_by_tau;
    /* d/dtau1 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t27*z1_3_by_tau1 + t29*v2_3_by_tau1;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t63*z1_3_by_tau1 - t63*z2_3_by_tau1;
    /* d/dtau2 of: stick-slip for tau2, until second-reaches-belt */
    const double t64 = -z1_3 + z2_3;
    const double t65 = -V*t28 + t28*v2_3;
    const double z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*t64 + sin_omega3_tau2_by_tau2*t65;
    const double t66 = -V + v2_3;
    const double t67 = t31 - t32;
    const double v2_4_by_tau2 = cos_omega3_tau2_by_tau2*t66 + sin_omega3_tau2_by_tau2*t67;
    if (jacobian) {
        jacobian[lane] = 1;
        jacobian[1*lanes + lane] = -chi;
        jacobian[2*lanes + lane] = 0;
        jacobian[3*lanes + lane] = 0;
        jacobian[4*lanes + lane] = 0;
        jacobian[5*lanes + lane] = -1;
        jacobian[6*lanes + lane] = -t0;
        jacobian[7*lanes + lane] = -chi*z1_2_by_z20 + chi;
        jacobian[8*lanes + lane] = -chi*z1_2_by_tau + t34;
        jacobian[9*lanes + lane] = 0;
        jacobian[10*lanes + lane] = 0;
        jacobian[11*lanes + lane] = 0;
        jacobian[12*lanes + lane] = v1_3_by_z10;
        jacobian[13*lanes + lane] = v1_3_by_z20;
        jacobian[14*lanes + lane] = v1_3_by_tau;
        jacobian[15*lanes + lane] = v1_3_by_tau1;
        jacobian[16*lanes + lane] = 0;
        jacobian[17*lanes + lane] = 0;
        jacobian[18*lanes + lane] = v2_4_by_z10;
        jacobian[19*lanes + lane] = v2_4_by_z20;
        jacobian[20*lanes + lane] = v2_4_by_tau;
        jacobian[21*lanes + lane] = v2_4_by_tau1;
        jacobian[22*lanes + lane] = v2_4_by_tau2;
        jacobian[23*lanes + lane] = 0;
        jacobian[24*lanes + lane] = z1_3_by_z10 - 1;
        jacobian[25*lanes + lane] = z1_3_by_z20;
        jacobian[26*lanes + lane] = z1_3_by_tau;
        jacobian[27*lanes + lane] = z1_3_by_tau1;
        jacobian[28*lanes + lane] = V;
        jacobian[29*lanes + lane] = 0;
        jacobian[30*lanes + lane] = z2_4_by_z10;
        jacobian[31*lanes + lane] = z2_4_by_z20 - 1;
        jacobian[32*lanes + lane] = z2_4_by_tau;
        jacobian[33*lanes + lane] = z2_4_by_tau1;
        jacobian[34*lanes + lane] = z2_4_by_tau2;
        jacobian[35*lanes + lane] = 0;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane],
        omega3_by_chi = spectrum_derivatives[12*lanes + lane],
        omega3_by_eta = spectrum_derivatives[13*lanes + lane];
    /* d/dchi of: slip-stick for tau, until second-breaks-forward */
    const double t68 = 1 - cos_tau;
    const double z1_2_by_chi = V*(-sin_tau + tau) + t68*z20;
    const double v1_2_by_chi = V*t68 + sin_tau*z20;
    /* d/dV of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_V = sin_tau + t2;
    const double v1_2_by_V = chi + cos_tau - t0;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t69 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t69;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t69;
    const double t70 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t70;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t70;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t71 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t71;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t71;
    const double t72 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t72;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t72;
    /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
    const double t73 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t74 = -t11 + t9;
    const double t75 = V*t74 + t73*z2_2;
    const double t76 = t73*z1_2 + t74*v1_2;
    const double t77 = (1.0/(omega2*omega2));
    const double t78 = sin_omega2_tau1*t77;
    const double t79 = t39*t78 - t5*t78*v1_2;
    const double t80 = sin_omega1_tau1/(omega1*omega1);
    const double t81 = -t39*t80 - t40*t80;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t38 + cos_omega2_tau1_by_chi*t42 + omega1_by_chi*t81 + omega2_by_chi*t79 + p1_by_chi*t76 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t41 + sin_omega2_tau1_by_chi*t43 + t12*v1_2_by_chi + t6*z1_2_by_chi;
    const double t82 = -V*t74 - t73*z2_2;
    const double t83 = p3*sin_omega2_tau1*t77*v1_2 - t51*t78;
    const double t84 = -t47*t80 - t48*t80;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t46 + cos_omega2_tau1_by_chi*t50 + omega1_by_chi*t84 + omega2_by_chi*t83 + p1_by_chi*t82 + p3_by_chi*t76 + sin_omega1_tau1_by_chi*t49 + sin_omega2_tau1_by_chi*t52 + t14*z1_2_by_chi + t16*v1_2_by_chi;
    const double t85 = -t18 + t19;
    const double t86 = V*t73 + t85*z2_2;
    const double t87 = t73*v1_2 + t85*z1_2;
    const double t88 = sin_omega2_tau1*t36 - sin_omega2_tau1*t56;
    const double t89 = -sin_omega1_tau1*t36 - sin_omega1_tau1*t37;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t53 + cos_omega2_tau1_by_chi*t55 + omega1_by_chi*t89 + omega2_by_chi*t88 + p1_by_chi*t87 + p2_by_chi*t86 + sin_omega1_tau1_by_chi*t54 + sin_omega2_tau1_by_chi*t57 + t20*z1_2_by_chi + t6*v1_2_by_chi;
    const double t90 = -V*t73 - t85*z2_2;
    const double t91 = sin_omega2_tau1*t44 - sin_omega2_tau1*t61;
    const double t92 = -sin_omega1_tau1*t44 - sin_omega1_tau1*t45;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t58 + cos_omega2_tau1_by_chi*t60 + omega1_by_chi*t92 + omega2_by_chi*t91 + p1_by_chi*t90 + p3_by_chi*t87 + sin_omega1_tau1_by_chi*t59 + sin_omega2_tau1_by_chi*t62 + t14*v1_2_by_chi + t23*z1_2_by_chi;
    /* d/deta of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t38 + cos_omega2_tau1_by_eta*t42 + omega1_by_eta*t81 + omega2_by_eta*t79 + p1_by_eta*t76 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t41 + sin_omega2_tau1_by_eta*t43;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t46 + cos_omega2_tau1_by_eta*t50 + omega1_by_eta*t84 + omega2_by_eta*t83 + p1_by_eta*t82 + p3_by_eta*t76 + sin_omega1_tau1_by_eta*t49 + sin_omega2_tau1_by_eta*t52;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t53 + cos_omega2_tau1_by_eta*t55 + omega1_by_eta*t89 + omega2_by_eta*t88 + p1_by_eta*t87 + p2_by_eta*t86 + sin_omega1_tau1_by_eta*t54 + sin_omega2_tau1_by_eta*t57;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t58 + cos_omega2_tau1_by_eta*t60 + omega1_by_eta*t92 + omega2_by_eta*t91 + p1_by_eta*t90 + p3_by_eta*t87 + sin_omega1_tau1_by_eta*t59 + sin_omega2_tau1_by_eta*t62;
    /* d/dV of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_V = t12*v1_2_by_V + t13 + t6*z1_2_by_V + t7*tau;
    const double z2_3_by_V = t14*z1_2_by_V + t15*tau + t16*v1_2_by_V + t17;
    const double v1_3_by_V = t20*z1_2_by_V + t21*tau + t6*v1_2_by_V + t7;
    const double v2_3_by_V = t14*v1_2_by_V + t15 + t23*z1_2_by_V - t24*tau;
    /* d/dchi of: functions of tau2 in stick-slip */
    const double t93 = omega3_by_chi*tau2;
    const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t93;
    const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t93;
    /* d/deta of: functions of tau2 in stick-slip */
    const double t94 = omega3_by_eta*tau2;
    const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t94;
    const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t94;
    /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
    const double t95 = sin_omega3_tau2/(omega3*omega3);
    const double t96 = V*t95 - t95*v2_3;
    const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t64 + omega3_by_chi*t96 + sin_omega3_tau2_by_chi*t65 + t27*z1_3_by_chi + t29*v2_3_by_chi;
    const double t97 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3;
    const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t66 + omega3_by_chi*t97 + sin_omega3_tau2_by_chi*t67 + t63*z1_3_by_chi - t63*z2_3_by_chi;
    /* d/deta of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t64 + omega3_by_eta*t96 + sin_omega3_tau2_by_eta*t65 + t27*z1_3_by_eta + t29*v2_3_by_eta;
    const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t66 + omega3_by_eta*t97 + sin_omega3_tau2_by_eta*t67 + t63*z1_3_by_eta - t63*z2_3_by_eta;
    /* d/dV of: stick-slip for tau2, until second-reaches-belt */
    const double z1_4_by_V = tau2 + z1_3_by_V;
    const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t27*z1_3_by_V + t29*v2_3_by_V + t30;
    const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t63*z1_3_by_V - t63*z2_3_by_V + 1;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = -z20;
        parameter_jacobian[1*lanes + lane] = 0;
        parameter_jacobian[2*lanes + lane] = 0;
        parameter_jacobian[3*lanes + lane] = 0;
        parameter_jacobian[4*lanes + lane] = -chi*z1_2_by_chi - z1_2 + z2_2;
        parameter_jacobian[5*lanes + lane] = 0;
        parameter_jacobian[6*lanes + lane] = -chi*z1_2_by_V + t1;
        parameter_jacobian[7*lanes + lane] = -1;
        parameter_jacobian[8*lanes + lane] = v1_3_by_chi;
        parameter_jacobian[9*lanes + lane] = v1_3_by_eta;
        parameter_jacobian[10*lanes + lane] = v1_3_by_V - 1;
        parameter_jacobian[11*lanes + lane] = 0;
        parameter_jacobian[12*lanes + lane] = v2_4_by_chi;
        parameter_jacobian[13*lanes + lane] = v2_4_by_eta;
        parameter_jacobian[14*lanes + lane] = v2_4_by_V - 1;
        parameter_jacobian[15*lanes + lane] = 0;
        parameter_jacobian[16*lanes + lane] = z1_3_by_chi;
        parameter_jacobian[17*lanes + lane] = z1_3_by_eta;
        parameter_jacobian[18*lanes + lane] = z1_4_by_V;
        parameter_jacobian[19*lanes + lane] = 0;
        parameter_jacobian[20*lanes + lane] = z2_4_by_chi;
        parameter_jacobian[21*lanes + lane] = z2_4_by_eta;
        parameter_jacobian[22*lanes + lane] = z2_4_by_V;
        parameter_jacobian[23*lanes + lane] = 0;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_solution_ii_equations(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    dry_friction_solution_ii_equations_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, residual, jacobian, parameter_jacobian);
}

/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the parameters.
 * Operations: 1107. Intermediate terms: 250. */
static NONSMOOTH_INLINE void dry_friction_solution_ii_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double z10 = unknowns[lane], z20 = unknowns[1*lanes + lane],
        tau = unknowns[2*lanes + lane], tau1 = unknowns[3*lanes + lane],
        tau2 = unknowns[4*lanes + lane];
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* slip-stick for tau, until second-breaks-forward */
    const double t0 = chi*cos_tau;
    const double t1 = chi - t0;
    const double t2 = chi*sin_tau;
    const double t3 = chi*tau - t2;
    const double z1_2 = V*sin_tau + V*t3 + cos_tau*z10 + t1*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t1 - sin_tau*z10 + t2*z20;
    /* functions of tau1 in slip-slip */
    const double t4 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t4);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t5 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t5);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    /* slip-slip for tau1, until first-reaches-belt */
    const double t6 = 1 - p1;
    const double t7 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t9 = (1.0/(omega1));
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = (1.0/(omega2));
    const double t12 = sin_omega2_tau1*t11;
    const double t13 = p1*t10 + t12*t6;
    const double t14 = p2*t10 - p2*t12;
    const double z1_3 = V*t14 + t13*v1_2 + t7*z1_2 + t8*z2_2;
    const double t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t16 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double t17 = p3*t10 - p3*t12;
    const double t18 = p1*t12 + t10*t6;
    const double z2_3 = V*t18 + t15*z1_2 + t16*z2_2 + t17*v1_2;
    const double t19 = omega1*sin_omega1_tau1;
    const double t20 = omega2*sin_omega2_tau1;
    const double t21 = -p1*t19 - t20*t6;
    const double t22 = -p2*t19 + p2*t20;
    const double v1_3 = V*t8 + t21*z1_2 + t22*z2_2 + t7*v1_2;
    const double t23 = -p3*t19 + p3*t20;
    const double t24 = -p1*t20 - t19*t6;
    const double v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t24*z2_2;
    /* functions of tau2 in stick-slip */
    const double t25 = omega3*tau2;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t25);
    const double cos_omega3_tau2 = wave_3.cosine;
    const double sin_omega3_tau2 = wave_3.sine;
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t26 = 1 - cos_omega3_tau2;
    const double t27 = (1.0/(omega3));
    const double t28 = sin_omega3_tau2*t27;
    const double t29 = -t28 + tau2;
    const double z2_4 = V*t29 + cos_omega3_tau2*z2_3 + t26*z1_3 + t28*v2_3;
    const double t30 = omega3*z1_3;
    const double t31 = omega3*z2_3;
    const double v2_4 = V*t26 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t30 - sin_omega3_tau2*t31;
    /* rate of the exit boundary after ta */
    const double t32 = V*chi;
    const double rate_1 = V - t32;
    /* derivatives of the time to the boundary after ta */
    const double t33 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t33;
    const double delay_ta_by_z20 = chi*t33;
    /* perturbation on the boundary after ta */
    const double z2_1_on_boundary_by_z10 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t32;
    /* derivatives of the time to the boundary after tau */
    const double t34 = (1.0/(rate_2));
    const double t35 = chi*z2_1_on_boundary_by_z10;
    const double t36 = carried_z1_2_by_z10*chi - t35;
    const double delay_tau_by_z10 = t34*t36;
    const double t37 = chi*z2_1_on_boundary_by_z20;
    const double t38 = carried_z1_2_by_z20*chi - t37;
    const double delay_tau_by_z20 = t34*t38;
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t39 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t39;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t39;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t13*v1_2_on_boundary_by_z10 + t7*z1_2_on_boundary_by_z10 + t8*z2_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t13*v1_2_on_boundary_by_z20 + t7*z1_2_on_boundary_by_z20 + t8*z2_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t15*z1_2_on_boundary_by_z10 + t16*z2_2_on_boundary_by_z10 + t17*v1_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t15*z1_2_on_boundary_by_z20 + t16*z2_2_on_boundary_by_z20 + t17*v1_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t21*z1_2_on_boundary_by_z10 + t22*z2_2_on_boundary_by_z10 + t7*v1_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t21*z1_2_on_boundary_by_z20 + t22*z2_2_on_boundary_by_z20 + t7*v1_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t15*v1_2_on_boundary_by_z10 + t23*z1_2_on_boundary_by_z10 + t24*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t15*v1_2_on_boundary_by_z20 + t23*z1_2_on_boundary_by_z20 + t24*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t40 = chi*z2_3;
    const double rate_3 = t40 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t41 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t41;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t41;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t42 = eta*z1_3;
    const double t43 = chi*t42 - eta*t40;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t43;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t43;
    /* Phi along tau2 */
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t26*z1_3_on_boundary_by_z20 + t28*v2_3_on_boundary_by_z20;
    const double t44 = omega3*z1_3_on_boundary_by_z10;
    const double t45 = omega3*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2*t44 - sin_omega3_tau2*t45;
    const double t46 = omega3*z1_3_on_boundary_by_z20;
    const double t47 = omega3*z2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2*t46 - sin_omega3_tau2*t47;
    /* rate of the exit boundary after tau2 */
    const double t48 = eta*z1_4;
    const double t49 = eta*z2_4;
    const double rate_4 = chi*t48 - chi*t49;
    /* derivatives of the time to the boundary after tau2 */
    const double t50 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t50;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t50;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    if (trace) {
        trace[lane] = z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_chi = spectrum_derivatives[2*lanes + lane],
        omega1_by_eta = spectrum_derivatives[3*lanes + lane],
        omega2_by_chi = spectrum_derivatives[4*lanes + lane],
        omega2_by_eta = spectrum_derivatives[5*lanes + lane],
        p1_by_chi = spectrum_derivatives[6*lanes + lane],
        p1_by_eta = spectrum_derivatives[7*lanes + lane],
        p2_by_chi = spectrum_derivatives[8*lanes + lane],
        p2_by_eta = spectrum_derivatives[9*lanes + lane],
        p3_by_chi = spectrum_derivatives[10*lanes + lane],
        p3_by_eta = spectrum_derivatives[11*lanes + lane],
        omega3_by_chi = spectrum_derivatives[12*lanes + lane],
        omega3_by_eta = spectrum_derivatives[13*lanes + lane];
    /* back through: rate of the exit boundary after tau2 */
    const double t51 = (1.0/(rate_4*rate_4));
    const double slope_by_rate_4 = V*carried_v2_4_by_z10*t51 + carried_v2_4_by_z20*t51*v2_4;
    /* back through: Phi along tau2 */
    const double slope_by_carried_v2_4_by_z20 = -t50*v2_4;
    const double slope_by_carried_v2_4_by_z10 = -V*t50;
    /* back through: perturbation on the boundary after tau1 */
    const double slope_by_v2_3_on_boundary_by_z20 = cos_omega3_tau2*slope_by_carried_v2_4_by_z20 + t28;
    const double slope_by_v2_3_on_boundary_by_z10 = cos_omega3_tau2*slope_by_carried_v2_4_by_z10;
    const double t52 = omega3*sin_omega3_tau2;
    const double t53 = -cos_omega3_tau2 + slope_by_carried_v2_4_by_z20*t52;
    const double slope_by_z2_3_on_boundary_by_z20 = -t53;
    const double t54 = slope_by_carried_v2_4_by_z10*t52;
    const double slope_by_z2_3_on_boundary_by_z10 = -t54;
    const double slope_by_z1_3_on_boundary_by_z20 = t53 + 1;
    const double slope_by_z1_3_on_boundary_by_z10 = t54 + 1;
    /* back through: derivatives of the time to the boundary after tau1 */
    const double slope_by_delay_tau1_by_z20 = slope_by_v2_3_on_boundary_by_z20*t43 + slope_by_z1_3_on_boundary_by_z20*v1_3 + slope_by_z2_3_on_boundary_by_z20*v2_3;
    const double slope_by_delay_tau1_by_z10 = slope_by_v2_3_on_boundary_by_z10*t43 + slope_by_z1_3_on_boundary_by_z10*v1_3 + slope_by_z2_3_on_boundary_by_z10*v2_3;
    /* back through: rate of the exit boundary after tau1 */
    const double t55 = (1.0/(rate_3*rate_3));
    const double slope_by_rate_3 = carried_v1_3_by_z10*slope_by_delay_tau1_by_z10*t55 + carried_v1_3_by_z20*slope_by_delay_tau1_by_z20*t55;
    /* back through: Phi along tau1 */
    const double slope_by_carried_v1_3_by_z20 = -slope_by_delay_tau1_by_z20*t41;
    const double slope_by_carried_v1_3_by_z10 = -slope_by_delay_tau1_by_z10*t41;
    /* back through: perturbation on the boundary after tau */
    const double slope_by_v1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t7 + slope_by_v2_3_on_boundary_by_z20*t15 + slope_by_z1_3_on_boundary_by_z20*t13 + slope_by_z2_3_on_boundary_by_z20*t17;
    const double slope_by_v1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t7 + slope_by_v2_3_on_boundary_by_z10*t15 + slope_by_z1_3_on_boundary_by_z10*t13 + slope_by_z2_3_on_boundary_by_z10*t17;
    const double slope_by_z2_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t22 + slope_by_v2_3_on_boundary_by_z20*t24 + slope_by_z1_3_on_boundary_by_z20*t8 + slope_by_z2_3_on_boundary_by_z20*t16;
    const double slope_by_z2_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t22 + slope_by_v2_3_on_boundary_by_z10*t24 + slope_by_z1_3_on_boundary_by_z10*t8 + slope_by_z2_3_on_boundary_by_z10*t16;
    const double slope_by_z1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t21 + slope_by_v2_3_on_boundary_by_z20*t23 + slope_by_z1_3_on_boundary_by_z20*t7 + slope_by_z2_3_on_boundary_by_z20*t15;
    const double slope_by_z1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t21 + slope_by_v2_3_on_boundary_by_z10*t23 + slope_by_z1_3_on_boundary_by_z10*t7 + slope_by_z2_3_on_boundary_by_z10*t15;
    /* back through: derivatives of the time to the boundary after tau */
    const double slope_by_delay_tau_by_z20 = V*slope_by_z2_2_on_boundary_by_z20 + slope_by_v1_2_on_boundary_by_z20*t39 + slope_by_z1_2_on_boundary_by_z20*v1_2;
    const double slope_by_delay_tau_by_z10 = V*slope_by_z2_2_on_boundary_by_z10 + slope_by_v1_2_on_boundary_by_z10*t39 + slope_by_z1_2_on_boundary_by_z10*v1_2;
    /* back through: rate of the exit boundary after tau */
    const double t56 = (1.0/(rate_2*rate_2));
    const double slope_by_rate_2 = -slope_by_delay_tau_by_z10*t36*t56 - slope_by_delay_tau_by_z20*t38*t56;
    /* back through: Phi along tau */
    const double t57 = chi*t34;
    const double t58 = slope_by_delay_tau_by_z20*t57;
    const double slope_by_carried_z1_2_by_z20 = slope_by_z1_2_on_boundary_by_z20 + t58;
    const double t59 = slope_by_delay_tau_by_z10*t57;
    const double slope_by_carried_z1_2_by_z10 = slope_by_z1_2_on_boundary_by_z10 + t59;
    /* back through: perturbation on the boundary after ta */
    const double slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t1 + slope_by_v1_2_on_boundary_by_z20*t2 + slope_by_z2_2_on_boundary_by_z20 - t58;
    const double slope_by_z2_1_on_boundary_by_z10 = slope_by_carried_z1_2_by_z10*t1 + slope_by_v1_2_on_boundary_by_z10*t2 + slope_by_z2_2_on_boundary_by_z10 - t59;
    const double t60 = sin_tau*slope_by_v1_2_on_boundary_by_z20;
    const double slope_by_z1_1_on_boundary_by_z20 = cos_tau*slope_by_carried_z1_2_by_z20 - t60;
    const double t61 = sin_tau*slope_by_v1_2_on_boundary_by_z10;
    const double slope_by_z1_1_on_boundary_by_z10 = cos_tau*slope_by_carried_z1_2_by_z10 - t61;
    /* back through: derivatives of the time to the boundary after ta */
    const double slope_by_delay_ta_by_z20 = V*slope_by_z1_1_on_boundary_by_z20 + V*slope_by_z2_1_on_boundary_by_z20;
    const double slope_by_delay_ta_by_z10 = V*slope_by_z1_1_on_boundary_by_z10 + V*slope_by_z2_1_on_boundary_by_z10;
    /* back through: rate of the exit boundary after ta */
    const double t62 = (1.0/(rate_1*rate_1));
    const double slope_by_rate_1 = -chi*slope_by_delay_ta_by_z20*t62 + slope_by_delay_ta_by_z10*t62;
    /* back through: stick-slip for tau2, until second-reaches-belt */
    const double t63 = chi*eta;
    const double slope_by_z1_4 = slope_by_rate_4*t63;
    const double slope_by_z2_4 = -slope_by_z1_4;
    /* back through: functions of tau2 in stick-slip */
    const double slope_by_sin_omega3_tau2 = delay_tau2_by_z20*(t30 - t31) + slope_by_carried_v2_4_by_z10*(t44 - t45) + slope_by_carried_v2_4_by_z20*(t46 - t47) + slope_by_z2_4*(-V*t27 + t27*v2_3) + t27*v2_3_on_boundary_by_z20;
    const double slope_by_cos_omega3_tau2 = delay_tau2_by_z20*(-V + v2_3) + slope_by_carried_v2_4_by_z10*v2_3_on_boundary_by_z10 + slope_by_carried_v2_4_by_z20*v2_3_on_boundary_by_z20 + slope_by_z2_4*(-z1_3 + z2_3) - z1_3_on_boundary_by_z20 + z2_3_on_boundary_by_z20;
    /* back through: slip-slip for tau1, until first-reaches-belt */
    const double slope_by_v2_3 = cos_omega3_tau2*delay_tau2_by_z20 + delay_tau1_by_z10*slope_by_z2_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z2_3_on_boundary_by_z20 + slope_by_z2_4*t28;
    const double slope_by_v1_3 = delay_tau1_by_z10*slope_by_z1_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z1_3_on_boundary_by_z20;
    const double t64 = delay_tau1_by_z10*slope_by_v2_3_on_boundary_by_z10;
    const double t65 = delay_tau1_by_z20*slope_by_v2_3_on_boundary_by_z20;
    const double t66 = delay_tau2_by_z20*t52 + t63*t64 + t63*t65;
    const double slope_by_z2_3 = chi*slope_by_rate_3 + cos_omega3_tau2*slope_by_z2_4 - t66;
    const double slope_by_z1_3 = -slope_by_rate_3 + slope_by_z1_4 + slope_by_z2_4*t26 + t66;
    /* back through: functions of tau1 in slip-slip */
    const double t67 = p3*z1_2_on_boundary_by_z20;
    const double t68 = p1*z2_2_on_boundary_by_z20;
    const double t69 = p3*z1_2_on_boundary_by_z10;
    const double t70 = p1*z2_2_on_boundary_by_z10;
    const double t71 = p2*z2_2_on_boundary_by_z20;
    const double t72 = t6*z1_2_on_boundary_by_z20;
    const double t73 = p2*z2_2_on_boundary_by_z10;
    const double t74 = t6*z1_2_on_boundary_by_z10;
    const double t75 = p3*z1_2;
    const double t76 = p1*z2_2;
    const double t77 = p2*z2_2;
    const double t78 = t6*z1_2;
    const double t79 = V*p1;
    const double t80 = p3*v1_2;
    const double t81 = V*p2;
    const double t82 = t11*t6;
    const double t83 = slope_by_z1_3_on_boundary_by_z10*v1_2_on_boundary_by_z10;
    const double t84 = slope_by_z1_3_on_boundary_by_z20*v1_2_on_boundary_by_z20;
    const double t85 = p3*v1_2_on_boundary_by_z10;
    const double t86 = slope_by_z2_3_on_boundary_by_z10*t85;
    const double t87 = p3*v1_2_on_boundary_by_z20;
    const double t88 = slope_by_z2_3_on_boundary_by_z20*t87;
    const double slope_by_sin_omega2_tau1 = slope_by_carried_v1_3_by_z10*(omega2*t73 - omega2*t74) + slope_by_carried_v1_3_by_z20*(omega2*t71 - omega2*t72) + slope_by_v1_3*(omega2*t77 - omega2*t78) + slope_by_v2_3*(omega2*t75 - omega2*t76) + slope_by_v2_3_on_boundary_by_z10*(omega2*t69 - omega2*t70) + slope_by_v2_3_on_boundary_by_z20*(omega2*t67 - omega2*t68) + slope_by_z1_3*(t11*t6*v1_2 - t11*t81) + slope_by_z2_3*(t11*t79 - t11*t80) - t11*t86 - t11*t88 + t82*t83 + t82*t84;
    const double t89 = slope_by_carried_v1_3_by_z10*v1_2_on_boundary_by_z10;
    const double t90 = slope_by_carried_v1_3_by_z20*v1_2_on_boundary_by_z20;
    const double t91 = slope_by_v2_3_on_boundary_by_z10*t85;
    const double t92 = slope_by_v2_3_on_boundary_by_z20*t87;
    const double slope_by_cos_omega2_tau1 = slope_by_v1_3*(t6*v1_2 - t81) + slope_by_v2_3*(t79 - t80) + slope_by_z1_3*(t6*z1_2 - t77) + slope_by_z1_3_on_boundary_by_z10*(t6*z1_2_on_boundary_by_z10 - t73) + slope_by_z1_3_on_boundary_by_z20*(t6*z1_2_on_boundary_by_z20 - t71) + slope_by_z2_3*(p1*z2_2 - t75) + slope_by_z2_3_on_boundary_by_z10*(p1*z2_2_on_boundary_by_z10 - t69) + slope_by_z2_3_on_boundary_by_z20*(p1*z2_2_on_boundary_by_z20 - t67) + t6*t89 + t6*t90 - t91 - t92;
    const double t93 = t6*z2_2_on_boundary_by_z20;
    const double t94 = t6*z2_2_on_boundary_by_z10;
    const double t95 = p1*z1_2_on_boundary_by_z20;
    const double t96 = p1*z1_2_on_boundary_by_z10;
    const double t97 = t6*z2_2;
    const double t98 = p1*z1_2;
    const double t99 = V*t6;
    const double t100 = p1*v1_2;
    const double t101 = p1*t9;
    const double slope_by_sin_omega1_tau1 = slope_by_carried_v1_3_by_z10*(-omega1*t73 - omega1*t96) + slope_by_carried_v1_3_by_z20*(-omega1*t71 - omega1*t95) + slope_by_v1_3*(-omega1*t77 - omega1*t98) + slope_by_v2_3*(-omega1*t75 - omega1*t97) + slope_by_v2_3_on_boundary_by_z10*(-omega1*t69 - omega1*t94) + slope_by_v2_3_on_boundary_by_z20*(-omega1*t67 - omega1*t93) + slope_by_z1_3*(t100*t9 + t81*t9) + slope_by_z2_3*(t80*t9 + t9*t99) + t101*t83 + t101*t84 + t86*t9 + t88*t9;
    const double slope_by_cos_omega1_tau1 = p1*t89 + p1*t90 + slope_by_v1_3*(t100 + t81) + slope_by_v2_3*(t80 + t99) + slope_by_z1_3*(t77 + t98) + slope_by_z1_3_on_boundary_by_z10*(t73 + t96) + slope_by_z1_3_on_boundary_by_z20*(t71 + t95) + slope_by_z2_3*(t75 + t97) + slope_by_z2_3_on_boundary_by_z10*(t69 + t94) + slope_by_z2_3_on_boundary_by_z20*(t67 + t93) + t91 + t92;
    /* back through: slip-stick for tau, until second-breaks-forward */
    const double t102 = chi*slope_by_rate_2;
    const double slope_by_v1_2 = delay_tau_by_z10*slope_by_z1_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z1_2_on_boundary_by_z20 + slope_by_v1_3*t7 + slope_by_v2_3*t15 + slope_by_z1_3*t13 + slope_by_z2_3*t17 - t102;
    const double t103 = delay_tau_by_z10*slope_by_v1_2_on_boundary_by_z10;
    const double t104 = delay_tau_by_z20*slope_by_v1_2_on_boundary_by_z20;
    const double slope_by_z2_2 = chi*t103 + chi*t104 + slope_by_v1_3*t22 + slope_by_v2_3*t24 + slope_by_z1_3*t8 + slope_by_z2_3*t16;
    const double slope_by_z1_2 = slope_by_v1_3*t21 + slope_by_v2_3*t23 + slope_by_z1_3*t7 + slope_by_z2_3*t15 - t103 - t104;
    /* back through: functions of tau in slip-stick */
    const double t105 = t37 - z1_1_on_boundary_by_z20;
    const double t106 = t35 - z1_1_on_boundary_by_z10;
    const double t107 = chi*z20 - z10;
    const double slope_by_sin_tau = rate_1*slope_by_z1_2 + slope_by_v1_2*t107 + slope_by_v1_2_on_boundary_by_z10*t106 + slope_by_v1_2_on_boundary_by_z20*t105;
    const double slope_by_cos_tau = rate_1*slope_by_v1_2 - slope_by_carried_z1_2_by_z10*t106 - slope_by_carried_z1_2_by_z20*t105 - slope_by_z1_2*t107;
    /* trace_gradient */
    const double t108 = cos_omega2_tau1*slope_by_sin_omega2_tau1;
    const double t109 = cos_omega1_tau1*slope_by_sin_omega1_tau1;
    const double t110 = sin_omega2_tau1*slope_by_cos_omega2_tau1;
    const double t111 = sin_omega1_tau1*slope_by_cos_omega1_tau1;
    const double t112 = cos_omega3_tau2*slope_by_sin_omega3_tau2;
    const double t113 = sin_omega3_tau2*slope_by_cos_omega3_tau2;
    const double t114 = sin_omega3_tau2/(omega3*omega3);
    const double t115 = delay_tau2_by_z20*(sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3) + slope_by_carried_v2_4_by_z10*(sin_omega3_tau2*z1_3_on_boundary_by_z10 - sin_omega3_tau2*z2_3_on_boundary_by_z10) + slope_by_carried_v2_4_by_z20*(sin_omega3_tau2*z1_3_on_boundary_by_z20 - sin_omega3_tau2*z2_3_on_boundary_by_z20) + slope_by_z2_4*(V*t114 - t114*v2_3) + t112*tau2 - t113*tau2 - t114*v2_3_on_boundary_by_z20;
    const double t116 = -t19 + t20;
    const double t117 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t118 = t116*z1_2_on_boundary_by_z20 + t117*v1_2_on_boundary_by_z20;
    const double t119 = t116*z1_2_on_boundary_by_z10 + t117*v1_2_on_boundary_by_z10;
    const double t120 = t10 - t12;
    const double t121 = t117*z1_2_on_boundary_by_z20 + t120*v1_2_on_boundary_by_z20;
    const double t122 = t117*z1_2_on_boundary_by_z10 + t120*v1_2_on_boundary_by_z10;
    const double t123 = t116*z1_2 + t117*v1_2;
    const double t124 = t117*z1_2 + t120*v1_2;
    const double t125 = slope_by_v2_3*t123 + slope_by_v2_3_on_boundary_by_z10*t119 + slope_by_v2_3_on_boundary_by_z20*t118 + slope_by_z2_3*t124 + slope_by_z2_3_on_boundary_by_z10*t122 + slope_by_z2_3_on_boundary_by_z20*t121;
    const double t126 = slope_by_carried_v1_3_by_z10*t116*z2_2_on_boundary_by_z10 + slope_by_carried_v1_3_by_z20*t116*z2_2_on_boundary_by_z20 + slope_by_v1_3*(V*t117 + t116*z2_2) + slope_by_z1_3*(V*t120 + t117*z2_2) + slope_by_z1_3_on_boundary_by_z10*t117*z2_2_on_boundary_by_z10 + slope_by_z1_3_on_boundary_by_z20*t117*z2_2_on_boundary_by_z20;
    const double t127 = slope_by_carried_v1_3_by_z10*t119 + slope_by_carried_v1_3_by_z20*t118 + slope_by_v1_3*t123 + slope_by_v2_3*(-V*t117 - t116*z2_2) - slope_by_v2_3_on_boundary_by_z10*t116*z2_2_on_boundary_by_z10 - slope_by_v2_3_on_boundary_by_z20*t116*z2_2_on_boundary_by_z20 + slope_by_z1_3*t124 + slope_by_z1_3_on_boundary_by_z10*t122 + slope_by_z1_3_on_boundary_by_z20*t121 + slope_by_z2_3*(-V*t120 - t117*z2_2) - slope_by_z2_3_on_boundary_by_z10*t117*z2_2_on_boundary_by_z10 - slope_by_z2_3_on_boundary_by_z20*t117*z2_2_on_boundary_by_z20;
    const double t128 = (1.0/(omega2*omega2));
    const double t129 = sin_omega2_tau1*t128;
    const double t130 = t129*t6;
    const double t131 = slope_by_carried_v1_3_by_z10*(sin_omega2_tau1*t73 - sin_omega2_tau1*t74) + slope_by_carried_v1_3_by_z20*(sin_omega2_tau1*t71 - sin_omega2_tau1*t72) + slope_by_v1_3*(sin_omega2_tau1*t77 - sin_omega2_tau1*t78) + slope_by_v2_3*(sin_omega2_tau1*t75 - sin_omega2_tau1*t76) + slope_by_v2_3_on_boundary_by_z10*(sin_omega2_tau1*t69 - sin_omega2_tau1*t70) + slope_by_v2_3_on_boundary_by_z20*(sin_omega2_tau1*t67 - sin_omega2_tau1*t68) + slope_by_z1_3*(-t129*t6*v1_2 + t129*t81) + slope_by_z2_3*(p3*sin_omega2_tau1*t128*v1_2 - t129*t79) + t108*tau1 - t110*tau1 + t129*t86 + t129*t88 - t130*t83 - t130*t84;
    const double t132 = sin_omega1_tau1/(omega1*omega1);
    const double t133 = p1*t132;
    const double t134 = slope_by_carried_v1_3_by_z10*(-sin_omega1_tau1*t73 - sin_omega1_tau1*t96) + slope_by_carried_v1_3_by_z20*(-sin_omega1_tau1*t71 - sin_omega1_tau1*t95) + slope_by_v1_3*(-sin_omega1_tau1*t77 - sin_omega1_tau1*t98) + slope_by_v2_3*(-sin_omega1_tau1*t75 - sin_omega1_tau1*t97) + slope_by_v2_3_on_boundary_by_z10*(-sin_omega1_tau1*t69 - sin_omega1_tau1*t94) + slope_by_v2_3_on_boundary_by_z20*(-sin_omega1_tau1*t67 - sin_omega1_tau1*t93) + slope_by_z1_3*(-t100*t132 - t132*t81) + slope_by_z2_3*(-t132*t80 - t132*t99) + t109*tau1 - t111*tau1 - t132*t86 - t132*t88 - t133*t83 - t133*t84;
    const double t135 = 1 - cos_tau;
    const double t136 = -eta*z2_3 + t42;
    const double t137 = chi*z1_3 - t40;
    if (trace_gradient) {
        trace_gradient[lane] = cos_tau*slope_by_z1_2 - sin_tau*slope_by_v1_2;
        trace_gradient[1*lanes + lane] = slope_by_v1_2*t2 + slope_by_z1_2*t1 + slope_by_z2_2;
        trace_gradient[2*lanes + lane] = V*slope_by_z2_2 + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau + slope_by_z1_2*t32;
        trace_gradient[3*lanes + lane] = omega1*t109 - omega1*t111 + omega2*t108 - omega2*t110;
        trace_gradient[4*lanes + lane] = V*slope_by_z1_4 + V*slope_by_z2_4 + omega3*t112 - omega3*t113;
        trace_gradient[5*lanes + lane] = 0;
        trace_gradient[6*lanes + lane] = -V*slope_by_rate_1 + omega1_by_chi*t134 + omega2_by_chi*t131 + omega3_by_chi*t115 + p1_by_chi*t127 + p2_by_chi*t126 + p3_by_chi*t125 + slope_by_carried_z1_2_by_z10*t135*z2_1_on_boundary_by_z10 + slope_by_carried_z1_2_by_z20*t135*z2_1_on_boundary_by_z20 + slope_by_delay_ta_by_z20*t33 + slope_by_delay_tau_by_z10*t34*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10) + slope_by_delay_tau_by_z20*t34*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + slope_by_rate_2*(V - v1_2) + slope_by_rate_3*z2_3 + slope_by_rate_4*(t48 - t49) + slope_by_v1_2*(V*t135 + sin_tau*z20) + slope_by_z1_2*(V*(-sin_tau + tau) + t135*z20) + t103*z2_2 + t104*z2_2 + t136*t64 + t136*t65 + t60*z2_1_on_boundary_by_z20 + t61*z2_1_on_boundary_by_z10;
        trace_gradient[7*lanes + lane] = omega1_by_eta*t134 + omega2_by_eta*t131 + omega3_by_eta*t115 + p1_by_eta*t127 + p2_by_eta*t126 + p3_by_eta*t125 + slope_by_rate_4*(chi*z1_4 - chi*z2_4) + t137*t64 + t137*t65;
        trace_gradient[8*lanes + lane] = delay_ta_by_z10*slope_by_z1_1_on_boundary_by_z10 + delay_ta_by_z10*slope_by_z2_1_on_boundary_by_z10 + delay_ta_by_z20*slope_by_z1_1_on_boundary_by_z20 + delay_ta_by_z20*slope_by_z2_1_on_boundary_by_z20 + delay_tau2_by_z10 + delay_tau2_by_z20*t26 + delay_tau_by_z10*slope_by_z2_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z2_2_on_boundary_by_z20 + slope_by_rate_1*(1 - chi) + slope_by_v1_2*(chi + cos_tau - t0) + slope_by_v1_3*t8 + slope_by_v2_3*t16 + slope_by_z1_2*(sin_tau + t3) + slope_by_z1_3*t14 + slope_by_z1_4*tau2 + slope_by_z2_2*tau + slope_by_z2_3*t18 + slope_by_z2_4*t29 + t102;
        trace_gradient[9*lanes + lane] = 0;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_solution_ii_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    dry_friction_solution_ii_trace_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, trace, trace_gradient);
}

/* State at the start and behind each transition. Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after the other; and the frequencies of each phase.
 * Operations: 181. Intermediate terms: 50. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_passage(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *states,
    double *coefficients, double *frequencies)
{
    const double chi = parameters[0], V = parameters[2], e2 = parameters[3];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double z10 = unknowns[0], z20 = unknowns[1], tau = unknowns[2], tau1 = unknowns[3],
        tau2 = unknowns[4], e1 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t0 = -chi*cos_tau + chi;
    const double t1 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t1) + cos_tau*z10 + t0*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t0 - sin_tau*z10 + t1*z20;
    /* functions of tau1 in slip-slip */
    const double t2 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t2);
    const double sin_omega1_tau1 = sin(t2);
    const double t3 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t3);
    const double sin_omega2_tau1 = sin(t3);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t4 = 1 - p1;
    const double t5 = sin_omega1_tau1/omega1;
    const double t6 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*t5 - p2*t6) + v1_2*(p1*t5 + t4*t6) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t4) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t7 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t8 = cos_omega1_tau1*t4 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t6 + t4*t5) + t7*z1_2 + t8*z2_2 + v1_2*(p3*t5 - p3*t6);
    const double t9 = omega2*sin_omega2_tau1;
    const double t10 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t8 + t7*v1_2 + z1_2*(-p3*t10 + p3*t9) + z2_2*(-p1*t9 - t10*t4);
    /* functions of tau2 in stick-slip */
    const double t11 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t11);
    const double sin_omega3_tau2 = sin(t11);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t12 = (1.0/(omega3));
    const double t13 = sin_omega3_tau2*t12;
    const double z2_4 = V*(-t13 + tau2) + cos_omega3_tau2*z2_3 + t13*v2_3 + z1_3*(1 - cos_omega3_tau2);
    if (states) {
        states[0] = z10;
        states[1] = z20;
        states[2] = V;
        states[3] = V;
        states[4] = z10;
        states[5] = z20;
        states[6] = V;
        states[7] = V;
        states[8] = z1_2;
        states[9] = z2_2;
        states[10] = v1_2;
        states[11] = V;
        states[12] = z1_3;
        states[13] = z2_3;
        states[14] = V;
        states[15] = v2_3;
        states[16] = z1_4;
        states[17] = z2_4;
        states[18] = V;
        states[19] = V;
    }
    if (!coefficients && !frequencies)
        return;
    /* coefficients */
    const double t14 = chi*z20;
    const double t15 = t14 - z10;
    const double t16 = V*chi;
    const double t17 = -V + t16;
    const double t18 = chi*z10;
    const double t19 = e2 - t14;
    const double t20 = e2 + t14;
    const double t21 = (chi*chi);
    const double t22 = t21*z20;
    const double t23 = V*t21 - t16;
    const double t24 = -chi*t15;
    const double t25 = -chi*t17;
    const double t26 = V*p2;
    const double t27 = p2*z2_2;
    const double t28 = omega1*z1_2;
    const double t29 = omega2*z1_2;
    const double t30 = p3*v1_2;
    const double t31 = chi*z1_3;
    const double t32 = chi*(-z1_3 + z2_3);
    const double t33 = chi*(-V*t12 + t12*v2_3);
    if (coefficients) {
        for (int i = 0; i < 44; ++i)
            coefficients[i] = 0.0;
        coefficients[0] = -e1 - t15;
        coefficients[1] = -t17;
        coefficients[2] = -e1 + t14 - z10;
        coefficients[3] = t17;
        coefficients[4] = -t18 - t19;
        coefficients[6] = t18 - t20;
        coefficients[8] = t17;
        coefficients[10] = -t17;
        coefficients[11] = t15;
        coefficients[12] = -t19 - t22;
        coefficients[13] = -t23;
        coefficients[14] = -t24;
        coefficients[15] = -t25;
        coefficients[16] = -t20 + t22;
        coefficients[17] = t23;
        coefficients[18] = t24;
        coefficients[19] = t25;
        coefficients[20] = -V;
        coefficients[22] = p1*v1_2 + t26;
        coefficients[23] = -t26 + t4*v1_2;
        coefficients[24] = -omega1*t27 - p1*t28;
        coefficients[25] = omega2*t27 - t29*t4;
        coefficients[26] = -V;
        coefficients[28] = V*t4 + t30;
        coefficients[29] = V*p1 - t30;
        coefficients[30] = -omega1*t4*z2_2 - p3*t28;
        coefficients[31] = -omega2*p1*z2_2 + p3*t29;
        coefficients[32] = -e1 - t31 + z1_3;
        coefficients[33] = -t17;
        coefficients[34] = -t32;
        coefficients[35] = -t33;
        coefficients[36] = -e1 + t31 - z1_3;
        coefficients[37] = t17;
        coefficients[38] = t32;
        coefficients[39] = t33;
        coefficients[42] = -V + v2_3;
        coefficients[43] = omega3*z1_3 - omega3*z2_3;
    }
    if (!frequencies)
        return;
    if (frequencies) {
        frequencies[0] = 1;
        frequencies[1] = omega1;
        frequencies[2] = omega2;
        frequencies[3] = omega3;
    }
}

/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the other; monodromy matrix.
 * Operations: 476. Intermediate terms: 169. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_linearisation(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    double *poincare_jacobian, double *saltations, double *monodromy)
{
    const double chi = parameters[0], eta = parameters[1], V = parameters[2];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double z10 = unknowns[0], z20 = unknowns[1], tau = unknowns[2], tau1 = unknowns[3],
        tau2 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t0 = chi*cos_tau;
    const double phi_2_23 = chi - t0;
    const double t1 = chi*tau;
    const double t2 = chi*sin_tau;
    const double phi_2_03 = t1 - t2;
    const double z1_2 = V*phi_2_03 + V*sin_tau + cos_tau*z10 + phi_2_23*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*phi_2_23 - sin_tau*z10 + t2*z20;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t3);
    const double sin_omega1_tau1 = sin(t3);
    const double t4 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t4);
    const double sin_omega2_tau1 = sin(t4);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t5 = 1 - p1;
    const double t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5;
    const double t7 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t8 = sin_omega1_tau1/omega1;
    const double t9 = sin_omega2_tau1/omega2;
    const double t10 = p1*t8 + t5*t9;
    const double t11 = p2*t8 - p2*t9;
    const double z1_3 = V*t11 + t10*v1_2 + t6*z1_2 + t7*z2_2;
    const double t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t13 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1;
    const double t14 = p3*t8 - p3*t9;
    const double t15 = p1*t9 + t5*t8;
    const double z2_3 = V*t15 + t12*z1_2 + t13*z2_2 + t14*v1_2;
    const double t16 = omega1*sin_omega1_tau1;
    const double t17 = omega2*sin_omega2_tau1;
    const double t18 = -p1*t16 - t17*t5;
    const double t19 = -p2*t16 + p2*t17;
    const double v1_3 = V*t7 + t18*z1_2 + t19*z2_2 + t6*v1_2;
    const double t20 = -p3*t16 + p3*t17;
    const double t21 = p1*t17;
    const double t22 = t16*t5;
    const double t23 = -t21 - t22;
    const double v2_3 = V*t13 + t12*v1_2 + t20*z1_2 + t23*z2_2;
    /* functions of tau2 in stick-slip */
    const double t24 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t24);
    const double sin_omega3_tau2 = sin(t24);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t25 = 1 - cos_omega3_tau2;
    const double t26 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t26 + tau2) + cos_omega3_tau2*z2_3 + t25*z1_3 + t26*v2_3;
    const double t27 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t25 + cos_omega3_tau2*v2_3 + t27*z1_3 - t27*z2_3;
    /* rate of the exit boundary after ta */
    const double t28 = V*chi;
    const double rate_1 = V - t28;
    /* derivatives of the time to the boundary after ta */
    const double t29 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t29;
    const double delay_ta_by_z20 = chi*t29;
    /* perturbation on the boundary after ta */
    const double z2_1_on_boundary_by_z10 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + phi_2_23*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + phi_2_23*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t28;
    /* derivatives of the time to the boundary after tau */
    const double t30 = (1.0/(rate_2));
    const double delay_tau_by_z10 = t30*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20 = t30*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t31 = chi*z2_2;
    const double before_v1_2 = t31 - z1_2;
    const double v1_2_on_boundary_by_z10 = before_v1_2*delay_tau_by_z10 + carried_v1_2_by_z10;
    const double v1_2_on_boundary_by_z20 = before_v1_2*delay_tau_by_z20 + carried_v1_2_by_z20;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t6*z1_2_on_boundary_by_z10 + t7*z2_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t6*z1_2_on_boundary_by_z20 + t7*z2_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10 + t14*v1_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20 + t14*v1_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10 + t6*v1_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20 + t6*v1_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t20*z1_2_on_boundary_by_z10 + t23*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t20*z1_2_on_boundary_by_z20 + t23*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t32 = chi*z2_3;
    const double rate_3 = t32 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t33 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t33;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t33;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t34 = chi*eta;
    const double before_v2_3 = -eta*t32 + t34*z1_3;
    const double v2_3_on_boundary_by_z10 = before_v2_3*delay_tau1_by_z10 + carried_v2_3_by_z10;
    const double v2_3_on_boundary_by_z20 = before_v2_3*delay_tau1_by_z20 + carried_v2_3_by_z20;
    /* Phi along tau2 */
    const double carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t25*z1_3_on_boundary_by_z10 + t26*v2_3_on_boundary_by_z10;
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t25*z1_3_on_boundary_by_z20 + t26*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t27*z1_3_on_boundary_by_z10 - t27*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t27*z1_3_on_boundary_by_z20 - t27*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t34*z1_4 - t34*z2_4;
    /* derivatives of the time to the boundary after tau2 */
    const double t35 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t35;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t35;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20;
    const double z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    if (poincare_jacobian) {
        poincare_jacobian[0] = z1_4_on_boundary_by_z10;
        poincare_jacobian[1] = z1_4_on_boundary_by_z20;
        poincare_jacobian[2] = z2_4_on_boundary_by_z10;
        poincare_jacobian[3] = z2_4_on_boundary_by_z20;
    }
    if (!saltations && !monodromy)
        return;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z20 - z10;
    /* vector fields at transition 2 */
    const double behind_v2_2 = -eta*t31 + t34*z1_2;
    /* saltations */
    const double saltation_1_20 = behind_v1_1/rate_1;
    const double saltation_1_21 = -chi*saltation_1_20;
    const double t36 = 0;
    const double t37 = (1.0/(rate_2));
    const double t38 = chi*t37;
    const double t39 = t36*t38;
    const double t40 = behind_v2_2*t38;
    const double t41 = (1.0/(rate_3));
    const double t42 = t41*(V - v1_3);
    const double t43 = 0;
    const double t44 = (V - v2_4)/rate_4;
    if (saltations) {
        for (int i = 0; i < 64; ++i)
            saltations[i] = 0.0;
        saltations[0] = 1;
        saltations[5] = 1;
        saltations[8] = saltation_1_20;
        saltations[9] = saltation_1_21;
        saltations[10] = 1;
        saltations[15] = 1;
        saltations[16] = 1;
        saltations[21] = 1;
        saltations[24] = -t39;
        saltations[25] = t39;
        saltations[26] = 1;
        saltations[28] = -t40;
        saltations[29] = t40;
        saltations[31] = 1;
        saltations[32] = 1;
        saltations[34] = t42;
        saltations[37] = 1;
        saltations[46] = t43;
        saltations[47] = 1;
        saltations[48] = 1;
        saltations[53] = 1;
        saltations[55] = t44;
        saltations[58] = 1;
    }
    if (!monodromy)
        return;
    /* Phi of phase 2 */
    const double phi_2_00 = cos_tau + saltation_1_20*sin_tau;
    const double phi_2_01 = chi + saltation_1_21*sin_tau - t0;
    const double phi_2_20 = cos_tau*saltation_1_20 - sin_tau;
    const double phi_2_21 = cos_tau*saltation_1_21 + t2;
    /* saltation of phase 2 */
    const double saltation_2_20 = -phi_2_00*t39 + phi_2_20;
    const double saltation_2_21 = -phi_2_01*t39 + phi_2_21 + t39;
    const double t45 = t36*t37;
    const double saltation_2_22 = cos_tau - t2*t45;
    const double saltation_2_23 = -phi_2_03*t39 + phi_2_23 + t1*t45;
    const double saltation_2_30 = -phi_2_00*t40;
    const double saltation_2_31 = -phi_2_01*t40 + t40;
    const double t46 = behind_v2_2*t37;
    const double saltation_2_32 = -t2*t46;
    const double saltation_2_33 = -phi_2_03*t40 + t1*t46 + 1;
    /* Phi of phase 3 */
    const double phi_3_00 = phi_2_00*t6 + saltation_2_20*t10 + saltation_2_30*t11;
    const double phi_3_01 = phi_2_01*t6 + saltation_2_21*t10 + saltation_2_31*t11 + t7;
    const double phi_3_02 = saltation_2_22*t10 + saltation_2_32*t11 + sin_tau*t6;
    const double phi_3_03 = phi_2_03*t6 + saltation_2_23*t10 + saltation_2_33*t11 + t7*tau;
    const double phi_3_10 = phi_2_00*t12 + saltation_2_20*t14 + saltation_2_30*t15;
    const double phi_3_11 = phi_2_01*t12 + saltation_2_21*t14 + saltation_2_31*t15 + t13;
    const double phi_3_12 = saltation_2_22*t14 + saltation_2_32*t15 + sin_tau*t12;
    const double phi_3_13 = phi_2_03*t12 + saltation_2_23*t14 + saltation_2_33*t15 + t13*tau;
    const double phi_3_20 = phi_2_00*t18 + saltation_2_20*t6 + saltation_2_30*t7;
    const double phi_3_21 = phi_2_01*t18 + saltation_2_21*t6 + saltation_2_31*t7 + t19;
    const double phi_3_22 = saltation_2_22*t6 + saltation_2_32*t7 + sin_tau*t18;
    const double phi_3_23 = phi_2_03*t18 + saltation_2_23*t6 + saltation_2_33*t7 + t19*tau;
    const double phi_3_30 = phi_2_00*t20 + saltation_2_20*t12 + saltation_2_30*t13;
    const double phi_3_31 = phi_2_01*t20 + saltation_2_21*t12 + saltation_2_31*t13 - t21 - t22;
    const double phi_3_32 = saltation_2_22*t12 + saltation_2_32*t13 + sin_tau*t20;
    const double phi_3_33 = phi_2_03*t20 + saltation_2_23*t12 + saltation_2_33*t13 + t23*tau;
    /* saltation of phase 3 */
    const double saltation_3_00 = phi_3_00 + phi_3_20*t42;
    const double saltation_3_01 = phi_3_01 + phi_3_21*t42;
    const double saltation_3_02 = phi_3_02 + phi_3_22*t42;
    const double saltation_3_03 = phi_3_03 + phi_3_23*t42;
    const double saltation_3_30 = phi_3_20*t43 + phi_3_30;
    const double saltation_3_31 = phi_3_21*t43 + phi_3_31;
    const double saltation_3_32 = phi_3_22*t43 + phi_3_32;
    const double saltation_3_33 = phi_3_23*t43 + phi_3_33;
    /* Phi of phase 4 */
    const double phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t25 + saltation_3_30*t26;
    const double phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t25 + saltation_3_31*t26;
    const double phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t25 + saltation_3_32*t26;
    const double phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t25 + saltation_3_33*t26;
    const double phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t27 + saltation_3_00*t27;
    const double phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t27 + saltation_3_01*t27;
    const double phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t27 + saltation_3_02*t27;
    const double phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t27 + saltation_3_03*t27;
    /* saltation of phase 4 */
    const double saltation_4_10 = phi_4_10 + phi_4_30*t44;
    const double saltation_4_11 = phi_4_11 + phi_4_31*t44;
    const double saltation_4_12 = phi_4_12 + phi_4_32*t44;
    const double saltation_4_13 = phi_4_13 + phi_4_33*t44;
    if (monodromy) {
        for (int i = 0; i < 16; ++i)
            monodromy[i] = 0.0;
        monodromy[0] = saltation_3_00;
        monodromy[1] = saltation_3_01;
        monodromy[2] = saltation_3_02;
        monodromy[3] = saltation_3_03;
        monodromy[4] = saltation_4_10;
        monodromy[5] = saltation_4_11;
        monodromy[6] = saltation_4_12;
        monodromy[7] = saltation_4_13;
    }
}

/* State after a time in slip-stick.
 * Operations: 23. Intermediate terms: 4. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = sin(time);
    const double t1 = chi*t0;
    const double t2 = cos(time);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1);
    state_after[1] = time*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-slip.
 * Operations: 77. Intermediate terms: 15. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5];
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
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
    state_after[0] = t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6);
    state_after[2] = t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14);
    state_after[3] = t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6);
}

/* State after a time in stick-slip.
 * Operations: 23. Intermediate terms: 6. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_flow_stick_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[6];
    const double z1 = state[0], z2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega3*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = omega3*t1;
    state_after[0] = time*v1 + z1;
    state_after[1] = t2*v2 + t3*z2 + t4*z1 + v1*(-t2 + time);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*z1 - t5*z2;
}

/* All unknowns from the reduced ones; the equations for these and their derivatives.
 * Operations: 295. Intermediate terms: 100. */
static NONSMOOTH_INLINE void dry_friction_solution_ii_reduced_fixed_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *fixed)
{
    const double chi = parameters[lane], V = parameters[2*lanes + lane];
    const double p1 = spectrum[3*lanes + lane], omega3 = spectrum[6*lanes + lane];
    const double t1 = (1.0/((chi - 1)));
    /* slip-slip for tau1 */
    const double t8 = 1 - p1;
    /* tau2: first return */
    const double t22 = (1.0/(omega3));
    /* d/dtau of: slip-stick for tau */
    const double t26 = V*chi;
    const double t27 = V - t26;
    fixed[lane] = t1;
    fixed[1*lanes + lane] = t8;
    fixed[2*lanes + lane] = t22;
    fixed[3*lanes + lane] = t26;
    fixed[4*lanes + lane] = t27;
}

static NONSMOOTH_INLINE void dry_friction_solution_ii_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *fixed,
    const double *reduced, double *unknowns, double *reduced_residual, double *reduced_jacobian)
{
    const double chi = parameters[lane], eta = parameters[1*lanes + lane],
        V = parameters[2*lanes + lane], e2 = parameters[3*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[6*lanes + lane];
    const double t1 = fixed[lane], t8 = fixed[1*lanes + lane], t22 = fixed[2*lanes + lane],
        t26 = fixed[3*lanes + lane], t27 = fixed[4*lanes + lane];
    const double tau = reduced[lane], tau1 = reduced[1*lanes + lane], e1 = reduced[2*lanes + lane];
    /* functions of tau in slip-stick */
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, tau);
    const double cos_tau = wave_0.cosine;
    const double sin_tau = wave_0.sine;
    /* z2_1: linear in second-breaks-forward */
    const double t0 = V*tau;
    const double t2 = cos_tau*t1;
    const double z2_1 = V*sin_tau - e1*t2 - t0 - e2*t1/chi;
    /* slip-stick for tau */
    const double t3 = chi*z2_1;
    const double t4 = e1 + t3;
    const double t5 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t4 + t5*z2_1;
    const double z2_2 = t0 + z2_1;
    const double v1_2 = V*cos_tau + V*t5 + sin_tau*t3 - sin_tau*t4;
    /* functions of tau1 in slip-slip */
    const double t6 = omega1*tau1;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t6);
    const double cos_omega1_tau1 = wave_1.cosine;
    const double sin_omega1_tau1 = wave_1.sine;
    const double t7 = omega2*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t7);
    const double cos_omega2_tau1 = wave_2.cosine;
    const double sin_omega2_tau1 = wave_2.sine;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t11 = sin_omega1_tau1/omega1;
    const double t12 = sin_omega2_tau1/omega2;
    const double t13 = p1*t11 + t12*t8;
    const double z1_3 = V*(p2*t11 - p2*t12) + t10*z2_2 + t13*v1_2 + t9*z1_2;
    const double t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t15 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1;
    const double t16 = p3*t11 - p3*t12;
    const double z2_3 = V*(p1*t12 + t11*t8) + t14*z1_2 + t15*z2_2 + t16*v1_2;
    const double t17 = omega1*sin_omega1_tau1;
    const double t18 = omega2*sin_omega2_tau1;
    const double t19 = -p3*t17 + p3*t18;
    const double t20 = -p1*t18 - t17*t8;
    const double v2_3 = V*t15 + t14*v1_2 + t19*z1_2 + t20*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* first return of tau2 */
    const double t21 = (1.0/(amplitude_tau2));
    const double cos_tau2_return = sine_part_tau2*t21;
    const double sin_tau2_return = -cosine_part_tau2*t21;
    const double tau2 = t22*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
    /* unknowns */
    const double z1_5 = V*tau2 + sine_part_tau2*t22 + z2_3;
    const double z2_5 = -amplitude_tau2*t22 + z1_5;
    if (unknowns) {
        unknowns[lane] = z1_5;
        unknowns[1*lanes + lane] = z2_5;
        unknowns[2*lanes + lane] = tau;
        unknowns[3*lanes + lane] = tau1;
        unknowns[4*lanes + lane] = tau2;
        unknowns[5*lanes + lane] = e1;
    }
    if (!reduced_residual && !reduced_jacobian)
        return;
    /* slip-slip for tau1 */
    const double t23 = -p1*t17 - t18*t8;
    const double t24 = -p2*t17 + p2*t18;
    const double v1_3 = V*t10 + t23*z1_2 + t24*z2_2 + t9*v1_2;
    if (reduced_residual) {
        reduced_residual[lane] = -V + v1_3;
        reduced_residual[1*lanes + lane] = -chi*z2_5 - e1 + z1_5;
        reduced_residual[2*lanes + lane] = -z2_1 + z2_5;
    }
    if (!reduced_jacobian)
        return;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t25 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = V*cos_tau - V - t1*t25;
    /* d/de1 of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_e1 = -t2;
    const double z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t27 + t25 + t26;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t27;
    /* d/de1 of: slip-stick for tau */
    const double z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau;
    const double v1_2_by_e1 = -sin_tau;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t10*z2_2_by_tau + t13*v1_2_by_tau + t9*z1_2_by_tau;
    const double z2_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t16*v1_2_by_tau;
    const double v1_3_by_tau = t23*z1_2_by_tau + t24*z2_2_by_tau + t9*v1_2_by_tau;
    const double v2_3_by_tau = t14*v1_2_by_tau + t19*z1_2_by_tau + t20*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t28 = chi*z2_3;
    const double v1_3_by_tau1 = t28 - z1_3;
    const double v2_3_by_tau1 = chi*eta*z1_3 - eta*t28;
    /* d/de1 of: slip-slip for tau1 */
    const double z1_3_by_e1 = t10*z2_1_by_e1 + t13*v1_2_by_e1 + t9*z1_2_by_e1;
    const double z2_3_by_e1 = t14*z1_2_by_e1 + t15*z2_1_by_e1 + t16*v1_2_by_e1;
    const double v1_3_by_e1 = t23*z1_2_by_e1 + t24*z2_1_by_e1 + t9*v1_2_by_e1;
    const double v2_3_by_e1 = t14*v1_2_by_e1 + t19*z1_2_by_e1 + t20*z2_1_by_e1;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/de1 of: first return of tau2 */
    const double sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1;
    /* d/dtau of: first return of tau2 */
    const double t29 = 2*cosine_part_tau2;
    const double t30 = 2*sine_part_tau2;
    const double t31 = (1.0/2.0)*t21;
    const double amplitude_tau2_by_tau = t31*(sine_part_tau2_by_tau*t30 + t29*v2_3_by_tau);
    /* d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1 = t31*(sine_part_tau2_by_tau1*t30 + t29*v2_3_by_tau1);
    /* d/de1 of: first return of tau2 */
    const double amplitude_tau2_by_e1 = t31*(sine_part_tau2_by_e1*t30 + t29*v2_3_by_e1);
    /* d/dtau of: first return of tau2 */
    const double t32 = (1.0/(amplitude_tau2*amplitude_tau2));
    const double t33 = amplitude_tau2_by_tau*t32;
    const double cos_tau2_return_by_tau = -sine_part_tau2*t33 + sine_part_tau2_by_tau*t21;
    const double sin_tau2_return_by_tau = cosine_part_tau2*t33 - t21*v2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double t34 = amplitude_tau2_by_tau1*t32;
    const double cos_tau2_return_by_tau1 = -sine_part_tau2*t34 + sine_part_tau2_by_tau1*t21;
    const double sin_tau2_return_by_tau1 = cosine_part_tau2*t34 - t21*v2_3_by_tau1;
    /* d/de1 of: first return of tau2 */
    const double t35 = amplitude_tau2_by_e1*t32;
    const double cos_tau2_return_by_e1 = -sine_part_tau2*t35 + sine_part_tau2_by_e1*t21;
    const double sin_tau2_return_by_e1 = cosine_part_tau2*t35 - t21*v2_3_by_e1;
    /* d/dtau of: tau2: first return */
    const double t36 = t22/((cos_tau2_return*cos_tau2_return) + (sin_tau2_return*sin_tau2_return));
    const double t37 = cos_tau2_return*t36;
    const double t38 = sin_tau2_return*t36;
    const double tau2_by_tau = -cos_tau2_return_by_tau*t38 + sin_tau2_return_by_tau*t37;
    /* d/dtau1 of: tau2: first return */
    const double tau2_by_tau1 = -cos_tau2_return_by_tau1*t38 + sin_tau2_return_by_tau1*t37;
    /* d/de1 of: tau2: first return */
    const double tau2_by_e1 = -cos_tau2_return_by_e1*t38 + sin_tau2_return_by_e1*t37;
    /* d/dtau of: stick-stick for no time */
    const double z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t22 + z2_3_by_tau;
    const double z2_5_by_tau = -amplitude_tau2_by_tau*t22 + z1_5_by_tau;
    /* d/dtau1 of: stick-stick for no time */
    const double z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t22 + v2_3;
    const double z2_5_by_tau1 = -amplitude_tau2_by_tau1*t22 + z1_5_by_tau1;
    /* d/de1 of: stick-stick for no time */
    const double z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t22 + z2_3_by_e1;
    const double z2_5_by_e1 = -amplitude_tau2_by_e1*t22 + z1_5_by_e1;
    if (reduced_jacobian) {
        reduced_jacobian[lane] = v1_3_by_tau;
        reduced_jacobian[1*lanes + lane] = v1_3_by_tau1;
        reduced_jacobian[2*lanes + lane] = v1_3_by_e1;
        reduced_jacobian[3*lanes + lane] = -chi*z2_5_by_tau + z1_5_by_tau;
        reduced_jacobian[4*lanes + lane] = -chi*z2_5_by_tau1 + z1_5_by_tau1;
        reduced_jacobian[5*lanes + lane] = -chi*z2_5_by_e1 + z1_5_by_e1 - 1;
        reduced_jacobian[6*lanes + lane] = -z2_1_by_tau + z2_5_by_tau;
        reduced_jacobian[7*lanes + lane] = z2_5_by_tau1;
        reduced_jacobian[8*lanes + lane] = -z2_1_by_e1 + z2_5_by_e1;
    }
}

NONSMOOTH_UNMERGED
void dry_friction_solution_ii_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[3], double *unknowns,
    double *reduced_residual, double *reduced_jacobian)
{
    double fixed[5];
    dry_friction_solution_ii_reduced_fixed_in_lane(1, 0, parameters, spectrum, fixed);
    dry_friction_solution_ii_reduced_in_lane(1, 0, parameters, spectrum, fixed, reduced, unknowns,
        reduced_residual, reduced_jacobian);
}

/* Map [N, c] of a turn; the start that follows from the dwell times; compatibility and switching conditions. The start among the unknowns is not read.
 * Operations: 243. Intermediate terms: 76. */
NONSMOOTH_UNMERGED
void dry_friction_solution_ii_period_map(
    const double parameters[4], const double spectrum[7], const double unknowns[6],
    double *period_map, double *linear_start, double *compatibility)
{
    const double chi = parameters[0], V = parameters[2], e2 = parameters[3];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[6];
    const double tau = unknowns[2], tau1 = unknowns[3], tau2 = unknowns[4], e1 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick after tau, by the start */
    const double z1_2_by_z20 = -chi*cos_tau + chi;
    const double v1_2_by_z20 = chi*sin_tau;
    const double z1_2_by_v20 = chi*tau - v1_2_by_z20;
    const double v1_2_by_z10 = -sin_tau;
    /* functions of tau1 in slip-slip */
    const double t0 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t0);
    const double sin_omega1_tau1 = sin(t0);
    const double t1 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t1);
    const double sin_omega2_tau1 = sin(t1);
    /* slip-slip after tau1, by the start */
    const double t2 = 1 - p1;
    const double t3 = cos_omega1_tau1*p1 + cos_omega2_tau1*t2;
    const double t4 = cos_tau*t3;
    const double t5 = sin_omega1_tau1/omega1;
    const double t6 = sin_omega2_tau1/omega2;
    const double t7 = p1*t5 + t2*t6;
    const double z1_3_by_z10 = t4 + t7*v1_2_by_z10;
    const double t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3_by_z20 = t3*z1_2_by_z20 + t7*v1_2_by_z20 + t8;
    const double z1_3_by_v10 = cos_tau*t7 + sin_tau*t3;
    const double z1_3_by_v20 = p2*t5 - p2*t6 + t3*z1_2_by_v20 + t7*z1_2_by_z20 + t8*tau;
    const double t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t10 = cos_tau*t9;
    const double t11 = p3*t5 - p3*t6;
    const double z2_3_by_z10 = t10 + t11*v1_2_by_z10;
    const double t12 = cos_omega1_tau1*t2 + cos_omega2_tau1*p1;
    const double z2_3_by_z20 = t11*v1_2_by_z20 + t12 + t9*z1_2_by_z20;
    const double z2_3_by_v10 = cos_tau*t11 + sin_tau*t9;
    const double z2_3_by_v20 = p1*t6 + t11*z1_2_by_z20 + t12*tau + t2*t5 + t9*z1_2_by_v20;
    const double t13 = omega1*sin_omega1_tau1;
    const double t14 = omega2*sin_omega2_tau1;
    const double t15 = -p1*t13 - t14*t2;
    const double v1_3_by_z10 = cos_tau*t15 + t3*v1_2_by_z10;
    const double t16 = -p2*t13 + p2*t14;
    const double v1_3_by_z20 = t15*z1_2_by_z20 + t16 + t3*v1_2_by_z20;
    const double v1_3_by_v10 = sin_tau*t15 + t4;
    const double v1_3_by_v20 = t15*z1_2_by_v20 + t16*tau + t3*z1_2_by_z20 + t8;
    const double t17 = -p3*t13 + p3*t14;
    const double v2_3_by_z10 = cos_tau*t17 + t9*v1_2_by_z10;
    const double t18 = p1*t14 + t13*t2;
    const double v2_3_by_z20 = t17*z1_2_by_z20 - t18 + t9*v1_2_by_z20;
    const double v2_3_by_v10 = sin_tau*t17 + t10;
    const double v2_3_by_v20 = t12 + t17*z1_2_by_v20 - t18*tau + t9*z1_2_by_z20;
    /* functions of tau2 in stick-slip */
    const double t19 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t19);
    const double sin_omega3_tau2 = sin(t19);
    /* stick-slip after tau2, by the start */
    const double z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10;
    const double z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20;
    const double z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10;
    const double z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20;
    const double t20 = 1 - cos_omega3_tau2;
    const double t21 = sin_omega3_tau2/omega3;
    const double t22 = -t21 + tau2;
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t20*z1_3_by_z10 + t21*v2_3_by_z10 + t22*v1_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t20*z1_3_by_z20 + t21*v2_3_by_z20 + t22*v1_3_by_z20;
    const double z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t20*z1_3_by_v10 + t21*v2_3_by_v10 + t22*v1_3_by_v10;
    const double z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t20*z1_3_by_v20 + t21*v2_3_by_v20 + t22*v1_3_by_v20;
    const double t23 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t20*v1_3_by_z10 + t23*z1_3_by_z10 - t23*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t20*v1_3_by_z20 + t23*z1_3_by_z20 - t23*z2_3_by_z20;
    const double v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t20*v1_3_by_v10 + t23*z1_3_by_v10 - t23*z2_3_by_v10;
    const double v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t20*v1_3_by_v20 + t23*z1_3_by_v20 - t23*z2_3_by_v20;
    if (period_map) {
        for (int i = 0; i < 20; ++i)
            period_map[i] = 0.0;
        period_map[0] = z1_4_by_z10;
        period_map[1] = z1_4_by_z20;
        period_map[2] = z1_4_by_v10;
        period_map[3] = z1_4_by_v20;
        period_map[5] = z2_4_by_z10;
        period_map[6] = z2_4_by_z20;
        period_map[7] = z2_4_by_v10;
        period_map[8] = z2_4_by_v20;
        period_map[10] = v1_3_by_z10;
        period_map[11] = v1_3_by_z20;
        period_map[12] = v1_3_by_v10;
        period_map[13] = v1_3_by_v20;
        period_map[15] = v2_4_by_z10;
        period_map[16] = v2_4_by_z20;
        period_map[17] = v2_4_by_v10;
        period_map[18] = v2_4_by_v20;
    }
    if (!linear_start && !compatibility)
        return;
    /* coefficients of the linear equations */
    const double coefficient11 = z1_4_by_z10 - 1;
    const double coefficient22 = z2_4_by_z20 - 1;
    /* right-hand sides of the linear equations */
    const double right1 = -V*z1_4_by_v10 - V*z1_4_by_v20;
    const double right2 = -V*z2_4_by_v10 - V*z2_4_by_v20;
    /* determinant of the linear equations */
    const double determinant = coefficient11*coefficient22 - z1_4_by_z20*z2_4_by_z10;
    /* numerators of Cramer's rule */
    const double numerator1 = coefficient22*right1 - right2*z1_4_by_z20;
    const double numerator2 = coefficient11*right2 - right1*z2_4_by_z10;
    /* z10, z20 by Cramer's rule */
    const double t24 = (1.0/(determinant));
    const double z1_0 = numerator1*t24;
    const double z2_0 = numerator2*t24;
    if (linear_start) {
        linear_start[0] = z1_0;
        linear_start[1] = z2_0;
    }
    if (!compatibility)
        return;
    /* slip-stick for tau, until second-breaks-forward */
    const double z1_2 = V*sin_tau + V*z1_2_by_v20 + cos_tau*z1_0 + z1_2_by_z20*z2_0;
    const double z2_2 = V*tau + z2_0;
    if (compatibility) {
        compatibility[0] = V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0;
        compatibility[1] = V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0;
        compatibility[2] = -chi*z2_0 - e1 + z1_0;
        compatibility[3] = -chi*z1_2 + chi*z2_2 - e2;
    }
}

/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
void dry_friction_symmetric_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = NONSMOOTH_LANES, n = 5, p = 4, reduced = 2 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
        double fixed[13 * lanes], determinant[1 * lanes], x[2 * lanes], equation[2 * lanes], jacobian[4 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[2 * lanes], spectrum[7 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_spectrum_in_lane(lanes, lane, own, spectrum, NULL);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_symmetric_reduced_fixed_in_lane(lanes, lane, parameter, spectrum, fixed);
        static const int positive[] = {1, 1};
        nonsmooth_load(lanes, reduced, guess, count, start, x);
        for (int step = 0; step < 32 && nonsmooth_runs(lanes, open); ++step) {
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                dry_friction_symmetric_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                    NULL, NULL, equation, jacobian);
                nonsmooth_newton_in_lane(reduced, positive, lane, jacobian, equation, x, open,
                    taken);
            }
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            dry_friction_symmetric_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                unknown, determinant, equation, NULL);
            dry_friction_symmetric_trace_in_lane(lanes, lane, parameter, spectrum, unknown, NULL,
                slope, NULL);
        }
        nonsmooth_largest(lanes, reduced, equation, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = DRY_FRICTION_CONVERGED;
            code = ((unknown[3*lanes + lane] <= 0.0) | (unknown[4*lanes + lane] <= 0.0)) ?
                DRY_FRICTION_NOT_POSITIVE : code;
            code = open[lane] != 0.0 ? DRY_FRICTION_NOT_CONVERGED : code;
            code = doubt[lane] != 0.0 ? DRY_FRICTION_NOT_FINITE : code;
            code = ((fabs(determinant[0*lanes + lane]) <= NONSMOOTH_SINGULAR)) ?
                DRY_FRICTION_SINGULAR : code;
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
void dry_friction_symmetric_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int counts[] = {2, 3}, at_once[] = {0, 0}, exits[] = {6, 16};
    static const int opened[] = {-1, -1, -1, -1, 0};
    static const int begins[] = {0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 0.0, 0.0, 0.0, 2.0};
    static const nonsmooth_boundaries boundaries = {
        2, 1, counts, at_once, exits, opened, begins, per_unit};
    static const int terms[] = {2, 1}, first[] = {0, 2};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 4 * point, *const u = unknowns + 5 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {u[3], u[4]};
        const double measures[] = {p[0], p[2], p[3], u[0], u[1], u[2]};
        double spectral[7], work[12], rows[24], frequencies[3];
        dry_friction_spectrum(q, spectral, NULL);
        dry_friction_symmetric_passage(p, spectral, u, NULL, rows, frequencies);
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, 6, measures, work, bounds + 1 * point);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}

/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. */
NONSMOOTH_MULTIVERSION
void dry_friction_symmetric_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = NONSMOOTH_LANES, n = 5, p = 4 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        double parameter[p * lanes], unknown[n * lanes];
        double jacobian[n * n * lanes], moved[n * p * lanes], slope[(n + p) * lanes];
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        nonsmooth_load(lanes, n, unknowns, count, start, unknown);
        double own[2 * lanes], spectrum[7 * lanes], spectrum_derivatives[14 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_spectrum_in_lane(lanes, lane, own, spectrum, spectrum_derivatives);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_symmetric_equations_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, jacobian, moved);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_symmetric_trace_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, slope);
        nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
        nonsmooth_store(lanes, n * p, moved, count, start, directions);
        nonsmooth_store(lanes, p, slope + n * lanes, count, start, directions + n * p * count);
    }
}

/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = NONSMOOTH_LANES, n = 6, p = 5, reduced = 2 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
        double fixed[6 * lanes], x[2 * lanes], equation[2 * lanes], jacobian[4 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[2 * lanes], spectrum[7 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_spectrum_in_lane(lanes, lane, own, spectrum, NULL);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_global_stick_reduced_fixed_in_lane(lanes, lane, parameter, spectrum,
                fixed);
        static const int positive[] = {1, 1};
        nonsmooth_load(lanes, reduced, guess, count, start, x);
        for (int step = 0; step < 32 && nonsmooth_runs(lanes, open); ++step) {
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                dry_friction_global_stick_reduced_in_lane(lanes, lane, parameter, spectrum, fixed,
                    x, NULL, equation, jacobian);
                nonsmooth_newton_in_lane(reduced, positive, lane, jacobian, equation, x, open,
                    taken);
            }
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            dry_friction_global_stick_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                unknown, equation, NULL);
            dry_friction_global_stick_trace_in_lane(lanes, lane, parameter, spectrum, unknown, NULL,
                slope, NULL);
        }
        nonsmooth_largest(lanes, reduced, equation, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = DRY_FRICTION_CONVERGED;
            code = ((unknown[2*lanes + lane] <= 0.0) | (unknown[3*lanes + lane] <= 0.0) |
                (unknown[4*lanes + lane] <= 0.0) | (unknown[5*lanes + lane] <= 0.0)) ?
                DRY_FRICTION_NOT_POSITIVE : code;
            code = open[lane] != 0.0 ? DRY_FRICTION_NOT_CONVERGED : code;
            code = doubt[lane] != 0.0 ? DRY_FRICTION_NOT_FINITE : code;
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
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int counts[] = {4, 3, 2, 3}, at_once[] = {0, 0, 0, 0}, exits[] = {0, 12, 20, 40};
    static const int opened[] = {-1, 0, -1, 1, -1, -1, 1, -1, -1, -1, 0, -1};
    static const int begins[] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    static const nonsmooth_boundaries boundaries = {
        4, 2, counts, at_once, exits, opened, begins, per_unit};
    static const int terms[] = {0, 1, 2, 1}, first[] = {0, 0, 1, 3};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 5 * point, *const u = unknowns + 6 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {u[2], u[3], u[4], u[5]};
        const double measures[] = {p[0], p[2], p[3], p[4], u[0], u[1]};
        double spectral[7], work[16], rows[44], frequencies[4];
        dry_friction_spectrum(q, spectral, NULL);
        dry_friction_global_stick_passage(p, spectral, u, NULL, rows, frequencies);
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, 6, measures, work, bounds + 2 * point);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}

/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. */
NONSMOOTH_MULTIVERSION
void dry_friction_global_stick_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = NONSMOOTH_LANES, n = 6, p = 5 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        double parameter[p * lanes], unknown[n * lanes];
        double jacobian[n * n * lanes], moved[n * p * lanes], slope[(n + p) * lanes];
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        nonsmooth_load(lanes, n, unknowns, count, start, unknown);
        double own[2 * lanes], spectrum[7 * lanes], spectrum_derivatives[14 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_spectrum_in_lane(lanes, lane, own, spectrum, spectrum_derivatives);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_global_stick_equations_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, jacobian, moved);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_global_stick_trace_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, slope);
        nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
        nonsmooth_store(lanes, n * p, moved, count, start, directions);
        nonsmooth_store(lanes, p, slope + n * lanes, count, start, directions + n * p * count);
    }
}

/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
void dry_friction_solution_ii_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = NONSMOOTH_LANES, n = 6, p = 4, reduced = 3 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
        double fixed[5 * lanes], x[3 * lanes], equation[3 * lanes], jacobian[9 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[2 * lanes], spectrum[7 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_spectrum_in_lane(lanes, lane, own, spectrum, NULL);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            dry_friction_solution_ii_reduced_fixed_in_lane(lanes, lane, parameter, spectrum, fixed);
        static const int positive[] = {1, 1, 0};
        nonsmooth_load(lanes, reduced, guess, count, start, x);
        for (int step = 0; step < 32 && nonsmooth_runs(lanes, open); ++step) {
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                dry_friction_solution_ii_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                    NULL, equation, jacobian);
                nonsmooth_newton_in_lane(reduced, positive, lane, jacobian, equation, x, open,
                    taken);
            }
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            dry_friction_solution_ii_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                unknown, equation, NULL);
            dry_friction_solution_ii_trace_in_lane(lanes, lane, parameter, spectrum, unknown, NULL,
                slope, NULL);
        }
        nonsmooth_largest(lanes, reduced, equation, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = DRY_FRICTION_CONVERGED;
            code = ((unknown[2*lanes + lane] <= 0.0) | (unknown[3*lanes + lane] <= 0.0) |
                (unknown[4*lanes + lane] <= 0.0)) ? DRY_FRICTION_NOT_POSITIVE : code;
            code = open[lane] != 0.0 ? DRY_FRICTION_NOT_CONVERGED : code;
            code = doubt[lane] != 0.0 ? DRY_FRICTION_NOT_FINITE : code;
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
void dry_friction_solution_ii_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int counts[] = {4, 3, 2, 3}, at_once[] = {1, 0, 0, 0}, exits[] = {0, 12, 20, 40};
    static const int opened[] = {-1, 0, -1, 1, -1, -1, 1, -1, -1, -1, 0, -1};
    static const int begins[] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    static const nonsmooth_boundaries boundaries = {
        4, 2, counts, at_once, exits, opened, begins, per_unit};
    static const int terms[] = {0, 1, 2, 1}, first[] = {0, 0, 1, 3};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 4 * point, *const u = unknowns + 6 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {0, u[2], u[3], u[4]};
        const double measures[] = {p[0], p[2], p[3], u[0], u[1], u[5]};
        double spectral[7], work[16], rows[44], frequencies[4];
        dry_friction_spectrum(q, spectral, NULL);
        dry_friction_solution_ii_passage(p, spectral, u, NULL, rows, frequencies);
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, 6, measures, work, bounds + 2 * point);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}
