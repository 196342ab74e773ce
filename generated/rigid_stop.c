/* Generated; do not edit.
 * Source: nonsmooth.derive.systems.rigid_stop
 * Again: python scripts/regenerate.py
 * SymPy 1.14.0, derivation f03cf19002c3a6c5 */
#include "rigid_stop.h"

#include <math.h>

#include "nonsmooth_compiler.h"
#include "nonsmooth_sums.h"
#include "nonsmooth_trigonometry.h"

/* Frequencies and projector coefficients, with their derivatives by the parameters.
 * Operations: 179. Intermediate terms: 70. */
void rigid_stop_spectrum(
    const double parameters[4], double spectrum[7], double derivatives[28])
{
    const double k1 = parameters[0];
    const double k2 = parameters[1];
    const double m1 = parameters[2];
    const double m2 = parameters[3];
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
    const double t9 = sqrt(k1);
    const double t10 = (1.0/sqrt(m2));
    const double t11 = sqrt(k2);
    const double t12 = (1.0/sqrt(m1));
    const double t13 = t10*t11*t12*t9;
    const double omega2 = t13*t8;
    const double t14 = (1.0/(gap1));
    const double t15 = (1.0/2.0)*t14;
    const double p1 = t15*t5 + 1.0/2.0;
    const double p2 = -t1*t14;
    const double t16 = t14*t2;
    const double p3 = -k1*t16;
    const double t17 = sqrt(t3);
    const double omega3 = t10*t17;
    /* d/dk1 of: spectrum */
    const double gap1_by_k1 = t15*(8*t1*t2 + t5*(2*t0 - 2*t2));
    const double t18 = (1.0/2.0)*gap1_by_k1;
    const double t19 = (1.0/2.0)*t2;
    const double t20 = (1.0/2.0)*t8;
    const double omega1_by_k1 = t20*((1.0/2.0)*t0 + t18 + t19);
    const double t21 = t13/(omega1*omega1);
    const double omega2_by_k1 = -omega1_by_k1*t21 + (1.0/2.0)*t10*t11*t12*t8/t9;
    const double t22 = (1.0/(gap1*gap1));
    const double t23 = t22*t5;
    const double p1_by_k1 = t15*(t0 - t2) - t18*t23;
    const double p2_by_k1 = gap1_by_k1*k1*t0*t22 - t0*t14;
    const double p3_by_k1 = gap1_by_k1*k1*t2*t22 - t16;
    const double omega3_by_k1 = (1.0/2.0)*t10/t17;
    /* d/dk2 of: spectrum */
    const double gap1_by_k2 = -t16*t5;
    const double t25 = (1.0/2.0)*gap1_by_k2;
    const double omega1_by_k2 = t20*(t19 + t25);
    const double omega2_by_k2 = -omega1_by_k2*t21 + (1.0/2.0)*t10*t12*t8*t9/t11;
    const double p1_by_k2 = -t14*t19 - t23*t25;
    const double t26 = gap1_by_k2*t22;
    const double p2_by_k2 = t1*t26;
    const double t27 = k1*t2;
    const double p3_by_k2 = t26*t27;
    const double omega3_by_k2 = omega3_by_k1;
    /* d/dm1 of: spectrum */
    const double t28 = (1.0/(m1*m1));
    const double t29 = k1*t28;
    const double gap1_by_m1 = t15*(-t28*t7 - 2*t29*t5);
    const double t30 = (1.0/2.0)*gap1_by_m1;
    const double omega1_by_m1 = t20*(-1.0/2.0*t29 + t30);
    const double omega2_by_m1 = -omega1_by_m1*t21 - t10*t11*t20*t9/(sqrt(m1)*sqrt(m1)*sqrt(m1));
    const double p1_by_m1 = -t15*t29 - t23*t30;
    const double t31 = gap1_by_m1*t22;
    const double p2_by_m1 = t1*t31 + t14*t29;
    const double p3_by_m1 = t27*t31;
    /* d/dm2 of: spectrum */
    const double t32 = (1.0/(m2*m2));
    const double gap1_by_m2 = t15*(-4*t0*t32*t6 + 2*t3*t32*t5);
    const double t33 = (1.0/2.0)*gap1_by_m2;
    const double t34 = t3*t32;
    const double omega1_by_m2 = t20*(t33 - 1.0/2.0*t34);
    const double t35 = (1.0/(sqrt(m2)*sqrt(m2)*sqrt(m2)));
    const double omega2_by_m2 = -omega1_by_m2*t21 - t11*t12*t20*t35*t9;
    const double p1_by_m2 = t15*t34 - t23*t33;
    const double t36 = gap1_by_m2*t22;
    const double p2_by_m2 = t1*t36;
    const double p3_by_m2 = k1*t14*t32 + t27*t36;
    const double omega3_by_m2 = -1.0/2.0*t17*t35;
    spectrum[0] = gap1;
    spectrum[1] = omega1;
    spectrum[2] = omega2;
    spectrum[3] = p1;
    spectrum[4] = p2;
    spectrum[5] = p3;
    spectrum[6] = omega3;
    derivatives[0] = gap1_by_k1;
    derivatives[1] = gap1_by_k2;
    derivatives[2] = gap1_by_m1;
    derivatives[3] = gap1_by_m2;
    derivatives[4] = omega1_by_k1;
    derivatives[5] = omega1_by_k2;
    derivatives[6] = omega1_by_m1;
    derivatives[7] = omega1_by_m2;
    derivatives[8] = omega2_by_k1;
    derivatives[9] = omega2_by_k2;
    derivatives[10] = omega2_by_m1;
    derivatives[11] = omega2_by_m2;
    derivatives[12] = p1_by_k1;
    derivatives[13] = p1_by_k2;
    derivatives[14] = p1_by_m1;
    derivatives[15] = p1_by_m2;
    derivatives[16] = p2_by_k1;
    derivatives[17] = p2_by_k2;
    derivatives[18] = p2_by_m1;
    derivatives[19] = p2_by_m2;
    derivatives[20] = p3_by_k1;
    derivatives[21] = p3_by_k2;
    derivatives[22] = p3_by_m1;
    derivatives[23] = p3_by_m2;
    derivatives[24] = omega3_by_k1;
    derivatives[25] = omega3_by_k2;
    derivatives[26] = 0;
    derivatives[27] = omega3_by_m2;
}

/* State after a time in free.
 * Operations: 82. Intermediate terms: 16. */
void rigid_stop_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
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
    const double t14 = omega1*t2;
    const double t15 = omega2*t6;
    state_after[0] = t10*x1 + t11*x2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7);
    state_after[1] = t12*x1 + t13*x2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + x1*(-p1*t14 - t15*t4) + x2*(omega2*p2*t6 - p2*t14);
    state_after[3] = t12*v1 + t13*v2 + x1*(omega2*p3*t6 - p3*t14) + x2*(-p1*t15 - t14*t4);
}

/* State after a time in contact.
 * Operations: 31. Intermediate terms: 8. */
void rigid_stop_flow_contact(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double omega3 = spectrum[6];
    const double t = time;
    const double x1 = state[0];
    const double x2 = state[1];
    const double v1 = state[2];
    const double v2 = state[3];
    /* outputs */
    const double t0 = (1.0/((k1 + k2)));
    const double t1 = k1*t0;
    const double t2 = omega3*t;
    const double t3 = sin(t2);
    const double t4 = t3/omega3;
    const double t5 = cos(t2);
    const double t6 = k1*t0 - t1*t5;
    const double t7 = omega3*t3;
    state_after[0] = t*v1 + x1;
    state_after[1] = t4*v2 + t5*x2 + t6*x1 + v1*(t*t1 - t1*t4);
    state_after[2] = v1;
    state_after[3] = t1*t7*x1 + t5*v2 + t6*v1 - t7*x2;
}

/* Vector fields of the configurations, one below the other, offsets last.
 * Operations: 7. Intermediate terms: 4. */
void rigid_stop_fields(
    const double parameters[5], double fields[40])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    /* outputs */
    const double t0 = k1/m1;
    const double t1 = (1.0/(m2));
    const double t2 = k1*t1;
    const double t3 = -t1*(k1 + k2);
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
    fields[10] = -t0;
    fields[11] = t0;
    fields[12] = 0;
    fields[13] = 0;
    fields[14] = 0;
    fields[15] = t2;
    fields[16] = t3;
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
    fields[30] = 0;
    fields[31] = 0;
    fields[32] = 0;
    fields[33] = 0;
    fields[34] = 0;
    fields[35] = t2;
    fields[36] = t3;
    fields[37] = 0;
    fields[38] = 0;
    fields[39] = 0;
}

/* Affine functions of the state: gradients, constants last.
 * Operations: 3. Intermediate terms: 0. */
void rigid_stop_rows(
    const double parameters[5], double rows[25])
{
    const double k1 = parameters[2];
    rows[0] = 1;
    rows[1] = 0;
    rows[2] = 0;
    rows[3] = 0;
    rows[4] = -1;
    rows[5] = k1;
    rows[6] = -k1;
    rows[7] = 0;
    rows[8] = 0;
    rows[9] = 0;
    rows[10] = 0;
    rows[11] = 0;
    rows[12] = 1;
    rows[13] = 0;
    rows[14] = 0;
    rows[15] = -k1;
    rows[16] = k1;
    rows[17] = 0;
    rows[18] = 0;
    rows[19] = 0;
    rows[20] = 0;
    rows[21] = 0;
    rows[22] = 0;
    rows[23] = 0;
    rows[24] = 0;
}

/* Affine resets of the state, one below the other, offsets last.
 * Operations: 1. Intermediate terms: 0. */
void rigid_stop_resets(
    const double parameters[5], double resets[60])
{
    const double r = parameters[4];
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
    resets[32] = -r;
    resets[33] = 0;
    resets[34] = 0;
    resets[35] = 0;
    resets[36] = 0;
    resets[37] = 0;
    resets[38] = 1;
    resets[39] = 0;
    resets[40] = 0;
    resets[41] = 0;
    resets[42] = 0;
    resets[43] = 0;
    resets[44] = 1;
    resets[45] = 0;
    resets[46] = 1;
    resets[47] = 0;
    resets[48] = 0;
    resets[49] = 0;
    resets[50] = 0;
    resets[51] = 0;
    resets[52] = 0;
    resets[53] = 0;
    resets[54] = 0;
    resets[55] = 0;
    resets[56] = 0;
    resets[57] = 0;
    resets[58] = 1;
    resets[59] = 0;
}

/* Exponents of the modes; coefficients of their functions, offsets last.
 * Operations: 40. Intermediate terms: 5. */
void rigid_stop_modes(
    const double parameters[5], const double spectrum[7], double exponents[10],
    double coefficients[180])
{
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega3 = spectrum[6];
    /* outputs */
    const double t0 = 1 - p1;
    const double t1 = (1.0/(omega1));
    const double t4 = (1.0/(omega2));
    const double t5 = k1/(k1 + k2);
    const double t7 = (1.0/(omega3));
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
    coefficients[0] = 0;
    coefficients[1] = 0;
    coefficients[2] = 0;
    coefficients[3] = 0;
    coefficients[4] = 0;
    coefficients[5] = 0;
    coefficients[6] = 0;
    coefficients[7] = 0;
    coefficients[8] = 0;
    coefficients[9] = 0;
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
    coefficients[24] = 0;
    coefficients[25] = p3;
    coefficients[26] = t0;
    coefficients[27] = 0;
    coefficients[28] = 0;
    coefficients[29] = 0;
    coefficients[30] = 0;
    coefficients[31] = 0;
    coefficients[32] = p1;
    coefficients[33] = p2;
    coefficients[34] = 0;
    coefficients[35] = 0;
    coefficients[36] = 0;
    coefficients[37] = p3;
    coefficients[38] = t0;
    coefficients[39] = 0;
    coefficients[40] = 0;
    coefficients[41] = 0;
    coefficients[42] = p1*t1;
    coefficients[43] = p2*t1;
    coefficients[44] = 0;
    coefficients[45] = 0;
    coefficients[46] = 0;
    coefficients[47] = p3*t1;
    coefficients[48] = t0*t1;
    coefficients[49] = 0;
    coefficients[50] = -omega1*p1;
    coefficients[51] = -omega1*p2;
    coefficients[52] = 0;
    coefficients[53] = 0;
    coefficients[54] = 0;
    coefficients[55] = -omega1*p3;
    coefficients[56] = -omega1*t0;
    coefficients[57] = 0;
    coefficients[58] = 0;
    coefficients[59] = 0;
    coefficients[60] = t0;
    coefficients[61] = -p2;
    coefficients[62] = 0;
    coefficients[63] = 0;
    coefficients[64] = 0;
    coefficients[65] = -p3;
    coefficients[66] = p1;
    coefficients[67] = 0;
    coefficients[68] = 0;
    coefficients[69] = 0;
    coefficients[70] = 0;
    coefficients[71] = 0;
    coefficients[72] = t0;
    coefficients[73] = -p2;
    coefficients[74] = 0;
    coefficients[75] = 0;
    coefficients[76] = 0;
    coefficients[77] = -p3;
    coefficients[78] = p1;
    coefficients[79] = 0;
    coefficients[80] = 0;
    coefficients[81] = 0;
    coefficients[82] = t0*t4;
    coefficients[83] = -p2*t4;
    coefficients[84] = 0;
    coefficients[85] = 0;
    coefficients[86] = 0;
    coefficients[87] = -p3*t4;
    coefficients[88] = p1*t4;
    coefficients[89] = 0;
    coefficients[90] = -omega2*t0;
    coefficients[91] = omega2*p2;
    coefficients[92] = 0;
    coefficients[93] = 0;
    coefficients[94] = 0;
    coefficients[95] = omega2*p3;
    coefficients[96] = -omega2*p1;
    coefficients[97] = 0;
    coefficients[98] = 0;
    coefficients[99] = 0;
    coefficients[100] = 1;
    coefficients[101] = 0;
    coefficients[102] = 0;
    coefficients[103] = 0;
    coefficients[104] = 0;
    coefficients[105] = t5;
    coefficients[106] = 0;
    coefficients[107] = 0;
    coefficients[108] = 0;
    coefficients[109] = 0;
    coefficients[110] = 0;
    coefficients[111] = 0;
    coefficients[112] = 1;
    coefficients[113] = 0;
    coefficients[114] = 0;
    coefficients[115] = 0;
    coefficients[116] = 0;
    coefficients[117] = t5;
    coefficients[118] = 0;
    coefficients[119] = 0;
    coefficients[120] = 0;
    coefficients[121] = 0;
    coefficients[122] = 1;
    coefficients[123] = 0;
    coefficients[124] = 0;
    coefficients[125] = 0;
    coefficients[126] = 0;
    coefficients[127] = t5;
    coefficients[128] = 0;
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
    coefficients[140] = 0;
    coefficients[141] = 0;
    coefficients[142] = 0;
    coefficients[143] = 0;
    coefficients[144] = 0;
    coefficients[145] = -t5;
    coefficients[146] = 1;
    coefficients[147] = 0;
    coefficients[148] = 0;
    coefficients[149] = 0;
    coefficients[150] = 0;
    coefficients[151] = 0;
    coefficients[152] = 0;
    coefficients[153] = 0;
    coefficients[154] = 0;
    coefficients[155] = 0;
    coefficients[156] = 0;
    coefficients[157] = -t5;
    coefficients[158] = 1;
    coefficients[159] = 0;
    coefficients[160] = 0;
    coefficients[161] = 0;
    coefficients[162] = 0;
    coefficients[163] = 0;
    coefficients[164] = 0;
    coefficients[165] = 0;
    coefficients[166] = 0;
    coefficients[167] = -t5*t7;
    coefficients[168] = t7;
    coefficients[169] = 0;
    coefficients[170] = 0;
    coefficients[171] = 0;
    coefficients[172] = 0;
    coefficients[173] = 0;
    coefficients[174] = 0;
    coefficients[175] = omega3*t5;
    coefficients[176] = -omega3;
    coefficients[177] = 0;
    coefficients[178] = 0;
    coefficients[179] = 0;
}

/* Switching and periodicity equations.
 * Operations: 34. Intermediate terms: 13. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_residual(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double residual[2])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const double cos_omega1_half_T = cos(t0);
    const double sin_omega1_half_T = sin(t0);
    const double t1 = half_T*omega2;
    const double cos_omega2_half_T = cos(t1);
    const double sin_omega2_half_T = sin(t1);
    /* outputs */
    const double t2 = cos_omega1_half_T*u;
    const double t3 = p2*y;
    const double t4 = p1 - 1;
    const double t5 = omega2*sin_omega2_half_T;
    const double t6 = cos_omega2_half_T*u;
    const double t7 = omega1*sin_omega1_half_T;
    residual[0] = p1*t2 - t4*t6 + t5*(t3 + t4) - t7*(p1 + t3);
    residual[1] = p3*t2 - p3*t6 - t5*(p1*y - p3) + t7*(p1*y - p3 - y);
}

/* Derivatives of the equations by the unknowns.
 * Operations: 23. Intermediate terms: 9. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double jacobian[4])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    (void)unknowns;
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const double cos_omega1_half_T = cos(t0);
    const double sin_omega1_half_T = sin(t0);
    const double t1 = half_T*omega2;
    const double cos_omega2_half_T = cos(t1);
    const double sin_omega2_half_T = sin(t1);
    /* outputs */
    const double t2 = omega1*sin_omega1_half_T;
    const double t3 = p1 - 1;
    jacobian[0] = omega2*p2*sin_omega2_half_T - p2*t2;
    jacobian[1] = cos_omega1_half_T*p1 - cos_omega2_half_T*t3;
    jacobian[2] = -omega2*p1*sin_omega2_half_T + t2*t3;
    jacobian[3] = cos_omega1_half_T*p3 - cos_omega2_half_T*p3;
}

/* Equations and their derivatives by the unknowns, sharing all intermediate terms.
 * Operations: 45. Intermediate terms: 15. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_residual_and_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double residual[2], double jacobian[4])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const double cos_omega1_half_T = cos(t0);
    const double sin_omega1_half_T = sin(t0);
    const double t1 = half_T*omega2;
    const double cos_omega2_half_T = cos(t1);
    const double sin_omega2_half_T = sin(t1);
    /* outputs */
    const double t2 = cos_omega1_half_T*p1;
    const double t3 = p2*y;
    const double t4 = p1 - 1;
    const double t5 = omega2*sin_omega2_half_T;
    const double t6 = cos_omega2_half_T*t4;
    const double t7 = omega1*sin_omega1_half_T;
    const double t8 = cos_omega1_half_T*p3;
    const double t9 = cos_omega2_half_T*p3;
    residual[0] = t2*u + t5*(t3 + t4) - t6*u - t7*(p1 + t3);
    residual[1] = -t5*(p1*y - p3) + t7*(p1*y - p3 - y) + t8*u - t9*u;
    jacobian[0] = omega2*p2*sin_omega2_half_T - p2*t7;
    jacobian[1] = t2 - t6;
    jacobian[2] = -p1*t5 + t4*t7;
    jacobian[3] = t8 - t9;
}

/* Total derivatives of the equations by the parameters, through the spectrum too.
 * Operations: 212. Intermediate terms: 57. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_parameter_jacobian(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[28],
    const double unknowns[2], double parameter_jacobian[10])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega1_by_k1 = spectrum_derivatives[4];
    const double omega1_by_k2 = spectrum_derivatives[5];
    const double omega1_by_m1 = spectrum_derivatives[6];
    const double omega1_by_m2 = spectrum_derivatives[7];
    const double omega2_by_k1 = spectrum_derivatives[8];
    const double omega2_by_k2 = spectrum_derivatives[9];
    const double omega2_by_m1 = spectrum_derivatives[10];
    const double omega2_by_m2 = spectrum_derivatives[11];
    const double p1_by_k1 = spectrum_derivatives[12];
    const double p1_by_k2 = spectrum_derivatives[13];
    const double p1_by_m1 = spectrum_derivatives[14];
    const double p1_by_m2 = spectrum_derivatives[15];
    const double p2_by_k1 = spectrum_derivatives[16];
    const double p2_by_k2 = spectrum_derivatives[17];
    const double p2_by_m1 = spectrum_derivatives[18];
    const double p2_by_m2 = spectrum_derivatives[19];
    const double p3_by_k1 = spectrum_derivatives[20];
    const double p3_by_k2 = spectrum_derivatives[21];
    const double p3_by_m1 = spectrum_derivatives[22];
    const double p3_by_m2 = spectrum_derivatives[23];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const double cos_omega1_half_T = cos(t0);
    const double sin_omega1_half_T = sin(t0);
    const double t3 = half_T*omega2;
    const double cos_omega2_half_T = cos(t3);
    const double sin_omega2_half_T = sin(t3);
    /* d/dm1 of: functions of half_T in free */
    const double t6 = half_T*omega1_by_m1;
    const double cos_omega1_half_T_by_m1 = -sin_omega1_half_T*t6;
    const double sin_omega1_half_T_by_m1 = cos_omega1_half_T*t6;
    const double t7 = half_T*omega2_by_m1;
    const double cos_omega2_half_T_by_m1 = -sin_omega2_half_T*t7;
    const double sin_omega2_half_T_by_m1 = cos_omega2_half_T*t7;
    /* d/dm2 of: functions of half_T in free */
    const double t8 = half_T*omega1_by_m2;
    const double cos_omega1_half_T_by_m2 = -sin_omega1_half_T*t8;
    const double sin_omega1_half_T_by_m2 = cos_omega1_half_T*t8;
    const double t9 = half_T*omega2_by_m2;
    const double cos_omega2_half_T_by_m2 = -sin_omega2_half_T*t9;
    const double sin_omega2_half_T_by_m2 = cos_omega2_half_T*t9;
    /* d/dk1 of: functions of half_T in free */
    const double t10 = half_T*omega1_by_k1;
    const double cos_omega1_half_T_by_k1 = -sin_omega1_half_T*t10;
    const double sin_omega1_half_T_by_k1 = cos_omega1_half_T*t10;
    const double t11 = half_T*omega2_by_k1;
    const double cos_omega2_half_T_by_k1 = -sin_omega2_half_T*t11;
    const double sin_omega2_half_T_by_k1 = cos_omega2_half_T*t11;
    /* d/dk2 of: functions of half_T in free */
    const double t12 = half_T*omega1_by_k2;
    const double cos_omega1_half_T_by_k2 = -sin_omega1_half_T*t12;
    const double sin_omega1_half_T_by_k2 = cos_omega1_half_T*t12;
    const double t13 = half_T*omega2_by_k2;
    const double cos_omega2_half_T_by_k2 = -sin_omega2_half_T*t13;
    const double sin_omega2_half_T_by_k2 = cos_omega2_half_T*t13;
    /* d/dT of: functions of half_T in free */
    const double t14 = (1.0/2.0)*omega1;
    const double cos_omega1_half_T_by_T = -sin_omega1_half_T*t14;
    const double sin_omega1_half_T_by_T = cos_omega1_half_T*t14;
    const double t15 = (1.0/2.0)*omega2;
    const double cos_omega2_half_T_by_T = -sin_omega2_half_T*t15;
    const double sin_omega2_half_T_by_T = cos_omega2_half_T*t15;
    /* outputs */
    const double t16 = omega1*sin_omega1_half_T;
    const double t17 = cos_omega1_half_T*u - cos_omega2_half_T*u + omega2*sin_omega2_half_T - t16;
    const double t18 = -omega2*sin_omega2_half_T*y + t16*y;
    const double t20 = p1*u;
    const double t21 = p2*y;
    const double t22 = p1 - 1;
    const double t23 = t21 + t22;
    const double t24 = sin_omega2_half_T*t23;
    const double t25 = omega2*t23;
    const double t26 = t22*u;
    const double t27 = p1 + t21;
    const double t28 = sin_omega1_half_T*t27;
    const double t29 = omega1*t27;
    const double t30 = p3*u;
    const double t31 = p1*y - p3 - y;
    const double t32 = sin_omega1_half_T*t31;
    const double t33 = omega1*t31;
    const double t34 = p1*y - p3;
    const double t35 = sin_omega2_half_T*t34;
    const double t36 = omega2*t34;
    parameter_jacobian[0] = cos_omega1_half_T_by_m1*t20 - cos_omega2_half_T_by_m1*t26 - omega1_by_m1*t28 + omega2_by_m1*t24 + p1_by_m1*t17 - p2_by_m1*t18 - sin_omega1_half_T_by_m1*t29 + sin_omega2_half_T_by_m1*t25;
    parameter_jacobian[1] = cos_omega1_half_T_by_m2*t20 - cos_omega2_half_T_by_m2*t26 - omega1_by_m2*t28 + omega2_by_m2*t24 + p1_by_m2*t17 - p2_by_m2*t18 - sin_omega1_half_T_by_m2*t29 + sin_omega2_half_T_by_m2*t25;
    parameter_jacobian[2] = cos_omega1_half_T_by_k1*t20 - cos_omega2_half_T_by_k1*t26 - omega1_by_k1*t28 + omega2_by_k1*t24 + p1_by_k1*t17 - p2_by_k1*t18 - sin_omega1_half_T_by_k1*t29 + sin_omega2_half_T_by_k1*t25;
    parameter_jacobian[3] = cos_omega1_half_T_by_k2*t20 - cos_omega2_half_T_by_k2*t26 - omega1_by_k2*t28 + omega2_by_k2*t24 + p1_by_k2*t17 - p2_by_k2*t18 - sin_omega1_half_T_by_k2*t29 + sin_omega2_half_T_by_k2*t25;
    parameter_jacobian[4] = cos_omega1_half_T_by_T*t20 - cos_omega2_half_T_by_T*t26 - sin_omega1_half_T_by_T*t29 + sin_omega2_half_T_by_T*t25;
    parameter_jacobian[5] = cos_omega1_half_T_by_m1*t30 - cos_omega2_half_T_by_m1*t30 + omega1_by_m1*t32 - omega2_by_m1*t35 + p1_by_m1*t18 + p3_by_m1*t17 + sin_omega1_half_T_by_m1*t33 - sin_omega2_half_T_by_m1*t36;
    parameter_jacobian[6] = cos_omega1_half_T_by_m2*t30 - cos_omega2_half_T_by_m2*t30 + omega1_by_m2*t32 - omega2_by_m2*t35 + p1_by_m2*t18 + p3_by_m2*t17 + sin_omega1_half_T_by_m2*t33 - sin_omega2_half_T_by_m2*t36;
    parameter_jacobian[7] = cos_omega1_half_T_by_k1*t30 - cos_omega2_half_T_by_k1*t30 + omega1_by_k1*t32 - omega2_by_k1*t35 + p1_by_k1*t18 + p3_by_k1*t17 + sin_omega1_half_T_by_k1*t33 - sin_omega2_half_T_by_k1*t36;
    parameter_jacobian[8] = cos_omega1_half_T_by_k2*t30 - cos_omega2_half_T_by_k2*t30 + omega1_by_k2*t32 - omega2_by_k2*t35 + p1_by_k2*t18 + p3_by_k2*t17 + sin_omega1_half_T_by_k2*t33 - sin_omega2_half_T_by_k2*t36;
    parameter_jacobian[9] = cos_omega1_half_T_by_T*t30 - cos_omega2_half_T_by_T*t30 + sin_omega1_half_T_by_T*t33 - sin_omega2_half_T_by_T*t36;
}

/* Jacobian of the Poincare map in the section's coordinates.
 * Operations: 109. Intermediate terms: 53. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_poincare_jacobian(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double poincare_jacobian[9])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
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
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_T/omega2;
    const double t6 = p1*t3 + t4*t5;
    const double t7 = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double t8 = cos_omega1_T*p1 + cos_omega2_T*t4;
    const double x1_1 = t6*u + t7*y + t8;
    const double t9 = p3*sin_omega1_T*t2 - p3*t5;
    const double t10 = cos_omega1_T*t4 + cos_omega2_T*p1;
    const double t11 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t10*y + t11 + t9*u;
    const double t12 = omega1*sin_omega1_T;
    const double t13 = omega2*p2*sin_omega2_T - p2*t12;
    const double t14 = omega2*sin_omega2_T;
    const double v1_1 = -p1*t12 + t13*y - t14*t4 + t8*u;
    const double t15 = -p1*t14 - t12*t4;
    const double v2_1 = -p3*t12 + p3*t14 + t11*u + t15*y;
    /* Phi along T */
    const double carried_x1_1_by_y = t7;
    const double carried_x1_1_by_u = t6;
    const double carried_x1_1_by_w = p2*sin_omega1_T*t2 - p2*t5;
    const double carried_x2_1_by_y = t10;
    const double carried_x2_1_by_u = t9;
    const double carried_x2_1_by_w = p1*t5 + t3*t4;
    const double carried_v1_1_by_y = t13;
    const double carried_v1_1_by_u = t8;
    const double carried_v1_1_by_w = t7;
    const double carried_v2_1_by_y = t15;
    const double carried_v2_1_by_u = t11;
    const double carried_v2_1_by_w = t10;
    /* derivatives of the time to the boundary after T */
    const double t16 = (1.0/(v1_1));
    const double delay_T_by_y = -carried_x1_1_by_y*t16;
    const double delay_T_by_u = -carried_x1_1_by_u*t16;
    const double delay_T_by_w = -carried_x1_1_by_w*t16;
    /* perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1;
    const double x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_T_by_u*v2_1;
    const double x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_T_by_w*v2_1;
    const double t17 = (1.0/(m1));
    const double t18 = -k1*t17*x1_1 + k1*t17*x2_1;
    const double v1_1_on_boundary_by_y = -carried_v1_1_by_y - delay_T_by_y*t18;
    const double v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*t18;
    const double v1_1_on_boundary_by_w = -carried_v1_1_by_w - delay_T_by_w*t18;
    const double t19 = (1.0/(m2));
    const double t20 = k1*t19*x1_1 - t19*x2_1*(k1 + k2);
    const double v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_T_by_y*t20;
    const double v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_T_by_u*t20;
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*t20;
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

/* Saltation matrices of the transitions, one below the other.
 * Operations: 73. Intermediate terms: 22. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_saltations(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double saltations[16])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t1 = T*omega2;
    const double cos_omega2_T = cos(t1);
    const double sin_omega2_T = sin(t1);
    /* free for T, until first-reaches-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_T/omega2;
    const double t5 = cos_omega1_T*p1 + cos_omega2_T*t3;
    const double x1_1 = t5 + u*(p1*sin_omega1_T*t2 + t3*t4) + y*(cos_omega1_T*p2 - cos_omega2_T*p2);
    const double x2_1 = cos_omega1_T*p3 - cos_omega2_T*p3 + u*(p3*sin_omega1_T*t2 - p3*t4) + y*(cos_omega1_T*t3 + cos_omega2_T*p1);
    const double t6 = omega1*sin_omega1_T;
    const double v1_1 = -omega2*sin_omega2_T*t3 - p1*t6 + t5*u + y*(omega2*p2*sin_omega2_T - p2*t6);
    /* transition to free */
    const double v1_1_reset = -v1_1;
    /* vector fields at transition 1 */
    const double t7 = (1.0/(m1));
    const double before_v1_1 = -k1*t7*x1_1 + k1*t7*x2_1;
    const double t9 = (1.0/(m2));
    const double before_v2_1 = k1*t9*x1_1 - t9*x2_1*(k1 + k2);
    const double behind_v1_1 = before_v1_1;
    const double behind_v2_1 = before_v2_1;
    /* outputs */
    const double t11 = (1.0/(v1_1));
    saltations[0] = t11*(-v1_1 + v1_1_reset) + 1;
    saltations[1] = 0;
    saltations[2] = 0;
    saltations[3] = 0;
    saltations[4] = 0;
    saltations[5] = 1;
    saltations[6] = 0;
    saltations[7] = 0;
    saltations[8] = t11*(before_v1_1 + behind_v1_1);
    saltations[9] = 0;
    saltations[10] = -1;
    saltations[11] = 0;
    saltations[12] = t11*(-before_v2_1 + behind_v2_1);
    saltations[13] = 0;
    saltations[14] = 0;
    saltations[15] = 1;
}

/* Monodromy matrix: the product of flows and saltation matrices over a period.
 * Operations: 108. Intermediate terms: 62. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_monodromy(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double monodromy[16])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
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
    const double t4 = 1 - p1;
    const double t5 = sin_omega2_T/omega2;
    const double t6 = p1*t3 + t4*t5;
    const double t7 = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double t8 = cos_omega1_T*p1 + cos_omega2_T*t4;
    const double x1_1 = t6*u + t7*y + t8;
    const double t9 = p3*sin_omega1_T*t2 - p3*t5;
    const double t10 = cos_omega1_T*t4 + cos_omega2_T*p1;
    const double t11 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t10*y + t11 + t9*u;
    const double t12 = omega1*sin_omega1_T;
    const double t13 = omega2*p2*sin_omega2_T - p2*t12;
    const double t14 = omega2*sin_omega2_T;
    const double t15 = p1*t12 + t14*t4;
    const double v1_1 = t13*y - t15 + t8*u;
    /* transition to free */
    const double v1_1_reset = -v1_1;
    /* vector fields at transition 1 */
    const double t16 = (1.0/(m1));
    const double before_v1_1 = -k1*t16*x1_1 + k1*t16*x2_1;
    const double t18 = (1.0/(m2));
    const double before_v2_1 = k1*t18*x1_1 - t18*x2_1*(k1 + k2);
    const double behind_v1_1 = before_v1_1;
    const double behind_v2_1 = before_v2_1;
    /* Phi of phase 1 */
    const double phi_1_00 = t8;
    const double phi_1_01 = t7;
    const double phi_1_02 = t6;
    const double phi_1_03 = p2*sin_omega1_T*t2 - p2*t5;
    const double phi_1_10 = t11;
    const double phi_1_11 = t10;
    const double phi_1_12 = t9;
    const double phi_1_13 = p1*t5 + t3*t4;
    const double phi_1_20 = -t15;
    const double phi_1_21 = t13;
    const double phi_1_22 = t8;
    const double phi_1_23 = t7;
    const double phi_1_30 = omega2*p3*sin_omega2_T - p3*t12;
    const double phi_1_31 = -p1*t14 - t12*t4;
    const double phi_1_32 = t11;
    const double phi_1_33 = t10;
    /* saltation of phase 1 */
    const double t20 = (1.0/(v1_1));
    const double t21 = t20*(-v1_1 + v1_1_reset) + 1;
    const double saltation_1_00 = phi_1_00*t21;
    const double saltation_1_01 = phi_1_01*t21;
    const double saltation_1_02 = phi_1_02*t21;
    const double saltation_1_03 = phi_1_03*t21;
    const double t22 = t20*(before_v1_1 + behind_v1_1);
    const double saltation_1_20 = phi_1_00*t22 - phi_1_20;
    const double saltation_1_21 = phi_1_01*t22 - phi_1_21;
    const double saltation_1_22 = phi_1_02*t22 - phi_1_22;
    const double saltation_1_23 = phi_1_03*t22 - phi_1_23;
    const double t23 = t20*(-before_v2_1 + behind_v2_1);
    const double saltation_1_30 = phi_1_00*t23 + phi_1_30;
    const double saltation_1_31 = phi_1_01*t23 + phi_1_31;
    const double saltation_1_32 = phi_1_02*t23 + phi_1_32;
    const double saltation_1_33 = phi_1_03*t23 + phi_1_33;
    monodromy[0] = saltation_1_00;
    monodromy[1] = saltation_1_01;
    monodromy[2] = saltation_1_02;
    monodromy[3] = saltation_1_03;
    monodromy[4] = phi_1_10;
    monodromy[5] = phi_1_11;
    monodromy[6] = phi_1_12;
    monodromy[7] = phi_1_13;
    monodromy[8] = saltation_1_20;
    monodromy[9] = saltation_1_21;
    monodromy[10] = saltation_1_22;
    monodromy[11] = saltation_1_23;
    monodromy[12] = saltation_1_30;
    monodromy[13] = saltation_1_31;
    monodromy[14] = saltation_1_32;
    monodromy[15] = saltation_1_33;
}

/* Trace of the Poincare map's Jacobian.
 * Operations: 94. Intermediate terms: 35. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_trace(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double *trace)
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t1 = T*omega2;
    const double cos_omega2_T = cos(t1);
    const double sin_omega2_T = sin(t1);
    /* free for T, until first-reaches-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_T/omega2;
    const double t5 = p1*sin_omega1_T*t2 + t3*t4;
    const double t6 = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double t7 = cos_omega1_T*p1 + cos_omega2_T*t3;
    const double x1_1 = t5*u + t6*y + t7;
    const double t8 = cos_omega1_T*t3 + cos_omega2_T*p1;
    const double t9 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t8*y + t9 + u*(p3*sin_omega1_T*t2 - p3*t4);
    const double t10 = omega1*sin_omega1_T;
    const double t11 = omega2*sin_omega2_T;
    const double v1_1 = -p1*t10 - t11*t3 + t7*u + y*(omega2*p2*sin_omega2_T - p2*t10);
    const double v2_1 = -p3*t10 + p3*t11 + t9*u + y*(-p1*t11 - t10*t3);
    /* Phi along T */
    const double carried_x1_1_by_y = t6;
    const double carried_x1_1_by_u = t5;
    const double carried_x1_1_by_w = p2*sin_omega1_T*t2 - p2*t4;
    const double carried_x2_1_by_y = t8;
    const double carried_v1_1_by_u = t7;
    const double carried_v2_1_by_w = t8;
    /* derivatives of the time to the boundary after T */
    const double t12 = (1.0/(v1_1));
    const double delay_T_by_y = -carried_x1_1_by_y*t12;
    const double delay_T_by_u = -carried_x1_1_by_u*t12;
    const double delay_T_by_w = -carried_x1_1_by_w*t12;
    /* perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1;
    const double t13 = (1.0/(m1));
    const double v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*(-k1*t13*x1_1 + k1*t13*x2_1);
    const double t14 = (1.0/(m2));
    const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*(k1*t14*x1_1 - t14*x2_1*(k1 + k2));
    *trace = v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y;
}

/* Derivatives of the trace by the unknowns, then in total by the parameters.
 * Operations: 853. Intermediate terms: 269. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_trace_gradient(
    const double parameters[5], const double spectrum[7], const double spectrum_derivatives[28],
    const double unknowns[2], double trace_gradient[7])
{
    const double m1 = parameters[0];
    const double m2 = parameters[1];
    const double k1 = parameters[2];
    const double k2 = parameters[3];
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double omega1_by_k1 = spectrum_derivatives[4];
    const double omega1_by_k2 = spectrum_derivatives[5];
    const double omega1_by_m1 = spectrum_derivatives[6];
    const double omega1_by_m2 = spectrum_derivatives[7];
    const double omega2_by_k1 = spectrum_derivatives[8];
    const double omega2_by_k2 = spectrum_derivatives[9];
    const double omega2_by_m1 = spectrum_derivatives[10];
    const double omega2_by_m2 = spectrum_derivatives[11];
    const double p1_by_k1 = spectrum_derivatives[12];
    const double p1_by_k2 = spectrum_derivatives[13];
    const double p1_by_m1 = spectrum_derivatives[14];
    const double p1_by_m2 = spectrum_derivatives[15];
    const double p2_by_k1 = spectrum_derivatives[16];
    const double p2_by_k2 = spectrum_derivatives[17];
    const double p2_by_m1 = spectrum_derivatives[18];
    const double p2_by_m2 = spectrum_derivatives[19];
    const double p3_by_k1 = spectrum_derivatives[20];
    const double p3_by_k2 = spectrum_derivatives[21];
    const double p3_by_m1 = spectrum_derivatives[22];
    const double p3_by_m2 = spectrum_derivatives[23];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t3 = T*omega2;
    const double cos_omega2_T = cos(t3);
    const double sin_omega2_T = sin(t3);
    /* free for T, until first-reaches-stop */
    const double t6 = (1.0/(omega1));
    const double t7 = p1 - 1;
    const double t9 = (1.0/(omega2));
    const double t10 = sin_omega2_T*t9;
    const double t11 = p1*sin_omega1_T*t6 - t10*t7;
    const double t12 = cos_omega1_T*p2 - cos_omega2_T*p2;
    const double t13 = cos_omega1_T*p1 - cos_omega2_T*t7;
    const double x1_1 = t11*u + t12*y + t13;
    const double t14 = p3*sin_omega1_T*t6 - p3*t10;
    const double t15 = -cos_omega1_T*t7 + cos_omega2_T*p1;
    const double t16 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t14*u + t15*y + t16;
    const double t17 = omega1*sin_omega1_T;
    const double t18 = omega2*p2*sin_omega2_T - p2*t17;
    const double t19 = p1*sin_omega1_T;
    const double t20 = -sin_omega2_T*t7;
    const double v1_1 = -omega1*t19 - omega2*t20 + t13*u + t18*y;
    const double t21 = omega2*sin_omega2_T;
    const double t22 = -p1*t21 + t17*t7;
    const double v2_1 = -p3*t17 + p3*t21 + t16*u + t22*y;
    /* Phi along T */
    const double carried_x1_1_by_y = t12;
    const double carried_x1_1_by_u = t11;
    const double carried_x1_1_by_w = p2*sin_omega1_T*t6 - p2*t10;
    /* derivatives of the time to the boundary after T */
    const double t23 = (1.0/(v1_1));
    const double delay_T_by_y = -carried_x1_1_by_y*t23;
    const double delay_T_by_u = -carried_x1_1_by_u*t23;
    const double delay_T_by_w = -carried_x1_1_by_w*t23;
    /* d/dm1 of: functions of T in free */
    const double t24 = T*omega1_by_m1;
    const double cos_omega1_T_by_m1 = -sin_omega1_T*t24;
    const double sin_omega1_T_by_m1 = cos_omega1_T*t24;
    const double t25 = T*omega2_by_m1;
    const double cos_omega2_T_by_m1 = -sin_omega2_T*t25;
    const double sin_omega2_T_by_m1 = cos_omega2_T*t25;
    /* d/dm2 of: functions of T in free */
    const double t26 = T*omega1_by_m2;
    const double cos_omega1_T_by_m2 = -sin_omega1_T*t26;
    const double sin_omega1_T_by_m2 = cos_omega1_T*t26;
    const double t27 = T*omega2_by_m2;
    const double cos_omega2_T_by_m2 = -sin_omega2_T*t27;
    const double sin_omega2_T_by_m2 = cos_omega2_T*t27;
    /* d/dk1 of: functions of T in free */
    const double t28 = T*omega1_by_k1;
    const double cos_omega1_T_by_k1 = -sin_omega1_T*t28;
    const double sin_omega1_T_by_k1 = cos_omega1_T*t28;
    const double t29 = T*omega2_by_k1;
    const double cos_omega2_T_by_k1 = -sin_omega2_T*t29;
    const double sin_omega2_T_by_k1 = cos_omega2_T*t29;
    /* d/dk2 of: functions of T in free */
    const double t30 = T*omega1_by_k2;
    const double cos_omega1_T_by_k2 = -sin_omega1_T*t30;
    const double sin_omega1_T_by_k2 = cos_omega1_T*t30;
    const double t31 = T*omega2_by_k2;
    const double cos_omega2_T_by_k2 = -sin_omega2_T*t31;
    const double sin_omega2_T_by_k2 = cos_omega2_T*t31;
    /* d/dT of: functions of T in free */
    const double cos_omega1_T_by_T = -omega1*sin_omega1_T;
    const double sin_omega1_T_by_T = cos_omega1_T*omega1;
    const double cos_omega2_T_by_T = -omega2*sin_omega2_T;
    const double sin_omega2_T_by_T = cos_omega2_T*omega2;
    /* d/dy of: free for T, until first-reaches-stop */
    const double x1_1_by_y = t12;
    const double x2_1_by_y = t15;
    const double v1_1_by_y = t18;
    const double v2_1_by_y = t22;
    /* d/du of: free for T, until first-reaches-stop */
    const double x1_1_by_u = t11;
    const double x2_1_by_u = t14;
    const double v1_1_by_u = t13;
    const double v2_1_by_u = t16;
    /* d/dm1 of: free for T, until first-reaches-stop */
    const double t32 = p2*y;
    const double t33 = p1 + t32;
    const double t34 = -t32 - t7;
    const double t35 = sin_omega1_T*t6 - t10;
    const double t36 = cos_omega1_T - cos_omega2_T;
    const double t37 = t35*u + t36;
    const double t38 = p2_by_m1*t36;
    const double t39 = sin_omega1_T_by_m1*t6;
    const double t40 = p1*t39;
    const double t41 = sin_omega2_T_by_m1*t9;
    const double t42 = -t41*t7;
    const double t43 = (1.0/(omega1*omega1));
    const double t44 = omega1_by_m1*t43;
    const double t45 = t19*t44;
    const double t46 = (1.0/(omega2*omega2));
    const double t47 = omega2_by_m1*t46;
    const double t48 = t20*t47;
    const double x1_1_by_m1 = cos_omega1_T_by_m1*t33 + cos_omega2_T_by_m1*t34 + p1_by_m1*t37 + t38*y + t40*u + t42*u - t45*u - t48*u;
    const double t49 = -t7*y;
    const double t50 = p3 + t49;
    const double t51 = p1*y;
    const double t52 = -p3 + t51;
    const double t54 = -p1_by_m1*t36;
    const double t55 = p3*u;
    const double t56 = p3*sin_omega2_T*u;
    const double t57 = p3*sin_omega1_T;
    const double t58 = t57*u;
    const double x2_1_by_m1 = cos_omega1_T_by_m1*t50 + cos_omega2_T_by_m1*t52 + p3_by_m1*t37 + t39*t55 - t41*t55 - t44*t58 + t47*t56 + t54*y;
    const double t59 = -sin_omega1_T*t32 - t19;
    const double t60 = sin_omega2_T*t32 - t20;
    const double t61 = -t17 + t21 + t36*u;
    const double t62 = -omega1*p1 - omega1*t32;
    const double t63 = omega2*t32 + omega2*t7;
    const double t64 = cos_omega1_T_by_m1*p1;
    const double t65 = -cos_omega2_T_by_m1*t7;
    const double t66 = -omega2*sin_omega2_T + t17;
    const double t67 = -t66*y;
    const double v1_1_by_m1 = omega1_by_m1*t59 + omega2_by_m1*t60 + p1_by_m1*t61 + p2_by_m1*t67 + sin_omega1_T_by_m1*t62 + sin_omega2_T_by_m1*t63 + t64*u + t65*u;
    const double t68 = -sin_omega1_T*t49 - t57;
    const double t69 = p3*sin_omega2_T - sin_omega2_T*t51;
    const double t70 = -omega1*p3 - omega1*t49;
    const double t71 = omega2*p3 - omega2*t51;
    const double t72 = t66*y;
    const double v2_1_by_m1 = cos_omega1_T_by_m1*t55 - cos_omega2_T_by_m1*t55 + omega1_by_m1*t68 + omega2_by_m1*t69 + p1_by_m1*t72 + p3_by_m1*t61 + sin_omega1_T_by_m1*t70 + sin_omega2_T_by_m1*t71;
    /* d/dm2 of: free for T, until first-reaches-stop */
    const double t73 = p2_by_m2*t36;
    const double t74 = sin_omega1_T_by_m2*t6;
    const double t75 = p1*t74;
    const double t76 = sin_omega2_T_by_m2*t9;
    const double t77 = -t7*t76;
    const double t78 = omega1_by_m2*t43;
    const double t79 = t19*t78;
    const double t80 = omega2_by_m2*t46;
    const double t81 = t20*t80;
    const double x1_1_by_m2 = cos_omega1_T_by_m2*t33 + cos_omega2_T_by_m2*t34 + p1_by_m2*t37 + t73*y + t75*u + t77*u - t79*u - t81*u;
    const double t82 = -p1_by_m2*t36;
    const double x2_1_by_m2 = cos_omega1_T_by_m2*t50 + cos_omega2_T_by_m2*t52 + p3_by_m2*t37 + t55*t74 - t55*t76 + t56*t80 - t58*t78 + t82*y;
    const double t83 = cos_omega1_T_by_m2*p1;
    const double t84 = -cos_omega2_T_by_m2*t7;
    const double v1_1_by_m2 = omega1_by_m2*t59 + omega2_by_m2*t60 + p1_by_m2*t61 + p2_by_m2*t67 + sin_omega1_T_by_m2*t62 + sin_omega2_T_by_m2*t63 + t83*u + t84*u;
    const double v2_1_by_m2 = cos_omega1_T_by_m2*t55 - cos_omega2_T_by_m2*t55 + omega1_by_m2*t68 + omega2_by_m2*t69 + p1_by_m2*t72 + p3_by_m2*t61 + sin_omega1_T_by_m2*t70 + sin_omega2_T_by_m2*t71;
    /* d/dk1 of: free for T, until first-reaches-stop */
    const double t85 = p2_by_k1*t36;
    const double t86 = sin_omega1_T_by_k1*t6;
    const double t87 = p1*t86;
    const double t88 = sin_omega2_T_by_k1*t9;
    const double t89 = -t7*t88;
    const double t90 = omega1_by_k1*t43;
    const double t91 = t19*t90;
    const double t92 = omega2_by_k1*t46;
    const double t93 = t20*t92;
    const double x1_1_by_k1 = cos_omega1_T_by_k1*t33 + cos_omega2_T_by_k1*t34 + p1_by_k1*t37 + t85*y + t87*u + t89*u - t91*u - t93*u;
    const double t94 = -p1_by_k1*t36;
    const double x2_1_by_k1 = cos_omega1_T_by_k1*t50 + cos_omega2_T_by_k1*t52 + p3_by_k1*t37 + t55*t86 - t55*t88 + t56*t92 - t58*t90 + t94*y;
    const double t95 = cos_omega1_T_by_k1*p1;
    const double t96 = -cos_omega2_T_by_k1*t7;
    const double v1_1_by_k1 = omega1_by_k1*t59 + omega2_by_k1*t60 + p1_by_k1*t61 + p2_by_k1*t67 + sin_omega1_T_by_k1*t62 + sin_omega2_T_by_k1*t63 + t95*u + t96*u;
    const double v2_1_by_k1 = cos_omega1_T_by_k1*t55 - cos_omega2_T_by_k1*t55 + omega1_by_k1*t68 + omega2_by_k1*t69 + p1_by_k1*t72 + p3_by_k1*t61 + sin_omega1_T_by_k1*t70 + sin_omega2_T_by_k1*t71;
    /* d/dk2 of: free for T, until first-reaches-stop */
    const double t97 = p2_by_k2*t36;
    const double t98 = sin_omega1_T_by_k2*t6;
    const double t99 = p1*t98;
    const double t100 = sin_omega2_T_by_k2*t9;
    const double t101 = -t100*t7;
    const double t102 = omega1_by_k2*t43;
    const double t103 = t102*t19;
    const double t104 = omega2_by_k2*t46;
    const double t105 = t104*t20;
    const double x1_1_by_k2 = cos_omega1_T_by_k2*t33 + cos_omega2_T_by_k2*t34 + p1_by_k2*t37 + t101*u - t103*u - t105*u + t97*y + t99*u;
    const double t106 = -p1_by_k2*t36;
    const double x2_1_by_k2 = cos_omega1_T_by_k2*t50 + cos_omega2_T_by_k2*t52 + p3_by_k2*t37 - t100*t55 - t102*t58 + t104*t56 + t106*y + t55*t98;
    const double t107 = cos_omega1_T_by_k2*p1;
    const double t108 = -cos_omega2_T_by_k2*t7;
    const double v1_1_by_k2 = omega1_by_k2*t59 + omega2_by_k2*t60 + p1_by_k2*t61 + p2_by_k2*t67 + sin_omega1_T_by_k2*t62 + sin_omega2_T_by_k2*t63 + t107*u + t108*u;
    const double v2_1_by_k2 = cos_omega1_T_by_k2*t55 - cos_omega2_T_by_k2*t55 + omega1_by_k2*t68 + omega2_by_k2*t69 + p1_by_k2*t72 + p3_by_k2*t61 + sin_omega1_T_by_k2*t70 + sin_omega2_T_by_k2*t71;
    /* d/dT of: free for T, until first-reaches-stop */
    const double t109 = sin_omega1_T_by_T*t6;
    const double t110 = p1*t109;
    const double t111 = sin_omega2_T_by_T*t9;
    const double t112 = -t111*t7;
    const double x1_1_by_T = cos_omega1_T_by_T*t33 + cos_omega2_T_by_T*t34 + t110*u + t112*u;
    const double x2_1_by_T = cos_omega1_T_by_T*t50 + cos_omega2_T_by_T*t52 + t109*t55 - t111*t55;
    const double t113 = cos_omega1_T_by_T*p1;
    const double t114 = -cos_omega2_T_by_T*t7;
    const double v1_1_by_T = sin_omega1_T_by_T*t62 + sin_omega2_T_by_T*t63 + t113*u + t114*u;
    const double v2_1_by_T = cos_omega1_T_by_T*t55 - cos_omega2_T_by_T*t55 + sin_omega1_T_by_T*t70 + sin_omega2_T_by_T*t71;
    /* d/dm1 of: Phi along T */
    const double carried_x1_1_by_y_by_m1 = cos_omega1_T_by_m1*p2 - cos_omega2_T_by_m1*p2 + t38;
    const double carried_x1_1_by_u_by_m1 = p1_by_m1*t35 + t40 + t42 - t45 - t48;
    const double t115 = p2*sin_omega2_T;
    const double t116 = p2*sin_omega1_T;
    const double carried_x1_1_by_w_by_m1 = p2*t39 - p2*t41 + p2_by_m1*t35 + t115*t47 - t116*t44;
    const double carried_x2_1_by_y_by_m1 = -cos_omega1_T_by_m1*t7 + cos_omega2_T_by_m1*p1 + t54;
    const double carried_v1_1_by_u_by_m1 = p1_by_m1*t36 + t64 + t65;
    const double carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1;
    /* d/dm2 of: Phi along T */
    const double carried_x1_1_by_y_by_m2 = cos_omega1_T_by_m2*p2 - cos_omega2_T_by_m2*p2 + t73;
    const double carried_x1_1_by_u_by_m2 = p1_by_m2*t35 + t75 + t77 - t79 - t81;
    const double carried_x1_1_by_w_by_m2 = p2*t74 - p2*t76 + p2_by_m2*t35 + t115*t80 - t116*t78;
    const double carried_x2_1_by_y_by_m2 = -cos_omega1_T_by_m2*t7 + cos_omega2_T_by_m2*p1 + t82;
    const double carried_v1_1_by_u_by_m2 = p1_by_m2*t36 + t83 + t84;
    const double carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2;
    /* d/dk1 of: Phi along T */
    const double carried_x1_1_by_y_by_k1 = cos_omega1_T_by_k1*p2 - cos_omega2_T_by_k1*p2 + t85;
    const double carried_x1_1_by_u_by_k1 = p1_by_k1*t35 + t87 + t89 - t91 - t93;
    const double carried_x1_1_by_w_by_k1 = p2*t86 - p2*t88 + p2_by_k1*t35 + t115*t92 - t116*t90;
    const double carried_x2_1_by_y_by_k1 = -cos_omega1_T_by_k1*t7 + cos_omega2_T_by_k1*p1 + t94;
    const double carried_v1_1_by_u_by_k1 = p1_by_k1*t36 + t95 + t96;
    const double carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1;
    /* d/dk2 of: Phi along T */
    const double carried_x1_1_by_y_by_k2 = cos_omega1_T_by_k2*p2 - cos_omega2_T_by_k2*p2 + t97;
    const double carried_x1_1_by_u_by_k2 = p1_by_k2*t35 + t101 - t103 - t105 + t99;
    const double carried_x1_1_by_w_by_k2 = -p2*t100 + p2*t98 + p2_by_k2*t35 - t102*t116 + t104*t115;
    const double carried_x2_1_by_y_by_k2 = -cos_omega1_T_by_k2*t7 + cos_omega2_T_by_k2*p1 + t106;
    const double carried_v1_1_by_u_by_k2 = p1_by_k2*t36 + t107 + t108;
    const double carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2;
    /* d/dT of: Phi along T */
    const double carried_x1_1_by_y_by_T = cos_omega1_T_by_T*p2 - cos_omega2_T_by_T*p2;
    const double carried_x1_1_by_u_by_T = t110 + t112;
    const double carried_x1_1_by_w_by_T = p2*sin_omega1_T_by_T*t6 - p2*t111;
    const double carried_x2_1_by_y_by_T = -cos_omega1_T_by_T*t7 + cos_omega2_T_by_T*p1;
    const double carried_v1_1_by_u_by_T = t113 + t114;
    const double carried_v2_1_by_w_by_T = carried_x2_1_by_y_by_T;
    /* d/dy of: derivatives of the time to the boundary after T */
    const double t122 = (1.0/(v1_1*v1_1));
    const double t123 = t122*v1_1_by_y;
    const double delay_T_by_y_by_y = carried_x1_1_by_y*t123;
    const double delay_T_by_u_by_y = carried_x1_1_by_u*t123;
    const double delay_T_by_w_by_y = carried_x1_1_by_w*t123;
    /* d/du of: derivatives of the time to the boundary after T */
    const double t124 = t122*v1_1_by_u;
    const double delay_T_by_y_by_u = carried_x1_1_by_y*t124;
    const double delay_T_by_u_by_u = carried_x1_1_by_u*t124;
    const double delay_T_by_w_by_u = carried_x1_1_by_w*t124;
    /* d/dm1 of: derivatives of the time to the boundary after T */
    const double t125 = t122*v1_1_by_m1;
    const double delay_T_by_y_by_m1 = carried_x1_1_by_y*t125 - carried_x1_1_by_y_by_m1*t23;
    const double delay_T_by_u_by_m1 = carried_x1_1_by_u*t125 - carried_x1_1_by_u_by_m1*t23;
    const double delay_T_by_w_by_m1 = carried_x1_1_by_w*t125 - carried_x1_1_by_w_by_m1*t23;
    /* d/dm2 of: derivatives of the time to the boundary after T */
    const double t126 = t122*v1_1_by_m2;
    const double delay_T_by_y_by_m2 = carried_x1_1_by_y*t126 - carried_x1_1_by_y_by_m2*t23;
    const double delay_T_by_u_by_m2 = carried_x1_1_by_u*t126 - carried_x1_1_by_u_by_m2*t23;
    const double delay_T_by_w_by_m2 = carried_x1_1_by_w*t126 - carried_x1_1_by_w_by_m2*t23;
    /* d/dk1 of: derivatives of the time to the boundary after T */
    const double t127 = t122*v1_1_by_k1;
    const double delay_T_by_y_by_k1 = carried_x1_1_by_y*t127 - carried_x1_1_by_y_by_k1*t23;
    const double delay_T_by_u_by_k1 = carried_x1_1_by_u*t127 - carried_x1_1_by_u_by_k1*t23;
    const double delay_T_by_w_by_k1 = carried_x1_1_by_w*t127 - carried_x1_1_by_w_by_k1*t23;
    /* d/dk2 of: derivatives of the time to the boundary after T */
    const double t128 = t122*v1_1_by_k2;
    const double delay_T_by_y_by_k2 = carried_x1_1_by_y*t128 - carried_x1_1_by_y_by_k2*t23;
    const double delay_T_by_u_by_k2 = carried_x1_1_by_u*t128 - carried_x1_1_by_u_by_k2*t23;
    const double delay_T_by_w_by_k2 = carried_x1_1_by_w*t128 - carried_x1_1_by_w_by_k2*t23;
    /* d/dT of: derivatives of the time to the boundary after T */
    const double t129 = t122*v1_1_by_T;
    const double delay_T_by_y_by_T = carried_x1_1_by_y*t129 - carried_x1_1_by_y_by_T*t23;
    const double delay_T_by_u_by_T = carried_x1_1_by_u*t129 - carried_x1_1_by_u_by_T*t23;
    const double delay_T_by_w_by_T = carried_x1_1_by_w*t129 - carried_x1_1_by_w_by_T*t23;
    /* d/dy of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_y = delay_T_by_y*v2_1_by_y + delay_T_by_y_by_y*v2_1;
    const double t130 = (1.0/(m1));
    const double t131 = t130*x1_1;
    const double t132 = -k1*t130*x2_1 + k1*t131;
    const double t133 = k1*x1_1_by_y;
    const double t134 = delay_T_by_u*t130;
    const double t135 = k1*t134;
    const double v1_1_on_boundary_by_u_by_y = delay_T_by_u_by_y*t132 + t133*t134 - t135*x2_1_by_y;
    const double t136 = (1.0/(m2));
    const double t137 = t136*x1_1;
    const double t138 = k1 + k2;
    const double t139 = t136*x2_1;
    const double t140 = k1*t137 - t138*t139;
    const double t141 = delay_T_by_w*t136;
    const double t142 = t138*t141;
    const double v2_1_on_boundary_by_w_by_y = delay_T_by_w_by_y*t140 + t133*t141 - t142*x2_1_by_y;
    /* d/du of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_u = delay_T_by_y*v2_1_by_u + delay_T_by_y_by_u*v2_1;
    const double v1_1_on_boundary_by_u_by_u = delay_T_by_u_by_u*t132 + t135*x1_1_by_u - t135*x2_1_by_u;
    const double t143 = k1*t141;
    const double v2_1_on_boundary_by_w_by_u = delay_T_by_w_by_u*t140 - t142*x2_1_by_u + t143*x1_1_by_u;
    /* d/dm1 of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_T_by_y*v2_1_by_m1 + delay_T_by_y_by_m1*v2_1;
    const double t144 = k1/(m1*m1);
    const double v1_1_on_boundary_by_u_by_m1 = -carried_v1_1_by_u_by_m1 + delay_T_by_u*k1*t130*x1_1_by_m1 - delay_T_by_u*(t144*x1_1 - t144*x2_1) + delay_T_by_u_by_m1*t132 - t135*x2_1_by_m1;
    const double v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_T_by_w_by_m1*t140 - t142*x2_1_by_m1 + t143*x1_1_by_m1;
    /* d/dm2 of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_T_by_y*v2_1_by_m2 + delay_T_by_y_by_m2*v2_1;
    const double v1_1_on_boundary_by_u_by_m2 = -carried_v1_1_by_u_by_m2 + delay_T_by_u*k1*t130*x1_1_by_m2 + delay_T_by_u_by_m2*t132 - t135*x2_1_by_m2;
    const double t145 = (1.0/(m2*m2));
    const double v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_T_by_w*(-k1*t145*x1_1 + t138*t145*x2_1) + delay_T_by_w_by_m2*t140 - t142*x2_1_by_m2 + t143*x1_1_by_m2;
    /* d/dk1 of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_T_by_y*v2_1_by_k1 + delay_T_by_y_by_k1*v2_1;
    const double v1_1_on_boundary_by_u_by_k1 = -carried_v1_1_by_u_by_k1 + delay_T_by_u*k1*t130*x1_1_by_k1 - delay_T_by_u*(t130*x2_1 - t131) + delay_T_by_u_by_k1*t132 - t135*x2_1_by_k1;
    const double v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_T_by_w*(t137 - t139) + delay_T_by_w_by_k1*t140 - t142*x2_1_by_k1 + t143*x1_1_by_k1;
    /* d/dk2 of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_T_by_y*v2_1_by_k2 + delay_T_by_y_by_k2*v2_1;
    const double v1_1_on_boundary_by_u_by_k2 = -carried_v1_1_by_u_by_k2 + delay_T_by_u*k1*t130*x1_1_by_k2 + delay_T_by_u_by_k2*t132 - t135*x2_1_by_k2;
    const double v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_T_by_w*t139 + delay_T_by_w_by_k2*t140 - t142*x2_1_by_k2 + t143*x1_1_by_k2;
    /* d/dT of: perturbation on the boundary after T */
    const double x2_1_on_boundary_by_y_by_T = carried_x2_1_by_y_by_T + delay_T_by_y*v2_1_by_T + delay_T_by_y_by_T*v2_1;
    const double v1_1_on_boundary_by_u_by_T = -carried_v1_1_by_u_by_T + delay_T_by_u*k1*t130*x1_1_by_T + delay_T_by_u_by_T*t132 - t135*x2_1_by_T;
    const double v2_1_on_boundary_by_w_by_T = carried_v2_1_by_w_by_T + delay_T_by_w_by_T*t140 - t142*x2_1_by_T + t143*x1_1_by_T;
    trace_gradient[0] = v1_1_on_boundary_by_u_by_y + v2_1_on_boundary_by_w_by_y + x2_1_on_boundary_by_y_by_y;
    trace_gradient[1] = v1_1_on_boundary_by_u_by_u + v2_1_on_boundary_by_w_by_u + x2_1_on_boundary_by_y_by_u;
    trace_gradient[2] = v1_1_on_boundary_by_u_by_m1 + v2_1_on_boundary_by_w_by_m1 + x2_1_on_boundary_by_y_by_m1;
    trace_gradient[3] = v1_1_on_boundary_by_u_by_m2 + v2_1_on_boundary_by_w_by_m2 + x2_1_on_boundary_by_y_by_m2;
    trace_gradient[4] = v1_1_on_boundary_by_u_by_k1 + v2_1_on_boundary_by_w_by_k1 + x2_1_on_boundary_by_y_by_k1;
    trace_gradient[5] = v1_1_on_boundary_by_u_by_k2 + v2_1_on_boundary_by_w_by_k2 + x2_1_on_boundary_by_y_by_k2;
    trace_gradient[6] = v1_1_on_boundary_by_u_by_T + v2_1_on_boundary_by_w_by_T + x2_1_on_boundary_by_y_by_T;
}

/* State at the start and behind each transition, row by row.
 * Operations: 62. Intermediate terms: 18. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_states(
    const double parameters[5], const double spectrum[7], const double unknowns[2], double states[8])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* functions of T in free */
    const double t0 = T*omega1;
    const double cos_omega1_T = cos(t0);
    const double sin_omega1_T = sin(t0);
    const double t1 = T*omega2;
    const double cos_omega2_T = cos(t1);
    const double sin_omega2_T = sin(t1);
    /* free for T, until first-reaches-stop */
    const double t2 = (1.0/(omega1));
    const double t3 = 1 - p1;
    const double t4 = sin_omega2_T/omega2;
    const double t5 = cos_omega1_T*p1 + cos_omega2_T*t3;
    const double x1_1 = t5 + u*(p1*sin_omega1_T*t2 + t3*t4) + y*(cos_omega1_T*p2 - cos_omega2_T*p2);
    const double t6 = cos_omega1_T*p3 - cos_omega2_T*p3;
    const double x2_1 = t6 + u*(p3*sin_omega1_T*t2 - p3*t4) + y*(cos_omega1_T*t3 + cos_omega2_T*p1);
    const double t7 = omega1*sin_omega1_T;
    const double t8 = omega2*sin_omega2_T;
    const double v1_1 = -p1*t7 - t3*t8 + t5*u + y*(omega2*p2*sin_omega2_T - p2*t7);
    const double v2_1 = -p3*t7 + p3*t8 + t6*u + y*(-p1*t8 - t3*t7);
    /* transition to free */
    const double v1_1_reset = -v1_1;
    states[0] = 1;
    states[1] = y;
    states[2] = u;
    states[3] = 0;
    states[4] = x1_1;
    states[5] = x2_1;
    states[6] = v1_1_reset;
    states[7] = v2_1;
}

/* Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.
 * Operations: 9. Intermediate terms: 1. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_boundary_functions(
    const double parameters[5], const double spectrum[7], const double unknowns[2],
    double coefficients[6], double frequencies[2])
{
    (void)parameters;
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double y = unknowns[0];
    const double u = unknowns[1];
    /* outputs */
    const double t0 = p1 + p2*y;
    coefficients[0] = -1;
    coefficients[1] = 0;
    coefficients[2] = t0;
    coefficients[3] = 1 - t0;
    coefficients[4] = p1*u/omega1;
    coefficients[5] = u*(1 - p1)/omega2;
    frequencies[0] = omega1;
    frequencies[1] = omega2;
}

/* State after a time in free.
 * Operations: 82. Intermediate terms: 16. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_flow_free(
    const double parameters[5], const double spectrum[7], double time, const double state[4],
    double state_after[4])
{
    (void)parameters;
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
    const double t14 = omega1*t2;
    const double t15 = omega2*t6;
    state_after[0] = t10*x1 + t11*x2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7);
    state_after[1] = t12*x1 + t13*x2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4);
    state_after[2] = t10*v1 + t11*v2 + x1*(-p1*t14 - t15*t4) + x2*(omega2*p2*t6 - p2*t14);
    state_after[3] = t12*v1 + t13*v2 + x1*(omega2*p3*t6 - p3*t14) + x2*(-p1*t15 - t14*t4);
}

/* All unknowns: they are explicit, and how singular the linear equations for them are: 0 if they are.
 * Operations: 76. Intermediate terms: 28. */
NONSMOOTH_UNMERGED
void rigid_stop_one_impact_expand(
    const double parameters[5], const double spectrum[7], double unknowns[2], double determinants[1])
{
    const double T = parameters[4];
    const double omega1 = spectrum[1];
    const double omega2 = spectrum[2];
    const double p1 = spectrum[3];
    const double p2 = spectrum[4];
    const double p3 = spectrum[5];
    /* half of T */
    const double half_T = (1.0/2.0)*T;
    /* functions of half_T in free */
    const double t0 = half_T*omega1;
    const double cos_omega1_half_T = cos(t0);
    const double sin_omega1_half_T = sin(t0);
    const double t1 = half_T*omega2;
    const double cos_omega2_half_T = cos(t1);
    const double sin_omega2_half_T = sin(t1);
    /* coefficients of the linear equations */
    const double t2 = omega1*sin_omega1_half_T;
    const double coefficient11 = omega2*p2*sin_omega2_half_T - p2*t2;
    const double t3 = p1 - 1;
    const double coefficient12 = cos_omega1_half_T*p1 - cos_omega2_half_T*t3;
    const double t4 = omega2*sin_omega2_half_T;
    const double coefficient21 = -p1*t4 + t2*t3;
    const double coefficient22 = cos_omega1_half_T*p3 - cos_omega2_half_T*p3;
    /* right-hand sides of the linear equations */
    const double right1 = p1*t2 - t3*t4;
    const double right2 = p3*t2 - p3*t4;
    /* determinant of the linear equations */
    const double determinant = coefficient11*coefficient22 - coefficient12*coefficient21;
    /* numerators of Cramer's rule */
    const double numerator1 = -coefficient12*right2 + coefficient22*right1;
    const double numerator2 = coefficient11*right2 - coefficient21*right1;
    /* y, u by Cramer's rule */
    const double t5 = (1.0/(determinant));
    const double y = numerator1*t5;
    const double u = numerator2*t5;
    /* outputs */
    const double t6 = (p1*p1);
    const double t7 = (half_T*half_T);
    const double t8 = 2*t7;
    const double t9 = (omega2*omega2*omega2*omega2)*t8/((omega2*omega2)*t7 + 1);
    const double t10 = (omega1*omega1*omega1*omega1)*t8/((omega1*omega1)*t7 + 1);
    const double t11 = (p2*p2);
    unknowns[0] = y;
    unknowns[1] = u;
    determinants[0] = determinant/(sqrt(2*(p3*p3) + t10*(t3*t3) + t6*t9)*sqrt(t10*t11 + t11*t9 + (t3*t3) + t6));
}

/* Newton's method on the reduced equations for `count` points. In one step a dwell time changes by
 * a factor of four at most; a point has converged when a whole step is below
 * 1e-9 max(1, |x|). */
NONSMOOTH_MULTIVERSION
void rigid_stop_one_impact_solve(
    ptrdiff_t count, const double *parameters, double *unknowns, double *trace, double *residual,
    int32_t *iterations, int32_t *status)
{
    enum { lanes = 16, most = 32 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[5][lanes], fixed[12][lanes];
        double open[lanes];
        int32_t taken[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const ptrdiff_t point = start + (lane < here ? lane : here - 1);
            for (int i = 0; i < 5; ++i)
                parameter[i][lane] = parameters[i * count + point];
            open[lane] = 0.0;
            taken[lane] = 0;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double m1 = parameter[0][lane];
            const double m2 = parameter[1][lane];
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double T = parameter[4][lane];
            const double gap1 = sqrt(4*(k1*k1)/(m1*m2) + ((k1/m1 - (k1 + k2)/m2)*(k1/m1 - (k1 + k2)/m2)));
            const double omega1 = sqrt((1.0/2.0)*gap1 + (1.0/2.0)*k1/m1 + (1.0/2.0)*(k1 + k2)/m2);
            const double omega2 = sqrt(k1)*sqrt(k2)/(sqrt(m1)*sqrt(m2)*omega1);
            const double p1 = 1.0/2.0 + (1.0/2.0)*(k1/m1 - (k1 + k2)/m2)/gap1;
            const double p2 = -k1/(gap1*m1);
            const double p3 = -k1/(gap1*m2);
            /* half of T */
            const double half_T = (1.0/2.0)*T;
            /* functions of half_T in free */
            const double t0 = half_T*omega1;
            const double cos_omega1_half_T = cos(t0);
            const double sin_omega1_half_T = sin(t0);
            const double t1 = half_T*omega2;
            const double cos_omega2_half_T = cos(t1);
            const double sin_omega2_half_T = sin(t1);
            /* coefficients of the linear equations */
            const double t2 = omega1*sin_omega1_half_T;
            const double coefficient11 = omega2*p2*sin_omega2_half_T - p2*t2;
            const double t3 = p1 - 1;
            const double coefficient12 = cos_omega1_half_T*p1 - cos_omega2_half_T*t3;
            const double t4 = omega2*sin_omega2_half_T;
            const double coefficient21 = -p1*t4 + t2*t3;
            const double coefficient22 = cos_omega1_half_T*p3 - cos_omega2_half_T*p3;
            /* right-hand sides of the linear equations */
            const double right1 = p1*t2 - t3*t4;
            const double right2 = p3*t2 - p3*t4;
            /* determinant of the linear equations */
            const double determinant = coefficient11*coefficient22 - coefficient12*coefficient21;
            /* numerators of Cramer's rule */
            const double numerator1 = -coefficient12*right2 + coefficient22*right1;
            const double numerator2 = coefficient11*right2 - coefficient21*right1;
            /* y, u by Cramer's rule */
            const double t5 = (1.0/(determinant));
            const double y = numerator1*t5;
            const double u = numerator2*t5;
            /* functions of T in free */
            const double t6 = T*omega1;
            const double cos_omega1_T = cos(t6);
            const double sin_omega1_T = sin(t6);
            const double t7 = T*omega2;
            const double cos_omega2_T = cos(t7);
            const double sin_omega2_T = sin(t7);
            /* free for T, until first-reaches-stop */
            const double t8 = (1.0/(omega1));
            const double t10 = sin_omega2_T/omega2;
            const double t11 = p1*sin_omega1_T*t8 - t10*t3;
            const double t12 = cos_omega1_T*p2 - cos_omega2_T*p2;
            const double t13 = cos_omega1_T*p1 - cos_omega2_T*t3;
            const double x1_1 = t11*u + t12*y + t13;
            const double t14 = -cos_omega1_T*t3 + cos_omega2_T*p1;
            const double t15 = cos_omega1_T*p3 - cos_omega2_T*p3;
            const double x2_1 = t14*y + t15 + u*(p3*sin_omega1_T*t8 - p3*t10);
            const double t16 = omega1*sin_omega1_T;
            const double t17 = omega2*sin_omega2_T;
            const double v1_1 = -p1*t16 + t13*u + t17*t3 + y*(omega2*p2*sin_omega2_T - p2*t16);
            const double v2_1 = -p3*t16 + p3*t17 + t15*u + y*(-p1*t17 + t16*t3);
            /* Phi along T */
            const double carried_x1_1_by_y = t12;
            const double carried_x1_1_by_u = t11;
            const double carried_x1_1_by_w = p2*sin_omega1_T*t8 - p2*t10;
            const double carried_x2_1_by_y = t14;
            const double carried_v1_1_by_u = t13;
            const double carried_v2_1_by_w = t14;
            /* derivatives of the time to the boundary after T */
            const double t18 = (1.0/(v1_1));
            const double delay_T_by_y = -carried_x1_1_by_y*t18;
            const double delay_T_by_u = -carried_x1_1_by_u*t18;
            const double delay_T_by_w = -carried_x1_1_by_w*t18;
            /* perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1;
            const double t19 = (1.0/(m1));
            const double v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*(-k1*t19*x1_1 + k1*t19*x2_1);
            const double t20 = (1.0/(m2));
            const double v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*(k1*t20*x1_1 - t20*x2_1*(k1 + k2));
            /* outputs */
            const double t21 = (p1*p1);
            const double t22 = (half_T*half_T);
            const double t23 = 2*t22;
            const double t24 = (omega2*omega2*omega2*omega2)*t23/((omega2*omega2)*t22 + 1);
            const double t25 = (omega1*omega1*omega1*omega1)*t23/((omega1*omega1)*t22 + 1);
            const double t26 = (p2*p2);
            fixed[0][lane] = p3;
            fixed[1][lane] = t3;
            fixed[2][lane] = determinant;
            fixed[3][lane] = y;
            fixed[4][lane] = u;
            fixed[5][lane] = x2_1_on_boundary_by_y;
            fixed[6][lane] = v1_1_on_boundary_by_u;
            fixed[7][lane] = v2_1_on_boundary_by_w;
            fixed[8][lane] = t21;
            fixed[9][lane] = t24;
            fixed[10][lane] = t25;
            fixed[11][lane] = t26;
        }
        double result[2][lanes], slope[lanes], defect[lanes];
        int32_t ended[lanes];
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double p3 = fixed[0][lane];
            const double t3 = fixed[1][lane];
            const double determinant = fixed[2][lane];
            const double y = fixed[3][lane];
            const double u = fixed[4][lane];
            const double x2_1_on_boundary_by_y = fixed[5][lane];
            const double v1_1_on_boundary_by_u = fixed[6][lane];
            const double v2_1_on_boundary_by_w = fixed[7][lane];
            const double t21 = fixed[8][lane];
            const double t24 = fixed[9][lane];
            const double t25 = fixed[10][lane];
            const double t26 = fixed[11][lane];
            result[0][lane] = y;
            result[1][lane] = u;
            slope[lane] = v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y;
            double largest = 0.0;
            defect[lane] = largest;
            const double finite = (slope[lane] - slope[lane]) + (result[0][lane] - result[0][lane]) + (result[1][lane] - result[1][lane]);
            int32_t ending = ((parameter[4][lane] <= 0.0)) ? RIGID_STOP_NOT_POSITIVE : RIGID_STOP_CONVERGED;
            ending = open[lane] != 0.0 ? RIGID_STOP_NOT_CONVERGED : ending;
            ending = finite == 0.0 ? ending : RIGID_STOP_NOT_FINITE;
            ending = ((fabs(determinant/(sqrt(2*(p3*p3) + t21*t24 + t25*(t3*t3))*sqrt(t21 + t24*t26 + t25*t26 + (t3*t3)))) <= 1e-12)) ? RIGID_STOP_SINGULAR : ending;
            ended[lane] = ending;
        }
        for (int i = 0; i < 2; ++i)
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
void rigid_stop_one_impact_admissible(
    ptrdiff_t count, const double *parameters, const double *unknowns, int32_t *boundary,
    double *excess, double *instant)
{
    static const int sums[] = {1}, terms[] = {2}, at_once[] = {0};
    static const int opened[] = {-1};
    static const int exits[] = {0}, first_frequency[] = {0};
    static const int begins[] = {1};
    static const double per_unit[] = {0.0};
    for (ptrdiff_t point = 0; point < count; ++point) {
        const double *const p = parameters + 5 * point, *const u = unknowns + 2 * point;
        const double q[4] = {p[2], p[3], p[0], p[1]};
        const double durations[] = {p[4]};
        double spectral[7], derivatives[28], coefficients[6], frequencies[2];
        rigid_stop_spectrum(q, spectral, derivatives);
        rigid_stop_one_impact_boundary_functions(p, spectral, u, coefficients, frequencies);
        /* the coefficients are differences of the data and carry their rounding */
        const double measures[] = {u[0], u[1]};
        double size = 0.0, missed = 0.0;
        for (int i = 0; i < 2; ++i)
            size = fabs(measures[i]) > size ? fabs(measures[i]) : size;
        /* by as much as a phase misses the boundary that ends it, all may be off: to a limit */
        for (int phase = 0; phase < 1; ++phase) {
            const double miss = fabs(
                nonsmooth_evaluate(terms[phase], frequencies + first_frequency[phase],
                                   coefficients + exits[phase], durations[phase]).value);
            missed = miss > missed ? miss : missed;
        }
        const double most_missed = 0x1p-30 * size;
        const double noise = 32.0 * DBL_EPSILON * size +
                             (2.0 * missed < most_missed ? 2.0 * missed : most_missed);
        double least[1], most = 0.0, when = 0.0;
        int found = RIGID_STOP_ADMISSIBLE, row = 0;
        const double *coefficient = coefficients, *frequency = frequencies;
        for (int i = 0; i < 1; ++i)
            least[i] = 0.0;
        for (int phase = 0; phase < 1 && found == RIGID_STOP_ADMISSIBLE; ++phase) {
            const double duration = durations[phase];
            const int length = 2 + 2 * terms[phase];
            double usual[1], floor[1], maximum[1], time[1];
            if (!(duration > 0.0) && !at_once[phase])
                found = duration <= 0.0 ? RIGID_STOP_NO_DURATION : RIGID_STOP_UNDECIDED;
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
            for (int i = 0; i < sums[phase] && found == RIGID_STOP_ADMISSIBLE; ++i) {
                if (!(maximum[i] >= floor[i])) {
                    found = RIGID_STOP_UNDECIDED;
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
void rigid_stop_one_impact_directions(
    ptrdiff_t count, const double *parameters, const double *unknowns, double *directions)
{
    enum { lanes = 16, n = 2, p = 5, width = 2 + 5 };
    for (ptrdiff_t start = 0; start < count; start += lanes) {
        const ptrdiff_t here = count - start < lanes ? count - start : lanes;
        double parameter[p][lanes], unknown[n][lanes], fixed[25][lanes];
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
            const double t9 = sqrt(k1);
            const double t10 = (1.0/sqrt(m2));
            const double t11 = sqrt(k2);
            const double t12 = (1.0/sqrt(m1));
            const double t13 = t10*t11*t12*t9;
            const double omega2 = t13*t8;
            const double t14 = (1.0/(gap1));
            const double t15 = (1.0/2.0)*t14;
            const double p1 = t15*t5 + 1.0/2.0;
            const double p2 = -t1*t14;
            const double t16 = t14*t2;
            const double p3 = -k1*t16;
            /* d/dk1 of: spectrum */
            const double gap1_by_k1 = t15*(8*t1*t2 + t5*(2*t0 - 2*t2));
            const double t18 = (1.0/2.0)*gap1_by_k1;
            const double t19 = (1.0/2.0)*t2;
            const double t20 = (1.0/2.0)*t8;
            const double omega1_by_k1 = t20*((1.0/2.0)*t0 + t18 + t19);
            const double t21 = t13/(omega1*omega1);
            const double omega2_by_k1 = -omega1_by_k1*t21 + (1.0/2.0)*t10*t11*t12*t8/t9;
            const double t22 = (1.0/(gap1*gap1));
            const double t23 = t22*t5;
            const double p1_by_k1 = t15*(t0 - t2) - t18*t23;
            const double p2_by_k1 = gap1_by_k1*k1*t0*t22 - t0*t14;
            const double p3_by_k1 = gap1_by_k1*k1*t2*t22 - t16;
            /* d/dk2 of: spectrum */
            const double gap1_by_k2 = -t16*t5;
            const double t25 = (1.0/2.0)*gap1_by_k2;
            const double omega1_by_k2 = t20*(t19 + t25);
            const double omega2_by_k2 = -omega1_by_k2*t21 + (1.0/2.0)*t10*t12*t8*t9/t11;
            const double p1_by_k2 = -t14*t19 - t23*t25;
            const double t26 = gap1_by_k2*t22;
            const double p2_by_k2 = t1*t26;
            const double t27 = k1*t2;
            const double p3_by_k2 = t26*t27;
            /* d/dm1 of: spectrum */
            const double t28 = (1.0/(m1*m1));
            const double t29 = k1*t28;
            const double gap1_by_m1 = t15*(-t28*t7 - 2*t29*t5);
            const double t30 = (1.0/2.0)*gap1_by_m1;
            const double omega1_by_m1 = t20*(-1.0/2.0*t29 + t30);
            const double omega2_by_m1 = -omega1_by_m1*t21 - t10*t11*t20*t9/(sqrt(m1)*sqrt(m1)*sqrt(m1));
            const double p1_by_m1 = -t15*t29 - t23*t30;
            const double t31 = gap1_by_m1*t22;
            const double p2_by_m1 = t1*t31 + t14*t29;
            const double p3_by_m1 = t27*t31;
            /* d/dm2 of: spectrum */
            const double t32 = (1.0/(m2*m2));
            const double gap1_by_m2 = t15*(-4*t0*t32*t6 + 2*t3*t32*t5);
            const double t33 = (1.0/2.0)*gap1_by_m2;
            const double t34 = t3*t32;
            const double omega1_by_m2 = t20*(t33 - 1.0/2.0*t34);
            const double t35 = (1.0/(sqrt(m2)*sqrt(m2)*sqrt(m2)));
            const double omega2_by_m2 = -omega1_by_m2*t21 - t11*t12*t20*t35*t9;
            const double p1_by_m2 = t15*t34 - t23*t33;
            const double t36 = gap1_by_m2*t22;
            const double p2_by_m2 = t1*t36;
            const double p3_by_m2 = k1*t14*t32 + t27*t36;
            fixed[0][lane] = omega1;
            fixed[1][lane] = omega2;
            fixed[2][lane] = p1;
            fixed[3][lane] = p2;
            fixed[4][lane] = p3;
            fixed[5][lane] = omega1_by_k1;
            fixed[6][lane] = omega1_by_k2;
            fixed[7][lane] = omega1_by_m1;
            fixed[8][lane] = omega1_by_m2;
            fixed[9][lane] = omega2_by_k1;
            fixed[10][lane] = omega2_by_k2;
            fixed[11][lane] = omega2_by_m1;
            fixed[12][lane] = omega2_by_m2;
            fixed[13][lane] = p1_by_k1;
            fixed[14][lane] = p1_by_k2;
            fixed[15][lane] = p1_by_m1;
            fixed[16][lane] = p1_by_m2;
            fixed[17][lane] = p2_by_k1;
            fixed[18][lane] = p2_by_k2;
            fixed[19][lane] = p2_by_m1;
            fixed[20][lane] = p2_by_m2;
            fixed[21][lane] = p3_by_k1;
            fixed[22][lane] = p3_by_k2;
            fixed[23][lane] = p3_by_m1;
            fixed[24][lane] = p3_by_m2;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double T = parameter[4][lane];
            const double y = unknown[0][lane];
            const double u = unknown[1][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega1_by_k1 = fixed[5][lane];
            const double omega1_by_k2 = fixed[6][lane];
            const double omega1_by_m1 = fixed[7][lane];
            const double omega1_by_m2 = fixed[8][lane];
            const double omega2_by_k1 = fixed[9][lane];
            const double omega2_by_k2 = fixed[10][lane];
            const double omega2_by_m1 = fixed[11][lane];
            const double omega2_by_m2 = fixed[12][lane];
            const double p1_by_k1 = fixed[13][lane];
            const double p1_by_k2 = fixed[14][lane];
            const double p1_by_m1 = fixed[15][lane];
            const double p1_by_m2 = fixed[16][lane];
            const double p2_by_k1 = fixed[17][lane];
            const double p2_by_k2 = fixed[18][lane];
            const double p2_by_m1 = fixed[19][lane];
            const double p2_by_m2 = fixed[20][lane];
            const double p3_by_k1 = fixed[21][lane];
            const double p3_by_k2 = fixed[22][lane];
            const double p3_by_m1 = fixed[23][lane];
            const double p3_by_m2 = fixed[24][lane];
            /* half of T */
            const double half_T = (1.0/2.0)*T;
            /* functions of half_T in free */
            const double t0 = half_T*omega1;
            double sine_0, cosine_0;
            nonsmooth_sincos(t0, &sine_0, &cosine_0);
            const double cos_omega1_half_T = cosine_0;
            const double sin_omega1_half_T = sine_0;
            const double t3 = half_T*omega2;
            double sine_1, cosine_1;
            nonsmooth_sincos(t3, &sine_1, &cosine_1);
            const double cos_omega2_half_T = cosine_1;
            const double sin_omega2_half_T = sine_1;
            /* d/dm1 of: functions of half_T in free */
            const double t6 = half_T*omega1_by_m1;
            const double cos_omega1_half_T_by_m1 = -sin_omega1_half_T*t6;
            const double sin_omega1_half_T_by_m1 = cos_omega1_half_T*t6;
            const double t7 = half_T*omega2_by_m1;
            const double cos_omega2_half_T_by_m1 = -sin_omega2_half_T*t7;
            const double sin_omega2_half_T_by_m1 = cos_omega2_half_T*t7;
            /* d/dm2 of: functions of half_T in free */
            const double t8 = half_T*omega1_by_m2;
            const double cos_omega1_half_T_by_m2 = -sin_omega1_half_T*t8;
            const double sin_omega1_half_T_by_m2 = cos_omega1_half_T*t8;
            const double t9 = half_T*omega2_by_m2;
            const double cos_omega2_half_T_by_m2 = -sin_omega2_half_T*t9;
            const double sin_omega2_half_T_by_m2 = cos_omega2_half_T*t9;
            /* d/dk1 of: functions of half_T in free */
            const double t10 = half_T*omega1_by_k1;
            const double cos_omega1_half_T_by_k1 = -sin_omega1_half_T*t10;
            const double sin_omega1_half_T_by_k1 = cos_omega1_half_T*t10;
            const double t11 = half_T*omega2_by_k1;
            const double cos_omega2_half_T_by_k1 = -sin_omega2_half_T*t11;
            const double sin_omega2_half_T_by_k1 = cos_omega2_half_T*t11;
            /* d/dk2 of: functions of half_T in free */
            const double t12 = half_T*omega1_by_k2;
            const double cos_omega1_half_T_by_k2 = -sin_omega1_half_T*t12;
            const double sin_omega1_half_T_by_k2 = cos_omega1_half_T*t12;
            const double t13 = half_T*omega2_by_k2;
            const double cos_omega2_half_T_by_k2 = -sin_omega2_half_T*t13;
            const double sin_omega2_half_T_by_k2 = cos_omega2_half_T*t13;
            /* d/dT of: functions of half_T in free */
            const double t14 = (1.0/2.0)*omega1;
            const double cos_omega1_half_T_by_T = -sin_omega1_half_T*t14;
            const double sin_omega1_half_T_by_T = cos_omega1_half_T*t14;
            const double t15 = (1.0/2.0)*omega2;
            const double cos_omega2_half_T_by_T = -sin_omega2_half_T*t15;
            const double sin_omega2_half_T_by_T = cos_omega2_half_T*t15;
            /* outputs */
            const double t16 = omega1*sin_omega1_half_T;
            const double t17 = p1 - 1;
            const double t18 = omega2*sin_omega2_half_T;
            const double t19 = cos_omega1_half_T*u - cos_omega2_half_T*u - t16 + t18;
            const double t20 = -omega2*sin_omega2_half_T*y + t16*y;
            const double t22 = p1*u;
            const double t23 = p2*y;
            const double t24 = t17 + t23;
            const double t25 = sin_omega2_half_T*t24;
            const double t26 = omega2*t24;
            const double t27 = t17*u;
            const double t28 = p1 + t23;
            const double t29 = sin_omega1_half_T*t28;
            const double t30 = omega1*t28;
            const double t31 = p3*u;
            const double t32 = p1*y - p3 - y;
            const double t33 = sin_omega1_half_T*t32;
            const double t34 = omega1*t32;
            const double t35 = p1*y - p3;
            const double t36 = sin_omega2_half_T*t35;
            const double t37 = omega2*t35;
            matrix[0][0][lane] = omega2*p2*sin_omega2_half_T - p2*t16;
            matrix[0][1][lane] = cos_omega1_half_T*p1 - cos_omega2_half_T*t17;
            matrix[1][0][lane] = -p1*t18 + t16*t17;
            matrix[1][1][lane] = cos_omega1_half_T*p3 - cos_omega2_half_T*p3;
            matrix[0][2][lane] = -cos_omega1_half_T_by_m1*t22 + cos_omega2_half_T_by_m1*t27 + omega1_by_m1*t29 - omega2_by_m1*t25 - p1_by_m1*t19 + p2_by_m1*t20 + sin_omega1_half_T_by_m1*t30 - sin_omega2_half_T_by_m1*t26;
            matrix[0][3][lane] = -cos_omega1_half_T_by_m2*t22 + cos_omega2_half_T_by_m2*t27 + omega1_by_m2*t29 - omega2_by_m2*t25 - p1_by_m2*t19 + p2_by_m2*t20 + sin_omega1_half_T_by_m2*t30 - sin_omega2_half_T_by_m2*t26;
            matrix[0][4][lane] = -cos_omega1_half_T_by_k1*t22 + cos_omega2_half_T_by_k1*t27 + omega1_by_k1*t29 - omega2_by_k1*t25 - p1_by_k1*t19 + p2_by_k1*t20 + sin_omega1_half_T_by_k1*t30 - sin_omega2_half_T_by_k1*t26;
            matrix[0][5][lane] = -cos_omega1_half_T_by_k2*t22 + cos_omega2_half_T_by_k2*t27 + omega1_by_k2*t29 - omega2_by_k2*t25 - p1_by_k2*t19 + p2_by_k2*t20 + sin_omega1_half_T_by_k2*t30 - sin_omega2_half_T_by_k2*t26;
            matrix[0][6][lane] = -cos_omega1_half_T_by_T*t22 + cos_omega2_half_T_by_T*t27 + sin_omega1_half_T_by_T*t30 - sin_omega2_half_T_by_T*t26;
            matrix[1][2][lane] = -cos_omega1_half_T_by_m1*t31 + cos_omega2_half_T_by_m1*t31 - omega1_by_m1*t33 + omega2_by_m1*t36 - p1_by_m1*t20 - p3_by_m1*t19 - sin_omega1_half_T_by_m1*t34 + sin_omega2_half_T_by_m1*t37;
            matrix[1][3][lane] = -cos_omega1_half_T_by_m2*t31 + cos_omega2_half_T_by_m2*t31 - omega1_by_m2*t33 + omega2_by_m2*t36 - p1_by_m2*t20 - p3_by_m2*t19 - sin_omega1_half_T_by_m2*t34 + sin_omega2_half_T_by_m2*t37;
            matrix[1][4][lane] = -cos_omega1_half_T_by_k1*t31 + cos_omega2_half_T_by_k1*t31 - omega1_by_k1*t33 + omega2_by_k1*t36 - p1_by_k1*t20 - p3_by_k1*t19 - sin_omega1_half_T_by_k1*t34 + sin_omega2_half_T_by_k1*t37;
            matrix[1][5][lane] = -cos_omega1_half_T_by_k2*t31 + cos_omega2_half_T_by_k2*t31 - omega1_by_k2*t33 + omega2_by_k2*t36 - p1_by_k2*t20 - p3_by_k2*t19 - sin_omega1_half_T_by_k2*t34 + sin_omega2_half_T_by_k2*t37;
            matrix[1][6][lane] = -cos_omega1_half_T_by_T*t31 + cos_omega2_half_T_by_T*t31 - sin_omega1_half_T_by_T*t34 + sin_omega2_half_T_by_T*t37;
        }
        NONSMOOTH_SIMD
        for (int lane = 0; lane < lanes; ++lane) {
            const double m1 = parameter[0][lane];
            const double m2 = parameter[1][lane];
            const double k1 = parameter[2][lane];
            const double k2 = parameter[3][lane];
            const double T = parameter[4][lane];
            const double y = unknown[0][lane];
            const double u = unknown[1][lane];
            const double omega1 = fixed[0][lane];
            const double omega2 = fixed[1][lane];
            const double p1 = fixed[2][lane];
            const double p2 = fixed[3][lane];
            const double p3 = fixed[4][lane];
            const double omega1_by_k1 = fixed[5][lane];
            const double omega1_by_k2 = fixed[6][lane];
            const double omega1_by_m1 = fixed[7][lane];
            const double omega1_by_m2 = fixed[8][lane];
            const double omega2_by_k1 = fixed[9][lane];
            const double omega2_by_k2 = fixed[10][lane];
            const double omega2_by_m1 = fixed[11][lane];
            const double omega2_by_m2 = fixed[12][lane];
            const double p1_by_k1 = fixed[13][lane];
            const double p1_by_k2 = fixed[14][lane];
            const double p1_by_m1 = fixed[15][lane];
            const double p1_by_m2 = fixed[16][lane];
            const double p2_by_k1 = fixed[17][lane];
            const double p2_by_k2 = fixed[18][lane];
            const double p2_by_m1 = fixed[19][lane];
            const double p2_by_m2 = fixed[20][lane];
            const double p3_by_k1 = fixed[21][lane];
            const double p3_by_k2 = fixed[22][lane];
            const double p3_by_m1 = fixed[23][lane];
            const double p3_by_m2 = fixed[24][lane];
            /* functions of T in free */
            const double t0 = T*omega1;
            double sine_0, cosine_0;
            nonsmooth_sincos(t0, &sine_0, &cosine_0);
            const double cos_omega1_T = cosine_0;
            const double sin_omega1_T = sine_0;
            const double t3 = T*omega2;
            double sine_1, cosine_1;
            nonsmooth_sincos(t3, &sine_1, &cosine_1);
            const double cos_omega2_T = cosine_1;
            const double sin_omega2_T = sine_1;
            /* free for T, until first-reaches-stop */
            const double t6 = (1.0/(omega1));
            const double t7 = p1 - 1;
            const double t9 = (1.0/(omega2));
            const double t10 = sin_omega2_T*t9;
            const double t11 = p1*sin_omega1_T*t6 - t10*t7;
            const double t12 = cos_omega1_T*p2 - cos_omega2_T*p2;
            const double t13 = cos_omega1_T*p1 - cos_omega2_T*t7;
            const double x1_1 = t11*u + t12*y + t13;
            const double t14 = p3*sin_omega1_T*t6 - p3*t10;
            const double t15 = -cos_omega1_T*t7 + cos_omega2_T*p1;
            const double t16 = cos_omega1_T*p3 - cos_omega2_T*p3;
            const double x2_1 = t14*u + t15*y + t16;
            const double t17 = omega1*sin_omega1_T;
            const double t18 = omega2*p2*sin_omega2_T - p2*t17;
            const double t19 = p1*sin_omega1_T;
            const double t20 = -sin_omega2_T*t7;
            const double v1_1 = -omega1*t19 - omega2*t20 + t13*u + t18*y;
            const double t21 = omega2*sin_omega2_T;
            const double t22 = -p1*t21 + t17*t7;
            const double v2_1 = -p3*t17 + p3*t21 + t16*u + t22*y;
            /* Phi along T */
            const double carried_x1_1_by_y = t12;
            const double carried_x1_1_by_u = t11;
            const double carried_x1_1_by_w = p2*sin_omega1_T*t6 - p2*t10;
            /* derivatives of the time to the boundary after T */
            const double t23 = (1.0/(v1_1));
            const double delay_T_by_y = -carried_x1_1_by_y*t23;
            const double delay_T_by_u = -carried_x1_1_by_u*t23;
            const double delay_T_by_w = -carried_x1_1_by_w*t23;
            /* d/dm1 of: functions of T in free */
            const double t24 = T*omega1_by_m1;
            const double cos_omega1_T_by_m1 = -sin_omega1_T*t24;
            const double sin_omega1_T_by_m1 = cos_omega1_T*t24;
            const double t25 = T*omega2_by_m1;
            const double cos_omega2_T_by_m1 = -sin_omega2_T*t25;
            const double sin_omega2_T_by_m1 = cos_omega2_T*t25;
            /* d/dm2 of: functions of T in free */
            const double t26 = T*omega1_by_m2;
            const double cos_omega1_T_by_m2 = -sin_omega1_T*t26;
            const double sin_omega1_T_by_m2 = cos_omega1_T*t26;
            const double t27 = T*omega2_by_m2;
            const double cos_omega2_T_by_m2 = -sin_omega2_T*t27;
            const double sin_omega2_T_by_m2 = cos_omega2_T*t27;
            /* d/dk1 of: functions of T in free */
            const double t28 = T*omega1_by_k1;
            const double cos_omega1_T_by_k1 = -sin_omega1_T*t28;
            const double sin_omega1_T_by_k1 = cos_omega1_T*t28;
            const double t29 = T*omega2_by_k1;
            const double cos_omega2_T_by_k1 = -sin_omega2_T*t29;
            const double sin_omega2_T_by_k1 = cos_omega2_T*t29;
            /* d/dk2 of: functions of T in free */
            const double t30 = T*omega1_by_k2;
            const double cos_omega1_T_by_k2 = -sin_omega1_T*t30;
            const double sin_omega1_T_by_k2 = cos_omega1_T*t30;
            const double t31 = T*omega2_by_k2;
            const double cos_omega2_T_by_k2 = -sin_omega2_T*t31;
            const double sin_omega2_T_by_k2 = cos_omega2_T*t31;
            /* d/dT of: functions of T in free */
            const double cos_omega1_T_by_T = -omega1*sin_omega1_T;
            const double sin_omega1_T_by_T = cos_omega1_T*omega1;
            const double cos_omega2_T_by_T = -omega2*sin_omega2_T;
            const double sin_omega2_T_by_T = cos_omega2_T*omega2;
            /* d/dy of: free for T, until first-reaches-stop */
            const double x1_1_by_y = t12;
            const double x2_1_by_y = t15;
            const double v1_1_by_y = t18;
            const double v2_1_by_y = t22;
            /* d/du of: free for T, until first-reaches-stop */
            const double x1_1_by_u = t11;
            const double x2_1_by_u = t14;
            const double v1_1_by_u = t13;
            const double v2_1_by_u = t16;
            /* d/dm1 of: free for T, until first-reaches-stop */
            const double t32 = p2*y;
            const double t33 = p1 + t32;
            const double t34 = -t32 - t7;
            const double t35 = sin_omega1_T*t6 - t10;
            const double t36 = cos_omega1_T - cos_omega2_T;
            const double t37 = t35*u + t36;
            const double t38 = p2_by_m1*t36;
            const double t39 = sin_omega1_T_by_m1*t6;
            const double t40 = p1*t39;
            const double t41 = sin_omega2_T_by_m1*t9;
            const double t42 = -t41*t7;
            const double t43 = (1.0/(omega1*omega1));
            const double t44 = omega1_by_m1*t43;
            const double t45 = t19*t44;
            const double t46 = (1.0/(omega2*omega2));
            const double t47 = omega2_by_m1*t46;
            const double t48 = t20*t47;
            const double x1_1_by_m1 = cos_omega1_T_by_m1*t33 + cos_omega2_T_by_m1*t34 + p1_by_m1*t37 + t38*y + t40*u + t42*u - t45*u - t48*u;
            const double t49 = -t7*y;
            const double t50 = p3 + t49;
            const double t51 = p1*y;
            const double t52 = -p3 + t51;
            const double t54 = -p1_by_m1*t36;
            const double t55 = p3*u;
            const double t56 = p3*sin_omega2_T*u;
            const double t57 = p3*sin_omega1_T;
            const double t58 = t57*u;
            const double x2_1_by_m1 = cos_omega1_T_by_m1*t50 + cos_omega2_T_by_m1*t52 + p3_by_m1*t37 + t39*t55 - t41*t55 - t44*t58 + t47*t56 + t54*y;
            const double t59 = -sin_omega1_T*t32 - t19;
            const double t60 = sin_omega2_T*t32 - t20;
            const double t61 = -t17 + t21 + t36*u;
            const double t62 = -omega1*p1 - omega1*t32;
            const double t63 = omega2*t32 + omega2*t7;
            const double t64 = cos_omega1_T_by_m1*p1;
            const double t65 = -cos_omega2_T_by_m1*t7;
            const double t66 = -omega2*sin_omega2_T + t17;
            const double t67 = -t66*y;
            const double v1_1_by_m1 = omega1_by_m1*t59 + omega2_by_m1*t60 + p1_by_m1*t61 + p2_by_m1*t67 + sin_omega1_T_by_m1*t62 + sin_omega2_T_by_m1*t63 + t64*u + t65*u;
            const double t68 = -sin_omega1_T*t49 - t57;
            const double t69 = p3*sin_omega2_T - sin_omega2_T*t51;
            const double t70 = -omega1*p3 - omega1*t49;
            const double t71 = omega2*p3 - omega2*t51;
            const double t72 = t66*y;
            const double v2_1_by_m1 = cos_omega1_T_by_m1*t55 - cos_omega2_T_by_m1*t55 + omega1_by_m1*t68 + omega2_by_m1*t69 + p1_by_m1*t72 + p3_by_m1*t61 + sin_omega1_T_by_m1*t70 + sin_omega2_T_by_m1*t71;
            /* d/dm2 of: free for T, until first-reaches-stop */
            const double t73 = p2_by_m2*t36;
            const double t74 = sin_omega1_T_by_m2*t6;
            const double t75 = p1*t74;
            const double t76 = sin_omega2_T_by_m2*t9;
            const double t77 = -t7*t76;
            const double t78 = omega1_by_m2*t43;
            const double t79 = t19*t78;
            const double t80 = omega2_by_m2*t46;
            const double t81 = t20*t80;
            const double x1_1_by_m2 = cos_omega1_T_by_m2*t33 + cos_omega2_T_by_m2*t34 + p1_by_m2*t37 + t73*y + t75*u + t77*u - t79*u - t81*u;
            const double t82 = -p1_by_m2*t36;
            const double x2_1_by_m2 = cos_omega1_T_by_m2*t50 + cos_omega2_T_by_m2*t52 + p3_by_m2*t37 + t55*t74 - t55*t76 + t56*t80 - t58*t78 + t82*y;
            const double t83 = cos_omega1_T_by_m2*p1;
            const double t84 = -cos_omega2_T_by_m2*t7;
            const double v1_1_by_m2 = omega1_by_m2*t59 + omega2_by_m2*t60 + p1_by_m2*t61 + p2_by_m2*t67 + sin_omega1_T_by_m2*t62 + sin_omega2_T_by_m2*t63 + t83*u + t84*u;
            const double v2_1_by_m2 = cos_omega1_T_by_m2*t55 - cos_omega2_T_by_m2*t55 + omega1_by_m2*t68 + omega2_by_m2*t69 + p1_by_m2*t72 + p3_by_m2*t61 + sin_omega1_T_by_m2*t70 + sin_omega2_T_by_m2*t71;
            /* d/dk1 of: free for T, until first-reaches-stop */
            const double t85 = p2_by_k1*t36;
            const double t86 = sin_omega1_T_by_k1*t6;
            const double t87 = p1*t86;
            const double t88 = sin_omega2_T_by_k1*t9;
            const double t89 = -t7*t88;
            const double t90 = omega1_by_k1*t43;
            const double t91 = t19*t90;
            const double t92 = omega2_by_k1*t46;
            const double t93 = t20*t92;
            const double x1_1_by_k1 = cos_omega1_T_by_k1*t33 + cos_omega2_T_by_k1*t34 + p1_by_k1*t37 + t85*y + t87*u + t89*u - t91*u - t93*u;
            const double t94 = -p1_by_k1*t36;
            const double x2_1_by_k1 = cos_omega1_T_by_k1*t50 + cos_omega2_T_by_k1*t52 + p3_by_k1*t37 + t55*t86 - t55*t88 + t56*t92 - t58*t90 + t94*y;
            const double t95 = cos_omega1_T_by_k1*p1;
            const double t96 = -cos_omega2_T_by_k1*t7;
            const double v1_1_by_k1 = omega1_by_k1*t59 + omega2_by_k1*t60 + p1_by_k1*t61 + p2_by_k1*t67 + sin_omega1_T_by_k1*t62 + sin_omega2_T_by_k1*t63 + t95*u + t96*u;
            const double v2_1_by_k1 = cos_omega1_T_by_k1*t55 - cos_omega2_T_by_k1*t55 + omega1_by_k1*t68 + omega2_by_k1*t69 + p1_by_k1*t72 + p3_by_k1*t61 + sin_omega1_T_by_k1*t70 + sin_omega2_T_by_k1*t71;
            /* d/dk2 of: free for T, until first-reaches-stop */
            const double t97 = p2_by_k2*t36;
            const double t98 = sin_omega1_T_by_k2*t6;
            const double t99 = p1*t98;
            const double t100 = sin_omega2_T_by_k2*t9;
            const double t101 = -t100*t7;
            const double t102 = omega1_by_k2*t43;
            const double t103 = t102*t19;
            const double t104 = omega2_by_k2*t46;
            const double t105 = t104*t20;
            const double x1_1_by_k2 = cos_omega1_T_by_k2*t33 + cos_omega2_T_by_k2*t34 + p1_by_k2*t37 + t101*u - t103*u - t105*u + t97*y + t99*u;
            const double t106 = -p1_by_k2*t36;
            const double x2_1_by_k2 = cos_omega1_T_by_k2*t50 + cos_omega2_T_by_k2*t52 + p3_by_k2*t37 - t100*t55 - t102*t58 + t104*t56 + t106*y + t55*t98;
            const double t107 = cos_omega1_T_by_k2*p1;
            const double t108 = -cos_omega2_T_by_k2*t7;
            const double v1_1_by_k2 = omega1_by_k2*t59 + omega2_by_k2*t60 + p1_by_k2*t61 + p2_by_k2*t67 + sin_omega1_T_by_k2*t62 + sin_omega2_T_by_k2*t63 + t107*u + t108*u;
            const double v2_1_by_k2 = cos_omega1_T_by_k2*t55 - cos_omega2_T_by_k2*t55 + omega1_by_k2*t68 + omega2_by_k2*t69 + p1_by_k2*t72 + p3_by_k2*t61 + sin_omega1_T_by_k2*t70 + sin_omega2_T_by_k2*t71;
            /* d/dT of: free for T, until first-reaches-stop */
            const double t109 = sin_omega1_T_by_T*t6;
            const double t110 = p1*t109;
            const double t111 = sin_omega2_T_by_T*t9;
            const double t112 = -t111*t7;
            const double x1_1_by_T = cos_omega1_T_by_T*t33 + cos_omega2_T_by_T*t34 + t110*u + t112*u;
            const double x2_1_by_T = cos_omega1_T_by_T*t50 + cos_omega2_T_by_T*t52 + t109*t55 - t111*t55;
            const double t113 = cos_omega1_T_by_T*p1;
            const double t114 = -cos_omega2_T_by_T*t7;
            const double v1_1_by_T = sin_omega1_T_by_T*t62 + sin_omega2_T_by_T*t63 + t113*u + t114*u;
            const double v2_1_by_T = cos_omega1_T_by_T*t55 - cos_omega2_T_by_T*t55 + sin_omega1_T_by_T*t70 + sin_omega2_T_by_T*t71;
            /* d/dm1 of: Phi along T */
            const double carried_x1_1_by_y_by_m1 = cos_omega1_T_by_m1*p2 - cos_omega2_T_by_m1*p2 + t38;
            const double carried_x1_1_by_u_by_m1 = p1_by_m1*t35 + t40 + t42 - t45 - t48;
            const double t115 = p2*sin_omega2_T;
            const double t116 = p2*sin_omega1_T;
            const double carried_x1_1_by_w_by_m1 = p2*t39 - p2*t41 + p2_by_m1*t35 + t115*t47 - t116*t44;
            const double carried_x2_1_by_y_by_m1 = -cos_omega1_T_by_m1*t7 + cos_omega2_T_by_m1*p1 + t54;
            const double carried_v1_1_by_u_by_m1 = p1_by_m1*t36 + t64 + t65;
            const double carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1;
            /* d/dm2 of: Phi along T */
            const double carried_x1_1_by_y_by_m2 = cos_omega1_T_by_m2*p2 - cos_omega2_T_by_m2*p2 + t73;
            const double carried_x1_1_by_u_by_m2 = p1_by_m2*t35 + t75 + t77 - t79 - t81;
            const double carried_x1_1_by_w_by_m2 = p2*t74 - p2*t76 + p2_by_m2*t35 + t115*t80 - t116*t78;
            const double carried_x2_1_by_y_by_m2 = -cos_omega1_T_by_m2*t7 + cos_omega2_T_by_m2*p1 + t82;
            const double carried_v1_1_by_u_by_m2 = p1_by_m2*t36 + t83 + t84;
            const double carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2;
            /* d/dk1 of: Phi along T */
            const double carried_x1_1_by_y_by_k1 = cos_omega1_T_by_k1*p2 - cos_omega2_T_by_k1*p2 + t85;
            const double carried_x1_1_by_u_by_k1 = p1_by_k1*t35 + t87 + t89 - t91 - t93;
            const double carried_x1_1_by_w_by_k1 = p2*t86 - p2*t88 + p2_by_k1*t35 + t115*t92 - t116*t90;
            const double carried_x2_1_by_y_by_k1 = -cos_omega1_T_by_k1*t7 + cos_omega2_T_by_k1*p1 + t94;
            const double carried_v1_1_by_u_by_k1 = p1_by_k1*t36 + t95 + t96;
            const double carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1;
            /* d/dk2 of: Phi along T */
            const double carried_x1_1_by_y_by_k2 = cos_omega1_T_by_k2*p2 - cos_omega2_T_by_k2*p2 + t97;
            const double carried_x1_1_by_u_by_k2 = p1_by_k2*t35 + t101 - t103 - t105 + t99;
            const double carried_x1_1_by_w_by_k2 = -p2*t100 + p2*t98 + p2_by_k2*t35 - t102*t116 + t104*t115;
            const double carried_x2_1_by_y_by_k2 = -cos_omega1_T_by_k2*t7 + cos_omega2_T_by_k2*p1 + t106;
            const double carried_v1_1_by_u_by_k2 = p1_by_k2*t36 + t107 + t108;
            const double carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2;
            /* d/dT of: Phi along T */
            const double carried_x1_1_by_y_by_T = cos_omega1_T_by_T*p2 - cos_omega2_T_by_T*p2;
            const double carried_x1_1_by_u_by_T = t110 + t112;
            const double carried_x1_1_by_w_by_T = p2*sin_omega1_T_by_T*t6 - p2*t111;
            const double carried_x2_1_by_y_by_T = -cos_omega1_T_by_T*t7 + cos_omega2_T_by_T*p1;
            const double carried_v1_1_by_u_by_T = t113 + t114;
            const double carried_v2_1_by_w_by_T = carried_x2_1_by_y_by_T;
            /* d/dy of: derivatives of the time to the boundary after T */
            const double t122 = (1.0/(v1_1*v1_1));
            const double t123 = t122*v1_1_by_y;
            const double delay_T_by_y_by_y = carried_x1_1_by_y*t123;
            const double delay_T_by_u_by_y = carried_x1_1_by_u*t123;
            const double delay_T_by_w_by_y = carried_x1_1_by_w*t123;
            /* d/du of: derivatives of the time to the boundary after T */
            const double t124 = t122*v1_1_by_u;
            const double delay_T_by_y_by_u = carried_x1_1_by_y*t124;
            const double delay_T_by_u_by_u = carried_x1_1_by_u*t124;
            const double delay_T_by_w_by_u = carried_x1_1_by_w*t124;
            /* d/dm1 of: derivatives of the time to the boundary after T */
            const double t125 = t122*v1_1_by_m1;
            const double delay_T_by_y_by_m1 = carried_x1_1_by_y*t125 - carried_x1_1_by_y_by_m1*t23;
            const double delay_T_by_u_by_m1 = carried_x1_1_by_u*t125 - carried_x1_1_by_u_by_m1*t23;
            const double delay_T_by_w_by_m1 = carried_x1_1_by_w*t125 - carried_x1_1_by_w_by_m1*t23;
            /* d/dm2 of: derivatives of the time to the boundary after T */
            const double t126 = t122*v1_1_by_m2;
            const double delay_T_by_y_by_m2 = carried_x1_1_by_y*t126 - carried_x1_1_by_y_by_m2*t23;
            const double delay_T_by_u_by_m2 = carried_x1_1_by_u*t126 - carried_x1_1_by_u_by_m2*t23;
            const double delay_T_by_w_by_m2 = carried_x1_1_by_w*t126 - carried_x1_1_by_w_by_m2*t23;
            /* d/dk1 of: derivatives of the time to the boundary after T */
            const double t127 = t122*v1_1_by_k1;
            const double delay_T_by_y_by_k1 = carried_x1_1_by_y*t127 - carried_x1_1_by_y_by_k1*t23;
            const double delay_T_by_u_by_k1 = carried_x1_1_by_u*t127 - carried_x1_1_by_u_by_k1*t23;
            const double delay_T_by_w_by_k1 = carried_x1_1_by_w*t127 - carried_x1_1_by_w_by_k1*t23;
            /* d/dk2 of: derivatives of the time to the boundary after T */
            const double t128 = t122*v1_1_by_k2;
            const double delay_T_by_y_by_k2 = carried_x1_1_by_y*t128 - carried_x1_1_by_y_by_k2*t23;
            const double delay_T_by_u_by_k2 = carried_x1_1_by_u*t128 - carried_x1_1_by_u_by_k2*t23;
            const double delay_T_by_w_by_k2 = carried_x1_1_by_w*t128 - carried_x1_1_by_w_by_k2*t23;
            /* d/dT of: derivatives of the time to the boundary after T */
            const double t129 = t122*v1_1_by_T;
            const double delay_T_by_y_by_T = carried_x1_1_by_y*t129 - carried_x1_1_by_y_by_T*t23;
            const double delay_T_by_u_by_T = carried_x1_1_by_u*t129 - carried_x1_1_by_u_by_T*t23;
            const double delay_T_by_w_by_T = carried_x1_1_by_w*t129 - carried_x1_1_by_w_by_T*t23;
            /* d/dy of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_y = delay_T_by_y*v2_1_by_y + delay_T_by_y_by_y*v2_1;
            const double t130 = (1.0/(m1));
            const double t131 = t130*x1_1;
            const double t132 = -k1*t130*x2_1 + k1*t131;
            const double t133 = k1*x1_1_by_y;
            const double t134 = delay_T_by_u*t130;
            const double t135 = k1*t134;
            const double v1_1_on_boundary_by_u_by_y = delay_T_by_u_by_y*t132 + t133*t134 - t135*x2_1_by_y;
            const double t136 = (1.0/(m2));
            const double t137 = t136*x1_1;
            const double t138 = k1 + k2;
            const double t139 = t136*x2_1;
            const double t140 = k1*t137 - t138*t139;
            const double t141 = delay_T_by_w*t136;
            const double t142 = t138*t141;
            const double v2_1_on_boundary_by_w_by_y = delay_T_by_w_by_y*t140 + t133*t141 - t142*x2_1_by_y;
            /* d/du of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_u = delay_T_by_y*v2_1_by_u + delay_T_by_y_by_u*v2_1;
            const double v1_1_on_boundary_by_u_by_u = delay_T_by_u_by_u*t132 + t135*x1_1_by_u - t135*x2_1_by_u;
            const double t143 = k1*t141;
            const double v2_1_on_boundary_by_w_by_u = delay_T_by_w_by_u*t140 - t142*x2_1_by_u + t143*x1_1_by_u;
            /* d/dm1 of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_T_by_y*v2_1_by_m1 + delay_T_by_y_by_m1*v2_1;
            const double t144 = k1/(m1*m1);
            const double v1_1_on_boundary_by_u_by_m1 = -carried_v1_1_by_u_by_m1 + delay_T_by_u*k1*t130*x1_1_by_m1 - delay_T_by_u*(t144*x1_1 - t144*x2_1) + delay_T_by_u_by_m1*t132 - t135*x2_1_by_m1;
            const double v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_T_by_w_by_m1*t140 - t142*x2_1_by_m1 + t143*x1_1_by_m1;
            /* d/dm2 of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_T_by_y*v2_1_by_m2 + delay_T_by_y_by_m2*v2_1;
            const double v1_1_on_boundary_by_u_by_m2 = -carried_v1_1_by_u_by_m2 + delay_T_by_u*k1*t130*x1_1_by_m2 + delay_T_by_u_by_m2*t132 - t135*x2_1_by_m2;
            const double t145 = (1.0/(m2*m2));
            const double v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_T_by_w*(-k1*t145*x1_1 + t138*t145*x2_1) + delay_T_by_w_by_m2*t140 - t142*x2_1_by_m2 + t143*x1_1_by_m2;
            /* d/dk1 of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_T_by_y*v2_1_by_k1 + delay_T_by_y_by_k1*v2_1;
            const double v1_1_on_boundary_by_u_by_k1 = -carried_v1_1_by_u_by_k1 + delay_T_by_u*k1*t130*x1_1_by_k1 - delay_T_by_u*(t130*x2_1 - t131) + delay_T_by_u_by_k1*t132 - t135*x2_1_by_k1;
            const double v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_T_by_w*(t137 - t139) + delay_T_by_w_by_k1*t140 - t142*x2_1_by_k1 + t143*x1_1_by_k1;
            /* d/dk2 of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_T_by_y*v2_1_by_k2 + delay_T_by_y_by_k2*v2_1;
            const double v1_1_on_boundary_by_u_by_k2 = -carried_v1_1_by_u_by_k2 + delay_T_by_u*k1*t130*x1_1_by_k2 + delay_T_by_u_by_k2*t132 - t135*x2_1_by_k2;
            const double v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_T_by_w*t139 + delay_T_by_w_by_k2*t140 - t142*x2_1_by_k2 + t143*x1_1_by_k2;
            /* d/dT of: perturbation on the boundary after T */
            const double x2_1_on_boundary_by_y_by_T = carried_x2_1_by_y_by_T + delay_T_by_y*v2_1_by_T + delay_T_by_y_by_T*v2_1;
            const double v1_1_on_boundary_by_u_by_T = -carried_v1_1_by_u_by_T + delay_T_by_u*k1*t130*x1_1_by_T + delay_T_by_u_by_T*t132 - t135*x2_1_by_T;
            const double v2_1_on_boundary_by_w_by_T = carried_v2_1_by_w_by_T + delay_T_by_w_by_T*t140 - t142*x2_1_by_T + t143*x1_1_by_T;
            slope[0][lane] = v1_1_on_boundary_by_u_by_y + v2_1_on_boundary_by_w_by_y + x2_1_on_boundary_by_y_by_y;
            slope[1][lane] = v1_1_on_boundary_by_u_by_u + v2_1_on_boundary_by_w_by_u + x2_1_on_boundary_by_y_by_u;
            slope[2][lane] = v1_1_on_boundary_by_u_by_m1 + v2_1_on_boundary_by_w_by_m1 + x2_1_on_boundary_by_y_by_m1;
            slope[3][lane] = v1_1_on_boundary_by_u_by_m2 + v2_1_on_boundary_by_w_by_m2 + x2_1_on_boundary_by_y_by_m2;
            slope[4][lane] = v1_1_on_boundary_by_u_by_k1 + v2_1_on_boundary_by_w_by_k1 + x2_1_on_boundary_by_y_by_k1;
            slope[5][lane] = v1_1_on_boundary_by_u_by_k2 + v2_1_on_boundary_by_w_by_k2 + x2_1_on_boundary_by_y_by_k2;
            slope[6][lane] = v1_1_on_boundary_by_u_by_T + v2_1_on_boundary_by_w_by_T + x2_1_on_boundary_by_y_by_T;
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
