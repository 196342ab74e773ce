# Generated; do not edit.
# Source: nonsmooth.derive.systems.dry_friction
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation c4b4023331a9e8d8
"""Kernels and tables of the system dry-friction, over any arithmetic ``lib``."""

DERIVATION = "c4b4023331a9e8d8"

SYSTEM = {'name': 'dry-friction',
 'description': 'two coupled oscillators on a driving belt with dry friction (Sec. 3)',
 'states': ['x1', 'x2', 'v1', 'v2'],
 'parameters': [{'name': 'chi',
                 'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                 'lower': '0',
                 'upper': '1',
                 'closed': False,
                 'upper_closed': False},
                {'name': 'eta',
                 'description': 'mass ratio m1/m2, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'V',
                 'description': 'velocity of the belt, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'us1',
                 'description': 'slipping friction force on the first mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'ur1',
                 'description': 'static friction force on the first mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'us2',
                 'description': 'slipping friction force on the second mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False},
                {'name': 'ur2',
                 'description': 'static friction force on the second mass, nondimensional',
                 'lower': '0',
                 'upper': None,
                 'closed': False,
                 'upper_closed': False}],
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
 'spectrum': ['gap1', 'omega1', 'omega2', 'p1', 'p2', 'p3', 'omega3'],
 'spectrum_parameters': ['chi', 'eta'],
 'modes': {'slip-slip': [{'length': 1, 'oscillates': False},
                         {'length': 1, 'oscillates': True},
                         {'length': 1, 'oscillates': True}],
           'slip-stick': [{'length': 2, 'oscillates': False},
                          {'length': 1, 'oscillates': True}],
           'slip-overshoot': [{'length': 1, 'oscillates': False},
                              {'length': 1, 'oscillates': True},
                              {'length': 1, 'oscillates': True}],
           'stick-slip': [{'length': 2, 'oscillates': False},
                          {'length': 1, 'oscillates': True}],
           'stick-stick': [{'length': 2, 'oscillates': False}],
           'stick-overshoot': [{'length': 2, 'oscillates': False},
                               {'length': 1, 'oscillates': True}],
           'overshoot-slip': [{'length': 1, 'oscillates': False},
                              {'length': 1, 'oscillates': True},
                              {'length': 1, 'oscillates': True}],
           'overshoot-stick': [{'length': 2, 'oscillates': False},
                               {'length': 1, 'oscillates': True}],
           'overshoot-overshoot': [{'length': 1, 'oscillates': False},
                                   {'length': 1, 'oscillates': True},
                                   {'length': 1, 'oscillates': True}]},
 'forcing': [],
 'coordinates': [('x1', 'v1'), ('x2', 'v2')],
 'held': {'slip-slip': [],
          'slip-stick': ['x2'],
          'slip-overshoot': [],
          'stick-slip': ['x1'],
          'stick-stick': ['x1', 'x2'],
          'stick-overshoot': ['x1'],
          'overshoot-slip': [],
          'overshoot-stick': ['x2'],
          'overshoot-overshoot': []},
 'constraint_rows': {'slip-slip': [],
                     'slip-stick': [1],
                     'slip-overshoot': [],
                     'stick-slip': [0],
                     'stick-stick': [0, 1],
                     'stick-overshoot': [0],
                     'overshoot-slip': [],
                     'overshoot-stick': [1],
                     'overshoot-overshoot': []},
 'boundary_rows': {'slip-slip': [0, 1],
                   'slip-stick': [0, 2, 3],
                   'slip-overshoot': [0, 4],
                   'stick-slip': [5, 6, 1],
                   'stick-stick': [5, 6, 2, 3],
                   'stick-overshoot': [5, 6, 4],
                   'overshoot-slip': [7, 1],
                   'overshoot-stick': [7, 2, 3],
                   'overshoot-overshoot': [7, 4]},
 'transitions': [{'source': 'slip-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'slip-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'slip-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'slip-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'slip-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'stick-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(5, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(6, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(5, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(6, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-slip',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-forward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-forward', 'second-breaks-backward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-forward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-stick',
                  'boundaries': ['first-breaks-backward', 'second-breaks-backward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'stick-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(5, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [(6, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-forward', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(5, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [(6, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'stick-overshoot',
                  'boundaries': ['first-breaks-backward', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-slip', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'overshoot-slip',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [(3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-forward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [(3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['second-breaks-backward'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'slip-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-forward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'overshoot-stick',
                  'boundaries': ['first-reaches-belt', 'second-breaks-backward'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [(3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['second-reaches-belt'],
                  'conditions': [],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(5, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [(6, 'stick-overshoot', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt'],
                  'conditions': [],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (2, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-slip'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True), (3, 'slip-stick', True)],
                  'reset': 0,
                  'target': 'slip-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(5, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'slip-stick'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (2, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-slip'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True), (3, 'overshoot-stick', True)],
                  'reset': 0,
                  'target': 'overshoot-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(6, 'stick-stick', True)],
                  'reset': 1,
                  'target': 'overshoot-stick'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(2, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-slip'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [(3, 'stick-stick', True)],
                  'reset': 2,
                  'target': 'stick-overshoot'},
                 {'source': 'overshoot-overshoot',
                  'boundaries': ['first-reaches-belt', 'second-reaches-belt'],
                  'conditions': [],
                  'reset': 3,
                  'target': 'stick-stick'}],
 'contacts': {'first-friction': {'forces': {'slip-slip': 8,
                                            'slip-stick': 8,
                                            'slip-overshoot': 8,
                                            'stick-slip': 9,
                                            'stick-stick': 9,
                                            'stick-overshoot': 9,
                                            'overshoot-slip': 10,
                                            'overshoot-stick': 10,
                                            'overshoot-overshoot': 10},
                                 'velocity': 11,
                                 'surface': 12},
              'second-friction': {'forces': {'slip-slip': 13,
                                             'slip-stick': 14,
                                             'slip-overshoot': 15,
                                             'stick-slip': 13,
                                             'stick-stick': 14,
                                             'stick-overshoot': 15,
                                             'overshoot-slip': 13,
                                             'overshoot-stick': 14,
                                             'overshoot-overshoot': 15},
                                  'velocity': 16,
                                  'surface': 12}}}

ORBITS = {'symmetric': {'derived': True,
               'phases': [('slip-slip', 'second-reaches-belt', 'tau'),
                          ('slip-stick', 'second-breaks-forward', 'tau1')],
               'states': ['z1', 'z2', 'v1', 'v2'],
               'parameters': [{'name': 'chi',
                               'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                               'lower': '0',
                               'upper': '1',
                               'closed': False,
                               'upper_closed': False},
                              {'name': 'eta',
                               'description': 'mass ratio m1/m2, nondimensional',
                               'lower': '0',
                               'upper': None,
                               'closed': False,
                               'upper_closed': False},
                              {'name': 'V',
                               'description': 'velocity of the belt, nondimensional',
                               'lower': '0',
                               'upper': None,
                               'closed': False,
                               'upper_closed': False},
                              {'name': 'e2',
                               'description': 'excess ur2 - us2 of static over slipping '
                                              'friction',
                               'lower': '0',
                               'upper': None,
                               'closed': True,
                               'upper_closed': False}],
               'open_parameters': [{'name': 'us2',
                                    'description': 'slipping friction force on the second '
                                                   'mass, nondimensional',
                                    'lower': '0',
                                    'upper': None,
                                    'closed': False,
                                    'upper_closed': False}],
               'other_parameters': [{'name': 'us1',
                                     'description': 'slipping friction force on the first '
                                                    'mass, nondimensional',
                                     'lower': '0',
                                     'upper': None,
                                     'closed': False,
                                     'upper_closed': False},
                                    {'name': 'ur1',
                                     'description': 'static friction force on the first mass, '
                                                    'nondimensional',
                                     'lower': '0',
                                     'upper': None,
                                     'closed': False,
                                     'upper_closed': False},
                                    {'name': 'ur2',
                                     'description': 'static friction force on the second mass, '
                                                    'nondimensional',
                                     'lower': '0',
                                     'upper': None,
                                     'closed': False,
                                     'upper_closed': False},
                                    {'name': 'e1',
                                     'description': 'excess ur1 - us1 of static over slipping '
                                                    'friction',
                                     'lower': '0',
                                     'upper': None,
                                     'closed': True,
                                     'upper_closed': False}],
               'combined': {'e1': {'ur1': 1, 'us1': -1}, 'e2': {'ur2': 1, 'us2': -1}},
               'unknowns': ['z10', 'z20', 'v10', 'tau', 'tau1'],
               'dwell_times': ['tau', 'tau1'],
               'durations': [{'tau': 1}, {'tau1': 1}],
               'equations': ['z1 vanishes halfway through slip-slip',
                             'z2 vanishes halfway through slip-slip',
                             'z1 vanishes halfway through slip-stick',
                             'z2 vanishes halfway through slip-stick',
                             'second-breaks-forward ends slip-stick'],
               'reduced': ['tau', 'tau1'],
               'eliminated': {'z20': 'linear in: z2 vanishes halfway through slip-stick',
                              'z10': 'linear in: second-breaks-forward ends slip-stick',
                              'v10': 'linear in: z1 vanishes halfway through slip-slip'},
               'rank': 2,
               'section': ['z20', 'v10'],
               'conservative': False,
               'required': {},
               'vanishing': [],
               'levels': {'v1': 'V', 'v2': 'V'},
               'resets': [[['1', '0', '0', '0'],
                           ['0', '1', '0', '0'],
                           ['0', '0', '1', '0'],
                           ['0', '0', '0', '0']],
                          [['1', '0', '0', '0'],
                           ['0', '1', '0', '0'],
                           ['0', '0', '1', '0'],
                           ['0', '0', '0', '1']]],
               'measures': ['chi', 'V', 'e2', 'z10', 'z20', 'v10'],
               'terms': [2, 1],
               'boundaries': [(0, 'first-reaches-belt', None, 0.0, False),
                              (0, 'second-reaches-belt', None, 0.0, True),
                              (1, 'first-reaches-belt', None, 0.0, False),
                              (1, 'second-breaks-forward', None, 0.0, False),
                              (1, 'second-breaks-backward', 'us2', -2.0, False)],
               'reference': {'parameters': {'chi': '0.4',
                                            'eta': '4',
                                            'V': '0.6773',
                                            'e2': '0.5'},
                             'guess': {'z10': '-0.4898',
                                       'z20': '0.7602',
                                       'v10': '-0.111',
                                       'tau': '2.651',
                                       'tau1': '2.245'}}},
 'global-stick': {'derived': True,
                  'phases': [('stick-stick', 'first-breaks-forward', 'ta'),
                             ('slip-stick', 'second-breaks-forward', 'tau'),
                             ('slip-slip', 'first-reaches-belt', 'tau1'),
                             ('stick-slip', 'second-reaches-belt', 'tau2')],
                  'states': ['z1', 'z2', 'v1', 'v2'],
                  'parameters': [{'name': 'chi',
                                  'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                                  'lower': '0',
                                  'upper': '1',
                                  'closed': False,
                                  'upper_closed': False},
                                 {'name': 'eta',
                                  'description': 'mass ratio m1/m2, nondimensional',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': False,
                                  'upper_closed': False},
                                 {'name': 'V',
                                  'description': 'velocity of the belt, nondimensional',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': False,
                                  'upper_closed': False},
                                 {'name': 'e1',
                                  'description': 'excess ur1 - us1 of static over slipping '
                                                 'friction',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': True,
                                  'upper_closed': False},
                                 {'name': 'e2',
                                  'description': 'excess ur2 - us2 of static over slipping '
                                                 'friction',
                                  'lower': '0',
                                  'upper': None,
                                  'closed': True,
                                  'upper_closed': False}],
                  'open_parameters': [{'name': 'us1',
                                       'description': 'slipping friction force on the first '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False,
                                       'upper_closed': False},
                                      {'name': 'us2',
                                       'description': 'slipping friction force on the second '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False,
                                       'upper_closed': False}],
                  'other_parameters': [{'name': 'ur1',
                                        'description': 'static friction force on the first '
                                                       'mass, nondimensional',
                                        'lower': '0',
                                        'upper': None,
                                        'closed': False,
                                        'upper_closed': False},
                                       {'name': 'ur2',
                                        'description': 'static friction force on the second '
                                                       'mass, nondimensional',
                                        'lower': '0',
                                        'upper': None,
                                        'closed': False,
                                        'upper_closed': False}],
                  'combined': {'e1': {'ur1': 1, 'us1': -1}, 'e2': {'ur2': 1, 'us2': -1}},
                  'unknowns': ['z10', 'z20', 'ta', 'tau', 'tau1', 'tau2'],
                  'dwell_times': ['ta', 'tau', 'tau1', 'tau2'],
                  'durations': [{'ta': 1}, {'tau': 1}, {'tau1': 1}, {'tau2': 1}],
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
                  'conservative': False,
                  'required': {},
                  'vanishing': [],
                  'levels': {'v1': 'V', 'v2': 'V'},
                  'resets': [[['1', '0', '0', '0'],
                              ['0', '1', '0', '0'],
                              ['0', '0', '1', '0'],
                              ['0', '0', '0', '1']],
                             [['1', '0', '0', '0'],
                              ['0', '1', '0', '0'],
                              ['0', '0', '1', '0'],
                              ['0', '0', '0', '1']],
                             [['1', '0', '0', '0'],
                              ['0', '1', '0', '0'],
                              ['0', '0', '0', '0'],
                              ['0', '0', '0', '1']],
                             [['1', '0', '0', '0'],
                              ['0', '1', '0', '0'],
                              ['0', '0', '1', '0'],
                              ['0', '0', '0', '0']]],
                  'measures': ['chi', 'V', 'e1', 'e2', 'z10', 'z20'],
                  'terms': [0, 1, 2, 1],
                  'boundaries': [(0, 'first-breaks-forward', None, 0.0, False),
                                 (0, 'first-breaks-backward', 'us1', -2.0, False),
                                 (0, 'second-breaks-forward', None, 0.0, False),
                                 (0, 'second-breaks-backward', 'us2', -2.0, False),
                                 (1, 'first-reaches-belt', None, 0.0, True),
                                 (1, 'second-breaks-forward', None, 0.0, False),
                                 (1, 'second-breaks-backward', 'us2', -2.0, False),
                                 (2, 'first-reaches-belt', None, 0.0, False),
                                 (2, 'second-reaches-belt', None, 0.0, True),
                                 (3, 'first-breaks-forward', None, 0.0, False),
                                 (3, 'first-breaks-backward', 'us1', -2.0, False),
                                 (3, 'second-reaches-belt', None, 0.0, False)],
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
                                          'tau2': '3.28'}}},
 'solution-ii': {'derived': True,
                 'phases': [('stick-stick', 'first-breaks-forward', 'ta'),
                            ('slip-stick', 'second-breaks-forward', 'tau'),
                            ('slip-slip', 'first-reaches-belt', 'tau1'),
                            ('stick-slip', 'second-reaches-belt', 'tau2')],
                 'states': ['z1', 'z2', 'v1', 'v2'],
                 'parameters': [{'name': 'chi',
                                 'description': 'stiffness ratio k2/(k1 + k2), nondimensional',
                                 'lower': '0',
                                 'upper': '1',
                                 'closed': False,
                                 'upper_closed': False},
                                {'name': 'eta',
                                 'description': 'mass ratio m1/m2, nondimensional',
                                 'lower': '0',
                                 'upper': None,
                                 'closed': False,
                                 'upper_closed': False},
                                {'name': 'V',
                                 'description': 'velocity of the belt, nondimensional',
                                 'lower': '0',
                                 'upper': None,
                                 'closed': False,
                                 'upper_closed': False},
                                {'name': 'e2',
                                 'description': 'excess ur2 - us2 of static over slipping '
                                                'friction',
                                 'lower': '0',
                                 'upper': None,
                                 'closed': True,
                                 'upper_closed': False}],
                 'open_parameters': [{'name': 'us1',
                                      'description': 'slipping friction force on the first '
                                                     'mass, nondimensional',
                                      'lower': '0',
                                      'upper': None,
                                      'closed': False,
                                      'upper_closed': False},
                                     {'name': 'us2',
                                      'description': 'slipping friction force on the second '
                                                     'mass, nondimensional',
                                      'lower': '0',
                                      'upper': None,
                                      'closed': False,
                                      'upper_closed': False}],
                 'other_parameters': [{'name': 'ur1',
                                       'description': 'static friction force on the first '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False,
                                       'upper_closed': False},
                                      {'name': 'ur2',
                                       'description': 'static friction force on the second '
                                                      'mass, nondimensional',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': False,
                                       'upper_closed': False},
                                      {'name': 'e1',
                                       'description': 'excess ur1 - us1 of static over '
                                                      'slipping friction',
                                       'lower': '0',
                                       'upper': None,
                                       'closed': True,
                                       'upper_closed': False}],
                 'combined': {'e1': {'ur1': 1, 'us1': -1}, 'e2': {'ur2': 1, 'us2': -1}},
                 'unknowns': ['z10', 'z20', 'tau', 'tau1', 'tau2', 'e1'],
                 'dwell_times': ['ta', 'tau', 'tau1', 'tau2'],
                 'durations': [{}, {'tau': 1}, {'tau1': 1}, {'tau2': 1}],
                 'equations': ['first-breaks-forward ends stick-stick',
                               'second-breaks-forward ends slip-stick',
                               'first-reaches-belt ends slip-slip',
                               'second-reaches-belt ends stick-slip',
                               'z10 returns',
                               'z20 returns'],
                 'reduced': ['tau', 'tau1', 'e1'],
                 'eliminated': {'z2_1': 'linear in second-breaks-forward',
                                'tau2': 'first return'},
                 'rank': 1,
                 'section': ['z10', 'z20'],
                 'conservative': False,
                 'required': {},
                 'vanishing': ['ta'],
                 'levels': {'v1': 'V', 'v2': 'V'},
                 'resets': [[['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '1', '0'],
                             ['0', '0', '0', '1']],
                            [['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '1', '0'],
                             ['0', '0', '0', '1']],
                            [['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '0', '0'],
                             ['0', '0', '0', '1']],
                            [['1', '0', '0', '0'],
                             ['0', '1', '0', '0'],
                             ['0', '0', '1', '0'],
                             ['0', '0', '0', '0']]],
                 'measures': ['chi', 'V', 'e2', 'z10', 'z20', 'e1'],
                 'terms': [0, 1, 2, 1],
                 'boundaries': [(0, 'first-breaks-forward', None, 0.0, False),
                                (0, 'first-breaks-backward', 'us1', -2.0, False),
                                (0, 'second-breaks-forward', None, 0.0, False),
                                (0, 'second-breaks-backward', 'us2', -2.0, False),
                                (1, 'first-reaches-belt', None, 0.0, True),
                                (1, 'second-breaks-forward', None, 0.0, False),
                                (1, 'second-breaks-backward', 'us2', -2.0, False),
                                (2, 'first-reaches-belt', None, 0.0, False),
                                (2, 'second-reaches-belt', None, 0.0, True),
                                (3, 'first-breaks-forward', None, 0.0, False),
                                (3, 'first-breaks-backward', 'us1', -2.0, False),
                                (3, 'second-reaches-belt', None, 0.0, False)],
                 'reference': {'parameters': {'chi': '0.5',
                                              'eta': '1',
                                              'V': '1',
                                              'e2': '0.4831'},
                               'guess': {'z10': '2',
                                         'z20': '-3',
                                         'tau': '2',
                                         'tau1': '1.568',
                                         'tau2': '3.28',
                                         'e1': '3.5'}}}}

KERNELS = {'spectrum': ([((2,), 0)], [('spectrum', (7,)), ('spectrum_derivatives', (7, 2))]),
 'flow_slip_slip': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_slip_stick': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_slip_overshoot': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_stick_slip': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_stick_stick': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_stick_overshoot': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_overshoot_slip': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_overshoot_stick': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)], [('state_after', (4,))]),
 'flow_overshoot_overshoot': ([((7,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                              [('state_after', (4,))]),
 'fields': ([((7,), 0)], [('fields', (36, 5))]),
 'rows': ([((7,), 0)], [('rows', (17, 5))]),
 'resets': ([((7,), 0)], [('resets', (16, 5))]),
 'modes': ([((7,), 0), ((7,), 0)], [('exponents', (21, 2)), ('coefficients', (152, 5))]),
 'symmetric_equations': ([((4,), 0), ((7,), 0), ((5,), 0), ((7, 2), 2)],
                         [('residual', (5,)),
                          ('jacobian', (5, 5)),
                          ('parameter_jacobian', (5, 4))]),
 'symmetric_trace': ([((4,), 0), ((7,), 0), ((5,), 0), ((7, 2), 1)],
                     [('trace', ()), ('trace_gradient', (9,))]),
 'symmetric_passage': ([((4,), 0), ((7,), 0), ((5,), 0)],
                       [('states', (3, 4)), ('coefficients', (24,)), ('frequencies', (3,))]),
 'symmetric_linearisation': ([((4,), 0), ((7,), 0), ((5,), 0)],
                             [('poincare_jacobian', (2, 2)),
                              ('saltations', (8, 4)),
                              ('monodromy', (4, 4))]),
 'symmetric_flow_slip_slip': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                              [('state_after', (4,))]),
 'symmetric_flow_slip_stick': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                               [('state_after', (4,))]),
 'symmetric_reduced': ([((4,), 0), ((7,), 0), ((2,), 0)],
                       [('unknowns', (5,)),
                        ('determinants', (1,)),
                        ('reduced_residual', (2,)),
                        ('reduced_jacobian', (2, 2))]),
 'global_stick_equations': ([((5,), 0), ((7,), 0), ((6,), 0), ((7, 2), 2)],
                            [('residual', (6,)),
                             ('jacobian', (6, 6)),
                             ('parameter_jacobian', (6, 5))]),
 'global_stick_trace': ([((5,), 0), ((7,), 0), ((6,), 0), ((7, 2), 1)],
                        [('trace', ()), ('trace_gradient', (11,))]),
 'global_stick_passage': ([((5,), 0), ((7,), 0), ((6,), 0)],
                          [('states', (5, 4)), ('coefficients', (44,)), ('frequencies', (4,))]),
 'global_stick_linearisation': ([((5,), 0), ((7,), 0), ((6,), 0)],
                                [('poincare_jacobian', (2, 2)),
                                 ('saltations', (16, 4)),
                                 ('monodromy', (4, 4))]),
 'global_stick_flow_stick_stick': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                   [('state_after', (4,))]),
 'global_stick_flow_slip_stick': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                  [('state_after', (4,))]),
 'global_stick_flow_slip_slip': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                 [('state_after', (4,))]),
 'global_stick_flow_stick_slip': ([((5,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                  [('state_after', (4,))]),
 'global_stick_reduced': ([((5,), 0), ((7,), 0), ((2,), 0)],
                          [('unknowns', (6,)),
                           ('reduced_residual', (2,)),
                           ('reduced_jacobian', (2, 2))]),
 'global_stick_period_map': ([((5,), 0), ((7,), 0), ((6,), 0)],
                             [('period_map', (4, 5)),
                              ('linear_start', (2,)),
                              ('compatibility', (4,))]),
 'solution_ii_equations': ([((4,), 0), ((7,), 0), ((6,), 0), ((7, 2), 2)],
                           [('residual', (6,)),
                            ('jacobian', (6, 6)),
                            ('parameter_jacobian', (6, 4))]),
 'solution_ii_trace': ([((4,), 0), ((7,), 0), ((6,), 0), ((7, 2), 1)],
                       [('trace', ()), ('trace_gradient', (10,))]),
 'solution_ii_passage': ([((4,), 0), ((7,), 0), ((6,), 0)],
                         [('states', (5, 4)), ('coefficients', (44,)), ('frequencies', (4,))]),
 'solution_ii_linearisation': ([((4,), 0), ((7,), 0), ((6,), 0)],
                               [('poincare_jacobian', (2, 2)),
                                ('saltations', (16, 4)),
                                ('monodromy', (4, 4))]),
 'solution_ii_flow_stick_stick': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                  [('state_after', (4,))]),
 'solution_ii_flow_slip_stick': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                 [('state_after', (4,))]),
 'solution_ii_flow_slip_slip': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                [('state_after', (4,))]),
 'solution_ii_flow_stick_slip': ([((4,), 0), ((7,), 0), ((), 0), ((4,), 0)],
                                 [('state_after', (4,))]),
 'solution_ii_reduced': ([((4,), 0), ((7,), 0), ((3,), 0)],
                         [('unknowns', (6,)),
                          ('reduced_residual', (3,)),
                          ('reduced_jacobian', (3, 3))]),
 'solution_ii_period_map': ([((4,), 0), ((7,), 0), ((6,), 0)],
                            [('period_map', (4, 5)),
                             ('linear_start', (2,)),
                             ('compatibility', (4,))])}

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (2): chi, eta.
    Gives spectrum (7).
    Gives spectrum_derivatives (7, 2).
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
    spectrum = [gap1, omega1, omega2, p1, p2, p3, omega3]
    if outputs == 1:
        return spectrum
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
    spectrum_derivatives = [[gap1_by_chi, gap1_by_eta], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]]
    return spectrum, spectrum_derivatives


def flow_slip_slip(parameters, spectrum, time, state, *, lib):
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


def flow_slip_stick(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 - t2*us1 + t2*x1 + t3*x2 + us1 + v2*(chi*t - t1), t*v2 + x2, t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_slip_overshoot(parameters, spectrum, time, state, *, lib):
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


def flow_stick_slip(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [t*v1 + x1, t2*v2 - t3*t5 + t3*x2 + t4*x1 + t5 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*t6 + t6*x1 - t6*x2]


def flow_stick_stick(parameters, spectrum, time, state, *, lib):
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


def flow_stick_overshoot(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [t*v1 + x1, t2*v2 + t3*t5 + t3*x2 + t4*x1 - t5 + v1*(t - t2), v1, t3*v2 + t4*v1 - t5*t6 + t6*x1 - t6*x2]


def flow_overshoot_slip(parameters, spectrum, time, state, *, lib):
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


def flow_overshoot_stick(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*us1 + t2*x1 + t3*x2 - us1 + v2*(chi*t - t1), t*v2 + x2, -t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_overshoot_overshoot(parameters, spectrum, time, state, *, lib):
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


def fields(parameters, *, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives fields (36, 5).
    Operations: 20. Intermediate terms: 2.
    """
    [chi, eta, _, us1, _, us2, _] = parameters
    # fields
    t0 = chi*eta
    t2 = eta*us2
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, -t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, -t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, -t2]]


def rows(parameters, *, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives rows (17, 5).
    Operations: 16. Intermediate terms: 0.
    """
    [chi, _, V, us1, ur1, us2, ur2] = parameters
    return [[0, 0, 1, 0, -V], [0, 0, 0, 1, -V], [-chi, chi, 0, 0, -ur2], [chi, -chi, 0, 0, -ur2], [0, 0, 0, -1, V], [1, -chi, 0, 0, -ur1], [-1, chi, 0, 0, -ur1], [0, 0, -1, 0, V], [0, 0, 0, 0, us1], [1, -chi, 0, 0, 0], [0, 0, 0, 0, -us1], [0, 0, 1, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 0, us2], [-chi, chi, 0, 0, 0], [0, 0, 0, 0, -us2], [0, 0, 0, 1, 0]]


def resets(parameters, *, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives resets (16, 5).
    Operations: 0. Intermediate terms: 0.
    """
    [_, _, V, _, _, _, _] = parameters
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, V], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 0, V]]


def modes(parameters, spectrum, *, lib, outputs=2):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives exponents (21, 2).
    Gives coefficients (152, 5).
    Operations: 231. Intermediate terms: 45.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    exponents = [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3], [0, 0], [0, 0], [0, omega3], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2]]
    if outputs == 1:
        return exponents
    # coefficients
    t0 = 1/(chi - 1)
    t1 = us1 + us2
    t3 = -t0*t1
    t5 = 1/(chi**2 - chi)
    t6 = chi*us1
    t7 = t6 + us2
    t9 = -t5*t7
    t10 = p2*t9
    t11 = p1 - 1
    t13 = p3*t3
    t14 = 1/omega1
    t15 = p1*t14
    t16 = p2*t14
    t17 = p3*t14
    t18 = -t11*t14
    t19 = omega1*p1
    t21 = omega1*p2
    t23 = omega1*p3
    t25 = -omega1*t11
    t29 = 1/omega2
    t30 = -t11*t29
    t31 = -p2*t29
    t32 = -p3*t29
    t33 = p1*t29
    t34 = omega2*t11
    t35 = omega2*p2
    t36 = omega2*p3
    t37 = omega2*p1
    t41 = us1 - us2
    t43 = -t0*t41
    t44 = t6 - us2
    t46 = -t44*t5
    t47 = p2*t46
    t48 = p3*t43
    t49 = us2/chi
    t51 = 1/omega3
    t54 = omega3*t49
    t55 = t0*t41
    t56 = t44*t5
    t57 = p2*t56
    t58 = p3*t55
    t59 = t0*t1
    t60 = t5*t7
    t61 = p2*t60
    t62 = p3*t59
    coefficients = [[0, 0, 0, 0, t3], [0, 0, 0, 0, t9], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t3 - t10], [p3, -t11, 0, 0, -t11*t5*t7 - t13], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t3 + t21*t9], [-t23, -t25, 0, 0, t23*t3 + t25*t9], [-t11, -p2, 0, 0, t10 + t11*t3], [-p3, p1, 0, 0, -p1*t9 + t13], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, omega2*t0*t1*t11 - t35*t9], [t36, -t37, 0, 0, -t3*t36 + t37*t9], [0, chi, 0, 0, us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t43], [0, 0, 0, 0, t46], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t43 - t47], [p3, -t11, 0, 0, -t11*t44*t5 - t48], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t43 + t21*t46], [-t23, -t25, 0, 0, t23*t43 + t25*t46], [-t11, -p2, 0, 0, t11*t43 + t47], [-p3, p1, 0, 0, -p1*t46 + t48], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, omega2*t0*t11*t41 - t35*t46], [t36, -t37, 0, 0, -t36*t43 + t37*t46], [1, 0, 0, 0, 0], [1, 0, 0, 0, t49], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, -t49], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t51, t51, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, t54], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [1, 0, 0, 0, -t49], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, t49], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t51, t51, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, -t54], [0, 0, 0, 0, t55], [0, 0, 0, 0, t56], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t55 - t57], [p3, -t11, 0, 0, t11*t44*t5 - t58], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t55 + t21*t56], [-t23, -t25, 0, 0, t23*t55 + t25*t56], [-t11, -p2, 0, 0, t11*t55 + t57], [-p3, p1, 0, 0, -p1*t56 + t58], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, -omega2*t0*t11*t41 - t35*t56], [t36, -t37, 0, 0, -t36*t55 + t37*t56], [0, chi, 0, 0, -us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t59], [0, 0, 0, 0, t60], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t59 - t61], [p3, -t11, 0, 0, t11*t5*t7 - t62], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t59 + t21*t60], [-t23, -t25, 0, 0, t23*t59 + t25*t60], [-t11, -p2, 0, 0, t11*t59 + t61], [-p3, p1, 0, 0, -p1*t60 + t62], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, -omega2*t0*t1*t11 - t35*t60], [t36, -t37, 0, 0, -t36*t59 + t37*t60]]
    return exponents, coefficients


def symmetric_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for
        parameter_jacobian.
    Gives residual (5).
    Gives jacobian (5, 5).
    Gives parameter_jacobian (5, 4).
    Operations: 240. Intermediate terms: 65.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z10, z20, v10, tau, tau1] = unknowns
    # half of tau
    half_tau = tau/2
    # functions of half_tau in slip-slip
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in slip-stick
    cos_half_tau1 = lib.cos(half_tau1)
    sin_half_tau1 = lib.sin(half_tau1)
    # residual
    t14 = p1*z10 + p2*z20
    t16 = -t14 + z10
    t17 = V*p2 + p1*v10
    t18 = 1/omega1
    t19 = sin_omega1_half_tau*t18
    t21 = t17 - v10
    t22 = 1/omega2
    t23 = sin_omega2_half_tau*t22
    t24 = p3*z10
    t25 = p1*z20
    t26 = t24 - t25 + z20
    t27 = -t24 + t25
    t28 = p3*v10
    t29 = V*p1 - t28
    t30 = V*p1 - V - t28
    t31 = chi*z20
    t32 = t31 - z10
    t33 = V*chi
    t34 = -t33 + v10
    t37 = V*half_tau1 - z20
    residual = [cos_omega1_half_tau*t14 + cos_omega2_half_tau*t16 + t17*t19 - t21*t23, cos_omega1_half_tau*t26 + cos_omega2_half_tau*t27 - t19*t30 + t23*t29, cos_half_tau1*t32 + half_tau1*t33 + sin_half_tau1*t34 - t31, t37, -chi*z10 - e2 + t31]
    if outputs == 1:
        return residual
    # d/dtau of: functions of half_tau in slip-slip
    t8 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t8
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t8
    t9 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t9
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t9
    # d/dtau1 of: functions of half_tau1 in slip-stick
    cos_half_tau1_by_tau1 = -sin_half_tau1/2
    sin_half_tau1_by_tau1 = cos_half_tau1/2
    # jacobian
    t38 = p1 - 1
    t40 = sin_omega1_half_tau_by_tau*t18
    t41 = sin_omega2_half_tau_by_tau*t22
    jacobian = [[cos_omega1_half_tau*p1 - cos_omega2_half_tau*t38, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, p1*sin_omega1_half_tau*t18 - t23*t38, cos_omega1_half_tau_by_tau*t14 + cos_omega2_half_tau_by_tau*t16 + t17*t40 - t21*t41, 0], [cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, -cos_omega1_half_tau*t38 + cos_omega2_half_tau*p1, p3*sin_omega1_half_tau*t18 - p3*t23, cos_omega1_half_tau_by_tau*t26 + cos_omega2_half_tau_by_tau*t27 + t29*t41 - t30*t40, 0], [-cos_half_tau1, chi*cos_half_tau1 - chi, sin_half_tau1, 0, cos_half_tau1_by_tau1*t32 + sin_half_tau1_by_tau1*t34 + t33/2], [0, -1, 0, 0, V/2], [-chi, chi, 0, 0, 0]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
    # d/dchi of: functions of half_tau in slip-slip
    t10 = half_tau*omega1_by_chi
    cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t10
    sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t10
    t11 = half_tau*omega2_by_chi
    cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t11
    sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t11
    # d/deta of: functions of half_tau in slip-slip
    t12 = half_tau*omega1_by_eta
    cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t12
    sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t12
    t13 = half_tau*omega2_by_eta
    cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t13
    sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t13
    # parameter_jacobian
    t43 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 + t19*v10 - t23*v10
    t44 = -V*sin_omega1_half_tau*t18 + V*t23 - cos_omega1_half_tau*z20 + cos_omega2_half_tau*z20
    t46 = t17*t18
    t47 = t21*t22
    t48 = sin_omega2_half_tau/omega2**2
    t49 = t21*t48
    t50 = sin_omega1_half_tau/omega1**2
    t51 = t17*t50
    t52 = t22*t29
    t53 = t18*t30
    t54 = t30*t50
    t55 = t29*t48
    parameter_jacobian = [[cos_omega1_half_tau_by_chi*t14 + cos_omega2_half_tau_by_chi*t16 - omega1_by_chi*t51 + omega2_by_chi*t49 + p1_by_chi*t43 - p2_by_chi*t44 + sin_omega1_half_tau_by_chi*t46 - sin_omega2_half_tau_by_chi*t47, cos_omega1_half_tau_by_eta*t14 + cos_omega2_half_tau_by_eta*t16 - omega1_by_eta*t51 + omega2_by_eta*t49 + p1_by_eta*t43 - p2_by_eta*t44 + sin_omega1_half_tau_by_eta*t46 - sin_omega2_half_tau_by_eta*t47, p2*sin_omega1_half_tau*t18 - p2*t23, 0], [cos_omega1_half_tau_by_chi*t26 + cos_omega2_half_tau_by_chi*t27 + omega1_by_chi*t54 - omega2_by_chi*t55 + p1_by_chi*t44 + p3_by_chi*t43 - sin_omega1_half_tau_by_chi*t53 + sin_omega2_half_tau_by_chi*t52, cos_omega1_half_tau_by_eta*t26 + cos_omega2_half_tau_by_eta*t27 + omega1_by_eta*t54 - omega2_by_eta*t55 + p1_by_eta*t44 + p3_by_eta*t43 - sin_omega1_half_tau_by_eta*t53 + sin_omega2_half_tau_by_eta*t52, p1*t23 - t19*t38, 0], [-V*sin_half_tau1 + cos_half_tau1*z20 + t37, 0, chi*half_tau1 - chi*sin_half_tau1, 0], [0, 0, half_tau1, 0], [-z10 + z20, 0, 0, -1]]
    return residual, jacobian, parameter_jacobian


def symmetric_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for trace_gradient.
    Gives trace.
    Gives trace_gradient (9).
    Operations: 672. Intermediate terms: 150.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z10, z20, v10, tau, tau1] = unknowns
    # functions of tau in slip-slip
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t3 = omega2*tau
    cos_omega2_tau = lib.cos(t3)
    sin_omega2_tau = lib.sin(t3)
    # slip-slip for tau, until second-reaches-belt
    t6 = 1/omega1
    t7 = p1*sin_omega1_tau
    t8 = 1/omega2
    t9 = p1 - 1
    t11 = -sin_omega2_tau*t9
    t12 = t11*t8 + t6*t7
    t13 = cos_omega1_tau*p1 - cos_omega2_tau*t9
    t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t15 = p2*sin_omega2_tau
    t16 = p2*sin_omega1_tau*t6 - t15*t8
    z1_1 = V*t16 + t12*v10 + t13*z10 + t14*z20
    t17 = p3*sin_omega2_tau
    t18 = p3*sin_omega1_tau*t6 - t17*t8
    t19 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t20 = -cos_omega1_tau*t9 + cos_omega2_tau*p1
    t21 = p1*sin_omega2_tau
    t22 = -sin_omega1_tau*t9
    t23 = t21*t8 + t22*t6
    z2_1 = V*t23 + t18*v10 + t19*z10 + t20*z20
    t24 = -omega2*t9
    t25 = omega1*p1
    t26 = sin_omega1_tau*t25 + sin_omega2_tau*t24
    t28 = omega1*p2
    t29 = -omega2*p2*sin_omega2_tau + sin_omega1_tau*t28
    v1_1 = V*t14 + t13*v10 - t26*z10 - t29*z20
    t31 = omega1*p3
    t32 = -omega2*p3*sin_omega2_tau + sin_omega1_tau*t31
    t34 = omega2*p1
    t35 = -omega1*t9
    t36 = sin_omega1_tau*t35 + sin_omega2_tau*t34
    v2_1 = V*t20 + t19*v10 - t32*z10 - t36*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t40 = -chi*cos_tau1 + chi
    t41 = chi*sin_tau1
    t42 = chi*tau1 - t41
    z1_2 = V*t42 + cos_tau1*z1_1 + sin_tau1*v1_1 + t40*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t40 + cos_tau1*v1_1 - sin_tau1*z1_1 + t41*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = t13 + t14
    carried_z1_1_by_v10 = t12
    carried_z2_1_by_z20 = t19 + t20
    carried_z2_1_by_v10 = t18
    carried_v1_1_by_z20 = -t26 - t29
    carried_v1_1_by_v10 = t13
    carried_v2_1_by_z20 = -t32 - t36
    carried_v2_1_by_v10 = t19
    # rate of the exit boundary after tau
    t43 = eta*z1_1
    t44 = chi*z2_1
    rate_1 = chi*t43 - eta*t44
    # derivatives of the time to the boundary after tau
    t45 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t45
    delay_tau_by_v10 = -carried_v2_1_by_v10*t45
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t46 = t44 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t46
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t46
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t40*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t40*z2_1_on_boundary_by_v10
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t41*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    t47 = V*chi
    rate_2 = -chi*v1_2 + t47
    # derivatives of the time to the boundary after tau1
    t48 = 1/rate_2
    t49 = chi*z2_1_on_boundary_by_z20
    t50 = carried_z1_2_by_z20*chi - t49
    delay_tau1_by_z20 = t48*t50
    t51 = chi*z2_1_on_boundary_by_v10
    t52 = carried_z1_2_by_v10*chi - t51
    delay_tau1_by_v10 = t48*t52
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    t53 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*t53
    trace = v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
    # back through: derivatives of the time to the boundary after tau1
    slope_by_delay_tau1_by_v10 = t53
    # back through: rate of the exit boundary after tau1
    t54 = 1/rate_2**2
    slope_by_rate_2 = -V*t50*t54 - slope_by_delay_tau1_by_v10*t52*t54
    # back through: Phi along tau1
    t55 = slope_by_delay_tau1_by_v10*t48
    slope_by_carried_z1_2_by_v10 = chi*t55
    slope_by_carried_z1_2_by_z20 = t47*t48
    # back through: perturbation on the boundary after tau
    slope_by_v1_1_on_boundary_by_v10 = cos_tau1 + sin_tau1*slope_by_carried_z1_2_by_v10
    slope_by_v1_1_on_boundary_by_z20 = sin_tau1*slope_by_carried_z1_2_by_z20
    slope_by_z2_1_on_boundary_by_v10 = slope_by_carried_z1_2_by_v10*t40 - slope_by_carried_z1_2_by_v10 + t41
    slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t40 - slope_by_carried_z1_2_by_z20 + 1
    slope_by_z1_1_on_boundary_by_v10 = cos_tau1*slope_by_carried_z1_2_by_v10 - sin_tau1
    slope_by_z1_1_on_boundary_by_z20 = cos_tau1*slope_by_carried_z1_2_by_z20
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_v10 = slope_by_v1_1_on_boundary_by_v10*t46 + slope_by_z1_1_on_boundary_by_v10*v1_1 + slope_by_z2_1_on_boundary_by_v10*v2_1
    slope_by_delay_tau_by_z20 = slope_by_v1_1_on_boundary_by_z20*t46 + slope_by_z1_1_on_boundary_by_z20*v1_1 + slope_by_z2_1_on_boundary_by_z20*v2_1
    # back through: rate of the exit boundary after tau
    t58 = 1/rate_1**2
    slope_by_rate_1 = carried_v2_1_by_v10*slope_by_delay_tau_by_v10*t58 + carried_v2_1_by_z20*slope_by_delay_tau_by_z20*t58
    # back through: Phi along tau
    slope_by_carried_v2_1_by_v10 = -slope_by_delay_tau_by_v10*t45
    slope_by_carried_v2_1_by_z20 = -slope_by_delay_tau_by_z20*t45
    # back through: slip-stick for tau1, until second-breaks-forward
    t59 = chi*slope_by_rate_2
    slope_by_v1_2 = -t59
    slope_by_z2_2 = chi*delay_tau1_by_v10
    slope_by_z1_2 = -delay_tau1_by_v10
    # back through: functions of tau1 in slip-stick
    t60 = -t47 + v1_1
    t61 = t51 - z1_1_on_boundary_by_v10
    slope_by_sin_tau1 = slope_by_carried_z1_2_by_v10*v1_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*v1_1_on_boundary_by_z20 + slope_by_v1_2*t46 + slope_by_z1_2*t60 + t61
    slope_by_cos_tau1 = -slope_by_carried_z1_2_by_v10*t61 + slope_by_carried_z1_2_by_z20*(-t49 + z1_1_on_boundary_by_z20) + slope_by_v1_2*t60 - slope_by_z1_2*t46 + v1_1_on_boundary_by_v10
    # back through: slip-slip for tau, until second-reaches-belt
    slope_by_v2_1 = delay_tau_by_v10*slope_by_z2_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z2_1_on_boundary_by_z20
    slope_by_v1_1 = cos_tau1*slope_by_v1_2 + delay_tau_by_v10*slope_by_z1_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z1_1_on_boundary_by_z20 + sin_tau1*slope_by_z1_2
    t62 = delay_tau_by_v10*slope_by_v1_1_on_boundary_by_v10
    t63 = delay_tau_by_z20*slope_by_v1_1_on_boundary_by_z20
    t64 = -chi*eta*slope_by_rate_1
    slope_by_z2_1 = chi*t62 + chi*t63 + slope_by_v1_2*t41 + slope_by_z1_2*t40 + slope_by_z2_2 + t64
    slope_by_z1_1 = cos_tau1*slope_by_z1_2 - sin_tau1*slope_by_v1_2 - t62 - t63 - t64
    # back through: functions of tau in slip-slip
    t65 = omega2*p2
    t66 = V*p2
    t67 = V*p1
    t68 = p3*v10
    t69 = p3*slope_by_z2_1_on_boundary_by_v10
    slope_by_sin_omega2_tau = slope_by_carried_v2_1_by_z20*(omega2*p3 - t34) + slope_by_v1_1*(-t24*z10 + t65*z20) + slope_by_v1_1_on_boundary_by_z20*(-t24 + t65) + slope_by_v2_1*(omega2*p3*z10 - t34*z20) + slope_by_z1_1*(-t66*t8 - t8*t9*v10) - slope_by_z1_1_on_boundary_by_v10*t8*t9 + slope_by_z2_1*(t67*t8 - t68*t8) - t69*t8
    t70 = p2*z20
    t71 = p1*z20
    t72 = p3*z10
    t73 = p3*slope_by_carried_v2_1_by_v10
    slope_by_cos_omega2_tau = slope_by_v1_1*(-t66 - t9*v10) - slope_by_v1_1_on_boundary_by_v10*t9 + slope_by_v2_1*(t67 - t68) + slope_by_z1_1*(-t70 - t9*z10) + slope_by_z1_1_on_boundary_by_z20*(-p2 - t9) + slope_by_z2_1*(t71 - t72) + slope_by_z2_1_on_boundary_by_z20*(p1 - p3) - t73
    t74 = p1*v10
    t75 = -V*t9
    slope_by_sin_omega1_tau = p1*slope_by_z1_1_on_boundary_by_v10*t6 + slope_by_carried_v2_1_by_z20*(-t31 - t35) + slope_by_v1_1*(-omega1*t70 - t25*z10) + slope_by_v1_1_on_boundary_by_z20*(-t25 - t28) + slope_by_v2_1*(-omega1*t72 - t35*z20) + slope_by_z1_1*(t6*t66 + t6*t74) + slope_by_z2_1*(t6*t68 + t6*t75) + t6*t69
    t76 = p1*z10
    t77 = -t9*z20
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_v10 + slope_by_v1_1*(t66 + t74) + slope_by_v2_1*(t68 + t75) + slope_by_z1_1*(t70 + t76) + slope_by_z1_1_on_boundary_by_z20*(p1 + p2) + slope_by_z2_1*(t72 + t77) + slope_by_z2_1_on_boundary_by_z20*(-p1 + p3 + 1) + t73
    # trace_gradient
    t78 = sin_omega2_tau*slope_by_cos_omega2_tau
    t79 = sin_omega1_tau*slope_by_cos_omega1_tau
    t80 = p3*sin_omega1_tau
    t81 = 1/omega1**2
    t82 = sin_omega1_tau*t81
    t83 = cos_omega1_tau*slope_by_sin_omega1_tau*tau + slope_by_carried_v2_1_by_z20*(-t22 - t80) + slope_by_v1_1*(-sin_omega1_tau*t70 - sin_omega1_tau*t76) + slope_by_v1_1_on_boundary_by_z20*(-p2*sin_omega1_tau - t7) + slope_by_v2_1*(-sin_omega1_tau*t72 - sin_omega1_tau*t77) + slope_by_z1_1*(-t66*t82 - t74*t82) - slope_by_z1_1_on_boundary_by_v10*t7*t81 + slope_by_z2_1*(-t68*t82 - t75*t82) - slope_by_z2_1_on_boundary_by_v10*t80*t81 - t79*tau
    t84 = 1/omega2**2
    t85 = sin_omega2_tau*t84
    t86 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + slope_by_carried_v2_1_by_z20*(p3*sin_omega2_tau - t21) + slope_by_v1_1*(sin_omega2_tau*t70 + sin_omega2_tau*t9*z10) + slope_by_v1_1_on_boundary_by_z20*(-t11 + t15) + slope_by_v2_1*(p3*sin_omega2_tau*z10 - sin_omega2_tau*t71) + slope_by_z1_1*(t66*t85 + t85*t9*v10) - slope_by_z1_1_on_boundary_by_v10*t11*t84 + slope_by_z2_1*(p3*sin_omega2_tau*t84*v10 - t67*t85) + slope_by_z2_1_on_boundary_by_v10*t17*t84 - t78*tau
    t87 = omega1*sin_omega1_tau - omega2*sin_omega2_tau
    t88 = cos_omega1_tau - cos_omega2_tau
    t90 = -t87*z10 + t88*v10
    t92 = -sin_omega1_tau*t6 + sin_omega2_tau*t8
    t94 = t88*z10 - t92*v10
    t95 = -slope_by_v1_1_on_boundary_by_z20*t87 + slope_by_z1_1_on_boundary_by_z20*t88
    t96 = slope_by_carried_v2_1_by_z20*t87 + slope_by_v1_1*t90 + slope_by_v1_1_on_boundary_by_v10*t88 + slope_by_v2_1*(-V*t88 + t87*z20) + slope_by_z1_1*t94 - slope_by_z1_1_on_boundary_by_v10*t92 + slope_by_z2_1*(V*t92 - t88*z20) - slope_by_z2_1_on_boundary_by_z20*t88 + t95
    t97 = slope_by_v1_1*(V*t88 - t87*z20) + slope_by_z1_1*(-V*t92 + t88*z20) + t95
    t98 = slope_by_carried_v2_1_by_v10*t88 - slope_by_carried_v2_1_by_z20*t87 + slope_by_v2_1*t90 + slope_by_z2_1*t94 - slope_by_z2_1_on_boundary_by_v10*t92 + slope_by_z2_1_on_boundary_by_z20*t88
    t99 = 1 - cos_tau1
    trace_gradient = [-slope_by_v1_1*t26 - slope_by_v2_1*t32 + slope_by_z1_1*t13 + slope_by_z2_1*t19, -slope_by_v1_1*t29 - slope_by_v2_1*t36 + slope_by_z1_1*t14 + slope_by_z2_1*t20, slope_by_v1_1*t13 + slope_by_v2_1*t19 + slope_by_z1_1*t12 + slope_by_z2_1*t18, cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t79 - omega2*t78, V*slope_by_z2_2 + cos_tau1*slope_by_sin_tau1 - sin_tau1*slope_by_cos_tau1 + slope_by_z1_2*t47, V*t48*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + delay_tau1_by_v10*z2_2 + omega1_by_chi*t83 + omega2_by_chi*t86 + p1_by_chi*t96 + p2_by_chi*t97 + p3_by_chi*t98 + sin_tau1*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_v10*t99*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*t99*z2_1_on_boundary_by_z20 + slope_by_rate_1*(-eta*z2_1 + t43) + slope_by_rate_2*(V - v1_2) + slope_by_v1_2*(V*t99 + sin_tau1*z2_1) + slope_by_z1_2*(V*(-sin_tau1 + tau1) + t99*z2_1) + t55*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10) + t62*z2_1 + t63*z2_1, omega1_by_eta*t83 + omega2_by_eta*t86 + p1_by_eta*t96 + p2_by_eta*t97 + p3_by_eta*t98 + slope_by_rate_1*(chi*z1_1 - t44), delay_tau1_by_z20 + slope_by_v1_1*t14 + slope_by_v1_2*t40 + slope_by_v2_1*t20 + slope_by_z1_1*t16 + slope_by_z1_2*t42 + slope_by_z2_1*t23 + slope_by_z2_2*tau1 + t59, 0]
    return trace, trace_gradient


def symmetric_passage(parameters, spectrum, unknowns, *, lib, outputs=3):
    """State at the start and behind each transition. Boundaries along the phases: constant,
    slope, cosine and sine amplitudes, one after the other; and the frequencies of each
    phase.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives states (3, 4).
    Gives coefficients (24).
    Gives frequencies (3).
    Operations: 141. Intermediate terms: 36.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z10, z20, v10, tau, tau1] = unknowns
    # functions of tau in slip-slip
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t1 = omega2*tau
    cos_omega2_tau = lib.cos(t1)
    sin_omega2_tau = lib.sin(t1)
    # slip-slip for tau, until second-reaches-belt
    t2 = 1/omega1
    t3 = sin_omega1_tau*t2
    t4 = 1 - p1
    t5 = sin_omega2_tau/omega2
    t6 = cos_omega1_tau*p1 + cos_omega2_tau*t4
    t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*z10 + t7*z20 + v10*(p1*t3 + t4*t5)
    z2_1 = V*(p1*t5 + t3*t4) + v10*(p3*sin_omega1_tau*t2 - p3*t5) + z10*(cos_omega1_tau*p3 - cos_omega2_tau*p3) + z20*(cos_omega1_tau*t4 + cos_omega2_tau*p1)
    t8 = omega1*sin_omega1_tau
    v1_1 = V*t7 + t6*v10 + z10*(-omega2*sin_omega2_tau*t4 - p1*t8) + z20*(omega2*p2*sin_omega2_tau - p2*t8)
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t9 = -chi*cos_tau1 + chi
    t10 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t10) + cos_tau1*z1_1 + sin_tau1*v1_1 + t9*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t9 + cos_tau1*v1_1 - sin_tau1*z1_1 + t10*z2_1
    states = [[z10, z20, v10, V], [z1_1, z2_1, v1_1, V], [z1_2, z2_2, v1_2, V]]
    if outputs == 1:
        return states
    # coefficients
    t12 = V*p2
    t13 = omega1*z10
    t14 = p2*z20
    t15 = p3*v10
    t16 = V*chi
    t17 = -t16 + v1_1
    t18 = chi*z2_1
    t19 = t18 - z1_1
    t20 = chi**2
    t21 = t20*z2_1
    t22 = V*t20 - t16
    t23 = -chi*t19
    t24 = chi*t17
    coefficients = [-V, 0, p1*v10 + t12, -t12 + t4*v10, -omega1*t14 - p1*t13, omega2*t14 - omega2*t4*z10, -V, 0, V*t4 + t15, V*p1 - t15, -omega1*t4*z20 - p3*t13, -omega2*p1*z20 + omega2*p3*z10, -V + t16, 0, t17, t19, -e2 + t18 - t21, -t22, -t23, -t24, -e2 - t18 + t21, t22, t23, t24]
    if outputs == 2:
        return states, coefficients
    frequencies = [omega1, omega2, 1]
    return states, coefficients, frequencies


def symmetric_linearisation(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Jacobian of the Poincare map in the section's coordinates; saltation matrices, one
    below the other; monodromy matrix.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives poincare_jacobian (2, 2).
    Gives saltations (8, 4).
    Gives monodromy (4, 4).
    Operations: 285. Intermediate terms: 123.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z10, z20, v10, tau, tau1] = unknowns
    # functions of tau in slip-slip
    t0 = omega1*tau
    cos_omega1_tau = lib.cos(t0)
    sin_omega1_tau = lib.sin(t0)
    t1 = omega2*tau
    cos_omega2_tau = lib.cos(t1)
    sin_omega2_tau = lib.sin(t1)
    # slip-slip for tau, until second-reaches-belt
    t2 = 1/omega1
    t3 = sin_omega1_tau*t2
    t4 = 1 - p1
    t5 = sin_omega2_tau/omega2
    t6 = p1*t3 + t4*t5
    t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4
    t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t9 = p2*sin_omega1_tau*t2 - p2*t5
    z1_1 = V*t9 + t6*v10 + t7*z10 + t8*z20
    t10 = p3*sin_omega1_tau*t2 - p3*t5
    t11 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t12 = cos_omega1_tau*t4 + cos_omega2_tau*p1
    t13 = p1*t5 + t3*t4
    z2_1 = V*t13 + t10*v10 + t11*z10 + t12*z20
    t14 = omega2*sin_omega2_tau
    t15 = omega1*sin_omega1_tau
    t16 = p1*t15 + t14*t4
    t18 = -omega2*p2*sin_omega2_tau + p2*t15
    v1_1 = V*t8 - t16*z10 - t18*z20 + t7*v10
    t20 = -omega2*p3*sin_omega2_tau + p3*t15
    t22 = p1*t14 + t15*t4
    v2_1 = V*t12 + t11*v10 - t20*z10 - t22*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t24 = -chi*cos_tau1 + chi
    t25 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t25) + cos_tau1*z1_1 + sin_tau1*v1_1 + t24*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t24 + cos_tau1*v1_1 - sin_tau1*z1_1 + t25*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = t7 + t8
    carried_z1_1_by_v10 = t6
    carried_z2_1_by_z20 = t11 + t12
    carried_z2_1_by_v10 = t10
    carried_v1_1_by_z20 = -t16 - t18
    carried_v1_1_by_v10 = t7
    carried_v2_1_by_z20 = -t20 - t22
    carried_v2_1_by_v10 = t11
    # rate of the exit boundary after tau
    t26 = chi*eta
    t27 = chi*z2_1
    rate_1 = -eta*t27 + t26*z1_1
    # derivatives of the time to the boundary after tau
    t29 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t29
    delay_tau_by_v10 = -carried_v2_1_by_v10*t29
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t30 = t27 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t30
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t30
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t24*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t24*z2_1_on_boundary_by_v10
    carried_v1_2_by_z20 = cos_tau1*v1_1_on_boundary_by_z20 - sin_tau1*z1_1_on_boundary_by_z20 + t25*z2_1_on_boundary_by_z20
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t25*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    rate_2 = V*chi - chi*v1_2
    # derivatives of the time to the boundary after tau1
    t32 = 1/rate_2
    delay_tau1_by_z20 = t32*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    delay_tau1_by_v10 = t32*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10)
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    z2_2_on_boundary_by_v10 = V*delay_tau1_by_v10 + z2_1_on_boundary_by_v10
    t33 = chi*z2_2
    t34 = t33 - z1_2
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau1_by_z20*t34
    v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*t34
    poincare_jacobian = [[z2_2_on_boundary_by_z20, z2_2_on_boundary_by_v10], [v1_2_on_boundary_by_z20, v1_2_on_boundary_by_v10]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 1
    before_v1_1 = t30
    before_v2_1 = rate_1
    behind_v1_1 = t30
    # vector fields at transition 2
    before_v1_2 = t34
    behind_v1_2 = t34
    behind_v2_2 = -eta*t33 + t26*z1_2
    # saltations
    t35 = 1/before_v2_1
    t36 = t35*(V - v2_1)
    t37 = t35*(-before_v1_1 + behind_v1_1)
    t38 = 1/rate_2
    t39 = chi*t38
    t40 = t39*(-before_v1_2 + behind_v1_2)
    t41 = behind_v2_2*t39
    saltations = [[1, 0, 0, 0], [0, 1, 0, t36], [0, 0, 1, t37], [0, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [-t40, t40, 1, 0], [-t41, t41, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 1
    phi_1_00 = t7
    phi_1_01 = t8
    phi_1_02 = t6
    phi_1_03 = t9
    phi_1_10 = t11
    phi_1_11 = t12
    phi_1_12 = t10
    phi_1_13 = t13
    phi_1_20 = -t16
    phi_1_21 = -t18
    phi_1_22 = t7
    phi_1_23 = t8
    phi_1_30 = -t20
    phi_1_31 = -t22
    phi_1_32 = t11
    phi_1_33 = t12
    # saltation of phase 1
    saltation_1_10 = phi_1_10 + phi_1_30*t36
    saltation_1_11 = phi_1_11 + phi_1_31*t36
    saltation_1_12 = phi_1_12 + phi_1_32*t36
    saltation_1_13 = phi_1_13 + phi_1_33*t36
    saltation_1_20 = phi_1_20 + phi_1_30*t37
    saltation_1_21 = phi_1_21 + phi_1_31*t37
    saltation_1_22 = phi_1_22 + phi_1_32*t37
    saltation_1_23 = phi_1_23 + phi_1_33*t37
    # Phi of phase 2
    phi_2_00 = cos_tau1*phi_1_00 + saltation_1_10*t24 + saltation_1_20*sin_tau1
    phi_2_01 = cos_tau1*phi_1_01 + saltation_1_11*t24 + saltation_1_21*sin_tau1
    phi_2_02 = cos_tau1*phi_1_02 + saltation_1_12*t24 + saltation_1_22*sin_tau1
    phi_2_03 = cos_tau1*phi_1_03 + saltation_1_13*t24 + saltation_1_23*sin_tau1
    phi_2_20 = cos_tau1*saltation_1_20 - phi_1_00*sin_tau1 + saltation_1_10*t25
    phi_2_21 = cos_tau1*saltation_1_21 - phi_1_01*sin_tau1 + saltation_1_11*t25
    phi_2_22 = cos_tau1*saltation_1_22 - phi_1_02*sin_tau1 + saltation_1_12*t25
    phi_2_23 = cos_tau1*saltation_1_23 - phi_1_03*sin_tau1 + saltation_1_13*t25
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t40 + phi_2_20 + saltation_1_10*t40
    saltation_2_21 = -phi_2_01*t40 + phi_2_21 + saltation_1_11*t40
    saltation_2_22 = -phi_2_02*t40 + phi_2_22 + saltation_1_12*t40
    saltation_2_23 = -phi_2_03*t40 + phi_2_23 + saltation_1_13*t40
    saltation_2_30 = behind_v2_2*chi*saltation_1_10*t38 - phi_2_00*t41
    saltation_2_31 = behind_v2_2*chi*saltation_1_11*t38 - phi_2_01*t41
    saltation_2_32 = behind_v2_2*chi*saltation_1_12*t38 - phi_2_02*t41
    saltation_2_33 = behind_v2_2*chi*saltation_1_13*t38 - phi_2_03*t41
    monodromy = [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [saltation_1_10, saltation_1_11, saltation_1_12, saltation_1_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]
    return poincare_jacobian, saltations, monodromy


def symmetric_flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    t = time
    [z1, z2, v1, v2] = state
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
    t14 = omega2*t6
    t15 = omega1*t2
    return [t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15), t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4)]


def symmetric_flow_slip_stick(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-stick.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 23. Intermediate terms: 4.
    """
    [chi, _, _, _] = parameters
    t = time
    [z1, z2, v1, v2] = state
    # state_after
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def symmetric_reduced(parameters, spectrum, reduced, *, lib, outputs=4):
    """All unknowns from the reduced ones; how singular the linear equations for them are: 0
    if they are; the equations for these and their derivatives.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives unknowns (5).
    Gives determinants (1).
    Gives reduced_residual (2).
    Gives reduced_jacobian (2, 2).
    Operations: 208. Intermediate terms: 62.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [tau, tau1] = reduced
    # half of tau
    half_tau = tau/2
    # functions of half_tau in slip-slip
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t3 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t3)
    sin_omega2_half_tau = lib.sin(t3)
    # half of tau1
    half_tau1 = tau1/2
    # coefficients of the linear equations
    t8 = 1/omega2
    t9 = sin_omega2_half_tau*t8
    t10 = 1/omega1
    t11 = p1*t10
    t12 = p1*t9
    coefficient11 = sin_omega1_half_tau*t11 - t12 + t9
    # right-hand sides of the linear equations
    t13 = V*half_tau1
    t14 = cos_omega2_half_tau*t13
    t15 = 1/chi
    t16 = p1*t13
    t17 = cos_omega1_half_tau*t16
    t18 = p2*t13
    t19 = e2*t15
    t20 = cos_omega2_half_tau*t19
    t21 = V*t10
    t22 = sin_omega1_half_tau*t21
    right1 = V*cos_omega2_half_tau*half_tau1*p1 + V*cos_omega2_half_tau*half_tau1*p2 + V*p2*sin_omega2_half_tau*t8 + cos_omega1_half_tau*e2*p1*t15 - cos_omega1_half_tau*t18 + cos_omega2_half_tau*e2*t15 - p1*t20 - p2*t22 - t14 - t17
    # determinant of the linear equations
    determinant = coefficient11
    # v10 by Cramer's rule
    t23 = 1/determinant
    v10 = right1*t23
    # z10: linear in: second-breaks-forward ends slip-stick
    z10 = t13 - t19
    # z20: linear in: z2 vanishes halfway through slip-stick
    z20 = t13
    unknowns = [z10, z20, v10, tau, tau1]
    if outputs == 1:
        return unknowns
    # determinants
    t34 = half_tau**2
    t35 = 2*t34
    determinants = [determinant/lib.sqrt(p1**2*t35/(omega1**2*t34 + 1) + t35*(p1 - 1)**2/(omega2**2*t34 + 1))]
    if outputs == 2:
        return unknowns, determinants
    # functions of half_tau1 in slip-stick
    cos_half_tau1 = lib.cos(half_tau1)
    sin_half_tau1 = lib.sin(half_tau1)
    # reduced_residual
    t36 = cos_omega1_half_tau*t13
    t37 = p3*v10
    t38 = t10*t37
    t39 = p3*t19
    t40 = cos_half_tau1*t13
    t41 = V*chi
    reduced_residual = [V*t12 - cos_omega1_half_tau*t39 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t36 + sin_omega1_half_tau*t38 - t17 + t22 + t36 - t37*t9, chi*t40 + cos_half_tau1*t19 - sin_half_tau1*t41 + sin_half_tau1*v10 - t40]
    if outputs == 3:
        return unknowns, determinants, reduced_residual
    # d/dtau of: functions of half_tau in slip-slip
    t24 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t24
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t24
    t25 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t25
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t25
    # d/dtau1 of: functions of half_tau1 in slip-stick
    cos_half_tau1_by_tau1 = -sin_half_tau1/2
    sin_half_tau1_by_tau1 = cos_half_tau1/2
    # d/dtau of: coefficients of the linear equations
    t26 = p1*t8
    coefficient11_by_tau = sin_omega1_half_tau_by_tau*t11 + sin_omega2_half_tau_by_tau*(-t26 + t8)
    # d/dtau of: right-hand sides of the linear equations
    t27 = -p1*t19 + t16 + t18
    t29 = -t13 + t19
    right1_by_tau = V*p2*sin_omega2_half_tau_by_tau*t8 - cos_omega1_half_tau_by_tau*t27 + cos_omega2_half_tau_by_tau*(t27 + t29) - p2*sin_omega1_half_tau_by_tau*t21
    # d/dtau1 of: right-hand sides of the linear equations
    t30 = V/2
    t31 = cos_omega2_half_tau*t30
    t32 = cos_omega1_half_tau*t30
    t33 = p1*t32
    right1_by_tau1 = V*cos_omega2_half_tau*p1/2 + V*cos_omega2_half_tau*p2/2 - p2*t32 - t31 - t33
    # d/dtau of: v10 by Cramer's rule
    v10_by_tau = -coefficient11_by_tau*right1/determinant**2 + right1_by_tau*t23
    # d/dtau1 of: v10 by Cramer's rule
    v10_by_tau1 = right1_by_tau1*t23
    # reduced_jacobian
    t42 = -p3*t13 + t16 + t39
    t43 = p3*sin_omega1_half_tau*t10 - p3*t9
    reduced_jacobian = [[cos_omega1_half_tau_by_tau*(t13 - t42) + cos_omega2_half_tau_by_tau*t42 + sin_omega1_half_tau_by_tau*(-p1*t21 + t21 + t38) + sin_omega2_half_tau_by_tau*(V*t26 - t37*t8) + t43*v10_by_tau, p1*t31 - p3*t31 + p3*t32 + t32 - t33 + t43*v10_by_tau1], [sin_half_tau1*v10_by_tau, -cos_half_tau1*t30 + cos_half_tau1*t41/2 + cos_half_tau1_by_tau1*(chi*t13 + t29) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t41 + v10)]]
    return unknowns, determinants, reduced_residual, reduced_jacobian


def global_stick_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for
        parameter_jacobian.
    Gives residual (6).
    Gives jacobian (6, 6).
    Gives parameter_jacobian (6, 5).
    Operations: 683. Intermediate terms: 198.
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
    t10 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t10)
    sin_omega2_tau1 = lib.sin(t10)
    # slip-slip for tau1, until first-reaches-belt
    t13 = 1/omega1
    t14 = sin_omega1_tau1*t13
    t15 = 1 - p1
    t16 = 1/omega2
    t17 = sin_omega2_tau1*t16
    t18 = p1*t14 + t15*t17
    t19 = cos_omega1_tau1*p1 + cos_omega2_tau1*t15
    t20 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t21 = p2*t17
    z1_3 = V*(p2*sin_omega1_tau1*t13 - t21) + t18*v1_2 + t19*z1_2 + t20*z2_2
    t22 = p3*sin_omega1_tau1*t13 - p3*t17
    t23 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t24 = cos_omega1_tau1*t15 + cos_omega2_tau1*p1
    t25 = p1*t17 + t14*t15
    z2_3 = V*t25 + t22*v1_2 + t23*z1_2 + t24*z2_2
    t26 = omega2*sin_omega2_tau1
    t27 = omega1*sin_omega1_tau1
    t28 = -p1*t27 - t15*t26
    t29 = p2*t27
    t30 = omega2*p2*sin_omega2_tau1 - t29
    t31 = V*t20
    t32 = t19*v1_2 + t31
    v1_3 = t28*z1_2 + t30*z2_2 + t32
    t33 = omega2*p3*sin_omega2_tau1 - p3*t27
    t34 = p1*t26 + t15*t27
    t36 = V*t24
    t37 = t23*v1_2 + t36
    v2_3 = t33*z1_2 - t34*z2_2 + t37
    # functions of tau2 in stick-slip
    t38 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t38)
    sin_omega3_tau2 = lib.sin(t38)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t41 = 1 - cos_omega3_tau2
    t42 = 1/omega3
    t43 = sin_omega3_tau2*t42
    t44 = -t43 + tau2
    z2_4 = V*t44 + cos_omega3_tau2*z2_3 + t41*z1_3 + t43*v2_3
    t45 = cos_omega3_tau2*v2_3
    t46 = sin_omega3_tau2*z1_3
    t47 = sin_omega3_tau2*z2_3
    v2_4 = V*t41 + omega3*t46 - omega3*t47 + t45
    residual = [-chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]
    if outputs == 1:
        return residual
    # derivatives of the state after tau
    z1_2_by_z20 = t4
    z1_2_by_ta = t6
    v1_2_by_z10 = -sin_tau
    v1_2_by_z20 = t5
    v1_2_by_ta = chi*t1 - t1
    v1_2_by_tau = chi*z2_2 - z1_2
    # derivatives of the state after tau1
    z1_3_by_z10 = cos_tau*t19 + t18*v1_2_by_z10
    z1_3_by_z20 = t18*v1_2_by_z20 + t19*z1_2_by_z20 + t20
    z1_3_by_ta = t18*v1_2_by_ta + t19*z1_2_by_ta + t31
    z1_3_by_tau = t18*v1_2_by_tau + t32
    z2_3_by_z10 = cos_tau*t23 + t22*v1_2_by_z10
    z2_3_by_z20 = t22*v1_2_by_z20 + t23*z1_2_by_z20 + t24
    z2_3_by_ta = t22*v1_2_by_ta + t23*z1_2_by_ta + t36
    z2_3_by_tau = t22*v1_2_by_tau + t37
    v1_3_by_z10 = cos_tau*t28 + t19*v1_2_by_z10
    v1_3_by_z20 = p2*t26 + t19*v1_2_by_z20 + t28*z1_2_by_z20 - t29
    t48 = V*t30
    v1_3_by_ta = t19*v1_2_by_ta + t28*z1_2_by_ta + t48
    v1_3_by_tau = t19*v1_2_by_tau + t28*v1_2 + t48
    t49 = chi*z2_3
    v1_3_by_tau1 = t49 - z1_3
    v2_3_by_z10 = cos_tau*t33 + t23*v1_2_by_z10
    v2_3_by_z20 = t23*v1_2_by_z20 + t33*z1_2_by_z20 - t34
    t50 = -V*t34
    v2_3_by_ta = t23*v1_2_by_ta + t33*z1_2_by_ta + t50
    v2_3_by_tau = t23*v1_2_by_tau + t33*v1_2 + t50
    t51 = chi*eta
    v2_3_by_tau1 = -eta*t49 + t51*z1_3
    # derivatives of the state after tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t41*z1_3_by_z10 + t43*v2_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t41*z1_3_by_z20 + t43*v2_3_by_z20
    z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t41*z1_3_by_ta + t43*v2_3_by_ta
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t41*z1_3_by_tau + t43*v2_3_by_tau
    z2_4_by_tau1 = t41*v1_3 + t43*v2_3_by_tau1 + t45
    t52 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t52*z1_3_by_z10 - t52*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t52*z1_3_by_z20 - t52*z2_3_by_z20
    v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t52*z1_3_by_ta - t52*z2_3_by_ta
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t52*z1_3_by_tau - t52*z2_3_by_tau
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t52*v1_3 - t52*v2_3
    v2_4_by_tau2 = t51*z1_4 - t51*z2_4
    # jacobian
    t118 = V*chi
    jacobian = [[1, -chi, V - t118, 0, 0, 0], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_ta + t118, -chi*v1_2 + t118, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_ta, v1_3_by_tau, v1_3_by_tau1, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_ta, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_ta, z1_3_by_tau, v1_3, V], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_ta, z2_4_by_tau, z2_4_by_tau1, v2_4]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t53 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t53*z2_1
    v1_2_by_chi = V*t53 + sin_tau*z2_1
    # d/dV of: slip-stick for tau, until second-breaks-forward
    z1_2_by_V = chi*tau + cos_tau*ta + sin_tau + t4*ta - t5
    z2_2_by_V = ta + tau
    v1_2_by_V = chi + cos_tau - sin_tau*ta - t3 + t5*ta
    # d/dchi of: functions of tau1 in slip-slip
    t55 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t55
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t55
    t56 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t56
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t56
    # d/deta of: functions of tau1 in slip-slip
    t57 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t57
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t57
    t58 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t58
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t58
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t59 = p1*z1_2
    t60 = p2*z2_2
    t61 = t59 + t60
    t62 = t15*z1_2 - t60
    t63 = p1*v1_2
    t64 = sin_omega1_tau1/omega1**2
    t65 = V*p2
    t66 = -t63*t64 - t64*t65
    t67 = 1/omega2**2
    t68 = sin_omega2_tau1*t67
    t69 = -t15*t68*v1_2 + t65*t68
    t70 = -sin_omega1_tau1*t13 + t17
    t72 = cos_omega1_tau1 - cos_omega2_tau1
    t73 = -t70*v1_2 + t72*z1_2
    t74 = -V*t70 + t72*z2_2
    t75 = t13*t63 + t13*t65
    t76 = t15*t16*v1_2 - t16*t65
    z1_3_by_chi = cos_omega1_tau1_by_chi*t61 + cos_omega2_tau1_by_chi*t62 + omega1_by_chi*t66 + omega2_by_chi*t69 + p1_by_chi*t73 + p2_by_chi*t74 + sin_omega1_tau1_by_chi*t75 + sin_omega2_tau1_by_chi*t76 + t18*v1_2_by_chi + t19*z1_2_by_chi
    t77 = p3*z1_2
    t78 = t15*z2_2
    t79 = t77 + t78
    t80 = p1*z2_2
    t81 = -t77 + t80
    t82 = p3*v1_2
    t83 = V*t15
    t84 = -t64*t82 - t64*t83
    t85 = V*p1
    t86 = p3*sin_omega2_tau1*t67*v1_2 - t68*t85
    t88 = V*t70 - t72*z2_2
    t89 = t13*t82 + t13*t83
    t90 = -t16*t82 + t16*t85
    z2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t81 + omega1_by_chi*t84 + omega2_by_chi*t86 + p1_by_chi*t88 + p3_by_chi*t73 + sin_omega1_tau1_by_chi*t89 + sin_omega2_tau1_by_chi*t90 + t22*v1_2_by_chi + t23*z1_2_by_chi
    t91 = t63 + t65
    t92 = t15*v1_2 - t65
    t93 = -sin_omega1_tau1*t59 - sin_omega1_tau1*t60
    t94 = t15*z1_2
    t95 = sin_omega2_tau1*t60 - sin_omega2_tau1*t94
    t96 = -omega2*sin_omega2_tau1 + t27
    t98 = t72*v1_2 - t96*z1_2
    t99 = V*t72 - t96*z2_2
    t100 = -omega1*t59 - omega1*t60
    t101 = omega2*t60 - omega2*t94
    v1_3_by_chi = cos_omega1_tau1_by_chi*t91 + cos_omega2_tau1_by_chi*t92 + omega1_by_chi*t93 + omega2_by_chi*t95 + p1_by_chi*t98 + p2_by_chi*t99 + sin_omega1_tau1_by_chi*t100 + sin_omega2_tau1_by_chi*t101 + t19*v1_2_by_chi + t28*z1_2_by_chi
    t102 = t82 + t83
    t103 = -t82 + t85
    t104 = -sin_omega1_tau1*t77 - sin_omega1_tau1*t78
    t105 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t80
    t106 = -V*t72 + t96*z2_2
    t107 = -omega1*t77 - omega1*t78
    t108 = omega2*p3*z1_2 - omega2*t80
    v2_3_by_chi = cos_omega1_tau1_by_chi*t102 + cos_omega2_tau1_by_chi*t103 + omega1_by_chi*t104 + omega2_by_chi*t105 + p1_by_chi*t106 + p3_by_chi*t98 + sin_omega1_tau1_by_chi*t107 + sin_omega2_tau1_by_chi*t108 + t23*v1_2_by_chi + t33*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t61 + cos_omega2_tau1_by_eta*t62 + omega1_by_eta*t66 + omega2_by_eta*t69 + p1_by_eta*t73 + p2_by_eta*t74 + sin_omega1_tau1_by_eta*t75 + sin_omega2_tau1_by_eta*t76
    z2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t81 + omega1_by_eta*t84 + omega2_by_eta*t86 + p1_by_eta*t88 + p3_by_eta*t73 + sin_omega1_tau1_by_eta*t89 + sin_omega2_tau1_by_eta*t90
    v1_3_by_eta = cos_omega1_tau1_by_eta*t91 + cos_omega2_tau1_by_eta*t92 + omega1_by_eta*t93 + omega2_by_eta*t95 + p1_by_eta*t98 + p2_by_eta*t99 + sin_omega1_tau1_by_eta*t100 + sin_omega2_tau1_by_eta*t101
    v2_3_by_eta = cos_omega1_tau1_by_eta*t102 + cos_omega2_tau1_by_eta*t103 + omega1_by_eta*t104 + omega2_by_eta*t105 + p1_by_eta*t106 + p3_by_eta*t98 + sin_omega1_tau1_by_eta*t107 + sin_omega2_tau1_by_eta*t108
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = p2*t14 + t18*v1_2_by_V + t19*z1_2_by_V + t20*z2_2_by_V - t21
    z2_3_by_V = t22*v1_2_by_V + t23*z1_2_by_V + t24*z2_2_by_V + t25
    v1_3_by_V = t19*v1_2_by_V + t20 + t28*z1_2_by_V + t30*z2_2_by_V
    v2_3_by_V = t23*v1_2_by_V + t24 + t33*z1_2_by_V - t34*z2_2_by_V
    # d/dchi of: functions of tau2 in stick-slip
    t109 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t109
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t109
    # d/deta of: functions of tau2 in stick-slip
    t110 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t110
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t110
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t111 = -z1_3 + z2_3
    t112 = sin_omega3_tau2/omega3**2
    t113 = V*t112 - t112*v2_3
    t114 = -V*t42 + t42*v2_3
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t111 + omega3_by_chi*t113 + sin_omega3_tau2_by_chi*t114 + t41*z1_3_by_chi + t43*v2_3_by_chi
    t115 = -V + v2_3
    t116 = t46 - t47
    t117 = omega3*z1_3 - omega3*z2_3
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t115 + omega3_by_chi*t116 + sin_omega3_tau2_by_chi*t117 + t52*z1_3_by_chi - t52*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t111 + omega3_by_eta*t113 + sin_omega3_tau2_by_eta*t114 + t41*z1_3_by_eta + t43*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t115 + omega3_by_eta*t116 + sin_omega3_tau2_by_eta*t117 + t52*z1_3_by_eta - t52*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t41*z1_3_by_V + t43*v2_3_by_V + t44
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t52*z1_3_by_V - t52*z2_3_by_V + 1
    parameter_jacobian = [[-z2_1, 0, -chi*ta + ta, -1, 0], [-chi*z1_2_by_chi - z1_2 + z2_2, 0, -chi*z1_2_by_V + chi*z2_2_by_V, 0, -1], [v1_3_by_chi, v1_3_by_eta, v1_3_by_V - 1, 0, 0], [v2_4_by_chi, v2_4_by_eta, v2_4_by_V - 1, 0, 0], [z1_3_by_chi, z1_3_by_eta, z1_4_by_V, 0, 0], [z2_4_by_chi, z2_4_by_eta, z2_4_by_V, 0, 0]]
    return residual, jacobian, parameter_jacobian


def global_stick_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for trace_gradient.
    Gives trace.
    Gives trace_gradient (11).
    Operations: 774. Intermediate terms: 175.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, _, tau, tau1, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t2 = V*tau
    t3 = chi - 1
    t4 = 1/t3
    t5 = e1*t4
    t6 = 1/chi
    t7 = e2*t6
    z2_1 = V*sin_tau - cos_tau*t5 - t2 - t4*t7
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
    t27 = p2*sin_omega1_tau1*t19 - p2*t23
    z1_3 = V*t27 + t24*v1_2 + t25*z1_2 + t26*z2_2
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
    t39 = -V*sin_tau_by_tau
    t40 = cos_tau_by_tau*e1
    z2_1_by_tau = -V - t39 - t4*t40
    # d/dtau of: slip-stick for tau
    t41 = V*chi
    t42 = V - t41
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t42 + t40 + t41
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t42 - e1*sin_tau_by_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t24*v1_2_by_tau + t25*z1_2_by_tau + t26*z2_2_by_tau
    z2_3_by_tau = t28*v1_2_by_tau + t29*z1_2_by_tau + t30*z2_2_by_tau
    v1_3_by_tau = t25*v1_2_by_tau + t34*z1_2_by_tau + t35*z2_2_by_tau
    v2_3_by_tau = t29*v1_2_by_tau + t36*z1_2_by_tau + t37*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t44 = chi*z2_3
    v1_3_by_tau1 = t44 - z1_3
    t45 = eta*z1_3
    v2_3_by_tau1 = chi*t45 - eta*t44
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t46 = 2*cosine_part_tau2
    t47 = 2*sine_part_tau2
    t48 = sine_part_tau2_by_tau*t47 + t46*v2_3_by_tau
    t49 = 1/amplitude_tau2
    t50 = t49/2
    amplitude_tau2_by_tau = t48*t50
    # d/dtau1 of: first return of tau2
    t51 = sine_part_tau2_by_tau1*t47 + t46*v2_3_by_tau1
    amplitude_tau2_by_tau1 = t50*t51
    # trace
    t53 = 1/z2_1_by_tau
    t52 = 1/v1_3_by_tau1
    t54 = 1/omega3
    t55 = t4*t54
    t60 = amplitude_tau2_by_tau1*v1_3_by_tau
    t62 = amplitude_tau2_by_tau*t55 - t52*t55*t60
    trace = t53*t62
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # back through: d/dtau1 of: first return of tau2
    t56 = t53*t55
    t57 = t52*t56
    slope_by_amplitude_tau2_by_tau1 = -t57*v1_3_by_tau
    # back through: d/dtau of: first return of tau2
    slope_by_amplitude_tau2_by_tau = t56
    # back through: d/dtau1 of: first return of tau2
    t58 = sine_part_tau2*t49
    slope_by_sine_part_tau2_by_tau1 = slope_by_amplitude_tau2_by_tau1*t58
    # back through: d/dtau of: first return of tau2
    slope_by_sine_part_tau2_by_tau = slope_by_amplitude_tau2_by_tau*t58
    # back through: d/dtau1 of: slip-slip for tau1
    t59 = cosine_part_tau2*t49
    slope_by_v2_3_by_tau1 = slope_by_amplitude_tau2_by_tau1*t59
    slope_by_v1_3_by_tau1 = t56*t60/v1_3_by_tau1**2
    # back through: d/dtau of: slip-slip for tau1
    slope_by_v2_3_by_tau = slope_by_amplitude_tau2_by_tau*t59
    slope_by_v1_3_by_tau = -amplitude_tau2_by_tau1*t57
    t61 = omega3*slope_by_sine_part_tau2_by_tau
    slope_by_z2_3_by_tau = -t61
    slope_by_z1_3_by_tau = t61
    # back through: d/dtau of: slip-stick for tau
    slope_by_v1_2_by_tau = slope_by_v1_3_by_tau*t25 + slope_by_v2_3_by_tau*t29 + slope_by_z1_3_by_tau*t24 + slope_by_z2_3_by_tau*t28
    slope_by_z2_2_by_tau = slope_by_v1_3_by_tau*t35 + slope_by_v2_3_by_tau*t37 + slope_by_z1_3_by_tau*t26 + slope_by_z2_3_by_tau*t30
    slope_by_z1_2_by_tau = slope_by_v1_3_by_tau*t34 + slope_by_v2_3_by_tau*t36 + slope_by_z1_3_by_tau*t25 + slope_by_z2_3_by_tau*t29
    # back through: d/dtau of: z2_1: linear in second-breaks-forward
    slope_by_z2_1_by_tau = chi*slope_by_z1_2_by_tau + slope_by_z2_2_by_tau - t62/z2_1_by_tau**2
    # back through: d/dtau of: functions of tau in slip-stick
    slope_by_sin_tau_by_tau = V*slope_by_z2_1_by_tau - e1*slope_by_v1_2_by_tau + slope_by_z1_2_by_tau*t42
    slope_by_cos_tau_by_tau = e1*slope_by_z1_2_by_tau + slope_by_v1_2_by_tau*t42 - slope_by_z2_1_by_tau*t5
    # back through: first return of tau2
    t63 = 1/(2*amplitude_tau2**2)
    slope_by_amplitude_tau2 = -slope_by_amplitude_tau2_by_tau*t48*t63 - slope_by_amplitude_tau2_by_tau1*t51*t63
    # back through: first return of tau2
    t64 = slope_by_amplitude_tau2_by_tau*t49
    t65 = slope_by_amplitude_tau2_by_tau1*t49
    slope_by_sine_part_tau2 = sine_part_tau2_by_tau*t64 + sine_part_tau2_by_tau1*t65 + slope_by_amplitude_tau2*t58
    slope_by_cosine_part_tau2 = slope_by_amplitude_tau2*t59 + t64*v2_3_by_tau + t65*v2_3_by_tau1
    # back through: slip-slip for tau1
    t67 = omega3*slope_by_sine_part_tau2_by_tau1
    slope_by_v2_3 = slope_by_cosine_part_tau2 - t67
    slope_by_v1_3 = t67
    t68 = chi*eta*slope_by_v2_3_by_tau1 + omega3*slope_by_sine_part_tau2
    slope_by_z2_3 = chi*slope_by_v1_3_by_tau1 - t68
    slope_by_z1_3 = -slope_by_v1_3_by_tau1 + t68
    # back through: functions of tau1 in slip-slip
    t69 = p2*z2_2
    t70 = t21*z1_2
    t71 = p2*z2_2_by_tau
    t72 = t21*z1_2_by_tau
    t73 = p1*z2_2
    t74 = p1*z2_2_by_tau
    t75 = V*p2
    t76 = V*p1
    t77 = p3*v1_2
    t78 = slope_by_z1_3_by_tau*v1_2_by_tau
    t79 = t21*t78
    t80 = p3*v1_2_by_tau
    t81 = slope_by_z2_3_by_tau*t80
    slope_by_sin_omega2_tau1 = slope_by_v1_3*(omega2*t69 - omega2*t70) + slope_by_v1_3_by_tau*(omega2*t71 - omega2*t72) + slope_by_v2_3*(omega2*p3*z1_2 - omega2*t73) + slope_by_v2_3_by_tau*(omega2*p3*z1_2_by_tau - omega2*t74) + slope_by_z1_3*(t21*t22*v1_2 - t22*t75) + slope_by_z2_3*(t22*t76 - t22*t77) + t22*t79 - t22*t81
    t82 = p3*z1_2
    t83 = p3*z1_2_by_tau
    t84 = slope_by_v1_3_by_tau*v1_2_by_tau
    t85 = slope_by_v2_3_by_tau*t80
    slope_by_cos_omega2_tau1 = slope_by_v1_3*(t21*v1_2 - t75) + slope_by_v2_3*(t76 - t77) + slope_by_z1_3*(t21*z1_2 - t69) + slope_by_z1_3_by_tau*(t21*z1_2_by_tau - t71) + slope_by_z2_3*(t73 - t82) + slope_by_z2_3_by_tau*(t74 - t83) + t21*t84 - t85
    t86 = p1*z1_2
    t87 = p1*z1_2_by_tau
    t88 = t21*z2_2
    t89 = t21*z2_2_by_tau
    t90 = p1*v1_2
    t91 = V*t21
    t92 = p1*t78
    slope_by_sin_omega1_tau1 = slope_by_v1_3*(-omega1*t69 - omega1*t86) + slope_by_v1_3_by_tau*(-omega1*t71 - omega1*t87) + slope_by_v2_3*(-omega1*t82 - omega1*t88) + slope_by_v2_3_by_tau*(-omega1*t83 - omega1*t89) + slope_by_z1_3*(t19*t75 + t19*t90) + slope_by_z2_3*(t19*t77 + t19*t91) + t19*t81 + t19*t92
    slope_by_cos_omega1_tau1 = p1*t84 + slope_by_v1_3*(t75 + t90) + slope_by_v2_3*(t77 + t91) + slope_by_z1_3*(t69 + t86) + slope_by_z1_3_by_tau*(t71 + t87) + slope_by_z2_3*(t82 + t88) + slope_by_z2_3_by_tau*(t83 + t89) + t85
    # back through: slip-stick for tau
    slope_by_v1_2 = slope_by_v1_3*t25 + slope_by_v2_3*t29 + slope_by_z1_3*t24 + slope_by_z2_3*t28
    slope_by_z2_2 = slope_by_v1_3*t35 + slope_by_v2_3*t37 + slope_by_z1_3*t26 + slope_by_z2_3*t30
    slope_by_z1_2 = slope_by_v1_3*t34 + slope_by_v2_3*t36 + slope_by_z1_3*t25 + slope_by_z2_3*t29
    # back through: z2_1: linear in second-breaks-forward
    slope_by_z2_1 = chi*slope_by_z1_2 + slope_by_z2_2
    # back through: functions of tau in slip-stick
    t93 = V*slope_by_z2_1
    slope_by_sin_tau = -e1*slope_by_v1_2 + slope_by_z1_2*t42 + t93
    slope_by_cos_tau = e1*slope_by_z1_2 + slope_by_v1_2*t42 - slope_by_z2_1*t5
    # trace_gradient
    t94 = sin_omega2_tau1*slope_by_cos_omega2_tau1
    t95 = sin_omega1_tau1*slope_by_cos_omega1_tau1
    t96 = sin_omega1_tau1/omega1**2
    t97 = cos_omega1_tau1*slope_by_sin_omega1_tau1*tau1 + slope_by_v1_3*(-sin_omega1_tau1*t69 - sin_omega1_tau1*t86) + slope_by_v1_3_by_tau*(-sin_omega1_tau1*t71 - sin_omega1_tau1*t87) + slope_by_v2_3*(-sin_omega1_tau1*t82 - sin_omega1_tau1*t88) + slope_by_v2_3_by_tau*(-sin_omega1_tau1*t83 - sin_omega1_tau1*t89) + slope_by_z1_3*(-t75*t96 - t90*t96) + slope_by_z2_3*(-t77*t96 - t91*t96) - t81*t96 - t92*t96 - t95*tau1
    t98 = 1/omega2**2
    t99 = sin_omega2_tau1*t98
    t100 = cos_omega2_tau1*slope_by_sin_omega2_tau1*tau1 + slope_by_v1_3*(sin_omega2_tau1*t69 - sin_omega2_tau1*t70) + slope_by_v1_3_by_tau*(sin_omega2_tau1*t71 - sin_omega2_tau1*t72) + slope_by_v2_3*(p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t73) + slope_by_v2_3_by_tau*(p3*sin_omega2_tau1*z1_2_by_tau - sin_omega2_tau1*t74) + slope_by_z1_3*(-t21*t99*v1_2 + t75*t99) + slope_by_z2_3*(p3*sin_omega2_tau1*t98*v1_2 - t76*t99) - t79*t99 + t81*t99 - t94*tau1
    t101 = 1/omega3**2
    t102 = slope_by_sine_part_tau2*(z1_3 - z2_3) + slope_by_sine_part_tau2_by_tau*(z1_3_by_tau - z2_3_by_tau) + slope_by_sine_part_tau2_by_tau1*(v1_3 - v2_3) + t53*(-amplitude_tau2_by_tau*t101*t4 + amplitude_tau2_by_tau1*t101*t4*t52*v1_3_by_tau)
    t103 = cos_omega1_tau1 - cos_omega2_tau1
    t104 = -omega2*sin_omega2_tau1 + t33
    t106 = t103*v1_2 - t104*z1_2
    t107 = t103*v1_2_by_tau - t104*z1_2_by_tau
    t109 = -sin_omega1_tau1*t19 + t23
    t111 = t103*z1_2 - t109*v1_2
    t112 = t103*z1_2_by_tau - t109*v1_2_by_tau
    t113 = slope_by_v1_3*t106 + slope_by_v1_3_by_tau*t107 + slope_by_v2_3*(-V*t103 + t104*z2_2) + slope_by_v2_3_by_tau*t104*z2_2_by_tau + slope_by_z1_3*t111 + slope_by_z1_3_by_tau*t112 + slope_by_z2_3*(V*t109 - t103*z2_2) - slope_by_z2_3_by_tau*t103*z2_2_by_tau
    t114 = slope_by_v1_3*(V*t103 - t104*z2_2) - slope_by_v1_3_by_tau*t104*z2_2_by_tau + slope_by_z1_3*(-V*t109 + t103*z2_2) + slope_by_z1_3_by_tau*t103*z2_2_by_tau
    t115 = slope_by_v2_3*t106 + slope_by_v2_3_by_tau*t107 + slope_by_z2_3*t111 + slope_by_z2_3_by_tau*t112
    t116 = 1 - cos_tau
    t117 = sin_tau - tau
    t118 = 1/t3**2
    t119 = cos_tau_by_tau*slope_by_v1_2_by_tau
    t121 = slope_by_z2_1*t4
    trace_gradient = [0, 0, 0, V*chi*slope_by_z1_2 + V*slope_by_z2_2 - cos_tau*slope_by_cos_tau_by_tau + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau - sin_tau*slope_by_sin_tau_by_tau - t93, cos_omega1_tau1*omega1*slope_by_sin_omega1_tau1 + cos_omega2_tau1*omega2*slope_by_sin_omega2_tau1 - omega1*t95 - omega2*t94, 0, V*slope_by_v1_2*t116 - V*t119 + omega1_by_chi*t97 + omega2_by_chi*t100 + omega3_by_chi*t102 + p1_by_chi*t113 + p2_by_chi*t114 + p3_by_chi*t115 + slope_by_v1_3_by_tau1*z2_3 + slope_by_v2_3_by_tau1*(-eta*z2_3 + t45) + slope_by_z1_2*(-V*t117 + cos_tau*z2_1 + t116*z2_1) + slope_by_z1_2_by_tau*(t39 + z2_2_by_tau) + slope_by_z2_1*(cos_tau*e1*t118 + t118*t7 + e2*t4/chi**2) + slope_by_z2_1_by_tau*t118*t40 + t53*(-amplitude_tau2_by_tau*t118*t54 + amplitude_tau2_by_tau1*t118*t52*t54*v1_3_by_tau), omega1_by_eta*t97 + omega2_by_eta*t100 + omega3_by_eta*t102 + p1_by_eta*t113 + p2_by_eta*t114 + p3_by_eta*t115 + slope_by_v2_3_by_tau1*(chi*z1_3 - t44), -slope_by_cosine_part_tau2 + slope_by_v1_2*(chi + cos_tau - t10) + slope_by_v1_3*t26 + slope_by_v2_3*t30 + slope_by_z1_2*(chi*tau + sin_tau - t12) + slope_by_z1_2_by_tau*(chi - sin_tau_by_tau*t3) + slope_by_z1_3*t27 + slope_by_z2_1*t117 + slope_by_z2_1_by_tau*(sin_tau_by_tau - 1) + slope_by_z2_2*tau + slope_by_z2_2_by_tau + slope_by_z2_3*t31 - t119*t3, cos_tau*slope_by_z1_2 - cos_tau*t121 + cos_tau_by_tau*slope_by_z1_2_by_tau - cos_tau_by_tau*slope_by_z2_1_by_tau*t4 - sin_tau*slope_by_v1_2 - sin_tau_by_tau*slope_by_v1_2_by_tau, -t121*t6]
    return trace, trace_gradient


def global_stick_passage(parameters, spectrum, unknowns, *, lib, outputs=3):
    """State at the start and behind each transition. Boundaries along the phases: constant,
    slope, cosine and sine amplitudes, one after the other; and the frequencies of each
    phase.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives states (5, 4).
    Gives coefficients (44).
    Gives frequencies (4).
    Operations: 190. Intermediate terms: 51.
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
    t13 = 1/omega3
    t14 = sin_omega3_tau2*t13
    z2_4 = V*(-t14 + tau2) + cos_omega3_tau2*z2_3 + t14*v2_3 + z1_3*(1 - cos_omega3_tau2)
    states = [[z10, z20, V, V], [z1_1, z2_1, V, V], [z1_2, z2_2, v1_2, V], [z1_3, z2_3, V, v2_3], [z1_4, z2_4, V, V]]
    if outputs == 1:
        return states
    # coefficients
    t15 = chi*z20
    t17 = V*chi
    t18 = -V + t17
    t21 = chi*z10
    t22 = chi*z2_1
    t23 = t22 - z1_1
    t24 = chi**2
    t25 = t24*z2_1
    t26 = V*t24 - t17
    t27 = -chi*t23
    t28 = -chi*t18
    t29 = V*p2
    t30 = omega1*z1_2
    t31 = p2*z2_2
    t32 = p3*v1_2
    t33 = chi*z1_3
    t34 = chi*(-z1_3 + z2_3)
    t35 = chi*(-V*t13 + t13*v2_3)
    coefficients = [-e1 - t15 + z10, -t18, -e1 + t15 - z10, t18, -e2 + t15 - t21, 0, -e2 - t15 + t21, 0, t18, 0, -t18, t23, -e2 + t22 - t25, -t26, -t27, -t28, -e2 - t22 + t25, t26, t27, t28, -V, 0, p1*v1_2 + t29, -t29 + t7*v1_2, -omega1*t31 - p1*t30, omega2*t31 - omega2*t7*z1_2, -V, 0, V*t7 + t32, V*p1 - t32, -omega1*t7*z2_2 - p3*t30, -omega2*p1*z2_2 + omega2*p3*z1_2, -e1 - t33 + z1_3, -t18, -t34, -t35, -e1 + t33 - z1_3, t18, t34, t35, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3]
    if outputs == 2:
        return states, coefficients
    frequencies = [1, omega1, omega2, omega3]
    return states, coefficients, frequencies


def global_stick_linearisation(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Jacobian of the Poincare map in the section's coordinates; saltation matrices, one
    below the other; monodromy matrix.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives poincare_jacobian (2, 2).
    Gives saltations (16, 4).
    Gives monodromy (4, 4).
    Operations: 508. Intermediate terms: 185.
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
    t5 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t5)
    sin_omega2_tau1 = lib.sin(t5)
    # slip-slip for tau1, until first-reaches-belt
    t6 = 1/omega1
    t7 = sin_omega1_tau1*t6
    t8 = 1 - p1
    t9 = sin_omega2_tau1/omega2
    t10 = p1*t7 + t8*t9
    t11 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8
    t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t13 = p2*sin_omega1_tau1*t6 - p2*t9
    z1_3 = V*t13 + t10*v1_2 + t11*z1_2 + t12*z2_2
    t14 = p3*sin_omega1_tau1*t6 - p3*t9
    t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t16 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1
    t17 = p1*t9 + t7*t8
    z2_3 = V*t17 + t14*v1_2 + t15*z1_2 + t16*z2_2
    t18 = omega2*sin_omega2_tau1
    t19 = omega1*sin_omega1_tau1
    t20 = -p1*t19 - t18*t8
    t21 = p2*t19
    t22 = omega2*p2*sin_omega2_tau1 - t21
    v1_3 = V*t12 + t11*v1_2 + t20*z1_2 + t22*z2_2
    t23 = omega2*p3*sin_omega2_tau1 - p3*t19
    t24 = p1*t18
    t25 = t19*t8
    t26 = -t24 - t25
    v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t26*z2_2
    # functions of tau2 in stick-slip
    t27 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t27)
    sin_omega3_tau2 = lib.sin(t27)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t28 = 1 - cos_omega3_tau2
    t29 = sin_omega3_tau2/omega3
    z2_4 = V*(-t29 + tau2) + cos_omega3_tau2*z2_3 + t28*z1_3 + t29*v2_3
    t30 = omega3*sin_omega3_tau2
    v2_4 = V*t28 + cos_omega3_tau2*v2_3 + t30*z1_3 - t30*z2_3
    # rate of the exit boundary after ta
    t31 = V*chi
    rate_1 = V - t31
    # derivatives of the time to the boundary after ta
    t33 = 1/rate_1
    delay_ta_by_z10 = -t33
    delay_ta_by_z20 = chi*t33
    # perturbation on the boundary after ta
    t34 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t34 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t34
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t3*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t3*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t31
    # derivatives of the time to the boundary after tau
    t37 = 1/rate_2
    delay_tau_by_z10 = t37*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t37*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t38 = chi*z2_2
    t39 = t38 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t39
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t39
    # Phi along tau1
    carried_z1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t11*z1_2_on_boundary_by_z10 + t12*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t11*z1_2_on_boundary_by_z20 + t12*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t14*v1_2_on_boundary_by_z10 + t15*z1_2_on_boundary_by_z10 + t16*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t14*v1_2_on_boundary_by_z20 + t15*z1_2_on_boundary_by_z20 + t16*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t20*z1_2_on_boundary_by_z10 + t22*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t20*z1_2_on_boundary_by_z20 + t22*z2_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t15*v1_2_on_boundary_by_z10 + t23*z1_2_on_boundary_by_z10 + t26*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t15*v1_2_on_boundary_by_z20 + t23*z1_2_on_boundary_by_z20 + t26*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t40 = chi*z2_3
    rate_3 = t40 - z1_3
    # derivatives of the time to the boundary after tau1
    t42 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t42
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t42
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t43 = chi*eta
    t44 = -eta*t40 + t43*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t44
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t44
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t28*z1_3_on_boundary_by_z10 + t29*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t28*z1_3_on_boundary_by_z20 + t29*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t30*z1_3_on_boundary_by_z10 - t30*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t30*z1_3_on_boundary_by_z20 - t30*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t43*z1_4 - t43*z2_4
    # derivatives of the time to the boundary after tau2
    t46 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t46
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t46
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20
    z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    poincare_jacobian = [[z1_4_on_boundary_by_z10, z1_4_on_boundary_by_z20], [z2_4_on_boundary_by_z10, z2_4_on_boundary_by_z20]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 1
    behind_v1_1 = chi*z2_1 - z1_1
    # vector fields at transition 2
    before_v1_2 = t39
    behind_v1_2 = t39
    behind_v2_2 = -eta*t38 + t43*z1_2
    # vector fields at transition 3
    before_v1_3 = rate_3
    before_v2_3 = t44
    behind_v2_3 = t44
    # vector fields at transition 4
    before_v2_4 = rate_4
    # saltations
    t47 = behind_v1_1/rate_1
    t48 = chi*t47
    t51 = chi/rate_2
    t52 = t51*(-before_v1_2 + behind_v1_2)
    t53 = behind_v2_2*t51
    t55 = 1/before_v1_3
    t56 = t55*(V - v1_3)
    t57 = t55*(-before_v2_3 + behind_v2_3)
    t58 = (V - v2_4)/before_v2_4
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [t47, -t48, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t52, t52, 1, 0], [-t53, t53, 0, 1], [1, 0, t56, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t57, 1], [1, 0, 0, 0], [0, 1, 0, t58], [0, 0, 1, 0], [0, 0, 0, 0]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # saltation of phase 1
    saltation_1_20 = t47
    saltation_1_21 = -t48
    saltation_1_22 = t47*ta + 1
    saltation_1_23 = -t48*ta
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    t50 = chi - t1
    phi_2_01 = saltation_1_21*sin_tau + t50
    phi_2_02 = cos_tau*ta + saltation_1_22*sin_tau
    phi_2_03 = chi*tau + saltation_1_23*sin_tau + t2*ta - t3
    phi_2_13 = ta + tau
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t3
    phi_2_22 = cos_tau*saltation_1_22 - sin_tau*ta
    phi_2_23 = cos_tau*saltation_1_23 + t3*ta + t50
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t52 + phi_2_20
    saltation_2_21 = -phi_2_01*t52 + phi_2_21 + t52
    saltation_2_22 = -phi_2_02*t52 + phi_2_22
    saltation_2_23 = -phi_2_03*t52 + phi_2_13*t52 + phi_2_23
    saltation_2_30 = -phi_2_00*t53
    saltation_2_31 = -phi_2_01*t53 + t53
    saltation_2_32 = -phi_2_02*t53
    saltation_2_33 = -phi_2_03*t53 + phi_2_13*t53 + 1
    # Phi of phase 3
    phi_3_00 = phi_2_00*t11 + saltation_2_20*t10 + saltation_2_30*t13
    phi_3_01 = phi_2_01*t11 + saltation_2_21*t10 + saltation_2_31*t13 + t12
    phi_3_02 = phi_2_02*t11 + saltation_2_22*t10 + saltation_2_32*t13
    phi_3_03 = phi_2_03*t11 + phi_2_13*t12 + saltation_2_23*t10 + saltation_2_33*t13
    phi_3_10 = phi_2_00*t15 + saltation_2_20*t14 + saltation_2_30*t17
    phi_3_11 = phi_2_01*t15 + saltation_2_21*t14 + saltation_2_31*t17 + t16
    phi_3_12 = phi_2_02*t15 + saltation_2_22*t14 + saltation_2_32*t17
    phi_3_13 = phi_2_03*t15 + phi_2_13*t16 + saltation_2_23*t14 + saltation_2_33*t17
    phi_3_20 = phi_2_00*t20 + saltation_2_20*t11 + saltation_2_30*t12
    phi_3_21 = p2*t18 + phi_2_01*t20 + saltation_2_21*t11 + saltation_2_31*t12 - t21
    phi_3_22 = phi_2_02*t20 + saltation_2_22*t11 + saltation_2_32*t12
    phi_3_23 = phi_2_03*t20 + phi_2_13*t22 + saltation_2_23*t11 + saltation_2_33*t12
    phi_3_30 = phi_2_00*t23 + saltation_2_20*t15 + saltation_2_30*t16
    phi_3_31 = phi_2_01*t23 + saltation_2_21*t15 + saltation_2_31*t16 - t24 - t25
    phi_3_32 = phi_2_02*t23 + saltation_2_22*t15 + saltation_2_32*t16
    phi_3_33 = phi_2_03*t23 + phi_2_13*t26 + saltation_2_23*t15 + saltation_2_33*t16
    # saltation of phase 3
    saltation_3_00 = phi_3_00 + phi_3_20*t56
    saltation_3_01 = phi_3_01 + phi_3_21*t56
    saltation_3_02 = phi_3_02 + phi_3_22*t56
    saltation_3_03 = phi_3_03 + phi_3_23*t56
    saltation_3_30 = phi_3_20*t57 + phi_3_30
    saltation_3_31 = phi_3_21*t57 + phi_3_31
    saltation_3_32 = phi_3_22*t57 + phi_3_32
    saltation_3_33 = phi_3_23*t57 + phi_3_33
    # Phi of phase 4
    phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t28 + saltation_3_30*t29
    phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t28 + saltation_3_31*t29
    phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t28 + saltation_3_32*t29
    phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t28 + saltation_3_33*t29
    phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t30 + saltation_3_00*t30
    phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t30 + saltation_3_01*t30
    phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t30 + saltation_3_02*t30
    phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t30 + saltation_3_03*t30
    # saltation of phase 4
    saltation_4_10 = phi_4_10 + phi_4_30*t58
    saltation_4_11 = phi_4_11 + phi_4_31*t58
    saltation_4_12 = phi_4_12 + phi_4_32*t58
    saltation_4_13 = phi_4_13 + phi_4_33*t58
    monodromy = [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]
    return poincare_jacobian, saltations, monodromy


def global_stick_flow_stick_stick(parameters, spectrum, time, state, *, lib):
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


def global_stick_flow_slip_stick(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def global_stick_flow_slip_slip(parameters, spectrum, time, state, *, lib):
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
    t14 = omega2*t6
    t15 = omega1*t2
    return [t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15), t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4)]


def global_stick_flow_stick_slip(parameters, spectrum, time, state, *, lib):
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
    # state_after
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [t*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def global_stick_reduced(parameters, spectrum, reduced, *, lib, outputs=3):
    """All unknowns from the reduced ones; the equations for these and their derivatives.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives unknowns (6).
    Gives reduced_residual (2).
    Gives reduced_jacobian (2, 2).
    Operations: 221. Intermediate terms: 75.
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
    t21 = omega1*sin_omega1_tau1
    t24 = omega2*p3*sin_omega2_tau1 - p3*t21
    t20 = omega2*sin_omega2_tau1
    t25 = -p1*t20 - t12*t21
    v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # first return of tau2
    t26 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t26
    sin_tau2_return = -cosine_part_tau2*t26
    # tau2: first return
    t27 = 1/omega3
    tau2 = t27*lib.angle(sin_tau2_return, cos_tau2_return)
    # ta: linear in time
    t28 = chi*z2_3
    t29 = sine_part_tau2*t27
    t30 = V*tau2
    t31 = amplitude_tau2*t27
    ta = -t3*(chi*t29 + chi*t30 - chi*t31 + e1 + t28 - t29 - t30 - z2_3)/V
    # unknowns
    t38 = t29 + t30 + z2_3
    unknowns = [t38, -t31 + t38, ta, tau, tau1, tau2]
    if outputs == 1:
        return unknowns
    # slip-slip for tau1
    t22 = -p1*t21 - t12*t20
    t23 = omega2*p2*sin_omega2_tau1 - p2*t21
    v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2
    reduced_residual = [-V + v1_3, amplitude_tau2*t27*t3 - t4 - z2_1]
    if outputs == 2:
        return unknowns, reduced_residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t32 = cos_tau_by_tau*e1
    z2_1_by_tau = V*sin_tau_by_tau - V - t3*t32
    # d/dtau of: slip-stick for tau
    t33 = V*chi
    t34 = V - t33
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t34 + t32 + t33
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t34 - e1*sin_tau_by_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau
    z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau
    v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau
    v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    v1_3_by_tau1 = t28 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t28
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t35 = 2*cosine_part_tau2
    t36 = 2*sine_part_tau2
    t37 = t26/2
    amplitude_tau2_by_tau = t37*(sine_part_tau2_by_tau*t36 + t35*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t37*(sine_part_tau2_by_tau1*t36 + t35*v2_3_by_tau1)
    # reduced_jacobian
    t39 = t27*t3
    reduced_jacobian = [[v1_3_by_tau, v1_3_by_tau1], [amplitude_tau2_by_tau*t39 - z2_1_by_tau, amplitude_tau2_by_tau1*t39]]
    return unknowns, reduced_residual, reduced_jacobian


def global_stick_period_map(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Map [N, c] of a turn; the start that follows from the dwell times; compatibility and
    switching conditions. The start among the unknowns is not read.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives period_map (4, 5).
    Gives linear_start (2).
    Gives compatibility (4).
    Operations: 266. Intermediate terms: 84.
    """
    [chi, _, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, ta, tau, tau1, tau2] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick after tau, by the start
    t0 = chi*cos_tau
    z1_2_by_z20 = chi - t0
    z1_2_by_v10 = cos_tau*ta + sin_tau
    t2 = chi*sin_tau
    z1_2_by_v20 = chi*tau - t2 + ta*z1_2_by_z20
    z2_2_by_v20 = ta + tau
    v1_2_by_z10 = -sin_tau
    v1_2_by_z20 = t2
    v1_2_by_v10 = cos_tau - sin_tau*ta
    v1_2_by_v20 = chi - t0 + t2*ta
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip after tau1, by the start
    t5 = 1 - p1
    t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5
    t7 = 1/omega1
    t8 = sin_omega1_tau1*t7
    t9 = sin_omega2_tau1/omega2
    t10 = p1*t8 + t5*t9
    z1_3_by_z10 = cos_tau*t6 + t10*v1_2_by_z10
    t11 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3_by_z20 = t10*v1_2_by_z20 + t11 + t6*z1_2_by_z20
    z1_3_by_v10 = t10*v1_2_by_v10 + t6*z1_2_by_v10
    z1_3_by_v20 = p2*t8 - p2*t9 + t10*v1_2_by_v20 + t11*z2_2_by_v20 + t6*z1_2_by_v20
    t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t13 = p3*sin_omega1_tau1*t7 - p3*t9
    z2_3_by_z10 = cos_tau*t12 + t13*v1_2_by_z10
    t14 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1
    z2_3_by_z20 = t12*z1_2_by_z20 + t13*v1_2_by_z20 + t14
    z2_3_by_v10 = t12*z1_2_by_v10 + t13*v1_2_by_v10
    z2_3_by_v20 = p1*t9 + t12*z1_2_by_v20 + t13*v1_2_by_v20 + t14*z2_2_by_v20 + t5*t8
    t15 = omega2*sin_omega2_tau1
    t16 = omega1*sin_omega1_tau1
    t17 = -p1*t16 - t15*t5
    v1_3_by_z10 = cos_tau*t17 + t6*v1_2_by_z10
    t18 = p2*t16
    v1_3_by_z20 = p2*t15 + t17*z1_2_by_z20 - t18 + t6*v1_2_by_z20
    v1_3_by_v10 = t17*z1_2_by_v10 + t6*v1_2_by_v10
    v1_3_by_v20 = t11 + t17*z1_2_by_v20 + t6*v1_2_by_v20 + z2_2_by_v20*(omega2*p2*sin_omega2_tau1 - t18)
    t19 = omega2*p3*sin_omega2_tau1 - p3*t16
    v2_3_by_z10 = cos_tau*t19 + t12*v1_2_by_z10
    t20 = p1*t15 + t16*t5
    v2_3_by_z20 = t12*v1_2_by_z20 + t19*z1_2_by_z20 - t20
    v2_3_by_v10 = t12*v1_2_by_v10 + t19*z1_2_by_v10
    v2_3_by_v20 = t12*v1_2_by_v20 + t14 + t19*z1_2_by_v20 - t20*z2_2_by_v20
    # functions of tau2 in stick-slip
    t21 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t21)
    sin_omega3_tau2 = lib.sin(t21)
    # stick-slip after tau2, by the start
    z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10
    z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20
    z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10
    z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20
    t22 = sin_omega3_tau2/omega3
    t23 = -t22 + tau2
    t24 = 1 - cos_omega3_tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t22*v2_3_by_z10 + t23*v1_3_by_z10 + t24*z1_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t22*v2_3_by_z20 + t23*v1_3_by_z20 + t24*z1_3_by_z20
    z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t22*v2_3_by_v10 + t23*v1_3_by_v10 + t24*z1_3_by_v10
    z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t22*v2_3_by_v20 + t23*v1_3_by_v20 + t24*z1_3_by_v20
    t25 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t24*v1_3_by_z10 + t25*z1_3_by_z10 - t25*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t24*v1_3_by_z20 + t25*z1_3_by_z20 - t25*z2_3_by_z20
    v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t24*v1_3_by_v10 + t25*z1_3_by_v10 - t25*z2_3_by_v10
    v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t24*v1_3_by_v20 + t25*z1_3_by_v20 - t25*z2_3_by_v20
    period_map = [[z1_4_by_z10, z1_4_by_z20, z1_4_by_v10, z1_4_by_v20, 0], [z2_4_by_z10, z2_4_by_z20, z2_4_by_v10, z2_4_by_v20, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_v10, v1_3_by_v20, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_v10, v2_4_by_v20, 0]]
    if outputs == 1:
        return period_map
    # coefficients of the linear equations
    coefficient11 = z1_4_by_z10 - 1
    coefficient22 = z2_4_by_z20 - 1
    # right-hand sides of the linear equations
    right1 = -V*z1_4_by_v10 - V*z1_4_by_v20
    right2 = -V*z2_4_by_v10 - V*z2_4_by_v20
    # determinant of the linear equations
    determinant = coefficient11*coefficient22 - z1_4_by_z20*z2_4_by_z10
    # numerators of Cramer's rule
    numerator1 = coefficient22*right1 - right2*z1_4_by_z20
    numerator2 = coefficient11*right2 - right1*z2_4_by_z10
    # z10, z20 by Cramer's rule
    t26 = 1/determinant
    z1_0 = numerator1*t26
    z2_0 = numerator2*t26
    linear_start = [z1_0, z2_0]
    if outputs == 2:
        return period_map, linear_start
    # stick-stick for ta, until first-breaks-forward
    t27 = V*ta
    z1_1 = t27 + z1_0
    z2_1 = t27 + z2_0
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + z1_2_by_z20*z2_1
    z2_2 = V*tau + z2_1
    compatibility = [V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0, V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0, -chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2]
    return period_map, linear_start, compatibility


def solution_ii_equations(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=3):
    """Switching and periodicity equations; their derivatives by the unknowns; those by the
    parameters, in total, through the spectrum too.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for
        parameter_jacobian.
    Gives residual (6).
    Gives jacobian (6, 6).
    Gives parameter_jacobian (6, 4).
    Operations: 684. Intermediate terms: 192.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, e1] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t3 = chi*cos_tau
    t4 = chi - t3
    t5 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t5) + cos_tau*z10 + t4*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*t4 - sin_tau*z10 + t5*z20
    # functions of tau1 in slip-slip
    t6 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t6)
    sin_omega1_tau1 = lib.sin(t6)
    t9 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t9)
    sin_omega2_tau1 = lib.sin(t9)
    # slip-slip for tau1, until first-reaches-belt
    t12 = 1/omega1
    t13 = sin_omega1_tau1*t12
    t14 = 1 - p1
    t15 = 1/omega2
    t16 = sin_omega2_tau1*t15
    t17 = p1*t13 + t14*t16
    t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14
    t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t20 = p2*t16
    z1_3 = V*(p2*sin_omega1_tau1*t12 - t20) + t17*v1_2 + t18*z1_2 + t19*z2_2
    t21 = p3*sin_omega1_tau1*t12 - p3*t16
    t22 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t23 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1
    t24 = p1*t16 + t13*t14
    z2_3 = V*t24 + t21*v1_2 + t22*z1_2 + t23*z2_2
    t25 = omega2*sin_omega2_tau1
    t26 = omega1*sin_omega1_tau1
    t27 = -p1*t26 - t14*t25
    t28 = p2*t26
    t29 = omega2*p2*sin_omega2_tau1 - t28
    t30 = V*t19
    v1_3 = t18*v1_2 + t27*z1_2 + t29*z2_2 + t30
    t31 = omega2*p3*sin_omega2_tau1 - p3*t26
    t32 = p1*t25 + t14*t26
    t34 = V*t23
    v2_3 = t22*v1_2 + t31*z1_2 - t32*z2_2 + t34
    # functions of tau2 in stick-slip
    t35 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t35)
    sin_omega3_tau2 = lib.sin(t35)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t38 = 1 - cos_omega3_tau2
    t39 = 1/omega3
    t40 = sin_omega3_tau2*t39
    t41 = -t40 + tau2
    z2_4 = V*t41 + cos_omega3_tau2*z2_3 + t38*z1_3 + t40*v2_3
    t42 = omega3*z1_3
    t43 = omega3*z2_3
    v2_4 = V*t38 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t42 - sin_omega3_tau2*t43
    # residual
    t44 = chi*z20 - z10
    residual = [-e1 - t44, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]
    if outputs == 1:
        return residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dz10 of: slip-stick for tau, until second-breaks-forward
    v1_2_by_z10 = -sin_tau
    # d/dz20 of: slip-stick for tau, until second-breaks-forward
    z1_2_by_z20 = t4
    v1_2_by_z20 = t5
    # d/dtau of: slip-stick for tau, until second-breaks-forward
    t45 = V*chi
    t46 = V - t45
    z1_2_by_tau = -cos_tau_by_tau*t44 + sin_tau_by_tau*t46 + t45
    v1_2_by_tau = cos_tau_by_tau*t46 + sin_tau_by_tau*t44
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dz10 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10
    z2_3_by_z10 = cos_tau*t22 + t21*v1_2_by_z10
    v1_3_by_z10 = cos_tau*t27 + t18*v1_2_by_z10
    v2_3_by_z10 = cos_tau*t31 + t22*v1_2_by_z10
    # d/dz20 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19
    z2_3_by_z20 = t21*v1_2_by_z20 + t22*z1_2_by_z20 + t23
    v1_3_by_z20 = p2*t25 + t18*v1_2_by_z20 + t27*z1_2_by_z20 - t28
    v2_3_by_z20 = t22*v1_2_by_z20 + t31*z1_2_by_z20 - t32
    # d/dtau of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t30
    z2_3_by_tau = t21*v1_2_by_tau + t22*z1_2_by_tau + t34
    v1_3_by_tau = V*t29 + t18*v1_2_by_tau + t27*z1_2_by_tau
    v2_3_by_tau = -V*t32 + t22*v1_2_by_tau + t31*z1_2_by_tau
    # d/dtau1 of: slip-slip for tau1, until first-reaches-belt
    t47 = p1*z1_2
    t48 = p2*z2_2
    t49 = t47 + t48
    t50 = t14*z1_2 - t48
    t51 = p1*v1_2
    t52 = V*p2
    t53 = t12*t51 + t12*t52
    t54 = t14*t15*v1_2 - t15*t52
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t49 + cos_omega2_tau1_by_tau1*t50 + sin_omega1_tau1_by_tau1*t53 + sin_omega2_tau1_by_tau1*t54
    t55 = p3*z1_2
    t56 = t14*z2_2
    t57 = t55 + t56
    t58 = p1*z2_2
    t59 = -t55 + t58
    t60 = p3*v1_2
    t61 = V*t14
    t62 = t12*t60 + t12*t61
    t63 = V*p1
    t64 = -t15*t60 + t15*t63
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t57 + cos_omega2_tau1_by_tau1*t59 + sin_omega1_tau1_by_tau1*t62 + sin_omega2_tau1_by_tau1*t64
    t65 = t51 + t52
    t66 = t14*v1_2 - t52
    t67 = -omega1*t47 - omega1*t48
    t68 = t14*z1_2
    t69 = omega2*t48 - omega2*t68
    v1_3_by_tau1 = cos_omega1_tau1_by_tau1*t65 + cos_omega2_tau1_by_tau1*t66 + sin_omega1_tau1_by_tau1*t67 + sin_omega2_tau1_by_tau1*t69
    t70 = t60 + t61
    t71 = -t60 + t63
    t72 = -omega1*t55 - omega1*t56
    t73 = omega2*p3*z1_2 - omega2*t58
    v2_3_by_tau1 = cos_omega1_tau1_by_tau1*t70 + cos_omega2_tau1_by_tau1*t71 + sin_omega1_tau1_by_tau1*t72 + sin_omega2_tau1_by_tau1*t73
    # d/dtau2 of: functions of tau2 in stick-slip
    cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2
    sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3
    # d/dz10 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t38*z1_3_by_z10 + t40*v2_3_by_z10
    t74 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t74*z1_3_by_z10 - t74*z2_3_by_z10
    # d/dz20 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t38*z1_3_by_z20 + t40*v2_3_by_z20
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t74*z1_3_by_z20 - t74*z2_3_by_z20
    # d/dtau of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t38*z1_3_by_tau + t40*v2_3_by_tau
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t74*z1_3_by_tau - t74*z2_3_by_tau
    # d/dtau1 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t38*z1_3_by_tau1 + t40*v2_3_by_tau1
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t74*z1_3_by_tau1 - t74*z2_3_by_tau1
    # d/dtau2 of: stick-slip for tau2, until second-reaches-belt
    t75 = -z1_3 + z2_3
    t76 = -V*t39 + t39*v2_3
    z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*t75 + sin_omega3_tau2_by_tau2*t76
    t77 = -V + v2_3
    t78 = t42 - t43
    v2_4_by_tau2 = cos_omega3_tau2_by_tau2*t77 + sin_omega3_tau2_by_tau2*t78
    jacobian = [[1, -chi, 0, 0, 0, -1], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_tau + t45, 0, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_tau, v1_3_by_tau1, 0, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2, 0], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_tau, z1_3_by_tau1, V, 0], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_tau, z2_4_by_tau1, z2_4_by_tau2, 0]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t79 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t79*z20
    v1_2_by_chi = V*t79 + sin_tau*z20
    # d/dV of: slip-stick for tau, until second-breaks-forward
    t80 = chi*tau
    z1_2_by_V = sin_tau - t5 + t80
    v1_2_by_V = chi + cos_tau - t3
    # d/dchi of: functions of tau1 in slip-slip
    t82 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t82
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t82
    t83 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t83
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t83
    # d/deta of: functions of tau1 in slip-slip
    t84 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t84
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t84
    t85 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t85
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t85
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t86 = sin_omega1_tau1/omega1**2
    t87 = -t51*t86 - t52*t86
    t88 = 1/omega2**2
    t89 = sin_omega2_tau1*t88
    t90 = -t14*t89*v1_2 + t52*t89
    t91 = -sin_omega1_tau1*t12 + t16
    t93 = cos_omega1_tau1 - cos_omega2_tau1
    t94 = -t91*v1_2 + t93*z1_2
    t95 = -V*t91 + t93*z2_2
    z1_3_by_chi = cos_omega1_tau1_by_chi*t49 + cos_omega2_tau1_by_chi*t50 + omega1_by_chi*t87 + omega2_by_chi*t90 + p1_by_chi*t94 + p2_by_chi*t95 + sin_omega1_tau1_by_chi*t53 + sin_omega2_tau1_by_chi*t54 + t17*v1_2_by_chi + t18*z1_2_by_chi
    t96 = -t60*t86 - t61*t86
    t97 = p3*sin_omega2_tau1*t88*v1_2 - t63*t89
    t99 = V*t91 - t93*z2_2
    z2_3_by_chi = cos_omega1_tau1_by_chi*t57 + cos_omega2_tau1_by_chi*t59 + omega1_by_chi*t96 + omega2_by_chi*t97 + p1_by_chi*t99 + p3_by_chi*t94 + sin_omega1_tau1_by_chi*t62 + sin_omega2_tau1_by_chi*t64 + t21*v1_2_by_chi + t22*z1_2_by_chi
    t100 = -sin_omega1_tau1*t47 - sin_omega1_tau1*t48
    t101 = sin_omega2_tau1*t48 - sin_omega2_tau1*t68
    t102 = -omega2*sin_omega2_tau1 + t26
    t104 = -t102*z1_2 + t93*v1_2
    t105 = V*t93 - t102*z2_2
    v1_3_by_chi = cos_omega1_tau1_by_chi*t65 + cos_omega2_tau1_by_chi*t66 + omega1_by_chi*t100 + omega2_by_chi*t101 + p1_by_chi*t104 + p2_by_chi*t105 + sin_omega1_tau1_by_chi*t67 + sin_omega2_tau1_by_chi*t69 + t18*v1_2_by_chi + t27*z1_2_by_chi
    t106 = -sin_omega1_tau1*t55 - sin_omega1_tau1*t56
    t107 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t58
    t108 = -V*t93 + t102*z2_2
    v2_3_by_chi = cos_omega1_tau1_by_chi*t70 + cos_omega2_tau1_by_chi*t71 + omega1_by_chi*t106 + omega2_by_chi*t107 + p1_by_chi*t108 + p3_by_chi*t104 + sin_omega1_tau1_by_chi*t72 + sin_omega2_tau1_by_chi*t73 + t22*v1_2_by_chi + t31*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t49 + cos_omega2_tau1_by_eta*t50 + omega1_by_eta*t87 + omega2_by_eta*t90 + p1_by_eta*t94 + p2_by_eta*t95 + sin_omega1_tau1_by_eta*t53 + sin_omega2_tau1_by_eta*t54
    z2_3_by_eta = cos_omega1_tau1_by_eta*t57 + cos_omega2_tau1_by_eta*t59 + omega1_by_eta*t96 + omega2_by_eta*t97 + p1_by_eta*t99 + p3_by_eta*t94 + sin_omega1_tau1_by_eta*t62 + sin_omega2_tau1_by_eta*t64
    v1_3_by_eta = cos_omega1_tau1_by_eta*t65 + cos_omega2_tau1_by_eta*t66 + omega1_by_eta*t100 + omega2_by_eta*t101 + p1_by_eta*t104 + p2_by_eta*t105 + sin_omega1_tau1_by_eta*t67 + sin_omega2_tau1_by_eta*t69
    v2_3_by_eta = cos_omega1_tau1_by_eta*t70 + cos_omega2_tau1_by_eta*t71 + omega1_by_eta*t106 + omega2_by_eta*t107 + p1_by_eta*t108 + p3_by_eta*t104 + sin_omega1_tau1_by_eta*t72 + sin_omega2_tau1_by_eta*t73
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = p2*t13 + t17*v1_2_by_V + t18*z1_2_by_V + t19*tau - t20
    z2_3_by_V = t21*v1_2_by_V + t22*z1_2_by_V + t23*tau + t24
    v1_3_by_V = t18*v1_2_by_V + t19 + t27*z1_2_by_V + t29*tau
    v2_3_by_V = t22*v1_2_by_V + t23 + t31*z1_2_by_V - t32*tau
    # d/dchi of: functions of tau2 in stick-slip
    t109 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t109
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t109
    # d/deta of: functions of tau2 in stick-slip
    t110 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t110
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t110
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t111 = sin_omega3_tau2/omega3**2
    t112 = V*t111 - t111*v2_3
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t75 + omega3_by_chi*t112 + sin_omega3_tau2_by_chi*t76 + t38*z1_3_by_chi + t40*v2_3_by_chi
    t113 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t77 + omega3_by_chi*t113 + sin_omega3_tau2_by_chi*t78 + t74*z1_3_by_chi - t74*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t75 + omega3_by_eta*t112 + sin_omega3_tau2_by_eta*t76 + t38*z1_3_by_eta + t40*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t77 + omega3_by_eta*t113 + sin_omega3_tau2_by_eta*t78 + t74*z1_3_by_eta - t74*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t38*z1_3_by_V + t40*v2_3_by_V + t41
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t74*z1_3_by_V - t74*z2_3_by_V + 1
    parameter_jacobian = [[-z20, 0, 0, 0], [-chi*z1_2_by_chi - z1_2 + z2_2, 0, -chi*z1_2_by_V + t80, -1], [v1_3_by_chi, v1_3_by_eta, v1_3_by_V - 1, 0], [v2_4_by_chi, v2_4_by_eta, v2_4_by_V - 1, 0], [z1_3_by_chi, z1_3_by_eta, z1_4_by_V, 0], [z2_4_by_chi, z2_4_by_eta, z2_4_by_V, 0]]
    return residual, jacobian, parameter_jacobian


def solution_ii_trace(parameters, spectrum, unknowns, spectrum_derivatives=None, *, lib, outputs=2):
    """Trace of the Poincare map's Jacobian; its derivatives by the unknowns, then in total
    by the parameters.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta, for trace_gradient.
    Gives trace.
    Gives trace_gradient (10).
    Operations: 1118. Intermediate terms: 249.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t2 = chi*cos_tau
    t3 = chi - t2
    t4 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t4) + cos_tau*z10 + t3*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*t3 - sin_tau*z10 + t4*z20
    # functions of tau1 in slip-slip
    t5 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t5)
    sin_omega1_tau1 = lib.sin(t5)
    t8 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t8)
    sin_omega2_tau1 = lib.sin(t8)
    # slip-slip for tau1, until first-reaches-belt
    t11 = 1/omega1
    t12 = sin_omega1_tau1*t11
    t13 = 1 - p1
    t14 = 1/omega2
    t15 = sin_omega2_tau1*t14
    t16 = p1*t12 + t13*t15
    t17 = cos_omega1_tau1*p1 + cos_omega2_tau1*t13
    t18 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t19 = p2*sin_omega1_tau1*t11 - p2*t15
    z1_3 = V*t19 + t16*v1_2 + t17*z1_2 + t18*z2_2
    t20 = p3*sin_omega1_tau1*t11 - p3*t15
    t21 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t22 = cos_omega1_tau1*t13 + cos_omega2_tau1*p1
    t23 = p1*t15 + t12*t13
    z2_3 = V*t23 + t20*v1_2 + t21*z1_2 + t22*z2_2
    t24 = omega2*sin_omega2_tau1
    t25 = omega1*sin_omega1_tau1
    t26 = -p1*t25 - t13*t24
    t27 = omega2*p2*sin_omega2_tau1 - p2*t25
    v1_3 = V*t18 + t17*v1_2 + t26*z1_2 + t27*z2_2
    t28 = omega2*p3*sin_omega2_tau1 - p3*t25
    t29 = -p1*t24 - t13*t25
    v2_3 = V*t22 + t21*v1_2 + t28*z1_2 + t29*z2_2
    # functions of tau2 in stick-slip
    t30 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t30)
    sin_omega3_tau2 = lib.sin(t30)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t33 = 1 - cos_omega3_tau2
    t34 = 1/omega3
    t35 = sin_omega3_tau2*t34
    t36 = -t35 + tau2
    z2_4 = V*t36 + cos_omega3_tau2*z2_3 + t33*z1_3 + t35*v2_3
    t37 = omega3*z1_3
    t38 = omega3*z2_3
    v2_4 = V*t33 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t37 - sin_omega3_tau2*t38
    # rate of the exit boundary after ta
    t39 = V*chi
    rate_1 = V - t39
    # derivatives of the time to the boundary after ta
    t41 = 1/rate_1
    delay_ta_by_z10 = -t41
    delay_ta_by_z20 = chi*t41
    # perturbation on the boundary after ta
    t42 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t42 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t42
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t3*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t3*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t4*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t4*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t39
    # derivatives of the time to the boundary after tau
    t44 = 1/rate_2
    t45 = chi*z2_1_on_boundary_by_z10
    t46 = carried_z1_2_by_z10*chi - t45
    delay_tau_by_z10 = t44*t46
    t47 = chi*z2_1_on_boundary_by_z20
    t48 = carried_z1_2_by_z20*chi - t47
    delay_tau_by_z20 = t44*t48
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t49 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t49
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t49
    # Phi along tau1
    carried_z1_3_by_z10 = t16*v1_2_on_boundary_by_z10 + t17*z1_2_on_boundary_by_z10 + t18*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t16*v1_2_on_boundary_by_z20 + t17*z1_2_on_boundary_by_z20 + t18*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t20*v1_2_on_boundary_by_z10 + t21*z1_2_on_boundary_by_z10 + t22*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t20*v1_2_on_boundary_by_z20 + t21*z1_2_on_boundary_by_z20 + t22*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t17*v1_2_on_boundary_by_z10 + t26*z1_2_on_boundary_by_z10 + t27*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t17*v1_2_on_boundary_by_z20 + t26*z1_2_on_boundary_by_z20 + t27*z2_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t21*v1_2_on_boundary_by_z10 + t28*z1_2_on_boundary_by_z10 + t29*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t21*v1_2_on_boundary_by_z20 + t28*z1_2_on_boundary_by_z20 + t29*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t50 = chi*z2_3
    rate_3 = t50 - z1_3
    # derivatives of the time to the boundary after tau1
    t51 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t51
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t51
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t52 = eta*z1_3
    t53 = chi*t52 - eta*t50
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t53
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t53
    # Phi along tau2
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t33*z1_3_on_boundary_by_z20 + t35*v2_3_on_boundary_by_z20
    t54 = omega3*z1_3_on_boundary_by_z10
    t55 = omega3*z2_3_on_boundary_by_z10
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2*t54 - sin_omega3_tau2*t55
    t56 = omega3*z1_3_on_boundary_by_z20
    t57 = omega3*z2_3_on_boundary_by_z20
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2*t56 - sin_omega3_tau2*t57
    # rate of the exit boundary after tau2
    t58 = eta*z1_4
    t59 = eta*z2_4
    rate_4 = chi*t58 - chi*t59
    # derivatives of the time to the boundary after tau2
    t60 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t60
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t60
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    trace = z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # back through: rate of the exit boundary after tau2
    t61 = 1/rate_4**2
    slope_by_rate_4 = V*carried_v2_4_by_z10*t61 + carried_v2_4_by_z20*t61*v2_4
    # back through: Phi along tau2
    slope_by_carried_v2_4_by_z20 = -t60*v2_4
    slope_by_carried_v2_4_by_z10 = -V*t60
    # back through: perturbation on the boundary after tau1
    slope_by_v2_3_on_boundary_by_z20 = cos_omega3_tau2*slope_by_carried_v2_4_by_z20 + t35
    slope_by_v2_3_on_boundary_by_z10 = cos_omega3_tau2*slope_by_carried_v2_4_by_z10
    t62 = omega3*sin_omega3_tau2
    t63 = slope_by_carried_v2_4_by_z20*t62
    slope_by_z2_3_on_boundary_by_z20 = cos_omega3_tau2 - t63
    t64 = slope_by_carried_v2_4_by_z10*t62
    slope_by_z2_3_on_boundary_by_z10 = -t64
    slope_by_z1_3_on_boundary_by_z20 = -cos_omega3_tau2 + t63 + 1
    slope_by_z1_3_on_boundary_by_z10 = t64 + 1
    # back through: derivatives of the time to the boundary after tau1
    slope_by_delay_tau1_by_z20 = slope_by_v2_3_on_boundary_by_z20*t53 + slope_by_z1_3_on_boundary_by_z20*v1_3 + slope_by_z2_3_on_boundary_by_z20*v2_3
    slope_by_delay_tau1_by_z10 = slope_by_v2_3_on_boundary_by_z10*t53 + slope_by_z1_3_on_boundary_by_z10*v1_3 + slope_by_z2_3_on_boundary_by_z10*v2_3
    # back through: rate of the exit boundary after tau1
    t65 = 1/rate_3**2
    slope_by_rate_3 = carried_v1_3_by_z10*slope_by_delay_tau1_by_z10*t65 + carried_v1_3_by_z20*slope_by_delay_tau1_by_z20*t65
    # back through: Phi along tau1
    slope_by_carried_v1_3_by_z20 = -slope_by_delay_tau1_by_z20*t51
    slope_by_carried_v1_3_by_z10 = -slope_by_delay_tau1_by_z10*t51
    # back through: perturbation on the boundary after tau
    slope_by_v1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t17 + slope_by_v2_3_on_boundary_by_z20*t21 + slope_by_z1_3_on_boundary_by_z20*t16 + slope_by_z2_3_on_boundary_by_z20*t20
    slope_by_v1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t17 + slope_by_v2_3_on_boundary_by_z10*t21 + slope_by_z1_3_on_boundary_by_z10*t16 + slope_by_z2_3_on_boundary_by_z10*t20
    slope_by_z2_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t27 + slope_by_v2_3_on_boundary_by_z20*t29 + slope_by_z1_3_on_boundary_by_z20*t18 + slope_by_z2_3_on_boundary_by_z20*t22
    slope_by_z2_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t27 + slope_by_v2_3_on_boundary_by_z10*t29 + slope_by_z1_3_on_boundary_by_z10*t18 + slope_by_z2_3_on_boundary_by_z10*t22
    slope_by_z1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t26 + slope_by_v2_3_on_boundary_by_z20*t28 + slope_by_z1_3_on_boundary_by_z20*t17 + slope_by_z2_3_on_boundary_by_z20*t21
    slope_by_z1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t26 + slope_by_v2_3_on_boundary_by_z10*t28 + slope_by_z1_3_on_boundary_by_z10*t17 + slope_by_z2_3_on_boundary_by_z10*t21
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_z20 = V*slope_by_z2_2_on_boundary_by_z20 + slope_by_v1_2_on_boundary_by_z20*t49 + slope_by_z1_2_on_boundary_by_z20*v1_2
    slope_by_delay_tau_by_z10 = V*slope_by_z2_2_on_boundary_by_z10 + slope_by_v1_2_on_boundary_by_z10*t49 + slope_by_z1_2_on_boundary_by_z10*v1_2
    # back through: rate of the exit boundary after tau
    t66 = 1/rate_2**2
    slope_by_rate_2 = -slope_by_delay_tau_by_z10*t46*t66 - slope_by_delay_tau_by_z20*t48*t66
    # back through: Phi along tau
    t67 = chi*t44
    t68 = slope_by_delay_tau_by_z20*t67
    slope_by_carried_z1_2_by_z20 = slope_by_z1_2_on_boundary_by_z20 + t68
    t69 = slope_by_delay_tau_by_z10*t67
    slope_by_carried_z1_2_by_z10 = slope_by_z1_2_on_boundary_by_z10 + t69
    # back through: perturbation on the boundary after ta
    slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t3 + slope_by_v1_2_on_boundary_by_z20*t4 + slope_by_z2_2_on_boundary_by_z20 - t68
    slope_by_z2_1_on_boundary_by_z10 = slope_by_carried_z1_2_by_z10*t3 + slope_by_v1_2_on_boundary_by_z10*t4 + slope_by_z2_2_on_boundary_by_z10 - t69
    t70 = sin_tau*slope_by_v1_2_on_boundary_by_z20
    slope_by_z1_1_on_boundary_by_z20 = cos_tau*slope_by_carried_z1_2_by_z20 - t70
    t71 = sin_tau*slope_by_v1_2_on_boundary_by_z10
    slope_by_z1_1_on_boundary_by_z10 = cos_tau*slope_by_carried_z1_2_by_z10 - t71
    # back through: derivatives of the time to the boundary after ta
    slope_by_delay_ta_by_z20 = V*slope_by_z1_1_on_boundary_by_z20 + V*slope_by_z2_1_on_boundary_by_z20
    slope_by_delay_ta_by_z10 = V*slope_by_z1_1_on_boundary_by_z10 + V*slope_by_z2_1_on_boundary_by_z10
    # back through: rate of the exit boundary after ta
    t72 = 1/rate_1**2
    slope_by_rate_1 = -chi*slope_by_delay_ta_by_z20*t72 + slope_by_delay_ta_by_z10*t72
    # back through: stick-slip for tau2, until second-reaches-belt
    t73 = chi*eta
    t74 = slope_by_rate_4*t73
    slope_by_z2_4 = -t74
    slope_by_z1_4 = t74
    # back through: functions of tau2 in stick-slip
    slope_by_sin_omega3_tau2 = delay_tau2_by_z20*(t37 - t38) + slope_by_carried_v2_4_by_z10*(t54 - t55) + slope_by_carried_v2_4_by_z20*(t56 - t57) + slope_by_z2_4*(-V*t34 + t34*v2_3) + t34*v2_3_on_boundary_by_z20
    slope_by_cos_omega3_tau2 = delay_tau2_by_z20*(-V + v2_3) + slope_by_carried_v2_4_by_z10*v2_3_on_boundary_by_z10 + slope_by_carried_v2_4_by_z20*v2_3_on_boundary_by_z20 + slope_by_z2_4*(-z1_3 + z2_3) - z1_3_on_boundary_by_z20 + z2_3_on_boundary_by_z20
    # back through: slip-slip for tau1, until first-reaches-belt
    slope_by_v2_3 = cos_omega3_tau2*delay_tau2_by_z20 + delay_tau1_by_z10*slope_by_z2_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z2_3_on_boundary_by_z20 + slope_by_z2_4*t35
    slope_by_v1_3 = delay_tau1_by_z10*slope_by_z1_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z1_3_on_boundary_by_z20
    t75 = delay_tau1_by_z10*slope_by_v2_3_on_boundary_by_z10
    t76 = delay_tau1_by_z20*slope_by_v2_3_on_boundary_by_z20
    t77 = delay_tau2_by_z20*t62 + t73*t75 + t73*t76
    slope_by_z2_3 = chi*slope_by_rate_3 + cos_omega3_tau2*slope_by_z2_4 - t77
    slope_by_z1_3 = -slope_by_rate_3 + slope_by_z1_4 + slope_by_z2_4*t33 + t77
    # back through: functions of tau1 in slip-slip
    t78 = p2*z2_2_on_boundary_by_z10
    t79 = t13*z1_2_on_boundary_by_z10
    t80 = p2*z2_2_on_boundary_by_z20
    t81 = t13*z1_2_on_boundary_by_z20
    t82 = p2*z2_2
    t83 = t13*z1_2
    t84 = p1*z2_2
    t85 = p1*z2_2_on_boundary_by_z10
    t86 = p1*z2_2_on_boundary_by_z20
    t87 = V*p2
    t88 = V*p1
    t89 = p3*v1_2
    t90 = t13*t14
    t91 = slope_by_z1_3_on_boundary_by_z10*v1_2_on_boundary_by_z10
    t92 = slope_by_z1_3_on_boundary_by_z20*v1_2_on_boundary_by_z20
    t93 = p3*v1_2_on_boundary_by_z10
    t94 = slope_by_z2_3_on_boundary_by_z10*t93
    t95 = p3*v1_2_on_boundary_by_z20
    t96 = slope_by_z2_3_on_boundary_by_z20*t95
    slope_by_sin_omega2_tau1 = slope_by_carried_v1_3_by_z10*(omega2*t78 - omega2*t79) + slope_by_carried_v1_3_by_z20*(omega2*t80 - omega2*t81) + slope_by_v1_3*(omega2*t82 - omega2*t83) + slope_by_v2_3*(omega2*p3*z1_2 - omega2*t84) + slope_by_v2_3_on_boundary_by_z10*(omega2*p3*z1_2_on_boundary_by_z10 - omega2*t85) + slope_by_v2_3_on_boundary_by_z20*(omega2*p3*z1_2_on_boundary_by_z20 - omega2*t86) + slope_by_z1_3*(t13*t14*v1_2 - t14*t87) + slope_by_z2_3*(t14*t88 - t14*t89) - t14*t94 - t14*t96 + t90*t91 + t90*t92
    t97 = p3*z1_2
    t98 = p3*z1_2_on_boundary_by_z10
    t99 = p3*z1_2_on_boundary_by_z20
    t100 = slope_by_carried_v1_3_by_z10*v1_2_on_boundary_by_z10
    t101 = slope_by_carried_v1_3_by_z20*v1_2_on_boundary_by_z20
    t102 = slope_by_v2_3_on_boundary_by_z10*t93
    t103 = slope_by_v2_3_on_boundary_by_z20*t95
    slope_by_cos_omega2_tau1 = slope_by_v1_3*(t13*v1_2 - t87) + slope_by_v2_3*(t88 - t89) + slope_by_z1_3*(t13*z1_2 - t82) + slope_by_z1_3_on_boundary_by_z10*(t13*z1_2_on_boundary_by_z10 - t78) + slope_by_z1_3_on_boundary_by_z20*(t13*z1_2_on_boundary_by_z20 - t80) + slope_by_z2_3*(t84 - t97) + slope_by_z2_3_on_boundary_by_z10*(t85 - t98) + slope_by_z2_3_on_boundary_by_z20*(t86 - t99) + t100*t13 + t101*t13 - t102 - t103
    t104 = p1*z1_2_on_boundary_by_z10
    t105 = p1*z1_2_on_boundary_by_z20
    t106 = p1*z1_2
    t107 = t13*z2_2
    t108 = t13*z2_2_on_boundary_by_z10
    t109 = t13*z2_2_on_boundary_by_z20
    t110 = p1*v1_2
    t111 = V*t13
    t112 = p1*t11
    slope_by_sin_omega1_tau1 = slope_by_carried_v1_3_by_z10*(-omega1*t104 - omega1*t78) + slope_by_carried_v1_3_by_z20*(-omega1*t105 - omega1*t80) + slope_by_v1_3*(-omega1*t106 - omega1*t82) + slope_by_v2_3*(-omega1*t107 - omega1*t97) + slope_by_v2_3_on_boundary_by_z10*(-omega1*t108 - omega1*t98) + slope_by_v2_3_on_boundary_by_z20*(-omega1*t109 - omega1*t99) + slope_by_z1_3*(t11*t110 + t11*t87) + slope_by_z2_3*(t11*t111 + t11*t89) + t11*t94 + t11*t96 + t112*t91 + t112*t92
    slope_by_cos_omega1_tau1 = p1*t100 + p1*t101 + slope_by_v1_3*(t110 + t87) + slope_by_v2_3*(t111 + t89) + slope_by_z1_3*(t106 + t82) + slope_by_z1_3_on_boundary_by_z10*(t104 + t78) + slope_by_z1_3_on_boundary_by_z20*(t105 + t80) + slope_by_z2_3*(t107 + t97) + slope_by_z2_3_on_boundary_by_z10*(t108 + t98) + slope_by_z2_3_on_boundary_by_z20*(t109 + t99) + t102 + t103
    # back through: slip-stick for tau, until second-breaks-forward
    t113 = chi*slope_by_rate_2
    slope_by_v1_2 = delay_tau_by_z10*slope_by_z1_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z1_2_on_boundary_by_z20 + slope_by_v1_3*t17 + slope_by_v2_3*t21 + slope_by_z1_3*t16 + slope_by_z2_3*t20 - t113
    t114 = delay_tau_by_z10*slope_by_v1_2_on_boundary_by_z10
    t115 = delay_tau_by_z20*slope_by_v1_2_on_boundary_by_z20
    slope_by_z2_2 = chi*t114 + chi*t115 + slope_by_v1_3*t27 + slope_by_v2_3*t29 + slope_by_z1_3*t18 + slope_by_z2_3*t22
    slope_by_z1_2 = slope_by_v1_3*t26 + slope_by_v2_3*t28 + slope_by_z1_3*t17 + slope_by_z2_3*t21 - t114 - t115
    # back through: functions of tau in slip-stick
    t116 = chi*z20 - z10
    t117 = t45 - z1_1_on_boundary_by_z10
    t118 = t47 - z1_1_on_boundary_by_z20
    slope_by_sin_tau = rate_1*slope_by_z1_2 + slope_by_v1_2*t116 + slope_by_v1_2_on_boundary_by_z10*t117 + slope_by_v1_2_on_boundary_by_z20*t118
    slope_by_cos_tau = rate_1*slope_by_v1_2 - slope_by_carried_z1_2_by_z10*t117 - slope_by_carried_z1_2_by_z20*t118 - slope_by_z1_2*t116
    # trace_gradient
    t119 = sin_omega2_tau1*slope_by_cos_omega2_tau1
    t120 = sin_omega1_tau1*slope_by_cos_omega1_tau1
    t121 = cos_omega3_tau2*slope_by_sin_omega3_tau2
    t122 = sin_omega3_tau2*slope_by_cos_omega3_tau2
    t123 = sin_omega1_tau1/omega1**2
    t124 = p1*t123
    t125 = cos_omega1_tau1*slope_by_sin_omega1_tau1*tau1 + slope_by_carried_v1_3_by_z10*(-sin_omega1_tau1*t104 - sin_omega1_tau1*t78) + slope_by_carried_v1_3_by_z20*(-sin_omega1_tau1*t105 - sin_omega1_tau1*t80) + slope_by_v1_3*(-sin_omega1_tau1*t106 - sin_omega1_tau1*t82) + slope_by_v2_3*(-sin_omega1_tau1*t107 - sin_omega1_tau1*t97) + slope_by_v2_3_on_boundary_by_z10*(-sin_omega1_tau1*t108 - sin_omega1_tau1*t98) + slope_by_v2_3_on_boundary_by_z20*(-sin_omega1_tau1*t109 - sin_omega1_tau1*t99) + slope_by_z1_3*(-t110*t123 - t123*t87) + slope_by_z2_3*(-t111*t123 - t123*t89) - t120*tau1 - t123*t94 - t123*t96 - t124*t91 - t124*t92
    t126 = 1/omega2**2
    t127 = sin_omega2_tau1*t126
    t128 = t127*t13
    t129 = cos_omega2_tau1*slope_by_sin_omega2_tau1*tau1 + slope_by_carried_v1_3_by_z10*(sin_omega2_tau1*t78 - sin_omega2_tau1*t79) + slope_by_carried_v1_3_by_z20*(sin_omega2_tau1*t80 - sin_omega2_tau1*t81) + slope_by_v1_3*(sin_omega2_tau1*t82 - sin_omega2_tau1*t83) + slope_by_v2_3*(p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t84) + slope_by_v2_3_on_boundary_by_z10*(p3*sin_omega2_tau1*z1_2_on_boundary_by_z10 - sin_omega2_tau1*t85) + slope_by_v2_3_on_boundary_by_z20*(p3*sin_omega2_tau1*z1_2_on_boundary_by_z20 - sin_omega2_tau1*t86) + slope_by_z1_3*(-t127*t13*v1_2 + t127*t87) + slope_by_z2_3*(p3*sin_omega2_tau1*t126*v1_2 - t127*t88) - t119*tau1 + t127*t94 + t127*t96 - t128*t91 - t128*t92
    t130 = sin_omega3_tau2/omega3**2
    t131 = delay_tau2_by_z20*(sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3) + slope_by_carried_v2_4_by_z10*(sin_omega3_tau2*z1_3_on_boundary_by_z10 - sin_omega3_tau2*z2_3_on_boundary_by_z10) + slope_by_carried_v2_4_by_z20*(sin_omega3_tau2*z1_3_on_boundary_by_z20 - sin_omega3_tau2*z2_3_on_boundary_by_z20) + slope_by_z2_4*(V*t130 - t130*v2_3) + t121*tau2 - t122*tau2 - t130*v2_3_on_boundary_by_z20
    t132 = cos_omega1_tau1 - cos_omega2_tau1
    t133 = -omega2*sin_omega2_tau1 + t25
    t135 = t132*v1_2_on_boundary_by_z10 - t133*z1_2_on_boundary_by_z10
    t136 = t132*v1_2_on_boundary_by_z20 - t133*z1_2_on_boundary_by_z20
    t137 = t132*v1_2 - t133*z1_2
    t139 = -sin_omega1_tau1*t11 + t15
    t141 = t132*z1_2 - t139*v1_2
    t142 = t132*z1_2_on_boundary_by_z10 - t139*v1_2_on_boundary_by_z10
    t143 = t132*z1_2_on_boundary_by_z20 - t139*v1_2_on_boundary_by_z20
    t144 = slope_by_carried_v1_3_by_z10*t135 + slope_by_carried_v1_3_by_z20*t136 + slope_by_v1_3*t137 + slope_by_v2_3*(-V*t132 + t133*z2_2) + slope_by_v2_3_on_boundary_by_z10*t133*z2_2_on_boundary_by_z10 + slope_by_v2_3_on_boundary_by_z20*t133*z2_2_on_boundary_by_z20 + slope_by_z1_3*t141 + slope_by_z1_3_on_boundary_by_z10*t142 + slope_by_z1_3_on_boundary_by_z20*t143 + slope_by_z2_3*(V*t139 - t132*z2_2) - slope_by_z2_3_on_boundary_by_z10*t132*z2_2_on_boundary_by_z10 - slope_by_z2_3_on_boundary_by_z20*t132*z2_2_on_boundary_by_z20
    t145 = -slope_by_carried_v1_3_by_z10*t133*z2_2_on_boundary_by_z10 - slope_by_carried_v1_3_by_z20*t133*z2_2_on_boundary_by_z20 + slope_by_v1_3*(V*t132 - t133*z2_2) + slope_by_z1_3*(-V*t139 + t132*z2_2) + slope_by_z1_3_on_boundary_by_z10*t132*z2_2_on_boundary_by_z10 + slope_by_z1_3_on_boundary_by_z20*t132*z2_2_on_boundary_by_z20
    t146 = slope_by_v2_3*t137 + slope_by_v2_3_on_boundary_by_z10*t135 + slope_by_v2_3_on_boundary_by_z20*t136 + slope_by_z2_3*t141 + slope_by_z2_3_on_boundary_by_z10*t142 + slope_by_z2_3_on_boundary_by_z20*t143
    t147 = 1 - cos_tau
    t148 = -eta*z2_3 + t52
    t149 = chi*z1_3 - t50
    trace_gradient = [cos_tau*slope_by_z1_2 - sin_tau*slope_by_v1_2, slope_by_v1_2*t4 + slope_by_z1_2*t3 + slope_by_z2_2, V*slope_by_z2_2 + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau + slope_by_z1_2*t39, cos_omega1_tau1*omega1*slope_by_sin_omega1_tau1 + cos_omega2_tau1*omega2*slope_by_sin_omega2_tau1 - omega1*t120 - omega2*t119, V*slope_by_z1_4 + V*slope_by_z2_4 + omega3*t121 - omega3*t122, 0, -V*slope_by_rate_1 + omega1_by_chi*t125 + omega2_by_chi*t129 + omega3_by_chi*t131 + p1_by_chi*t144 + p2_by_chi*t145 + p3_by_chi*t146 + slope_by_carried_z1_2_by_z10*t147*z2_1_on_boundary_by_z10 + slope_by_carried_z1_2_by_z20*t147*z2_1_on_boundary_by_z20 + slope_by_delay_ta_by_z20*t41 + slope_by_delay_tau_by_z10*t44*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10) + slope_by_delay_tau_by_z20*t44*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + slope_by_rate_2*(V - v1_2) + slope_by_rate_3*z2_3 + slope_by_rate_4*(t58 - t59) + slope_by_v1_2*(V*t147 + sin_tau*z20) + slope_by_z1_2*(V*(-sin_tau + tau) + t147*z20) + t114*z2_2 + t115*z2_2 + t148*t75 + t148*t76 + t70*z2_1_on_boundary_by_z20 + t71*z2_1_on_boundary_by_z10, omega1_by_eta*t125 + omega2_by_eta*t129 + omega3_by_eta*t131 + p1_by_eta*t144 + p2_by_eta*t145 + p3_by_eta*t146 + slope_by_rate_4*(chi*z1_4 - chi*z2_4) + t149*t75 + t149*t76, delay_ta_by_z10*slope_by_z1_1_on_boundary_by_z10 + delay_ta_by_z10*slope_by_z2_1_on_boundary_by_z10 + delay_ta_by_z20*slope_by_z1_1_on_boundary_by_z20 + delay_ta_by_z20*slope_by_z2_1_on_boundary_by_z20 + delay_tau2_by_z10 + delay_tau2_by_z20*t33 + delay_tau_by_z10*slope_by_z2_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z2_2_on_boundary_by_z20 + slope_by_rate_1*(1 - chi) + slope_by_v1_2*(chi + cos_tau - t2) + slope_by_v1_3*t18 + slope_by_v2_3*t22 + slope_by_z1_2*(chi*tau + sin_tau - t4) + slope_by_z1_3*t19 + slope_by_z1_4*tau2 + slope_by_z2_2*tau + slope_by_z2_3*t23 + slope_by_z2_4*t36 + t113, 0]
    return trace, trace_gradient


def solution_ii_passage(parameters, spectrum, unknowns, *, lib, outputs=3):
    """State at the start and behind each transition. Boundaries along the phases: constant,
    slope, cosine and sine amplitudes, one after the other; and the frequencies of each
    phase.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives states (5, 4).
    Gives coefficients (44).
    Gives frequencies (4).
    Operations: 186. Intermediate terms: 49.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, e1] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t0 = -chi*cos_tau + chi
    t1 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t1) + cos_tau*z10 + t0*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*t0 - sin_tau*z10 + t1*z20
    # functions of tau1 in slip-slip
    t2 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t2)
    sin_omega1_tau1 = lib.sin(t2)
    t3 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t3)
    sin_omega2_tau1 = lib.sin(t3)
    # slip-slip for tau1, until first-reaches-belt
    t4 = 1/omega1
    t5 = sin_omega1_tau1*t4
    t6 = 1 - p1
    t7 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + v1_2*(p1*t5 + t6*t7) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t6) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t8 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t9 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t8*z1_2 + t9*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7)
    t10 = omega1*sin_omega1_tau1
    v2_3 = V*t9 + t8*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t10) + z2_2*(-omega2*p1*sin_omega2_tau1 - t10*t6)
    # functions of tau2 in stick-slip
    t11 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t11)
    sin_omega3_tau2 = lib.sin(t11)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t12 = 1/omega3
    t13 = sin_omega3_tau2*t12
    z2_4 = V*(-t13 + tau2) + cos_omega3_tau2*z2_3 + t13*v2_3 + z1_3*(1 - cos_omega3_tau2)
    states = [[z10, z20, V, V], [z10, z20, V, V], [z1_2, z2_2, v1_2, V], [z1_3, z2_3, V, v2_3], [z1_4, z2_4, V, V]]
    if outputs == 1:
        return states
    # coefficients
    t14 = chi*z20
    t15 = t14 - z10
    t17 = V*chi
    t18 = -V + t17
    t21 = chi*z10
    t22 = e2 - t14
    t23 = e2 + t14
    t24 = chi**2
    t25 = t24*z20
    t26 = V*t24 - t17
    t27 = -chi*t15
    t28 = -chi*t18
    t29 = V*p2
    t30 = omega1*z1_2
    t31 = p2*z2_2
    t32 = p3*v1_2
    t33 = chi*z1_3
    t34 = chi*(-z1_3 + z2_3)
    t35 = chi*(-V*t12 + t12*v2_3)
    coefficients = [-e1 - t15, -t18, -e1 + t14 - z10, t18, -t21 - t22, 0, t21 - t23, 0, t18, 0, -t18, t15, -t22 - t25, -t26, -t27, -t28, -t23 + t25, t26, t27, t28, -V, 0, p1*v1_2 + t29, -t29 + t6*v1_2, -omega1*t31 - p1*t30, omega2*t31 - omega2*t6*z1_2, -V, 0, V*t6 + t32, V*p1 - t32, -omega1*t6*z2_2 - p3*t30, -omega2*p1*z2_2 + omega2*p3*z1_2, -e1 - t33 + z1_3, -t18, -t34, -t35, -e1 + t33 - z1_3, t18, t34, t35, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3]
    if outputs == 2:
        return states, coefficients
    frequencies = [1, omega1, omega2, omega3]
    return states, coefficients, frequencies


def solution_ii_linearisation(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Jacobian of the Poincare map in the section's coordinates; saltation matrices, one
    below the other; monodromy matrix.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives poincare_jacobian (2, 2).
    Gives saltations (16, 4).
    Gives monodromy (4, 4).
    Operations: 487. Intermediate terms: 182.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t0 = chi*cos_tau
    t1 = chi - t0
    t2 = chi*sin_tau
    t3 = chi*tau - t2
    z1_2 = V*sin_tau + V*t3 + cos_tau*z10 + t1*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*t1 - sin_tau*z10 + t2*z20
    # functions of tau1 in slip-slip
    t4 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t4)
    sin_omega1_tau1 = lib.sin(t4)
    t5 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t5)
    sin_omega2_tau1 = lib.sin(t5)
    # slip-slip for tau1, until first-reaches-belt
    t6 = 1/omega1
    t7 = sin_omega1_tau1*t6
    t8 = 1 - p1
    t9 = sin_omega2_tau1/omega2
    t10 = p1*t7 + t8*t9
    t11 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8
    t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t13 = p2*sin_omega1_tau1*t6 - p2*t9
    z1_3 = V*t13 + t10*v1_2 + t11*z1_2 + t12*z2_2
    t14 = p3*sin_omega1_tau1*t6 - p3*t9
    t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t16 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1
    t17 = p1*t9 + t7*t8
    z2_3 = V*t17 + t14*v1_2 + t15*z1_2 + t16*z2_2
    t18 = omega2*sin_omega2_tau1
    t19 = omega1*sin_omega1_tau1
    t20 = -p1*t19 - t18*t8
    t21 = p2*t19
    t22 = omega2*p2*sin_omega2_tau1 - t21
    v1_3 = V*t12 + t11*v1_2 + t20*z1_2 + t22*z2_2
    t23 = omega2*p3*sin_omega2_tau1 - p3*t19
    t24 = p1*t18
    t25 = t19*t8
    t26 = -t24 - t25
    v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t26*z2_2
    # functions of tau2 in stick-slip
    t27 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t27)
    sin_omega3_tau2 = lib.sin(t27)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t28 = 1 - cos_omega3_tau2
    t29 = sin_omega3_tau2/omega3
    z2_4 = V*(-t29 + tau2) + cos_omega3_tau2*z2_3 + t28*z1_3 + t29*v2_3
    t30 = omega3*sin_omega3_tau2
    v2_4 = V*t28 + cos_omega3_tau2*v2_3 + t30*z1_3 - t30*z2_3
    # rate of the exit boundary after ta
    t31 = V*chi
    rate_1 = V - t31
    # derivatives of the time to the boundary after ta
    t33 = 1/rate_1
    delay_ta_by_z10 = -t33
    delay_ta_by_z20 = chi*t33
    # perturbation on the boundary after ta
    t34 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t34 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t34
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t31
    # derivatives of the time to the boundary after tau
    t37 = 1/rate_2
    delay_tau_by_z10 = t37*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t37*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t38 = chi*z2_2
    t39 = t38 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t39
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t39
    # Phi along tau1
    carried_z1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t11*z1_2_on_boundary_by_z10 + t12*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t11*z1_2_on_boundary_by_z20 + t12*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t14*v1_2_on_boundary_by_z10 + t15*z1_2_on_boundary_by_z10 + t16*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t14*v1_2_on_boundary_by_z20 + t15*z1_2_on_boundary_by_z20 + t16*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t20*z1_2_on_boundary_by_z10 + t22*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t20*z1_2_on_boundary_by_z20 + t22*z2_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t15*v1_2_on_boundary_by_z10 + t23*z1_2_on_boundary_by_z10 + t26*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t15*v1_2_on_boundary_by_z20 + t23*z1_2_on_boundary_by_z20 + t26*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t40 = chi*z2_3
    rate_3 = t40 - z1_3
    # derivatives of the time to the boundary after tau1
    t42 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t42
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t42
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t43 = chi*eta
    t44 = -eta*t40 + t43*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t44
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t44
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t28*z1_3_on_boundary_by_z10 + t29*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t28*z1_3_on_boundary_by_z20 + t29*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t30*z1_3_on_boundary_by_z10 - t30*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t30*z1_3_on_boundary_by_z20 - t30*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t43*z1_4 - t43*z2_4
    # derivatives of the time to the boundary after tau2
    t46 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t46
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t46
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20
    z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    poincare_jacobian = [[z1_4_on_boundary_by_z10, z1_4_on_boundary_by_z20], [z2_4_on_boundary_by_z10, z2_4_on_boundary_by_z20]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 1
    behind_v1_1 = chi*z20 - z10
    # vector fields at transition 2
    before_v1_2 = t39
    behind_v1_2 = t39
    behind_v2_2 = -eta*t38 + t43*z1_2
    # vector fields at transition 3
    before_v1_3 = rate_3
    before_v2_3 = t44
    behind_v2_3 = t44
    # vector fields at transition 4
    before_v2_4 = rate_4
    # saltations
    t47 = behind_v1_1/rate_1
    t48 = -chi*t47
    t49 = -before_v1_2 + behind_v1_2
    t50 = 1/rate_2
    t51 = chi*t50
    t52 = t49*t51
    t55 = behind_v2_2*t51
    t58 = 1/before_v1_3
    t59 = t58*(V - v1_3)
    t60 = t58*(-before_v2_3 + behind_v2_3)
    t61 = (V - v2_4)/before_v2_4
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [t47, t48, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t52, t52, 1, 0], [-t55, t55, 0, 1], [1, 0, t59, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t60, 1], [1, 0, 0, 0], [0, 1, 0, t61], [0, 0, 1, 0], [0, 0, 0, 0]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # saltation of phase 1
    saltation_1_20 = t47
    saltation_1_21 = t48
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    phi_2_01 = chi + saltation_1_21*sin_tau - t0
    phi_2_03 = t3
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t2
    phi_2_23 = t1
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t52 + phi_2_20
    saltation_2_21 = -phi_2_01*t52 + phi_2_21 + t52
    t53 = t49*t50
    saltation_2_22 = cos_tau - t2*t53
    t54 = chi*tau
    saltation_2_23 = -phi_2_03*t52 + phi_2_23 + t53*t54
    saltation_2_30 = -phi_2_00*t55
    saltation_2_31 = -phi_2_01*t55 + t55
    t57 = behind_v2_2*t50
    saltation_2_32 = -t2*t57
    saltation_2_33 = -phi_2_03*t55 + t54*t57 + 1
    # Phi of phase 3
    phi_3_00 = phi_2_00*t11 + saltation_2_20*t10 + saltation_2_30*t13
    phi_3_01 = phi_2_01*t11 + saltation_2_21*t10 + saltation_2_31*t13 + t12
    phi_3_02 = saltation_2_22*t10 + saltation_2_32*t13 + sin_tau*t11
    phi_3_03 = phi_2_03*t11 + saltation_2_23*t10 + saltation_2_33*t13 + t12*tau
    phi_3_10 = phi_2_00*t15 + saltation_2_20*t14 + saltation_2_30*t17
    phi_3_11 = phi_2_01*t15 + saltation_2_21*t14 + saltation_2_31*t17 + t16
    phi_3_12 = saltation_2_22*t14 + saltation_2_32*t17 + sin_tau*t15
    phi_3_13 = phi_2_03*t15 + saltation_2_23*t14 + saltation_2_33*t17 + t16*tau
    phi_3_20 = phi_2_00*t20 + saltation_2_20*t11 + saltation_2_30*t12
    phi_3_21 = p2*t18 + phi_2_01*t20 + saltation_2_21*t11 + saltation_2_31*t12 - t21
    phi_3_22 = saltation_2_22*t11 + saltation_2_32*t12 + sin_tau*t20
    phi_3_23 = phi_2_03*t20 + saltation_2_23*t11 + saltation_2_33*t12 + t22*tau
    phi_3_30 = phi_2_00*t23 + saltation_2_20*t15 + saltation_2_30*t16
    phi_3_31 = phi_2_01*t23 + saltation_2_21*t15 + saltation_2_31*t16 - t24 - t25
    phi_3_32 = saltation_2_22*t15 + saltation_2_32*t16 + sin_tau*t23
    phi_3_33 = phi_2_03*t23 + saltation_2_23*t15 + saltation_2_33*t16 + t26*tau
    # saltation of phase 3
    saltation_3_00 = phi_3_00 + phi_3_20*t59
    saltation_3_01 = phi_3_01 + phi_3_21*t59
    saltation_3_02 = phi_3_02 + phi_3_22*t59
    saltation_3_03 = phi_3_03 + phi_3_23*t59
    saltation_3_30 = phi_3_20*t60 + phi_3_30
    saltation_3_31 = phi_3_21*t60 + phi_3_31
    saltation_3_32 = phi_3_22*t60 + phi_3_32
    saltation_3_33 = phi_3_23*t60 + phi_3_33
    # Phi of phase 4
    phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t28 + saltation_3_30*t29
    phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t28 + saltation_3_31*t29
    phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t28 + saltation_3_32*t29
    phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t28 + saltation_3_33*t29
    phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t30 + saltation_3_00*t30
    phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t30 + saltation_3_01*t30
    phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t30 + saltation_3_02*t30
    phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t30 + saltation_3_03*t30
    # saltation of phase 4
    saltation_4_10 = phi_4_10 + phi_4_30*t61
    saltation_4_11 = phi_4_11 + phi_4_31*t61
    saltation_4_12 = phi_4_12 + phi_4_32*t61
    saltation_4_13 = phi_4_13 + phi_4_33*t61
    monodromy = [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]
    return poincare_jacobian, saltations, monodromy


def solution_ii_flow_stick_stick(parameters, spectrum, time, state, *, lib):
    """State after a time in stick-stick.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 4. Intermediate terms: 0.
    """
    t = time
    [z1, z2, v1, v2] = state
    return [t*v1 + z1, t*v2 + z2, v1, v2]


def solution_ii_flow_slip_stick(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-stick.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 23. Intermediate terms: 4.
    """
    [chi, _, _, _] = parameters
    t = time
    [z1, z2, v1, v2] = state
    # state_after
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def solution_ii_flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 82. Intermediate terms: 16.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    t = time
    [z1, z2, v1, v2] = state
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
    t14 = omega2*t6
    t15 = omega1*t2
    return [t10*z1 + t11*z2 + v1*(p1*t3 + t4*t7) + v2*(p2*t0*t2 - p2*t7), t12*z1 + t13*z2 + v1*(p3*t0*t2 - p3*t7) + v2*(p1*t7 + t3*t4), t10*v1 + t11*v2 + z1*(-p1*t15 - t14*t4) + z2*(omega2*p2*t6 - p2*t15), t12*v1 + t13*v2 + z1*(omega2*p3*t6 - p3*t15) + z2*(-p1*t14 - t15*t4)]


def solution_ii_flow_stick_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in stick-slip.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 23. Intermediate terms: 6.
    """
    [_, _, _, _, _, _, omega3] = spectrum
    t = time
    [z1, z2, v1, v2] = state
    # state_after
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [t*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def solution_ii_reduced(parameters, spectrum, reduced, *, lib, outputs=3):
    """All unknowns from the reduced ones; the equations for these and their derivatives.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (3): tau, tau1, e1.
    Gives unknowns (6).
    Gives reduced_residual (3).
    Gives reduced_jacobian (3, 3).
    Operations: 303. Intermediate terms: 101.
    """
    [chi, eta, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1, e1] = reduced
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t2 = V*tau
    t3 = 1/(chi - 1)
    t4 = cos_tau*t3
    z2_1 = V*sin_tau - e1*t4 - t2 - e2*t3/chi
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
    t21 = omega1*sin_omega1_tau1
    t24 = omega2*p3*sin_omega2_tau1 - p3*t21
    t20 = omega2*sin_omega2_tau1
    t25 = -p1*t20 - t12*t21
    v2_3 = V*t19 + t18*v1_2 + t24*z1_2 + t25*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # first return of tau2
    t26 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t26
    sin_tau2_return = -cosine_part_tau2*t26
    # tau2: first return
    t27 = 1/omega3
    tau2 = t27*lib.angle(sin_tau2_return, cos_tau2_return)
    # unknowns
    t28 = V*tau2 + sine_part_tau2*t27 + z2_3
    t29 = -amplitude_tau2*t27 + t28
    unknowns = [t28, t29, tau, tau1, tau2, e1]
    if outputs == 1:
        return unknowns
    # slip-slip for tau1
    t22 = -p1*t21 - t12*t20
    t23 = omega2*p2*sin_omega2_tau1 - p2*t21
    v1_3 = V*t16 + t15*v1_2 + t22*z1_2 + t23*z2_2
    # stick-stick for no time
    z1_5 = t28
    z2_5 = t29
    reduced_residual = [-V + v1_3, -chi*z2_5 - e1 + z1_5, -z2_1 + z2_5]
    if outputs == 2:
        return unknowns, reduced_residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t30 = cos_tau_by_tau*e1
    z2_1_by_tau = V*sin_tau_by_tau - V - t3*t30
    # d/de1 of: z2_1: linear in second-breaks-forward
    z2_1_by_e1 = -t4
    # d/dtau of: slip-stick for tau
    t31 = V*chi
    t32 = V - t31
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t32 + t30 + t31
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t32 - e1*sin_tau_by_tau
    # d/de1 of: slip-stick for tau
    z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau
    v1_2_by_e1 = -sin_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau
    z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau
    v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau
    v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t33 = chi*z2_3
    v1_3_by_tau1 = t33 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t33
    # d/de1 of: slip-slip for tau1
    z1_3_by_e1 = t14*v1_2_by_e1 + t15*z1_2_by_e1 + t16*z2_1_by_e1
    z2_3_by_e1 = t17*v1_2_by_e1 + t18*z1_2_by_e1 + t19*z2_1_by_e1
    v1_3_by_e1 = t15*v1_2_by_e1 + t22*z1_2_by_e1 + t23*z2_1_by_e1
    v2_3_by_e1 = t18*v1_2_by_e1 + t24*z1_2_by_e1 + t25*z2_1_by_e1
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/de1 of: first return of tau2
    sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1
    # d/dtau of: first return of tau2
    t34 = 2*cosine_part_tau2
    t35 = 2*sine_part_tau2
    t36 = t26/2
    amplitude_tau2_by_tau = t36*(sine_part_tau2_by_tau*t35 + t34*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t36*(sine_part_tau2_by_tau1*t35 + t34*v2_3_by_tau1)
    # d/de1 of: first return of tau2
    amplitude_tau2_by_e1 = t36*(sine_part_tau2_by_e1*t35 + t34*v2_3_by_e1)
    # d/dtau of: first return of tau2
    t37 = 1/amplitude_tau2**2
    cos_tau2_return_by_tau = -amplitude_tau2_by_tau*sine_part_tau2*t37 + sine_part_tau2_by_tau*t26
    sin_tau2_return_by_tau = amplitude_tau2_by_tau*cosine_part_tau2*t37 - t26*v2_3_by_tau
    # d/dtau1 of: first return of tau2
    cos_tau2_return_by_tau1 = -amplitude_tau2_by_tau1*sine_part_tau2*t37 + sine_part_tau2_by_tau1*t26
    sin_tau2_return_by_tau1 = amplitude_tau2_by_tau1*cosine_part_tau2*t37 - t26*v2_3_by_tau1
    # d/de1 of: first return of tau2
    cos_tau2_return_by_e1 = -amplitude_tau2_by_e1*sine_part_tau2*t37 + sine_part_tau2_by_e1*t26
    sin_tau2_return_by_e1 = amplitude_tau2_by_e1*cosine_part_tau2*t37 - t26*v2_3_by_e1
    # d/dtau of: tau2: first return
    t38 = t27/(cos_tau2_return**2 + sin_tau2_return**2)
    t39 = cos_tau2_return*t38
    t40 = sin_tau2_return*t38
    tau2_by_tau = -cos_tau2_return_by_tau*t40 + sin_tau2_return_by_tau*t39
    # d/dtau1 of: tau2: first return
    tau2_by_tau1 = -cos_tau2_return_by_tau1*t40 + sin_tau2_return_by_tau1*t39
    # d/de1 of: tau2: first return
    tau2_by_e1 = -cos_tau2_return_by_e1*t40 + sin_tau2_return_by_e1*t39
    # d/dtau of: stick-stick for no time
    z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t27 + z2_3_by_tau
    z2_5_by_tau = -amplitude_tau2_by_tau*t27 + z1_5_by_tau
    # d/dtau1 of: stick-stick for no time
    z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t27 + v2_3
    z2_5_by_tau1 = -amplitude_tau2_by_tau1*t27 + z1_5_by_tau1
    # d/de1 of: stick-stick for no time
    z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t27 + z2_3_by_e1
    z2_5_by_e1 = -amplitude_tau2_by_e1*t27 + z1_5_by_e1
    reduced_jacobian = [[v1_3_by_tau, v1_3_by_tau1, v1_3_by_e1], [-chi*z2_5_by_tau + z1_5_by_tau, -chi*z2_5_by_tau1 + z1_5_by_tau1, -chi*z2_5_by_e1 + z1_5_by_e1 - 1], [-z2_1_by_tau + z2_5_by_tau, z2_5_by_tau1, -z2_1_by_e1 + z2_5_by_e1]]
    return unknowns, reduced_residual, reduced_jacobian


def solution_ii_period_map(parameters, spectrum, unknowns, *, lib, outputs=3):
    """Map [N, c] of a turn; the start that follows from the dwell times; compatibility and
    switching conditions. The start among the unknowns is not read.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives period_map (4, 5).
    Gives linear_start (2).
    Gives compatibility (4).
    Operations: 249. Intermediate terms: 79.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, tau, tau1, tau2, e1] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick after tau, by the start
    z1_2_by_z20 = -chi*cos_tau + chi
    t1 = chi*sin_tau
    z1_2_by_v20 = chi*tau - t1
    v1_2_by_z10 = -sin_tau
    v1_2_by_z20 = t1
    v1_2_by_v20 = z1_2_by_z20
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip after tau1, by the start
    t5 = 1 - p1
    t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5
    t7 = cos_tau*t6
    t8 = 1/omega1
    t9 = sin_omega1_tau1*t8
    t10 = sin_omega2_tau1/omega2
    t11 = p1*t9 + t10*t5
    z1_3_by_z10 = t11*v1_2_by_z10 + t7
    t12 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3_by_z20 = t11*v1_2_by_z20 + t12 + t6*z1_2_by_z20
    z1_3_by_v10 = cos_tau*t11 + sin_tau*t6
    z1_3_by_v20 = -p2*t10 + p2*t9 + t11*v1_2_by_v20 + t12*tau + t6*z1_2_by_v20
    t13 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t14 = cos_tau*t13
    t15 = p3*sin_omega1_tau1*t8 - p3*t10
    z2_3_by_z10 = t14 + t15*v1_2_by_z10
    t16 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1
    z2_3_by_z20 = t13*z1_2_by_z20 + t15*v1_2_by_z20 + t16
    z2_3_by_v10 = cos_tau*t15 + sin_tau*t13
    z2_3_by_v20 = p1*t10 + t13*z1_2_by_v20 + t15*v1_2_by_v20 + t16*tau + t5*t9
    t17 = omega2*sin_omega2_tau1
    t18 = omega1*sin_omega1_tau1
    t19 = -p1*t18 - t17*t5
    v1_3_by_z10 = cos_tau*t19 + t6*v1_2_by_z10
    t20 = p2*t18
    v1_3_by_z20 = p2*t17 + t19*z1_2_by_z20 - t20 + t6*v1_2_by_z20
    v1_3_by_v10 = sin_tau*t19 + t7
    v1_3_by_v20 = t12 + t19*z1_2_by_v20 + t6*v1_2_by_v20 + tau*(omega2*p2*sin_omega2_tau1 - t20)
    t21 = omega2*p3*sin_omega2_tau1 - p3*t18
    v2_3_by_z10 = cos_tau*t21 + t13*v1_2_by_z10
    t22 = p1*t17 + t18*t5
    v2_3_by_z20 = t13*v1_2_by_z20 + t21*z1_2_by_z20 - t22
    v2_3_by_v10 = sin_tau*t21 + t14
    v2_3_by_v20 = t13*v1_2_by_v20 + t16 + t21*z1_2_by_v20 - t22*tau
    # functions of tau2 in stick-slip
    t23 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t23)
    sin_omega3_tau2 = lib.sin(t23)
    # stick-slip after tau2, by the start
    z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10
    z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20
    z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10
    z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20
    t24 = sin_omega3_tau2/omega3
    t25 = -t24 + tau2
    t26 = 1 - cos_omega3_tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t24*v2_3_by_z10 + t25*v1_3_by_z10 + t26*z1_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t24*v2_3_by_z20 + t25*v1_3_by_z20 + t26*z1_3_by_z20
    z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t24*v2_3_by_v10 + t25*v1_3_by_v10 + t26*z1_3_by_v10
    z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t24*v2_3_by_v20 + t25*v1_3_by_v20 + t26*z1_3_by_v20
    t27 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t26*v1_3_by_z10 + t27*z1_3_by_z10 - t27*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t26*v1_3_by_z20 + t27*z1_3_by_z20 - t27*z2_3_by_z20
    v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t26*v1_3_by_v10 + t27*z1_3_by_v10 - t27*z2_3_by_v10
    v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t26*v1_3_by_v20 + t27*z1_3_by_v20 - t27*z2_3_by_v20
    period_map = [[z1_4_by_z10, z1_4_by_z20, z1_4_by_v10, z1_4_by_v20, 0], [z2_4_by_z10, z2_4_by_z20, z2_4_by_v10, z2_4_by_v20, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_v10, v1_3_by_v20, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_v10, v2_4_by_v20, 0]]
    if outputs == 1:
        return period_map
    # coefficients of the linear equations
    coefficient11 = z1_4_by_z10 - 1
    coefficient22 = z2_4_by_z20 - 1
    # right-hand sides of the linear equations
    right1 = -V*z1_4_by_v10 - V*z1_4_by_v20
    right2 = -V*z2_4_by_v10 - V*z2_4_by_v20
    # determinant of the linear equations
    determinant = coefficient11*coefficient22 - z1_4_by_z20*z2_4_by_z10
    # numerators of Cramer's rule
    numerator1 = coefficient22*right1 - right2*z1_4_by_z20
    numerator2 = coefficient11*right2 - right1*z2_4_by_z10
    # z10, z20 by Cramer's rule
    t28 = 1/determinant
    z1_0 = numerator1*t28
    z2_0 = numerator2*t28
    linear_start = [z1_0, z2_0]
    if outputs == 2:
        return period_map, linear_start
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*z1_2_by_v20 + cos_tau*z1_0 + z1_2_by_z20*z2_0
    z2_2 = V*tau + z2_0
    compatibility = [V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0, V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0, -chi*z2_0 - e1 + z1_0, -chi*z1_2 + chi*z2_2 - e2]
    return period_map, linear_start, compatibility
