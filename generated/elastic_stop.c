/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.elastic_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation 4ac3f6d86542e342 */
#include "elastic_stop.h"

#include <math.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_elimination.h"
#include "nonsmooth_lanes.h"
#include "nonsmooth_newton.h"
#include "nonsmooth_sums.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 310. Intermediate terms: 144. */
static NONSMOOTH_INLINE void elastic_stop_spectrum_in_lane(
    int lanes, int lane, const double *parameters, double *spectrum, double *spectrum_derivatives)
{
    const double k1 = parameters[lane];
    const double k2 = parameters[1*lanes + lane];
    const double k3 = parameters[2*lanes + lane];
    const double m1 = parameters[3*lanes + lane];
    const double m2 = parameters[4*lanes + lane];
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
    if (spectrum_derivatives) {
        spectrum_derivatives[lane] = gap1_by_k1;
        spectrum_derivatives[1*lanes + lane] = gap1_by_k2;
        spectrum_derivatives[2*lanes + lane] = gap1_by_k3;
        spectrum_derivatives[3*lanes + lane] = gap1_by_m1;
        spectrum_derivatives[4*lanes + lane] = gap1_by_m2;
        spectrum_derivatives[5*lanes + lane] = omega1_by_k1;
        spectrum_derivatives[6*lanes + lane] = omega1_by_k2;
        spectrum_derivatives[7*lanes + lane] = omega1_by_k3;
        spectrum_derivatives[8*lanes + lane] = omega1_by_m1;
        spectrum_derivatives[9*lanes + lane] = omega1_by_m2;
        spectrum_derivatives[10*lanes + lane] = omega2_by_k1;
        spectrum_derivatives[11*lanes + lane] = omega2_by_k2;
        spectrum_derivatives[12*lanes + lane] = omega2_by_k3;
        spectrum_derivatives[13*lanes + lane] = omega2_by_m1;
        spectrum_derivatives[14*lanes + lane] = omega2_by_m2;
        spectrum_derivatives[15*lanes + lane] = p1_by_k1;
        spectrum_derivatives[16*lanes + lane] = p1_by_k2;
        spectrum_derivatives[17*lanes + lane] = p1_by_k3;
        spectrum_derivatives[18*lanes + lane] = p1_by_m1;
        spectrum_derivatives[19*lanes + lane] = p1_by_m2;
        spectrum_derivatives[20*lanes + lane] = p2_by_k1;
        spectrum_derivatives[21*lanes + lane] = p2_by_k2;
        spectrum_derivatives[22*lanes + lane] = p2_by_k3;
        spectrum_derivatives[23*lanes + lane] = p2_by_m1;
        spectrum_derivatives[24*lanes + lane] = p2_by_m2;
        spectrum_derivatives[25*lanes + lane] = p3_by_k1;
        spectrum_derivatives[26*lanes + lane] = p3_by_k2;
        spectrum_derivatives[27*lanes + lane] = p3_by_k3;
        spectrum_derivatives[28*lanes + lane] = p3_by_m1;
        spectrum_derivatives[29*lanes + lane] = p3_by_m2;
        spectrum_derivatives[30*lanes + lane] = gap2_by_k1;
        spectrum_derivatives[31*lanes + lane] = gap2_by_k2;
        spectrum_derivatives[32*lanes + lane] = 0;
        spectrum_derivatives[33*lanes + lane] = gap2_by_m1;
        spectrum_derivatives[34*lanes + lane] = gap2_by_m2;
        spectrum_derivatives[35*lanes + lane] = omega3_by_k1;
        spectrum_derivatives[36*lanes + lane] = omega3_by_k2;
        spectrum_derivatives[37*lanes + lane] = 0;
        spectrum_derivatives[38*lanes + lane] = omega3_by_m1;
        spectrum_derivatives[39*lanes + lane] = omega3_by_m2;
        spectrum_derivatives[40*lanes + lane] = omega4_by_k1;
        spectrum_derivatives[41*lanes + lane] = omega4_by_k2;
        spectrum_derivatives[42*lanes + lane] = 0;
        spectrum_derivatives[43*lanes + lane] = omega4_by_m1;
        spectrum_derivatives[44*lanes + lane] = omega4_by_m2;
        spectrum_derivatives[45*lanes + lane] = p4_by_k1;
        spectrum_derivatives[46*lanes + lane] = p4_by_k2;
        spectrum_derivatives[47*lanes + lane] = 0;
        spectrum_derivatives[48*lanes + lane] = p4_by_m1;
        spectrum_derivatives[49*lanes + lane] = p4_by_m2;
        spectrum_derivatives[50*lanes + lane] = p5_by_k1;
        spectrum_derivatives[51*lanes + lane] = p5_by_k2;
        spectrum_derivatives[52*lanes + lane] = 0;
        spectrum_derivatives[53*lanes + lane] = p5_by_m1;
        spectrum_derivatives[54*lanes + lane] = p5_by_m2;
        spectrum_derivatives[55*lanes + lane] = p6_by_k1;
        spectrum_derivatives[56*lanes + lane] = p6_by_k2;
        spectrum_derivatives[57*lanes + lane] = 0;
        spectrum_derivatives[58*lanes + lane] = p6_by_m1;
        spectrum_derivatives[59*lanes + lane] = p6_by_m2;
    }
}

void elastic_stop_spectrum(
    const double parameters[5], double *spectrum, double *spectrum_derivatives)
{
    elastic_stop_spectrum_in_lane(1, 0, parameters, spectrum, spectrum_derivatives);
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
    /* state_after */
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
    /* state_after */
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
    /* fields */
    const double t0 = (1.0/(m1));
    const double t1 = k1*t0;
    const double t2 = (1.0/(m2));
    const double t3 = k1*t2;
    const double t4 = -t2*(k1 + k2);
    static const unsigned char nonsmooth_fields_places[] = {
        0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 2, 3, 0, 0, 4, 5, 6, 0, 0, 0, 0, 0, 1, 0, 0,
        0, 0, 0, 1, 0, 7, 3, 0, 0, 0, 5, 6, 0, 0, 0,
    };
    double nonsmooth_fields_values[8];
    nonsmooth_fields_values[0] = 0;
    nonsmooth_fields_values[1] = 1;
    nonsmooth_fields_values[2] = -t0*(k1 + k3);
    nonsmooth_fields_values[3] = t1;
    nonsmooth_fields_values[4] = k3*t0;
    nonsmooth_fields_values[5] = t3;
    nonsmooth_fields_values[6] = t4;
    nonsmooth_fields_values[7] = -t1;
    for (int i = 0; i < 40; ++i)
        fields[i] = nonsmooth_fields_values[nonsmooth_fields_places[i]];
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
    const double parameters[5], const double spectrum[12], double *exponents, double *coefficients)
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
    if (exponents) {
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
    if (coefficients) {
        static const unsigned char nonsmooth_coefficients_places[] = {
            0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 4, 0, 0, 5,
            6, 7, 0, 0, 8, 0, 0, 3, 4, 0, 0, 0, 6, 7, 0, 0, 0, 9, 10, 0, 0, 0, 11, 12, 0,
            13, 14, 0, 0, 15, 16, 17, 0, 0, 18, 7, 19, 0, 0, 20, 21, 3, 0, 0, 22, 0, 0, 7, 19, 0,
            0, 0, 21, 3, 0, 0, 0, 23, 24, 0, 0, 0, 25, 26, 0, 27, 28, 0, 0, 29, 30, 31, 0, 0, 32,
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 33, 34, 0, 0, 0,
            35, 36, 0, 0, 0, 0, 0, 33, 34, 0, 0, 0, 35, 36, 0, 0, 0, 37, 38, 0, 0, 0, 39, 40, 0,
            41, 42, 0, 0, 0, 43, 44, 0, 0, 0, 36, 45, 0, 0, 0, 46, 33, 0, 0, 0, 0, 0, 36, 45, 0,
            0, 0, 46, 33, 0, 0, 0, 47, 48, 0, 0, 0, 49, 50, 0, 51, 52, 0, 0, 0, 53, 54, 0, 0, 0,
        };
        double nonsmooth_coefficients_values[55];
        nonsmooth_coefficients_values[0] = 0;
        nonsmooth_coefficients_values[1] = t3;
        nonsmooth_coefficients_values[2] = t4;
        nonsmooth_coefficients_values[3] = p1;
        nonsmooth_coefficients_values[4] = p2;
        nonsmooth_coefficients_values[5] = -p1*t3 - t5;
        nonsmooth_coefficients_values[6] = p3;
        nonsmooth_coefficients_values[7] = -t6;
        nonsmooth_coefficients_values[8] = t4*t6 + t8;
        nonsmooth_coefficients_values[9] = p1*t9;
        nonsmooth_coefficients_values[10] = p2*t9;
        nonsmooth_coefficients_values[11] = p3*t9;
        nonsmooth_coefficients_values[12] = -t6*t9;
        nonsmooth_coefficients_values[13] = -t10;
        nonsmooth_coefficients_values[14] = -t11;
        nonsmooth_coefficients_values[15] = t10*t3 + t11*t4;
        nonsmooth_coefficients_values[16] = -t12;
        nonsmooth_coefficients_values[17] = -t13;
        nonsmooth_coefficients_values[18] = t12*t3 + t13*t4;
        nonsmooth_coefficients_values[19] = -p2;
        nonsmooth_coefficients_values[20] = t3*t6 + t5;
        nonsmooth_coefficients_values[21] = -p3;
        nonsmooth_coefficients_values[22] = -p1*t4 - t8;
        nonsmooth_coefficients_values[23] = -t16*t6;
        nonsmooth_coefficients_values[24] = -p2*t16;
        nonsmooth_coefficients_values[25] = -p3*t16;
        nonsmooth_coefficients_values[26] = p1*t16;
        nonsmooth_coefficients_values[27] = omega2*t6;
        nonsmooth_coefficients_values[28] = t17;
        nonsmooth_coefficients_values[29] = -omega2*t1*t2*t6 - t17*t4;
        nonsmooth_coefficients_values[30] = t18;
        nonsmooth_coefficients_values[31] = -t19;
        nonsmooth_coefficients_values[32] = -t18*t3 + t19*t4;
        nonsmooth_coefficients_values[33] = p4;
        nonsmooth_coefficients_values[34] = p5;
        nonsmooth_coefficients_values[35] = p6;
        nonsmooth_coefficients_values[36] = t20;
        nonsmooth_coefficients_values[37] = p4*t21;
        nonsmooth_coefficients_values[38] = p5*t21;
        nonsmooth_coefficients_values[39] = p6*t21;
        nonsmooth_coefficients_values[40] = t20*t21;
        nonsmooth_coefficients_values[41] = -omega3*p4;
        nonsmooth_coefficients_values[42] = -omega3*p5;
        nonsmooth_coefficients_values[43] = -omega3*p6;
        nonsmooth_coefficients_values[44] = -omega3*t20;
        nonsmooth_coefficients_values[45] = -p5;
        nonsmooth_coefficients_values[46] = -p6;
        nonsmooth_coefficients_values[47] = t20*t24;
        nonsmooth_coefficients_values[48] = -p5*t24;
        nonsmooth_coefficients_values[49] = -p6*t24;
        nonsmooth_coefficients_values[50] = p4*t24;
        nonsmooth_coefficients_values[51] = -omega4*t20;
        nonsmooth_coefficients_values[52] = omega4*p5;
        nonsmooth_coefficients_values[53] = omega4*p6;
        nonsmooth_coefficients_values[54] = -omega4*p4;
        for (int i = 0; i < 200; ++i)
            coefficients[i] = nonsmooth_coefficients_values[nonsmooth_coefficients_places[i]];
    }
}

/* Switching and periodicity equations; their derivatives by the unknowns; those by the parameters, in total, through the spectrum too.
 * Operations: 776. Intermediate terms: 191. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_equations_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *residual, double *jacobian,
    double *parameter_jacobian)
{
    const double k1 = parameters[2*lanes + lane];
    const double k2 = parameters[3*lanes + lane];
    const double k3 = parameters[4*lanes + lane];
    const double T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane];
    const double omega2 = spectrum[2*lanes + lane];
    const double p1 = spectrum[3*lanes + lane];
    const double p2 = spectrum[4*lanes + lane];
    const double p3 = spectrum[5*lanes + lane];
    const double omega3 = spectrum[7*lanes + lane];
    const double omega4 = spectrum[8*lanes + lane];
    const double p4 = spectrum[9*lanes + lane];
    const double p5 = spectrum[10*lanes + lane];
    const double p6 = spectrum[11*lanes + lane];
    const double y = unknowns[lane];
    const double u = unknowns[1*lanes + lane];
    const double w = unknowns[2*lanes + lane];
    const double tau = unknowns[3*lanes + lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t3 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t6);
    const double cos_omega3_half_tau1 = wave_2.cosine;
    const double sin_omega3_half_tau1 = wave_2.sine;
    const double t9 = half_tau1*omega4;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t9);
    const double cos_omega4_half_tau1 = wave_3.cosine;
    const double sin_omega4_half_tau1 = wave_3.sine;
    /* residual */
    const double t40 = p1*u + p2*w;
    const double t42 = -t40 + u;
    const double t43 = k1*k2;
    const double t45 = p1*t43;
    const double t46 = k1*k3;
    const double t47 = p2*t46;
    const double t48 = t43*y;
    const double t49 = k2*k3;
    const double t50 = t49*y;
    const double t51 = p2*t48 + p2*t50 + t45 + t47*y - t47;
    const double t52 = -t43 + t51;
    const double t53 = t43 + t46 + t49;
    const double t54 = (1.0/(t53));
    const double t55 = omega2*t54;
    const double t56 = sin_omega2_half_tau*t55;
    const double t57 = omega1*t54;
    const double t58 = sin_omega1_half_tau*t57;
    const double t59 = p3*u;
    const double t60 = p1*w;
    const double t61 = t59 - t60 + w;
    const double t62 = -t59 + t60;
    const double t63 = p1*t46;
    const double t64 = p3*t43;
    const double t66 = t46*y - t46 + t48 + t50;
    const double t67 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t63 - t64 - t66;
    const double t68 = p1*t50 + t45*y + t63*y - t63 - t64;
    const double t69 = p4*u + p5*w;
    const double t71 = t69 - u;
    const double t72 = p4 + p5*y;
    const double t73 = t72 - 1;
    const double t74 = omega4*sin_omega4_half_tau1;
    const double t75 = omega3*sin_omega3_half_tau1;
    const double t76 = p6*u;
    const double t77 = p4*w;
    const double t78 = -t76 + t77 - w;
    const double t79 = t76 - t77;
    const double t80 = p4*y - p6 - y;
    const double t81 = p4*y - p6;
    if (residual) {
        residual[lane] = cos_omega1_half_tau*t40 + cos_omega2_half_tau*t42 - t51*t58 + t52*t56;
        residual[1*lanes + lane] = cos_omega1_half_tau*t61 + cos_omega2_half_tau*t62 - t56*t68 + t58*t67;
        residual[2*lanes + lane] = -cos_omega3_half_tau1*t69 + cos_omega4_half_tau1*t71 - t72*t75 + t73*t74;
        residual[3*lanes + lane] = cos_omega3_half_tau1*t78 + cos_omega4_half_tau1*t79 - t74*t81 + t75*t80;
    }
    if (!jacobian && !parameter_jacobian)
        return;
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
    /* jacobian */
    const double t82 = p2*t43 + p2*t49 + t47;
    const double t83 = 1 - p1;
    const double t84 = sin_omega2_half_tau_by_tau*t55;
    const double t85 = sin_omega1_half_tau_by_tau*t57;
    const double t86 = p1*t49 + t45 + t63;
    const double t87 = p4 - 1;
    const double t88 = omega4*sin_omega4_half_tau1_by_tau;
    const double t89 = omega3*sin_omega3_half_tau1_by_tau;
    if (jacobian) {
        jacobian[lane] = omega2*sin_omega2_half_tau*t54*t82 - t58*t82;
        jacobian[1*lanes + lane] = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t83;
        jacobian[2*lanes + lane] = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
        jacobian[3*lanes + lane] = cos_omega1_half_tau_by_tau*t40 + cos_omega2_half_tau_by_tau*t42 - t51*t85 + t52*t84;
        jacobian[4*lanes + lane] = -t56*t86 + t58*(-t43 - t46 - t49 + t86);
        jacobian[5*lanes + lane] = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
        jacobian[6*lanes + lane] = cos_omega1_half_tau*t83 + cos_omega2_half_tau*p1;
        jacobian[7*lanes + lane] = cos_omega1_half_tau_by_tau*t61 + cos_omega2_half_tau_by_tau*t62 + t67*t85 - t68*t84;
        jacobian[8*lanes + lane] = omega4*p5*sin_omega4_half_tau1 - p5*t75;
        jacobian[9*lanes + lane] = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t87;
        jacobian[10*lanes + lane] = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
        jacobian[11*lanes + lane] = -cos_omega3_half_tau1_by_tau*t69 + cos_omega4_half_tau1_by_tau*t71 - t72*t89 + t73*t88;
        jacobian[12*lanes + lane] = -p4*t74 + t75*t87;
        jacobian[13*lanes + lane] = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
        jacobian[14*lanes + lane] = cos_omega3_half_tau1*t87 - cos_omega4_half_tau1*p4;
        jacobian[15*lanes + lane] = cos_omega3_half_tau1_by_tau*t78 + cos_omega4_half_tau1_by_tau*t79 + t80*t89 - t81*t88;
    }
    if (!parameter_jacobian)
        return;
    const double omega1_by_k1 = spectrum_derivatives[5*lanes + lane];
    const double omega1_by_k2 = spectrum_derivatives[6*lanes + lane];
    const double omega1_by_k3 = spectrum_derivatives[7*lanes + lane];
    const double omega1_by_m1 = spectrum_derivatives[8*lanes + lane];
    const double omega1_by_m2 = spectrum_derivatives[9*lanes + lane];
    const double omega2_by_k1 = spectrum_derivatives[10*lanes + lane];
    const double omega2_by_k2 = spectrum_derivatives[11*lanes + lane];
    const double omega2_by_k3 = spectrum_derivatives[12*lanes + lane];
    const double omega2_by_m1 = spectrum_derivatives[13*lanes + lane];
    const double omega2_by_m2 = spectrum_derivatives[14*lanes + lane];
    const double p1_by_k1 = spectrum_derivatives[15*lanes + lane];
    const double p1_by_k2 = spectrum_derivatives[16*lanes + lane];
    const double p1_by_k3 = spectrum_derivatives[17*lanes + lane];
    const double p1_by_m1 = spectrum_derivatives[18*lanes + lane];
    const double p1_by_m2 = spectrum_derivatives[19*lanes + lane];
    const double p2_by_k1 = spectrum_derivatives[20*lanes + lane];
    const double p2_by_k2 = spectrum_derivatives[21*lanes + lane];
    const double p2_by_k3 = spectrum_derivatives[22*lanes + lane];
    const double p2_by_m1 = spectrum_derivatives[23*lanes + lane];
    const double p2_by_m2 = spectrum_derivatives[24*lanes + lane];
    const double p3_by_k1 = spectrum_derivatives[25*lanes + lane];
    const double p3_by_k2 = spectrum_derivatives[26*lanes + lane];
    const double p3_by_k3 = spectrum_derivatives[27*lanes + lane];
    const double p3_by_m1 = spectrum_derivatives[28*lanes + lane];
    const double p3_by_m2 = spectrum_derivatives[29*lanes + lane];
    const double omega3_by_k1 = spectrum_derivatives[35*lanes + lane];
    const double omega3_by_k2 = spectrum_derivatives[36*lanes + lane];
    const double omega3_by_k3 = spectrum_derivatives[37*lanes + lane];
    const double omega3_by_m1 = spectrum_derivatives[38*lanes + lane];
    const double omega3_by_m2 = spectrum_derivatives[39*lanes + lane];
    const double omega4_by_k1 = spectrum_derivatives[40*lanes + lane];
    const double omega4_by_k2 = spectrum_derivatives[41*lanes + lane];
    const double omega4_by_k3 = spectrum_derivatives[42*lanes + lane];
    const double omega4_by_m1 = spectrum_derivatives[43*lanes + lane];
    const double omega4_by_m2 = spectrum_derivatives[44*lanes + lane];
    const double p4_by_k1 = spectrum_derivatives[45*lanes + lane];
    const double p4_by_k2 = spectrum_derivatives[46*lanes + lane];
    const double p4_by_k3 = spectrum_derivatives[47*lanes + lane];
    const double p4_by_m1 = spectrum_derivatives[48*lanes + lane];
    const double p4_by_m2 = spectrum_derivatives[49*lanes + lane];
    const double p5_by_k1 = spectrum_derivatives[50*lanes + lane];
    const double p5_by_k2 = spectrum_derivatives[51*lanes + lane];
    const double p5_by_k3 = spectrum_derivatives[52*lanes + lane];
    const double p5_by_m1 = spectrum_derivatives[53*lanes + lane];
    const double p5_by_m2 = spectrum_derivatives[54*lanes + lane];
    const double p6_by_k1 = spectrum_derivatives[55*lanes + lane];
    const double p6_by_k2 = spectrum_derivatives[56*lanes + lane];
    const double p6_by_k3 = spectrum_derivatives[57*lanes + lane];
    const double p6_by_m1 = spectrum_derivatives[58*lanes + lane];
    const double p6_by_m2 = spectrum_derivatives[59*lanes + lane];
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
    /* parameter_jacobian */
    const double t90 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t43*t56 - t43*t58;
    const double t91 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t56*t66 - t58*t66;
    const double t92 = sin_omega2_half_tau*t54;
    const double t93 = t52*t92;
    const double t94 = t52*t55;
    const double t95 = sin_omega1_half_tau*t54;
    const double t96 = t51*t95;
    const double t97 = t51*t57;
    const double t98 = k2*p1;
    const double t99 = k3*p2;
    const double t100 = k2*y;
    const double t101 = p2*t100;
    const double t102 = t99*y;
    const double t103 = t101 + t102 + t98 - t99;
    const double t104 = (1.0/(t53*t53));
    const double t105 = t104*(-k2 - k3);
    const double t106 = omega2*sin_omega2_half_tau;
    const double t107 = t106*t52;
    const double t108 = omega1*sin_omega1_half_tau;
    const double t109 = t108*t51;
    const double t110 = k1*p1;
    const double t111 = k1*p2;
    const double t112 = t111*y;
    const double t113 = t102 + t110 + t112;
    const double t114 = t104*(-k1 - k3);
    const double t115 = t101 - t111 + t112;
    const double t116 = t104*(-k1 - k2);
    const double t118 = t67*t95;
    const double t119 = t57*t67;
    const double t120 = t68*t92;
    const double t121 = t55*t68;
    const double t122 = k3*p1;
    const double t123 = k2*p3;
    const double t124 = -k3*p1*y + k3*y;
    const double t125 = t98*y;
    const double t126 = t122*y;
    const double t127 = t108*t67;
    const double t128 = t106*t68;
    const double t129 = k1*p3;
    const double t130 = k1*y;
    const double t131 = t110*y;
    const double t132 = -t110 + t125 + t131;
    const double t133 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + omega4*sin_omega4_half_tau1 - t75;
    const double t134 = cos_omega3_half_tau1*w - cos_omega4_half_tau1*w - omega4*sin_omega4_half_tau1*y + t75*y;
    const double t136 = sin_omega4_half_tau1*t73;
    const double t137 = omega4*t73;
    const double t138 = sin_omega3_half_tau1*t72;
    const double t139 = omega3*t72;
    const double t140 = sin_omega3_half_tau1*t80;
    const double t141 = omega3*t80;
    const double t142 = sin_omega4_half_tau1*t81;
    const double t143 = omega4*t81;
    if (parameter_jacobian) {
        parameter_jacobian[lane] = cos_omega1_half_tau_by_m1*t40 + cos_omega2_half_tau_by_m1*t42 - omega1_by_m1*t96 + omega2_by_m1*t93 + p1_by_m1*t90 + p2_by_m1*t91 - sin_omega1_half_tau_by_m1*t97 + sin_omega2_half_tau_by_m1*t94;
        parameter_jacobian[1*lanes + lane] = cos_omega1_half_tau_by_m2*t40 + cos_omega2_half_tau_by_m2*t42 - omega1_by_m2*t96 + omega2_by_m2*t93 + p1_by_m2*t90 + p2_by_m2*t91 - sin_omega1_half_tau_by_m2*t97 + sin_omega2_half_tau_by_m2*t94;
        parameter_jacobian[2*lanes + lane] = cos_omega1_half_tau_by_k1*t40 + cos_omega2_half_tau_by_k1*t42 - omega1_by_k1*t96 + omega2_by_k1*t93 + p1_by_k1*t90 + p2_by_k1*t91 - sin_omega1_half_tau_by_k1*t97 + sin_omega2_half_tau_by_k1*t94 - t103*t58 + t105*t107 - t105*t109 + t56*(-k2 + t103);
        parameter_jacobian[3*lanes + lane] = cos_omega1_half_tau_by_k2*t40 + cos_omega2_half_tau_by_k2*t42 - omega1_by_k2*t96 + omega2_by_k2*t93 + p1_by_k2*t90 + p2_by_k2*t91 - sin_omega1_half_tau_by_k2*t97 + sin_omega2_half_tau_by_k2*t94 + t107*t114 - t109*t114 - t113*t58 + t56*(-k1 + t113);
        parameter_jacobian[4*lanes + lane] = cos_omega1_half_tau_by_k3*t40 + cos_omega2_half_tau_by_k3*t42 - omega1_by_k3*t96 + omega2_by_k3*t93 + p1_by_k3*t90 + p2_by_k3*t91 - sin_omega1_half_tau_by_k3*t97 + sin_omega2_half_tau_by_k3*t94 + t107*t116 - t109*t116 + t115*t56 - t115*t58;
        parameter_jacobian[5*lanes + lane] = 0;
        parameter_jacobian[6*lanes + lane] = cos_omega1_half_tau_by_m1*t61 + cos_omega2_half_tau_by_m1*t62 + omega1_by_m1*t118 - omega2_by_m1*t120 - p1_by_m1*t91 + p3_by_m1*t90 + sin_omega1_half_tau_by_m1*t119 - sin_omega2_half_tau_by_m1*t121;
        parameter_jacobian[7*lanes + lane] = cos_omega1_half_tau_by_m2*t61 + cos_omega2_half_tau_by_m2*t62 + omega1_by_m2*t118 - omega2_by_m2*t120 - p1_by_m2*t91 + p3_by_m2*t90 + sin_omega1_half_tau_by_m2*t119 - sin_omega2_half_tau_by_m2*t121;
        parameter_jacobian[8*lanes + lane] = cos_omega1_half_tau_by_k1*t61 + cos_omega2_half_tau_by_k1*t62 + omega1_by_k1*t118 - omega2_by_k1*t120 - p1_by_k1*t91 + p3_by_k1*t90 + sin_omega1_half_tau_by_k1*t119 - sin_omega2_half_tau_by_k1*t121 + t105*t127 - t105*t128 - t56*(-t122 - t123 + t125 + t126) + t58*(k2*p1*y + k3 - t100 - t122 - t123 - t124);
        parameter_jacobian[9*lanes + lane] = cos_omega1_half_tau_by_k2*t61 + cos_omega2_half_tau_by_k2*t62 + omega1_by_k2*t118 - omega2_by_k2*t120 - p1_by_k2*t91 + p3_by_k2*t90 + sin_omega1_half_tau_by_k2*t119 - sin_omega2_half_tau_by_k2*t121 + t114*t127 - t114*t128 - t56*(t126 - t129 + t131) + t58*(k1*p1*y - t124 - t129 - t130);
        parameter_jacobian[10*lanes + lane] = cos_omega1_half_tau_by_k3*t61 + cos_omega2_half_tau_by_k3*t62 + omega1_by_k3*t118 - omega2_by_k3*t120 - p1_by_k3*t91 + p3_by_k3*t90 + sin_omega1_half_tau_by_k3*t119 - sin_omega2_half_tau_by_k3*t121 + t116*t127 - t116*t128 - t132*t56 + t58*(k1 - t100 - t130 + t132);
        parameter_jacobian[11*lanes + lane] = 0;
        parameter_jacobian[12*lanes + lane] = -cos_omega3_half_tau1_by_m1*t69 + cos_omega4_half_tau1_by_m1*t71 - omega3_by_m1*t138 + omega4_by_m1*t136 + p4_by_m1*t133 - p5_by_m1*t134 - sin_omega3_half_tau1_by_m1*t139 + sin_omega4_half_tau1_by_m1*t137;
        parameter_jacobian[13*lanes + lane] = -cos_omega3_half_tau1_by_m2*t69 + cos_omega4_half_tau1_by_m2*t71 - omega3_by_m2*t138 + omega4_by_m2*t136 + p4_by_m2*t133 - p5_by_m2*t134 - sin_omega3_half_tau1_by_m2*t139 + sin_omega4_half_tau1_by_m2*t137;
        parameter_jacobian[14*lanes + lane] = -cos_omega3_half_tau1_by_k1*t69 + cos_omega4_half_tau1_by_k1*t71 - omega3_by_k1*t138 + omega4_by_k1*t136 + p4_by_k1*t133 - p5_by_k1*t134 - sin_omega3_half_tau1_by_k1*t139 + sin_omega4_half_tau1_by_k1*t137;
        parameter_jacobian[15*lanes + lane] = -cos_omega3_half_tau1_by_k2*t69 + cos_omega4_half_tau1_by_k2*t71 - omega3_by_k2*t138 + omega4_by_k2*t136 + p4_by_k2*t133 - p5_by_k2*t134 - sin_omega3_half_tau1_by_k2*t139 + sin_omega4_half_tau1_by_k2*t137;
        parameter_jacobian[16*lanes + lane] = -cos_omega3_half_tau1_by_k3*t69 + cos_omega4_half_tau1_by_k3*t71 - omega3_by_k3*t138 + omega4_by_k3*t136 + p4_by_k3*t133 - p5_by_k3*t134 - sin_omega3_half_tau1_by_k3*t139 + sin_omega4_half_tau1_by_k3*t137;
        parameter_jacobian[17*lanes + lane] = -cos_omega3_half_tau1_by_T*t69 + cos_omega4_half_tau1_by_T*t71 - sin_omega3_half_tau1_by_T*t139 + sin_omega4_half_tau1_by_T*t137;
        parameter_jacobian[18*lanes + lane] = cos_omega3_half_tau1_by_m1*t78 + cos_omega4_half_tau1_by_m1*t79 + omega3_by_m1*t140 - omega4_by_m1*t142 + p4_by_m1*t134 + p6_by_m1*t133 + sin_omega3_half_tau1_by_m1*t141 - sin_omega4_half_tau1_by_m1*t143;
        parameter_jacobian[19*lanes + lane] = cos_omega3_half_tau1_by_m2*t78 + cos_omega4_half_tau1_by_m2*t79 + omega3_by_m2*t140 - omega4_by_m2*t142 + p4_by_m2*t134 + p6_by_m2*t133 + sin_omega3_half_tau1_by_m2*t141 - sin_omega4_half_tau1_by_m2*t143;
        parameter_jacobian[20*lanes + lane] = cos_omega3_half_tau1_by_k1*t78 + cos_omega4_half_tau1_by_k1*t79 + omega3_by_k1*t140 - omega4_by_k1*t142 + p4_by_k1*t134 + p6_by_k1*t133 + sin_omega3_half_tau1_by_k1*t141 - sin_omega4_half_tau1_by_k1*t143;
        parameter_jacobian[21*lanes + lane] = cos_omega3_half_tau1_by_k2*t78 + cos_omega4_half_tau1_by_k2*t79 + omega3_by_k2*t140 - omega4_by_k2*t142 + p4_by_k2*t134 + p6_by_k2*t133 + sin_omega3_half_tau1_by_k2*t141 - sin_omega4_half_tau1_by_k2*t143;
        parameter_jacobian[22*lanes + lane] = cos_omega3_half_tau1_by_k3*t78 + cos_omega4_half_tau1_by_k3*t79 + omega3_by_k3*t140 - omega4_by_k3*t142 + p4_by_k3*t134 + p6_by_k3*t133 + sin_omega3_half_tau1_by_k3*t141 - sin_omega4_half_tau1_by_k3*t143;
        parameter_jacobian[23*lanes + lane] = cos_omega3_half_tau1_by_T*t78 + cos_omega4_half_tau1_by_T*t79 + sin_omega3_half_tau1_by_T*t141 - sin_omega4_half_tau1_by_T*t143;
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
 * Operations: 1672. Intermediate terms: 325. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_trace_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *unknowns,
    const double *spectrum_derivatives, double *trace, double *trace_gradient)
{
    const double m1 = parameters[lane];
    const double m2 = parameters[1*lanes + lane];
    const double k1 = parameters[2*lanes + lane];
    const double k2 = parameters[3*lanes + lane];
    const double k3 = parameters[4*lanes + lane];
    const double T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane];
    const double omega2 = spectrum[2*lanes + lane];
    const double p1 = spectrum[3*lanes + lane];
    const double p2 = spectrum[4*lanes + lane];
    const double p3 = spectrum[5*lanes + lane];
    const double omega3 = spectrum[7*lanes + lane];
    const double omega4 = spectrum[8*lanes + lane];
    const double p4 = spectrum[9*lanes + lane];
    const double p5 = spectrum[10*lanes + lane];
    const double p6 = spectrum[11*lanes + lane];
    const double y = unknowns[lane];
    const double u = unknowns[1*lanes + lane];
    const double w = unknowns[2*lanes + lane];
    const double tau = unknowns[3*lanes + lane];
    /* functions of tau in contact */
    const double t0 = omega1*tau;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_tau = wave_0.cosine;
    const double sin_omega1_tau = wave_0.sine;
    const double t3 = omega2*tau;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega2_tau = wave_1.cosine;
    const double sin_omega2_tau = wave_1.sine;
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
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t49);
    const double cos_omega3_tau1 = wave_2.cosine;
    const double sin_omega3_tau1 = wave_2.sine;
    const double t52 = omega4*tau1;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t52);
    const double cos_omega4_tau1 = wave_3.cosine;
    const double sin_omega4_tau1 = wave_3.sine;
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
    const double carried_x2_2_by_y = t65*v1_1_on_boundary_by_y + t66*v2_1_on_boundary_by_y + t67*x1_1_on_boundary_by_y + t68*x2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t62*v1_1_on_boundary_by_u + t63*v2_1_on_boundary_by_u - t71*x1_1_on_boundary_by_u + t74*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t67*v1_1_on_boundary_by_w + t68*v2_1_on_boundary_by_w + t76*x1_1_on_boundary_by_w - t77*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t89 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t89;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t89;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t89;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double t90 = t80*x1_2;
    const double t91 = k1*t80*x2_2 - k1*t90;
    const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t91;
    const double t92 = t84*x1_2;
    const double t93 = t84*x2_2;
    const double t94 = k1*t92 - t86*t93;
    const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t94;
    if (trace) {
        trace[lane] = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y;
    }
    if (!trace_gradient)
        return;
    const double omega1_by_k1 = spectrum_derivatives[5*lanes + lane];
    const double omega1_by_k2 = spectrum_derivatives[6*lanes + lane];
    const double omega1_by_k3 = spectrum_derivatives[7*lanes + lane];
    const double omega1_by_m1 = spectrum_derivatives[8*lanes + lane];
    const double omega1_by_m2 = spectrum_derivatives[9*lanes + lane];
    const double omega2_by_k1 = spectrum_derivatives[10*lanes + lane];
    const double omega2_by_k2 = spectrum_derivatives[11*lanes + lane];
    const double omega2_by_k3 = spectrum_derivatives[12*lanes + lane];
    const double omega2_by_m1 = spectrum_derivatives[13*lanes + lane];
    const double omega2_by_m2 = spectrum_derivatives[14*lanes + lane];
    const double p1_by_k1 = spectrum_derivatives[15*lanes + lane];
    const double p1_by_k2 = spectrum_derivatives[16*lanes + lane];
    const double p1_by_k3 = spectrum_derivatives[17*lanes + lane];
    const double p1_by_m1 = spectrum_derivatives[18*lanes + lane];
    const double p1_by_m2 = spectrum_derivatives[19*lanes + lane];
    const double p2_by_k1 = spectrum_derivatives[20*lanes + lane];
    const double p2_by_k2 = spectrum_derivatives[21*lanes + lane];
    const double p2_by_k3 = spectrum_derivatives[22*lanes + lane];
    const double p2_by_m1 = spectrum_derivatives[23*lanes + lane];
    const double p2_by_m2 = spectrum_derivatives[24*lanes + lane];
    const double p3_by_k1 = spectrum_derivatives[25*lanes + lane];
    const double p3_by_k2 = spectrum_derivatives[26*lanes + lane];
    const double p3_by_k3 = spectrum_derivatives[27*lanes + lane];
    const double p3_by_m1 = spectrum_derivatives[28*lanes + lane];
    const double p3_by_m2 = spectrum_derivatives[29*lanes + lane];
    const double omega3_by_k1 = spectrum_derivatives[35*lanes + lane];
    const double omega3_by_k2 = spectrum_derivatives[36*lanes + lane];
    const double omega3_by_k3 = spectrum_derivatives[37*lanes + lane];
    const double omega3_by_m1 = spectrum_derivatives[38*lanes + lane];
    const double omega3_by_m2 = spectrum_derivatives[39*lanes + lane];
    const double omega4_by_k1 = spectrum_derivatives[40*lanes + lane];
    const double omega4_by_k2 = spectrum_derivatives[41*lanes + lane];
    const double omega4_by_k3 = spectrum_derivatives[42*lanes + lane];
    const double omega4_by_m1 = spectrum_derivatives[43*lanes + lane];
    const double omega4_by_m2 = spectrum_derivatives[44*lanes + lane];
    const double p4_by_k1 = spectrum_derivatives[45*lanes + lane];
    const double p4_by_k2 = spectrum_derivatives[46*lanes + lane];
    const double p4_by_k3 = spectrum_derivatives[47*lanes + lane];
    const double p4_by_m1 = spectrum_derivatives[48*lanes + lane];
    const double p4_by_m2 = spectrum_derivatives[49*lanes + lane];
    const double p5_by_k1 = spectrum_derivatives[50*lanes + lane];
    const double p5_by_k2 = spectrum_derivatives[51*lanes + lane];
    const double p5_by_k3 = spectrum_derivatives[52*lanes + lane];
    const double p5_by_m1 = spectrum_derivatives[53*lanes + lane];
    const double p5_by_m2 = spectrum_derivatives[54*lanes + lane];
    const double p6_by_k1 = spectrum_derivatives[55*lanes + lane];
    const double p6_by_k2 = spectrum_derivatives[56*lanes + lane];
    const double p6_by_k3 = spectrum_derivatives[57*lanes + lane];
    const double p6_by_m1 = spectrum_derivatives[58*lanes + lane];
    const double p6_by_m2 = spectrum_derivatives[59*lanes + lane];
    /* back through: derivatives of the time to the boundary after tau1 */
    const double slope_by_delay_tau1_by_w = t94;
    const double slope_by_delay_tau1_by_u = t91;
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
    const double t95 = (1.0/(rate_1*rate_1));
    const double slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t95 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t95 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t95;
    /* back through: Phi along tau */
    const double slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t79 + slope_by_x1_1_on_boundary_by_w;
    const double slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t79 + slope_by_x1_1_on_boundary_by_u;
    const double slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t79 + slope_by_x1_1_on_boundary_by_y;
    /* back through: free for tau1, until first-reaches-stop */
    const double t96 = (1.0/(v1_2*v1_2));
    const double slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t96 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t96 + carried_x1_2_by_y*t96*v2_2;
    const double t97 = k1*t80;
    const double t98 = delay_tau1_by_u*t97;
    const double slope_by_x2_2 = -delay_tau1_by_w*t84*t86 + t98;
    const double slope_by_x1_2 = delay_tau1_by_w*k1*t84 - t98;
    /* back through: functions of tau1 in free */
    const double t99 = p4*x2_1;
    const double t100 = p5*v2_1_on_boundary_by_u;
    const double t101 = p5*t58;
    const double t102 = p5*x2_1;
    const double t103 = t57*x1_1;
    const double t104 = p5*v2_1;
    const double t105 = p4*v2_1;
    const double t106 = p6*v1_1;
    const double t107 = p4*v2_1_on_boundary_by_y;
    const double t108 = p5*x2_1_on_boundary_by_u;
    const double t109 = p6*x1_1_on_boundary_by_w;
    const double t110 = p4*x2_1_on_boundary_by_w;
    const double t111 = p6*v1_1_on_boundary_by_y;
    const double t112 = t57*x1_1_on_boundary_by_u;
    const double slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*p6*x1_1 - omega4*t99) + omega4*t108 + omega4*t109 - omega4*t110 - omega4*t112 + slope_by_carried_x1_2_by_u*(-t100*t58 + t57*t58*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t101*v2_1_on_boundary_by_w + t57*t58*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t101*v2_1_on_boundary_by_y + t57*t58*v1_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t102 - omega4*t103) + slope_by_x1_2*(-t104*t58 + t57*t58*v1_1) + slope_by_x2_2*(t105*t58 - t106*t58) + t107*t58 - t111*t58;
    const double t113 = p5*x2_1_on_boundary_by_w;
    const double t114 = p5*x2_1_on_boundary_by_y;
    const double t115 = p6*x1_1;
    const double t116 = t57*v1_1_on_boundary_by_u;
    const double t117 = p6*v1_1_on_boundary_by_w;
    const double t118 = p6*x1_1_on_boundary_by_y;
    const double slope_by_cos_omega4_tau1 = delay_tau1_by_y*(t105 - t106) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(-t108 + t57*x1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t113 + t57*x1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t114 + t57*x1_1_on_boundary_by_y) + slope_by_v1_2*(-t104 + t57*v1_1) + slope_by_x1_2*(-t102 + t57*x1_1) + slope_by_x2_2*(-t115 + t99) - t100 + t116 - t117 - t118;
    const double t119 = t57*x2_1;
    const double t120 = p4*v1_1_on_boundary_by_u;
    const double t121 = p4*t55;
    const double t122 = p5*t55;
    const double t123 = p4*x1_1;
    const double t124 = p4*v1_1;
    const double t125 = t57*v2_1;
    const double t126 = t57*v2_1_on_boundary_by_y;
    const double t127 = p4*x1_1_on_boundary_by_u;
    const double t128 = t57*x2_1_on_boundary_by_w;
    const double slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t115 - omega3*t119) - omega3*t108 - omega3*t109 - omega3*t127 - omega3*t128 + slope_by_carried_x1_2_by_u*(t100*t55 + t120*t55) + slope_by_carried_x1_2_by_w*(t121*v1_1_on_boundary_by_w + t122*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t121*v1_1_on_boundary_by_y + t122*v2_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t102 - omega3*t123) + slope_by_x1_2*(t104*t55 + t124*t55) + slope_by_x2_2*(t106*t55 + t125*t55) + t111*t55 + t126*t55;
    const double slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t106 + t125) + slope_by_carried_x1_2_by_u*(t108 + t127) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t113) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t114) + slope_by_v1_2*(t104 + t124) + slope_by_x1_2*(t102 + t123) + slope_by_x2_2*(t115 + t119) + t100 + t117 + t118 + t120 + t57*v2_1_on_boundary_by_w + t57*x2_1_on_boundary_by_y;
    /* back through: tau1 completes the period */
    const double t129 = sin_omega3_tau1*slope_by_cos_omega3_tau1;
    const double t130 = sin_omega4_tau1*slope_by_cos_omega4_tau1;
    const double slope_by_tau1 = cos_omega3_tau1*omega3*slope_by_sin_omega3_tau1 + cos_omega4_tau1*omega4*slope_by_sin_omega4_tau1 - omega3*t129 - omega4*t130;
    /* back through: contact for tau, until first-leaves-stop */
    const double slope_by_v2_1 = delay_tau1_by_y*t68 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t63 + slope_by_x1_2*t61 + slope_by_x2_2*t66;
    const double slope_by_v1_1 = delay_tau1_by_y*t67 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t62 + slope_by_x1_2*t60 + slope_by_x2_2*t65;
    const double t131 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u;
    const double t132 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w;
    const double t133 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y;
    const double t134 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u;
    const double t135 = t84*t86;
    const double t136 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w;
    const double t137 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y;
    const double slope_by_x2_1 = -delay_tau1_by_y*t77 + slope_by_v1_2*t74 + slope_by_x1_2*t63 + slope_by_x2_2*t68 + t131*t97 + t132*t97 + t133*t97 - t134*t135 - t135*t136 - t135*t137;
    const double t138 = k1*t84;
    const double t139 = t80*t81;
    const double slope_by_x1_1 = delay_tau1_by_y*t76 - slope_by_v1_2*t71 + slope_by_x1_2*t62 + slope_by_x2_2*t67 - t131*t139 - t132*t139 - t133*t139 + t134*t138 + t136*t138 + t137*t138;
    /* back through: functions of tau in contact */
    const double t140 = p1*y;
    const double t141 = p2*w;
    const double t142 = p1*w;
    const double t143 = p3*u;
    const double t144 = p1*slope_by_x2_1_on_boundary_by_w;
    const double t145 = p2*slope_by_v1_1_on_boundary_by_y;
    const double t146 = p1*slope_by_v2_1_on_boundary_by_y;
    const double t147 = p2*slope_by_carried_x1_1_by_w;
    const double t148 = p3*slope_by_x2_1_on_boundary_by_u;
    const double slope_by_sin_omega2_tau = omega2*t145 - omega2*t146 - slope_by_carried_x1_1_by_u*t14*t18 + slope_by_v1_1*(omega2*p2*y - t38 - t41) + slope_by_v2_1*(-omega2*t140 + t45 + t46) + slope_by_x1_1*(-t14*t18*u - t141*t18) + slope_by_x2_1*(t142*t18 - t143*t18) + t144*t18 - t147*t18 - t148*t18;
    const double t149 = p2*y;
    const double t150 = -p1 - t149;
    const double t151 = p2*slope_by_carried_x1_1_by_y;
    const double t152 = p2*slope_by_v1_1_on_boundary_by_w;
    const double t153 = p3*slope_by_v2_1_on_boundary_by_u;
    const double slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t14*u - t141) - slope_by_v1_1_on_boundary_by_u*t14 + slope_by_v2_1*(t142 - t143) + slope_by_x1_1*(t15 + t150 + 1) + slope_by_x2_1*(p1*y - p3 - t30) - t151 - t152 - t153;
    const double t154 = -t14*y;
    const double t155 = p1*u;
    const double t156 = -t14*w;
    const double t157 = -slope_by_x2_1_on_boundary_by_w*t14;
    const double t158 = -slope_by_v2_1_on_boundary_by_y*t14;
    const double slope_by_sin_omega1_tau = -omega1*t145 - omega1*t158 + p1*slope_by_carried_x1_1_by_u*t16 + slope_by_v1_1*(-omega1*t149 - t36 + t37) + slope_by_v2_1*(-omega1*t154 - t42 + t44) + slope_by_x1_1*(t141*t16 + t155*t16) + slope_by_x2_1*(t143*t16 + t156*t16) + t147*t16 + t148*t16 + t157*t16;
    const double slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t141 + t155) + slope_by_v2_1*(t143 + t156) - slope_by_v2_1_on_boundary_by_w*t14 + slope_by_x1_1*(-t13 - t150) + slope_by_x2_1*(p3 + t154 + t28) - slope_by_x2_1_on_boundary_by_y*t14 + t151 + t152 + t153;
    /* trace_gradient */
    const double t159 = sin_omega1_tau*slope_by_cos_omega1_tau;
    const double t160 = sin_omega2_tau*slope_by_cos_omega2_tau;
    const double t161 = (1.0/(m1*m1));
    const double t162 = k1*t161;
    const double t163 = p3*sin_omega1_tau;
    const double t164 = (1.0/(omega1*omega1));
    const double t165 = sin_omega1_tau*t164;
    const double t166 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t145 - sin_omega1_tau*t158 - slope_by_carried_x1_1_by_u*t164*t17 + slope_by_v1_1*(sin_omega1_tau*t13 - sin_omega1_tau*t149 - t17) + slope_by_v2_1*(-sin_omega1_tau*t154 + sin_omega1_tau*(t26 + t43) - t163) + slope_by_x1_1*(-t141*t165 - t155*t165) + slope_by_x2_1*(-t143*t165 - t156*t165) - slope_by_x2_1_on_boundary_by_u*t163*t164 - t147*t165 - t157*t165 - t159*tau;
    const double t167 = (1.0/(omega2*omega2));
    const double t168 = sin_omega2_tau*t167;
    const double t169 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t145 - sin_omega2_tau*t146 - slope_by_carried_x1_1_by_u*t167*t20 + slope_by_v1_1*(sin_omega2_tau*t149 + sin_omega2_tau*(-t12 - t14*t7*t9) - t20) + slope_by_v2_1*(-sin_omega2_tau*t140 + sin_omega2_tau*t30 + t31) + slope_by_x1_1*(t14*t168*u + t141*t168) + slope_by_x2_1*(p3*sin_omega2_tau*t167*u - t142*t168) + slope_by_x2_1_on_boundary_by_u*t167*t31 - t144*t168 + t147*t168 - t160*tau;
    const double t170 = sin_omega3_tau1/(omega3*omega3);
    const double t171 = p4*t170;
    const double t172 = p5*t170;
    const double t173 = cos_omega3_tau1*slope_by_sin_omega3_tau1*tau1 + delay_tau1_by_y*(-sin_omega3_tau1*t115 - sin_omega3_tau1*t119) - sin_omega3_tau1*t108 - sin_omega3_tau1*t109 - sin_omega3_tau1*t127 - sin_omega3_tau1*t128 + slope_by_carried_x1_2_by_u*(-t100*t170 - t120*t170) + slope_by_carried_x1_2_by_w*(-t171*v1_1_on_boundary_by_w - t172*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t171*v1_1_on_boundary_by_y - t172*v2_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t102 - sin_omega3_tau1*t123) + slope_by_x1_2*(-t104*t170 - t124*t170) + slope_by_x2_2*(-t106*t170 - t125*t170) - t111*t170 - t126*t170 - t129*tau1;
    const double t174 = (1.0/(omega4*omega4));
    const double t175 = sin_omega4_tau1*t174;
    const double t176 = p5*t175;
    const double t177 = t175*t57;
    const double t178 = cos_omega4_tau1*slope_by_sin_omega4_tau1*tau1 + delay_tau1_by_y*(p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t99) + sin_omega4_tau1*t108 + sin_omega4_tau1*t109 - sin_omega4_tau1*t110 - sin_omega4_tau1*t112 + slope_by_carried_x1_2_by_u*(t100*t175 - t116*t175) + slope_by_carried_x1_2_by_w*(t176*v2_1_on_boundary_by_w - t177*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t176*v2_1_on_boundary_by_y - t177*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t102 - sin_omega4_tau1*t103) + slope_by_x1_2*(t104*t175 - t175*t57*v1_1) + slope_by_x2_2*(p6*sin_omega4_tau1*t174*v1_1 - t105*t175) - t107*t175 + t111*t175 - t130*tau1;
    const double t179 = -sin_omega1_tau*t16 + t22;
    const double t181 = cos_omega1_tau - cos_omega2_tau;
    const double t182 = t10*t39 - t10*t47 + t181*u - t39 + t47;
    const double t184 = t39 - t47;
    const double t185 = t11*t47;
    const double t186 = t11*t39;
    const double t187 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t179*u + t181;
    const double t188 = cos_omega1_tau*t11;
    const double t189 = cos_omega2_tau*t11;
    const double t190 = -slope_by_carried_x1_1_by_u*t179 + slope_by_v1_1*t182 + slope_by_v1_1_on_boundary_by_u*t181 + slope_by_v2_1*(-t181*w + t184*y + t185 - t186) - slope_by_v2_1_on_boundary_by_w*t181 + slope_by_v2_1_on_boundary_by_y*t184 + slope_by_x1_1*t187 + slope_by_x2_1*(t179*w - t181*y + t188 - t189) + slope_by_x2_1_on_boundary_by_w*t179 - slope_by_x2_1_on_boundary_by_y*t181;
    const double t192 = -slope_by_carried_x1_1_by_w*t179 + slope_by_carried_x1_1_by_y*t181 + slope_by_v1_1*(t181*w - t184*y - t185 + t186) + slope_by_v1_1_on_boundary_by_w*t181 - slope_by_v1_1_on_boundary_by_y*t184 + slope_by_x1_1*(-t179*w + t181*y - t188 + t189);
    const double t193 = slope_by_v2_1*t182 + slope_by_v2_1_on_boundary_by_u*t181 + slope_by_x2_1*t187 - slope_by_x2_1_on_boundary_by_u*t179;
    const double t194 = cos_omega3_tau1 - cos_omega4_tau1;
    const double t196 = t69 - t70;
    const double t197 = -sin_omega3_tau1*t55 + t59;
    const double t199 = t194*x1_1_on_boundary_by_y - t197*v1_1_on_boundary_by_y;
    const double t201 = t194*v1_1 - t196*x1_1;
    const double t202 = t194*x1_1 - t197*v1_1;
    const double t203 = delay_tau1_by_y*(-t194*v2_1 + t196*x2_1) + slope_by_carried_x1_2_by_u*(t194*x1_1_on_boundary_by_u - t197*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t194*x1_1_on_boundary_by_w - t197*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t199 + slope_by_v1_2*t201 + slope_by_x1_2*t202 + slope_by_x2_2*(-t194*x2_1 + t197*v2_1) + t194*v1_1_on_boundary_by_u - t194*v2_1_on_boundary_by_w - t194*x2_1_on_boundary_by_y - t196*x1_1_on_boundary_by_u + t196*x2_1_on_boundary_by_w + t197*v2_1_on_boundary_by_y;
    const double t204 = slope_by_carried_x1_2_by_u*(t194*x2_1_on_boundary_by_u - t197*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t194*x2_1_on_boundary_by_w - t197*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t194*x2_1_on_boundary_by_y - t197*v2_1_on_boundary_by_y) + slope_by_v1_2*(t194*v2_1 - t196*x2_1) + slope_by_x1_2*(t194*x2_1 - t197*v2_1) + t194*v2_1_on_boundary_by_u - t196*x2_1_on_boundary_by_u;
    const double t205 = delay_tau1_by_y*t201 + slope_by_x2_2*t202 + t194*v1_1_on_boundary_by_w - t196*x1_1_on_boundary_by_w + t199;
    const double t206 = -k3*t161 + t161*t81*x1_1 - t162*x2_1;
    const double t207 = (1.0/(m2*m2));
    const double t208 = k1*t207;
    const double t209 = t207*t86*x2_1 - t208*x1_1;
    const double t210 = k3*t9;
    const double t211 = t210*t36;
    const double t212 = p2*t210;
    const double t213 = -k2 - k3;
    const double t214 = (1.0/(t8*t8));
    const double t215 = t214*t7;
    const double t216 = t213*t215;
    const double t217 = t214*t6;
    const double t218 = t213*t217;
    const double t219 = p2*t218;
    const double t220 = t210*t42;
    const double t221 = -omega1*t14;
    const double t222 = p1*t210;
    const double t223 = t210*t45;
    const double t224 = p1*t218;
    const double t225 = t212 + t219;
    const double t226 = t14*t210;
    const double t227 = p3*t210;
    const double t228 = -p3*t216 - t227;
    const double t229 = t80*x2_1 - t82;
    const double t230 = t85 - t87;
    const double t232 = -t215*t81;
    const double t233 = -t217*t81;
    const double t234 = p2*t233;
    const double t235 = p3*t232 + t227;
    const double t236 = t86*t9;
    const double t237 = k1*t9;
    const double t238 = p2*t237;
    const double t240 = -t215*t86;
    const double t241 = -t217*t86;
    const double t242 = p2*t241;
    const double t243 = p1*t237;
    const double t244 = p1*t241;
    const double t245 = t238 + t242;
    const double t246 = -p3*t236 - p3*t240;
    const double t247 = t80 - t82;
    if (trace_gradient) {
        trace_gradient[lane] = slope_by_v1_1*t40 + slope_by_v2_1*t48 + slope_by_x1_1*t24 + slope_by_x2_1*t34;
        trace_gradient[1*lanes + lane] = slope_by_v1_1*t25 + slope_by_v2_1*t35 + slope_by_x1_1*t21 + slope_by_x2_1*t32;
        trace_gradient[2*lanes + lane] = slope_by_v1_1*t24 + slope_by_v2_1*t34 + slope_by_x1_1*t23 + slope_by_x2_1*t33;
        trace_gradient[3*lanes + lane] = cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t159 - omega2*t160 - slope_by_tau1;
        trace_gradient[4*lanes + lane] = delay_tau1_by_u*(t162*x1_2 - t162*x2_2) + omega1_by_m1*t166 + omega2_by_m1*t169 + omega3_by_m1*t173 + omega4_by_m1*t178 + p1_by_m1*t190 + p2_by_m1*t192 + p3_by_m1*t193 + p4_by_m1*t203 + p5_by_m1*t204 + p6_by_m1*t205 + t131*t206 + t132*t206 + t133*t206;
        trace_gradient[5*lanes + lane] = delay_tau1_by_w*(t207*t86*x2_2 - t208*x1_2) + omega1_by_m2*t166 + omega2_by_m2*t169 + omega3_by_m2*t173 + omega4_by_m2*t178 + p1_by_m2*t190 + p2_by_m2*t192 + p3_by_m2*t193 + p4_by_m2*t203 + p5_by_m2*t204 + p6_by_m2*t205 + t134*t209 + t136*t209 + t137*t209;
        trace_gradient[6*lanes + lane] = delay_tau1_by_u*(t80*x2_2 - t90) + delay_tau1_by_w*(t92 - t93) + omega1_by_k1*t166 + omega2_by_k1*t169 + omega3_by_k1*t173 + omega4_by_k1*t178 + p1_by_k1*t190 + p2_by_k1*t192 + p3_by_k1*t193 + p4_by_k1*t203 + p5_by_k1*t204 + p6_by_k1*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t212 + omega1*t219 + t211 + t216*t36) + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t213*t214*t7 - omega2*t212 - omega2*t219)) + slope_by_v2_1*(sin_omega1_tau*(t210*t221 + t216*t42 + t218*t221 + t220) + sin_omega2_tau*(omega2*t222 + omega2*t224 - t216*t45 - t223)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t216 - t222 - t225) + cos_omega2_tau*(t14*t216 + t225 + t226) + t210 + t216) + slope_by_x2_1*(cos_omega1_tau*(t14*t218 + t226 + t228) + cos_omega2_tau*(-t222 - t224 - t228) + t210 + t218) + t131*t229 + t132*t229 + t133*t229 + t134*t230 + t136*t230 + t137*t230;
        trace_gradient[7*lanes + lane] = -delay_tau1_by_w*t93 + omega1_by_k2*t166 + omega2_by_k2*t169 + omega3_by_k2*t173 + omega4_by_k2*t178 + p1_by_k2*t190 + p2_by_k2*t192 + p3_by_k2*t193 + p4_by_k2*t203 + p5_by_k2*t204 + p6_by_k2*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t234 + t211 + t232*t36) + sin_omega2_tau*(-omega2*t234 + t210*t41 + t232*t41)) + slope_by_v2_1*(sin_omega1_tau*(t220 + t221*t233 + t232*t42) + sin_omega2_tau*(-k1*k3*omega2*p1*t214*t81 - t223 - t232*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t232 - t222 - t234) + cos_omega2_tau*(t14*t232 + t226 + t234) + t210 + t232) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t14*t214*t81 - t235) + cos_omega2_tau*(-p1*t233 + t235) + t233) - t134*t87 - t136*t87 - t137*t87;
        trace_gradient[8*lanes + lane] = omega1_by_k3*t166 + omega2_by_k3*t169 + omega3_by_k3*t173 + omega4_by_k3*t178 + p1_by_k3*t190 + p2_by_k3*t192 + p3_by_k3*t193 + p4_by_k3*t203 + p5_by_k3*t204 + p6_by_k3*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t238 + omega1*t242 + t236*t36 + t240*t36) + sin_omega2_tau*(omega2*t14*t214*t7*t86 - omega2*t14*t86*t9 - omega2*t238 - omega2*t242)) + slope_by_v2_1*(sin_omega1_tau*(t221*t237 + t221*t241 + t236*t42 + t240*t42) + sin_omega2_tau*(omega2*t243 + omega2*t244 - t236*t45 - t240*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t236 - p1*t240 - t245) + cos_omega2_tau*(t14*t236 + t14*t240 + t245) + t236 + t240) + slope_by_x2_1*(cos_omega1_tau*(t14*t237 + t14*t241 + t246) + cos_omega2_tau*(-t243 - t244 - t246) + t237 + t241) + t131*t247 + t132*t247 + t133*t247;
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
 * Operations: 245. Intermediate terms: 58. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_passage(
    const double parameters[6], const double spectrum[12], const double unknowns[4], double *states,
    double *coefficients, double *frequencies)
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
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* functions of tau1 in free */
    const double t26 = omega3*tau1;
    const double cos_omega3_tau1 = cos(t26);
    const double sin_omega3_tau1 = sin(t26);
    const double t27 = omega4*tau1;
    const double cos_omega4_tau1 = cos(t27);
    const double sin_omega4_tau1 = sin(t27);
    /* free for tau1, until first-reaches-stop */
    const double t28 = (1.0/(omega3));
    const double t29 = sin_omega3_tau1*t28;
    const double t30 = 1 - p4;
    const double t31 = (1.0/(omega4));
    const double t32 = sin_omega4_tau1*t31;
    const double t33 = cos_omega3_tau1*p4 + cos_omega4_tau1*t30;
    const double t34 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5;
    const double x1_2 = t33*x1_1 + t34*x2_1 + v1_1*(p4*t29 + t30*t32) + v2_1*(p5*sin_omega3_tau1*t28 - p5*t32);
    const double t35 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6;
    const double t36 = cos_omega3_tau1*t30 + cos_omega4_tau1*p4;
    const double x2_2 = t35*x1_1 + t36*x2_1 + v1_1*(p6*sin_omega3_tau1*t28 - p6*t32) + v2_1*(p4*t32 + t29*t30);
    const double t37 = omega3*sin_omega3_tau1;
    const double t38 = omega4*sin_omega4_tau1;
    const double v1_2 = t33*v1_1 + t34*v2_1 + x1_1*(-p4*t37 - t30*t38) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t37);
    const double v2_2 = t35*v1_1 + t36*v2_1 + x1_1*(omega4*p6*sin_omega4_tau1 - p6*t37) + x2_1*(-p4*t38 - t30*t37);
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
    const double t39 = -p1 - p2*y;
    const double t40 = p2*w;
    const double t41 = p5*x2_1;
    const double t42 = p5*v2_1;
    if (coefficients) {
        coefficients[0] = 1 - t5;
        coefficients[1] = 0;
        coefficients[2] = t39 + t9;
        coefficients[3] = -t11 - t39 - 1;
        coefficients[4] = -p1*t12*u - t12*t40;
        coefficients[5] = t10*t15*u + t15*t40;
        coefficients[6] = -1;
        coefficients[7] = 0;
        coefficients[8] = p4*x1_1 + t41;
        coefficients[9] = t30*x1_1 - t41;
        coefficients[10] = p4*t28*v1_1 + t28*t42;
        coefficients[11] = t30*t31*v1_1 - t31*t42;
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
 * Operations: 541. Intermediate terms: 193. */
NONSMOOTH_UNMERGED
void elastic_stop_one_contact_linearisation(
    const double parameters[6], const double spectrum[12], const double unknowns[4],
    double *poincare_jacobian, double *saltations, double *monodromy)
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
    const double t50 = omega4*p6*sin_omega4_tau1 - p6*t46;
    const double t51 = -p4*t47 - t36*t46;
    const double v2_2 = t44*v1_1 + t45*v2_1 + t50*x1_1 + t51*x2_1;
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
    const double carried_v2_1_by_y = t30;
    const double carried_v2_1_by_u = t24;
    const double carried_v2_1_by_w = t23;
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
    const double t54 = k3*t53;
    const double t55 = k1*t53;
    const double t56 = t53*(k1 + k3);
    const double t57 = t54 + t55*x2_1 - t56*x1_1;
    const double v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t57;
    const double v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t57;
    const double v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t57;
    const double t58 = (1.0/(m2));
    const double t59 = k1*t58;
    const double t60 = t58*(k1 + k2);
    const double t61 = t59*x1_1 - t60*x2_1;
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t61;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t61;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t61;
    /* Phi along tau1 */
    const double carried_x1_2_by_y = t38*v1_1_on_boundary_by_y + t39*v2_1_on_boundary_by_y + t40*x1_1_on_boundary_by_y + t41*x2_1_on_boundary_by_y;
    const double carried_x1_2_by_u = t38*v1_1_on_boundary_by_u + t39*v2_1_on_boundary_by_u + t40*x1_1_on_boundary_by_u + t41*x2_1_on_boundary_by_u;
    const double carried_x1_2_by_w = t38*v1_1_on_boundary_by_w + t39*v2_1_on_boundary_by_w + t40*x1_1_on_boundary_by_w + t41*x2_1_on_boundary_by_w;
    const double carried_x2_2_by_y = t42*v1_1_on_boundary_by_y + t43*v2_1_on_boundary_by_y + t44*x1_1_on_boundary_by_y + t45*x2_1_on_boundary_by_y;
    const double carried_x2_2_by_u = t42*v1_1_on_boundary_by_u + t43*v2_1_on_boundary_by_u + t44*x1_1_on_boundary_by_u + t45*x2_1_on_boundary_by_u;
    const double carried_x2_2_by_w = t42*v1_1_on_boundary_by_w + t43*v2_1_on_boundary_by_w + t44*x1_1_on_boundary_by_w + t45*x2_1_on_boundary_by_w;
    const double carried_v1_2_by_y = t40*v1_1_on_boundary_by_y + t41*v2_1_on_boundary_by_y + t48*x1_1_on_boundary_by_y + t49*x2_1_on_boundary_by_y;
    const double carried_v1_2_by_u = t40*v1_1_on_boundary_by_u + t41*v2_1_on_boundary_by_u + t48*x1_1_on_boundary_by_u + t49*x2_1_on_boundary_by_u;
    const double carried_v1_2_by_w = t40*v1_1_on_boundary_by_w + t41*v2_1_on_boundary_by_w + t48*x1_1_on_boundary_by_w + t49*x2_1_on_boundary_by_w;
    const double carried_v2_2_by_y = t44*v1_1_on_boundary_by_y + t45*v2_1_on_boundary_by_y + t50*x1_1_on_boundary_by_y + t51*x2_1_on_boundary_by_y;
    const double carried_v2_2_by_u = t44*v1_1_on_boundary_by_u + t45*v2_1_on_boundary_by_u + t50*x1_1_on_boundary_by_u + t51*x2_1_on_boundary_by_u;
    const double carried_v2_2_by_w = t44*v1_1_on_boundary_by_w + t45*v2_1_on_boundary_by_w + t50*x1_1_on_boundary_by_w + t51*x2_1_on_boundary_by_w;
    /* derivatives of the time to the boundary after tau1 */
    const double t62 = (1.0/(v1_2));
    const double delay_tau1_by_y = -carried_x1_2_by_y*t62;
    const double delay_tau1_by_u = -carried_x1_2_by_u*t62;
    const double delay_tau1_by_w = -carried_x1_2_by_w*t62;
    /* perturbation on the boundary after tau1 */
    const double x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2;
    const double x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2;
    const double x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2;
    const double t63 = k1*t53*x2_2 - t55*x1_2;
    const double v1_2_on_boundary_by_y = carried_v1_2_by_y + delay_tau1_by_y*t63;
    const double v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t63;
    const double v1_2_on_boundary_by_w = carried_v1_2_by_w + delay_tau1_by_w*t63;
    const double t64 = t59*x1_2 - t60*x2_2;
    const double v2_2_on_boundary_by_y = carried_v2_2_by_y + delay_tau1_by_y*t64;
    const double v2_2_on_boundary_by_u = carried_v2_2_by_u + delay_tau1_by_u*t64;
    const double v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t64;
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
    const double before_v1_1 = t57;
    const double before_v2_1 = t61;
    const double behind_v1_1 = k1*t53*x2_1 - t55*x1_1;
    const double behind_v2_1 = t61;
    /* vector fields at transition 2 */
    const double before_v1_2 = t63;
    const double before_v2_2 = t64;
    const double behind_v1_2 = t54 + t55*x2_2 - t56*x1_2;
    const double behind_v2_2 = t64;
    /* saltations */
    const double t65 = (1.0/(v1_1));
    const double t66 = t65*(before_v1_1 - behind_v1_1);
    const double t67 = t65*(before_v2_1 - behind_v2_1);
    const double t68 = t62*(-before_v1_2 + behind_v1_2);
    const double t69 = t62*(-before_v2_2 + behind_v2_2);
    if (saltations) {
        saltations[0] = 1;
        saltations[1] = 0;
        saltations[2] = 0;
        saltations[3] = 0;
        saltations[4] = 0;
        saltations[5] = 1;
        saltations[6] = 0;
        saltations[7] = 0;
        saltations[8] = -t66;
        saltations[9] = 0;
        saltations[10] = 1;
        saltations[11] = 0;
        saltations[12] = -t67;
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
        saltations[24] = t68;
        saltations[25] = 0;
        saltations[26] = 1;
        saltations[27] = 0;
        saltations[28] = t69;
        saltations[29] = 0;
        saltations[30] = 0;
        saltations[31] = 1;
    }
    if (!monodromy)
        return;
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
    const double saltation_1_20 = -phi_1_00*t66 + phi_1_20;
    const double saltation_1_21 = -phi_1_01*t66 + phi_1_21;
    const double saltation_1_22 = -phi_1_02*t66 + phi_1_22;
    const double saltation_1_23 = -phi_1_03*t66 + phi_1_23;
    const double saltation_1_30 = -phi_1_00*t67 + phi_1_30;
    const double saltation_1_31 = -phi_1_01*t67 + phi_1_31;
    const double saltation_1_32 = -phi_1_02*t67 + phi_1_32;
    const double saltation_1_33 = -phi_1_03*t67 + phi_1_33;
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
    const double phi_2_30 = phi_1_00*t50 + phi_1_10*t51 + saltation_1_20*t44 + saltation_1_30*t45;
    const double phi_2_31 = phi_1_01*t50 + phi_1_11*t51 + saltation_1_21*t44 + saltation_1_31*t45;
    const double phi_2_32 = phi_1_02*t50 + phi_1_12*t51 + saltation_1_22*t44 + saltation_1_32*t45;
    const double phi_2_33 = phi_1_03*t50 + phi_1_13*t51 + saltation_1_23*t44 + saltation_1_33*t45;
    /* saltation of phase 2 */
    const double saltation_2_20 = phi_2_00*t68 + phi_2_20;
    const double saltation_2_21 = phi_2_01*t68 + phi_2_21;
    const double saltation_2_22 = phi_2_02*t68 + phi_2_22;
    const double saltation_2_23 = phi_2_03*t68 + phi_2_23;
    const double saltation_2_30 = phi_2_00*t69 + phi_2_30;
    const double saltation_2_31 = phi_2_01*t69 + phi_2_31;
    const double saltation_2_32 = phi_2_02*t69 + phi_2_32;
    const double saltation_2_33 = phi_2_03*t69 + phi_2_33;
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
    /* state_after */
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
    /* state_after */
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

/* All unknowns from the reduced ones; how singular the linear equations for them are: 0 if they are; the equations for these and their derivatives.
 * Operations: 446. Intermediate terms: 137. */
static NONSMOOTH_INLINE void elastic_stop_one_contact_reduced_fixed_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, double *fixed)
{
    const double k1 = parameters[2*lanes + lane];
    const double k2 = parameters[3*lanes + lane];
    const double k3 = parameters[4*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane];
    const double omega2 = spectrum[2*lanes + lane];
    const double p1 = spectrum[3*lanes + lane];
    const double p2 = spectrum[4*lanes + lane];
    const double p3 = spectrum[5*lanes + lane];
    const double omega3 = spectrum[7*lanes + lane];
    const double omega4 = spectrum[8*lanes + lane];
    const double p4 = spectrum[9*lanes + lane];
    const double p5 = spectrum[10*lanes + lane];
    /* coefficients of the linear equations */
    const double t12 = k1*k2;
    const double t13 = k1*k3;
    const double t14 = k2*k3;
    const double t15 = (1.0/((t12 + t13 + t14)));
    const double t16 = p2*t13;
    const double t17 = p2*t12 + p2*t14 + t16;
    const double t18 = t15*t17;
    const double t20 = p1 - 1;
    const double t23 = p1*t12;
    const double t24 = p1*t13;
    const double t25 = p1*t14 + t23 + t24;
    const double t26 = -t12 - t13 - t14 + t25;
    const double t30 = p4 - 1;
    /* right-hand sides of the linear equations */
    const double t31 = -t16 + t23;
    const double t32 = k1*k2*p1 - t12 - t16;
    const double t33 = p3*t12 + t24;
    const double t34 = t13 - t33;
    /* determinants */
    const double t77 = 2*(p2*p2);
    const double t82 = (p1*p1);
    const double t83 = (t20*t20) + t82;
    const double t85 = 2*(p5*p5);
    /* d/dtau of: functions of half_tau in contact */
    const double t51 = (1.0/2.0)*omega1;
    const double t52 = (1.0/2.0)*omega2;
    /* d/dtau of: functions of half_tau1 in free */
    const double t53 = (1.0/2.0)*omega3;
    const double t54 = (1.0/2.0)*omega4;
    fixed[lane] = t15;
    fixed[1*lanes + lane] = t17;
    fixed[2*lanes + lane] = t18;
    fixed[3*lanes + lane] = t20;
    fixed[4*lanes + lane] = t25;
    fixed[5*lanes + lane] = t26;
    fixed[6*lanes + lane] = t30;
    fixed[7*lanes + lane] = t31;
    fixed[8*lanes + lane] = t32;
    fixed[9*lanes + lane] = t33;
    fixed[10*lanes + lane] = t34;
    fixed[11*lanes + lane] = t77;
    fixed[12*lanes + lane] = t82;
    fixed[13*lanes + lane] = t83;
    fixed[14*lanes + lane] = t85;
    fixed[15*lanes + lane] = t51;
    fixed[16*lanes + lane] = t52;
    fixed[17*lanes + lane] = t53;
    fixed[18*lanes + lane] = t54;
}

static NONSMOOTH_INLINE void elastic_stop_one_contact_reduced_in_lane(
    int lanes, int lane, const double *parameters, const double *spectrum, const double *fixed,
    const double *reduced, double *unknowns, double *determinants, double *reduced_residual,
    double *reduced_jacobian)
{
    const double T = parameters[5*lanes + lane];
    const double omega1 = spectrum[1*lanes + lane];
    const double omega2 = spectrum[2*lanes + lane];
    const double p1 = spectrum[3*lanes + lane];
    const double p2 = spectrum[4*lanes + lane];
    const double p3 = spectrum[5*lanes + lane];
    const double omega3 = spectrum[7*lanes + lane];
    const double omega4 = spectrum[8*lanes + lane];
    const double p4 = spectrum[9*lanes + lane];
    const double p5 = spectrum[10*lanes + lane];
    const double p6 = spectrum[11*lanes + lane];
    const double t15 = fixed[lane];
    const double t17 = fixed[1*lanes + lane];
    const double t18 = fixed[2*lanes + lane];
    const double t20 = fixed[3*lanes + lane];
    const double t25 = fixed[4*lanes + lane];
    const double t26 = fixed[5*lanes + lane];
    const double t30 = fixed[6*lanes + lane];
    const double t31 = fixed[7*lanes + lane];
    const double t32 = fixed[8*lanes + lane];
    const double t33 = fixed[9*lanes + lane];
    const double t34 = fixed[10*lanes + lane];
    const double t77 = fixed[11*lanes + lane];
    const double t82 = fixed[12*lanes + lane];
    const double t83 = fixed[13*lanes + lane];
    const double t85 = fixed[14*lanes + lane];
    const double t51 = fixed[15*lanes + lane];
    const double t52 = fixed[16*lanes + lane];
    const double t53 = fixed[17*lanes + lane];
    const double t54 = fixed[18*lanes + lane];
    const double tau = reduced[lane];
    /* half of tau */
    const double half_tau = (1.0/2.0)*tau;
    /* functions of half_tau in contact */
    const double t0 = half_tau*omega1;
    const nonsmooth_wave wave_0 = nonsmooth_wave_of(lanes, t0);
    const double cos_omega1_half_tau = wave_0.cosine;
    const double sin_omega1_half_tau = wave_0.sine;
    const double t3 = half_tau*omega2;
    const nonsmooth_wave wave_1 = nonsmooth_wave_of(lanes, t3);
    const double cos_omega2_half_tau = wave_1.cosine;
    const double sin_omega2_half_tau = wave_1.sine;
    /* tau1 completes the period */
    const double tau1 = T - tau;
    /* half of tau1 */
    const double half_tau1 = (1.0/2.0)*tau1;
    /* functions of half_tau1 in free */
    const double t6 = half_tau1*omega3;
    const nonsmooth_wave wave_2 = nonsmooth_wave_of(lanes, t6);
    const double cos_omega3_half_tau1 = wave_2.cosine;
    const double sin_omega3_half_tau1 = wave_2.sine;
    const double t9 = half_tau1*omega4;
    const nonsmooth_wave wave_3 = nonsmooth_wave_of(lanes, t9);
    const double cos_omega4_half_tau1 = wave_3.cosine;
    const double sin_omega4_half_tau1 = wave_3.sine;
    const double t19 = omega1*sin_omega1_half_tau;
    const double coefficient11 = omega2*sin_omega2_half_tau*t15*t17 - t18*t19;
    const double coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t20;
    const double coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2;
    const double t27 = t15*t19;
    const double t28 = omega2*sin_omega2_half_tau*t15;
    const double coefficient21 = -t25*t28 + t26*t27;
    const double coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3;
    const double coefficient23 = -cos_omega1_half_tau*t20 + cos_omega2_half_tau*p1;
    const double t29 = omega3*sin_omega3_half_tau1;
    const double coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t29;
    const double coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t30;
    const double coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5;
    const double right1 = t27*t31 - t28*t32;
    const double right2 = -omega2*sin_omega2_half_tau*t15*t33 - t27*t34;
    const double t36 = omega4*sin_omega4_half_tau1;
    const double right3 = p4*t29 - t30*t36;
    /* determinant of the linear equations */
    const double t37 = coefficient22*coefficient33;
    const double t38 = coefficient21*coefficient32;
    const double t39 = coefficient23*coefficient32;
    const double t40 = coefficient21*coefficient33;
    const double t41 = coefficient22*coefficient31;
    const double determinant = coefficient11*t37 - coefficient11*t39 + coefficient12*coefficient23*coefficient31 - coefficient12*t40 + coefficient13*t38 - coefficient13*t41;
    /* numerators of Cramer's rule */
    const double t42 = coefficient12*coefficient23;
    const double t43 = coefficient12*coefficient33;
    const double t44 = coefficient13*coefficient22;
    const double numerator1 = coefficient13*coefficient32*right2 + right1*t37 - right1*t39 - right2*t43 + right3*t42 - right3*t44;
    const double t45 = coefficient11*coefficient23;
    const double t46 = coefficient13*coefficient31;
    const double numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t40 - right2*t46 - right3*t45;
    const double t47 = coefficient11*coefficient22;
    const double t48 = coefficient11*coefficient32;
    const double t49 = coefficient12*coefficient21;
    const double numerator3 = coefficient12*coefficient31*right2 + right1*t38 - right1*t41 - right2*t48 + right3*t47 - right3*t49;
    /* y, u, w by Cramer's rule */
    const double t50 = (1.0/(determinant));
    const double y = numerator1*t50;
    const double u = numerator2*t50;
    const double w = numerator3*t50;
    if (unknowns) {
        unknowns[lane] = y;
        unknowns[1*lanes + lane] = u;
        unknowns[2*lanes + lane] = w;
        unknowns[3*lanes + lane] = tau;
    }
    if (!determinants && !reduced_residual && !reduced_jacobian)
        return;
    const double t78 = (half_tau*half_tau);
    const double t79 = t77*t78;
    const double t80 = (omega1*omega1*omega1*omega1)/((omega1*omega1)*t78 + 1);
    const double t81 = (omega2*omega2*omega2*omega2)/((omega2*omega2)*t78 + 1);
    const double t84 = 2*t78;
    const double t86 = (half_tau1*half_tau1);
    const double t87 = t85*t86;
    if (determinants) {
        determinants[lane] = determinant/(sqrt(2*(p3*p3) + (t20*t20)*t80*t84 + t81*t82*t84 + t83)*sqrt(t77 + t79*t80 + t79*t81 + t83)*sqrt((omega3*omega3*omega3*omega3)*t87/((omega3*omega3)*t86 + 1) + (omega4*omega4*omega4*omega4)*t87/((omega4*omega4)*t86 + 1) + (p4*p4) + (t30*t30) + t85));
    }
    if (!reduced_residual && !reduced_jacobian)
        return;
    /* reduced_residual */
    const double t88 = omega4*p6*sin_omega4_half_tau1 - p6*t29;
    const double t89 = -p4*t36 + t29*t30;
    const double t90 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6;
    const double t91 = cos_omega3_half_tau1*t30 - cos_omega4_half_tau1*p4;
    if (reduced_residual) {
        reduced_residual[lane] = determinant*t88 + numerator1*t89 + numerator2*t90 + numerator3*t91;
    }
    if (!reduced_jacobian)
        return;
    const double cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t51;
    const double sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t51;
    const double cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t52;
    const double sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t52;
    const double cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t53;
    const double sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t53;
    const double cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t54;
    const double sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t54;
    /* d/dtau of: coefficients of the linear equations */
    const double t55 = omega1*sin_omega1_half_tau_by_tau;
    const double coefficient11_by_tau = omega2*sin_omega2_half_tau_by_tau*t15*t17 - t18*t55;
    const double coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 - cos_omega2_half_tau_by_tau*t20;
    const double coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2;
    const double t56 = t15*t55;
    const double t57 = omega2*sin_omega2_half_tau_by_tau*t15;
    const double coefficient21_by_tau = -t25*t57 + t26*t56;
    const double coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3;
    const double coefficient23_by_tau = -cos_omega1_half_tau_by_tau*t20 + cos_omega2_half_tau_by_tau*p1;
    const double t58 = omega3*sin_omega3_half_tau1_by_tau;
    const double coefficient31_by_tau = omega4*p5*sin_omega4_half_tau1_by_tau - p5*t58;
    const double coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t30;
    const double coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5;
    /* d/dtau of: right-hand sides of the linear equations */
    const double right1_by_tau = t31*t56 - t32*t57;
    const double right2_by_tau = -omega2*sin_omega2_half_tau_by_tau*t15*t33 - t34*t56;
    const double right3_by_tau = -omega4*sin_omega4_half_tau1_by_tau*t30 + p4*t58;
    /* d/dtau of: determinant of the linear equations */
    const double t59 = t37 - t39;
    const double t60 = coefficient23*coefficient31 - t40;
    const double t61 = t38 - t41;
    const double t62 = coefficient13*coefficient32 - t43;
    const double t63 = coefficient11*coefficient33 - t46;
    const double t64 = coefficient12*coefficient31 - t48;
    const double t65 = t42 - t44;
    const double t66 = coefficient13*coefficient21 - t45;
    const double t67 = t47 - t49;
    const double determinant_by_tau = coefficient11_by_tau*t59 + coefficient12_by_tau*t60 + coefficient13_by_tau*t61 + coefficient21_by_tau*t62 + coefficient22_by_tau*t63 + coefficient23_by_tau*t64 + coefficient31_by_tau*t65 + coefficient32_by_tau*t66 + coefficient33_by_tau*t67;
    /* d/dtau of: numerators of Cramer's rule */
    const double t68 = coefficient23*right3 - coefficient33*right2;
    const double t69 = coefficient22*right3 - coefficient32*right2;
    const double t70 = coefficient13*right3 - coefficient33*right1;
    const double t71 = coefficient12*right3 - coefficient32*right1;
    const double t72 = coefficient13*right2 - coefficient23*right1;
    const double t73 = coefficient12*right2 - coefficient22*right1;
    const double numerator1_by_tau = coefficient12_by_tau*t68 - coefficient13_by_tau*t69 - coefficient22_by_tau*t70 + coefficient23_by_tau*t71 + coefficient32_by_tau*t72 - coefficient33_by_tau*t73 + right1_by_tau*t59 + right2_by_tau*t62 + right3_by_tau*t65;
    const double t74 = coefficient21*right3 - coefficient31*right2;
    const double t75 = coefficient11*right3 - coefficient31*right1;
    const double t76 = coefficient11*right2 - coefficient21*right1;
    const double numerator2_by_tau = -coefficient11_by_tau*t68 + coefficient13_by_tau*t74 + coefficient21_by_tau*t70 - coefficient23_by_tau*t75 - coefficient31_by_tau*t72 + coefficient33_by_tau*t76 + right1_by_tau*t60 + right2_by_tau*t63 + right3_by_tau*t66;
    const double numerator3_by_tau = coefficient11_by_tau*t69 - coefficient12_by_tau*t74 - coefficient21_by_tau*t71 + coefficient22_by_tau*t75 + coefficient31_by_tau*t73 - coefficient32_by_tau*t76 + right1_by_tau*t61 + right2_by_tau*t64 + right3_by_tau*t67;
    /* reduced_jacobian */
    const double t92 = numerator2*p6;
    const double t93 = determinant*p6;
    if (reduced_jacobian) {
        reduced_jacobian[lane] = cos_omega3_half_tau1_by_tau*(numerator3*t30 - t92) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t92) + determinant_by_tau*t88 + numerator1_by_tau*t89 + numerator2_by_tau*t90 + numerator3_by_tau*t91 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t30 - omega3*t93) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t93);
    }
}

NONSMOOTH_UNMERGED
void elastic_stop_one_contact_reduced(
    const double parameters[6], const double spectrum[12], const double reduced[1],
    double *unknowns, double *determinants, double *reduced_residual, double *reduced_jacobian)
{
    double fixed[19];
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
        double fixed[19 * lanes], determinant[1 * lanes], x[1 * lanes], equation[1 * lanes], jacobian[1 * lanes];
        double slope[lanes], largest[lanes], open[lanes], doubt[lanes];
        int32_t taken[lanes], ended[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            open[lane] = reduced > 0 ? 1.0 : 0.0;
            taken[lane] = 0;
            doubt[lane] = 0.0;
        }
        nonsmooth_load(lanes, p, parameters, count, start, parameter);
        double own[5 * lanes], spectrum[12 * lanes];
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 4 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 3 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 4 * lanes);
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
    static const int sums[] = {1, 1}, terms[] = {2, 2}, at_once[] = {0, 0};
    static const int opened[] = {-1, -1};
    static const int exits[] = {0, 6}, first_frequency[] = {0, 2};
    static const int begins[] = {1, 1};
    static const double per_unit[] = {0.0, 0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 6 * point, *const u = unknowns + 4 * point;
        const double q[5] = {p[2], p[3], p[4], p[0], p[1]};
        const double durations[] = {u[3], p[5] - u[3]};
        double spectral[12], coefficients[12], frequencies[4];
        elastic_stop_spectrum(q, spectral, NULL);
        elastic_stop_one_contact_passage(p, spectral, u, NULL, coefficients, frequencies);
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
        nonsmooth_load(lanes, 1, parameters + 2 * count, count, start, own + 0 * lanes);
        nonsmooth_load(lanes, 1, parameters + 3 * count, count, start, own + 1 * lanes);
        nonsmooth_load(lanes, 1, parameters + 4 * count, count, start, own + 2 * lanes);
        nonsmooth_load(lanes, 1, parameters + 0 * count, count, start, own + 3 * lanes);
        nonsmooth_load(lanes, 1, parameters + 1 * count, count, start, own + 4 * lanes);
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
