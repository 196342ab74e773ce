# Generated; do not edit.
# Source: nonsmooth.derive.systems.rigid_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation 53b6b82b7842df3c
"""Kernels and tables of the system rigid-stop, over any arithmetic ``lib``."""

DERIVATION = "53b6b82b7842df3c"

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

KERNELS = {'spectrum': ([((4,), 0)], [('spectrum', (7,)), ('spectrum_derivatives', (7, 4))]),
 'flow_free': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_contact': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'fields': ([((5,), 0)], [('fields', (8, 5))]),
 'rows': ([((5,), 0)], [('rows', (5, 5))]),
 'resets': ([((5,), 0)], [('resets', (12, 5))]),
 'modes': ([((5,), 0), ((7,), 0)], [('exponents', (5, 2)), ('coefficients', (36, 5))]),
 'one_impact_equations': ([((5,), 0), ((7,), 0), ((2,), 0), ((7, 4), 2)],
                          [('residual', (2,)),
                           ('jacobian', (2, 2)),
                           ('parameter_jacobian', (2, 5))]),
 'one_impact_trace': ([((5,), 0), ((7,), 0), ((2,), 0), ((7, 4), 1)],
                      [('trace', ()), ('trace_gradient', (7,))]),
 'one_impact_passage': ([((5,), 0), ((7,), 0), ((2,), 0)],
                        [('states', (2, 4)), ('coefficients', (6,)), ('frequencies', (2,))]),
 'one_impact_linearisation': ([((5,), 0), ((7,), 0), ((2,), 0)],
                              [('poincare_jacobian', (3, 3)),
                               ('saltations', (4, 4)),
                               ('monodromy', (4, 4))]),
 'one_impact_flow_free': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'one_impact_reduced': ([((5,), 0), ((7,), 0)], [('unknowns', (2,)), ('determinants', (1,))])}

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (4): k1, k2, m1, m2.
    Gives spectrum (7).
    Gives spectrum_derivatives (7, 4).
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
    spectrum = [gap1, omega1, omega2, p1, p2, p3, omega3]
    if outputs == 1:
        return spectrum
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
    spectrum_derivatives = [[gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [omega3_by_k1, omega3_by_k2, 0, omega3_by_m2]]
    return spectrum, spectrum_derivatives


def flow_free(parameters, spectrum, time, state, *, lib):
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
    # state_after
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
    t = time
    [x1, x2, v1, v2] = state
    # state_after
    t0 = 1/(k1 + k2)
    t1 = k1*t0
    t2 = omega3*t
    t3 = lib.sin(t2)
    t4 = t3/omega3
    t5 = lib.cos(t2)
    t6 = k1*t0 - t1*t5
    t7 = omega3*t3
    return [t*v1 + x1, t4*v2 + t5*x2 + t6*x1 + v1*(t*t1 - t1*t4), v1, t1*t7*x1 + t5*v2 + t6*v1 - t7*x2]


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
    t4 = 1/omega2
    t5 = k1/(k1 + k2)
    t7 = 1/omega3
    coefficients = [[0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, 0], [p3, t0, 0, 0, 0], [0, 0, p1, p2, 0], [0, 0, p3, t0, 0], [0, 0, p1*t1, p2*t1, 0], [0, 0, p3*t1, t0*t1, 0], [-omega1*p1, -omega1*p2, 0, 0, 0], [-omega1*p3, -omega1*t0, 0, 0, 0], [t0, -p2, 0, 0, 0], [-p3, p1, 0, 0, 0], [0, 0, t0, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t0*t4, -p2*t4, 0], [0, 0, -p3*t4, p1*t4, 0], [-omega2*t0, omega2*p2, 0, 0, 0], [omega2*p3, -omega2*p1, 0, 0, 0], [1, 0, 0, 0, 0], [t5, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, t5, 0, 0], [0, 0, 1, 0, 0], [0, 0, t5, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-t5, 1, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, -t5, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t5*t7, t7, 0], [0, 0, 0, 0, 0], [omega3*t5, -omega3, 0, 0, 0]]
    return exponents, coefficients


def one_impact_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Takes spectrum_derivatives (7, 4): gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2,
        omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2, omega2_by_k1, omega2_by_k2,
        omega2_by_m1, omega2_by_m2, p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2, p2_by_k1,
        p2_by_k2, p2_by_m1, p2_by_m2, p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_m1, omega3_by_m2, for parameter_jacobian.
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
    t3 = half_T*omega2
    cos_omega2_half_T = lib.cos(t3)
    sin_omega2_half_T = lib.sin(t3)
    # residual
    t16 = cos_omega1_half_T*p1
    t17 = p2*y
    t18 = p1 - 1
    t19 = t17 + t18
    t20 = omega2*sin_omega2_half_T
    t21 = cos_omega2_half_T*t18
    t22 = p1 + t17
    t23 = omega1*sin_omega1_half_T
    t24 = cos_omega1_half_T*p3
    t25 = p1*y - p3 - y
    t26 = cos_omega2_half_T*p3
    t27 = p1*y - p3
    residual = [t16*u + t19*t20 - t21*u - t22*t23, -t20*t27 + t23*t25 + t24*u - t26*u]
    if outputs == 1:
        return residual
    jacobian = [[omega2*p2*sin_omega2_half_T - p2*t23, t16 - t21], [-p1*t20 + t18*t23, t24 - t26]]
    if outputs == 2:
        return residual, jacobian
    [[_, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [_, _, _, _]] = spectrum_derivatives
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
    # parameter_jacobian
    t28 = cos_omega1_half_T*u - cos_omega2_half_T*u + t20 - t23
    t29 = -omega2*sin_omega2_half_T*y + t23*y
    t31 = p1*u
    t32 = sin_omega2_half_T*t19
    t33 = omega2*t19
    t34 = t18*u
    t35 = sin_omega1_half_T*t22
    t36 = omega1*t22
    t37 = p3*u
    t38 = sin_omega1_half_T*t25
    t39 = omega1*t25
    t40 = sin_omega2_half_T*t27
    t41 = omega2*t27
    parameter_jacobian = [[cos_omega1_half_T_by_m1*t31 - cos_omega2_half_T_by_m1*t34 - omega1_by_m1*t35 + omega2_by_m1*t32 + p1_by_m1*t28 - p2_by_m1*t29 - sin_omega1_half_T_by_m1*t36 + sin_omega2_half_T_by_m1*t33, cos_omega1_half_T_by_m2*t31 - cos_omega2_half_T_by_m2*t34 - omega1_by_m2*t35 + omega2_by_m2*t32 + p1_by_m2*t28 - p2_by_m2*t29 - sin_omega1_half_T_by_m2*t36 + sin_omega2_half_T_by_m2*t33, cos_omega1_half_T_by_k1*t31 - cos_omega2_half_T_by_k1*t34 - omega1_by_k1*t35 + omega2_by_k1*t32 + p1_by_k1*t28 - p2_by_k1*t29 - sin_omega1_half_T_by_k1*t36 + sin_omega2_half_T_by_k1*t33, cos_omega1_half_T_by_k2*t31 - cos_omega2_half_T_by_k2*t34 - omega1_by_k2*t35 + omega2_by_k2*t32 + p1_by_k2*t28 - p2_by_k2*t29 - sin_omega1_half_T_by_k2*t36 + sin_omega2_half_T_by_k2*t33, cos_omega1_half_T_by_T*t31 - cos_omega2_half_T_by_T*t34 - sin_omega1_half_T_by_T*t36 + sin_omega2_half_T_by_T*t33], [cos_omega1_half_T_by_m1*t37 - cos_omega2_half_T_by_m1*t37 + omega1_by_m1*t38 - omega2_by_m1*t40 + p1_by_m1*t29 + p3_by_m1*t28 + sin_omega1_half_T_by_m1*t39 - sin_omega2_half_T_by_m1*t41, cos_omega1_half_T_by_m2*t37 - cos_omega2_half_T_by_m2*t37 + omega1_by_m2*t38 - omega2_by_m2*t40 + p1_by_m2*t29 + p3_by_m2*t28 + sin_omega1_half_T_by_m2*t39 - sin_omega2_half_T_by_m2*t41, cos_omega1_half_T_by_k1*t37 - cos_omega2_half_T_by_k1*t37 + omega1_by_k1*t38 - omega2_by_k1*t40 + p1_by_k1*t29 + p3_by_k1*t28 + sin_omega1_half_T_by_k1*t39 - sin_omega2_half_T_by_k1*t41, cos_omega1_half_T_by_k2*t37 - cos_omega2_half_T_by_k2*t37 + omega1_by_k2*t38 - omega2_by_k2*t40 + p1_by_k2*t29 + p3_by_k2*t28 + sin_omega1_half_T_by_k2*t39 - sin_omega2_half_T_by_k2*t41, cos_omega1_half_T_by_T*t37 - cos_omega2_half_T_by_T*t37 + sin_omega1_half_T_by_T*t39 - sin_omega2_half_T_by_T*t41]]
    return residual, jacobian, parameter_jacobian


def one_impact_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (5): m1, m2, k1, k2, T.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (2): y, u.
    Takes spectrum_derivatives (7, 4): gap1_by_k1, gap1_by_k2, gap1_by_m1, gap1_by_m2,
        omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2, omega2_by_k1, omega2_by_k2,
        omega2_by_m1, omega2_by_m2, p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2, p2_by_k1,
        p2_by_k2, p2_by_m1, p2_by_m2, p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2, omega3_by_k1,
        omega3_by_k2, omega3_by_m1, omega3_by_m2, for trace_gradient.
    Gives trace.
    Gives trace_gradient (7).
    Operations: 373. Intermediate terms: 99.
    """
    [m1, m2, k1, k2, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
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
    t7 = p1*sin_omega1_T
    t8 = 1/omega2
    t9 = p1 - 1
    t11 = -sin_omega2_T*t9
    t12 = t11*t8 + t6*t7
    t13 = cos_omega1_T*p2 - cos_omega2_T*p2
    t14 = cos_omega1_T*p1 - cos_omega2_T*t9
    x1_1 = t12*u + t13*y + t14
    t15 = p3*sin_omega2_T
    t16 = p3*sin_omega1_T*t6 - t15*t8
    t17 = -cos_omega1_T*t9 + cos_omega2_T*p1
    t18 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t16*u + t17*y + t18
    t19 = omega1*sin_omega1_T
    t20 = omega2*p2*sin_omega2_T - p2*t19
    t21 = omega1*p1
    t22 = -omega2*t9
    v1_1 = -sin_omega1_T*t21 - sin_omega2_T*t22 + t14*u + t20*y
    t23 = omega2*sin_omega2_T
    t24 = -p1*t23 + t19*t9
    t25 = omega1*p3
    v2_1 = omega2*p3*sin_omega2_T - sin_omega1_T*t25 + t18*u + t24*y
    # Phi along T
    carried_x1_1_by_y = t13
    carried_x1_1_by_u = t12
    t26 = sin_omega2_T*t8
    carried_x1_1_by_w = p2*sin_omega1_T*t6 - p2*t26
    carried_x2_1_by_y = t17
    carried_v1_1_by_u = t14
    carried_v2_1_by_w = t17
    # derivatives of the time to the boundary after T
    t27 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t27
    delay_T_by_u = -carried_x1_1_by_u*t27
    delay_T_by_w = -carried_x1_1_by_w*t27
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    t28 = 1/m1
    t29 = t28*x1_1
    t30 = -k1*t28*x2_1 + k1*t29
    v1_1_on_boundary_by_u = -carried_v1_1_by_u + delay_T_by_u*t30
    t31 = 1/m2
    t32 = t31*x1_1
    t33 = k1 + k2
    t34 = t31*x2_1
    t35 = k1*t32 - t33*t34
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*t35
    trace = v1_1_on_boundary_by_u + v2_1_on_boundary_by_w + x2_1_on_boundary_by_y
    if outputs == 1:
        return trace
    [[_, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_m1, p3_by_m2], [_, _, _, _]] = spectrum_derivatives
    # back through: derivatives of the time to the boundary after T
    slope_by_delay_T_by_w = t35
    slope_by_delay_T_by_u = t30
    # back through: Phi along T
    slope_by_carried_x1_1_by_w = -slope_by_delay_T_by_w*t27
    slope_by_carried_x1_1_by_u = -slope_by_delay_T_by_u*t27
    slope_by_carried_x1_1_by_y = -t27*v2_1
    # back through: free for T, until first-reaches-stop
    t36 = 1/v1_1**2
    slope_by_v1_1 = carried_x1_1_by_u*slope_by_delay_T_by_u*t36 + carried_x1_1_by_w*slope_by_delay_T_by_w*t36 + carried_x1_1_by_y*t36*v2_1
    t37 = delay_T_by_u*k1*t28
    t38 = delay_T_by_w*t31
    slope_by_x2_1 = -t33*t38 - t37
    slope_by_x1_1 = k1*t38 + t37
    # back through: functions of T in free
    t39 = p1*y
    t40 = p2*y
    t41 = -t8*t9
    t42 = p2*slope_by_carried_x1_1_by_w
    t43 = slope_by_x1_1*u
    t44 = p3*u
    t45 = slope_by_x2_1*t44
    slope_by_sin_omega2_T = delay_T_by_y*(omega2*p3 - omega2*t39) + slope_by_carried_x1_1_by_u*t41 + slope_by_v1_1*(omega2*t40 - t22) + t41*t43 - t42*t8 - t45*t8
    t46 = 3*p1
    t47 = p2*slope_by_carried_x1_1_by_y
    t48 = slope_by_v1_1*u
    t49 = delay_T_by_y*t44
    slope_by_cos_omega2_T = slope_by_x1_1*(-t40 - t9) + slope_by_x2_1*(-p3 + t39) + t46 - t47 - t48*t9 - t49 - 1
    t50 = -t9*y
    t51 = p1*t6
    slope_by_sin_omega1_T = delay_T_by_y*(-omega1*t50 - t25) + slope_by_carried_x1_1_by_u*t51 + slope_by_v1_1*(-omega1*t40 - t21) + t42*t6 + t43*t51 + t45*t6
    slope_by_cos_omega1_T = p1*t48 + slope_by_x1_1*(p1 + t40) + slope_by_x2_1*(p3 + t50) - t46 + t47 + t49 + 2
    # trace_gradient
    t52 = p3*sin_omega1_T
    t53 = sin_omega1_T*slope_by_cos_omega1_T
    t54 = 1/omega1**2
    t55 = t54*t7
    t56 = slope_by_x2_1*u
    t57 = T*cos_omega1_T*slope_by_sin_omega1_T - T*t53 + delay_T_by_y*(-sin_omega1_T*t50 - t52) - sin_omega1_T*t42*t54 - slope_by_carried_x1_1_by_u*t55 + slope_by_v1_1*(-sin_omega1_T*t40 - t7) - t43*t55 - t52*t54*t56
    t58 = sin_omega2_T*slope_by_cos_omega2_T
    t59 = 1/omega2**2
    t60 = t11*t59
    t61 = T*cos_omega2_T*slope_by_sin_omega2_T - T*t58 + delay_T_by_y*(p3*sin_omega2_T - sin_omega2_T*t39) + sin_omega2_T*t42*t59 - slope_by_carried_x1_1_by_u*t60 + slope_by_v1_1*(sin_omega2_T*t40 - t11) + t15*t56*t59 - t43*t60
    t62 = sin_omega1_T*t6 - t26
    t63 = cos_omega1_T - cos_omega2_T
    t64 = -t19 + t23 + t63*u
    t65 = t62*u + t63
    t66 = t19 - t23
    t67 = -3*cos_omega1_T + 3*cos_omega2_T + delay_T_by_y*t66*y + slope_by_carried_x1_1_by_u*t62 + slope_by_v1_1*t64 + slope_by_x1_1*t65 - slope_by_x2_1*t63*y
    t68 = slope_by_carried_x1_1_by_w*t62 + slope_by_carried_x1_1_by_y*t63 - slope_by_v1_1*t66*y + slope_by_x1_1*t63*y
    t69 = delay_T_by_y*t64 + slope_by_x2_1*t65
    t70 = k1/m1**2
    t71 = 1/m2**2
    trace_gradient = [delay_T_by_y*t24 + slope_by_v1_1*t20 + slope_by_x1_1*t13 + slope_by_x2_1*t17, delay_T_by_y*t18 + slope_by_v1_1*t14 + slope_by_x1_1*t12 + slope_by_x2_1*t16, -delay_T_by_u*(t70*x1_1 - t70*x2_1) + omega1_by_m1*t57 + omega2_by_m1*t61 + p1_by_m1*t67 + p2_by_m1*t68 + p3_by_m1*t69, delay_T_by_w*(-k1*t71*x1_1 + t33*t71*x2_1) + omega1_by_m2*t57 + omega2_by_m2*t61 + p1_by_m2*t67 + p2_by_m2*t68 + p3_by_m2*t69, -delay_T_by_u*(t28*x2_1 - t29) + delay_T_by_w*(t32 - t34) + omega1_by_k1*t57 + omega2_by_k1*t61 + p1_by_k1*t67 + p2_by_k1*t68 + p3_by_k1*t69, -delay_T_by_w*t34 + omega1_by_k2*t57 + omega2_by_k2*t61 + p1_by_k2*t67 + p2_by_k2*t68 + p3_by_k2*t69, cos_omega1_T*omega1*slope_by_sin_omega1_T + cos_omega2_T*omega2*slope_by_sin_omega2_T - omega1*t53 - omega2*t58]
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
    Operations: 72. Intermediate terms: 20.
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
    t3 = p1 - 1
    t5 = 1/omega2
    t6 = sin_omega2_T*t5
    t7 = cos_omega1_T*p1 - cos_omega2_T*t3
    x1_1 = t7 + u*(p1*sin_omega1_T*t2 - t3*t6) + y*(cos_omega1_T*p2 - cos_omega2_T*p2)
    t8 = cos_omega1_T*p3 - cos_omega2_T*p3
    x2_1 = t8 + u*(p3*sin_omega1_T*t2 - p3*t6) + y*(-cos_omega1_T*t3 + cos_omega2_T*p1)
    t9 = omega1*sin_omega1_T
    t10 = omega2*sin_omega2_T
    v1_1 = -p1*t9 + t10*t3 + t7*u + y*(omega2*p2*sin_omega2_T - p2*t9)
    v2_1 = p3*t10 - p3*t9 + t8*u + y*(-p1*t10 + t3*t9)
    # transition to free
    v1_1_reset = -v1_1
    states = [[1, y, u, 0], [x1_1, x2_1, v1_1_reset, v2_1]]
    if outputs == 1:
        return states
    # coefficients
    t11 = p2*y
    coefficients = [-1, 0, p1 + t11, -t11 - t3, p1*t2*u, -t3*t5*u]
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
    Operations: 142. Intermediate terms: 91.
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
    t16 = -p1*t14 - t12*t4
    t17 = p3*t12
    v2_1 = p3*t14 + t11*u + t16*y - t17
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
    carried_v2_1_by_y = t16
    carried_v2_1_by_u = t11
    carried_v2_1_by_w = t10
    # derivatives of the time to the boundary after T
    t20 = 1/v1_1
    delay_T_by_y = -carried_x1_1_by_y*t20
    delay_T_by_u = -carried_x1_1_by_u*t20
    delay_T_by_w = -carried_x1_1_by_w*t20
    # perturbation on the boundary after T
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_T_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_T_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_T_by_w*v2_1
    t21 = 1/m1
    t22 = -k1*t21*x1_1 + k1*t21*x2_1
    v1_1_on_boundary_by_y = -carried_v1_1_by_y - delay_T_by_y*t22
    v1_1_on_boundary_by_u = -carried_v1_1_by_u - delay_T_by_u*t22
    v1_1_on_boundary_by_w = -carried_v1_1_by_w - delay_T_by_w*t22
    t23 = 1/m2
    t24 = k1*t23*x1_1 - t23*x2_1*(k1 + k2)
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_T_by_y*t24
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_T_by_u*t24
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_T_by_w*t24
    poincare_jacobian = [[x2_1_on_boundary_by_y, x2_1_on_boundary_by_u, x2_1_on_boundary_by_w], [v1_1_on_boundary_by_y, v1_1_on_boundary_by_u, v1_1_on_boundary_by_w], [v2_1_on_boundary_by_y, v2_1_on_boundary_by_u, v2_1_on_boundary_by_w]]
    if outputs == 1:
        return poincare_jacobian
    # transition to free
    v1_1_reset = -v1_1
    # vector fields at transition 1
    before_v1_1 = t22
    before_v2_1 = t24
    behind_v1_1 = t22
    behind_v2_1 = t24
    # saltations
    t25 = t20*(-v1_1 + v1_1_reset) + 1
    t26 = t20*(before_v1_1 + behind_v1_1)
    t27 = t20*(-before_v2_1 + behind_v2_1)
    saltations = [[t25, 0, 0, 0], [0, 1, 0, 0], [t26, 0, -1, 0], [t27, 0, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 1
    phi_1_00 = t8
    phi_1_01 = t7
    phi_1_02 = t6
    phi_1_03 = carried_x1_1_by_w
    phi_1_10 = t11
    phi_1_11 = t10
    phi_1_12 = t9
    phi_1_13 = carried_x2_1_by_w
    phi_1_20 = -t15
    phi_1_21 = t13
    phi_1_22 = t8
    phi_1_23 = t7
    phi_1_30 = omega2*p3*sin_omega2_T - t17
    phi_1_31 = t16
    phi_1_32 = t11
    phi_1_33 = t10
    # saltation of phase 1
    saltation_1_00 = phi_1_00*t25
    saltation_1_01 = phi_1_01*t25
    saltation_1_02 = phi_1_02*t25
    saltation_1_03 = phi_1_03*t25
    saltation_1_20 = phi_1_00*t26 - phi_1_20
    saltation_1_21 = phi_1_01*t26 - phi_1_21
    saltation_1_22 = phi_1_02*t26 - phi_1_22
    saltation_1_23 = phi_1_03*t26 - phi_1_23
    saltation_1_30 = phi_1_00*t27 + phi_1_30
    saltation_1_31 = phi_1_01*t27 + phi_1_31
    saltation_1_32 = phi_1_02*t27 + phi_1_32
    saltation_1_33 = phi_1_03*t27 + phi_1_33
    monodromy = [[saltation_1_00, saltation_1_01, saltation_1_02, saltation_1_03], [phi_1_10, phi_1_11, phi_1_12, phi_1_13], [saltation_1_20, saltation_1_21, saltation_1_22, saltation_1_23], [saltation_1_30, saltation_1_31, saltation_1_32, saltation_1_33]]
    return poincare_jacobian, saltations, monodromy


def one_impact_flow_free(parameters, spectrum, time, state, *, lib):
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
    # state_after
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


def one_impact_reduced(parameters, spectrum, *, lib, outputs=2):
    """All unknowns; how singular the linear equations for them are: 0 if they are.

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
    determinants = [determinant/(lib.sqrt(2*p3**2 + t10*t3**2 + t6*t9)*lib.sqrt(t10*t11 + t11*t9 + t3**2 + t6))]
    return unknowns, determinants
