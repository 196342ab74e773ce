/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation bc8b907cd6e5cf02 */
#include "elastic_stop.h"

#include <math.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_sums.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 310. Intermediate terms: 144. */
void elastic_stop_spectrum(
    const double parameters[5], double spectrum[12], double derivatives[60])
{
    const double k1 = parameters[0];
    const double k2 = parameters[1];
    const double k3 = parameters[2];
    const double m1 = parameters[3];
    const double m2 = parameters[4];
    /* spectrum */
    const double t0 = (1.0/(m2));
    const double t1 = k1 + k2;
    const double t2 = t0*t1;
    const double t3 = (1.0/(m1));
    const double t4 = k1 + k3;
    const double t5 = -t2 + t3*t4;
    const double t6 = (k1*k1);
    const double t7 = 4*t0*t6;
    const double t8 = t3*t7;
    const double gap1 = sqrt((t5*t5) + t8);
    const double t9 = (1.0/2.0)*t2;
    const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t3*t4 + t9);
    const double t10 = sqrt(k1*k2 + k1*k3 + k2*k3);
    const double t11 = (1.0/(omega1));
    const double t12 = (1.0/sqrt(m1));
    const double t13 = (1.0/sqrt(m2));
    const double t14 = t12*t13;
    const double t15 = t11*t14;
    const double omega2 = t10*t15;
    const double t16 = (1.0/(gap1));
    const double t17 = (1.0/2.0)*t16;
    const double p1 = t17*t5 + 1.0/2.0;
    const double t18 = k1*t3;
    const double p2 = -t16*t18;
    const double t19 = t0*t16;
    const double p3 = -k1*t19;
    const double t20 = t18 - t2;
    const double gap2 = sqrt((t20*t20) + t8);
    const double omega3 = sqrt((1.0/2.0)*gap2 + (1.0/2.0)*t18 + t9);
    const double t21 = (1.0/(omega3));
    const double t22 = sqrt(k1);
    const double t23 = sqrt(k2);
    const double t24 = t14*t22*t23;
    const double omega4 = t21*t24;
    const double t25 = (1.0/(gap2));
    const double t26 = (1.0/2.0)*t25;
    const double p4 = t20*t26 + 1.0/2.0;
    const double p5 = -t18*t25;
    const double t27 = t0*t25;
    const double p6 = -k1*t27;
    /* d/dk1 of: spectrum */
    const double t28 = -2*t0 + 2*t3;
    const double t29 = 8*t0*t18;
    const double gap1_by_k1 = t17*(t28*t5 + t29);
    const double t30 = (1.0/2.0)*gap1_by_k1;
    const double t31 = (1.0/2.0)*t0;
    const double t32 = (1.0/2.0)*t3;
    const double t33 = t31 + t32;
    const double t34 = (1.0/2.0)*t11;
    const double omega1_by_k1 = t34*(t30 + t33);
    const double t35 = (1.0/2.0)*k2;
    const double t36 = (1.0/2.0)*k3;
    const double t37 = t15/t10;
    const double t38 = t10*t14/(omega1*omega1);
    const double omega2_by_k1 = -omega1_by_k1*t38 + t37*(t35 + t36);
    const double t39 = -t0 + t3;
    const double t40 = (1.0/(gap1*gap1));
    const double t41 = t40*t5;
    const double p1_by_k1 = t17*t39 - t30*t41;
    const double t42 = t16*t3;
    const double p2_by_k1 = gap1_by_k1*k1*t3*t40 - t42;
    const double p3_by_k1 = gap1_by_k1*k1*t0*t40 - t19;
    const double gap2_by_k1 = t26*(t20*t28 + t29);
    const double t43 = (1.0/2.0)*gap2_by_k1;
    const double t44 = (1.0/2.0)*t21;
    const double omega3_by_k1 = t44*(t33 + t43);
    const double t45 = t24/(omega3*omega3);
    const double omega4_by_k1 = -omega3_by_k1*t45 + (1.0/2.0)*t12*t13*t21*t23/t22;
    const double t46 = (1.0/(gap2*gap2));
    const double t47 = t20*t46;
    const double p4_by_k1 = t26*t39 - t43*t47;
    const double p5_by_k1 = gap2_by_k1*k1*t3*t46 - t25*t3;
    const double p6_by_k1 = gap2_by_k1*k1*t0*t46 - t27;
    /* d/dk2 of: spectrum */
    const double gap1_by_k2 = -t19*t5;
    const double t48 = (1.0/2.0)*gap1_by_k2;
    const double omega1_by_k2 = t34*(t31 + t48);
    const double t49 = (1.0/2.0)*k1;
    const double omega2_by_k2 = -omega1_by_k2*t38 + t37*(t36 + t49);
    const double p1_by_k2 = -t16*t31 - t41*t48;
    const double t50 = gap1_by_k2*t40;
    const double p2_by_k2 = t18*t50;
    const double t51 = k1*t0;
    const double p3_by_k2 = t50*t51;
    const double gap2_by_k2 = -t20*t27;
    const double t52 = (1.0/2.0)*gap2_by_k2;
    const double omega3_by_k2 = t44*(t31 + t52);
    const double omega4_by_k2 = -omega3_by_k2*t45 + (1.0/2.0)*t12*t13*t21*t22/t23;
    const double p4_by_k2 = -t25*t31 - t47*t52;
    const double t53 = gap2_by_k2*t46;
    const double p5_by_k2 = t18*t53;
    const double p6_by_k2 = t51*t53;
    /* d/dk3 of: spectrum */
    const double gap1_by_k3 = t42*t5;
    const double t54 = (1.0/2.0)*gap1_by_k3;
    const double omega1_by_k3 = t34*(t32 + t54);
    const double omega2_by_k3 = -omega1_by_k3*t38 + t37*(t35 + t49);
    const double p1_by_k3 = t16*t32 - t41*t54;
    const double t55 = gap1_by_k3*t40;
    const double p2_by_k3 = t18*t55;
    const double p3_by_k3 = t51*t55;
    /* d/dm1 of: spectrum */
    const double t56 = (1.0/(m1*m1));
    const double t57 = t4*t56;
    const double t58 = t56*t7;
    const double gap1_by_m1 = t17*(-2*t5*t57 - t58);
    const double t59 = (1.0/2.0)*gap1_by_m1;
    const double omega1_by_m1 = t34*(-1.0/2.0*t57 + t59);
    const double t60 = t10*t34;
    const double t61 = t13/(sqrt(m1)*sqrt(m1)*sqrt(m1));
    const double omega2_by_m1 = -omega1_by_m1*t38 - t60*t61;
    const double p1_by_m1 = -t17*t57 - t41*t59;
    const double t62 = k1*t56;
    const double t63 = gap1_by_m1*t40;
    const double p2_by_m1 = t16*t62 + t18*t63;
    const double p3_by_m1 = t51*t63;
    const double gap2_by_m1 = t26*(-2*t20*t62 - t58);
    const double t64 = (1.0/2.0)*gap2_by_m1;
    const double t65 = t49*t56;
    const double omega3_by_m1 = t44*(t64 - t65);
    const double t66 = t22*t23*t44;
    const double omega4_by_m1 = -omega3_by_m1*t45 - t61*t66;
    const double p4_by_m1 = -t25*t65 - t47*t64;
    const double t67 = gap2_by_m1*t46;
    const double p5_by_m1 = t18*t67 + t25*t62;
    const double p6_by_m1 = t51*t67;
    /* d/dm2 of: spectrum */
    const double t68 = (1.0/(m2*m2));
    const double t69 = 4*t3*t6*t68;
    const double gap1_by_m2 = t17*(2*t1*t5*t68 - t69);
    const double t70 = (1.0/2.0)*gap1_by_m2;
    const double t71 = t1*t68;
    const double t72 = -1.0/2.0*t71;
    const double omega1_by_m2 = t34*(t70 + t72);
    const double t73 = t12/(sqrt(m2)*sqrt(m2)*sqrt(m2));
    const double omega2_by_m2 = -omega1_by_m2*t38 - t60*t73;
    const double p1_by_m2 = t17*t71 - t41*t70;
    const double t74 = gap1_by_m2*t40;
    const double p2_by_m2 = t18*t74;
    const double t75 = k1*t68;
    const double p3_by_m2 = t16*t75 + t51*t74;
    const double gap2_by_m2 = t26*(2*t1*t20*t68 - t69);
    const double t76 = (1.0/2.0)*gap2_by_m2;
    const double omega3_by_m2 = t44*(t72 + t76);
    const double omega4_by_m2 = -omega3_by_m2*t45 - t66*t73;
    const double p4_by_m2 = t26*t71 - t47*t76;
    const double t77 = gap2_by_m2*t46;
    const double p5_by_m2 = t18*t77;
    const double p6_by_m2 = t25*t75 + t51*t77;
    spectrum[0] = gap1;
    spectrum[1] = omega1;
    spectrum[2] = omega2;
    spectrum[3] = p1;
    spectrum[4] = p2;
    spectrum[5] = p3;
    spectrum[6] = gap2;
    spectrum[7] = omega3;
    spectrum[8] = omega4;
    spectrum[9] = p4;
    spectrum[10] = p5;
    spectrum[11] = p6;
    derivatives[0] = gap1_by_k1;
    derivatives[1] = gap1_by_k2;
    derivatives[2] = gap1_by_k3;
    derivatives[3] = gap1_by_m1;
    derivatives[4] = gap1_by_m2;
    derivatives[5] = omega1_by_k1;
    derivatives[6] = omega1_by_k2;
    derivatives[7] = omega1_by_k3;
    derivatives[8] = omega1_by_m1;
    derivatives[9] = omega1_by_m2;
    derivatives[10] = omega2_by_k1;
    derivatives[11] = omega2_by_k2;
    derivatives[12] = omega2_by_k3;
    derivatives[13] = omega2_by_m1;
    derivatives[14] = omega2_by_m2;
    derivatives[15] = p1_by_k1;
    derivatives[16] = p1_by_k2;
    derivatives[17] = p1_by_k3;
    derivatives[18] = p1_by_m1;
    derivatives[19] = p1_by_m2;
    derivatives[20] = p2_by_k1;
    derivatives[21] = p2_by_k2;
    derivatives[22] = p2_by_k3;
    derivatives[23] = p2_by_m1;
    derivatives[24] = p2_by_m2;
    derivatives[25] = p3_by_k1;
    derivatives[26] = p3_by_k2;
    derivatives[27] = p3_by_k3;
    derivatives[28] = p3_by_m1;
    derivatives[29] = p3_by_m2;
    derivatives[30] = gap2_by_k1;
    derivatives[31] = gap2_by_k2;
    derivatives[32] = 0;
    derivatives[33] = gap2_by_m1;
    derivatives[34] = gap2_by_m2;
    derivatives[35] = omega3_by_k1;
    derivatives[36] = omega3_by_k2;
    derivatives[37] = 0;
    derivatives[38] = omega3_by_m1;
    derivatives[39] = omega3_by_m2;
    derivatives[40] = omega4_by_k1;
    derivatives[41] = omega4_by_k2;
    derivatives[42] = 0;
    derivatives[43] = omega4_by_m1;
    derivatives[44] = omega4_by_m2;
    derivatives[45] = p4_by_k1;
    derivatives[46] = p4_by_k2;
    derivatives[47] = 0;
    derivatives[48] = p4_by_m1;
    derivatives[49] = p4_by_m2;
    derivatives[50] = p5_by_k1;
    derivatives[51] = p5_by_k2;
    derivatives[52] = 0;
    derivatives[53] = p5_by_m1;
    derivatives[54] = p5_by_m2;
    derivatives[55] = p6_by_k1;
    derivatives[56] = p6_by_k2;
    derivatives[57] = 0;
    derivatives[58] = p6_by_m1;
    derivatives[59] = p6_by_m2;
}

/* State after a time in contact.
 * Operations: 133. Intermediate terms: 25. */
void elastic_stop_flow_contact(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
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
    const double t13 = k1*k3;
    const double t14 = k2*k3 + t13;
    const double t15 = (1.0/((k1*k2 + t14)));
    const double t16 = t14*t15;
    const double t17 = t13*t15;
    const double t18 = p2*t17;
    const double t19 = p1*t16;
    const double t20 = -p3*t10 + p3*t9;
    const double t21 = p1*t10 - t4*t9;
    const double t22 = p3*t16;
    const double t24 = p1*t17;
    const double t25 = omega1*t1;
    const double t26 = omega2*t7;
    state_after[0] = t10*(t16*t4 + t18) + t11*x1 + t12*x2 + t16 + t9*(-t18 - t19) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(t22 - t24) + t17 + t20*x1 + t21*x2 + t9*(t17*t4 - t22) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t18 + omega1*t19) + t11*v1 + t12*v2 + t7*(-omega2*t14*t15*t4 - omega2*t18) + x1*(-p1*t25 + t26*t4) + x2*(omega2*p2*t7 - p2*t25);
    state_after[3] = t1*(-omega1*t17*t4 + omega1*t22) + t20*v1 + t21*v2 + t7*(-omega2*t22 + omega2*t24) + x1*(omega2*p3*t7 - p3*t25) + x2*(-p1*t26 + t25*t4);
}

/* State after a time in free.
 * Operations: 82. Intermediate terms: 16. */
void elastic_stop_flow_free(
    const double parameters[5], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/(omega3));
    const double t1 = omega3*t;
    const double t2 = sin(t1);
    const double t3 = t0*t2;
    const double t4 = 1 - p4;
    const double t5 = omega4*t;
    const double t6 = sin(t5);
    const double t7 = t6/omega4;
    const double t8 = cos(t1);
    const double t9 = cos(t5);
    const double t10 = p4*t8 + t4*t9;
    const double t11 = p5*t8 - p5*t9;
    const double t12 = p6*t8 - p6*t9;
    const double t13 = p4*t9 + t4*t8;
    const double t14 = omega3*t2;
    const double t15 = omega4*t6;
    state_after[0] = t10*x1 + t11*x2 + v1*(p4*t3 + t4*t7) + v2*(p5*t0*t2 - p5*t7);
    state_after[1] = t12*x1 + t13*x2 + v1*(p6*t0*t2 - p6*t7) + v2*(p4*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + x1*(-p4*t14 - t15*t4) + x2*(omega4*p5*t6 - p5*t14);
    state_after[3] = t12*v1 + t13*v2 + x1*(omega4*p6*t6 - p6*t14) + x2*(-p4*t15 - t14*t4);
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Operations: 12. Intermediate terms: 5. */
void elastic_stop_fields(
    const double parameters[5], double fields[40])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    /* outputs */
    const double t0 = (1.0/(m1));
    const double t1 = k1*t0;
    const double t2 = (1.0/(m2));
    const double t3 = k1*t2;
    const double t4 = -t2*(k1 + k2);
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
    fields[10] = -t0*(k1 + k3);
    fields[11] = t1;
    fields[12] = 0;
    fields[13] = 0;
    fields[14] = k3*t0;
    fields[15] = t3;
    fields[16] = t4;
    fields[17] = 0;
    fields[18] = 0;
    fields[19] = 0;
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
    fields[30] = -t1;
    fields[31] = t1;
    fields[32] = 0;
    fields[33] = 0;
    fields[34] = 0;
    fields[35] = t3;
    fields[36] = t4;
    fields[37] = 0;
    fields[38] = 0;
    fields[39] = 0;
}

/* Affine functions of the state: gradients, constants last.
 * Operations: 3. Intermediate terms: 0. */
void elastic_stop_rows(
    const double parameters[5], double rows[25])
{
    const double k3 = parameters[4];
    rows[0] = -1;
    rows[1] = 0;
    rows[2] = 0;
    rows[3] = 0;
    rows[4] = 1;
    rows[5] = 1;
    rows[6] = 0;
    rows[7] = 0;
    rows[8] = 0;
    rows[9] = -1;
    rows[10] = -k3;
    rows[11] = 0;
    rows[12] = 0;
    rows[13] = 0;
    rows[14] = k3;
    rows[15] = 0;
    rows[16] = 0;
    rows[17] = 1;
    rows[18] = 0;
    rows[19] = 0;
    rows[20] = 0;
    rows[21] = 0;
    rows[22] = 0;
    rows[23] = 0;
    rows[24] = 0;
}

/* Affine resets of the state, one below the other, offsets last.
 * Operations: 0. Intermediate terms: 0. */
void elastic_stop_resets(
    const double parameters[5], double resets[20])
{
    (void)parameters;
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
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Operations: 104. Intermediate terms: 20. */
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double exponents[12],
    double coefficients[200])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    /* outputs */
    const double t0 = k1*k3;
    const double t1 = k2*k3 + t0;
    const double t2 = (1.0/((k1*k2 + t1)));
    const double t3 = t1*t2;
    const double t4 = t0*t2;
    const double t5 = p2*t4;
    const double t6 = p1 - 1;
    const double t8 = -p3*t3;
    const double t9 = (1.0/(omega1));
    const double t10 = omega1*p1;
    const double t11 = omega1*p2;
    const double t12 = omega1*p3;
    const double t13 = -omega1*t6;
    const double t16 = (1.0/(omega2));
    const double t17 = omega2*p2;
    const double t18 = omega2*p3;
    const double t19 = omega2*p1;
    const double t20 = 1 - p4;
    const double t21 = (1.0/(omega3));
    const double t24 = (1.0/(omega4));
    exponents[0] = 0;
    exponents[1] = 0;
    exponents[2] = 0;
    exponents[3] = omega1;
    exponents[4] = 0;
    exponents[5] = omega2;
    exponents[6] = 0;
    exponents[7] = 0;
    exponents[8] = 0;
    exponents[9] = omega3;
    exponents[10] = 0;
    exponents[11] = omega4;
    coefficients[0] = 0;
    coefficients[1] = 0;
    coefficients[2] = 0;
    coefficients[3] = 0;
    coefficients[4] = t3;
    coefficients[5] = 0;
    coefficients[6] = 0;
    coefficients[7] = 0;
    coefficients[8] = 0;
    coefficients[9] = t4;
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
    coefficients[24] = -p1*t3 - t5;
    coefficients[25] = p3;
    coefficients[26] = -t6;
    coefficients[27] = 0;
    coefficients[28] = 0;
    coefficients[29] = t4*t6 + t8;
    coefficients[30] = 0;
    coefficients[31] = 0;
    coefficients[32] = p1;
    coefficients[33] = p2;
    coefficients[34] = 0;
    coefficients[35] = 0;
    coefficients[36] = 0;
    coefficients[37] = p3;
    coefficients[38] = -t6;
    coefficients[39] = 0;
    coefficients[40] = 0;
    coefficients[41] = 0;
    coefficients[42] = p1*t9;
    coefficients[43] = p2*t9;
    coefficients[44] = 0;
    coefficients[45] = 0;
    coefficients[46] = 0;
    coefficients[47] = p3*t9;
    coefficients[48] = -t6*t9;
    coefficients[49] = 0;
    coefficients[50] = -t10;
    coefficients[51] = -t11;
    coefficients[52] = 0;
    coefficients[53] = 0;
    coefficients[54] = t10*t3 + t11*t4;
    coefficients[55] = -t12;
    coefficients[56] = -t13;
    coefficients[57] = 0;
    coefficients[58] = 0;
    coefficients[59] = t12*t3 + t13*t4;
    coefficients[60] = -t6;
    coefficients[61] = -p2;
    coefficients[62] = 0;
    coefficients[63] = 0;
    coefficients[64] = t3*t6 + t5;
    coefficients[65] = -p3;
    coefficients[66] = p1;
    coefficients[67] = 0;
    coefficients[68] = 0;
    coefficients[69] = -p1*t4 - t8;
    coefficients[70] = 0;
    coefficients[71] = 0;
    coefficients[72] = -t6;
    coefficients[73] = -p2;
    coefficients[74] = 0;
    coefficients[75] = 0;
    coefficients[76] = 0;
    coefficients[77] = -p3;
    coefficients[78] = p1;
    coefficients[79] = 0;
    coefficients[80] = 0;
    coefficients[81] = 0;
    coefficients[82] = -t16*t6;
    coefficients[83] = -p2*t16;
    coefficients[84] = 0;
    coefficients[85] = 0;
    coefficients[86] = 0;
    coefficients[87] = -p3*t16;
    coefficients[88] = p1*t16;
    coefficients[89] = 0;
    coefficients[90] = omega2*t6;
    coefficients[91] = t17;
    coefficients[92] = 0;
    coefficients[93] = 0;
    coefficients[94] = -omega2*t1*t2*t6 - t17*t4;
    coefficients[95] = t18;
    coefficients[96] = -t19;
    coefficients[97] = 0;
    coefficients[98] = 0;
    coefficients[99] = -t18*t3 + t19*t4;
    coefficients[100] = 0;
    coefficients[101] = 0;
    coefficients[102] = 0;
    coefficients[103] = 0;
    coefficients[104] = 0;
    coefficients[105] = 0;
    coefficients[106] = 0;
    coefficients[107] = 0;
    coefficients[108] = 0;
    coefficients[109] = 0;
    coefficients[110] = 0;
    coefficients[111] = 0;
    coefficients[112] = 0;
    coefficients[113] = 0;
    coefficients[114] = 0;
    coefficients[115] = 0;
    coefficients[116] = 0;
    coefficients[117] = 0;
    coefficients[118] = 0;
    coefficients[119] = 0;
    coefficients[120] = p4;
    coefficients[121] = p5;
    coefficients[122] = 0;
    coefficients[123] = 0;
    coefficients[124] = 0;
    coefficients[125] = p6;
    coefficients[126] = t20;
    coefficients[127] = 0;
    coefficients[128] = 0;
    coefficients[129] = 0;
    coefficients[130] = 0;
    coefficients[131] = 0;
    coefficients[132] = p4;
    coefficients[133] = p5;
    coefficients[134] = 0;
    coefficients[135] = 0;
    coefficients[136] = 0;
    coefficients[137] = p6;
    coefficients[138] = t20;
    coefficients[139] = 0;
    coefficients[140] = 0;
    coefficients[141] = 0;
    coefficients[142] = p4*t21;
    coefficients[143] = p5*t21;
    coefficients[144] = 0;
    coefficients[145] = 0;
    coefficients[146] = 0;
    coefficients[147] = p6*t21;
    coefficients[148] = t20*t21;
    coefficients[149] = 0;
    coefficients[150] = -omega3*p4;
    coefficients[151] = -omega3*p5;
    coefficients[152] = 0;
    coefficients[153] = 0;
    coefficients[154] = 0;
    coefficients[155] = -omega3*p6;
    coefficients[156] = -omega3*t20;
    coefficients[157] = 0;
    coefficients[158] = 0;
    coefficients[159] = 0;
    coefficients[160] = t20;
    coefficients[161] = -p5;
    coefficients[162] = 0;
    coefficients[163] = 0;
    coefficients[164] = 0;
    coefficients[165] = -p6;
    coefficients[166] = p4;
    coefficients[167] = 0;
    coefficients[168] = 0;
    coefficients[169] = 0;
    coefficients[170] = 0;
    coefficients[171] = 0;
    coefficients[172] = t20;
    coefficients[173] = -p5;
    coefficients[174] = 0;
    coefficients[175] = 0;
    coefficients[176] = 0;
    coefficients[177] = -p6;
    coefficients[178] = p4;
    coefficients[179] = 0;
    coefficients[180] = 0;
    coefficients[181] = 0;
    coefficients[182] = t20*t24;
    coefficients[183] = -p5*t24;
    coefficients[184] = 0;
    coefficients[185] = 0;
    coefficients[186] = 0;
    coefficients[187] = -p6*t24;
    coefficients[188] = p4*t24;
    coefficients[189] = 0;
    coefficients[190] = -omega4*t20;
    coefficients[191] = omega4*p5;
    coefficients[192] = 0;
    coefficients[193] = 0;
    coefficients[194] = 0;
    coefficients[195] = omega4*p6;
    coefficients[196] = -omega4*p4;
    coefficients[197] = 0;
    coefficients[198] = 0;
    coefficients[199] = 0;
}

/* Switching and periodicity equations.
 * Operations: 121. Intermediate terms: 37. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_residual(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double residual[4])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t1 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t1);
    const double sin_omega2_half_tau = sin(t1);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t2 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t2);
    const double sin_omega3_half_tau1 = sin(t2);
    const double t3 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t3);
    const double sin_omega4_half_tau1 = sin(t3);
    /* outputs */
    const double t4 = p1*u + p2*w;
    const double t6 = k1*k2;
    const double t7 = p1*t6;
    const double t8 = k1*k3;
    const double t9 = p2*t8;
    const double t10 = t6*y;
    const double t11 = k2*k3;
    const double t12 = t11*y;
    const double t13 = p2*t10 + p2*t12 + t7 + t9*y - t9;
    const double t14 = (1.0/((t11 + t6 + t8)));
    const double t15 = omega2*sin_omega2_half_tau*t14;
    const double t16 = omega1*sin_omega1_half_tau*t14;
    const double t17 = p3*u;
    const double t18 = p1*w;
    const double t19 = p1*t8;
    const double t20 = p3*t6;
    const double t21 = p4*u + p5*w;
    const double t22 = p4 + p5*y;
    const double t23 = omega4*sin_omega4_half_tau1;
    const double t24 = omega3*sin_omega3_half_tau1;
    const double t25 = p6*u;
    const double t26 = p4*w;
    residual[0] = cos_omega1_half_tau*t4 + cos_omega2_half_tau*(-t4 + u) - t13*t16 + t15*(t13 - t6);
    residual[1] = cos_omega1_half_tau*(t17 - t18 + w) + cos_omega2_half_tau*(-t17 + t18) - t15*(p1*t12 + t19*y - t19 - t20 + t7*y) + t16*(k1*k2*p1*y + k1*k3*p1*y + k1*k3 + k2*k3*p1*y - t10 - t12 - t19 - t20 - t8*y);
    residual[2] = -cos_omega3_half_tau1*t21 + cos_omega4_half_tau1*(t21 - u) - t22*t24 + t23*(t22 - 1);
    residual[3] = cos_omega3_half_tau1*(-t25 + t26 - w) + cos_omega4_half_tau1*(t25 - t26) - t23*(p4*y - p6) + t24*(p4*y - p6 - y);
}

/* Derivatives of the equations by the unknowns.
 * Operations: 194. Intermediate terms: 56. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double jacobian[16])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t6);
    const double sin_omega3_half_tau1 = sin(t6);
    const double t9 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t9);
    const double sin_omega4_half_tau1 = sin(t9);
    /* d/dtau of: functions of half_tau in contact */
    const double t12 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t12;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t12;
    const double t13 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t13;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t13;
    /* d/dtau of: functions of half_tau1 in free */
    const double t14 = (1.0/2.0)*omega3;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t14;
    const double sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t14;
    const double t15 = (1.0/2.0)*omega4;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t15;
    const double sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t15;
    /* outputs */
    const double t16 = k1*k2;
    const double t17 = k1*k3;
    const double t18 = k2*k3;
    const double t19 = (1.0/((t16 + t17 + t18)));
    const double t20 = p2*t16;
    const double t21 = p2*t17;
    const double t22 = p2*t18;
    const double t23 = t20 + t21 + t22;
    const double t24 = omega1*sin_omega1_half_tau;
    const double t25 = 1 - p1;
    const double t26 = p1*u + p2*w;
    const double t29 = p1*t16;
    const double t30 = t20*y + t21*y - t21 + t22*y + t29;
    const double t31 = omega2*sin_omega2_half_tau_by_tau*t19;
    const double t32 = omega1*sin_omega1_half_tau_by_tau*t19;
    const double t34 = p1*t17;
    const double t35 = p1*t18;
    const double t36 = t29 + t34 + t35;
    const double t37 = p3*u;
    const double t38 = p1*w;
    const double t39 = p3*t16;
    const double t40 = omega3*sin_omega3_half_tau1;
    const double t41 = p4 - 1;
    const double t42 = p4*u + p5*w;
    const double t43 = p5*y;
    const double t44 = omega4*sin_omega4_half_tau1_by_tau;
    const double t45 = omega3*sin_omega3_half_tau1_by_tau;
    const double t46 = p6*u;
    const double t47 = p4*w;
    jacobian[0] = omega2*sin_omega2_half_tau*t19*t23 - t19*t23*t24;
    jacobian[1] = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t25;
    jacobian[2] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    jacobian[3] = cos_omega1_half_tau_by_tau*t26 + cos_omega2_half_tau_by_tau*(-t26 + u) - t30*t32 + t31*(-t16 + t30);
    jacobian[4] = -omega2*sin_omega2_half_tau*t19*t36 + t19*t24*(-t16 - t17 - t18 + t36);
    jacobian[5] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    jacobian[6] = cos_omega1_half_tau*t25 + cos_omega2_half_tau*p1;
    jacobian[7] = cos_omega1_half_tau_by_tau*(t37 - t38 + w) + cos_omega2_half_tau_by_tau*(-t37 + t38) - t31*(t29*y + t34*y - t34 + t35*y - t39) + t32*(k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t16*y - t17*y + t17 - t18*y - t34 - t39);
    jacobian[8] = omega4*p5*sin_omega4_half_tau1 - p5*t40;
    jacobian[9] = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t41;
    jacobian[10] = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    jacobian[11] = -cos_omega3_half_tau1_by_tau*t42 + cos_omega4_half_tau1_by_tau*(t42 - u) + t44*(t41 + t43) - t45*(p4 + t43);
    jacobian[12] = -omega4*p4*sin_omega4_half_tau1 + t40*t41;
    jacobian[13] = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
    jacobian[14] = cos_omega3_half_tau1*t41 - cos_omega4_half_tau1*p4;
    jacobian[15] = cos_omega3_half_tau1_by_tau*(-t46 + t47 - w) + cos_omega4_half_tau1_by_tau*(t46 - t47) - t44*(p4*y - p6) + t45*(p4*y - p6 - y);
}

/* Equations and their derivatives by the unknowns, sharing all intermediate terms.
 * Operations: 219. Intermediate terms: 71. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_residual_and_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double residual[4], double jacobian[16])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t6);
    const double sin_omega3_half_tau1 = sin(t6);
    const double t9 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t9);
    const double sin_omega4_half_tau1 = sin(t9);
    /* d/dtau of: functions of half_tau in contact */
    const double t12 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t12;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t12;
    const double t13 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t13;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t13;
    /* d/dtau of: functions of half_tau1 in free */
    const double t14 = (1.0/2.0)*omega3;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t14;
    const double sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t14;
    const double t15 = (1.0/2.0)*omega4;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t15;
    const double sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t15;
    /* outputs */
    const double t16 = p1*u + p2*w;
    const double t18 = -t16 + u;
    const double t19 = k1*k2;
    const double t21 = p1*t19;
    const double t22 = k1*k3;
    const double t23 = p2*t22;
    const double t24 = t19*y;
    const double t25 = k2*k3;
    const double t26 = t25*y;
    const double t27 = p2*t24 + p2*t26 + t21 + t23*y - t23;
    const double t28 = -t19 + t27;
    const double t29 = (1.0/((t19 + t22 + t25)));
    const double t30 = omega2*t29;
    const double t31 = sin_omega2_half_tau*t30;
    const double t32 = omega1*t29;
    const double t33 = sin_omega1_half_tau*t32;
    const double t34 = p3*u;
    const double t35 = p1*w;
    const double t36 = t34 - t35 + w;
    const double t37 = -t34 + t35;
    const double t39 = p1*t22;
    const double t40 = p3*t19;
    const double t41 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t22*y + t22 - t24 - t26 - t39 - t40;
    const double t42 = p1*t26 + t21*y + t39*y - t39 - t40;
    const double t43 = p4*u + p5*w;
    const double t45 = t43 - u;
    const double t46 = p4 + p5*y;
    const double t47 = t46 - 1;
    const double t48 = omega4*sin_omega4_half_tau1;
    const double t49 = omega3*sin_omega3_half_tau1;
    const double t50 = p6*u;
    const double t51 = p4*w;
    const double t52 = -t50 + t51 - w;
    const double t53 = t50 - t51;
    const double t54 = p4*y - p6 - y;
    const double t55 = p4*y - p6;
    const double t56 = p2*t19 + p2*t25 + t23;
    const double t57 = 1 - p1;
    const double t58 = sin_omega2_half_tau_by_tau*t30;
    const double t59 = sin_omega1_half_tau_by_tau*t32;
    const double t60 = p1*t25 + t21 + t39;
    const double t61 = p4 - 1;
    const double t62 = omega4*sin_omega4_half_tau1_by_tau;
    const double t63 = omega3*sin_omega3_half_tau1_by_tau;
    residual[0] = cos_omega1_half_tau*t16 + cos_omega2_half_tau*t18 - t27*t33 + t28*t31;
    residual[1] = cos_omega1_half_tau*t36 + cos_omega2_half_tau*t37 - t31*t42 + t33*t41;
    residual[2] = -cos_omega3_half_tau1*t43 + cos_omega4_half_tau1*t45 - t46*t49 + t47*t48;
    residual[3] = cos_omega3_half_tau1*t52 + cos_omega4_half_tau1*t53 - t48*t55 + t49*t54;
    jacobian[0] = omega2*sin_omega2_half_tau*t29*t56 - t33*t56;
    jacobian[1] = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t57;
    jacobian[2] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    jacobian[3] = cos_omega1_half_tau_by_tau*t16 + cos_omega2_half_tau_by_tau*t18 - t27*t59 + t28*t58;
    jacobian[4] = -t31*t60 + t33*(-t19 - t22 - t25 + t60);
    jacobian[5] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    jacobian[6] = cos_omega1_half_tau*t57 + cos_omega2_half_tau*p1;
    jacobian[7] = cos_omega1_half_tau_by_tau*t36 + cos_omega2_half_tau_by_tau*t37 + t41*t59 - t42*t58;
    jacobian[8] = omega4*p5*sin_omega4_half_tau1 - p5*t49;
    jacobian[9] = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t61;
    jacobian[10] = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    jacobian[11] = -cos_omega3_half_tau1_by_tau*t43 + cos_omega4_half_tau1_by_tau*t45 - t46*t63 + t47*t62;
    jacobian[12] = -p4*t48 + t49*t61;
    jacobian[13] = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
    jacobian[14] = cos_omega3_half_tau1*t61 - cos_omega4_half_tau1*p4;
    jacobian[15] = cos_omega3_half_tau1_by_tau*t52 + cos_omega4_half_tau1_by_tau*t53 + t54*t63 - t55*t62;
}

/* Total derivatives of the equations by the parameters, through the spectrum too.
 * Operations: 655. Intermediate terms: 170. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_parameter_jacobian(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60],
    const double unknowns[4], double parameter_jacobian[24])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double omega1_by_k1 = spectrum_derivatives[5];
    const double omega1_by_k2 = spectrum_derivatives[6];
    const double omega1_by_k3 = spectrum_derivatives[7];
    const double omega1_by_m1 = spectrum_derivatives[8];
    const double omega1_by_m2 = spectrum_derivatives[9];
    const double omega2_by_k1 = spectrum_derivatives[10];
    const double omega2_by_k2 = spectrum_derivatives[11];
    const double omega2_by_k3 = spectrum_derivatives[12];
    const double omega2_by_m1 = spectrum_derivatives[13];
    const double omega2_by_m2 = spectrum_derivatives[14];
    const double p1_by_k1 = spectrum_derivatives[15];
    const double p1_by_k2 = spectrum_derivatives[16];
    const double p1_by_k3 = spectrum_derivatives[17];
    const double p1_by_m1 = spectrum_derivatives[18];
    const double p1_by_m2 = spectrum_derivatives[19];
    const double p2_by_k1 = spectrum_derivatives[20];
    const double p2_by_k2 = spectrum_derivatives[21];
    const double p2_by_k3 = spectrum_derivatives[22];
    const double p2_by_m1 = spectrum_derivatives[23];
    const double p2_by_m2 = spectrum_derivatives[24];
    const double p3_by_k1 = spectrum_derivatives[25];
    const double p3_by_k2 = spectrum_derivatives[26];
    const double p3_by_k3 = spectrum_derivatives[27];
    const double p3_by_m1 = spectrum_derivatives[28];
    const double p3_by_m2 = spectrum_derivatives[29];
    const double omega3_by_k1 = spectrum_derivatives[35];
    const double omega3_by_k2 = spectrum_derivatives[36];
    const double omega3_by_k3 = spectrum_derivatives[37];
    const double omega3_by_m1 = spectrum_derivatives[38];
    const double omega3_by_m2 = spectrum_derivatives[39];
    const double omega4_by_k1 = spectrum_derivatives[40];
    const double omega4_by_k2 = spectrum_derivatives[41];
    const double omega4_by_k3 = spectrum_derivatives[42];
    const double omega4_by_m1 = spectrum_derivatives[43];
    const double omega4_by_m2 = spectrum_derivatives[44];
    const double p4_by_k1 = spectrum_derivatives[45];
    const double p4_by_k2 = spectrum_derivatives[46];
    const double p4_by_k3 = spectrum_derivatives[47];
    const double p4_by_m1 = spectrum_derivatives[48];
    const double p4_by_m2 = spectrum_derivatives[49];
    const double p5_by_k1 = spectrum_derivatives[50];
    const double p5_by_k2 = spectrum_derivatives[51];
    const double p5_by_k3 = spectrum_derivatives[52];
    const double p5_by_m1 = spectrum_derivatives[53];
    const double p5_by_m2 = spectrum_derivatives[54];
    const double p6_by_k1 = spectrum_derivatives[55];
    const double p6_by_k2 = spectrum_derivatives[56];
    const double p6_by_k3 = spectrum_derivatives[57];
    const double p6_by_m1 = spectrum_derivatives[58];
    const double p6_by_m2 = spectrum_derivatives[59];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t6);
    const double sin_omega3_half_tau1 = sin(t6);
    const double t9 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t9);
    const double sin_omega4_half_tau1 = sin(t9);
    /* d/dm1 of: functions of half_tau in contact */
    const double t12 = half_tau*omega1_by_m1;
    const double cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t12;
    const double sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t12;
    const double t13 = half_tau*omega2_by_m1;
    const double cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t13;
    const double sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t13;
    /* d/dm2 of: functions of half_tau in contact */
    const double t14 = half_tau*omega1_by_m2;
    const double cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t14;
    const double sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t14;
    const double t15 = half_tau*omega2_by_m2;
    const double cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t15;
    const double sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t15;
    /* d/dk1 of: functions of half_tau in contact */
    const double t16 = half_tau*omega1_by_k1;
    const double cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t16;
    const double sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t16;
    const double t17 = half_tau*omega2_by_k1;
    const double cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t17;
    const double sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t17;
    /* d/dk2 of: functions of half_tau in contact */
    const double t18 = half_tau*omega1_by_k2;
    const double cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t18;
    const double sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t18;
    const double t19 = half_tau*omega2_by_k2;
    const double cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t19;
    const double sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t19;
    /* d/dk3 of: functions of half_tau in contact */
    const double t20 = half_tau*omega1_by_k3;
    const double cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t20;
    const double sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t20;
    const double t21 = half_tau*omega2_by_k3;
    const double cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t21;
    const double sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t21;
    /* d/dm1 of: functions of half_tau1 in free */
    const double t22 = half_tau1*omega3_by_m1;
    const double cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t22;
    const double sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t22;
    const double t23 = half_tau1*omega4_by_m1;
    const double cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t23;
    const double sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t23;
    /* d/dm2 of: functions of half_tau1 in free */
    const double t24 = half_tau1*omega3_by_m2;
    const double cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t24;
    const double sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t24;
    const double t25 = half_tau1*omega4_by_m2;
    const double cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t25;
    const double sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t25;
    /* d/dk1 of: functions of half_tau1 in free */
    const double t26 = half_tau1*omega3_by_k1;
    const double cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t26;
    const double sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t26;
    const double t27 = half_tau1*omega4_by_k1;
    const double cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t27;
    const double sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t27;
    /* d/dk2 of: functions of half_tau1 in free */
    const double t28 = half_tau1*omega3_by_k2;
    const double cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t28;
    const double sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t28;
    const double t29 = half_tau1*omega4_by_k2;
    const double cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t29;
    const double sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t29;
    /* d/dk3 of: functions of half_tau1 in free */
    const double t30 = half_tau1*omega3_by_k3;
    const double cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t30;
    const double sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t30;
    const double t31 = half_tau1*omega4_by_k3;
    const double cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t31;
    const double sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t31;
    /* d/dT of: functions of half_tau1 in free */
    const double t32 = (1.0/2.0)*omega3;
    const double cos_omega3_half_tau1_by_T = -sin_omega3_half_tau1*t32;
    const double sin_omega3_half_tau1_by_T = cos_omega3_half_tau1*t32;
    const double t33 = (1.0/2.0)*omega4;
    const double cos_omega4_half_tau1_by_T = -sin_omega4_half_tau1*t33;
    const double sin_omega4_half_tau1_by_T = cos_omega4_half_tau1*t33;
    /* outputs */
    const double t34 = p1*u + p2*w;
    const double t36 = -t34 + u;
    const double t37 = k1*k2;
    const double t38 = k1*k3;
    const double t39 = k2*k3;
    const double t40 = t37 + t38 + t39;
    const double t41 = (1.0/(t40));
    const double t42 = omega2*sin_omega2_half_tau;
    const double t43 = t41*t42;
    const double t44 = omega1*sin_omega1_half_tau;
    const double t45 = t41*t44;
    const double t46 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t37*t43 - t37*t45;
    const double t47 = t37*y;
    const double t48 = t38*y;
    const double t49 = t39*y;
    const double t50 = -t38 + t47 + t48 + t49;
    const double t51 = t41*t50;
    const double t52 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t42*t51 - t44*t51;
    const double t53 = p1*t37 - p2*t38 + p2*t47 + p2*t48 + p2*t49;
    const double t54 = -t37 + t53;
    const double t55 = t41*t54;
    const double t56 = sin_omega2_half_tau*t55;
    const double t57 = omega2*t55;
    const double t58 = t41*t53;
    const double t59 = sin_omega1_half_tau*t58;
    const double t60 = omega1*t58;
    const double t61 = k2*p1;
    const double t62 = k3*p2;
    const double t63 = k2*y;
    const double t64 = p2*t63;
    const double t65 = t62*y;
    const double t66 = t61 - t62 + t64 + t65;
    const double t67 = (1.0/(t40*t40));
    const double t68 = t67*(-k2 - k3);
    const double t69 = t42*t54;
    const double t70 = t44*t53;
    const double t71 = k1*p1;
    const double t72 = k1*p2;
    const double t73 = t72*y;
    const double t74 = t65 + t71 + t73;
    const double t75 = t67*(-k1 - k3);
    const double t76 = t64 - t72 + t73;
    const double t77 = t67*(-k1 - k2);
    const double t78 = p3*u;
    const double t79 = p1*w;
    const double t80 = t78 - t79 + w;
    const double t81 = -t78 + t79;
    const double t83 = p1*t38;
    const double t84 = p3*t37;
    const double t85 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t50 - t83 - t84;
    const double t86 = t41*t85;
    const double t87 = sin_omega1_half_tau*t86;
    const double t88 = omega1*t86;
    const double t89 = p1*t47 + p1*t48 + p1*t49 - t83 - t84;
    const double t90 = t41*t89;
    const double t91 = sin_omega2_half_tau*t90;
    const double t92 = omega2*t90;
    const double t93 = k3*p1;
    const double t94 = k2*p3;
    const double t95 = -k3*p1*y + k3*y;
    const double t96 = t61*y;
    const double t97 = t93*y;
    const double t98 = t44*t85;
    const double t99 = t42*t89;
    const double t100 = k1*p3;
    const double t101 = k1*y;
    const double t102 = t71*y;
    const double t103 = t102 - t71 + t96;
    const double t104 = p4*u + p5*w;
    const double t106 = t104 - u;
    const double t107 = omega3*sin_omega3_half_tau1;
    const double t108 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + omega4*sin_omega4_half_tau1 - t107;
    const double t109 = cos_omega3_half_tau1*w - cos_omega4_half_tau1*w - omega4*sin_omega4_half_tau1*y + t107*y;
    const double t111 = p4 + p5*y;
    const double t112 = t111 - 1;
    const double t113 = sin_omega4_half_tau1*t112;
    const double t114 = omega4*t112;
    const double t115 = sin_omega3_half_tau1*t111;
    const double t116 = omega3*t111;
    const double t117 = p6*u;
    const double t118 = p4*w;
    const double t119 = -t117 + t118 - w;
    const double t120 = t117 - t118;
    const double t121 = p4*y - p6 - y;
    const double t122 = sin_omega3_half_tau1*t121;
    const double t123 = omega3*t121;
    const double t124 = p4*y - p6;
    const double t125 = sin_omega4_half_tau1*t124;
    const double t126 = omega4*t124;
    parameter_jacobian[0] = cos_omega1_half_tau_by_m1*t34 + cos_omega2_half_tau_by_m1*t36 - omega1_by_m1*t59 + omega2_by_m1*t56 + p1_by_m1*t46 + p2_by_m1*t52 - sin_omega1_half_tau_by_m1*t60 + sin_omega2_half_tau_by_m1*t57;
    parameter_jacobian[1] = cos_omega1_half_tau_by_m2*t34 + cos_omega2_half_tau_by_m2*t36 - omega1_by_m2*t59 + omega2_by_m2*t56 + p1_by_m2*t46 + p2_by_m2*t52 - sin_omega1_half_tau_by_m2*t60 + sin_omega2_half_tau_by_m2*t57;
    parameter_jacobian[2] = cos_omega1_half_tau_by_k1*t34 + cos_omega2_half_tau_by_k1*t36 - omega1_by_k1*t59 + omega2_by_k1*t56 + p1_by_k1*t46 + p2_by_k1*t52 - sin_omega1_half_tau_by_k1*t60 + sin_omega2_half_tau_by_k1*t57 + t43*(-k2 + t66) - t45*t66 + t68*t69 - t68*t70;
    parameter_jacobian[3] = cos_omega1_half_tau_by_k2*t34 + cos_omega2_half_tau_by_k2*t36 - omega1_by_k2*t59 + omega2_by_k2*t56 + p1_by_k2*t46 + p2_by_k2*t52 - sin_omega1_half_tau_by_k2*t60 + sin_omega2_half_tau_by_k2*t57 + t43*(-k1 + t74) - t45*t74 + t69*t75 - t70*t75;
    parameter_jacobian[4] = cos_omega1_half_tau_by_k3*t34 + cos_omega2_half_tau_by_k3*t36 - omega1_by_k3*t59 + omega2_by_k3*t56 + p1_by_k3*t46 + p2_by_k3*t52 - sin_omega1_half_tau_by_k3*t60 + sin_omega2_half_tau_by_k3*t57 + t43*t76 - t45*t76 + t69*t77 - t70*t77;
    parameter_jacobian[5] = 0;
    parameter_jacobian[6] = cos_omega1_half_tau_by_m1*t80 + cos_omega2_half_tau_by_m1*t81 + omega1_by_m1*t87 - omega2_by_m1*t91 - p1_by_m1*t52 + p3_by_m1*t46 + sin_omega1_half_tau_by_m1*t88 - sin_omega2_half_tau_by_m1*t92;
    parameter_jacobian[7] = cos_omega1_half_tau_by_m2*t80 + cos_omega2_half_tau_by_m2*t81 + omega1_by_m2*t87 - omega2_by_m2*t91 - p1_by_m2*t52 + p3_by_m2*t46 + sin_omega1_half_tau_by_m2*t88 - sin_omega2_half_tau_by_m2*t92;
    parameter_jacobian[8] = cos_omega1_half_tau_by_k1*t80 + cos_omega2_half_tau_by_k1*t81 + omega1_by_k1*t87 - omega2_by_k1*t91 - p1_by_k1*t52 + p3_by_k1*t46 + sin_omega1_half_tau_by_k1*t88 - sin_omega2_half_tau_by_k1*t92 - t43*(-t93 - t94 + t96 + t97) + t45*(k2*p1*y + k3 - t63 - t93 - t94 - t95) + t68*t98 - t68*t99;
    parameter_jacobian[9] = cos_omega1_half_tau_by_k2*t80 + cos_omega2_half_tau_by_k2*t81 + omega1_by_k2*t87 - omega2_by_k2*t91 - p1_by_k2*t52 + p3_by_k2*t46 + sin_omega1_half_tau_by_k2*t88 - sin_omega2_half_tau_by_k2*t92 - t43*(-t100 + t102 + t97) + t45*(k1*p1*y - t100 - t101 - t95) + t75*t98 - t75*t99;
    parameter_jacobian[10] = cos_omega1_half_tau_by_k3*t80 + cos_omega2_half_tau_by_k3*t81 + omega1_by_k3*t87 - omega2_by_k3*t91 - p1_by_k3*t52 + p3_by_k3*t46 + sin_omega1_half_tau_by_k3*t88 - sin_omega2_half_tau_by_k3*t92 - t103*t43 + t45*(k1 - t101 + t103 - t63) + t77*t98 - t77*t99;
    parameter_jacobian[11] = 0;
    parameter_jacobian[12] = -cos_omega3_half_tau1_by_m1*t104 + cos_omega4_half_tau1_by_m1*t106 - omega3_by_m1*t115 + omega4_by_m1*t113 + p4_by_m1*t108 - p5_by_m1*t109 - sin_omega3_half_tau1_by_m1*t116 + sin_omega4_half_tau1_by_m1*t114;
    parameter_jacobian[13] = -cos_omega3_half_tau1_by_m2*t104 + cos_omega4_half_tau1_by_m2*t106 - omega3_by_m2*t115 + omega4_by_m2*t113 + p4_by_m2*t108 - p5_by_m2*t109 - sin_omega3_half_tau1_by_m2*t116 + sin_omega4_half_tau1_by_m2*t114;
    parameter_jacobian[14] = -cos_omega3_half_tau1_by_k1*t104 + cos_omega4_half_tau1_by_k1*t106 - omega3_by_k1*t115 + omega4_by_k1*t113 + p4_by_k1*t108 - p5_by_k1*t109 - sin_omega3_half_tau1_by_k1*t116 + sin_omega4_half_tau1_by_k1*t114;
    parameter_jacobian[15] = -cos_omega3_half_tau1_by_k2*t104 + cos_omega4_half_tau1_by_k2*t106 - omega3_by_k2*t115 + omega4_by_k2*t113 + p4_by_k2*t108 - p5_by_k2*t109 - sin_omega3_half_tau1_by_k2*t116 + sin_omega4_half_tau1_by_k2*t114;
    parameter_jacobian[16] = -cos_omega3_half_tau1_by_k3*t104 + cos_omega4_half_tau1_by_k3*t106 - omega3_by_k3*t115 + omega4_by_k3*t113 + p4_by_k3*t108 - p5_by_k3*t109 - sin_omega3_half_tau1_by_k3*t116 + sin_omega4_half_tau1_by_k3*t114;
    parameter_jacobian[17] = -cos_omega3_half_tau1_by_T*t104 + cos_omega4_half_tau1_by_T*t106 - sin_omega3_half_tau1_by_T*t116 + sin_omega4_half_tau1_by_T*t114;
    parameter_jacobian[18] = cos_omega3_half_tau1_by_m1*t119 + cos_omega4_half_tau1_by_m1*t120 + omega3_by_m1*t122 - omega4_by_m1*t125 + p4_by_m1*t109 + p6_by_m1*t108 + sin_omega3_half_tau1_by_m1*t123 - sin_omega4_half_tau1_by_m1*t126;
    parameter_jacobian[19] = cos_omega3_half_tau1_by_m2*t119 + cos_omega4_half_tau1_by_m2*t120 + omega3_by_m2*t122 - omega4_by_m2*t125 + p4_by_m2*t109 + p6_by_m2*t108 + sin_omega3_half_tau1_by_m2*t123 - sin_omega4_half_tau1_by_m2*t126;
    parameter_jacobian[20] = cos_omega3_half_tau1_by_k1*t119 + cos_omega4_half_tau1_by_k1*t120 + omega3_by_k1*t122 - omega4_by_k1*t125 + p4_by_k1*t109 + p6_by_k1*t108 + sin_omega3_half_tau1_by_k1*t123 - sin_omega4_half_tau1_by_k1*t126;
    parameter_jacobian[21] = cos_omega3_half_tau1_by_k2*t119 + cos_omega4_half_tau1_by_k2*t120 + omega3_by_k2*t122 - omega4_by_k2*t125 + p4_by_k2*t109 + p6_by_k2*t108 + sin_omega3_half_tau1_by_k2*t123 - sin_omega4_half_tau1_by_k2*t126;
    parameter_jacobian[22] = cos_omega3_half_tau1_by_k3*t119 + cos_omega4_half_tau1_by_k3*t120 + omega3_by_k3*t122 - omega4_by_k3*t125 + p4_by_k3*t109 + p6_by_k3*t108 + sin_omega3_half_tau1_by_k3*t123 - sin_omega4_half_tau1_by_k3*t126;
    parameter_jacobian[23] = cos_omega3_half_tau1_by_T*t119 + cos_omega4_half_tau1_by_T*t120 + sin_omega3_half_tau1_by_T*t123 - sin_omega4_half_tau1_by_T*t126;
}

/* Jacobian of the Poincare map in the section's coordinates.
 * Operations: 372. Intermediate terms: 127. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_poincare_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double poincare_jacobian[9])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = p1 - 1;
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau*t10;
    const double t13 = sin_omega2_tau/omega2;
    const double t14 = p1*t11 - t13*t9;
    const double t15 = p2*sin_omega1_tau*t10 - p2*t13;
    const double t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9;
    const double x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5;
    const double t18 = p3*t5;
    const double t20 = p1*t7;
    const double t21 = p3*sin_omega1_tau*t10 - p3*t13;
    const double t22 = p1*t13 - t11*t9;
    const double t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1;
    const double t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7;
    const double t25 = omega1*sin_omega1_tau;
    const double t26 = omega2*p2*sin_omega2_tau - p2*t25;
    const double t27 = omega2*sin_omega2_tau;
    const double v1_1 = -p1*t25 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y + t27*t9;
    const double t28 = -p1*t27 + t25*t9;
    const double v2_1 = -p3*t25 + p3*t27 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t28*y;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t29 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t29);
    const double sin_omega3_tau1 = sin(t29);
    const double t30 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t30);
    const double sin_omega4_tau1 = sin(t30);
    /* free for tau1, until first-reaches-stop */
    const double t31 = (1.0/(omega3));
    const double t32 = sin_omega3_tau1*t31;
    const double t33 = 1 - p4;
    const double t34 = sin_omega4_tau1/omega4;
    const double t35 = p4*t32 + t33*t34;
    const double t36 = p5*sin_omega3_tau1*t31 - p5*t34;
    const double t37 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33;
    const double t38 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t35*v1_1 + t36*v2_1 + t37*x1_1 + t38*x2_1;
    const double t39 = p6*sin_omega3_tau1*t31 - p6*t34;
    const double t40 = p4*t34 + t32*t33;
    const double t41 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t42 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4;
    const double x2_2 = t39*v1_1 + t40*v2_1 + t41*x1_1 + t42*x2_1;
    const double t43 = omega3*sin_omega3_tau1;
    const double t44 = omega4*sin_omega4_tau1;
    const double t45 = -p4*t43 - t33*t44;
    const double t46 = omega4*p5*sin_omega4_tau1 - p5*t43;
    const double v1_2 = t37*v1_1 + t38*v2_1 + t45*x1_1 + t46*x2_1;
    const double t47 = omega4*p6*sin_omega4_tau1 - p6*t43;
    const double t48 = -p4*t44 - t33*t43;
    const double v2_2 = t41*v1_1 + t42*v2_1 + t47*x1_1 + t48*x2_1;
    /* Phi along tau */
    const double carried_x1_1_by_y = t16;
    const double carried_x1_1_by_u = t14;
    const double carried_x1_1_by_w = t15;
    const double carried_x2_1_by_y = t23;
    const double carried_x2_1_by_u = t21;
    const double carried_x2_1_by_w = t22;
    const double carried_v1_1_by_y = t26;
    const double carried_v1_1_by_u = t17;
    const double carried_v1_1_by_w = t16;
    const double carried_v2_1_by_y = t28;
    const double carried_v2_1_by_u = t24;
    const double carried_v2_1_by_w = t23;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t49 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t49;
    const double delay_tau_by_u = carried_x1_1_by_u*t49;
    const double delay_tau_by_w = carried_x1_1_by_w*t49;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t50 = (1.0/(m1));
    const double t51 = k1*t50;
    const double t52 = k3*t50 - t50*x1_1*(k1 + k3) + t51*x2_1;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t52;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t52;
    const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t52;
    const double t53 = (1.0/(m2));
    const double t54 = k1*t53;
    const double t55 = t53*(k1 + k2);
    const double t56 = t54*x1_1 - t55*x2_1;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t56;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t56;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t56;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t35*v1_1_on_boundary_by_y + t36*v2_1_on_boundary_by_y + t37*x1_1_on_boundary_by_y + t38*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t35*v1_1_on_boundary_by_u + t36*v2_1_on_boundary_by_u + t37*x1_1_on_boundary_by_u + t38*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t35*v1_1_on_boundary_by_w + t36*v2_1_on_boundary_by_w + t37*x1_1_on_boundary_by_w + t38*x2_1_on_boundary_by_w;
    const double carried_x2_2_by_y = t39*v1_1_on_boundary_by_y + t40*v2_1_on_boundary_by_y + t41*x1_1_on_boundary_by_y + t42*x2_1_on_boundary_by_y;
    const double carried_x2_2_by_u = t39*v1_1_on_boundary_by_u + t40*v2_1_on_boundary_by_u + t41*x1_1_on_boundary_by_u + t42*x2_1_on_boundary_by_u;
    const double carried_x2_2_by_w = t39*v1_1_on_boundary_by_w + t40*v2_1_on_boundary_by_w + t41*x1_1_on_boundary_by_w + t42*x2_1_on_boundary_by_w;
    const double carried_v1_2_by_y = t37*v1_1_on_boundary_by_y + t38*v2_1_on_boundary_by_y + t45*x1_1_on_boundary_by_y + t46*x2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t37*v1_1_on_boundary_by_u + t38*v2_1_on_boundary_by_u + t45*x1_1_on_boundary_by_u + t46*x2_1_on_boundary_by_u;
    const double carried_v1_2_by_w = t37*v1_1_on_boundary_by_w + t38*v2_1_on_boundary_by_w + t45*x1_1_on_boundary_by_w + t46*x2_1_on_boundary_by_w;
    const double carried_v2_2_by_y = t41*v1_1_on_boundary_by_y + t42*v2_1_on_boundary_by_y + t47*x1_1_on_boundary_by_y + t48*x2_1_on_boundary_by_y;
    const double carried_v2_2_by_u = t41*v1_1_on_boundary_by_u + t42*v2_1_on_boundary_by_u + t47*x1_1_on_boundary_by_u + t48*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t41*v1_1_on_boundary_by_w + t42*v2_1_on_boundary_by_w + t47*x1_1_on_boundary_by_w + t48*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t57 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t57;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t57;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t57;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2;
    const double x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2;
    const double t58 = k1*t50*x2_2 - t51*x1_2;
    const double v1_2_on_boundary_by_y = carried_v1_2_by_y + delay_tau1_by_y*t58;
    const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t58;
    const double v1_2_on_boundary_by_w = carried_v1_2_by_w + delay_tau1_by_w*t58;
    const double t59 = t54*x1_2 - t55*x2_2;
    const double v2_2_on_boundary_by_y = carried_v2_2_by_y + delay_tau1_by_y*t59;
    const double v2_2_on_boundary_by_u = carried_v2_2_by_u + delay_tau1_by_u*t59;
    const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t59;
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

/* Saltation matrices of the transitions, one below the other.
 * Operations: 239. Intermediate terms: 63. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_saltations(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double saltations[32])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = p1 - 1;
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau*t10;
    const double t13 = sin_omega2_tau/omega2;
    const double t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t15 = cos_omega1_tau*p1 - cos_omega2_tau*t9;
    const double x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*y + t15 + t5 + u*(p1*t11 - t13*t9) + w*(p2*sin_omega1_tau*t10 - p2*t13);
    const double t16 = p3*t5;
    const double t18 = p1*t7;
    const double t19 = -cos_omega1_tau*t9 + cos_omega2_tau*p1;
    const double t20 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(-t16 + t7*t9) + cos_omega2_tau*(t16 - t18) + t19*y + t20 + t7 + u*(p3*sin_omega1_tau*t10 - p3*t13) + w*(p1*t13 - t11*t9);
    const double t21 = omega1*sin_omega1_tau;
    const double t22 = omega2*sin_omega2_tau;
    const double v1_1 = -p1*t21 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t14*w + t15*u + t22*t9 + y*(omega2*p2*sin_omega2_tau - p2*t21);
    const double v2_1 = -p3*t21 + p3*t22 + sin_omega1_tau*(omega1*t16 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t16 + omega2*t18) + t19*w + t20*u + y*(-p1*t22 + t21*t9);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t23 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t23);
    const double sin_omega3_tau1 = sin(t23);
    const double t24 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t24);
    const double sin_omega4_tau1 = sin(t24);
    /* free for tau1, until first-reaches-stop */
    const double t25 = (1.0/(omega3));
    const double t26 = sin_omega3_tau1*t25;
    const double t27 = 1 - p4;
    const double t28 = sin_omega4_tau1/omega4;
    const double t29 = cos_omega3_tau1*p4 + cos_omega4_tau1*t27;
    const double t30 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t29*x1_1 + t30*x2_1 + v1_1*(p4*t26 + t27*t28) + v2_1*(p5*sin_omega3_tau1*t25 - p5*t28);
    const double x2_2 = v1_1*(p6*sin_omega3_tau1*t25 - p6*t28) + v2_1*(p4*t28 + t26*t27) + x1_1*(cos_omega3_tau1*p6 - cos_omega4_tau1*p6) + x2_1*(cos_omega3_tau1*t27 + cos_omega4_tau1*p4);
    const double t31 = omega3*sin_omega3_tau1;
    const double v1_2 = t29*v1_1 + t30*v2_1 + x1_1*(-omega4*sin_omega4_tau1*t27 - p4*t31) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t31);
    /* vector fields at transition 1 */
    const double t32 = (1.0/(m1));
    const double t33 = k3*t32;
    const double t34 = k1*t32;
    const double t35 = t32*(k1 + k3);
    const double before_v1_1 = t33 + t34*x2_1 - t35*x1_1;
    const double t36 = (1.0/(m2));
    const double t37 = k1*t36;
    const double t38 = t36*(k1 + k2);
    const double before_v2_1 = t37*x1_1 - t38*x2_1;
    const double behind_v1_1 = k1*t32*x2_1 - t34*x1_1;
    const double behind_v2_1 = before_v2_1;
    /* vector fields at transition 2 */
    const double before_v1_2 = k1*t32*x2_2 - t34*x1_2;
    const double before_v2_2 = t37*x1_2 - t38*x2_2;
    const double behind_v1_2 = t33 + t34*x2_2 - t35*x1_2;
    const double behind_v2_2 = before_v2_2;
    /* outputs */
    const double t41 = (1.0/(v1_1));
    const double t42 = (1.0/(v1_2));
    saltations[0] = 1;
    saltations[1] = 0;
    saltations[2] = 0;
    saltations[3] = 0;
    saltations[4] = 0;
    saltations[5] = 1;
    saltations[6] = 0;
    saltations[7] = 0;
    saltations[8] = -t41*(before_v1_1 - behind_v1_1);
    saltations[9] = 0;
    saltations[10] = 1;
    saltations[11] = 0;
    saltations[12] = -t41*(before_v2_1 - behind_v2_1);
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
    saltations[24] = t42*(-before_v1_2 + behind_v1_2);
    saltations[25] = 0;
    saltations[26] = 1;
    saltations[27] = 0;
    saltations[28] = t42*(-before_v2_2 + behind_v2_2);
    saltations[29] = 0;
    saltations[30] = 0;
    saltations[31] = 1;
}

/* Monodromy matrix: the product of flows and saltation matrices over a period.
 * Operations: 395. Intermediate terms: 135. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_monodromy(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double monodromy[16])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = p1 - 1;
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau*t10;
    const double t13 = sin_omega2_tau/omega2;
    const double t14 = p1*t11 - t13*t9;
    const double t15 = p2*sin_omega1_tau*t10 - p2*t13;
    const double t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9;
    const double x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5;
    const double t18 = p3*t5;
    const double t20 = p1*t7;
    const double t21 = p3*sin_omega1_tau*t10 - p3*t13;
    const double t22 = p1*t13 - t11*t9;
    const double t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1;
    const double t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7;
    const double t25 = omega1*sin_omega1_tau;
    const double t26 = omega2*p2*sin_omega2_tau - p2*t25;
    const double t27 = p1*t25;
    const double t28 = omega2*sin_omega2_tau;
    const double t29 = -t28*t9;
    const double v1_1 = sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y - t27 - t29;
    const double t30 = -p1*t28 + t25*t9;
    const double t31 = p3*t25;
    const double v2_1 = p3*t28 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t30*y - t31;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t32 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t32);
    const double sin_omega3_tau1 = sin(t32);
    const double t33 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t33);
    const double sin_omega4_tau1 = sin(t33);
    /* free for tau1, until first-reaches-stop */
    const double t34 = (1.0/(omega3));
    const double t35 = sin_omega3_tau1*t34;
    const double t36 = 1 - p4;
    const double t37 = sin_omega4_tau1/omega4;
    const double t38 = p4*t35 + t36*t37;
    const double t39 = p5*sin_omega3_tau1*t34 - p5*t37;
    const double t40 = cos_omega3_tau1*p4 + cos_omega4_tau1*t36;
    const double t41 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t38*v1_1 + t39*v2_1 + t40*x1_1 + t41*x2_1;
    const double t42 = p6*sin_omega3_tau1*t34 - p6*t37;
    const double t43 = p4*t37 + t35*t36;
    const double t44 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t45 = cos_omega3_tau1*t36 + cos_omega4_tau1*p4;
    const double x2_2 = t42*v1_1 + t43*v2_1 + t44*x1_1 + t45*x2_1;
    const double t46 = omega3*sin_omega3_tau1;
    const double t47 = omega4*sin_omega4_tau1;
    const double t48 = -p4*t46 - t36*t47;
    const double t49 = omega4*p5*sin_omega4_tau1 - p5*t46;
    const double v1_2 = t40*v1_1 + t41*v2_1 + t48*x1_1 + t49*x2_1;
    /* vector fields at transition 1 */
    const double t50 = (1.0/(m1));
    const double t51 = k3*t50;
    const double t52 = k1*t50;
    const double t53 = t50*(k1 + k3);
    const double before_v1_1 = t51 + t52*x2_1 - t53*x1_1;
    const double t54 = (1.0/(m2));
    const double t55 = k1*t54;
    const double t56 = t54*(k1 + k2);
    const double before_v2_1 = t55*x1_1 - t56*x2_1;
    const double behind_v1_1 = k1*t50*x2_1 - t52*x1_1;
    const double behind_v2_1 = before_v2_1;
    /* vector fields at transition 2 */
    const double before_v1_2 = k1*t50*x2_2 - t52*x1_2;
    const double before_v2_2 = t55*x1_2 - t56*x2_2;
    const double behind_v1_2 = t51 + t52*x2_2 - t53*x1_2;
    const double behind_v2_2 = before_v2_2;
    /* Phi of phase 1 */
    const double phi_1_00 = t17;
    const double phi_1_01 = t16;
    const double phi_1_02 = t14;
    const double phi_1_03 = t15;
    const double phi_1_10 = t24;
    const double phi_1_11 = t23;
    const double phi_1_12 = t21;
    const double phi_1_13 = t22;
    const double phi_1_20 = -t27 - t29;
    const double phi_1_21 = t26;
    const double phi_1_22 = t17;
    const double phi_1_23 = t16;
    const double phi_1_30 = omega2*p3*sin_omega2_tau - t31;
    const double phi_1_31 = t30;
    const double phi_1_32 = t24;
    const double phi_1_33 = t23;
    /* saltation of phase 1 */
    const double t59 = (1.0/(v1_1));
    const double t60 = t59*(before_v1_1 - behind_v1_1);
    const double saltation_1_20 = -phi_1_00*t60 + phi_1_20;
    const double saltation_1_21 = -phi_1_01*t60 + phi_1_21;
    const double saltation_1_22 = -phi_1_02*t60 + phi_1_22;
    const double saltation_1_23 = -phi_1_03*t60 + phi_1_23;
    const double t61 = t59*(before_v2_1 - behind_v2_1);
    const double saltation_1_30 = -phi_1_00*t61 + phi_1_30;
    const double saltation_1_31 = -phi_1_01*t61 + phi_1_31;
    const double saltation_1_32 = -phi_1_02*t61 + phi_1_32;
    const double saltation_1_33 = -phi_1_03*t61 + phi_1_33;
    /* Phi of phase 2 */
    const double phi_2_00 = phi_1_00*t40 + phi_1_10*t41 + saltation_1_20*t38 + saltation_1_30*t39;
    const double phi_2_01 = phi_1_01*t40 + phi_1_11*t41 + saltation_1_21*t38 + saltation_1_31*t39;
    const double phi_2_02 = phi_1_02*t40 + phi_1_12*t41 + saltation_1_22*t38 + saltation_1_32*t39;
    const double phi_2_03 = phi_1_03*t40 + phi_1_13*t41 + saltation_1_23*t38 + saltation_1_33*t39;
    const double phi_2_10 = phi_1_00*t44 + phi_1_10*t45 + saltation_1_20*t42 + saltation_1_30*t43;
    const double phi_2_11 = phi_1_01*t44 + phi_1_11*t45 + saltation_1_21*t42 + saltation_1_31*t43;
    const double phi_2_12 = phi_1_02*t44 + phi_1_12*t45 + saltation_1_22*t42 + saltation_1_32*t43;
    const double phi_2_13 = phi_1_03*t44 + phi_1_13*t45 + saltation_1_23*t42 + saltation_1_33*t43;
    const double phi_2_20 = phi_1_00*t48 + phi_1_10*t49 + saltation_1_20*t40 + saltation_1_30*t41;
    const double phi_2_21 = phi_1_01*t48 + phi_1_11*t49 + saltation_1_21*t40 + saltation_1_31*t41;
    const double phi_2_22 = phi_1_02*t48 + phi_1_12*t49 + saltation_1_22*t40 + saltation_1_32*t41;
    const double phi_2_23 = phi_1_03*t48 + phi_1_13*t49 + saltation_1_23*t40 + saltation_1_33*t41;
    const double t62 = omega4*p6*sin_omega4_tau1 - p6*t46;
    const double t63 = -p4*t47 - t36*t46;
    const double phi_2_30 = phi_1_00*t62 + phi_1_10*t63 + saltation_1_20*t44 + saltation_1_30*t45;
    const double phi_2_31 = phi_1_01*t62 + phi_1_11*t63 + saltation_1_21*t44 + saltation_1_31*t45;
    const double phi_2_32 = phi_1_02*t62 + phi_1_12*t63 + saltation_1_22*t44 + saltation_1_32*t45;
    const double phi_2_33 = phi_1_03*t62 + phi_1_13*t63 + saltation_1_23*t44 + saltation_1_33*t45;
    /* saltation of phase 2 */
    const double t64 = (1.0/(v1_2));
    const double t65 = t64*(-before_v1_2 + behind_v1_2);
    const double saltation_2_20 = phi_2_00*t65 + phi_2_20;
    const double saltation_2_21 = phi_2_01*t65 + phi_2_21;
    const double saltation_2_22 = phi_2_02*t65 + phi_2_22;
    const double saltation_2_23 = phi_2_03*t65 + phi_2_23;
    const double t66 = t64*(-before_v2_2 + behind_v2_2);
    const double saltation_2_30 = phi_2_00*t66 + phi_2_30;
    const double saltation_2_31 = phi_2_01*t66 + phi_2_31;
    const double saltation_2_32 = phi_2_02*t66 + phi_2_32;
    const double saltation_2_33 = phi_2_03*t66 + phi_2_33;
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

/* Trace of the Poincare map's Jacobian.
 * Operations: 320. Intermediate terms: 113. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_trace(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *trace)
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = p1 - 1;
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau*t10;
    const double t13 = sin_omega2_tau/omega2;
    const double t14 = p1*t11 - t13*t9;
    const double t15 = p2*sin_omega1_tau*t10 - p2*t13;
    const double t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9;
    const double x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5;
    const double t18 = p3*t5;
    const double t20 = p1*t7;
    const double t21 = p3*sin_omega1_tau*t10 - p3*t13;
    const double t22 = p1*t13 - t11*t9;
    const double t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1;
    const double t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7;
    const double t25 = omega1*sin_omega1_tau;
    const double t26 = omega2*p2*sin_omega2_tau - p2*t25;
    const double t27 = omega2*sin_omega2_tau;
    const double v1_1 = -p1*t25 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y + t27*t9;
    const double t28 = -p1*t27 + t25*t9;
    const double v2_1 = -p3*t25 + p3*t27 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t28*y;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t29 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t29);
    const double sin_omega3_tau1 = sin(t29);
    const double t30 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t30);
    const double sin_omega4_tau1 = sin(t30);
    /* free for tau1, until first-reaches-stop */
    const double t31 = (1.0/(omega3));
    const double t32 = sin_omega3_tau1*t31;
    const double t33 = 1 - p4;
    const double t34 = sin_omega4_tau1/omega4;
    const double t35 = p4*t32 + t33*t34;
    const double t36 = p5*sin_omega3_tau1*t31 - p5*t34;
    const double t37 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33;
    const double t38 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t35*v1_1 + t36*v2_1 + t37*x1_1 + t38*x2_1;
    const double t39 = p6*sin_omega3_tau1*t31 - p6*t34;
    const double t40 = p4*t34 + t32*t33;
    const double t41 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t42 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4;
    const double x2_2 = t39*v1_1 + t40*v2_1 + t41*x1_1 + t42*x2_1;
    const double t43 = omega3*sin_omega3_tau1;
    const double t44 = omega4*sin_omega4_tau1;
    const double t45 = -p4*t43 - t33*t44;
    const double t46 = omega4*p5*sin_omega4_tau1 - p5*t43;
    const double v1_2 = t37*v1_1 + t38*v2_1 + t45*x1_1 + t46*x2_1;
    const double t47 = omega4*p6*sin_omega4_tau1 - p6*t43;
    const double t48 = -p4*t44 - t33*t43;
    const double v2_2 = t41*v1_1 + t42*v2_1 + t47*x1_1 + t48*x2_1;
    /* Phi along tau */
    const double carried_x1_1_by_y = t16;
    const double carried_x1_1_by_u = t14;
    const double carried_x1_1_by_w = t15;
    const double carried_x2_1_by_y = t23;
    const double carried_x2_1_by_u = t21;
    const double carried_x2_1_by_w = t22;
    const double carried_v1_1_by_y = t26;
    const double carried_v1_1_by_u = t17;
    const double carried_v1_1_by_w = t16;
    const double carried_v2_1_by_y = t28;
    const double carried_v2_1_by_u = t24;
    const double carried_v2_1_by_w = t23;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t49 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t49;
    const double delay_tau_by_u = carried_x1_1_by_u*t49;
    const double delay_tau_by_w = carried_x1_1_by_w*t49;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t50 = (1.0/(m1));
    const double t51 = k1*t50;
    const double t52 = k3*t50 - t50*x1_1*(k1 + k3) + t51*x2_1;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t52;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t52;
    const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t52;
    const double t53 = (1.0/(m2));
    const double t54 = k1*t53;
    const double t55 = t53*(k1 + k2);
    const double t56 = t54*x1_1 - t55*x2_1;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t56;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t56;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t56;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t35*v1_1_on_boundary_by_y + t36*v2_1_on_boundary_by_y + t37*x1_1_on_boundary_by_y + t38*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t35*v1_1_on_boundary_by_u + t36*v2_1_on_boundary_by_u + t37*x1_1_on_boundary_by_u + t38*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t35*v1_1_on_boundary_by_w + t36*v2_1_on_boundary_by_w + t37*x1_1_on_boundary_by_w + t38*x2_1_on_boundary_by_w;
    const double carried_x2_2_by_y = t39*v1_1_on_boundary_by_y + t40*v2_1_on_boundary_by_y + t41*x1_1_on_boundary_by_y + t42*x2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t37*v1_1_on_boundary_by_u + t38*v2_1_on_boundary_by_u + t45*x1_1_on_boundary_by_u + t46*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t41*v1_1_on_boundary_by_w + t42*v2_1_on_boundary_by_w + t47*x1_1_on_boundary_by_w + t48*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t57 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t57;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t57;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t57;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*(k1*t50*x2_2 - t51*x1_2);
    const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*(t54*x1_2 - t55*x2_2);
    *trace = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y;
}

/* Derivatives of the trace by the unknowns, then in total by the parameters.
 * Operations: 4407. Intermediate terms: 955. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_trace_gradient(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60],
    const double unknowns[4], double trace_gradient[10])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double omega1_by_k1 = spectrum_derivatives[5];
    const double omega1_by_k2 = spectrum_derivatives[6];
    const double omega1_by_k3 = spectrum_derivatives[7];
    const double omega1_by_m1 = spectrum_derivatives[8];
    const double omega1_by_m2 = spectrum_derivatives[9];
    const double omega2_by_k1 = spectrum_derivatives[10];
    const double omega2_by_k2 = spectrum_derivatives[11];
    const double omega2_by_k3 = spectrum_derivatives[12];
    const double omega2_by_m1 = spectrum_derivatives[13];
    const double omega2_by_m2 = spectrum_derivatives[14];
    const double p1_by_k1 = spectrum_derivatives[15];
    const double p1_by_k2 = spectrum_derivatives[16];
    const double p1_by_k3 = spectrum_derivatives[17];
    const double p1_by_m1 = spectrum_derivatives[18];
    const double p1_by_m2 = spectrum_derivatives[19];
    const double p2_by_k1 = spectrum_derivatives[20];
    const double p2_by_k2 = spectrum_derivatives[21];
    const double p2_by_k3 = spectrum_derivatives[22];
    const double p2_by_m1 = spectrum_derivatives[23];
    const double p2_by_m2 = spectrum_derivatives[24];
    const double p3_by_k1 = spectrum_derivatives[25];
    const double p3_by_k2 = spectrum_derivatives[26];
    const double p3_by_k3 = spectrum_derivatives[27];
    const double p3_by_m1 = spectrum_derivatives[28];
    const double p3_by_m2 = spectrum_derivatives[29];
    const double omega3_by_k1 = spectrum_derivatives[35];
    const double omega3_by_k2 = spectrum_derivatives[36];
    const double omega3_by_k3 = spectrum_derivatives[37];
    const double omega3_by_m1 = spectrum_derivatives[38];
    const double omega3_by_m2 = spectrum_derivatives[39];
    const double omega4_by_k1 = spectrum_derivatives[40];
    const double omega4_by_k2 = spectrum_derivatives[41];
    const double omega4_by_k3 = spectrum_derivatives[42];
    const double omega4_by_m1 = spectrum_derivatives[43];
    const double omega4_by_m2 = spectrum_derivatives[44];
    const double p4_by_k1 = spectrum_derivatives[45];
    const double p4_by_k2 = spectrum_derivatives[46];
    const double p4_by_k3 = spectrum_derivatives[47];
    const double p4_by_m1 = spectrum_derivatives[48];
    const double p4_by_m2 = spectrum_derivatives[49];
    const double p5_by_k1 = spectrum_derivatives[50];
    const double p5_by_k2 = spectrum_derivatives[51];
    const double p5_by_k3 = spectrum_derivatives[52];
    const double p5_by_m1 = spectrum_derivatives[53];
    const double p5_by_m2 = spectrum_derivatives[54];
    const double p6_by_k1 = spectrum_derivatives[55];
    const double p6_by_k2 = spectrum_derivatives[56];
    const double p6_by_k3 = spectrum_derivatives[57];
    const double p6_by_m1 = spectrum_derivatives[58];
    const double p6_by_m2 = spectrum_derivatives[59];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
    /* functions of tau in contact */
    const double t0 = omega1*tau;
    const double cos_omega1_tau = cos(t0);
    const double sin_omega1_tau = sin(t0);
    const double t3 = omega2*tau;
    const double cos_omega2_tau = cos(t3);
    const double sin_omega2_tau = sin(t3);
    /* contact for tau, until first-leaves-stop */
    const double t6 = k1*k3;
    const double t7 = k2*k3 + t6;
    const double t8 = k1*k2 + t7;
    const double t9 = (1.0/(t8));
    const double t10 = t7*t9;
    const double t11 = t6*t9;
    const double t12 = p2*t11;
    const double t13 = p1*t10 + t12;
    const double t14 = p1 - 1;
    const double t15 = t10*t14 + t12;
    const double t16 = (1.0/(omega1));
    const double t17 = sin_omega1_tau*t16;
    const double t19 = (1.0/(omega2));
    const double t20 = sin_omega2_tau*t19;
    const double t21 = p1*t17 - t14*t20;
    const double t22 = p2*sin_omega1_tau*t16 - p2*t20;
    const double t23 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t24 = cos_omega1_tau*p1 - cos_omega2_tau*t14;
    const double x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t22*w + t23*y + t24;
    const double t25 = p3*t10;
    const double t27 = t11*t14 - t25;
    const double t28 = p1*t11;
    const double t29 = -t25 + t28;
    const double t30 = p3*sin_omega1_tau*t16 - p3*t20;
    const double t31 = p1*t20 - t14*t17;
    const double t32 = -cos_omega1_tau*t14 + cos_omega2_tau*p1;
    const double t33 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*t27 - cos_omega2_tau*t29 + t11 + t30*u + t31*w + t32*y + t33;
    const double t34 = omega1*p1;
    const double t35 = omega1*t12 + t10*t34;
    const double t36 = omega2*t12 + omega2*t14*t7*t9;
    const double t37 = omega1*sin_omega1_tau;
    const double t38 = omega2*p2*sin_omega2_tau - p2*t37;
    const double t39 = -omega2*t14;
    const double v1_1 = -sin_omega1_tau*t34 + sin_omega1_tau*t35 - sin_omega2_tau*t36 - sin_omega2_tau*t39 + t23*w + t24*u + t38*y;
    const double t40 = omega1*p3;
    const double t41 = -t11*t14;
    const double t42 = omega1*t41 + t10*t40;
    const double t43 = omega2*p3;
    const double t44 = omega2*t28 - t10*t43;
    const double t45 = omega2*sin_omega2_tau;
    const double t46 = -p1*t45 + t14*t37;
    const double v2_1 = -sin_omega1_tau*t40 + sin_omega1_tau*t42 + sin_omega2_tau*t43 + sin_omega2_tau*t44 + t32*w + t33*u + t46*y;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t47 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t47);
    const double sin_omega3_tau1 = sin(t47);
    const double t50 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t50);
    const double sin_omega4_tau1 = sin(t50);
    /* free for tau1, until first-reaches-stop */
    const double t53 = (1.0/(omega3));
    const double t54 = sin_omega3_tau1*t53;
    const double t55 = 1 - p4;
    const double t56 = (1.0/(omega4));
    const double t57 = sin_omega4_tau1*t56;
    const double t58 = p4*t54 + t55*t57;
    const double t59 = p5*sin_omega3_tau1*t53 - p5*t57;
    const double t60 = cos_omega3_tau1*p4 + cos_omega4_tau1*t55;
    const double t61 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t58*v1_1 + t59*v2_1 + t60*x1_1 + t61*x2_1;
    const double t62 = p6*sin_omega3_tau1*t53 - p6*t57;
    const double t63 = p4*t57 + t54*t55;
    const double t64 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t65 = cos_omega3_tau1*t55 + cos_omega4_tau1*p4;
    const double x2_2 = t62*v1_1 + t63*v2_1 + t64*x1_1 + t65*x2_1;
    const double t66 = omega3*sin_omega3_tau1;
    const double t67 = omega4*sin_omega4_tau1;
    const double t68 = -p4*t66 - t55*t67;
    const double t69 = omega4*p5*sin_omega4_tau1 - p5*t66;
    const double v1_2 = t60*v1_1 + t61*v2_1 + t68*x1_1 + t69*x2_1;
    const double t70 = omega4*p6*sin_omega4_tau1 - p6*t66;
    const double t71 = -p4*t67 - t55*t66;
    const double v2_2 = t64*v1_1 + t65*v2_1 + t70*x1_1 + t71*x2_1;
    /* Phi along tau */
    const double carried_x1_1_by_y = t23;
    const double carried_x1_1_by_u = t21;
    const double carried_x1_1_by_w = t22;
    const double carried_x2_1_by_y = t32;
    const double carried_x2_1_by_u = t30;
    const double carried_x2_1_by_w = t31;
    const double carried_v1_1_by_y = t38;
    const double carried_v1_1_by_u = t24;
    const double carried_v1_1_by_w = t23;
    const double carried_v2_1_by_y = t46;
    const double carried_v2_1_by_u = t33;
    const double carried_v2_1_by_w = t32;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t72 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t72;
    const double delay_tau_by_u = carried_x1_1_by_u*t72;
    const double delay_tau_by_w = carried_x1_1_by_w*t72;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t73 = (1.0/(m1));
    const double t74 = k1 + k3;
    const double t75 = t73*x1_1;
    const double t76 = k1*t73*x2_1 + k3*t73 - t74*t75;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t76;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t76;
    const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t76;
    const double t77 = (1.0/(m2));
    const double t78 = t77*x1_1;
    const double t79 = k1 + k2;
    const double t80 = t77*x2_1;
    const double t81 = k1*t78 - t79*t80;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t81;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t81;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t81;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t58*v1_1_on_boundary_by_y + t59*v2_1_on_boundary_by_y + t60*x1_1_on_boundary_by_y + t61*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t58*v1_1_on_boundary_by_u + t59*v2_1_on_boundary_by_u + t60*x1_1_on_boundary_by_u + t61*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t58*v1_1_on_boundary_by_w + t59*v2_1_on_boundary_by_w + t60*x1_1_on_boundary_by_w + t61*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t82 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t82;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t82;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t82;
    /* d/dtau of: functions of tau in contact */
    const double cos_omega1_tau_by_tau = -omega1*sin_omega1_tau;
    const double sin_omega1_tau_by_tau = cos_omega1_tau*omega1;
    const double cos_omega2_tau_by_tau = -omega2*sin_omega2_tau;
    const double sin_omega2_tau_by_tau = cos_omega2_tau*omega2;
    /* d/dm1 of: functions of tau in contact */
    const double t83 = omega1_by_m1*tau;
    const double cos_omega1_tau_by_m1 = -sin_omega1_tau*t83;
    const double sin_omega1_tau_by_m1 = cos_omega1_tau*t83;
    const double t84 = omega2_by_m1*tau;
    const double cos_omega2_tau_by_m1 = -sin_omega2_tau*t84;
    const double sin_omega2_tau_by_m1 = cos_omega2_tau*t84;
    /* d/dm2 of: functions of tau in contact */
    const double t85 = omega1_by_m2*tau;
    const double cos_omega1_tau_by_m2 = -sin_omega1_tau*t85;
    const double sin_omega1_tau_by_m2 = cos_omega1_tau*t85;
    const double t86 = omega2_by_m2*tau;
    const double cos_omega2_tau_by_m2 = -sin_omega2_tau*t86;
    const double sin_omega2_tau_by_m2 = cos_omega2_tau*t86;
    /* d/dk1 of: functions of tau in contact */
    const double t87 = omega1_by_k1*tau;
    const double cos_omega1_tau_by_k1 = -sin_omega1_tau*t87;
    const double sin_omega1_tau_by_k1 = cos_omega1_tau*t87;
    const double t88 = omega2_by_k1*tau;
    const double cos_omega2_tau_by_k1 = -sin_omega2_tau*t88;
    const double sin_omega2_tau_by_k1 = cos_omega2_tau*t88;
    /* d/dk2 of: functions of tau in contact */
    const double t89 = omega1_by_k2*tau;
    const double cos_omega1_tau_by_k2 = -sin_omega1_tau*t89;
    const double sin_omega1_tau_by_k2 = cos_omega1_tau*t89;
    const double t90 = omega2_by_k2*tau;
    const double cos_omega2_tau_by_k2 = -sin_omega2_tau*t90;
    const double sin_omega2_tau_by_k2 = cos_omega2_tau*t90;
    /* d/dk3 of: functions of tau in contact */
    const double t91 = omega1_by_k3*tau;
    const double cos_omega1_tau_by_k3 = -sin_omega1_tau*t91;
    const double sin_omega1_tau_by_k3 = cos_omega1_tau*t91;
    const double t92 = omega2_by_k3*tau;
    const double cos_omega2_tau_by_k3 = -sin_omega2_tau*t92;
    const double sin_omega2_tau_by_k3 = cos_omega2_tau*t92;
    /* d/dy of: contact for tau, until first-leaves-stop */
    const double x1_1_by_y = t23;
    const double x2_1_by_y = t32;
    const double v1_1_by_y = t38;
    const double v2_1_by_y = t46;
    /* d/du of: contact for tau, until first-leaves-stop */
    const double x1_1_by_u = t21;
    const double x2_1_by_u = t30;
    const double v1_1_by_u = t24;
    const double v2_1_by_u = t33;
    /* d/dw of: contact for tau, until first-leaves-stop */
    const double x1_1_by_w = t22;
    const double x2_1_by_w = t31;
    const double v1_1_by_w = t23;
    const double v2_1_by_w = t32;
    /* d/dtau of: contact for tau, until first-leaves-stop */
    const double t93 = p2*y;
    const double t94 = -p1 - t93;
    const double t95 = -t13 - t94;
    const double t96 = t15 + t94 + 1;
    const double t97 = p1*u;
    const double t98 = p2*w;
    const double t99 = t16*t97 + t16*t98;
    const double t100 = -t14*t19*u - t19*t98;
    const double x1_1_by_tau = cos_omega1_tau_by_tau*t95 + cos_omega2_tau_by_tau*t96 + sin_omega1_tau_by_tau*t99 + sin_omega2_tau_by_tau*t100;
    const double t101 = -t14*y;
    const double t102 = p3 + t101 + t27;
    const double t103 = p1*y - p3 - t29;
    const double t104 = p3*u;
    const double t105 = -t14*w;
    const double t106 = t104*t16 + t105*t16;
    const double t107 = p1*w;
    const double t108 = -t104*t19 + t107*t19;
    const double x2_1_by_tau = cos_omega1_tau_by_tau*t102 + cos_omega2_tau_by_tau*t103 + sin_omega1_tau_by_tau*t106 + sin_omega2_tau_by_tau*t108;
    const double t109 = t97 + t98;
    const double t110 = -t14*u - t98;
    const double t111 = -omega1*t93 - t34 + t35;
    const double t112 = omega2*p2*y - t36 - t39;
    const double v1_1_by_tau = cos_omega1_tau_by_tau*t109 + cos_omega2_tau_by_tau*t110 + sin_omega1_tau_by_tau*t111 + sin_omega2_tau_by_tau*t112;
    const double t113 = t104 + t105;
    const double t114 = -t104 + t107;
    const double t115 = -omega1*t101 - t40 + t42;
    const double t116 = p1*y;
    const double t117 = -omega2*t116 + t43 + t44;
    const double v2_1_by_tau = cos_omega1_tau_by_tau*t113 + cos_omega2_tau_by_tau*t114 + sin_omega1_tau_by_tau*t115 + sin_omega2_tau_by_tau*t117;
    /* d/dm1 of: contact for tau, until first-leaves-stop */
    const double t118 = (1.0/(omega1*omega1));
    const double t119 = sin_omega1_tau*t118;
    const double t120 = -t119*t97 - t119*t98;
    const double t121 = (1.0/(omega2*omega2));
    const double t122 = sin_omega2_tau*t121;
    const double t123 = t122*t14*u + t122*t98;
    const double t124 = -sin_omega1_tau*t16 + t20;
    const double t126 = cos_omega1_tau - cos_omega2_tau;
    const double t127 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t124*u + t126;
    const double t128 = cos_omega2_tau*t11;
    const double t129 = cos_omega1_tau*t11;
    const double t130 = -t124*w + t126*y + t128 - t129;
    const double x1_1_by_m1 = cos_omega1_tau_by_m1*t95 + cos_omega2_tau_by_m1*t96 + omega1_by_m1*t120 + omega2_by_m1*t123 + p1_by_m1*t127 + p2_by_m1*t130 + sin_omega1_tau_by_m1*t99 + sin_omega2_tau_by_m1*t100;
    const double t131 = -t104*t119 - t105*t119;
    const double t132 = p3*sin_omega2_tau*t121*u - t107*t122;
    const double t134 = t124*w - t126*y - t128 + t129;
    const double x2_1_by_m1 = cos_omega1_tau_by_m1*t102 + cos_omega2_tau_by_m1*t103 + omega1_by_m1*t131 + omega2_by_m1*t132 + p1_by_m1*t134 + p3_by_m1*t127 + sin_omega1_tau_by_m1*t106 + sin_omega2_tau_by_m1*t108;
    const double t135 = p1*sin_omega1_tau;
    const double t136 = sin_omega1_tau*t13 - sin_omega1_tau*t93 - t135;
    const double t137 = -sin_omega2_tau*t14;
    const double t138 = sin_omega2_tau*t93 + sin_omega2_tau*(-t12 - t14*t7*t9) - t137;
    const double t139 = t10*t37 - t10*t45 + t126*u - t37 + t45;
    const double t140 = -omega2*sin_omega2_tau + t37;
    const double t142 = t11*t37;
    const double t143 = t11*t45;
    const double t144 = t126*w - t140*y + t142 - t143;
    const double v1_1_by_m1 = cos_omega1_tau_by_m1*t109 + cos_omega2_tau_by_m1*t110 + omega1_by_m1*t136 + omega2_by_m1*t138 + p1_by_m1*t139 + p2_by_m1*t144 + sin_omega1_tau_by_m1*t111 + sin_omega2_tau_by_m1*t112;
    const double t145 = p3*sin_omega1_tau;
    const double t146 = -sin_omega1_tau*t101 + sin_omega1_tau*(t25 + t41) - t145;
    const double t147 = p3*sin_omega2_tau;
    const double t148 = -sin_omega2_tau*t116 + sin_omega2_tau*t29 + t147;
    const double t149 = -t126*w + t140*y - t142 + t143;
    const double v2_1_by_m1 = cos_omega1_tau_by_m1*t113 + cos_omega2_tau_by_m1*t114 + omega1_by_m1*t146 + omega2_by_m1*t148 + p1_by_m1*t149 + p3_by_m1*t139 + sin_omega1_tau_by_m1*t115 + sin_omega2_tau_by_m1*t117;
    /* d/dm2 of: contact for tau, until first-leaves-stop */
    const double x1_1_by_m2 = cos_omega1_tau_by_m2*t95 + cos_omega2_tau_by_m2*t96 + omega1_by_m2*t120 + omega2_by_m2*t123 + p1_by_m2*t127 + p2_by_m2*t130 + sin_omega1_tau_by_m2*t99 + sin_omega2_tau_by_m2*t100;
    const double x2_1_by_m2 = cos_omega1_tau_by_m2*t102 + cos_omega2_tau_by_m2*t103 + omega1_by_m2*t131 + omega2_by_m2*t132 + p1_by_m2*t134 + p3_by_m2*t127 + sin_omega1_tau_by_m2*t106 + sin_omega2_tau_by_m2*t108;
    const double v1_1_by_m2 = cos_omega1_tau_by_m2*t109 + cos_omega2_tau_by_m2*t110 + omega1_by_m2*t136 + omega2_by_m2*t138 + p1_by_m2*t139 + p2_by_m2*t144 + sin_omega1_tau_by_m2*t111 + sin_omega2_tau_by_m2*t112;
    const double v2_1_by_m2 = cos_omega1_tau_by_m2*t113 + cos_omega2_tau_by_m2*t114 + omega1_by_m2*t146 + omega2_by_m2*t148 + p1_by_m2*t149 + p3_by_m2*t139 + sin_omega1_tau_by_m2*t115 + sin_omega2_tau_by_m2*t117;
    /* d/dk1 of: contact for tau, until first-leaves-stop */
    const double t150 = k3*t9;
    const double t151 = p1*t150;
    const double t152 = -k2 - k3;
    const double t153 = (1.0/(t8*t8));
    const double t154 = t153*t7;
    const double t155 = t152*t154;
    const double t156 = p2*t150;
    const double t157 = t153*t6;
    const double t158 = t152*t157;
    const double t159 = p2*t158;
    const double t160 = t156 + t159;
    const double t161 = t14*t150;
    const double x1_1_by_k1 = cos_omega1_tau*(-p1*t155 - t151 - t160) + cos_omega1_tau_by_k1*t95 + cos_omega2_tau*(t14*t155 + t160 + t161) + cos_omega2_tau_by_k1*t96 + omega1_by_k1*t120 + omega2_by_k1*t123 + p1_by_k1*t127 + p2_by_k1*t130 + sin_omega1_tau_by_k1*t99 + sin_omega2_tau_by_k1*t100 + t150 + t155;
    const double t162 = p3*t150;
    const double t163 = -p3*t155 - t162;
    const double t164 = p1*t158;
    const double x2_1_by_k1 = cos_omega1_tau*(t14*t158 + t161 + t163) + cos_omega1_tau_by_k1*t102 + cos_omega2_tau*(-t151 - t163 - t164) + cos_omega2_tau_by_k1*t103 + omega1_by_k1*t131 + omega2_by_k1*t132 + p1_by_k1*t134 + p3_by_k1*t127 + sin_omega1_tau_by_k1*t106 + sin_omega2_tau_by_k1*t108 + t150 + t158;
    const double t165 = t150*t34;
    const double v1_1_by_k1 = cos_omega1_tau_by_k1*t109 + cos_omega2_tau_by_k1*t110 + omega1_by_k1*t136 + omega2_by_k1*t138 + p1_by_k1*t139 + p2_by_k1*t144 + sin_omega1_tau*(omega1*t156 + omega1*t159 + t155*t34 + t165) + sin_omega1_tau_by_k1*t111 + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t152*t153*t7 - omega2*t156 - omega2*t159) + sin_omega2_tau_by_k1*t112;
    const double t166 = t150*t40;
    const double t167 = -omega1*t14;
    const double t168 = t150*t43;
    const double v2_1_by_k1 = cos_omega1_tau_by_k1*t113 + cos_omega2_tau_by_k1*t114 + omega1_by_k1*t146 + omega2_by_k1*t148 + p1_by_k1*t149 + p3_by_k1*t139 + sin_omega1_tau*(t150*t167 + t155*t40 + t158*t167 + t166) + sin_omega1_tau_by_k1*t115 + sin_omega2_tau*(omega2*t151 + omega2*t164 - t155*t43 - t168) + sin_omega2_tau_by_k1*t117;
    /* d/dk2 of: contact for tau, until first-leaves-stop */
    const double t170 = -t154*t74;
    const double t171 = -t157*t74;
    const double t172 = p2*t171;
    const double x1_1_by_k2 = cos_omega1_tau*(-p1*t170 - t151 - t172) + cos_omega1_tau_by_k2*t95 + cos_omega2_tau*(t14*t170 + t161 + t172) + cos_omega2_tau_by_k2*t96 + omega1_by_k2*t120 + omega2_by_k2*t123 + p1_by_k2*t127 + p2_by_k2*t130 + sin_omega1_tau_by_k2*t99 + sin_omega2_tau_by_k2*t100 + t150 + t170;
    const double t173 = p3*t170 + t162;
    const double x2_1_by_k2 = cos_omega1_tau*(-k1*k3*t14*t153*t74 - t173) + cos_omega1_tau_by_k2*t102 + cos_omega2_tau*(-p1*t171 + t173) + cos_omega2_tau_by_k2*t103 + omega1_by_k2*t131 + omega2_by_k2*t132 + p1_by_k2*t134 + p3_by_k2*t127 + sin_omega1_tau_by_k2*t106 + sin_omega2_tau_by_k2*t108 + t171;
    const double v1_1_by_k2 = cos_omega1_tau_by_k2*t109 + cos_omega2_tau_by_k2*t110 + omega1_by_k2*t136 + omega2_by_k2*t138 + p1_by_k2*t139 + p2_by_k2*t144 + sin_omega1_tau*(omega1*t172 + t165 + t170*t34) + sin_omega1_tau_by_k2*t111 + sin_omega2_tau*(-omega2*t172 + t150*t39 + t170*t39) + sin_omega2_tau_by_k2*t112;
    const double v2_1_by_k2 = cos_omega1_tau_by_k2*t113 + cos_omega2_tau_by_k2*t114 + omega1_by_k2*t146 + omega2_by_k2*t148 + p1_by_k2*t149 + p3_by_k2*t139 + sin_omega1_tau*(t166 + t167*t171 + t170*t40) + sin_omega1_tau_by_k2*t115 + sin_omega2_tau*(-k1*k3*omega2*p1*t153*t74 - t168 - t170*t43) + sin_omega2_tau_by_k2*t117;
    /* d/dk3 of: contact for tau, until first-leaves-stop */
    const double t174 = t79*t9;
    const double t176 = -t154*t79;
    const double t177 = k1*t9;
    const double t178 = p2*t177;
    const double t179 = -t157*t79;
    const double t180 = p2*t179;
    const double t181 = t178 + t180;
    const double x1_1_by_k3 = cos_omega1_tau*(-p1*t174 - p1*t176 - t181) + cos_omega1_tau_by_k3*t95 + cos_omega2_tau*(t14*t174 + t14*t176 + t181) + cos_omega2_tau_by_k3*t96 + omega1_by_k3*t120 + omega2_by_k3*t123 + p1_by_k3*t127 + p2_by_k3*t130 + sin_omega1_tau_by_k3*t99 + sin_omega2_tau_by_k3*t100 + t174 + t176;
    const double t182 = -p3*t174 - p3*t176;
    const double t183 = p1*t177;
    const double t184 = p1*t179;
    const double x2_1_by_k3 = cos_omega1_tau*(t14*t177 + t14*t179 + t182) + cos_omega1_tau_by_k3*t102 + cos_omega2_tau*(-t182 - t183 - t184) + cos_omega2_tau_by_k3*t103 + omega1_by_k3*t131 + omega2_by_k3*t132 + p1_by_k3*t134 + p3_by_k3*t127 + sin_omega1_tau_by_k3*t106 + sin_omega2_tau_by_k3*t108 + t177 + t179;
    const double v1_1_by_k3 = cos_omega1_tau_by_k3*t109 + cos_omega2_tau_by_k3*t110 + omega1_by_k3*t136 + omega2_by_k3*t138 + p1_by_k3*t139 + p2_by_k3*t144 + sin_omega1_tau*(omega1*t178 + omega1*t180 + t174*t34 + t176*t34) + sin_omega1_tau_by_k3*t111 + sin_omega2_tau*(omega2*t14*t153*t7*t79 - omega2*t14*t79*t9 - omega2*t178 - omega2*t180) + sin_omega2_tau_by_k3*t112;
    const double v2_1_by_k3 = cos_omega1_tau_by_k3*t113 + cos_omega2_tau_by_k3*t114 + omega1_by_k3*t146 + omega2_by_k3*t148 + p1_by_k3*t149 + p3_by_k3*t139 + sin_omega1_tau*(t167*t177 + t167*t179 + t174*t40 + t176*t40) + sin_omega1_tau_by_k3*t115 + sin_omega2_tau*(omega2*t183 + omega2*t184 - t174*t43 - t176*t43) + sin_omega2_tau_by_k3*t117;
    /* d/dtau of: functions of tau1 in free */
    const double cos_omega3_tau1_by_tau = omega3*sin_omega3_tau1;
    const double t186 = cos_omega3_tau1*omega3;
    const double sin_omega3_tau1_by_tau = -t186;
    const double cos_omega4_tau1_by_tau = omega4*sin_omega4_tau1;
    const double t188 = cos_omega4_tau1*omega4;
    const double sin_omega4_tau1_by_tau = -t188;
    /* d/dm1 of: functions of tau1 in free */
    const double t189 = omega3_by_m1*tau1;
    const double cos_omega3_tau1_by_m1 = -sin_omega3_tau1*t189;
    const double sin_omega3_tau1_by_m1 = cos_omega3_tau1*t189;
    const double t190 = omega4_by_m1*tau1;
    const double cos_omega4_tau1_by_m1 = -sin_omega4_tau1*t190;
    const double sin_omega4_tau1_by_m1 = cos_omega4_tau1*t190;
    /* d/dm2 of: functions of tau1 in free */
    const double t191 = omega3_by_m2*tau1;
    const double cos_omega3_tau1_by_m2 = -sin_omega3_tau1*t191;
    const double sin_omega3_tau1_by_m2 = cos_omega3_tau1*t191;
    const double t192 = omega4_by_m2*tau1;
    const double cos_omega4_tau1_by_m2 = -sin_omega4_tau1*t192;
    const double sin_omega4_tau1_by_m2 = cos_omega4_tau1*t192;
    /* d/dk1 of: functions of tau1 in free */
    const double t193 = omega3_by_k1*tau1;
    const double cos_omega3_tau1_by_k1 = -sin_omega3_tau1*t193;
    const double sin_omega3_tau1_by_k1 = cos_omega3_tau1*t193;
    const double t194 = omega4_by_k1*tau1;
    const double cos_omega4_tau1_by_k1 = -sin_omega4_tau1*t194;
    const double sin_omega4_tau1_by_k1 = cos_omega4_tau1*t194;
    /* d/dk2 of: functions of tau1 in free */
    const double t195 = omega3_by_k2*tau1;
    const double cos_omega3_tau1_by_k2 = -sin_omega3_tau1*t195;
    const double sin_omega3_tau1_by_k2 = cos_omega3_tau1*t195;
    const double t196 = omega4_by_k2*tau1;
    const double cos_omega4_tau1_by_k2 = -sin_omega4_tau1*t196;
    const double sin_omega4_tau1_by_k2 = cos_omega4_tau1*t196;
    /* d/dk3 of: functions of tau1 in free */
    const double t197 = omega3_by_k3*tau1;
    const double cos_omega3_tau1_by_k3 = -sin_omega3_tau1*t197;
    const double sin_omega3_tau1_by_k3 = cos_omega3_tau1*t197;
    const double t198 = omega4_by_k3*tau1;
    const double cos_omega4_tau1_by_k3 = -sin_omega4_tau1*t198;
    const double sin_omega4_tau1_by_k3 = cos_omega4_tau1*t198;
    /* d/dT of: functions of tau1 in free */
    const double cos_omega3_tau1_by_T = -cos_omega3_tau1_by_tau;
    const double sin_omega3_tau1_by_T = t186;
    const double cos_omega4_tau1_by_T = -cos_omega4_tau1_by_tau;
    const double sin_omega4_tau1_by_T = t188;
    /* d/dy of: free for tau1, until first-reaches-stop */
    const double x1_2_by_y = t58*v1_1_by_y + t59*v2_1_by_y + t60*x1_1_by_y + t61*x2_1_by_y;
    const double x2_2_by_y = t62*v1_1_by_y + t63*v2_1_by_y + t64*x1_1_by_y + t65*x2_1_by_y;
    const double v1_2_by_y = t60*v1_1_by_y + t61*v2_1_by_y + t68*x1_1_by_y + t69*x2_1_by_y;
    const double v2_2_by_y = t64*v1_1_by_y + t65*v2_1_by_y + t70*x1_1_by_y + t71*x2_1_by_y;
    /* d/du of: free for tau1, until first-reaches-stop */
    const double x1_2_by_u = t58*v1_1_by_u + t59*v2_1_by_u + t60*x1_1_by_u + t61*x2_1_by_u;
    const double x2_2_by_u = t62*v1_1_by_u + t63*v2_1_by_u + t64*x1_1_by_u + t65*x2_1_by_u;
    const double v1_2_by_u = t60*v1_1_by_u + t61*v2_1_by_u + t68*x1_1_by_u + t69*x2_1_by_u;
    const double v2_2_by_u = t64*v1_1_by_u + t65*v2_1_by_u + t70*x1_1_by_u + t71*x2_1_by_u;
    /* d/dw of: free for tau1, until first-reaches-stop */
    const double x1_2_by_w = t58*v1_1_by_w + t59*v2_1_by_w + t60*x1_1_by_w + t61*x2_1_by_w;
    const double x2_2_by_w = t62*v1_1_by_w + t63*v2_1_by_w + t64*x1_1_by_w + t65*x2_1_by_w;
    const double v1_2_by_w = t60*v1_1_by_w + t61*v2_1_by_w + t68*x1_1_by_w + t69*x2_1_by_w;
    const double v2_2_by_w = t64*v1_1_by_w + t65*v2_1_by_w + t70*x1_1_by_w + t71*x2_1_by_w;
    /* d/dtau of: free for tau1, until first-reaches-stop */
    const double t199 = p4*x1_1;
    const double t200 = p5*x2_1;
    const double t201 = t199 + t200;
    const double t202 = -t200 + t55*x1_1;
    const double t203 = p4*v1_1;
    const double t204 = p5*v2_1;
    const double t205 = t203*t53 + t204*t53;
    const double t206 = -t204*t56 + t55*t56*v1_1;
    const double x1_2_by_tau = cos_omega3_tau1_by_tau*t201 + cos_omega4_tau1_by_tau*t202 + sin_omega3_tau1_by_tau*t205 + sin_omega4_tau1_by_tau*t206 + t58*v1_1_by_tau + t59*v2_1_by_tau + t60*x1_1_by_tau + t61*x2_1_by_tau;
    const double t207 = p6*x1_1;
    const double t208 = t55*x2_1;
    const double t209 = t207 + t208;
    const double t210 = p4*x2_1;
    const double t211 = -t207 + t210;
    const double t212 = p6*v1_1;
    const double t213 = t55*v2_1;
    const double t214 = t212*t53 + t213*t53;
    const double t215 = p4*v2_1;
    const double t216 = -t212*t56 + t215*t56;
    const double x2_2_by_tau = cos_omega3_tau1_by_tau*t209 + cos_omega4_tau1_by_tau*t211 + sin_omega3_tau1_by_tau*t214 + sin_omega4_tau1_by_tau*t216 + t62*v1_1_by_tau + t63*v2_1_by_tau + t64*x1_1_by_tau + t65*x2_1_by_tau;
    const double t217 = t203 + t204;
    const double t218 = -t204 + t55*v1_1;
    const double t219 = -omega3*t199 - omega3*t200;
    const double t220 = t55*x1_1;
    const double t221 = omega4*t200 - omega4*t220;
    const double v1_2_by_tau = cos_omega3_tau1_by_tau*t217 + cos_omega4_tau1_by_tau*t218 + sin_omega3_tau1_by_tau*t219 + sin_omega4_tau1_by_tau*t221 + t60*v1_1_by_tau + t61*v2_1_by_tau + t68*x1_1_by_tau + t69*x2_1_by_tau;
    const double t222 = t212 + t213;
    const double t223 = -t212 + t215;
    const double t224 = -omega3*t207 - omega3*t208;
    const double t225 = omega4*p6*x1_1 - omega4*t210;
    const double v2_2_by_tau = cos_omega3_tau1_by_tau*t222 + cos_omega4_tau1_by_tau*t223 + sin_omega3_tau1_by_tau*t224 + sin_omega4_tau1_by_tau*t225 + t64*v1_1_by_tau + t65*v2_1_by_tau + t70*x1_1_by_tau + t71*x2_1_by_tau;
    /* d/dm1 of: free for tau1, until first-reaches-stop */
    const double t226 = sin_omega3_tau1/(omega3*omega3);
    const double t227 = -t203*t226 - t204*t226;
    const double t228 = (1.0/(omega4*omega4));
    const double t229 = sin_omega4_tau1*t228;
    const double t230 = t204*t229 - t229*t55*v1_1;
    const double t231 = -sin_omega3_tau1*t53 + t57;
    const double t233 = cos_omega3_tau1 - cos_omega4_tau1;
    const double t234 = -t231*v1_1 + t233*x1_1;
    const double t235 = -t231*v2_1 + t233*x2_1;
    const double x1_2_by_m1 = cos_omega3_tau1_by_m1*t201 + cos_omega4_tau1_by_m1*t202 + omega3_by_m1*t227 + omega4_by_m1*t230 + p4_by_m1*t234 + p5_by_m1*t235 + sin_omega3_tau1_by_m1*t205 + sin_omega4_tau1_by_m1*t206 + t58*v1_1_by_m1 + t59*v2_1_by_m1 + t60*x1_1_by_m1 + t61*x2_1_by_m1;
    const double t236 = -t212*t226 - t213*t226;
    const double t237 = p6*sin_omega4_tau1*t228*v1_1 - t215*t229;
    const double t239 = t231*v2_1 - t233*x2_1;
    const double x2_2_by_m1 = cos_omega3_tau1_by_m1*t209 + cos_omega4_tau1_by_m1*t211 + omega3_by_m1*t236 + omega4_by_m1*t237 + p4_by_m1*t239 + p6_by_m1*t234 + sin_omega3_tau1_by_m1*t214 + sin_omega4_tau1_by_m1*t216 + t62*v1_1_by_m1 + t63*v2_1_by_m1 + t64*x1_1_by_m1 + t65*x2_1_by_m1;
    const double t240 = -sin_omega3_tau1*t199 - sin_omega3_tau1*t200;
    const double t241 = sin_omega4_tau1*t200 - sin_omega4_tau1*t220;
    const double t242 = -omega4*sin_omega4_tau1 + t66;
    const double t244 = t233*v1_1 - t242*x1_1;
    const double t245 = t233*v2_1 - t242*x2_1;
    const double v1_2_by_m1 = cos_omega3_tau1_by_m1*t217 + cos_omega4_tau1_by_m1*t218 + omega3_by_m1*t240 + omega4_by_m1*t241 + p4_by_m1*t244 + p5_by_m1*t245 + sin_omega3_tau1_by_m1*t219 + sin_omega4_tau1_by_m1*t221 + t60*v1_1_by_m1 + t61*v2_1_by_m1 + t68*x1_1_by_m1 + t69*x2_1_by_m1;
    const double t246 = -sin_omega3_tau1*t207 - sin_omega3_tau1*t208;
    const double t247 = p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t210;
    const double t248 = -t233*v2_1 + t242*x2_1;
    const double v2_2_by_m1 = cos_omega3_tau1_by_m1*t222 + cos_omega4_tau1_by_m1*t223 + omega3_by_m1*t246 + omega4_by_m1*t247 + p4_by_m1*t248 + p6_by_m1*t244 + sin_omega3_tau1_by_m1*t224 + sin_omega4_tau1_by_m1*t225 + t64*v1_1_by_m1 + t65*v2_1_by_m1 + t70*x1_1_by_m1 + t71*x2_1_by_m1;
    /* d/dm2 of: free for tau1, until first-reaches-stop */
    const double x1_2_by_m2 = cos_omega3_tau1_by_m2*t201 + cos_omega4_tau1_by_m2*t202 + omega3_by_m2*t227 + omega4_by_m2*t230 + p4_by_m2*t234 + p5_by_m2*t235 + sin_omega3_tau1_by_m2*t205 + sin_omega4_tau1_by_m2*t206 + t58*v1_1_by_m2 + t59*v2_1_by_m2 + t60*x1_1_by_m2 + t61*x2_1_by_m2;
    const double x2_2_by_m2 = cos_omega3_tau1_by_m2*t209 + cos_omega4_tau1_by_m2*t211 + omega3_by_m2*t236 + omega4_by_m2*t237 + p4_by_m2*t239 + p6_by_m2*t234 + sin_omega3_tau1_by_m2*t214 + sin_omega4_tau1_by_m2*t216 + t62*v1_1_by_m2 + t63*v2_1_by_m2 + t64*x1_1_by_m2 + t65*x2_1_by_m2;
    const double v1_2_by_m2 = cos_omega3_tau1_by_m2*t217 + cos_omega4_tau1_by_m2*t218 + omega3_by_m2*t240 + omega4_by_m2*t241 + p4_by_m2*t244 + p5_by_m2*t245 + sin_omega3_tau1_by_m2*t219 + sin_omega4_tau1_by_m2*t221 + t60*v1_1_by_m2 + t61*v2_1_by_m2 + t68*x1_1_by_m2 + t69*x2_1_by_m2;
    const double v2_2_by_m2 = cos_omega3_tau1_by_m2*t222 + cos_omega4_tau1_by_m2*t223 + omega3_by_m2*t246 + omega4_by_m2*t247 + p4_by_m2*t248 + p6_by_m2*t244 + sin_omega3_tau1_by_m2*t224 + sin_omega4_tau1_by_m2*t225 + t64*v1_1_by_m2 + t65*v2_1_by_m2 + t70*x1_1_by_m2 + t71*x2_1_by_m2;
    /* d/dk1 of: free for tau1, until first-reaches-stop */
    const double x1_2_by_k1 = cos_omega3_tau1_by_k1*t201 + cos_omega4_tau1_by_k1*t202 + omega3_by_k1*t227 + omega4_by_k1*t230 + p4_by_k1*t234 + p5_by_k1*t235 + sin_omega3_tau1_by_k1*t205 + sin_omega4_tau1_by_k1*t206 + t58*v1_1_by_k1 + t59*v2_1_by_k1 + t60*x1_1_by_k1 + t61*x2_1_by_k1;
    const double x2_2_by_k1 = cos_omega3_tau1_by_k1*t209 + cos_omega4_tau1_by_k1*t211 + omega3_by_k1*t236 + omega4_by_k1*t237 + p4_by_k1*t239 + p6_by_k1*t234 + sin_omega3_tau1_by_k1*t214 + sin_omega4_tau1_by_k1*t216 + t62*v1_1_by_k1 + t63*v2_1_by_k1 + t64*x1_1_by_k1 + t65*x2_1_by_k1;
    const double v1_2_by_k1 = cos_omega3_tau1_by_k1*t217 + cos_omega4_tau1_by_k1*t218 + omega3_by_k1*t240 + omega4_by_k1*t241 + p4_by_k1*t244 + p5_by_k1*t245 + sin_omega3_tau1_by_k1*t219 + sin_omega4_tau1_by_k1*t221 + t60*v1_1_by_k1 + t61*v2_1_by_k1 + t68*x1_1_by_k1 + t69*x2_1_by_k1;
    const double v2_2_by_k1 = cos_omega3_tau1_by_k1*t222 + cos_omega4_tau1_by_k1*t223 + omega3_by_k1*t246 + omega4_by_k1*t247 + p4_by_k1*t248 + p6_by_k1*t244 + sin_omega3_tau1_by_k1*t224 + sin_omega4_tau1_by_k1*t225 + t64*v1_1_by_k1 + t65*v2_1_by_k1 + t70*x1_1_by_k1 + t71*x2_1_by_k1;
    /* d/dk2 of: free for tau1, until first-reaches-stop */
    const double x1_2_by_k2 = cos_omega3_tau1_by_k2*t201 + cos_omega4_tau1_by_k2*t202 + omega3_by_k2*t227 + omega4_by_k2*t230 + p4_by_k2*t234 + p5_by_k2*t235 + sin_omega3_tau1_by_k2*t205 + sin_omega4_tau1_by_k2*t206 + t58*v1_1_by_k2 + t59*v2_1_by_k2 + t60*x1_1_by_k2 + t61*x2_1_by_k2;
    const double x2_2_by_k2 = cos_omega3_tau1_by_k2*t209 + cos_omega4_tau1_by_k2*t211 + omega3_by_k2*t236 + omega4_by_k2*t237 + p4_by_k2*t239 + p6_by_k2*t234 + sin_omega3_tau1_by_k2*t214 + sin_omega4_tau1_by_k2*t216 + t62*v1_1_by_k2 + t63*v2_1_by_k2 + t64*x1_1_by_k2 + t65*x2_1_by_k2;
    const double v1_2_by_k2 = cos_omega3_tau1_by_k2*t217 + cos_omega4_tau1_by_k2*t218 + omega3_by_k2*t240 + omega4_by_k2*t241 + p4_by_k2*t244 + p5_by_k2*t245 + sin_omega3_tau1_by_k2*t219 + sin_omega4_tau1_by_k2*t221 + t60*v1_1_by_k2 + t61*v2_1_by_k2 + t68*x1_1_by_k2 + t69*x2_1_by_k2;
    const double v2_2_by_k2 = cos_omega3_tau1_by_k2*t222 + cos_omega4_tau1_by_k2*t223 + omega3_by_k2*t246 + omega4_by_k2*t247 + p4_by_k2*t248 + p6_by_k2*t244 + sin_omega3_tau1_by_k2*t224 + sin_omega4_tau1_by_k2*t225 + t64*v1_1_by_k2 + t65*v2_1_by_k2 + t70*x1_1_by_k2 + t71*x2_1_by_k2;
    /* d/dk3 of: free for tau1, until first-reaches-stop */
    const double x1_2_by_k3 = cos_omega3_tau1_by_k3*t201 + cos_omega4_tau1_by_k3*t202 + omega3_by_k3*t227 + omega4_by_k3*t230 + p4_by_k3*t234 + p5_by_k3*t235 + sin_omega3_tau1_by_k3*t205 + sin_omega4_tau1_by_k3*t206 + t58*v1_1_by_k3 + t59*v2_1_by_k3 + t60*x1_1_by_k3 + t61*x2_1_by_k3;
    const double x2_2_by_k3 = cos_omega3_tau1_by_k3*t209 + cos_omega4_tau1_by_k3*t211 + omega3_by_k3*t236 + omega4_by_k3*t237 + p4_by_k3*t239 + p6_by_k3*t234 + sin_omega3_tau1_by_k3*t214 + sin_omega4_tau1_by_k3*t216 + t62*v1_1_by_k3 + t63*v2_1_by_k3 + t64*x1_1_by_k3 + t65*x2_1_by_k3;
    const double v1_2_by_k3 = cos_omega3_tau1_by_k3*t217 + cos_omega4_tau1_by_k3*t218 + omega3_by_k3*t240 + omega4_by_k3*t241 + p4_by_k3*t244 + p5_by_k3*t245 + sin_omega3_tau1_by_k3*t219 + sin_omega4_tau1_by_k3*t221 + t60*v1_1_by_k3 + t61*v2_1_by_k3 + t68*x1_1_by_k3 + t69*x2_1_by_k3;
    const double v2_2_by_k3 = cos_omega3_tau1_by_k3*t222 + cos_omega4_tau1_by_k3*t223 + omega3_by_k3*t246 + omega4_by_k3*t247 + p4_by_k3*t248 + p6_by_k3*t244 + sin_omega3_tau1_by_k3*t224 + sin_omega4_tau1_by_k3*t225 + t64*v1_1_by_k3 + t65*v2_1_by_k3 + t70*x1_1_by_k3 + t71*x2_1_by_k3;
    /* d/dT of: free for tau1, until first-reaches-stop */
    const double x1_2_by_T = cos_omega3_tau1_by_T*t201 + cos_omega4_tau1_by_T*t202 + sin_omega3_tau1_by_T*t205 + sin_omega4_tau1_by_T*t206;
    const double x2_2_by_T = cos_omega3_tau1_by_T*t209 + cos_omega4_tau1_by_T*t211 + sin_omega3_tau1_by_T*t214 + sin_omega4_tau1_by_T*t216;
    const double v1_2_by_T = cos_omega3_tau1_by_T*t217 + cos_omega4_tau1_by_T*t218 + sin_omega3_tau1_by_T*t219 + sin_omega4_tau1_by_T*t221;
    const double v2_2_by_T = cos_omega3_tau1_by_T*t222 + cos_omega4_tau1_by_T*t223 + sin_omega3_tau1_by_T*t224 + sin_omega4_tau1_by_T*t225;
    /* d/dtau of: Phi along tau */
    const double carried_x1_1_by_y_by_tau = cos_omega1_tau_by_tau*p2 - cos_omega2_tau_by_tau*p2;
    const double t250 = sin_omega1_tau_by_tau*t16;
    const double t251 = sin_omega2_tau_by_tau*t19;
    const double carried_x1_1_by_u_by_tau = p1*t250 - t14*t251;
    const double carried_x1_1_by_w_by_tau = p2*sin_omega1_tau_by_tau*t16 - p2*t251;
    const double carried_x2_1_by_y_by_tau = -cos_omega1_tau_by_tau*t14 + cos_omega2_tau_by_tau*p1;
    const double carried_x2_1_by_u_by_tau = p3*sin_omega1_tau_by_tau*t16 - p3*t251;
    const double carried_x2_1_by_w_by_tau = p1*t251 - t14*t250;
    const double t253 = omega1*sin_omega1_tau_by_tau;
    const double carried_v1_1_by_y_by_tau = omega2*p2*sin_omega2_tau_by_tau - p2*t253;
    const double carried_v1_1_by_u_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t14;
    const double carried_v1_1_by_w_by_tau = carried_x1_1_by_y_by_tau;
    const double carried_v2_1_by_y_by_tau = -omega2*p1*sin_omega2_tau_by_tau + t14*t253;
    const double carried_v2_1_by_u_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3;
    const double carried_v2_1_by_w_by_tau = carried_x2_1_by_y_by_tau;
    /* d/dm1 of: Phi along tau */
    const double carried_x1_1_by_y_by_m1 = cos_omega1_tau_by_m1*p2 - cos_omega2_tau_by_m1*p2 + p2_by_m1*t126;
    const double t255 = sin_omega1_tau_by_m1*t16;
    const double t256 = sin_omega2_tau_by_m1*t19;
    const double t257 = omega1_by_m1*t118;
    const double t258 = omega2_by_m1*t121;
    const double carried_x1_1_by_u_by_m1 = p1*t255 - p1_by_m1*t124 - t135*t257 - t137*t258 - t14*t256;
    const double t259 = omega2_by_m1*sin_omega2_tau;
    const double t260 = p2*t259;
    const double t261 = omega1_by_m1*sin_omega1_tau;
    const double t262 = p2*t261;
    const double carried_x1_1_by_w_by_m1 = p2*t255 - p2*t256 - p2_by_m1*t124 - t118*t262 + t121*t260;
    const double carried_x2_1_by_y_by_m1 = -cos_omega1_tau_by_m1*t14 + cos_omega2_tau_by_m1*p1 - p1_by_m1*t126;
    const double carried_x2_1_by_u_by_m1 = p3*t255 - p3*t256 - p3_by_m1*t124 - t145*t257 + t147*t258;
    const double t264 = -t14*t261;
    const double t265 = p1*t259;
    const double carried_x2_1_by_w_by_m1 = p1*t256 + p1_by_m1*t124 - t118*t264 - t121*t265 - t14*t255;
    const double t266 = omega2*sin_omega2_tau_by_m1;
    const double t267 = omega1*sin_omega1_tau_by_m1;
    const double carried_v1_1_by_y_by_m1 = p2*t266 - p2*t267 - p2_by_m1*t140 + t260 - t262;
    const double carried_v1_1_by_u_by_m1 = cos_omega1_tau_by_m1*p1 - cos_omega2_tau_by_m1*t14 + p1_by_m1*t126;
    const double carried_v1_1_by_w_by_m1 = carried_x1_1_by_y_by_m1;
    const double carried_v2_1_by_y_by_m1 = -p1*t266 + p1_by_m1*t140 + t14*t267 - t264 - t265;
    const double carried_v2_1_by_u_by_m1 = cos_omega1_tau_by_m1*p3 - cos_omega2_tau_by_m1*p3 + p3_by_m1*t126;
    const double carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1;
    /* d/dm2 of: Phi along tau */
    const double carried_x1_1_by_y_by_m2 = cos_omega1_tau_by_m2*p2 - cos_omega2_tau_by_m2*p2 + p2_by_m2*t126;
    const double t269 = sin_omega1_tau_by_m2*t16;
    const double t270 = sin_omega2_tau_by_m2*t19;
    const double t271 = omega1_by_m2*t118;
    const double t272 = omega2_by_m2*t121;
    const double carried_x1_1_by_u_by_m2 = p1*t269 - p1_by_m2*t124 - t135*t271 - t137*t272 - t14*t270;
    const double t273 = omega2_by_m2*sin_omega2_tau;
    const double t274 = p2*t273;
    const double t275 = omega1_by_m2*sin_omega1_tau;
    const double t276 = p2*t275;
    const double carried_x1_1_by_w_by_m2 = p2*t269 - p2*t270 - p2_by_m2*t124 - t118*t276 + t121*t274;
    const double carried_x2_1_by_y_by_m2 = -cos_omega1_tau_by_m2*t14 + cos_omega2_tau_by_m2*p1 - p1_by_m2*t126;
    const double carried_x2_1_by_u_by_m2 = p3*t269 - p3*t270 - p3_by_m2*t124 - t145*t271 + t147*t272;
    const double t278 = -t14*t275;
    const double t279 = p1*t273;
    const double carried_x2_1_by_w_by_m2 = p1*t270 + p1_by_m2*t124 - t118*t278 - t121*t279 - t14*t269;
    const double t280 = omega2*sin_omega2_tau_by_m2;
    const double t281 = omega1*sin_omega1_tau_by_m2;
    const double carried_v1_1_by_y_by_m2 = p2*t280 - p2*t281 - p2_by_m2*t140 + t274 - t276;
    const double carried_v1_1_by_u_by_m2 = cos_omega1_tau_by_m2*p1 - cos_omega2_tau_by_m2*t14 + p1_by_m2*t126;
    const double carried_v1_1_by_w_by_m2 = carried_x1_1_by_y_by_m2;
    const double carried_v2_1_by_y_by_m2 = -p1*t280 + p1_by_m2*t140 + t14*t281 - t278 - t279;
    const double carried_v2_1_by_u_by_m2 = cos_omega1_tau_by_m2*p3 - cos_omega2_tau_by_m2*p3 + p3_by_m2*t126;
    const double carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2;
    /* d/dk1 of: Phi along tau */
    const double carried_x1_1_by_y_by_k1 = cos_omega1_tau_by_k1*p2 - cos_omega2_tau_by_k1*p2 + p2_by_k1*t126;
    const double t283 = sin_omega1_tau_by_k1*t16;
    const double t284 = sin_omega2_tau_by_k1*t19;
    const double t285 = omega1_by_k1*t118;
    const double t286 = omega2_by_k1*t121;
    const double carried_x1_1_by_u_by_k1 = p1*t283 - p1_by_k1*t124 - t135*t285 - t137*t286 - t14*t284;
    const double t287 = omega2_by_k1*sin_omega2_tau;
    const double t288 = p2*t287;
    const double t289 = omega1_by_k1*sin_omega1_tau;
    const double t290 = p2*t289;
    const double carried_x1_1_by_w_by_k1 = p2*t283 - p2*t284 - p2_by_k1*t124 - t118*t290 + t121*t288;
    const double carried_x2_1_by_y_by_k1 = -cos_omega1_tau_by_k1*t14 + cos_omega2_tau_by_k1*p1 - p1_by_k1*t126;
    const double carried_x2_1_by_u_by_k1 = p3*t283 - p3*t284 - p3_by_k1*t124 - t145*t285 + t147*t286;
    const double t292 = -t14*t289;
    const double t293 = p1*t287;
    const double carried_x2_1_by_w_by_k1 = p1*t284 + p1_by_k1*t124 - t118*t292 - t121*t293 - t14*t283;
    const double t294 = omega2*sin_omega2_tau_by_k1;
    const double t295 = omega1*sin_omega1_tau_by_k1;
    const double carried_v1_1_by_y_by_k1 = p2*t294 - p2*t295 - p2_by_k1*t140 + t288 - t290;
    const double carried_v1_1_by_u_by_k1 = cos_omega1_tau_by_k1*p1 - cos_omega2_tau_by_k1*t14 + p1_by_k1*t126;
    const double carried_v1_1_by_w_by_k1 = carried_x1_1_by_y_by_k1;
    const double carried_v2_1_by_y_by_k1 = -p1*t294 + p1_by_k1*t140 + t14*t295 - t292 - t293;
    const double carried_v2_1_by_u_by_k1 = cos_omega1_tau_by_k1*p3 - cos_omega2_tau_by_k1*p3 + p3_by_k1*t126;
    const double carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1;
    /* d/dk2 of: Phi along tau */
    const double carried_x1_1_by_y_by_k2 = cos_omega1_tau_by_k2*p2 - cos_omega2_tau_by_k2*p2 + p2_by_k2*t126;
    const double t297 = sin_omega1_tau_by_k2*t16;
    const double t298 = sin_omega2_tau_by_k2*t19;
    const double t299 = omega1_by_k2*t118;
    const double t300 = omega2_by_k2*t121;
    const double carried_x1_1_by_u_by_k2 = p1*t297 - p1_by_k2*t124 - t135*t299 - t137*t300 - t14*t298;
    const double t301 = omega2_by_k2*sin_omega2_tau;
    const double t302 = p2*t301;
    const double t303 = omega1_by_k2*sin_omega1_tau;
    const double t304 = p2*t303;
    const double carried_x1_1_by_w_by_k2 = p2*t297 - p2*t298 - p2_by_k2*t124 - t118*t304 + t121*t302;
    const double carried_x2_1_by_y_by_k2 = -cos_omega1_tau_by_k2*t14 + cos_omega2_tau_by_k2*p1 - p1_by_k2*t126;
    const double carried_x2_1_by_u_by_k2 = p3*t297 - p3*t298 - p3_by_k2*t124 - t145*t299 + t147*t300;
    const double t306 = -t14*t303;
    const double t307 = p1*t301;
    const double carried_x2_1_by_w_by_k2 = p1*t298 + p1_by_k2*t124 - t118*t306 - t121*t307 - t14*t297;
    const double t308 = omega2*sin_omega2_tau_by_k2;
    const double t309 = omega1*sin_omega1_tau_by_k2;
    const double carried_v1_1_by_y_by_k2 = p2*t308 - p2*t309 - p2_by_k2*t140 + t302 - t304;
    const double carried_v1_1_by_u_by_k2 = cos_omega1_tau_by_k2*p1 - cos_omega2_tau_by_k2*t14 + p1_by_k2*t126;
    const double carried_v1_1_by_w_by_k2 = carried_x1_1_by_y_by_k2;
    const double carried_v2_1_by_y_by_k2 = -p1*t308 + p1_by_k2*t140 + t14*t309 - t306 - t307;
    const double carried_v2_1_by_u_by_k2 = cos_omega1_tau_by_k2*p3 - cos_omega2_tau_by_k2*p3 + p3_by_k2*t126;
    const double carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2;
    /* d/dk3 of: Phi along tau */
    const double carried_x1_1_by_y_by_k3 = cos_omega1_tau_by_k3*p2 - cos_omega2_tau_by_k3*p2 + p2_by_k3*t126;
    const double t311 = sin_omega1_tau_by_k3*t16;
    const double t312 = sin_omega2_tau_by_k3*t19;
    const double t313 = omega1_by_k3*t118;
    const double t314 = omega2_by_k3*t121;
    const double carried_x1_1_by_u_by_k3 = p1*t311 - p1_by_k3*t124 - t135*t313 - t137*t314 - t14*t312;
    const double t315 = omega2_by_k3*sin_omega2_tau;
    const double t316 = p2*t315;
    const double t317 = omega1_by_k3*sin_omega1_tau;
    const double t318 = p2*t317;
    const double carried_x1_1_by_w_by_k3 = p2*t311 - p2*t312 - p2_by_k3*t124 - t118*t318 + t121*t316;
    const double carried_x2_1_by_y_by_k3 = -cos_omega1_tau_by_k3*t14 + cos_omega2_tau_by_k3*p1 - p1_by_k3*t126;
    const double carried_x2_1_by_u_by_k3 = p3*t311 - p3*t312 - p3_by_k3*t124 - t145*t313 + t147*t314;
    const double t320 = -t14*t317;
    const double t321 = p1*t315;
    const double carried_x2_1_by_w_by_k3 = p1*t312 + p1_by_k3*t124 - t118*t320 - t121*t321 - t14*t311;
    const double t322 = omega2*sin_omega2_tau_by_k3;
    const double t323 = omega1*sin_omega1_tau_by_k3;
    const double carried_v1_1_by_y_by_k3 = p2*t322 - p2*t323 - p2_by_k3*t140 + t316 - t318;
    const double carried_v1_1_by_u_by_k3 = cos_omega1_tau_by_k3*p1 - cos_omega2_tau_by_k3*t14 + p1_by_k3*t126;
    const double carried_v1_1_by_w_by_k3 = carried_x1_1_by_y_by_k3;
    const double carried_v2_1_by_y_by_k3 = -p1*t322 + p1_by_k3*t140 + t14*t323 - t320 - t321;
    const double carried_v2_1_by_u_by_k3 = cos_omega1_tau_by_k3*p3 - cos_omega2_tau_by_k3*p3 + p3_by_k3*t126;
    const double carried_v2_1_by_w_by_k3 = carried_x2_1_by_y_by_k3;
    /* d/dy of: rate of the exit boundary after tau */
    const double rate_1_by_y = -v1_1_by_y;
    /* d/du of: rate of the exit boundary after tau */
    const double rate_1_by_u = -v1_1_by_u;
    /* d/dw of: rate of the exit boundary after tau */
    const double rate_1_by_w = -v1_1_by_w;
    /* d/dtau of: rate of the exit boundary after tau */
    const double rate_1_by_tau = -v1_1_by_tau;
    /* d/dm1 of: rate of the exit boundary after tau */
    const double rate_1_by_m1 = -v1_1_by_m1;
    /* d/dm2 of: rate of the exit boundary after tau */
    const double rate_1_by_m2 = -v1_1_by_m2;
    /* d/dk1 of: rate of the exit boundary after tau */
    const double rate_1_by_k1 = -v1_1_by_k1;
    /* d/dk2 of: rate of the exit boundary after tau */
    const double rate_1_by_k2 = -v1_1_by_k2;
    /* d/dk3 of: rate of the exit boundary after tau */
    const double rate_1_by_k3 = -v1_1_by_k3;
    /* d/dy of: derivatives of the time to the boundary after tau */
    const double t324 = (1.0/(rate_1*rate_1));
    const double t325 = rate_1_by_y*t324;
    const double delay_tau_by_y_by_y = -carried_x1_1_by_y*t325;
    const double delay_tau_by_u_by_y = -carried_x1_1_by_u*t325;
    const double delay_tau_by_w_by_y = -carried_x1_1_by_w*t325;
    /* d/du of: derivatives of the time to the boundary after tau */
    const double t326 = rate_1_by_u*t324;
    const double delay_tau_by_y_by_u = -carried_x1_1_by_y*t326;
    const double delay_tau_by_u_by_u = -carried_x1_1_by_u*t326;
    const double delay_tau_by_w_by_u = -carried_x1_1_by_w*t326;
    /* d/dw of: derivatives of the time to the boundary after tau */
    const double t327 = rate_1_by_w*t324;
    const double delay_tau_by_y_by_w = -carried_x1_1_by_y*t327;
    const double delay_tau_by_u_by_w = -carried_x1_1_by_u*t327;
    const double delay_tau_by_w_by_w = -carried_x1_1_by_w*t327;
    /* d/dtau of: derivatives of the time to the boundary after tau */
    const double t328 = rate_1_by_tau*t324;
    const double delay_tau_by_y_by_tau = -carried_x1_1_by_y*t328 + carried_x1_1_by_y_by_tau*t72;
    const double delay_tau_by_u_by_tau = -carried_x1_1_by_u*t328 + carried_x1_1_by_u_by_tau*t72;
    const double delay_tau_by_w_by_tau = -carried_x1_1_by_w*t328 + carried_x1_1_by_w_by_tau*t72;
    /* d/dm1 of: derivatives of the time to the boundary after tau */
    const double t329 = rate_1_by_m1*t324;
    const double delay_tau_by_y_by_m1 = -carried_x1_1_by_y*t329 + carried_x1_1_by_y_by_m1*t72;
    const double delay_tau_by_u_by_m1 = -carried_x1_1_by_u*t329 + carried_x1_1_by_u_by_m1*t72;
    const double delay_tau_by_w_by_m1 = -carried_x1_1_by_w*t329 + carried_x1_1_by_w_by_m1*t72;
    /* d/dm2 of: derivatives of the time to the boundary after tau */
    const double t330 = rate_1_by_m2*t324;
    const double delay_tau_by_y_by_m2 = -carried_x1_1_by_y*t330 + carried_x1_1_by_y_by_m2*t72;
    const double delay_tau_by_u_by_m2 = -carried_x1_1_by_u*t330 + carried_x1_1_by_u_by_m2*t72;
    const double delay_tau_by_w_by_m2 = -carried_x1_1_by_w*t330 + carried_x1_1_by_w_by_m2*t72;
    /* d/dk1 of: derivatives of the time to the boundary after tau */
    const double t331 = rate_1_by_k1*t324;
    const double delay_tau_by_y_by_k1 = -carried_x1_1_by_y*t331 + carried_x1_1_by_y_by_k1*t72;
    const double delay_tau_by_u_by_k1 = -carried_x1_1_by_u*t331 + carried_x1_1_by_u_by_k1*t72;
    const double delay_tau_by_w_by_k1 = -carried_x1_1_by_w*t331 + carried_x1_1_by_w_by_k1*t72;
    /* d/dk2 of: derivatives of the time to the boundary after tau */
    const double t332 = rate_1_by_k2*t324;
    const double delay_tau_by_y_by_k2 = -carried_x1_1_by_y*t332 + carried_x1_1_by_y_by_k2*t72;
    const double delay_tau_by_u_by_k2 = -carried_x1_1_by_u*t332 + carried_x1_1_by_u_by_k2*t72;
    const double delay_tau_by_w_by_k2 = -carried_x1_1_by_w*t332 + carried_x1_1_by_w_by_k2*t72;
    /* d/dk3 of: derivatives of the time to the boundary after tau */
    const double t333 = rate_1_by_k3*t324;
    const double delay_tau_by_y_by_k3 = -carried_x1_1_by_y*t333 + carried_x1_1_by_y_by_k3*t72;
    const double delay_tau_by_u_by_k3 = -carried_x1_1_by_u*t333 + carried_x1_1_by_u_by_k3*t72;
    const double delay_tau_by_w_by_k3 = -carried_x1_1_by_w*t333 + carried_x1_1_by_w_by_k3*t72;
    /* d/dy of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_y = delay_tau_by_y*v1_1_by_y + delay_tau_by_y_by_y*v1_1;
    const double x1_1_on_boundary_by_u_by_y = delay_tau_by_u*v1_1_by_y + delay_tau_by_u_by_y*v1_1;
    const double x1_1_on_boundary_by_w_by_y = delay_tau_by_w*v1_1_by_y + delay_tau_by_w_by_y*v1_1;
    const double x2_1_on_boundary_by_y_by_y = delay_tau_by_y*v2_1_by_y + delay_tau_by_y_by_y*v2_1;
    const double x2_1_on_boundary_by_u_by_y = delay_tau_by_u*v2_1_by_y + delay_tau_by_u_by_y*v2_1;
    const double x2_1_on_boundary_by_w_by_y = delay_tau_by_w*v2_1_by_y + delay_tau_by_w_by_y*v2_1;
    const double t334 = delay_tau_by_y*t73;
    const double t335 = k1*x2_1_by_y;
    const double t336 = t74*x1_1_by_y;
    const double v1_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t76 + t334*t335 - t334*t336;
    const double t337 = delay_tau_by_u*t73;
    const double v1_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t76 + t335*t337 - t336*t337;
    const double t338 = delay_tau_by_w*t73;
    const double v1_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t76 + t335*t338 - t336*t338;
    const double t339 = delay_tau_by_y*t77;
    const double t340 = k1*x1_1_by_y;
    const double t341 = t79*x2_1_by_y;
    const double v2_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t81 + t339*t340 - t339*t341;
    const double t342 = delay_tau_by_u*t77;
    const double v2_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t81 + t340*t342 - t341*t342;
    const double t343 = delay_tau_by_w*t77;
    const double v2_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t81 + t340*t343 - t341*t343;
    /* d/du of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_u = delay_tau_by_y*v1_1_by_u + delay_tau_by_y_by_u*v1_1;
    const double x1_1_on_boundary_by_u_by_u = delay_tau_by_u*v1_1_by_u + delay_tau_by_u_by_u*v1_1;
    const double x1_1_on_boundary_by_w_by_u = delay_tau_by_w*v1_1_by_u + delay_tau_by_w_by_u*v1_1;
    const double x2_1_on_boundary_by_y_by_u = delay_tau_by_y*v2_1_by_u + delay_tau_by_y_by_u*v2_1;
    const double x2_1_on_boundary_by_u_by_u = delay_tau_by_u*v2_1_by_u + delay_tau_by_u_by_u*v2_1;
    const double x2_1_on_boundary_by_w_by_u = delay_tau_by_w*v2_1_by_u + delay_tau_by_w_by_u*v2_1;
    const double t344 = k1*x2_1_by_u;
    const double t345 = t74*x1_1_by_u;
    const double v1_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t76 + t334*t344 - t334*t345;
    const double v1_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t76 + t337*t344 - t337*t345;
    const double v1_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t76 + t338*t344 - t338*t345;
    const double t346 = k1*x1_1_by_u;
    const double t347 = t79*x2_1_by_u;
    const double v2_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t81 + t339*t346 - t339*t347;
    const double v2_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t81 + t342*t346 - t342*t347;
    const double v2_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t81 + t343*t346 - t343*t347;
    /* d/dw of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_w = delay_tau_by_y*v1_1_by_w + delay_tau_by_y_by_w*v1_1;
    const double x1_1_on_boundary_by_u_by_w = delay_tau_by_u*v1_1_by_w + delay_tau_by_u_by_w*v1_1;
    const double x1_1_on_boundary_by_w_by_w = delay_tau_by_w*v1_1_by_w + delay_tau_by_w_by_w*v1_1;
    const double x2_1_on_boundary_by_y_by_w = delay_tau_by_y*v2_1_by_w + delay_tau_by_y_by_w*v2_1;
    const double x2_1_on_boundary_by_u_by_w = delay_tau_by_u*v2_1_by_w + delay_tau_by_u_by_w*v2_1;
    const double x2_1_on_boundary_by_w_by_w = delay_tau_by_w*v2_1_by_w + delay_tau_by_w_by_w*v2_1;
    const double t348 = k1*x2_1_by_w;
    const double t349 = t74*x1_1_by_w;
    const double v1_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t76 + t334*t348 - t334*t349;
    const double v1_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t76 + t337*t348 - t337*t349;
    const double v1_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t76 + t338*t348 - t338*t349;
    const double t350 = k1*x1_1_by_w;
    const double t351 = t79*x2_1_by_w;
    const double v2_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t81 + t339*t350 - t339*t351;
    const double v2_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t81 + t342*t350 - t342*t351;
    const double v2_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t81 + t343*t350 - t343*t351;
    /* d/dtau of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_tau = carried_x1_1_by_y_by_tau + delay_tau_by_y*v1_1_by_tau + delay_tau_by_y_by_tau*v1_1;
    const double x1_1_on_boundary_by_u_by_tau = carried_x1_1_by_u_by_tau + delay_tau_by_u*v1_1_by_tau + delay_tau_by_u_by_tau*v1_1;
    const double x1_1_on_boundary_by_w_by_tau = carried_x1_1_by_w_by_tau + delay_tau_by_w*v1_1_by_tau + delay_tau_by_w_by_tau*v1_1;
    const double x2_1_on_boundary_by_y_by_tau = carried_x2_1_by_y_by_tau + delay_tau_by_y*v2_1_by_tau + delay_tau_by_y_by_tau*v2_1;
    const double x2_1_on_boundary_by_u_by_tau = carried_x2_1_by_u_by_tau + delay_tau_by_u*v2_1_by_tau + delay_tau_by_u_by_tau*v2_1;
    const double x2_1_on_boundary_by_w_by_tau = carried_x2_1_by_w_by_tau + delay_tau_by_w*v2_1_by_tau + delay_tau_by_w_by_tau*v2_1;
    const double t352 = k1*x2_1_by_tau;
    const double t353 = t74*x1_1_by_tau;
    const double v1_1_on_boundary_by_y_by_tau = carried_v1_1_by_y_by_tau + delay_tau_by_y_by_tau*t76 + t334*t352 - t334*t353;
    const double v1_1_on_boundary_by_u_by_tau = carried_v1_1_by_u_by_tau + delay_tau_by_u_by_tau*t76 + t337*t352 - t337*t353;
    const double v1_1_on_boundary_by_w_by_tau = carried_v1_1_by_w_by_tau + delay_tau_by_w_by_tau*t76 + t338*t352 - t338*t353;
    const double t354 = k1*x1_1_by_tau;
    const double t355 = t79*x2_1_by_tau;
    const double v2_1_on_boundary_by_y_by_tau = carried_v2_1_by_y_by_tau + delay_tau_by_y_by_tau*t81 + t339*t354 - t339*t355;
    const double v2_1_on_boundary_by_u_by_tau = carried_v2_1_by_u_by_tau + delay_tau_by_u_by_tau*t81 + t342*t354 - t342*t355;
    const double v2_1_on_boundary_by_w_by_tau = carried_v2_1_by_w_by_tau + delay_tau_by_w_by_tau*t81 + t343*t354 - t343*t355;
    /* d/dm1 of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_m1 = carried_x1_1_by_y_by_m1 + delay_tau_by_y*v1_1_by_m1 + delay_tau_by_y_by_m1*v1_1;
    const double x1_1_on_boundary_by_u_by_m1 = carried_x1_1_by_u_by_m1 + delay_tau_by_u*v1_1_by_m1 + delay_tau_by_u_by_m1*v1_1;
    const double x1_1_on_boundary_by_w_by_m1 = carried_x1_1_by_w_by_m1 + delay_tau_by_w*v1_1_by_m1 + delay_tau_by_w_by_m1*v1_1;
    const double x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_tau_by_y*v2_1_by_m1 + delay_tau_by_y_by_m1*v2_1;
    const double x2_1_on_boundary_by_u_by_m1 = carried_x2_1_by_u_by_m1 + delay_tau_by_u*v2_1_by_m1 + delay_tau_by_u_by_m1*v2_1;
    const double x2_1_on_boundary_by_w_by_m1 = carried_x2_1_by_w_by_m1 + delay_tau_by_w*v2_1_by_m1 + delay_tau_by_w_by_m1*v2_1;
    const double t356 = (1.0/(m1*m1));
    const double t357 = k1*t356;
    const double t358 = -k3*t356 + t356*t74*x1_1 - t357*x2_1;
    const double t359 = k1*x2_1_by_m1;
    const double t360 = t74*x1_1_by_m1;
    const double v1_1_on_boundary_by_y_by_m1 = carried_v1_1_by_y_by_m1 + delay_tau_by_y*t358 + delay_tau_by_y_by_m1*t76 + t334*t359 - t334*t360;
    const double v1_1_on_boundary_by_u_by_m1 = carried_v1_1_by_u_by_m1 + delay_tau_by_u*t358 + delay_tau_by_u_by_m1*t76 + t337*t359 - t337*t360;
    const double v1_1_on_boundary_by_w_by_m1 = carried_v1_1_by_w_by_m1 + delay_tau_by_w*t358 + delay_tau_by_w_by_m1*t76 + t338*t359 - t338*t360;
    const double t361 = k1*x1_1_by_m1;
    const double t362 = t79*x2_1_by_m1;
    const double v2_1_on_boundary_by_y_by_m1 = carried_v2_1_by_y_by_m1 + delay_tau_by_y_by_m1*t81 + t339*t361 - t339*t362;
    const double v2_1_on_boundary_by_u_by_m1 = carried_v2_1_by_u_by_m1 + delay_tau_by_u_by_m1*t81 + t342*t361 - t342*t362;
    const double v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_tau_by_w_by_m1*t81 + t343*t361 - t343*t362;
    /* d/dm2 of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_m2 = carried_x1_1_by_y_by_m2 + delay_tau_by_y*v1_1_by_m2 + delay_tau_by_y_by_m2*v1_1;
    const double x1_1_on_boundary_by_u_by_m2 = carried_x1_1_by_u_by_m2 + delay_tau_by_u*v1_1_by_m2 + delay_tau_by_u_by_m2*v1_1;
    const double x1_1_on_boundary_by_w_by_m2 = carried_x1_1_by_w_by_m2 + delay_tau_by_w*v1_1_by_m2 + delay_tau_by_w_by_m2*v1_1;
    const double x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_tau_by_y*v2_1_by_m2 + delay_tau_by_y_by_m2*v2_1;
    const double x2_1_on_boundary_by_u_by_m2 = carried_x2_1_by_u_by_m2 + delay_tau_by_u*v2_1_by_m2 + delay_tau_by_u_by_m2*v2_1;
    const double x2_1_on_boundary_by_w_by_m2 = carried_x2_1_by_w_by_m2 + delay_tau_by_w*v2_1_by_m2 + delay_tau_by_w_by_m2*v2_1;
    const double t363 = k1*x2_1_by_m2;
    const double t364 = t74*x1_1_by_m2;
    const double v1_1_on_boundary_by_y_by_m2 = carried_v1_1_by_y_by_m2 + delay_tau_by_y_by_m2*t76 + t334*t363 - t334*t364;
    const double v1_1_on_boundary_by_u_by_m2 = carried_v1_1_by_u_by_m2 + delay_tau_by_u_by_m2*t76 + t337*t363 - t337*t364;
    const double v1_1_on_boundary_by_w_by_m2 = carried_v1_1_by_w_by_m2 + delay_tau_by_w_by_m2*t76 + t338*t363 - t338*t364;
    const double t365 = (1.0/(m2*m2));
    const double t366 = k1*t365;
    const double t367 = t365*t79*x2_1 - t366*x1_1;
    const double t368 = k1*x1_1_by_m2;
    const double t369 = t79*x2_1_by_m2;
    const double v2_1_on_boundary_by_y_by_m2 = carried_v2_1_by_y_by_m2 + delay_tau_by_y*t367 + delay_tau_by_y_by_m2*t81 + t339*t368 - t339*t369;
    const double v2_1_on_boundary_by_u_by_m2 = carried_v2_1_by_u_by_m2 + delay_tau_by_u*t367 + delay_tau_by_u_by_m2*t81 + t342*t368 - t342*t369;
    const double v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_tau_by_w*t367 + delay_tau_by_w_by_m2*t81 + t343*t368 - t343*t369;
    /* d/dk1 of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_k1 = carried_x1_1_by_y_by_k1 + delay_tau_by_y*v1_1_by_k1 + delay_tau_by_y_by_k1*v1_1;
    const double x1_1_on_boundary_by_u_by_k1 = carried_x1_1_by_u_by_k1 + delay_tau_by_u*v1_1_by_k1 + delay_tau_by_u_by_k1*v1_1;
    const double x1_1_on_boundary_by_w_by_k1 = carried_x1_1_by_w_by_k1 + delay_tau_by_w*v1_1_by_k1 + delay_tau_by_w_by_k1*v1_1;
    const double x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_tau_by_y*v2_1_by_k1 + delay_tau_by_y_by_k1*v2_1;
    const double x2_1_on_boundary_by_u_by_k1 = carried_x2_1_by_u_by_k1 + delay_tau_by_u*v2_1_by_k1 + delay_tau_by_u_by_k1*v2_1;
    const double x2_1_on_boundary_by_w_by_k1 = carried_x2_1_by_w_by_k1 + delay_tau_by_w*v2_1_by_k1 + delay_tau_by_w_by_k1*v2_1;
    const double t370 = t73*x2_1 - t75;
    const double t371 = k1*x2_1_by_k1;
    const double t372 = t74*x1_1_by_k1;
    const double v1_1_on_boundary_by_y_by_k1 = carried_v1_1_by_y_by_k1 + delay_tau_by_y*t370 + delay_tau_by_y_by_k1*t76 + t334*t371 - t334*t372;
    const double v1_1_on_boundary_by_u_by_k1 = carried_v1_1_by_u_by_k1 + delay_tau_by_u*t370 + delay_tau_by_u_by_k1*t76 + t337*t371 - t337*t372;
    const double v1_1_on_boundary_by_w_by_k1 = carried_v1_1_by_w_by_k1 + delay_tau_by_w*t370 + delay_tau_by_w_by_k1*t76 + t338*t371 - t338*t372;
    const double t373 = t78 - t80;
    const double t374 = k1*x1_1_by_k1;
    const double t375 = t79*x2_1_by_k1;
    const double v2_1_on_boundary_by_y_by_k1 = carried_v2_1_by_y_by_k1 + delay_tau_by_y*t373 + delay_tau_by_y_by_k1*t81 + t339*t374 - t339*t375;
    const double v2_1_on_boundary_by_u_by_k1 = carried_v2_1_by_u_by_k1 + delay_tau_by_u*t373 + delay_tau_by_u_by_k1*t81 + t342*t374 - t342*t375;
    const double v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_tau_by_w*t373 + delay_tau_by_w_by_k1*t81 + t343*t374 - t343*t375;
    /* d/dk2 of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_k2 = carried_x1_1_by_y_by_k2 + delay_tau_by_y*v1_1_by_k2 + delay_tau_by_y_by_k2*v1_1;
    const double x1_1_on_boundary_by_u_by_k2 = carried_x1_1_by_u_by_k2 + delay_tau_by_u*v1_1_by_k2 + delay_tau_by_u_by_k2*v1_1;
    const double x1_1_on_boundary_by_w_by_k2 = carried_x1_1_by_w_by_k2 + delay_tau_by_w*v1_1_by_k2 + delay_tau_by_w_by_k2*v1_1;
    const double x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_tau_by_y*v2_1_by_k2 + delay_tau_by_y_by_k2*v2_1;
    const double x2_1_on_boundary_by_u_by_k2 = carried_x2_1_by_u_by_k2 + delay_tau_by_u*v2_1_by_k2 + delay_tau_by_u_by_k2*v2_1;
    const double x2_1_on_boundary_by_w_by_k2 = carried_x2_1_by_w_by_k2 + delay_tau_by_w*v2_1_by_k2 + delay_tau_by_w_by_k2*v2_1;
    const double t376 = k1*x2_1_by_k2;
    const double t377 = t74*x1_1_by_k2;
    const double v1_1_on_boundary_by_y_by_k2 = carried_v1_1_by_y_by_k2 + delay_tau_by_y_by_k2*t76 + t334*t376 - t334*t377;
    const double v1_1_on_boundary_by_u_by_k2 = carried_v1_1_by_u_by_k2 + delay_tau_by_u_by_k2*t76 + t337*t376 - t337*t377;
    const double v1_1_on_boundary_by_w_by_k2 = carried_v1_1_by_w_by_k2 + delay_tau_by_w_by_k2*t76 + t338*t376 - t338*t377;
    const double t378 = k1*x1_1_by_k2;
    const double t379 = t79*x2_1_by_k2;
    const double v2_1_on_boundary_by_y_by_k2 = carried_v2_1_by_y_by_k2 - delay_tau_by_y*t80 + delay_tau_by_y_by_k2*t81 + t339*t378 - t339*t379;
    const double v2_1_on_boundary_by_u_by_k2 = carried_v2_1_by_u_by_k2 - delay_tau_by_u*t80 + delay_tau_by_u_by_k2*t81 + t342*t378 - t342*t379;
    const double v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_tau_by_w*t80 + delay_tau_by_w_by_k2*t81 + t343*t378 - t343*t379;
    /* d/dk3 of: perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y_by_k3 = carried_x1_1_by_y_by_k3 + delay_tau_by_y*v1_1_by_k3 + delay_tau_by_y_by_k3*v1_1;
    const double x1_1_on_boundary_by_u_by_k3 = carried_x1_1_by_u_by_k3 + delay_tau_by_u*v1_1_by_k3 + delay_tau_by_u_by_k3*v1_1;
    const double x1_1_on_boundary_by_w_by_k3 = carried_x1_1_by_w_by_k3 + delay_tau_by_w*v1_1_by_k3 + delay_tau_by_w_by_k3*v1_1;
    const double x2_1_on_boundary_by_y_by_k3 = carried_x2_1_by_y_by_k3 + delay_tau_by_y*v2_1_by_k3 + delay_tau_by_y_by_k3*v2_1;
    const double x2_1_on_boundary_by_u_by_k3 = carried_x2_1_by_u_by_k3 + delay_tau_by_u*v2_1_by_k3 + delay_tau_by_u_by_k3*v2_1;
    const double x2_1_on_boundary_by_w_by_k3 = carried_x2_1_by_w_by_k3 + delay_tau_by_w*v2_1_by_k3 + delay_tau_by_w_by_k3*v2_1;
    const double t380 = t73 - t75;
    const double t381 = k1*x2_1_by_k3;
    const double t382 = t74*x1_1_by_k3;
    const double v1_1_on_boundary_by_y_by_k3 = carried_v1_1_by_y_by_k3 + delay_tau_by_y*t380 + delay_tau_by_y_by_k3*t76 + t334*t381 - t334*t382;
    const double v1_1_on_boundary_by_u_by_k3 = carried_v1_1_by_u_by_k3 + delay_tau_by_u*t380 + delay_tau_by_u_by_k3*t76 + t337*t381 - t337*t382;
    const double v1_1_on_boundary_by_w_by_k3 = carried_v1_1_by_w_by_k3 + delay_tau_by_w*t380 + delay_tau_by_w_by_k3*t76 + t338*t381 - t338*t382;
    const double t383 = k1*x1_1_by_k3;
    const double t384 = t79*x2_1_by_k3;
    const double v2_1_on_boundary_by_y_by_k3 = carried_v2_1_by_y_by_k3 + delay_tau_by_y_by_k3*t81 + t339*t383 - t339*t384;
    const double v2_1_on_boundary_by_u_by_k3 = carried_v2_1_by_u_by_k3 + delay_tau_by_u_by_k3*t81 + t342*t383 - t342*t384;
    const double v2_1_on_boundary_by_w_by_k3 = carried_v2_1_by_w_by_k3 + delay_tau_by_w_by_k3*t81 + t343*t383 - t343*t384;
    /* d/dy of: Phi along tau1 */
    const double carried_x1_2_by_y_by_y = t58*v1_1_on_boundary_by_y_by_y + t59*v2_1_on_boundary_by_y_by_y + t60*x1_1_on_boundary_by_y_by_y + t61*x2_1_on_boundary_by_y_by_y;
    const double carried_x1_2_by_u_by_y = t58*v1_1_on_boundary_by_u_by_y + t59*v2_1_on_boundary_by_u_by_y + t60*x1_1_on_boundary_by_u_by_y + t61*x2_1_on_boundary_by_u_by_y;
    const double carried_x1_2_by_w_by_y = t58*v1_1_on_boundary_by_w_by_y + t59*v2_1_on_boundary_by_w_by_y + t60*x1_1_on_boundary_by_w_by_y + t61*x2_1_on_boundary_by_w_by_y;
    const double carried_x2_2_by_y_by_y = t62*v1_1_on_boundary_by_y_by_y + t63*v2_1_on_boundary_by_y_by_y + t64*x1_1_on_boundary_by_y_by_y + t65*x2_1_on_boundary_by_y_by_y;
    const double carried_v1_2_by_u_by_y = t60*v1_1_on_boundary_by_u_by_y + t61*v2_1_on_boundary_by_u_by_y + t68*x1_1_on_boundary_by_u_by_y + t69*x2_1_on_boundary_by_u_by_y;
    const double carried_v2_2_by_w_by_y = t64*v1_1_on_boundary_by_w_by_y + t65*v2_1_on_boundary_by_w_by_y + t70*x1_1_on_boundary_by_w_by_y + t71*x2_1_on_boundary_by_w_by_y;
    /* d/du of: Phi along tau1 */
    const double carried_x1_2_by_y_by_u = t58*v1_1_on_boundary_by_y_by_u + t59*v2_1_on_boundary_by_y_by_u + t60*x1_1_on_boundary_by_y_by_u + t61*x2_1_on_boundary_by_y_by_u;
    const double carried_x1_2_by_u_by_u = t58*v1_1_on_boundary_by_u_by_u + t59*v2_1_on_boundary_by_u_by_u + t60*x1_1_on_boundary_by_u_by_u + t61*x2_1_on_boundary_by_u_by_u;
    const double carried_x1_2_by_w_by_u = t58*v1_1_on_boundary_by_w_by_u + t59*v2_1_on_boundary_by_w_by_u + t60*x1_1_on_boundary_by_w_by_u + t61*x2_1_on_boundary_by_w_by_u;
    const double carried_x2_2_by_y_by_u = t62*v1_1_on_boundary_by_y_by_u + t63*v2_1_on_boundary_by_y_by_u + t64*x1_1_on_boundary_by_y_by_u + t65*x2_1_on_boundary_by_y_by_u;
    const double carried_v1_2_by_u_by_u = t60*v1_1_on_boundary_by_u_by_u + t61*v2_1_on_boundary_by_u_by_u + t68*x1_1_on_boundary_by_u_by_u + t69*x2_1_on_boundary_by_u_by_u;
    const double carried_v2_2_by_w_by_u = t64*v1_1_on_boundary_by_w_by_u + t65*v2_1_on_boundary_by_w_by_u + t70*x1_1_on_boundary_by_w_by_u + t71*x2_1_on_boundary_by_w_by_u;
    /* d/dw of: Phi along tau1 */
    const double carried_x1_2_by_y_by_w = t58*v1_1_on_boundary_by_y_by_w + t59*v2_1_on_boundary_by_y_by_w + t60*x1_1_on_boundary_by_y_by_w + t61*x2_1_on_boundary_by_y_by_w;
    const double carried_x1_2_by_u_by_w = t58*v1_1_on_boundary_by_u_by_w + t59*v2_1_on_boundary_by_u_by_w + t60*x1_1_on_boundary_by_u_by_w + t61*x2_1_on_boundary_by_u_by_w;
    const double carried_x1_2_by_w_by_w = t58*v1_1_on_boundary_by_w_by_w + t59*v2_1_on_boundary_by_w_by_w + t60*x1_1_on_boundary_by_w_by_w + t61*x2_1_on_boundary_by_w_by_w;
    const double carried_x2_2_by_y_by_w = t62*v1_1_on_boundary_by_y_by_w + t63*v2_1_on_boundary_by_y_by_w + t64*x1_1_on_boundary_by_y_by_w + t65*x2_1_on_boundary_by_y_by_w;
    const double carried_v1_2_by_u_by_w = t60*v1_1_on_boundary_by_u_by_w + t61*v2_1_on_boundary_by_u_by_w + t68*x1_1_on_boundary_by_u_by_w + t69*x2_1_on_boundary_by_u_by_w;
    const double carried_v2_2_by_w_by_w = t64*v1_1_on_boundary_by_w_by_w + t65*v2_1_on_boundary_by_w_by_w + t70*x1_1_on_boundary_by_w_by_w + t71*x2_1_on_boundary_by_w_by_w;
    /* d/dtau of: Phi along tau1 */
    const double t385 = p5*x2_1_on_boundary_by_y;
    const double t386 = p4*x1_1_on_boundary_by_y + t385;
    const double t387 = -t385 + t55*x1_1_on_boundary_by_y;
    const double t388 = p4*t53;
    const double t389 = p5*v2_1_on_boundary_by_y;
    const double t390 = t388*v1_1_on_boundary_by_y + t389*t53;
    const double t391 = -t389*t56 + t55*t56*v1_1_on_boundary_by_y;
    const double carried_x1_2_by_y_by_tau = cos_omega3_tau1_by_tau*t386 + cos_omega4_tau1_by_tau*t387 + sin_omega3_tau1_by_tau*t390 + sin_omega4_tau1_by_tau*t391 + t58*v1_1_on_boundary_by_y_by_tau + t59*v2_1_on_boundary_by_y_by_tau + t60*x1_1_on_boundary_by_y_by_tau + t61*x2_1_on_boundary_by_y_by_tau;
    const double t392 = p4*x1_1_on_boundary_by_u;
    const double t393 = p5*x2_1_on_boundary_by_u;
    const double t394 = t392 + t393;
    const double t395 = -t393 + t55*x1_1_on_boundary_by_u;
    const double t396 = p4*v1_1_on_boundary_by_u;
    const double t397 = p5*v2_1_on_boundary_by_u;
    const double t398 = t396*t53 + t397*t53;
    const double t399 = -t397*t56 + t55*t56*v1_1_on_boundary_by_u;
    const double carried_x1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t394 + cos_omega4_tau1_by_tau*t395 + sin_omega3_tau1_by_tau*t398 + sin_omega4_tau1_by_tau*t399 + t58*v1_1_on_boundary_by_u_by_tau + t59*v2_1_on_boundary_by_u_by_tau + t60*x1_1_on_boundary_by_u_by_tau + t61*x2_1_on_boundary_by_u_by_tau;
    const double t400 = p5*x2_1_on_boundary_by_w;
    const double t401 = p4*x1_1_on_boundary_by_w + t400;
    const double t402 = -t400 + t55*x1_1_on_boundary_by_w;
    const double t403 = p5*v2_1_on_boundary_by_w;
    const double t404 = t388*v1_1_on_boundary_by_w + t403*t53;
    const double t405 = -t403*t56 + t55*t56*v1_1_on_boundary_by_w;
    const double carried_x1_2_by_w_by_tau = cos_omega3_tau1_by_tau*t401 + cos_omega4_tau1_by_tau*t402 + sin_omega3_tau1_by_tau*t404 + sin_omega4_tau1_by_tau*t405 + t58*v1_1_on_boundary_by_w_by_tau + t59*v2_1_on_boundary_by_w_by_tau + t60*x1_1_on_boundary_by_w_by_tau + t61*x2_1_on_boundary_by_w_by_tau;
    const double t406 = p6*x1_1_on_boundary_by_y;
    const double t407 = t406 + t55*x2_1_on_boundary_by_y;
    const double t408 = p4*x2_1_on_boundary_by_y - t406;
    const double t409 = p6*v1_1_on_boundary_by_y;
    const double t410 = t55*v2_1_on_boundary_by_y;
    const double t411 = t409*t53 + t410*t53;
    const double t412 = p4*v2_1_on_boundary_by_y;
    const double t413 = -t409*t56 + t412*t56;
    const double carried_x2_2_by_y_by_tau = cos_omega3_tau1_by_tau*t407 + cos_omega4_tau1_by_tau*t408 + sin_omega3_tau1_by_tau*t411 + sin_omega4_tau1_by_tau*t413 + t62*v1_1_on_boundary_by_y_by_tau + t63*v2_1_on_boundary_by_y_by_tau + t64*x1_1_on_boundary_by_y_by_tau + t65*x2_1_on_boundary_by_y_by_tau;
    const double t414 = t396 + t397;
    const double t415 = -t397 + t55*v1_1_on_boundary_by_u;
    const double t416 = -omega3*t392 - omega3*t393;
    const double t417 = t55*x1_1_on_boundary_by_u;
    const double t418 = omega4*t393 - omega4*t417;
    const double carried_v1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t414 + cos_omega4_tau1_by_tau*t415 + sin_omega3_tau1_by_tau*t416 + sin_omega4_tau1_by_tau*t418 + t60*v1_1_on_boundary_by_u_by_tau + t61*v2_1_on_boundary_by_u_by_tau + t68*x1_1_on_boundary_by_u_by_tau + t69*x2_1_on_boundary_by_u_by_tau;
    const double t419 = p6*v1_1_on_boundary_by_w;
    const double t420 = t419 + t55*v2_1_on_boundary_by_w;
    const double t421 = p4*v2_1_on_boundary_by_w - t419;
    const double t422 = p6*x1_1_on_boundary_by_w;
    const double t423 = t55*x2_1_on_boundary_by_w;
    const double t424 = -omega3*t422 - omega3*t423;
    const double t425 = p4*x2_1_on_boundary_by_w;
    const double t426 = omega4*p6*x1_1_on_boundary_by_w - omega4*t425;
    const double carried_v2_2_by_w_by_tau = cos_omega3_tau1_by_tau*t420 + cos_omega4_tau1_by_tau*t421 + sin_omega3_tau1_by_tau*t424 + sin_omega4_tau1_by_tau*t426 + t64*v1_1_on_boundary_by_w_by_tau + t65*v2_1_on_boundary_by_w_by_tau + t70*x1_1_on_boundary_by_w_by_tau + t71*x2_1_on_boundary_by_w_by_tau;
    /* d/dm1 of: Phi along tau1 */
    const double t427 = p4*t226;
    const double t428 = -t226*t389 - t427*v1_1_on_boundary_by_y;
    const double t429 = t229*t55;
    const double t430 = t229*t389 - t429*v1_1_on_boundary_by_y;
    const double t431 = -t231*v1_1_on_boundary_by_y + t233*x1_1_on_boundary_by_y;
    const double t432 = -t231*v2_1_on_boundary_by_y + t233*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t386 + cos_omega4_tau1_by_m1*t387 + omega3_by_m1*t428 + omega4_by_m1*t430 + p4_by_m1*t431 + p5_by_m1*t432 + sin_omega3_tau1_by_m1*t390 + sin_omega4_tau1_by_m1*t391 + t58*v1_1_on_boundary_by_y_by_m1 + t59*v2_1_on_boundary_by_y_by_m1 + t60*x1_1_on_boundary_by_y_by_m1 + t61*x2_1_on_boundary_by_y_by_m1;
    const double t433 = -t226*t396 - t226*t397;
    const double t434 = t229*t397 - t229*t55*v1_1_on_boundary_by_u;
    const double t435 = -t231*v1_1_on_boundary_by_u + t233*x1_1_on_boundary_by_u;
    const double t436 = -t231*v2_1_on_boundary_by_u + t233*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t394 + cos_omega4_tau1_by_m1*t395 + omega3_by_m1*t433 + omega4_by_m1*t434 + p4_by_m1*t435 + p5_by_m1*t436 + sin_omega3_tau1_by_m1*t398 + sin_omega4_tau1_by_m1*t399 + t58*v1_1_on_boundary_by_u_by_m1 + t59*v2_1_on_boundary_by_u_by_m1 + t60*x1_1_on_boundary_by_u_by_m1 + t61*x2_1_on_boundary_by_u_by_m1;
    const double t437 = -t226*t403 - t427*v1_1_on_boundary_by_w;
    const double t438 = t229*t403 - t429*v1_1_on_boundary_by_w;
    const double t439 = -t231*v1_1_on_boundary_by_w + t233*x1_1_on_boundary_by_w;
    const double t440 = -t231*v2_1_on_boundary_by_w + t233*x2_1_on_boundary_by_w;
    const double carried_x1_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t401 + cos_omega4_tau1_by_m1*t402 + omega3_by_m1*t437 + omega4_by_m1*t438 + p4_by_m1*t439 + p5_by_m1*t440 + sin_omega3_tau1_by_m1*t404 + sin_omega4_tau1_by_m1*t405 + t58*v1_1_on_boundary_by_w_by_m1 + t59*v2_1_on_boundary_by_w_by_m1 + t60*x1_1_on_boundary_by_w_by_m1 + t61*x2_1_on_boundary_by_w_by_m1;
    const double t441 = -t226*t409 - t226*t410;
    const double t442 = p6*sin_omega4_tau1*t228*v1_1_on_boundary_by_y - t229*t412;
    const double t443 = t231*v2_1_on_boundary_by_y - t233*x2_1_on_boundary_by_y;
    const double carried_x2_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t407 + cos_omega4_tau1_by_m1*t408 + omega3_by_m1*t441 + omega4_by_m1*t442 + p4_by_m1*t443 + p6_by_m1*t431 + sin_omega3_tau1_by_m1*t411 + sin_omega4_tau1_by_m1*t413 + t62*v1_1_on_boundary_by_y_by_m1 + t63*v2_1_on_boundary_by_y_by_m1 + t64*x1_1_on_boundary_by_y_by_m1 + t65*x2_1_on_boundary_by_y_by_m1;
    const double t444 = -sin_omega3_tau1*t392 - sin_omega3_tau1*t393;
    const double t445 = sin_omega4_tau1*t393 - sin_omega4_tau1*t417;
    const double t446 = t233*v1_1_on_boundary_by_u - t242*x1_1_on_boundary_by_u;
    const double t447 = t233*v2_1_on_boundary_by_u - t242*x2_1_on_boundary_by_u;
    const double carried_v1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t414 + cos_omega4_tau1_by_m1*t415 + omega3_by_m1*t444 + omega4_by_m1*t445 + p4_by_m1*t446 + p5_by_m1*t447 + sin_omega3_tau1_by_m1*t416 + sin_omega4_tau1_by_m1*t418 + t60*v1_1_on_boundary_by_u_by_m1 + t61*v2_1_on_boundary_by_u_by_m1 + t68*x1_1_on_boundary_by_u_by_m1 + t69*x2_1_on_boundary_by_u_by_m1;
    const double t448 = -sin_omega3_tau1*t422 - sin_omega3_tau1*t423;
    const double t449 = p6*sin_omega4_tau1*x1_1_on_boundary_by_w - sin_omega4_tau1*t425;
    const double t450 = -t233*v2_1_on_boundary_by_w + t242*x2_1_on_boundary_by_w;
    const double t451 = t233*v1_1_on_boundary_by_w - t242*x1_1_on_boundary_by_w;
    const double carried_v2_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t420 + cos_omega4_tau1_by_m1*t421 + omega3_by_m1*t448 + omega4_by_m1*t449 + p4_by_m1*t450 + p6_by_m1*t451 + sin_omega3_tau1_by_m1*t424 + sin_omega4_tau1_by_m1*t426 + t64*v1_1_on_boundary_by_w_by_m1 + t65*v2_1_on_boundary_by_w_by_m1 + t70*x1_1_on_boundary_by_w_by_m1 + t71*x2_1_on_boundary_by_w_by_m1;
    /* d/dm2 of: Phi along tau1 */
    const double carried_x1_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t386 + cos_omega4_tau1_by_m2*t387 + omega3_by_m2*t428 + omega4_by_m2*t430 + p4_by_m2*t431 + p5_by_m2*t432 + sin_omega3_tau1_by_m2*t390 + sin_omega4_tau1_by_m2*t391 + t58*v1_1_on_boundary_by_y_by_m2 + t59*v2_1_on_boundary_by_y_by_m2 + t60*x1_1_on_boundary_by_y_by_m2 + t61*x2_1_on_boundary_by_y_by_m2;
    const double carried_x1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t394 + cos_omega4_tau1_by_m2*t395 + omega3_by_m2*t433 + omega4_by_m2*t434 + p4_by_m2*t435 + p5_by_m2*t436 + sin_omega3_tau1_by_m2*t398 + sin_omega4_tau1_by_m2*t399 + t58*v1_1_on_boundary_by_u_by_m2 + t59*v2_1_on_boundary_by_u_by_m2 + t60*x1_1_on_boundary_by_u_by_m2 + t61*x2_1_on_boundary_by_u_by_m2;
    const double carried_x1_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t401 + cos_omega4_tau1_by_m2*t402 + omega3_by_m2*t437 + omega4_by_m2*t438 + p4_by_m2*t439 + p5_by_m2*t440 + sin_omega3_tau1_by_m2*t404 + sin_omega4_tau1_by_m2*t405 + t58*v1_1_on_boundary_by_w_by_m2 + t59*v2_1_on_boundary_by_w_by_m2 + t60*x1_1_on_boundary_by_w_by_m2 + t61*x2_1_on_boundary_by_w_by_m2;
    const double carried_x2_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t407 + cos_omega4_tau1_by_m2*t408 + omega3_by_m2*t441 + omega4_by_m2*t442 + p4_by_m2*t443 + p6_by_m2*t431 + sin_omega3_tau1_by_m2*t411 + sin_omega4_tau1_by_m2*t413 + t62*v1_1_on_boundary_by_y_by_m2 + t63*v2_1_on_boundary_by_y_by_m2 + t64*x1_1_on_boundary_by_y_by_m2 + t65*x2_1_on_boundary_by_y_by_m2;
    const double carried_v1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t414 + cos_omega4_tau1_by_m2*t415 + omega3_by_m2*t444 + omega4_by_m2*t445 + p4_by_m2*t446 + p5_by_m2*t447 + sin_omega3_tau1_by_m2*t416 + sin_omega4_tau1_by_m2*t418 + t60*v1_1_on_boundary_by_u_by_m2 + t61*v2_1_on_boundary_by_u_by_m2 + t68*x1_1_on_boundary_by_u_by_m2 + t69*x2_1_on_boundary_by_u_by_m2;
    const double carried_v2_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t420 + cos_omega4_tau1_by_m2*t421 + omega3_by_m2*t448 + omega4_by_m2*t449 + p4_by_m2*t450 + p6_by_m2*t451 + sin_omega3_tau1_by_m2*t424 + sin_omega4_tau1_by_m2*t426 + t64*v1_1_on_boundary_by_w_by_m2 + t65*v2_1_on_boundary_by_w_by_m2 + t70*x1_1_on_boundary_by_w_by_m2 + t71*x2_1_on_boundary_by_w_by_m2;
    /* d/dk1 of: Phi along tau1 */
    const double carried_x1_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t386 + cos_omega4_tau1_by_k1*t387 + omega3_by_k1*t428 + omega4_by_k1*t430 + p4_by_k1*t431 + p5_by_k1*t432 + sin_omega3_tau1_by_k1*t390 + sin_omega4_tau1_by_k1*t391 + t58*v1_1_on_boundary_by_y_by_k1 + t59*v2_1_on_boundary_by_y_by_k1 + t60*x1_1_on_boundary_by_y_by_k1 + t61*x2_1_on_boundary_by_y_by_k1;
    const double carried_x1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t394 + cos_omega4_tau1_by_k1*t395 + omega3_by_k1*t433 + omega4_by_k1*t434 + p4_by_k1*t435 + p5_by_k1*t436 + sin_omega3_tau1_by_k1*t398 + sin_omega4_tau1_by_k1*t399 + t58*v1_1_on_boundary_by_u_by_k1 + t59*v2_1_on_boundary_by_u_by_k1 + t60*x1_1_on_boundary_by_u_by_k1 + t61*x2_1_on_boundary_by_u_by_k1;
    const double carried_x1_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t401 + cos_omega4_tau1_by_k1*t402 + omega3_by_k1*t437 + omega4_by_k1*t438 + p4_by_k1*t439 + p5_by_k1*t440 + sin_omega3_tau1_by_k1*t404 + sin_omega4_tau1_by_k1*t405 + t58*v1_1_on_boundary_by_w_by_k1 + t59*v2_1_on_boundary_by_w_by_k1 + t60*x1_1_on_boundary_by_w_by_k1 + t61*x2_1_on_boundary_by_w_by_k1;
    const double carried_x2_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t407 + cos_omega4_tau1_by_k1*t408 + omega3_by_k1*t441 + omega4_by_k1*t442 + p4_by_k1*t443 + p6_by_k1*t431 + sin_omega3_tau1_by_k1*t411 + sin_omega4_tau1_by_k1*t413 + t62*v1_1_on_boundary_by_y_by_k1 + t63*v2_1_on_boundary_by_y_by_k1 + t64*x1_1_on_boundary_by_y_by_k1 + t65*x2_1_on_boundary_by_y_by_k1;
    const double carried_v1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t414 + cos_omega4_tau1_by_k1*t415 + omega3_by_k1*t444 + omega4_by_k1*t445 + p4_by_k1*t446 + p5_by_k1*t447 + sin_omega3_tau1_by_k1*t416 + sin_omega4_tau1_by_k1*t418 + t60*v1_1_on_boundary_by_u_by_k1 + t61*v2_1_on_boundary_by_u_by_k1 + t68*x1_1_on_boundary_by_u_by_k1 + t69*x2_1_on_boundary_by_u_by_k1;
    const double carried_v2_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t420 + cos_omega4_tau1_by_k1*t421 + omega3_by_k1*t448 + omega4_by_k1*t449 + p4_by_k1*t450 + p6_by_k1*t451 + sin_omega3_tau1_by_k1*t424 + sin_omega4_tau1_by_k1*t426 + t64*v1_1_on_boundary_by_w_by_k1 + t65*v2_1_on_boundary_by_w_by_k1 + t70*x1_1_on_boundary_by_w_by_k1 + t71*x2_1_on_boundary_by_w_by_k1;
    /* d/dk2 of: Phi along tau1 */
    const double carried_x1_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t386 + cos_omega4_tau1_by_k2*t387 + omega3_by_k2*t428 + omega4_by_k2*t430 + p4_by_k2*t431 + p5_by_k2*t432 + sin_omega3_tau1_by_k2*t390 + sin_omega4_tau1_by_k2*t391 + t58*v1_1_on_boundary_by_y_by_k2 + t59*v2_1_on_boundary_by_y_by_k2 + t60*x1_1_on_boundary_by_y_by_k2 + t61*x2_1_on_boundary_by_y_by_k2;
    const double carried_x1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t394 + cos_omega4_tau1_by_k2*t395 + omega3_by_k2*t433 + omega4_by_k2*t434 + p4_by_k2*t435 + p5_by_k2*t436 + sin_omega3_tau1_by_k2*t398 + sin_omega4_tau1_by_k2*t399 + t58*v1_1_on_boundary_by_u_by_k2 + t59*v2_1_on_boundary_by_u_by_k2 + t60*x1_1_on_boundary_by_u_by_k2 + t61*x2_1_on_boundary_by_u_by_k2;
    const double carried_x1_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t401 + cos_omega4_tau1_by_k2*t402 + omega3_by_k2*t437 + omega4_by_k2*t438 + p4_by_k2*t439 + p5_by_k2*t440 + sin_omega3_tau1_by_k2*t404 + sin_omega4_tau1_by_k2*t405 + t58*v1_1_on_boundary_by_w_by_k2 + t59*v2_1_on_boundary_by_w_by_k2 + t60*x1_1_on_boundary_by_w_by_k2 + t61*x2_1_on_boundary_by_w_by_k2;
    const double carried_x2_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t407 + cos_omega4_tau1_by_k2*t408 + omega3_by_k2*t441 + omega4_by_k2*t442 + p4_by_k2*t443 + p6_by_k2*t431 + sin_omega3_tau1_by_k2*t411 + sin_omega4_tau1_by_k2*t413 + t62*v1_1_on_boundary_by_y_by_k2 + t63*v2_1_on_boundary_by_y_by_k2 + t64*x1_1_on_boundary_by_y_by_k2 + t65*x2_1_on_boundary_by_y_by_k2;
    const double carried_v1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t414 + cos_omega4_tau1_by_k2*t415 + omega3_by_k2*t444 + omega4_by_k2*t445 + p4_by_k2*t446 + p5_by_k2*t447 + sin_omega3_tau1_by_k2*t416 + sin_omega4_tau1_by_k2*t418 + t60*v1_1_on_boundary_by_u_by_k2 + t61*v2_1_on_boundary_by_u_by_k2 + t68*x1_1_on_boundary_by_u_by_k2 + t69*x2_1_on_boundary_by_u_by_k2;
    const double carried_v2_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t420 + cos_omega4_tau1_by_k2*t421 + omega3_by_k2*t448 + omega4_by_k2*t449 + p4_by_k2*t450 + p6_by_k2*t451 + sin_omega3_tau1_by_k2*t424 + sin_omega4_tau1_by_k2*t426 + t64*v1_1_on_boundary_by_w_by_k2 + t65*v2_1_on_boundary_by_w_by_k2 + t70*x1_1_on_boundary_by_w_by_k2 + t71*x2_1_on_boundary_by_w_by_k2;
    /* d/dk3 of: Phi along tau1 */
    const double carried_x1_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t386 + cos_omega4_tau1_by_k3*t387 + omega3_by_k3*t428 + omega4_by_k3*t430 + p4_by_k3*t431 + p5_by_k3*t432 + sin_omega3_tau1_by_k3*t390 + sin_omega4_tau1_by_k3*t391 + t58*v1_1_on_boundary_by_y_by_k3 + t59*v2_1_on_boundary_by_y_by_k3 + t60*x1_1_on_boundary_by_y_by_k3 + t61*x2_1_on_boundary_by_y_by_k3;
    const double carried_x1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t394 + cos_omega4_tau1_by_k3*t395 + omega3_by_k3*t433 + omega4_by_k3*t434 + p4_by_k3*t435 + p5_by_k3*t436 + sin_omega3_tau1_by_k3*t398 + sin_omega4_tau1_by_k3*t399 + t58*v1_1_on_boundary_by_u_by_k3 + t59*v2_1_on_boundary_by_u_by_k3 + t60*x1_1_on_boundary_by_u_by_k3 + t61*x2_1_on_boundary_by_u_by_k3;
    const double carried_x1_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t401 + cos_omega4_tau1_by_k3*t402 + omega3_by_k3*t437 + omega4_by_k3*t438 + p4_by_k3*t439 + p5_by_k3*t440 + sin_omega3_tau1_by_k3*t404 + sin_omega4_tau1_by_k3*t405 + t58*v1_1_on_boundary_by_w_by_k3 + t59*v2_1_on_boundary_by_w_by_k3 + t60*x1_1_on_boundary_by_w_by_k3 + t61*x2_1_on_boundary_by_w_by_k3;
    const double carried_x2_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t407 + cos_omega4_tau1_by_k3*t408 + omega3_by_k3*t441 + omega4_by_k3*t442 + p4_by_k3*t443 + p6_by_k3*t431 + sin_omega3_tau1_by_k3*t411 + sin_omega4_tau1_by_k3*t413 + t62*v1_1_on_boundary_by_y_by_k3 + t63*v2_1_on_boundary_by_y_by_k3 + t64*x1_1_on_boundary_by_y_by_k3 + t65*x2_1_on_boundary_by_y_by_k3;
    const double carried_v1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t414 + cos_omega4_tau1_by_k3*t415 + omega3_by_k3*t444 + omega4_by_k3*t445 + p4_by_k3*t446 + p5_by_k3*t447 + sin_omega3_tau1_by_k3*t416 + sin_omega4_tau1_by_k3*t418 + t60*v1_1_on_boundary_by_u_by_k3 + t61*v2_1_on_boundary_by_u_by_k3 + t68*x1_1_on_boundary_by_u_by_k3 + t69*x2_1_on_boundary_by_u_by_k3;
    const double carried_v2_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t420 + cos_omega4_tau1_by_k3*t421 + omega3_by_k3*t448 + omega4_by_k3*t449 + p4_by_k3*t450 + p6_by_k3*t451 + sin_omega3_tau1_by_k3*t424 + sin_omega4_tau1_by_k3*t426 + t64*v1_1_on_boundary_by_w_by_k3 + t65*v2_1_on_boundary_by_w_by_k3 + t70*x1_1_on_boundary_by_w_by_k3 + t71*x2_1_on_boundary_by_w_by_k3;
    /* d/dT of: Phi along tau1 */
    const double carried_x1_2_by_y_by_T = cos_omega3_tau1_by_T*t386 + cos_omega4_tau1_by_T*t387 + sin_omega3_tau1_by_T*t390 + sin_omega4_tau1_by_T*t391;
    const double carried_x1_2_by_u_by_T = cos_omega3_tau1_by_T*t394 + cos_omega4_tau1_by_T*t395 + sin_omega3_tau1_by_T*t398 + sin_omega4_tau1_by_T*t399;
    const double carried_x1_2_by_w_by_T = cos_omega3_tau1_by_T*t401 + cos_omega4_tau1_by_T*t402 + sin_omega3_tau1_by_T*t404 + sin_omega4_tau1_by_T*t405;
    const double carried_x2_2_by_y_by_T = cos_omega3_tau1_by_T*t407 + cos_omega4_tau1_by_T*t408 + sin_omega3_tau1_by_T*t411 + sin_omega4_tau1_by_T*t413;
    const double carried_v1_2_by_u_by_T = cos_omega3_tau1_by_T*t414 + cos_omega4_tau1_by_T*t415 + sin_omega3_tau1_by_T*t416 + sin_omega4_tau1_by_T*t418;
    const double carried_v2_2_by_w_by_T = cos_omega3_tau1_by_T*t420 + cos_omega4_tau1_by_T*t421 + sin_omega3_tau1_by_T*t424 + sin_omega4_tau1_by_T*t426;
    /* d/dy of: derivatives of the time to the boundary after tau1 */
    const double t452 = (1.0/(v1_2*v1_2));
    const double t453 = t452*v1_2_by_y;
    const double delay_tau1_by_y_by_y = carried_x1_2_by_y*t453 - carried_x1_2_by_y_by_y*t82;
    const double delay_tau1_by_u_by_y = carried_x1_2_by_u*t453 - carried_x1_2_by_u_by_y*t82;
    const double delay_tau1_by_w_by_y = carried_x1_2_by_w*t453 - carried_x1_2_by_w_by_y*t82;
    /* d/du of: derivatives of the time to the boundary after tau1 */
    const double t454 = t452*v1_2_by_u;
    const double delay_tau1_by_y_by_u = carried_x1_2_by_y*t454 - carried_x1_2_by_y_by_u*t82;
    const double delay_tau1_by_u_by_u = carried_x1_2_by_u*t454 - carried_x1_2_by_u_by_u*t82;
    const double delay_tau1_by_w_by_u = carried_x1_2_by_w*t454 - carried_x1_2_by_w_by_u*t82;
    /* d/dw of: derivatives of the time to the boundary after tau1 */
    const double t455 = t452*v1_2_by_w;
    const double delay_tau1_by_y_by_w = carried_x1_2_by_y*t455 - carried_x1_2_by_y_by_w*t82;
    const double delay_tau1_by_u_by_w = carried_x1_2_by_u*t455 - carried_x1_2_by_u_by_w*t82;
    const double delay_tau1_by_w_by_w = carried_x1_2_by_w*t455 - carried_x1_2_by_w_by_w*t82;
    /* d/dtau of: derivatives of the time to the boundary after tau1 */
    const double t456 = t452*v1_2_by_tau;
    const double delay_tau1_by_y_by_tau = carried_x1_2_by_y*t456 - carried_x1_2_by_y_by_tau*t82;
    const double delay_tau1_by_u_by_tau = carried_x1_2_by_u*t456 - carried_x1_2_by_u_by_tau*t82;
    const double delay_tau1_by_w_by_tau = carried_x1_2_by_w*t456 - carried_x1_2_by_w_by_tau*t82;
    /* d/dm1 of: derivatives of the time to the boundary after tau1 */
    const double t457 = t452*v1_2_by_m1;
    const double delay_tau1_by_y_by_m1 = carried_x1_2_by_y*t457 - carried_x1_2_by_y_by_m1*t82;
    const double delay_tau1_by_u_by_m1 = carried_x1_2_by_u*t457 - carried_x1_2_by_u_by_m1*t82;
    const double delay_tau1_by_w_by_m1 = carried_x1_2_by_w*t457 - carried_x1_2_by_w_by_m1*t82;
    /* d/dm2 of: derivatives of the time to the boundary after tau1 */
    const double t458 = t452*v1_2_by_m2;
    const double delay_tau1_by_y_by_m2 = carried_x1_2_by_y*t458 - carried_x1_2_by_y_by_m2*t82;
    const double delay_tau1_by_u_by_m2 = carried_x1_2_by_u*t458 - carried_x1_2_by_u_by_m2*t82;
    const double delay_tau1_by_w_by_m2 = carried_x1_2_by_w*t458 - carried_x1_2_by_w_by_m2*t82;
    /* d/dk1 of: derivatives of the time to the boundary after tau1 */
    const double t459 = t452*v1_2_by_k1;
    const double delay_tau1_by_y_by_k1 = carried_x1_2_by_y*t459 - carried_x1_2_by_y_by_k1*t82;
    const double delay_tau1_by_u_by_k1 = carried_x1_2_by_u*t459 - carried_x1_2_by_u_by_k1*t82;
    const double delay_tau1_by_w_by_k1 = carried_x1_2_by_w*t459 - carried_x1_2_by_w_by_k1*t82;
    /* d/dk2 of: derivatives of the time to the boundary after tau1 */
    const double t460 = t452*v1_2_by_k2;
    const double delay_tau1_by_y_by_k2 = carried_x1_2_by_y*t460 - carried_x1_2_by_y_by_k2*t82;
    const double delay_tau1_by_u_by_k2 = carried_x1_2_by_u*t460 - carried_x1_2_by_u_by_k2*t82;
    const double delay_tau1_by_w_by_k2 = carried_x1_2_by_w*t460 - carried_x1_2_by_w_by_k2*t82;
    /* d/dk3 of: derivatives of the time to the boundary after tau1 */
    const double t461 = t452*v1_2_by_k3;
    const double delay_tau1_by_y_by_k3 = carried_x1_2_by_y*t461 - carried_x1_2_by_y_by_k3*t82;
    const double delay_tau1_by_u_by_k3 = carried_x1_2_by_u*t461 - carried_x1_2_by_u_by_k3*t82;
    const double delay_tau1_by_w_by_k3 = carried_x1_2_by_w*t461 - carried_x1_2_by_w_by_k3*t82;
    /* d/dT of: derivatives of the time to the boundary after tau1 */
    const double t462 = t452*v1_2_by_T;
    const double delay_tau1_by_y_by_T = carried_x1_2_by_y*t462 - carried_x1_2_by_y_by_T*t82;
    const double delay_tau1_by_u_by_T = carried_x1_2_by_u*t462 - carried_x1_2_by_u_by_T*t82;
    const double delay_tau1_by_w_by_T = carried_x1_2_by_w*t462 - carried_x1_2_by_w_by_T*t82;
    /* d/dy of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_y = carried_x2_2_by_y_by_y + delay_tau1_by_y*v2_2_by_y + delay_tau1_by_y_by_y*v2_2;
    const double t463 = t73*x1_2;
    const double t464 = -k1*t463 + k1*t73*x2_2;
    const double t465 = delay_tau1_by_u*k1*t73;
    const double v1_2_on_boundary_by_u_by_y = carried_v1_2_by_u_by_y + delay_tau1_by_u_by_y*t464 - t465*x1_2_by_y + t465*x2_2_by_y;
    const double t466 = t77*x1_2;
    const double t467 = t77*x2_2;
    const double t468 = k1*t466 - t467*t79;
    const double t469 = delay_tau1_by_w*t77;
    const double t470 = k1*t469;
    const double t471 = t469*t79;
    const double v2_2_on_boundary_by_w_by_y = carried_v2_2_by_w_by_y + delay_tau1_by_w_by_y*t468 + t470*x1_2_by_y - t471*x2_2_by_y;
    /* d/du of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_u = carried_x2_2_by_y_by_u + delay_tau1_by_y*v2_2_by_u + delay_tau1_by_y_by_u*v2_2;
    const double v1_2_on_boundary_by_u_by_u = carried_v1_2_by_u_by_u + delay_tau1_by_u_by_u*t464 - t465*x1_2_by_u + t465*x2_2_by_u;
    const double v2_2_on_boundary_by_w_by_u = carried_v2_2_by_w_by_u + delay_tau1_by_w_by_u*t468 + t470*x1_2_by_u - t471*x2_2_by_u;
    /* d/dw of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_w = carried_x2_2_by_y_by_w + delay_tau1_by_y*v2_2_by_w + delay_tau1_by_y_by_w*v2_2;
    const double v1_2_on_boundary_by_u_by_w = carried_v1_2_by_u_by_w + delay_tau1_by_u_by_w*t464 - t465*x1_2_by_w + t465*x2_2_by_w;
    const double v2_2_on_boundary_by_w_by_w = carried_v2_2_by_w_by_w + delay_tau1_by_w_by_w*t468 + t470*x1_2_by_w - t471*x2_2_by_w;
    /* d/dtau of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_tau = carried_x2_2_by_y_by_tau + delay_tau1_by_y*v2_2_by_tau + delay_tau1_by_y_by_tau*v2_2;
    const double v1_2_on_boundary_by_u_by_tau = carried_v1_2_by_u_by_tau + delay_tau1_by_u_by_tau*t464 - t465*x1_2_by_tau + t465*x2_2_by_tau;
    const double v2_2_on_boundary_by_w_by_tau = carried_v2_2_by_w_by_tau + delay_tau1_by_w_by_tau*t468 + t470*x1_2_by_tau - t471*x2_2_by_tau;
    /* d/dm1 of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_m1 = carried_x2_2_by_y_by_m1 + delay_tau1_by_y*v2_2_by_m1 + delay_tau1_by_y_by_m1*v2_2;
    const double v1_2_on_boundary_by_u_by_m1 = carried_v1_2_by_u_by_m1 + delay_tau1_by_u*(t357*x1_2 - t357*x2_2) + delay_tau1_by_u_by_m1*t464 - t465*x1_2_by_m1 + t465*x2_2_by_m1;
    const double v2_2_on_boundary_by_w_by_m1 = carried_v2_2_by_w_by_m1 + delay_tau1_by_w_by_m1*t468 + t470*x1_2_by_m1 - t471*x2_2_by_m1;
    /* d/dm2 of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_m2 = carried_x2_2_by_y_by_m2 + delay_tau1_by_y*v2_2_by_m2 + delay_tau1_by_y_by_m2*v2_2;
    const double v1_2_on_boundary_by_u_by_m2 = carried_v1_2_by_u_by_m2 + delay_tau1_by_u_by_m2*t464 - t465*x1_2_by_m2 + t465*x2_2_by_m2;
    const double v2_2_on_boundary_by_w_by_m2 = carried_v2_2_by_w_by_m2 + delay_tau1_by_w*(t365*t79*x2_2 - t366*x1_2) + delay_tau1_by_w_by_m2*t468 + t470*x1_2_by_m2 - t471*x2_2_by_m2;
    /* d/dk1 of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_k1 = carried_x2_2_by_y_by_k1 + delay_tau1_by_y*v2_2_by_k1 + delay_tau1_by_y_by_k1*v2_2;
    const double v1_2_on_boundary_by_u_by_k1 = carried_v1_2_by_u_by_k1 + delay_tau1_by_u*(-t463 + t73*x2_2) + delay_tau1_by_u_by_k1*t464 - t465*x1_2_by_k1 + t465*x2_2_by_k1;
    const double v2_2_on_boundary_by_w_by_k1 = carried_v2_2_by_w_by_k1 + delay_tau1_by_w*(t466 - t467) + delay_tau1_by_w_by_k1*t468 + t470*x1_2_by_k1 - t471*x2_2_by_k1;
    /* d/dk2 of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_k2 = carried_x2_2_by_y_by_k2 + delay_tau1_by_y*v2_2_by_k2 + delay_tau1_by_y_by_k2*v2_2;
    const double v1_2_on_boundary_by_u_by_k2 = carried_v1_2_by_u_by_k2 + delay_tau1_by_u_by_k2*t464 - t465*x1_2_by_k2 + t465*x2_2_by_k2;
    const double v2_2_on_boundary_by_w_by_k2 = carried_v2_2_by_w_by_k2 - delay_tau1_by_w*t467 + delay_tau1_by_w_by_k2*t468 + t470*x1_2_by_k2 - t471*x2_2_by_k2;
    /* d/dk3 of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_k3 = carried_x2_2_by_y_by_k3 + delay_tau1_by_y*v2_2_by_k3 + delay_tau1_by_y_by_k3*v2_2;
    const double v1_2_on_boundary_by_u_by_k3 = carried_v1_2_by_u_by_k3 + delay_tau1_by_u_by_k3*t464 - t465*x1_2_by_k3 + t465*x2_2_by_k3;
    const double v2_2_on_boundary_by_w_by_k3 = carried_v2_2_by_w_by_k3 + delay_tau1_by_w_by_k3*t468 + t470*x1_2_by_k3 - t471*x2_2_by_k3;
    /* d/dT of: perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y_by_T = carried_x2_2_by_y_by_T + delay_tau1_by_y*v2_2_by_T + delay_tau1_by_y_by_T*v2_2;
    const double v1_2_on_boundary_by_u_by_T = carried_v1_2_by_u_by_T + delay_tau1_by_u_by_T*t464 - t465*x1_2_by_T + t465*x2_2_by_T;
    const double v2_2_on_boundary_by_w_by_T = carried_v2_2_by_w_by_T + delay_tau1_by_w_by_T*t468 + t470*x1_2_by_T - t471*x2_2_by_T;
    trace_gradient[0] = v1_2_on_boundary_by_u_by_y + v2_2_on_boundary_by_w_by_y + x2_2_on_boundary_by_y_by_y;
    trace_gradient[1] = v1_2_on_boundary_by_u_by_u + v2_2_on_boundary_by_w_by_u + x2_2_on_boundary_by_y_by_u;
    trace_gradient[2] = v1_2_on_boundary_by_u_by_w + v2_2_on_boundary_by_w_by_w + x2_2_on_boundary_by_y_by_w;
    trace_gradient[3] = v1_2_on_boundary_by_u_by_tau + v2_2_on_boundary_by_w_by_tau + x2_2_on_boundary_by_y_by_tau;
    trace_gradient[4] = v1_2_on_boundary_by_u_by_m1 + v2_2_on_boundary_by_w_by_m1 + x2_2_on_boundary_by_y_by_m1;
    trace_gradient[5] = v1_2_on_boundary_by_u_by_m2 + v2_2_on_boundary_by_w_by_m2 + x2_2_on_boundary_by_y_by_m2;
    trace_gradient[6] = v1_2_on_boundary_by_u_by_k1 + v2_2_on_boundary_by_w_by_k1 + x2_2_on_boundary_by_y_by_k1;
    trace_gradient[7] = v1_2_on_boundary_by_u_by_k2 + v2_2_on_boundary_by_w_by_k2 + x2_2_on_boundary_by_y_by_k2;
    trace_gradient[8] = v1_2_on_boundary_by_u_by_k3 + v2_2_on_boundary_by_w_by_k3 + x2_2_on_boundary_by_y_by_k3;
    trace_gradient[9] = v1_2_on_boundary_by_u_by_T + v2_2_on_boundary_by_w_by_T + x2_2_on_boundary_by_y_by_T;
}

/* State at the start and behind each transition, row by row.
 * Operations: 211. Intermediate terms: 50. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_states(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double states[12])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = p1 - 1;
    const double t10 = (1.0/(omega1));
    const double t11 = sin_omega1_tau*t10;
    const double t13 = sin_omega2_tau/omega2;
    const double t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t15 = cos_omega1_tau*p1 - cos_omega2_tau*t9;
    const double x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*y + t15 + t5 + u*(p1*t11 - t13*t9) + w*(p2*sin_omega1_tau*t10 - p2*t13);
    const double t16 = p3*t5;
    const double t18 = p1*t7;
    const double t19 = -cos_omega1_tau*t9 + cos_omega2_tau*p1;
    const double t20 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(-t16 + t7*t9) + cos_omega2_tau*(t16 - t18) + t19*y + t20 + t7 + u*(p3*sin_omega1_tau*t10 - p3*t13) + w*(p1*t13 - t11*t9);
    const double t21 = omega1*sin_omega1_tau;
    const double t22 = omega2*sin_omega2_tau;
    const double v1_1 = -p1*t21 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t14*w + t15*u + t22*t9 + y*(omega2*p2*sin_omega2_tau - p2*t21);
    const double v2_1 = -p3*t21 + p3*t22 + sin_omega1_tau*(omega1*t16 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t16 + omega2*t18) + t19*w + t20*u + y*(-p1*t22 + t21*t9);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t23 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t23);
    const double sin_omega3_tau1 = sin(t23);
    const double t24 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t24);
    const double sin_omega4_tau1 = sin(t24);
    /* free for tau1, until first-reaches-stop */
    const double t25 = (1.0/(omega3));
    const double t26 = sin_omega3_tau1*t25;
    const double t27 = 1 - p4;
    const double t28 = sin_omega4_tau1/omega4;
    const double t29 = cos_omega3_tau1*p4 + cos_omega4_tau1*t27;
    const double t30 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t29*x1_1 + t30*x2_1 + v1_1*(p4*t26 + t27*t28) + v2_1*(p5*sin_omega3_tau1*t25 - p5*t28);
    const double t31 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t32 = cos_omega3_tau1*t27 + cos_omega4_tau1*p4;
    const double x2_2 = t31*x1_1 + t32*x2_1 + v1_1*(p6*sin_omega3_tau1*t25 - p6*t28) + v2_1*(p4*t28 + t26*t27);
    const double t33 = omega3*sin_omega3_tau1;
    const double t34 = omega4*sin_omega4_tau1;
    const double v1_2 = t29*v1_1 + t30*v2_1 + x1_1*(-p4*t33 - t27*t34) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t33);
    const double v2_2 = t31*v1_1 + t32*v2_1 + x1_1*(omega4*p6*sin_omega4_tau1 - p6*t33) + x2_1*(-p4*t34 - t27*t33);
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

/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.
 * Operations: 164. Intermediate terms: 39. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_boundary_functions(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double coefficients[12], double frequencies[4])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double y = unknowns[0];
    const double u = unknowns[1];
    const double w = unknowns[2];
    const double tau = unknowns[3];
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
    const double t6 = p1*t5;
    const double t7 = t2*t4;
    const double t8 = p2*t7;
    const double t9 = t6 + t8;
    const double t10 = p1 - 1;
    const double t11 = t10*t5 + t8;
    const double t12 = (1.0/(omega1));
    const double t13 = sin_omega1_tau*t12;
    const double t15 = (1.0/(omega2));
    const double t16 = sin_omega2_tau*t15;
    const double t17 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t18 = cos_omega1_tau*p1 - cos_omega2_tau*t10;
    const double x1_1 = -cos_omega1_tau*t9 + cos_omega2_tau*t11 + t17*y + t18 + t5 + u*(p1*t13 - t10*t16) + w*(p2*sin_omega1_tau*t12 - p2*t16);
    const double t19 = p3*t5;
    const double t21 = p1*t7;
    const double t22 = -cos_omega1_tau*t10 + cos_omega2_tau*p1;
    const double t23 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*(t10*t7 - t19) + cos_omega2_tau*(t19 - t21) + t22*y + t23 + t7 + u*(p3*sin_omega1_tau*t12 - p3*t16) + w*(p1*t16 - t10*t13);
    const double t24 = omega1*sin_omega1_tau;
    const double t25 = omega2*sin_omega2_tau;
    const double v1_1 = -p1*t24 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t10*t3*t4 - omega2*t8) + t10*t25 + t17*w + t18*u + y*(omega2*p2*sin_omega2_tau - p2*t24);
    const double v2_1 = -p3*t24 + p3*t25 + sin_omega1_tau*(-omega1*t10*t7 + omega1*t19) + sin_omega2_tau*(-omega2*t19 + omega2*t21) + t22*w + t23*u + y*(-p1*t25 + t10*t24);
    /* outputs */
    const double t26 = -p1 - p2*y;
    const double t27 = p2*w;
    const double t28 = p5*x2_1;
    const double t29 = 1 - p4;
    const double t30 = (1.0/(omega3));
    const double t31 = p5*v2_1;
    const double t32 = (1.0/(omega4));
    coefficients[0] = 1 - t5;
    coefficients[1] = 0;
    coefficients[2] = t26 + t9;
    coefficients[3] = -t11 - t26 - 1;
    coefficients[4] = -p1*t12*u - t12*t27;
    coefficients[5] = t10*t15*u + t15*t27;
    coefficients[6] = -1;
    coefficients[7] = 0;
    coefficients[8] = p4*x1_1 + t28;
    coefficients[9] = -t28 + t29*x1_1;
    coefficients[10] = p4*t30*v1_1 + t30*t31;
    coefficients[11] = t29*t32*v1_1 - t31*t32;
    frequencies[0] = omega1;
    frequencies[1] = omega2;
    frequencies[2] = omega3;
    frequencies[3] = omega4;
}

/* State after a time in contact.
 * Operations: 133. Intermediate terms: 25. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_flow_contact(
    const double parameters[6], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
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
    const double t13 = k1*k3;
    const double t14 = k2*k3 + t13;
    const double t15 = (1.0/((k1*k2 + t14)));
    const double t16 = t14*t15;
    const double t17 = t13*t15;
    const double t18 = p2*t17;
    const double t19 = p1*t16;
    const double t20 = -p3*t10 + p3*t9;
    const double t21 = p1*t10 - t4*t9;
    const double t22 = p3*t16;
    const double t24 = p1*t17;
    const double t25 = omega1*t1;
    const double t26 = omega2*t7;
    state_after[0] = t10*(t16*t4 + t18) + t11*x1 + t12*x2 + t16 + t9*(-t18 - t19) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8);
    state_after[1] = t10*(t22 - t24) + t17 + t20*x1 + t21*x2 + t9*(t17*t4 - t22) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4);
    state_after[2] = t1*(omega1*t18 + omega1*t19) + t11*v1 + t12*v2 + t7*(-omega2*t14*t15*t4 - omega2*t18) + x1*(-p1*t25 + t26*t4) + x2*(omega2*p2*t7 - p2*t25);
    state_after[3] = t1*(-omega1*t17*t4 + omega1*t22) + t20*v1 + t21*v2 + t7*(-omega2*t22 + omega2*t24) + x1*(omega2*p3*t7 - p3*t25) + x2*(-p1*t26 + t25*t4);
}

/* State after a time in free.
 * Operations: 82. Intermediate terms: 16. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_flow_free(
    const double parameters[6], const double spectrum[12], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/(omega3));
    const double t1 = omega3*t;
    const double t2 = sin(t1);
    const double t3 = t0*t2;
    const double t4 = 1 - p4;
    const double t5 = omega4*t;
    const double t6 = sin(t5);
    const double t7 = t6/omega4;
    const double t8 = cos(t1);
    const double t9 = cos(t5);
    const double t10 = p4*t8 + t4*t9;
    const double t11 = p5*t8 - p5*t9;
    const double t12 = p6*t8 - p6*t9;
    const double t13 = p4*t9 + t4*t8;
    const double t14 = omega3*t2;
    const double t15 = omega4*t6;
    state_after[0] = t10*x1 + t11*x2 + v1*(p4*t3 + t4*t7) + v2*(p5*t0*t2 - p5*t7);
    state_after[1] = t12*x1 + t13*x2 + v1*(p6*t0*t2 - p6*t7) + v2*(p4*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + x1*(-p4*t14 - t15*t4) + x2*(omega4*p5*t6 - p5*t14);
    state_after[3] = t12*v1 + t13*v2 + x1*(omega4*p6*t6 - p6*t14) + x2*(-p4*t15 - t14*t4);
}

/* Reduced equations and their derivatives by the reduced unknowns.
 * Operations: 378. Intermediate terms: 122. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double residual[1], double jacobian[1])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double p6 = spectrum[11];
    const double tau = reduced[0];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t3 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t3);
    const double sin_omega2_half_tau = sin(t3);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t6);
    const double sin_omega3_half_tau1 = sin(t6);
    const double t9 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t9);
    const double sin_omega4_half_tau1 = sin(t9);
    /* coefficients of the linear equations */
    const double t12 = k1*k2;
    const double t13 = k1*k3;
    const double t14 = k2*k3;
    const double t15 = (1.0/((t12 + t13 + t14)));
    const double t16 = p2*t13;
    const double t17 = p2*t12 + p2*t14 + t16;
    const double t18 = t15*t17;
    const double t19 = omega1*sin_omega1_half_tau;
    const double coefficient11 = omega2*sin_omega2_half_tau*t15*t17 - t18*t19;
    const double t20 = 1 - p1;
    const double coefficient12 = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t20;
    const double coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    const double t22 = p1*t12;
    const double t23 = p1*t13;
    const double t24 = p1*t14 + t22 + t23;
    const double t25 = -t12 - t13 - t14 + t24;
    const double t26 = t15*t19;
    const double t27 = omega2*sin_omega2_half_tau*t15;
    const double coefficient21 = -t24*t27 + t25*t26;
    const double coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    const double coefficient23 = cos_omega1_half_tau*t20 + cos_omega2_half_tau*p1;
    const double t28 = omega3*sin_omega3_half_tau1;
    const double coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t28;
    const double t29 = p4 - 1;
    const double coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t29;
    const double coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    /* right-hand sides of the linear equations */
    const double t30 = -t16 + t22;
    const double t31 = k1*k2*p1 - t12 - t16;
    const double right1 = t26*t30 - t27*t31;
    const double t32 = p3*t12 + t23;
    const double t33 = t13 - t32;
    const double right2 = -omega2*sin_omega2_half_tau*t15*t32 - t26*t33;
    const double t35 = omega4*sin_omega4_half_tau1;
    const double right3 = p4*t28 - t29*t35;
    /* determinant of the linear equations */
    const double t36 = coefficient22*coefficient33;
    const double t37 = coefficient21*coefficient32;
    const double t38 = coefficient23*coefficient32;
    const double t39 = coefficient21*coefficient33;
    const double t40 = coefficient22*coefficient31;
    const double determinant = coefficient11*t36 - coefficient11*t38 + coefficient12*coefficient23*coefficient31 - coefficient12*t39 + coefficient13*t37 - coefficient13*t40;
    /* numerators of Cramer's rule */
    const double t41 = coefficient12*coefficient23;
    const double t42 = coefficient12*coefficient33;
    const double t43 = coefficient13*coefficient22;
    const double numerator1 = coefficient13*coefficient32*right2 + right1*t36 - right1*t38 - right2*t42 + right3*t41 - right3*t43;
    const double t44 = coefficient11*coefficient23;
    const double t45 = coefficient13*coefficient31;
    const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t39 - right2*t45 - right3*t44;
    const double t46 = coefficient11*coefficient22;
    const double t47 = coefficient11*coefficient32;
    const double t48 = coefficient12*coefficient21;
    const double numerator3 = coefficient12*coefficient31*right2 + right1*t37 - right1*t40 - right2*t47 + right3*t46 - right3*t48;
    /* d/dtau of: functions of half_tau in contact */
    const double t49 = (1.0/2.0)*omega1;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t49;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t49;
    const double t50 = (1.0/2.0)*omega2;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t50;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t50;
    /* d/dtau of: functions of half_tau1 in free */
    const double t51 = (1.0/2.0)*omega3;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t51;
    const double sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t51;
    const double t52 = (1.0/2.0)*omega4;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t52;
    const double sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t52;
    /* d/dtau of: coefficients of the linear equations */
    const double t53 = omega1*sin_omega1_half_tau_by_tau;
    const double coefficient11_by_tau = omega2*sin_omega2_half_tau_by_tau*t15*t17 - t18*t53;
    const double coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 + cos_omega2_half_tau_by_tau*t20;
    const double coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2;
    const double t54 = t15*t53;
    const double t55 = omega2*sin_omega2_half_tau_by_tau*t15;
    const double coefficient21_by_tau = -t24*t55 + t25*t54;
    const double coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3;
    const double coefficient23_by_tau = cos_omega1_half_tau_by_tau*t20 + cos_omega2_half_tau_by_tau*p1;
    const double t56 = omega3*sin_omega3_half_tau1_by_tau;
    const double coefficient31_by_tau = omega4*p5*sin_omega4_half_tau1_by_tau - p5*t56;
    const double coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t29;
    const double coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5;
    /* d/dtau of: right-hand sides of the linear equations */
    const double right1_by_tau = t30*t54 - t31*t55;
    const double right2_by_tau = -omega2*sin_omega2_half_tau_by_tau*t15*t32 - t33*t54;
    const double right3_by_tau = -omega4*sin_omega4_half_tau1_by_tau*t29 + p4*t56;
    /* d/dtau of: determinant of the linear equations */
    const double t57 = t36 - t38;
    const double t58 = coefficient23*coefficient31 - t39;
    const double t59 = t37 - t40;
    const double t60 = coefficient13*coefficient32 - t42;
    const double t61 = coefficient11*coefficient33 - t45;
    const double t62 = coefficient12*coefficient31 - t47;
    const double t63 = t41 - t43;
    const double t64 = coefficient13*coefficient21 - t44;
    const double t65 = t46 - t48;
    const double determinant_by_tau = coefficient11_by_tau*t57 + coefficient12_by_tau*t58 + coefficient13_by_tau*t59 + coefficient21_by_tau*t60 + coefficient22_by_tau*t61 + coefficient23_by_tau*t62 + coefficient31_by_tau*t63 + coefficient32_by_tau*t64 + coefficient33_by_tau*t65;
    /* d/dtau of: numerators of Cramer's rule */
    const double t66 = coefficient23*right3 - coefficient33*right2;
    const double t67 = coefficient22*right3 - coefficient32*right2;
    const double t68 = coefficient13*right3 - coefficient33*right1;
    const double t69 = coefficient12*right3 - coefficient32*right1;
    const double t70 = coefficient13*right2 - coefficient23*right1;
    const double t71 = coefficient12*right2 - coefficient22*right1;
    const double numerator1_by_tau = coefficient12_by_tau*t66 - coefficient13_by_tau*t67 - coefficient22_by_tau*t68 + coefficient23_by_tau*t69 + coefficient32_by_tau*t70 - coefficient33_by_tau*t71 + right1_by_tau*t57 + right2_by_tau*t60 + right3_by_tau*t63;
    const double t72 = coefficient21*right3 - coefficient31*right2;
    const double t73 = coefficient11*right3 - coefficient31*right1;
    const double t74 = coefficient11*right2 - coefficient21*right1;
    const double numerator2_by_tau = -coefficient11_by_tau*t66 + coefficient13_by_tau*t72 + coefficient21_by_tau*t68 - coefficient23_by_tau*t73 - coefficient31_by_tau*t70 + coefficient33_by_tau*t74 + right1_by_tau*t58 + right2_by_tau*t61 + right3_by_tau*t64;
    const double numerator3_by_tau = coefficient11_by_tau*t67 - coefficient12_by_tau*t72 - coefficient21_by_tau*t69 + coefficient22_by_tau*t73 + coefficient31_by_tau*t71 - coefficient32_by_tau*t74 + right1_by_tau*t59 + right2_by_tau*t62 + right3_by_tau*t65;
    /* outputs */
    const double t75 = omega4*p6*sin_omega4_half_tau1 - p6*t28;
    const double t76 = -p4*t35 + t28*t29;
    const double t77 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
    const double t78 = cos_omega3_half_tau1*t29 - cos_omega4_half_tau1*p4;
    const double t79 = numerator2*p6;
    const double t80 = determinant*p6;
    residual[0] = determinant*t75 + numerator1*t76 + numerator2*t77 + numerator3*t78;
    jacobian[0] = cos_omega3_half_tau1_by_tau*(numerator3*t29 - t79) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t79) + determinant_by_tau*t75 + numerator1_by_tau*t76 + numerator2_by_tau*t77 + numerator3_by_tau*t78 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t29 - omega3*t80) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t80);
}

/* All unknowns from the reduced ones, and how singular the linear equations for them are: 0 if they are.
 * Operations: 220. Intermediate terms: 71. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_expand(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double unknowns[4], double determinants[1])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double k3 = parameters[4];
    const double T = parameters[5];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[7];
    const double omega4 = spectrum[8];
    const double p4 = spectrum[9];
    const double p5 = spectrum[10];
    const double tau = reduced[0];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const double cos_omega1_half_tau = cos(t0);
    const double sin_omega1_half_tau = sin(t0);
    const double t1 = half_tau*omega2;
    const double cos_omega2_half_tau = cos(t1);
    const double sin_omega2_half_tau = sin(t1);
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t2 = half_tau1*omega3;
    const double cos_omega3_half_tau1 = cos(t2);
    const double sin_omega3_half_tau1 = sin(t2);
    const double t3 = half_tau1*omega4;
    const double cos_omega4_half_tau1 = cos(t3);
    const double sin_omega4_half_tau1 = sin(t3);
    /* coefficients of the linear equations */
    const double t4 = k1*k2;
    const double t5 = k1*k3;
    const double t6 = k2*k3;
    const double t7 = (1.0/((t4 + t5 + t6)));
    const double t8 = p2*t5;
    const double t9 = p2*t4 + p2*t6 + t8;
    const double t10 = omega1*sin_omega1_half_tau;
    const double coefficient11 = omega2*sin_omega2_half_tau*t7*t9 - t10*t7*t9;
    const double t11 = p1 - 1;
    const double coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t11;
    const double coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    const double t14 = p1*t4;
    const double t15 = p1*t5;
    const double t16 = p1*t6 + t14 + t15;
    const double t17 = t10*t7;
    const double t18 = omega2*sin_omega2_half_tau*t7;
    const double coefficient21 = -t16*t18 + t17*(t16 - t4 - t5 - t6);
    const double coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    const double coefficient23 = -cos_omega1_half_tau*t11 + cos_omega2_half_tau*p1;
    const double t19 = omega3*sin_omega3_half_tau1;
    const double coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t19;
    const double t20 = p4 - 1;
    const double coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t20;
    const double coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    /* right-hand sides of the linear equations */
    const double right1 = t17*(t14 - t8) - t18*(k1*k2*p1 - t4 - t8);
    const double t21 = p3*t4 + t15;
    const double right2 = -omega2*sin_omega2_half_tau*t21*t7 - t17*(-t21 + t5);
    const double right3 = -omega4*sin_omega4_half_tau1*t20 + p4*t19;
    /* determinant of the linear equations */
    const double t22 = coefficient22*coefficient33;
    const double t23 = coefficient12*coefficient23;
    const double t24 = coefficient13*coefficient32;
    const double t25 = coefficient23*coefficient32;
    const double t26 = coefficient12*coefficient33;
    const double t27 = coefficient13*coefficient22;
    const double determinant = coefficient11*t22 - coefficient11*t25 + coefficient21*t24 - coefficient21*t26 + coefficient31*t23 - coefficient31*t27;
    /* numerators of Cramer's rule */
    const double numerator1 = right1*t22 - right1*t25 + right2*t24 - right2*t26 + right3*t23 - right3*t27;
    const double t28 = coefficient11*right3;
    const double t29 = coefficient31*right2;
    const double t30 = coefficient21*right1;
    const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 - coefficient13*t29 + coefficient23*coefficient31*right1 - coefficient23*t28 - coefficient33*t30;
    const double numerator3 = -coefficient11*coefficient32*right2 - coefficient12*coefficient21*right3 + coefficient12*t29 - coefficient22*coefficient31*right1 + coefficient22*t28 + coefficient32*t30;
    /* y, u, w by Cramer's rule */
    const double t31 = (1.0/(determinant));
    const double y = numerator1*t31;
    const double u = numerator2*t31;
    const double w = numerator3*t31;
    /* outputs */
    const double t32 = 2*(p2*p2);
    const double t33 = (half_tau*half_tau);
    const double t34 = t32*t33;
    const double t35 = (omega1*omega1*omega1*omega1)/((omega1*omega1)*t33 + 1);
    const double t36 = (omega2*omega2*omega2*omega2)/((omega2*omega2)*t33 + 1);
    const double t37 = (p1*p1);
    const double t38 = (t11*t11) + t37;
    const double t39 = 2*t33;
    const double t40 = 2*(p5*p5);
    const double t41 = (half_tau1*half_tau1);
    const double t42 = t40*t41;
    unknowns[0] = y;
    unknowns[1] = u;
    unknowns[2] = w;
    unknowns[3] = tau;
    determinants[0] = determinant/(sqrt(2*(p3*p3) + (t11*t11)*t35*t39 + t36*t37*t39 + t38)*sqrt(t32 + t34*t35 + t34*t36 + t38)*sqrt((omega3*omega3*omega3*omega3)*t42/((omega3*omega3)*t41 + 1) + (omega4*omega4*omega4*omega4)*t42/((omega4*omega4)*t41 + 1) + (p4*p4) + (t20*t20) + t40));
}

/* Newton's method on the reduced equations for `count` points. In one step a dwell time changes by
 * a factor of four at most; a point has converged when a whole step is below
 * 1e-9 max(1, |x|). */
NONSMOOTH_MULTIVERSION
void elastic_stop_one_contact_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns, double *trace,
    double *residual, int32_t *iterations, int32_t *status)
{
    enum { lanes = 16, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[6][lanes], x[1][lanes], fixed[75][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 6; ++i)
                parameter[i][lane] = parameters[i * count + point];
            open[lane] = 1.0;
            for (int i = 0; i < 1; ++i)
                x[i][lane] = guess[i * count + point];
            taken[lane] = 0;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double m1 = parameter[0][lane];
            const double m2 = parameter[1][lane];
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double k3 = parameter[4][lane];
            const double gap1 = sqrt(4*(k1*k1)/(m1*m2) + ((-(k1 + k2)/m2 + (k1 + k3)/m1)*(-(k1 + k2)/m2 + (k1 + k3)/m1)));
            const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*(k1 + k2)/m2 + (1.0/2.0)*(k1 + k3)/m1);
            const double omega2 = sqrt(k1*k2 + k1*k3 + k2*k3)/(sqrt(m1)*sqrt(m2)*omega1);
            const double p1 = 1.0/2.0 + (1.0/2.0)*(-(k1 + k2)/m2 + (k1 + k3)/m1)/gap1;
            const double p2 = -k1/(gap1*m1);
            const double p3 = -k1/(gap1*m2);
            const double gap2 = sqrt(4*(k1*k1)/(m1*m2) + ((k1/m1 - (k1 + k2)/m2)*(k1/m1 - (k1 + k2)/m2)));
            const double omega3 = sqrt((1.0/2.0)*gap2 + (1.0/2.0)*k1/m1 + (1.0/2.0)*(k1 + k2)/m2);
            const double omega4 = sqrt(k1)*sqrt(k2)/(sqrt(m1)*sqrt(m2)*omega3);
            const double p4 = 1.0/2.0 + (1.0/2.0)*(k1/m1 - (k1 + k2)/m2)/gap2;
            const double p5 = -k1/(gap2*m1);
            const double p6 = -k1/(gap2*m2);
            /* coefficients of the linear equations */
            const double t12 = k1*k2;
            const double t13 = k1*k3;
            const double t14 = k2*k3;
            const double t15 = t13 + t14;
            const double t16 = (1.0/((t12 + t15)));
            const double t17 = p2*t13;
            const double t18 = p2*t12 + p2*t14 + t17;
            const double t19 = t16*t18;
            const double h0 = -t19;
            const double h1 = omega2*t16*t18;
            const double t21 = p1 - 1;
            const double h2 = -t21;
            const double h3 = -p2;
            const double t24 = p1*t12;
            const double t25 = p1*t13;
            const double t26 = p1*t14 + t24 + t25;
            const double t27 = -t12 - t13 - t14 + t26;
            const double h4 = omega2*t16;
            const double h5 = -t26;
            const double h6 = -p3;
            const double h7 = -p5;
            const double h8 = omega4*p5;
            const double t31 = p4 - 1;
            const double h9 = -p4;
            /* right-hand sides of the linear equations */
            const double t32 = -t17 + t24;
            const double t33 = k1*k2*p1 - t12 - t17;
            const double h10 = -t33;
            const double t34 = p3*t12 + t25;
            const double t35 = t13 - t34;
            const double h11 = -t35;
            const double h12 = -omega2*t16*t34;
            const double h13 = -t31;
            /* d/dtau of: functions of half_tau in contact */
            const double t52 = (1.0/2.0)*omega1;
            const double h14 = -t52;
            const double t53 = (1.0/2.0)*omega2;
            const double h15 = -t53;
            /* d/dtau of: functions of half_tau1 in free */
            const double t54 = (1.0/2.0)*omega3;
            const double h16 = -t54;
            const double t55 = (1.0/2.0)*omega4;
            const double h17 = -t55;
            const double h18 = -omega4*t31;
            /* contact for tau, until first-leaves-stop */
            const double t80 = t15*t16;
            const double t81 = p1*t80;
            const double t82 = t16*t17;
            const double t83 = (1.0/(omega1));
            const double h19 = (1.0/(omega2));
            const double h20 = p2*t83;
            const double h21 = -t81 - t82;
            const double h22 = t21*t80 + t82;
            const double t90 = p3*t80;
            const double t92 = t13*t16;
            const double t93 = t16*t25;
            const double h23 = p3*t83;
            const double h24 = t21*t92 - t90;
            const double h25 = t90 - t93;
            const double h26 = omega2*p2;
            const double h27 = omega1*t81 + omega1*t82;
            const double h28 = -omega2*t15*t16*t21 - omega2*t82;
            const double h29 = -p1;
            const double h30 = -omega1*t21*t92 + omega1*t90;
            const double h31 = -omega2*t90 + omega2*t93;
            /* free for tau1, until first-reaches-stop */
            const double t104 = (1.0/(omega3));
            const double h32 = (1.0/(omega4));
            const double h33 = p5*t104;
            const double h34 = -p6;
            const double h35 = p6*t104;
            const double h36 = omega4*p6;
            const double t123 = (1.0/(m1));
            const double t124 = k1*t123;
            const double h37 = -t123*(k1 + k3);
            const double h38 = k3*t123;
            const double t126 = (1.0/(m2));
            const double t127 = k1*t126;
            const double t128 = t126*(k1 + k2);
            const double h39 = -t128;
            const double h40 = -t124;
            const double h41 = k1*t123;
            const double t137 = 2*(p2*p2);
            const double h42 = (omega1*omega1);
            const double h43 = (omega1*omega1*omega1*omega1);
            const double h44 = (omega2*omega2);
            const double h45 = (omega2*omega2*omega2*omega2);
            const double t142 = (p1*p1);
            const double t143 = t142 + (t21*t21);
            const double t145 = 2*(p5*p5);
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega3;
            fixed[6][lane] = omega4;
            fixed[7][lane] = p4;
            fixed[8][lane] = p5;
            fixed[9][lane] = p6;
            fixed[10][lane] = t16;
            fixed[11][lane] = h0;
            fixed[12][lane] = h1;
            fixed[13][lane] = t21;
            fixed[14][lane] = h2;
            fixed[15][lane] = h3;
            fixed[16][lane] = t27;
            fixed[17][lane] = h4;
            fixed[18][lane] = h5;
            fixed[19][lane] = h6;
            fixed[20][lane] = h7;
            fixed[21][lane] = h8;
            fixed[22][lane] = t31;
            fixed[23][lane] = h9;
            fixed[24][lane] = t32;
            fixed[25][lane] = h10;
            fixed[26][lane] = h11;
            fixed[27][lane] = h12;
            fixed[28][lane] = h13;
            fixed[29][lane] = t52;
            fixed[30][lane] = h14;
            fixed[31][lane] = t53;
            fixed[32][lane] = h15;
            fixed[33][lane] = t54;
            fixed[34][lane] = h16;
            fixed[35][lane] = t55;
            fixed[36][lane] = h17;
            fixed[37][lane] = h18;
            fixed[38][lane] = t80;
            fixed[39][lane] = t83;
            fixed[40][lane] = h19;
            fixed[41][lane] = h20;
            fixed[42][lane] = h21;
            fixed[43][lane] = h22;
            fixed[44][lane] = t92;
            fixed[45][lane] = h23;
            fixed[46][lane] = h24;
            fixed[47][lane] = h25;
            fixed[48][lane] = h26;
            fixed[49][lane] = h27;
            fixed[50][lane] = h28;
            fixed[51][lane] = h29;
            fixed[52][lane] = h30;
            fixed[53][lane] = h31;
            fixed[54][lane] = t104;
            fixed[55][lane] = h32;
            fixed[56][lane] = h33;
            fixed[57][lane] = h34;
            fixed[58][lane] = h35;
            fixed[59][lane] = h36;
            fixed[60][lane] = t124;
            fixed[61][lane] = h37;
            fixed[62][lane] = h38;
            fixed[63][lane] = t127;
            fixed[64][lane] = h39;
            fixed[65][lane] = h40;
            fixed[66][lane] = h41;
            fixed[67][lane] = t137;
            fixed[68][lane] = h42;
            fixed[69][lane] = h43;
            fixed[70][lane] = h44;
            fixed[71][lane] = h45;
            fixed[72][lane] = t142;
            fixed[73][lane] = t143;
            fixed[74][lane] = t145;
        }
        for (int iteration = 0; iteration < most; ++iteration) {
            double running = 0.0;
            NONSMOOTH_SIMD
            for (int lane = 0; lane < lanes; ++lane) {
                const double T = parameter[5][lane];
                const double omega1 = fixed[0][lane];
                const double omega2 = fixed[1][lane];
                const double p1 = fixed[2][lane];
                const double p2 = fixed[3][lane];
                const double p3 = fixed[4][lane];
                const double omega3 = fixed[5][lane];
                const double omega4 = fixed[6][lane];
                const double p4 = fixed[7][lane];
                const double p5 = fixed[8][lane];
                const double p6 = fixed[9][lane];
                const double t16 = fixed[10][lane];
                const double h0 = fixed[11][lane];
                const double h1 = fixed[12][lane];
                const double h2 = fixed[14][lane];
                const double h3 = fixed[15][lane];
                const double t27 = fixed[16][lane];
                const double h4 = fixed[17][lane];
                const double h5 = fixed[18][lane];
                const double h6 = fixed[19][lane];
                const double h7 = fixed[20][lane];
                const double h8 = fixed[21][lane];
                const double t31 = fixed[22][lane];
                const double h9 = fixed[23][lane];
                const double t32 = fixed[24][lane];
                const double h10 = fixed[25][lane];
                const double h11 = fixed[26][lane];
                const double h12 = fixed[27][lane];
                const double h13 = fixed[28][lane];
                const double t52 = fixed[29][lane];
                const double h14 = fixed[30][lane];
                const double t53 = fixed[31][lane];
                const double h15 = fixed[32][lane];
                const double t54 = fixed[33][lane];
                const double h16 = fixed[34][lane];
                const double t55 = fixed[35][lane];
                const double h17 = fixed[36][lane];
                const double h18 = fixed[37][lane];
                const double h34 = fixed[57][lane];
                const double h36 = fixed[59][lane];
                const double tau = x[0][lane];
                /* half of tau */
                const double half_tau = (1.0/2.0)*tau;
                /* functions of half_tau in contact */
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
                /* tau1 completes the period */
                const double tau1 = T - tau;
                /* half of tau1 */
                const double half_tau1 = (1.0/2.0)*tau1;
                /* functions of half_tau1 in free */
                const double t6 = half_tau1*omega3;
                double sine_2, cosine_2;
                nonsmooth_sincos(t6, &sine_2, &cosine_2);
                const double cos_omega3_half_tau1 = cosine_2;
                const double sin_omega3_half_tau1 = sine_2;
                const double t9 = half_tau1*omega4;
                double sine_3, cosine_3;
                nonsmooth_sincos(t9, &sine_3, &cosine_3);
                const double cos_omega4_half_tau1 = cosine_3;
                const double sin_omega4_half_tau1 = sine_3;
                const double t20 = omega1*sin_omega1_half_tau;
                const double coefficient11 = h0*t20 + h1*sin_omega2_half_tau;
                const double coefficient12 = cos_omega1_half_tau*p1 + cos_omega2_half_tau*h2;
                const double coefficient13 = cos_omega1_half_tau*p2 + cos_omega2_half_tau*h3;
                const double t28 = t16*t20;
                const double t29 = h4*sin_omega2_half_tau;
                const double coefficient21 = h5*t29 + t27*t28;
                const double coefficient22 = cos_omega1_half_tau*p3 + cos_omega2_half_tau*h6;
                const double coefficient23 = cos_omega1_half_tau*h2 + cos_omega2_half_tau*p1;
                const double t30 = omega3*sin_omega3_half_tau1;
                const double coefficient31 = h7*t30 + h8*sin_omega4_half_tau1;
                const double coefficient32 = cos_omega3_half_tau1*h9 + cos_omega4_half_tau1*t31;
                const double coefficient33 = cos_omega3_half_tau1*h7 + cos_omega4_half_tau1*p5;
                const double right1 = h10*t29 + t28*t32;
                const double right2 = h11*t28 + h12*sin_omega2_half_tau;
                const double t37 = omega4*sin_omega4_half_tau1;
                const double right3 = h13*t37 + p4*t30;
                /* determinant of the linear equations */
                const double t38 = coefficient22*coefficient33;
                const double t39 = coefficient21*coefficient32;
                const double t40 = coefficient23*coefficient32;
                const double t41 = coefficient21*coefficient33;
                const double t42 = coefficient22*coefficient31;
                const double determinant = coefficient11*t38 - coefficient11*t40 + coefficient12*coefficient23*coefficient31 - coefficient12*t41 + coefficient13*t39 - coefficient13*t42;
                /* numerators of Cramer's rule */
                const double t43 = coefficient12*coefficient23;
                const double t44 = coefficient12*coefficient33;
                const double t45 = coefficient13*coefficient22;
                const double numerator1 = coefficient13*coefficient32*right2 + right1*t38 - right1*t40 - right2*t44 + right3*t43 - right3*t45;
                const double t46 = coefficient11*coefficient23;
                const double t47 = coefficient13*coefficient31;
                const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t41 - right2*t47 - right3*t46;
                const double t48 = coefficient11*coefficient22;
                const double t49 = coefficient11*coefficient32;
                const double t50 = coefficient12*coefficient21;
                const double numerator3 = coefficient12*coefficient31*right2 + right1*t39 - right1*t42 - right2*t49 + right3*t48 - right3*t50;
                const double cos_omega1_half_tau_by_tau = h14*sin_omega1_half_tau;
                const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t52;
                const double cos_omega2_half_tau_by_tau = h15*sin_omega2_half_tau;
                const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t53;
                const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t54;
                const double sin_omega3_half_tau1_by_tau = cos_omega3_half_tau1*h16;
                const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t55;
                const double sin_omega4_half_tau1_by_tau = cos_omega4_half_tau1*h17;
                /* d/dtau of: coefficients of the linear equations */
                const double t56 = omega1*sin_omega1_half_tau_by_tau;
                const double coefficient11_by_tau = h0*t56 + h1*sin_omega2_half_tau_by_tau;
                const double coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 + cos_omega2_half_tau_by_tau*h2;
                const double coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 + cos_omega2_half_tau_by_tau*h3;
                const double t57 = t16*t56;
                const double t58 = h4*sin_omega2_half_tau_by_tau;
                const double coefficient21_by_tau = h5*t58 + t27*t57;
                const double coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 + cos_omega2_half_tau_by_tau*h6;
                const double coefficient23_by_tau = cos_omega1_half_tau_by_tau*h2 + cos_omega2_half_tau_by_tau*p1;
                const double t59 = omega3*sin_omega3_half_tau1_by_tau;
                const double coefficient31_by_tau = h7*t59 + h8*sin_omega4_half_tau1_by_tau;
                const double coefficient32_by_tau = cos_omega3_half_tau1_by_tau*h9 + cos_omega4_half_tau1_by_tau*t31;
                const double coefficient33_by_tau = cos_omega3_half_tau1_by_tau*h7 + cos_omega4_half_tau1_by_tau*p5;
                /* d/dtau of: right-hand sides of the linear equations */
                const double right1_by_tau = h10*t58 + t32*t57;
                const double right2_by_tau = h11*t57 + h12*sin_omega2_half_tau_by_tau;
                const double right3_by_tau = h18*sin_omega4_half_tau1_by_tau + p4*t59;
                /* d/dtau of: determinant of the linear equations */
                const double t60 = t38 - t40;
                const double t61 = coefficient23*coefficient31 - t41;
                const double t62 = t39 - t42;
                const double t63 = coefficient13*coefficient32 - t44;
                const double t64 = coefficient11*coefficient33 - t47;
                const double t65 = coefficient12*coefficient31 - t49;
                const double t66 = t43 - t45;
                const double t67 = coefficient13*coefficient21 - t46;
                const double t68 = t48 - t50;
                const double determinant_by_tau = coefficient11_by_tau*t60 + coefficient12_by_tau*t61 + coefficient13_by_tau*t62 + coefficient21_by_tau*t63 + coefficient22_by_tau*t64 + coefficient23_by_tau*t65 + coefficient31_by_tau*t66 + coefficient32_by_tau*t67 + coefficient33_by_tau*t68;
                /* d/dtau of: numerators of Cramer's rule */
                const double t69 = coefficient23*right3 - coefficient33*right2;
                const double t70 = coefficient22*right3 - coefficient32*right2;
                const double t71 = coefficient13*right3 - coefficient33*right1;
                const double t72 = coefficient12*right3 - coefficient32*right1;
                const double t73 = coefficient13*right2 - coefficient23*right1;
                const double t74 = coefficient12*right2 - coefficient22*right1;
                const double numerator1_by_tau = coefficient12_by_tau*t69 - coefficient13_by_tau*t70 - coefficient22_by_tau*t71 + coefficient23_by_tau*t72 + coefficient32_by_tau*t73 - coefficient33_by_tau*t74 + right1_by_tau*t60 + right2_by_tau*t63 + right3_by_tau*t66;
                const double t75 = coefficient21*right3 - coefficient31*right2;
                const double t76 = coefficient11*right3 - coefficient31*right1;
                const double t77 = coefficient11*right2 - coefficient21*right1;
                const double numerator2_by_tau = -coefficient11_by_tau*t69 + coefficient13_by_tau*t75 + coefficient21_by_tau*t71 - coefficient23_by_tau*t76 - coefficient31_by_tau*t73 + coefficient33_by_tau*t77 + right1_by_tau*t61 + right2_by_tau*t64 + right3_by_tau*t67;
                const double numerator3_by_tau = coefficient11_by_tau*t70 - coefficient12_by_tau*t75 - coefficient21_by_tau*t72 + coefficient22_by_tau*t76 + coefficient31_by_tau*t74 - coefficient32_by_tau*t77 + right1_by_tau*t62 + right2_by_tau*t65 + right3_by_tau*t68;
                /* outputs */
                const double t131 = h34*t30 + h36*sin_omega4_half_tau1;
                const double t132 = h9*t37 + t30*t31;
                const double t133 = cos_omega3_half_tau1*h34 + cos_omega4_half_tau1*p6;
                const double t134 = cos_omega3_half_tau1*t31 + cos_omega4_half_tau1*h9;
                const double t135 = numerator2*p6;
                const double t136 = determinant*p6;
                const double residual_0 = determinant*t131 + numerator1*t132 + numerator2*t133 + numerator3*t134;
                const double jacobian_0 = cos_omega3_half_tau1_by_tau*(numerator3*t31 - t135) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t135) + determinant_by_tau*t131 + numerator1_by_tau*t132 + numerator2_by_tau*t133 + numerator3_by_tau*t134 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t31 - omega3*t136) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t136);
                const double inverse = (1.0/(jacobian_0));
                const double wanted_0 = tau - (residual_0)*inverse;
                const double next_0 = wanted_0 < 0.25*tau ? 0.25*tau : wanted_0 > 4.0*tau ? 4.0*tau : wanted_0;
                const double size_0 = fabs(next_0) > 1.0 ? fabs(next_0) : 1.0;
                x[0][lane] = open[lane] != 0.0 ? next_0 : tau;
                taken[lane] += open[lane] != 0.0 ? 1 : 0;
                open[lane] = ((fabs(wanted_0 - tau) <= 1e-9*size_0)) ? 0.0 : open[lane];
            }
            for (int lane = 0; lane < lanes; ++lane)
                running += open[lane];
            if (running == 0.0)
                break;
        }
        double result[4][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double T = parameter[5][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double omega4 = fixed[6][lane];
            const double p4 = fixed[7][lane];
            const double p5 = fixed[8][lane];
            const double p6 = fixed[9][lane];
            const double t16 = fixed[10][lane];
            const double h0 = fixed[11][lane];
            const double h1 = fixed[12][lane];
            const double t21 = fixed[13][lane];
            const double h2 = fixed[14][lane];
            const double h3 = fixed[15][lane];
            const double t27 = fixed[16][lane];
            const double h4 = fixed[17][lane];
            const double h5 = fixed[18][lane];
            const double h6 = fixed[19][lane];
            const double h7 = fixed[20][lane];
            const double h8 = fixed[21][lane];
            const double t31 = fixed[22][lane];
            const double h9 = fixed[23][lane];
            const double t32 = fixed[24][lane];
            const double h10 = fixed[25][lane];
            const double h11 = fixed[26][lane];
            const double h12 = fixed[27][lane];
            const double h13 = fixed[28][lane];
            const double t80 = fixed[38][lane];
            const double t83 = fixed[39][lane];
            const double h19 = fixed[40][lane];
            const double h20 = fixed[41][lane];
            const double h21 = fixed[42][lane];
            const double h22 = fixed[43][lane];
            const double t92 = fixed[44][lane];
            const double h23 = fixed[45][lane];
            const double h24 = fixed[46][lane];
            const double h25 = fixed[47][lane];
            const double h26 = fixed[48][lane];
            const double h27 = fixed[49][lane];
            const double h28 = fixed[50][lane];
            const double h29 = fixed[51][lane];
            const double h30 = fixed[52][lane];
            const double h31 = fixed[53][lane];
            const double t104 = fixed[54][lane];
            const double h32 = fixed[55][lane];
            const double h33 = fixed[56][lane];
            const double h34 = fixed[57][lane];
            const double h35 = fixed[58][lane];
            const double h36 = fixed[59][lane];
            const double t124 = fixed[60][lane];
            const double h37 = fixed[61][lane];
            const double h38 = fixed[62][lane];
            const double t127 = fixed[63][lane];
            const double h39 = fixed[64][lane];
            const double h40 = fixed[65][lane];
            const double h41 = fixed[66][lane];
            const double t137 = fixed[67][lane];
            const double h42 = fixed[68][lane];
            const double h43 = fixed[69][lane];
            const double h44 = fixed[70][lane];
            const double h45 = fixed[71][lane];
            const double t142 = fixed[72][lane];
            const double t143 = fixed[73][lane];
            const double t145 = fixed[74][lane];
            const double tau = x[0][lane];
            /* half of tau */
            const double half_tau = (1.0/2.0)*tau;
            /* functions of half_tau in contact */
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
            /* tau1 completes the period */
            const double tau1 = T - tau;
            /* half of tau1 */
            const double half_tau1 = (1.0/2.0)*tau1;
            /* functions of half_tau1 in free */
            const double t6 = half_tau1*omega3;
            double sine_2, cosine_2;
            nonsmooth_sincos(t6, &sine_2, &cosine_2);
            const double cos_omega3_half_tau1 = cosine_2;
            const double sin_omega3_half_tau1 = sine_2;
            const double t9 = half_tau1*omega4;
            double sine_3, cosine_3;
            nonsmooth_sincos(t9, &sine_3, &cosine_3);
            const double cos_omega4_half_tau1 = cosine_3;
            const double sin_omega4_half_tau1 = sine_3;
            const double t20 = omega1*sin_omega1_half_tau;
            const double coefficient11 = h0*t20 + h1*sin_omega2_half_tau;
            const double coefficient12 = cos_omega1_half_tau*p1 + cos_omega2_half_tau*h2;
            const double coefficient13 = cos_omega1_half_tau*p2 + cos_omega2_half_tau*h3;
            const double t28 = t16*t20;
            const double t29 = h4*sin_omega2_half_tau;
            const double coefficient21 = h5*t29 + t27*t28;
            const double coefficient22 = cos_omega1_half_tau*p3 + cos_omega2_half_tau*h6;
            const double coefficient23 = cos_omega1_half_tau*h2 + cos_omega2_half_tau*p1;
            const double t30 = omega3*sin_omega3_half_tau1;
            const double coefficient31 = h7*t30 + h8*sin_omega4_half_tau1;
            const double coefficient32 = cos_omega3_half_tau1*h9 + cos_omega4_half_tau1*t31;
            const double coefficient33 = cos_omega3_half_tau1*h7 + cos_omega4_half_tau1*p5;
            const double right1 = h10*t29 + t28*t32;
            const double right2 = h11*t28 + h12*sin_omega2_half_tau;
            const double t37 = omega4*sin_omega4_half_tau1;
            const double right3 = h13*t37 + p4*t30;
            /* determinant of the linear equations */
            const double t38 = coefficient22*coefficient33;
            const double t39 = coefficient21*coefficient32;
            const double t40 = coefficient23*coefficient32;
            const double t41 = coefficient21*coefficient33;
            const double t42 = coefficient22*coefficient31;
            const double determinant = coefficient11*t38 - coefficient11*t40 + coefficient12*coefficient23*coefficient31 - coefficient12*t41 + coefficient13*t39 - coefficient13*t42;
            /* numerators of Cramer's rule */
            const double t43 = coefficient12*coefficient23;
            const double t44 = coefficient12*coefficient33;
            const double t45 = coefficient13*coefficient22;
            const double numerator1 = coefficient13*coefficient32*right2 + right1*t38 - right1*t40 - right2*t44 + right3*t43 - right3*t45;
            const double t46 = coefficient11*coefficient23;
            const double t47 = coefficient13*coefficient31;
            const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t41 - right2*t47 - right3*t46;
            const double t48 = coefficient11*coefficient22;
            const double t49 = coefficient11*coefficient32;
            const double t50 = coefficient12*coefficient21;
            const double numerator3 = coefficient12*coefficient31*right2 + right1*t39 - right1*t42 - right2*t49 + right3*t48 - right3*t50;
            /* y, u, w by Cramer's rule */
            const double t51 = (1.0/(determinant));
            const double y = numerator1*t51;
            const double u = numerator2*t51;
            const double w = numerator3*t51;
            /* functions of tau in contact */
            const double t78 = omega1*tau;
            double sine_4, cosine_4;
            nonsmooth_sincos(t78, &sine_4, &cosine_4);
            const double cos_omega1_tau = cosine_4;
            const double sin_omega1_tau = sine_4;
            const double t79 = omega2*tau;
            double sine_5, cosine_5;
            nonsmooth_sincos(t79, &sine_5, &cosine_5);
            const double cos_omega2_tau = cosine_5;
            const double sin_omega2_tau = sine_5;
            const double t84 = sin_omega1_tau*t83;
            const double t85 = h19*sin_omega2_tau;
            const double t86 = h2*t85 + p1*t84;
            const double t87 = h20*sin_omega1_tau + h3*t85;
            const double t88 = cos_omega1_tau*p2 + cos_omega2_tau*h3;
            const double t89 = cos_omega1_tau*p1 + cos_omega2_tau*h2;
            const double x1_1 = cos_omega1_tau*h21 + cos_omega2_tau*h22 + t80 + t86*u + t87*w + t88*y + t89;
            const double t94 = h23*sin_omega1_tau + h6*t85;
            const double t95 = h2*t84 + p1*t85;
            const double t96 = cos_omega1_tau*h2 + cos_omega2_tau*p1;
            const double t97 = cos_omega1_tau*p3 + cos_omega2_tau*h6;
            const double x2_1 = cos_omega1_tau*h24 + cos_omega2_tau*h25 + t92 + t94*u + t95*w + t96*y + t97;
            const double t98 = omega1*sin_omega1_tau;
            const double t99 = h26*sin_omega2_tau + h3*t98;
            const double t100 = omega2*sin_omega2_tau;
            const double v1_1 = h27*sin_omega1_tau + h28*sin_omega2_tau + h29*t98 + t100*t21 + t88*w + t89*u + t99*y;
            const double t101 = h29*t100 + t21*t98;
            const double v2_1 = h30*sin_omega1_tau + h31*sin_omega2_tau + h6*t98 + p3*t100 + t101*y + t96*w + t97*u;
            /* functions of tau1 in free */
            const double t102 = omega3*tau1;
            double sine_6, cosine_6;
            nonsmooth_sincos(t102, &sine_6, &cosine_6);
            const double cos_omega3_tau1 = cosine_6;
            const double sin_omega3_tau1 = sine_6;
            const double t103 = omega4*tau1;
            double sine_7, cosine_7;
            nonsmooth_sincos(t103, &sine_7, &cosine_7);
            const double cos_omega4_tau1 = cosine_7;
            const double sin_omega4_tau1 = sine_7;
            const double t105 = sin_omega3_tau1*t104;
            const double t107 = h32*sin_omega4_tau1;
            const double t108 = h13*t107 + p4*t105;
            const double t109 = h33*sin_omega3_tau1 + h7*t107;
            const double t110 = cos_omega3_tau1*p4 + cos_omega4_tau1*h13;
            const double t111 = cos_omega3_tau1*p5 + cos_omega4_tau1*h7;
            const double x1_2 = t108*v1_1 + t109*v2_1 + t110*x1_1 + t111*x2_1;
            const double t112 = h34*t107 + h35*sin_omega3_tau1;
            const double t113 = h13*t105 + p4*t107;
            const double t114 = cos_omega3_tau1*p6 + cos_omega4_tau1*h34;
            const double t115 = cos_omega3_tau1*h13 + cos_omega4_tau1*p4;
            const double x2_2 = t112*v1_1 + t113*v2_1 + t114*x1_1 + t115*x2_1;
            const double t116 = omega3*sin_omega3_tau1;
            const double t117 = omega4*sin_omega4_tau1;
            const double t118 = h9*t116 + t117*t31;
            const double t119 = h7*t116 + h8*sin_omega4_tau1;
            const double v1_2 = t110*v1_1 + t111*v2_1 + t118*x1_1 + t119*x2_1;
            const double t120 = h34*t116 + h36*sin_omega4_tau1;
            const double t121 = h9*t117 + t116*t31;
            const double v2_2 = t114*v1_1 + t115*v2_1 + t120*x1_1 + t121*x2_1;
            /* Phi along tau */
            const double carried_x1_1_by_y = t88;
            const double carried_x1_1_by_u = t86;
            const double carried_x1_1_by_w = t87;
            const double carried_x2_1_by_y = t96;
            const double carried_x2_1_by_u = t94;
            const double carried_x2_1_by_w = t95;
            const double carried_v1_1_by_y = t99;
            const double carried_v1_1_by_u = t89;
            const double carried_v1_1_by_w = t88;
            const double carried_v2_1_by_y = t101;
            const double carried_v2_1_by_u = t97;
            const double carried_v2_1_by_w = t96;
            /* rate of the exit boundary after tau */
            const double rate_1 = -v1_1;
            /* derivatives of the time to the boundary after tau */
            const double t122 = (1.0/(rate_1));
            const double delay_tau_by_y = carried_x1_1_by_y*t122;
            const double delay_tau_by_u = carried_x1_1_by_u*t122;
            const double delay_tau_by_w = carried_x1_1_by_w*t122;
            /* perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
            const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
            const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
            const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
            const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
            const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
            const double t125 = h37*x1_1 + h38 + t124*x2_1;
            const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t125;
            const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t125;
            const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t125;
            const double t129 = h39*x2_1 + t127*x1_1;
            const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t129;
            const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t129;
            const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t129;
            /* Phi along tau1 */
            const double carried_x1_2_by_y = t108*v1_1_on_boundary_by_y + t109*v2_1_on_boundary_by_y + t110*x1_1_on_boundary_by_y + t111*x2_1_on_boundary_by_y;
            const double carried_x1_2_by_u = t108*v1_1_on_boundary_by_u + t109*v2_1_on_boundary_by_u + t110*x1_1_on_boundary_by_u + t111*x2_1_on_boundary_by_u;
            const double carried_x1_2_by_w = t108*v1_1_on_boundary_by_w + t109*v2_1_on_boundary_by_w + t110*x1_1_on_boundary_by_w + t111*x2_1_on_boundary_by_w;
            const double carried_x2_2_by_y = t112*v1_1_on_boundary_by_y + t113*v2_1_on_boundary_by_y + t114*x1_1_on_boundary_by_y + t115*x2_1_on_boundary_by_y;
            const double carried_v1_2_by_u = t110*v1_1_on_boundary_by_u + t111*v2_1_on_boundary_by_u + t118*x1_1_on_boundary_by_u + t119*x2_1_on_boundary_by_u;
            const double carried_v2_2_by_w = t114*v1_1_on_boundary_by_w + t115*v2_1_on_boundary_by_w + t120*x1_1_on_boundary_by_w + t121*x2_1_on_boundary_by_w;
            /* derivatives of the time to the boundary after tau1 */
            const double t130 = (1.0/(v1_2));
            const double delay_tau1_by_y = -carried_x1_2_by_y*t130;
            const double delay_tau1_by_u = -carried_x1_2_by_u*t130;
            const double delay_tau1_by_w = -carried_x1_2_by_w*t130;
            /* perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
            const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*(h40*x1_2 + h41*x2_2);
            const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*(h39*x2_2 + t127*x1_2);
            /* outputs */
            const double t131 = h34*t30 + h36*sin_omega4_half_tau1;
            const double t132 = h9*t37 + t30*t31;
            const double t133 = cos_omega3_half_tau1*h34 + cos_omega4_half_tau1*p6;
            const double t134 = cos_omega3_half_tau1*t31 + cos_omega4_half_tau1*h9;
            const double t138 = (half_tau*half_tau);
            const double t139 = t137*t138;
            const double t140 = h43/(h42*t138 + 1);
            const double t141 = h45/(h44*t138 + 1);
            const double t144 = 2*t138;
            const double t146 = (half_tau1*half_tau1);
            const double t147 = t145*t146;
            result[0][lane] = y;
            result[1][lane] = u;
            result[2][lane] = w;
            result[3][lane] = tau;
            slope[lane] = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y;
            double largest = 0.0;
            largest = fabs(determinant*t131 + numerator1*t132 + numerator2*t133 + numerator3*t134) > largest ? fabs(determinant*t131 + numerator1*t132 + numerator2*t133 + numerator3*t134) : largest;
            defect[lane] = largest;
            const double finite = (slope[lane] - slope[lane]) + (result[0][lane] - result[0][lane]) + (result[1][lane] - result[1][lane]) + (result[2][lane] - result[2][lane]) + (result[3][lane] - result[3][lane]);
            int32_t ending = ((result[3][lane] <= 0.0) | (parameter[5][lane] - result[3][lane] <= 0.0)) ? ELASTIC_STOP_NOT_POSITIVE : ELASTIC_STOP_CONVERGED;
            ending = open[lane] != 0.0 ? ELASTIC_STOP_NOT_CONVERGED : ending;
            ending = finite == 0.0 ? ending : ELASTIC_STOP_NOT_FINITE;
            ending = ((fabs(determinant/(sqrt(2*(p3*p3) + t140*t144*(t21*t21) + t141*t142*t144 + t143)*sqrt(t137 + t139*t140 + t139*t141 + t143)*sqrt((omega3*omega3*omega3*omega3)*t147/((omega3*omega3)*t146 + 1) + (omega4*omega4*omega4*omega4)*t147/((omega4*omega4)*t146 + 1) + (p4*p4) + t145 + (t31*t31)))) <= 1e-12)) ? ELASTIC_STOP_SINGULAR : ending;
            ended[lane] = ending;
        }
        for (int i = 0; i < 4; ++i)
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

/* Is each of `count` orbits a motion of the real system? */
void elastic_stop_one_contact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant)
{
    static const int sums[] = {1, 1}, terms[] = {2, 2}, at_once[] = {0, 0};
    static const int opened[] = {-1, -1};
    static const int exits[] = {0, 6}, first_frequency[] = {0, 2};
    static const int begins[] = {1, 1};
    static const double per_unit[] = {0.0, 0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 6 * point, *const u = unknowns + 4 * point;
        const double q[5] = {p[2], p[3], p[4], p[0], p[1]};
        const double durations[] = {u[3], p[5] - u[3]};
        double spectral[12], derivatives[60], coefficients[12], frequencies[4];
        elastic_stop_spectrum(q, spectral, derivatives);
        elastic_stop_one_contact_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        const double measures[] = {u[0], u[1], u[2]};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < 3; ++i)
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
        int found = ELASTIC_STOP_ADMISSIBLE, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 1; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 2 && found == ELASTIC_STOP_ADMISSIBLE; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[1], floor[1], maximum[1], time[1];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? ELASTIC_STOP_NO_DURATION : ELASTIC_STOP_UNDECIDED;
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
            for (int i = 0; i < sums[phase] && found == ELASTIC_STOP_ADMISSIBLE; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = ELASTIC_STOP_UNDECIDED;
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
        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}

/* Derivatives of the unknowns and the trace by the parameters, at solutions of the equations, for
 * `count` points. NaN where a pivot is below 1e-10 times the matrix. */
NONSMOOTH_MULTIVERSION
void elastic_stop_one_contact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = 16, n = 4, p = 6, width = 4 + 6 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[p][lanes], unknown[n][lanes], fixed[60][lanes];
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
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double m1 = parameter[0][lane];
            const double m2 = parameter[1][lane];
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double k3 = parameter[4][lane];
            /* spectrum */
            const double t0 = (1.0/(m2));
            const double t1 = k1 + k2;
            const double t2 = t0*t1;
            const double t3 = (1.0/(m1));
            const double t4 = k1 + k3;
            const double t5 = -t2 + t3*t4;
            const double t6 = (k1*k1);
            const double t7 = 4*t0*t6;
            const double t8 = t3*t7;
            const double gap1 = sqrt((t5*t5) + t8);
            const double t9 = (1.0/2.0)*t2;
            const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*t3*t4 + t9);
            const double t10 = sqrt(k1*k2 + k1*k3 + k2*k3);
            const double t11 = (1.0/(omega1));
            const double t12 = (1.0/sqrt(m1));
            const double t13 = (1.0/sqrt(m2));
            const double t14 = t12*t13;
            const double t15 = t11*t14;
            const double omega2 = t10*t15;
            const double t16 = (1.0/(gap1));
            const double t17 = (1.0/2.0)*t16;
            const double p1 = t17*t5 + 1.0/2.0;
            const double t18 = k1*t3;
            const double p2 = -t16*t18;
            const double t19 = t0*t16;
            const double p3 = -k1*t19;
            const double t20 = t18 - t2;
            const double gap2 = sqrt((t20*t20) + t8);
            const double omega3 = sqrt((1.0/2.0)*gap2 + (1.0/2.0)*t18 + t9);
            const double t21 = (1.0/(omega3));
            const double t22 = sqrt(k1);
            const double t23 = sqrt(k2);
            const double t24 = t14*t22*t23;
            const double omega4 = t21*t24;
            const double t25 = (1.0/(gap2));
            const double t26 = (1.0/2.0)*t25;
            const double p4 = t20*t26 + 1.0/2.0;
            const double p5 = -t18*t25;
            const double t27 = t0*t25;
            const double p6 = -k1*t27;
            /* d/dk1 of: spectrum */
            const double t28 = -2*t0 + 2*t3;
            const double t29 = 8*t0*t18;
            const double gap1_by_k1 = t17*(t28*t5 + t29);
            const double t30 = (1.0/2.0)*gap1_by_k1;
            const double t31 = (1.0/2.0)*t0;
            const double t32 = (1.0/2.0)*t3;
            const double t33 = t31 + t32;
            const double t34 = (1.0/2.0)*t11;
            const double omega1_by_k1 = t34*(t30 + t33);
            const double t35 = (1.0/2.0)*k2;
            const double t36 = (1.0/2.0)*k3;
            const double t37 = t15/t10;
            const double t38 = t10*t14/(omega1*omega1);
            const double omega2_by_k1 = -omega1_by_k1*t38 + t37*(t35 + t36);
            const double t39 = -t0 + t3;
            const double t40 = (1.0/(gap1*gap1));
            const double t41 = t40*t5;
            const double p1_by_k1 = t17*t39 - t30*t41;
            const double t42 = t16*t3;
            const double p2_by_k1 = gap1_by_k1*k1*t3*t40 - t42;
            const double p3_by_k1 = gap1_by_k1*k1*t0*t40 - t19;
            const double gap2_by_k1 = t26*(t20*t28 + t29);
            const double t43 = (1.0/2.0)*gap2_by_k1;
            const double t44 = (1.0/2.0)*t21;
            const double omega3_by_k1 = t44*(t33 + t43);
            const double t45 = t24/(omega3*omega3);
            const double omega4_by_k1 = -omega3_by_k1*t45 + (1.0/2.0)*t12*t13*t21*t23/t22;
            const double t46 = (1.0/(gap2*gap2));
            const double t47 = t20*t46;
            const double p4_by_k1 = t26*t39 - t43*t47;
            const double p5_by_k1 = gap2_by_k1*k1*t3*t46 - t25*t3;
            const double p6_by_k1 = gap2_by_k1*k1*t0*t46 - t27;
            /* d/dk2 of: spectrum */
            const double gap1_by_k2 = -t19*t5;
            const double t48 = (1.0/2.0)*gap1_by_k2;
            const double omega1_by_k2 = t34*(t31 + t48);
            const double t49 = (1.0/2.0)*k1;
            const double omega2_by_k2 = -omega1_by_k2*t38 + t37*(t36 + t49);
            const double p1_by_k2 = -t16*t31 - t41*t48;
            const double t50 = gap1_by_k2*t40;
            const double p2_by_k2 = t18*t50;
            const double t51 = k1*t0;
            const double p3_by_k2 = t50*t51;
            const double gap2_by_k2 = -t20*t27;
            const double t52 = (1.0/2.0)*gap2_by_k2;
            const double omega3_by_k2 = t44*(t31 + t52);
            const double omega4_by_k2 = -omega3_by_k2*t45 + (1.0/2.0)*t12*t13*t21*t22/t23;
            const double p4_by_k2 = -t25*t31 - t47*t52;
            const double t53 = gap2_by_k2*t46;
            const double p5_by_k2 = t18*t53;
            const double p6_by_k2 = t51*t53;
            /* d/dk3 of: spectrum */
            const double gap1_by_k3 = t42*t5;
            const double t54 = (1.0/2.0)*gap1_by_k3;
            const double omega1_by_k3 = t34*(t32 + t54);
            const double omega2_by_k3 = -omega1_by_k3*t38 + t37*(t35 + t49);
            const double p1_by_k3 = t16*t32 - t41*t54;
            const double t55 = gap1_by_k3*t40;
            const double p2_by_k3 = t18*t55;
            const double p3_by_k3 = t51*t55;
            /* d/dm1 of: spectrum */
            const double t56 = (1.0/(m1*m1));
            const double t57 = t4*t56;
            const double t58 = t56*t7;
            const double gap1_by_m1 = t17*(-2*t5*t57 - t58);
            const double t59 = (1.0/2.0)*gap1_by_m1;
            const double omega1_by_m1 = t34*(-1.0/2.0*t57 + t59);
            const double t60 = t10*t34;
            const double t61 = t13/(sqrt(m1)*sqrt(m1)*sqrt(m1));
            const double omega2_by_m1 = -omega1_by_m1*t38 - t60*t61;
            const double p1_by_m1 = -t17*t57 - t41*t59;
            const double t62 = k1*t56;
            const double t63 = gap1_by_m1*t40;
            const double p2_by_m1 = t16*t62 + t18*t63;
            const double p3_by_m1 = t51*t63;
            const double gap2_by_m1 = t26*(-2*t20*t62 - t58);
            const double t64 = (1.0/2.0)*gap2_by_m1;
            const double t65 = t49*t56;
            const double omega3_by_m1 = t44*(t64 - t65);
            const double t66 = t22*t23*t44;
            const double omega4_by_m1 = -omega3_by_m1*t45 - t61*t66;
            const double p4_by_m1 = -t25*t65 - t47*t64;
            const double t67 = gap2_by_m1*t46;
            const double p5_by_m1 = t18*t67 + t25*t62;
            const double p6_by_m1 = t51*t67;
            /* d/dm2 of: spectrum */
            const double t68 = (1.0/(m2*m2));
            const double t69 = 4*t3*t6*t68;
            const double gap1_by_m2 = t17*(2*t1*t5*t68 - t69);
            const double t70 = (1.0/2.0)*gap1_by_m2;
            const double t71 = t1*t68;
            const double t72 = -1.0/2.0*t71;
            const double omega1_by_m2 = t34*(t70 + t72);
            const double t73 = t12/(sqrt(m2)*sqrt(m2)*sqrt(m2));
            const double omega2_by_m2 = -omega1_by_m2*t38 - t60*t73;
            const double p1_by_m2 = t17*t71 - t41*t70;
            const double t74 = gap1_by_m2*t40;
            const double p2_by_m2 = t18*t74;
            const double t75 = k1*t68;
            const double p3_by_m2 = t16*t75 + t51*t74;
            const double gap2_by_m2 = t26*(2*t1*t20*t68 - t69);
            const double t76 = (1.0/2.0)*gap2_by_m2;
            const double omega3_by_m2 = t44*(t72 + t76);
            const double omega4_by_m2 = -omega3_by_m2*t45 - t66*t73;
            const double p4_by_m2 = t26*t71 - t47*t76;
            const double t77 = gap2_by_m2*t46;
            const double p5_by_m2 = t18*t77;
            const double p6_by_m2 = t25*t75 + t51*t77;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega3;
            fixed[6][lane] = omega4;
            fixed[7][lane] = p4;
            fixed[8][lane] = p5;
            fixed[9][lane] = p6;
            fixed[10][lane] = omega1_by_k1;
            fixed[11][lane] = omega1_by_k2;
            fixed[12][lane] = omega1_by_k3;
            fixed[13][lane] = omega1_by_m1;
            fixed[14][lane] = omega1_by_m2;
            fixed[15][lane] = omega2_by_k1;
            fixed[16][lane] = omega2_by_k2;
            fixed[17][lane] = omega2_by_k3;
            fixed[18][lane] = omega2_by_m1;
            fixed[19][lane] = omega2_by_m2;
            fixed[20][lane] = p1_by_k1;
            fixed[21][lane] = p1_by_k2;
            fixed[22][lane] = p1_by_k3;
            fixed[23][lane] = p1_by_m1;
            fixed[24][lane] = p1_by_m2;
            fixed[25][lane] = p2_by_k1;
            fixed[26][lane] = p2_by_k2;
            fixed[27][lane] = p2_by_k3;
            fixed[28][lane] = p2_by_m1;
            fixed[29][lane] = p2_by_m2;
            fixed[30][lane] = p3_by_k1;
            fixed[31][lane] = p3_by_k2;
            fixed[32][lane] = p3_by_k3;
            fixed[33][lane] = p3_by_m1;
            fixed[34][lane] = p3_by_m2;
            fixed[35][lane] = omega3_by_k1;
            fixed[36][lane] = omega3_by_k2;
            fixed[37][lane] = 0;
            fixed[38][lane] = omega3_by_m1;
            fixed[39][lane] = omega3_by_m2;
            fixed[40][lane] = omega4_by_k1;
            fixed[41][lane] = omega4_by_k2;
            fixed[42][lane] = 0;
            fixed[43][lane] = omega4_by_m1;
            fixed[44][lane] = omega4_by_m2;
            fixed[45][lane] = p4_by_k1;
            fixed[46][lane] = p4_by_k2;
            fixed[47][lane] = 0;
            fixed[48][lane] = p4_by_m1;
            fixed[49][lane] = p4_by_m2;
            fixed[50][lane] = p5_by_k1;
            fixed[51][lane] = p5_by_k2;
            fixed[52][lane] = 0;
            fixed[53][lane] = p5_by_m1;
            fixed[54][lane] = p5_by_m2;
            fixed[55][lane] = p6_by_k1;
            fixed[56][lane] = p6_by_k2;
            fixed[57][lane] = 0;
            fixed[58][lane] = p6_by_m1;
            fixed[59][lane] = p6_by_m2;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double k3 = parameter[4][lane];
            const double T = parameter[5][lane];
            const double y = unknown[0][lane];
            const double u = unknown[1][lane];
            const double w = unknown[2][lane];
            const double tau = unknown[3][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double omega4 = fixed[6][lane];
            const double p4 = fixed[7][lane];
            const double p5 = fixed[8][lane];
            const double p6 = fixed[9][lane];
            const double omega1_by_k1 = fixed[10][lane];
            const double omega1_by_k2 = fixed[11][lane];
            const double omega1_by_k3 = fixed[12][lane];
            const double omega1_by_m1 = fixed[13][lane];
            const double omega1_by_m2 = fixed[14][lane];
            const double omega2_by_k1 = fixed[15][lane];
            const double omega2_by_k2 = fixed[16][lane];
            const double omega2_by_k3 = fixed[17][lane];
            const double omega2_by_m1 = fixed[18][lane];
            const double omega2_by_m2 = fixed[19][lane];
            const double p1_by_k1 = fixed[20][lane];
            const double p1_by_k2 = fixed[21][lane];
            const double p1_by_k3 = fixed[22][lane];
            const double p1_by_m1 = fixed[23][lane];
            const double p1_by_m2 = fixed[24][lane];
            const double p2_by_k1 = fixed[25][lane];
            const double p2_by_k2 = fixed[26][lane];
            const double p2_by_k3 = fixed[27][lane];
            const double p2_by_m1 = fixed[28][lane];
            const double p2_by_m2 = fixed[29][lane];
            const double p3_by_k1 = fixed[30][lane];
            const double p3_by_k2 = fixed[31][lane];
            const double p3_by_k3 = fixed[32][lane];
            const double p3_by_m1 = fixed[33][lane];
            const double p3_by_m2 = fixed[34][lane];
            const double omega3_by_k1 = fixed[35][lane];
            const double omega3_by_k2 = fixed[36][lane];
            const double omega3_by_k3 = fixed[37][lane];
            const double omega3_by_m1 = fixed[38][lane];
            const double omega3_by_m2 = fixed[39][lane];
            const double omega4_by_k1 = fixed[40][lane];
            const double omega4_by_k2 = fixed[41][lane];
            const double omega4_by_k3 = fixed[42][lane];
            const double omega4_by_m1 = fixed[43][lane];
            const double omega4_by_m2 = fixed[44][lane];
            const double p4_by_k1 = fixed[45][lane];
            const double p4_by_k2 = fixed[46][lane];
            const double p4_by_k3 = fixed[47][lane];
            const double p4_by_m1 = fixed[48][lane];
            const double p4_by_m2 = fixed[49][lane];
            const double p5_by_k1 = fixed[50][lane];
            const double p5_by_k2 = fixed[51][lane];
            const double p5_by_k3 = fixed[52][lane];
            const double p5_by_m1 = fixed[53][lane];
            const double p5_by_m2 = fixed[54][lane];
            const double p6_by_k1 = fixed[55][lane];
            const double p6_by_k2 = fixed[56][lane];
            const double p6_by_k3 = fixed[57][lane];
            const double p6_by_m1 = fixed[58][lane];
            const double p6_by_m2 = fixed[59][lane];
            /* half of tau */
            const double half_tau = (1.0/2.0)*tau;
            /* functions of half_tau in contact */
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
            /* tau1 completes the period */
            const double tau1 = T - tau;
            /* half of tau1 */
            const double half_tau1 = (1.0/2.0)*tau1;
            /* functions of half_tau1 in free */
            const double t6 = half_tau1*omega3;
            double sine_2, cosine_2;
            nonsmooth_sincos(t6, &sine_2, &cosine_2);
            const double cos_omega3_half_tau1 = cosine_2;
            const double sin_omega3_half_tau1 = sine_2;
            const double t9 = half_tau1*omega4;
            double sine_3, cosine_3;
            nonsmooth_sincos(t9, &sine_3, &cosine_3);
            const double cos_omega4_half_tau1 = cosine_3;
            const double sin_omega4_half_tau1 = sine_3;
            /* d/dtau of: functions of half_tau in contact */
            const double t12 = (1.0/2.0)*omega1;
            const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t12;
            const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t12;
            const double t13 = (1.0/2.0)*omega2;
            const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t13;
            const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t13;
            /* d/dtau of: functions of half_tau1 in free */
            const double t14 = (1.0/2.0)*omega3;
            const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t14;
            const double t16 = cos_omega3_half_tau1*t14;
            const double sin_omega3_half_tau1_by_tau = -t16;
            const double t17 = (1.0/2.0)*omega4;
            const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t17;
            const double t19 = cos_omega4_half_tau1*t17;
            const double sin_omega4_half_tau1_by_tau = -t19;
            /* d/dm1 of: functions of half_tau in contact */
            const double t20 = half_tau*omega1_by_m1;
            const double cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t20;
            const double sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t20;
            const double t21 = half_tau*omega2_by_m1;
            const double cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t21;
            const double sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t21;
            /* d/dm2 of: functions of half_tau in contact */
            const double t22 = half_tau*omega1_by_m2;
            const double cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t22;
            const double sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t22;
            const double t23 = half_tau*omega2_by_m2;
            const double cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t23;
            const double sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t23;
            /* d/dk1 of: functions of half_tau in contact */
            const double t24 = half_tau*omega1_by_k1;
            const double cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t24;
            const double sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t24;
            const double t25 = half_tau*omega2_by_k1;
            const double cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t25;
            const double sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t25;
            /* d/dk2 of: functions of half_tau in contact */
            const double t26 = half_tau*omega1_by_k2;
            const double cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t26;
            const double sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t26;
            const double t27 = half_tau*omega2_by_k2;
            const double cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t27;
            const double sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t27;
            /* d/dk3 of: functions of half_tau in contact */
            const double t28 = half_tau*omega1_by_k3;
            const double cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t28;
            const double sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t28;
            const double t29 = half_tau*omega2_by_k3;
            const double cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t29;
            const double sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t29;
            /* d/dm1 of: functions of half_tau1 in free */
            const double t30 = half_tau1*omega3_by_m1;
            const double cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t30;
            const double sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t30;
            const double t31 = half_tau1*omega4_by_m1;
            const double cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t31;
            const double sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t31;
            /* d/dm2 of: functions of half_tau1 in free */
            const double t32 = half_tau1*omega3_by_m2;
            const double cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t32;
            const double sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t32;
            const double t33 = half_tau1*omega4_by_m2;
            const double cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t33;
            const double sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t33;
            /* d/dk1 of: functions of half_tau1 in free */
            const double t34 = half_tau1*omega3_by_k1;
            const double cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t34;
            const double sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t34;
            const double t35 = half_tau1*omega4_by_k1;
            const double cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t35;
            const double sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t35;
            /* d/dk2 of: functions of half_tau1 in free */
            const double t36 = half_tau1*omega3_by_k2;
            const double cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t36;
            const double sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t36;
            const double t37 = half_tau1*omega4_by_k2;
            const double cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t37;
            const double sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t37;
            /* d/dk3 of: functions of half_tau1 in free */
            const double t38 = half_tau1*omega3_by_k3;
            const double cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t38;
            const double sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t38;
            const double t39 = half_tau1*omega4_by_k3;
            const double cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t39;
            const double sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t39;
            /* d/dT of: functions of half_tau1 in free */
            const double cos_omega3_half_tau1_by_T = -cos_omega3_half_tau1_by_tau;
            const double sin_omega3_half_tau1_by_T = t16;
            const double cos_omega4_half_tau1_by_T = -cos_omega4_half_tau1_by_tau;
            const double sin_omega4_half_tau1_by_T = t19;
            /* outputs */
            const double t40 = k1*k2;
            const double t41 = k1*k3;
            const double t42 = k2*k3;
            const double t43 = t40 + t41 + t42;
            const double t44 = (1.0/(t43));
            const double t45 = p2*t40;
            const double t46 = p2*t41;
            const double t47 = p2*t42;
            const double t48 = t45 + t46 + t47;
            const double t49 = omega1*sin_omega1_half_tau;
            const double t50 = 1 - p1;
            const double t51 = p1*u + p2*w;
            const double t53 = -t51 + u;
            const double t55 = p1*t40;
            const double t56 = t45*y + t46*y - t46 + t47*y + t55;
            const double t57 = -t40 + t56;
            const double t58 = t44*t57;
            const double t59 = omega2*sin_omega2_half_tau_by_tau;
            const double t60 = t44*t56;
            const double t61 = omega1*sin_omega1_half_tau_by_tau;
            const double t63 = p1*t41;
            const double t64 = p1*t42;
            const double t65 = t55 + t63 + t64;
            const double t66 = t44*t49;
            const double t67 = omega2*sin_omega2_half_tau;
            const double t68 = t44*t67;
            const double t69 = p3*u;
            const double t70 = p1*w;
            const double t71 = t69 - t70 + w;
            const double t72 = -t69 + t70;
            const double t73 = p3*t40;
            const double t74 = t40*y + t41*y - t41 + t42*y;
            const double t75 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t63 - t73 - t74;
            const double t76 = t44*t75;
            const double t77 = t55*y + t63*y - t63 + t64*y - t73;
            const double t78 = t44*t77;
            const double t79 = omega3*sin_omega3_half_tau1;
            const double t80 = p4 - 1;
            const double t81 = p4*u + p5*w;
            const double t83 = t81 - u;
            const double t84 = p5*y;
            const double t85 = t80 + t84;
            const double t86 = omega4*sin_omega4_half_tau1_by_tau;
            const double t87 = p4 + t84;
            const double t88 = omega3*sin_omega3_half_tau1_by_tau;
            const double t89 = p6*u;
            const double t90 = p4*w;
            const double t91 = -t89 + t90 - w;
            const double t92 = t89 - t90;
            const double t93 = p4*y - p6 - y;
            const double t94 = p4*y - p6;
            const double t95 = cos_omega1_half_tau*u - cos_omega2_half_tau*u - t40*t66 + t40*t68;
            const double t96 = cos_omega1_half_tau*w - cos_omega2_half_tau*w - t66*t74 + t68*t74;
            const double t97 = sin_omega2_half_tau*t58;
            const double t98 = omega2*t58;
            const double t99 = sin_omega1_half_tau*t60;
            const double t100 = omega1*t60;
            const double t101 = k2*p1;
            const double t102 = k3*p2;
            const double t103 = k2*y;
            const double t104 = p2*t103;
            const double t105 = t102*y;
            const double t106 = t101 - t102 + t104 + t105;
            const double t107 = (1.0/(t43*t43));
            const double t108 = t107*(-k2 - k3);
            const double t109 = t57*t67;
            const double t110 = t49*t56;
            const double t111 = k1*p1;
            const double t112 = k1*p2;
            const double t113 = t112*y;
            const double t114 = t105 + t111 + t113;
            const double t115 = t107*(-k1 - k3);
            const double t116 = t104 - t112 + t113;
            const double t117 = t107*(-k1 - k2);
            const double t119 = sin_omega1_half_tau*t76;
            const double t120 = omega1*t76;
            const double t121 = sin_omega2_half_tau*t78;
            const double t122 = omega2*t78;
            const double t123 = k3*p1;
            const double t124 = k2*p3;
            const double t125 = -k3*p1*y + k3*y;
            const double t126 = t101*y;
            const double t127 = t123*y;
            const double t128 = t49*t75;
            const double t129 = t67*t77;
            const double t130 = k1*p3;
            const double t131 = k1*y;
            const double t132 = t111*y;
            const double t133 = -t111 + t126 + t132;
            const double t134 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + omega4*sin_omega4_half_tau1 - t79;
            const double t135 = cos_omega3_half_tau1*w - cos_omega4_half_tau1*w - omega4*sin_omega4_half_tau1*y + t79*y;
            const double t137 = sin_omega4_half_tau1*t85;
            const double t138 = omega4*t85;
            const double t139 = sin_omega3_half_tau1*t87;
            const double t140 = omega3*t87;
            const double t141 = sin_omega3_half_tau1*t93;
            const double t142 = omega3*t93;
            const double t143 = sin_omega4_half_tau1*t94;
            const double t144 = omega4*t94;
            matrix[0][0][lane] = omega2*sin_omega2_half_tau*t44*t48 - t44*t48*t49;
            matrix[0][1][lane] = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t50;
            matrix[0][2][lane] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
            matrix[0][3][lane] = cos_omega1_half_tau_by_tau*t51 + cos_omega2_half_tau_by_tau*t53 + t58*t59 - t60*t61;
            matrix[1][0][lane] = -t65*t68 + t66*(-t40 - t41 - t42 + t65);
            matrix[1][1][lane] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
            matrix[1][2][lane] = cos_omega1_half_tau*t50 + cos_omega2_half_tau*p1;
            matrix[1][3][lane] = cos_omega1_half_tau_by_tau*t71 + cos_omega2_half_tau_by_tau*t72 - t59*t78 + t61*t76;
            matrix[2][0][lane] = omega4*p5*sin_omega4_half_tau1 - p5*t79;
            matrix[2][1][lane] = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t80;
            matrix[2][2][lane] = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
            matrix[2][3][lane] = -cos_omega3_half_tau1_by_tau*t81 + cos_omega4_half_tau1_by_tau*t83 + t85*t86 - t87*t88;
            matrix[3][0][lane] = -omega4*p4*sin_omega4_half_tau1 + t79*t80;
            matrix[3][1][lane] = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
            matrix[3][2][lane] = cos_omega3_half_tau1*t80 - cos_omega4_half_tau1*p4;
            matrix[3][3][lane] = cos_omega3_half_tau1_by_tau*t91 + cos_omega4_half_tau1_by_tau*t92 - t86*t94 + t88*t93;
            matrix[0][4][lane] = -cos_omega1_half_tau_by_m1*t51 - cos_omega2_half_tau_by_m1*t53 + omega1_by_m1*t99 - omega2_by_m1*t97 - p1_by_m1*t95 - p2_by_m1*t96 + sin_omega1_half_tau_by_m1*t100 - sin_omega2_half_tau_by_m1*t98;
            matrix[0][5][lane] = -cos_omega1_half_tau_by_m2*t51 - cos_omega2_half_tau_by_m2*t53 + omega1_by_m2*t99 - omega2_by_m2*t97 - p1_by_m2*t95 - p2_by_m2*t96 + sin_omega1_half_tau_by_m2*t100 - sin_omega2_half_tau_by_m2*t98;
            matrix[0][6][lane] = -cos_omega1_half_tau_by_k1*t51 - cos_omega2_half_tau_by_k1*t53 + omega1_by_k1*t99 - omega2_by_k1*t97 - p1_by_k1*t95 - p2_by_k1*t96 + sin_omega1_half_tau_by_k1*t100 - sin_omega2_half_tau_by_k1*t98 + t106*t66 - t108*t109 + t108*t110 - t68*(-k2 + t106);
            matrix[0][7][lane] = -cos_omega1_half_tau_by_k2*t51 - cos_omega2_half_tau_by_k2*t53 + omega1_by_k2*t99 - omega2_by_k2*t97 - p1_by_k2*t95 - p2_by_k2*t96 + sin_omega1_half_tau_by_k2*t100 - sin_omega2_half_tau_by_k2*t98 - t109*t115 + t110*t115 + t114*t66 - t68*(-k1 + t114);
            matrix[0][8][lane] = -cos_omega1_half_tau_by_k3*t51 - cos_omega2_half_tau_by_k3*t53 + omega1_by_k3*t99 - omega2_by_k3*t97 - p1_by_k3*t95 - p2_by_k3*t96 + sin_omega1_half_tau_by_k3*t100 - sin_omega2_half_tau_by_k3*t98 - t109*t117 + t110*t117 + t116*t66 - t116*t68;
            matrix[0][9][lane] = 0;
            matrix[1][4][lane] = -cos_omega1_half_tau_by_m1*t71 - cos_omega2_half_tau_by_m1*t72 - omega1_by_m1*t119 + omega2_by_m1*t121 + p1_by_m1*t96 - p3_by_m1*t95 - sin_omega1_half_tau_by_m1*t120 + sin_omega2_half_tau_by_m1*t122;
            matrix[1][5][lane] = -cos_omega1_half_tau_by_m2*t71 - cos_omega2_half_tau_by_m2*t72 - omega1_by_m2*t119 + omega2_by_m2*t121 + p1_by_m2*t96 - p3_by_m2*t95 - sin_omega1_half_tau_by_m2*t120 + sin_omega2_half_tau_by_m2*t122;
            matrix[1][6][lane] = -cos_omega1_half_tau_by_k1*t71 - cos_omega2_half_tau_by_k1*t72 - omega1_by_k1*t119 + omega2_by_k1*t121 + p1_by_k1*t96 - p3_by_k1*t95 - sin_omega1_half_tau_by_k1*t120 + sin_omega2_half_tau_by_k1*t122 - t108*t128 + t108*t129 - t66*(k2*p1*y + k3 - t103 - t123 - t124 - t125) + t68*(-t123 - t124 + t126 + t127);
            matrix[1][7][lane] = -cos_omega1_half_tau_by_k2*t71 - cos_omega2_half_tau_by_k2*t72 - omega1_by_k2*t119 + omega2_by_k2*t121 + p1_by_k2*t96 - p3_by_k2*t95 - sin_omega1_half_tau_by_k2*t120 + sin_omega2_half_tau_by_k2*t122 - t115*t128 + t115*t129 - t66*(k1*p1*y - t125 - t130 - t131) + t68*(t127 - t130 + t132);
            matrix[1][8][lane] = -cos_omega1_half_tau_by_k3*t71 - cos_omega2_half_tau_by_k3*t72 - omega1_by_k3*t119 + omega2_by_k3*t121 + p1_by_k3*t96 - p3_by_k3*t95 - sin_omega1_half_tau_by_k3*t120 + sin_omega2_half_tau_by_k3*t122 - t117*t128 + t117*t129 + t133*t68 - t66*(k1 - t103 - t131 + t133);
            matrix[1][9][lane] = 0;
            matrix[2][4][lane] = cos_omega3_half_tau1_by_m1*t81 - cos_omega4_half_tau1_by_m1*t83 + omega3_by_m1*t139 - omega4_by_m1*t137 - p4_by_m1*t134 + p5_by_m1*t135 + sin_omega3_half_tau1_by_m1*t140 - sin_omega4_half_tau1_by_m1*t138;
            matrix[2][5][lane] = cos_omega3_half_tau1_by_m2*t81 - cos_omega4_half_tau1_by_m2*t83 + omega3_by_m2*t139 - omega4_by_m2*t137 - p4_by_m2*t134 + p5_by_m2*t135 + sin_omega3_half_tau1_by_m2*t140 - sin_omega4_half_tau1_by_m2*t138;
            matrix[2][6][lane] = cos_omega3_half_tau1_by_k1*t81 - cos_omega4_half_tau1_by_k1*t83 + omega3_by_k1*t139 - omega4_by_k1*t137 - p4_by_k1*t134 + p5_by_k1*t135 + sin_omega3_half_tau1_by_k1*t140 - sin_omega4_half_tau1_by_k1*t138;
            matrix[2][7][lane] = cos_omega3_half_tau1_by_k2*t81 - cos_omega4_half_tau1_by_k2*t83 + omega3_by_k2*t139 - omega4_by_k2*t137 - p4_by_k2*t134 + p5_by_k2*t135 + sin_omega3_half_tau1_by_k2*t140 - sin_omega4_half_tau1_by_k2*t138;
            matrix[2][8][lane] = cos_omega3_half_tau1_by_k3*t81 - cos_omega4_half_tau1_by_k3*t83 + omega3_by_k3*t139 - omega4_by_k3*t137 - p4_by_k3*t134 + p5_by_k3*t135 + sin_omega3_half_tau1_by_k3*t140 - sin_omega4_half_tau1_by_k3*t138;
            matrix[2][9][lane] = cos_omega3_half_tau1_by_T*t81 - cos_omega4_half_tau1_by_T*t83 + sin_omega3_half_tau1_by_T*t140 - sin_omega4_half_tau1_by_T*t138;
            matrix[3][4][lane] = -cos_omega3_half_tau1_by_m1*t91 - cos_omega4_half_tau1_by_m1*t92 - omega3_by_m1*t141 + omega4_by_m1*t143 - p4_by_m1*t135 - p6_by_m1*t134 - sin_omega3_half_tau1_by_m1*t142 + sin_omega4_half_tau1_by_m1*t144;
            matrix[3][5][lane] = -cos_omega3_half_tau1_by_m2*t91 - cos_omega4_half_tau1_by_m2*t92 - omega3_by_m2*t141 + omega4_by_m2*t143 - p4_by_m2*t135 - p6_by_m2*t134 - sin_omega3_half_tau1_by_m2*t142 + sin_omega4_half_tau1_by_m2*t144;
            matrix[3][6][lane] = -cos_omega3_half_tau1_by_k1*t91 - cos_omega4_half_tau1_by_k1*t92 - omega3_by_k1*t141 + omega4_by_k1*t143 - p4_by_k1*t135 - p6_by_k1*t134 - sin_omega3_half_tau1_by_k1*t142 + sin_omega4_half_tau1_by_k1*t144;
            matrix[3][7][lane] = -cos_omega3_half_tau1_by_k2*t91 - cos_omega4_half_tau1_by_k2*t92 - omega3_by_k2*t141 + omega4_by_k2*t143 - p4_by_k2*t135 - p6_by_k2*t134 - sin_omega3_half_tau1_by_k2*t142 + sin_omega4_half_tau1_by_k2*t144;
            matrix[3][8][lane] = -cos_omega3_half_tau1_by_k3*t91 - cos_omega4_half_tau1_by_k3*t92 - omega3_by_k3*t141 + omega4_by_k3*t143 - p4_by_k3*t135 - p6_by_k3*t134 - sin_omega3_half_tau1_by_k3*t142 + sin_omega4_half_tau1_by_k3*t144;
            matrix[3][9][lane] = -cos_omega3_half_tau1_by_T*t91 - cos_omega4_half_tau1_by_T*t92 - sin_omega3_half_tau1_by_T*t142 + sin_omega4_half_tau1_by_T*t144;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double m1 = parameter[0][lane];
            const double m2 = parameter[1][lane];
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double k3 = parameter[4][lane];
            const double T = parameter[5][lane];
            const double y = unknown[0][lane];
            const double u = unknown[1][lane];
            const double w = unknown[2][lane];
            const double tau = unknown[3][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega3 = fixed[5][lane];
            const double omega4 = fixed[6][lane];
            const double p4 = fixed[7][lane];
            const double p5 = fixed[8][lane];
            const double p6 = fixed[9][lane];
            const double omega1_by_k1 = fixed[10][lane];
            const double omega1_by_k2 = fixed[11][lane];
            const double omega1_by_k3 = fixed[12][lane];
            const double omega1_by_m1 = fixed[13][lane];
            const double omega1_by_m2 = fixed[14][lane];
            const double omega2_by_k1 = fixed[15][lane];
            const double omega2_by_k2 = fixed[16][lane];
            const double omega2_by_k3 = fixed[17][lane];
            const double omega2_by_m1 = fixed[18][lane];
            const double omega2_by_m2 = fixed[19][lane];
            const double p1_by_k1 = fixed[20][lane];
            const double p1_by_k2 = fixed[21][lane];
            const double p1_by_k3 = fixed[22][lane];
            const double p1_by_m1 = fixed[23][lane];
            const double p1_by_m2 = fixed[24][lane];
            const double p2_by_k1 = fixed[25][lane];
            const double p2_by_k2 = fixed[26][lane];
            const double p2_by_k3 = fixed[27][lane];
            const double p2_by_m1 = fixed[28][lane];
            const double p2_by_m2 = fixed[29][lane];
            const double p3_by_k1 = fixed[30][lane];
            const double p3_by_k2 = fixed[31][lane];
            const double p3_by_k3 = fixed[32][lane];
            const double p3_by_m1 = fixed[33][lane];
            const double p3_by_m2 = fixed[34][lane];
            const double omega3_by_k1 = fixed[35][lane];
            const double omega3_by_k2 = fixed[36][lane];
            const double omega3_by_k3 = fixed[37][lane];
            const double omega3_by_m1 = fixed[38][lane];
            const double omega3_by_m2 = fixed[39][lane];
            const double omega4_by_k1 = fixed[40][lane];
            const double omega4_by_k2 = fixed[41][lane];
            const double omega4_by_k3 = fixed[42][lane];
            const double omega4_by_m1 = fixed[43][lane];
            const double omega4_by_m2 = fixed[44][lane];
            const double p4_by_k1 = fixed[45][lane];
            const double p4_by_k2 = fixed[46][lane];
            const double p4_by_k3 = fixed[47][lane];
            const double p4_by_m1 = fixed[48][lane];
            const double p4_by_m2 = fixed[49][lane];
            const double p5_by_k1 = fixed[50][lane];
            const double p5_by_k2 = fixed[51][lane];
            const double p5_by_k3 = fixed[52][lane];
            const double p5_by_m1 = fixed[53][lane];
            const double p5_by_m2 = fixed[54][lane];
            const double p6_by_k1 = fixed[55][lane];
            const double p6_by_k2 = fixed[56][lane];
            const double p6_by_k3 = fixed[57][lane];
            const double p6_by_m1 = fixed[58][lane];
            const double p6_by_m2 = fixed[59][lane];
            /* functions of tau in contact */
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
            /* contact for tau, until first-leaves-stop */
            const double t6 = k1*k3;
            const double t7 = k2*k3 + t6;
            const double t8 = k1*k2 + t7;
            const double t9 = (1.0/(t8));
            const double t10 = t7*t9;
            const double t11 = t6*t9;
            const double t12 = p2*t11;
            const double t13 = p1*t10 + t12;
            const double t14 = p1 - 1;
            const double t15 = t10*t14 + t12;
            const double t16 = (1.0/(omega1));
            const double t17 = sin_omega1_tau*t16;
            const double t19 = (1.0/(omega2));
            const double t20 = sin_omega2_tau*t19;
            const double t21 = p1*t17 - t14*t20;
            const double t22 = p2*sin_omega1_tau*t16 - p2*t20;
            const double t23 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
            const double t24 = cos_omega1_tau*p1 - cos_omega2_tau*t14;
            const double x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t22*w + t23*y + t24;
            const double t25 = p3*t10;
            const double t27 = t11*t14 - t25;
            const double t28 = p1*t11;
            const double t29 = -t25 + t28;
            const double t30 = p3*sin_omega1_tau*t16 - p3*t20;
            const double t31 = p1*t20 - t14*t17;
            const double t32 = -cos_omega1_tau*t14 + cos_omega2_tau*p1;
            const double t33 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
            const double x2_1 = cos_omega1_tau*t27 - cos_omega2_tau*t29 + t11 + t30*u + t31*w + t32*y + t33;
            const double t34 = omega1*p1;
            const double t35 = omega1*t12 + t10*t34;
            const double t36 = omega2*t12 + omega2*t14*t7*t9;
            const double t37 = omega1*sin_omega1_tau;
            const double t38 = omega2*p2*sin_omega2_tau - p2*t37;
            const double t39 = -omega2*t14;
            const double v1_1 = -sin_omega1_tau*t34 + sin_omega1_tau*t35 - sin_omega2_tau*t36 - sin_omega2_tau*t39 + t23*w + t24*u + t38*y;
            const double t40 = omega1*p3;
            const double t41 = -t11*t14;
            const double t42 = omega1*t41 + t10*t40;
            const double t43 = omega2*p3;
            const double t44 = omega2*t28 - t10*t43;
            const double t45 = omega2*sin_omega2_tau;
            const double t46 = -p1*t45 + t14*t37;
            const double v2_1 = -sin_omega1_tau*t40 + sin_omega1_tau*t42 + sin_omega2_tau*t43 + sin_omega2_tau*t44 + t32*w + t33*u + t46*y;
            /* tau1 completes the period */
            const double tau1 = T - tau;
            /* functions of tau1 in free */
            const double t47 = omega3*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t47, &sine_2, &cosine_2);
            const double cos_omega3_tau1 = cosine_2;
            const double sin_omega3_tau1 = sine_2;
            const double t50 = omega4*tau1;
            double sine_3, cosine_3;
            nonsmooth_sincos(t50, &sine_3, &cosine_3);
            const double cos_omega4_tau1 = cosine_3;
            const double sin_omega4_tau1 = sine_3;
            /* free for tau1, until first-reaches-stop */
            const double t53 = (1.0/(omega3));
            const double t54 = sin_omega3_tau1*t53;
            const double t55 = 1 - p4;
            const double t56 = (1.0/(omega4));
            const double t57 = sin_omega4_tau1*t56;
            const double t58 = p4*t54 + t55*t57;
            const double t59 = p5*sin_omega3_tau1*t53 - p5*t57;
            const double t60 = cos_omega3_tau1*p4 + cos_omega4_tau1*t55;
            const double t61 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
            const double x1_2 = t58*v1_1 + t59*v2_1 + t60*x1_1 + t61*x2_1;
            const double t62 = p6*sin_omega3_tau1*t53 - p6*t57;
            const double t63 = p4*t57 + t54*t55;
            const double t64 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
            const double t65 = cos_omega3_tau1*t55 + cos_omega4_tau1*p4;
            const double x2_2 = t62*v1_1 + t63*v2_1 + t64*x1_1 + t65*x2_1;
            const double t66 = omega3*sin_omega3_tau1;
            const double t67 = omega4*sin_omega4_tau1;
            const double t68 = -p4*t66 - t55*t67;
            const double t69 = omega4*p5*sin_omega4_tau1 - p5*t66;
            const double v1_2 = t60*v1_1 + t61*v2_1 + t68*x1_1 + t69*x2_1;
            const double t70 = omega4*p6*sin_omega4_tau1 - p6*t66;
            const double t71 = -p4*t67 - t55*t66;
            const double v2_2 = t64*v1_1 + t65*v2_1 + t70*x1_1 + t71*x2_1;
            /* Phi along tau */
            const double carried_x1_1_by_y = t23;
            const double carried_x1_1_by_u = t21;
            const double carried_x1_1_by_w = t22;
            const double carried_x2_1_by_y = t32;
            const double carried_x2_1_by_u = t30;
            const double carried_x2_1_by_w = t31;
            const double carried_v1_1_by_y = t38;
            const double carried_v1_1_by_u = t24;
            const double carried_v1_1_by_w = t23;
            const double carried_v2_1_by_y = t46;
            const double carried_v2_1_by_u = t33;
            const double carried_v2_1_by_w = t32;
            /* rate of the exit boundary after tau */
            const double rate_1 = -v1_1;
            /* derivatives of the time to the boundary after tau */
            const double t72 = (1.0/(rate_1));
            const double delay_tau_by_y = carried_x1_1_by_y*t72;
            const double delay_tau_by_u = carried_x1_1_by_u*t72;
            const double delay_tau_by_w = carried_x1_1_by_w*t72;
            /* perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
            const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
            const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
            const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
            const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
            const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
            const double t73 = (1.0/(m1));
            const double t74 = k1 + k3;
            const double t75 = t73*x1_1;
            const double t76 = k1*t73*x2_1 + k3*t73 - t74*t75;
            const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t76;
            const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t76;
            const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t76;
            const double t77 = (1.0/(m2));
            const double t78 = t77*x1_1;
            const double t79 = k1 + k2;
            const double t80 = t77*x2_1;
            const double t81 = k1*t78 - t79*t80;
            const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t81;
            const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t81;
            const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t81;
            /* Phi along tau1 */
            const double carried_x1_2_by_y = t58*v1_1_on_boundary_by_y + t59*v2_1_on_boundary_by_y + t60*x1_1_on_boundary_by_y + t61*x2_1_on_boundary_by_y;
            const double carried_x1_2_by_u = t58*v1_1_on_boundary_by_u + t59*v2_1_on_boundary_by_u + t60*x1_1_on_boundary_by_u + t61*x2_1_on_boundary_by_u;
            const double carried_x1_2_by_w = t58*v1_1_on_boundary_by_w + t59*v2_1_on_boundary_by_w + t60*x1_1_on_boundary_by_w + t61*x2_1_on_boundary_by_w;
            /* derivatives of the time to the boundary after tau1 */
            const double t82 = (1.0/(v1_2));
            const double delay_tau1_by_y = -carried_x1_2_by_y*t82;
            const double delay_tau1_by_u = -carried_x1_2_by_u*t82;
            const double delay_tau1_by_w = -carried_x1_2_by_w*t82;
            /* d/dtau of: functions of tau in contact */
            const double cos_omega1_tau_by_tau = -omega1*sin_omega1_tau;
            const double sin_omega1_tau_by_tau = cos_omega1_tau*omega1;
            const double cos_omega2_tau_by_tau = -omega2*sin_omega2_tau;
            const double sin_omega2_tau_by_tau = cos_omega2_tau*omega2;
            /* d/dm1 of: functions of tau in contact */
            const double t83 = omega1_by_m1*tau;
            const double cos_omega1_tau_by_m1 = -sin_omega1_tau*t83;
            const double sin_omega1_tau_by_m1 = cos_omega1_tau*t83;
            const double t84 = omega2_by_m1*tau;
            const double cos_omega2_tau_by_m1 = -sin_omega2_tau*t84;
            const double sin_omega2_tau_by_m1 = cos_omega2_tau*t84;
            /* d/dm2 of: functions of tau in contact */
            const double t85 = omega1_by_m2*tau;
            const double cos_omega1_tau_by_m2 = -sin_omega1_tau*t85;
            const double sin_omega1_tau_by_m2 = cos_omega1_tau*t85;
            const double t86 = omega2_by_m2*tau;
            const double cos_omega2_tau_by_m2 = -sin_omega2_tau*t86;
            const double sin_omega2_tau_by_m2 = cos_omega2_tau*t86;
            /* d/dk1 of: functions of tau in contact */
            const double t87 = omega1_by_k1*tau;
            const double cos_omega1_tau_by_k1 = -sin_omega1_tau*t87;
            const double sin_omega1_tau_by_k1 = cos_omega1_tau*t87;
            const double t88 = omega2_by_k1*tau;
            const double cos_omega2_tau_by_k1 = -sin_omega2_tau*t88;
            const double sin_omega2_tau_by_k1 = cos_omega2_tau*t88;
            /* d/dk2 of: functions of tau in contact */
            const double t89 = omega1_by_k2*tau;
            const double cos_omega1_tau_by_k2 = -sin_omega1_tau*t89;
            const double sin_omega1_tau_by_k2 = cos_omega1_tau*t89;
            const double t90 = omega2_by_k2*tau;
            const double cos_omega2_tau_by_k2 = -sin_omega2_tau*t90;
            const double sin_omega2_tau_by_k2 = cos_omega2_tau*t90;
            /* d/dk3 of: functions of tau in contact */
            const double t91 = omega1_by_k3*tau;
            const double cos_omega1_tau_by_k3 = -sin_omega1_tau*t91;
            const double sin_omega1_tau_by_k3 = cos_omega1_tau*t91;
            const double t92 = omega2_by_k3*tau;
            const double cos_omega2_tau_by_k3 = -sin_omega2_tau*t92;
            const double sin_omega2_tau_by_k3 = cos_omega2_tau*t92;
            /* d/dy of: contact for tau, until first-leaves-stop */
            const double x1_1_by_y = t23;
            const double x2_1_by_y = t32;
            const double v1_1_by_y = t38;
            const double v2_1_by_y = t46;
            /* d/du of: contact for tau, until first-leaves-stop */
            const double x1_1_by_u = t21;
            const double x2_1_by_u = t30;
            const double v1_1_by_u = t24;
            const double v2_1_by_u = t33;
            /* d/dw of: contact for tau, until first-leaves-stop */
            const double x1_1_by_w = t22;
            const double x2_1_by_w = t31;
            const double v1_1_by_w = t23;
            const double v2_1_by_w = t32;
            /* d/dtau of: contact for tau, until first-leaves-stop */
            const double t93 = p2*y;
            const double t94 = -p1 - t93;
            const double t95 = -t13 - t94;
            const double t96 = t15 + t94 + 1;
            const double t97 = p1*u;
            const double t98 = p2*w;
            const double t99 = t16*t97 + t16*t98;
            const double t100 = -t14*t19*u - t19*t98;
            const double x1_1_by_tau = cos_omega1_tau_by_tau*t95 + cos_omega2_tau_by_tau*t96 + sin_omega1_tau_by_tau*t99 + sin_omega2_tau_by_tau*t100;
            const double t101 = -t14*y;
            const double t102 = p3 + t101 + t27;
            const double t103 = p1*y - p3 - t29;
            const double t104 = p3*u;
            const double t105 = -t14*w;
            const double t106 = t104*t16 + t105*t16;
            const double t107 = p1*w;
            const double t108 = -t104*t19 + t107*t19;
            const double x2_1_by_tau = cos_omega1_tau_by_tau*t102 + cos_omega2_tau_by_tau*t103 + sin_omega1_tau_by_tau*t106 + sin_omega2_tau_by_tau*t108;
            const double t109 = t97 + t98;
            const double t110 = -t14*u - t98;
            const double t111 = -omega1*t93 - t34 + t35;
            const double t112 = omega2*p2*y - t36 - t39;
            const double v1_1_by_tau = cos_omega1_tau_by_tau*t109 + cos_omega2_tau_by_tau*t110 + sin_omega1_tau_by_tau*t111 + sin_omega2_tau_by_tau*t112;
            const double t113 = t104 + t105;
            const double t114 = -t104 + t107;
            const double t115 = -omega1*t101 - t40 + t42;
            const double t116 = p1*y;
            const double t117 = -omega2*t116 + t43 + t44;
            const double v2_1_by_tau = cos_omega1_tau_by_tau*t113 + cos_omega2_tau_by_tau*t114 + sin_omega1_tau_by_tau*t115 + sin_omega2_tau_by_tau*t117;
            /* d/dm1 of: contact for tau, until first-leaves-stop */
            const double t118 = (1.0/(omega1*omega1));
            const double t119 = sin_omega1_tau*t118;
            const double t120 = -t119*t97 - t119*t98;
            const double t121 = (1.0/(omega2*omega2));
            const double t122 = sin_omega2_tau*t121;
            const double t123 = t122*t14*u + t122*t98;
            const double t124 = -sin_omega1_tau*t16 + t20;
            const double t126 = cos_omega1_tau - cos_omega2_tau;
            const double t127 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t124*u + t126;
            const double t128 = cos_omega2_tau*t11;
            const double t129 = cos_omega1_tau*t11;
            const double t130 = -t124*w + t126*y + t128 - t129;
            const double x1_1_by_m1 = cos_omega1_tau_by_m1*t95 + cos_omega2_tau_by_m1*t96 + omega1_by_m1*t120 + omega2_by_m1*t123 + p1_by_m1*t127 + p2_by_m1*t130 + sin_omega1_tau_by_m1*t99 + sin_omega2_tau_by_m1*t100;
            const double t131 = -t104*t119 - t105*t119;
            const double t132 = p3*sin_omega2_tau*t121*u - t107*t122;
            const double t134 = t124*w - t126*y - t128 + t129;
            const double x2_1_by_m1 = cos_omega1_tau_by_m1*t102 + cos_omega2_tau_by_m1*t103 + omega1_by_m1*t131 + omega2_by_m1*t132 + p1_by_m1*t134 + p3_by_m1*t127 + sin_omega1_tau_by_m1*t106 + sin_omega2_tau_by_m1*t108;
            const double t135 = p1*sin_omega1_tau;
            const double t136 = sin_omega1_tau*t13 - sin_omega1_tau*t93 - t135;
            const double t137 = -sin_omega2_tau*t14;
            const double t138 = sin_omega2_tau*t93 + sin_omega2_tau*(-t12 - t14*t7*t9) - t137;
            const double t139 = t10*t37 - t10*t45 + t126*u - t37 + t45;
            const double t140 = -omega2*sin_omega2_tau + t37;
            const double t142 = t11*t37;
            const double t143 = t11*t45;
            const double t144 = t126*w - t140*y + t142 - t143;
            const double v1_1_by_m1 = cos_omega1_tau_by_m1*t109 + cos_omega2_tau_by_m1*t110 + omega1_by_m1*t136 + omega2_by_m1*t138 + p1_by_m1*t139 + p2_by_m1*t144 + sin_omega1_tau_by_m1*t111 + sin_omega2_tau_by_m1*t112;
            const double t145 = p3*sin_omega1_tau;
            const double t146 = -sin_omega1_tau*t101 + sin_omega1_tau*(t25 + t41) - t145;
            const double t147 = p3*sin_omega2_tau;
            const double t148 = -sin_omega2_tau*t116 + sin_omega2_tau*t29 + t147;
            const double t149 = -t126*w + t140*y - t142 + t143;
            const double v2_1_by_m1 = cos_omega1_tau_by_m1*t113 + cos_omega2_tau_by_m1*t114 + omega1_by_m1*t146 + omega2_by_m1*t148 + p1_by_m1*t149 + p3_by_m1*t139 + sin_omega1_tau_by_m1*t115 + sin_omega2_tau_by_m1*t117;
            /* d/dm2 of: contact for tau, until first-leaves-stop */
            const double x1_1_by_m2 = cos_omega1_tau_by_m2*t95 + cos_omega2_tau_by_m2*t96 + omega1_by_m2*t120 + omega2_by_m2*t123 + p1_by_m2*t127 + p2_by_m2*t130 + sin_omega1_tau_by_m2*t99 + sin_omega2_tau_by_m2*t100;
            const double x2_1_by_m2 = cos_omega1_tau_by_m2*t102 + cos_omega2_tau_by_m2*t103 + omega1_by_m2*t131 + omega2_by_m2*t132 + p1_by_m2*t134 + p3_by_m2*t127 + sin_omega1_tau_by_m2*t106 + sin_omega2_tau_by_m2*t108;
            const double v1_1_by_m2 = cos_omega1_tau_by_m2*t109 + cos_omega2_tau_by_m2*t110 + omega1_by_m2*t136 + omega2_by_m2*t138 + p1_by_m2*t139 + p2_by_m2*t144 + sin_omega1_tau_by_m2*t111 + sin_omega2_tau_by_m2*t112;
            const double v2_1_by_m2 = cos_omega1_tau_by_m2*t113 + cos_omega2_tau_by_m2*t114 + omega1_by_m2*t146 + omega2_by_m2*t148 + p1_by_m2*t149 + p3_by_m2*t139 + sin_omega1_tau_by_m2*t115 + sin_omega2_tau_by_m2*t117;
            /* d/dk1 of: contact for tau, until first-leaves-stop */
            const double t150 = k3*t9;
            const double t151 = p1*t150;
            const double t152 = -k2 - k3;
            const double t153 = (1.0/(t8*t8));
            const double t154 = t153*t7;
            const double t155 = t152*t154;
            const double t156 = p2*t150;
            const double t157 = t153*t6;
            const double t158 = t152*t157;
            const double t159 = p2*t158;
            const double t160 = t156 + t159;
            const double t161 = t14*t150;
            const double x1_1_by_k1 = cos_omega1_tau*(-p1*t155 - t151 - t160) + cos_omega1_tau_by_k1*t95 + cos_omega2_tau*(t14*t155 + t160 + t161) + cos_omega2_tau_by_k1*t96 + omega1_by_k1*t120 + omega2_by_k1*t123 + p1_by_k1*t127 + p2_by_k1*t130 + sin_omega1_tau_by_k1*t99 + sin_omega2_tau_by_k1*t100 + t150 + t155;
            const double t162 = p3*t150;
            const double t163 = -p3*t155 - t162;
            const double t164 = p1*t158;
            const double x2_1_by_k1 = cos_omega1_tau*(t14*t158 + t161 + t163) + cos_omega1_tau_by_k1*t102 + cos_omega2_tau*(-t151 - t163 - t164) + cos_omega2_tau_by_k1*t103 + omega1_by_k1*t131 + omega2_by_k1*t132 + p1_by_k1*t134 + p3_by_k1*t127 + sin_omega1_tau_by_k1*t106 + sin_omega2_tau_by_k1*t108 + t150 + t158;
            const double t165 = t150*t34;
            const double v1_1_by_k1 = cos_omega1_tau_by_k1*t109 + cos_omega2_tau_by_k1*t110 + omega1_by_k1*t136 + omega2_by_k1*t138 + p1_by_k1*t139 + p2_by_k1*t144 + sin_omega1_tau*(omega1*t156 + omega1*t159 + t155*t34 + t165) + sin_omega1_tau_by_k1*t111 + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t152*t153*t7 - omega2*t156 - omega2*t159) + sin_omega2_tau_by_k1*t112;
            const double t166 = t150*t40;
            const double t167 = -omega1*t14;
            const double t168 = t150*t43;
            const double v2_1_by_k1 = cos_omega1_tau_by_k1*t113 + cos_omega2_tau_by_k1*t114 + omega1_by_k1*t146 + omega2_by_k1*t148 + p1_by_k1*t149 + p3_by_k1*t139 + sin_omega1_tau*(t150*t167 + t155*t40 + t158*t167 + t166) + sin_omega1_tau_by_k1*t115 + sin_omega2_tau*(omega2*t151 + omega2*t164 - t155*t43 - t168) + sin_omega2_tau_by_k1*t117;
            /* d/dk2 of: contact for tau, until first-leaves-stop */
            const double t170 = -t154*t74;
            const double t171 = -t157*t74;
            const double t172 = p2*t171;
            const double x1_1_by_k2 = cos_omega1_tau*(-p1*t170 - t151 - t172) + cos_omega1_tau_by_k2*t95 + cos_omega2_tau*(t14*t170 + t161 + t172) + cos_omega2_tau_by_k2*t96 + omega1_by_k2*t120 + omega2_by_k2*t123 + p1_by_k2*t127 + p2_by_k2*t130 + sin_omega1_tau_by_k2*t99 + sin_omega2_tau_by_k2*t100 + t150 + t170;
            const double t173 = p3*t170 + t162;
            const double x2_1_by_k2 = cos_omega1_tau*(-k1*k3*t14*t153*t74 - t173) + cos_omega1_tau_by_k2*t102 + cos_omega2_tau*(-p1*t171 + t173) + cos_omega2_tau_by_k2*t103 + omega1_by_k2*t131 + omega2_by_k2*t132 + p1_by_k2*t134 + p3_by_k2*t127 + sin_omega1_tau_by_k2*t106 + sin_omega2_tau_by_k2*t108 + t171;
            const double v1_1_by_k2 = cos_omega1_tau_by_k2*t109 + cos_omega2_tau_by_k2*t110 + omega1_by_k2*t136 + omega2_by_k2*t138 + p1_by_k2*t139 + p2_by_k2*t144 + sin_omega1_tau*(omega1*t172 + t165 + t170*t34) + sin_omega1_tau_by_k2*t111 + sin_omega2_tau*(-omega2*t172 + t150*t39 + t170*t39) + sin_omega2_tau_by_k2*t112;
            const double v2_1_by_k2 = cos_omega1_tau_by_k2*t113 + cos_omega2_tau_by_k2*t114 + omega1_by_k2*t146 + omega2_by_k2*t148 + p1_by_k2*t149 + p3_by_k2*t139 + sin_omega1_tau*(t166 + t167*t171 + t170*t40) + sin_omega1_tau_by_k2*t115 + sin_omega2_tau*(-k1*k3*omega2*p1*t153*t74 - t168 - t170*t43) + sin_omega2_tau_by_k2*t117;
            /* d/dk3 of: contact for tau, until first-leaves-stop */
            const double t174 = t79*t9;
            const double t176 = -t154*t79;
            const double t177 = k1*t9;
            const double t178 = p2*t177;
            const double t179 = -t157*t79;
            const double t180 = p2*t179;
            const double t181 = t178 + t180;
            const double x1_1_by_k3 = cos_omega1_tau*(-p1*t174 - p1*t176 - t181) + cos_omega1_tau_by_k3*t95 + cos_omega2_tau*(t14*t174 + t14*t176 + t181) + cos_omega2_tau_by_k3*t96 + omega1_by_k3*t120 + omega2_by_k3*t123 + p1_by_k3*t127 + p2_by_k3*t130 + sin_omega1_tau_by_k3*t99 + sin_omega2_tau_by_k3*t100 + t174 + t176;
            const double t182 = -p3*t174 - p3*t176;
            const double t183 = p1*t177;
            const double t184 = p1*t179;
            const double x2_1_by_k3 = cos_omega1_tau*(t14*t177 + t14*t179 + t182) + cos_omega1_tau_by_k3*t102 + cos_omega2_tau*(-t182 - t183 - t184) + cos_omega2_tau_by_k3*t103 + omega1_by_k3*t131 + omega2_by_k3*t132 + p1_by_k3*t134 + p3_by_k3*t127 + sin_omega1_tau_by_k3*t106 + sin_omega2_tau_by_k3*t108 + t177 + t179;
            const double v1_1_by_k3 = cos_omega1_tau_by_k3*t109 + cos_omega2_tau_by_k3*t110 + omega1_by_k3*t136 + omega2_by_k3*t138 + p1_by_k3*t139 + p2_by_k3*t144 + sin_omega1_tau*(omega1*t178 + omega1*t180 + t174*t34 + t176*t34) + sin_omega1_tau_by_k3*t111 + sin_omega2_tau*(omega2*t14*t153*t7*t79 - omega2*t14*t79*t9 - omega2*t178 - omega2*t180) + sin_omega2_tau_by_k3*t112;
            const double v2_1_by_k3 = cos_omega1_tau_by_k3*t113 + cos_omega2_tau_by_k3*t114 + omega1_by_k3*t146 + omega2_by_k3*t148 + p1_by_k3*t149 + p3_by_k3*t139 + sin_omega1_tau*(t167*t177 + t167*t179 + t174*t40 + t176*t40) + sin_omega1_tau_by_k3*t115 + sin_omega2_tau*(omega2*t183 + omega2*t184 - t174*t43 - t176*t43) + sin_omega2_tau_by_k3*t117;
            /* d/dtau of: functions of tau1 in free */
            const double cos_omega3_tau1_by_tau = omega3*sin_omega3_tau1;
            const double t186 = cos_omega3_tau1*omega3;
            const double sin_omega3_tau1_by_tau = -t186;
            const double cos_omega4_tau1_by_tau = omega4*sin_omega4_tau1;
            const double t188 = cos_omega4_tau1*omega4;
            const double sin_omega4_tau1_by_tau = -t188;
            /* d/dm1 of: functions of tau1 in free */
            const double t189 = omega3_by_m1*tau1;
            const double cos_omega3_tau1_by_m1 = -sin_omega3_tau1*t189;
            const double sin_omega3_tau1_by_m1 = cos_omega3_tau1*t189;
            const double t190 = omega4_by_m1*tau1;
            const double cos_omega4_tau1_by_m1 = -sin_omega4_tau1*t190;
            const double sin_omega4_tau1_by_m1 = cos_omega4_tau1*t190;
            /* d/dm2 of: functions of tau1 in free */
            const double t191 = omega3_by_m2*tau1;
            const double cos_omega3_tau1_by_m2 = -sin_omega3_tau1*t191;
            const double sin_omega3_tau1_by_m2 = cos_omega3_tau1*t191;
            const double t192 = omega4_by_m2*tau1;
            const double cos_omega4_tau1_by_m2 = -sin_omega4_tau1*t192;
            const double sin_omega4_tau1_by_m2 = cos_omega4_tau1*t192;
            /* d/dk1 of: functions of tau1 in free */
            const double t193 = omega3_by_k1*tau1;
            const double cos_omega3_tau1_by_k1 = -sin_omega3_tau1*t193;
            const double sin_omega3_tau1_by_k1 = cos_omega3_tau1*t193;
            const double t194 = omega4_by_k1*tau1;
            const double cos_omega4_tau1_by_k1 = -sin_omega4_tau1*t194;
            const double sin_omega4_tau1_by_k1 = cos_omega4_tau1*t194;
            /* d/dk2 of: functions of tau1 in free */
            const double t195 = omega3_by_k2*tau1;
            const double cos_omega3_tau1_by_k2 = -sin_omega3_tau1*t195;
            const double sin_omega3_tau1_by_k2 = cos_omega3_tau1*t195;
            const double t196 = omega4_by_k2*tau1;
            const double cos_omega4_tau1_by_k2 = -sin_omega4_tau1*t196;
            const double sin_omega4_tau1_by_k2 = cos_omega4_tau1*t196;
            /* d/dk3 of: functions of tau1 in free */
            const double t197 = omega3_by_k3*tau1;
            const double cos_omega3_tau1_by_k3 = -sin_omega3_tau1*t197;
            const double sin_omega3_tau1_by_k3 = cos_omega3_tau1*t197;
            const double t198 = omega4_by_k3*tau1;
            const double cos_omega4_tau1_by_k3 = -sin_omega4_tau1*t198;
            const double sin_omega4_tau1_by_k3 = cos_omega4_tau1*t198;
            /* d/dT of: functions of tau1 in free */
            const double cos_omega3_tau1_by_T = -cos_omega3_tau1_by_tau;
            const double sin_omega3_tau1_by_T = t186;
            const double cos_omega4_tau1_by_T = -cos_omega4_tau1_by_tau;
            const double sin_omega4_tau1_by_T = t188;
            /* d/dy of: free for tau1, until first-reaches-stop */
            const double x1_2_by_y = t58*v1_1_by_y + t59*v2_1_by_y + t60*x1_1_by_y + t61*x2_1_by_y;
            const double x2_2_by_y = t62*v1_1_by_y + t63*v2_1_by_y + t64*x1_1_by_y + t65*x2_1_by_y;
            const double v1_2_by_y = t60*v1_1_by_y + t61*v2_1_by_y + t68*x1_1_by_y + t69*x2_1_by_y;
            const double v2_2_by_y = t64*v1_1_by_y + t65*v2_1_by_y + t70*x1_1_by_y + t71*x2_1_by_y;
            /* d/du of: free for tau1, until first-reaches-stop */
            const double x1_2_by_u = t58*v1_1_by_u + t59*v2_1_by_u + t60*x1_1_by_u + t61*x2_1_by_u;
            const double x2_2_by_u = t62*v1_1_by_u + t63*v2_1_by_u + t64*x1_1_by_u + t65*x2_1_by_u;
            const double v1_2_by_u = t60*v1_1_by_u + t61*v2_1_by_u + t68*x1_1_by_u + t69*x2_1_by_u;
            const double v2_2_by_u = t64*v1_1_by_u + t65*v2_1_by_u + t70*x1_1_by_u + t71*x2_1_by_u;
            /* d/dw of: free for tau1, until first-reaches-stop */
            const double x1_2_by_w = t58*v1_1_by_w + t59*v2_1_by_w + t60*x1_1_by_w + t61*x2_1_by_w;
            const double x2_2_by_w = t62*v1_1_by_w + t63*v2_1_by_w + t64*x1_1_by_w + t65*x2_1_by_w;
            const double v1_2_by_w = t60*v1_1_by_w + t61*v2_1_by_w + t68*x1_1_by_w + t69*x2_1_by_w;
            const double v2_2_by_w = t64*v1_1_by_w + t65*v2_1_by_w + t70*x1_1_by_w + t71*x2_1_by_w;
            /* d/dtau of: free for tau1, until first-reaches-stop */
            const double t199 = p4*x1_1;
            const double t200 = p5*x2_1;
            const double t201 = t199 + t200;
            const double t202 = -t200 + t55*x1_1;
            const double t203 = p4*v1_1;
            const double t204 = p5*v2_1;
            const double t205 = t203*t53 + t204*t53;
            const double t206 = -t204*t56 + t55*t56*v1_1;
            const double x1_2_by_tau = cos_omega3_tau1_by_tau*t201 + cos_omega4_tau1_by_tau*t202 + sin_omega3_tau1_by_tau*t205 + sin_omega4_tau1_by_tau*t206 + t58*v1_1_by_tau + t59*v2_1_by_tau + t60*x1_1_by_tau + t61*x2_1_by_tau;
            const double t207 = p6*x1_1;
            const double t208 = t55*x2_1;
            const double t209 = t207 + t208;
            const double t210 = p4*x2_1;
            const double t211 = -t207 + t210;
            const double t212 = p6*v1_1;
            const double t213 = t55*v2_1;
            const double t214 = t212*t53 + t213*t53;
            const double t215 = p4*v2_1;
            const double t216 = -t212*t56 + t215*t56;
            const double x2_2_by_tau = cos_omega3_tau1_by_tau*t209 + cos_omega4_tau1_by_tau*t211 + sin_omega3_tau1_by_tau*t214 + sin_omega4_tau1_by_tau*t216 + t62*v1_1_by_tau + t63*v2_1_by_tau + t64*x1_1_by_tau + t65*x2_1_by_tau;
            const double t217 = t203 + t204;
            const double t218 = -t204 + t55*v1_1;
            const double t219 = -omega3*t199 - omega3*t200;
            const double t220 = t55*x1_1;
            const double t221 = omega4*t200 - omega4*t220;
            const double v1_2_by_tau = cos_omega3_tau1_by_tau*t217 + cos_omega4_tau1_by_tau*t218 + sin_omega3_tau1_by_tau*t219 + sin_omega4_tau1_by_tau*t221 + t60*v1_1_by_tau + t61*v2_1_by_tau + t68*x1_1_by_tau + t69*x2_1_by_tau;
            const double t222 = t212 + t213;
            const double t223 = -t212 + t215;
            const double t224 = -omega3*t207 - omega3*t208;
            const double t225 = omega4*p6*x1_1 - omega4*t210;
            const double v2_2_by_tau = cos_omega3_tau1_by_tau*t222 + cos_omega4_tau1_by_tau*t223 + sin_omega3_tau1_by_tau*t224 + sin_omega4_tau1_by_tau*t225 + t64*v1_1_by_tau + t65*v2_1_by_tau + t70*x1_1_by_tau + t71*x2_1_by_tau;
            /* d/dm1 of: free for tau1, until first-reaches-stop */
            const double t226 = sin_omega3_tau1/(omega3*omega3);
            const double t227 = -t203*t226 - t204*t226;
            const double t228 = (1.0/(omega4*omega4));
            const double t229 = sin_omega4_tau1*t228;
            const double t230 = t204*t229 - t229*t55*v1_1;
            const double t231 = -sin_omega3_tau1*t53 + t57;
            const double t233 = cos_omega3_tau1 - cos_omega4_tau1;
            const double t234 = -t231*v1_1 + t233*x1_1;
            const double t235 = -t231*v2_1 + t233*x2_1;
            const double x1_2_by_m1 = cos_omega3_tau1_by_m1*t201 + cos_omega4_tau1_by_m1*t202 + omega3_by_m1*t227 + omega4_by_m1*t230 + p4_by_m1*t234 + p5_by_m1*t235 + sin_omega3_tau1_by_m1*t205 + sin_omega4_tau1_by_m1*t206 + t58*v1_1_by_m1 + t59*v2_1_by_m1 + t60*x1_1_by_m1 + t61*x2_1_by_m1;
            const double t236 = -t212*t226 - t213*t226;
            const double t237 = p6*sin_omega4_tau1*t228*v1_1 - t215*t229;
            const double t239 = t231*v2_1 - t233*x2_1;
            const double x2_2_by_m1 = cos_omega3_tau1_by_m1*t209 + cos_omega4_tau1_by_m1*t211 + omega3_by_m1*t236 + omega4_by_m1*t237 + p4_by_m1*t239 + p6_by_m1*t234 + sin_omega3_tau1_by_m1*t214 + sin_omega4_tau1_by_m1*t216 + t62*v1_1_by_m1 + t63*v2_1_by_m1 + t64*x1_1_by_m1 + t65*x2_1_by_m1;
            const double t240 = -sin_omega3_tau1*t199 - sin_omega3_tau1*t200;
            const double t241 = sin_omega4_tau1*t200 - sin_omega4_tau1*t220;
            const double t242 = -omega4*sin_omega4_tau1 + t66;
            const double t244 = t233*v1_1 - t242*x1_1;
            const double t245 = t233*v2_1 - t242*x2_1;
            const double v1_2_by_m1 = cos_omega3_tau1_by_m1*t217 + cos_omega4_tau1_by_m1*t218 + omega3_by_m1*t240 + omega4_by_m1*t241 + p4_by_m1*t244 + p5_by_m1*t245 + sin_omega3_tau1_by_m1*t219 + sin_omega4_tau1_by_m1*t221 + t60*v1_1_by_m1 + t61*v2_1_by_m1 + t68*x1_1_by_m1 + t69*x2_1_by_m1;
            const double t246 = -sin_omega3_tau1*t207 - sin_omega3_tau1*t208;
            const double t247 = p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t210;
            const double t248 = -t233*v2_1 + t242*x2_1;
            const double v2_2_by_m1 = cos_omega3_tau1_by_m1*t222 + cos_omega4_tau1_by_m1*t223 + omega3_by_m1*t246 + omega4_by_m1*t247 + p4_by_m1*t248 + p6_by_m1*t244 + sin_omega3_tau1_by_m1*t224 + sin_omega4_tau1_by_m1*t225 + t64*v1_1_by_m1 + t65*v2_1_by_m1 + t70*x1_1_by_m1 + t71*x2_1_by_m1;
            /* d/dm2 of: free for tau1, until first-reaches-stop */
            const double x1_2_by_m2 = cos_omega3_tau1_by_m2*t201 + cos_omega4_tau1_by_m2*t202 + omega3_by_m2*t227 + omega4_by_m2*t230 + p4_by_m2*t234 + p5_by_m2*t235 + sin_omega3_tau1_by_m2*t205 + sin_omega4_tau1_by_m2*t206 + t58*v1_1_by_m2 + t59*v2_1_by_m2 + t60*x1_1_by_m2 + t61*x2_1_by_m2;
            const double x2_2_by_m2 = cos_omega3_tau1_by_m2*t209 + cos_omega4_tau1_by_m2*t211 + omega3_by_m2*t236 + omega4_by_m2*t237 + p4_by_m2*t239 + p6_by_m2*t234 + sin_omega3_tau1_by_m2*t214 + sin_omega4_tau1_by_m2*t216 + t62*v1_1_by_m2 + t63*v2_1_by_m2 + t64*x1_1_by_m2 + t65*x2_1_by_m2;
            const double v1_2_by_m2 = cos_omega3_tau1_by_m2*t217 + cos_omega4_tau1_by_m2*t218 + omega3_by_m2*t240 + omega4_by_m2*t241 + p4_by_m2*t244 + p5_by_m2*t245 + sin_omega3_tau1_by_m2*t219 + sin_omega4_tau1_by_m2*t221 + t60*v1_1_by_m2 + t61*v2_1_by_m2 + t68*x1_1_by_m2 + t69*x2_1_by_m2;
            const double v2_2_by_m2 = cos_omega3_tau1_by_m2*t222 + cos_omega4_tau1_by_m2*t223 + omega3_by_m2*t246 + omega4_by_m2*t247 + p4_by_m2*t248 + p6_by_m2*t244 + sin_omega3_tau1_by_m2*t224 + sin_omega4_tau1_by_m2*t225 + t64*v1_1_by_m2 + t65*v2_1_by_m2 + t70*x1_1_by_m2 + t71*x2_1_by_m2;
            /* d/dk1 of: free for tau1, until first-reaches-stop */
            const double x1_2_by_k1 = cos_omega3_tau1_by_k1*t201 + cos_omega4_tau1_by_k1*t202 + omega3_by_k1*t227 + omega4_by_k1*t230 + p4_by_k1*t234 + p5_by_k1*t235 + sin_omega3_tau1_by_k1*t205 + sin_omega4_tau1_by_k1*t206 + t58*v1_1_by_k1 + t59*v2_1_by_k1 + t60*x1_1_by_k1 + t61*x2_1_by_k1;
            const double x2_2_by_k1 = cos_omega3_tau1_by_k1*t209 + cos_omega4_tau1_by_k1*t211 + omega3_by_k1*t236 + omega4_by_k1*t237 + p4_by_k1*t239 + p6_by_k1*t234 + sin_omega3_tau1_by_k1*t214 + sin_omega4_tau1_by_k1*t216 + t62*v1_1_by_k1 + t63*v2_1_by_k1 + t64*x1_1_by_k1 + t65*x2_1_by_k1;
            const double v1_2_by_k1 = cos_omega3_tau1_by_k1*t217 + cos_omega4_tau1_by_k1*t218 + omega3_by_k1*t240 + omega4_by_k1*t241 + p4_by_k1*t244 + p5_by_k1*t245 + sin_omega3_tau1_by_k1*t219 + sin_omega4_tau1_by_k1*t221 + t60*v1_1_by_k1 + t61*v2_1_by_k1 + t68*x1_1_by_k1 + t69*x2_1_by_k1;
            const double v2_2_by_k1 = cos_omega3_tau1_by_k1*t222 + cos_omega4_tau1_by_k1*t223 + omega3_by_k1*t246 + omega4_by_k1*t247 + p4_by_k1*t248 + p6_by_k1*t244 + sin_omega3_tau1_by_k1*t224 + sin_omega4_tau1_by_k1*t225 + t64*v1_1_by_k1 + t65*v2_1_by_k1 + t70*x1_1_by_k1 + t71*x2_1_by_k1;
            /* d/dk2 of: free for tau1, until first-reaches-stop */
            const double x1_2_by_k2 = cos_omega3_tau1_by_k2*t201 + cos_omega4_tau1_by_k2*t202 + omega3_by_k2*t227 + omega4_by_k2*t230 + p4_by_k2*t234 + p5_by_k2*t235 + sin_omega3_tau1_by_k2*t205 + sin_omega4_tau1_by_k2*t206 + t58*v1_1_by_k2 + t59*v2_1_by_k2 + t60*x1_1_by_k2 + t61*x2_1_by_k2;
            const double x2_2_by_k2 = cos_omega3_tau1_by_k2*t209 + cos_omega4_tau1_by_k2*t211 + omega3_by_k2*t236 + omega4_by_k2*t237 + p4_by_k2*t239 + p6_by_k2*t234 + sin_omega3_tau1_by_k2*t214 + sin_omega4_tau1_by_k2*t216 + t62*v1_1_by_k2 + t63*v2_1_by_k2 + t64*x1_1_by_k2 + t65*x2_1_by_k2;
            const double v1_2_by_k2 = cos_omega3_tau1_by_k2*t217 + cos_omega4_tau1_by_k2*t218 + omega3_by_k2*t240 + omega4_by_k2*t241 + p4_by_k2*t244 + p5_by_k2*t245 + sin_omega3_tau1_by_k2*t219 + sin_omega4_tau1_by_k2*t221 + t60*v1_1_by_k2 + t61*v2_1_by_k2 + t68*x1_1_by_k2 + t69*x2_1_by_k2;
            const double v2_2_by_k2 = cos_omega3_tau1_by_k2*t222 + cos_omega4_tau1_by_k2*t223 + omega3_by_k2*t246 + omega4_by_k2*t247 + p4_by_k2*t248 + p6_by_k2*t244 + sin_omega3_tau1_by_k2*t224 + sin_omega4_tau1_by_k2*t225 + t64*v1_1_by_k2 + t65*v2_1_by_k2 + t70*x1_1_by_k2 + t71*x2_1_by_k2;
            /* d/dk3 of: free for tau1, until first-reaches-stop */
            const double x1_2_by_k3 = cos_omega3_tau1_by_k3*t201 + cos_omega4_tau1_by_k3*t202 + omega3_by_k3*t227 + omega4_by_k3*t230 + p4_by_k3*t234 + p5_by_k3*t235 + sin_omega3_tau1_by_k3*t205 + sin_omega4_tau1_by_k3*t206 + t58*v1_1_by_k3 + t59*v2_1_by_k3 + t60*x1_1_by_k3 + t61*x2_1_by_k3;
            const double x2_2_by_k3 = cos_omega3_tau1_by_k3*t209 + cos_omega4_tau1_by_k3*t211 + omega3_by_k3*t236 + omega4_by_k3*t237 + p4_by_k3*t239 + p6_by_k3*t234 + sin_omega3_tau1_by_k3*t214 + sin_omega4_tau1_by_k3*t216 + t62*v1_1_by_k3 + t63*v2_1_by_k3 + t64*x1_1_by_k3 + t65*x2_1_by_k3;
            const double v1_2_by_k3 = cos_omega3_tau1_by_k3*t217 + cos_omega4_tau1_by_k3*t218 + omega3_by_k3*t240 + omega4_by_k3*t241 + p4_by_k3*t244 + p5_by_k3*t245 + sin_omega3_tau1_by_k3*t219 + sin_omega4_tau1_by_k3*t221 + t60*v1_1_by_k3 + t61*v2_1_by_k3 + t68*x1_1_by_k3 + t69*x2_1_by_k3;
            const double v2_2_by_k3 = cos_omega3_tau1_by_k3*t222 + cos_omega4_tau1_by_k3*t223 + omega3_by_k3*t246 + omega4_by_k3*t247 + p4_by_k3*t248 + p6_by_k3*t244 + sin_omega3_tau1_by_k3*t224 + sin_omega4_tau1_by_k3*t225 + t64*v1_1_by_k3 + t65*v2_1_by_k3 + t70*x1_1_by_k3 + t71*x2_1_by_k3;
            /* d/dT of: free for tau1, until first-reaches-stop */
            const double x1_2_by_T = cos_omega3_tau1_by_T*t201 + cos_omega4_tau1_by_T*t202 + sin_omega3_tau1_by_T*t205 + sin_omega4_tau1_by_T*t206;
            const double x2_2_by_T = cos_omega3_tau1_by_T*t209 + cos_omega4_tau1_by_T*t211 + sin_omega3_tau1_by_T*t214 + sin_omega4_tau1_by_T*t216;
            const double v1_2_by_T = cos_omega3_tau1_by_T*t217 + cos_omega4_tau1_by_T*t218 + sin_omega3_tau1_by_T*t219 + sin_omega4_tau1_by_T*t221;
            const double v2_2_by_T = cos_omega3_tau1_by_T*t222 + cos_omega4_tau1_by_T*t223 + sin_omega3_tau1_by_T*t224 + sin_omega4_tau1_by_T*t225;
            /* d/dtau of: Phi along tau */
            const double carried_x1_1_by_y_by_tau = cos_omega1_tau_by_tau*p2 - cos_omega2_tau_by_tau*p2;
            const double t250 = sin_omega1_tau_by_tau*t16;
            const double t251 = sin_omega2_tau_by_tau*t19;
            const double carried_x1_1_by_u_by_tau = p1*t250 - t14*t251;
            const double carried_x1_1_by_w_by_tau = p2*sin_omega1_tau_by_tau*t16 - p2*t251;
            const double carried_x2_1_by_y_by_tau = -cos_omega1_tau_by_tau*t14 + cos_omega2_tau_by_tau*p1;
            const double carried_x2_1_by_u_by_tau = p3*sin_omega1_tau_by_tau*t16 - p3*t251;
            const double carried_x2_1_by_w_by_tau = p1*t251 - t14*t250;
            const double t253 = omega1*sin_omega1_tau_by_tau;
            const double carried_v1_1_by_y_by_tau = omega2*p2*sin_omega2_tau_by_tau - p2*t253;
            const double carried_v1_1_by_u_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t14;
            const double carried_v1_1_by_w_by_tau = carried_x1_1_by_y_by_tau;
            const double carried_v2_1_by_y_by_tau = -omega2*p1*sin_omega2_tau_by_tau + t14*t253;
            const double carried_v2_1_by_u_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3;
            const double carried_v2_1_by_w_by_tau = carried_x2_1_by_y_by_tau;
            /* d/dm1 of: Phi along tau */
            const double carried_x1_1_by_y_by_m1 = cos_omega1_tau_by_m1*p2 - cos_omega2_tau_by_m1*p2 + p2_by_m1*t126;
            const double t255 = sin_omega1_tau_by_m1*t16;
            const double t256 = sin_omega2_tau_by_m1*t19;
            const double t257 = omega1_by_m1*t118;
            const double t258 = omega2_by_m1*t121;
            const double carried_x1_1_by_u_by_m1 = p1*t255 - p1_by_m1*t124 - t135*t257 - t137*t258 - t14*t256;
            const double t259 = omega2_by_m1*sin_omega2_tau;
            const double t260 = p2*t259;
            const double t261 = omega1_by_m1*sin_omega1_tau;
            const double t262 = p2*t261;
            const double carried_x1_1_by_w_by_m1 = p2*t255 - p2*t256 - p2_by_m1*t124 - t118*t262 + t121*t260;
            const double carried_x2_1_by_y_by_m1 = -cos_omega1_tau_by_m1*t14 + cos_omega2_tau_by_m1*p1 - p1_by_m1*t126;
            const double carried_x2_1_by_u_by_m1 = p3*t255 - p3*t256 - p3_by_m1*t124 - t145*t257 + t147*t258;
            const double t264 = -t14*t261;
            const double t265 = p1*t259;
            const double carried_x2_1_by_w_by_m1 = p1*t256 + p1_by_m1*t124 - t118*t264 - t121*t265 - t14*t255;
            const double t266 = omega2*sin_omega2_tau_by_m1;
            const double t267 = omega1*sin_omega1_tau_by_m1;
            const double carried_v1_1_by_y_by_m1 = p2*t266 - p2*t267 - p2_by_m1*t140 + t260 - t262;
            const double carried_v1_1_by_u_by_m1 = cos_omega1_tau_by_m1*p1 - cos_omega2_tau_by_m1*t14 + p1_by_m1*t126;
            const double carried_v1_1_by_w_by_m1 = carried_x1_1_by_y_by_m1;
            const double carried_v2_1_by_y_by_m1 = -p1*t266 + p1_by_m1*t140 + t14*t267 - t264 - t265;
            const double carried_v2_1_by_u_by_m1 = cos_omega1_tau_by_m1*p3 - cos_omega2_tau_by_m1*p3 + p3_by_m1*t126;
            const double carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1;
            /* d/dm2 of: Phi along tau */
            const double carried_x1_1_by_y_by_m2 = cos_omega1_tau_by_m2*p2 - cos_omega2_tau_by_m2*p2 + p2_by_m2*t126;
            const double t269 = sin_omega1_tau_by_m2*t16;
            const double t270 = sin_omega2_tau_by_m2*t19;
            const double t271 = omega1_by_m2*t118;
            const double t272 = omega2_by_m2*t121;
            const double carried_x1_1_by_u_by_m2 = p1*t269 - p1_by_m2*t124 - t135*t271 - t137*t272 - t14*t270;
            const double t273 = omega2_by_m2*sin_omega2_tau;
            const double t274 = p2*t273;
            const double t275 = omega1_by_m2*sin_omega1_tau;
            const double t276 = p2*t275;
            const double carried_x1_1_by_w_by_m2 = p2*t269 - p2*t270 - p2_by_m2*t124 - t118*t276 + t121*t274;
            const double carried_x2_1_by_y_by_m2 = -cos_omega1_tau_by_m2*t14 + cos_omega2_tau_by_m2*p1 - p1_by_m2*t126;
            const double carried_x2_1_by_u_by_m2 = p3*t269 - p3*t270 - p3_by_m2*t124 - t145*t271 + t147*t272;
            const double t278 = -t14*t275;
            const double t279 = p1*t273;
            const double carried_x2_1_by_w_by_m2 = p1*t270 + p1_by_m2*t124 - t118*t278 - t121*t279 - t14*t269;
            const double t280 = omega2*sin_omega2_tau_by_m2;
            const double t281 = omega1*sin_omega1_tau_by_m2;
            const double carried_v1_1_by_y_by_m2 = p2*t280 - p2*t281 - p2_by_m2*t140 + t274 - t276;
            const double carried_v1_1_by_u_by_m2 = cos_omega1_tau_by_m2*p1 - cos_omega2_tau_by_m2*t14 + p1_by_m2*t126;
            const double carried_v1_1_by_w_by_m2 = carried_x1_1_by_y_by_m2;
            const double carried_v2_1_by_y_by_m2 = -p1*t280 + p1_by_m2*t140 + t14*t281 - t278 - t279;
            const double carried_v2_1_by_u_by_m2 = cos_omega1_tau_by_m2*p3 - cos_omega2_tau_by_m2*p3 + p3_by_m2*t126;
            const double carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2;
            /* d/dk1 of: Phi along tau */
            const double carried_x1_1_by_y_by_k1 = cos_omega1_tau_by_k1*p2 - cos_omega2_tau_by_k1*p2 + p2_by_k1*t126;
            const double t283 = sin_omega1_tau_by_k1*t16;
            const double t284 = sin_omega2_tau_by_k1*t19;
            const double t285 = omega1_by_k1*t118;
            const double t286 = omega2_by_k1*t121;
            const double carried_x1_1_by_u_by_k1 = p1*t283 - p1_by_k1*t124 - t135*t285 - t137*t286 - t14*t284;
            const double t287 = omega2_by_k1*sin_omega2_tau;
            const double t288 = p2*t287;
            const double t289 = omega1_by_k1*sin_omega1_tau;
            const double t290 = p2*t289;
            const double carried_x1_1_by_w_by_k1 = p2*t283 - p2*t284 - p2_by_k1*t124 - t118*t290 + t121*t288;
            const double carried_x2_1_by_y_by_k1 = -cos_omega1_tau_by_k1*t14 + cos_omega2_tau_by_k1*p1 - p1_by_k1*t126;
            const double carried_x2_1_by_u_by_k1 = p3*t283 - p3*t284 - p3_by_k1*t124 - t145*t285 + t147*t286;
            const double t292 = -t14*t289;
            const double t293 = p1*t287;
            const double carried_x2_1_by_w_by_k1 = p1*t284 + p1_by_k1*t124 - t118*t292 - t121*t293 - t14*t283;
            const double t294 = omega2*sin_omega2_tau_by_k1;
            const double t295 = omega1*sin_omega1_tau_by_k1;
            const double carried_v1_1_by_y_by_k1 = p2*t294 - p2*t295 - p2_by_k1*t140 + t288 - t290;
            const double carried_v1_1_by_u_by_k1 = cos_omega1_tau_by_k1*p1 - cos_omega2_tau_by_k1*t14 + p1_by_k1*t126;
            const double carried_v1_1_by_w_by_k1 = carried_x1_1_by_y_by_k1;
            const double carried_v2_1_by_y_by_k1 = -p1*t294 + p1_by_k1*t140 + t14*t295 - t292 - t293;
            const double carried_v2_1_by_u_by_k1 = cos_omega1_tau_by_k1*p3 - cos_omega2_tau_by_k1*p3 + p3_by_k1*t126;
            const double carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1;
            /* d/dk2 of: Phi along tau */
            const double carried_x1_1_by_y_by_k2 = cos_omega1_tau_by_k2*p2 - cos_omega2_tau_by_k2*p2 + p2_by_k2*t126;
            const double t297 = sin_omega1_tau_by_k2*t16;
            const double t298 = sin_omega2_tau_by_k2*t19;
            const double t299 = omega1_by_k2*t118;
            const double t300 = omega2_by_k2*t121;
            const double carried_x1_1_by_u_by_k2 = p1*t297 - p1_by_k2*t124 - t135*t299 - t137*t300 - t14*t298;
            const double t301 = omega2_by_k2*sin_omega2_tau;
            const double t302 = p2*t301;
            const double t303 = omega1_by_k2*sin_omega1_tau;
            const double t304 = p2*t303;
            const double carried_x1_1_by_w_by_k2 = p2*t297 - p2*t298 - p2_by_k2*t124 - t118*t304 + t121*t302;
            const double carried_x2_1_by_y_by_k2 = -cos_omega1_tau_by_k2*t14 + cos_omega2_tau_by_k2*p1 - p1_by_k2*t126;
            const double carried_x2_1_by_u_by_k2 = p3*t297 - p3*t298 - p3_by_k2*t124 - t145*t299 + t147*t300;
            const double t306 = -t14*t303;
            const double t307 = p1*t301;
            const double carried_x2_1_by_w_by_k2 = p1*t298 + p1_by_k2*t124 - t118*t306 - t121*t307 - t14*t297;
            const double t308 = omega2*sin_omega2_tau_by_k2;
            const double t309 = omega1*sin_omega1_tau_by_k2;
            const double carried_v1_1_by_y_by_k2 = p2*t308 - p2*t309 - p2_by_k2*t140 + t302 - t304;
            const double carried_v1_1_by_u_by_k2 = cos_omega1_tau_by_k2*p1 - cos_omega2_tau_by_k2*t14 + p1_by_k2*t126;
            const double carried_v1_1_by_w_by_k2 = carried_x1_1_by_y_by_k2;
            const double carried_v2_1_by_y_by_k2 = -p1*t308 + p1_by_k2*t140 + t14*t309 - t306 - t307;
            const double carried_v2_1_by_u_by_k2 = cos_omega1_tau_by_k2*p3 - cos_omega2_tau_by_k2*p3 + p3_by_k2*t126;
            const double carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2;
            /* d/dk3 of: Phi along tau */
            const double carried_x1_1_by_y_by_k3 = cos_omega1_tau_by_k3*p2 - cos_omega2_tau_by_k3*p2 + p2_by_k3*t126;
            const double t311 = sin_omega1_tau_by_k3*t16;
            const double t312 = sin_omega2_tau_by_k3*t19;
            const double t313 = omega1_by_k3*t118;
            const double t314 = omega2_by_k3*t121;
            const double carried_x1_1_by_u_by_k3 = p1*t311 - p1_by_k3*t124 - t135*t313 - t137*t314 - t14*t312;
            const double t315 = omega2_by_k3*sin_omega2_tau;
            const double t316 = p2*t315;
            const double t317 = omega1_by_k3*sin_omega1_tau;
            const double t318 = p2*t317;
            const double carried_x1_1_by_w_by_k3 = p2*t311 - p2*t312 - p2_by_k3*t124 - t118*t318 + t121*t316;
            const double carried_x2_1_by_y_by_k3 = -cos_omega1_tau_by_k3*t14 + cos_omega2_tau_by_k3*p1 - p1_by_k3*t126;
            const double carried_x2_1_by_u_by_k3 = p3*t311 - p3*t312 - p3_by_k3*t124 - t145*t313 + t147*t314;
            const double t320 = -t14*t317;
            const double t321 = p1*t315;
            const double carried_x2_1_by_w_by_k3 = p1*t312 + p1_by_k3*t124 - t118*t320 - t121*t321 - t14*t311;
            const double t322 = omega2*sin_omega2_tau_by_k3;
            const double t323 = omega1*sin_omega1_tau_by_k3;
            const double carried_v1_1_by_y_by_k3 = p2*t322 - p2*t323 - p2_by_k3*t140 + t316 - t318;
            const double carried_v1_1_by_u_by_k3 = cos_omega1_tau_by_k3*p1 - cos_omega2_tau_by_k3*t14 + p1_by_k3*t126;
            const double carried_v1_1_by_w_by_k3 = carried_x1_1_by_y_by_k3;
            const double carried_v2_1_by_y_by_k3 = -p1*t322 + p1_by_k3*t140 + t14*t323 - t320 - t321;
            const double carried_v2_1_by_u_by_k3 = cos_omega1_tau_by_k3*p3 - cos_omega2_tau_by_k3*p3 + p3_by_k3*t126;
            const double carried_v2_1_by_w_by_k3 = carried_x2_1_by_y_by_k3;
            /* d/dy of: rate of the exit boundary after tau */
            const double rate_1_by_y = -v1_1_by_y;
            /* d/du of: rate of the exit boundary after tau */
            const double rate_1_by_u = -v1_1_by_u;
            /* d/dw of: rate of the exit boundary after tau */
            const double rate_1_by_w = -v1_1_by_w;
            /* d/dtau of: rate of the exit boundary after tau */
            const double rate_1_by_tau = -v1_1_by_tau;
            /* d/dm1 of: rate of the exit boundary after tau */
            const double rate_1_by_m1 = -v1_1_by_m1;
            /* d/dm2 of: rate of the exit boundary after tau */
            const double rate_1_by_m2 = -v1_1_by_m2;
            /* d/dk1 of: rate of the exit boundary after tau */
            const double rate_1_by_k1 = -v1_1_by_k1;
            /* d/dk2 of: rate of the exit boundary after tau */
            const double rate_1_by_k2 = -v1_1_by_k2;
            /* d/dk3 of: rate of the exit boundary after tau */
            const double rate_1_by_k3 = -v1_1_by_k3;
            /* d/dy of: derivatives of the time to the boundary after tau */
            const double t324 = (1.0/(rate_1*rate_1));
            const double t325 = rate_1_by_y*t324;
            const double delay_tau_by_y_by_y = -carried_x1_1_by_y*t325;
            const double delay_tau_by_u_by_y = -carried_x1_1_by_u*t325;
            const double delay_tau_by_w_by_y = -carried_x1_1_by_w*t325;
            /* d/du of: derivatives of the time to the boundary after tau */
            const double t326 = rate_1_by_u*t324;
            const double delay_tau_by_y_by_u = -carried_x1_1_by_y*t326;
            const double delay_tau_by_u_by_u = -carried_x1_1_by_u*t326;
            const double delay_tau_by_w_by_u = -carried_x1_1_by_w*t326;
            /* d/dw of: derivatives of the time to the boundary after tau */
            const double t327 = rate_1_by_w*t324;
            const double delay_tau_by_y_by_w = -carried_x1_1_by_y*t327;
            const double delay_tau_by_u_by_w = -carried_x1_1_by_u*t327;
            const double delay_tau_by_w_by_w = -carried_x1_1_by_w*t327;
            /* d/dtau of: derivatives of the time to the boundary after tau */
            const double t328 = rate_1_by_tau*t324;
            const double delay_tau_by_y_by_tau = -carried_x1_1_by_y*t328 + carried_x1_1_by_y_by_tau*t72;
            const double delay_tau_by_u_by_tau = -carried_x1_1_by_u*t328 + carried_x1_1_by_u_by_tau*t72;
            const double delay_tau_by_w_by_tau = -carried_x1_1_by_w*t328 + carried_x1_1_by_w_by_tau*t72;
            /* d/dm1 of: derivatives of the time to the boundary after tau */
            const double t329 = rate_1_by_m1*t324;
            const double delay_tau_by_y_by_m1 = -carried_x1_1_by_y*t329 + carried_x1_1_by_y_by_m1*t72;
            const double delay_tau_by_u_by_m1 = -carried_x1_1_by_u*t329 + carried_x1_1_by_u_by_m1*t72;
            const double delay_tau_by_w_by_m1 = -carried_x1_1_by_w*t329 + carried_x1_1_by_w_by_m1*t72;
            /* d/dm2 of: derivatives of the time to the boundary after tau */
            const double t330 = rate_1_by_m2*t324;
            const double delay_tau_by_y_by_m2 = -carried_x1_1_by_y*t330 + carried_x1_1_by_y_by_m2*t72;
            const double delay_tau_by_u_by_m2 = -carried_x1_1_by_u*t330 + carried_x1_1_by_u_by_m2*t72;
            const double delay_tau_by_w_by_m2 = -carried_x1_1_by_w*t330 + carried_x1_1_by_w_by_m2*t72;
            /* d/dk1 of: derivatives of the time to the boundary after tau */
            const double t331 = rate_1_by_k1*t324;
            const double delay_tau_by_y_by_k1 = -carried_x1_1_by_y*t331 + carried_x1_1_by_y_by_k1*t72;
            const double delay_tau_by_u_by_k1 = -carried_x1_1_by_u*t331 + carried_x1_1_by_u_by_k1*t72;
            const double delay_tau_by_w_by_k1 = -carried_x1_1_by_w*t331 + carried_x1_1_by_w_by_k1*t72;
            /* d/dk2 of: derivatives of the time to the boundary after tau */
            const double t332 = rate_1_by_k2*t324;
            const double delay_tau_by_y_by_k2 = -carried_x1_1_by_y*t332 + carried_x1_1_by_y_by_k2*t72;
            const double delay_tau_by_u_by_k2 = -carried_x1_1_by_u*t332 + carried_x1_1_by_u_by_k2*t72;
            const double delay_tau_by_w_by_k2 = -carried_x1_1_by_w*t332 + carried_x1_1_by_w_by_k2*t72;
            /* d/dk3 of: derivatives of the time to the boundary after tau */
            const double t333 = rate_1_by_k3*t324;
            const double delay_tau_by_y_by_k3 = -carried_x1_1_by_y*t333 + carried_x1_1_by_y_by_k3*t72;
            const double delay_tau_by_u_by_k3 = -carried_x1_1_by_u*t333 + carried_x1_1_by_u_by_k3*t72;
            const double delay_tau_by_w_by_k3 = -carried_x1_1_by_w*t333 + carried_x1_1_by_w_by_k3*t72;
            /* d/dy of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_y = delay_tau_by_y*v1_1_by_y + delay_tau_by_y_by_y*v1_1;
            const double x1_1_on_boundary_by_u_by_y = delay_tau_by_u*v1_1_by_y + delay_tau_by_u_by_y*v1_1;
            const double x1_1_on_boundary_by_w_by_y = delay_tau_by_w*v1_1_by_y + delay_tau_by_w_by_y*v1_1;
            const double x2_1_on_boundary_by_y_by_y = delay_tau_by_y*v2_1_by_y + delay_tau_by_y_by_y*v2_1;
            const double x2_1_on_boundary_by_u_by_y = delay_tau_by_u*v2_1_by_y + delay_tau_by_u_by_y*v2_1;
            const double x2_1_on_boundary_by_w_by_y = delay_tau_by_w*v2_1_by_y + delay_tau_by_w_by_y*v2_1;
            const double t334 = delay_tau_by_y*t73;
            const double t335 = k1*x2_1_by_y;
            const double t336 = t74*x1_1_by_y;
            const double v1_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t76 + t334*t335 - t334*t336;
            const double t337 = delay_tau_by_u*t73;
            const double v1_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t76 + t335*t337 - t336*t337;
            const double t338 = delay_tau_by_w*t73;
            const double v1_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t76 + t335*t338 - t336*t338;
            const double t339 = delay_tau_by_y*t77;
            const double t340 = k1*x1_1_by_y;
            const double t341 = t79*x2_1_by_y;
            const double v2_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t81 + t339*t340 - t339*t341;
            const double t342 = delay_tau_by_u*t77;
            const double v2_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t81 + t340*t342 - t341*t342;
            const double t343 = delay_tau_by_w*t77;
            const double v2_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t81 + t340*t343 - t341*t343;
            /* d/du of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_u = delay_tau_by_y*v1_1_by_u + delay_tau_by_y_by_u*v1_1;
            const double x1_1_on_boundary_by_u_by_u = delay_tau_by_u*v1_1_by_u + delay_tau_by_u_by_u*v1_1;
            const double x1_1_on_boundary_by_w_by_u = delay_tau_by_w*v1_1_by_u + delay_tau_by_w_by_u*v1_1;
            const double x2_1_on_boundary_by_y_by_u = delay_tau_by_y*v2_1_by_u + delay_tau_by_y_by_u*v2_1;
            const double x2_1_on_boundary_by_u_by_u = delay_tau_by_u*v2_1_by_u + delay_tau_by_u_by_u*v2_1;
            const double x2_1_on_boundary_by_w_by_u = delay_tau_by_w*v2_1_by_u + delay_tau_by_w_by_u*v2_1;
            const double t344 = k1*x2_1_by_u;
            const double t345 = t74*x1_1_by_u;
            const double v1_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t76 + t334*t344 - t334*t345;
            const double v1_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t76 + t337*t344 - t337*t345;
            const double v1_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t76 + t338*t344 - t338*t345;
            const double t346 = k1*x1_1_by_u;
            const double t347 = t79*x2_1_by_u;
            const double v2_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t81 + t339*t346 - t339*t347;
            const double v2_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t81 + t342*t346 - t342*t347;
            const double v2_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t81 + t343*t346 - t343*t347;
            /* d/dw of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_w = delay_tau_by_y*v1_1_by_w + delay_tau_by_y_by_w*v1_1;
            const double x1_1_on_boundary_by_u_by_w = delay_tau_by_u*v1_1_by_w + delay_tau_by_u_by_w*v1_1;
            const double x1_1_on_boundary_by_w_by_w = delay_tau_by_w*v1_1_by_w + delay_tau_by_w_by_w*v1_1;
            const double x2_1_on_boundary_by_y_by_w = delay_tau_by_y*v2_1_by_w + delay_tau_by_y_by_w*v2_1;
            const double x2_1_on_boundary_by_u_by_w = delay_tau_by_u*v2_1_by_w + delay_tau_by_u_by_w*v2_1;
            const double x2_1_on_boundary_by_w_by_w = delay_tau_by_w*v2_1_by_w + delay_tau_by_w_by_w*v2_1;
            const double t348 = k1*x2_1_by_w;
            const double t349 = t74*x1_1_by_w;
            const double v1_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t76 + t334*t348 - t334*t349;
            const double v1_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t76 + t337*t348 - t337*t349;
            const double v1_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t76 + t338*t348 - t338*t349;
            const double t350 = k1*x1_1_by_w;
            const double t351 = t79*x2_1_by_w;
            const double v2_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t81 + t339*t350 - t339*t351;
            const double v2_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t81 + t342*t350 - t342*t351;
            const double v2_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t81 + t343*t350 - t343*t351;
            /* d/dtau of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_tau = carried_x1_1_by_y_by_tau + delay_tau_by_y*v1_1_by_tau + delay_tau_by_y_by_tau*v1_1;
            const double x1_1_on_boundary_by_u_by_tau = carried_x1_1_by_u_by_tau + delay_tau_by_u*v1_1_by_tau + delay_tau_by_u_by_tau*v1_1;
            const double x1_1_on_boundary_by_w_by_tau = carried_x1_1_by_w_by_tau + delay_tau_by_w*v1_1_by_tau + delay_tau_by_w_by_tau*v1_1;
            const double x2_1_on_boundary_by_y_by_tau = carried_x2_1_by_y_by_tau + delay_tau_by_y*v2_1_by_tau + delay_tau_by_y_by_tau*v2_1;
            const double x2_1_on_boundary_by_u_by_tau = carried_x2_1_by_u_by_tau + delay_tau_by_u*v2_1_by_tau + delay_tau_by_u_by_tau*v2_1;
            const double x2_1_on_boundary_by_w_by_tau = carried_x2_1_by_w_by_tau + delay_tau_by_w*v2_1_by_tau + delay_tau_by_w_by_tau*v2_1;
            const double t352 = k1*x2_1_by_tau;
            const double t353 = t74*x1_1_by_tau;
            const double v1_1_on_boundary_by_y_by_tau = carried_v1_1_by_y_by_tau + delay_tau_by_y_by_tau*t76 + t334*t352 - t334*t353;
            const double v1_1_on_boundary_by_u_by_tau = carried_v1_1_by_u_by_tau + delay_tau_by_u_by_tau*t76 + t337*t352 - t337*t353;
            const double v1_1_on_boundary_by_w_by_tau = carried_v1_1_by_w_by_tau + delay_tau_by_w_by_tau*t76 + t338*t352 - t338*t353;
            const double t354 = k1*x1_1_by_tau;
            const double t355 = t79*x2_1_by_tau;
            const double v2_1_on_boundary_by_y_by_tau = carried_v2_1_by_y_by_tau + delay_tau_by_y_by_tau*t81 + t339*t354 - t339*t355;
            const double v2_1_on_boundary_by_u_by_tau = carried_v2_1_by_u_by_tau + delay_tau_by_u_by_tau*t81 + t342*t354 - t342*t355;
            const double v2_1_on_boundary_by_w_by_tau = carried_v2_1_by_w_by_tau + delay_tau_by_w_by_tau*t81 + t343*t354 - t343*t355;
            /* d/dm1 of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_m1 = carried_x1_1_by_y_by_m1 + delay_tau_by_y*v1_1_by_m1 + delay_tau_by_y_by_m1*v1_1;
            const double x1_1_on_boundary_by_u_by_m1 = carried_x1_1_by_u_by_m1 + delay_tau_by_u*v1_1_by_m1 + delay_tau_by_u_by_m1*v1_1;
            const double x1_1_on_boundary_by_w_by_m1 = carried_x1_1_by_w_by_m1 + delay_tau_by_w*v1_1_by_m1 + delay_tau_by_w_by_m1*v1_1;
            const double x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_tau_by_y*v2_1_by_m1 + delay_tau_by_y_by_m1*v2_1;
            const double x2_1_on_boundary_by_u_by_m1 = carried_x2_1_by_u_by_m1 + delay_tau_by_u*v2_1_by_m1 + delay_tau_by_u_by_m1*v2_1;
            const double x2_1_on_boundary_by_w_by_m1 = carried_x2_1_by_w_by_m1 + delay_tau_by_w*v2_1_by_m1 + delay_tau_by_w_by_m1*v2_1;
            const double t356 = (1.0/(m1*m1));
            const double t357 = k1*t356;
            const double t358 = -k3*t356 + t356*t74*x1_1 - t357*x2_1;
            const double t359 = k1*x2_1_by_m1;
            const double t360 = t74*x1_1_by_m1;
            const double v1_1_on_boundary_by_y_by_m1 = carried_v1_1_by_y_by_m1 + delay_tau_by_y*t358 + delay_tau_by_y_by_m1*t76 + t334*t359 - t334*t360;
            const double v1_1_on_boundary_by_u_by_m1 = carried_v1_1_by_u_by_m1 + delay_tau_by_u*t358 + delay_tau_by_u_by_m1*t76 + t337*t359 - t337*t360;
            const double v1_1_on_boundary_by_w_by_m1 = carried_v1_1_by_w_by_m1 + delay_tau_by_w*t358 + delay_tau_by_w_by_m1*t76 + t338*t359 - t338*t360;
            const double t361 = k1*x1_1_by_m1;
            const double t362 = t79*x2_1_by_m1;
            const double v2_1_on_boundary_by_y_by_m1 = carried_v2_1_by_y_by_m1 + delay_tau_by_y_by_m1*t81 + t339*t361 - t339*t362;
            const double v2_1_on_boundary_by_u_by_m1 = carried_v2_1_by_u_by_m1 + delay_tau_by_u_by_m1*t81 + t342*t361 - t342*t362;
            const double v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_tau_by_w_by_m1*t81 + t343*t361 - t343*t362;
            /* d/dm2 of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_m2 = carried_x1_1_by_y_by_m2 + delay_tau_by_y*v1_1_by_m2 + delay_tau_by_y_by_m2*v1_1;
            const double x1_1_on_boundary_by_u_by_m2 = carried_x1_1_by_u_by_m2 + delay_tau_by_u*v1_1_by_m2 + delay_tau_by_u_by_m2*v1_1;
            const double x1_1_on_boundary_by_w_by_m2 = carried_x1_1_by_w_by_m2 + delay_tau_by_w*v1_1_by_m2 + delay_tau_by_w_by_m2*v1_1;
            const double x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_tau_by_y*v2_1_by_m2 + delay_tau_by_y_by_m2*v2_1;
            const double x2_1_on_boundary_by_u_by_m2 = carried_x2_1_by_u_by_m2 + delay_tau_by_u*v2_1_by_m2 + delay_tau_by_u_by_m2*v2_1;
            const double x2_1_on_boundary_by_w_by_m2 = carried_x2_1_by_w_by_m2 + delay_tau_by_w*v2_1_by_m2 + delay_tau_by_w_by_m2*v2_1;
            const double t363 = k1*x2_1_by_m2;
            const double t364 = t74*x1_1_by_m2;
            const double v1_1_on_boundary_by_y_by_m2 = carried_v1_1_by_y_by_m2 + delay_tau_by_y_by_m2*t76 + t334*t363 - t334*t364;
            const double v1_1_on_boundary_by_u_by_m2 = carried_v1_1_by_u_by_m2 + delay_tau_by_u_by_m2*t76 + t337*t363 - t337*t364;
            const double v1_1_on_boundary_by_w_by_m2 = carried_v1_1_by_w_by_m2 + delay_tau_by_w_by_m2*t76 + t338*t363 - t338*t364;
            const double t365 = (1.0/(m2*m2));
            const double t366 = k1*t365;
            const double t367 = t365*t79*x2_1 - t366*x1_1;
            const double t368 = k1*x1_1_by_m2;
            const double t369 = t79*x2_1_by_m2;
            const double v2_1_on_boundary_by_y_by_m2 = carried_v2_1_by_y_by_m2 + delay_tau_by_y*t367 + delay_tau_by_y_by_m2*t81 + t339*t368 - t339*t369;
            const double v2_1_on_boundary_by_u_by_m2 = carried_v2_1_by_u_by_m2 + delay_tau_by_u*t367 + delay_tau_by_u_by_m2*t81 + t342*t368 - t342*t369;
            const double v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_tau_by_w*t367 + delay_tau_by_w_by_m2*t81 + t343*t368 - t343*t369;
            /* d/dk1 of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_k1 = carried_x1_1_by_y_by_k1 + delay_tau_by_y*v1_1_by_k1 + delay_tau_by_y_by_k1*v1_1;
            const double x1_1_on_boundary_by_u_by_k1 = carried_x1_1_by_u_by_k1 + delay_tau_by_u*v1_1_by_k1 + delay_tau_by_u_by_k1*v1_1;
            const double x1_1_on_boundary_by_w_by_k1 = carried_x1_1_by_w_by_k1 + delay_tau_by_w*v1_1_by_k1 + delay_tau_by_w_by_k1*v1_1;
            const double x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_tau_by_y*v2_1_by_k1 + delay_tau_by_y_by_k1*v2_1;
            const double x2_1_on_boundary_by_u_by_k1 = carried_x2_1_by_u_by_k1 + delay_tau_by_u*v2_1_by_k1 + delay_tau_by_u_by_k1*v2_1;
            const double x2_1_on_boundary_by_w_by_k1 = carried_x2_1_by_w_by_k1 + delay_tau_by_w*v2_1_by_k1 + delay_tau_by_w_by_k1*v2_1;
            const double t370 = t73*x2_1 - t75;
            const double t371 = k1*x2_1_by_k1;
            const double t372 = t74*x1_1_by_k1;
            const double v1_1_on_boundary_by_y_by_k1 = carried_v1_1_by_y_by_k1 + delay_tau_by_y*t370 + delay_tau_by_y_by_k1*t76 + t334*t371 - t334*t372;
            const double v1_1_on_boundary_by_u_by_k1 = carried_v1_1_by_u_by_k1 + delay_tau_by_u*t370 + delay_tau_by_u_by_k1*t76 + t337*t371 - t337*t372;
            const double v1_1_on_boundary_by_w_by_k1 = carried_v1_1_by_w_by_k1 + delay_tau_by_w*t370 + delay_tau_by_w_by_k1*t76 + t338*t371 - t338*t372;
            const double t373 = t78 - t80;
            const double t374 = k1*x1_1_by_k1;
            const double t375 = t79*x2_1_by_k1;
            const double v2_1_on_boundary_by_y_by_k1 = carried_v2_1_by_y_by_k1 + delay_tau_by_y*t373 + delay_tau_by_y_by_k1*t81 + t339*t374 - t339*t375;
            const double v2_1_on_boundary_by_u_by_k1 = carried_v2_1_by_u_by_k1 + delay_tau_by_u*t373 + delay_tau_by_u_by_k1*t81 + t342*t374 - t342*t375;
            const double v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_tau_by_w*t373 + delay_tau_by_w_by_k1*t81 + t343*t374 - t343*t375;
            /* d/dk2 of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_k2 = carried_x1_1_by_y_by_k2 + delay_tau_by_y*v1_1_by_k2 + delay_tau_by_y_by_k2*v1_1;
            const double x1_1_on_boundary_by_u_by_k2 = carried_x1_1_by_u_by_k2 + delay_tau_by_u*v1_1_by_k2 + delay_tau_by_u_by_k2*v1_1;
            const double x1_1_on_boundary_by_w_by_k2 = carried_x1_1_by_w_by_k2 + delay_tau_by_w*v1_1_by_k2 + delay_tau_by_w_by_k2*v1_1;
            const double x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_tau_by_y*v2_1_by_k2 + delay_tau_by_y_by_k2*v2_1;
            const double x2_1_on_boundary_by_u_by_k2 = carried_x2_1_by_u_by_k2 + delay_tau_by_u*v2_1_by_k2 + delay_tau_by_u_by_k2*v2_1;
            const double x2_1_on_boundary_by_w_by_k2 = carried_x2_1_by_w_by_k2 + delay_tau_by_w*v2_1_by_k2 + delay_tau_by_w_by_k2*v2_1;
            const double t376 = k1*x2_1_by_k2;
            const double t377 = t74*x1_1_by_k2;
            const double v1_1_on_boundary_by_y_by_k2 = carried_v1_1_by_y_by_k2 + delay_tau_by_y_by_k2*t76 + t334*t376 - t334*t377;
            const double v1_1_on_boundary_by_u_by_k2 = carried_v1_1_by_u_by_k2 + delay_tau_by_u_by_k2*t76 + t337*t376 - t337*t377;
            const double v1_1_on_boundary_by_w_by_k2 = carried_v1_1_by_w_by_k2 + delay_tau_by_w_by_k2*t76 + t338*t376 - t338*t377;
            const double t378 = k1*x1_1_by_k2;
            const double t379 = t79*x2_1_by_k2;
            const double v2_1_on_boundary_by_y_by_k2 = carried_v2_1_by_y_by_k2 - delay_tau_by_y*t80 + delay_tau_by_y_by_k2*t81 + t339*t378 - t339*t379;
            const double v2_1_on_boundary_by_u_by_k2 = carried_v2_1_by_u_by_k2 - delay_tau_by_u*t80 + delay_tau_by_u_by_k2*t81 + t342*t378 - t342*t379;
            const double v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_tau_by_w*t80 + delay_tau_by_w_by_k2*t81 + t343*t378 - t343*t379;
            /* d/dk3 of: perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y_by_k3 = carried_x1_1_by_y_by_k3 + delay_tau_by_y*v1_1_by_k3 + delay_tau_by_y_by_k3*v1_1;
            const double x1_1_on_boundary_by_u_by_k3 = carried_x1_1_by_u_by_k3 + delay_tau_by_u*v1_1_by_k3 + delay_tau_by_u_by_k3*v1_1;
            const double x1_1_on_boundary_by_w_by_k3 = carried_x1_1_by_w_by_k3 + delay_tau_by_w*v1_1_by_k3 + delay_tau_by_w_by_k3*v1_1;
            const double x2_1_on_boundary_by_y_by_k3 = carried_x2_1_by_y_by_k3 + delay_tau_by_y*v2_1_by_k3 + delay_tau_by_y_by_k3*v2_1;
            const double x2_1_on_boundary_by_u_by_k3 = carried_x2_1_by_u_by_k3 + delay_tau_by_u*v2_1_by_k3 + delay_tau_by_u_by_k3*v2_1;
            const double x2_1_on_boundary_by_w_by_k3 = carried_x2_1_by_w_by_k3 + delay_tau_by_w*v2_1_by_k3 + delay_tau_by_w_by_k3*v2_1;
            const double t380 = t73 - t75;
            const double t381 = k1*x2_1_by_k3;
            const double t382 = t74*x1_1_by_k3;
            const double v1_1_on_boundary_by_y_by_k3 = carried_v1_1_by_y_by_k3 + delay_tau_by_y*t380 + delay_tau_by_y_by_k3*t76 + t334*t381 - t334*t382;
            const double v1_1_on_boundary_by_u_by_k3 = carried_v1_1_by_u_by_k3 + delay_tau_by_u*t380 + delay_tau_by_u_by_k3*t76 + t337*t381 - t337*t382;
            const double v1_1_on_boundary_by_w_by_k3 = carried_v1_1_by_w_by_k3 + delay_tau_by_w*t380 + delay_tau_by_w_by_k3*t76 + t338*t381 - t338*t382;
            const double t383 = k1*x1_1_by_k3;
            const double t384 = t79*x2_1_by_k3;
            const double v2_1_on_boundary_by_y_by_k3 = carried_v2_1_by_y_by_k3 + delay_tau_by_y_by_k3*t81 + t339*t383 - t339*t384;
            const double v2_1_on_boundary_by_u_by_k3 = carried_v2_1_by_u_by_k3 + delay_tau_by_u_by_k3*t81 + t342*t383 - t342*t384;
            const double v2_1_on_boundary_by_w_by_k3 = carried_v2_1_by_w_by_k3 + delay_tau_by_w_by_k3*t81 + t343*t383 - t343*t384;
            /* d/dy of: Phi along tau1 */
            const double carried_x1_2_by_y_by_y = t58*v1_1_on_boundary_by_y_by_y + t59*v2_1_on_boundary_by_y_by_y + t60*x1_1_on_boundary_by_y_by_y + t61*x2_1_on_boundary_by_y_by_y;
            const double carried_x1_2_by_u_by_y = t58*v1_1_on_boundary_by_u_by_y + t59*v2_1_on_boundary_by_u_by_y + t60*x1_1_on_boundary_by_u_by_y + t61*x2_1_on_boundary_by_u_by_y;
            const double carried_x1_2_by_w_by_y = t58*v1_1_on_boundary_by_w_by_y + t59*v2_1_on_boundary_by_w_by_y + t60*x1_1_on_boundary_by_w_by_y + t61*x2_1_on_boundary_by_w_by_y;
            const double carried_x2_2_by_y_by_y = t62*v1_1_on_boundary_by_y_by_y + t63*v2_1_on_boundary_by_y_by_y + t64*x1_1_on_boundary_by_y_by_y + t65*x2_1_on_boundary_by_y_by_y;
            const double carried_v1_2_by_u_by_y = t60*v1_1_on_boundary_by_u_by_y + t61*v2_1_on_boundary_by_u_by_y + t68*x1_1_on_boundary_by_u_by_y + t69*x2_1_on_boundary_by_u_by_y;
            const double carried_v2_2_by_w_by_y = t64*v1_1_on_boundary_by_w_by_y + t65*v2_1_on_boundary_by_w_by_y + t70*x1_1_on_boundary_by_w_by_y + t71*x2_1_on_boundary_by_w_by_y;
            /* d/du of: Phi along tau1 */
            const double carried_x1_2_by_y_by_u = t58*v1_1_on_boundary_by_y_by_u + t59*v2_1_on_boundary_by_y_by_u + t60*x1_1_on_boundary_by_y_by_u + t61*x2_1_on_boundary_by_y_by_u;
            const double carried_x1_2_by_u_by_u = t58*v1_1_on_boundary_by_u_by_u + t59*v2_1_on_boundary_by_u_by_u + t60*x1_1_on_boundary_by_u_by_u + t61*x2_1_on_boundary_by_u_by_u;
            const double carried_x1_2_by_w_by_u = t58*v1_1_on_boundary_by_w_by_u + t59*v2_1_on_boundary_by_w_by_u + t60*x1_1_on_boundary_by_w_by_u + t61*x2_1_on_boundary_by_w_by_u;
            const double carried_x2_2_by_y_by_u = t62*v1_1_on_boundary_by_y_by_u + t63*v2_1_on_boundary_by_y_by_u + t64*x1_1_on_boundary_by_y_by_u + t65*x2_1_on_boundary_by_y_by_u;
            const double carried_v1_2_by_u_by_u = t60*v1_1_on_boundary_by_u_by_u + t61*v2_1_on_boundary_by_u_by_u + t68*x1_1_on_boundary_by_u_by_u + t69*x2_1_on_boundary_by_u_by_u;
            const double carried_v2_2_by_w_by_u = t64*v1_1_on_boundary_by_w_by_u + t65*v2_1_on_boundary_by_w_by_u + t70*x1_1_on_boundary_by_w_by_u + t71*x2_1_on_boundary_by_w_by_u;
            /* d/dw of: Phi along tau1 */
            const double carried_x1_2_by_y_by_w = t58*v1_1_on_boundary_by_y_by_w + t59*v2_1_on_boundary_by_y_by_w + t60*x1_1_on_boundary_by_y_by_w + t61*x2_1_on_boundary_by_y_by_w;
            const double carried_x1_2_by_u_by_w = t58*v1_1_on_boundary_by_u_by_w + t59*v2_1_on_boundary_by_u_by_w + t60*x1_1_on_boundary_by_u_by_w + t61*x2_1_on_boundary_by_u_by_w;
            const double carried_x1_2_by_w_by_w = t58*v1_1_on_boundary_by_w_by_w + t59*v2_1_on_boundary_by_w_by_w + t60*x1_1_on_boundary_by_w_by_w + t61*x2_1_on_boundary_by_w_by_w;
            const double carried_x2_2_by_y_by_w = t62*v1_1_on_boundary_by_y_by_w + t63*v2_1_on_boundary_by_y_by_w + t64*x1_1_on_boundary_by_y_by_w + t65*x2_1_on_boundary_by_y_by_w;
            const double carried_v1_2_by_u_by_w = t60*v1_1_on_boundary_by_u_by_w + t61*v2_1_on_boundary_by_u_by_w + t68*x1_1_on_boundary_by_u_by_w + t69*x2_1_on_boundary_by_u_by_w;
            const double carried_v2_2_by_w_by_w = t64*v1_1_on_boundary_by_w_by_w + t65*v2_1_on_boundary_by_w_by_w + t70*x1_1_on_boundary_by_w_by_w + t71*x2_1_on_boundary_by_w_by_w;
            /* d/dtau of: Phi along tau1 */
            const double t385 = p5*x2_1_on_boundary_by_y;
            const double t386 = p4*x1_1_on_boundary_by_y + t385;
            const double t387 = -t385 + t55*x1_1_on_boundary_by_y;
            const double t388 = p4*t53;
            const double t389 = p5*v2_1_on_boundary_by_y;
            const double t390 = t388*v1_1_on_boundary_by_y + t389*t53;
            const double t391 = -t389*t56 + t55*t56*v1_1_on_boundary_by_y;
            const double carried_x1_2_by_y_by_tau = cos_omega3_tau1_by_tau*t386 + cos_omega4_tau1_by_tau*t387 + sin_omega3_tau1_by_tau*t390 + sin_omega4_tau1_by_tau*t391 + t58*v1_1_on_boundary_by_y_by_tau + t59*v2_1_on_boundary_by_y_by_tau + t60*x1_1_on_boundary_by_y_by_tau + t61*x2_1_on_boundary_by_y_by_tau;
            const double t392 = p4*x1_1_on_boundary_by_u;
            const double t393 = p5*x2_1_on_boundary_by_u;
            const double t394 = t392 + t393;
            const double t395 = -t393 + t55*x1_1_on_boundary_by_u;
            const double t396 = p4*v1_1_on_boundary_by_u;
            const double t397 = p5*v2_1_on_boundary_by_u;
            const double t398 = t396*t53 + t397*t53;
            const double t399 = -t397*t56 + t55*t56*v1_1_on_boundary_by_u;
            const double carried_x1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t394 + cos_omega4_tau1_by_tau*t395 + sin_omega3_tau1_by_tau*t398 + sin_omega4_tau1_by_tau*t399 + t58*v1_1_on_boundary_by_u_by_tau + t59*v2_1_on_boundary_by_u_by_tau + t60*x1_1_on_boundary_by_u_by_tau + t61*x2_1_on_boundary_by_u_by_tau;
            const double t400 = p5*x2_1_on_boundary_by_w;
            const double t401 = p4*x1_1_on_boundary_by_w + t400;
            const double t402 = -t400 + t55*x1_1_on_boundary_by_w;
            const double t403 = p5*v2_1_on_boundary_by_w;
            const double t404 = t388*v1_1_on_boundary_by_w + t403*t53;
            const double t405 = -t403*t56 + t55*t56*v1_1_on_boundary_by_w;
            const double carried_x1_2_by_w_by_tau = cos_omega3_tau1_by_tau*t401 + cos_omega4_tau1_by_tau*t402 + sin_omega3_tau1_by_tau*t404 + sin_omega4_tau1_by_tau*t405 + t58*v1_1_on_boundary_by_w_by_tau + t59*v2_1_on_boundary_by_w_by_tau + t60*x1_1_on_boundary_by_w_by_tau + t61*x2_1_on_boundary_by_w_by_tau;
            const double t406 = p6*x1_1_on_boundary_by_y;
            const double t407 = t406 + t55*x2_1_on_boundary_by_y;
            const double t408 = p4*x2_1_on_boundary_by_y - t406;
            const double t409 = p6*v1_1_on_boundary_by_y;
            const double t410 = t55*v2_1_on_boundary_by_y;
            const double t411 = t409*t53 + t410*t53;
            const double t412 = p4*v2_1_on_boundary_by_y;
            const double t413 = -t409*t56 + t412*t56;
            const double carried_x2_2_by_y_by_tau = cos_omega3_tau1_by_tau*t407 + cos_omega4_tau1_by_tau*t408 + sin_omega3_tau1_by_tau*t411 + sin_omega4_tau1_by_tau*t413 + t62*v1_1_on_boundary_by_y_by_tau + t63*v2_1_on_boundary_by_y_by_tau + t64*x1_1_on_boundary_by_y_by_tau + t65*x2_1_on_boundary_by_y_by_tau;
            const double t414 = t396 + t397;
            const double t415 = -t397 + t55*v1_1_on_boundary_by_u;
            const double t416 = -omega3*t392 - omega3*t393;
            const double t417 = t55*x1_1_on_boundary_by_u;
            const double t418 = omega4*t393 - omega4*t417;
            const double carried_v1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t414 + cos_omega4_tau1_by_tau*t415 + sin_omega3_tau1_by_tau*t416 + sin_omega4_tau1_by_tau*t418 + t60*v1_1_on_boundary_by_u_by_tau + t61*v2_1_on_boundary_by_u_by_tau + t68*x1_1_on_boundary_by_u_by_tau + t69*x2_1_on_boundary_by_u_by_tau;
            const double t419 = p6*v1_1_on_boundary_by_w;
            const double t420 = t419 + t55*v2_1_on_boundary_by_w;
            const double t421 = p4*v2_1_on_boundary_by_w - t419;
            const double t422 = p6*x1_1_on_boundary_by_w;
            const double t423 = t55*x2_1_on_boundary_by_w;
            const double t424 = -omega3*t422 - omega3*t423;
            const double t425 = p4*x2_1_on_boundary_by_w;
            const double t426 = omega4*p6*x1_1_on_boundary_by_w - omega4*t425;
            const double carried_v2_2_by_w_by_tau = cos_omega3_tau1_by_tau*t420 + cos_omega4_tau1_by_tau*t421 + sin_omega3_tau1_by_tau*t424 + sin_omega4_tau1_by_tau*t426 + t64*v1_1_on_boundary_by_w_by_tau + t65*v2_1_on_boundary_by_w_by_tau + t70*x1_1_on_boundary_by_w_by_tau + t71*x2_1_on_boundary_by_w_by_tau;
            /* d/dm1 of: Phi along tau1 */
            const double t427 = p4*t226;
            const double t428 = -t226*t389 - t427*v1_1_on_boundary_by_y;
            const double t429 = t229*t55;
            const double t430 = t229*t389 - t429*v1_1_on_boundary_by_y;
            const double t431 = -t231*v1_1_on_boundary_by_y + t233*x1_1_on_boundary_by_y;
            const double t432 = -t231*v2_1_on_boundary_by_y + t233*x2_1_on_boundary_by_y;
            const double carried_x1_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t386 + cos_omega4_tau1_by_m1*t387 + omega3_by_m1*t428 + omega4_by_m1*t430 + p4_by_m1*t431 + p5_by_m1*t432 + sin_omega3_tau1_by_m1*t390 + sin_omega4_tau1_by_m1*t391 + t58*v1_1_on_boundary_by_y_by_m1 + t59*v2_1_on_boundary_by_y_by_m1 + t60*x1_1_on_boundary_by_y_by_m1 + t61*x2_1_on_boundary_by_y_by_m1;
            const double t433 = -t226*t396 - t226*t397;
            const double t434 = t229*t397 - t229*t55*v1_1_on_boundary_by_u;
            const double t435 = -t231*v1_1_on_boundary_by_u + t233*x1_1_on_boundary_by_u;
            const double t436 = -t231*v2_1_on_boundary_by_u + t233*x2_1_on_boundary_by_u;
            const double carried_x1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t394 + cos_omega4_tau1_by_m1*t395 + omega3_by_m1*t433 + omega4_by_m1*t434 + p4_by_m1*t435 + p5_by_m1*t436 + sin_omega3_tau1_by_m1*t398 + sin_omega4_tau1_by_m1*t399 + t58*v1_1_on_boundary_by_u_by_m1 + t59*v2_1_on_boundary_by_u_by_m1 + t60*x1_1_on_boundary_by_u_by_m1 + t61*x2_1_on_boundary_by_u_by_m1;
            const double t437 = -t226*t403 - t427*v1_1_on_boundary_by_w;
            const double t438 = t229*t403 - t429*v1_1_on_boundary_by_w;
            const double t439 = -t231*v1_1_on_boundary_by_w + t233*x1_1_on_boundary_by_w;
            const double t440 = -t231*v2_1_on_boundary_by_w + t233*x2_1_on_boundary_by_w;
            const double carried_x1_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t401 + cos_omega4_tau1_by_m1*t402 + omega3_by_m1*t437 + omega4_by_m1*t438 + p4_by_m1*t439 + p5_by_m1*t440 + sin_omega3_tau1_by_m1*t404 + sin_omega4_tau1_by_m1*t405 + t58*v1_1_on_boundary_by_w_by_m1 + t59*v2_1_on_boundary_by_w_by_m1 + t60*x1_1_on_boundary_by_w_by_m1 + t61*x2_1_on_boundary_by_w_by_m1;
            const double t441 = -t226*t409 - t226*t410;
            const double t442 = p6*sin_omega4_tau1*t228*v1_1_on_boundary_by_y - t229*t412;
            const double t443 = t231*v2_1_on_boundary_by_y - t233*x2_1_on_boundary_by_y;
            const double carried_x2_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t407 + cos_omega4_tau1_by_m1*t408 + omega3_by_m1*t441 + omega4_by_m1*t442 + p4_by_m1*t443 + p6_by_m1*t431 + sin_omega3_tau1_by_m1*t411 + sin_omega4_tau1_by_m1*t413 + t62*v1_1_on_boundary_by_y_by_m1 + t63*v2_1_on_boundary_by_y_by_m1 + t64*x1_1_on_boundary_by_y_by_m1 + t65*x2_1_on_boundary_by_y_by_m1;
            const double t444 = -sin_omega3_tau1*t392 - sin_omega3_tau1*t393;
            const double t445 = sin_omega4_tau1*t393 - sin_omega4_tau1*t417;
            const double t446 = t233*v1_1_on_boundary_by_u - t242*x1_1_on_boundary_by_u;
            const double t447 = t233*v2_1_on_boundary_by_u - t242*x2_1_on_boundary_by_u;
            const double carried_v1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t414 + cos_omega4_tau1_by_m1*t415 + omega3_by_m1*t444 + omega4_by_m1*t445 + p4_by_m1*t446 + p5_by_m1*t447 + sin_omega3_tau1_by_m1*t416 + sin_omega4_tau1_by_m1*t418 + t60*v1_1_on_boundary_by_u_by_m1 + t61*v2_1_on_boundary_by_u_by_m1 + t68*x1_1_on_boundary_by_u_by_m1 + t69*x2_1_on_boundary_by_u_by_m1;
            const double t448 = -sin_omega3_tau1*t422 - sin_omega3_tau1*t423;
            const double t449 = p6*sin_omega4_tau1*x1_1_on_boundary_by_w - sin_omega4_tau1*t425;
            const double t450 = -t233*v2_1_on_boundary_by_w + t242*x2_1_on_boundary_by_w;
            const double t451 = t233*v1_1_on_boundary_by_w - t242*x1_1_on_boundary_by_w;
            const double carried_v2_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t420 + cos_omega4_tau1_by_m1*t421 + omega3_by_m1*t448 + omega4_by_m1*t449 + p4_by_m1*t450 + p6_by_m1*t451 + sin_omega3_tau1_by_m1*t424 + sin_omega4_tau1_by_m1*t426 + t64*v1_1_on_boundary_by_w_by_m1 + t65*v2_1_on_boundary_by_w_by_m1 + t70*x1_1_on_boundary_by_w_by_m1 + t71*x2_1_on_boundary_by_w_by_m1;
            /* d/dm2 of: Phi along tau1 */
            const double carried_x1_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t386 + cos_omega4_tau1_by_m2*t387 + omega3_by_m2*t428 + omega4_by_m2*t430 + p4_by_m2*t431 + p5_by_m2*t432 + sin_omega3_tau1_by_m2*t390 + sin_omega4_tau1_by_m2*t391 + t58*v1_1_on_boundary_by_y_by_m2 + t59*v2_1_on_boundary_by_y_by_m2 + t60*x1_1_on_boundary_by_y_by_m2 + t61*x2_1_on_boundary_by_y_by_m2;
            const double carried_x1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t394 + cos_omega4_tau1_by_m2*t395 + omega3_by_m2*t433 + omega4_by_m2*t434 + p4_by_m2*t435 + p5_by_m2*t436 + sin_omega3_tau1_by_m2*t398 + sin_omega4_tau1_by_m2*t399 + t58*v1_1_on_boundary_by_u_by_m2 + t59*v2_1_on_boundary_by_u_by_m2 + t60*x1_1_on_boundary_by_u_by_m2 + t61*x2_1_on_boundary_by_u_by_m2;
            const double carried_x1_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t401 + cos_omega4_tau1_by_m2*t402 + omega3_by_m2*t437 + omega4_by_m2*t438 + p4_by_m2*t439 + p5_by_m2*t440 + sin_omega3_tau1_by_m2*t404 + sin_omega4_tau1_by_m2*t405 + t58*v1_1_on_boundary_by_w_by_m2 + t59*v2_1_on_boundary_by_w_by_m2 + t60*x1_1_on_boundary_by_w_by_m2 + t61*x2_1_on_boundary_by_w_by_m2;
            const double carried_x2_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t407 + cos_omega4_tau1_by_m2*t408 + omega3_by_m2*t441 + omega4_by_m2*t442 + p4_by_m2*t443 + p6_by_m2*t431 + sin_omega3_tau1_by_m2*t411 + sin_omega4_tau1_by_m2*t413 + t62*v1_1_on_boundary_by_y_by_m2 + t63*v2_1_on_boundary_by_y_by_m2 + t64*x1_1_on_boundary_by_y_by_m2 + t65*x2_1_on_boundary_by_y_by_m2;
            const double carried_v1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t414 + cos_omega4_tau1_by_m2*t415 + omega3_by_m2*t444 + omega4_by_m2*t445 + p4_by_m2*t446 + p5_by_m2*t447 + sin_omega3_tau1_by_m2*t416 + sin_omega4_tau1_by_m2*t418 + t60*v1_1_on_boundary_by_u_by_m2 + t61*v2_1_on_boundary_by_u_by_m2 + t68*x1_1_on_boundary_by_u_by_m2 + t69*x2_1_on_boundary_by_u_by_m2;
            const double carried_v2_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t420 + cos_omega4_tau1_by_m2*t421 + omega3_by_m2*t448 + omega4_by_m2*t449 + p4_by_m2*t450 + p6_by_m2*t451 + sin_omega3_tau1_by_m2*t424 + sin_omega4_tau1_by_m2*t426 + t64*v1_1_on_boundary_by_w_by_m2 + t65*v2_1_on_boundary_by_w_by_m2 + t70*x1_1_on_boundary_by_w_by_m2 + t71*x2_1_on_boundary_by_w_by_m2;
            /* d/dk1 of: Phi along tau1 */
            const double carried_x1_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t386 + cos_omega4_tau1_by_k1*t387 + omega3_by_k1*t428 + omega4_by_k1*t430 + p4_by_k1*t431 + p5_by_k1*t432 + sin_omega3_tau1_by_k1*t390 + sin_omega4_tau1_by_k1*t391 + t58*v1_1_on_boundary_by_y_by_k1 + t59*v2_1_on_boundary_by_y_by_k1 + t60*x1_1_on_boundary_by_y_by_k1 + t61*x2_1_on_boundary_by_y_by_k1;
            const double carried_x1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t394 + cos_omega4_tau1_by_k1*t395 + omega3_by_k1*t433 + omega4_by_k1*t434 + p4_by_k1*t435 + p5_by_k1*t436 + sin_omega3_tau1_by_k1*t398 + sin_omega4_tau1_by_k1*t399 + t58*v1_1_on_boundary_by_u_by_k1 + t59*v2_1_on_boundary_by_u_by_k1 + t60*x1_1_on_boundary_by_u_by_k1 + t61*x2_1_on_boundary_by_u_by_k1;
            const double carried_x1_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t401 + cos_omega4_tau1_by_k1*t402 + omega3_by_k1*t437 + omega4_by_k1*t438 + p4_by_k1*t439 + p5_by_k1*t440 + sin_omega3_tau1_by_k1*t404 + sin_omega4_tau1_by_k1*t405 + t58*v1_1_on_boundary_by_w_by_k1 + t59*v2_1_on_boundary_by_w_by_k1 + t60*x1_1_on_boundary_by_w_by_k1 + t61*x2_1_on_boundary_by_w_by_k1;
            const double carried_x2_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t407 + cos_omega4_tau1_by_k1*t408 + omega3_by_k1*t441 + omega4_by_k1*t442 + p4_by_k1*t443 + p6_by_k1*t431 + sin_omega3_tau1_by_k1*t411 + sin_omega4_tau1_by_k1*t413 + t62*v1_1_on_boundary_by_y_by_k1 + t63*v2_1_on_boundary_by_y_by_k1 + t64*x1_1_on_boundary_by_y_by_k1 + t65*x2_1_on_boundary_by_y_by_k1;
            const double carried_v1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t414 + cos_omega4_tau1_by_k1*t415 + omega3_by_k1*t444 + omega4_by_k1*t445 + p4_by_k1*t446 + p5_by_k1*t447 + sin_omega3_tau1_by_k1*t416 + sin_omega4_tau1_by_k1*t418 + t60*v1_1_on_boundary_by_u_by_k1 + t61*v2_1_on_boundary_by_u_by_k1 + t68*x1_1_on_boundary_by_u_by_k1 + t69*x2_1_on_boundary_by_u_by_k1;
            const double carried_v2_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t420 + cos_omega4_tau1_by_k1*t421 + omega3_by_k1*t448 + omega4_by_k1*t449 + p4_by_k1*t450 + p6_by_k1*t451 + sin_omega3_tau1_by_k1*t424 + sin_omega4_tau1_by_k1*t426 + t64*v1_1_on_boundary_by_w_by_k1 + t65*v2_1_on_boundary_by_w_by_k1 + t70*x1_1_on_boundary_by_w_by_k1 + t71*x2_1_on_boundary_by_w_by_k1;
            /* d/dk2 of: Phi along tau1 */
            const double carried_x1_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t386 + cos_omega4_tau1_by_k2*t387 + omega3_by_k2*t428 + omega4_by_k2*t430 + p4_by_k2*t431 + p5_by_k2*t432 + sin_omega3_tau1_by_k2*t390 + sin_omega4_tau1_by_k2*t391 + t58*v1_1_on_boundary_by_y_by_k2 + t59*v2_1_on_boundary_by_y_by_k2 + t60*x1_1_on_boundary_by_y_by_k2 + t61*x2_1_on_boundary_by_y_by_k2;
            const double carried_x1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t394 + cos_omega4_tau1_by_k2*t395 + omega3_by_k2*t433 + omega4_by_k2*t434 + p4_by_k2*t435 + p5_by_k2*t436 + sin_omega3_tau1_by_k2*t398 + sin_omega4_tau1_by_k2*t399 + t58*v1_1_on_boundary_by_u_by_k2 + t59*v2_1_on_boundary_by_u_by_k2 + t60*x1_1_on_boundary_by_u_by_k2 + t61*x2_1_on_boundary_by_u_by_k2;
            const double carried_x1_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t401 + cos_omega4_tau1_by_k2*t402 + omega3_by_k2*t437 + omega4_by_k2*t438 + p4_by_k2*t439 + p5_by_k2*t440 + sin_omega3_tau1_by_k2*t404 + sin_omega4_tau1_by_k2*t405 + t58*v1_1_on_boundary_by_w_by_k2 + t59*v2_1_on_boundary_by_w_by_k2 + t60*x1_1_on_boundary_by_w_by_k2 + t61*x2_1_on_boundary_by_w_by_k2;
            const double carried_x2_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t407 + cos_omega4_tau1_by_k2*t408 + omega3_by_k2*t441 + omega4_by_k2*t442 + p4_by_k2*t443 + p6_by_k2*t431 + sin_omega3_tau1_by_k2*t411 + sin_omega4_tau1_by_k2*t413 + t62*v1_1_on_boundary_by_y_by_k2 + t63*v2_1_on_boundary_by_y_by_k2 + t64*x1_1_on_boundary_by_y_by_k2 + t65*x2_1_on_boundary_by_y_by_k2;
            const double carried_v1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t414 + cos_omega4_tau1_by_k2*t415 + omega3_by_k2*t444 + omega4_by_k2*t445 + p4_by_k2*t446 + p5_by_k2*t447 + sin_omega3_tau1_by_k2*t416 + sin_omega4_tau1_by_k2*t418 + t60*v1_1_on_boundary_by_u_by_k2 + t61*v2_1_on_boundary_by_u_by_k2 + t68*x1_1_on_boundary_by_u_by_k2 + t69*x2_1_on_boundary_by_u_by_k2;
            const double carried_v2_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t420 + cos_omega4_tau1_by_k2*t421 + omega3_by_k2*t448 + omega4_by_k2*t449 + p4_by_k2*t450 + p6_by_k2*t451 + sin_omega3_tau1_by_k2*t424 + sin_omega4_tau1_by_k2*t426 + t64*v1_1_on_boundary_by_w_by_k2 + t65*v2_1_on_boundary_by_w_by_k2 + t70*x1_1_on_boundary_by_w_by_k2 + t71*x2_1_on_boundary_by_w_by_k2;
            /* d/dk3 of: Phi along tau1 */
            const double carried_x1_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t386 + cos_omega4_tau1_by_k3*t387 + omega3_by_k3*t428 + omega4_by_k3*t430 + p4_by_k3*t431 + p5_by_k3*t432 + sin_omega3_tau1_by_k3*t390 + sin_omega4_tau1_by_k3*t391 + t58*v1_1_on_boundary_by_y_by_k3 + t59*v2_1_on_boundary_by_y_by_k3 + t60*x1_1_on_boundary_by_y_by_k3 + t61*x2_1_on_boundary_by_y_by_k3;
            const double carried_x1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t394 + cos_omega4_tau1_by_k3*t395 + omega3_by_k3*t433 + omega4_by_k3*t434 + p4_by_k3*t435 + p5_by_k3*t436 + sin_omega3_tau1_by_k3*t398 + sin_omega4_tau1_by_k3*t399 + t58*v1_1_on_boundary_by_u_by_k3 + t59*v2_1_on_boundary_by_u_by_k3 + t60*x1_1_on_boundary_by_u_by_k3 + t61*x2_1_on_boundary_by_u_by_k3;
            const double carried_x1_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t401 + cos_omega4_tau1_by_k3*t402 + omega3_by_k3*t437 + omega4_by_k3*t438 + p4_by_k3*t439 + p5_by_k3*t440 + sin_omega3_tau1_by_k3*t404 + sin_omega4_tau1_by_k3*t405 + t58*v1_1_on_boundary_by_w_by_k3 + t59*v2_1_on_boundary_by_w_by_k3 + t60*x1_1_on_boundary_by_w_by_k3 + t61*x2_1_on_boundary_by_w_by_k3;
            const double carried_x2_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t407 + cos_omega4_tau1_by_k3*t408 + omega3_by_k3*t441 + omega4_by_k3*t442 + p4_by_k3*t443 + p6_by_k3*t431 + sin_omega3_tau1_by_k3*t411 + sin_omega4_tau1_by_k3*t413 + t62*v1_1_on_boundary_by_y_by_k3 + t63*v2_1_on_boundary_by_y_by_k3 + t64*x1_1_on_boundary_by_y_by_k3 + t65*x2_1_on_boundary_by_y_by_k3;
            const double carried_v1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t414 + cos_omega4_tau1_by_k3*t415 + omega3_by_k3*t444 + omega4_by_k3*t445 + p4_by_k3*t446 + p5_by_k3*t447 + sin_omega3_tau1_by_k3*t416 + sin_omega4_tau1_by_k3*t418 + t60*v1_1_on_boundary_by_u_by_k3 + t61*v2_1_on_boundary_by_u_by_k3 + t68*x1_1_on_boundary_by_u_by_k3 + t69*x2_1_on_boundary_by_u_by_k3;
            const double carried_v2_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t420 + cos_omega4_tau1_by_k3*t421 + omega3_by_k3*t448 + omega4_by_k3*t449 + p4_by_k3*t450 + p6_by_k3*t451 + sin_omega3_tau1_by_k3*t424 + sin_omega4_tau1_by_k3*t426 + t64*v1_1_on_boundary_by_w_by_k3 + t65*v2_1_on_boundary_by_w_by_k3 + t70*x1_1_on_boundary_by_w_by_k3 + t71*x2_1_on_boundary_by_w_by_k3;
            /* d/dT of: Phi along tau1 */
            const double carried_x1_2_by_y_by_T = cos_omega3_tau1_by_T*t386 + cos_omega4_tau1_by_T*t387 + sin_omega3_tau1_by_T*t390 + sin_omega4_tau1_by_T*t391;
            const double carried_x1_2_by_u_by_T = cos_omega3_tau1_by_T*t394 + cos_omega4_tau1_by_T*t395 + sin_omega3_tau1_by_T*t398 + sin_omega4_tau1_by_T*t399;
            const double carried_x1_2_by_w_by_T = cos_omega3_tau1_by_T*t401 + cos_omega4_tau1_by_T*t402 + sin_omega3_tau1_by_T*t404 + sin_omega4_tau1_by_T*t405;
            const double carried_x2_2_by_y_by_T = cos_omega3_tau1_by_T*t407 + cos_omega4_tau1_by_T*t408 + sin_omega3_tau1_by_T*t411 + sin_omega4_tau1_by_T*t413;
            const double carried_v1_2_by_u_by_T = cos_omega3_tau1_by_T*t414 + cos_omega4_tau1_by_T*t415 + sin_omega3_tau1_by_T*t416 + sin_omega4_tau1_by_T*t418;
            const double carried_v2_2_by_w_by_T = cos_omega3_tau1_by_T*t420 + cos_omega4_tau1_by_T*t421 + sin_omega3_tau1_by_T*t424 + sin_omega4_tau1_by_T*t426;
            /* d/dy of: derivatives of the time to the boundary after tau1 */
            const double t452 = (1.0/(v1_2*v1_2));
            const double t453 = t452*v1_2_by_y;
            const double delay_tau1_by_y_by_y = carried_x1_2_by_y*t453 - carried_x1_2_by_y_by_y*t82;
            const double delay_tau1_by_u_by_y = carried_x1_2_by_u*t453 - carried_x1_2_by_u_by_y*t82;
            const double delay_tau1_by_w_by_y = carried_x1_2_by_w*t453 - carried_x1_2_by_w_by_y*t82;
            /* d/du of: derivatives of the time to the boundary after tau1 */
            const double t454 = t452*v1_2_by_u;
            const double delay_tau1_by_y_by_u = carried_x1_2_by_y*t454 - carried_x1_2_by_y_by_u*t82;
            const double delay_tau1_by_u_by_u = carried_x1_2_by_u*t454 - carried_x1_2_by_u_by_u*t82;
            const double delay_tau1_by_w_by_u = carried_x1_2_by_w*t454 - carried_x1_2_by_w_by_u*t82;
            /* d/dw of: derivatives of the time to the boundary after tau1 */
            const double t455 = t452*v1_2_by_w;
            const double delay_tau1_by_y_by_w = carried_x1_2_by_y*t455 - carried_x1_2_by_y_by_w*t82;
            const double delay_tau1_by_u_by_w = carried_x1_2_by_u*t455 - carried_x1_2_by_u_by_w*t82;
            const double delay_tau1_by_w_by_w = carried_x1_2_by_w*t455 - carried_x1_2_by_w_by_w*t82;
            /* d/dtau of: derivatives of the time to the boundary after tau1 */
            const double t456 = t452*v1_2_by_tau;
            const double delay_tau1_by_y_by_tau = carried_x1_2_by_y*t456 - carried_x1_2_by_y_by_tau*t82;
            const double delay_tau1_by_u_by_tau = carried_x1_2_by_u*t456 - carried_x1_2_by_u_by_tau*t82;
            const double delay_tau1_by_w_by_tau = carried_x1_2_by_w*t456 - carried_x1_2_by_w_by_tau*t82;
            /* d/dm1 of: derivatives of the time to the boundary after tau1 */
            const double t457 = t452*v1_2_by_m1;
            const double delay_tau1_by_y_by_m1 = carried_x1_2_by_y*t457 - carried_x1_2_by_y_by_m1*t82;
            const double delay_tau1_by_u_by_m1 = carried_x1_2_by_u*t457 - carried_x1_2_by_u_by_m1*t82;
            const double delay_tau1_by_w_by_m1 = carried_x1_2_by_w*t457 - carried_x1_2_by_w_by_m1*t82;
            /* d/dm2 of: derivatives of the time to the boundary after tau1 */
            const double t458 = t452*v1_2_by_m2;
            const double delay_tau1_by_y_by_m2 = carried_x1_2_by_y*t458 - carried_x1_2_by_y_by_m2*t82;
            const double delay_tau1_by_u_by_m2 = carried_x1_2_by_u*t458 - carried_x1_2_by_u_by_m2*t82;
            const double delay_tau1_by_w_by_m2 = carried_x1_2_by_w*t458 - carried_x1_2_by_w_by_m2*t82;
            /* d/dk1 of: derivatives of the time to the boundary after tau1 */
            const double t459 = t452*v1_2_by_k1;
            const double delay_tau1_by_y_by_k1 = carried_x1_2_by_y*t459 - carried_x1_2_by_y_by_k1*t82;
            const double delay_tau1_by_u_by_k1 = carried_x1_2_by_u*t459 - carried_x1_2_by_u_by_k1*t82;
            const double delay_tau1_by_w_by_k1 = carried_x1_2_by_w*t459 - carried_x1_2_by_w_by_k1*t82;
            /* d/dk2 of: derivatives of the time to the boundary after tau1 */
            const double t460 = t452*v1_2_by_k2;
            const double delay_tau1_by_y_by_k2 = carried_x1_2_by_y*t460 - carried_x1_2_by_y_by_k2*t82;
            const double delay_tau1_by_u_by_k2 = carried_x1_2_by_u*t460 - carried_x1_2_by_u_by_k2*t82;
            const double delay_tau1_by_w_by_k2 = carried_x1_2_by_w*t460 - carried_x1_2_by_w_by_k2*t82;
            /* d/dk3 of: derivatives of the time to the boundary after tau1 */
            const double t461 = t452*v1_2_by_k3;
            const double delay_tau1_by_y_by_k3 = carried_x1_2_by_y*t461 - carried_x1_2_by_y_by_k3*t82;
            const double delay_tau1_by_u_by_k3 = carried_x1_2_by_u*t461 - carried_x1_2_by_u_by_k3*t82;
            const double delay_tau1_by_w_by_k3 = carried_x1_2_by_w*t461 - carried_x1_2_by_w_by_k3*t82;
            /* d/dT of: derivatives of the time to the boundary after tau1 */
            const double t462 = t452*v1_2_by_T;
            const double delay_tau1_by_y_by_T = carried_x1_2_by_y*t462 - carried_x1_2_by_y_by_T*t82;
            const double delay_tau1_by_u_by_T = carried_x1_2_by_u*t462 - carried_x1_2_by_u_by_T*t82;
            const double delay_tau1_by_w_by_T = carried_x1_2_by_w*t462 - carried_x1_2_by_w_by_T*t82;
            /* d/dy of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_y = carried_x2_2_by_y_by_y + delay_tau1_by_y*v2_2_by_y + delay_tau1_by_y_by_y*v2_2;
            const double t463 = t73*x1_2;
            const double t464 = -k1*t463 + k1*t73*x2_2;
            const double t465 = delay_tau1_by_u*k1*t73;
            const double v1_2_on_boundary_by_u_by_y = carried_v1_2_by_u_by_y + delay_tau1_by_u_by_y*t464 - t465*x1_2_by_y + t465*x2_2_by_y;
            const double t466 = t77*x1_2;
            const double t467 = t77*x2_2;
            const double t468 = k1*t466 - t467*t79;
            const double t469 = delay_tau1_by_w*t77;
            const double t470 = k1*t469;
            const double t471 = t469*t79;
            const double v2_2_on_boundary_by_w_by_y = carried_v2_2_by_w_by_y + delay_tau1_by_w_by_y*t468 + t470*x1_2_by_y - t471*x2_2_by_y;
            /* d/du of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_u = carried_x2_2_by_y_by_u + delay_tau1_by_y*v2_2_by_u + delay_tau1_by_y_by_u*v2_2;
            const double v1_2_on_boundary_by_u_by_u = carried_v1_2_by_u_by_u + delay_tau1_by_u_by_u*t464 - t465*x1_2_by_u + t465*x2_2_by_u;
            const double v2_2_on_boundary_by_w_by_u = carried_v2_2_by_w_by_u + delay_tau1_by_w_by_u*t468 + t470*x1_2_by_u - t471*x2_2_by_u;
            /* d/dw of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_w = carried_x2_2_by_y_by_w + delay_tau1_by_y*v2_2_by_w + delay_tau1_by_y_by_w*v2_2;
            const double v1_2_on_boundary_by_u_by_w = carried_v1_2_by_u_by_w + delay_tau1_by_u_by_w*t464 - t465*x1_2_by_w + t465*x2_2_by_w;
            const double v2_2_on_boundary_by_w_by_w = carried_v2_2_by_w_by_w + delay_tau1_by_w_by_w*t468 + t470*x1_2_by_w - t471*x2_2_by_w;
            /* d/dtau of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_tau = carried_x2_2_by_y_by_tau + delay_tau1_by_y*v2_2_by_tau + delay_tau1_by_y_by_tau*v2_2;
            const double v1_2_on_boundary_by_u_by_tau = carried_v1_2_by_u_by_tau + delay_tau1_by_u_by_tau*t464 - t465*x1_2_by_tau + t465*x2_2_by_tau;
            const double v2_2_on_boundary_by_w_by_tau = carried_v2_2_by_w_by_tau + delay_tau1_by_w_by_tau*t468 + t470*x1_2_by_tau - t471*x2_2_by_tau;
            /* d/dm1 of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_m1 = carried_x2_2_by_y_by_m1 + delay_tau1_by_y*v2_2_by_m1 + delay_tau1_by_y_by_m1*v2_2;
            const double v1_2_on_boundary_by_u_by_m1 = carried_v1_2_by_u_by_m1 + delay_tau1_by_u*(t357*x1_2 - t357*x2_2) + delay_tau1_by_u_by_m1*t464 - t465*x1_2_by_m1 + t465*x2_2_by_m1;
            const double v2_2_on_boundary_by_w_by_m1 = carried_v2_2_by_w_by_m1 + delay_tau1_by_w_by_m1*t468 + t470*x1_2_by_m1 - t471*x2_2_by_m1;
            /* d/dm2 of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_m2 = carried_x2_2_by_y_by_m2 + delay_tau1_by_y*v2_2_by_m2 + delay_tau1_by_y_by_m2*v2_2;
            const double v1_2_on_boundary_by_u_by_m2 = carried_v1_2_by_u_by_m2 + delay_tau1_by_u_by_m2*t464 - t465*x1_2_by_m2 + t465*x2_2_by_m2;
            const double v2_2_on_boundary_by_w_by_m2 = carried_v2_2_by_w_by_m2 + delay_tau1_by_w*(t365*t79*x2_2 - t366*x1_2) + delay_tau1_by_w_by_m2*t468 + t470*x1_2_by_m2 - t471*x2_2_by_m2;
            /* d/dk1 of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_k1 = carried_x2_2_by_y_by_k1 + delay_tau1_by_y*v2_2_by_k1 + delay_tau1_by_y_by_k1*v2_2;
            const double v1_2_on_boundary_by_u_by_k1 = carried_v1_2_by_u_by_k1 + delay_tau1_by_u*(-t463 + t73*x2_2) + delay_tau1_by_u_by_k1*t464 - t465*x1_2_by_k1 + t465*x2_2_by_k1;
            const double v2_2_on_boundary_by_w_by_k1 = carried_v2_2_by_w_by_k1 + delay_tau1_by_w*(t466 - t467) + delay_tau1_by_w_by_k1*t468 + t470*x1_2_by_k1 - t471*x2_2_by_k1;
            /* d/dk2 of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_k2 = carried_x2_2_by_y_by_k2 + delay_tau1_by_y*v2_2_by_k2 + delay_tau1_by_y_by_k2*v2_2;
            const double v1_2_on_boundary_by_u_by_k2 = carried_v1_2_by_u_by_k2 + delay_tau1_by_u_by_k2*t464 - t465*x1_2_by_k2 + t465*x2_2_by_k2;
            const double v2_2_on_boundary_by_w_by_k2 = carried_v2_2_by_w_by_k2 - delay_tau1_by_w*t467 + delay_tau1_by_w_by_k2*t468 + t470*x1_2_by_k2 - t471*x2_2_by_k2;
            /* d/dk3 of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_k3 = carried_x2_2_by_y_by_k3 + delay_tau1_by_y*v2_2_by_k3 + delay_tau1_by_y_by_k3*v2_2;
            const double v1_2_on_boundary_by_u_by_k3 = carried_v1_2_by_u_by_k3 + delay_tau1_by_u_by_k3*t464 - t465*x1_2_by_k3 + t465*x2_2_by_k3;
            const double v2_2_on_boundary_by_w_by_k3 = carried_v2_2_by_w_by_k3 + delay_tau1_by_w_by_k3*t468 + t470*x1_2_by_k3 - t471*x2_2_by_k3;
            /* d/dT of: perturbation on the boundary after tau1 */
            const double x2_2_on_boundary_by_y_by_T = carried_x2_2_by_y_by_T + delay_tau1_by_y*v2_2_by_T + delay_tau1_by_y_by_T*v2_2;
            const double v1_2_on_boundary_by_u_by_T = carried_v1_2_by_u_by_T + delay_tau1_by_u_by_T*t464 - t465*x1_2_by_T + t465*x2_2_by_T;
            const double v2_2_on_boundary_by_w_by_T = carried_v2_2_by_w_by_T + delay_tau1_by_w_by_T*t468 + t470*x1_2_by_T - t471*x2_2_by_T;
            slope[0][lane] = v1_2_on_boundary_by_u_by_y + v2_2_on_boundary_by_w_by_y + x2_2_on_boundary_by_y_by_y;
            slope[1][lane] = v1_2_on_boundary_by_u_by_u + v2_2_on_boundary_by_w_by_u + x2_2_on_boundary_by_y_by_u;
            slope[2][lane] = v1_2_on_boundary_by_u_by_w + v2_2_on_boundary_by_w_by_w + x2_2_on_boundary_by_y_by_w;
            slope[3][lane] = v1_2_on_boundary_by_u_by_tau + v2_2_on_boundary_by_w_by_tau + x2_2_on_boundary_by_y_by_tau;
            slope[4][lane] = v1_2_on_boundary_by_u_by_m1 + v2_2_on_boundary_by_w_by_m1 + x2_2_on_boundary_by_y_by_m1;
            slope[5][lane] = v1_2_on_boundary_by_u_by_m2 + v2_2_on_boundary_by_w_by_m2 + x2_2_on_boundary_by_y_by_m2;
            slope[6][lane] = v1_2_on_boundary_by_u_by_k1 + v2_2_on_boundary_by_w_by_k1 + x2_2_on_boundary_by_y_by_k1;
            slope[7][lane] = v1_2_on_boundary_by_u_by_k2 + v2_2_on_boundary_by_w_by_k2 + x2_2_on_boundary_by_y_by_k2;
            slope[8][lane] = v1_2_on_boundary_by_u_by_k3 + v2_2_on_boundary_by_w_by_k3 + x2_2_on_boundary_by_y_by_k3;
            slope[9][lane] = v1_2_on_boundary_by_u_by_T + v2_2_on_boundary_by_w_by_T + x2_2_on_boundary_by_y_by_T;
        }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                NONSMOOTH_SIMD
                for (int lane = 0; lane < lanes; ++lane)
                    size[lane] += matrix[i][j][lane] * matrix[i][j][lane];
        for (int k = 0; k < n; ++k) {
            for (int i = k + 1; i < n; ++i) {
                double other[lanes];
                for (int lane = 0; lane < lanes; ++lane)
                    other[lane] = fabs(matrix[i][k][lane]) - fabs(matrix[k][k][lane]);
                for (int j = k; j < width; ++j)
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane) {
                        const double above = matrix[k][j][lane], below = matrix[i][j][lane];
                        matrix[k][j][lane] = other[lane] > 0.0 ? below : above;
                        matrix[i][j][lane] = other[lane] > 0.0 ? above : below;
                    }
            }
            NONSMOOTH_SIMD
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
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[i][j][lane] -= factor[lane] * matrix[k][j][lane];
            }
        }
        for (int k = n - 1; k >= 0; --k)
            for (int j = n; j < width; ++j) {
                for (int l = k + 1; l < n; ++l)
                    NONSMOOTH_SIMD
                    for (int lane = 0; lane < lanes; ++lane)
                        matrix[k][j][lane] -= matrix[k][l][lane] * matrix[l][j][lane];
                NONSMOOTH_SIMD
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
