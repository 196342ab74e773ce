# Generated; do not edit.
# Source: nonsmooth.derive.systems.dry_friction
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation 1438dbb9032bd9e6
"""Kernels and tables of the system dry-friction, over any arithmetic ``lib``."""

DERIVATION = "1438dbb9032bd9e6"

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
 'fields': ([(7,)], [(36, 5)]),
 'rows': ([(7,)], [(17, 5)]),
 'resets': ([(7,)], [(16, 5)]),
 'modes': ([(7,), (7,)], [(21, 2), (152, 5)]),
 'symmetric_residual': ([(4,), (7,), (5,)], [(5,)]),
 'symmetric_jacobian': ([(4,), (7,), (5,)], [(5, 5)]),
 'symmetric_residual_and_jacobian': ([(4,), (7,), (5,)], [(5,), (5, 5)]),
 'symmetric_parameter_jacobian': ([(4,), (7,), (7, 2), (5,)], [(5, 4)]),
 'symmetric_poincare_jacobian': ([(4,), (7,), (5,)], [(2, 2)]),
 'symmetric_saltations': ([(4,), (7,), (5,)], [(8, 4)]),
 'symmetric_monodromy': ([(4,), (7,), (5,)], [(4, 4)]),
 'symmetric_trace': ([(4,), (7,), (5,)], [()]),
 'symmetric_trace_gradient': ([(4,), (7,), (7, 2), (5,)], [(9,)]),
 'symmetric_states': ([(4,), (7,), (5,)], [(3, 4)]),
 'symmetric_boundary_functions': ([(4,), (7,), (5,)], [(24,), (3,)]),
 'symmetric_flow_slip_slip': ([(4,), (7,), (), (4,)], [(4,)]),
 'symmetric_flow_slip_stick': ([(4,), (7,), (), (4,)], [(4,)]),
 'symmetric_reduced': ([(4,), (7,), (2,)], [(2,), (2, 2)]),
 'symmetric_expand': ([(4,), (7,), (2,)], [(5,), (1,)]),
 'global_stick_residual': ([(5,), (7,), (6,)], [(6,)]),
 'global_stick_jacobian': ([(5,), (7,), (6,)], [(6, 6)]),
 'global_stick_residual_and_jacobian': ([(5,), (7,), (6,)], [(6,), (6, 6)]),
 'global_stick_parameter_jacobian': ([(5,), (7,), (7, 2), (6,)], [(6, 5)]),
 'global_stick_poincare_jacobian': ([(5,), (7,), (6,)], [(2, 2)]),
 'global_stick_saltations': ([(5,), (7,), (6,)], [(16, 4)]),
 'global_stick_monodromy': ([(5,), (7,), (6,)], [(4, 4)]),
 'global_stick_trace': ([(5,), (7,), (6,)], [()]),
 'global_stick_trace_gradient': ([(5,), (7,), (7, 2), (6,)], [(11,)]),
 'global_stick_states': ([(5,), (7,), (6,)], [(5, 4)]),
 'global_stick_boundary_functions': ([(5,), (7,), (6,)], [(44,), (4,)]),
 'global_stick_flow_stick_stick': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_slip_stick': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_slip_slip': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_flow_stick_slip': ([(5,), (7,), (), (4,)], [(4,)]),
 'global_stick_reduced': ([(5,), (7,), (2,)], [(2,), (2, 2)]),
 'global_stick_expand': ([(5,), (7,), (2,)], [(6,)]),
 'global_stick_period_map': ([(5,), (7,), (6,)], [(4,), (2,), (4, 5)]),
 'solution_ii_residual': ([(4,), (7,), (6,)], [(6,)]),
 'solution_ii_jacobian': ([(4,), (7,), (6,)], [(6, 6)]),
 'solution_ii_residual_and_jacobian': ([(4,), (7,), (6,)], [(6,), (6, 6)]),
 'solution_ii_parameter_jacobian': ([(4,), (7,), (7, 2), (6,)], [(6, 4)]),
 'solution_ii_poincare_jacobian': ([(4,), (7,), (6,)], [(2, 2)]),
 'solution_ii_saltations': ([(4,), (7,), (6,)], [(16, 4)]),
 'solution_ii_monodromy': ([(4,), (7,), (6,)], [(4, 4)]),
 'solution_ii_trace': ([(4,), (7,), (6,)], [()]),
 'solution_ii_trace_gradient': ([(4,), (7,), (7, 2), (6,)], [(10,)]),
 'solution_ii_states': ([(4,), (7,), (6,)], [(5, 4)]),
 'solution_ii_boundary_functions': ([(4,), (7,), (6,)], [(44,), (4,)]),
 'solution_ii_flow_stick_stick': ([(4,), (7,), (), (4,)], [(4,)]),
 'solution_ii_flow_slip_stick': ([(4,), (7,), (), (4,)], [(4,)]),
 'solution_ii_flow_slip_slip': ([(4,), (7,), (), (4,)], [(4,)]),
 'solution_ii_flow_stick_slip': ([(4,), (7,), (), (4,)], [(4,)]),
 'solution_ii_reduced': ([(4,), (7,), (3,)], [(3,), (3, 3)]),
 'solution_ii_expand': ([(4,), (7,), (3,)], [(6,)]),
 'solution_ii_period_map': ([(4,), (7,), (6,)], [(4,), (2,), (4, 5)])}

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


def fields(parameters, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives fields (36, 5).
    Operations: 20. Intermediate terms: 2.
    """
    [chi, eta, _, us1, _, us2, _] = parameters
    # outputs
    t0 = chi*eta
    t2 = eta*us2
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, -t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, -t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, t2], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, -t2]]


def rows(parameters, lib):
    """Affine functions of the state: gradients, constants last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives rows (17, 5).
    Operations: 16. Intermediate terms: 0.
    """
    [chi, _, V, us1, ur1, us2, ur2] = parameters
    return [[0, 0, 1, 0, -V], [0, 0, 0, 1, -V], [-chi, chi, 0, 0, -ur2], [chi, -chi, 0, 0, -ur2], [0, 0, 0, -1, V], [1, -chi, 0, 0, -ur1], [-1, chi, 0, 0, -ur1], [0, 0, -1, 0, V], [0, 0, 0, 0, us1], [1, -chi, 0, 0, 0], [0, 0, 0, 0, -us1], [0, 0, 1, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 0, us2], [-chi, chi, 0, 0, 0], [0, 0, 0, 0, -us2], [0, 0, 0, 1, 0]]


def resets(parameters, lib):
    """Affine resets of the state, one below the other, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives resets (16, 5).
    Operations: 0. Intermediate terms: 0.
    """
    [_, _, V, _, _, _, _] = parameters
    return [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, V], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 1, 0], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 0, 0, V], [0, 0, 0, 0, V]]


def modes(parameters, spectrum, lib):
    """Exponents of the modes; coefficients of their functions, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Gives exponents (21, 2).
    Gives coefficients (152, 5).
    Operations: 231. Intermediate terms: 45.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    # outputs
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
    return (
        [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3], [0, 0], [0, 0], [0, omega3], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2]],
        [[0, 0, 0, 0, t3], [0, 0, 0, 0, t9], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t3 - t10], [p3, -t11, 0, 0, -t11*t5*t7 - t13], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t3 + t21*t9], [-t23, -t25, 0, 0, t23*t3 + t25*t9], [-t11, -p2, 0, 0, t10 + t11*t3], [-p3, p1, 0, 0, -p1*t9 + t13], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, omega2*t0*t1*t11 - t35*t9], [t36, -t37, 0, 0, -t3*t36 + t37*t9], [0, chi, 0, 0, us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t43], [0, 0, 0, 0, t46], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t43 - t47], [p3, -t11, 0, 0, -t11*t44*t5 - t48], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t43 + t21*t46], [-t23, -t25, 0, 0, t23*t43 + t25*t46], [-t11, -p2, 0, 0, t11*t43 + t47], [-p3, p1, 0, 0, -p1*t46 + t48], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, omega2*t0*t11*t41 - t35*t46], [t36, -t37, 0, 0, -t36*t43 + t37*t46], [1, 0, 0, 0, 0], [1, 0, 0, 0, t49], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, -t49], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t51, t51, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, t54], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [1, 0, 0, 0, -t49], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, t49], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t51, t51, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, -t54], [0, 0, 0, 0, t55], [0, 0, 0, 0, t56], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t55 - t57], [p3, -t11, 0, 0, t11*t44*t5 - t58], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t55 + t21*t56], [-t23, -t25, 0, 0, t23*t55 + t25*t56], [-t11, -p2, 0, 0, t11*t55 + t57], [-p3, p1, 0, 0, -p1*t56 + t58], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, -omega2*t0*t11*t41 - t35*t56], [t36, -t37, 0, 0, -t36*t55 + t37*t56], [0, chi, 0, 0, -us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t59], [0, 0, 0, 0, t60], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t59 - t61], [p3, -t11, 0, 0, t11*t5*t7 - t62], [0, 0, p1, p2, 0], [0, 0, p3, -t11, 0], [0, 0, t15, t16, 0], [0, 0, t17, t18, 0], [-t19, -t21, 0, 0, t19*t59 + t21*t60], [-t23, -t25, 0, 0, t23*t59 + t25*t60], [-t11, -p2, 0, 0, t11*t59 + t61], [-p3, p1, 0, 0, -p1*t60 + t62], [0, 0, -t11, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t30, t31, 0], [0, 0, t32, t33, 0], [t34, t35, 0, 0, -omega2*t0*t1*t11 - t35*t60], [t36, -t37, 0, 0, -t36*t59 + t37*t60]],
    )


def symmetric_residual(parameters, spectrum, unknowns, lib):
    """Switching and periodicity equations.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives residual (5).
    Operations: 60. Intermediate terms: 19.
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
    t1 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t1)
    sin_omega2_half_tau = lib.sin(t1)
    # half of tau1
    half_tau1 = tau1/2
    # functions of half_tau1 in slip-stick
    cos_half_tau1 = lib.cos(half_tau1)
    sin_half_tau1 = lib.sin(half_tau1)
    # outputs
    t2 = p1*z10 + p2*z20
    t4 = V*p2 + p1*v10
    t5 = sin_omega1_half_tau/omega1
    t7 = sin_omega2_half_tau/omega2
    t8 = p3*z10
    t9 = p1*z20
    t10 = p3*v10
    t11 = chi*z20
    t12 = V*chi
    return [cos_omega1_half_tau*t2 + cos_omega2_half_tau*(-t2 + z10) + t4*t5 - t7*(t4 - v10), cos_omega1_half_tau*(t8 - t9 + z20) + cos_omega2_half_tau*(-t8 + t9) - t5*(V*p1 - V - t10) + t7*(V*p1 - t10), cos_half_tau1*(t11 - z10) + half_tau1*t12 + sin_half_tau1*(-t12 + v10) - t11, V*half_tau1 - z20, -chi*z10 - e2 + t11]


def symmetric_jacobian(parameters, spectrum, unknowns, lib):
    """Derivatives of the equations by the unknowns.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives jacobian (5, 5).
    Operations: 95. Intermediate terms: 30.
    """
    [chi, _, V, _] = parameters
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
    # outputs
    t10 = p1 - 1
    t12 = 1/omega2
    t13 = sin_omega2_half_tau*t12
    t14 = 1/omega1
    t15 = p1*z10 + p2*z20
    t17 = V*p2 + p1*v10
    t18 = sin_omega1_half_tau_by_tau*t14
    t20 = sin_omega2_half_tau_by_tau*t12
    t21 = p3*z10
    t22 = p1*z20
    t23 = p3*v10
    t25 = V*chi
    return [[cos_omega1_half_tau*p1 - cos_omega2_half_tau*t10, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, p1*sin_omega1_half_tau*t14 - t10*t13, cos_omega1_half_tau_by_tau*t15 + cos_omega2_half_tau_by_tau*(-t15 + z10) + t17*t18 - t20*(t17 - v10), 0], [cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, -cos_omega1_half_tau*t10 + cos_omega2_half_tau*p1, p3*sin_omega1_half_tau*t14 - p3*t13, cos_omega1_half_tau_by_tau*(t21 - t22 + z20) + cos_omega2_half_tau_by_tau*(-t21 + t22) - t18*(V*p1 - V - t23) + t20*(V*p1 - t23), 0], [-cos_half_tau1, chi*cos_half_tau1 - chi, sin_half_tau1, 0, cos_half_tau1_by_tau1*(chi*z20 - z10) + sin_half_tau1_by_tau1*(-t25 + v10) + t25/2], [0, -1, 0, 0, V/2], [-chi, chi, 0, 0, 0]]


def symmetric_residual_and_jacobian(parameters, spectrum, unknowns, lib):
    """Equations and their derivatives by the unknowns, sharing all intermediate terms.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives residual (5).
    Gives jacobian (5, 5).
    Operations: 121. Intermediate terms: 40.
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
    # outputs
    t10 = p1*z10 + p2*z20
    t12 = -t10 + z10
    t13 = V*p2 + p1*v10
    t14 = 1/omega1
    t15 = sin_omega1_half_tau*t14
    t17 = t13 - v10
    t18 = 1/omega2
    t19 = sin_omega2_half_tau*t18
    t20 = p3*z10
    t21 = p1*z20
    t22 = t20 - t21 + z20
    t23 = -t20 + t21
    t24 = p3*v10
    t25 = V*p1 - t24
    t26 = V*p1 - V - t24
    t27 = chi*z20
    t28 = t27 - z10
    t29 = V*chi
    t30 = -t29 + v10
    t32 = p1 - 1
    t34 = sin_omega1_half_tau_by_tau*t14
    t35 = sin_omega2_half_tau_by_tau*t18
    return (
        [cos_omega1_half_tau*t10 + cos_omega2_half_tau*t12 + t13*t15 - t17*t19, cos_omega1_half_tau*t22 + cos_omega2_half_tau*t23 - t15*t26 + t19*t25, cos_half_tau1*t28 + half_tau1*t29 + sin_half_tau1*t30 - t27, V*half_tau1 - z20, -chi*z10 - e2 + t27],
        [[cos_omega1_half_tau*p1 - cos_omega2_half_tau*t32, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, p1*sin_omega1_half_tau*t14 - t19*t32, cos_omega1_half_tau_by_tau*t10 + cos_omega2_half_tau_by_tau*t12 + t13*t34 - t17*t35, 0], [cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, -cos_omega1_half_tau*t32 + cos_omega2_half_tau*p1, p3*sin_omega1_half_tau*t14 - p3*t19, cos_omega1_half_tau_by_tau*t22 + cos_omega2_half_tau_by_tau*t23 + t25*t35 - t26*t34, 0], [-cos_half_tau1, chi*cos_half_tau1 - chi, sin_half_tau1, 0, cos_half_tau1_by_tau1*t28 + sin_half_tau1_by_tau1*t30 + t29/2], [0, -1, 0, 0, V/2], [-chi, chi, 0, 0, 0]],
    )


def symmetric_parameter_jacobian(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Total derivatives of the equations by the parameters, through the spectrum too.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives parameter_jacobian (5, 4).
    Operations: 155. Intermediate terms: 49.
    """
    [chi, _, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
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
    # d/dchi of: functions of half_tau in slip-slip
    t6 = half_tau*omega1_by_chi
    cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t6
    sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t6
    t7 = half_tau*omega2_by_chi
    cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t7
    sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t7
    # d/deta of: functions of half_tau in slip-slip
    t8 = half_tau*omega1_by_eta
    cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t8
    sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t8
    t9 = half_tau*omega2_by_eta
    cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t9
    sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t9
    # outputs
    t10 = p1*z10 + p2*z20
    t11 = -t10 + z10
    t12 = 1/omega1
    t13 = sin_omega1_half_tau*t12
    t14 = 1/omega2
    t15 = sin_omega2_half_tau*t14
    t16 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 + t13*v10 - t15*v10
    t17 = -V*sin_omega1_half_tau*t12 + V*t15 - cos_omega1_half_tau*z20 + cos_omega2_half_tau*z20
    t19 = V*p2 + p1*v10
    t20 = t12*t19
    t21 = t19 - v10
    t22 = t14*t21
    t23 = sin_omega2_half_tau/omega2**2
    t24 = t21*t23
    t25 = sin_omega1_half_tau/omega1**2
    t26 = t19*t25
    t27 = p3*z10
    t28 = p1*z20
    t29 = t27 - t28 + z20
    t30 = -t27 + t28
    t31 = p3*v10
    t32 = V*p1 - t31
    t33 = t14*t32
    t34 = V*p1 - V - t31
    t35 = t12*t34
    t36 = t25*t34
    t37 = t23*t32
    return [[cos_omega1_half_tau_by_chi*t10 + cos_omega2_half_tau_by_chi*t11 - omega1_by_chi*t26 + omega2_by_chi*t24 + p1_by_chi*t16 - p2_by_chi*t17 + sin_omega1_half_tau_by_chi*t20 - sin_omega2_half_tau_by_chi*t22, cos_omega1_half_tau_by_eta*t10 + cos_omega2_half_tau_by_eta*t11 - omega1_by_eta*t26 + omega2_by_eta*t24 + p1_by_eta*t16 - p2_by_eta*t17 + sin_omega1_half_tau_by_eta*t20 - sin_omega2_half_tau_by_eta*t22, p2*sin_omega1_half_tau*t12 - p2*t15, 0], [cos_omega1_half_tau_by_chi*t29 + cos_omega2_half_tau_by_chi*t30 + omega1_by_chi*t36 - omega2_by_chi*t37 + p1_by_chi*t17 + p3_by_chi*t16 - sin_omega1_half_tau_by_chi*t35 + sin_omega2_half_tau_by_chi*t33, cos_omega1_half_tau_by_eta*t29 + cos_omega2_half_tau_by_eta*t30 + omega1_by_eta*t36 - omega2_by_eta*t37 + p1_by_eta*t17 + p3_by_eta*t16 - sin_omega1_half_tau_by_eta*t35 + sin_omega2_half_tau_by_eta*t33, p1*t15 - t13*(p1 - 1), 0], [V*half_tau1 - V*sin_half_tau1 + cos_half_tau1*z20 - z20, 0, chi*half_tau1 - chi*sin_half_tau1, 0], [0, 0, half_tau1, 0], [-z10 + z20, 0, 0, -1]]


def symmetric_poincare_jacobian(parameters, spectrum, unknowns, lib):
    """Jacobian of the Poincare map in the section's coordinates.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives poincare_jacobian (2, 2).
    Operations: 174. Intermediate terms: 66.
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
    t5 = sin_omega2_tau/omega2
    t3 = sin_omega1_tau*t2
    t4 = 1 - p1
    t6 = p1*t3 + t4*t5
    t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4
    t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*v10 + t7*z10 + t8*z20
    t9 = p3*sin_omega1_tau*t2 - p3*t5
    t10 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t11 = cos_omega1_tau*t4 + cos_omega2_tau*p1
    z2_1 = V*(p1*t5 + t3*t4) + t10*z10 + t11*z20 + t9*v10
    t12 = omega2*sin_omega2_tau
    t13 = omega1*sin_omega1_tau
    t14 = p1*t13 + t12*t4
    t15 = -omega2*p2*sin_omega2_tau + p2*t13
    v1_1 = V*t8 - t14*z10 - t15*z20 + t7*v10
    t16 = -omega2*p3*sin_omega2_tau + p3*t13
    t17 = p1*t12 + t13*t4
    v2_1 = V*t11 + t10*v10 - t16*z10 - t17*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t18 = -chi*cos_tau1 + chi
    t19 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t19) + cos_tau1*z1_1 + sin_tau1*v1_1 + t18*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t18 + cos_tau1*v1_1 - sin_tau1*z1_1 + t19*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = t7 + t8
    carried_z1_1_by_v10 = t6
    carried_z2_1_by_z20 = t10 + t11
    carried_z2_1_by_v10 = t9
    carried_v1_1_by_z20 = -t14 - t15
    carried_v1_1_by_v10 = t7
    carried_v2_1_by_z20 = -t16 - t17
    carried_v2_1_by_v10 = t10
    # rate of the exit boundary after tau
    t20 = chi*z2_1
    rate_1 = chi*eta*z1_1 - eta*t20
    # derivatives of the time to the boundary after tau
    t21 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t21
    delay_tau_by_v10 = -carried_v2_1_by_v10*t21
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t22 = t20 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t22
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t22
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t18*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t18*z2_1_on_boundary_by_v10
    carried_v1_2_by_z20 = cos_tau1*v1_1_on_boundary_by_z20 - sin_tau1*z1_1_on_boundary_by_z20 + t19*z2_1_on_boundary_by_z20
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t19*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    rate_2 = V*chi - chi*v1_2
    # derivatives of the time to the boundary after tau1
    t23 = 1/rate_2
    delay_tau1_by_z20 = t23*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    delay_tau1_by_v10 = t23*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10)
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    z2_2_on_boundary_by_v10 = V*delay_tau1_by_v10 + z2_1_on_boundary_by_v10
    t24 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau1_by_z20*t24
    v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*t24
    return [[z2_2_on_boundary_by_z20, z2_2_on_boundary_by_v10], [v1_2_on_boundary_by_z20, v1_2_on_boundary_by_v10]]


def symmetric_saltations(parameters, spectrum, unknowns, lib):
    """Saltation matrices of the transitions, one below the other.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives saltations (8, 4).
    Operations: 130. Intermediate terms: 40.
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
    t6 = cos_omega1_tau*p1 + cos_omega2_tau*t4
    t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*z10 + t7*z20 + v10*(p1*t3 + t4*t5)
    t8 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t9 = cos_omega1_tau*t4 + cos_omega2_tau*p1
    z2_1 = V*(p1*t5 + t3*t4) + t8*z10 + t9*z20 + v10*(p3*sin_omega1_tau*t2 - p3*t5)
    t10 = omega2*sin_omega2_tau
    t11 = omega1*sin_omega1_tau
    v1_1 = V*t7 + t6*v10 + z10*(-p1*t11 - t10*t4) + z20*(omega2*p2*sin_omega2_tau - p2*t11)
    v2_1 = V*t9 + t8*v10 + z10*(omega2*p3*sin_omega2_tau - p3*t11) + z20*(-p1*t10 - t11*t4)
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t12 = -chi*cos_tau1 + chi
    t13 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t13) + cos_tau1*z1_1 + sin_tau1*v1_1 + t12*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t12 + cos_tau1*v1_1 - sin_tau1*z1_1 + t13*z2_1
    # vector fields at transition 1
    t14 = chi*z2_1
    before_v1_1 = t14 - z1_1
    t16 = chi*eta
    before_v2_1 = -eta*t14 + t16*z1_1
    behind_v1_1 = before_v1_1
    # vector fields at transition 2
    t17 = chi*z2_2
    before_v1_2 = t17 - z1_2
    behind_v1_2 = before_v1_2
    behind_v2_2 = -eta*t17 + t16*z1_2
    # outputs
    t19 = 1/before_v2_1
    t20 = chi/(V*chi - chi*v1_2)
    t21 = t20*(-before_v1_2 + behind_v1_2)
    t22 = behind_v2_2*t20
    return [[1, 0, 0, 0], [0, 1, 0, t19*(V - v2_1)], [0, 0, 1, t19*(-before_v1_1 + behind_v1_1)], [0, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [-t21, t21, 1, 0], [-t22, t22, 0, 1]]


def symmetric_monodromy(parameters, spectrum, unknowns, lib):
    """Monodromy matrix: the product of flows and saltation matrices over a period.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives monodromy (4, 4).
    Operations: 221. Intermediate terms: 91.
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
    t16 = -p1*t15 - t14*t4
    t17 = omega2*p2*sin_omega2_tau - p2*t15
    v1_1 = V*t8 + t16*z10 + t17*z20 + t7*v10
    t18 = omega2*p3*sin_omega2_tau - p3*t15
    t19 = -p1*t14 - t15*t4
    v2_1 = V*t12 + t11*v10 + t18*z10 + t19*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t20 = -chi*cos_tau1 + chi
    t21 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t21) + cos_tau1*z1_1 + sin_tau1*v1_1 + t20*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t20 + cos_tau1*v1_1 - sin_tau1*z1_1 + t21*z2_1
    # vector fields at transition 1
    t22 = chi*z2_1
    before_v1_1 = t22 - z1_1
    t24 = chi*eta
    before_v2_1 = -eta*t22 + t24*z1_1
    behind_v1_1 = before_v1_1
    # vector fields at transition 2
    t25 = chi*z2_2
    before_v1_2 = t25 - z1_2
    behind_v1_2 = before_v1_2
    behind_v2_2 = -eta*t25 + t24*z1_2
    # Phi of phase 1
    phi_1_00 = t7
    phi_1_01 = t8
    phi_1_02 = t6
    phi_1_03 = t9
    phi_1_10 = t11
    phi_1_11 = t12
    phi_1_12 = t10
    phi_1_13 = t13
    phi_1_20 = t16
    phi_1_21 = t17
    phi_1_22 = t7
    phi_1_23 = t8
    phi_1_30 = t18
    phi_1_31 = t19
    phi_1_32 = t11
    phi_1_33 = t12
    # saltation of phase 1
    t27 = 1/before_v2_1
    t28 = t27*(V - v2_1)
    saltation_1_10 = phi_1_10 + phi_1_30*t28
    saltation_1_11 = phi_1_11 + phi_1_31*t28
    saltation_1_12 = phi_1_12 + phi_1_32*t28
    saltation_1_13 = phi_1_13 + phi_1_33*t28
    t29 = t27*(-before_v1_1 + behind_v1_1)
    saltation_1_20 = phi_1_20 + phi_1_30*t29
    saltation_1_21 = phi_1_21 + phi_1_31*t29
    saltation_1_22 = phi_1_22 + phi_1_32*t29
    saltation_1_23 = phi_1_23 + phi_1_33*t29
    # Phi of phase 2
    phi_2_00 = cos_tau1*phi_1_00 + saltation_1_10*t20 + saltation_1_20*sin_tau1
    phi_2_01 = cos_tau1*phi_1_01 + saltation_1_11*t20 + saltation_1_21*sin_tau1
    phi_2_02 = cos_tau1*phi_1_02 + saltation_1_12*t20 + saltation_1_22*sin_tau1
    phi_2_03 = cos_tau1*phi_1_03 + saltation_1_13*t20 + saltation_1_23*sin_tau1
    phi_2_20 = cos_tau1*saltation_1_20 - phi_1_00*sin_tau1 + saltation_1_10*t21
    phi_2_21 = cos_tau1*saltation_1_21 - phi_1_01*sin_tau1 + saltation_1_11*t21
    phi_2_22 = cos_tau1*saltation_1_22 - phi_1_02*sin_tau1 + saltation_1_12*t21
    phi_2_23 = cos_tau1*saltation_1_23 - phi_1_03*sin_tau1 + saltation_1_13*t21
    # saltation of phase 2
    t30 = 1/(V*chi - chi*v1_2)
    t31 = chi*t30
    t32 = t31*(-before_v1_2 + behind_v1_2)
    saltation_2_20 = -phi_2_00*t32 + phi_2_20 + saltation_1_10*t32
    saltation_2_21 = -phi_2_01*t32 + phi_2_21 + saltation_1_11*t32
    saltation_2_22 = -phi_2_02*t32 + phi_2_22 + saltation_1_12*t32
    saltation_2_23 = -phi_2_03*t32 + phi_2_23 + saltation_1_13*t32
    t33 = behind_v2_2*t31
    saltation_2_30 = behind_v2_2*chi*saltation_1_10*t30 - phi_2_00*t33
    saltation_2_31 = behind_v2_2*chi*saltation_1_11*t30 - phi_2_01*t33
    saltation_2_32 = behind_v2_2*chi*saltation_1_12*t30 - phi_2_02*t33
    saltation_2_33 = behind_v2_2*chi*saltation_1_13*t30 - phi_2_03*t33
    return [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [saltation_1_10, saltation_1_11, saltation_1_12, saltation_1_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]


def symmetric_trace(parameters, spectrum, unknowns, lib):
    """Trace of the Poincare map's Jacobian.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives trace.
    Operations: 166. Intermediate terms: 62.
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
    t5 = sin_omega2_tau/omega2
    t3 = sin_omega1_tau*t2
    t4 = 1 - p1
    t6 = p1*t3 + t4*t5
    t7 = cos_omega1_tau*p1 + cos_omega2_tau*t4
    t8 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    z1_1 = V*(p2*sin_omega1_tau*t2 - p2*t5) + t6*v10 + t7*z10 + t8*z20
    t9 = p3*sin_omega1_tau*t2 - p3*t5
    t10 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t11 = cos_omega1_tau*t4 + cos_omega2_tau*p1
    z2_1 = V*(p1*t5 + t3*t4) + t10*z10 + t11*z20 + t9*v10
    t12 = omega2*sin_omega2_tau
    t13 = omega1*sin_omega1_tau
    t14 = p1*t13 + t12*t4
    t15 = -omega2*p2*sin_omega2_tau + p2*t13
    v1_1 = V*t8 - t14*z10 - t15*z20 + t7*v10
    t16 = -omega2*p3*sin_omega2_tau + p3*t13
    t17 = p1*t12 + t13*t4
    v2_1 = V*t11 + t10*v10 - t16*z10 - t17*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t18 = -chi*cos_tau1 + chi
    t19 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t19) + cos_tau1*z1_1 + sin_tau1*v1_1 + t18*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t18 + cos_tau1*v1_1 - sin_tau1*z1_1 + t19*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = t7 + t8
    carried_z1_1_by_v10 = t6
    carried_z2_1_by_z20 = t10 + t11
    carried_z2_1_by_v10 = t9
    carried_v1_1_by_z20 = -t14 - t15
    carried_v1_1_by_v10 = t7
    carried_v2_1_by_z20 = -t16 - t17
    carried_v2_1_by_v10 = t10
    # rate of the exit boundary after tau
    t20 = chi*z2_1
    rate_1 = chi*eta*z1_1 - eta*t20
    # derivatives of the time to the boundary after tau
    t21 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t21
    delay_tau_by_v10 = -carried_v2_1_by_v10*t21
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t22 = t20 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t22
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t22
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t18*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t18*z2_1_on_boundary_by_v10
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t19*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    rate_2 = V*chi - chi*v1_2
    # derivatives of the time to the boundary after tau1
    t23 = 1/rate_2
    delay_tau1_by_z20 = t23*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    delay_tau1_by_v10 = t23*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10)
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*(chi*z2_2 - z1_2)
    return v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20


def symmetric_trace_gradient(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Derivatives of the trace by the unknowns, then in total by the parameters.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives trace_gradient (9).
    Operations: 1300. Intermediate terms: 390.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
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
    t7 = sin_omega1_tau*t6
    t8 = p1 - 1
    t10 = 1/omega2
    t11 = sin_omega2_tau*t10
    t12 = p1*t7 - t11*t8
    t13 = cos_omega1_tau*p1 - cos_omega2_tau*t8
    t14 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t15 = p2*sin_omega1_tau*t6 - p2*t11
    z1_1 = V*t15 + t12*v10 + t13*z10 + t14*z20
    t16 = p3*sin_omega1_tau*t6 - p3*t11
    t17 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t18 = -cos_omega1_tau*t8 + cos_omega2_tau*p1
    t19 = p1*t11 - t7*t8
    z2_1 = V*t19 + t16*v10 + t17*z10 + t18*z20
    t20 = omega2*sin_omega2_tau
    t21 = omega1*sin_omega1_tau
    t22 = p1*t21 - t20*t8
    t24 = -omega2*p2*sin_omega2_tau + p2*t21
    v1_1 = V*t14 + t13*v10 - t22*z10 - t24*z20
    t26 = -omega2*p3*sin_omega2_tau + p3*t21
    t28 = p1*t20 - t21*t8
    v2_1 = V*t18 + t17*v10 - t26*z10 - t28*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t33 = chi*cos_tau1
    t34 = chi - t33
    t35 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t35) + cos_tau1*z1_1 + sin_tau1*v1_1 + t34*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t34 + cos_tau1*v1_1 - sin_tau1*z1_1 + t35*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = t13 + t14
    carried_z1_1_by_v10 = t12
    carried_z2_1_by_z20 = t17 + t18
    carried_z2_1_by_v10 = t16
    carried_v1_1_by_z20 = -t22 - t24
    carried_v1_1_by_v10 = t13
    carried_v2_1_by_z20 = -t26 - t28
    carried_v2_1_by_v10 = t17
    # rate of the exit boundary after tau
    t36 = eta*z1_1
    t37 = chi*z2_1
    rate_1 = chi*t36 - eta*t37
    # derivatives of the time to the boundary after tau
    t38 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t38
    delay_tau_by_v10 = -carried_v2_1_by_v10*t38
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t39 = t37 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t39
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t39
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    t40 = V*chi
    rate_2 = -chi*v1_2 + t40
    # derivatives of the time to the boundary after tau1
    t41 = 1/rate_2
    t42 = chi*z2_1_on_boundary_by_z20
    t43 = carried_z1_2_by_z20*chi - t42
    delay_tau1_by_z20 = t41*t43
    t44 = chi*z2_1_on_boundary_by_v10
    t45 = carried_z1_2_by_v10*chi - t44
    delay_tau1_by_v10 = t41*t45
    # d/dtau of: functions of tau in slip-slip
    cos_omega1_tau_by_tau = -omega1*sin_omega1_tau
    sin_omega1_tau_by_tau = cos_omega1_tau*omega1
    cos_omega2_tau_by_tau = -omega2*sin_omega2_tau
    sin_omega2_tau_by_tau = cos_omega2_tau*omega2
    # d/dchi of: functions of tau in slip-slip
    t46 = omega1_by_chi*tau
    cos_omega1_tau_by_chi = -sin_omega1_tau*t46
    sin_omega1_tau_by_chi = cos_omega1_tau*t46
    t47 = omega2_by_chi*tau
    cos_omega2_tau_by_chi = -sin_omega2_tau*t47
    sin_omega2_tau_by_chi = cos_omega2_tau*t47
    # d/deta of: functions of tau in slip-slip
    t48 = omega1_by_eta*tau
    cos_omega1_tau_by_eta = -sin_omega1_tau*t48
    sin_omega1_tau_by_eta = cos_omega1_tau*t48
    t49 = omega2_by_eta*tau
    cos_omega2_tau_by_eta = -sin_omega2_tau*t49
    sin_omega2_tau_by_eta = cos_omega2_tau*t49
    # d/dz10 of: slip-slip for tau, until second-reaches-belt
    z1_1_by_z10 = t13
    z2_1_by_z10 = t17
    v1_1_by_z10 = -t22
    v2_1_by_z10 = -t26
    # d/dz20 of: slip-slip for tau, until second-reaches-belt
    z1_1_by_z20 = t14
    z2_1_by_z20 = t18
    v1_1_by_z20 = -t24
    v2_1_by_z20 = -t28
    # d/dv10 of: slip-slip for tau, until second-reaches-belt
    z1_1_by_v10 = t12
    z2_1_by_v10 = t16
    v1_1_by_v10 = t13
    v2_1_by_v10 = t17
    # d/dtau of: slip-slip for tau, until second-reaches-belt
    t50 = p1*z10
    t51 = p2*z20
    t52 = t50 + t51
    t53 = -t51 - t8*z10
    t54 = p1*v10
    t55 = V*p2
    t56 = t54*t6 + t55*t6
    t57 = -t10*t55 - t10*t8*v10
    z1_1_by_tau = cos_omega1_tau_by_tau*t52 + cos_omega2_tau_by_tau*t53 + sin_omega1_tau_by_tau*t56 + sin_omega2_tau_by_tau*t57
    t58 = p3*z10
    t59 = -t8*z20
    t60 = t58 + t59
    t61 = p1*z20
    t62 = -t58 + t61
    t63 = p3*v10
    t64 = -V*t8
    t65 = t6*t63 + t6*t64
    t66 = V*p1
    t67 = -t10*t63 + t10*t66
    z2_1_by_tau = cos_omega1_tau_by_tau*t60 + cos_omega2_tau_by_tau*t62 + sin_omega1_tau_by_tau*t65 + sin_omega2_tau_by_tau*t67
    t68 = t54 + t55
    t69 = -t55 - t8*v10
    t70 = -omega1*t50 - omega1*t51
    t71 = -t8*z10
    t72 = omega2*t51 - omega2*t71
    v1_1_by_tau = cos_omega1_tau_by_tau*t68 + cos_omega2_tau_by_tau*t69 + sin_omega1_tau_by_tau*t70 + sin_omega2_tau_by_tau*t72
    t73 = t63 + t64
    t74 = -t63 + t66
    t75 = -omega1*t58 - omega1*t59
    t76 = omega2*p3*z10 - omega2*t61
    v2_1_by_tau = cos_omega1_tau_by_tau*t73 + cos_omega2_tau_by_tau*t74 + sin_omega1_tau_by_tau*t75 + sin_omega2_tau_by_tau*t76
    # d/dchi of: slip-slip for tau, until second-reaches-belt
    t77 = 1/omega1**2
    t78 = sin_omega1_tau*t77
    t79 = -t54*t78 - t55*t78
    t80 = 1/omega2**2
    t81 = sin_omega2_tau*t80
    t82 = t55*t81 + t8*t81*v10
    t83 = -sin_omega1_tau*t6 + t11
    t85 = cos_omega1_tau - cos_omega2_tau
    t86 = -t83*v10 + t85*z10
    t87 = -V*t83 + t85*z20
    z1_1_by_chi = cos_omega1_tau_by_chi*t52 + cos_omega2_tau_by_chi*t53 + omega1_by_chi*t79 + omega2_by_chi*t82 + p1_by_chi*t86 + p2_by_chi*t87 + sin_omega1_tau_by_chi*t56 + sin_omega2_tau_by_chi*t57
    t88 = -t63*t78 - t64*t78
    t89 = p3*sin_omega2_tau*t80*v10 - t66*t81
    t91 = V*t83 - t85*z20
    z2_1_by_chi = cos_omega1_tau_by_chi*t60 + cos_omega2_tau_by_chi*t62 + omega1_by_chi*t88 + omega2_by_chi*t89 + p1_by_chi*t91 + p3_by_chi*t86 + sin_omega1_tau_by_chi*t65 + sin_omega2_tau_by_chi*t67
    t92 = -sin_omega1_tau*t50 - sin_omega1_tau*t51
    t93 = sin_omega2_tau*t51 - sin_omega2_tau*t71
    t94 = -omega2*sin_omega2_tau + t21
    t96 = t85*v10 - t94*z10
    t97 = V*t85 - t94*z20
    v1_1_by_chi = cos_omega1_tau_by_chi*t68 + cos_omega2_tau_by_chi*t69 + omega1_by_chi*t92 + omega2_by_chi*t93 + p1_by_chi*t96 + p2_by_chi*t97 + sin_omega1_tau_by_chi*t70 + sin_omega2_tau_by_chi*t72
    t98 = -sin_omega1_tau*t58 - sin_omega1_tau*t59
    t99 = p3*sin_omega2_tau*z10 - sin_omega2_tau*t61
    t100 = -V*t85 + t94*z20
    v2_1_by_chi = cos_omega1_tau_by_chi*t73 + cos_omega2_tau_by_chi*t74 + omega1_by_chi*t98 + omega2_by_chi*t99 + p1_by_chi*t100 + p3_by_chi*t96 + sin_omega1_tau_by_chi*t75 + sin_omega2_tau_by_chi*t76
    # d/deta of: slip-slip for tau, until second-reaches-belt
    z1_1_by_eta = cos_omega1_tau_by_eta*t52 + cos_omega2_tau_by_eta*t53 + omega1_by_eta*t79 + omega2_by_eta*t82 + p1_by_eta*t86 + p2_by_eta*t87 + sin_omega1_tau_by_eta*t56 + sin_omega2_tau_by_eta*t57
    z2_1_by_eta = cos_omega1_tau_by_eta*t60 + cos_omega2_tau_by_eta*t62 + omega1_by_eta*t88 + omega2_by_eta*t89 + p1_by_eta*t91 + p3_by_eta*t86 + sin_omega1_tau_by_eta*t65 + sin_omega2_tau_by_eta*t67
    v1_1_by_eta = cos_omega1_tau_by_eta*t68 + cos_omega2_tau_by_eta*t69 + omega1_by_eta*t92 + omega2_by_eta*t93 + p1_by_eta*t96 + p2_by_eta*t97 + sin_omega1_tau_by_eta*t70 + sin_omega2_tau_by_eta*t72
    v2_1_by_eta = cos_omega1_tau_by_eta*t73 + cos_omega2_tau_by_eta*t74 + omega1_by_eta*t98 + omega2_by_eta*t99 + p1_by_eta*t100 + p3_by_eta*t96 + sin_omega1_tau_by_eta*t75 + sin_omega2_tau_by_eta*t76
    # d/dV of: slip-slip for tau, until second-reaches-belt
    z1_1_by_V = t15
    z2_1_by_V = t19
    v1_1_by_V = t14
    v2_1_by_V = t18
    # d/dtau1 of: functions of tau1 in slip-stick
    cos_tau1_by_tau1 = -sin_tau1
    sin_tau1_by_tau1 = cos_tau1
    # d/dz10 of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_z10 = cos_tau1*z1_1_by_z10 + sin_tau1*v1_1_by_z10 + t34*z2_1_by_z10
    v1_2_by_z10 = cos_tau1*v1_1_by_z10 - sin_tau1*z1_1_by_z10 + t35*z2_1_by_z10
    # d/dz20 of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_z20 = cos_tau1*z1_1_by_z20 + sin_tau1*v1_1_by_z20 + t34*z2_1_by_z20
    v1_2_by_z20 = cos_tau1*v1_1_by_z20 - sin_tau1*z1_1_by_z20 + t35*z2_1_by_z20
    # d/dv10 of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_v10 = cos_tau1*z1_1_by_v10 + sin_tau1*v1_1_by_v10 + t34*z2_1_by_v10
    v1_2_by_v10 = cos_tau1*v1_1_by_v10 - sin_tau1*z1_1_by_v10 + t35*z2_1_by_v10
    # d/dtau of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_tau = cos_tau1*z1_1_by_tau + sin_tau1*v1_1_by_tau + t34*z2_1_by_tau
    v1_2_by_tau = cos_tau1*v1_1_by_tau - sin_tau1*z1_1_by_tau + t35*z2_1_by_tau
    # d/dtau1 of: slip-stick for tau1, until second-breaks-forward
    t101 = -t40 + v1_1
    z1_2_by_tau1 = -cos_tau1_by_tau1*t39 + sin_tau1_by_tau1*t101 + t40
    v1_2_by_tau1 = cos_tau1_by_tau1*t101 + sin_tau1_by_tau1*t39
    # d/dchi of: slip-stick for tau1, until second-breaks-forward
    t102 = 1 - cos_tau1
    z1_2_by_chi = V*(-sin_tau1 + tau1) + cos_tau1*z1_1_by_chi + sin_tau1*v1_1_by_chi + t102*z2_1 + t34*z2_1_by_chi
    v1_2_by_chi = V*t102 + cos_tau1*v1_1_by_chi - sin_tau1*z1_1_by_chi + sin_tau1*z2_1 + t35*z2_1_by_chi
    # d/deta of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_eta = cos_tau1*z1_1_by_eta + sin_tau1*v1_1_by_eta + t34*z2_1_by_eta
    v1_2_by_eta = cos_tau1*v1_1_by_eta - sin_tau1*z1_1_by_eta + t35*z2_1_by_eta
    # d/dV of: slip-stick for tau1, until second-breaks-forward
    z1_2_by_V = chi*tau1 + cos_tau1*z1_1_by_V + sin_tau1*v1_1_by_V + t34*z2_1_by_V - t35
    z2_2_by_V = tau1 + z2_1_by_V
    v1_2_by_V = chi + cos_tau1*v1_1_by_V - sin_tau1*z1_1_by_V - t33 + t35*z2_1_by_V
    # d/dtau of: Phi along tau
    t103 = p1 + p2
    t104 = -p2 - t8
    carried_z1_1_by_z20_by_tau = cos_omega1_tau_by_tau*t103 + cos_omega2_tau_by_tau*t104
    t105 = sin_omega2_tau_by_tau*t10
    carried_z1_1_by_v10_by_tau = p1*sin_omega1_tau_by_tau*t6 - t105*t8
    t106 = -p1 + p3 + 1
    t107 = p1 - p3
    carried_z2_1_by_z20_by_tau = cos_omega1_tau_by_tau*t106 + cos_omega2_tau_by_tau*t107
    carried_z2_1_by_v10_by_tau = p3*sin_omega1_tau_by_tau*t6 - p3*t105
    t108 = -omega1*p1 - omega1*p2
    t109 = omega2*p2 + omega2*t8
    carried_v1_1_by_z20_by_tau = sin_omega1_tau_by_tau*t108 + sin_omega2_tau_by_tau*t109
    carried_v1_1_by_v10_by_tau = cos_omega1_tau_by_tau*p1 - cos_omega2_tau_by_tau*t8
    t110 = -omega1*p3 + omega1*t8
    t111 = -omega2*p1 + omega2*p3
    carried_v2_1_by_z20_by_tau = sin_omega1_tau_by_tau*t110 + sin_omega2_tau_by_tau*t111
    carried_v2_1_by_v10_by_tau = cos_omega1_tau_by_tau*p3 - cos_omega2_tau_by_tau*p3
    # d/dchi of: Phi along tau
    t112 = p1_by_chi*t85
    carried_z1_1_by_z20_by_chi = cos_omega1_tau_by_chi*t103 + cos_omega2_tau_by_chi*t104 + p2_by_chi*t85 + t112
    t113 = sin_omega1_tau_by_chi*t6
    t114 = sin_omega2_tau_by_chi*t10
    t115 = p1*sin_omega1_tau
    t116 = omega1_by_chi*t77
    t117 = -sin_omega2_tau*t8
    t118 = omega2_by_chi*t80
    carried_z1_1_by_v10_by_chi = p1*t113 - p1_by_chi*t83 - t114*t8 - t115*t116 - t117*t118
    t119 = p3_by_chi*t85
    carried_z2_1_by_z20_by_chi = cos_omega1_tau_by_chi*t106 + cos_omega2_tau_by_chi*t107 - p1_by_chi*t85 + t119
    t120 = p3*sin_omega2_tau
    t121 = p3*sin_omega1_tau
    carried_z2_1_by_v10_by_chi = p3*t113 - p3*t114 - p3_by_chi*t83 - t116*t121 + t118*t120
    t122 = -p2*sin_omega1_tau - t115
    t123 = p2*sin_omega2_tau - t117
    carried_v1_1_by_z20_by_chi = omega1_by_chi*t122 + omega2_by_chi*t123 - p1_by_chi*t94 - p2_by_chi*t94 + sin_omega1_tau_by_chi*t108 + sin_omega2_tau_by_chi*t109
    carried_v1_1_by_v10_by_chi = cos_omega1_tau_by_chi*p1 - cos_omega2_tau_by_chi*t8 + t112
    t124 = sin_omega1_tau*t8 - t121
    t125 = -p1*sin_omega2_tau + p3*sin_omega2_tau
    carried_v2_1_by_z20_by_chi = omega1_by_chi*t124 + omega2_by_chi*t125 + p1_by_chi*t94 - p3_by_chi*t94 + sin_omega1_tau_by_chi*t110 + sin_omega2_tau_by_chi*t111
    carried_v2_1_by_v10_by_chi = cos_omega1_tau_by_chi*p3 - cos_omega2_tau_by_chi*p3 + t119
    # d/deta of: Phi along tau
    t126 = p1_by_eta*t85
    carried_z1_1_by_z20_by_eta = cos_omega1_tau_by_eta*t103 + cos_omega2_tau_by_eta*t104 + p2_by_eta*t85 + t126
    t127 = sin_omega1_tau_by_eta*t6
    t128 = sin_omega2_tau_by_eta*t10
    t129 = omega1_by_eta*t77
    t130 = omega2_by_eta*t80
    carried_z1_1_by_v10_by_eta = p1*t127 - p1_by_eta*t83 - t115*t129 - t117*t130 - t128*t8
    t131 = p3_by_eta*t85
    carried_z2_1_by_z20_by_eta = cos_omega1_tau_by_eta*t106 + cos_omega2_tau_by_eta*t107 - p1_by_eta*t85 + t131
    carried_z2_1_by_v10_by_eta = p3*t127 - p3*t128 - p3_by_eta*t83 + t120*t130 - t121*t129
    carried_v1_1_by_z20_by_eta = omega1_by_eta*t122 + omega2_by_eta*t123 - p1_by_eta*t94 - p2_by_eta*t94 + sin_omega1_tau_by_eta*t108 + sin_omega2_tau_by_eta*t109
    carried_v1_1_by_v10_by_eta = cos_omega1_tau_by_eta*p1 - cos_omega2_tau_by_eta*t8 + t126
    carried_v2_1_by_z20_by_eta = omega1_by_eta*t124 + omega2_by_eta*t125 + p1_by_eta*t94 - p3_by_eta*t94 + sin_omega1_tau_by_eta*t110 + sin_omega2_tau_by_eta*t111
    carried_v2_1_by_v10_by_eta = cos_omega1_tau_by_eta*p3 - cos_omega2_tau_by_eta*p3 + t131
    # d/dz10 of: rate of the exit boundary after tau
    t132 = chi*eta
    rate_1_by_z10 = t132*z1_1_by_z10 - t132*z2_1_by_z10
    # d/dz20 of: rate of the exit boundary after tau
    rate_1_by_z20 = t132*z1_1_by_z20 - t132*z2_1_by_z20
    # d/dv10 of: rate of the exit boundary after tau
    rate_1_by_v10 = t132*z1_1_by_v10 - t132*z2_1_by_v10
    # d/dtau of: rate of the exit boundary after tau
    rate_1_by_tau = t132*z1_1_by_tau - t132*z2_1_by_tau
    # d/dchi of: rate of the exit boundary after tau
    rate_1_by_chi = -eta*z2_1 + t132*z1_1_by_chi - t132*z2_1_by_chi + t36
    # d/deta of: rate of the exit boundary after tau
    rate_1_by_eta = chi*z1_1 + t132*z1_1_by_eta - t132*z2_1_by_eta - t37
    # d/dV of: rate of the exit boundary after tau
    rate_1_by_V = t132*z1_1_by_V - t132*z2_1_by_V
    # d/dz10 of: derivatives of the time to the boundary after tau
    t133 = 1/rate_1**2
    t134 = rate_1_by_z10*t133
    delay_tau_by_z20_by_z10 = carried_v2_1_by_z20*t134
    delay_tau_by_v10_by_z10 = carried_v2_1_by_v10*t134
    # d/dz20 of: derivatives of the time to the boundary after tau
    t135 = rate_1_by_z20*t133
    delay_tau_by_z20_by_z20 = carried_v2_1_by_z20*t135
    delay_tau_by_v10_by_z20 = carried_v2_1_by_v10*t135
    # d/dv10 of: derivatives of the time to the boundary after tau
    t136 = rate_1_by_v10*t133
    delay_tau_by_z20_by_v10 = carried_v2_1_by_z20*t136
    delay_tau_by_v10_by_v10 = carried_v2_1_by_v10*t136
    # d/dtau of: derivatives of the time to the boundary after tau
    t137 = rate_1_by_tau*t133
    delay_tau_by_z20_by_tau = carried_v2_1_by_z20*t137 - carried_v2_1_by_z20_by_tau*t38
    delay_tau_by_v10_by_tau = carried_v2_1_by_v10*t137 - carried_v2_1_by_v10_by_tau*t38
    # d/dchi of: derivatives of the time to the boundary after tau
    t138 = rate_1_by_chi*t133
    delay_tau_by_z20_by_chi = carried_v2_1_by_z20*t138 - carried_v2_1_by_z20_by_chi*t38
    delay_tau_by_v10_by_chi = carried_v2_1_by_v10*t138 - carried_v2_1_by_v10_by_chi*t38
    # d/deta of: derivatives of the time to the boundary after tau
    t139 = rate_1_by_eta*t133
    delay_tau_by_z20_by_eta = carried_v2_1_by_z20*t139 - carried_v2_1_by_z20_by_eta*t38
    delay_tau_by_v10_by_eta = carried_v2_1_by_v10*t139 - carried_v2_1_by_v10_by_eta*t38
    # d/dV of: derivatives of the time to the boundary after tau
    t140 = rate_1_by_V*t133
    delay_tau_by_z20_by_V = carried_v2_1_by_z20*t140
    delay_tau_by_v10_by_V = carried_v2_1_by_v10*t140
    # d/dz10 of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v1_1_by_z10 + delay_tau_by_z20_by_z10*v1_1
    z1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v1_1_by_z10 + delay_tau_by_v10_by_z10*v1_1
    z2_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v2_1_by_z10 + delay_tau_by_z20_by_z10*v2_1
    z2_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*v2_1_by_z10 + delay_tau_by_v10_by_z10*v2_1
    t141 = chi*z2_1_by_z10
    v1_1_on_boundary_by_z20_by_z10 = delay_tau_by_z20*t141 - delay_tau_by_z20*z1_1_by_z10 + delay_tau_by_z20_by_z10*t39
    v1_1_on_boundary_by_v10_by_z10 = delay_tau_by_v10*t141 - delay_tau_by_v10*z1_1_by_z10 + delay_tau_by_v10_by_z10*t39
    # d/dz20 of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v1_1_by_z20 + delay_tau_by_z20_by_z20*v1_1
    z1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v1_1_by_z20 + delay_tau_by_v10_by_z20*v1_1
    z2_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v2_1_by_z20 + delay_tau_by_z20_by_z20*v2_1
    z2_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*v2_1_by_z20 + delay_tau_by_v10_by_z20*v2_1
    t142 = chi*z2_1_by_z20
    v1_1_on_boundary_by_z20_by_z20 = delay_tau_by_z20*t142 - delay_tau_by_z20*z1_1_by_z20 + delay_tau_by_z20_by_z20*t39
    v1_1_on_boundary_by_v10_by_z20 = delay_tau_by_v10*t142 - delay_tau_by_v10*z1_1_by_z20 + delay_tau_by_v10_by_z20*t39
    # d/dv10 of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v1_1_by_v10 + delay_tau_by_z20_by_v10*v1_1
    z1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v1_1_by_v10 + delay_tau_by_v10_by_v10*v1_1
    z2_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*v2_1_by_v10 + delay_tau_by_z20_by_v10*v2_1
    z2_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*v2_1_by_v10 + delay_tau_by_v10_by_v10*v2_1
    t143 = chi*z2_1_by_v10
    v1_1_on_boundary_by_z20_by_v10 = delay_tau_by_z20*t143 - delay_tau_by_z20*z1_1_by_v10 + delay_tau_by_z20_by_v10*t39
    v1_1_on_boundary_by_v10_by_v10 = delay_tau_by_v10*t143 - delay_tau_by_v10*z1_1_by_v10 + delay_tau_by_v10_by_v10*t39
    # d/dtau of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_tau = carried_z1_1_by_z20_by_tau + delay_tau_by_z20*v1_1_by_tau + delay_tau_by_z20_by_tau*v1_1
    z1_1_on_boundary_by_v10_by_tau = carried_z1_1_by_v10_by_tau + delay_tau_by_v10*v1_1_by_tau + delay_tau_by_v10_by_tau*v1_1
    z2_1_on_boundary_by_z20_by_tau = carried_z2_1_by_z20_by_tau + delay_tau_by_z20*v2_1_by_tau + delay_tau_by_z20_by_tau*v2_1
    z2_1_on_boundary_by_v10_by_tau = carried_z2_1_by_v10_by_tau + delay_tau_by_v10*v2_1_by_tau + delay_tau_by_v10_by_tau*v2_1
    t144 = chi*z2_1_by_tau
    v1_1_on_boundary_by_z20_by_tau = carried_v1_1_by_z20_by_tau + delay_tau_by_z20*t144 - delay_tau_by_z20*z1_1_by_tau + delay_tau_by_z20_by_tau*t39
    v1_1_on_boundary_by_v10_by_tau = carried_v1_1_by_v10_by_tau + delay_tau_by_v10*t144 - delay_tau_by_v10*z1_1_by_tau + delay_tau_by_v10_by_tau*t39
    # d/dchi of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_chi = carried_z1_1_by_z20_by_chi + delay_tau_by_z20*v1_1_by_chi + delay_tau_by_z20_by_chi*v1_1
    z1_1_on_boundary_by_v10_by_chi = carried_z1_1_by_v10_by_chi + delay_tau_by_v10*v1_1_by_chi + delay_tau_by_v10_by_chi*v1_1
    z2_1_on_boundary_by_z20_by_chi = carried_z2_1_by_z20_by_chi + delay_tau_by_z20*v2_1_by_chi + delay_tau_by_z20_by_chi*v2_1
    z2_1_on_boundary_by_v10_by_chi = carried_z2_1_by_v10_by_chi + delay_tau_by_v10*v2_1_by_chi + delay_tau_by_v10_by_chi*v2_1
    t145 = chi*z2_1_by_chi
    v1_1_on_boundary_by_z20_by_chi = carried_v1_1_by_z20_by_chi + delay_tau_by_z20*t145 - delay_tau_by_z20*z1_1_by_chi + delay_tau_by_z20*z2_1 + delay_tau_by_z20_by_chi*t39
    v1_1_on_boundary_by_v10_by_chi = carried_v1_1_by_v10_by_chi + delay_tau_by_v10*t145 - delay_tau_by_v10*z1_1_by_chi + delay_tau_by_v10*z2_1 + delay_tau_by_v10_by_chi*t39
    # d/deta of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_eta = carried_z1_1_by_z20_by_eta + delay_tau_by_z20*v1_1_by_eta + delay_tau_by_z20_by_eta*v1_1
    z1_1_on_boundary_by_v10_by_eta = carried_z1_1_by_v10_by_eta + delay_tau_by_v10*v1_1_by_eta + delay_tau_by_v10_by_eta*v1_1
    z2_1_on_boundary_by_z20_by_eta = carried_z2_1_by_z20_by_eta + delay_tau_by_z20*v2_1_by_eta + delay_tau_by_z20_by_eta*v2_1
    z2_1_on_boundary_by_v10_by_eta = carried_z2_1_by_v10_by_eta + delay_tau_by_v10*v2_1_by_eta + delay_tau_by_v10_by_eta*v2_1
    t146 = chi*z2_1_by_eta
    v1_1_on_boundary_by_z20_by_eta = carried_v1_1_by_z20_by_eta + delay_tau_by_z20*t146 - delay_tau_by_z20*z1_1_by_eta + delay_tau_by_z20_by_eta*t39
    v1_1_on_boundary_by_v10_by_eta = carried_v1_1_by_v10_by_eta + delay_tau_by_v10*t146 - delay_tau_by_v10*z1_1_by_eta + delay_tau_by_v10_by_eta*t39
    # d/dV of: perturbation on the boundary after tau
    z1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v1_1_by_V + delay_tau_by_z20_by_V*v1_1
    z1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v1_1_by_V + delay_tau_by_v10_by_V*v1_1
    z2_1_on_boundary_by_z20_by_V = delay_tau_by_z20*v2_1_by_V + delay_tau_by_z20_by_V*v2_1
    z2_1_on_boundary_by_v10_by_V = delay_tau_by_v10*v2_1_by_V + delay_tau_by_v10_by_V*v2_1
    t147 = chi*z2_1_by_V
    v1_1_on_boundary_by_z20_by_V = delay_tau_by_z20*t147 - delay_tau_by_z20*z1_1_by_V + delay_tau_by_z20_by_V*t39
    v1_1_on_boundary_by_v10_by_V = delay_tau_by_v10*t147 - delay_tau_by_v10*z1_1_by_V + delay_tau_by_v10_by_V*t39
    # d/dz10 of: Phi along tau1
    carried_z1_2_by_z20_by_z10 = cos_tau1*z1_1_on_boundary_by_z20_by_z10 + sin_tau1*v1_1_on_boundary_by_z20_by_z10 + t34*z2_1_on_boundary_by_z20_by_z10
    carried_z1_2_by_v10_by_z10 = cos_tau1*z1_1_on_boundary_by_v10_by_z10 + sin_tau1*v1_1_on_boundary_by_v10_by_z10 + t34*z2_1_on_boundary_by_v10_by_z10
    carried_v1_2_by_v10_by_z10 = cos_tau1*v1_1_on_boundary_by_v10_by_z10 - sin_tau1*z1_1_on_boundary_by_v10_by_z10 + t35*z2_1_on_boundary_by_v10_by_z10
    # d/dz20 of: Phi along tau1
    carried_z1_2_by_z20_by_z20 = cos_tau1*z1_1_on_boundary_by_z20_by_z20 + sin_tau1*v1_1_on_boundary_by_z20_by_z20 + t34*z2_1_on_boundary_by_z20_by_z20
    carried_z1_2_by_v10_by_z20 = cos_tau1*z1_1_on_boundary_by_v10_by_z20 + sin_tau1*v1_1_on_boundary_by_v10_by_z20 + t34*z2_1_on_boundary_by_v10_by_z20
    carried_v1_2_by_v10_by_z20 = cos_tau1*v1_1_on_boundary_by_v10_by_z20 - sin_tau1*z1_1_on_boundary_by_v10_by_z20 + t35*z2_1_on_boundary_by_v10_by_z20
    # d/dv10 of: Phi along tau1
    carried_z1_2_by_z20_by_v10 = cos_tau1*z1_1_on_boundary_by_z20_by_v10 + sin_tau1*v1_1_on_boundary_by_z20_by_v10 + t34*z2_1_on_boundary_by_z20_by_v10
    carried_z1_2_by_v10_by_v10 = cos_tau1*z1_1_on_boundary_by_v10_by_v10 + sin_tau1*v1_1_on_boundary_by_v10_by_v10 + t34*z2_1_on_boundary_by_v10_by_v10
    carried_v1_2_by_v10_by_v10 = cos_tau1*v1_1_on_boundary_by_v10_by_v10 - sin_tau1*z1_1_on_boundary_by_v10_by_v10 + t35*z2_1_on_boundary_by_v10_by_v10
    # d/dtau of: Phi along tau1
    carried_z1_2_by_z20_by_tau = cos_tau1*z1_1_on_boundary_by_z20_by_tau + sin_tau1*v1_1_on_boundary_by_z20_by_tau + t34*z2_1_on_boundary_by_z20_by_tau
    carried_z1_2_by_v10_by_tau = cos_tau1*z1_1_on_boundary_by_v10_by_tau + sin_tau1*v1_1_on_boundary_by_v10_by_tau + t34*z2_1_on_boundary_by_v10_by_tau
    carried_v1_2_by_v10_by_tau = cos_tau1*v1_1_on_boundary_by_v10_by_tau - sin_tau1*z1_1_on_boundary_by_v10_by_tau + t35*z2_1_on_boundary_by_v10_by_tau
    # d/dtau1 of: Phi along tau1
    carried_z1_2_by_z20_by_tau1 = cos_tau1_by_tau1*(-t42 + z1_1_on_boundary_by_z20) + sin_tau1_by_tau1*v1_1_on_boundary_by_z20
    t148 = t44 - z1_1_on_boundary_by_v10
    carried_z1_2_by_v10_by_tau1 = -cos_tau1_by_tau1*t148 + sin_tau1_by_tau1*v1_1_on_boundary_by_v10
    carried_v1_2_by_v10_by_tau1 = cos_tau1_by_tau1*v1_1_on_boundary_by_v10 + sin_tau1_by_tau1*t148
    # d/dchi of: Phi along tau1
    carried_z1_2_by_z20_by_chi = cos_tau1*z1_1_on_boundary_by_z20_by_chi + sin_tau1*v1_1_on_boundary_by_z20_by_chi + t102*z2_1_on_boundary_by_z20 + t34*z2_1_on_boundary_by_z20_by_chi
    carried_z1_2_by_v10_by_chi = cos_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*v1_1_on_boundary_by_v10_by_chi + t102*z2_1_on_boundary_by_v10 + t34*z2_1_on_boundary_by_v10_by_chi
    carried_v1_2_by_v10_by_chi = cos_tau1*v1_1_on_boundary_by_v10_by_chi - sin_tau1*z1_1_on_boundary_by_v10_by_chi + sin_tau1*z2_1_on_boundary_by_v10 + t35*z2_1_on_boundary_by_v10_by_chi
    # d/deta of: Phi along tau1
    carried_z1_2_by_z20_by_eta = cos_tau1*z1_1_on_boundary_by_z20_by_eta + sin_tau1*v1_1_on_boundary_by_z20_by_eta + t34*z2_1_on_boundary_by_z20_by_eta
    carried_z1_2_by_v10_by_eta = cos_tau1*z1_1_on_boundary_by_v10_by_eta + sin_tau1*v1_1_on_boundary_by_v10_by_eta + t34*z2_1_on_boundary_by_v10_by_eta
    carried_v1_2_by_v10_by_eta = cos_tau1*v1_1_on_boundary_by_v10_by_eta - sin_tau1*z1_1_on_boundary_by_v10_by_eta + t35*z2_1_on_boundary_by_v10_by_eta
    # d/dV of: Phi along tau1
    carried_z1_2_by_z20_by_V = cos_tau1*z1_1_on_boundary_by_z20_by_V + sin_tau1*v1_1_on_boundary_by_z20_by_V + t34*z2_1_on_boundary_by_z20_by_V
    carried_z1_2_by_v10_by_V = cos_tau1*z1_1_on_boundary_by_v10_by_V + sin_tau1*v1_1_on_boundary_by_v10_by_V + t34*z2_1_on_boundary_by_v10_by_V
    carried_v1_2_by_v10_by_V = cos_tau1*v1_1_on_boundary_by_v10_by_V - sin_tau1*z1_1_on_boundary_by_v10_by_V + t35*z2_1_on_boundary_by_v10_by_V
    # d/dz10 of: rate of the exit boundary after tau1
    rate_2_by_z10 = -chi*v1_2_by_z10
    # d/dz20 of: rate of the exit boundary after tau1
    rate_2_by_z20 = -chi*v1_2_by_z20
    # d/dv10 of: rate of the exit boundary after tau1
    rate_2_by_v10 = -chi*v1_2_by_v10
    # d/dtau of: rate of the exit boundary after tau1
    rate_2_by_tau = -chi*v1_2_by_tau
    # d/dtau1 of: rate of the exit boundary after tau1
    rate_2_by_tau1 = -chi*v1_2_by_tau1
    # d/dchi of: rate of the exit boundary after tau1
    rate_2_by_chi = V - chi*v1_2_by_chi - v1_2
    # d/deta of: rate of the exit boundary after tau1
    rate_2_by_eta = -chi*v1_2_by_eta
    # d/dV of: rate of the exit boundary after tau1
    rate_2_by_V = -chi*v1_2_by_V + chi
    # d/dz10 of: derivatives of the time to the boundary after tau1
    t149 = 1/rate_2**2
    t150 = rate_2_by_z10*t149
    t151 = chi*t41
    delay_tau1_by_z20_by_z10 = carried_z1_2_by_z20_by_z10*chi*t41 - t150*t43 - t151*z2_1_on_boundary_by_z20_by_z10
    delay_tau1_by_v10_by_z10 = carried_z1_2_by_v10_by_z10*chi*t41 - t150*t45 - t151*z2_1_on_boundary_by_v10_by_z10
    # d/dz20 of: derivatives of the time to the boundary after tau1
    t152 = rate_2_by_z20*t149
    delay_tau1_by_z20_by_z20 = carried_z1_2_by_z20_by_z20*chi*t41 - t151*z2_1_on_boundary_by_z20_by_z20 - t152*t43
    delay_tau1_by_v10_by_z20 = carried_z1_2_by_v10_by_z20*chi*t41 - t151*z2_1_on_boundary_by_v10_by_z20 - t152*t45
    # d/dv10 of: derivatives of the time to the boundary after tau1
    t153 = rate_2_by_v10*t149
    delay_tau1_by_z20_by_v10 = carried_z1_2_by_z20_by_v10*chi*t41 - t151*z2_1_on_boundary_by_z20_by_v10 - t153*t43
    delay_tau1_by_v10_by_v10 = carried_z1_2_by_v10_by_v10*chi*t41 - t151*z2_1_on_boundary_by_v10_by_v10 - t153*t45
    # d/dtau of: derivatives of the time to the boundary after tau1
    t154 = rate_2_by_tau*t149
    delay_tau1_by_z20_by_tau = carried_z1_2_by_z20_by_tau*chi*t41 - t151*z2_1_on_boundary_by_z20_by_tau - t154*t43
    delay_tau1_by_v10_by_tau = carried_z1_2_by_v10_by_tau*chi*t41 - t151*z2_1_on_boundary_by_v10_by_tau - t154*t45
    # d/dtau1 of: derivatives of the time to the boundary after tau1
    t155 = rate_2_by_tau1*t149
    delay_tau1_by_z20_by_tau1 = carried_z1_2_by_z20_by_tau1*t151 - t155*t43
    delay_tau1_by_v10_by_tau1 = carried_z1_2_by_v10_by_tau1*t151 - t155*t45
    # d/dchi of: derivatives of the time to the boundary after tau1
    t156 = rate_2_by_chi*t149
    delay_tau1_by_z20_by_chi = carried_z1_2_by_z20_by_chi*t151 - t151*z2_1_on_boundary_by_z20_by_chi - t156*t43 + t41*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20)
    delay_tau1_by_v10_by_chi = carried_z1_2_by_v10_by_chi*t151 - t151*z2_1_on_boundary_by_v10_by_chi - t156*t45 + t41*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10)
    # d/deta of: derivatives of the time to the boundary after tau1
    t157 = rate_2_by_eta*t149
    delay_tau1_by_z20_by_eta = carried_z1_2_by_z20_by_eta*chi*t41 - t151*z2_1_on_boundary_by_z20_by_eta - t157*t43
    delay_tau1_by_v10_by_eta = carried_z1_2_by_v10_by_eta*chi*t41 - t151*z2_1_on_boundary_by_v10_by_eta - t157*t45
    # d/dV of: derivatives of the time to the boundary after tau1
    t158 = rate_2_by_V*t149
    delay_tau1_by_z20_by_V = carried_z1_2_by_z20_by_V*chi*t41 - t151*z2_1_on_boundary_by_z20_by_V - t158*t43
    delay_tau1_by_v10_by_V = carried_z1_2_by_v10_by_V*chi*t41 - t151*z2_1_on_boundary_by_v10_by_V - t158*t45
    # d/dz10 of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_z10 = V*delay_tau1_by_z20_by_z10 + z2_1_on_boundary_by_z20_by_z10
    t159 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_v10_by_z10 = carried_v1_2_by_v10_by_z10 + delay_tau1_by_v10*t141 - delay_tau1_by_v10*z1_2_by_z10 + delay_tau1_by_v10_by_z10*t159
    # d/dz20 of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_z20 = V*delay_tau1_by_z20_by_z20 + z2_1_on_boundary_by_z20_by_z20
    v1_2_on_boundary_by_v10_by_z20 = carried_v1_2_by_v10_by_z20 + delay_tau1_by_v10*t142 - delay_tau1_by_v10*z1_2_by_z20 + delay_tau1_by_v10_by_z20*t159
    # d/dv10 of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_v10 = V*delay_tau1_by_z20_by_v10 + z2_1_on_boundary_by_z20_by_v10
    v1_2_on_boundary_by_v10_by_v10 = carried_v1_2_by_v10_by_v10 + delay_tau1_by_v10*t143 - delay_tau1_by_v10*z1_2_by_v10 + delay_tau1_by_v10_by_v10*t159
    # d/dtau of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_tau = V*delay_tau1_by_z20_by_tau + z2_1_on_boundary_by_z20_by_tau
    v1_2_on_boundary_by_v10_by_tau = carried_v1_2_by_v10_by_tau + delay_tau1_by_v10*t144 - delay_tau1_by_v10*z1_2_by_tau + delay_tau1_by_v10_by_tau*t159
    # d/dtau1 of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_tau1 = V*delay_tau1_by_z20_by_tau1
    v1_2_on_boundary_by_v10_by_tau1 = carried_v1_2_by_v10_by_tau1 + delay_tau1_by_v10*t40 - delay_tau1_by_v10*z1_2_by_tau1 + delay_tau1_by_v10_by_tau1*t159
    # d/dchi of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_chi = V*delay_tau1_by_z20_by_chi + z2_1_on_boundary_by_z20_by_chi
    v1_2_on_boundary_by_v10_by_chi = carried_v1_2_by_v10_by_chi + delay_tau1_by_v10*t145 - delay_tau1_by_v10*z1_2_by_chi + delay_tau1_by_v10*z2_2 + delay_tau1_by_v10_by_chi*t159
    # d/deta of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_eta = V*delay_tau1_by_z20_by_eta + z2_1_on_boundary_by_z20_by_eta
    v1_2_on_boundary_by_v10_by_eta = carried_v1_2_by_v10_by_eta + delay_tau1_by_v10*t146 - delay_tau1_by_v10*z1_2_by_eta + delay_tau1_by_v10_by_eta*t159
    # d/dV of: perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20_by_V = V*delay_tau1_by_z20_by_V + delay_tau1_by_z20 + z2_1_on_boundary_by_z20_by_V
    v1_2_on_boundary_by_v10_by_V = carried_v1_2_by_v10_by_V + chi*delay_tau1_by_v10*z2_2_by_V - delay_tau1_by_v10*z1_2_by_V + delay_tau1_by_v10_by_V*t159
    return [v1_2_on_boundary_by_v10_by_z10 + z2_2_on_boundary_by_z20_by_z10, v1_2_on_boundary_by_v10_by_z20 + z2_2_on_boundary_by_z20_by_z20, v1_2_on_boundary_by_v10_by_v10 + z2_2_on_boundary_by_z20_by_v10, v1_2_on_boundary_by_v10_by_tau + z2_2_on_boundary_by_z20_by_tau, v1_2_on_boundary_by_v10_by_tau1 + z2_2_on_boundary_by_z20_by_tau1, v1_2_on_boundary_by_v10_by_chi + z2_2_on_boundary_by_z20_by_chi, v1_2_on_boundary_by_v10_by_eta + z2_2_on_boundary_by_z20_by_eta, v1_2_on_boundary_by_v10_by_V + z2_2_on_boundary_by_z20_by_V, 0]


def symmetric_states(parameters, spectrum, unknowns, lib):
    """State at the start and behind each transition, row by row.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives states (3, 4).
    Operations: 90. Intermediate terms: 23.
    """
    [chi, _, V, _] = parameters
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
    return [[z10, z20, v10, V], [z1_1, z2_1, v1_1, V], [z1_2, z2_2, v1_2, V]]


def symmetric_boundary_functions(parameters, spectrum, unknowns, lib):
    """Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (5): z10, z20, v10, tau, tau1.
    Gives coefficients (24).
    Gives frequencies (3).
    Operations: 118. Intermediate terms: 29.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z10, z20, v10, tau, _] = unknowns
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
    # outputs
    t10 = V*p2
    t11 = omega1*z10
    t12 = p2*z20
    t13 = p3*v10
    t14 = V*chi
    t15 = -t14 + v1_1
    t16 = chi*z2_1
    t17 = t16 - z1_1
    t18 = chi**2
    t19 = t18*z2_1
    t20 = V*t18 - t14
    t21 = -chi*t17
    t22 = chi*t15
    return (
        [-V, 0, p1*v10 + t10, -t10 + t4*v10, -omega1*t12 - p1*t11, omega2*t12 - omega2*t4*z10, -V, 0, V*t4 + t13, V*p1 - t13, -omega1*t4*z20 - p3*t11, -omega2*p1*z20 + omega2*p3*z10, -V + t14, 0, t15, t17, -e2 + t16 - t19, -t20, -t21, -t22, -e2 - t16 + t19, t20, t21, t22],
        [omega1, omega2, 1],
    )


def symmetric_flow_slip_slip(parameters, spectrum, time, state, lib):
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


def symmetric_flow_slip_stick(parameters, spectrum, time, state, lib):
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
    # outputs
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def symmetric_reduced(parameters, spectrum, reduced, lib):
    """Reduced equations and their derivatives by the reduced unknowns.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives residual (2).
    Gives jacobian (2, 2).
    Operations: 188. Intermediate terms: 58.
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
    # functions of half_tau1 in slip-stick
    cos_half_tau1 = lib.cos(half_tau1)
    sin_half_tau1 = lib.sin(half_tau1)
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
    # outputs
    t34 = cos_omega1_half_tau*t13
    t35 = p3*v10
    t36 = t10*t35
    t37 = p3*t19
    t38 = cos_half_tau1*t13
    t39 = V*chi
    t40 = -p3*t13 + t16 + t37
    t41 = p3*sin_omega1_half_tau*t10 - p3*t9
    return (
        [V*t12 - cos_omega1_half_tau*t37 + p1*t14 - p1*t22 - p3*t14 + p3*t20 + p3*t34 + sin_omega1_half_tau*t36 - t17 + t22 + t34 - t35*t9, chi*t38 + cos_half_tau1*t19 - sin_half_tau1*t39 + sin_half_tau1*v10 - t38],
        [[cos_omega1_half_tau_by_tau*(t13 - t40) + cos_omega2_half_tau_by_tau*t40 + sin_omega1_half_tau_by_tau*(-p1*t21 + t21 + t36) + sin_omega2_half_tau_by_tau*(V*t26 - t35*t8) + t41*v10_by_tau, p1*t31 - p3*t31 + p3*t32 + t32 - t33 + t41*v10_by_tau1], [sin_half_tau1*v10_by_tau, -cos_half_tau1*t30 + cos_half_tau1*t39/2 + cos_half_tau1_by_tau1*(chi*t13 + t29) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t39 + v10)]],
    )


def symmetric_expand(parameters, spectrum, reduced, lib):
    """All unknowns from the reduced ones, and how singular the linear equations for them are: 0 if they are.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives unknowns (5).
    Gives determinants (1).
    Operations: 71. Intermediate terms: 22.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, _, _] = spectrum
    [tau, tau1] = reduced
    # half of tau
    half_tau = tau/2
    # functions of half_tau in slip-slip
    t0 = half_tau*omega1
    cos_omega1_half_tau = lib.cos(t0)
    sin_omega1_half_tau = lib.sin(t0)
    t1 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t1)
    sin_omega2_half_tau = lib.sin(t1)
    # half of tau1
    half_tau1 = tau1/2
    # coefficients of the linear equations
    t2 = 1/omega2
    t3 = sin_omega2_half_tau*t2
    t4 = sin_omega1_half_tau/omega1
    coefficient11 = -p1*t3 + p1*t4 + t3
    # right-hand sides of the linear equations
    t5 = V*half_tau1
    t6 = 1/chi
    t7 = e2*t6
    right1 = V*cos_omega2_half_tau*half_tau1*p1 + V*cos_omega2_half_tau*half_tau1*p2 + V*p2*sin_omega2_half_tau*t2 - V*p2*t4 + cos_omega1_half_tau*e2*p1*t6 - cos_omega1_half_tau*p1*t5 - cos_omega1_half_tau*p2*t5 + cos_omega2_half_tau*e2*t6 - cos_omega2_half_tau*p1*t7 - cos_omega2_half_tau*t5
    # determinant of the linear equations
    determinant = coefficient11
    # v10 by Cramer's rule
    v10 = right1/determinant
    # z10: linear in: second-breaks-forward ends slip-stick
    z10 = t5 - t7
    # z20: linear in: z2 vanishes halfway through slip-stick
    z20 = t5
    # outputs
    t8 = half_tau**2
    t9 = 2*t8
    return (
        [z10, z20, v10, tau, tau1],
        [determinant/lib.sqrt(p1**2*t9/(omega1**2*t8 + 1) + t9*(p1 - 1)**2/(omega2**2*t8 + 1))],
    )


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
    # derivatives of the time to the boundary after ta
    t26 = 1/rate_1
    delay_ta_by_z10 = -t26
    delay_ta_by_z20 = chi*t26
    # perturbation on the boundary after ta
    t27 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t27 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t27
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t25
    # derivatives of the time to the boundary after tau
    t29 = 1/rate_2
    delay_tau_by_z10 = t29*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t29*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t30 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t30
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t30
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
    # derivatives of the time to the boundary after tau1
    t32 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t32
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t32
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t33 = chi*eta
    t34 = -eta*t31 + t33*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t34
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t34
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t22*z1_3_on_boundary_by_z10 + t23*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t22*z1_3_on_boundary_by_z20 + t23*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t24*z1_3_on_boundary_by_z10 - t24*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t24*z1_3_on_boundary_by_z20 - t24*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t33*z1_4 - t33*z2_4
    # derivatives of the time to the boundary after tau2
    t35 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t35
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t35
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20
    z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    return [[z1_4_on_boundary_by_z10, z1_4_on_boundary_by_z20], [z2_4_on_boundary_by_z10, z2_4_on_boundary_by_z20]]


def global_stick_saltations(parameters, spectrum, unknowns, lib):
    """Saltation matrices of the transitions, one below the other.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives saltations (16, 4).
    Operations: 167. Intermediate terms: 56.
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
    # vector fields at transition 1
    behind_v1_1 = chi*z2_1 - z1_1
    # vector fields at transition 2
    t19 = chi*z2_2
    before_v1_2 = t19 - z1_2
    behind_v1_2 = before_v1_2
    t21 = chi*eta
    behind_v2_2 = -eta*t19 + t21*z1_2
    # vector fields at transition 3
    t22 = chi*z2_3
    before_v1_3 = t22 - z1_3
    before_v2_3 = -eta*t22 + t21*z1_3
    behind_v2_3 = before_v2_3
    # vector fields at transition 4
    before_v2_4 = t21*z1_4 - t21*z2_4
    # outputs
    t24 = V*chi
    t25 = behind_v1_1/(V - t24)
    t26 = chi/(-chi*v1_2 + t24)
    t27 = t26*(-before_v1_2 + behind_v1_2)
    t28 = behind_v2_2*t26
    t29 = 1/before_v1_3
    return [[1, 0, 0, 0], [0, 1, 0, 0], [t25, -chi*t25, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t27, t27, 1, 0], [-t28, t28, 0, 1], [1, 0, t29*(V - v1_3), 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t29*(-before_v2_3 + behind_v2_3), 1], [1, 0, 0, 0], [0, 1, 0, (V - v2_4)/before_v2_4], [0, 0, 1, 0], [0, 0, 0, 0]]


def global_stick_monodromy(parameters, spectrum, unknowns, lib):
    """Monodromy matrix: the product of flows and saltation matrices over a period.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives monodromy (4, 4).
    Operations: 378. Intermediate terms: 130.
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
    # vector fields at transition 1
    behind_v1_1 = chi*z2_1 - z1_1
    # vector fields at transition 2
    t31 = chi*z2_2
    before_v1_2 = t31 - z1_2
    behind_v1_2 = before_v1_2
    t33 = chi*eta
    behind_v2_2 = -eta*t31 + t33*z1_2
    # vector fields at transition 3
    t34 = chi*z2_3
    before_v1_3 = t34 - z1_3
    before_v2_3 = -eta*t34 + t33*z1_3
    behind_v2_3 = before_v2_3
    # vector fields at transition 4
    before_v2_4 = t33*z1_4 - t33*z2_4
    # saltation of phase 1
    t36 = V*chi
    saltation_1_20 = behind_v1_1/(V - t36)
    t38 = chi*saltation_1_20
    saltation_1_21 = -t38
    saltation_1_22 = saltation_1_20*ta + 1
    saltation_1_23 = -t38*ta
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    t39 = chi - t1
    phi_2_01 = saltation_1_21*sin_tau + t39
    phi_2_02 = cos_tau*ta + saltation_1_22*sin_tau
    phi_2_03 = chi*tau + saltation_1_23*sin_tau + t2*ta - t3
    phi_2_13 = ta + tau
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t3
    phi_2_22 = cos_tau*saltation_1_22 - sin_tau*ta
    phi_2_23 = cos_tau*saltation_1_23 + t3*ta + t39
    # saltation of phase 2
    t40 = 1/(-chi*v1_2 + t36)
    t41 = chi*t40
    t42 = t41*(-before_v1_2 + behind_v1_2)
    saltation_2_20 = -phi_2_00*t42 + phi_2_20
    saltation_2_21 = -phi_2_01*t42 + phi_2_21 + t42
    saltation_2_22 = -phi_2_02*t42 + phi_2_22
    saltation_2_23 = -phi_2_03*t42 + phi_2_13*t42 + phi_2_23
    t43 = behind_v2_2*t41
    saltation_2_30 = -phi_2_00*t43
    saltation_2_31 = behind_v2_2*chi*t40 - phi_2_01*t43
    saltation_2_32 = -phi_2_02*t43
    saltation_2_33 = -phi_2_03*t43 + phi_2_13*t43 + 1
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
    t44 = 1/before_v1_3
    t45 = t44*(V - v1_3)
    saltation_3_00 = phi_3_00 + phi_3_20*t45
    saltation_3_01 = phi_3_01 + phi_3_21*t45
    saltation_3_02 = phi_3_02 + phi_3_22*t45
    saltation_3_03 = phi_3_03 + phi_3_23*t45
    t46 = t44*(-before_v2_3 + behind_v2_3)
    saltation_3_30 = phi_3_20*t46 + phi_3_30
    saltation_3_31 = phi_3_21*t46 + phi_3_31
    saltation_3_32 = phi_3_22*t46 + phi_3_32
    saltation_3_33 = phi_3_23*t46 + phi_3_33
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
    t47 = (V - v2_4)/before_v2_4
    saltation_4_10 = phi_4_10 + phi_4_30*t47
    saltation_4_11 = phi_4_11 + phi_4_31*t47
    saltation_4_12 = phi_4_12 + phi_4_32*t47
    saltation_4_13 = phi_4_13 + phi_4_33*t47
    return [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]


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


def global_stick_period_map(parameters, spectrum, unknowns, lib):
    """Compatibility and switching conditions, the start, and the map [N, c] of a turn, all from the unknowns but the start.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, ta, tau, tau1, tau2.
    Gives residual (4).
    Gives start (2).
    Gives map (4, 5).
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
    # stick-stick for ta, until first-breaks-forward
    t27 = V*ta
    z1_1 = t27 + z1_0
    z2_1 = t27 + z2_0
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z1_1 + z1_2_by_z20*z2_1
    z2_2 = V*tau + z2_1
    return (
        [V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0, V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0, -chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2],
        [z1_0, z2_0],
        [[z1_4_by_z10, z1_4_by_z20, z1_4_by_v10, z1_4_by_v20, 0], [z2_4_by_z10, z2_4_by_z20, z2_4_by_v10, z2_4_by_v20, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_v10, v1_3_by_v20, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_v10, v2_4_by_v20, 0]],
    )


def solution_ii_residual(parameters, spectrum, unknowns, lib):
    """Switching and periodicity equations.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives residual (6).
    Operations: 139. Intermediate terms: 36.
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
    t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t8*z1_2 + t9*z2_2 + v1_2*(p1*t5 + t6*t7)
    t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t11 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t10*z1_2 + t11*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7)
    t12 = omega2*sin_omega2_tau1
    t13 = omega1*sin_omega1_tau1
    v1_3 = V*t9 + t8*v1_2 + z1_2*(-p1*t13 - t12*t6) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t13)
    v2_3 = V*t11 + t10*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-p1*t12 - t13*t6)
    # functions of tau2 in stick-slip
    t14 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t14)
    sin_omega3_tau2 = lib.sin(t14)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t15 = 1 - cos_omega3_tau2
    t16 = sin_omega3_tau2/omega3
    z2_4 = V*(-t16 + tau2) + cos_omega3_tau2*z2_3 + t15*z1_3 + t16*v2_3
    t17 = omega3*sin_omega3_tau2
    v2_4 = V*t15 + cos_omega3_tau2*v2_3 + t17*z1_3 - t17*z2_3
    return [-chi*z20 - e1 + z10, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]


def solution_ii_jacobian(parameters, spectrum, unknowns, lib):
    """Derivatives of the equations by the unknowns.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives jacobian (6, 6).
    Operations: 317. Intermediate terms: 94.
    """
    [chi, _, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    t15 = 1/omega2
    t16 = sin_omega2_tau1*t15
    t13 = sin_omega1_tau1*t12
    t14 = 1 - p1
    t17 = p1*t13 + t14*t16
    t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14
    t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t12 - p2*t16) + t17*v1_2 + t18*z1_2 + t19*z2_2
    t20 = p3*sin_omega1_tau1*t12 - p3*t16
    t21 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t22 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t16 + t13*t14) + t20*v1_2 + t21*z1_2 + t22*z2_2
    t23 = omega1*sin_omega1_tau1
    t24 = omega2*p3*sin_omega2_tau1 - p3*t23
    t25 = omega2*sin_omega2_tau1
    t26 = p1*t25 + t14*t23
    t28 = V*t22
    v2_3 = t21*v1_2 + t24*z1_2 - t26*z2_2 + t28
    # functions of tau2 in stick-slip
    t29 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t29)
    sin_omega3_tau2 = lib.sin(t29)
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dz10 of: slip-stick for tau, until second-breaks-forward
    v1_2_by_z10 = -sin_tau
    # d/dz20 of: slip-stick for tau, until second-breaks-forward
    z1_2_by_z20 = t4
    v1_2_by_z20 = t5
    # d/dtau of: slip-stick for tau, until second-breaks-forward
    t32 = chi*z20 - z10
    t33 = V*chi
    t34 = V - t33
    z1_2_by_tau = -cos_tau_by_tau*t32 + sin_tau_by_tau*t34 + t33
    v1_2_by_tau = cos_tau_by_tau*t34 + sin_tau_by_tau*t32
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dz10 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10
    z2_3_by_z10 = cos_tau*t21 + t20*v1_2_by_z10
    t35 = -p1*t23 - t14*t25
    v1_3_by_z10 = cos_tau*t35 + t18*v1_2_by_z10
    v2_3_by_z10 = cos_tau*t24 + t21*v1_2_by_z10
    # d/dz20 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19
    z2_3_by_z20 = t20*v1_2_by_z20 + t21*z1_2_by_z20 + t22
    t36 = p2*t23
    v1_3_by_z20 = p2*t25 + t18*v1_2_by_z20 + t35*z1_2_by_z20 - t36
    v2_3_by_z20 = t21*v1_2_by_z20 + t24*z1_2_by_z20 - t26
    # d/dtau of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_tau = V*t19 + t17*v1_2_by_tau + t18*z1_2_by_tau
    z2_3_by_tau = t20*v1_2_by_tau + t21*z1_2_by_tau + t28
    v1_3_by_tau = V*(omega2*p2*sin_omega2_tau1 - t36) + t18*v1_2_by_tau + t35*z1_2_by_tau
    v2_3_by_tau = -V*t26 + t21*v1_2_by_tau + t24*z1_2_by_tau
    # d/dtau1 of: slip-slip for tau1, until first-reaches-belt
    t37 = p1*z1_2
    t38 = p2*z2_2
    t39 = p1*v1_2
    t40 = V*p2
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t37 + t38) + cos_omega2_tau1_by_tau1*(t14*z1_2 - t38) + sin_omega1_tau1_by_tau1*(t12*t39 + t12*t40) + sin_omega2_tau1_by_tau1*(t14*t15*v1_2 - t15*t40)
    t41 = p3*z1_2
    t42 = t14*z2_2
    t43 = p1*z2_2
    t44 = p3*v1_2
    t45 = V*t14
    t46 = V*p1
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t41 + t42) + cos_omega2_tau1_by_tau1*(-t41 + t43) + sin_omega1_tau1_by_tau1*(t12*t44 + t12*t45) + sin_omega2_tau1_by_tau1*(-t15*t44 + t15*t46)
    v1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t39 + t40) + cos_omega2_tau1_by_tau1*(t14*v1_2 - t40) + sin_omega1_tau1_by_tau1*(-omega1*t37 - omega1*t38) + sin_omega2_tau1_by_tau1*(-omega2*t14*z1_2 + omega2*t38)
    v2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t44 + t45) + cos_omega2_tau1_by_tau1*(-t44 + t46) + sin_omega1_tau1_by_tau1*(-omega1*t41 - omega1*t42) + sin_omega2_tau1_by_tau1*(omega2*p3*z1_2 - omega2*t43)
    # d/dtau2 of: functions of tau2 in stick-slip
    cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2
    sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3
    # d/dz10 of: stick-slip for tau2, until second-reaches-belt
    t47 = 1 - cos_omega3_tau2
    t48 = 1/omega3
    t49 = sin_omega3_tau2*t48
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t47*z1_3_by_z10 + t49*v2_3_by_z10
    t50 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t50*z1_3_by_z10 - t50*z2_3_by_z10
    # d/dz20 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t47*z1_3_by_z20 + t49*v2_3_by_z20
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t50*z1_3_by_z20 - t50*z2_3_by_z20
    # d/dtau of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t47*z1_3_by_tau + t49*v2_3_by_tau
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t50*z1_3_by_tau - t50*z2_3_by_tau
    # d/dtau1 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t47*z1_3_by_tau1 + t49*v2_3_by_tau1
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t50*z1_3_by_tau1 - t50*z2_3_by_tau1
    # d/dtau2 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*(-z1_3 + z2_3) + sin_omega3_tau2_by_tau2*(-V*t48 + t48*v2_3)
    v2_4_by_tau2 = cos_omega3_tau2_by_tau2*(-V + v2_3) + sin_omega3_tau2_by_tau2*(omega3*z1_3 - omega3*z2_3)
    return [[1, -chi, 0, 0, 0, -1], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_tau + t33, 0, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_tau, v1_3_by_tau1, 0, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2, 0], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_tau, z1_3_by_tau1, V, 0], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_tau, z2_4_by_tau1, z2_4_by_tau2, 0]]


def solution_ii_residual_and_jacobian(parameters, spectrum, unknowns, lib):
    """Equations and their derivatives by the unknowns, sharing all intermediate terms.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives residual (6).
    Gives jacobian (6, 6).
    Operations: 350. Intermediate terms: 102.
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
    t15 = 1/omega2
    t16 = sin_omega2_tau1*t15
    t13 = sin_omega1_tau1*t12
    t14 = 1 - p1
    t17 = p1*t13 + t14*t16
    t18 = cos_omega1_tau1*p1 + cos_omega2_tau1*t14
    t19 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t12 - p2*t16) + t17*v1_2 + t18*z1_2 + t19*z2_2
    t20 = p3*sin_omega1_tau1*t12 - p3*t16
    t21 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t22 = cos_omega1_tau1*t14 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t16 + t13*t14) + t20*v1_2 + t21*z1_2 + t22*z2_2
    t23 = omega2*sin_omega2_tau1
    t24 = omega1*sin_omega1_tau1
    t25 = -p1*t24 - t14*t23
    t26 = p2*t24
    t27 = omega2*p2*sin_omega2_tau1 - t26
    t28 = V*t19
    v1_3 = t18*v1_2 + t25*z1_2 + t27*z2_2 + t28
    t29 = omega2*p3*sin_omega2_tau1 - p3*t24
    t30 = p1*t23 + t14*t24
    t32 = V*t22
    v2_3 = t21*v1_2 + t29*z1_2 - t30*z2_2 + t32
    # functions of tau2 in stick-slip
    t33 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t33)
    sin_omega3_tau2 = lib.sin(t33)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t36 = 1 - cos_omega3_tau2
    t37 = 1/omega3
    t38 = sin_omega3_tau2*t37
    z2_4 = V*(-t38 + tau2) + cos_omega3_tau2*z2_3 + t36*z1_3 + t38*v2_3
    t39 = omega3*z1_3
    t40 = omega3*z2_3
    v2_4 = V*t36 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t39 - sin_omega3_tau2*t40
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dz10 of: slip-stick for tau, until second-breaks-forward
    v1_2_by_z10 = -sin_tau
    # d/dz20 of: slip-stick for tau, until second-breaks-forward
    z1_2_by_z20 = t4
    v1_2_by_z20 = t5
    # d/dtau of: slip-stick for tau, until second-breaks-forward
    t41 = chi*z20 - z10
    t42 = V*chi
    t43 = V - t42
    z1_2_by_tau = -cos_tau_by_tau*t41 + sin_tau_by_tau*t43 + t42
    v1_2_by_tau = cos_tau_by_tau*t43 + sin_tau_by_tau*t41
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dz10 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z10 = cos_tau*t18 + t17*v1_2_by_z10
    z2_3_by_z10 = cos_tau*t21 + t20*v1_2_by_z10
    v1_3_by_z10 = cos_tau*t25 + t18*v1_2_by_z10
    v2_3_by_z10 = cos_tau*t29 + t21*v1_2_by_z10
    # d/dz20 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z20 = t17*v1_2_by_z20 + t18*z1_2_by_z20 + t19
    z2_3_by_z20 = t20*v1_2_by_z20 + t21*z1_2_by_z20 + t22
    v1_3_by_z20 = p2*t23 + t18*v1_2_by_z20 + t25*z1_2_by_z20 - t26
    v2_3_by_z20 = t21*v1_2_by_z20 + t29*z1_2_by_z20 - t30
    # d/dtau of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t28
    z2_3_by_tau = t20*v1_2_by_tau + t21*z1_2_by_tau + t32
    v1_3_by_tau = V*t27 + t18*v1_2_by_tau + t25*z1_2_by_tau
    v2_3_by_tau = -V*t30 + t21*v1_2_by_tau + t29*z1_2_by_tau
    # d/dtau1 of: slip-slip for tau1, until first-reaches-belt
    t44 = p1*z1_2
    t45 = p2*z2_2
    t46 = p1*v1_2
    t47 = V*p2
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t44 + t45) + cos_omega2_tau1_by_tau1*(t14*z1_2 - t45) + sin_omega1_tau1_by_tau1*(t12*t46 + t12*t47) + sin_omega2_tau1_by_tau1*(t14*t15*v1_2 - t15*t47)
    t48 = p3*z1_2
    t49 = t14*z2_2
    t50 = p1*z2_2
    t51 = p3*v1_2
    t52 = V*t14
    t53 = V*p1
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t48 + t49) + cos_omega2_tau1_by_tau1*(-t48 + t50) + sin_omega1_tau1_by_tau1*(t12*t51 + t12*t52) + sin_omega2_tau1_by_tau1*(-t15*t51 + t15*t53)
    v1_3_by_tau1 = cos_omega1_tau1_by_tau1*(t46 + t47) + cos_omega2_tau1_by_tau1*(t14*v1_2 - t47) + sin_omega1_tau1_by_tau1*(-omega1*t44 - omega1*t45) + sin_omega2_tau1_by_tau1*(-omega2*t14*z1_2 + omega2*t45)
    v2_3_by_tau1 = cos_omega1_tau1_by_tau1*(t51 + t52) + cos_omega2_tau1_by_tau1*(-t51 + t53) + sin_omega1_tau1_by_tau1*(-omega1*t48 - omega1*t49) + sin_omega2_tau1_by_tau1*(omega2*p3*z1_2 - omega2*t50)
    # d/dtau2 of: functions of tau2 in stick-slip
    cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2
    sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3
    # d/dz10 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t36*z1_3_by_z10 + t38*v2_3_by_z10
    t54 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t54*z1_3_by_z10 - t54*z2_3_by_z10
    # d/dz20 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t36*z1_3_by_z20 + t38*v2_3_by_z20
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t54*z1_3_by_z20 - t54*z2_3_by_z20
    # d/dtau of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t36*z1_3_by_tau + t38*v2_3_by_tau
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t54*z1_3_by_tau - t54*z2_3_by_tau
    # d/dtau1 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t36*z1_3_by_tau1 + t38*v2_3_by_tau1
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t54*z1_3_by_tau1 - t54*z2_3_by_tau1
    # d/dtau2 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*(-z1_3 + z2_3) + sin_omega3_tau2_by_tau2*(-V*t37 + t37*v2_3)
    v2_4_by_tau2 = cos_omega3_tau2_by_tau2*(-V + v2_3) + sin_omega3_tau2_by_tau2*(t39 - t40)
    return (
        [-e1 - t41, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4],
        [[1, -chi, 0, 0, 0, -1], [-t3, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_tau + t42, 0, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_tau, v1_3_by_tau1, 0, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2, 0], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_tau, z1_3_by_tau1, V, 0], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_tau, z2_4_by_tau1, z2_4_by_tau2, 0]],
    )


def solution_ii_parameter_jacobian(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Total derivatives of the equations by the parameters, through the spectrum too.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives parameter_jacobian (6, 4).
    Operations: 498. Intermediate terms: 139.
    """
    [chi, _, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    [z10, z20, tau, tau1, tau2, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t0 = chi*cos_tau
    t1 = chi - t0
    t2 = chi*sin_tau
    z1_2 = V*sin_tau + V*(chi*tau - t2) + cos_tau*z10 + t1*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*t1 - sin_tau*z10 + t2*z20
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t6 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t6)
    sin_omega2_tau1 = lib.sin(t6)
    # slip-slip for tau1, until first-reaches-belt
    t9 = 1/omega1
    t10 = sin_omega1_tau1*t9
    t11 = 1 - p1
    t12 = 1/omega2
    t13 = sin_omega2_tau1*t12
    t14 = p1*t10 + t11*t13
    t15 = cos_omega1_tau1*p1 + cos_omega2_tau1*t11
    t16 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t17 = p2*t13
    z1_3 = V*(p2*sin_omega1_tau1*t9 - t17) + t14*v1_2 + t15*z1_2 + t16*z2_2
    t18 = p3*sin_omega1_tau1*t9 - p3*t13
    t19 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t20 = cos_omega1_tau1*t11 + cos_omega2_tau1*p1
    t21 = p1*t13 + t10*t11
    z2_3 = V*t21 + t18*v1_2 + t19*z1_2 + t20*z2_2
    t22 = omega1*sin_omega1_tau1
    t23 = omega2*p3*sin_omega2_tau1 - p3*t22
    t24 = omega2*sin_omega2_tau1
    t25 = -p1*t24 - t11*t22
    v2_3 = V*t20 + t19*v1_2 + t23*z1_2 + t25*z2_2
    # functions of tau2 in stick-slip
    t26 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t26)
    sin_omega3_tau2 = lib.sin(t26)
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t29 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t29*z20
    v1_2_by_chi = V*t29 + sin_tau*z20
    # d/dV of: slip-stick for tau, until second-breaks-forward
    t30 = chi*tau
    z1_2_by_V = sin_tau - t2 + t30
    v1_2_by_V = chi + cos_tau - t0
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
    t38 = t11*z1_2 - t36
    t39 = p1*v1_2
    t40 = sin_omega1_tau1/omega1**2
    t41 = V*p2
    t42 = -t39*t40 - t40*t41
    t43 = 1/omega2**2
    t44 = sin_omega2_tau1*t43
    t45 = -t11*t44*v1_2 + t41*t44
    t46 = -sin_omega1_tau1*t9 + t13
    t48 = cos_omega1_tau1 - cos_omega2_tau1
    t49 = -t46*v1_2 + t48*z1_2
    t50 = -V*t46 + t48*z2_2
    t51 = t39*t9 + t41*t9
    t52 = t11*t12*v1_2 - t12*t41
    z1_3_by_chi = cos_omega1_tau1_by_chi*t37 + cos_omega2_tau1_by_chi*t38 + omega1_by_chi*t42 + omega2_by_chi*t45 + p1_by_chi*t49 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t51 + sin_omega2_tau1_by_chi*t52 + t14*v1_2_by_chi + t15*z1_2_by_chi
    t53 = p3*z1_2
    t54 = t11*z2_2
    t55 = t53 + t54
    t56 = p1*z2_2
    t57 = -t53 + t56
    t58 = p3*v1_2
    t59 = V*t11
    t60 = -t40*t58 - t40*t59
    t61 = V*p1
    t62 = p3*sin_omega2_tau1*t43*v1_2 - t44*t61
    t64 = V*t46 - t48*z2_2
    t65 = t58*t9 + t59*t9
    t66 = -t12*t58 + t12*t61
    z2_3_by_chi = cos_omega1_tau1_by_chi*t55 + cos_omega2_tau1_by_chi*t57 + omega1_by_chi*t60 + omega2_by_chi*t62 + p1_by_chi*t64 + p3_by_chi*t49 + sin_omega1_tau1_by_chi*t65 + sin_omega2_tau1_by_chi*t66 + t18*v1_2_by_chi + t19*z1_2_by_chi
    t67 = t39 + t41
    t68 = t11*v1_2 - t41
    t69 = -sin_omega1_tau1*t35 - sin_omega1_tau1*t36
    t70 = t11*z1_2
    t71 = sin_omega2_tau1*t36 - sin_omega2_tau1*t70
    t72 = -omega2*sin_omega2_tau1 + t22
    t74 = t48*v1_2 - t72*z1_2
    t75 = V*t48 - t72*z2_2
    t76 = -omega1*t35 - omega1*t36
    t77 = omega2*t36 - omega2*t70
    t78 = -p1*t22 - t11*t24
    v1_3_by_chi = cos_omega1_tau1_by_chi*t67 + cos_omega2_tau1_by_chi*t68 + omega1_by_chi*t69 + omega2_by_chi*t71 + p1_by_chi*t74 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t76 + sin_omega2_tau1_by_chi*t77 + t15*v1_2_by_chi + t78*z1_2_by_chi
    t79 = t58 + t59
    t80 = -t58 + t61
    t81 = -sin_omega1_tau1*t53 - sin_omega1_tau1*t54
    t82 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t56
    t83 = -V*t48 + t72*z2_2
    t84 = -omega1*t53 - omega1*t54
    t85 = omega2*p3*z1_2 - omega2*t56
    v2_3_by_chi = cos_omega1_tau1_by_chi*t79 + cos_omega2_tau1_by_chi*t80 + omega1_by_chi*t81 + omega2_by_chi*t82 + p1_by_chi*t83 + p3_by_chi*t74 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t85 + t19*v1_2_by_chi + t23*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t37 + cos_omega2_tau1_by_eta*t38 + omega1_by_eta*t42 + omega2_by_eta*t45 + p1_by_eta*t49 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t51 + sin_omega2_tau1_by_eta*t52
    z2_3_by_eta = cos_omega1_tau1_by_eta*t55 + cos_omega2_tau1_by_eta*t57 + omega1_by_eta*t60 + omega2_by_eta*t62 + p1_by_eta*t64 + p3_by_eta*t49 + sin_omega1_tau1_by_eta*t65 + sin_omega2_tau1_by_eta*t66
    v1_3_by_eta = cos_omega1_tau1_by_eta*t67 + cos_omega2_tau1_by_eta*t68 + omega1_by_eta*t69 + omega2_by_eta*t71 + p1_by_eta*t74 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t76 + sin_omega2_tau1_by_eta*t77
    v2_3_by_eta = cos_omega1_tau1_by_eta*t79 + cos_omega2_tau1_by_eta*t80 + omega1_by_eta*t81 + omega2_by_eta*t82 + p1_by_eta*t83 + p3_by_eta*t74 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t85
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = p2*t10 + t14*v1_2_by_V + t15*z1_2_by_V + t16*tau - t17
    z2_3_by_V = t18*v1_2_by_V + t19*z1_2_by_V + t20*tau + t21
    v1_3_by_V = t15*v1_2_by_V + t16 + t78*z1_2_by_V + tau*(omega2*p2*sin_omega2_tau1 - p2*t22)
    v2_3_by_V = t19*v1_2_by_V + t20 + t23*z1_2_by_V + t25*tau
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
    return [[-z20, 0, 0, 0], [-chi*z1_2_by_chi - z1_2 + z2_2, 0, -chi*z1_2_by_V + t30, -1], [v1_3_by_chi, v1_3_by_eta, v1_3_by_V - 1, 0], [v2_4_by_chi, v2_4_by_eta, v2_4_by_V - 1, 0], [z1_3_by_chi, z1_3_by_eta, z1_4_by_V, 0], [z2_4_by_chi, z2_4_by_eta, z2_4_by_V, 0]]


def solution_ii_poincare_jacobian(parameters, spectrum, unknowns, lib):
    """Jacobian of the Poincare map in the section's coordinates.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives poincare_jacobian (2, 2).
    Operations: 273. Intermediate terms: 100.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    t7 = sin_omega2_tau1/omega2
    t5 = sin_omega1_tau1*t4
    t6 = 1 - p1
    t8 = p1*t5 + t6*t7
    t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t10*z2_2 + t8*v1_2 + t9*z1_2
    t11 = p3*sin_omega1_tau1*t4 - p3*t7
    t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t13 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t11*v1_2 + t12*z1_2 + t13*z2_2
    t14 = omega2*sin_omega2_tau1
    t15 = omega1*sin_omega1_tau1
    t16 = -p1*t15 - t14*t6
    t17 = omega2*p2*sin_omega2_tau1 - p2*t15
    v1_3 = V*t10 + t16*z1_2 + t17*z2_2 + t9*v1_2
    t18 = omega2*p3*sin_omega2_tau1 - p3*t15
    t19 = -p1*t14 - t15*t6
    v2_3 = V*t13 + t12*v1_2 + t18*z1_2 + t19*z2_2
    # functions of tau2 in stick-slip
    t20 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t20)
    sin_omega3_tau2 = lib.sin(t20)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t21 = 1 - cos_omega3_tau2
    t22 = sin_omega3_tau2/omega3
    z2_4 = V*(-t22 + tau2) + cos_omega3_tau2*z2_3 + t21*z1_3 + t22*v2_3
    t23 = omega3*sin_omega3_tau2
    v2_4 = V*t21 + cos_omega3_tau2*v2_3 + t23*z1_3 - t23*z2_3
    # rate of the exit boundary after ta
    t24 = V*chi
    rate_1 = V - t24
    # derivatives of the time to the boundary after ta
    t25 = 1/rate_1
    delay_ta_by_z10 = -t25
    delay_ta_by_z20 = chi*t25
    # perturbation on the boundary after ta
    t26 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t26 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t26
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t0*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t0*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t24
    # derivatives of the time to the boundary after tau
    t28 = 1/rate_2
    delay_tau_by_z10 = t28*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t28*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t29 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t29
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t29
    # Phi along tau1
    carried_z1_3_by_z10 = t10*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10 + t9*z1_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20 + t9*z1_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t16*z1_2_on_boundary_by_z10 + t17*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t16*z1_2_on_boundary_by_z20 + t17*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t30 = chi*z2_3
    rate_3 = t30 - z1_3
    # derivatives of the time to the boundary after tau1
    t31 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t31
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t31
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t32 = chi*eta
    t33 = -eta*t30 + t32*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t33
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t33
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t21*z1_3_on_boundary_by_z10 + t22*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t21*z1_3_on_boundary_by_z20 + t22*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t23*z1_3_on_boundary_by_z10 - t23*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t23*z1_3_on_boundary_by_z20 - t23*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t32*z1_4 - t32*z2_4
    # derivatives of the time to the boundary after tau2
    t34 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t34
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t34
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z1_4_on_boundary_by_z20 = V*delay_tau2_by_z20 + z1_3_on_boundary_by_z20
    z2_4_on_boundary_by_z10 = carried_z2_4_by_z10 + delay_tau2_by_z10*v2_4
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    return [[z1_4_on_boundary_by_z10, z1_4_on_boundary_by_z20], [z2_4_on_boundary_by_z10, z2_4_on_boundary_by_z20]]


def solution_ii_saltations(parameters, spectrum, unknowns, lib):
    """Saltation matrices of the transitions, one below the other.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives saltations (16, 4).
    Operations: 164. Intermediate terms: 53.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t8*z1_2 + t9*z2_2 + v1_2*(p1*t5 + t6*t7)
    t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t11 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t10*z1_2 + t11*z2_2 + v1_2*(p3*sin_omega1_tau1*t4 - p3*t7)
    t12 = omega2*sin_omega2_tau1
    t13 = omega1*sin_omega1_tau1
    v1_3 = V*t9 + t8*v1_2 + z1_2*(-p1*t13 - t12*t6) + z2_2*(omega2*p2*sin_omega2_tau1 - p2*t13)
    v2_3 = V*t11 + t10*v1_2 + z1_2*(omega2*p3*sin_omega2_tau1 - p3*t13) + z2_2*(-p1*t12 - t13*t6)
    # functions of tau2 in stick-slip
    t14 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t14)
    sin_omega3_tau2 = lib.sin(t14)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t15 = 1 - cos_omega3_tau2
    t16 = sin_omega3_tau2/omega3
    z2_4 = V*(-t16 + tau2) + cos_omega3_tau2*z2_3 + t15*z1_3 + t16*v2_3
    t17 = omega3*sin_omega3_tau2
    v2_4 = V*t15 + cos_omega3_tau2*v2_3 + t17*z1_3 - t17*z2_3
    # vector fields at transition 1
    behind_v1_1 = chi*z20 - z10
    # vector fields at transition 2
    t18 = chi*z2_2
    before_v1_2 = t18 - z1_2
    behind_v1_2 = before_v1_2
    t20 = chi*eta
    behind_v2_2 = -eta*t18 + t20*z1_2
    # vector fields at transition 3
    t21 = chi*z2_3
    before_v1_3 = t21 - z1_3
    before_v2_3 = -eta*t21 + t20*z1_3
    behind_v2_3 = before_v2_3
    # vector fields at transition 4
    before_v2_4 = t20*z1_4 - t20*z2_4
    # outputs
    t23 = V*chi
    t24 = behind_v1_1/(V - t23)
    t25 = chi/(-chi*v1_2 + t23)
    t26 = t25*(-before_v1_2 + behind_v1_2)
    t27 = behind_v2_2*t25
    t28 = 1/before_v1_3
    return [[1, 0, 0, 0], [0, 1, 0, 0], [t24, -chi*t24, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t26, t26, 1, 0], [-t27, t27, 0, 1], [1, 0, t28*(V - v1_3), 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t28*(-before_v2_3 + behind_v2_3), 1], [1, 0, 0, 0], [0, 1, 0, (V - v2_4)/before_v2_4], [0, 0, 1, 0], [0, 0, 0, 0]]


def solution_ii_monodromy(parameters, spectrum, unknowns, lib):
    """Monodromy matrix: the product of flows and saltation matrices over a period.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives monodromy (4, 4).
    Operations: 357. Intermediate terms: 125.
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
    # vector fields at transition 1
    behind_v1_1 = chi*z20 - z10
    # vector fields at transition 2
    t31 = chi*z2_2
    before_v1_2 = t31 - z1_2
    behind_v1_2 = before_v1_2
    t33 = chi*eta
    behind_v2_2 = -eta*t31 + t33*z1_2
    # vector fields at transition 3
    t34 = chi*z2_3
    before_v1_3 = t34 - z1_3
    before_v2_3 = -eta*t34 + t33*z1_3
    behind_v2_3 = before_v2_3
    # vector fields at transition 4
    before_v2_4 = t33*z1_4 - t33*z2_4
    # saltation of phase 1
    t36 = V*chi
    saltation_1_20 = behind_v1_1/(V - t36)
    saltation_1_21 = -chi*saltation_1_20
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    phi_2_01 = chi + saltation_1_21*sin_tau - t0
    phi_2_03 = t3
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t2
    phi_2_23 = t1
    # saltation of phase 2
    t38 = -before_v1_2 + behind_v1_2
    t39 = 1/(-chi*v1_2 + t36)
    t40 = chi*t39
    t41 = t38*t40
    saltation_2_20 = -phi_2_00*t41 + phi_2_20
    saltation_2_21 = -phi_2_01*t41 + phi_2_21 + t41
    t42 = t38*t39
    saltation_2_22 = cos_tau - t2*t42
    t43 = chi*tau
    saltation_2_23 = -phi_2_03*t41 + phi_2_23 + t42*t43
    t44 = behind_v2_2*t40
    saltation_2_30 = -phi_2_00*t44
    saltation_2_31 = behind_v2_2*chi*t39 - phi_2_01*t44
    t45 = behind_v2_2*t39
    saltation_2_32 = -t2*t45
    saltation_2_33 = -phi_2_03*t44 + t43*t45 + 1
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
    t46 = 1/before_v1_3
    t47 = t46*(V - v1_3)
    saltation_3_00 = phi_3_00 + phi_3_20*t47
    saltation_3_01 = phi_3_01 + phi_3_21*t47
    saltation_3_02 = phi_3_02 + phi_3_22*t47
    saltation_3_03 = phi_3_03 + phi_3_23*t47
    t48 = t46*(-before_v2_3 + behind_v2_3)
    saltation_3_30 = phi_3_20*t48 + phi_3_30
    saltation_3_31 = phi_3_21*t48 + phi_3_31
    saltation_3_32 = phi_3_22*t48 + phi_3_32
    saltation_3_33 = phi_3_23*t48 + phi_3_33
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
    t49 = (V - v2_4)/before_v2_4
    saltation_4_10 = phi_4_10 + phi_4_30*t49
    saltation_4_11 = phi_4_11 + phi_4_31*t49
    saltation_4_12 = phi_4_12 + phi_4_32*t49
    saltation_4_13 = phi_4_13 + phi_4_33*t49
    return [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]


def solution_ii_trace(parameters, spectrum, unknowns, lib):
    """Trace of the Poincare map's Jacobian.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives trace.
    Operations: 265. Intermediate terms: 97.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    t7 = sin_omega2_tau1/omega2
    t5 = sin_omega1_tau1*t4
    t6 = 1 - p1
    t8 = p1*t5 + t6*t7
    t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3 = V*(p2*sin_omega1_tau1*t4 - p2*t7) + t10*z2_2 + t8*v1_2 + t9*z1_2
    t11 = p3*sin_omega1_tau1*t4 - p3*t7
    t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t13 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t11*v1_2 + t12*z1_2 + t13*z2_2
    t14 = omega2*sin_omega2_tau1
    t15 = omega1*sin_omega1_tau1
    t16 = -p1*t15 - t14*t6
    t17 = omega2*p2*sin_omega2_tau1 - p2*t15
    v1_3 = V*t10 + t16*z1_2 + t17*z2_2 + t9*v1_2
    t18 = omega2*p3*sin_omega2_tau1 - p3*t15
    t19 = -p1*t14 - t15*t6
    v2_3 = V*t13 + t12*v1_2 + t18*z1_2 + t19*z2_2
    # functions of tau2 in stick-slip
    t20 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t20)
    sin_omega3_tau2 = lib.sin(t20)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t21 = 1 - cos_omega3_tau2
    t22 = sin_omega3_tau2/omega3
    z2_4 = V*(-t22 + tau2) + cos_omega3_tau2*z2_3 + t21*z1_3 + t22*v2_3
    t23 = omega3*sin_omega3_tau2
    v2_4 = V*t21 + cos_omega3_tau2*v2_3 + t23*z1_3 - t23*z2_3
    # rate of the exit boundary after ta
    t24 = V*chi
    rate_1 = V - t24
    # derivatives of the time to the boundary after ta
    t25 = 1/rate_1
    delay_ta_by_z10 = -t25
    delay_ta_by_z20 = chi*t25
    # perturbation on the boundary after ta
    t26 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t26 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t26
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t0*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t0*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t24
    # derivatives of the time to the boundary after tau
    t28 = 1/rate_2
    delay_tau_by_z10 = t28*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t28*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t29 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t29
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t29
    # Phi along tau1
    carried_z1_3_by_z10 = t10*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10 + t9*z1_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20 + t9*z1_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t11*v1_2_on_boundary_by_z10 + t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t11*v1_2_on_boundary_by_z20 + t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t16*z1_2_on_boundary_by_z10 + t17*z2_2_on_boundary_by_z10 + t9*v1_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t16*z1_2_on_boundary_by_z20 + t17*z2_2_on_boundary_by_z20 + t9*v1_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t30 = chi*z2_3
    rate_3 = t30 - z1_3
    # derivatives of the time to the boundary after tau1
    t31 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t31
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t31
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t32 = chi*eta
    t33 = -eta*t30 + t32*z1_3
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t33
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t33
    # Phi along tau2
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t21*z1_3_on_boundary_by_z20 + t22*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t23*z1_3_on_boundary_by_z10 - t23*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t23*z1_3_on_boundary_by_z20 - t23*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t32*z1_4 - t32*z2_4
    # derivatives of the time to the boundary after tau2
    t34 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t34
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t34
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    return z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20


def solution_ii_trace_gradient(parameters, spectrum, spectrum_derivatives, unknowns, lib):
    """Derivatives of the trace by the unknowns, then in total by the parameters.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes spectrum_derivatives (7, 2): gap1_by_chi, gap1_by_eta, omega1_by_chi,
        omega1_by_eta, omega2_by_chi, omega2_by_eta, p1_by_chi, p1_by_eta, p2_by_chi,
        p2_by_eta, p3_by_chi, p3_by_eta, omega3_by_chi, omega3_by_eta.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives trace_gradient (10).
    Operations: 2228. Intermediate terms: 634.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    # rate of the exit boundary after ta
    t45 = V*chi
    rate_1 = V - t45
    # derivatives of the time to the boundary after ta
    t47 = 1/rate_1
    delay_ta_by_z10 = -t47
    delay_ta_by_z20 = chi*t47
    # perturbation on the boundary after ta
    t49 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = t49 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z10 = t49
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t4*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t4*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t5*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t5*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t45
    # derivatives of the time to the boundary after tau
    t51 = 1/rate_2
    t52 = chi*z2_1_on_boundary_by_z10
    t53 = carried_z1_2_by_z10*chi - t52
    delay_tau_by_z10 = t51*t53
    t54 = chi*z2_1_on_boundary_by_z20
    t55 = carried_z1_2_by_z20*chi - t54
    delay_tau_by_z20 = t51*t55
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t56 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t56
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t56
    # Phi along tau1
    carried_z1_3_by_z10 = t17*v1_2_on_boundary_by_z10 + t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t17*v1_2_on_boundary_by_z20 + t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t21*v1_2_on_boundary_by_z10 + t22*z1_2_on_boundary_by_z10 + t23*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t21*v1_2_on_boundary_by_z20 + t22*z1_2_on_boundary_by_z20 + t23*z2_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t18*v1_2_on_boundary_by_z10 + t27*z1_2_on_boundary_by_z10 + t29*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t18*v1_2_on_boundary_by_z20 + t27*z1_2_on_boundary_by_z20 + t29*z2_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t22*v1_2_on_boundary_by_z10 + t31*z1_2_on_boundary_by_z10 - t32*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t22*v1_2_on_boundary_by_z20 + t31*z1_2_on_boundary_by_z20 - t32*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t57 = chi*z2_3
    rate_3 = t57 - z1_3
    # derivatives of the time to the boundary after tau1
    t58 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t58
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t58
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t59 = eta*z1_3
    t60 = chi*t59 - eta*t57
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t60
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t60
    # Phi along tau2
    t61 = omega3*z1_3_on_boundary_by_z10
    t62 = omega3*z2_3_on_boundary_by_z10
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2*t61 - sin_omega3_tau2*t62
    t63 = omega3*z1_3_on_boundary_by_z20
    t64 = omega3*z2_3_on_boundary_by_z20
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2*t63 - sin_omega3_tau2*t64
    # rate of the exit boundary after tau2
    t65 = eta*z1_4
    t66 = eta*z2_4
    rate_4 = chi*t65 - chi*t66
    # derivatives of the time to the boundary after tau2
    t67 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t67
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t67
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dz10 of: slip-stick for tau, until second-breaks-forward
    v1_2_by_z10 = -sin_tau
    # d/dz20 of: slip-stick for tau, until second-breaks-forward
    z1_2_by_z20 = t4
    v1_2_by_z20 = t5
    # d/dtau of: slip-stick for tau, until second-breaks-forward
    t68 = chi*z20 - z10
    z1_2_by_tau = -cos_tau_by_tau*t68 + rate_1*sin_tau_by_tau + t45
    v1_2_by_tau = cos_tau_by_tau*rate_1 + sin_tau_by_tau*t68
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t69 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t69*z20
    v1_2_by_chi = V*t69 + sin_tau*z20
    # d/dV of: slip-stick for tau, until second-breaks-forward
    t70 = chi*tau
    z1_2_by_V = sin_tau - t5 + t70
    v1_2_by_V = chi + cos_tau - t3
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dchi of: functions of tau1 in slip-slip
    t71 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t71
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t71
    t72 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t72
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t72
    # d/deta of: functions of tau1 in slip-slip
    t73 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t73
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t73
    t74 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t74
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t74
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
    t75 = p1*z1_2
    t76 = p2*z2_2
    t77 = t75 + t76
    t78 = t14*z1_2 - t76
    t79 = p1*v1_2
    t80 = V*p2
    t81 = t12*t79 + t12*t80
    t82 = t14*t15*v1_2 - t15*t80
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t77 + cos_omega2_tau1_by_tau1*t78 + sin_omega1_tau1_by_tau1*t81 + sin_omega2_tau1_by_tau1*t82
    t83 = p3*z1_2
    t84 = t14*z2_2
    t85 = t83 + t84
    t86 = p1*z2_2
    t87 = -t83 + t86
    t88 = p3*v1_2
    t89 = V*t14
    t90 = t12*t88 + t12*t89
    t91 = V*p1
    t92 = -t15*t88 + t15*t91
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t85 + cos_omega2_tau1_by_tau1*t87 + sin_omega1_tau1_by_tau1*t90 + sin_omega2_tau1_by_tau1*t92
    t93 = t79 + t80
    t94 = t14*v1_2 - t80
    t95 = -omega1*t75 - omega1*t76
    t96 = t14*z1_2
    t97 = omega2*t76 - omega2*t96
    v1_3_by_tau1 = cos_omega1_tau1_by_tau1*t93 + cos_omega2_tau1_by_tau1*t94 + sin_omega1_tau1_by_tau1*t95 + sin_omega2_tau1_by_tau1*t97
    t98 = t88 + t89
    t99 = -t88 + t91
    t100 = -omega1*t83 - omega1*t84
    t101 = omega2*p3*z1_2 - omega2*t86
    v2_3_by_tau1 = cos_omega1_tau1_by_tau1*t98 + cos_omega2_tau1_by_tau1*t99 + sin_omega1_tau1_by_tau1*t100 + sin_omega2_tau1_by_tau1*t101
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t102 = sin_omega1_tau1/omega1**2
    t103 = -t102*t79 - t102*t80
    t104 = 1/omega2**2
    t105 = sin_omega2_tau1*t104
    t106 = -t105*t14*v1_2 + t105*t80
    t107 = -sin_omega1_tau1*t12 + t16
    t109 = cos_omega1_tau1 - cos_omega2_tau1
    t110 = -t107*v1_2 + t109*z1_2
    t111 = -V*t107 + t109*z2_2
    z1_3_by_chi = cos_omega1_tau1_by_chi*t77 + cos_omega2_tau1_by_chi*t78 + omega1_by_chi*t103 + omega2_by_chi*t106 + p1_by_chi*t110 + p2_by_chi*t111 + sin_omega1_tau1_by_chi*t81 + sin_omega2_tau1_by_chi*t82 + t17*v1_2_by_chi + t18*z1_2_by_chi
    t112 = -t102*t88 - t102*t89
    t113 = p3*sin_omega2_tau1*t104*v1_2 - t105*t91
    t115 = V*t107 - t109*z2_2
    z2_3_by_chi = cos_omega1_tau1_by_chi*t85 + cos_omega2_tau1_by_chi*t87 + omega1_by_chi*t112 + omega2_by_chi*t113 + p1_by_chi*t115 + p3_by_chi*t110 + sin_omega1_tau1_by_chi*t90 + sin_omega2_tau1_by_chi*t92 + t21*v1_2_by_chi + t22*z1_2_by_chi
    t116 = -sin_omega1_tau1*t75 - sin_omega1_tau1*t76
    t117 = sin_omega2_tau1*t76 - sin_omega2_tau1*t96
    t118 = -omega2*sin_omega2_tau1 + t26
    t120 = t109*v1_2 - t118*z1_2
    t121 = V*t109 - t118*z2_2
    v1_3_by_chi = cos_omega1_tau1_by_chi*t93 + cos_omega2_tau1_by_chi*t94 + omega1_by_chi*t116 + omega2_by_chi*t117 + p1_by_chi*t120 + p2_by_chi*t121 + sin_omega1_tau1_by_chi*t95 + sin_omega2_tau1_by_chi*t97 + t18*v1_2_by_chi + t27*z1_2_by_chi
    t122 = -sin_omega1_tau1*t83 - sin_omega1_tau1*t84
    t123 = p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t86
    t124 = -V*t109 + t118*z2_2
    v2_3_by_chi = cos_omega1_tau1_by_chi*t98 + cos_omega2_tau1_by_chi*t99 + omega1_by_chi*t122 + omega2_by_chi*t123 + p1_by_chi*t124 + p3_by_chi*t120 + sin_omega1_tau1_by_chi*t100 + sin_omega2_tau1_by_chi*t101 + t22*v1_2_by_chi + t31*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t77 + cos_omega2_tau1_by_eta*t78 + omega1_by_eta*t103 + omega2_by_eta*t106 + p1_by_eta*t110 + p2_by_eta*t111 + sin_omega1_tau1_by_eta*t81 + sin_omega2_tau1_by_eta*t82
    z2_3_by_eta = cos_omega1_tau1_by_eta*t85 + cos_omega2_tau1_by_eta*t87 + omega1_by_eta*t112 + omega2_by_eta*t113 + p1_by_eta*t115 + p3_by_eta*t110 + sin_omega1_tau1_by_eta*t90 + sin_omega2_tau1_by_eta*t92
    v1_3_by_eta = cos_omega1_tau1_by_eta*t93 + cos_omega2_tau1_by_eta*t94 + omega1_by_eta*t116 + omega2_by_eta*t117 + p1_by_eta*t120 + p2_by_eta*t121 + sin_omega1_tau1_by_eta*t95 + sin_omega2_tau1_by_eta*t97
    v2_3_by_eta = cos_omega1_tau1_by_eta*t98 + cos_omega2_tau1_by_eta*t99 + omega1_by_eta*t122 + omega2_by_eta*t123 + p1_by_eta*t124 + p3_by_eta*t120 + sin_omega1_tau1_by_eta*t100 + sin_omega2_tau1_by_eta*t101
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = p2*t13 + t17*v1_2_by_V + t18*z1_2_by_V + t19*tau - t20
    z2_3_by_V = t21*v1_2_by_V + t22*z1_2_by_V + t23*tau + t24
    v1_3_by_V = t18*v1_2_by_V + t19 + t27*z1_2_by_V + t29*tau
    v2_3_by_V = t22*v1_2_by_V + t23 + t31*z1_2_by_V - t32*tau
    # d/dtau2 of: functions of tau2 in stick-slip
    cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2
    sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3
    # d/dchi of: functions of tau2 in stick-slip
    t125 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t125
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t125
    # d/deta of: functions of tau2 in stick-slip
    t126 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t126
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t126
    # d/dz10 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t38*z1_3_by_z10 + t40*v2_3_by_z10
    t127 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t127*z1_3_by_z10 - t127*z2_3_by_z10
    # d/dz20 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t38*z1_3_by_z20 + t40*v2_3_by_z20
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t127*z1_3_by_z20 - t127*z2_3_by_z20
    # d/dtau of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t38*z1_3_by_tau + t40*v2_3_by_tau
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t127*z1_3_by_tau - t127*z2_3_by_tau
    # d/dtau1 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t38*z1_3_by_tau1 + t40*v2_3_by_tau1
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t127*z1_3_by_tau1 - t127*z2_3_by_tau1
    # d/dtau2 of: stick-slip for tau2, until second-reaches-belt
    t128 = -z1_3 + z2_3
    t129 = -V*t39 + t39*v2_3
    z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*t128 + sin_omega3_tau2_by_tau2*t129
    t130 = -V + v2_3
    t131 = t42 - t43
    v2_4_by_tau2 = cos_omega3_tau2_by_tau2*t130 + sin_omega3_tau2_by_tau2*t131
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t132 = sin_omega3_tau2/omega3**2
    t133 = V*t132 - t132*v2_3
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t128 + omega3_by_chi*t133 + sin_omega3_tau2_by_chi*t129 + t38*z1_3_by_chi + t40*v2_3_by_chi
    t134 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t130 + omega3_by_chi*t134 + sin_omega3_tau2_by_chi*t131 + t127*z1_3_by_chi - t127*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t128 + omega3_by_eta*t133 + sin_omega3_tau2_by_eta*t129 + t38*z1_3_by_eta + t40*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t130 + omega3_by_eta*t134 + sin_omega3_tau2_by_eta*t131 + t127*z1_3_by_eta - t127*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t38*z1_3_by_V + t40*v2_3_by_V + t41
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t127*z1_3_by_V - t127*z2_3_by_V + 1
    # d/dchi of: rate of the exit boundary after ta
    rate_1_by_chi = -V
    # d/dV of: rate of the exit boundary after ta
    rate_1_by_V = 1 - chi
    # d/dchi of: derivatives of the time to the boundary after ta
    t135 = 1/rate_1**2
    delay_ta_by_z10_by_chi = rate_1_by_chi*t135
    delay_ta_by_z20_by_chi = -chi*delay_ta_by_z10_by_chi + t47
    # d/dV of: derivatives of the time to the boundary after ta
    delay_ta_by_z10_by_V = rate_1_by_V*t135
    delay_ta_by_z20_by_V = -chi*delay_ta_by_z10_by_V
    # d/dchi of: perturbation on the boundary after ta
    z1_1_on_boundary_by_z10_by_chi = V*delay_ta_by_z10_by_chi
    z1_1_on_boundary_by_z20_by_chi = V*delay_ta_by_z20_by_chi
    z2_1_on_boundary_by_z10_by_chi = z1_1_on_boundary_by_z10_by_chi
    z2_1_on_boundary_by_z20_by_chi = z1_1_on_boundary_by_z20_by_chi
    # d/dV of: perturbation on the boundary after ta
    z1_1_on_boundary_by_z10_by_V = V*delay_ta_by_z10_by_V + delay_ta_by_z10
    z1_1_on_boundary_by_z20_by_V = V*delay_ta_by_z20_by_V + delay_ta_by_z20
    z2_1_on_boundary_by_z10_by_V = z1_1_on_boundary_by_z10_by_V
    z2_1_on_boundary_by_z20_by_V = z1_1_on_boundary_by_z20_by_V
    # d/dtau of: Phi along tau
    t142 = t52 - z1_1_on_boundary_by_z10
    carried_z1_2_by_z10_by_tau = -cos_tau_by_tau*t142
    t143 = t54 - z1_1_on_boundary_by_z20
    carried_z1_2_by_z20_by_tau = -cos_tau_by_tau*t143
    carried_v1_2_by_z10_by_tau = sin_tau_by_tau*t142
    carried_v1_2_by_z20_by_tau = sin_tau_by_tau*t143
    # d/dchi of: Phi along tau
    carried_z1_2_by_z10_by_chi = cos_tau*z1_1_on_boundary_by_z10_by_chi + t4*z2_1_on_boundary_by_z10_by_chi + t69*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20_by_chi = cos_tau*z1_1_on_boundary_by_z20_by_chi + t4*z2_1_on_boundary_by_z20_by_chi + t69*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10_by_chi = -sin_tau*z1_1_on_boundary_by_z10_by_chi + sin_tau*z2_1_on_boundary_by_z10 + t5*z2_1_on_boundary_by_z10_by_chi
    carried_v1_2_by_z20_by_chi = -sin_tau*z1_1_on_boundary_by_z20_by_chi + sin_tau*z2_1_on_boundary_by_z20 + t5*z2_1_on_boundary_by_z20_by_chi
    # d/dV of: Phi along tau
    carried_z1_2_by_z10_by_V = cos_tau*z1_1_on_boundary_by_z10_by_V + t4*z2_1_on_boundary_by_z10_by_V
    carried_z1_2_by_z20_by_V = cos_tau*z1_1_on_boundary_by_z20_by_V + t4*z2_1_on_boundary_by_z20_by_V
    carried_v1_2_by_z10_by_V = -sin_tau*z1_1_on_boundary_by_z10_by_V + t5*z2_1_on_boundary_by_z10_by_V
    carried_v1_2_by_z20_by_V = -sin_tau*z1_1_on_boundary_by_z20_by_V + t5*z2_1_on_boundary_by_z20_by_V
    # d/dz10 of: rate of the exit boundary after tau
    rate_2_by_z10 = -chi*v1_2_by_z10
    # d/dz20 of: rate of the exit boundary after tau
    rate_2_by_z20 = -chi*v1_2_by_z20
    # d/dtau of: rate of the exit boundary after tau
    rate_2_by_tau = -chi*v1_2_by_tau
    # d/dchi of: rate of the exit boundary after tau
    rate_2_by_chi = V - chi*v1_2_by_chi - v1_2
    # d/dV of: rate of the exit boundary after tau
    rate_2_by_V = -chi*v1_2_by_V + chi
    # d/dz10 of: derivatives of the time to the boundary after tau
    t144 = 1/rate_2**2
    t145 = rate_2_by_z10*t144
    delay_tau_by_z10_by_z10 = -t145*t53
    delay_tau_by_z20_by_z10 = -t145*t55
    # d/dz20 of: derivatives of the time to the boundary after tau
    t146 = rate_2_by_z20*t144
    delay_tau_by_z10_by_z20 = -t146*t53
    delay_tau_by_z20_by_z20 = -t146*t55
    # d/dtau of: derivatives of the time to the boundary after tau
    t147 = chi*t51
    t148 = rate_2_by_tau*t144
    delay_tau_by_z10_by_tau = carried_z1_2_by_z10_by_tau*t147 - t148*t53
    delay_tau_by_z20_by_tau = carried_z1_2_by_z20_by_tau*t147 - t148*t55
    # d/dchi of: derivatives of the time to the boundary after tau
    t149 = rate_2_by_chi*t144
    delay_tau_by_z10_by_chi = carried_z1_2_by_z10_by_chi*t147 - t147*z2_1_on_boundary_by_z10_by_chi - t149*t53 + t51*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10)
    delay_tau_by_z20_by_chi = carried_z1_2_by_z20_by_chi*t147 - t147*z2_1_on_boundary_by_z20_by_chi - t149*t55 + t51*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20)
    # d/dV of: derivatives of the time to the boundary after tau
    t150 = rate_2_by_V*t144
    delay_tau_by_z10_by_V = carried_z1_2_by_z10_by_V*chi*t51 - t147*z2_1_on_boundary_by_z10_by_V - t150*t53
    delay_tau_by_z20_by_V = carried_z1_2_by_z20_by_V*chi*t51 - t147*z2_1_on_boundary_by_z20_by_V - t150*t55
    # d/dz10 of: perturbation on the boundary after tau
    z1_2_on_boundary_by_z10_by_z10 = delay_tau_by_z10*v1_2_by_z10 + delay_tau_by_z10_by_z10*v1_2
    z1_2_on_boundary_by_z20_by_z10 = delay_tau_by_z20*v1_2_by_z10 + delay_tau_by_z20_by_z10*v1_2
    z2_2_on_boundary_by_z10_by_z10 = V*delay_tau_by_z10_by_z10
    z2_2_on_boundary_by_z20_by_z10 = V*delay_tau_by_z20_by_z10
    v1_2_on_boundary_by_z10_by_z10 = -cos_tau*delay_tau_by_z10 + delay_tau_by_z10_by_z10*t56
    v1_2_on_boundary_by_z20_by_z10 = -cos_tau*delay_tau_by_z20 + delay_tau_by_z20_by_z10*t56
    # d/dz20 of: perturbation on the boundary after tau
    z1_2_on_boundary_by_z10_by_z20 = delay_tau_by_z10*v1_2_by_z20 + delay_tau_by_z10_by_z20*v1_2
    z1_2_on_boundary_by_z20_by_z20 = delay_tau_by_z20*v1_2_by_z20 + delay_tau_by_z20_by_z20*v1_2
    z2_2_on_boundary_by_z10_by_z20 = V*delay_tau_by_z10_by_z20
    z2_2_on_boundary_by_z20_by_z20 = V*delay_tau_by_z20_by_z20
    v1_2_on_boundary_by_z10_by_z20 = chi*delay_tau_by_z10 - delay_tau_by_z10*z1_2_by_z20 + delay_tau_by_z10_by_z20*t56
    v1_2_on_boundary_by_z20_by_z20 = chi*delay_tau_by_z20 - delay_tau_by_z20*z1_2_by_z20 + delay_tau_by_z20_by_z20*t56
    # d/dtau of: perturbation on the boundary after tau
    z1_2_on_boundary_by_z10_by_tau = carried_z1_2_by_z10_by_tau + delay_tau_by_z10*v1_2_by_tau + delay_tau_by_z10_by_tau*v1_2
    z1_2_on_boundary_by_z20_by_tau = carried_z1_2_by_z20_by_tau + delay_tau_by_z20*v1_2_by_tau + delay_tau_by_z20_by_tau*v1_2
    z2_2_on_boundary_by_z10_by_tau = V*delay_tau_by_z10_by_tau
    z2_2_on_boundary_by_z20_by_tau = V*delay_tau_by_z20_by_tau
    v1_2_on_boundary_by_z10_by_tau = carried_v1_2_by_z10_by_tau + delay_tau_by_z10*t45 - delay_tau_by_z10*z1_2_by_tau + delay_tau_by_z10_by_tau*t56
    v1_2_on_boundary_by_z20_by_tau = carried_v1_2_by_z20_by_tau + delay_tau_by_z20*t45 - delay_tau_by_z20*z1_2_by_tau + delay_tau_by_z20_by_tau*t56
    # d/dchi of: perturbation on the boundary after tau
    z1_2_on_boundary_by_z10_by_chi = carried_z1_2_by_z10_by_chi + delay_tau_by_z10*v1_2_by_chi + delay_tau_by_z10_by_chi*v1_2
    z1_2_on_boundary_by_z20_by_chi = carried_z1_2_by_z20_by_chi + delay_tau_by_z20*v1_2_by_chi + delay_tau_by_z20_by_chi*v1_2
    z2_2_on_boundary_by_z10_by_chi = V*delay_tau_by_z10_by_chi + z2_1_on_boundary_by_z10_by_chi
    z2_2_on_boundary_by_z20_by_chi = V*delay_tau_by_z20_by_chi + z2_1_on_boundary_by_z20_by_chi
    v1_2_on_boundary_by_z10_by_chi = carried_v1_2_by_z10_by_chi - delay_tau_by_z10*z1_2_by_chi + delay_tau_by_z10*z2_2 + delay_tau_by_z10_by_chi*t56
    v1_2_on_boundary_by_z20_by_chi = carried_v1_2_by_z20_by_chi - delay_tau_by_z20*z1_2_by_chi + delay_tau_by_z20*z2_2 + delay_tau_by_z20_by_chi*t56
    # d/dV of: perturbation on the boundary after tau
    z1_2_on_boundary_by_z10_by_V = carried_z1_2_by_z10_by_V + delay_tau_by_z10*v1_2_by_V + delay_tau_by_z10_by_V*v1_2
    z1_2_on_boundary_by_z20_by_V = carried_z1_2_by_z20_by_V + delay_tau_by_z20*v1_2_by_V + delay_tau_by_z20_by_V*v1_2
    z2_2_on_boundary_by_z10_by_V = V*delay_tau_by_z10_by_V + delay_tau_by_z10 + z2_1_on_boundary_by_z10_by_V
    z2_2_on_boundary_by_z20_by_V = V*delay_tau_by_z20_by_V + delay_tau_by_z20 + z2_1_on_boundary_by_z20_by_V
    v1_2_on_boundary_by_z10_by_V = carried_v1_2_by_z10_by_V + delay_tau_by_z10*t70 - delay_tau_by_z10*z1_2_by_V + delay_tau_by_z10_by_V*t56
    v1_2_on_boundary_by_z20_by_V = carried_v1_2_by_z20_by_V + delay_tau_by_z20*t70 - delay_tau_by_z20*z1_2_by_V + delay_tau_by_z20_by_V*t56
    # d/dz10 of: Phi along tau1
    carried_z1_3_by_z10_by_z10 = t17*v1_2_on_boundary_by_z10_by_z10 + t18*z1_2_on_boundary_by_z10_by_z10 + t19*z2_2_on_boundary_by_z10_by_z10
    carried_z1_3_by_z20_by_z10 = t17*v1_2_on_boundary_by_z20_by_z10 + t18*z1_2_on_boundary_by_z20_by_z10 + t19*z2_2_on_boundary_by_z20_by_z10
    carried_z2_3_by_z10_by_z10 = t21*v1_2_on_boundary_by_z10_by_z10 + t22*z1_2_on_boundary_by_z10_by_z10 + t23*z2_2_on_boundary_by_z10_by_z10
    carried_z2_3_by_z20_by_z10 = t21*v1_2_on_boundary_by_z20_by_z10 + t22*z1_2_on_boundary_by_z20_by_z10 + t23*z2_2_on_boundary_by_z20_by_z10
    carried_v1_3_by_z10_by_z10 = t18*v1_2_on_boundary_by_z10_by_z10 + t27*z1_2_on_boundary_by_z10_by_z10 + t29*z2_2_on_boundary_by_z10_by_z10
    carried_v1_3_by_z20_by_z10 = t18*v1_2_on_boundary_by_z20_by_z10 + t27*z1_2_on_boundary_by_z20_by_z10 + t29*z2_2_on_boundary_by_z20_by_z10
    carried_v2_3_by_z10_by_z10 = t22*v1_2_on_boundary_by_z10_by_z10 + t31*z1_2_on_boundary_by_z10_by_z10 - t32*z2_2_on_boundary_by_z10_by_z10
    carried_v2_3_by_z20_by_z10 = t22*v1_2_on_boundary_by_z20_by_z10 + t31*z1_2_on_boundary_by_z20_by_z10 - t32*z2_2_on_boundary_by_z20_by_z10
    # d/dz20 of: Phi along tau1
    carried_z1_3_by_z10_by_z20 = t17*v1_2_on_boundary_by_z10_by_z20 + t18*z1_2_on_boundary_by_z10_by_z20 + t19*z2_2_on_boundary_by_z10_by_z20
    carried_z1_3_by_z20_by_z20 = t17*v1_2_on_boundary_by_z20_by_z20 + t18*z1_2_on_boundary_by_z20_by_z20 + t19*z2_2_on_boundary_by_z20_by_z20
    carried_z2_3_by_z10_by_z20 = t21*v1_2_on_boundary_by_z10_by_z20 + t22*z1_2_on_boundary_by_z10_by_z20 + t23*z2_2_on_boundary_by_z10_by_z20
    carried_z2_3_by_z20_by_z20 = t21*v1_2_on_boundary_by_z20_by_z20 + t22*z1_2_on_boundary_by_z20_by_z20 + t23*z2_2_on_boundary_by_z20_by_z20
    carried_v1_3_by_z10_by_z20 = t18*v1_2_on_boundary_by_z10_by_z20 + t27*z1_2_on_boundary_by_z10_by_z20 + t29*z2_2_on_boundary_by_z10_by_z20
    carried_v1_3_by_z20_by_z20 = t18*v1_2_on_boundary_by_z20_by_z20 + t27*z1_2_on_boundary_by_z20_by_z20 + t29*z2_2_on_boundary_by_z20_by_z20
    carried_v2_3_by_z10_by_z20 = t22*v1_2_on_boundary_by_z10_by_z20 + t31*z1_2_on_boundary_by_z10_by_z20 - t32*z2_2_on_boundary_by_z10_by_z20
    carried_v2_3_by_z20_by_z20 = t22*v1_2_on_boundary_by_z20_by_z20 + t31*z1_2_on_boundary_by_z20_by_z20 - t32*z2_2_on_boundary_by_z20_by_z20
    # d/dtau of: Phi along tau1
    carried_z1_3_by_z10_by_tau = t17*v1_2_on_boundary_by_z10_by_tau + t18*z1_2_on_boundary_by_z10_by_tau + t19*z2_2_on_boundary_by_z10_by_tau
    carried_z1_3_by_z20_by_tau = t17*v1_2_on_boundary_by_z20_by_tau + t18*z1_2_on_boundary_by_z20_by_tau + t19*z2_2_on_boundary_by_z20_by_tau
    carried_z2_3_by_z10_by_tau = t21*v1_2_on_boundary_by_z10_by_tau + t22*z1_2_on_boundary_by_z10_by_tau + t23*z2_2_on_boundary_by_z10_by_tau
    carried_z2_3_by_z20_by_tau = t21*v1_2_on_boundary_by_z20_by_tau + t22*z1_2_on_boundary_by_z20_by_tau + t23*z2_2_on_boundary_by_z20_by_tau
    carried_v1_3_by_z10_by_tau = t18*v1_2_on_boundary_by_z10_by_tau + t27*z1_2_on_boundary_by_z10_by_tau + t29*z2_2_on_boundary_by_z10_by_tau
    carried_v1_3_by_z20_by_tau = t18*v1_2_on_boundary_by_z20_by_tau + t27*z1_2_on_boundary_by_z20_by_tau + t29*z2_2_on_boundary_by_z20_by_tau
    carried_v2_3_by_z10_by_tau = t22*v1_2_on_boundary_by_z10_by_tau + t31*z1_2_on_boundary_by_z10_by_tau - t32*z2_2_on_boundary_by_z10_by_tau
    carried_v2_3_by_z20_by_tau = t22*v1_2_on_boundary_by_z20_by_tau + t31*z1_2_on_boundary_by_z20_by_tau - t32*z2_2_on_boundary_by_z20_by_tau
    # d/dtau1 of: Phi along tau1
    t151 = p1*z1_2_on_boundary_by_z10
    t152 = p2*z2_2_on_boundary_by_z10
    t153 = t151 + t152
    t154 = t14*z1_2_on_boundary_by_z10 - t152
    t155 = sin_omega1_tau1_by_tau1*t12
    t156 = p1*v1_2_on_boundary_by_z10
    t157 = sin_omega2_tau1_by_tau1*t15
    t158 = t14*v1_2_on_boundary_by_z10
    carried_z1_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t153 + cos_omega2_tau1_by_tau1*t154 + t155*t156 + t157*t158
    t159 = p1*z1_2_on_boundary_by_z20
    t160 = p2*z2_2_on_boundary_by_z20
    t161 = t159 + t160
    t162 = t14*z1_2_on_boundary_by_z20 - t160
    t163 = p1*v1_2_on_boundary_by_z20
    t164 = t14*v1_2_on_boundary_by_z20
    carried_z1_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t161 + cos_omega2_tau1_by_tau1*t162 + t155*t163 + t157*t164
    t165 = p3*z1_2_on_boundary_by_z10
    t166 = t14*z2_2_on_boundary_by_z10
    t167 = t165 + t166
    t168 = p1*z2_2_on_boundary_by_z10
    t169 = -t165 + t168
    t170 = p3*v1_2_on_boundary_by_z10
    carried_z2_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t167 + cos_omega2_tau1_by_tau1*t169 + t155*t170 - t157*t170
    t171 = p3*z1_2_on_boundary_by_z20
    t172 = t14*z2_2_on_boundary_by_z20
    t173 = t171 + t172
    t174 = p1*z2_2_on_boundary_by_z20
    t175 = -t171 + t174
    t176 = p3*v1_2_on_boundary_by_z20
    carried_z2_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t173 + cos_omega2_tau1_by_tau1*t175 + t155*t176 - t157*t176
    t177 = -omega1*t151 - omega1*t152
    t178 = t14*z1_2_on_boundary_by_z10
    t179 = omega2*t152 - omega2*t178
    t180 = cos_omega1_tau1_by_tau1*p1
    t181 = cos_omega2_tau1_by_tau1*t14
    carried_v1_3_by_z10_by_tau1 = sin_omega1_tau1_by_tau1*t177 + sin_omega2_tau1_by_tau1*t179 + t180*v1_2_on_boundary_by_z10 + t181*v1_2_on_boundary_by_z10
    t182 = -omega1*t159 - omega1*t160
    t183 = t14*z1_2_on_boundary_by_z20
    t184 = omega2*t160 - omega2*t183
    carried_v1_3_by_z20_by_tau1 = sin_omega1_tau1_by_tau1*t182 + sin_omega2_tau1_by_tau1*t184 + t180*v1_2_on_boundary_by_z20 + t181*v1_2_on_boundary_by_z20
    t185 = -omega1*t165 - omega1*t166
    t186 = omega2*p3*z1_2_on_boundary_by_z10 - omega2*t168
    carried_v2_3_by_z10_by_tau1 = cos_omega1_tau1_by_tau1*t170 - cos_omega2_tau1_by_tau1*t170 + sin_omega1_tau1_by_tau1*t185 + sin_omega2_tau1_by_tau1*t186
    t187 = -omega1*t171 - omega1*t172
    t188 = omega2*p3*z1_2_on_boundary_by_z20 - omega2*t174
    carried_v2_3_by_z20_by_tau1 = cos_omega1_tau1_by_tau1*t176 - cos_omega2_tau1_by_tau1*t176 + sin_omega1_tau1_by_tau1*t187 + sin_omega2_tau1_by_tau1*t188
    # d/dchi of: Phi along tau1
    t189 = -t107*v1_2_on_boundary_by_z10 + t109*z1_2_on_boundary_by_z10
    t190 = p2_by_chi*t109
    t191 = sin_omega1_tau1_by_chi*t12
    t192 = sin_omega2_tau1_by_chi*t15
    t193 = omega1_by_chi*t102
    t194 = omega2_by_chi*t105
    carried_z1_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t153 + cos_omega2_tau1_by_chi*t154 + p1_by_chi*t189 + t156*t191 - t156*t193 + t158*t192 - t158*t194 + t17*v1_2_on_boundary_by_z10_by_chi + t18*z1_2_on_boundary_by_z10_by_chi + t19*z2_2_on_boundary_by_z10_by_chi + t190*z2_2_on_boundary_by_z10
    t195 = -t107*v1_2_on_boundary_by_z20 + t109*z1_2_on_boundary_by_z20
    carried_z1_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t161 + cos_omega2_tau1_by_chi*t162 + p1_by_chi*t195 + t163*t191 - t163*t193 + t164*t192 - t164*t194 + t17*v1_2_on_boundary_by_z20_by_chi + t18*z1_2_on_boundary_by_z20_by_chi + t19*z2_2_on_boundary_by_z20_by_chi + t190*z2_2_on_boundary_by_z20
    t196 = -p1_by_chi*t109
    carried_z2_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t167 + cos_omega2_tau1_by_chi*t169 + p3_by_chi*t189 + t170*t191 - t170*t192 - t170*t193 + t170*t194 + t196*z2_2_on_boundary_by_z10 + t21*v1_2_on_boundary_by_z10_by_chi + t22*z1_2_on_boundary_by_z10_by_chi + t23*z2_2_on_boundary_by_z10_by_chi
    carried_z2_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t173 + cos_omega2_tau1_by_chi*t175 + p3_by_chi*t195 + t176*t191 - t176*t192 - t176*t193 + t176*t194 + t196*z2_2_on_boundary_by_z20 + t21*v1_2_on_boundary_by_z20_by_chi + t22*z1_2_on_boundary_by_z20_by_chi + t23*z2_2_on_boundary_by_z20_by_chi
    t197 = -sin_omega1_tau1*t151 - sin_omega1_tau1*t152
    t198 = sin_omega2_tau1*t152 - sin_omega2_tau1*t178
    t199 = t109*v1_2_on_boundary_by_z10 - t118*z1_2_on_boundary_by_z10
    t200 = cos_omega1_tau1_by_chi*p1
    t201 = cos_omega2_tau1_by_chi*t14
    t202 = -p2_by_chi*t118
    carried_v1_3_by_z10_by_chi = omega1_by_chi*t197 + omega2_by_chi*t198 + p1_by_chi*t199 + sin_omega1_tau1_by_chi*t177 + sin_omega2_tau1_by_chi*t179 + t18*v1_2_on_boundary_by_z10_by_chi + t200*v1_2_on_boundary_by_z10 + t201*v1_2_on_boundary_by_z10 + t202*z2_2_on_boundary_by_z10 + t27*z1_2_on_boundary_by_z10_by_chi + t29*z2_2_on_boundary_by_z10_by_chi
    t203 = -sin_omega1_tau1*t159 - sin_omega1_tau1*t160
    t204 = sin_omega2_tau1*t160 - sin_omega2_tau1*t183
    t205 = t109*v1_2_on_boundary_by_z20 - t118*z1_2_on_boundary_by_z20
    carried_v1_3_by_z20_by_chi = omega1_by_chi*t203 + omega2_by_chi*t204 + p1_by_chi*t205 + sin_omega1_tau1_by_chi*t182 + sin_omega2_tau1_by_chi*t184 + t18*v1_2_on_boundary_by_z20_by_chi + t200*v1_2_on_boundary_by_z20 + t201*v1_2_on_boundary_by_z20 + t202*z2_2_on_boundary_by_z20 + t27*z1_2_on_boundary_by_z20_by_chi + t29*z2_2_on_boundary_by_z20_by_chi
    t206 = -sin_omega1_tau1*t165 - sin_omega1_tau1*t166
    t207 = p3*sin_omega2_tau1*z1_2_on_boundary_by_z10 - sin_omega2_tau1*t168
    t208 = p1_by_chi*t118
    carried_v2_3_by_z10_by_chi = cos_omega1_tau1_by_chi*t170 - cos_omega2_tau1_by_chi*t170 + omega1_by_chi*t206 + omega2_by_chi*t207 + p3_by_chi*t199 + sin_omega1_tau1_by_chi*t185 + sin_omega2_tau1_by_chi*t186 + t208*z2_2_on_boundary_by_z10 + t22*v1_2_on_boundary_by_z10_by_chi + t31*z1_2_on_boundary_by_z10_by_chi - t32*z2_2_on_boundary_by_z10_by_chi
    t209 = -sin_omega1_tau1*t171 - sin_omega1_tau1*t172
    t210 = p3*sin_omega2_tau1*z1_2_on_boundary_by_z20 - sin_omega2_tau1*t174
    carried_v2_3_by_z20_by_chi = cos_omega1_tau1_by_chi*t176 - cos_omega2_tau1_by_chi*t176 + omega1_by_chi*t209 + omega2_by_chi*t210 + p3_by_chi*t205 + sin_omega1_tau1_by_chi*t187 + sin_omega2_tau1_by_chi*t188 + t208*z2_2_on_boundary_by_z20 + t22*v1_2_on_boundary_by_z20_by_chi + t31*z1_2_on_boundary_by_z20_by_chi - t32*z2_2_on_boundary_by_z20_by_chi
    # d/deta of: Phi along tau1
    t211 = p2_by_eta*t109
    t212 = sin_omega1_tau1_by_eta*t12
    t213 = sin_omega2_tau1_by_eta*t15
    t214 = omega1_by_eta*t102
    t215 = omega2_by_eta*t105
    carried_z1_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t153 + cos_omega2_tau1_by_eta*t154 + p1_by_eta*t189 + t156*t212 - t156*t214 + t158*t213 - t158*t215 + t211*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t161 + cos_omega2_tau1_by_eta*t162 + p1_by_eta*t195 + t163*t212 - t163*t214 + t164*t213 - t164*t215 + t211*z2_2_on_boundary_by_z20
    t216 = -p1_by_eta*t109
    carried_z2_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t167 + cos_omega2_tau1_by_eta*t169 + p3_by_eta*t189 + t170*t212 - t170*t213 - t170*t214 + t170*t215 + t216*z2_2_on_boundary_by_z10
    carried_z2_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t173 + cos_omega2_tau1_by_eta*t175 + p3_by_eta*t195 + t176*t212 - t176*t213 - t176*t214 + t176*t215 + t216*z2_2_on_boundary_by_z20
    t217 = cos_omega1_tau1_by_eta*p1
    t218 = cos_omega2_tau1_by_eta*t14
    t219 = -p2_by_eta*t118
    carried_v1_3_by_z10_by_eta = omega1_by_eta*t197 + omega2_by_eta*t198 + p1_by_eta*t199 + sin_omega1_tau1_by_eta*t177 + sin_omega2_tau1_by_eta*t179 + t217*v1_2_on_boundary_by_z10 + t218*v1_2_on_boundary_by_z10 + t219*z2_2_on_boundary_by_z10
    carried_v1_3_by_z20_by_eta = omega1_by_eta*t203 + omega2_by_eta*t204 + p1_by_eta*t205 + sin_omega1_tau1_by_eta*t182 + sin_omega2_tau1_by_eta*t184 + t217*v1_2_on_boundary_by_z20 + t218*v1_2_on_boundary_by_z20 + t219*z2_2_on_boundary_by_z20
    t220 = p1_by_eta*t118
    carried_v2_3_by_z10_by_eta = cos_omega1_tau1_by_eta*t170 - cos_omega2_tau1_by_eta*t170 + omega1_by_eta*t206 + omega2_by_eta*t207 + p3_by_eta*t199 + sin_omega1_tau1_by_eta*t185 + sin_omega2_tau1_by_eta*t186 + t220*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20_by_eta = cos_omega1_tau1_by_eta*t176 - cos_omega2_tau1_by_eta*t176 + omega1_by_eta*t209 + omega2_by_eta*t210 + p3_by_eta*t205 + sin_omega1_tau1_by_eta*t187 + sin_omega2_tau1_by_eta*t188 + t220*z2_2_on_boundary_by_z20
    # d/dV of: Phi along tau1
    carried_z1_3_by_z10_by_V = t17*v1_2_on_boundary_by_z10_by_V + t18*z1_2_on_boundary_by_z10_by_V + t19*z2_2_on_boundary_by_z10_by_V
    carried_z1_3_by_z20_by_V = t17*v1_2_on_boundary_by_z20_by_V + t18*z1_2_on_boundary_by_z20_by_V + t19*z2_2_on_boundary_by_z20_by_V
    carried_z2_3_by_z10_by_V = t21*v1_2_on_boundary_by_z10_by_V + t22*z1_2_on_boundary_by_z10_by_V + t23*z2_2_on_boundary_by_z10_by_V
    carried_z2_3_by_z20_by_V = t21*v1_2_on_boundary_by_z20_by_V + t22*z1_2_on_boundary_by_z20_by_V + t23*z2_2_on_boundary_by_z20_by_V
    carried_v1_3_by_z10_by_V = t18*v1_2_on_boundary_by_z10_by_V + t27*z1_2_on_boundary_by_z10_by_V + t29*z2_2_on_boundary_by_z10_by_V
    carried_v1_3_by_z20_by_V = t18*v1_2_on_boundary_by_z20_by_V + t27*z1_2_on_boundary_by_z20_by_V + t29*z2_2_on_boundary_by_z20_by_V
    carried_v2_3_by_z10_by_V = t22*v1_2_on_boundary_by_z10_by_V + t31*z1_2_on_boundary_by_z10_by_V - t32*z2_2_on_boundary_by_z10_by_V
    carried_v2_3_by_z20_by_V = t22*v1_2_on_boundary_by_z20_by_V + t31*z1_2_on_boundary_by_z20_by_V - t32*z2_2_on_boundary_by_z20_by_V
    # d/dz10 of: rate of the exit boundary after tau1
    t221 = chi*z2_3_by_z10
    rate_3_by_z10 = t221 - z1_3_by_z10
    # d/dz20 of: rate of the exit boundary after tau1
    t222 = chi*z2_3_by_z20
    rate_3_by_z20 = t222 - z1_3_by_z20
    # d/dtau of: rate of the exit boundary after tau1
    t223 = chi*z2_3_by_tau
    rate_3_by_tau = t223 - z1_3_by_tau
    # d/dtau1 of: rate of the exit boundary after tau1
    t224 = chi*z2_3_by_tau1
    rate_3_by_tau1 = t224 - z1_3_by_tau1
    # d/dchi of: rate of the exit boundary after tau1
    t225 = chi*z2_3_by_chi
    rate_3_by_chi = t225 - z1_3_by_chi + z2_3
    # d/deta of: rate of the exit boundary after tau1
    t226 = chi*z2_3_by_eta
    rate_3_by_eta = t226 - z1_3_by_eta
    # d/dV of: rate of the exit boundary after tau1
    t227 = chi*z2_3_by_V
    rate_3_by_V = t227 - z1_3_by_V
    # d/dz10 of: derivatives of the time to the boundary after tau1
    t228 = 1/rate_3**2
    t229 = rate_3_by_z10*t228
    delay_tau1_by_z10_by_z10 = carried_v1_3_by_z10*t229 - carried_v1_3_by_z10_by_z10*t58
    delay_tau1_by_z20_by_z10 = carried_v1_3_by_z20*t229 - carried_v1_3_by_z20_by_z10*t58
    # d/dz20 of: derivatives of the time to the boundary after tau1
    t230 = rate_3_by_z20*t228
    delay_tau1_by_z10_by_z20 = carried_v1_3_by_z10*t230 - carried_v1_3_by_z10_by_z20*t58
    delay_tau1_by_z20_by_z20 = carried_v1_3_by_z20*t230 - carried_v1_3_by_z20_by_z20*t58
    # d/dtau of: derivatives of the time to the boundary after tau1
    t231 = rate_3_by_tau*t228
    delay_tau1_by_z10_by_tau = carried_v1_3_by_z10*t231 - carried_v1_3_by_z10_by_tau*t58
    delay_tau1_by_z20_by_tau = carried_v1_3_by_z20*t231 - carried_v1_3_by_z20_by_tau*t58
    # d/dtau1 of: derivatives of the time to the boundary after tau1
    t232 = rate_3_by_tau1*t228
    delay_tau1_by_z10_by_tau1 = carried_v1_3_by_z10*t232 - carried_v1_3_by_z10_by_tau1*t58
    delay_tau1_by_z20_by_tau1 = carried_v1_3_by_z20*t232 - carried_v1_3_by_z20_by_tau1*t58
    # d/dchi of: derivatives of the time to the boundary after tau1
    t233 = rate_3_by_chi*t228
    delay_tau1_by_z10_by_chi = carried_v1_3_by_z10*t233 - carried_v1_3_by_z10_by_chi*t58
    delay_tau1_by_z20_by_chi = carried_v1_3_by_z20*t233 - carried_v1_3_by_z20_by_chi*t58
    # d/deta of: derivatives of the time to the boundary after tau1
    t234 = rate_3_by_eta*t228
    delay_tau1_by_z10_by_eta = carried_v1_3_by_z10*t234 - carried_v1_3_by_z10_by_eta*t58
    delay_tau1_by_z20_by_eta = carried_v1_3_by_z20*t234 - carried_v1_3_by_z20_by_eta*t58
    # d/dV of: derivatives of the time to the boundary after tau1
    t235 = rate_3_by_V*t228
    delay_tau1_by_z10_by_V = carried_v1_3_by_z10*t235 - carried_v1_3_by_z10_by_V*t58
    delay_tau1_by_z20_by_V = carried_v1_3_by_z20*t235 - carried_v1_3_by_z20_by_V*t58
    # d/dz10 of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_z10 = carried_z1_3_by_z10_by_z10 + delay_tau1_by_z10*v1_3_by_z10 + delay_tau1_by_z10_by_z10*v1_3
    z1_3_on_boundary_by_z20_by_z10 = carried_z1_3_by_z20_by_z10 + delay_tau1_by_z20*v1_3_by_z10 + delay_tau1_by_z20_by_z10*v1_3
    z2_3_on_boundary_by_z10_by_z10 = carried_z2_3_by_z10_by_z10 + delay_tau1_by_z10*v2_3_by_z10 + delay_tau1_by_z10_by_z10*v2_3
    z2_3_on_boundary_by_z20_by_z10 = carried_z2_3_by_z20_by_z10 + delay_tau1_by_z20*v2_3_by_z10 + delay_tau1_by_z20_by_z10*v2_3
    t236 = chi*eta
    t237 = t236*z1_3_by_z10
    t238 = eta*t221
    v2_3_on_boundary_by_z10_by_z10 = carried_v2_3_by_z10_by_z10 + delay_tau1_by_z10*t237 - delay_tau1_by_z10*t238 + delay_tau1_by_z10_by_z10*t60
    v2_3_on_boundary_by_z20_by_z10 = carried_v2_3_by_z20_by_z10 + delay_tau1_by_z20*t237 - delay_tau1_by_z20*t238 + delay_tau1_by_z20_by_z10*t60
    # d/dz20 of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_z20 = carried_z1_3_by_z10_by_z20 + delay_tau1_by_z10*v1_3_by_z20 + delay_tau1_by_z10_by_z20*v1_3
    z1_3_on_boundary_by_z20_by_z20 = carried_z1_3_by_z20_by_z20 + delay_tau1_by_z20*v1_3_by_z20 + delay_tau1_by_z20_by_z20*v1_3
    z2_3_on_boundary_by_z10_by_z20 = carried_z2_3_by_z10_by_z20 + delay_tau1_by_z10*v2_3_by_z20 + delay_tau1_by_z10_by_z20*v2_3
    z2_3_on_boundary_by_z20_by_z20 = carried_z2_3_by_z20_by_z20 + delay_tau1_by_z20*v2_3_by_z20 + delay_tau1_by_z20_by_z20*v2_3
    t239 = t236*z1_3_by_z20
    t240 = eta*t222
    v2_3_on_boundary_by_z10_by_z20 = carried_v2_3_by_z10_by_z20 + delay_tau1_by_z10*t239 - delay_tau1_by_z10*t240 + delay_tau1_by_z10_by_z20*t60
    v2_3_on_boundary_by_z20_by_z20 = carried_v2_3_by_z20_by_z20 + delay_tau1_by_z20*t239 - delay_tau1_by_z20*t240 + delay_tau1_by_z20_by_z20*t60
    # d/dtau of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_tau = carried_z1_3_by_z10_by_tau + delay_tau1_by_z10*v1_3_by_tau + delay_tau1_by_z10_by_tau*v1_3
    z1_3_on_boundary_by_z20_by_tau = carried_z1_3_by_z20_by_tau + delay_tau1_by_z20*v1_3_by_tau + delay_tau1_by_z20_by_tau*v1_3
    z2_3_on_boundary_by_z10_by_tau = carried_z2_3_by_z10_by_tau + delay_tau1_by_z10*v2_3_by_tau + delay_tau1_by_z10_by_tau*v2_3
    z2_3_on_boundary_by_z20_by_tau = carried_z2_3_by_z20_by_tau + delay_tau1_by_z20*v2_3_by_tau + delay_tau1_by_z20_by_tau*v2_3
    t241 = t236*z1_3_by_tau
    t242 = eta*t223
    v2_3_on_boundary_by_z10_by_tau = carried_v2_3_by_z10_by_tau + delay_tau1_by_z10*t241 - delay_tau1_by_z10*t242 + delay_tau1_by_z10_by_tau*t60
    v2_3_on_boundary_by_z20_by_tau = carried_v2_3_by_z20_by_tau + delay_tau1_by_z20*t241 - delay_tau1_by_z20*t242 + delay_tau1_by_z20_by_tau*t60
    # d/dtau1 of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_tau1 = carried_z1_3_by_z10_by_tau1 + delay_tau1_by_z10*v1_3_by_tau1 + delay_tau1_by_z10_by_tau1*v1_3
    z1_3_on_boundary_by_z20_by_tau1 = carried_z1_3_by_z20_by_tau1 + delay_tau1_by_z20*v1_3_by_tau1 + delay_tau1_by_z20_by_tau1*v1_3
    z2_3_on_boundary_by_z10_by_tau1 = carried_z2_3_by_z10_by_tau1 + delay_tau1_by_z10*v2_3_by_tau1 + delay_tau1_by_z10_by_tau1*v2_3
    z2_3_on_boundary_by_z20_by_tau1 = carried_z2_3_by_z20_by_tau1 + delay_tau1_by_z20*v2_3_by_tau1 + delay_tau1_by_z20_by_tau1*v2_3
    t243 = t236*z1_3_by_tau1
    t244 = eta*t224
    v2_3_on_boundary_by_z10_by_tau1 = carried_v2_3_by_z10_by_tau1 + delay_tau1_by_z10*t243 - delay_tau1_by_z10*t244 + delay_tau1_by_z10_by_tau1*t60
    v2_3_on_boundary_by_z20_by_tau1 = carried_v2_3_by_z20_by_tau1 + delay_tau1_by_z20*t243 - delay_tau1_by_z20*t244 + delay_tau1_by_z20_by_tau1*t60
    # d/dchi of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_chi = carried_z1_3_by_z10_by_chi + delay_tau1_by_z10*v1_3_by_chi + delay_tau1_by_z10_by_chi*v1_3
    z1_3_on_boundary_by_z20_by_chi = carried_z1_3_by_z20_by_chi + delay_tau1_by_z20*v1_3_by_chi + delay_tau1_by_z20_by_chi*v1_3
    z2_3_on_boundary_by_z10_by_chi = carried_z2_3_by_z10_by_chi + delay_tau1_by_z10*v2_3_by_chi + delay_tau1_by_z10_by_chi*v2_3
    z2_3_on_boundary_by_z20_by_chi = carried_z2_3_by_z20_by_chi + delay_tau1_by_z20*v2_3_by_chi + delay_tau1_by_z20_by_chi*v2_3
    t245 = -eta*z2_3 + t59
    t246 = t236*z1_3_by_chi
    t247 = eta*t225
    v2_3_on_boundary_by_z10_by_chi = carried_v2_3_by_z10_by_chi + delay_tau1_by_z10*t245 + delay_tau1_by_z10*t246 - delay_tau1_by_z10*t247 + delay_tau1_by_z10_by_chi*t60
    v2_3_on_boundary_by_z20_by_chi = carried_v2_3_by_z20_by_chi + delay_tau1_by_z20*t245 + delay_tau1_by_z20*t246 - delay_tau1_by_z20*t247 + delay_tau1_by_z20_by_chi*t60
    # d/deta of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_eta = carried_z1_3_by_z10_by_eta + delay_tau1_by_z10*v1_3_by_eta + delay_tau1_by_z10_by_eta*v1_3
    z1_3_on_boundary_by_z20_by_eta = carried_z1_3_by_z20_by_eta + delay_tau1_by_z20*v1_3_by_eta + delay_tau1_by_z20_by_eta*v1_3
    z2_3_on_boundary_by_z10_by_eta = carried_z2_3_by_z10_by_eta + delay_tau1_by_z10*v2_3_by_eta + delay_tau1_by_z10_by_eta*v2_3
    z2_3_on_boundary_by_z20_by_eta = carried_z2_3_by_z20_by_eta + delay_tau1_by_z20*v2_3_by_eta + delay_tau1_by_z20_by_eta*v2_3
    t248 = chi*z1_3 - t57
    t249 = t236*z1_3_by_eta
    t250 = eta*t226
    v2_3_on_boundary_by_z10_by_eta = carried_v2_3_by_z10_by_eta + delay_tau1_by_z10*t248 + delay_tau1_by_z10*t249 - delay_tau1_by_z10*t250 + delay_tau1_by_z10_by_eta*t60
    v2_3_on_boundary_by_z20_by_eta = carried_v2_3_by_z20_by_eta + delay_tau1_by_z20*t248 + delay_tau1_by_z20*t249 - delay_tau1_by_z20*t250 + delay_tau1_by_z20_by_eta*t60
    # d/dV of: perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10_by_V = carried_z1_3_by_z10_by_V + delay_tau1_by_z10*v1_3_by_V + delay_tau1_by_z10_by_V*v1_3
    z1_3_on_boundary_by_z20_by_V = carried_z1_3_by_z20_by_V + delay_tau1_by_z20*v1_3_by_V + delay_tau1_by_z20_by_V*v1_3
    z2_3_on_boundary_by_z10_by_V = carried_z2_3_by_z10_by_V + delay_tau1_by_z10*v2_3_by_V + delay_tau1_by_z10_by_V*v2_3
    z2_3_on_boundary_by_z20_by_V = carried_z2_3_by_z20_by_V + delay_tau1_by_z20*v2_3_by_V + delay_tau1_by_z20_by_V*v2_3
    t251 = t236*z1_3_by_V
    t252 = eta*t227
    v2_3_on_boundary_by_z10_by_V = carried_v2_3_by_z10_by_V + delay_tau1_by_z10*t251 - delay_tau1_by_z10*t252 + delay_tau1_by_z10_by_V*t60
    v2_3_on_boundary_by_z20_by_V = carried_v2_3_by_z20_by_V + delay_tau1_by_z20*t251 - delay_tau1_by_z20*t252 + delay_tau1_by_z20_by_V*t60
    # d/dz10 of: Phi along tau2
    carried_z2_4_by_z20_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_z10 + t38*z1_3_on_boundary_by_z20_by_z10 + t40*v2_3_on_boundary_by_z20_by_z10
    carried_v2_4_by_z10_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_z10 + t127*z1_3_on_boundary_by_z10_by_z10 - t127*z2_3_on_boundary_by_z10_by_z10
    carried_v2_4_by_z20_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_z10 + t127*z1_3_on_boundary_by_z20_by_z10 - t127*z2_3_on_boundary_by_z20_by_z10
    # d/dz20 of: Phi along tau2
    carried_z2_4_by_z20_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_z20 + t38*z1_3_on_boundary_by_z20_by_z20 + t40*v2_3_on_boundary_by_z20_by_z20
    carried_v2_4_by_z10_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_z20 + t127*z1_3_on_boundary_by_z10_by_z20 - t127*z2_3_on_boundary_by_z10_by_z20
    carried_v2_4_by_z20_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_z20 + t127*z1_3_on_boundary_by_z20_by_z20 - t127*z2_3_on_boundary_by_z20_by_z20
    # d/dtau of: Phi along tau2
    carried_z2_4_by_z20_by_tau = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_tau + t38*z1_3_on_boundary_by_z20_by_tau + t40*v2_3_on_boundary_by_z20_by_tau
    carried_v2_4_by_z10_by_tau = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_tau + t127*z1_3_on_boundary_by_z10_by_tau - t127*z2_3_on_boundary_by_z10_by_tau
    carried_v2_4_by_z20_by_tau = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_tau + t127*z1_3_on_boundary_by_z20_by_tau - t127*z2_3_on_boundary_by_z20_by_tau
    # d/dtau1 of: Phi along tau2
    carried_z2_4_by_z20_by_tau1 = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_tau1 + t38*z1_3_on_boundary_by_z20_by_tau1 + t40*v2_3_on_boundary_by_z20_by_tau1
    carried_v2_4_by_z10_by_tau1 = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_tau1 + t127*z1_3_on_boundary_by_z10_by_tau1 - t127*z2_3_on_boundary_by_z10_by_tau1
    carried_v2_4_by_z20_by_tau1 = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_tau1 + t127*z1_3_on_boundary_by_z20_by_tau1 - t127*z2_3_on_boundary_by_z20_by_tau1
    # d/dtau2 of: Phi along tau2
    t253 = -z1_3_on_boundary_by_z20 + z2_3_on_boundary_by_z20
    t254 = t39*v2_3_on_boundary_by_z20
    carried_z2_4_by_z20_by_tau2 = cos_omega3_tau2_by_tau2*t253 + sin_omega3_tau2_by_tau2*t254
    t255 = t61 - t62
    carried_v2_4_by_z10_by_tau2 = cos_omega3_tau2_by_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2_by_tau2*t255
    t256 = t63 - t64
    carried_v2_4_by_z20_by_tau2 = cos_omega3_tau2_by_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2_by_tau2*t256
    # d/dchi of: Phi along tau2
    t257 = t132*v2_3_on_boundary_by_z20
    carried_z2_4_by_z20_by_chi = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_chi + cos_omega3_tau2_by_chi*t253 - omega3_by_chi*t257 + sin_omega3_tau2_by_chi*t254 + t38*z1_3_on_boundary_by_z20_by_chi + t40*v2_3_on_boundary_by_z20_by_chi
    t258 = sin_omega3_tau2*z1_3_on_boundary_by_z10 - sin_omega3_tau2*z2_3_on_boundary_by_z10
    carried_v2_4_by_z10_by_chi = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_chi + cos_omega3_tau2_by_chi*v2_3_on_boundary_by_z10 + omega3_by_chi*t258 + sin_omega3_tau2_by_chi*t255 + t127*z1_3_on_boundary_by_z10_by_chi - t127*z2_3_on_boundary_by_z10_by_chi
    t259 = sin_omega3_tau2*z1_3_on_boundary_by_z20 - sin_omega3_tau2*z2_3_on_boundary_by_z20
    carried_v2_4_by_z20_by_chi = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_chi + cos_omega3_tau2_by_chi*v2_3_on_boundary_by_z20 + omega3_by_chi*t259 + sin_omega3_tau2_by_chi*t256 + t127*z1_3_on_boundary_by_z20_by_chi - t127*z2_3_on_boundary_by_z20_by_chi
    # d/deta of: Phi along tau2
    carried_z2_4_by_z20_by_eta = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_eta + cos_omega3_tau2_by_eta*t253 - omega3_by_eta*t257 + sin_omega3_tau2_by_eta*t254 + t38*z1_3_on_boundary_by_z20_by_eta + t40*v2_3_on_boundary_by_z20_by_eta
    carried_v2_4_by_z10_by_eta = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_eta + cos_omega3_tau2_by_eta*v2_3_on_boundary_by_z10 + omega3_by_eta*t258 + sin_omega3_tau2_by_eta*t255 + t127*z1_3_on_boundary_by_z10_by_eta - t127*z2_3_on_boundary_by_z10_by_eta
    carried_v2_4_by_z20_by_eta = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_eta + cos_omega3_tau2_by_eta*v2_3_on_boundary_by_z20 + omega3_by_eta*t259 + sin_omega3_tau2_by_eta*t256 + t127*z1_3_on_boundary_by_z20_by_eta - t127*z2_3_on_boundary_by_z20_by_eta
    # d/dV of: Phi along tau2
    carried_z2_4_by_z20_by_V = cos_omega3_tau2*z2_3_on_boundary_by_z20_by_V + t38*z1_3_on_boundary_by_z20_by_V + t40*v2_3_on_boundary_by_z20_by_V
    carried_v2_4_by_z10_by_V = cos_omega3_tau2*v2_3_on_boundary_by_z10_by_V + t127*z1_3_on_boundary_by_z10_by_V - t127*z2_3_on_boundary_by_z10_by_V
    carried_v2_4_by_z20_by_V = cos_omega3_tau2*v2_3_on_boundary_by_z20_by_V + t127*z1_3_on_boundary_by_z20_by_V - t127*z2_3_on_boundary_by_z20_by_V
    # d/dz10 of: rate of the exit boundary after tau2
    rate_4_by_z10 = -t236*z2_4_by_z10 + t237
    # d/dz20 of: rate of the exit boundary after tau2
    rate_4_by_z20 = -t236*z2_4_by_z20 + t239
    # d/dtau of: rate of the exit boundary after tau2
    rate_4_by_tau = -t236*z2_4_by_tau + t241
    # d/dtau1 of: rate of the exit boundary after tau2
    rate_4_by_tau1 = -t236*z2_4_by_tau1 + t243
    # d/dtau2 of: rate of the exit boundary after tau2
    rate_4_by_tau2 = eta*t45 - t236*z2_4_by_tau2
    # d/dchi of: rate of the exit boundary after tau2
    rate_4_by_chi = -t236*z2_4_by_chi + t246 + t65 - t66
    # d/deta of: rate of the exit boundary after tau2
    rate_4_by_eta = chi*z1_4 - chi*z2_4 - t236*z2_4_by_eta + t249
    # d/dV of: rate of the exit boundary after tau2
    rate_4_by_V = t236*z1_4_by_V - t236*z2_4_by_V
    # d/dz10 of: derivatives of the time to the boundary after tau2
    t260 = 1/rate_4**2
    t261 = rate_4_by_z10*t260
    delay_tau2_by_z10_by_z10 = carried_v2_4_by_z10*t261 - carried_v2_4_by_z10_by_z10*t67
    delay_tau2_by_z20_by_z10 = carried_v2_4_by_z20*t261 - carried_v2_4_by_z20_by_z10*t67
    # d/dz20 of: derivatives of the time to the boundary after tau2
    t262 = rate_4_by_z20*t260
    delay_tau2_by_z10_by_z20 = carried_v2_4_by_z10*t262 - carried_v2_4_by_z10_by_z20*t67
    delay_tau2_by_z20_by_z20 = carried_v2_4_by_z20*t262 - carried_v2_4_by_z20_by_z20*t67
    # d/dtau of: derivatives of the time to the boundary after tau2
    t263 = rate_4_by_tau*t260
    delay_tau2_by_z10_by_tau = carried_v2_4_by_z10*t263 - carried_v2_4_by_z10_by_tau*t67
    delay_tau2_by_z20_by_tau = carried_v2_4_by_z20*t263 - carried_v2_4_by_z20_by_tau*t67
    # d/dtau1 of: derivatives of the time to the boundary after tau2
    t264 = rate_4_by_tau1*t260
    delay_tau2_by_z10_by_tau1 = carried_v2_4_by_z10*t264 - carried_v2_4_by_z10_by_tau1*t67
    delay_tau2_by_z20_by_tau1 = carried_v2_4_by_z20*t264 - carried_v2_4_by_z20_by_tau1*t67
    # d/dtau2 of: derivatives of the time to the boundary after tau2
    t265 = rate_4_by_tau2*t260
    delay_tau2_by_z10_by_tau2 = carried_v2_4_by_z10*t265 - carried_v2_4_by_z10_by_tau2*t67
    delay_tau2_by_z20_by_tau2 = carried_v2_4_by_z20*t265 - carried_v2_4_by_z20_by_tau2*t67
    # d/dchi of: derivatives of the time to the boundary after tau2
    t266 = rate_4_by_chi*t260
    delay_tau2_by_z10_by_chi = carried_v2_4_by_z10*t266 - carried_v2_4_by_z10_by_chi*t67
    delay_tau2_by_z20_by_chi = carried_v2_4_by_z20*t266 - carried_v2_4_by_z20_by_chi*t67
    # d/deta of: derivatives of the time to the boundary after tau2
    t267 = rate_4_by_eta*t260
    delay_tau2_by_z10_by_eta = carried_v2_4_by_z10*t267 - carried_v2_4_by_z10_by_eta*t67
    delay_tau2_by_z20_by_eta = carried_v2_4_by_z20*t267 - carried_v2_4_by_z20_by_eta*t67
    # d/dV of: derivatives of the time to the boundary after tau2
    t268 = rate_4_by_V*t260
    delay_tau2_by_z10_by_V = carried_v2_4_by_z10*t268 - carried_v2_4_by_z10_by_V*t67
    delay_tau2_by_z20_by_V = carried_v2_4_by_z20*t268 - carried_v2_4_by_z20_by_V*t67
    # d/dz10 of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_z10 = V*delay_tau2_by_z10_by_z10 + z1_3_on_boundary_by_z10_by_z10
    z2_4_on_boundary_by_z20_by_z10 = carried_z2_4_by_z20_by_z10 + delay_tau2_by_z20*v2_4_by_z10 + delay_tau2_by_z20_by_z10*v2_4
    # d/dz20 of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_z20 = V*delay_tau2_by_z10_by_z20 + z1_3_on_boundary_by_z10_by_z20
    z2_4_on_boundary_by_z20_by_z20 = carried_z2_4_by_z20_by_z20 + delay_tau2_by_z20*v2_4_by_z20 + delay_tau2_by_z20_by_z20*v2_4
    # d/dtau of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_tau = V*delay_tau2_by_z10_by_tau + z1_3_on_boundary_by_z10_by_tau
    z2_4_on_boundary_by_z20_by_tau = carried_z2_4_by_z20_by_tau + delay_tau2_by_z20*v2_4_by_tau + delay_tau2_by_z20_by_tau*v2_4
    # d/dtau1 of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_tau1 = V*delay_tau2_by_z10_by_tau1 + z1_3_on_boundary_by_z10_by_tau1
    z2_4_on_boundary_by_z20_by_tau1 = carried_z2_4_by_z20_by_tau1 + delay_tau2_by_z20*v2_4_by_tau1 + delay_tau2_by_z20_by_tau1*v2_4
    # d/dtau2 of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_tau2 = V*delay_tau2_by_z10_by_tau2
    z2_4_on_boundary_by_z20_by_tau2 = carried_z2_4_by_z20_by_tau2 + delay_tau2_by_z20*v2_4_by_tau2 + delay_tau2_by_z20_by_tau2*v2_4
    # d/dchi of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_chi = V*delay_tau2_by_z10_by_chi + z1_3_on_boundary_by_z10_by_chi
    z2_4_on_boundary_by_z20_by_chi = carried_z2_4_by_z20_by_chi + delay_tau2_by_z20*v2_4_by_chi + delay_tau2_by_z20_by_chi*v2_4
    # d/deta of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_eta = V*delay_tau2_by_z10_by_eta + z1_3_on_boundary_by_z10_by_eta
    z2_4_on_boundary_by_z20_by_eta = carried_z2_4_by_z20_by_eta + delay_tau2_by_z20*v2_4_by_eta + delay_tau2_by_z20_by_eta*v2_4
    # d/dV of: perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10_by_V = V*delay_tau2_by_z10_by_V + delay_tau2_by_z10 + z1_3_on_boundary_by_z10_by_V
    z2_4_on_boundary_by_z20_by_V = carried_z2_4_by_z20_by_V + delay_tau2_by_z20*v2_4_by_V + delay_tau2_by_z20_by_V*v2_4
    return [z1_4_on_boundary_by_z10_by_z10 + z2_4_on_boundary_by_z20_by_z10, z1_4_on_boundary_by_z10_by_z20 + z2_4_on_boundary_by_z20_by_z20, z1_4_on_boundary_by_z10_by_tau + z2_4_on_boundary_by_z20_by_tau, z1_4_on_boundary_by_z10_by_tau1 + z2_4_on_boundary_by_z20_by_tau1, z1_4_on_boundary_by_z10_by_tau2 + z2_4_on_boundary_by_z20_by_tau2, 0, z1_4_on_boundary_by_z10_by_chi + z2_4_on_boundary_by_z20_by_chi, z1_4_on_boundary_by_z10_by_eta + z2_4_on_boundary_by_z20_by_eta, z1_4_on_boundary_by_z10_by_V + z2_4_on_boundary_by_z20_by_V, 0]


def solution_ii_states(parameters, spectrum, unknowns, lib):
    """State at the start and behind each transition, row by row.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives states (5, 4).
    Operations: 105. Intermediate terms: 29.
    """
    [chi, _, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
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
    t12 = sin_omega3_tau2/omega3
    z2_4 = V*(-t12 + tau2) + cos_omega3_tau2*z2_3 + t12*v2_3 + z1_3*(1 - cos_omega3_tau2)
    return [[z10, z20, V, V], [z10, z20, V, V], [z1_2, z2_2, v1_2, V], [z1_3, z2_3, V, v2_3], [z1_4, z2_4, V, V]]


def solution_ii_boundary_functions(parameters, spectrum, unknowns, lib):
    """Boundaries along the phases: constant, slope, cosine and sine amplitudes, one row after the other; and the frequencies of each phase.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives coefficients (44).
    Gives frequencies (4).
    Operations: 171. Intermediate terms: 43.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, _, e1] = unknowns
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
    # outputs
    t11 = chi*z20
    t12 = t11 - z10
    t14 = V*chi
    t15 = -V + t14
    t18 = chi*z10
    t19 = e2 - t11
    t20 = e2 + t11
    t21 = chi**2
    t22 = t21*z20
    t23 = V*t21 - t14
    t24 = -chi*t12
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
        [-e1 - t12, -t15, -e1 + t11 - z10, t15, -t18 - t19, 0, t18 - t20, 0, t15, 0, -t15, t12, -t19 - t22, -t23, -t24, -t25, -t20 + t22, t23, t24, t25, -V, 0, p1*v1_2 + t26, -t26 + t6*v1_2, -omega1*t28 - p1*t27, omega2*t28 - omega2*t6*z1_2, -V, 0, V*t6 + t29, V*p1 - t29, -omega1*t6*z2_2 - p3*t27, -omega2*p1*z2_2 + omega2*p3*z1_2, -e1 - t30 + z1_3, -t15, -t31, -t33, -e1 + t30 - z1_3, t15, t31, t33, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3],
        [1, omega1, omega2, omega3],
    )


def solution_ii_flow_stick_stick(parameters, spectrum, time, state, lib):
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


def solution_ii_flow_slip_stick(parameters, spectrum, time, state, lib):
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
    # outputs
    t0 = lib.sin(t)
    t1 = chi*t0
    t2 = lib.cos(t)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*t - t1), t*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def solution_ii_flow_slip_slip(parameters, spectrum, time, state, lib):
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


def solution_ii_flow_stick_slip(parameters, spectrum, time, state, lib):
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
    # outputs
    t0 = omega3*t
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [t*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(t - t2), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def solution_ii_reduced(parameters, spectrum, reduced, lib):
    """Reduced equations and their derivatives by the reduced unknowns.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (3): tau, tau1, e1.
    Gives residual (3).
    Gives jacobian (3, 3).
    Operations: 303. Intermediate terms: 99.
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
    # first return of tau2
    t26 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t26
    sin_tau2_return = -cosine_part_tau2*t26
    # tau2: first return
    t27 = 1/omega3
    tau2 = t27*lib.angle(sin_tau2_return, cos_tau2_return)
    # stick-stick for no time
    z1_5 = V*tau2 + sine_part_tau2*t27 + z2_3
    z2_5 = -amplitude_tau2*t27 + z1_5
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    sin_tau_by_tau = cos_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t29 = cos_tau_by_tau*e1
    z2_1_by_tau = V*sin_tau_by_tau - V - t29*t3
    # d/de1 of: z2_1: linear in second-breaks-forward
    z2_1_by_e1 = -t4
    # d/dtau of: slip-stick for tau
    t30 = V*chi
    t31 = V - t30
    z1_2_by_tau = chi*z2_1_by_tau + sin_tau_by_tau*t31 + t29 + t30
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = cos_tau_by_tau*t31 - e1*sin_tau_by_tau
    # d/de1 of: slip-stick for tau
    z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau
    v1_2_by_e1 = -sin_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t14*v1_2_by_tau + t15*z1_2_by_tau + t16*z2_2_by_tau
    z2_3_by_tau = t17*v1_2_by_tau + t18*z1_2_by_tau + t19*z2_2_by_tau
    v1_3_by_tau = t15*v1_2_by_tau + t22*z1_2_by_tau + t23*z2_2_by_tau
    v2_3_by_tau = t18*v1_2_by_tau + t24*z1_2_by_tau + t25*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t32 = chi*z2_3
    v1_3_by_tau1 = t32 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t32
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
    t33 = 2*cosine_part_tau2
    t34 = 2*sine_part_tau2
    t35 = t26/2
    amplitude_tau2_by_tau = t35*(sine_part_tau2_by_tau*t34 + t33*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t35*(sine_part_tau2_by_tau1*t34 + t33*v2_3_by_tau1)
    # d/de1 of: first return of tau2
    amplitude_tau2_by_e1 = t35*(sine_part_tau2_by_e1*t34 + t33*v2_3_by_e1)
    # d/dtau of: first return of tau2
    t36 = 1/amplitude_tau2**2
    cos_tau2_return_by_tau = -amplitude_tau2_by_tau*sine_part_tau2*t36 + sine_part_tau2_by_tau*t26
    sin_tau2_return_by_tau = amplitude_tau2_by_tau*cosine_part_tau2*t36 - t26*v2_3_by_tau
    # d/dtau1 of: first return of tau2
    cos_tau2_return_by_tau1 = -amplitude_tau2_by_tau1*sine_part_tau2*t36 + sine_part_tau2_by_tau1*t26
    sin_tau2_return_by_tau1 = amplitude_tau2_by_tau1*cosine_part_tau2*t36 - t26*v2_3_by_tau1
    # d/de1 of: first return of tau2
    cos_tau2_return_by_e1 = -amplitude_tau2_by_e1*sine_part_tau2*t36 + sine_part_tau2_by_e1*t26
    sin_tau2_return_by_e1 = amplitude_tau2_by_e1*cosine_part_tau2*t36 - t26*v2_3_by_e1
    # d/dtau of: tau2: first return
    t37 = t27/(cos_tau2_return**2 + sin_tau2_return**2)
    t38 = cos_tau2_return*t37
    t39 = sin_tau2_return*t37
    tau2_by_tau = -cos_tau2_return_by_tau*t39 + sin_tau2_return_by_tau*t38
    # d/dtau1 of: tau2: first return
    tau2_by_tau1 = -cos_tau2_return_by_tau1*t39 + sin_tau2_return_by_tau1*t38
    # d/de1 of: tau2: first return
    tau2_by_e1 = -cos_tau2_return_by_e1*t39 + sin_tau2_return_by_e1*t38
    # d/dtau of: stick-stick for no time
    z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t27 + z2_3_by_tau
    z2_5_by_tau = -amplitude_tau2_by_tau*t27 + z1_5_by_tau
    # d/dtau1 of: stick-stick for no time
    z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t27 + v2_3
    z2_5_by_tau1 = -amplitude_tau2_by_tau1*t27 + z1_5_by_tau1
    # d/de1 of: stick-stick for no time
    z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t27 + z2_3_by_e1
    z2_5_by_e1 = -amplitude_tau2_by_e1*t27 + z1_5_by_e1
    return (
        [-V + v1_3, -chi*z2_5 - e1 + z1_5, -z2_1 + z2_5],
        [[v1_3_by_tau, v1_3_by_tau1, v1_3_by_e1], [-chi*z2_5_by_tau + z1_5_by_tau, -chi*z2_5_by_tau1 + z1_5_by_tau1, -chi*z2_5_by_e1 + z1_5_by_e1 - 1], [-z2_1_by_tau + z2_5_by_tau, z2_5_by_tau1, -z2_1_by_e1 + z2_5_by_e1]],
    )


def solution_ii_expand(parameters, spectrum, reduced, lib):
    """All unknowns from the reduced ones.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (3): tau, tau1, e1.
    Gives unknowns (6).
    Operations: 124. Intermediate terms: 36.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1, e1] = reduced
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
    # outputs
    t16 = V*tau2 + sine_part_tau2*t15 + z2_3
    return [t16, -amplitude_tau2*t15 + t16, tau, tau1, tau2, e1]


def solution_ii_period_map(parameters, spectrum, unknowns, lib):
    """Compatibility and switching conditions, the start, and the map [N, c] of a turn, all from the unknowns but the start.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes unknowns (6): z10, z20, tau, tau1, tau2, e1.
    Gives residual (4).
    Gives start (2).
    Gives map (4, 5).
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
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*z1_2_by_v20 + cos_tau*z1_0 + z1_2_by_z20*z2_0
    z2_2 = V*tau + z2_0
    return (
        [V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0, V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0, -chi*z2_0 - e1 + z1_0, -chi*z1_2 + chi*z2_2 - e2],
        [z1_0, z2_0],
        [[z1_4_by_z10, z1_4_by_z20, z1_4_by_v10, z1_4_by_v20, 0], [z2_4_by_z10, z2_4_by_z20, z2_4_by_v10, z2_4_by_v20, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_v10, v1_3_by_v20, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_v10, v2_4_by_v20, 0]],
    )
