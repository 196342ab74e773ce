# Generated; do not edit.
# Source: nonsmooth.derive.systems.dry_friction
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation e3765aa45fa93668
"""Kernels and tables of the system dry-friction, over any arithmetic ``lib``."""

DERIVATION = "e3765aa45fa93668"

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
 'solution_ii_expand': ([(4,), (7,), (3,)], [(6,)])}

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
    Operations: 662. Intermediate terms: 146.
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
    # back through: derivatives of the time to the boundary after tau1
    slope_by_delay_tau1_by_v10 = chi*z2_2 - z1_2
    # back through: rate of the exit boundary after tau1
    t53 = 1/rate_2**2
    slope_by_rate_2 = -V*t50*t53 - slope_by_delay_tau1_by_v10*t52*t53
    # back through: Phi along tau1
    t54 = slope_by_delay_tau1_by_v10*t48
    slope_by_carried_z1_2_by_v10 = chi*t54
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
    t57 = 1/rate_1**2
    slope_by_rate_1 = carried_v2_1_by_v10*slope_by_delay_tau_by_v10*t57 + carried_v2_1_by_z20*slope_by_delay_tau_by_z20*t57
    # back through: Phi along tau
    slope_by_carried_v2_1_by_v10 = -slope_by_delay_tau_by_v10*t45
    slope_by_carried_v2_1_by_z20 = -slope_by_delay_tau_by_z20*t45
    # back through: slip-stick for tau1, until second-breaks-forward
    t58 = chi*slope_by_rate_2
    slope_by_v1_2 = -t58
    slope_by_z2_2 = chi*delay_tau1_by_v10
    slope_by_z1_2 = -delay_tau1_by_v10
    # back through: functions of tau1 in slip-stick
    t59 = -t47 + v1_1
    t60 = t51 - z1_1_on_boundary_by_v10
    slope_by_sin_tau1 = slope_by_carried_z1_2_by_v10*v1_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*v1_1_on_boundary_by_z20 + slope_by_v1_2*t46 + slope_by_z1_2*t59 + t60
    slope_by_cos_tau1 = -slope_by_carried_z1_2_by_v10*t60 + slope_by_carried_z1_2_by_z20*(-t49 + z1_1_on_boundary_by_z20) + slope_by_v1_2*t59 - slope_by_z1_2*t46 + v1_1_on_boundary_by_v10
    # back through: slip-slip for tau, until second-reaches-belt
    slope_by_v2_1 = delay_tau_by_v10*slope_by_z2_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z2_1_on_boundary_by_z20
    slope_by_v1_1 = cos_tau1*slope_by_v1_2 + delay_tau_by_v10*slope_by_z1_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z1_1_on_boundary_by_z20 + sin_tau1*slope_by_z1_2
    t61 = delay_tau_by_v10*slope_by_v1_1_on_boundary_by_v10
    t62 = delay_tau_by_z20*slope_by_v1_1_on_boundary_by_z20
    t63 = -chi*eta*slope_by_rate_1
    slope_by_z2_1 = chi*t61 + chi*t62 + slope_by_v1_2*t41 + slope_by_z1_2*t40 + slope_by_z2_2 + t63
    slope_by_z1_1 = cos_tau1*slope_by_z1_2 - sin_tau1*slope_by_v1_2 - t61 - t62 - t63
    # back through: functions of tau in slip-slip
    t64 = omega2*p2
    t65 = V*p2
    t66 = V*p1
    t67 = p3*v10
    t68 = p3*slope_by_z2_1_on_boundary_by_v10
    slope_by_sin_omega2_tau = slope_by_carried_v2_1_by_z20*(omega2*p3 - t34) + slope_by_v1_1*(-t24*z10 + t64*z20) + slope_by_v1_1_on_boundary_by_z20*(-t24 + t64) + slope_by_v2_1*(omega2*p3*z10 - t34*z20) + slope_by_z1_1*(-t65*t8 - t8*t9*v10) - slope_by_z1_1_on_boundary_by_v10*t8*t9 + slope_by_z2_1*(t66*t8 - t67*t8) - t68*t8
    t69 = p2*z20
    t70 = p1*z20
    t71 = p3*z10
    t72 = p3*slope_by_carried_v2_1_by_v10
    slope_by_cos_omega2_tau = slope_by_v1_1*(-t65 - t9*v10) - slope_by_v1_1_on_boundary_by_v10*t9 + slope_by_v2_1*(t66 - t67) + slope_by_z1_1*(-t69 - t9*z10) + slope_by_z1_1_on_boundary_by_z20*(-p2 - t9) + slope_by_z2_1*(t70 - t71) + slope_by_z2_1_on_boundary_by_z20*(p1 - p3) - t72
    t73 = p1*v10
    t74 = -V*t9
    slope_by_sin_omega1_tau = p1*slope_by_z1_1_on_boundary_by_v10*t6 + slope_by_carried_v2_1_by_z20*(-t31 - t35) + slope_by_v1_1*(-omega1*t69 - t25*z10) + slope_by_v1_1_on_boundary_by_z20*(-t25 - t28) + slope_by_v2_1*(-omega1*t71 - t35*z20) + slope_by_z1_1*(t6*t65 + t6*t73) + slope_by_z2_1*(t6*t67 + t6*t74) + t6*t68
    t75 = p1*z10
    t76 = -t9*z20
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_v10 + slope_by_v1_1*(t65 + t73) + slope_by_v2_1*(t67 + t74) + slope_by_z1_1*(t69 + t75) + slope_by_z1_1_on_boundary_by_z20*(p1 + p2) + slope_by_z2_1*(t71 + t76) + slope_by_z2_1_on_boundary_by_z20*(-p1 + p3 + 1) + t72
    # outputs
    t77 = sin_omega2_tau*slope_by_cos_omega2_tau
    t78 = sin_omega1_tau*slope_by_cos_omega1_tau
    t79 = p3*sin_omega1_tau
    t80 = 1/omega1**2
    t81 = sin_omega1_tau*t80
    t82 = cos_omega1_tau*slope_by_sin_omega1_tau*tau + slope_by_carried_v2_1_by_z20*(-t22 - t79) + slope_by_v1_1*(-sin_omega1_tau*t69 - sin_omega1_tau*t75) + slope_by_v1_1_on_boundary_by_z20*(-p2*sin_omega1_tau - t7) + slope_by_v2_1*(-sin_omega1_tau*t71 - sin_omega1_tau*t76) + slope_by_z1_1*(-t65*t81 - t73*t81) - slope_by_z1_1_on_boundary_by_v10*t7*t80 + slope_by_z2_1*(-t67*t81 - t74*t81) - slope_by_z2_1_on_boundary_by_v10*t79*t80 - t78*tau
    t83 = 1/omega2**2
    t84 = sin_omega2_tau*t83
    t85 = cos_omega2_tau*slope_by_sin_omega2_tau*tau + slope_by_carried_v2_1_by_z20*(p3*sin_omega2_tau - t21) + slope_by_v1_1*(sin_omega2_tau*t69 + sin_omega2_tau*t9*z10) + slope_by_v1_1_on_boundary_by_z20*(-t11 + t15) + slope_by_v2_1*(p3*sin_omega2_tau*z10 - sin_omega2_tau*t70) + slope_by_z1_1*(t65*t84 + t84*t9*v10) - slope_by_z1_1_on_boundary_by_v10*t11*t83 + slope_by_z2_1*(p3*sin_omega2_tau*t83*v10 - t66*t84) + slope_by_z2_1_on_boundary_by_v10*t17*t83 - t77*tau
    t86 = omega1*sin_omega1_tau - omega2*sin_omega2_tau
    t87 = cos_omega1_tau - cos_omega2_tau
    t89 = -t86*z10 + t87*v10
    t91 = -sin_omega1_tau*t6 + sin_omega2_tau*t8
    t93 = t87*z10 - t91*v10
    t94 = -slope_by_v1_1_on_boundary_by_z20*t86 + slope_by_z1_1_on_boundary_by_z20*t87
    t95 = slope_by_carried_v2_1_by_z20*t86 + slope_by_v1_1*t89 + slope_by_v1_1_on_boundary_by_v10*t87 + slope_by_v2_1*(-V*t87 + t86*z20) + slope_by_z1_1*t93 - slope_by_z1_1_on_boundary_by_v10*t91 + slope_by_z2_1*(V*t91 - t87*z20) - slope_by_z2_1_on_boundary_by_z20*t87 + t94
    t96 = slope_by_v1_1*(V*t87 - t86*z20) + slope_by_z1_1*(-V*t91 + t87*z20) + t94
    t97 = slope_by_carried_v2_1_by_v10*t87 - slope_by_carried_v2_1_by_z20*t86 + slope_by_v2_1*t89 + slope_by_z2_1*t93 - slope_by_z2_1_on_boundary_by_v10*t91 + slope_by_z2_1_on_boundary_by_z20*t87
    t98 = 1 - cos_tau1
    return [-slope_by_v1_1*t26 - slope_by_v2_1*t32 + slope_by_z1_1*t13 + slope_by_z2_1*t19, -slope_by_v1_1*t29 - slope_by_v2_1*t36 + slope_by_z1_1*t14 + slope_by_z2_1*t20, slope_by_v1_1*t13 + slope_by_v2_1*t19 + slope_by_z1_1*t12 + slope_by_z2_1*t18, cos_omega1_tau*omega1*slope_by_sin_omega1_tau + cos_omega2_tau*omega2*slope_by_sin_omega2_tau - omega1*t78 - omega2*t77, V*slope_by_z2_2 + cos_tau1*slope_by_sin_tau1 - sin_tau1*slope_by_cos_tau1 + slope_by_z1_2*t47, V*t48*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + delay_tau1_by_v10*z2_2 + omega1_by_chi*t82 + omega2_by_chi*t85 + p1_by_chi*t95 + p2_by_chi*t96 + p3_by_chi*t97 + sin_tau1*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_v10*t98*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*t98*z2_1_on_boundary_by_z20 + slope_by_rate_1*(-eta*z2_1 + t43) + slope_by_rate_2*(V - v1_2) + slope_by_v1_2*(V*t98 + sin_tau1*z2_1) + slope_by_z1_2*(V*(-sin_tau1 + tau1) + t98*z2_1) + t54*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10) + t61*z2_1 + t62*z2_1, omega1_by_eta*t82 + omega2_by_eta*t85 + p1_by_eta*t95 + p2_by_eta*t96 + p3_by_eta*t97 + slope_by_rate_1*(chi*z1_1 - t44), delay_tau1_by_z20 + slope_by_v1_1*t14 + slope_by_v1_2*t40 + slope_by_v2_1*t20 + slope_by_z1_1*t16 + slope_by_z1_2*t42 + slope_by_z2_1*t23 + slope_by_z2_2*tau1 + t58, 0]


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
    Operations: 773. Intermediate terms: 174.
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
    # back through: d/dtau1 of: first return of tau2
    t52 = 1/v1_3_by_tau1
    t53 = 1/z2_1_by_tau
    t54 = 1/omega3
    t55 = t4*t54
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
    t60 = amplitude_tau2_by_tau1*v1_3_by_tau
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
    slope_by_z2_1_by_tau = chi*slope_by_z1_2_by_tau + slope_by_z2_2_by_tau - (amplitude_tau2_by_tau*t55 - t52*t55*t60)/z2_1_by_tau**2
    # back through: d/dtau of: functions of tau in slip-stick
    slope_by_sin_tau_by_tau = V*slope_by_z2_1_by_tau - e1*slope_by_v1_2_by_tau + slope_by_z1_2_by_tau*t42
    slope_by_cos_tau_by_tau = e1*slope_by_z1_2_by_tau + slope_by_v1_2_by_tau*t42 - slope_by_z2_1_by_tau*t5
    # back through: first return of tau2
    t62 = 1/(2*amplitude_tau2**2)
    slope_by_amplitude_tau2 = -slope_by_amplitude_tau2_by_tau*t48*t62 - slope_by_amplitude_tau2_by_tau1*t51*t62
    # back through: first return of tau2
    t63 = slope_by_amplitude_tau2_by_tau*t49
    t64 = slope_by_amplitude_tau2_by_tau1*t49
    slope_by_sine_part_tau2 = sine_part_tau2_by_tau*t63 + sine_part_tau2_by_tau1*t64 + slope_by_amplitude_tau2*t58
    slope_by_cosine_part_tau2 = slope_by_amplitude_tau2*t59 + t63*v2_3_by_tau + t64*v2_3_by_tau1
    # back through: slip-slip for tau1
    t66 = omega3*slope_by_sine_part_tau2_by_tau1
    slope_by_v2_3 = slope_by_cosine_part_tau2 - t66
    slope_by_v1_3 = t66
    t67 = chi*eta*slope_by_v2_3_by_tau1 + omega3*slope_by_sine_part_tau2
    slope_by_z2_3 = chi*slope_by_v1_3_by_tau1 - t67
    slope_by_z1_3 = -slope_by_v1_3_by_tau1 + t67
    # back through: functions of tau1 in slip-slip
    t68 = p2*z2_2
    t69 = t21*z1_2
    t70 = p2*z2_2_by_tau
    t71 = t21*z1_2_by_tau
    t72 = p1*z2_2
    t73 = p1*z2_2_by_tau
    t74 = V*p2
    t75 = V*p1
    t76 = p3*v1_2
    t77 = slope_by_z1_3_by_tau*v1_2_by_tau
    t78 = t21*t77
    t79 = p3*v1_2_by_tau
    t80 = slope_by_z2_3_by_tau*t79
    slope_by_sin_omega2_tau1 = slope_by_v1_3*(omega2*t68 - omega2*t69) + slope_by_v1_3_by_tau*(omega2*t70 - omega2*t71) + slope_by_v2_3*(omega2*p3*z1_2 - omega2*t72) + slope_by_v2_3_by_tau*(omega2*p3*z1_2_by_tau - omega2*t73) + slope_by_z1_3*(t21*t22*v1_2 - t22*t74) + slope_by_z2_3*(t22*t75 - t22*t76) + t22*t78 - t22*t80
    t81 = p3*z1_2
    t82 = p3*z1_2_by_tau
    t83 = slope_by_v1_3_by_tau*v1_2_by_tau
    t84 = slope_by_v2_3_by_tau*t79
    slope_by_cos_omega2_tau1 = slope_by_v1_3*(t21*v1_2 - t74) + slope_by_v2_3*(t75 - t76) + slope_by_z1_3*(t21*z1_2 - t68) + slope_by_z1_3_by_tau*(t21*z1_2_by_tau - t70) + slope_by_z2_3*(t72 - t81) + slope_by_z2_3_by_tau*(t73 - t82) + t21*t83 - t84
    t85 = p1*z1_2
    t86 = p1*z1_2_by_tau
    t87 = t21*z2_2
    t88 = t21*z2_2_by_tau
    t89 = p1*v1_2
    t90 = V*t21
    t91 = p1*t77
    slope_by_sin_omega1_tau1 = slope_by_v1_3*(-omega1*t68 - omega1*t85) + slope_by_v1_3_by_tau*(-omega1*t70 - omega1*t86) + slope_by_v2_3*(-omega1*t81 - omega1*t87) + slope_by_v2_3_by_tau*(-omega1*t82 - omega1*t88) + slope_by_z1_3*(t19*t74 + t19*t89) + slope_by_z2_3*(t19*t76 + t19*t90) + t19*t80 + t19*t91
    slope_by_cos_omega1_tau1 = p1*t83 + slope_by_v1_3*(t74 + t89) + slope_by_v2_3*(t76 + t90) + slope_by_z1_3*(t68 + t85) + slope_by_z1_3_by_tau*(t70 + t86) + slope_by_z2_3*(t81 + t87) + slope_by_z2_3_by_tau*(t82 + t88) + t84
    # back through: slip-stick for tau
    slope_by_v1_2 = slope_by_v1_3*t25 + slope_by_v2_3*t29 + slope_by_z1_3*t24 + slope_by_z2_3*t28
    slope_by_z2_2 = slope_by_v1_3*t35 + slope_by_v2_3*t37 + slope_by_z1_3*t26 + slope_by_z2_3*t30
    slope_by_z1_2 = slope_by_v1_3*t34 + slope_by_v2_3*t36 + slope_by_z1_3*t25 + slope_by_z2_3*t29
    # back through: z2_1: linear in second-breaks-forward
    slope_by_z2_1 = chi*slope_by_z1_2 + slope_by_z2_2
    # back through: functions of tau in slip-stick
    t92 = V*slope_by_z2_1
    slope_by_sin_tau = -e1*slope_by_v1_2 + slope_by_z1_2*t42 + t92
    slope_by_cos_tau = e1*slope_by_z1_2 + slope_by_v1_2*t42 - slope_by_z2_1*t5
    # outputs
    t93 = sin_omega2_tau1*slope_by_cos_omega2_tau1
    t94 = sin_omega1_tau1*slope_by_cos_omega1_tau1
    t95 = sin_omega1_tau1/omega1**2
    t96 = cos_omega1_tau1*slope_by_sin_omega1_tau1*tau1 + slope_by_v1_3*(-sin_omega1_tau1*t68 - sin_omega1_tau1*t85) + slope_by_v1_3_by_tau*(-sin_omega1_tau1*t70 - sin_omega1_tau1*t86) + slope_by_v2_3*(-sin_omega1_tau1*t81 - sin_omega1_tau1*t87) + slope_by_v2_3_by_tau*(-sin_omega1_tau1*t82 - sin_omega1_tau1*t88) + slope_by_z1_3*(-t74*t95 - t89*t95) + slope_by_z2_3*(-t76*t95 - t90*t95) - t80*t95 - t91*t95 - t94*tau1
    t97 = 1/omega2**2
    t98 = sin_omega2_tau1*t97
    t99 = cos_omega2_tau1*slope_by_sin_omega2_tau1*tau1 + slope_by_v1_3*(sin_omega2_tau1*t68 - sin_omega2_tau1*t69) + slope_by_v1_3_by_tau*(sin_omega2_tau1*t70 - sin_omega2_tau1*t71) + slope_by_v2_3*(p3*sin_omega2_tau1*z1_2 - sin_omega2_tau1*t72) + slope_by_v2_3_by_tau*(p3*sin_omega2_tau1*z1_2_by_tau - sin_omega2_tau1*t73) + slope_by_z1_3*(-t21*t98*v1_2 + t74*t98) + slope_by_z2_3*(p3*sin_omega2_tau1*t97*v1_2 - t75*t98) - t78*t98 + t80*t98 - t93*tau1
    t100 = 1/omega3**2
    t101 = slope_by_sine_part_tau2*(z1_3 - z2_3) + slope_by_sine_part_tau2_by_tau*(z1_3_by_tau - z2_3_by_tau) + slope_by_sine_part_tau2_by_tau1*(v1_3 - v2_3) + t53*(-amplitude_tau2_by_tau*t100*t4 + amplitude_tau2_by_tau1*t100*t4*t52*v1_3_by_tau)
    t102 = cos_omega1_tau1 - cos_omega2_tau1
    t103 = -omega2*sin_omega2_tau1 + t33
    t105 = t102*v1_2 - t103*z1_2
    t106 = t102*v1_2_by_tau - t103*z1_2_by_tau
    t108 = -sin_omega1_tau1*t19 + t23
    t110 = t102*z1_2 - t108*v1_2
    t111 = t102*z1_2_by_tau - t108*v1_2_by_tau
    t112 = slope_by_v1_3*t105 + slope_by_v1_3_by_tau*t106 + slope_by_v2_3*(-V*t102 + t103*z2_2) + slope_by_v2_3_by_tau*t103*z2_2_by_tau + slope_by_z1_3*t110 + slope_by_z1_3_by_tau*t111 + slope_by_z2_3*(V*t108 - t102*z2_2) - slope_by_z2_3_by_tau*t102*z2_2_by_tau
    t113 = slope_by_v1_3*(V*t102 - t103*z2_2) - slope_by_v1_3_by_tau*t103*z2_2_by_tau + slope_by_z1_3*(-V*t108 + t102*z2_2) + slope_by_z1_3_by_tau*t102*z2_2_by_tau
    t114 = slope_by_v2_3*t105 + slope_by_v2_3_by_tau*t106 + slope_by_z2_3*t110 + slope_by_z2_3_by_tau*t111
    t115 = 1 - cos_tau
    t116 = sin_tau - tau
    t117 = 1/t3**2
    t118 = cos_tau_by_tau*slope_by_v1_2_by_tau
    t120 = slope_by_z2_1*t4
    return [0, 0, 0, V*chi*slope_by_z1_2 + V*slope_by_z2_2 - cos_tau*slope_by_cos_tau_by_tau + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau - sin_tau*slope_by_sin_tau_by_tau - t92, cos_omega1_tau1*omega1*slope_by_sin_omega1_tau1 + cos_omega2_tau1*omega2*slope_by_sin_omega2_tau1 - omega1*t94 - omega2*t93, 0, V*slope_by_v1_2*t115 - V*t118 + omega1_by_chi*t96 + omega2_by_chi*t99 + omega3_by_chi*t101 + p1_by_chi*t112 + p2_by_chi*t113 + p3_by_chi*t114 + slope_by_v1_3_by_tau1*z2_3 + slope_by_v2_3_by_tau1*(-eta*z2_3 + t45) + slope_by_z1_2*(-V*t116 + cos_tau*z2_1 + t115*z2_1) + slope_by_z1_2_by_tau*(t39 + z2_2_by_tau) + slope_by_z2_1*(cos_tau*e1*t117 + t117*t7 + e2*t4/chi**2) + slope_by_z2_1_by_tau*t117*t40 + t53*(-amplitude_tau2_by_tau*t117*t54 + amplitude_tau2_by_tau1*t117*t52*t54*v1_3_by_tau), omega1_by_eta*t96 + omega2_by_eta*t99 + omega3_by_eta*t101 + p1_by_eta*t112 + p2_by_eta*t113 + p3_by_eta*t114 + slope_by_v2_3_by_tau1*(chi*z1_3 - t44), -slope_by_cosine_part_tau2 + slope_by_v1_2*(chi + cos_tau - t10) + slope_by_v1_3*t26 + slope_by_v2_3*t30 + slope_by_z1_2*(chi*tau + sin_tau - t12) + slope_by_z1_2_by_tau*(chi - sin_tau_by_tau*t3) + slope_by_z1_3*t27 + slope_by_z2_1*t116 + slope_by_z2_1_by_tau*(sin_tau_by_tau - 1) + slope_by_z2_2*tau + slope_by_z2_2_by_tau + slope_by_z2_3*t31 - t118*t3, cos_tau*slope_by_z1_2 - cos_tau*t120 + cos_tau_by_tau*slope_by_z1_2_by_tau - cos_tau_by_tau*slope_by_z2_1_by_tau*t4 - sin_tau*slope_by_v1_2 - sin_tau_by_tau*slope_by_v1_2_by_tau, -t120*t6]


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
    Operations: 1108. Intermediate terms: 246.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
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
    # outputs
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
    return [cos_tau*slope_by_z1_2 - sin_tau*slope_by_v1_2, slope_by_v1_2*t4 + slope_by_z1_2*t3 + slope_by_z2_2, V*slope_by_z2_2 + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau + slope_by_z1_2*t39, cos_omega1_tau1*omega1*slope_by_sin_omega1_tau1 + cos_omega2_tau1*omega2*slope_by_sin_omega2_tau1 - omega1*t120 - omega2*t119, V*slope_by_z1_4 + V*slope_by_z2_4 + omega3*t121 - omega3*t122, 0, -V*slope_by_rate_1 + omega1_by_chi*t125 + omega2_by_chi*t129 + omega3_by_chi*t131 + p1_by_chi*t144 + p2_by_chi*t145 + p3_by_chi*t146 + slope_by_carried_z1_2_by_z10*t147*z2_1_on_boundary_by_z10 + slope_by_carried_z1_2_by_z20*t147*z2_1_on_boundary_by_z20 + slope_by_delay_ta_by_z20*t41 + slope_by_delay_tau_by_z10*t44*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10) + slope_by_delay_tau_by_z20*t44*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + slope_by_rate_2*(V - v1_2) + slope_by_rate_3*z2_3 + slope_by_rate_4*(t58 - t59) + slope_by_v1_2*(V*t147 + sin_tau*z20) + slope_by_z1_2*(V*(-sin_tau + tau) + t147*z20) + t114*z2_2 + t115*z2_2 + t148*t75 + t148*t76 + t70*z2_1_on_boundary_by_z20 + t71*z2_1_on_boundary_by_z10, omega1_by_eta*t125 + omega2_by_eta*t129 + omega3_by_eta*t131 + p1_by_eta*t144 + p2_by_eta*t145 + p3_by_eta*t146 + slope_by_rate_4*(chi*z1_4 - chi*z2_4) + t149*t75 + t149*t76, delay_ta_by_z10*slope_by_z1_1_on_boundary_by_z10 + delay_ta_by_z10*slope_by_z2_1_on_boundary_by_z10 + delay_ta_by_z20*slope_by_z1_1_on_boundary_by_z20 + delay_ta_by_z20*slope_by_z2_1_on_boundary_by_z20 + delay_tau2_by_z10 + delay_tau2_by_z20*t33 + delay_tau_by_z10*slope_by_z2_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z2_2_on_boundary_by_z20 + slope_by_rate_1*(1 - chi) + slope_by_v1_2*(chi + cos_tau - t2) + slope_by_v1_3*t18 + slope_by_v2_3*t22 + slope_by_z1_2*(chi*tau + sin_tau - t4) + slope_by_z1_3*t19 + slope_by_z1_4*tau2 + slope_by_z2_2*tau + slope_by_z2_3*t23 + slope_by_z2_4*t36 + t113, 0]


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
