/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 1438dbb9032bd9e6 */
#include "dry_friction.h"

#include <math.h>

#include "support.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Takes parameters (2); gives spectrum (7), derivatives (7, 2), row by row.
 * Operations: 97. Intermediate terms: 45. */
void dry_friction_spectrum(
    const double parameters[2], double spectrum[7], double derivatives[14])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    /* spectrum */
    const double t0 = chi*eta;
    const double t1 = 1 - t0;
    const double t2 = 4*(chi*chi);
    const double gap1 = sqrt(eta*t2 + (t1*t1));
    const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t0 + 1.0/2.0);
    const double t3 = (1.0/(omega1));
    const double t4 = sqrt(1 - chi);
    const double t5 = sqrt(chi);
    const double t6 = sqrt(eta);
    const double t7 = t5*t6;
    const double t8 = t4*t7;
    const double omega2 = t3*t8;
    const double t9 = (1.0/(gap1));
    const double t10 = (1.0/2.0)*t9;
    const double p1 = t1*t10 + 1.0/2.0;
    const double t11 = chi*t9;
    const double p2 = -t11;
    const double p3 = -t0*t9;
    const double omega3 = t7;
    /* d/dchi of: spectrum */
    const double t13 = 2*t1;
    const double gap1_by_chi = t10*(-eta*t13 + 8*t0);
    const double t14 = (1.0/2.0)*gap1_by_chi;
    const double t15 = (1.0/2.0)*eta;
    const double t16 = (1.0/2.0)*t3;
    const double omega1_by_chi = t16*(t14 + t15);
    const double t17 = (1.0/(t5));
    const double t18 = t8/(omega1*omega1);
    const double omega2_by_chi = -omega1_by_chi*t18 - t16*t7/t4 + (1.0/2.0)*t17*t3*t4*t6;
    const double t19 = (1.0/(gap1*gap1));
    const double t20 = t1*t19;
    const double p1_by_chi = -t14*t20 - t15*t9;
    const double t21 = chi*t19;
    const double p2_by_chi = gap1_by_chi*t21 - t9;
    const double t22 = t0*t19;
    const double p3_by_chi = -eta*t9 + gap1_by_chi*t22;
    const double omega3_by_chi = (1.0/2.0)*t17*t6;
    /* d/deta of: spectrum */
    const double gap1_by_eta = t10*(-chi*t13 + t2);
    const double t23 = (1.0/2.0)*gap1_by_eta;
    const double omega1_by_eta = t16*((1.0/2.0)*chi + t23);
    const double t24 = (1.0/(t6));
    const double omega2_by_eta = -omega1_by_eta*t18 + (1.0/2.0)*t24*t3*t4*t5;
    const double p1_by_eta = -1.0/2.0*t11 - t20*t23;
    const double p2_by_eta = gap1_by_eta*t21;
    const double p3_by_eta = gap1_by_eta*t22 - t11;
    const double omega3_by_eta = (1.0/2.0)*t24*t5;
    spectrum[0] = gap1;
    spectrum[1] = omega1;
    spectrum[2] = omega2;
    spectrum[3] = p1;
    spectrum[4] = p2;
    spectrum[5] = p3;
    spectrum[6] = omega3;
    derivatives[0] = gap1_by_chi;
    derivatives[1] = gap1_by_eta;
    derivatives[2] = omega1_by_chi;
    derivatives[3] = omega1_by_eta;
    derivatives[4] = omega2_by_chi;
    derivatives[5] = omega2_by_eta;
    derivatives[6] = p1_by_chi;
    derivatives[7] = p1_by_eta;
    derivatives[8] = p2_by_chi;
    derivatives[9] = p2_by_eta;
    derivatives[10] = p3_by_chi;
    derivatives[11] = p3_by_eta;
    derivatives[12] = omega3_by_chi;
    derivatives[13] = omega3_by_eta;
}

/* State after a time in slip-slip.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 138. Intermediate terms: 26. */
void dry_friction_flow_slip_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega1*t;
    const double t1 = sin(t0);
    const double t2 = (1.0/(omega1));
    const double t3 = t1*t2;
    const double t4 = p1 - 1;
    const double t6 = omega2*t;
    const double t7 = sin(t6);
    const double t8 = t7/omega2;
    const double t9 = cos(t0);
    const double t10 = cos(t6);
    const double t11 = p1*t9 - t10*t4;
    const double t12 = -p2*t10 + p2*t9;
    const double t13 = (1.0/((chi - 1)));
    const double t14 = -us1 - us2;
    const double t15 = t13*t14;
    const double t16 = (1.0/(((chi*chi) - chi)));
    const double t17 = -chi*us1 - us2;
    const double t18 = t16*t17;
    const double t19 = p2*t18;
    const double t20 = p1*t15;
    const double t21 = -p3*t10 + p3*t9;
    const double t22 = p1*t10 - t4*t9;
    const double t23 = p1*t18;
    const double t24 = p3*t15;
    const double t25 = omega2*t7;
    const double t26 = omega1*t1;
    state_after[0] = t10*(t15*t4 + t19) + t11*x1 + t12*x2 + t15 + t9*(-t19 - t20) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(-t23 + t24) + t18 + t21*x1 + t22*x2 + t9*(t16*t17*t4 - t24) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t19 + omega1*t20) + t11*v1 + t12*v2 + t7*(-omega2*t13*t14*t4 - omega2*t19) + x1*(-p1*t26 + t25*t4) + x2*(omega2*p2*t7 - p2*t26);
    state_after[3] = t1*(-omega1*t18*t4 + omega1*t24) + t21*v1 + t22*v2 + t7*(omega2*t23 - omega2*t24) + x1*(omega2*p3*t7 - p3*t26) + x2*(-p1*t25 + t26*t4);
}

/* State after a time in slip-stick.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 28. Intermediate terms: 4. */
void dry_friction_flow_slip_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    (void)spectrum;
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = sin(t);
    const double t1 = chi*t0;
    const double t2 = cos(t);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 - t2*us1 + t2*x1 + t3*x2 + us1 + v2*(chi*t - t1);
    state_after[1] = t*v2 + x2;
    state_after[2] = t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-overshoot.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 136. Intermediate terms: 26. */
void dry_friction_flow_slip_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega1*t;
    const double t1 = sin(t0);
    const double t2 = (1.0/(omega1));
    const double t3 = t1*t2;
    const double t4 = p1 - 1;
    const double t6 = omega2*t;
    const double t7 = sin(t6);
    const double t8 = t7/omega2;
    const double t9 = cos(t0);
    const double t10 = cos(t6);
    const double t11 = p1*t9 - t10*t4;
    const double t12 = -p2*t10 + p2*t9;
    const double t13 = (1.0/((chi - 1)));
    const double t15 = -us1 + us2;
    const double t16 = t13*t15;
    const double t17 = (1.0/(((chi*chi) - chi)));
    const double t18 = -chi*us1 + us2;
    const double t19 = t17*t18;
    const double t20 = p2*t19;
    const double t21 = p1*t16;
    const double t22 = -p3*t10 + p3*t9;
    const double t23 = p1*t10 - t4*t9;
    const double t24 = p1*t19;
    const double t25 = p3*t16;
    const double t26 = omega2*t7;
    const double t27 = omega1*t1;
    state_after[0] = t10*(t16*t4 + t20) + t11*x1 + t12*x2 + t16 + t9*(-t20 - t21) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(-t24 + t25) + t19 + t22*x1 + t23*x2 + t9*(t17*t18*t4 - t25) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t20 + omega1*t21) + t11*v1 + t12*v2 + t7*(-omega2*t13*t15*t4 - omega2*t20) + x1*(-p1*t27 + t26*t4) + x2*(omega2*p2*t7 - p2*t27);
    state_after[3] = t1*(-omega1*t19*t4 + omega1*t25) + t22*v1 + t23*v2 + t7*(omega2*t24 - omega2*t25) + x1*(omega2*p3*t7 - p3*t27) + x2*(-p1*t26 + t27*t4);
}

/* State after a time in stick-slip.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 29. Intermediate terms: 7. */
void dry_friction_flow_stick_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us2 = parameters[5];
    const double omega3 = spectrum[6];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega3*t;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = us2/chi;
    const double t6 = omega3*t1;
    state_after[0] = t*v1 + x1;
    state_after[1] = t2*v2 - t3*t5 + t3*x2 + t4*x1 + t5 + v1*(t - t2);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*t6 + t6*x1 - t6*x2;
}

/* State after a time in stick-stick.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 4. Intermediate terms: 0. */
void dry_friction_flow_stick_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    (void)spectrum;
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    state_after[0] = t*v1 + x1;
    state_after[1] = t*v2 + x2;
    state_after[2] = v1;
    state_after[3] = v2;
}

/* State after a time in stick-overshoot.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 29. Intermediate terms: 7. */
void dry_friction_flow_stick_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us2 = parameters[5];
    const double omega3 = spectrum[6];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega3*t;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = us2/chi;
    const double t6 = omega3*t1;
    state_after[0] = t*v1 + x1;
    state_after[1] = t2*v2 + t3*t5 + t3*x2 + t4*x1 - t5 + v1*(t - t2);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 - t5*t6 + t6*x1 - t6*x2;
}

/* State after a time in overshoot-slip.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 136. Intermediate terms: 26. */
void dry_friction_flow_overshoot_slip(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega1*t;
    const double t1 = sin(t0);
    const double t2 = (1.0/(omega1));
    const double t3 = t1*t2;
    const double t4 = p1 - 1;
    const double t6 = omega2*t;
    const double t7 = sin(t6);
    const double t8 = t7/omega2;
    const double t9 = cos(t0);
    const double t10 = cos(t6);
    const double t11 = p1*t9 - t10*t4;
    const double t12 = -p2*t10 + p2*t9;
    const double t13 = (1.0/((chi - 1)));
    const double t15 = us1 - us2;
    const double t16 = t13*t15;
    const double t17 = (1.0/(((chi*chi) - chi)));
    const double t18 = chi*us1 - us2;
    const double t19 = t17*t18;
    const double t20 = p2*t19;
    const double t21 = p1*t16;
    const double t22 = -p3*t10 + p3*t9;
    const double t23 = p1*t10 - t4*t9;
    const double t24 = p1*t19;
    const double t25 = p3*t16;
    const double t26 = omega2*t7;
    const double t27 = omega1*t1;
    state_after[0] = t10*(t16*t4 + t20) + t11*x1 + t12*x2 + t16 + t9*(-t20 - t21) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(-t24 + t25) + t19 + t22*x1 + t23*x2 + t9*(t17*t18*t4 - t25) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t20 + omega1*t21) + t11*v1 + t12*v2 + t7*(-omega2*t13*t15*t4 - omega2*t20) + x1*(-p1*t27 + t26*t4) + x2*(omega2*p2*t7 - p2*t27);
    state_after[3] = t1*(-omega1*t19*t4 + omega1*t25) + t22*v1 + t23*v2 + t7*(omega2*t24 - omega2*t25) + x1*(omega2*p3*t7 - p3*t27) + x2*(-p1*t26 + t27*t4);
}

/* State after a time in overshoot-stick.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 28. Intermediate terms: 4. */
void dry_friction_flow_overshoot_stick(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    (void)spectrum;
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = sin(t);
    const double t1 = chi*t0;
    const double t2 = cos(t);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*us1 + t2*x1 + t3*x2 - us1 + v2*(chi*t - t1);
    state_after[1] = t*v2 + x2;
    state_after[2] = -t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in overshoot-overshoot.
 * Takes parameters (7), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 136. Intermediate terms: 26. */
void dry_friction_flow_overshoot_overshoot(
    const double parameters[7], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega1*t;
    const double t1 = sin(t0);
    const double t2 = (1.0/(omega1));
    const double t3 = t1*t2;
    const double t4 = p1 - 1;
    const double t6 = omega2*t;
    const double t7 = sin(t6);
    const double t8 = t7/omega2;
    const double t9 = cos(t0);
    const double t10 = cos(t6);
    const double t11 = p1*t9 - t10*t4;
    const double t12 = -p2*t10 + p2*t9;
    const double t13 = (1.0/((chi - 1)));
    const double t14 = us1 + us2;
    const double t15 = t13*t14;
    const double t16 = (1.0/(((chi*chi) - chi)));
    const double t17 = chi*us1 + us2;
    const double t18 = t16*t17;
    const double t19 = p2*t18;
    const double t20 = p1*t15;
    const double t21 = -p3*t10 + p3*t9;
    const double t22 = p1*t10 - t4*t9;
    const double t23 = p1*t18;
    const double t24 = p3*t15;
    const double t25 = omega2*t7;
    const double t26 = omega1*t1;
    state_after[0] = t10*(t15*t4 + t19) + t11*x1 + t12*x2 + t15 + t9*(-t19 - t20) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(-t23 + t24) + t18 + t21*x1 + t22*x2 + t9*(t16*t17*t4 - t24) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t19 + omega1*t20) + t11*v1 + t12*v2 + t7*(-omega2*t13*t14*t4 - omega2*t19) + x1*(-p1*t26 + t25*t4) + x2*(omega2*p2*t7 - p2*t26);
    state_after[3] = t1*(-omega1*t18*t4 + omega1*t24) + t21*v1 + t22*v2 + t7*(omega2*t23 - omega2*t24) + x1*(omega2*p3*t7 - p3*t26) + x2*(-p1*t25 + t26*t4);
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Takes parameters (7); gives fields (36, 5), row by row.
 * Operations: 20. Intermediate terms: 2. */
void dry_friction_fields(
    const double parameters[7], double fields[180])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    /* outputs */
    const double t0 = chi*eta;
    const double t2 = eta*us2;
    fields[0] = 0;
    fields[1] = 0;
    fields[2] = 1;
    fields[3] = 0;
    fields[4] = 0;
    fields[5] = 0;
    fields[6] = 0;
    fields[7] = 0;
    fields[8] = 1;
    fields[9] = 0;
    fields[10] = -1;
    fields[11] = chi;
    fields[12] = 0;
    fields[13] = 0;
    fields[14] = us1;
    fields[15] = t0;
    fields[16] = -t0;
    fields[17] = 0;
    fields[18] = 0;
    fields[19] = t2;
    fields[20] = 0;
    fields[21] = 0;
    fields[22] = 1;
    fields[23] = 0;
    fields[24] = 0;
    fields[25] = 0;
    fields[26] = 0;
    fields[27] = 0;
    fields[28] = 1;
    fields[29] = 0;
    fields[30] = -1;
    fields[31] = chi;
    fields[32] = 0;
    fields[33] = 0;
    fields[34] = us1;
    fields[35] = 0;
    fields[36] = 0;
    fields[37] = 0;
    fields[38] = 0;
    fields[39] = 0;
    fields[40] = 0;
    fields[41] = 0;
    fields[42] = 1;
    fields[43] = 0;
    fields[44] = 0;
    fields[45] = 0;
    fields[46] = 0;
    fields[47] = 0;
    fields[48] = 1;
    fields[49] = 0;
    fields[50] = -1;
    fields[51] = chi;
    fields[52] = 0;
    fields[53] = 0;
    fields[54] = us1;
    fields[55] = t0;
    fields[56] = -t0;
    fields[57] = 0;
    fields[58] = 0;
    fields[59] = -t2;
    fields[60] = 0;
    fields[61] = 0;
    fields[62] = 1;
    fields[63] = 0;
    fields[64] = 0;
    fields[65] = 0;
    fields[66] = 0;
    fields[67] = 0;
    fields[68] = 1;
    fields[69] = 0;
    fields[70] = 0;
    fields[71] = 0;
    fields[72] = 0;
    fields[73] = 0;
    fields[74] = 0;
    fields[75] = t0;
    fields[76] = -t0;
    fields[77] = 0;
    fields[78] = 0;
    fields[79] = t2;
    fields[80] = 0;
    fields[81] = 0;
    fields[82] = 1;
    fields[83] = 0;
    fields[84] = 0;
    fields[85] = 0;
    fields[86] = 0;
    fields[87] = 0;
    fields[88] = 1;
    fields[89] = 0;
    fields[90] = 0;
    fields[91] = 0;
    fields[92] = 0;
    fields[93] = 0;
    fields[94] = 0;
    fields[95] = 0;
    fields[96] = 0;
    fields[97] = 0;
    fields[98] = 0;
    fields[99] = 0;
    fields[100] = 0;
    fields[101] = 0;
    fields[102] = 1;
    fields[103] = 0;
    fields[104] = 0;
    fields[105] = 0;
    fields[106] = 0;
    fields[107] = 0;
    fields[108] = 1;
    fields[109] = 0;
    fields[110] = 0;
    fields[111] = 0;
    fields[112] = 0;
    fields[113] = 0;
    fields[114] = 0;
    fields[115] = t0;
    fields[116] = -t0;
    fields[117] = 0;
    fields[118] = 0;
    fields[119] = -t2;
    fields[120] = 0;
    fields[121] = 0;
    fields[122] = 1;
    fields[123] = 0;
    fields[124] = 0;
    fields[125] = 0;
    fields[126] = 0;
    fields[127] = 0;
    fields[128] = 1;
    fields[129] = 0;
    fields[130] = -1;
    fields[131] = chi;
    fields[132] = 0;
    fields[133] = 0;
    fields[134] = -us1;
    fields[135] = t0;
    fields[136] = -t0;
    fields[137] = 0;
    fields[138] = 0;
    fields[139] = t2;
    fields[140] = 0;
    fields[141] = 0;
    fields[142] = 1;
    fields[143] = 0;
    fields[144] = 0;
    fields[145] = 0;
    fields[146] = 0;
    fields[147] = 0;
    fields[148] = 1;
    fields[149] = 0;
    fields[150] = -1;
    fields[151] = chi;
    fields[152] = 0;
    fields[153] = 0;
    fields[154] = -us1;
    fields[155] = 0;
    fields[156] = 0;
    fields[157] = 0;
    fields[158] = 0;
    fields[159] = 0;
    fields[160] = 0;
    fields[161] = 0;
    fields[162] = 1;
    fields[163] = 0;
    fields[164] = 0;
    fields[165] = 0;
    fields[166] = 0;
    fields[167] = 0;
    fields[168] = 1;
    fields[169] = 0;
    fields[170] = -1;
    fields[171] = chi;
    fields[172] = 0;
    fields[173] = 0;
    fields[174] = -us1;
    fields[175] = t0;
    fields[176] = -t0;
    fields[177] = 0;
    fields[178] = 0;
    fields[179] = -t2;
}

/* Affine functions of the state: gradients, constants last.
 * Takes parameters (7); gives rows (17, 5), row by row.
 * Operations: 16. Intermediate terms: 0. */
void dry_friction_rows(
    const double parameters[7], double rows[85])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double us1 = parameters[3];
    const double ur1 = parameters[4];
    const double us2 = parameters[5];
    const double ur2 = parameters[6];
    rows[0] = 0;
    rows[1] = 0;
    rows[2] = 1;
    rows[3] = 0;
    rows[4] = -V;
    rows[5] = 0;
    rows[6] = 0;
    rows[7] = 0;
    rows[8] = 1;
    rows[9] = -V;
    rows[10] = -chi;
    rows[11] = chi;
    rows[12] = 0;
    rows[13] = 0;
    rows[14] = -ur2;
    rows[15] = chi;
    rows[16] = -chi;
    rows[17] = 0;
    rows[18] = 0;
    rows[19] = -ur2;
    rows[20] = 0;
    rows[21] = 0;
    rows[22] = 0;
    rows[23] = -1;
    rows[24] = V;
    rows[25] = 1;
    rows[26] = -chi;
    rows[27] = 0;
    rows[28] = 0;
    rows[29] = -ur1;
    rows[30] = -1;
    rows[31] = chi;
    rows[32] = 0;
    rows[33] = 0;
    rows[34] = -ur1;
    rows[35] = 0;
    rows[36] = 0;
    rows[37] = -1;
    rows[38] = 0;
    rows[39] = V;
    rows[40] = 0;
    rows[41] = 0;
    rows[42] = 0;
    rows[43] = 0;
    rows[44] = us1;
    rows[45] = 1;
    rows[46] = -chi;
    rows[47] = 0;
    rows[48] = 0;
    rows[49] = 0;
    rows[50] = 0;
    rows[51] = 0;
    rows[52] = 0;
    rows[53] = 0;
    rows[54] = -us1;
    rows[55] = 0;
    rows[56] = 0;
    rows[57] = 1;
    rows[58] = 0;
    rows[59] = 0;
    rows[60] = 0;
    rows[61] = 0;
    rows[62] = 0;
    rows[63] = 0;
    rows[64] = V;
    rows[65] = 0;
    rows[66] = 0;
    rows[67] = 0;
    rows[68] = 0;
    rows[69] = us2;
    rows[70] = -chi;
    rows[71] = chi;
    rows[72] = 0;
    rows[73] = 0;
    rows[74] = 0;
    rows[75] = 0;
    rows[76] = 0;
    rows[77] = 0;
    rows[78] = 0;
    rows[79] = -us2;
    rows[80] = 0;
    rows[81] = 0;
    rows[82] = 0;
    rows[83] = 1;
    rows[84] = 0;
}

/* Affine resets of the state, one below the other, offsets last.
 * Takes parameters (7); gives resets (16, 5), row by row.
 * Operations: 0. Intermediate terms: 0. */
void dry_friction_resets(
    const double parameters[7], double resets[80])
{
    const double V = parameters[2];
    resets[0] = 1;
    resets[1] = 0;
    resets[2] = 0;
    resets[3] = 0;
    resets[4] = 0;
    resets[5] = 0;
    resets[6] = 1;
    resets[7] = 0;
    resets[8] = 0;
    resets[9] = 0;
    resets[10] = 0;
    resets[11] = 0;
    resets[12] = 1;
    resets[13] = 0;
    resets[14] = 0;
    resets[15] = 0;
    resets[16] = 0;
    resets[17] = 0;
    resets[18] = 1;
    resets[19] = 0;
    resets[20] = 1;
    resets[21] = 0;
    resets[22] = 0;
    resets[23] = 0;
    resets[24] = 0;
    resets[25] = 0;
    resets[26] = 1;
    resets[27] = 0;
    resets[28] = 0;
    resets[29] = 0;
    resets[30] = 0;
    resets[31] = 0;
    resets[32] = 1;
    resets[33] = 0;
    resets[34] = 0;
    resets[35] = 0;
    resets[36] = 0;
    resets[37] = 0;
    resets[38] = 0;
    resets[39] = V;
    resets[40] = 1;
    resets[41] = 0;
    resets[42] = 0;
    resets[43] = 0;
    resets[44] = 0;
    resets[45] = 0;
    resets[46] = 1;
    resets[47] = 0;
    resets[48] = 0;
    resets[49] = 0;
    resets[50] = 0;
    resets[51] = 0;
    resets[52] = 0;
    resets[53] = 0;
    resets[54] = V;
    resets[55] = 0;
    resets[56] = 0;
    resets[57] = 0;
    resets[58] = 1;
    resets[59] = 0;
    resets[60] = 1;
    resets[61] = 0;
    resets[62] = 0;
    resets[63] = 0;
    resets[64] = 0;
    resets[65] = 0;
    resets[66] = 1;
    resets[67] = 0;
    resets[68] = 0;
    resets[69] = 0;
    resets[70] = 0;
    resets[71] = 0;
    resets[72] = 0;
    resets[73] = 0;
    resets[74] = V;
    resets[75] = 0;
    resets[76] = 0;
    resets[77] = 0;
    resets[78] = 0;
    resets[79] = V;
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Takes parameters (7), spectrum (7); gives exponents (21, 2), coefficients (152, 5), row by row.
 * Operations: 231. Intermediate terms: 45. */
void dry_friction_modes(
    const double parameters[7], const double spectrum[7], double exponents[42], double coefficients[760])
{
    const double chi = parameters[0];
    const double us1 = parameters[3];
    const double us2 = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    /* outputs */
    const double t0 = (1.0/((chi - 1)));
    const double t1 = us1 + us2;
    const double t3 = -t0*t1;
    const double t5 = (1.0/(((chi*chi) - chi)));
    const double t6 = chi*us1;
    const double t7 = t6 + us2;
    const double t9 = -t5*t7;
    const double t10 = p2*t9;
    const double t11 = p1 - 1;
    const double t13 = p3*t3;
    const double t14 = (1.0/(omega1));
    const double t15 = p1*t14;
    const double t16 = p2*t14;
    const double t17 = p3*t14;
    const double t18 = -t11*t14;
    const double t19 = omega1*p1;
    const double t21 = omega1*p2;
    const double t23 = omega1*p3;
    const double t25 = -omega1*t11;
    const double t29 = (1.0/(omega2));
    const double t30 = -t11*t29;
    const double t31 = -p2*t29;
    const double t32 = -p3*t29;
    const double t33 = p1*t29;
    const double t34 = omega2*t11;
    const double t35 = omega2*p2;
    const double t36 = omega2*p3;
    const double t37 = omega2*p1;
    const double t41 = us1 - us2;
    const double t43 = -t0*t41;
    const double t44 = t6 - us2;
    const double t46 = -t44*t5;
    const double t47 = p2*t46;
    const double t48 = p3*t43;
    const double t49 = us2/chi;
    const double t51 = (1.0/(omega3));
    const double t54 = omega3*t49;
    const double t55 = t0*t41;
    const double t56 = t44*t5;
    const double t57 = p2*t56;
    const double t58 = p3*t55;
    const double t59 = t0*t1;
    const double t60 = t5*t7;
    const double t61 = p2*t60;
    const double t62 = p3*t59;
    exponents[0] = 0;
    exponents[1] = 0;
    exponents[2] = 0;
    exponents[3] = omega1;
    exponents[4] = 0;
    exponents[5] = omega2;
    exponents[6] = 0;
    exponents[7] = 0;
    exponents[8] = 0;
    exponents[9] = 1;
    exponents[10] = 0;
    exponents[11] = 0;
    exponents[12] = 0;
    exponents[13] = omega1;
    exponents[14] = 0;
    exponents[15] = omega2;
    exponents[16] = 0;
    exponents[17] = 0;
    exponents[18] = 0;
    exponents[19] = omega3;
    exponents[20] = 0;
    exponents[21] = 0;
    exponents[22] = 0;
    exponents[23] = 0;
    exponents[24] = 0;
    exponents[25] = omega3;
    exponents[26] = 0;
    exponents[27] = 0;
    exponents[28] = 0;
    exponents[29] = omega1;
    exponents[30] = 0;
    exponents[31] = omega2;
    exponents[32] = 0;
    exponents[33] = 0;
    exponents[34] = 0;
    exponents[35] = 1;
    exponents[36] = 0;
    exponents[37] = 0;
    exponents[38] = 0;
    exponents[39] = omega1;
    exponents[40] = 0;
    exponents[41] = omega2;
    coefficients[0] = 0;
    coefficients[1] = 0;
    coefficients[2] = 0;
    coefficients[3] = 0;
    coefficients[4] = t3;
    coefficients[5] = 0;
    coefficients[6] = 0;
    coefficients[7] = 0;
    coefficients[8] = 0;
    coefficients[9] = t9;
    coefficients[10] = 0;
    coefficients[11] = 0;
    coefficients[12] = 0;
    coefficients[13] = 0;
    coefficients[14] = 0;
    coefficients[15] = 0;
    coefficients[16] = 0;
    coefficients[17] = 0;
    coefficients[18] = 0;
    coefficients[19] = 0;
    coefficients[20] = p1;
    coefficients[21] = p2;
    coefficients[22] = 0;
    coefficients[23] = 0;
    coefficients[24] = -p1*t3 - t10;
    coefficients[25] = p3;
    coefficients[26] = -t11;
    coefficients[27] = 0;
    coefficients[28] = 0;
    coefficients[29] = -t11*t5*t7 - t13;
    coefficients[30] = 0;
    coefficients[31] = 0;
    coefficients[32] = p1;
    coefficients[33] = p2;
    coefficients[34] = 0;
    coefficients[35] = 0;
    coefficients[36] = 0;
    coefficients[37] = p3;
    coefficients[38] = -t11;
    coefficients[39] = 0;
    coefficients[40] = 0;
    coefficients[41] = 0;
    coefficients[42] = t15;
    coefficients[43] = t16;
    coefficients[44] = 0;
    coefficients[45] = 0;
    coefficients[46] = 0;
    coefficients[47] = t17;
    coefficients[48] = t18;
    coefficients[49] = 0;
    coefficients[50] = -t19;
    coefficients[51] = -t21;
    coefficients[52] = 0;
    coefficients[53] = 0;
    coefficients[54] = t19*t3 + t21*t9;
    coefficients[55] = -t23;
    coefficients[56] = -t25;
    coefficients[57] = 0;
    coefficients[58] = 0;
    coefficients[59] = t23*t3 + t25*t9;
    coefficients[60] = -t11;
    coefficients[61] = -p2;
    coefficients[62] = 0;
    coefficients[63] = 0;
    coefficients[64] = t10 + t11*t3;
    coefficients[65] = -p3;
    coefficients[66] = p1;
    coefficients[67] = 0;
    coefficients[68] = 0;
    coefficients[69] = -p1*t9 + t13;
    coefficients[70] = 0;
    coefficients[71] = 0;
    coefficients[72] = -t11;
    coefficients[73] = -p2;
    coefficients[74] = 0;
    coefficients[75] = 0;
    coefficients[76] = 0;
    coefficients[77] = -p3;
    coefficients[78] = p1;
    coefficients[79] = 0;
    coefficients[80] = 0;
    coefficients[81] = 0;
    coefficients[82] = t30;
    coefficients[83] = t31;
    coefficients[84] = 0;
    coefficients[85] = 0;
    coefficients[86] = 0;
    coefficients[87] = t32;
    coefficients[88] = t33;
    coefficients[89] = 0;
    coefficients[90] = t34;
    coefficients[91] = t35;
    coefficients[92] = 0;
    coefficients[93] = 0;
    coefficients[94] = omega2*t0*t1*t11 - t35*t9;
    coefficients[95] = t36;
    coefficients[96] = -t37;
    coefficients[97] = 0;
    coefficients[98] = 0;
    coefficients[99] = -t3*t36 + t37*t9;
    coefficients[100] = 0;
    coefficients[101] = chi;
    coefficients[102] = 0;
    coefficients[103] = 0;
    coefficients[104] = us1;
    coefficients[105] = 0;
    coefficients[106] = 1;
    coefficients[107] = 0;
    coefficients[108] = 0;
    coefficients[109] = 0;
    coefficients[110] = 0;
    coefficients[111] = 0;
    coefficients[112] = 0;
    coefficients[113] = chi;
    coefficients[114] = 0;
    coefficients[115] = 0;
    coefficients[116] = 0;
    coefficients[117] = 0;
    coefficients[118] = 1;
    coefficients[119] = 0;
    coefficients[120] = 0;
    coefficients[121] = 0;
    coefficients[122] = 0;
    coefficients[123] = chi;
    coefficients[124] = 0;
    coefficients[125] = 0;
    coefficients[126] = 0;
    coefficients[127] = 0;
    coefficients[128] = 1;
    coefficients[129] = 0;
    coefficients[130] = 0;
    coefficients[131] = 0;
    coefficients[132] = 0;
    coefficients[133] = 0;
    coefficients[134] = 0;
    coefficients[135] = 0;
    coefficients[136] = 0;
    coefficients[137] = 0;
    coefficients[138] = 0;
    coefficients[139] = 0;
    coefficients[140] = 1;
    coefficients[141] = -chi;
    coefficients[142] = 0;
    coefficients[143] = 0;
    coefficients[144] = -us1;
    coefficients[145] = 0;
    coefficients[146] = 0;
    coefficients[147] = 0;
    coefficients[148] = 0;
    coefficients[149] = 0;
    coefficients[150] = 0;
    coefficients[151] = 0;
    coefficients[152] = 1;
    coefficients[153] = -chi;
    coefficients[154] = 0;
    coefficients[155] = 0;
    coefficients[156] = 0;
    coefficients[157] = 0;
    coefficients[158] = 0;
    coefficients[159] = 0;
    coefficients[160] = 0;
    coefficients[161] = 0;
    coefficients[162] = 1;
    coefficients[163] = -chi;
    coefficients[164] = 0;
    coefficients[165] = 0;
    coefficients[166] = 0;
    coefficients[167] = 0;
    coefficients[168] = 0;
    coefficients[169] = 0;
    coefficients[170] = -1;
    coefficients[171] = chi;
    coefficients[172] = 0;
    coefficients[173] = 0;
    coefficients[174] = us1;
    coefficients[175] = 0;
    coefficients[176] = 0;
    coefficients[177] = 0;
    coefficients[178] = 0;
    coefficients[179] = 0;
    coefficients[180] = 0;
    coefficients[181] = 0;
    coefficients[182] = 0;
    coefficients[183] = 0;
    coefficients[184] = t43;
    coefficients[185] = 0;
    coefficients[186] = 0;
    coefficients[187] = 0;
    coefficients[188] = 0;
    coefficients[189] = t46;
    coefficients[190] = 0;
    coefficients[191] = 0;
    coefficients[192] = 0;
    coefficients[193] = 0;
    coefficients[194] = 0;
    coefficients[195] = 0;
    coefficients[196] = 0;
    coefficients[197] = 0;
    coefficients[198] = 0;
    coefficients[199] = 0;
    coefficients[200] = p1;
    coefficients[201] = p2;
    coefficients[202] = 0;
    coefficients[203] = 0;
    coefficients[204] = -p1*t43 - t47;
    coefficients[205] = p3;
    coefficients[206] = -t11;
    coefficients[207] = 0;
    coefficients[208] = 0;
    coefficients[209] = -t11*t44*t5 - t48;
    coefficients[210] = 0;
    coefficients[211] = 0;
    coefficients[212] = p1;
    coefficients[213] = p2;
    coefficients[214] = 0;
    coefficients[215] = 0;
    coefficients[216] = 0;
    coefficients[217] = p3;
    coefficients[218] = -t11;
    coefficients[219] = 0;
    coefficients[220] = 0;
    coefficients[221] = 0;
    coefficients[222] = t15;
    coefficients[223] = t16;
    coefficients[224] = 0;
    coefficients[225] = 0;
    coefficients[226] = 0;
    coefficients[227] = t17;
    coefficients[228] = t18;
    coefficients[229] = 0;
    coefficients[230] = -t19;
    coefficients[231] = -t21;
    coefficients[232] = 0;
    coefficients[233] = 0;
    coefficients[234] = t19*t43 + t21*t46;
    coefficients[235] = -t23;
    coefficients[236] = -t25;
    coefficients[237] = 0;
    coefficients[238] = 0;
    coefficients[239] = t23*t43 + t25*t46;
    coefficients[240] = -t11;
    coefficients[241] = -p2;
    coefficients[242] = 0;
    coefficients[243] = 0;
    coefficients[244] = t11*t43 + t47;
    coefficients[245] = -p3;
    coefficients[246] = p1;
    coefficients[247] = 0;
    coefficients[248] = 0;
    coefficients[249] = -p1*t46 + t48;
    coefficients[250] = 0;
    coefficients[251] = 0;
    coefficients[252] = -t11;
    coefficients[253] = -p2;
    coefficients[254] = 0;
    coefficients[255] = 0;
    coefficients[256] = 0;
    coefficients[257] = -p3;
    coefficients[258] = p1;
    coefficients[259] = 0;
    coefficients[260] = 0;
    coefficients[261] = 0;
    coefficients[262] = t30;
    coefficients[263] = t31;
    coefficients[264] = 0;
    coefficients[265] = 0;
    coefficients[266] = 0;
    coefficients[267] = t32;
    coefficients[268] = t33;
    coefficients[269] = 0;
    coefficients[270] = t34;
    coefficients[271] = t35;
    coefficients[272] = 0;
    coefficients[273] = 0;
    coefficients[274] = omega2*t0*t11*t41 - t35*t46;
    coefficients[275] = t36;
    coefficients[276] = -t37;
    coefficients[277] = 0;
    coefficients[278] = 0;
    coefficients[279] = -t36*t43 + t37*t46;
    coefficients[280] = 1;
    coefficients[281] = 0;
    coefficients[282] = 0;
    coefficients[283] = 0;
    coefficients[284] = 0;
    coefficients[285] = 1;
    coefficients[286] = 0;
    coefficients[287] = 0;
    coefficients[288] = 0;
    coefficients[289] = t49;
    coefficients[290] = 0;
    coefficients[291] = 0;
    coefficients[292] = 1;
    coefficients[293] = 0;
    coefficients[294] = 0;
    coefficients[295] = 0;
    coefficients[296] = 0;
    coefficients[297] = 1;
    coefficients[298] = 0;
    coefficients[299] = 0;
    coefficients[300] = 0;
    coefficients[301] = 0;
    coefficients[302] = 1;
    coefficients[303] = 0;
    coefficients[304] = 0;
    coefficients[305] = 0;
    coefficients[306] = 0;
    coefficients[307] = 1;
    coefficients[308] = 0;
    coefficients[309] = 0;
    coefficients[310] = 0;
    coefficients[311] = 0;
    coefficients[312] = 0;
    coefficients[313] = 0;
    coefficients[314] = 0;
    coefficients[315] = 0;
    coefficients[316] = 0;
    coefficients[317] = 0;
    coefficients[318] = 0;
    coefficients[319] = 0;
    coefficients[320] = 0;
    coefficients[321] = 0;
    coefficients[322] = 0;
    coefficients[323] = 0;
    coefficients[324] = 0;
    coefficients[325] = -1;
    coefficients[326] = 1;
    coefficients[327] = 0;
    coefficients[328] = 0;
    coefficients[329] = -t49;
    coefficients[330] = 0;
    coefficients[331] = 0;
    coefficients[332] = 0;
    coefficients[333] = 0;
    coefficients[334] = 0;
    coefficients[335] = 0;
    coefficients[336] = 0;
    coefficients[337] = -1;
    coefficients[338] = 1;
    coefficients[339] = 0;
    coefficients[340] = 0;
    coefficients[341] = 0;
    coefficients[342] = 0;
    coefficients[343] = 0;
    coefficients[344] = 0;
    coefficients[345] = 0;
    coefficients[346] = 0;
    coefficients[347] = -t51;
    coefficients[348] = t51;
    coefficients[349] = 0;
    coefficients[350] = 0;
    coefficients[351] = 0;
    coefficients[352] = 0;
    coefficients[353] = 0;
    coefficients[354] = 0;
    coefficients[355] = omega3;
    coefficients[356] = -omega3;
    coefficients[357] = 0;
    coefficients[358] = 0;
    coefficients[359] = t54;
    coefficients[360] = 1;
    coefficients[361] = 0;
    coefficients[362] = 0;
    coefficients[363] = 0;
    coefficients[364] = 0;
    coefficients[365] = 0;
    coefficients[366] = 1;
    coefficients[367] = 0;
    coefficients[368] = 0;
    coefficients[369] = 0;
    coefficients[370] = 0;
    coefficients[371] = 0;
    coefficients[372] = 1;
    coefficients[373] = 0;
    coefficients[374] = 0;
    coefficients[375] = 0;
    coefficients[376] = 0;
    coefficients[377] = 0;
    coefficients[378] = 1;
    coefficients[379] = 0;
    coefficients[380] = 0;
    coefficients[381] = 0;
    coefficients[382] = 1;
    coefficients[383] = 0;
    coefficients[384] = 0;
    coefficients[385] = 0;
    coefficients[386] = 0;
    coefficients[387] = 0;
    coefficients[388] = 1;
    coefficients[389] = 0;
    coefficients[390] = 0;
    coefficients[391] = 0;
    coefficients[392] = 0;
    coefficients[393] = 0;
    coefficients[394] = 0;
    coefficients[395] = 0;
    coefficients[396] = 0;
    coefficients[397] = 0;
    coefficients[398] = 0;
    coefficients[399] = 0;
    coefficients[400] = 1;
    coefficients[401] = 0;
    coefficients[402] = 0;
    coefficients[403] = 0;
    coefficients[404] = 0;
    coefficients[405] = 1;
    coefficients[406] = 0;
    coefficients[407] = 0;
    coefficients[408] = 0;
    coefficients[409] = -t49;
    coefficients[410] = 0;
    coefficients[411] = 0;
    coefficients[412] = 1;
    coefficients[413] = 0;
    coefficients[414] = 0;
    coefficients[415] = 0;
    coefficients[416] = 0;
    coefficients[417] = 1;
    coefficients[418] = 0;
    coefficients[419] = 0;
    coefficients[420] = 0;
    coefficients[421] = 0;
    coefficients[422] = 1;
    coefficients[423] = 0;
    coefficients[424] = 0;
    coefficients[425] = 0;
    coefficients[426] = 0;
    coefficients[427] = 1;
    coefficients[428] = 0;
    coefficients[429] = 0;
    coefficients[430] = 0;
    coefficients[431] = 0;
    coefficients[432] = 0;
    coefficients[433] = 0;
    coefficients[434] = 0;
    coefficients[435] = 0;
    coefficients[436] = 0;
    coefficients[437] = 0;
    coefficients[438] = 0;
    coefficients[439] = 0;
    coefficients[440] = 0;
    coefficients[441] = 0;
    coefficients[442] = 0;
    coefficients[443] = 0;
    coefficients[444] = 0;
    coefficients[445] = -1;
    coefficients[446] = 1;
    coefficients[447] = 0;
    coefficients[448] = 0;
    coefficients[449] = t49;
    coefficients[450] = 0;
    coefficients[451] = 0;
    coefficients[452] = 0;
    coefficients[453] = 0;
    coefficients[454] = 0;
    coefficients[455] = 0;
    coefficients[456] = 0;
    coefficients[457] = -1;
    coefficients[458] = 1;
    coefficients[459] = 0;
    coefficients[460] = 0;
    coefficients[461] = 0;
    coefficients[462] = 0;
    coefficients[463] = 0;
    coefficients[464] = 0;
    coefficients[465] = 0;
    coefficients[466] = 0;
    coefficients[467] = -t51;
    coefficients[468] = t51;
    coefficients[469] = 0;
    coefficients[470] = 0;
    coefficients[471] = 0;
    coefficients[472] = 0;
    coefficients[473] = 0;
    coefficients[474] = 0;
    coefficients[475] = omega3;
    coefficients[476] = -omega3;
    coefficients[477] = 0;
    coefficients[478] = 0;
    coefficients[479] = -t54;
    coefficients[480] = 0;
    coefficients[481] = 0;
    coefficients[482] = 0;
    coefficients[483] = 0;
    coefficients[484] = t55;
    coefficients[485] = 0;
    coefficients[486] = 0;
    coefficients[487] = 0;
    coefficients[488] = 0;
    coefficients[489] = t56;
    coefficients[490] = 0;
    coefficients[491] = 0;
    coefficients[492] = 0;
    coefficients[493] = 0;
    coefficients[494] = 0;
    coefficients[495] = 0;
    coefficients[496] = 0;
    coefficients[497] = 0;
    coefficients[498] = 0;
    coefficients[499] = 0;
    coefficients[500] = p1;
    coefficients[501] = p2;
    coefficients[502] = 0;
    coefficients[503] = 0;
    coefficients[504] = -p1*t55 - t57;
    coefficients[505] = p3;
    coefficients[506] = -t11;
    coefficients[507] = 0;
    coefficients[508] = 0;
    coefficients[509] = t11*t44*t5 - t58;
    coefficients[510] = 0;
    coefficients[511] = 0;
    coefficients[512] = p1;
    coefficients[513] = p2;
    coefficients[514] = 0;
    coefficients[515] = 0;
    coefficients[516] = 0;
    coefficients[517] = p3;
    coefficients[518] = -t11;
    coefficients[519] = 0;
    coefficients[520] = 0;
    coefficients[521] = 0;
    coefficients[522] = t15;
    coefficients[523] = t16;
    coefficients[524] = 0;
    coefficients[525] = 0;
    coefficients[526] = 0;
    coefficients[527] = t17;
    coefficients[528] = t18;
    coefficients[529] = 0;
    coefficients[530] = -t19;
    coefficients[531] = -t21;
    coefficients[532] = 0;
    coefficients[533] = 0;
    coefficients[534] = t19*t55 + t21*t56;
    coefficients[535] = -t23;
    coefficients[536] = -t25;
    coefficients[537] = 0;
    coefficients[538] = 0;
    coefficients[539] = t23*t55 + t25*t56;
    coefficients[540] = -t11;
    coefficients[541] = -p2;
    coefficients[542] = 0;
    coefficients[543] = 0;
    coefficients[544] = t11*t55 + t57;
    coefficients[545] = -p3;
    coefficients[546] = p1;
    coefficients[547] = 0;
    coefficients[548] = 0;
    coefficients[549] = -p1*t56 + t58;
    coefficients[550] = 0;
    coefficients[551] = 0;
    coefficients[552] = -t11;
    coefficients[553] = -p2;
    coefficients[554] = 0;
    coefficients[555] = 0;
    coefficients[556] = 0;
    coefficients[557] = -p3;
    coefficients[558] = p1;
    coefficients[559] = 0;
    coefficients[560] = 0;
    coefficients[561] = 0;
    coefficients[562] = t30;
    coefficients[563] = t31;
    coefficients[564] = 0;
    coefficients[565] = 0;
    coefficients[566] = 0;
    coefficients[567] = t32;
    coefficients[568] = t33;
    coefficients[569] = 0;
    coefficients[570] = t34;
    coefficients[571] = t35;
    coefficients[572] = 0;
    coefficients[573] = 0;
    coefficients[574] = -omega2*t0*t11*t41 - t35*t56;
    coefficients[575] = t36;
    coefficients[576] = -t37;
    coefficients[577] = 0;
    coefficients[578] = 0;
    coefficients[579] = -t36*t55 + t37*t56;
    coefficients[580] = 0;
    coefficients[581] = chi;
    coefficients[582] = 0;
    coefficients[583] = 0;
    coefficients[584] = -us1;
    coefficients[585] = 0;
    coefficients[586] = 1;
    coefficients[587] = 0;
    coefficients[588] = 0;
    coefficients[589] = 0;
    coefficients[590] = 0;
    coefficients[591] = 0;
    coefficients[592] = 0;
    coefficients[593] = chi;
    coefficients[594] = 0;
    coefficients[595] = 0;
    coefficients[596] = 0;
    coefficients[597] = 0;
    coefficients[598] = 1;
    coefficients[599] = 0;
    coefficients[600] = 0;
    coefficients[601] = 0;
    coefficients[602] = 0;
    coefficients[603] = chi;
    coefficients[604] = 0;
    coefficients[605] = 0;
    coefficients[606] = 0;
    coefficients[607] = 0;
    coefficients[608] = 1;
    coefficients[609] = 0;
    coefficients[610] = 0;
    coefficients[611] = 0;
    coefficients[612] = 0;
    coefficients[613] = 0;
    coefficients[614] = 0;
    coefficients[615] = 0;
    coefficients[616] = 0;
    coefficients[617] = 0;
    coefficients[618] = 0;
    coefficients[619] = 0;
    coefficients[620] = 1;
    coefficients[621] = -chi;
    coefficients[622] = 0;
    coefficients[623] = 0;
    coefficients[624] = us1;
    coefficients[625] = 0;
    coefficients[626] = 0;
    coefficients[627] = 0;
    coefficients[628] = 0;
    coefficients[629] = 0;
    coefficients[630] = 0;
    coefficients[631] = 0;
    coefficients[632] = 1;
    coefficients[633] = -chi;
    coefficients[634] = 0;
    coefficients[635] = 0;
    coefficients[636] = 0;
    coefficients[637] = 0;
    coefficients[638] = 0;
    coefficients[639] = 0;
    coefficients[640] = 0;
    coefficients[641] = 0;
    coefficients[642] = 1;
    coefficients[643] = -chi;
    coefficients[644] = 0;
    coefficients[645] = 0;
    coefficients[646] = 0;
    coefficients[647] = 0;
    coefficients[648] = 0;
    coefficients[649] = 0;
    coefficients[650] = -1;
    coefficients[651] = chi;
    coefficients[652] = 0;
    coefficients[653] = 0;
    coefficients[654] = -us1;
    coefficients[655] = 0;
    coefficients[656] = 0;
    coefficients[657] = 0;
    coefficients[658] = 0;
    coefficients[659] = 0;
    coefficients[660] = 0;
    coefficients[661] = 0;
    coefficients[662] = 0;
    coefficients[663] = 0;
    coefficients[664] = t59;
    coefficients[665] = 0;
    coefficients[666] = 0;
    coefficients[667] = 0;
    coefficients[668] = 0;
    coefficients[669] = t60;
    coefficients[670] = 0;
    coefficients[671] = 0;
    coefficients[672] = 0;
    coefficients[673] = 0;
    coefficients[674] = 0;
    coefficients[675] = 0;
    coefficients[676] = 0;
    coefficients[677] = 0;
    coefficients[678] = 0;
    coefficients[679] = 0;
    coefficients[680] = p1;
    coefficients[681] = p2;
    coefficients[682] = 0;
    coefficients[683] = 0;
    coefficients[684] = -p1*t59 - t61;
    coefficients[685] = p3;
    coefficients[686] = -t11;
    coefficients[687] = 0;
    coefficients[688] = 0;
    coefficients[689] = t11*t5*t7 - t62;
    coefficients[690] = 0;
    coefficients[691] = 0;
    coefficients[692] = p1;
    coefficients[693] = p2;
    coefficients[694] = 0;
    coefficients[695] = 0;
    coefficients[696] = 0;
    coefficients[697] = p3;
    coefficients[698] = -t11;
    coefficients[699] = 0;
    coefficients[700] = 0;
    coefficients[701] = 0;
    coefficients[702] = t15;
    coefficients[703] = t16;
    coefficients[704] = 0;
    coefficients[705] = 0;
    coefficients[706] = 0;
    coefficients[707] = t17;
    coefficients[708] = t18;
    coefficients[709] = 0;
    coefficients[710] = -t19;
    coefficients[711] = -t21;
    coefficients[712] = 0;
    coefficients[713] = 0;
    coefficients[714] = t19*t59 + t21*t60;
    coefficients[715] = -t23;
    coefficients[716] = -t25;
    coefficients[717] = 0;
    coefficients[718] = 0;
    coefficients[719] = t23*t59 + t25*t60;
    coefficients[720] = -t11;
    coefficients[721] = -p2;
    coefficients[722] = 0;
    coefficients[723] = 0;
    coefficients[724] = t11*t59 + t61;
    coefficients[725] = -p3;
    coefficients[726] = p1;
    coefficients[727] = 0;
    coefficients[728] = 0;
    coefficients[729] = -p1*t60 + t62;
    coefficients[730] = 0;
    coefficients[731] = 0;
    coefficients[732] = -t11;
    coefficients[733] = -p2;
    coefficients[734] = 0;
    coefficients[735] = 0;
    coefficients[736] = 0;
    coefficients[737] = -p3;
    coefficients[738] = p1;
    coefficients[739] = 0;
    coefficients[740] = 0;
    coefficients[741] = 0;
    coefficients[742] = t30;
    coefficients[743] = t31;
    coefficients[744] = 0;
    coefficients[745] = 0;
    coefficients[746] = 0;
    coefficients[747] = t32;
    coefficients[748] = t33;
    coefficients[749] = 0;
    coefficients[750] = t34;
    coefficients[751] = t35;
    coefficients[752] = 0;
    coefficients[753] = 0;
    coefficients[754] = -omega2*t0*t1*t11 - t35*t60;
    coefficients[755] = t36;
    coefficients[756] = -t37;
    coefficients[757] = 0;
    coefficients[758] = 0;
    coefficients[759] = -t36*t59 + t37*t60;
}

/* Switching and periodicity equations.
 * Takes parameters (4), spectrum (7), unknowns (5); gives residual (5), row by row.
 * Operations: 60. Intermediate terms: 19. */
void dry_friction_symmetric_residual(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double residual[5])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t1 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t1);
    const double sin_omega2_half_tau = sin(t1);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const double cos_half_tau1 = cos(half_tau1);
    const double sin_half_tau1 = sin(half_tau1);
    /* outputs */
    const double t2 = p1*z10 + p2*z20;
    const double t4 = V*p2 + p1*v10;
    const double t5 = sin_omega1_half_tau/omega1;
    const double t7 = sin_omega2_half_tau/omega2;
    const double t8 = p3*z10;
    const double t9 = p1*z20;
    const double t10 = p3*v10;
    const double t11 = chi*z20;
    const double t12 = V*chi;
    residual[0] = cos_omega1_half_tau*t2 + cos_omega2_half_tau*(-t2 + z10) + t4*t5 - t7*(t4 - v10);
    residual[1] = cos_omega1_half_tau*(t8 - t9 + z20) + cos_omega2_half_tau*(-t8 + t9) - t5*(V*p1 - V - t10) + t7*(V*p1 - t10);
    residual[2] = cos_half_tau1*(t11 - z10) + half_tau1*t12 + sin_half_tau1*(-t12 + v10) - t11;
    residual[3] = V*half_tau1 - z20;
    residual[4] = -chi*z10 - e2 + t11;
}

/* Derivatives of the equations by the unknowns.
 * Takes parameters (4), spectrum (7), unknowns (5); gives jacobian (5, 5), row by row.
 * Operations: 95. Intermediate terms: 30. */
void dry_friction_symmetric_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double jacobian[25])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const double cos_half_tau1 = cos(half_tau1);
    const double sin_half_tau1 = sin(half_tau1);
    /* d/dtau of: functions of half_tau in slip-slip */
    const double t8 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t8;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t8;
    const double t9 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t9;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t9;
    /* d/dtau1 of: functions of half_tau1 in slip-stick */
    const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
    const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
    /* outputs */
    const double t10 = p1 - 1;
    const double t12 = (1.0/(omega2));
    const double t13 = sin_omega2_half_tau*t12;
    const double t14 = (1.0/(omega1));
    const double t15 = p1*z10 + p2*z20;
    const double t17 = V*p2 + p1*v10;
    const double t18 = sin_omega1_half_tau_by_tau*t14;
    const double t20 = sin_omega2_half_tau_by_tau*t12;
    const double t21 = p3*z10;
    const double t22 = p1*z20;
    const double t23 = p3*v10;
    const double t25 = V*chi;
    jacobian[0] = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t10;
    jacobian[1] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    jacobian[2] = p1*sin_omega1_half_tau*t14 - t10*t13;
    jacobian[3] = cos_omega1_half_tau_by_tau*t15 + cos_omega2_half_tau_by_tau*(-t15 + z10) + t17*t18 - t20*(t17 - v10);
    jacobian[4] = 0;
    jacobian[5] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    jacobian[6] = -cos_omega1_half_tau*t10 + cos_omega2_half_tau*p1;
    jacobian[7] = p3*sin_omega1_half_tau*t14 - p3*t13;
    jacobian[8] = cos_omega1_half_tau_by_tau*(t21 - t22 + z20) + cos_omega2_half_tau_by_tau*(-t21 + t22) - t18*(V*p1 - V - t23) + t20*(V*p1 - t23);
    jacobian[9] = 0;
    jacobian[10] = -cos_half_tau1;
    jacobian[11] = chi*cos_half_tau1 - chi;
    jacobian[12] = sin_half_tau1;
    jacobian[13] = 0;
    jacobian[14] = cos_half_tau1_by_tau1*(chi*z20 - z10) + sin_half_tau1_by_tau1*(-t25 + v10) + (1.0/2.0)*t25;
    jacobian[15] = 0;
    jacobian[16] = -1;
    jacobian[17] = 0;
    jacobian[18] = 0;
    jacobian[19] = (1.0/2.0)*V;
    jacobian[20] = -chi;
    jacobian[21] = chi;
    jacobian[22] = 0;
    jacobian[23] = 0;
    jacobian[24] = 0;
}

/* Equations and their derivatives by the unknowns, sharing all intermediate terms.
 * Takes parameters (4), spectrum (7), unknowns (5); gives residual (5), jacobian (5, 5), row by row.
 * Operations: 121. Intermediate terms: 40. */
void dry_friction_symmetric_residual_and_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double residual[5], double jacobian[25])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const double cos_half_tau1 = cos(half_tau1);
    const double sin_half_tau1 = sin(half_tau1);
    /* d/dtau of: functions of half_tau in slip-slip */
    const double t8 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t8;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t8;
    const double t9 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t9;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t9;
    /* d/dtau1 of: functions of half_tau1 in slip-stick */
    const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
    const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
    /* outputs */
    const double t10 = p1*z10 + p2*z20;
    const double t12 = -t10 + z10;
    const double t13 = V*p2 + p1*v10;
    const double t14 = (1.0/(omega1));
    const double t15 = sin_omega1_half_tau*t14;
    const double t17 = t13 - v10;
    const double t18 = (1.0/(omega2));
    const double t19 = sin_omega2_half_tau*t18;
    const double t20 = p3*z10;
    const double t21 = p1*z20;
    const double t22 = t20 - t21 + z20;
    const double t23 = -t20 + t21;
    const double t24 = p3*v10;
    const double t25 = V*p1 - t24;
    const double t26 = V*p1 - V - t24;
    const double t27 = chi*z20;
    const double t28 = t27 - z10;
    const double t29 = V*chi;
    const double t30 = -t29 + v10;
    const double t32 = p1 - 1;
    const double t34 = sin_omega1_half_tau_by_tau*t14;
    const double t35 = sin_omega2_half_tau_by_tau*t18;
    residual[0] = cos_omega1_half_tau*t10 + cos_omega2_half_tau*t12 + t13*t15 - t17*t19;
    residual[1] = cos_omega1_half_tau*t22 + cos_omega2_half_tau*t23 - t15*t26 + t19*t25;
    residual[2] = cos_half_tau1*t28 + half_tau1*t29 + sin_half_tau1*t30 - t27;
    residual[3] = V*half_tau1 - z20;
    residual[4] = -chi*z10 - e2 + t27;
    jacobian[0] = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t32;
    jacobian[1] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    jacobian[2] = p1*sin_omega1_half_tau*t14 - t19*t32;
    jacobian[3] = cos_omega1_half_tau_by_tau*t10 + cos_omega2_half_tau_by_tau*t12 + t13*t34 - t17*t35;
    jacobian[4] = 0;
    jacobian[5] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    jacobian[6] = -cos_omega1_half_tau*t32 + cos_omega2_half_tau*p1;
    jacobian[7] = p3*sin_omega1_half_tau*t14 - p3*t19;
    jacobian[8] = cos_omega1_half_tau_by_tau*t22 + cos_omega2_half_tau_by_tau*t23 + t25*t35 - t26*t34;
    jacobian[9] = 0;
    jacobian[10] = -cos_half_tau1;
    jacobian[11] = chi*cos_half_tau1 - chi;
    jacobian[12] = sin_half_tau1;
    jacobian[13] = 0;
    jacobian[14] = cos_half_tau1_by_tau1*t28 + sin_half_tau1_by_tau1*t30 + (1.0/2.0)*t29;
    jacobian[15] = 0;
    jacobian[16] = -1;
    jacobian[17] = 0;
    jacobian[18] = 0;
    jacobian[19] = (1.0/2.0)*V;
    jacobian[20] = -chi;
    jacobian[21] = chi;
    jacobian[22] = 0;
    jacobian[23] = 0;
    jacobian[24] = 0;
}

/* Total derivatives of the equations by the parameters, through the spectrum too.
 * Takes parameters (4), spectrum (7), spectrum_derivatives (7, 2), unknowns (5); gives parameter_jacobian (5, 4), row by row.
 * Operations: 155. Intermediate terms: 49. */
void dry_friction_symmetric_parameter_jacobian(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[5], double parameter_jacobian[20])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const double cos_half_tau1 = cos(half_tau1);
    const double sin_half_tau1 = sin(half_tau1);
    /* d/dchi of: functions of half_tau in slip-slip */
    const double t6 = half_tau*omega1_by_chi;
    const double cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t6;
    const double sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t6;
    const double t7 = half_tau*omega2_by_chi;
    const double cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t7;
    const double sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t7;
    /* d/deta of: functions of half_tau in slip-slip */
    const double t8 = half_tau*omega1_by_eta;
    const double cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t8;
    const double sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t8;
    const double t9 = half_tau*omega2_by_eta;
    const double cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t9;
    const double sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t9;
    /* outputs */
    const double t10 = p1*z10 + p2*z20;
    const double t11 = -t10 + z10;
    const double t12 = (1.0/(omega1));
    const double t13 = sin_omega1_half_tau*t12;
    const double t14 = (1.0/(omega2));
    const double t15 = sin_omega2_half_tau*t14;
    const double t16 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 + t13*v10 - t15*v10;
    const double t17 = -V*sin_omega1_half_tau*t12 + V*t15 - cos_omega1_half_tau*z20 + cos_omega2_half_tau*z20;
    const double t19 = V*p2 + p1*v10;
    const double t20 = t12*t19;
    const double t21 = t19 - v10;
    const double t22 = t14*t21;
    const double t23 = sin_omega2_half_tau/(omega2*omega2);
    const double t24 = t21*t23;
    const double t25 = sin_omega1_half_tau/(omega1*omega1);
    const double t26 = t19*t25;
    const double t27 = p3*z10;
    const double t28 = p1*z20;
    const double t29 = t27 - t28 + z20;
    const double t30 = -t27 + t28;
    const double t31 = p3*v10;
    const double t32 = V*p1 - t31;
    const double t33 = t14*t32;
    const double t34 = V*p1 - V - t31;
    const double t35 = t12*t34;
    const double t36 = t25*t34;
    const double t37 = t23*t32;
    parameter_jacobian[0] = cos_omega1_half_tau_by_chi*t10 + cos_omega2_half_tau_by_chi*t11 - omega1_by_chi*t26 + omega2_by_chi*t24 + p1_by_chi*t16 - p2_by_chi*t17 + sin_omega1_half_tau_by_chi*t20 - sin_omega2_half_tau_by_chi*t22;
    parameter_jacobian[1] = cos_omega1_half_tau_by_eta*t10 + cos_omega2_half_tau_by_eta*t11 - omega1_by_eta*t26 + omega2_by_eta*t24 + p1_by_eta*t16 - p2_by_eta*t17 + sin_omega1_half_tau_by_eta*t20 - sin_omega2_half_tau_by_eta*t22;
    parameter_jacobian[2] = p2*sin_omega1_half_tau*t12 - p2*t15;
    parameter_jacobian[3] = 0;
    parameter_jacobian[4] = cos_omega1_half_tau_by_chi*t29 + cos_omega2_half_tau_by_chi*t30 + omega1_by_chi*t36 - omega2_by_chi*t37 + p1_by_chi*t17 + p3_by_chi*t16 - sin_omega1_half_tau_by_chi*t35 + sin_omega2_half_tau_by_chi*t33;
    parameter_jacobian[5] = cos_omega1_half_tau_by_eta*t29 + cos_omega2_half_tau_by_eta*t30 + omega1_by_eta*t36 - omega2_by_eta*t37 + p1_by_eta*t17 + p3_by_eta*t16 - sin_omega1_half_tau_by_eta*t35 + sin_omega2_half_tau_by_eta*t33;
    parameter_jacobian[6] = p1*t15 - t13*(p1 - 1);
    parameter_jacobian[7] = 0;
    parameter_jacobian[8] = V*half_tau1 - V*sin_half_tau1 + cos_half_tau1*z20 - z20;
    parameter_jacobian[9] = 0;
    parameter_jacobian[10] = chi*half_tau1 - chi*sin_half_tau1;
    parameter_jacobian[11] = 0;
    parameter_jacobian[12] = 0;
    parameter_jacobian[13] = 0;
    parameter_jacobian[14] = half_tau1;
    parameter_jacobian[15] = 0;
    parameter_jacobian[16] = -z10 + z20;
    parameter_jacobian[17] = 0;
    parameter_jacobian[18] = 0;
    parameter_jacobian[19] = -1;
}

/* Jacobian of the Poincare map in the section's coordinates.
 * Takes parameters (4), spectrum (7), unknowns (5); gives poincare_jacobian (2, 2), row by row.
 * Operations: 174. Intermediate terms: 66. */
void dry_friction_symmetric_poincare_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double poincare_jacobian[4])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t5 = sin_omega2_tau/omega2;
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t6 = p1*t3 + t4*t5;
    const double t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*v10 + t7*z10 + t8*z20;
    const double t9 = p3*sin_omega1_tau*t2 - p3*t5;
    const double t10 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t11 = cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double z2_1 = V*(p1*t5 + t3*t4) + t10*z10 + t11*z20 + t9*v10;
    const double t12 = omega2*sin_omega2_tau;
    const double t13 = omega1*sin_omega1_tau;
    const double t14 = p1*t13 + t12*t4;
    const double t15 = -omega2*p2*sin_omega2_tau + p2*t13;
    const double v1_1 = V*t8 - t14*z10 - t15*z20 + t7*v10;
    const double t16 = -omega2*p3*sin_omega2_tau + p3*t13;
    const double t17 = p1*t12 + t13*t4;
    const double v2_1 = V*t11 + t10*v10 - t16*z10 - t17*z20;
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t18 = -chi*cos_tau1 + chi;
    const double t19 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t19) + cos_tau1*z1_1 + sin_tau1*v1_1 + t18*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t18 + cos_tau1*v1_1 - sin_tau1*z1_1 + t19*z2_1;
    /* Phi along tau */
    const double carried_z1_1_by_z20 = t7 + t8;
    const double carried_z1_1_by_v10 = t6;
    const double carried_z2_1_by_z20 = t10 + t11;
    const double carried_z2_1_by_v10 = t9;
    const double carried_v1_1_by_z20 = -t14 - t15;
    const double carried_v1_1_by_v10 = t7;
    const double carried_v2_1_by_z20 = -t16 - t17;
    const double carried_v2_1_by_v10 = t10;
    /* rate of the exit boundary after tau */
    const double t20 = chi*z2_1;
    const double rate_1 = chi*eta*z1_1 - eta*t20;
    /* derivatives of the time to the boundary after tau */
    const double t21 = (1.0/(rate_1));
    const double delay_tau_by_z20 = -carried_v2_1_by_z20*t21;
    const double delay_tau_by_v10 = -carried_v2_1_by_v10*t21;
    /* perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
    const double t22 = t20 - z1_1;
    const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t22;
    const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t22;
    /* Phi along tau1 */
    const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t18*z2_1_on_boundary_by_z20;
    const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t18*z2_1_on_boundary_by_v10;
    const double carried_v1_2_by_z20 = cos_tau1*v1_1_on_boundary_by_z20 - sin_tau1*z1_1_on_boundary_by_z20 + t19*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t19*z2_1_on_boundary_by_v10;
    /* rate of the exit boundary after tau1 */
    const double rate_2 = V*chi - chi*v1_2;
    /* derivatives of the time to the boundary after tau1 */
    const double t23 = (1.0/(rate_2));
    const double delay_tau1_by_z20 = t23*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    const double delay_tau1_by_v10 = t23*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10);
    /* perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20;
    const double z2_2_on_boundary_by_v10 = V*delay_tau1_by_v10 + z2_1_on_boundary_by_v10;
    const double t24 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau1_by_z20*t24;
    const double v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*t24;
    poincare_jacobian[0] = z2_2_on_boundary_by_z20;
    poincare_jacobian[1] = z2_2_on_boundary_by_v10;
    poincare_jacobian[2] = v1_2_on_boundary_by_z20;
    poincare_jacobian[3] = v1_2_on_boundary_by_v10;
}

/* Saltation matrices of the transitions, one below the other.
 * Takes parameters (4), spectrum (7), unknowns (5); gives saltations (8, 4), row by row.
 * Operations: 130. Intermediate terms: 40. */
void dry_friction_symmetric_saltations(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double saltations[32])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_tau/omega2;
    const double t6 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*z10 + t7*z20 + v10*(p1*t3 + t4*t5);
    const double t8 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t9 = cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double z2_1 = V*(p1*t5 + t3*t4) + t8*z10 + t9*z20 + v10*(p3*sin_omega1_tau*t2 - p3*t5);
    const double t10 = omega2*sin_omega2_tau;
    const double t11 = omega1*sin_omega1_tau;
    const double v1_1 = V*t7 + t6*v10 + z10*(-p1*t11 - t10*t4) + z20*(omega2*p2*sin_omega2_tau - p2*t11);
    const double v2_1 = V*t9 + t8*v10 + z10*(omega2*p3*sin_omega2_tau - p3*t11) + z20*(-p1*t10 - t11*t4);
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t12 = -chi*cos_tau1 + chi;
    const double t13 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t13) + cos_tau1*z1_1 + sin_tau1*v1_1 + t12*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t12 + cos_tau1*v1_1 - sin_tau1*z1_1 + t13*z2_1;
    /* vector fields at transition 1 */
    const double t14 = chi*z2_1;
    const double before_v1_1 = t14 - z1_1;
    const double t16 = chi*eta;
    const double before_v2_1 = -eta*t14 + t16*z1_1;
    const double behind_v1_1 = before_v1_1;
    /* vector fields at transition 2 */
    const double t17 = chi*z2_2;
    const double before_v1_2 = t17 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double behind_v2_2 = -eta*t17 + t16*z1_2;
    /* outputs */
    const double t19 = (1.0/(before_v2_1));
    const double t20 = chi/(V*chi - chi*v1_2);
    const double t21 = t20*(-before_v1_2 + behind_v1_2);
    const double t22 = behind_v2_2*t20;
    saltations[0] = 1;
    saltations[1] = 0;
    saltations[2] = 0;
    saltations[3] = 0;
    saltations[4] = 0;
    saltations[5] = 1;
    saltations[6] = 0;
    saltations[7] = t19*(V - v2_1);
    saltations[8] = 0;
    saltations[9] = 0;
    saltations[10] = 1;
    saltations[11] = t19*(-before_v1_1 + behind_v1_1);
    saltations[12] = 0;
    saltations[13] = 0;
    saltations[14] = 0;
    saltations[15] = 0;
    saltations[16] = 1;
    saltations[17] = 0;
    saltations[18] = 0;
    saltations[19] = 0;
    saltations[20] = 0;
    saltations[21] = 1;
    saltations[22] = 0;
    saltations[23] = 0;
    saltations[24] = -t21;
    saltations[25] = t21;
    saltations[26] = 1;
    saltations[27] = 0;
    saltations[28] = -t22;
    saltations[29] = t22;
    saltations[30] = 0;
    saltations[31] = 1;
}

/* Monodromy matrix: the product of flows and saltation matrices over a period.
 * Takes parameters (4), spectrum (7), unknowns (5); gives monodromy (4, 4), row by row.
 * Operations: 221. Intermediate terms: 91. */
void dry_friction_symmetric_monodromy(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double monodromy[16])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_tau/omega2;
    const double t6 = p1*t3 + t4*t5;
    const double t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t9 = p2*sin_omega1_tau*t2 - p2*t5;
    const double z1_1 = V*t9 + t6*v10 + t7*z10 + t8*z20;
    const double t10 = p3*sin_omega1_tau*t2 - p3*t5;
    const double t11 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t12 = cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double t13 = p1*t5 + t3*t4;
    const double z2_1 = V*t13 + t10*v10 + t11*z10 + t12*z20;
    const double t14 = omega2*sin_omega2_tau;
    const double t15 = omega1*sin_omega1_tau;
    const double t16 = -p1*t15 - t14*t4;
    const double t17 = omega2*p2*sin_omega2_tau - p2*t15;
    const double v1_1 = V*t8 + t16*z10 + t17*z20 + t7*v10;
    const double t18 = omega2*p3*sin_omega2_tau - p3*t15;
    const double t19 = -p1*t14 - t15*t4;
    const double v2_1 = V*t12 + t11*v10 + t18*z10 + t19*z20;
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t20 = -chi*cos_tau1 + chi;
    const double t21 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t21) + cos_tau1*z1_1 + sin_tau1*v1_1 + t20*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t20 + cos_tau1*v1_1 - sin_tau1*z1_1 + t21*z2_1;
    /* vector fields at transition 1 */
    const double t22 = chi*z2_1;
    const double before_v1_1 = t22 - z1_1;
    const double t24 = chi*eta;
    const double before_v2_1 = -eta*t22 + t24*z1_1;
    const double behind_v1_1 = before_v1_1;
    /* vector fields at transition 2 */
    const double t25 = chi*z2_2;
    const double before_v1_2 = t25 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double behind_v2_2 = -eta*t25 + t24*z1_2;
    /* Phi of phase 1 */
    const double phi_1_00 = t7;
    const double phi_1_01 = t8;
    const double phi_1_02 = t6;
    const double phi_1_03 = t9;
    const double phi_1_10 = t11;
    const double phi_1_11 = t12;
    const double phi_1_12 = t10;
    const double phi_1_13 = t13;
    const double phi_1_20 = t16;
    const double phi_1_21 = t17;
    const double phi_1_22 = t7;
    const double phi_1_23 = t8;
    const double phi_1_30 = t18;
    const double phi_1_31 = t19;
    const double phi_1_32 = t11;
    const double phi_1_33 = t12;
    /* saltation of phase 1 */
    const double t27 = (1.0/(before_v2_1));
    const double t28 = t27*(V - v2_1);
    const double saltation_1_10 = phi_1_10 + phi_1_30*t28;
    const double saltation_1_11 = phi_1_11 + phi_1_31*t28;
    const double saltation_1_12 = phi_1_12 + phi_1_32*t28;
    const double saltation_1_13 = phi_1_13 + phi_1_33*t28;
    const double t29 = t27*(-before_v1_1 + behind_v1_1);
    const double saltation_1_20 = phi_1_20 + phi_1_30*t29;
    const double saltation_1_21 = phi_1_21 + phi_1_31*t29;
    const double saltation_1_22 = phi_1_22 + phi_1_32*t29;
    const double saltation_1_23 = phi_1_23 + phi_1_33*t29;
    /* Phi of phase 2 */
    const double phi_2_00 = cos_tau1*phi_1_00 + saltation_1_10*t20 + saltation_1_20*sin_tau1;
    const double phi_2_01 = cos_tau1*phi_1_01 + saltation_1_11*t20 + saltation_1_21*sin_tau1;
    const double phi_2_02 = cos_tau1*phi_1_02 + saltation_1_12*t20 + saltation_1_22*sin_tau1;
    const double phi_2_03 = cos_tau1*phi_1_03 + saltation_1_13*t20 + saltation_1_23*sin_tau1;
    const double phi_2_20 = cos_tau1*saltation_1_20 - phi_1_00*sin_tau1 + saltation_1_10*t21;
    const double phi_2_21 = cos_tau1*saltation_1_21 - phi_1_01*sin_tau1 + saltation_1_11*t21;
    const double phi_2_22 = cos_tau1*saltation_1_22 - phi_1_02*sin_tau1 + saltation_1_12*t21;
    const double phi_2_23 = cos_tau1*saltation_1_23 - phi_1_03*sin_tau1 + saltation_1_13*t21;
    /* saltation of phase 2 */
    const double t30 = (1.0/((V*chi - chi*v1_2)));
    const double t31 = chi*t30;
    const double t32 = t31*(-before_v1_2 + behind_v1_2);
    const double saltation_2_20 = -phi_2_00*t32 + phi_2_20 + saltation_1_10*t32;
    const double saltation_2_21 = -phi_2_01*t32 + phi_2_21 + saltation_1_11*t32;
    const double saltation_2_22 = -phi_2_02*t32 + phi_2_22 + saltation_1_12*t32;
    const double saltation_2_23 = -phi_2_03*t32 + phi_2_23 + saltation_1_13*t32;
    const double t33 = behind_v2_2*t31;
    const double saltation_2_30 = behind_v2_2*chi*saltation_1_10*t30 - phi_2_00*t33;
    const double saltation_2_31 = behind_v2_2*chi*saltation_1_11*t30 - phi_2_01*t33;
    const double saltation_2_32 = behind_v2_2*chi*saltation_1_12*t30 - phi_2_02*t33;
    const double saltation_2_33 = behind_v2_2*chi*saltation_1_13*t30 - phi_2_03*t33;
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

/* Trace of the Poincare map's Jacobian.
 * Takes parameters (4), spectrum (7), unknowns (5); gives trace, row by row.
 * Operations: 166. Intermediate terms: 62. */
void dry_friction_symmetric_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double *trace)
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t5 = sin_omega2_tau/omega2;
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t6 = p1*t3 + t4*t5;
    const double t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*v10 + t7*z10 + t8*z20;
    const double t9 = p3*sin_omega1_tau*t2 - p3*t5;
    const double t10 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t11 = cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double z2_1 = V*(p1*t5 + t3*t4) + t10*z10 + t11*z20 + t9*v10;
    const double t12 = omega2*sin_omega2_tau;
    const double t13 = omega1*sin_omega1_tau;
    const double t14 = p1*t13 + t12*t4;
    const double t15 = -omega2*p2*sin_omega2_tau + p2*t13;
    const double v1_1 = V*t8 - t14*z10 - t15*z20 + t7*v10;
    const double t16 = -omega2*p3*sin_omega2_tau + p3*t13;
    const double t17 = p1*t12 + t13*t4;
    const double v2_1 = V*t11 + t10*v10 - t16*z10 - t17*z20;
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t18 = -chi*cos_tau1 + chi;
    const double t19 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t19) + cos_tau1*z1_1 + sin_tau1*v1_1 + t18*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t18 + cos_tau1*v1_1 - sin_tau1*z1_1 + t19*z2_1;
    /* Phi along tau */
    const double carried_z1_1_by_z20 = t7 + t8;
    const double carried_z1_1_by_v10 = t6;
    const double carried_z2_1_by_z20 = t10 + t11;
    const double carried_z2_1_by_v10 = t9;
    const double carried_v1_1_by_z20 = -t14 - t15;
    const double carried_v1_1_by_v10 = t7;
    const double carried_v2_1_by_z20 = -t16 - t17;
    const double carried_v2_1_by_v10 = t10;
    /* rate of the exit boundary after tau */
    const double t20 = chi*z2_1;
    const double rate_1 = chi*eta*z1_1 - eta*t20;
    /* derivatives of the time to the boundary after tau */
    const double t21 = (1.0/(rate_1));
    const double delay_tau_by_z20 = -carried_v2_1_by_z20*t21;
    const double delay_tau_by_v10 = -carried_v2_1_by_v10*t21;
    /* perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
    const double t22 = t20 - z1_1;
    const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t22;
    const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t22;
    /* Phi along tau1 */
    const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t18*z2_1_on_boundary_by_z20;
    const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t18*z2_1_on_boundary_by_v10;
    const double carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t19*z2_1_on_boundary_by_v10;
    /* rate of the exit boundary after tau1 */
    const double rate_2 = V*chi - chi*v1_2;
    /* derivatives of the time to the boundary after tau1 */
    const double t23 = (1.0/(rate_2));
    const double delay_tau1_by_z20 = t23*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    const double delay_tau1_by_v10 = t23*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10);
    /* perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20;
    const double v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*(chi*z2_2 - z1_2);
    *trace = v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20;
}

/* Derivatives of the trace by the unknowns, then in total by the parameters.
 * Takes parameters (4), spectrum (7), spectrum_derivatives (7, 2), unknowns (5); gives trace_gradient (9), row by row.
 * Operations: 1300. Intermediate terms: 390. */
void dry_friction_symmetric_trace_gradient(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[5], double trace_gradient[9])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t3 = omega2*tau;
    const double cos_omega2_tau = cos(t3);
    const double sin_omega2_tau = sin(t3);
    /* slip-slip for tau, until second-reaches-belt */
    const double t6 = (1.0/(omega1));
    const double t7 = sin_omega1_tau*t6;
    const double t8 = p1 - 1;
    const double t10 = (1.0/(omega2));
    const double t11 = sin_omega2_tau*t10;
    const double t12 = p1*t7 - t11*t8;
    const double t13 = cos_omega1_tau*p1 - cos_omega2_tau*t8;
    const double t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t15 = p2*sin_omega1_tau*t6 - p2*t11;
    const double z1_1 = V*t15 + t12*v10 + t13*z10 + t14*z20;
    const double t16 = p3*sin_omega1_tau*t6 - p3*t11;
    const double t17 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double t18 = -cos_omega1_tau*t8 + cos_omega2_tau*p1;
    const double t19 = p1*t11 - t7*t8;
    const double z2_1 = V*t19 + t16*v10 + t17*z10 + t18*z20;
    const double t20 = omega2*sin_omega2_tau;
    const double t21 = omega1*sin_omega1_tau;
    const double t22 = p1*t21 - t20*t8;
    const double t24 = -omega2*p2*sin_omega2_tau + p2*t21;
    const double v1_1 = V*t14 + t13*v10 - t22*z10 - t24*z20;
    const double t26 = -omega2*p3*sin_omega2_tau + p3*t21;
    const double t28 = p1*t20 - t21*t8;
    const double v2_1 = V*t18 + t17*v10 - t26*z10 - t28*z20;
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t33 = chi*cos_tau1;
    const double t34 = chi - t33;
    const double t35 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t35) + cos_tau1*z1_1 + sin_tau1*v1_1 + t34*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t34 + cos_tau1*v1_1 - sin_tau1*z1_1 + t35*z2_1;
    /* Phi along tau */
    const double carried_z1_1_by_z20 = t13 + t14;
    const double carried_z1_1_by_v10 = t12;
    const double carried_z2_1_by_z20 = t17 + t18;
    const double carried_z2_1_by_v10 = t16;
    const double carried_v1_1_by_z20 = -t22 - t24;
    const double carried_v1_1_by_v10 = t13;
    const double carried_v2_1_by_z20 = -t26 - t28;
    const double carried_v2_1_by_v10 = t17;
    /* rate of the exit boundary after tau */
    const double t36 = eta*z1_1;
    const double t37 = chi*z2_1;
    const double rate_1 = chi*t36 - eta*t37;
    /* derivatives of the time to the boundary after tau */
    const double t38 = (1.0/(rate_1));
    const double delay_tau_by_z20 = -carried_v2_1_by_z20*t38;
    const double delay_tau_by_v10 = -carried_v2_1_by_v10*t38;
    /* perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
    const double t39 = t37 - z1_1;
    const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t39;
    const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t39;
    /* Phi along tau1 */
    const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20;
    const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10;
    /* rate of the exit boundary after tau1 */
    const double t40 = V*chi;
    const double rate_2 = -chi*v1_2 + t40;
    /* derivatives of the time to the boundary after tau1 */
    const double t41 = (1.0/(rate_2));
    const double t42 = chi*z2_1_on_boundary_by_z20;
    const double t43 = carried_z1_2_by_z20*chi - t42;
    const double delay_tau1_by_z20 = t41*t43;
    const double t44 = chi*z2_1_on_boundary_by_v10;
    const double t45 = carried_z1_2_by_v10*chi - t44;
    const double delay_tau1_by_v10 = t41*t45;
    /* d/dtau of: functions of tau in slip-slip */
    const double cos_omega1_tau_by_tau = -omega1*sin_omega1_tau;
    const double sin_omega1_tau_by_tau = cos_omega1_tau*omega1;
    const double cos_omega2_tau_by_tau = -omega2*sin_omega2_tau;
    const double sin_omega2_tau_by_tau = cos_omega2_tau*omega2;
    /* d/dchi of: functions of tau in slip-slip */
    const double t46 = omega1_by_chi*tau;
    const double cos_omega1_tau_by_chi = -sin_omega1_tau*t46;
    const double sin_omega1_tau_by_chi = cos_omega1_tau*t46;
    const double t47 = omega2_by_chi*tau;
    const double cos_omega2_tau_by_chi = -sin_omega2_tau*t47;
    const double sin_omega2_tau_by_chi = cos_omega2_tau*t47;
    /* d/deta of: functions of tau in slip-slip */
    const double t48 = omega1_by_eta*tau;
    const double cos_omega1_tau_by_eta = -sin_omega1_tau*t48;
    const double sin_omega1_tau_by_eta = cos_omega1_tau*t48;
    const double t49 = omega2_by_eta*tau;
    const double cos_omega2_tau_by_eta = -sin_omega2_tau*t49;
    const double sin_omega2_tau_by_eta = cos_omega2_tau*t49;
    /* d/dz10 of: slip-slip for tau, until second-reaches-belt */
    const double z1_1_by_z10 = t13;
    const double z2_1_by_z10 = t17;
    const double v1_1_by_z10 = -t22;
    const double v2_1_by_z10 = -t26;
    /* d/dz20 of: slip-slip for tau, until second-reaches-belt */
    const double z1_1_by_z20 = t14;
    const double z2_1_by_z20 = t18;
    const double v1_1_by_z20 = -t24;
    const double v2_1_by_z20 = -t28;
    /* d/dv10 of: slip-slip for tau, until second-reaches-belt */
    const double z1_1_by_v10 = t12;
    const double z2_1_by_v10 = t16;
    const double v1_1_by_v10 = t13;
    const double v2_1_by_v10 = t17;
    /* d/dtau of: slip-slip for tau, until second-reaches-belt */
    const double t50 = p1*z10;
    const double t51 = p2*z20;
    const double t52 = t50 + t51;
    const double t53 = -t51 - t8*z10;
    const double t54 = p1*v10;
    const double t55 = V*p2;
    const double t56 = t54*t6 + t55*t6;
    const double t57 = -t10*t55 - t10*t8*v10;
    const double z1_1_by_tau = cos_omega1_tau_by_tau*t52 + cos_omega2_tau_by_tau*t53 + sin_omega1_tau_by_tau*t56 + sin_omega2_tau_by_tau*t57;
    const double t58 = p3*z10;
    const double t59 = -t8*z20;
    const double t60 = t58 + t59;
    const double t61 = p1*z20;
    const double t62 = -t58 + t61;
    const double t63 = p3*v10;
    const double t64 = -V*t8;
    const double t65 = t6*t63 + t6*t64;
    const double t66 = V*p1;
    const double t67 = -t10*t63 + t10*t66;
    const double z2_1_by_tau = cos_omega1_tau_by_tau*t60 + cos_omega2_tau_by_tau*t62 + sin_omega1_tau_by_tau*t65 + sin_omega2_tau_by_tau*t67;
    const double t68 = t54 + t55;
    const double t69 = -t55 - t8*v10;
    const double t70 = -omega1*t50 - omega1*t51;
    const double t71 = -t8*z10;
    const double t72 = omega2*t51 - omega2*t71;
    const double v1_1_by_tau = cos_omega1_tau_by_tau*t68 + cos_omega2_tau_by_tau*t69 + sin_omega1_tau_by_tau*t70 + sin_omega2_tau_by_tau*t72;
    const double t73 = t63 + t64;
    const double t74 = -t63 + t66;
    const double t75 = -omega1*t58 - omega1*t59;
    const double t76 = omega2*p3*z10 - omega2*t61;
    const double v2_1_by_tau = cos_omega1_tau_by_tau*t73 + cos_omega2_tau_by_tau*t74 + sin_omega1_tau_by_tau*t75 + sin_omega2_tau_by_tau*t76;
    /* d/dchi of: slip-slip for tau, until second-reaches-belt */
    const double t77 = (1.0/(omega1*omega1));
    const double t78 = sin_omega1_tau*t77;
    const double t79 = -t54*t78 - t55*t78;
    const double t80 = (1.0/(omega2*omega2));
    const double t81 = sin_omega2_tau*t80;
    const double t82 = t55*t81 + t8*t81*v10;
    const double t83 = -sin_omega1_tau*t6 + t11;
    const double t85 = cos_omega1_tau - cos_omega2_tau;
    const double t86 = -t83*v10 + t85*z10;
    const double t87 = -V*t83 + t85*z20;
    const double z1_1_by_chi = cos_omega1_tau_by_chi*t52 + cos_omega2_tau_by_chi*t53 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau_by_chi*t56 + sin_omega2_tau_by_chi*t57;
    const double t88 = -t63*t78 - t64*t78;
    const double t89 = p3*sin_omega2_tau*t80*v10 - t66*t81;
    const double t91 = V*t83 - t85*z20;
    const double z2_1_by_chi = cos_omega1_tau_by_chi*t60 + cos_omega2_tau_by_chi*t62 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau_by_chi*t65 + sin_omega2_tau_by_chi*t67;
    const double t92 = -sin_omega1_tau*t50 - sin_omega1_tau*t51;
    const double t93 = sin_omega2_tau*t51 - sin_omega2_tau*t71;
    const double t94 = -omega2*sin_omega2_tau + t21;
    const double t96 = t85*v10 - t94*z10;
    const double t97 = V*t85 - t94*z20;
    const double v1_1_by_chi = cos_omega1_tau_by_chi*t68 + cos_omega2_tau_by_chi*t69 + omega1_by_chi*t92 + omega2_by_chi*t93 + p1_by_chi*t96 + p2_by_chi*t97 + sin_omega1_tau_by_chi*t70 + sin_omega2_tau_by_chi*t72;
    const double t98 = -sin_omega1_tau*t58 - sin_omega1_tau*t59;
    const double t99 = p3*sin_omega2_tau*z10 - sin_omega2_tau*t61;
    const double t100 = -V*t85 + t94*z20;
    const double v2_1_by_chi = cos_omega1_tau_by_chi*t73 + cos_omega2_tau_by_chi*t74 + omega1_by_chi*t98 + omega2_by_chi*t99 + p1_by_chi*t100 + p3_by_chi*t96 + sin_omega1_tau_by_chi*t75 + sin_omega2_tau_by_chi*t76;
    /* d/deta of: slip-slip for tau, until second-reaches-belt */
    const double z1_1_by_eta = cos_omega1_tau_by_eta*t52 + cos_omega2_tau_by_eta*t53 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau_by_eta*t56 + sin_omega2_tau_by_eta*t57;
    const double z2_1_by_eta = cos_omega1_tau_by_eta*t60 + cos_omega2_tau_by_eta*t62 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau_by_eta*t65 + sin_omega2_tau_by_eta*t67;
    const double v1_1_by_eta = cos_omega1_tau_by_eta*t68 + cos_omega2_tau_by_eta*t69 + omega1_by_eta*t92 + omega2_by_eta*t93 + p1_by_eta*t96 + p2_by_eta*t97 + sin_omega1_tau_by_eta*t70 + sin_omega2_tau_by_eta*t72;
    const double v2_1_by_eta = cos_omega1_tau_by_eta*t73 + cos_omega2_tau_by_eta*t74 + omega1_by_eta*t98 + omega2_by_eta*t99 + p1_by_eta*t100 + p3_by_eta*t96 + sin_omega1_tau_by_eta*t75 + sin_omega2_tau_by_eta*t76;
    /* d/dV of: slip-slip for tau, until second-reaches-belt */
    const double z1_1_by_V = t15;
    const double z2_1_by_V = t19;
    const double v1_1_by_V = t14;
    const double v2_1_by_V = t18;
    /* d/dtau1 of: functions of tau1 in slip-stick */
    const double cos_tau1_by_tau1 = -sin_tau1;
    const double sin_tau1_by_tau1 = cos_tau1;
    /* d/dz10 of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_z10 = cos_tau1*z1_1_by_z10 + sin_tau1*v1_1_by_z10 + t34*z2_1_by_z10;
    const double v1_2_by_z10 = cos_tau1*v1_1_by_z10 - sin_tau1*z1_1_by_z10 + t35*z2_1_by_z10;
    /* d/dz20 of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_z20 = cos_tau1*z1_1_by_z20 + sin_tau1*v1_1_by_z20 + t34*z2_1_by_z20;
    const double v1_2_by_z20 = cos_tau1*v1_1_by_z20 - sin_tau1*z1_1_by_z20 + t35*z2_1_by_z20;
    /* d/dv10 of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_v10 = cos_tau1*z1_1_by_v10 + sin_tau1*v1_1_by_v10 + t34*z2_1_by_v10;
    const double v1_2_by_v10 = cos_tau1*v1_1_by_v10 - sin_tau1*z1_1_by_v10 + t35*z2_1_by_v10;
    /* d/dtau of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_tau = cos_tau1*z1_1_by_tau + sin_tau1*v1_1_by_tau + t34*z2_1_by_tau;
    const double v1_2_by_tau = cos_tau1*v1_1_by_tau - sin_tau1*z1_1_by_tau + t35*z2_1_by_tau;
    /* d/dtau1 of: slip-stick for tau1, until second-breaks-forward */
    const double t101 = -t40 + v1_1;
    const double z1_2_by_tau1 = -cos_tau1_by_tau1*t39 + sin_tau1_by_tau1*t101 + t40;
    const double v1_2_by_tau1 = cos_tau1_by_tau1*t101 + sin_tau1_by_tau1*t39;
    /* d/dchi of: slip-stick for tau1, until second-breaks-forward */
    const double t102 = 1 - cos_tau1;
    const double z1_2_by_chi = V*(-sin_tau1 + tau1) + cos_tau1*z1_1_by_chi + sin_tau1*v1_1_by_chi + t102*z2_1 + t34*z2_1_by_chi;
    const double v1_2_by_chi = V*t102 + cos_tau1*v1_1_by_chi - sin_tau1*z1_1_by_chi + sin_tau1*z2_1 + t35*z2_1_by_chi;
    /* d/deta of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_eta = cos_tau1*z1_1_by_eta + sin_tau1*v1_1_by_eta + t34*z2_1_by_eta;
    const double v1_2_by_eta = cos_tau1*v1_1_by_eta - sin_tau1*z1_1_by_eta + t35*z2_1_by_eta;
    /* d/dV of: slip-stick for tau1, until second-breaks-forward */
    const double z1_2_by_V = chi*tau1 + cos_tau1*z1_1_by_V + sin_tau1*v1_1_by_V + t34*z2_1_by_V - t35;
    const double z2_2_by_V = tau1 + z2_1_by_V;
    const double v1_2_by_V = chi + cos_tau1*v1_1_by_V - sin_tau1*z1_1_by_V - t33 + t35*z2_1_by_V;
    /* d/dtau of: Phi along tau */
    const double t103 = p1 + p2;
    const double t104 = -p2 - t8;
    const double carried_z1_1_by_z20_by_tau = cos_omega1_tau_by_tau*t103 + cos_omega2_tau_by_tau*t104;
    const double t105 = sin_omega2_tau_by_tau*t10;
    const double carried_z1_1_by_v10_by_tau = p1*sin_omega1_tau_by_tau*t6 - t105*t8;
    const double t106 = -p1 + p3 + 1;
    const double t107 = p1 - p3;
    const double carried_z2_1_by_z20_by_tau = cos_omega1_tau_by_tau*t106 + cos_omega2_tau_by_tau*t107;
    const double carried_z2_1_by_v10_by_tau = p3*sin_omega1_tau_by_tau*t6 - p3*t105;
    const double t108 = -omega1*p1 - omega1*p2;
    const double t109 = omega2*p2 + omega2*t8;
    const double carried_v1_1_by_z20_by_tau = sin_omega1_tau_by_tau*t108 + sin_omega2_tau_by_tau*t109;
    const double carried_v1_1_by_v10_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t8;
    const double t110 = -omega1*p3 + omega1*t8;
    const double t111 = -omega2*p1 + omega2*p3;
    const double carried_v2_1_by_z20_by_tau = sin_omega1_tau_by_tau*t110 + sin_omega2_tau_by_tau*t111;
    const double carried_v2_1_by_v10_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3;
    /* d/dchi of: Phi along tau */
    const double t112 = p1_by_chi*t85;
    const double carried_z1_1_by_z20_by_chi = cos_omega1_tau_by_chi*t103 + cos_omega2_tau_by_chi*t104 + p2_by_chi*t85 + t112;
    const double t113 = sin_omega1_tau_by_chi*t6;
    const double t114 = sin_omega2_tau_by_chi*t10;
    const double t115 = p1*sin_omega1_tau;
    const double t116 = omega1_by_chi*t77;
    const double t117 = -sin_omega2_tau*t8;
    const double t118 = omega2_by_chi*t80;
    const double carried_z1_1_by_v10_by_chi = p1*t113 - p1_by_chi*t83 - t114*t8 - t115*t116 - t117*t118;
    const double t119 = p3_by_chi*t85;
    const double carried_z2_1_by_z20_by_chi = cos_omega1_tau_by_chi*t106 + cos_omega2_tau_by_chi*t107 - p1_by_chi*t85 + t119;
    const double t120 = p3*sin_omega2_tau;
    const double t121 = p3*sin_omega1_tau;
    const double carried_z2_1_by_v10_by_chi = p3*t113 - p3*t114 - p3_by_chi*t83 - t116*t121 + t118*t120;
    const double t122 = -p2*sin_omega1_tau - t115;
    const double t123 = p2*sin_omega2_tau - t117;
    const double carried_v1_1_by_z20_by_chi = omega1_by_chi*t122 + omega2_by_chi*t123 - p1_by_chi*t94 - p2_by_chi*t94 + sin_omega1_tau_by_chi*t108 + sin_omega2_tau_by_chi*t109;
    const double carried_v1_1_by_v10_by_chi = cos_omega1_tau_by_chi*p1 - cos_omega2_tau_by_chi*t8 + t112;
    const double t124 = sin_omega1_tau*t8 - t121;
    const double t125 = -p1*sin_omega2_tau + p3*sin_omega2_tau;
    const double carried_v2_1_by_z20_by_chi = omega1_by_chi*t124 + omega2_by_chi*t125 + p1_by_chi*t94 - p3_by_chi*t94 + sin_omega1_tau_by_chi*t110 + sin_omega2_tau_by_chi*t111;
    const double carried_v2_1_by_v10_by_chi = cos_omega1_tau_by_chi*p3 - cos_omega2_tau_by_chi*p3 + t119;
    /* d/deta of: Phi along tau */
    const double t126 = p1_by_eta*t85;
    const double carried_z1_1_by_z20_by_eta = cos_omega1_tau_by_eta*t103 + cos_omega2_tau_by_eta*t104 + p2_by_eta*t85 + t126;
    const double t127 = sin_omega1_tau_by_eta*t6;
    const double t128 = sin_omega2_tau_by_eta*t10;
    const double t129 = omega1_by_eta*t77;
    const double t130 = omega2_by_eta*t80;
    const double carried_z1_1_by_v10_by_eta = p1*t127 - p1_by_eta*t83 - t115*t129 - t117*t130 - t128*t8;
    const double t131 = p3_by_eta*t85;
    const double carried_z2_1_by_z20_by_eta = cos_omega1_tau_by_eta*t106 + cos_omega2_tau_by_eta*t107 - p1_by_eta*t85 + t131;
    const double carried_z2_1_by_v10_by_eta = p3*t127 - p3*t128 - p3_by_eta*t83 + t120*t130 - t121*t129;
    const double carried_v1_1_by_z20_by_eta = omega1_by_eta*t122 + omega2_by_eta*t123 - p1_by_eta*t94 - p2_by_eta*t94 + sin_omega1_tau_by_eta*t108 + sin_omega2_tau_by_eta*t109;
    const double carried_v1_1_by_v10_by_eta = cos_omega1_tau_by_eta*p1 - cos_omega2_tau_by_eta*t8 + t126;
    const double carried_v2_1_by_z20_by_eta = omega1_by_eta*t124 + omega2_by_eta*t125 + p1_by_eta*t94 - p3_by_eta*t94 + sin_omega1_tau_by_eta*t110 + sin_omega2_tau_by_eta*t111;
    const double carried_v2_1_by_v10_by_eta = cos_omega1_tau_by_eta*p3 - cos_omega2_tau_by_eta*p3 + t131;
    /* d/dz10 of: rate of the exit boundary after tau */
    const double t132 = chi*eta;
    const double rate_1_by_z10 = t132*z1_1_by_z10 - t132*z2_1_by_z10;
    /* d/dz20 of: rate of the exit boundary after tau */
    const double rate_1_by_z20 = t132*z1_1_by_z20 - t132*z2_1_by_z20;
    /* d/dv10 of: rate of the exit boundary after tau */
    const double rate_1_by_v10 = t132*z1_1_by_v10 - t132*z2_1_by_v10;
    /* d/dtau of: rate of the exit boundary after tau */
    const double rate_1_by_tau = t132*z1_1_by_tau - t132*z2_1_by_tau;
    /* d/dchi of: rate of the exit boundary after tau */
    const double rate_1_by_chi = -eta*z2_1 + t132*z1_1_by_chi - t132*z2_1_by_chi + t36;
    /* d/deta of: rate of the exit boundary after tau */
    const double rate_1_by_eta = chi*z1_1 + t132*z1_1_by_eta - t132*z2_1_by_eta - t37;
    /* d/dV of: rate of the exit boundary after tau */
    const double rate_1_by_V = t132*z1_1_by_V - t132*z2_1_by_V;
    /* d/dz10 of: derivatives of the time to the boundary after tau */
    const double t133 = (1.0/(rate_1*rate_1));
    const double t134 = rate_1_by_z10*t133;
    const double delay_tau_by_z20_by_z10 = carried_v2_1_by_z20*t134;
    const double delay_tau_by_v10_by_z10 = carried_v2_1_by_v10*t134;
    /* d/dz20 of: derivatives of the time to the boundary after tau */
    const double t135 = rate_1_by_z20*t133;
    const double delay_tau_by_z20_by_z20 = carried_v2_1_by_z20*t135;
    const double delay_tau_by_v10_by_z20 = carried_v2_1_by_v10*t135;
    /* d/dv10 of: derivatives of the time to the boundary after tau */
    const double t136 = rate_1_by_v10*t133;
    const double delay_tau_by_z20_by_v10 = carried_v2_1_by_z20*t136;
    const double delay_tau_by_v10_by_v10 = carried_v2_1_by_v10*t136;
    /* d/dtau of: derivatives of the time to the boundary after tau */
    const double t137 = rate_1_by_tau*t133;
    const double delay_tau_by_z20_by_tau = carried_v2_1_by_z20*t137 - carried_v2_1_by_z20_by_tau*t38;
    const double delay_tau_by_v10_by_tau = carried_v2_1_by_v10*t137 - carried_v2_1_by_v10_by_tau*t38;
    /* d/dchi of: derivatives of the time to the boundary after tau */
    const double t138 = rate_1_by_chi*t133;
    const double delay_tau_by_z20_by_chi = carried_v2_1_by_z20*t138 - carried_v2_1_by_z20_by_chi*t38;
    const double delay_tau_by_v10_by_chi = carried_v2_1_by_v10*t138 - carried_v2_1_by_v10_by_chi*t38;
    /* d/deta of: derivatives of the time to the boundary after tau */
    const double t139 = rate_1_by_eta*t133;
    const double delay_tau_by_z20_by_eta = carried_v2_1_by_z20*t139 - carried_v2_1_by_z20_by_eta*t38;
    const double delay_tau_by_v10_by_eta = carried_v2_1_by_v10*t139 - carried_v2_1_by_v10_by_eta*t38;
    /* d/dV of: derivatives of the time to the boundary after tau */
    const double t140 = rate_1_by_V*t133;
    const double delay_tau_by_z20_by_V = carried_v2_1_by_z20*t140;
    const double delay_tau_by_v10_by_V = carried_v2_1_by_v10*t140;
    /* d/dz10 of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v1_1_by_z10 + delay_tau_by_z20_by_z10*v1_1;
    const double z1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v1_1_by_z10 + delay_tau_by_v10_by_z10*v1_1;
    const double z2_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v2_1_by_z10 + delay_tau_by_z20_by_z10*v2_1;
    const double z2_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v2_1_by_z10 + delay_tau_by_v10_by_z10*v2_1;
    const double t141 = chi*z2_1_by_z10;
    const double v1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*t141 - delay_tau_by_z20*z1_1_by_z10 + delay_tau_by_z20_by_z10*t39;
    const double v1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*t141 - delay_tau_by_v10*z1_1_by_z10 + delay_tau_by_v10_by_z10*t39;
    /* d/dz20 of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v1_1_by_z20 + delay_tau_by_z20_by_z20*v1_1;
    const double z1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v1_1_by_z20 + delay_tau_by_v10_by_z20*v1_1;
    const double z2_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v2_1_by_z20 + delay_tau_by_z20_by_z20*v2_1;
    const double z2_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v2_1_by_z20 + delay_tau_by_v10_by_z20*v2_1;
    const double t142 = chi*z2_1_by_z20;
    const double v1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*t142 - delay_tau_by_z20*z1_1_by_z20 + delay_tau_by_z20_by_z20*t39;
    const double v1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*t142 - delay_tau_by_v10*z1_1_by_z20 + delay_tau_by_v10_by_z20*t39;
    /* d/dv10 of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v1_1_by_v10 + delay_tau_by_z20_by_v10*v1_1;
    const double z1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v1_1_by_v10 + delay_tau_by_v10_by_v10*v1_1;
    const double z2_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v2_1_by_v10 + delay_tau_by_z20_by_v10*v2_1;
    const double z2_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v2_1_by_v10 + delay_tau_by_v10_by_v10*v2_1;
    const double t143 = chi*z2_1_by_v10;
    const double v1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*t143 - delay_tau_by_z20*z1_1_by_v10 + delay_tau_by_z20_by_v10*t39;
    const double v1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*t143 - delay_tau_by_v10*z1_1_by_v10 + delay_tau_by_v10_by_v10*t39;
    /* d/dtau of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_tau = carried_z1_1_by_z20_by_tau + delay_tau_by_z20*v1_1_by_tau + delay_tau_by_z20_by_tau*v1_1;
    const double z1_1_on_boundary_by_v10_by_tau = carried_z1_1_by_v10_by_tau + delay_tau_by_v10*v1_1_by_tau + delay_tau_by_v10_by_tau*v1_1;
    const double z2_1_on_boundary_by_z20_by_tau = carried_z2_1_by_z20_by_tau + delay_tau_by_z20*v2_1_by_tau + delay_tau_by_z20_by_tau*v2_1;
    const double z2_1_on_boundary_by_v10_by_tau = carried_z2_1_by_v10_by_tau + delay_tau_by_v10*v2_1_by_tau + delay_tau_by_v10_by_tau*v2_1;
    const double t144 = chi*z2_1_by_tau;
    const double v1_1_on_boundary_by_z20_by_tau = carried_v1_1_by_z20_by_tau + delay_tau_by_z20*t144 - delay_tau_by_z20*z1_1_by_tau + delay_tau_by_z20_by_tau*t39;
    const double v1_1_on_boundary_by_v10_by_tau = carried_v1_1_by_v10_by_tau + delay_tau_by_v10*t144 - delay_tau_by_v10*z1_1_by_tau + delay_tau_by_v10_by_tau*t39;
    /* d/dchi of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_chi = carried_z1_1_by_z20_by_chi + delay_tau_by_z20*v1_1_by_chi + delay_tau_by_z20_by_chi*v1_1;
    const double z1_1_on_boundary_by_v10_by_chi = carried_z1_1_by_v10_by_chi + delay_tau_by_v10*v1_1_by_chi + delay_tau_by_v10_by_chi*v1_1;
    const double z2_1_on_boundary_by_z20_by_chi = carried_z2_1_by_z20_by_chi + delay_tau_by_z20*v2_1_by_chi + delay_tau_by_z20_by_chi*v2_1;
    const double z2_1_on_boundary_by_v10_by_chi = carried_z2_1_by_v10_by_chi + delay_tau_by_v10*v2_1_by_chi + delay_tau_by_v10_by_chi*v2_1;
    const double t145 = chi*z2_1_by_chi;
    const double v1_1_on_boundary_by_z20_by_chi = carried_v1_1_by_z20_by_chi + delay_tau_by_z20*t145 - delay_tau_by_z20*z1_1_by_chi + delay_tau_by_z20*z2_1 + delay_tau_by_z20_by_chi*t39;
    const double v1_1_on_boundary_by_v10_by_chi = carried_v1_1_by_v10_by_chi + delay_tau_by_v10*t145 - delay_tau_by_v10*z1_1_by_chi + delay_tau_by_v10*z2_1 + delay_tau_by_v10_by_chi*t39;
    /* d/deta of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_eta = carried_z1_1_by_z20_by_eta + delay_tau_by_z20*v1_1_by_eta + delay_tau_by_z20_by_eta*v1_1;
    const double z1_1_on_boundary_by_v10_by_eta = carried_z1_1_by_v10_by_eta + delay_tau_by_v10*v1_1_by_eta + delay_tau_by_v10_by_eta*v1_1;
    const double z2_1_on_boundary_by_z20_by_eta = carried_z2_1_by_z20_by_eta + delay_tau_by_z20*v2_1_by_eta + delay_tau_by_z20_by_eta*v2_1;
    const double z2_1_on_boundary_by_v10_by_eta = carried_z2_1_by_v10_by_eta + delay_tau_by_v10*v2_1_by_eta + delay_tau_by_v10_by_eta*v2_1;
    const double t146 = chi*z2_1_by_eta;
    const double v1_1_on_boundary_by_z20_by_eta = carried_v1_1_by_z20_by_eta + delay_tau_by_z20*t146 - delay_tau_by_z20*z1_1_by_eta + delay_tau_by_z20_by_eta*t39;
    const double v1_1_on_boundary_by_v10_by_eta = carried_v1_1_by_v10_by_eta + delay_tau_by_v10*t146 - delay_tau_by_v10*z1_1_by_eta + delay_tau_by_v10_by_eta*t39;
    /* d/dV of: perturbation on the boundary after tau */
    const double z1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v1_1_by_V + delay_tau_by_z20_by_V*v1_1;
    const double z1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v1_1_by_V + delay_tau_by_v10_by_V*v1_1;
    const double z2_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v2_1_by_V + delay_tau_by_z20_by_V*v2_1;
    const double z2_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v2_1_by_V + delay_tau_by_v10_by_V*v2_1;
    const double t147 = chi*z2_1_by_V;
    const double v1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*t147 - delay_tau_by_z20*z1_1_by_V + delay_tau_by_z20_by_V*t39;
    const double v1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*t147 - delay_tau_by_v10*z1_1_by_V + delay_tau_by_v10_by_V*t39;
    /* d/dz10 of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_z10 = cos_tau1*z1_1_on_boundary_by_z20_by_z10 + sin_tau1*v1_1_on_boundary_by_z20_by_z10 + t34*z2_1_on_boundary_by_z20_by_z10;
    const double carried_z1_2_by_v10_by_z10 = cos_tau1*z1_1_on_boundary_by_v10_by_z10 + sin_tau1*v1_1_on_boundary_by_v10_by_z10 + t34*z2_1_on_boundary_by_v10_by_z10;
    const double carried_v1_2_by_v10_by_z10 = cos_tau1*v1_1_on_boundary_by_v10_by_z10 - sin_tau1*z1_1_on_boundary_by_v10_by_z10 + t35*z2_1_on_boundary_by_v10_by_z10;
    /* d/dz20 of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_z20 = cos_tau1*z1_1_on_boundary_by_z20_by_z20 + sin_tau1*v1_1_on_boundary_by_z20_by_z20 + t34*z2_1_on_boundary_by_z20_by_z20;
    const double carried_z1_2_by_v10_by_z20 = cos_tau1*z1_1_on_boundary_by_v10_by_z20 + sin_tau1*v1_1_on_boundary_by_v10_by_z20 + t34*z2_1_on_boundary_by_v10_by_z20;
    const double carried_v1_2_by_v10_by_z20 = cos_tau1*v1_1_on_boundary_by_v10_by_z20 - sin_tau1*z1_1_on_boundary_by_v10_by_z20 + t35*z2_1_on_boundary_by_v10_by_z20;
    /* d/dv10 of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_v10 = cos_tau1*z1_1_on_boundary_by_z20_by_v10 + sin_tau1*v1_1_on_boundary_by_z20_by_v10 + t34*z2_1_on_boundary_by_z20_by_v10;
    const double carried_z1_2_by_v10_by_v10 = cos_tau1*z1_1_on_boundary_by_v10_by_v10 + sin_tau1*v1_1_on_boundary_by_v10_by_v10 + t34*z2_1_on_boundary_by_v10_by_v10;
    const double carried_v1_2_by_v10_by_v10 = cos_tau1*v1_1_on_boundary_by_v10_by_v10 - sin_tau1*z1_1_on_boundary_by_v10_by_v10 + t35*z2_1_on_boundary_by_v10_by_v10;
    /* d/dtau of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_tau = cos_tau1*z1_1_on_boundary_by_z20_by_tau + sin_tau1*v1_1_on_boundary_by_z20_by_tau + t34*z2_1_on_boundary_by_z20_by_tau;
    const double carried_z1_2_by_v10_by_tau = cos_tau1*z1_1_on_boundary_by_v10_by_tau + sin_tau1*v1_1_on_boundary_by_v10_by_tau + t34*z2_1_on_boundary_by_v10_by_tau;
    const double carried_v1_2_by_v10_by_tau = cos_tau1*v1_1_on_boundary_by_v10_by_tau - sin_tau1*z1_1_on_boundary_by_v10_by_tau + t35*z2_1_on_boundary_by_v10_by_tau;
    /* d/dtau1 of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_tau1 = cos_tau1_by_tau1*(-t42 + z1_1_on_boundary_by_z20) + sin_tau1_by_tau1*v1_1_on_boundary_by_z20;
    const double t148 = t44 - z1_1_on_boundary_by_v10;
    const double carried_z1_2_by_v10_by_tau1 = -cos_tau1_by_tau1*t148 + sin_tau1_by_tau1*v1_1_on_boundary_by_v10;
    const double carried_v1_2_by_v10_by_tau1 = cos_tau1_by_tau1*v1_1_on_boundary_by_v10 + sin_tau1_by_tau1*t148;
    /* d/dchi of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_chi = cos_tau1*z1_1_on_boundary_by_z20_by_chi + sin_tau1*v1_1_on_boundary_by_z20_by_chi + t102*z2_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20_by_chi;
    const double carried_z1_2_by_v10_by_chi = cos_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*v1_1_on_boundary_by_v10_by_chi + t102*z2_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10_by_chi;
    const double carried_v1_2_by_v10_by_chi = cos_tau1*v1_1_on_boundary_by_v10_by_chi - sin_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*z2_1_on_boundary_by_v10 + t35*z2_1_on_boundary_by_v10_by_chi;
    /* d/deta of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_eta = cos_tau1*z1_1_on_boundary_by_z20_by_eta + sin_tau1*v1_1_on_boundary_by_z20_by_eta + t34*z2_1_on_boundary_by_z20_by_eta;
    const double carried_z1_2_by_v10_by_eta = cos_tau1*z1_1_on_boundary_by_v10_by_eta + sin_tau1*v1_1_on_boundary_by_v10_by_eta + t34*z2_1_on_boundary_by_v10_by_eta;
    const double carried_v1_2_by_v10_by_eta = cos_tau1*v1_1_on_boundary_by_v10_by_eta - sin_tau1*z1_1_on_boundary_by_v10_by_eta + t35*z2_1_on_boundary_by_v10_by_eta;
    /* d/dV of: Phi along tau1 */
    const double carried_z1_2_by_z20_by_V = cos_tau1*z1_1_on_boundary_by_z20_by_V + sin_tau1*v1_1_on_boundary_by_z20_by_V + t34*z2_1_on_boundary_by_z20_by_V;
    const double carried_z1_2_by_v10_by_V = cos_tau1*z1_1_on_boundary_by_v10_by_V + sin_tau1*v1_1_on_boundary_by_v10_by_V + t34*z2_1_on_boundary_by_v10_by_V;
    const double carried_v1_2_by_v10_by_V = cos_tau1*v1_1_on_boundary_by_v10_by_V - sin_tau1*z1_1_on_boundary_by_v10_by_V + t35*z2_1_on_boundary_by_v10_by_V;
    /* d/dz10 of: rate of the exit boundary after tau1 */
    const double rate_2_by_z10 = -chi*v1_2_by_z10;
    /* d/dz20 of: rate of the exit boundary after tau1 */
    const double rate_2_by_z20 = -chi*v1_2_by_z20;
    /* d/dv10 of: rate of the exit boundary after tau1 */
    const double rate_2_by_v10 = -chi*v1_2_by_v10;
    /* d/dtau of: rate of the exit boundary after tau1 */
    const double rate_2_by_tau = -chi*v1_2_by_tau;
    /* d/dtau1 of: rate of the exit boundary after tau1 */
    const double rate_2_by_tau1 = -chi*v1_2_by_tau1;
    /* d/dchi of: rate of the exit boundary after tau1 */
    const double rate_2_by_chi = V - chi*v1_2_by_chi - v1_2;
    /* d/deta of: rate of the exit boundary after tau1 */
    const double rate_2_by_eta = -chi*v1_2_by_eta;
    /* d/dV of: rate of the exit boundary after tau1 */
    const double rate_2_by_V = -chi*v1_2_by_V + chi;
    /* d/dz10 of: derivatives of the time to the boundary after tau1 */
    const double t149 = (1.0/(rate_2*rate_2));
    const double t150 = rate_2_by_z10*t149;
    const double t151 = chi*t41;
    const double delay_tau1_by_z20_by_z10 = carried_z1_2_by_z20_by_z10*chi*t41 - t150*t43 - t151*z2_1_on_boundary_by_z20_by_z10;
    const double delay_tau1_by_v10_by_z10 = carried_z1_2_by_v10_by_z10*chi*t41 - t150*t45 - t151*z2_1_on_boundary_by_v10_by_z10;
    /* d/dz20 of: derivatives of the time to the boundary after tau1 */
    const double t152 = rate_2_by_z20*t149;
    const double delay_tau1_by_z20_by_z20 = carried_z1_2_by_z20_by_z20*chi*t41 - t151*z2_1_on_boundary_by_z20_by_z20 - t152*t43;
    const double delay_tau1_by_v10_by_z20 = carried_z1_2_by_v10_by_z20*chi*t41 - t151*z2_1_on_boundary_by_v10_by_z20 - t152*t45;
    /* d/dv10 of: derivatives of the time to the boundary after tau1 */
    const double t153 = rate_2_by_v10*t149;
    const double delay_tau1_by_z20_by_v10 = carried_z1_2_by_z20_by_v10*chi*t41 - t151*z2_1_on_boundary_by_z20_by_v10 - t153*t43;
    const double delay_tau1_by_v10_by_v10 = carried_z1_2_by_v10_by_v10*chi*t41 - t151*z2_1_on_boundary_by_v10_by_v10 - t153*t45;
    /* d/dtau of: derivatives of the time to the boundary after tau1 */
    const double t154 = rate_2_by_tau*t149;
    const double delay_tau1_by_z20_by_tau = carried_z1_2_by_z20_by_tau*chi*t41 - t151*z2_1_on_boundary_by_z20_by_tau - t154*t43;
    const double delay_tau1_by_v10_by_tau = carried_z1_2_by_v10_by_tau*chi*t41 - t151*z2_1_on_boundary_by_v10_by_tau - t154*t45;
    /* d/dtau1 of: derivatives of the time to the boundary after tau1 */
    const double t155 = rate_2_by_tau1*t149;
    const double delay_tau1_by_z20_by_tau1 = carried_z1_2_by_z20_by_tau1*t151 - t155*t43;
    const double delay_tau1_by_v10_by_tau1 = carried_z1_2_by_v10_by_tau1*t151 - t155*t45;
    /* d/dchi of: derivatives of the time to the boundary after tau1 */
    const double t156 = rate_2_by_chi*t149;
    const double delay_tau1_by_z20_by_chi = carried_z1_2_by_z20_by_chi*t151 - t151*z2_1_on_boundary_by_z20_by_chi - t156*t43 + t41*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20);
    const double delay_tau1_by_v10_by_chi = carried_z1_2_by_v10_by_chi*t151 - t151*z2_1_on_boundary_by_v10_by_chi - t156*t45 + t41*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10);
    /* d/deta of: derivatives of the time to the boundary after tau1 */
    const double t157 = rate_2_by_eta*t149;
    const double delay_tau1_by_z20_by_eta = carried_z1_2_by_z20_by_eta*chi*t41 - t151*z2_1_on_boundary_by_z20_by_eta - t157*t43;
    const double delay_tau1_by_v10_by_eta = carried_z1_2_by_v10_by_eta*chi*t41 - t151*z2_1_on_boundary_by_v10_by_eta - t157*t45;
    /* d/dV of: derivatives of the time to the boundary after tau1 */
    const double t158 = rate_2_by_V*t149;
    const double delay_tau1_by_z20_by_V = carried_z1_2_by_z20_by_V*chi*t41 - t151*z2_1_on_boundary_by_z20_by_V - t158*t43;
    const double delay_tau1_by_v10_by_V = carried_z1_2_by_v10_by_V*chi*t41 - t151*z2_1_on_boundary_by_v10_by_V - t158*t45;
    /* d/dz10 of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_z10 = V*delay_tau1_by_z20_by_z10 + z2_1_on_boundary_by_z20_by_z10;
    const double t159 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_v10_by_z10 = carried_v1_2_by_v10_by_z10 + delay_tau1_by_v10*t141 - delay_tau1_by_v10*z1_2_by_z10 + delay_tau1_by_v10_by_z10*t159;
    /* d/dz20 of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_z20 = V*delay_tau1_by_z20_by_z20 + z2_1_on_boundary_by_z20_by_z20;
    const double v1_2_on_boundary_by_v10_by_z20 = carried_v1_2_by_v10_by_z20 + delay_tau1_by_v10*t142 - delay_tau1_by_v10*z1_2_by_z20 + delay_tau1_by_v10_by_z20*t159;
    /* d/dv10 of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_v10 = V*delay_tau1_by_z20_by_v10 + z2_1_on_boundary_by_z20_by_v10;
    const double v1_2_on_boundary_by_v10_by_v10 = carried_v1_2_by_v10_by_v10 + delay_tau1_by_v10*t143 - delay_tau1_by_v10*z1_2_by_v10 + delay_tau1_by_v10_by_v10*t159;
    /* d/dtau of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_tau = V*delay_tau1_by_z20_by_tau + z2_1_on_boundary_by_z20_by_tau;
    const double v1_2_on_boundary_by_v10_by_tau = carried_v1_2_by_v10_by_tau + delay_tau1_by_v10*t144 - delay_tau1_by_v10*z1_2_by_tau + delay_tau1_by_v10_by_tau*t159;
    /* d/dtau1 of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_tau1 = V*delay_tau1_by_z20_by_tau1;
    const double v1_2_on_boundary_by_v10_by_tau1 = carried_v1_2_by_v10_by_tau1 + delay_tau1_by_v10*t40 - delay_tau1_by_v10*z1_2_by_tau1 + delay_tau1_by_v10_by_tau1*t159;
    /* d/dchi of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_chi = V*delay_tau1_by_z20_by_chi + z2_1_on_boundary_by_z20_by_chi;
    const double v1_2_on_boundary_by_v10_by_chi = carried_v1_2_by_v10_by_chi + delay_tau1_by_v10*t145 - delay_tau1_by_v10*z1_2_by_chi + delay_tau1_by_v10*z2_2 + delay_tau1_by_v10_by_chi*t159;
    /* d/deta of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_eta = V*delay_tau1_by_z20_by_eta + z2_1_on_boundary_by_z20_by_eta;
    const double v1_2_on_boundary_by_v10_by_eta = carried_v1_2_by_v10_by_eta + delay_tau1_by_v10*t146 - delay_tau1_by_v10*z1_2_by_eta + delay_tau1_by_v10_by_eta*t159;
    /* d/dV of: perturbation on the boundary after tau1 */
    const double z2_2_on_boundary_by_z20_by_V = V*delay_tau1_by_z20_by_V + delay_tau1_by_z20 + z2_1_on_boundary_by_z20_by_V;
    const double v1_2_on_boundary_by_v10_by_V = carried_v1_2_by_v10_by_V + chi*delay_tau1_by_v10*z2_2_by_V - delay_tau1_by_v10*z1_2_by_V + delay_tau1_by_v10_by_V*t159;
    trace_gradient[0] = v1_2_on_boundary_by_v10_by_z10 + z2_2_on_boundary_by_z20_by_z10;
    trace_gradient[1] = v1_2_on_boundary_by_v10_by_z20 + z2_2_on_boundary_by_z20_by_z20;
    trace_gradient[2] = v1_2_on_boundary_by_v10_by_v10 + z2_2_on_boundary_by_z20_by_v10;
    trace_gradient[3] = v1_2_on_boundary_by_v10_by_tau + z2_2_on_boundary_by_z20_by_tau;
    trace_gradient[4] = v1_2_on_boundary_by_v10_by_tau1 + z2_2_on_boundary_by_z20_by_tau1;
    trace_gradient[5] = v1_2_on_boundary_by_v10_by_chi + z2_2_on_boundary_by_z20_by_chi;
    trace_gradient[6] = v1_2_on_boundary_by_v10_by_eta + z2_2_on_boundary_by_z20_by_eta;
    trace_gradient[7] = v1_2_on_boundary_by_v10_by_V + z2_2_on_boundary_by_z20_by_V;
    trace_gradient[8] = 0;
}

/* State at the start and behind each transition, row by row.
 * Takes parameters (4), spectrum (7), unknowns (5); gives states (3, 4), row by row.
 * Operations: 90. Intermediate terms: 23. */
void dry_friction_symmetric_states(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double states[12])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_tau/omega2;
    const double t6 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*z10 + t7*z20 + v10*(p1*t3 + t4*t5);
    const double z2_1 = V*(p1*t5 + t3*t4) + v10*(p3*sin_omega1_tau*t2 - p3*t5) + z10*(cos_omega1_tau*p3 - cos_omega2_tau*p3) + z20*(cos_omega1_tau*t4 + cos_omega2_tau*p1);
    const double t8 = omega1*sin_omega1_tau;
    const double v1_1 = V*t7 + t6*v10 + z10*(-omega2*sin_omega2_tau*t4 - p1*t8) + z20*(omega2*p2*sin_omega2_tau - p2*t8);
    /* functions of tau1 in slip-stick */
    const double cos_tau1 = cos(tau1);
    const double sin_tau1 = sin(tau1);
    /* slip-stick for tau1, until second-breaks-forward */
    const double t9 = -chi*cos_tau1 + chi;
    const double t10 = chi*sin_tau1;
    const double z1_2 = V*(chi*tau1 - t10) + cos_tau1*z1_1 + sin_tau1*v1_1 + t9*z2_1;
    const double z2_2 = V*tau1 + z2_1;
    const double v1_2 = V*t9 + cos_tau1*v1_1 - sin_tau1*z1_1 + t10*z2_1;
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

/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.
 * Takes parameters (4), spectrum (7), unknowns (5); gives coefficients (24), frequencies (3), row by row.
 * Operations: 118. Intermediate terms: 29. */
void dry_friction_symmetric_boundary_functions(
    const double parameters[4], const double spectrum[7], const double unknowns[5], double coefficients[24], double frequencies[3])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double v10 = unknowns[2];
    const double tau = unknowns[3];
    /* functions of tau in slip-slip */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* slip-slip for tau, until second-reaches-belt */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_tau/omega2;
    const double t6 = cos_omega1_tau*p1 + cos_omega2_tau*t4;
    const double t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*z10 + t7*z20 + v10*(p1*t3 + t4*t5);
    const double z2_1 = V*(p1*t5 + t3*t4) + v10*(p3*sin_omega1_tau*t2 - p3*t5) + z10*(cos_omega1_tau*p3 - cos_omega2_tau*p3) + z20*(cos_omega1_tau*t4 + cos_omega2_tau*p1);
    const double t8 = omega1*sin_omega1_tau;
    const double v1_1 = V*t7 + t6*v10 + z10*(-omega2*sin_omega2_tau*t4 - p1*t8) + z20*(omega2*p2*sin_omega2_tau - p2*t8);
    /* outputs */
    const double t10 = V*p2;
    const double t11 = omega1*z10;
    const double t12 = p2*z20;
    const double t13 = p3*v10;
    const double t14 = V*chi;
    const double t15 = -t14 + v1_1;
    const double t16 = chi*z2_1;
    const double t17 = t16 - z1_1;
    const double t18 = (chi*chi);
    const double t19 = t18*z2_1;
    const double t20 = V*t18 - t14;
    const double t21 = -chi*t17;
    const double t22 = chi*t15;
    coefficients[0] = -V;
    coefficients[1] = 0;
    coefficients[2] = p1*v10 + t10;
    coefficients[3] = -t10 + t4*v10;
    coefficients[4] = -omega1*t12 - p1*t11;
    coefficients[5] = omega2*t12 - omega2*t4*z10;
    coefficients[6] = -V;
    coefficients[7] = 0;
    coefficients[8] = V*t4 + t13;
    coefficients[9] = V*p1 - t13;
    coefficients[10] = -omega1*t4*z20 - p3*t11;
    coefficients[11] = -omega2*p1*z20 + omega2*p3*z10;
    coefficients[12] = -V + t14;
    coefficients[13] = 0;
    coefficients[14] = t15;
    coefficients[15] = t17;
    coefficients[16] = -e2 + t16 - t19;
    coefficients[17] = -t20;
    coefficients[18] = -t21;
    coefficients[19] = -t22;
    coefficients[20] = -e2 - t16 + t19;
    coefficients[21] = t20;
    coefficients[22] = t21;
    coefficients[23] = t22;
    frequencies[0] = omega1;
    frequencies[1] = omega2;
    frequencies[2] = 1;
}

/* State after a time in slip-slip.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 82. Intermediate terms: 16. */
void dry_friction_symmetric_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/(omega1));
    const double t1 = omega1*t;
    const double t2 = sin(t1);
    const double t3 = t0*t2;
    const double t4 = 1 - p1;
    const double t5 = omega2*t;
    const double t6 = sin(t5);
    const double t7 = t6/omega2;
    const double t8 = cos(t1);
    const double t9 = cos(t5);
    const double t10 = p1*t8 + t4*t9;
    const double t11 = p2*t8 - p2*t9;
    const double t12 = p3*t8 - p3*t9;
    const double t13 = p1*t9 + t4*t8;
    const double t14 = omega2*t6;
    const double t15 = omega1*t2;
    state_after[0] = t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7);
    state_after[1] = t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15);
    state_after[3] = t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4);
}

/* State after a time in slip-stick.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 23. Intermediate terms: 4. */
void dry_friction_symmetric_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = sin(t);
    const double t1 = chi*t0;
    const double t2 = cos(t);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1);
    state_after[1] = t*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* Reduced equations and their derivatives by the reduced unknowns.
 * Takes parameters (4), spectrum (7), reduced (2); gives residual (2), jacobian (2, 2), row by row.
 * Operations: 188. Intermediate terms: 58. */
void dry_friction_symmetric_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[2], double residual[2], double jacobian[4])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in slip-stick */
    const double cos_half_tau1 = cos(half_tau1);
    const double sin_half_tau1 = sin(half_tau1);
    /* coefficients of the linear equations */
    const double t8 = (1.0/(omega2));
    const double t9 = sin_omega2_half_tau*t8;
    const double t10 = (1.0/(omega1));
    const double t11 = p1*t10;
    const double t12 = p1*t9;
    const double coefficient11 = sin_omega1_half_tau*t11 - t12 + t9;
    /* right-hand sides of the linear equations */
    const double t13 = V*half_tau1;
    const double t14 = cos_omega2_half_tau*t13;
    const double t15 = (1.0/(chi));
    const double t16 = p1*t13;
    const double t17 = cos_omega1_half_tau*t16;
    const double t18 = p2*t13;
    const double t19 = e2*t15;
    const double t20 = cos_omega2_half_tau*t19;
    const double t21 = V*t10;
    const double t22 = sin_omega1_half_tau*t21;
    const double right1 = V*cos_omega2_half_tau*half_tau1*p1 + V*cos_omega2_half_tau*half_tau1*p2 + V*p2*sin_omega2_half_tau*t8 + cos_omega1_half_tau*e2*p1*t15 - cos_omega1_half_tau*t18 + cos_omega2_half_tau*e2*t15 - p1*t20 - p2*t22 - t14 - t17;
    /* determinant of the linear equations */
    const double determinant = coefficient11;
    /* v10 by Cramer's rule */
    const double t23 = (1.0/(determinant));
    const double v10 = right1*t23;
    /* d/dtau of: functions of half_tau in slip-slip */
    const double t24 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t24;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t24;
    const double t25 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t25;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t25;
    /* d/dtau1 of: functions of half_tau1 in slip-stick */
    const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
    const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
    /* d/dtau of: coefficients of the linear equations */
    const double t26 = p1*t8;
    const double coefficient11_by_tau = sin_omega1_half_tau_by_tau*t11 + sin_omega2_half_tau_by_tau*(-t26 + t8);
    /* d/dtau of: right-hand sides of the linear equations */
    const double t27 = -p1*t19 + t16 + t18;
    const double t29 = -t13 + t19;
    const double right1_by_tau = V*p2*sin_omega2_half_tau_by_tau*t8 - cos_omega1_half_tau_by_tau*t27 + cos_omega2_half_tau_by_tau*(t27 + t29) - p2*sin_omega1_half_tau_by_tau*t21;
    /* d/dtau1 of: right-hand sides of the linear equations */
    const double t30 = (1.0/2.0)*V;
    const double t31 = cos_omega2_half_tau*t30;
    const double t32 = cos_omega1_half_tau*t30;
    const double t33 = p1*t32;
    const double right1_by_tau1 = (1.0/2.0)*V*cos_omega2_half_tau*p1 + (1.0/2.0)*V*cos_omega2_half_tau*p2 - p2*t32 - t31 - t33;
    /* d/dtau of: v10 by Cramer's rule */
    const double v10_by_tau = -coefficient11_by_tau*right1/(determinant*determinant) + right1_by_tau*t23;
    /* d/dtau1 of: v10 by Cramer's rule */
    const double v10_by_tau1 = right1_by_tau1*t23;
    /* outputs */
    const double t34 = cos_omega1_half_tau*t13;
    const double t35 = p3*v10;
    const double t36 = t10*t35;
    const double t37 = p3*t19;
    const double t38 = cos_half_tau1*t13;
    const double t39 = V*chi;
    const double t40 = -p3*t13 + t16 + t37;
    const double t41 = p3*sin_omega1_half_tau*t10 - p3*t9;
    residual[0] = V*t12 - cos_omega1_half_tau*t37 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t34 + sin_omega1_half_tau*t36 - t17 + t22 + t34 - t35*t9;
    residual[1] = chi*t38 + cos_half_tau1*t19 - sin_half_tau1*t39 + sin_half_tau1*v10 - t38;
    jacobian[0] = cos_omega1_half_tau_by_tau*(t13 - t40) + cos_omega2_half_tau_by_tau*t40 + sin_omega1_half_tau_by_tau*(-p1*t21 + t21 + t36) + sin_omega2_half_tau_by_tau*(V*t26 - t35*t8) + t41*v10_by_tau;
    jacobian[1] = p1*t31 - p3*t31 + p3*t32 + t32 - t33 + t41*v10_by_tau1;
    jacobian[2] = sin_half_tau1*v10_by_tau;
    jacobian[3] = -cos_half_tau1*t30 + (1.0/2.0)*cos_half_tau1*t39 + cos_half_tau1_by_tau1*(chi*t13 + t29) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t39 + v10);
}

/* All unknowns from the reduced ones, and how singular the linear equations for them are: 0 if they are.
 * Takes parameters (4), spectrum (7), reduced (2); gives unknowns (5), determinants (1), row by row.
 * Operations: 71. Intermediate terms: 22. */
void dry_friction_symmetric_expand(
    const double parameters[4], const double spectrum[7], const double reduced[2], double unknowns[5], double determinants[1])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in slip-slip */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t1 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t1);
    const double sin_omega2_half_tau = sin(t1);
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* coefficients of the linear equations */
    const double t2 = (1.0/(omega2));
    const double t3 = sin_omega2_half_tau*t2;
    const double t4 = sin_omega1_half_tau/omega1;
    const double coefficient11 = -p1*t3 + p1*t4 + t3;
    /* right-hand sides of the linear equations */
    const double t5 = V*half_tau1;
    const double t6 = (1.0/(chi));
    const double t7 = e2*t6;
    const double right1 = V*cos_omega2_half_tau*half_tau1*p1 + V*cos_omega2_half_tau*half_tau1*p2 + V*p2*sin_omega2_half_tau*t2 - V*p2*t4 + cos_omega1_half_tau*e2*p1*t6 - cos_omega1_half_tau*p1*t5 - cos_omega1_half_tau*p2*t5 + cos_omega2_half_tau*e2*t6 - cos_omega2_half_tau*p1*t7 - cos_omega2_half_tau*t5;
    /* determinant of the linear equations */
    const double determinant = coefficient11;
    /* v10 by Cramer's rule */
    const double v10 = right1/determinant;
    /* z10: linear in: second-breaks-forward ends slip-stick */
    const double z10 = t5 - t7;
    /* z20: linear in: z2 vanishes halfway through slip-stick */
    const double z20 = t5;
    /* outputs */
    const double t8 = (half_tau*half_tau);
    const double t9 = 2*t8;
    unknowns[0] = z10;
    unknowns[1] = z20;
    unknowns[2] = v10;
    unknowns[3] = tau;
    unknowns[4] = tau1;
    determinants[0] = determinant/sqrt((p1*p1)*t9/((omega1*omega1)*t8 + 1) + t9*((p1 - 1)*(p1 - 1))/((omega2*omega2)*t8 + 1));
}

/* Switching and periodicity equations.
 * Takes parameters (5), spectrum (7), unknowns (6); gives residual (6), row by row.
 * Operations: 142. Intermediate terms: 39. */
void dry_friction_global_stick_residual(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[6])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double t5 = (1.0/(omega1));
    const double t6 = sin_omega1_tau1*t5;
    const double t7 = 1 - p1;
    const double t8 = sin_omega2_tau1/omega2;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + t10*z2_2 + t9*z1_2 + v1_2*(p1*t6 + t7*t8);
    const double t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t12 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t8 + t6*t7) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8);
    const double t13 = omega2*sin_omega2_tau1;
    const double t14 = omega1*sin_omega1_tau1;
    const double v1_3 = V*t10 + t9*v1_2 + z1_2*(-p1*t14 - t13*t7) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t14);
    const double v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t14) + z2_2*(-p1*t13 - t14*t7);
    /* functions of tau2 in stick-slip */
    const double t15 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t15);
    const double sin_omega3_tau2 = sin(t15);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t16 = 1 - cos_omega3_tau2;
    const double t17 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t17 + tau2) + cos_omega3_tau2*z2_3 + t16*z1_3 + t17*v2_3;
    const double t18 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t16 + cos_omega3_tau2*v2_3 + t18*z1_3 - t18*z2_3;
    residual[0] = -chi*z2_1 - e1 + z1_1;
    residual[1] = -chi*z1_2 + chi*z2_2 - e2;
    residual[2] = -V + v1_3;
    residual[3] = -V + v2_4;
    residual[4] = -z10 + z1_4;
    residual[5] = -z20 + z2_4;
}

/* Derivatives of the equations by the unknowns.
 * Takes parameters (5), spectrum (7), unknowns (6); gives jacobian (6, 6), row by row.
 * Operations: 266. Intermediate terms: 94. */
void dry_friction_global_stick_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double jacobian[36])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
    /* stick-stick for ta, until first-breaks-forward */
    const double t0 = V*ta;
    const double z1_1 = t0 + z10;
    const double z2_1 = t0 + z20;
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t1 = V*sin_tau;
    const double t3 = chi*cos_tau;
    const double t4 = chi - t3;
    const double t5 = chi*sin_tau;
    const double z1_2 = V*(chi*tau - t5) + cos_tau*z1_1 + t1 + t4*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double t6 = V*cos_tau + V*t4;
    const double v1_2 = -sin_tau*z1_1 + t5*z2_1 + t6;
    /* functions of tau1 in slip-slip */
    const double t7 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t7);
    const double sin_omega1_tau1 = sin(t7);
    const double t8 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t8);
    const double sin_omega2_tau1 = sin(t8);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t9 = (1.0/(omega1));
    const double t12 = sin_omega2_tau1/omega2;
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = 1 - p1;
    const double t13 = p1*t10 + t11*t12;
    const double t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11;
    const double t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2;
    const double t16 = p3*sin_omega1_tau1*t9 - p3*t12;
    const double t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2;
    const double t19 = omega2*sin_omega2_tau1;
    const double t20 = omega1*sin_omega1_tau1;
    const double t21 = -p1*t20 - t11*t19;
    const double t22 = p2*t20;
    const double t23 = omega2*p2*sin_omega2_tau1 - t22;
    const double t24 = V*t15;
    const double t25 = t14*v1_2 + t24;
    const double v1_3 = t21*z1_2 + t23*z2_2 + t25;
    const double t26 = omega2*p3*sin_omega2_tau1 - p3*t20;
    const double t27 = p1*t19 + t11*t20;
    const double t29 = V*t18;
    const double t30 = t17*v1_2 + t29;
    const double v2_3 = t26*z1_2 - t27*z2_2 + t30;
    /* functions of tau2 in stick-slip */
    const double t31 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t31);
    const double sin_omega3_tau2 = sin(t31);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t32 = 1 - cos_omega3_tau2;
    const double t33 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t33 + tau2) + cos_omega3_tau2*z2_3 + t32*z1_3 + t33*v2_3;
    const double t34 = cos_omega3_tau2*v2_3;
    const double t35 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t32 + t34 + t35*z1_3 - t35*z2_3;
    /* derivatives of the state after tau */
    const double z1_2_by_z20 = t4;
    const double z1_2_by_ta = t6;
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_z20 = t5;
    const double v1_2_by_ta = chi*t1 - t1;
    const double v1_2_by_tau = chi*z2_2 - z1_2;
    /* derivatives of the state after tau1 */
    const double z1_3_by_z10 = cos_tau*t14 + t13*v1_2_by_z10;
    const double z1_3_by_z20 = t13*v1_2_by_z20 + t14*z1_2_by_z20 + t15;
    const double z1_3_by_ta = t13*v1_2_by_ta + t14*z1_2_by_ta + t24;
    const double z1_3_by_tau = t13*v1_2_by_tau + t25;
    const double z2_3_by_z10 = cos_tau*t17 + t16*v1_2_by_z10;
    const double z2_3_by_z20 = t16*v1_2_by_z20 + t17*z1_2_by_z20 + t18;
    const double z2_3_by_ta = t16*v1_2_by_ta + t17*z1_2_by_ta + t29;
    const double z2_3_by_tau = t16*v1_2_by_tau + t30;
    const double v1_3_by_z10 = cos_tau*t21 + t14*v1_2_by_z10;
    const double v1_3_by_z20 = p2*t19 + t14*v1_2_by_z20 + t21*z1_2_by_z20 - t22;
    const double t36 = V*t23;
    const double v1_3_by_ta = t14*v1_2_by_ta + t21*z1_2_by_ta + t36;
    const double v1_3_by_tau = t14*v1_2_by_tau + t21*v1_2 + t36;
    const double t37 = chi*z2_3;
    const double v1_3_by_tau1 = t37 - z1_3;
    const double v2_3_by_z10 = cos_tau*t26 + t17*v1_2_by_z10;
    const double v2_3_by_z20 = t17*v1_2_by_z20 + t26*z1_2_by_z20 - t27;
    const double t38 = -V*t27;
    const double v2_3_by_ta = t17*v1_2_by_ta + t26*z1_2_by_ta + t38;
    const double v2_3_by_tau = t17*v1_2_by_tau + t26*v1_2 + t38;
    const double t39 = chi*eta;
    const double v2_3_by_tau1 = -eta*t37 + t39*z1_3;
    /* derivatives of the state after tau2 */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t32*z1_3_by_z10 + t33*v2_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t32*z1_3_by_z20 + t33*v2_3_by_z20;
    const double z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t32*z1_3_by_ta + t33*v2_3_by_ta;
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t32*z1_3_by_tau + t33*v2_3_by_tau;
    const double z2_4_by_tau1 = t32*v1_3 + t33*v2_3_by_tau1 + t34;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t35*z1_3_by_z10 - t35*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t35*z1_3_by_z20 - t35*z2_3_by_z20;
    const double v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t35*z1_3_by_ta - t35*z2_3_by_ta;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t35*z1_3_by_tau - t35*z2_3_by_tau;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t35*v1_3 - t35*v2_3;
    const double v2_4_by_tau2 = t39*z1_4 - t39*z2_4;
    /* outputs */
    const double t40 = V*chi;
    jacobian[0] = 1;
    jacobian[1] = -chi;
    jacobian[2] = V - t40;
    jacobian[3] = 0;
    jacobian[4] = 0;
    jacobian[5] = 0;
    jacobian[6] = -t3;
    jacobian[7] = -chi*z1_2_by_z20 + chi;
    jacobian[8] = -chi*z1_2_by_ta + t40;
    jacobian[9] = -chi*v1_2 + t40;
    jacobian[10] = 0;
    jacobian[11] = 0;
    jacobian[12] = v1_3_by_z10;
    jacobian[13] = v1_3_by_z20;
    jacobian[14] = v1_3_by_ta;
    jacobian[15] = v1_3_by_tau;
    jacobian[16] = v1_3_by_tau1;
    jacobian[17] = 0;
    jacobian[18] = v2_4_by_z10;
    jacobian[19] = v2_4_by_z20;
    jacobian[20] = v2_4_by_ta;
    jacobian[21] = v2_4_by_tau;
    jacobian[22] = v2_4_by_tau1;
    jacobian[23] = v2_4_by_tau2;
    jacobian[24] = z1_3_by_z10 - 1;
    jacobian[25] = z1_3_by_z20;
    jacobian[26] = z1_3_by_ta;
    jacobian[27] = z1_3_by_tau;
    jacobian[28] = v1_3;
    jacobian[29] = V;
    jacobian[30] = z2_4_by_z10;
    jacobian[31] = z2_4_by_z20 - 1;
    jacobian[32] = z2_4_by_ta;
    jacobian[33] = z2_4_by_tau;
    jacobian[34] = z2_4_by_tau1;
    jacobian[35] = v2_4;
}

/* Equations and their derivatives by the unknowns, sharing all intermediate terms.
 * Takes parameters (5), spectrum (7), unknowns (6); gives residual (6), jacobian (6, 6), row by row.
 * Operations: 277. Intermediate terms: 94. */
void dry_friction_global_stick_residual_and_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[6], double jacobian[36])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
    /* stick-stick for ta, until first-breaks-forward */
    const double t0 = V*ta;
    const double z1_1 = t0 + z10;
    const double z2_1 = t0 + z20;
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t1 = V*sin_tau;
    const double t3 = chi*cos_tau;
    const double t4 = chi - t3;
    const double t5 = chi*sin_tau;
    const double z1_2 = V*(chi*tau - t5) + cos_tau*z1_1 + t1 + t4*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double t6 = V*cos_tau + V*t4;
    const double v1_2 = -sin_tau*z1_1 + t5*z2_1 + t6;
    /* functions of tau1 in slip-slip */
    const double t7 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t7);
    const double sin_omega1_tau1 = sin(t7);
    const double t8 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t8);
    const double sin_omega2_tau1 = sin(t8);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t9 = (1.0/(omega1));
    const double t12 = sin_omega2_tau1/omega2;
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = 1 - p1;
    const double t13 = p1*t10 + t11*t12;
    const double t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11;
    const double t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2;
    const double t16 = p3*sin_omega1_tau1*t9 - p3*t12;
    const double t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2;
    const double t19 = omega2*sin_omega2_tau1;
    const double t20 = omega1*sin_omega1_tau1;
    const double t21 = -p1*t20 - t11*t19;
    const double t22 = p2*t20;
    const double t23 = omega2*p2*sin_omega2_tau1 - t22;
    const double t24 = V*t15;
    const double t25 = t14*v1_2 + t24;
    const double v1_3 = t21*z1_2 + t23*z2_2 + t25;
    const double t26 = omega2*p3*sin_omega2_tau1 - p3*t20;
    const double t27 = p1*t19 + t11*t20;
    const double t29 = V*t18;
    const double t30 = t17*v1_2 + t29;
    const double v2_3 = t26*z1_2 - t27*z2_2 + t30;
    /* functions of tau2 in stick-slip */
    const double t31 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t31);
    const double sin_omega3_tau2 = sin(t31);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t32 = 1 - cos_omega3_tau2;
    const double t33 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t33 + tau2) + cos_omega3_tau2*z2_3 + t32*z1_3 + t33*v2_3;
    const double t34 = cos_omega3_tau2*v2_3;
    const double t35 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t32 + t34 + t35*z1_3 - t35*z2_3;
    /* derivatives of the state after tau */
    const double z1_2_by_z20 = t4;
    const double z1_2_by_ta = t6;
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_z20 = t5;
    const double v1_2_by_ta = chi*t1 - t1;
    const double v1_2_by_tau = chi*z2_2 - z1_2;
    /* derivatives of the state after tau1 */
    const double z1_3_by_z10 = cos_tau*t14 + t13*v1_2_by_z10;
    const double z1_3_by_z20 = t13*v1_2_by_z20 + t14*z1_2_by_z20 + t15;
    const double z1_3_by_ta = t13*v1_2_by_ta + t14*z1_2_by_ta + t24;
    const double z1_3_by_tau = t13*v1_2_by_tau + t25;
    const double z2_3_by_z10 = cos_tau*t17 + t16*v1_2_by_z10;
    const double z2_3_by_z20 = t16*v1_2_by_z20 + t17*z1_2_by_z20 + t18;
    const double z2_3_by_ta = t16*v1_2_by_ta + t17*z1_2_by_ta + t29;
    const double z2_3_by_tau = t16*v1_2_by_tau + t30;
    const double v1_3_by_z10 = cos_tau*t21 + t14*v1_2_by_z10;
    const double v1_3_by_z20 = p2*t19 + t14*v1_2_by_z20 + t21*z1_2_by_z20 - t22;
    const double t36 = V*t23;
    const double v1_3_by_ta = t14*v1_2_by_ta + t21*z1_2_by_ta + t36;
    const double v1_3_by_tau = t14*v1_2_by_tau + t21*v1_2 + t36;
    const double t37 = chi*z2_3;
    const double v1_3_by_tau1 = t37 - z1_3;
    const double v2_3_by_z10 = cos_tau*t26 + t17*v1_2_by_z10;
    const double v2_3_by_z20 = t17*v1_2_by_z20 + t26*z1_2_by_z20 - t27;
    const double t38 = -V*t27;
    const double v2_3_by_ta = t17*v1_2_by_ta + t26*z1_2_by_ta + t38;
    const double v2_3_by_tau = t17*v1_2_by_tau + t26*v1_2 + t38;
    const double t39 = chi*eta;
    const double v2_3_by_tau1 = -eta*t37 + t39*z1_3;
    /* derivatives of the state after tau2 */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t32*z1_3_by_z10 + t33*v2_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t32*z1_3_by_z20 + t33*v2_3_by_z20;
    const double z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t32*z1_3_by_ta + t33*v2_3_by_ta;
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t32*z1_3_by_tau + t33*v2_3_by_tau;
    const double z2_4_by_tau1 = t32*v1_3 + t33*v2_3_by_tau1 + t34;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t35*z1_3_by_z10 - t35*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t35*z1_3_by_z20 - t35*z2_3_by_z20;
    const double v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t35*z1_3_by_ta - t35*z2_3_by_ta;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t35*z1_3_by_tau - t35*z2_3_by_tau;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t35*v1_3 - t35*v2_3;
    const double v2_4_by_tau2 = t39*z1_4 - t39*z2_4;
    /* outputs */
    const double t40 = V*chi;
    residual[0] = -chi*z2_1 - e1 + z1_1;
    residual[1] = -chi*z1_2 + chi*z2_2 - e2;
    residual[2] = -V + v1_3;
    residual[3] = -V + v2_4;
    residual[4] = -z10 + z1_4;
    residual[5] = -z20 + z2_4;
    jacobian[0] = 1;
    jacobian[1] = -chi;
    jacobian[2] = V - t40;
    jacobian[3] = 0;
    jacobian[4] = 0;
    jacobian[5] = 0;
    jacobian[6] = -t3;
    jacobian[7] = -chi*z1_2_by_z20 + chi;
    jacobian[8] = -chi*z1_2_by_ta + t40;
    jacobian[9] = -chi*v1_2 + t40;
    jacobian[10] = 0;
    jacobian[11] = 0;
    jacobian[12] = v1_3_by_z10;
    jacobian[13] = v1_3_by_z20;
    jacobian[14] = v1_3_by_ta;
    jacobian[15] = v1_3_by_tau;
    jacobian[16] = v1_3_by_tau1;
    jacobian[17] = 0;
    jacobian[18] = v2_4_by_z10;
    jacobian[19] = v2_4_by_z20;
    jacobian[20] = v2_4_by_ta;
    jacobian[21] = v2_4_by_tau;
    jacobian[22] = v2_4_by_tau1;
    jacobian[23] = v2_4_by_tau2;
    jacobian[24] = z1_3_by_z10 - 1;
    jacobian[25] = z1_3_by_z20;
    jacobian[26] = z1_3_by_ta;
    jacobian[27] = z1_3_by_tau;
    jacobian[28] = v1_3;
    jacobian[29] = V;
    jacobian[30] = z2_4_by_z10;
    jacobian[31] = z2_4_by_z20 - 1;
    jacobian[32] = z2_4_by_ta;
    jacobian[33] = z2_4_by_tau;
    jacobian[34] = z2_4_by_tau1;
    jacobian[35] = v2_4;
}

/* Total derivatives of the equations by the parameters, through the spectrum too.
 * Takes parameters (5), spectrum (7), spectrum_derivatives (7, 2), unknowns (6); gives parameter_jacobian (6, 5), row by row.
 * Operations: 514. Intermediate terms: 142. */
void dry_friction_global_stick_parameter_jacobian(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double parameter_jacobian[30])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double omega3_by_chi = spectrum_derivatives[12];
    const double omega3_by_eta = spectrum_derivatives[13];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double z1_2 = V*sin_tau + V*(chi*tau - t3) + cos_tau*z1_1 + t2*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double v1_2 = V*cos_tau + V*t2 - sin_tau*z1_1 + t3*z2_1;
    /* functions of tau1 in slip-slip */
    const double t4 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t4);
    const double sin_omega1_tau1 = sin(t4);
    const double t7 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t7);
    const double sin_omega2_tau1 = sin(t7);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau1*t10;
    const double t12 = 1 - p1;
    const double t13 = (1.0/(omega2));
    const double t14 = sin_omega2_tau1*t13;
    const double t15 = p1*t11 + t12*t14;
    const double t16 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12;
    const double t17 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t18 = p2*t14;
    const double z1_3 = V*(p2*sin_omega1_tau1*t10 - t18) + t15*v1_2 + t16*z1_2 + t17*z2_2;
    const double t19 = p3*sin_omega1_tau1*t10 - p3*t14;
    const double t20 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t21 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1;
    const double t22 = p1*t14 + t11*t12;
    const double z2_3 = V*t22 + t19*v1_2 + t20*z1_2 + t21*z2_2;
    const double t23 = omega1*sin_omega1_tau1;
    const double t24 = omega2*p3*sin_omega2_tau1 - p3*t23;
    const double t25 = omega2*sin_omega2_tau1;
    const double t26 = -p1*t25 - t12*t23;
    const double v2_3 = V*t21 + t20*v1_2 + t24*z1_2 + t26*z2_2;
    /* functions of tau2 in stick-slip */
    const double t27 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t27);
    const double sin_omega3_tau2 = sin(t27);
    /* d/dchi of: slip-stick for tau, until second-breaks-forward */
    const double t30 = 1 - cos_tau;
    const double z1_2_by_chi = V*(-sin_tau + tau) + t30*z2_1;
    const double v1_2_by_chi = V*t30 + sin_tau*z2_1;
    /* d/dV of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_V = chi*tau + cos_tau*ta + sin_tau + t2*ta - t3;
    const double z2_2_by_V = ta + tau;
    const double v1_2_by_V = chi + cos_tau - sin_tau*ta - t1 + t3*ta;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t31 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t31;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t31;
    const double t32 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t32;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t32;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t33 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t33;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t33;
    const double t34 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t34;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t34;
    /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
    const double t35 = p1*z1_2;
    const double t36 = p2*z2_2;
    const double t37 = t35 + t36;
    const double t38 = t12*z1_2 - t36;
    const double t39 = p1*v1_2;
    const double t40 = sin_omega1_tau1/(omega1*omega1);
    const double t41 = V*p2;
    const double t42 = -t39*t40 - t40*t41;
    const double t43 = (1.0/(omega2*omega2));
    const double t44 = sin_omega2_tau1*t43;
    const double t45 = -t12*t44*v1_2 + t41*t44;
    const double t46 = -sin_omega1_tau1*t10 + t14;
    const double t48 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t49 = -t46*v1_2 + t48*z1_2;
    const double t50 = -V*t46 + t48*z2_2;
    const double t51 = t10*t39 + t10*t41;
    const double t52 = t12*t13*v1_2 - t13*t41;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t37 + cos_omega2_tau1_by_chi*t38 + omega1_by_chi*t42 + omega2_by_chi*t45 + p1_by_chi*t49 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t51 + sin_omega2_tau1_by_chi*t52 + t15*v1_2_by_chi + t16*z1_2_by_chi;
    const double t53 = p3*z1_2;
    const double t54 = t12*z2_2;
    const double t55 = t53 + t54;
    const double t56 = p1*z2_2;
    const double t57 = -t53 + t56;
    const double t58 = p3*v1_2;
    const double t59 = V*t12;
    const double t60 = -t40*t58 - t40*t59;
    const double t61 = V*p1;
    const double t62 = p3*sin_omega2_tau1*t43*v1_2 - t44*t61;
    const double t64 = V*t46 - t48*z2_2;
    const double t65 = t10*t58 + t10*t59;
    const double t66 = -t13*t58 + t13*t61;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t55 + cos_omega2_tau1_by_chi*t57 + omega1_by_chi*t60 + omega2_by_chi*t62 + p1_by_chi*t64 + p3_by_chi*t49 + sin_omega1_tau1_by_chi*t65 + sin_omega2_tau1_by_chi*t66 + t19*v1_2_by_chi + t20*z1_2_by_chi;
    const double t67 = t39 + t41;
    const double t68 = t12*v1_2 - t41;
    const double t69 = -sin_omega1_tau1*t35 - sin_omega1_tau1*t36;
    const double t70 = t12*z1_2;
    const double t71 = sin_omega2_tau1*t36 - sin_omega2_tau1*t70;
    const double t72 = -omega2*sin_omega2_tau1 + t23;
    const double t74 = t48*v1_2 - t72*z1_2;
    const double t75 = V*t48 - t72*z2_2;
    const double t76 = -omega1*t35 - omega1*t36;
    const double t77 = omega2*t36 - omega2*t70;
    const double t78 = -p1*t23 - t12*t25;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t67 + cos_omega2_tau1_by_chi*t68 + omega1_by_chi*t69 + omega2_by_chi*t71 + p1_by_chi*t74 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t76 + sin_omega2_tau1_by_chi*t77 + t16*v1_2_by_chi + t78*z1_2_by_chi;
    const double t79 = t58 + t59;
    const double t80 = -t58 + t61;
    const double t81 = -sin_omega1_tau1*t53 - sin_omega1_tau1*t54;
    const double t82 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t56;
    const double t83 = -V*t48 + t72*z2_2;
    const double t84 = -omega1*t53 - omega1*t54;
    const double t85 = omega2*p3*z1_2 - omega2*t56;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t80 + omega1_by_chi*t81 + omega2_by_chi*t82 + p1_by_chi*t83 + p3_by_chi*t74 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t85 + t20*v1_2_by_chi + t24*z1_2_by_chi;
    /* d/deta of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t37 + cos_omega2_tau1_by_eta*t38 + omega1_by_eta*t42 + omega2_by_eta*t45 + p1_by_eta*t49 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t51 + sin_omega2_tau1_by_eta*t52;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t55 + cos_omega2_tau1_by_eta*t57 + omega1_by_eta*t60 + omega2_by_eta*t62 + p1_by_eta*t64 + p3_by_eta*t49 + sin_omega1_tau1_by_eta*t65 + sin_omega2_tau1_by_eta*t66;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t67 + cos_omega2_tau1_by_eta*t68 + omega1_by_eta*t69 + omega2_by_eta*t71 + p1_by_eta*t74 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t76 + sin_omega2_tau1_by_eta*t77;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t80 + omega1_by_eta*t81 + omega2_by_eta*t82 + p1_by_eta*t83 + p3_by_eta*t74 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t85;
    /* d/dV of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_V = p2*t11 + t15*v1_2_by_V + t16*z1_2_by_V + t17*z2_2_by_V - t18;
    const double z2_3_by_V = t19*v1_2_by_V + t20*z1_2_by_V + t21*z2_2_by_V + t22;
    const double v1_3_by_V = t16*v1_2_by_V + t17 + t78*z1_2_by_V + z2_2_by_V*(omega2*p2*sin_omega2_tau1 - p2*t23);
    const double v2_3_by_V = t20*v1_2_by_V + t21 + t24*z1_2_by_V + t26*z2_2_by_V;
    /* d/dchi of: functions of tau2 in stick-slip */
    const double t86 = omega3_by_chi*tau2;
    const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t86;
    const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t86;
    /* d/deta of: functions of tau2 in stick-slip */
    const double t87 = omega3_by_eta*tau2;
    const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t87;
    const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t87;
    /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
    const double t88 = -z1_3 + z2_3;
    const double t89 = sin_omega3_tau2/(omega3*omega3);
    const double t90 = V*t89 - t89*v2_3;
    const double t91 = (1.0/(omega3));
    const double t92 = -V*t91 + t91*v2_3;
    const double t93 = 1 - cos_omega3_tau2;
    const double t94 = sin_omega3_tau2*t91;
    const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t88 + omega3_by_chi*t90 + sin_omega3_tau2_by_chi*t92 + t93*z1_3_by_chi + t94*v2_3_by_chi;
    const double t95 = -V + v2_3;
    const double t96 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3;
    const double t97 = omega3*z1_3 - omega3*z2_3;
    const double t98 = omega3*sin_omega3_tau2;
    const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t95 + omega3_by_chi*t96 + sin_omega3_tau2_by_chi*t97 + t98*z1_3_by_chi - t98*z2_3_by_chi;
    /* d/deta of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t88 + omega3_by_eta*t90 + sin_omega3_tau2_by_eta*t92 + t93*z1_3_by_eta + t94*v2_3_by_eta;
    const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t95 + omega3_by_eta*t96 + sin_omega3_tau2_by_eta*t97 + t98*z1_3_by_eta - t98*z2_3_by_eta;
    /* d/dV of: stick-slip for tau2, until second-reaches-belt */
    const double z1_4_by_V = tau2 + z1_3_by_V;
    const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t93*z1_3_by_V + t94*v2_3_by_V - t94 + tau2;
    const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t98*z1_3_by_V - t98*z2_3_by_V + 1;
    parameter_jacobian[0] = -z2_1;
    parameter_jacobian[1] = 0;
    parameter_jacobian[2] = -chi*ta + ta;
    parameter_jacobian[3] = -1;
    parameter_jacobian[4] = 0;
    parameter_jacobian[5] = -chi*z1_2_by_chi - z1_2 + z2_2;
    parameter_jacobian[6] = 0;
    parameter_jacobian[7] = -chi*z1_2_by_V + chi*z2_2_by_V;
    parameter_jacobian[8] = 0;
    parameter_jacobian[9] = -1;
    parameter_jacobian[10] = v1_3_by_chi;
    parameter_jacobian[11] = v1_3_by_eta;
    parameter_jacobian[12] = v1_3_by_V - 1;
    parameter_jacobian[13] = 0;
    parameter_jacobian[14] = 0;
    parameter_jacobian[15] = v2_4_by_chi;
    parameter_jacobian[16] = v2_4_by_eta;
    parameter_jacobian[17] = v2_4_by_V - 1;
    parameter_jacobian[18] = 0;
    parameter_jacobian[19] = 0;
    parameter_jacobian[20] = z1_3_by_chi;
    parameter_jacobian[21] = z1_3_by_eta;
    parameter_jacobian[22] = z1_4_by_V;
    parameter_jacobian[23] = 0;
    parameter_jacobian[24] = 0;
    parameter_jacobian[25] = z2_4_by_chi;
    parameter_jacobian[26] = z2_4_by_eta;
    parameter_jacobian[27] = z2_4_by_V;
    parameter_jacobian[28] = 0;
    parameter_jacobian[29] = 0;
}

/* Jacobian of the Poincare map in the section's coordinates.
 * Takes parameters (5), spectrum (7), unknowns (6); gives poincare_jacobian (2, 2), row by row.
 * Operations: 276. Intermediate terms: 103. */
void dry_friction_global_stick_poincare_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double poincare_jacobian[4])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double t5 = (1.0/(omega1));
    const double t8 = sin_omega2_tau1/omega2;
    const double t6 = sin_omega1_tau1*t5;
    const double t7 = 1 - p1;
    const double t9 = p1*t6 + t7*t8;
    const double t10 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7;
    const double t11 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + t10*z1_2 + t11*z2_2 + t9*v1_2;
    const double t12 = p3*sin_omega1_tau1*t5 - p3*t8;
    const double t13 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t14 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t8 + t6*t7) + t12*v1_2 + t13*z1_2 + t14*z2_2;
    const double t15 = omega2*sin_omega2_tau1;
    const double t16 = omega1*sin_omega1_tau1;
    const double t17 = -p1*t16 - t15*t7;
    const double t18 = omega2*p2*sin_omega2_tau1 - p2*t16;
    const double v1_3 = V*t11 + t10*v1_2 + t17*z1_2 + t18*z2_2;
    const double t19 = omega2*p3*sin_omega2_tau1 - p3*t16;
    const double t20 = -p1*t15 - t16*t7;
    const double v2_3 = V*t14 + t13*v1_2 + t19*z1_2 + t20*z2_2;
    /* functions of tau2 in stick-slip */
    const double t21 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t21);
    const double sin_omega3_tau2 = sin(t21);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t22 = 1 - cos_omega3_tau2;
    const double t23 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t23 + tau2) + cos_omega3_tau2*z2_3 + t22*z1_3 + t23*v2_3;
    const double t24 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t22 + cos_omega3_tau2*v2_3 + t24*z1_3 - t24*z2_3;
    /* rate of the exit boundary after ta */
    const double t25 = V*chi;
    const double rate_1 = V - t25;
    /* derivatives of the time to the boundary after ta */
    const double t26 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t26;
    const double delay_ta_by_z20 = chi*t26;
    /* perturbation on the boundary after ta */
    const double t27 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = t27 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z10 = t27;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t25;
    /* derivatives of the time to the boundary after tau */
    const double t29 = (1.0/(rate_2));
    const double delay_tau_by_z10 = t29*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20 = t29*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t30 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t30;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t30;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t10*z1_2_on_boundary_by_z10 + t11*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t10*z1_2_on_boundary_by_z20 + t11*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t13*z1_2_on_boundary_by_z10 + t14*z2_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t13*z1_2_on_boundary_by_z20 + t14*z2_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t17*z1_2_on_boundary_by_z10 + t18*z2_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t17*z1_2_on_boundary_by_z20 + t18*z2_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t13*v1_2_on_boundary_by_z10 + t19*z1_2_on_boundary_by_z10 + t20*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t13*v1_2_on_boundary_by_z20 + t19*z1_2_on_boundary_by_z20 + t20*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t31 = chi*z2_3;
    const double rate_3 = t31 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t32 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t32;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t32;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t33 = chi*eta;
    const double t34 = -eta*t31 + t33*z1_3;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t34;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t34;
    /* Phi along tau2 */
    const double carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t22*z1_3_on_boundary_by_z10 + t23*v2_3_on_boundary_by_z10;
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t22*z1_3_on_boundary_by_z20 + t23*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t24*z1_3_on_boundary_by_z10 - t24*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t24*z1_3_on_boundary_by_z20 - t24*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t33*z1_4 - t33*z2_4;
    /* derivatives of the time to the boundary after tau2 */
    const double t35 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t35;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t35;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20;
    const double z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    poincare_jacobian[0] = z1_4_on_boundary_by_z10;
    poincare_jacobian[1] = z1_4_on_boundary_by_z20;
    poincare_jacobian[2] = z2_4_on_boundary_by_z10;
    poincare_jacobian[3] = z2_4_on_boundary_by_z20;
}

/* Saltation matrices of the transitions, one below the other.
 * Takes parameters (5), spectrum (7), unknowns (6); gives saltations (16, 4), row by row.
 * Operations: 167. Intermediate terms: 56. */
void dry_friction_global_stick_saltations(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double saltations[64])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double t5 = (1.0/(omega1));
    const double t6 = sin_omega1_tau1*t5;
    const double t7 = 1 - p1;
    const double t8 = sin_omega2_tau1/omega2;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + t10*z2_2 + t9*z1_2 + v1_2*(p1*t6 + t7*t8);
    const double t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t12 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t8 + t6*t7) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8);
    const double t13 = omega2*sin_omega2_tau1;
    const double t14 = omega1*sin_omega1_tau1;
    const double v1_3 = V*t10 + t9*v1_2 + z1_2*(-p1*t14 - t13*t7) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t14);
    const double v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t14) + z2_2*(-p1*t13 - t14*t7);
    /* functions of tau2 in stick-slip */
    const double t15 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t15);
    const double sin_omega3_tau2 = sin(t15);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t16 = 1 - cos_omega3_tau2;
    const double t17 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t17 + tau2) + cos_omega3_tau2*z2_3 + t16*z1_3 + t17*v2_3;
    const double t18 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t16 + cos_omega3_tau2*v2_3 + t18*z1_3 - t18*z2_3;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z2_1 - z1_1;
    /* vector fields at transition 2 */
    const double t19 = chi*z2_2;
    const double before_v1_2 = t19 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double t21 = chi*eta;
    const double behind_v2_2 = -eta*t19 + t21*z1_2;
    /* vector fields at transition 3 */
    const double t22 = chi*z2_3;
    const double before_v1_3 = t22 - z1_3;
    const double before_v2_3 = -eta*t22 + t21*z1_3;
    const double behind_v2_3 = before_v2_3;
    /* vector fields at transition 4 */
    const double before_v2_4 = t21*z1_4 - t21*z2_4;
    /* outputs */
    const double t24 = V*chi;
    const double t25 = behind_v1_1/(V - t24);
    const double t26 = chi/(-chi*v1_2 + t24);
    const double t27 = t26*(-before_v1_2 + behind_v1_2);
    const double t28 = behind_v2_2*t26;
    const double t29 = (1.0/(before_v1_3));
    saltations[0] = 1;
    saltations[1] = 0;
    saltations[2] = 0;
    saltations[3] = 0;
    saltations[4] = 0;
    saltations[5] = 1;
    saltations[6] = 0;
    saltations[7] = 0;
    saltations[8] = t25;
    saltations[9] = -chi*t25;
    saltations[10] = 1;
    saltations[11] = 0;
    saltations[12] = 0;
    saltations[13] = 0;
    saltations[14] = 0;
    saltations[15] = 1;
    saltations[16] = 1;
    saltations[17] = 0;
    saltations[18] = 0;
    saltations[19] = 0;
    saltations[20] = 0;
    saltations[21] = 1;
    saltations[22] = 0;
    saltations[23] = 0;
    saltations[24] = -t27;
    saltations[25] = t27;
    saltations[26] = 1;
    saltations[27] = 0;
    saltations[28] = -t28;
    saltations[29] = t28;
    saltations[30] = 0;
    saltations[31] = 1;
    saltations[32] = 1;
    saltations[33] = 0;
    saltations[34] = t29*(V - v1_3);
    saltations[35] = 0;
    saltations[36] = 0;
    saltations[37] = 1;
    saltations[38] = 0;
    saltations[39] = 0;
    saltations[40] = 0;
    saltations[41] = 0;
    saltations[42] = 0;
    saltations[43] = 0;
    saltations[44] = 0;
    saltations[45] = 0;
    saltations[46] = t29*(-before_v2_3 + behind_v2_3);
    saltations[47] = 1;
    saltations[48] = 1;
    saltations[49] = 0;
    saltations[50] = 0;
    saltations[51] = 0;
    saltations[52] = 0;
    saltations[53] = 1;
    saltations[54] = 0;
    saltations[55] = (V - v2_4)/before_v2_4;
    saltations[56] = 0;
    saltations[57] = 0;
    saltations[58] = 1;
    saltations[59] = 0;
    saltations[60] = 0;
    saltations[61] = 0;
    saltations[62] = 0;
    saltations[63] = 0;
}

/* Monodromy matrix: the product of flows and saltation matrices over a period.
 * Takes parameters (5), spectrum (7), unknowns (6); gives monodromy (4, 4), row by row.
 * Operations: 378. Intermediate terms: 130. */
void dry_friction_global_stick_monodromy(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double monodromy[16])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double z1_2 = V*sin_tau + V*(chi*tau - t3) + cos_tau*z1_1 + t2*z2_1;
    const double z2_2 = V*tau + z2_1;
    const double v1_2 = V*cos_tau + V*t2 - sin_tau*z1_1 + t3*z2_1;
    /* functions of tau1 in slip-slip */
    const double t4 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t4);
    const double sin_omega1_tau1 = sin(t4);
    const double t5 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t5);
    const double sin_omega2_tau1 = sin(t5);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t6 = (1.0/(omega1));
    const double t7 = sin_omega1_tau1*t6;
    const double t8 = 1 - p1;
    const double t9 = sin_omega2_tau1/omega2;
    const double t10 = p1*t7 + t8*t9;
    const double t11 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8;
    const double t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t13 = p2*sin_omega1_tau1*t6 - p2*t9;
    const double z1_3 = V*t13 + t10*v1_2 + t11*z1_2 + t12*z2_2;
    const double t14 = p3*sin_omega1_tau1*t6 - p3*t9;
    const double t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t16 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1;
    const double t17 = p1*t9 + t7*t8;
    const double z2_3 = V*t17 + t14*v1_2 + t15*z1_2 + t16*z2_2;
    const double t18 = omega2*sin_omega2_tau1;
    const double t19 = omega1*sin_omega1_tau1;
    const double t20 = -p1*t19 - t18*t8;
    const double t21 = p2*t19;
    const double t22 = omega2*p2*sin_omega2_tau1 - t21;
    const double v1_3 = V*t12 + t11*v1_2 + t20*z1_2 + t22*z2_2;
    const double t23 = omega2*p3*sin_omega2_tau1 - p3*t19;
    const double t24 = p1*t18;
    const double t25 = t19*t8;
    const double t26 = -t24 - t25;
    const double v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t26*z2_2;
    /* functions of tau2 in stick-slip */
    const double t27 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t27);
    const double sin_omega3_tau2 = sin(t27);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t28 = 1 - cos_omega3_tau2;
    const double t29 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t29 + tau2) + cos_omega3_tau2*z2_3 + t28*z1_3 + t29*v2_3;
    const double t30 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t28 + cos_omega3_tau2*v2_3 + t30*z1_3 - t30*z2_3;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z2_1 - z1_1;
    /* vector fields at transition 2 */
    const double t31 = chi*z2_2;
    const double before_v1_2 = t31 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double t33 = chi*eta;
    const double behind_v2_2 = -eta*t31 + t33*z1_2;
    /* vector fields at transition 3 */
    const double t34 = chi*z2_3;
    const double before_v1_3 = t34 - z1_3;
    const double before_v2_3 = -eta*t34 + t33*z1_3;
    const double behind_v2_3 = before_v2_3;
    /* vector fields at transition 4 */
    const double before_v2_4 = t33*z1_4 - t33*z2_4;
    /* saltation of phase 1 */
    const double t36 = V*chi;
    const double saltation_1_20 = behind_v1_1/(V - t36);
    const double t38 = chi*saltation_1_20;
    const double saltation_1_21 = -t38;
    const double saltation_1_22 = saltation_1_20*ta + 1;
    const double saltation_1_23 = -t38*ta;
    /* Phi of phase 2 */
    const double phi_2_00 = cos_tau + saltation_1_20*sin_tau;
    const double t39 = chi - t1;
    const double phi_2_01 = saltation_1_21*sin_tau + t39;
    const double phi_2_02 = cos_tau*ta + saltation_1_22*sin_tau;
    const double phi_2_03 = chi*tau + saltation_1_23*sin_tau + t2*ta - t3;
    const double phi_2_13 = ta + tau;
    const double phi_2_20 = cos_tau*saltation_1_20 - sin_tau;
    const double phi_2_21 = cos_tau*saltation_1_21 + t3;
    const double phi_2_22 = cos_tau*saltation_1_22 - sin_tau*ta;
    const double phi_2_23 = cos_tau*saltation_1_23 + t3*ta + t39;
    /* saltation of phase 2 */
    const double t40 = (1.0/((-chi*v1_2 + t36)));
    const double t41 = chi*t40;
    const double t42 = t41*(-before_v1_2 + behind_v1_2);
    const double saltation_2_20 = -phi_2_00*t42 + phi_2_20;
    const double saltation_2_21 = -phi_2_01*t42 + phi_2_21 + t42;
    const double saltation_2_22 = -phi_2_02*t42 + phi_2_22;
    const double saltation_2_23 = -phi_2_03*t42 + phi_2_13*t42 + phi_2_23;
    const double t43 = behind_v2_2*t41;
    const double saltation_2_30 = -phi_2_00*t43;
    const double saltation_2_31 = behind_v2_2*chi*t40 - phi_2_01*t43;
    const double saltation_2_32 = -phi_2_02*t43;
    const double saltation_2_33 = -phi_2_03*t43 + phi_2_13*t43 + 1;
    /* Phi of phase 3 */
    const double phi_3_00 = phi_2_00*t11 + saltation_2_20*t10 + saltation_2_30*t13;
    const double phi_3_01 = phi_2_01*t11 + saltation_2_21*t10 + saltation_2_31*t13 + t12;
    const double phi_3_02 = phi_2_02*t11 + saltation_2_22*t10 + saltation_2_32*t13;
    const double phi_3_03 = phi_2_03*t11 + phi_2_13*t12 + saltation_2_23*t10 + saltation_2_33*t13;
    const double phi_3_10 = phi_2_00*t15 + saltation_2_20*t14 + saltation_2_30*t17;
    const double phi_3_11 = phi_2_01*t15 + saltation_2_21*t14 + saltation_2_31*t17 + t16;
    const double phi_3_12 = phi_2_02*t15 + saltation_2_22*t14 + saltation_2_32*t17;
    const double phi_3_13 = phi_2_03*t15 + phi_2_13*t16 + saltation_2_23*t14 + saltation_2_33*t17;
    const double phi_3_20 = phi_2_00*t20 + saltation_2_20*t11 + saltation_2_30*t12;
    const double phi_3_21 = p2*t18 + phi_2_01*t20 + saltation_2_21*t11 + saltation_2_31*t12 - t21;
    const double phi_3_22 = phi_2_02*t20 + saltation_2_22*t11 + saltation_2_32*t12;
    const double phi_3_23 = phi_2_03*t20 + phi_2_13*t22 + saltation_2_23*t11 + saltation_2_33*t12;
    const double phi_3_30 = phi_2_00*t23 + saltation_2_20*t15 + saltation_2_30*t16;
    const double phi_3_31 = phi_2_01*t23 + saltation_2_21*t15 + saltation_2_31*t16 - t24 - t25;
    const double phi_3_32 = phi_2_02*t23 + saltation_2_22*t15 + saltation_2_32*t16;
    const double phi_3_33 = phi_2_03*t23 + phi_2_13*t26 + saltation_2_23*t15 + saltation_2_33*t16;
    /* saltation of phase 3 */
    const double t44 = (1.0/(before_v1_3));
    const double t45 = t44*(V - v1_3);
    const double saltation_3_00 = phi_3_00 + phi_3_20*t45;
    const double saltation_3_01 = phi_3_01 + phi_3_21*t45;
    const double saltation_3_02 = phi_3_02 + phi_3_22*t45;
    const double saltation_3_03 = phi_3_03 + phi_3_23*t45;
    const double t46 = t44*(-before_v2_3 + behind_v2_3);
    const double saltation_3_30 = phi_3_20*t46 + phi_3_30;
    const double saltation_3_31 = phi_3_21*t46 + phi_3_31;
    const double saltation_3_32 = phi_3_22*t46 + phi_3_32;
    const double saltation_3_33 = phi_3_23*t46 + phi_3_33;
    /* Phi of phase 4 */
    const double phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t28 + saltation_3_30*t29;
    const double phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t28 + saltation_3_31*t29;
    const double phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t28 + saltation_3_32*t29;
    const double phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t28 + saltation_3_33*t29;
    const double phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t30 + saltation_3_00*t30;
    const double phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t30 + saltation_3_01*t30;
    const double phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t30 + saltation_3_02*t30;
    const double phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t30 + saltation_3_03*t30;
    /* saltation of phase 4 */
    const double t47 = (V - v2_4)/before_v2_4;
    const double saltation_4_10 = phi_4_10 + phi_4_30*t47;
    const double saltation_4_11 = phi_4_11 + phi_4_31*t47;
    const double saltation_4_12 = phi_4_12 + phi_4_32*t47;
    const double saltation_4_13 = phi_4_13 + phi_4_33*t47;
    monodromy[0] = saltation_3_00;
    monodromy[1] = saltation_3_01;
    monodromy[2] = saltation_3_02;
    monodromy[3] = saltation_3_03;
    monodromy[4] = saltation_4_10;
    monodromy[5] = saltation_4_11;
    monodromy[6] = saltation_4_12;
    monodromy[7] = saltation_4_13;
    monodromy[8] = 0;
    monodromy[9] = 0;
    monodromy[10] = 0;
    monodromy[11] = 0;
    monodromy[12] = 0;
    monodromy[13] = 0;
    monodromy[14] = 0;
    monodromy[15] = 0;
}

/* Trace of the Poincare map's Jacobian.
 * Takes parameters (5), spectrum (7), unknowns (6); gives trace, row by row.
 * Operations: 194. Intermediate terms: 64. */
void dry_friction_global_stick_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double *trace)
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t2 = V*tau;
    const double t3 = (1.0/((chi - 1)));
    const double z2_1 = V*sin_tau - cos_tau*e1*t3 - t2 - e2*t3/chi;
    /* slip-stick for tau */
    const double t4 = chi*z2_1;
    const double t5 = e1 + t4;
    const double t6 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t5 + t6*z2_1;
    const double z2_2 = t2 + z2_1;
    const double v1_2 = V*cos_tau + V*t6 + sin_tau*t4 - sin_tau*t5;
    /* functions of tau1 in slip-slip */
    const double t7 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t7);
    const double sin_omega1_tau1 = sin(t7);
    const double t8 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t8);
    const double sin_omega2_tau1 = sin(t8);
    /* slip-slip for tau1 */
    const double t9 = (1.0/(omega1));
    const double t12 = sin_omega2_tau1/omega2;
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = 1 - p1;
    const double t13 = p1*t10 + t11*t12;
    const double t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11;
    const double t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2;
    const double t16 = p3*sin_omega1_tau1*t9 - p3*t12;
    const double t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2;
    const double t19 = omega2*sin_omega2_tau1;
    const double t20 = omega1*sin_omega1_tau1;
    const double t21 = -p1*t20 - t11*t19;
    const double t22 = omega2*p2*sin_omega2_tau1 - p2*t20;
    const double v1_3 = V*t15 + t14*v1_2 + t21*z1_2 + t22*z2_2;
    const double t23 = omega2*p3*sin_omega2_tau1 - p3*t20;
    const double t24 = -p1*t19 - t11*t20;
    const double v2_3 = V*t18 + t17*v1_2 + t23*z1_2 + t24*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t25 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = V*sin_tau_by_tau - V - t25*t3;
    /* d/dtau of: slip-stick for tau */
    const double t26 = V*chi;
    const double t27 = V - t26;
    const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t27 + t25 + t26;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = cos_tau_by_tau*t27 - e1*sin_tau_by_tau;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t13*v1_2_by_tau + t14*z1_2_by_tau + t15*z2_2_by_tau;
    const double z2_3_by_tau = t16*v1_2_by_tau + t17*z1_2_by_tau + t18*z2_2_by_tau;
    const double v1_3_by_tau = t14*v1_2_by_tau + t21*z1_2_by_tau + t22*z2_2_by_tau;
    const double v2_3_by_tau = t17*v1_2_by_tau + t23*z1_2_by_tau + t24*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t28 = chi*z2_3;
    const double v1_3_by_tau1 = t28 - z1_3;
    const double v2_3_by_tau1 = chi*eta*z1_3 - eta*t28;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/dtau of: first return of tau2 */
    const double t29 = 2*cosine_part_tau2;
    const double t30 = 2*sine_part_tau2;
    const double t31 = (1.0/2.0)/amplitude_tau2;
    const double amplitude_tau2_by_tau = t31*(sine_part_tau2_by_tau*t30 + t29*v2_3_by_tau);
    /* d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1 = t31*(sine_part_tau2_by_tau1*t30 + t29*v2_3_by_tau1);
    /* outputs */
    const double t32 = t3/omega3;
    *trace = (amplitude_tau2_by_tau*t32 - amplitude_tau2_by_tau1*t32*v1_3_by_tau/v1_3_by_tau1)/z2_1_by_tau;
}

/* Derivatives of the trace by the unknowns, then in total by the parameters.
 * Takes parameters (5), spectrum (7), spectrum_derivatives (7, 2), unknowns (6); gives trace_gradient (11), row by row.
 * Operations: 1293. Intermediate terms: 348. */
void dry_friction_global_stick_trace_gradient(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double trace_gradient[11])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double omega3_by_chi = spectrum_derivatives[12];
    const double omega3_by_eta = spectrum_derivatives[13];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t2 = V*tau;
    const double t3 = chi - 1;
    const double t4 = (1.0/(t3));
    const double t5 = cos_tau*t4;
    const double t6 = (1.0/(chi));
    const double t7 = t4*t6;
    const double z2_1 = V*sin_tau - e1*t5 - e2*t7 - t2;
    /* slip-stick for tau */
    const double t8 = chi*z2_1;
    const double t9 = e1 + t8;
    const double t10 = chi*cos_tau;
    const double t11 = chi - t10;
    const double t12 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t12) + cos_tau*t9 + t11*z2_1;
    const double z2_2 = t2 + z2_1;
    const double v1_2 = V*cos_tau + V*t11 + sin_tau*t8 - sin_tau*t9;
    /* functions of tau1 in slip-slip */
    const double t13 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t13);
    const double sin_omega1_tau1 = sin(t13);
    const double t16 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t16);
    const double sin_omega2_tau1 = sin(t16);
    /* slip-slip for tau1 */
    const double t19 = (1.0/(omega1));
    const double t20 = sin_omega1_tau1*t19;
    const double t21 = 1 - p1;
    const double t22 = (1.0/(omega2));
    const double t23 = sin_omega2_tau1*t22;
    const double t24 = p1*t20 + t21*t23;
    const double t25 = cos_omega1_tau1*p1 + cos_omega2_tau1*t21;
    const double t26 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t27 = p2*t23;
    const double z1_3 = V*(p2*sin_omega1_tau1*t19 - t27) + t24*v1_2 + t25*z1_2 + t26*z2_2;
    const double t28 = p3*sin_omega1_tau1*t19 - p3*t23;
    const double t29 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t30 = cos_omega1_tau1*t21 + cos_omega2_tau1*p1;
    const double t31 = p1*t23 + t20*t21;
    const double z2_3 = V*t31 + t28*v1_2 + t29*z1_2 + t30*z2_2;
    const double t32 = omega2*sin_omega2_tau1;
    const double t33 = omega1*sin_omega1_tau1;
    const double t34 = -p1*t33 - t21*t32;
    const double t35 = omega2*p2*sin_omega2_tau1 - p2*t33;
    const double v1_3 = V*t26 + t25*v1_2 + t34*z1_2 + t35*z2_2;
    const double t36 = omega2*p3*sin_omega2_tau1 - p3*t33;
    const double t37 = -p1*t32 - t21*t33;
    const double v2_3 = V*t30 + t29*v1_2 + t36*z1_2 + t37*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t40 = -V*sin_tau_by_tau;
    const double t41 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = -V - t4*t41 - t40;
    /* d/dtau of: slip-stick for tau */
    const double t42 = V*chi;
    const double t43 = V - t42;
    const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t43 + t41 + t42;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = cos_tau_by_tau*t43 - e1*sin_tau_by_tau;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t24*v1_2_by_tau + t25*z1_2_by_tau + t26*z2_2_by_tau;
    const double z2_3_by_tau = t28*v1_2_by_tau + t29*z1_2_by_tau + t30*z2_2_by_tau;
    const double v1_3_by_tau = t25*v1_2_by_tau + t34*z1_2_by_tau + t35*z2_2_by_tau;
    const double v2_3_by_tau = t29*v1_2_by_tau + t36*z1_2_by_tau + t37*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t45 = chi*z2_3;
    const double v1_3_by_tau1 = t45 - z1_3;
    const double t46 = eta*z1_3;
    const double v2_3_by_tau1 = chi*t46 - eta*t45;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/dtau of: first return of tau2 */
    const double t47 = 2*cosine_part_tau2;
    const double t48 = 2*sine_part_tau2;
    const double t49 = sine_part_tau2_by_tau*t48 + t47*v2_3_by_tau;
    const double t50 = (1.0/(amplitude_tau2));
    const double t51 = (1.0/2.0)*t50;
    const double amplitude_tau2_by_tau = t49*t51;
    /* d/dtau1 of: first return of tau2 */
    const double t52 = sine_part_tau2_by_tau1*t48 + t47*v2_3_by_tau1;
    const double amplitude_tau2_by_tau1 = t51*t52;
    /* d/dchi of: z2_1: linear in second-breaks-forward */
    const double t53 = (1.0/(t3*t3));
    const double z2_1_by_chi = cos_tau*e1*t53 + e2*t53*t6 + e2*t4/(chi*chi);
    /* d/dV of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_V = sin_tau - tau;
    /* d/de1 of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_e1 = -t5;
    /* d/de2 of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_e2 = -t7;
    /* d/dchi of: slip-stick for tau */
    const double t55 = 1 - cos_tau;
    const double z1_2_by_chi = -V*z2_1_by_V + chi*z2_1_by_chi + cos_tau*z2_1 + t55*z2_1;
    const double v1_2_by_chi = V*t55;
    /* d/dV of: slip-stick for tau */
    const double z1_2_by_V = chi*tau + chi*z2_1_by_V + sin_tau - t12;
    const double z2_2_by_V = tau + z2_1_by_V;
    const double v1_2_by_V = chi + cos_tau - t10;
    /* d/de1 of: slip-stick for tau */
    const double z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau;
    const double v1_2_by_e1 = -sin_tau;
    /* d/de2 of: slip-stick for tau */
    const double z1_2_by_e2 = chi*z2_1_by_e2;
    /* d/dtau1 of: functions of tau1 in slip-slip */
    const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
    const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
    const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
    const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t56 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t56;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t56;
    const double t57 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t57;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t57;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t58 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t58;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t58;
    const double t59 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t59;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t59;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t60 = p1*z1_2;
    const double t61 = p2*z2_2;
    const double t62 = t60 + t61;
    const double t63 = t21*z1_2 - t61;
    const double t64 = p1*v1_2;
    const double t65 = V*p2;
    const double t66 = t19*t64 + t19*t65;
    const double t67 = t21*t22*v1_2 - t22*t65;
    const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t62 + cos_omega2_tau1_by_tau1*t63 + sin_omega1_tau1_by_tau1*t66 + sin_omega2_tau1_by_tau1*t67;
    const double t68 = p3*z1_2;
    const double t69 = t21*z2_2;
    const double t70 = t68 + t69;
    const double t71 = p1*z2_2;
    const double t72 = -t68 + t71;
    const double t73 = p3*v1_2;
    const double t74 = V*t21;
    const double t75 = t19*t73 + t19*t74;
    const double t76 = V*p1;
    const double t77 = -t22*t73 + t22*t76;
    const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t70 + cos_omega2_tau1_by_tau1*t72 + sin_omega1_tau1_by_tau1*t75 + sin_omega2_tau1_by_tau1*t77;
    /* d/dchi of: slip-slip for tau1 */
    const double t78 = sin_omega1_tau1/(omega1*omega1);
    const double t79 = -t64*t78 - t65*t78;
    const double t80 = (1.0/(omega2*omega2));
    const double t81 = sin_omega2_tau1*t80;
    const double t82 = -t21*t81*v1_2 + t65*t81;
    const double t83 = -sin_omega1_tau1*t19 + t23;
    const double t85 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t86 = -t83*v1_2 + t85*z1_2;
    const double t87 = -V*t83 + t85*z2_2;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t62 + cos_omega2_tau1_by_chi*t63 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau1_by_chi*t66 + sin_omega2_tau1_by_chi*t67 + t24*v1_2_by_chi + t25*z1_2_by_chi + t26*z2_1_by_chi;
    const double t88 = -t73*t78 - t74*t78;
    const double t89 = p3*sin_omega2_tau1*t80*v1_2 - t76*t81;
    const double t91 = V*t83 - t85*z2_2;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t70 + cos_omega2_tau1_by_chi*t72 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau1_by_chi*t75 + sin_omega2_tau1_by_chi*t77 + t28*v1_2_by_chi + t29*z1_2_by_chi + t30*z2_1_by_chi;
    const double t92 = t64 + t65;
    const double t93 = t21*v1_2 - t65;
    const double t94 = -sin_omega1_tau1*t60 - sin_omega1_tau1*t61;
    const double t95 = t21*z1_2;
    const double t96 = sin_omega2_tau1*t61 - sin_omega2_tau1*t95;
    const double t97 = -omega2*sin_omega2_tau1 + t33;
    const double t99 = t85*v1_2 - t97*z1_2;
    const double t100 = V*t85 - t97*z2_2;
    const double t101 = -omega1*t60 - omega1*t61;
    const double t102 = omega2*t61 - omega2*t95;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t92 + cos_omega2_tau1_by_chi*t93 + omega1_by_chi*t94 + omega2_by_chi*t96 + p1_by_chi*t99 + p2_by_chi*t100 + sin_omega1_tau1_by_chi*t101 + sin_omega2_tau1_by_chi*t102 + t25*v1_2_by_chi + t34*z1_2_by_chi + t35*z2_1_by_chi;
    const double t103 = t73 + t74;
    const double t104 = -t73 + t76;
    const double t105 = -sin_omega1_tau1*t68 - sin_omega1_tau1*t69;
    const double t106 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t71;
    const double t107 = -V*t85 + t97*z2_2;
    const double t108 = -omega1*t68 - omega1*t69;
    const double t109 = omega2*p3*z1_2 - omega2*t71;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t103 + cos_omega2_tau1_by_chi*t104 + omega1_by_chi*t105 + omega2_by_chi*t106 + p1_by_chi*t107 + p3_by_chi*t99 + sin_omega1_tau1_by_chi*t108 + sin_omega2_tau1_by_chi*t109 + t29*v1_2_by_chi + t36*z1_2_by_chi + t37*z2_1_by_chi;
    /* d/deta of: slip-slip for tau1 */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t62 + cos_omega2_tau1_by_eta*t63 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau1_by_eta*t66 + sin_omega2_tau1_by_eta*t67;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t70 + cos_omega2_tau1_by_eta*t72 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau1_by_eta*t75 + sin_omega2_tau1_by_eta*t77;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t92 + cos_omega2_tau1_by_eta*t93 + omega1_by_eta*t94 + omega2_by_eta*t96 + p1_by_eta*t99 + p2_by_eta*t100 + sin_omega1_tau1_by_eta*t101 + sin_omega2_tau1_by_eta*t102;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t103 + cos_omega2_tau1_by_eta*t104 + omega1_by_eta*t105 + omega2_by_eta*t106 + p1_by_eta*t107 + p3_by_eta*t99 + sin_omega1_tau1_by_eta*t108 + sin_omega2_tau1_by_eta*t109;
    /* d/dV of: slip-slip for tau1 */
    const double z1_3_by_V = p2*t20 + t24*v1_2_by_V + t25*z1_2_by_V + t26*z2_2_by_V - t27;
    const double z2_3_by_V = t28*v1_2_by_V + t29*z1_2_by_V + t30*z2_2_by_V + t31;
    const double v1_3_by_V = t25*v1_2_by_V + t26 + t34*z1_2_by_V + t35*z2_2_by_V;
    const double v2_3_by_V = t29*v1_2_by_V + t30 + t36*z1_2_by_V + t37*z2_2_by_V;
    /* d/de1 of: slip-slip for tau1 */
    const double z1_3_by_e1 = t24*v1_2_by_e1 + t25*z1_2_by_e1 + t26*z2_1_by_e1;
    const double z2_3_by_e1 = t28*v1_2_by_e1 + t29*z1_2_by_e1 + t30*z2_1_by_e1;
    const double v1_3_by_e1 = t25*v1_2_by_e1 + t34*z1_2_by_e1 + t35*z2_1_by_e1;
    const double v2_3_by_e1 = t29*v1_2_by_e1 + t36*z1_2_by_e1 + t37*z2_1_by_e1;
    /* d/de2 of: slip-slip for tau1 */
    const double z1_3_by_e2 = t25*z1_2_by_e2 + t26*z2_1_by_e2;
    const double z2_3_by_e2 = t29*z1_2_by_e2 + t30*z2_1_by_e2;
    const double v1_3_by_e2 = t34*z1_2_by_e2 + t35*z2_1_by_e2;
    const double v2_3_by_e2 = t36*z1_2_by_e2 + t37*z2_1_by_e2;
    /* d/dchi of: first return of tau2 */
    const double t110 = z1_3 - z2_3;
    const double sine_part_tau2_by_chi = omega3*z1_3_by_chi - omega3*z2_3_by_chi + omega3_by_chi*t110;
    /* d/deta of: first return of tau2 */
    const double sine_part_tau2_by_eta = omega3*z1_3_by_eta - omega3*z2_3_by_eta + omega3_by_eta*t110;
    /* d/dV of: first return of tau2 */
    const double cosine_part_tau2_by_V = v2_3_by_V - 1;
    const double sine_part_tau2_by_V = omega3*z1_3_by_V - omega3*z2_3_by_V;
    /* d/de1 of: first return of tau2 */
    const double sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1;
    /* d/de2 of: first return of tau2 */
    const double sine_part_tau2_by_e2 = omega3*z1_3_by_e2 - omega3*z2_3_by_e2;
    /* d/dchi of: first return of tau2 */
    const double amplitude_tau2_by_chi = t51*(sine_part_tau2_by_chi*t48 + t47*v2_3_by_chi);
    /* d/deta of: first return of tau2 */
    const double amplitude_tau2_by_eta = t51*(sine_part_tau2_by_eta*t48 + t47*v2_3_by_eta);
    /* d/dV of: first return of tau2 */
    const double amplitude_tau2_by_V = t51*(cosine_part_tau2_by_V*t47 + sine_part_tau2_by_V*t48);
    /* d/de1 of: first return of tau2 */
    const double amplitude_tau2_by_e1 = t51*(sine_part_tau2_by_e1*t48 + t47*v2_3_by_e1);
    /* d/de2 of: first return of tau2 */
    const double amplitude_tau2_by_e2 = t51*(sine_part_tau2_by_e2*t48 + t47*v2_3_by_e2);
    /* d/dtau of: d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau_by_tau = -cos_tau;
    const double sin_tau_by_tau_by_tau = -sin_tau;
    /* d/dtau of: d/dtau of: z2_1: linear in second-breaks-forward */
    const double t111 = cos_tau_by_tau_by_tau*e1;
    const double z2_1_by_tau_by_tau = V*sin_tau_by_tau_by_tau - t111*t4;
    /* d/dchi of: d/dtau of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_tau_by_chi = t41*t53;
    /* d/dV of: d/dtau of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_tau_by_V = sin_tau_by_tau - 1;
    /* d/de1 of: d/dtau of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_tau_by_e1 = -cos_tau_by_tau*t4;
    /* d/dtau of: d/dtau of: slip-stick for tau */
    const double z1_2_by_tau_by_tau = chi*z2_1_by_tau_by_tau + sin_tau_by_tau_by_tau*t43 + t111;
    const double v1_2_by_tau_by_tau = cos_tau_by_tau_by_tau*t43 - e1*sin_tau_by_tau_by_tau;
    /* d/dchi of: d/dtau of: slip-stick for tau */
    const double z1_2_by_tau_by_chi = chi*z2_1_by_tau_by_chi + t40 + z2_2_by_tau;
    const double v1_2_by_tau_by_chi = -V*cos_tau_by_tau;
    /* d/dV of: d/dtau of: slip-stick for tau */
    const double z1_2_by_tau_by_V = chi*z2_1_by_tau_by_V + chi - sin_tau_by_tau*t3;
    const double z2_2_by_tau_by_V = z2_1_by_tau_by_V + 1;
    const double v1_2_by_tau_by_V = -cos_tau_by_tau*t3;
    /* d/de1 of: d/dtau of: slip-stick for tau */
    const double z1_2_by_tau_by_e1 = chi*z2_1_by_tau_by_e1 + cos_tau_by_tau;
    const double v1_2_by_tau_by_e1 = -sin_tau_by_tau;
    /* d/dtau of: d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau_by_tau = t24*v1_2_by_tau_by_tau + t25*z1_2_by_tau_by_tau + t26*z2_1_by_tau_by_tau;
    const double z2_3_by_tau_by_tau = t28*v1_2_by_tau_by_tau + t29*z1_2_by_tau_by_tau + t30*z2_1_by_tau_by_tau;
    const double v1_3_by_tau_by_tau = t25*v1_2_by_tau_by_tau + t34*z1_2_by_tau_by_tau + t35*z2_1_by_tau_by_tau;
    const double v2_3_by_tau_by_tau = t29*v1_2_by_tau_by_tau + t36*z1_2_by_tau_by_tau + t37*z2_1_by_tau_by_tau;
    /* d/dtau1 of: d/dtau of: slip-slip for tau1 */
    const double t113 = p1*z1_2_by_tau;
    const double t114 = p2*z2_2_by_tau;
    const double t115 = t113 + t114;
    const double t116 = -t114 + t21*z1_2_by_tau;
    const double t117 = t19*v1_2_by_tau;
    const double t118 = sin_omega1_tau1_by_tau1*t117;
    const double t119 = t22*v1_2_by_tau;
    const double t120 = sin_omega2_tau1_by_tau1*t119;
    const double z1_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t115 + cos_omega2_tau1_by_tau1*t116 + p1*t118 + t120*t21;
    const double t121 = p3*z1_2_by_tau;
    const double t122 = t21*z2_2_by_tau;
    const double t123 = t121 + t122;
    const double t124 = p1*z2_2_by_tau;
    const double t125 = -t121 + t124;
    const double z2_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t123 + cos_omega2_tau1_by_tau1*t125 + p3*t118 - p3*t120;
    const double t126 = -omega1*t113 - omega1*t114;
    const double t127 = t21*z1_2_by_tau;
    const double t128 = omega2*t114 - omega2*t127;
    const double t129 = cos_omega1_tau1_by_tau1*v1_2_by_tau;
    const double t130 = cos_omega2_tau1_by_tau1*v1_2_by_tau;
    const double v1_3_by_tau_by_tau1 = p1*t129 + sin_omega1_tau1_by_tau1*t126 + sin_omega2_tau1_by_tau1*t128 + t130*t21;
    const double t131 = -omega1*t121 - omega1*t122;
    const double t132 = omega2*p3*z1_2_by_tau - omega2*t124;
    const double v2_3_by_tau_by_tau1 = p3*t129 - p3*t130 + sin_omega1_tau1_by_tau1*t131 + sin_omega2_tau1_by_tau1*t132;
    /* d/dchi of: d/dtau of: slip-slip for tau1 */
    const double t133 = -t83*v1_2_by_tau + t85*z1_2_by_tau;
    const double t134 = p2_by_chi*z2_2_by_tau;
    const double t135 = sin_omega1_tau1_by_chi*t117;
    const double t136 = sin_omega2_tau1_by_chi*t119;
    const double t137 = t78*v1_2_by_tau;
    const double t138 = omega1_by_chi*t137;
    const double t139 = t81*v1_2_by_tau;
    const double t140 = omega2_by_chi*t139;
    const double z1_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t115 + cos_omega2_tau1_by_chi*t116 + p1*t135 - p1*t138 + p1_by_chi*t133 + t134*t85 + t136*t21 - t140*t21 + t24*v1_2_by_tau_by_chi + t25*z1_2_by_tau_by_chi + t26*z2_1_by_tau_by_chi;
    const double t141 = p1_by_chi*z2_2_by_tau;
    const double z2_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t123 + cos_omega2_tau1_by_chi*t125 + p3*t135 - p3*t136 - p3*t138 + p3*t140 + p3_by_chi*t133 - t141*t85 + t28*v1_2_by_tau_by_chi + t29*z1_2_by_tau_by_chi + t30*z2_1_by_tau_by_chi;
    const double t142 = -sin_omega1_tau1*t113 - sin_omega1_tau1*t114;
    const double t143 = sin_omega2_tau1*t114 - sin_omega2_tau1*t127;
    const double t144 = t85*v1_2_by_tau - t97*z1_2_by_tau;
    const double t145 = cos_omega1_tau1_by_chi*v1_2_by_tau;
    const double t146 = cos_omega2_tau1_by_chi*v1_2_by_tau;
    const double v1_3_by_tau_by_chi = omega1_by_chi*t142 + omega2_by_chi*t143 + p1*t145 + p1_by_chi*t144 + sin_omega1_tau1_by_chi*t126 + sin_omega2_tau1_by_chi*t128 - t134*t97 + t146*t21 + t25*v1_2_by_tau_by_chi + t34*z1_2_by_tau_by_chi + t35*z2_1_by_tau_by_chi;
    const double t147 = -sin_omega1_tau1*t121 - sin_omega1_tau1*t122;
    const double t148 = p3*sin_omega2_tau1*z1_2_by_tau - sin_omega2_tau1*t124;
    const double v2_3_by_tau_by_chi = omega1_by_chi*t147 + omega2_by_chi*t148 + p3*t145 - p3*t146 + p3_by_chi*t144 + sin_omega1_tau1_by_chi*t131 + sin_omega2_tau1_by_chi*t132 + t141*t97 + t29*v1_2_by_tau_by_chi + t36*z1_2_by_tau_by_chi + t37*z2_1_by_tau_by_chi;
    /* d/deta of: d/dtau of: slip-slip for tau1 */
    const double t149 = p2_by_eta*z2_2_by_tau;
    const double t150 = sin_omega1_tau1_by_eta*t117;
    const double t151 = sin_omega2_tau1_by_eta*t119;
    const double t152 = omega1_by_eta*t137;
    const double t153 = omega2_by_eta*t139;
    const double z1_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t115 + cos_omega2_tau1_by_eta*t116 + p1*t150 - p1*t152 + p1_by_eta*t133 + t149*t85 + t151*t21 - t153*t21;
    const double t154 = p1_by_eta*z2_2_by_tau;
    const double z2_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t123 + cos_omega2_tau1_by_eta*t125 + p3*t150 - p3*t151 - p3*t152 + p3*t153 + p3_by_eta*t133 - t154*t85;
    const double t155 = cos_omega1_tau1_by_eta*v1_2_by_tau;
    const double t156 = cos_omega2_tau1_by_eta*v1_2_by_tau;
    const double v1_3_by_tau_by_eta = omega1_by_eta*t142 + omega2_by_eta*t143 + p1*t155 + p1_by_eta*t144 + sin_omega1_tau1_by_eta*t126 + sin_omega2_tau1_by_eta*t128 - t149*t97 + t156*t21;
    const double v2_3_by_tau_by_eta = omega1_by_eta*t147 + omega2_by_eta*t148 + p3*t155 - p3*t156 + p3_by_eta*t144 + sin_omega1_tau1_by_eta*t131 + sin_omega2_tau1_by_eta*t132 + t154*t97;
    /* d/dV of: d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau_by_V = t24*v1_2_by_tau_by_V + t25*z1_2_by_tau_by_V + t26*z2_2_by_tau_by_V;
    const double z2_3_by_tau_by_V = t28*v1_2_by_tau_by_V + t29*z1_2_by_tau_by_V + t30*z2_2_by_tau_by_V;
    const double v1_3_by_tau_by_V = t25*v1_2_by_tau_by_V + t34*z1_2_by_tau_by_V + t35*z2_2_by_tau_by_V;
    const double v2_3_by_tau_by_V = t29*v1_2_by_tau_by_V + t36*z1_2_by_tau_by_V + t37*z2_2_by_tau_by_V;
    /* d/de1 of: d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau_by_e1 = t24*v1_2_by_tau_by_e1 + t25*z1_2_by_tau_by_e1 + t26*z2_1_by_tau_by_e1;
    const double z2_3_by_tau_by_e1 = t28*v1_2_by_tau_by_e1 + t29*z1_2_by_tau_by_e1 + t30*z2_1_by_tau_by_e1;
    const double v1_3_by_tau_by_e1 = t25*v1_2_by_tau_by_e1 + t34*z1_2_by_tau_by_e1 + t35*z2_1_by_tau_by_e1;
    const double v2_3_by_tau_by_e1 = t29*v1_2_by_tau_by_e1 + t36*z1_2_by_tau_by_e1 + t37*z2_1_by_tau_by_e1;
    /* d/dtau of: d/dtau1 of: slip-slip for tau1 */
    const double t157 = chi*z2_3_by_tau;
    const double v1_3_by_tau1_by_tau = t157 - z1_3_by_tau;
    const double t158 = chi*eta;
    const double v2_3_by_tau1_by_tau = -eta*t157 + t158*z1_3_by_tau;
    /* d/dtau1 of: d/dtau1 of: slip-slip for tau1 */
    const double t159 = chi*z2_3_by_tau1;
    const double v1_3_by_tau1_by_tau1 = t159 - z1_3_by_tau1;
    const double v2_3_by_tau1_by_tau1 = -eta*t159 + t158*z1_3_by_tau1;
    /* d/dchi of: d/dtau1 of: slip-slip for tau1 */
    const double t160 = chi*z2_3_by_chi;
    const double v1_3_by_tau1_by_chi = t160 - z1_3_by_chi + z2_3;
    const double v2_3_by_tau1_by_chi = -eta*t160 - eta*z2_3 + t158*z1_3_by_chi + t46;
    /* d/deta of: d/dtau1 of: slip-slip for tau1 */
    const double t161 = chi*z2_3_by_eta;
    const double v1_3_by_tau1_by_eta = t161 - z1_3_by_eta;
    const double v2_3_by_tau1_by_eta = chi*z1_3 - eta*t161 + t158*z1_3_by_eta - t45;
    /* d/dV of: d/dtau1 of: slip-slip for tau1 */
    const double t162 = chi*z2_3_by_V;
    const double v1_3_by_tau1_by_V = t162 - z1_3_by_V;
    const double v2_3_by_tau1_by_V = -eta*t162 + t158*z1_3_by_V;
    /* d/de1 of: d/dtau1 of: slip-slip for tau1 */
    const double t163 = chi*z2_3_by_e1;
    const double v1_3_by_tau1_by_e1 = t163 - z1_3_by_e1;
    const double v2_3_by_tau1_by_e1 = -eta*t163 + t158*z1_3_by_e1;
    /* d/de2 of: d/dtau1 of: slip-slip for tau1 */
    const double t164 = chi*z2_3_by_e2;
    const double v1_3_by_tau1_by_e2 = t164 - z1_3_by_e2;
    const double v2_3_by_tau1_by_e2 = -eta*t164 + t158*z1_3_by_e2;
    /* d/dtau of: d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau_by_tau = omega3*z1_3_by_tau_by_tau - omega3*z2_3_by_tau_by_tau;
    /* d/dtau1 of: d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau_by_tau1 = omega3*z1_3_by_tau_by_tau1 - omega3*z2_3_by_tau_by_tau1;
    /* d/dchi of: d/dtau of: first return of tau2 */
    const double t165 = z1_3_by_tau - z2_3_by_tau;
    const double sine_part_tau2_by_tau_by_chi = omega3*z1_3_by_tau_by_chi - omega3*z2_3_by_tau_by_chi + omega3_by_chi*t165;
    /* d/deta of: d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau_by_eta = omega3*z1_3_by_tau_by_eta - omega3*z2_3_by_tau_by_eta + omega3_by_eta*t165;
    /* d/dV of: d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau_by_V = omega3*z1_3_by_tau_by_V - omega3*z2_3_by_tau_by_V;
    /* d/de1 of: d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau_by_e1 = omega3*z1_3_by_tau_by_e1 - omega3*z2_3_by_tau_by_e1;
    /* d/dtau of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_tau = omega3*v1_3_by_tau - omega3*v2_3_by_tau;
    /* d/dtau1 of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_tau1 = omega3*v1_3_by_tau1 - omega3*v2_3_by_tau1;
    /* d/dchi of: d/dtau1 of: first return of tau2 */
    const double t166 = v1_3 - v2_3;
    const double sine_part_tau2_by_tau1_by_chi = omega3*v1_3_by_chi - omega3*v2_3_by_chi + omega3_by_chi*t166;
    /* d/deta of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_eta = omega3*v1_3_by_eta - omega3*v2_3_by_eta + omega3_by_eta*t166;
    /* d/dV of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_V = omega3*v1_3_by_V - omega3*v2_3_by_V;
    /* d/de1 of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_e1 = omega3*v1_3_by_e1 - omega3*v2_3_by_e1;
    /* d/de2 of: d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1_by_e2 = omega3*v1_3_by_e2 - omega3*v2_3_by_e2;
    /* d/dtau of: d/dtau of: first return of tau2 */
    const double t167 = cosine_part_tau2*t50;
    const double t168 = sine_part_tau2*t50;
    const double t169 = (1.0/2.0)/(amplitude_tau2*amplitude_tau2);
    const double t170 = t169*t49;
    const double amplitude_tau2_by_tau_by_tau = -amplitude_tau2_by_tau*t170 + (sine_part_tau2_by_tau*sine_part_tau2_by_tau)*t50 + sine_part_tau2_by_tau_by_tau*t168 + t167*v2_3_by_tau_by_tau + t50*(v2_3_by_tau*v2_3_by_tau);
    /* d/dtau1 of: d/dtau of: first return of tau2 */
    const double t171 = sine_part_tau2_by_tau*t50;
    const double t172 = t50*v2_3_by_tau;
    const double t173 = sine_part_tau2_by_tau1*t171 + t172*v2_3_by_tau1;
    const double amplitude_tau2_by_tau_by_tau1 = -amplitude_tau2_by_tau1*t170 + sine_part_tau2_by_tau_by_tau1*t168 + t167*v2_3_by_tau_by_tau1 + t173;
    /* d/dchi of: d/dtau of: first return of tau2 */
    const double amplitude_tau2_by_tau_by_chi = -amplitude_tau2_by_chi*t170 + sine_part_tau2_by_chi*t171 + sine_part_tau2_by_tau_by_chi*t168 + t167*v2_3_by_tau_by_chi + t172*v2_3_by_chi;
    /* d/deta of: d/dtau of: first return of tau2 */
    const double amplitude_tau2_by_tau_by_eta = -amplitude_tau2_by_eta*t170 + sine_part_tau2_by_eta*t171 + sine_part_tau2_by_tau_by_eta*t168 + t167*v2_3_by_tau_by_eta + t172*v2_3_by_eta;
    /* d/dV of: d/dtau of: first return of tau2 */
    const double amplitude_tau2_by_tau_by_V = -amplitude_tau2_by_V*t170 + cosine_part_tau2_by_V*t172 + sine_part_tau2_by_V*t171 + sine_part_tau2_by_tau_by_V*t168 + t167*v2_3_by_tau_by_V;
    /* d/de1 of: d/dtau of: first return of tau2 */
    const double amplitude_tau2_by_tau_by_e1 = -amplitude_tau2_by_e1*t170 + sine_part_tau2_by_e1*t171 + sine_part_tau2_by_tau_by_e1*t168 + t167*v2_3_by_tau_by_e1 + t172*v2_3_by_e1;
    /* d/de2 of: d/dtau of: first return of tau2 */
    const double amplitude_tau2_by_tau_by_e2 = -amplitude_tau2_by_e2*t170 + sine_part_tau2_by_e2*t171 + t172*v2_3_by_e2;
    /* d/dtau of: d/dtau1 of: first return of tau2 */
    const double t174 = t169*t52;
    const double amplitude_tau2_by_tau1_by_tau = -amplitude_tau2_by_tau*t174 + sine_part_tau2_by_tau1_by_tau*t168 + t167*v2_3_by_tau1_by_tau + t173;
    /* d/dtau1 of: d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1_by_tau1 = -amplitude_tau2_by_tau1*t174 + (sine_part_tau2_by_tau1*sine_part_tau2_by_tau1)*t50 + sine_part_tau2_by_tau1_by_tau1*t168 + t167*v2_3_by_tau1_by_tau1 + t50*(v2_3_by_tau1*v2_3_by_tau1);
    /* d/dchi of: d/dtau1 of: first return of tau2 */
    const double t175 = sine_part_tau2_by_tau1*t50;
    const double t176 = t50*v2_3_by_tau1;
    const double amplitude_tau2_by_tau1_by_chi = -amplitude_tau2_by_chi*t174 + sine_part_tau2_by_chi*t175 + sine_part_tau2_by_tau1_by_chi*t168 + t167*v2_3_by_tau1_by_chi + t176*v2_3_by_chi;
    /* d/deta of: d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1_by_eta = -amplitude_tau2_by_eta*t174 + sine_part_tau2_by_eta*t175 + sine_part_tau2_by_tau1_by_eta*t168 + t167*v2_3_by_tau1_by_eta + t176*v2_3_by_eta;
    /* d/dV of: d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1_by_V = -amplitude_tau2_by_V*t174 + cosine_part_tau2_by_V*t176 + sine_part_tau2_by_V*t175 + sine_part_tau2_by_tau1_by_V*t168 + t167*v2_3_by_tau1_by_V;
    /* d/de1 of: d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1_by_e1 = -amplitude_tau2_by_e1*t174 + sine_part_tau2_by_e1*t175 + sine_part_tau2_by_tau1_by_e1*t168 + t167*v2_3_by_tau1_by_e1 + t176*v2_3_by_e1;
    /* d/de2 of: d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1_by_e2 = -amplitude_tau2_by_e2*t174 + sine_part_tau2_by_e2*t175 + sine_part_tau2_by_tau1_by_e2*t168 + t167*v2_3_by_tau1_by_e2 + t176*v2_3_by_e2;
    /* outputs */
    const double t177 = (1.0/(omega3));
    const double t178 = amplitude_tau2_by_tau*t177;
    const double t179 = t177*t4;
    const double t180 = (1.0/(v1_3_by_tau1));
    const double t181 = amplitude_tau2_by_tau1*t180;
    const double t182 = (t178*t4 - t179*t181*v1_3_by_tau)/(z2_1_by_tau*z2_1_by_tau);
    const double t183 = (1.0/(z2_1_by_tau));
    const double t184 = t179*t183;
    const double t185 = t181*t184;
    const double t186 = t184*v1_3_by_tau;
    const double t187 = t180*t186;
    const double t188 = (1.0/(v1_3_by_tau1*v1_3_by_tau1));
    const double t189 = amplitude_tau2_by_tau1*t186*t188;
    const double t190 = (1.0/(omega3*omega3));
    const double t191 = t183*(-amplitude_tau2_by_tau*t190*t4 + amplitude_tau2_by_tau1*t180*t190*t4*v1_3_by_tau);
    trace_gradient[0] = 0;
    trace_gradient[1] = 0;
    trace_gradient[2] = 0;
    trace_gradient[3] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_tau - amplitude_tau2_by_tau1_by_tau*t187 + amplitude_tau2_by_tau_by_tau*t177*t183*t4 - t182*z2_1_by_tau_by_tau - t185*v1_3_by_tau_by_tau;
    trace_gradient[4] = -amplitude_tau2_by_tau1_by_tau1*t187 + amplitude_tau2_by_tau_by_tau1*t184 - t185*v1_3_by_tau_by_tau1 + t189*v1_3_by_tau1_by_tau1;
    trace_gradient[5] = 0;
    trace_gradient[6] = -amplitude_tau2_by_tau1_by_chi*t187 + amplitude_tau2_by_tau_by_chi*t184 + omega3_by_chi*t191 - t182*z2_1_by_tau_by_chi + t183*(amplitude_tau2_by_tau1*t177*t180*t53*v1_3_by_tau - t178*t53) - t185*v1_3_by_tau_by_chi + t189*v1_3_by_tau1_by_chi;
    trace_gradient[7] = -amplitude_tau2_by_tau1_by_eta*t187 + amplitude_tau2_by_tau_by_eta*t184 + omega3_by_eta*t191 - t185*v1_3_by_tau_by_eta + t189*v1_3_by_tau1_by_eta;
    trace_gradient[8] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_V - amplitude_tau2_by_tau1_by_V*t187 + amplitude_tau2_by_tau_by_V*t177*t183*t4 - t182*z2_1_by_tau_by_V - t185*v1_3_by_tau_by_V;
    trace_gradient[9] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_e1 - amplitude_tau2_by_tau1_by_e1*t187 + amplitude_tau2_by_tau_by_e1*t177*t183*t4 - t182*z2_1_by_tau_by_e1 - t185*v1_3_by_tau_by_e1;
    trace_gradient[10] = -amplitude_tau2_by_tau1_by_e2*t187 + amplitude_tau2_by_tau_by_e2*t184 + t189*v1_3_by_tau1_by_e2;
}

/* State at the start and behind each transition, row by row.
 * Takes parameters (5), spectrum (7), unknowns (6); gives states (5, 4), row by row.
 * Operations: 108. Intermediate terms: 32. */
void dry_friction_global_stick_states(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double states[20])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
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
    const double t5 = (1.0/(omega1));
    const double t6 = sin_omega1_tau1*t5;
    const double t7 = 1 - p1;
    const double t8 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + v1_2*(p1*t6 + t7*t8) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t7) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t10 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t8 + t6*t7) + t10*z2_2 + t9*z1_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8);
    const double t11 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t10 + t9*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t11) + z2_2*(-omega2*p1*sin_omega2_tau1 - t11*t7);
    /* functions of tau2 in stick-slip */
    const double t12 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t12);
    const double sin_omega3_tau2 = sin(t12);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t13 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t13 + tau2) + cos_omega3_tau2*z2_3 + t13*v2_3 + z1_3*(1 - cos_omega3_tau2);
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

/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.
 * Takes parameters (5), spectrum (7), unknowns (6); gives coefficients (44), frequencies (4), row by row.
 * Operations: 175. Intermediate terms: 45. */
void dry_friction_global_stick_boundary_functions(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double coefficients[44], double frequencies[4])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
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
    const double t5 = (1.0/(omega1));
    const double t6 = sin_omega1_tau1*t5;
    const double t7 = 1 - p1;
    const double t8 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + v1_2*(p1*t6 + t7*t8) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t7) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t10 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t8 + t6*t7) + t10*z2_2 + t9*z1_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8);
    const double t11 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t10 + t9*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t11) + z2_2*(-omega2*p1*sin_omega2_tau1 - t11*t7);
    /* outputs */
    const double t12 = chi*z20;
    const double t14 = V*chi;
    const double t15 = -V + t14;
    const double t18 = chi*z10;
    const double t19 = chi*z2_1;
    const double t20 = t19 - z1_1;
    const double t21 = (chi*chi);
    const double t22 = t21*z2_1;
    const double t23 = V*t21 - t14;
    const double t24 = -chi*t20;
    const double t25 = -chi*t15;
    const double t26 = V*p2;
    const double t27 = omega1*z1_2;
    const double t28 = p2*z2_2;
    const double t29 = p3*v1_2;
    const double t30 = chi*z1_3;
    const double t31 = chi*(-z1_3 + z2_3);
    const double t32 = (1.0/(omega3));
    const double t33 = chi*(-V*t32 + t32*v2_3);
    coefficients[0] = -e1 - t12 + z10;
    coefficients[1] = -t15;
    coefficients[2] = -e1 + t12 - z10;
    coefficients[3] = t15;
    coefficients[4] = -e2 + t12 - t18;
    coefficients[5] = 0;
    coefficients[6] = -e2 - t12 + t18;
    coefficients[7] = 0;
    coefficients[8] = t15;
    coefficients[9] = 0;
    coefficients[10] = -t15;
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
    coefficients[21] = 0;
    coefficients[22] = p1*v1_2 + t26;
    coefficients[23] = -t26 + t7*v1_2;
    coefficients[24] = -omega1*t28 - p1*t27;
    coefficients[25] = omega2*t28 - omega2*t7*z1_2;
    coefficients[26] = -V;
    coefficients[27] = 0;
    coefficients[28] = V*t7 + t29;
    coefficients[29] = V*p1 - t29;
    coefficients[30] = -omega1*t7*z2_2 - p3*t27;
    coefficients[31] = -omega2*p1*z2_2 + omega2*p3*z1_2;
    coefficients[32] = -e1 - t30 + z1_3;
    coefficients[33] = -t15;
    coefficients[34] = -t31;
    coefficients[35] = -t33;
    coefficients[36] = -e1 + t30 - z1_3;
    coefficients[37] = t15;
    coefficients[38] = t31;
    coefficients[39] = t33;
    coefficients[40] = 0;
    coefficients[41] = 0;
    coefficients[42] = -V + v2_3;
    coefficients[43] = omega3*z1_3 - omega3*z2_3;
    frequencies[0] = 1;
    frequencies[1] = omega1;
    frequencies[2] = omega2;
    frequencies[3] = omega3;
}

/* State after a time in stick-stick.
 * Takes parameters (5), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 4. Intermediate terms: 0. */
void dry_friction_global_stick_flow_stick_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    (void)spectrum;
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    state_after[0] = t*v1 + z1;
    state_after[1] = t*v2 + z2;
    state_after[2] = v1;
    state_after[3] = v2;
}

/* State after a time in slip-stick.
 * Takes parameters (5), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 23. Intermediate terms: 4. */
void dry_friction_global_stick_flow_slip_stick(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = sin(t);
    const double t1 = chi*t0;
    const double t2 = cos(t);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1);
    state_after[1] = t*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-slip.
 * Takes parameters (5), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 82. Intermediate terms: 16. */
void dry_friction_global_stick_flow_slip_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/(omega1));
    const double t1 = omega1*t;
    const double t2 = sin(t1);
    const double t3 = t0*t2;
    const double t4 = 1 - p1;
    const double t5 = omega2*t;
    const double t6 = sin(t5);
    const double t7 = t6/omega2;
    const double t8 = cos(t1);
    const double t9 = cos(t5);
    const double t10 = p1*t8 + t4*t9;
    const double t11 = p2*t8 - p2*t9;
    const double t12 = p3*t8 - p3*t9;
    const double t13 = p1*t9 + t4*t8;
    const double t14 = omega2*t6;
    const double t15 = omega1*t2;
    state_after[0] = t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7);
    state_after[1] = t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15);
    state_after[3] = t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4);
}

/* State after a time in stick-slip.
 * Takes parameters (5), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 23. Intermediate terms: 6. */
void dry_friction_global_stick_flow_stick_slip(
    const double parameters[5], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[6];
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega3*t;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = omega3*t1;
    state_after[0] = t*v1 + z1;
    state_after[1] = t2*v2 + t3*z2 + t4*z1 + v1*(t - t2);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*z1 - t5*z2;
}

/* Reduced equations and their derivatives by the reduced unknowns.
 * Takes parameters (5), spectrum (7), reduced (2); gives residual (2), jacobian (2, 2), row by row.
 * Operations: 197. Intermediate terms: 66. */
void dry_friction_global_stick_reduced(
    const double parameters[5], const double spectrum[7], const double reduced[2], double residual[2], double jacobian[4])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t2 = V*tau;
    const double t3 = (1.0/((chi - 1)));
    const double t4 = e1*t3;
    const double z2_1 = V*sin_tau - cos_tau*t4 - t2 - e2*t3/chi;
    /* slip-stick for tau */
    const double t5 = chi*z2_1;
    const double t6 = e1 + t5;
    const double t7 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t6 + t7*z2_1;
    const double z2_2 = t2 + z2_1;
    const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
    /* functions of tau1 in slip-slip */
    const double t8 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t8);
    const double sin_omega1_tau1 = sin(t8);
    const double t9 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t9);
    const double sin_omega2_tau1 = sin(t9);
    /* slip-slip for tau1 */
    const double t10 = (1.0/(omega1));
    const double t13 = sin_omega2_tau1/omega2;
    const double t11 = sin_omega1_tau1*t10;
    const double t12 = 1 - p1;
    const double t14 = p1*t11 + t12*t13;
    const double t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12;
    const double t16 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t10 - p2*t13) + t14*v1_2 + t15*z1_2 + t16*z2_2;
    const double t17 = p3*sin_omega1_tau1*t10 - p3*t13;
    const double t18 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t19 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t13 + t11*t12) + t17*v1_2 + t18*z1_2 + t19*z2_2;
    const double t20 = omega2*sin_omega2_tau1;
    const double t21 = omega1*sin_omega1_tau1;
    const double t22 = -p1*t21 - t12*t20;
    const double t23 = omega2*p2*sin_omega2_tau1 - p2*t21;
    const double v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2;
    const double t24 = omega2*p3*sin_omega2_tau1 - p3*t21;
    const double t25 = -p1*t20 - t12*t21;
    const double v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t26 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = V*sin_tau_by_tau - V - t26*t3;
    /* d/dtau of: slip-stick for tau */
    const double t27 = V*chi;
    const double t28 = V - t27;
    const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t28 + t26 + t27;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = cos_tau_by_tau*t28 - e1*sin_tau_by_tau;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau;
    const double z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau;
    const double v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau;
    const double v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t29 = chi*z2_3;
    const double v1_3_by_tau1 = t29 - z1_3;
    const double v2_3_by_tau1 = chi*eta*z1_3 - eta*t29;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/dtau of: first return of tau2 */
    const double t30 = 2*cosine_part_tau2;
    const double t31 = 2*sine_part_tau2;
    const double t32 = (1.0/2.0)/amplitude_tau2;
    const double amplitude_tau2_by_tau = t32*(sine_part_tau2_by_tau*t31 + t30*v2_3_by_tau);
    /* d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1 = t32*(sine_part_tau2_by_tau1*t31 + t30*v2_3_by_tau1);
    /* outputs */
    const double t33 = (1.0/(omega3));
    const double t34 = t3*t33;
    residual[0] = -V + v1_3;
    residual[1] = amplitude_tau2*t3*t33 - t4 - z2_1;
    jacobian[0] = v1_3_by_tau;
    jacobian[1] = v1_3_by_tau1;
    jacobian[2] = amplitude_tau2_by_tau*t34 - z2_1_by_tau;
    jacobian[3] = amplitude_tau2_by_tau1*t34;
}

/* All unknowns from the reduced ones.
 * Takes parameters (5), spectrum (7), reduced (2); gives unknowns (6), row by row.
 * Operations: 138. Intermediate terms: 40. */
void dry_friction_global_stick_expand(
    const double parameters[5], const double spectrum[7], const double reduced[2], double unknowns[6])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t0 = V*tau;
    const double t1 = (1.0/((chi - 1)));
    const double z2_1 = V*sin_tau - cos_tau*e1*t1 - t0 - e2*t1/chi;
    /* slip-stick for tau */
    const double t2 = chi*z2_1;
    const double t3 = e1 + t2;
    const double t4 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t3 + t4*z2_1;
    const double z2_2 = t0 + z2_1;
    const double v1_2 = V*cos_tau + V*t4 + sin_tau*t2 - sin_tau*t3;
    /* functions of tau1 in slip-slip */
    const double t5 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t5);
    const double sin_omega1_tau1 = sin(t5);
    const double t6 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t6);
    const double sin_omega2_tau1 = sin(t6);
    /* slip-slip for tau1 */
    const double t7 = (1.0/(omega1));
    const double t8 = sin_omega1_tau1*t7;
    const double t9 = 1 - p1;
    const double t10 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t7 - p2*t10) + v1_2*(p1*t8 + t10*t9) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t9) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t12 = cos_omega1_tau1*t9 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t10 + t8*t9) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t7 - p3*t10);
    const double t13 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-omega2*p1*sin_omega2_tau1 - t13*t9);
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* first return of tau2 */
    const double t14 = (1.0/(amplitude_tau2));
    const double cos_tau2_return = sine_part_tau2*t14;
    const double sin_tau2_return = -cosine_part_tau2*t14;
    /* tau2: first return */
    const double t15 = (1.0/(omega3));
    const double tau2 = t15*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
    /* ta: linear in time */
    const double t16 = sine_part_tau2*t15;
    const double t17 = V*tau2;
    const double t18 = amplitude_tau2*t15;
    const double ta = -t1*(chi*t16 + chi*t17 - chi*t18 + chi*z2_3 + e1 - t16 - t17 - z2_3)/V;
    /* outputs */
    const double t19 = t16 + t17 + z2_3;
    unknowns[0] = t19;
    unknowns[1] = -t18 + t19;
    unknowns[2] = ta;
    unknowns[3] = tau;
    unknowns[4] = tau1;
    unknowns[5] = tau2;
}

/* Compatibility and switching conditions, the start, and the map [N, c] of a turn, all from the unknowns but the start.
 * Takes parameters (5), spectrum (7), unknowns (6); gives residual (4), start (2), map (4, 5), row by row.
 * Operations: 266. Intermediate terms: 84. */
void dry_friction_global_stick_period_map(
    const double parameters[5], const double spectrum[7], const double unknowns[6], double residual[4], double start[2], double map[20])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e1 = parameters[3];
    const double e2 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double ta = unknowns[2];
    const double tau = unknowns[3];
    const double tau1 = unknowns[4];
    const double tau2 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick after tau, by the start */
    const double t0 = chi*cos_tau;
    const double z1_2_by_z20 = chi - t0;
    const double z1_2_by_v10 = cos_tau*ta + sin_tau;
    const double t2 = chi*sin_tau;
    const double z1_2_by_v20 = chi*tau - t2 + ta*z1_2_by_z20;
    const double z2_2_by_v20 = ta + tau;
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_z20 = t2;
    const double v1_2_by_v10 = cos_tau - sin_tau*ta;
    const double v1_2_by_v20 = chi - t0 + t2*ta;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t3);
    const double sin_omega1_tau1 = sin(t3);
    const double t4 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t4);
    const double sin_omega2_tau1 = sin(t4);
    /* slip-slip after tau1, by the start */
    const double t5 = 1 - p1;
    const double t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5;
    const double t7 = (1.0/(omega1));
    const double t8 = sin_omega1_tau1*t7;
    const double t9 = sin_omega2_tau1/omega2;
    const double t10 = p1*t8 + t5*t9;
    const double z1_3_by_z10 = cos_tau*t6 + t10*v1_2_by_z10;
    const double t11 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3_by_z20 = t10*v1_2_by_z20 + t11 + t6*z1_2_by_z20;
    const double z1_3_by_v10 = t10*v1_2_by_v10 + t6*z1_2_by_v10;
    const double z1_3_by_v20 = p2*t8 - p2*t9 + t10*v1_2_by_v20 + t11*z2_2_by_v20 + t6*z1_2_by_v20;
    const double t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t13 = p3*sin_omega1_tau1*t7 - p3*t9;
    const double z2_3_by_z10 = cos_tau*t12 + t13*v1_2_by_z10;
    const double t14 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1;
    const double z2_3_by_z20 = t12*z1_2_by_z20 + t13*v1_2_by_z20 + t14;
    const double z2_3_by_v10 = t12*z1_2_by_v10 + t13*v1_2_by_v10;
    const double z2_3_by_v20 = p1*t9 + t12*z1_2_by_v20 + t13*v1_2_by_v20 + t14*z2_2_by_v20 + t5*t8;
    const double t15 = omega2*sin_omega2_tau1;
    const double t16 = omega1*sin_omega1_tau1;
    const double t17 = -p1*t16 - t15*t5;
    const double v1_3_by_z10 = cos_tau*t17 + t6*v1_2_by_z10;
    const double t18 = p2*t16;
    const double v1_3_by_z20 = p2*t15 + t17*z1_2_by_z20 - t18 + t6*v1_2_by_z20;
    const double v1_3_by_v10 = t17*z1_2_by_v10 + t6*v1_2_by_v10;
    const double v1_3_by_v20 = t11 + t17*z1_2_by_v20 + t6*v1_2_by_v20 + z2_2_by_v20*(omega2*p2*sin_omega2_tau1 - t18);
    const double t19 = omega2*p3*sin_omega2_tau1 - p3*t16;
    const double v2_3_by_z10 = cos_tau*t19 + t12*v1_2_by_z10;
    const double t20 = p1*t15 + t16*t5;
    const double v2_3_by_z20 = t12*v1_2_by_z20 + t19*z1_2_by_z20 - t20;
    const double v2_3_by_v10 = t12*v1_2_by_v10 + t19*z1_2_by_v10;
    const double v2_3_by_v20 = t12*v1_2_by_v20 + t14 + t19*z1_2_by_v20 - t20*z2_2_by_v20;
    /* functions of tau2 in stick-slip */
    const double t21 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t21);
    const double sin_omega3_tau2 = sin(t21);
    /* stick-slip after tau2, by the start */
    const double z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10;
    const double z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20;
    const double z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10;
    const double z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20;
    const double t22 = sin_omega3_tau2/omega3;
    const double t23 = -t22 + tau2;
    const double t24 = 1 - cos_omega3_tau2;
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t22*v2_3_by_z10 + t23*v1_3_by_z10 + t24*z1_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t22*v2_3_by_z20 + t23*v1_3_by_z20 + t24*z1_3_by_z20;
    const double z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t22*v2_3_by_v10 + t23*v1_3_by_v10 + t24*z1_3_by_v10;
    const double z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t22*v2_3_by_v20 + t23*v1_3_by_v20 + t24*z1_3_by_v20;
    const double t25 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t24*v1_3_by_z10 + t25*z1_3_by_z10 - t25*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t24*v1_3_by_z20 + t25*z1_3_by_z20 - t25*z2_3_by_z20;
    const double v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t24*v1_3_by_v10 + t25*z1_3_by_v10 - t25*z2_3_by_v10;
    const double v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t24*v1_3_by_v20 + t25*z1_3_by_v20 - t25*z2_3_by_v20;
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
    const double t26 = (1.0/(determinant));
    const double z1_0 = numerator1*t26;
    const double z2_0 = numerator2*t26;
    /* stick-stick for ta, until first-breaks-forward */
    const double t27 = V*ta;
    const double z1_1 = t27 + z1_0;
    const double z2_1 = t27 + z2_0;
    /* slip-stick for tau, until second-breaks-forward */
    const double z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + z1_2_by_z20*z2_1;
    const double z2_2 = V*tau + z2_1;
    residual[0] = V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0;
    residual[1] = V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0;
    residual[2] = -chi*z2_1 - e1 + z1_1;
    residual[3] = -chi*z1_2 + chi*z2_2 - e2;
    start[0] = z1_0;
    start[1] = z2_0;
    map[0] = z1_4_by_z10;
    map[1] = z1_4_by_z20;
    map[2] = z1_4_by_v10;
    map[3] = z1_4_by_v20;
    map[4] = 0;
    map[5] = z2_4_by_z10;
    map[6] = z2_4_by_z20;
    map[7] = z2_4_by_v10;
    map[8] = z2_4_by_v20;
    map[9] = 0;
    map[10] = v1_3_by_z10;
    map[11] = v1_3_by_z20;
    map[12] = v1_3_by_v10;
    map[13] = v1_3_by_v20;
    map[14] = 0;
    map[15] = v2_4_by_z10;
    map[16] = v2_4_by_z20;
    map[17] = v2_4_by_v10;
    map[18] = v2_4_by_v20;
    map[19] = 0;
}

/* Switching and periodicity equations.
 * Takes parameters (4), spectrum (7), unknowns (6); gives residual (6), row by row.
 * Operations: 139. Intermediate terms: 36. */
void dry_friction_solution_ii_residual(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[6])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    const double e1 = unknowns[5];
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
    const double t4 = (1.0/(omega1));
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t7 = sin_omega2_tau1/omega2;
    const double t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t8*z1_2 + t9*z2_2 + v1_2*(p1*t5 + t6*t7);
    const double t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t11 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t10*z1_2 + t11*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7);
    const double t12 = omega2*sin_omega2_tau1;
    const double t13 = omega1*sin_omega1_tau1;
    const double v1_3 = V*t9 + t8*v1_2 + z1_2*(-p1*t13 - t12*t6) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t13);
    const double v2_3 = V*t11 + t10*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-p1*t12 - t13*t6);
    /* functions of tau2 in stick-slip */
    const double t14 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t14);
    const double sin_omega3_tau2 = sin(t14);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t15 = 1 - cos_omega3_tau2;
    const double t16 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t16 + tau2) + cos_omega3_tau2*z2_3 + t15*z1_3 + t16*v2_3;
    const double t17 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t15 + cos_omega3_tau2*v2_3 + t17*z1_3 - t17*z2_3;
    residual[0] = -chi*z20 - e1 + z10;
    residual[1] = -chi*z1_2 + chi*z2_2 - e2;
    residual[2] = -V + v1_3;
    residual[3] = -V + v2_4;
    residual[4] = -z10 + z1_4;
    residual[5] = -z20 + z2_4;
}

/* Derivatives of the equations by the unknowns.
 * Takes parameters (4), spectrum (7), unknowns (6); gives jacobian (6, 6), row by row.
 * Operations: 317. Intermediate terms: 94. */
void dry_friction_solution_ii_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double jacobian[36])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t3 = chi*cos_tau;
    const double t4 = chi - t3;
    const double t5 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t5) + cos_tau*z10 + t4*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t4 - sin_tau*z10 + t5*z20;
    /* functions of tau1 in slip-slip */
    const double t6 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t6);
    const double sin_omega1_tau1 = sin(t6);
    const double t9 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t9);
    const double sin_omega2_tau1 = sin(t9);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t12 = (1.0/(omega1));
    const double t15 = (1.0/(omega2));
    const double t16 = sin_omega2_tau1*t15;
    const double t13 = sin_omega1_tau1*t12;
    const double t14 = 1 - p1;
    const double t17 = p1*t13 + t14*t16;
    const double t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14;
    const double t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t12 - p2*t16) + t17*v1_2 + t18*z1_2 + t19*z2_2;
    const double t20 = p3*sin_omega1_tau1*t12 - p3*t16;
    const double t21 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t22 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t16 + t13*t14) + t20*v1_2 + t21*z1_2 + t22*z2_2;
    const double t23 = omega1*sin_omega1_tau1;
    const double t24 = omega2*p3*sin_omega2_tau1 - p3*t23;
    const double t25 = omega2*sin_omega2_tau1;
    const double t26 = p1*t25 + t14*t23;
    const double t28 = V*t22;
    const double v2_3 = t21*v1_2 + t24*z1_2 - t26*z2_2 + t28;
    /* functions of tau2 in stick-slip */
    const double t29 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t29);
    const double sin_omega3_tau2 = sin(t29);
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dz10 of: slip-stick for tau, until second-breaks-forward */
    const double v1_2_by_z10 = -sin_tau;
    /* d/dz20 of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_z20 = t4;
    const double v1_2_by_z20 = t5;
    /* d/dtau of: slip-stick for tau, until second-breaks-forward */
    const double t32 = chi*z20 - z10;
    const double t33 = V*chi;
    const double t34 = V - t33;
    const double z1_2_by_tau = -cos_tau_by_tau*t32 + sin_tau_by_tau*t34 + t33;
    const double v1_2_by_tau = cos_tau_by_tau*t34 + sin_tau_by_tau*t32;
    /* d/dtau1 of: functions of tau1 in slip-slip */
    const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
    const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
    const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
    const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
    /* d/dz10 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10;
    const double z2_3_by_z10 = cos_tau*t21 + t20*v1_2_by_z10;
    const double t35 = -p1*t23 - t14*t25;
    const double v1_3_by_z10 = cos_tau*t35 + t18*v1_2_by_z10;
    const double v2_3_by_z10 = cos_tau*t24 + t21*v1_2_by_z10;
    /* d/dz20 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19;
    const double z2_3_by_z20 = t20*v1_2_by_z20 + t21*z1_2_by_z20 + t22;
    const double t36 = p2*t23;
    const double v1_3_by_z20 = p2*t25 + t18*v1_2_by_z20 + t35*z1_2_by_z20 - t36;
    const double v2_3_by_z20 = t21*v1_2_by_z20 + t24*z1_2_by_z20 - t26;
    /* d/dtau of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_tau = V*t19 + t17*v1_2_by_tau + t18*z1_2_by_tau;
    const double z2_3_by_tau = t20*v1_2_by_tau + t21*z1_2_by_tau + t28;
    const double v1_3_by_tau = V*(omega2*p2*sin_omega2_tau1 - t36) + t18*v1_2_by_tau + t35*z1_2_by_tau;
    const double v2_3_by_tau = -V*t26 + t21*v1_2_by_tau + t24*z1_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1, until first-reaches-belt */
    const double t37 = p1*z1_2;
    const double t38 = p2*z2_2;
    const double t39 = p1*v1_2;
    const double t40 = V*p2;
    const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t37 + t38) + cos_omega2_tau1_by_tau1*(t14*z1_2 - t38) + sin_omega1_tau1_by_tau1*(t12*t39 + t12*t40) + sin_omega2_tau1_by_tau1*(t14*t15*v1_2 - t15*t40);
    const double t41 = p3*z1_2;
    const double t42 = t14*z2_2;
    const double t43 = p1*z2_2;
    const double t44 = p3*v1_2;
    const double t45 = V*t14;
    const double t46 = V*p1;
    const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t41 + t42) + cos_omega2_tau1_by_tau1*(-t41 + t43) + sin_omega1_tau1_by_tau1*(t12*t44 + t12*t45) + sin_omega2_tau1_by_tau1*(-t15*t44 + t15*t46);
    const double v1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t39 + t40) + cos_omega2_tau1_by_tau1*(t14*v1_2 - t40) + sin_omega1_tau1_by_tau1*(-omega1*t37 - omega1*t38) + sin_omega2_tau1_by_tau1*(-omega2*t14*z1_2 + omega2*t38);
    const double v2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t44 + t45) + cos_omega2_tau1_by_tau1*(-t44 + t46) + sin_omega1_tau1_by_tau1*(-omega1*t41 - omega1*t42) + sin_omega2_tau1_by_tau1*(omega2*p3*z1_2 - omega2*t43);
    /* d/dtau2 of: functions of tau2 in stick-slip */
    const double cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2;
    const double sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3;
    /* d/dz10 of: stick-slip for tau2, until second-reaches-belt */
    const double t47 = 1 - cos_omega3_tau2;
    const double t48 = (1.0/(omega3));
    const double t49 = sin_omega3_tau2*t48;
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t47*z1_3_by_z10 + t49*v2_3_by_z10;
    const double t50 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t50*z1_3_by_z10 - t50*z2_3_by_z10;
    /* d/dz20 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t47*z1_3_by_z20 + t49*v2_3_by_z20;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t50*z1_3_by_z20 - t50*z2_3_by_z20;
    /* d/dtau of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t47*z1_3_by_tau + t49*v2_3_by_tau;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t50*z1_3_by_tau - t50*z2_3_by_tau;
    /* d/dtau1 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t47*z1_3_by_tau1 + t49*v2_3_by_tau1;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t50*z1_3_by_tau1 - t50*z2_3_by_tau1;
    /* d/dtau2 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*(-z1_3 + z2_3) + sin_omega3_tau2_by_tau2*(-V*t48 + t48*v2_3);
    const double v2_4_by_tau2 = cos_omega3_tau2_by_tau2*(-V + v2_3) + sin_omega3_tau2_by_tau2*(omega3*z1_3 - omega3*z2_3);
    jacobian[0] = 1;
    jacobian[1] = -chi;
    jacobian[2] = 0;
    jacobian[3] = 0;
    jacobian[4] = 0;
    jacobian[5] = -1;
    jacobian[6] = -t3;
    jacobian[7] = -chi*z1_2_by_z20 + chi;
    jacobian[8] = -chi*z1_2_by_tau + t33;
    jacobian[9] = 0;
    jacobian[10] = 0;
    jacobian[11] = 0;
    jacobian[12] = v1_3_by_z10;
    jacobian[13] = v1_3_by_z20;
    jacobian[14] = v1_3_by_tau;
    jacobian[15] = v1_3_by_tau1;
    jacobian[16] = 0;
    jacobian[17] = 0;
    jacobian[18] = v2_4_by_z10;
    jacobian[19] = v2_4_by_z20;
    jacobian[20] = v2_4_by_tau;
    jacobian[21] = v2_4_by_tau1;
    jacobian[22] = v2_4_by_tau2;
    jacobian[23] = 0;
    jacobian[24] = z1_3_by_z10 - 1;
    jacobian[25] = z1_3_by_z20;
    jacobian[26] = z1_3_by_tau;
    jacobian[27] = z1_3_by_tau1;
    jacobian[28] = V;
    jacobian[29] = 0;
    jacobian[30] = z2_4_by_z10;
    jacobian[31] = z2_4_by_z20 - 1;
    jacobian[32] = z2_4_by_tau;
    jacobian[33] = z2_4_by_tau1;
    jacobian[34] = z2_4_by_tau2;
    jacobian[35] = 0;
}

/* Equations and their derivatives by the unknowns, sharing all intermediate terms.
 * Takes parameters (4), spectrum (7), unknowns (6); gives residual (6), jacobian (6, 6), row by row.
 * Operations: 350. Intermediate terms: 102. */
void dry_friction_solution_ii_residual_and_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[6], double jacobian[36])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    const double e1 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t3 = chi*cos_tau;
    const double t4 = chi - t3;
    const double t5 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t5) + cos_tau*z10 + t4*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t4 - sin_tau*z10 + t5*z20;
    /* functions of tau1 in slip-slip */
    const double t6 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t6);
    const double sin_omega1_tau1 = sin(t6);
    const double t9 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t9);
    const double sin_omega2_tau1 = sin(t9);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t12 = (1.0/(omega1));
    const double t15 = (1.0/(omega2));
    const double t16 = sin_omega2_tau1*t15;
    const double t13 = sin_omega1_tau1*t12;
    const double t14 = 1 - p1;
    const double t17 = p1*t13 + t14*t16;
    const double t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14;
    const double t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t12 - p2*t16) + t17*v1_2 + t18*z1_2 + t19*z2_2;
    const double t20 = p3*sin_omega1_tau1*t12 - p3*t16;
    const double t21 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t22 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t16 + t13*t14) + t20*v1_2 + t21*z1_2 + t22*z2_2;
    const double t23 = omega2*sin_omega2_tau1;
    const double t24 = omega1*sin_omega1_tau1;
    const double t25 = -p1*t24 - t14*t23;
    const double t26 = p2*t24;
    const double t27 = omega2*p2*sin_omega2_tau1 - t26;
    const double t28 = V*t19;
    const double v1_3 = t18*v1_2 + t25*z1_2 + t27*z2_2 + t28;
    const double t29 = omega2*p3*sin_omega2_tau1 - p3*t24;
    const double t30 = p1*t23 + t14*t24;
    const double t32 = V*t22;
    const double v2_3 = t21*v1_2 + t29*z1_2 - t30*z2_2 + t32;
    /* functions of tau2 in stick-slip */
    const double t33 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t33);
    const double sin_omega3_tau2 = sin(t33);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t36 = 1 - cos_omega3_tau2;
    const double t37 = (1.0/(omega3));
    const double t38 = sin_omega3_tau2*t37;
    const double z2_4 = V*(-t38 + tau2) + cos_omega3_tau2*z2_3 + t36*z1_3 + t38*v2_3;
    const double t39 = omega3*z1_3;
    const double t40 = omega3*z2_3;
    const double v2_4 = V*t36 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t39 - sin_omega3_tau2*t40;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dz10 of: slip-stick for tau, until second-breaks-forward */
    const double v1_2_by_z10 = -sin_tau;
    /* d/dz20 of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_z20 = t4;
    const double v1_2_by_z20 = t5;
    /* d/dtau of: slip-stick for tau, until second-breaks-forward */
    const double t41 = chi*z20 - z10;
    const double t42 = V*chi;
    const double t43 = V - t42;
    const double z1_2_by_tau = -cos_tau_by_tau*t41 + sin_tau_by_tau*t43 + t42;
    const double v1_2_by_tau = cos_tau_by_tau*t43 + sin_tau_by_tau*t41;
    /* d/dtau1 of: functions of tau1 in slip-slip */
    const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
    const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
    const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
    const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
    /* d/dz10 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10;
    const double z2_3_by_z10 = cos_tau*t21 + t20*v1_2_by_z10;
    const double v1_3_by_z10 = cos_tau*t25 + t18*v1_2_by_z10;
    const double v2_3_by_z10 = cos_tau*t29 + t21*v1_2_by_z10;
    /* d/dz20 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19;
    const double z2_3_by_z20 = t20*v1_2_by_z20 + t21*z1_2_by_z20 + t22;
    const double v1_3_by_z20 = p2*t23 + t18*v1_2_by_z20 + t25*z1_2_by_z20 - t26;
    const double v2_3_by_z20 = t21*v1_2_by_z20 + t29*z1_2_by_z20 - t30;
    /* d/dtau of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t28;
    const double z2_3_by_tau = t20*v1_2_by_tau + t21*z1_2_by_tau + t32;
    const double v1_3_by_tau = V*t27 + t18*v1_2_by_tau + t25*z1_2_by_tau;
    const double v2_3_by_tau = -V*t30 + t21*v1_2_by_tau + t29*z1_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1, until first-reaches-belt */
    const double t44 = p1*z1_2;
    const double t45 = p2*z2_2;
    const double t46 = p1*v1_2;
    const double t47 = V*p2;
    const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t44 + t45) + cos_omega2_tau1_by_tau1*(t14*z1_2 - t45) + sin_omega1_tau1_by_tau1*(t12*t46 + t12*t47) + sin_omega2_tau1_by_tau1*(t14*t15*v1_2 - t15*t47);
    const double t48 = p3*z1_2;
    const double t49 = t14*z2_2;
    const double t50 = p1*z2_2;
    const double t51 = p3*v1_2;
    const double t52 = V*t14;
    const double t53 = V*p1;
    const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t48 + t49) + cos_omega2_tau1_by_tau1*(-t48 + t50) + sin_omega1_tau1_by_tau1*(t12*t51 + t12*t52) + sin_omega2_tau1_by_tau1*(-t15*t51 + t15*t53);
    const double v1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t46 + t47) + cos_omega2_tau1_by_tau1*(t14*v1_2 - t47) + sin_omega1_tau1_by_tau1*(-omega1*t44 - omega1*t45) + sin_omega2_tau1_by_tau1*(-omega2*t14*z1_2 + omega2*t45);
    const double v2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t51 + t52) + cos_omega2_tau1_by_tau1*(-t51 + t53) + sin_omega1_tau1_by_tau1*(-omega1*t48 - omega1*t49) + sin_omega2_tau1_by_tau1*(omega2*p3*z1_2 - omega2*t50);
    /* d/dtau2 of: functions of tau2 in stick-slip */
    const double cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2;
    const double sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3;
    /* d/dz10 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t36*z1_3_by_z10 + t38*v2_3_by_z10;
    const double t54 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t54*z1_3_by_z10 - t54*z2_3_by_z10;
    /* d/dz20 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t36*z1_3_by_z20 + t38*v2_3_by_z20;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t54*z1_3_by_z20 - t54*z2_3_by_z20;
    /* d/dtau of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t36*z1_3_by_tau + t38*v2_3_by_tau;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t54*z1_3_by_tau - t54*z2_3_by_tau;
    /* d/dtau1 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t36*z1_3_by_tau1 + t38*v2_3_by_tau1;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t54*z1_3_by_tau1 - t54*z2_3_by_tau1;
    /* d/dtau2 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*(-z1_3 + z2_3) + sin_omega3_tau2_by_tau2*(-V*t37 + t37*v2_3);
    const double v2_4_by_tau2 = cos_omega3_tau2_by_tau2*(-V + v2_3) + sin_omega3_tau2_by_tau2*(t39 - t40);
    residual[0] = -e1 - t41;
    residual[1] = -chi*z1_2 + chi*z2_2 - e2;
    residual[2] = -V + v1_3;
    residual[3] = -V + v2_4;
    residual[4] = -z10 + z1_4;
    residual[5] = -z20 + z2_4;
    jacobian[0] = 1;
    jacobian[1] = -chi;
    jacobian[2] = 0;
    jacobian[3] = 0;
    jacobian[4] = 0;
    jacobian[5] = -1;
    jacobian[6] = -t3;
    jacobian[7] = -chi*z1_2_by_z20 + chi;
    jacobian[8] = -chi*z1_2_by_tau + t42;
    jacobian[9] = 0;
    jacobian[10] = 0;
    jacobian[11] = 0;
    jacobian[12] = v1_3_by_z10;
    jacobian[13] = v1_3_by_z20;
    jacobian[14] = v1_3_by_tau;
    jacobian[15] = v1_3_by_tau1;
    jacobian[16] = 0;
    jacobian[17] = 0;
    jacobian[18] = v2_4_by_z10;
    jacobian[19] = v2_4_by_z20;
    jacobian[20] = v2_4_by_tau;
    jacobian[21] = v2_4_by_tau1;
    jacobian[22] = v2_4_by_tau2;
    jacobian[23] = 0;
    jacobian[24] = z1_3_by_z10 - 1;
    jacobian[25] = z1_3_by_z20;
    jacobian[26] = z1_3_by_tau;
    jacobian[27] = z1_3_by_tau1;
    jacobian[28] = V;
    jacobian[29] = 0;
    jacobian[30] = z2_4_by_z10;
    jacobian[31] = z2_4_by_z20 - 1;
    jacobian[32] = z2_4_by_tau;
    jacobian[33] = z2_4_by_tau1;
    jacobian[34] = z2_4_by_tau2;
    jacobian[35] = 0;
}

/* Total derivatives of the equations by the parameters, through the spectrum too.
 * Takes parameters (4), spectrum (7), spectrum_derivatives (7, 2), unknowns (6); gives parameter_jacobian (6, 4), row by row.
 * Operations: 498. Intermediate terms: 139. */
void dry_friction_solution_ii_parameter_jacobian(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double parameter_jacobian[24])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double omega3_by_chi = spectrum_derivatives[12];
    const double omega3_by_eta = spectrum_derivatives[13];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t0 = chi*cos_tau;
    const double t1 = chi - t0;
    const double t2 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z10 + t1*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t1 - sin_tau*z10 + t2*z20;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t3);
    const double sin_omega1_tau1 = sin(t3);
    const double t6 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t6);
    const double sin_omega2_tau1 = sin(t6);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t9 = (1.0/(omega1));
    const double t10 = sin_omega1_tau1*t9;
    const double t11 = 1 - p1;
    const double t12 = (1.0/(omega2));
    const double t13 = sin_omega2_tau1*t12;
    const double t14 = p1*t10 + t11*t13;
    const double t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11;
    const double t16 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t17 = p2*t13;
    const double z1_3 = V*(p2*sin_omega1_tau1*t9 - t17) + t14*v1_2 + t15*z1_2 + t16*z2_2;
    const double t18 = p3*sin_omega1_tau1*t9 - p3*t13;
    const double t19 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t20 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1;
    const double t21 = p1*t13 + t10*t11;
    const double z2_3 = V*t21 + t18*v1_2 + t19*z1_2 + t20*z2_2;
    const double t22 = omega1*sin_omega1_tau1;
    const double t23 = omega2*p3*sin_omega2_tau1 - p3*t22;
    const double t24 = omega2*sin_omega2_tau1;
    const double t25 = -p1*t24 - t11*t22;
    const double v2_3 = V*t20 + t19*v1_2 + t23*z1_2 + t25*z2_2;
    /* functions of tau2 in stick-slip */
    const double t26 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t26);
    const double sin_omega3_tau2 = sin(t26);
    /* d/dchi of: slip-stick for tau, until second-breaks-forward */
    const double t29 = 1 - cos_tau;
    const double z1_2_by_chi = V*(-sin_tau + tau) + t29*z20;
    const double v1_2_by_chi = V*t29 + sin_tau*z20;
    /* d/dV of: slip-stick for tau, until second-breaks-forward */
    const double t30 = chi*tau;
    const double z1_2_by_V = sin_tau - t2 + t30;
    const double v1_2_by_V = chi + cos_tau - t0;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t31 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t31;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t31;
    const double t32 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t32;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t32;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t33 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t33;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t33;
    const double t34 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t34;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t34;
    /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
    const double t35 = p1*z1_2;
    const double t36 = p2*z2_2;
    const double t37 = t35 + t36;
    const double t38 = t11*z1_2 - t36;
    const double t39 = p1*v1_2;
    const double t40 = sin_omega1_tau1/(omega1*omega1);
    const double t41 = V*p2;
    const double t42 = -t39*t40 - t40*t41;
    const double t43 = (1.0/(omega2*omega2));
    const double t44 = sin_omega2_tau1*t43;
    const double t45 = -t11*t44*v1_2 + t41*t44;
    const double t46 = -sin_omega1_tau1*t9 + t13;
    const double t48 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t49 = -t46*v1_2 + t48*z1_2;
    const double t50 = -V*t46 + t48*z2_2;
    const double t51 = t39*t9 + t41*t9;
    const double t52 = t11*t12*v1_2 - t12*t41;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t37 + cos_omega2_tau1_by_chi*t38 + omega1_by_chi*t42 + omega2_by_chi*t45 + p1_by_chi*t49 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t51 + sin_omega2_tau1_by_chi*t52 + t14*v1_2_by_chi + t15*z1_2_by_chi;
    const double t53 = p3*z1_2;
    const double t54 = t11*z2_2;
    const double t55 = t53 + t54;
    const double t56 = p1*z2_2;
    const double t57 = -t53 + t56;
    const double t58 = p3*v1_2;
    const double t59 = V*t11;
    const double t60 = -t40*t58 - t40*t59;
    const double t61 = V*p1;
    const double t62 = p3*sin_omega2_tau1*t43*v1_2 - t44*t61;
    const double t64 = V*t46 - t48*z2_2;
    const double t65 = t58*t9 + t59*t9;
    const double t66 = -t12*t58 + t12*t61;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t55 + cos_omega2_tau1_by_chi*t57 + omega1_by_chi*t60 + omega2_by_chi*t62 + p1_by_chi*t64 + p3_by_chi*t49 + sin_omega1_tau1_by_chi*t65 + sin_omega2_tau1_by_chi*t66 + t18*v1_2_by_chi + t19*z1_2_by_chi;
    const double t67 = t39 + t41;
    const double t68 = t11*v1_2 - t41;
    const double t69 = -sin_omega1_tau1*t35 - sin_omega1_tau1*t36;
    const double t70 = t11*z1_2;
    const double t71 = sin_omega2_tau1*t36 - sin_omega2_tau1*t70;
    const double t72 = -omega2*sin_omega2_tau1 + t22;
    const double t74 = t48*v1_2 - t72*z1_2;
    const double t75 = V*t48 - t72*z2_2;
    const double t76 = -omega1*t35 - omega1*t36;
    const double t77 = omega2*t36 - omega2*t70;
    const double t78 = -p1*t22 - t11*t24;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t67 + cos_omega2_tau1_by_chi*t68 + omega1_by_chi*t69 + omega2_by_chi*t71 + p1_by_chi*t74 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t76 + sin_omega2_tau1_by_chi*t77 + t15*v1_2_by_chi + t78*z1_2_by_chi;
    const double t79 = t58 + t59;
    const double t80 = -t58 + t61;
    const double t81 = -sin_omega1_tau1*t53 - sin_omega1_tau1*t54;
    const double t82 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t56;
    const double t83 = -V*t48 + t72*z2_2;
    const double t84 = -omega1*t53 - omega1*t54;
    const double t85 = omega2*p3*z1_2 - omega2*t56;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t80 + omega1_by_chi*t81 + omega2_by_chi*t82 + p1_by_chi*t83 + p3_by_chi*t74 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t85 + t19*v1_2_by_chi + t23*z1_2_by_chi;
    /* d/deta of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t37 + cos_omega2_tau1_by_eta*t38 + omega1_by_eta*t42 + omega2_by_eta*t45 + p1_by_eta*t49 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t51 + sin_omega2_tau1_by_eta*t52;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t55 + cos_omega2_tau1_by_eta*t57 + omega1_by_eta*t60 + omega2_by_eta*t62 + p1_by_eta*t64 + p3_by_eta*t49 + sin_omega1_tau1_by_eta*t65 + sin_omega2_tau1_by_eta*t66;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t67 + cos_omega2_tau1_by_eta*t68 + omega1_by_eta*t69 + omega2_by_eta*t71 + p1_by_eta*t74 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t76 + sin_omega2_tau1_by_eta*t77;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t80 + omega1_by_eta*t81 + omega2_by_eta*t82 + p1_by_eta*t83 + p3_by_eta*t74 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t85;
    /* d/dV of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_V = p2*t10 + t14*v1_2_by_V + t15*z1_2_by_V + t16*tau - t17;
    const double z2_3_by_V = t18*v1_2_by_V + t19*z1_2_by_V + t20*tau + t21;
    const double v1_3_by_V = t15*v1_2_by_V + t16 + t78*z1_2_by_V + tau*(omega2*p2*sin_omega2_tau1 - p2*t22);
    const double v2_3_by_V = t19*v1_2_by_V + t20 + t23*z1_2_by_V + t25*tau;
    /* d/dchi of: functions of tau2 in stick-slip */
    const double t86 = omega3_by_chi*tau2;
    const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t86;
    const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t86;
    /* d/deta of: functions of tau2 in stick-slip */
    const double t87 = omega3_by_eta*tau2;
    const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t87;
    const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t87;
    /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
    const double t88 = -z1_3 + z2_3;
    const double t89 = sin_omega3_tau2/(omega3*omega3);
    const double t90 = V*t89 - t89*v2_3;
    const double t91 = (1.0/(omega3));
    const double t92 = -V*t91 + t91*v2_3;
    const double t93 = 1 - cos_omega3_tau2;
    const double t94 = sin_omega3_tau2*t91;
    const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t88 + omega3_by_chi*t90 + sin_omega3_tau2_by_chi*t92 + t93*z1_3_by_chi + t94*v2_3_by_chi;
    const double t95 = -V + v2_3;
    const double t96 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3;
    const double t97 = omega3*z1_3 - omega3*z2_3;
    const double t98 = omega3*sin_omega3_tau2;
    const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t95 + omega3_by_chi*t96 + sin_omega3_tau2_by_chi*t97 + t98*z1_3_by_chi - t98*z2_3_by_chi;
    /* d/deta of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t88 + omega3_by_eta*t90 + sin_omega3_tau2_by_eta*t92 + t93*z1_3_by_eta + t94*v2_3_by_eta;
    const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t95 + omega3_by_eta*t96 + sin_omega3_tau2_by_eta*t97 + t98*z1_3_by_eta - t98*z2_3_by_eta;
    /* d/dV of: stick-slip for tau2, until second-reaches-belt */
    const double z1_4_by_V = tau2 + z1_3_by_V;
    const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t93*z1_3_by_V + t94*v2_3_by_V - t94 + tau2;
    const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t98*z1_3_by_V - t98*z2_3_by_V + 1;
    parameter_jacobian[0] = -z20;
    parameter_jacobian[1] = 0;
    parameter_jacobian[2] = 0;
    parameter_jacobian[3] = 0;
    parameter_jacobian[4] = -chi*z1_2_by_chi - z1_2 + z2_2;
    parameter_jacobian[5] = 0;
    parameter_jacobian[6] = -chi*z1_2_by_V + t30;
    parameter_jacobian[7] = -1;
    parameter_jacobian[8] = v1_3_by_chi;
    parameter_jacobian[9] = v1_3_by_eta;
    parameter_jacobian[10] = v1_3_by_V - 1;
    parameter_jacobian[11] = 0;
    parameter_jacobian[12] = v2_4_by_chi;
    parameter_jacobian[13] = v2_4_by_eta;
    parameter_jacobian[14] = v2_4_by_V - 1;
    parameter_jacobian[15] = 0;
    parameter_jacobian[16] = z1_3_by_chi;
    parameter_jacobian[17] = z1_3_by_eta;
    parameter_jacobian[18] = z1_4_by_V;
    parameter_jacobian[19] = 0;
    parameter_jacobian[20] = z2_4_by_chi;
    parameter_jacobian[21] = z2_4_by_eta;
    parameter_jacobian[22] = z2_4_by_V;
    parameter_jacobian[23] = 0;
}

/* Jacobian of the Poincare map in the section's coordinates.
 * Takes parameters (4), spectrum (7), unknowns (6); gives poincare_jacobian (2, 2), row by row.
 * Operations: 273. Intermediate terms: 100. */
void dry_friction_solution_ii_poincare_jacobian(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double poincare_jacobian[4])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
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
    const double t4 = (1.0/(omega1));
    const double t7 = sin_omega2_tau1/omega2;
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t8 = p1*t5 + t6*t7;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t10*z2_2 + t8*v1_2 + t9*z1_2;
    const double t11 = p3*sin_omega1_tau1*t4 - p3*t7;
    const double t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t13 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t11*v1_2 + t12*z1_2 + t13*z2_2;
    const double t14 = omega2*sin_omega2_tau1;
    const double t15 = omega1*sin_omega1_tau1;
    const double t16 = -p1*t15 - t14*t6;
    const double t17 = omega2*p2*sin_omega2_tau1 - p2*t15;
    const double v1_3 = V*t10 + t16*z1_2 + t17*z2_2 + t9*v1_2;
    const double t18 = omega2*p3*sin_omega2_tau1 - p3*t15;
    const double t19 = -p1*t14 - t15*t6;
    const double v2_3 = V*t13 + t12*v1_2 + t18*z1_2 + t19*z2_2;
    /* functions of tau2 in stick-slip */
    const double t20 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t20);
    const double sin_omega3_tau2 = sin(t20);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t21 = 1 - cos_omega3_tau2;
    const double t22 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t22 + tau2) + cos_omega3_tau2*z2_3 + t21*z1_3 + t22*v2_3;
    const double t23 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t21 + cos_omega3_tau2*v2_3 + t23*z1_3 - t23*z2_3;
    /* rate of the exit boundary after ta */
    const double t24 = V*chi;
    const double rate_1 = V - t24;
    /* derivatives of the time to the boundary after ta */
    const double t25 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t25;
    const double delay_ta_by_z20 = chi*t25;
    /* perturbation on the boundary after ta */
    const double t26 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = t26 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z10 = t26;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t0*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t0*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t24;
    /* derivatives of the time to the boundary after tau */
    const double t28 = (1.0/(rate_2));
    const double delay_tau_by_z10 = t28*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20 = t28*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t29 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t29;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t29;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t10*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10 + t9*z1_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t10*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20 + t9*z1_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t16*z1_2_on_boundary_by_z10 + t17*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t16*z1_2_on_boundary_by_z20 + t17*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t30 = chi*z2_3;
    const double rate_3 = t30 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t31 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t31;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t31;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t32 = chi*eta;
    const double t33 = -eta*t30 + t32*z1_3;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t33;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t33;
    /* Phi along tau2 */
    const double carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t21*z1_3_on_boundary_by_z10 + t22*v2_3_on_boundary_by_z10;
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t21*z1_3_on_boundary_by_z20 + t22*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t23*z1_3_on_boundary_by_z10 - t23*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t23*z1_3_on_boundary_by_z20 - t23*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t32*z1_4 - t32*z2_4;
    /* derivatives of the time to the boundary after tau2 */
    const double t34 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t34;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t34;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20;
    const double z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    poincare_jacobian[0] = z1_4_on_boundary_by_z10;
    poincare_jacobian[1] = z1_4_on_boundary_by_z20;
    poincare_jacobian[2] = z2_4_on_boundary_by_z10;
    poincare_jacobian[3] = z2_4_on_boundary_by_z20;
}

/* Saltation matrices of the transitions, one below the other.
 * Takes parameters (4), spectrum (7), unknowns (6); gives saltations (16, 4), row by row.
 * Operations: 164. Intermediate terms: 53. */
void dry_friction_solution_ii_saltations(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double saltations[64])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
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
    const double t4 = (1.0/(omega1));
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t7 = sin_omega2_tau1/omega2;
    const double t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t8*z1_2 + t9*z2_2 + v1_2*(p1*t5 + t6*t7);
    const double t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t11 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t10*z1_2 + t11*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7);
    const double t12 = omega2*sin_omega2_tau1;
    const double t13 = omega1*sin_omega1_tau1;
    const double v1_3 = V*t9 + t8*v1_2 + z1_2*(-p1*t13 - t12*t6) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t13);
    const double v2_3 = V*t11 + t10*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-p1*t12 - t13*t6);
    /* functions of tau2 in stick-slip */
    const double t14 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t14);
    const double sin_omega3_tau2 = sin(t14);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t15 = 1 - cos_omega3_tau2;
    const double t16 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t16 + tau2) + cos_omega3_tau2*z2_3 + t15*z1_3 + t16*v2_3;
    const double t17 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t15 + cos_omega3_tau2*v2_3 + t17*z1_3 - t17*z2_3;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z20 - z10;
    /* vector fields at transition 2 */
    const double t18 = chi*z2_2;
    const double before_v1_2 = t18 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double t20 = chi*eta;
    const double behind_v2_2 = -eta*t18 + t20*z1_2;
    /* vector fields at transition 3 */
    const double t21 = chi*z2_3;
    const double before_v1_3 = t21 - z1_3;
    const double before_v2_3 = -eta*t21 + t20*z1_3;
    const double behind_v2_3 = before_v2_3;
    /* vector fields at transition 4 */
    const double before_v2_4 = t20*z1_4 - t20*z2_4;
    /* outputs */
    const double t23 = V*chi;
    const double t24 = behind_v1_1/(V - t23);
    const double t25 = chi/(-chi*v1_2 + t23);
    const double t26 = t25*(-before_v1_2 + behind_v1_2);
    const double t27 = behind_v2_2*t25;
    const double t28 = (1.0/(before_v1_3));
    saltations[0] = 1;
    saltations[1] = 0;
    saltations[2] = 0;
    saltations[3] = 0;
    saltations[4] = 0;
    saltations[5] = 1;
    saltations[6] = 0;
    saltations[7] = 0;
    saltations[8] = t24;
    saltations[9] = -chi*t24;
    saltations[10] = 1;
    saltations[11] = 0;
    saltations[12] = 0;
    saltations[13] = 0;
    saltations[14] = 0;
    saltations[15] = 1;
    saltations[16] = 1;
    saltations[17] = 0;
    saltations[18] = 0;
    saltations[19] = 0;
    saltations[20] = 0;
    saltations[21] = 1;
    saltations[22] = 0;
    saltations[23] = 0;
    saltations[24] = -t26;
    saltations[25] = t26;
    saltations[26] = 1;
    saltations[27] = 0;
    saltations[28] = -t27;
    saltations[29] = t27;
    saltations[30] = 0;
    saltations[31] = 1;
    saltations[32] = 1;
    saltations[33] = 0;
    saltations[34] = t28*(V - v1_3);
    saltations[35] = 0;
    saltations[36] = 0;
    saltations[37] = 1;
    saltations[38] = 0;
    saltations[39] = 0;
    saltations[40] = 0;
    saltations[41] = 0;
    saltations[42] = 0;
    saltations[43] = 0;
    saltations[44] = 0;
    saltations[45] = 0;
    saltations[46] = t28*(-before_v2_3 + behind_v2_3);
    saltations[47] = 1;
    saltations[48] = 1;
    saltations[49] = 0;
    saltations[50] = 0;
    saltations[51] = 0;
    saltations[52] = 0;
    saltations[53] = 1;
    saltations[54] = 0;
    saltations[55] = (V - v2_4)/before_v2_4;
    saltations[56] = 0;
    saltations[57] = 0;
    saltations[58] = 1;
    saltations[59] = 0;
    saltations[60] = 0;
    saltations[61] = 0;
    saltations[62] = 0;
    saltations[63] = 0;
}

/* Monodromy matrix: the product of flows and saltation matrices over a period.
 * Takes parameters (4), spectrum (7), unknowns (6); gives monodromy (4, 4), row by row.
 * Operations: 357. Intermediate terms: 125. */
void dry_friction_solution_ii_monodromy(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double monodromy[16])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
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
    const double cos_omega1_tau1 = cos(t4);
    const double sin_omega1_tau1 = sin(t4);
    const double t5 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t5);
    const double sin_omega2_tau1 = sin(t5);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t6 = (1.0/(omega1));
    const double t7 = sin_omega1_tau1*t6;
    const double t8 = 1 - p1;
    const double t9 = sin_omega2_tau1/omega2;
    const double t10 = p1*t7 + t8*t9;
    const double t11 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8;
    const double t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t13 = p2*sin_omega1_tau1*t6 - p2*t9;
    const double z1_3 = V*t13 + t10*v1_2 + t11*z1_2 + t12*z2_2;
    const double t14 = p3*sin_omega1_tau1*t6 - p3*t9;
    const double t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t16 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1;
    const double t17 = p1*t9 + t7*t8;
    const double z2_3 = V*t17 + t14*v1_2 + t15*z1_2 + t16*z2_2;
    const double t18 = omega2*sin_omega2_tau1;
    const double t19 = omega1*sin_omega1_tau1;
    const double t20 = -p1*t19 - t18*t8;
    const double t21 = p2*t19;
    const double t22 = omega2*p2*sin_omega2_tau1 - t21;
    const double v1_3 = V*t12 + t11*v1_2 + t20*z1_2 + t22*z2_2;
    const double t23 = omega2*p3*sin_omega2_tau1 - p3*t19;
    const double t24 = p1*t18;
    const double t25 = t19*t8;
    const double t26 = -t24 - t25;
    const double v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t26*z2_2;
    /* functions of tau2 in stick-slip */
    const double t27 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t27);
    const double sin_omega3_tau2 = sin(t27);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t28 = 1 - cos_omega3_tau2;
    const double t29 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t29 + tau2) + cos_omega3_tau2*z2_3 + t28*z1_3 + t29*v2_3;
    const double t30 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t28 + cos_omega3_tau2*v2_3 + t30*z1_3 - t30*z2_3;
    /* vector fields at transition 1 */
    const double behind_v1_1 = chi*z20 - z10;
    /* vector fields at transition 2 */
    const double t31 = chi*z2_2;
    const double before_v1_2 = t31 - z1_2;
    const double behind_v1_2 = before_v1_2;
    const double t33 = chi*eta;
    const double behind_v2_2 = -eta*t31 + t33*z1_2;
    /* vector fields at transition 3 */
    const double t34 = chi*z2_3;
    const double before_v1_3 = t34 - z1_3;
    const double before_v2_3 = -eta*t34 + t33*z1_3;
    const double behind_v2_3 = before_v2_3;
    /* vector fields at transition 4 */
    const double before_v2_4 = t33*z1_4 - t33*z2_4;
    /* saltation of phase 1 */
    const double t36 = V*chi;
    const double saltation_1_20 = behind_v1_1/(V - t36);
    const double saltation_1_21 = -chi*saltation_1_20;
    /* Phi of phase 2 */
    const double phi_2_00 = cos_tau + saltation_1_20*sin_tau;
    const double phi_2_01 = chi + saltation_1_21*sin_tau - t0;
    const double phi_2_03 = t3;
    const double phi_2_20 = cos_tau*saltation_1_20 - sin_tau;
    const double phi_2_21 = cos_tau*saltation_1_21 + t2;
    const double phi_2_23 = t1;
    /* saltation of phase 2 */
    const double t38 = -before_v1_2 + behind_v1_2;
    const double t39 = (1.0/((-chi*v1_2 + t36)));
    const double t40 = chi*t39;
    const double t41 = t38*t40;
    const double saltation_2_20 = -phi_2_00*t41 + phi_2_20;
    const double saltation_2_21 = -phi_2_01*t41 + phi_2_21 + t41;
    const double t42 = t38*t39;
    const double saltation_2_22 = cos_tau - t2*t42;
    const double t43 = chi*tau;
    const double saltation_2_23 = -phi_2_03*t41 + phi_2_23 + t42*t43;
    const double t44 = behind_v2_2*t40;
    const double saltation_2_30 = -phi_2_00*t44;
    const double saltation_2_31 = behind_v2_2*chi*t39 - phi_2_01*t44;
    const double t45 = behind_v2_2*t39;
    const double saltation_2_32 = -t2*t45;
    const double saltation_2_33 = -phi_2_03*t44 + t43*t45 + 1;
    /* Phi of phase 3 */
    const double phi_3_00 = phi_2_00*t11 + saltation_2_20*t10 + saltation_2_30*t13;
    const double phi_3_01 = phi_2_01*t11 + saltation_2_21*t10 + saltation_2_31*t13 + t12;
    const double phi_3_02 = saltation_2_22*t10 + saltation_2_32*t13 + sin_tau*t11;
    const double phi_3_03 = phi_2_03*t11 + saltation_2_23*t10 + saltation_2_33*t13 + t12*tau;
    const double phi_3_10 = phi_2_00*t15 + saltation_2_20*t14 + saltation_2_30*t17;
    const double phi_3_11 = phi_2_01*t15 + saltation_2_21*t14 + saltation_2_31*t17 + t16;
    const double phi_3_12 = saltation_2_22*t14 + saltation_2_32*t17 + sin_tau*t15;
    const double phi_3_13 = phi_2_03*t15 + saltation_2_23*t14 + saltation_2_33*t17 + t16*tau;
    const double phi_3_20 = phi_2_00*t20 + saltation_2_20*t11 + saltation_2_30*t12;
    const double phi_3_21 = p2*t18 + phi_2_01*t20 + saltation_2_21*t11 + saltation_2_31*t12 - t21;
    const double phi_3_22 = saltation_2_22*t11 + saltation_2_32*t12 + sin_tau*t20;
    const double phi_3_23 = phi_2_03*t20 + saltation_2_23*t11 + saltation_2_33*t12 + t22*tau;
    const double phi_3_30 = phi_2_00*t23 + saltation_2_20*t15 + saltation_2_30*t16;
    const double phi_3_31 = phi_2_01*t23 + saltation_2_21*t15 + saltation_2_31*t16 - t24 - t25;
    const double phi_3_32 = saltation_2_22*t15 + saltation_2_32*t16 + sin_tau*t23;
    const double phi_3_33 = phi_2_03*t23 + saltation_2_23*t15 + saltation_2_33*t16 + t26*tau;
    /* saltation of phase 3 */
    const double t46 = (1.0/(before_v1_3));
    const double t47 = t46*(V - v1_3);
    const double saltation_3_00 = phi_3_00 + phi_3_20*t47;
    const double saltation_3_01 = phi_3_01 + phi_3_21*t47;
    const double saltation_3_02 = phi_3_02 + phi_3_22*t47;
    const double saltation_3_03 = phi_3_03 + phi_3_23*t47;
    const double t48 = t46*(-before_v2_3 + behind_v2_3);
    const double saltation_3_30 = phi_3_20*t48 + phi_3_30;
    const double saltation_3_31 = phi_3_21*t48 + phi_3_31;
    const double saltation_3_32 = phi_3_22*t48 + phi_3_32;
    const double saltation_3_33 = phi_3_23*t48 + phi_3_33;
    /* Phi of phase 4 */
    const double phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t28 + saltation_3_30*t29;
    const double phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t28 + saltation_3_31*t29;
    const double phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t28 + saltation_3_32*t29;
    const double phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t28 + saltation_3_33*t29;
    const double phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t30 + saltation_3_00*t30;
    const double phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t30 + saltation_3_01*t30;
    const double phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t30 + saltation_3_02*t30;
    const double phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t30 + saltation_3_03*t30;
    /* saltation of phase 4 */
    const double t49 = (V - v2_4)/before_v2_4;
    const double saltation_4_10 = phi_4_10 + phi_4_30*t49;
    const double saltation_4_11 = phi_4_11 + phi_4_31*t49;
    const double saltation_4_12 = phi_4_12 + phi_4_32*t49;
    const double saltation_4_13 = phi_4_13 + phi_4_33*t49;
    monodromy[0] = saltation_3_00;
    monodromy[1] = saltation_3_01;
    monodromy[2] = saltation_3_02;
    monodromy[3] = saltation_3_03;
    monodromy[4] = saltation_4_10;
    monodromy[5] = saltation_4_11;
    monodromy[6] = saltation_4_12;
    monodromy[7] = saltation_4_13;
    monodromy[8] = 0;
    monodromy[9] = 0;
    monodromy[10] = 0;
    monodromy[11] = 0;
    monodromy[12] = 0;
    monodromy[13] = 0;
    monodromy[14] = 0;
    monodromy[15] = 0;
}

/* Trace of the Poincare map's Jacobian.
 * Takes parameters (4), spectrum (7), unknowns (6); gives trace, row by row.
 * Operations: 265. Intermediate terms: 97. */
void dry_friction_solution_ii_trace(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double *trace)
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
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
    const double t4 = (1.0/(omega1));
    const double t7 = sin_omega2_tau1/omega2;
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t8 = p1*t5 + t6*t7;
    const double t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6;
    const double t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t10*z2_2 + t8*v1_2 + t9*z1_2;
    const double t11 = p3*sin_omega1_tau1*t4 - p3*t7;
    const double t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t13 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t11*v1_2 + t12*z1_2 + t13*z2_2;
    const double t14 = omega2*sin_omega2_tau1;
    const double t15 = omega1*sin_omega1_tau1;
    const double t16 = -p1*t15 - t14*t6;
    const double t17 = omega2*p2*sin_omega2_tau1 - p2*t15;
    const double v1_3 = V*t10 + t16*z1_2 + t17*z2_2 + t9*v1_2;
    const double t18 = omega2*p3*sin_omega2_tau1 - p3*t15;
    const double t19 = -p1*t14 - t15*t6;
    const double v2_3 = V*t13 + t12*v1_2 + t18*z1_2 + t19*z2_2;
    /* functions of tau2 in stick-slip */
    const double t20 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t20);
    const double sin_omega3_tau2 = sin(t20);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t21 = 1 - cos_omega3_tau2;
    const double t22 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t22 + tau2) + cos_omega3_tau2*z2_3 + t21*z1_3 + t22*v2_3;
    const double t23 = omega3*sin_omega3_tau2;
    const double v2_4 = V*t21 + cos_omega3_tau2*v2_3 + t23*z1_3 - t23*z2_3;
    /* rate of the exit boundary after ta */
    const double t24 = V*chi;
    const double rate_1 = V - t24;
    /* derivatives of the time to the boundary after ta */
    const double t25 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t25;
    const double delay_ta_by_z20 = chi*t25;
    /* perturbation on the boundary after ta */
    const double t26 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = t26 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z10 = t26;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t0*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t0*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t24;
    /* derivatives of the time to the boundary after tau */
    const double t28 = (1.0/(rate_2));
    const double delay_tau_by_z10 = t28*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20 = t28*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t29 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t29;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t29;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t10*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10 + t9*z1_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t10*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20 + t9*z1_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t16*z1_2_on_boundary_by_z10 + t17*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t16*z1_2_on_boundary_by_z20 + t17*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t30 = chi*z2_3;
    const double rate_3 = t30 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t31 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t31;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t31;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t32 = chi*eta;
    const double t33 = -eta*t30 + t32*z1_3;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t33;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t33;
    /* Phi along tau2 */
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t21*z1_3_on_boundary_by_z20 + t22*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t23*z1_3_on_boundary_by_z10 - t23*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t23*z1_3_on_boundary_by_z20 - t23*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t32*z1_4 - t32*z2_4;
    /* derivatives of the time to the boundary after tau2 */
    const double t34 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t34;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t34;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
    *trace = z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20;
}

/* Derivatives of the trace by the unknowns, then in total by the parameters.
 * Takes parameters (4), spectrum (7), spectrum_derivatives (7, 2), unknowns (6); gives trace_gradient (10), row by row.
 * Operations: 2228. Intermediate terms: 634. */
void dry_friction_solution_ii_trace_gradient(
    const double parameters[4], const double spectrum[7], const double spectrum_derivatives[14], const double unknowns[6], double trace_gradient[10])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double omega1_by_chi = spectrum_derivatives[2];
    const double omega1_by_eta = spectrum_derivatives[3];
    const double omega2_by_chi = spectrum_derivatives[4];
    const double omega2_by_eta = spectrum_derivatives[5];
    const double p1_by_chi = spectrum_derivatives[6];
    const double p1_by_eta = spectrum_derivatives[7];
    const double p2_by_chi = spectrum_derivatives[8];
    const double p2_by_eta = spectrum_derivatives[9];
    const double p3_by_chi = spectrum_derivatives[10];
    const double p3_by_eta = spectrum_derivatives[11];
    const double omega3_by_chi = spectrum_derivatives[12];
    const double omega3_by_eta = spectrum_derivatives[13];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick for tau, until second-breaks-forward */
    const double t3 = chi*cos_tau;
    const double t4 = chi - t3;
    const double t5 = chi*sin_tau;
    const double z1_2 = V*sin_tau + V*(chi*tau - t5) + cos_tau*z10 + t4*z20;
    const double z2_2 = V*tau + z20;
    const double v1_2 = V*cos_tau + V*t4 - sin_tau*z10 + t5*z20;
    /* functions of tau1 in slip-slip */
    const double t6 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t6);
    const double sin_omega1_tau1 = sin(t6);
    const double t9 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t9);
    const double sin_omega2_tau1 = sin(t9);
    /* slip-slip for tau1, until first-reaches-belt */
    const double t12 = (1.0/(omega1));
    const double t13 = sin_omega1_tau1*t12;
    const double t14 = 1 - p1;
    const double t15 = (1.0/(omega2));
    const double t16 = sin_omega2_tau1*t15;
    const double t17 = p1*t13 + t14*t16;
    const double t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14;
    const double t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double t20 = p2*t16;
    const double z1_3 = V*(p2*sin_omega1_tau1*t12 - t20) + t17*v1_2 + t18*z1_2 + t19*z2_2;
    const double t21 = p3*sin_omega1_tau1*t12 - p3*t16;
    const double t22 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t23 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1;
    const double t24 = p1*t16 + t13*t14;
    const double z2_3 = V*t24 + t21*v1_2 + t22*z1_2 + t23*z2_2;
    const double t25 = omega2*sin_omega2_tau1;
    const double t26 = omega1*sin_omega1_tau1;
    const double t27 = -p1*t26 - t14*t25;
    const double t28 = p2*t26;
    const double t29 = omega2*p2*sin_omega2_tau1 - t28;
    const double t30 = V*t19;
    const double v1_3 = t18*v1_2 + t27*z1_2 + t29*z2_2 + t30;
    const double t31 = omega2*p3*sin_omega2_tau1 - p3*t26;
    const double t32 = p1*t25 + t14*t26;
    const double t34 = V*t23;
    const double v2_3 = t22*v1_2 + t31*z1_2 - t32*z2_2 + t34;
    /* functions of tau2 in stick-slip */
    const double t35 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t35);
    const double sin_omega3_tau2 = sin(t35);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t38 = 1 - cos_omega3_tau2;
    const double t39 = (1.0/(omega3));
    const double t40 = sin_omega3_tau2*t39;
    const double t41 = -t40 + tau2;
    const double z2_4 = V*t41 + cos_omega3_tau2*z2_3 + t38*z1_3 + t40*v2_3;
    const double t42 = omega3*z1_3;
    const double t43 = omega3*z2_3;
    const double v2_4 = V*t38 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t42 - sin_omega3_tau2*t43;
    /* rate of the exit boundary after ta */
    const double t45 = V*chi;
    const double rate_1 = V - t45;
    /* derivatives of the time to the boundary after ta */
    const double t47 = (1.0/(rate_1));
    const double delay_ta_by_z10 = -t47;
    const double delay_ta_by_z20 = chi*t47;
    /* perturbation on the boundary after ta */
    const double t49 = V*delay_ta_by_z10;
    const double z1_1_on_boundary_by_z10 = t49 + 1;
    const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
    const double z2_1_on_boundary_by_z10 = t49;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t4*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t4*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t5*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t5*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t45;
    /* derivatives of the time to the boundary after tau */
    const double t51 = (1.0/(rate_2));
    const double t52 = chi*z2_1_on_boundary_by_z10;
    const double t53 = carried_z1_2_by_z10*chi - t52;
    const double delay_tau_by_z10 = t51*t53;
    const double t54 = chi*z2_1_on_boundary_by_z20;
    const double t55 = carried_z1_2_by_z20*chi - t54;
    const double delay_tau_by_z20 = t51*t55;
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t56 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t56;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t56;
    /* Phi along tau1 */
    const double carried_z1_3_by_z10 = t17*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20 = t17*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20;
    const double carried_z2_3_by_z10 = t21*v1_2_on_boundary_by_z10 + t22*z1_2_on_boundary_by_z10 + t23*z2_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20 = t21*v1_2_on_boundary_by_z20 + t22*z1_2_on_boundary_by_z20 + t23*z2_2_on_boundary_by_z20;
    const double carried_v1_3_by_z10 = t18*v1_2_on_boundary_by_z10 + t27*z1_2_on_boundary_by_z10 + t29*z2_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20 = t18*v1_2_on_boundary_by_z20 + t27*z1_2_on_boundary_by_z20 + t29*z2_2_on_boundary_by_z20;
    const double carried_v2_3_by_z10 = t22*v1_2_on_boundary_by_z10 + t31*z1_2_on_boundary_by_z10 - t32*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20 = t22*v1_2_on_boundary_by_z20 + t31*z1_2_on_boundary_by_z20 - t32*z2_2_on_boundary_by_z20;
    /* rate of the exit boundary after tau1 */
    const double t57 = chi*z2_3;
    const double rate_3 = t57 - z1_3;
    /* derivatives of the time to the boundary after tau1 */
    const double t58 = (1.0/(rate_3));
    const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t58;
    const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t58;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
    const double t59 = eta*z1_3;
    const double t60 = chi*t59 - eta*t57;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t60;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t60;
    /* Phi along tau2 */
    const double t61 = omega3*z1_3_on_boundary_by_z10;
    const double t62 = omega3*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2*t61 - sin_omega3_tau2*t62;
    const double t63 = omega3*z1_3_on_boundary_by_z20;
    const double t64 = omega3*z2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2*t63 - sin_omega3_tau2*t64;
    /* rate of the exit boundary after tau2 */
    const double t65 = eta*z1_4;
    const double t66 = eta*z2_4;
    const double rate_4 = chi*t65 - chi*t66;
    /* derivatives of the time to the boundary after tau2 */
    const double t67 = (1.0/(rate_4));
    const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t67;
    const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t67;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dz10 of: slip-stick for tau, until second-breaks-forward */
    const double v1_2_by_z10 = -sin_tau;
    /* d/dz20 of: slip-stick for tau, until second-breaks-forward */
    const double z1_2_by_z20 = t4;
    const double v1_2_by_z20 = t5;
    /* d/dtau of: slip-stick for tau, until second-breaks-forward */
    const double t68 = chi*z20 - z10;
    const double z1_2_by_tau = -cos_tau_by_tau*t68 + rate_1*sin_tau_by_tau + t45;
    const double v1_2_by_tau = cos_tau_by_tau*rate_1 + sin_tau_by_tau*t68;
    /* d/dchi of: slip-stick for tau, until second-breaks-forward */
    const double t69 = 1 - cos_tau;
    const double z1_2_by_chi = V*(-sin_tau + tau) + t69*z20;
    const double v1_2_by_chi = V*t69 + sin_tau*z20;
    /* d/dV of: slip-stick for tau, until second-breaks-forward */
    const double t70 = chi*tau;
    const double z1_2_by_V = sin_tau - t5 + t70;
    const double v1_2_by_V = chi + cos_tau - t3;
    /* d/dtau1 of: functions of tau1 in slip-slip */
    const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
    const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
    const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
    const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
    /* d/dchi of: functions of tau1 in slip-slip */
    const double t71 = omega1_by_chi*tau1;
    const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t71;
    const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t71;
    const double t72 = omega2_by_chi*tau1;
    const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t72;
    const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t72;
    /* d/deta of: functions of tau1 in slip-slip */
    const double t73 = omega1_by_eta*tau1;
    const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t73;
    const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t73;
    const double t74 = omega2_by_eta*tau1;
    const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t74;
    const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t74;
    /* d/dz10 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10;
    const double z2_3_by_z10 = cos_tau*t22 + t21*v1_2_by_z10;
    const double v1_3_by_z10 = cos_tau*t27 + t18*v1_2_by_z10;
    const double v2_3_by_z10 = cos_tau*t31 + t22*v1_2_by_z10;
    /* d/dz20 of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19;
    const double z2_3_by_z20 = t21*v1_2_by_z20 + t22*z1_2_by_z20 + t23;
    const double v1_3_by_z20 = p2*t25 + t18*v1_2_by_z20 + t27*z1_2_by_z20 - t28;
    const double v2_3_by_z20 = t22*v1_2_by_z20 + t31*z1_2_by_z20 - t32;
    /* d/dtau of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t30;
    const double z2_3_by_tau = t21*v1_2_by_tau + t22*z1_2_by_tau + t34;
    const double v1_3_by_tau = V*t29 + t18*v1_2_by_tau + t27*z1_2_by_tau;
    const double v2_3_by_tau = -V*t32 + t22*v1_2_by_tau + t31*z1_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1, until first-reaches-belt */
    const double t75 = p1*z1_2;
    const double t76 = p2*z2_2;
    const double t77 = t75 + t76;
    const double t78 = t14*z1_2 - t76;
    const double t79 = p1*v1_2;
    const double t80 = V*p2;
    const double t81 = t12*t79 + t12*t80;
    const double t82 = t14*t15*v1_2 - t15*t80;
    const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t77 + cos_omega2_tau1_by_tau1*t78 + sin_omega1_tau1_by_tau1*t81 + sin_omega2_tau1_by_tau1*t82;
    const double t83 = p3*z1_2;
    const double t84 = t14*z2_2;
    const double t85 = t83 + t84;
    const double t86 = p1*z2_2;
    const double t87 = -t83 + t86;
    const double t88 = p3*v1_2;
    const double t89 = V*t14;
    const double t90 = t12*t88 + t12*t89;
    const double t91 = V*p1;
    const double t92 = -t15*t88 + t15*t91;
    const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t85 + cos_omega2_tau1_by_tau1*t87 + sin_omega1_tau1_by_tau1*t90 + sin_omega2_tau1_by_tau1*t92;
    const double t93 = t79 + t80;
    const double t94 = t14*v1_2 - t80;
    const double t95 = -omega1*t75 - omega1*t76;
    const double t96 = t14*z1_2;
    const double t97 = omega2*t76 - omega2*t96;
    const double v1_3_by_tau1 = cos_omega1_tau1_by_tau1*t93 + cos_omega2_tau1_by_tau1*t94 + sin_omega1_tau1_by_tau1*t95 + sin_omega2_tau1_by_tau1*t97;
    const double t98 = t88 + t89;
    const double t99 = -t88 + t91;
    const double t100 = -omega1*t83 - omega1*t84;
    const double t101 = omega2*p3*z1_2 - omega2*t86;
    const double v2_3_by_tau1 = cos_omega1_tau1_by_tau1*t98 + cos_omega2_tau1_by_tau1*t99 + sin_omega1_tau1_by_tau1*t100 + sin_omega2_tau1_by_tau1*t101;
    /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
    const double t102 = sin_omega1_tau1/(omega1*omega1);
    const double t103 = -t102*t79 - t102*t80;
    const double t104 = (1.0/(omega2*omega2));
    const double t105 = sin_omega2_tau1*t104;
    const double t106 = -t105*t14*v1_2 + t105*t80;
    const double t107 = -sin_omega1_tau1*t12 + t16;
    const double t109 = cos_omega1_tau1 - cos_omega2_tau1;
    const double t110 = -t107*v1_2 + t109*z1_2;
    const double t111 = -V*t107 + t109*z2_2;
    const double z1_3_by_chi = cos_omega1_tau1_by_chi*t77 + cos_omega2_tau1_by_chi*t78 + omega1_by_chi*t103 + omega2_by_chi*t106 + p1_by_chi*t110 + p2_by_chi*t111 + sin_omega1_tau1_by_chi*t81 + sin_omega2_tau1_by_chi*t82 + t17*v1_2_by_chi + t18*z1_2_by_chi;
    const double t112 = -t102*t88 - t102*t89;
    const double t113 = p3*sin_omega2_tau1*t104*v1_2 - t105*t91;
    const double t115 = V*t107 - t109*z2_2;
    const double z2_3_by_chi = cos_omega1_tau1_by_chi*t85 + cos_omega2_tau1_by_chi*t87 + omega1_by_chi*t112 + omega2_by_chi*t113 + p1_by_chi*t115 + p3_by_chi*t110 + sin_omega1_tau1_by_chi*t90 + sin_omega2_tau1_by_chi*t92 + t21*v1_2_by_chi + t22*z1_2_by_chi;
    const double t116 = -sin_omega1_tau1*t75 - sin_omega1_tau1*t76;
    const double t117 = sin_omega2_tau1*t76 - sin_omega2_tau1*t96;
    const double t118 = -omega2*sin_omega2_tau1 + t26;
    const double t120 = t109*v1_2 - t118*z1_2;
    const double t121 = V*t109 - t118*z2_2;
    const double v1_3_by_chi = cos_omega1_tau1_by_chi*t93 + cos_omega2_tau1_by_chi*t94 + omega1_by_chi*t116 + omega2_by_chi*t117 + p1_by_chi*t120 + p2_by_chi*t121 + sin_omega1_tau1_by_chi*t95 + sin_omega2_tau1_by_chi*t97 + t18*v1_2_by_chi + t27*z1_2_by_chi;
    const double t122 = -sin_omega1_tau1*t83 - sin_omega1_tau1*t84;
    const double t123 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t86;
    const double t124 = -V*t109 + t118*z2_2;
    const double v2_3_by_chi = cos_omega1_tau1_by_chi*t98 + cos_omega2_tau1_by_chi*t99 + omega1_by_chi*t122 + omega2_by_chi*t123 + p1_by_chi*t124 + p3_by_chi*t120 + sin_omega1_tau1_by_chi*t100 + sin_omega2_tau1_by_chi*t101 + t22*v1_2_by_chi + t31*z1_2_by_chi;
    /* d/deta of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_eta = cos_omega1_tau1_by_eta*t77 + cos_omega2_tau1_by_eta*t78 + omega1_by_eta*t103 + omega2_by_eta*t106 + p1_by_eta*t110 + p2_by_eta*t111 + sin_omega1_tau1_by_eta*t81 + sin_omega2_tau1_by_eta*t82;
    const double z2_3_by_eta = cos_omega1_tau1_by_eta*t85 + cos_omega2_tau1_by_eta*t87 + omega1_by_eta*t112 + omega2_by_eta*t113 + p1_by_eta*t115 + p3_by_eta*t110 + sin_omega1_tau1_by_eta*t90 + sin_omega2_tau1_by_eta*t92;
    const double v1_3_by_eta = cos_omega1_tau1_by_eta*t93 + cos_omega2_tau1_by_eta*t94 + omega1_by_eta*t116 + omega2_by_eta*t117 + p1_by_eta*t120 + p2_by_eta*t121 + sin_omega1_tau1_by_eta*t95 + sin_omega2_tau1_by_eta*t97;
    const double v2_3_by_eta = cos_omega1_tau1_by_eta*t98 + cos_omega2_tau1_by_eta*t99 + omega1_by_eta*t122 + omega2_by_eta*t123 + p1_by_eta*t124 + p3_by_eta*t120 + sin_omega1_tau1_by_eta*t100 + sin_omega2_tau1_by_eta*t101;
    /* d/dV of: slip-slip for tau1, until first-reaches-belt */
    const double z1_3_by_V = p2*t13 + t17*v1_2_by_V + t18*z1_2_by_V + t19*tau - t20;
    const double z2_3_by_V = t21*v1_2_by_V + t22*z1_2_by_V + t23*tau + t24;
    const double v1_3_by_V = t18*v1_2_by_V + t19 + t27*z1_2_by_V + t29*tau;
    const double v2_3_by_V = t22*v1_2_by_V + t23 + t31*z1_2_by_V - t32*tau;
    /* d/dtau2 of: functions of tau2 in stick-slip */
    const double cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2;
    const double sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3;
    /* d/dchi of: functions of tau2 in stick-slip */
    const double t125 = omega3_by_chi*tau2;
    const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t125;
    const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t125;
    /* d/deta of: functions of tau2 in stick-slip */
    const double t126 = omega3_by_eta*tau2;
    const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t126;
    const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t126;
    /* d/dz10 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t38*z1_3_by_z10 + t40*v2_3_by_z10;
    const double t127 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t127*z1_3_by_z10 - t127*z2_3_by_z10;
    /* d/dz20 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t38*z1_3_by_z20 + t40*v2_3_by_z20;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t127*z1_3_by_z20 - t127*z2_3_by_z20;
    /* d/dtau of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t38*z1_3_by_tau + t40*v2_3_by_tau;
    const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t127*z1_3_by_tau - t127*z2_3_by_tau;
    /* d/dtau1 of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t38*z1_3_by_tau1 + t40*v2_3_by_tau1;
    const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t127*z1_3_by_tau1 - t127*z2_3_by_tau1;
    /* d/dtau2 of: stick-slip for tau2, until second-reaches-belt */
    const double t128 = -z1_3 + z2_3;
    const double t129 = -V*t39 + t39*v2_3;
    const double z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*t128 + sin_omega3_tau2_by_tau2*t129;
    const double t130 = -V + v2_3;
    const double t131 = t42 - t43;
    const double v2_4_by_tau2 = cos_omega3_tau2_by_tau2*t130 + sin_omega3_tau2_by_tau2*t131;
    /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
    const double t132 = sin_omega3_tau2/(omega3*omega3);
    const double t133 = V*t132 - t132*v2_3;
    const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t128 + omega3_by_chi*t133 + sin_omega3_tau2_by_chi*t129 + t38*z1_3_by_chi + t40*v2_3_by_chi;
    const double t134 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3;
    const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t130 + omega3_by_chi*t134 + sin_omega3_tau2_by_chi*t131 + t127*z1_3_by_chi - t127*z2_3_by_chi;
    /* d/deta of: stick-slip for tau2, until second-reaches-belt */
    const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t128 + omega3_by_eta*t133 + sin_omega3_tau2_by_eta*t129 + t38*z1_3_by_eta + t40*v2_3_by_eta;
    const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t130 + omega3_by_eta*t134 + sin_omega3_tau2_by_eta*t131 + t127*z1_3_by_eta - t127*z2_3_by_eta;
    /* d/dV of: stick-slip for tau2, until second-reaches-belt */
    const double z1_4_by_V = tau2 + z1_3_by_V;
    const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t38*z1_3_by_V + t40*v2_3_by_V + t41;
    const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t127*z1_3_by_V - t127*z2_3_by_V + 1;
    /* d/dchi of: rate of the exit boundary after ta */
    const double rate_1_by_chi = -V;
    /* d/dV of: rate of the exit boundary after ta */
    const double rate_1_by_V = 1 - chi;
    /* d/dchi of: derivatives of the time to the boundary after ta */
    const double t135 = (1.0/(rate_1*rate_1));
    const double delay_ta_by_z10_by_chi = rate_1_by_chi*t135;
    const double delay_ta_by_z20_by_chi = -chi*delay_ta_by_z10_by_chi + t47;
    /* d/dV of: derivatives of the time to the boundary after ta */
    const double delay_ta_by_z10_by_V = rate_1_by_V*t135;
    const double delay_ta_by_z20_by_V = -chi*delay_ta_by_z10_by_V;
    /* d/dchi of: perturbation on the boundary after ta */
    const double z1_1_on_boundary_by_z10_by_chi = V*delay_ta_by_z10_by_chi;
    const double z1_1_on_boundary_by_z20_by_chi = V*delay_ta_by_z20_by_chi;
    const double z2_1_on_boundary_by_z10_by_chi = z1_1_on_boundary_by_z10_by_chi;
    const double z2_1_on_boundary_by_z20_by_chi = z1_1_on_boundary_by_z20_by_chi;
    /* d/dV of: perturbation on the boundary after ta */
    const double z1_1_on_boundary_by_z10_by_V = V*delay_ta_by_z10_by_V + delay_ta_by_z10;
    const double z1_1_on_boundary_by_z20_by_V = V*delay_ta_by_z20_by_V + delay_ta_by_z20;
    const double z2_1_on_boundary_by_z10_by_V = z1_1_on_boundary_by_z10_by_V;
    const double z2_1_on_boundary_by_z20_by_V = z1_1_on_boundary_by_z20_by_V;
    /* d/dtau of: Phi along tau */
    const double t142 = t52 - z1_1_on_boundary_by_z10;
    const double carried_z1_2_by_z10_by_tau = -cos_tau_by_tau*t142;
    const double t143 = t54 - z1_1_on_boundary_by_z20;
    const double carried_z1_2_by_z20_by_tau = -cos_tau_by_tau*t143;
    const double carried_v1_2_by_z10_by_tau = sin_tau_by_tau*t142;
    const double carried_v1_2_by_z20_by_tau = sin_tau_by_tau*t143;
    /* d/dchi of: Phi along tau */
    const double carried_z1_2_by_z10_by_chi = cos_tau*z1_1_on_boundary_by_z10_by_chi + t4*z2_1_on_boundary_by_z10_by_chi + t69*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20_by_chi = cos_tau*z1_1_on_boundary_by_z20_by_chi + t4*z2_1_on_boundary_by_z20_by_chi + t69*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10_by_chi = -sin_tau*z1_1_on_boundary_by_z10_by_chi + sin_tau*z2_1_on_boundary_by_z10 + t5*z2_1_on_boundary_by_z10_by_chi;
    const double carried_v1_2_by_z20_by_chi = -sin_tau*z1_1_on_boundary_by_z20_by_chi + sin_tau*z2_1_on_boundary_by_z20 + t5*z2_1_on_boundary_by_z20_by_chi;
    /* d/dV of: Phi along tau */
    const double carried_z1_2_by_z10_by_V = cos_tau*z1_1_on_boundary_by_z10_by_V + t4*z2_1_on_boundary_by_z10_by_V;
    const double carried_z1_2_by_z20_by_V = cos_tau*z1_1_on_boundary_by_z20_by_V + t4*z2_1_on_boundary_by_z20_by_V;
    const double carried_v1_2_by_z10_by_V = -sin_tau*z1_1_on_boundary_by_z10_by_V + t5*z2_1_on_boundary_by_z10_by_V;
    const double carried_v1_2_by_z20_by_V = -sin_tau*z1_1_on_boundary_by_z20_by_V + t5*z2_1_on_boundary_by_z20_by_V;
    /* d/dz10 of: rate of the exit boundary after tau */
    const double rate_2_by_z10 = -chi*v1_2_by_z10;
    /* d/dz20 of: rate of the exit boundary after tau */
    const double rate_2_by_z20 = -chi*v1_2_by_z20;
    /* d/dtau of: rate of the exit boundary after tau */
    const double rate_2_by_tau = -chi*v1_2_by_tau;
    /* d/dchi of: rate of the exit boundary after tau */
    const double rate_2_by_chi = V - chi*v1_2_by_chi - v1_2;
    /* d/dV of: rate of the exit boundary after tau */
    const double rate_2_by_V = -chi*v1_2_by_V + chi;
    /* d/dz10 of: derivatives of the time to the boundary after tau */
    const double t144 = (1.0/(rate_2*rate_2));
    const double t145 = rate_2_by_z10*t144;
    const double delay_tau_by_z10_by_z10 = -t145*t53;
    const double delay_tau_by_z20_by_z10 = -t145*t55;
    /* d/dz20 of: derivatives of the time to the boundary after tau */
    const double t146 = rate_2_by_z20*t144;
    const double delay_tau_by_z10_by_z20 = -t146*t53;
    const double delay_tau_by_z20_by_z20 = -t146*t55;
    /* d/dtau of: derivatives of the time to the boundary after tau */
    const double t147 = chi*t51;
    const double t148 = rate_2_by_tau*t144;
    const double delay_tau_by_z10_by_tau = carried_z1_2_by_z10_by_tau*t147 - t148*t53;
    const double delay_tau_by_z20_by_tau = carried_z1_2_by_z20_by_tau*t147 - t148*t55;
    /* d/dchi of: derivatives of the time to the boundary after tau */
    const double t149 = rate_2_by_chi*t144;
    const double delay_tau_by_z10_by_chi = carried_z1_2_by_z10_by_chi*t147 - t147*z2_1_on_boundary_by_z10_by_chi - t149*t53 + t51*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10);
    const double delay_tau_by_z20_by_chi = carried_z1_2_by_z20_by_chi*t147 - t147*z2_1_on_boundary_by_z20_by_chi - t149*t55 + t51*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20);
    /* d/dV of: derivatives of the time to the boundary after tau */
    const double t150 = rate_2_by_V*t144;
    const double delay_tau_by_z10_by_V = carried_z1_2_by_z10_by_V*chi*t51 - t147*z2_1_on_boundary_by_z10_by_V - t150*t53;
    const double delay_tau_by_z20_by_V = carried_z1_2_by_z20_by_V*chi*t51 - t147*z2_1_on_boundary_by_z20_by_V - t150*t55;
    /* d/dz10 of: perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10_by_z10 = delay_tau_by_z10*v1_2_by_z10 + delay_tau_by_z10_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v1_2_by_z10 + delay_tau_by_z20_by_z10*v1_2;
    const double z2_2_on_boundary_by_z10_by_z10 = V*delay_tau_by_z10_by_z10;
    const double z2_2_on_boundary_by_z20_by_z10 = V*delay_tau_by_z20_by_z10;
    const double v1_2_on_boundary_by_z10_by_z10 = -cos_tau*delay_tau_by_z10 + delay_tau_by_z10_by_z10*t56;
    const double v1_2_on_boundary_by_z20_by_z10 = -cos_tau*delay_tau_by_z20 + delay_tau_by_z20_by_z10*t56;
    /* d/dz20 of: perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10_by_z20 = delay_tau_by_z10*v1_2_by_z20 + delay_tau_by_z10_by_z20*v1_2;
    const double z1_2_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v1_2_by_z20 + delay_tau_by_z20_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10_by_z20 = V*delay_tau_by_z10_by_z20;
    const double z2_2_on_boundary_by_z20_by_z20 = V*delay_tau_by_z20_by_z20;
    const double v1_2_on_boundary_by_z10_by_z20 = chi*delay_tau_by_z10 - delay_tau_by_z10*z1_2_by_z20 + delay_tau_by_z10_by_z20*t56;
    const double v1_2_on_boundary_by_z20_by_z20 = chi*delay_tau_by_z20 - delay_tau_by_z20*z1_2_by_z20 + delay_tau_by_z20_by_z20*t56;
    /* d/dtau of: perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10_by_tau = carried_z1_2_by_z10_by_tau + delay_tau_by_z10*v1_2_by_tau + delay_tau_by_z10_by_tau*v1_2;
    const double z1_2_on_boundary_by_z20_by_tau = carried_z1_2_by_z20_by_tau + delay_tau_by_z20*v1_2_by_tau + delay_tau_by_z20_by_tau*v1_2;
    const double z2_2_on_boundary_by_z10_by_tau = V*delay_tau_by_z10_by_tau;
    const double z2_2_on_boundary_by_z20_by_tau = V*delay_tau_by_z20_by_tau;
    const double v1_2_on_boundary_by_z10_by_tau = carried_v1_2_by_z10_by_tau + delay_tau_by_z10*t45 - delay_tau_by_z10*z1_2_by_tau + delay_tau_by_z10_by_tau*t56;
    const double v1_2_on_boundary_by_z20_by_tau = carried_v1_2_by_z20_by_tau + delay_tau_by_z20*t45 - delay_tau_by_z20*z1_2_by_tau + delay_tau_by_z20_by_tau*t56;
    /* d/dchi of: perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10_by_chi = carried_z1_2_by_z10_by_chi + delay_tau_by_z10*v1_2_by_chi + delay_tau_by_z10_by_chi*v1_2;
    const double z1_2_on_boundary_by_z20_by_chi = carried_z1_2_by_z20_by_chi + delay_tau_by_z20*v1_2_by_chi + delay_tau_by_z20_by_chi*v1_2;
    const double z2_2_on_boundary_by_z10_by_chi = V*delay_tau_by_z10_by_chi + z2_1_on_boundary_by_z10_by_chi;
    const double z2_2_on_boundary_by_z20_by_chi = V*delay_tau_by_z20_by_chi + z2_1_on_boundary_by_z20_by_chi;
    const double v1_2_on_boundary_by_z10_by_chi = carried_v1_2_by_z10_by_chi - delay_tau_by_z10*z1_2_by_chi + delay_tau_by_z10*z2_2 + delay_tau_by_z10_by_chi*t56;
    const double v1_2_on_boundary_by_z20_by_chi = carried_v1_2_by_z20_by_chi - delay_tau_by_z20*z1_2_by_chi + delay_tau_by_z20*z2_2 + delay_tau_by_z20_by_chi*t56;
    /* d/dV of: perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10_by_V = carried_z1_2_by_z10_by_V + delay_tau_by_z10*v1_2_by_V + delay_tau_by_z10_by_V*v1_2;
    const double z1_2_on_boundary_by_z20_by_V = carried_z1_2_by_z20_by_V + delay_tau_by_z20*v1_2_by_V + delay_tau_by_z20_by_V*v1_2;
    const double z2_2_on_boundary_by_z10_by_V = V*delay_tau_by_z10_by_V + delay_tau_by_z10 + z2_1_on_boundary_by_z10_by_V;
    const double z2_2_on_boundary_by_z20_by_V = V*delay_tau_by_z20_by_V + delay_tau_by_z20 + z2_1_on_boundary_by_z20_by_V;
    const double v1_2_on_boundary_by_z10_by_V = carried_v1_2_by_z10_by_V + delay_tau_by_z10*t70 - delay_tau_by_z10*z1_2_by_V + delay_tau_by_z10_by_V*t56;
    const double v1_2_on_boundary_by_z20_by_V = carried_v1_2_by_z20_by_V + delay_tau_by_z20*t70 - delay_tau_by_z20*z1_2_by_V + delay_tau_by_z20_by_V*t56;
    /* d/dz10 of: Phi along tau1 */
    const double carried_z1_3_by_z10_by_z10 = t17*v1_2_on_boundary_by_z10_by_z10 + t18*z1_2_on_boundary_by_z10_by_z10 + t19*z2_2_on_boundary_by_z10_by_z10;
    const double carried_z1_3_by_z20_by_z10 = t17*v1_2_on_boundary_by_z20_by_z10 + t18*z1_2_on_boundary_by_z20_by_z10 + t19*z2_2_on_boundary_by_z20_by_z10;
    const double carried_z2_3_by_z10_by_z10 = t21*v1_2_on_boundary_by_z10_by_z10 + t22*z1_2_on_boundary_by_z10_by_z10 + t23*z2_2_on_boundary_by_z10_by_z10;
    const double carried_z2_3_by_z20_by_z10 = t21*v1_2_on_boundary_by_z20_by_z10 + t22*z1_2_on_boundary_by_z20_by_z10 + t23*z2_2_on_boundary_by_z20_by_z10;
    const double carried_v1_3_by_z10_by_z10 = t18*v1_2_on_boundary_by_z10_by_z10 + t27*z1_2_on_boundary_by_z10_by_z10 + t29*z2_2_on_boundary_by_z10_by_z10;
    const double carried_v1_3_by_z20_by_z10 = t18*v1_2_on_boundary_by_z20_by_z10 + t27*z1_2_on_boundary_by_z20_by_z10 + t29*z2_2_on_boundary_by_z20_by_z10;
    const double carried_v2_3_by_z10_by_z10 = t22*v1_2_on_boundary_by_z10_by_z10 + t31*z1_2_on_boundary_by_z10_by_z10 - t32*z2_2_on_boundary_by_z10_by_z10;
    const double carried_v2_3_by_z20_by_z10 = t22*v1_2_on_boundary_by_z20_by_z10 + t31*z1_2_on_boundary_by_z20_by_z10 - t32*z2_2_on_boundary_by_z20_by_z10;
    /* d/dz20 of: Phi along tau1 */
    const double carried_z1_3_by_z10_by_z20 = t17*v1_2_on_boundary_by_z10_by_z20 + t18*z1_2_on_boundary_by_z10_by_z20 + t19*z2_2_on_boundary_by_z10_by_z20;
    const double carried_z1_3_by_z20_by_z20 = t17*v1_2_on_boundary_by_z20_by_z20 + t18*z1_2_on_boundary_by_z20_by_z20 + t19*z2_2_on_boundary_by_z20_by_z20;
    const double carried_z2_3_by_z10_by_z20 = t21*v1_2_on_boundary_by_z10_by_z20 + t22*z1_2_on_boundary_by_z10_by_z20 + t23*z2_2_on_boundary_by_z10_by_z20;
    const double carried_z2_3_by_z20_by_z20 = t21*v1_2_on_boundary_by_z20_by_z20 + t22*z1_2_on_boundary_by_z20_by_z20 + t23*z2_2_on_boundary_by_z20_by_z20;
    const double carried_v1_3_by_z10_by_z20 = t18*v1_2_on_boundary_by_z10_by_z20 + t27*z1_2_on_boundary_by_z10_by_z20 + t29*z2_2_on_boundary_by_z10_by_z20;
    const double carried_v1_3_by_z20_by_z20 = t18*v1_2_on_boundary_by_z20_by_z20 + t27*z1_2_on_boundary_by_z20_by_z20 + t29*z2_2_on_boundary_by_z20_by_z20;
    const double carried_v2_3_by_z10_by_z20 = t22*v1_2_on_boundary_by_z10_by_z20 + t31*z1_2_on_boundary_by_z10_by_z20 - t32*z2_2_on_boundary_by_z10_by_z20;
    const double carried_v2_3_by_z20_by_z20 = t22*v1_2_on_boundary_by_z20_by_z20 + t31*z1_2_on_boundary_by_z20_by_z20 - t32*z2_2_on_boundary_by_z20_by_z20;
    /* d/dtau of: Phi along tau1 */
    const double carried_z1_3_by_z10_by_tau = t17*v1_2_on_boundary_by_z10_by_tau + t18*z1_2_on_boundary_by_z10_by_tau + t19*z2_2_on_boundary_by_z10_by_tau;
    const double carried_z1_3_by_z20_by_tau = t17*v1_2_on_boundary_by_z20_by_tau + t18*z1_2_on_boundary_by_z20_by_tau + t19*z2_2_on_boundary_by_z20_by_tau;
    const double carried_z2_3_by_z10_by_tau = t21*v1_2_on_boundary_by_z10_by_tau + t22*z1_2_on_boundary_by_z10_by_tau + t23*z2_2_on_boundary_by_z10_by_tau;
    const double carried_z2_3_by_z20_by_tau = t21*v1_2_on_boundary_by_z20_by_tau + t22*z1_2_on_boundary_by_z20_by_tau + t23*z2_2_on_boundary_by_z20_by_tau;
    const double carried_v1_3_by_z10_by_tau = t18*v1_2_on_boundary_by_z10_by_tau + t27*z1_2_on_boundary_by_z10_by_tau + t29*z2_2_on_boundary_by_z10_by_tau;
    const double carried_v1_3_by_z20_by_tau = t18*v1_2_on_boundary_by_z20_by_tau + t27*z1_2_on_boundary_by_z20_by_tau + t29*z2_2_on_boundary_by_z20_by_tau;
    const double carried_v2_3_by_z10_by_tau = t22*v1_2_on_boundary_by_z10_by_tau + t31*z1_2_on_boundary_by_z10_by_tau - t32*z2_2_on_boundary_by_z10_by_tau;
    const double carried_v2_3_by_z20_by_tau = t22*v1_2_on_boundary_by_z20_by_tau + t31*z1_2_on_boundary_by_z20_by_tau - t32*z2_2_on_boundary_by_z20_by_tau;
    /* d/dtau1 of: Phi along tau1 */
    const double t151 = p1*z1_2_on_boundary_by_z10;
    const double t152 = p2*z2_2_on_boundary_by_z10;
    const double t153 = t151 + t152;
    const double t154 = t14*z1_2_on_boundary_by_z10 - t152;
    const double t155 = sin_omega1_tau1_by_tau1*t12;
    const double t156 = p1*v1_2_on_boundary_by_z10;
    const double t157 = sin_omega2_tau1_by_tau1*t15;
    const double t158 = t14*v1_2_on_boundary_by_z10;
    const double carried_z1_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t153 + cos_omega2_tau1_by_tau1*t154 + t155*t156 + t157*t158;
    const double t159 = p1*z1_2_on_boundary_by_z20;
    const double t160 = p2*z2_2_on_boundary_by_z20;
    const double t161 = t159 + t160;
    const double t162 = t14*z1_2_on_boundary_by_z20 - t160;
    const double t163 = p1*v1_2_on_boundary_by_z20;
    const double t164 = t14*v1_2_on_boundary_by_z20;
    const double carried_z1_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t161 + cos_omega2_tau1_by_tau1*t162 + t155*t163 + t157*t164;
    const double t165 = p3*z1_2_on_boundary_by_z10;
    const double t166 = t14*z2_2_on_boundary_by_z10;
    const double t167 = t165 + t166;
    const double t168 = p1*z2_2_on_boundary_by_z10;
    const double t169 = -t165 + t168;
    const double t170 = p3*v1_2_on_boundary_by_z10;
    const double carried_z2_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t167 + cos_omega2_tau1_by_tau1*t169 + t155*t170 - t157*t170;
    const double t171 = p3*z1_2_on_boundary_by_z20;
    const double t172 = t14*z2_2_on_boundary_by_z20;
    const double t173 = t171 + t172;
    const double t174 = p1*z2_2_on_boundary_by_z20;
    const double t175 = -t171 + t174;
    const double t176 = p3*v1_2_on_boundary_by_z20;
    const double carried_z2_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t173 + cos_omega2_tau1_by_tau1*t175 + t155*t176 - t157*t176;
    const double t177 = -omega1*t151 - omega1*t152;
    const double t178 = t14*z1_2_on_boundary_by_z10;
    const double t179 = omega2*t152 - omega2*t178;
    const double t180 = cos_omega1_tau1_by_tau1*p1;
    const double t181 = cos_omega2_tau1_by_tau1*t14;
    const double carried_v1_3_by_z10_by_tau1 = sin_omega1_tau1_by_tau1*t177 + sin_omega2_tau1_by_tau1*t179 + t180*v1_2_on_boundary_by_z10 + t181*v1_2_on_boundary_by_z10;
    const double t182 = -omega1*t159 - omega1*t160;
    const double t183 = t14*z1_2_on_boundary_by_z20;
    const double t184 = omega2*t160 - omega2*t183;
    const double carried_v1_3_by_z20_by_tau1 = sin_omega1_tau1_by_tau1*t182 + sin_omega2_tau1_by_tau1*t184 + t180*v1_2_on_boundary_by_z20 + t181*v1_2_on_boundary_by_z20;
    const double t185 = -omega1*t165 - omega1*t166;
    const double t186 = omega2*p3*z1_2_on_boundary_by_z10 - omega2*t168;
    const double carried_v2_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t170 - cos_omega2_tau1_by_tau1*t170 + sin_omega1_tau1_by_tau1*t185 + sin_omega2_tau1_by_tau1*t186;
    const double t187 = -omega1*t171 - omega1*t172;
    const double t188 = omega2*p3*z1_2_on_boundary_by_z20 - omega2*t174;
    const double carried_v2_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t176 - cos_omega2_tau1_by_tau1*t176 + sin_omega1_tau1_by_tau1*t187 + sin_omega2_tau1_by_tau1*t188;
    /* d/dchi of: Phi along tau1 */
    const double t189 = -t107*v1_2_on_boundary_by_z10 + t109*z1_2_on_boundary_by_z10;
    const double t190 = p2_by_chi*t109;
    const double t191 = sin_omega1_tau1_by_chi*t12;
    const double t192 = sin_omega2_tau1_by_chi*t15;
    const double t193 = omega1_by_chi*t102;
    const double t194 = omega2_by_chi*t105;
    const double carried_z1_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t153 + cos_omega2_tau1_by_chi*t154 + p1_by_chi*t189 + t156*t191 - t156*t193 + t158*t192 - t158*t194 + t17*v1_2_on_boundary_by_z10_by_chi + t18*z1_2_on_boundary_by_z10_by_chi + t19*z2_2_on_boundary_by_z10_by_chi + t190*z2_2_on_boundary_by_z10;
    const double t195 = -t107*v1_2_on_boundary_by_z20 + t109*z1_2_on_boundary_by_z20;
    const double carried_z1_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t161 + cos_omega2_tau1_by_chi*t162 + p1_by_chi*t195 + t163*t191 - t163*t193 + t164*t192 - t164*t194 + t17*v1_2_on_boundary_by_z20_by_chi + t18*z1_2_on_boundary_by_z20_by_chi + t19*z2_2_on_boundary_by_z20_by_chi + t190*z2_2_on_boundary_by_z20;
    const double t196 = -p1_by_chi*t109;
    const double carried_z2_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t167 + cos_omega2_tau1_by_chi*t169 + p3_by_chi*t189 + t170*t191 - t170*t192 - t170*t193 + t170*t194 + t196*z2_2_on_boundary_by_z10 + t21*v1_2_on_boundary_by_z10_by_chi + t22*z1_2_on_boundary_by_z10_by_chi + t23*z2_2_on_boundary_by_z10_by_chi;
    const double carried_z2_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t173 + cos_omega2_tau1_by_chi*t175 + p3_by_chi*t195 + t176*t191 - t176*t192 - t176*t193 + t176*t194 + t196*z2_2_on_boundary_by_z20 + t21*v1_2_on_boundary_by_z20_by_chi + t22*z1_2_on_boundary_by_z20_by_chi + t23*z2_2_on_boundary_by_z20_by_chi;
    const double t197 = -sin_omega1_tau1*t151 - sin_omega1_tau1*t152;
    const double t198 = sin_omega2_tau1*t152 - sin_omega2_tau1*t178;
    const double t199 = t109*v1_2_on_boundary_by_z10 - t118*z1_2_on_boundary_by_z10;
    const double t200 = cos_omega1_tau1_by_chi*p1;
    const double t201 = cos_omega2_tau1_by_chi*t14;
    const double t202 = -p2_by_chi*t118;
    const double carried_v1_3_by_z10_by_chi = omega1_by_chi*t197 + omega2_by_chi*t198 + p1_by_chi*t199 + sin_omega1_tau1_by_chi*t177 + sin_omega2_tau1_by_chi*t179 + t18*v1_2_on_boundary_by_z10_by_chi + t200*v1_2_on_boundary_by_z10 + t201*v1_2_on_boundary_by_z10 + t202*z2_2_on_boundary_by_z10 + t27*z1_2_on_boundary_by_z10_by_chi + t29*z2_2_on_boundary_by_z10_by_chi;
    const double t203 = -sin_omega1_tau1*t159 - sin_omega1_tau1*t160;
    const double t204 = sin_omega2_tau1*t160 - sin_omega2_tau1*t183;
    const double t205 = t109*v1_2_on_boundary_by_z20 - t118*z1_2_on_boundary_by_z20;
    const double carried_v1_3_by_z20_by_chi = omega1_by_chi*t203 + omega2_by_chi*t204 + p1_by_chi*t205 + sin_omega1_tau1_by_chi*t182 + sin_omega2_tau1_by_chi*t184 + t18*v1_2_on_boundary_by_z20_by_chi + t200*v1_2_on_boundary_by_z20 + t201*v1_2_on_boundary_by_z20 + t202*z2_2_on_boundary_by_z20 + t27*z1_2_on_boundary_by_z20_by_chi + t29*z2_2_on_boundary_by_z20_by_chi;
    const double t206 = -sin_omega1_tau1*t165 - sin_omega1_tau1*t166;
    const double t207 = p3*sin_omega2_tau1*z1_2_on_boundary_by_z10 - sin_omega2_tau1*t168;
    const double t208 = p1_by_chi*t118;
    const double carried_v2_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t170 - cos_omega2_tau1_by_chi*t170 + omega1_by_chi*t206 + omega2_by_chi*t207 + p3_by_chi*t199 + sin_omega1_tau1_by_chi*t185 + sin_omega2_tau1_by_chi*t186 + t208*z2_2_on_boundary_by_z10 + t22*v1_2_on_boundary_by_z10_by_chi + t31*z1_2_on_boundary_by_z10_by_chi - t32*z2_2_on_boundary_by_z10_by_chi;
    const double t209 = -sin_omega1_tau1*t171 - sin_omega1_tau1*t172;
    const double t210 = p3*sin_omega2_tau1*z1_2_on_boundary_by_z20 - sin_omega2_tau1*t174;
    const double carried_v2_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t176 - cos_omega2_tau1_by_chi*t176 + omega1_by_chi*t209 + omega2_by_chi*t210 + p3_by_chi*t205 + sin_omega1_tau1_by_chi*t187 + sin_omega2_tau1_by_chi*t188 + t208*z2_2_on_boundary_by_z20 + t22*v1_2_on_boundary_by_z20_by_chi + t31*z1_2_on_boundary_by_z20_by_chi - t32*z2_2_on_boundary_by_z20_by_chi;
    /* d/deta of: Phi along tau1 */
    const double t211 = p2_by_eta*t109;
    const double t212 = sin_omega1_tau1_by_eta*t12;
    const double t213 = sin_omega2_tau1_by_eta*t15;
    const double t214 = omega1_by_eta*t102;
    const double t215 = omega2_by_eta*t105;
    const double carried_z1_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t153 + cos_omega2_tau1_by_eta*t154 + p1_by_eta*t189 + t156*t212 - t156*t214 + t158*t213 - t158*t215 + t211*z2_2_on_boundary_by_z10;
    const double carried_z1_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t161 + cos_omega2_tau1_by_eta*t162 + p1_by_eta*t195 + t163*t212 - t163*t214 + t164*t213 - t164*t215 + t211*z2_2_on_boundary_by_z20;
    const double t216 = -p1_by_eta*t109;
    const double carried_z2_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t167 + cos_omega2_tau1_by_eta*t169 + p3_by_eta*t189 + t170*t212 - t170*t213 - t170*t214 + t170*t215 + t216*z2_2_on_boundary_by_z10;
    const double carried_z2_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t173 + cos_omega2_tau1_by_eta*t175 + p3_by_eta*t195 + t176*t212 - t176*t213 - t176*t214 + t176*t215 + t216*z2_2_on_boundary_by_z20;
    const double t217 = cos_omega1_tau1_by_eta*p1;
    const double t218 = cos_omega2_tau1_by_eta*t14;
    const double t219 = -p2_by_eta*t118;
    const double carried_v1_3_by_z10_by_eta = omega1_by_eta*t197 + omega2_by_eta*t198 + p1_by_eta*t199 + sin_omega1_tau1_by_eta*t177 + sin_omega2_tau1_by_eta*t179 + t217*v1_2_on_boundary_by_z10 + t218*v1_2_on_boundary_by_z10 + t219*z2_2_on_boundary_by_z10;
    const double carried_v1_3_by_z20_by_eta = omega1_by_eta*t203 + omega2_by_eta*t204 + p1_by_eta*t205 + sin_omega1_tau1_by_eta*t182 + sin_omega2_tau1_by_eta*t184 + t217*v1_2_on_boundary_by_z20 + t218*v1_2_on_boundary_by_z20 + t219*z2_2_on_boundary_by_z20;
    const double t220 = p1_by_eta*t118;
    const double carried_v2_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t170 - cos_omega2_tau1_by_eta*t170 + omega1_by_eta*t206 + omega2_by_eta*t207 + p3_by_eta*t199 + sin_omega1_tau1_by_eta*t185 + sin_omega2_tau1_by_eta*t186 + t220*z2_2_on_boundary_by_z10;
    const double carried_v2_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t176 - cos_omega2_tau1_by_eta*t176 + omega1_by_eta*t209 + omega2_by_eta*t210 + p3_by_eta*t205 + sin_omega1_tau1_by_eta*t187 + sin_omega2_tau1_by_eta*t188 + t220*z2_2_on_boundary_by_z20;
    /* d/dV of: Phi along tau1 */
    const double carried_z1_3_by_z10_by_V = t17*v1_2_on_boundary_by_z10_by_V + t18*z1_2_on_boundary_by_z10_by_V + t19*z2_2_on_boundary_by_z10_by_V;
    const double carried_z1_3_by_z20_by_V = t17*v1_2_on_boundary_by_z20_by_V + t18*z1_2_on_boundary_by_z20_by_V + t19*z2_2_on_boundary_by_z20_by_V;
    const double carried_z2_3_by_z10_by_V = t21*v1_2_on_boundary_by_z10_by_V + t22*z1_2_on_boundary_by_z10_by_V + t23*z2_2_on_boundary_by_z10_by_V;
    const double carried_z2_3_by_z20_by_V = t21*v1_2_on_boundary_by_z20_by_V + t22*z1_2_on_boundary_by_z20_by_V + t23*z2_2_on_boundary_by_z20_by_V;
    const double carried_v1_3_by_z10_by_V = t18*v1_2_on_boundary_by_z10_by_V + t27*z1_2_on_boundary_by_z10_by_V + t29*z2_2_on_boundary_by_z10_by_V;
    const double carried_v1_3_by_z20_by_V = t18*v1_2_on_boundary_by_z20_by_V + t27*z1_2_on_boundary_by_z20_by_V + t29*z2_2_on_boundary_by_z20_by_V;
    const double carried_v2_3_by_z10_by_V = t22*v1_2_on_boundary_by_z10_by_V + t31*z1_2_on_boundary_by_z10_by_V - t32*z2_2_on_boundary_by_z10_by_V;
    const double carried_v2_3_by_z20_by_V = t22*v1_2_on_boundary_by_z20_by_V + t31*z1_2_on_boundary_by_z20_by_V - t32*z2_2_on_boundary_by_z20_by_V;
    /* d/dz10 of: rate of the exit boundary after tau1 */
    const double t221 = chi*z2_3_by_z10;
    const double rate_3_by_z10 = t221 - z1_3_by_z10;
    /* d/dz20 of: rate of the exit boundary after tau1 */
    const double t222 = chi*z2_3_by_z20;
    const double rate_3_by_z20 = t222 - z1_3_by_z20;
    /* d/dtau of: rate of the exit boundary after tau1 */
    const double t223 = chi*z2_3_by_tau;
    const double rate_3_by_tau = t223 - z1_3_by_tau;
    /* d/dtau1 of: rate of the exit boundary after tau1 */
    const double t224 = chi*z2_3_by_tau1;
    const double rate_3_by_tau1 = t224 - z1_3_by_tau1;
    /* d/dchi of: rate of the exit boundary after tau1 */
    const double t225 = chi*z2_3_by_chi;
    const double rate_3_by_chi = t225 - z1_3_by_chi + z2_3;
    /* d/deta of: rate of the exit boundary after tau1 */
    const double t226 = chi*z2_3_by_eta;
    const double rate_3_by_eta = t226 - z1_3_by_eta;
    /* d/dV of: rate of the exit boundary after tau1 */
    const double t227 = chi*z2_3_by_V;
    const double rate_3_by_V = t227 - z1_3_by_V;
    /* d/dz10 of: derivatives of the time to the boundary after tau1 */
    const double t228 = (1.0/(rate_3*rate_3));
    const double t229 = rate_3_by_z10*t228;
    const double delay_tau1_by_z10_by_z10 = carried_v1_3_by_z10*t229 - carried_v1_3_by_z10_by_z10*t58;
    const double delay_tau1_by_z20_by_z10 = carried_v1_3_by_z20*t229 - carried_v1_3_by_z20_by_z10*t58;
    /* d/dz20 of: derivatives of the time to the boundary after tau1 */
    const double t230 = rate_3_by_z20*t228;
    const double delay_tau1_by_z10_by_z20 = carried_v1_3_by_z10*t230 - carried_v1_3_by_z10_by_z20*t58;
    const double delay_tau1_by_z20_by_z20 = carried_v1_3_by_z20*t230 - carried_v1_3_by_z20_by_z20*t58;
    /* d/dtau of: derivatives of the time to the boundary after tau1 */
    const double t231 = rate_3_by_tau*t228;
    const double delay_tau1_by_z10_by_tau = carried_v1_3_by_z10*t231 - carried_v1_3_by_z10_by_tau*t58;
    const double delay_tau1_by_z20_by_tau = carried_v1_3_by_z20*t231 - carried_v1_3_by_z20_by_tau*t58;
    /* d/dtau1 of: derivatives of the time to the boundary after tau1 */
    const double t232 = rate_3_by_tau1*t228;
    const double delay_tau1_by_z10_by_tau1 = carried_v1_3_by_z10*t232 - carried_v1_3_by_z10_by_tau1*t58;
    const double delay_tau1_by_z20_by_tau1 = carried_v1_3_by_z20*t232 - carried_v1_3_by_z20_by_tau1*t58;
    /* d/dchi of: derivatives of the time to the boundary after tau1 */
    const double t233 = rate_3_by_chi*t228;
    const double delay_tau1_by_z10_by_chi = carried_v1_3_by_z10*t233 - carried_v1_3_by_z10_by_chi*t58;
    const double delay_tau1_by_z20_by_chi = carried_v1_3_by_z20*t233 - carried_v1_3_by_z20_by_chi*t58;
    /* d/deta of: derivatives of the time to the boundary after tau1 */
    const double t234 = rate_3_by_eta*t228;
    const double delay_tau1_by_z10_by_eta = carried_v1_3_by_z10*t234 - carried_v1_3_by_z10_by_eta*t58;
    const double delay_tau1_by_z20_by_eta = carried_v1_3_by_z20*t234 - carried_v1_3_by_z20_by_eta*t58;
    /* d/dV of: derivatives of the time to the boundary after tau1 */
    const double t235 = rate_3_by_V*t228;
    const double delay_tau1_by_z10_by_V = carried_v1_3_by_z10*t235 - carried_v1_3_by_z10_by_V*t58;
    const double delay_tau1_by_z20_by_V = carried_v1_3_by_z20*t235 - carried_v1_3_by_z20_by_V*t58;
    /* d/dz10 of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_z10 = carried_z1_3_by_z10_by_z10 + delay_tau1_by_z10*v1_3_by_z10 + delay_tau1_by_z10_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20_by_z10 = carried_z1_3_by_z20_by_z10 + delay_tau1_by_z20*v1_3_by_z10 + delay_tau1_by_z20_by_z10*v1_3;
    const double z2_3_on_boundary_by_z10_by_z10 = carried_z2_3_by_z10_by_z10 + delay_tau1_by_z10*v2_3_by_z10 + delay_tau1_by_z10_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20_by_z10 = carried_z2_3_by_z20_by_z10 + delay_tau1_by_z20*v2_3_by_z10 + delay_tau1_by_z20_by_z10*v2_3;
    const double t236 = chi*eta;
    const double t237 = t236*z1_3_by_z10;
    const double t238 = eta*t221;
    const double v2_3_on_boundary_by_z10_by_z10 = carried_v2_3_by_z10_by_z10 + delay_tau1_by_z10*t237 - delay_tau1_by_z10*t238 + delay_tau1_by_z10_by_z10*t60;
    const double v2_3_on_boundary_by_z20_by_z10 = carried_v2_3_by_z20_by_z10 + delay_tau1_by_z20*t237 - delay_tau1_by_z20*t238 + delay_tau1_by_z20_by_z10*t60;
    /* d/dz20 of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_z20 = carried_z1_3_by_z10_by_z20 + delay_tau1_by_z10*v1_3_by_z20 + delay_tau1_by_z10_by_z20*v1_3;
    const double z1_3_on_boundary_by_z20_by_z20 = carried_z1_3_by_z20_by_z20 + delay_tau1_by_z20*v1_3_by_z20 + delay_tau1_by_z20_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10_by_z20 = carried_z2_3_by_z10_by_z20 + delay_tau1_by_z10*v2_3_by_z20 + delay_tau1_by_z10_by_z20*v2_3;
    const double z2_3_on_boundary_by_z20_by_z20 = carried_z2_3_by_z20_by_z20 + delay_tau1_by_z20*v2_3_by_z20 + delay_tau1_by_z20_by_z20*v2_3;
    const double t239 = t236*z1_3_by_z20;
    const double t240 = eta*t222;
    const double v2_3_on_boundary_by_z10_by_z20 = carried_v2_3_by_z10_by_z20 + delay_tau1_by_z10*t239 - delay_tau1_by_z10*t240 + delay_tau1_by_z10_by_z20*t60;
    const double v2_3_on_boundary_by_z20_by_z20 = carried_v2_3_by_z20_by_z20 + delay_tau1_by_z20*t239 - delay_tau1_by_z20*t240 + delay_tau1_by_z20_by_z20*t60;
    /* d/dtau of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_tau = carried_z1_3_by_z10_by_tau + delay_tau1_by_z10*v1_3_by_tau + delay_tau1_by_z10_by_tau*v1_3;
    const double z1_3_on_boundary_by_z20_by_tau = carried_z1_3_by_z20_by_tau + delay_tau1_by_z20*v1_3_by_tau + delay_tau1_by_z20_by_tau*v1_3;
    const double z2_3_on_boundary_by_z10_by_tau = carried_z2_3_by_z10_by_tau + delay_tau1_by_z10*v2_3_by_tau + delay_tau1_by_z10_by_tau*v2_3;
    const double z2_3_on_boundary_by_z20_by_tau = carried_z2_3_by_z20_by_tau + delay_tau1_by_z20*v2_3_by_tau + delay_tau1_by_z20_by_tau*v2_3;
    const double t241 = t236*z1_3_by_tau;
    const double t242 = eta*t223;
    const double v2_3_on_boundary_by_z10_by_tau = carried_v2_3_by_z10_by_tau + delay_tau1_by_z10*t241 - delay_tau1_by_z10*t242 + delay_tau1_by_z10_by_tau*t60;
    const double v2_3_on_boundary_by_z20_by_tau = carried_v2_3_by_z20_by_tau + delay_tau1_by_z20*t241 - delay_tau1_by_z20*t242 + delay_tau1_by_z20_by_tau*t60;
    /* d/dtau1 of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_tau1 = carried_z1_3_by_z10_by_tau1 + delay_tau1_by_z10*v1_3_by_tau1 + delay_tau1_by_z10_by_tau1*v1_3;
    const double z1_3_on_boundary_by_z20_by_tau1 = carried_z1_3_by_z20_by_tau1 + delay_tau1_by_z20*v1_3_by_tau1 + delay_tau1_by_z20_by_tau1*v1_3;
    const double z2_3_on_boundary_by_z10_by_tau1 = carried_z2_3_by_z10_by_tau1 + delay_tau1_by_z10*v2_3_by_tau1 + delay_tau1_by_z10_by_tau1*v2_3;
    const double z2_3_on_boundary_by_z20_by_tau1 = carried_z2_3_by_z20_by_tau1 + delay_tau1_by_z20*v2_3_by_tau1 + delay_tau1_by_z20_by_tau1*v2_3;
    const double t243 = t236*z1_3_by_tau1;
    const double t244 = eta*t224;
    const double v2_3_on_boundary_by_z10_by_tau1 = carried_v2_3_by_z10_by_tau1 + delay_tau1_by_z10*t243 - delay_tau1_by_z10*t244 + delay_tau1_by_z10_by_tau1*t60;
    const double v2_3_on_boundary_by_z20_by_tau1 = carried_v2_3_by_z20_by_tau1 + delay_tau1_by_z20*t243 - delay_tau1_by_z20*t244 + delay_tau1_by_z20_by_tau1*t60;
    /* d/dchi of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_chi = carried_z1_3_by_z10_by_chi + delay_tau1_by_z10*v1_3_by_chi + delay_tau1_by_z10_by_chi*v1_3;
    const double z1_3_on_boundary_by_z20_by_chi = carried_z1_3_by_z20_by_chi + delay_tau1_by_z20*v1_3_by_chi + delay_tau1_by_z20_by_chi*v1_3;
    const double z2_3_on_boundary_by_z10_by_chi = carried_z2_3_by_z10_by_chi + delay_tau1_by_z10*v2_3_by_chi + delay_tau1_by_z10_by_chi*v2_3;
    const double z2_3_on_boundary_by_z20_by_chi = carried_z2_3_by_z20_by_chi + delay_tau1_by_z20*v2_3_by_chi + delay_tau1_by_z20_by_chi*v2_3;
    const double t245 = -eta*z2_3 + t59;
    const double t246 = t236*z1_3_by_chi;
    const double t247 = eta*t225;
    const double v2_3_on_boundary_by_z10_by_chi = carried_v2_3_by_z10_by_chi + delay_tau1_by_z10*t245 + delay_tau1_by_z10*t246 - delay_tau1_by_z10*t247 + delay_tau1_by_z10_by_chi*t60;
    const double v2_3_on_boundary_by_z20_by_chi = carried_v2_3_by_z20_by_chi + delay_tau1_by_z20*t245 + delay_tau1_by_z20*t246 - delay_tau1_by_z20*t247 + delay_tau1_by_z20_by_chi*t60;
    /* d/deta of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_eta = carried_z1_3_by_z10_by_eta + delay_tau1_by_z10*v1_3_by_eta + delay_tau1_by_z10_by_eta*v1_3;
    const double z1_3_on_boundary_by_z20_by_eta = carried_z1_3_by_z20_by_eta + delay_tau1_by_z20*v1_3_by_eta + delay_tau1_by_z20_by_eta*v1_3;
    const double z2_3_on_boundary_by_z10_by_eta = carried_z2_3_by_z10_by_eta + delay_tau1_by_z10*v2_3_by_eta + delay_tau1_by_z10_by_eta*v2_3;
    const double z2_3_on_boundary_by_z20_by_eta = carried_z2_3_by_z20_by_eta + delay_tau1_by_z20*v2_3_by_eta + delay_tau1_by_z20_by_eta*v2_3;
    const double t248 = chi*z1_3 - t57;
    const double t249 = t236*z1_3_by_eta;
    const double t250 = eta*t226;
    const double v2_3_on_boundary_by_z10_by_eta = carried_v2_3_by_z10_by_eta + delay_tau1_by_z10*t248 + delay_tau1_by_z10*t249 - delay_tau1_by_z10*t250 + delay_tau1_by_z10_by_eta*t60;
    const double v2_3_on_boundary_by_z20_by_eta = carried_v2_3_by_z20_by_eta + delay_tau1_by_z20*t248 + delay_tau1_by_z20*t249 - delay_tau1_by_z20*t250 + delay_tau1_by_z20_by_eta*t60;
    /* d/dV of: perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10_by_V = carried_z1_3_by_z10_by_V + delay_tau1_by_z10*v1_3_by_V + delay_tau1_by_z10_by_V*v1_3;
    const double z1_3_on_boundary_by_z20_by_V = carried_z1_3_by_z20_by_V + delay_tau1_by_z20*v1_3_by_V + delay_tau1_by_z20_by_V*v1_3;
    const double z2_3_on_boundary_by_z10_by_V = carried_z2_3_by_z10_by_V + delay_tau1_by_z10*v2_3_by_V + delay_tau1_by_z10_by_V*v2_3;
    const double z2_3_on_boundary_by_z20_by_V = carried_z2_3_by_z20_by_V + delay_tau1_by_z20*v2_3_by_V + delay_tau1_by_z20_by_V*v2_3;
    const double t251 = t236*z1_3_by_V;
    const double t252 = eta*t227;
    const double v2_3_on_boundary_by_z10_by_V = carried_v2_3_by_z10_by_V + delay_tau1_by_z10*t251 - delay_tau1_by_z10*t252 + delay_tau1_by_z10_by_V*t60;
    const double v2_3_on_boundary_by_z20_by_V = carried_v2_3_by_z20_by_V + delay_tau1_by_z20*t251 - delay_tau1_by_z20*t252 + delay_tau1_by_z20_by_V*t60;
    /* d/dz10 of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_z10 + t38*z1_3_on_boundary_by_z20_by_z10 + t40*v2_3_on_boundary_by_z20_by_z10;
    const double carried_v2_4_by_z10_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_z10 + t127*z1_3_on_boundary_by_z10_by_z10 - t127*z2_3_on_boundary_by_z10_by_z10;
    const double carried_v2_4_by_z20_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_z10 + t127*z1_3_on_boundary_by_z20_by_z10 - t127*z2_3_on_boundary_by_z20_by_z10;
    /* d/dz20 of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_z20 + t38*z1_3_on_boundary_by_z20_by_z20 + t40*v2_3_on_boundary_by_z20_by_z20;
    const double carried_v2_4_by_z10_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_z20 + t127*z1_3_on_boundary_by_z10_by_z20 - t127*z2_3_on_boundary_by_z10_by_z20;
    const double carried_v2_4_by_z20_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_z20 + t127*z1_3_on_boundary_by_z20_by_z20 - t127*z2_3_on_boundary_by_z20_by_z20;
    /* d/dtau of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_tau = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_tau + t38*z1_3_on_boundary_by_z20_by_tau + t40*v2_3_on_boundary_by_z20_by_tau;
    const double carried_v2_4_by_z10_by_tau = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_tau + t127*z1_3_on_boundary_by_z10_by_tau - t127*z2_3_on_boundary_by_z10_by_tau;
    const double carried_v2_4_by_z20_by_tau = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_tau + t127*z1_3_on_boundary_by_z20_by_tau - t127*z2_3_on_boundary_by_z20_by_tau;
    /* d/dtau1 of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_tau1 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_tau1 + t38*z1_3_on_boundary_by_z20_by_tau1 + t40*v2_3_on_boundary_by_z20_by_tau1;
    const double carried_v2_4_by_z10_by_tau1 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_tau1 + t127*z1_3_on_boundary_by_z10_by_tau1 - t127*z2_3_on_boundary_by_z10_by_tau1;
    const double carried_v2_4_by_z20_by_tau1 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_tau1 + t127*z1_3_on_boundary_by_z20_by_tau1 - t127*z2_3_on_boundary_by_z20_by_tau1;
    /* d/dtau2 of: Phi along tau2 */
    const double t253 = -z1_3_on_boundary_by_z20 + z2_3_on_boundary_by_z20;
    const double t254 = t39*v2_3_on_boundary_by_z20;
    const double carried_z2_4_by_z20_by_tau2 = cos_omega3_tau2_by_tau2*t253 + sin_omega3_tau2_by_tau2*t254;
    const double t255 = t61 - t62;
    const double carried_v2_4_by_z10_by_tau2 = cos_omega3_tau2_by_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2_by_tau2*t255;
    const double t256 = t63 - t64;
    const double carried_v2_4_by_z20_by_tau2 = cos_omega3_tau2_by_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2_by_tau2*t256;
    /* d/dchi of: Phi along tau2 */
    const double t257 = t132*v2_3_on_boundary_by_z20;
    const double carried_z2_4_by_z20_by_chi = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_chi + cos_omega3_tau2_by_chi*t253 - omega3_by_chi*t257 + sin_omega3_tau2_by_chi*t254 + t38*z1_3_on_boundary_by_z20_by_chi + t40*v2_3_on_boundary_by_z20_by_chi;
    const double t258 = sin_omega3_tau2*z1_3_on_boundary_by_z10 - sin_omega3_tau2*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z10_by_chi = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_chi + cos_omega3_tau2_by_chi*v2_3_on_boundary_by_z10 + omega3_by_chi*t258 + sin_omega3_tau2_by_chi*t255 + t127*z1_3_on_boundary_by_z10_by_chi - t127*z2_3_on_boundary_by_z10_by_chi;
    const double t259 = sin_omega3_tau2*z1_3_on_boundary_by_z20 - sin_omega3_tau2*z2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z20_by_chi = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_chi + cos_omega3_tau2_by_chi*v2_3_on_boundary_by_z20 + omega3_by_chi*t259 + sin_omega3_tau2_by_chi*t256 + t127*z1_3_on_boundary_by_z20_by_chi - t127*z2_3_on_boundary_by_z20_by_chi;
    /* d/deta of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_eta = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_eta + cos_omega3_tau2_by_eta*t253 - omega3_by_eta*t257 + sin_omega3_tau2_by_eta*t254 + t38*z1_3_on_boundary_by_z20_by_eta + t40*v2_3_on_boundary_by_z20_by_eta;
    const double carried_v2_4_by_z10_by_eta = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_eta + cos_omega3_tau2_by_eta*v2_3_on_boundary_by_z10 + omega3_by_eta*t258 + sin_omega3_tau2_by_eta*t255 + t127*z1_3_on_boundary_by_z10_by_eta - t127*z2_3_on_boundary_by_z10_by_eta;
    const double carried_v2_4_by_z20_by_eta = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_eta + cos_omega3_tau2_by_eta*v2_3_on_boundary_by_z20 + omega3_by_eta*t259 + sin_omega3_tau2_by_eta*t256 + t127*z1_3_on_boundary_by_z20_by_eta - t127*z2_3_on_boundary_by_z20_by_eta;
    /* d/dV of: Phi along tau2 */
    const double carried_z2_4_by_z20_by_V = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_V + t38*z1_3_on_boundary_by_z20_by_V + t40*v2_3_on_boundary_by_z20_by_V;
    const double carried_v2_4_by_z10_by_V = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_V + t127*z1_3_on_boundary_by_z10_by_V - t127*z2_3_on_boundary_by_z10_by_V;
    const double carried_v2_4_by_z20_by_V = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_V + t127*z1_3_on_boundary_by_z20_by_V - t127*z2_3_on_boundary_by_z20_by_V;
    /* d/dz10 of: rate of the exit boundary after tau2 */
    const double rate_4_by_z10 = -t236*z2_4_by_z10 + t237;
    /* d/dz20 of: rate of the exit boundary after tau2 */
    const double rate_4_by_z20 = -t236*z2_4_by_z20 + t239;
    /* d/dtau of: rate of the exit boundary after tau2 */
    const double rate_4_by_tau = -t236*z2_4_by_tau + t241;
    /* d/dtau1 of: rate of the exit boundary after tau2 */
    const double rate_4_by_tau1 = -t236*z2_4_by_tau1 + t243;
    /* d/dtau2 of: rate of the exit boundary after tau2 */
    const double rate_4_by_tau2 = eta*t45 - t236*z2_4_by_tau2;
    /* d/dchi of: rate of the exit boundary after tau2 */
    const double rate_4_by_chi = -t236*z2_4_by_chi + t246 + t65 - t66;
    /* d/deta of: rate of the exit boundary after tau2 */
    const double rate_4_by_eta = chi*z1_4 - chi*z2_4 - t236*z2_4_by_eta + t249;
    /* d/dV of: rate of the exit boundary after tau2 */
    const double rate_4_by_V = t236*z1_4_by_V - t236*z2_4_by_V;
    /* d/dz10 of: derivatives of the time to the boundary after tau2 */
    const double t260 = (1.0/(rate_4*rate_4));
    const double t261 = rate_4_by_z10*t260;
    const double delay_tau2_by_z10_by_z10 = carried_v2_4_by_z10*t261 - carried_v2_4_by_z10_by_z10*t67;
    const double delay_tau2_by_z20_by_z10 = carried_v2_4_by_z20*t261 - carried_v2_4_by_z20_by_z10*t67;
    /* d/dz20 of: derivatives of the time to the boundary after tau2 */
    const double t262 = rate_4_by_z20*t260;
    const double delay_tau2_by_z10_by_z20 = carried_v2_4_by_z10*t262 - carried_v2_4_by_z10_by_z20*t67;
    const double delay_tau2_by_z20_by_z20 = carried_v2_4_by_z20*t262 - carried_v2_4_by_z20_by_z20*t67;
    /* d/dtau of: derivatives of the time to the boundary after tau2 */
    const double t263 = rate_4_by_tau*t260;
    const double delay_tau2_by_z10_by_tau = carried_v2_4_by_z10*t263 - carried_v2_4_by_z10_by_tau*t67;
    const double delay_tau2_by_z20_by_tau = carried_v2_4_by_z20*t263 - carried_v2_4_by_z20_by_tau*t67;
    /* d/dtau1 of: derivatives of the time to the boundary after tau2 */
    const double t264 = rate_4_by_tau1*t260;
    const double delay_tau2_by_z10_by_tau1 = carried_v2_4_by_z10*t264 - carried_v2_4_by_z10_by_tau1*t67;
    const double delay_tau2_by_z20_by_tau1 = carried_v2_4_by_z20*t264 - carried_v2_4_by_z20_by_tau1*t67;
    /* d/dtau2 of: derivatives of the time to the boundary after tau2 */
    const double t265 = rate_4_by_tau2*t260;
    const double delay_tau2_by_z10_by_tau2 = carried_v2_4_by_z10*t265 - carried_v2_4_by_z10_by_tau2*t67;
    const double delay_tau2_by_z20_by_tau2 = carried_v2_4_by_z20*t265 - carried_v2_4_by_z20_by_tau2*t67;
    /* d/dchi of: derivatives of the time to the boundary after tau2 */
    const double t266 = rate_4_by_chi*t260;
    const double delay_tau2_by_z10_by_chi = carried_v2_4_by_z10*t266 - carried_v2_4_by_z10_by_chi*t67;
    const double delay_tau2_by_z20_by_chi = carried_v2_4_by_z20*t266 - carried_v2_4_by_z20_by_chi*t67;
    /* d/deta of: derivatives of the time to the boundary after tau2 */
    const double t267 = rate_4_by_eta*t260;
    const double delay_tau2_by_z10_by_eta = carried_v2_4_by_z10*t267 - carried_v2_4_by_z10_by_eta*t67;
    const double delay_tau2_by_z20_by_eta = carried_v2_4_by_z20*t267 - carried_v2_4_by_z20_by_eta*t67;
    /* d/dV of: derivatives of the time to the boundary after tau2 */
    const double t268 = rate_4_by_V*t260;
    const double delay_tau2_by_z10_by_V = carried_v2_4_by_z10*t268 - carried_v2_4_by_z10_by_V*t67;
    const double delay_tau2_by_z20_by_V = carried_v2_4_by_z20*t268 - carried_v2_4_by_z20_by_V*t67;
    /* d/dz10 of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_z10 = V*delay_tau2_by_z10_by_z10 + z1_3_on_boundary_by_z10_by_z10;
    const double z2_4_on_boundary_by_z20_by_z10 = carried_z2_4_by_z20_by_z10 + delay_tau2_by_z20*v2_4_by_z10 + delay_tau2_by_z20_by_z10*v2_4;
    /* d/dz20 of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_z20 = V*delay_tau2_by_z10_by_z20 + z1_3_on_boundary_by_z10_by_z20;
    const double z2_4_on_boundary_by_z20_by_z20 = carried_z2_4_by_z20_by_z20 + delay_tau2_by_z20*v2_4_by_z20 + delay_tau2_by_z20_by_z20*v2_4;
    /* d/dtau of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_tau = V*delay_tau2_by_z10_by_tau + z1_3_on_boundary_by_z10_by_tau;
    const double z2_4_on_boundary_by_z20_by_tau = carried_z2_4_by_z20_by_tau + delay_tau2_by_z20*v2_4_by_tau + delay_tau2_by_z20_by_tau*v2_4;
    /* d/dtau1 of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_tau1 = V*delay_tau2_by_z10_by_tau1 + z1_3_on_boundary_by_z10_by_tau1;
    const double z2_4_on_boundary_by_z20_by_tau1 = carried_z2_4_by_z20_by_tau1 + delay_tau2_by_z20*v2_4_by_tau1 + delay_tau2_by_z20_by_tau1*v2_4;
    /* d/dtau2 of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_tau2 = V*delay_tau2_by_z10_by_tau2;
    const double z2_4_on_boundary_by_z20_by_tau2 = carried_z2_4_by_z20_by_tau2 + delay_tau2_by_z20*v2_4_by_tau2 + delay_tau2_by_z20_by_tau2*v2_4;
    /* d/dchi of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_chi = V*delay_tau2_by_z10_by_chi + z1_3_on_boundary_by_z10_by_chi;
    const double z2_4_on_boundary_by_z20_by_chi = carried_z2_4_by_z20_by_chi + delay_tau2_by_z20*v2_4_by_chi + delay_tau2_by_z20_by_chi*v2_4;
    /* d/deta of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_eta = V*delay_tau2_by_z10_by_eta + z1_3_on_boundary_by_z10_by_eta;
    const double z2_4_on_boundary_by_z20_by_eta = carried_z2_4_by_z20_by_eta + delay_tau2_by_z20*v2_4_by_eta + delay_tau2_by_z20_by_eta*v2_4;
    /* d/dV of: perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10_by_V = V*delay_tau2_by_z10_by_V + delay_tau2_by_z10 + z1_3_on_boundary_by_z10_by_V;
    const double z2_4_on_boundary_by_z20_by_V = carried_z2_4_by_z20_by_V + delay_tau2_by_z20*v2_4_by_V + delay_tau2_by_z20_by_V*v2_4;
    trace_gradient[0] = z1_4_on_boundary_by_z10_by_z10 + z2_4_on_boundary_by_z20_by_z10;
    trace_gradient[1] = z1_4_on_boundary_by_z10_by_z20 + z2_4_on_boundary_by_z20_by_z20;
    trace_gradient[2] = z1_4_on_boundary_by_z10_by_tau + z2_4_on_boundary_by_z20_by_tau;
    trace_gradient[3] = z1_4_on_boundary_by_z10_by_tau1 + z2_4_on_boundary_by_z20_by_tau1;
    trace_gradient[4] = z1_4_on_boundary_by_z10_by_tau2 + z2_4_on_boundary_by_z20_by_tau2;
    trace_gradient[5] = 0;
    trace_gradient[6] = z1_4_on_boundary_by_z10_by_chi + z2_4_on_boundary_by_z20_by_chi;
    trace_gradient[7] = z1_4_on_boundary_by_z10_by_eta + z2_4_on_boundary_by_z20_by_eta;
    trace_gradient[8] = z1_4_on_boundary_by_z10_by_V + z2_4_on_boundary_by_z20_by_V;
    trace_gradient[9] = 0;
}

/* State at the start and behind each transition, row by row.
 * Takes parameters (4), spectrum (7), unknowns (6); gives states (5, 4), row by row.
 * Operations: 105. Intermediate terms: 29. */
void dry_friction_solution_ii_states(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double states[20])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
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
    const double t4 = (1.0/(omega1));
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t7 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + v1_2*(p1*t5 + t6*t7) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t6) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t8 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t9 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t8*z1_2 + t9*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7);
    const double t10 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t9 + t8*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t10) + z2_2*(-omega2*p1*sin_omega2_tau1 - t10*t6);
    /* functions of tau2 in stick-slip */
    const double t11 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t11);
    const double sin_omega3_tau2 = sin(t11);
    /* stick-slip for tau2, until second-reaches-belt */
    const double z1_4 = V*tau2 + z1_3;
    const double t12 = sin_omega3_tau2/omega3;
    const double z2_4 = V*(-t12 + tau2) + cos_omega3_tau2*z2_3 + t12*v2_3 + z1_3*(1 - cos_omega3_tau2);
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

/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.
 * Takes parameters (4), spectrum (7), unknowns (6); gives coefficients (44), frequencies (4), row by row.
 * Operations: 171. Intermediate terms: 43. */
void dry_friction_solution_ii_boundary_functions(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double coefficients[44], double frequencies[4])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double z10 = unknowns[0];
    const double z20 = unknowns[1];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double e1 = unknowns[5];
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
    const double t4 = (1.0/(omega1));
    const double t5 = sin_omega1_tau1*t4;
    const double t6 = 1 - p1;
    const double t7 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + v1_2*(p1*t5 + t6*t7) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t6) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t8 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t9 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t7 + t5*t6) + t8*z1_2 + t9*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7);
    const double t10 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t9 + t8*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t10) + z2_2*(-omega2*p1*sin_omega2_tau1 - t10*t6);
    /* outputs */
    const double t11 = chi*z20;
    const double t12 = t11 - z10;
    const double t14 = V*chi;
    const double t15 = -V + t14;
    const double t18 = chi*z10;
    const double t19 = e2 - t11;
    const double t20 = e2 + t11;
    const double t21 = (chi*chi);
    const double t22 = t21*z20;
    const double t23 = V*t21 - t14;
    const double t24 = -chi*t12;
    const double t25 = -chi*t15;
    const double t26 = V*p2;
    const double t27 = omega1*z1_2;
    const double t28 = p2*z2_2;
    const double t29 = p3*v1_2;
    const double t30 = chi*z1_3;
    const double t31 = chi*(-z1_3 + z2_3);
    const double t32 = (1.0/(omega3));
    const double t33 = chi*(-V*t32 + t32*v2_3);
    coefficients[0] = -e1 - t12;
    coefficients[1] = -t15;
    coefficients[2] = -e1 + t11 - z10;
    coefficients[3] = t15;
    coefficients[4] = -t18 - t19;
    coefficients[5] = 0;
    coefficients[6] = t18 - t20;
    coefficients[7] = 0;
    coefficients[8] = t15;
    coefficients[9] = 0;
    coefficients[10] = -t15;
    coefficients[11] = t12;
    coefficients[12] = -t19 - t22;
    coefficients[13] = -t23;
    coefficients[14] = -t24;
    coefficients[15] = -t25;
    coefficients[16] = -t20 + t22;
    coefficients[17] = t23;
    coefficients[18] = t24;
    coefficients[19] = t25;
    coefficients[20] = -V;
    coefficients[21] = 0;
    coefficients[22] = p1*v1_2 + t26;
    coefficients[23] = -t26 + t6*v1_2;
    coefficients[24] = -omega1*t28 - p1*t27;
    coefficients[25] = omega2*t28 - omega2*t6*z1_2;
    coefficients[26] = -V;
    coefficients[27] = 0;
    coefficients[28] = V*t6 + t29;
    coefficients[29] = V*p1 - t29;
    coefficients[30] = -omega1*t6*z2_2 - p3*t27;
    coefficients[31] = -omega2*p1*z2_2 + omega2*p3*z1_2;
    coefficients[32] = -e1 - t30 + z1_3;
    coefficients[33] = -t15;
    coefficients[34] = -t31;
    coefficients[35] = -t33;
    coefficients[36] = -e1 + t30 - z1_3;
    coefficients[37] = t15;
    coefficients[38] = t31;
    coefficients[39] = t33;
    coefficients[40] = 0;
    coefficients[41] = 0;
    coefficients[42] = -V + v2_3;
    coefficients[43] = omega3*z1_3 - omega3*z2_3;
    frequencies[0] = 1;
    frequencies[1] = omega1;
    frequencies[2] = omega2;
    frequencies[3] = omega3;
}

/* State after a time in stick-stick.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 4. Intermediate terms: 0. */
void dry_friction_solution_ii_flow_stick_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    (void)spectrum;
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    state_after[0] = t*v1 + z1;
    state_after[1] = t*v2 + z2;
    state_after[2] = v1;
    state_after[3] = v2;
}

/* State after a time in slip-stick.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 23. Intermediate terms: 4. */
void dry_friction_solution_ii_flow_slip_stick(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    const double chi = parameters[0];
    (void)spectrum;
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = sin(t);
    const double t1 = chi*t0;
    const double t2 = cos(t);
    const double t3 = -chi*t2 + chi;
    state_after[0] = t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1);
    state_after[1] = t*v2 + z2;
    state_after[2] = -t0*z1 + t1*z2 + t2*v1 + t3*v2;
    state_after[3] = v2;
}

/* State after a time in slip-slip.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 82. Intermediate terms: 16. */
void dry_friction_solution_ii_flow_slip_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/(omega1));
    const double t1 = omega1*t;
    const double t2 = sin(t1);
    const double t3 = t0*t2;
    const double t4 = 1 - p1;
    const double t5 = omega2*t;
    const double t6 = sin(t5);
    const double t7 = t6/omega2;
    const double t8 = cos(t1);
    const double t9 = cos(t5);
    const double t10 = p1*t8 + t4*t9;
    const double t11 = p2*t8 - p2*t9;
    const double t12 = p3*t8 - p3*t9;
    const double t13 = p1*t9 + t4*t8;
    const double t14 = omega2*t6;
    const double t15 = omega1*t2;
    state_after[0] = t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7);
    state_after[1] = t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15);
    state_after[3] = t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4);
}

/* State after a time in stick-slip.
 * Takes parameters (4), spectrum (7), time, state (4); gives state_after (4), row by row.
 * Operations: 23. Intermediate terms: 6. */
void dry_friction_solution_ii_flow_stick_slip(
    const double parameters[4], const double spectrum[7], double time, const double state[4], double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[6];
    const double t = time;
    const double z1 = state[0];
    const double z2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = omega3*t;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = cos(t0);
    const double t4 = 1 - t3;
    const double t5 = omega3*t1;
    state_after[0] = t*v1 + z1;
    state_after[1] = t2*v2 + t3*z2 + t4*z1 + v1*(t - t2);
    state_after[2] = v1;
    state_after[3] = t3*v2 + t4*v1 + t5*z1 - t5*z2;
}

/* Reduced equations and their derivatives by the reduced unknowns.
 * Takes parameters (4), spectrum (7), reduced (3); gives residual (3), jacobian (3, 3), row by row.
 * Operations: 303. Intermediate terms: 99. */
void dry_friction_solution_ii_reduced(
    const double parameters[4], const double spectrum[7], const double reduced[3], double residual[3], double jacobian[9])
{
    const double chi = parameters[0];
    const double eta = parameters[1];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    const double e1 = reduced[2];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t2 = V*tau;
    const double t3 = (1.0/((chi - 1)));
    const double t4 = cos_tau*t3;
    const double z2_1 = V*sin_tau - e1*t4 - t2 - e2*t3/chi;
    /* slip-stick for tau */
    const double t5 = chi*z2_1;
    const double t6 = e1 + t5;
    const double t7 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t6 + t7*z2_1;
    const double z2_2 = t2 + z2_1;
    const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
    /* functions of tau1 in slip-slip */
    const double t8 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t8);
    const double sin_omega1_tau1 = sin(t8);
    const double t9 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t9);
    const double sin_omega2_tau1 = sin(t9);
    /* slip-slip for tau1 */
    const double t10 = (1.0/(omega1));
    const double t13 = sin_omega2_tau1/omega2;
    const double t11 = sin_omega1_tau1*t10;
    const double t12 = 1 - p1;
    const double t14 = p1*t11 + t12*t13;
    const double t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12;
    const double t16 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t10 - p2*t13) + t14*v1_2 + t15*z1_2 + t16*z2_2;
    const double t17 = p3*sin_omega1_tau1*t10 - p3*t13;
    const double t18 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t19 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t13 + t11*t12) + t17*v1_2 + t18*z1_2 + t19*z2_2;
    const double t20 = omega2*sin_omega2_tau1;
    const double t21 = omega1*sin_omega1_tau1;
    const double t22 = -p1*t21 - t12*t20;
    const double t23 = omega2*p2*sin_omega2_tau1 - p2*t21;
    const double v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2;
    const double t24 = omega2*p3*sin_omega2_tau1 - p3*t21;
    const double t25 = -p1*t20 - t12*t21;
    const double v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2;
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* first return of tau2 */
    const double t26 = (1.0/(amplitude_tau2));
    const double cos_tau2_return = sine_part_tau2*t26;
    const double sin_tau2_return = -cosine_part_tau2*t26;
    /* tau2: first return */
    const double t27 = (1.0/(omega3));
    const double tau2 = t27*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
    /* stick-stick for no time */
    const double z1_5 = V*tau2 + sine_part_tau2*t27 + z2_3;
    const double z2_5 = -amplitude_tau2*t27 + z1_5;
    /* d/dtau of: functions of tau in slip-stick */
    const double cos_tau_by_tau = -sin_tau;
    const double sin_tau_by_tau = cos_tau;
    /* d/dtau of: z2_1: linear in second-breaks-forward */
    const double t29 = cos_tau_by_tau*e1;
    const double z2_1_by_tau = V*sin_tau_by_tau - V - t29*t3;
    /* d/de1 of: z2_1: linear in second-breaks-forward */
    const double z2_1_by_e1 = -t4;
    /* d/dtau of: slip-stick for tau */
    const double t30 = V*chi;
    const double t31 = V - t30;
    const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t31 + t29 + t30;
    const double z2_2_by_tau = V + z2_1_by_tau;
    const double v1_2_by_tau = cos_tau_by_tau*t31 - e1*sin_tau_by_tau;
    /* d/de1 of: slip-stick for tau */
    const double z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau;
    const double v1_2_by_e1 = -sin_tau;
    /* d/dtau of: slip-slip for tau1 */
    const double z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau;
    const double z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau;
    const double v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau;
    const double v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau;
    /* d/dtau1 of: slip-slip for tau1 */
    const double t32 = chi*z2_3;
    const double v1_3_by_tau1 = t32 - z1_3;
    const double v2_3_by_tau1 = chi*eta*z1_3 - eta*t32;
    /* d/de1 of: slip-slip for tau1 */
    const double z1_3_by_e1 = t14*v1_2_by_e1 + t15*z1_2_by_e1 + t16*z2_1_by_e1;
    const double z2_3_by_e1 = t17*v1_2_by_e1 + t18*z1_2_by_e1 + t19*z2_1_by_e1;
    const double v1_3_by_e1 = t15*v1_2_by_e1 + t22*z1_2_by_e1 + t23*z2_1_by_e1;
    const double v2_3_by_e1 = t18*v1_2_by_e1 + t24*z1_2_by_e1 + t25*z2_1_by_e1;
    /* d/dtau of: first return of tau2 */
    const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
    /* d/de1 of: first return of tau2 */
    const double sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1;
    /* d/dtau of: first return of tau2 */
    const double t33 = 2*cosine_part_tau2;
    const double t34 = 2*sine_part_tau2;
    const double t35 = (1.0/2.0)*t26;
    const double amplitude_tau2_by_tau = t35*(sine_part_tau2_by_tau*t34 + t33*v2_3_by_tau);
    /* d/dtau1 of: first return of tau2 */
    const double amplitude_tau2_by_tau1 = t35*(sine_part_tau2_by_tau1*t34 + t33*v2_3_by_tau1);
    /* d/de1 of: first return of tau2 */
    const double amplitude_tau2_by_e1 = t35*(sine_part_tau2_by_e1*t34 + t33*v2_3_by_e1);
    /* d/dtau of: first return of tau2 */
    const double t36 = (1.0/(amplitude_tau2*amplitude_tau2));
    const double cos_tau2_return_by_tau = -amplitude_tau2_by_tau*sine_part_tau2*t36 + sine_part_tau2_by_tau*t26;
    const double sin_tau2_return_by_tau = amplitude_tau2_by_tau*cosine_part_tau2*t36 - t26*v2_3_by_tau;
    /* d/dtau1 of: first return of tau2 */
    const double cos_tau2_return_by_tau1 = -amplitude_tau2_by_tau1*sine_part_tau2*t36 + sine_part_tau2_by_tau1*t26;
    const double sin_tau2_return_by_tau1 = amplitude_tau2_by_tau1*cosine_part_tau2*t36 - t26*v2_3_by_tau1;
    /* d/de1 of: first return of tau2 */
    const double cos_tau2_return_by_e1 = -amplitude_tau2_by_e1*sine_part_tau2*t36 + sine_part_tau2_by_e1*t26;
    const double sin_tau2_return_by_e1 = amplitude_tau2_by_e1*cosine_part_tau2*t36 - t26*v2_3_by_e1;
    /* d/dtau of: tau2: first return */
    const double t37 = t27/((cos_tau2_return*cos_tau2_return) + (sin_tau2_return*sin_tau2_return));
    const double t38 = cos_tau2_return*t37;
    const double t39 = sin_tau2_return*t37;
    const double tau2_by_tau = -cos_tau2_return_by_tau*t39 + sin_tau2_return_by_tau*t38;
    /* d/dtau1 of: tau2: first return */
    const double tau2_by_tau1 = -cos_tau2_return_by_tau1*t39 + sin_tau2_return_by_tau1*t38;
    /* d/de1 of: tau2: first return */
    const double tau2_by_e1 = -cos_tau2_return_by_e1*t39 + sin_tau2_return_by_e1*t38;
    /* d/dtau of: stick-stick for no time */
    const double z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t27 + z2_3_by_tau;
    const double z2_5_by_tau = -amplitude_tau2_by_tau*t27 + z1_5_by_tau;
    /* d/dtau1 of: stick-stick for no time */
    const double z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t27 + v2_3;
    const double z2_5_by_tau1 = -amplitude_tau2_by_tau1*t27 + z1_5_by_tau1;
    /* d/de1 of: stick-stick for no time */
    const double z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t27 + z2_3_by_e1;
    const double z2_5_by_e1 = -amplitude_tau2_by_e1*t27 + z1_5_by_e1;
    residual[0] = -V + v1_3;
    residual[1] = -chi*z2_5 - e1 + z1_5;
    residual[2] = -z2_1 + z2_5;
    jacobian[0] = v1_3_by_tau;
    jacobian[1] = v1_3_by_tau1;
    jacobian[2] = v1_3_by_e1;
    jacobian[3] = -chi*z2_5_by_tau + z1_5_by_tau;
    jacobian[4] = -chi*z2_5_by_tau1 + z1_5_by_tau1;
    jacobian[5] = -chi*z2_5_by_e1 + z1_5_by_e1 - 1;
    jacobian[6] = -z2_1_by_tau + z2_5_by_tau;
    jacobian[7] = z2_5_by_tau1;
    jacobian[8] = -z2_1_by_e1 + z2_5_by_e1;
}

/* All unknowns from the reduced ones.
 * Takes parameters (4), spectrum (7), reduced (3); gives unknowns (6), row by row.
 * Operations: 124. Intermediate terms: 36. */
void dry_friction_solution_ii_expand(
    const double parameters[4], const double spectrum[7], const double reduced[3], double unknowns[6])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = reduced[0];
    const double tau1 = reduced[1];
    const double e1 = reduced[2];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* z2_1: linear in second-breaks-forward */
    const double t0 = V*tau;
    const double t1 = (1.0/((chi - 1)));
    const double z2_1 = V*sin_tau - cos_tau*e1*t1 - t0 - e2*t1/chi;
    /* slip-stick for tau */
    const double t2 = chi*z2_1;
    const double t3 = e1 + t2;
    const double t4 = -chi*cos_tau + chi;
    const double z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t3 + t4*z2_1;
    const double z2_2 = t0 + z2_1;
    const double v1_2 = V*cos_tau + V*t4 + sin_tau*t2 - sin_tau*t3;
    /* functions of tau1 in slip-slip */
    const double t5 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t5);
    const double sin_omega1_tau1 = sin(t5);
    const double t6 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t6);
    const double sin_omega2_tau1 = sin(t6);
    /* slip-slip for tau1 */
    const double t7 = (1.0/(omega1));
    const double t8 = sin_omega1_tau1*t7;
    const double t9 = 1 - p1;
    const double t10 = sin_omega2_tau1/omega2;
    const double z1_3 = V*(p2*sin_omega1_tau1*t7 - p2*t10) + v1_2*(p1*t8 + t10*t9) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t9) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2);
    const double t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t12 = cos_omega1_tau1*t9 + cos_omega2_tau1*p1;
    const double z2_3 = V*(p1*t10 + t8*t9) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t7 - p3*t10);
    const double t13 = omega1*sin_omega1_tau1;
    const double v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-omega2*p1*sin_omega2_tau1 - t13*t9);
    /* first return of tau2 */
    const double cosine_part_tau2 = -V + v2_3;
    const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
    /* first return of tau2 */
    const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
    /* first return of tau2 */
    const double t14 = (1.0/(amplitude_tau2));
    const double cos_tau2_return = sine_part_tau2*t14;
    const double sin_tau2_return = -cosine_part_tau2*t14;
    /* tau2: first return */
    const double t15 = (1.0/(omega3));
    const double tau2 = t15*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
    /* outputs */
    const double t16 = V*tau2 + sine_part_tau2*t15 + z2_3;
    unknowns[0] = t16;
    unknowns[1] = -amplitude_tau2*t15 + t16;
    unknowns[2] = tau;
    unknowns[3] = tau1;
    unknowns[4] = tau2;
    unknowns[5] = e1;
}

/* Compatibility and switching conditions, the start, and the map [N, c] of a turn, all from the unknowns but the start.
 * Takes parameters (4), spectrum (7), unknowns (6); gives residual (4), start (2), map (4, 5), row by row.
 * Operations: 249. Intermediate terms: 79. */
void dry_friction_solution_ii_period_map(
    const double parameters[4], const double spectrum[7], const double unknowns[6], double residual[4], double start[2], double map[20])
{
    const double chi = parameters[0];
    const double V = parameters[2];
    const double e2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    const double tau = unknowns[2];
    const double tau1 = unknowns[3];
    const double tau2 = unknowns[4];
    const double e1 = unknowns[5];
    /* functions of tau in slip-stick */
    const double cos_tau = cos(tau);
    const double sin_tau = sin(tau);
    /* slip-stick after tau, by the start */
    const double z1_2_by_z20 = -chi*cos_tau + chi;
    const double t1 = chi*sin_tau;
    const double z1_2_by_v20 = chi*tau - t1;
    const double v1_2_by_z10 = -sin_tau;
    const double v1_2_by_z20 = t1;
    const double v1_2_by_v20 = z1_2_by_z20;
    /* functions of tau1 in slip-slip */
    const double t3 = omega1*tau1;
    const double cos_omega1_tau1 = cos(t3);
    const double sin_omega1_tau1 = sin(t3);
    const double t4 = omega2*tau1;
    const double cos_omega2_tau1 = cos(t4);
    const double sin_omega2_tau1 = sin(t4);
    /* slip-slip after tau1, by the start */
    const double t5 = 1 - p1;
    const double t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5;
    const double t7 = cos_tau*t6;
    const double t8 = (1.0/(omega1));
    const double t9 = sin_omega1_tau1*t8;
    const double t10 = sin_omega2_tau1/omega2;
    const double t11 = p1*t9 + t10*t5;
    const double z1_3_by_z10 = t11*v1_2_by_z10 + t7;
    const double t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
    const double z1_3_by_z20 = t11*v1_2_by_z20 + t12 + t6*z1_2_by_z20;
    const double z1_3_by_v10 = cos_tau*t11 + sin_tau*t6;
    const double z1_3_by_v20 = -p2*t10 + p2*t9 + t11*v1_2_by_v20 + t12*tau + t6*z1_2_by_v20;
    const double t13 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
    const double t14 = cos_tau*t13;
    const double t15 = p3*sin_omega1_tau1*t8 - p3*t10;
    const double z2_3_by_z10 = t14 + t15*v1_2_by_z10;
    const double t16 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1;
    const double z2_3_by_z20 = t13*z1_2_by_z20 + t15*v1_2_by_z20 + t16;
    const double z2_3_by_v10 = cos_tau*t15 + sin_tau*t13;
    const double z2_3_by_v20 = p1*t10 + t13*z1_2_by_v20 + t15*v1_2_by_v20 + t16*tau + t5*t9;
    const double t17 = omega2*sin_omega2_tau1;
    const double t18 = omega1*sin_omega1_tau1;
    const double t19 = -p1*t18 - t17*t5;
    const double v1_3_by_z10 = cos_tau*t19 + t6*v1_2_by_z10;
    const double t20 = p2*t18;
    const double v1_3_by_z20 = p2*t17 + t19*z1_2_by_z20 - t20 + t6*v1_2_by_z20;
    const double v1_3_by_v10 = sin_tau*t19 + t7;
    const double v1_3_by_v20 = t12 + t19*z1_2_by_v20 + t6*v1_2_by_v20 + tau*(omega2*p2*sin_omega2_tau1 - t20);
    const double t21 = omega2*p3*sin_omega2_tau1 - p3*t18;
    const double v2_3_by_z10 = cos_tau*t21 + t13*v1_2_by_z10;
    const double t22 = p1*t17 + t18*t5;
    const double v2_3_by_z20 = t13*v1_2_by_z20 + t21*z1_2_by_z20 - t22;
    const double v2_3_by_v10 = sin_tau*t21 + t14;
    const double v2_3_by_v20 = t13*v1_2_by_v20 + t16 + t21*z1_2_by_v20 - t22*tau;
    /* functions of tau2 in stick-slip */
    const double t23 = omega3*tau2;
    const double cos_omega3_tau2 = cos(t23);
    const double sin_omega3_tau2 = sin(t23);
    /* stick-slip after tau2, by the start */
    const double z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10;
    const double z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20;
    const double z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10;
    const double z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20;
    const double t24 = sin_omega3_tau2/omega3;
    const double t25 = -t24 + tau2;
    const double t26 = 1 - cos_omega3_tau2;
    const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t24*v2_3_by_z10 + t25*v1_3_by_z10 + t26*z1_3_by_z10;
    const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t24*v2_3_by_z20 + t25*v1_3_by_z20 + t26*z1_3_by_z20;
    const double z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t24*v2_3_by_v10 + t25*v1_3_by_v10 + t26*z1_3_by_v10;
    const double z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t24*v2_3_by_v20 + t25*v1_3_by_v20 + t26*z1_3_by_v20;
    const double t27 = omega3*sin_omega3_tau2;
    const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t26*v1_3_by_z10 + t27*z1_3_by_z10 - t27*z2_3_by_z10;
    const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t26*v1_3_by_z20 + t27*z1_3_by_z20 - t27*z2_3_by_z20;
    const double v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t26*v1_3_by_v10 + t27*z1_3_by_v10 - t27*z2_3_by_v10;
    const double v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t26*v1_3_by_v20 + t27*z1_3_by_v20 - t27*z2_3_by_v20;
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
    const double t28 = (1.0/(determinant));
    const double z1_0 = numerator1*t28;
    const double z2_0 = numerator2*t28;
    /* slip-stick for tau, until second-breaks-forward */
    const double z1_2 = V*sin_tau + V*z1_2_by_v20 + cos_tau*z1_0 + z1_2_by_z20*z2_0;
    const double z2_2 = V*tau + z2_0;
    residual[0] = V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0;
    residual[1] = V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0;
    residual[2] = -chi*z2_0 - e1 + z1_0;
    residual[3] = -chi*z1_2 + chi*z2_2 - e2;
    start[0] = z1_0;
    start[1] = z2_0;
    map[0] = z1_4_by_z10;
    map[1] = z1_4_by_z20;
    map[2] = z1_4_by_v10;
    map[3] = z1_4_by_v20;
    map[4] = 0;
    map[5] = z2_4_by_z10;
    map[6] = z2_4_by_z20;
    map[7] = z2_4_by_v10;
    map[8] = z2_4_by_v20;
    map[9] = 0;
    map[10] = v1_3_by_z10;
    map[11] = v1_3_by_z20;
    map[12] = v1_3_by_v10;
    map[13] = v1_3_by_v20;
    map[14] = 0;
    map[15] = v2_4_by_z10;
    map[16] = v2_4_by_z20;
    map[17] = v2_4_by_v10;
    map[18] = v2_4_by_v20;
    map[19] = 0;
}

/* Newton's method on the reduced equations for `count` points.
 * Takes parameters (4) and guess (2: tau, tau1) of the points; gives unknowns (5), the
 * trace, the largest reduced residual, iterations and a status of each. Arrays hold columns:
 * entry i of a point stands at [i * count + point].
 * In one step a dwell time changes by a factor of four at most; a point has converged when
 * a whole step is below 1e-9 max(1, |x|).
 * Status: 0 converged, 1 not converged, 2 not finite, 3 a dwell time is not positive,
 * 5 the linear equations for the start are singular. */
NONSMOOTH_MULTIVERSION
void dry_friction_symmetric_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = 16, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[4][lanes], x[2][lanes], fixed[42][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 4; ++i)
                parameter[i][lane] = parameters[i * count + point];
            open[lane] = 1.0;
            for (int i = 0; i < 2; ++i)
                x[i][lane] = guess[i * count + point];
            taken[lane] = 0;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double e2 = parameter[3][lane];
            const double gap1 = sqrt(4*(chi*chi)*eta + ((-chi*eta + 1)*(-chi*eta + 1)));
            const double omega1 = sqrt((1.0/2.0)*chi*eta + (1.0/2.0)*gap1 + 1.0/2.0);
            const double omega2 = sqrt(chi)*sqrt(eta)*sqrt(1 - chi)/omega1;
            const double p1 = 1.0/2.0 + (1.0/2.0)*(-chi*eta + 1)/gap1;
            const double p2 = -chi/gap1;
            const double p3 = -chi*eta/gap1;
            /* coefficients of the linear equations */
            const double t8 = (1.0/(omega2));
            const double t10 = (1.0/(omega1));
            const double t11 = p1*t10;
            const double t15 = (1.0/(chi));
            const double t19 = e2*t15;
            const double t21 = V*t10;
            const double h0 = -p1;
            const double h1 = -p2;
            const double h2 = e2*t15;
            const double h3 = e2*p1*t15;
            const double h4 = V*p1;
            const double h5 = V*p2;
            const double h6 = V*p2*t8;
            const double h7 = -t19;
            /* d/dtau of: functions of half_tau in slip-slip */
            const double t24 = (1.0/2.0)*omega1;
            const double h8 = -t24;
            const double t25 = (1.0/2.0)*omega2;
            const double h9 = -t25;
            /* d/dtau of: coefficients of the linear equations */
            const double t26 = p1*t8;
            const double h10 = -t26 + t8;
            const double h11 = -p1*t19;
            const double h12 = -p2*t21;
            /* d/dtau1 of: right-hand sides of the linear equations */
            const double t30 = (1.0/2.0)*V;
            const double h13 = (1.0/2.0)*V*p1;
            const double h14 = (1.0/2.0)*V*p2;
            const double t36 = p1 - 1;
            const double h15 = -t36;
            const double h16 = p2*t10;
            const double h17 = -p3;
            const double h18 = p3*t10;
            const double h19 = -t10*t36;
            const double h20 = -omega2*p2;
            const double h21 = -omega2*p3;
            const double h22 = -chi;
            const double h23 = -eta;
            const double h24 = chi*eta;
            /* rate of the exit boundary after tau1 */
            const double t56 = V*chi;
            const double t61 = p3*t19;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = t8;
            fixed[6][lane] = t10;
            fixed[7][lane] = t11;
            fixed[8][lane] = t19;
            fixed[9][lane] = t21;
            fixed[10][lane] = h0;
            fixed[11][lane] = h1;
            fixed[12][lane] = h2;
            fixed[13][lane] = h3;
            fixed[14][lane] = h4;
            fixed[15][lane] = h5;
            fixed[16][lane] = h6;
            fixed[17][lane] = h7;
            fixed[18][lane] = t24;
            fixed[19][lane] = h8;
            fixed[20][lane] = t25;
            fixed[21][lane] = h9;
            fixed[22][lane] = t26;
            fixed[23][lane] = h10;
            fixed[24][lane] = h11;
            fixed[25][lane] = h12;
            fixed[26][lane] = t30;
            fixed[27][lane] = h13;
            fixed[28][lane] = h14;
            fixed[29][lane] = t36;
            fixed[30][lane] = h15;
            fixed[31][lane] = h16;
            fixed[32][lane] = h17;
            fixed[33][lane] = h18;
            fixed[34][lane] = h19;
            fixed[35][lane] = h20;
            fixed[36][lane] = h21;
            fixed[37][lane] = h22;
            fixed[38][lane] = h23;
            fixed[39][lane] = h24;
            fixed[40][lane] = t56;
            fixed[41][lane] = t61;
        }
        for (int iteration = 0; iteration < most; ++iteration) {
            double running = 0.0;
#pragma omp simd
            for (int lane = 0; lane < lanes; ++lane) {
                const double chi = parameter[0][lane];
                const double V = parameter[2][lane];
                const double omega1 = fixed[0][lane];
                const double omega2 = fixed[1][lane];
                const double p1 = fixed[2][lane];
                const double p2 = fixed[3][lane];
                const double p3 = fixed[4][lane];
                const double t8 = fixed[5][lane];
                const double t10 = fixed[6][lane];
                const double t11 = fixed[7][lane];
                const double t19 = fixed[8][lane];
                const double t21 = fixed[9][lane];
                const double h0 = fixed[10][lane];
                const double h1 = fixed[11][lane];
                const double h2 = fixed[12][lane];
                const double h3 = fixed[13][lane];
                const double h4 = fixed[14][lane];
                const double h5 = fixed[15][lane];
                const double h6 = fixed[16][lane];
                const double t24 = fixed[18][lane];
                const double h8 = fixed[19][lane];
                const double t25 = fixed[20][lane];
                const double h9 = fixed[21][lane];
                const double t26 = fixed[22][lane];
                const double h10 = fixed[23][lane];
                const double h11 = fixed[24][lane];
                const double h12 = fixed[25][lane];
                const double t30 = fixed[26][lane];
                const double h13 = fixed[27][lane];
                const double h14 = fixed[28][lane];
                const double h17 = fixed[32][lane];
                const double h18 = fixed[33][lane];
                const double t56 = fixed[40][lane];
                const double t61 = fixed[41][lane];
                const double tau = x[0][lane];
                const double tau1 = x[1][lane];
                /* half of tau */
                const double half_tau = (1.0/2.0)*tau;
                /* functions of half_tau in slip-slip */
                const double t0 = half_tau*omega1;
                double sine_0, cosine_0;
                nonsmooth_sincos(t0, &sine_0, &cosine_0);
                const double cos_omega1_half_tau = cosine_0;
                const double sin_omega1_half_tau = sine_0;
                const double t3 = half_tau*omega2;
                double sine_1, cosine_1;
                nonsmooth_sincos(t3, &sine_1, &cosine_1);
                const double cos_omega2_half_tau = cosine_1;
                const double sin_omega2_half_tau = sine_1;
                /* half of tau1 */
                const double half_tau1 = (1.0/2.0)*tau1;
                double sine_2, cosine_2;
                nonsmooth_sincos(half_tau1, &sine_2, &cosine_2);
                const double cos_half_tau1 = cosine_2;
                const double sin_half_tau1 = sine_2;
                const double t9 = sin_omega2_half_tau*t8;
                const double t12 = p1*t9;
                const double coefficient11 = sin_omega1_half_tau*t11 - t12 + t9;
                /* right-hand sides of the linear equations */
                const double t13 = V*half_tau1;
                const double t14 = cos_omega2_half_tau*t13;
                const double t16 = p1*t13;
                const double t17 = cos_omega1_half_tau*t16;
                const double t18 = p2*t13;
                const double t20 = cos_omega2_half_tau*t19;
                const double t22 = sin_omega1_half_tau*t21;
                const double right1 = cos_omega1_half_tau*h3 - cos_omega1_half_tau*t18 + cos_omega2_half_tau*h2 + cos_omega2_half_tau*h4*half_tau1 + cos_omega2_half_tau*h5*half_tau1 + h0*t20 + h1*t22 + h6*sin_omega2_half_tau - t14 - t17;
                /* determinant of the linear equations */
                const double determinant = coefficient11;
                /* v10 by Cramer's rule */
                const double t23 = (1.0/(determinant));
                const double v10 = right1*t23;
                const double cos_omega1_half_tau_by_tau = h8*sin_omega1_half_tau;
                const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t24;
                const double cos_omega2_half_tau_by_tau = h9*sin_omega2_half_tau;
                const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t25;
                /* d/dtau1 of: functions of half_tau1 in slip-stick */
                const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
                const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
                const double coefficient11_by_tau = h10*sin_omega2_half_tau_by_tau + sin_omega1_half_tau_by_tau*t11;
                /* d/dtau of: right-hand sides of the linear equations */
                const double t27 = h11 + t16 + t18;
                const double t29 = -t13 + t19;
                const double right1_by_tau = -cos_omega1_half_tau_by_tau*t27 + cos_omega2_half_tau_by_tau*(t27 + t29) + h12*sin_omega1_half_tau_by_tau + h6*sin_omega2_half_tau_by_tau;
                const double t31 = cos_omega2_half_tau*t30;
                const double t32 = cos_omega1_half_tau*t30;
                const double t33 = p1*t32;
                const double right1_by_tau1 = cos_omega2_half_tau*h13 + cos_omega2_half_tau*h14 + h1*t32 - t31 - t33;
                /* d/dtau of: v10 by Cramer's rule */
                const double v10_by_tau = -coefficient11_by_tau*right1/(determinant*determinant) + right1_by_tau*t23;
                /* d/dtau1 of: v10 by Cramer's rule */
                const double v10_by_tau1 = right1_by_tau1*t23;
                /* outputs */
                const double t58 = cos_omega1_half_tau*t13;
                const double t59 = p3*v10;
                const double t60 = t10*t59;
                const double t62 = cos_half_tau1*t13;
                const double t63 = h17*t13 + t16 + t61;
                const double t64 = h17*t9 + h18*sin_omega1_half_tau;
                const double residual_0 = V*t12 - cos_omega1_half_tau*t61 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t58 + sin_omega1_half_tau*t60 - t17 + t22 + t58 - t59*t9;
                const double residual_1 = chi*t62 + cos_half_tau1*t19 - sin_half_tau1*t56 + sin_half_tau1*v10 - t62;
                const double jacobian_0 = cos_omega1_half_tau_by_tau*(t13 - t63) + cos_omega2_half_tau_by_tau*t63 + sin_omega1_half_tau_by_tau*(-p1*t21 + t21 + t60) + sin_omega2_half_tau_by_tau*(V*t26 - t59*t8) + t64*v10_by_tau;
                const double jacobian_1 = p1*t31 - p3*t31 + p3*t32 + t32 - t33 + t64*v10_by_tau1;
                const double jacobian_2 = sin_half_tau1*v10_by_tau;
                const double jacobian_3 = -cos_half_tau1*t30 + (1.0/2.0)*cos_half_tau1*t56 + cos_half_tau1_by_tau1*(chi*t13 + t29) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t56 + v10);
                const double inverse = (1.0/((jacobian_0*jacobian_3 - jacobian_1*jacobian_2)));
                const double wanted_0 = tau - (-jacobian_1*residual_1 + jacobian_3*residual_0)*inverse;
                const double next_0 = wanted_0 < 0.25*tau ? 0.25*tau : wanted_0 > 4.0*tau ? 4.0*tau : wanted_0;
                const double size_0 = fabs(next_0) > 1.0 ? fabs(next_0) : 1.0;
                const double wanted_1 = tau1 - (jacobian_0*residual_1 - jacobian_2*residual_0)*inverse;
                const double next_1 = wanted_1 < 0.25*tau1 ? 0.25*tau1 : wanted_1 > 4.0*tau1 ? 4.0*tau1 : wanted_1;
                const double size_1 = fabs(next_1) > 1.0 ? fabs(next_1) : 1.0;
                x[0][lane] = open[lane] != 0.0 ? next_0 : tau;
                x[1][lane] = open[lane] != 0.0 ? next_1 : tau1;
                taken[lane] += open[lane] != 0.0 ? 1 : 0;
                open[lane] = ((fabs(wanted_0 - tau) <= 1e-9*size_0) & (fabs(wanted_1 - tau1) <= 1e-9*size_1)) ? 0.0 : open[lane];
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
        double result[5][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double V = parameter[2][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double t8 = fixed[5][lane];
            const double t10 = fixed[6][lane];
            const double t11 = fixed[7][lane];
            const double t19 = fixed[8][lane];
            const double t21 = fixed[9][lane];
            const double h0 = fixed[10][lane];
            const double h1 = fixed[11][lane];
            const double h2 = fixed[12][lane];
            const double h3 = fixed[13][lane];
            const double h4 = fixed[14][lane];
            const double h5 = fixed[15][lane];
            const double h6 = fixed[16][lane];
            const double h7 = fixed[17][lane];
            const double t26 = fixed[22][lane];
            const double t36 = fixed[29][lane];
            const double h15 = fixed[30][lane];
            const double h16 = fixed[31][lane];
            const double h17 = fixed[32][lane];
            const double h18 = fixed[33][lane];
            const double h19 = fixed[34][lane];
            const double h20 = fixed[35][lane];
            const double h21 = fixed[36][lane];
            const double h22 = fixed[37][lane];
            const double h23 = fixed[38][lane];
            const double h24 = fixed[39][lane];
            const double t56 = fixed[40][lane];
            const double t61 = fixed[41][lane];
            const double tau = x[0][lane];
            const double tau1 = x[1][lane];
            /* half of tau */
            const double half_tau = (1.0/2.0)*tau;
            /* functions of half_tau in slip-slip */
            const double t0 = half_tau*omega1;
            double sine_0, cosine_0;
            nonsmooth_sincos(t0, &sine_0, &cosine_0);
            const double cos_omega1_half_tau = cosine_0;
            const double sin_omega1_half_tau = sine_0;
            const double t3 = half_tau*omega2;
            double sine_1, cosine_1;
            nonsmooth_sincos(t3, &sine_1, &cosine_1);
            const double cos_omega2_half_tau = cosine_1;
            const double sin_omega2_half_tau = sine_1;
            /* half of tau1 */
            const double half_tau1 = (1.0/2.0)*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(half_tau1, &sine_2, &cosine_2);
            const double cos_half_tau1 = cosine_2;
            const double sin_half_tau1 = sine_2;
            const double t9 = sin_omega2_half_tau*t8;
            const double t12 = p1*t9;
            const double coefficient11 = sin_omega1_half_tau*t11 - t12 + t9;
            /* right-hand sides of the linear equations */
            const double t13 = V*half_tau1;
            const double t14 = cos_omega2_half_tau*t13;
            const double t16 = p1*t13;
            const double t17 = cos_omega1_half_tau*t16;
            const double t18 = p2*t13;
            const double t20 = cos_omega2_half_tau*t19;
            const double t22 = sin_omega1_half_tau*t21;
            const double right1 = cos_omega1_half_tau*h3 - cos_omega1_half_tau*t18 + cos_omega2_half_tau*h2 + cos_omega2_half_tau*h4*half_tau1 + cos_omega2_half_tau*h5*half_tau1 + h0*t20 + h1*t22 + h6*sin_omega2_half_tau - t14 - t17;
            /* determinant of the linear equations */
            const double determinant = coefficient11;
            /* v10 by Cramer's rule */
            const double t23 = (1.0/(determinant));
            const double v10 = right1*t23;
            /* z10: linear in: second-breaks-forward ends slip-stick */
            const double z10 = h7 + t13;
            /* z20: linear in: z2 vanishes halfway through slip-stick */
            const double z20 = t13;
            /* functions of tau in slip-slip */
            const double t34 = omega1*tau;
            double sine_3, cosine_3;
            nonsmooth_sincos(t34, &sine_3, &cosine_3);
            const double cos_omega1_tau = cosine_3;
            const double sin_omega1_tau = sine_3;
            const double t35 = omega2*tau;
            double sine_4, cosine_4;
            nonsmooth_sincos(t35, &sine_4, &cosine_4);
            const double cos_omega2_tau = cosine_4;
            const double sin_omega2_tau = sine_4;
            /* slip-slip for tau, until second-reaches-belt */
            const double t38 = sin_omega2_tau*t8;
            const double t39 = h15*t38 + sin_omega1_tau*t11;
            const double t40 = cos_omega1_tau*p1 + cos_omega2_tau*h15;
            const double t41 = cos_omega1_tau*p2 + cos_omega2_tau*h1;
            const double z1_1 = V*(h1*t38 + h16*sin_omega1_tau) + t39*v10 + t40*z10 + t41*z20;
            const double t42 = h17*t38 + h18*sin_omega1_tau;
            const double t43 = cos_omega1_tau*p3 + cos_omega2_tau*h17;
            const double t44 = cos_omega1_tau*h15 + cos_omega2_tau*p1;
            const double z2_1 = V*(h19*sin_omega1_tau + sin_omega2_tau*t26) + t42*v10 + t43*z10 + t44*z20;
            const double t45 = omega2*sin_omega2_tau;
            const double t46 = omega1*sin_omega1_tau;
            const double t47 = h15*t45 + p1*t46;
            const double t48 = h20*sin_omega2_tau + p2*t46;
            const double v1_1 = V*t41 + t40*v10 - t47*z10 - t48*z20;
            const double t49 = h21*sin_omega2_tau + p3*t46;
            const double t50 = h15*t46 + p1*t45;
            const double v2_1 = V*t44 + t43*v10 - t49*z10 - t50*z20;
            double sine_5, cosine_5;
            nonsmooth_sincos(tau1, &sine_5, &cosine_5);
            const double cos_tau1 = cosine_5;
            const double sin_tau1 = sine_5;
            /* slip-stick for tau1, until second-breaks-forward */
            const double t51 = chi + cos_tau1*h22;
            const double t52 = chi*sin_tau1;
            const double z1_2 = V*(chi*tau1 - t52) + cos_tau1*z1_1 + sin_tau1*v1_1 + t51*z2_1;
            const double z2_2 = V*tau1 + z2_1;
            const double v1_2 = V*t51 + cos_tau1*v1_1 - sin_tau1*z1_1 + t52*z2_1;
            /* Phi along tau */
            const double carried_z1_1_by_z20 = t40 + t41;
            const double carried_z1_1_by_v10 = t39;
            const double carried_z2_1_by_z20 = t43 + t44;
            const double carried_z2_1_by_v10 = t42;
            const double carried_v1_1_by_z20 = -t47 - t48;
            const double carried_v1_1_by_v10 = t40;
            const double carried_v2_1_by_z20 = -t49 - t50;
            const double carried_v2_1_by_v10 = t43;
            /* rate of the exit boundary after tau */
            const double t53 = chi*z2_1;
            const double rate_1 = h23*t53 + h24*z1_1;
            /* derivatives of the time to the boundary after tau */
            const double t54 = (1.0/(rate_1));
            const double delay_tau_by_z20 = -carried_v2_1_by_z20*t54;
            const double delay_tau_by_v10 = -carried_v2_1_by_v10*t54;
            /* perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
            const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
            const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
            const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
            const double t55 = t53 - z1_1;
            const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t55;
            const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t55;
            /* Phi along tau1 */
            const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t51*z2_1_on_boundary_by_z20;
            const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t51*z2_1_on_boundary_by_v10;
            const double carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t52*z2_1_on_boundary_by_v10;
            const double rate_2 = h22*v1_2 + t56;
            /* derivatives of the time to the boundary after tau1 */
            const double t57 = (1.0/(rate_2));
            const double delay_tau1_by_z20 = t57*(carried_z1_2_by_z20*chi + h22*z2_1_on_boundary_by_z20);
            const double delay_tau1_by_v10 = t57*(carried_z1_2_by_v10*chi + h22*z2_1_on_boundary_by_v10);
            /* perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20;
            const double v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*(chi*z2_2 - z1_2);
            /* outputs */
            const double t58 = cos_omega1_half_tau*t13;
            const double t59 = p3*v10;
            const double t60 = t10*t59;
            const double t62 = cos_half_tau1*t13;
            const double t65 = (half_tau*half_tau);
            const double t66 = 2*t65;
            result[0][lane] = z10;
            result[1][lane] = z20;
            result[2][lane] = v10;
            result[3][lane] = tau;
            result[4][lane] = tau1;
            slope[lane] = v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20;
            double largest = 0.0;
            largest = fabs(V*t12 - cos_omega1_half_tau*t61 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t58 + sin_omega1_half_tau*t60 - t17 + t22 + t58 - t59*t9) > largest ? fabs(V*t12 - cos_omega1_half_tau*t61 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t58 + sin_omega1_half_tau*t60 - t17 + t22 + t58 - t59*t9) : largest;
            largest = fabs(chi*t62 + cos_half_tau1*t19 - sin_half_tau1*t56 + sin_half_tau1*v10 - t62) > largest ? fabs(chi*t62 + cos_half_tau1*t19 - sin_half_tau1*t56 + sin_half_tau1*v10 - t62) : largest;
            defect[lane] = largest;
            const double finite = (slope[lane] - slope[lane]) + (result[0][lane] - result[0][lane]) + (result[1][lane] - result[1][lane]) + (result[2][lane] - result[2][lane]) + (result[3][lane] - result[3][lane]) + (result[4][lane] - result[4][lane]);
            int32_t ending = ((result[3][lane] <= 0.0) | (result[4][lane] <= 0.0)) ? 3 : 0;
            ending = open[lane] != 0.0 ? 1 : ending;
            ending = finite == 0.0 ? ending : 2;
            ending = ((fabs(determinant/sqrt((p1*p1)*t66/((omega1*omega1)*t65 + 1) + (t36*t36)*t66/((omega2*omega2)*t65 + 1))) <= 1e-12)) ? 5 : ending;
            ended[lane] = ending;
        }
        for (int i = 0; i < 5; ++i)
            for (int lane = 0; lane < here; ++lane)
                unknowns[i * count + start + lane] = result[i][lane];
        for (int lane = 0; lane < here; ++lane) {
            const ptrdiff_t point = start + lane;
            trace[point] = slope[lane];
            residual[point] = defect[lane];
            iterations[point] = taken[lane];
            status[point] = ended[lane];
        }
    }
}

/* Is each of `count` orbits a motion of the real system?
 * Takes parameters (4) and unknowns (5) for each, row by row. Gives the least values of the
 * open parameters (us2) under which it is; the row of
 * the boundary that is crossed inside a phase (-1 none, -2 a dwell time is not positive, -3
 * data that are not finite), by how much, and how long after the start of the phase. */
void dry_friction_symmetric_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int sums[] = {2, 3}, terms[] = {2, 1}, at_once[] = {0, 0};
    static const int opened[] = {-1, -1, -1, -1, 0};
    static const int exits[] = {6, 16}, first_frequency[] = {0, 2};
    static const int begins[] = {0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 0.0, 0.0, 0.0, 2.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 4 * point, *const u = unknowns + 5 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {u[3], u[4]};
        double spectral[7], derivatives[14], coefficients[24], frequencies[3];
        dry_friction_spectrum(q, spectral, derivatives);
        dry_friction_symmetric_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        const double measures[] = {p[0], p[2], p[3], u[0], u[1], u[2]};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < 6; ++i)
            size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
        /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
        for (int phase = 0; phase < 2; ++phase) {
            const double miss = fabs(
                nonsmooth_evaluate(terms[phase], frequencies + first_frequency[phase],
                                   coefficients + exits[phase], durations[phase]).value);
            missed = miss > missed ? miss : missed;
        }
        const double most_missed = 0x1p-30 * size;
        const double noise = 32.0 * DBL_EPSILON * size +
                             (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
        double least[1], most = 0.0, when = 0.0;
        int found = -1, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 1; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 2 && found == -1; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[3], floor[3], maximum[3], time[3];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? -2 : -3;
            for (int i = 0; i < sums[phase]; ++i) {
                const double *const function = coefficient + i * length;
                usual[i] = opened[row + i] < 0
                    ? noise + nonsmooth_rounding(terms[phase], frequency, function, duration)
                    : least[opened[row + i]] * per_unit[row + i];
                /* a phase that begins on a boundary and rises crosses it, however little */
                const int rises = begins[row + i] && duration > 0.0 &&
                                  nonsmooth_rises(terms[phase], frequency, function, noise);
                floor[i] = rises ? -(double)INFINITY : usual[i];
            }
            nonsmooth_maxima(sums[phase], terms[phase], frequency, coefficient, duration, floor,
                             maximum, time);
            for (int i = 0; i < sums[phase] && found == -1; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = -3;
                } else if (maximum[i] > floor[i] && opened[row + i] >= 0) {
                    least[opened[row + i]] = maximum[i] / per_unit[row + i];
                } else if (maximum[i] > floor[i]) {
                    found = row + i;
                    most = maximum[i] > 0.0 ? maximum[i] : 0.0;
                    when = maximum[i] > usual[i] ? time[i] : 0.0;
                }
            }
            row += sums[phase];
            coefficient += sums[phase] * length;
            frequency += terms[phase];
        }
        for (int i = 0; i < 1; ++i)
            bounds[1 * point + i] = least[i];
        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}

/* Derivatives of the unknowns (5) and the trace by the parameters (4), at solutions of the
 * equations, for `count` points. Arrays hold columns: entry i of a point stands at
 * [i * count + point], and of the derivatives those by one parameter follow another.
 * NaN where the equations are singular: a pivot is below 1e-10 times the matrix. */
NONSMOOTH_MULTIVERSION
void dry_friction_symmetric_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = 16, n = 5, p = 4, width = 5 + 4 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[p][lanes], unknown[n][lanes], fixed[15][lanes];
        double matrix[n][width][lanes], slope[width][lanes], size[lanes], least[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < p; ++i)
                parameter[i][lane] = parameters[i * count + point];
            for (int i = 0; i < n; ++i)
                unknown[i][lane] = unknowns[i * count + point];
            size[lane] = 0.0;
            least[lane] = INFINITY;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            /* spectrum */
            const double t0 = chi*eta;
            const double t1 = 1 - t0;
            const double t2 = 4*(chi*chi);
            const double gap1 = sqrt(eta*t2 + (t1*t1));
            const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t0 + 1.0/2.0);
            const double t3 = (1.0/(omega1));
            const double t4 = sqrt(1 - chi);
            const double t5 = sqrt(chi);
            const double t6 = sqrt(eta);
            const double t7 = t5*t6;
            const double t8 = t4*t7;
            const double omega2 = t3*t8;
            const double t9 = (1.0/(gap1));
            const double t10 = (1.0/2.0)*t9;
            const double p1 = t1*t10 + 1.0/2.0;
            const double t11 = chi*t9;
            const double p2 = -t11;
            const double p3 = -t0*t9;
            /* d/dchi of: spectrum */
            const double t13 = 2*t1;
            const double gap1_by_chi = t10*(-eta*t13 + 8*t0);
            const double t14 = (1.0/2.0)*gap1_by_chi;
            const double t15 = (1.0/2.0)*eta;
            const double t16 = (1.0/2.0)*t3;
            const double omega1_by_chi = t16*(t14 + t15);
            const double t17 = (1.0/(t5));
            const double t18 = t8/(omega1*omega1);
            const double omega2_by_chi = -omega1_by_chi*t18 - t16*t7/t4 + (1.0/2.0)*t17*t3*t4*t6;
            const double t19 = (1.0/(gap1*gap1));
            const double t20 = t1*t19;
            const double p1_by_chi = -t14*t20 - t15*t9;
            const double t21 = chi*t19;
            const double p2_by_chi = gap1_by_chi*t21 - t9;
            const double t22 = t0*t19;
            const double p3_by_chi = -eta*t9 + gap1_by_chi*t22;
            /* d/deta of: spectrum */
            const double gap1_by_eta = t10*(-chi*t13 + t2);
            const double t23 = (1.0/2.0)*gap1_by_eta;
            const double omega1_by_eta = t16*((1.0/2.0)*chi + t23);
            const double t24 = (1.0/(t6));
            const double omega2_by_eta = -omega1_by_eta*t18 + (1.0/2.0)*t24*t3*t4*t5;
            const double p1_by_eta = -1.0/2.0*t11 - t20*t23;
            const double p2_by_eta = gap1_by_eta*t21;
            const double p3_by_eta = gap1_by_eta*t22 - t11;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega1_by_chi;
            fixed[6][lane] = omega1_by_eta;
            fixed[7][lane] = omega2_by_chi;
            fixed[8][lane] = omega2_by_eta;
            fixed[9][lane] = p1_by_chi;
            fixed[10][lane] = p1_by_eta;
            fixed[11][lane] = p2_by_chi;
            fixed[12][lane] = p2_by_eta;
            fixed[13][lane] = p3_by_chi;
            fixed[14][lane] = p3_by_eta;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double V = parameter[2][lane];
            const double z10 = unknown[0][lane];
            const double z20 = unknown[1][lane];
            const double v10 = unknown[2][lane];
            const double tau = unknown[3][lane];
            const double tau1 = unknown[4][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega1_by_chi = fixed[5][lane];
            const double omega1_by_eta = fixed[6][lane];
            const double omega2_by_chi = fixed[7][lane];
            const double omega2_by_eta = fixed[8][lane];
            const double p1_by_chi = fixed[9][lane];
            const double p1_by_eta = fixed[10][lane];
            const double p2_by_chi = fixed[11][lane];
            const double p2_by_eta = fixed[12][lane];
            const double p3_by_chi = fixed[13][lane];
            const double p3_by_eta = fixed[14][lane];
            /* half of tau */
            const double half_tau = (1.0/2.0)*tau;
            /* functions of half_tau in slip-slip */
            const double t0 = half_tau*omega1;
            double sine_0, cosine_0;
            nonsmooth_sincos(t0, &sine_0, &cosine_0);
            const double cos_omega1_half_tau = cosine_0;
            const double sin_omega1_half_tau = sine_0;
            const double t3 = half_tau*omega2;
            double sine_1, cosine_1;
            nonsmooth_sincos(t3, &sine_1, &cosine_1);
            const double cos_omega2_half_tau = cosine_1;
            const double sin_omega2_half_tau = sine_1;
            /* half of tau1 */
            const double half_tau1 = (1.0/2.0)*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(half_tau1, &sine_2, &cosine_2);
            const double cos_half_tau1 = cosine_2;
            const double sin_half_tau1 = sine_2;
            /* d/dtau of: functions of half_tau in slip-slip */
            const double t8 = (1.0/2.0)*omega1;
            const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t8;
            const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t8;
            const double t9 = (1.0/2.0)*omega2;
            const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t9;
            const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t9;
            /* d/dtau1 of: functions of half_tau1 in slip-stick */
            const double cos_half_tau1_by_tau1 = -1.0/2.0*sin_half_tau1;
            const double sin_half_tau1_by_tau1 = (1.0/2.0)*cos_half_tau1;
            /* d/dchi of: functions of half_tau in slip-slip */
            const double t10 = half_tau*omega1_by_chi;
            const double cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t10;
            const double sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t10;
            const double t11 = half_tau*omega2_by_chi;
            const double cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t11;
            const double sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t11;
            /* d/deta of: functions of half_tau in slip-slip */
            const double t12 = half_tau*omega1_by_eta;
            const double cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t12;
            const double sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t12;
            const double t13 = half_tau*omega2_by_eta;
            const double cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t13;
            const double sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t13;
            /* outputs */
            const double t14 = p1 - 1;
            const double t16 = (1.0/(omega2));
            const double t17 = sin_omega2_half_tau*t16;
            const double t18 = (1.0/(omega1));
            const double t19 = p1*z10 + p2*z20;
            const double t21 = -t19 + z10;
            const double t22 = V*p2 + p1*v10;
            const double t23 = sin_omega1_half_tau_by_tau*t18;
            const double t25 = t22 - v10;
            const double t26 = sin_omega2_half_tau_by_tau*t16;
            const double t27 = p3*z10;
            const double t28 = p1*z20;
            const double t29 = t27 - t28 + z20;
            const double t30 = -t27 + t28;
            const double t31 = p3*v10;
            const double t32 = V*p1 - t31;
            const double t33 = V*p1 - V - t31;
            const double t35 = V*chi;
            const double t36 = sin_omega1_half_tau*t18;
            const double t37 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 - t17*v10 + t36*v10;
            const double t38 = -V*sin_omega1_half_tau*t18 + V*t17 - cos_omega1_half_tau*z20 + cos_omega2_half_tau*z20;
            const double t40 = t18*t22;
            const double t41 = t16*t25;
            const double t42 = sin_omega2_half_tau/(omega2*omega2);
            const double t43 = t25*t42;
            const double t44 = sin_omega1_half_tau/(omega1*omega1);
            const double t45 = t22*t44;
            const double t46 = t16*t32;
            const double t47 = t18*t33;
            const double t48 = t33*t44;
            const double t49 = t32*t42;
            matrix[0][0][lane] = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t14;
            matrix[0][1][lane] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
            matrix[0][2][lane] = p1*sin_omega1_half_tau*t18 - t14*t17;
            matrix[0][3][lane] = cos_omega1_half_tau_by_tau*t19 + cos_omega2_half_tau_by_tau*t21 + t22*t23 - t25*t26;
            matrix[0][4][lane] = 0;
            matrix[1][0][lane] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
            matrix[1][1][lane] = -cos_omega1_half_tau*t14 + cos_omega2_half_tau*p1;
            matrix[1][2][lane] = p3*sin_omega1_half_tau*t18 - p3*t17;
            matrix[1][3][lane] = cos_omega1_half_tau_by_tau*t29 + cos_omega2_half_tau_by_tau*t30 - t23*t33 + t26*t32;
            matrix[1][4][lane] = 0;
            matrix[2][0][lane] = -cos_half_tau1;
            matrix[2][1][lane] = chi*cos_half_tau1 - chi;
            matrix[2][2][lane] = sin_half_tau1;
            matrix[2][3][lane] = 0;
            matrix[2][4][lane] = cos_half_tau1_by_tau1*(chi*z20 - z10) + sin_half_tau1_by_tau1*(-t35 + v10) + (1.0/2.0)*t35;
            matrix[3][0][lane] = 0;
            matrix[3][1][lane] = -1;
            matrix[3][2][lane] = 0;
            matrix[3][3][lane] = 0;
            matrix[3][4][lane] = (1.0/2.0)*V;
            matrix[4][0][lane] = -chi;
            matrix[4][1][lane] = chi;
            matrix[4][2][lane] = 0;
            matrix[4][3][lane] = 0;
            matrix[4][4][lane] = 0;
            matrix[0][5][lane] = -cos_omega1_half_tau_by_chi*t19 - cos_omega2_half_tau_by_chi*t21 + omega1_by_chi*t45 - omega2_by_chi*t43 - p1_by_chi*t37 + p2_by_chi*t38 - sin_omega1_half_tau_by_chi*t40 + sin_omega2_half_tau_by_chi*t41;
            matrix[0][6][lane] = -cos_omega1_half_tau_by_eta*t19 - cos_omega2_half_tau_by_eta*t21 + omega1_by_eta*t45 - omega2_by_eta*t43 - p1_by_eta*t37 + p2_by_eta*t38 - sin_omega1_half_tau_by_eta*t40 + sin_omega2_half_tau_by_eta*t41;
            matrix[0][7][lane] = -p2*sin_omega1_half_tau*t18 + p2*t17;
            matrix[0][8][lane] = 0;
            matrix[1][5][lane] = -cos_omega1_half_tau_by_chi*t29 - cos_omega2_half_tau_by_chi*t30 - omega1_by_chi*t48 + omega2_by_chi*t49 - p1_by_chi*t38 - p3_by_chi*t37 + sin_omega1_half_tau_by_chi*t47 - sin_omega2_half_tau_by_chi*t46;
            matrix[1][6][lane] = -cos_omega1_half_tau_by_eta*t29 - cos_omega2_half_tau_by_eta*t30 - omega1_by_eta*t48 + omega2_by_eta*t49 - p1_by_eta*t38 - p3_by_eta*t37 + sin_omega1_half_tau_by_eta*t47 - sin_omega2_half_tau_by_eta*t46;
            matrix[1][7][lane] = -p1*t17 + t14*t36;
            matrix[1][8][lane] = 0;
            matrix[2][5][lane] = -V*half_tau1 + V*sin_half_tau1 - cos_half_tau1*z20 + z20;
            matrix[2][6][lane] = 0;
            matrix[2][7][lane] = -chi*half_tau1 + chi*sin_half_tau1;
            matrix[2][8][lane] = 0;
            matrix[3][5][lane] = 0;
            matrix[3][6][lane] = 0;
            matrix[3][7][lane] = -half_tau1;
            matrix[3][8][lane] = 0;
            matrix[4][5][lane] = z10 - z20;
            matrix[4][6][lane] = 0;
            matrix[4][7][lane] = 0;
            matrix[4][8][lane] = 1;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double z10 = unknown[0][lane];
            const double z20 = unknown[1][lane];
            const double v10 = unknown[2][lane];
            const double tau = unknown[3][lane];
            const double tau1 = unknown[4][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega1_by_chi = fixed[5][lane];
            const double omega1_by_eta = fixed[6][lane];
            const double omega2_by_chi = fixed[7][lane];
            const double omega2_by_eta = fixed[8][lane];
            const double p1_by_chi = fixed[9][lane];
            const double p1_by_eta = fixed[10][lane];
            const double p2_by_chi = fixed[11][lane];
            const double p2_by_eta = fixed[12][lane];
            const double p3_by_chi = fixed[13][lane];
            const double p3_by_eta = fixed[14][lane];
            /* functions of tau in slip-slip */
            const double t0 = omega1*tau;
            double sine_0, cosine_0;
            nonsmooth_sincos(t0, &sine_0, &cosine_0);
            const double cos_omega1_tau = cosine_0;
            const double sin_omega1_tau = sine_0;
            const double t3 = omega2*tau;
            double sine_1, cosine_1;
            nonsmooth_sincos(t3, &sine_1, &cosine_1);
            const double cos_omega2_tau = cosine_1;
            const double sin_omega2_tau = sine_1;
            /* slip-slip for tau, until second-reaches-belt */
            const double t6 = (1.0/(omega1));
            const double t7 = sin_omega1_tau*t6;
            const double t8 = p1 - 1;
            const double t10 = (1.0/(omega2));
            const double t11 = sin_omega2_tau*t10;
            const double t12 = p1*t7 - t11*t8;
            const double t13 = cos_omega1_tau*p1 - cos_omega2_tau*t8;
            const double t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
            const double t15 = p2*sin_omega1_tau*t6 - p2*t11;
            const double z1_1 = V*t15 + t12*v10 + t13*z10 + t14*z20;
            const double t16 = p3*sin_omega1_tau*t6 - p3*t11;
            const double t17 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
            const double t18 = -cos_omega1_tau*t8 + cos_omega2_tau*p1;
            const double t19 = p1*t11 - t7*t8;
            const double z2_1 = V*t19 + t16*v10 + t17*z10 + t18*z20;
            const double t20 = omega2*sin_omega2_tau;
            const double t21 = omega1*sin_omega1_tau;
            const double t22 = p1*t21 - t20*t8;
            const double t24 = -omega2*p2*sin_omega2_tau + p2*t21;
            const double v1_1 = V*t14 + t13*v10 - t22*z10 - t24*z20;
            const double t26 = -omega2*p3*sin_omega2_tau + p3*t21;
            const double t28 = p1*t20 - t21*t8;
            const double v2_1 = V*t18 + t17*v10 - t26*z10 - t28*z20;
            double sine_2, cosine_2;
            nonsmooth_sincos(tau1, &sine_2, &cosine_2);
            const double cos_tau1 = cosine_2;
            const double sin_tau1 = sine_2;
            /* slip-stick for tau1, until second-breaks-forward */
            const double t33 = chi*cos_tau1;
            const double t34 = chi - t33;
            const double t35 = chi*sin_tau1;
            const double z1_2 = V*(chi*tau1 - t35) + cos_tau1*z1_1 + sin_tau1*v1_1 + t34*z2_1;
            const double z2_2 = V*tau1 + z2_1;
            const double v1_2 = V*t34 + cos_tau1*v1_1 - sin_tau1*z1_1 + t35*z2_1;
            /* Phi along tau */
            const double carried_z1_1_by_z20 = t13 + t14;
            const double carried_z1_1_by_v10 = t12;
            const double carried_z2_1_by_z20 = t17 + t18;
            const double carried_z2_1_by_v10 = t16;
            const double carried_v1_1_by_z20 = -t22 - t24;
            const double carried_v1_1_by_v10 = t13;
            const double carried_v2_1_by_z20 = -t26 - t28;
            const double carried_v2_1_by_v10 = t17;
            /* rate of the exit boundary after tau */
            const double t36 = eta*z1_1;
            const double t37 = chi*z2_1;
            const double rate_1 = chi*t36 - eta*t37;
            /* derivatives of the time to the boundary after tau */
            const double t38 = (1.0/(rate_1));
            const double delay_tau_by_z20 = -carried_v2_1_by_z20*t38;
            const double delay_tau_by_v10 = -carried_v2_1_by_v10*t38;
            /* perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1;
            const double z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1;
            const double z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1;
            const double z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1;
            const double t39 = t37 - z1_1;
            const double v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t39;
            const double v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t39;
            /* Phi along tau1 */
            const double carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20;
            const double carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10;
            /* rate of the exit boundary after tau1 */
            const double t40 = V*chi;
            const double rate_2 = -chi*v1_2 + t40;
            /* derivatives of the time to the boundary after tau1 */
            const double t41 = (1.0/(rate_2));
            const double t42 = chi*z2_1_on_boundary_by_z20;
            const double t43 = carried_z1_2_by_z20*chi - t42;
            const double delay_tau1_by_z20 = t41*t43;
            const double t44 = chi*z2_1_on_boundary_by_v10;
            const double t45 = carried_z1_2_by_v10*chi - t44;
            const double delay_tau1_by_v10 = t41*t45;
            /* d/dtau of: functions of tau in slip-slip */
            const double cos_omega1_tau_by_tau = -omega1*sin_omega1_tau;
            const double sin_omega1_tau_by_tau = cos_omega1_tau*omega1;
            const double cos_omega2_tau_by_tau = -omega2*sin_omega2_tau;
            const double sin_omega2_tau_by_tau = cos_omega2_tau*omega2;
            /* d/dchi of: functions of tau in slip-slip */
            const double t46 = omega1_by_chi*tau;
            const double cos_omega1_tau_by_chi = -sin_omega1_tau*t46;
            const double sin_omega1_tau_by_chi = cos_omega1_tau*t46;
            const double t47 = omega2_by_chi*tau;
            const double cos_omega2_tau_by_chi = -sin_omega2_tau*t47;
            const double sin_omega2_tau_by_chi = cos_omega2_tau*t47;
            /* d/deta of: functions of tau in slip-slip */
            const double t48 = omega1_by_eta*tau;
            const double cos_omega1_tau_by_eta = -sin_omega1_tau*t48;
            const double sin_omega1_tau_by_eta = cos_omega1_tau*t48;
            const double t49 = omega2_by_eta*tau;
            const double cos_omega2_tau_by_eta = -sin_omega2_tau*t49;
            const double sin_omega2_tau_by_eta = cos_omega2_tau*t49;
            /* d/dz10 of: slip-slip for tau, until second-reaches-belt */
            const double z1_1_by_z10 = t13;
            const double z2_1_by_z10 = t17;
            const double v1_1_by_z10 = -t22;
            const double v2_1_by_z10 = -t26;
            /* d/dz20 of: slip-slip for tau, until second-reaches-belt */
            const double z1_1_by_z20 = t14;
            const double z2_1_by_z20 = t18;
            const double v1_1_by_z20 = -t24;
            const double v2_1_by_z20 = -t28;
            /* d/dv10 of: slip-slip for tau, until second-reaches-belt */
            const double z1_1_by_v10 = t12;
            const double z2_1_by_v10 = t16;
            const double v1_1_by_v10 = t13;
            const double v2_1_by_v10 = t17;
            /* d/dtau of: slip-slip for tau, until second-reaches-belt */
            const double t50 = p1*z10;
            const double t51 = p2*z20;
            const double t52 = t50 + t51;
            const double t53 = -t51 - t8*z10;
            const double t54 = p1*v10;
            const double t55 = V*p2;
            const double t56 = t54*t6 + t55*t6;
            const double t57 = -t10*t55 - t10*t8*v10;
            const double z1_1_by_tau = cos_omega1_tau_by_tau*t52 + cos_omega2_tau_by_tau*t53 + sin_omega1_tau_by_tau*t56 + sin_omega2_tau_by_tau*t57;
            const double t58 = p3*z10;
            const double t59 = -t8*z20;
            const double t60 = t58 + t59;
            const double t61 = p1*z20;
            const double t62 = -t58 + t61;
            const double t63 = p3*v10;
            const double t64 = -V*t8;
            const double t65 = t6*t63 + t6*t64;
            const double t66 = V*p1;
            const double t67 = -t10*t63 + t10*t66;
            const double z2_1_by_tau = cos_omega1_tau_by_tau*t60 + cos_omega2_tau_by_tau*t62 + sin_omega1_tau_by_tau*t65 + sin_omega2_tau_by_tau*t67;
            const double t68 = t54 + t55;
            const double t69 = -t55 - t8*v10;
            const double t70 = -omega1*t50 - omega1*t51;
            const double t71 = -t8*z10;
            const double t72 = omega2*t51 - omega2*t71;
            const double v1_1_by_tau = cos_omega1_tau_by_tau*t68 + cos_omega2_tau_by_tau*t69 + sin_omega1_tau_by_tau*t70 + sin_omega2_tau_by_tau*t72;
            const double t73 = t63 + t64;
            const double t74 = -t63 + t66;
            const double t75 = -omega1*t58 - omega1*t59;
            const double t76 = omega2*p3*z10 - omega2*t61;
            const double v2_1_by_tau = cos_omega1_tau_by_tau*t73 + cos_omega2_tau_by_tau*t74 + sin_omega1_tau_by_tau*t75 + sin_omega2_tau_by_tau*t76;
            /* d/dchi of: slip-slip for tau, until second-reaches-belt */
            const double t77 = (1.0/(omega1*omega1));
            const double t78 = sin_omega1_tau*t77;
            const double t79 = -t54*t78 - t55*t78;
            const double t80 = (1.0/(omega2*omega2));
            const double t81 = sin_omega2_tau*t80;
            const double t82 = t55*t81 + t8*t81*v10;
            const double t83 = -sin_omega1_tau*t6 + t11;
            const double t85 = cos_omega1_tau - cos_omega2_tau;
            const double t86 = -t83*v10 + t85*z10;
            const double t87 = -V*t83 + t85*z20;
            const double z1_1_by_chi = cos_omega1_tau_by_chi*t52 + cos_omega2_tau_by_chi*t53 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau_by_chi*t56 + sin_omega2_tau_by_chi*t57;
            const double t88 = -t63*t78 - t64*t78;
            const double t89 = p3*sin_omega2_tau*t80*v10 - t66*t81;
            const double t91 = V*t83 - t85*z20;
            const double z2_1_by_chi = cos_omega1_tau_by_chi*t60 + cos_omega2_tau_by_chi*t62 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau_by_chi*t65 + sin_omega2_tau_by_chi*t67;
            const double t92 = -sin_omega1_tau*t50 - sin_omega1_tau*t51;
            const double t93 = sin_omega2_tau*t51 - sin_omega2_tau*t71;
            const double t94 = -omega2*sin_omega2_tau + t21;
            const double t96 = t85*v10 - t94*z10;
            const double t97 = V*t85 - t94*z20;
            const double v1_1_by_chi = cos_omega1_tau_by_chi*t68 + cos_omega2_tau_by_chi*t69 + omega1_by_chi*t92 + omega2_by_chi*t93 + p1_by_chi*t96 + p2_by_chi*t97 + sin_omega1_tau_by_chi*t70 + sin_omega2_tau_by_chi*t72;
            const double t98 = -sin_omega1_tau*t58 - sin_omega1_tau*t59;
            const double t99 = p3*sin_omega2_tau*z10 - sin_omega2_tau*t61;
            const double t100 = -V*t85 + t94*z20;
            const double v2_1_by_chi = cos_omega1_tau_by_chi*t73 + cos_omega2_tau_by_chi*t74 + omega1_by_chi*t98 + omega2_by_chi*t99 + p1_by_chi*t100 + p3_by_chi*t96 + sin_omega1_tau_by_chi*t75 + sin_omega2_tau_by_chi*t76;
            /* d/deta of: slip-slip for tau, until second-reaches-belt */
            const double z1_1_by_eta = cos_omega1_tau_by_eta*t52 + cos_omega2_tau_by_eta*t53 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau_by_eta*t56 + sin_omega2_tau_by_eta*t57;
            const double z2_1_by_eta = cos_omega1_tau_by_eta*t60 + cos_omega2_tau_by_eta*t62 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau_by_eta*t65 + sin_omega2_tau_by_eta*t67;
            const double v1_1_by_eta = cos_omega1_tau_by_eta*t68 + cos_omega2_tau_by_eta*t69 + omega1_by_eta*t92 + omega2_by_eta*t93 + p1_by_eta*t96 + p2_by_eta*t97 + sin_omega1_tau_by_eta*t70 + sin_omega2_tau_by_eta*t72;
            const double v2_1_by_eta = cos_omega1_tau_by_eta*t73 + cos_omega2_tau_by_eta*t74 + omega1_by_eta*t98 + omega2_by_eta*t99 + p1_by_eta*t100 + p3_by_eta*t96 + sin_omega1_tau_by_eta*t75 + sin_omega2_tau_by_eta*t76;
            /* d/dV of: slip-slip for tau, until second-reaches-belt */
            const double z1_1_by_V = t15;
            const double z2_1_by_V = t19;
            const double v1_1_by_V = t14;
            const double v2_1_by_V = t18;
            /* d/dtau1 of: functions of tau1 in slip-stick */
            const double cos_tau1_by_tau1 = -sin_tau1;
            const double sin_tau1_by_tau1 = cos_tau1;
            /* d/dz10 of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_z10 = cos_tau1*z1_1_by_z10 + sin_tau1*v1_1_by_z10 + t34*z2_1_by_z10;
            const double v1_2_by_z10 = cos_tau1*v1_1_by_z10 - sin_tau1*z1_1_by_z10 + t35*z2_1_by_z10;
            /* d/dz20 of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_z20 = cos_tau1*z1_1_by_z20 + sin_tau1*v1_1_by_z20 + t34*z2_1_by_z20;
            const double v1_2_by_z20 = cos_tau1*v1_1_by_z20 - sin_tau1*z1_1_by_z20 + t35*z2_1_by_z20;
            /* d/dv10 of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_v10 = cos_tau1*z1_1_by_v10 + sin_tau1*v1_1_by_v10 + t34*z2_1_by_v10;
            const double v1_2_by_v10 = cos_tau1*v1_1_by_v10 - sin_tau1*z1_1_by_v10 + t35*z2_1_by_v10;
            /* d/dtau of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_tau = cos_tau1*z1_1_by_tau + sin_tau1*v1_1_by_tau + t34*z2_1_by_tau;
            const double v1_2_by_tau = cos_tau1*v1_1_by_tau - sin_tau1*z1_1_by_tau + t35*z2_1_by_tau;
            /* d/dtau1 of: slip-stick for tau1, until second-breaks-forward */
            const double t101 = -t40 + v1_1;
            const double z1_2_by_tau1 = -cos_tau1_by_tau1*t39 + sin_tau1_by_tau1*t101 + t40;
            const double v1_2_by_tau1 = cos_tau1_by_tau1*t101 + sin_tau1_by_tau1*t39;
            /* d/dchi of: slip-stick for tau1, until second-breaks-forward */
            const double t102 = 1 - cos_tau1;
            const double z1_2_by_chi = V*(-sin_tau1 + tau1) + cos_tau1*z1_1_by_chi + sin_tau1*v1_1_by_chi + t102*z2_1 + t34*z2_1_by_chi;
            const double v1_2_by_chi = V*t102 + cos_tau1*v1_1_by_chi - sin_tau1*z1_1_by_chi + sin_tau1*z2_1 + t35*z2_1_by_chi;
            /* d/deta of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_eta = cos_tau1*z1_1_by_eta + sin_tau1*v1_1_by_eta + t34*z2_1_by_eta;
            const double v1_2_by_eta = cos_tau1*v1_1_by_eta - sin_tau1*z1_1_by_eta + t35*z2_1_by_eta;
            /* d/dV of: slip-stick for tau1, until second-breaks-forward */
            const double z1_2_by_V = chi*tau1 + cos_tau1*z1_1_by_V + sin_tau1*v1_1_by_V + t34*z2_1_by_V - t35;
            const double z2_2_by_V = tau1 + z2_1_by_V;
            const double v1_2_by_V = chi + cos_tau1*v1_1_by_V - sin_tau1*z1_1_by_V - t33 + t35*z2_1_by_V;
            /* d/dtau of: Phi along tau */
            const double t103 = p1 + p2;
            const double t104 = -p2 - t8;
            const double carried_z1_1_by_z20_by_tau = cos_omega1_tau_by_tau*t103 + cos_omega2_tau_by_tau*t104;
            const double t105 = sin_omega2_tau_by_tau*t10;
            const double carried_z1_1_by_v10_by_tau = p1*sin_omega1_tau_by_tau*t6 - t105*t8;
            const double t106 = -p1 + p3 + 1;
            const double t107 = p1 - p3;
            const double carried_z2_1_by_z20_by_tau = cos_omega1_tau_by_tau*t106 + cos_omega2_tau_by_tau*t107;
            const double carried_z2_1_by_v10_by_tau = p3*sin_omega1_tau_by_tau*t6 - p3*t105;
            const double t108 = -omega1*p1 - omega1*p2;
            const double t109 = omega2*p2 + omega2*t8;
            const double carried_v1_1_by_z20_by_tau = sin_omega1_tau_by_tau*t108 + sin_omega2_tau_by_tau*t109;
            const double carried_v1_1_by_v10_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t8;
            const double t110 = -omega1*p3 + omega1*t8;
            const double t111 = -omega2*p1 + omega2*p3;
            const double carried_v2_1_by_z20_by_tau = sin_omega1_tau_by_tau*t110 + sin_omega2_tau_by_tau*t111;
            const double carried_v2_1_by_v10_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3;
            /* d/dchi of: Phi along tau */
            const double t112 = p1_by_chi*t85;
            const double carried_z1_1_by_z20_by_chi = cos_omega1_tau_by_chi*t103 + cos_omega2_tau_by_chi*t104 + p2_by_chi*t85 + t112;
            const double t113 = sin_omega1_tau_by_chi*t6;
            const double t114 = sin_omega2_tau_by_chi*t10;
            const double t115 = p1*sin_omega1_tau;
            const double t116 = omega1_by_chi*t77;
            const double t117 = -sin_omega2_tau*t8;
            const double t118 = omega2_by_chi*t80;
            const double carried_z1_1_by_v10_by_chi = p1*t113 - p1_by_chi*t83 - t114*t8 - t115*t116 - t117*t118;
            const double t119 = p3_by_chi*t85;
            const double carried_z2_1_by_z20_by_chi = cos_omega1_tau_by_chi*t106 + cos_omega2_tau_by_chi*t107 - p1_by_chi*t85 + t119;
            const double t120 = p3*sin_omega2_tau;
            const double t121 = p3*sin_omega1_tau;
            const double carried_z2_1_by_v10_by_chi = p3*t113 - p3*t114 - p3_by_chi*t83 - t116*t121 + t118*t120;
            const double t122 = -p2*sin_omega1_tau - t115;
            const double t123 = p2*sin_omega2_tau - t117;
            const double carried_v1_1_by_z20_by_chi = omega1_by_chi*t122 + omega2_by_chi*t123 - p1_by_chi*t94 - p2_by_chi*t94 + sin_omega1_tau_by_chi*t108 + sin_omega2_tau_by_chi*t109;
            const double carried_v1_1_by_v10_by_chi = cos_omega1_tau_by_chi*p1 - cos_omega2_tau_by_chi*t8 + t112;
            const double t124 = sin_omega1_tau*t8 - t121;
            const double t125 = -p1*sin_omega2_tau + p3*sin_omega2_tau;
            const double carried_v2_1_by_z20_by_chi = omega1_by_chi*t124 + omega2_by_chi*t125 + p1_by_chi*t94 - p3_by_chi*t94 + sin_omega1_tau_by_chi*t110 + sin_omega2_tau_by_chi*t111;
            const double carried_v2_1_by_v10_by_chi = cos_omega1_tau_by_chi*p3 - cos_omega2_tau_by_chi*p3 + t119;
            /* d/deta of: Phi along tau */
            const double t126 = p1_by_eta*t85;
            const double carried_z1_1_by_z20_by_eta = cos_omega1_tau_by_eta*t103 + cos_omega2_tau_by_eta*t104 + p2_by_eta*t85 + t126;
            const double t127 = sin_omega1_tau_by_eta*t6;
            const double t128 = sin_omega2_tau_by_eta*t10;
            const double t129 = omega1_by_eta*t77;
            const double t130 = omega2_by_eta*t80;
            const double carried_z1_1_by_v10_by_eta = p1*t127 - p1_by_eta*t83 - t115*t129 - t117*t130 - t128*t8;
            const double t131 = p3_by_eta*t85;
            const double carried_z2_1_by_z20_by_eta = cos_omega1_tau_by_eta*t106 + cos_omega2_tau_by_eta*t107 - p1_by_eta*t85 + t131;
            const double carried_z2_1_by_v10_by_eta = p3*t127 - p3*t128 - p3_by_eta*t83 + t120*t130 - t121*t129;
            const double carried_v1_1_by_z20_by_eta = omega1_by_eta*t122 + omega2_by_eta*t123 - p1_by_eta*t94 - p2_by_eta*t94 + sin_omega1_tau_by_eta*t108 + sin_omega2_tau_by_eta*t109;
            const double carried_v1_1_by_v10_by_eta = cos_omega1_tau_by_eta*p1 - cos_omega2_tau_by_eta*t8 + t126;
            const double carried_v2_1_by_z20_by_eta = omega1_by_eta*t124 + omega2_by_eta*t125 + p1_by_eta*t94 - p3_by_eta*t94 + sin_omega1_tau_by_eta*t110 + sin_omega2_tau_by_eta*t111;
            const double carried_v2_1_by_v10_by_eta = cos_omega1_tau_by_eta*p3 - cos_omega2_tau_by_eta*p3 + t131;
            /* d/dz10 of: rate of the exit boundary after tau */
            const double t132 = chi*eta;
            const double rate_1_by_z10 = t132*z1_1_by_z10 - t132*z2_1_by_z10;
            /* d/dz20 of: rate of the exit boundary after tau */
            const double rate_1_by_z20 = t132*z1_1_by_z20 - t132*z2_1_by_z20;
            /* d/dv10 of: rate of the exit boundary after tau */
            const double rate_1_by_v10 = t132*z1_1_by_v10 - t132*z2_1_by_v10;
            /* d/dtau of: rate of the exit boundary after tau */
            const double rate_1_by_tau = t132*z1_1_by_tau - t132*z2_1_by_tau;
            /* d/dchi of: rate of the exit boundary after tau */
            const double rate_1_by_chi = -eta*z2_1 + t132*z1_1_by_chi - t132*z2_1_by_chi + t36;
            /* d/deta of: rate of the exit boundary after tau */
            const double rate_1_by_eta = chi*z1_1 + t132*z1_1_by_eta - t132*z2_1_by_eta - t37;
            /* d/dV of: rate of the exit boundary after tau */
            const double rate_1_by_V = t132*z1_1_by_V - t132*z2_1_by_V;
            /* d/dz10 of: derivatives of the time to the boundary after tau */
            const double t133 = (1.0/(rate_1*rate_1));
            const double t134 = rate_1_by_z10*t133;
            const double delay_tau_by_z20_by_z10 = carried_v2_1_by_z20*t134;
            const double delay_tau_by_v10_by_z10 = carried_v2_1_by_v10*t134;
            /* d/dz20 of: derivatives of the time to the boundary after tau */
            const double t135 = rate_1_by_z20*t133;
            const double delay_tau_by_z20_by_z20 = carried_v2_1_by_z20*t135;
            const double delay_tau_by_v10_by_z20 = carried_v2_1_by_v10*t135;
            /* d/dv10 of: derivatives of the time to the boundary after tau */
            const double t136 = rate_1_by_v10*t133;
            const double delay_tau_by_z20_by_v10 = carried_v2_1_by_z20*t136;
            const double delay_tau_by_v10_by_v10 = carried_v2_1_by_v10*t136;
            /* d/dtau of: derivatives of the time to the boundary after tau */
            const double t137 = rate_1_by_tau*t133;
            const double delay_tau_by_z20_by_tau = carried_v2_1_by_z20*t137 - carried_v2_1_by_z20_by_tau*t38;
            const double delay_tau_by_v10_by_tau = carried_v2_1_by_v10*t137 - carried_v2_1_by_v10_by_tau*t38;
            /* d/dchi of: derivatives of the time to the boundary after tau */
            const double t138 = rate_1_by_chi*t133;
            const double delay_tau_by_z20_by_chi = carried_v2_1_by_z20*t138 - carried_v2_1_by_z20_by_chi*t38;
            const double delay_tau_by_v10_by_chi = carried_v2_1_by_v10*t138 - carried_v2_1_by_v10_by_chi*t38;
            /* d/deta of: derivatives of the time to the boundary after tau */
            const double t139 = rate_1_by_eta*t133;
            const double delay_tau_by_z20_by_eta = carried_v2_1_by_z20*t139 - carried_v2_1_by_z20_by_eta*t38;
            const double delay_tau_by_v10_by_eta = carried_v2_1_by_v10*t139 - carried_v2_1_by_v10_by_eta*t38;
            /* d/dV of: derivatives of the time to the boundary after tau */
            const double t140 = rate_1_by_V*t133;
            const double delay_tau_by_z20_by_V = carried_v2_1_by_z20*t140;
            const double delay_tau_by_v10_by_V = carried_v2_1_by_v10*t140;
            /* d/dz10 of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v1_1_by_z10 + delay_tau_by_z20_by_z10*v1_1;
            const double z1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v1_1_by_z10 + delay_tau_by_v10_by_z10*v1_1;
            const double z2_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v2_1_by_z10 + delay_tau_by_z20_by_z10*v2_1;
            const double z2_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v2_1_by_z10 + delay_tau_by_v10_by_z10*v2_1;
            const double t141 = chi*z2_1_by_z10;
            const double v1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*t141 - delay_tau_by_z20*z1_1_by_z10 + delay_tau_by_z20_by_z10*t39;
            const double v1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*t141 - delay_tau_by_v10*z1_1_by_z10 + delay_tau_by_v10_by_z10*t39;
            /* d/dz20 of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v1_1_by_z20 + delay_tau_by_z20_by_z20*v1_1;
            const double z1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v1_1_by_z20 + delay_tau_by_v10_by_z20*v1_1;
            const double z2_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v2_1_by_z20 + delay_tau_by_z20_by_z20*v2_1;
            const double z2_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v2_1_by_z20 + delay_tau_by_v10_by_z20*v2_1;
            const double t142 = chi*z2_1_by_z20;
            const double v1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*t142 - delay_tau_by_z20*z1_1_by_z20 + delay_tau_by_z20_by_z20*t39;
            const double v1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*t142 - delay_tau_by_v10*z1_1_by_z20 + delay_tau_by_v10_by_z20*t39;
            /* d/dv10 of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v1_1_by_v10 + delay_tau_by_z20_by_v10*v1_1;
            const double z1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v1_1_by_v10 + delay_tau_by_v10_by_v10*v1_1;
            const double z2_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v2_1_by_v10 + delay_tau_by_z20_by_v10*v2_1;
            const double z2_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v2_1_by_v10 + delay_tau_by_v10_by_v10*v2_1;
            const double t143 = chi*z2_1_by_v10;
            const double v1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*t143 - delay_tau_by_z20*z1_1_by_v10 + delay_tau_by_z20_by_v10*t39;
            const double v1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*t143 - delay_tau_by_v10*z1_1_by_v10 + delay_tau_by_v10_by_v10*t39;
            /* d/dtau of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_tau = carried_z1_1_by_z20_by_tau + delay_tau_by_z20*v1_1_by_tau + delay_tau_by_z20_by_tau*v1_1;
            const double z1_1_on_boundary_by_v10_by_tau = carried_z1_1_by_v10_by_tau + delay_tau_by_v10*v1_1_by_tau + delay_tau_by_v10_by_tau*v1_1;
            const double z2_1_on_boundary_by_z20_by_tau = carried_z2_1_by_z20_by_tau + delay_tau_by_z20*v2_1_by_tau + delay_tau_by_z20_by_tau*v2_1;
            const double z2_1_on_boundary_by_v10_by_tau = carried_z2_1_by_v10_by_tau + delay_tau_by_v10*v2_1_by_tau + delay_tau_by_v10_by_tau*v2_1;
            const double t144 = chi*z2_1_by_tau;
            const double v1_1_on_boundary_by_z20_by_tau = carried_v1_1_by_z20_by_tau + delay_tau_by_z20*t144 - delay_tau_by_z20*z1_1_by_tau + delay_tau_by_z20_by_tau*t39;
            const double v1_1_on_boundary_by_v10_by_tau = carried_v1_1_by_v10_by_tau + delay_tau_by_v10*t144 - delay_tau_by_v10*z1_1_by_tau + delay_tau_by_v10_by_tau*t39;
            /* d/dchi of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_chi = carried_z1_1_by_z20_by_chi + delay_tau_by_z20*v1_1_by_chi + delay_tau_by_z20_by_chi*v1_1;
            const double z1_1_on_boundary_by_v10_by_chi = carried_z1_1_by_v10_by_chi + delay_tau_by_v10*v1_1_by_chi + delay_tau_by_v10_by_chi*v1_1;
            const double z2_1_on_boundary_by_z20_by_chi = carried_z2_1_by_z20_by_chi + delay_tau_by_z20*v2_1_by_chi + delay_tau_by_z20_by_chi*v2_1;
            const double z2_1_on_boundary_by_v10_by_chi = carried_z2_1_by_v10_by_chi + delay_tau_by_v10*v2_1_by_chi + delay_tau_by_v10_by_chi*v2_1;
            const double t145 = chi*z2_1_by_chi;
            const double v1_1_on_boundary_by_z20_by_chi = carried_v1_1_by_z20_by_chi + delay_tau_by_z20*t145 - delay_tau_by_z20*z1_1_by_chi + delay_tau_by_z20*z2_1 + delay_tau_by_z20_by_chi*t39;
            const double v1_1_on_boundary_by_v10_by_chi = carried_v1_1_by_v10_by_chi + delay_tau_by_v10*t145 - delay_tau_by_v10*z1_1_by_chi + delay_tau_by_v10*z2_1 + delay_tau_by_v10_by_chi*t39;
            /* d/deta of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_eta = carried_z1_1_by_z20_by_eta + delay_tau_by_z20*v1_1_by_eta + delay_tau_by_z20_by_eta*v1_1;
            const double z1_1_on_boundary_by_v10_by_eta = carried_z1_1_by_v10_by_eta + delay_tau_by_v10*v1_1_by_eta + delay_tau_by_v10_by_eta*v1_1;
            const double z2_1_on_boundary_by_z20_by_eta = carried_z2_1_by_z20_by_eta + delay_tau_by_z20*v2_1_by_eta + delay_tau_by_z20_by_eta*v2_1;
            const double z2_1_on_boundary_by_v10_by_eta = carried_z2_1_by_v10_by_eta + delay_tau_by_v10*v2_1_by_eta + delay_tau_by_v10_by_eta*v2_1;
            const double t146 = chi*z2_1_by_eta;
            const double v1_1_on_boundary_by_z20_by_eta = carried_v1_1_by_z20_by_eta + delay_tau_by_z20*t146 - delay_tau_by_z20*z1_1_by_eta + delay_tau_by_z20_by_eta*t39;
            const double v1_1_on_boundary_by_v10_by_eta = carried_v1_1_by_v10_by_eta + delay_tau_by_v10*t146 - delay_tau_by_v10*z1_1_by_eta + delay_tau_by_v10_by_eta*t39;
            /* d/dV of: perturbation on the boundary after tau */
            const double z1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v1_1_by_V + delay_tau_by_z20_by_V*v1_1;
            const double z1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v1_1_by_V + delay_tau_by_v10_by_V*v1_1;
            const double z2_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v2_1_by_V + delay_tau_by_z20_by_V*v2_1;
            const double z2_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v2_1_by_V + delay_tau_by_v10_by_V*v2_1;
            const double t147 = chi*z2_1_by_V;
            const double v1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*t147 - delay_tau_by_z20*z1_1_by_V + delay_tau_by_z20_by_V*t39;
            const double v1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*t147 - delay_tau_by_v10*z1_1_by_V + delay_tau_by_v10_by_V*t39;
            /* d/dz10 of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_z10 = cos_tau1*z1_1_on_boundary_by_z20_by_z10 + sin_tau1*v1_1_on_boundary_by_z20_by_z10 + t34*z2_1_on_boundary_by_z20_by_z10;
            const double carried_z1_2_by_v10_by_z10 = cos_tau1*z1_1_on_boundary_by_v10_by_z10 + sin_tau1*v1_1_on_boundary_by_v10_by_z10 + t34*z2_1_on_boundary_by_v10_by_z10;
            const double carried_v1_2_by_v10_by_z10 = cos_tau1*v1_1_on_boundary_by_v10_by_z10 - sin_tau1*z1_1_on_boundary_by_v10_by_z10 + t35*z2_1_on_boundary_by_v10_by_z10;
            /* d/dz20 of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_z20 = cos_tau1*z1_1_on_boundary_by_z20_by_z20 + sin_tau1*v1_1_on_boundary_by_z20_by_z20 + t34*z2_1_on_boundary_by_z20_by_z20;
            const double carried_z1_2_by_v10_by_z20 = cos_tau1*z1_1_on_boundary_by_v10_by_z20 + sin_tau1*v1_1_on_boundary_by_v10_by_z20 + t34*z2_1_on_boundary_by_v10_by_z20;
            const double carried_v1_2_by_v10_by_z20 = cos_tau1*v1_1_on_boundary_by_v10_by_z20 - sin_tau1*z1_1_on_boundary_by_v10_by_z20 + t35*z2_1_on_boundary_by_v10_by_z20;
            /* d/dv10 of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_v10 = cos_tau1*z1_1_on_boundary_by_z20_by_v10 + sin_tau1*v1_1_on_boundary_by_z20_by_v10 + t34*z2_1_on_boundary_by_z20_by_v10;
            const double carried_z1_2_by_v10_by_v10 = cos_tau1*z1_1_on_boundary_by_v10_by_v10 + sin_tau1*v1_1_on_boundary_by_v10_by_v10 + t34*z2_1_on_boundary_by_v10_by_v10;
            const double carried_v1_2_by_v10_by_v10 = cos_tau1*v1_1_on_boundary_by_v10_by_v10 - sin_tau1*z1_1_on_boundary_by_v10_by_v10 + t35*z2_1_on_boundary_by_v10_by_v10;
            /* d/dtau of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_tau = cos_tau1*z1_1_on_boundary_by_z20_by_tau + sin_tau1*v1_1_on_boundary_by_z20_by_tau + t34*z2_1_on_boundary_by_z20_by_tau;
            const double carried_z1_2_by_v10_by_tau = cos_tau1*z1_1_on_boundary_by_v10_by_tau + sin_tau1*v1_1_on_boundary_by_v10_by_tau + t34*z2_1_on_boundary_by_v10_by_tau;
            const double carried_v1_2_by_v10_by_tau = cos_tau1*v1_1_on_boundary_by_v10_by_tau - sin_tau1*z1_1_on_boundary_by_v10_by_tau + t35*z2_1_on_boundary_by_v10_by_tau;
            /* d/dtau1 of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_tau1 = cos_tau1_by_tau1*(-t42 + z1_1_on_boundary_by_z20) + sin_tau1_by_tau1*v1_1_on_boundary_by_z20;
            const double t148 = t44 - z1_1_on_boundary_by_v10;
            const double carried_z1_2_by_v10_by_tau1 = -cos_tau1_by_tau1*t148 + sin_tau1_by_tau1*v1_1_on_boundary_by_v10;
            const double carried_v1_2_by_v10_by_tau1 = cos_tau1_by_tau1*v1_1_on_boundary_by_v10 + sin_tau1_by_tau1*t148;
            /* d/dchi of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_chi = cos_tau1*z1_1_on_boundary_by_z20_by_chi + sin_tau1*v1_1_on_boundary_by_z20_by_chi + t102*z2_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20_by_chi;
            const double carried_z1_2_by_v10_by_chi = cos_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*v1_1_on_boundary_by_v10_by_chi + t102*z2_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10_by_chi;
            const double carried_v1_2_by_v10_by_chi = cos_tau1*v1_1_on_boundary_by_v10_by_chi - sin_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*z2_1_on_boundary_by_v10 + t35*z2_1_on_boundary_by_v10_by_chi;
            /* d/deta of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_eta = cos_tau1*z1_1_on_boundary_by_z20_by_eta + sin_tau1*v1_1_on_boundary_by_z20_by_eta + t34*z2_1_on_boundary_by_z20_by_eta;
            const double carried_z1_2_by_v10_by_eta = cos_tau1*z1_1_on_boundary_by_v10_by_eta + sin_tau1*v1_1_on_boundary_by_v10_by_eta + t34*z2_1_on_boundary_by_v10_by_eta;
            const double carried_v1_2_by_v10_by_eta = cos_tau1*v1_1_on_boundary_by_v10_by_eta - sin_tau1*z1_1_on_boundary_by_v10_by_eta + t35*z2_1_on_boundary_by_v10_by_eta;
            /* d/dV of: Phi along tau1 */
            const double carried_z1_2_by_z20_by_V = cos_tau1*z1_1_on_boundary_by_z20_by_V + sin_tau1*v1_1_on_boundary_by_z20_by_V + t34*z2_1_on_boundary_by_z20_by_V;
            const double carried_z1_2_by_v10_by_V = cos_tau1*z1_1_on_boundary_by_v10_by_V + sin_tau1*v1_1_on_boundary_by_v10_by_V + t34*z2_1_on_boundary_by_v10_by_V;
            const double carried_v1_2_by_v10_by_V = cos_tau1*v1_1_on_boundary_by_v10_by_V - sin_tau1*z1_1_on_boundary_by_v10_by_V + t35*z2_1_on_boundary_by_v10_by_V;
            /* d/dz10 of: rate of the exit boundary after tau1 */
            const double rate_2_by_z10 = -chi*v1_2_by_z10;
            /* d/dz20 of: rate of the exit boundary after tau1 */
            const double rate_2_by_z20 = -chi*v1_2_by_z20;
            /* d/dv10 of: rate of the exit boundary after tau1 */
            const double rate_2_by_v10 = -chi*v1_2_by_v10;
            /* d/dtau of: rate of the exit boundary after tau1 */
            const double rate_2_by_tau = -chi*v1_2_by_tau;
            /* d/dtau1 of: rate of the exit boundary after tau1 */
            const double rate_2_by_tau1 = -chi*v1_2_by_tau1;
            /* d/dchi of: rate of the exit boundary after tau1 */
            const double rate_2_by_chi = V - chi*v1_2_by_chi - v1_2;
            /* d/deta of: rate of the exit boundary after tau1 */
            const double rate_2_by_eta = -chi*v1_2_by_eta;
            /* d/dV of: rate of the exit boundary after tau1 */
            const double rate_2_by_V = -chi*v1_2_by_V + chi;
            /* d/dz10 of: derivatives of the time to the boundary after tau1 */
            const double t149 = (1.0/(rate_2*rate_2));
            const double t150 = rate_2_by_z10*t149;
            const double t151 = chi*t41;
            const double delay_tau1_by_z20_by_z10 = carried_z1_2_by_z20_by_z10*chi*t41 - t150*t43 - t151*z2_1_on_boundary_by_z20_by_z10;
            const double delay_tau1_by_v10_by_z10 = carried_z1_2_by_v10_by_z10*chi*t41 - t150*t45 - t151*z2_1_on_boundary_by_v10_by_z10;
            /* d/dz20 of: derivatives of the time to the boundary after tau1 */
            const double t152 = rate_2_by_z20*t149;
            const double delay_tau1_by_z20_by_z20 = carried_z1_2_by_z20_by_z20*chi*t41 - t151*z2_1_on_boundary_by_z20_by_z20 - t152*t43;
            const double delay_tau1_by_v10_by_z20 = carried_z1_2_by_v10_by_z20*chi*t41 - t151*z2_1_on_boundary_by_v10_by_z20 - t152*t45;
            /* d/dv10 of: derivatives of the time to the boundary after tau1 */
            const double t153 = rate_2_by_v10*t149;
            const double delay_tau1_by_z20_by_v10 = carried_z1_2_by_z20_by_v10*chi*t41 - t151*z2_1_on_boundary_by_z20_by_v10 - t153*t43;
            const double delay_tau1_by_v10_by_v10 = carried_z1_2_by_v10_by_v10*chi*t41 - t151*z2_1_on_boundary_by_v10_by_v10 - t153*t45;
            /* d/dtau of: derivatives of the time to the boundary after tau1 */
            const double t154 = rate_2_by_tau*t149;
            const double delay_tau1_by_z20_by_tau = carried_z1_2_by_z20_by_tau*chi*t41 - t151*z2_1_on_boundary_by_z20_by_tau - t154*t43;
            const double delay_tau1_by_v10_by_tau = carried_z1_2_by_v10_by_tau*chi*t41 - t151*z2_1_on_boundary_by_v10_by_tau - t154*t45;
            /* d/dtau1 of: derivatives of the time to the boundary after tau1 */
            const double t155 = rate_2_by_tau1*t149;
            const double delay_tau1_by_z20_by_tau1 = carried_z1_2_by_z20_by_tau1*t151 - t155*t43;
            const double delay_tau1_by_v10_by_tau1 = carried_z1_2_by_v10_by_tau1*t151 - t155*t45;
            /* d/dchi of: derivatives of the time to the boundary after tau1 */
            const double t156 = rate_2_by_chi*t149;
            const double delay_tau1_by_z20_by_chi = carried_z1_2_by_z20_by_chi*t151 - t151*z2_1_on_boundary_by_z20_by_chi - t156*t43 + t41*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20);
            const double delay_tau1_by_v10_by_chi = carried_z1_2_by_v10_by_chi*t151 - t151*z2_1_on_boundary_by_v10_by_chi - t156*t45 + t41*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10);
            /* d/deta of: derivatives of the time to the boundary after tau1 */
            const double t157 = rate_2_by_eta*t149;
            const double delay_tau1_by_z20_by_eta = carried_z1_2_by_z20_by_eta*chi*t41 - t151*z2_1_on_boundary_by_z20_by_eta - t157*t43;
            const double delay_tau1_by_v10_by_eta = carried_z1_2_by_v10_by_eta*chi*t41 - t151*z2_1_on_boundary_by_v10_by_eta - t157*t45;
            /* d/dV of: derivatives of the time to the boundary after tau1 */
            const double t158 = rate_2_by_V*t149;
            const double delay_tau1_by_z20_by_V = carried_z1_2_by_z20_by_V*chi*t41 - t151*z2_1_on_boundary_by_z20_by_V - t158*t43;
            const double delay_tau1_by_v10_by_V = carried_z1_2_by_v10_by_V*chi*t41 - t151*z2_1_on_boundary_by_v10_by_V - t158*t45;
            /* d/dz10 of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_z10 = V*delay_tau1_by_z20_by_z10 + z2_1_on_boundary_by_z20_by_z10;
            const double t159 = chi*z2_2 - z1_2;
            const double v1_2_on_boundary_by_v10_by_z10 = carried_v1_2_by_v10_by_z10 + delay_tau1_by_v10*t141 - delay_tau1_by_v10*z1_2_by_z10 + delay_tau1_by_v10_by_z10*t159;
            /* d/dz20 of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_z20 = V*delay_tau1_by_z20_by_z20 + z2_1_on_boundary_by_z20_by_z20;
            const double v1_2_on_boundary_by_v10_by_z20 = carried_v1_2_by_v10_by_z20 + delay_tau1_by_v10*t142 - delay_tau1_by_v10*z1_2_by_z20 + delay_tau1_by_v10_by_z20*t159;
            /* d/dv10 of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_v10 = V*delay_tau1_by_z20_by_v10 + z2_1_on_boundary_by_z20_by_v10;
            const double v1_2_on_boundary_by_v10_by_v10 = carried_v1_2_by_v10_by_v10 + delay_tau1_by_v10*t143 - delay_tau1_by_v10*z1_2_by_v10 + delay_tau1_by_v10_by_v10*t159;
            /* d/dtau of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_tau = V*delay_tau1_by_z20_by_tau + z2_1_on_boundary_by_z20_by_tau;
            const double v1_2_on_boundary_by_v10_by_tau = carried_v1_2_by_v10_by_tau + delay_tau1_by_v10*t144 - delay_tau1_by_v10*z1_2_by_tau + delay_tau1_by_v10_by_tau*t159;
            /* d/dtau1 of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_tau1 = V*delay_tau1_by_z20_by_tau1;
            const double v1_2_on_boundary_by_v10_by_tau1 = carried_v1_2_by_v10_by_tau1 + delay_tau1_by_v10*t40 - delay_tau1_by_v10*z1_2_by_tau1 + delay_tau1_by_v10_by_tau1*t159;
            /* d/dchi of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_chi = V*delay_tau1_by_z20_by_chi + z2_1_on_boundary_by_z20_by_chi;
            const double v1_2_on_boundary_by_v10_by_chi = carried_v1_2_by_v10_by_chi + delay_tau1_by_v10*t145 - delay_tau1_by_v10*z1_2_by_chi + delay_tau1_by_v10*z2_2 + delay_tau1_by_v10_by_chi*t159;
            /* d/deta of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_eta = V*delay_tau1_by_z20_by_eta + z2_1_on_boundary_by_z20_by_eta;
            const double v1_2_on_boundary_by_v10_by_eta = carried_v1_2_by_v10_by_eta + delay_tau1_by_v10*t146 - delay_tau1_by_v10*z1_2_by_eta + delay_tau1_by_v10_by_eta*t159;
            /* d/dV of: perturbation on the boundary after tau1 */
            const double z2_2_on_boundary_by_z20_by_V = V*delay_tau1_by_z20_by_V + delay_tau1_by_z20 + z2_1_on_boundary_by_z20_by_V;
            const double v1_2_on_boundary_by_v10_by_V = carried_v1_2_by_v10_by_V + chi*delay_tau1_by_v10*z2_2_by_V - delay_tau1_by_v10*z1_2_by_V + delay_tau1_by_v10_by_V*t159;
            slope[0][lane] = v1_2_on_boundary_by_v10_by_z10 + z2_2_on_boundary_by_z20_by_z10;
            slope[1][lane] = v1_2_on_boundary_by_v10_by_z20 + z2_2_on_boundary_by_z20_by_z20;
            slope[2][lane] = v1_2_on_boundary_by_v10_by_v10 + z2_2_on_boundary_by_z20_by_v10;
            slope[3][lane] = v1_2_on_boundary_by_v10_by_tau + z2_2_on_boundary_by_z20_by_tau;
            slope[4][lane] = v1_2_on_boundary_by_v10_by_tau1 + z2_2_on_boundary_by_z20_by_tau1;
            slope[5][lane] = v1_2_on_boundary_by_v10_by_chi + z2_2_on_boundary_by_z20_by_chi;
            slope[6][lane] = v1_2_on_boundary_by_v10_by_eta + z2_2_on_boundary_by_z20_by_eta;
            slope[7][lane] = v1_2_on_boundary_by_v10_by_V + z2_2_on_boundary_by_z20_by_V;
            slope[8][lane] = 0;
        }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
#pragma omp simd
                for (int lane = 0; lane < lanes; ++lane)
                    size[lane] += matrix[i][j][lane] * matrix[i][j][lane];
        for (int k = 0; k < n; ++k) {
            for (int i = k + 1; i < n; ++i) {
                double other[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    other[lane] = fabs(matrix[i][k][lane]) - fabs(matrix[k][k][lane]);
                for (int j = k; j < width; ++j)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane) {
                        const double above = matrix[k][j][lane], below = matrix[i][j][lane];
                        matrix[k][j][lane] = other[lane] > 0.0 ? below : above;
                        matrix[i][j][lane] = other[lane] > 0.0 ? above : below;
                    }
            }
#pragma omp simd
            for (int lane = 0; lane < lanes; ++lane) {
                const double pivot = fabs(matrix[k][k][lane]);
                least[lane] = pivot < least[lane] ? pivot : least[lane];
                matrix[k][k][lane] = 1.0 / matrix[k][k][lane];
            }
            for (int i = k + 1; i < n; ++i) {
                double factor[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    factor[lane] = matrix[i][k][lane] * matrix[k][k][lane];
                for (int j = k + 1; j < width; ++j)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[i][j][lane] -= factor[lane] * matrix[k][j][lane];
            }
        }
        for (int k = n - 1; k >= 0; --k)
            for (int j = n; j < width; ++j) {
                for (int l = k + 1; l < n; ++l)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[k][j][lane] -= matrix[k][l][lane] * matrix[l][j][lane];
#pragma omp simd
                for (int lane = 0; lane < lanes; ++lane) {
                    matrix[k][j][lane] *= matrix[k][k][lane];
                    slope[j][lane] += slope[k][lane] * matrix[k][j][lane];
                }
            }
        for (int lane = 0; lane < here; ++lane) {
            const double lost = least[lane] > 1e-10 * sqrt(size[lane]) ? 0.0 : (double)NAN;
            for (int j = 0; j < p; ++j) {
                for (int i = 0; i < n; ++i)
                    directions[(i * p + j) * count + start + lane] = matrix[i][n + j][lane] + lost;
                directions[(n * p + j) * count + start + lane] = slope[n + j][lane] + lost;
            }
        }
    }
}

/* Newton's method on the reduced equations for `count` points.
 * Takes parameters (5) and guess (2: tau, tau1) of the points; gives unknowns (6), the
 * trace, the largest reduced residual, iterations and a status of each. Arrays hold columns:
 * entry i of a point stands at [i * count + point].
 * In one step a dwell time changes by a factor of four at most; a point has converged when
 * a whole step is below 1e-9 max(1, |x|).
 * Status: 0 converged, 1 not converged, 2 not finite, 3 a dwell time is not positive,
 * 5 the linear equations for the start are singular. */
NONSMOOTH_MULTIVERSION
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = 16, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[5][lanes], x[2][lanes], fixed[33][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 5; ++i)
                parameter[i][lane] = parameters[i * count + point];
            open[lane] = 1.0;
            for (int i = 0; i < 2; ++i)
                x[i][lane] = guess[i * count + point];
            taken[lane] = 0;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double e1 = parameter[3][lane];
            const double e2 = parameter[4][lane];
            const double gap1 = sqrt(4*(chi*chi)*eta + ((-chi*eta + 1)*(-chi*eta + 1)));
            const double omega1 = sqrt((1.0/2.0)*chi*eta + (1.0/2.0)*gap1 + 1.0/2.0);
            const double omega2 = sqrt(chi)*sqrt(eta)*sqrt(1 - chi)/omega1;
            const double p1 = 1.0/2.0 + (1.0/2.0)*(-chi*eta + 1)/gap1;
            const double p2 = -chi/gap1;
            const double p3 = -chi*eta/gap1;
            const double omega3 = sqrt(chi)*sqrt(eta);
            const double t3 = (1.0/((chi - 1)));
            const double t4 = e1*t3;
            const double h0 = -t4;
            const double h1 = -e2*t3/chi;
            const double h2 = -chi;
            /* slip-slip for tau1 */
            const double t10 = (1.0/(omega1));
            const double h3 = (1.0/(omega2));
            const double t12 = 1 - p1;
            const double h4 = -p2;
            const double h5 = p2*t10;
            const double h6 = -p3;
            const double h7 = p3*t10;
            const double h8 = -p1;
            const double h9 = -t12;
            const double h10 = omega2*p2;
            const double h11 = omega2*p3;
            const double h12 = -V;
            const double h13 = -omega3;
            /* tau2: first return */
            const double t27 = (1.0/(omega3));
            const double h14 = -t3/V;
            const double h15 = -t3;
            /* d/dtau of: slip-stick for tau */
            const double t33 = V*chi;
            const double t34 = V - t33;
            const double h16 = -e1;
            const double h17 = -eta;
            const double h18 = chi*eta;
            /* outputs */
            const double t38 = t27*t3;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega3;
            fixed[6][lane] = t3;
            fixed[7][lane] = t4;
            fixed[8][lane] = h0;
            fixed[9][lane] = h1;
            fixed[10][lane] = h2;
            fixed[11][lane] = t10;
            fixed[12][lane] = h3;
            fixed[13][lane] = t12;
            fixed[14][lane] = h4;
            fixed[15][lane] = h5;
            fixed[16][lane] = h6;
            fixed[17][lane] = h7;
            fixed[18][lane] = h8;
            fixed[19][lane] = h9;
            fixed[20][lane] = h10;
            fixed[21][lane] = h11;
            fixed[22][lane] = h12;
            fixed[23][lane] = h13;
            fixed[24][lane] = t27;
            fixed[25][lane] = h14;
            fixed[26][lane] = h15;
            fixed[27][lane] = t33;
            fixed[28][lane] = t34;
            fixed[29][lane] = h16;
            fixed[30][lane] = h17;
            fixed[31][lane] = h18;
            fixed[32][lane] = t38;
        }
        for (int iteration = 0; iteration < most; ++iteration) {
            double running = 0.0;
#pragma omp simd
            for (int lane = 0; lane < lanes; ++lane) {
                const double chi = parameter[0][lane];
                const double V = parameter[2][lane];
                const double e1 = parameter[3][lane];
                const double omega1 = fixed[0][lane];
                const double omega2 = fixed[1][lane];
                const double p1 = fixed[2][lane];
                const double p2 = fixed[3][lane];
                const double p3 = fixed[4][lane];
                const double omega3 = fixed[5][lane];
                const double t3 = fixed[6][lane];
                const double t4 = fixed[7][lane];
                const double h0 = fixed[8][lane];
                const double h1 = fixed[9][lane];
                const double h2 = fixed[10][lane];
                const double t10 = fixed[11][lane];
                const double h3 = fixed[12][lane];
                const double t12 = fixed[13][lane];
                const double h4 = fixed[14][lane];
                const double h5 = fixed[15][lane];
                const double h6 = fixed[16][lane];
                const double h7 = fixed[17][lane];
                const double h8 = fixed[18][lane];
                const double h9 = fixed[19][lane];
                const double h10 = fixed[20][lane];
                const double h11 = fixed[21][lane];
                const double h12 = fixed[22][lane];
                const double h13 = fixed[23][lane];
                const double t27 = fixed[24][lane];
                const double h15 = fixed[26][lane];
                const double t33 = fixed[27][lane];
                const double t34 = fixed[28][lane];
                const double h16 = fixed[29][lane];
                const double h17 = fixed[30][lane];
                const double h18 = fixed[31][lane];
                const double t38 = fixed[32][lane];
                const double tau = x[0][lane];
                const double tau1 = x[1][lane];
                double sine_0, cosine_0;
                nonsmooth_sincos(tau, &sine_0, &cosine_0);
                const double cos_tau = cosine_0;
                const double sin_tau = sine_0;
                /* z2_1: linear in second-breaks-forward */
                const double t2 = V*tau;
                const double z2_1 = V*sin_tau + cos_tau*h0 + h1 - t2;
                /* slip-stick for tau */
                const double t5 = chi*z2_1;
                const double t6 = e1 + t5;
                const double t7 = chi + cos_tau*h2;
                const double z1_2 = V*sin_tau + V*(chi*tau + h2*sin_tau) + cos_tau*t6 + t7*z2_1;
                const double z2_2 = t2 + z2_1;
                const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
                /* functions of tau1 in slip-slip */
                const double t8 = omega1*tau1;
                double sine_1, cosine_1;
                nonsmooth_sincos(t8, &sine_1, &cosine_1);
                const double cos_omega1_tau1 = cosine_1;
                const double sin_omega1_tau1 = sine_1;
                const double t9 = omega2*tau1;
                double sine_2, cosine_2;
                nonsmooth_sincos(t9, &sine_2, &cosine_2);
                const double cos_omega2_tau1 = cosine_2;
                const double sin_omega2_tau1 = sine_2;
                const double t13 = h3*sin_omega2_tau1;
                const double t11 = sin_omega1_tau1*t10;
                const double t14 = p1*t11 + t12*t13;
                const double t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12;
                const double t16 = cos_omega1_tau1*p2 + cos_omega2_tau1*h4;
                const double z1_3 = V*(h4*t13 + h5*sin_omega1_tau1) + t14*v1_2 + t15*z1_2 + t16*z2_2;
                const double t17 = h6*t13 + h7*sin_omega1_tau1;
                const double t18 = cos_omega1_tau1*p3 + cos_omega2_tau1*h6;
                const double t19 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1;
                const double z2_3 = V*(p1*t13 + t11*t12) + t17*v1_2 + t18*z1_2 + t19*z2_2;
                const double t20 = omega2*sin_omega2_tau1;
                const double t21 = omega1*sin_omega1_tau1;
                const double t22 = h8*t21 + h9*t20;
                const double t23 = h10*sin_omega2_tau1 + h4*t21;
                const double v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2;
                const double t24 = h11*sin_omega2_tau1 + h6*t21;
                const double t25 = h8*t20 + h9*t21;
                const double v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2;
                /* first return of tau2 */
                const double cosine_part_tau2 = h12 + v2_3;
                const double sine_part_tau2 = h13*z2_3 + omega3*z1_3;
                /* first return of tau2 */
                const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
                /* first return of tau2 */
                const double t26 = (1.0/(amplitude_tau2));
                /* ta: linear in time */
                const double t28 = chi*z2_3;
                /* d/dtau of: functions of tau in slip-stick */
                const double cos_tau_by_tau = -sin_tau;
                const double sin_tau_by_tau = cos_tau;
                /* d/dtau of: z2_1: linear in second-breaks-forward */
                const double t32 = cos_tau_by_tau*e1;
                const double z2_1_by_tau = V*sin_tau_by_tau + h12 + h15*t32;
                const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t34 + t32 + t33;
                const double z2_2_by_tau = V + z2_1_by_tau;
                const double v1_2_by_tau = cos_tau_by_tau*t34 + h16*sin_tau_by_tau;
                /* d/dtau of: slip-slip for tau1 */
                const double z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau;
                const double z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau;
                const double v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau;
                const double v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau;
                /* d/dtau1 of: slip-slip for tau1 */
                const double v1_3_by_tau1 = t28 - z1_3;
                const double v2_3_by_tau1 = h17*t28 + h18*z1_3;
                /* d/dtau of: first return of tau2 */
                const double sine_part_tau2_by_tau = h13*z2_3_by_tau + omega3*z1_3_by_tau;
                /* d/dtau1 of: first return of tau2 */
                const double sine_part_tau2_by_tau1 = h13*v2_3 + omega3*v1_3;
                /* d/dtau of: first return of tau2 */
                const double t35 = 2*cosine_part_tau2;
                const double t36 = 2*sine_part_tau2;
                const double t37 = (1.0/2.0)*t26;
                const double amplitude_tau2_by_tau = t37*(sine_part_tau2_by_tau*t36 + t35*v2_3_by_tau);
                /* d/dtau1 of: first return of tau2 */
                const double amplitude_tau2_by_tau1 = t37*(sine_part_tau2_by_tau1*t36 + t35*v2_3_by_tau1);
                const double t39 = amplitude_tau2_by_tau*t38;
                const double t40 = amplitude_tau2_by_tau1*t38;
                const double residual_0 = -V + v1_3;
                const double residual_1 = amplitude_tau2*t27*t3 - t4 - z2_1;
                const double jacobian_0 = v1_3_by_tau;
                const double jacobian_1 = v1_3_by_tau1;
                const double jacobian_2 = t39 - z2_1_by_tau;
                const double jacobian_3 = t40;
                const double inverse = (1.0/((jacobian_0*jacobian_3 - jacobian_1*jacobian_2)));
                const double wanted_0 = tau - (-jacobian_1*residual_1 + jacobian_3*residual_0)*inverse;
                const double next_0 = wanted_0 < 0.25*tau ? 0.25*tau : wanted_0 > 4.0*tau ? 4.0*tau : wanted_0;
                const double size_0 = fabs(next_0) > 1.0 ? fabs(next_0) : 1.0;
                const double wanted_1 = tau1 - (jacobian_0*residual_1 - jacobian_2*residual_0)*inverse;
                const double next_1 = wanted_1 < 0.25*tau1 ? 0.25*tau1 : wanted_1 > 4.0*tau1 ? 4.0*tau1 : wanted_1;
                const double size_1 = fabs(next_1) > 1.0 ? fabs(next_1) : 1.0;
                x[0][lane] = open[lane] != 0.0 ? next_0 : tau;
                x[1][lane] = open[lane] != 0.0 ? next_1 : tau1;
                taken[lane] += open[lane] != 0.0 ? 1 : 0;
                open[lane] = ((fabs(wanted_0 - tau) <= 1e-9*size_0) & (fabs(wanted_1 - tau1) <= 1e-9*size_1)) ? 0.0 : open[lane];
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
        double result[6][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double V = parameter[2][lane];
            const double e1 = parameter[3][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double t3 = fixed[6][lane];
            const double t4 = fixed[7][lane];
            const double h0 = fixed[8][lane];
            const double h1 = fixed[9][lane];
            const double h2 = fixed[10][lane];
            const double t10 = fixed[11][lane];
            const double h3 = fixed[12][lane];
            const double t12 = fixed[13][lane];
            const double h4 = fixed[14][lane];
            const double h5 = fixed[15][lane];
            const double h6 = fixed[16][lane];
            const double h7 = fixed[17][lane];
            const double h8 = fixed[18][lane];
            const double h9 = fixed[19][lane];
            const double h10 = fixed[20][lane];
            const double h11 = fixed[21][lane];
            const double h12 = fixed[22][lane];
            const double h13 = fixed[23][lane];
            const double t27 = fixed[24][lane];
            const double h14 = fixed[25][lane];
            const double h15 = fixed[26][lane];
            const double t33 = fixed[27][lane];
            const double t34 = fixed[28][lane];
            const double h16 = fixed[29][lane];
            const double h17 = fixed[30][lane];
            const double h18 = fixed[31][lane];
            const double t38 = fixed[32][lane];
            const double tau = x[0][lane];
            const double tau1 = x[1][lane];
            double sine_0, cosine_0;
            nonsmooth_sincos(tau, &sine_0, &cosine_0);
            const double cos_tau = cosine_0;
            const double sin_tau = sine_0;
            /* z2_1: linear in second-breaks-forward */
            const double t2 = V*tau;
            const double z2_1 = V*sin_tau + cos_tau*h0 + h1 - t2;
            /* slip-stick for tau */
            const double t5 = chi*z2_1;
            const double t6 = e1 + t5;
            const double t7 = chi + cos_tau*h2;
            const double z1_2 = V*sin_tau + V*(chi*tau + h2*sin_tau) + cos_tau*t6 + t7*z2_1;
            const double z2_2 = t2 + z2_1;
            const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
            /* functions of tau1 in slip-slip */
            const double t8 = omega1*tau1;
            double sine_1, cosine_1;
            nonsmooth_sincos(t8, &sine_1, &cosine_1);
            const double cos_omega1_tau1 = cosine_1;
            const double sin_omega1_tau1 = sine_1;
            const double t9 = omega2*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t9, &sine_2, &cosine_2);
            const double cos_omega2_tau1 = cosine_2;
            const double sin_omega2_tau1 = sine_2;
            const double t13 = h3*sin_omega2_tau1;
            const double t11 = sin_omega1_tau1*t10;
            const double t14 = p1*t11 + t12*t13;
            const double t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12;
            const double t16 = cos_omega1_tau1*p2 + cos_omega2_tau1*h4;
            const double z1_3 = V*(h4*t13 + h5*sin_omega1_tau1) + t14*v1_2 + t15*z1_2 + t16*z2_2;
            const double t17 = h6*t13 + h7*sin_omega1_tau1;
            const double t18 = cos_omega1_tau1*p3 + cos_omega2_tau1*h6;
            const double t19 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1;
            const double z2_3 = V*(p1*t13 + t11*t12) + t17*v1_2 + t18*z1_2 + t19*z2_2;
            const double t20 = omega2*sin_omega2_tau1;
            const double t21 = omega1*sin_omega1_tau1;
            const double t22 = h8*t21 + h9*t20;
            const double t23 = h10*sin_omega2_tau1 + h4*t21;
            const double v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2;
            const double t24 = h11*sin_omega2_tau1 + h6*t21;
            const double t25 = h8*t20 + h9*t21;
            const double v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2;
            /* first return of tau2 */
            const double cosine_part_tau2 = h12 + v2_3;
            const double sine_part_tau2 = h13*z2_3 + omega3*z1_3;
            /* first return of tau2 */
            const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
            /* first return of tau2 */
            const double t26 = (1.0/(amplitude_tau2));
            const double cos_tau2_return = sine_part_tau2*t26;
            const double sin_tau2_return = -cosine_part_tau2*t26;
            const double tau2 = t27*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
            /* ta: linear in time */
            const double t28 = chi*z2_3;
            const double t29 = sine_part_tau2*t27;
            const double t30 = V*tau2;
            const double t31 = amplitude_tau2*t27;
            const double ta = h14*(chi*t29 + chi*t30 + e1 + h2*t31 + t28 - t29 - t30 - z2_3);
            /* d/dtau of: functions of tau in slip-stick */
            const double cos_tau_by_tau = -sin_tau;
            const double sin_tau_by_tau = cos_tau;
            /* d/dtau of: z2_1: linear in second-breaks-forward */
            const double t32 = cos_tau_by_tau*e1;
            const double z2_1_by_tau = V*sin_tau_by_tau + h12 + h15*t32;
            const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t34 + t32 + t33;
            const double z2_2_by_tau = V + z2_1_by_tau;
            const double v1_2_by_tau = cos_tau_by_tau*t34 + h16*sin_tau_by_tau;
            /* d/dtau of: slip-slip for tau1 */
            const double z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau;
            const double z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau;
            const double v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau;
            const double v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau;
            /* d/dtau1 of: slip-slip for tau1 */
            const double v1_3_by_tau1 = t28 - z1_3;
            const double v2_3_by_tau1 = h17*t28 + h18*z1_3;
            /* d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau = h13*z2_3_by_tau + omega3*z1_3_by_tau;
            /* d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1 = h13*v2_3 + omega3*v1_3;
            /* d/dtau of: first return of tau2 */
            const double t35 = 2*cosine_part_tau2;
            const double t36 = 2*sine_part_tau2;
            const double t37 = (1.0/2.0)*t26;
            const double amplitude_tau2_by_tau = t37*(sine_part_tau2_by_tau*t36 + t35*v2_3_by_tau);
            /* d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1 = t37*(sine_part_tau2_by_tau1*t36 + t35*v2_3_by_tau1);
            const double t39 = amplitude_tau2_by_tau*t38;
            const double t40 = amplitude_tau2_by_tau1*t38;
            const double t41 = t29 + t30 + z2_3;
            result[0][lane] = t41;
            result[1][lane] = -t31 + t41;
            result[2][lane] = ta;
            result[3][lane] = tau;
            result[4][lane] = tau1;
            result[5][lane] = tau2;
            slope[lane] = (t39 - t40*v1_3_by_tau/v1_3_by_tau1)/z2_1_by_tau;
            double largest = 0.0;
            largest = fabs(-V + v1_3) > largest ? fabs(-V + v1_3) : largest;
            largest = fabs(amplitude_tau2*t27*t3 - t4 - z2_1) > largest ? fabs(amplitude_tau2*t27*t3 - t4 - z2_1) : largest;
            defect[lane] = largest;
            const double finite = (slope[lane] - slope[lane]) + (result[0][lane] - result[0][lane]) + (result[1][lane] - result[1][lane]) + (result[2][lane] - result[2][lane]) + (result[3][lane] - result[3][lane]) + (result[4][lane] - result[4][lane]) + (result[5][lane] - result[5][lane]);
            int32_t ending = ((result[2][lane] <= 0.0) | (result[3][lane] <= 0.0) | (result[4][lane] <= 0.0) | (result[5][lane] <= 0.0)) ? 3 : 0;
            ending = open[lane] != 0.0 ? 1 : ending;
            ending = finite == 0.0 ? ending : 2;
            ended[lane] = ending;
        }
        for (int i = 0; i < 6; ++i)
            for (int lane = 0; lane < here; ++lane)
                unknowns[i * count + start + lane] = result[i][lane];
        for (int lane = 0; lane < here; ++lane) {
            const ptrdiff_t point = start + lane;
            trace[point] = slope[lane];
            residual[point] = defect[lane];
            iterations[point] = taken[lane];
            status[point] = ended[lane];
        }
    }
}

/* Is each of `count` orbits a motion of the real system?
 * Takes parameters (5) and unknowns (6) for each, row by row. Gives the least values of the
 * open parameters (us1, us2) under which it is; the row of
 * the boundary that is crossed inside a phase (-1 none, -2 a dwell time is not positive, -3
 * data that are not finite), by how much, and how long after the start of the phase. */
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int sums[] = {4, 3, 2, 3}, terms[] = {0, 1, 2, 1}, at_once[] = {0, 0, 0, 0};
    static const int opened[] = {-1, 0, -1, 1, -1, -1, 1, -1, -1, -1, 0, -1};
    static const int exits[] = {0, 12, 20, 40}, first_frequency[] = {0, 0, 1, 3};
    static const int begins[] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 5 * point, *const u = unknowns + 6 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {u[2], u[3], u[4], u[5]};
        double spectral[7], derivatives[14], coefficients[44], frequencies[4];
        dry_friction_spectrum(q, spectral, derivatives);
        dry_friction_global_stick_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        const double measures[] = {p[0], p[2], p[3], p[4], u[0], u[1]};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < 6; ++i)
            size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
        /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
        for (int phase = 0; phase < 4; ++phase) {
            const double miss = fabs(
                nonsmooth_evaluate(terms[phase], frequencies + first_frequency[phase],
                                   coefficients + exits[phase], durations[phase]).value);
            missed = miss > missed ? miss : missed;
        }
        const double most_missed = 0x1p-30 * size;
        const double noise = 32.0 * DBL_EPSILON * size +
                             (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
        double least[2], most = 0.0, when = 0.0;
        int found = -1, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 2; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 4 && found == -1; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[4], floor[4], maximum[4], time[4];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? -2 : -3;
            for (int i = 0; i < sums[phase]; ++i) {
                const double *const function = coefficient + i * length;
                usual[i] = opened[row + i] < 0
                    ? noise + nonsmooth_rounding(terms[phase], frequency, function, duration)
                    : least[opened[row + i]] * per_unit[row + i];
                /* a phase that begins on a boundary and rises crosses it, however little */
                const int rises = begins[row + i] && duration > 0.0 &&
                                  nonsmooth_rises(terms[phase], frequency, function, noise);
                floor[i] = rises ? -(double)INFINITY : usual[i];
            }
            nonsmooth_maxima(sums[phase], terms[phase], frequency, coefficient, duration, floor,
                             maximum, time);
            for (int i = 0; i < sums[phase] && found == -1; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = -3;
                } else if (maximum[i] > floor[i] && opened[row + i] >= 0) {
                    least[opened[row + i]] = maximum[i] / per_unit[row + i];
                } else if (maximum[i] > floor[i]) {
                    found = row + i;
                    most = maximum[i] > 0.0 ? maximum[i] : 0.0;
                    when = maximum[i] > usual[i] ? time[i] : 0.0;
                }
            }
            row += sums[phase];
            coefficient += sums[phase] * length;
            frequency += terms[phase];
        }
        for (int i = 0; i < 2; ++i)
            bounds[2 * point + i] = least[i];
        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}

/* Derivatives of the unknowns (6) and the trace by the parameters (5), at solutions of the
 * equations, for `count` points. Arrays hold columns: entry i of a point stands at
 * [i * count + point], and of the derivatives those by one parameter follow another.
 * NaN where the equations are singular: a pivot is below 1e-10 times the matrix. */
NONSMOOTH_MULTIVERSION
void dry_friction_global_stick_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = 16, n = 6, p = 5, width = 6 + 5 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[p][lanes], unknown[n][lanes], fixed[18][lanes];
        double matrix[n][width][lanes], slope[width][lanes], size[lanes], least[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < p; ++i)
                parameter[i][lane] = parameters[i * count + point];
            for (int i = 0; i < n; ++i)
                unknown[i][lane] = unknowns[i * count + point];
            size[lane] = 0.0;
            least[lane] = INFINITY;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            /* spectrum */
            const double t0 = chi*eta;
            const double t1 = 1 - t0;
            const double t2 = 4*(chi*chi);
            const double gap1 = sqrt(eta*t2 + (t1*t1));
            const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t0 + 1.0/2.0);
            const double t3 = (1.0/(omega1));
            const double t4 = sqrt(1 - chi);
            const double t5 = sqrt(chi);
            const double t6 = sqrt(eta);
            const double t7 = t5*t6;
            const double t8 = t4*t7;
            const double omega2 = t3*t8;
            const double t9 = (1.0/(gap1));
            const double t10 = (1.0/2.0)*t9;
            const double p1 = t1*t10 + 1.0/2.0;
            const double t11 = chi*t9;
            const double p2 = -t11;
            const double p3 = -t0*t9;
            const double omega3 = t7;
            /* d/dchi of: spectrum */
            const double t13 = 2*t1;
            const double gap1_by_chi = t10*(-eta*t13 + 8*t0);
            const double t14 = (1.0/2.0)*gap1_by_chi;
            const double t15 = (1.0/2.0)*eta;
            const double t16 = (1.0/2.0)*t3;
            const double omega1_by_chi = t16*(t14 + t15);
            const double t17 = (1.0/(t5));
            const double t18 = t8/(omega1*omega1);
            const double omega2_by_chi = -omega1_by_chi*t18 - t16*t7/t4 + (1.0/2.0)*t17*t3*t4*t6;
            const double t19 = (1.0/(gap1*gap1));
            const double t20 = t1*t19;
            const double p1_by_chi = -t14*t20 - t15*t9;
            const double t21 = chi*t19;
            const double p2_by_chi = gap1_by_chi*t21 - t9;
            const double t22 = t0*t19;
            const double p3_by_chi = -eta*t9 + gap1_by_chi*t22;
            const double omega3_by_chi = (1.0/2.0)*t17*t6;
            /* d/deta of: spectrum */
            const double gap1_by_eta = t10*(-chi*t13 + t2);
            const double t23 = (1.0/2.0)*gap1_by_eta;
            const double omega1_by_eta = t16*((1.0/2.0)*chi + t23);
            const double t24 = (1.0/(t6));
            const double omega2_by_eta = -omega1_by_eta*t18 + (1.0/2.0)*t24*t3*t4*t5;
            const double p1_by_eta = -1.0/2.0*t11 - t20*t23;
            const double p2_by_eta = gap1_by_eta*t21;
            const double p3_by_eta = gap1_by_eta*t22 - t11;
            const double omega3_by_eta = (1.0/2.0)*t24*t5;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega3;
            fixed[6][lane] = omega1_by_chi;
            fixed[7][lane] = omega1_by_eta;
            fixed[8][lane] = omega2_by_chi;
            fixed[9][lane] = omega2_by_eta;
            fixed[10][lane] = p1_by_chi;
            fixed[11][lane] = p1_by_eta;
            fixed[12][lane] = p2_by_chi;
            fixed[13][lane] = p2_by_eta;
            fixed[14][lane] = p3_by_chi;
            fixed[15][lane] = p3_by_eta;
            fixed[16][lane] = omega3_by_chi;
            fixed[17][lane] = omega3_by_eta;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double z10 = unknown[0][lane];
            const double z20 = unknown[1][lane];
            const double ta = unknown[2][lane];
            const double tau = unknown[3][lane];
            const double tau1 = unknown[4][lane];
            const double tau2 = unknown[5][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double omega1_by_chi = fixed[6][lane];
            const double omega1_by_eta = fixed[7][lane];
            const double omega2_by_chi = fixed[8][lane];
            const double omega2_by_eta = fixed[9][lane];
            const double p1_by_chi = fixed[10][lane];
            const double p1_by_eta = fixed[11][lane];
            const double p2_by_chi = fixed[12][lane];
            const double p2_by_eta = fixed[13][lane];
            const double p3_by_chi = fixed[14][lane];
            const double p3_by_eta = fixed[15][lane];
            const double omega3_by_chi = fixed[16][lane];
            const double omega3_by_eta = fixed[17][lane];
            /* stick-stick for ta, until first-breaks-forward */
            const double t0 = V*ta;
            const double z1_1 = t0 + z10;
            const double z2_1 = t0 + z20;
            double sine_0, cosine_0;
            nonsmooth_sincos(tau, &sine_0, &cosine_0);
            const double cos_tau = cosine_0;
            const double sin_tau = sine_0;
            /* slip-stick for tau, until second-breaks-forward */
            const double t1 = V*sin_tau;
            const double t3 = chi*cos_tau;
            const double t4 = chi - t3;
            const double t5 = chi*sin_tau;
            const double z1_2 = V*(chi*tau - t5) + cos_tau*z1_1 + t1 + t4*z2_1;
            const double z2_2 = V*tau + z2_1;
            const double t6 = V*cos_tau + V*t4;
            const double v1_2 = -sin_tau*z1_1 + t5*z2_1 + t6;
            /* functions of tau1 in slip-slip */
            const double t7 = omega1*tau1;
            double sine_1, cosine_1;
            nonsmooth_sincos(t7, &sine_1, &cosine_1);
            const double cos_omega1_tau1 = cosine_1;
            const double sin_omega1_tau1 = sine_1;
            const double t10 = omega2*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t10, &sine_2, &cosine_2);
            const double cos_omega2_tau1 = cosine_2;
            const double sin_omega2_tau1 = sine_2;
            /* slip-slip for tau1, until first-reaches-belt */
            const double t13 = (1.0/(omega1));
            const double t14 = sin_omega1_tau1*t13;
            const double t15 = 1 - p1;
            const double t16 = (1.0/(omega2));
            const double t17 = sin_omega2_tau1*t16;
            const double t18 = p1*t14 + t15*t17;
            const double t19 = cos_omega1_tau1*p1 + cos_omega2_tau1*t15;
            const double t20 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
            const double t21 = p2*t17;
            const double z1_3 = V*(p2*sin_omega1_tau1*t13 - t21) + t18*v1_2 + t19*z1_2 + t20*z2_2;
            const double t22 = p3*sin_omega1_tau1*t13 - p3*t17;
            const double t23 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
            const double t24 = cos_omega1_tau1*t15 + cos_omega2_tau1*p1;
            const double t25 = p1*t17 + t14*t15;
            const double z2_3 = V*t25 + t22*v1_2 + t23*z1_2 + t24*z2_2;
            const double t26 = omega2*sin_omega2_tau1;
            const double t27 = omega1*sin_omega1_tau1;
            const double t28 = -p1*t27 - t15*t26;
            const double t29 = p2*t27;
            const double t30 = omega2*p2*sin_omega2_tau1 - t29;
            const double t31 = V*t20;
            const double t32 = t19*v1_2 + t31;
            const double v1_3 = t28*z1_2 + t30*z2_2 + t32;
            const double t33 = omega2*p3*sin_omega2_tau1 - p3*t27;
            const double t34 = p1*t26 + t15*t27;
            const double t36 = V*t24;
            const double t37 = t23*v1_2 + t36;
            const double v2_3 = t33*z1_2 - t34*z2_2 + t37;
            /* functions of tau2 in stick-slip */
            const double t38 = omega3*tau2;
            double sine_3, cosine_3;
            nonsmooth_sincos(t38, &sine_3, &cosine_3);
            const double cos_omega3_tau2 = cosine_3;
            const double sin_omega3_tau2 = sine_3;
            /* stick-slip for tau2, until second-reaches-belt */
            const double z1_4 = V*tau2 + z1_3;
            const double t41 = 1 - cos_omega3_tau2;
            const double t42 = (1.0/(omega3));
            const double t43 = sin_omega3_tau2*t42;
            const double t44 = -t43 + tau2;
            const double z2_4 = V*t44 + cos_omega3_tau2*z2_3 + t41*z1_3 + t43*v2_3;
            const double t45 = cos_omega3_tau2*v2_3;
            const double t46 = sin_omega3_tau2*z1_3;
            const double t47 = sin_omega3_tau2*z2_3;
            const double v2_4 = V*t41 + omega3*t46 - omega3*t47 + t45;
            /* derivatives of the state after tau */
            const double z1_2_by_z20 = t4;
            const double z1_2_by_ta = t6;
            const double v1_2_by_z10 = -sin_tau;
            const double v1_2_by_z20 = t5;
            const double v1_2_by_ta = chi*t1 - t1;
            const double v1_2_by_tau = chi*z2_2 - z1_2;
            /* derivatives of the state after tau1 */
            const double z1_3_by_z10 = cos_tau*t19 + t18*v1_2_by_z10;
            const double z1_3_by_z20 = t18*v1_2_by_z20 + t19*z1_2_by_z20 + t20;
            const double z1_3_by_ta = t18*v1_2_by_ta + t19*z1_2_by_ta + t31;
            const double z1_3_by_tau = t18*v1_2_by_tau + t32;
            const double z2_3_by_z10 = cos_tau*t23 + t22*v1_2_by_z10;
            const double z2_3_by_z20 = t22*v1_2_by_z20 + t23*z1_2_by_z20 + t24;
            const double z2_3_by_ta = t22*v1_2_by_ta + t23*z1_2_by_ta + t36;
            const double z2_3_by_tau = t22*v1_2_by_tau + t37;
            const double v1_3_by_z10 = cos_tau*t28 + t19*v1_2_by_z10;
            const double v1_3_by_z20 = p2*t26 + t19*v1_2_by_z20 + t28*z1_2_by_z20 - t29;
            const double t48 = V*t30;
            const double v1_3_by_ta = t19*v1_2_by_ta + t28*z1_2_by_ta + t48;
            const double v1_3_by_tau = t19*v1_2_by_tau + t28*v1_2 + t48;
            const double t49 = chi*z2_3;
            const double v1_3_by_tau1 = t49 - z1_3;
            const double v2_3_by_z10 = cos_tau*t33 + t23*v1_2_by_z10;
            const double v2_3_by_z20 = t23*v1_2_by_z20 + t33*z1_2_by_z20 - t34;
            const double t50 = -V*t34;
            const double v2_3_by_ta = t23*v1_2_by_ta + t33*z1_2_by_ta + t50;
            const double v2_3_by_tau = t23*v1_2_by_tau + t33*v1_2 + t50;
            const double t51 = chi*eta;
            const double v2_3_by_tau1 = -eta*t49 + t51*z1_3;
            /* derivatives of the state after tau2 */
            const double z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t41*z1_3_by_z10 + t43*v2_3_by_z10;
            const double z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t41*z1_3_by_z20 + t43*v2_3_by_z20;
            const double z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t41*z1_3_by_ta + t43*v2_3_by_ta;
            const double z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t41*z1_3_by_tau + t43*v2_3_by_tau;
            const double z2_4_by_tau1 = t41*v1_3 + t43*v2_3_by_tau1 + t45;
            const double t52 = omega3*sin_omega3_tau2;
            const double v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t52*z1_3_by_z10 - t52*z2_3_by_z10;
            const double v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t52*z1_3_by_z20 - t52*z2_3_by_z20;
            const double v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t52*z1_3_by_ta - t52*z2_3_by_ta;
            const double v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t52*z1_3_by_tau - t52*z2_3_by_tau;
            const double v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t52*v1_3 - t52*v2_3;
            const double v2_4_by_tau2 = t51*z1_4 - t51*z2_4;
            /* d/dchi of: slip-stick for tau, until second-breaks-forward */
            const double t53 = 1 - cos_tau;
            const double z1_2_by_chi = V*(-sin_tau + tau) + t53*z2_1;
            const double v1_2_by_chi = V*t53 + sin_tau*z2_1;
            /* d/dV of: slip-stick for tau, until second-breaks-forward */
            const double z1_2_by_V = chi*tau + cos_tau*ta + sin_tau + t4*ta - t5;
            const double z2_2_by_V = ta + tau;
            const double v1_2_by_V = chi + cos_tau - sin_tau*ta - t3 + t5*ta;
            /* d/dchi of: functions of tau1 in slip-slip */
            const double t55 = omega1_by_chi*tau1;
            const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t55;
            const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t55;
            const double t56 = omega2_by_chi*tau1;
            const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t56;
            const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t56;
            /* d/deta of: functions of tau1 in slip-slip */
            const double t57 = omega1_by_eta*tau1;
            const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t57;
            const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t57;
            const double t58 = omega2_by_eta*tau1;
            const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t58;
            const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t58;
            /* d/dchi of: slip-slip for tau1, until first-reaches-belt */
            const double t59 = p1*z1_2;
            const double t60 = p2*z2_2;
            const double t61 = t59 + t60;
            const double t62 = t15*z1_2 - t60;
            const double t63 = p1*v1_2;
            const double t64 = sin_omega1_tau1/(omega1*omega1);
            const double t65 = V*p2;
            const double t66 = -t63*t64 - t64*t65;
            const double t67 = (1.0/(omega2*omega2));
            const double t68 = sin_omega2_tau1*t67;
            const double t69 = -t15*t68*v1_2 + t65*t68;
            const double t70 = -sin_omega1_tau1*t13 + t17;
            const double t72 = cos_omega1_tau1 - cos_omega2_tau1;
            const double t73 = -t70*v1_2 + t72*z1_2;
            const double t74 = -V*t70 + t72*z2_2;
            const double t75 = t13*t63 + t13*t65;
            const double t76 = t15*t16*v1_2 - t16*t65;
            const double z1_3_by_chi = cos_omega1_tau1_by_chi*t61 + cos_omega2_tau1_by_chi*t62 + omega1_by_chi*t66 + omega2_by_chi*t69 + p1_by_chi*t73 + p2_by_chi*t74 + sin_omega1_tau1_by_chi*t75 + sin_omega2_tau1_by_chi*t76 + t18*v1_2_by_chi + t19*z1_2_by_chi;
            const double t77 = p3*z1_2;
            const double t78 = t15*z2_2;
            const double t79 = t77 + t78;
            const double t80 = p1*z2_2;
            const double t81 = -t77 + t80;
            const double t82 = p3*v1_2;
            const double t83 = V*t15;
            const double t84 = -t64*t82 - t64*t83;
            const double t85 = V*p1;
            const double t86 = p3*sin_omega2_tau1*t67*v1_2 - t68*t85;
            const double t88 = V*t70 - t72*z2_2;
            const double t89 = t13*t82 + t13*t83;
            const double t90 = -t16*t82 + t16*t85;
            const double z2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t81 + omega1_by_chi*t84 + omega2_by_chi*t86 + p1_by_chi*t88 + p3_by_chi*t73 + sin_omega1_tau1_by_chi*t89 + sin_omega2_tau1_by_chi*t90 + t22*v1_2_by_chi + t23*z1_2_by_chi;
            const double t91 = t63 + t65;
            const double t92 = t15*v1_2 - t65;
            const double t93 = -sin_omega1_tau1*t59 - sin_omega1_tau1*t60;
            const double t94 = t15*z1_2;
            const double t95 = sin_omega2_tau1*t60 - sin_omega2_tau1*t94;
            const double t96 = -omega2*sin_omega2_tau1 + t27;
            const double t98 = t72*v1_2 - t96*z1_2;
            const double t99 = V*t72 - t96*z2_2;
            const double t100 = -omega1*t59 - omega1*t60;
            const double t101 = omega2*t60 - omega2*t94;
            const double v1_3_by_chi = cos_omega1_tau1_by_chi*t91 + cos_omega2_tau1_by_chi*t92 + omega1_by_chi*t93 + omega2_by_chi*t95 + p1_by_chi*t98 + p2_by_chi*t99 + sin_omega1_tau1_by_chi*t100 + sin_omega2_tau1_by_chi*t101 + t19*v1_2_by_chi + t28*z1_2_by_chi;
            const double t102 = t82 + t83;
            const double t103 = -t82 + t85;
            const double t104 = -sin_omega1_tau1*t77 - sin_omega1_tau1*t78;
            const double t105 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t80;
            const double t106 = -V*t72 + t96*z2_2;
            const double t107 = -omega1*t77 - omega1*t78;
            const double t108 = omega2*p3*z1_2 - omega2*t80;
            const double v2_3_by_chi = cos_omega1_tau1_by_chi*t102 + cos_omega2_tau1_by_chi*t103 + omega1_by_chi*t104 + omega2_by_chi*t105 + p1_by_chi*t106 + p3_by_chi*t98 + sin_omega1_tau1_by_chi*t107 + sin_omega2_tau1_by_chi*t108 + t23*v1_2_by_chi + t33*z1_2_by_chi;
            /* d/deta of: slip-slip for tau1, until first-reaches-belt */
            const double z1_3_by_eta = cos_omega1_tau1_by_eta*t61 + cos_omega2_tau1_by_eta*t62 + omega1_by_eta*t66 + omega2_by_eta*t69 + p1_by_eta*t73 + p2_by_eta*t74 + sin_omega1_tau1_by_eta*t75 + sin_omega2_tau1_by_eta*t76;
            const double z2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t81 + omega1_by_eta*t84 + omega2_by_eta*t86 + p1_by_eta*t88 + p3_by_eta*t73 + sin_omega1_tau1_by_eta*t89 + sin_omega2_tau1_by_eta*t90;
            const double v1_3_by_eta = cos_omega1_tau1_by_eta*t91 + cos_omega2_tau1_by_eta*t92 + omega1_by_eta*t93 + omega2_by_eta*t95 + p1_by_eta*t98 + p2_by_eta*t99 + sin_omega1_tau1_by_eta*t100 + sin_omega2_tau1_by_eta*t101;
            const double v2_3_by_eta = cos_omega1_tau1_by_eta*t102 + cos_omega2_tau1_by_eta*t103 + omega1_by_eta*t104 + omega2_by_eta*t105 + p1_by_eta*t106 + p3_by_eta*t98 + sin_omega1_tau1_by_eta*t107 + sin_omega2_tau1_by_eta*t108;
            /* d/dV of: slip-slip for tau1, until first-reaches-belt */
            const double z1_3_by_V = p2*t14 + t18*v1_2_by_V + t19*z1_2_by_V + t20*z2_2_by_V - t21;
            const double z2_3_by_V = t22*v1_2_by_V + t23*z1_2_by_V + t24*z2_2_by_V + t25;
            const double v1_3_by_V = t19*v1_2_by_V + t20 + t28*z1_2_by_V + t30*z2_2_by_V;
            const double v2_3_by_V = t23*v1_2_by_V + t24 + t33*z1_2_by_V - t34*z2_2_by_V;
            /* d/dchi of: functions of tau2 in stick-slip */
            const double t109 = omega3_by_chi*tau2;
            const double cos_omega3_tau2_by_chi = -sin_omega3_tau2*t109;
            const double sin_omega3_tau2_by_chi = cos_omega3_tau2*t109;
            /* d/deta of: functions of tau2 in stick-slip */
            const double t110 = omega3_by_eta*tau2;
            const double cos_omega3_tau2_by_eta = -sin_omega3_tau2*t110;
            const double sin_omega3_tau2_by_eta = cos_omega3_tau2*t110;
            /* d/dchi of: stick-slip for tau2, until second-reaches-belt */
            const double t111 = -z1_3 + z2_3;
            const double t112 = sin_omega3_tau2/(omega3*omega3);
            const double t113 = V*t112 - t112*v2_3;
            const double t114 = -V*t42 + t42*v2_3;
            const double z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t111 + omega3_by_chi*t113 + sin_omega3_tau2_by_chi*t114 + t41*z1_3_by_chi + t43*v2_3_by_chi;
            const double t115 = -V + v2_3;
            const double t116 = t46 - t47;
            const double t117 = omega3*z1_3 - omega3*z2_3;
            const double v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t115 + omega3_by_chi*t116 + sin_omega3_tau2_by_chi*t117 + t52*z1_3_by_chi - t52*z2_3_by_chi;
            /* d/deta of: stick-slip for tau2, until second-reaches-belt */
            const double z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t111 + omega3_by_eta*t113 + sin_omega3_tau2_by_eta*t114 + t41*z1_3_by_eta + t43*v2_3_by_eta;
            const double v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t115 + omega3_by_eta*t116 + sin_omega3_tau2_by_eta*t117 + t52*z1_3_by_eta - t52*z2_3_by_eta;
            /* d/dV of: stick-slip for tau2, until second-reaches-belt */
            const double z1_4_by_V = tau2 + z1_3_by_V;
            const double z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t41*z1_3_by_V + t43*v2_3_by_V + t44;
            const double v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t52*z1_3_by_V - t52*z2_3_by_V + 1;
            /* outputs */
            const double t118 = V*chi;
            matrix[0][0][lane] = 1;
            matrix[0][1][lane] = -chi;
            matrix[0][2][lane] = V - t118;
            matrix[0][3][lane] = 0;
            matrix[0][4][lane] = 0;
            matrix[0][5][lane] = 0;
            matrix[1][0][lane] = -t3;
            matrix[1][1][lane] = -chi*z1_2_by_z20 + chi;
            matrix[1][2][lane] = -chi*z1_2_by_ta + t118;
            matrix[1][3][lane] = -chi*v1_2 + t118;
            matrix[1][4][lane] = 0;
            matrix[1][5][lane] = 0;
            matrix[2][0][lane] = v1_3_by_z10;
            matrix[2][1][lane] = v1_3_by_z20;
            matrix[2][2][lane] = v1_3_by_ta;
            matrix[2][3][lane] = v1_3_by_tau;
            matrix[2][4][lane] = v1_3_by_tau1;
            matrix[2][5][lane] = 0;
            matrix[3][0][lane] = v2_4_by_z10;
            matrix[3][1][lane] = v2_4_by_z20;
            matrix[3][2][lane] = v2_4_by_ta;
            matrix[3][3][lane] = v2_4_by_tau;
            matrix[3][4][lane] = v2_4_by_tau1;
            matrix[3][5][lane] = v2_4_by_tau2;
            matrix[4][0][lane] = z1_3_by_z10 - 1;
            matrix[4][1][lane] = z1_3_by_z20;
            matrix[4][2][lane] = z1_3_by_ta;
            matrix[4][3][lane] = z1_3_by_tau;
            matrix[4][4][lane] = v1_3;
            matrix[4][5][lane] = V;
            matrix[5][0][lane] = z2_4_by_z10;
            matrix[5][1][lane] = z2_4_by_z20 - 1;
            matrix[5][2][lane] = z2_4_by_ta;
            matrix[5][3][lane] = z2_4_by_tau;
            matrix[5][4][lane] = z2_4_by_tau1;
            matrix[5][5][lane] = v2_4;
            matrix[0][6][lane] = z2_1;
            matrix[0][7][lane] = 0;
            matrix[0][8][lane] = chi*ta - ta;
            matrix[0][9][lane] = 1;
            matrix[0][10][lane] = 0;
            matrix[1][6][lane] = chi*z1_2_by_chi + z1_2 - z2_2;
            matrix[1][7][lane] = 0;
            matrix[1][8][lane] = chi*z1_2_by_V - chi*z2_2_by_V;
            matrix[1][9][lane] = 0;
            matrix[1][10][lane] = 1;
            matrix[2][6][lane] = -v1_3_by_chi;
            matrix[2][7][lane] = -v1_3_by_eta;
            matrix[2][8][lane] = 1 - v1_3_by_V;
            matrix[2][9][lane] = 0;
            matrix[2][10][lane] = 0;
            matrix[3][6][lane] = -v2_4_by_chi;
            matrix[3][7][lane] = -v2_4_by_eta;
            matrix[3][8][lane] = 1 - v2_4_by_V;
            matrix[3][9][lane] = 0;
            matrix[3][10][lane] = 0;
            matrix[4][6][lane] = -z1_3_by_chi;
            matrix[4][7][lane] = -z1_3_by_eta;
            matrix[4][8][lane] = -z1_4_by_V;
            matrix[4][9][lane] = 0;
            matrix[4][10][lane] = 0;
            matrix[5][6][lane] = -z2_4_by_chi;
            matrix[5][7][lane] = -z2_4_by_eta;
            matrix[5][8][lane] = -z2_4_by_V;
            matrix[5][9][lane] = 0;
            matrix[5][10][lane] = 0;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double e1 = parameter[3][lane];
            const double e2 = parameter[4][lane];
            const double tau = unknown[3][lane];
            const double tau1 = unknown[4][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double omega1_by_chi = fixed[6][lane];
            const double omega1_by_eta = fixed[7][lane];
            const double omega2_by_chi = fixed[8][lane];
            const double omega2_by_eta = fixed[9][lane];
            const double p1_by_chi = fixed[10][lane];
            const double p1_by_eta = fixed[11][lane];
            const double p2_by_chi = fixed[12][lane];
            const double p2_by_eta = fixed[13][lane];
            const double p3_by_chi = fixed[14][lane];
            const double p3_by_eta = fixed[15][lane];
            const double omega3_by_chi = fixed[16][lane];
            const double omega3_by_eta = fixed[17][lane];
            double sine_0, cosine_0;
            nonsmooth_sincos(tau, &sine_0, &cosine_0);
            const double cos_tau = cosine_0;
            const double sin_tau = sine_0;
            /* z2_1: linear in second-breaks-forward */
            const double t2 = V*tau;
            const double t3 = chi - 1;
            const double t4 = (1.0/(t3));
            const double t5 = cos_tau*t4;
            const double t6 = (1.0/(chi));
            const double t7 = t4*t6;
            const double z2_1 = V*sin_tau - e1*t5 - e2*t7 - t2;
            /* slip-stick for tau */
            const double t8 = chi*z2_1;
            const double t9 = e1 + t8;
            const double t10 = chi*cos_tau;
            const double t11 = chi - t10;
            const double t12 = chi*sin_tau;
            const double z1_2 = V*sin_tau + V*(chi*tau - t12) + cos_tau*t9 + t11*z2_1;
            const double z2_2 = t2 + z2_1;
            const double v1_2 = V*cos_tau + V*t11 + sin_tau*t8 - sin_tau*t9;
            /* functions of tau1 in slip-slip */
            const double t13 = omega1*tau1;
            double sine_1, cosine_1;
            nonsmooth_sincos(t13, &sine_1, &cosine_1);
            const double cos_omega1_tau1 = cosine_1;
            const double sin_omega1_tau1 = sine_1;
            const double t16 = omega2*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t16, &sine_2, &cosine_2);
            const double cos_omega2_tau1 = cosine_2;
            const double sin_omega2_tau1 = sine_2;
            /* slip-slip for tau1 */
            const double t19 = (1.0/(omega1));
            const double t20 = sin_omega1_tau1*t19;
            const double t21 = 1 - p1;
            const double t22 = (1.0/(omega2));
            const double t23 = sin_omega2_tau1*t22;
            const double t24 = p1*t20 + t21*t23;
            const double t25 = cos_omega1_tau1*p1 + cos_omega2_tau1*t21;
            const double t26 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2;
            const double t27 = p2*t23;
            const double z1_3 = V*(p2*sin_omega1_tau1*t19 - t27) + t24*v1_2 + t25*z1_2 + t26*z2_2;
            const double t28 = p3*sin_omega1_tau1*t19 - p3*t23;
            const double t29 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3;
            const double t30 = cos_omega1_tau1*t21 + cos_omega2_tau1*p1;
            const double t31 = p1*t23 + t20*t21;
            const double z2_3 = V*t31 + t28*v1_2 + t29*z1_2 + t30*z2_2;
            const double t32 = omega2*sin_omega2_tau1;
            const double t33 = omega1*sin_omega1_tau1;
            const double t34 = -p1*t33 - t21*t32;
            const double t35 = omega2*p2*sin_omega2_tau1 - p2*t33;
            const double v1_3 = V*t26 + t25*v1_2 + t34*z1_2 + t35*z2_2;
            const double t36 = omega2*p3*sin_omega2_tau1 - p3*t33;
            const double t37 = -p1*t32 - t21*t33;
            const double v2_3 = V*t30 + t29*v1_2 + t36*z1_2 + t37*z2_2;
            /* first return of tau2 */
            const double cosine_part_tau2 = -V + v2_3;
            const double sine_part_tau2 = omega3*z1_3 - omega3*z2_3;
            /* first return of tau2 */
            const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
            /* d/dtau of: functions of tau in slip-stick */
            const double cos_tau_by_tau = -sin_tau;
            const double sin_tau_by_tau = cos_tau;
            /* d/dtau of: z2_1: linear in second-breaks-forward */
            const double t40 = -V*sin_tau_by_tau;
            const double t41 = cos_tau_by_tau*e1;
            const double z2_1_by_tau = -V - t4*t41 - t40;
            /* d/dtau of: slip-stick for tau */
            const double t42 = V*chi;
            const double t43 = V - t42;
            const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t43 + t41 + t42;
            const double z2_2_by_tau = V + z2_1_by_tau;
            const double v1_2_by_tau = cos_tau_by_tau*t43 - e1*sin_tau_by_tau;
            /* d/dtau of: slip-slip for tau1 */
            const double z1_3_by_tau = t24*v1_2_by_tau + t25*z1_2_by_tau + t26*z2_2_by_tau;
            const double z2_3_by_tau = t28*v1_2_by_tau + t29*z1_2_by_tau + t30*z2_2_by_tau;
            const double v1_3_by_tau = t25*v1_2_by_tau + t34*z1_2_by_tau + t35*z2_2_by_tau;
            const double v2_3_by_tau = t29*v1_2_by_tau + t36*z1_2_by_tau + t37*z2_2_by_tau;
            /* d/dtau1 of: slip-slip for tau1 */
            const double t45 = chi*z2_3;
            const double v1_3_by_tau1 = t45 - z1_3;
            const double t46 = eta*z1_3;
            const double v2_3_by_tau1 = chi*t46 - eta*t45;
            /* d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau;
            /* d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3;
            /* d/dtau of: first return of tau2 */
            const double t47 = 2*cosine_part_tau2;
            const double t48 = 2*sine_part_tau2;
            const double t49 = sine_part_tau2_by_tau*t48 + t47*v2_3_by_tau;
            const double t50 = (1.0/(amplitude_tau2));
            const double t51 = (1.0/2.0)*t50;
            const double amplitude_tau2_by_tau = t49*t51;
            /* d/dtau1 of: first return of tau2 */
            const double t52 = sine_part_tau2_by_tau1*t48 + t47*v2_3_by_tau1;
            const double amplitude_tau2_by_tau1 = t51*t52;
            /* d/dchi of: z2_1: linear in second-breaks-forward */
            const double t53 = (1.0/(t3*t3));
            const double z2_1_by_chi = cos_tau*e1*t53 + e2*t53*t6 + e2*t4/(chi*chi);
            /* d/dV of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_V = sin_tau - tau;
            /* d/de1 of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_e1 = -t5;
            /* d/de2 of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_e2 = -t7;
            /* d/dchi of: slip-stick for tau */
            const double t55 = 1 - cos_tau;
            const double z1_2_by_chi = -V*z2_1_by_V + chi*z2_1_by_chi + cos_tau*z2_1 + t55*z2_1;
            const double v1_2_by_chi = V*t55;
            /* d/dV of: slip-stick for tau */
            const double z1_2_by_V = chi*tau + chi*z2_1_by_V + sin_tau - t12;
            const double z2_2_by_V = tau + z2_1_by_V;
            const double v1_2_by_V = chi + cos_tau - t10;
            /* d/de1 of: slip-stick for tau */
            const double z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau;
            const double v1_2_by_e1 = -sin_tau;
            /* d/de2 of: slip-stick for tau */
            const double z1_2_by_e2 = chi*z2_1_by_e2;
            /* d/dtau1 of: functions of tau1 in slip-slip */
            const double cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1;
            const double sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1;
            const double cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1;
            const double sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2;
            /* d/dchi of: functions of tau1 in slip-slip */
            const double t56 = omega1_by_chi*tau1;
            const double cos_omega1_tau1_by_chi = -sin_omega1_tau1*t56;
            const double sin_omega1_tau1_by_chi = cos_omega1_tau1*t56;
            const double t57 = omega2_by_chi*tau1;
            const double cos_omega2_tau1_by_chi = -sin_omega2_tau1*t57;
            const double sin_omega2_tau1_by_chi = cos_omega2_tau1*t57;
            /* d/deta of: functions of tau1 in slip-slip */
            const double t58 = omega1_by_eta*tau1;
            const double cos_omega1_tau1_by_eta = -sin_omega1_tau1*t58;
            const double sin_omega1_tau1_by_eta = cos_omega1_tau1*t58;
            const double t59 = omega2_by_eta*tau1;
            const double cos_omega2_tau1_by_eta = -sin_omega2_tau1*t59;
            const double sin_omega2_tau1_by_eta = cos_omega2_tau1*t59;
            /* d/dtau1 of: slip-slip for tau1 */
            const double t60 = p1*z1_2;
            const double t61 = p2*z2_2;
            const double t62 = t60 + t61;
            const double t63 = t21*z1_2 - t61;
            const double t64 = p1*v1_2;
            const double t65 = V*p2;
            const double t66 = t19*t64 + t19*t65;
            const double t67 = t21*t22*v1_2 - t22*t65;
            const double z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t62 + cos_omega2_tau1_by_tau1*t63 + sin_omega1_tau1_by_tau1*t66 + sin_omega2_tau1_by_tau1*t67;
            const double t68 = p3*z1_2;
            const double t69 = t21*z2_2;
            const double t70 = t68 + t69;
            const double t71 = p1*z2_2;
            const double t72 = -t68 + t71;
            const double t73 = p3*v1_2;
            const double t74 = V*t21;
            const double t75 = t19*t73 + t19*t74;
            const double t76 = V*p1;
            const double t77 = -t22*t73 + t22*t76;
            const double z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t70 + cos_omega2_tau1_by_tau1*t72 + sin_omega1_tau1_by_tau1*t75 + sin_omega2_tau1_by_tau1*t77;
            /* d/dchi of: slip-slip for tau1 */
            const double t78 = sin_omega1_tau1/(omega1*omega1);
            const double t79 = -t64*t78 - t65*t78;
            const double t80 = (1.0/(omega2*omega2));
            const double t81 = sin_omega2_tau1*t80;
            const double t82 = -t21*t81*v1_2 + t65*t81;
            const double t83 = -sin_omega1_tau1*t19 + t23;
            const double t85 = cos_omega1_tau1 - cos_omega2_tau1;
            const double t86 = -t83*v1_2 + t85*z1_2;
            const double t87 = -V*t83 + t85*z2_2;
            const double z1_3_by_chi = cos_omega1_tau1_by_chi*t62 + cos_omega2_tau1_by_chi*t63 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau1_by_chi*t66 + sin_omega2_tau1_by_chi*t67 + t24*v1_2_by_chi + t25*z1_2_by_chi + t26*z2_1_by_chi;
            const double t88 = -t73*t78 - t74*t78;
            const double t89 = p3*sin_omega2_tau1*t80*v1_2 - t76*t81;
            const double t91 = V*t83 - t85*z2_2;
            const double z2_3_by_chi = cos_omega1_tau1_by_chi*t70 + cos_omega2_tau1_by_chi*t72 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau1_by_chi*t75 + sin_omega2_tau1_by_chi*t77 + t28*v1_2_by_chi + t29*z1_2_by_chi + t30*z2_1_by_chi;
            const double t92 = t64 + t65;
            const double t93 = t21*v1_2 - t65;
            const double t94 = -sin_omega1_tau1*t60 - sin_omega1_tau1*t61;
            const double t95 = t21*z1_2;
            const double t96 = sin_omega2_tau1*t61 - sin_omega2_tau1*t95;
            const double t97 = -omega2*sin_omega2_tau1 + t33;
            const double t99 = t85*v1_2 - t97*z1_2;
            const double t100 = V*t85 - t97*z2_2;
            const double t101 = -omega1*t60 - omega1*t61;
            const double t102 = omega2*t61 - omega2*t95;
            const double v1_3_by_chi = cos_omega1_tau1_by_chi*t92 + cos_omega2_tau1_by_chi*t93 + omega1_by_chi*t94 + omega2_by_chi*t96 + p1_by_chi*t99 + p2_by_chi*t100 + sin_omega1_tau1_by_chi*t101 + sin_omega2_tau1_by_chi*t102 + t25*v1_2_by_chi + t34*z1_2_by_chi + t35*z2_1_by_chi;
            const double t103 = t73 + t74;
            const double t104 = -t73 + t76;
            const double t105 = -sin_omega1_tau1*t68 - sin_omega1_tau1*t69;
            const double t106 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t71;
            const double t107 = -V*t85 + t97*z2_2;
            const double t108 = -omega1*t68 - omega1*t69;
            const double t109 = omega2*p3*z1_2 - omega2*t71;
            const double v2_3_by_chi = cos_omega1_tau1_by_chi*t103 + cos_omega2_tau1_by_chi*t104 + omega1_by_chi*t105 + omega2_by_chi*t106 + p1_by_chi*t107 + p3_by_chi*t99 + sin_omega1_tau1_by_chi*t108 + sin_omega2_tau1_by_chi*t109 + t29*v1_2_by_chi + t36*z1_2_by_chi + t37*z2_1_by_chi;
            /* d/deta of: slip-slip for tau1 */
            const double z1_3_by_eta = cos_omega1_tau1_by_eta*t62 + cos_omega2_tau1_by_eta*t63 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau1_by_eta*t66 + sin_omega2_tau1_by_eta*t67;
            const double z2_3_by_eta = cos_omega1_tau1_by_eta*t70 + cos_omega2_tau1_by_eta*t72 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau1_by_eta*t75 + sin_omega2_tau1_by_eta*t77;
            const double v1_3_by_eta = cos_omega1_tau1_by_eta*t92 + cos_omega2_tau1_by_eta*t93 + omega1_by_eta*t94 + omega2_by_eta*t96 + p1_by_eta*t99 + p2_by_eta*t100 + sin_omega1_tau1_by_eta*t101 + sin_omega2_tau1_by_eta*t102;
            const double v2_3_by_eta = cos_omega1_tau1_by_eta*t103 + cos_omega2_tau1_by_eta*t104 + omega1_by_eta*t105 + omega2_by_eta*t106 + p1_by_eta*t107 + p3_by_eta*t99 + sin_omega1_tau1_by_eta*t108 + sin_omega2_tau1_by_eta*t109;
            /* d/dV of: slip-slip for tau1 */
            const double z1_3_by_V = p2*t20 + t24*v1_2_by_V + t25*z1_2_by_V + t26*z2_2_by_V - t27;
            const double z2_3_by_V = t28*v1_2_by_V + t29*z1_2_by_V + t30*z2_2_by_V + t31;
            const double v1_3_by_V = t25*v1_2_by_V + t26 + t34*z1_2_by_V + t35*z2_2_by_V;
            const double v2_3_by_V = t29*v1_2_by_V + t30 + t36*z1_2_by_V + t37*z2_2_by_V;
            /* d/de1 of: slip-slip for tau1 */
            const double z1_3_by_e1 = t24*v1_2_by_e1 + t25*z1_2_by_e1 + t26*z2_1_by_e1;
            const double z2_3_by_e1 = t28*v1_2_by_e1 + t29*z1_2_by_e1 + t30*z2_1_by_e1;
            const double v1_3_by_e1 = t25*v1_2_by_e1 + t34*z1_2_by_e1 + t35*z2_1_by_e1;
            const double v2_3_by_e1 = t29*v1_2_by_e1 + t36*z1_2_by_e1 + t37*z2_1_by_e1;
            /* d/de2 of: slip-slip for tau1 */
            const double z1_3_by_e2 = t25*z1_2_by_e2 + t26*z2_1_by_e2;
            const double z2_3_by_e2 = t29*z1_2_by_e2 + t30*z2_1_by_e2;
            const double v1_3_by_e2 = t34*z1_2_by_e2 + t35*z2_1_by_e2;
            const double v2_3_by_e2 = t36*z1_2_by_e2 + t37*z2_1_by_e2;
            /* d/dchi of: first return of tau2 */
            const double t110 = z1_3 - z2_3;
            const double sine_part_tau2_by_chi = omega3*z1_3_by_chi - omega3*z2_3_by_chi + omega3_by_chi*t110;
            /* d/deta of: first return of tau2 */
            const double sine_part_tau2_by_eta = omega3*z1_3_by_eta - omega3*z2_3_by_eta + omega3_by_eta*t110;
            /* d/dV of: first return of tau2 */
            const double cosine_part_tau2_by_V = v2_3_by_V - 1;
            const double sine_part_tau2_by_V = omega3*z1_3_by_V - omega3*z2_3_by_V;
            /* d/de1 of: first return of tau2 */
            const double sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1;
            /* d/de2 of: first return of tau2 */
            const double sine_part_tau2_by_e2 = omega3*z1_3_by_e2 - omega3*z2_3_by_e2;
            /* d/dchi of: first return of tau2 */
            const double amplitude_tau2_by_chi = t51*(sine_part_tau2_by_chi*t48 + t47*v2_3_by_chi);
            /* d/deta of: first return of tau2 */
            const double amplitude_tau2_by_eta = t51*(sine_part_tau2_by_eta*t48 + t47*v2_3_by_eta);
            /* d/dV of: first return of tau2 */
            const double amplitude_tau2_by_V = t51*(cosine_part_tau2_by_V*t47 + sine_part_tau2_by_V*t48);
            /* d/de1 of: first return of tau2 */
            const double amplitude_tau2_by_e1 = t51*(sine_part_tau2_by_e1*t48 + t47*v2_3_by_e1);
            /* d/de2 of: first return of tau2 */
            const double amplitude_tau2_by_e2 = t51*(sine_part_tau2_by_e2*t48 + t47*v2_3_by_e2);
            /* d/dtau of: d/dtau of: functions of tau in slip-stick */
            const double cos_tau_by_tau_by_tau = -cos_tau;
            const double sin_tau_by_tau_by_tau = -sin_tau;
            /* d/dtau of: d/dtau of: z2_1: linear in second-breaks-forward */
            const double t111 = cos_tau_by_tau_by_tau*e1;
            const double z2_1_by_tau_by_tau = V*sin_tau_by_tau_by_tau - t111*t4;
            /* d/dchi of: d/dtau of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_tau_by_chi = t41*t53;
            /* d/dV of: d/dtau of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_tau_by_V = sin_tau_by_tau - 1;
            /* d/de1 of: d/dtau of: z2_1: linear in second-breaks-forward */
            const double z2_1_by_tau_by_e1 = -cos_tau_by_tau*t4;
            /* d/dtau of: d/dtau of: slip-stick for tau */
            const double z1_2_by_tau_by_tau = chi*z2_1_by_tau_by_tau + sin_tau_by_tau_by_tau*t43 + t111;
            const double v1_2_by_tau_by_tau = cos_tau_by_tau_by_tau*t43 - e1*sin_tau_by_tau_by_tau;
            /* d/dchi of: d/dtau of: slip-stick for tau */
            const double z1_2_by_tau_by_chi = chi*z2_1_by_tau_by_chi + t40 + z2_2_by_tau;
            const double v1_2_by_tau_by_chi = -V*cos_tau_by_tau;
            /* d/dV of: d/dtau of: slip-stick for tau */
            const double z1_2_by_tau_by_V = chi*z2_1_by_tau_by_V + chi - sin_tau_by_tau*t3;
            const double z2_2_by_tau_by_V = z2_1_by_tau_by_V + 1;
            const double v1_2_by_tau_by_V = -cos_tau_by_tau*t3;
            /* d/de1 of: d/dtau of: slip-stick for tau */
            const double z1_2_by_tau_by_e1 = chi*z2_1_by_tau_by_e1 + cos_tau_by_tau;
            const double v1_2_by_tau_by_e1 = -sin_tau_by_tau;
            /* d/dtau of: d/dtau of: slip-slip for tau1 */
            const double z1_3_by_tau_by_tau = t24*v1_2_by_tau_by_tau + t25*z1_2_by_tau_by_tau + t26*z2_1_by_tau_by_tau;
            const double z2_3_by_tau_by_tau = t28*v1_2_by_tau_by_tau + t29*z1_2_by_tau_by_tau + t30*z2_1_by_tau_by_tau;
            const double v1_3_by_tau_by_tau = t25*v1_2_by_tau_by_tau + t34*z1_2_by_tau_by_tau + t35*z2_1_by_tau_by_tau;
            const double v2_3_by_tau_by_tau = t29*v1_2_by_tau_by_tau + t36*z1_2_by_tau_by_tau + t37*z2_1_by_tau_by_tau;
            /* d/dtau1 of: d/dtau of: slip-slip for tau1 */
            const double t113 = p1*z1_2_by_tau;
            const double t114 = p2*z2_2_by_tau;
            const double t115 = t113 + t114;
            const double t116 = -t114 + t21*z1_2_by_tau;
            const double t117 = t19*v1_2_by_tau;
            const double t118 = sin_omega1_tau1_by_tau1*t117;
            const double t119 = t22*v1_2_by_tau;
            const double t120 = sin_omega2_tau1_by_tau1*t119;
            const double z1_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t115 + cos_omega2_tau1_by_tau1*t116 + p1*t118 + t120*t21;
            const double t121 = p3*z1_2_by_tau;
            const double t122 = t21*z2_2_by_tau;
            const double t123 = t121 + t122;
            const double t124 = p1*z2_2_by_tau;
            const double t125 = -t121 + t124;
            const double z2_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t123 + cos_omega2_tau1_by_tau1*t125 + p3*t118 - p3*t120;
            const double t126 = -omega1*t113 - omega1*t114;
            const double t127 = t21*z1_2_by_tau;
            const double t128 = omega2*t114 - omega2*t127;
            const double t129 = cos_omega1_tau1_by_tau1*v1_2_by_tau;
            const double t130 = cos_omega2_tau1_by_tau1*v1_2_by_tau;
            const double v1_3_by_tau_by_tau1 = p1*t129 + sin_omega1_tau1_by_tau1*t126 + sin_omega2_tau1_by_tau1*t128 + t130*t21;
            const double t131 = -omega1*t121 - omega1*t122;
            const double t132 = omega2*p3*z1_2_by_tau - omega2*t124;
            const double v2_3_by_tau_by_tau1 = p3*t129 - p3*t130 + sin_omega1_tau1_by_tau1*t131 + sin_omega2_tau1_by_tau1*t132;
            /* d/dchi of: d/dtau of: slip-slip for tau1 */
            const double t133 = -t83*v1_2_by_tau + t85*z1_2_by_tau;
            const double t134 = p2_by_chi*z2_2_by_tau;
            const double t135 = sin_omega1_tau1_by_chi*t117;
            const double t136 = sin_omega2_tau1_by_chi*t119;
            const double t137 = t78*v1_2_by_tau;
            const double t138 = omega1_by_chi*t137;
            const double t139 = t81*v1_2_by_tau;
            const double t140 = omega2_by_chi*t139;
            const double z1_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t115 + cos_omega2_tau1_by_chi*t116 + p1*t135 - p1*t138 + p1_by_chi*t133 + t134*t85 + t136*t21 - t140*t21 + t24*v1_2_by_tau_by_chi + t25*z1_2_by_tau_by_chi + t26*z2_1_by_tau_by_chi;
            const double t141 = p1_by_chi*z2_2_by_tau;
            const double z2_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t123 + cos_omega2_tau1_by_chi*t125 + p3*t135 - p3*t136 - p3*t138 + p3*t140 + p3_by_chi*t133 - t141*t85 + t28*v1_2_by_tau_by_chi + t29*z1_2_by_tau_by_chi + t30*z2_1_by_tau_by_chi;
            const double t142 = -sin_omega1_tau1*t113 - sin_omega1_tau1*t114;
            const double t143 = sin_omega2_tau1*t114 - sin_omega2_tau1*t127;
            const double t144 = t85*v1_2_by_tau - t97*z1_2_by_tau;
            const double t145 = cos_omega1_tau1_by_chi*v1_2_by_tau;
            const double t146 = cos_omega2_tau1_by_chi*v1_2_by_tau;
            const double v1_3_by_tau_by_chi = omega1_by_chi*t142 + omega2_by_chi*t143 + p1*t145 + p1_by_chi*t144 + sin_omega1_tau1_by_chi*t126 + sin_omega2_tau1_by_chi*t128 - t134*t97 + t146*t21 + t25*v1_2_by_tau_by_chi + t34*z1_2_by_tau_by_chi + t35*z2_1_by_tau_by_chi;
            const double t147 = -sin_omega1_tau1*t121 - sin_omega1_tau1*t122;
            const double t148 = p3*sin_omega2_tau1*z1_2_by_tau - sin_omega2_tau1*t124;
            const double v2_3_by_tau_by_chi = omega1_by_chi*t147 + omega2_by_chi*t148 + p3*t145 - p3*t146 + p3_by_chi*t144 + sin_omega1_tau1_by_chi*t131 + sin_omega2_tau1_by_chi*t132 + t141*t97 + t29*v1_2_by_tau_by_chi + t36*z1_2_by_tau_by_chi + t37*z2_1_by_tau_by_chi;
            /* d/deta of: d/dtau of: slip-slip for tau1 */
            const double t149 = p2_by_eta*z2_2_by_tau;
            const double t150 = sin_omega1_tau1_by_eta*t117;
            const double t151 = sin_omega2_tau1_by_eta*t119;
            const double t152 = omega1_by_eta*t137;
            const double t153 = omega2_by_eta*t139;
            const double z1_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t115 + cos_omega2_tau1_by_eta*t116 + p1*t150 - p1*t152 + p1_by_eta*t133 + t149*t85 + t151*t21 - t153*t21;
            const double t154 = p1_by_eta*z2_2_by_tau;
            const double z2_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t123 + cos_omega2_tau1_by_eta*t125 + p3*t150 - p3*t151 - p3*t152 + p3*t153 + p3_by_eta*t133 - t154*t85;
            const double t155 = cos_omega1_tau1_by_eta*v1_2_by_tau;
            const double t156 = cos_omega2_tau1_by_eta*v1_2_by_tau;
            const double v1_3_by_tau_by_eta = omega1_by_eta*t142 + omega2_by_eta*t143 + p1*t155 + p1_by_eta*t144 + sin_omega1_tau1_by_eta*t126 + sin_omega2_tau1_by_eta*t128 - t149*t97 + t156*t21;
            const double v2_3_by_tau_by_eta = omega1_by_eta*t147 + omega2_by_eta*t148 + p3*t155 - p3*t156 + p3_by_eta*t144 + sin_omega1_tau1_by_eta*t131 + sin_omega2_tau1_by_eta*t132 + t154*t97;
            /* d/dV of: d/dtau of: slip-slip for tau1 */
            const double z1_3_by_tau_by_V = t24*v1_2_by_tau_by_V + t25*z1_2_by_tau_by_V + t26*z2_2_by_tau_by_V;
            const double z2_3_by_tau_by_V = t28*v1_2_by_tau_by_V + t29*z1_2_by_tau_by_V + t30*z2_2_by_tau_by_V;
            const double v1_3_by_tau_by_V = t25*v1_2_by_tau_by_V + t34*z1_2_by_tau_by_V + t35*z2_2_by_tau_by_V;
            const double v2_3_by_tau_by_V = t29*v1_2_by_tau_by_V + t36*z1_2_by_tau_by_V + t37*z2_2_by_tau_by_V;
            /* d/de1 of: d/dtau of: slip-slip for tau1 */
            const double z1_3_by_tau_by_e1 = t24*v1_2_by_tau_by_e1 + t25*z1_2_by_tau_by_e1 + t26*z2_1_by_tau_by_e1;
            const double z2_3_by_tau_by_e1 = t28*v1_2_by_tau_by_e1 + t29*z1_2_by_tau_by_e1 + t30*z2_1_by_tau_by_e1;
            const double v1_3_by_tau_by_e1 = t25*v1_2_by_tau_by_e1 + t34*z1_2_by_tau_by_e1 + t35*z2_1_by_tau_by_e1;
            const double v2_3_by_tau_by_e1 = t29*v1_2_by_tau_by_e1 + t36*z1_2_by_tau_by_e1 + t37*z2_1_by_tau_by_e1;
            /* d/dtau of: d/dtau1 of: slip-slip for tau1 */
            const double t157 = chi*z2_3_by_tau;
            const double v1_3_by_tau1_by_tau = t157 - z1_3_by_tau;
            const double t158 = chi*eta;
            const double v2_3_by_tau1_by_tau = -eta*t157 + t158*z1_3_by_tau;
            /* d/dtau1 of: d/dtau1 of: slip-slip for tau1 */
            const double t159 = chi*z2_3_by_tau1;
            const double v1_3_by_tau1_by_tau1 = t159 - z1_3_by_tau1;
            const double v2_3_by_tau1_by_tau1 = -eta*t159 + t158*z1_3_by_tau1;
            /* d/dchi of: d/dtau1 of: slip-slip for tau1 */
            const double t160 = chi*z2_3_by_chi;
            const double v1_3_by_tau1_by_chi = t160 - z1_3_by_chi + z2_3;
            const double v2_3_by_tau1_by_chi = -eta*t160 - eta*z2_3 + t158*z1_3_by_chi + t46;
            /* d/deta of: d/dtau1 of: slip-slip for tau1 */
            const double t161 = chi*z2_3_by_eta;
            const double v1_3_by_tau1_by_eta = t161 - z1_3_by_eta;
            const double v2_3_by_tau1_by_eta = chi*z1_3 - eta*t161 + t158*z1_3_by_eta - t45;
            /* d/dV of: d/dtau1 of: slip-slip for tau1 */
            const double t162 = chi*z2_3_by_V;
            const double v1_3_by_tau1_by_V = t162 - z1_3_by_V;
            const double v2_3_by_tau1_by_V = -eta*t162 + t158*z1_3_by_V;
            /* d/de1 of: d/dtau1 of: slip-slip for tau1 */
            const double t163 = chi*z2_3_by_e1;
            const double v1_3_by_tau1_by_e1 = t163 - z1_3_by_e1;
            const double v2_3_by_tau1_by_e1 = -eta*t163 + t158*z1_3_by_e1;
            /* d/de2 of: d/dtau1 of: slip-slip for tau1 */
            const double t164 = chi*z2_3_by_e2;
            const double v1_3_by_tau1_by_e2 = t164 - z1_3_by_e2;
            const double v2_3_by_tau1_by_e2 = -eta*t164 + t158*z1_3_by_e2;
            /* d/dtau of: d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau_by_tau = omega3*z1_3_by_tau_by_tau - omega3*z2_3_by_tau_by_tau;
            /* d/dtau1 of: d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau_by_tau1 = omega3*z1_3_by_tau_by_tau1 - omega3*z2_3_by_tau_by_tau1;
            /* d/dchi of: d/dtau of: first return of tau2 */
            const double t165 = z1_3_by_tau - z2_3_by_tau;
            const double sine_part_tau2_by_tau_by_chi = omega3*z1_3_by_tau_by_chi - omega3*z2_3_by_tau_by_chi + omega3_by_chi*t165;
            /* d/deta of: d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau_by_eta = omega3*z1_3_by_tau_by_eta - omega3*z2_3_by_tau_by_eta + omega3_by_eta*t165;
            /* d/dV of: d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau_by_V = omega3*z1_3_by_tau_by_V - omega3*z2_3_by_tau_by_V;
            /* d/de1 of: d/dtau of: first return of tau2 */
            const double sine_part_tau2_by_tau_by_e1 = omega3*z1_3_by_tau_by_e1 - omega3*z2_3_by_tau_by_e1;
            /* d/dtau of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_tau = omega3*v1_3_by_tau - omega3*v2_3_by_tau;
            /* d/dtau1 of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_tau1 = omega3*v1_3_by_tau1 - omega3*v2_3_by_tau1;
            /* d/dchi of: d/dtau1 of: first return of tau2 */
            const double t166 = v1_3 - v2_3;
            const double sine_part_tau2_by_tau1_by_chi = omega3*v1_3_by_chi - omega3*v2_3_by_chi + omega3_by_chi*t166;
            /* d/deta of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_eta = omega3*v1_3_by_eta - omega3*v2_3_by_eta + omega3_by_eta*t166;
            /* d/dV of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_V = omega3*v1_3_by_V - omega3*v2_3_by_V;
            /* d/de1 of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_e1 = omega3*v1_3_by_e1 - omega3*v2_3_by_e1;
            /* d/de2 of: d/dtau1 of: first return of tau2 */
            const double sine_part_tau2_by_tau1_by_e2 = omega3*v1_3_by_e2 - omega3*v2_3_by_e2;
            /* d/dtau of: d/dtau of: first return of tau2 */
            const double t167 = cosine_part_tau2*t50;
            const double t168 = sine_part_tau2*t50;
            const double t169 = (1.0/2.0)/(amplitude_tau2*amplitude_tau2);
            const double t170 = t169*t49;
            const double amplitude_tau2_by_tau_by_tau = -amplitude_tau2_by_tau*t170 + (sine_part_tau2_by_tau*sine_part_tau2_by_tau)*t50 + sine_part_tau2_by_tau_by_tau*t168 + t167*v2_3_by_tau_by_tau + t50*(v2_3_by_tau*v2_3_by_tau);
            /* d/dtau1 of: d/dtau of: first return of tau2 */
            const double t171 = sine_part_tau2_by_tau*t50;
            const double t172 = t50*v2_3_by_tau;
            const double t173 = sine_part_tau2_by_tau1*t171 + t172*v2_3_by_tau1;
            const double amplitude_tau2_by_tau_by_tau1 = -amplitude_tau2_by_tau1*t170 + sine_part_tau2_by_tau_by_tau1*t168 + t167*v2_3_by_tau_by_tau1 + t173;
            /* d/dchi of: d/dtau of: first return of tau2 */
            const double amplitude_tau2_by_tau_by_chi = -amplitude_tau2_by_chi*t170 + sine_part_tau2_by_chi*t171 + sine_part_tau2_by_tau_by_chi*t168 + t167*v2_3_by_tau_by_chi + t172*v2_3_by_chi;
            /* d/deta of: d/dtau of: first return of tau2 */
            const double amplitude_tau2_by_tau_by_eta = -amplitude_tau2_by_eta*t170 + sine_part_tau2_by_eta*t171 + sine_part_tau2_by_tau_by_eta*t168 + t167*v2_3_by_tau_by_eta + t172*v2_3_by_eta;
            /* d/dV of: d/dtau of: first return of tau2 */
            const double amplitude_tau2_by_tau_by_V = -amplitude_tau2_by_V*t170 + cosine_part_tau2_by_V*t172 + sine_part_tau2_by_V*t171 + sine_part_tau2_by_tau_by_V*t168 + t167*v2_3_by_tau_by_V;
            /* d/de1 of: d/dtau of: first return of tau2 */
            const double amplitude_tau2_by_tau_by_e1 = -amplitude_tau2_by_e1*t170 + sine_part_tau2_by_e1*t171 + sine_part_tau2_by_tau_by_e1*t168 + t167*v2_3_by_tau_by_e1 + t172*v2_3_by_e1;
            /* d/de2 of: d/dtau of: first return of tau2 */
            const double amplitude_tau2_by_tau_by_e2 = -amplitude_tau2_by_e2*t170 + sine_part_tau2_by_e2*t171 + t172*v2_3_by_e2;
            /* d/dtau of: d/dtau1 of: first return of tau2 */
            const double t174 = t169*t52;
            const double amplitude_tau2_by_tau1_by_tau = -amplitude_tau2_by_tau*t174 + sine_part_tau2_by_tau1_by_tau*t168 + t167*v2_3_by_tau1_by_tau + t173;
            /* d/dtau1 of: d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1_by_tau1 = -amplitude_tau2_by_tau1*t174 + (sine_part_tau2_by_tau1*sine_part_tau2_by_tau1)*t50 + sine_part_tau2_by_tau1_by_tau1*t168 + t167*v2_3_by_tau1_by_tau1 + t50*(v2_3_by_tau1*v2_3_by_tau1);
            /* d/dchi of: d/dtau1 of: first return of tau2 */
            const double t175 = sine_part_tau2_by_tau1*t50;
            const double t176 = t50*v2_3_by_tau1;
            const double amplitude_tau2_by_tau1_by_chi = -amplitude_tau2_by_chi*t174 + sine_part_tau2_by_chi*t175 + sine_part_tau2_by_tau1_by_chi*t168 + t167*v2_3_by_tau1_by_chi + t176*v2_3_by_chi;
            /* d/deta of: d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1_by_eta = -amplitude_tau2_by_eta*t174 + sine_part_tau2_by_eta*t175 + sine_part_tau2_by_tau1_by_eta*t168 + t167*v2_3_by_tau1_by_eta + t176*v2_3_by_eta;
            /* d/dV of: d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1_by_V = -amplitude_tau2_by_V*t174 + cosine_part_tau2_by_V*t176 + sine_part_tau2_by_V*t175 + sine_part_tau2_by_tau1_by_V*t168 + t167*v2_3_by_tau1_by_V;
            /* d/de1 of: d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1_by_e1 = -amplitude_tau2_by_e1*t174 + sine_part_tau2_by_e1*t175 + sine_part_tau2_by_tau1_by_e1*t168 + t167*v2_3_by_tau1_by_e1 + t176*v2_3_by_e1;
            /* d/de2 of: d/dtau1 of: first return of tau2 */
            const double amplitude_tau2_by_tau1_by_e2 = -amplitude_tau2_by_e2*t174 + sine_part_tau2_by_e2*t175 + sine_part_tau2_by_tau1_by_e2*t168 + t167*v2_3_by_tau1_by_e2 + t176*v2_3_by_e2;
            /* outputs */
            const double t177 = (1.0/(omega3));
            const double t178 = amplitude_tau2_by_tau*t177;
            const double t179 = t177*t4;
            const double t180 = (1.0/(v1_3_by_tau1));
            const double t181 = amplitude_tau2_by_tau1*t180;
            const double t182 = (t178*t4 - t179*t181*v1_3_by_tau)/(z2_1_by_tau*z2_1_by_tau);
            const double t183 = (1.0/(z2_1_by_tau));
            const double t184 = t179*t183;
            const double t185 = t181*t184;
            const double t186 = t184*v1_3_by_tau;
            const double t187 = t180*t186;
            const double t188 = (1.0/(v1_3_by_tau1*v1_3_by_tau1));
            const double t189 = amplitude_tau2_by_tau1*t186*t188;
            const double t190 = (1.0/(omega3*omega3));
            const double t191 = t183*(-amplitude_tau2_by_tau*t190*t4 + amplitude_tau2_by_tau1*t180*t190*t4*v1_3_by_tau);
            slope[0][lane] = 0;
            slope[1][lane] = 0;
            slope[2][lane] = 0;
            slope[3][lane] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_tau - amplitude_tau2_by_tau1_by_tau*t187 + amplitude_tau2_by_tau_by_tau*t177*t183*t4 - t182*z2_1_by_tau_by_tau - t185*v1_3_by_tau_by_tau;
            slope[4][lane] = -amplitude_tau2_by_tau1_by_tau1*t187 + amplitude_tau2_by_tau_by_tau1*t184 - t185*v1_3_by_tau_by_tau1 + t189*v1_3_by_tau1_by_tau1;
            slope[5][lane] = 0;
            slope[6][lane] = -amplitude_tau2_by_tau1_by_chi*t187 + amplitude_tau2_by_tau_by_chi*t184 + omega3_by_chi*t191 - t182*z2_1_by_tau_by_chi + t183*(amplitude_tau2_by_tau1*t177*t180*t53*v1_3_by_tau - t178*t53) - t185*v1_3_by_tau_by_chi + t189*v1_3_by_tau1_by_chi;
            slope[7][lane] = -amplitude_tau2_by_tau1_by_eta*t187 + amplitude_tau2_by_tau_by_eta*t184 + omega3_by_eta*t191 - t185*v1_3_by_tau_by_eta + t189*v1_3_by_tau1_by_eta;
            slope[8][lane] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_V - amplitude_tau2_by_tau1_by_V*t187 + amplitude_tau2_by_tau_by_V*t177*t183*t4 - t182*z2_1_by_tau_by_V - t185*v1_3_by_tau_by_V;
            slope[9][lane] = amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_e1 - amplitude_tau2_by_tau1_by_e1*t187 + amplitude_tau2_by_tau_by_e1*t177*t183*t4 - t182*z2_1_by_tau_by_e1 - t185*v1_3_by_tau_by_e1;
            slope[10][lane] = -amplitude_tau2_by_tau1_by_e2*t187 + amplitude_tau2_by_tau_by_e2*t184 + t189*v1_3_by_tau1_by_e2;
        }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
#pragma omp simd
                for (int lane = 0; lane < lanes; ++lane)
                    size[lane] += matrix[i][j][lane] * matrix[i][j][lane];
        for (int k = 0; k < n; ++k) {
            for (int i = k + 1; i < n; ++i) {
                double other[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    other[lane] = fabs(matrix[i][k][lane]) - fabs(matrix[k][k][lane]);
                for (int j = k; j < width; ++j)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane) {
                        const double above = matrix[k][j][lane], below = matrix[i][j][lane];
                        matrix[k][j][lane] = other[lane] > 0.0 ? below : above;
                        matrix[i][j][lane] = other[lane] > 0.0 ? above : below;
                    }
            }
#pragma omp simd
            for (int lane = 0; lane < lanes; ++lane) {
                const double pivot = fabs(matrix[k][k][lane]);
                least[lane] = pivot < least[lane] ? pivot : least[lane];
                matrix[k][k][lane] = 1.0 / matrix[k][k][lane];
            }
            for (int i = k + 1; i < n; ++i) {
                double factor[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    factor[lane] = matrix[i][k][lane] * matrix[k][k][lane];
                for (int j = k + 1; j < width; ++j)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[i][j][lane] -= factor[lane] * matrix[k][j][lane];
            }
        }
        for (int k = n - 1; k >= 0; --k)
            for (int j = n; j < width; ++j) {
                for (int l = k + 1; l < n; ++l)
#pragma omp simd
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[k][j][lane] -= matrix[k][l][lane] * matrix[l][j][lane];
#pragma omp simd
                for (int lane = 0; lane < lanes; ++lane) {
                    matrix[k][j][lane] *= matrix[k][k][lane];
                    slope[j][lane] += slope[k][lane] * matrix[k][j][lane];
                }
            }
        for (int lane = 0; lane < here; ++lane) {
            const double lost = least[lane] > 1e-10 * sqrt(size[lane]) ? 0.0 : (double)NAN;
            for (int j = 0; j < p; ++j) {
                for (int i = 0; i < n; ++i)
                    directions[(i * p + j) * count + start + lane] = matrix[i][n + j][lane] + lost;
                directions[(n * p + j) * count + start + lane] = slope[n + j][lane] + lost;
            }
        }
    }
}

/* Newton's method on the reduced equations for `count` points.
 * Takes parameters (4) and guess (3: tau, tau1, e1) of the points; gives unknowns (6), the
 * trace, the largest reduced residual, iterations and a status of each. Arrays hold columns:
 * entry i of a point stands at [i * count + point].
 * In one step a dwell time changes by a factor of four at most; a point has converged when
 * a whole step is below 1e-9 max(1, |x|).
 * Status: 0 converged, 1 not converged, 2 not finite, 3 a dwell time is not positive,
 * 5 the linear equations for the start are singular. */
NONSMOOTH_MULTIVERSION
void dry_friction_solution_ii_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = 16, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[4][lanes], x[3][lanes], fixed[38][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 4; ++i)
                parameter[i][lane] = parameters[i * count + point];
            open[lane] = 1.0;
            for (int i = 0; i < 3; ++i)
                x[i][lane] = guess[i * count + point];
            taken[lane] = 0;
        }
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double eta = parameter[1][lane];
            const double V = parameter[2][lane];
            const double e2 = parameter[3][lane];
            const double gap1 = sqrt(4*(chi*chi)*eta + ((-chi*eta + 1)*(-chi*eta + 1)));
            const double omega1 = sqrt((1.0/2.0)*chi*eta + (1.0/2.0)*gap1 + 1.0/2.0);
            const double omega2 = sqrt(chi)*sqrt(eta)*sqrt(1 - chi)/omega1;
            const double p1 = 1.0/2.0 + (1.0/2.0)*(-chi*eta + 1)/gap1;
            const double p2 = -chi/gap1;
            const double p3 = -chi*eta/gap1;
            const double omega3 = sqrt(chi)*sqrt(eta);
            const double t3 = (1.0/((chi - 1)));
            const double h0 = -e2*t3/chi;
            const double h1 = -chi;
            /* slip-slip for tau1 */
            const double t11 = (1.0/(omega1));
            const double h2 = (1.0/(omega2));
            const double t13 = 1 - p1;
            const double h3 = -p2;
            const double h4 = p2*t11;
            const double h5 = -p3;
            const double h6 = p3*t11;
            const double h7 = -p1;
            const double h8 = -t13;
            const double h9 = omega2*p2;
            const double h10 = omega2*p3;
            const double h11 = -V;
            /* tau2: first return */
            const double t30 = (1.0/(omega3));
            const double h12 = -t30;
            const double h13 = -t3;
            /* d/dtau of: slip-stick for tau */
            const double t35 = V*chi;
            const double t36 = V - t35;
            const double t39 = chi*eta;
            const double h14 = -eta;
            const double h15 = -omega3;
            /* rate of the exit boundary after ta */
            const double rate_1 = t36;
            /* derivatives of the time to the boundary after ta */
            const double t54 = (1.0/(rate_1));
            const double delay_ta_by_z10 = -t54;
            const double delay_ta_by_z20 = chi*t54;
            /* perturbation on the boundary after ta */
            const double t55 = V*delay_ta_by_z10;
            const double z1_1_on_boundary_by_z10 = t55 + 1;
            const double z1_1_on_boundary_by_z20 = V*delay_ta_by_z20;
            const double z2_1_on_boundary_by_z10 = t55;
            const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
            const double h16 = -z1_1_on_boundary_by_z10;
            const double h17 = -z1_1_on_boundary_by_z20;
            const double h18 = -chi*z2_1_on_boundary_by_z10;
            const double h19 = -chi*z2_1_on_boundary_by_z20;
            const double h20 = -t39;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega3;
            fixed[6][lane] = t3;
            fixed[7][lane] = h0;
            fixed[8][lane] = h1;
            fixed[9][lane] = t11;
            fixed[10][lane] = h2;
            fixed[11][lane] = t13;
            fixed[12][lane] = h3;
            fixed[13][lane] = h4;
            fixed[14][lane] = h5;
            fixed[15][lane] = h6;
            fixed[16][lane] = h7;
            fixed[17][lane] = h8;
            fixed[18][lane] = h9;
            fixed[19][lane] = h10;
            fixed[20][lane] = h11;
            fixed[21][lane] = t30;
            fixed[22][lane] = h12;
            fixed[23][lane] = h13;
            fixed[24][lane] = t35;
            fixed[25][lane] = t36;
            fixed[26][lane] = t39;
            fixed[27][lane] = h14;
            fixed[28][lane] = h15;
            fixed[29][lane] = z1_1_on_boundary_by_z10;
            fixed[30][lane] = z1_1_on_boundary_by_z20;
            fixed[31][lane] = z2_1_on_boundary_by_z10;
            fixed[32][lane] = z2_1_on_boundary_by_z20;
            fixed[33][lane] = h16;
            fixed[34][lane] = h17;
            fixed[35][lane] = h18;
            fixed[36][lane] = h19;
            fixed[37][lane] = h20;
        }
        for (int iteration = 0; iteration < most; ++iteration) {
            double running = 0.0;
#pragma omp simd
            for (int lane = 0; lane < lanes; ++lane) {
                const double chi = parameter[0][lane];
                const double V = parameter[2][lane];
                const double omega1 = fixed[0][lane];
                const double omega2 = fixed[1][lane];
                const double p1 = fixed[2][lane];
                const double p2 = fixed[3][lane];
                const double p3 = fixed[4][lane];
                const double omega3 = fixed[5][lane];
                const double t3 = fixed[6][lane];
                const double h0 = fixed[7][lane];
                const double h1 = fixed[8][lane];
                const double t11 = fixed[9][lane];
                const double h2 = fixed[10][lane];
                const double t13 = fixed[11][lane];
                const double h3 = fixed[12][lane];
                const double h4 = fixed[13][lane];
                const double h5 = fixed[14][lane];
                const double h6 = fixed[15][lane];
                const double h7 = fixed[16][lane];
                const double h8 = fixed[17][lane];
                const double h9 = fixed[18][lane];
                const double h10 = fixed[19][lane];
                const double h11 = fixed[20][lane];
                const double t30 = fixed[21][lane];
                const double h12 = fixed[22][lane];
                const double h13 = fixed[23][lane];
                const double t35 = fixed[24][lane];
                const double t36 = fixed[25][lane];
                const double t39 = fixed[26][lane];
                const double h14 = fixed[27][lane];
                const double h15 = fixed[28][lane];
                const double tau = x[0][lane];
                const double tau1 = x[1][lane];
                const double e1 = x[2][lane];
                double sine_0, cosine_0;
                nonsmooth_sincos(tau, &sine_0, &cosine_0);
                const double cos_tau = cosine_0;
                const double sin_tau = sine_0;
                /* z2_1: linear in second-breaks-forward */
                const double t2 = V*tau;
                const double t4 = cos_tau*t3;
                const double z2_1 = V*sin_tau - e1*t4 + h0 - t2;
                /* slip-stick for tau */
                const double t5 = chi*z2_1;
                const double t6 = e1 + t5;
                const double t7 = chi + cos_tau*h1;
                const double t8 = chi*sin_tau;
                const double z1_2 = V*sin_tau + V*(chi*tau - t8) + cos_tau*t6 + t7*z2_1;
                const double z2_2 = t2 + z2_1;
                const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
                /* functions of tau1 in slip-slip */
                const double t9 = omega1*tau1;
                double sine_1, cosine_1;
                nonsmooth_sincos(t9, &sine_1, &cosine_1);
                const double cos_omega1_tau1 = cosine_1;
                const double sin_omega1_tau1 = sine_1;
                const double t10 = omega2*tau1;
                double sine_2, cosine_2;
                nonsmooth_sincos(t10, &sine_2, &cosine_2);
                const double cos_omega2_tau1 = cosine_2;
                const double sin_omega2_tau1 = sine_2;
                const double t14 = h2*sin_omega2_tau1;
                const double t12 = sin_omega1_tau1*t11;
                const double t15 = p1*t12 + t13*t14;
                const double t16 = cos_omega1_tau1*p1 + cos_omega2_tau1*t13;
                const double t17 = cos_omega1_tau1*p2 + cos_omega2_tau1*h3;
                const double z1_3 = V*(h3*t14 + h4*sin_omega1_tau1) + t15*v1_2 + t16*z1_2 + t17*z2_2;
                const double t18 = h5*t14 + h6*sin_omega1_tau1;
                const double t19 = cos_omega1_tau1*p3 + cos_omega2_tau1*h5;
                const double t20 = cos_omega1_tau1*t13 + cos_omega2_tau1*p1;
                const double z2_3 = V*(p1*t14 + t12*t13) + t18*v1_2 + t19*z1_2 + t20*z2_2;
                const double t21 = omega2*sin_omega2_tau1;
                const double t22 = omega1*sin_omega1_tau1;
                const double t23 = h7*t22 + h8*t21;
                const double t24 = h3*t22 + h9*sin_omega2_tau1;
                const double v1_3 = V*t17 + t16*v1_2 + t23*z1_2 + t24*z2_2;
                const double t25 = h10*sin_omega2_tau1 + h5*t22;
                const double t26 = h7*t21 + h8*t22;
                const double v2_3 = V*t20 + t19*v1_2 + t25*z1_2 + t26*z2_2;
                /* first return of tau2 */
                const double cosine_part_tau2 = h11 + v2_3;
                const double t27 = omega3*z1_3;
                const double t28 = omega3*z2_3;
                const double sine_part_tau2 = t27 - t28;
                /* first return of tau2 */
                const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
                /* first return of tau2 */
                const double t29 = (1.0/(amplitude_tau2));
                const double cos_tau2_return = sine_part_tau2*t29;
                const double sin_tau2_return = -cosine_part_tau2*t29;
                const double tau2 = t30*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
                /* stick-stick for no time */
                const double t31 = V*tau2;
                const double z1_5 = sine_part_tau2*t30 + t31 + z2_3;
                const double z2_5 = amplitude_tau2*h12 + z1_5;
                /* d/dtau of: functions of tau in slip-stick */
                const double cos_tau_by_tau = -sin_tau;
                const double sin_tau_by_tau = cos_tau;
                /* d/dtau of: z2_1: linear in second-breaks-forward */
                const double t34 = cos_tau_by_tau*e1;
                const double z2_1_by_tau = V*sin_tau_by_tau + h11 + h13*t34;
                /* d/de1 of: z2_1: linear in second-breaks-forward */
                const double z2_1_by_e1 = -t4;
                const double z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t36 + t34 + t35;
                const double z2_2_by_tau = V + z2_1_by_tau;
                const double v1_2_by_tau = cos_tau_by_tau*t36 - e1*sin_tau_by_tau;
                /* d/de1 of: slip-stick for tau */
                const double z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau;
                const double v1_2_by_e1 = -sin_tau;
                /* d/dtau of: slip-slip for tau1 */
                const double z1_3_by_tau = t15*v1_2_by_tau + t16*z1_2_by_tau + t17*z2_2_by_tau;
                const double z2_3_by_tau = t18*v1_2_by_tau + t19*z1_2_by_tau + t20*z2_2_by_tau;
                const double v1_3_by_tau = t16*v1_2_by_tau + t23*z1_2_by_tau + t24*z2_2_by_tau;
                const double v2_3_by_tau = t19*v1_2_by_tau + t25*z1_2_by_tau + t26*z2_2_by_tau;
                /* d/dtau1 of: slip-slip for tau1 */
                const double t37 = chi*z2_3;
                const double v1_3_by_tau1 = t37 - z1_3;
                const double v2_3_by_tau1 = h14*t37 + t39*z1_3;
                /* d/de1 of: slip-slip for tau1 */
                const double z1_3_by_e1 = t15*v1_2_by_e1 + t16*z1_2_by_e1 + t17*z2_1_by_e1;
                const double z2_3_by_e1 = t18*v1_2_by_e1 + t19*z1_2_by_e1 + t20*z2_1_by_e1;
                const double v1_3_by_e1 = t16*v1_2_by_e1 + t23*z1_2_by_e1 + t24*z2_1_by_e1;
                const double v2_3_by_e1 = t19*v1_2_by_e1 + t25*z1_2_by_e1 + t26*z2_1_by_e1;
                /* d/dtau of: first return of tau2 */
                const double sine_part_tau2_by_tau = h15*z2_3_by_tau + omega3*z1_3_by_tau;
                /* d/dtau1 of: first return of tau2 */
                const double sine_part_tau2_by_tau1 = h15*v2_3 + omega3*v1_3;
                /* d/de1 of: first return of tau2 */
                const double sine_part_tau2_by_e1 = h15*z2_3_by_e1 + omega3*z1_3_by_e1;
                /* d/dtau of: first return of tau2 */
                const double t41 = 2*cosine_part_tau2;
                const double t42 = 2*sine_part_tau2;
                const double t43 = (1.0/2.0)*t29;
                const double amplitude_tau2_by_tau = t43*(sine_part_tau2_by_tau*t42 + t41*v2_3_by_tau);
                /* d/dtau1 of: first return of tau2 */
                const double amplitude_tau2_by_tau1 = t43*(sine_part_tau2_by_tau1*t42 + t41*v2_3_by_tau1);
                /* d/de1 of: first return of tau2 */
                const double amplitude_tau2_by_e1 = t43*(sine_part_tau2_by_e1*t42 + t41*v2_3_by_e1);
                /* d/dtau of: first return of tau2 */
                const double t44 = (1.0/(amplitude_tau2*amplitude_tau2));
                const double cos_tau2_return_by_tau = -amplitude_tau2_by_tau*sine_part_tau2*t44 + sine_part_tau2_by_tau*t29;
                const double sin_tau2_return_by_tau = amplitude_tau2_by_tau*cosine_part_tau2*t44 - t29*v2_3_by_tau;
                /* d/dtau1 of: first return of tau2 */
                const double cos_tau2_return_by_tau1 = -amplitude_tau2_by_tau1*sine_part_tau2*t44 + sine_part_tau2_by_tau1*t29;
                const double sin_tau2_return_by_tau1 = amplitude_tau2_by_tau1*cosine_part_tau2*t44 - t29*v2_3_by_tau1;
                /* d/de1 of: first return of tau2 */
                const double cos_tau2_return_by_e1 = -amplitude_tau2_by_e1*sine_part_tau2*t44 + sine_part_tau2_by_e1*t29;
                const double sin_tau2_return_by_e1 = amplitude_tau2_by_e1*cosine_part_tau2*t44 - t29*v2_3_by_e1;
                /* d/dtau of: tau2: first return */
                const double t45 = t30/((cos_tau2_return*cos_tau2_return) + (sin_tau2_return*sin_tau2_return));
                const double t46 = cos_tau2_return*t45;
                const double t47 = sin_tau2_return*t45;
                const double tau2_by_tau = -cos_tau2_return_by_tau*t47 + sin_tau2_return_by_tau*t46;
                /* d/dtau1 of: tau2: first return */
                const double tau2_by_tau1 = -cos_tau2_return_by_tau1*t47 + sin_tau2_return_by_tau1*t46;
                /* d/de1 of: tau2: first return */
                const double tau2_by_e1 = -cos_tau2_return_by_e1*t47 + sin_tau2_return_by_e1*t46;
                /* d/dtau of: stick-stick for no time */
                const double z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t30 + z2_3_by_tau;
                const double z2_5_by_tau = amplitude_tau2_by_tau*h12 + z1_5_by_tau;
                /* d/dtau1 of: stick-stick for no time */
                const double z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t30 + v2_3;
                const double z2_5_by_tau1 = amplitude_tau2_by_tau1*h12 + z1_5_by_tau1;
                /* d/de1 of: stick-stick for no time */
                const double z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t30 + z2_3_by_e1;
                const double z2_5_by_e1 = amplitude_tau2_by_e1*h12 + z1_5_by_e1;
                const double residual_0 = -V + v1_3;
                const double residual_1 = -chi*z2_5 - e1 + z1_5;
                const double residual_2 = -z2_1 + z2_5;
                const double jacobian_0 = v1_3_by_tau;
                const double jacobian_1 = v1_3_by_tau1;
                const double jacobian_2 = v1_3_by_e1;
                const double jacobian_3 = -chi*z2_5_by_tau + z1_5_by_tau;
                const double jacobian_4 = -chi*z2_5_by_tau1 + z1_5_by_tau1;
                const double jacobian_5 = -chi*z2_5_by_e1 + z1_5_by_e1 - 1;
                const double jacobian_6 = -z2_1_by_tau + z2_5_by_tau;
                const double jacobian_7 = z2_5_by_tau1;
                const double jacobian_8 = -z2_1_by_e1 + z2_5_by_e1;
                const double inverse = (1.0/((jacobian_0*jacobian_4*jacobian_8 - jacobian_0*jacobian_5*jacobian_7 - jacobian_1*jacobian_3*jacobian_8 + jacobian_1*jacobian_5*jacobian_6 + jacobian_2*jacobian_3*jacobian_7 - jacobian_2*jacobian_4*jacobian_6)));
                const double wanted_0 = tau - (residual_0*(jacobian_4*jacobian_8 - jacobian_5*jacobian_7) + residual_1*(-jacobian_1*jacobian_8 + jacobian_2*jacobian_7) + residual_2*(jacobian_1*jacobian_5 - jacobian_2*jacobian_4))*inverse;
                const double next_0 = wanted_0 < 0.25*tau ? 0.25*tau : wanted_0 > 4.0*tau ? 4.0*tau : wanted_0;
                const double size_0 = fabs(next_0) > 1.0 ? fabs(next_0) : 1.0;
                const double wanted_1 = tau1 - (residual_0*(-jacobian_3*jacobian_8 + jacobian_5*jacobian_6) + residual_1*(jacobian_0*jacobian_8 - jacobian_2*jacobian_6) + residual_2*(-jacobian_0*jacobian_5 + jacobian_2*jacobian_3))*inverse;
                const double next_1 = wanted_1 < 0.25*tau1 ? 0.25*tau1 : wanted_1 > 4.0*tau1 ? 4.0*tau1 : wanted_1;
                const double size_1 = fabs(next_1) > 1.0 ? fabs(next_1) : 1.0;
                const double wanted_2 = e1 - (residual_0*(jacobian_3*jacobian_7 - jacobian_4*jacobian_6) + residual_1*(-jacobian_0*jacobian_7 + jacobian_1*jacobian_6) + residual_2*(jacobian_0*jacobian_4 - jacobian_1*jacobian_3))*inverse;
                const double next_2 = wanted_2;
                const double size_2 = fabs(next_2) > 1.0 ? fabs(next_2) : 1.0;
                x[0][lane] = open[lane] != 0.0 ? next_0 : tau;
                x[1][lane] = open[lane] != 0.0 ? next_1 : tau1;
                x[2][lane] = open[lane] != 0.0 ? next_2 : e1;
                taken[lane] += open[lane] != 0.0 ? 1 : 0;
                open[lane] = ((fabs(wanted_0 - tau) <= 1e-9*size_0) & (fabs(wanted_1 - tau1) <= 1e-9*size_1) & (fabs(wanted_2 - e1) <= 1e-9*size_2)) ? 0.0 : open[lane];
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
        double result[6][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
#pragma omp simd
        for (int lane = 0; lane < lanes; ++lane) {
            const double chi = parameter[0][lane];
            const double V = parameter[2][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double t3 = fixed[6][lane];
            const double h0 = fixed[7][lane];
            const double h1 = fixed[8][lane];
            const double t11 = fixed[9][lane];
            const double h2 = fixed[10][lane];
            const double t13 = fixed[11][lane];
            const double h3 = fixed[12][lane];
            const double h4 = fixed[13][lane];
            const double h5 = fixed[14][lane];
            const double h6 = fixed[15][lane];
            const double h7 = fixed[16][lane];
            const double h8 = fixed[17][lane];
            const double h9 = fixed[18][lane];
            const double h10 = fixed[19][lane];
            const double h11 = fixed[20][lane];
            const double t30 = fixed[21][lane];
            const double h12 = fixed[22][lane];
            const double t35 = fixed[24][lane];
            const double t39 = fixed[26][lane];
            const double h14 = fixed[27][lane];
            const double z1_1_on_boundary_by_z10 = fixed[29][lane];
            const double z1_1_on_boundary_by_z20 = fixed[30][lane];
            const double z2_1_on_boundary_by_z10 = fixed[31][lane];
            const double z2_1_on_boundary_by_z20 = fixed[32][lane];
            const double h16 = fixed[33][lane];
            const double h17 = fixed[34][lane];
            const double h18 = fixed[35][lane];
            const double h19 = fixed[36][lane];
            const double h20 = fixed[37][lane];
            const double tau = x[0][lane];
            const double tau1 = x[1][lane];
            const double e1 = x[2][lane];
            double sine_0, cosine_0;
            nonsmooth_sincos(tau, &sine_0, &cosine_0);
            const double cos_tau = cosine_0;
            const double sin_tau = sine_0;
            /* z2_1: linear in second-breaks-forward */
            const double t2 = V*tau;
            const double t4 = cos_tau*t3;
            const double z2_1 = V*sin_tau - e1*t4 + h0 - t2;
            /* slip-stick for tau */
            const double t5 = chi*z2_1;
            const double t6 = e1 + t5;
            const double t7 = chi + cos_tau*h1;
            const double t8 = chi*sin_tau;
            const double z1_2 = V*sin_tau + V*(chi*tau - t8) + cos_tau*t6 + t7*z2_1;
            const double z2_2 = t2 + z2_1;
            const double v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6;
            /* functions of tau1 in slip-slip */
            const double t9 = omega1*tau1;
            double sine_1, cosine_1;
            nonsmooth_sincos(t9, &sine_1, &cosine_1);
            const double cos_omega1_tau1 = cosine_1;
            const double sin_omega1_tau1 = sine_1;
            const double t10 = omega2*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t10, &sine_2, &cosine_2);
            const double cos_omega2_tau1 = cosine_2;
            const double sin_omega2_tau1 = sine_2;
            const double t14 = h2*sin_omega2_tau1;
            const double t12 = sin_omega1_tau1*t11;
            const double t15 = p1*t12 + t13*t14;
            const double t16 = cos_omega1_tau1*p1 + cos_omega2_tau1*t13;
            const double t17 = cos_omega1_tau1*p2 + cos_omega2_tau1*h3;
            const double z1_3 = V*(h3*t14 + h4*sin_omega1_tau1) + t15*v1_2 + t16*z1_2 + t17*z2_2;
            const double t18 = h5*t14 + h6*sin_omega1_tau1;
            const double t19 = cos_omega1_tau1*p3 + cos_omega2_tau1*h5;
            const double t20 = cos_omega1_tau1*t13 + cos_omega2_tau1*p1;
            const double z2_3 = V*(p1*t14 + t12*t13) + t18*v1_2 + t19*z1_2 + t20*z2_2;
            const double t21 = omega2*sin_omega2_tau1;
            const double t22 = omega1*sin_omega1_tau1;
            const double t23 = h7*t22 + h8*t21;
            const double t24 = h3*t22 + h9*sin_omega2_tau1;
            const double v1_3 = V*t17 + t16*v1_2 + t23*z1_2 + t24*z2_2;
            const double t25 = h10*sin_omega2_tau1 + h5*t22;
            const double t26 = h7*t21 + h8*t22;
            const double v2_3 = V*t20 + t19*v1_2 + t25*z1_2 + t26*z2_2;
            /* first return of tau2 */
            const double cosine_part_tau2 = h11 + v2_3;
            const double t27 = omega3*z1_3;
            const double t28 = omega3*z2_3;
            const double sine_part_tau2 = t27 - t28;
            /* first return of tau2 */
            const double amplitude_tau2 = sqrt((cosine_part_tau2*cosine_part_tau2) + (sine_part_tau2*sine_part_tau2));
            /* first return of tau2 */
            const double t29 = (1.0/(amplitude_tau2));
            const double cos_tau2_return = sine_part_tau2*t29;
            const double sin_tau2_return = -cosine_part_tau2*t29;
            const double tau2 = t30*nonsmooth_angle(sin_tau2_return, cos_tau2_return);
            /* stick-stick for no time */
            const double t31 = V*tau2;
            const double z1_5 = sine_part_tau2*t30 + t31 + z2_3;
            const double z2_5 = amplitude_tau2*h12 + z1_5;
            /* d/dtau1 of: slip-slip for tau1 */
            const double t37 = chi*z2_3;
            const double v1_3_by_tau1 = t37 - z1_3;
            const double v2_3_by_tau1 = h14*t37 + t39*z1_3;
            /* functions of tau2 in stick-slip */
            const double t51 = omega3*tau2;
            double sine_3, cosine_3;
            nonsmooth_sincos(t51, &sine_3, &cosine_3);
            const double cos_omega3_tau2 = cosine_3;
            const double sin_omega3_tau2 = sine_3;
            /* stick-slip for tau2, until second-reaches-belt */
            const double z1_4 = t31 + z1_3;
            const double t52 = 1 - cos_omega3_tau2;
            const double t53 = sin_omega3_tau2*t30;
            const double z2_4 = V*(-t53 + tau2) + cos_omega3_tau2*z2_3 + t52*z1_3 + t53*v2_3;
            const double v2_4 = V*t52 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t27 - sin_omega3_tau2*t28;
            /* Phi along tau */
            const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t7*z2_1_on_boundary_by_z10;
            const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t7*z2_1_on_boundary_by_z20;
            const double carried_v1_2_by_z10 = h16*sin_tau + t8*z2_1_on_boundary_by_z10;
            const double carried_v1_2_by_z20 = h17*sin_tau + t8*z2_1_on_boundary_by_z20;
            /* rate of the exit boundary after tau */
            const double rate_2 = h1*v1_2 + t35;
            /* derivatives of the time to the boundary after tau */
            const double t57 = (1.0/(rate_2));
            const double delay_tau_by_z10 = t57*(carried_z1_2_by_z10*chi + h18);
            const double delay_tau_by_z20 = t57*(carried_z1_2_by_z20*chi + h19);
            /* perturbation on the boundary after tau */
            const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2;
            const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2;
            const double z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10;
            const double z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20;
            const double t58 = chi*z2_2 - z1_2;
            const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t58;
            const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t58;
            /* Phi along tau1 */
            const double carried_z1_3_by_z10 = t15*v1_2_on_boundary_by_z10 + t16*z1_2_on_boundary_by_z10 + t17*z2_2_on_boundary_by_z10;
            const double carried_z1_3_by_z20 = t15*v1_2_on_boundary_by_z20 + t16*z1_2_on_boundary_by_z20 + t17*z2_2_on_boundary_by_z20;
            const double carried_z2_3_by_z10 = t18*v1_2_on_boundary_by_z10 + t19*z1_2_on_boundary_by_z10 + t20*z2_2_on_boundary_by_z10;
            const double carried_z2_3_by_z20 = t18*v1_2_on_boundary_by_z20 + t19*z1_2_on_boundary_by_z20 + t20*z2_2_on_boundary_by_z20;
            const double carried_v1_3_by_z10 = t16*v1_2_on_boundary_by_z10 + t23*z1_2_on_boundary_by_z10 + t24*z2_2_on_boundary_by_z10;
            const double carried_v1_3_by_z20 = t16*v1_2_on_boundary_by_z20 + t23*z1_2_on_boundary_by_z20 + t24*z2_2_on_boundary_by_z20;
            const double carried_v2_3_by_z10 = t19*v1_2_on_boundary_by_z10 + t25*z1_2_on_boundary_by_z10 + t26*z2_2_on_boundary_by_z10;
            const double carried_v2_3_by_z20 = t19*v1_2_on_boundary_by_z20 + t25*z1_2_on_boundary_by_z20 + t26*z2_2_on_boundary_by_z20;
            /* rate of the exit boundary after tau1 */
            const double rate_3 = v1_3_by_tau1;
            /* derivatives of the time to the boundary after tau1 */
            const double t59 = (1.0/(rate_3));
            const double delay_tau1_by_z10 = -carried_v1_3_by_z10*t59;
            const double delay_tau1_by_z20 = -carried_v1_3_by_z20*t59;
            /* perturbation on the boundary after tau1 */
            const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3;
            const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3;
            const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3;
            const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3;
            const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*v2_3_by_tau1;
            const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*v2_3_by_tau1;
            /* Phi along tau2 */
            const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t52*z1_3_on_boundary_by_z20 + t53*v2_3_on_boundary_by_z20;
            const double t60 = omega3*sin_omega3_tau2;
            const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t60*z1_3_on_boundary_by_z10 - t60*z2_3_on_boundary_by_z10;
            const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t60*z1_3_on_boundary_by_z20 - t60*z2_3_on_boundary_by_z20;
            /* rate of the exit boundary after tau2 */
            const double rate_4 = h20*z2_4 + t39*z1_4;
            /* derivatives of the time to the boundary after tau2 */
            const double t61 = (1.0/(rate_4));
            const double delay_tau2_by_z10 = -carried_v2_4_by_z10*t61;
            const double delay_tau2_by_z20 = -carried_v2_4_by_z20*t61;
            /* perturbation on the boundary after tau2 */
            const double z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10;
            const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4;
            result[0][lane] = z1_5;
            result[1][lane] = z2_5;
            result[2][lane] = tau;
            result[3][lane] = tau1;
            result[4][lane] = tau2;
            result[5][lane] = e1;
            slope[lane] = z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20;
            double largest = 0.0;
            largest = fabs(-V + v1_3) > largest ? fabs(-V + v1_3) : largest;
            largest = fabs(-chi*z2_5 - e1 + z1_5) > largest ? fabs(-chi*z2_5 - e1 + z1_5) : largest;
            largest = fabs(-z2_1 + z2_5) > largest ? fabs(-z2_1 + z2_5) : largest;
            defect[lane] = largest;
            const double finite = (slope[lane] - slope[lane]) + (result[0][lane] - result[0][lane]) + (result[1][lane] - result[1][lane]) + (result[2][lane] - result[2][lane]) + (result[3][lane] - result[3][lane]) + (result[4][lane] - result[4][lane]) + (result[5][lane] - result[5][lane]);
            int32_t ending = ((result[2][lane] <= 0.0) | (result[3][lane] <= 0.0) | (result[4][lane] <= 0.0)) ? 3 : 0;
            ending = open[lane] != 0.0 ? 1 : ending;
            ending = finite == 0.0 ? ending : 2;
            ended[lane] = ending;
        }
        for (int i = 0; i < 6; ++i)
            for (int lane = 0; lane < here; ++lane)
                unknowns[i * count + start + lane] = result[i][lane];
        for (int lane = 0; lane < here; ++lane) {
            const ptrdiff_t point = start + lane;
            trace[point] = slope[lane];
            residual[point] = defect[lane];
            iterations[point] = taken[lane];
            status[point] = ended[lane];
        }
    }
}

/* Is each of `count` orbits a motion of the real system?
 * Takes parameters (4) and unknowns (6) for each, row by row. Gives the least values of the
 * open parameters (us1, us2) under which it is; the row of
 * the boundary that is crossed inside a phase (-1 none, -2 a dwell time is not positive, -3
 * data that are not finite), by how much, and how long after the start of the phase. */
void dry_friction_solution_ii_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int sums[] = {4, 3, 2, 3}, terms[] = {0, 1, 2, 1}, at_once[] = {1, 0, 0, 0};
    static const int opened[] = {-1, 0, -1, 1, -1, -1, 1, -1, -1, -1, 0, -1};
    static const int exits[] = {0, 12, 20, 40}, first_frequency[] = {0, 0, 1, 3};
    static const int begins[] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    static const double per_unit[] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 4 * point, *const u = unknowns + 6 * point;
        const double q[2] = {p[0], p[1]};
        const double durations[] = {0, u[2], u[3], u[4]};
        double spectral[7], derivatives[14], coefficients[44], frequencies[4];
        dry_friction_spectrum(q, spectral, derivatives);
        dry_friction_solution_ii_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        const double measures[] = {p[0], p[2], p[3], u[0], u[1], u[5]};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < 6; ++i)
            size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
        /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
        for (int phase = 0; phase < 4; ++phase) {
            const double miss = fabs(
                nonsmooth_evaluate(terms[phase], frequencies + first_frequency[phase],
                                   coefficients + exits[phase], durations[phase]).value);
            missed = miss > missed ? miss : missed;
        }
        const double most_missed = 0x1p-30 * size;
        const double noise = 32.0 * DBL_EPSILON * size +
                             (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
        double least[2], most = 0.0, when = 0.0;
        int found = -1, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 2; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 4 && found == -1; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[4], floor[4], maximum[4], time[4];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? -2 : -3;
            for (int i = 0; i < sums[phase]; ++i) {
                const double *const function = coefficient + i * length;
                usual[i] = opened[row + i] < 0
                    ? noise + nonsmooth_rounding(terms[phase], frequency, function, duration)
                    : least[opened[row + i]] * per_unit[row + i];
                /* a phase that begins on a boundary and rises crosses it, however little */
                const int rises = begins[row + i] && duration > 0.0 &&
                                  nonsmooth_rises(terms[phase], frequency, function, noise);
                floor[i] = rises ? -(double)INFINITY : usual[i];
            }
            nonsmooth_maxima(sums[phase], terms[phase], frequency, coefficient, duration, floor,
                             maximum, time);
            for (int i = 0; i < sums[phase] && found == -1; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = -3;
                } else if (maximum[i] > floor[i] && opened[row + i] >= 0) {
                    least[opened[row + i]] = maximum[i] / per_unit[row + i];
                } else if (maximum[i] > floor[i]) {
                    found = row + i;
                    most = maximum[i] > 0.0 ? maximum[i] : 0.0;
                    when = maximum[i] > usual[i] ? time[i] : 0.0;
                }
            }
            row += sums[phase];
            coefficient += sums[phase] * length;
            frequency += terms[phase];
        }
        for (int i = 0; i < 2; ++i)
            bounds[2 * point + i] = least[i];
        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}
