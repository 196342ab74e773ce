# Generated; do not edit.
# Source: nonsmooth.derive.systems.elastic_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation ac22722cc176f8d2
"""Kernels and tables of the system elastic-stop, over any arithmetic ``lib``."""

DERIVATION = "ac22722cc176f8d2"

SYSTEM = {'name': 'elastic-stop',
 'description': 'two coupled oscillators, the first in front of an elastic stop (Sec. 2.2)',
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
                {'name': 'k3',
                 'description': 'stiffness of the stop',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False}],
 'constraints': [],
 'configurations': {'contact': [{'name': 'first-leaves-stop', 'acts_when': 'exceeded'}],
                    'free': [{'name': 'first-reaches-stop', 'acts_when': 'exceeded'}]},
 'spectrum': ['gap1',
              'omega1',
              'omega2',
              'p1',
              'p2',
              'p3',
              'gap2',
              'omega3',
              'omega4',
              'p4',
              'p5',
              'p6'],
 'spectrum_parameters': ['k1', 'k2', 'k3', 'm1', 'm2'],
 'modes': {'contact': [{'length': 1, 'oscillates': False},
                       {'length': 1, 'oscillates': True},
                       {'length': 1, 'oscillates': True}],
           'free': [{'length': 1, 'oscillates': False},
                    {'length': 1, 'oscillates': True},
                    {'length': 1, 'oscillates': True}]},
 'forcing': [],
 'coordinates': [('x1', 'v1'), ('x2', 'v2')],
 'held': {'contact': [], 'free': []},
 'constraint_rows': {'contact': [], 'free': []},
 'boundary_rows': {'contact': [0], 'free': [1]},
 'transitions': [{'source': 'contact',
                  'boundaries': ['first-leaves-stop'],
                  'conditions': [],
                  'reset': 0,
                  'target': 'free'},
                 {'source': 'free',
                  'boundaries': ['first-reaches-stop'],
                  'conditions': [],
                  'reset': 0,
                  'target': 'contact'}],
 'contacts': {'stop': {'forces': {'contact': 2}, 'velocity': 3, 'surface': 4}}}

ORBITS = {'one-contact': {'derived': True,
                 'phases': [('contact', 'first-leaves-stop', 'tau'),
                            ('free', 'first-reaches-stop', 'tau1')],
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
                                {'name': 'k3',
                                 'description': 'stiffness of the stop',
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
                 'other_parameters': [],
                 'combined': {},
                 'unknowns': ['y', 'u', 'w', 'tau'],
                 'dwell_times': ['tau', 'tau1'],
                 'durations': [{'tau': 1}, {'T': 1, 'tau': -1}],
                 'equations': ['v1 vanishes halfway through contact',
                               'v2 vanishes halfway through contact',
                               'v1 vanishes halfway through free',
                               'v2 vanishes halfway through free'],
                 'reduced': ['tau'],
                 'eliminated': {'y': 'linear in: v1 vanishes halfway through contact; v2 '
                                     'vanishes halfway through contact; v1 vanishes halfway '
                                     'through free',
                                'u': 'linear in: v1 vanishes halfway through contact; v2 '
                                     'vanishes halfway through contact; v1 vanishes halfway '
                                     'through free',
                                'w': 'linear in: v1 vanishes halfway through contact; v2 '
                                     'vanishes halfway through contact; v1 vanishes halfway '
                                     'through free'},
                 'rank': 3,
                 'section': ['y', 'u', 'w'],
                 'conservative': True,
                 'required': {},
                 'vanishing': [],
                 'levels': {'x1': '1'},
                 'resets': [[['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '1', '0'],
                             ['0', '0', '0', '1']],
                            [['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '1', '0'],
                             ['0', '0', '0', '1']]],
                 'measures': ['y', 'u', 'w'],
                 'terms': [2, 2],
                 'boundaries': [(0, 'first-leaves-stop', None, 0.0, True),
                                (1, 'first-reaches-stop', None, 0.0, True)],
                 'reference': {'parameters': {'m1': '1',
                                              'm2': '2',
                                              'k1': '1',
                                              'k2': '5',
                                              'k3': '1',
                                              'T': '2*pi'},
                               'guess': {'y': '0.42',
                                         'u': '3.66',
                                         'w': '0.59',
                                         'tau': '2.12'}}}}

KERNELS = {'spectrum': ([(5,)], [(12,), (12, 5)]),
 'flow_contact': ([(5,), (12,), (), (4,)], [(4,)]),
 'flow_free': ([(5,), (12,), (), (4,)], [(4,)]),
 'fields': ([(5,)], [(8, 5)]),
 'rows': ([(5,)], [(5, 5)]),
 'resets': ([(5,)], [(4, 5)]),
 'modes': ([(5,), (12,)], [(6, 2), (40, 5)]),
 'one_contact_residual': ([(6,), (12,), (4,)], [(4,)]),
 'one_contact_jacobian': ([(6,), (12,), (4,)], [(4, 4)]),
 'one_contact_residual_and_jacobian': ([(6,), (12,), (4,)], [(4,), (4, 4)]),
 'one_contact_parameter_jacobian': ([(6,), (12,), (12, 5), (4,)], [(4, 6)]),
 'one_contact_poincare_jacobian': ([(6,), (12,), (4,)], [(3, 3)]),
 'one_contact_saltations': ([(6,), (12,), (4,)], [(8, 4)]),
 'one_contact_monodromy': ([(6,), (12,), (4,)], [(4, 4)]),
 'one_contact_trace': ([(6,), (12,), (4,)], [()]),
 'one_contact_trace_gradient': ([(6,), (12,), (12, 5), (4,)], [(10,)]),
 'one_contact_states': ([(6,), (12,), (4,)], [(3, 4)]),
 'one_contact_boundary_functions': ([(6,), (12,), (4,)], [(12,), (4,)]),
 'one_contact_flow_contact': ([(6,), (12,), (), (4,)], [(4,)]),
 'one_contact_flow_free': ([(6,), (12,), (), (4,)], [(4,)]),
 'one_contact_reduced': ([(6,), (12,), (1,)], [(1,), (1, 1)]),
 'one_contact_expand': ([(6,), (12,), (1,)], [(4,), (1,)])}

def spectrum(parameters, lib):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (5): k1, k2, k3, m1, m2.
    Gives spectrum (12).
    Gives derivatives (12, 5).
    Operations: 310. Intermediate terms: 144.
    """
    [k1, k2, k3, m1, m2] = parameters
    # spectrum
    t0 = 1/m2
    t1 = k1 + k2
    t2 = t0*t1
    t3 = 1/m1
    t4 = k1 + k3
    t5 = -t2 + t3*t4
    t6 = k1**2
    t7 = 4*t0*t6
    t8 = t3*t7
    gap1 = lib.sqrt(t5**2 + t8)
    t9 = t2/2
    omega1 = lib.sqrt(gap1/2 + t3*t4/2 + t9)
    t10 = lib.sqrt(k1*k2 + k1*k3 + k2*k3)
    t11 = 1/omega1
    t12 = 1/lib.sqrt(m1)
    t13 = 1/lib.sqrt(m2)
    t14 = t12*t13
    t15 = t11*t14
    omega2 = t10*t15
    t16 = 1/gap1
    t17 = t16/2
    p1 = t17*t5 + lib.rational(1, 2)
    t18 = k1*t3
    p2 = -t16*t18
    t19 = t0*t16
    p3 = -k1*t19
    t20 = t18 - t2
    gap2 = lib.sqrt(t20**2 + t8)
    omega3 = lib.sqrt(gap2/2 + t18/2 + t9)
    t21 = 1/omega3
    t22 = lib.sqrt(k1)
    t23 = lib.sqrt(k2)
    t24 = t14*t22*t23
    omega4 = t21*t24
    t25 = 1/gap2
    t26 = t25/2
    p4 = t20*t26 + lib.rational(1, 2)
    p5 = -t18*t25
    t27 = t0*t25
    p6 = -k1*t27
    # d/dk1 of: spectrum
    t28 = -2*t0 + 2*t3
    t29 = 8*t0*t18
    gap1_by_k1 = t17*(t28*t5 + t29)
    t30 = gap1_by_k1/2
    t31 = t0/2
    t32 = t3/2
    t33 = t31 + t32
    t34 = t11/2
    omega1_by_k1 = t34*(t30 + t33)
    t35 = k2/2
    t36 = k3/2
    t37 = t15/t10
    t38 = t10*t14/omega1**2
    omega2_by_k1 = -omega1_by_k1*t38 + t37*(t35 + t36)
    t39 = -t0 + t3
    t40 = 1/gap1**2
    t41 = t40*t5
    p1_by_k1 = t17*t39 - t30*t41
    t42 = t16*t3
    p2_by_k1 = gap1_by_k1*k1*t3*t40 - t42
    p3_by_k1 = gap1_by_k1*k1*t0*t40 - t19
    gap2_by_k1 = t26*(t20*t28 + t29)
    t43 = gap2_by_k1/2
    t44 = t21/2
    omega3_by_k1 = t44*(t33 + t43)
    t45 = t24/omega3**2
    omega4_by_k1 = -omega3_by_k1*t45 + t12*t13*t21*t23/(2*t22)
    t46 = 1/gap2**2
    t47 = t20*t46
    p4_by_k1 = t26*t39 - t43*t47
    p5_by_k1 = gap2_by_k1*k1*t3*t46 - t25*t3
    p6_by_k1 = gap2_by_k1*k1*t0*t46 - t27
    # d/dk2 of: spectrum
    gap1_by_k2 = -t19*t5
    t48 = gap1_by_k2/2
    omega1_by_k2 = t34*(t31 + t48)
    t49 = k1/2
    omega2_by_k2 = -omega1_by_k2*t38 + t37*(t36 + t49)
    p1_by_k2 = -t16*t31 - t41*t48
    t50 = gap1_by_k2*t40
    p2_by_k2 = t18*t50
    t51 = k1*t0
    p3_by_k2 = t50*t51
    gap2_by_k2 = -t20*t27
    t52 = gap2_by_k2/2
    omega3_by_k2 = t44*(t31 + t52)
    omega4_by_k2 = -omega3_by_k2*t45 + t12*t13*t21*t22/(2*t23)
    p4_by_k2 = -t25*t31 - t47*t52
    t53 = gap2_by_k2*t46
    p5_by_k2 = t18*t53
    p6_by_k2 = t51*t53
    # d/dk3 of: spectrum
    gap1_by_k3 = t42*t5
    t54 = gap1_by_k3/2
    omega1_by_k3 = t34*(t32 + t54)
    omega2_by_k3 = -omega1_by_k3*t38 + t37*(t35 + t49)
    p1_by_k3 = t16*t32 - t41*t54
    t55 = gap1_by_k3*t40
    p2_by_k3 = t18*t55
    p3_by_k3 = t51*t55
    # d/dm1 of: spectrum
    t56 = 1/m1**2
    t57 = t4*t56
    t58 = t56*t7
    gap1_by_m1 = t17*(-2*t5*t57 - t58)
    t59 = gap1_by_m1/2
    omega1_by_m1 = t34*(-t57/2 + t59)
    t60 = t10*t34
    t61 = t13/lib.sqrt(m1)**3
    omega2_by_m1 = -omega1_by_m1*t38 - t60*t61
    p1_by_m1 = -t17*t57 - t41*t59
    t62 = k1*t56
    t63 = gap1_by_m1*t40
    p2_by_m1 = t16*t62 + t18*t63
    p3_by_m1 = t51*t63
    gap2_by_m1 = t26*(-2*t20*t62 - t58)
    t64 = gap2_by_m1/2
    t65 = t49*t56
    omega3_by_m1 = t44*(t64 - t65)
    t66 = t22*t23*t44
    omega4_by_m1 = -omega3_by_m1*t45 - t61*t66
    p4_by_m1 = -t25*t65 - t47*t64
    t67 = gap2_by_m1*t46
    p5_by_m1 = t18*t67 + t25*t62
    p6_by_m1 = t51*t67
    # d/dm2 of: spectrum
    t68 = 1/m2**2
    t69 = 4*t3*t6*t68
    gap1_by_m2 = t17*(2*t1*t5*t68 - t69)
    t70 = gap1_by_m2/2
    t71 = t1*t68
    t72 = -t71/2
    omega1_by_m2 = t34*(t70 + t72)
    t73 = t12/lib.sqrt(m2)**3
    omega2_by_m2 = -omega1_by_m2*t38 - t60*t73
    p1_by_m2 = t17*t71 - t41*t70
    t74 = gap1_by_m2*t40
    p2_by_m2 = t18*t74
    t75 = k1*t68
    p3_by_m2 = t16*t75 + t51*t74
    gap2_by_m2 = t26*(2*t1*t20*t68 - t69)
    t76 = gap2_by_m2/2
    omega3_by_m2 = t44*(t72 + t76)
    omega4_by_m2 = -omega3_by_m2*t45 - t66*t73
    p4_by_m2 = t26*t71 - t47*t76
    t77 = gap2_by_m2*t46
    p5_by_m2 = t18*t77
    p6_by_m2 = t25*t75 + t51*t77
    return (
        [gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6],
        [[gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1, gap1_by_m2], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [gap2_by_k1, gap2_by_k2, 0, gap2_by_m1, gap2_by_m2], [omega3_by_k1, omega3_by_k2, 0, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, 0, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, 0, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, 0, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, 0, p6_by_m1, p6_by_m2]],
    )


def flow_contact(parameters, spectrum, time, state, lib):
    """State after a time in contact.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 133. Intermediate terms: 25.
    """
    [_, _, k1, k2, k3] = parameters
    [_, omega1, omega2, p1, p2, p3, _, _, _, _, _, _] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = omega1*t
    t1 = lib.sin(t0)
    t2 = 1/omega1
    t3 = t1*t2
    t4 = p1 - 1
    t6 = omega2*t
    t7 = lib.sin(t6)
    t8 = t7/omega2
    t9 = lib.cos(t0)
    t10 = lib.cos(t6)
    t11 = p1*t9 - t10*t4
    t12 = -p2*t10 + p2*t9
    t13 = k1*k3
    t14 = k2*k3 + t13
    t15 = 1/(k1*k2 + t14)
    t16 = t14*t15
    t17 = t13*t15
    t18 = p2*t17
    t19 = p1*t16
    t20 = -p3*t10 + p3*t9
    t21 = p1*t10 - t4*t9
    t22 = p3*t16
    t24 = p1*t17
    t25 = omega1*t1
    t26 = omega2*t7
    return [t10*(t16*t4 + t18) + t11*x1 + t12*x2 + t16 + t9*(-t18 - t19) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(t22 - t24) + t17 + t20*x1 + t21*x2 + t9*(t17*t4 - t22) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t18 + omega1*t19) + t11*v1 + t12*v2 + t7*(-omega2*t14*t15*t4 - omega2*t18) + x1*(-p1*t25 + t26*t4) + x2*(omega2*p2*t7 - p2*t25), t1*(-omega1*t17*t4 + omega1*t22) + t20*v1 + t21*v2 + t7*(-omega2*t22 + omega2*t24) + x1*(omega2*p3*t7 - p3*t25) + x2*(-p1*t26 + t25*t4)]


def flow_free(parameters, spectrum, time, state, lib):
    """State after a time in free.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, _, _, _, _, _, _, omega3, omega4, p4, p5, p6] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = 1/omega3
    t1 = omega3*t
    t2 = lib.sin(t1)
    t3 = t0*t2
    t4 = 1 - p4
    t5 = omega4*t
    t6 = lib.sin(t5)
    t7 = t6/omega4
    t8 = lib.cos(t1)
    t9 = lib.cos(t5)
    t10 = p4*t8 + t4*t9
    t11 = p5*t8 - p5*t9
    t12 = p6*t8 - p6*t9
    t13 = p4*t9 + t4*t8
    t14 = omega3*t2
    t15 = omega4*t6
    return [t10*x1 + t11*x2 + v1*(p4*t3 + t4*t7) + v2*(p5*t0*t2 - p5*t7), t12*x1 + t13*x2 + v1*(p6*t0*t2 - p6*t7) + v2*(p4*t7 + t3*t4), t10*v1 + t11*v2 + x1*(-p4*t14 - t15*t4) + x2*(omega4*p5*t6 - p5*t14), t12*v1 + t13*v2 + x1*(omega4*p6*t6 - p6*t14) + x2*(-p4*t15 - t14*t4)]


def fields(parameters, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives fields (8, 5).
    Operations: 12. Intermediate terms: 5.
    """
    [m1, m2, k1, k2, k3] = parameters
    # outputs
    t0 = 1/m1
    t1 = k1*t0
    t2 = 1/m2
    t3 = k1*t2
    t4 = -t2*(k1 + k2)
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t0*(k1 + k3), t1, 0, 0, k3*t0], [t3, t4, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-t1, t1, 0, 0, 0], [t3, t4, 0, 0, 0]]


def rows(parameters, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives rows (5, 5).
    Operations: 3. Intermediate terms: 0.
    """
    [_, _, _, _, k3] = parameters
    return [[-1, 0, 0, 0, 1], [1, 0, 0, 0, -1], [-k3, 0, 0, 0, k3], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0]]


def resets(parameters, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Gives resets (4, 5).
    Operations: 0. Intermediate terms: 0.
    """
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0]]


def modes(parameters, spectrum, lib):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (5): m1, m2, k1, k2, k3.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Gives exponents (6, 2).
    Gives coefficients (40, 5).
    Operations: 104. Intermediate terms: 20.
    """
    [_, _, k1, k2, k3] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    # outputs
    t0 = k1*k3
    t1 = k2*k3 + t0
    t2 = 1/(k1*k2 + t1)
    t3 = t1*t2
    t4 = t0*t2
    t5 = p2*t4
    t6 = p1 - 1
    t8 = -p3*t3
    t9 = 1/omega1
    t10 = omega1*p1
    t11 = omega1*p2
    t12 = omega1*p3
    t13 = -omega1*t6
    t16 = 1/omega2
    t17 = omega2*p2
    t18 = omega2*p3
    t19 = omega2*p1
    t20 = 1 - p4
    t21 = 1/omega3
    t24 = 1/omega4
    return (
        [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3], [0, omega4]],
        [[0, 0, 0, 0, t3], [0, 0, 0, 0, t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t3 - t5], [p3, -t6, 0, 0, t4*t6 + t8], [0, 0, p1, p2, 0], [0, 0, p3, -t6, 0], [0, 0, p1*t9, p2*t9, 0], [0, 0, p3*t9, -t6*t9, 0], [-t10, -t11, 0, 0, t10*t3 + t11*t4], [-t12, -t13, 0, 0, t12*t3 + t13*t4], [-t6, -p2, 0, 0, t3*t6 + t5], [-p3, p1, 0, 0, -p1*t4 - t8], [0, 0, -t6, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, -t16*t6, -p2*t16, 0], [0, 0, -p3*t16, p1*t16, 0], [omega2*t6, t17, 0, 0, -omega2*t1*t2*t6 - t17*t4], [t18, -t19, 0, 0, -t18*t3 + t19*t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p4, p5, 0, 0, 0], [p6, t20, 0, 0, 0], [0, 0, p4, p5, 0], [0, 0, p6, t20, 0], [0, 0, p4*t21, p5*t21, 0], [0, 0, p6*t21, t20*t21, 0], [-omega3*p4, -omega3*p5, 0, 0, 0], [-omega3*p6, -omega3*t20, 0, 0, 0], [t20, -p5, 0, 0, 0], [-p6, p4, 0, 0, 0], [0, 0, t20, -p5, 0], [0, 0, -p6, p4, 0], [0, 0, t20*t24, -p5*t24, 0], [0, 0, -p6*t24, p4*t24, 0], [-omega4*t20, omega4*p5, 0, 0, 0], [omega4*p6, -omega4*p4, 0, 0, 0]],
    )


def one_contact_residual(parameters, spectrum, unknowns, lib):
    """Switching and periodicity equations.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives residual (4).
    Operations: 121. Intermediate terms: 37.
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
    # outputs
    t4 = p1*u + p2*w
    t6 = k1*k2
    t7 = p1*t6
    t8 = k1*k3
    t9 = p2*t8
    t10 = t6*y
    t11 = k2*k3
    t12 = t11*y
    t13 = p2*t10 + p2*t12 + t7 + t9*y - t9
    t14 = 1/(t11 + t6 + t8)
    t15 = omega2*sin_omega2_half_tau*t14
    t16 = omega1*sin_omega1_half_tau*t14
    t17 = p3*u
    t18 = p1*w
    t19 = p1*t8
    t20 = p3*t6
    t21 = p4*u + p5*w
    t22 = p4 + p5*y
    t23 = omega4*sin_omega4_half_tau1
    t24 = omega3*sin_omega3_half_tau1
    t25 = p6*u
    t26 = p4*w
    return [cos_omega1_half_tau*t4 + cos_omega2_half_tau*(-t4 + u) - t13*t16 + t15*(t13 - t6), cos_omega1_half_tau*(t17 - t18 + w) + cos_omega2_half_tau*(-t17 + t18) - t15*(p1*t12 + t19*y - t19 - t20 + t7*y) + t16*(k1*k2*p1*y + k1*k3*p1*y + k1*k3 + k2*k3*p1*y - t10 - t12 - t19 - t20 - t8*y), -cos_omega3_half_tau1*t21 + cos_omega4_half_tau1*(t21 - u) - t22*t24 + t23*(t22 - 1), cos_omega3_half_tau1*(-t25 + t26 - w) + cos_omega4_half_tau1*(t25 - t26) - t23*(p4*y - p6) + t24*(p4*y - p6 - y)]


def one_contact_jacobian(parameters, spectrum, unknowns, lib):
    """Derivatives of the equations by the unknowns.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives jacobian (4, 4).
    Operations: 194. Intermediate terms: 56.
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
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t6 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t6)
    sin_omega3_half_tau1 = lib.sin(t6)
    t9 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t9)
    sin_omega4_half_tau1 = lib.sin(t9)
    # d/dtau of: functions of half_tau in contact
    t12 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t12
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t12
    t13 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t13
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t13
    # d/dtau of: functions of half_tau1 in free
    t14 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t14
    sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t14
    t15 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t15
    sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t15
    # outputs
    t16 = k1*k2
    t17 = k1*k3
    t18 = k2*k3
    t19 = 1/(t16 + t17 + t18)
    t20 = p2*t16
    t21 = p2*t17
    t22 = p2*t18
    t23 = t20 + t21 + t22
    t24 = omega1*sin_omega1_half_tau
    t25 = 1 - p1
    t26 = p1*u + p2*w
    t29 = p1*t16
    t30 = t20*y + t21*y - t21 + t22*y + t29
    t31 = omega2*sin_omega2_half_tau_by_tau*t19
    t32 = omega1*sin_omega1_half_tau_by_tau*t19
    t34 = p1*t17
    t35 = p1*t18
    t36 = t29 + t34 + t35
    t37 = p3*u
    t38 = p1*w
    t39 = p3*t16
    t40 = omega3*sin_omega3_half_tau1
    t41 = p4 - 1
    t42 = p4*u + p5*w
    t43 = p5*y
    t44 = omega4*sin_omega4_half_tau1_by_tau
    t45 = omega3*sin_omega3_half_tau1_by_tau
    t46 = p6*u
    t47 = p4*w
    return [[omega2*sin_omega2_half_tau*t19*t23 - t19*t23*t24, cos_omega1_half_tau*p1 + cos_omega2_half_tau*t25, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, cos_omega1_half_tau_by_tau*t26 + cos_omega2_half_tau_by_tau*(-t26 + u) - t30*t32 + t31*(-t16 + t30)], [-omega2*sin_omega2_half_tau*t19*t36 + t19*t24*(-t16 - t17 - t18 + t36), cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, cos_omega1_half_tau*t25 + cos_omega2_half_tau*p1, cos_omega1_half_tau_by_tau*(t37 - t38 + w) + cos_omega2_half_tau_by_tau*(-t37 + t38) - t31*(t29*y + t34*y - t34 + t35*y - t39) + t32*(k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t16*y - t17*y + t17 - t18*y - t34 - t39)], [omega4*p5*sin_omega4_half_tau1 - p5*t40, -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t41, -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5, -cos_omega3_half_tau1_by_tau*t42 + cos_omega4_half_tau1_by_tau*(t42 - u) + t44*(t41 + t43) - t45*(p4 + t43)], [-omega4*p4*sin_omega4_half_tau1 + t40*t41, -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6, cos_omega3_half_tau1*t41 - cos_omega4_half_tau1*p4, cos_omega3_half_tau1_by_tau*(-t46 + t47 - w) + cos_omega4_half_tau1_by_tau*(t46 - t47) - t44*(p4*y - p6) + t45*(p4*y - p6 - y)]]


def one_contact_residual_and_jacobian(parameters, spectrum, unknowns, lib):
    """Equations and their derivatives by the unknowns, sharing all intermediate terms.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives residual (4).
    Gives jacobian (4, 4).
    Operations: 219. Intermediate terms: 71.
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
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t6 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t6)
    sin_omega3_half_tau1 = lib.sin(t6)
    t9 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t9)
    sin_omega4_half_tau1 = lib.sin(t9)
    # d/dtau of: functions of half_tau in contact
    t12 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t12
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t12
    t13 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t13
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t13
    # d/dtau of: functions of half_tau1 in free
    t14 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t14
    sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t14
    t15 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t15
    sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t15
    # outputs
    t16 = p1*u + p2*w
    t18 = -t16 + u
    t19 = k1*k2
    t21 = p1*t19
    t22 = k1*k3
    t23 = p2*t22
    t24 = t19*y
    t25 = k2*k3
    t26 = t25*y
    t27 = p2*t24 + p2*t26 + t21 + t23*y - t23
    t28 = -t19 + t27
    t29 = 1/(t19 + t22 + t25)
    t30 = omega2*t29
    t31 = sin_omega2_half_tau*t30
    t32 = omega1*t29
    t33 = sin_omega1_half_tau*t32
    t34 = p3*u
    t35 = p1*w
    t36 = t34 - t35 + w
    t37 = -t34 + t35
    t39 = p1*t22
    t40 = p3*t19
    t41 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t22*y + t22 - t24 - t26 - t39 - t40
    t42 = p1*t26 + t21*y + t39*y - t39 - t40
    t43 = p4*u + p5*w
    t45 = t43 - u
    t46 = p4 + p5*y
    t47 = t46 - 1
    t48 = omega4*sin_omega4_half_tau1
    t49 = omega3*sin_omega3_half_tau1
    t50 = p6*u
    t51 = p4*w
    t52 = -t50 + t51 - w
    t53 = t50 - t51
    t54 = p4*y - p6 - y
    t55 = p4*y - p6
    t56 = p2*t19 + p2*t25 + t23
    t57 = 1 - p1
    t58 = sin_omega2_half_tau_by_tau*t30
    t59 = sin_omega1_half_tau_by_tau*t32
    t60 = p1*t25 + t21 + t39
    t61 = p4 - 1
    t62 = omega4*sin_omega4_half_tau1_by_tau
    t63 = omega3*sin_omega3_half_tau1_by_tau
    return (
        [cos_omega1_half_tau*t16 + cos_omega2_half_tau*t18 - t27*t33 + t28*t31, cos_omega1_half_tau*t36 + cos_omega2_half_tau*t37 - t31*t42 + t33*t41, -cos_omega3_half_tau1*t43 + cos_omega4_half_tau1*t45 - t46*t49 + t47*t48, cos_omega3_half_tau1*t52 + cos_omega4_half_tau1*t53 - t48*t55 + t49*t54],
        [[omega2*sin_omega2_half_tau*t29*t56 - t33*t56, cos_omega1_half_tau*p1 + cos_omega2_half_tau*t57, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, cos_omega1_half_tau_by_tau*t16 + cos_omega2_half_tau_by_tau*t18 - t27*t59 + t28*t58], [-t31*t60 + t33*(-t19 - t22 - t25 + t60), cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, cos_omega1_half_tau*t57 + cos_omega2_half_tau*p1, cos_omega1_half_tau_by_tau*t36 + cos_omega2_half_tau_by_tau*t37 + t41*t59 - t42*t58], [omega4*p5*sin_omega4_half_tau1 - p5*t49, -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t61, -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5, -cos_omega3_half_tau1_by_tau*t43 + cos_omega4_half_tau1_by_tau*t45 - t46*t63 + t47*t62], [-p4*t48 + t49*t61, -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6, cos_omega3_half_tau1*t61 - cos_omega4_half_tau1*p4, cos_omega3_half_tau1_by_tau*t52 + cos_omega4_half_tau1_by_tau*t53 + t54*t63 - t55*t62]],
    )


def one_contact_parameter_jacobian(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Total derivatives of the equations by the parameters, through the spectrum too.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes spectrum_derivatives (12, 5): gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1,
        gap1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2,
        omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2, p1_by_k1,
        p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2, p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1,
        p2_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2, gap2_by_k1, gap2_by_k2,
        gap2_by_k3, gap2_by_m1, gap2_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3,
        omega3_by_m1, omega3_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1,
        omega4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2, p5_by_k1, p5_by_k2,
        p5_by_k3, p5_by_m1, p5_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2.
    Takes unknowns (4): y, u, w, tau.
    Gives parameter_jacobian (4, 6).
    Operations: 655. Intermediate terms: 170.
    """
    [_, _, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [[_, _, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [_, _, _, _, _], [omega3_by_k1, omega3_by_k2, omega3_by_k3, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, p5_by_k3, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2]] = spectrum_derivatives
    [y, u, w, tau] = unknowns
    # half of tau
    half_tau = tau/2
    # functions of half_tau in contact
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t6 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t6)
    sin_omega3_half_tau1 = lib.sin(t6)
    t9 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t9)
    sin_omega4_half_tau1 = lib.sin(t9)
    # d/dm1 of: functions of half_tau in contact
    t12 = half_tau*omega1_by_m1
    cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t12
    sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t12
    t13 = half_tau*omega2_by_m1
    cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t13
    sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t13
    # d/dm2 of: functions of half_tau in contact
    t14 = half_tau*omega1_by_m2
    cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t14
    sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t14
    t15 = half_tau*omega2_by_m2
    cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t15
    sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t15
    # d/dk1 of: functions of half_tau in contact
    t16 = half_tau*omega1_by_k1
    cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t16
    sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t16
    t17 = half_tau*omega2_by_k1
    cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t17
    sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t17
    # d/dk2 of: functions of half_tau in contact
    t18 = half_tau*omega1_by_k2
    cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t18
    sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t18
    t19 = half_tau*omega2_by_k2
    cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t19
    sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t19
    # d/dk3 of: functions of half_tau in contact
    t20 = half_tau*omega1_by_k3
    cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t20
    sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t20
    t21 = half_tau*omega2_by_k3
    cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t21
    sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t21
    # d/dm1 of: functions of half_tau1 in free
    t22 = half_tau1*omega3_by_m1
    cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t22
    sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t22
    t23 = half_tau1*omega4_by_m1
    cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t23
    sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t23
    # d/dm2 of: functions of half_tau1 in free
    t24 = half_tau1*omega3_by_m2
    cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t24
    sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t24
    t25 = half_tau1*omega4_by_m2
    cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t25
    sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t25
    # d/dk1 of: functions of half_tau1 in free
    t26 = half_tau1*omega3_by_k1
    cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t26
    sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t26
    t27 = half_tau1*omega4_by_k1
    cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t27
    sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t27
    # d/dk2 of: functions of half_tau1 in free
    t28 = half_tau1*omega3_by_k2
    cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t28
    sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t28
    t29 = half_tau1*omega4_by_k2
    cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t29
    sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t29
    # d/dk3 of: functions of half_tau1 in free
    t30 = half_tau1*omega3_by_k3
    cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t30
    sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t30
    t31 = half_tau1*omega4_by_k3
    cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t31
    sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t31
    # d/dT of: functions of half_tau1 in free
    t32 = omega3/2
    cos_omega3_half_tau1_by_T = -sin_omega3_half_tau1*t32
    sin_omega3_half_tau1_by_T = cos_omega3_half_tau1*t32
    t33 = omega4/2
    cos_omega4_half_tau1_by_T = -sin_omega4_half_tau1*t33
    sin_omega4_half_tau1_by_T = cos_omega4_half_tau1*t33
    # outputs
    t34 = p1*u + p2*w
    t36 = -t34 + u
    t37 = k1*k2
    t38 = k1*k3
    t39 = k2*k3
    t40 = t37 + t38 + t39
    t41 = 1/t40
    t42 = omega2*sin_omega2_half_tau
    t43 = t41*t42
    t44 = omega1*sin_omega1_half_tau
    t45 = t41*t44
    t46 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t37*t43 - t37*t45
    t47 = t37*y
    t48 = t38*y
    t49 = t39*y
    t50 = -t38 + t47 + t48 + t49
    t51 = t41*t50
    t52 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t42*t51 - t44*t51
    t53 = p1*t37 - p2*t38 + p2*t47 + p2*t48 + p2*t49
    t54 = -t37 + t53
    t55 = t41*t54
    t56 = sin_omega2_half_tau*t55
    t57 = omega2*t55
    t58 = t41*t53
    t59 = sin_omega1_half_tau*t58
    t60 = omega1*t58
    t61 = k2*p1
    t62 = k3*p2
    t63 = k2*y
    t64 = p2*t63
    t65 = t62*y
    t66 = t61 - t62 + t64 + t65
    t67 = 1/t40**2
    t68 = t67*(-k2 - k3)
    t69 = t42*t54
    t70 = t44*t53
    t71 = k1*p1
    t72 = k1*p2
    t73 = t72*y
    t74 = t65 + t71 + t73
    t75 = t67*(-k1 - k3)
    t76 = t64 - t72 + t73
    t77 = t67*(-k1 - k2)
    t78 = p3*u
    t79 = p1*w
    t80 = t78 - t79 + w
    t81 = -t78 + t79
    t83 = p1*t38
    t84 = p3*t37
    t85 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t50 - t83 - t84
    t86 = t41*t85
    t87 = sin_omega1_half_tau*t86
    t88 = omega1*t86
    t89 = p1*t47 + p1*t48 + p1*t49 - t83 - t84
    t90 = t41*t89
    t91 = sin_omega2_half_tau*t90
    t92 = omega2*t90
    t93 = k3*p1
    t94 = k2*p3
    t95 = -k3*p1*y + k3*y
    t96 = t61*y
    t97 = t93*y
    t98 = t44*t85
    t99 = t42*t89
    t100 = k1*p3
    t101 = k1*y
    t102 = t71*y
    t103 = t102 - t71 + t96
    t104 = p4*u + p5*w
    t106 = t104 - u
    t107 = omega3*sin_omega3_half_tau1
    t108 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + omega4*sin_omega4_half_tau1 - t107
    t109 = cos_omega3_half_tau1*w - cos_omega4_half_tau1*w - omega4*sin_omega4_half_tau1*y + t107*y
    t111 = p4 + p5*y
    t112 = t111 - 1
    t113 = sin_omega4_half_tau1*t112
    t114 = omega4*t112
    t115 = sin_omega3_half_tau1*t111
    t116 = omega3*t111
    t117 = p6*u
    t118 = p4*w
    t119 = -t117 + t118 - w
    t120 = t117 - t118
    t121 = p4*y - p6 - y
    t122 = sin_omega3_half_tau1*t121
    t123 = omega3*t121
    t124 = p4*y - p6
    t125 = sin_omega4_half_tau1*t124
    t126 = omega4*t124
    return [[cos_omega1_half_tau_by_m1*t34 + cos_omega2_half_tau_by_m1*t36 - omega1_by_m1*t59 + omega2_by_m1*t56 + p1_by_m1*t46 + p2_by_m1*t52 - sin_omega1_half_tau_by_m1*t60 + sin_omega2_half_tau_by_m1*t57, cos_omega1_half_tau_by_m2*t34 + cos_omega2_half_tau_by_m2*t36 - omega1_by_m2*t59 + omega2_by_m2*t56 + p1_by_m2*t46 + p2_by_m2*t52 - sin_omega1_half_tau_by_m2*t60 + sin_omega2_half_tau_by_m2*t57, cos_omega1_half_tau_by_k1*t34 + cos_omega2_half_tau_by_k1*t36 - omega1_by_k1*t59 + omega2_by_k1*t56 + p1_by_k1*t46 + p2_by_k1*t52 - sin_omega1_half_tau_by_k1*t60 + sin_omega2_half_tau_by_k1*t57 + t43*(-k2 + t66) - t45*t66 + t68*t69 - t68*t70, cos_omega1_half_tau_by_k2*t34 + cos_omega2_half_tau_by_k2*t36 - omega1_by_k2*t59 + omega2_by_k2*t56 + p1_by_k2*t46 + p2_by_k2*t52 - sin_omega1_half_tau_by_k2*t60 + sin_omega2_half_tau_by_k2*t57 + t43*(-k1 + t74) - t45*t74 + t69*t75 - t70*t75, cos_omega1_half_tau_by_k3*t34 + cos_omega2_half_tau_by_k3*t36 - omega1_by_k3*t59 + omega2_by_k3*t56 + p1_by_k3*t46 + p2_by_k3*t52 - sin_omega1_half_tau_by_k3*t60 + sin_omega2_half_tau_by_k3*t57 + t43*t76 - t45*t76 + t69*t77 - t70*t77, 0], [cos_omega1_half_tau_by_m1*t80 + cos_omega2_half_tau_by_m1*t81 + omega1_by_m1*t87 - omega2_by_m1*t91 - p1_by_m1*t52 + p3_by_m1*t46 + sin_omega1_half_tau_by_m1*t88 - sin_omega2_half_tau_by_m1*t92, cos_omega1_half_tau_by_m2*t80 + cos_omega2_half_tau_by_m2*t81 + omega1_by_m2*t87 - omega2_by_m2*t91 - p1_by_m2*t52 + p3_by_m2*t46 + sin_omega1_half_tau_by_m2*t88 - sin_omega2_half_tau_by_m2*t92, cos_omega1_half_tau_by_k1*t80 + cos_omega2_half_tau_by_k1*t81 + omega1_by_k1*t87 - omega2_by_k1*t91 - p1_by_k1*t52 + p3_by_k1*t46 + sin_omega1_half_tau_by_k1*t88 - sin_omega2_half_tau_by_k1*t92 - t43*(-t93 - t94 + t96 + t97) + t45*(k2*p1*y + k3 - t63 - t93 - t94 - t95) + t68*t98 - t68*t99, cos_omega1_half_tau_by_k2*t80 + cos_omega2_half_tau_by_k2*t81 + omega1_by_k2*t87 - omega2_by_k2*t91 - p1_by_k2*t52 + p3_by_k2*t46 + sin_omega1_half_tau_by_k2*t88 - sin_omega2_half_tau_by_k2*t92 - t43*(-t100 + t102 + t97) + t45*(k1*p1*y - t100 - t101 - t95) + t75*t98 - t75*t99, cos_omega1_half_tau_by_k3*t80 + cos_omega2_half_tau_by_k3*t81 + omega1_by_k3*t87 - omega2_by_k3*t91 - p1_by_k3*t52 + p3_by_k3*t46 + sin_omega1_half_tau_by_k3*t88 - sin_omega2_half_tau_by_k3*t92 - t103*t43 + t45*(k1 - t101 + t103 - t63) + t77*t98 - t77*t99, 0], [-cos_omega3_half_tau1_by_m1*t104 + cos_omega4_half_tau1_by_m1*t106 - omega3_by_m1*t115 + omega4_by_m1*t113 + p4_by_m1*t108 - p5_by_m1*t109 - sin_omega3_half_tau1_by_m1*t116 + sin_omega4_half_tau1_by_m1*t114, -cos_omega3_half_tau1_by_m2*t104 + cos_omega4_half_tau1_by_m2*t106 - omega3_by_m2*t115 + omega4_by_m2*t113 + p4_by_m2*t108 - p5_by_m2*t109 - sin_omega3_half_tau1_by_m2*t116 + sin_omega4_half_tau1_by_m2*t114, -cos_omega3_half_tau1_by_k1*t104 + cos_omega4_half_tau1_by_k1*t106 - omega3_by_k1*t115 + omega4_by_k1*t113 + p4_by_k1*t108 - p5_by_k1*t109 - sin_omega3_half_tau1_by_k1*t116 + sin_omega4_half_tau1_by_k1*t114, -cos_omega3_half_tau1_by_k2*t104 + cos_omega4_half_tau1_by_k2*t106 - omega3_by_k2*t115 + omega4_by_k2*t113 + p4_by_k2*t108 - p5_by_k2*t109 - sin_omega3_half_tau1_by_k2*t116 + sin_omega4_half_tau1_by_k2*t114, -cos_omega3_half_tau1_by_k3*t104 + cos_omega4_half_tau1_by_k3*t106 - omega3_by_k3*t115 + omega4_by_k3*t113 + p4_by_k3*t108 - p5_by_k3*t109 - sin_omega3_half_tau1_by_k3*t116 + sin_omega4_half_tau1_by_k3*t114, -cos_omega3_half_tau1_by_T*t104 + cos_omega4_half_tau1_by_T*t106 - sin_omega3_half_tau1_by_T*t116 + sin_omega4_half_tau1_by_T*t114], [cos_omega3_half_tau1_by_m1*t119 + cos_omega4_half_tau1_by_m1*t120 + omega3_by_m1*t122 - omega4_by_m1*t125 + p4_by_m1*t109 + p6_by_m1*t108 + sin_omega3_half_tau1_by_m1*t123 - sin_omega4_half_tau1_by_m1*t126, cos_omega3_half_tau1_by_m2*t119 + cos_omega4_half_tau1_by_m2*t120 + omega3_by_m2*t122 - omega4_by_m2*t125 + p4_by_m2*t109 + p6_by_m2*t108 + sin_omega3_half_tau1_by_m2*t123 - sin_omega4_half_tau1_by_m2*t126, cos_omega3_half_tau1_by_k1*t119 + cos_omega4_half_tau1_by_k1*t120 + omega3_by_k1*t122 - omega4_by_k1*t125 + p4_by_k1*t109 + p6_by_k1*t108 + sin_omega3_half_tau1_by_k1*t123 - sin_omega4_half_tau1_by_k1*t126, cos_omega3_half_tau1_by_k2*t119 + cos_omega4_half_tau1_by_k2*t120 + omega3_by_k2*t122 - omega4_by_k2*t125 + p4_by_k2*t109 + p6_by_k2*t108 + sin_omega3_half_tau1_by_k2*t123 - sin_omega4_half_tau1_by_k2*t126, cos_omega3_half_tau1_by_k3*t119 + cos_omega4_half_tau1_by_k3*t120 + omega3_by_k3*t122 - omega4_by_k3*t125 + p4_by_k3*t109 + p6_by_k3*t108 + sin_omega3_half_tau1_by_k3*t123 - sin_omega4_half_tau1_by_k3*t126, cos_omega3_half_tau1_by_T*t119 + cos_omega4_half_tau1_by_T*t120 + sin_omega3_half_tau1_by_T*t123 - sin_omega4_half_tau1_by_T*t126]]


def one_contact_poincare_jacobian(parameters, spectrum, unknowns, lib):
    """Jacobian of the Poincare map in the section's coordinates.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives poincare_jacobian (3, 3).
    Operations: 372. Intermediate terms: 127.
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
    t2 = k1*k3
    t3 = k2*k3 + t2
    t4 = 1/(k1*k2 + t3)
    t5 = t3*t4
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = p1 - 1
    t10 = 1/omega1
    t11 = sin_omega1_tau*t10
    t13 = sin_omega2_tau/omega2
    t14 = p1*t11 - t13*t9
    t15 = p2*sin_omega1_tau*t10 - p2*t13
    t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5
    t18 = p3*t5
    t20 = p1*t7
    t21 = p3*sin_omega1_tau*t10 - p3*t13
    t22 = p1*t13 - t11*t9
    t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7
    t25 = omega1*sin_omega1_tau
    t26 = omega2*p2*sin_omega2_tau - p2*t25
    t27 = omega2*sin_omega2_tau
    v1_1 = -p1*t25 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y + t27*t9
    t28 = -p1*t27 + t25*t9
    v2_1 = -p3*t25 + p3*t27 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t28*y
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t29 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t29)
    sin_omega3_tau1 = lib.sin(t29)
    t30 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t30)
    sin_omega4_tau1 = lib.sin(t30)
    # free for tau1, until first-reaches-stop
    t31 = 1/omega3
    t32 = sin_omega3_tau1*t31
    t33 = 1 - p4
    t34 = sin_omega4_tau1/omega4
    t35 = p4*t32 + t33*t34
    t36 = p5*sin_omega3_tau1*t31 - p5*t34
    t37 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33
    t38 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t35*v1_1 + t36*v2_1 + t37*x1_1 + t38*x2_1
    t39 = p6*sin_omega3_tau1*t31 - p6*t34
    t40 = p4*t34 + t32*t33
    t41 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t42 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4
    x2_2 = t39*v1_1 + t40*v2_1 + t41*x1_1 + t42*x2_1
    t43 = omega3*sin_omega3_tau1
    t44 = omega4*sin_omega4_tau1
    t45 = -p4*t43 - t33*t44
    t46 = omega4*p5*sin_omega4_tau1 - p5*t43
    v1_2 = t37*v1_1 + t38*v2_1 + t45*x1_1 + t46*x2_1
    t47 = omega4*p6*sin_omega4_tau1 - p6*t43
    t48 = -p4*t44 - t33*t43
    v2_2 = t41*v1_1 + t42*v2_1 + t47*x1_1 + t48*x2_1
    # Phi along tau
    carried_x1_1_by_y = t16
    carried_x1_1_by_u = t14
    carried_x1_1_by_w = t15
    carried_x2_1_by_y = t23
    carried_x2_1_by_u = t21
    carried_x2_1_by_w = t22
    carried_v1_1_by_y = t26
    carried_v1_1_by_u = t17
    carried_v1_1_by_w = t16
    carried_v2_1_by_y = t28
    carried_v2_1_by_u = t24
    carried_v2_1_by_w = t23
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t49 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t49
    delay_tau_by_u = carried_x1_1_by_u*t49
    delay_tau_by_w = carried_x1_1_by_w*t49
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t50 = 1/m1
    t51 = k1*t50
    t52 = k3*t50 - t50*x1_1*(k1 + k3) + t51*x2_1
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t52
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t52
    v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t52
    t53 = 1/m2
    t54 = k1*t53
    t55 = t53*(k1 + k2)
    t56 = t54*x1_1 - t55*x2_1
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t56
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t56
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t56
    # Phi along tau1
    carried_x1_2_by_y = t35*v1_1_on_boundary_by_y + t36*v2_1_on_boundary_by_y + t37*x1_1_on_boundary_by_y + t38*x2_1_on_boundary_by_y
    carried_x1_2_by_u = t35*v1_1_on_boundary_by_u + t36*v2_1_on_boundary_by_u + t37*x1_1_on_boundary_by_u + t38*x2_1_on_boundary_by_u
    carried_x1_2_by_w = t35*v1_1_on_boundary_by_w + t36*v2_1_on_boundary_by_w + t37*x1_1_on_boundary_by_w + t38*x2_1_on_boundary_by_w
    carried_x2_2_by_y = t39*v1_1_on_boundary_by_y + t40*v2_1_on_boundary_by_y + t41*x1_1_on_boundary_by_y + t42*x2_1_on_boundary_by_y
    carried_x2_2_by_u = t39*v1_1_on_boundary_by_u + t40*v2_1_on_boundary_by_u + t41*x1_1_on_boundary_by_u + t42*x2_1_on_boundary_by_u
    carried_x2_2_by_w = t39*v1_1_on_boundary_by_w + t40*v2_1_on_boundary_by_w + t41*x1_1_on_boundary_by_w + t42*x2_1_on_boundary_by_w
    carried_v1_2_by_y = t37*v1_1_on_boundary_by_y + t38*v2_1_on_boundary_by_y + t45*x1_1_on_boundary_by_y + t46*x2_1_on_boundary_by_y
    carried_v1_2_by_u = t37*v1_1_on_boundary_by_u + t38*v2_1_on_boundary_by_u + t45*x1_1_on_boundary_by_u + t46*x2_1_on_boundary_by_u
    carried_v1_2_by_w = t37*v1_1_on_boundary_by_w + t38*v2_1_on_boundary_by_w + t45*x1_1_on_boundary_by_w + t46*x2_1_on_boundary_by_w
    carried_v2_2_by_y = t41*v1_1_on_boundary_by_y + t42*v2_1_on_boundary_by_y + t47*x1_1_on_boundary_by_y + t48*x2_1_on_boundary_by_y
    carried_v2_2_by_u = t41*v1_1_on_boundary_by_u + t42*v2_1_on_boundary_by_u + t47*x1_1_on_boundary_by_u + t48*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t41*v1_1_on_boundary_by_w + t42*v2_1_on_boundary_by_w + t47*x1_1_on_boundary_by_w + t48*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t57 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t57
    delay_tau1_by_u = -carried_x1_2_by_u*t57
    delay_tau1_by_w = -carried_x1_2_by_w*t57
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2
    x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2
    t58 = k1*t50*x2_2 - t51*x1_2
    v1_2_on_boundary_by_y = carried_v1_2_by_y + delay_tau1_by_y*t58
    v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t58
    v1_2_on_boundary_by_w = carried_v1_2_by_w + delay_tau1_by_w*t58
    t59 = t54*x1_2 - t55*x2_2
    v2_2_on_boundary_by_y = carried_v2_2_by_y + delay_tau1_by_y*t59
    v2_2_on_boundary_by_u = carried_v2_2_by_u + delay_tau1_by_u*t59
    v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t59
    return [[x2_2_on_boundary_by_y, x2_2_on_boundary_by_u, x2_2_on_boundary_by_w], [v1_2_on_boundary_by_y, v1_2_on_boundary_by_u, v1_2_on_boundary_by_w], [v2_2_on_boundary_by_y, v2_2_on_boundary_by_u, v2_2_on_boundary_by_w]]


def one_contact_saltations(parameters, spectrum, unknowns, lib):
    """Saltation matrices of the transitions, one below the other.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives saltations (8, 4).
    Operations: 239. Intermediate terms: 63.
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
    t2 = k1*k3
    t3 = k2*k3 + t2
    t4 = 1/(k1*k2 + t3)
    t5 = t3*t4
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = p1 - 1
    t10 = 1/omega1
    t11 = sin_omega1_tau*t10
    t13 = sin_omega2_tau/omega2
    t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t15 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*y + t15 + t5 + u*(p1*t11 - t13*t9) + w*(p2*sin_omega1_tau*t10 - p2*t13)
    t16 = p3*t5
    t18 = p1*t7
    t19 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t20 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(-t16 + t7*t9) + cos_omega2_tau*(t16 - t18) + t19*y + t20 + t7 + u*(p3*sin_omega1_tau*t10 - p3*t13) + w*(p1*t13 - t11*t9)
    t21 = omega1*sin_omega1_tau
    t22 = omega2*sin_omega2_tau
    v1_1 = -p1*t21 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t14*w + t15*u + t22*t9 + y*(omega2*p2*sin_omega2_tau - p2*t21)
    v2_1 = -p3*t21 + p3*t22 + sin_omega1_tau*(omega1*t16 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t16 + omega2*t18) + t19*w + t20*u + y*(-p1*t22 + t21*t9)
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t23 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t23)
    sin_omega3_tau1 = lib.sin(t23)
    t24 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t24)
    sin_omega4_tau1 = lib.sin(t24)
    # free for tau1, until first-reaches-stop
    t25 = 1/omega3
    t26 = sin_omega3_tau1*t25
    t27 = 1 - p4
    t28 = sin_omega4_tau1/omega4
    t29 = cos_omega3_tau1*p4 + cos_omega4_tau1*t27
    t30 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t29*x1_1 + t30*x2_1 + v1_1*(p4*t26 + t27*t28) + v2_1*(p5*sin_omega3_tau1*t25 - p5*t28)
    x2_2 = v1_1*(p6*sin_omega3_tau1*t25 - p6*t28) + v2_1*(p4*t28 + t26*t27) + x1_1*(cos_omega3_tau1*p6 - cos_omega4_tau1*p6) + x2_1*(cos_omega3_tau1*t27 + cos_omega4_tau1*p4)
    t31 = omega3*sin_omega3_tau1
    v1_2 = t29*v1_1 + t30*v2_1 + x1_1*(-omega4*sin_omega4_tau1*t27 - p4*t31) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t31)
    # vector fields at transition 1
    t32 = 1/m1
    t33 = k3*t32
    t34 = k1*t32
    t35 = t32*(k1 + k3)
    before_v1_1 = t33 + t34*x2_1 - t35*x1_1
    t36 = 1/m2
    t37 = k1*t36
    t38 = t36*(k1 + k2)
    before_v2_1 = t37*x1_1 - t38*x2_1
    behind_v1_1 = k1*t32*x2_1 - t34*x1_1
    behind_v2_1 = before_v2_1
    # vector fields at transition 2
    before_v1_2 = k1*t32*x2_2 - t34*x1_2
    before_v2_2 = t37*x1_2 - t38*x2_2
    behind_v1_2 = t33 + t34*x2_2 - t35*x1_2
    behind_v2_2 = before_v2_2
    # outputs
    t41 = 1/v1_1
    t42 = 1/v1_2
    return [[1, 0, 0, 0], [0, 1, 0, 0], [-t41*(before_v1_1 - behind_v1_1), 0, 1, 0], [-t41*(before_v2_1 - behind_v2_1), 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [t42*(-before_v1_2 + behind_v1_2), 0, 1, 0], [t42*(-before_v2_2 + behind_v2_2), 0, 0, 1]]


def one_contact_monodromy(parameters, spectrum, unknowns, lib):
    """Monodromy matrix: the product of flows and saltation matrices over a period.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives monodromy (4, 4).
    Operations: 395. Intermediate terms: 135.
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
    t2 = k1*k3
    t3 = k2*k3 + t2
    t4 = 1/(k1*k2 + t3)
    t5 = t3*t4
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = p1 - 1
    t10 = 1/omega1
    t11 = sin_omega1_tau*t10
    t13 = sin_omega2_tau/omega2
    t14 = p1*t11 - t13*t9
    t15 = p2*sin_omega1_tau*t10 - p2*t13
    t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5
    t18 = p3*t5
    t20 = p1*t7
    t21 = p3*sin_omega1_tau*t10 - p3*t13
    t22 = p1*t13 - t11*t9
    t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7
    t25 = omega1*sin_omega1_tau
    t26 = omega2*p2*sin_omega2_tau - p2*t25
    t27 = p1*t25
    t28 = omega2*sin_omega2_tau
    t29 = -t28*t9
    v1_1 = sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y - t27 - t29
    t30 = -p1*t28 + t25*t9
    t31 = p3*t25
    v2_1 = p3*t28 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t30*y - t31
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t32 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t32)
    sin_omega3_tau1 = lib.sin(t32)
    t33 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t33)
    sin_omega4_tau1 = lib.sin(t33)
    # free for tau1, until first-reaches-stop
    t34 = 1/omega3
    t35 = sin_omega3_tau1*t34
    t36 = 1 - p4
    t37 = sin_omega4_tau1/omega4
    t38 = p4*t35 + t36*t37
    t39 = p5*sin_omega3_tau1*t34 - p5*t37
    t40 = cos_omega3_tau1*p4 + cos_omega4_tau1*t36
    t41 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t38*v1_1 + t39*v2_1 + t40*x1_1 + t41*x2_1
    t42 = p6*sin_omega3_tau1*t34 - p6*t37
    t43 = p4*t37 + t35*t36
    t44 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t45 = cos_omega3_tau1*t36 + cos_omega4_tau1*p4
    x2_2 = t42*v1_1 + t43*v2_1 + t44*x1_1 + t45*x2_1
    t46 = omega3*sin_omega3_tau1
    t47 = omega4*sin_omega4_tau1
    t48 = -p4*t46 - t36*t47
    t49 = omega4*p5*sin_omega4_tau1 - p5*t46
    v1_2 = t40*v1_1 + t41*v2_1 + t48*x1_1 + t49*x2_1
    # vector fields at transition 1
    t50 = 1/m1
    t51 = k3*t50
    t52 = k1*t50
    t53 = t50*(k1 + k3)
    before_v1_1 = t51 + t52*x2_1 - t53*x1_1
    t54 = 1/m2
    t55 = k1*t54
    t56 = t54*(k1 + k2)
    before_v2_1 = t55*x1_1 - t56*x2_1
    behind_v1_1 = k1*t50*x2_1 - t52*x1_1
    behind_v2_1 = before_v2_1
    # vector fields at transition 2
    before_v1_2 = k1*t50*x2_2 - t52*x1_2
    before_v2_2 = t55*x1_2 - t56*x2_2
    behind_v1_2 = t51 + t52*x2_2 - t53*x1_2
    behind_v2_2 = before_v2_2
    # Phi of phase 1
    phi_1_00 = t17
    phi_1_01 = t16
    phi_1_02 = t14
    phi_1_03 = t15
    phi_1_10 = t24
    phi_1_11 = t23
    phi_1_12 = t21
    phi_1_13 = t22
    phi_1_20 = -t27 - t29
    phi_1_21 = t26
    phi_1_22 = t17
    phi_1_23 = t16
    phi_1_30 = omega2*p3*sin_omega2_tau - t31
    phi_1_31 = t30
    phi_1_32 = t24
    phi_1_33 = t23
    # saltation of phase 1
    t59 = 1/v1_1
    t60 = t59*(before_v1_1 - behind_v1_1)
    saltation_1_20 = -phi_1_00*t60 + phi_1_20
    saltation_1_21 = -phi_1_01*t60 + phi_1_21
    saltation_1_22 = -phi_1_02*t60 + phi_1_22
    saltation_1_23 = -phi_1_03*t60 + phi_1_23
    t61 = t59*(before_v2_1 - behind_v2_1)
    saltation_1_30 = -phi_1_00*t61 + phi_1_30
    saltation_1_31 = -phi_1_01*t61 + phi_1_31
    saltation_1_32 = -phi_1_02*t61 + phi_1_32
    saltation_1_33 = -phi_1_03*t61 + phi_1_33
    # Phi of phase 2
    phi_2_00 = phi_1_00*t40 + phi_1_10*t41 + saltation_1_20*t38 + saltation_1_30*t39
    phi_2_01 = phi_1_01*t40 + phi_1_11*t41 + saltation_1_21*t38 + saltation_1_31*t39
    phi_2_02 = phi_1_02*t40 + phi_1_12*t41 + saltation_1_22*t38 + saltation_1_32*t39
    phi_2_03 = phi_1_03*t40 + phi_1_13*t41 + saltation_1_23*t38 + saltation_1_33*t39
    phi_2_10 = phi_1_00*t44 + phi_1_10*t45 + saltation_1_20*t42 + saltation_1_30*t43
    phi_2_11 = phi_1_01*t44 + phi_1_11*t45 + saltation_1_21*t42 + saltation_1_31*t43
    phi_2_12 = phi_1_02*t44 + phi_1_12*t45 + saltation_1_22*t42 + saltation_1_32*t43
    phi_2_13 = phi_1_03*t44 + phi_1_13*t45 + saltation_1_23*t42 + saltation_1_33*t43
    phi_2_20 = phi_1_00*t48 + phi_1_10*t49 + saltation_1_20*t40 + saltation_1_30*t41
    phi_2_21 = phi_1_01*t48 + phi_1_11*t49 + saltation_1_21*t40 + saltation_1_31*t41
    phi_2_22 = phi_1_02*t48 + phi_1_12*t49 + saltation_1_22*t40 + saltation_1_32*t41
    phi_2_23 = phi_1_03*t48 + phi_1_13*t49 + saltation_1_23*t40 + saltation_1_33*t41
    t62 = omega4*p6*sin_omega4_tau1 - p6*t46
    t63 = -p4*t47 - t36*t46
    phi_2_30 = phi_1_00*t62 + phi_1_10*t63 + saltation_1_20*t44 + saltation_1_30*t45
    phi_2_31 = phi_1_01*t62 + phi_1_11*t63 + saltation_1_21*t44 + saltation_1_31*t45
    phi_2_32 = phi_1_02*t62 + phi_1_12*t63 + saltation_1_22*t44 + saltation_1_32*t45
    phi_2_33 = phi_1_03*t62 + phi_1_13*t63 + saltation_1_23*t44 + saltation_1_33*t45
    # saltation of phase 2
    t64 = 1/v1_2
    t65 = t64*(-before_v1_2 + behind_v1_2)
    saltation_2_20 = phi_2_00*t65 + phi_2_20
    saltation_2_21 = phi_2_01*t65 + phi_2_21
    saltation_2_22 = phi_2_02*t65 + phi_2_22
    saltation_2_23 = phi_2_03*t65 + phi_2_23
    t66 = t64*(-before_v2_2 + behind_v2_2)
    saltation_2_30 = phi_2_00*t66 + phi_2_30
    saltation_2_31 = phi_2_01*t66 + phi_2_31
    saltation_2_32 = phi_2_02*t66 + phi_2_32
    saltation_2_33 = phi_2_03*t66 + phi_2_33
    return [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [phi_2_10, phi_2_11, phi_2_12, phi_2_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]


def one_contact_trace(parameters, spectrum, unknowns, lib):
    """Trace of the Poincare map's Jacobian.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives trace.
    Operations: 320. Intermediate terms: 113.
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
    t2 = k1*k3
    t3 = k2*k3 + t2
    t4 = 1/(k1*k2 + t3)
    t5 = t3*t4
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = p1 - 1
    t10 = 1/omega1
    t11 = sin_omega1_tau*t10
    t13 = sin_omega2_tau/omega2
    t14 = p1*t11 - t13*t9
    t15 = p2*sin_omega1_tau*t10 - p2*t13
    t16 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t17 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*u + t15*w + t16*y + t17 + t5
    t18 = p3*t5
    t20 = p1*t7
    t21 = p3*sin_omega1_tau*t10 - p3*t13
    t22 = p1*t13 - t11*t9
    t23 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t24 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(-t18 + t7*t9) + cos_omega2_tau*(t18 - t20) + t21*u + t22*w + t23*y + t24 + t7
    t25 = omega1*sin_omega1_tau
    t26 = omega2*p2*sin_omega2_tau - p2*t25
    t27 = omega2*sin_omega2_tau
    v1_1 = -p1*t25 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t16*w + t17*u + t26*y + t27*t9
    t28 = -p1*t27 + t25*t9
    v2_1 = -p3*t25 + p3*t27 + sin_omega1_tau*(omega1*t18 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t18 + omega2*t20) + t23*w + t24*u + t28*y
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t29 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t29)
    sin_omega3_tau1 = lib.sin(t29)
    t30 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t30)
    sin_omega4_tau1 = lib.sin(t30)
    # free for tau1, until first-reaches-stop
    t31 = 1/omega3
    t32 = sin_omega3_tau1*t31
    t33 = 1 - p4
    t34 = sin_omega4_tau1/omega4
    t35 = p4*t32 + t33*t34
    t36 = p5*sin_omega3_tau1*t31 - p5*t34
    t37 = cos_omega3_tau1*p4 + cos_omega4_tau1*t33
    t38 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t35*v1_1 + t36*v2_1 + t37*x1_1 + t38*x2_1
    t39 = p6*sin_omega3_tau1*t31 - p6*t34
    t40 = p4*t34 + t32*t33
    t41 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t42 = cos_omega3_tau1*t33 + cos_omega4_tau1*p4
    x2_2 = t39*v1_1 + t40*v2_1 + t41*x1_1 + t42*x2_1
    t43 = omega3*sin_omega3_tau1
    t44 = omega4*sin_omega4_tau1
    t45 = -p4*t43 - t33*t44
    t46 = omega4*p5*sin_omega4_tau1 - p5*t43
    v1_2 = t37*v1_1 + t38*v2_1 + t45*x1_1 + t46*x2_1
    t47 = omega4*p6*sin_omega4_tau1 - p6*t43
    t48 = -p4*t44 - t33*t43
    v2_2 = t41*v1_1 + t42*v2_1 + t47*x1_1 + t48*x2_1
    # Phi along tau
    carried_x1_1_by_y = t16
    carried_x1_1_by_u = t14
    carried_x1_1_by_w = t15
    carried_x2_1_by_y = t23
    carried_x2_1_by_u = t21
    carried_x2_1_by_w = t22
    carried_v1_1_by_y = t26
    carried_v1_1_by_u = t17
    carried_v1_1_by_w = t16
    carried_v2_1_by_y = t28
    carried_v2_1_by_u = t24
    carried_v2_1_by_w = t23
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t49 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t49
    delay_tau_by_u = carried_x1_1_by_u*t49
    delay_tau_by_w = carried_x1_1_by_w*t49
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t50 = 1/m1
    t51 = k1*t50
    t52 = k3*t50 - t50*x1_1*(k1 + k3) + t51*x2_1
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t52
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t52
    v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t52
    t53 = 1/m2
    t54 = k1*t53
    t55 = t53*(k1 + k2)
    t56 = t54*x1_1 - t55*x2_1
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t56
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t56
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t56
    # Phi along tau1
    carried_x1_2_by_y = t35*v1_1_on_boundary_by_y + t36*v2_1_on_boundary_by_y + t37*x1_1_on_boundary_by_y + t38*x2_1_on_boundary_by_y
    carried_x1_2_by_u = t35*v1_1_on_boundary_by_u + t36*v2_1_on_boundary_by_u + t37*x1_1_on_boundary_by_u + t38*x2_1_on_boundary_by_u
    carried_x1_2_by_w = t35*v1_1_on_boundary_by_w + t36*v2_1_on_boundary_by_w + t37*x1_1_on_boundary_by_w + t38*x2_1_on_boundary_by_w
    carried_x2_2_by_y = t39*v1_1_on_boundary_by_y + t40*v2_1_on_boundary_by_y + t41*x1_1_on_boundary_by_y + t42*x2_1_on_boundary_by_y
    carried_v1_2_by_u = t37*v1_1_on_boundary_by_u + t38*v2_1_on_boundary_by_u + t45*x1_1_on_boundary_by_u + t46*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t41*v1_1_on_boundary_by_w + t42*v2_1_on_boundary_by_w + t47*x1_1_on_boundary_by_w + t48*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t57 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t57
    delay_tau1_by_u = -carried_x1_2_by_u*t57
    delay_tau1_by_w = -carried_x1_2_by_w*t57
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*(k1*t50*x2_2 - t51*x1_2)
    v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*(t54*x1_2 - t55*x2_2)
    return v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y


def one_contact_trace_gradient(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Derivatives of the trace by the unknowns, then in total by the parameters.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes spectrum_derivatives (12, 5): gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1,
        gap1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2,
        omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2, p1_by_k1,
        p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2, p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1,
        p2_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2, gap2_by_k1, gap2_by_k2,
        gap2_by_k3, gap2_by_m1, gap2_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3,
        omega3_by_m1, omega3_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1,
        omega4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2, p5_by_k1, p5_by_k2,
        p5_by_k3, p5_by_m1, p5_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2.
    Takes unknowns (4): y, u, w, tau.
    Gives trace_gradient (10).
    Operations: 1643. Intermediate terms: 317.
    """
    [m1, m2, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
    [[_, _, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [_, _, _, _, _], [omega3_by_k1, omega3_by_k2, omega3_by_k3, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, p5_by_k3, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2]] = spectrum_derivatives
    [y, u, w, tau] = unknowns
    # functions of tau in contact
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t3 = omega2*tau
    cos_omega2_tau = lib.cos(t3)
    sin_omega2_tau = lib.sin(t3)
    # contact for tau, until first-leaves-stop
    t6 = k1*k3
    t7 = k2*k3 + t6
    t8 = k1*k2 + t7
    t9 = 1/t8
    t10 = t7*t9
    t11 = t6*t9
    t12 = p2*t11
    t13 = p1*t10 + t12
    t14 = p1 - 1
    t15 = t10*t14 + t12
    t16 = 1/omega1
    t17 = p1*sin_omega1_tau
    t18 = 1/omega2
    t20 = -sin_omega2_tau*t14
    t21 = t16*t17 + t18*t20
    t22 = sin_omega2_tau*t18
    t23 = p2*sin_omega1_tau*t16 - p2*t22
    t24 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t25 = cos_omega1_tau*p1 - cos_omega2_tau*t14
    x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t23*w + t24*y + t25
    t26 = p3*t10
    t28 = t11*t14 - t26
    t29 = p1*t11
    t30 = -t26 + t29
    t31 = p3*sin_omega2_tau
    t32 = p3*sin_omega1_tau*t16 - t18*t31
    t33 = p1*t22 - sin_omega1_tau*t14*t16
    t34 = -cos_omega1_tau*t14 + cos_omega2_tau*p1
    t35 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*t28 - cos_omega2_tau*t30 + t11 + t32*u + t33*w + t34*y + t35
    t36 = omega1*p1
    t37 = omega1*t12 + t10*t36
    t38 = omega2*t12 + omega2*t14*t7*t9
    t39 = omega1*sin_omega1_tau
    t40 = omega2*p2*sin_omega2_tau - p2*t39
    t41 = -omega2*t14
    v1_1 = -sin_omega1_tau*t36 + sin_omega1_tau*t37 - sin_omega2_tau*t38 - sin_omega2_tau*t41 + t24*w + t25*u + t40*y
    t42 = omega1*p3
    t43 = -t11*t14
    t44 = omega1*t43 + t10*t42
    t45 = omega2*p3
    t46 = omega2*t29 - t10*t45
    t47 = omega2*sin_omega2_tau
    t48 = -p1*t47 + t14*t39
    v2_1 = -sin_omega1_tau*t42 + sin_omega1_tau*t44 + sin_omega2_tau*t45 + sin_omega2_tau*t46 + t34*w + t35*u + t48*y
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t49 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t49)
    sin_omega3_tau1 = lib.sin(t49)
    t52 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t52)
    sin_omega4_tau1 = lib.sin(t52)
    # free for tau1, until first-reaches-stop
    t55 = 1/omega3
    t56 = sin_omega3_tau1*t55
    t57 = 1 - p4
    t58 = 1/omega4
    t59 = sin_omega4_tau1*t58
    t60 = p4*t56 + t57*t59
    t61 = p5*sin_omega3_tau1*t55 - p5*t59
    t62 = cos_omega3_tau1*p4 + cos_omega4_tau1*t57
    t63 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t60*v1_1 + t61*v2_1 + t62*x1_1 + t63*x2_1
    t64 = p6*t59
    t65 = p6*sin_omega3_tau1*t55 - t64
    t66 = p4*t59 + t56*t57
    t67 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t68 = cos_omega3_tau1*t57 + cos_omega4_tau1*p4
    x2_2 = t65*v1_1 + t66*v2_1 + t67*x1_1 + t68*x2_1
    t69 = omega3*sin_omega3_tau1
    t70 = omega4*sin_omega4_tau1
    t71 = p4*t69 + t57*t70
    t73 = p5*t69
    t74 = omega4*p5*sin_omega4_tau1 - t73
    v1_2 = t62*v1_1 + t63*v2_1 - t71*x1_1 + t74*x2_1
    t75 = p6*t69
    t76 = omega4*p6*sin_omega4_tau1 - t75
    t77 = p4*t70 + t57*t69
    v2_2 = t67*v1_1 + t68*v2_1 + t76*x1_1 - t77*x2_1
    # Phi along tau
    carried_x1_1_by_y = t24
    carried_x1_1_by_u = t21
    carried_x1_1_by_w = t23
    carried_x2_1_by_y = t34
    carried_x2_1_by_u = t32
    carried_x2_1_by_w = t33
    carried_v1_1_by_y = t40
    carried_v1_1_by_u = t25
    carried_v1_1_by_w = t24
    carried_v2_1_by_y = t48
    carried_v2_1_by_u = t35
    carried_v2_1_by_w = t34
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t79 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t79
    delay_tau_by_u = carried_x1_1_by_u*t79
    delay_tau_by_w = carried_x1_1_by_w*t79
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t80 = 1/m1
    t81 = k1 + k3
    t82 = t80*x1_1
    t83 = k1*t80*x2_1 + k3*t80 - t81*t82
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t83
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t83
    v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t83
    t84 = 1/m2
    t85 = t84*x1_1
    t86 = k1 + k2
    t87 = t84*x2_1
    t88 = k1*t85 - t86*t87
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t88
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t88
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t88
    # Phi along tau1
    carried_x1_2_by_y = t60*v1_1_on_boundary_by_y + t61*v2_1_on_boundary_by_y + t62*x1_1_on_boundary_by_y + t63*x2_1_on_boundary_by_y
    carried_x1_2_by_u = t60*v1_1_on_boundary_by_u + t61*v2_1_on_boundary_by_u + t62*x1_1_on_boundary_by_u + t63*x2_1_on_boundary_by_u
    carried_x1_2_by_w = t60*v1_1_on_boundary_by_w + t61*v2_1_on_boundary_by_w + t62*x1_1_on_boundary_by_w + t63*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t89 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t89
    delay_tau1_by_u = -carried_x1_2_by_u*t89
    delay_tau1_by_w = -carried_x1_2_by_w*t89
    # back through: derivatives of the time to the boundary after tau1
    t90 = t84*x1_2
    t91 = t84*x2_2
    slope_by_delay_tau1_by_w = k1*t90 - t86*t91
    t92 = t80*x1_2
    slope_by_delay_tau1_by_u = k1*t80*x2_2 - k1*t92
    # back through: Phi along tau1
    slope_by_carried_x1_2_by_w = -slope_by_delay_tau1_by_w*t89
    slope_by_carried_x1_2_by_u = -slope_by_delay_tau1_by_u*t89
    slope_by_carried_x1_2_by_y = -t89*v2_2
    # back through: perturbation on the boundary after tau
    slope_by_v2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t61 + t68
    slope_by_v2_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t61 + t63
    slope_by_v2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t61 + t66
    slope_by_v1_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t60 + t67
    slope_by_v1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t60 + t62
    slope_by_v1_1_on_boundary_by_y = p6*t56 + slope_by_carried_x1_2_by_y*t60 - t64
    slope_by_x2_1_on_boundary_by_w = slope_by_carried_x1_2_by_w*t63 - t77
    slope_by_x2_1_on_boundary_by_u = p5*t70 + slope_by_carried_x1_2_by_u*t63 - t73
    slope_by_x2_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t63 + t68
    slope_by_x1_1_on_boundary_by_w = p6*t70 + slope_by_carried_x1_2_by_w*t62 - t75
    slope_by_x1_1_on_boundary_by_u = slope_by_carried_x1_2_by_u*t62 - t71
    slope_by_x1_1_on_boundary_by_y = slope_by_carried_x1_2_by_y*t62 + t67
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_w = slope_by_v1_1_on_boundary_by_w*t83 + slope_by_v2_1_on_boundary_by_w*t88 + slope_by_x1_1_on_boundary_by_w*v1_1 + slope_by_x2_1_on_boundary_by_w*v2_1
    slope_by_delay_tau_by_u = slope_by_v1_1_on_boundary_by_u*t83 + slope_by_v2_1_on_boundary_by_u*t88 + slope_by_x1_1_on_boundary_by_u*v1_1 + slope_by_x2_1_on_boundary_by_u*v2_1
    slope_by_delay_tau_by_y = slope_by_v1_1_on_boundary_by_y*t83 + slope_by_v2_1_on_boundary_by_y*t88 + slope_by_x1_1_on_boundary_by_y*v1_1 + slope_by_x2_1_on_boundary_by_y*v2_1
    # back through: rate of the exit boundary after tau
    t93 = 1/rate_1**2
    slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t93 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t93 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t93
    # back through: Phi along tau
    slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t79 + slope_by_x1_1_on_boundary_by_w
    slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t79 + slope_by_x1_1_on_boundary_by_u
    slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t79 + slope_by_x1_1_on_boundary_by_y
    # back through: free for tau1, until first-reaches-stop
    t94 = 1/v1_2**2
    slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t94 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t94 + carried_x1_2_by_y*t94*v2_2
    t95 = k1*t80
    t96 = delay_tau1_by_u*t95
    slope_by_x2_2 = -delay_tau1_by_w*t84*t86 + t96
    slope_by_x1_2 = delay_tau1_by_w*k1*t84 - t96
    # back through: functions of tau1 in free
    t97 = p4*x2_1
    t98 = p5*v2_1_on_boundary_by_u
    t99 = p5*t58
    t100 = p5*x2_1
    t101 = t57*x1_1
    t102 = p5*v2_1
    t103 = p4*v2_1
    t104 = p6*v1_1
    t105 = p4*v2_1_on_boundary_by_y
    t106 = p5*x2_1_on_boundary_by_u
    t107 = p6*x1_1_on_boundary_by_w
    t108 = p4*x2_1_on_boundary_by_w
    t109 = p6*v1_1_on_boundary_by_y
    t110 = t57*x1_1_on_boundary_by_u
    slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*p6*x1_1 - omega4*t97) + omega4*t106 + omega4*t107 - omega4*t108 - omega4*t110 + slope_by_carried_x1_2_by_u*(t57*t58*v1_1_on_boundary_by_u - t58*t98) + slope_by_carried_x1_2_by_w*(t57*t58*v1_1_on_boundary_by_w - t99*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t57*t58*v1_1_on_boundary_by_y - t99*v2_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t100 - omega4*t101) + slope_by_x1_2*(-t102*t58 + t57*t58*v1_1) + slope_by_x2_2*(t103*t58 - t104*t58) + t105*t58 - t109*t58
    t111 = p5*x2_1_on_boundary_by_w
    t112 = p5*x2_1_on_boundary_by_y
    t113 = p6*x1_1
    t114 = t57*v1_1_on_boundary_by_u
    t115 = p6*v1_1_on_boundary_by_w
    t116 = p6*x1_1_on_boundary_by_y
    slope_by_cos_omega4_tau1 = delay_tau1_by_y*(t103 - t104) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(-t106 + t57*x1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t111 + t57*x1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t112 + t57*x1_1_on_boundary_by_y) + slope_by_v1_2*(-t102 + t57*v1_1) + slope_by_x1_2*(-t100 + t57*x1_1) + slope_by_x2_2*(-t113 + t97) + t114 - t115 - t116 - t98
    t117 = t57*x2_1
    t118 = p4*v1_1_on_boundary_by_u
    t119 = p4*t55
    t120 = p5*t55
    t121 = p4*x1_1
    t122 = p4*v1_1
    t123 = t57*v2_1
    t124 = t57*v2_1_on_boundary_by_y
    t125 = p4*x1_1_on_boundary_by_u
    t126 = t57*x2_1_on_boundary_by_w
    slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t113 - omega3*t117) - omega3*t106 - omega3*t107 - omega3*t125 - omega3*t126 + slope_by_carried_x1_2_by_u*(t118*t55 + t55*t98) + slope_by_carried_x1_2_by_w*(t119*v1_1_on_boundary_by_w + t120*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t119*v1_1_on_boundary_by_y + t120*v2_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t100 - omega3*t121) + slope_by_x1_2*(t102*t55 + t122*t55) + slope_by_x2_2*(t104*t55 + t123*t55) + t109*t55 + t124*t55
    slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t104 + t123) + slope_by_carried_x1_2_by_u*(t106 + t125) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t111) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t112) + slope_by_v1_2*(t102 + t122) + slope_by_x1_2*(t100 + t121) + slope_by_x2_2*(t113 + t117) + t115 + t116 + t118 + t57*v2_1_on_boundary_by_w + t57*x2_1_on_boundary_by_y + t98
    # back through: tau1 completes the period
    t127 = sin_omega3_tau1*slope_by_cos_omega3_tau1
    t128 = sin_omega4_tau1*slope_by_cos_omega4_tau1
    slope_by_tau1 = cos_omega3_tau1*omega3*slope_by_sin_omega3_tau1 + cos_omega4_tau1*omega4*slope_by_sin_omega4_tau1 - omega3*t127 - omega4*t128
    # back through: contact for tau, until first-leaves-stop
    slope_by_v2_1 = delay_tau1_by_y*t68 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t63 + slope_by_x1_2*t61 + slope_by_x2_2*t66
    slope_by_v1_1 = delay_tau1_by_y*t67 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t62 + slope_by_x1_2*t60 + slope_by_x2_2*t65
    t129 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u
    t130 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w
    t131 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y
    t132 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u
    t133 = t84*t86
    t134 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w
    t135 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y
    slope_by_x2_1 = -delay_tau1_by_y*t77 + slope_by_v1_2*t74 + slope_by_x1_2*t63 + slope_by_x2_2*t68 + t129*t95 + t130*t95 + t131*t95 - t132*t133 - t133*t134 - t133*t135
    t136 = k1*t84
    t137 = t80*t81
    slope_by_x1_1 = delay_tau1_by_y*t76 - slope_by_v1_2*t71 + slope_by_x1_2*t62 + slope_by_x2_2*t67 - t129*t137 - t130*t137 - t131*t137 + t132*t136 + t134*t136 + t135*t136
    # back through: functions of tau in contact
    t138 = p1*y
    t139 = p2*w
    t140 = p1*w
    t141 = p3*u
    t142 = p1*slope_by_x2_1_on_boundary_by_w
    t143 = p2*slope_by_v1_1_on_boundary_by_y
    t144 = p1*slope_by_v2_1_on_boundary_by_y
    t145 = p2*slope_by_carried_x1_1_by_w
    t146 = p3*slope_by_x2_1_on_boundary_by_u
    slope_by_sin_omega2_tau = omega2*t143 - omega2*t144 - slope_by_carried_x1_1_by_u*t14*t18 + slope_by_v1_1*(omega2*p2*y - t38 - t41) + slope_by_v2_1*(-omega2*t138 + t45 + t46) + slope_by_x1_1*(-t139*t18 - t14*t18*u) + slope_by_x2_1*(t140*t18 - t141*t18) + t142*t18 - t145*t18 - t146*t18
    t147 = p2*y
    t148 = -p1 - t147
    t149 = p2*slope_by_carried_x1_1_by_y
    t150 = p2*slope_by_v1_1_on_boundary_by_w
    t151 = p3*slope_by_v2_1_on_boundary_by_u
    slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t139 - t14*u) - slope_by_v1_1_on_boundary_by_u*t14 + slope_by_v2_1*(t140 - t141) + slope_by_x1_1*(t148 + t15 + 1) + slope_by_x2_1*(p1*y - p3 - t30) - t149 - t150 - t151
    t152 = -t14*y
    t153 = p1*u
    t154 = -t14*w
    t155 = -slope_by_x2_1_on_boundary_by_w*t14
    t156 = -slope_by_v2_1_on_boundary_by_y*t14
    slope_by_sin_omega1_tau = -omega1*t143 - omega1*t156 + p1*slope_by_carried_x1_1_by_u*t16 + slope_by_v1_1*(-omega1*t147 - t36 + t37) + slope_by_v2_1*(-omega1*t152 - t42 + t44) + slope_by_x1_1*(t139*t16 + t153*t16) + slope_by_x2_1*(t141*t16 + t154*t16) + t145*t16 + t146*t16 + t155*t16
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t139 + t153) + slope_by_v2_1*(t141 + t154) - slope_by_v2_1_on_boundary_by_w*t14 + slope_by_x1_1*(-t13 - t148) + slope_by_x2_1*(p3 + t152 + t28) - slope_by_x2_1_on_boundary_by_y*t14 + t149 + t150 + t151
    # outputs
    t157 = sin_omega1_tau*slope_by_cos_omega1_tau
    t158 = sin_omega2_tau*slope_by_cos_omega2_tau
    t159 = 1/m1**2
    t160 = k1*t159
    t161 = p3*sin_omega1_tau
    t162 = 1/omega1**2
    t163 = sin_omega1_tau*t162
    t164 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t143 - sin_omega1_tau*t156 - slope_by_carried_x1_1_by_u*t162*t17 + slope_by_v1_1*(sin_omega1_tau*t13 - sin_omega1_tau*t147 - t17) + slope_by_v2_1*(-sin_omega1_tau*t152 + sin_omega1_tau*(t26 + t43) - t161) + slope_by_x1_1*(-t139*t163 - t153*t163) + slope_by_x2_1*(-t141*t163 - t154*t163) - slope_by_x2_1_on_boundary_by_u*t161*t162 - t145*t163 - t155*t163 - t157*tau
    t165 = 1/omega2**2
    t166 = sin_omega2_tau*t165
    t167 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t143 - sin_omega2_tau*t144 - slope_by_carried_x1_1_by_u*t165*t20 + slope_by_v1_1*(sin_omega2_tau*t147 + sin_omega2_tau*(-t12 - t14*t7*t9) - t20) + slope_by_v2_1*(-sin_omega2_tau*t138 + sin_omega2_tau*t30 + t31) + slope_by_x1_1*(t139*t166 + t14*t166*u) + slope_by_x2_1*(p3*sin_omega2_tau*t165*u - t140*t166) + slope_by_x2_1_on_boundary_by_u*t165*t31 - t142*t166 + t145*t166 - t158*tau
    t168 = sin_omega3_tau1/omega3**2
    t169 = p4*t168
    t170 = p5*t168
    t171 = cos_omega3_tau1*slope_by_sin_omega3_tau1*tau1 + delay_tau1_by_y*(-sin_omega3_tau1*t113 - sin_omega3_tau1*t117) - sin_omega3_tau1*t106 - sin_omega3_tau1*t107 - sin_omega3_tau1*t125 - sin_omega3_tau1*t126 + slope_by_carried_x1_2_by_u*(-t118*t168 - t168*t98) + slope_by_carried_x1_2_by_w*(-t169*v1_1_on_boundary_by_w - t170*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t169*v1_1_on_boundary_by_y - t170*v2_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t100 - sin_omega3_tau1*t121) + slope_by_x1_2*(-t102*t168 - t122*t168) + slope_by_x2_2*(-t104*t168 - t123*t168) - t109*t168 - t124*t168 - t127*tau1
    t172 = 1/omega4**2
    t173 = sin_omega4_tau1*t172
    t174 = p5*t173
    t175 = t173*t57
    t176 = cos_omega4_tau1*slope_by_sin_omega4_tau1*tau1 + delay_tau1_by_y*(p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t97) + sin_omega4_tau1*t106 + sin_omega4_tau1*t107 - sin_omega4_tau1*t108 - sin_omega4_tau1*t110 + slope_by_carried_x1_2_by_u*(-t114*t173 + t173*t98) + slope_by_carried_x1_2_by_w*(t174*v2_1_on_boundary_by_w - t175*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t174*v2_1_on_boundary_by_y - t175*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t100 - sin_omega4_tau1*t101) + slope_by_x1_2*(t102*t173 - t173*t57*v1_1) + slope_by_x2_2*(p6*sin_omega4_tau1*t172*v1_1 - t103*t173) - t105*t173 + t109*t173 - t128*tau1
    t177 = -sin_omega1_tau*t16 + t22
    t179 = cos_omega1_tau - cos_omega2_tau
    t180 = t10*t39 - t10*t47 + t179*u - t39 + t47
    t182 = t39 - t47
    t183 = t11*t47
    t184 = t11*t39
    t185 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t177*u + t179
    t186 = cos_omega1_tau*t11
    t187 = cos_omega2_tau*t11
    t188 = -slope_by_carried_x1_1_by_u*t177 + slope_by_v1_1*t180 + slope_by_v1_1_on_boundary_by_u*t179 + slope_by_v2_1*(-t179*w + t182*y + t183 - t184) - slope_by_v2_1_on_boundary_by_w*t179 + slope_by_v2_1_on_boundary_by_y*t182 + slope_by_x1_1*t185 + slope_by_x2_1*(t177*w - t179*y + t186 - t187) + slope_by_x2_1_on_boundary_by_w*t177 - slope_by_x2_1_on_boundary_by_y*t179
    t190 = -slope_by_carried_x1_1_by_w*t177 + slope_by_carried_x1_1_by_y*t179 + slope_by_v1_1*(t179*w - t182*y - t183 + t184) + slope_by_v1_1_on_boundary_by_w*t179 - slope_by_v1_1_on_boundary_by_y*t182 + slope_by_x1_1*(-t177*w + t179*y - t186 + t187)
    t191 = slope_by_v2_1*t180 + slope_by_v2_1_on_boundary_by_u*t179 + slope_by_x2_1*t185 - slope_by_x2_1_on_boundary_by_u*t177
    t192 = cos_omega3_tau1 - cos_omega4_tau1
    t194 = t69 - t70
    t195 = -sin_omega3_tau1*t55 + t59
    t197 = t192*x1_1_on_boundary_by_y - t195*v1_1_on_boundary_by_y
    t199 = t192*v1_1 - t194*x1_1
    t200 = t192*x1_1 - t195*v1_1
    t201 = delay_tau1_by_y*(-t192*v2_1 + t194*x2_1) + slope_by_carried_x1_2_by_u*(t192*x1_1_on_boundary_by_u - t195*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x1_1_on_boundary_by_w - t195*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t197 + slope_by_v1_2*t199 + slope_by_x1_2*t200 + slope_by_x2_2*(-t192*x2_1 + t195*v2_1) + t192*v1_1_on_boundary_by_u - t192*v2_1_on_boundary_by_w - t192*x2_1_on_boundary_by_y - t194*x1_1_on_boundary_by_u + t194*x2_1_on_boundary_by_w + t195*v2_1_on_boundary_by_y
    t202 = slope_by_carried_x1_2_by_u*(t192*x2_1_on_boundary_by_u - t195*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t192*x2_1_on_boundary_by_w - t195*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t192*x2_1_on_boundary_by_y - t195*v2_1_on_boundary_by_y) + slope_by_v1_2*(t192*v2_1 - t194*x2_1) + slope_by_x1_2*(t192*x2_1 - t195*v2_1) + t192*v2_1_on_boundary_by_u - t194*x2_1_on_boundary_by_u
    t203 = delay_tau1_by_y*t199 + slope_by_x2_2*t200 + t192*v1_1_on_boundary_by_w - t194*x1_1_on_boundary_by_w + t197
    t204 = -k3*t159 + t159*t81*x1_1 - t160*x2_1
    t205 = 1/m2**2
    t206 = k1*t205
    t207 = t205*t86*x2_1 - t206*x1_1
    t208 = k3*t9
    t209 = t208*t36
    t210 = p2*t208
    t211 = -k2 - k3
    t212 = 1/t8**2
    t213 = t212*t7
    t214 = t211*t213
    t215 = t212*t6
    t216 = t211*t215
    t217 = p2*t216
    t218 = t208*t42
    t219 = -omega1*t14
    t220 = p1*t208
    t221 = t208*t45
    t222 = p1*t216
    t223 = t210 + t217
    t224 = t14*t208
    t225 = p3*t208
    t226 = -p3*t214 - t225
    t227 = t80*x2_1 - t82
    t228 = t85 - t87
    t230 = -t213*t81
    t231 = -t215*t81
    t232 = p2*t231
    t233 = p3*t230 + t225
    t234 = t86*t9
    t235 = k1*t9
    t236 = p2*t235
    t238 = -t213*t86
    t239 = -t215*t86
    t240 = p2*t239
    t241 = p1*t235
    t242 = p1*t239
    t243 = t236 + t240
    t244 = -p3*t234 - p3*t238
    t245 = t80 - t82
    return [slope_by_v1_1*t40 + slope_by_v2_1*t48 + slope_by_x1_1*t24 + slope_by_x2_1*t34, slope_by_v1_1*t25 + slope_by_v2_1*t35 + slope_by_x1_1*t21 + slope_by_x2_1*t32, slope_by_v1_1*t24 + slope_by_v2_1*t34 + slope_by_x1_1*t23 + slope_by_x2_1*t33, cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t157 - omega2*t158 - slope_by_tau1, delay_tau1_by_u*(t160*x1_2 - t160*x2_2) + omega1_by_m1*t164 + omega2_by_m1*t167 + omega3_by_m1*t171 + omega4_by_m1*t176 + p1_by_m1*t188 + p2_by_m1*t190 + p3_by_m1*t191 + p4_by_m1*t201 + p5_by_m1*t202 + p6_by_m1*t203 + t129*t204 + t130*t204 + t131*t204, delay_tau1_by_w*(t205*t86*x2_2 - t206*x1_2) + omega1_by_m2*t164 + omega2_by_m2*t167 + omega3_by_m2*t171 + omega4_by_m2*t176 + p1_by_m2*t188 + p2_by_m2*t190 + p3_by_m2*t191 + p4_by_m2*t201 + p5_by_m2*t202 + p6_by_m2*t203 + t132*t207 + t134*t207 + t135*t207, delay_tau1_by_u*(t80*x2_2 - t92) + delay_tau1_by_w*(t90 - t91) + omega1_by_k1*t164 + omega2_by_k1*t167 + omega3_by_k1*t171 + omega4_by_k1*t176 + p1_by_k1*t188 + p2_by_k1*t190 + p3_by_k1*t191 + p4_by_k1*t201 + p5_by_k1*t202 + p6_by_k1*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t210 + omega1*t217 + t209 + t214*t36) + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t211*t212*t7 - omega2*t210 - omega2*t217)) + slope_by_v2_1*(sin_omega1_tau*(t208*t219 + t214*t42 + t216*t219 + t218) + sin_omega2_tau*(omega2*t220 + omega2*t222 - t214*t45 - t221)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t214 - t220 - t223) + cos_omega2_tau*(t14*t214 + t223 + t224) + t208 + t214) + slope_by_x2_1*(cos_omega1_tau*(t14*t216 + t224 + t226) + cos_omega2_tau*(-t220 - t222 - t226) + t208 + t216) + t129*t227 + t130*t227 + t131*t227 + t132*t228 + t134*t228 + t135*t228, -delay_tau1_by_w*t91 + omega1_by_k2*t164 + omega2_by_k2*t167 + omega3_by_k2*t171 + omega4_by_k2*t176 + p1_by_k2*t188 + p2_by_k2*t190 + p3_by_k2*t191 + p4_by_k2*t201 + p5_by_k2*t202 + p6_by_k2*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t232 + t209 + t230*t36) + sin_omega2_tau*(-omega2*t232 + t208*t41 + t230*t41)) + slope_by_v2_1*(sin_omega1_tau*(t218 + t219*t231 + t230*t42) + sin_omega2_tau*(-k1*k3*omega2*p1*t212*t81 - t221 - t230*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t230 - t220 - t232) + cos_omega2_tau*(t14*t230 + t224 + t232) + t208 + t230) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t14*t212*t81 - t233) + cos_omega2_tau*(-p1*t231 + t233) + t231) - t132*t87 - t134*t87 - t135*t87, omega1_by_k3*t164 + omega2_by_k3*t167 + omega3_by_k3*t171 + omega4_by_k3*t176 + p1_by_k3*t188 + p2_by_k3*t190 + p3_by_k3*t191 + p4_by_k3*t201 + p5_by_k3*t202 + p6_by_k3*t203 + slope_by_v1_1*(sin_omega1_tau*(omega1*t236 + omega1*t240 + t234*t36 + t238*t36) + sin_omega2_tau*(omega2*t14*t212*t7*t86 - omega2*t14*t86*t9 - omega2*t236 - omega2*t240)) + slope_by_v2_1*(sin_omega1_tau*(t219*t235 + t219*t239 + t234*t42 + t238*t42) + sin_omega2_tau*(omega2*t241 + omega2*t242 - t234*t45 - t238*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t234 - p1*t238 - t243) + cos_omega2_tau*(t14*t234 + t14*t238 + t243) + t234 + t238) + slope_by_x2_1*(cos_omega1_tau*(t14*t235 + t14*t239 + t244) + cos_omega2_tau*(-t241 - t242 - t244) + t235 + t239) + t129*t245 + t130*t245 + t131*t245, slope_by_tau1]


def one_contact_states(parameters, spectrum, unknowns, lib):
    """State at the start and behind each transition, row by row.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives states (3, 4).
    Operations: 211. Intermediate terms: 50.
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
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = p1 - 1
    t10 = 1/omega1
    t11 = sin_omega1_tau*t10
    t13 = sin_omega2_tau/omega2
    t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t15 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    x1_1 = cos_omega1_tau*(-t6 - t8) + cos_omega2_tau*(t5*t9 + t8) + t14*y + t15 + t5 + u*(p1*t11 - t13*t9) + w*(p2*sin_omega1_tau*t10 - p2*t13)
    t16 = p3*t5
    t18 = p1*t7
    t19 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t20 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(-t16 + t7*t9) + cos_omega2_tau*(t16 - t18) + t19*y + t20 + t7 + u*(p3*sin_omega1_tau*t10 - p3*t13) + w*(p1*t13 - t11*t9)
    t21 = omega1*sin_omega1_tau
    t22 = omega2*sin_omega2_tau
    v1_1 = -p1*t21 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t3*t4*t9 - omega2*t8) + t14*w + t15*u + t22*t9 + y*(omega2*p2*sin_omega2_tau - p2*t21)
    v2_1 = -p3*t21 + p3*t22 + sin_omega1_tau*(omega1*t16 - omega1*t7*t9) + sin_omega2_tau*(-omega2*t16 + omega2*t18) + t19*w + t20*u + y*(-p1*t22 + t21*t9)
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t23 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t23)
    sin_omega3_tau1 = lib.sin(t23)
    t24 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t24)
    sin_omega4_tau1 = lib.sin(t24)
    # free for tau1, until first-reaches-stop
    t25 = 1/omega3
    t26 = sin_omega3_tau1*t25
    t27 = 1 - p4
    t28 = sin_omega4_tau1/omega4
    t29 = cos_omega3_tau1*p4 + cos_omega4_tau1*t27
    t30 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t29*x1_1 + t30*x2_1 + v1_1*(p4*t26 + t27*t28) + v2_1*(p5*sin_omega3_tau1*t25 - p5*t28)
    t31 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t32 = cos_omega3_tau1*t27 + cos_omega4_tau1*p4
    x2_2 = t31*x1_1 + t32*x2_1 + v1_1*(p6*sin_omega3_tau1*t25 - p6*t28) + v2_1*(p4*t28 + t26*t27)
    t33 = omega3*sin_omega3_tau1
    t34 = omega4*sin_omega4_tau1
    v1_2 = t29*v1_1 + t30*v2_1 + x1_1*(-p4*t33 - t27*t34) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t33)
    v2_2 = t31*v1_1 + t32*v2_1 + x1_1*(omega4*p6*sin_omega4_tau1 - p6*t33) + x2_1*(-p4*t34 - t27*t33)
    return [[1, y, u, w], [x1_1, x2_1, v1_1, v2_1], [x1_2, x2_2, v1_2, v2_2]]


def one_contact_boundary_functions(parameters, spectrum, unknowns, lib):
    """Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Gives coefficients (12).
    Gives frequencies (4).
    Operations: 164. Intermediate terms: 39.
    """
    [_, _, k1, k2, k3, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, _] = spectrum
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
    t6 = p1*t5
    t7 = t2*t4
    t8 = p2*t7
    t9 = t6 + t8
    t10 = p1 - 1
    t11 = t10*t5 + t8
    t12 = 1/omega1
    t13 = sin_omega1_tau*t12
    t15 = 1/omega2
    t16 = sin_omega2_tau*t15
    t17 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t18 = cos_omega1_tau*p1 - cos_omega2_tau*t10
    x1_1 = -cos_omega1_tau*t9 + cos_omega2_tau*t11 + t17*y + t18 + t5 + u*(p1*t13 - t10*t16) + w*(p2*sin_omega1_tau*t12 - p2*t16)
    t19 = p3*t5
    t21 = p1*t7
    t22 = -cos_omega1_tau*t10 + cos_omega2_tau*p1
    t23 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*(t10*t7 - t19) + cos_omega2_tau*(t19 - t21) + t22*y + t23 + t7 + u*(p3*sin_omega1_tau*t12 - p3*t16) + w*(p1*t16 - t10*t13)
    t24 = omega1*sin_omega1_tau
    t25 = omega2*sin_omega2_tau
    v1_1 = -p1*t24 + sin_omega1_tau*(omega1*t6 + omega1*t8) + sin_omega2_tau*(-omega2*t10*t3*t4 - omega2*t8) + t10*t25 + t17*w + t18*u + y*(omega2*p2*sin_omega2_tau - p2*t24)
    v2_1 = -p3*t24 + p3*t25 + sin_omega1_tau*(-omega1*t10*t7 + omega1*t19) + sin_omega2_tau*(-omega2*t19 + omega2*t21) + t22*w + t23*u + y*(-p1*t25 + t10*t24)
    # outputs
    t26 = -p1 - p2*y
    t27 = p2*w
    t28 = p5*x2_1
    t29 = 1 - p4
    t30 = 1/omega3
    t31 = p5*v2_1
    t32 = 1/omega4
    return (
        [1 - t5, 0, t26 + t9, -t11 - t26 - 1, -p1*t12*u - t12*t27, t10*t15*u + t15*t27, -1, 0, p4*x1_1 + t28, -t28 + t29*x1_1, p4*t30*v1_1 + t30*t31, t29*t32*v1_1 - t31*t32],
        [omega1, omega2, omega3, omega4],
    )


def one_contact_flow_contact(parameters, spectrum, time, state, lib):
    """State after a time in contact.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 133. Intermediate terms: 25.
    """
    [_, _, k1, k2, k3, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _, _, _, _, _, _] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = omega1*t
    t1 = lib.sin(t0)
    t2 = 1/omega1
    t3 = t1*t2
    t4 = p1 - 1
    t6 = omega2*t
    t7 = lib.sin(t6)
    t8 = t7/omega2
    t9 = lib.cos(t0)
    t10 = lib.cos(t6)
    t11 = p1*t9 - t10*t4
    t12 = -p2*t10 + p2*t9
    t13 = k1*k3
    t14 = k2*k3 + t13
    t15 = 1/(k1*k2 + t14)
    t16 = t14*t15
    t17 = t13*t15
    t18 = p2*t17
    t19 = p1*t16
    t20 = -p3*t10 + p3*t9
    t21 = p1*t10 - t4*t9
    t22 = p3*t16
    t24 = p1*t17
    t25 = omega1*t1
    t26 = omega2*t7
    return [t10*(t16*t4 + t18) + t11*x1 + t12*x2 + t16 + t9*(-t18 - t19) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(t22 - t24) + t17 + t20*x1 + t21*x2 + t9*(t17*t4 - t22) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t18 + omega1*t19) + t11*v1 + t12*v2 + t7*(-omega2*t14*t15*t4 - omega2*t18) + x1*(-p1*t25 + t26*t4) + x2*(omega2*p2*t7 - p2*t25), t1*(-omega1*t17*t4 + omega1*t22) + t20*v1 + t21*v2 + t7*(-omega2*t22 + omega2*t24) + x1*(omega2*p3*t7 - p3*t25) + x2*(-p1*t26 + t25*t4)]


def one_contact_flow_free(parameters, spectrum, time, state, lib):
    """State after a time in free.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, _, _, _, _, _, _, omega3, omega4, p4, p5, p6] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = 1/omega3
    t1 = omega3*t
    t2 = lib.sin(t1)
    t3 = t0*t2
    t4 = 1 - p4
    t5 = omega4*t
    t6 = lib.sin(t5)
    t7 = t6/omega4
    t8 = lib.cos(t1)
    t9 = lib.cos(t5)
    t10 = p4*t8 + t4*t9
    t11 = p5*t8 - p5*t9
    t12 = p6*t8 - p6*t9
    t13 = p4*t9 + t4*t8
    t14 = omega3*t2
    t15 = omega4*t6
    return [t10*x1 + t11*x2 + v1*(p4*t3 + t4*t7) + v2*(p5*t0*t2 - p5*t7), t12*x1 + t13*x2 + v1*(p6*t0*t2 - p6*t7) + v2*(p4*t7 + t3*t4), t10*v1 + t11*v2 + x1*(-p4*t14 - t15*t4) + x2*(omega4*p5*t6 - p5*t14), t12*v1 + t13*v2 + x1*(omega4*p6*t6 - p6*t14) + x2*(-p4*t15 - t14*t4)]


def one_contact_reduced(parameters, spectrum, reduced, lib):
    """Reduced equations and their derivatives by the reduced unknowns.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes reduced (1): tau.
    Gives residual (1).
    Gives jacobian (1, 1).
    Operations: 378. Intermediate terms: 122.
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
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # tau1 completes the period
    tau1 = T - tau
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in free
    t6 = half_tau1*omega3
    cos_omega3_half_tau1 = lib.cos(t6)
    sin_omega3_half_tau1 = lib.sin(t6)
    t9 = half_tau1*omega4
    cos_omega4_half_tau1 = lib.cos(t9)
    sin_omega4_half_tau1 = lib.sin(t9)
    # coefficients of the linear equations
    t12 = k1*k2
    t13 = k1*k3
    t14 = k2*k3
    t15 = 1/(t12 + t13 + t14)
    t16 = p2*t13
    t17 = p2*t12 + p2*t14 + t16
    t18 = t15*t17
    t19 = omega1*sin_omega1_half_tau
    coefficient11 = omega2*sin_omega2_half_tau*t15*t17 - t18*t19
    t20 = 1 - p1
    coefficient12 = cos_omega1_half_tau*p1 + cos_omega2_half_tau*t20
    coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2
    t22 = p1*t12
    t23 = p1*t13
    t24 = p1*t14 + t22 + t23
    t25 = -t12 - t13 - t14 + t24
    t26 = t15*t19
    t27 = omega2*sin_omega2_half_tau*t15
    coefficient21 = -t24*t27 + t25*t26
    coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3
    coefficient23 = cos_omega1_half_tau*t20 + cos_omega2_half_tau*p1
    t28 = omega3*sin_omega3_half_tau1
    coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t28
    t29 = p4 - 1
    coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t29
    coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5
    # right-hand sides of the linear equations
    t30 = -t16 + t22
    t31 = k1*k2*p1 - t12 - t16
    right1 = t26*t30 - t27*t31
    t32 = p3*t12 + t23
    t33 = t13 - t32
    right2 = -omega2*sin_omega2_half_tau*t15*t32 - t26*t33
    t35 = omega4*sin_omega4_half_tau1
    right3 = p4*t28 - t29*t35
    # determinant of the linear equations
    t36 = coefficient22*coefficient33
    t37 = coefficient21*coefficient32
    t38 = coefficient23*coefficient32
    t39 = coefficient21*coefficient33
    t40 = coefficient22*coefficient31
    determinant = coefficient11*t36 - coefficient11*t38 + coefficient12*coefficient23*coefficient31 - coefficient12*t39 + coefficient13*t37 - coefficient13*t40
    # numerators of Cramer's rule
    t41 = coefficient12*coefficient23
    t42 = coefficient12*coefficient33
    t43 = coefficient13*coefficient22
    numerator1 = coefficient13*coefficient32*right2 + right1*t36 - right1*t38 - right2*t42 + right3*t41 - right3*t43
    t44 = coefficient11*coefficient23
    t45 = coefficient13*coefficient31
    numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t39 - right2*t45 - right3*t44
    t46 = coefficient11*coefficient22
    t47 = coefficient11*coefficient32
    t48 = coefficient12*coefficient21
    numerator3 = coefficient12*coefficient31*right2 + right1*t37 - right1*t40 - right2*t47 + right3*t46 - right3*t48
    # d/dtau of: functions of half_tau in contact
    t49 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t49
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t49
    t50 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t50
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t50
    # d/dtau of: functions of half_tau1 in free
    t51 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t51
    sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t51
    t52 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t52
    sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t52
    # d/dtau of: coefficients of the linear equations
    t53 = omega1*sin_omega1_half_tau_by_tau
    coefficient11_by_tau = omega2*sin_omega2_half_tau_by_tau*t15*t17 - t18*t53
    coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 + cos_omega2_half_tau_by_tau*t20
    coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2
    t54 = t15*t53
    t55 = omega2*sin_omega2_half_tau_by_tau*t15
    coefficient21_by_tau = -t24*t55 + t25*t54
    coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3
    coefficient23_by_tau = cos_omega1_half_tau_by_tau*t20 + cos_omega2_half_tau_by_tau*p1
    t56 = omega3*sin_omega3_half_tau1_by_tau
    coefficient31_by_tau = omega4*p5*sin_omega4_half_tau1_by_tau - p5*t56
    coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t29
    coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5
    # d/dtau of: right-hand sides of the linear equations
    right1_by_tau = t30*t54 - t31*t55
    right2_by_tau = -omega2*sin_omega2_half_tau_by_tau*t15*t32 - t33*t54
    right3_by_tau = -omega4*sin_omega4_half_tau1_by_tau*t29 + p4*t56
    # d/dtau of: determinant of the linear equations
    t57 = t36 - t38
    t58 = coefficient23*coefficient31 - t39
    t59 = t37 - t40
    t60 = coefficient13*coefficient32 - t42
    t61 = coefficient11*coefficient33 - t45
    t62 = coefficient12*coefficient31 - t47
    t63 = t41 - t43
    t64 = coefficient13*coefficient21 - t44
    t65 = t46 - t48
    determinant_by_tau = coefficient11_by_tau*t57 + coefficient12_by_tau*t58 + coefficient13_by_tau*t59 + coefficient21_by_tau*t60 + coefficient22_by_tau*t61 + coefficient23_by_tau*t62 + coefficient31_by_tau*t63 + coefficient32_by_tau*t64 + coefficient33_by_tau*t65
    # d/dtau of: numerators of Cramer's rule
    t66 = coefficient23*right3 - coefficient33*right2
    t67 = coefficient22*right3 - coefficient32*right2
    t68 = coefficient13*right3 - coefficient33*right1
    t69 = coefficient12*right3 - coefficient32*right1
    t70 = coefficient13*right2 - coefficient23*right1
    t71 = coefficient12*right2 - coefficient22*right1
    numerator1_by_tau = coefficient12_by_tau*t66 - coefficient13_by_tau*t67 - coefficient22_by_tau*t68 + coefficient23_by_tau*t69 + coefficient32_by_tau*t70 - coefficient33_by_tau*t71 + right1_by_tau*t57 + right2_by_tau*t60 + right3_by_tau*t63
    t72 = coefficient21*right3 - coefficient31*right2
    t73 = coefficient11*right3 - coefficient31*right1
    t74 = coefficient11*right2 - coefficient21*right1
    numerator2_by_tau = -coefficient11_by_tau*t66 + coefficient13_by_tau*t72 + coefficient21_by_tau*t68 - coefficient23_by_tau*t73 - coefficient31_by_tau*t70 + coefficient33_by_tau*t74 + right1_by_tau*t58 + right2_by_tau*t61 + right3_by_tau*t64
    numerator3_by_tau = coefficient11_by_tau*t67 - coefficient12_by_tau*t72 - coefficient21_by_tau*t69 + coefficient22_by_tau*t73 + coefficient31_by_tau*t71 - coefficient32_by_tau*t74 + right1_by_tau*t59 + right2_by_tau*t62 + right3_by_tau*t65
    # outputs
    t75 = omega4*p6*sin_omega4_half_tau1 - p6*t28
    t76 = -p4*t35 + t28*t29
    t77 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6
    t78 = cos_omega3_half_tau1*t29 - cos_omega4_half_tau1*p4
    t79 = numerator2*p6
    t80 = determinant*p6
    return (
        [determinant*t75 + numerator1*t76 + numerator2*t77 + numerator3*t78],
        [[cos_omega3_half_tau1_by_tau*(numerator3*t29 - t79) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t79) + determinant_by_tau*t75 + numerator1_by_tau*t76 + numerator2_by_tau*t77 + numerator3_by_tau*t78 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t29 - omega3*t80) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t80)]],
    )


def one_contact_expand(parameters, spectrum, reduced, lib):
    """All unknowns from the reduced ones, and how singular the linear equations for them are: 0 if they are.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes reduced (1): tau.
    Gives unknowns (4).
    Gives determinants (1).
    Operations: 220. Intermediate terms: 71.
    """
    [_, _, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, _] = spectrum
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
    t4 = k1*k2
    t5 = k1*k3
    t6 = k2*k3
    t7 = 1/(t4 + t5 + t6)
    t8 = p2*t5
    t9 = p2*t4 + p2*t6 + t8
    t10 = omega1*sin_omega1_half_tau
    coefficient11 = omega2*sin_omega2_half_tau*t7*t9 - t10*t7*t9
    t11 = p1 - 1
    coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t11
    coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2
    t14 = p1*t4
    t15 = p1*t5
    t16 = p1*t6 + t14 + t15
    t17 = t10*t7
    t18 = omega2*sin_omega2_half_tau*t7
    coefficient21 = -t16*t18 + t17*(t16 - t4 - t5 - t6)
    coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3
    coefficient23 = -cos_omega1_half_tau*t11 + cos_omega2_half_tau*p1
    t19 = omega3*sin_omega3_half_tau1
    coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t19
    t20 = p4 - 1
    coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t20
    coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5
    # right-hand sides of the linear equations
    right1 = t17*(t14 - t8) - t18*(k1*k2*p1 - t4 - t8)
    t21 = p3*t4 + t15
    right2 = -omega2*sin_omega2_half_tau*t21*t7 - t17*(-t21 + t5)
    right3 = -omega4*sin_omega4_half_tau1*t20 + p4*t19
    # determinant of the linear equations
    t22 = coefficient22*coefficient33
    t23 = coefficient12*coefficient23
    t24 = coefficient13*coefficient32
    t25 = coefficient23*coefficient32
    t26 = coefficient12*coefficient33
    t27 = coefficient13*coefficient22
    determinant = coefficient11*t22 - coefficient11*t25 + coefficient21*t24 - coefficient21*t26 + coefficient31*t23 - coefficient31*t27
    # numerators of Cramer's rule
    numerator1 = right1*t22 - right1*t25 + right2*t24 - right2*t26 + right3*t23 - right3*t27
    t28 = coefficient11*right3
    t29 = coefficient31*right2
    t30 = coefficient21*right1
    numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 - coefficient13*t29 + coefficient23*coefficient31*right1 - coefficient23*t28 - coefficient33*t30
    numerator3 = -coefficient11*coefficient32*right2 - coefficient12*coefficient21*right3 + coefficient12*t29 - coefficient22*coefficient31*right1 + coefficient22*t28 + coefficient32*t30
    # y, u, w by Cramer's rule
    t31 = 1/determinant
    y = numerator1*t31
    u = numerator2*t31
    w = numerator3*t31
    # outputs
    t32 = 2*p2**2
    t33 = half_tau**2
    t34 = t32*t33
    t35 = omega1**4/(omega1**2*t33 + 1)
    t36 = omega2**4/(omega2**2*t33 + 1)
    t37 = p1**2
    t38 = t11**2 + t37
    t39 = 2*t33
    t40 = 2*p5**2
    t41 = half_tau1**2
    t42 = t40*t41
    return (
        [y, u, w, tau],
        [determinant/(lib.sqrt(2*p3**2 + t11**2*t35*t39 + t36*t37*t39 + t38)*lib.sqrt(t32 + t34*t35 + t34*t36 + t38)*lib.sqrt(omega3**4*t42/(omega3**2*t41 + 1) + omega4**4*t42/(omega4**2*t41 + 1) + p4**2 + t20**2 + t40))],
    )
