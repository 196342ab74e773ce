# Generated; do not edit.
# Source: nonsmooth.derive.systems.elastic_stop
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation 4ac3f6d86542e342
"""Kernels and tables of the system elastic-stop, over any arithmetic ``lib``."""

DERIVATION = "4ac3f6d86542e342"

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

KERNELS = {'spectrum': ([((5,), 0)], [('spectrum', (12,)), ('spectrum_derivatives', (12, 5))]),
 'flow_contact': ([((5,), 0), ((12,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_free': ([((5,), 0), ((12,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'fields': ([((5,), 0)], [('fields', (8, 5))]),
 'rows': ([((5,), 0)], [('rows', (5, 5))]),
 'resets': ([((5,), 0)], [('resets', (4, 5))]),
 'modes': ([((5,), 0), ((12,), 0)], [('exponents', (6, 2)), ('coefficients', (40, 5))]),
 'one_contact_equations': ([((6,), 0), ((12,), 0), ((4,), 0), ((12, 5), 2)],
                           [('residual', (4,)),
                            ('jacobian', (4, 4)),
                            ('parameter_jacobian', (4, 6))]),
 'one_contact_trace': ([((6,), 0), ((12,), 0), ((4,), 0), ((12, 5), 1)],
                       [('trace', ()), ('trace_gradient', (10,))]),
 'one_contact_passage': ([((6,), 0), ((12,), 0), ((4,), 0)],
                         [('states', (3, 4)), ('coefficients', (12,)), ('frequencies', (4,))]),
 'one_contact_linearisation': ([((6,), 0), ((12,), 0), ((4,), 0)],
                               [('poincare_jacobian', (3, 3)),
                                ('saltations', (8, 4)),
                                ('monodromy', (4, 4))]),
 'one_contact_flow_contact': ([((6,), 0), ((12,), 0), ((), 0), ((4,), 0)],
                              [('state_after', (4,))]),
 'one_contact_flow_free': ([((6,), 0), ((12,), 0), ((), 0), ((4,), 0)],
                           [('state_after', (4,))]),
 'one_contact_reduced': ([((6,), 0), ((12,), 0), ((1,), 0)],
                         [('unknowns', (4,)),
                          ('determinants', (1,)),
                          ('reduced_residual', (1,)),
                          ('reduced_jacobian', (1, 1))])}

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (5): k1, k2, k3, m1, m2.
    Gives spectrum (12).
    Gives spectrum_derivatives (12, 5).
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
    spectrum = [gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6]
    if outputs == 1:
        return spectrum
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
    spectrum_derivatives = [[gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1, gap1_by_m2], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [gap2_by_k1, gap2_by_k2, 0, gap2_by_m1, gap2_by_m2], [omega3_by_k1, omega3_by_k2, 0, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, 0, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, 0, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, 0, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, 0, p6_by_m1, p6_by_m2]]
    return spectrum, spectrum_derivatives


def flow_contact(parameters, spectrum, time, state, *, lib):
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
    # state_after
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


def flow_free(parameters, spectrum, time, state, *, lib):
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
    # state_after
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
    coefficients = [[0, 0, 0, 0, t3], [0, 0, 0, 0, t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t3 - t5], [p3, -t6, 0, 0, t4*t6 + t8], [0, 0, p1, p2, 0], [0, 0, p3, -t6, 0], [0, 0, p1*t9, p2*t9, 0], [0, 0, p3*t9, -t6*t9, 0], [-t10, -t11, 0, 0, t10*t3 + t11*t4], [-t12, -t13, 0, 0, t12*t3 + t13*t4], [-t6, -p2, 0, 0, t3*t6 + t5], [-p3, p1, 0, 0, -p1*t4 - t8], [0, 0, -t6, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, -t16*t6, -p2*t16, 0], [0, 0, -p3*t16, p1*t16, 0], [omega2*t6, t17, 0, 0, -omega2*t1*t2*t6 - t17*t4], [t18, -t19, 0, 0, -t18*t3 + t19*t4], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p4, p5, 0, 0, 0], [p6, t20, 0, 0, 0], [0, 0, p4, p5, 0], [0, 0, p6, t20, 0], [0, 0, p4*t21, p5*t21, 0], [0, 0, p6*t21, t20*t21, 0], [-omega3*p4, -omega3*p5, 0, 0, 0], [-omega3*p6, -omega3*t20, 0, 0, 0], [t20, -p5, 0, 0, 0], [-p6, p4, 0, 0, 0], [0, 0, t20, -p5, 0], [0, 0, -p6, p4, 0], [0, 0, t20*t24, -p5*t24, 0], [0, 0, -p6*t24, p4*t24, 0], [-omega4*t20, omega4*p5, 0, 0, 0], [omega4*p6, -omega4*p4, 0, 0, 0]]
    return exponents, coefficients


def one_contact_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Takes spectrum_derivatives (12, 5): gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1,
        gap1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2,
        omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2, p1_by_k1,
        p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2, p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1,
        p2_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2, gap2_by_k1, gap2_by_k2,
        gap2_by_k3, gap2_by_m1, gap2_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3,
        omega3_by_m1, omega3_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1,
        omega4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2, p5_by_k1, p5_by_k2,
        p5_by_k3, p5_by_m1, p5_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2, for
        parameter_jacobian.
    Gives residual (4).
    Gives jacobian (4, 4).
    Gives parameter_jacobian (4, 6).
    Operations: 776. Intermediate terms: 191.
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
    # residual
    t40 = p1*u + p2*w
    t42 = -t40 + u
    t43 = k1*k2
    t45 = p1*t43
    t46 = k1*k3
    t47 = p2*t46
    t48 = t43*y
    t49 = k2*k3
    t50 = t49*y
    t51 = p2*t48 + p2*t50 + t45 + t47*y - t47
    t52 = -t43 + t51
    t53 = t43 + t46 + t49
    t54 = 1/t53
    t55 = omega2*t54
    t56 = sin_omega2_half_tau*t55
    t57 = omega1*t54
    t58 = sin_omega1_half_tau*t57
    t59 = p3*u
    t60 = p1*w
    t61 = t59 - t60 + w
    t62 = -t59 + t60
    t63 = p1*t46
    t64 = p3*t43
    t66 = t46*y - t46 + t48 + t50
    t67 = k1*k2*p1*y + k1*k3*p1*y + k2*k3*p1*y - t63 - t64 - t66
    t68 = p1*t50 + t45*y + t63*y - t63 - t64
    t69 = p4*u + p5*w
    t71 = t69 - u
    t72 = p4 + p5*y
    t73 = t72 - 1
    t74 = omega4*sin_omega4_half_tau1
    t75 = omega3*sin_omega3_half_tau1
    t76 = p6*u
    t77 = p4*w
    t78 = -t76 + t77 - w
    t79 = t76 - t77
    t80 = p4*y - p6 - y
    t81 = p4*y - p6
    residual = [cos_omega1_half_tau*t40 + cos_omega2_half_tau*t42 - t51*t58 + t52*t56, cos_omega1_half_tau*t61 + cos_omega2_half_tau*t62 - t56*t68 + t58*t67, -cos_omega3_half_tau1*t69 + cos_omega4_half_tau1*t71 - t72*t75 + t73*t74, cos_omega3_half_tau1*t78 + cos_omega4_half_tau1*t79 - t74*t81 + t75*t80]
    if outputs == 1:
        return residual
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
    t16 = cos_omega3_half_tau1*t14
    sin_omega3_half_tau1_by_tau = -t16
    t17 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t17
    t19 = cos_omega4_half_tau1*t17
    sin_omega4_half_tau1_by_tau = -t19
    # jacobian
    t82 = p2*t43 + p2*t49 + t47
    t83 = 1 - p1
    t84 = sin_omega2_half_tau_by_tau*t55
    t85 = sin_omega1_half_tau_by_tau*t57
    t86 = p1*t49 + t45 + t63
    t87 = p4 - 1
    t88 = omega4*sin_omega4_half_tau1_by_tau
    t89 = omega3*sin_omega3_half_tau1_by_tau
    jacobian = [[omega2*sin_omega2_half_tau*t54*t82 - t58*t82, cos_omega1_half_tau*p1 + cos_omega2_half_tau*t83, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, cos_omega1_half_tau_by_tau*t40 + cos_omega2_half_tau_by_tau*t42 - t51*t85 + t52*t84], [-t56*t86 + t58*(-t43 - t46 - t49 + t86), cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, cos_omega1_half_tau*t83 + cos_omega2_half_tau*p1, cos_omega1_half_tau_by_tau*t61 + cos_omega2_half_tau_by_tau*t62 + t67*t85 - t68*t84], [omega4*p5*sin_omega4_half_tau1 - p5*t75, -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t87, -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5, -cos_omega3_half_tau1_by_tau*t69 + cos_omega4_half_tau1_by_tau*t71 - t72*t89 + t73*t88], [-p4*t74 + t75*t87, -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6, cos_omega3_half_tau1*t87 - cos_omega4_half_tau1*p4, cos_omega3_half_tau1_by_tau*t78 + cos_omega4_half_tau1_by_tau*t79 + t80*t89 - t81*t88]]
    if outputs == 2:
        return residual, jacobian
    [[_, _, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [_, _, _, _, _], [omega3_by_k1, omega3_by_k2, omega3_by_k3, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, p5_by_k3, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2]] = spectrum_derivatives
    # d/dm1 of: functions of half_tau in contact
    t20 = half_tau*omega1_by_m1
    cos_omega1_half_tau_by_m1 = -sin_omega1_half_tau*t20
    sin_omega1_half_tau_by_m1 = cos_omega1_half_tau*t20
    t21 = half_tau*omega2_by_m1
    cos_omega2_half_tau_by_m1 = -sin_omega2_half_tau*t21
    sin_omega2_half_tau_by_m1 = cos_omega2_half_tau*t21
    # d/dm2 of: functions of half_tau in contact
    t22 = half_tau*omega1_by_m2
    cos_omega1_half_tau_by_m2 = -sin_omega1_half_tau*t22
    sin_omega1_half_tau_by_m2 = cos_omega1_half_tau*t22
    t23 = half_tau*omega2_by_m2
    cos_omega2_half_tau_by_m2 = -sin_omega2_half_tau*t23
    sin_omega2_half_tau_by_m2 = cos_omega2_half_tau*t23
    # d/dk1 of: functions of half_tau in contact
    t24 = half_tau*omega1_by_k1
    cos_omega1_half_tau_by_k1 = -sin_omega1_half_tau*t24
    sin_omega1_half_tau_by_k1 = cos_omega1_half_tau*t24
    t25 = half_tau*omega2_by_k1
    cos_omega2_half_tau_by_k1 = -sin_omega2_half_tau*t25
    sin_omega2_half_tau_by_k1 = cos_omega2_half_tau*t25
    # d/dk2 of: functions of half_tau in contact
    t26 = half_tau*omega1_by_k2
    cos_omega1_half_tau_by_k2 = -sin_omega1_half_tau*t26
    sin_omega1_half_tau_by_k2 = cos_omega1_half_tau*t26
    t27 = half_tau*omega2_by_k2
    cos_omega2_half_tau_by_k2 = -sin_omega2_half_tau*t27
    sin_omega2_half_tau_by_k2 = cos_omega2_half_tau*t27
    # d/dk3 of: functions of half_tau in contact
    t28 = half_tau*omega1_by_k3
    cos_omega1_half_tau_by_k3 = -sin_omega1_half_tau*t28
    sin_omega1_half_tau_by_k3 = cos_omega1_half_tau*t28
    t29 = half_tau*omega2_by_k3
    cos_omega2_half_tau_by_k3 = -sin_omega2_half_tau*t29
    sin_omega2_half_tau_by_k3 = cos_omega2_half_tau*t29
    # d/dm1 of: functions of half_tau1 in free
    t30 = half_tau1*omega3_by_m1
    cos_omega3_half_tau1_by_m1 = -sin_omega3_half_tau1*t30
    sin_omega3_half_tau1_by_m1 = cos_omega3_half_tau1*t30
    t31 = half_tau1*omega4_by_m1
    cos_omega4_half_tau1_by_m1 = -sin_omega4_half_tau1*t31
    sin_omega4_half_tau1_by_m1 = cos_omega4_half_tau1*t31
    # d/dm2 of: functions of half_tau1 in free
    t32 = half_tau1*omega3_by_m2
    cos_omega3_half_tau1_by_m2 = -sin_omega3_half_tau1*t32
    sin_omega3_half_tau1_by_m2 = cos_omega3_half_tau1*t32
    t33 = half_tau1*omega4_by_m2
    cos_omega4_half_tau1_by_m2 = -sin_omega4_half_tau1*t33
    sin_omega4_half_tau1_by_m2 = cos_omega4_half_tau1*t33
    # d/dk1 of: functions of half_tau1 in free
    t34 = half_tau1*omega3_by_k1
    cos_omega3_half_tau1_by_k1 = -sin_omega3_half_tau1*t34
    sin_omega3_half_tau1_by_k1 = cos_omega3_half_tau1*t34
    t35 = half_tau1*omega4_by_k1
    cos_omega4_half_tau1_by_k1 = -sin_omega4_half_tau1*t35
    sin_omega4_half_tau1_by_k1 = cos_omega4_half_tau1*t35
    # d/dk2 of: functions of half_tau1 in free
    t36 = half_tau1*omega3_by_k2
    cos_omega3_half_tau1_by_k2 = -sin_omega3_half_tau1*t36
    sin_omega3_half_tau1_by_k2 = cos_omega3_half_tau1*t36
    t37 = half_tau1*omega4_by_k2
    cos_omega4_half_tau1_by_k2 = -sin_omega4_half_tau1*t37
    sin_omega4_half_tau1_by_k2 = cos_omega4_half_tau1*t37
    # d/dk3 of: functions of half_tau1 in free
    t38 = half_tau1*omega3_by_k3
    cos_omega3_half_tau1_by_k3 = -sin_omega3_half_tau1*t38
    sin_omega3_half_tau1_by_k3 = cos_omega3_half_tau1*t38
    t39 = half_tau1*omega4_by_k3
    cos_omega4_half_tau1_by_k3 = -sin_omega4_half_tau1*t39
    sin_omega4_half_tau1_by_k3 = cos_omega4_half_tau1*t39
    # d/dT of: functions of half_tau1 in free
    cos_omega3_half_tau1_by_T = -cos_omega3_half_tau1_by_tau
    sin_omega3_half_tau1_by_T = t16
    cos_omega4_half_tau1_by_T = -cos_omega4_half_tau1_by_tau
    sin_omega4_half_tau1_by_T = t19
    # parameter_jacobian
    t90 = cos_omega1_half_tau*u - cos_omega2_half_tau*u + t43*t56 - t43*t58
    t91 = cos_omega1_half_tau*w - cos_omega2_half_tau*w + t56*t66 - t58*t66
    t92 = sin_omega2_half_tau*t54
    t93 = t52*t92
    t94 = t52*t55
    t95 = sin_omega1_half_tau*t54
    t96 = t51*t95
    t97 = t51*t57
    t98 = k2*p1
    t99 = k3*p2
    t100 = k2*y
    t101 = p2*t100
    t102 = t99*y
    t103 = t101 + t102 + t98 - t99
    t104 = 1/t53**2
    t105 = t104*(-k2 - k3)
    t106 = omega2*sin_omega2_half_tau
    t107 = t106*t52
    t108 = omega1*sin_omega1_half_tau
    t109 = t108*t51
    t110 = k1*p1
    t111 = k1*p2
    t112 = t111*y
    t113 = t102 + t110 + t112
    t114 = t104*(-k1 - k3)
    t115 = t101 - t111 + t112
    t116 = t104*(-k1 - k2)
    t118 = t67*t95
    t119 = t57*t67
    t120 = t68*t92
    t121 = t55*t68
    t122 = k3*p1
    t123 = k2*p3
    t124 = -k3*p1*y + k3*y
    t125 = t98*y
    t126 = t122*y
    t127 = t108*t67
    t128 = t106*t68
    t129 = k1*p3
    t130 = k1*y
    t131 = t110*y
    t132 = -t110 + t125 + t131
    t133 = -cos_omega3_half_tau1*u + cos_omega4_half_tau1*u + omega4*sin_omega4_half_tau1 - t75
    t134 = cos_omega3_half_tau1*w - cos_omega4_half_tau1*w - omega4*sin_omega4_half_tau1*y + t75*y
    t136 = sin_omega4_half_tau1*t73
    t137 = omega4*t73
    t138 = sin_omega3_half_tau1*t72
    t139 = omega3*t72
    t140 = sin_omega3_half_tau1*t80
    t141 = omega3*t80
    t142 = sin_omega4_half_tau1*t81
    t143 = omega4*t81
    parameter_jacobian = [[cos_omega1_half_tau_by_m1*t40 + cos_omega2_half_tau_by_m1*t42 - omega1_by_m1*t96 + omega2_by_m1*t93 + p1_by_m1*t90 + p2_by_m1*t91 - sin_omega1_half_tau_by_m1*t97 + sin_omega2_half_tau_by_m1*t94, cos_omega1_half_tau_by_m2*t40 + cos_omega2_half_tau_by_m2*t42 - omega1_by_m2*t96 + omega2_by_m2*t93 + p1_by_m2*t90 + p2_by_m2*t91 - sin_omega1_half_tau_by_m2*t97 + sin_omega2_half_tau_by_m2*t94, cos_omega1_half_tau_by_k1*t40 + cos_omega2_half_tau_by_k1*t42 - omega1_by_k1*t96 + omega2_by_k1*t93 + p1_by_k1*t90 + p2_by_k1*t91 - sin_omega1_half_tau_by_k1*t97 + sin_omega2_half_tau_by_k1*t94 - t103*t58 + t105*t107 - t105*t109 + t56*(-k2 + t103), cos_omega1_half_tau_by_k2*t40 + cos_omega2_half_tau_by_k2*t42 - omega1_by_k2*t96 + omega2_by_k2*t93 + p1_by_k2*t90 + p2_by_k2*t91 - sin_omega1_half_tau_by_k2*t97 + sin_omega2_half_tau_by_k2*t94 + t107*t114 - t109*t114 - t113*t58 + t56*(-k1 + t113), cos_omega1_half_tau_by_k3*t40 + cos_omega2_half_tau_by_k3*t42 - omega1_by_k3*t96 + omega2_by_k3*t93 + p1_by_k3*t90 + p2_by_k3*t91 - sin_omega1_half_tau_by_k3*t97 + sin_omega2_half_tau_by_k3*t94 + t107*t116 - t109*t116 + t115*t56 - t115*t58, 0], [cos_omega1_half_tau_by_m1*t61 + cos_omega2_half_tau_by_m1*t62 + omega1_by_m1*t118 - omega2_by_m1*t120 - p1_by_m1*t91 + p3_by_m1*t90 + sin_omega1_half_tau_by_m1*t119 - sin_omega2_half_tau_by_m1*t121, cos_omega1_half_tau_by_m2*t61 + cos_omega2_half_tau_by_m2*t62 + omega1_by_m2*t118 - omega2_by_m2*t120 - p1_by_m2*t91 + p3_by_m2*t90 + sin_omega1_half_tau_by_m2*t119 - sin_omega2_half_tau_by_m2*t121, cos_omega1_half_tau_by_k1*t61 + cos_omega2_half_tau_by_k1*t62 + omega1_by_k1*t118 - omega2_by_k1*t120 - p1_by_k1*t91 + p3_by_k1*t90 + sin_omega1_half_tau_by_k1*t119 - sin_omega2_half_tau_by_k1*t121 + t105*t127 - t105*t128 - t56*(-t122 - t123 + t125 + t126) + t58*(k2*p1*y + k3 - t100 - t122 - t123 - t124), cos_omega1_half_tau_by_k2*t61 + cos_omega2_half_tau_by_k2*t62 + omega1_by_k2*t118 - omega2_by_k2*t120 - p1_by_k2*t91 + p3_by_k2*t90 + sin_omega1_half_tau_by_k2*t119 - sin_omega2_half_tau_by_k2*t121 + t114*t127 - t114*t128 - t56*(t126 - t129 + t131) + t58*(k1*p1*y - t124 - t129 - t130), cos_omega1_half_tau_by_k3*t61 + cos_omega2_half_tau_by_k3*t62 + omega1_by_k3*t118 - omega2_by_k3*t120 - p1_by_k3*t91 + p3_by_k3*t90 + sin_omega1_half_tau_by_k3*t119 - sin_omega2_half_tau_by_k3*t121 + t116*t127 - t116*t128 - t132*t56 + t58*(k1 - t100 - t130 + t132), 0], [-cos_omega3_half_tau1_by_m1*t69 + cos_omega4_half_tau1_by_m1*t71 - omega3_by_m1*t138 + omega4_by_m1*t136 + p4_by_m1*t133 - p5_by_m1*t134 - sin_omega3_half_tau1_by_m1*t139 + sin_omega4_half_tau1_by_m1*t137, -cos_omega3_half_tau1_by_m2*t69 + cos_omega4_half_tau1_by_m2*t71 - omega3_by_m2*t138 + omega4_by_m2*t136 + p4_by_m2*t133 - p5_by_m2*t134 - sin_omega3_half_tau1_by_m2*t139 + sin_omega4_half_tau1_by_m2*t137, -cos_omega3_half_tau1_by_k1*t69 + cos_omega4_half_tau1_by_k1*t71 - omega3_by_k1*t138 + omega4_by_k1*t136 + p4_by_k1*t133 - p5_by_k1*t134 - sin_omega3_half_tau1_by_k1*t139 + sin_omega4_half_tau1_by_k1*t137, -cos_omega3_half_tau1_by_k2*t69 + cos_omega4_half_tau1_by_k2*t71 - omega3_by_k2*t138 + omega4_by_k2*t136 + p4_by_k2*t133 - p5_by_k2*t134 - sin_omega3_half_tau1_by_k2*t139 + sin_omega4_half_tau1_by_k2*t137, -cos_omega3_half_tau1_by_k3*t69 + cos_omega4_half_tau1_by_k3*t71 - omega3_by_k3*t138 + omega4_by_k3*t136 + p4_by_k3*t133 - p5_by_k3*t134 - sin_omega3_half_tau1_by_k3*t139 + sin_omega4_half_tau1_by_k3*t137, -cos_omega3_half_tau1_by_T*t69 + cos_omega4_half_tau1_by_T*t71 - sin_omega3_half_tau1_by_T*t139 + sin_omega4_half_tau1_by_T*t137], [cos_omega3_half_tau1_by_m1*t78 + cos_omega4_half_tau1_by_m1*t79 + omega3_by_m1*t140 - omega4_by_m1*t142 + p4_by_m1*t134 + p6_by_m1*t133 + sin_omega3_half_tau1_by_m1*t141 - sin_omega4_half_tau1_by_m1*t143, cos_omega3_half_tau1_by_m2*t78 + cos_omega4_half_tau1_by_m2*t79 + omega3_by_m2*t140 - omega4_by_m2*t142 + p4_by_m2*t134 + p6_by_m2*t133 + sin_omega3_half_tau1_by_m2*t141 - sin_omega4_half_tau1_by_m2*t143, cos_omega3_half_tau1_by_k1*t78 + cos_omega4_half_tau1_by_k1*t79 + omega3_by_k1*t140 - omega4_by_k1*t142 + p4_by_k1*t134 + p6_by_k1*t133 + sin_omega3_half_tau1_by_k1*t141 - sin_omega4_half_tau1_by_k1*t143, cos_omega3_half_tau1_by_k2*t78 + cos_omega4_half_tau1_by_k2*t79 + omega3_by_k2*t140 - omega4_by_k2*t142 + p4_by_k2*t134 + p6_by_k2*t133 + sin_omega3_half_tau1_by_k2*t141 - sin_omega4_half_tau1_by_k2*t143, cos_omega3_half_tau1_by_k3*t78 + cos_omega4_half_tau1_by_k3*t79 + omega3_by_k3*t140 - omega4_by_k3*t142 + p4_by_k3*t134 + p6_by_k3*t133 + sin_omega3_half_tau1_by_k3*t141 - sin_omega4_half_tau1_by_k3*t143, cos_omega3_half_tau1_by_T*t78 + cos_omega4_half_tau1_by_T*t79 + sin_omega3_half_tau1_by_T*t141 - sin_omega4_half_tau1_by_T*t143]]
    return residual, jacobian, parameter_jacobian


def one_contact_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (6): m1, m2, k1, k2, k3, T.
    Takes spectrum (12): gap1, omega1, omega2, p1, p2, p3, gap2, omega3, omega4, p4, p5, p6.
    Takes unknowns (4): y, u, w, tau.
    Takes spectrum_derivatives (12, 5): gap1_by_k1, gap1_by_k2, gap1_by_k3, gap1_by_m1,
        gap1_by_m2, omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2,
        omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2, p1_by_k1,
        p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2, p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1,
        p2_by_m2, p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2, gap2_by_k1, gap2_by_k2,
        gap2_by_k3, gap2_by_m1, gap2_by_m2, omega3_by_k1, omega3_by_k2, omega3_by_k3,
        omega3_by_m1, omega3_by_m2, omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1,
        omega4_by_m2, p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2, p5_by_k1, p5_by_k2,
        p5_by_k3, p5_by_m1, p5_by_m2, p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2, for
        trace_gradient.
    Gives trace.
    Gives trace_gradient (10).
    Operations: 1672. Intermediate terms: 325.
    """
    [m1, m2, k1, k2, k3, T] = parameters
    [_, omega1, omega2, p1, p2, p3, _, omega3, omega4, p4, p5, p6] = spectrum
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
    carried_x2_2_by_y = t65*v1_1_on_boundary_by_y + t66*v2_1_on_boundary_by_y + t67*x1_1_on_boundary_by_y + t68*x2_1_on_boundary_by_y
    carried_v1_2_by_u = t62*v1_1_on_boundary_by_u + t63*v2_1_on_boundary_by_u - t71*x1_1_on_boundary_by_u + t74*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t67*v1_1_on_boundary_by_w + t68*v2_1_on_boundary_by_w + t76*x1_1_on_boundary_by_w - t77*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t89 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t89
    delay_tau1_by_u = -carried_x1_2_by_u*t89
    delay_tau1_by_w = -carried_x1_2_by_w*t89
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    t90 = t80*x1_2
    t91 = k1*t80*x2_2 - k1*t90
    v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t91
    t92 = t84*x1_2
    t93 = t84*x2_2
    t94 = k1*t92 - t86*t93
    v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t94
    trace = v1_2_on_boundary_by_u + v2_2_on_boundary_by_w + x2_2_on_boundary_by_y
    if outputs == 1:
        return trace
    [[_, _, _, _, _], [omega1_by_k1, omega1_by_k2, omega1_by_k3, omega1_by_m1, omega1_by_m2], [omega2_by_k1, omega2_by_k2, omega2_by_k3, omega2_by_m1, omega2_by_m2], [p1_by_k1, p1_by_k2, p1_by_k3, p1_by_m1, p1_by_m2], [p2_by_k1, p2_by_k2, p2_by_k3, p2_by_m1, p2_by_m2], [p3_by_k1, p3_by_k2, p3_by_k3, p3_by_m1, p3_by_m2], [_, _, _, _, _], [omega3_by_k1, omega3_by_k2, omega3_by_k3, omega3_by_m1, omega3_by_m2], [omega4_by_k1, omega4_by_k2, omega4_by_k3, omega4_by_m1, omega4_by_m2], [p4_by_k1, p4_by_k2, p4_by_k3, p4_by_m1, p4_by_m2], [p5_by_k1, p5_by_k2, p5_by_k3, p5_by_m1, p5_by_m2], [p6_by_k1, p6_by_k2, p6_by_k3, p6_by_m1, p6_by_m2]] = spectrum_derivatives
    # back through: derivatives of the time to the boundary after tau1
    slope_by_delay_tau1_by_w = t94
    slope_by_delay_tau1_by_u = t91
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
    t95 = 1/rate_1**2
    slope_by_rate_1 = -carried_x1_1_by_u*slope_by_delay_tau_by_u*t95 - carried_x1_1_by_w*slope_by_delay_tau_by_w*t95 - carried_x1_1_by_y*slope_by_delay_tau_by_y*t95
    # back through: Phi along tau
    slope_by_carried_x1_1_by_w = slope_by_delay_tau_by_w*t79 + slope_by_x1_1_on_boundary_by_w
    slope_by_carried_x1_1_by_u = slope_by_delay_tau_by_u*t79 + slope_by_x1_1_on_boundary_by_u
    slope_by_carried_x1_1_by_y = slope_by_delay_tau_by_y*t79 + slope_by_x1_1_on_boundary_by_y
    # back through: free for tau1, until first-reaches-stop
    t96 = 1/v1_2**2
    slope_by_v1_2 = carried_x1_2_by_u*slope_by_delay_tau1_by_u*t96 + carried_x1_2_by_w*slope_by_delay_tau1_by_w*t96 + carried_x1_2_by_y*t96*v2_2
    t97 = k1*t80
    t98 = delay_tau1_by_u*t97
    slope_by_x2_2 = -delay_tau1_by_w*t84*t86 + t98
    slope_by_x1_2 = delay_tau1_by_w*k1*t84 - t98
    # back through: functions of tau1 in free
    t99 = p4*x2_1
    t100 = p5*v2_1_on_boundary_by_u
    t101 = p5*t58
    t102 = p5*x2_1
    t103 = t57*x1_1
    t104 = p5*v2_1
    t105 = p4*v2_1
    t106 = p6*v1_1
    t107 = p4*v2_1_on_boundary_by_y
    t108 = p5*x2_1_on_boundary_by_u
    t109 = p6*x1_1_on_boundary_by_w
    t110 = p4*x2_1_on_boundary_by_w
    t111 = p6*v1_1_on_boundary_by_y
    t112 = t57*x1_1_on_boundary_by_u
    slope_by_sin_omega4_tau1 = delay_tau1_by_y*(omega4*p6*x1_1 - omega4*t99) + omega4*t108 + omega4*t109 - omega4*t110 - omega4*t112 + slope_by_carried_x1_2_by_u*(-t100*t58 + t57*t58*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t101*v2_1_on_boundary_by_w + t57*t58*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t101*v2_1_on_boundary_by_y + t57*t58*v1_1_on_boundary_by_y) + slope_by_v1_2*(omega4*t102 - omega4*t103) + slope_by_x1_2*(-t104*t58 + t57*t58*v1_1) + slope_by_x2_2*(t105*t58 - t106*t58) + t107*t58 - t111*t58
    t113 = p5*x2_1_on_boundary_by_w
    t114 = p5*x2_1_on_boundary_by_y
    t115 = p6*x1_1
    t116 = t57*v1_1_on_boundary_by_u
    t117 = p6*v1_1_on_boundary_by_w
    t118 = p6*x1_1_on_boundary_by_y
    slope_by_cos_omega4_tau1 = delay_tau1_by_y*(t105 - t106) + p4*v2_1_on_boundary_by_w + p4*x2_1_on_boundary_by_y + slope_by_carried_x1_2_by_u*(-t108 + t57*x1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(-t113 + t57*x1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t114 + t57*x1_1_on_boundary_by_y) + slope_by_v1_2*(-t104 + t57*v1_1) + slope_by_x1_2*(-t102 + t57*x1_1) + slope_by_x2_2*(-t115 + t99) - t100 + t116 - t117 - t118
    t119 = t57*x2_1
    t120 = p4*v1_1_on_boundary_by_u
    t121 = p4*t55
    t122 = p5*t55
    t123 = p4*x1_1
    t124 = p4*v1_1
    t125 = t57*v2_1
    t126 = t57*v2_1_on_boundary_by_y
    t127 = p4*x1_1_on_boundary_by_u
    t128 = t57*x2_1_on_boundary_by_w
    slope_by_sin_omega3_tau1 = delay_tau1_by_y*(-omega3*t115 - omega3*t119) - omega3*t108 - omega3*t109 - omega3*t127 - omega3*t128 + slope_by_carried_x1_2_by_u*(t100*t55 + t120*t55) + slope_by_carried_x1_2_by_w*(t121*v1_1_on_boundary_by_w + t122*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t121*v1_1_on_boundary_by_y + t122*v2_1_on_boundary_by_y) + slope_by_v1_2*(-omega3*t102 - omega3*t123) + slope_by_x1_2*(t104*t55 + t124*t55) + slope_by_x2_2*(t106*t55 + t125*t55) + t111*t55 + t126*t55
    slope_by_cos_omega3_tau1 = delay_tau1_by_y*(t106 + t125) + slope_by_carried_x1_2_by_u*(t108 + t127) + slope_by_carried_x1_2_by_w*(p4*x1_1_on_boundary_by_w + t113) + slope_by_carried_x1_2_by_y*(p4*x1_1_on_boundary_by_y + t114) + slope_by_v1_2*(t104 + t124) + slope_by_x1_2*(t102 + t123) + slope_by_x2_2*(t115 + t119) + t100 + t117 + t118 + t120 + t57*v2_1_on_boundary_by_w + t57*x2_1_on_boundary_by_y
    # back through: tau1 completes the period
    t129 = sin_omega3_tau1*slope_by_cos_omega3_tau1
    t130 = sin_omega4_tau1*slope_by_cos_omega4_tau1
    slope_by_tau1 = cos_omega3_tau1*omega3*slope_by_sin_omega3_tau1 + cos_omega4_tau1*omega4*slope_by_sin_omega4_tau1 - omega3*t129 - omega4*t130
    # back through: contact for tau, until first-leaves-stop
    slope_by_v2_1 = delay_tau1_by_y*t68 + delay_tau_by_u*slope_by_x2_1_on_boundary_by_u + delay_tau_by_w*slope_by_x2_1_on_boundary_by_w + delay_tau_by_y*slope_by_x2_1_on_boundary_by_y + slope_by_v1_2*t63 + slope_by_x1_2*t61 + slope_by_x2_2*t66
    slope_by_v1_1 = delay_tau1_by_y*t67 + delay_tau_by_u*slope_by_x1_1_on_boundary_by_u + delay_tau_by_w*slope_by_x1_1_on_boundary_by_w + delay_tau_by_y*slope_by_x1_1_on_boundary_by_y - slope_by_rate_1 + slope_by_v1_2*t62 + slope_by_x1_2*t60 + slope_by_x2_2*t65
    t131 = delay_tau_by_u*slope_by_v1_1_on_boundary_by_u
    t132 = delay_tau_by_w*slope_by_v1_1_on_boundary_by_w
    t133 = delay_tau_by_y*slope_by_v1_1_on_boundary_by_y
    t134 = delay_tau_by_u*slope_by_v2_1_on_boundary_by_u
    t135 = t84*t86
    t136 = delay_tau_by_w*slope_by_v2_1_on_boundary_by_w
    t137 = delay_tau_by_y*slope_by_v2_1_on_boundary_by_y
    slope_by_x2_1 = -delay_tau1_by_y*t77 + slope_by_v1_2*t74 + slope_by_x1_2*t63 + slope_by_x2_2*t68 + t131*t97 + t132*t97 + t133*t97 - t134*t135 - t135*t136 - t135*t137
    t138 = k1*t84
    t139 = t80*t81
    slope_by_x1_1 = delay_tau1_by_y*t76 - slope_by_v1_2*t71 + slope_by_x1_2*t62 + slope_by_x2_2*t67 - t131*t139 - t132*t139 - t133*t139 + t134*t138 + t136*t138 + t137*t138
    # back through: functions of tau in contact
    t140 = p1*y
    t141 = p2*w
    t142 = p1*w
    t143 = p3*u
    t144 = p1*slope_by_x2_1_on_boundary_by_w
    t145 = p2*slope_by_v1_1_on_boundary_by_y
    t146 = p1*slope_by_v2_1_on_boundary_by_y
    t147 = p2*slope_by_carried_x1_1_by_w
    t148 = p3*slope_by_x2_1_on_boundary_by_u
    slope_by_sin_omega2_tau = omega2*t145 - omega2*t146 - slope_by_carried_x1_1_by_u*t14*t18 + slope_by_v1_1*(omega2*p2*y - t38 - t41) + slope_by_v2_1*(-omega2*t140 + t45 + t46) + slope_by_x1_1*(-t14*t18*u - t141*t18) + slope_by_x2_1*(t142*t18 - t143*t18) + t144*t18 - t147*t18 - t148*t18
    t149 = p2*y
    t150 = -p1 - t149
    t151 = p2*slope_by_carried_x1_1_by_y
    t152 = p2*slope_by_v1_1_on_boundary_by_w
    t153 = p3*slope_by_v2_1_on_boundary_by_u
    slope_by_cos_omega2_tau = p1*slope_by_v2_1_on_boundary_by_w + p1*slope_by_x2_1_on_boundary_by_y + slope_by_v1_1*(-t14*u - t141) - slope_by_v1_1_on_boundary_by_u*t14 + slope_by_v2_1*(t142 - t143) + slope_by_x1_1*(t15 + t150 + 1) + slope_by_x2_1*(p1*y - p3 - t30) - t151 - t152 - t153
    t154 = -t14*y
    t155 = p1*u
    t156 = -t14*w
    t157 = -slope_by_x2_1_on_boundary_by_w*t14
    t158 = -slope_by_v2_1_on_boundary_by_y*t14
    slope_by_sin_omega1_tau = -omega1*t145 - omega1*t158 + p1*slope_by_carried_x1_1_by_u*t16 + slope_by_v1_1*(-omega1*t149 - t36 + t37) + slope_by_v2_1*(-omega1*t154 - t42 + t44) + slope_by_x1_1*(t141*t16 + t155*t16) + slope_by_x2_1*(t143*t16 + t156*t16) + t147*t16 + t148*t16 + t157*t16
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_u + slope_by_v1_1*(t141 + t155) + slope_by_v2_1*(t143 + t156) - slope_by_v2_1_on_boundary_by_w*t14 + slope_by_x1_1*(-t13 - t150) + slope_by_x2_1*(p3 + t154 + t28) - slope_by_x2_1_on_boundary_by_y*t14 + t151 + t152 + t153
    # trace_gradient
    t159 = sin_omega1_tau*slope_by_cos_omega1_tau
    t160 = sin_omega2_tau*slope_by_cos_omega2_tau
    t161 = 1/m1**2
    t162 = k1*t161
    t163 = p3*sin_omega1_tau
    t164 = 1/omega1**2
    t165 = sin_omega1_tau*t164
    t166 = cos_omega1_tau*slope_by_sin_omega1_tau*tau - sin_omega1_tau*t145 - sin_omega1_tau*t158 - slope_by_carried_x1_1_by_u*t164*t17 + slope_by_v1_1*(sin_omega1_tau*t13 - sin_omega1_tau*t149 - t17) + slope_by_v2_1*(-sin_omega1_tau*t154 + sin_omega1_tau*(t26 + t43) - t163) + slope_by_x1_1*(-t141*t165 - t155*t165) + slope_by_x2_1*(-t143*t165 - t156*t165) - slope_by_x2_1_on_boundary_by_u*t163*t164 - t147*t165 - t157*t165 - t159*tau
    t167 = 1/omega2**2
    t168 = sin_omega2_tau*t167
    t169 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + sin_omega2_tau*t145 - sin_omega2_tau*t146 - slope_by_carried_x1_1_by_u*t167*t20 + slope_by_v1_1*(sin_omega2_tau*t149 + sin_omega2_tau*(-t12 - t14*t7*t9) - t20) + slope_by_v2_1*(-sin_omega2_tau*t140 + sin_omega2_tau*t30 + t31) + slope_by_x1_1*(t14*t168*u + t141*t168) + slope_by_x2_1*(p3*sin_omega2_tau*t167*u - t142*t168) + slope_by_x2_1_on_boundary_by_u*t167*t31 - t144*t168 + t147*t168 - t160*tau
    t170 = sin_omega3_tau1/omega3**2
    t171 = p4*t170
    t172 = p5*t170
    t173 = cos_omega3_tau1*slope_by_sin_omega3_tau1*tau1 + delay_tau1_by_y*(-sin_omega3_tau1*t115 - sin_omega3_tau1*t119) - sin_omega3_tau1*t108 - sin_omega3_tau1*t109 - sin_omega3_tau1*t127 - sin_omega3_tau1*t128 + slope_by_carried_x1_2_by_u*(-t100*t170 - t120*t170) + slope_by_carried_x1_2_by_w*(-t171*v1_1_on_boundary_by_w - t172*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(-t171*v1_1_on_boundary_by_y - t172*v2_1_on_boundary_by_y) + slope_by_v1_2*(-sin_omega3_tau1*t102 - sin_omega3_tau1*t123) + slope_by_x1_2*(-t104*t170 - t124*t170) + slope_by_x2_2*(-t106*t170 - t125*t170) - t111*t170 - t126*t170 - t129*tau1
    t174 = 1/omega4**2
    t175 = sin_omega4_tau1*t174
    t176 = p5*t175
    t177 = t175*t57
    t178 = cos_omega4_tau1*slope_by_sin_omega4_tau1*tau1 + delay_tau1_by_y*(p6*sin_omega4_tau1*x1_1 - sin_omega4_tau1*t99) + sin_omega4_tau1*t108 + sin_omega4_tau1*t109 - sin_omega4_tau1*t110 - sin_omega4_tau1*t112 + slope_by_carried_x1_2_by_u*(t100*t175 - t116*t175) + slope_by_carried_x1_2_by_w*(t176*v2_1_on_boundary_by_w - t177*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t176*v2_1_on_boundary_by_y - t177*v1_1_on_boundary_by_y) + slope_by_v1_2*(sin_omega4_tau1*t102 - sin_omega4_tau1*t103) + slope_by_x1_2*(t104*t175 - t175*t57*v1_1) + slope_by_x2_2*(p6*sin_omega4_tau1*t174*v1_1 - t105*t175) - t107*t175 + t111*t175 - t130*tau1
    t179 = -sin_omega1_tau*t16 + t22
    t181 = cos_omega1_tau - cos_omega2_tau
    t182 = t10*t39 - t10*t47 + t181*u - t39 + t47
    t184 = t39 - t47
    t185 = t11*t47
    t186 = t11*t39
    t187 = -cos_omega1_tau*t10 + cos_omega2_tau*t10 - t179*u + t181
    t188 = cos_omega1_tau*t11
    t189 = cos_omega2_tau*t11
    t190 = -slope_by_carried_x1_1_by_u*t179 + slope_by_v1_1*t182 + slope_by_v1_1_on_boundary_by_u*t181 + slope_by_v2_1*(-t181*w + t184*y + t185 - t186) - slope_by_v2_1_on_boundary_by_w*t181 + slope_by_v2_1_on_boundary_by_y*t184 + slope_by_x1_1*t187 + slope_by_x2_1*(t179*w - t181*y + t188 - t189) + slope_by_x2_1_on_boundary_by_w*t179 - slope_by_x2_1_on_boundary_by_y*t181
    t192 = -slope_by_carried_x1_1_by_w*t179 + slope_by_carried_x1_1_by_y*t181 + slope_by_v1_1*(t181*w - t184*y - t185 + t186) + slope_by_v1_1_on_boundary_by_w*t181 - slope_by_v1_1_on_boundary_by_y*t184 + slope_by_x1_1*(-t179*w + t181*y - t188 + t189)
    t193 = slope_by_v2_1*t182 + slope_by_v2_1_on_boundary_by_u*t181 + slope_by_x2_1*t187 - slope_by_x2_1_on_boundary_by_u*t179
    t194 = cos_omega3_tau1 - cos_omega4_tau1
    t196 = t69 - t70
    t197 = -sin_omega3_tau1*t55 + t59
    t199 = t194*x1_1_on_boundary_by_y - t197*v1_1_on_boundary_by_y
    t201 = t194*v1_1 - t196*x1_1
    t202 = t194*x1_1 - t197*v1_1
    t203 = delay_tau1_by_y*(-t194*v2_1 + t196*x2_1) + slope_by_carried_x1_2_by_u*(t194*x1_1_on_boundary_by_u - t197*v1_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t194*x1_1_on_boundary_by_w - t197*v1_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*t199 + slope_by_v1_2*t201 + slope_by_x1_2*t202 + slope_by_x2_2*(-t194*x2_1 + t197*v2_1) + t194*v1_1_on_boundary_by_u - t194*v2_1_on_boundary_by_w - t194*x2_1_on_boundary_by_y - t196*x1_1_on_boundary_by_u + t196*x2_1_on_boundary_by_w + t197*v2_1_on_boundary_by_y
    t204 = slope_by_carried_x1_2_by_u*(t194*x2_1_on_boundary_by_u - t197*v2_1_on_boundary_by_u) + slope_by_carried_x1_2_by_w*(t194*x2_1_on_boundary_by_w - t197*v2_1_on_boundary_by_w) + slope_by_carried_x1_2_by_y*(t194*x2_1_on_boundary_by_y - t197*v2_1_on_boundary_by_y) + slope_by_v1_2*(t194*v2_1 - t196*x2_1) + slope_by_x1_2*(t194*x2_1 - t197*v2_1) + t194*v2_1_on_boundary_by_u - t196*x2_1_on_boundary_by_u
    t205 = delay_tau1_by_y*t201 + slope_by_x2_2*t202 + t194*v1_1_on_boundary_by_w - t196*x1_1_on_boundary_by_w + t199
    t206 = -k3*t161 + t161*t81*x1_1 - t162*x2_1
    t207 = 1/m2**2
    t208 = k1*t207
    t209 = t207*t86*x2_1 - t208*x1_1
    t210 = k3*t9
    t211 = t210*t36
    t212 = p2*t210
    t213 = -k2 - k3
    t214 = 1/t8**2
    t215 = t214*t7
    t216 = t213*t215
    t217 = t214*t6
    t218 = t213*t217
    t219 = p2*t218
    t220 = t210*t42
    t221 = -omega1*t14
    t222 = p1*t210
    t223 = t210*t45
    t224 = p1*t218
    t225 = t212 + t219
    t226 = t14*t210
    t227 = p3*t210
    t228 = -p3*t216 - t227
    t229 = t80*x2_1 - t82
    t230 = t85 - t87
    t232 = -t215*t81
    t233 = -t217*t81
    t234 = p2*t233
    t235 = p3*t232 + t227
    t236 = t86*t9
    t237 = k1*t9
    t238 = p2*t237
    t240 = -t215*t86
    t241 = -t217*t86
    t242 = p2*t241
    t243 = p1*t237
    t244 = p1*t241
    t245 = t238 + t242
    t246 = -p3*t236 - p3*t240
    t247 = t80 - t82
    trace_gradient = [slope_by_v1_1*t40 + slope_by_v2_1*t48 + slope_by_x1_1*t24 + slope_by_x2_1*t34, slope_by_v1_1*t25 + slope_by_v2_1*t35 + slope_by_x1_1*t21 + slope_by_x2_1*t32, slope_by_v1_1*t24 + slope_by_v2_1*t34 + slope_by_x1_1*t23 + slope_by_x2_1*t33, cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t159 - omega2*t160 - slope_by_tau1, delay_tau1_by_u*(t162*x1_2 - t162*x2_2) + omega1_by_m1*t166 + omega2_by_m1*t169 + omega3_by_m1*t173 + omega4_by_m1*t178 + p1_by_m1*t190 + p2_by_m1*t192 + p3_by_m1*t193 + p4_by_m1*t203 + p5_by_m1*t204 + p6_by_m1*t205 + t131*t206 + t132*t206 + t133*t206, delay_tau1_by_w*(t207*t86*x2_2 - t208*x1_2) + omega1_by_m2*t166 + omega2_by_m2*t169 + omega3_by_m2*t173 + omega4_by_m2*t178 + p1_by_m2*t190 + p2_by_m2*t192 + p3_by_m2*t193 + p4_by_m2*t203 + p5_by_m2*t204 + p6_by_m2*t205 + t134*t209 + t136*t209 + t137*t209, delay_tau1_by_u*(t80*x2_2 - t90) + delay_tau1_by_w*(t92 - t93) + omega1_by_k1*t166 + omega2_by_k1*t169 + omega3_by_k1*t173 + omega4_by_k1*t178 + p1_by_k1*t190 + p2_by_k1*t192 + p3_by_k1*t193 + p4_by_k1*t203 + p5_by_k1*t204 + p6_by_k1*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t212 + omega1*t219 + t211 + t216*t36) + sin_omega2_tau*(-k3*omega2*t14*t9 - omega2*t14*t213*t214*t7 - omega2*t212 - omega2*t219)) + slope_by_v2_1*(sin_omega1_tau*(t210*t221 + t216*t42 + t218*t221 + t220) + sin_omega2_tau*(omega2*t222 + omega2*t224 - t216*t45 - t223)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t216 - t222 - t225) + cos_omega2_tau*(t14*t216 + t225 + t226) + t210 + t216) + slope_by_x2_1*(cos_omega1_tau*(t14*t218 + t226 + t228) + cos_omega2_tau*(-t222 - t224 - t228) + t210 + t218) + t131*t229 + t132*t229 + t133*t229 + t134*t230 + t136*t230 + t137*t230, -delay_tau1_by_w*t93 + omega1_by_k2*t166 + omega2_by_k2*t169 + omega3_by_k2*t173 + omega4_by_k2*t178 + p1_by_k2*t190 + p2_by_k2*t192 + p3_by_k2*t193 + p4_by_k2*t203 + p5_by_k2*t204 + p6_by_k2*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t234 + t211 + t232*t36) + sin_omega2_tau*(-omega2*t234 + t210*t41 + t232*t41)) + slope_by_v2_1*(sin_omega1_tau*(t220 + t221*t233 + t232*t42) + sin_omega2_tau*(-k1*k3*omega2*p1*t214*t81 - t223 - t232*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t232 - t222 - t234) + cos_omega2_tau*(t14*t232 + t226 + t234) + t210 + t232) + slope_by_x2_1*(cos_omega1_tau*(-k1*k3*t14*t214*t81 - t235) + cos_omega2_tau*(-p1*t233 + t235) + t233) - t134*t87 - t136*t87 - t137*t87, omega1_by_k3*t166 + omega2_by_k3*t169 + omega3_by_k3*t173 + omega4_by_k3*t178 + p1_by_k3*t190 + p2_by_k3*t192 + p3_by_k3*t193 + p4_by_k3*t203 + p5_by_k3*t204 + p6_by_k3*t205 + slope_by_v1_1*(sin_omega1_tau*(omega1*t238 + omega1*t242 + t236*t36 + t240*t36) + sin_omega2_tau*(omega2*t14*t214*t7*t86 - omega2*t14*t86*t9 - omega2*t238 - omega2*t242)) + slope_by_v2_1*(sin_omega1_tau*(t221*t237 + t221*t241 + t236*t42 + t240*t42) + sin_omega2_tau*(omega2*t243 + omega2*t244 - t236*t45 - t240*t45)) + slope_by_x1_1*(cos_omega1_tau*(-p1*t236 - p1*t240 - t245) + cos_omega2_tau*(t14*t236 + t14*t240 + t245) + t236 + t240) + slope_by_x2_1*(cos_omega1_tau*(t14*t237 + t14*t241 + t246) + cos_omega2_tau*(-t243 - t244 - t246) + t237 + t241) + t131*t247 + t132*t247 + t133*t247, slope_by_tau1]
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
    Operations: 245. Intermediate terms: 58.
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
    # tau1 completes the period
    tau1 = T - tau
    # functions of tau1 in free
    t26 = omega3*tau1
    cos_omega3_tau1 = lib.cos(t26)
    sin_omega3_tau1 = lib.sin(t26)
    t27 = omega4*tau1
    cos_omega4_tau1 = lib.cos(t27)
    sin_omega4_tau1 = lib.sin(t27)
    # free for tau1, until first-reaches-stop
    t28 = 1/omega3
    t29 = sin_omega3_tau1*t28
    t30 = 1 - p4
    t31 = 1/omega4
    t32 = sin_omega4_tau1*t31
    t33 = cos_omega3_tau1*p4 + cos_omega4_tau1*t30
    t34 = cos_omega3_tau1*p5 - cos_omega4_tau1*p5
    x1_2 = t33*x1_1 + t34*x2_1 + v1_1*(p4*t29 + t30*t32) + v2_1*(p5*sin_omega3_tau1*t28 - p5*t32)
    t35 = cos_omega3_tau1*p6 - cos_omega4_tau1*p6
    t36 = cos_omega3_tau1*t30 + cos_omega4_tau1*p4
    x2_2 = t35*x1_1 + t36*x2_1 + v1_1*(p6*sin_omega3_tau1*t28 - p6*t32) + v2_1*(p4*t32 + t29*t30)
    t37 = omega3*sin_omega3_tau1
    t38 = omega4*sin_omega4_tau1
    v1_2 = t33*v1_1 + t34*v2_1 + x1_1*(-p4*t37 - t30*t38) + x2_1*(omega4*p5*sin_omega4_tau1 - p5*t37)
    v2_2 = t35*v1_1 + t36*v2_1 + x1_1*(omega4*p6*sin_omega4_tau1 - p6*t37) + x2_1*(-p4*t38 - t30*t37)
    states = [[1, y, u, w], [x1_1, x2_1, v1_1, v2_1], [x1_2, x2_2, v1_2, v2_2]]
    if outputs == 1:
        return states
    # coefficients
    t39 = -p1 - p2*y
    t40 = p2*w
    t41 = p5*x2_1
    t42 = p5*v2_1
    coefficients = [1 - t5, 0, t39 + t9, -t11 - t39 - 1, -p1*t12*u - t12*t40, t10*t15*u + t15*t40, -1, 0, p4*x1_1 + t41, t30*x1_1 - t41, p4*t28*v1_1 + t28*t42, t30*t31*v1_1 - t31*t42]
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
    Operations: 541. Intermediate terms: 193.
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
    t50 = omega4*p6*sin_omega4_tau1 - p6*t46
    t51 = -p4*t47 - t36*t46
    v2_2 = t44*v1_1 + t45*v2_1 + t50*x1_1 + t51*x2_1
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
    carried_v2_1_by_y = t30
    carried_v2_1_by_u = t24
    carried_v2_1_by_w = t23
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
    t54 = k3*t53
    t55 = k1*t53
    t56 = t53*(k1 + k3)
    t57 = t54 + t55*x2_1 - t56*x1_1
    v1_1_on_boundary_by_y = carried_v1_1_by_y + delay_tau_by_y*t57
    v1_1_on_boundary_by_u = carried_v1_1_by_u + delay_tau_by_u*t57
    v1_1_on_boundary_by_w = carried_v1_1_by_w + delay_tau_by_w*t57
    t58 = 1/m2
    t59 = k1*t58
    t60 = t58*(k1 + k2)
    t61 = t59*x1_1 - t60*x2_1
    v2_1_on_boundary_by_y = carried_v2_1_by_y + delay_tau_by_y*t61
    v2_1_on_boundary_by_u = carried_v2_1_by_u + delay_tau_by_u*t61
    v2_1_on_boundary_by_w = carried_v2_1_by_w + delay_tau_by_w*t61
    # Phi along tau1
    carried_x1_2_by_y = t38*v1_1_on_boundary_by_y + t39*v2_1_on_boundary_by_y + t40*x1_1_on_boundary_by_y + t41*x2_1_on_boundary_by_y
    carried_x1_2_by_u = t38*v1_1_on_boundary_by_u + t39*v2_1_on_boundary_by_u + t40*x1_1_on_boundary_by_u + t41*x2_1_on_boundary_by_u
    carried_x1_2_by_w = t38*v1_1_on_boundary_by_w + t39*v2_1_on_boundary_by_w + t40*x1_1_on_boundary_by_w + t41*x2_1_on_boundary_by_w
    carried_x2_2_by_y = t42*v1_1_on_boundary_by_y + t43*v2_1_on_boundary_by_y + t44*x1_1_on_boundary_by_y + t45*x2_1_on_boundary_by_y
    carried_x2_2_by_u = t42*v1_1_on_boundary_by_u + t43*v2_1_on_boundary_by_u + t44*x1_1_on_boundary_by_u + t45*x2_1_on_boundary_by_u
    carried_x2_2_by_w = t42*v1_1_on_boundary_by_w + t43*v2_1_on_boundary_by_w + t44*x1_1_on_boundary_by_w + t45*x2_1_on_boundary_by_w
    carried_v1_2_by_y = t40*v1_1_on_boundary_by_y + t41*v2_1_on_boundary_by_y + t48*x1_1_on_boundary_by_y + t49*x2_1_on_boundary_by_y
    carried_v1_2_by_u = t40*v1_1_on_boundary_by_u + t41*v2_1_on_boundary_by_u + t48*x1_1_on_boundary_by_u + t49*x2_1_on_boundary_by_u
    carried_v1_2_by_w = t40*v1_1_on_boundary_by_w + t41*v2_1_on_boundary_by_w + t48*x1_1_on_boundary_by_w + t49*x2_1_on_boundary_by_w
    carried_v2_2_by_y = t44*v1_1_on_boundary_by_y + t45*v2_1_on_boundary_by_y + t50*x1_1_on_boundary_by_y + t51*x2_1_on_boundary_by_y
    carried_v2_2_by_u = t44*v1_1_on_boundary_by_u + t45*v2_1_on_boundary_by_u + t50*x1_1_on_boundary_by_u + t51*x2_1_on_boundary_by_u
    carried_v2_2_by_w = t44*v1_1_on_boundary_by_w + t45*v2_1_on_boundary_by_w + t50*x1_1_on_boundary_by_w + t51*x2_1_on_boundary_by_w
    # derivatives of the time to the boundary after tau1
    t62 = 1/v1_2
    delay_tau1_by_y = -carried_x1_2_by_y*t62
    delay_tau1_by_u = -carried_x1_2_by_u*t62
    delay_tau1_by_w = -carried_x1_2_by_w*t62
    # perturbation on the boundary after tau1
    x2_2_on_boundary_by_y = carried_x2_2_by_y + delay_tau1_by_y*v2_2
    x2_2_on_boundary_by_u = carried_x2_2_by_u + delay_tau1_by_u*v2_2
    x2_2_on_boundary_by_w = carried_x2_2_by_w + delay_tau1_by_w*v2_2
    t63 = k1*t53*x2_2 - t55*x1_2
    v1_2_on_boundary_by_y = carried_v1_2_by_y + delay_tau1_by_y*t63
    v1_2_on_boundary_by_u = carried_v1_2_by_u + delay_tau1_by_u*t63
    v1_2_on_boundary_by_w = carried_v1_2_by_w + delay_tau1_by_w*t63
    t64 = t59*x1_2 - t60*x2_2
    v2_2_on_boundary_by_y = carried_v2_2_by_y + delay_tau1_by_y*t64
    v2_2_on_boundary_by_u = carried_v2_2_by_u + delay_tau1_by_u*t64
    v2_2_on_boundary_by_w = carried_v2_2_by_w + delay_tau1_by_w*t64
    poincare_jacobian = [[x2_2_on_boundary_by_y, x2_2_on_boundary_by_u, x2_2_on_boundary_by_w], [v1_2_on_boundary_by_y, v1_2_on_boundary_by_u, v1_2_on_boundary_by_w], [v2_2_on_boundary_by_y, v2_2_on_boundary_by_u, v2_2_on_boundary_by_w]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 1
    before_v1_1 = t57
    before_v2_1 = t61
    behind_v1_1 = k1*t53*x2_1 - t55*x1_1
    behind_v2_1 = t61
    # vector fields at transition 2
    before_v1_2 = t63
    before_v2_2 = t64
    behind_v1_2 = t54 + t55*x2_2 - t56*x1_2
    behind_v2_2 = t64
    # saltations
    t65 = 1/v1_1
    t66 = t65*(before_v1_1 - behind_v1_1)
    t67 = t65*(before_v2_1 - behind_v2_1)
    t68 = t62*(-before_v1_2 + behind_v1_2)
    t69 = t62*(-before_v2_2 + behind_v2_2)
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [-t66, 0, 1, 0], [-t67, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [t68, 0, 1, 0], [t69, 0, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
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
    saltation_1_20 = -phi_1_00*t66 + phi_1_20
    saltation_1_21 = -phi_1_01*t66 + phi_1_21
    saltation_1_22 = -phi_1_02*t66 + phi_1_22
    saltation_1_23 = -phi_1_03*t66 + phi_1_23
    saltation_1_30 = -phi_1_00*t67 + phi_1_30
    saltation_1_31 = -phi_1_01*t67 + phi_1_31
    saltation_1_32 = -phi_1_02*t67 + phi_1_32
    saltation_1_33 = -phi_1_03*t67 + phi_1_33
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
    phi_2_30 = phi_1_00*t50 + phi_1_10*t51 + saltation_1_20*t44 + saltation_1_30*t45
    phi_2_31 = phi_1_01*t50 + phi_1_11*t51 + saltation_1_21*t44 + saltation_1_31*t45
    phi_2_32 = phi_1_02*t50 + phi_1_12*t51 + saltation_1_22*t44 + saltation_1_32*t45
    phi_2_33 = phi_1_03*t50 + phi_1_13*t51 + saltation_1_23*t44 + saltation_1_33*t45
    # saltation of phase 2
    saltation_2_20 = phi_2_00*t68 + phi_2_20
    saltation_2_21 = phi_2_01*t68 + phi_2_21
    saltation_2_22 = phi_2_02*t68 + phi_2_22
    saltation_2_23 = phi_2_03*t68 + phi_2_23
    saltation_2_30 = phi_2_00*t69 + phi_2_30
    saltation_2_31 = phi_2_01*t69 + phi_2_31
    saltation_2_32 = phi_2_02*t69 + phi_2_32
    saltation_2_33 = phi_2_03*t69 + phi_2_33
    monodromy = [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [phi_2_10, phi_2_11, phi_2_12, phi_2_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]
    return poincare_jacobian, saltations, monodromy


def one_contact_flow_contact(parameters, spectrum, time, state, *, lib):
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
    # state_after
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


def one_contact_flow_free(parameters, spectrum, time, state, *, lib):
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
    # state_after
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
    Operations: 446. Intermediate terms: 137.
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
    t20 = p1 - 1
    coefficient12 = cos_omega1_half_tau*p1 - cos_omega2_half_tau*t20
    coefficient13 = cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2
    t23 = p1*t12
    t24 = p1*t13
    t25 = p1*t14 + t23 + t24
    t26 = -t12 - t13 - t14 + t25
    t27 = t15*t19
    t28 = omega2*sin_omega2_half_tau*t15
    coefficient21 = -t25*t28 + t26*t27
    coefficient22 = cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3
    coefficient23 = -cos_omega1_half_tau*t20 + cos_omega2_half_tau*p1
    t29 = omega3*sin_omega3_half_tau1
    coefficient31 = omega4*p5*sin_omega4_half_tau1 - p5*t29
    t30 = p4 - 1
    coefficient32 = -cos_omega3_half_tau1*p4 + cos_omega4_half_tau1*t30
    coefficient33 = -cos_omega3_half_tau1*p5 + cos_omega4_half_tau1*p5
    # right-hand sides of the linear equations
    t31 = -t16 + t23
    t32 = k1*k2*p1 - t12 - t16
    right1 = t27*t31 - t28*t32
    t33 = p3*t12 + t24
    t34 = t13 - t33
    right2 = -omega2*sin_omega2_half_tau*t15*t33 - t27*t34
    t36 = omega4*sin_omega4_half_tau1
    right3 = p4*t29 - t30*t36
    # determinant of the linear equations
    t37 = coefficient22*coefficient33
    t38 = coefficient21*coefficient32
    t39 = coefficient23*coefficient32
    t40 = coefficient21*coefficient33
    t41 = coefficient22*coefficient31
    determinant = coefficient11*t37 - coefficient11*t39 + coefficient12*coefficient23*coefficient31 - coefficient12*t40 + coefficient13*t38 - coefficient13*t41
    # numerators of Cramer's rule
    t42 = coefficient12*coefficient23
    t43 = coefficient12*coefficient33
    t44 = coefficient13*coefficient22
    numerator1 = coefficient13*coefficient32*right2 + right1*t37 - right1*t39 - right2*t43 + right3*t42 - right3*t44
    t45 = coefficient11*coefficient23
    t46 = coefficient13*coefficient31
    numerator2 = coefficient11*coefficient33*right2 + coefficient13*coefficient21*right3 + coefficient23*coefficient31*right1 - right1*t40 - right2*t46 - right3*t45
    t47 = coefficient11*coefficient22
    t48 = coefficient11*coefficient32
    t49 = coefficient12*coefficient21
    numerator3 = coefficient12*coefficient31*right2 + right1*t38 - right1*t41 - right2*t48 + right3*t47 - right3*t49
    # y, u, w by Cramer's rule
    t50 = 1/determinant
    y = numerator1*t50
    u = numerator2*t50
    w = numerator3*t50
    unknowns = [y, u, w, tau]
    if outputs == 1:
        return unknowns
    # determinants
    t77 = 2*p2**2
    t78 = half_tau**2
    t79 = t77*t78
    t80 = omega1**4/(omega1**2*t78 + 1)
    t81 = omega2**4/(omega2**2*t78 + 1)
    t82 = p1**2
    t83 = t20**2 + t82
    t84 = 2*t78
    t85 = 2*p5**2
    t86 = half_tau1**2
    t87 = t85*t86
    determinants = [determinant/(lib.sqrt(2*p3**2 + t20**2*t80*t84 + t81*t82*t84 + t83)*lib.sqrt(t77 + t79*t80 + t79*t81 + t83)*lib.sqrt(omega3**4*t87/(omega3**2*t86 + 1) + omega4**4*t87/(omega4**2*t86 + 1) + p4**2 + t30**2 + t85))]
    if outputs == 2:
        return unknowns, determinants
    # reduced_residual
    t88 = omega4*p6*sin_omega4_half_tau1 - p6*t29
    t89 = -p4*t36 + t29*t30
    t90 = -cos_omega3_half_tau1*p6 + cos_omega4_half_tau1*p6
    t91 = cos_omega3_half_tau1*t30 - cos_omega4_half_tau1*p4
    reduced_residual = [determinant*t88 + numerator1*t89 + numerator2*t90 + numerator3*t91]
    if outputs == 3:
        return unknowns, determinants, reduced_residual
    # d/dtau of: functions of half_tau in contact
    t51 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t51
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t51
    t52 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t52
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t52
    # d/dtau of: functions of half_tau1 in free
    t53 = omega3/2
    cos_omega3_half_tau1_by_tau = sin_omega3_half_tau1*t53
    sin_omega3_half_tau1_by_tau = -cos_omega3_half_tau1*t53
    t54 = omega4/2
    cos_omega4_half_tau1_by_tau = sin_omega4_half_tau1*t54
    sin_omega4_half_tau1_by_tau = -cos_omega4_half_tau1*t54
    # d/dtau of: coefficients of the linear equations
    t55 = omega1*sin_omega1_half_tau_by_tau
    coefficient11_by_tau = omega2*sin_omega2_half_tau_by_tau*t15*t17 - t18*t55
    coefficient12_by_tau = cos_omega1_half_tau_by_tau*p1 - cos_omega2_half_tau_by_tau*t20
    coefficient13_by_tau = cos_omega1_half_tau_by_tau*p2 - cos_omega2_half_tau_by_tau*p2
    t56 = t15*t55
    t57 = omega2*sin_omega2_half_tau_by_tau*t15
    coefficient21_by_tau = -t25*t57 + t26*t56
    coefficient22_by_tau = cos_omega1_half_tau_by_tau*p3 - cos_omega2_half_tau_by_tau*p3
    coefficient23_by_tau = -cos_omega1_half_tau_by_tau*t20 + cos_omega2_half_tau_by_tau*p1
    t58 = omega3*sin_omega3_half_tau1_by_tau
    coefficient31_by_tau = omega4*p5*sin_omega4_half_tau1_by_tau - p5*t58
    coefficient32_by_tau = -cos_omega3_half_tau1_by_tau*p4 + cos_omega4_half_tau1_by_tau*t30
    coefficient33_by_tau = -cos_omega3_half_tau1_by_tau*p5 + cos_omega4_half_tau1_by_tau*p5
    # d/dtau of: right-hand sides of the linear equations
    right1_by_tau = t31*t56 - t32*t57
    right2_by_tau = -omega2*sin_omega2_half_tau_by_tau*t15*t33 - t34*t56
    right3_by_tau = -omega4*sin_omega4_half_tau1_by_tau*t30 + p4*t58
    # d/dtau of: determinant of the linear equations
    t59 = t37 - t39
    t60 = coefficient23*coefficient31 - t40
    t61 = t38 - t41
    t62 = coefficient13*coefficient32 - t43
    t63 = coefficient11*coefficient33 - t46
    t64 = coefficient12*coefficient31 - t48
    t65 = t42 - t44
    t66 = coefficient13*coefficient21 - t45
    t67 = t47 - t49
    determinant_by_tau = coefficient11_by_tau*t59 + coefficient12_by_tau*t60 + coefficient13_by_tau*t61 + coefficient21_by_tau*t62 + coefficient22_by_tau*t63 + coefficient23_by_tau*t64 + coefficient31_by_tau*t65 + coefficient32_by_tau*t66 + coefficient33_by_tau*t67
    # d/dtau of: numerators of Cramer's rule
    t68 = coefficient23*right3 - coefficient33*right2
    t69 = coefficient22*right3 - coefficient32*right2
    t70 = coefficient13*right3 - coefficient33*right1
    t71 = coefficient12*right3 - coefficient32*right1
    t72 = coefficient13*right2 - coefficient23*right1
    t73 = coefficient12*right2 - coefficient22*right1
    numerator1_by_tau = coefficient12_by_tau*t68 - coefficient13_by_tau*t69 - coefficient22_by_tau*t70 + coefficient23_by_tau*t71 + coefficient32_by_tau*t72 - coefficient33_by_tau*t73 + right1_by_tau*t59 + right2_by_tau*t62 + right3_by_tau*t65
    t74 = coefficient21*right3 - coefficient31*right2
    t75 = coefficient11*right3 - coefficient31*right1
    t76 = coefficient11*right2 - coefficient21*right1
    numerator2_by_tau = -coefficient11_by_tau*t68 + coefficient13_by_tau*t74 + coefficient21_by_tau*t70 - coefficient23_by_tau*t75 - coefficient31_by_tau*t72 + coefficient33_by_tau*t76 + right1_by_tau*t60 + right2_by_tau*t63 + right3_by_tau*t66
    numerator3_by_tau = coefficient11_by_tau*t69 - coefficient12_by_tau*t74 - coefficient21_by_tau*t71 + coefficient22_by_tau*t75 + coefficient31_by_tau*t73 - coefficient32_by_tau*t76 + right1_by_tau*t61 + right2_by_tau*t64 + right3_by_tau*t67
    # reduced_jacobian
    t92 = numerator2*p6
    t93 = determinant*p6
    reduced_jacobian = [[cos_omega3_half_tau1_by_tau*(numerator3*t30 - t92) + cos_omega4_half_tau1_by_tau*(-numerator3*p4 + t92) + determinant_by_tau*t88 + numerator1_by_tau*t89 + numerator2_by_tau*t90 + numerator3_by_tau*t91 + sin_omega3_half_tau1_by_tau*(numerator1*omega3*t30 - omega3*t93) + sin_omega4_half_tau1_by_tau*(-numerator1*omega4*p4 + omega4*t93)]]
    return unknowns, determinants, reduced_residual, reduced_jacobian
