/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.dry_friction
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 589b5b148a78a35d */
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
    /* derivatives of ta on the boundary */
    const double t26 = (1.0/(rate_1));
    const double ta_by_z10 = -t26;
    const double ta_by_z20 = chi*t26;
    /* perturbation on the boundary after ta */
    const double t27 = V*ta_by_z10;
    const double z1_1_on_boundary_by_z10 = t27 + 1;
    const double z1_1_on_boundary_by_z20 = V*ta_by_z20;
    const double z2_1_on_boundary_by_z10 = t27;
    const double z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1;
    /* Phi along tau */
    const double carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10;
    const double carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20;
    const double carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10;
    const double carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20;
    /* rate of the exit boundary after tau */
    const double rate_2 = -chi*v1_2 + t25;
    /* derivatives of tau on the boundary */
    const double t29 = (1.0/(rate_2));
    const double tau_by_z10 = t29*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10);
    const double tau_by_z20 = t29*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20);
    /* perturbation on the boundary after tau */
    const double z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + tau_by_z10*v1_2;
    const double z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + tau_by_z20*v1_2;
    const double z2_2_on_boundary_by_z10 = V*tau_by_z10 + z2_1_on_boundary_by_z10;
    const double z2_2_on_boundary_by_z20 = V*tau_by_z20 + z2_1_on_boundary_by_z20;
    const double t30 = chi*z2_2 - z1_2;
    const double v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + t30*tau_by_z10;
    const double v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + t30*tau_by_z20;
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
    /* derivatives of tau1 on the boundary */
    const double t32 = (1.0/(rate_3));
    const double tau1_by_z10 = -carried_v1_3_by_z10*t32;
    const double tau1_by_z20 = -carried_v1_3_by_z20*t32;
    /* perturbation on the boundary after tau1 */
    const double z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + tau1_by_z10*v1_3;
    const double z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + tau1_by_z20*v1_3;
    const double z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + tau1_by_z10*v2_3;
    const double z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + tau1_by_z20*v2_3;
    const double t33 = chi*eta;
    const double t34 = -eta*t31 + t33*z1_3;
    const double v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + t34*tau1_by_z10;
    const double v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + t34*tau1_by_z20;
    /* Phi along tau2 */
    const double carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t22*z1_3_on_boundary_by_z10 + t23*v2_3_on_boundary_by_z10;
    const double carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t22*z1_3_on_boundary_by_z20 + t23*v2_3_on_boundary_by_z20;
    const double carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t24*z1_3_on_boundary_by_z10 - t24*z2_3_on_boundary_by_z10;
    const double carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t24*z1_3_on_boundary_by_z20 - t24*z2_3_on_boundary_by_z20;
    /* rate of the exit boundary after tau2 */
    const double rate_4 = t33*z1_4 - t33*z2_4;
    /* derivatives of tau2 on the boundary */
    const double t35 = (1.0/(rate_4));
    const double tau2_by_z10 = -carried_v2_4_by_z10*t35;
    const double tau2_by_z20 = -carried_v2_4_by_z20*t35;
    /* perturbation on the boundary after tau2 */
    const double z1_4_on_boundary_by_z10 = V*tau2_by_z10 + z1_3_on_boundary_by_z10;
    const double z1_4_on_boundary_by_z20 = V*tau2_by_z20 + z1_3_on_boundary_by_z20;
    const double z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + tau2_by_z10*v2_4;
    const double z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + tau2_by_z20*v2_4;
    poincare_jacobian[0] = z1_4_on_boundary_by_z10;
    poincare_jacobian[1] = z1_4_on_boundary_by_z20;
    poincare_jacobian[2] = z2_4_on_boundary_by_z10;
    poincare_jacobian[3] = z2_4_on_boundary_by_z20;
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

/* Newton's method on the reduced equations for `count` points.
 * Takes parameters (5) and guess (2: tau, tau1) for each point, row by row; gives unknowns
 * (6), the trace, the largest reduced residual, iterations and a status for each point.
 * In one step a dwell time changes by a factor of four at most; a point has converged when
 * a whole step is below 1e-9 max(1, |x|).
 * Status: 0 converged, 1 not converged, 2 not finite, 3 a dwell time is not positive. */
NONSMOOTH_MULTIVERSION
void dry_friction_global_stick_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = 8, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[5][lanes], x[2][lanes], fixed[33][lanes];
        double taken[lanes], open[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 5; ++i)
                parameter[i][lane] = parameters[5 * point + i];
            for (int i = 0; i < 2; ++i)
                x[i][lane] = guess[2 * point + i];
            taken[lane] = 0.0;
            open[lane] = 1.0;
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
                taken[lane] += open[lane];
                open[lane] = (fabs(wanted_0 - tau) <= 1e-9*size_0) & (fabs(wanted_1 - tau1) <= 1e-9*size_1) ? 0.0 : open[lane];
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
        double result[6][lanes], slope[lanes], defect[lanes];
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
        }
        for (int lane = 0; lane < here; ++lane) {
            const ptrdiff_t point = start + lane;
            int sound = isfinite(slope[lane]) != 0;
            for (int i = 0; i < 6; ++i) {
                unknowns[6 * point + i] = result[i][lane];
                sound &= isfinite(result[i][lane]) != 0;
            }
            trace[point] = slope[lane];
            residual[point] = defect[lane];
            iterations[point] = (int32_t)taken[lane];
            status[point] = !sound ? 2 : open[lane] != 0.0 ? 1 : (result[2][lane] <= 0.0 || result[3][lane] <= 0.0 || result[4][lane] <= 0.0 || result[5][lane] <= 0.0) ? 3 : 0;
        }
    }
}

/* Is each of `count` orbits a motion of the real system?
 * Takes parameters (5) and unknowns (6) for each, row by row. Gives the least values of the
 * open parameters (us1, us2) under which it is; the row of the boundary that is crossed inside
 * a phase (-1 none, -2 a dwell time is not positive, -3 data that are not finite), by how
 * much, and how long after the start of the phase. */
void dry_friction_global_stick_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *bounds,
    int32_t *boundary, double *excess, double *instant)
{
    static const int sums[] = {4, 3, 2, 3}, terms[] = {0, 1, 2, 1}, dwell[] = {2, 3, 4, 5};
    static const int opened[] = {-1, 0, -1, 1, -1, -1, 1, -1, -1, -1, 0, -1};
    static const double per_unit[] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 5 * point, *const u = unknowns + 6 * point;
        const double q[2] = {p[0], p[1]};
        double spectral[7], derivatives[14], coefficients[44], frequencies[4];
        dry_friction_spectrum(q, spectral, derivatives);
        dry_friction_global_stick_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        double noise = 0.0;
        for (int i = 0; i < 5; ++i)
            noise = fabs(p[i]) > noise ? fabs(p[i]) : noise;
        for (int i = 0; i < 6; ++i)
            noise = fabs(u[i]) > noise ? fabs(u[i]) : noise;
        noise *= 32.0 * DBL_EPSILON;
        double least[2], most = 0.0, when = 0.0;
        int found = -1, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 2; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 4 && found == -1; ++phase) {
            const double duration = u[dwell[phase]];
            const int length = 2 + 2 * terms[phase];
            double floor[4], maximum[4], time[4];
            if (!(duration > 0.0))
                found = duration <= 0.0 ? -2 : -3;
            for (int i = 0; i < sums[phase]; ++i)
                floor[i] = opened[row + i] < 0
                    ? noise + nonsmooth_rounding(terms[phase], frequency,
                                                 coefficient + i * length, duration)
                    : least[opened[row + i]] * per_unit[row + i];
            nonsmooth_maxima(sums[phase], terms[phase], frequency, coefficient, duration, floor,
                             maximum, time);
            for (int i = 0; i < sums[phase] && found == -1; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = -3;
                } else if (maximum[i] > floor[i] && opened[row + i] >= 0) {
                    least[opened[row + i]] = maximum[i] / per_unit[row + i];
                } else if (maximum[i] > floor[i]) {
                    found = row + i;
                    most = maximum[i];
                    when = time[i];
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
