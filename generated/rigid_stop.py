# Generated; do not edit.
# Source: nonsmooth.derive.systems.rigid_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation f03cf19002c3a6c5
"""Kernels and tables of the system rigid-stop, over any arithmetic ``lib``."""

DERIVATION = "f03cf19002c3a6c5"

SYSTEM = {'name': 'rigid-stop',
 'description': 'two coupled oscillators, the first in front of a rigid stop (Sec. 2.1)',
 'states': ['x1', 'x2', 'v1', 'v2'],
 'parameters': [{'name': 'm1',
                 'description': "first mass, in the user's consistent units",
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'm2',
                 'description': 'second mass',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'k1',
                 'description': 'stiffness of the spring between the masses',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'k2',
                 'description': 'stiffness of the spring between the second mass and the '
                                'ground',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'r',
                 'description': 'coefficient of restitution, nondimensional',
                 'lower': '0',
                 'upper': '1',
                 'closed': True,
                 'upper_closed': True}],
 'constraints': [],
 'configurations': {'free': [{'name': 'first-reaches-stop', 'acts_when': 'exceeded'}],
                    'contact': [{'name': 'first-leaves-stop', 'acts_when': 'exceeded'}]},
 'spectrum': ['gap1', 'omega1', 'omega2', 'p1', 'p2', 'p3', 'omega3'],
 'spectrum_parameters': ['k1', 'k2', 'm1', 'm2'],
 'modes': {'free': [{'length': 1, 'oscillates': False},
                    {'length': 1, 'oscillates': True},
                    {'length': 1, 'oscillates': True}],
           'contact': [{'length': 2, 'oscillates': False}, {'length': 1, 'oscillates': True}]},
 'forcing': [],
 'coordinates': [('x1', 'v1'), ('x2', 'v2')],
 'held': {'free': [], 'contact': ['x1']},
 'constraint_rows': {'free': [], 'contact': [2, 0]},
 'boundary_rows': {'free': [0], 'contact': [1]},
 'transitions': [{'source': 'free',
                  'boundaries': ['first-reaches-stop'],
                  'conditions': [(2, 'contact', True)],
                  'reset': 1,
                  'target': 'free'},
                 {'source': 'free',
                  'boundaries': ['first-reaches-stop'],
                  'conditions': [(3, 'contact', True)],
                  'reset': 2,
                  'target': 'contact'},
                 {'source': 'free',
                  'boundaries': ['first-reaches-stop'],
                  'conditions': [],
                  'reset': 0,
                  'target': 'free'},
                 {'source': 'contact',
                  'boundaries': ['first-leaves-stop'],
                  'conditions': [],
                  'reset': 0,
                  'target': 'free'}],
 'contacts': {'stop': {'forces': {'contact': 1}, 'velocity': 2, 'surface': 4}}}

ORBITS = {'one-impact': {'derived': True,
                'phases': [('free', 'first-reaches-stop', 'T')],
                'states': ['x1', 'x2', 'v1', 'v2'],
                'parameters': [{'name': 'm1',
                                'description': "first mass, in the user's consistent units",
                                'lower': '0',
                                'upper': None,
                                'closed': False,
                                'upper_closed': False},
                               {'name': 'm2',
                                'description': 'second mass',
                                'lower': '0',
                                'upper': None,
                                'closed': False,
                                'upper_closed': False},
                               {'name': 'k1',
                                'description': 'stiffness of the spring between the masses',
                                'lower': '0',
                                'upper': None,
                                'closed': False,
                                'upper_closed': False},
                               {'name': 'k2',
                                'description': 'stiffness of the spring between the second '
                                               'mass and the ground',
                                'lower': '0',
                                'upper': None,
                                'closed': False,
                                'upper_closed': False},
                               {'name': 'T',
                                'description': 'period of the orbit',
                                'lower': '0',
                                'upper': None,
                                'closed': False,
                                'upper_closed': False}],
                'open_parameters': [],
                'other_parameters': [{'name': 'r',
                                      'description': 'coefficient of restitution, '
                                                     'nondimensional',
                                      'lower': '0',
                                      'upper': '1',
                                      'closed': True,
                                      'upper_closed': True}],
                'combined': {},
                'unknowns': ['y', 'u'],
                'dwell_times': ['T'],
                'durations': [{'T': 1}],
                'equations': ['v1 vanishes halfway through free',
                              'v2 vanishes halfway through free'],
                'reduced': [],
                'eliminated': {'y': 'linear in: v1 vanishes halfway through free; v2 vanishes '
                                    'halfway through free',
                               'u': 'linear in: v1 vanishes halfway through free; v2 vanishes '
                                    'halfway through free'},
                'rank': 3,
                'section': ['y', 'u', 'w'],
                'conservative': True,
                'required': {'r': '1'},
                'vanishing': [],
                'levels': {'x1': '1'},
                'resets': [[['1', '0', '0', '0'],
                            ['0', '1', '0', '0'],
                            ['0', '0', '-1', '0'],
                            ['0', '0', '0', '1']]],
                'measures': ['y', 'u'],
                'terms': [2],
                'boundaries': [(0, 'first-reaches-stop', None, 0.0, True)],
                'reference': {'parameters': {'m1': '1',
                                             'm2': '2',
                                             'k1': '1',
                                             'k2': '5',
                                             'T': '2*pi'},
                              'guess': {'y': '0.162', 'u': '-0.372'}}}}

KERNELS = {'spectrum': ([(4,)], [(7,), (7, 4)]),
 'flow_free': ([(5,), (7,), (), (4,)], [(4,)]),
 'flow_contact': ([(5,), (7,), (), (4,)], [(4,)]),
 'fields': ([(5,)], [(8, 5)]),
 'rows': ([(5,)], [(5, 5)]),
 'resets': ([(5,)], [(12, 5)]),
 'modes': ([(5,), (7,)], [(5, 2), (36, 5)]),
 'one_impact_residual': ([(5,), (7,), (2,)], [(2,)]),
 'one_impact_jacobian': ([(5,), (7,), (2,)], [(2, 2)]),
 'one_impact_residual_and_jacobian': ([(5,), (7,), (2,)], [(2,), (2, 2)]),
 'one_impact_parameter_jacobian': ([(5,), (7,), (7, 4), (2,)], [(2, 5)]),
 'one_impact_poincare_jacobian': ([(5,), (7,), (2,)], [(3, 3)]),
 'one_impact_saltations': ([(5,), (7,), (2,)], [(4, 4)]),
 'one_impact_monodromy': ([(5,), (7,), (2,)], [(4, 4)]),
 'one_impact_trace': ([(5,), (7,), (2,)], [()]),
 'one_impact_trace_gradient': ([(5,), (7,), (7, 4), (2,)], [(7,)]),
 'one_impact_states': ([(5,), (7,), (2,)], [(2, 4)]),
 'one_impact_boundary_functions': ([(5,), (7,), (2,)], [(6,), (2,)]),
 'one_impact_flow_free': ([(5,), (7,), (), (4,)], [(4,)]),
 'one_impact_expand': ([(5,), (7,)], [(2,), (1,)])}

def spectrum(parameters, lib):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (4): k1, k2, m1, m2.
    Gives spectrum (7).
    Gives derivatives (7, 4).
    Operations: 179. Intermediate terms: 70.
    """
    [k1, k2, m1, m2] = parameters
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
    t9 = lib.sqrt(k1)
    t10 = 1/lib.sqrt(m2)
    t11 = lib.sqrt(k2)
    t12 = 1/lib.sqrt(m1)
    t13 = t10*t11*t12*t9
    omega2 = t13*t8
    t14 = 1/gap1
    t15 = t14/2
    p1 = t15*t5 + lib.rational(1, 2)
    p2 = -t1*t14
    t16 = t14*t2
    p3 = -k1*t16
    t17 = lib.sqrt(t3)
    omega3 = t10*t17
    # d/dk1 of: spectrum
    gap1_by_k1 = t15*(8*t1*t2 + t5*(2*t0 - 2*t2))
    t18 = gap1_by_k1/2
    t19 = t2/2
    t20 = t8/2
    omega1_by_k1 = t20*(t0/2 + t18 + t19)
    t21 = t13/omega1**2
    omega2_by_k1 = -omega1_by_k1*t21 + t10*t11*t12*t8/(2*t9)
    t22 = 1/gap1**2
    t23 = t22*t5
    p1_by_k1 = t15*(t0 - t2) - t18*t23
    p2_by_k1 = gap1_by_k1*k1*t0*t22 - t0*t14
    p3_by_k1 = gap1_by_k1*k1*t2*t22 - t16
    omega3_by_k1 = t10/(2*t17)
    # d/dk2 of: spectrum
    gap1_by_k2 = -t16*t5
    t25 = gap1_by_k2/2
    omega1_by_k2 = t20*(t19 + t25)
    omega2_by_k2 = -omega1_by_k2*t21 + t10*t12*t8*t9/(2*t11)
    p1_by_k2 = -t14*t19 - t23*t25
    t26 = gap1_by_k2*t22
    p2_by_k2 = t1*t26
    t27 = k1*t2
    p3_by_k2 = t26*t27
    omega3_by_k2 = omega3_by_k1
    # d/dm1 of: spectrum
    t28 = 1/m1**2
    t29 = k1*t28
    gap1_by_m1 = t15*(-t28*t7 - 2*t29*t5)
    t30 = gap1_by_m1/2
    omega1_by_m1 = t20*(-t29/2 + t30)
    omega2_by_m1 = -omega1_by_m1*t21 - t10*t11*t20*t9/lib.sqrt(m1)**3
    p1_by_m1 = -t15*t29 - t23*t30
    t31 = gap1_by_m1*t22
    p2_by_m1 = t1*t31 + t14*t29
    p3_by_m1 = t27*t31
    # d/dm2 of: spectrum
    t32 = 1/m2**2
    gap1_by_m2 = t15*(-4*t0*t32*t6 + 2*t3*t32*t5)
    t33 = gap1_by_m2/2
    t34 = t3*t32
    omega1_by_m2 = t20*(t33 - t34/2)
    t35 = 1/lib.sqrt(m2)**3
    omega2_by_m2 = -omega1_by_m2*t21 - t11*t12*t20*t35*t9
    p1_by_m2 = t15*t34 - t23*t33
    t36 = gap1_by_m2*t22
    p2_by_m2 = t1*t36
    p3_by_m2 = k1*t14*t32 + t27*t36
    omega3_by_m2 = -t17*t35/2
    return (
        [gap1, omega1, omega2, p1, p2, p3, omega3],
        [[gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [omega3_by_k1, omega3_by_k2, 0, omega3_by_m2]],
    )


def flow_free(parameters, spectrum, time, state, lib):
    """State after a time in free.

    Takes parameters (5): m1, m2, k1, k2, r.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = 1/omega1
    t1 = omega1*t
    t2 = lib.sin(t1)
    t3 = t0*t2
    t4 = 1 - p1
    t5 = omega2*t
    t6 = lib.sin(t5)
    t7 = t6/omega2
    t8 = lib.cos(t1)
    t9 = lib.cos(t5)
    t10 = p1*t8 + t4*t9
    t11 = p2*t8 - p2*t9
    t12 = p3*t8 - p3*t9
    t13 = p1*t9 + t4*t8
    t14 = omega1*t2
    t15 = omega2*t6
    return [t10*x1 + t11*x2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*x1 + t13*x2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + x1*(-p1*t14 - t15*t4) + x2*(omega2*p2*t6 - p2*t14), t12*v1 + t13*v2 + x1*(omega2*p3*t6 - p3*t14) + x2*(-p1*t15 - t14*t4)]


def flow_contact(parameters, spectrum, time, state, lib):
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
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = 1/(k1 + k2)
    t1 = k1*t0
    t2 = omega3*t
    t3 = lib.sin(t2)
    t4 = t3/omega3
    t5 = lib.cos(t2)
    t6 = k1*t0 - t1*t5
    t7 = omega3*t3
    return [t*v1 + x1, t4*v2 + t5*x2 + t6*x1 + v1*(t*t1 - t1*t4), v1, t1*t7*x1 + t5*v2 + t6*v1 - t7*x2]


def fields(parameters, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives fields (8, 5).
    Operations: 7. Intermediate terms: 4.
    """
    [m1, m2, k1, k2, _] = parameters
    # outputs
    t0 = k1/m1
    t1 = 1/m2
    t2 = k1*t1
    t3 = -t1*(k1 + k2)
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t0, t0, 0, 0, 0], [t2, t3, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t2, t3, 0, 0, 0]]


def rows(parameters, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives rows (5, 5).
    Operations: 3. Intermediate terms: 0.
    """
    [_, _, k1, _, _] = parameters
    return [[1, 0, 0, 0, -1], [k1, -k1, 0, 0, 0], [0, 0, 1, 0, 0], [-k1, k1, 0, 0, 0], [0, 0, 0, 0, 0]]


def resets(parameters, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Gives resets (12, 5).
    Operations: 1. Intermediate terms: 0.
    """
    [_, _, _, _, r] = parameters
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, -r, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 1], [0, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 1, 0]]


def modes(parameters, spectrum, lib):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (5): m1, m2, k1, k2, r.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives exponents (5, 2).
    Gives coefficients (36, 5).
    Operations: 40. Intermediate terms: 5.
    """
    [_, _, k1, k2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    # outputs
    t0 = 1 - p1
    t1 = 1/omega1
    t4 = 1/omega2
    t5 = k1/(k1 + k2)
    t7 = 1/omega3
    return (
        [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3]],
        [[0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, 0], [p3, t0, 0, 0, 0], [0, 0, p1, p2, 0], [0, 0, p3, t0, 0], [0, 0, p1*t1, p2*t1, 0], [0, 0, p3*t1, t0*t1, 0], [-omega1*p1, -omega1*p2, 0, 0, 0], [-omega1*p3, -omega1*t0, 0, 0, 0], [t0, -p2, 0, 0, 0], [-p3, p1, 0, 0, 0], [0, 0, t0, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t0*t4, -p2*t4, 0], [0, 0, -p3*t4, p1*t4, 0], [-omega2*t0, omega2*p2, 0, 0, 0], [omega2*p3, -omega2*p1, 0, 0, 0], [1, 0, 0, 0, 0], [t5, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, t5, 0, 0], [0, 0, 1, 0, 0], [0, 0, t5, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-t5, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, -t5, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t5*t7, t7, 0], [0, 0, 0, 0, 0], [omega3*t5, -omega3, 0, 0, 0]],
    )


def one_impact_residual(parameters, spectrum, unknowns, lib):
    """Switching and periodicity equations.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives residual (2).
    Operations: 34. Intermediate terms: 13.
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
    # outputs
    t2 = cos_omega1_half_T*u
    t3 = p2*y
    t4 = p1 - 1
    t5 = omega2*sin_omega2_half_T
    t6 = cos_omega2_half_T*u
    t7 = omega1*sin_omega1_half_T
    return [p1*t2 - t4*t6 + t5*(t3 + t4) - t7*(p1 + t3), p3*t2 - p3*t6 - t5*(p1*y - p3) + t7*(p1*y - p3 - y)]


def one_impact_jacobian(parameters, spectrum, unknowns, lib):
    """Derivatives of the equations by the unknowns.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives jacobian (2, 2).
    Operations: 23. Intermediate terms: 9.
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
    # outputs
    t2 = omega1*sin_omega1_half_T
    t3 = p1 - 1
    return [[omega2*p2*sin_omega2_half_T - p2*t2, cos_omega1_half_T*p1 - cos_omega2_half_T*t3], [-omega2*p1*sin_omega2_half_T + t2*t3, cos_omega1_half_T*p3 - cos_omega2_half_T*p3]]


def one_impact_residual_and_jacobian(parameters, spectrum, unknowns, lib):
    """Equations and their derivatives by the unknowns, sharing all intermediate terms.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives residual (2).
    Gives jacobian (2, 2).
    Operations: 45. Intermediate terms: 15.
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
    # outputs
    t2 = cos_omega1_half_T*p1
    t3 = p2*y
    t4 = p1 - 1
    t5 = omega2*sin_omega2_half_T
    t6 = cos_omega2_half_T*t4
    t7 = omega1*sin_omega1_half_T
    t8 = cos_omega1_half_T*p3
    t9 = cos_omega2_half_T*p3
    return (
        [t2*u + t5*(t3 + t4) - t6*u - t7*(p1 + t3), -t5*(p1*y - p3) + t7*(p1*y - p3 - y) + t8*u - t9*u],
        [[omega2*p2*sin_omega2_half_T - p2*t7, t2 - t6], [-p1*t5 + t4*t7, t8 - t9]],
    )


def one_impact_parameter_jacobian(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Total derivatives of the equations by the parameters, through the spectrum too.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 4): gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2,
        omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2, omega2_by_k1, omega2_by_k2,
        omega2_by_m1, omega2_by_m2, p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2, p2_by_k1,
        p2_by_k2, p2_by_m1, p2_by_m2, p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_m1, omega3_by_m2.
    Takes unknowns (2): y, u.
    Gives parameter_jacobian (2, 5).
    Operations: 212. Intermediate terms: 57.
    """
    [_, _, _, _, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [[_, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [_, _, _, _]] = spectrum_derivatives
    [y, u] = unknowns
    # half of T
    half_T = T/2
    # functions of half_T in free
    t0 = half_T*omega1
    cos_omega1_half_T = lib.cos(t0)
    sin_omega1_half_T = lib.sin(t0)
    t3 = half_T*omega2
    cos_omega2_half_T = lib.cos(t3)
    sin_omega2_half_T = lib.sin(t3)
    # d/dm1 of: functions of half_T in free
    t6 = half_T*omega1_by_m1
    cos_omega1_half_T_by_m1 = -sin_omega1_half_T*t6
    sin_omega1_half_T_by_m1 = cos_omega1_half_T*t6
    t7 = half_T*omega2_by_m1
    cos_omega2_half_T_by_m1 = -sin_omega2_half_T*t7
    sin_omega2_half_T_by_m1 = cos_omega2_half_T*t7
    # d/dm2 of: functions of half_T in free
    t8 = half_T*omega1_by_m2
    cos_omega1_half_T_by_m2 = -sin_omega1_half_T*t8
    sin_omega1_half_T_by_m2 = cos_omega1_half_T*t8
    t9 = half_T*omega2_by_m2
    cos_omega2_half_T_by_m2 = -sin_omega2_half_T*t9
    sin_omega2_half_T_by_m2 = cos_omega2_half_T*t9
    # d/dk1 of: functions of half_T in free
    t10 = half_T*omega1_by_k1
    cos_omega1_half_T_by_k1 = -sin_omega1_half_T*t10
    sin_omega1_half_T_by_k1 = cos_omega1_half_T*t10
    t11 = half_T*omega2_by_k1
    cos_omega2_half_T_by_k1 = -sin_omega2_half_T*t11
    sin_omega2_half_T_by_k1 = cos_omega2_half_T*t11
    # d/dk2 of: functions of half_T in free
    t12 = half_T*omega1_by_k2
    cos_omega1_half_T_by_k2 = -sin_omega1_half_T*t12
    sin_omega1_half_T_by_k2 = cos_omega1_half_T*t12
    t13 = half_T*omega2_by_k2
    cos_omega2_half_T_by_k2 = -sin_omega2_half_T*t13
    sin_omega2_half_T_by_k2 = cos_omega2_half_T*t13
    # d/dT of: functions of half_T in free
    t14 = omega1/2
    cos_omega1_half_T_by_T = -sin_omega1_half_T*t14
    sin_omega1_half_T_by_T = cos_omega1_half_T*t14
    t15 = omega2/2
    cos_omega2_half_T_by_T = -sin_omega2_half_T*t15
    sin_omega2_half_T_by_T = cos_omega2_half_T*t15
    # outputs
    t16 = omega1*sin_omega1_half_T
    t17 = cos_omega1_half_T*u - cos_omega2_half_T*u + omega2*sin_omega2_half_T - t16
    t18 = -omega2*sin_omega2_half_T*y + t16*y
    t20 = p1*u
    t21 = p2*y
    t22 = p1 - 1
    t23 = t21 + t22
    t24 = sin_omega2_half_T*t23
    t25 = omega2*t23
    t26 = t22*u
    t27 = p1 + t21
    t28 = sin_omega1_half_T*t27
    t29 = omega1*t27
    t30 = p3*u
    t31 = p1*y - p3 - y
    t32 = sin_omega1_half_T*t31
    t33 = omega1*t31
    t34 = p1*y - p3
    t35 = sin_omega2_half_T*t34
    t36 = omega2*t34
    return [[cos_omega1_half_T_by_m1*t20 - cos_omega2_half_T_by_m1*t26 - omega1_by_m1*t28 + omega2_by_m1*t24 + p1_by_m1*t17 - p2_by_m1*t18 - sin_omega1_half_T_by_m1*t29 + sin_omega2_half_T_by_m1*t25, cos_omega1_half_T_by_m2*t20 - cos_omega2_half_T_by_m2*t26 - omega1_by_m2*t28 + omega2_by_m2*t24 + p1_by_m2*t17 - p2_by_m2*t18 - sin_omega1_half_T_by_m2*t29 + sin_omega2_half_T_by_m2*t25, cos_omega1_half_T_by_k1*t20 - cos_omega2_half_T_by_k1*t26 - omega1_by_k1*t28 + omega2_by_k1*t24 + p1_by_k1*t17 - p2_by_k1*t18 - sin_omega1_half_T_by_k1*t29 + sin_omega2_half_T_by_k1*t25, cos_omega1_half_T_by_k2*t20 - cos_omega2_half_T_by_k2*t26 - omega1_by_k2*t28 + omega2_by_k2*t24 + p1_by_k2*t17 - p2_by_k2*t18 - sin_omega1_half_T_by_k2*t29 + sin_omega2_half_T_by_k2*t25, cos_omega1_half_T_by_T*t20 - cos_omega2_half_T_by_T*t26 - sin_omega1_half_T_by_T*t29 + sin_omega2_half_T_by_T*t25], [cos_omega1_half_T_by_m1*t30 - cos_omega2_half_T_by_m1*t30 + omega1_by_m1*t32 - omega2_by_m1*t35 + p1_by_m1*t18 + p3_by_m1*t17 + sin_omega1_half_T_by_m1*t33 - sin_omega2_half_T_by_m1*t36, cos_omega1_half_T_by_m2*t30 - cos_omega2_half_T_by_m2*t30 + omega1_by_m2*t32 - omega2_by_m2*t35 + p1_by_m2*t18 + p3_by_m2*t17 + sin_omega1_half_T_by_m2*t33 - sin_omega2_half_T_by_m2*t36, cos_omega1_half_T_by_k1*t30 - cos_omega2_half_T_by_k1*t30 + omega1_by_k1*t32 - omega2_by_k1*t35 + p1_by_k1*t18 + p3_by_k1*t17 + sin_omega1_half_T_by_k1*t33 - sin_omega2_half_T_by_k1*t36, cos_omega1_half_T_by_k2*t30 - cos_omega2_half_T_by_k2*t30 + omega1_by_k2*t32 - omega2_by_k2*t35 + p1_by_k2*t18 + p3_by_k2*t17 + sin_omega1_half_T_by_k2*t33 - sin_omega2_half_T_by_k2*t36, cos_omega1_half_T_by_T*t30 - cos_omega2_half_T_by_T*t30 + sin_omega1_half_T_by_T*t33 - sin_omega2_half_T_by_T*t36]]


def one_impact_poincare_jacobian(parameters, spectrum, unknowns, lib):
    """Jacobian of the Poincare map in the section's coordinates.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives poincare_jacobian (3, 3).
    Operations: 109. Intermediate terms: 53.
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
    t4 = 1 - p1
    t5 = sin_omega2_T/omega2
    t6 = p1*t3 + t4*t5
    t7 = cos_omega1_T*p2 - cos_omega2_T*p2
    t8 = cos_omega1_T*p1 + cos_omega2_T*t4
    x1_1 = t6*u + t7*y + t8
    t9 = p3*sin_omega1_T*t2 - p3*t5
    t10 = cos_omega1_T*t4 + cos_omega2_T*p1
    t11 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t10*y + t11 + t9*u
    t12 = omega1*sin_omega1_T
    t13 = omega2*p2*sin_omega2_T - p2*t12
    t14 = omega2*sin_omega2_T
    v1_1 = -p1*t12 + t13*y - t14*t4 + t8*u
    t15 = -p1*t14 - t12*t4
    v2_1 = -p3*t12 + p3*t14 + t11*u + t15*y
    # Phi along T
    carried_x1_1_by_y = t7
    carried_x1_1_by_u = t6
    carried_x1_1_by_w = p2*sin_omega1_T*t2 - p2*t5
    carried_x2_1_by_y = t10
    carried_x2_1_by_u = t9
    carried_x2_1_by_w = p1*t5 + t3*t4
    carried_v1_1_by_y = t13
    carried_v1_1_by_u = t8
    carried_v1_1_by_w = t7
    carried_v2_1_by_y = t15
    carried_v2_1_by_u = t11
    carried_v2_1_by_w = t10
    # derivatives of the time to the boundary after T
    t16 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t16
    delay_T_by_u = -carried_x1_1_by_u*t16
    delay_T_by_w = -carried_x1_1_by_w*t16
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_T_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_T_by_w*v2_1
    t17 = 1/m1
    t18 = -k1*t17*x1_1 + k1*t17*x2_1
    v1_1_on_boundary_by_y = -carried_v1_1_by_y - delay_T_by_y*t18
    v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*t18
    v1_1_on_boundary_by_w = -carried_v1_1_by_w - delay_T_by_w*t18
    t19 = 1/m2
    t20 = k1*t19*x1_1 - t19*x2_1*(k1 + k2)
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_T_by_y*t20
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_T_by_u*t20
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*t20
    return [[x2_1_on_boundary_by_y, x2_1_on_boundary_by_u, x2_1_on_boundary_by_w], [v1_1_on_boundary_by_y, v1_1_on_boundary_by_u, v1_1_on_boundary_by_w], [v2_1_on_boundary_by_y, v2_1_on_boundary_by_u, v2_1_on_boundary_by_w]]


def one_impact_saltations(parameters, spectrum, unknowns, lib):
    """Saltation matrices of the transitions, one below the other.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives saltations (4, 4).
    Operations: 73. Intermediate terms: 22.
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
    t3 = 1 - p1
    t4 = sin_omega2_T/omega2
    t5 = cos_omega1_T*p1 + cos_omega2_T*t3
    x1_1 = t5 + u*(p1*sin_omega1_T*t2 + t3*t4) + y*(cos_omega1_T*p2 - cos_omega2_T*p2)
    x2_1 = cos_omega1_T*p3 - cos_omega2_T*p3 + u*(p3*sin_omega1_T*t2 - p3*t4) + y*(cos_omega1_T*t3 + cos_omega2_T*p1)
    t6 = omega1*sin_omega1_T
    v1_1 = -omega2*sin_omega2_T*t3 - p1*t6 + t5*u + y*(omega2*p2*sin_omega2_T - p2*t6)
    # transition to free
    v1_1_reset = -v1_1
    # vector fields at transition 1
    t7 = 1/m1
    before_v1_1 = -k1*t7*x1_1 + k1*t7*x2_1
    t9 = 1/m2
    before_v2_1 = k1*t9*x1_1 - t9*x2_1*(k1 + k2)
    behind_v1_1 = before_v1_1
    behind_v2_1 = before_v2_1
    # outputs
    t11 = 1/v1_1
    return [[t11*(-v1_1 + v1_1_reset) + 1, 0, 0, 0], [0, 1, 0, 0], [t11*(before_v1_1 + behind_v1_1), 0, -1, 0], [t11*(-before_v2_1 + behind_v2_1), 0, 0, 1]]


def one_impact_monodromy(parameters, spectrum, unknowns, lib):
    """Monodromy matrix: the product of flows and saltation matrices over a period.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives monodromy (4, 4).
    Operations: 108. Intermediate terms: 62.
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
    t4 = 1 - p1
    t5 = sin_omega2_T/omega2
    t6 = p1*t3 + t4*t5
    t7 = cos_omega1_T*p2 - cos_omega2_T*p2
    t8 = cos_omega1_T*p1 + cos_omega2_T*t4
    x1_1 = t6*u + t7*y + t8
    t9 = p3*sin_omega1_T*t2 - p3*t5
    t10 = cos_omega1_T*t4 + cos_omega2_T*p1
    t11 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t10*y + t11 + t9*u
    t12 = omega1*sin_omega1_T
    t13 = omega2*p2*sin_omega2_T - p2*t12
    t14 = omega2*sin_omega2_T
    t15 = p1*t12 + t14*t4
    v1_1 = t13*y - t15 + t8*u
    # transition to free
    v1_1_reset = -v1_1
    # vector fields at transition 1
    t16 = 1/m1
    before_v1_1 = -k1*t16*x1_1 + k1*t16*x2_1
    t18 = 1/m2
    before_v2_1 = k1*t18*x1_1 - t18*x2_1*(k1 + k2)
    behind_v1_1 = before_v1_1
    behind_v2_1 = before_v2_1
    # Phi of phase 1
    phi_1_00 = t8
    phi_1_01 = t7
    phi_1_02 = t6
    phi_1_03 = p2*sin_omega1_T*t2 - p2*t5
    phi_1_10 = t11
    phi_1_11 = t10
    phi_1_12 = t9
    phi_1_13 = p1*t5 + t3*t4
    phi_1_20 = -t15
    phi_1_21 = t13
    phi_1_22 = t8
    phi_1_23 = t7
    phi_1_30 = omega2*p3*sin_omega2_T - p3*t12
    phi_1_31 = -p1*t14 - t12*t4
    phi_1_32 = t11
    phi_1_33 = t10
    # saltation of phase 1
    t20 = 1/v1_1
    t21 = t20*(-v1_1 + v1_1_reset) + 1
    saltation_1_00 = phi_1_00*t21
    saltation_1_01 = phi_1_01*t21
    saltation_1_02 = phi_1_02*t21
    saltation_1_03 = phi_1_03*t21
    t22 = t20*(before_v1_1 + behind_v1_1)
    saltation_1_20 = phi_1_00*t22 - phi_1_20
    saltation_1_21 = phi_1_01*t22 - phi_1_21
    saltation_1_22 = phi_1_02*t22 - phi_1_22
    saltation_1_23 = phi_1_03*t22 - phi_1_23
    t23 = t20*(-before_v2_1 + behind_v2_1)
    saltation_1_30 = phi_1_00*t23 + phi_1_30
    saltation_1_31 = phi_1_01*t23 + phi_1_31
    saltation_1_32 = phi_1_02*t23 + phi_1_32
    saltation_1_33 = phi_1_03*t23 + phi_1_33
    return [[saltation_1_00, saltation_1_01, saltation_1_02, saltation_1_03], [phi_1_10, phi_1_11, phi_1_12, phi_1_13], [saltation_1_20, saltation_1_21, saltation_1_22, saltation_1_23], [saltation_1_30, saltation_1_31, saltation_1_32, saltation_1_33]]


def one_impact_trace(parameters, spectrum, unknowns, lib):
    """Trace of the Poincare map's Jacobian.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives trace.
    Operations: 94. Intermediate terms: 35.
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
    t3 = 1 - p1
    t4 = sin_omega2_T/omega2
    t5 = p1*sin_omega1_T*t2 + t3*t4
    t6 = cos_omega1_T*p2 - cos_omega2_T*p2
    t7 = cos_omega1_T*p1 + cos_omega2_T*t3
    x1_1 = t5*u + t6*y + t7
    t8 = cos_omega1_T*t3 + cos_omega2_T*p1
    t9 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t8*y + t9 + u*(p3*sin_omega1_T*t2 - p3*t4)
    t10 = omega1*sin_omega1_T
    t11 = omega2*sin_omega2_T
    v1_1 = -p1*t10 - t11*t3 + t7*u + y*(omega2*p2*sin_omega2_T - p2*t10)
    v2_1 = -p3*t10 + p3*t11 + t9*u + y*(-p1*t11 - t10*t3)
    # Phi along T
    carried_x1_1_by_y = t6
    carried_x1_1_by_u = t5
    carried_x1_1_by_w = p2*sin_omega1_T*t2 - p2*t4
    carried_x2_1_by_y = t8
    carried_v1_1_by_u = t7
    carried_v2_1_by_w = t8
    # derivatives of the time to the boundary after T
    t12 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t12
    delay_T_by_u = -carried_x1_1_by_u*t12
    delay_T_by_w = -carried_x1_1_by_w*t12
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    t13 = 1/m1
    v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*(-k1*t13*x1_1 + k1*t13*x2_1)
    t14 = 1/m2
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*(k1*t14*x1_1 - t14*x2_1*(k1 + k2))
    return v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y


def one_impact_trace_gradient(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Derivatives of the trace by the unknowns, then in total by the parameters.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 4): gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2,
        omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2, omega2_by_k1, omega2_by_k2,
        omega2_by_m1, omega2_by_m2, p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2, p2_by_k1,
        p2_by_k2, p2_by_m1, p2_by_m2, p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_m1, omega3_by_m2.
    Takes unknowns (2): y, u.
    Gives trace_gradient (7).
    Operations: 853. Intermediate terms: 269.
    """
    [m1, m2, k1, k2, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [[_, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [_, _, _, _]] = spectrum_derivatives
    [y, u] = unknowns
    # functions of T in free
    t0 = T*omega1
    cos_omega1_T = lib.cos(t0)
    sin_omega1_T = lib.sin(t0)
    t3 = T*omega2
    cos_omega2_T = lib.cos(t3)
    sin_omega2_T = lib.sin(t3)
    # free for T, until first-reaches-stop
    t6 = 1/omega1
    t7 = p1 - 1
    t9 = 1/omega2
    t10 = sin_omega2_T*t9
    t11 = p1*sin_omega1_T*t6 - t10*t7
    t12 = cos_omega1_T*p2 - cos_omega2_T*p2
    t13 = cos_omega1_T*p1 - cos_omega2_T*t7
    x1_1 = t11*u + t12*y + t13
    t14 = p3*sin_omega1_T*t6 - p3*t10
    t15 = -cos_omega1_T*t7 + cos_omega2_T*p1
    t16 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t14*u + t15*y + t16
    t17 = omega1*sin_omega1_T
    t18 = omega2*p2*sin_omega2_T - p2*t17
    t19 = p1*sin_omega1_T
    t20 = -sin_omega2_T*t7
    v1_1 = -omega1*t19 - omega2*t20 + t13*u + t18*y
    t21 = omega2*sin_omega2_T
    t22 = -p1*t21 + t17*t7
    v2_1 = -p3*t17 + p3*t21 + t16*u + t22*y
    # Phi along T
    carried_x1_1_by_y = t12
    carried_x1_1_by_u = t11
    carried_x1_1_by_w = p2*sin_omega1_T*t6 - p2*t10
    # derivatives of the time to the boundary after T
    t23 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t23
    delay_T_by_u = -carried_x1_1_by_u*t23
    delay_T_by_w = -carried_x1_1_by_w*t23
    # d/dm1 of: functions of T in free
    t24 = T*omega1_by_m1
    cos_omega1_T_by_m1 = -sin_omega1_T*t24
    sin_omega1_T_by_m1 = cos_omega1_T*t24
    t25 = T*omega2_by_m1
    cos_omega2_T_by_m1 = -sin_omega2_T*t25
    sin_omega2_T_by_m1 = cos_omega2_T*t25
    # d/dm2 of: functions of T in free
    t26 = T*omega1_by_m2
    cos_omega1_T_by_m2 = -sin_omega1_T*t26
    sin_omega1_T_by_m2 = cos_omega1_T*t26
    t27 = T*omega2_by_m2
    cos_omega2_T_by_m2 = -sin_omega2_T*t27
    sin_omega2_T_by_m2 = cos_omega2_T*t27
    # d/dk1 of: functions of T in free
    t28 = T*omega1_by_k1
    cos_omega1_T_by_k1 = -sin_omega1_T*t28
    sin_omega1_T_by_k1 = cos_omega1_T*t28
    t29 = T*omega2_by_k1
    cos_omega2_T_by_k1 = -sin_omega2_T*t29
    sin_omega2_T_by_k1 = cos_omega2_T*t29
    # d/dk2 of: functions of T in free
    t30 = T*omega1_by_k2
    cos_omega1_T_by_k2 = -sin_omega1_T*t30
    sin_omega1_T_by_k2 = cos_omega1_T*t30
    t31 = T*omega2_by_k2
    cos_omega2_T_by_k2 = -sin_omega2_T*t31
    sin_omega2_T_by_k2 = cos_omega2_T*t31
    # d/dT of: functions of T in free
    cos_omega1_T_by_T = -omega1*sin_omega1_T
    sin_omega1_T_by_T = cos_omega1_T*omega1
    cos_omega2_T_by_T = -omega2*sin_omega2_T
    sin_omega2_T_by_T = cos_omega2_T*omega2
    # d/dy of: free for T, until first-reaches-stop
    x1_1_by_y = t12
    x2_1_by_y = t15
    v1_1_by_y = t18
    v2_1_by_y = t22
    # d/du of: free for T, until first-reaches-stop
    x1_1_by_u = t11
    x2_1_by_u = t14
    v1_1_by_u = t13
    v2_1_by_u = t16
    # d/dm1 of: free for T, until first-reaches-stop
    t32 = p2*y
    t33 = p1 + t32
    t34 = -t32 - t7
    t35 = sin_omega1_T*t6 - t10
    t36 = cos_omega1_T - cos_omega2_T
    t37 = t35*u + t36
    t38 = p2_by_m1*t36
    t39 = sin_omega1_T_by_m1*t6
    t40 = p1*t39
    t41 = sin_omega2_T_by_m1*t9
    t42 = -t41*t7
    t43 = 1/omega1**2
    t44 = omega1_by_m1*t43
    t45 = t19*t44
    t46 = 1/omega2**2
    t47 = omega2_by_m1*t46
    t48 = t20*t47
    x1_1_by_m1 = cos_omega1_T_by_m1*t33 + cos_omega2_T_by_m1*t34 + p1_by_m1*t37 + t38*y + t40*u + t42*u - t45*u - t48*u
    t49 = -t7*y
    t50 = p3 + t49
    t51 = p1*y
    t52 = -p3 + t51
    t54 = -p1_by_m1*t36
    t55 = p3*u
    t56 = p3*sin_omega2_T*u
    t57 = p3*sin_omega1_T
    t58 = t57*u
    x2_1_by_m1 = cos_omega1_T_by_m1*t50 + cos_omega2_T_by_m1*t52 + p3_by_m1*t37 + t39*t55 - t41*t55 - t44*t58 + t47*t56 + t54*y
    t59 = -sin_omega1_T*t32 - t19
    t60 = sin_omega2_T*t32 - t20
    t61 = -t17 + t21 + t36*u
    t62 = -omega1*p1 - omega1*t32
    t63 = omega2*t32 + omega2*t7
    t64 = cos_omega1_T_by_m1*p1
    t65 = -cos_omega2_T_by_m1*t7
    t66 = -omega2*sin_omega2_T + t17
    t67 = -t66*y
    v1_1_by_m1 = omega1_by_m1*t59 + omega2_by_m1*t60 + p1_by_m1*t61 + p2_by_m1*t67 + sin_omega1_T_by_m1*t62 + sin_omega2_T_by_m1*t63 + t64*u + t65*u
    t68 = -sin_omega1_T*t49 - t57
    t69 = p3*sin_omega2_T - sin_omega2_T*t51
    t70 = -omega1*p3 - omega1*t49
    t71 = omega2*p3 - omega2*t51
    t72 = t66*y
    v2_1_by_m1 = cos_omega1_T_by_m1*t55 - cos_omega2_T_by_m1*t55 + omega1_by_m1*t68 + omega2_by_m1*t69 + p1_by_m1*t72 + p3_by_m1*t61 + sin_omega1_T_by_m1*t70 + sin_omega2_T_by_m1*t71
    # d/dm2 of: free for T, until first-reaches-stop
    t73 = p2_by_m2*t36
    t74 = sin_omega1_T_by_m2*t6
    t75 = p1*t74
    t76 = sin_omega2_T_by_m2*t9
    t77 = -t7*t76
    t78 = omega1_by_m2*t43
    t79 = t19*t78
    t80 = omega2_by_m2*t46
    t81 = t20*t80
    x1_1_by_m2 = cos_omega1_T_by_m2*t33 + cos_omega2_T_by_m2*t34 + p1_by_m2*t37 + t73*y + t75*u + t77*u - t79*u - t81*u
    t82 = -p1_by_m2*t36
    x2_1_by_m2 = cos_omega1_T_by_m2*t50 + cos_omega2_T_by_m2*t52 + p3_by_m2*t37 + t55*t74 - t55*t76 + t56*t80 - t58*t78 + t82*y
    t83 = cos_omega1_T_by_m2*p1
    t84 = -cos_omega2_T_by_m2*t7
    v1_1_by_m2 = omega1_by_m2*t59 + omega2_by_m2*t60 + p1_by_m2*t61 + p2_by_m2*t67 + sin_omega1_T_by_m2*t62 + sin_omega2_T_by_m2*t63 + t83*u + t84*u
    v2_1_by_m2 = cos_omega1_T_by_m2*t55 - cos_omega2_T_by_m2*t55 + omega1_by_m2*t68 + omega2_by_m2*t69 + p1_by_m2*t72 + p3_by_m2*t61 + sin_omega1_T_by_m2*t70 + sin_omega2_T_by_m2*t71
    # d/dk1 of: free for T, until first-reaches-stop
    t85 = p2_by_k1*t36
    t86 = sin_omega1_T_by_k1*t6
    t87 = p1*t86
    t88 = sin_omega2_T_by_k1*t9
    t89 = -t7*t88
    t90 = omega1_by_k1*t43
    t91 = t19*t90
    t92 = omega2_by_k1*t46
    t93 = t20*t92
    x1_1_by_k1 = cos_omega1_T_by_k1*t33 + cos_omega2_T_by_k1*t34 + p1_by_k1*t37 + t85*y + t87*u + t89*u - t91*u - t93*u
    t94 = -p1_by_k1*t36
    x2_1_by_k1 = cos_omega1_T_by_k1*t50 + cos_omega2_T_by_k1*t52 + p3_by_k1*t37 + t55*t86 - t55*t88 + t56*t92 - t58*t90 + t94*y
    t95 = cos_omega1_T_by_k1*p1
    t96 = -cos_omega2_T_by_k1*t7
    v1_1_by_k1 = omega1_by_k1*t59 + omega2_by_k1*t60 + p1_by_k1*t61 + p2_by_k1*t67 + sin_omega1_T_by_k1*t62 + sin_omega2_T_by_k1*t63 + t95*u + t96*u
    v2_1_by_k1 = cos_omega1_T_by_k1*t55 - cos_omega2_T_by_k1*t55 + omega1_by_k1*t68 + omega2_by_k1*t69 + p1_by_k1*t72 + p3_by_k1*t61 + sin_omega1_T_by_k1*t70 + sin_omega2_T_by_k1*t71
    # d/dk2 of: free for T, until first-reaches-stop
    t97 = p2_by_k2*t36
    t98 = sin_omega1_T_by_k2*t6
    t99 = p1*t98
    t100 = sin_omega2_T_by_k2*t9
    t101 = -t100*t7
    t102 = omega1_by_k2*t43
    t103 = t102*t19
    t104 = omega2_by_k2*t46
    t105 = t104*t20
    x1_1_by_k2 = cos_omega1_T_by_k2*t33 + cos_omega2_T_by_k2*t34 + p1_by_k2*t37 + t101*u - t103*u - t105*u + t97*y + t99*u
    t106 = -p1_by_k2*t36
    x2_1_by_k2 = cos_omega1_T_by_k2*t50 + cos_omega2_T_by_k2*t52 + p3_by_k2*t37 - t100*t55 - t102*t58 + t104*t56 + t106*y + t55*t98
    t107 = cos_omega1_T_by_k2*p1
    t108 = -cos_omega2_T_by_k2*t7
    v1_1_by_k2 = omega1_by_k2*t59 + omega2_by_k2*t60 + p1_by_k2*t61 + p2_by_k2*t67 + sin_omega1_T_by_k2*t62 + sin_omega2_T_by_k2*t63 + t107*u + t108*u
    v2_1_by_k2 = cos_omega1_T_by_k2*t55 - cos_omega2_T_by_k2*t55 + omega1_by_k2*t68 + omega2_by_k2*t69 + p1_by_k2*t72 + p3_by_k2*t61 + sin_omega1_T_by_k2*t70 + sin_omega2_T_by_k2*t71
    # d/dT of: free for T, until first-reaches-stop
    t109 = sin_omega1_T_by_T*t6
    t110 = p1*t109
    t111 = sin_omega2_T_by_T*t9
    t112 = -t111*t7
    x1_1_by_T = cos_omega1_T_by_T*t33 + cos_omega2_T_by_T*t34 + t110*u + t112*u
    x2_1_by_T = cos_omega1_T_by_T*t50 + cos_omega2_T_by_T*t52 + t109*t55 - t111*t55
    t113 = cos_omega1_T_by_T*p1
    t114 = -cos_omega2_T_by_T*t7
    v1_1_by_T = sin_omega1_T_by_T*t62 + sin_omega2_T_by_T*t63 + t113*u + t114*u
    v2_1_by_T = cos_omega1_T_by_T*t55 - cos_omega2_T_by_T*t55 + sin_omega1_T_by_T*t70 + sin_omega2_T_by_T*t71
    # d/dm1 of: Phi along T
    carried_x1_1_by_y_by_m1 = cos_omega1_T_by_m1*p2 - cos_omega2_T_by_m1*p2 + t38
    carried_x1_1_by_u_by_m1 = p1_by_m1*t35 + t40 + t42 - t45 - t48
    t115 = p2*sin_omega2_T
    t116 = p2*sin_omega1_T
    carried_x1_1_by_w_by_m1 = p2*t39 - p2*t41 + p2_by_m1*t35 + t115*t47 - t116*t44
    carried_x2_1_by_y_by_m1 = -cos_omega1_T_by_m1*t7 + cos_omega2_T_by_m1*p1 + t54
    carried_v1_1_by_u_by_m1 = p1_by_m1*t36 + t64 + t65
    carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1
    # d/dm2 of: Phi along T
    carried_x1_1_by_y_by_m2 = cos_omega1_T_by_m2*p2 - cos_omega2_T_by_m2*p2 + t73
    carried_x1_1_by_u_by_m2 = p1_by_m2*t35 + t75 + t77 - t79 - t81
    carried_x1_1_by_w_by_m2 = p2*t74 - p2*t76 + p2_by_m2*t35 + t115*t80 - t116*t78
    carried_x2_1_by_y_by_m2 = -cos_omega1_T_by_m2*t7 + cos_omega2_T_by_m2*p1 + t82
    carried_v1_1_by_u_by_m2 = p1_by_m2*t36 + t83 + t84
    carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2
    # d/dk1 of: Phi along T
    carried_x1_1_by_y_by_k1 = cos_omega1_T_by_k1*p2 - cos_omega2_T_by_k1*p2 + t85
    carried_x1_1_by_u_by_k1 = p1_by_k1*t35 + t87 + t89 - t91 - t93
    carried_x1_1_by_w_by_k1 = p2*t86 - p2*t88 + p2_by_k1*t35 + t115*t92 - t116*t90
    carried_x2_1_by_y_by_k1 = -cos_omega1_T_by_k1*t7 + cos_omega2_T_by_k1*p1 + t94
    carried_v1_1_by_u_by_k1 = p1_by_k1*t36 + t95 + t96
    carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1
    # d/dk2 of: Phi along T
    carried_x1_1_by_y_by_k2 = cos_omega1_T_by_k2*p2 - cos_omega2_T_by_k2*p2 + t97
    carried_x1_1_by_u_by_k2 = p1_by_k2*t35 + t101 - t103 - t105 + t99
    carried_x1_1_by_w_by_k2 = -p2*t100 + p2*t98 + p2_by_k2*t35 - t102*t116 + t104*t115
    carried_x2_1_by_y_by_k2 = -cos_omega1_T_by_k2*t7 + cos_omega2_T_by_k2*p1 + t106
    carried_v1_1_by_u_by_k2 = p1_by_k2*t36 + t107 + t108
    carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2
    # d/dT of: Phi along T
    carried_x1_1_by_y_by_T = cos_omega1_T_by_T*p2 - cos_omega2_T_by_T*p2
    carried_x1_1_by_u_by_T = t110 + t112
    carried_x1_1_by_w_by_T = p2*sin_omega1_T_by_T*t6 - p2*t111
    carried_x2_1_by_y_by_T = -cos_omega1_T_by_T*t7 + cos_omega2_T_by_T*p1
    carried_v1_1_by_u_by_T = t113 + t114
    carried_v2_1_by_w_by_T = carried_x2_1_by_y_by_T
    # d/dy of: derivatives of the time to the boundary after T
    t122 = 1/v1_1**2
    t123 = t122*v1_1_by_y
    delay_T_by_y_by_y = carried_x1_1_by_y*t123
    delay_T_by_u_by_y = carried_x1_1_by_u*t123
    delay_T_by_w_by_y = carried_x1_1_by_w*t123
    # d/du of: derivatives of the time to the boundary after T
    t124 = t122*v1_1_by_u
    delay_T_by_y_by_u = carried_x1_1_by_y*t124
    delay_T_by_u_by_u = carried_x1_1_by_u*t124
    delay_T_by_w_by_u = carried_x1_1_by_w*t124
    # d/dm1 of: derivatives of the time to the boundary after T
    t125 = t122*v1_1_by_m1
    delay_T_by_y_by_m1 = carried_x1_1_by_y*t125 - carried_x1_1_by_y_by_m1*t23
    delay_T_by_u_by_m1 = carried_x1_1_by_u*t125 - carried_x1_1_by_u_by_m1*t23
    delay_T_by_w_by_m1 = carried_x1_1_by_w*t125 - carried_x1_1_by_w_by_m1*t23
    # d/dm2 of: derivatives of the time to the boundary after T
    t126 = t122*v1_1_by_m2
    delay_T_by_y_by_m2 = carried_x1_1_by_y*t126 - carried_x1_1_by_y_by_m2*t23
    delay_T_by_u_by_m2 = carried_x1_1_by_u*t126 - carried_x1_1_by_u_by_m2*t23
    delay_T_by_w_by_m2 = carried_x1_1_by_w*t126 - carried_x1_1_by_w_by_m2*t23
    # d/dk1 of: derivatives of the time to the boundary after T
    t127 = t122*v1_1_by_k1
    delay_T_by_y_by_k1 = carried_x1_1_by_y*t127 - carried_x1_1_by_y_by_k1*t23
    delay_T_by_u_by_k1 = carried_x1_1_by_u*t127 - carried_x1_1_by_u_by_k1*t23
    delay_T_by_w_by_k1 = carried_x1_1_by_w*t127 - carried_x1_1_by_w_by_k1*t23
    # d/dk2 of: derivatives of the time to the boundary after T
    t128 = t122*v1_1_by_k2
    delay_T_by_y_by_k2 = carried_x1_1_by_y*t128 - carried_x1_1_by_y_by_k2*t23
    delay_T_by_u_by_k2 = carried_x1_1_by_u*t128 - carried_x1_1_by_u_by_k2*t23
    delay_T_by_w_by_k2 = carried_x1_1_by_w*t128 - carried_x1_1_by_w_by_k2*t23
    # d/dT of: derivatives of the time to the boundary after T
    t129 = t122*v1_1_by_T
    delay_T_by_y_by_T = carried_x1_1_by_y*t129 - carried_x1_1_by_y_by_T*t23
    delay_T_by_u_by_T = carried_x1_1_by_u*t129 - carried_x1_1_by_u_by_T*t23
    delay_T_by_w_by_T = carried_x1_1_by_w*t129 - carried_x1_1_by_w_by_T*t23
    # d/dy of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_y = delay_T_by_y*v2_1_by_y + delay_T_by_y_by_y*v2_1
    t130 = 1/m1
    t131 = t130*x1_1
    t132 = -k1*t130*x2_1 + k1*t131
    t133 = k1*x1_1_by_y
    t134 = delay_T_by_u*t130
    t135 = k1*t134
    v1_1_on_boundary_by_u_by_y = delay_T_by_u_by_y*t132 + t133*t134 - t135*x2_1_by_y
    t136 = 1/m2
    t137 = t136*x1_1
    t138 = k1 + k2
    t139 = t136*x2_1
    t140 = k1*t137 - t138*t139
    t141 = delay_T_by_w*t136
    t142 = t138*t141
    v2_1_on_boundary_by_w_by_y = delay_T_by_w_by_y*t140 + t133*t141 - t142*x2_1_by_y
    # d/du of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_u = delay_T_by_y*v2_1_by_u + delay_T_by_y_by_u*v2_1
    v1_1_on_boundary_by_u_by_u = delay_T_by_u_by_u*t132 + t135*x1_1_by_u - t135*x2_1_by_u
    t143 = k1*t141
    v2_1_on_boundary_by_w_by_u = delay_T_by_w_by_u*t140 - t142*x2_1_by_u + t143*x1_1_by_u
    # d/dm1 of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_T_by_y*v2_1_by_m1 + delay_T_by_y_by_m1*v2_1
    t144 = k1/m1**2
    v1_1_on_boundary_by_u_by_m1 = -carried_v1_1_by_u_by_m1 + delay_T_by_u*k1*t130*x1_1_by_m1 - delay_T_by_u*(t144*x1_1 - t144*x2_1) + delay_T_by_u_by_m1*t132 - t135*x2_1_by_m1
    v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_T_by_w_by_m1*t140 - t142*x2_1_by_m1 + t143*x1_1_by_m1
    # d/dm2 of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_T_by_y*v2_1_by_m2 + delay_T_by_y_by_m2*v2_1
    v1_1_on_boundary_by_u_by_m2 = -carried_v1_1_by_u_by_m2 + delay_T_by_u*k1*t130*x1_1_by_m2 + delay_T_by_u_by_m2*t132 - t135*x2_1_by_m2
    t145 = 1/m2**2
    v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_T_by_w*(-k1*t145*x1_1 + t138*t145*x2_1) + delay_T_by_w_by_m2*t140 - t142*x2_1_by_m2 + t143*x1_1_by_m2
    # d/dk1 of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_T_by_y*v2_1_by_k1 + delay_T_by_y_by_k1*v2_1
    v1_1_on_boundary_by_u_by_k1 = -carried_v1_1_by_u_by_k1 + delay_T_by_u*k1*t130*x1_1_by_k1 - delay_T_by_u*(t130*x2_1 - t131) + delay_T_by_u_by_k1*t132 - t135*x2_1_by_k1
    v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_T_by_w*(t137 - t139) + delay_T_by_w_by_k1*t140 - t142*x2_1_by_k1 + t143*x1_1_by_k1
    # d/dk2 of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_T_by_y*v2_1_by_k2 + delay_T_by_y_by_k2*v2_1
    v1_1_on_boundary_by_u_by_k2 = -carried_v1_1_by_u_by_k2 + delay_T_by_u*k1*t130*x1_1_by_k2 + delay_T_by_u_by_k2*t132 - t135*x2_1_by_k2
    v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_T_by_w*t139 + delay_T_by_w_by_k2*t140 - t142*x2_1_by_k2 + t143*x1_1_by_k2
    # d/dT of: perturbation on the boundary after T
    x2_1_on_boundary_by_y_by_T = carried_x2_1_by_y_by_T + delay_T_by_y*v2_1_by_T + delay_T_by_y_by_T*v2_1
    v1_1_on_boundary_by_u_by_T = -carried_v1_1_by_u_by_T + delay_T_by_u*k1*t130*x1_1_by_T + delay_T_by_u_by_T*t132 - t135*x2_1_by_T
    v2_1_on_boundary_by_w_by_T = carried_v2_1_by_w_by_T + delay_T_by_w_by_T*t140 - t142*x2_1_by_T + t143*x1_1_by_T
    return [v1_1_on_boundary_by_u_by_y + v2_1_on_boundary_by_w_by_y + x2_1_on_boundary_by_y_by_y, v1_1_on_boundary_by_u_by_u + v2_1_on_boundary_by_w_by_u + x2_1_on_boundary_by_y_by_u, v1_1_on_boundary_by_u_by_m1 + v2_1_on_boundary_by_w_by_m1 + x2_1_on_boundary_by_y_by_m1, v1_1_on_boundary_by_u_by_m2 + v2_1_on_boundary_by_w_by_m2 + x2_1_on_boundary_by_y_by_m2, v1_1_on_boundary_by_u_by_k1 + v2_1_on_boundary_by_w_by_k1 + x2_1_on_boundary_by_y_by_k1, v1_1_on_boundary_by_u_by_k2 + v2_1_on_boundary_by_w_by_k2 + x2_1_on_boundary_by_y_by_k2, v1_1_on_boundary_by_u_by_T + v2_1_on_boundary_by_w_by_T + x2_1_on_boundary_by_y_by_T]


def one_impact_states(parameters, spectrum, unknowns, lib):
    """State at the start and behind each transition, row by row.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives states (2, 4).
    Operations: 62. Intermediate terms: 18.
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
    t3 = 1 - p1
    t4 = sin_omega2_T/omega2
    t5 = cos_omega1_T*p1 + cos_omega2_T*t3
    x1_1 = t5 + u*(p1*sin_omega1_T*t2 + t3*t4) + y*(cos_omega1_T*p2 - cos_omega2_T*p2)
    t6 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t6 + u*(p3*sin_omega1_T*t2 - p3*t4) + y*(cos_omega1_T*t3 + cos_omega2_T*p1)
    t7 = omega1*sin_omega1_T
    t8 = omega2*sin_omega2_T
    v1_1 = -p1*t7 - t3*t8 + t5*u + y*(omega2*p2*sin_omega2_T - p2*t7)
    v2_1 = -p3*t7 + p3*t8 + t6*u + y*(-p1*t8 - t3*t7)
    # transition to free
    v1_1_reset = -v1_1
    return [[1, y, u, 0], [x1_1, x2_1, v1_1_reset, v2_1]]


def one_impact_boundary_functions(parameters, spectrum, unknowns, lib):
    """Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Gives coefficients (6).
    Gives frequencies (2).
    Operations: 9. Intermediate terms: 1.
    """
    [_, omega1, omega2, p1, p2, _, _] = spectrum
    [y, u] = unknowns
    # outputs
    t0 = p1 + p2*y
    return (
        [-1, 0, t0, 1 - t0, p1*u/omega1, u*(1 - p1)/omega2],
        [omega1, omega2],
    )


def one_impact_flow_free(parameters, spectrum, time, state, lib):
    """State after a time in free.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = 1/omega1
    t1 = omega1*t
    t2 = lib.sin(t1)
    t3 = t0*t2
    t4 = 1 - p1
    t5 = omega2*t
    t6 = lib.sin(t5)
    t7 = t6/omega2
    t8 = lib.cos(t1)
    t9 = lib.cos(t5)
    t10 = p1*t8 + t4*t9
    t11 = p2*t8 - p2*t9
    t12 = p3*t8 - p3*t9
    t13 = p1*t9 + t4*t8
    t14 = omega1*t2
    t15 = omega2*t6
    return [t10*x1 + t11*x2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*x1 + t13*x2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + x1*(-p1*t14 - t15*t4) + x2*(omega2*p2*t6 - p2*t14), t12*v1 + t13*v2 + x1*(omega2*p3*t6 - p3*t14) + x2*(-p1*t15 - t14*t4)]


def one_impact_expand(parameters, spectrum, lib):
    """All unknowns: they are explicit, and how singular the linear equations for them are: 0 if they are.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives unknowns (2).
    Gives determinants (1).
    Operations: 76. Intermediate terms: 28.
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
    t2 = omega1*sin_omega1_half_T
    coefficient11 = omega2*p2*sin_omega2_half_T - p2*t2
    t3 = p1 - 1
    coefficient12 = cos_omega1_half_T*p1 - cos_omega2_half_T*t3
    t4 = omega2*sin_omega2_half_T
    coefficient21 = -p1*t4 + t2*t3
    coefficient22 = cos_omega1_half_T*p3 - cos_omega2_half_T*p3
    # right-hand sides of the linear equations
    right1 = p1*t2 - t3*t4
    right2 = p3*t2 - p3*t4
    # determinant of the linear equations
    determinant = coefficient11*coefficient22 - coefficient12*coefficient21
    # numerators of Cramer's rule
    numerator1 = -coefficient12*right2 + coefficient22*right1
    numerator2 = coefficient11*right2 - coefficient21*right1
    # y, u by Cramer's rule
    t5 = 1/determinant
    y = numerator1*t5
    u = numerator2*t5
    # outputs
    t6 = p1**2
    t7 = half_T**2
    t8 = 2*t7
    t9 = omega2**4*t8/(omega2**2*t7 + 1)
    t10 = omega1**4*t8/(omega1**2*t7 + 1)
    t11 = p2**2
    return (
        [y, u],
        [determinant/(lib.sqrt(2*p3**2 + t10*t3**2 + t6*t9)*lib.sqrt(t10*t11 + t11*t9 + t3**2 + t6))],
    )
