/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 34270e2de36ca60b */
#include "elastic_stop.h"

#include <math.h>

#include "nonsmooth_admissible.h"
#include "nonsmooth_admissible_sums.h"
#include "nonsmooth_compiler.h"
#include "nonsmooth_elimination.h"
#include "nonsmooth_lanes.h"
#include "nonsmooth_newton.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 308. Intermediate terms: 146. */
static NONSMOOTH_INLINE void elastic_stop_spectrum_in_lane(
    int lanes, int lane, const double *parameters, double *spectrum, double *spectrum_derivatives)
{
    const double m1 = parameters[lane], m2 = parameters[1*lanes + lane],
        k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane],
        k3 = parameters[4*lanes + lane];
    /* spectrum */
    const double t0 = (1.0/(m1));
    const double t1 = k1 + k3;
    const double t2 = t0*t1;
    const double t3 = (1.0/(m2));
    const double t4 = k1 + k2;
    const double t5 = t3*t4;
    const double t6 = t2 - t5;
    const double t7 = (k1*k1);
    const double t8 = 4*t3*t7;
    const double t9 = t0*t8;
    const double gap1 = sqrt((t6*t6) + t9);
    const double t10 = (1.0/2.0)*t5;
    const double omega1 = sqrt((1.0/2.0)*gap1 + t10 + (1.0/2.0)*t2);
    const double t11 = (1.0/(omega1));
    const double t12 = sqrt(k1*k2 + k1*k3 + k2*k3);
    const double t13 = (1.0/sqrt(m2));
    const double t14 = (1.0/sqrt(m1));
    const double t15 = t13*t14;
    const double t16 = t12*t15;
    const double omega2 = t11*t16;
    const double t17 = (1.0/(gap1));
    const double t18 = (1.0/2.0)*t17;
    const double p1 = t18*t6 + 1.0/2.0;
    const double t19 = k1*t0;
    const double p2 = -t17*t19;
    const double t20 = t17*t3;
    const double p3 = -k1*t20;
    const double t21 = t19 - t5;
    const double gap2 = sqrt((t21*t21) + t9);
    const double omega3 = sqrt((1.0/2.0)*gap2 + t10 + (1.0/2.0)*t19);
    const double t22 = (1.0/(omega3));
    const double t23 = sqrt(k2);
    const double t24 = sqrt(k1);
    const double t25 = t23*t24;
    const double t26 = t15*t25;
    const double omega4 = t22*t26;
    const double t27 = (1.0/(gap2));
    const double t28 = (1.0/2.0)*t27;
    const double p4 = t21*t28 + 1.0/2.0;
    const double p5 = -t19*t27;
    const double t29 = t27*t3;
    const double p6 = -k1*t29;
    if (spectrum) {
        spectrum[lane] = gap1;
        spectrum[1*lanes + lane] = omega1;
        spectrum[2*lanes + lane] = omega2;
        spectrum[3*lanes + lane] = p1;
        spectrum[4*lanes + lane] = p2;
        spectrum[5*lanes + lane] = p3;
        spectrum[6*lanes + lane] = gap2;
        spectrum[7*lanes + lane] = omega3;
        spectrum[8*lanes + lane] = omega4;
        spectrum[9*lanes + lane] = p4;
        spectrum[10*lanes + lane] = p5;
        spectrum[11*lanes + lane] = p6;
    }
    if (!spectrum_derivatives)
        return;
    /* d/dm1 of: spectrum */
    const double t30 = (1.0/(m1*m1));
    const double t31 = t1*t30;
    const double t32 = t30*t8;
    const double gap1_by_m1 = t18*(-2*t31*t6 - t32);
    const double t33 = (1.0/2.0)*gap1_by_m1;
    const double t34 = (1.0/2.0)*t11;
    const double omega1_by_m1 = t34*(-1.0/2.0*t31 + t33);
    const double t35 = t12*t34;
    const double t36 = t13/(sqrt(m1)*sqrt(m1)*sqrt(m1));
    const double t37 = t16/(omega1*omega1);
    const double omega2_by_m1 = -omega1_by_m1*t37 - t35*t36;
    const double t38 = (1.0/(gap1*gap1));
    const double t39 = t38*t6;
    const double p1_by_m1 = -t18*t31 - t33*t39;
    const double t40 = k1*t30;
    const double t41 = gap1_by_m1*t38;
    const double p2_by_m1 = t17*t40 + t19*t41;
    const double t42 = k1*t3;
    const double p3_by_m1 = t41*t42;
    const double gap2_by_m1 = t28*(-2*t21*t40 - t32);
    const double t43 = (1.0/2.0)*k1;
    const double t44 = t30*t43;
    const double t45 = (1.0/2.0)*t22;
    const double omega3_by_m1 = t45*((1.0/2.0)*gap2_by_m1 - t44);
    const double t46 = t25*t45;
    const double t47 = t26/(omega3*omega3);
    const double omega4_by_m1 = -omega3_by_m1*t47 - t36*t46;
    const double t48 = (1.0/(gap2*gap2));
    const double t49 = t21*t48;
    const double p4_by_m1 = -1.0/2.0*gap2_by_m1*t49 - t27*t44;
    const double t50 = gap2_by_m1*t48;
    const double p5_by_m1 = t19*t50 + t27*t40;
    const double p6_by_m1 = t42*t50;
    /* d/dm2 of: spectrum */
    const double t51 = (1.0/(m2*m2));
    const double t52 = 4*t0*t51*t7;
    const double gap1_by_m2 = t18*(2*t4*t51*t6 - t52);
    const double t53 = (1.0/2.0)*gap1_by_m2;
    const double t54 = -1.0/2.0*t4*t51;
    const double omega1_by_m2 = t34*(t53 + t54);
    const double t55 = t14/(sqrt(m2)*sqrt(m2)*sqrt(m2));
    const double omega2_by_m2 = -omega1_by_m2*t37 - t35*t55;
    const double p1_by_m2 = (1.0/2.0)*t17*t4*t51 - t39*t53;
    const double t56 = gap1_by_m2*t38;
    const double p2_by_m2 = t19*t56;
    const double t57 = k1*t51;
    const double p3_by_m2 = t17*t57 + t42*t56;
    const double gap2_by_m2 = t28*(2*t21*t4*t51 - t52);
    const double t58 = (1.0/2.0)*gap2_by_m2;
    const double omega3_by_m2 = t45*(t54 + t58);
    const double omega4_by_m2 = -omega3_by_m2*t47 - t46*t55;
    const double p4_by_m2 = (1.0/2.0)*t27*t4*t51 - t49*t58;
    const double t59 = gap2_by_m2*t48;
    const double p5_by_m2 = t19*t59;
    const double p6_by_m2 = t27*t57 + t42*t59;
    /* d/dk1 of: spectrum */
    const double t60 = 2*t0 - 2*t3;
    const double t61 = 8*t19*t3;
    const double gap1_by_k1 = t18*(t6*t60 + t61);
    const double t62 = (1.0/2.0)*gap1_by_k1;
    const double t63 = (1.0/2.0)*t3;
    const double t64 = (1.0/2.0)*t0;
    const double t65 = t63 + t64;
    const double omega1_by_k1 = t34*(t62 + t65);
    const double t66 = (1.0/2.0)*k3;
    const double t67 = (1.0/2.0)*k2;
    const double t68 = t11*t15/t12;
    const double omega2_by_k1 = -omega1_by_k1*t37 + t68*(t66 + t67);
    const double t69 = t0 - t3;
    const double p1_by_k1 = t18*t69 - t39*t62;
    const double t70 = t0*t17;
    const double t71 = gap1_by_k1*t38;
    const double p2_by_k1 = t19*t71 - t70;
    const double p3_by_k1 = -t20 + t42*t71;
    const double gap2_by_k1 = t28*(t21*t60 + t61);
    const double t72 = (1.0/2.0)*gap2_by_k1;
    const double omega3_by_k1 = t45*(t65 + t72);
    const double omega4_by_k1 = -omega3_by_k1*t47 + (1.0/2.0)*t13*t14*t22*t23/t24;
    const double p4_by_k1 = t28*t69 - t49*t72;
    const double t73 = gap2_by_k1*t48;
    const double p5_by_k1 = -t0*t27 + t19*t73;
    const double p6_by_k1 = -t29 + t42*t73;
    /* d/dk2 of: spectrum */
    const double gap1_by_k2 = -t20*t6;
    const double t74 = (1.0/2.0)*gap1_by_k2;
    const double omega1_by_k2 = t34*(t63 + t74);
    const double omega2_by_k2 = -omega1_by_k2*t37 + t68*(t43 + t66);
    const double p1_by_k2 = -t17*t63 - t39*t74;
    const double t75 = gap1_by_k2*t38;
    const double p2_by_k2 = t19*t75;
    const double p3_by_k2 = t42*t75;
    const double gap2_by_k2 = -t21*t29;
    const double t76 = (1.0/2.0)*gap2_by_k2;
    const double omega3_by_k2 = t45*(t63 + t76);
    const double omega4_by_k2 = -omega3_by_k2*t47 + (1.0/2.0)*t13*t14*t22*t24/t23;
    const double p4_by_k2 = -t27*t63 - t49*t76;
    const double t77 = gap2_by_k2*t48;
    const double p5_by_k2 = t19*t77;
    const double p6_by_k2 = t42*t77;
    /* d/dk3 of: spectrum */
    const double gap1_by_k3 = t6*t70;
    const double t78 = (1.0/2.0)*gap1_by_k3;
    const double omega1_by_k3 = t34*(t64 + t78);
    const double omega2_by_k3 = -omega1_by_k3*t37 + t68*(t43 + t67);
    const double p1_by_k3 = (1.0/2.0)*t0*t17 - t39*t78;
    const double t79 = gap1_by_k3*t38;
    const double p2_by_k3 = t19*t79;
    const double p3_by_k3 = t42*t79;
    if (spectrum_derivatives) {
        spectrum_derivatives[lane] = gap1_by_m1;
        spectrum_derivatives[1*lanes + lane] = gap1_by_m2;
        spectrum_derivatives[2*lanes + lane] = gap1_by_k1;
        spectrum_derivatives[3*lanes + lane] = gap1_by_k2;
        spectrum_derivatives[4*lanes + lane] = gap1_by_k3;
        spectrum_derivatives[5*lanes + lane] = omega1_by_m1;
        spectrum_derivatives[6*lanes + lane] = omega1_by_m2;
        spectrum_derivatives[7*lanes + lane] = omega1_by_k1;
        spectrum_derivatives[8*lanes + lane] = omega1_by_k2;
        spectrum_derivatives[9*lanes + lane] = omega1_by_k3;
        spectrum_derivatives[10*lanes + lane] = omega2_by_m1;
        spectrum_derivatives[11*lanes + lane] = omega2_by_m2;
        spectrum_derivatives[12*lanes + lane] = omega2_by_k1;
        spectrum_derivatives[13*lanes + lane] = omega2_by_k2;
        spectrum_derivatives[14*lanes + lane] = omega2_by_k3;
        spectrum_derivatives[15*lanes + lane] = p1_by_m1;
        spectrum_derivatives[16*lanes + lane] = p1_by_m2;
        spectrum_derivatives[17*lanes + lane] = p1_by_k1;
        spectrum_derivatives[18*lanes + lane] = p1_by_k2;
        spectrum_derivatives[19*lanes + lane] = p1_by_k3;
        spectrum_derivatives[20*lanes + lane] = p2_by_m1;
        spectrum_derivatives[21*lanes + lane] = p2_by_m2;
        spectrum_derivatives[22*lanes + lane] = p2_by_k1;
        spectrum_derivatives[23*lanes + lane] = p2_by_k2;
        spectrum_derivatives[24*lanes + lane] = p2_by_k3;
        spectrum_derivatives[25*lanes + lane] = p3_by_m1;
        spectrum_derivatives[26*lanes + lane] = p3_by_m2;
        spectrum_derivatives[27*lanes + lane] = p3_by_k1;
        spectrum_derivatives[28*lanes + lane] = p3_by_k2;
        spectrum_derivatives[29*lanes + lane] = p3_by_k3;
        spectrum_derivatives[30*lanes + lane] = gap2_by_m1;
        spectrum_derivatives[31*lanes + lane] = gap2_by_m2;
        spectrum_derivatives[32*lanes + lane] = gap2_by_k1;
        spectrum_derivatives[33*lanes + lane] = gap2_by_k2;
        spectrum_derivatives[34*lanes + lane] = 0;
        spectrum_derivatives[35*lanes + lane] = omega3_by_m1;
        spectrum_derivatives[36*lanes + lane] = omega3_by_m2;
        spectrum_derivatives[37*lanes + lane] = omega3_by_k1;
        spectrum_derivatives[38*lanes + lane] = omega3_by_k2;
        spectrum_derivatives[39*lanes + lane] = 0;
        spectrum_derivatives[40*lanes + lane] = omega4_by_m1;
        spectrum_derivatives[41*lanes + lane] = omega4_by_m2;
        spectrum_derivatives[42*lanes + lane] = omega4_by_k1;
        spectrum_derivatives[43*lanes + lane] = omega4_by_k2;
        spectrum_derivatives[44*lanes + lane] = 0;
        spectrum_derivatives[45*lanes + lane] = p4_by_m1;
        spectrum_derivatives[46*lanes + lane] = p4_by_m2;
        spectrum_derivatives[47*lanes + lane] = p4_by_k1;
        spectrum_derivatives[48*lanes + lane] = p4_by_k2;
        spectrum_derivatives[49*lanes + lane] = 0;
        spectrum_derivatives[50*lanes + lane] = p5_by_m1;
        spectrum_derivatives[51*lanes + lane] = p5_by_m2;
        spectrum_derivatives[52*lanes + lane] = p5_by_k1;
        spectrum_derivatives[53*lanes + lane] = p5_by_k2;
        spectrum_derivatives[54*lanes + lane] = 0;
        spectrum_derivatives[55*lanes + lane] = p6_by_m1;
        spectrum_derivatives[56*lanes + lane] = p6_by_m2;
        spectrum_derivatives[57*lanes + lane] = p6_by_k1;
        spectrum_derivatives[58*lanes + lane] = p6_by_k2;
        spectrum_derivatives[59*lanes + lane] = 0;
    }
}

void elastic_stop_spectrum(
    const double parameters[5], double *spectrum, double *spectrum_derivatives)
{
    elastic_stop_spectrum_in_lane(1, 0, parameters, spectrum, spectrum_derivatives);
}

/* State after a time in contact.
 * Operations: 128. Intermediate terms: 24. */
void elastic_stop_flow_contact(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    const double k1 = parameters[2], k2 = parameters[3], k3 = parameters[4];
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
    const double t11 = k1*k3;
    const double t12 = k2*k3 + t11;
    const double t13 = (1.0/((k1*k2 + t12)));
    const double t14 = t12*t13;
    const double t15 = t11*t13;
    const double t16 = p2*t15;
    const double t17 = p1*t14;
    const double t18 = p1*t7 - t6*t8;
    const double t19 = -p3*t7 + p3*t8;
    const double t20 = p3*t14;
    const double t21 = p1*t15;
    const double t22 = omega2*t4;
    const double t23 = omega1*t1;
    state_after[0] = t10*x1 + t14 + t7*(t14*t6 + t16) + t8*(-t16 - t17) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5);
    state_after[1] = t15 + t18*x2 + t19*x1 + t7*(t20 - t21) + t8*(t15*t6 - t20) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6);
    state_after[2] = t1*(omega1*t16 + omega1*t17) + t10*v1 + t4*(-omega2*t12*t13*t6 - omega2*t16) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23);
    state_after[3] = t1*(-omega1*t15*t6 + omega1*t20) + t18*v2 + t19*v1 + t4*(-omega2*t20 + omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6);
}

/* State after a time in free.
 * Operations: 77. Intermediate terms: 15. */
void elastic_stop_flow_free(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[7], omega4 = spectrum[8], p4 = spectrum[9], p5 = spectrum[10],
        p6 = spectrum[11];
    const double x1 = state[0], x2 = state[1], v1 = state[2], v2 = state[3];
    /* state_after */
    const double t0 = omega3*time;
    const double t1 = sin(t0);
    const double t2 = t1/omega3;
    const double t3 = omega4*time;
    const double t4 = sin(t3);
    const double t5 = t4/omega4;
    const double t6 = 1 - p4;
    const double t7 = cos(t3);
    const double t8 = cos(t0);
    const double t9 = -p5*t7 + p5*t8;
    const double t10 = p4*t8 + t6*t7;
    const double t11 = p4*t7 + t6*t8;
    const double t12 = -p6*t7 + p6*t8;
    const double t13 = omega4*t4;
    const double t14 = omega3*t1;
    state_after[0] = t10*x1 + t9*x2 + v1*(p4*t2 + t5*t6) + v2*(p5*t2 - p5*t5);
    state_after[1] = t11*x2 + t12*x1 + v1*(p6*t2 - p6*t5) + v2*(p4*t5 + t2*t6);
    state_after[2] = t10*v1 + t9*v2 + x1*(-p4*t14 - t13*t6) + x2*(p5*t13 - p5*t14);
    state_after[3] = t11*v2 + t12*v1 + x1*(p6*t13 - p6*t14) + x2*(-p4*t13 - t14*t6);
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Operations: 12. Intermediate terms: 5. */
void elastic_stop_fields(
    const double parameters[5], double fields[40])
{
    const double m1 = parameters[0], m2 = parameters[1], k1 = parameters[2], k2 = parameters[3],
        k3 = parameters[4];
    /* fields */
    const double t0 = (1.0/(m1));
    const double t1 = k1*t0;
    const double t2 = (1.0/(m2));
    const double t3 = k1*t2;
    const double t4 = -t2*(k1 + k2);
    for (int i = 0; i < 40; ++i)
        fields[i] = 0.0;
    fields[2] = 1;
    fields[8] = 1;
    fields[10] = -t0*(k1 + k3);
    fields[11] = t1;
    fields[14] = k3*t0;
    fields[15] = t3;
    fields[16] = t4;
    fields[22] = 1;
    fields[28] = 1;
    fields[30] = -t1;
    fields[31] = t1;
    fields[35] = t3;
    fields[36] = t4;
}

/* Affine functions of the state: gradients, constants last.
 * Operations: 3. Intermediate terms: 0. */
void elastic_stop_rows(
    const double parameters[5], double rows[25])
{
    const double k3 = parameters[4];
    for (int i = 0; i < 25; ++i)
        rows[i] = 0.0;
    rows[0] = -1;
    rows[4] = 1;
    rows[5] = 1;
    rows[9] = -1;
    rows[10] = -k3;
    rows[14] = k3;
    rows[17] = 1;
}

/* Affine resets of the state, one below the other, offsets last.
 * Operations: 0. Intermediate terms: 0. */
void elastic_stop_resets(
    const double parameters[5], double resets[20])
{
    (void)parameters;
    for (int i = 0; i < 20; ++i)
        resets[i] = 0.0;
    resets[0] = 1;
    resets[6] = 1;
    resets[12] = 1;
    resets[18] = 1;
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Operations: 104. Intermediate terms: 20. */
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double *exponents, double *coefficients)
{
    const double k1 = parameters[2], k2 = parameters[3], k3 = parameters[4];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[7], omega4 = spectrum[8], p4 = spectrum[9],
        p5 = spectrum[10], p6 = spectrum[11];
    if (exponents) {
        for (int i = 0; i < 12; ++i)
            exponents[i] = 0.0;
        exponents[3] = omega1;
        exponents[5] = omega2;
        exponents[9] = omega3;
        exponents[11] = omega4;
    }
    if (!coefficients)
        return;
    /* coefficients */
    const double t0 = k1*k3;
    const double t1 = k2*k3 + t0;
    const double t2 = (1.0/((k1*k2 + t1)));
    const double t3 = t1*t2;
    const double t4 = t0*t2;
    const double t5 = p2*t4;
    const double t6 = p1 - 1;
    const double t7 = -p3*t3;
    const double t8 = (1.0/(omega1));
    const double t9 = omega1*p1;
    const double t10 = omega1*p2;
    const double t11 = omega1*p3;
    const double t12 = -omega1*t6;
    const double t13 = (1.0/(omega2));
    const double t14 = omega2*p2;
    const double t15 = omega2*p3;
    const double t16 = omega2*p1;
    const double t17 = 1 - p4;
    const double t18 = (1.0/(omega3));
    const double t19 = (1.0/(omega4));
    if (coefficients) {
        for (int i = 0; i < 200; ++i)
            coefficients[i] = 0.0;
        coefficients[4] = t3;
        coefficients[9] = t4;
        coefficients[20] = p1;
        coefficients[21] = p2;
        coefficients[24] = -p1*t3 - t5;
        coefficients[25] = p3;
        coefficients[26] = -t6;
        coefficients[29] = t4*t6 + t7;
        coefficients[32] = p1;
        coefficients[33] = p2;
        coefficients[37] = p3;
        coefficients[38] = -t6;
        coefficients[42] = p1*t8;
        coefficients[43] = p2*t8;
        coefficients[47] = p3*t8;
        coefficients[48] = -t6*t8;
        coefficients[50] = -t9;
        coefficients[51] = -t10;
        coefficients[54] = t10*t4 + t3*t9;
        coefficients[55] = -t11;
        coefficients[56] = -t12;
        coefficients[59] = t11*t3 + t12*t4;
        coefficients[60] = -t6;
        coefficients[61] = -p2;
        coefficients[64] = t3*t6 + t5;
        coefficients[65] = -p3;
        coefficients[66] = p1;
        coefficients[69] = -p1*t4 - t7;
        coefficients[72] = -t6;
        coefficients[73] = -p2;
        coefficients[77] = -p3;
        coefficients[78] = p1;
        coefficients[82] = -t13*t6;
        coefficients[83] = -p2*t13;
        coefficients[87] = -p3*t13;
        coefficients[88] = p1*t13;
        coefficients[90] = omega2*t6;
        coefficients[91] = t14;
        coefficients[94] = -omega2*t1*t2*t6 - t14*t4;
        coefficients[95] = t15;
        coefficients[96] = -t16;
        coefficients[99] = -t15*t3 + t16*t4;
        coefficients[120] = p4;
        coefficients[121] = p5;
        coefficients[125] = p6;
        coefficients[126] = t17;
        coefficients[132] = p4;
        coefficients[133] = p5;
        coefficients[137] = p6;
        coefficients[138] = t17;
        coefficients[142] = p4*t18;
        coefficients[143] = p5*t18;
        coefficients[147] = p6*t18;
        coefficients[148] = t17*t18;
        coefficients[150] = -omega3*p4;
        coefficients[151] = -omega3*p5;
        coefficients[155] = -omega3*p6;
        coefficients[156] = -omega3*t17;
        coefficients[160] = t17;
        coefficients[161] = -p5;
        coefficients[165] = -p6;
        coefficients[166] = p4;
        coefficients[172] = t17;
        coefficients[173] = -p5;
        coefficients[177] = -p6;
        coefficients[178] = p4;
        coefficients[182] = t17*t19;
        coefficients[183] = -p5*t19;
        coefficients[187] = -p6*t19;
        coefficients[188] = p4*t19;
        coefficients[190] = -omega4*t17;
        coefficients[191] = omega4*p5;
        coefficients[195] = omega4*p6;
        coefficients[196] = -omega4*p4;
    }
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 774. Intermediate terms: 185. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane],
        k3 = parameters[4*lanes + lane], T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[7*lanes + lane], omega4 = spectrum[8*lanes + lane],
        p4 = spectrum[9*lanes + lane], p5 = spectrum[10*lanes + lane],
        p6 = spectrum[11*lanes + lane];
    const double y = unknowns[lane], u = unknowns[1*lanes + lane], w = unknowns[2*lanes + lane],
        tau = unknowns[3*lanes + lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t1 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t2 = half_tau1*omega3;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t2);
    const double cos_omega3_half_tau1 = wave_2.cosine;
    const double sin_omega3_half_tau1 = wave_2.sine;
    const double t3 = half_tau1*omega4;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega4_half_tau1 = wave_3.cosine;
    const double sin_omega4_half_tau1 = wave_3.sine;
    /* residual */
    const double t4 = p1*u + p2*w;
    const double t5 = -t4 + u;
    const double t6 = k1*k2;
    const double t7 = p1*t6;
    const double t8 = k1*k3;
    const double t9 = p2*t8;
    const double t10 = k2*k3;
    const double t11 = t10*y;
    const double t12 = t6*y;
    const double t13 = p2*t11 + p2*t12 + t7 + t9*y - t9;
    const double t14 = t13 - t6;
    const double t15 = t10 + t6 + t8;
    const double t16 = (1.0/(t15));
    const double t17 = omega2*t16;
    const double t18 = sin_omega2_half_tau*t17;
    const double t19 = omega1*t16;
    const double t20 = sin_omega1_half_tau*t19;
    const double t21 = -p1*w + p3*u;
    const double t22 = t21 + w;
    const double t23 = p1*t8;
    const double t24 = p3*t6;
    const double t25 = t11 + t12 + t8*y - t8;
    const double t26 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t23 - t24 - t25;
    const double t27 = p1*t11 + t23*y - t23 - t24 + t7*y;
    const double t28 = p4*u + p5*w;
    const double t29 = t28 - u;
    const double t30 = p4 + p5*y;
    const double t31 = t30 - 1;
    const double t32 = omega4*sin_omega4_half_tau1;
    const double t33 = omega3*sin_omega3_half_tau1;
    const double t34 = -p4*w + p6*u;
    const double t35 = -t34 - w;
    const double t36 = -p4*y + p6;
    const double t37 = -t36 - y;
    if (residual) {
        residual[lane] = cos_omega1_half_tau*t4 + cos_omega2_half_tau*t5 - t13*t20 + t14*t18;
        residual[1*lanes + lane] = cos_omega1_half_tau*t22 - cos_omega2_half_tau*t21 - t18*t27 + t20*t26;
        residual[2*lanes + lane] = -cos_omega3_half_tau1*t28 + cos_omega4_half_tau1*t29 - t30*t33 + t31*t32;
        residual[3*lanes + lane] = cos_omega3_half_tau1*t35 + cos_omega4_half_tau1*t34 + t32*t36 + t33*t37;
    }
    if (!jacobian && !parameter_jacobian)
        return;
    /* d/dtau of: functions of half_tau in contact */
    const double t38 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t38;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t38;
    const double t39 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t39;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t39;
    /* d/dtau of: functions of half_tau1 in free */
    const double t40 = (1.0/2.0)*omega3;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t40;
    const double sin_omega3_half_tau1_by_T = cos_omega3_half_tau1*t40;
    const double sin_omega3_half_tau1_by_tau = -sin_omega3_half_tau1_by_T;
    const double t41 = (1.0/2.0)*omega4;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t41;
    const double sin_omega4_half_tau1_by_T = cos_omega4_half_tau1*t41;
    const double sin_omega4_half_tau1_by_tau = -sin_omega4_half_tau1_by_T;
    /* jacobian */
    const double t42 = p2*t10 + p2*t6 + t9;
    const double t43 = 1 - p1;
    const double t44 = sin_omega2_half_tau_by_tau*t17;
    const double t45 = sin_omega1_half_tau_by_tau*t19;
    const double t46 = p1*t10 + t23 + t7;
    const double t47 = p4 - 1;
    const double t48 = omega4*sin_omega4_half_tau1_by_tau;
    const double t49 = omega3*sin_omega3_half_tau1_by_tau;
    if (jacobian) {
        jacobian[lane] = t18*t42 - t20*t42;
        jacobian[1*lanes + lane] = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t43;
        jacobian[2*lanes + lane] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
        jacobian[3*lanes + lane] = cos_omega1_half_tau_by_tau*t4 + cos_omega2_half_tau_by_tau*t5 - t13*t45 + t14*t44;
        jacobian[4*lanes + lane] = omega1*sin_omega1_half_tau*t16*(-t10 + t46 - t6 - t8) - t18*t46;
        jacobian[5*lanes + lane] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
        jacobian[6*lanes + lane] = cos_omega1_half_tau*t43 + cos_omega2_half_tau*p1;
        jacobian[7*lanes + lane] = cos_omega1_half_tau_by_tau*t22 - cos_omega2_half_tau_by_tau*t21 + t26*t45 - t27*t44;
        jacobian[8*lanes + lane] = p5*t32 - p5*t33;
        jacobian[9*lanes + lane] = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t47;
        jacobian[10*lanes + lane] = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
        jacobian[11*lanes + lane] = -cos_omega3_half_tau1_by_tau*t28 + cos_omega4_half_tau1_by_tau*t29 - t30*t49 + t31*t48;
        jacobian[12*lanes + lane] = omega3*sin_omega3_half_tau1*t47 - p4*t32;
        jacobian[13*lanes + lane] = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
        jacobian[14*lanes + lane] = cos_omega3_half_tau1*t47 - cos_omega4_half_tau1*p4;
        jacobian[15*lanes + lane] = cos_omega3_half_tau1_by_tau*t35 + cos_omega4_half_tau1_by_tau*t34 + t36*t48 + t37*t49;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_m1 = spectrum_derivatives[5*lanes + lane],
        omega1_by_m2 = spectrum_derivatives[6*lanes + lane],
        omega1_by_k1 = spectrum_derivatives[7*lanes + lane],
        omega1_by_k2 = spectrum_derivatives[8*lanes + lane],
        omega1_by_k3 = spectrum_derivatives[9*lanes + lane],
        omega2_by_m1 = spectrum_derivatives[10*lanes + lane],
        omega2_by_m2 = spectrum_derivatives[11*lanes + lane],
        omega2_by_k1 = spectrum_derivatives[12*lanes + lane],
        omega2_by_k2 = spectrum_derivatives[13*lanes + lane],
        omega2_by_k3 = spectrum_derivatives[14*lanes + lane],
        p1_by_m1 = spectrum_derivatives[15*lanes + lane],
        p1_by_m2 = spectrum_derivatives[16*lanes + lane],
        p1_by_k1 = spectrum_derivatives[17*lanes + lane],
        p1_by_k2 = spectrum_derivatives[18*lanes + lane],
        p1_by_k3 = spectrum_derivatives[19*lanes + lane],
        p2_by_m1 = spectrum_derivatives[20*lanes + lane],
        p2_by_m2 = spectrum_derivatives[21*lanes + lane],
        p2_by_k1 = spectrum_derivatives[22*lanes + lane],
        p2_by_k2 = spectrum_derivatives[23*lanes + lane],
        p2_by_k3 = spectrum_derivatives[24*lanes + lane],
        p3_by_m1 = spectrum_derivatives[25*lanes + lane],
        p3_by_m2 = spectrum_derivatives[26*lanes + lane],
        p3_by_k1 = spectrum_derivatives[27*lanes + lane],
        p3_by_k2 = spectrum_derivatives[28*lanes + lane],
        p3_by_k3 = spectrum_derivatives[29*lanes + lane],
        omega3_by_m1 = spectrum_derivatives[35*lanes + lane],
        omega3_by_m2 = spectrum_derivatives[36*lanes + lane],
        omega3_by_k1 = spectrum_derivatives[37*lanes + lane],
        omega3_by_k2 = spectrum_derivatives[38*lanes + lane],
        omega3_by_k3 = spectrum_derivatives[39*lanes + lane],
        omega4_by_m1 = spectrum_derivatives[40*lanes + lane],
        omega4_by_m2 = spectrum_derivatives[41*lanes + lane],
        omega4_by_k1 = spectrum_derivatives[42*lanes + lane],
        omega4_by_k2 = spectrum_derivatives[43*lanes + lane],
        omega4_by_k3 = spectrum_derivatives[44*lanes + lane],
        p4_by_m1 = spectrum_derivatives[45*lanes + lane],
        p4_by_m2 = spectrum_derivatives[46*lanes + lane],
        p4_by_k1 = spectrum_derivatives[47*lanes + lane],
        p4_by_k2 = spectrum_derivatives[48*lanes + lane],
        p4_by_k3 = spectrum_derivatives[49*lanes + lane],
        p5_by_m1 = spectrum_derivatives[50*lanes + lane],
        p5_by_m2 = spectrum_derivatives[51*lanes + lane],
        p5_by_k1 = spectrum_derivatives[52*lanes + lane],
        p5_by_k2 = spectrum_derivatives[53*lanes + lane],
        p5_by_k3 = spectrum_derivatives[54*lanes + lane],
        p6_by_m1 = spectrum_derivatives[55*lanes + lane],
        p6_by_m2 = spectrum_derivatives[56*lanes + lane],
        p6_by_k1 = spectrum_derivatives[57*lanes + lane],
        p6_by_k2 = spectrum_derivatives[58*lanes + lane],
        p6_by_k3 = spectrum_derivatives[59*lanes + lane];
    /* d/dm1 of: functions of half_tau in contact */
    const double t50 = half_tau*omega1_by_m1;
    const double cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t50;
    const double sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t50;
    const double t51 = half_tau*omega2_by_m1;
    const double cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t51;
    const double sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t51;
    /* d/dm2 of: functions of half_tau in contact */
    const double t52 = half_tau*omega1_by_m2;
    const double cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t52;
    const double sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t52;
    const double t53 = half_tau*omega2_by_m2;
    const double cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t53;
    const double sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t53;
    /* d/dk1 of: functions of half_tau in contact */
    const double t54 = half_tau*omega1_by_k1;
    const double cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t54;
    const double sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t54;
    const double t55 = half_tau*omega2_by_k1;
    const double cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t55;
    const double sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t55;
    /* d/dk2 of: functions of half_tau in contact */
    const double t56 = half_tau*omega1_by_k2;
    const double cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t56;
    const double sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t56;
    const double t57 = half_tau*omega2_by_k2;
    const double cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t57;
    const double sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t57;
    /* d/dk3 of: functions of half_tau in contact */
    const double t58 = half_tau*omega1_by_k3;
    const double cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t58;
    const double sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t58;
    const double t59 = half_tau*omega2_by_k3;
    const double cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t59;
    const double sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t59;
    /* d/dm1 of: functions of half_tau1 in free */
    const double t60 = half_tau1*omega3_by_m1;
    const double cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t60;
    const double sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t60;
    const double t61 = half_tau1*omega4_by_m1;
    const double cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t61;
    const double sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t61;
    /* d/dm2 of: functions of half_tau1 in free */
    const double t62 = half_tau1*omega3_by_m2;
    const double cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t62;
    const double sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t62;
    const double t63 = half_tau1*omega4_by_m2;
    const double cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t63;
    const double sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t63;
    /* d/dk1 of: functions of half_tau1 in free */
    const double t64 = half_tau1*omega3_by_k1;
    const double cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t64;
    const double sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t64;
    const double t65 = half_tau1*omega4_by_k1;
    const double cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t65;
    const double sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t65;
    /* d/dk2 of: functions of half_tau1 in free */
    const double t66 = half_tau1*omega3_by_k2;
    const double cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t66;
    const double sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t66;
    const double t67 = half_tau1*omega4_by_k2;
    const double cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t67;
    const double sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t67;
    /* d/dk3 of: functions of half_tau1 in free */
    const double t68 = half_tau1*omega3_by_k3;
    const double cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t68;
    const double sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t68;
    const double t69 = half_tau1*omega4_by_k3;
    const double cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t69;
    const double sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t69;
    /* d/dT of: functions of half_tau1 in free */
    const double cos_omega3_half_tau1_by_T = -cos_omega3_half_tau1_by_tau;
    const double cos_omega4_half_tau1_by_T = -cos_omega4_half_tau1_by_tau;
    /* parameter_jacobian */
    const double t70 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t18*t25 - t20*t25;
    const double t71 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t18*t6 - t20*t6;
    const double t72 = sin_omega2_half_tau*t16;
    const double t73 = t14*t72;
    const double t74 = t14*t17;
    const double t75 = sin_omega1_half_tau*t16;
    const double t76 = t13*t75;
    const double t77 = t13*t19;
    const double t78 = k2*p1;
    const double t79 = k3*p2;
    const double t80 = t79*y;
    const double t81 = k2*y;
    const double t82 = p2*t81;
    const double t83 = t78 - t79 + t80 + t82;
    const double t84 = (1.0/(t15*t15));
    const double t85 = t84*(-k2 - k3);
    const double t86 = omega2*sin_omega2_half_tau;
    const double t87 = t14*t86;
    const double t88 = omega1*sin_omega1_half_tau;
    const double t89 = t13*t88;
    const double t90 = k1*p1;
    const double t91 = k1*p2;
    const double t92 = t91*y;
    const double t93 = t80 + t90 + t92;
    const double t94 = t84*(-k1 - k3);
    const double t95 = t82 - t91 + t92;
    const double t96 = t84*(-k1 - k2);
    const double t97 = t26*t75;
    const double t98 = t19*t26;
    const double t99 = t27*t72;
    const double t100 = t17*t27;
    const double t101 = k2*p3;
    const double t102 = k3*p1;
    const double t103 = -k3*p1*y + k3*y;
    const double t104 = t102*y;
    const double t105 = t78*y;
    const double t106 = t26*t88;
    const double t107 = t27*t86;
    const double t108 = k1*p3;
    const double t109 = k1*y;
    const double t110 = t90*y;
    const double t111 = t105 + t110 - t90;
    const double t112 = -cos_omega3_half_tau1*w + cos_omega4_half_tau1*w + t32*y - t33*y;
    const double t113 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + t32 - t33;
    const double t114 = sin_omega4_half_tau1*t31;
    const double t115 = omega4*t31;
    const double t116 = sin_omega3_half_tau1*t30;
    const double t117 = omega3*t30;
    const double t118 = sin_omega3_half_tau1*t37;
    const double t119 = omega3*t37;
    const double t120 = -sin_omega4_half_tau1*t36;
    const double t121 = -omega4*t36;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = cos_omega1_half_tau_by_m1*t4 + cos_omega2_half_tau_by_m1*t5 - omega1_by_m1*t76 + omega2_by_m1*t73 + p1_by_m1*t71 + p2_by_m1*t70 - sin_omega1_half_tau_by_m1*t77 + sin_omega2_half_tau_by_m1*t74;
        parameter_jacobian[1*lanes + lane] = cos_omega1_half_tau_by_m2*t4 + cos_omega2_half_tau_by_m2*t5 - omega1_by_m2*t76 + omega2_by_m2*t73 + p1_by_m2*t71 + p2_by_m2*t70 - sin_omega1_half_tau_by_m2*t77 + sin_omega2_half_tau_by_m2*t74;
        parameter_jacobian[2*lanes + lane] = cos_omega1_half_tau_by_k1*t4 + cos_omega2_half_tau_by_k1*t5 - omega1_by_k1*t76 + omega2_by_k1*t73 + p1_by_k1*t71 + p2_by_k1*t70 - sin_omega1_half_tau_by_k1*t77 + sin_omega2_half_tau_by_k1*t74 + t18*(-k2 + t83) - t20*t83 + t85*t87 - t85*t89;
        parameter_jacobian[3*lanes + lane] = cos_omega1_half_tau_by_k2*t4 + cos_omega2_half_tau_by_k2*t5 - omega1_by_k2*t76 + omega2_by_k2*t73 + p1_by_k2*t71 + p2_by_k2*t70 - sin_omega1_half_tau_by_k2*t77 + sin_omega2_half_tau_by_k2*t74 + t18*(-k1 + t93) - t20*t93 + t87*t94 - t89*t94;
        parameter_jacobian[4*lanes + lane] = cos_omega1_half_tau_by_k3*t4 + cos_omega2_half_tau_by_k3*t5 - omega1_by_k3*t76 + omega2_by_k3*t73 + p1_by_k3*t71 + p2_by_k3*t70 - sin_omega1_half_tau_by_k3*t77 + sin_omega2_half_tau_by_k3*t74 + t18*t95 - t20*t95 + t87*t96 - t89*t96;
        parameter_jacobian[5*lanes + lane] = 0;
        parameter_jacobian[6*lanes + lane] = cos_omega1_half_tau_by_m1*t22 - cos_omega2_half_tau_by_m1*t21 + omega1_by_m1*t97 - omega2_by_m1*t99 - p1_by_m1*t70 + p3_by_m1*t71 + sin_omega1_half_tau_by_m1*t98 - sin_omega2_half_tau_by_m1*t100;
        parameter_jacobian[7*lanes + lane] = cos_omega1_half_tau_by_m2*t22 - cos_omega2_half_tau_by_m2*t21 + omega1_by_m2*t97 - omega2_by_m2*t99 - p1_by_m2*t70 + p3_by_m2*t71 + sin_omega1_half_tau_by_m2*t98 - sin_omega2_half_tau_by_m2*t100;
        parameter_jacobian[8*lanes + lane] = cos_omega1_half_tau_by_k1*t22 - cos_omega2_half_tau_by_k1*t21 + omega1_by_k1*t97 - omega2_by_k1*t99 - p1_by_k1*t70 + p3_by_k1*t71 + sin_omega1_half_tau_by_k1*t98 - sin_omega2_half_tau_by_k1*t100 + t106*t85 - t107*t85 - t18*(-t101 - t102 + t104 + t105) + t20*(k2*p1*y + k3 - t101 - t102 - t103 - t81);
        parameter_jacobian[9*lanes + lane] = cos_omega1_half_tau_by_k2*t22 - cos_omega2_half_tau_by_k2*t21 + omega1_by_k2*t97 - omega2_by_k2*t99 - p1_by_k2*t70 + p3_by_k2*t71 + sin_omega1_half_tau_by_k2*t98 - sin_omega2_half_tau_by_k2*t100 + t106*t94 - t107*t94 - t18*(t104 - t108 + t110) + t20*(k1*p1*y - t103 - t108 - t109);
        parameter_jacobian[10*lanes + lane] = cos_omega1_half_tau_by_k3*t22 - cos_omega2_half_tau_by_k3*t21 + omega1_by_k3*t97 - omega2_by_k3*t99 - p1_by_k3*t70 + p3_by_k3*t71 + sin_omega1_half_tau_by_k3*t98 - sin_omega2_half_tau_by_k3*t100 + t106*t96 - t107*t96 - t111*t18 + t20*(k1 - t109 + t111 - t81);
        parameter_jacobian[11*lanes + lane] = 0;
        parameter_jacobian[12*lanes + lane] = -cos_omega3_half_tau1_by_m1*t28 + cos_omega4_half_tau1_by_m1*t29 - omega3_by_m1*t116 + omega4_by_m1*t114 + p4_by_m1*t113 + p5_by_m1*t112 - sin_omega3_half_tau1_by_m1*t117 + sin_omega4_half_tau1_by_m1*t115;
        parameter_jacobian[13*lanes + lane] = -cos_omega3_half_tau1_by_m2*t28 + cos_omega4_half_tau1_by_m2*t29 - omega3_by_m2*t116 + omega4_by_m2*t114 + p4_by_m2*t113 + p5_by_m2*t112 - sin_omega3_half_tau1_by_m2*t117 + sin_omega4_half_tau1_by_m2*t115;
        parameter_jacobian[14*lanes + lane] = -cos_omega3_half_tau1_by_k1*t28 + cos_omega4_half_tau1_by_k1*t29 - omega3_by_k1*t116 + omega4_by_k1*t114 + p4_by_k1*t113 + p5_by_k1*t112 - sin_omega3_half_tau1_by_k1*t117 + sin_omega4_half_tau1_by_k1*t115;
        parameter_jacobian[15*lanes + lane] = -cos_omega3_half_tau1_by_k2*t28 + cos_omega4_half_tau1_by_k2*t29 - omega3_by_k2*t116 + omega4_by_k2*t114 + p4_by_k2*t113 + p5_by_k2*t112 - sin_omega3_half_tau1_by_k2*t117 + sin_omega4_half_tau1_by_k2*t115;
        parameter_jacobian[16*lanes + lane] = -cos_omega3_half_tau1_by_k3*t28 + cos_omega4_half_tau1_by_k3*t29 - omega3_by_k3*t116 + omega4_by_k3*t114 + p4_by_k3*t113 + p5_by_k3*t112 - sin_omega3_half_tau1_by_k3*t117 + sin_omega4_half_tau1_by_k3*t115;
        parameter_jacobian[17*lanes + lane] = -cos_omega3_half_tau1_by_T*t28 + cos_omega4_half_tau1_by_T*t29 - sin_omega3_half_tau1_by_T*t117 + sin_omega4_half_tau1_by_T*t115;
        parameter_jacobian[18*lanes + lane] = cos_omega3_half_tau1_by_m1*t35 + cos_omega4_half_tau1_by_m1*t34 + omega3_by_m1*t118 - omega4_by_m1*t120 - p4_by_m1*t112 + p6_by_m1*t113 + sin_omega3_half_tau1_by_m1*t119 - sin_omega4_half_tau1_by_m1*t121;
        parameter_jacobian[19*lanes + lane] = cos_omega3_half_tau1_by_m2*t35 + cos_omega4_half_tau1_by_m2*t34 + omega3_by_m2*t118 - omega4_by_m2*t120 - p4_by_m2*t112 + p6_by_m2*t113 + sin_omega3_half_tau1_by_m2*t119 - sin_omega4_half_tau1_by_m2*t121;
        parameter_jacobian[20*lanes + lane] = cos_omega3_half_tau1_by_k1*t35 + cos_omega4_half_tau1_by_k1*t34 + omega3_by_k1*t118 - omega4_by_k1*t120 - p4_by_k1*t112 + p6_by_k1*t113 + sin_omega3_half_tau1_by_k1*t119 - sin_omega4_half_tau1_by_k1*t121;
        parameter_jacobian[21*lanes + lane] = cos_omega3_half_tau1_by_k2*t35 + cos_omega4_half_tau1_by_k2*t34 + omega3_by_k2*t118 - omega4_by_k2*t120 - p4_by_k2*t112 + p6_by_k2*t113 + sin_omega3_half_tau1_by_k2*t119 - sin_omega4_half_tau1_by_k2*t121;
        parameter_jacobian[22*lanes + lane] = cos_omega3_half_tau1_by_k3*t35 + cos_omega4_half_tau1_by_k3*t34 + omega3_by_k3*t118 - omega4_by_k3*t120 - p4_by_k3*t112 + p6_by_k3*t113 + sin_omega3_half_tau1_by_k3*t119 - sin_omega4_half_tau1_by_k3*t121;
        parameter_jacobian[23*lanes + lane] = cos_omega3_half_tau1_by_T*t35 + cos_omega4_half_tau1_by_T*t34 + sin_omega3_half_tau1_by_T*t119 - sin_omega4_half_tau1_by_T*t121;
    }
}

NONSMOOTH_UNMERGED
void elastic_stop_one_contact_equations(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    elastic_stop_one_contact_equations_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, residual, jacobian, parameter_jacobian);
}

/* Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total by the parameters.
 * Operations: 1654. Intermediate terms: 308. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double m1 = parameters[lane], m2 = parameters[1*lanes + lane],
        k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane],
        k3 = parameters[4*lanes + lane], T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[7*lanes + lane], omega4 = spectrum[8*lanes + lane],
        p4 = spectrum[9*lanes + lane], p5 = spectrum[10*lanes + lane],
        p6 = spectrum[11*lanes + lane];
    const double y = unknowns[lane], u = unknowns[1*lanes + lane], w = unknowns[2*lanes + lane],
        tau = unknowns[3*lanes + lane];
    /* functions of tau in contact */
    const double t0 = omega1*tau;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_tau = wave_0.cosine;
    const double sin_omega1_tau = wave_0.sine;
    const double t1 = omega2*tau;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_tau = wave_1.cosine;
    const double sin_omega2_tau = wave_1.sine;
    /* contact for tau, until first-leaves-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = sin_omega1_tau*t2;
    const double t4 = (1.0/(omega2));
    const double t5 = sin_omega2_tau*t4;
    const double carried_x1_1_by_w = p2*t3 - p2*t5;
    const double t6 = p1 - 1;
    const double carried_x1_1_by_u = p1*t3 - t5*t6;
    const double carried_x1_1_by_y = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t7 = k1*k3;
    const double t8 = k2*k3 + t7;
    const double t9 = k1*k2 + t8;
    const double t10 = (1.0/(t9));
    const double t11 = t10*t8;
    const double t12 = t10*t7;
    const double t13 = p2*t12;
    const double t14 = p1*t11 + t13;
    const double t15 = t11*t6 + t13;
    const double carried_v1_1_by_u = cos_omega1_tau*p1 - cos_omega2_tau*t6;
    const double x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_w*w + carried_x1_1_by_y*y - cos_omega1_tau*t14 + cos_omega2_tau*t15 + t11;
    const double carried_x2_1_by_w = p1*t5 - t3*t6;
    const double carried_x2_1_by_u = p3*t3 - p3*t5;
    const double carried_x2_1_by_y = -cos_omega1_tau*t6 + cos_omega2_tau*p1;
    const double t16 = p3*t11;
    const double t17 = t12*t6 - t16;
    const double t18 = p1*t12;
    const double t19 = -t16 + t18;
    const double carried_v2_1_by_u = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_w*w + carried_x2_1_by_y*y + cos_omega1_tau*t17 - cos_omega2_tau*t19 + t12;
    const double t20 = omega2*sin_omega2_tau;
    const double t21 = omega1*sin_omega1_tau;
    const double carried_v1_1_by_y = p2*t20 - p2*t21;
    const double t22 = omega1*p1;
    const double t23 = omega1*t13 + t11*t22;
    const double t24 = omega2*t10*t6*t8 + omega2*t13;
    const double t25 = -omega2*t6;
    const double v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y + carried_x1_1_by_y*w - sin_omega1_tau*t22 + sin_omega1_tau*t23 - sin_omega2_tau*t24 - sin_omega2_tau*t25;
    const double carried_v2_1_by_y = -p1*t20 + t21*t6;
    const double t26 = omega1*p3;
    const double t27 = -t12*t6;
    const double t28 = omega1*t27 + t11*t26;
    const double t29 = omega2*p3;
    const double t30 = omega2*t18 - t11*t29;
    const double v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + carried_x2_1_by_y*w - sin_omega1_tau*t26 + sin_omega1_tau*t28 + sin_omega2_tau*t29 + sin_omega2_tau*t30;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t31 = omega3*tau1;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t31);
    const double cos_omega3_tau1 = wave_2.cosine;
    const double sin_omega3_tau1 = wave_2.sine;
    const double t32 = omega4*tau1;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t32);
    const double cos_omega4_tau1 = wave_3.cosine;
    const double sin_omega4_tau1 = wave_3.sine;
    /* free for tau1, until first-reaches-stop */
    const double t33 = 1 - p4;
    const double t34 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33;
    const double t35 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double t36 = (1.0/(omega3));
    const double t37 = sin_omega3_tau1*t36;
    const double t38 = (1.0/(omega4));
    const double t39 = sin_omega4_tau1*t38;
    const double t40 = p4*t37 + t33*t39;
    const double t41 = p5*t37 - p5*t39;
    const double x1_2 = t34*x1_1 + t35*x2_1 + t40*v1_1 + t41*v2_1;
    const double t42 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t43 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4;
    const double t44 = p6*t37 - p6*t39;
    const double t45 = p4*t39 + t33*t37;
    const double x2_2 = t42*x1_1 + t43*x2_1 + t44*v1_1 + t45*v2_1;
    const double t46 = omega3*sin_omega3_tau1;
    const double t47 = omega4*sin_omega4_tau1;
    const double t48 = p4*t46 + t33*t47;
    const double t49 = -p5*t46 + p5*t47;
    const double v1_2 = t34*v1_1 + t35*v2_1 - t48*x1_1 + t49*x2_1;
    const double t50 = -p6*t46 + p6*t47;
    const double t51 = p4*t47 + t33*t46;
    const double v2_2 = t42*v1_1 + t43*v2_1 + t50*x1_1 - t51*x2_1;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t52 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t52;
    const double delay_tau_by_u = carried_x1_1_by_u*t52;
    const double delay_tau_by_w = carried_x1_1_by_w*t52;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t53 = (1.0/(m1));
    const double t54 = k1 + k3;
    const double t55 = t53*x1_1;
    const double t56 = k1*t53*x2_1 + k3*t53 - t54*t55;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t56;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t56;
    const double v1_1_on_boundary_by_w = carried_x1_1_by_y + delay_tau_by_w*t56;
    const double t57 = (1.0/(m2));
    const double t58 = t57*x1_1;
    const double t59 = k1 + k2;
    const double t60 = t57*x2_1;
    const double t61 = k1*t58 - t59*t60;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t61;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t61;
    const double v2_1_on_boundary_by_w = carried_x2_1_by_y + delay_tau_by_w*t61;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t34*x1_1_on_boundary_by_y + t35*x2_1_on_boundary_by_y + t40*v1_1_on_boundary_by_y + t41*v2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t34*x1_1_on_boundary_by_u + t35*x2_1_on_boundary_by_u + t40*v1_1_on_boundary_by_u + t41*v2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t34*x1_1_on_boundary_by_w + t35*x2_1_on_boundary_by_w + t40*v1_1_on_boundary_by_w + t41*v2_1_on_boundary_by_w;
    const double carried_x2_2_by_y = t42*x1_1_on_boundary_by_y + t43*x2_1_on_boundary_by_y + t44*v1_1_on_boundary_by_y + t45*v2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t34*v1_1_on_boundary_by_u + t35*v2_1_on_boundary_by_u - t48*x1_1_on_boundary_by_u + t49*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t42*v1_1_on_boundary_by_w + t43*v2_1_on_boundary_by_w + t50*x1_1_on_boundary_by_w - t51*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t62 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t62;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t62;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t62;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double t63 = t53*x1_2;
    const double slope_by_delay_tau1_by_u = k1*t53*x2_2 - k1*t63;
    const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*slope_by_delay_tau1_by_u;
    const double t64 = t57*x1_2;
    const double t65 = t57*x2_2;
    const double slope_by_delay_tau1_by_w = k1*t64 - t59*t65;
    const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*slope_by_delay_tau1_by_w;
    if (trace) {
        trace[lane] = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_m1 = spectrum_derivatives[5*lanes + lane],
        omega1_by_m2 = spectrum_derivatives[6*lanes + lane],
        omega1_by_k1 = spectrum_derivatives[7*lanes + lane],
        omega1_by_k2 = spectrum_derivatives[8*lanes + lane],
        omega1_by_k3 = spectrum_derivatives[9*lanes + lane],
        omega2_by_m1 = spectrum_derivatives[10*lanes + lane],
        omega2_by_m2 = spectrum_derivatives[11*lanes + lane],
        omega2_by_k1 = spectrum_derivatives[12*lanes + lane],
        omega2_by_k2 = spectrum_derivatives[13*lanes + lane],
        omega2_by_k3 = spectrum_derivatives[14*lanes + lane],
        p1_by_m1 = spectrum_derivatives[15*lanes + lane],
        p1_by_m2 = spectrum_derivatives[16*lanes + lane],
        p1_by_k1 = spectrum_derivatives[17*lanes + lane],
        p1_by_k2 = spectrum_derivatives[18*lanes + lane],
        p1_by_k3 = spectrum_derivatives[19*lanes + lane],
        p2_by_m1 = spectrum_derivatives[20*lanes + lane],
        p2_by_m2 = spectrum_derivatives[21*lanes + lane],
        p2_by_k1 = spectrum_derivatives[22*lanes + lane],
        p2_by_k2 = spectrum_derivatives[23*lanes + lane],
        p2_by_k3 = spectrum_derivatives[24*lanes + lane],
        p3_by_m1 = spectrum_derivatives[25*lanes + lane],
        p3_by_m2 = spectrum_derivatives[26*lanes + lane],
        p3_by_k1 = spectrum_derivatives[27*lanes + lane],
        p3_by_k2 = spectrum_derivatives[28*lanes + lane],
        p3_by_k3 = spectrum_derivatives[29*lanes + lane],
        omega3_by_m1 = spectrum_derivatives[35*lanes + lane],
        omega3_by_m2 = spectrum_derivatives[36*lanes + lane],
        omega3_by_k1 = spectrum_derivatives[37*lanes + lane],
        omega3_by_k2 = spectrum_derivatives[38*lanes + lane],
        omega3_by_k3 = spectrum_derivatives[39*lanes + lane],
        omega4_by_m1 = spectrum_derivatives[40*lanes + lane],
        omega4_by_m2 = spectrum_derivatives[41*lanes + lane],
        omega4_by_k1 = spectrum_derivatives[42*lanes + lane],
        omega4_by_k2 = spectrum_derivatives[43*lanes + lane],
        omega4_by_k3 = spectrum_derivatives[44*lanes + lane],
        p4_by_m1 = spectrum_derivatives[45*lanes + lane],
        p4_by_m2 = spectrum_derivatives[46*lanes + lane],
        p4_by_k1 = spectrum_derivatives[47*lanes + lane],
        p4_by_k2 = spectrum_derivatives[48*lanes + lane],
        p4_by_k3 = spectrum_derivatives[49*lanes + lane],
        p5_by_m1 = spectrum_derivatives[50*lanes + lane],
        p5_by_m2 = spectrum_derivatives[51*lanes + lane],
        p5_by_k1 = spectrum_derivatives[52*lanes + lane],
        p5_by_k2 = spectrum_derivatives[53*lanes + lane],
        p5_by_k3 = spectrum_derivatives[54*lanes + lane],
        p6_by_m1 = spectrum_derivatives[55*lanes + lane],
        p6_by_m2 = spectrum_derivatives[56*lanes + lane],
        p6_by_k1 = spectrum_derivatives[57*lanes + lane],
        p6_by_k2 = spectrum_derivatives[58*lanes + lane],
        p6_by_k3 = spectrum_derivatives[59*lanes + lane];
    /* back through: Phi along tau1 */
    const double slope_by_carried_x1_2_by_w = -slope_by_delay_tau1_by_w*t62;
    const double slope_by_carried_x1_2_by_u = -slope_by_delay_tau1_by_u*t62;
    const double slope_by_carried_x1_2_by_y = -t62*v2_2;
    /* back through: perturbation on the boundary after tau */
    const double slope_by_v2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t41 + t43;
    const double slope_by_v2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t41 + t35;
    const double slope_by_v2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t41 + t45;
    const double slope_by_v1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t40 + t42;
    const double slope_by_v1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t40 + t34;
    const double slope_by_v1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t40 + t44;
    const double slope_by_x2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t35 - t51;
    const double slope_by_x2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t35 + t49;
    const double slope_by_x2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t35 + t43;
    const double slope_by_x1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t34 + t50;
    const double slope_by_x1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t34 - t48;
    const double slope_by_x1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t34 + t42;
    /* back through: derivatives of the time to the boundary after tau */
    const double slope_by_delay_tau_by_w = slope_by_v1_1_on_boundary_by_w*t56 + slope_by_v2_1_on_boundary_by_w*t61 + slope_by_x1_1_on_boundary_by_w*v1_1 + slope_by_x2_1_on_boundary_by_w*v2_1;
    const double slope_by_delay_tau_by_u = slope_by_v1_1_on_boundary_by_u*t56 + slope_by_v2_1_on_boundary_by_u*t61 + slope_by_x1_1_on_boundary_by_u*v1_1 + slope_by_x2_1_on_boundary_by_u*v2_1;
    const double slope_by_delay_tau_by_y = slope_by_v1_1_on_boundary_by_y*t56 + slope_by_v2_1_on_boundary_by_y*t61 + slope_by_x1_1_on_boundary_by_y*v1_1 + slope_by_x2_1_on_boundary_by_y*v2_1;
    /* back through: rate of the exit boundary after tau */
    const double t66 = (1.0/(rate_1*rate_1));
    const double slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t66 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t66 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t66;
    /* back through: Phi along tau */
    const double slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t52 + slope_by_x1_1_on_boundary_by_w;
    const double slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t52 + slope_by_x1_1_on_boundary_by_u;
    const double slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t52 + slope_by_x1_1_on_boundary_by_y;
    /* back through: free for tau1, until first-reaches-stop */
    const double t67 = (1.0/(v1_2*v1_2));
    const double slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t67 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t67 + carried_x1_2_by_y*t67*v2_2;
    const double t68 = k1*t53;
    const double t69 = delay_tau1_by_u*t68;
    const double slope_by_x2_2 = -delay_tau1_by_w*t57*t59 + t69;
    const double slope_by_x1_2 = delay_tau1_by_w*k1*t57 - t69;
    /* back through: functions of tau1 in free */
    const double t70 = p6*x1_1;
    const double t71 = p4*x2_1;
    const double t72 = p5*t38;
    const double t73 = p5*v2_1_on_boundary_by_u;
    const double t74 = p5*x2_1;
    const double t75 = t33*x1_1;
    const double t76 = p6*v1_1;
    const double t77 = p5*v2_1;
    const double t78 = p6*x1_1_on_boundary_by_w;
    const double t79 = p5*x2_1_on_boundary_by_u;
    const double t80 = p4*v2_1_on_boundary_by_y;
    const double t81 = p6*v1_1_on_boundary_by_y;
    const double t82 = p4*x2_1_on_boundary_by_w;
    const double t83 = t33*x1_1_on_boundary_by_u;
    const double slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*t70 - omega4*t71) + omega4*t78 + omega4*t79 - omega4*t82 - omega4*t83 + slope_by_carried_x1_2_by_u*(t33*t38*v1_1_on_boundary_by_u - t38*t73) + slope_by_carried_x1_2_by_w*(t33*t38*v1_1_on_boundary_by_w - t72*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t33*t38*v1_1_on_boundary_by_y - t72*v2_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t74 - omega4*t75) + slope_by_x1_2*(t33*t38*v1_1 - t38*t77) + slope_by_x2_2*(p4*t38*v2_1 - t38*t76) + t38*t80 - t38*t81;
    const double t84 = t33*v1_1_on_boundary_by_u;
    const double t85 = p5*x2_1_on_boundary_by_w;
    const double t86 = p5*x2_1_on_boundary_by_y;
    const double t87 = p6*x1_1_on_boundary_by_y;
    const double t88 = p6*v1_1_on_boundary_by_w;
    const double slope_by_cos_omega4_tau1 = delay_tau1_by_y*(p4*v2_1 - t76) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(t33*x1_1_on_boundary_by_u - t79) + slope_by_carried_x1_2_by_w*(t33*x1_1_on_boundary_by_w - t85) + slope_by_carried_x1_2_by_y*(t33*x1_1_on_boundary_by_y - t86) + slope_by_v1_2*(t33*v1_1 - t77) + slope_by_x1_2*(t33*x1_1 - t74) + slope_by_x2_2*(p4*x2_1 - t70) - t73 + t84 - t87 - t88;
    const double t89 = t33*x2_1;
    const double t90 = p5*t36;
    const double t91 = p4*t36;
    const double t92 = p4*v1_1_on_boundary_by_u;
    const double t93 = p4*x1_1;
    const double t94 = t33*v2_1;
    const double t95 = p4*v1_1;
    const double t96 = t33*v2_1_on_boundary_by_y;
    const double t97 = p4*x1_1_on_boundary_by_u;
    const double t98 = t33*x2_1_on_boundary_by_w;
    const double slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t70 - omega3*t89) - omega3*t78 - omega3*t79 - omega3*t97 - omega3*t98 + slope_by_carried_x1_2_by_u*(t36*t73 + t36*t92) + slope_by_carried_x1_2_by_w*(t90*v2_1_on_boundary_by_w + t91*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t90*v2_1_on_boundary_by_y + t91*v1_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t74 - omega3*t93) + slope_by_x1_2*(t36*t77 + t36*t95) + slope_by_x2_2*(t36*t76 + t36*t94) + t36*t81 + t36*t96;
    const double slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t76 + t94) + slope_by_carried_x1_2_by_u*(t79 + t97) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t85) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t86) + slope_by_v1_2*(t77 + t95) + slope_by_x1_2*(t74 + t93) + slope_by_x2_2*(t70 + t89) + t33*v2_1_on_boundary_by_w + t33*x2_1_on_boundary_by_y + t73 + t87 + t88 + t92;
    /* back through: tau1 completes the period */
    const double t99 = cos_omega4_tau1*slope_by_sin_omega4_tau1;
    const double t100 = cos_omega3_tau1*slope_by_sin_omega3_tau1;
    const double t101 = sin_omega4_tau1*slope_by_cos_omega4_tau1;
    const double t102 = sin_omega3_tau1*slope_by_cos_omega3_tau1;
    const double slope_by_tau1 = omega3*t100 - omega3*t102 - omega4*t101 + omega4*t99;
    /* back through: contact for tau, until first-leaves-stop */
    const double slope_by_v2_1 = delay_tau1_by_y*t43 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t35 + slope_by_x1_2*t41 + slope_by_x2_2*t45;
    const double slope_by_v1_1 = delay_tau1_by_y*t42 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t34 + slope_by_x1_2*t40 + slope_by_x2_2*t44;
    const double t103 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y;
    const double t104 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u;
    const double t105 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w;
    const double t106 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y;
    const double t107 = t57*t59;
    const double t108 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u;
    const double t109 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w;
    const double slope_by_x2_1 = -delay_tau1_by_y*t51 + slope_by_v1_2*t49 + slope_by_x1_2*t35 + slope_by_x2_2*t43 + t103*t68 + t104*t68 + t105*t68 - t106*t107 - t107*t108 - t107*t109;
    const double t110 = k1*t57;
    const double t111 = t53*t54;
    const double slope_by_x1_1 = delay_tau1_by_y*t50 - slope_by_v1_2*t48 + slope_by_x1_2*t34 + slope_by_x2_2*t42 - t103*t111 - t104*t111 - t105*t111 + t106*t110 + t108*t110 + t109*t110;
    /* back through: functions of tau in contact */
    const double t112 = p1*y;
    const double t113 = p3*u;
    const double t114 = p2*w;
    const double t115 = p2*slope_by_v1_1_on_boundary_by_y;
    const double t116 = p1*slope_by_x2_1_on_boundary_by_w;
    const double t117 = p3*slope_by_x2_1_on_boundary_by_u;
    const double t118 = p2*slope_by_carried_x1_1_by_w;
    const double t119 = p1*slope_by_v2_1_on_boundary_by_y;
    const double slope_by_sin_omega2_tau = omega2*t115 - omega2*t119 - slope_by_carried_x1_1_by_u*t4*t6 + slope_by_v1_1*(omega2*p2*y - t24 - t25) + slope_by_v2_1*(-omega2*t112 + t29 + t30) + slope_by_x1_1*(-t114*t4 - t4*t6*u) + slope_by_x2_1*(p1*t4*w - t113*t4) + t116*t4 - t117*t4 - t118*t4;
    const double t120 = p2*y;
    const double t121 = -p1 - t120;
    const double t122 = p3*slope_by_v2_1_on_boundary_by_u;
    const double t123 = p2*slope_by_v1_1_on_boundary_by_w;
    const double t124 = p2*slope_by_carried_x1_1_by_y;
    const double slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t114 - t6*u) - slope_by_v1_1_on_boundary_by_u*t6 + slope_by_v2_1*(p1*w - t113) + slope_by_x1_1*(t121 + t15 + 1) + slope_by_x2_1*(p1*y - p3 - t19) - t122 - t123 - t124;
    const double t125 = -t6*y;
    const double t126 = -t6*w;
    const double t127 = p1*u;
    const double t128 = -slope_by_x2_1_on_boundary_by_w*t6;
    const double t129 = -slope_by_v2_1_on_boundary_by_y*t6;
    const double slope_by_sin_omega1_tau = -omega1*t115 - omega1*t129 + p1*slope_by_carried_x1_1_by_u*t2 + slope_by_v1_1*(-omega1*t120 - t22 + t23) + slope_by_v2_1*(-omega1*t125 - t26 + t28) + slope_by_x1_1*(t114*t2 + t127*t2) + slope_by_x2_1*(t113*t2 + t126*t2) + t117*t2 + t118*t2 + t128*t2;
    const double slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t114 + t127) + slope_by_v2_1*(t113 + t126) - slope_by_v2_1_on_boundary_by_w*t6 + slope_by_x1_1*(-t121 - t14) + slope_by_x2_1*(p3 + t125 + t17) - slope_by_x2_1_on_boundary_by_y*t6 + t122 + t123 + t124;
    /* trace_gradient */
    const double t130 = sin_omega2_tau*slope_by_cos_omega2_tau;
    const double t131 = sin_omega1_tau*slope_by_cos_omega1_tau;
    const double t132 = -t46 + t47;
    const double t133 = cos_omega3_tau1 - cos_omega4_tau1;
    const double t134 = t132*x1_1 + t133*v1_1;
    const double t135 = t37 - t39;
    const double t136 = t133*x1_1 + t135*v1_1;
    const double t137 = t133*x1_1_on_boundary_by_y + t135*v1_1_on_boundary_by_y;
    const double t138 = delay_tau1_by_y*t134 + slope_by_x2_2*t136 + t132*x1_1_on_boundary_by_w + t133*v1_1_on_boundary_by_w + t137;
    const double t139 = slope_by_carried_x1_2_by_u*(t133*x2_1_on_boundary_by_u + t135*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t133*x2_1_on_boundary_by_w + t135*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t133*x2_1_on_boundary_by_y + t135*v2_1_on_boundary_by_y) + slope_by_v1_2*(t132*x2_1 + t133*v2_1) + slope_by_x1_2*(t133*x2_1 + t135*v2_1) + t132*x2_1_on_boundary_by_u + t133*v2_1_on_boundary_by_u;
    const double t140 = delay_tau1_by_y*(-t132*x2_1 - t133*v2_1) + slope_by_carried_x1_2_by_u*(t133*x1_1_on_boundary_by_u + t135*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t133*x1_1_on_boundary_by_w + t135*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t137 + slope_by_v1_2*t134 + slope_by_x1_2*t136 + slope_by_x2_2*(-t133*x2_1 - t135*v2_1) + t132*x1_1_on_boundary_by_u - t132*x2_1_on_boundary_by_w + t133*v1_1_on_boundary_by_u - t133*v2_1_on_boundary_by_w - t133*x2_1_on_boundary_by_y - t135*v2_1_on_boundary_by_y;
    const double t141 = sin_omega4_tau1/(omega4*omega4);
    const double t142 = p5*v2_1_on_boundary_by_w;
    const double t143 = t141*t33;
    const double t144 = p5*v2_1_on_boundary_by_y;
    const double t145 = delay_tau1_by_y*(sin_omega4_tau1*t70 - sin_omega4_tau1*t71) + sin_omega4_tau1*t78 + sin_omega4_tau1*t79 - sin_omega4_tau1*t82 - sin_omega4_tau1*t83 + slope_by_carried_x1_2_by_u*(t141*t73 - t141*t84) + slope_by_carried_x1_2_by_w*(t141*t142 - t143*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t141*t144 - t143*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t74 - sin_omega4_tau1*t75) + slope_by_x1_2*(-t141*t33*v1_1 + t141*t77) + slope_by_x2_2*(-p4*t141*v2_1 + t141*t76) - t101*tau1 - t141*t80 + t141*t81 + t99*tau1;
    const double t146 = sin_omega3_tau1/(omega3*omega3);
    const double t147 = p4*t146;
    const double t148 = delay_tau1_by_y*(-sin_omega3_tau1*t70 - sin_omega3_tau1*t89) - sin_omega3_tau1*t78 - sin_omega3_tau1*t79 - sin_omega3_tau1*t97 - sin_omega3_tau1*t98 + slope_by_carried_x1_2_by_u*(-t146*t73 - t146*t92) + slope_by_carried_x1_2_by_w*(-t142*t146 - t147*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t144*t146 - t147*v1_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t74 - sin_omega3_tau1*t93) + slope_by_x1_2*(-t146*t77 - t146*t95) + slope_by_x2_2*(-t146*t76 - t146*t94) + t100*tau1 - t102*tau1 - t146*t81 - t146*t96;
    const double t149 = cos_omega1_tau - cos_omega2_tau;
    const double t150 = t3 - t5;
    const double t151 = t20 - t21;
    const double t152 = -t11*t20 + t11*t21 + t149*u + t151;
    const double t153 = -cos_omega1_tau*t11 + cos_omega2_tau*t11 + t149 + t150*u;
    const double t154 = slope_by_v2_1*t152 + slope_by_v2_1_on_boundary_by_u*t149 + slope_by_x2_1*t153 + slope_by_x2_1_on_boundary_by_u*t150;
    const double t155 = t12*t21;
    const double t156 = t12*t20;
    const double t157 = cos_omega2_tau*t12;
    const double t158 = cos_omega1_tau*t12;
    const double t159 = slope_by_carried_x1_1_by_w*t150 + slope_by_carried_x1_1_by_y*t149 + slope_by_v1_1*(t149*w + t151*y + t155 - t156) + slope_by_v1_1_on_boundary_by_w*t149 + slope_by_v1_1_on_boundary_by_y*t151 + slope_by_x1_1*(t149*y + t150*w + t157 - t158);
    const double t160 = slope_by_carried_x1_1_by_u*t150 + slope_by_v1_1*t152 + slope_by_v1_1_on_boundary_by_u*t149 + slope_by_v2_1*(-t149*w - t151*y - t155 + t156) - slope_by_v2_1_on_boundary_by_w*t149 - slope_by_v2_1_on_boundary_by_y*t151 + slope_by_x1_1*t153 + slope_by_x2_1*(-t149*y - t150*w - t157 + t158) - slope_by_x2_1_on_boundary_by_w*t150 - slope_by_x2_1_on_boundary_by_y*t149;
    const double t161 = p3*sin_omega2_tau;
    const double t162 = -sin_omega2_tau*t6;
    const double t163 = (1.0/(omega2*omega2));
    const double t164 = sin_omega2_tau*t163;
    const double t165 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t115 - sin_omega2_tau*t119 - slope_by_carried_x1_1_by_u*t162*t163 + slope_by_v1_1*(sin_omega2_tau*t120 + sin_omega2_tau*(-t10*t6*t8 - t13) - t162) + slope_by_v2_1*(-sin_omega2_tau*t112 + sin_omega2_tau*t19 + t161) + slope_by_x1_1*(t114*t164 + t164*t6*u) + slope_by_x2_1*(-p1*t164*w + t113*t164) + slope_by_x2_1_on_boundary_by_u*t161*t163 - t116*t164 + t118*t164 - t130*tau;
    const double t166 = p3*sin_omega1_tau;
    const double t167 = p1*sin_omega1_tau;
    const double t168 = (1.0/(omega1*omega1));
    const double t169 = sin_omega1_tau*t168;
    const double t170 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t115 - sin_omega1_tau*t129 - slope_by_carried_x1_1_by_u*t167*t168 + slope_by_v1_1*(-sin_omega1_tau*t120 + sin_omega1_tau*t14 - t167) + slope_by_v2_1*(-sin_omega1_tau*t125 + sin_omega1_tau*(t16 + t27) - t166) + slope_by_x1_1*(-t114*t169 - t127*t169) + slope_by_x2_1*(-t113*t169 - t126*t169) - slope_by_x2_1_on_boundary_by_u*t166*t168 - t118*t169 - t128*t169 - t131*tau;
    const double t171 = (1.0/(m1*m1));
    const double t172 = k1*t171;
    const double t173 = -k3*t171 + t171*t54*x1_1 - t172*x2_1;
    const double t174 = (1.0/(m2*m2));
    const double t175 = k1*t174;
    const double t176 = t174*t59*x2_1 - t175*x1_1;
    const double t177 = k3*t10;
    const double t178 = t177*t26;
    const double t179 = -omega1*t6;
    const double t180 = -k2 - k3;
    const double t181 = (1.0/(t9*t9));
    const double t182 = t181*t8;
    const double t183 = t180*t182;
    const double t184 = t181*t7;
    const double t185 = t180*t184;
    const double t186 = p1*t177;
    const double t187 = t177*t29;
    const double t188 = p1*t185;
    const double t189 = p2*t177;
    const double t190 = t177*t22;
    const double t191 = p2*t185;
    const double t192 = t177*t6;
    const double t193 = p3*t177;
    const double t194 = -p3*t183 - t193;
    const double t195 = t189 + t191;
    const double t196 = t58 - t60;
    const double t197 = t53*x2_1 - t55;
    const double t198 = -t182*t54;
    const double t199 = -t184*t54;
    const double t200 = p2*t199;
    const double t201 = p3*t198 + t193;
    const double t202 = t10*t59;
    const double t203 = k1*t10;
    const double t204 = -t182*t59;
    const double t205 = -t184*t59;
    const double t206 = p1*t203;
    const double t207 = p1*t205;
    const double t208 = p2*t203;
    const double t209 = p2*t205;
    const double t210 = -p3*t202 - p3*t204;
    const double t211 = t208 + t209;
    const double t212 = t53 - t55;
    if (trace_gradient) {
        trace_gradient[lane] = carried_v1_1_by_y*slope_by_v1_1 + carried_v2_1_by_y*slope_by_v2_1 + carried_x1_1_by_y*slope_by_x1_1 + carried_x2_1_by_y*slope_by_x2_1;
        trace_gradient[1*lanes + lane] = carried_v1_1_by_u*slope_by_v1_1 + carried_v2_1_by_u*slope_by_v2_1 + carried_x1_1_by_u*slope_by_x1_1 + carried_x2_1_by_u*slope_by_x2_1;
        trace_gradient[2*lanes + lane] = carried_x1_1_by_w*slope_by_x1_1 + carried_x1_1_by_y*slope_by_v1_1 + carried_x2_1_by_w*slope_by_x2_1 + carried_x2_1_by_y*slope_by_v2_1;
        trace_gradient[3*lanes + lane] = cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t131 - omega2*t130 - slope_by_tau1;
        trace_gradient[4*lanes + lane] = delay_tau1_by_u*(t172*x1_2 - t172*x2_2) + omega1_by_m1*t170 + omega2_by_m1*t165 + omega3_by_m1*t148 + omega4_by_m1*t145 + p1_by_m1*t160 + p2_by_m1*t159 + p3_by_m1*t154 + p4_by_m1*t140 + p5_by_m1*t139 + p6_by_m1*t138 + t103*t173 + t104*t173 + t105*t173;
        trace_gradient[5*lanes + lane] = delay_tau1_by_w*(t174*t59*x2_2 - t175*x1_2) + omega1_by_m2*t170 + omega2_by_m2*t165 + omega3_by_m2*t148 + omega4_by_m2*t145 + p1_by_m2*t160 + p2_by_m2*t159 + p3_by_m2*t154 + p4_by_m2*t140 + p5_by_m2*t139 + p6_by_m2*t138 + t106*t176 + t108*t176 + t109*t176;
        trace_gradient[6*lanes + lane] = delay_tau1_by_u*(t53*x2_2 - t63) + delay_tau1_by_w*(t64 - t65) + omega1_by_k1*t170 + omega2_by_k1*t165 + omega3_by_k1*t148 + omega4_by_k1*t145 + p1_by_k1*t160 + p2_by_k1*t159 + p3_by_k1*t154 + p4_by_k1*t140 + p5_by_k1*t139 + p6_by_k1*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t189 + omega1*t191 + t183*t22 + t190) + sin_omega2_tau*(-k3*omega2*t10*t6 - omega2*t180*t181*t6*t8 - omega2*t189 - omega2*t191)) + slope_by_v2_1*(sin_omega1_tau*(t177*t179 + t178 + t179*t185 + t183*t26) + sin_omega2_tau*(omega2*t186 + omega2*t188 - t183*t29 - t187)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t183 - t186 - t195) + cos_omega2_tau*(t183*t6 + t192 + t195) + t177 + t183) + slope_by_x2_1*(cos_omega1_tau*(t185*t6 + t192 + t194) + cos_omega2_tau*(-t186 - t188 - t194) + t177 + t185) + t103*t197 + t104*t197 + t105*t197 + t106*t196 + t108*t196 + t109*t196;
        trace_gradient[7*lanes + lane] = -delay_tau1_by_w*t65 + omega1_by_k2*t170 + omega2_by_k2*t165 + omega3_by_k2*t148 + omega4_by_k2*t145 + p1_by_k2*t160 + p2_by_k2*t159 + p3_by_k2*t154 + p4_by_k2*t140 + p5_by_k2*t139 + p6_by_k2*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t200 + t190 + t198*t22) + sin_omega2_tau*(-omega2*t200 + t177*t25 + t198*t25)) + slope_by_v2_1*(sin_omega1_tau*(t178 + t179*t199 + t198*t26) + sin_omega2_tau*(-k1*k3*omega2*p1*t181*t54 - t187 - t198*t29)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t198 - t186 - t200) + cos_omega2_tau*(t192 + t198*t6 + t200) + t177 + t198) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t181*t54*t6 - t201) + cos_omega2_tau*(-p1*t199 + t201) + t199) - t106*t60 - t108*t60 - t109*t60;
        trace_gradient[8*lanes + lane] = omega1_by_k3*t170 + omega2_by_k3*t165 + omega3_by_k3*t148 + omega4_by_k3*t145 + p1_by_k3*t160 + p2_by_k3*t159 + p3_by_k3*t154 + p4_by_k3*t140 + p5_by_k3*t139 + p6_by_k3*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t208 + omega1*t209 + t202*t22 + t204*t22) + sin_omega2_tau*(-omega2*t10*t59*t6 + omega2*t181*t59*t6*t8 - omega2*t208 - omega2*t209)) + slope_by_v2_1*(sin_omega1_tau*(t179*t203 + t179*t205 + t202*t26 + t204*t26) + sin_omega2_tau*(omega2*t206 + omega2*t207 - t202*t29 - t204*t29)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t202 - p1*t204 - t211) + cos_omega2_tau*(t202*t6 + t204*t6 + t211) + t202 + t204) + slope_by_x2_1*(cos_omega1_tau*(t203*t6 + t205*t6 + t210) + cos_omega2_tau*(-t206 - t207 - t210) + t203 + t205) + t103*t212 + t104*t212 + t105*t212;
        trace_gradient[9*lanes + lane] = slope_by_tau1;
    }
}

NONSMOOTH_UNMERGED
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    elastic_stop_one_contact_trace_in_lane(1, 0, parameters, spectrum, unknowns,
        spectrum_derivatives, trace, trace_gradient);
}

/* State at the start and behind each transition. Boundaries along the phases: constant, slope, cosine and sine amplitudes, one after the other; and the frequencies of each phase.
 * Operations: 238. Intermediate terms: 58. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_passage(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *states,
    double *coefficients, double *frequencies)
{
    const double k1 = parameters[2], k2 = parameters[3], k3 = parameters[4], T = parameters[5];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[7], omega4 = spectrum[8], p4 = spectrum[9],
        p5 = spectrum[10], p6 = spectrum[11];
    const double y = unknowns[0], u = unknowns[1], w = unknowns[2], tau = unknowns[3];
    /* functions of tau in contact */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* contact for tau, until first-leaves-stop */
    const double t2 = k1*k3;
    const double t3 = k2*k3 + t2;
    const double t4 = (1.0/((k1*k2 + t3)));
    const double t5 = t3*t4;
    const double t6 = (1.0/(omega1));
    const double t7 = sin_omega1_tau*t6;
    const double t8 = (1.0/(omega2));
    const double t9 = sin_omega2_tau*t8;
    const double t10 = p1 - 1;
    const double t11 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t12 = p1*t5;
    const double t13 = t2*t4;
    const double t14 = p2*t13;
    const double t15 = t12 + t14;
    const double t16 = t10*t5 + t14;
    const double t17 = cos_omega1_tau*p1 - cos_omega2_tau*t10;
    const double x1_1 = -cos_omega1_tau*t15 + cos_omega2_tau*t16 + t11*y + t17 + t5 + u*(p1*t7 - t10*t9) + w*(p2*t7 - p2*t9);
    const double t18 = -cos_omega1_tau*t10 + cos_omega2_tau*p1;
    const double t19 = p3*t5;
    const double t20 = p1*t13;
    const double t21 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(t10*t13 - t19) + cos_omega2_tau*(t19 - t20) + t13 + t18*y + t21 + u*(p3*t7 - p3*t9) + w*(p1*t9 - t10*t7);
    const double t22 = omega2*sin_omega2_tau;
    const double t23 = omega1*sin_omega1_tau;
    const double v1_1 = -p1*t23 + sin_omega1_tau*(omega1*t12 + omega1*t14) + sin_omega2_tau*(-omega2*t10*t3*t4 - omega2*t14) + t10*t22 + t11*w + t17*u + y*(p2*t22 - p2*t23);
    const double v2_1 = p3*t22 - p3*t23 + sin_omega1_tau*(-omega1*t10*t13 + omega1*t19) + sin_omega2_tau*(-omega2*t19 + omega2*t20) + t18*w + t21*u + y*(-p1*t22 + t10*t23);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t24 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t24);
    const double sin_omega3_tau1 = sin(t24);
    const double t25 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t25);
    const double sin_omega4_tau1 = sin(t25);
    /* free for tau1, until first-reaches-stop */
    const double t26 = 1 - p4;
    const double t27 = cos_omega3_tau1*p4 + cos_omega4_tau1*t26;
    const double t28 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double t29 = (1.0/(omega3));
    const double t30 = sin_omega3_tau1*t29;
    const double t31 = (1.0/(omega4));
    const double t32 = sin_omega4_tau1*t31;
    const double x1_2 = t27*x1_1 + t28*x2_1 + v1_1*(p4*t30 + t26*t32) + v2_1*(p5*t30 - p5*t32);
    const double t33 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t34 = cos_omega3_tau1*t26 + cos_omega4_tau1*p4;
    const double x2_2 = t33*x1_1 + t34*x2_1 + v1_1*(p6*t30 - p6*t32) + v2_1*(p4*t32 + t26*t30);
    const double t35 = omega3*sin_omega3_tau1;
    const double t36 = omega4*sin_omega4_tau1;
    const double v1_2 = t27*v1_1 + t28*v2_1 + x1_1*(-p4*t35 - t26*t36) + x2_1*(-p5*t35 + p5*t36);
    const double v2_2 = t33*v1_1 + t34*v2_1 + x1_1*(-p6*t35 + p6*t36) + x2_1*(-p4*t36 - t26*t35);
    if (states) {
        states[0] = 1;
        states[1] = y;
        states[2] = u;
        states[3] = w;
        states[4] = x1_1;
        states[5] = x2_1;
        states[6] = v1_1;
        states[7] = v2_1;
        states[8] = x1_2;
        states[9] = x2_2;
        states[10] = v1_2;
        states[11] = v2_2;
    }
    if (!coefficients && !frequencies)
        return;
    /* coefficients */
    const double t37 = -p1 - p2*y;
    const double t38 = p2*w;
    const double t39 = p5*x2_1;
    const double t40 = p5*v2_1;
    if (coefficients) {
        coefficients[0] = 1 - t5;
        coefficients[1] = 0;
        coefficients[2] = t15 + t37;
        coefficients[3] = -t16 - t37 - 1;
        coefficients[4] = -p1*t6*u - t38*t6;
        coefficients[5] = t10*t8*u + t38*t8;
        coefficients[6] = -1;
        coefficients[7] = 0;
        coefficients[8] = p4*x1_1 + t39;
        coefficients[9] = t26*x1_1 - t39;
        coefficients[10] = p4*t29*v1_1 + t29*t40;
        coefficients[11] = t26*t31*v1_1 - t31*t40;
    }
    if (!frequencies)
        return;
    if (frequencies) {
        frequencies[0] = omega1;
        frequencies[1] = omega2;
        frequencies[2] = omega3;
        frequencies[3] = omega4;
    }
}

/* Jacobian of the Poincare map in the section's coordinates; saltation matrices, one below the other; monodromy matrix.
 * Operations: 525. Intermediate terms: 158. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_linearisation(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double *poincare_jacobian, double *saltations, double *monodromy)
{
    const double m1 = parameters[0], m2 = parameters[1], k1 = parameters[2], k2 = parameters[3],
        k3 = parameters[4], T = parameters[5];
    const double omega1 = spectrum[1], omega2 = spectrum[2], p1 = spectrum[3], p2 = spectrum[4],
        p3 = spectrum[5], omega3 = spectrum[7], omega4 = spectrum[8], p4 = spectrum[9],
        p5 = spectrum[10], p6 = spectrum[11];
    const double y = unknowns[0], u = unknowns[1], w = unknowns[2], tau = unknowns[3];
    /* functions of tau in contact */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t1 = omega2*tau;
    const double cos_omega2_tau = cos(t1);
    const double sin_omega2_tau = sin(t1);
    /* contact for tau, until first-leaves-stop */
    const double t2 = sin_omega1_tau/omega1;
    const double t3 = sin_omega2_tau/omega2;
    const double carried_x1_1_by_w = p2*t2 - p2*t3;
    const double t4 = p1 - 1;
    const double carried_x1_1_by_u = p1*t2 - t3*t4;
    const double carried_x1_1_by_y = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t5 = k1*k3;
    const double t6 = k2*k3 + t5;
    const double t7 = (1.0/((k1*k2 + t6)));
    const double t8 = t6*t7;
    const double t9 = p1*t8;
    const double t10 = t5*t7;
    const double t11 = p2*t10;
    const double carried_v1_1_by_u = cos_omega1_tau*p1 - cos_omega2_tau*t4;
    const double x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_w*w + carried_x1_1_by_y*y + cos_omega1_tau*(-t11 - t9) + cos_omega2_tau*(t11 + t4*t8) + t8;
    const double carried_x2_1_by_w = p1*t3 - t2*t4;
    const double carried_x2_1_by_u = p3*t2 - p3*t3;
    const double carried_x2_1_by_y = -cos_omega1_tau*t4 + cos_omega2_tau*p1;
    const double t12 = p3*t8;
    const double t13 = p1*t10;
    const double carried_v2_1_by_u = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_w*w + carried_x2_1_by_y*y + cos_omega1_tau*(t10*t4 - t12) + cos_omega2_tau*(t12 - t13) + t10;
    const double t14 = omega2*sin_omega2_tau;
    const double t15 = omega1*sin_omega1_tau;
    const double carried_v1_1_by_y = p2*t14 - p2*t15;
    const double t16 = p1*t15;
    const double t17 = -t14*t4;
    const double v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y + carried_x1_1_by_y*w + sin_omega1_tau*(omega1*t11 + omega1*t9) + sin_omega2_tau*(-omega2*t11 - omega2*t4*t6*t7) - t16 - t17;
    const double carried_v2_1_by_y = -p1*t14 + t15*t4;
    const double phi_1_30 = p3*t14 - p3*t15;
    const double v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + carried_x2_1_by_y*w + phi_1_30 + sin_omega1_tau*(-omega1*t10*t4 + omega1*t12) + sin_omega2_tau*(-omega2*t12 + omega2*t13);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t18 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t18);
    const double sin_omega3_tau1 = sin(t18);
    const double t19 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t19);
    const double sin_omega4_tau1 = sin(t19);
    /* free for tau1, until first-reaches-stop */
    const double t20 = 1 - p4;
    const double t21 = cos_omega3_tau1*p4 + cos_omega4_tau1*t20;
    const double t22 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double t23 = sin_omega3_tau1/omega3;
    const double t24 = sin_omega4_tau1/omega4;
    const double t25 = p4*t23 + t20*t24;
    const double t26 = p5*t23 - p5*t24;
    const double x1_2 = t21*x1_1 + t22*x2_1 + t25*v1_1 + t26*v2_1;
    const double t27 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t28 = cos_omega3_tau1*t20 + cos_omega4_tau1*p4;
    const double t29 = p6*t23 - p6*t24;
    const double t30 = p4*t24 + t20*t23;
    const double x2_2 = t27*x1_1 + t28*x2_1 + t29*v1_1 + t30*v2_1;
    const double t31 = omega3*sin_omega3_tau1;
    const double t32 = omega4*sin_omega4_tau1;
    const double t33 = -p4*t31 - t20*t32;
    const double t34 = -p5*t31 + p5*t32;
    const double v1_2 = t21*v1_1 + t22*v2_1 + t33*x1_1 + t34*x2_1;
    const double t35 = -p6*t31 + p6*t32;
    const double t36 = -p4*t32 - t20*t31;
    const double v2_2 = t27*v1_1 + t28*v2_1 + t35*x1_1 + t36*x2_1;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t37 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t37;
    const double delay_tau_by_u = carried_x1_1_by_u*t37;
    const double delay_tau_by_w = carried_x1_1_by_w*t37;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t38 = (1.0/(m1));
    const double t39 = k3*t38;
    const double t40 = k1*t38;
    const double t41 = t38*(k1 + k3);
    const double before_v1_1 = t39 + t40*x2_1 - t41*x1_1;
    const double v1_1_on_boundary_by_y = before_v1_1*delay_tau_by_y + carried_v1_1_by_y;
    const double v1_1_on_boundary_by_u = before_v1_1*delay_tau_by_u + carried_v1_1_by_u;
    const double v1_1_on_boundary_by_w = before_v1_1*delay_tau_by_w + carried_x1_1_by_y;
    const double t42 = (1.0/(m2));
    const double t43 = k1*t42;
    const double t44 = t42*(k1 + k2);
    const double before_v2_1 = t43*x1_1 - t44*x2_1;
    const double v2_1_on_boundary_by_y = before_v2_1*delay_tau_by_y + carried_v2_1_by_y;
    const double v2_1_on_boundary_by_u = before_v2_1*delay_tau_by_u + carried_v2_1_by_u;
    const double v2_1_on_boundary_by_w = before_v2_1*delay_tau_by_w + carried_x2_1_by_y;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t21*x1_1_on_boundary_by_y + t22*x2_1_on_boundary_by_y + t25*v1_1_on_boundary_by_y + t26*v2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t21*x1_1_on_boundary_by_u + t22*x2_1_on_boundary_by_u + t25*v1_1_on_boundary_by_u + t26*v2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t21*x1_1_on_boundary_by_w + t22*x2_1_on_boundary_by_w + t25*v1_1_on_boundary_by_w + t26*v2_1_on_boundary_by_w;
    const double carried_x2_2_by_y = t27*x1_1_on_boundary_by_y + t28*x2_1_on_boundary_by_y + t29*v1_1_on_boundary_by_y + t30*v2_1_on_boundary_by_y;
    const double carried_x2_2_by_u = t27*x1_1_on_boundary_by_u + t28*x2_1_on_boundary_by_u + t29*v1_1_on_boundary_by_u + t30*v2_1_on_boundary_by_u;
    const double carried_x2_2_by_w = t27*x1_1_on_boundary_by_w + t28*x2_1_on_boundary_by_w + t29*v1_1_on_boundary_by_w + t30*v2_1_on_boundary_by_w;
    const double carried_v1_2_by_y = t21*v1_1_on_boundary_by_y + t22*v2_1_on_boundary_by_y + t33*x1_1_on_boundary_by_y + t34*x2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t21*v1_1_on_boundary_by_u + t22*v2_1_on_boundary_by_u + t33*x1_1_on_boundary_by_u + t34*x2_1_on_boundary_by_u;
    const double carried_v1_2_by_w = t21*v1_1_on_boundary_by_w + t22*v2_1_on_boundary_by_w + t33*x1_1_on_boundary_by_w + t34*x2_1_on_boundary_by_w;
    const double carried_v2_2_by_y = t27*v1_1_on_boundary_by_y + t28*v2_1_on_boundary_by_y + t35*x1_1_on_boundary_by_y + t36*x2_1_on_boundary_by_y;
    const double carried_v2_2_by_u = t27*v1_1_on_boundary_by_u + t28*v2_1_on_boundary_by_u + t35*x1_1_on_boundary_by_u + t36*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t27*v1_1_on_boundary_by_w + t28*v2_1_on_boundary_by_w + t35*x1_1_on_boundary_by_w + t36*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t45 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t45;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t45;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t45;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2;
    const double x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2;
    const double before_v1_2 = k1*t38*x2_2 - t40*x1_2;
    const double v1_2_on_boundary_by_y = before_v1_2*delay_tau1_by_y + carried_v1_2_by_y;
    const double v1_2_on_boundary_by_u = before_v1_2*delay_tau1_by_u + carried_v1_2_by_u;
    const double v1_2_on_boundary_by_w = before_v1_2*delay_tau1_by_w + carried_v1_2_by_w;
    const double before_v2_2 = t43*x1_2 - t44*x2_2;
    const double v2_2_on_boundary_by_y = before_v2_2*delay_tau1_by_y + carried_v2_2_by_y;
    const double v2_2_on_boundary_by_u = before_v2_2*delay_tau1_by_u + carried_v2_2_by_u;
    const double v2_2_on_boundary_by_w = before_v2_2*delay_tau1_by_w + carried_v2_2_by_w;
    if (poincare_jacobian) {
        poincare_jacobian[0] = x2_2_on_boundary_by_y;
        poincare_jacobian[1] = x2_2_on_boundary_by_u;
        poincare_jacobian[2] = x2_2_on_boundary_by_w;
        poincare_jacobian[3] = v1_2_on_boundary_by_y;
        poincare_jacobian[4] = v1_2_on_boundary_by_u;
        poincare_jacobian[5] = v1_2_on_boundary_by_w;
        poincare_jacobian[6] = v2_2_on_boundary_by_y;
        poincare_jacobian[7] = v2_2_on_boundary_by_u;
        poincare_jacobian[8] = v2_2_on_boundary_by_w;
    }
    if (!saltations && !monodromy)
        return;
    /* vector fields at transition 1 */
    const double behind_v1_1 = k1*t38*x2_1 - t40*x1_1;
    /* vector fields at transition 2 */
    const double behind_v1_2 = t39 + t40*x2_2 - t41*x1_2;
    /* saltations */
    const double t46 = (1.0/(v1_1));
    const double t47 = t46*(before_v1_1 - behind_v1_1);
    const double t48 = 0;
    const double t49 = t45*(-before_v1_2 + behind_v1_2);
    const double t50 = 0;
    if (saltations) {
        for (int i = 0; i < 32; ++i)
            saltations[i] = 0.0;
        saltations[0] = 1;
        saltations[5] = 1;
        saltations[8] = -t47;
        saltations[10] = 1;
        saltations[12] = -t48;
        saltations[15] = 1;
        saltations[16] = 1;
        saltations[21] = 1;
        saltations[24] = t49;
        saltations[26] = 1;
        saltations[28] = t50;
        saltations[31] = 1;
    }
    if (!monodromy)
        return;
    /* Phi of phase 1 */
    const double phi_1_20 = -t16 - t17;
    /* saltation of phase 1 */
    const double saltation_1_20 = -carried_v1_1_by_u*t47 + phi_1_20;
    const double saltation_1_21 = carried_v1_1_by_y - carried_x1_1_by_y*t47;
    const double saltation_1_22 = carried_v1_1_by_u - carried_x1_1_by_u*t47;
    const double saltation_1_23 = -carried_x1_1_by_w*t47 + carried_x1_1_by_y;
    const double saltation_1_30 = -carried_v1_1_by_u*t48 + phi_1_30;
    const double saltation_1_31 = carried_v2_1_by_y - carried_x1_1_by_y*t48;
    const double saltation_1_32 = carried_v2_1_by_u - carried_x1_1_by_u*t48;
    const double saltation_1_33 = -carried_x1_1_by_w*t48 + carried_x2_1_by_y;
    /* Phi of phase 2 */
    const double phi_2_00 = carried_v1_1_by_u*t21 + carried_v2_1_by_u*t22 + saltation_1_20*t25 + saltation_1_30*t26;
    const double phi_2_01 = carried_x1_1_by_y*t21 + carried_x2_1_by_y*t22 + saltation_1_21*t25 + saltation_1_31*t26;
    const double phi_2_02 = carried_x1_1_by_u*t21 + carried_x2_1_by_u*t22 + saltation_1_22*t25 + saltation_1_32*t26;
    const double phi_2_03 = carried_x1_1_by_w*t21 + carried_x2_1_by_w*t22 + saltation_1_23*t25 + saltation_1_33*t26;
    const double phi_2_10 = carried_v1_1_by_u*t27 + carried_v2_1_by_u*t28 + saltation_1_20*t29 + saltation_1_30*t30;
    const double phi_2_11 = carried_x1_1_by_y*t27 + carried_x2_1_by_y*t28 + saltation_1_21*t29 + saltation_1_31*t30;
    const double phi_2_12 = carried_x1_1_by_u*t27 + carried_x2_1_by_u*t28 + saltation_1_22*t29 + saltation_1_32*t30;
    const double phi_2_13 = carried_x1_1_by_w*t27 + carried_x2_1_by_w*t28 + saltation_1_23*t29 + saltation_1_33*t30;
    const double phi_2_20 = carried_v1_1_by_u*t33 + carried_v2_1_by_u*t34 + saltation_1_20*t21 + saltation_1_30*t22;
    const double phi_2_21 = carried_x1_1_by_y*t33 + carried_x2_1_by_y*t34 + saltation_1_21*t21 + saltation_1_31*t22;
    const double phi_2_22 = carried_x1_1_by_u*t33 + carried_x2_1_by_u*t34 + saltation_1_22*t21 + saltation_1_32*t22;
    const double phi_2_23 = carried_x1_1_by_w*t33 + carried_x2_1_by_w*t34 + saltation_1_23*t21 + saltation_1_33*t22;
    const double phi_2_30 = carried_v1_1_by_u*t35 + carried_v2_1_by_u*t36 + saltation_1_20*t27 + saltation_1_30*t28;
    const double phi_2_31 = carried_x1_1_by_y*t35 + carried_x2_1_by_y*t36 + saltation_1_21*t27 + saltation_1_31*t28;
    const double phi_2_32 = carried_x1_1_by_u*t35 + carried_x2_1_by_u*t36 + saltation_1_22*t27 + saltation_1_32*t28;
    const double phi_2_33 = carried_x1_1_by_w*t35 + carried_x2_1_by_w*t36 + saltation_1_23*t27 + saltation_1_33*t28;
    /* saltation of phase 2 */
    const double saltation_2_20 = phi_2_00*t49 + phi_2_20;
    const double saltation_2_21 = phi_2_01*t49 + phi_2_21;
    const double saltation_2_22 = phi_2_02*t49 + phi_2_22;
    const double saltation_2_23 = phi_2_03*t49 + phi_2_23;
    const double saltation_2_30 = phi_2_00*t50 + phi_2_30;
    const double saltation_2_31 = phi_2_01*t50 + phi_2_31;
    const double saltation_2_32 = phi_2_02*t50 + phi_2_32;
    const double saltation_2_33 = phi_2_03*t50 + phi_2_33;
    if (monodromy) {
        monodromy[0] = phi_2_00;
        monodromy[1] = phi_2_01;
        monodromy[2] = phi_2_02;
        monodromy[3] = phi_2_03;
        monodromy[4] = phi_2_10;
        monodromy[5] = phi_2_11;
        monodromy[6] = phi_2_12;
        monodromy[7] = phi_2_13;
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

/* All unknowns from the reduced ones; how singular the linear equations for them are: 0 if they are; the equations for these and their derivatives.
 * Operations: 446. Intermediate terms: 136. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_reduced_fixed_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *fixed)
{
    const double k1 = parameters[2*lanes + lane], k2 = parameters[3*lanes + lane],
        k3 = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[7*lanes + lane], omega4 = spectrum[8*lanes + lane],
        p4 = spectrum[9*lanes + lane], p5 = spectrum[10*lanes + lane];
    /* coefficients of the linear equations */
    const double t4 = k2*k3;
    const double t5 = k1*k2;
    const double t6 = k1*k3;
    const double t7 = (1.0/((t4 + t5 + t6)));
    const double t8 = p2*t6;
    const double t9 = t7*(p2*t4 + p2*t5 + t8);
    const double t12 = p1 - 1;
    const double t13 = p1*t6;
    const double t14 = p1*t4 + p1*t5 + t13;
    const double t16 = t14 - t4 - t5 - t6;
    const double t19 = p4 - 1;
    /* right-hand sides of the linear equations */
    const double t20 = -k1*k2*p1 + t8;
    const double t21 = -t20 - t5;
    const double t22 = p3*t5 + t13;
    const double t23 = -t22 + t6;
    /* determinants */
    const double t38 = 2*(p5*p5);
    const double t41 = (p1*p1);
    const double t46 = (t12*t12) + t41;
    const double t47 = 2*(p2*p2);
    /* d/dtau of: functions of half_tau in contact */
    const double t53 = (1.0/2.0)*omega1;
    const double t54 = (1.0/2.0)*omega2;
    /* d/dtau of: functions of half_tau1 in free */
    const double t55 = (1.0/2.0)*omega3;
    const double t56 = (1.0/2.0)*omega4;
    fixed[lane] = t7;
    fixed[1*lanes + lane] = t9;
    fixed[2*lanes + lane] = t12;
    fixed[3*lanes + lane] = t14;
    fixed[4*lanes + lane] = t16;
    fixed[5*lanes + lane] = t19;
    fixed[6*lanes + lane] = t20;
    fixed[7*lanes + lane] = t21;
    fixed[8*lanes + lane] = t22;
    fixed[9*lanes + lane] = t23;
    fixed[10*lanes + lane] = t38;
    fixed[11*lanes + lane] = t41;
    fixed[12*lanes + lane] = t46;
    fixed[13*lanes + lane] = t47;
    fixed[14*lanes + lane] = t53;
    fixed[15*lanes + lane] = t54;
    fixed[16*lanes + lane] = t55;
    fixed[17*lanes + lane] = t56;
}

static NONSMOOTH_INLINE void elastic_stop_one_contact_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *fixed,
    const double *reduced, double *unknowns, double *determinants, double *reduced_residual,
    double *reduced_jacobian)
{
    const double T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane], omega2 = spectrum[2*lanes + lane],
        p1 = spectrum[3*lanes + lane], p2 = spectrum[4*lanes + lane], p3 = spectrum[5*lanes + lane],
        omega3 = spectrum[7*lanes + lane], omega4 = spectrum[8*lanes + lane],
        p4 = spectrum[9*lanes + lane], p5 = spectrum[10*lanes + lane],
        p6 = spectrum[11*lanes + lane];
    const double t7 = fixed[lane], t9 = fixed[1*lanes + lane], t12 = fixed[2*lanes + lane],
        t14 = fixed[3*lanes + lane], t16 = fixed[4*lanes + lane], t19 = fixed[5*lanes + lane],
        t20 = fixed[6*lanes + lane], t21 = fixed[7*lanes + lane], t22 = fixed[8*lanes + lane],
        t23 = fixed[9*lanes + lane], t38 = fixed[10*lanes + lane], t41 = fixed[11*lanes + lane],
        t46 = fixed[12*lanes + lane], t47 = fixed[13*lanes + lane], t53 = fixed[14*lanes + lane],
        t54 = fixed[15*lanes + lane], t55 = fixed[16*lanes + lane], t56 = fixed[17*lanes + lane];
    const double tau = reduced[lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t1 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t1);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t2 = half_tau1*omega3;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t2);
    const double cos_omega3_half_tau1 = wave_2.cosine;
    const double sin_omega3_half_tau1 = wave_2.sine;
    const double t3 = half_tau1*omega4;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega4_half_tau1 = wave_3.cosine;
    const double sin_omega4_half_tau1 = wave_3.sine;
    const double t10 = omega2*sin_omega2_half_tau;
    const double t11 = omega1*sin_omega1_half_tau;
    const double coefficient11 = t10*t9 - t11*t9;
    const double coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t12;
    const double coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    const double t15 = t10*t7;
    const double coefficient21 = omega1*sin_omega1_half_tau*t16*t7 - t14*t15;
    const double coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    const double coefficient23 = -cos_omega1_half_tau*t12 + cos_omega2_half_tau*p1;
    const double t17 = omega4*sin_omega4_half_tau1;
    const double t18 = omega3*sin_omega3_half_tau1;
    const double coefficient31 = p5*t17 - p5*t18;
    const double coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t19;
    const double coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    const double right1 = -omega1*sin_omega1_half_tau*t20*t7 - t15*t21;
    const double right2 = -t11*t23*t7 - t15*t22;
    const double right3 = p4*t18 - t17*t19;
    /* determinant of the linear equations */
    const double t24 = coefficient22*coefficient33;
    const double t25 = coefficient21*coefficient32;
    const double t26 = coefficient23*coefficient32;
    const double t27 = coefficient21*coefficient33;
    const double t28 = coefficient22*coefficient31;
    const double determinant = coefficient11*t24 - coefficient11*t26 + coefficient12*coefficient23*coefficient31 - coefficient12*t27 + coefficient13*t25 - coefficient13*t28;
    /* numerators of Cramer's rule */
    const double t29 = coefficient12*coefficient23;
    const double t30 = coefficient12*coefficient33;
    const double t31 = coefficient13*coefficient22;
    const double numerator1 = coefficient13*coefficient32*right2 + right1*t24 - right1*t26 - right2*t30 + right3*t29 - right3*t31;
    const double t32 = coefficient11*coefficient23;
    const double t33 = coefficient13*coefficient31;
    const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t27 - right2*t33 - right3*t32;
    const double t34 = coefficient11*coefficient22;
    const double t35 = coefficient11*coefficient32;
    const double t36 = coefficient12*coefficient21;
    const double numerator3 = coefficient12*coefficient31*right2 + right1*t25 - right1*t28 - right2*t35 + right3*t34 - right3*t36;
    /* y, u, w by Cramer's rule */
    const double t37 = (1.0/(determinant));
    const double y = numerator1*t37;
    const double u = numerator2*t37;
    const double w = numerator3*t37;
    if (unknowns) {
        unknowns[lane] = y;
        unknowns[1*lanes + lane] = u;
        unknowns[2*lanes + lane] = w;
        unknowns[3*lanes + lane] = tau;
    }
    if (!determinants && !reduced_residual && !reduced_jacobian)
        return;
    const double t39 = (half_tau1*half_tau1);
    const double t40 = t38*t39;
    const double t42 = (half_tau*half_tau);
    const double t43 = 2*t42;
    const double t44 = (omega2*omega2*omega2*omega2)/((omega2*omega2)*t42 + 1);
    const double t45 = (omega1*omega1*omega1*omega1)/((omega1*omega1)*t42 + 1);
    const double t48 = t42*t47;
    if (determinants) {
        determinants[lane] = determinant/(sqrt(2*(p3*p3) + (t12*t12)*t43*t45 + t41*t43*t44 + t46)*sqrt(t44*t48 + t45*t48 + t46 + t47)*sqrt((omega3*omega3*omega3*omega3)*t40/((omega3*omega3)*t39 + 1) + (omega4*omega4*omega4*omega4)*t40/((omega4*omega4)*t39 + 1) + (p4*p4) + (t19*t19) + t38));
    }
    if (!reduced_residual && !reduced_jacobian)
        return;
    /* reduced_residual */
    const double t49 = p6*t17 - p6*t18;
    const double t50 = omega3*sin_omega3_half_tau1*t19 - p4*t17;
    const double t51 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
    const double t52 = cos_omega3_half_tau1*t19 - cos_omega4_half_tau1*p4;
    if (reduced_residual) {
        reduced_residual[lane] = determinant*t49 + numerator1*t50 + numerator2*t51 + numerator3*t52;
    }
    if (!reduced_jacobian)
        return;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t53;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t53;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t54;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t54;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t55;
    const double sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t55;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t56;
    const double sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t56;
    /* d/dtau of: coefficients of the linear equations */
    const double t57 = omega2*sin_omega2_half_tau_by_tau;
    const double t58 = omega1*sin_omega1_half_tau_by_tau;
    const double coefficient11_by_tau = t57*t9 - t58*t9;
    const double coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 - cos_omega2_half_tau_by_tau*t12;
    const double coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2;
    const double t59 = t57*t7;
    const double coefficient21_by_tau = omega1*sin_omega1_half_tau_by_tau*t16*t7 - t14*t59;
    const double coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3;
    const double coefficient23_by_tau = -cos_omega1_half_tau_by_tau*t12 + cos_omega2_half_tau_by_tau*p1;
    const double t60 = omega4*sin_omega4_half_tau1_by_tau;
    const double t61 = omega3*sin_omega3_half_tau1_by_tau;
    const double coefficient31_by_tau = p5*t60 - p5*t61;
    const double coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t19;
    const double coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5;
    /* d/dtau of: right-hand sides of the linear equations */
    const double right1_by_tau = -omega1*sin_omega1_half_tau_by_tau*t20*t7 - t21*t59;
    const double right2_by_tau = -t22*t59 - t23*t58*t7;
    const double right3_by_tau = p4*t61 - t19*t60;
    /* d/dtau of: determinant of the linear equations */
    const double t62 = t24 - t26;
    const double t63 = coefficient23*coefficient31 - t27;
    const double t64 = t25 - t28;
    const double t65 = coefficient13*coefficient32 - t30;
    const double t66 = coefficient11*coefficient33 - t33;
    const double t67 = coefficient12*coefficient31 - t35;
    const double t68 = t29 - t31;
    const double t69 = coefficient13*coefficient21 - t32;
    const double t70 = t34 - t36;
    const double determinant_by_tau = coefficient11_by_tau*t62 + coefficient12_by_tau*t63 + coefficient13_by_tau*t64 + coefficient21_by_tau*t65 + coefficient22_by_tau*t66 + coefficient23_by_tau*t67 + coefficient31_by_tau*t68 + coefficient32_by_tau*t69 + coefficient33_by_tau*t70;
    /* d/dtau of: numerators of Cramer's rule */
    const double t71 = coefficient23*right3 - coefficient33*right2;
    const double t72 = coefficient22*right3 - coefficient32*right2;
    const double t73 = coefficient13*right3 - coefficient33*right1;
    const double t74 = coefficient12*right3 - coefficient32*right1;
    const double t75 = coefficient13*right2 - coefficient23*right1;
    const double t76 = coefficient12*right2 - coefficient22*right1;
    const double numerator1_by_tau = coefficient12_by_tau*t71 - coefficient13_by_tau*t72 - coefficient22_by_tau*t73 + coefficient23_by_tau*t74 + coefficient32_by_tau*t75 - coefficient33_by_tau*t76 + right1_by_tau*t62 + right2_by_tau*t65 + right3_by_tau*t68;
    const double t77 = coefficient21*right3 - coefficient31*right2;
    const double t78 = coefficient11*right3 - coefficient31*right1;
    const double t79 = coefficient11*right2 - coefficient21*right1;
    const double numerator2_by_tau = -coefficient11_by_tau*t71 + coefficient13_by_tau*t77 + coefficient21_by_tau*t73 - coefficient23_by_tau*t78 - coefficient31_by_tau*t75 + coefficient33_by_tau*t79 + right1_by_tau*t63 + right2_by_tau*t66 + right3_by_tau*t69;
    const double numerator3_by_tau = coefficient11_by_tau*t72 - coefficient12_by_tau*t77 - coefficient21_by_tau*t74 + coefficient22_by_tau*t78 + coefficient31_by_tau*t76 - coefficient32_by_tau*t79 + right1_by_tau*t64 + right2_by_tau*t67 + right3_by_tau*t70;
    /* reduced_jacobian */
    const double t80 = numerator2*p6;
    const double t81 = determinant*p6;
    if (reduced_jacobian) {
        reduced_jacobian[lane] = cos_omega3_half_tau1_by_tau*(numerator3*t19 - t80) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t80) + determinant_by_tau*t49 + numerator1_by_tau*t50 + numerator2_by_tau*t51 + numerator3_by_tau*t52 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t19 - omega3*t81) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t81);
    }
}

NONSMOOTH_UNMERGED
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double *unknowns, double *determinants, double *reduced_residual, double *reduced_jacobian)
{
    double fixed[18];
    elastic_stop_one_contact_reduced_fixed_in_lane(1, 0, parameters, spectrum, fixed);
    elastic_stop_one_contact_reduced_in_lane(1, 0, parameters, spectrum, fixed, reduced, unknowns,
        determinants, reduced_residual, reduced_jacobian);
}

/* Newton's method on the reduced equations for `count` points. */
NONSMOOTH_MULTIVERSION
void elastic_stop_one_contact_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = NONSMOOTH_LANES, n = 4, p = 6, reduced = 1 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const int here = count - start < lanes ? (int)(count - start) : lanes;
        double parameter[p * lanes], unknown[n * lanes];
        double fixed[18 * lanes], determinant[1 * lanes], x[1 * lanes], equation[1 * lanes], jacobian[1 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[5 * lanes], spectrum[12 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 3 * lanes);
        nonsmooth_load(lanes, 1, parameters + 4 * count, count, start, own + 4 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            elastic_stop_spectrum_in_lane(lanes, lane, own, spectrum, NULL);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            elastic_stop_one_contact_reduced_fixed_in_lane(lanes, lane, parameter, spectrum, fixed);
        static const int positive[] = {1};
        nonsmooth_load(lanes, reduced, guess, count, start, x);
        for (int step = 0; step < 32 && nonsmooth_runs(lanes, open); ++step) {
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                elastic_stop_one_contact_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                    NULL, NULL, equation, jacobian);
                nonsmooth_newton_in_lane(reduced, positive, lane, jacobian, equation, x, open,
                    taken);
            }
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            elastic_stop_one_contact_reduced_in_lane(lanes, lane, parameter, spectrum, fixed, x,
                unknown, determinant, equation, NULL);
            elastic_stop_one_contact_trace_in_lane(lanes, lane, parameter, spectrum, unknown, NULL,
                slope, NULL);
        }
        nonsmooth_largest(lanes, reduced, equation, largest);
        nonsmooth_doubt(lanes, n, unknown, doubt);
        nonsmooth_doubt(lanes, 1, slope, doubt);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            int32_t code = ELASTIC_STOP_CONVERGED;
            code = ((unknown[3*lanes + lane] <= 0.0) | (parameter[5*lanes + lane] - unknown[3*lanes
                + lane] <= 0.0)) ? ELASTIC_STOP_NOT_POSITIVE : code;
            code = open[lane] != 0.0 ? ELASTIC_STOP_NOT_CONVERGED : code;
            code = doubt[lane] != 0.0 ? ELASTIC_STOP_NOT_FINITE : code;
            code = ((fabs(determinant[0*lanes + lane]) <= NONSMOOTH_SINGULAR)) ?
                ELASTIC_STOP_SINGULAR : code;
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
void elastic_stop_one_contact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant)
{
    static const int counts[] = {1, 1}, at_once[] = {0, 0}, exits[] = {0, 6};
    static const int opened[] = {-1, -1};
    static const int begins[] = {1, 1};
    static const double per_unit[] = {0.0, 0.0};
    static const nonsmooth_boundaries boundaries = {
        2, 0, counts, at_once, exits, opened, begins, per_unit};
    static const int terms[] = {2, 2}, first[] = {0, 2};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 6 * point, *const u = unknowns + 4 * point;
        const double q[5] = {p[0], p[1], p[2], p[3], p[4]};
        const double durations[] = {u[3], p[5] - u[3]};
        const double measures[] = {u[0], u[1], u[2]};
        double spectral[12], work[4], rows[12], frequencies[4];
        elastic_stop_spectrum(q, spectral, NULL);
        elastic_stop_one_contact_passage(p, spectral, u, NULL, rows, frequencies);
        const nonsmooth_phase_sums sums = {terms, first, frequencies};
        const nonsmooth_along along = nonsmooth_along_sums(&sums, durations, rows);
        const nonsmooth_verdict verdict =
            nonsmooth_judge(&boundaries, &along, 3, measures, work, NULL);
        boundary[point] = verdict.boundary;
        excess[point] = verdict.excess;
        instant[point] = verdict.instant;
    }
}

/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. */
NONSMOOTH_MULTIVERSION
void elastic_stop_one_contact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = NONSMOOTH_LANES, n = 4, p = 6 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        double parameter[p * lanes], unknown[n * lanes];
        double jacobian[n * n * lanes], moved[n * p * lanes], slope[(n + p) * lanes];
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        nonsmooth_load(lanes, n, unknowns, count, start, unknown);
        double own[5 * lanes], spectrum[12 * lanes], spectrum_derivatives[60 * lanes];
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 3 * lanes);
        nonsmooth_load(lanes, 1, parameters + 4 * count, count, start, own + 4 * lanes);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            elastic_stop_spectrum_in_lane(lanes, lane, own, spectrum, spectrum_derivatives);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            elastic_stop_one_contact_equations_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, jacobian, moved);
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane)
            elastic_stop_one_contact_trace_in_lane(lanes, lane, parameter, spectrum, unknown,
                spectrum_derivatives, NULL, slope);
        nonsmooth_implicit_derivatives(n, p, jacobian, moved, slope);
        nonsmooth_store(lanes, n * p, moved, count, start, directions);
        nonsmooth_store(lanes, p, slope + n * lanes, count, start, directions + n * p * count);
    }
}
