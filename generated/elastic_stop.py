# Generated; do not edit.
# Source: nonsmooth.derive.systems.elastic_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation 34270e2de36ca60b
"""Kernels and tables of the system elastic-stop, over any arithmetic ``lib``."""

import json

DERIVATION = "34270e2de36ca60b"

SYSTEM = json.loads(r"""{
 "name": "elastic-stop",
 "description": "two coupled oscillators, the first in front of an elastic stop (Sec. 2.2)",
 "states": ["x1", "x2", "v1", "v2"],
 "parameters": [
  {"name": "m1", "description": "first mass, in the user's consistent units", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false},
  {"name": "m2", "description": "second mass", "lower": "0", "upper": null, "closed": false, "upper_closed": false},
  {"name": "k1", "description": "stiffness of the spring between the masses", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false},
  {"name": "k2", "description": "stiffness of the spring between the second mass and the ground", "lower": "0",
   "upper": null, "closed": false, "upper_closed": false},
  {"name": "k3", "description": "stiffness of the stop", "lower": "0", "upper": null, "closed": false,
   "upper_closed": false}
 ],
 "constraints": [],
 "configurations": {
  "contact": [{"name": "first-leaves-stop", "acts_when": "exceeded"}],
  "free": [{"name": "first-reaches-stop", "acts_when": "exceeded"}]
 },
 "spectrum": ["gap1", "omega1", "omega2", "p1", "p2", "p3", "gap2", "omega3", "omega4", "p4", "p5", "p6"],
 "spectrum_parameters": ["m1", "m2", "k1", "k2", "k3"],
 "modes": {
  "contact": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1, "oscillates": true}],
  "free": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1, "oscillates": true}]
 },
 "forcing": [],
 "coordinates": [["x1", "v1"], ["x2", "v2"]],
 "held": {"contact": [], "free": []},
 "constraint_rows": {"contact": [], "free": []},
 "boundary_rows": {"contact": [0], "free": [1]},
 "transitions": [
  {"source": "contact", "boundaries": ["first-leaves-stop"], "conditions": [], "reset": 0, "target": "free"},
  {"source": "free", "boundaries": ["first-reaches-stop"], "conditions": [], "reset": 0, "target": "contact"}
 ],
 "contacts": {"stop": {"forces": {"contact": 2}, "velocity": 3, "surface": 4}}
}""")

ORBITS = json.loads(r"""{
 "one-contact": {
  "derived": true,
  "phases": [["contact", "first-leaves-stop", "tau"], ["free", "first-reaches-stop", "tau1"]],
  "states": ["x1", "x2", "v1", "v2"],
  "parameters": [
   {"name": "m1", "description": "first mass, in the user's consistent units", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "m2", "description": "second mass", "lower": "0", "upper": null, "closed": false, "upper_closed": false},
   {"name": "k1", "description": "stiffness of the spring between the masses", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "k2", "description": "stiffness of the spring between the second mass and the ground", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false},
   {"name": "k3", "description": "stiffness of the stop", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "T", "description": "period of the orbit", "lower": "0", "upper": null, "closed": false, "upper_closed": false}
  ],
  "open_parameters": [],
  "other_parameters": [],
  "combined": {},
  "unknowns": ["y", "u", "w", "tau"],
  "dwell_times": ["tau", "tau1"],
  "durations": [{"tau": 1}, {"T": 1, "tau": -1}],
  "equations": [
   "v1 vanishes halfway through contact",
   "v2 vanishes halfway through contact",
   "v1 vanishes halfway through free",
   "v2 vanishes halfway through free"
  ],
  "reduced": ["tau"],
  "rank": 3,
  "section": ["y", "u", "w"],
  "conservative": true,
  "reciprocal_pair": true,
  "required": {},
  "vanishing": [],
  "levels": {"x1": "1"},
  "resets": [
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]]
  ],
  "measures": ["y", "u", "w"],
  "terms": [2, 2],
  "boundaries": [[0, "first-leaves-stop", null, 0.0, true], [1, "first-reaches-stop", null, 0.0, true]],
  "reference": {
   "parameters": {"m1": "1", "m2": "2", "k1": "1", "k2": "5", "k3": "1", "T": "2*pi"},
   "guess": {"y": "0.42", "u": "3.66", "w": "0.59", "tau": "2.12"}
  }
 }
}""")

KERNELS = json.loads(r"""{
 "spectrum": [[[[5], 0]], [["spectrum", [12]], ["spectrum_derivatives", [12, 5]]]],
 "flow_contact": [[[[5], 0], [[12], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_free": [[[[5], 0], [[12], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "fields": [[[[5], 0]], [["fields", [8, 5]]]],
 "rows": [[[[5], 0]], [["rows", [5, 5]]]],
 "resets": [[[[5], 0]], [["resets", [4, 5]]]],
 "modes": [[[[5], 0], [[12], 0]], [["exponents", [6, 2]], ["coefficients", [40, 5]]]],
 "one_contact_equations": [[[[6], 0], [[12], 0], [[4], 0], [[12, 5], 2]], [["residual", [4]], ["jacobian", [4, 4]],
  ["parameter_jacobian", [4, 6]]]],
 "one_contact_trace": [[[[6], 0], [[12], 0], [[4], 0], [[12, 5], 1]], [["trace", []], ["trace_gradient", [10]]]],
 "one_contact_passage": [[[[6], 0], [[12], 0], [[4], 0]], [["states", [3, 4]], ["coefficients", [12]], ["frequencies",
  [4]]]],
 "one_contact_linearisation": [[[[6], 0], [[12], 0], [[4], 0]], [["poincare_jacobian", [3, 3]], ["saltations", [8, 4]],
  ["monodromy", [4, 4]]]],
 "one_contact_reduced": [[[[6], 0], [[12], 0], [[1], 0]], [["unknowns", [4]], ["determinants", [1]],
  ["reduced_residual", [1]], ["reduced_jacobian", [1, 1]]]]
}""")

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives spectrum (12).
    Gives spectrum_derivatives (12, 5).
    Operations: 308. Intermediate terms: 146.
    """
    [m1, m2, k1, k2, k3] = parameters
    # spectrum
    t0 = 1/m1
    t1 = k1 + k3
    t2 = t0*t1
    t3 = 1/m2
    t4 = k1 + k2
    t5 = t3*t4
    t6 = t2 - t5
    t7 = k1**2
    t8 = 4*t3*t7
    t9 = t0*t8
    gap1 = lib.sqrt(t6**2 + t9)
    t10 = t5/2
    omega1 = lib.sqrt(gap1/2 + t10 + t2/2)
    t11 = 1/omega1
    t12 = lib.sqrt(k1*k2 + k1*k3 + k2*k3)
    t13 = 1/lib.sqrt(m2)
    t14 = 1/lib.sqrt(m1)
    t15 = t13*t14
    t16 = t12*t15
    omega2 = t11*t16
    t17 = 1/gap1
    t18 = t17/2
    p1 = t18*t6 + lib.rational(1, 2)
    t19 = k1*t0
    p2 = -t17*t19
    t20 = t17*t3
    p3 = -k1*t20
    t21 = t19 - t5
    gap2 = lib.sqrt(t21**2 + t9)
    omega3 = lib.sqrt(gap2/2 + t10 + t19/2)
    t22 = 1/omega3
    t23 = lib.sqrt(k2)
    t24 = lib.sqrt(k1)
    t25 = t23*t24
    t26 = t15*t25
    omega4 = t22*t26
    t27 = 1/gap2
    t28 = t27/2
    p4 = t21*t28 + lib.rational(1, 2)
    p5 = -t19*t27
    t29 = t27*t3
    p6 = -k1*t29
    spectrum = [gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6]
    if outputs == 1:
        return spectrum
    # d/dm1 of: spectrum
    t30 = 1/m1**2
    t31 = t1*t30
    t32 = t30*t8
    gap1_by_m1 = t18*(-2*t31*t6 - t32)
    t33 = gap1_by_m1/2
    t34 = t11/2
    omega1_by_m1 = t34*(-t31/2 + t33)
    t35 = t12*t34
    t36 = t13/lib.sqrt(m1)**3
    t37 = t16/omega1**2
    omega2_by_m1 = -omega1_by_m1*t37 - t35*t36
    t38 = 1/gap1**2
    t39 = t38*t6
    p1_by_m1 = -t18*t31 - t33*t39
    t40 = k1*t30
    t41 = gap1_by_m1*t38
    p2_by_m1 = t17*t40 + t19*t41
    t42 = k1*t3
    p3_by_m1 = t41*t42
    gap2_by_m1 = t28*(-2*t21*t40 - t32)
    t43 = k1/2
    t44 = t30*t43
    t45 = t22/2
    omega3_by_m1 = t45*(gap2_by_m1/2 - t44)
    t46 = t25*t45
    t47 = t26/omega3**2
    omega4_by_m1 = -omega3_by_m1*t47 - t36*t46
    t48 = 1/gap2**2
    t49 = t21*t48
    p4_by_m1 = -gap2_by_m1*t49/2 - t27*t44
    t50 = gap2_by_m1*t48
    p5_by_m1 = t19*t50 + t27*t40
    p6_by_m1 = t42*t50
    # d/dm2 of: spectrum
    t51 = 1/m2**2
    t52 = 4*t0*t51*t7
    gap1_by_m2 = t18*(2*t4*t51*t6 - t52)
    t53 = gap1_by_m2/2
    t54 = -t4*t51/2
    omega1_by_m2 = t34*(t53 + t54)
    t55 = t14/lib.sqrt(m2)**3
    omega2_by_m2 = -omega1_by_m2*t37 - t35*t55
    p1_by_m2 = t17*t4*t51/2 - t39*t53
    t56 = gap1_by_m2*t38
    p2_by_m2 = t19*t56
    t57 = k1*t51
    p3_by_m2 = t17*t57 + t42*t56
    gap2_by_m2 = t28*(2*t21*t4*t51 - t52)
    t58 = gap2_by_m2/2
    omega3_by_m2 = t45*(t54 + t58)
    omega4_by_m2 = -omega3_by_m2*t47 - t46*t55
    p4_by_m2 = t27*t4*t51/2 - t49*t58
    t59 = gap2_by_m2*t48
    p5_by_m2 = t19*t59
    p6_by_m2 = t27*t57 + t42*t59
    # d/dk1 of: spectrum
    t60 = 2*t0 - 2*t3
    t61 = 8*t19*t3
    gap1_by_k1 = t18*(t6*t60 + t61)
    t62 = gap1_by_k1/2
    t63 = t3/2
    t64 = t0/2
    t65 = t63 + t64
    omega1_by_k1 = t34*(t62 + t65)
    t66 = k3/2
    t67 = k2/2
    t68 = t11*t15/t12
    omega2_by_k1 = -omega1_by_k1*t37 + t68*(t66 + t67)
    t69 = t0 - t3
    p1_by_k1 = t18*t69 - t39*t62
    t70 = t0*t17
    t71 = gap1_by_k1*t38
    p2_by_k1 = t19*t71 - t70
    p3_by_k1 = -t20 + t42*t71
    gap2_by_k1 = t28*(t21*t60 + t61)
    t72 = gap2_by_k1/2
    omega3_by_k1 = t45*(t65 + t72)
    omega4_by_k1 = -omega3_by_k1*t47 + t13*t14*t22*t23/(2*t24)
    p4_by_k1 = t28*t69 - t49*t72
    t73 = gap2_by_k1*t48
    p5_by_k1 = -t0*t27 + t19*t73
    p6_by_k1 = -t29 + t42*t73
    # d/dk2 of: spectrum
    gap1_by_k2 = -t20*t6
    t74 = gap1_by_k2/2
    omega1_by_k2 = t34*(t63 + t74)
    omega2_by_k2 = -omega1_by_k2*t37 + t68*(t43 + t66)
    p1_by_k2 = -t17*t63 - t39*t74
    t75 = gap1_by_k2*t38
    p2_by_k2 = t19*t75
    p3_by_k2 = t42*t75
    gap2_by_k2 = -t21*t29
    t76 = gap2_by_k2/2
    omega3_by_k2 = t45*(t63 + t76)
    omega4_by_k2 = -omega3_by_k2*t47 + t13*t14*t22*t24/(2*t23)
    p4_by_k2 = -t27*t63 - t49*t76
    t77 = gap2_by_k2*t48
    p5_by_k2 = t19*t77
    p6_by_k2 = t42*t77
    # d/dk3 of: spectrum
    gap1_by_k3 = t6*t70
    t78 = gap1_by_k3/2
    omega1_by_k3 = t34*(t64 + t78)
    omega2_by_k3 = -omega1_by_k3*t37 + t68*(t43 + t67)
    p1_by_k3 = t0*t17/2 - t39*t78
    t79 = gap1_by_k3*t38
    p2_by_k3 = t19*t79
    p3_by_k3 = t42*t79
    spectrum_derivatives = [[gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2, gap1_by_k3], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2, omega2_by_k3], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2, p1_by_k3], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2, p2_by_k3], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, p3_by_k3], [gap2_by_m1, gap2_by_m2, gap2_by_k1, gap2_by_k2, 0], [omega3_by_m1, omega3_by_m2, omega3_by_k1, omega3_by_k2, 0], [omega4_by_m1, omega4_by_m2, omega4_by_k1, omega4_by_k2, 0], [p4_by_m1, p4_by_m2, p4_by_k1, p4_by_k2, 0], [p5_by_m1, p5_by_m2, p5_by_k1, p5_by_k2, 0], [p6_by_m1, p6_by_m2, p6_by_k1, p6_by_k2, 0]]
    return spectrum, spectrum_derivatives


def flow_contact(parameters, spectrum, time, state, *, lib):
    """State after a time in contact.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 128. Intermediate terms: 24.
    """
    [_, _, k1, k2, k3] = parameters
    [_, omega1, omega2, p1, p2, p3, _, _, _, _, _, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = p1 - 1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 - t6*t7
    t11 = k1*k3
    t12 = k2*k3 + t11
    t13 = 1/(k1*k2 + t12)
    t14 = t12*t13
    t15 = t11*t13
    t16 = p2*t15
    t17 = p1*t14
    t18 = p1*t7 - t6*t8
    t19 = -p3*t7 + p3*t8
    t20 = p3*t14
    t21 = p1*t15
    t22 = omega2*t4
    t23 = omega1*t1
    return [t10*x1 + t14 + t7*(t14*t6 + t16) + t8*(-t16 - t17) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5), t15 + t18*x2 + t19*x1 + t7*(t20 - t21) + t8*(t15*t6 - t20) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6), t1*(omega1*t16 + omega1*t17) + t10*v1 + t4*(-omega2*t12*t13*t6 - omega2*t16) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23), t1*(-omega1*t15*t6 + omega1*t20) + t18*v2 + t19*v1 + t4*(-omega2*t20 + omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6)]


def flow_free(parameters, spectrum, time, state, *, lib):
    """State after a time in free.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 77. Intermediate terms: 15.
    """
    [_, _, _, _, _, _, _, omega3, omega4, p4, p5, p6] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega3*time
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = omega4*time
    t4 = lib.sin(t3)
    t5 = t4/omega4
    t6 = 1 - p4
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p5*t7 + p5*t8
    t10 = p4*t8 + t6*t7
    t11 = p4*t7 + t6*t8
    t12 = -p6*t7 + p6*t8
    t13 = omega4*t4
    t14 = omega3*t1
    return [t10*x1 + t9*x2 + v1*(p4*t2 + t5*t6) + v2*(p5*t2 - p5*t5), t11*x2 + t12*x1 + v1*(p6*t2 - p6*t5) + v2*(p4*t5 + t2*t6), t10*v1 + t9*v2 + x1*(-p4*t14 - t13*t6) + x2*(p5*t13 - p5*t14), t11*v2 + t12*v1 + x1*(p6*t13 - p6*t14) + x2*(-p4*t13 - t14*t6)]


def fields(parameters, *, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives fields (8, 5).
    Operations: 12. Intermediate terms: 5.
    """
    [m1, m2, k1, k2, k3] = parameters
    # fields
    t0 = 1/m1
    t1 = k1*t0
    t2 = 1/m2
    t3 = k1*t2
    t4 = -t2*(k1 + k2)
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t0*(k1 + k3), t1, 0, 0, k3*t0], [t3, t4, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t1, t1, 0, 0, 0], [t3, t4, 0, 0, 0]]


def rows(parameters, *, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives rows (5, 5).
    Operations: 3. Intermediate terms: 0.
    """
    [_, _, _, _, k3] = parameters
    return [[-1, 0, 0, 0, 1], [1, 0, 0, 0, -1], [-k3, 0, 0, 0, k3], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0]]


def resets(parameters, *, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives resets (4, 5).
    Operations: 0. Intermediate terms: 0.
    """
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0]]


def modes(parameters, spectrum, *, lib, outputs=2):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Gives exponents (6, 2).
    Gives coefficients (40, 5).
    Operations: 104. Intermediate terms: 20.
    """
    [_, _, k1, k2, k3] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    exponents = [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3], [0, omega4]]
    if outputs == 1:
        return exponents
    # coefficients
    t0 = k1*k3
    t1 = k2*k3 + t0
    t2 = 1/(k1*k2 + t1)
    t3 = t1*t2
    t4 = t0*t2
    t5 = p2*t4
    t6 = p1 - 1
    t7 = -p3*t3
    t8 = 1/omega1
    t9 = omega1*p1
    t10 = omega1*p2
    t11 = omega1*p3
    t12 = -omega1*t6
    t13 = 1/omega2
    t14 = omega2*p2
    t15 = omega2*p3
    t16 = omega2*p1
    t17 = 1 - p4
    t18 = 1/omega3
    t19 = 1/omega4
    coefficients = [[0, 0, 0, 0, t3], [0, 0, 0, 0, t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t3 - t5], [p3, -t6, 0, 0, t4*t6 + t7], [0, 0, p1, p2, 0], [0, 0, p3, -t6, 0], [0, 0, p1*t8, p2*t8, 0], [0, 0, p3*t8, -t6*t8, 0], [-t9, -t10, 0, 0, t10*t4 + t3*t9], [-t11, -t12, 0, 0, t11*t3 + t12*t4], [-t6, -p2, 0, 0, t3*t6 + t5], [-p3, p1, 0, 0, -p1*t4 - t7], [0, 0, -t6, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, -t13*t6, -p2*t13, 0], [0, 0, -p3*t13, p1*t13, 0], [omega2*t6, t14, 0, 0, -omega2*t1*t2*t6 - t14*t4], [t15, -t16, 0, 0, -t15*t3 + t16*t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p4, p5, 0, 0, 0], [p6, t17, 0, 0, 0], [0, 0, p4, p5, 0], [0, 0, p6, t17, 0], [0, 0, p4*t18, p5*t18, 0], [0, 0, p6*t18, t17*t18, 0], [-omega3*p4, -omega3*p5, 0, 0, 0], [-omega3*p6, -omega3*t17, 0, 0, 0], [t17, -p5, 0, 0, 0], [-p6, p4, 0, 0, 0], [0, 0, t17, -p5, 0], [0, 0, -p6, p4, 0], [0, 0, t17*t19, -p5*t19, 0], [0, 0, -p6*t19, p4*t19, 0], [-omega4*t17, omega4*p5, 0, 0, 0], [omega4*p6, -omega4*p4, 0, 0, 0]]
    return exponents, coefficients


def one_contact_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Takes spectrum_derivatives (12, 5): gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2,
        gap1_by_k3, omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3,
        omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2, omega2_by_k3, p1_by_m1,
        p1_by_m2, p1_by_k1, p1_by_k2, p1_by_k3, p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2,
        p2_by_k3, p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, gap2_by_m1, gap2_by_m2,
        gap2_by_k1, gap2_by_k2, gap2_by_k3, omega3_by_m1, omega3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_k3, omega4_by_m1, omega4_by_m2, omega4_by_k1, omega4_by_k2,
        omega4_by_k3, p4_by_m1, p4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p5_by_m1, p5_by_m2,
        p5_by_k1, p5_by_k2, p5_by_k3, p6_by_m1, p6_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, for
        parameter_jacobian.
    Gives residual (4).
    Gives jacobian (4, 4).
    Gives parameter_jacobian (4, 6).
    Operations: 774. Intermediate terms: 185.
    """
    [_, _, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [y, u, w, tau] = unknowns
    # half of tau
    half_tau = tau/2
    # functions of half_tau in contact
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t1 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t1)
    sin_omega2_half_tau = lib.sin(t1)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t2 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t2)
    sin_omega3_half_tau1 = lib.sin(t2)
    t3 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t3)
    sin_omega4_half_tau1 = lib.sin(t3)
    # residual
    t4 = p1*u + p2*w
    t5 = -t4 + u
    t6 = k1*k2
    t7 = p1*t6
    t8 = k1*k3
    t9 = p2*t8
    t10 = k2*k3
    t11 = t10*y
    t12 = t6*y
    t13 = p2*t11 + p2*t12 + t7 + t9*y - t9
    t14 = t13 - t6
    t15 = t10 + t6 + t8
    t16 = 1/t15
    t17 = omega2*t16
    t18 = sin_omega2_half_tau*t17
    t19 = omega1*t16
    t20 = sin_omega1_half_tau*t19
    t21 = -p1*w + p3*u
    t22 = t21 + w
    t23 = p1*t8
    t24 = p3*t6
    t25 = t11 + t12 + t8*y - t8
    t26 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t23 - t24 - t25
    t27 = p1*t11 + t23*y - t23 - t24 + t7*y
    t28 = p4*u + p5*w
    t29 = t28 - u
    t30 = p4 + p5*y
    t31 = t30 - 1
    t32 = omega4*sin_omega4_half_tau1
    t33 = omega3*sin_omega3_half_tau1
    t34 = -p4*w + p6*u
    t35 = -t34 - w
    t36 = -p4*y + p6
    t37 = -t36 - y
    residual = [cos_omega1_half_tau*t4 + cos_omega2_half_tau*t5 - t13*t20 + t14*t18, cos_omega1_half_tau*t22 - cos_omega2_half_tau*t21 - t18*t27 + t20*t26, -cos_omega3_half_tau1*t28 + cos_omega4_half_tau1*t29 - t30*t33 + t31*t32, cos_omega3_half_tau1*t35 + cos_omega4_half_tau1*t34 + t32*t36 + t33*t37]
    if outputs == 1:
        return residual
    # d/dtau of: functions of half_tau in contact
    t38 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t38
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t38
    t39 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t39
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t39
    # d/dtau of: functions of half_tau1 in free
    t40 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t40
    sin_omega3_half_tau1_by_T = cos_omega3_half_tau1*t40
    sin_omega3_half_tau1_by_tau = -sin_omega3_half_tau1_by_T
    t41 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t41
    sin_omega4_half_tau1_by_T = cos_omega4_half_tau1*t41
    sin_omega4_half_tau1_by_tau = -sin_omega4_half_tau1_by_T
    # jacobian
    t42 = p2*t10 + p2*t6 + t9
    t43 = 1 - p1
    t44 = sin_omega2_half_tau_by_tau*t17
    t45 = sin_omega1_half_tau_by_tau*t19
    t46 = p1*t10 + t23 + t7
    t47 = p4 - 1
    t48 = omega4*sin_omega4_half_tau1_by_tau
    t49 = omega3*sin_omega3_half_tau1_by_tau
    jacobian = [[t18*t42 - t20*t42, cos_omega1_half_tau*p1 + cos_omega2_half_tau*t43, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, cos_omega1_half_tau_by_tau*t4 + cos_omega2_half_tau_by_tau*t5 - t13*t45 + t14*t44], [omega1*sin_omega1_half_tau*t16*(-t10 + t46 - t6 - t8) - t18*t46, cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, cos_omega1_half_tau*t43 + cos_omega2_half_tau*p1, cos_omega1_half_tau_by_tau*t22 - cos_omega2_half_tau_by_tau*t21 + t26*t45 - t27*t44], [p5*t32 - p5*t33, -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t47, -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5, -cos_omega3_half_tau1_by_tau*t28 + cos_omega4_half_tau1_by_tau*t29 - t30*t49 + t31*t48], [omega3*sin_omega3_half_tau1*t47 - p4*t32, -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6, cos_omega3_half_tau1*t47 - cos_omega4_half_tau1*p4, cos_omega3_half_tau1_by_tau*t35 + cos_omega4_half_tau1_by_tau*t34 + t36*t48 + t37*t49]]
    if outputs == 2:
        return residual, jacobian
    [[_, _, _, _, _], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2, omega2_by_k3], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2, p1_by_k3], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2, p2_by_k3], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, p3_by_k3], [_, _, _, _, _], [omega3_by_m1, omega3_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3], [omega4_by_m1, omega4_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3], [p4_by_m1, p4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3], [p5_by_m1, p5_by_m2, p5_by_k1, p5_by_k2, p5_by_k3], [p6_by_m1, p6_by_m2, p6_by_k1, p6_by_k2, p6_by_k3]] = spectrum_derivatives
    # d/dm1 of: functions of half_tau in contact
    t50 = half_tau*omega1_by_m1
    cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t50
    sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t50
    t51 = half_tau*omega2_by_m1
    cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t51
    sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t51
    # d/dm2 of: functions of half_tau in contact
    t52 = half_tau*omega1_by_m2
    cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t52
    sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t52
    t53 = half_tau*omega2_by_m2
    cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t53
    sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t53
    # d/dk1 of: functions of half_tau in contact
    t54 = half_tau*omega1_by_k1
    cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t54
    sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t54
    t55 = half_tau*omega2_by_k1
    cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t55
    sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t55
    # d/dk2 of: functions of half_tau in contact
    t56 = half_tau*omega1_by_k2
    cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t56
    sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t56
    t57 = half_tau*omega2_by_k2
    cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t57
    sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t57
    # d/dk3 of: functions of half_tau in contact
    t58 = half_tau*omega1_by_k3
    cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t58
    sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t58
    t59 = half_tau*omega2_by_k3
    cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t59
    sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t59
    # d/dm1 of: functions of half_tau1 in free
    t60 = half_tau1*omega3_by_m1
    cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t60
    sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t60
    t61 = half_tau1*omega4_by_m1
    cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t61
    sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t61
    # d/dm2 of: functions of half_tau1 in free
    t62 = half_tau1*omega3_by_m2
    cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t62
    sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t62
    t63 = half_tau1*omega4_by_m2
    cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t63
    sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t63
    # d/dk1 of: functions of half_tau1 in free
    t64 = half_tau1*omega3_by_k1
    cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t64
    sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t64
    t65 = half_tau1*omega4_by_k1
    cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t65
    sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t65
    # d/dk2 of: functions of half_tau1 in free
    t66 = half_tau1*omega3_by_k2
    cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t66
    sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t66
    t67 = half_tau1*omega4_by_k2
    cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t67
    sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t67
    # d/dk3 of: functions of half_tau1 in free
    t68 = half_tau1*omega3_by_k3
    cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t68
    sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t68
    t69 = half_tau1*omega4_by_k3
    cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t69
    sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t69
    # d/dT of: functions of half_tau1 in free
    cos_omega3_half_tau1_by_T = -cos_omega3_half_tau1_by_tau
    cos_omega4_half_tau1_by_T = -cos_omega4_half_tau1_by_tau
    # parameter_jacobian
    t70 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t18*t25 - t20*t25
    t71 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t18*t6 - t20*t6
    t72 = sin_omega2_half_tau*t16
    t73 = t14*t72
    t74 = t14*t17
    t75 = sin_omega1_half_tau*t16
    t76 = t13*t75
    t77 = t13*t19
    t78 = k2*p1
    t79 = k3*p2
    t80 = t79*y
    t81 = k2*y
    t82 = p2*t81
    t83 = t78 - t79 + t80 + t82
    t84 = 1/t15**2
    t85 = t84*(-k2 - k3)
    t86 = omega2*sin_omega2_half_tau
    t87 = t14*t86
    t88 = omega1*sin_omega1_half_tau
    t89 = t13*t88
    t90 = k1*p1
    t91 = k1*p2
    t92 = t91*y
    t93 = t80 + t90 + t92
    t94 = t84*(-k1 - k3)
    t95 = t82 - t91 + t92
    t96 = t84*(-k1 - k2)
    t97 = t26*t75
    t98 = t19*t26
    t99 = t27*t72
    t100 = t17*t27
    t101 = k2*p3
    t102 = k3*p1
    t103 = -k3*p1*y + k3*y
    t104 = t102*y
    t105 = t78*y
    t106 = t26*t88
    t107 = t27*t86
    t108 = k1*p3
    t109 = k1*y
    t110 = t90*y
    t111 = t105 + t110 - t90
    t112 = -cos_omega3_half_tau1*w + cos_omega4_half_tau1*w + t32*y - t33*y
    t113 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + t32 - t33
    t114 = sin_omega4_half_tau1*t31
    t115 = omega4*t31
    t116 = sin_omega3_half_tau1*t30
    t117 = omega3*t30
    t118 = sin_omega3_half_tau1*t37
    t119 = omega3*t37
    t120 = -sin_omega4_half_tau1*t36
    t121 = -omega4*t36
    parameter_jacobian = [[cos_omega1_half_tau_by_m1*t4 + cos_omega2_half_tau_by_m1*t5 - omega1_by_m1*t76 + omega2_by_m1*t73 + p1_by_m1*t71 + p2_by_m1*t70 - sin_omega1_half_tau_by_m1*t77 + sin_omega2_half_tau_by_m1*t74, cos_omega1_half_tau_by_m2*t4 + cos_omega2_half_tau_by_m2*t5 - omega1_by_m2*t76 + omega2_by_m2*t73 + p1_by_m2*t71 + p2_by_m2*t70 - sin_omega1_half_tau_by_m2*t77 + sin_omega2_half_tau_by_m2*t74, cos_omega1_half_tau_by_k1*t4 + cos_omega2_half_tau_by_k1*t5 - omega1_by_k1*t76 + omega2_by_k1*t73 + p1_by_k1*t71 + p2_by_k1*t70 - sin_omega1_half_tau_by_k1*t77 + sin_omega2_half_tau_by_k1*t74 + t18*(-k2 + t83) - t20*t83 + t85*t87 - t85*t89, cos_omega1_half_tau_by_k2*t4 + cos_omega2_half_tau_by_k2*t5 - omega1_by_k2*t76 + omega2_by_k2*t73 + p1_by_k2*t71 + p2_by_k2*t70 - sin_omega1_half_tau_by_k2*t77 + sin_omega2_half_tau_by_k2*t74 + t18*(-k1 + t93) - t20*t93 + t87*t94 - t89*t94, cos_omega1_half_tau_by_k3*t4 + cos_omega2_half_tau_by_k3*t5 - omega1_by_k3*t76 + omega2_by_k3*t73 + p1_by_k3*t71 + p2_by_k3*t70 - sin_omega1_half_tau_by_k3*t77 + sin_omega2_half_tau_by_k3*t74 + t18*t95 - t20*t95 + t87*t96 - t89*t96, 0], [cos_omega1_half_tau_by_m1*t22 - cos_omega2_half_tau_by_m1*t21 + omega1_by_m1*t97 - omega2_by_m1*t99 - p1_by_m1*t70 + p3_by_m1*t71 + sin_omega1_half_tau_by_m1*t98 - sin_omega2_half_tau_by_m1*t100, cos_omega1_half_tau_by_m2*t22 - cos_omega2_half_tau_by_m2*t21 + omega1_by_m2*t97 - omega2_by_m2*t99 - p1_by_m2*t70 + p3_by_m2*t71 + sin_omega1_half_tau_by_m2*t98 - sin_omega2_half_tau_by_m2*t100, cos_omega1_half_tau_by_k1*t22 - cos_omega2_half_tau_by_k1*t21 + omega1_by_k1*t97 - omega2_by_k1*t99 - p1_by_k1*t70 + p3_by_k1*t71 + sin_omega1_half_tau_by_k1*t98 - sin_omega2_half_tau_by_k1*t100 + t106*t85 - t107*t85 - t18*(-t101 - t102 + t104 + t105) + t20*(k2*p1*y + k3 - t101 - t102 - t103 - t81), cos_omega1_half_tau_by_k2*t22 - cos_omega2_half_tau_by_k2*t21 + omega1_by_k2*t97 - omega2_by_k2*t99 - p1_by_k2*t70 + p3_by_k2*t71 + sin_omega1_half_tau_by_k2*t98 - sin_omega2_half_tau_by_k2*t100 + t106*t94 - t107*t94 - t18*(t104 - t108 + t110) + t20*(k1*p1*y - t103 - t108 - t109), cos_omega1_half_tau_by_k3*t22 - cos_omega2_half_tau_by_k3*t21 + omega1_by_k3*t97 - omega2_by_k3*t99 - p1_by_k3*t70 + p3_by_k3*t71 + sin_omega1_half_tau_by_k3*t98 - sin_omega2_half_tau_by_k3*t100 + t106*t96 - t107*t96 - t111*t18 + t20*(k1 - t109 + t111 - t81), 0], [-cos_omega3_half_tau1_by_m1*t28 + cos_omega4_half_tau1_by_m1*t29 - omega3_by_m1*t116 + omega4_by_m1*t114 + p4_by_m1*t113 + p5_by_m1*t112 - sin_omega3_half_tau1_by_m1*t117 + sin_omega4_half_tau1_by_m1*t115, -cos_omega3_half_tau1_by_m2*t28 + cos_omega4_half_tau1_by_m2*t29 - omega3_by_m2*t116 + omega4_by_m2*t114 + p4_by_m2*t113 + p5_by_m2*t112 - sin_omega3_half_tau1_by_m2*t117 + sin_omega4_half_tau1_by_m2*t115, -cos_omega3_half_tau1_by_k1*t28 + cos_omega4_half_tau1_by_k1*t29 - omega3_by_k1*t116 + omega4_by_k1*t114 + p4_by_k1*t113 + p5_by_k1*t112 - sin_omega3_half_tau1_by_k1*t117 + sin_omega4_half_tau1_by_k1*t115, -cos_omega3_half_tau1_by_k2*t28 + cos_omega4_half_tau1_by_k2*t29 - omega3_by_k2*t116 + omega4_by_k2*t114 + p4_by_k2*t113 + p5_by_k2*t112 - sin_omega3_half_tau1_by_k2*t117 + sin_omega4_half_tau1_by_k2*t115, -cos_omega3_half_tau1_by_k3*t28 + cos_omega4_half_tau1_by_k3*t29 - omega3_by_k3*t116 + omega4_by_k3*t114 + p4_by_k3*t113 + p5_by_k3*t112 - sin_omega3_half_tau1_by_k3*t117 + sin_omega4_half_tau1_by_k3*t115, -cos_omega3_half_tau1_by_T*t28 + cos_omega4_half_tau1_by_T*t29 - sin_omega3_half_tau1_by_T*t117 + sin_omega4_half_tau1_by_T*t115], [cos_omega3_half_tau1_by_m1*t35 + cos_omega4_half_tau1_by_m1*t34 + omega3_by_m1*t118 - omega4_by_m1*t120 - p4_by_m1*t112 + p6_by_m1*t113 + sin_omega3_half_tau1_by_m1*t119 - sin_omega4_half_tau1_by_m1*t121, cos_omega3_half_tau1_by_m2*t35 + cos_omega4_half_tau1_by_m2*t34 + omega3_by_m2*t118 - omega4_by_m2*t120 - p4_by_m2*t112 + p6_by_m2*t113 + sin_omega3_half_tau1_by_m2*t119 - sin_omega4_half_tau1_by_m2*t121, cos_omega3_half_tau1_by_k1*t35 + cos_omega4_half_tau1_by_k1*t34 + omega3_by_k1*t118 - omega4_by_k1*t120 - p4_by_k1*t112 + p6_by_k1*t113 + sin_omega3_half_tau1_by_k1*t119 - sin_omega4_half_tau1_by_k1*t121, cos_omega3_half_tau1_by_k2*t35 + cos_omega4_half_tau1_by_k2*t34 + omega3_by_k2*t118 - omega4_by_k2*t120 - p4_by_k2*t112 + p6_by_k2*t113 + sin_omega3_half_tau1_by_k2*t119 - sin_omega4_half_tau1_by_k2*t121, cos_omega3_half_tau1_by_k3*t35 + cos_omega4_half_tau1_by_k3*t34 + omega3_by_k3*t118 - omega4_by_k3*t120 - p4_by_k3*t112 + p6_by_k3*t113 + sin_omega3_half_tau1_by_k3*t119 - sin_omega4_half_tau1_by_k3*t121, cos_omega3_half_tau1_by_T*t35 + cos_omega4_half_tau1_by_T*t34 + sin_omega3_half_tau1_by_T*t119 - sin_omega4_half_tau1_by_T*t121]]
    return residual, jacobian, parameter_jacobian


def one_contact_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Takes spectrum_derivatives (12, 5): gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2,
        gap1_by_k3, omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3,
        omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2, omega2_by_k3, p1_by_m1,
        p1_by_m2, p1_by_k1, p1_by_k2, p1_by_k3, p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2,
        p2_by_k3, p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, gap2_by_m1, gap2_by_m2,
        gap2_by_k1, gap2_by_k2, gap2_by_k3, omega3_by_m1, omega3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_k3, omega4_by_m1, omega4_by_m2, omega4_by_k1, omega4_by_k2,
        omega4_by_k3, p4_by_m1, p4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p5_by_m1, p5_by_m2,
        p5_by_k1, p5_by_k2, p5_by_k3, p6_by_m1, p6_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, for
        trace_gradient.
    Gives trace.
    Gives trace_gradient (10).
    Operations: 1654. Intermediate terms: 308.
    """
    [m1, m2, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [y, u, w, tau] = unknowns
    # functions of tau in contact
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t1 = omega2*tau
    cos_omega2_tau = lib.cos(t1)
    sin_omega2_tau = lib.sin(t1)
    # contact for tau, until first-leaves-stop
    t2 = 1/omega1
    t3 = sin_omega1_tau*t2
    t4 = 1/omega2
    t5 = sin_omega2_tau*t4
    carried_x1_1_by_w = p2*t3 - p2*t5
    t6 = p1 - 1
    carried_x1_1_by_u = p1*t3 - t5*t6
    carried_x1_1_by_y = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t7 = k1*k3
    t8 = k2*k3 + t7
    t9 = k1*k2 + t8
    t10 = 1/t9
    t11 = t10*t8
    t12 = t10*t7
    t13 = p2*t12
    t14 = p1*t11 + t13
    t15 = t11*t6 + t13
    carried_v1_1_by_u = cos_omega1_tau*p1 - cos_omega2_tau*t6
    x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_w*w + carried_x1_1_by_y*y - cos_omega1_tau*t14 + cos_omega2_tau*t15 + t11
    carried_x2_1_by_w = p1*t5 - t3*t6
    carried_x2_1_by_u = p3*t3 - p3*t5
    carried_x2_1_by_y = -cos_omega1_tau*t6 + cos_omega2_tau*p1
    t16 = p3*t11
    t17 = t12*t6 - t16
    t18 = p1*t12
    t19 = -t16 + t18
    carried_v2_1_by_u = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_w*w + carried_x2_1_by_y*y + cos_omega1_tau*t17 - cos_omega2_tau*t19 + t12
    t20 = omega2*sin_omega2_tau
    t21 = omega1*sin_omega1_tau
    carried_v1_1_by_y = p2*t20 - p2*t21
    t22 = omega1*p1
    t23 = omega1*t13 + t11*t22
    t24 = omega2*t10*t6*t8 + omega2*t13
    t25 = -omega2*t6
    v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y + carried_x1_1_by_y*w - sin_omega1_tau*t22 + sin_omega1_tau*t23 - sin_omega2_tau*t24 - sin_omega2_tau*t25
    carried_v2_1_by_y = -p1*t20 + t21*t6
    t26 = omega1*p3
    t27 = -t12*t6
    t28 = omega1*t27 + t11*t26
    t29 = omega2*p3
    t30 = omega2*t18 - t11*t29
    v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + carried_x2_1_by_y*w - sin_omega1_tau*t26 + sin_omega1_tau*t28 + sin_omega2_tau*t29 + sin_omega2_tau*t30
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t31 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t31)
    sin_omega3_tau1 = lib.sin(t31)
    t32 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t32)
    sin_omega4_tau1 = lib.sin(t32)
    # free for tau1, until first-reaches-stop
    t33 = 1 - p4
    t34 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33
    t35 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    t36 = 1/omega3
    t37 = sin_omega3_tau1*t36
    t38 = 1/omega4
    t39 = sin_omega4_tau1*t38
    t40 = p4*t37 + t33*t39
    t41 = p5*t37 - p5*t39
    x1_2 = t34*x1_1 + t35*x2_1 + t40*v1_1 + t41*v2_1
    t42 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t43 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4
    t44 = p6*t37 - p6*t39
    t45 = p4*t39 + t33*t37
    x2_2 = t42*x1_1 + t43*x2_1 + t44*v1_1 + t45*v2_1
    t46 = omega3*sin_omega3_tau1
    t47 = omega4*sin_omega4_tau1
    t48 = p4*t46 + t33*t47
    t49 = -p5*t46 + p5*t47
    v1_2 = t34*v1_1 + t35*v2_1 - t48*x1_1 + t49*x2_1
    t50 = -p6*t46 + p6*t47
    t51 = p4*t47 + t33*t46
    v2_2 = t42*v1_1 + t43*v2_1 + t50*x1_1 - t51*x2_1
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t52 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t52
    delay_tau_by_u = carried_x1_1_by_u*t52
    delay_tau_by_w = carried_x1_1_by_w*t52
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t53 = 1/m1
    t54 = k1 + k3
    t55 = t53*x1_1
    t56 = k1*t53*x2_1 + k3*t53 - t54*t55
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t56
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t56
    v1_1_on_boundary_by_w = carried_x1_1_by_y + delay_tau_by_w*t56
    t57 = 1/m2
    t58 = t57*x1_1
    t59 = k1 + k2
    t60 = t57*x2_1
    t61 = k1*t58 - t59*t60
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t61
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t61
    v2_1_on_boundary_by_w = carried_x2_1_by_y + delay_tau_by_w*t61
    # Phi along tau1
    carried_x1_2_by_y = t34*x1_1_on_boundary_by_y + t35*x2_1_on_boundary_by_y + t40*v1_1_on_boundary_by_y + t41*v2_1_on_boundary_by_y
    carried_x1_2_by_u = t34*x1_1_on_boundary_by_u + t35*x2_1_on_boundary_by_u + t40*v1_1_on_boundary_by_u + t41*v2_1_on_boundary_by_u
    carried_x1_2_by_w = t34*x1_1_on_boundary_by_w + t35*x2_1_on_boundary_by_w + t40*v1_1_on_boundary_by_w + t41*v2_1_on_boundary_by_w
    carried_x2_2_by_y = t42*x1_1_on_boundary_by_y + t43*x2_1_on_boundary_by_y + t44*v1_1_on_boundary_by_y + t45*v2_1_on_boundary_by_y
    carried_v1_2_by_u = t34*v1_1_on_boundary_by_u + t35*v2_1_on_boundary_by_u - t48*x1_1_on_boundary_by_u + t49*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t42*v1_1_on_boundary_by_w + t43*v2_1_on_boundary_by_w + t50*x1_1_on_boundary_by_w - t51*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t62 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t62
    delay_tau1_by_u = -carried_x1_2_by_u*t62
    delay_tau1_by_w = -carried_x1_2_by_w*t62
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    t63 = t53*x1_2
    slope_by_delay_tau1_by_u = k1*t53*x2_2 - k1*t63
    v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*slope_by_delay_tau1_by_u
    t64 = t57*x1_2
    t65 = t57*x2_2
    slope_by_delay_tau1_by_w = k1*t64 - t59*t65
    v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*slope_by_delay_tau1_by_w
    trace = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y
    if outputs == 1:
        return trace
    [[_, _, _, _, _], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2, omega2_by_k3], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2, p1_by_k3], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2, p2_by_k3], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, p3_by_k3], [_, _, _, _, _], [omega3_by_m1, omega3_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3], [omega4_by_m1, omega4_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3], [p4_by_m1, p4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3], [p5_by_m1, p5_by_m2, p5_by_k1, p5_by_k2, p5_by_k3], [p6_by_m1, p6_by_m2, p6_by_k1, p6_by_k2, p6_by_k3]] = spectrum_derivatives
    # back through: Phi along tau1
    slope_by_carried_x1_2_by_w = -slope_by_delay_tau1_by_w*t62
    slope_by_carried_x1_2_by_u = -slope_by_delay_tau1_by_u*t62
    slope_by_carried_x1_2_by_y = -t62*v2_2
    # back through: perturbation on the boundary after tau
    slope_by_v2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t41 + t43
    slope_by_v2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t41 + t35
    slope_by_v2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t41 + t45
    slope_by_v1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t40 + t42
    slope_by_v1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t40 + t34
    slope_by_v1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t40 + t44
    slope_by_x2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t35 - t51
    slope_by_x2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t35 + t49
    slope_by_x2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t35 + t43
    slope_by_x1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t34 + t50
    slope_by_x1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t34 - t48
    slope_by_x1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t34 + t42
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_w = slope_by_v1_1_on_boundary_by_w*t56 + slope_by_v2_1_on_boundary_by_w*t61 + slope_by_x1_1_on_boundary_by_w*v1_1 + slope_by_x2_1_on_boundary_by_w*v2_1
    slope_by_delay_tau_by_u = slope_by_v1_1_on_boundary_by_u*t56 + slope_by_v2_1_on_boundary_by_u*t61 + slope_by_x1_1_on_boundary_by_u*v1_1 + slope_by_x2_1_on_boundary_by_u*v2_1
    slope_by_delay_tau_by_y = slope_by_v1_1_on_boundary_by_y*t56 + slope_by_v2_1_on_boundary_by_y*t61 + slope_by_x1_1_on_boundary_by_y*v1_1 + slope_by_x2_1_on_boundary_by_y*v2_1
    # back through: rate of the exit boundary after tau
    t66 = 1/rate_1**2
    slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t66 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t66 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t66
    # back through: Phi along tau
    slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t52 + slope_by_x1_1_on_boundary_by_w
    slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t52 + slope_by_x1_1_on_boundary_by_u
    slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t52 + slope_by_x1_1_on_boundary_by_y
    # back through: free for tau1, until first-reaches-stop
    t67 = 1/v1_2**2
    slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t67 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t67 + carried_x1_2_by_y*t67*v2_2
    t68 = k1*t53
    t69 = delay_tau1_by_u*t68
    slope_by_x2_2 = -delay_tau1_by_w*t57*t59 + t69
    slope_by_x1_2 = delay_tau1_by_w*k1*t57 - t69
    # back through: functions of tau1 in free
    t70 = p6*x1_1
    t71 = p4*x2_1
    t72 = p5*t38
    t73 = p5*v2_1_on_boundary_by_u
    t74 = p5*x2_1
    t75 = t33*x1_1
    t76 = p6*v1_1
    t77 = p5*v2_1
    t78 = p6*x1_1_on_boundary_by_w
    t79 = p5*x2_1_on_boundary_by_u
    t80 = p4*v2_1_on_boundary_by_y
    t81 = p6*v1_1_on_boundary_by_y
    t82 = p4*x2_1_on_boundary_by_w
    t83 = t33*x1_1_on_boundary_by_u
    slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*t70 - omega4*t71) + omega4*t78 + omega4*t79 - omega4*t82 - omega4*t83 + slope_by_carried_x1_2_by_u*(t33*t38*v1_1_on_boundary_by_u - t38*t73) + slope_by_carried_x1_2_by_w*(t33*t38*v1_1_on_boundary_by_w - t72*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t33*t38*v1_1_on_boundary_by_y - t72*v2_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t74 - omega4*t75) + slope_by_x1_2*(t33*t38*v1_1 - t38*t77) + slope_by_x2_2*(p4*t38*v2_1 - t38*t76) + t38*t80 - t38*t81
    t84 = t33*v1_1_on_boundary_by_u
    t85 = p5*x2_1_on_boundary_by_w
    t86 = p5*x2_1_on_boundary_by_y
    t87 = p6*x1_1_on_boundary_by_y
    t88 = p6*v1_1_on_boundary_by_w
    slope_by_cos_omega4_tau1 = delay_tau1_by_y*(p4*v2_1 - t76) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(t33*x1_1_on_boundary_by_u - t79) + slope_by_carried_x1_2_by_w*(t33*x1_1_on_boundary_by_w - t85) + slope_by_carried_x1_2_by_y*(t33*x1_1_on_boundary_by_y - t86) + slope_by_v1_2*(t33*v1_1 - t77) + slope_by_x1_2*(t33*x1_1 - t74) + slope_by_x2_2*(p4*x2_1 - t70) - t73 + t84 - t87 - t88
    t89 = t33*x2_1
    t90 = p5*t36
    t91 = p4*t36
    t92 = p4*v1_1_on_boundary_by_u
    t93 = p4*x1_1
    t94 = t33*v2_1
    t95 = p4*v1_1
    t96 = t33*v2_1_on_boundary_by_y
    t97 = p4*x1_1_on_boundary_by_u
    t98 = t33*x2_1_on_boundary_by_w
    slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t70 - omega3*t89) - omega3*t78 - omega3*t79 - omega3*t97 - omega3*t98 + slope_by_carried_x1_2_by_u*(t36*t73 + t36*t92) + slope_by_carried_x1_2_by_w*(t90*v2_1_on_boundary_by_w + t91*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t90*v2_1_on_boundary_by_y + t91*v1_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t74 - omega3*t93) + slope_by_x1_2*(t36*t77 + t36*t95) + slope_by_x2_2*(t36*t76 + t36*t94) + t36*t81 + t36*t96
    slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t76 + t94) + slope_by_carried_x1_2_by_u*(t79 + t97) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t85) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t86) + slope_by_v1_2*(t77 + t95) + slope_by_x1_2*(t74 + t93) + slope_by_x2_2*(t70 + t89) + t33*v2_1_on_boundary_by_w + t33*x2_1_on_boundary_by_y + t73 + t87 + t88 + t92
    # back through: tau1 completes the period
    t99 = cos_omega4_tau1*slope_by_sin_omega4_tau1
    t100 = cos_omega3_tau1*slope_by_sin_omega3_tau1
    t101 = sin_omega4_tau1*slope_by_cos_omega4_tau1
    t102 = sin_omega3_tau1*slope_by_cos_omega3_tau1
    slope_by_tau1 = omega3*t100 - omega3*t102 - omega4*t101 + omega4*t99
    # back through: contact for tau, until first-leaves-stop
    slope_by_v2_1 = delay_tau1_by_y*t43 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t35 + slope_by_x1_2*t41 + slope_by_x2_2*t45
    slope_by_v1_1 = delay_tau1_by_y*t42 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t34 + slope_by_x1_2*t40 + slope_by_x2_2*t44
    t103 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y
    t104 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u
    t105 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w
    t106 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y
    t107 = t57*t59
    t108 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u
    t109 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w
    slope_by_x2_1 = -delay_tau1_by_y*t51 + slope_by_v1_2*t49 + slope_by_x1_2*t35 + slope_by_x2_2*t43 + t103*t68 + t104*t68 + t105*t68 - t106*t107 - t107*t108 - t107*t109
    t110 = k1*t57
    t111 = t53*t54
    slope_by_x1_1 = delay_tau1_by_y*t50 - slope_by_v1_2*t48 + slope_by_x1_2*t34 + slope_by_x2_2*t42 - t103*t111 - t104*t111 - t105*t111 + t106*t110 + t108*t110 + t109*t110
    # back through: functions of tau in contact
    t112 = p1*y
    t113 = p3*u
    t114 = p2*w
    t115 = p2*slope_by_v1_1_on_boundary_by_y
    t116 = p1*slope_by_x2_1_on_boundary_by_w
    t117 = p3*slope_by_x2_1_on_boundary_by_u
    t118 = p2*slope_by_carried_x1_1_by_w
    t119 = p1*slope_by_v2_1_on_boundary_by_y
    slope_by_sin_omega2_tau = omega2*t115 - omega2*t119 - slope_by_carried_x1_1_by_u*t4*t6 + slope_by_v1_1*(omega2*p2*y - t24 - t25) + slope_by_v2_1*(-omega2*t112 + t29 + t30) + slope_by_x1_1*(-t114*t4 - t4*t6*u) + slope_by_x2_1*(p1*t4*w - t113*t4) + t116*t4 - t117*t4 - t118*t4
    t120 = p2*y
    t121 = -p1 - t120
    t122 = p3*slope_by_v2_1_on_boundary_by_u
    t123 = p2*slope_by_v1_1_on_boundary_by_w
    t124 = p2*slope_by_carried_x1_1_by_y
    slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t114 - t6*u) - slope_by_v1_1_on_boundary_by_u*t6 + slope_by_v2_1*(p1*w - t113) + slope_by_x1_1*(t121 + t15 + 1) + slope_by_x2_1*(p1*y - p3 - t19) - t122 - t123 - t124
    t125 = -t6*y
    t126 = -t6*w
    t127 = p1*u
    t128 = -slope_by_x2_1_on_boundary_by_w*t6
    t129 = -slope_by_v2_1_on_boundary_by_y*t6
    slope_by_sin_omega1_tau = -omega1*t115 - omega1*t129 + p1*slope_by_carried_x1_1_by_u*t2 + slope_by_v1_1*(-omega1*t120 - t22 + t23) + slope_by_v2_1*(-omega1*t125 - t26 + t28) + slope_by_x1_1*(t114*t2 + t127*t2) + slope_by_x2_1*(t113*t2 + t126*t2) + t117*t2 + t118*t2 + t128*t2
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t114 + t127) + slope_by_v2_1*(t113 + t126) - slope_by_v2_1_on_boundary_by_w*t6 + slope_by_x1_1*(-t121 - t14) + slope_by_x2_1*(p3 + t125 + t17) - slope_by_x2_1_on_boundary_by_y*t6 + t122 + t123 + t124
    # trace_gradient
    t130 = sin_omega2_tau*slope_by_cos_omega2_tau
    t131 = sin_omega1_tau*slope_by_cos_omega1_tau
    t132 = -t46 + t47
    t133 = cos_omega3_tau1 - cos_omega4_tau1
    t134 = t132*x1_1 + t133*v1_1
    t135 = t37 - t39
    t136 = t133*x1_1 + t135*v1_1
    t137 = t133*x1_1_on_boundary_by_y + t135*v1_1_on_boundary_by_y
    t138 = delay_tau1_by_y*t134 + slope_by_x2_2*t136 + t132*x1_1_on_boundary_by_w + t133*v1_1_on_boundary_by_w + t137
    t139 = slope_by_carried_x1_2_by_u*(t133*x2_1_on_boundary_by_u + t135*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t133*x2_1_on_boundary_by_w + t135*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t133*x2_1_on_boundary_by_y + t135*v2_1_on_boundary_by_y) + slope_by_v1_2*(t132*x2_1 + t133*v2_1) + slope_by_x1_2*(t133*x2_1 + t135*v2_1) + t132*x2_1_on_boundary_by_u + t133*v2_1_on_boundary_by_u
    t140 = delay_tau1_by_y*(-t132*x2_1 - t133*v2_1) + slope_by_carried_x1_2_by_u*(t133*x1_1_on_boundary_by_u + t135*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t133*x1_1_on_boundary_by_w + t135*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t137 + slope_by_v1_2*t134 + slope_by_x1_2*t136 + slope_by_x2_2*(-t133*x2_1 - t135*v2_1) + t132*x1_1_on_boundary_by_u - t132*x2_1_on_boundary_by_w + t133*v1_1_on_boundary_by_u - t133*v2_1_on_boundary_by_w - t133*x2_1_on_boundary_by_y - t135*v2_1_on_boundary_by_y
    t141 = sin_omega4_tau1/omega4**2
    t142 = p5*v2_1_on_boundary_by_w
    t143 = t141*t33
    t144 = p5*v2_1_on_boundary_by_y
    t145 = delay_tau1_by_y*(sin_omega4_tau1*t70 - sin_omega4_tau1*t71) + sin_omega4_tau1*t78 + sin_omega4_tau1*t79 - sin_omega4_tau1*t82 - sin_omega4_tau1*t83 + slope_by_carried_x1_2_by_u*(t141*t73 - t141*t84) + slope_by_carried_x1_2_by_w*(t141*t142 - t143*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t141*t144 - t143*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t74 - sin_omega4_tau1*t75) + slope_by_x1_2*(-t141*t33*v1_1 + t141*t77) + slope_by_x2_2*(-p4*t141*v2_1 + t141*t76) - t101*tau1 - t141*t80 + t141*t81 + t99*tau1
    t146 = sin_omega3_tau1/omega3**2
    t147 = p4*t146
    t148 = delay_tau1_by_y*(-sin_omega3_tau1*t70 - sin_omega3_tau1*t89) - sin_omega3_tau1*t78 - sin_omega3_tau1*t79 - sin_omega3_tau1*t97 - sin_omega3_tau1*t98 + slope_by_carried_x1_2_by_u*(-t146*t73 - t146*t92) + slope_by_carried_x1_2_by_w*(-t142*t146 - t147*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t144*t146 - t147*v1_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t74 - sin_omega3_tau1*t93) + slope_by_x1_2*(-t146*t77 - t146*t95) + slope_by_x2_2*(-t146*t76 - t146*t94) + t100*tau1 - t102*tau1 - t146*t81 - t146*t96
    t149 = cos_omega1_tau - cos_omega2_tau
    t150 = t3 - t5
    t151 = t20 - t21
    t152 = -t11*t20 + t11*t21 + t149*u + t151
    t153 = -cos_omega1_tau*t11 + cos_omega2_tau*t11 + t149 + t150*u
    t154 = slope_by_v2_1*t152 + slope_by_v2_1_on_boundary_by_u*t149 + slope_by_x2_1*t153 + slope_by_x2_1_on_boundary_by_u*t150
    t155 = t12*t21
    t156 = t12*t20
    t157 = cos_omega2_tau*t12
    t158 = cos_omega1_tau*t12
    t159 = slope_by_carried_x1_1_by_w*t150 + slope_by_carried_x1_1_by_y*t149 + slope_by_v1_1*(t149*w + t151*y + t155 - t156) + slope_by_v1_1_on_boundary_by_w*t149 + slope_by_v1_1_on_boundary_by_y*t151 + slope_by_x1_1*(t149*y + t150*w + t157 - t158)
    t160 = slope_by_carried_x1_1_by_u*t150 + slope_by_v1_1*t152 + slope_by_v1_1_on_boundary_by_u*t149 + slope_by_v2_1*(-t149*w - t151*y - t155 + t156) - slope_by_v2_1_on_boundary_by_w*t149 - slope_by_v2_1_on_boundary_by_y*t151 + slope_by_x1_1*t153 + slope_by_x2_1*(-t149*y - t150*w - t157 + t158) - slope_by_x2_1_on_boundary_by_w*t150 - slope_by_x2_1_on_boundary_by_y*t149
    t161 = p3*sin_omega2_tau
    t162 = -sin_omega2_tau*t6
    t163 = 1/omega2**2
    t164 = sin_omega2_tau*t163
    t165 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t115 - sin_omega2_tau*t119 - slope_by_carried_x1_1_by_u*t162*t163 + slope_by_v1_1*(sin_omega2_tau*t120 + sin_omega2_tau*(-t10*t6*t8 - t13) - t162) + slope_by_v2_1*(-sin_omega2_tau*t112 + sin_omega2_tau*t19 + t161) + slope_by_x1_1*(t114*t164 + t164*t6*u) + slope_by_x2_1*(-p1*t164*w + t113*t164) + slope_by_x2_1_on_boundary_by_u*t161*t163 - t116*t164 + t118*t164 - t130*tau
    t166 = p3*sin_omega1_tau
    t167 = p1*sin_omega1_tau
    t168 = 1/omega1**2
    t169 = sin_omega1_tau*t168
    t170 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t115 - sin_omega1_tau*t129 - slope_by_carried_x1_1_by_u*t167*t168 + slope_by_v1_1*(-sin_omega1_tau*t120 + sin_omega1_tau*t14 - t167) + slope_by_v2_1*(-sin_omega1_tau*t125 + sin_omega1_tau*(t16 + t27) - t166) + slope_by_x1_1*(-t114*t169 - t127*t169) + slope_by_x2_1*(-t113*t169 - t126*t169) - slope_by_x2_1_on_boundary_by_u*t166*t168 - t118*t169 - t128*t169 - t131*tau
    t171 = 1/m1**2
    t172 = k1*t171
    t173 = -k3*t171 + t171*t54*x1_1 - t172*x2_1
    t174 = 1/m2**2
    t175 = k1*t174
    t176 = t174*t59*x2_1 - t175*x1_1
    t177 = k3*t10
    t178 = t177*t26
    t179 = -omega1*t6
    t180 = -k2 - k3
    t181 = 1/t9**2
    t182 = t181*t8
    t183 = t180*t182
    t184 = t181*t7
    t185 = t180*t184
    t186 = p1*t177
    t187 = t177*t29
    t188 = p1*t185
    t189 = p2*t177
    t190 = t177*t22
    t191 = p2*t185
    t192 = t177*t6
    t193 = p3*t177
    t194 = -p3*t183 - t193
    t195 = t189 + t191
    t196 = t58 - t60
    t197 = t53*x2_1 - t55
    t198 = -t182*t54
    t199 = -t184*t54
    t200 = p2*t199
    t201 = p3*t198 + t193
    t202 = t10*t59
    t203 = k1*t10
    t204 = -t182*t59
    t205 = -t184*t59
    t206 = p1*t203
    t207 = p1*t205
    t208 = p2*t203
    t209 = p2*t205
    t210 = -p3*t202 - p3*t204
    t211 = t208 + t209
    t212 = t53 - t55
    trace_gradient = [carried_v1_1_by_y*slope_by_v1_1 + carried_v2_1_by_y*slope_by_v2_1 + carried_x1_1_by_y*slope_by_x1_1 + carried_x2_1_by_y*slope_by_x2_1, carried_v1_1_by_u*slope_by_v1_1 + carried_v2_1_by_u*slope_by_v2_1 + carried_x1_1_by_u*slope_by_x1_1 + carried_x2_1_by_u*slope_by_x2_1, carried_x1_1_by_w*slope_by_x1_1 + carried_x1_1_by_y*slope_by_v1_1 + carried_x2_1_by_w*slope_by_x2_1 + carried_x2_1_by_y*slope_by_v2_1, cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t131 - omega2*t130 - slope_by_tau1, delay_tau1_by_u*(t172*x1_2 - t172*x2_2) + omega1_by_m1*t170 + omega2_by_m1*t165 + omega3_by_m1*t148 + omega4_by_m1*t145 + p1_by_m1*t160 + p2_by_m1*t159 + p3_by_m1*t154 + p4_by_m1*t140 + p5_by_m1*t139 + p6_by_m1*t138 + t103*t173 + t104*t173 + t105*t173, delay_tau1_by_w*(t174*t59*x2_2 - t175*x1_2) + omega1_by_m2*t170 + omega2_by_m2*t165 + omega3_by_m2*t148 + omega4_by_m2*t145 + p1_by_m2*t160 + p2_by_m2*t159 + p3_by_m2*t154 + p4_by_m2*t140 + p5_by_m2*t139 + p6_by_m2*t138 + t106*t176 + t108*t176 + t109*t176, delay_tau1_by_u*(t53*x2_2 - t63) + delay_tau1_by_w*(t64 - t65) + omega1_by_k1*t170 + omega2_by_k1*t165 + omega3_by_k1*t148 + omega4_by_k1*t145 + p1_by_k1*t160 + p2_by_k1*t159 + p3_by_k1*t154 + p4_by_k1*t140 + p5_by_k1*t139 + p6_by_k1*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t189 + omega1*t191 + t183*t22 + t190) + sin_omega2_tau*(-k3*omega2*t10*t6 - omega2*t180*t181*t6*t8 - omega2*t189 - omega2*t191)) + slope_by_v2_1*(sin_omega1_tau*(t177*t179 + t178 + t179*t185 + t183*t26) + sin_omega2_tau*(omega2*t186 + omega2*t188 - t183*t29 - t187)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t183 - t186 - t195) + cos_omega2_tau*(t183*t6 + t192 + t195) + t177 + t183) + slope_by_x2_1*(cos_omega1_tau*(t185*t6 + t192 + t194) + cos_omega2_tau*(-t186 - t188 - t194) + t177 + t185) + t103*t197 + t104*t197 + t105*t197 + t106*t196 + t108*t196 + t109*t196, -delay_tau1_by_w*t65 + omega1_by_k2*t170 + omega2_by_k2*t165 + omega3_by_k2*t148 + omega4_by_k2*t145 + p1_by_k2*t160 + p2_by_k2*t159 + p3_by_k2*t154 + p4_by_k2*t140 + p5_by_k2*t139 + p6_by_k2*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t200 + t190 + t198*t22) + sin_omega2_tau*(-omega2*t200 + t177*t25 + t198*t25)) + slope_by_v2_1*(sin_omega1_tau*(t178 + t179*t199 + t198*t26) + sin_omega2_tau*(-k1*k3*omega2*p1*t181*t54 - t187 - t198*t29)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t198 - t186 - t200) + cos_omega2_tau*(t192 + t198*t6 + t200) + t177 + t198) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t181*t54*t6 - t201) + cos_omega2_tau*(-p1*t199 + t201) + t199) - t106*t60 - t108*t60 - t109*t60, omega1_by_k3*t170 + omega2_by_k3*t165 + omega3_by_k3*t148 + omega4_by_k3*t145 + p1_by_k3*t160 + p2_by_k3*t159 + p3_by_k3*t154 + p4_by_k3*t140 + p5_by_k3*t139 + p6_by_k3*t138 + slope_by_v1_1*(sin_omega1_tau*(omega1*t208 + omega1*t209 + t202*t22 + t204*t22) + sin_omega2_tau*(-omega2*t10*t59*t6 + omega2*t181*t59*t6*t8 - omega2*t208 - omega2*t209)) + slope_by_v2_1*(sin_omega1_tau*(t179*t203 + t179*t205 + t202*t26 + t204*t26) + sin_omega2_tau*(omega2*t206 + omega2*t207 - t202*t29 - t204*t29)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t202 - p1*t204 - t211) + cos_omega2_tau*(t202*t6 + t204*t6 + t211) + t202 + t204) + slope_by_x2_1*(cos_omega1_tau*(t203*t6 + t205*t6 + t210) + cos_omega2_tau*(-t206 - t207 - t210) + t203 + t205) + t103*t212 + t104*t212 + t105*t212, slope_by_tau1]
    return trace, trace_gradient


def one_contact_passage(parameters, spectrum, unknowns, *, lib, outputs=3):
    """State at the start and behind each transition. Boundaries along the phases: constant,
    slope, cosine and sine amplitudes, one after the other; and the frequencies of each
    phase.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives states (3, 4).
    Gives coefficients (12).
    Gives frequencies (4).
    Operations: 238. Intermediate terms: 58.
    """
    [_, _, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [y, u, w, tau] = unknowns
    # functions of tau in contact
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t1 = omega2*tau
    cos_omega2_tau = lib.cos(t1)
    sin_omega2_tau = lib.sin(t1)
    # contact for tau, until first-leaves-stop
    t2 = k1*k3
    t3 = k2*k3 + t2
    t4 = 1/(k1*k2 + t3)
    t5 = t3*t4
    t6 = 1/omega1
    t7 = sin_omega1_tau*t6
    t8 = 1/omega2
    t9 = sin_omega2_tau*t8
    t10 = p1 - 1
    t11 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t12 = p1*t5
    t13 = t2*t4
    t14 = p2*t13
    t15 = t12 + t14
    t16 = t10*t5 + t14
    t17 = cos_omega1_tau*p1 - cos_omega2_tau*t10
    x1_1 = -cos_omega1_tau*t15 + cos_omega2_tau*t16 + t11*y + t17 + t5 + u*(p1*t7 - t10*t9) + w*(p2*t7 - p2*t9)
    t18 = -cos_omega1_tau*t10 + cos_omega2_tau*p1
    t19 = p3*t5
    t20 = p1*t13
    t21 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(t10*t13 - t19) + cos_omega2_tau*(t19 - t20) + t13 + t18*y + t21 + u*(p3*t7 - p3*t9) + w*(p1*t9 - t10*t7)
    t22 = omega2*sin_omega2_tau
    t23 = omega1*sin_omega1_tau
    v1_1 = -p1*t23 + sin_omega1_tau*(omega1*t12 + omega1*t14) + sin_omega2_tau*(-omega2*t10*t3*t4 - omega2*t14) + t10*t22 + t11*w + t17*u + y*(p2*t22 - p2*t23)
    v2_1 = p3*t22 - p3*t23 + sin_omega1_tau*(-omega1*t10*t13 + omega1*t19) + sin_omega2_tau*(-omega2*t19 + omega2*t20) + t18*w + t21*u + y*(-p1*t22 + t10*t23)
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t24 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t24)
    sin_omega3_tau1 = lib.sin(t24)
    t25 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t25)
    sin_omega4_tau1 = lib.sin(t25)
    # free for tau1, until first-reaches-stop
    t26 = 1 - p4
    t27 = cos_omega3_tau1*p4 + cos_omega4_tau1*t26
    t28 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    t29 = 1/omega3
    t30 = sin_omega3_tau1*t29
    t31 = 1/omega4
    t32 = sin_omega4_tau1*t31
    x1_2 = t27*x1_1 + t28*x2_1 + v1_1*(p4*t30 + t26*t32) + v2_1*(p5*t30 - p5*t32)
    t33 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t34 = cos_omega3_tau1*t26 + cos_omega4_tau1*p4
    x2_2 = t33*x1_1 + t34*x2_1 + v1_1*(p6*t30 - p6*t32) + v2_1*(p4*t32 + t26*t30)
    t35 = omega3*sin_omega3_tau1
    t36 = omega4*sin_omega4_tau1
    v1_2 = t27*v1_1 + t28*v2_1 + x1_1*(-p4*t35 - t26*t36) + x2_1*(-p5*t35 + p5*t36)
    v2_2 = t33*v1_1 + t34*v2_1 + x1_1*(-p6*t35 + p6*t36) + x2_1*(-p4*t36 - t26*t35)
    states = [[1, y, u, w], [x1_1, x2_1, v1_1, v2_1], [x1_2, x2_2, v1_2, v2_2]]
    if outputs == 1:
        return states
    # coefficients
    t37 = -p1 - p2*y
    t38 = p2*w
    t39 = p5*x2_1
    t40 = p5*v2_1
    coefficients = [1 - t5, 0, t15 + t37, -t16 - t37 - 1, -p1*t6*u - t38*t6, t10*t8*u + t38*t8, -1, 0, p4*x1_1 + t39, t26*x1_1 - t39, p4*t29*v1_1 + t29*t40, t26*t31*v1_1 - t31*t40]
    if outputs == 2:
        return states, coefficients
    frequencies = [omega1, omega2, omega3, omega4]
    return states, coefficients, frequencies


def one_contact_linearisation(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Jacobian of the Poincare map in the section's coordinates; saltation matrices, one
    below the other; monodromy matrix.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives poincare_jacobian (3, 3).
    Gives saltations (8, 4).
    Gives monodromy (4, 4).
    Operations: 525. Intermediate terms: 158.
    """
    [m1, m2, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [y, u, w, tau] = unknowns
    # functions of tau in contact
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t1 = omega2*tau
    cos_omega2_tau = lib.cos(t1)
    sin_omega2_tau = lib.sin(t1)
    # contact for tau, until first-leaves-stop
    t2 = sin_omega1_tau/omega1
    t3 = sin_omega2_tau/omega2
    carried_x1_1_by_w = p2*t2 - p2*t3
    t4 = p1 - 1
    carried_x1_1_by_u = p1*t2 - t3*t4
    carried_x1_1_by_y = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t5 = k1*k3
    t6 = k2*k3 + t5
    t7 = 1/(k1*k2 + t6)
    t8 = t6*t7
    t9 = p1*t8
    t10 = t5*t7
    t11 = p2*t10
    carried_v1_1_by_u = cos_omega1_tau*p1 - cos_omega2_tau*t4
    x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_w*w + carried_x1_1_by_y*y + cos_omega1_tau*(-t11 - t9) + cos_omega2_tau*(t11 + t4*t8) + t8
    carried_x2_1_by_w = p1*t3 - t2*t4
    carried_x2_1_by_u = p3*t2 - p3*t3
    carried_x2_1_by_y = -cos_omega1_tau*t4 + cos_omega2_tau*p1
    t12 = p3*t8
    t13 = p1*t10
    carried_v2_1_by_u = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_w*w + carried_x2_1_by_y*y + cos_omega1_tau*(t10*t4 - t12) + cos_omega2_tau*(t12 - t13) + t10
    t14 = omega2*sin_omega2_tau
    t15 = omega1*sin_omega1_tau
    carried_v1_1_by_y = p2*t14 - p2*t15
    t16 = p1*t15
    t17 = -t14*t4
    v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y + carried_x1_1_by_y*w + sin_omega1_tau*(omega1*t11 + omega1*t9) + sin_omega2_tau*(-omega2*t11 - omega2*t4*t6*t7) - t16 - t17
    carried_v2_1_by_y = -p1*t14 + t15*t4
    phi_1_30 = p3*t14 - p3*t15
    v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + carried_x2_1_by_y*w + phi_1_30 + sin_omega1_tau*(-omega1*t10*t4 + omega1*t12) + sin_omega2_tau*(-omega2*t12 + omega2*t13)
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t18 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t18)
    sin_omega3_tau1 = lib.sin(t18)
    t19 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t19)
    sin_omega4_tau1 = lib.sin(t19)
    # free for tau1, until first-reaches-stop
    t20 = 1 - p4
    t21 = cos_omega3_tau1*p4 + cos_omega4_tau1*t20
    t22 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    t23 = sin_omega3_tau1/omega3
    t24 = sin_omega4_tau1/omega4
    t25 = p4*t23 + t20*t24
    t26 = p5*t23 - p5*t24
    x1_2 = t21*x1_1 + t22*x2_1 + t25*v1_1 + t26*v2_1
    t27 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t28 = cos_omega3_tau1*t20 + cos_omega4_tau1*p4
    t29 = p6*t23 - p6*t24
    t30 = p4*t24 + t20*t23
    x2_2 = t27*x1_1 + t28*x2_1 + t29*v1_1 + t30*v2_1
    t31 = omega3*sin_omega3_tau1
    t32 = omega4*sin_omega4_tau1
    t33 = -p4*t31 - t20*t32
    t34 = -p5*t31 + p5*t32
    v1_2 = t21*v1_1 + t22*v2_1 + t33*x1_1 + t34*x2_1
    t35 = -p6*t31 + p6*t32
    t36 = -p4*t32 - t20*t31
    v2_2 = t27*v1_1 + t28*v2_1 + t35*x1_1 + t36*x2_1
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t37 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t37
    delay_tau_by_u = carried_x1_1_by_u*t37
    delay_tau_by_w = carried_x1_1_by_w*t37
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t38 = 1/m1
    t39 = k3*t38
    t40 = k1*t38
    t41 = t38*(k1 + k3)
    before_v1_1 = t39 + t40*x2_1 - t41*x1_1
    v1_1_on_boundary_by_y = before_v1_1*delay_tau_by_y + carried_v1_1_by_y
    v1_1_on_boundary_by_u = before_v1_1*delay_tau_by_u + carried_v1_1_by_u
    v1_1_on_boundary_by_w = before_v1_1*delay_tau_by_w + carried_x1_1_by_y
    t42 = 1/m2
    t43 = k1*t42
    t44 = t42*(k1 + k2)
    before_v2_1 = t43*x1_1 - t44*x2_1
    v2_1_on_boundary_by_y = before_v2_1*delay_tau_by_y + carried_v2_1_by_y
    v2_1_on_boundary_by_u = before_v2_1*delay_tau_by_u + carried_v2_1_by_u
    v2_1_on_boundary_by_w = before_v2_1*delay_tau_by_w + carried_x2_1_by_y
    # Phi along tau1
    carried_x1_2_by_y = t21*x1_1_on_boundary_by_y + t22*x2_1_on_boundary_by_y + t25*v1_1_on_boundary_by_y + t26*v2_1_on_boundary_by_y
    carried_x1_2_by_u = t21*x1_1_on_boundary_by_u + t22*x2_1_on_boundary_by_u + t25*v1_1_on_boundary_by_u + t26*v2_1_on_boundary_by_u
    carried_x1_2_by_w = t21*x1_1_on_boundary_by_w + t22*x2_1_on_boundary_by_w + t25*v1_1_on_boundary_by_w + t26*v2_1_on_boundary_by_w
    carried_x2_2_by_y = t27*x1_1_on_boundary_by_y + t28*x2_1_on_boundary_by_y + t29*v1_1_on_boundary_by_y + t30*v2_1_on_boundary_by_y
    carried_x2_2_by_u = t27*x1_1_on_boundary_by_u + t28*x2_1_on_boundary_by_u + t29*v1_1_on_boundary_by_u + t30*v2_1_on_boundary_by_u
    carried_x2_2_by_w = t27*x1_1_on_boundary_by_w + t28*x2_1_on_boundary_by_w + t29*v1_1_on_boundary_by_w + t30*v2_1_on_boundary_by_w
    carried_v1_2_by_y = t21*v1_1_on_boundary_by_y + t22*v2_1_on_boundary_by_y + t33*x1_1_on_boundary_by_y + t34*x2_1_on_boundary_by_y
    carried_v1_2_by_u = t21*v1_1_on_boundary_by_u + t22*v2_1_on_boundary_by_u + t33*x1_1_on_boundary_by_u + t34*x2_1_on_boundary_by_u
    carried_v1_2_by_w = t21*v1_1_on_boundary_by_w + t22*v2_1_on_boundary_by_w + t33*x1_1_on_boundary_by_w + t34*x2_1_on_boundary_by_w
    carried_v2_2_by_y = t27*v1_1_on_boundary_by_y + t28*v2_1_on_boundary_by_y + t35*x1_1_on_boundary_by_y + t36*x2_1_on_boundary_by_y
    carried_v2_2_by_u = t27*v1_1_on_boundary_by_u + t28*v2_1_on_boundary_by_u + t35*x1_1_on_boundary_by_u + t36*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t27*v1_1_on_boundary_by_w + t28*v2_1_on_boundary_by_w + t35*x1_1_on_boundary_by_w + t36*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t45 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t45
    delay_tau1_by_u = -carried_x1_2_by_u*t45
    delay_tau1_by_w = -carried_x1_2_by_w*t45
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2
    x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2
    before_v1_2 = k1*t38*x2_2 - t40*x1_2
    v1_2_on_boundary_by_y = before_v1_2*delay_tau1_by_y + carried_v1_2_by_y
    v1_2_on_boundary_by_u = before_v1_2*delay_tau1_by_u + carried_v1_2_by_u
    v1_2_on_boundary_by_w = before_v1_2*delay_tau1_by_w + carried_v1_2_by_w
    before_v2_2 = t43*x1_2 - t44*x2_2
    v2_2_on_boundary_by_y = before_v2_2*delay_tau1_by_y + carried_v2_2_by_y
    v2_2_on_boundary_by_u = before_v2_2*delay_tau1_by_u + carried_v2_2_by_u
    v2_2_on_boundary_by_w = before_v2_2*delay_tau1_by_w + carried_v2_2_by_w
    poincare_jacobian = [[x2_2_on_boundary_by_y, x2_2_on_boundary_by_u, x2_2_on_boundary_by_w], [v1_2_on_boundary_by_y, v1_2_on_boundary_by_u, v1_2_on_boundary_by_w], [v2_2_on_boundary_by_y, v2_2_on_boundary_by_u, v2_2_on_boundary_by_w]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 1
    behind_v1_1 = k1*t38*x2_1 - t40*x1_1
    # vector fields at transition 2
    behind_v1_2 = t39 + t40*x2_2 - t41*x1_2
    # saltations
    t46 = 1/v1_1
    t47 = t46*(before_v1_1 - behind_v1_1)
    t48 = 0
    t49 = t45*(-before_v1_2 + behind_v1_2)
    t50 = 0
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [-t47, 0, 1, 0], [-t48, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [t49, 0, 1, 0], [t50, 0, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 1
    phi_1_20 = -t16 - t17
    # saltation of phase 1
    saltation_1_20 = -carried_v1_1_by_u*t47 + phi_1_20
    saltation_1_21 = carried_v1_1_by_y - carried_x1_1_by_y*t47
    saltation_1_22 = carried_v1_1_by_u - carried_x1_1_by_u*t47
    saltation_1_23 = -carried_x1_1_by_w*t47 + carried_x1_1_by_y
    saltation_1_30 = -carried_v1_1_by_u*t48 + phi_1_30
    saltation_1_31 = carried_v2_1_by_y - carried_x1_1_by_y*t48
    saltation_1_32 = carried_v2_1_by_u - carried_x1_1_by_u*t48
    saltation_1_33 = -carried_x1_1_by_w*t48 + carried_x2_1_by_y
    # Phi of phase 2
    phi_2_00 = carried_v1_1_by_u*t21 + carried_v2_1_by_u*t22 + saltation_1_20*t25 + saltation_1_30*t26
    phi_2_01 = carried_x1_1_by_y*t21 + carried_x2_1_by_y*t22 + saltation_1_21*t25 + saltation_1_31*t26
    phi_2_02 = carried_x1_1_by_u*t21 + carried_x2_1_by_u*t22 + saltation_1_22*t25 + saltation_1_32*t26
    phi_2_03 = carried_x1_1_by_w*t21 + carried_x2_1_by_w*t22 + saltation_1_23*t25 + saltation_1_33*t26
    phi_2_10 = carried_v1_1_by_u*t27 + carried_v2_1_by_u*t28 + saltation_1_20*t29 + saltation_1_30*t30
    phi_2_11 = carried_x1_1_by_y*t27 + carried_x2_1_by_y*t28 + saltation_1_21*t29 + saltation_1_31*t30
    phi_2_12 = carried_x1_1_by_u*t27 + carried_x2_1_by_u*t28 + saltation_1_22*t29 + saltation_1_32*t30
    phi_2_13 = carried_x1_1_by_w*t27 + carried_x2_1_by_w*t28 + saltation_1_23*t29 + saltation_1_33*t30
    phi_2_20 = carried_v1_1_by_u*t33 + carried_v2_1_by_u*t34 + saltation_1_20*t21 + saltation_1_30*t22
    phi_2_21 = carried_x1_1_by_y*t33 + carried_x2_1_by_y*t34 + saltation_1_21*t21 + saltation_1_31*t22
    phi_2_22 = carried_x1_1_by_u*t33 + carried_x2_1_by_u*t34 + saltation_1_22*t21 + saltation_1_32*t22
    phi_2_23 = carried_x1_1_by_w*t33 + carried_x2_1_by_w*t34 + saltation_1_23*t21 + saltation_1_33*t22
    phi_2_30 = carried_v1_1_by_u*t35 + carried_v2_1_by_u*t36 + saltation_1_20*t27 + saltation_1_30*t28
    phi_2_31 = carried_x1_1_by_y*t35 + carried_x2_1_by_y*t36 + saltation_1_21*t27 + saltation_1_31*t28
    phi_2_32 = carried_x1_1_by_u*t35 + carried_x2_1_by_u*t36 + saltation_1_22*t27 + saltation_1_32*t28
    phi_2_33 = carried_x1_1_by_w*t35 + carried_x2_1_by_w*t36 + saltation_1_23*t27 + saltation_1_33*t28
    # saltation of phase 2
    saltation_2_20 = phi_2_00*t49 + phi_2_20
    saltation_2_21 = phi_2_01*t49 + phi_2_21
    saltation_2_22 = phi_2_02*t49 + phi_2_22
    saltation_2_23 = phi_2_03*t49 + phi_2_23
    saltation_2_30 = phi_2_00*t50 + phi_2_30
    saltation_2_31 = phi_2_01*t50 + phi_2_31
    saltation_2_32 = phi_2_02*t50 + phi_2_32
    saltation_2_33 = phi_2_03*t50 + phi_2_33
    monodromy = [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [phi_2_10, phi_2_11, phi_2_12, phi_2_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]
    return poincare_jacobian, saltations, monodromy


def one_contact_reduced(parameters, spectrum, reduced, *, lib, outputs=4):
    """All unknowns from the reduced ones; how singular the linear equations for them are: 0
    if they are; the equations for these and their derivatives.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes reduced (1): tau.
    Gives unknowns (4).
    Gives determinants (1).
    Gives reduced_residual (1).
    Gives reduced_jacobian (1, 1).
    Operations: 446. Intermediate terms: 136.
    """
    [_, _, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [tau] = reduced
    # half of tau
    half_tau = tau/2
    # functions of half_tau in contact
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t1 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t1)
    sin_omega2_half_tau = lib.sin(t1)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t2 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t2)
    sin_omega3_half_tau1 = lib.sin(t2)
    t3 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t3)
    sin_omega4_half_tau1 = lib.sin(t3)
    # coefficients of the linear equations
    t4 = k2*k3
    t5 = k1*k2
    t6 = k1*k3
    t7 = 1/(t4 + t5 + t6)
    t8 = p2*t6
    t9 = t7*(p2*t4 + p2*t5 + t8)
    t10 = omega2*sin_omega2_half_tau
    t11 = omega1*sin_omega1_half_tau
    coefficient11 = t10*t9 - t11*t9
    t12 = p1 - 1
    coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t12
    coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2
    t13 = p1*t6
    t14 = p1*t4 + p1*t5 + t13
    t15 = t10*t7
    t16 = t14 - t4 - t5 - t6
    coefficient21 = omega1*sin_omega1_half_tau*t16*t7 - t14*t15
    coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3
    coefficient23 = -cos_omega1_half_tau*t12 + cos_omega2_half_tau*p1
    t17 = omega4*sin_omega4_half_tau1
    t18 = omega3*sin_omega3_half_tau1
    coefficient31 = p5*t17 - p5*t18
    t19 = p4 - 1
    coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t19
    coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5
    # right-hand sides of the linear equations
    t20 = -k1*k2*p1 + t8
    t21 = -t20 - t5
    right1 = -omega1*sin_omega1_half_tau*t20*t7 - t15*t21
    t22 = p3*t5 + t13
    t23 = -t22 + t6
    right2 = -t11*t23*t7 - t15*t22
    right3 = p4*t18 - t17*t19
    # determinant of the linear equations
    t24 = coefficient22*coefficient33
    t25 = coefficient21*coefficient32
    t26 = coefficient23*coefficient32
    t27 = coefficient21*coefficient33
    t28 = coefficient22*coefficient31
    determinant = coefficient11*t24 - coefficient11*t26 + coefficient12*coefficient23*coefficient31 - coefficient12*t27 + coefficient13*t25 - coefficient13*t28
    # numerators of Cramer's rule
    t29 = coefficient12*coefficient23
    t30 = coefficient12*coefficient33
    t31 = coefficient13*coefficient22
    numerator1 = coefficient13*coefficient32*right2 + right1*t24 - right1*t26 - right2*t30 + right3*t29 - right3*t31
    t32 = coefficient11*coefficient23
    t33 = coefficient13*coefficient31
    numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t27 - right2*t33 - right3*t32
    t34 = coefficient11*coefficient22
    t35 = coefficient11*coefficient32
    t36 = coefficient12*coefficient21
    numerator3 = coefficient12*coefficient31*right2 + right1*t25 - right1*t28 - right2*t35 + right3*t34 - right3*t36
    # y, u, w by Cramer's rule
    t37 = 1/determinant
    y = numerator1*t37
    u = numerator2*t37
    w = numerator3*t37
    unknowns = [y, u, w, tau]
    if outputs == 1:
        return unknowns
    # determinants
    t38 = 2*p5**2
    t39 = half_tau1**2
    t40 = t38*t39
    t41 = p1**2
    t42 = half_tau**2
    t43 = 2*t42
    t44 = omega2**4/(omega2**2*t42 + 1)
    t45 = omega1**4/(omega1**2*t42 + 1)
    t46 = t12**2 + t41
    t47 = 2*p2**2
    t48 = t42*t47
    determinants = [determinant/(lib.sqrt(2*p3**2 + t12**2*t43*t45 + t41*t43*t44 + t46)*lib.sqrt(t44*t48 + t45*t48 + t46 + t47)*lib.sqrt(omega3**4*t40/(omega3**2*t39 + 1) + omega4**4*t40/(omega4**2*t39 + 1) + p4**2 + t19**2 + t38))]
    if outputs == 2:
        return unknowns, determinants
    # reduced_residual
    t49 = p6*t17 - p6*t18
    t50 = omega3*sin_omega3_half_tau1*t19 - p4*t17
    t51 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6
    t52 = cos_omega3_half_tau1*t19 - cos_omega4_half_tau1*p4
    reduced_residual = [determinant*t49 + numerator1*t50 + numerator2*t51 + numerator3*t52]
    if outputs == 3:
        return unknowns, determinants, reduced_residual
    # d/dtau of: functions of half_tau in contact
    t53 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t53
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t53
    t54 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t54
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t54
    # d/dtau of: functions of half_tau1 in free
    t55 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t55
    sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t55
    t56 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t56
    sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t56
    # d/dtau of: coefficients of the linear equations
    t57 = omega2*sin_omega2_half_tau_by_tau
    t58 = omega1*sin_omega1_half_tau_by_tau
    coefficient11_by_tau = t57*t9 - t58*t9
    coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 - cos_omega2_half_tau_by_tau*t12
    coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2
    t59 = t57*t7
    coefficient21_by_tau = omega1*sin_omega1_half_tau_by_tau*t16*t7 - t14*t59
    coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3
    coefficient23_by_tau = -cos_omega1_half_tau_by_tau*t12 + cos_omega2_half_tau_by_tau*p1
    t60 = omega4*sin_omega4_half_tau1_by_tau
    t61 = omega3*sin_omega3_half_tau1_by_tau
    coefficient31_by_tau = p5*t60 - p5*t61
    coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t19
    coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5
    # d/dtau of: right-hand sides of the linear equations
    right1_by_tau = -omega1*sin_omega1_half_tau_by_tau*t20*t7 - t21*t59
    right2_by_tau = -t22*t59 - t23*t58*t7
    right3_by_tau = p4*t61 - t19*t60
    # d/dtau of: determinant of the linear equations
    t62 = t24 - t26
    t63 = coefficient23*coefficient31 - t27
    t64 = t25 - t28
    t65 = coefficient13*coefficient32 - t30
    t66 = coefficient11*coefficient33 - t33
    t67 = coefficient12*coefficient31 - t35
    t68 = t29 - t31
    t69 = coefficient13*coefficient21 - t32
    t70 = t34 - t36
    determinant_by_tau = coefficient11_by_tau*t62 + coefficient12_by_tau*t63 + coefficient13_by_tau*t64 + coefficient21_by_tau*t65 + coefficient22_by_tau*t66 + coefficient23_by_tau*t67 + coefficient31_by_tau*t68 + coefficient32_by_tau*t69 + coefficient33_by_tau*t70
    # d/dtau of: numerators of Cramer's rule
    t71 = coefficient23*right3 - coefficient33*right2
    t72 = coefficient22*right3 - coefficient32*right2
    t73 = coefficient13*right3 - coefficient33*right1
    t74 = coefficient12*right3 - coefficient32*right1
    t75 = coefficient13*right2 - coefficient23*right1
    t76 = coefficient12*right2 - coefficient22*right1
    numerator1_by_tau = coefficient12_by_tau*t71 - coefficient13_by_tau*t72 - coefficient22_by_tau*t73 + coefficient23_by_tau*t74 + coefficient32_by_tau*t75 - coefficient33_by_tau*t76 + right1_by_tau*t62 + right2_by_tau*t65 + right3_by_tau*t68
    t77 = coefficient21*right3 - coefficient31*right2
    t78 = coefficient11*right3 - coefficient31*right1
    t79 = coefficient11*right2 - coefficient21*right1
    numerator2_by_tau = -coefficient11_by_tau*t71 + coefficient13_by_tau*t77 + coefficient21_by_tau*t73 - coefficient23_by_tau*t78 - coefficient31_by_tau*t75 + coefficient33_by_tau*t79 + right1_by_tau*t63 + right2_by_tau*t66 + right3_by_tau*t69
    numerator3_by_tau = coefficient11_by_tau*t72 - coefficient12_by_tau*t77 - coefficient21_by_tau*t74 + coefficient22_by_tau*t78 + coefficient31_by_tau*t76 - coefficient32_by_tau*t79 + right1_by_tau*t64 + right2_by_tau*t67 + right3_by_tau*t70
    # reduced_jacobian
    t80 = numerator2*p6
    t81 = determinant*p6
    reduced_jacobian = [[cos_omega3_half_tau1_by_tau*(numerator3*t19 - t80) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t80) + determinant_by_tau*t49 + numerator1_by_tau*t50 + numerator2_by_tau*t51 + numerator3_by_tau*t52 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t19 - omega3*t81) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t81)]]
    return unknowns, determinants, reduced_residual, reduced_jacobian
