# Generated; do not edit.
# Source: nonsmooth.derive.systems.elastic_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation bc8b907cd6e5cf02
"""Kernels and tables of the system elastic-stop, over any arithmetic ``lib``."""

DERIVATION = "bc8b907cd6e5cf02"

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
    Operations: 4407. Intermediate terms: 955.
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
    t17 = sin_omega1_tau*t16
    t19 = 1/omega2
    t20 = sin_omega2_tau*t19
    t21 = p1*t17 - t14*t20
    t22 = p2*sin_omega1_tau*t16 - p2*t20
    t23 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t24 = cos_omega1_tau*p1 - cos_omega2_tau*t14
    x1_1 = -cos_omega1_tau*t13 + cos_omega2_tau*t15 + t10 + t21*u + t22*w + t23*y + t24
    t25 = p3*t10
    t27 = t11*t14 - t25
    t28 = p1*t11
    t29 = -t25 + t28
    t30 = p3*sin_omega1_tau*t16 - p3*t20
    t31 = p1*t20 - t14*t17
    t32 = -cos_omega1_tau*t14 + cos_omega2_tau*p1
    t33 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    x2_1 = cos_omega1_tau*t27 - cos_omega2_tau*t29 + t11 + t30*u + t31*w + t32*y + t33
    t34 = omega1*p1
    t35 = omega1*t12 + t10*t34
    t36 = omega2*t12 + omega2*t14*t7*t9
    t37 = omega1*sin_omega1_tau
    t38 = omega2*p2*sin_omega2_tau - p2*t37
    t39 = -omega2*t14
    v1_1 = -sin_omega1_tau*t34 + sin_omega1_tau*t35 - sin_omega2_tau*t36 - sin_omega2_tau*t39 + t23*w + t24*u + t38*y
    t40 = omega1*p3
    t41 = -t11*t14
    t42 = omega1*t41 + t10*t40
    t43 = omega2*p3
    t44 = omega2*t28 - t10*t43
    t45 = omega2*sin_omega2_tau
    t46 = -p1*t45 + t14*t37
    v2_1 = -sin_omega1_tau*t40 + sin_omega1_tau*t42 + sin_omega2_tau*t43 + sin_omega2_tau*t44 + t32*w + t33*u + t46*y
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t47 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t47)
    sin_omega3_tau1 = lib.sin(t47)
    t50 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t50)
    sin_omega4_tau1 = lib.sin(t50)
    # free for tau1, until first-reaches-stop
    t53 = 1/omega3
    t54 = sin_omega3_tau1*t53
    t55 = 1 - p4
    t56 = 1/omega4
    t57 = sin_omega4_tau1*t56
    t58 = p4*t54 + t55*t57
    t59 = p5*sin_omega3_tau1*t53 - p5*t57
    t60 = cos_omega3_tau1*p4 + cos_omega4_tau1*t55
    t61 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t58*v1_1 + t59*v2_1 + t60*x1_1 + t61*x2_1
    t62 = p6*sin_omega3_tau1*t53 - p6*t57
    t63 = p4*t57 + t54*t55
    t64 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t65 = cos_omega3_tau1*t55 + cos_omega4_tau1*p4
    x2_2 = t62*v1_1 + t63*v2_1 + t64*x1_1 + t65*x2_1
    t66 = omega3*sin_omega3_tau1
    t67 = omega4*sin_omega4_tau1
    t68 = -p4*t66 - t55*t67
    t69 = omega4*p5*sin_omega4_tau1 - p5*t66
    v1_2 = t60*v1_1 + t61*v2_1 + t68*x1_1 + t69*x2_1
    t70 = omega4*p6*sin_omega4_tau1 - p6*t66
    t71 = -p4*t67 - t55*t66
    v2_2 = t64*v1_1 + t65*v2_1 + t70*x1_1 + t71*x2_1
    # Phi along tau
    carried_x1_1_by_y = t23
    carried_x1_1_by_u = t21
    carried_x1_1_by_w = t22
    carried_x2_1_by_y = t32
    carried_x2_1_by_u = t30
    carried_x2_1_by_w = t31
    carried_v1_1_by_y = t38
    carried_v1_1_by_u = t24
    carried_v1_1_by_w = t23
    carried_v2_1_by_y = t46
    carried_v2_1_by_u = t33
    carried_v2_1_by_w = t32
    # rate of the exit boundary after tau
    rate_1 = -v1_1
    # derivatives of the time to the boundary after tau
    t72 = 1/rate_1
    delay_tau_by_y = carried_x1_1_by_y*t72
    delay_tau_by_u = carried_x1_1_by_u*t72
    delay_tau_by_w = carried_x1_1_by_w*t72
    # perturbation on the boundary after tau
    x1_1_on_boundary_by_y = carried_x1_1_by_y + delay_tau_by_y*v1_1
    x1_1_on_boundary_by_u = carried_x1_1_by_u + delay_tau_by_u*v1_1
    x1_1_on_boundary_by_w = carried_x1_1_by_w + delay_tau_by_w*v1_1
    x2_1_on_boundary_by_y = carried_x2_1_by_y + delay_tau_by_y*v2_1
    x2_1_on_boundary_by_u = carried_x2_1_by_u + delay_tau_by_u*v2_1
    x2_1_on_boundary_by_w = carried_x2_1_by_w + delay_tau_by_w*v2_1
    t73 = 1/m1
    t74 = k1 + k3
    t75 = t73*x1_1
    t76 = k1*t73*x2_1 + k3*t73 - t74*t75
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t76
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t76
    v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t76
    t77 = 1/m2
    t78 = t77*x1_1
    t79 = k1 + k2
    t80 = t77*x2_1
    t81 = k1*t78 - t79*t80
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t81
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t81
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t81
    # Phi along tau1
    carried_x1_2_by_y = t58*v1_1_on_boundary_by_y + t59*v2_1_on_boundary_by_y + t60*x1_1_on_boundary_by_y + t61*x2_1_on_boundary_by_y
    carried_x1_2_by_u = t58*v1_1_on_boundary_by_u + t59*v2_1_on_boundary_by_u + t60*x1_1_on_boundary_by_u + t61*x2_1_on_boundary_by_u
    carried_x1_2_by_w = t58*v1_1_on_boundary_by_w + t59*v2_1_on_boundary_by_w + t60*x1_1_on_boundary_by_w + t61*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t82 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t82
    delay_tau1_by_u = -carried_x1_2_by_u*t82
    delay_tau1_by_w = -carried_x1_2_by_w*t82
    # d/dtau of: functions of tau in contact
    cos_omega1_tau_by_tau = -omega1*sin_omega1_tau
    sin_omega1_tau_by_tau = cos_omega1_tau*omega1
    cos_omega2_tau_by_tau = -omega2*sin_omega2_tau
    sin_omega2_tau_by_tau = cos_omega2_tau*omega2
    # d/dm1 of: functions of tau in contact
    t83 = omega1_by_m1*tau
    cos_omega1_tau_by_m1 = -sin_omega1_tau*t83
    sin_omega1_tau_by_m1 = cos_omega1_tau*t83
    t84 = omega2_by_m1*tau
    cos_omega2_tau_by_m1 = -sin_omega2_tau*t84
    sin_omega2_tau_by_m1 = cos_omega2_tau*t84
    # d/dm2 of: functions of tau in contact
    t85 = omega1_by_m2*tau
    cos_omega1_tau_by_m2 = -sin_omega1_tau*t85
    sin_omega1_tau_by_m2 = cos_omega1_tau*t85
    t86 = omega2_by_m2*tau
    cos_omega2_tau_by_m2 = -sin_omega2_tau*t86
    sin_omega2_tau_by_m2 = cos_omega2_tau*t86
    # d/dk1 of: functions of tau in contact
    t87 = omega1_by_k1*tau
    cos_omega1_tau_by_k1 = -sin_omega1_tau*t87
    sin_omega1_tau_by_k1 = cos_omega1_tau*t87
    t88 = omega2_by_k1*tau
    cos_omega2_tau_by_k1 = -sin_omega2_tau*t88
    sin_omega2_tau_by_k1 = cos_omega2_tau*t88
    # d/dk2 of: functions of tau in contact
    t89 = omega1_by_k2*tau
    cos_omega1_tau_by_k2 = -sin_omega1_tau*t89
    sin_omega1_tau_by_k2 = cos_omega1_tau*t89
    t90 = omega2_by_k2*tau
    cos_omega2_tau_by_k2 = -sin_omega2_tau*t90
    sin_omega2_tau_by_k2 = cos_omega2_tau*t90
    # d/dk3 of: functions of tau in contact
    t91 = omega1_by_k3*tau
    cos_omega1_tau_by_k3 = -sin_omega1_tau*t91
    sin_omega1_tau_by_k3 = cos_omega1_tau*t91
    t92 = omega2_by_k3*tau
    cos_omega2_tau_by_k3 = -sin_omega2_tau*t92
    sin_omega2_tau_by_k3 = cos_omega2_tau*t92
    # d/dy of: contact for tau, until first-leaves-stop
    x1_1_by_y = t23
    x2_1_by_y = t32
    v1_1_by_y = t38
    v2_1_by_y = t46
    # d/du of: contact for tau, until first-leaves-stop
    x1_1_by_u = t21
    x2_1_by_u = t30
    v1_1_by_u = t24
    v2_1_by_u = t33
    # d/dw of: contact for tau, until first-leaves-stop
    x1_1_by_w = t22
    x2_1_by_w = t31
    v1_1_by_w = t23
    v2_1_by_w = t32
    # d/dtau of: contact for tau, until first-leaves-stop
    t93 = p2*y
    t94 = -p1 - t93
    t95 = -t13 - t94
    t96 = t15 + t94 + 1
    t97 = p1*u
    t98 = p2*w
    t99 = t16*t97 + t16*t98
    t100 = -t14*t19*u - t19*t98
    x1_1_by_tau = cos_omega1_tau_by_tau*t95 + cos_omega2_tau_by_tau*t96 + sin_omega1_tau_by_tau*t99 + sin_omega2_tau_by_tau*t100
    t101 = -t14*y
    t102 = p3 + t101 + t27
    t103 = p1*y - p3 - t29
    t104 = p3*u
    t105 = -t14*w
    t106 = t104*t16 + t105*t16
    t107 = p1*w
    t108 = -t104*t19 + t107*t19
    x2_1_by_tau = cos_omega1_tau_by_tau*t102 + cos_omega2_tau_by_tau*t103 + sin_omega1_tau_by_tau*t106 + sin_omega2_tau_by_tau*t108
    t109 = t97 + t98
    t110 = -t14*u - t98
    t111 = -omega1*t93 - t34 + t35
    t112 = omega2*p2*y - t36 - t39
    v1_1_by_tau = cos_omega1_tau_by_tau*t109 + cos_omega2_tau_by_tau*t110 + sin_omega1_tau_by_tau*t111 + sin_omega2_tau_by_tau*t112
    t113 = t104 + t105
    t114 = -t104 + t107
    t115 = -omega1*t101 - t40 + t42
    t116 = p1*y
    t117 = -omega2*t116 + t43 + t44
    v2_1_by_tau = cos_omega1_tau_by_tau*t113 + cos_omega2_tau_by_tau*t114 + sin_omega1_tau_by_tau*t115 + sin_omega2_tau_by_tau*t117
    # d/dm1 of: contact for tau, until first-leaves-stop
    t118 = 1/omega1**2
    t119 = sin_omega1_tau*t118
    t120 = -t119*t97 - t119*t98
    t121 = 1/omega2**2
    t122 = sin_omega2_tau*t121
    t123 = t122*t14*u + t122*t98
    t124 = -sin_omega1_tau*t16 + t20
    t126 = cos_omega1_tau - cos_omega2_tau
    t127 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t124*u + t126
    t128 = cos_omega2_tau*t11
    t129 = cos_omega1_tau*t11
    t130 = -t124*w + t126*y + t128 - t129
    x1_1_by_m1 = cos_omega1_tau_by_m1*t95 + cos_omega2_tau_by_m1*t96 + omega1_by_m1*t120 + omega2_by_m1*t123 + p1_by_m1*t127 + p2_by_m1*t130 + sin_omega1_tau_by_m1*t99 + sin_omega2_tau_by_m1*t100
    t131 = -t104*t119 - t105*t119
    t132 = p3*sin_omega2_tau*t121*u - t107*t122
    t134 = t124*w - t126*y - t128 + t129
    x2_1_by_m1 = cos_omega1_tau_by_m1*t102 + cos_omega2_tau_by_m1*t103 + omega1_by_m1*t131 + omega2_by_m1*t132 + p1_by_m1*t134 + p3_by_m1*t127 + sin_omega1_tau_by_m1*t106 + sin_omega2_tau_by_m1*t108
    t135 = p1*sin_omega1_tau
    t136 = sin_omega1_tau*t13 - sin_omega1_tau*t93 - t135
    t137 = -sin_omega2_tau*t14
    t138 = sin_omega2_tau*t93 + sin_omega2_tau*(-t12 - t14*t7*t9) - t137
    t139 = t10*t37 - t10*t45 + t126*u - t37 + t45
    t140 = -omega2*sin_omega2_tau + t37
    t142 = t11*t37
    t143 = t11*t45
    t144 = t126*w - t140*y + t142 - t143
    v1_1_by_m1 = cos_omega1_tau_by_m1*t109 + cos_omega2_tau_by_m1*t110 + omega1_by_m1*t136 + omega2_by_m1*t138 + p1_by_m1*t139 + p2_by_m1*t144 + sin_omega1_tau_by_m1*t111 + sin_omega2_tau_by_m1*t112
    t145 = p3*sin_omega1_tau
    t146 = -sin_omega1_tau*t101 + sin_omega1_tau*(t25 + t41) - t145
    t147 = p3*sin_omega2_tau
    t148 = -sin_omega2_tau*t116 + sin_omega2_tau*t29 + t147
    t149 = -t126*w + t140*y - t142 + t143
    v2_1_by_m1 = cos_omega1_tau_by_m1*t113 + cos_omega2_tau_by_m1*t114 + omega1_by_m1*t146 + omega2_by_m1*t148 + p1_by_m1*t149 + p3_by_m1*t139 + sin_omega1_tau_by_m1*t115 + sin_omega2_tau_by_m1*t117
    # d/dm2 of: contact for tau, until first-leaves-stop
    x1_1_by_m2 = cos_omega1_tau_by_m2*t95 + cos_omega2_tau_by_m2*t96 + omega1_by_m2*t120 + omega2_by_m2*t123 + p1_by_m2*t127 + p2_by_m2*t130 + sin_omega1_tau_by_m2*t99 + sin_omega2_tau_by_m2*t100
    x2_1_by_m2 = cos_omega1_tau_by_m2*t102 + cos_omega2_tau_by_m2*t103 + omega1_by_m2*t131 + omega2_by_m2*t132 + p1_by_m2*t134 + p3_by_m2*t127 + sin_omega1_tau_by_m2*t106 + sin_omega2_tau_by_m2*t108
    v1_1_by_m2 = cos_omega1_tau_by_m2*t109 + cos_omega2_tau_by_m2*t110 + omega1_by_m2*t136 + omega2_by_m2*t138 + p1_by_m2*t139 + p2_by_m2*t144 + sin_omega1_tau_by_m2*t111 + sin_omega2_tau_by_m2*t112
    v2_1_by_m2 = cos_omega1_tau_by_m2*t113 + cos_omega2_tau_by_m2*t114 + omega1_by_m2*t146 + omega2_by_m2*t148 + p1_by_m2*t149 + p3_by_m2*t139 + sin_omega1_tau_by_m2*t115 + sin_omega2_tau_by_m2*t117
    # d/dk1 of: contact for tau, until first-leaves-stop
    t150 = k3*t9
    t151 = p1*t150
    t152 = -k2 - k3
    t153 = 1/t8**2
    t154 = t153*t7
    t155 = t152*t154
    t156 = p2*t150
    t157 = t153*t6
    t158 = t152*t157
    t159 = p2*t158
    t160 = t156 + t159
    t161 = t14*t150
    x1_1_by_k1 = cos_omega1_tau*(-p1*t155 - t151 - t160) + cos_omega1_tau_by_k1*t95 + cos_omega2_tau*(t14*t155 + t160 + t161) + cos_omega2_tau_by_k1*t96 + omega1_by_k1*t120 + omega2_by_k1*t123 + p1_by_k1*t127 + p2_by_k1*t130 + sin_omega1_tau_by_k1*t99 + sin_omega2_tau_by_k1*t100 + t150 + t155
    t162 = p3*t150
    t163 = -p3*t155 - t162
    t164 = p1*t158
    x2_1_by_k1 = cos_omega1_tau*(t14*t158 + t161 + t163) + cos_omega1_tau_by_k1*t102 + cos_omega2_tau*(-t151 - t163 - t164) + cos_omega2_tau_by_k1*t103 + omega1_by_k1*t131 + omega2_by_k1*t132 + p1_by_k1*t134 + p3_by_k1*t127 + sin_omega1_tau_by_k1*t106 + sin_omega2_tau_by_k1*t108 + t150 + t158
    t165 = t150*t34
    v1_1_by_k1 = cos_omega1_tau_by_k1*t109 + cos_omega2_tau_by_k1*t110 + omega1_by_k1*t136 + omega2_by_k1*t138 + p1_by_k1*t139 + p2_by_k1*t144 + sin_omega1_tau*(omega1*t156 + omega1*t159 + t155*t34 + t165) + sin_omega1_tau_by_k1*t111 + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t152*t153*t7 - omega2*t156 - omega2*t159) + sin_omega2_tau_by_k1*t112
    t166 = t150*t40
    t167 = -omega1*t14
    t168 = t150*t43
    v2_1_by_k1 = cos_omega1_tau_by_k1*t113 + cos_omega2_tau_by_k1*t114 + omega1_by_k1*t146 + omega2_by_k1*t148 + p1_by_k1*t149 + p3_by_k1*t139 + sin_omega1_tau*(t150*t167 + t155*t40 + t158*t167 + t166) + sin_omega1_tau_by_k1*t115 + sin_omega2_tau*(omega2*t151 + omega2*t164 - t155*t43 - t168) + sin_omega2_tau_by_k1*t117
    # d/dk2 of: contact for tau, until first-leaves-stop
    t170 = -t154*t74
    t171 = -t157*t74
    t172 = p2*t171
    x1_1_by_k2 = cos_omega1_tau*(-p1*t170 - t151 - t172) + cos_omega1_tau_by_k2*t95 + cos_omega2_tau*(t14*t170 + t161 + t172) + cos_omega2_tau_by_k2*t96 + omega1_by_k2*t120 + omega2_by_k2*t123 + p1_by_k2*t127 + p2_by_k2*t130 + sin_omega1_tau_by_k2*t99 + sin_omega2_tau_by_k2*t100 + t150 + t170
    t173 = p3*t170 + t162
    x2_1_by_k2 = cos_omega1_tau*(-k1*k3*t14*t153*t74 - t173) + cos_omega1_tau_by_k2*t102 + cos_omega2_tau*(-p1*t171 + t173) + cos_omega2_tau_by_k2*t103 + omega1_by_k2*t131 + omega2_by_k2*t132 + p1_by_k2*t134 + p3_by_k2*t127 + sin_omega1_tau_by_k2*t106 + sin_omega2_tau_by_k2*t108 + t171
    v1_1_by_k2 = cos_omega1_tau_by_k2*t109 + cos_omega2_tau_by_k2*t110 + omega1_by_k2*t136 + omega2_by_k2*t138 + p1_by_k2*t139 + p2_by_k2*t144 + sin_omega1_tau*(omega1*t172 + t165 + t170*t34) + sin_omega1_tau_by_k2*t111 + sin_omega2_tau*(-omega2*t172 + t150*t39 + t170*t39) + sin_omega2_tau_by_k2*t112
    v2_1_by_k2 = cos_omega1_tau_by_k2*t113 + cos_omega2_tau_by_k2*t114 + omega1_by_k2*t146 + omega2_by_k2*t148 + p1_by_k2*t149 + p3_by_k2*t139 + sin_omega1_tau*(t166 + t167*t171 + t170*t40) + sin_omega1_tau_by_k2*t115 + sin_omega2_tau*(-k1*k3*omega2*p1*t153*t74 - t168 - t170*t43) + sin_omega2_tau_by_k2*t117
    # d/dk3 of: contact for tau, until first-leaves-stop
    t174 = t79*t9
    t176 = -t154*t79
    t177 = k1*t9
    t178 = p2*t177
    t179 = -t157*t79
    t180 = p2*t179
    t181 = t178 + t180
    x1_1_by_k3 = cos_omega1_tau*(-p1*t174 - p1*t176 - t181) + cos_omega1_tau_by_k3*t95 + cos_omega2_tau*(t14*t174 + t14*t176 + t181) + cos_omega2_tau_by_k3*t96 + omega1_by_k3*t120 + omega2_by_k3*t123 + p1_by_k3*t127 + p2_by_k3*t130 + sin_omega1_tau_by_k3*t99 + sin_omega2_tau_by_k3*t100 + t174 + t176
    t182 = -p3*t174 - p3*t176
    t183 = p1*t177
    t184 = p1*t179
    x2_1_by_k3 = cos_omega1_tau*(t14*t177 + t14*t179 + t182) + cos_omega1_tau_by_k3*t102 + cos_omega2_tau*(-t182 - t183 - t184) + cos_omega2_tau_by_k3*t103 + omega1_by_k3*t131 + omega2_by_k3*t132 + p1_by_k3*t134 + p3_by_k3*t127 + sin_omega1_tau_by_k3*t106 + sin_omega2_tau_by_k3*t108 + t177 + t179
    v1_1_by_k3 = cos_omega1_tau_by_k3*t109 + cos_omega2_tau_by_k3*t110 + omega1_by_k3*t136 + omega2_by_k3*t138 + p1_by_k3*t139 + p2_by_k3*t144 + sin_omega1_tau*(omega1*t178 + omega1*t180 + t174*t34 + t176*t34) + sin_omega1_tau_by_k3*t111 + sin_omega2_tau*(omega2*t14*t153*t7*t79 - omega2*t14*t79*t9 - omega2*t178 - omega2*t180) + sin_omega2_tau_by_k3*t112
    v2_1_by_k3 = cos_omega1_tau_by_k3*t113 + cos_omega2_tau_by_k3*t114 + omega1_by_k3*t146 + omega2_by_k3*t148 + p1_by_k3*t149 + p3_by_k3*t139 + sin_omega1_tau*(t167*t177 + t167*t179 + t174*t40 + t176*t40) + sin_omega1_tau_by_k3*t115 + sin_omega2_tau*(omega2*t183 + omega2*t184 - t174*t43 - t176*t43) + sin_omega2_tau_by_k3*t117
    # d/dtau of: functions of tau1 in free
    cos_omega3_tau1_by_tau = omega3*sin_omega3_tau1
    t186 = cos_omega3_tau1*omega3
    sin_omega3_tau1_by_tau = -t186
    cos_omega4_tau1_by_tau = omega4*sin_omega4_tau1
    t188 = cos_omega4_tau1*omega4
    sin_omega4_tau1_by_tau = -t188
    # d/dm1 of: functions of tau1 in free
    t189 = omega3_by_m1*tau1
    cos_omega3_tau1_by_m1 = -sin_omega3_tau1*t189
    sin_omega3_tau1_by_m1 = cos_omega3_tau1*t189
    t190 = omega4_by_m1*tau1
    cos_omega4_tau1_by_m1 = -sin_omega4_tau1*t190
    sin_omega4_tau1_by_m1 = cos_omega4_tau1*t190
    # d/dm2 of: functions of tau1 in free
    t191 = omega3_by_m2*tau1
    cos_omega3_tau1_by_m2 = -sin_omega3_tau1*t191
    sin_omega3_tau1_by_m2 = cos_omega3_tau1*t191
    t192 = omega4_by_m2*tau1
    cos_omega4_tau1_by_m2 = -sin_omega4_tau1*t192
    sin_omega4_tau1_by_m2 = cos_omega4_tau1*t192
    # d/dk1 of: functions of tau1 in free
    t193 = omega3_by_k1*tau1
    cos_omega3_tau1_by_k1 = -sin_omega3_tau1*t193
    sin_omega3_tau1_by_k1 = cos_omega3_tau1*t193
    t194 = omega4_by_k1*tau1
    cos_omega4_tau1_by_k1 = -sin_omega4_tau1*t194
    sin_omega4_tau1_by_k1 = cos_omega4_tau1*t194
    # d/dk2 of: functions of tau1 in free
    t195 = omega3_by_k2*tau1
    cos_omega3_tau1_by_k2 = -sin_omega3_tau1*t195
    sin_omega3_tau1_by_k2 = cos_omega3_tau1*t195
    t196 = omega4_by_k2*tau1
    cos_omega4_tau1_by_k2 = -sin_omega4_tau1*t196
    sin_omega4_tau1_by_k2 = cos_omega4_tau1*t196
    # d/dk3 of: functions of tau1 in free
    t197 = omega3_by_k3*tau1
    cos_omega3_tau1_by_k3 = -sin_omega3_tau1*t197
    sin_omega3_tau1_by_k3 = cos_omega3_tau1*t197
    t198 = omega4_by_k3*tau1
    cos_omega4_tau1_by_k3 = -sin_omega4_tau1*t198
    sin_omega4_tau1_by_k3 = cos_omega4_tau1*t198
    # d/dT of: functions of tau1 in free
    cos_omega3_tau1_by_T = -cos_omega3_tau1_by_tau
    sin_omega3_tau1_by_T = t186
    cos_omega4_tau1_by_T = -cos_omega4_tau1_by_tau
    sin_omega4_tau1_by_T = t188
    # d/dy of: free for tau1, until first-reaches-stop
    x1_2_by_y = t58*v1_1_by_y + t59*v2_1_by_y + t60*x1_1_by_y + t61*x2_1_by_y
    x2_2_by_y = t62*v1_1_by_y + t63*v2_1_by_y + t64*x1_1_by_y + t65*x2_1_by_y
    v1_2_by_y = t60*v1_1_by_y + t61*v2_1_by_y + t68*x1_1_by_y + t69*x2_1_by_y
    v2_2_by_y = t64*v1_1_by_y + t65*v2_1_by_y + t70*x1_1_by_y + t71*x2_1_by_y
    # d/du of: free for tau1, until first-reaches-stop
    x1_2_by_u = t58*v1_1_by_u + t59*v2_1_by_u + t60*x1_1_by_u + t61*x2_1_by_u
    x2_2_by_u = t62*v1_1_by_u + t63*v2_1_by_u + t64*x1_1_by_u + t65*x2_1_by_u
    v1_2_by_u = t60*v1_1_by_u + t61*v2_1_by_u + t68*x1_1_by_u + t69*x2_1_by_u
    v2_2_by_u = t64*v1_1_by_u + t65*v2_1_by_u + t70*x1_1_by_u + t71*x2_1_by_u
    # d/dw of: free for tau1, until first-reaches-stop
    x1_2_by_w = t58*v1_1_by_w + t59*v2_1_by_w + t60*x1_1_by_w + t61*x2_1_by_w
    x2_2_by_w = t62*v1_1_by_w + t63*v2_1_by_w + t64*x1_1_by_w + t65*x2_1_by_w
    v1_2_by_w = t60*v1_1_by_w + t61*v2_1_by_w + t68*x1_1_by_w + t69*x2_1_by_w
    v2_2_by_w = t64*v1_1_by_w + t65*v2_1_by_w + t70*x1_1_by_w + t71*x2_1_by_w
    # d/dtau of: free for tau1, until first-reaches-stop
    t199 = p4*x1_1
    t200 = p5*x2_1
    t201 = t199 + t200
    t202 = -t200 + t55*x1_1
    t203 = p4*v1_1
    t204 = p5*v2_1
    t205 = t203*t53 + t204*t53
    t206 = -t204*t56 + t55*t56*v1_1
    x1_2_by_tau = cos_omega3_tau1_by_tau*t201 + cos_omega4_tau1_by_tau*t202 + sin_omega3_tau1_by_tau*t205 + sin_omega4_tau1_by_tau*t206 + t58*v1_1_by_tau + t59*v2_1_by_tau + t60*x1_1_by_tau + t61*x2_1_by_tau
    t207 = p6*x1_1
    t208 = t55*x2_1
    t209 = t207 + t208
    t210 = p4*x2_1
    t211 = -t207 + t210
    t212 = p6*v1_1
    t213 = t55*v2_1
    t214 = t212*t53 + t213*t53
    t215 = p4*v2_1
    t216 = -t212*t56 + t215*t56
    x2_2_by_tau = cos_omega3_tau1_by_tau*t209 + cos_omega4_tau1_by_tau*t211 + sin_omega3_tau1_by_tau*t214 + sin_omega4_tau1_by_tau*t216 + t62*v1_1_by_tau + t63*v2_1_by_tau + t64*x1_1_by_tau + t65*x2_1_by_tau
    t217 = t203 + t204
    t218 = -t204 + t55*v1_1
    t219 = -omega3*t199 - omega3*t200
    t220 = t55*x1_1
    t221 = omega4*t200 - omega4*t220
    v1_2_by_tau = cos_omega3_tau1_by_tau*t217 + cos_omega4_tau1_by_tau*t218 + sin_omega3_tau1_by_tau*t219 + sin_omega4_tau1_by_tau*t221 + t60*v1_1_by_tau + t61*v2_1_by_tau + t68*x1_1_by_tau + t69*x2_1_by_tau
    t222 = t212 + t213
    t223 = -t212 + t215
    t224 = -omega3*t207 - omega3*t208
    t225 = omega4*p6*x1_1 - omega4*t210
    v2_2_by_tau = cos_omega3_tau1_by_tau*t222 + cos_omega4_tau1_by_tau*t223 + sin_omega3_tau1_by_tau*t224 + sin_omega4_tau1_by_tau*t225 + t64*v1_1_by_tau + t65*v2_1_by_tau + t70*x1_1_by_tau + t71*x2_1_by_tau
    # d/dm1 of: free for tau1, until first-reaches-stop
    t226 = sin_omega3_tau1/omega3**2
    t227 = -t203*t226 - t204*t226
    t228 = 1/omega4**2
    t229 = sin_omega4_tau1*t228
    t230 = t204*t229 - t229*t55*v1_1
    t231 = -sin_omega3_tau1*t53 + t57
    t233 = cos_omega3_tau1 - cos_omega4_tau1
    t234 = -t231*v1_1 + t233*x1_1
    t235 = -t231*v2_1 + t233*x2_1
    x1_2_by_m1 = cos_omega3_tau1_by_m1*t201 + cos_omega4_tau1_by_m1*t202 + omega3_by_m1*t227 + omega4_by_m1*t230 + p4_by_m1*t234 + p5_by_m1*t235 + sin_omega3_tau1_by_m1*t205 + sin_omega4_tau1_by_m1*t206 + t58*v1_1_by_m1 + t59*v2_1_by_m1 + t60*x1_1_by_m1 + t61*x2_1_by_m1
    t236 = -t212*t226 - t213*t226
    t237 = p6*sin_omega4_tau1*t228*v1_1 - t215*t229
    t239 = t231*v2_1 - t233*x2_1
    x2_2_by_m1 = cos_omega3_tau1_by_m1*t209 + cos_omega4_tau1_by_m1*t211 + omega3_by_m1*t236 + omega4_by_m1*t237 + p4_by_m1*t239 + p6_by_m1*t234 + sin_omega3_tau1_by_m1*t214 + sin_omega4_tau1_by_m1*t216 + t62*v1_1_by_m1 + t63*v2_1_by_m1 + t64*x1_1_by_m1 + t65*x2_1_by_m1
    t240 = -sin_omega3_tau1*t199 - sin_omega3_tau1*t200
    t241 = sin_omega4_tau1*t200 - sin_omega4_tau1*t220
    t242 = -omega4*sin_omega4_tau1 + t66
    t244 = t233*v1_1 - t242*x1_1
    t245 = t233*v2_1 - t242*x2_1
    v1_2_by_m1 = cos_omega3_tau1_by_m1*t217 + cos_omega4_tau1_by_m1*t218 + omega3_by_m1*t240 + omega4_by_m1*t241 + p4_by_m1*t244 + p5_by_m1*t245 + sin_omega3_tau1_by_m1*t219 + sin_omega4_tau1_by_m1*t221 + t60*v1_1_by_m1 + t61*v2_1_by_m1 + t68*x1_1_by_m1 + t69*x2_1_by_m1
    t246 = -sin_omega3_tau1*t207 - sin_omega3_tau1*t208
    t247 = p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t210
    t248 = -t233*v2_1 + t242*x2_1
    v2_2_by_m1 = cos_omega3_tau1_by_m1*t222 + cos_omega4_tau1_by_m1*t223 + omega3_by_m1*t246 + omega4_by_m1*t247 + p4_by_m1*t248 + p6_by_m1*t244 + sin_omega3_tau1_by_m1*t224 + sin_omega4_tau1_by_m1*t225 + t64*v1_1_by_m1 + t65*v2_1_by_m1 + t70*x1_1_by_m1 + t71*x2_1_by_m1
    # d/dm2 of: free for tau1, until first-reaches-stop
    x1_2_by_m2 = cos_omega3_tau1_by_m2*t201 + cos_omega4_tau1_by_m2*t202 + omega3_by_m2*t227 + omega4_by_m2*t230 + p4_by_m2*t234 + p5_by_m2*t235 + sin_omega3_tau1_by_m2*t205 + sin_omega4_tau1_by_m2*t206 + t58*v1_1_by_m2 + t59*v2_1_by_m2 + t60*x1_1_by_m2 + t61*x2_1_by_m2
    x2_2_by_m2 = cos_omega3_tau1_by_m2*t209 + cos_omega4_tau1_by_m2*t211 + omega3_by_m2*t236 + omega4_by_m2*t237 + p4_by_m2*t239 + p6_by_m2*t234 + sin_omega3_tau1_by_m2*t214 + sin_omega4_tau1_by_m2*t216 + t62*v1_1_by_m2 + t63*v2_1_by_m2 + t64*x1_1_by_m2 + t65*x2_1_by_m2
    v1_2_by_m2 = cos_omega3_tau1_by_m2*t217 + cos_omega4_tau1_by_m2*t218 + omega3_by_m2*t240 + omega4_by_m2*t241 + p4_by_m2*t244 + p5_by_m2*t245 + sin_omega3_tau1_by_m2*t219 + sin_omega4_tau1_by_m2*t221 + t60*v1_1_by_m2 + t61*v2_1_by_m2 + t68*x1_1_by_m2 + t69*x2_1_by_m2
    v2_2_by_m2 = cos_omega3_tau1_by_m2*t222 + cos_omega4_tau1_by_m2*t223 + omega3_by_m2*t246 + omega4_by_m2*t247 + p4_by_m2*t248 + p6_by_m2*t244 + sin_omega3_tau1_by_m2*t224 + sin_omega4_tau1_by_m2*t225 + t64*v1_1_by_m2 + t65*v2_1_by_m2 + t70*x1_1_by_m2 + t71*x2_1_by_m2
    # d/dk1 of: free for tau1, until first-reaches-stop
    x1_2_by_k1 = cos_omega3_tau1_by_k1*t201 + cos_omega4_tau1_by_k1*t202 + omega3_by_k1*t227 + omega4_by_k1*t230 + p4_by_k1*t234 + p5_by_k1*t235 + sin_omega3_tau1_by_k1*t205 + sin_omega4_tau1_by_k1*t206 + t58*v1_1_by_k1 + t59*v2_1_by_k1 + t60*x1_1_by_k1 + t61*x2_1_by_k1
    x2_2_by_k1 = cos_omega3_tau1_by_k1*t209 + cos_omega4_tau1_by_k1*t211 + omega3_by_k1*t236 + omega4_by_k1*t237 + p4_by_k1*t239 + p6_by_k1*t234 + sin_omega3_tau1_by_k1*t214 + sin_omega4_tau1_by_k1*t216 + t62*v1_1_by_k1 + t63*v2_1_by_k1 + t64*x1_1_by_k1 + t65*x2_1_by_k1
    v1_2_by_k1 = cos_omega3_tau1_by_k1*t217 + cos_omega4_tau1_by_k1*t218 + omega3_by_k1*t240 + omega4_by_k1*t241 + p4_by_k1*t244 + p5_by_k1*t245 + sin_omega3_tau1_by_k1*t219 + sin_omega4_tau1_by_k1*t221 + t60*v1_1_by_k1 + t61*v2_1_by_k1 + t68*x1_1_by_k1 + t69*x2_1_by_k1
    v2_2_by_k1 = cos_omega3_tau1_by_k1*t222 + cos_omega4_tau1_by_k1*t223 + omega3_by_k1*t246 + omega4_by_k1*t247 + p4_by_k1*t248 + p6_by_k1*t244 + sin_omega3_tau1_by_k1*t224 + sin_omega4_tau1_by_k1*t225 + t64*v1_1_by_k1 + t65*v2_1_by_k1 + t70*x1_1_by_k1 + t71*x2_1_by_k1
    # d/dk2 of: free for tau1, until first-reaches-stop
    x1_2_by_k2 = cos_omega3_tau1_by_k2*t201 + cos_omega4_tau1_by_k2*t202 + omega3_by_k2*t227 + omega4_by_k2*t230 + p4_by_k2*t234 + p5_by_k2*t235 + sin_omega3_tau1_by_k2*t205 + sin_omega4_tau1_by_k2*t206 + t58*v1_1_by_k2 + t59*v2_1_by_k2 + t60*x1_1_by_k2 + t61*x2_1_by_k2
    x2_2_by_k2 = cos_omega3_tau1_by_k2*t209 + cos_omega4_tau1_by_k2*t211 + omega3_by_k2*t236 + omega4_by_k2*t237 + p4_by_k2*t239 + p6_by_k2*t234 + sin_omega3_tau1_by_k2*t214 + sin_omega4_tau1_by_k2*t216 + t62*v1_1_by_k2 + t63*v2_1_by_k2 + t64*x1_1_by_k2 + t65*x2_1_by_k2
    v1_2_by_k2 = cos_omega3_tau1_by_k2*t217 + cos_omega4_tau1_by_k2*t218 + omega3_by_k2*t240 + omega4_by_k2*t241 + p4_by_k2*t244 + p5_by_k2*t245 + sin_omega3_tau1_by_k2*t219 + sin_omega4_tau1_by_k2*t221 + t60*v1_1_by_k2 + t61*v2_1_by_k2 + t68*x1_1_by_k2 + t69*x2_1_by_k2
    v2_2_by_k2 = cos_omega3_tau1_by_k2*t222 + cos_omega4_tau1_by_k2*t223 + omega3_by_k2*t246 + omega4_by_k2*t247 + p4_by_k2*t248 + p6_by_k2*t244 + sin_omega3_tau1_by_k2*t224 + sin_omega4_tau1_by_k2*t225 + t64*v1_1_by_k2 + t65*v2_1_by_k2 + t70*x1_1_by_k2 + t71*x2_1_by_k2
    # d/dk3 of: free for tau1, until first-reaches-stop
    x1_2_by_k3 = cos_omega3_tau1_by_k3*t201 + cos_omega4_tau1_by_k3*t202 + omega3_by_k3*t227 + omega4_by_k3*t230 + p4_by_k3*t234 + p5_by_k3*t235 + sin_omega3_tau1_by_k3*t205 + sin_omega4_tau1_by_k3*t206 + t58*v1_1_by_k3 + t59*v2_1_by_k3 + t60*x1_1_by_k3 + t61*x2_1_by_k3
    x2_2_by_k3 = cos_omega3_tau1_by_k3*t209 + cos_omega4_tau1_by_k3*t211 + omega3_by_k3*t236 + omega4_by_k3*t237 + p4_by_k3*t239 + p6_by_k3*t234 + sin_omega3_tau1_by_k3*t214 + sin_omega4_tau1_by_k3*t216 + t62*v1_1_by_k3 + t63*v2_1_by_k3 + t64*x1_1_by_k3 + t65*x2_1_by_k3
    v1_2_by_k3 = cos_omega3_tau1_by_k3*t217 + cos_omega4_tau1_by_k3*t218 + omega3_by_k3*t240 + omega4_by_k3*t241 + p4_by_k3*t244 + p5_by_k3*t245 + sin_omega3_tau1_by_k3*t219 + sin_omega4_tau1_by_k3*t221 + t60*v1_1_by_k3 + t61*v2_1_by_k3 + t68*x1_1_by_k3 + t69*x2_1_by_k3
    v2_2_by_k3 = cos_omega3_tau1_by_k3*t222 + cos_omega4_tau1_by_k3*t223 + omega3_by_k3*t246 + omega4_by_k3*t247 + p4_by_k3*t248 + p6_by_k3*t244 + sin_omega3_tau1_by_k3*t224 + sin_omega4_tau1_by_k3*t225 + t64*v1_1_by_k3 + t65*v2_1_by_k3 + t70*x1_1_by_k3 + t71*x2_1_by_k3
    # d/dT of: free for tau1, until first-reaches-stop
    x1_2_by_T = cos_omega3_tau1_by_T*t201 + cos_omega4_tau1_by_T*t202 + sin_omega3_tau1_by_T*t205 + sin_omega4_tau1_by_T*t206
    x2_2_by_T = cos_omega3_tau1_by_T*t209 + cos_omega4_tau1_by_T*t211 + sin_omega3_tau1_by_T*t214 + sin_omega4_tau1_by_T*t216
    v1_2_by_T = cos_omega3_tau1_by_T*t217 + cos_omega4_tau1_by_T*t218 + sin_omega3_tau1_by_T*t219 + sin_omega4_tau1_by_T*t221
    v2_2_by_T = cos_omega3_tau1_by_T*t222 + cos_omega4_tau1_by_T*t223 + sin_omega3_tau1_by_T*t224 + sin_omega4_tau1_by_T*t225
    # d/dtau of: Phi along tau
    carried_x1_1_by_y_by_tau = cos_omega1_tau_by_tau*p2 - cos_omega2_tau_by_tau*p2
    t250 = sin_omega1_tau_by_tau*t16
    t251 = sin_omega2_tau_by_tau*t19
    carried_x1_1_by_u_by_tau = p1*t250 - t14*t251
    carried_x1_1_by_w_by_tau = p2*sin_omega1_tau_by_tau*t16 - p2*t251
    carried_x2_1_by_y_by_tau = -cos_omega1_tau_by_tau*t14 + cos_omega2_tau_by_tau*p1
    carried_x2_1_by_u_by_tau = p3*sin_omega1_tau_by_tau*t16 - p3*t251
    carried_x2_1_by_w_by_tau = p1*t251 - t14*t250
    t253 = omega1*sin_omega1_tau_by_tau
    carried_v1_1_by_y_by_tau = omega2*p2*sin_omega2_tau_by_tau - p2*t253
    carried_v1_1_by_u_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t14
    carried_v1_1_by_w_by_tau = carried_x1_1_by_y_by_tau
    carried_v2_1_by_y_by_tau = -omega2*p1*sin_omega2_tau_by_tau + t14*t253
    carried_v2_1_by_u_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3
    carried_v2_1_by_w_by_tau = carried_x2_1_by_y_by_tau
    # d/dm1 of: Phi along tau
    carried_x1_1_by_y_by_m1 = cos_omega1_tau_by_m1*p2 - cos_omega2_tau_by_m1*p2 + p2_by_m1*t126
    t255 = sin_omega1_tau_by_m1*t16
    t256 = sin_omega2_tau_by_m1*t19
    t257 = omega1_by_m1*t118
    t258 = omega2_by_m1*t121
    carried_x1_1_by_u_by_m1 = p1*t255 - p1_by_m1*t124 - t135*t257 - t137*t258 - t14*t256
    t259 = omega2_by_m1*sin_omega2_tau
    t260 = p2*t259
    t261 = omega1_by_m1*sin_omega1_tau
    t262 = p2*t261
    carried_x1_1_by_w_by_m1 = p2*t255 - p2*t256 - p2_by_m1*t124 - t118*t262 + t121*t260
    carried_x2_1_by_y_by_m1 = -cos_omega1_tau_by_m1*t14 + cos_omega2_tau_by_m1*p1 - p1_by_m1*t126
    carried_x2_1_by_u_by_m1 = p3*t255 - p3*t256 - p3_by_m1*t124 - t145*t257 + t147*t258
    t264 = -t14*t261
    t265 = p1*t259
    carried_x2_1_by_w_by_m1 = p1*t256 + p1_by_m1*t124 - t118*t264 - t121*t265 - t14*t255
    t266 = omega2*sin_omega2_tau_by_m1
    t267 = omega1*sin_omega1_tau_by_m1
    carried_v1_1_by_y_by_m1 = p2*t266 - p2*t267 - p2_by_m1*t140 + t260 - t262
    carried_v1_1_by_u_by_m1 = cos_omega1_tau_by_m1*p1 - cos_omega2_tau_by_m1*t14 + p1_by_m1*t126
    carried_v1_1_by_w_by_m1 = carried_x1_1_by_y_by_m1
    carried_v2_1_by_y_by_m1 = -p1*t266 + p1_by_m1*t140 + t14*t267 - t264 - t265
    carried_v2_1_by_u_by_m1 = cos_omega1_tau_by_m1*p3 - cos_omega2_tau_by_m1*p3 + p3_by_m1*t126
    carried_v2_1_by_w_by_m1 = carried_x2_1_by_y_by_m1
    # d/dm2 of: Phi along tau
    carried_x1_1_by_y_by_m2 = cos_omega1_tau_by_m2*p2 - cos_omega2_tau_by_m2*p2 + p2_by_m2*t126
    t269 = sin_omega1_tau_by_m2*t16
    t270 = sin_omega2_tau_by_m2*t19
    t271 = omega1_by_m2*t118
    t272 = omega2_by_m2*t121
    carried_x1_1_by_u_by_m2 = p1*t269 - p1_by_m2*t124 - t135*t271 - t137*t272 - t14*t270
    t273 = omega2_by_m2*sin_omega2_tau
    t274 = p2*t273
    t275 = omega1_by_m2*sin_omega1_tau
    t276 = p2*t275
    carried_x1_1_by_w_by_m2 = p2*t269 - p2*t270 - p2_by_m2*t124 - t118*t276 + t121*t274
    carried_x2_1_by_y_by_m2 = -cos_omega1_tau_by_m2*t14 + cos_omega2_tau_by_m2*p1 - p1_by_m2*t126
    carried_x2_1_by_u_by_m2 = p3*t269 - p3*t270 - p3_by_m2*t124 - t145*t271 + t147*t272
    t278 = -t14*t275
    t279 = p1*t273
    carried_x2_1_by_w_by_m2 = p1*t270 + p1_by_m2*t124 - t118*t278 - t121*t279 - t14*t269
    t280 = omega2*sin_omega2_tau_by_m2
    t281 = omega1*sin_omega1_tau_by_m2
    carried_v1_1_by_y_by_m2 = p2*t280 - p2*t281 - p2_by_m2*t140 + t274 - t276
    carried_v1_1_by_u_by_m2 = cos_omega1_tau_by_m2*p1 - cos_omega2_tau_by_m2*t14 + p1_by_m2*t126
    carried_v1_1_by_w_by_m2 = carried_x1_1_by_y_by_m2
    carried_v2_1_by_y_by_m2 = -p1*t280 + p1_by_m2*t140 + t14*t281 - t278 - t279
    carried_v2_1_by_u_by_m2 = cos_omega1_tau_by_m2*p3 - cos_omega2_tau_by_m2*p3 + p3_by_m2*t126
    carried_v2_1_by_w_by_m2 = carried_x2_1_by_y_by_m2
    # d/dk1 of: Phi along tau
    carried_x1_1_by_y_by_k1 = cos_omega1_tau_by_k1*p2 - cos_omega2_tau_by_k1*p2 + p2_by_k1*t126
    t283 = sin_omega1_tau_by_k1*t16
    t284 = sin_omega2_tau_by_k1*t19
    t285 = omega1_by_k1*t118
    t286 = omega2_by_k1*t121
    carried_x1_1_by_u_by_k1 = p1*t283 - p1_by_k1*t124 - t135*t285 - t137*t286 - t14*t284
    t287 = omega2_by_k1*sin_omega2_tau
    t288 = p2*t287
    t289 = omega1_by_k1*sin_omega1_tau
    t290 = p2*t289
    carried_x1_1_by_w_by_k1 = p2*t283 - p2*t284 - p2_by_k1*t124 - t118*t290 + t121*t288
    carried_x2_1_by_y_by_k1 = -cos_omega1_tau_by_k1*t14 + cos_omega2_tau_by_k1*p1 - p1_by_k1*t126
    carried_x2_1_by_u_by_k1 = p3*t283 - p3*t284 - p3_by_k1*t124 - t145*t285 + t147*t286
    t292 = -t14*t289
    t293 = p1*t287
    carried_x2_1_by_w_by_k1 = p1*t284 + p1_by_k1*t124 - t118*t292 - t121*t293 - t14*t283
    t294 = omega2*sin_omega2_tau_by_k1
    t295 = omega1*sin_omega1_tau_by_k1
    carried_v1_1_by_y_by_k1 = p2*t294 - p2*t295 - p2_by_k1*t140 + t288 - t290
    carried_v1_1_by_u_by_k1 = cos_omega1_tau_by_k1*p1 - cos_omega2_tau_by_k1*t14 + p1_by_k1*t126
    carried_v1_1_by_w_by_k1 = carried_x1_1_by_y_by_k1
    carried_v2_1_by_y_by_k1 = -p1*t294 + p1_by_k1*t140 + t14*t295 - t292 - t293
    carried_v2_1_by_u_by_k1 = cos_omega1_tau_by_k1*p3 - cos_omega2_tau_by_k1*p3 + p3_by_k1*t126
    carried_v2_1_by_w_by_k1 = carried_x2_1_by_y_by_k1
    # d/dk2 of: Phi along tau
    carried_x1_1_by_y_by_k2 = cos_omega1_tau_by_k2*p2 - cos_omega2_tau_by_k2*p2 + p2_by_k2*t126
    t297 = sin_omega1_tau_by_k2*t16
    t298 = sin_omega2_tau_by_k2*t19
    t299 = omega1_by_k2*t118
    t300 = omega2_by_k2*t121
    carried_x1_1_by_u_by_k2 = p1*t297 - p1_by_k2*t124 - t135*t299 - t137*t300 - t14*t298
    t301 = omega2_by_k2*sin_omega2_tau
    t302 = p2*t301
    t303 = omega1_by_k2*sin_omega1_tau
    t304 = p2*t303
    carried_x1_1_by_w_by_k2 = p2*t297 - p2*t298 - p2_by_k2*t124 - t118*t304 + t121*t302
    carried_x2_1_by_y_by_k2 = -cos_omega1_tau_by_k2*t14 + cos_omega2_tau_by_k2*p1 - p1_by_k2*t126
    carried_x2_1_by_u_by_k2 = p3*t297 - p3*t298 - p3_by_k2*t124 - t145*t299 + t147*t300
    t306 = -t14*t303
    t307 = p1*t301
    carried_x2_1_by_w_by_k2 = p1*t298 + p1_by_k2*t124 - t118*t306 - t121*t307 - t14*t297
    t308 = omega2*sin_omega2_tau_by_k2
    t309 = omega1*sin_omega1_tau_by_k2
    carried_v1_1_by_y_by_k2 = p2*t308 - p2*t309 - p2_by_k2*t140 + t302 - t304
    carried_v1_1_by_u_by_k2 = cos_omega1_tau_by_k2*p1 - cos_omega2_tau_by_k2*t14 + p1_by_k2*t126
    carried_v1_1_by_w_by_k2 = carried_x1_1_by_y_by_k2
    carried_v2_1_by_y_by_k2 = -p1*t308 + p1_by_k2*t140 + t14*t309 - t306 - t307
    carried_v2_1_by_u_by_k2 = cos_omega1_tau_by_k2*p3 - cos_omega2_tau_by_k2*p3 + p3_by_k2*t126
    carried_v2_1_by_w_by_k2 = carried_x2_1_by_y_by_k2
    # d/dk3 of: Phi along tau
    carried_x1_1_by_y_by_k3 = cos_omega1_tau_by_k3*p2 - cos_omega2_tau_by_k3*p2 + p2_by_k3*t126
    t311 = sin_omega1_tau_by_k3*t16
    t312 = sin_omega2_tau_by_k3*t19
    t313 = omega1_by_k3*t118
    t314 = omega2_by_k3*t121
    carried_x1_1_by_u_by_k3 = p1*t311 - p1_by_k3*t124 - t135*t313 - t137*t314 - t14*t312
    t315 = omega2_by_k3*sin_omega2_tau
    t316 = p2*t315
    t317 = omega1_by_k3*sin_omega1_tau
    t318 = p2*t317
    carried_x1_1_by_w_by_k3 = p2*t311 - p2*t312 - p2_by_k3*t124 - t118*t318 + t121*t316
    carried_x2_1_by_y_by_k3 = -cos_omega1_tau_by_k3*t14 + cos_omega2_tau_by_k3*p1 - p1_by_k3*t126
    carried_x2_1_by_u_by_k3 = p3*t311 - p3*t312 - p3_by_k3*t124 - t145*t313 + t147*t314
    t320 = -t14*t317
    t321 = p1*t315
    carried_x2_1_by_w_by_k3 = p1*t312 + p1_by_k3*t124 - t118*t320 - t121*t321 - t14*t311
    t322 = omega2*sin_omega2_tau_by_k3
    t323 = omega1*sin_omega1_tau_by_k3
    carried_v1_1_by_y_by_k3 = p2*t322 - p2*t323 - p2_by_k3*t140 + t316 - t318
    carried_v1_1_by_u_by_k3 = cos_omega1_tau_by_k3*p1 - cos_omega2_tau_by_k3*t14 + p1_by_k3*t126
    carried_v1_1_by_w_by_k3 = carried_x1_1_by_y_by_k3
    carried_v2_1_by_y_by_k3 = -p1*t322 + p1_by_k3*t140 + t14*t323 - t320 - t321
    carried_v2_1_by_u_by_k3 = cos_omega1_tau_by_k3*p3 - cos_omega2_tau_by_k3*p3 + p3_by_k3*t126
    carried_v2_1_by_w_by_k3 = carried_x2_1_by_y_by_k3
    # d/dy of: rate of the exit boundary after tau
    rate_1_by_y = -v1_1_by_y
    # d/du of: rate of the exit boundary after tau
    rate_1_by_u = -v1_1_by_u
    # d/dw of: rate of the exit boundary after tau
    rate_1_by_w = -v1_1_by_w
    # d/dtau of: rate of the exit boundary after tau
    rate_1_by_tau = -v1_1_by_tau
    # d/dm1 of: rate of the exit boundary after tau
    rate_1_by_m1 = -v1_1_by_m1
    # d/dm2 of: rate of the exit boundary after tau
    rate_1_by_m2 = -v1_1_by_m2
    # d/dk1 of: rate of the exit boundary after tau
    rate_1_by_k1 = -v1_1_by_k1
    # d/dk2 of: rate of the exit boundary after tau
    rate_1_by_k2 = -v1_1_by_k2
    # d/dk3 of: rate of the exit boundary after tau
    rate_1_by_k3 = -v1_1_by_k3
    # d/dy of: derivatives of the time to the boundary after tau
    t324 = 1/rate_1**2
    t325 = rate_1_by_y*t324
    delay_tau_by_y_by_y = -carried_x1_1_by_y*t325
    delay_tau_by_u_by_y = -carried_x1_1_by_u*t325
    delay_tau_by_w_by_y = -carried_x1_1_by_w*t325
    # d/du of: derivatives of the time to the boundary after tau
    t326 = rate_1_by_u*t324
    delay_tau_by_y_by_u = -carried_x1_1_by_y*t326
    delay_tau_by_u_by_u = -carried_x1_1_by_u*t326
    delay_tau_by_w_by_u = -carried_x1_1_by_w*t326
    # d/dw of: derivatives of the time to the boundary after tau
    t327 = rate_1_by_w*t324
    delay_tau_by_y_by_w = -carried_x1_1_by_y*t327
    delay_tau_by_u_by_w = -carried_x1_1_by_u*t327
    delay_tau_by_w_by_w = -carried_x1_1_by_w*t327
    # d/dtau of: derivatives of the time to the boundary after tau
    t328 = rate_1_by_tau*t324
    delay_tau_by_y_by_tau = -carried_x1_1_by_y*t328 + carried_x1_1_by_y_by_tau*t72
    delay_tau_by_u_by_tau = -carried_x1_1_by_u*t328 + carried_x1_1_by_u_by_tau*t72
    delay_tau_by_w_by_tau = -carried_x1_1_by_w*t328 + carried_x1_1_by_w_by_tau*t72
    # d/dm1 of: derivatives of the time to the boundary after tau
    t329 = rate_1_by_m1*t324
    delay_tau_by_y_by_m1 = -carried_x1_1_by_y*t329 + carried_x1_1_by_y_by_m1*t72
    delay_tau_by_u_by_m1 = -carried_x1_1_by_u*t329 + carried_x1_1_by_u_by_m1*t72
    delay_tau_by_w_by_m1 = -carried_x1_1_by_w*t329 + carried_x1_1_by_w_by_m1*t72
    # d/dm2 of: derivatives of the time to the boundary after tau
    t330 = rate_1_by_m2*t324
    delay_tau_by_y_by_m2 = -carried_x1_1_by_y*t330 + carried_x1_1_by_y_by_m2*t72
    delay_tau_by_u_by_m2 = -carried_x1_1_by_u*t330 + carried_x1_1_by_u_by_m2*t72
    delay_tau_by_w_by_m2 = -carried_x1_1_by_w*t330 + carried_x1_1_by_w_by_m2*t72
    # d/dk1 of: derivatives of the time to the boundary after tau
    t331 = rate_1_by_k1*t324
    delay_tau_by_y_by_k1 = -carried_x1_1_by_y*t331 + carried_x1_1_by_y_by_k1*t72
    delay_tau_by_u_by_k1 = -carried_x1_1_by_u*t331 + carried_x1_1_by_u_by_k1*t72
    delay_tau_by_w_by_k1 = -carried_x1_1_by_w*t331 + carried_x1_1_by_w_by_k1*t72
    # d/dk2 of: derivatives of the time to the boundary after tau
    t332 = rate_1_by_k2*t324
    delay_tau_by_y_by_k2 = -carried_x1_1_by_y*t332 + carried_x1_1_by_y_by_k2*t72
    delay_tau_by_u_by_k2 = -carried_x1_1_by_u*t332 + carried_x1_1_by_u_by_k2*t72
    delay_tau_by_w_by_k2 = -carried_x1_1_by_w*t332 + carried_x1_1_by_w_by_k2*t72
    # d/dk3 of: derivatives of the time to the boundary after tau
    t333 = rate_1_by_k3*t324
    delay_tau_by_y_by_k3 = -carried_x1_1_by_y*t333 + carried_x1_1_by_y_by_k3*t72
    delay_tau_by_u_by_k3 = -carried_x1_1_by_u*t333 + carried_x1_1_by_u_by_k3*t72
    delay_tau_by_w_by_k3 = -carried_x1_1_by_w*t333 + carried_x1_1_by_w_by_k3*t72
    # d/dy of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_y = delay_tau_by_y*v1_1_by_y + delay_tau_by_y_by_y*v1_1
    x1_1_on_boundary_by_u_by_y = delay_tau_by_u*v1_1_by_y + delay_tau_by_u_by_y*v1_1
    x1_1_on_boundary_by_w_by_y = delay_tau_by_w*v1_1_by_y + delay_tau_by_w_by_y*v1_1
    x2_1_on_boundary_by_y_by_y = delay_tau_by_y*v2_1_by_y + delay_tau_by_y_by_y*v2_1
    x2_1_on_boundary_by_u_by_y = delay_tau_by_u*v2_1_by_y + delay_tau_by_u_by_y*v2_1
    x2_1_on_boundary_by_w_by_y = delay_tau_by_w*v2_1_by_y + delay_tau_by_w_by_y*v2_1
    t334 = delay_tau_by_y*t73
    t335 = k1*x2_1_by_y
    t336 = t74*x1_1_by_y
    v1_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t76 + t334*t335 - t334*t336
    t337 = delay_tau_by_u*t73
    v1_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t76 + t335*t337 - t336*t337
    t338 = delay_tau_by_w*t73
    v1_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t76 + t335*t338 - t336*t338
    t339 = delay_tau_by_y*t77
    t340 = k1*x1_1_by_y
    t341 = t79*x2_1_by_y
    v2_1_on_boundary_by_y_by_y = delay_tau_by_y_by_y*t81 + t339*t340 - t339*t341
    t342 = delay_tau_by_u*t77
    v2_1_on_boundary_by_u_by_y = delay_tau_by_u_by_y*t81 + t340*t342 - t341*t342
    t343 = delay_tau_by_w*t77
    v2_1_on_boundary_by_w_by_y = delay_tau_by_w_by_y*t81 + t340*t343 - t341*t343
    # d/du of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_u = delay_tau_by_y*v1_1_by_u + delay_tau_by_y_by_u*v1_1
    x1_1_on_boundary_by_u_by_u = delay_tau_by_u*v1_1_by_u + delay_tau_by_u_by_u*v1_1
    x1_1_on_boundary_by_w_by_u = delay_tau_by_w*v1_1_by_u + delay_tau_by_w_by_u*v1_1
    x2_1_on_boundary_by_y_by_u = delay_tau_by_y*v2_1_by_u + delay_tau_by_y_by_u*v2_1
    x2_1_on_boundary_by_u_by_u = delay_tau_by_u*v2_1_by_u + delay_tau_by_u_by_u*v2_1
    x2_1_on_boundary_by_w_by_u = delay_tau_by_w*v2_1_by_u + delay_tau_by_w_by_u*v2_1
    t344 = k1*x2_1_by_u
    t345 = t74*x1_1_by_u
    v1_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t76 + t334*t344 - t334*t345
    v1_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t76 + t337*t344 - t337*t345
    v1_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t76 + t338*t344 - t338*t345
    t346 = k1*x1_1_by_u
    t347 = t79*x2_1_by_u
    v2_1_on_boundary_by_y_by_u = delay_tau_by_y_by_u*t81 + t339*t346 - t339*t347
    v2_1_on_boundary_by_u_by_u = delay_tau_by_u_by_u*t81 + t342*t346 - t342*t347
    v2_1_on_boundary_by_w_by_u = delay_tau_by_w_by_u*t81 + t343*t346 - t343*t347
    # d/dw of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_w = delay_tau_by_y*v1_1_by_w + delay_tau_by_y_by_w*v1_1
    x1_1_on_boundary_by_u_by_w = delay_tau_by_u*v1_1_by_w + delay_tau_by_u_by_w*v1_1
    x1_1_on_boundary_by_w_by_w = delay_tau_by_w*v1_1_by_w + delay_tau_by_w_by_w*v1_1
    x2_1_on_boundary_by_y_by_w = delay_tau_by_y*v2_1_by_w + delay_tau_by_y_by_w*v2_1
    x2_1_on_boundary_by_u_by_w = delay_tau_by_u*v2_1_by_w + delay_tau_by_u_by_w*v2_1
    x2_1_on_boundary_by_w_by_w = delay_tau_by_w*v2_1_by_w + delay_tau_by_w_by_w*v2_1
    t348 = k1*x2_1_by_w
    t349 = t74*x1_1_by_w
    v1_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t76 + t334*t348 - t334*t349
    v1_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t76 + t337*t348 - t337*t349
    v1_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t76 + t338*t348 - t338*t349
    t350 = k1*x1_1_by_w
    t351 = t79*x2_1_by_w
    v2_1_on_boundary_by_y_by_w = delay_tau_by_y_by_w*t81 + t339*t350 - t339*t351
    v2_1_on_boundary_by_u_by_w = delay_tau_by_u_by_w*t81 + t342*t350 - t342*t351
    v2_1_on_boundary_by_w_by_w = delay_tau_by_w_by_w*t81 + t343*t350 - t343*t351
    # d/dtau of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_tau = carried_x1_1_by_y_by_tau + delay_tau_by_y*v1_1_by_tau + delay_tau_by_y_by_tau*v1_1
    x1_1_on_boundary_by_u_by_tau = carried_x1_1_by_u_by_tau + delay_tau_by_u*v1_1_by_tau + delay_tau_by_u_by_tau*v1_1
    x1_1_on_boundary_by_w_by_tau = carried_x1_1_by_w_by_tau + delay_tau_by_w*v1_1_by_tau + delay_tau_by_w_by_tau*v1_1
    x2_1_on_boundary_by_y_by_tau = carried_x2_1_by_y_by_tau + delay_tau_by_y*v2_1_by_tau + delay_tau_by_y_by_tau*v2_1
    x2_1_on_boundary_by_u_by_tau = carried_x2_1_by_u_by_tau + delay_tau_by_u*v2_1_by_tau + delay_tau_by_u_by_tau*v2_1
    x2_1_on_boundary_by_w_by_tau = carried_x2_1_by_w_by_tau + delay_tau_by_w*v2_1_by_tau + delay_tau_by_w_by_tau*v2_1
    t352 = k1*x2_1_by_tau
    t353 = t74*x1_1_by_tau
    v1_1_on_boundary_by_y_by_tau = carried_v1_1_by_y_by_tau + delay_tau_by_y_by_tau*t76 + t334*t352 - t334*t353
    v1_1_on_boundary_by_u_by_tau = carried_v1_1_by_u_by_tau + delay_tau_by_u_by_tau*t76 + t337*t352 - t337*t353
    v1_1_on_boundary_by_w_by_tau = carried_v1_1_by_w_by_tau + delay_tau_by_w_by_tau*t76 + t338*t352 - t338*t353
    t354 = k1*x1_1_by_tau
    t355 = t79*x2_1_by_tau
    v2_1_on_boundary_by_y_by_tau = carried_v2_1_by_y_by_tau + delay_tau_by_y_by_tau*t81 + t339*t354 - t339*t355
    v2_1_on_boundary_by_u_by_tau = carried_v2_1_by_u_by_tau + delay_tau_by_u_by_tau*t81 + t342*t354 - t342*t355
    v2_1_on_boundary_by_w_by_tau = carried_v2_1_by_w_by_tau + delay_tau_by_w_by_tau*t81 + t343*t354 - t343*t355
    # d/dm1 of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_m1 = carried_x1_1_by_y_by_m1 + delay_tau_by_y*v1_1_by_m1 + delay_tau_by_y_by_m1*v1_1
    x1_1_on_boundary_by_u_by_m1 = carried_x1_1_by_u_by_m1 + delay_tau_by_u*v1_1_by_m1 + delay_tau_by_u_by_m1*v1_1
    x1_1_on_boundary_by_w_by_m1 = carried_x1_1_by_w_by_m1 + delay_tau_by_w*v1_1_by_m1 + delay_tau_by_w_by_m1*v1_1
    x2_1_on_boundary_by_y_by_m1 = carried_x2_1_by_y_by_m1 + delay_tau_by_y*v2_1_by_m1 + delay_tau_by_y_by_m1*v2_1
    x2_1_on_boundary_by_u_by_m1 = carried_x2_1_by_u_by_m1 + delay_tau_by_u*v2_1_by_m1 + delay_tau_by_u_by_m1*v2_1
    x2_1_on_boundary_by_w_by_m1 = carried_x2_1_by_w_by_m1 + delay_tau_by_w*v2_1_by_m1 + delay_tau_by_w_by_m1*v2_1
    t356 = 1/m1**2
    t357 = k1*t356
    t358 = -k3*t356 + t356*t74*x1_1 - t357*x2_1
    t359 = k1*x2_1_by_m1
    t360 = t74*x1_1_by_m1
    v1_1_on_boundary_by_y_by_m1 = carried_v1_1_by_y_by_m1 + delay_tau_by_y*t358 + delay_tau_by_y_by_m1*t76 + t334*t359 - t334*t360
    v1_1_on_boundary_by_u_by_m1 = carried_v1_1_by_u_by_m1 + delay_tau_by_u*t358 + delay_tau_by_u_by_m1*t76 + t337*t359 - t337*t360
    v1_1_on_boundary_by_w_by_m1 = carried_v1_1_by_w_by_m1 + delay_tau_by_w*t358 + delay_tau_by_w_by_m1*t76 + t338*t359 - t338*t360
    t361 = k1*x1_1_by_m1
    t362 = t79*x2_1_by_m1
    v2_1_on_boundary_by_y_by_m1 = carried_v2_1_by_y_by_m1 + delay_tau_by_y_by_m1*t81 + t339*t361 - t339*t362
    v2_1_on_boundary_by_u_by_m1 = carried_v2_1_by_u_by_m1 + delay_tau_by_u_by_m1*t81 + t342*t361 - t342*t362
    v2_1_on_boundary_by_w_by_m1 = carried_v2_1_by_w_by_m1 + delay_tau_by_w_by_m1*t81 + t343*t361 - t343*t362
    # d/dm2 of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_m2 = carried_x1_1_by_y_by_m2 + delay_tau_by_y*v1_1_by_m2 + delay_tau_by_y_by_m2*v1_1
    x1_1_on_boundary_by_u_by_m2 = carried_x1_1_by_u_by_m2 + delay_tau_by_u*v1_1_by_m2 + delay_tau_by_u_by_m2*v1_1
    x1_1_on_boundary_by_w_by_m2 = carried_x1_1_by_w_by_m2 + delay_tau_by_w*v1_1_by_m2 + delay_tau_by_w_by_m2*v1_1
    x2_1_on_boundary_by_y_by_m2 = carried_x2_1_by_y_by_m2 + delay_tau_by_y*v2_1_by_m2 + delay_tau_by_y_by_m2*v2_1
    x2_1_on_boundary_by_u_by_m2 = carried_x2_1_by_u_by_m2 + delay_tau_by_u*v2_1_by_m2 + delay_tau_by_u_by_m2*v2_1
    x2_1_on_boundary_by_w_by_m2 = carried_x2_1_by_w_by_m2 + delay_tau_by_w*v2_1_by_m2 + delay_tau_by_w_by_m2*v2_1
    t363 = k1*x2_1_by_m2
    t364 = t74*x1_1_by_m2
    v1_1_on_boundary_by_y_by_m2 = carried_v1_1_by_y_by_m2 + delay_tau_by_y_by_m2*t76 + t334*t363 - t334*t364
    v1_1_on_boundary_by_u_by_m2 = carried_v1_1_by_u_by_m2 + delay_tau_by_u_by_m2*t76 + t337*t363 - t337*t364
    v1_1_on_boundary_by_w_by_m2 = carried_v1_1_by_w_by_m2 + delay_tau_by_w_by_m2*t76 + t338*t363 - t338*t364
    t365 = 1/m2**2
    t366 = k1*t365
    t367 = t365*t79*x2_1 - t366*x1_1
    t368 = k1*x1_1_by_m2
    t369 = t79*x2_1_by_m2
    v2_1_on_boundary_by_y_by_m2 = carried_v2_1_by_y_by_m2 + delay_tau_by_y*t367 + delay_tau_by_y_by_m2*t81 + t339*t368 - t339*t369
    v2_1_on_boundary_by_u_by_m2 = carried_v2_1_by_u_by_m2 + delay_tau_by_u*t367 + delay_tau_by_u_by_m2*t81 + t342*t368 - t342*t369
    v2_1_on_boundary_by_w_by_m2 = carried_v2_1_by_w_by_m2 + delay_tau_by_w*t367 + delay_tau_by_w_by_m2*t81 + t343*t368 - t343*t369
    # d/dk1 of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_k1 = carried_x1_1_by_y_by_k1 + delay_tau_by_y*v1_1_by_k1 + delay_tau_by_y_by_k1*v1_1
    x1_1_on_boundary_by_u_by_k1 = carried_x1_1_by_u_by_k1 + delay_tau_by_u*v1_1_by_k1 + delay_tau_by_u_by_k1*v1_1
    x1_1_on_boundary_by_w_by_k1 = carried_x1_1_by_w_by_k1 + delay_tau_by_w*v1_1_by_k1 + delay_tau_by_w_by_k1*v1_1
    x2_1_on_boundary_by_y_by_k1 = carried_x2_1_by_y_by_k1 + delay_tau_by_y*v2_1_by_k1 + delay_tau_by_y_by_k1*v2_1
    x2_1_on_boundary_by_u_by_k1 = carried_x2_1_by_u_by_k1 + delay_tau_by_u*v2_1_by_k1 + delay_tau_by_u_by_k1*v2_1
    x2_1_on_boundary_by_w_by_k1 = carried_x2_1_by_w_by_k1 + delay_tau_by_w*v2_1_by_k1 + delay_tau_by_w_by_k1*v2_1
    t370 = t73*x2_1 - t75
    t371 = k1*x2_1_by_k1
    t372 = t74*x1_1_by_k1
    v1_1_on_boundary_by_y_by_k1 = carried_v1_1_by_y_by_k1 + delay_tau_by_y*t370 + delay_tau_by_y_by_k1*t76 + t334*t371 - t334*t372
    v1_1_on_boundary_by_u_by_k1 = carried_v1_1_by_u_by_k1 + delay_tau_by_u*t370 + delay_tau_by_u_by_k1*t76 + t337*t371 - t337*t372
    v1_1_on_boundary_by_w_by_k1 = carried_v1_1_by_w_by_k1 + delay_tau_by_w*t370 + delay_tau_by_w_by_k1*t76 + t338*t371 - t338*t372
    t373 = t78 - t80
    t374 = k1*x1_1_by_k1
    t375 = t79*x2_1_by_k1
    v2_1_on_boundary_by_y_by_k1 = carried_v2_1_by_y_by_k1 + delay_tau_by_y*t373 + delay_tau_by_y_by_k1*t81 + t339*t374 - t339*t375
    v2_1_on_boundary_by_u_by_k1 = carried_v2_1_by_u_by_k1 + delay_tau_by_u*t373 + delay_tau_by_u_by_k1*t81 + t342*t374 - t342*t375
    v2_1_on_boundary_by_w_by_k1 = carried_v2_1_by_w_by_k1 + delay_tau_by_w*t373 + delay_tau_by_w_by_k1*t81 + t343*t374 - t343*t375
    # d/dk2 of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_k2 = carried_x1_1_by_y_by_k2 + delay_tau_by_y*v1_1_by_k2 + delay_tau_by_y_by_k2*v1_1
    x1_1_on_boundary_by_u_by_k2 = carried_x1_1_by_u_by_k2 + delay_tau_by_u*v1_1_by_k2 + delay_tau_by_u_by_k2*v1_1
    x1_1_on_boundary_by_w_by_k2 = carried_x1_1_by_w_by_k2 + delay_tau_by_w*v1_1_by_k2 + delay_tau_by_w_by_k2*v1_1
    x2_1_on_boundary_by_y_by_k2 = carried_x2_1_by_y_by_k2 + delay_tau_by_y*v2_1_by_k2 + delay_tau_by_y_by_k2*v2_1
    x2_1_on_boundary_by_u_by_k2 = carried_x2_1_by_u_by_k2 + delay_tau_by_u*v2_1_by_k2 + delay_tau_by_u_by_k2*v2_1
    x2_1_on_boundary_by_w_by_k2 = carried_x2_1_by_w_by_k2 + delay_tau_by_w*v2_1_by_k2 + delay_tau_by_w_by_k2*v2_1
    t376 = k1*x2_1_by_k2
    t377 = t74*x1_1_by_k2
    v1_1_on_boundary_by_y_by_k2 = carried_v1_1_by_y_by_k2 + delay_tau_by_y_by_k2*t76 + t334*t376 - t334*t377
    v1_1_on_boundary_by_u_by_k2 = carried_v1_1_by_u_by_k2 + delay_tau_by_u_by_k2*t76 + t337*t376 - t337*t377
    v1_1_on_boundary_by_w_by_k2 = carried_v1_1_by_w_by_k2 + delay_tau_by_w_by_k2*t76 + t338*t376 - t338*t377
    t378 = k1*x1_1_by_k2
    t379 = t79*x2_1_by_k2
    v2_1_on_boundary_by_y_by_k2 = carried_v2_1_by_y_by_k2 - delay_tau_by_y*t80 + delay_tau_by_y_by_k2*t81 + t339*t378 - t339*t379
    v2_1_on_boundary_by_u_by_k2 = carried_v2_1_by_u_by_k2 - delay_tau_by_u*t80 + delay_tau_by_u_by_k2*t81 + t342*t378 - t342*t379
    v2_1_on_boundary_by_w_by_k2 = carried_v2_1_by_w_by_k2 - delay_tau_by_w*t80 + delay_tau_by_w_by_k2*t81 + t343*t378 - t343*t379
    # d/dk3 of: perturbation on the boundary after tau
    x1_1_on_boundary_by_y_by_k3 = carried_x1_1_by_y_by_k3 + delay_tau_by_y*v1_1_by_k3 + delay_tau_by_y_by_k3*v1_1
    x1_1_on_boundary_by_u_by_k3 = carried_x1_1_by_u_by_k3 + delay_tau_by_u*v1_1_by_k3 + delay_tau_by_u_by_k3*v1_1
    x1_1_on_boundary_by_w_by_k3 = carried_x1_1_by_w_by_k3 + delay_tau_by_w*v1_1_by_k3 + delay_tau_by_w_by_k3*v1_1
    x2_1_on_boundary_by_y_by_k3 = carried_x2_1_by_y_by_k3 + delay_tau_by_y*v2_1_by_k3 + delay_tau_by_y_by_k3*v2_1
    x2_1_on_boundary_by_u_by_k3 = carried_x2_1_by_u_by_k3 + delay_tau_by_u*v2_1_by_k3 + delay_tau_by_u_by_k3*v2_1
    x2_1_on_boundary_by_w_by_k3 = carried_x2_1_by_w_by_k3 + delay_tau_by_w*v2_1_by_k3 + delay_tau_by_w_by_k3*v2_1
    t380 = t73 - t75
    t381 = k1*x2_1_by_k3
    t382 = t74*x1_1_by_k3
    v1_1_on_boundary_by_y_by_k3 = carried_v1_1_by_y_by_k3 + delay_tau_by_y*t380 + delay_tau_by_y_by_k3*t76 + t334*t381 - t334*t382
    v1_1_on_boundary_by_u_by_k3 = carried_v1_1_by_u_by_k3 + delay_tau_by_u*t380 + delay_tau_by_u_by_k3*t76 + t337*t381 - t337*t382
    v1_1_on_boundary_by_w_by_k3 = carried_v1_1_by_w_by_k3 + delay_tau_by_w*t380 + delay_tau_by_w_by_k3*t76 + t338*t381 - t338*t382
    t383 = k1*x1_1_by_k3
    t384 = t79*x2_1_by_k3
    v2_1_on_boundary_by_y_by_k3 = carried_v2_1_by_y_by_k3 + delay_tau_by_y_by_k3*t81 + t339*t383 - t339*t384
    v2_1_on_boundary_by_u_by_k3 = carried_v2_1_by_u_by_k3 + delay_tau_by_u_by_k3*t81 + t342*t383 - t342*t384
    v2_1_on_boundary_by_w_by_k3 = carried_v2_1_by_w_by_k3 + delay_tau_by_w_by_k3*t81 + t343*t383 - t343*t384
    # d/dy of: Phi along tau1
    carried_x1_2_by_y_by_y = t58*v1_1_on_boundary_by_y_by_y + t59*v2_1_on_boundary_by_y_by_y + t60*x1_1_on_boundary_by_y_by_y + t61*x2_1_on_boundary_by_y_by_y
    carried_x1_2_by_u_by_y = t58*v1_1_on_boundary_by_u_by_y + t59*v2_1_on_boundary_by_u_by_y + t60*x1_1_on_boundary_by_u_by_y + t61*x2_1_on_boundary_by_u_by_y
    carried_x1_2_by_w_by_y = t58*v1_1_on_boundary_by_w_by_y + t59*v2_1_on_boundary_by_w_by_y + t60*x1_1_on_boundary_by_w_by_y + t61*x2_1_on_boundary_by_w_by_y
    carried_x2_2_by_y_by_y = t62*v1_1_on_boundary_by_y_by_y + t63*v2_1_on_boundary_by_y_by_y + t64*x1_1_on_boundary_by_y_by_y + t65*x2_1_on_boundary_by_y_by_y
    carried_v1_2_by_u_by_y = t60*v1_1_on_boundary_by_u_by_y + t61*v2_1_on_boundary_by_u_by_y + t68*x1_1_on_boundary_by_u_by_y + t69*x2_1_on_boundary_by_u_by_y
    carried_v2_2_by_w_by_y = t64*v1_1_on_boundary_by_w_by_y + t65*v2_1_on_boundary_by_w_by_y + t70*x1_1_on_boundary_by_w_by_y + t71*x2_1_on_boundary_by_w_by_y
    # d/du of: Phi along tau1
    carried_x1_2_by_y_by_u = t58*v1_1_on_boundary_by_y_by_u + t59*v2_1_on_boundary_by_y_by_u + t60*x1_1_on_boundary_by_y_by_u + t61*x2_1_on_boundary_by_y_by_u
    carried_x1_2_by_u_by_u = t58*v1_1_on_boundary_by_u_by_u + t59*v2_1_on_boundary_by_u_by_u + t60*x1_1_on_boundary_by_u_by_u + t61*x2_1_on_boundary_by_u_by_u
    carried_x1_2_by_w_by_u = t58*v1_1_on_boundary_by_w_by_u + t59*v2_1_on_boundary_by_w_by_u + t60*x1_1_on_boundary_by_w_by_u + t61*x2_1_on_boundary_by_w_by_u
    carried_x2_2_by_y_by_u = t62*v1_1_on_boundary_by_y_by_u + t63*v2_1_on_boundary_by_y_by_u + t64*x1_1_on_boundary_by_y_by_u + t65*x2_1_on_boundary_by_y_by_u
    carried_v1_2_by_u_by_u = t60*v1_1_on_boundary_by_u_by_u + t61*v2_1_on_boundary_by_u_by_u + t68*x1_1_on_boundary_by_u_by_u + t69*x2_1_on_boundary_by_u_by_u
    carried_v2_2_by_w_by_u = t64*v1_1_on_boundary_by_w_by_u + t65*v2_1_on_boundary_by_w_by_u + t70*x1_1_on_boundary_by_w_by_u + t71*x2_1_on_boundary_by_w_by_u
    # d/dw of: Phi along tau1
    carried_x1_2_by_y_by_w = t58*v1_1_on_boundary_by_y_by_w + t59*v2_1_on_boundary_by_y_by_w + t60*x1_1_on_boundary_by_y_by_w + t61*x2_1_on_boundary_by_y_by_w
    carried_x1_2_by_u_by_w = t58*v1_1_on_boundary_by_u_by_w + t59*v2_1_on_boundary_by_u_by_w + t60*x1_1_on_boundary_by_u_by_w + t61*x2_1_on_boundary_by_u_by_w
    carried_x1_2_by_w_by_w = t58*v1_1_on_boundary_by_w_by_w + t59*v2_1_on_boundary_by_w_by_w + t60*x1_1_on_boundary_by_w_by_w + t61*x2_1_on_boundary_by_w_by_w
    carried_x2_2_by_y_by_w = t62*v1_1_on_boundary_by_y_by_w + t63*v2_1_on_boundary_by_y_by_w + t64*x1_1_on_boundary_by_y_by_w + t65*x2_1_on_boundary_by_y_by_w
    carried_v1_2_by_u_by_w = t60*v1_1_on_boundary_by_u_by_w + t61*v2_1_on_boundary_by_u_by_w + t68*x1_1_on_boundary_by_u_by_w + t69*x2_1_on_boundary_by_u_by_w
    carried_v2_2_by_w_by_w = t64*v1_1_on_boundary_by_w_by_w + t65*v2_1_on_boundary_by_w_by_w + t70*x1_1_on_boundary_by_w_by_w + t71*x2_1_on_boundary_by_w_by_w
    # d/dtau of: Phi along tau1
    t385 = p5*x2_1_on_boundary_by_y
    t386 = p4*x1_1_on_boundary_by_y + t385
    t387 = -t385 + t55*x1_1_on_boundary_by_y
    t388 = p4*t53
    t389 = p5*v2_1_on_boundary_by_y
    t390 = t388*v1_1_on_boundary_by_y + t389*t53
    t391 = -t389*t56 + t55*t56*v1_1_on_boundary_by_y
    carried_x1_2_by_y_by_tau = cos_omega3_tau1_by_tau*t386 + cos_omega4_tau1_by_tau*t387 + sin_omega3_tau1_by_tau*t390 + sin_omega4_tau1_by_tau*t391 + t58*v1_1_on_boundary_by_y_by_tau + t59*v2_1_on_boundary_by_y_by_tau + t60*x1_1_on_boundary_by_y_by_tau + t61*x2_1_on_boundary_by_y_by_tau
    t392 = p4*x1_1_on_boundary_by_u
    t393 = p5*x2_1_on_boundary_by_u
    t394 = t392 + t393
    t395 = -t393 + t55*x1_1_on_boundary_by_u
    t396 = p4*v1_1_on_boundary_by_u
    t397 = p5*v2_1_on_boundary_by_u
    t398 = t396*t53 + t397*t53
    t399 = -t397*t56 + t55*t56*v1_1_on_boundary_by_u
    carried_x1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t394 + cos_omega4_tau1_by_tau*t395 + sin_omega3_tau1_by_tau*t398 + sin_omega4_tau1_by_tau*t399 + t58*v1_1_on_boundary_by_u_by_tau + t59*v2_1_on_boundary_by_u_by_tau + t60*x1_1_on_boundary_by_u_by_tau + t61*x2_1_on_boundary_by_u_by_tau
    t400 = p5*x2_1_on_boundary_by_w
    t401 = p4*x1_1_on_boundary_by_w + t400
    t402 = -t400 + t55*x1_1_on_boundary_by_w
    t403 = p5*v2_1_on_boundary_by_w
    t404 = t388*v1_1_on_boundary_by_w + t403*t53
    t405 = -t403*t56 + t55*t56*v1_1_on_boundary_by_w
    carried_x1_2_by_w_by_tau = cos_omega3_tau1_by_tau*t401 + cos_omega4_tau1_by_tau*t402 + sin_omega3_tau1_by_tau*t404 + sin_omega4_tau1_by_tau*t405 + t58*v1_1_on_boundary_by_w_by_tau + t59*v2_1_on_boundary_by_w_by_tau + t60*x1_1_on_boundary_by_w_by_tau + t61*x2_1_on_boundary_by_w_by_tau
    t406 = p6*x1_1_on_boundary_by_y
    t407 = t406 + t55*x2_1_on_boundary_by_y
    t408 = p4*x2_1_on_boundary_by_y - t406
    t409 = p6*v1_1_on_boundary_by_y
    t410 = t55*v2_1_on_boundary_by_y
    t411 = t409*t53 + t410*t53
    t412 = p4*v2_1_on_boundary_by_y
    t413 = -t409*t56 + t412*t56
    carried_x2_2_by_y_by_tau = cos_omega3_tau1_by_tau*t407 + cos_omega4_tau1_by_tau*t408 + sin_omega3_tau1_by_tau*t411 + sin_omega4_tau1_by_tau*t413 + t62*v1_1_on_boundary_by_y_by_tau + t63*v2_1_on_boundary_by_y_by_tau + t64*x1_1_on_boundary_by_y_by_tau + t65*x2_1_on_boundary_by_y_by_tau
    t414 = t396 + t397
    t415 = -t397 + t55*v1_1_on_boundary_by_u
    t416 = -omega3*t392 - omega3*t393
    t417 = t55*x1_1_on_boundary_by_u
    t418 = omega4*t393 - omega4*t417
    carried_v1_2_by_u_by_tau = cos_omega3_tau1_by_tau*t414 + cos_omega4_tau1_by_tau*t415 + sin_omega3_tau1_by_tau*t416 + sin_omega4_tau1_by_tau*t418 + t60*v1_1_on_boundary_by_u_by_tau + t61*v2_1_on_boundary_by_u_by_tau + t68*x1_1_on_boundary_by_u_by_tau + t69*x2_1_on_boundary_by_u_by_tau
    t419 = p6*v1_1_on_boundary_by_w
    t420 = t419 + t55*v2_1_on_boundary_by_w
    t421 = p4*v2_1_on_boundary_by_w - t419
    t422 = p6*x1_1_on_boundary_by_w
    t423 = t55*x2_1_on_boundary_by_w
    t424 = -omega3*t422 - omega3*t423
    t425 = p4*x2_1_on_boundary_by_w
    t426 = omega4*p6*x1_1_on_boundary_by_w - omega4*t425
    carried_v2_2_by_w_by_tau = cos_omega3_tau1_by_tau*t420 + cos_omega4_tau1_by_tau*t421 + sin_omega3_tau1_by_tau*t424 + sin_omega4_tau1_by_tau*t426 + t64*v1_1_on_boundary_by_w_by_tau + t65*v2_1_on_boundary_by_w_by_tau + t70*x1_1_on_boundary_by_w_by_tau + t71*x2_1_on_boundary_by_w_by_tau
    # d/dm1 of: Phi along tau1
    t427 = p4*t226
    t428 = -t226*t389 - t427*v1_1_on_boundary_by_y
    t429 = t229*t55
    t430 = t229*t389 - t429*v1_1_on_boundary_by_y
    t431 = -t231*v1_1_on_boundary_by_y + t233*x1_1_on_boundary_by_y
    t432 = -t231*v2_1_on_boundary_by_y + t233*x2_1_on_boundary_by_y
    carried_x1_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t386 + cos_omega4_tau1_by_m1*t387 + omega3_by_m1*t428 + omega4_by_m1*t430 + p4_by_m1*t431 + p5_by_m1*t432 + sin_omega3_tau1_by_m1*t390 + sin_omega4_tau1_by_m1*t391 + t58*v1_1_on_boundary_by_y_by_m1 + t59*v2_1_on_boundary_by_y_by_m1 + t60*x1_1_on_boundary_by_y_by_m1 + t61*x2_1_on_boundary_by_y_by_m1
    t433 = -t226*t396 - t226*t397
    t434 = t229*t397 - t229*t55*v1_1_on_boundary_by_u
    t435 = -t231*v1_1_on_boundary_by_u + t233*x1_1_on_boundary_by_u
    t436 = -t231*v2_1_on_boundary_by_u + t233*x2_1_on_boundary_by_u
    carried_x1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t394 + cos_omega4_tau1_by_m1*t395 + omega3_by_m1*t433 + omega4_by_m1*t434 + p4_by_m1*t435 + p5_by_m1*t436 + sin_omega3_tau1_by_m1*t398 + sin_omega4_tau1_by_m1*t399 + t58*v1_1_on_boundary_by_u_by_m1 + t59*v2_1_on_boundary_by_u_by_m1 + t60*x1_1_on_boundary_by_u_by_m1 + t61*x2_1_on_boundary_by_u_by_m1
    t437 = -t226*t403 - t427*v1_1_on_boundary_by_w
    t438 = t229*t403 - t429*v1_1_on_boundary_by_w
    t439 = -t231*v1_1_on_boundary_by_w + t233*x1_1_on_boundary_by_w
    t440 = -t231*v2_1_on_boundary_by_w + t233*x2_1_on_boundary_by_w
    carried_x1_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t401 + cos_omega4_tau1_by_m1*t402 + omega3_by_m1*t437 + omega4_by_m1*t438 + p4_by_m1*t439 + p5_by_m1*t440 + sin_omega3_tau1_by_m1*t404 + sin_omega4_tau1_by_m1*t405 + t58*v1_1_on_boundary_by_w_by_m1 + t59*v2_1_on_boundary_by_w_by_m1 + t60*x1_1_on_boundary_by_w_by_m1 + t61*x2_1_on_boundary_by_w_by_m1
    t441 = -t226*t409 - t226*t410
    t442 = p6*sin_omega4_tau1*t228*v1_1_on_boundary_by_y - t229*t412
    t443 = t231*v2_1_on_boundary_by_y - t233*x2_1_on_boundary_by_y
    carried_x2_2_by_y_by_m1 = cos_omega3_tau1_by_m1*t407 + cos_omega4_tau1_by_m1*t408 + omega3_by_m1*t441 + omega4_by_m1*t442 + p4_by_m1*t443 + p6_by_m1*t431 + sin_omega3_tau1_by_m1*t411 + sin_omega4_tau1_by_m1*t413 + t62*v1_1_on_boundary_by_y_by_m1 + t63*v2_1_on_boundary_by_y_by_m1 + t64*x1_1_on_boundary_by_y_by_m1 + t65*x2_1_on_boundary_by_y_by_m1
    t444 = -sin_omega3_tau1*t392 - sin_omega3_tau1*t393
    t445 = sin_omega4_tau1*t393 - sin_omega4_tau1*t417
    t446 = t233*v1_1_on_boundary_by_u - t242*x1_1_on_boundary_by_u
    t447 = t233*v2_1_on_boundary_by_u - t242*x2_1_on_boundary_by_u
    carried_v1_2_by_u_by_m1 = cos_omega3_tau1_by_m1*t414 + cos_omega4_tau1_by_m1*t415 + omega3_by_m1*t444 + omega4_by_m1*t445 + p4_by_m1*t446 + p5_by_m1*t447 + sin_omega3_tau1_by_m1*t416 + sin_omega4_tau1_by_m1*t418 + t60*v1_1_on_boundary_by_u_by_m1 + t61*v2_1_on_boundary_by_u_by_m1 + t68*x1_1_on_boundary_by_u_by_m1 + t69*x2_1_on_boundary_by_u_by_m1
    t448 = -sin_omega3_tau1*t422 - sin_omega3_tau1*t423
    t449 = p6*sin_omega4_tau1*x1_1_on_boundary_by_w - sin_omega4_tau1*t425
    t450 = -t233*v2_1_on_boundary_by_w + t242*x2_1_on_boundary_by_w
    t451 = t233*v1_1_on_boundary_by_w - t242*x1_1_on_boundary_by_w
    carried_v2_2_by_w_by_m1 = cos_omega3_tau1_by_m1*t420 + cos_omega4_tau1_by_m1*t421 + omega3_by_m1*t448 + omega4_by_m1*t449 + p4_by_m1*t450 + p6_by_m1*t451 + sin_omega3_tau1_by_m1*t424 + sin_omega4_tau1_by_m1*t426 + t64*v1_1_on_boundary_by_w_by_m1 + t65*v2_1_on_boundary_by_w_by_m1 + t70*x1_1_on_boundary_by_w_by_m1 + t71*x2_1_on_boundary_by_w_by_m1
    # d/dm2 of: Phi along tau1
    carried_x1_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t386 + cos_omega4_tau1_by_m2*t387 + omega3_by_m2*t428 + omega4_by_m2*t430 + p4_by_m2*t431 + p5_by_m2*t432 + sin_omega3_tau1_by_m2*t390 + sin_omega4_tau1_by_m2*t391 + t58*v1_1_on_boundary_by_y_by_m2 + t59*v2_1_on_boundary_by_y_by_m2 + t60*x1_1_on_boundary_by_y_by_m2 + t61*x2_1_on_boundary_by_y_by_m2
    carried_x1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t394 + cos_omega4_tau1_by_m2*t395 + omega3_by_m2*t433 + omega4_by_m2*t434 + p4_by_m2*t435 + p5_by_m2*t436 + sin_omega3_tau1_by_m2*t398 + sin_omega4_tau1_by_m2*t399 + t58*v1_1_on_boundary_by_u_by_m2 + t59*v2_1_on_boundary_by_u_by_m2 + t60*x1_1_on_boundary_by_u_by_m2 + t61*x2_1_on_boundary_by_u_by_m2
    carried_x1_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t401 + cos_omega4_tau1_by_m2*t402 + omega3_by_m2*t437 + omega4_by_m2*t438 + p4_by_m2*t439 + p5_by_m2*t440 + sin_omega3_tau1_by_m2*t404 + sin_omega4_tau1_by_m2*t405 + t58*v1_1_on_boundary_by_w_by_m2 + t59*v2_1_on_boundary_by_w_by_m2 + t60*x1_1_on_boundary_by_w_by_m2 + t61*x2_1_on_boundary_by_w_by_m2
    carried_x2_2_by_y_by_m2 = cos_omega3_tau1_by_m2*t407 + cos_omega4_tau1_by_m2*t408 + omega3_by_m2*t441 + omega4_by_m2*t442 + p4_by_m2*t443 + p6_by_m2*t431 + sin_omega3_tau1_by_m2*t411 + sin_omega4_tau1_by_m2*t413 + t62*v1_1_on_boundary_by_y_by_m2 + t63*v2_1_on_boundary_by_y_by_m2 + t64*x1_1_on_boundary_by_y_by_m2 + t65*x2_1_on_boundary_by_y_by_m2
    carried_v1_2_by_u_by_m2 = cos_omega3_tau1_by_m2*t414 + cos_omega4_tau1_by_m2*t415 + omega3_by_m2*t444 + omega4_by_m2*t445 + p4_by_m2*t446 + p5_by_m2*t447 + sin_omega3_tau1_by_m2*t416 + sin_omega4_tau1_by_m2*t418 + t60*v1_1_on_boundary_by_u_by_m2 + t61*v2_1_on_boundary_by_u_by_m2 + t68*x1_1_on_boundary_by_u_by_m2 + t69*x2_1_on_boundary_by_u_by_m2
    carried_v2_2_by_w_by_m2 = cos_omega3_tau1_by_m2*t420 + cos_omega4_tau1_by_m2*t421 + omega3_by_m2*t448 + omega4_by_m2*t449 + p4_by_m2*t450 + p6_by_m2*t451 + sin_omega3_tau1_by_m2*t424 + sin_omega4_tau1_by_m2*t426 + t64*v1_1_on_boundary_by_w_by_m2 + t65*v2_1_on_boundary_by_w_by_m2 + t70*x1_1_on_boundary_by_w_by_m2 + t71*x2_1_on_boundary_by_w_by_m2
    # d/dk1 of: Phi along tau1
    carried_x1_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t386 + cos_omega4_tau1_by_k1*t387 + omega3_by_k1*t428 + omega4_by_k1*t430 + p4_by_k1*t431 + p5_by_k1*t432 + sin_omega3_tau1_by_k1*t390 + sin_omega4_tau1_by_k1*t391 + t58*v1_1_on_boundary_by_y_by_k1 + t59*v2_1_on_boundary_by_y_by_k1 + t60*x1_1_on_boundary_by_y_by_k1 + t61*x2_1_on_boundary_by_y_by_k1
    carried_x1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t394 + cos_omega4_tau1_by_k1*t395 + omega3_by_k1*t433 + omega4_by_k1*t434 + p4_by_k1*t435 + p5_by_k1*t436 + sin_omega3_tau1_by_k1*t398 + sin_omega4_tau1_by_k1*t399 + t58*v1_1_on_boundary_by_u_by_k1 + t59*v2_1_on_boundary_by_u_by_k1 + t60*x1_1_on_boundary_by_u_by_k1 + t61*x2_1_on_boundary_by_u_by_k1
    carried_x1_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t401 + cos_omega4_tau1_by_k1*t402 + omega3_by_k1*t437 + omega4_by_k1*t438 + p4_by_k1*t439 + p5_by_k1*t440 + sin_omega3_tau1_by_k1*t404 + sin_omega4_tau1_by_k1*t405 + t58*v1_1_on_boundary_by_w_by_k1 + t59*v2_1_on_boundary_by_w_by_k1 + t60*x1_1_on_boundary_by_w_by_k1 + t61*x2_1_on_boundary_by_w_by_k1
    carried_x2_2_by_y_by_k1 = cos_omega3_tau1_by_k1*t407 + cos_omega4_tau1_by_k1*t408 + omega3_by_k1*t441 + omega4_by_k1*t442 + p4_by_k1*t443 + p6_by_k1*t431 + sin_omega3_tau1_by_k1*t411 + sin_omega4_tau1_by_k1*t413 + t62*v1_1_on_boundary_by_y_by_k1 + t63*v2_1_on_boundary_by_y_by_k1 + t64*x1_1_on_boundary_by_y_by_k1 + t65*x2_1_on_boundary_by_y_by_k1
    carried_v1_2_by_u_by_k1 = cos_omega3_tau1_by_k1*t414 + cos_omega4_tau1_by_k1*t415 + omega3_by_k1*t444 + omega4_by_k1*t445 + p4_by_k1*t446 + p5_by_k1*t447 + sin_omega3_tau1_by_k1*t416 + sin_omega4_tau1_by_k1*t418 + t60*v1_1_on_boundary_by_u_by_k1 + t61*v2_1_on_boundary_by_u_by_k1 + t68*x1_1_on_boundary_by_u_by_k1 + t69*x2_1_on_boundary_by_u_by_k1
    carried_v2_2_by_w_by_k1 = cos_omega3_tau1_by_k1*t420 + cos_omega4_tau1_by_k1*t421 + omega3_by_k1*t448 + omega4_by_k1*t449 + p4_by_k1*t450 + p6_by_k1*t451 + sin_omega3_tau1_by_k1*t424 + sin_omega4_tau1_by_k1*t426 + t64*v1_1_on_boundary_by_w_by_k1 + t65*v2_1_on_boundary_by_w_by_k1 + t70*x1_1_on_boundary_by_w_by_k1 + t71*x2_1_on_boundary_by_w_by_k1
    # d/dk2 of: Phi along tau1
    carried_x1_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t386 + cos_omega4_tau1_by_k2*t387 + omega3_by_k2*t428 + omega4_by_k2*t430 + p4_by_k2*t431 + p5_by_k2*t432 + sin_omega3_tau1_by_k2*t390 + sin_omega4_tau1_by_k2*t391 + t58*v1_1_on_boundary_by_y_by_k2 + t59*v2_1_on_boundary_by_y_by_k2 + t60*x1_1_on_boundary_by_y_by_k2 + t61*x2_1_on_boundary_by_y_by_k2
    carried_x1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t394 + cos_omega4_tau1_by_k2*t395 + omega3_by_k2*t433 + omega4_by_k2*t434 + p4_by_k2*t435 + p5_by_k2*t436 + sin_omega3_tau1_by_k2*t398 + sin_omega4_tau1_by_k2*t399 + t58*v1_1_on_boundary_by_u_by_k2 + t59*v2_1_on_boundary_by_u_by_k2 + t60*x1_1_on_boundary_by_u_by_k2 + t61*x2_1_on_boundary_by_u_by_k2
    carried_x1_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t401 + cos_omega4_tau1_by_k2*t402 + omega3_by_k2*t437 + omega4_by_k2*t438 + p4_by_k2*t439 + p5_by_k2*t440 + sin_omega3_tau1_by_k2*t404 + sin_omega4_tau1_by_k2*t405 + t58*v1_1_on_boundary_by_w_by_k2 + t59*v2_1_on_boundary_by_w_by_k2 + t60*x1_1_on_boundary_by_w_by_k2 + t61*x2_1_on_boundary_by_w_by_k2
    carried_x2_2_by_y_by_k2 = cos_omega3_tau1_by_k2*t407 + cos_omega4_tau1_by_k2*t408 + omega3_by_k2*t441 + omega4_by_k2*t442 + p4_by_k2*t443 + p6_by_k2*t431 + sin_omega3_tau1_by_k2*t411 + sin_omega4_tau1_by_k2*t413 + t62*v1_1_on_boundary_by_y_by_k2 + t63*v2_1_on_boundary_by_y_by_k2 + t64*x1_1_on_boundary_by_y_by_k2 + t65*x2_1_on_boundary_by_y_by_k2
    carried_v1_2_by_u_by_k2 = cos_omega3_tau1_by_k2*t414 + cos_omega4_tau1_by_k2*t415 + omega3_by_k2*t444 + omega4_by_k2*t445 + p4_by_k2*t446 + p5_by_k2*t447 + sin_omega3_tau1_by_k2*t416 + sin_omega4_tau1_by_k2*t418 + t60*v1_1_on_boundary_by_u_by_k2 + t61*v2_1_on_boundary_by_u_by_k2 + t68*x1_1_on_boundary_by_u_by_k2 + t69*x2_1_on_boundary_by_u_by_k2
    carried_v2_2_by_w_by_k2 = cos_omega3_tau1_by_k2*t420 + cos_omega4_tau1_by_k2*t421 + omega3_by_k2*t448 + omega4_by_k2*t449 + p4_by_k2*t450 + p6_by_k2*t451 + sin_omega3_tau1_by_k2*t424 + sin_omega4_tau1_by_k2*t426 + t64*v1_1_on_boundary_by_w_by_k2 + t65*v2_1_on_boundary_by_w_by_k2 + t70*x1_1_on_boundary_by_w_by_k2 + t71*x2_1_on_boundary_by_w_by_k2
    # d/dk3 of: Phi along tau1
    carried_x1_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t386 + cos_omega4_tau1_by_k3*t387 + omega3_by_k3*t428 + omega4_by_k3*t430 + p4_by_k3*t431 + p5_by_k3*t432 + sin_omega3_tau1_by_k3*t390 + sin_omega4_tau1_by_k3*t391 + t58*v1_1_on_boundary_by_y_by_k3 + t59*v2_1_on_boundary_by_y_by_k3 + t60*x1_1_on_boundary_by_y_by_k3 + t61*x2_1_on_boundary_by_y_by_k3
    carried_x1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t394 + cos_omega4_tau1_by_k3*t395 + omega3_by_k3*t433 + omega4_by_k3*t434 + p4_by_k3*t435 + p5_by_k3*t436 + sin_omega3_tau1_by_k3*t398 + sin_omega4_tau1_by_k3*t399 + t58*v1_1_on_boundary_by_u_by_k3 + t59*v2_1_on_boundary_by_u_by_k3 + t60*x1_1_on_boundary_by_u_by_k3 + t61*x2_1_on_boundary_by_u_by_k3
    carried_x1_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t401 + cos_omega4_tau1_by_k3*t402 + omega3_by_k3*t437 + omega4_by_k3*t438 + p4_by_k3*t439 + p5_by_k3*t440 + sin_omega3_tau1_by_k3*t404 + sin_omega4_tau1_by_k3*t405 + t58*v1_1_on_boundary_by_w_by_k3 + t59*v2_1_on_boundary_by_w_by_k3 + t60*x1_1_on_boundary_by_w_by_k3 + t61*x2_1_on_boundary_by_w_by_k3
    carried_x2_2_by_y_by_k3 = cos_omega3_tau1_by_k3*t407 + cos_omega4_tau1_by_k3*t408 + omega3_by_k3*t441 + omega4_by_k3*t442 + p4_by_k3*t443 + p6_by_k3*t431 + sin_omega3_tau1_by_k3*t411 + sin_omega4_tau1_by_k3*t413 + t62*v1_1_on_boundary_by_y_by_k3 + t63*v2_1_on_boundary_by_y_by_k3 + t64*x1_1_on_boundary_by_y_by_k3 + t65*x2_1_on_boundary_by_y_by_k3
    carried_v1_2_by_u_by_k3 = cos_omega3_tau1_by_k3*t414 + cos_omega4_tau1_by_k3*t415 + omega3_by_k3*t444 + omega4_by_k3*t445 + p4_by_k3*t446 + p5_by_k3*t447 + sin_omega3_tau1_by_k3*t416 + sin_omega4_tau1_by_k3*t418 + t60*v1_1_on_boundary_by_u_by_k3 + t61*v2_1_on_boundary_by_u_by_k3 + t68*x1_1_on_boundary_by_u_by_k3 + t69*x2_1_on_boundary_by_u_by_k3
    carried_v2_2_by_w_by_k3 = cos_omega3_tau1_by_k3*t420 + cos_omega4_tau1_by_k3*t421 + omega3_by_k3*t448 + omega4_by_k3*t449 + p4_by_k3*t450 + p6_by_k3*t451 + sin_omega3_tau1_by_k3*t424 + sin_omega4_tau1_by_k3*t426 + t64*v1_1_on_boundary_by_w_by_k3 + t65*v2_1_on_boundary_by_w_by_k3 + t70*x1_1_on_boundary_by_w_by_k3 + t71*x2_1_on_boundary_by_w_by_k3
    # d/dT of: Phi along tau1
    carried_x1_2_by_y_by_T = cos_omega3_tau1_by_T*t386 + cos_omega4_tau1_by_T*t387 + sin_omega3_tau1_by_T*t390 + sin_omega4_tau1_by_T*t391
    carried_x1_2_by_u_by_T = cos_omega3_tau1_by_T*t394 + cos_omega4_tau1_by_T*t395 + sin_omega3_tau1_by_T*t398 + sin_omega4_tau1_by_T*t399
    carried_x1_2_by_w_by_T = cos_omega3_tau1_by_T*t401 + cos_omega4_tau1_by_T*t402 + sin_omega3_tau1_by_T*t404 + sin_omega4_tau1_by_T*t405
    carried_x2_2_by_y_by_T = cos_omega3_tau1_by_T*t407 + cos_omega4_tau1_by_T*t408 + sin_omega3_tau1_by_T*t411 + sin_omega4_tau1_by_T*t413
    carried_v1_2_by_u_by_T = cos_omega3_tau1_by_T*t414 + cos_omega4_tau1_by_T*t415 + sin_omega3_tau1_by_T*t416 + sin_omega4_tau1_by_T*t418
    carried_v2_2_by_w_by_T = cos_omega3_tau1_by_T*t420 + cos_omega4_tau1_by_T*t421 + sin_omega3_tau1_by_T*t424 + sin_omega4_tau1_by_T*t426
    # d/dy of: derivatives of the time to the boundary after tau1
    t452 = 1/v1_2**2
    t453 = t452*v1_2_by_y
    delay_tau1_by_y_by_y = carried_x1_2_by_y*t453 - carried_x1_2_by_y_by_y*t82
    delay_tau1_by_u_by_y = carried_x1_2_by_u*t453 - carried_x1_2_by_u_by_y*t82
    delay_tau1_by_w_by_y = carried_x1_2_by_w*t453 - carried_x1_2_by_w_by_y*t82
    # d/du of: derivatives of the time to the boundary after tau1
    t454 = t452*v1_2_by_u
    delay_tau1_by_y_by_u = carried_x1_2_by_y*t454 - carried_x1_2_by_y_by_u*t82
    delay_tau1_by_u_by_u = carried_x1_2_by_u*t454 - carried_x1_2_by_u_by_u*t82
    delay_tau1_by_w_by_u = carried_x1_2_by_w*t454 - carried_x1_2_by_w_by_u*t82
    # d/dw of: derivatives of the time to the boundary after tau1
    t455 = t452*v1_2_by_w
    delay_tau1_by_y_by_w = carried_x1_2_by_y*t455 - carried_x1_2_by_y_by_w*t82
    delay_tau1_by_u_by_w = carried_x1_2_by_u*t455 - carried_x1_2_by_u_by_w*t82
    delay_tau1_by_w_by_w = carried_x1_2_by_w*t455 - carried_x1_2_by_w_by_w*t82
    # d/dtau of: derivatives of the time to the boundary after tau1
    t456 = t452*v1_2_by_tau
    delay_tau1_by_y_by_tau = carried_x1_2_by_y*t456 - carried_x1_2_by_y_by_tau*t82
    delay_tau1_by_u_by_tau = carried_x1_2_by_u*t456 - carried_x1_2_by_u_by_tau*t82
    delay_tau1_by_w_by_tau = carried_x1_2_by_w*t456 - carried_x1_2_by_w_by_tau*t82
    # d/dm1 of: derivatives of the time to the boundary after tau1
    t457 = t452*v1_2_by_m1
    delay_tau1_by_y_by_m1 = carried_x1_2_by_y*t457 - carried_x1_2_by_y_by_m1*t82
    delay_tau1_by_u_by_m1 = carried_x1_2_by_u*t457 - carried_x1_2_by_u_by_m1*t82
    delay_tau1_by_w_by_m1 = carried_x1_2_by_w*t457 - carried_x1_2_by_w_by_m1*t82
    # d/dm2 of: derivatives of the time to the boundary after tau1
    t458 = t452*v1_2_by_m2
    delay_tau1_by_y_by_m2 = carried_x1_2_by_y*t458 - carried_x1_2_by_y_by_m2*t82
    delay_tau1_by_u_by_m2 = carried_x1_2_by_u*t458 - carried_x1_2_by_u_by_m2*t82
    delay_tau1_by_w_by_m2 = carried_x1_2_by_w*t458 - carried_x1_2_by_w_by_m2*t82
    # d/dk1 of: derivatives of the time to the boundary after tau1
    t459 = t452*v1_2_by_k1
    delay_tau1_by_y_by_k1 = carried_x1_2_by_y*t459 - carried_x1_2_by_y_by_k1*t82
    delay_tau1_by_u_by_k1 = carried_x1_2_by_u*t459 - carried_x1_2_by_u_by_k1*t82
    delay_tau1_by_w_by_k1 = carried_x1_2_by_w*t459 - carried_x1_2_by_w_by_k1*t82
    # d/dk2 of: derivatives of the time to the boundary after tau1
    t460 = t452*v1_2_by_k2
    delay_tau1_by_y_by_k2 = carried_x1_2_by_y*t460 - carried_x1_2_by_y_by_k2*t82
    delay_tau1_by_u_by_k2 = carried_x1_2_by_u*t460 - carried_x1_2_by_u_by_k2*t82
    delay_tau1_by_w_by_k2 = carried_x1_2_by_w*t460 - carried_x1_2_by_w_by_k2*t82
    # d/dk3 of: derivatives of the time to the boundary after tau1
    t461 = t452*v1_2_by_k3
    delay_tau1_by_y_by_k3 = carried_x1_2_by_y*t461 - carried_x1_2_by_y_by_k3*t82
    delay_tau1_by_u_by_k3 = carried_x1_2_by_u*t461 - carried_x1_2_by_u_by_k3*t82
    delay_tau1_by_w_by_k3 = carried_x1_2_by_w*t461 - carried_x1_2_by_w_by_k3*t82
    # d/dT of: derivatives of the time to the boundary after tau1
    t462 = t452*v1_2_by_T
    delay_tau1_by_y_by_T = carried_x1_2_by_y*t462 - carried_x1_2_by_y_by_T*t82
    delay_tau1_by_u_by_T = carried_x1_2_by_u*t462 - carried_x1_2_by_u_by_T*t82
    delay_tau1_by_w_by_T = carried_x1_2_by_w*t462 - carried_x1_2_by_w_by_T*t82
    # d/dy of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_y = carried_x2_2_by_y_by_y + delay_tau1_by_y*v2_2_by_y + delay_tau1_by_y_by_y*v2_2
    t463 = t73*x1_2
    t464 = -k1*t463 + k1*t73*x2_2
    t465 = delay_tau1_by_u*k1*t73
    v1_2_on_boundary_by_u_by_y = carried_v1_2_by_u_by_y + delay_tau1_by_u_by_y*t464 - t465*x1_2_by_y + t465*x2_2_by_y
    t466 = t77*x1_2
    t467 = t77*x2_2
    t468 = k1*t466 - t467*t79
    t469 = delay_tau1_by_w*t77
    t470 = k1*t469
    t471 = t469*t79
    v2_2_on_boundary_by_w_by_y = carried_v2_2_by_w_by_y + delay_tau1_by_w_by_y*t468 + t470*x1_2_by_y - t471*x2_2_by_y
    # d/du of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_u = carried_x2_2_by_y_by_u + delay_tau1_by_y*v2_2_by_u + delay_tau1_by_y_by_u*v2_2
    v1_2_on_boundary_by_u_by_u = carried_v1_2_by_u_by_u + delay_tau1_by_u_by_u*t464 - t465*x1_2_by_u + t465*x2_2_by_u
    v2_2_on_boundary_by_w_by_u = carried_v2_2_by_w_by_u + delay_tau1_by_w_by_u*t468 + t470*x1_2_by_u - t471*x2_2_by_u
    # d/dw of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_w = carried_x2_2_by_y_by_w + delay_tau1_by_y*v2_2_by_w + delay_tau1_by_y_by_w*v2_2
    v1_2_on_boundary_by_u_by_w = carried_v1_2_by_u_by_w + delay_tau1_by_u_by_w*t464 - t465*x1_2_by_w + t465*x2_2_by_w
    v2_2_on_boundary_by_w_by_w = carried_v2_2_by_w_by_w + delay_tau1_by_w_by_w*t468 + t470*x1_2_by_w - t471*x2_2_by_w
    # d/dtau of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_tau = carried_x2_2_by_y_by_tau + delay_tau1_by_y*v2_2_by_tau + delay_tau1_by_y_by_tau*v2_2
    v1_2_on_boundary_by_u_by_tau = carried_v1_2_by_u_by_tau + delay_tau1_by_u_by_tau*t464 - t465*x1_2_by_tau + t465*x2_2_by_tau
    v2_2_on_boundary_by_w_by_tau = carried_v2_2_by_w_by_tau + delay_tau1_by_w_by_tau*t468 + t470*x1_2_by_tau - t471*x2_2_by_tau
    # d/dm1 of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_m1 = carried_x2_2_by_y_by_m1 + delay_tau1_by_y*v2_2_by_m1 + delay_tau1_by_y_by_m1*v2_2
    v1_2_on_boundary_by_u_by_m1 = carried_v1_2_by_u_by_m1 + delay_tau1_by_u*(t357*x1_2 - t357*x2_2) + delay_tau1_by_u_by_m1*t464 - t465*x1_2_by_m1 + t465*x2_2_by_m1
    v2_2_on_boundary_by_w_by_m1 = carried_v2_2_by_w_by_m1 + delay_tau1_by_w_by_m1*t468 + t470*x1_2_by_m1 - t471*x2_2_by_m1
    # d/dm2 of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_m2 = carried_x2_2_by_y_by_m2 + delay_tau1_by_y*v2_2_by_m2 + delay_tau1_by_y_by_m2*v2_2
    v1_2_on_boundary_by_u_by_m2 = carried_v1_2_by_u_by_m2 + delay_tau1_by_u_by_m2*t464 - t465*x1_2_by_m2 + t465*x2_2_by_m2
    v2_2_on_boundary_by_w_by_m2 = carried_v2_2_by_w_by_m2 + delay_tau1_by_w*(t365*t79*x2_2 - t366*x1_2) + delay_tau1_by_w_by_m2*t468 + t470*x1_2_by_m2 - t471*x2_2_by_m2
    # d/dk1 of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_k1 = carried_x2_2_by_y_by_k1 + delay_tau1_by_y*v2_2_by_k1 + delay_tau1_by_y_by_k1*v2_2
    v1_2_on_boundary_by_u_by_k1 = carried_v1_2_by_u_by_k1 + delay_tau1_by_u*(-t463 + t73*x2_2) + delay_tau1_by_u_by_k1*t464 - t465*x1_2_by_k1 + t465*x2_2_by_k1
    v2_2_on_boundary_by_w_by_k1 = carried_v2_2_by_w_by_k1 + delay_tau1_by_w*(t466 - t467) + delay_tau1_by_w_by_k1*t468 + t470*x1_2_by_k1 - t471*x2_2_by_k1
    # d/dk2 of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_k2 = carried_x2_2_by_y_by_k2 + delay_tau1_by_y*v2_2_by_k2 + delay_tau1_by_y_by_k2*v2_2
    v1_2_on_boundary_by_u_by_k2 = carried_v1_2_by_u_by_k2 + delay_tau1_by_u_by_k2*t464 - t465*x1_2_by_k2 + t465*x2_2_by_k2
    v2_2_on_boundary_by_w_by_k2 = carried_v2_2_by_w_by_k2 - delay_tau1_by_w*t467 + delay_tau1_by_w_by_k2*t468 + t470*x1_2_by_k2 - t471*x2_2_by_k2
    # d/dk3 of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_k3 = carried_x2_2_by_y_by_k3 + delay_tau1_by_y*v2_2_by_k3 + delay_tau1_by_y_by_k3*v2_2
    v1_2_on_boundary_by_u_by_k3 = carried_v1_2_by_u_by_k3 + delay_tau1_by_u_by_k3*t464 - t465*x1_2_by_k3 + t465*x2_2_by_k3
    v2_2_on_boundary_by_w_by_k3 = carried_v2_2_by_w_by_k3 + delay_tau1_by_w_by_k3*t468 + t470*x1_2_by_k3 - t471*x2_2_by_k3
    # d/dT of: perturbation on the boundary after tau1
    x2_2_on_boundary_by_y_by_T = carried_x2_2_by_y_by_T + delay_tau1_by_y*v2_2_by_T + delay_tau1_by_y_by_T*v2_2
    v1_2_on_boundary_by_u_by_T = carried_v1_2_by_u_by_T + delay_tau1_by_u_by_T*t464 - t465*x1_2_by_T + t465*x2_2_by_T
    v2_2_on_boundary_by_w_by_T = carried_v2_2_by_w_by_T + delay_tau1_by_w_by_T*t468 + t470*x1_2_by_T - t471*x2_2_by_T
    return [v1_2_on_boundary_by_u_by_y + v2_2_on_boundary_by_w_by_y + x2_2_on_boundary_by_y_by_y, v1_2_on_boundary_by_u_by_u + v2_2_on_boundary_by_w_by_u + x2_2_on_boundary_by_y_by_u, v1_2_on_boundary_by_u_by_w + v2_2_on_boundary_by_w_by_w + x2_2_on_boundary_by_y_by_w, v1_2_on_boundary_by_u_by_tau + v2_2_on_boundary_by_w_by_tau + x2_2_on_boundary_by_y_by_tau, v1_2_on_boundary_by_u_by_m1 + v2_2_on_boundary_by_w_by_m1 + x2_2_on_boundary_by_y_by_m1, v1_2_on_boundary_by_u_by_m2 + v2_2_on_boundary_by_w_by_m2 + x2_2_on_boundary_by_y_by_m2, v1_2_on_boundary_by_u_by_k1 + v2_2_on_boundary_by_w_by_k1 + x2_2_on_boundary_by_y_by_k1, v1_2_on_boundary_by_u_by_k2 + v2_2_on_boundary_by_w_by_k2 + x2_2_on_boundary_by_y_by_k2, v1_2_on_boundary_by_u_by_k3 + v2_2_on_boundary_by_w_by_k3 + x2_2_on_boundary_by_y_by_k3, v1_2_on_boundary_by_u_by_T + v2_2_on_boundary_by_w_by_T + x2_2_on_boundary_by_y_by_T]


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
