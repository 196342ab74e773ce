# Generated; do not edit.
# Source: nonsmooth.derive.systems.rigid_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation e0db5a0cf84061ce
"""Kernels and tables of the system rigid-stop, over any arithmetic ``lib``."""

import json

DERIVATION = "e0db5a0cf84061ce"

SYSTEM = json.loads(r"""{
 "name": "rigid-stop",
 "description": "two coupled oscillators, the first in front of a rigid stop (Sec. 2.1)",
 "states": ["x1", "x2", "v1", "v2"],
 "parameters": [
  {"name": "m1", "description": "first mass, in the user's consistent units", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false},
  {"name": "m2", "description": "second mass", "lower": "0", "upper": null, "closed": false, "upper_closed": false},
  {"name": "k1", "description": "stiffness of the spring between the masses", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false},
  {"name": "k2", "description": "stiffness of the spring between the second mass and the ground", "lower": "0",
   "upper": null, "closed": false, "upper_closed": false},
  {"name": "r", "description": "coefficient of restitution, nondimensional", "lower": "0", "upper": "1", "closed": true,
   "upper_closed": true}
 ],
 "constraints": [],
 "configurations": {
  "free": [{"name": "first-reaches-stop", "acts_when": "exceeded"}],
  "contact": [{"name": "first-leaves-stop", "acts_when": "exceeded"}]
 },
 "spectrum": ["gap1", "omega1", "omega2", "p1", "p2", "p3", "omega3"],
 "spectrum_parameters": ["m1", "m2", "k1", "k2"],
 "modes": {
  "free": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1, "oscillates": true}],
  "contact": [{"length": 2, "oscillates": false}, {"length": 1, "oscillates": true}]
 },
 "forcing": [],
 "coordinates": [["x1", "v1"], ["x2", "v2"]],
 "held": {"free": [], "contact": ["x1"]},
 "constraint_rows": {"free": [], "contact": [2, 0]},
 "boundary_rows": {"free": [0], "contact": [1]},
 "transitions": [
  {"source": "free", "boundaries": ["first-reaches-stop"], "conditions": [[2, "contact", true]], "reset": 1,
   "target": "free"},
  {"source": "free", "boundaries": ["first-reaches-stop"], "conditions": [[3, "contact", true]], "reset": 2,
   "target": "contact"},
  {"source": "free", "boundaries": ["first-reaches-stop"], "conditions": [], "reset": 0, "target": "free"},
  {"source": "contact", "boundaries": ["first-leaves-stop"], "conditions": [], "reset": 0, "target": "free"}
 ],
 "contacts": {"stop": {"forces": {"contact": 1}, "velocity": 2, "surface": 4}}
}""")

ORBITS = json.loads(r"""{
 "one-impact": {
  "derived": true,
  "phases": [["free", "first-reaches-stop", "T"]],
  "states": ["x1", "x2", "v1", "v2"],
  "parameters": [
   {"name": "m1", "description": "first mass, in the user's consistent units", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "m2", "description": "second mass", "lower": "0", "upper": null, "closed": false, "upper_closed": false},
   {"name": "k1", "description": "stiffness of the spring between the masses", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "k2", "description": "stiffness of the spring between the second mass and the ground", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false},
   {"name": "T", "description": "period of the orbit", "lower": "0", "upper": null, "closed": false, "upper_closed": false}
  ],
  "open_parameters": [],
  "other_parameters": [
   {"name": "r", "description": "coefficient of restitution, nondimensional", "lower": "0", "upper": "1", "closed": true,
    "upper_closed": true}
  ],
  "combined": {},
  "unknowns": ["y", "u"],
  "dwell_times": ["T"],
  "durations": [{"T": 1}],
  "equations": ["v1 vanishes halfway through free", "v2 vanishes halfway through free"],
  "reduced": [],
  "rank": 3,
  "section": ["y", "u", "w"],
  "conservative": true,
  "reciprocal_pair": true,
  "required": {"r": "1"},
  "vanishing": [],
  "levels": {"x1": "1"},
  "resets": [[["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "-1", "0"], ["0", "0", "0", "1"]]],
  "measures": ["y", "u"],
  "terms": [2],
  "boundaries": [[0, "first-reaches-stop", null, 0.0, true]],
  "reference": {
   "parameters": {"m1": "1", "m2": "2", "k1": "1", "k2": "5", "T": "2*pi"},
   "guess": {"y": "0.162", "u": "-0.372"}
  }
 }
}""")

KERNELS = json.loads(r"""{
 "spectrum": [[[[4], 0]], [["spectrum", [7]], ["spectrum_derivatives", [7, 4]]]],
 "flow_free": [[[[5], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_contact": [[[[5], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "fields": [[[[5], 0]], [["fields", [8, 5]]]],
 "rows": [[[[5], 0]], [["rows", [5, 5]]]],
 "resets": [[[[5], 0]], [["resets", [12, 5]]]],
 "modes": [[[[5], 0], [[7], 0]], [["exponents", [5, 2]], ["coefficients", [36, 5]]]],
 "one_impact_equations": [[[[5], 0], [[7], 0], [[2], 0], [[7, 4], 2]], [["residual", [2]], ["jacobian", [2, 2]],
  ["parameter_jacobian", [2, 5]]]],
 "one_impact_trace": [[[[5], 0], [[7], 0], [[2], 0], [[7, 4], 1]], [["trace", []], ["trace_gradient", [7]]]],
 "one_impact_passage": [[[[5], 0], [[7], 0], [[2], 0]], [["states", [2, 4]], ["coefficients", [6]], ["frequencies",
  [2]]]],
 "one_impact_linearisation": [[[[5], 0], [[7], 0], [[2], 0]], [["poincare_jacobian", [3, 3]], ["saltations", [4, 4]],
  ["monodromy", [4, 4]]]],
 "one_impact_reduced": [[[[5], 0], [[7], 0]], [["unknowns", [2]], ["determinants", [1]]]]
}""")

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (4): m1, m2, k1, k2.
    Gives spectrum (7).
    Gives spectrum_derivatives (7, 4).
    Operations: 177. Intermediate terms: 69.
    """
    [m1, m2, k1, k2] = parameters
    # spectrum
    t0 = 1/m1
    t1 = k1*t0
    t2 = 1/m2
    t3 = k1 + k2
    t4 = t2*t3
    t5 = t1 - t4
    t6 = k1**2
    t7 = 4*t2*t6
    gap1 = lib.sqrt(t0*t7 + t5**2)
    omega1 = lib.sqrt(gap1/2 + t1/2 + t4/2)
    t8 = 1/omega1
    t9 = 1/lib.sqrt(m1)
    t10 = 1/lib.sqrt(m2)
    t11 = lib.sqrt(k2)
    t12 = lib.sqrt(k1)
    t13 = t10*t11*t12
    t14 = t13*t9
    omega2 = t14*t8
    t15 = 1/gap1
    t16 = t15/2
    p1 = t16*t5 + lib.rational(1, 2)
    p2 = -t1*t15
    t17 = t15*t2
    p3 = -k1*t17
    t18 = lib.sqrt(t3)
    omega3 = t10*t18
    spectrum = [gap1, omega1, omega2, p1, p2, p3, omega3]
    if outputs == 1:
        return spectrum
    # d/dm1 of: spectrum
    t19 = 1/m1**2
    t20 = k1*t19
    gap1_by_m1 = t16*(-t19*t7 - 2*t20*t5)
    t21 = t8/2
    omega1_by_m1 = t21*(gap1_by_m1/2 - t20/2)
    t22 = t14/omega1**2
    omega2_by_m1 = -omega1_by_m1*t22 - t13*t21/lib.sqrt(m1)**3
    t23 = 1/gap1**2
    t24 = t23*t5
    p1_by_m1 = -gap1_by_m1*t24/2 - t16*t20
    t25 = gap1_by_m1*t23
    p2_by_m1 = t1*t25 + t15*t20
    t26 = k1*t2
    p3_by_m1 = t25*t26
    # d/dm2 of: spectrum
    t27 = 1/m2**2
    gap1_by_m2 = t16*(-4*t0*t27*t6 + 2*t27*t3*t5)
    t28 = gap1_by_m2/2
    omega1_by_m2 = t21*(-t27*t3/2 + t28)
    t29 = 1/lib.sqrt(m2)**3
    omega2_by_m2 = -omega1_by_m2*t22 - t11*t12*t21*t29*t9
    p1_by_m2 = t15*t27*t3/2 - t24*t28
    t30 = gap1_by_m2*t23
    p2_by_m2 = t1*t30
    p3_by_m2 = k1*t15*t27 + t26*t30
    omega3_by_m2 = -t18*t29/2
    # d/dk1 of: spectrum
    gap1_by_k1 = t16*(8*t1*t2 + t5*(2*t0 - 2*t2))
    t31 = gap1_by_k1/2
    t32 = t2/2
    omega1_by_k1 = t21*(t0/2 + t31 + t32)
    omega2_by_k1 = -omega1_by_k1*t22 + t10*t11*t8*t9/(2*t12)
    p1_by_k1 = t16*(t0 - t2) - t24*t31
    t33 = gap1_by_k1*t23
    p2_by_k1 = -t0*t15 + t1*t33
    p3_by_k1 = -t17 + t26*t33
    omega3_by_k1 = t10/(2*t18)
    # d/dk2 of: spectrum
    gap1_by_k2 = -t17*t5
    t34 = gap1_by_k2/2
    omega1_by_k2 = t21*(t32 + t34)
    omega2_by_k2 = -omega1_by_k2*t22 + t10*t12*t8*t9/(2*t11)
    p1_by_k2 = -t15*t32 - t24*t34
    t35 = gap1_by_k2*t23
    p2_by_k2 = t1*t35
    p3_by_k2 = t26*t35
    spectrum_derivatives = [[gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2], [0, omega3_by_m2, omega3_by_k1, omega3_by_k1]]
    return spectrum, spectrum_derivatives


def flow_free(parameters, spectrum, time, state, *, lib):
    """State after a time in free.

    Takes parameters (5): m1, m2, k1, k2, r.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 77. Intermediate terms: 15.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = 1 - p1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 + t6*t7
    t11 = p1*t7 + t6*t8
    t12 = -p3*t7 + p3*t8
    t13 = omega2*t4
    t14 = omega1*t1
    return [t10*x1 + t9*x2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5), t11*x2 + t12*x1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6), t10*v1 + t9*v2 + x1*(-p1*t14 - t13*t6) + x2*(p2*t13 - p2*t14), t11*v2 + t12*v1 + x1*(p3*t13 - p3*t14) + x2*(-p1*t13 - t14*t6)]


def flow_contact(parameters, spectrum, time, state, *, lib):
    """State after a time in contact.

    Takes parameters (5): m1, m2, k1, k2, r.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 31. Intermediate terms: 8.
    """
    [_, _, k1, k2, _] = parameters
    [_, _, _, _, _, _, omega3] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = 1/(k1 + k2)
    t1 = k1*t0
    t2 = omega3*time
    t3 = lib.sin(t2)
    t4 = t3/omega3
    t5 = lib.cos(t2)
    t6 = k1*t0 - t1*t5
    t7 = omega3*t3
    return [time*v1 + x1, t4*v2 + t5*x2 + t6*x1 + v1*(-t1*t4 + t1*time), v1, t1*t7*x1 + t5*v2 + t6*v1 - t7*x2]


def fields(parameters, *, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives fields (8, 5).
    Operations: 7. Intermediate terms: 4.
    """
    [m1, m2, k1, k2, _] = parameters
    # fields
    t0 = k1/m1
    t1 = 1/m2
    t2 = k1*t1
    t3 = -t1*(k1 + k2)
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t0, t0, 0, 0, 0], [t2, t3, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t2, t3, 0, 0, 0]]


def rows(parameters, *, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives rows (5, 5).
    Operations: 3. Intermediate terms: 0.
    """
    [_, _, k1, _, _] = parameters
    return [[1, 0, 0, 0, -1], [k1, -k1, 0, 0, 0], [0, 0, 1, 0, 0], [-k1, k1, 0, 0, 0], [0, 0, 0, 0, 0]]


def resets(parameters, *, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives resets (12, 5).
    Operations: 1. Intermediate terms: 0.
    """
    [_, _, _, _, r] = parameters
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, -r, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 1], [0, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 1, 0]]


def modes(parameters, spectrum, *, lib, outputs=2):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives exponents (5, 2).
    Gives coefficients (36, 5).
    Operations: 40. Intermediate terms: 5.
    """
    [_, _, k1, k2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    exponents = [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3]]
    if outputs == 1:
        return exponents
    # coefficients
    t0 = 1 - p1
    t1 = 1/omega1
    t2 = 1/omega2
    t3 = k1/(k1 + k2)
    t4 = 1/omega3
    coefficients = [[0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, 0], [p3, t0, 0, 0, 0], [0, 0, p1, p2, 0], [0, 0, p3, t0, 0], [0, 0, p1*t1, p2*t1, 0], [0, 0, p3*t1, t0*t1, 0], [-omega1*p1, -omega1*p2, 0, 0, 0], [-omega1*p3, -omega1*t0, 0, 0, 0], [t0, -p2, 0, 0, 0], [-p3, p1, 0, 0, 0], [0, 0, t0, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t0*t2, -p2*t2, 0], [0, 0, -p3*t2, p1*t2, 0], [-omega2*t0, omega2*p2, 0, 0, 0], [omega2*p3, -omega2*p1, 0, 0, 0], [1, 0, 0, 0, 0], [t3, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, t3, 0, 0], [0, 0, 1, 0, 0], [0, 0, t3, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-t3, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, -t3, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t3*t4, t4, 0], [0, 0, 0, 0, 0], [omega3*t3, -omega3, 0, 0, 0]]
    return exponents, coefficients


def one_impact_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Takes spectrum_derivatives (7, 4): gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2,
        omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega2_by_m1, omega2_by_m2,
        omega2_by_k1, omega2_by_k2, p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2, p2_by_m1,
        p2_by_m2, p2_by_k1, p2_by_k2, p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, omega3_by_m1,
        omega3_by_m2, omega3_by_k1, omega3_by_k2, for parameter_jacobian.
    Gives residual (2).
    Gives jacobian (2, 2).
    Gives parameter_jacobian (2, 5).
    Operations: 239. Intermediate terms: 62.
    """
    [_, _, _, _, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [y, u] = unknowns
    # half of T
    half_T = T/2
    # functions of half_T in free
    t0 = half_T*omega1
    cos_omega1_half_T = lib.cos(t0)
    sin_omega1_half_T = lib.sin(t0)
    t1 = half_T*omega2
    cos_omega2_half_T = lib.cos(t1)
    sin_omega2_half_T = lib.sin(t1)
    # residual
    t2 = cos_omega1_half_T*p1
    t3 = p2*y
    t4 = p1 - 1
    t5 = t3 + t4
    t6 = omega2*sin_omega2_half_T
    t7 = cos_omega2_half_T*t4
    t8 = p1 + t3
    t9 = omega1*sin_omega1_half_T
    t10 = cos_omega1_half_T*p3
    t11 = -p1*y + p3
    t12 = -t11 - y
    t13 = cos_omega2_half_T*p3
    residual = [t2*u + t5*t6 - t7*u - t8*t9, t10*u + t11*t6 + t12*t9 - t13*u]
    if outputs == 1:
        return residual
    jacobian = [[p2*t6 - p2*t9, t2 - t7], [omega1*sin_omega1_half_T*t4 - p1*t6, t10 - t13]]
    if outputs == 2:
        return residual, jacobian
    [[_, _, _, _], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2], [_, _, _, _]] = spectrum_derivatives
    # d/dm1 of: functions of half_T in free
    t14 = half_T*omega1_by_m1
    cos_omega1_half_T_by_m1 = -sin_omega1_half_T*t14
    sin_omega1_half_T_by_m1 = cos_omega1_half_T*t14
    t15 = half_T*omega2_by_m1
    cos_omega2_half_T_by_m1 = -sin_omega2_half_T*t15
    sin_omega2_half_T_by_m1 = cos_omega2_half_T*t15
    # d/dm2 of: functions of half_T in free
    t16 = half_T*omega1_by_m2
    cos_omega1_half_T_by_m2 = -sin_omega1_half_T*t16
    sin_omega1_half_T_by_m2 = cos_omega1_half_T*t16
    t17 = half_T*omega2_by_m2
    cos_omega2_half_T_by_m2 = -sin_omega2_half_T*t17
    sin_omega2_half_T_by_m2 = cos_omega2_half_T*t17
    # d/dk1 of: functions of half_T in free
    t18 = half_T*omega1_by_k1
    cos_omega1_half_T_by_k1 = -sin_omega1_half_T*t18
    sin_omega1_half_T_by_k1 = cos_omega1_half_T*t18
    t19 = half_T*omega2_by_k1
    cos_omega2_half_T_by_k1 = -sin_omega2_half_T*t19
    sin_omega2_half_T_by_k1 = cos_omega2_half_T*t19
    # d/dk2 of: functions of half_T in free
    t20 = half_T*omega1_by_k2
    cos_omega1_half_T_by_k2 = -sin_omega1_half_T*t20
    sin_omega1_half_T_by_k2 = cos_omega1_half_T*t20
    t21 = half_T*omega2_by_k2
    cos_omega2_half_T_by_k2 = -sin_omega2_half_T*t21
    sin_omega2_half_T_by_k2 = cos_omega2_half_T*t21
    # d/dT of: functions of half_T in free
    t22 = omega1/2
    cos_omega1_half_T_by_T = -sin_omega1_half_T*t22
    sin_omega1_half_T_by_T = cos_omega1_half_T*t22
    t23 = omega2/2
    cos_omega2_half_T_by_T = -sin_omega2_half_T*t23
    sin_omega2_half_T_by_T = cos_omega2_half_T*t23
    # parameter_jacobian
    t24 = t6*y - t9*y
    t25 = cos_omega1_half_T*u - cos_omega2_half_T*u + t6 - t9
    t26 = p1*u
    t27 = sin_omega2_half_T*t5
    t28 = omega2*t5
    t29 = t4*u
    t30 = sin_omega1_half_T*t8
    t31 = omega1*t8
    t32 = p3*u
    t33 = sin_omega1_half_T*t12
    t34 = omega1*t12
    t35 = -sin_omega2_half_T*t11
    t36 = -omega2*t11
    parameter_jacobian = [[cos_omega1_half_T_by_m1*t26 - cos_omega2_half_T_by_m1*t29 - omega1_by_m1*t30 + omega2_by_m1*t27 + p1_by_m1*t25 + p2_by_m1*t24 - sin_omega1_half_T_by_m1*t31 + sin_omega2_half_T_by_m1*t28, cos_omega1_half_T_by_m2*t26 - cos_omega2_half_T_by_m2*t29 - omega1_by_m2*t30 + omega2_by_m2*t27 + p1_by_m2*t25 + p2_by_m2*t24 - sin_omega1_half_T_by_m2*t31 + sin_omega2_half_T_by_m2*t28, cos_omega1_half_T_by_k1*t26 - cos_omega2_half_T_by_k1*t29 - omega1_by_k1*t30 + omega2_by_k1*t27 + p1_by_k1*t25 + p2_by_k1*t24 - sin_omega1_half_T_by_k1*t31 + sin_omega2_half_T_by_k1*t28, cos_omega1_half_T_by_k2*t26 - cos_omega2_half_T_by_k2*t29 - omega1_by_k2*t30 + omega2_by_k2*t27 + p1_by_k2*t25 + p2_by_k2*t24 - sin_omega1_half_T_by_k2*t31 + sin_omega2_half_T_by_k2*t28, cos_omega1_half_T_by_T*t26 - cos_omega2_half_T_by_T*t29 - sin_omega1_half_T_by_T*t31 + sin_omega2_half_T_by_T*t28], [cos_omega1_half_T_by_m1*t32 - cos_omega2_half_T_by_m1*t32 + omega1_by_m1*t33 - omega2_by_m1*t35 - p1_by_m1*t24 + p3_by_m1*t25 + sin_omega1_half_T_by_m1*t34 - sin_omega2_half_T_by_m1*t36, cos_omega1_half_T_by_m2*t32 - cos_omega2_half_T_by_m2*t32 + omega1_by_m2*t33 - omega2_by_m2*t35 - p1_by_m2*t24 + p3_by_m2*t25 + sin_omega1_half_T_by_m2*t34 - sin_omega2_half_T_by_m2*t36, cos_omega1_half_T_by_k1*t32 - cos_omega2_half_T_by_k1*t32 + omega1_by_k1*t33 - omega2_by_k1*t35 - p1_by_k1*t24 + p3_by_k1*t25 + sin_omega1_half_T_by_k1*t34 - sin_omega2_half_T_by_k1*t36, cos_omega1_half_T_by_k2*t32 - cos_omega2_half_T_by_k2*t32 + omega1_by_k2*t33 - omega2_by_k2*t35 - p1_by_k2*t24 + p3_by_k2*t25 + sin_omega1_half_T_by_k2*t34 - sin_omega2_half_T_by_k2*t36, cos_omega1_half_T_by_T*t32 - cos_omega2_half_T_by_T*t32 + sin_omega1_half_T_by_T*t34 - sin_omega2_half_T_by_T*t36]]
    return residual, jacobian, parameter_jacobian


def one_impact_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Takes spectrum_derivatives (7, 4): gap1_by_m1, gap1_by_m2, gap1_by_k1, gap1_by_k2,
        omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2, omega2_by_m1, omega2_by_m2,
        omega2_by_k1, omega2_by_k2, p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2, p2_by_m1,
        p2_by_m2, p2_by_k1, p2_by_k2, p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2, omega3_by_m1,
        omega3_by_m2, omega3_by_k1, omega3_by_k2, for trace_gradient.
    Gives trace.
    Gives trace_gradient (7).
    Operations: 367. Intermediate terms: 95.
    """
    [m1, m2, k1, k2, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [y, u] = unknowns
    # functions of T in free
    t0 = T*omega1
    cos_omega1_T = lib.cos(t0)
    sin_omega1_T = lib.sin(t0)
    t1 = T*omega2
    cos_omega2_T = lib.cos(t1)
    sin_omega2_T = lib.sin(t1)
    # free for T, until first-reaches-stop
    t2 = 1/omega1
    t3 = sin_omega1_T*t2
    t4 = p1 - 1
    t5 = 1/omega2
    t6 = sin_omega2_T*t5
    carried_x1_1_by_u = p1*t3 - t4*t6
    carried_x1_1_by_y = cos_omega1_T*p2 - cos_omega2_T*p2
    carried_v1_1_by_u = cos_omega1_T*p1 - cos_omega2_T*t4
    x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_y*y
    t7 = p3*t3 - p3*t6
    carried_x2_1_by_y = -cos_omega1_T*t4 + cos_omega2_T*p1
    t8 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = carried_x2_1_by_y*y + t7*u + t8
    t9 = omega2*sin_omega2_T
    t10 = omega1*sin_omega1_T
    t11 = -p2*t10 + p2*t9
    t12 = omega1*p1
    t13 = -omega2*t4
    v1_1 = carried_v1_1_by_u*u - sin_omega1_T*t12 - sin_omega2_T*t13 + t11*y
    t14 = -p1*t9 + t10*t4
    t15 = omega2*p3
    t16 = omega1*p3
    v2_1 = -sin_omega1_T*t16 + sin_omega2_T*t15 + t14*y + t8*u
    # Phi along T
    carried_x1_1_by_w = p2*t3 - p2*t6
    # derivatives of the time to the boundary after T
    t17 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t17
    delay_T_by_u = -carried_x1_1_by_u*t17
    delay_T_by_w = -carried_x1_1_by_w*t17
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    t18 = 1/m1
    t19 = t18*x1_1
    slope_by_delay_T_by_u = -k1*t18*x2_1 + k1*t19
    v1_1_on_boundary_by_u = -carried_v1_1_by_u + delay_T_by_u*slope_by_delay_T_by_u
    t20 = 1/m2
    t21 = t20*x1_1
    t22 = k1 + k2
    t23 = t20*x2_1
    slope_by_delay_T_by_w = k1*t21 - t22*t23
    v2_1_on_boundary_by_w = carried_x2_1_by_y + delay_T_by_w*slope_by_delay_T_by_w
    trace = v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y
    if outputs == 1:
        return trace
    [[_, _, _, _], [omega1_by_m1, omega1_by_m2, omega1_by_k1, omega1_by_k2], [omega2_by_m1, omega2_by_m2, omega2_by_k1, omega2_by_k2], [p1_by_m1, p1_by_m2, p1_by_k1, p1_by_k2], [p2_by_m1, p2_by_m2, p2_by_k1, p2_by_k2], [p3_by_m1, p3_by_m2, p3_by_k1, p3_by_k2], [_, _, _, _]] = spectrum_derivatives
    # back through: Phi along T
    slope_by_carried_x1_1_by_w = -slope_by_delay_T_by_w*t17
    slope_by_carried_x1_1_by_u = -slope_by_delay_T_by_u*t17
    slope_by_carried_x1_1_by_y = -t17*v2_1
    # back through: free for T, until first-reaches-stop
    t24 = 1/v1_1**2
    slope_by_v1_1 = carried_x1_1_by_u*slope_by_delay_T_by_u*t24 + carried_x1_1_by_w*slope_by_delay_T_by_w*t24 + carried_x1_1_by_y*t24*v2_1
    t25 = delay_T_by_u*k1*t18
    t26 = delay_T_by_w*t20
    slope_by_x2_1 = -t22*t26 - t25
    slope_by_x1_1 = k1*t26 + t25
    # back through: functions of T in free
    t27 = p1*y
    t28 = p2*y
    t29 = -t4*t5
    t30 = p2*slope_by_carried_x1_1_by_w
    t31 = slope_by_x1_1*u
    t32 = p3*u
    t33 = slope_by_x2_1*t32
    slope_by_sin_omega2_T = delay_T_by_y*(-omega2*t27 + t15) + slope_by_carried_x1_1_by_u*t29 + slope_by_v1_1*(omega2*t28 - t13) + t29*t31 - t30*t5 - t33*t5
    t34 = 3*p1
    t35 = p2*slope_by_carried_x1_1_by_y
    t36 = slope_by_v1_1*u
    t37 = delay_T_by_y*t32
    slope_by_cos_omega2_T = slope_by_x1_1*(-t28 - t4) + slope_by_x2_1*(p1*y - p3) + t34 - t35 - t36*t4 - t37 - 1
    t38 = -t4*y
    t39 = p1*t2
    slope_by_sin_omega1_T = delay_T_by_y*(-omega1*t38 - t16) + slope_by_carried_x1_1_by_u*t39 + slope_by_v1_1*(-omega1*t28 - t12) + t2*t30 + t2*t33 + t31*t39
    slope_by_cos_omega1_T = p1*t36 + slope_by_x1_1*(p1 + t28) + slope_by_x2_1*(p3 + t38) - t34 + t35 + t37 + 2
    # trace_gradient
    t40 = cos_omega1_T - cos_omega2_T
    t41 = -t10 + t9
    t42 = t40*u + t41
    t43 = t3 - t6
    t44 = t40 + t43*u
    t45 = delay_T_by_y*t42 + slope_by_x2_1*t44
    t46 = slope_by_carried_x1_1_by_w*t43 + slope_by_carried_x1_1_by_y*t40 + slope_by_v1_1*t41*y + slope_by_x1_1*t40*y
    t47 = -3*cos_omega1_T + 3*cos_omega2_T - delay_T_by_y*t41*y + slope_by_carried_x1_1_by_u*t43 + slope_by_v1_1*t42 + slope_by_x1_1*t44 - slope_by_x2_1*t40*y
    t48 = p3*sin_omega2_T
    t49 = -sin_omega2_T*t4
    t50 = cos_omega2_T*slope_by_sin_omega2_T
    t51 = sin_omega2_T*slope_by_cos_omega2_T
    t52 = 1/omega2**2
    t53 = t49*t52
    t54 = slope_by_x2_1*u
    t55 = T*t50 - T*t51 + delay_T_by_y*(-sin_omega2_T*t27 + t48) + sin_omega2_T*t30*t52 - slope_by_carried_x1_1_by_u*t53 + slope_by_v1_1*(sin_omega2_T*t28 - t49) - t31*t53 + t48*t52*t54
    t56 = p3*sin_omega1_T
    t57 = p1*sin_omega1_T
    t58 = sin_omega1_T*slope_by_cos_omega1_T
    t59 = 1/omega1**2
    t60 = t57*t59
    t61 = T*cos_omega1_T*slope_by_sin_omega1_T - T*t58 + delay_T_by_y*(-sin_omega1_T*t38 - t56) - sin_omega1_T*t30*t59 - slope_by_carried_x1_1_by_u*t60 + slope_by_v1_1*(-sin_omega1_T*t28 - t57) - t31*t60 - t54*t56*t59
    t62 = k1/m1**2
    t63 = 1/m2**2
    trace_gradient = [carried_x1_1_by_y*slope_by_x1_1 + carried_x2_1_by_y*slope_by_x2_1 + delay_T_by_y*t14 + slope_by_v1_1*t11, carried_v1_1_by_u*slope_by_v1_1 + carried_x1_1_by_u*slope_by_x1_1 + delay_T_by_y*t8 + slope_by_x2_1*t7, -delay_T_by_u*(t62*x1_1 - t62*x2_1) + omega1_by_m1*t61 + omega2_by_m1*t55 + p1_by_m1*t47 + p2_by_m1*t46 + p3_by_m1*t45, delay_T_by_w*(-k1*t63*x1_1 + t22*t63*x2_1) + omega1_by_m2*t61 + omega2_by_m2*t55 + p1_by_m2*t47 + p2_by_m2*t46 + p3_by_m2*t45, -delay_T_by_u*(t18*x2_1 - t19) + delay_T_by_w*(t21 - t23) + omega1_by_k1*t61 + omega2_by_k1*t55 + p1_by_k1*t47 + p2_by_k1*t46 + p3_by_k1*t45, -delay_T_by_w*t23 + omega1_by_k2*t61 + omega2_by_k2*t55 + p1_by_k2*t47 + p2_by_k2*t46 + p3_by_k2*t45, cos_omega1_T*omega1*slope_by_sin_omega1_T - omega1*t58 + omega2*t50 - omega2*t51]
    return trace, trace_gradient


def one_impact_passage(parameters, spectrum, unknowns, *, lib, outputs=3):
    """State at the start and behind each transition. Boundaries along the phases: constant,
    slope, cosine and sine amplitudes, one after the other; and the frequencies of each
    phase.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives states (2, 4).
    Gives coefficients (6).
    Gives frequencies (2).
    Operations: 70. Intermediate terms: 21.
    """
    [_, _, _, _, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [y, u] = unknowns
    # functions of T in free
    t0 = T*omega1
    cos_omega1_T = lib.cos(t0)
    sin_omega1_T = lib.sin(t0)
    t1 = T*omega2
    cos_omega2_T = lib.cos(t1)
    sin_omega2_T = lib.sin(t1)
    # free for T, until first-reaches-stop
    t2 = 1/omega1
    t3 = sin_omega1_T*t2
    t4 = p1 - 1
    t5 = 1/omega2
    t6 = sin_omega2_T*t5
    t7 = cos_omega1_T*p1 - cos_omega2_T*t4
    x1_1 = t7 + u*(p1*t3 - t4*t6) + y*(cos_omega1_T*p2 - cos_omega2_T*p2)
    t8 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t8 + u*(p3*t3 - p3*t6) + y*(-cos_omega1_T*t4 + cos_omega2_T*p1)
    t9 = omega2*sin_omega2_T
    t10 = omega1*sin_omega1_T
    v1_1 = -p1*t10 + t4*t9 + t7*u + y*(-p2*t10 + p2*t9)
    v2_1 = -p3*t10 + p3*t9 + t8*u + y*(-p1*t9 + t10*t4)
    # transition to free
    v1_1_reset = -v1_1
    states = [[1, y, u, 0], [x1_1, x2_1, v1_1_reset, v2_1]]
    if outputs == 1:
        return states
    # coefficients
    t11 = p2*y
    coefficients = [-1, 0, p1 + t11, -t11 - t4, p1*t2*u, -t4*t5*u]
    if outputs == 2:
        return states, coefficients
    frequencies = [omega1, omega2]
    return states, coefficients, frequencies


def one_impact_linearisation(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Jacobian of the Poincare map in the section's coordinates; saltation matrices, one
    below the other; monodromy matrix.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives poincare_jacobian (3, 3).
    Gives saltations (4, 4).
    Gives monodromy (4, 4).
    Operations: 137. Intermediate terms: 61.
    """
    [m1, m2, k1, k2, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [y, u] = unknowns
    # functions of T in free
    t0 = T*omega1
    cos_omega1_T = lib.cos(t0)
    sin_omega1_T = lib.sin(t0)
    t1 = T*omega2
    cos_omega2_T = lib.cos(t1)
    sin_omega2_T = lib.sin(t1)
    # free for T, until first-reaches-stop
    t2 = sin_omega1_T/omega1
    t3 = 1 - p1
    t4 = sin_omega2_T/omega2
    carried_x1_1_by_u = p1*t2 + t3*t4
    carried_x1_1_by_y = cos_omega1_T*p2 - cos_omega2_T*p2
    carried_v1_1_by_u = cos_omega1_T*p1 + cos_omega2_T*t3
    x1_1 = carried_v1_1_by_u + carried_x1_1_by_u*u + carried_x1_1_by_y*y
    carried_x2_1_by_u = p3*t2 - p3*t4
    carried_x2_1_by_y = cos_omega1_T*t3 + cos_omega2_T*p1
    carried_v2_1_by_u = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = carried_v2_1_by_u + carried_x2_1_by_u*u + carried_x2_1_by_y*y
    t5 = omega2*sin_omega2_T
    t6 = omega1*sin_omega1_T
    carried_v1_1_by_y = p2*t5 - p2*t6
    t7 = p1*t6 + t3*t5
    v1_1 = carried_v1_1_by_u*u + carried_v1_1_by_y*y - t7
    carried_v2_1_by_y = -p1*t5 - t3*t6
    phi_1_30 = p3*t5 - p3*t6
    v2_1 = carried_v2_1_by_u*u + carried_v2_1_by_y*y + phi_1_30
    # Phi along T
    carried_x1_1_by_w = p2*t2 - p2*t4
    carried_x2_1_by_w = p1*t4 + t2*t3
    # derivatives of the time to the boundary after T
    t8 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t8
    delay_T_by_u = -carried_x1_1_by_u*t8
    delay_T_by_w = -carried_x1_1_by_w*t8
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_T_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_T_by_w*v2_1
    t9 = 1/m1
    before_v1_1 = -k1*t9*x1_1 + k1*t9*x2_1
    v1_1_on_boundary_by_y = -before_v1_1*delay_T_by_y - carried_v1_1_by_y
    v1_1_on_boundary_by_u = -before_v1_1*delay_T_by_u - carried_v1_1_by_u
    v1_1_on_boundary_by_w = -before_v1_1*delay_T_by_w - carried_x1_1_by_y
    t10 = 1/m2
    before_v2_1 = k1*t10*x1_1 - t10*x2_1*(k1 + k2)
    v2_1_on_boundary_by_y = before_v2_1*delay_T_by_y + carried_v2_1_by_y
    v2_1_on_boundary_by_u = before_v2_1*delay_T_by_u + carried_v2_1_by_u
    v2_1_on_boundary_by_w = before_v2_1*delay_T_by_w + carried_x2_1_by_y
    poincare_jacobian = [[x2_1_on_boundary_by_y, x2_1_on_boundary_by_u, x2_1_on_boundary_by_w], [v1_1_on_boundary_by_y, v1_1_on_boundary_by_u, v1_1_on_boundary_by_w], [v2_1_on_boundary_by_y, v2_1_on_boundary_by_u, v2_1_on_boundary_by_w]]
    if outputs == 1:
        return poincare_jacobian
    # transition to free
    v1_1_reset = -v1_1
    # saltations
    t11 = t8*(-v1_1 + v1_1_reset) + 1
    t12 = 2*before_v1_1
    t13 = 0
    saltations = [[t11, 0, 0, 0], [0, 1, 0, 0], [t12*t8, 0, -1, 0], [t13, 0, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 1
    phi_1_20 = -t7
    # saltation of phase 1
    saltation_1_00 = carried_v1_1_by_u*t11
    saltation_1_01 = carried_x1_1_by_y*t11
    saltation_1_02 = carried_x1_1_by_u*t11
    saltation_1_03 = carried_x1_1_by_w*t11
    saltation_1_20 = carried_v1_1_by_u*t12*t8 - phi_1_20
    saltation_1_21 = -carried_v1_1_by_y + carried_x1_1_by_y*t12*t8
    saltation_1_22 = -carried_v1_1_by_u + carried_x1_1_by_u*t12*t8
    saltation_1_23 = carried_x1_1_by_w*t12*t8 - carried_x1_1_by_y
    saltation_1_30 = carried_v1_1_by_u*t13 + phi_1_30
    saltation_1_31 = carried_v2_1_by_y + carried_x1_1_by_y*t13
    saltation_1_32 = carried_v2_1_by_u + carried_x1_1_by_u*t13
    saltation_1_33 = carried_x1_1_by_w*t13 + carried_x2_1_by_y
    monodromy = [[saltation_1_00, saltation_1_01, saltation_1_02, saltation_1_03], [carried_v2_1_by_u, carried_x2_1_by_y, carried_x2_1_by_u, carried_x2_1_by_w], [saltation_1_20, saltation_1_21, saltation_1_22, saltation_1_23], [saltation_1_30, saltation_1_31, saltation_1_32, saltation_1_33]]
    return poincare_jacobian, saltations, monodromy


def one_impact_reduced(parameters, spectrum, *, lib, outputs=2):
    """All unknowns; how singular the linear equations for them are: 0 if they are.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives unknowns (2).
    Gives determinants (1).
    Operations: 77. Intermediate terms: 28.
    """
    [_, _, _, _, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    # half of T
    half_T = T/2
    # functions of half_T in free
    t0 = half_T*omega1
    cos_omega1_half_T = lib.cos(t0)
    sin_omega1_half_T = lib.sin(t0)
    t1 = half_T*omega2
    cos_omega2_half_T = lib.cos(t1)
    sin_omega2_half_T = lib.sin(t1)
    # coefficients of the linear equations
    t2 = omega2*sin_omega2_half_T
    t3 = omega1*sin_omega1_half_T
    coefficient11 = p2*t2 - p2*t3
    t4 = p1 - 1
    coefficient12 = cos_omega1_half_T*p1 - cos_omega2_half_T*t4
    coefficient21 = omega1*sin_omega1_half_T*t4 - p1*t2
    coefficient22 = cos_omega1_half_T*p3 - cos_omega2_half_T*p3
    # right-hand sides of the linear equations
    right1 = p1*t3 - t2*t4
    right2 = omega1*p3*sin_omega1_half_T - p3*t2
    # determinant of the linear equations
    determinant = coefficient11*coefficient22 - coefficient12*coefficient21
    # numerators of Cramer's rule
    numerator1 = -coefficient12*right2 + coefficient22*right1
    numerator2 = coefficient11*right2 - coefficient21*right1
    # y, u by Cramer's rule
    t5 = 1/determinant
    y = numerator1*t5
    u = numerator2*t5
    unknowns = [y, u]
    if outputs == 1:
        return unknowns
    # determinants
    t6 = p1**2
    t7 = half_T**2
    t8 = 2*t7
    t9 = omega2**4*t8/(omega2**2*t7 + 1)
    t10 = omega1**4*t8/(omega1**2*t7 + 1)
    t11 = p2**2
    determinants = [determinant/(lib.sqrt(2*p3**2 + t10*t4**2 + t6*t9)*lib.sqrt(t10*t11 + t11*t9 + t4**2 + t6))]
    return unknowns, determinants
