/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation ac22722cc176f8d2 */
#include "elastic_stop.h"

#include <math.h>

#include "support.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Takes parameters (5); gives spectrum (12), derivatives (12, 5), row by row.
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
 * Takes parameters (5), spectrum (12), time, state (4); gives state_after (4), row by row.
 * Operations: 133. Intermediate terms: 25. */
void elastic_stop_flow_contact(
    const double parameters[5], const double spectrum[12], double time, const double state[4], double state_after[4])
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
 * Takes parameters (5), spectrum (12), time, state (4); gives state_after (4), row by row.
 * Operations: 82. Intermediate terms: 16. */
void elastic_stop_flow_free(
    const double parameters[5], const double spectrum[12], double time, const double state[4], double state_after[4])
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
 * Takes parameters (5); gives fields (8, 5), row by row.
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
 * Takes parameters (5); gives rows (5, 5), row by row.
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
 * Takes parameters (5); gives resets (4, 5), row by row.
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
 * Takes parameters (5), spectrum (12); gives exponents (6, 2), coefficients (40, 5), row by row.
 * Operations: 104. Intermediate terms: 20. */
void elastic_stop_modes(
    const double parameters[5], const double spectrum[12], double exponents[12], double coefficients[200])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives residual (4), row by row.
 * Operations: 121. Intermediate terms: 37. */
void elastic_stop_one_contact_residual(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double residual[4])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives jacobian (4, 4), row by row.
 * Operations: 194. Intermediate terms: 56. */
void elastic_stop_one_contact_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double jacobian[16])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives residual (4), jacobian (4, 4), row by row.
 * Operations: 219. Intermediate terms: 71. */
void elastic_stop_one_contact_residual_and_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double residual[4], double jacobian[16])
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
 * Takes parameters (6), spectrum (12), spectrum_derivatives (12, 5), unknowns (4); gives parameter_jacobian (4, 6), row by row.
 * Operations: 655. Intermediate terms: 170. */
void elastic_stop_one_contact_parameter_jacobian(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60], const double unknowns[4], double parameter_jacobian[24])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives poincare_jacobian (3, 3), row by row.
 * Operations: 372. Intermediate terms: 127. */
void elastic_stop_one_contact_poincare_jacobian(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double poincare_jacobian[9])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives saltations (8, 4), row by row.
 * Operations: 239. Intermediate terms: 63. */
void elastic_stop_one_contact_saltations(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double saltations[32])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives monodromy (4, 4), row by row.
 * Operations: 395. Intermediate terms: 135. */
void elastic_stop_one_contact_monodromy(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double monodromy[16])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives trace, row by row.
 * Operations: 320. Intermediate terms: 113. */
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
 * Takes parameters (6), spectrum (12), spectrum_derivatives (12, 5), unknowns (4); gives trace_gradient (10), row by row.
 * Operations: 1643. Intermediate terms: 317. */
void elastic_stop_one_contact_trace_gradient(
    const double parameters[6], const double spectrum[12], const double spectrum_derivatives[60], const double unknowns[4], double trace_gradient[10])
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
    const double t17 = p1*sin_omega1_tau;
    const double t18 = (1.0/(omega2));
    const double t20 = -sin_omega2_tau*t14;
    const double t21 = t16*t17 + t18*t20;
    const double t22 = sin_omega2_tau*t18;
    const double t23 = p2*sin_omega1_tau*t16 - p2*t22;
    const double t24 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
    const double t25 = cos_omega1_tau*p1 - cos_omega2_tau*t14;
    const double x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t23*w + t24*y + t25;
    const double t26 = p3*t10;
    const double t28 = t11*t14 - t26;
    const double t29 = p1*t11;
    const double t30 = -t26 + t29;
    const double t31 = p3*sin_omega2_tau;
    const double t32 = p3*sin_omega1_tau*t16 - t18*t31;
    const double t33 = p1*t22 - sin_omega1_tau*t14*t16;
    const double t34 = -cos_omega1_tau*t14 + cos_omega2_tau*p1;
    const double t35 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
    const double x2_1 = cos_omega1_tau*t28 - cos_omega2_tau*t30 + t11 + t32*u + t33*w + t34*y + t35;
    const double t36 = omega1*p1;
    const double t37 = omega1*t12 + t10*t36;
    const double t38 = omega2*t12 + omega2*t14*t7*t9;
    const double t39 = omega1*sin_omega1_tau;
    const double t40 = omega2*p2*sin_omega2_tau - p2*t39;
    const double t41 = -omega2*t14;
    const double v1_1 = -sin_omega1_tau*t36 + sin_omega1_tau*t37 - sin_omega2_tau*t38 - sin_omega2_tau*t41 + t24*w + t25*u + t40*y;
    const double t42 = omega1*p3;
    const double t43 = -t11*t14;
    const double t44 = omega1*t43 + t10*t42;
    const double t45 = omega2*p3;
    const double t46 = omega2*t29 - t10*t45;
    const double t47 = omega2*sin_omega2_tau;
    const double t48 = -p1*t47 + t14*t39;
    const double v2_1 = -sin_omega1_tau*t42 + sin_omega1_tau*t44 + sin_omega2_tau*t45 + sin_omega2_tau*t46 + t34*w + t35*u + t48*y;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t49 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t49);
    const double sin_omega3_tau1 = sin(t49);
    const double t52 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t52);
    const double sin_omega4_tau1 = sin(t52);
    /* free for tau1, until first-reaches-stop */
    const double t55 = (1.0/(omega3));
    const double t56 = sin_omega3_tau1*t55;
    const double t57 = 1 - p4;
    const double t58 = (1.0/(omega4));
    const double t59 = sin_omega4_tau1*t58;
    const double t60 = p4*t56 + t57*t59;
    const double t61 = p5*sin_omega3_tau1*t55 - p5*t59;
    const double t62 = cos_omega3_tau1*p4 + cos_omega4_tau1*t57;
    const double t63 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t60*v1_1 + t61*v2_1 + t62*x1_1 + t63*x2_1;
    const double t64 = p6*t59;
    const double t65 = p6*sin_omega3_tau1*t55 - t64;
    const double t66 = p4*t59 + t56*t57;
    const double t67 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t68 = cos_omega3_tau1*t57 + cos_omega4_tau1*p4;
    const double x2_2 = t65*v1_1 + t66*v2_1 + t67*x1_1 + t68*x2_1;
    const double t69 = omega3*sin_omega3_tau1;
    const double t70 = omega4*sin_omega4_tau1;
    const double t71 = p4*t69 + t57*t70;
    const double t73 = p5*t69;
    const double t74 = omega4*p5*sin_omega4_tau1 - t73;
    const double v1_2 = t62*v1_1 + t63*v2_1 - t71*x1_1 + t74*x2_1;
    const double t75 = p6*t69;
    const double t76 = omega4*p6*sin_omega4_tau1 - t75;
    const double t77 = p4*t70 + t57*t69;
    const double v2_2 = t67*v1_1 + t68*v2_1 + t76*x1_1 - t77*x2_1;
    /* Phi along tau */
    const double carried_x1_1_by_y = t24;
    const double carried_x1_1_by_u = t21;
    const double carried_x1_1_by_w = t23;
    const double carried_x2_1_by_y = t34;
    const double carried_x2_1_by_u = t32;
    const double carried_x2_1_by_w = t33;
    const double carried_v1_1_by_y = t40;
    const double carried_v1_1_by_u = t25;
    const double carried_v1_1_by_w = t24;
    const double carried_v2_1_by_y = t48;
    const double carried_v2_1_by_u = t35;
    const double carried_v2_1_by_w = t34;
    /* rate of the exit boundary after tau */
    const double rate_1 = -v1_1;
    /* derivatives of the time to the boundary after tau */
    const double t79 = (1.0/(rate_1));
    const double delay_tau_by_y = carried_x1_1_by_y*t79;
    const double delay_tau_by_u = carried_x1_1_by_u*t79;
    const double delay_tau_by_w = carried_x1_1_by_w*t79;
    /* perturbation on the boundary after tau */
    const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
    const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
    const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
    const double t80 = (1.0/(m1));
    const double t81 = k1 + k3;
    const double t82 = t80*x1_1;
    const double t83 = k1*t80*x2_1 + k3*t80 - t81*t82;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t83;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t83;
    const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t83;
    const double t84 = (1.0/(m2));
    const double t85 = t84*x1_1;
    const double t86 = k1 + k2;
    const double t87 = t84*x2_1;
    const double t88 = k1*t85 - t86*t87;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t88;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t88;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t88;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t60*v1_1_on_boundary_by_y + t61*v2_1_on_boundary_by_y + t62*x1_1_on_boundary_by_y + t63*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t60*v1_1_on_boundary_by_u + t61*v2_1_on_boundary_by_u + t62*x1_1_on_boundary_by_u + t63*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t60*v1_1_on_boundary_by_w + t61*v2_1_on_boundary_by_w + t62*x1_1_on_boundary_by_w + t63*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t89 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t89;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t89;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t89;
    /* back through: derivatives of the time to the boundary after tau1 */
    const double t90 = t84*x1_2;
    const double t91 = t84*x2_2;
    const double slope_by_delay_tau1_by_w = k1*t90 - t86*t91;
    const double t92 = t80*x1_2;
    const double slope_by_delay_tau1_by_u = k1*t80*x2_2 - k1*t92;
    /* back through: Phi along tau1 */
    const double slope_by_carried_x1_2_by_w = -slope_by_delay_tau1_by_w*t89;
    const double slope_by_carried_x1_2_by_u = -slope_by_delay_tau1_by_u*t89;
    const double slope_by_carried_x1_2_by_y = -t89*v2_2;
    /* back through: perturbation on the boundary after tau */
    const double slope_by_v2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t61 + t68;
    const double slope_by_v2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t61 + t63;
    const double slope_by_v2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t61 + t66;
    const double slope_by_v1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t60 + t67;
    const double slope_by_v1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t60 + t62;
    const double slope_by_v1_1_on_boundary_by_y = p6*t56 + slope_by_carried_x1_2_by_y*t60 - t64;
    const double slope_by_x2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t63 - t77;
    const double slope_by_x2_1_on_boundary_by_u = p5*t70 + slope_by_carried_x1_2_by_u*t63 - t73;
    const double slope_by_x2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t63 + t68;
    const double slope_by_x1_1_on_boundary_by_w = p6*t70 + slope_by_carried_x1_2_by_w*t62 - t75;
    const double slope_by_x1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t62 - t71;
    const double slope_by_x1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t62 + t67;
    /* back through: derivatives of the time to the boundary after tau */
    const double slope_by_delay_tau_by_w = slope_by_v1_1_on_boundary_by_w*t83 + slope_by_v2_1_on_boundary_by_w*t88 + slope_by_x1_1_on_boundary_by_w*v1_1 + slope_by_x2_1_on_boundary_by_w*v2_1;
    const double slope_by_delay_tau_by_u = slope_by_v1_1_on_boundary_by_u*t83 + slope_by_v2_1_on_boundary_by_u*t88 + slope_by_x1_1_on_boundary_by_u*v1_1 + slope_by_x2_1_on_boundary_by_u*v2_1;
    const double slope_by_delay_tau_by_y = slope_by_v1_1_on_boundary_by_y*t83 + slope_by_v2_1_on_boundary_by_y*t88 + slope_by_x1_1_on_boundary_by_y*v1_1 + slope_by_x2_1_on_boundary_by_y*v2_1;
    /* back through: rate of the exit boundary after tau */
    const double t93 = (1.0/(rate_1*rate_1));
    const double slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t93 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t93 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t93;
    /* back through: Phi along tau */
    const double slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t79 + slope_by_x1_1_on_boundary_by_w;
    const double slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t79 + slope_by_x1_1_on_boundary_by_u;
    const double slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t79 + slope_by_x1_1_on_boundary_by_y;
    /* back through: free for tau1, until first-reaches-stop */
    const double t94 = (1.0/(v1_2*v1_2));
    const double slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t94 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t94 + carried_x1_2_by_y*t94*v2_2;
    const double t95 = k1*t80;
    const double t96 = delay_tau1_by_u*t95;
    const double slope_by_x2_2 = -delay_tau1_by_w*t84*t86 + t96;
    const double slope_by_x1_2 = delay_tau1_by_w*k1*t84 - t96;
    /* back through: functions of tau1 in free */
    const double t97 = p4*x2_1;
    const double t98 = p5*v2_1_on_boundary_by_u;
    const double t99 = p5*t58;
    const double t100 = p5*x2_1;
    const double t101 = t57*x1_1;
    const double t102 = p5*v2_1;
    const double t103 = p4*v2_1;
    const double t104 = p6*v1_1;
    const double t105 = p4*v2_1_on_boundary_by_y;
    const double t106 = p5*x2_1_on_boundary_by_u;
    const double t107 = p6*x1_1_on_boundary_by_w;
    const double t108 = p4*x2_1_on_boundary_by_w;
    const double t109 = p6*v1_1_on_boundary_by_y;
    const double t110 = t57*x1_1_on_boundary_by_u;
    const double slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*p6*x1_1 - omega4*t97) + omega4*t106 + omega4*t107 - omega4*t108 - omega4*t110 + slope_by_carried_x1_2_by_u*(t57*t58*v1_1_on_boundary_by_u - t58*t98) + slope_by_carried_x1_2_by_w*(t57*t58*v1_1_on_boundary_by_w - t99*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t57*t58*v1_1_on_boundary_by_y - t99*v2_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t100 - omega4*t101) + slope_by_x1_2*(-t102*t58 + t57*t58*v1_1) + slope_by_x2_2*(t103*t58 - t104*t58) + t105*t58 - t109*t58;
    const double t111 = p5*x2_1_on_boundary_by_w;
    const double t112 = p5*x2_1_on_boundary_by_y;
    const double t113 = p6*x1_1;
    const double t114 = t57*v1_1_on_boundary_by_u;
    const double t115 = p6*v1_1_on_boundary_by_w;
    const double t116 = p6*x1_1_on_boundary_by_y;
    const double slope_by_cos_omega4_tau1 = delay_tau1_by_y*(t103 - t104) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(-t106 + t57*x1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t111 + t57*x1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t112 + t57*x1_1_on_boundary_by_y) + slope_by_v1_2*(-t102 + t57*v1_1) + slope_by_x1_2*(-t100 + t57*x1_1) + slope_by_x2_2*(-t113 + t97) + t114 - t115 - t116 - t98;
    const double t117 = t57*x2_1;
    const double t118 = p4*v1_1_on_boundary_by_u;
    const double t119 = p4*t55;
    const double t120 = p5*t55;
    const double t121 = p4*x1_1;
    const double t122 = p4*v1_1;
    const double t123 = t57*v2_1;
    const double t124 = t57*v2_1_on_boundary_by_y;
    const double t125 = p4*x1_1_on_boundary_by_u;
    const double t126 = t57*x2_1_on_boundary_by_w;
    const double slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t113 - omega3*t117) - omega3*t106 - omega3*t107 - omega3*t125 - omega3*t126 + slope_by_carried_x1_2_by_u*(t118*t55 + t55*t98) + slope_by_carried_x1_2_by_w*(t119*v1_1_on_boundary_by_w + t120*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t119*v1_1_on_boundary_by_y + t120*v2_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t100 - omega3*t121) + slope_by_x1_2*(t102*t55 + t122*t55) + slope_by_x2_2*(t104*t55 + t123*t55) + t109*t55 + t124*t55;
    const double slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t104 + t123) + slope_by_carried_x1_2_by_u*(t106 + t125) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t111) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t112) + slope_by_v1_2*(t102 + t122) + slope_by_x1_2*(t100 + t121) + slope_by_x2_2*(t113 + t117) + t115 + t116 + t118 + t57*v2_1_on_boundary_by_w + t57*x2_1_on_boundary_by_y + t98;
    /* back through: tau1 completes the period */
    const double t127 = sin_omega3_tau1*slope_by_cos_omega3_tau1;
    const double t128 = sin_omega4_tau1*slope_by_cos_omega4_tau1;
    const double slope_by_tau1 = cos_omega3_tau1*omega3*slope_by_sin_omega3_tau1 + cos_omega4_tau1*omega4*slope_by_sin_omega4_tau1 - omega3*t127 - omega4*t128;
    /* back through: contact for tau, until first-leaves-stop */
    const double slope_by_v2_1 = delay_tau1_by_y*t68 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t63 + slope_by_x1_2*t61 + slope_by_x2_2*t66;
    const double slope_by_v1_1 = delay_tau1_by_y*t67 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t62 + slope_by_x1_2*t60 + slope_by_x2_2*t65;
    const double t129 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u;
    const double t130 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w;
    const double t131 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y;
    const double t132 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u;
    const double t133 = t84*t86;
    const double t134 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w;
    const double t135 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y;
    const double slope_by_x2_1 = -delay_tau1_by_y*t77 + slope_by_v1_2*t74 + slope_by_x1_2*t63 + slope_by_x2_2*t68 + t129*t95 + t130*t95 + t131*t95 - t132*t133 - t133*t134 - t133*t135;
    const double t136 = k1*t84;
    const double t137 = t80*t81;
    const double slope_by_x1_1 = delay_tau1_by_y*t76 - slope_by_v1_2*t71 + slope_by_x1_2*t62 + slope_by_x2_2*t67 - t129*t137 - t130*t137 - t131*t137 + t132*t136 + t134*t136 + t135*t136;
    /* back through: functions of tau in contact */
    const double t138 = p1*y;
    const double t139 = p2*w;
    const double t140 = p1*w;
    const double t141 = p3*u;
    const double t142 = p1*slope_by_x2_1_on_boundary_by_w;
    const double t143 = p2*slope_by_v1_1_on_boundary_by_y;
    const double t144 = p1*slope_by_v2_1_on_boundary_by_y;
    const double t145 = p2*slope_by_carried_x1_1_by_w;
    const double t146 = p3*slope_by_x2_1_on_boundary_by_u;
    const double slope_by_sin_omega2_tau = omega2*t143 - omega2*t144 - slope_by_carried_x1_1_by_u*t14*t18 + slope_by_v1_1*(omega2*p2*y - t38 - t41) + slope_by_v2_1*(-omega2*t138 + t45 + t46) + slope_by_x1_1*(-t139*t18 - t14*t18*u) + slope_by_x2_1*(t140*t18 - t141*t18) + t142*t18 - t145*t18 - t146*t18;
    const double t147 = p2*y;
    const double t148 = -p1 - t147;
    const double t149 = p2*slope_by_carried_x1_1_by_y;
    const double t150 = p2*slope_by_v1_1_on_boundary_by_w;
    const double t151 = p3*slope_by_v2_1_on_boundary_by_u;
    const double slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t139 - t14*u) - slope_by_v1_1_on_boundary_by_u*t14 + slope_by_v2_1*(t140 - t141) + slope_by_x1_1*(t148 + t15 + 1) + slope_by_x2_1*(p1*y - p3 - t30) - t149 - t150 - t151;
    const double t152 = -t14*y;
    const double t153 = p1*u;
    const double t154 = -t14*w;
    const double t155 = -slope_by_x2_1_on_boundary_by_w*t14;
    const double t156 = -slope_by_v2_1_on_boundary_by_y*t14;
    const double slope_by_sin_omega1_tau = -omega1*t143 - omega1*t156 + p1*slope_by_carried_x1_1_by_u*t16 + slope_by_v1_1*(-omega1*t147 - t36 + t37) + slope_by_v2_1*(-omega1*t152 - t42 + t44) + slope_by_x1_1*(t139*t16 + t153*t16) + slope_by_x2_1*(t141*t16 + t154*t16) + t145*t16 + t146*t16 + t155*t16;
    const double slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t139 + t153) + slope_by_v2_1*(t141 + t154) - slope_by_v2_1_on_boundary_by_w*t14 + slope_by_x1_1*(-t13 - t148) + slope_by_x2_1*(p3 + t152 + t28) - slope_by_x2_1_on_boundary_by_y*t14 + t149 + t150 + t151;
    /* outputs */
    const double t157 = sin_omega1_tau*slope_by_cos_omega1_tau;
    const double t158 = sin_omega2_tau*slope_by_cos_omega2_tau;
    const double t159 = (1.0/(m1*m1));
    const double t160 = k1*t159;
    const double t161 = p3*sin_omega1_tau;
    const double t162 = (1.0/(omega1*omega1));
    const double t163 = sin_omega1_tau*t162;
    const double t164 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t143 - sin_omega1_tau*t156 - slope_by_carried_x1_1_by_u*t162*t17 + slope_by_v1_1*(sin_omega1_tau*t13 - sin_omega1_tau*t147 - t17) + slope_by_v2_1*(-sin_omega1_tau*t152 + sin_omega1_tau*(t26 + t43) - t161) + slope_by_x1_1*(-t139*t163 - t153*t163) + slope_by_x2_1*(-t141*t163 - t154*t163) - slope_by_x2_1_on_boundary_by_u*t161*t162 - t145*t163 - t155*t163 - t157*tau;
    const double t165 = (1.0/(omega2*omega2));
    const double t166 = sin_omega2_tau*t165;
    const double t167 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t143 - sin_omega2_tau*t144 - slope_by_carried_x1_1_by_u*t165*t20 + slope_by_v1_1*(sin_omega2_tau*t147 + sin_omega2_tau*(-t12 - t14*t7*t9) - t20) + slope_by_v2_1*(-sin_omega2_tau*t138 + sin_omega2_tau*t30 + t31) + slope_by_x1_1*(t139*t166 + t14*t166*u) + slope_by_x2_1*(p3*sin_omega2_tau*t165*u - t140*t166) + slope_by_x2_1_on_boundary_by_u*t165*t31 - t142*t166 + t145*t166 - t158*tau;
    const double t168 = sin_omega3_tau1/(omega3*omega3);
    const double t169 = p4*t168;
    const double t170 = p5*t168;
    const double t171 = cos_omega3_tau1*slope_by_sin_omega3_tau1*tau1 + delay_tau1_by_y*(-sin_omega3_tau1*t113 - sin_omega3_tau1*t117) - sin_omega3_tau1*t106 - sin_omega3_tau1*t107 - sin_omega3_tau1*t125 - sin_omega3_tau1*t126 + slope_by_carried_x1_2_by_u*(-t118*t168 - t168*t98) + slope_by_carried_x1_2_by_w*(-t169*v1_1_on_boundary_by_w - t170*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t169*v1_1_on_boundary_by_y - t170*v2_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t100 - sin_omega3_tau1*t121) + slope_by_x1_2*(-t102*t168 - t122*t168) + slope_by_x2_2*(-t104*t168 - t123*t168) - t109*t168 - t124*t168 - t127*tau1;
    const double t172 = (1.0/(omega4*omega4));
    const double t173 = sin_omega4_tau1*t172;
    const double t174 = p5*t173;
    const double t175 = t173*t57;
    const double t176 = cos_omega4_tau1*slope_by_sin_omega4_tau1*tau1 + delay_tau1_by_y*(p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t97) + sin_omega4_tau1*t106 + sin_omega4_tau1*t107 - sin_omega4_tau1*t108 - sin_omega4_tau1*t110 + slope_by_carried_x1_2_by_u*(-t114*t173 + t173*t98) + slope_by_carried_x1_2_by_w*(t174*v2_1_on_boundary_by_w - t175*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t174*v2_1_on_boundary_by_y - t175*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t100 - sin_omega4_tau1*t101) + slope_by_x1_2*(t102*t173 - t173*t57*v1_1) + slope_by_x2_2*(p6*sin_omega4_tau1*t172*v1_1 - t103*t173) - t105*t173 + t109*t173 - t128*tau1;
    const double t177 = -sin_omega1_tau*t16 + t22;
    const double t179 = cos_omega1_tau - cos_omega2_tau;
    const double t180 = t10*t39 - t10*t47 + t179*u - t39 + t47;
    const double t182 = t39 - t47;
    const double t183 = t11*t47;
    const double t184 = t11*t39;
    const double t185 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t177*u + t179;
    const double t186 = cos_omega1_tau*t11;
    const double t187 = cos_omega2_tau*t11;
    const double t188 = -slope_by_carried_x1_1_by_u*t177 + slope_by_v1_1*t180 + slope_by_v1_1_on_boundary_by_u*t179 + slope_by_v2_1*(-t179*w + t182*y + t183 - t184) - slope_by_v2_1_on_boundary_by_w*t179 + slope_by_v2_1_on_boundary_by_y*t182 + slope_by_x1_1*t185 + slope_by_x2_1*(t177*w - t179*y + t186 - t187) + slope_by_x2_1_on_boundary_by_w*t177 - slope_by_x2_1_on_boundary_by_y*t179;
    const double t190 = -slope_by_carried_x1_1_by_w*t177 + slope_by_carried_x1_1_by_y*t179 + slope_by_v1_1*(t179*w - t182*y - t183 + t184) + slope_by_v1_1_on_boundary_by_w*t179 - slope_by_v1_1_on_boundary_by_y*t182 + slope_by_x1_1*(-t177*w + t179*y - t186 + t187);
    const double t191 = slope_by_v2_1*t180 + slope_by_v2_1_on_boundary_by_u*t179 + slope_by_x2_1*t185 - slope_by_x2_1_on_boundary_by_u*t177;
    const double t192 = cos_omega3_tau1 - cos_omega4_tau1;
    const double t194 = t69 - t70;
    const double t195 = -sin_omega3_tau1*t55 + t59;
    const double t197 = t192*x1_1_on_boundary_by_y - t195*v1_1_on_boundary_by_y;
    const double t199 = t192*v1_1 - t194*x1_1;
    const double t200 = t192*x1_1 - t195*v1_1;
    const double t201 = delay_tau1_by_y*(-t192*v2_1 + t194*x2_1) + slope_by_carried_x1_2_by_u*(t192*x1_1_on_boundary_by_u - t195*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x1_1_on_boundary_by_w - t195*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t197 + slope_by_v1_2*t199 + slope_by_x1_2*t200 + slope_by_x2_2*(-t192*x2_1 + t195*v2_1) + t192*v1_1_on_boundary_by_u - t192*v2_1_on_boundary_by_w - t192*x2_1_on_boundary_by_y - t194*x1_1_on_boundary_by_u + t194*x2_1_on_boundary_by_w + t195*v2_1_on_boundary_by_y;
    const double t202 = slope_by_carried_x1_2_by_u*(t192*x2_1_on_boundary_by_u - t195*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x2_1_on_boundary_by_w - t195*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t192*x2_1_on_boundary_by_y - t195*v2_1_on_boundary_by_y) + slope_by_v1_2*(t192*v2_1 - t194*x2_1) + slope_by_x1_2*(t192*x2_1 - t195*v2_1) + t192*v2_1_on_boundary_by_u - t194*x2_1_on_boundary_by_u;
    const double t203 = delay_tau1_by_y*t199 + slope_by_x2_2*t200 + t192*v1_1_on_boundary_by_w - t194*x1_1_on_boundary_by_w + t197;
    const double t204 = -k3*t159 + t159*t81*x1_1 - t160*x2_1;
    const double t205 = (1.0/(m2*m2));
    const double t206 = k1*t205;
    const double t207 = t205*t86*x2_1 - t206*x1_1;
    const double t208 = k3*t9;
    const double t209 = t208*t36;
    const double t210 = p2*t208;
    const double t211 = -k2 - k3;
    const double t212 = (1.0/(t8*t8));
    const double t213 = t212*t7;
    const double t214 = t211*t213;
    const double t215 = t212*t6;
    const double t216 = t211*t215;
    const double t217 = p2*t216;
    const double t218 = t208*t42;
    const double t219 = -omega1*t14;
    const double t220 = p1*t208;
    const double t221 = t208*t45;
    const double t222 = p1*t216;
    const double t223 = t210 + t217;
    const double t224 = t14*t208;
    const double t225 = p3*t208;
    const double t226 = -p3*t214 - t225;
    const double t227 = t80*x2_1 - t82;
    const double t228 = t85 - t87;
    const double t230 = -t213*t81;
    const double t231 = -t215*t81;
    const double t232 = p2*t231;
    const double t233 = p3*t230 + t225;
    const double t234 = t86*t9;
    const double t235 = k1*t9;
    const double t236 = p2*t235;
    const double t238 = -t213*t86;
    const double t239 = -t215*t86;
    const double t240 = p2*t239;
    const double t241 = p1*t235;
    const double t242 = p1*t239;
    const double t243 = t236 + t240;
    const double t244 = -p3*t234 - p3*t238;
    const double t245 = t80 - t82;
    trace_gradient[0] = slope_by_v1_1*t40 + slope_by_v2_1*t48 + slope_by_x1_1*t24 + slope_by_x2_1*t34;
    trace_gradient[1] = slope_by_v1_1*t25 + slope_by_v2_1*t35 + slope_by_x1_1*t21 + slope_by_x2_1*t32;
    trace_gradient[2] = slope_by_v1_1*t24 + slope_by_v2_1*t34 + slope_by_x1_1*t23 + slope_by_x2_1*t33;
    trace_gradient[3] = cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t157 - omega2*t158 - slope_by_tau1;
    trace_gradient[4] = delay_tau1_by_u*(t160*x1_2 - t160*x2_2) + omega1_by_m1*t164 + omega2_by_m1*t167 + omega3_by_m1*t171 + omega4_by_m1*t176 + p1_by_m1*t188 + p2_by_m1*t190 + p3_by_m1*t191 + p4_by_m1*t201 + p5_by_m1*t202 + p6_by_m1*t203 + t129*t204 + t130*t204 + t131*t204;
    trace_gradient[5] = delay_tau1_by_w*(t205*t86*x2_2 - t206*x1_2) + omega1_by_m2*t164 + omega2_by_m2*t167 + omega3_by_m2*t171 + omega4_by_m2*t176 + p1_by_m2*t188 + p2_by_m2*t190 + p3_by_m2*t191 + p4_by_m2*t201 + p5_by_m2*t202 + p6_by_m2*t203 + t132*t207 + t134*t207 + t135*t207;
    trace_gradient[6] = delay_tau1_by_u*(t80*x2_2 - t92) + delay_tau1_by_w*(t90 - t91) + omega1_by_k1*t164 + omega2_by_k1*t167 + omega3_by_k1*t171 + omega4_by_k1*t176 + p1_by_k1*t188 + p2_by_k1*t190 + p3_by_k1*t191 + p4_by_k1*t201 + p5_by_k1*t202 + p6_by_k1*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t210 + omega1*t217 + t209 + t214*t36) + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t211*t212*t7 - omega2*t210 - omega2*t217)) + slope_by_v2_1*(sin_omega1_tau*(t208*t219 + t214*t42 + t216*t219 + t218) + sin_omega2_tau*(omega2*t220 + omega2*t222 - t214*t45 - t221)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t214 - t220 - t223) + cos_omega2_tau*(t14*t214 + t223 + t224) + t208 + t214) + slope_by_x2_1*(cos_omega1_tau*(t14*t216 + t224 + t226) + cos_omega2_tau*(-t220 - t222 - t226) + t208 + t216) + t129*t227 + t130*t227 + t131*t227 + t132*t228 + t134*t228 + t135*t228;
    trace_gradient[7] = -delay_tau1_by_w*t91 + omega1_by_k2*t164 + omega2_by_k2*t167 + omega3_by_k2*t171 + omega4_by_k2*t176 + p1_by_k2*t188 + p2_by_k2*t190 + p3_by_k2*t191 + p4_by_k2*t201 + p5_by_k2*t202 + p6_by_k2*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t232 + t209 + t230*t36) + sin_omega2_tau*(-omega2*t232 + t208*t41 + t230*t41)) + slope_by_v2_1*(sin_omega1_tau*(t218 + t219*t231 + t230*t42) + sin_omega2_tau*(-k1*k3*omega2*p1*t212*t81 - t221 - t230*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t230 - t220 - t232) + cos_omega2_tau*(t14*t230 + t224 + t232) + t208 + t230) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t14*t212*t81 - t233) + cos_omega2_tau*(-p1*t231 + t233) + t231) - t132*t87 - t134*t87 - t135*t87;
    trace_gradient[8] = omega1_by_k3*t164 + omega2_by_k3*t167 + omega3_by_k3*t171 + omega4_by_k3*t176 + p1_by_k3*t188 + p2_by_k3*t190 + p3_by_k3*t191 + p4_by_k3*t201 + p5_by_k3*t202 + p6_by_k3*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t236 + omega1*t240 + t234*t36 + t238*t36) + sin_omega2_tau*(omega2*t14*t212*t7*t86 - omega2*t14*t86*t9 - omega2*t236 - omega2*t240)) + slope_by_v2_1*(sin_omega1_tau*(t219*t235 + t219*t239 + t234*t42 + t238*t42) + sin_omega2_tau*(omega2*t241 + omega2*t242 - t234*t45 - t238*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t234 - p1*t238 - t243) + cos_omega2_tau*(t14*t234 + t14*t238 + t243) + t234 + t238) + slope_by_x2_1*(cos_omega1_tau*(t14*t235 + t14*t239 + t244) + cos_omega2_tau*(-t241 - t242 - t244) + t235 + t239) + t129*t245 + t130*t245 + t131*t245;
    trace_gradient[9] = slope_by_tau1;
}

/* State at the start and behind each transition, row by row.
 * Takes parameters (6), spectrum (12), unknowns (4); gives states (3, 4), row by row.
 * Operations: 211. Intermediate terms: 50. */
void elastic_stop_one_contact_states(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double states[12])
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
 * Takes parameters (6), spectrum (12), unknowns (4); gives coefficients (12), frequencies (4), row by row.
 * Operations: 164. Intermediate terms: 39. */
void elastic_stop_one_contact_boundary_functions(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double coefficients[12], double frequencies[4])
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
 * Takes parameters (6), spectrum (12), time, state (4); gives state_after (4), row by row.
 * Operations: 133. Intermediate terms: 25. */
void elastic_stop_one_contact_flow_contact(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4])
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
 * Takes parameters (6), spectrum (12), time, state (4); gives state_after (4), row by row.
 * Operations: 82. Intermediate terms: 16. */
void elastic_stop_one_contact_flow_free(
    const double parameters[6], const double spectrum[12], double time, const double state[4], double state_after[4])
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
 * Takes parameters (6), spectrum (12), reduced (1); gives residual (1), jacobian (1, 1), row by row.
 * Operations: 378. Intermediate terms: 122. */
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1], double residual[1], double jacobian[1])
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
 * Takes parameters (6), spectrum (12), reduced (1); gives unknowns (4), determinants (1), row by row.
 * Operations: 220. Intermediate terms: 71. */
void elastic_stop_one_contact_expand(
    const double parameters[6], const double spectrum[12], const double reduced[1], double unknowns[4], double determinants[1])
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

/* Newton's method on the reduced equations for `count` points.
 * Takes parameters (6) and guess (1: tau) of the points; gives unknowns (4), the
 * trace, the largest reduced residual, iterations and a status of each. Arrays hold columns:
 * entry i of a point stands at [i * count + point].
 * In one step a dwell time changes by a factor of four at most; a point has converged when
 * a whole step is below 1e-9 max(1, |x|).
 * Status: 0 converged, 1 not converged, 2 not finite, 3 a dwell time is not positive,
 * 5 the linear equations for the start are singular. */
NONSMOOTH_MULTIVERSION
void elastic_stop_one_contact_solve(
    ptrdiff_t count, const double *parameters, const double *guess, double *unknowns,
    double *trace, double *residual, int32_t *iterations, int32_t *status)
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
#pragma omp simd
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
#pragma omp simd
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
#pragma omp simd
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
            int32_t ending = ((result[3][lane] <= 0.0) | (parameter[5][lane] - result[3][lane] <= 0.0)) ? 3 : 0;
            ending = open[lane] != 0.0 ? 1 : ending;
            ending = finite == 0.0 ? ending : 2;
            ending = ((fabs(determinant/(sqrt(2*(p3*p3) + t140*t144*(t21*t21) + t141*t142*t144 + t143)*sqrt(t137 + t139*t140 + t139*t141 + t143)*sqrt((omega3*omega3*omega3*omega3)*t147/((omega3*omega3)*t146 + 1) + (omega4*omega4*omega4*omega4)*t147/((omega4*omega4)*t146 + 1) + (p4*p4) + t145 + (t31*t31)))) <= 1e-12)) ? 5 : ending;
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

/* Is each of `count` orbits a motion of the real system?
 * Takes parameters (6) and unknowns (4) for each, row by row. Gives the row of
 * the boundary that is crossed inside a phase (-1 none, -2 a dwell time is not positive, -3
 * data that are not finite), by how much, and how long after the start of the phase. */
void elastic_stop_one_contact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns,
    int32_t *boundary, double *excess, double *instant)
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
        int found = -1, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 1; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 2 && found == -1; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[1], floor[1], maximum[1], time[1];
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
        boundary[point] = found;
        excess[point] = most;
        instant[point] = when;
    }
}

/* Derivatives of the unknowns (4) and the trace by the parameters (6), at solutions of the
 * equations, for `count` points. Arrays hold columns: entry i of a point stands at
 * [i * count + point], and of the derivatives those by one parameter follow another.
 * NaN where the equations are singular: a pivot is below 1e-10 times the matrix. */
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
#pragma omp simd
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
#pragma omp simd
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
#pragma omp simd
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
            const double t17 = p1*sin_omega1_tau;
            const double t18 = (1.0/(omega2));
            const double t20 = -sin_omega2_tau*t14;
            const double t21 = t16*t17 + t18*t20;
            const double t22 = sin_omega2_tau*t18;
            const double t23 = p2*sin_omega1_tau*t16 - p2*t22;
            const double t24 = cos_omega1_tau*p2 - cos_omega2_tau*p2;
            const double t25 = cos_omega1_tau*p1 - cos_omega2_tau*t14;
            const double x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t23*w + t24*y + t25;
            const double t26 = p3*t10;
            const double t28 = t11*t14 - t26;
            const double t29 = p1*t11;
            const double t30 = -t26 + t29;
            const double t31 = p3*sin_omega2_tau;
            const double t32 = p3*sin_omega1_tau*t16 - t18*t31;
            const double t33 = p1*t22 - sin_omega1_tau*t14*t16;
            const double t34 = -cos_omega1_tau*t14 + cos_omega2_tau*p1;
            const double t35 = cos_omega1_tau*p3 - cos_omega2_tau*p3;
            const double x2_1 = cos_omega1_tau*t28 - cos_omega2_tau*t30 + t11 + t32*u + t33*w + t34*y + t35;
            const double t36 = omega1*p1;
            const double t37 = omega1*t12 + t10*t36;
            const double t38 = omega2*t12 + omega2*t14*t7*t9;
            const double t39 = omega1*sin_omega1_tau;
            const double t40 = omega2*p2*sin_omega2_tau - p2*t39;
            const double t41 = -omega2*t14;
            const double v1_1 = -sin_omega1_tau*t36 + sin_omega1_tau*t37 - sin_omega2_tau*t38 - sin_omega2_tau*t41 + t24*w + t25*u + t40*y;
            const double t42 = omega1*p3;
            const double t43 = -t11*t14;
            const double t44 = omega1*t43 + t10*t42;
            const double t45 = omega2*p3;
            const double t46 = omega2*t29 - t10*t45;
            const double t47 = omega2*sin_omega2_tau;
            const double t48 = -p1*t47 + t14*t39;
            const double v2_1 = -sin_omega1_tau*t42 + sin_omega1_tau*t44 + sin_omega2_tau*t45 + sin_omega2_tau*t46 + t34*w + t35*u + t48*y;
            /* tau1 completes the period */
            const double tau1 = T - tau;
            /* functions of tau1 in free */
            const double t49 = omega3*tau1;
            double sine_2, cosine_2;
            nonsmooth_sincos(t49, &sine_2, &cosine_2);
            const double cos_omega3_tau1 = cosine_2;
            const double sin_omega3_tau1 = sine_2;
            const double t52 = omega4*tau1;
            double sine_3, cosine_3;
            nonsmooth_sincos(t52, &sine_3, &cosine_3);
            const double cos_omega4_tau1 = cosine_3;
            const double sin_omega4_tau1 = sine_3;
            /* free for tau1, until first-reaches-stop */
            const double t55 = (1.0/(omega3));
            const double t56 = sin_omega3_tau1*t55;
            const double t57 = 1 - p4;
            const double t58 = (1.0/(omega4));
            const double t59 = sin_omega4_tau1*t58;
            const double t60 = p4*t56 + t57*t59;
            const double t61 = p5*sin_omega3_tau1*t55 - p5*t59;
            const double t62 = cos_omega3_tau1*p4 + cos_omega4_tau1*t57;
            const double t63 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
            const double x1_2 = t60*v1_1 + t61*v2_1 + t62*x1_1 + t63*x2_1;
            const double t64 = p6*t59;
            const double t65 = p6*sin_omega3_tau1*t55 - t64;
            const double t66 = p4*t59 + t56*t57;
            const double t67 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
            const double t68 = cos_omega3_tau1*t57 + cos_omega4_tau1*p4;
            const double x2_2 = t65*v1_1 + t66*v2_1 + t67*x1_1 + t68*x2_1;
            const double t69 = omega3*sin_omega3_tau1;
            const double t70 = omega4*sin_omega4_tau1;
            const double t71 = p4*t69 + t57*t70;
            const double t73 = p5*t69;
            const double t74 = omega4*p5*sin_omega4_tau1 - t73;
            const double v1_2 = t62*v1_1 + t63*v2_1 - t71*x1_1 + t74*x2_1;
            const double t75 = p6*t69;
            const double t76 = omega4*p6*sin_omega4_tau1 - t75;
            const double t77 = p4*t70 + t57*t69;
            const double v2_2 = t67*v1_1 + t68*v2_1 + t76*x1_1 - t77*x2_1;
            /* Phi along tau */
            const double carried_x1_1_by_y = t24;
            const double carried_x1_1_by_u = t21;
            const double carried_x1_1_by_w = t23;
            const double carried_x2_1_by_y = t34;
            const double carried_x2_1_by_u = t32;
            const double carried_x2_1_by_w = t33;
            const double carried_v1_1_by_y = t40;
            const double carried_v1_1_by_u = t25;
            const double carried_v1_1_by_w = t24;
            const double carried_v2_1_by_y = t48;
            const double carried_v2_1_by_u = t35;
            const double carried_v2_1_by_w = t34;
            /* rate of the exit boundary after tau */
            const double rate_1 = -v1_1;
            /* derivatives of the time to the boundary after tau */
            const double t79 = (1.0/(rate_1));
            const double delay_tau_by_y = carried_x1_1_by_y*t79;
            const double delay_tau_by_u = carried_x1_1_by_u*t79;
            const double delay_tau_by_w = carried_x1_1_by_w*t79;
            /* perturbation on the boundary after tau */
            const double x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1;
            const double x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1;
            const double x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1;
            const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1;
            const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1;
            const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1;
            const double t80 = (1.0/(m1));
            const double t81 = k1 + k3;
            const double t82 = t80*x1_1;
            const double t83 = k1*t80*x2_1 + k3*t80 - t81*t82;
            const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t83;
            const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t83;
            const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t83;
            const double t84 = (1.0/(m2));
            const double t85 = t84*x1_1;
            const double t86 = k1 + k2;
            const double t87 = t84*x2_1;
            const double t88 = k1*t85 - t86*t87;
            const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t88;
            const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t88;
            const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t88;
            /* Phi along tau1 */
            const double carried_x1_2_by_y = t60*v1_1_on_boundary_by_y + t61*v2_1_on_boundary_by_y + t62*x1_1_on_boundary_by_y + t63*x2_1_on_boundary_by_y;
            const double carried_x1_2_by_u = t60*v1_1_on_boundary_by_u + t61*v2_1_on_boundary_by_u + t62*x1_1_on_boundary_by_u + t63*x2_1_on_boundary_by_u;
            const double carried_x1_2_by_w = t60*v1_1_on_boundary_by_w + t61*v2_1_on_boundary_by_w + t62*x1_1_on_boundary_by_w + t63*x2_1_on_boundary_by_w;
            /* derivatives of the time to the boundary after tau1 */
            const double t89 = (1.0/(v1_2));
            const double delay_tau1_by_y = -carried_x1_2_by_y*t89;
            const double delay_tau1_by_u = -carried_x1_2_by_u*t89;
            const double delay_tau1_by_w = -carried_x1_2_by_w*t89;
            /* back through: derivatives of the time to the boundary after tau1 */
            const double t90 = t84*x1_2;
            const double t91 = t84*x2_2;
            const double slope_by_delay_tau1_by_w = k1*t90 - t86*t91;
            const double t92 = t80*x1_2;
            const double slope_by_delay_tau1_by_u = k1*t80*x2_2 - k1*t92;
            /* back through: Phi along tau1 */
            const double slope_by_carried_x1_2_by_w = -slope_by_delay_tau1_by_w*t89;
            const double slope_by_carried_x1_2_by_u = -slope_by_delay_tau1_by_u*t89;
            const double slope_by_carried_x1_2_by_y = -t89*v2_2;
            /* back through: perturbation on the boundary after tau */
            const double slope_by_v2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t61 + t68;
            const double slope_by_v2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t61 + t63;
            const double slope_by_v2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t61 + t66;
            const double slope_by_v1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t60 + t67;
            const double slope_by_v1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t60 + t62;
            const double slope_by_v1_1_on_boundary_by_y = p6*t56 + slope_by_carried_x1_2_by_y*t60 - t64;
            const double slope_by_x2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t63 - t77;
            const double slope_by_x2_1_on_boundary_by_u = p5*t70 + slope_by_carried_x1_2_by_u*t63 - t73;
            const double slope_by_x2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t63 + t68;
            const double slope_by_x1_1_on_boundary_by_w = p6*t70 + slope_by_carried_x1_2_by_w*t62 - t75;
            const double slope_by_x1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t62 - t71;
            const double slope_by_x1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t62 + t67;
            /* back through: derivatives of the time to the boundary after tau */
            const double slope_by_delay_tau_by_w = slope_by_v1_1_on_boundary_by_w*t83 + slope_by_v2_1_on_boundary_by_w*t88 + slope_by_x1_1_on_boundary_by_w*v1_1 + slope_by_x2_1_on_boundary_by_w*v2_1;
            const double slope_by_delay_tau_by_u = slope_by_v1_1_on_boundary_by_u*t83 + slope_by_v2_1_on_boundary_by_u*t88 + slope_by_x1_1_on_boundary_by_u*v1_1 + slope_by_x2_1_on_boundary_by_u*v2_1;
            const double slope_by_delay_tau_by_y = slope_by_v1_1_on_boundary_by_y*t83 + slope_by_v2_1_on_boundary_by_y*t88 + slope_by_x1_1_on_boundary_by_y*v1_1 + slope_by_x2_1_on_boundary_by_y*v2_1;
            /* back through: rate of the exit boundary after tau */
            const double t93 = (1.0/(rate_1*rate_1));
            const double slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t93 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t93 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t93;
            /* back through: Phi along tau */
            const double slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t79 + slope_by_x1_1_on_boundary_by_w;
            const double slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t79 + slope_by_x1_1_on_boundary_by_u;
            const double slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t79 + slope_by_x1_1_on_boundary_by_y;
            /* back through: free for tau1, until first-reaches-stop */
            const double t94 = (1.0/(v1_2*v1_2));
            const double slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t94 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t94 + carried_x1_2_by_y*t94*v2_2;
            const double t95 = k1*t80;
            const double t96 = delay_tau1_by_u*t95;
            const double slope_by_x2_2 = -delay_tau1_by_w*t84*t86 + t96;
            const double slope_by_x1_2 = delay_tau1_by_w*k1*t84 - t96;
            /* back through: functions of tau1 in free */
            const double t97 = p4*x2_1;
            const double t98 = p5*v2_1_on_boundary_by_u;
            const double t99 = p5*t58;
            const double t100 = p5*x2_1;
            const double t101 = t57*x1_1;
            const double t102 = p5*v2_1;
            const double t103 = p4*v2_1;
            const double t104 = p6*v1_1;
            const double t105 = p4*v2_1_on_boundary_by_y;
            const double t106 = p5*x2_1_on_boundary_by_u;
            const double t107 = p6*x1_1_on_boundary_by_w;
            const double t108 = p4*x2_1_on_boundary_by_w;
            const double t109 = p6*v1_1_on_boundary_by_y;
            const double t110 = t57*x1_1_on_boundary_by_u;
            const double slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*p6*x1_1 - omega4*t97) + omega4*t106 + omega4*t107 - omega4*t108 - omega4*t110 + slope_by_carried_x1_2_by_u*(t57*t58*v1_1_on_boundary_by_u - t58*t98) + slope_by_carried_x1_2_by_w*(t57*t58*v1_1_on_boundary_by_w - t99*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t57*t58*v1_1_on_boundary_by_y - t99*v2_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t100 - omega4*t101) + slope_by_x1_2*(-t102*t58 + t57*t58*v1_1) + slope_by_x2_2*(t103*t58 - t104*t58) + t105*t58 - t109*t58;
            const double t111 = p5*x2_1_on_boundary_by_w;
            const double t112 = p5*x2_1_on_boundary_by_y;
            const double t113 = p6*x1_1;
            const double t114 = t57*v1_1_on_boundary_by_u;
            const double t115 = p6*v1_1_on_boundary_by_w;
            const double t116 = p6*x1_1_on_boundary_by_y;
            const double slope_by_cos_omega4_tau1 = delay_tau1_by_y*(t103 - t104) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(-t106 + t57*x1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t111 + t57*x1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t112 + t57*x1_1_on_boundary_by_y) + slope_by_v1_2*(-t102 + t57*v1_1) + slope_by_x1_2*(-t100 + t57*x1_1) + slope_by_x2_2*(-t113 + t97) + t114 - t115 - t116 - t98;
            const double t117 = t57*x2_1;
            const double t118 = p4*v1_1_on_boundary_by_u;
            const double t119 = p4*t55;
            const double t120 = p5*t55;
            const double t121 = p4*x1_1;
            const double t122 = p4*v1_1;
            const double t123 = t57*v2_1;
            const double t124 = t57*v2_1_on_boundary_by_y;
            const double t125 = p4*x1_1_on_boundary_by_u;
            const double t126 = t57*x2_1_on_boundary_by_w;
            const double slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t113 - omega3*t117) - omega3*t106 - omega3*t107 - omega3*t125 - omega3*t126 + slope_by_carried_x1_2_by_u*(t118*t55 + t55*t98) + slope_by_carried_x1_2_by_w*(t119*v1_1_on_boundary_by_w + t120*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t119*v1_1_on_boundary_by_y + t120*v2_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t100 - omega3*t121) + slope_by_x1_2*(t102*t55 + t122*t55) + slope_by_x2_2*(t104*t55 + t123*t55) + t109*t55 + t124*t55;
            const double slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t104 + t123) + slope_by_carried_x1_2_by_u*(t106 + t125) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t111) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t112) + slope_by_v1_2*(t102 + t122) + slope_by_x1_2*(t100 + t121) + slope_by_x2_2*(t113 + t117) + t115 + t116 + t118 + t57*v2_1_on_boundary_by_w + t57*x2_1_on_boundary_by_y + t98;
            /* back through: tau1 completes the period */
            const double t127 = sin_omega3_tau1*slope_by_cos_omega3_tau1;
            const double t128 = sin_omega4_tau1*slope_by_cos_omega4_tau1;
            const double slope_by_tau1 = cos_omega3_tau1*omega3*slope_by_sin_omega3_tau1 + cos_omega4_tau1*omega4*slope_by_sin_omega4_tau1 - omega3*t127 - omega4*t128;
            /* back through: contact for tau, until first-leaves-stop */
            const double slope_by_v2_1 = delay_tau1_by_y*t68 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t63 + slope_by_x1_2*t61 + slope_by_x2_2*t66;
            const double slope_by_v1_1 = delay_tau1_by_y*t67 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t62 + slope_by_x1_2*t60 + slope_by_x2_2*t65;
            const double t129 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u;
            const double t130 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w;
            const double t131 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y;
            const double t132 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u;
            const double t133 = t84*t86;
            const double t134 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w;
            const double t135 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y;
            const double slope_by_x2_1 = -delay_tau1_by_y*t77 + slope_by_v1_2*t74 + slope_by_x1_2*t63 + slope_by_x2_2*t68 + t129*t95 + t130*t95 + t131*t95 - t132*t133 - t133*t134 - t133*t135;
            const double t136 = k1*t84;
            const double t137 = t80*t81;
            const double slope_by_x1_1 = delay_tau1_by_y*t76 - slope_by_v1_2*t71 + slope_by_x1_2*t62 + slope_by_x2_2*t67 - t129*t137 - t130*t137 - t131*t137 + t132*t136 + t134*t136 + t135*t136;
            /* back through: functions of tau in contact */
            const double t138 = p1*y;
            const double t139 = p2*w;
            const double t140 = p1*w;
            const double t141 = p3*u;
            const double t142 = p1*slope_by_x2_1_on_boundary_by_w;
            const double t143 = p2*slope_by_v1_1_on_boundary_by_y;
            const double t144 = p1*slope_by_v2_1_on_boundary_by_y;
            const double t145 = p2*slope_by_carried_x1_1_by_w;
            const double t146 = p3*slope_by_x2_1_on_boundary_by_u;
            const double slope_by_sin_omega2_tau = omega2*t143 - omega2*t144 - slope_by_carried_x1_1_by_u*t14*t18 + slope_by_v1_1*(omega2*p2*y - t38 - t41) + slope_by_v2_1*(-omega2*t138 + t45 + t46) + slope_by_x1_1*(-t139*t18 - t14*t18*u) + slope_by_x2_1*(t140*t18 - t141*t18) + t142*t18 - t145*t18 - t146*t18;
            const double t147 = p2*y;
            const double t148 = -p1 - t147;
            const double t149 = p2*slope_by_carried_x1_1_by_y;
            const double t150 = p2*slope_by_v1_1_on_boundary_by_w;
            const double t151 = p3*slope_by_v2_1_on_boundary_by_u;
            const double slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t139 - t14*u) - slope_by_v1_1_on_boundary_by_u*t14 + slope_by_v2_1*(t140 - t141) + slope_by_x1_1*(t148 + t15 + 1) + slope_by_x2_1*(p1*y - p3 - t30) - t149 - t150 - t151;
            const double t152 = -t14*y;
            const double t153 = p1*u;
            const double t154 = -t14*w;
            const double t155 = -slope_by_x2_1_on_boundary_by_w*t14;
            const double t156 = -slope_by_v2_1_on_boundary_by_y*t14;
            const double slope_by_sin_omega1_tau = -omega1*t143 - omega1*t156 + p1*slope_by_carried_x1_1_by_u*t16 + slope_by_v1_1*(-omega1*t147 - t36 + t37) + slope_by_v2_1*(-omega1*t152 - t42 + t44) + slope_by_x1_1*(t139*t16 + t153*t16) + slope_by_x2_1*(t141*t16 + t154*t16) + t145*t16 + t146*t16 + t155*t16;
            const double slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t139 + t153) + slope_by_v2_1*(t141 + t154) - slope_by_v2_1_on_boundary_by_w*t14 + slope_by_x1_1*(-t13 - t148) + slope_by_x2_1*(p3 + t152 + t28) - slope_by_x2_1_on_boundary_by_y*t14 + t149 + t150 + t151;
            /* outputs */
            const double t157 = sin_omega1_tau*slope_by_cos_omega1_tau;
            const double t158 = sin_omega2_tau*slope_by_cos_omega2_tau;
            const double t159 = (1.0/(m1*m1));
            const double t160 = k1*t159;
            const double t161 = p3*sin_omega1_tau;
            const double t162 = (1.0/(omega1*omega1));
            const double t163 = sin_omega1_tau*t162;
            const double t164 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t143 - sin_omega1_tau*t156 - slope_by_carried_x1_1_by_u*t162*t17 + slope_by_v1_1*(sin_omega1_tau*t13 - sin_omega1_tau*t147 - t17) + slope_by_v2_1*(-sin_omega1_tau*t152 + sin_omega1_tau*(t26 + t43) - t161) + slope_by_x1_1*(-t139*t163 - t153*t163) + slope_by_x2_1*(-t141*t163 - t154*t163) - slope_by_x2_1_on_boundary_by_u*t161*t162 - t145*t163 - t155*t163 - t157*tau;
            const double t165 = (1.0/(omega2*omega2));
            const double t166 = sin_omega2_tau*t165;
            const double t167 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t143 - sin_omega2_tau*t144 - slope_by_carried_x1_1_by_u*t165*t20 + slope_by_v1_1*(sin_omega2_tau*t147 + sin_omega2_tau*(-t12 - t14*t7*t9) - t20) + slope_by_v2_1*(-sin_omega2_tau*t138 + sin_omega2_tau*t30 + t31) + slope_by_x1_1*(t139*t166 + t14*t166*u) + slope_by_x2_1*(p3*sin_omega2_tau*t165*u - t140*t166) + slope_by_x2_1_on_boundary_by_u*t165*t31 - t142*t166 + t145*t166 - t158*tau;
            const double t168 = sin_omega3_tau1/(omega3*omega3);
            const double t169 = p4*t168;
            const double t170 = p5*t168;
            const double t171 = cos_omega3_tau1*slope_by_sin_omega3_tau1*tau1 + delay_tau1_by_y*(-sin_omega3_tau1*t113 - sin_omega3_tau1*t117) - sin_omega3_tau1*t106 - sin_omega3_tau1*t107 - sin_omega3_tau1*t125 - sin_omega3_tau1*t126 + slope_by_carried_x1_2_by_u*(-t118*t168 - t168*t98) + slope_by_carried_x1_2_by_w*(-t169*v1_1_on_boundary_by_w - t170*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t169*v1_1_on_boundary_by_y - t170*v2_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t100 - sin_omega3_tau1*t121) + slope_by_x1_2*(-t102*t168 - t122*t168) + slope_by_x2_2*(-t104*t168 - t123*t168) - t109*t168 - t124*t168 - t127*tau1;
            const double t172 = (1.0/(omega4*omega4));
            const double t173 = sin_omega4_tau1*t172;
            const double t174 = p5*t173;
            const double t175 = t173*t57;
            const double t176 = cos_omega4_tau1*slope_by_sin_omega4_tau1*tau1 + delay_tau1_by_y*(p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t97) + sin_omega4_tau1*t106 + sin_omega4_tau1*t107 - sin_omega4_tau1*t108 - sin_omega4_tau1*t110 + slope_by_carried_x1_2_by_u*(-t114*t173 + t173*t98) + slope_by_carried_x1_2_by_w*(t174*v2_1_on_boundary_by_w - t175*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t174*v2_1_on_boundary_by_y - t175*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t100 - sin_omega4_tau1*t101) + slope_by_x1_2*(t102*t173 - t173*t57*v1_1) + slope_by_x2_2*(p6*sin_omega4_tau1*t172*v1_1 - t103*t173) - t105*t173 + t109*t173 - t128*tau1;
            const double t177 = -sin_omega1_tau*t16 + t22;
            const double t179 = cos_omega1_tau - cos_omega2_tau;
            const double t180 = t10*t39 - t10*t47 + t179*u - t39 + t47;
            const double t182 = t39 - t47;
            const double t183 = t11*t47;
            const double t184 = t11*t39;
            const double t185 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t177*u + t179;
            const double t186 = cos_omega1_tau*t11;
            const double t187 = cos_omega2_tau*t11;
            const double t188 = -slope_by_carried_x1_1_by_u*t177 + slope_by_v1_1*t180 + slope_by_v1_1_on_boundary_by_u*t179 + slope_by_v2_1*(-t179*w + t182*y + t183 - t184) - slope_by_v2_1_on_boundary_by_w*t179 + slope_by_v2_1_on_boundary_by_y*t182 + slope_by_x1_1*t185 + slope_by_x2_1*(t177*w - t179*y + t186 - t187) + slope_by_x2_1_on_boundary_by_w*t177 - slope_by_x2_1_on_boundary_by_y*t179;
            const double t190 = -slope_by_carried_x1_1_by_w*t177 + slope_by_carried_x1_1_by_y*t179 + slope_by_v1_1*(t179*w - t182*y - t183 + t184) + slope_by_v1_1_on_boundary_by_w*t179 - slope_by_v1_1_on_boundary_by_y*t182 + slope_by_x1_1*(-t177*w + t179*y - t186 + t187);
            const double t191 = slope_by_v2_1*t180 + slope_by_v2_1_on_boundary_by_u*t179 + slope_by_x2_1*t185 - slope_by_x2_1_on_boundary_by_u*t177;
            const double t192 = cos_omega3_tau1 - cos_omega4_tau1;
            const double t194 = t69 - t70;
            const double t195 = -sin_omega3_tau1*t55 + t59;
            const double t197 = t192*x1_1_on_boundary_by_y - t195*v1_1_on_boundary_by_y;
            const double t199 = t192*v1_1 - t194*x1_1;
            const double t200 = t192*x1_1 - t195*v1_1;
            const double t201 = delay_tau1_by_y*(-t192*v2_1 + t194*x2_1) + slope_by_carried_x1_2_by_u*(t192*x1_1_on_boundary_by_u - t195*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x1_1_on_boundary_by_w - t195*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t197 + slope_by_v1_2*t199 + slope_by_x1_2*t200 + slope_by_x2_2*(-t192*x2_1 + t195*v2_1) + t192*v1_1_on_boundary_by_u - t192*v2_1_on_boundary_by_w - t192*x2_1_on_boundary_by_y - t194*x1_1_on_boundary_by_u + t194*x2_1_on_boundary_by_w + t195*v2_1_on_boundary_by_y;
            const double t202 = slope_by_carried_x1_2_by_u*(t192*x2_1_on_boundary_by_u - t195*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x2_1_on_boundary_by_w - t195*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t192*x2_1_on_boundary_by_y - t195*v2_1_on_boundary_by_y) + slope_by_v1_2*(t192*v2_1 - t194*x2_1) + slope_by_x1_2*(t192*x2_1 - t195*v2_1) + t192*v2_1_on_boundary_by_u - t194*x2_1_on_boundary_by_u;
            const double t203 = delay_tau1_by_y*t199 + slope_by_x2_2*t200 + t192*v1_1_on_boundary_by_w - t194*x1_1_on_boundary_by_w + t197;
            const double t204 = -k3*t159 + t159*t81*x1_1 - t160*x2_1;
            const double t205 = (1.0/(m2*m2));
            const double t206 = k1*t205;
            const double t207 = t205*t86*x2_1 - t206*x1_1;
            const double t208 = k3*t9;
            const double t209 = t208*t36;
            const double t210 = p2*t208;
            const double t211 = -k2 - k3;
            const double t212 = (1.0/(t8*t8));
            const double t213 = t212*t7;
            const double t214 = t211*t213;
            const double t215 = t212*t6;
            const double t216 = t211*t215;
            const double t217 = p2*t216;
            const double t218 = t208*t42;
            const double t219 = -omega1*t14;
            const double t220 = p1*t208;
            const double t221 = t208*t45;
            const double t222 = p1*t216;
            const double t223 = t210 + t217;
            const double t224 = t14*t208;
            const double t225 = p3*t208;
            const double t226 = -p3*t214 - t225;
            const double t227 = t80*x2_1 - t82;
            const double t228 = t85 - t87;
            const double t230 = -t213*t81;
            const double t231 = -t215*t81;
            const double t232 = p2*t231;
            const double t233 = p3*t230 + t225;
            const double t234 = t86*t9;
            const double t235 = k1*t9;
            const double t236 = p2*t235;
            const double t238 = -t213*t86;
            const double t239 = -t215*t86;
            const double t240 = p2*t239;
            const double t241 = p1*t235;
            const double t242 = p1*t239;
            const double t243 = t236 + t240;
            const double t244 = -p3*t234 - p3*t238;
            const double t245 = t80 - t82;
            slope[0][lane] = slope_by_v1_1*t40 + slope_by_v2_1*t48 + slope_by_x1_1*t24 + slope_by_x2_1*t34;
            slope[1][lane] = slope_by_v1_1*t25 + slope_by_v2_1*t35 + slope_by_x1_1*t21 + slope_by_x2_1*t32;
            slope[2][lane] = slope_by_v1_1*t24 + slope_by_v2_1*t34 + slope_by_x1_1*t23 + slope_by_x2_1*t33;
            slope[3][lane] = cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t157 - omega2*t158 - slope_by_tau1;
            slope[4][lane] = delay_tau1_by_u*(t160*x1_2 - t160*x2_2) + omega1_by_m1*t164 + omega2_by_m1*t167 + omega3_by_m1*t171 + omega4_by_m1*t176 + p1_by_m1*t188 + p2_by_m1*t190 + p3_by_m1*t191 + p4_by_m1*t201 + p5_by_m1*t202 + p6_by_m1*t203 + t129*t204 + t130*t204 + t131*t204;
            slope[5][lane] = delay_tau1_by_w*(t205*t86*x2_2 - t206*x1_2) + omega1_by_m2*t164 + omega2_by_m2*t167 + omega3_by_m2*t171 + omega4_by_m2*t176 + p1_by_m2*t188 + p2_by_m2*t190 + p3_by_m2*t191 + p4_by_m2*t201 + p5_by_m2*t202 + p6_by_m2*t203 + t132*t207 + t134*t207 + t135*t207;
            slope[6][lane] = delay_tau1_by_u*(t80*x2_2 - t92) + delay_tau1_by_w*(t90 - t91) + omega1_by_k1*t164 + omega2_by_k1*t167 + omega3_by_k1*t171 + omega4_by_k1*t176 + p1_by_k1*t188 + p2_by_k1*t190 + p3_by_k1*t191 + p4_by_k1*t201 + p5_by_k1*t202 + p6_by_k1*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t210 + omega1*t217 + t209 + t214*t36) + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t211*t212*t7 - omega2*t210 - omega2*t217)) + slope_by_v2_1*(sin_omega1_tau*(t208*t219 + t214*t42 + t216*t219 + t218) + sin_omega2_tau*(omega2*t220 + omega2*t222 - t214*t45 - t221)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t214 - t220 - t223) + cos_omega2_tau*(t14*t214 + t223 + t224) + t208 + t214) + slope_by_x2_1*(cos_omega1_tau*(t14*t216 + t224 + t226) + cos_omega2_tau*(-t220 - t222 - t226) + t208 + t216) + t129*t227 + t130*t227 + t131*t227 + t132*t228 + t134*t228 + t135*t228;
            slope[7][lane] = -delay_tau1_by_w*t91 + omega1_by_k2*t164 + omega2_by_k2*t167 + omega3_by_k2*t171 + omega4_by_k2*t176 + p1_by_k2*t188 + p2_by_k2*t190 + p3_by_k2*t191 + p4_by_k2*t201 + p5_by_k2*t202 + p6_by_k2*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t232 + t209 + t230*t36) + sin_omega2_tau*(-omega2*t232 + t208*t41 + t230*t41)) + slope_by_v2_1*(sin_omega1_tau*(t218 + t219*t231 + t230*t42) + sin_omega2_tau*(-k1*k3*omega2*p1*t212*t81 - t221 - t230*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t230 - t220 - t232) + cos_omega2_tau*(t14*t230 + t224 + t232) + t208 + t230) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t14*t212*t81 - t233) + cos_omega2_tau*(-p1*t231 + t233) + t231) - t132*t87 - t134*t87 - t135*t87;
            slope[8][lane] = omega1_by_k3*t164 + omega2_by_k3*t167 + omega3_by_k3*t171 + omega4_by_k3*t176 + p1_by_k3*t188 + p2_by_k3*t190 + p3_by_k3*t191 + p4_by_k3*t201 + p5_by_k3*t202 + p6_by_k3*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t236 + omega1*t240 + t234*t36 + t238*t36) + sin_omega2_tau*(omega2*t14*t212*t7*t86 - omega2*t14*t86*t9 - omega2*t236 - omega2*t240)) + slope_by_v2_1*(sin_omega1_tau*(t219*t235 + t219*t239 + t234*t42 + t238*t42) + sin_omega2_tau*(omega2*t241 + omega2*t242 - t234*t45 - t238*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t234 - p1*t238 - t243) + cos_omega2_tau*(t14*t234 + t14*t238 + t243) + t234 + t238) + slope_by_x2_1*(cos_omega1_tau*(t14*t235 + t14*t239 + t244) + cos_omega2_tau*(-t241 - t242 - t244) + t235 + t239) + t129*t245 + t130*t245 + t131*t245;
            slope[9][lane] = slope_by_tau1;
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
