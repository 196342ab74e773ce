# Generated; do not edit.
# Source: nonsmooth.derive.systems.dry_friction
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation 589b5b148a78a35d
"""Kernels and tables of the system dry-friction, over any arithmetic ``lib``."""

DERIVATION = "589b5b148a78a35d"

SYSTEM = {'name': 'dry-friction',
 'description': 'two coupled oscillators on a driving belt with dry friction (Sec. 3)',
 'states': ['x1', 'x2', 'v1', 'v2'],
 'parameters': [{'name': 'chi',
                 'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                 'lower': '0',
                 'upper': '1',
                 'closed': False},
                {'name': 'eta',
                 'description': 'mass ratio m1/m2, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False},
                {'name': 'V',
                 'description': 'velocity of the belt, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False},
                {'name': 'us1',
                 'description': 'slipping friction force on the first mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False},
                {'name': 'ur1',
                 'description': 'static friction force on the first mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False},
                {'name': 'us2',
                 'description': 'slipping friction force on the second mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False},
                {'name': 'ur2',
                 'description': 'static friction force on the second mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False}],
 'constraints': [{'text': 'ur1 - us1 >= 0', 'terms': {'ur1': 1, 'us1': -1}},
                 {'text': 'ur2 - us2 >= 0', 'terms': {'ur2': 1, 'us2': -1}}],
 'configurations': {'slip-slip': [{'name': 'first-reaches-belt', 'acts_when': 'reached'},
                                  {'name': 'second-reaches-belt', 'acts_when': 'reached'}],
                    'slip-stick': [{'name': 'first-reaches-belt', 'acts_when': 'reached'},
                                   {'name': 'second-breaks-forward', 'acts_when': 'exceeded'},
                                   {'name': 'second-breaks-backward', 'acts_when': 'exceeded'}],
                    'slip-overshoot': [{'name': 'first-reaches-belt', 'acts_when': 'reached'},
                                       {'name': 'second-reaches-belt', 'acts_when': 'reached'}],
                    'stick-slip': [{'name': 'first-breaks-forward', 'acts_when': 'exceeded'},
                                   {'name': 'first-breaks-backward', 'acts_when': 'exceeded'},
                                   {'name': 'second-reaches-belt', 'acts_when': 'reached'}],
                    'stick-stick': [{'name': 'first-breaks-forward', 'acts_when': 'exceeded'},
                                    {'name': 'first-breaks-backward', 'acts_when': 'exceeded'},
                                    {'name': 'second-breaks-forward', 'acts_when': 'exceeded'},
                                    {'name': 'second-breaks-backward',
                                     'acts_when': 'exceeded'}],
                    'stick-overshoot': [{'name': 'first-breaks-forward',
                                         'acts_when': 'exceeded'},
                                        {'name': 'first-breaks-backward',
                                         'acts_when': 'exceeded'},
                                        {'name': 'second-reaches-belt',
                                         'acts_when': 'reached'}],
                    'overshoot-slip': [{'name': 'first-reaches-belt', 'acts_when': 'reached'},
                                       {'name': 'second-reaches-belt', 'acts_when': 'reached'}],
                    'overshoot-stick': [{'name': 'first-reaches-belt', 'acts_when': 'reached'},
                                        {'name': 'second-breaks-forward',
                                         'acts_when': 'exceeded'},
                                        {'name': 'second-breaks-backward',
                                         'acts_when': 'exceeded'}],
                    'overshoot-overshoot': [{'name': 'first-reaches-belt',
                                             'acts_when': 'reached'},
                                            {'name': 'second-reaches-belt',
                                             'acts_when': 'reached'}]},
 'transitions': [('slip-slip', ['second-reaches-belt'], 'slip-slip'),
                 ('slip-slip', ['second-reaches-belt'], 'slip-overshoot'),
                 ('slip-slip', ['second-reaches-belt'], 'slip-stick'),
                 ('slip-slip', ['first-reaches-belt'], 'slip-slip'),
                 ('slip-slip', ['first-reaches-belt'], 'overshoot-slip'),
                 ('slip-slip', ['first-reaches-belt'], 'stick-slip'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'slip-slip'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'slip-overshoot'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'slip-stick'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'overshoot-slip'),
                 ('slip-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('slip-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'stick-slip'),
                 ('slip-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('slip-slip', ['first-reaches-belt', 'second-reaches-belt'], 'stick-stick'),
                 ('slip-stick', ['second-breaks-forward'], 'slip-slip'),
                 ('slip-stick', ['second-breaks-forward'], 'slip-overshoot'),
                 ('slip-stick', ['second-breaks-forward'], 'slip-stick'),
                 ('slip-stick', ['second-breaks-backward'], 'slip-slip'),
                 ('slip-stick', ['second-breaks-backward'], 'slip-overshoot'),
                 ('slip-stick', ['second-breaks-backward'], 'slip-stick'),
                 ('slip-stick', ['first-reaches-belt'], 'slip-stick'),
                 ('slip-stick', ['first-reaches-belt'], 'overshoot-stick'),
                 ('slip-stick', ['first-reaches-belt'], 'stick-stick'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-forward'], 'slip-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'slip-overshoot'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-forward'], 'slip-stick'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-overshoot'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-stick'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-forward'], 'stick-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'stick-overshoot'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-forward'], 'stick-stick'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-backward'], 'slip-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'slip-overshoot'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-backward'], 'slip-stick'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-overshoot'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-stick'),
                 ('slip-stick', ['first-reaches-belt', 'second-breaks-backward'], 'stick-slip'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'stick-overshoot'),
                 ('slip-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'stick-stick'),
                 ('slip-overshoot', ['second-reaches-belt'], 'slip-slip'),
                 ('slip-overshoot', ['second-reaches-belt'], 'slip-overshoot'),
                 ('slip-overshoot', ['second-reaches-belt'], 'slip-stick'),
                 ('slip-overshoot', ['first-reaches-belt'], 'slip-overshoot'),
                 ('slip-overshoot', ['first-reaches-belt'], 'overshoot-overshoot'),
                 ('slip-overshoot', ['first-reaches-belt'], 'stick-overshoot'),
                 ('slip-overshoot', ['first-reaches-belt', 'second-reaches-belt'], 'slip-slip'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-stick'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-slip'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('slip-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-stick'),
                 ('stick-slip', ['second-reaches-belt'], 'stick-slip'),
                 ('stick-slip', ['second-reaches-belt'], 'stick-overshoot'),
                 ('stick-slip', ['second-reaches-belt'], 'stick-stick'),
                 ('stick-slip', ['first-breaks-forward'], 'slip-slip'),
                 ('stick-slip', ['first-breaks-forward'], 'overshoot-slip'),
                 ('stick-slip', ['first-breaks-forward'], 'stick-slip'),
                 ('stick-slip', ['first-breaks-forward', 'second-reaches-belt'], 'slip-slip'),
                 ('stick-slip',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('stick-slip', ['first-breaks-forward', 'second-reaches-belt'], 'slip-stick'),
                 ('stick-slip',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('stick-slip',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('stick-slip',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('stick-slip', ['first-breaks-forward', 'second-reaches-belt'], 'stick-slip'),
                 ('stick-slip',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('stick-slip', ['first-breaks-forward', 'second-reaches-belt'], 'stick-stick'),
                 ('stick-slip', ['first-breaks-backward'], 'slip-slip'),
                 ('stick-slip', ['first-breaks-backward'], 'overshoot-slip'),
                 ('stick-slip', ['first-breaks-backward'], 'stick-slip'),
                 ('stick-slip', ['first-breaks-backward', 'second-reaches-belt'], 'slip-slip'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('stick-slip', ['first-breaks-backward', 'second-reaches-belt'], 'slip-stick'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('stick-slip', ['first-breaks-backward', 'second-reaches-belt'], 'stick-slip'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('stick-slip',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'stick-stick'),
                 ('stick-stick', ['second-breaks-forward'], 'stick-slip'),
                 ('stick-stick', ['second-breaks-forward'], 'stick-overshoot'),
                 ('stick-stick', ['second-breaks-forward'], 'stick-stick'),
                 ('stick-stick', ['second-breaks-backward'], 'stick-slip'),
                 ('stick-stick', ['second-breaks-backward'], 'stick-overshoot'),
                 ('stick-stick', ['second-breaks-backward'], 'stick-stick'),
                 ('stick-stick', ['first-breaks-forward'], 'slip-stick'),
                 ('stick-stick', ['first-breaks-forward'], 'overshoot-stick'),
                 ('stick-stick', ['first-breaks-forward'], 'stick-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'slip-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'slip-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'slip-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'overshoot-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'overshoot-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'overshoot-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'stick-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'stick-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-forward'],
                  'stick-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'slip-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'slip-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'slip-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'overshoot-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'overshoot-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'overshoot-stick'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'stick-slip'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'stick-overshoot'),
                 ('stick-stick',
                  ['first-breaks-forward', 'second-breaks-backward'],
                  'stick-stick'),
                 ('stick-stick', ['first-breaks-backward'], 'slip-stick'),
                 ('stick-stick', ['first-breaks-backward'], 'overshoot-stick'),
                 ('stick-stick', ['first-breaks-backward'], 'stick-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'slip-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'slip-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'slip-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'overshoot-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'overshoot-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'overshoot-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'stick-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'stick-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-forward'],
                  'stick-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'slip-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'slip-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'slip-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'overshoot-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'overshoot-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'overshoot-stick'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'stick-slip'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'stick-overshoot'),
                 ('stick-stick',
                  ['first-breaks-backward', 'second-breaks-backward'],
                  'stick-stick'),
                 ('stick-overshoot', ['second-reaches-belt'], 'stick-slip'),
                 ('stick-overshoot', ['second-reaches-belt'], 'stick-overshoot'),
                 ('stick-overshoot', ['second-reaches-belt'], 'stick-stick'),
                 ('stick-overshoot', ['first-breaks-forward'], 'slip-overshoot'),
                 ('stick-overshoot', ['first-breaks-forward'], 'overshoot-overshoot'),
                 ('stick-overshoot', ['first-breaks-forward'], 'stick-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'slip-slip'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'slip-stick'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'stick-slip'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-forward', 'second-reaches-belt'],
                  'stick-stick'),
                 ('stick-overshoot', ['first-breaks-backward'], 'slip-overshoot'),
                 ('stick-overshoot', ['first-breaks-backward'], 'overshoot-overshoot'),
                 ('stick-overshoot', ['first-breaks-backward'], 'stick-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'slip-slip'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'slip-stick'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'stick-slip'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('stick-overshoot',
                  ['first-breaks-backward', 'second-reaches-belt'],
                  'stick-stick'),
                 ('overshoot-slip', ['second-reaches-belt'], 'overshoot-slip'),
                 ('overshoot-slip', ['second-reaches-belt'], 'overshoot-overshoot'),
                 ('overshoot-slip', ['second-reaches-belt'], 'overshoot-stick'),
                 ('overshoot-slip', ['first-reaches-belt'], 'slip-slip'),
                 ('overshoot-slip', ['first-reaches-belt'], 'overshoot-slip'),
                 ('overshoot-slip', ['first-reaches-belt'], 'stick-slip'),
                 ('overshoot-slip', ['first-reaches-belt', 'second-reaches-belt'], 'slip-slip'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-stick'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-slip'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('overshoot-slip',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-stick'),
                 ('overshoot-stick', ['second-breaks-forward'], 'overshoot-slip'),
                 ('overshoot-stick', ['second-breaks-forward'], 'overshoot-overshoot'),
                 ('overshoot-stick', ['second-breaks-forward'], 'overshoot-stick'),
                 ('overshoot-stick', ['second-breaks-backward'], 'overshoot-slip'),
                 ('overshoot-stick', ['second-breaks-backward'], 'overshoot-overshoot'),
                 ('overshoot-stick', ['second-breaks-backward'], 'overshoot-stick'),
                 ('overshoot-stick', ['first-reaches-belt'], 'slip-stick'),
                 ('overshoot-stick', ['first-reaches-belt'], 'overshoot-stick'),
                 ('overshoot-stick', ['first-reaches-belt'], 'stick-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'slip-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'slip-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'slip-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'overshoot-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'stick-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'stick-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-forward'],
                  'stick-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'slip-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'slip-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'slip-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'overshoot-stick'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'stick-slip'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'stick-overshoot'),
                 ('overshoot-stick',
                  ['first-reaches-belt', 'second-breaks-backward'],
                  'stick-stick'),
                 ('overshoot-overshoot', ['second-reaches-belt'], 'overshoot-slip'),
                 ('overshoot-overshoot', ['second-reaches-belt'], 'overshoot-overshoot'),
                 ('overshoot-overshoot', ['second-reaches-belt'], 'overshoot-stick'),
                 ('overshoot-overshoot', ['first-reaches-belt'], 'slip-overshoot'),
                 ('overshoot-overshoot', ['first-reaches-belt'], 'overshoot-overshoot'),
                 ('overshoot-overshoot', ['first-reaches-belt'], 'stick-overshoot'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-slip'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-overshoot'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'slip-stick'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-slip'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-overshoot'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'overshoot-stick'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-slip'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-overshoot'),
                 ('overshoot-overshoot',
                  ['first-reaches-belt', 'second-reaches-belt'],
                  'stick-stick')],
 'spectrum': ['gap1', 'omega1', 'omega2', 'p1', 'p2', 'p3', 'omega3'],
 'spectrum_parameters': ['chi', 'eta']}

ORBITS = {'global-stick': {'phases': [('stick-stick', 'first-breaks-forward', 'ta'),
                             ('slip-stick', 'second-breaks-forward', 'tau'),
                             ('slip-slip', 'first-reaches-belt', 'tau1'),
                             ('stick-slip', 'second-reaches-belt', 'tau2')],
                  'states': ['z1', 'z2', 'v1', 'v2'],
                  'parameters': [{'name': 'chi',
                                  'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                                  'lower': '0',
                                  'upper': '1',
                                  'closed': False},
                                 {'name': 'eta',
                                  'description': 'mass ratio m1/m2, nondimensional',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': False},
                                 {'name': 'V',
                                  'description': 'velocity of the belt, nondimensional',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': False},
                                 {'name': 'e1',
                                  'description': 'excess ur1 - us1 of static over slipping '
                                                 'friction',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': True},
                                 {'name': 'e2',
                                  'description': 'excess ur2 - us2 of static over slipping '
                                                 'friction',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': True}],
                  'open_parameters': [{'name': 'us1',
                                       'description': 'slipping friction force on the first '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False},
                                      {'name': 'us2',
                                       'description': 'slipping friction force on the second '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False}],
                  'combined': {'e1': {'ur1': 1, 'us1': -1}, 'e2': {'ur2': 1, 'us2': -1}},
                  'unknowns': ['z10', 'z20', 'ta', 'tau', 'tau1', 'tau2'],
                  'dwell_times': ['ta', 'tau', 'tau1', 'tau2'],
                  'equations': ['first-breaks-forward ends stick-stick',
                                'second-breaks-forward ends slip-stick',
                                'first-reaches-belt ends slip-slip',
                                'second-reaches-belt ends stick-slip',
                                'z10 returns',
                                'z20 returns'],
                  'reduced': ['tau', 'tau1'],
                  'eliminated': {'z2_1': 'linear in second-breaks-forward',
                                 'tau2': 'first return',
                                 'ta': 'linear in time'},
                  'rank': 1,
                  'section': ['z10', 'z20'],
                  'terms': [0, 1, 2, 1],
                  'boundaries': [(0, 'first-breaks-forward', None, 0.0),
                                 (0, 'first-breaks-backward', 'us1', -2.0),
                                 (0, 'second-breaks-forward', None, 0.0),
                                 (0, 'second-breaks-backward', 'us2', -2.0),
                                 (1, 'first-reaches-belt', None, 0.0),
                                 (1, 'second-breaks-forward', None, 0.0),
                                 (1, 'second-breaks-backward', 'us2', -2.0),
                                 (2, 'first-reaches-belt', None, 0.0),
                                 (2, 'second-reaches-belt', None, 0.0),
                                 (3, 'first-breaks-forward', None, 0.0),
                                 (3, 'first-breaks-backward', 'us1', -2.0),
                                 (3, 'second-reaches-belt', None, 0.0)],
                  'reference': {'parameters': {'chi': '0.5',
                                               'eta': '1',
                                               'V': '1',
                                               'e1': '3.0195',
                                               'e2': '0.4831'},
                                'guess': {'z10': '1.1838',
                                          'z20': '-2.6715',
                                          'ta': '1',
                                          'tau': '2',
                                          'tau1': '1.568',
                                          'tau2': '3.28'}}}}

KERNELS = {'spectrum': ([(2,)], [(7,), (7, 2)]),
 'flow_slip_slip': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_slip_stick': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_slip_overshoot': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_stick_slip': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_stick_stick': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_stick_overshoot': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_overshoot_slip': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_overshoot_stick': ([(7,), (7,), (), (4,)], [(4,)]),
 'flow_overshoot_overshoot': ([(7,), (7,), (), (4,)], [(4,)]),
 'global_stick_residual': ([(5,), (7,), (6,)], [(6,)]),
 'global_stick_jacobian': ([(5,), (7,), (6,)], [(6, 6)]),
 'global_stick_residual_and_jacobian': ([(5,), (7,), (6,)], [(6,), (6, 6)]),
 'global_stick_parameter_jacobian': ([(5,), (7,), (7, 2), (6,)], [(6, 5)]),
 'global_stick_poincare_jacobian': ([(5,), (7,), (6,)], [(2, 2)]),
 'global_stick_trace': ([(5,), (7,), (6,)], [()]),
 'global_stick_trace_gradient': ([(5,), (7,), (7, 2), (6,)], [(11,)]),
 'global_stick_states': ([(5,), (7,), (6,)], [(5, 4)]),
 'global_stick_boundary_functions': ([(5,), (7,), (6,)], [(44,), (4,)]),
 'global_stick_flow_stick_stick': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_slip_stick': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_slip_slip': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_stick_slip': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_reduced': ([(5,), (7,), (2,)], [(2,), (2, 2)]),
 'global_stick_expand': ([(5,), (7,), (2,)], [(6,)])}

def spectrum(parameters, lib):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (2): chi, eta.
    Gives spectrum (7).
    Gives derivatives (7, 2).
    Operations: 97. Intermediate terms: 45.
    """
    [chi, eta] = parameters
    # spectrum
    t0 = chi*eta
    t1 = 1 - t0
    t2 = 4*chi**2
    gap1 = lib.sqrt(eta*t2 + t1**2)
    omega1 = lib.sqrt(gap1/2 + t0/2 + lib.rational(1, 2))
    t3 = 1/omega1
    t4 = lib.sqrt(1 - chi)
    t5 = lib.sqrt(chi)
    t6 = lib.sqrt(eta)
    t7 = t5*t6
    t8 = t4*t7
    omega2 = t3*t8
    t9 = 1/gap1
    t10 = t9/2
    p1 = t1*t10 + lib.rational(1, 2)
    t11 = chi*t9
    p2 = -t11
    p3 = -t0*t9
    omega3 = t7
    # d/dchi of: spectrum
    t13 = 2*t1
    gap1_by_chi = t10*(-eta*t13 + 8*t0)
    t14 = gap1_by_chi/2
    t15 = eta/2
    t16 = t3/2
    omega1_by_chi = t16*(t14 + t15)
    t17 = 1/t5
    t18 = t8/omega1**2
    omega2_by_chi = -omega1_by_chi*t18 - t16*t7/t4 + t17*t3*t4*t6/2
    t19 = 1/gap1**2
    t20 = t1*t19
    p1_by_chi = -t14*t20 - t15*t9
    t21 = chi*t19
    p2_by_chi = gap1_by_chi*t21 - t9
    t22 = t0*t19
    p3_by_chi = -eta*t9 + gap1_by_chi*t22
    omega3_by_chi = t17*t6/2
    # d/deta of: spectrum
    gap1_by_eta = t10*(-chi*t13 + t2)
    t23 = gap1_by_eta/2
    omega1_by_eta = t16*(chi/2 + t23)
    t24 = 1/t6
    omega2_by_eta = -omega1_by_eta*t18 + t24*t3*t4*t5/2
    p1_by_eta = -t11/2 - t20*t23
    p2_by_eta = gap1_by_eta*t21
    p3_by_eta = gap1_by_eta*t22 - t11
    omega3_by_eta = t24*t5/2
    return (
        [gap1, omega1, omega2, p1, p2, p3, omega3],
        [[gap1_by_chi, gap1_by_eta], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]],
    )


def flow_slip_slip(parameters, spectrum, time, state, lib):
    """State after a time in slip-slip.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 138. Intermediate terms: 26.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
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
    t13 = 1/(chi - 1)
    t14 = -us1 - us2
    t15 = t13*t14
    t16 = 1/(chi**2 - chi)
    t17 = -chi*us1 - us2
    t18 = t16*t17
    t19 = p2*t18
    t20 = p1*t15
    t21 = -p3*t10 + p3*t9
    t22 = p1*t10 - t4*t9
    t23 = p1*t18
    t24 = p3*t15
    t25 = omega2*t7
    t26 = omega1*t1
    return [t10*(t15*t4 + t19) + t11*x1 + t12*x2 + t15 + t9*(-t19 - t20) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(-t23 + t24) + t18 + t21*x1 + t22*x2 + t9*(t16*t17*t4 - t24) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t19 + omega1*t20) + t11*v1 + t12*v2 + t7*(-omega2*t13*t14*t4 - omega2*t19) + x1*(-p1*t26 + t25*t4) + x2*(omega2*p2*t7 - p2*t26), t1*(-omega1*t18*t4 + omega1*t24) + t21*v1 + t22*v2 + t7*(omega2*t23 - omega2*t24) + x1*(omega2*p3*t7 - p3*t26) + x2*(-p1*t25 + t26*t4)]


def flow_slip_stick(parameters, spectrum, time, state, lib):
    """State after a time in slip-stick.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 28. Intermediate terms: 4.
    """
    [chi, _, _, us1, _, _, _] = parameters
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 - t2*us1 + t2*x1 + t3*x2 + us1 + v2*(chi*t - t1), t*v2 + x2, t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_slip_overshoot(parameters, spectrum, time, state, lib):
    """State after a time in slip-overshoot.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 136. Intermediate terms: 26.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
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
    t13 = 1/(chi - 1)
    t15 = -us1 + us2
    t16 = t13*t15
    t17 = 1/(chi**2 - chi)
    t18 = -chi*us1 + us2
    t19 = t17*t18
    t20 = p2*t19
    t21 = p1*t16
    t22 = -p3*t10 + p3*t9
    t23 = p1*t10 - t4*t9
    t24 = p1*t19
    t25 = p3*t16
    t26 = omega2*t7
    t27 = omega1*t1
    return [t10*(t16*t4 + t20) + t11*x1 + t12*x2 + t16 + t9*(-t20 - t21) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(-t24 + t25) + t19 + t22*x1 + t23*x2 + t9*(t17*t18*t4 - t25) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t20 + omega1*t21) + t11*v1 + t12*v2 + t7*(-omega2*t13*t15*t4 - omega2*t20) + x1*(-p1*t27 + t26*t4) + x2*(omega2*p2*t7 - p2*t27), t1*(-omega1*t19*t4 + omega1*t25) + t22*v1 + t23*v2 + t7*(omega2*t24 - omega2*t25) + x1*(omega2*p3*t7 - p3*t27) + x2*(-p1*t26 + t27*t4)]


def flow_stick_slip(parameters, spectrum, time, state, lib):
    """State after a time in stick-slip.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 29. Intermediate terms: 7.
    """
    [chi, _, _, _, _, us2, _] = parameters
    [_, _, _, _, _, _, omega3] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [t*v1 + x1, t2*v2 - t3*t5 + t3*x2 + t4*x1 + t5 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*t6 + t6*x1 - t6*x2]


def flow_stick_stick(parameters, spectrum, time, state, lib):
    """State after a time in stick-stick.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 4. Intermediate terms: 0.
    """
    t = time
    [x1, x2, v1, v2] = state
    return [t*v1 + x1, t*v2 + x2, v1, v2]


def flow_stick_overshoot(parameters, spectrum, time, state, lib):
    """State after a time in stick-overshoot.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 29. Intermediate terms: 7.
    """
    [chi, _, _, _, _, us2, _] = parameters
    [_, _, _, _, _, _, omega3] = spectrum
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [t*v1 + x1, t2*v2 + t3*t5 + t3*x2 + t4*x1 - t5 + v1*(t - t2), v1, t3*v2 + t4*v1 - t5*t6 + t6*x1 - t6*x2]


def flow_overshoot_slip(parameters, spectrum, time, state, lib):
    """State after a time in overshoot-slip.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 136. Intermediate terms: 26.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
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
    t13 = 1/(chi - 1)
    t15 = us1 - us2
    t16 = t13*t15
    t17 = 1/(chi**2 - chi)
    t18 = chi*us1 - us2
    t19 = t17*t18
    t20 = p2*t19
    t21 = p1*t16
    t22 = -p3*t10 + p3*t9
    t23 = p1*t10 - t4*t9
    t24 = p1*t19
    t25 = p3*t16
    t26 = omega2*t7
    t27 = omega1*t1
    return [t10*(t16*t4 + t20) + t11*x1 + t12*x2 + t16 + t9*(-t20 - t21) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(-t24 + t25) + t19 + t22*x1 + t23*x2 + t9*(t17*t18*t4 - t25) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t20 + omega1*t21) + t11*v1 + t12*v2 + t7*(-omega2*t13*t15*t4 - omega2*t20) + x1*(-p1*t27 + t26*t4) + x2*(omega2*p2*t7 - p2*t27), t1*(-omega1*t19*t4 + omega1*t25) + t22*v1 + t23*v2 + t7*(omega2*t24 - omega2*t25) + x1*(omega2*p3*t7 - p3*t27) + x2*(-p1*t26 + t27*t4)]


def flow_overshoot_stick(parameters, spectrum, time, state, lib):
    """State after a time in overshoot-stick.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 28. Intermediate terms: 4.
    """
    [chi, _, _, us1, _, _, _] = parameters
    t = time
    [x1, x2, v1, v2] = state
    # outputs
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*us1 + t2*x1 + t3*x2 - us1 + v2*(chi*t - t1), t*v2 + x2, -t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_overshoot_overshoot(parameters, spectrum, time, state, lib):
    """State after a time in overshoot-overshoot.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 136. Intermediate terms: 26.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
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
    t13 = 1/(chi - 1)
    t14 = us1 + us2
    t15 = t13*t14
    t16 = 1/(chi**2 - chi)
    t17 = chi*us1 + us2
    t18 = t16*t17
    t19 = p2*t18
    t20 = p1*t15
    t21 = -p3*t10 + p3*t9
    t22 = p1*t10 - t4*t9
    t23 = p1*t18
    t24 = p3*t15
    t25 = omega2*t7
    t26 = omega1*t1
    return [t10*(t15*t4 + t19) + t11*x1 + t12*x2 + t15 + t9*(-t19 - t20) + v1*(p1*t3 - t4*t8) + v2*(p2*t1*t2 - p2*t8), t10*(-t23 + t24) + t18 + t21*x1 + t22*x2 + t9*(t16*t17*t4 - t24) + v1*(p3*t1*t2 - p3*t8) + v2*(p1*t8 - t3*t4), t1*(omega1*t19 + omega1*t20) + t11*v1 + t12*v2 + t7*(-omega2*t13*t14*t4 - omega2*t19) + x1*(-p1*t26 + t25*t4) + x2*(omega2*p2*t7 - p2*t26), t1*(-omega1*t18*t4 + omega1*t24) + t21*v1 + t22*v2 + t7*(omega2*t23 - omega2*t24) + x1*(omega2*p3*t7 - p3*t26) + x2*(-p1*t25 + t26*t4)]


def global_stick_residual(parameters, spectrum, unknowns, lib):
    """Switching and periodicity equations.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives residual (6).
    Operations: 142. Intermediate terms: 39.
    """
    [chi, _, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = -chi*cos_tau + chi
    t2 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + t1*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t1 - sin_tau*z1_1 + t2*z2_1
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1/omega1
    t6 = sin_omega1_tau1*t5
    t7 = 1 - p1
    t8 = sin_omega2_tau1/omega2
    t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7
    t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + t10*z2_2 + t9*z1_2 + v1_2*(p1*t6 + t7*t8)
    t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t12 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t8 + t6*t7) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8)
    t13 = omega2*sin_omega2_tau1
    t14 = omega1*sin_omega1_tau1
    v1_3 = V*t10 + t9*v1_2 + z1_2*(-p1*t14 - t13*t7) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t14)
    v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t14) + z2_2*(-p1*t13 - t14*t7)
    # functions of tau2 in stick-slip
    t15 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t15)
    sin_omega3_tau2 = lib.sin(t15)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t16 = 1 - cos_omega3_tau2
    t17 = sin_omega3_tau2/omega3
    z2_4 = V*(-t17 + tau2) + cos_omega3_tau2*z2_3 + t16*z1_3 + t17*v2_3
    t18 = omega3*sin_omega3_tau2
    v2_4 = V*t16 + cos_omega3_tau2*v2_3 + t18*z1_3 - t18*z2_3
    return [-chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]


def global_stick_jacobian(parameters, spectrum, unknowns, lib):
    """Derivatives of the equations by the unknowns.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives jacobian (6, 6).
    Operations: 266. Intermediate terms: 94.
    """
    [chi, eta, V, _, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = V*sin_tau
    t3 = chi*cos_tau
    t4 = chi - t3
    t5 = chi*sin_tau
    z1_2 = V*(chi*tau - t5) + cos_tau*z1_1 + t1 + t4*z2_1
    z2_2 = V*tau + z2_1
    t6 = V*cos_tau + V*t4
    v1_2 = -sin_tau*z1_1 + t5*z2_1 + t6
    # functions of tau1 in slip-slip
    t7 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t7)
    sin_omega1_tau1 = lib.sin(t7)
    t8 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t8)
    sin_omega2_tau1 = lib.sin(t8)
    # slip-slip for tau1, until first-reaches-belt
    t9 = 1/omega1
    t12 = sin_omega2_tau1/omega2
    t10 = sin_omega1_tau1*t9
    t11 = 1 - p1
    t13 = p1*t10 + t11*t12
    t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11
    t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2
    t16 = p3*sin_omega1_tau1*t9 - p3*t12
    t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2
    t19 = omega2*sin_omega2_tau1
    t20 = omega1*sin_omega1_tau1
    t21 = -p1*t20 - t11*t19
    t22 = p2*t20
    t23 = omega2*p2*sin_omega2_tau1 - t22
    t24 = V*t15
    t25 = t14*v1_2 + t24
    v1_3 = t21*z1_2 + t23*z2_2 + t25
    t26 = omega2*p3*sin_omega2_tau1 - p3*t20
    t27 = p1*t19 + t11*t20
    t29 = V*t18
    t30 = t17*v1_2 + t29
    v2_3 = t26*z1_2 - t27*z2_2 + t30
    # functions of tau2 in stick-slip
    t31 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t31)
    sin_omega3_tau2 = lib.sin(t31)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t32 = 1 - cos_omega3_tau2
    t33 = sin_omega3_tau2/omega3
    z2_4 = V*(-t33 + tau2) + cos_omega3_tau2*z2_3 + t32*z1_3 + t33*v2_3
    t34 = cos_omega3_tau2*v2_3
    t35 = omega3*sin_omega3_tau2
    v2_4 = V*t32 + t34 + t35*z1_3 - t35*z2_3
    # derivatives of the state after tau
    z1_2_by_z20 = t4
    z1_2_by_ta = t6
    v1_2_by_z10 = -sin_tau
    v1_2_by_z20 = t5
    v1_2_by_ta = chi*t1 - t1
    v1_2_by_tau = chi*z2_2 - z1_2
    # derivatives of the state after tau1
    z1_3_by_z10 = cos_tau*t14 + t13*v1_2_by_z10
    z1_3_by_z20 = t13*v1_2_by_z20 + t14*z1_2_by_z20 + t15
    z1_3_by_ta = t13*v1_2_by_ta + t14*z1_2_by_ta + t24
    z1_3_by_tau = t13*v1_2_by_tau + t25
    z2_3_by_z10 = cos_tau*t17 + t16*v1_2_by_z10
    z2_3_by_z20 = t16*v1_2_by_z20 + t17*z1_2_by_z20 + t18
    z2_3_by_ta = t16*v1_2_by_ta + t17*z1_2_by_ta + t29
    z2_3_by_tau = t16*v1_2_by_tau + t30
    v1_3_by_z10 = cos_tau*t21 + t14*v1_2_by_z10
    v1_3_by_z20 = p2*t19 + t14*v1_2_by_z20 + t21*z1_2_by_z20 - t22
    t36 = V*t23
    v1_3_by_ta = t14*v1_2_by_ta + t21*z1_2_by_ta + t36
    v1_3_by_tau = t14*v1_2_by_tau + t21*v1_2 + t36
    t37 = chi*z2_3
    v1_3_by_tau1 = t37 - z1_3
    v2_3_by_z10 = cos_tau*t26 + t17*v1_2_by_z10
    v2_3_by_z20 = t17*v1_2_by_z20 + t26*z1_2_by_z20 - t27
    t38 = -V*t27
    v2_3_by_ta = t17*v1_2_by_ta + t26*z1_2_by_ta + t38
    v2_3_by_tau = t17*v1_2_by_tau + t26*v1_2 + t38
    t39 = chi*eta
    v2_3_by_tau1 = -eta*t37 + t39*z1_3
    # derivatives of the state after tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t32*z1_3_by_z10 + t33*v2_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t32*z1_3_by_z20 + t33*v2_3_by_z20
    z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t32*z1_3_by_ta + t33*v2_3_by_ta
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t32*z1_3_by_tau + t33*v2_3_by_tau
    z2_4_by_tau1 = t32*v1_3 + t33*v2_3_by_tau1 + t34
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t35*z1_3_by_z10 - t35*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t35*z1_3_by_z20 - t35*z2_3_by_z20
    v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t35*z1_3_by_ta - t35*z2_3_by_ta
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t35*z1_3_by_tau - t35*z2_3_by_tau
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t35*v1_3 - t35*v2_3
    v2_4_by_tau2 = t39*z1_4 - t39*z2_4
    # outputs
    t40 = V*chi
    return [[1, -chi, V - t40, 0, 0, 0], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_ta + t40, -chi*v1_2 + t40, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_ta, v1_3_by_tau, v1_3_by_tau1, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_ta, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_ta, z1_3_by_tau, v1_3, V], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_ta, z2_4_by_tau, z2_4_by_tau1, v2_4]]


def global_stick_residual_and_jacobian(parameters, spectrum, unknowns, lib):
    """Equations and their derivatives by the unknowns, sharing all intermediate terms.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives residual (6).
    Gives jacobian (6, 6).
    Operations: 277. Intermediate terms: 94.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = V*sin_tau
    t3 = chi*cos_tau
    t4 = chi - t3
    t5 = chi*sin_tau
    z1_2 = V*(chi*tau - t5) + cos_tau*z1_1 + t1 + t4*z2_1
    z2_2 = V*tau + z2_1
    t6 = V*cos_tau + V*t4
    v1_2 = -sin_tau*z1_1 + t5*z2_1 + t6
    # functions of tau1 in slip-slip
    t7 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t7)
    sin_omega1_tau1 = lib.sin(t7)
    t8 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t8)
    sin_omega2_tau1 = lib.sin(t8)
    # slip-slip for tau1, until first-reaches-belt
    t9 = 1/omega1
    t12 = sin_omega2_tau1/omega2
    t10 = sin_omega1_tau1*t9
    t11 = 1 - p1
    t13 = p1*t10 + t11*t12
    t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11
    t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2
    t16 = p3*sin_omega1_tau1*t9 - p3*t12
    t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2
    t19 = omega2*sin_omega2_tau1
    t20 = omega1*sin_omega1_tau1
    t21 = -p1*t20 - t11*t19
    t22 = p2*t20
    t23 = omega2*p2*sin_omega2_tau1 - t22
    t24 = V*t15
    t25 = t14*v1_2 + t24
    v1_3 = t21*z1_2 + t23*z2_2 + t25
    t26 = omega2*p3*sin_omega2_tau1 - p3*t20
    t27 = p1*t19 + t11*t20
    t29 = V*t18
    t30 = t17*v1_2 + t29
    v2_3 = t26*z1_2 - t27*z2_2 + t30
    # functions of tau2 in stick-slip
    t31 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t31)
    sin_omega3_tau2 = lib.sin(t31)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t32 = 1 - cos_omega3_tau2
    t33 = sin_omega3_tau2/omega3
    z2_4 = V*(-t33 + tau2) + cos_omega3_tau2*z2_3 + t32*z1_3 + t33*v2_3
    t34 = cos_omega3_tau2*v2_3
    t35 = omega3*sin_omega3_tau2
    v2_4 = V*t32 + t34 + t35*z1_3 - t35*z2_3
    # derivatives of the state after tau
    z1_2_by_z20 = t4
    z1_2_by_ta = t6
    v1_2_by_z10 = -sin_tau
    v1_2_by_z20 = t5
    v1_2_by_ta = chi*t1 - t1
    v1_2_by_tau = chi*z2_2 - z1_2
    # derivatives of the state after tau1
    z1_3_by_z10 = cos_tau*t14 + t13*v1_2_by_z10
    z1_3_by_z20 = t13*v1_2_by_z20 + t14*z1_2_by_z20 + t15
    z1_3_by_ta = t13*v1_2_by_ta + t14*z1_2_by_ta + t24
    z1_3_by_tau = t13*v1_2_by_tau + t25
    z2_3_by_z10 = cos_tau*t17 + t16*v1_2_by_z10
    z2_3_by_z20 = t16*v1_2_by_z20 + t17*z1_2_by_z20 + t18
    z2_3_by_ta = t16*v1_2_by_ta + t17*z1_2_by_ta + t29
    z2_3_by_tau = t16*v1_2_by_tau + t30
    v1_3_by_z10 = cos_tau*t21 + t14*v1_2_by_z10
    v1_3_by_z20 = p2*t19 + t14*v1_2_by_z20 + t21*z1_2_by_z20 - t22
    t36 = V*t23
    v1_3_by_ta = t14*v1_2_by_ta + t21*z1_2_by_ta + t36
    v1_3_by_tau = t14*v1_2_by_tau + t21*v1_2 + t36
    t37 = chi*z2_3
    v1_3_by_tau1 = t37 - z1_3
    v2_3_by_z10 = cos_tau*t26 + t17*v1_2_by_z10
    v2_3_by_z20 = t17*v1_2_by_z20 + t26*z1_2_by_z20 - t27
    t38 = -V*t27
    v2_3_by_ta = t17*v1_2_by_ta + t26*z1_2_by_ta + t38
    v2_3_by_tau = t17*v1_2_by_tau + t26*v1_2 + t38
    t39 = chi*eta
    v2_3_by_tau1 = -eta*t37 + t39*z1_3
    # derivatives of the state after tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t32*z1_3_by_z10 + t33*v2_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t32*z1_3_by_z20 + t33*v2_3_by_z20
    z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t32*z1_3_by_ta + t33*v2_3_by_ta
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t32*z1_3_by_tau + t33*v2_3_by_tau
    z2_4_by_tau1 = t32*v1_3 + t33*v2_3_by_tau1 + t34
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t35*z1_3_by_z10 - t35*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t35*z1_3_by_z20 - t35*z2_3_by_z20
    v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t35*z1_3_by_ta - t35*z2_3_by_ta
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t35*z1_3_by_tau - t35*z2_3_by_tau
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t35*v1_3 - t35*v2_3
    v2_4_by_tau2 = t39*z1_4 - t39*z2_4
    # outputs
    t40 = V*chi
    return (
        [-chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4],
        [[1, -chi, V - t40, 0, 0, 0], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_ta + t40, -chi*v1_2 + t40, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_ta, v1_3_by_tau, v1_3_by_tau1, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_ta, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_ta, z1_3_by_tau, v1_3, V], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_ta, z2_4_by_tau, z2_4_by_tau1, v2_4]],
    )


def global_stick_parameter_jacobian(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Total derivatives of the equations by the parameters, through the spectrum too.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives parameter_jacobian (6, 5).
    Operations: 514. Intermediate terms: 142.
    """
    [chi, _, V, _, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = chi*cos_tau
    t2 = chi - t1
    t3 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t3) + cos_tau*z1_1 + t2*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t2 - sin_tau*z1_1 + t3*z2_1
    # functions of tau1 in slip-slip
    t4 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t4)
    sin_omega1_tau1 = lib.sin(t4)
    t7 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t7)
    sin_omega2_tau1 = lib.sin(t7)
    # slip-slip for tau1, until first-reaches-belt
    t10 = 1/omega1
    t11 = sin_omega1_tau1*t10
    t12 = 1 - p1
    t13 = 1/omega2
    t14 = sin_omega2_tau1*t13
    t15 = p1*t11 + t12*t14
    t16 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12
    t17 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t18 = p2*t14
    z1_3 = V*(p2*sin_omega1_tau1*t10 - t18) + t15*v1_2 + t16*z1_2 + t17*z2_2
    t19 = p3*sin_omega1_tau1*t10 - p3*t14
    t20 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t21 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1
    t22 = p1*t14 + t11*t12
    z2_3 = V*t22 + t19*v1_2 + t20*z1_2 + t21*z2_2
    t23 = omega1*sin_omega1_tau1
    t24 = omega2*p3*sin_omega2_tau1 - p3*t23
    t25 = omega2*sin_omega2_tau1
    t26 = -p1*t25 - t12*t23
    v2_3 = V*t21 + t20*v1_2 + t24*z1_2 + t26*z2_2
    # functions of tau2 in stick-slip
    t27 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t27)
    sin_omega3_tau2 = lib.sin(t27)
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t30 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t30*z2_1
    v1_2_by_chi = V*t30 + sin_tau*z2_1
    # d/dV of: slip-stick for tau, until second-breaks-forward
    z1_2_by_V = chi*tau + cos_tau*ta + sin_tau + t2*ta - t3
    z2_2_by_V = ta + tau
    v1_2_by_V = chi + cos_tau - sin_tau*ta - t1 + t3*ta
    # d/dchi of: functions of tau1 in slip-slip
    t31 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t31
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t31
    t32 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t32
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t32
    # d/deta of: functions of tau1 in slip-slip
    t33 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t33
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t33
    t34 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t34
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t34
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t35 = p1*z1_2
    t36 = p2*z2_2
    t37 = t35 + t36
    t38 = t12*z1_2 - t36
    t39 = p1*v1_2
    t40 = sin_omega1_tau1/omega1**2
    t41 = V*p2
    t42 = -t39*t40 - t40*t41
    t43 = 1/omega2**2
    t44 = sin_omega2_tau1*t43
    t45 = -t12*t44*v1_2 + t41*t44
    t46 = -sin_omega1_tau1*t10 + t14
    t48 = cos_omega1_tau1 - cos_omega2_tau1
    t49 = -t46*v1_2 + t48*z1_2
    t50 = -V*t46 + t48*z2_2
    t51 = t10*t39 + t10*t41
    t52 = t12*t13*v1_2 - t13*t41
    z1_3_by_chi = cos_omega1_tau1_by_chi*t37 + cos_omega2_tau1_by_chi*t38 + omega1_by_chi*t42 + omega2_by_chi*t45 + p1_by_chi*t49 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t51 + sin_omega2_tau1_by_chi*t52 + t15*v1_2_by_chi + t16*z1_2_by_chi
    t53 = p3*z1_2
    t54 = t12*z2_2
    t55 = t53 + t54
    t56 = p1*z2_2
    t57 = -t53 + t56
    t58 = p3*v1_2
    t59 = V*t12
    t60 = -t40*t58 - t40*t59
    t61 = V*p1
    t62 = p3*sin_omega2_tau1*t43*v1_2 - t44*t61
    t64 = V*t46 - t48*z2_2
    t65 = t10*t58 + t10*t59
    t66 = -t13*t58 + t13*t61
    z2_3_by_chi = cos_omega1_tau1_by_chi*t55 + cos_omega2_tau1_by_chi*t57 + omega1_by_chi*t60 + omega2_by_chi*t62 + p1_by_chi*t64 + p3_by_chi*t49 + sin_omega1_tau1_by_chi*t65 + sin_omega2_tau1_by_chi*t66 + t19*v1_2_by_chi + t20*z1_2_by_chi
    t67 = t39 + t41
    t68 = t12*v1_2 - t41
    t69 = -sin_omega1_tau1*t35 - sin_omega1_tau1*t36
    t70 = t12*z1_2
    t71 = sin_omega2_tau1*t36 - sin_omega2_tau1*t70
    t72 = -omega2*sin_omega2_tau1 + t23
    t74 = t48*v1_2 - t72*z1_2
    t75 = V*t48 - t72*z2_2
    t76 = -omega1*t35 - omega1*t36
    t77 = omega2*t36 - omega2*t70
    t78 = -p1*t23 - t12*t25
    v1_3_by_chi = cos_omega1_tau1_by_chi*t67 + cos_omega2_tau1_by_chi*t68 + omega1_by_chi*t69 + omega2_by_chi*t71 + p1_by_chi*t74 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t76 + sin_omega2_tau1_by_chi*t77 + t16*v1_2_by_chi + t78*z1_2_by_chi
    t79 = t58 + t59
    t80 = -t58 + t61
    t81 = -sin_omega1_tau1*t53 - sin_omega1_tau1*t54
    t82 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t56
    t83 = -V*t48 + t72*z2_2
    t84 = -omega1*t53 - omega1*t54
    t85 = omega2*p3*z1_2 - omega2*t56
    v2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t80 + omega1_by_chi*t81 + omega2_by_chi*t82 + p1_by_chi*t83 + p3_by_chi*t74 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t85 + t20*v1_2_by_chi + t24*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t37 + cos_omega2_tau1_by_eta*t38 + omega1_by_eta*t42 + omega2_by_eta*t45 + p1_by_eta*t49 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t51 + sin_omega2_tau1_by_eta*t52
    z2_3_by_eta = cos_omega1_tau1_by_eta*t55 + cos_omega2_tau1_by_eta*t57 + omega1_by_eta*t60 + omega2_by_eta*t62 + p1_by_eta*t64 + p3_by_eta*t49 + sin_omega1_tau1_by_eta*t65 + sin_omega2_tau1_by_eta*t66
    v1_3_by_eta = cos_omega1_tau1_by_eta*t67 + cos_omega2_tau1_by_eta*t68 + omega1_by_eta*t69 + omega2_by_eta*t71 + p1_by_eta*t74 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t76 + sin_omega2_tau1_by_eta*t77
    v2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t80 + omega1_by_eta*t81 + omega2_by_eta*t82 + p1_by_eta*t83 + p3_by_eta*t74 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t85
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = p2*t11 + t15*v1_2_by_V + t16*z1_2_by_V + t17*z2_2_by_V - t18
    z2_3_by_V = t19*v1_2_by_V + t20*z1_2_by_V + t21*z2_2_by_V + t22
    v1_3_by_V = t16*v1_2_by_V + t17 + t78*z1_2_by_V + z2_2_by_V*(omega2*p2*sin_omega2_tau1 - p2*t23)
    v2_3_by_V = t20*v1_2_by_V + t21 + t24*z1_2_by_V + t26*z2_2_by_V
    # d/dchi of: functions of tau2 in stick-slip
    t86 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t86
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t86
    # d/deta of: functions of tau2 in stick-slip
    t87 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t87
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t87
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t88 = -z1_3 + z2_3
    t89 = sin_omega3_tau2/omega3**2
    t90 = V*t89 - t89*v2_3
    t91 = 1/omega3
    t92 = -V*t91 + t91*v2_3
    t93 = 1 - cos_omega3_tau2
    t94 = sin_omega3_tau2*t91
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t88 + omega3_by_chi*t90 + sin_omega3_tau2_by_chi*t92 + t93*z1_3_by_chi + t94*v2_3_by_chi
    t95 = -V + v2_3
    t96 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3
    t97 = omega3*z1_3 - omega3*z2_3
    t98 = omega3*sin_omega3_tau2
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t95 + omega3_by_chi*t96 + sin_omega3_tau2_by_chi*t97 + t98*z1_3_by_chi - t98*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t88 + omega3_by_eta*t90 + sin_omega3_tau2_by_eta*t92 + t93*z1_3_by_eta + t94*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t95 + omega3_by_eta*t96 + sin_omega3_tau2_by_eta*t97 + t98*z1_3_by_eta - t98*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t93*z1_3_by_V + t94*v2_3_by_V - t94 + tau2
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t98*z1_3_by_V - t98*z2_3_by_V + 1
    return [[-z2_1, 0, -chi*ta + ta, -1, 0], [-chi*z1_2_by_chi - z1_2 + z2_2, 0, -chi*z1_2_by_V + chi*z2_2_by_V, 0, -1], [v1_3_by_chi, v1_3_by_eta, v1_3_by_V - 1, 0, 0], [v2_4_by_chi, v2_4_by_eta, v2_4_by_V - 1, 0, 0], [z1_3_by_chi, z1_3_by_eta, z1_4_by_V, 0, 0], [z2_4_by_chi, z2_4_by_eta, z2_4_by_V, 0, 0]]


def global_stick_poincare_jacobian(parameters, spectrum, unknowns, lib):
    """Jacobian of the Poincare map in the section's coordinates.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives poincare_jacobian (2, 2).
    Operations: 276. Intermediate terms: 103.
    """
    [chi, eta, V, _, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = -chi*cos_tau + chi
    t2 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + t1*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t1 - sin_tau*z1_1 + t2*z2_1
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1/omega1
    t8 = sin_omega2_tau1/omega2
    t6 = sin_omega1_tau1*t5
    t7 = 1 - p1
    t9 = p1*t6 + t7*t8
    t10 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7
    t11 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + t10*z1_2 + t11*z2_2 + t9*v1_2
    t12 = p3*sin_omega1_tau1*t5 - p3*t8
    t13 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t14 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t8 + t6*t7) + t12*v1_2 + t13*z1_2 + t14*z2_2
    t15 = omega2*sin_omega2_tau1
    t16 = omega1*sin_omega1_tau1
    t17 = -p1*t16 - t15*t7
    t18 = omega2*p2*sin_omega2_tau1 - p2*t16
    v1_3 = V*t11 + t10*v1_2 + t17*z1_2 + t18*z2_2
    t19 = omega2*p3*sin_omega2_tau1 - p3*t16
    t20 = -p1*t15 - t16*t7
    v2_3 = V*t14 + t13*v1_2 + t19*z1_2 + t20*z2_2
    # functions of tau2 in stick-slip
    t21 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t21)
    sin_omega3_tau2 = lib.sin(t21)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t22 = 1 - cos_omega3_tau2
    t23 = sin_omega3_tau2/omega3
    z2_4 = V*(-t23 + tau2) + cos_omega3_tau2*z2_3 + t22*z1_3 + t23*v2_3
    t24 = omega3*sin_omega3_tau2
    v2_4 = V*t22 + cos_omega3_tau2*v2_3 + t24*z1_3 - t24*z2_3
    # rate of the exit boundary after ta
    t25 = V*chi
    rate_1 = V - t25
    # derivatives of ta on the boundary
    t26 = 1/rate_1
    ta_by_z10 = -t26
    ta_by_z20 = chi*t26
    # perturbation on the boundary after ta
    t27 = V*ta_by_z10
    z1_1_on_boundary_by_z10 = t27 + 1
    z1_1_on_boundary_by_z20 = V*ta_by_z20
    z2_1_on_boundary_by_z10 = t27
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t25
    # derivatives of tau on the boundary
    t29 = 1/rate_2
    tau_by_z10 = t29*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    tau_by_z20 = t29*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*tau_by_z20 + z2_1_on_boundary_by_z20
    t30 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + t30*tau_by_z10
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + t30*tau_by_z20
    # Phi along tau1
    carried_z1_3_by_z10 = t10*z1_2_on_boundary_by_z10 + t11*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*z1_2_on_boundary_by_z20 + t11*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t13*z1_2_on_boundary_by_z10 + t14*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t13*z1_2_on_boundary_by_z20 + t14*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t17*z1_2_on_boundary_by_z10 + t18*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t17*z1_2_on_boundary_by_z20 + t18*z2_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t13*v1_2_on_boundary_by_z10 + t19*z1_2_on_boundary_by_z10 + t20*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t13*v1_2_on_boundary_by_z20 + t19*z1_2_on_boundary_by_z20 + t20*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t31 = chi*z2_3
    rate_3 = t31 - z1_3
    # derivatives of tau1 on the boundary
    t32 = 1/rate_3
    tau1_by_z10 = -carried_v1_3_by_z10*t32
    tau1_by_z20 = -carried_v1_3_by_z20*t32
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + tau1_by_z20*v2_3
    t33 = chi*eta
    t34 = -eta*t31 + t33*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + t34*tau1_by_z10
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + t34*tau1_by_z20
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t22*z1_3_on_boundary_by_z10 + t23*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t22*z1_3_on_boundary_by_z20 + t23*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t24*z1_3_on_boundary_by_z10 - t24*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t24*z1_3_on_boundary_by_z20 - t24*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t33*z1_4 - t33*z2_4
    # derivatives of tau2 on the boundary
    t35 = 1/rate_4
    tau2_by_z10 = -carried_v2_4_by_z10*t35
    tau2_by_z20 = -carried_v2_4_by_z20*t35
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*tau2_by_z10 + z1_3_on_boundary_by_z10
    z1_4_on_boundary_by_z20 = V*tau2_by_z20 + z1_3_on_boundary_by_z20
    z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + tau2_by_z10*v2_4
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + tau2_by_z20*v2_4
    return [[z1_4_on_boundary_by_z10, z1_4_on_boundary_by_z20], [z2_4_on_boundary_by_z10, z2_4_on_boundary_by_z20]]


def global_stick_trace(parameters, spectrum, unknowns, lib):
    """Trace of the Poincare map's Jacobian.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives trace.
    Operations: 194. Intermediate terms: 64.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, _, tau, tau1, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t2 = V*tau
    t3 = 1/(chi - 1)
    z2_1 = V*sin_tau - cos_tau*e1*t3 - t2 - e2*t3/chi
    # slip-stick for tau
    t4 = chi*z2_1
    t5 = e1 + t4
    t6 = -chi*cos_tau + chi
    z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t5 + t6*z2_1
    z2_2 = t2 + z2_1
    v1_2 = V*cos_tau + V*t6 + sin_tau*t4 - sin_tau*t5
    # functions of tau1 in slip-slip
    t7 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t7)
    sin_omega1_tau1 = lib.sin(t7)
    t8 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t8)
    sin_omega2_tau1 = lib.sin(t8)
    # slip-slip for tau1
    t9 = 1/omega1
    t12 = sin_omega2_tau1/omega2
    t10 = sin_omega1_tau1*t9
    t11 = 1 - p1
    t13 = p1*t10 + t11*t12
    t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11
    t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t9 - p2*t12) + t13*v1_2 + t14*z1_2 + t15*z2_2
    t16 = p3*sin_omega1_tau1*t9 - p3*t12
    t17 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t18 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t12 + t10*t11) + t16*v1_2 + t17*z1_2 + t18*z2_2
    t19 = omega2*sin_omega2_tau1
    t20 = omega1*sin_omega1_tau1
    t21 = -p1*t20 - t11*t19
    t22 = omega2*p2*sin_omega2_tau1 - p2*t20
    v1_3 = V*t15 + t14*v1_2 + t21*z1_2 + t22*z2_2
    t23 = omega2*p3*sin_omega2_tau1 - p3*t20
    t24 = -p1*t19 - t11*t20
    v2_3 = V*t18 + t17*v1_2 + t23*z1_2 + t24*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t25 = cos_tau_by_tau*e1
    z2_1_by_tau = V*sin_tau_by_tau - V - t25*t3
    # d/dtau of: slip-stick for tau
    t26 = V*chi
    t27 = V - t26
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t27 + t25 + t26
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t27 - e1*sin_tau_by_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t13*v1_2_by_tau + t14*z1_2_by_tau + t15*z2_2_by_tau
    z2_3_by_tau = t16*v1_2_by_tau + t17*z1_2_by_tau + t18*z2_2_by_tau
    v1_3_by_tau = t14*v1_2_by_tau + t21*z1_2_by_tau + t22*z2_2_by_tau
    v2_3_by_tau = t17*v1_2_by_tau + t23*z1_2_by_tau + t24*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t28 = chi*z2_3
    v1_3_by_tau1 = t28 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t28
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t29 = 2*cosine_part_tau2
    t30 = 2*sine_part_tau2
    t31 = 1/(2*amplitude_tau2)
    amplitude_tau2_by_tau = t31*(sine_part_tau2_by_tau*t30 + t29*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t31*(sine_part_tau2_by_tau1*t30 + t29*v2_3_by_tau1)
    # outputs
    t32 = t3/omega3
    return (amplitude_tau2_by_tau*t32 - amplitude_tau2_by_tau1*t32*v1_3_by_tau/v1_3_by_tau1)/z2_1_by_tau


def global_stick_trace_gradient(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Derivatives of the trace by the unknowns, then in total by the parameters.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives trace_gradient (11).
    Operations: 1293. Intermediate terms: 348.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    [_, _, _, tau, tau1, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t2 = V*tau
    t3 = chi - 1
    t4 = 1/t3
    t5 = cos_tau*t4
    t6 = 1/chi
    t7 = t4*t6
    z2_1 = V*sin_tau - e1*t5 - e2*t7 - t2
    # slip-stick for tau
    t8 = chi*z2_1
    t9 = e1 + t8
    t10 = chi*cos_tau
    t11 = chi - t10
    t12 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t12) + cos_tau*t9 + t11*z2_1
    z2_2 = t2 + z2_1
    v1_2 = V*cos_tau + V*t11 + sin_tau*t8 - sin_tau*t9
    # functions of tau1 in slip-slip
    t13 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t13)
    sin_omega1_tau1 = lib.sin(t13)
    t16 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t16)
    sin_omega2_tau1 = lib.sin(t16)
    # slip-slip for tau1
    t19 = 1/omega1
    t20 = sin_omega1_tau1*t19
    t21 = 1 - p1
    t22 = 1/omega2
    t23 = sin_omega2_tau1*t22
    t24 = p1*t20 + t21*t23
    t25 = cos_omega1_tau1*p1 + cos_omega2_tau1*t21
    t26 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t27 = p2*t23
    z1_3 = V*(p2*sin_omega1_tau1*t19 - t27) + t24*v1_2 + t25*z1_2 + t26*z2_2
    t28 = p3*sin_omega1_tau1*t19 - p3*t23
    t29 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t30 = cos_omega1_tau1*t21 + cos_omega2_tau1*p1
    t31 = p1*t23 + t20*t21
    z2_3 = V*t31 + t28*v1_2 + t29*z1_2 + t30*z2_2
    t32 = omega2*sin_omega2_tau1
    t33 = omega1*sin_omega1_tau1
    t34 = -p1*t33 - t21*t32
    t35 = omega2*p2*sin_omega2_tau1 - p2*t33
    v1_3 = V*t26 + t25*v1_2 + t34*z1_2 + t35*z2_2
    t36 = omega2*p3*sin_omega2_tau1 - p3*t33
    t37 = -p1*t32 - t21*t33
    v2_3 = V*t30 + t29*v1_2 + t36*z1_2 + t37*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t40 = -V*sin_tau_by_tau
    t41 = cos_tau_by_tau*e1
    z2_1_by_tau = -V - t4*t41 - t40
    # d/dtau of: slip-stick for tau
    t42 = V*chi
    t43 = V - t42
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t43 + t41 + t42
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t43 - e1*sin_tau_by_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t24*v1_2_by_tau + t25*z1_2_by_tau + t26*z2_2_by_tau
    z2_3_by_tau = t28*v1_2_by_tau + t29*z1_2_by_tau + t30*z2_2_by_tau
    v1_3_by_tau = t25*v1_2_by_tau + t34*z1_2_by_tau + t35*z2_2_by_tau
    v2_3_by_tau = t29*v1_2_by_tau + t36*z1_2_by_tau + t37*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t45 = chi*z2_3
    v1_3_by_tau1 = t45 - z1_3
    t46 = eta*z1_3
    v2_3_by_tau1 = chi*t46 - eta*t45
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t47 = 2*cosine_part_tau2
    t48 = 2*sine_part_tau2
    t49 = sine_part_tau2_by_tau*t48 + t47*v2_3_by_tau
    t50 = 1/amplitude_tau2
    t51 = t50/2
    amplitude_tau2_by_tau = t49*t51
    # d/dtau1 of: first return of tau2
    t52 = sine_part_tau2_by_tau1*t48 + t47*v2_3_by_tau1
    amplitude_tau2_by_tau1 = t51*t52
    # d/dchi of: z2_1: linear in second-breaks-forward
    t53 = 1/t3**2
    z2_1_by_chi = cos_tau*e1*t53 + e2*t53*t6 + e2*t4/chi**2
    # d/dV of: z2_1: linear in second-breaks-forward
    z2_1_by_V = sin_tau - tau
    # d/de1 of: z2_1: linear in second-breaks-forward
    z2_1_by_e1 = -t5
    # d/de2 of: z2_1: linear in second-breaks-forward
    z2_1_by_e2 = -t7
    # d/dchi of: slip-stick for tau
    t55 = 1 - cos_tau
    z1_2_by_chi = -V*z2_1_by_V + chi*z2_1_by_chi + cos_tau*z2_1 + t55*z2_1
    v1_2_by_chi = V*t55
    # d/dV of: slip-stick for tau
    z1_2_by_V = chi*tau + chi*z2_1_by_V + sin_tau - t12
    z2_2_by_V = tau + z2_1_by_V
    v1_2_by_V = chi + cos_tau - t10
    # d/de1 of: slip-stick for tau
    z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau
    v1_2_by_e1 = -sin_tau
    # d/de2 of: slip-stick for tau
    z1_2_by_e2 = chi*z2_1_by_e2
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dchi of: functions of tau1 in slip-slip
    t56 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t56
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t56
    t57 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t57
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t57
    # d/deta of: functions of tau1 in slip-slip
    t58 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t58
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t58
    t59 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t59
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t59
    # d/dtau1 of: slip-slip for tau1
    t60 = p1*z1_2
    t61 = p2*z2_2
    t62 = t60 + t61
    t63 = t21*z1_2 - t61
    t64 = p1*v1_2
    t65 = V*p2
    t66 = t19*t64 + t19*t65
    t67 = t21*t22*v1_2 - t22*t65
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t62 + cos_omega2_tau1_by_tau1*t63 + sin_omega1_tau1_by_tau1*t66 + sin_omega2_tau1_by_tau1*t67
    t68 = p3*z1_2
    t69 = t21*z2_2
    t70 = t68 + t69
    t71 = p1*z2_2
    t72 = -t68 + t71
    t73 = p3*v1_2
    t74 = V*t21
    t75 = t19*t73 + t19*t74
    t76 = V*p1
    t77 = -t22*t73 + t22*t76
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t70 + cos_omega2_tau1_by_tau1*t72 + sin_omega1_tau1_by_tau1*t75 + sin_omega2_tau1_by_tau1*t77
    # d/dchi of: slip-slip for tau1
    t78 = sin_omega1_tau1/omega1**2
    t79 = -t64*t78 - t65*t78
    t80 = 1/omega2**2
    t81 = sin_omega2_tau1*t80
    t82 = -t21*t81*v1_2 + t65*t81
    t83 = -sin_omega1_tau1*t19 + t23
    t85 = cos_omega1_tau1 - cos_omega2_tau1
    t86 = -t83*v1_2 + t85*z1_2
    t87 = -V*t83 + t85*z2_2
    z1_3_by_chi = cos_omega1_tau1_by_chi*t62 + cos_omega2_tau1_by_chi*t63 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau1_by_chi*t66 + sin_omega2_tau1_by_chi*t67 + t24*v1_2_by_chi + t25*z1_2_by_chi + t26*z2_1_by_chi
    t88 = -t73*t78 - t74*t78
    t89 = p3*sin_omega2_tau1*t80*v1_2 - t76*t81
    t91 = V*t83 - t85*z2_2
    z2_3_by_chi = cos_omega1_tau1_by_chi*t70 + cos_omega2_tau1_by_chi*t72 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau1_by_chi*t75 + sin_omega2_tau1_by_chi*t77 + t28*v1_2_by_chi + t29*z1_2_by_chi + t30*z2_1_by_chi
    t92 = t64 + t65
    t93 = t21*v1_2 - t65
    t94 = -sin_omega1_tau1*t60 - sin_omega1_tau1*t61
    t95 = t21*z1_2
    t96 = sin_omega2_tau1*t61 - sin_omega2_tau1*t95
    t97 = -omega2*sin_omega2_tau1 + t33
    t99 = t85*v1_2 - t97*z1_2
    t100 = V*t85 - t97*z2_2
    t101 = -omega1*t60 - omega1*t61
    t102 = omega2*t61 - omega2*t95
    v1_3_by_chi = cos_omega1_tau1_by_chi*t92 + cos_omega2_tau1_by_chi*t93 + omega1_by_chi*t94 + omega2_by_chi*t96 + p1_by_chi*t99 + p2_by_chi*t100 + sin_omega1_tau1_by_chi*t101 + sin_omega2_tau1_by_chi*t102 + t25*v1_2_by_chi + t34*z1_2_by_chi + t35*z2_1_by_chi
    t103 = t73 + t74
    t104 = -t73 + t76
    t105 = -sin_omega1_tau1*t68 - sin_omega1_tau1*t69
    t106 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t71
    t107 = -V*t85 + t97*z2_2
    t108 = -omega1*t68 - omega1*t69
    t109 = omega2*p3*z1_2 - omega2*t71
    v2_3_by_chi = cos_omega1_tau1_by_chi*t103 + cos_omega2_tau1_by_chi*t104 + omega1_by_chi*t105 + omega2_by_chi*t106 + p1_by_chi*t107 + p3_by_chi*t99 + sin_omega1_tau1_by_chi*t108 + sin_omega2_tau1_by_chi*t109 + t29*v1_2_by_chi + t36*z1_2_by_chi + t37*z2_1_by_chi
    # d/deta of: slip-slip for tau1
    z1_3_by_eta = cos_omega1_tau1_by_eta*t62 + cos_omega2_tau1_by_eta*t63 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau1_by_eta*t66 + sin_omega2_tau1_by_eta*t67
    z2_3_by_eta = cos_omega1_tau1_by_eta*t70 + cos_omega2_tau1_by_eta*t72 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau1_by_eta*t75 + sin_omega2_tau1_by_eta*t77
    v1_3_by_eta = cos_omega1_tau1_by_eta*t92 + cos_omega2_tau1_by_eta*t93 + omega1_by_eta*t94 + omega2_by_eta*t96 + p1_by_eta*t99 + p2_by_eta*t100 + sin_omega1_tau1_by_eta*t101 + sin_omega2_tau1_by_eta*t102
    v2_3_by_eta = cos_omega1_tau1_by_eta*t103 + cos_omega2_tau1_by_eta*t104 + omega1_by_eta*t105 + omega2_by_eta*t106 + p1_by_eta*t107 + p3_by_eta*t99 + sin_omega1_tau1_by_eta*t108 + sin_omega2_tau1_by_eta*t109
    # d/dV of: slip-slip for tau1
    z1_3_by_V = p2*t20 + t24*v1_2_by_V + t25*z1_2_by_V + t26*z2_2_by_V - t27
    z2_3_by_V = t28*v1_2_by_V + t29*z1_2_by_V + t30*z2_2_by_V + t31
    v1_3_by_V = t25*v1_2_by_V + t26 + t34*z1_2_by_V + t35*z2_2_by_V
    v2_3_by_V = t29*v1_2_by_V + t30 + t36*z1_2_by_V + t37*z2_2_by_V
    # d/de1 of: slip-slip for tau1
    z1_3_by_e1 = t24*v1_2_by_e1 + t25*z1_2_by_e1 + t26*z2_1_by_e1
    z2_3_by_e1 = t28*v1_2_by_e1 + t29*z1_2_by_e1 + t30*z2_1_by_e1
    v1_3_by_e1 = t25*v1_2_by_e1 + t34*z1_2_by_e1 + t35*z2_1_by_e1
    v2_3_by_e1 = t29*v1_2_by_e1 + t36*z1_2_by_e1 + t37*z2_1_by_e1
    # d/de2 of: slip-slip for tau1
    z1_3_by_e2 = t25*z1_2_by_e2 + t26*z2_1_by_e2
    z2_3_by_e2 = t29*z1_2_by_e2 + t30*z2_1_by_e2
    v1_3_by_e2 = t34*z1_2_by_e2 + t35*z2_1_by_e2
    v2_3_by_e2 = t36*z1_2_by_e2 + t37*z2_1_by_e2
    # d/dchi of: first return of tau2
    t110 = z1_3 - z2_3
    sine_part_tau2_by_chi = omega3*z1_3_by_chi - omega3*z2_3_by_chi + omega3_by_chi*t110
    # d/deta of: first return of tau2
    sine_part_tau2_by_eta = omega3*z1_3_by_eta - omega3*z2_3_by_eta + omega3_by_eta*t110
    # d/dV of: first return of tau2
    cosine_part_tau2_by_V = v2_3_by_V - 1
    sine_part_tau2_by_V = omega3*z1_3_by_V - omega3*z2_3_by_V
    # d/de1 of: first return of tau2
    sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1
    # d/de2 of: first return of tau2
    sine_part_tau2_by_e2 = omega3*z1_3_by_e2 - omega3*z2_3_by_e2
    # d/dchi of: first return of tau2
    amplitude_tau2_by_chi = t51*(sine_part_tau2_by_chi*t48 + t47*v2_3_by_chi)
    # d/deta of: first return of tau2
    amplitude_tau2_by_eta = t51*(sine_part_tau2_by_eta*t48 + t47*v2_3_by_eta)
    # d/dV of: first return of tau2
    amplitude_tau2_by_V = t51*(cosine_part_tau2_by_V*t47 + sine_part_tau2_by_V*t48)
    # d/de1 of: first return of tau2
    amplitude_tau2_by_e1 = t51*(sine_part_tau2_by_e1*t48 + t47*v2_3_by_e1)
    # d/de2 of: first return of tau2
    amplitude_tau2_by_e2 = t51*(sine_part_tau2_by_e2*t48 + t47*v2_3_by_e2)
    # d/dtau of: d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau_by_tau = -cos_tau
    sin_tau_by_tau_by_tau = -sin_tau
    # d/dtau of: d/dtau of: z2_1: linear in second-breaks-forward
    t111 = cos_tau_by_tau_by_tau*e1
    z2_1_by_tau_by_tau = V*sin_tau_by_tau_by_tau - t111*t4
    # d/dchi of: d/dtau of: z2_1: linear in second-breaks-forward
    z2_1_by_tau_by_chi = t41*t53
    # d/dV of: d/dtau of: z2_1: linear in second-breaks-forward
    z2_1_by_tau_by_V = sin_tau_by_tau - 1
    # d/de1 of: d/dtau of: z2_1: linear in second-breaks-forward
    z2_1_by_tau_by_e1 = -cos_tau_by_tau*t4
    # d/dtau of: d/dtau of: slip-stick for tau
    z1_2_by_tau_by_tau = chi*z2_1_by_tau_by_tau + sin_tau_by_tau_by_tau*t43 + t111
    v1_2_by_tau_by_tau = cos_tau_by_tau_by_tau*t43 - e1*sin_tau_by_tau_by_tau
    # d/dchi of: d/dtau of: slip-stick for tau
    z1_2_by_tau_by_chi = chi*z2_1_by_tau_by_chi + t40 + z2_2_by_tau
    v1_2_by_tau_by_chi = -V*cos_tau_by_tau
    # d/dV of: d/dtau of: slip-stick for tau
    z1_2_by_tau_by_V = chi*z2_1_by_tau_by_V + chi - sin_tau_by_tau*t3
    z2_2_by_tau_by_V = z2_1_by_tau_by_V + 1
    v1_2_by_tau_by_V = -cos_tau_by_tau*t3
    # d/de1 of: d/dtau of: slip-stick for tau
    z1_2_by_tau_by_e1 = chi*z2_1_by_tau_by_e1 + cos_tau_by_tau
    v1_2_by_tau_by_e1 = -sin_tau_by_tau
    # d/dtau of: d/dtau of: slip-slip for tau1
    z1_3_by_tau_by_tau = t24*v1_2_by_tau_by_tau + t25*z1_2_by_tau_by_tau + t26*z2_1_by_tau_by_tau
    z2_3_by_tau_by_tau = t28*v1_2_by_tau_by_tau + t29*z1_2_by_tau_by_tau + t30*z2_1_by_tau_by_tau
    v1_3_by_tau_by_tau = t25*v1_2_by_tau_by_tau + t34*z1_2_by_tau_by_tau + t35*z2_1_by_tau_by_tau
    v2_3_by_tau_by_tau = t29*v1_2_by_tau_by_tau + t36*z1_2_by_tau_by_tau + t37*z2_1_by_tau_by_tau
    # d/dtau1 of: d/dtau of: slip-slip for tau1
    t113 = p1*z1_2_by_tau
    t114 = p2*z2_2_by_tau
    t115 = t113 + t114
    t116 = -t114 + t21*z1_2_by_tau
    t117 = t19*v1_2_by_tau
    t118 = sin_omega1_tau1_by_tau1*t117
    t119 = t22*v1_2_by_tau
    t120 = sin_omega2_tau1_by_tau1*t119
    z1_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t115 + cos_omega2_tau1_by_tau1*t116 + p1*t118 + t120*t21
    t121 = p3*z1_2_by_tau
    t122 = t21*z2_2_by_tau
    t123 = t121 + t122
    t124 = p1*z2_2_by_tau
    t125 = -t121 + t124
    z2_3_by_tau_by_tau1 = cos_omega1_tau1_by_tau1*t123 + cos_omega2_tau1_by_tau1*t125 + p3*t118 - p3*t120
    t126 = -omega1*t113 - omega1*t114
    t127 = t21*z1_2_by_tau
    t128 = omega2*t114 - omega2*t127
    t129 = cos_omega1_tau1_by_tau1*v1_2_by_tau
    t130 = cos_omega2_tau1_by_tau1*v1_2_by_tau
    v1_3_by_tau_by_tau1 = p1*t129 + sin_omega1_tau1_by_tau1*t126 + sin_omega2_tau1_by_tau1*t128 + t130*t21
    t131 = -omega1*t121 - omega1*t122
    t132 = omega2*p3*z1_2_by_tau - omega2*t124
    v2_3_by_tau_by_tau1 = p3*t129 - p3*t130 + sin_omega1_tau1_by_tau1*t131 + sin_omega2_tau1_by_tau1*t132
    # d/dchi of: d/dtau of: slip-slip for tau1
    t133 = -t83*v1_2_by_tau + t85*z1_2_by_tau
    t134 = p2_by_chi*z2_2_by_tau
    t135 = sin_omega1_tau1_by_chi*t117
    t136 = sin_omega2_tau1_by_chi*t119
    t137 = t78*v1_2_by_tau
    t138 = omega1_by_chi*t137
    t139 = t81*v1_2_by_tau
    t140 = omega2_by_chi*t139
    z1_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t115 + cos_omega2_tau1_by_chi*t116 + p1*t135 - p1*t138 + p1_by_chi*t133 + t134*t85 + t136*t21 - t140*t21 + t24*v1_2_by_tau_by_chi + t25*z1_2_by_tau_by_chi + t26*z2_1_by_tau_by_chi
    t141 = p1_by_chi*z2_2_by_tau
    z2_3_by_tau_by_chi = cos_omega1_tau1_by_chi*t123 + cos_omega2_tau1_by_chi*t125 + p3*t135 - p3*t136 - p3*t138 + p3*t140 + p3_by_chi*t133 - t141*t85 + t28*v1_2_by_tau_by_chi + t29*z1_2_by_tau_by_chi + t30*z2_1_by_tau_by_chi
    t142 = -sin_omega1_tau1*t113 - sin_omega1_tau1*t114
    t143 = sin_omega2_tau1*t114 - sin_omega2_tau1*t127
    t144 = t85*v1_2_by_tau - t97*z1_2_by_tau
    t145 = cos_omega1_tau1_by_chi*v1_2_by_tau
    t146 = cos_omega2_tau1_by_chi*v1_2_by_tau
    v1_3_by_tau_by_chi = omega1_by_chi*t142 + omega2_by_chi*t143 + p1*t145 + p1_by_chi*t144 + sin_omega1_tau1_by_chi*t126 + sin_omega2_tau1_by_chi*t128 - t134*t97 + t146*t21 + t25*v1_2_by_tau_by_chi + t34*z1_2_by_tau_by_chi + t35*z2_1_by_tau_by_chi
    t147 = -sin_omega1_tau1*t121 - sin_omega1_tau1*t122
    t148 = p3*sin_omega2_tau1*z1_2_by_tau - sin_omega2_tau1*t124
    v2_3_by_tau_by_chi = omega1_by_chi*t147 + omega2_by_chi*t148 + p3*t145 - p3*t146 + p3_by_chi*t144 + sin_omega1_tau1_by_chi*t131 + sin_omega2_tau1_by_chi*t132 + t141*t97 + t29*v1_2_by_tau_by_chi + t36*z1_2_by_tau_by_chi + t37*z2_1_by_tau_by_chi
    # d/deta of: d/dtau of: slip-slip for tau1
    t149 = p2_by_eta*z2_2_by_tau
    t150 = sin_omega1_tau1_by_eta*t117
    t151 = sin_omega2_tau1_by_eta*t119
    t152 = omega1_by_eta*t137
    t153 = omega2_by_eta*t139
    z1_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t115 + cos_omega2_tau1_by_eta*t116 + p1*t150 - p1*t152 + p1_by_eta*t133 + t149*t85 + t151*t21 - t153*t21
    t154 = p1_by_eta*z2_2_by_tau
    z2_3_by_tau_by_eta = cos_omega1_tau1_by_eta*t123 + cos_omega2_tau1_by_eta*t125 + p3*t150 - p3*t151 - p3*t152 + p3*t153 + p3_by_eta*t133 - t154*t85
    t155 = cos_omega1_tau1_by_eta*v1_2_by_tau
    t156 = cos_omega2_tau1_by_eta*v1_2_by_tau
    v1_3_by_tau_by_eta = omega1_by_eta*t142 + omega2_by_eta*t143 + p1*t155 + p1_by_eta*t144 + sin_omega1_tau1_by_eta*t126 + sin_omega2_tau1_by_eta*t128 - t149*t97 + t156*t21
    v2_3_by_tau_by_eta = omega1_by_eta*t147 + omega2_by_eta*t148 + p3*t155 - p3*t156 + p3_by_eta*t144 + sin_omega1_tau1_by_eta*t131 + sin_omega2_tau1_by_eta*t132 + t154*t97
    # d/dV of: d/dtau of: slip-slip for tau1
    z1_3_by_tau_by_V = t24*v1_2_by_tau_by_V + t25*z1_2_by_tau_by_V + t26*z2_2_by_tau_by_V
    z2_3_by_tau_by_V = t28*v1_2_by_tau_by_V + t29*z1_2_by_tau_by_V + t30*z2_2_by_tau_by_V
    v1_3_by_tau_by_V = t25*v1_2_by_tau_by_V + t34*z1_2_by_tau_by_V + t35*z2_2_by_tau_by_V
    v2_3_by_tau_by_V = t29*v1_2_by_tau_by_V + t36*z1_2_by_tau_by_V + t37*z2_2_by_tau_by_V
    # d/de1 of: d/dtau of: slip-slip for tau1
    z1_3_by_tau_by_e1 = t24*v1_2_by_tau_by_e1 + t25*z1_2_by_tau_by_e1 + t26*z2_1_by_tau_by_e1
    z2_3_by_tau_by_e1 = t28*v1_2_by_tau_by_e1 + t29*z1_2_by_tau_by_e1 + t30*z2_1_by_tau_by_e1
    v1_3_by_tau_by_e1 = t25*v1_2_by_tau_by_e1 + t34*z1_2_by_tau_by_e1 + t35*z2_1_by_tau_by_e1
    v2_3_by_tau_by_e1 = t29*v1_2_by_tau_by_e1 + t36*z1_2_by_tau_by_e1 + t37*z2_1_by_tau_by_e1
    # d/dtau of: d/dtau1 of: slip-slip for tau1
    t157 = chi*z2_3_by_tau
    v1_3_by_tau1_by_tau = t157 - z1_3_by_tau
    t158 = chi*eta
    v2_3_by_tau1_by_tau = -eta*t157 + t158*z1_3_by_tau
    # d/dtau1 of: d/dtau1 of: slip-slip for tau1
    t159 = chi*z2_3_by_tau1
    v1_3_by_tau1_by_tau1 = t159 - z1_3_by_tau1
    v2_3_by_tau1_by_tau1 = -eta*t159 + t158*z1_3_by_tau1
    # d/dchi of: d/dtau1 of: slip-slip for tau1
    t160 = chi*z2_3_by_chi
    v1_3_by_tau1_by_chi = t160 - z1_3_by_chi + z2_3
    v2_3_by_tau1_by_chi = -eta*t160 - eta*z2_3 + t158*z1_3_by_chi + t46
    # d/deta of: d/dtau1 of: slip-slip for tau1
    t161 = chi*z2_3_by_eta
    v1_3_by_tau1_by_eta = t161 - z1_3_by_eta
    v2_3_by_tau1_by_eta = chi*z1_3 - eta*t161 + t158*z1_3_by_eta - t45
    # d/dV of: d/dtau1 of: slip-slip for tau1
    t162 = chi*z2_3_by_V
    v1_3_by_tau1_by_V = t162 - z1_3_by_V
    v2_3_by_tau1_by_V = -eta*t162 + t158*z1_3_by_V
    # d/de1 of: d/dtau1 of: slip-slip for tau1
    t163 = chi*z2_3_by_e1
    v1_3_by_tau1_by_e1 = t163 - z1_3_by_e1
    v2_3_by_tau1_by_e1 = -eta*t163 + t158*z1_3_by_e1
    # d/de2 of: d/dtau1 of: slip-slip for tau1
    t164 = chi*z2_3_by_e2
    v1_3_by_tau1_by_e2 = t164 - z1_3_by_e2
    v2_3_by_tau1_by_e2 = -eta*t164 + t158*z1_3_by_e2
    # d/dtau of: d/dtau of: first return of tau2
    sine_part_tau2_by_tau_by_tau = omega3*z1_3_by_tau_by_tau - omega3*z2_3_by_tau_by_tau
    # d/dtau1 of: d/dtau of: first return of tau2
    sine_part_tau2_by_tau_by_tau1 = omega3*z1_3_by_tau_by_tau1 - omega3*z2_3_by_tau_by_tau1
    # d/dchi of: d/dtau of: first return of tau2
    t165 = z1_3_by_tau - z2_3_by_tau
    sine_part_tau2_by_tau_by_chi = omega3*z1_3_by_tau_by_chi - omega3*z2_3_by_tau_by_chi + omega3_by_chi*t165
    # d/deta of: d/dtau of: first return of tau2
    sine_part_tau2_by_tau_by_eta = omega3*z1_3_by_tau_by_eta - omega3*z2_3_by_tau_by_eta + omega3_by_eta*t165
    # d/dV of: d/dtau of: first return of tau2
    sine_part_tau2_by_tau_by_V = omega3*z1_3_by_tau_by_V - omega3*z2_3_by_tau_by_V
    # d/de1 of: d/dtau of: first return of tau2
    sine_part_tau2_by_tau_by_e1 = omega3*z1_3_by_tau_by_e1 - omega3*z2_3_by_tau_by_e1
    # d/dtau of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_tau = omega3*v1_3_by_tau - omega3*v2_3_by_tau
    # d/dtau1 of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_tau1 = omega3*v1_3_by_tau1 - omega3*v2_3_by_tau1
    # d/dchi of: d/dtau1 of: first return of tau2
    t166 = v1_3 - v2_3
    sine_part_tau2_by_tau1_by_chi = omega3*v1_3_by_chi - omega3*v2_3_by_chi + omega3_by_chi*t166
    # d/deta of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_eta = omega3*v1_3_by_eta - omega3*v2_3_by_eta + omega3_by_eta*t166
    # d/dV of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_V = omega3*v1_3_by_V - omega3*v2_3_by_V
    # d/de1 of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_e1 = omega3*v1_3_by_e1 - omega3*v2_3_by_e1
    # d/de2 of: d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1_by_e2 = omega3*v1_3_by_e2 - omega3*v2_3_by_e2
    # d/dtau of: d/dtau of: first return of tau2
    t167 = cosine_part_tau2*t50
    t168 = sine_part_tau2*t50
    t169 = 1/(2*amplitude_tau2**2)
    t170 = t169*t49
    amplitude_tau2_by_tau_by_tau = -amplitude_tau2_by_tau*t170 + sine_part_tau2_by_tau**2*t50 + sine_part_tau2_by_tau_by_tau*t168 + t167*v2_3_by_tau_by_tau + t50*v2_3_by_tau**2
    # d/dtau1 of: d/dtau of: first return of tau2
    t171 = sine_part_tau2_by_tau*t50
    t172 = t50*v2_3_by_tau
    t173 = sine_part_tau2_by_tau1*t171 + t172*v2_3_by_tau1
    amplitude_tau2_by_tau_by_tau1 = -amplitude_tau2_by_tau1*t170 + sine_part_tau2_by_tau_by_tau1*t168 + t167*v2_3_by_tau_by_tau1 + t173
    # d/dchi of: d/dtau of: first return of tau2
    amplitude_tau2_by_tau_by_chi = -amplitude_tau2_by_chi*t170 + sine_part_tau2_by_chi*t171 + sine_part_tau2_by_tau_by_chi*t168 + t167*v2_3_by_tau_by_chi + t172*v2_3_by_chi
    # d/deta of: d/dtau of: first return of tau2
    amplitude_tau2_by_tau_by_eta = -amplitude_tau2_by_eta*t170 + sine_part_tau2_by_eta*t171 + sine_part_tau2_by_tau_by_eta*t168 + t167*v2_3_by_tau_by_eta + t172*v2_3_by_eta
    # d/dV of: d/dtau of: first return of tau2
    amplitude_tau2_by_tau_by_V = -amplitude_tau2_by_V*t170 + cosine_part_tau2_by_V*t172 + sine_part_tau2_by_V*t171 + sine_part_tau2_by_tau_by_V*t168 + t167*v2_3_by_tau_by_V
    # d/de1 of: d/dtau of: first return of tau2
    amplitude_tau2_by_tau_by_e1 = -amplitude_tau2_by_e1*t170 + sine_part_tau2_by_e1*t171 + sine_part_tau2_by_tau_by_e1*t168 + t167*v2_3_by_tau_by_e1 + t172*v2_3_by_e1
    # d/de2 of: d/dtau of: first return of tau2
    amplitude_tau2_by_tau_by_e2 = -amplitude_tau2_by_e2*t170 + sine_part_tau2_by_e2*t171 + t172*v2_3_by_e2
    # d/dtau of: d/dtau1 of: first return of tau2
    t174 = t169*t52
    amplitude_tau2_by_tau1_by_tau = -amplitude_tau2_by_tau*t174 + sine_part_tau2_by_tau1_by_tau*t168 + t167*v2_3_by_tau1_by_tau + t173
    # d/dtau1 of: d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1_by_tau1 = -amplitude_tau2_by_tau1*t174 + sine_part_tau2_by_tau1**2*t50 + sine_part_tau2_by_tau1_by_tau1*t168 + t167*v2_3_by_tau1_by_tau1 + t50*v2_3_by_tau1**2
    # d/dchi of: d/dtau1 of: first return of tau2
    t175 = sine_part_tau2_by_tau1*t50
    t176 = t50*v2_3_by_tau1
    amplitude_tau2_by_tau1_by_chi = -amplitude_tau2_by_chi*t174 + sine_part_tau2_by_chi*t175 + sine_part_tau2_by_tau1_by_chi*t168 + t167*v2_3_by_tau1_by_chi + t176*v2_3_by_chi
    # d/deta of: d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1_by_eta = -amplitude_tau2_by_eta*t174 + sine_part_tau2_by_eta*t175 + sine_part_tau2_by_tau1_by_eta*t168 + t167*v2_3_by_tau1_by_eta + t176*v2_3_by_eta
    # d/dV of: d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1_by_V = -amplitude_tau2_by_V*t174 + cosine_part_tau2_by_V*t176 + sine_part_tau2_by_V*t175 + sine_part_tau2_by_tau1_by_V*t168 + t167*v2_3_by_tau1_by_V
    # d/de1 of: d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1_by_e1 = -amplitude_tau2_by_e1*t174 + sine_part_tau2_by_e1*t175 + sine_part_tau2_by_tau1_by_e1*t168 + t167*v2_3_by_tau1_by_e1 + t176*v2_3_by_e1
    # d/de2 of: d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1_by_e2 = -amplitude_tau2_by_e2*t174 + sine_part_tau2_by_e2*t175 + sine_part_tau2_by_tau1_by_e2*t168 + t167*v2_3_by_tau1_by_e2 + t176*v2_3_by_e2
    # outputs
    t177 = 1/omega3
    t178 = amplitude_tau2_by_tau*t177
    t179 = t177*t4
    t180 = 1/v1_3_by_tau1
    t181 = amplitude_tau2_by_tau1*t180
    t182 = (t178*t4 - t179*t181*v1_3_by_tau)/z2_1_by_tau**2
    t183 = 1/z2_1_by_tau
    t184 = t179*t183
    t185 = t181*t184
    t186 = t184*v1_3_by_tau
    t187 = t180*t186
    t188 = 1/v1_3_by_tau1**2
    t189 = amplitude_tau2_by_tau1*t186*t188
    t190 = 1/omega3**2
    t191 = t183*(-amplitude_tau2_by_tau*t190*t4 + amplitude_tau2_by_tau1*t180*t190*t4*v1_3_by_tau)
    return [0, 0, 0, amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_tau - amplitude_tau2_by_tau1_by_tau*t187 + amplitude_tau2_by_tau_by_tau*t177*t183*t4 - t182*z2_1_by_tau_by_tau - t185*v1_3_by_tau_by_tau, -amplitude_tau2_by_tau1_by_tau1*t187 + amplitude_tau2_by_tau_by_tau1*t184 - t185*v1_3_by_tau_by_tau1 + t189*v1_3_by_tau1_by_tau1, 0, -amplitude_tau2_by_tau1_by_chi*t187 + amplitude_tau2_by_tau_by_chi*t184 + omega3_by_chi*t191 - t182*z2_1_by_tau_by_chi + t183*(amplitude_tau2_by_tau1*t177*t180*t53*v1_3_by_tau - t178*t53) - t185*v1_3_by_tau_by_chi + t189*v1_3_by_tau1_by_chi, -amplitude_tau2_by_tau1_by_eta*t187 + amplitude_tau2_by_tau_by_eta*t184 + omega3_by_eta*t191 - t185*v1_3_by_tau_by_eta + t189*v1_3_by_tau1_by_eta, amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_V - amplitude_tau2_by_tau1_by_V*t187 + amplitude_tau2_by_tau_by_V*t177*t183*t4 - t182*z2_1_by_tau_by_V - t185*v1_3_by_tau_by_V, amplitude_tau2_by_tau1*t177*t183*t188*t4*v1_3_by_tau*v1_3_by_tau1_by_e1 - amplitude_tau2_by_tau1_by_e1*t187 + amplitude_tau2_by_tau_by_e1*t177*t183*t4 - t182*z2_1_by_tau_by_e1 - t185*v1_3_by_tau_by_e1, -amplitude_tau2_by_tau1_by_e2*t187 + amplitude_tau2_by_tau_by_e2*t184 + t189*v1_3_by_tau1_by_e2]


def global_stick_states(parameters, spectrum, unknowns, lib):
    """State at the start and behind each transition, row by row.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives states (5, 4).
    Operations: 108. Intermediate terms: 32.
    """
    [chi, _, V, _, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, tau2] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = -chi*cos_tau + chi
    t2 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + t1*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t1 - sin_tau*z1_1 + t2*z2_1
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1/omega1
    t6 = sin_omega1_tau1*t5
    t7 = 1 - p1
    t8 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + v1_2*(p1*t6 + t7*t8) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t7) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t10 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t8 + t6*t7) + t10*z2_2 + t9*z1_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8)
    t11 = omega1*sin_omega1_tau1
    v2_3 = V*t10 + t9*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t11) + z2_2*(-omega2*p1*sin_omega2_tau1 - t11*t7)
    # functions of tau2 in stick-slip
    t12 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t12)
    sin_omega3_tau2 = lib.sin(t12)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t13 = sin_omega3_tau2/omega3
    z2_4 = V*(-t13 + tau2) + cos_omega3_tau2*z2_3 + t13*v2_3 + z1_3*(1 - cos_omega3_tau2)
    return [[z10, z20, V, V], [z1_1, z2_1, V, V], [z1_2, z2_2, v1_2, V], [z1_3, z2_3, V, v2_3], [z1_4, z2_4, V, V]]


def global_stick_boundary_functions(parameters, spectrum, unknowns, lib):
    """Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives coefficients (44).
    Gives frequencies (4).
    Operations: 175. Intermediate terms: 45.
    """
    [chi, _, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, ta, tau, tau1, _] = unknowns
    # stick-stick for ta, until first-breaks-forward
    t0 = V*ta
    z1_1 = t0 + z10
    z2_1 = t0 + z20
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t1 = -chi*cos_tau + chi
    t2 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + t1*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t1 - sin_tau*z1_1 + t2*z2_1
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1/omega1
    t6 = sin_omega1_tau1*t5
    t7 = 1 - p1
    t8 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*sin_omega1_tau1*t5 - p2*t8) + v1_2*(p1*t6 + t7*t8) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t7) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t10 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t8 + t6*t7) + t10*z2_2 + t9*z1_2 + v1_2*(p3*sin_omega1_tau1*t5 - p3*t8)
    t11 = omega1*sin_omega1_tau1
    v2_3 = V*t10 + t9*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t11) + z2_2*(-omega2*p1*sin_omega2_tau1 - t11*t7)
    # outputs
    t12 = chi*z20
    t14 = V*chi
    t15 = -V + t14
    t18 = chi*z10
    t19 = chi*z2_1
    t20 = t19 - z1_1
    t21 = chi**2
    t22 = t21*z2_1
    t23 = V*t21 - t14
    t24 = -chi*t20
    t25 = -chi*t15
    t26 = V*p2
    t27 = omega1*z1_2
    t28 = p2*z2_2
    t29 = p3*v1_2
    t30 = chi*z1_3
    t31 = chi*(-z1_3 + z2_3)
    t32 = 1/omega3
    t33 = chi*(-V*t32 + t32*v2_3)
    return (
        [-e1 - t12 + z10, -t15, -e1 + t12 - z10, t15, -e2 + t12 - t18, 0, -e2 - t12 + t18, 0, t15, 0, -t15, t20, -e2 + t19 - t22, -t23, -t24, -t25, -e2 - t19 + t22, t23, t24, t25, -V, 0, p1*v1_2 + t26, -t26 + t7*v1_2, -omega1*t28 - p1*t27, omega2*t28 - omega2*t7*z1_2, -V, 0, V*t7 + t29, V*p1 - t29, -omega1*t7*z2_2 - p3*t27, -omega2*p1*z2_2 + omega2*p3*z1_2, -e1 - t30 + z1_3, -t15, -t31, -t33, -e1 + t30 - z1_3, t15, t31, t33, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3],
        [1, omega1, omega2, omega3],
    )


def global_stick_flow_stick_stick(parameters, spectrum, time, state, lib):
    """State after a time in stick-stick.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 4. Intermediate terms: 0.
    """
    t = time
    [z1, z2, v1, v2] = state
    return [t*v1 + z1, t*v2 + z2, v1, v2]


def global_stick_flow_slip_stick(parameters, spectrum, time, state, lib):
    """State after a time in slip-stick.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 23. Intermediate terms: 4.
    """
    [chi, _, _, _, _] = parameters
    t = time
    [z1, z2, v1, v2] = state
    # outputs
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def global_stick_flow_slip_slip(parameters, spectrum, time, state, lib):
    """State after a time in slip-slip.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    t = time
    [z1, z2, v1, v2] = state
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
    t14 = omega2*t6
    t15 = omega1*t2
    return [t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15), t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4)]


def global_stick_flow_stick_slip(parameters, spectrum, time, state, lib):
    """State after a time in stick-slip.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 23. Intermediate terms: 6.
    """
    [_, _, _, _, _, _, omega3] = spectrum
    t = time
    [z1, z2, v1, v2] = state
    # outputs
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [t*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def global_stick_reduced(parameters, spectrum, reduced, lib):
    """Reduced equations and their derivatives by the reduced unknowns.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives residual (2).
    Gives jacobian (2, 2).
    Operations: 197. Intermediate terms: 66.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1] = reduced
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t2 = V*tau
    t3 = 1/(chi - 1)
    t4 = e1*t3
    z2_1 = V*sin_tau - cos_tau*t4 - t2 - e2*t3/chi
    # slip-stick for tau
    t5 = chi*z2_1
    t6 = e1 + t5
    t7 = -chi*cos_tau + chi
    z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t6 + t7*z2_1
    z2_2 = t2 + z2_1
    v1_2 = V*cos_tau + V*t7 + sin_tau*t5 - sin_tau*t6
    # functions of tau1 in slip-slip
    t8 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t8)
    sin_omega1_tau1 = lib.sin(t8)
    t9 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t9)
    sin_omega2_tau1 = lib.sin(t9)
    # slip-slip for tau1
    t10 = 1/omega1
    t13 = sin_omega2_tau1/omega2
    t11 = sin_omega1_tau1*t10
    t12 = 1 - p1
    t14 = p1*t11 + t12*t13
    t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t12
    t16 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t10 - p2*t13) + t14*v1_2 + t15*z1_2 + t16*z2_2
    t17 = p3*sin_omega1_tau1*t10 - p3*t13
    t18 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t19 = cos_omega1_tau1*t12 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t13 + t11*t12) + t17*v1_2 + t18*z1_2 + t19*z2_2
    t20 = omega2*sin_omega2_tau1
    t21 = omega1*sin_omega1_tau1
    t22 = -p1*t21 - t12*t20
    t23 = omega2*p2*sin_omega2_tau1 - p2*t21
    v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2
    t24 = omega2*p3*sin_omega2_tau1 - p3*t21
    t25 = -p1*t20 - t12*t21
    v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t26 = cos_tau_by_tau*e1
    z2_1_by_tau = V*sin_tau_by_tau - V - t26*t3
    # d/dtau of: slip-stick for tau
    t27 = V*chi
    t28 = V - t27
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t28 + t26 + t27
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t28 - e1*sin_tau_by_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau
    z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau
    v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau
    v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t29 = chi*z2_3
    v1_3_by_tau1 = t29 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t29
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t30 = 2*cosine_part_tau2
    t31 = 2*sine_part_tau2
    t32 = 1/(2*amplitude_tau2)
    amplitude_tau2_by_tau = t32*(sine_part_tau2_by_tau*t31 + t30*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t32*(sine_part_tau2_by_tau1*t31 + t30*v2_3_by_tau1)
    # outputs
    t33 = 1/omega3
    t34 = t3*t33
    return (
        [-V + v1_3, amplitude_tau2*t3*t33 - t4 - z2_1],
        [[v1_3_by_tau, v1_3_by_tau1], [amplitude_tau2_by_tau*t34 - z2_1_by_tau, amplitude_tau2_by_tau1*t34]],
    )


def global_stick_expand(parameters, spectrum, reduced, lib):
    """All unknowns from the reduced ones.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives unknowns (6).
    Operations: 138. Intermediate terms: 40.
    """
    [chi, _, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1] = reduced
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t0 = V*tau
    t1 = 1/(chi - 1)
    z2_1 = V*sin_tau - cos_tau*e1*t1 - t0 - e2*t1/chi
    # slip-stick for tau
    t2 = chi*z2_1
    t3 = e1 + t2
    t4 = -chi*cos_tau + chi
    z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t3 + t4*z2_1
    z2_2 = t0 + z2_1
    v1_2 = V*cos_tau + V*t4 + sin_tau*t2 - sin_tau*t3
    # functions of tau1 in slip-slip
    t5 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t5)
    sin_omega1_tau1 = lib.sin(t5)
    t6 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t6)
    sin_omega2_tau1 = lib.sin(t6)
    # slip-slip for tau1
    t7 = 1/omega1
    t8 = sin_omega1_tau1*t7
    t9 = 1 - p1
    t10 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*sin_omega1_tau1*t7 - p2*t10) + v1_2*(p1*t8 + t10*t9) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t9) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t11 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t12 = cos_omega1_tau1*t9 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t10 + t8*t9) + t11*z1_2 + t12*z2_2 + v1_2*(p3*sin_omega1_tau1*t7 - p3*t10)
    t13 = omega1*sin_omega1_tau1
    v2_3 = V*t12 + t11*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-omega2*p1*sin_omega2_tau1 - t13*t9)
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # first return of tau2
    t14 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t14
    sin_tau2_return = -cosine_part_tau2*t14
    # tau2: first return
    t15 = 1/omega3
    tau2 = t15*lib.angle(sin_tau2_return, cos_tau2_return)
    # ta: linear in time
    t16 = sine_part_tau2*t15
    t17 = V*tau2
    t18 = amplitude_tau2*t15
    ta = -t1*(chi*t16 + chi*t17 - chi*t18 + chi*z2_3 + e1 - t16 - t17 - z2_3)/V
    # outputs
    t19 = t16 + t17 + z2_3
    return [t19, -t18 + t19, ta, tau, tau1, tau2]
