# Generated; do not edit.
# Source: nonsmooth.derive.systems.dry_friction
# Again: python scripts/regenerate.py
# SymPy 1.14.0, derivation a9cad82ee1ca7804
"""Kernels and tables of the system dry-friction, over any arithmetic ``lib``."""

import json

DERIVATION = "a9cad82ee1ca7804"

SYSTEM = json.loads(r"""{
 "name": "dry-friction",
 "description": "two coupled oscillators on a driving belt with dry friction (Sec. 3)",
 "states": ["x1", "x2", "v1", "v2"],
 "parameters": [
  {"name": "chi", "description": "stiffness ratio k2/(k1 + k2), nondimensional", "lower": "0", "upper": "1",
   "closed": false, "upper_closed": false},
  {"name": "eta", "description": "mass ratio m1/m2, nondimensional", "lower": "0", "upper": null, "closed": false,
   "upper_closed": false},
  {"name": "V", "description": "velocity of the belt, nondimensional", "lower": "0", "upper": null, "closed": false,
   "upper_closed": false},
  {"name": "us1", "description": "slipping friction force on the first mass, nondimensional", "lower": "0",
   "upper": null, "closed": false, "upper_closed": false},
  {"name": "ur1", "description": "static friction force on the first mass, nondimensional", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false},
  {"name": "us2", "description": "slipping friction force on the second mass, nondimensional", "lower": "0",
   "upper": null, "closed": false, "upper_closed": false},
  {"name": "ur2", "description": "static friction force on the second mass, nondimensional", "lower": "0", "upper": null,
   "closed": false, "upper_closed": false}
 ],
 "constraints": [
  {"text": "ur1 - us1 >= 0", "terms": {"ur1": 1, "us1": -1}},
  {"text": "ur2 - us2 >= 0", "terms": {"ur2": 1, "us2": -1}}
 ],
 "configurations": {
  "slip-slip": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-reaches-belt",
   "acts_when": "reached"}],
  "slip-stick": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-breaks-forward",
   "acts_when": "exceeded"}, {"name": "second-breaks-backward", "acts_when": "exceeded"}],
  "slip-overshoot": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-reaches-belt",
   "acts_when": "reached"}],
  "stick-slip": [{"name": "first-breaks-forward", "acts_when": "exceeded"}, {"name": "first-breaks-backward",
   "acts_when": "exceeded"}, {"name": "second-reaches-belt", "acts_when": "reached"}],
  "stick-stick": [{"name": "first-breaks-forward", "acts_when": "exceeded"}, {"name": "first-breaks-backward",
   "acts_when": "exceeded"}, {"name": "second-breaks-forward", "acts_when": "exceeded"},
   {"name": "second-breaks-backward", "acts_when": "exceeded"}],
  "stick-overshoot": [{"name": "first-breaks-forward", "acts_when": "exceeded"}, {"name": "first-breaks-backward",
   "acts_when": "exceeded"}, {"name": "second-reaches-belt", "acts_when": "reached"}],
  "overshoot-slip": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-reaches-belt",
   "acts_when": "reached"}],
  "overshoot-stick": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-breaks-forward",
   "acts_when": "exceeded"}, {"name": "second-breaks-backward", "acts_when": "exceeded"}],
  "overshoot-overshoot": [{"name": "first-reaches-belt", "acts_when": "reached"}, {"name": "second-reaches-belt",
   "acts_when": "reached"}]
 },
 "spectrum": ["gap1", "omega1", "omega2", "p1", "p2", "p3", "omega3"],
 "spectrum_parameters": ["chi", "eta"],
 "modes": {
  "slip-slip": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1, "oscillates": true}],
  "slip-stick": [{"length": 2, "oscillates": false}, {"length": 1, "oscillates": true}],
  "slip-overshoot": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1,
   "oscillates": true}],
  "stick-slip": [{"length": 2, "oscillates": false}, {"length": 1, "oscillates": true}],
  "stick-stick": [{"length": 2, "oscillates": false}],
  "stick-overshoot": [{"length": 2, "oscillates": false}, {"length": 1, "oscillates": true}],
  "overshoot-slip": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1,
   "oscillates": true}],
  "overshoot-stick": [{"length": 2, "oscillates": false}, {"length": 1, "oscillates": true}],
  "overshoot-overshoot": [{"length": 1, "oscillates": false}, {"length": 1, "oscillates": true}, {"length": 1,
   "oscillates": true}]
 },
 "forcing": [],
 "coordinates": [["x1", "v1"], ["x2", "v2"]],
 "held": {
  "slip-slip": [],
  "slip-stick": ["x2"],
  "slip-overshoot": [],
  "stick-slip": ["x1"],
  "stick-stick": ["x1", "x2"],
  "stick-overshoot": ["x1"],
  "overshoot-slip": [],
  "overshoot-stick": ["x2"],
  "overshoot-overshoot": []
 },
 "constraint_rows": {
  "slip-slip": [],
  "slip-stick": [1],
  "slip-overshoot": [],
  "stick-slip": [0],
  "stick-stick": [0, 1],
  "stick-overshoot": [0],
  "overshoot-slip": [],
  "overshoot-stick": [1],
  "overshoot-overshoot": []
 },
 "boundary_rows": {
  "slip-slip": [0, 1],
  "slip-stick": [0, 2, 3],
  "slip-overshoot": [0, 4],
  "stick-slip": [5, 6, 1],
  "stick-stick": [5, 6, 2, 3],
  "stick-overshoot": [5, 6, 4],
  "overshoot-slip": [7, 1],
  "overshoot-stick": [7, 2, 3],
  "overshoot-overshoot": [7, 4]
 },
 "transitions": [
  {"source": "slip-slip", "boundaries": ["second-reaches-belt"], "conditions": [[2, "slip-stick", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "slip-slip", "boundaries": ["second-reaches-belt"], "conditions": [[3, "slip-stick", true]], "reset": 0,
   "target": "slip-overshoot"},
  {"source": "slip-slip", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1, "target": "slip-stick"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-slip", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-slip", true]], "reset": 0,
   "target": "overshoot-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2, "target": "stick-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5, "stick-stick",
   true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5, "stick-stick",
   true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5, "stick-stick",
   true]], "reset": 1, "target": "slip-stick"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6, "stick-stick",
   true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6, "stick-stick",
   true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6, "stick-stick",
   true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[2, "stick-stick",
   true]], "reset": 2, "target": "stick-slip"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[3, "stick-stick",
   true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "slip-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "slip-stick", "boundaries": ["second-breaks-forward"], "conditions": [[2, "slip-stick", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "slip-stick", "boundaries": ["second-breaks-forward"], "conditions": [[3, "slip-stick", true]], "reset": 0,
   "target": "slip-overshoot"},
  {"source": "slip-stick", "boundaries": ["second-breaks-forward"], "conditions": [], "reset": 1, "target": "slip-stick"},
  {"source": "slip-stick", "boundaries": ["second-breaks-backward"], "conditions": [[2, "slip-stick", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "slip-stick", "boundaries": ["second-breaks-backward"], "conditions": [[3, "slip-stick", true]], "reset": 0,
   "target": "slip-overshoot"},
  {"source": "slip-stick", "boundaries": ["second-breaks-backward"], "conditions": [], "reset": 1,
   "target": "slip-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-stick", true]], "reset": 0,
   "target": "slip-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-stick", true]], "reset": 0,
   "target": "overshoot-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2, "target": "stick-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "slip-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "slip-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[2, "slip-stick", true]],
   "reset": 0, "target": "slip-slip"},
  {"source": "slip-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[3, "slip-stick", true]],
   "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1,
   "target": "slip-stick"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-overshoot", true]],
   "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-overshoot", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2,
   "target": "stick-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "slip-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "stick-slip", "boundaries": ["second-reaches-belt"], "conditions": [[2, "stick-stick", true]], "reset": 0,
   "target": "stick-slip"},
  {"source": "stick-slip", "boundaries": ["second-reaches-belt"], "conditions": [[3, "stick-stick", true]], "reset": 0,
   "target": "stick-overshoot"},
  {"source": "stick-slip", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1, "target": "stick-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward"], "conditions": [[5, "stick-slip", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward"], "conditions": [[6, "stick-slip", true]], "reset": 0,
   "target": "overshoot-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward"], "conditions": [], "reset": 2, "target": "stick-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward"], "conditions": [[5, "stick-slip", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward"], "conditions": [[6, "stick-slip", true]], "reset": 0,
   "target": "overshoot-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward"], "conditions": [], "reset": 2, "target": "stick-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-slip", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["second-breaks-forward"], "conditions": [[2, "stick-stick", true]],
   "reset": 0, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["second-breaks-forward"], "conditions": [[3, "stick-stick", true]],
   "reset": 0, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["second-breaks-forward"], "conditions": [], "reset": 1,
   "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["second-breaks-backward"], "conditions": [[2, "stick-stick", true]],
   "reset": 0, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["second-breaks-backward"], "conditions": [[3, "stick-stick", true]],
   "reset": 0, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["second-breaks-backward"], "conditions": [], "reset": 1,
   "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward"], "conditions": [[5, "stick-stick", true]], "reset": 0,
   "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward"], "conditions": [[6, "stick-stick", true]], "reset": 0,
   "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward"], "conditions": [], "reset": 2,
   "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-forward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-forward", "second-breaks-backward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward"], "conditions": [[5, "stick-stick", true]],
   "reset": 0, "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward"], "conditions": [[6, "stick-stick", true]],
   "reset": 0, "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward"], "conditions": [], "reset": 2,
   "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-forward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-stick", "boundaries": ["first-breaks-backward", "second-breaks-backward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "stick-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[2, "stick-stick", true]],
   "reset": 0, "target": "stick-slip"},
  {"source": "stick-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[3, "stick-stick", true]],
   "reset": 0, "target": "stick-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1,
   "target": "stick-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward"], "conditions": [[5, "stick-overshoot", true]],
   "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward"], "conditions": [[6, "stick-overshoot", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward"], "conditions": [], "reset": 2,
   "target": "stick-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-forward", "second-reaches-belt"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward"], "conditions": [[5, "stick-overshoot", true]],
   "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward"], "conditions": [[6, "stick-overshoot", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward"], "conditions": [], "reset": 2,
   "target": "stick-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "stick-overshoot", "boundaries": ["first-breaks-backward", "second-reaches-belt"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "overshoot-slip", "boundaries": ["second-reaches-belt"], "conditions": [[2, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-slip", "boundaries": ["second-reaches-belt"], "conditions": [[3, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-slip", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1,
   "target": "overshoot-stick"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-slip", true]], "reset": 0,
   "target": "slip-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-slip", true]], "reset": 0,
   "target": "overshoot-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2,
   "target": "stick-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "overshoot-slip", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [], "reset": 3,
   "target": "stick-stick"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-forward"], "conditions": [[2, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-forward"], "conditions": [[3, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-forward"], "conditions": [], "reset": 1,
   "target": "overshoot-stick"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-backward"], "conditions": [[2, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-backward"], "conditions": [[3, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["second-breaks-backward"], "conditions": [], "reset": 1,
   "target": "overshoot-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-stick", true]],
   "reset": 0, "target": "slip-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-stick", true]],
   "reset": 0, "target": "overshoot-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2,
   "target": "stick-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-forward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "overshoot-stick", "boundaries": ["first-reaches-belt", "second-breaks-backward"], "conditions": [],
   "reset": 3, "target": "stick-stick"},
  {"source": "overshoot-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[2, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [[3, "overshoot-stick", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["second-reaches-belt"], "conditions": [], "reset": 1,
   "target": "overshoot-stick"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [[5, "stick-overshoot", true]],
   "reset": 0, "target": "slip-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [[6, "stick-overshoot", true]],
   "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt"], "conditions": [], "reset": 2,
   "target": "stick-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [2, "slip-stick", true]], "reset": 0, "target": "slip-slip"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true], [3, "slip-stick", true]], "reset": 0, "target": "slip-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[5,
   "stick-stick", true]], "reset": 1, "target": "slip-stick"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [2, "overshoot-stick", true]], "reset": 0, "target": "overshoot-slip"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true], [3, "overshoot-stick", true]], "reset": 0, "target": "overshoot-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[6,
   "stick-stick", true]], "reset": 1, "target": "overshoot-stick"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[2,
   "stick-stick", true]], "reset": 2, "target": "stick-slip"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [[3,
   "stick-stick", true]], "reset": 2, "target": "stick-overshoot"},
  {"source": "overshoot-overshoot", "boundaries": ["first-reaches-belt", "second-reaches-belt"], "conditions": [],
   "reset": 3, "target": "stick-stick"}
 ],
 "contacts": {
  "first-friction": {"forces": {"slip-slip": 8, "slip-stick": 8, "slip-overshoot": 8, "stick-slip": 9, "stick-stick": 9,
   "stick-overshoot": 9, "overshoot-slip": 10, "overshoot-stick": 10, "overshoot-overshoot": 10}, "velocity": 11,
   "surface": 12},
  "second-friction": {"forces": {"slip-slip": 13, "slip-stick": 14, "slip-overshoot": 15, "stick-slip": 13,
   "stick-stick": 14, "stick-overshoot": 15, "overshoot-slip": 13, "overshoot-stick": 14, "overshoot-overshoot": 15},
   "velocity": 16, "surface": 12}
 }
}""")

ORBITS = json.loads(r"""{
 "symmetric": {
  "derived": true,
  "phases": [["slip-slip", "second-reaches-belt", "tau"], ["slip-stick", "second-breaks-forward", "tau1"]],
  "states": ["z1", "z2", "v1", "v2"],
  "parameters": [
   {"name": "chi", "description": "stiffness ratio k2/(k1 + k2), nondimensional", "lower": "0", "upper": "1",
    "closed": false, "upper_closed": false},
   {"name": "eta", "description": "mass ratio m1/m2, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "V", "description": "velocity of the belt, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "e2", "description": "excess ur2 - us2 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false}
  ],
  "open_parameters": [
   {"name": "us2", "description": "slipping friction force on the second mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false}
  ],
  "other_parameters": [
   {"name": "us1", "description": "slipping friction force on the first mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false},
   {"name": "ur1", "description": "static friction force on the first mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "ur2", "description": "static friction force on the second mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "e1", "description": "excess ur1 - us1 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false}
  ],
  "combined": {"e1": {"ur1": 1, "us1": -1}, "e2": {"ur2": 1, "us2": -1}},
  "unknowns": ["z10", "z20", "v10", "tau", "tau1"],
  "dwell_times": ["tau", "tau1"],
  "durations": [{"tau": 1}, {"tau1": 1}],
  "equations": [
   "z1 vanishes halfway through slip-slip",
   "z2 vanishes halfway through slip-slip",
   "z1 vanishes halfway through slip-stick",
   "z2 vanishes halfway through slip-stick",
   "second-breaks-forward ends slip-stick"
  ],
  "reduced": ["tau", "tau1"],
  "rank": 2,
  "section": ["z20", "v10"],
  "conservative": false,
  "reciprocal_pair": false,
  "required": {},
  "vanishing": [],
  "levels": {"v1": "V", "v2": "V"},
  "resets": [
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "0"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]]
  ],
  "measures": ["chi", "V", "e2", "z10", "z20", "v10"],
  "terms": [2, 1],
  "boundaries": [
   [0, "first-reaches-belt", null, 0.0, false],
   [0, "second-reaches-belt", null, 0.0, true],
   [1, "first-reaches-belt", null, 0.0, false],
   [1, "second-breaks-forward", null, 0.0, false],
   [1, "second-breaks-backward", "us2", -2.0, false]
  ],
  "reference": {
   "parameters": {"chi": "0.4", "eta": "4", "V": "0.6773", "e2": "0.5"},
   "guess": {"z10": "-0.4898", "z20": "0.7602", "v10": "-0.111", "tau": "2.651", "tau1": "2.245"}
  }
 },
 "global-stick": {
  "derived": true,
  "phases": [
   ["stick-stick", "first-breaks-forward", "ta"],
   ["slip-stick", "second-breaks-forward", "tau"],
   ["slip-slip", "first-reaches-belt", "tau1"],
   ["stick-slip", "second-reaches-belt", "tau2"]
  ],
  "states": ["z1", "z2", "v1", "v2"],
  "parameters": [
   {"name": "chi", "description": "stiffness ratio k2/(k1 + k2), nondimensional", "lower": "0", "upper": "1",
    "closed": false, "upper_closed": false},
   {"name": "eta", "description": "mass ratio m1/m2, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "V", "description": "velocity of the belt, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "e1", "description": "excess ur1 - us1 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false},
   {"name": "e2", "description": "excess ur2 - us2 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false}
  ],
  "open_parameters": [
   {"name": "us1", "description": "slipping friction force on the first mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false},
   {"name": "us2", "description": "slipping friction force on the second mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false}
  ],
  "other_parameters": [
   {"name": "ur1", "description": "static friction force on the first mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "ur2", "description": "static friction force on the second mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false}
  ],
  "combined": {"e1": {"ur1": 1, "us1": -1}, "e2": {"ur2": 1, "us2": -1}},
  "unknowns": ["z10", "z20", "ta", "tau", "tau1", "tau2"],
  "dwell_times": ["ta", "tau", "tau1", "tau2"],
  "durations": [{"ta": 1}, {"tau": 1}, {"tau1": 1}, {"tau2": 1}],
  "equations": [
   "first-breaks-forward ends stick-stick",
   "second-breaks-forward ends slip-stick",
   "first-reaches-belt ends slip-slip",
   "second-reaches-belt ends stick-slip",
   "z10 returns",
   "z20 returns"
  ],
  "reduced": ["tau", "tau1"],
  "rank": 1,
  "section": ["z10", "z20"],
  "conservative": false,
  "reciprocal_pair": false,
  "required": {},
  "vanishing": [],
  "levels": {"v1": "V", "v2": "V"},
  "resets": [
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "0", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "0"]]
  ],
  "measures": ["chi", "V", "e1", "e2", "z10", "z20"],
  "terms": [0, 1, 2, 1],
  "boundaries": [
   [0, "first-breaks-forward", null, 0.0, false],
   [0, "first-breaks-backward", "us1", -2.0, false],
   [0, "second-breaks-forward", null, 0.0, false],
   [0, "second-breaks-backward", "us2", -2.0, false],
   [1, "first-reaches-belt", null, 0.0, true],
   [1, "second-breaks-forward", null, 0.0, false],
   [1, "second-breaks-backward", "us2", -2.0, false],
   [2, "first-reaches-belt", null, 0.0, false],
   [2, "second-reaches-belt", null, 0.0, true],
   [3, "first-breaks-forward", null, 0.0, false],
   [3, "first-breaks-backward", "us1", -2.0, false],
   [3, "second-reaches-belt", null, 0.0, false]
  ],
  "reference": {
   "parameters": {"chi": "0.5", "eta": "1", "V": "1", "e1": "3.0195", "e2": "0.4831"},
   "guess": {"z10": "1.1838", "z20": "-2.6715", "ta": "1", "tau": "2", "tau1": "1.568", "tau2": "3.28"}
  }
 },
 "solution-ii": {
  "derived": true,
  "phases": [
   ["stick-stick", "first-breaks-forward", "ta"],
   ["slip-stick", "second-breaks-forward", "tau"],
   ["slip-slip", "first-reaches-belt", "tau1"],
   ["stick-slip", "second-reaches-belt", "tau2"]
  ],
  "states": ["z1", "z2", "v1", "v2"],
  "parameters": [
   {"name": "chi", "description": "stiffness ratio k2/(k1 + k2), nondimensional", "lower": "0", "upper": "1",
    "closed": false, "upper_closed": false},
   {"name": "eta", "description": "mass ratio m1/m2, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "V", "description": "velocity of the belt, nondimensional", "lower": "0", "upper": null, "closed": false,
    "upper_closed": false},
   {"name": "e2", "description": "excess ur2 - us2 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false}
  ],
  "open_parameters": [
   {"name": "us1", "description": "slipping friction force on the first mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false},
   {"name": "us2", "description": "slipping friction force on the second mass, nondimensional", "lower": "0",
    "upper": null, "closed": false, "upper_closed": false}
  ],
  "other_parameters": [
   {"name": "ur1", "description": "static friction force on the first mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "ur2", "description": "static friction force on the second mass, nondimensional", "lower": "0", "upper": null,
    "closed": false, "upper_closed": false},
   {"name": "e1", "description": "excess ur1 - us1 of static over slipping friction", "lower": "0", "upper": null,
    "closed": true, "upper_closed": false}
  ],
  "combined": {"e1": {"ur1": 1, "us1": -1}, "e2": {"ur2": 1, "us2": -1}},
  "unknowns": ["z10", "z20", "tau", "tau1", "tau2", "e1"],
  "dwell_times": ["ta", "tau", "tau1", "tau2"],
  "durations": [{}, {"tau": 1}, {"tau1": 1}, {"tau2": 1}],
  "equations": [
   "first-breaks-forward ends stick-stick",
   "second-breaks-forward ends slip-stick",
   "first-reaches-belt ends slip-slip",
   "second-reaches-belt ends stick-slip",
   "z10 returns",
   "z20 returns"
  ],
  "reduced": ["tau", "tau1", "e1"],
  "rank": 1,
  "section": ["z10", "z20"],
  "conservative": false,
  "reciprocal_pair": false,
  "required": {},
  "vanishing": ["ta"],
  "levels": {"v1": "V", "v2": "V"},
  "resets": [
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "0", "0"], ["0", "0", "0", "1"]],
   [["1", "0", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "0", "0"]]
  ],
  "measures": ["chi", "V", "e2", "z10", "z20", "e1"],
  "terms": [0, 1, 2, 1],
  "boundaries": [
   [0, "first-breaks-forward", null, 0.0, false],
   [0, "first-breaks-backward", "us1", -2.0, false],
   [0, "second-breaks-forward", null, 0.0, false],
   [0, "second-breaks-backward", "us2", -2.0, false],
   [1, "first-reaches-belt", null, 0.0, true],
   [1, "second-breaks-forward", null, 0.0, false],
   [1, "second-breaks-backward", "us2", -2.0, false],
   [2, "first-reaches-belt", null, 0.0, false],
   [2, "second-reaches-belt", null, 0.0, true],
   [3, "first-breaks-forward", null, 0.0, false],
   [3, "first-breaks-backward", "us1", -2.0, false],
   [3, "second-reaches-belt", null, 0.0, false]
  ],
  "reference": {
   "parameters": {"chi": "0.5", "eta": "1", "V": "1", "e2": "0.4831"},
   "guess": {"z10": "2", "z20": "-3", "tau": "2", "tau1": "1.568", "tau2": "3.28", "e1": "3.5"}
  }
 }
}""")

KERNELS = json.loads(r"""{
 "spectrum": [[[[2], 0]], [["spectrum", [7]], ["spectrum_derivatives", [7, 2]]]],
 "flow_slip_slip": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_slip_stick": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_slip_overshoot": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_stick_slip": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_stick_stick": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_stick_overshoot": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_overshoot_slip": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_overshoot_stick": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "flow_overshoot_overshoot": [[[[7], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "fields": [[[[7], 0]], [["fields", [36, 5]]]],
 "rows": [[[[7], 0]], [["rows", [17, 5]]]],
 "resets": [[[[7], 0]], [["resets", [16, 5]]]],
 "modes": [[[[7], 0], [[7], 0]], [["exponents", [21, 2]], ["coefficients", [152, 5]]]],
 "symmetric_equations": [[[[4], 0], [[7], 0], [[5], 0], [[7, 2], 2]], [["residual", [5]], ["jacobian", [5, 5]],
  ["parameter_jacobian", [5, 4]]]],
 "symmetric_trace": [[[[4], 0], [[7], 0], [[5], 0], [[7, 2], 1]], [["trace", []], ["trace_gradient", [9]]]],
 "symmetric_passage": [[[[4], 0], [[7], 0], [[5], 0]], [["states", [3, 4]], ["coefficients", [24]], ["frequencies",
  [3]]]],
 "symmetric_linearisation": [[[[4], 0], [[7], 0], [[5], 0]], [["poincare_jacobian", [2, 2]], ["saltations", [8, 4]],
  ["monodromy", [4, 4]]]],
 "symmetric_flow_slip_slip": [[[[4], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "symmetric_flow_slip_stick": [[[[4], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "symmetric_reduced": [[[[4], 0], [[7], 0], [[2], 0]], [["unknowns", [5]], ["determinants", [1]], ["reduced_residual",
  [2]], ["reduced_jacobian", [2, 2]]]],
 "global_stick_equations": [[[[5], 0], [[7], 0], [[6], 0], [[7, 2], 2]], [["residual", [6]], ["jacobian", [6, 6]],
  ["parameter_jacobian", [6, 5]]]],
 "global_stick_trace": [[[[5], 0], [[7], 0], [[6], 0], [[7, 2], 1]], [["trace", []], ["trace_gradient", [11]]]],
 "global_stick_passage": [[[[5], 0], [[7], 0], [[6], 0]], [["states", [5, 4]], ["coefficients", [44]], ["frequencies",
  [4]]]],
 "global_stick_linearisation": [[[[5], 0], [[7], 0], [[6], 0]], [["poincare_jacobian", [2, 2]], ["saltations", [16, 4]],
  ["monodromy", [4, 4]]]],
 "global_stick_flow_slip_stick": [[[[5], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "global_stick_flow_slip_slip": [[[[5], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "global_stick_flow_stick_slip": [[[[5], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "global_stick_reduced": [[[[5], 0], [[7], 0], [[2], 0]], [["unknowns", [6]], ["reduced_residual", [2]],
  ["reduced_jacobian", [2, 2]]]],
 "global_stick_period_map": [[[[5], 0], [[7], 0], [[6], 0]], [["period_map", [4, 5]], ["linear_start", [2]],
  ["compatibility", [4]]]],
 "solution_ii_equations": [[[[4], 0], [[7], 0], [[6], 0], [[7, 2], 2]], [["residual", [6]], ["jacobian", [6, 6]],
  ["parameter_jacobian", [6, 4]]]],
 "solution_ii_trace": [[[[4], 0], [[7], 0], [[6], 0], [[7, 2], 1]], [["trace", []], ["trace_gradient", [10]]]],
 "solution_ii_passage": [[[[4], 0], [[7], 0], [[6], 0]], [["states", [5, 4]], ["coefficients", [44]], ["frequencies",
  [4]]]],
 "solution_ii_linearisation": [[[[4], 0], [[7], 0], [[6], 0]], [["poincare_jacobian", [2, 2]], ["saltations", [16, 4]],
  ["monodromy", [4, 4]]]],
 "solution_ii_flow_slip_stick": [[[[4], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "solution_ii_flow_slip_slip": [[[[4], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "solution_ii_flow_stick_slip": [[[[4], 0], [[7], 0], [[], 0], [[4], 0]], [["state_after", [4]]]],
 "solution_ii_reduced": [[[[4], 0], [[7], 0], [[3], 0]], [["unknowns", [6]], ["reduced_residual", [3]],
  ["reduced_jacobian", [3, 3]]]],
 "solution_ii_period_map": [[[[4], 0], [[7], 0], [[6], 0]], [["period_map", [4, 5]], ["linear_start", [2]],
  ["compatibility", [4]]]]
}""")

def spectrum(parameters, *, lib, outputs=2):
    """Frequencies and projector coefficients, with their derivatives by the parameters.

    Takes parameters (2): chi, eta.
    Gives spectrum (7).
    Gives spectrum_derivatives (7, 2).
    Operations: 97. Intermediate terms: 44.
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
    t5 = lib.sqrt(eta)
    t6 = lib.sqrt(chi)
    omega3 = t5*t6
    t7 = omega3*t4
    omega2 = t3*t7
    t8 = 1/gap1
    t9 = t8/2
    p1 = t1*t9 + lib.rational(1, 2)
    t10 = chi*t8
    p2 = -t10
    p3 = -t0*t8
    spectrum = [gap1, omega1, omega2, p1, p2, p3, omega3]
    if outputs == 1:
        return spectrum
    # d/dchi of: spectrum
    t11 = 2*t1
    gap1_by_chi = t9*(-eta*t11 + 8*t0)
    t12 = gap1_by_chi/2
    t13 = eta/2
    t14 = t3/2
    omega1_by_chi = t14*(t12 + t13)
    t15 = 1/t6
    t16 = t7/omega1**2
    omega2_by_chi = -omega1_by_chi*t16 - omega3*t14/t4 + t15*t3*t4*t5/2
    t17 = 1/gap1**2
    t18 = t1*t17
    p1_by_chi = -t12*t18 - t13*t8
    t19 = chi*t17
    p2_by_chi = gap1_by_chi*t19 - t8
    t20 = t0*t17
    p3_by_chi = -eta*t8 + gap1_by_chi*t20
    omega3_by_chi = t15*t5/2
    # d/deta of: spectrum
    gap1_by_eta = t9*(-chi*t11 + t2)
    t21 = gap1_by_eta/2
    omega1_by_eta = t14*(chi/2 + t21)
    t22 = 1/t5
    omega2_by_eta = -omega1_by_eta*t16 + t22*t3*t4*t6/2
    p1_by_eta = -t10/2 - t18*t21
    p2_by_eta = gap1_by_eta*t19
    p3_by_eta = gap1_by_eta*t20 - t10
    omega3_by_eta = t22*t6/2
    spectrum_derivatives = [[gap1_by_chi, gap1_by_eta], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]]
    return spectrum, spectrum_derivatives


def flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 135. Intermediate terms: 24.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = p1 - 1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 - t6*t7
    t11 = 1/(chi - 1)
    t12 = -us1 - us2
    t13 = t11*t12
    t14 = 1/(chi**2 - chi)
    t15 = -chi*us1 - us2
    t16 = t14*t15
    t17 = p2*t16
    t18 = p1*t13
    t19 = p1*t7 - t6*t8
    t20 = -p3*t7 + p3*t8
    t21 = p3*t13
    t22 = omega2*t4
    t23 = omega1*t1
    return [t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5), t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6), t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23), t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6)]


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
    [x1, x2, v1, v2] = state
    # state_after
    t0 = lib.sin(time)
    t1 = chi*t0
    t2 = lib.cos(time)
    t3 = -chi*t2 + chi
    return [t0*v1 - t2*us1 + t2*x1 + t3*x2 + us1 + v2*(chi*time - t1), time*v2 + x2, t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_slip_overshoot(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-overshoot.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 133. Intermediate terms: 24.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = p1 - 1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 - t6*t7
    t11 = 1/(chi - 1)
    t12 = -us1 + us2
    t13 = t11*t12
    t14 = 1/(chi**2 - chi)
    t15 = -chi*us1 + us2
    t16 = t14*t15
    t17 = p2*t16
    t18 = p1*t13
    t19 = p1*t7 - t6*t8
    t20 = -p3*t7 + p3*t8
    t21 = p3*t13
    t22 = omega2*t4
    t23 = omega1*t1
    return [t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5), t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6), t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23), t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6)]


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
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega3*time
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [time*v1 + x1, t2*v2 - t3*t5 + t3*x2 + t4*x1 + t5 + v1*(-t2 + time), v1, t3*v2 + t4*v1 + t5*t6 + t6*x1 - t6*x2]


def flow_stick_stick(parameters, spectrum, time, state, *, lib):
    """State after a time in stick-stick.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 4. Intermediate terms: 0.
    """
    [x1, x2, v1, v2] = state
    return [time*v1 + x1, time*v2 + x2, v1, v2]


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
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega3*time
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = us2/chi
    t6 = omega3*t1
    return [time*v1 + x1, t2*v2 + t3*t5 + t3*x2 + t4*x1 - t5 + v1*(-t2 + time), v1, t3*v2 + t4*v1 - t5*t6 + t6*x1 - t6*x2]


def flow_overshoot_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in overshoot-slip.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 133. Intermediate terms: 24.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = p1 - 1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 - t6*t7
    t11 = 1/(chi - 1)
    t12 = us1 - us2
    t13 = t11*t12
    t14 = 1/(chi**2 - chi)
    t15 = chi*us1 - us2
    t16 = t14*t15
    t17 = p2*t16
    t18 = p1*t13
    t19 = p1*t7 - t6*t8
    t20 = -p3*t7 + p3*t8
    t21 = p3*t13
    t22 = omega2*t4
    t23 = omega1*t1
    return [t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5), t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6), t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23), t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6)]


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
    [x1, x2, v1, v2] = state
    # state_after
    t0 = lib.sin(time)
    t1 = chi*t0
    t2 = lib.cos(time)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*us1 + t2*x1 + t3*x2 - us1 + v2*(chi*time - t1), time*v2 + x2, -t0*us1 - t0*x1 + t1*x2 + t2*v1 + t3*v2, v2]


def flow_overshoot_overshoot(parameters, spectrum, time, state, *, lib):
    """State after a time in overshoot-overshoot.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): x1, x2, v1, v2.
    Gives state_after (4).
    Operations: 133. Intermediate terms: 24.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [x1, x2, v1, v2] = state
    # state_after
    t0 = omega1*time
    t1 = lib.sin(t0)
    t2 = t1/omega1
    t3 = omega2*time
    t4 = lib.sin(t3)
    t5 = t4/omega2
    t6 = p1 - 1
    t7 = lib.cos(t3)
    t8 = lib.cos(t0)
    t9 = -p2*t7 + p2*t8
    t10 = p1*t8 - t6*t7
    t11 = 1/(chi - 1)
    t12 = us1 + us2
    t13 = t11*t12
    t14 = 1/(chi**2 - chi)
    t15 = chi*us1 + us2
    t16 = t14*t15
    t17 = p2*t16
    t18 = p1*t13
    t19 = p1*t7 - t6*t8
    t20 = -p3*t7 + p3*t8
    t21 = p3*t13
    t22 = omega2*t4
    t23 = omega1*t1
    return [t10*x1 + t13 + t7*(t13*t6 + t17) + t8*(-t17 - t18) + t9*x2 + v1*(p1*t2 - t5*t6) + v2*(p2*t2 - p2*t5), t16 + t19*x2 + t20*x1 + t7*(-p1*t16 + t21) + t8*(t14*t15*t6 - t21) + v1*(p3*t2 - p3*t5) + v2*(p1*t5 - t2*t6), t1*(omega1*t17 + omega1*t18) + t10*v1 + t4*(-omega2*t11*t12*t6 - omega2*t17) + t9*v2 + x1*(-p1*t23 + t22*t6) + x2*(p2*t22 - p2*t23), t1*(-omega1*t16*t6 + omega1*t21) + t19*v2 + t20*v1 + t4*(omega2*p1*t14*t15 - omega2*t21) + x1*(p3*t22 - p3*t23) + x2*(-p1*t22 + t23*t6)]


def fields(parameters, *, lib):
    """Vector fields of the configurations, one below the other, offsets last.

    Takes parameters (7): chi, eta, V, us1, ur1, us2, ur2.
    Gives fields (36, 5).
    Operations: 20. Intermediate terms: 2.
    """
    [chi, eta, _, us1, _, us2, _] = parameters
    # fields
    t0 = chi*eta
    t1 = eta*us2
    return [[0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, t1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, us1], [t0, -t0, 0, 0, -t1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, t1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [t0, -t0, 0, 0, -t1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, t1], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [-1, chi, 0, 0, -us1], [t0, -t0, 0, 0, -t1]]


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
    Operations: 238. Intermediate terms: 45.
    """
    [chi, _, _, us1, _, us2, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    exponents = [[0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, omega3], [0, 0], [0, 0], [0, omega3], [0, 0], [0, omega1], [0, omega2], [0, 0], [0, 1], [0, 0], [0, omega1], [0, omega2]]
    if outputs == 1:
        return exponents
    # coefficients
    t0 = 1/(chi - 1)
    t1 = us1 + us2
    t2 = -t0*t1
    t3 = 1/(chi**2 - chi)
    t4 = chi*us1
    t5 = t4 + us2
    t6 = -t3*t5
    t7 = p2*t6
    t8 = p1 - 1
    t9 = p3*t2
    t10 = 1/omega1
    t11 = p1*t10
    t12 = p2*t10
    t13 = p3*t10
    t14 = -t10*t8
    t15 = omega1*p1
    t16 = omega1*p2
    t17 = omega1*p3
    t18 = -omega1*t8
    t19 = 1/omega2
    t20 = -t19*t8
    t21 = -p2*t19
    t22 = -p3*t19
    t23 = p1*t19
    t24 = omega2*t8
    t25 = omega2*p2
    t26 = omega2*p3
    t27 = -omega2*p1
    t28 = -us1 + us2
    t29 = t0*t28
    t30 = -t4 + us2
    t31 = t3*t30
    t32 = p2*t31
    t33 = p3*t29
    t34 = us2/chi
    t35 = 1/omega3
    t36 = omega3*t34
    t37 = -t0*t28
    t38 = -t3*t30
    t39 = p2*t38
    t40 = p3*t37
    t41 = t0*t1
    t42 = t3*t5
    t43 = p2*t42
    t44 = p3*t41
    coefficients = [[0, 0, 0, 0, t2], [0, 0, 0, 0, t6], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t2 - t7], [p3, -t8, 0, 0, -t3*t5*t8 - t9], [0, 0, p1, p2, 0], [0, 0, p3, -t8, 0], [0, 0, t11, t12, 0], [0, 0, t13, t14, 0], [-t15, -t16, 0, 0, t15*t2 + t16*t6], [-t17, -t18, 0, 0, t17*t2 + t18*t6], [-t8, -p2, 0, 0, t2*t8 + t7], [-p3, p1, 0, 0, -p1*t6 + t9], [0, 0, -t8, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t20, t21, 0], [0, 0, t22, t23, 0], [t24, t25, 0, 0, omega2*t0*t1*t8 - t25*t6], [t26, t27, 0, 0, -omega2*p1*t3*t5 - t2*t26], [0, chi, 0, 0, us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t29], [0, 0, 0, 0, t31], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t29 - t32], [p3, -t8, 0, 0, t3*t30*t8 - t33], [0, 0, p1, p2, 0], [0, 0, p3, -t8, 0], [0, 0, t11, t12, 0], [0, 0, t13, t14, 0], [-t15, -t16, 0, 0, t15*t29 + t16*t31], [-t17, -t18, 0, 0, t17*t29 + t18*t31], [-t8, -p2, 0, 0, t29*t8 + t32], [-p3, p1, 0, 0, -p1*t31 + t33], [0, 0, -t8, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t20, t21, 0], [0, 0, t22, t23, 0], [t24, t25, 0, 0, -omega2*t0*t28*t8 - t25*t31], [t26, t27, 0, 0, omega2*p1*t3*t30 - t26*t29], [1, 0, 0, 0, 0], [1, 0, 0, 0, t34], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, -t34], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t35, t35, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, t36], [1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [1, 0, 0, 0, -t34], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [-1, 1, 0, 0, t34], [0, 0, 0, 0, 0], [0, 0, -1, 1, 0], [0, 0, 0, 0, 0], [0, 0, -t35, t35, 0], [0, 0, 0, 0, 0], [omega3, -omega3, 0, 0, -t36], [0, 0, 0, 0, t37], [0, 0, 0, 0, t38], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t37 - t39], [p3, -t8, 0, 0, -t3*t30*t8 - t40], [0, 0, p1, p2, 0], [0, 0, p3, -t8, 0], [0, 0, t11, t12, 0], [0, 0, t13, t14, 0], [-t15, -t16, 0, 0, t15*t37 + t16*t38], [-t17, -t18, 0, 0, t17*t37 + t18*t38], [-t8, -p2, 0, 0, t37*t8 + t39], [-p3, p1, 0, 0, -p1*t38 + t40], [0, 0, -t8, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t20, t21, 0], [0, 0, t22, t23, 0], [t24, t25, 0, 0, omega2*t0*t28*t8 - t25*t38], [t26, t27, 0, 0, -omega2*p1*t3*t30 - t26*t37], [0, chi, 0, 0, -us1], [0, 1, 0, 0, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, chi, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [1, -chi, 0, 0, us1], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [0, 0, 1, -chi, 0], [0, 0, 0, 0, 0], [-1, chi, 0, 0, -us1], [0, 0, 0, 0, 0], [0, 0, 0, 0, t41], [0, 0, 0, 0, t42], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0], [p1, p2, 0, 0, -p1*t41 - t43], [p3, -t8, 0, 0, t3*t5*t8 - t44], [0, 0, p1, p2, 0], [0, 0, p3, -t8, 0], [0, 0, t11, t12, 0], [0, 0, t13, t14, 0], [-t15, -t16, 0, 0, t15*t41 + t16*t42], [-t17, -t18, 0, 0, t17*t41 + t18*t42], [-t8, -p2, 0, 0, t41*t8 + t43], [-p3, p1, 0, 0, -p1*t42 + t44], [0, 0, -t8, -p2, 0], [0, 0, -p3, p1, 0], [0, 0, t20, t21, 0], [0, 0, t22, t23, 0], [t24, t25, 0, 0, -omega2*t0*t1*t8 - t25*t42], [t26, t27, 0, 0, omega2*p1*t3*t5 - t26*t41]]
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
    Operations: 235. Intermediate terms: 63.
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
    # residual
    t2 = p1*z10 + p2*z20
    t3 = -t2 + z10
    t4 = V*p2 + p1*v10
    t5 = 1/omega1
    t6 = sin_omega1_half_tau*t5
    t7 = t4 - v10
    t8 = 1/omega2
    t9 = sin_omega2_half_tau*t8
    t10 = -p1*z20 + p3*z10
    t11 = t10 + z20
    t12 = p3*v10
    t13 = V*p1 - t12
    t14 = V*p1 - V - t12
    t15 = chi*z20
    t16 = t15 - z10
    t17 = V*chi
    t18 = -t17 + v10
    t19 = V*half_tau1 - z20
    residual = [cos_omega1_half_tau*t2 + cos_omega2_half_tau*t3 + t4*t6 - t7*t9, cos_omega1_half_tau*t11 - cos_omega2_half_tau*t10 + t13*t9 - t14*t6, cos_half_tau1*t16 + half_tau1*t17 + sin_half_tau1*t18 - t15, t19, -chi*z10 - e2 + t15]
    if outputs == 1:
        return residual
    # d/dtau of: functions of half_tau in slip-slip
    t20 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t20
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t20
    t21 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t21
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t21
    # d/dtau1 of: functions of half_tau1 in slip-stick
    cos_half_tau1_by_tau1 = -sin_half_tau1/2
    sin_half_tau1_by_tau1 = cos_half_tau1/2
    # jacobian
    t22 = p1 - 1
    t23 = sin_omega1_half_tau_by_tau*t5
    t24 = sin_omega2_half_tau_by_tau*t8
    jacobian = [[cos_omega1_half_tau*p1 - cos_omega2_half_tau*t22, cos_omega1_half_tau*p2 - cos_omega2_half_tau*p2, p1*t6 - t22*t9, cos_omega1_half_tau_by_tau*t2 + cos_omega2_half_tau_by_tau*t3 + t23*t4 - t24*t7, 0], [cos_omega1_half_tau*p3 - cos_omega2_half_tau*p3, -cos_omega1_half_tau*t22 + cos_omega2_half_tau*p1, p3*t6 - p3*t9, cos_omega1_half_tau_by_tau*t11 - cos_omega2_half_tau_by_tau*t10 + t13*t24 - t14*t23, 0], [-cos_half_tau1, chi*cos_half_tau1 - chi, sin_half_tau1, 0, cos_half_tau1_by_tau1*t16 + sin_half_tau1_by_tau1*t18 + t17/2], [0, -1, 0, 0, V/2], [-chi, chi, 0, 0, 0]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
    # d/dchi of: functions of half_tau in slip-slip
    t25 = half_tau*omega1_by_chi
    cos_omega1_half_tau_by_chi = -sin_omega1_half_tau*t25
    sin_omega1_half_tau_by_chi = cos_omega1_half_tau*t25
    t26 = half_tau*omega2_by_chi
    cos_omega2_half_tau_by_chi = -sin_omega2_half_tau*t26
    sin_omega2_half_tau_by_chi = cos_omega2_half_tau*t26
    # d/deta of: functions of half_tau in slip-slip
    t27 = half_tau*omega1_by_eta
    cos_omega1_half_tau_by_eta = -sin_omega1_half_tau*t27
    sin_omega1_half_tau_by_eta = cos_omega1_half_tau*t27
    t28 = half_tau*omega2_by_eta
    cos_omega2_half_tau_by_eta = -sin_omega2_half_tau*t28
    sin_omega2_half_tau_by_eta = cos_omega2_half_tau*t28
    # parameter_jacobian
    t29 = V*t6 - V*t9 + cos_omega1_half_tau*z20 - cos_omega2_half_tau*z20
    t30 = cos_omega1_half_tau*z10 - cos_omega2_half_tau*z10 + t6*v10 - t9*v10
    t31 = t4*t5
    t32 = t7*t8
    t33 = sin_omega2_half_tau/omega2**2
    t34 = t33*t7
    t35 = sin_omega1_half_tau/omega1**2
    t36 = t35*t4
    t37 = t13*t8
    t38 = t14*t5
    t39 = t14*t35
    t40 = t13*t33
    parameter_jacobian = [[cos_omega1_half_tau_by_chi*t2 + cos_omega2_half_tau_by_chi*t3 - omega1_by_chi*t36 + omega2_by_chi*t34 + p1_by_chi*t30 + p2_by_chi*t29 + sin_omega1_half_tau_by_chi*t31 - sin_omega2_half_tau_by_chi*t32, cos_omega1_half_tau_by_eta*t2 + cos_omega2_half_tau_by_eta*t3 - omega1_by_eta*t36 + omega2_by_eta*t34 + p1_by_eta*t30 + p2_by_eta*t29 + sin_omega1_half_tau_by_eta*t31 - sin_omega2_half_tau_by_eta*t32, p2*t6 - p2*t9, 0], [cos_omega1_half_tau_by_chi*t11 - cos_omega2_half_tau_by_chi*t10 + omega1_by_chi*t39 - omega2_by_chi*t40 - p1_by_chi*t29 + p3_by_chi*t30 - sin_omega1_half_tau_by_chi*t38 + sin_omega2_half_tau_by_chi*t37, cos_omega1_half_tau_by_eta*t11 - cos_omega2_half_tau_by_eta*t10 + omega1_by_eta*t39 - omega2_by_eta*t40 - p1_by_eta*t29 + p3_by_eta*t30 - sin_omega1_half_tau_by_eta*t38 + sin_omega2_half_tau_by_eta*t37, p1*t9 - t22*t6, 0], [-V*sin_half_tau1 + cos_half_tau1*z20 + t19, 0, chi*half_tau1 - chi*sin_half_tau1, 0], [0, 0, half_tau1, 0], [-z10 + z20, 0, 0, -1]]
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
    Operations: 667. Intermediate terms: 149.
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
    t4 = p1 - 1
    t5 = 1/omega2
    t6 = sin_omega2_tau*t5
    carried_z1_1_by_v10 = p1*t3 - t4*t6
    t7 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    carried_v1_1_by_v10 = cos_omega1_tau*p1 - cos_omega2_tau*t4
    t8 = p2*t3 - p2*t6
    z1_1 = V*t8 + carried_v1_1_by_v10*z10 + carried_z1_1_by_v10*v10 + t7*z20
    carried_z2_1_by_v10 = p3*t3 - p3*t6
    t9 = -cos_omega1_tau*t4 + cos_omega2_tau*p1
    carried_v2_1_by_v10 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    t10 = p1*t6 - t3*t4
    z2_1 = V*t10 + carried_v2_1_by_v10*z10 + carried_z2_1_by_v10*v10 + t9*z20
    t11 = omega2*p2
    t12 = omega1*p2
    t13 = sin_omega1_tau*t12
    t14 = sin_omega2_tau*t11 - t13
    t15 = omega1*p1
    t16 = -omega2*t4
    t17 = sin_omega1_tau*t15 + sin_omega2_tau*t16
    v1_1 = V*t7 + carried_v1_1_by_v10*v10 + t14*z20 - t17*z10
    t18 = omega2*p1
    t19 = -omega1*t4
    t20 = sin_omega1_tau*t19 + sin_omega2_tau*t18
    t21 = omega2*p3
    t22 = omega1*p3
    t23 = sin_omega1_tau*t22
    t24 = sin_omega2_tau*t21 - t23
    v2_1 = V*t9 + carried_v2_1_by_v10*v10 - t20*z20 + t24*z10
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t25 = -chi*cos_tau1 + chi
    t26 = chi*sin_tau1
    t27 = chi*tau1 - t26
    z1_2 = V*t27 + cos_tau1*z1_1 + sin_tau1*v1_1 + t25*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t25 + cos_tau1*v1_1 - sin_tau1*z1_1 + t26*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = carried_v1_1_by_v10 + t7
    carried_z2_1_by_z20 = carried_v2_1_by_v10 + t9
    carried_v1_1_by_z20 = omega2*p2*sin_omega2_tau - t13 - t17
    carried_v2_1_by_z20 = omega2*p3*sin_omega2_tau - t20 - t23
    # rate of the exit boundary after tau
    t28 = eta*z1_1
    t29 = chi*z2_1
    rate_1 = chi*t28 - eta*t29
    # derivatives of the time to the boundary after tau
    t30 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t30
    delay_tau_by_v10 = -carried_v2_1_by_v10*t30
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    t31 = t29 - z1_1
    v1_1_on_boundary_by_z20 = carried_v1_1_by_z20 + delay_tau_by_z20*t31
    v1_1_on_boundary_by_v10 = carried_v1_1_by_v10 + delay_tau_by_v10*t31
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t25*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t25*z2_1_on_boundary_by_v10
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t26*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    t32 = V*chi
    rate_2 = -chi*v1_2 + t32
    # derivatives of the time to the boundary after tau1
    t33 = 1/rate_2
    t34 = chi*z2_1_on_boundary_by_z20
    t35 = carried_z1_2_by_z20*chi - t34
    delay_tau1_by_z20 = t33*t35
    t36 = chi*z2_1_on_boundary_by_v10
    t37 = carried_z1_2_by_v10*chi - t36
    delay_tau1_by_v10 = t33*t37
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    slope_by_delay_tau1_by_v10 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_v10 = carried_v1_2_by_v10 + delay_tau1_by_v10*slope_by_delay_tau1_by_v10
    trace = v1_2_on_boundary_by_v10 + z2_2_on_boundary_by_z20
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [_, _]] = spectrum_derivatives
    # back through: rate of the exit boundary after tau1
    t38 = 1/rate_2**2
    slope_by_rate_2 = -V*t35*t38 - slope_by_delay_tau1_by_v10*t37*t38
    # back through: Phi along tau1
    t39 = slope_by_delay_tau1_by_v10*t33
    slope_by_carried_z1_2_by_v10 = chi*t39
    slope_by_carried_z1_2_by_z20 = t32*t33
    # back through: perturbation on the boundary after tau
    slope_by_v1_1_on_boundary_by_v10 = cos_tau1 + sin_tau1*slope_by_carried_z1_2_by_v10
    slope_by_v1_1_on_boundary_by_z20 = sin_tau1*slope_by_carried_z1_2_by_z20
    slope_by_z2_1_on_boundary_by_v10 = slope_by_carried_z1_2_by_v10*t25 - slope_by_carried_z1_2_by_v10 + t26
    slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t25 - slope_by_carried_z1_2_by_z20 + 1
    slope_by_z1_1_on_boundary_by_v10 = cos_tau1*slope_by_carried_z1_2_by_v10 - sin_tau1
    slope_by_z1_1_on_boundary_by_z20 = cos_tau1*slope_by_carried_z1_2_by_z20
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_v10 = slope_by_v1_1_on_boundary_by_v10*t31 + slope_by_z1_1_on_boundary_by_v10*v1_1 + slope_by_z2_1_on_boundary_by_v10*v2_1
    slope_by_delay_tau_by_z20 = slope_by_v1_1_on_boundary_by_z20*t31 + slope_by_z1_1_on_boundary_by_z20*v1_1 + slope_by_z2_1_on_boundary_by_z20*v2_1
    # back through: rate of the exit boundary after tau
    t40 = 1/rate_1**2
    slope_by_rate_1 = carried_v2_1_by_v10*slope_by_delay_tau_by_v10*t40 + carried_v2_1_by_z20*slope_by_delay_tau_by_z20*t40
    # back through: Phi along tau
    slope_by_carried_v2_1_by_v10 = -slope_by_delay_tau_by_v10*t30
    slope_by_carried_v2_1_by_z20 = -slope_by_delay_tau_by_z20*t30
    # back through: slip-stick for tau1, until second-breaks-forward
    t41 = chi*slope_by_rate_2
    slope_by_v1_2 = -t41
    slope_by_z2_2 = chi*delay_tau1_by_v10
    slope_by_z1_2 = -delay_tau1_by_v10
    # back through: functions of tau1 in slip-stick
    t42 = -t32 + v1_1
    t43 = t36 - z1_1_on_boundary_by_v10
    slope_by_sin_tau1 = slope_by_carried_z1_2_by_v10*v1_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*v1_1_on_boundary_by_z20 + slope_by_v1_2*t31 + slope_by_z1_2*t42 + t43
    slope_by_cos_tau1 = -slope_by_carried_z1_2_by_v10*t43 + slope_by_carried_z1_2_by_z20*(-t34 + z1_1_on_boundary_by_z20) + slope_by_v1_2*t42 - slope_by_z1_2*t31 + v1_1_on_boundary_by_v10
    # back through: slip-slip for tau, until second-reaches-belt
    slope_by_v2_1 = delay_tau_by_v10*slope_by_z2_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z2_1_on_boundary_by_z20
    slope_by_v1_1 = cos_tau1*slope_by_v1_2 + delay_tau_by_v10*slope_by_z1_1_on_boundary_by_v10 + delay_tau_by_z20*slope_by_z1_1_on_boundary_by_z20 + sin_tau1*slope_by_z1_2
    t44 = delay_tau_by_z20*slope_by_v1_1_on_boundary_by_z20
    t45 = delay_tau_by_v10*slope_by_v1_1_on_boundary_by_v10
    t46 = -chi*eta*slope_by_rate_1
    slope_by_z2_1 = chi*t44 + chi*t45 + slope_by_v1_2*t26 + slope_by_z1_2*t25 + slope_by_z2_2 + t46
    slope_by_z1_1 = cos_tau1*slope_by_z1_2 - sin_tau1*slope_by_v1_2 - t44 - t45 - t46
    # back through: functions of tau in slip-slip
    t47 = V*p1
    t48 = p3*v10
    t49 = V*p2
    t50 = p3*slope_by_z2_1_on_boundary_by_v10
    slope_by_sin_omega2_tau = slope_by_carried_v2_1_by_z20*(-t18 + t21) + slope_by_v1_1*(t11*z20 - t16*z10) + slope_by_v1_1_on_boundary_by_z20*(t11 - t16) + slope_by_v2_1*(-t18*z20 + t21*z10) + slope_by_z1_1*(-t4*t5*v10 - t49*t5) - slope_by_z1_1_on_boundary_by_v10*t4*t5 + slope_by_z2_1*(t47*t5 - t48*t5) - t5*t50
    t51 = -p1 + p3
    t52 = p3*z10
    t53 = p2*z20
    t54 = p3*slope_by_carried_v2_1_by_v10
    slope_by_cos_omega2_tau = slope_by_v1_1*(-t4*v10 - t49) - slope_by_v1_1_on_boundary_by_v10*t4 + slope_by_v2_1*(t47 - t48) + slope_by_z1_1*(-t4*z10 - t53) + slope_by_z1_1_on_boundary_by_z20*(-p2 - t4) + slope_by_z2_1*(p1*z20 - t52) - slope_by_z2_1_on_boundary_by_z20*t51 - t54
    t55 = -V*t4
    t56 = p1*v10
    slope_by_sin_omega1_tau = p1*slope_by_z1_1_on_boundary_by_v10*t2 + slope_by_carried_v2_1_by_z20*(-t19 - t22) + slope_by_v1_1*(-omega1*t53 - t15*z10) + slope_by_v1_1_on_boundary_by_z20*(-t12 - t15) + slope_by_v2_1*(-omega1*t52 - t19*z20) + slope_by_z1_1*(t2*t49 + t2*t56) + slope_by_z2_1*(t2*t48 + t2*t55) + t2*t50
    t57 = -t4*z20
    t58 = p1*z10
    slope_by_cos_omega1_tau = p1*slope_by_v1_1_on_boundary_by_v10 + slope_by_v1_1*(t49 + t56) + slope_by_v2_1*(t48 + t55) + slope_by_z1_1*(t53 + t58) + slope_by_z1_1_on_boundary_by_z20*(p1 + p2) + slope_by_z2_1*(t52 + t57) + slope_by_z2_1_on_boundary_by_z20*(t51 + 1) + t54
    # trace_gradient
    t59 = cos_omega2_tau*slope_by_sin_omega2_tau
    t60 = cos_omega1_tau*slope_by_sin_omega1_tau
    t61 = sin_omega2_tau*slope_by_cos_omega2_tau
    t62 = sin_omega1_tau*slope_by_cos_omega1_tau
    t63 = t3 - t6
    t64 = cos_omega1_tau - cos_omega2_tau
    t65 = -omega1*sin_omega1_tau + omega2*sin_omega2_tau
    t66 = t64*v10 + t65*z10
    t67 = t63*v10 + t64*z10
    t68 = slope_by_carried_v2_1_by_v10*t64 + slope_by_carried_v2_1_by_z20*t65 + slope_by_v2_1*t66 + slope_by_z2_1*t67 + slope_by_z2_1_on_boundary_by_v10*t63 + slope_by_z2_1_on_boundary_by_z20*t64
    t69 = slope_by_v1_1_on_boundary_by_z20*t65 + slope_by_z1_1_on_boundary_by_z20*t64
    t70 = slope_by_v1_1*(V*t64 + t65*z20) + slope_by_z1_1*(V*t63 + t64*z20) + t69
    t71 = -slope_by_carried_v2_1_by_z20*t65 + slope_by_v1_1*t66 + slope_by_v1_1_on_boundary_by_v10*t64 + slope_by_v2_1*(-V*t64 - t65*z20) + slope_by_z1_1*t67 + slope_by_z1_1_on_boundary_by_v10*t63 + slope_by_z2_1*(-V*t63 - t64*z20) - slope_by_z2_1_on_boundary_by_z20*t64 + t69
    t72 = -sin_omega2_tau*t4
    t73 = p3*sin_omega2_tau
    t74 = 1/omega2**2
    t75 = sin_omega2_tau*t74
    t76 = slope_by_carried_v2_1_by_z20*(-p1*sin_omega2_tau + t73) + slope_by_v1_1*(sin_omega2_tau*t4*z10 + sin_omega2_tau*t53) + slope_by_v1_1_on_boundary_by_z20*(p2*sin_omega2_tau - t72) + slope_by_v2_1*(-p1*sin_omega2_tau*z20 + sin_omega2_tau*t52) + slope_by_z1_1*(t4*t75*v10 + t49*t75) - slope_by_z1_1_on_boundary_by_v10*t72*t74 + slope_by_z2_1*(p3*sin_omega2_tau*t74*v10 - t47*t75) + slope_by_z2_1_on_boundary_by_v10*t73*t74 + t59*tau - t61*tau
    t77 = p1*sin_omega1_tau
    t78 = p3*sin_omega1_tau
    t79 = 1/omega1**2
    t80 = sin_omega1_tau*t79
    t81 = slope_by_carried_v2_1_by_z20*(sin_omega1_tau*t4 - t78) + slope_by_v1_1*(-sin_omega1_tau*t53 - sin_omega1_tau*t58) + slope_by_v1_1_on_boundary_by_z20*(-p2*sin_omega1_tau - t77) + slope_by_v2_1*(-sin_omega1_tau*t52 - sin_omega1_tau*t57) + slope_by_z1_1*(-t49*t80 - t56*t80) - slope_by_z1_1_on_boundary_by_v10*t77*t79 + slope_by_z2_1*(-t48*t80 - t55*t80) - slope_by_z2_1_on_boundary_by_v10*t78*t79 + t60*tau - t62*tau
    t82 = 1 - cos_tau1
    trace_gradient = [carried_v1_1_by_v10*slope_by_z1_1 + carried_v2_1_by_v10*slope_by_z2_1 - slope_by_v1_1*t17 + slope_by_v2_1*t24, slope_by_v1_1*t14 - slope_by_v2_1*t20 + slope_by_z1_1*t7 + slope_by_z2_1*t9, carried_v1_1_by_v10*slope_by_v1_1 + carried_v2_1_by_v10*slope_by_v2_1 + carried_z1_1_by_v10*slope_by_z1_1 + carried_z2_1_by_v10*slope_by_z2_1, omega1*t60 - omega1*t62 + omega2*t59 - omega2*t61, V*slope_by_z2_2 + cos_tau1*slope_by_sin_tau1 - sin_tau1*slope_by_cos_tau1 + slope_by_z1_2*t32, V*t33*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + delay_tau1_by_v10*z2_2 + omega1_by_chi*t81 + omega2_by_chi*t76 + p1_by_chi*t71 + p2_by_chi*t70 + p3_by_chi*t68 + sin_tau1*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_v10*t82*z2_1_on_boundary_by_v10 + slope_by_carried_z1_2_by_z20*t82*z2_1_on_boundary_by_z20 + slope_by_rate_1*(-eta*z2_1 + t28) + slope_by_rate_2*(V - v1_2) + slope_by_v1_2*(V*t82 + sin_tau1*z2_1) + slope_by_z1_2*(V*(-sin_tau1 + tau1) + t82*z2_1) + t39*(carried_z1_2_by_v10 - z2_1_on_boundary_by_v10) + t44*z2_1 + t45*z2_1, omega1_by_eta*t81 + omega2_by_eta*t76 + p1_by_eta*t71 + p2_by_eta*t70 + p3_by_eta*t68 + slope_by_rate_1*(chi*z1_1 - t29), delay_tau1_by_z20 + slope_by_v1_1*t7 + slope_by_v1_2*t25 + slope_by_v2_1*t9 + slope_by_z1_1*t8 + slope_by_z1_2*t27 + slope_by_z2_1*t10 + slope_by_z2_2*tau1 + t41, 0]
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
    Operations: 136. Intermediate terms: 37.
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
    t2 = sin_omega1_tau/omega1
    t3 = 1 - p1
    t4 = sin_omega2_tau/omega2
    t5 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    t6 = cos_omega1_tau*p1 + cos_omega2_tau*t3
    z1_1 = V*(p2*t2 - p2*t4) + t5*z20 + t6*z10 + v10*(p1*t2 + t3*t4)
    z2_1 = V*(p1*t4 + t2*t3) + v10*(p3*t2 - p3*t4) + z10*(cos_omega1_tau*p3 - cos_omega2_tau*p3) + z20*(cos_omega1_tau*t3 + cos_omega2_tau*p1)
    t7 = omega2*sin_omega2_tau
    t8 = omega1*sin_omega1_tau
    v1_1 = V*t5 + t6*v10 + z10*(-p1*t8 - t3*t7) + z20*(p2*t7 - p2*t8)
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
    t11 = V*p2
    t12 = p2*z20
    t13 = omega1*z10
    t14 = omega2*z10
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
    coefficients = [-V, 0, p1*v10 + t11, -t11 + t3*v10, -omega1*t12 - p1*t13, omega2*t12 - t14*t3, -V, 0, V*t3 + t15, V*p1 - t15, -omega1*t3*z20 - p3*t13, -omega2*p1*z20 + p3*t14, -V + t16, 0, t17, t19, -e2 + t18 - t21, -t22, -t23, -t24, -e2 - t18 + t21, t22, t23, t24]
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
    Operations: 269. Intermediate terms: 100.
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
    t2 = sin_omega1_tau/omega1
    t3 = 1 - p1
    t4 = sin_omega2_tau/omega2
    carried_z1_1_by_v10 = p1*t2 + t3*t4
    phi_1_01 = cos_omega1_tau*p2 - cos_omega2_tau*p2
    carried_v1_1_by_v10 = cos_omega1_tau*p1 + cos_omega2_tau*t3
    phi_1_03 = p2*t2 - p2*t4
    z1_1 = V*phi_1_03 + carried_v1_1_by_v10*z10 + carried_z1_1_by_v10*v10 + phi_1_01*z20
    carried_z2_1_by_v10 = p3*t2 - p3*t4
    phi_1_11 = cos_omega1_tau*t3 + cos_omega2_tau*p1
    carried_v2_1_by_v10 = cos_omega1_tau*p3 - cos_omega2_tau*p3
    phi_1_13 = p1*t4 + t2*t3
    z2_1 = V*phi_1_13 + carried_v2_1_by_v10*z10 + carried_z2_1_by_v10*v10 + phi_1_11*z20
    t5 = omega2*sin_omega2_tau
    t6 = omega1*sin_omega1_tau
    t7 = p2*t6
    phi_1_21 = p2*t5 - t7
    t8 = p1*t6 + t3*t5
    v1_1 = V*phi_1_01 + carried_v1_1_by_v10*v10 + phi_1_21*z20 - t8*z10
    t9 = p1*t5 + t3*t6
    t10 = p3*t6
    phi_1_30 = p3*t5 - t10
    v2_1 = V*phi_1_11 + carried_v2_1_by_v10*v10 + phi_1_30*z10 - t9*z20
    # functions of tau1 in slip-stick
    cos_tau1 = lib.cos(tau1)
    sin_tau1 = lib.sin(tau1)
    # slip-stick for tau1, until second-breaks-forward
    t11 = -chi*cos_tau1 + chi
    t12 = chi*sin_tau1
    z1_2 = V*(chi*tau1 - t12) + cos_tau1*z1_1 + sin_tau1*v1_1 + t11*z2_1
    z2_2 = V*tau1 + z2_1
    v1_2 = V*t11 + cos_tau1*v1_1 - sin_tau1*z1_1 + t12*z2_1
    # Phi along tau
    carried_z1_1_by_z20 = carried_v1_1_by_v10 + phi_1_01
    carried_z2_1_by_z20 = carried_v2_1_by_v10 + phi_1_11
    carried_v1_1_by_z20 = omega2*p2*sin_omega2_tau - t7 - t8
    carried_v2_1_by_z20 = omega2*p3*sin_omega2_tau - t10 - t9
    # rate of the exit boundary after tau
    t13 = chi*eta
    t14 = chi*z2_1
    rate_1 = -eta*t14 + t13*z1_1
    # derivatives of the time to the boundary after tau
    t15 = 1/rate_1
    delay_tau_by_z20 = -carried_v2_1_by_z20*t15
    delay_tau_by_v10 = -carried_v2_1_by_v10*t15
    # perturbation on the boundary after tau
    z1_1_on_boundary_by_z20 = carried_z1_1_by_z20 + delay_tau_by_z20*v1_1
    z1_1_on_boundary_by_v10 = carried_z1_1_by_v10 + delay_tau_by_v10*v1_1
    z2_1_on_boundary_by_z20 = carried_z2_1_by_z20 + delay_tau_by_z20*v2_1
    z2_1_on_boundary_by_v10 = carried_z2_1_by_v10 + delay_tau_by_v10*v2_1
    before_v1_1 = t14 - z1_1
    v1_1_on_boundary_by_z20 = before_v1_1*delay_tau_by_z20 + carried_v1_1_by_z20
    v1_1_on_boundary_by_v10 = before_v1_1*delay_tau_by_v10 + carried_v1_1_by_v10
    # Phi along tau1
    carried_z1_2_by_z20 = cos_tau1*z1_1_on_boundary_by_z20 + sin_tau1*v1_1_on_boundary_by_z20 + t11*z2_1_on_boundary_by_z20
    carried_z1_2_by_v10 = cos_tau1*z1_1_on_boundary_by_v10 + sin_tau1*v1_1_on_boundary_by_v10 + t11*z2_1_on_boundary_by_v10
    carried_v1_2_by_z20 = cos_tau1*v1_1_on_boundary_by_z20 - sin_tau1*z1_1_on_boundary_by_z20 + t12*z2_1_on_boundary_by_z20
    carried_v1_2_by_v10 = cos_tau1*v1_1_on_boundary_by_v10 - sin_tau1*z1_1_on_boundary_by_v10 + t12*z2_1_on_boundary_by_v10
    # rate of the exit boundary after tau1
    rate_2 = V*chi - chi*v1_2
    # derivatives of the time to the boundary after tau1
    t16 = 1/rate_2
    delay_tau1_by_z20 = t16*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    delay_tau1_by_v10 = t16*(carried_z1_2_by_v10*chi - chi*z2_1_on_boundary_by_v10)
    # perturbation on the boundary after tau1
    z2_2_on_boundary_by_z20 = V*delay_tau1_by_z20 + z2_1_on_boundary_by_z20
    z2_2_on_boundary_by_v10 = V*delay_tau1_by_v10 + z2_1_on_boundary_by_v10
    t17 = chi*z2_2
    before_v1_2 = t17 - z1_2
    v1_2_on_boundary_by_z20 = before_v1_2*delay_tau1_by_z20 + carried_v1_2_by_z20
    v1_2_on_boundary_by_v10 = before_v1_2*delay_tau1_by_v10 + carried_v1_2_by_v10
    poincare_jacobian = [[z2_2_on_boundary_by_z20, z2_2_on_boundary_by_v10], [v1_2_on_boundary_by_z20, v1_2_on_boundary_by_v10]]
    if outputs == 1:
        return poincare_jacobian
    # vector fields at transition 2
    behind_v2_2 = -eta*t17 + t13*z1_2
    # saltations
    t18 = 1/rate_1
    t19 = t18*(V - v2_1)
    t20 = 0
    t21 = chi/rate_2
    t22 = 0
    t23 = behind_v2_2*t21
    saltations = [[1, 0, 0, 0], [0, 1, 0, t19], [0, 0, 1, t20], [0, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [-t22, t22, 1, 0], [-t23, t23, 0, 1]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 1
    phi_1_20 = -t8
    phi_1_31 = -t9
    # saltation of phase 1
    saltation_1_10 = carried_v2_1_by_v10 + phi_1_30*t19
    saltation_1_11 = phi_1_11 + phi_1_31*t19
    saltation_1_12 = carried_v2_1_by_v10*t19 + carried_z2_1_by_v10
    saltation_1_13 = phi_1_11*t19 + phi_1_13
    saltation_1_20 = phi_1_20 + phi_1_30*t20
    saltation_1_21 = phi_1_21 + phi_1_31*t20
    saltation_1_22 = carried_v1_1_by_v10 + carried_v2_1_by_v10*t20
    saltation_1_23 = phi_1_01 + phi_1_11*t20
    # Phi of phase 2
    phi_2_00 = carried_v1_1_by_v10*cos_tau1 + saltation_1_10*t11 + saltation_1_20*sin_tau1
    phi_2_01 = cos_tau1*phi_1_01 + saltation_1_11*t11 + saltation_1_21*sin_tau1
    phi_2_02 = carried_z1_1_by_v10*cos_tau1 + saltation_1_12*t11 + saltation_1_22*sin_tau1
    phi_2_03 = cos_tau1*phi_1_03 + saltation_1_13*t11 + saltation_1_23*sin_tau1
    phi_2_20 = -carried_v1_1_by_v10*sin_tau1 + cos_tau1*saltation_1_20 + saltation_1_10*t12
    phi_2_21 = cos_tau1*saltation_1_21 - phi_1_01*sin_tau1 + saltation_1_11*t12
    phi_2_22 = -carried_z1_1_by_v10*sin_tau1 + cos_tau1*saltation_1_22 + saltation_1_12*t12
    phi_2_23 = cos_tau1*saltation_1_23 - phi_1_03*sin_tau1 + saltation_1_13*t12
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t22 + phi_2_20 + saltation_1_10*t22
    saltation_2_21 = -phi_2_01*t22 + phi_2_21 + saltation_1_11*t22
    saltation_2_22 = -phi_2_02*t22 + phi_2_22 + saltation_1_12*t22
    saltation_2_23 = -phi_2_03*t22 + phi_2_23 + saltation_1_13*t22
    saltation_2_30 = -phi_2_00*t23 + saltation_1_10*t23
    saltation_2_31 = -phi_2_01*t23 + saltation_1_11*t23
    saltation_2_32 = -phi_2_02*t23 + saltation_1_12*t23
    saltation_2_33 = -phi_2_03*t23 + saltation_1_13*t23
    monodromy = [[phi_2_00, phi_2_01, phi_2_02, phi_2_03], [saltation_1_10, saltation_1_11, saltation_1_12, saltation_1_13], [saltation_2_20, saltation_2_21, saltation_2_22, saltation_2_23], [saltation_2_30, saltation_2_31, saltation_2_32, saltation_2_33]]
    return poincare_jacobian, saltations, monodromy


def symmetric_flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 77. Intermediate terms: 15.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z1, z2, v1, v2] = state
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
    return [t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5), t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6), t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14), t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6)]


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
    [z1, z2, v1, v2] = state
    # state_after
    t0 = lib.sin(time)
    t1 = chi*t0
    t2 = lib.cos(time)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1), time*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


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
    Operations: 195. Intermediate terms: 61.
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
    t1 = half_tau*omega2
    cos_omega2_half_tau = lib.cos(t1)
    sin_omega2_half_tau = lib.sin(t1)
    # half of tau1
    half_tau1 = tau1/2
    # coefficients of the linear equations
    t2 = 1/omega2
    t3 = sin_omega2_half_tau*t2
    t4 = 1/omega1
    t5 = p1*t4
    t6 = p1*t3
    coefficient11 = sin_omega1_half_tau*t5 + t3 - t6
    # right-hand sides of the linear equations
    t7 = e2/chi
    t8 = cos_omega2_half_tau*t7
    z20 = V*half_tau1
    t9 = cos_omega2_half_tau*z20
    t10 = V*p2
    t11 = p1*t7
    t12 = p2*z20
    t13 = V*t4
    t14 = sin_omega1_half_tau*t13
    t15 = p1*z20
    t16 = -cos_omega1_half_tau*t15 + p1*t9
    right1 = cos_omega1_half_tau*t11 - cos_omega1_half_tau*t12 - p1*t8 - p2*t14 + p2*t9 + t10*t3 + t16 + t8 - t9
    # v10 by Cramer's rule
    t17 = 1/coefficient11
    v10 = right1*t17
    # z10: linear in: second-breaks-forward ends slip-stick
    t18 = t7 - z20
    z10 = -t18
    unknowns = [z10, z20, v10, tau, tau1]
    if outputs == 1:
        return unknowns
    # determinants
    t19 = half_tau**2
    t20 = 2*t19
    determinants = [coefficient11/lib.sqrt(p1**2*t20/(omega1**2*t19 + 1) + t20*(p1 - 1)**2/(omega2**2*t19 + 1))]
    if outputs == 2:
        return unknowns, determinants
    # functions of half_tau1 in slip-stick
    cos_half_tau1 = lib.cos(half_tau1)
    sin_half_tau1 = lib.sin(half_tau1)
    # reduced_residual
    t21 = cos_omega1_half_tau*z20
    t22 = p3*v10
    t23 = t22*t4
    t24 = p3*t7
    t25 = cos_half_tau1*z20
    t26 = V*chi
    reduced_residual = [V*t6 - cos_omega1_half_tau*t24 - p1*t14 + p3*t21 + p3*t8 - p3*t9 + sin_omega1_half_tau*t23 + t14 + t16 + t21 - t22*t3, chi*t25 + cos_half_tau1*t7 - sin_half_tau1*t26 + sin_half_tau1*v10 - t25]
    if outputs == 3:
        return unknowns, determinants, reduced_residual
    # d/dtau of: functions of half_tau in slip-slip
    t27 = omega1/2
    cos_omega1_half_tau_by_tau = -sin_omega1_half_tau*t27
    sin_omega1_half_tau_by_tau = cos_omega1_half_tau*t27
    t28 = omega2/2
    cos_omega2_half_tau_by_tau = -sin_omega2_half_tau*t28
    sin_omega2_half_tau_by_tau = cos_omega2_half_tau*t28
    # d/dtau1 of: functions of half_tau1 in slip-stick
    cos_half_tau1_by_tau1 = -sin_half_tau1/2
    sin_half_tau1_by_tau1 = cos_half_tau1/2
    # d/dtau of: coefficients of the linear equations
    t29 = p1*t2
    coefficient11_by_tau = sin_omega1_half_tau_by_tau*t5 + sin_omega2_half_tau_by_tau*(t2 - t29)
    # d/dtau of: right-hand sides of the linear equations
    t30 = -t11 + t12 + t15
    right1_by_tau = -cos_omega1_half_tau_by_tau*t30 + cos_omega2_half_tau_by_tau*(t18 + t30) - p2*sin_omega1_half_tau_by_tau*t13 + sin_omega2_half_tau_by_tau*t10*t2
    # d/dtau1 of: right-hand sides of the linear equations
    t31 = V/2
    t32 = cos_omega2_half_tau*t31
    t33 = cos_omega1_half_tau*t31
    t34 = p1*t33
    right1_by_tau1 = V*cos_omega2_half_tau*p1/2 + V*cos_omega2_half_tau*p2/2 - p2*t33 - t32 - t34
    # d/dtau of: v10 by Cramer's rule
    v10_by_tau = right1_by_tau*t17 - coefficient11_by_tau*right1/coefficient11**2
    # d/dtau1 of: v10 by Cramer's rule
    v10_by_tau1 = right1_by_tau1*t17
    # reduced_jacobian
    t35 = -p3*z20 + t15 + t24
    t36 = p3*sin_omega1_half_tau*t4 - p3*t3
    reduced_jacobian = [[cos_omega1_half_tau_by_tau*(-t35 + z20) + cos_omega2_half_tau_by_tau*t35 + sin_omega1_half_tau_by_tau*(-p1*t13 + t13 + t23) + sin_omega2_half_tau_by_tau*(V*t29 - t2*t22) + t36*v10_by_tau, p1*t32 - p3*t32 + p3*t33 + t33 - t34 + t36*v10_by_tau1], [sin_half_tau1*v10_by_tau, cos_half_tau1*t26/2 - cos_half_tau1*t31 + cos_half_tau1_by_tau1*(chi*z20 + t18) + sin_half_tau1*v10_by_tau1 + sin_half_tau1_by_tau1*(-t26 + v10)]]
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
    Operations: 672. Intermediate terms: 195.
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
    t1 = chi*cos_tau
    z1_2_by_z20 = chi - t1
    t2 = V*sin_tau
    v1_2_by_z20 = chi*sin_tau
    t3 = chi*tau - v1_2_by_z20
    z1_2 = V*t3 + cos_tau*z1_1 + t2 + z1_2_by_z20*z2_1
    z2_2 = V*tau + z2_1
    z1_2_by_ta = V*cos_tau + V*z1_2_by_z20
    v1_2 = -sin_tau*z1_1 + v1_2_by_z20*z2_1 + z1_2_by_ta
    # functions of tau1 in slip-slip
    t4 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t4)
    sin_omega1_tau1 = lib.sin(t4)
    t5 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t5)
    sin_omega2_tau1 = lib.sin(t5)
    # slip-slip for tau1, until first-reaches-belt
    t6 = 1 - p1
    t7 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t9 = 1/omega1
    t10 = sin_omega1_tau1*t9
    t11 = 1/omega2
    t12 = sin_omega2_tau1*t11
    t13 = p1*t10 + t12*t6
    t14 = p2*t10 - p2*t12
    z1_3 = V*t14 + t13*v1_2 + t7*z1_2 + t8*z2_2
    t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t16 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    t17 = p3*t10 - p3*t12
    t18 = p1*t12 + t10*t6
    z2_3 = V*t18 + t15*z1_2 + t16*z2_2 + t17*v1_2
    t19 = omega1*sin_omega1_tau1
    t20 = omega2*sin_omega2_tau1
    t21 = -p1*t19 - t20*t6
    t22 = -p2*t19 + p2*t20
    t23 = V*t8
    t24 = t23 + t7*v1_2
    v1_3 = t21*z1_2 + t22*z2_2 + t24
    t25 = -p3*t19 + p3*t20
    t26 = p1*t20 + t19*t6
    t27 = V*t16
    t28 = t15*v1_2 + t27
    v2_3 = t25*z1_2 - t26*z2_2 + t28
    # functions of tau2 in stick-slip
    t29 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t29)
    sin_omega3_tau2 = lib.sin(t29)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t30 = 1 - cos_omega3_tau2
    t31 = 1/omega3
    t32 = sin_omega3_tau2*t31
    t33 = -t32 + tau2
    z2_4 = V*t33 + cos_omega3_tau2*z2_3 + t30*z1_3 + t32*v2_3
    t34 = cos_omega3_tau2*v2_3
    t35 = sin_omega3_tau2*z1_3
    t36 = sin_omega3_tau2*z2_3
    v2_4 = V*t30 + omega3*t35 - omega3*t36 + t34
    residual = [-chi*z2_1 - e1 + z1_1, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]
    if outputs == 1:
        return residual
    # derivatives of the state after tau
    v1_2_by_z10 = -sin_tau
    v1_2_by_ta = chi*t2 - t2
    v1_2_by_tau = chi*z2_2 - z1_2
    # derivatives of the state after tau1
    z1_3_by_z10 = cos_tau*t7 + t13*v1_2_by_z10
    z1_3_by_z20 = t13*v1_2_by_z20 + t7*z1_2_by_z20 + t8
    z1_3_by_ta = t13*v1_2_by_ta + t23 + t7*z1_2_by_ta
    z1_3_by_tau = t13*v1_2_by_tau + t24
    z2_3_by_z10 = cos_tau*t15 + t17*v1_2_by_z10
    z2_3_by_z20 = t15*z1_2_by_z20 + t16 + t17*v1_2_by_z20
    z2_3_by_ta = t15*z1_2_by_ta + t17*v1_2_by_ta + t27
    z2_3_by_tau = t17*v1_2_by_tau + t28
    v1_3_by_z10 = cos_tau*t21 + t7*v1_2_by_z10
    v1_3_by_z20 = t21*z1_2_by_z20 + t22 + t7*v1_2_by_z20
    t37 = V*t22
    v1_3_by_ta = t21*z1_2_by_ta + t37 + t7*v1_2_by_ta
    v1_3_by_tau = t21*v1_2 + t37 + t7*v1_2_by_tau
    t38 = chi*z2_3
    v1_3_by_tau1 = t38 - z1_3
    v2_3_by_z10 = cos_tau*t25 + t15*v1_2_by_z10
    v2_3_by_z20 = t15*v1_2_by_z20 + t25*z1_2_by_z20 - t26
    t39 = -V*t26
    v2_3_by_ta = t15*v1_2_by_ta + t25*z1_2_by_ta + t39
    v2_3_by_tau = t15*v1_2_by_tau + t25*v1_2 + t39
    t40 = chi*eta
    v2_3_by_tau1 = -eta*t38 + t40*z1_3
    # derivatives of the state after tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t30*z1_3_by_z10 + t32*v2_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t30*z1_3_by_z20 + t32*v2_3_by_z20
    z2_4_by_ta = cos_omega3_tau2*z2_3_by_ta + t30*z1_3_by_ta + t32*v2_3_by_ta
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t30*z1_3_by_tau + t32*v2_3_by_tau
    z2_4_by_tau1 = t30*v1_3 + t32*v2_3_by_tau1 + t34
    t41 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t41*z1_3_by_z10 - t41*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t41*z1_3_by_z20 - t41*z2_3_by_z20
    v2_4_by_ta = cos_omega3_tau2*v2_3_by_ta + t41*z1_3_by_ta - t41*z2_3_by_ta
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t41*z1_3_by_tau - t41*z2_3_by_tau
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t41*v1_3 - t41*v2_3
    v2_4_by_tau2 = t40*z1_4 - t40*z2_4
    # jacobian
    t42 = V*chi
    jacobian = [[1, -chi, V - t42, 0, 0, 0], [-t1, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_ta + t42, -chi*v1_2 + t42, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_ta, v1_3_by_tau, v1_3_by_tau1, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_ta, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_ta, z1_3_by_tau, v1_3, V], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_ta, z2_4_by_tau, z2_4_by_tau1, v2_4]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t43 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t43*z2_1
    v1_2_by_chi = V*t43 + sin_tau*z2_1
    # d/dV of: slip-stick for tau, until second-breaks-forward
    z1_2_by_V = cos_tau*ta + sin_tau + t3 + ta*z1_2_by_z20
    z2_2_by_V = ta + tau
    v1_2_by_V = chi + cos_tau - sin_tau*ta - t1 + ta*v1_2_by_z20
    # d/dchi of: functions of tau1 in slip-slip
    t44 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t44
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t44
    t45 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t45
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t45
    # d/deta of: functions of tau1 in slip-slip
    t46 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t46
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t46
    t47 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t47
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t47
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t48 = cos_omega1_tau1 - cos_omega2_tau1
    t49 = t10 - t12
    t50 = V*t49 + t48*z2_2
    t51 = t48*z1_2 + t49*v1_2
    t52 = V*p2
    t53 = 1/omega2**2
    t54 = sin_omega2_tau1*t53
    t55 = t52*t54 - t54*t6*v1_2
    t56 = sin_omega1_tau1/omega1**2
    t57 = p1*v1_2
    t58 = -t52*t56 - t56*t57
    t59 = p2*z2_2
    t60 = p1*z1_2
    t61 = t59 + t60
    t62 = t52*t9 + t57*t9
    t63 = -t59 + t6*z1_2
    t64 = -t11*t52 + t11*t6*v1_2
    z1_3_by_chi = cos_omega1_tau1_by_chi*t61 + cos_omega2_tau1_by_chi*t63 + omega1_by_chi*t58 + omega2_by_chi*t55 + p1_by_chi*t51 + p2_by_chi*t50 + sin_omega1_tau1_by_chi*t62 + sin_omega2_tau1_by_chi*t64 + t13*v1_2_by_chi + t7*z1_2_by_chi
    t65 = -V*t49 - t48*z2_2
    t66 = V*p1
    t67 = p3*sin_omega2_tau1*t53*v1_2 - t54*t66
    t68 = p3*v1_2
    t69 = V*t6
    t70 = -t56*t68 - t56*t69
    t71 = p3*z1_2
    t72 = t6*z2_2
    t73 = t71 + t72
    t74 = t68*t9 + t69*t9
    t75 = p1*z2_2 - t71
    t76 = t11*t66 - t11*t68
    z2_3_by_chi = cos_omega1_tau1_by_chi*t73 + cos_omega2_tau1_by_chi*t75 + omega1_by_chi*t70 + omega2_by_chi*t67 + p1_by_chi*t65 + p3_by_chi*t51 + sin_omega1_tau1_by_chi*t74 + sin_omega2_tau1_by_chi*t76 + t15*z1_2_by_chi + t17*v1_2_by_chi
    t77 = -t19 + t20
    t78 = V*t48 + t77*z2_2
    t79 = t48*v1_2 + t77*z1_2
    t80 = t6*z1_2
    t81 = sin_omega2_tau1*t59 - sin_omega2_tau1*t80
    t82 = -sin_omega1_tau1*t59 - sin_omega1_tau1*t60
    t83 = t52 + t57
    t84 = -omega1*t59 - omega1*t60
    t85 = -t52 + t6*v1_2
    t86 = omega2*t59 - omega2*t80
    v1_3_by_chi = cos_omega1_tau1_by_chi*t83 + cos_omega2_tau1_by_chi*t85 + omega1_by_chi*t82 + omega2_by_chi*t81 + p1_by_chi*t79 + p2_by_chi*t78 + sin_omega1_tau1_by_chi*t84 + sin_omega2_tau1_by_chi*t86 + t21*z1_2_by_chi + t7*v1_2_by_chi
    t87 = -V*t48 - t77*z2_2
    t88 = p1*z2_2
    t89 = sin_omega2_tau1*t71 - sin_omega2_tau1*t88
    t90 = -sin_omega1_tau1*t71 - sin_omega1_tau1*t72
    t91 = t68 + t69
    t92 = -omega1*t71 - omega1*t72
    t93 = t66 - t68
    t94 = omega2*t71 - omega2*t88
    v2_3_by_chi = cos_omega1_tau1_by_chi*t91 + cos_omega2_tau1_by_chi*t93 + omega1_by_chi*t90 + omega2_by_chi*t89 + p1_by_chi*t87 + p3_by_chi*t79 + sin_omega1_tau1_by_chi*t92 + sin_omega2_tau1_by_chi*t94 + t15*v1_2_by_chi + t25*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t61 + cos_omega2_tau1_by_eta*t63 + omega1_by_eta*t58 + omega2_by_eta*t55 + p1_by_eta*t51 + p2_by_eta*t50 + sin_omega1_tau1_by_eta*t62 + sin_omega2_tau1_by_eta*t64
    z2_3_by_eta = cos_omega1_tau1_by_eta*t73 + cos_omega2_tau1_by_eta*t75 + omega1_by_eta*t70 + omega2_by_eta*t67 + p1_by_eta*t65 + p3_by_eta*t51 + sin_omega1_tau1_by_eta*t74 + sin_omega2_tau1_by_eta*t76
    v1_3_by_eta = cos_omega1_tau1_by_eta*t83 + cos_omega2_tau1_by_eta*t85 + omega1_by_eta*t82 + omega2_by_eta*t81 + p1_by_eta*t79 + p2_by_eta*t78 + sin_omega1_tau1_by_eta*t84 + sin_omega2_tau1_by_eta*t86
    v2_3_by_eta = cos_omega1_tau1_by_eta*t91 + cos_omega2_tau1_by_eta*t93 + omega1_by_eta*t90 + omega2_by_eta*t89 + p1_by_eta*t87 + p3_by_eta*t79 + sin_omega1_tau1_by_eta*t92 + sin_omega2_tau1_by_eta*t94
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = t13*v1_2_by_V + t14 + t7*z1_2_by_V + t8*z2_2_by_V
    z2_3_by_V = t15*z1_2_by_V + t16*z2_2_by_V + t17*v1_2_by_V + t18
    v1_3_by_V = t21*z1_2_by_V + t22*z2_2_by_V + t7*v1_2_by_V + t8
    v2_3_by_V = t15*v1_2_by_V + t16 + t25*z1_2_by_V - t26*z2_2_by_V
    # d/dchi of: functions of tau2 in stick-slip
    t95 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t95
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t95
    # d/deta of: functions of tau2 in stick-slip
    t96 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t96
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t96
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t97 = sin_omega3_tau2/omega3**2
    t98 = V*t97 - t97*v2_3
    t99 = -z1_3 + z2_3
    t100 = -V*t31 + t31*v2_3
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t99 + omega3_by_chi*t98 + sin_omega3_tau2_by_chi*t100 + t30*z1_3_by_chi + t32*v2_3_by_chi
    t101 = t35 - t36
    t102 = -V + v2_3
    t103 = omega3*z1_3 - omega3*z2_3
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t102 + omega3_by_chi*t101 + sin_omega3_tau2_by_chi*t103 + t41*z1_3_by_chi - t41*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t99 + omega3_by_eta*t98 + sin_omega3_tau2_by_eta*t100 + t30*z1_3_by_eta + t32*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t102 + omega3_by_eta*t101 + sin_omega3_tau2_by_eta*t103 + t41*z1_3_by_eta - t41*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t30*z1_3_by_V + t32*v2_3_by_V + t33
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t41*z1_3_by_V - t41*z2_3_by_V + 1
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
    Operations: 758. Intermediate terms: 175.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, _, tau, tau1, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t0 = V*tau
    t1 = chi - 1
    t2 = 1/t1
    t3 = e1*t2
    t4 = 1/chi
    t5 = e2*t4
    z2_1 = V*sin_tau - cos_tau*t3 - t0 - t2*t5
    # slip-stick for tau
    t6 = chi*z2_1
    t7 = e1 + t6
    t8 = chi*cos_tau
    t9 = chi - t8
    t10 = -chi*sin_tau + chi*tau
    z1_2 = V*sin_tau + V*t10 + cos_tau*t7 + t9*z2_1
    z2_2 = t0 + z2_1
    v1_2 = V*cos_tau + V*t9 + sin_tau*t6 - sin_tau*t7
    # functions of tau1 in slip-slip
    t11 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t11)
    sin_omega1_tau1 = lib.sin(t11)
    t12 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t12)
    sin_omega2_tau1 = lib.sin(t12)
    # slip-slip for tau1
    t13 = 1 - p1
    t14 = cos_omega1_tau1*p1 + cos_omega2_tau1*t13
    t15 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t16 = 1/omega1
    t17 = sin_omega1_tau1*t16
    t18 = 1/omega2
    t19 = sin_omega2_tau1*t18
    t20 = p1*t17 + t13*t19
    t21 = p2*t17 - p2*t19
    z1_3 = V*t21 + t14*z1_2 + t15*z2_2 + t20*v1_2
    t22 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t23 = cos_omega1_tau1*t13 + cos_omega2_tau1*p1
    t24 = p3*t17 - p3*t19
    t25 = p1*t19 + t13*t17
    z2_3 = V*t25 + t22*z1_2 + t23*z2_2 + t24*v1_2
    t26 = omega1*sin_omega1_tau1
    t27 = omega2*sin_omega2_tau1
    t28 = -p1*t26 - t13*t27
    t29 = -p2*t26 + p2*t27
    v1_3 = V*t15 + t14*v1_2 + t28*z1_2 + t29*z2_2
    t30 = -p3*t26 + p3*t27
    t31 = -p1*t27 - t13*t26
    v2_3 = V*t23 + t22*v1_2 + t30*z1_2 + t31*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t32 = -V*cos_tau
    t33 = cos_tau_by_tau*e1
    z2_1_by_tau = -V - t2*t33 - t32
    # d/dtau of: slip-stick for tau
    t34 = V*chi
    t35 = V - t34
    z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t35 + t33 + t34
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t35
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t20*v1_2_by_tau
    z2_3_by_tau = t22*z1_2_by_tau + t23*z2_2_by_tau + t24*v1_2_by_tau
    v1_3_by_tau = t14*v1_2_by_tau + t28*z1_2_by_tau + t29*z2_2_by_tau
    v2_3_by_tau = t22*v1_2_by_tau + t30*z1_2_by_tau + t31*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t36 = chi*z2_3
    v1_3_by_tau1 = t36 - z1_3
    t37 = eta*z1_3
    v2_3_by_tau1 = chi*t37 - eta*t36
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t38 = 2*cosine_part_tau2
    t39 = 2*sine_part_tau2
    t40 = sine_part_tau2_by_tau*t39 + t38*v2_3_by_tau
    t41 = 1/amplitude_tau2
    t42 = t41/2
    amplitude_tau2_by_tau = t40*t42
    # d/dtau1 of: first return of tau2
    t43 = sine_part_tau2_by_tau1*t39 + t38*v2_3_by_tau1
    amplitude_tau2_by_tau1 = t42*t43
    # trace
    t44 = 1/z2_1_by_tau
    t45 = 1/omega3
    t46 = t2*t45
    t47 = 1/v1_3_by_tau1
    t48 = amplitude_tau2_by_tau1*v1_3_by_tau
    t49 = t47*t48
    t50 = amplitude_tau2_by_tau*t2*t45 - t46*t49
    trace = t44*t50
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # back through: d/dtau1 of: first return of tau2
    slope_by_amplitude_tau2_by_tau = t44*t46
    t51 = slope_by_amplitude_tau2_by_tau*t47
    slope_by_amplitude_tau2_by_tau1 = -t51*v1_3_by_tau
    # back through: d/dtau1 of: first return of tau2
    t52 = sine_part_tau2*t41
    slope_by_sine_part_tau2_by_tau1 = slope_by_amplitude_tau2_by_tau1*t52
    # back through: d/dtau of: first return of tau2
    slope_by_sine_part_tau2_by_tau = slope_by_amplitude_tau2_by_tau*t52
    # back through: d/dtau1 of: slip-slip for tau1
    t53 = cosine_part_tau2*t41
    slope_by_v2_3_by_tau1 = slope_by_amplitude_tau2_by_tau1*t53
    slope_by_v1_3_by_tau1 = slope_by_amplitude_tau2_by_tau*t48/v1_3_by_tau1**2
    # back through: d/dtau of: slip-slip for tau1
    slope_by_v2_3_by_tau = slope_by_amplitude_tau2_by_tau*t53
    slope_by_v1_3_by_tau = -amplitude_tau2_by_tau1*t51
    slope_by_z1_3_by_tau = omega3*slope_by_sine_part_tau2_by_tau
    slope_by_z2_3_by_tau = -slope_by_z1_3_by_tau
    # back through: d/dtau of: slip-stick for tau
    slope_by_v1_2_by_tau = slope_by_v1_3_by_tau*t14 + slope_by_v2_3_by_tau*t22 + slope_by_z1_3_by_tau*t20 + slope_by_z2_3_by_tau*t24
    slope_by_z2_2_by_tau = slope_by_v1_3_by_tau*t29 + slope_by_v2_3_by_tau*t31 + slope_by_z1_3_by_tau*t15 + slope_by_z2_3_by_tau*t23
    slope_by_z1_2_by_tau = slope_by_v1_3_by_tau*t28 + slope_by_v2_3_by_tau*t30 + slope_by_z1_3_by_tau*t14 + slope_by_z2_3_by_tau*t22
    # back through: d/dtau of: z2_1: linear in second-breaks-forward
    slope_by_z2_1_by_tau = chi*slope_by_z1_2_by_tau + slope_by_z2_2_by_tau - t50/z2_1_by_tau**2
    # back through: d/dtau of: functions of tau in slip-stick
    slope_by_sin_tau_by_tau = V*slope_by_z2_1_by_tau - e1*slope_by_v1_2_by_tau + slope_by_z1_2_by_tau*t35
    slope_by_cos_tau_by_tau = e1*slope_by_z1_2_by_tau + slope_by_v1_2_by_tau*t35 - slope_by_z2_1_by_tau*t3
    # back through: first return of tau2
    t54 = 1/(2*amplitude_tau2**2)
    slope_by_amplitude_tau2 = -slope_by_amplitude_tau2_by_tau*t40*t54 - slope_by_amplitude_tau2_by_tau1*t43*t54
    # back through: first return of tau2
    t55 = slope_by_amplitude_tau2_by_tau*t41
    t56 = slope_by_amplitude_tau2_by_tau1*t41
    slope_by_sine_part_tau2 = sine_part_tau2_by_tau*t55 + sine_part_tau2_by_tau1*t56 + slope_by_amplitude_tau2*t52
    slope_by_cosine_part_tau2 = slope_by_amplitude_tau2*t53 + t55*v2_3_by_tau + t56*v2_3_by_tau1
    # back through: slip-slip for tau1
    slope_by_v1_3 = omega3*slope_by_sine_part_tau2_by_tau1
    slope_by_v2_3 = slope_by_cosine_part_tau2 - slope_by_v1_3
    t57 = chi*eta*slope_by_v2_3_by_tau1 + omega3*slope_by_sine_part_tau2
    slope_by_z2_3 = chi*slope_by_v1_3_by_tau1 - t57
    slope_by_z1_3 = -slope_by_v1_3_by_tau1 + t57
    # back through: functions of tau1 in slip-slip
    t58 = p3*z1_2_by_tau
    t59 = p1*z2_2_by_tau
    t60 = p2*z2_2_by_tau
    t61 = t13*z1_2_by_tau
    t62 = p3*z1_2
    t63 = p1*z2_2
    t64 = p2*z2_2
    t65 = t13*z1_2
    t66 = V*p1
    t67 = p3*v1_2
    t68 = V*p2
    t69 = slope_by_z1_3_by_tau*v1_2_by_tau
    t70 = t13*t69
    t71 = p3*v1_2_by_tau
    t72 = slope_by_z2_3_by_tau*t71
    slope_by_sin_omega2_tau1 = slope_by_v1_3*(omega2*t64 - omega2*t65) + slope_by_v1_3_by_tau*(omega2*t60 - omega2*t61) + slope_by_v2_3*(omega2*t62 - omega2*t63) + slope_by_v2_3_by_tau*(omega2*t58 - omega2*t59) + slope_by_z1_3*(t13*t18*v1_2 - t18*t68) + slope_by_z2_3*(t18*t66 - t18*t67) + t18*t70 - t18*t72
    t73 = slope_by_v1_3_by_tau*v1_2_by_tau
    t74 = slope_by_v2_3_by_tau*t71
    slope_by_cos_omega2_tau1 = slope_by_v1_3*(t13*v1_2 - t68) + slope_by_v2_3*(t66 - t67) + slope_by_z1_3*(t13*z1_2 - t64) + slope_by_z1_3_by_tau*(t13*z1_2_by_tau - t60) + slope_by_z2_3*(p1*z2_2 - t62) + slope_by_z2_3_by_tau*(p1*z2_2_by_tau - t58) + t13*t73 - t74
    t75 = t13*z2_2_by_tau
    t76 = p1*z1_2_by_tau
    t77 = t13*z2_2
    t78 = p1*z1_2
    t79 = V*t13
    t80 = p1*v1_2
    t81 = p1*t69
    slope_by_sin_omega1_tau1 = slope_by_v1_3*(-omega1*t64 - omega1*t78) + slope_by_v1_3_by_tau*(-omega1*t60 - omega1*t76) + slope_by_v2_3*(-omega1*t62 - omega1*t77) + slope_by_v2_3_by_tau*(-omega1*t58 - omega1*t75) + slope_by_z1_3*(t16*t68 + t16*t80) + slope_by_z2_3*(t16*t67 + t16*t79) + t16*t72 + t16*t81
    slope_by_cos_omega1_tau1 = p1*t73 + slope_by_v1_3*(t68 + t80) + slope_by_v2_3*(t67 + t79) + slope_by_z1_3*(t64 + t78) + slope_by_z1_3_by_tau*(t60 + t76) + slope_by_z2_3*(t62 + t77) + slope_by_z2_3_by_tau*(t58 + t75) + t74
    # back through: slip-stick for tau
    slope_by_v1_2 = slope_by_v1_3*t14 + slope_by_v2_3*t22 + slope_by_z1_3*t20 + slope_by_z2_3*t24
    slope_by_z2_2 = slope_by_v1_3*t29 + slope_by_v2_3*t31 + slope_by_z1_3*t15 + slope_by_z2_3*t23
    slope_by_z1_2 = slope_by_v1_3*t28 + slope_by_v2_3*t30 + slope_by_z1_3*t14 + slope_by_z2_3*t22
    # back through: z2_1: linear in second-breaks-forward
    slope_by_z2_1 = chi*slope_by_z1_2 + slope_by_z2_2
    # back through: functions of tau in slip-stick
    t82 = V*slope_by_z2_1
    slope_by_sin_tau = -e1*slope_by_v1_2 + slope_by_z1_2*t35 + t82
    slope_by_cos_tau = e1*slope_by_z1_2 + slope_by_v1_2*t35 - slope_by_z2_1*t3
    # trace_gradient
    t83 = cos_omega2_tau1*slope_by_sin_omega2_tau1
    t84 = cos_omega1_tau1*slope_by_sin_omega1_tau1
    t85 = sin_omega2_tau1*slope_by_cos_omega2_tau1
    t86 = sin_omega1_tau1*slope_by_cos_omega1_tau1
    t87 = t2/omega3**2
    t88 = slope_by_sine_part_tau2*(z1_3 - z2_3) + slope_by_sine_part_tau2_by_tau*(z1_3_by_tau - z2_3_by_tau) + slope_by_sine_part_tau2_by_tau1*(v1_3 - v2_3) + t44*(-amplitude_tau2_by_tau*t87 + t49*t87)
    t89 = -t26 + t27
    t90 = cos_omega1_tau1 - cos_omega2_tau1
    t91 = t89*z1_2_by_tau + t90*v1_2_by_tau
    t92 = t17 - t19
    t93 = t90*z1_2_by_tau + t92*v1_2_by_tau
    t94 = t89*z1_2 + t90*v1_2
    t95 = t90*z1_2 + t92*v1_2
    t96 = slope_by_v2_3*t94 + slope_by_v2_3_by_tau*t91 + slope_by_z2_3*t95 + slope_by_z2_3_by_tau*t93
    t97 = slope_by_v1_3*(V*t90 + t89*z2_2) + slope_by_v1_3_by_tau*t89*z2_2_by_tau + slope_by_z1_3*(V*t92 + t90*z2_2) + slope_by_z1_3_by_tau*t90*z2_2_by_tau
    t98 = slope_by_v1_3*t94 + slope_by_v1_3_by_tau*t91 + slope_by_v2_3*(-V*t90 - t89*z2_2) - slope_by_v2_3_by_tau*t89*z2_2_by_tau + slope_by_z1_3*t95 + slope_by_z1_3_by_tau*t93 + slope_by_z2_3*(-V*t92 - t90*z2_2) - slope_by_z2_3_by_tau*t90*z2_2_by_tau
    t99 = 1/omega2**2
    t100 = sin_omega2_tau1*t99
    t101 = slope_by_v1_3*(sin_omega2_tau1*t64 - sin_omega2_tau1*t65) + slope_by_v1_3_by_tau*(sin_omega2_tau1*t60 - sin_omega2_tau1*t61) + slope_by_v2_3*(sin_omega2_tau1*t62 - sin_omega2_tau1*t63) + slope_by_v2_3_by_tau*(sin_omega2_tau1*t58 - sin_omega2_tau1*t59) + slope_by_z1_3*(-t100*t13*v1_2 + t100*t68) + slope_by_z2_3*(p3*sin_omega2_tau1*t99*v1_2 - t100*t66) - t100*t70 + t100*t72 + t83*tau1 - t85*tau1
    t102 = sin_omega1_tau1/omega1**2
    t103 = slope_by_v1_3*(-sin_omega1_tau1*t64 - sin_omega1_tau1*t78) + slope_by_v1_3_by_tau*(-sin_omega1_tau1*t60 - sin_omega1_tau1*t76) + slope_by_v2_3*(-sin_omega1_tau1*t62 - sin_omega1_tau1*t77) + slope_by_v2_3_by_tau*(-sin_omega1_tau1*t58 - sin_omega1_tau1*t75) + slope_by_z1_3*(-t102*t68 - t102*t80) + slope_by_z2_3*(-t102*t67 - t102*t79) - t102*t72 - t102*t81 + t84*tau1 - t86*tau1
    t104 = 1 - cos_tau
    t105 = -sin_tau + tau
    t106 = 1/t1**2
    t107 = t106*t45
    t108 = cos_tau_by_tau*slope_by_v1_2_by_tau
    t109 = slope_by_z2_1*t2
    trace_gradient = [0, 0, 0, V*chi*slope_by_z1_2 + V*slope_by_z2_2 - cos_tau*slope_by_cos_tau_by_tau + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau - sin_tau*slope_by_sin_tau_by_tau - t82, omega1*t84 - omega1*t86 + omega2*t83 - omega2*t85, 0, V*slope_by_v1_2*t104 - V*t108 + omega1_by_chi*t103 + omega2_by_chi*t101 + omega3_by_chi*t88 + p1_by_chi*t98 + p2_by_chi*t97 + p3_by_chi*t96 + slope_by_v1_3_by_tau1*z2_3 + slope_by_v2_3_by_tau1*(-eta*z2_3 + t37) + slope_by_z1_2*(V*t105 + cos_tau*z2_1 + t104*z2_1) + slope_by_z1_2_by_tau*(t32 + z2_2_by_tau) + slope_by_z2_1*(cos_tau*e1*t106 + t106*t5 + e2*t2/chi**2) + slope_by_z2_1_by_tau*t106*t33 + t44*(-amplitude_tau2_by_tau*t107 + t107*t49), omega1_by_eta*t103 + omega2_by_eta*t101 + omega3_by_eta*t88 + p1_by_eta*t98 + p2_by_eta*t97 + p3_by_eta*t96 + slope_by_v2_3_by_tau1*(chi*z1_3 - t36), -slope_by_cosine_part_tau2 + slope_by_v1_2*(chi + cos_tau - t8) + slope_by_v1_3*t15 + slope_by_v2_3*t23 + slope_by_z1_2*(sin_tau + t10) + slope_by_z1_2_by_tau*(chi - cos_tau*t1) + slope_by_z1_3*t21 - slope_by_z2_1*t105 + slope_by_z2_1_by_tau*(cos_tau - 1) + slope_by_z2_2*tau + slope_by_z2_2_by_tau + slope_by_z2_3*t25 - t1*t108, -cos_tau*slope_by_v1_2_by_tau + cos_tau*slope_by_z1_2 - cos_tau*t109 + cos_tau_by_tau*slope_by_z1_2_by_tau - cos_tau_by_tau*slope_by_z2_1_by_tau*t2 - sin_tau*slope_by_v1_2, -t109*t4]
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
    Operations: 185. Intermediate terms: 52.
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
    t5 = 1 - p1
    t6 = sin_omega1_tau1/omega1
    t7 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*t6 - p2*t7) + v1_2*(p1*t6 + t5*t7) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t5) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t8 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t9 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t7 + t5*t6) + t8*z1_2 + t9*z2_2 + v1_2*(p3*t6 - p3*t7)
    t10 = omega2*sin_omega2_tau1
    t11 = omega1*sin_omega1_tau1
    v2_3 = V*t9 + t8*v1_2 + z1_2*(p3*t10 - p3*t11) + z2_2*(-p1*t10 - t11*t5)
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
    t16 = V*chi
    t17 = -V + t16
    t18 = chi*z10
    t19 = chi*z2_1
    t20 = t19 - z1_1
    t21 = chi**2
    t22 = t21*z2_1
    t23 = V*t21 - t16
    t24 = -chi*t20
    t25 = -chi*t17
    t26 = V*p2
    t27 = p2*z2_2
    t28 = omega1*z1_2
    t29 = omega2*z1_2
    t30 = p3*v1_2
    t31 = chi*z1_3
    t32 = chi*(-z1_3 + z2_3)
    t33 = chi*(-V*t13 + t13*v2_3)
    coefficients = [-e1 - t15 + z10, -t17, -e1 + t15 - z10, t17, -e2 + t15 - t18, 0, -e2 - t15 + t18, 0, t17, 0, -t17, t20, -e2 + t19 - t22, -t23, -t24, -t25, -e2 - t19 + t22, t23, t24, t25, -V, 0, p1*v1_2 + t26, -t26 + t5*v1_2, -omega1*t27 - p1*t28, omega2*t27 - t29*t5, -V, 0, V*t5 + t30, V*p1 - t30, -omega1*t5*z2_2 - p3*t28, -omega2*p1*z2_2 + p3*t29, -e1 - t31 + z1_3, -t17, -t32, -t33, -e1 + t31 - z1_3, t17, t32, t33, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3]
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
    Operations: 495. Intermediate terms: 176.
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
    t4 = chi*tau - t3
    z1_2 = V*sin_tau + V*t4 + cos_tau*z1_1 + t2*z2_1
    z2_2 = V*tau + z2_1
    v1_2 = V*cos_tau + V*t2 - sin_tau*z1_1 + t3*z2_1
    # functions of tau1 in slip-slip
    t5 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t5)
    sin_omega1_tau1 = lib.sin(t5)
    t6 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t6)
    sin_omega2_tau1 = lib.sin(t6)
    # slip-slip for tau1, until first-reaches-belt
    t7 = 1 - p1
    t8 = cos_omega1_tau1*p1 + cos_omega2_tau1*t7
    t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t10 = sin_omega1_tau1/omega1
    t11 = sin_omega2_tau1/omega2
    t12 = p1*t10 + t11*t7
    t13 = p2*t10 - p2*t11
    z1_3 = V*t13 + t12*v1_2 + t8*z1_2 + t9*z2_2
    t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t15 = cos_omega1_tau1*t7 + cos_omega2_tau1*p1
    t16 = p3*t10 - p3*t11
    t17 = p1*t11 + t10*t7
    z2_3 = V*t17 + t14*z1_2 + t15*z2_2 + t16*v1_2
    t18 = omega1*sin_omega1_tau1
    t19 = omega2*sin_omega2_tau1
    t20 = -p1*t18 - t19*t7
    t21 = -p2*t18 + p2*t19
    v1_3 = V*t9 + t20*z1_2 + t21*z2_2 + t8*v1_2
    t22 = -p3*t18 + p3*t19
    t23 = p1*t19
    t24 = t18*t7
    t25 = -t23 - t24
    v2_3 = V*t15 + t14*v1_2 + t22*z1_2 + t25*z2_2
    # functions of tau2 in stick-slip
    t26 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t26)
    sin_omega3_tau2 = lib.sin(t26)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t27 = 1 - cos_omega3_tau2
    t28 = sin_omega3_tau2/omega3
    z2_4 = V*(-t28 + tau2) + cos_omega3_tau2*z2_3 + t27*z1_3 + t28*v2_3
    t29 = omega3*sin_omega3_tau2
    v2_4 = V*t27 + cos_omega3_tau2*v2_3 + t29*z1_3 - t29*z2_3
    # rate of the exit boundary after ta
    t30 = V*chi
    rate_1 = V - t30
    # derivatives of the time to the boundary after ta
    t31 = 1/rate_1
    delay_ta_by_z10 = -t31
    delay_ta_by_z20 = chi*t31
    # perturbation on the boundary after ta
    z2_1_on_boundary_by_z10 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t3*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t3*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t30
    # derivatives of the time to the boundary after tau
    t32 = 1/rate_2
    delay_tau_by_z10 = t32*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t32*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t33 = chi*z2_2
    before_v1_2 = t33 - z1_2
    v1_2_on_boundary_by_z10 = before_v1_2*delay_tau_by_z10 + carried_v1_2_by_z10
    v1_2_on_boundary_by_z20 = before_v1_2*delay_tau_by_z20 + carried_v1_2_by_z20
    # Phi along tau1
    carried_z1_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t8*z1_2_on_boundary_by_z10 + t9*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t8*z1_2_on_boundary_by_z20 + t9*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t14*z1_2_on_boundary_by_z10 + t15*z2_2_on_boundary_by_z10 + t16*v1_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t14*z1_2_on_boundary_by_z20 + t15*z2_2_on_boundary_by_z20 + t16*v1_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t20*z1_2_on_boundary_by_z10 + t21*z2_2_on_boundary_by_z10 + t8*v1_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t20*z1_2_on_boundary_by_z20 + t21*z2_2_on_boundary_by_z20 + t8*v1_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t14*v1_2_on_boundary_by_z10 + t22*z1_2_on_boundary_by_z10 + t25*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t14*v1_2_on_boundary_by_z20 + t22*z1_2_on_boundary_by_z20 + t25*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t34 = chi*z2_3
    rate_3 = t34 - z1_3
    # derivatives of the time to the boundary after tau1
    t35 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t35
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t35
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t36 = chi*eta
    before_v2_3 = -eta*t34 + t36*z1_3
    v2_3_on_boundary_by_z10 = before_v2_3*delay_tau1_by_z10 + carried_v2_3_by_z10
    v2_3_on_boundary_by_z20 = before_v2_3*delay_tau1_by_z20 + carried_v2_3_by_z20
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t27*z1_3_on_boundary_by_z10 + t28*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t27*z1_3_on_boundary_by_z20 + t28*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t29*z1_3_on_boundary_by_z10 - t29*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t29*z1_3_on_boundary_by_z20 - t29*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t36*z1_4 - t36*z2_4
    # derivatives of the time to the boundary after tau2
    t37 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t37
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t37
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
    behind_v2_2 = -eta*t33 + t36*z1_2
    # saltations
    saltation_1_20 = behind_v1_1/rate_1
    t38 = chi*saltation_1_20
    t39 = chi/rate_2
    t40 = 0
    t41 = behind_v2_2*t39
    t42 = 1/rate_3
    t43 = t42*(V - v1_3)
    t44 = 0
    t45 = (V - v2_4)/rate_4
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [saltation_1_20, -t38, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t40, t40, 1, 0], [-t41, t41, 0, 1], [1, 0, t43, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t44, 1], [1, 0, 0, 0], [0, 1, 0, t45], [0, 0, 1, 0], [0, 0, 0, 0]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # saltation of phase 1
    saltation_1_21 = -t38
    saltation_1_22 = saltation_1_20*ta + 1
    saltation_1_23 = -t38*ta
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    t46 = chi - t1
    phi_2_01 = saltation_1_21*sin_tau + t46
    phi_2_02 = cos_tau*ta + saltation_1_22*sin_tau
    phi_2_03 = saltation_1_23*sin_tau + t2*ta + t4
    phi_2_13 = ta + tau
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t3
    phi_2_22 = cos_tau*saltation_1_22 - sin_tau*ta
    phi_2_23 = cos_tau*saltation_1_23 + t3*ta + t46
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t40 + phi_2_20
    saltation_2_21 = -phi_2_01*t40 + phi_2_21 + t40
    saltation_2_22 = -phi_2_02*t40 + phi_2_22
    saltation_2_23 = -phi_2_03*t40 + phi_2_13*t40 + phi_2_23
    saltation_2_30 = -phi_2_00*t41
    saltation_2_31 = -phi_2_01*t41 + t41
    saltation_2_32 = -phi_2_02*t41
    saltation_2_33 = -phi_2_03*t41 + phi_2_13*t41 + 1
    # Phi of phase 3
    phi_3_00 = phi_2_00*t8 + saltation_2_20*t12 + saltation_2_30*t13
    phi_3_01 = phi_2_01*t8 + saltation_2_21*t12 + saltation_2_31*t13 + t9
    phi_3_02 = phi_2_02*t8 + saltation_2_22*t12 + saltation_2_32*t13
    phi_3_03 = phi_2_03*t8 + phi_2_13*t9 + saltation_2_23*t12 + saltation_2_33*t13
    phi_3_10 = phi_2_00*t14 + saltation_2_20*t16 + saltation_2_30*t17
    phi_3_11 = phi_2_01*t14 + saltation_2_21*t16 + saltation_2_31*t17 + t15
    phi_3_12 = phi_2_02*t14 + saltation_2_22*t16 + saltation_2_32*t17
    phi_3_13 = phi_2_03*t14 + phi_2_13*t15 + saltation_2_23*t16 + saltation_2_33*t17
    phi_3_20 = phi_2_00*t20 + saltation_2_20*t8 + saltation_2_30*t9
    phi_3_21 = phi_2_01*t20 + saltation_2_21*t8 + saltation_2_31*t9 + t21
    phi_3_22 = phi_2_02*t20 + saltation_2_22*t8 + saltation_2_32*t9
    phi_3_23 = phi_2_03*t20 + phi_2_13*t21 + saltation_2_23*t8 + saltation_2_33*t9
    phi_3_30 = phi_2_00*t22 + saltation_2_20*t14 + saltation_2_30*t15
    phi_3_31 = phi_2_01*t22 + saltation_2_21*t14 + saltation_2_31*t15 - t23 - t24
    phi_3_32 = phi_2_02*t22 + saltation_2_22*t14 + saltation_2_32*t15
    phi_3_33 = phi_2_03*t22 + phi_2_13*t25 + saltation_2_23*t14 + saltation_2_33*t15
    # saltation of phase 3
    saltation_3_00 = phi_3_00 + phi_3_20*t43
    saltation_3_01 = phi_3_01 + phi_3_21*t43
    saltation_3_02 = phi_3_02 + phi_3_22*t43
    saltation_3_03 = phi_3_03 + phi_3_23*t43
    saltation_3_30 = phi_3_20*t44 + phi_3_30
    saltation_3_31 = phi_3_21*t44 + phi_3_31
    saltation_3_32 = phi_3_22*t44 + phi_3_32
    saltation_3_33 = phi_3_23*t44 + phi_3_33
    # Phi of phase 4
    phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t27 + saltation_3_30*t28
    phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t27 + saltation_3_31*t28
    phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t27 + saltation_3_32*t28
    phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t27 + saltation_3_33*t28
    phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t29 + saltation_3_00*t29
    phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t29 + saltation_3_01*t29
    phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t29 + saltation_3_02*t29
    phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t29 + saltation_3_03*t29
    # saltation of phase 4
    saltation_4_10 = phi_4_10 + phi_4_30*t45
    saltation_4_11 = phi_4_11 + phi_4_31*t45
    saltation_4_12 = phi_4_12 + phi_4_32*t45
    saltation_4_13 = phi_4_13 + phi_4_33*t45
    monodromy = [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]
    return poincare_jacobian, saltations, monodromy


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
    [z1, z2, v1, v2] = state
    # state_after
    t0 = lib.sin(time)
    t1 = chi*t0
    t2 = lib.cos(time)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1), time*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def global_stick_flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 77. Intermediate terms: 15.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z1, z2, v1, v2] = state
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
    return [t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5), t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6), t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14), t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6)]


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
    [z1, z2, v1, v2] = state
    # state_after
    t0 = omega3*time
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [time*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(-t2 + time), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def global_stick_reduced(parameters, spectrum, reduced, *, lib, outputs=3):
    """All unknowns from the reduced ones; the equations for these and their derivatives.

    Takes parameters (5): chi, eta, V, e1, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (2): tau, tau1.
    Gives unknowns (6).
    Gives reduced_residual (2).
    Gives reduced_jacobian (2, 2).
    Operations: 217. Intermediate terms: 72.
    """
    [chi, eta, V, e1, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1] = reduced
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t0 = V*tau
    t1 = 1/(chi - 1)
    t2 = e1*t1
    z2_1 = V*sin_tau - cos_tau*t2 - t0 - e2*t1/chi
    # slip-stick for tau
    t3 = chi*z2_1
    t4 = e1 + t3
    t5 = -chi*cos_tau + chi
    z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t4 + t5*z2_1
    z2_2 = t0 + z2_1
    v1_2 = V*cos_tau + V*t5 + sin_tau*t3 - sin_tau*t4
    # functions of tau1 in slip-slip
    t6 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t6)
    sin_omega1_tau1 = lib.sin(t6)
    t7 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t7)
    sin_omega2_tau1 = lib.sin(t7)
    # slip-slip for tau1
    t8 = 1 - p1
    t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8
    t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t11 = sin_omega1_tau1/omega1
    t12 = sin_omega2_tau1/omega2
    t13 = p1*t11 + t12*t8
    z1_3 = V*(p2*t11 - p2*t12) + t10*z2_2 + t13*v1_2 + t9*z1_2
    t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t15 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1
    t16 = p3*t11 - p3*t12
    z2_3 = V*(p1*t12 + t11*t8) + t14*z1_2 + t15*z2_2 + t16*v1_2
    t17 = omega1*sin_omega1_tau1
    t18 = omega2*sin_omega2_tau1
    t19 = -p3*t17 + p3*t18
    t20 = -p1*t18 - t17*t8
    v2_3 = V*t15 + t14*v1_2 + t19*z1_2 + t20*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # first return of tau2
    t21 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t21
    sin_tau2_return = -cosine_part_tau2*t21
    # tau2: first return
    t22 = 1/omega3
    tau2 = t22*lib.angle(sin_tau2_return, cos_tau2_return)
    # ta: linear in time
    t23 = chi*z2_3
    t24 = sine_part_tau2*t22
    t25 = V*tau2
    t26 = amplitude_tau2*t22
    ta = -t1*(chi*t24 + chi*t25 - chi*t26 + e1 + t23 - t24 - t25 - z2_3)/V
    # unknowns
    t27 = t24 + t25 + z2_3
    unknowns = [t27, -t26 + t27, ta, tau, tau1, tau2]
    if outputs == 1:
        return unknowns
    # slip-slip for tau1
    t28 = -p1*t17 - t18*t8
    t29 = -p2*t17 + p2*t18
    v1_3 = V*t10 + t28*z1_2 + t29*z2_2 + t9*v1_2
    reduced_residual = [-V + v1_3, amplitude_tau2*t1*t22 - t2 - z2_1]
    if outputs == 2:
        return unknowns, reduced_residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t30 = cos_tau_by_tau*e1
    z2_1_by_tau = V*cos_tau - V - t1*t30
    # d/dtau of: slip-stick for tau
    t31 = V*chi
    t32 = V - t31
    z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t32 + t30 + t31
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t32
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t10*z2_2_by_tau + t13*v1_2_by_tau + t9*z1_2_by_tau
    z2_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t16*v1_2_by_tau
    v1_3_by_tau = t28*z1_2_by_tau + t29*z2_2_by_tau + t9*v1_2_by_tau
    v2_3_by_tau = t14*v1_2_by_tau + t19*z1_2_by_tau + t20*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    v1_3_by_tau1 = t23 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t23
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/dtau of: first return of tau2
    t33 = 2*cosine_part_tau2
    t34 = 2*sine_part_tau2
    t35 = t21/2
    amplitude_tau2_by_tau = t35*(sine_part_tau2_by_tau*t34 + t33*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t35*(sine_part_tau2_by_tau1*t34 + t33*v2_3_by_tau1)
    reduced_jacobian = [[v1_3_by_tau, v1_3_by_tau1], [amplitude_tau2_by_tau*t1*t22 - z2_1_by_tau, amplitude_tau2_by_tau1*t1*t22]]
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
    Operations: 258. Intermediate terms: 83.
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
    v1_2_by_z20 = chi*sin_tau
    t1 = chi*tau - v1_2_by_z20
    z1_2_by_v20 = t1 + ta*z1_2_by_z20
    z2_2_by_v20 = ta + tau
    v1_2_by_z10 = -sin_tau
    v1_2_by_v10 = cos_tau - sin_tau*ta
    v1_2_by_v20 = chi - t0 + ta*v1_2_by_z20
    # functions of tau1 in slip-slip
    t2 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t2)
    sin_omega1_tau1 = lib.sin(t2)
    t3 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t3)
    sin_omega2_tau1 = lib.sin(t3)
    # slip-slip after tau1, by the start
    t4 = 1 - p1
    t5 = cos_omega1_tau1*p1 + cos_omega2_tau1*t4
    t6 = sin_omega1_tau1/omega1
    t7 = sin_omega2_tau1/omega2
    t8 = p1*t6 + t4*t7
    z1_3_by_z10 = cos_tau*t5 + t8*v1_2_by_z10
    t9 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3_by_z20 = t5*z1_2_by_z20 + t8*v1_2_by_z20 + t9
    z1_3_by_v10 = t5*z1_2_by_v10 + t8*v1_2_by_v10
    z1_3_by_v20 = p2*t6 - p2*t7 + t5*z1_2_by_v20 + t8*v1_2_by_v20 + t9*z2_2_by_v20
    t10 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t11 = p3*t6 - p3*t7
    z2_3_by_z10 = cos_tau*t10 + t11*v1_2_by_z10
    t12 = cos_omega1_tau1*t4 + cos_omega2_tau1*p1
    z2_3_by_z20 = t10*z1_2_by_z20 + t11*v1_2_by_z20 + t12
    z2_3_by_v10 = t10*z1_2_by_v10 + t11*v1_2_by_v10
    z2_3_by_v20 = p1*t7 + t10*z1_2_by_v20 + t11*v1_2_by_v20 + t12*z2_2_by_v20 + t4*t6
    t13 = omega1*sin_omega1_tau1
    t14 = omega2*sin_omega2_tau1
    t15 = -p1*t13 - t14*t4
    v1_3_by_z10 = cos_tau*t15 + t5*v1_2_by_z10
    t16 = -p2*t13 + p2*t14
    v1_3_by_z20 = t15*z1_2_by_z20 + t16 + t5*v1_2_by_z20
    v1_3_by_v10 = t15*z1_2_by_v10 + t5*v1_2_by_v10
    v1_3_by_v20 = t15*z1_2_by_v20 + t16*z2_2_by_v20 + t5*v1_2_by_v20 + t9
    t17 = -p3*t13 + p3*t14
    v2_3_by_z10 = cos_tau*t17 + t10*v1_2_by_z10
    t18 = p1*t14 + t13*t4
    v2_3_by_z20 = t10*v1_2_by_z20 + t17*z1_2_by_z20 - t18
    v2_3_by_v10 = t10*v1_2_by_v10 + t17*z1_2_by_v10
    v2_3_by_v20 = t10*v1_2_by_v20 + t12 + t17*z1_2_by_v20 - t18*z2_2_by_v20
    # functions of tau2 in stick-slip
    t19 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t19)
    sin_omega3_tau2 = lib.sin(t19)
    # stick-slip after tau2, by the start
    z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10
    z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20
    z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10
    z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20
    t20 = 1 - cos_omega3_tau2
    t21 = sin_omega3_tau2/omega3
    t22 = -t21 + tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t20*z1_3_by_z10 + t21*v2_3_by_z10 + t22*v1_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t20*z1_3_by_z20 + t21*v2_3_by_z20 + t22*v1_3_by_z20
    z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t20*z1_3_by_v10 + t21*v2_3_by_v10 + t22*v1_3_by_v10
    z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t20*z1_3_by_v20 + t21*v2_3_by_v20 + t22*v1_3_by_v20
    t23 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t20*v1_3_by_z10 + t23*z1_3_by_z10 - t23*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t20*v1_3_by_z20 + t23*z1_3_by_z20 - t23*z2_3_by_z20
    v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t20*v1_3_by_v10 + t23*z1_3_by_v10 - t23*z2_3_by_v10
    v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t20*v1_3_by_v20 + t23*z1_3_by_v20 - t23*z2_3_by_v20
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
    t24 = 1/determinant
    z1_0 = numerator1*t24
    z2_0 = numerator2*t24
    linear_start = [z1_0, z2_0]
    if outputs == 2:
        return period_map, linear_start
    # stick-stick for ta, until first-breaks-forward
    t25 = V*ta
    z1_1 = t25 + z1_0
    z2_1 = t25 + z2_0
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*t1 + cos_tau*z1_1 + z1_2_by_z20*z2_1
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
    Operations: 673. Intermediate terms: 189.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, e1] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t0 = chi*cos_tau
    z1_2_by_z20 = chi - t0
    t1 = chi*tau
    v1_2_by_z20 = chi*sin_tau
    t2 = t1 - v1_2_by_z20
    z1_2 = V*sin_tau + V*t2 + cos_tau*z10 + z1_2_by_z20*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*z1_2_by_z20 - sin_tau*z10 + v1_2_by_z20*z20
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1 - p1
    t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5
    t7 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t8 = 1/omega1
    t9 = sin_omega1_tau1*t8
    t10 = 1/omega2
    t11 = sin_omega2_tau1*t10
    t12 = p1*t9 + t11*t5
    t13 = -p2*t11 + p2*t9
    z1_3 = V*t13 + t12*v1_2 + t6*z1_2 + t7*z2_2
    t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t15 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1
    t16 = -p3*t11 + p3*t9
    t17 = p1*t11 + t5*t9
    z2_3 = V*t17 + t14*z1_2 + t15*z2_2 + t16*v1_2
    t18 = omega1*sin_omega1_tau1
    t19 = omega2*sin_omega2_tau1
    t20 = -p1*t18 - t19*t5
    t21 = -p2*t18 + p2*t19
    t22 = V*t7
    v1_3 = t20*z1_2 + t21*z2_2 + t22 + t6*v1_2
    t23 = -p3*t18 + p3*t19
    t24 = p1*t19 + t18*t5
    t25 = V*t15
    v2_3 = t14*v1_2 + t23*z1_2 - t24*z2_2 + t25
    # functions of tau2 in stick-slip
    t26 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t26)
    sin_omega3_tau2 = lib.sin(t26)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t27 = 1 - cos_omega3_tau2
    t28 = 1/omega3
    t29 = sin_omega3_tau2*t28
    t30 = -t29 + tau2
    z2_4 = V*t30 + cos_omega3_tau2*z2_3 + t27*z1_3 + t29*v2_3
    t31 = omega3*z1_3
    t32 = omega3*z2_3
    v2_4 = V*t27 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t31 - sin_omega3_tau2*t32
    # residual
    t33 = chi*z20 - z10
    residual = [-e1 - t33, -chi*z1_2 + chi*z2_2 - e2, -V + v1_3, -V + v2_4, -z10 + z1_4, -z20 + z2_4]
    if outputs == 1:
        return residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    # d/dz10 of: slip-stick for tau, until second-breaks-forward
    v1_2_by_z10 = -sin_tau
    # d/dtau of: slip-stick for tau, until second-breaks-forward
    t34 = V*chi
    t35 = V - t34
    z1_2_by_tau = cos_tau*t35 - cos_tau_by_tau*t33 + t34
    v1_2_by_tau = cos_tau*t33 + cos_tau_by_tau*t35
    # d/dtau1 of: functions of tau1 in slip-slip
    cos_omega1_tau1_by_tau1 = -omega1*sin_omega1_tau1
    sin_omega1_tau1_by_tau1 = cos_omega1_tau1*omega1
    cos_omega2_tau1_by_tau1 = -omega2*sin_omega2_tau1
    sin_omega2_tau1_by_tau1 = cos_omega2_tau1*omega2
    # d/dz10 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z10 = cos_tau*t6 + t12*v1_2_by_z10
    z2_3_by_z10 = cos_tau*t14 + t16*v1_2_by_z10
    v1_3_by_z10 = cos_tau*t20 + t6*v1_2_by_z10
    v2_3_by_z10 = cos_tau*t23 + t14*v1_2_by_z10
    # d/dz20 of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_z20 = t12*v1_2_by_z20 + t6*z1_2_by_z20 + t7
    z2_3_by_z20 = t14*z1_2_by_z20 + t15 + t16*v1_2_by_z20
    v1_3_by_z20 = t20*z1_2_by_z20 + t21 + t6*v1_2_by_z20
    v2_3_by_z20 = t14*v1_2_by_z20 + t23*z1_2_by_z20 - t24
    # d/dtau of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_tau = t12*v1_2_by_tau + t22 + t6*z1_2_by_tau
    z2_3_by_tau = t14*z1_2_by_tau + t16*v1_2_by_tau + t25
    v1_3_by_tau = V*t21 + t20*z1_2_by_tau + t6*v1_2_by_tau
    v2_3_by_tau = -V*t24 + t14*v1_2_by_tau + t23*z1_2_by_tau
    # d/dtau1 of: slip-slip for tau1, until first-reaches-belt
    t36 = p2*z2_2
    t37 = p1*z1_2
    t38 = t36 + t37
    t39 = V*p2
    t40 = p1*v1_2
    t41 = t39*t8 + t40*t8
    t42 = -t36 + t5*z1_2
    t43 = -t10*t39 + t10*t5*v1_2
    z1_3_by_tau1 = cos_omega1_tau1_by_tau1*t38 + cos_omega2_tau1_by_tau1*t42 + sin_omega1_tau1_by_tau1*t41 + sin_omega2_tau1_by_tau1*t43
    t44 = p3*z1_2
    t45 = t5*z2_2
    t46 = t44 + t45
    t47 = p3*v1_2
    t48 = V*t5
    t49 = t47*t8 + t48*t8
    t50 = p1*z2_2 - t44
    t51 = V*p1
    t52 = -t10*t47 + t10*t51
    z2_3_by_tau1 = cos_omega1_tau1_by_tau1*t46 + cos_omega2_tau1_by_tau1*t50 + sin_omega1_tau1_by_tau1*t49 + sin_omega2_tau1_by_tau1*t52
    t53 = t39 + t40
    t54 = -omega1*t36 - omega1*t37
    t55 = -t39 + t5*v1_2
    t56 = t5*z1_2
    t57 = omega2*t36 - omega2*t56
    v1_3_by_tau1 = cos_omega1_tau1_by_tau1*t53 + cos_omega2_tau1_by_tau1*t55 + sin_omega1_tau1_by_tau1*t54 + sin_omega2_tau1_by_tau1*t57
    t58 = t47 + t48
    t59 = -omega1*t44 - omega1*t45
    t60 = -t47 + t51
    t61 = p1*z2_2
    t62 = omega2*t44 - omega2*t61
    v2_3_by_tau1 = cos_omega1_tau1_by_tau1*t58 + cos_omega2_tau1_by_tau1*t60 + sin_omega1_tau1_by_tau1*t59 + sin_omega2_tau1_by_tau1*t62
    # d/dtau2 of: functions of tau2 in stick-slip
    cos_omega3_tau2_by_tau2 = -omega3*sin_omega3_tau2
    sin_omega3_tau2_by_tau2 = cos_omega3_tau2*omega3
    # d/dz10 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t27*z1_3_by_z10 + t29*v2_3_by_z10
    t63 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t63*z1_3_by_z10 - t63*z2_3_by_z10
    # d/dz20 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t27*z1_3_by_z20 + t29*v2_3_by_z20
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t63*z1_3_by_z20 - t63*z2_3_by_z20
    # d/dtau of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau = cos_omega3_tau2*z2_3_by_tau + t27*z1_3_by_tau + t29*v2_3_by_tau
    v2_4_by_tau = cos_omega3_tau2*v2_3_by_tau + t63*z1_3_by_tau - t63*z2_3_by_tau
    # d/dtau1 of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_tau1 = cos_omega3_tau2*z2_3_by_tau1 + t27*z1_3_by_tau1 + t29*v2_3_by_tau1
    v2_4_by_tau1 = cos_omega3_tau2*v2_3_by_tau1 + t63*z1_3_by_tau1 - t63*z2_3_by_tau1
    # d/dtau2 of: stick-slip for tau2, until second-reaches-belt
    t64 = -z1_3 + z2_3
    t65 = -V*t28 + t28*v2_3
    z2_4_by_tau2 = V + cos_omega3_tau2_by_tau2*t64 + sin_omega3_tau2_by_tau2*t65
    t66 = -V + v2_3
    t67 = t31 - t32
    v2_4_by_tau2 = cos_omega3_tau2_by_tau2*t66 + sin_omega3_tau2_by_tau2*t67
    jacobian = [[1, -chi, 0, 0, 0, -1], [-t0, -chi*z1_2_by_z20 + chi, -chi*z1_2_by_tau + t34, 0, 0, 0], [v1_3_by_z10, v1_3_by_z20, v1_3_by_tau, v1_3_by_tau1, 0, 0], [v2_4_by_z10, v2_4_by_z20, v2_4_by_tau, v2_4_by_tau1, v2_4_by_tau2, 0], [z1_3_by_z10 - 1, z1_3_by_z20, z1_3_by_tau, z1_3_by_tau1, V, 0], [z2_4_by_z10, z2_4_by_z20 - 1, z2_4_by_tau, z2_4_by_tau1, z2_4_by_tau2, 0]]
    if outputs == 2:
        return residual, jacobian
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # d/dchi of: slip-stick for tau, until second-breaks-forward
    t68 = 1 - cos_tau
    z1_2_by_chi = V*(-sin_tau + tau) + t68*z20
    v1_2_by_chi = V*t68 + sin_tau*z20
    # d/dV of: slip-stick for tau, until second-breaks-forward
    z1_2_by_V = sin_tau + t2
    v1_2_by_V = chi + cos_tau - t0
    # d/dchi of: functions of tau1 in slip-slip
    t69 = omega1_by_chi*tau1
    cos_omega1_tau1_by_chi = -sin_omega1_tau1*t69
    sin_omega1_tau1_by_chi = cos_omega1_tau1*t69
    t70 = omega2_by_chi*tau1
    cos_omega2_tau1_by_chi = -sin_omega2_tau1*t70
    sin_omega2_tau1_by_chi = cos_omega2_tau1*t70
    # d/deta of: functions of tau1 in slip-slip
    t71 = omega1_by_eta*tau1
    cos_omega1_tau1_by_eta = -sin_omega1_tau1*t71
    sin_omega1_tau1_by_eta = cos_omega1_tau1*t71
    t72 = omega2_by_eta*tau1
    cos_omega2_tau1_by_eta = -sin_omega2_tau1*t72
    sin_omega2_tau1_by_eta = cos_omega2_tau1*t72
    # d/dchi of: slip-slip for tau1, until first-reaches-belt
    t73 = cos_omega1_tau1 - cos_omega2_tau1
    t74 = -t11 + t9
    t75 = V*t74 + t73*z2_2
    t76 = t73*z1_2 + t74*v1_2
    t77 = 1/omega2**2
    t78 = sin_omega2_tau1*t77
    t79 = t39*t78 - t5*t78*v1_2
    t80 = sin_omega1_tau1/omega1**2
    t81 = -t39*t80 - t40*t80
    z1_3_by_chi = cos_omega1_tau1_by_chi*t38 + cos_omega2_tau1_by_chi*t42 + omega1_by_chi*t81 + omega2_by_chi*t79 + p1_by_chi*t76 + p2_by_chi*t75 + sin_omega1_tau1_by_chi*t41 + sin_omega2_tau1_by_chi*t43 + t12*v1_2_by_chi + t6*z1_2_by_chi
    t82 = -V*t74 - t73*z2_2
    t83 = p3*sin_omega2_tau1*t77*v1_2 - t51*t78
    t84 = -t47*t80 - t48*t80
    z2_3_by_chi = cos_omega1_tau1_by_chi*t46 + cos_omega2_tau1_by_chi*t50 + omega1_by_chi*t84 + omega2_by_chi*t83 + p1_by_chi*t82 + p3_by_chi*t76 + sin_omega1_tau1_by_chi*t49 + sin_omega2_tau1_by_chi*t52 + t14*z1_2_by_chi + t16*v1_2_by_chi
    t85 = -t18 + t19
    t86 = V*t73 + t85*z2_2
    t87 = t73*v1_2 + t85*z1_2
    t88 = sin_omega2_tau1*t36 - sin_omega2_tau1*t56
    t89 = -sin_omega1_tau1*t36 - sin_omega1_tau1*t37
    v1_3_by_chi = cos_omega1_tau1_by_chi*t53 + cos_omega2_tau1_by_chi*t55 + omega1_by_chi*t89 + omega2_by_chi*t88 + p1_by_chi*t87 + p2_by_chi*t86 + sin_omega1_tau1_by_chi*t54 + sin_omega2_tau1_by_chi*t57 + t20*z1_2_by_chi + t6*v1_2_by_chi
    t90 = -V*t73 - t85*z2_2
    t91 = sin_omega2_tau1*t44 - sin_omega2_tau1*t61
    t92 = -sin_omega1_tau1*t44 - sin_omega1_tau1*t45
    v2_3_by_chi = cos_omega1_tau1_by_chi*t58 + cos_omega2_tau1_by_chi*t60 + omega1_by_chi*t92 + omega2_by_chi*t91 + p1_by_chi*t90 + p3_by_chi*t87 + sin_omega1_tau1_by_chi*t59 + sin_omega2_tau1_by_chi*t62 + t14*v1_2_by_chi + t23*z1_2_by_chi
    # d/deta of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_eta = cos_omega1_tau1_by_eta*t38 + cos_omega2_tau1_by_eta*t42 + omega1_by_eta*t81 + omega2_by_eta*t79 + p1_by_eta*t76 + p2_by_eta*t75 + sin_omega1_tau1_by_eta*t41 + sin_omega2_tau1_by_eta*t43
    z2_3_by_eta = cos_omega1_tau1_by_eta*t46 + cos_omega2_tau1_by_eta*t50 + omega1_by_eta*t84 + omega2_by_eta*t83 + p1_by_eta*t82 + p3_by_eta*t76 + sin_omega1_tau1_by_eta*t49 + sin_omega2_tau1_by_eta*t52
    v1_3_by_eta = cos_omega1_tau1_by_eta*t53 + cos_omega2_tau1_by_eta*t55 + omega1_by_eta*t89 + omega2_by_eta*t88 + p1_by_eta*t87 + p2_by_eta*t86 + sin_omega1_tau1_by_eta*t54 + sin_omega2_tau1_by_eta*t57
    v2_3_by_eta = cos_omega1_tau1_by_eta*t58 + cos_omega2_tau1_by_eta*t60 + omega1_by_eta*t92 + omega2_by_eta*t91 + p1_by_eta*t90 + p3_by_eta*t87 + sin_omega1_tau1_by_eta*t59 + sin_omega2_tau1_by_eta*t62
    # d/dV of: slip-slip for tau1, until first-reaches-belt
    z1_3_by_V = t12*v1_2_by_V + t13 + t6*z1_2_by_V + t7*tau
    z2_3_by_V = t14*z1_2_by_V + t15*tau + t16*v1_2_by_V + t17
    v1_3_by_V = t20*z1_2_by_V + t21*tau + t6*v1_2_by_V + t7
    v2_3_by_V = t14*v1_2_by_V + t15 + t23*z1_2_by_V - t24*tau
    # d/dchi of: functions of tau2 in stick-slip
    t93 = omega3_by_chi*tau2
    cos_omega3_tau2_by_chi = -sin_omega3_tau2*t93
    sin_omega3_tau2_by_chi = cos_omega3_tau2*t93
    # d/deta of: functions of tau2 in stick-slip
    t94 = omega3_by_eta*tau2
    cos_omega3_tau2_by_eta = -sin_omega3_tau2*t94
    sin_omega3_tau2_by_eta = cos_omega3_tau2*t94
    # d/dchi of: stick-slip for tau2, until second-reaches-belt
    t95 = sin_omega3_tau2/omega3**2
    t96 = V*t95 - t95*v2_3
    z2_4_by_chi = cos_omega3_tau2*z2_3_by_chi + cos_omega3_tau2_by_chi*t64 + omega3_by_chi*t96 + sin_omega3_tau2_by_chi*t65 + t27*z1_3_by_chi + t29*v2_3_by_chi
    t97 = sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3
    v2_4_by_chi = cos_omega3_tau2*v2_3_by_chi + cos_omega3_tau2_by_chi*t66 + omega3_by_chi*t97 + sin_omega3_tau2_by_chi*t67 + t63*z1_3_by_chi - t63*z2_3_by_chi
    # d/deta of: stick-slip for tau2, until second-reaches-belt
    z2_4_by_eta = cos_omega3_tau2*z2_3_by_eta + cos_omega3_tau2_by_eta*t64 + omega3_by_eta*t96 + sin_omega3_tau2_by_eta*t65 + t27*z1_3_by_eta + t29*v2_3_by_eta
    v2_4_by_eta = cos_omega3_tau2*v2_3_by_eta + cos_omega3_tau2_by_eta*t66 + omega3_by_eta*t97 + sin_omega3_tau2_by_eta*t67 + t63*z1_3_by_eta - t63*z2_3_by_eta
    # d/dV of: stick-slip for tau2, until second-reaches-belt
    z1_4_by_V = tau2 + z1_3_by_V
    z2_4_by_V = cos_omega3_tau2*z2_3_by_V + t27*z1_3_by_V + t29*v2_3_by_V + t30
    v2_4_by_V = cos_omega3_tau2*v2_3_by_V - cos_omega3_tau2 + t63*z1_3_by_V - t63*z2_3_by_V + 1
    parameter_jacobian = [[-z20, 0, 0, 0], [-chi*z1_2_by_chi - z1_2 + z2_2, 0, -chi*z1_2_by_V + t1, -1], [v1_3_by_chi, v1_3_by_eta, v1_3_by_V - 1, 0], [v2_4_by_chi, v2_4_by_eta, v2_4_by_V - 1, 0], [z1_3_by_chi, z1_3_by_eta, z1_4_by_V, 0], [z2_4_by_chi, z2_4_by_eta, z2_4_by_V, 0]]
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
    Operations: 1107. Intermediate terms: 250.
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
    t6 = 1 - p1
    t7 = cos_omega1_tau1*p1 + cos_omega2_tau1*t6
    t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t9 = 1/omega1
    t10 = sin_omega1_tau1*t9
    t11 = 1/omega2
    t12 = sin_omega2_tau1*t11
    t13 = p1*t10 + t12*t6
    t14 = p2*t10 - p2*t12
    z1_3 = V*t14 + t13*v1_2 + t7*z1_2 + t8*z2_2
    t15 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t16 = cos_omega1_tau1*t6 + cos_omega2_tau1*p1
    t17 = p3*t10 - p3*t12
    t18 = p1*t12 + t10*t6
    z2_3 = V*t18 + t15*z1_2 + t16*z2_2 + t17*v1_2
    t19 = omega1*sin_omega1_tau1
    t20 = omega2*sin_omega2_tau1
    t21 = -p1*t19 - t20*t6
    t22 = -p2*t19 + p2*t20
    v1_3 = V*t8 + t21*z1_2 + t22*z2_2 + t7*v1_2
    t23 = -p3*t19 + p3*t20
    t24 = -p1*t20 - t19*t6
    v2_3 = V*t16 + t15*v1_2 + t23*z1_2 + t24*z2_2
    # functions of tau2 in stick-slip
    t25 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t25)
    sin_omega3_tau2 = lib.sin(t25)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t26 = 1 - cos_omega3_tau2
    t27 = 1/omega3
    t28 = sin_omega3_tau2*t27
    t29 = -t28 + tau2
    z2_4 = V*t29 + cos_omega3_tau2*z2_3 + t26*z1_3 + t28*v2_3
    t30 = omega3*z1_3
    t31 = omega3*z2_3
    v2_4 = V*t26 + cos_omega3_tau2*v2_3 + sin_omega3_tau2*t30 - sin_omega3_tau2*t31
    # rate of the exit boundary after ta
    t32 = V*chi
    rate_1 = V - t32
    # derivatives of the time to the boundary after ta
    t33 = 1/rate_1
    delay_ta_by_z10 = -t33
    delay_ta_by_z20 = chi*t33
    # perturbation on the boundary after ta
    z2_1_on_boundary_by_z10 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + t1*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + t1*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t32
    # derivatives of the time to the boundary after tau
    t34 = 1/rate_2
    t35 = chi*z2_1_on_boundary_by_z10
    t36 = carried_z1_2_by_z10*chi - t35
    delay_tau_by_z10 = t34*t36
    t37 = chi*z2_1_on_boundary_by_z20
    t38 = carried_z1_2_by_z20*chi - t37
    delay_tau_by_z20 = t34*t38
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t39 = chi*z2_2 - z1_2
    v1_2_on_boundary_by_z10 = carried_v1_2_by_z10 + delay_tau_by_z10*t39
    v1_2_on_boundary_by_z20 = carried_v1_2_by_z20 + delay_tau_by_z20*t39
    # Phi along tau1
    carried_z1_3_by_z10 = t13*v1_2_on_boundary_by_z10 + t7*z1_2_on_boundary_by_z10 + t8*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t13*v1_2_on_boundary_by_z20 + t7*z1_2_on_boundary_by_z20 + t8*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t15*z1_2_on_boundary_by_z10 + t16*z2_2_on_boundary_by_z10 + t17*v1_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t15*z1_2_on_boundary_by_z20 + t16*z2_2_on_boundary_by_z20 + t17*v1_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t21*z1_2_on_boundary_by_z10 + t22*z2_2_on_boundary_by_z10 + t7*v1_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t21*z1_2_on_boundary_by_z20 + t22*z2_2_on_boundary_by_z20 + t7*v1_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t15*v1_2_on_boundary_by_z10 + t23*z1_2_on_boundary_by_z10 + t24*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t15*v1_2_on_boundary_by_z20 + t23*z1_2_on_boundary_by_z20 + t24*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t40 = chi*z2_3
    rate_3 = t40 - z1_3
    # derivatives of the time to the boundary after tau1
    t41 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t41
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t41
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t42 = eta*z1_3
    t43 = chi*t42 - eta*t40
    v2_3_on_boundary_by_z10 = carried_v2_3_by_z10 + delay_tau1_by_z10*t43
    v2_3_on_boundary_by_z20 = carried_v2_3_by_z20 + delay_tau1_by_z20*t43
    # Phi along tau2
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t26*z1_3_on_boundary_by_z20 + t28*v2_3_on_boundary_by_z20
    t44 = omega3*z1_3_on_boundary_by_z10
    t45 = omega3*z2_3_on_boundary_by_z10
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + sin_omega3_tau2*t44 - sin_omega3_tau2*t45
    t46 = omega3*z1_3_on_boundary_by_z20
    t47 = omega3*z2_3_on_boundary_by_z20
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + sin_omega3_tau2*t46 - sin_omega3_tau2*t47
    # rate of the exit boundary after tau2
    t48 = eta*z1_4
    t49 = eta*z2_4
    rate_4 = chi*t48 - chi*t49
    # derivatives of the time to the boundary after tau2
    t50 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t50
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t50
    # perturbation on the boundary after tau2
    z1_4_on_boundary_by_z10 = V*delay_tau2_by_z10 + z1_3_on_boundary_by_z10
    z2_4_on_boundary_by_z20 = carried_z2_4_by_z20 + delay_tau2_by_z20*v2_4
    trace = z1_4_on_boundary_by_z10 + z2_4_on_boundary_by_z20
    if outputs == 1:
        return trace
    [[_, _], [omega1_by_chi, omega1_by_eta], [omega2_by_chi, omega2_by_eta], [p1_by_chi, p1_by_eta], [p2_by_chi, p2_by_eta], [p3_by_chi, p3_by_eta], [omega3_by_chi, omega3_by_eta]] = spectrum_derivatives
    # back through: rate of the exit boundary after tau2
    t51 = 1/rate_4**2
    slope_by_rate_4 = V*carried_v2_4_by_z10*t51 + carried_v2_4_by_z20*t51*v2_4
    # back through: Phi along tau2
    slope_by_carried_v2_4_by_z20 = -t50*v2_4
    slope_by_carried_v2_4_by_z10 = -V*t50
    # back through: perturbation on the boundary after tau1
    slope_by_v2_3_on_boundary_by_z20 = cos_omega3_tau2*slope_by_carried_v2_4_by_z20 + t28
    slope_by_v2_3_on_boundary_by_z10 = cos_omega3_tau2*slope_by_carried_v2_4_by_z10
    t52 = omega3*sin_omega3_tau2
    t53 = -cos_omega3_tau2 + slope_by_carried_v2_4_by_z20*t52
    slope_by_z2_3_on_boundary_by_z20 = -t53
    t54 = slope_by_carried_v2_4_by_z10*t52
    slope_by_z2_3_on_boundary_by_z10 = -t54
    slope_by_z1_3_on_boundary_by_z20 = t53 + 1
    slope_by_z1_3_on_boundary_by_z10 = t54 + 1
    # back through: derivatives of the time to the boundary after tau1
    slope_by_delay_tau1_by_z20 = slope_by_v2_3_on_boundary_by_z20*t43 + slope_by_z1_3_on_boundary_by_z20*v1_3 + slope_by_z2_3_on_boundary_by_z20*v2_3
    slope_by_delay_tau1_by_z10 = slope_by_v2_3_on_boundary_by_z10*t43 + slope_by_z1_3_on_boundary_by_z10*v1_3 + slope_by_z2_3_on_boundary_by_z10*v2_3
    # back through: rate of the exit boundary after tau1
    t55 = 1/rate_3**2
    slope_by_rate_3 = carried_v1_3_by_z10*slope_by_delay_tau1_by_z10*t55 + carried_v1_3_by_z20*slope_by_delay_tau1_by_z20*t55
    # back through: Phi along tau1
    slope_by_carried_v1_3_by_z20 = -slope_by_delay_tau1_by_z20*t41
    slope_by_carried_v1_3_by_z10 = -slope_by_delay_tau1_by_z10*t41
    # back through: perturbation on the boundary after tau
    slope_by_v1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t7 + slope_by_v2_3_on_boundary_by_z20*t15 + slope_by_z1_3_on_boundary_by_z20*t13 + slope_by_z2_3_on_boundary_by_z20*t17
    slope_by_v1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t7 + slope_by_v2_3_on_boundary_by_z10*t15 + slope_by_z1_3_on_boundary_by_z10*t13 + slope_by_z2_3_on_boundary_by_z10*t17
    slope_by_z2_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t22 + slope_by_v2_3_on_boundary_by_z20*t24 + slope_by_z1_3_on_boundary_by_z20*t8 + slope_by_z2_3_on_boundary_by_z20*t16
    slope_by_z2_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t22 + slope_by_v2_3_on_boundary_by_z10*t24 + slope_by_z1_3_on_boundary_by_z10*t8 + slope_by_z2_3_on_boundary_by_z10*t16
    slope_by_z1_2_on_boundary_by_z20 = slope_by_carried_v1_3_by_z20*t21 + slope_by_v2_3_on_boundary_by_z20*t23 + slope_by_z1_3_on_boundary_by_z20*t7 + slope_by_z2_3_on_boundary_by_z20*t15
    slope_by_z1_2_on_boundary_by_z10 = slope_by_carried_v1_3_by_z10*t21 + slope_by_v2_3_on_boundary_by_z10*t23 + slope_by_z1_3_on_boundary_by_z10*t7 + slope_by_z2_3_on_boundary_by_z10*t15
    # back through: derivatives of the time to the boundary after tau
    slope_by_delay_tau_by_z20 = V*slope_by_z2_2_on_boundary_by_z20 + slope_by_v1_2_on_boundary_by_z20*t39 + slope_by_z1_2_on_boundary_by_z20*v1_2
    slope_by_delay_tau_by_z10 = V*slope_by_z2_2_on_boundary_by_z10 + slope_by_v1_2_on_boundary_by_z10*t39 + slope_by_z1_2_on_boundary_by_z10*v1_2
    # back through: rate of the exit boundary after tau
    t56 = 1/rate_2**2
    slope_by_rate_2 = -slope_by_delay_tau_by_z10*t36*t56 - slope_by_delay_tau_by_z20*t38*t56
    # back through: Phi along tau
    t57 = chi*t34
    t58 = slope_by_delay_tau_by_z20*t57
    slope_by_carried_z1_2_by_z20 = slope_by_z1_2_on_boundary_by_z20 + t58
    t59 = slope_by_delay_tau_by_z10*t57
    slope_by_carried_z1_2_by_z10 = slope_by_z1_2_on_boundary_by_z10 + t59
    # back through: perturbation on the boundary after ta
    slope_by_z2_1_on_boundary_by_z20 = slope_by_carried_z1_2_by_z20*t1 + slope_by_v1_2_on_boundary_by_z20*t2 + slope_by_z2_2_on_boundary_by_z20 - t58
    slope_by_z2_1_on_boundary_by_z10 = slope_by_carried_z1_2_by_z10*t1 + slope_by_v1_2_on_boundary_by_z10*t2 + slope_by_z2_2_on_boundary_by_z10 - t59
    t60 = sin_tau*slope_by_v1_2_on_boundary_by_z20
    slope_by_z1_1_on_boundary_by_z20 = cos_tau*slope_by_carried_z1_2_by_z20 - t60
    t61 = sin_tau*slope_by_v1_2_on_boundary_by_z10
    slope_by_z1_1_on_boundary_by_z10 = cos_tau*slope_by_carried_z1_2_by_z10 - t61
    # back through: derivatives of the time to the boundary after ta
    slope_by_delay_ta_by_z20 = V*slope_by_z1_1_on_boundary_by_z20 + V*slope_by_z2_1_on_boundary_by_z20
    slope_by_delay_ta_by_z10 = V*slope_by_z1_1_on_boundary_by_z10 + V*slope_by_z2_1_on_boundary_by_z10
    # back through: rate of the exit boundary after ta
    t62 = 1/rate_1**2
    slope_by_rate_1 = -chi*slope_by_delay_ta_by_z20*t62 + slope_by_delay_ta_by_z10*t62
    # back through: stick-slip for tau2, until second-reaches-belt
    t63 = chi*eta
    slope_by_z1_4 = slope_by_rate_4*t63
    slope_by_z2_4 = -slope_by_z1_4
    # back through: functions of tau2 in stick-slip
    slope_by_sin_omega3_tau2 = delay_tau2_by_z20*(t30 - t31) + slope_by_carried_v2_4_by_z10*(t44 - t45) + slope_by_carried_v2_4_by_z20*(t46 - t47) + slope_by_z2_4*(-V*t27 + t27*v2_3) + t27*v2_3_on_boundary_by_z20
    slope_by_cos_omega3_tau2 = delay_tau2_by_z20*(-V + v2_3) + slope_by_carried_v2_4_by_z10*v2_3_on_boundary_by_z10 + slope_by_carried_v2_4_by_z20*v2_3_on_boundary_by_z20 + slope_by_z2_4*(-z1_3 + z2_3) - z1_3_on_boundary_by_z20 + z2_3_on_boundary_by_z20
    # back through: slip-slip for tau1, until first-reaches-belt
    slope_by_v2_3 = cos_omega3_tau2*delay_tau2_by_z20 + delay_tau1_by_z10*slope_by_z2_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z2_3_on_boundary_by_z20 + slope_by_z2_4*t28
    slope_by_v1_3 = delay_tau1_by_z10*slope_by_z1_3_on_boundary_by_z10 + delay_tau1_by_z20*slope_by_z1_3_on_boundary_by_z20
    t64 = delay_tau1_by_z10*slope_by_v2_3_on_boundary_by_z10
    t65 = delay_tau1_by_z20*slope_by_v2_3_on_boundary_by_z20
    t66 = delay_tau2_by_z20*t52 + t63*t64 + t63*t65
    slope_by_z2_3 = chi*slope_by_rate_3 + cos_omega3_tau2*slope_by_z2_4 - t66
    slope_by_z1_3 = -slope_by_rate_3 + slope_by_z1_4 + slope_by_z2_4*t26 + t66
    # back through: functions of tau1 in slip-slip
    t67 = p3*z1_2_on_boundary_by_z20
    t68 = p1*z2_2_on_boundary_by_z20
    t69 = p3*z1_2_on_boundary_by_z10
    t70 = p1*z2_2_on_boundary_by_z10
    t71 = p2*z2_2_on_boundary_by_z20
    t72 = t6*z1_2_on_boundary_by_z20
    t73 = p2*z2_2_on_boundary_by_z10
    t74 = t6*z1_2_on_boundary_by_z10
    t75 = p3*z1_2
    t76 = p1*z2_2
    t77 = p2*z2_2
    t78 = t6*z1_2
    t79 = V*p1
    t80 = p3*v1_2
    t81 = V*p2
    t82 = t11*t6
    t83 = slope_by_z1_3_on_boundary_by_z10*v1_2_on_boundary_by_z10
    t84 = slope_by_z1_3_on_boundary_by_z20*v1_2_on_boundary_by_z20
    t85 = p3*v1_2_on_boundary_by_z10
    t86 = slope_by_z2_3_on_boundary_by_z10*t85
    t87 = p3*v1_2_on_boundary_by_z20
    t88 = slope_by_z2_3_on_boundary_by_z20*t87
    slope_by_sin_omega2_tau1 = slope_by_carried_v1_3_by_z10*(omega2*t73 - omega2*t74) + slope_by_carried_v1_3_by_z20*(omega2*t71 - omega2*t72) + slope_by_v1_3*(omega2*t77 - omega2*t78) + slope_by_v2_3*(omega2*t75 - omega2*t76) + slope_by_v2_3_on_boundary_by_z10*(omega2*t69 - omega2*t70) + slope_by_v2_3_on_boundary_by_z20*(omega2*t67 - omega2*t68) + slope_by_z1_3*(t11*t6*v1_2 - t11*t81) + slope_by_z2_3*(t11*t79 - t11*t80) - t11*t86 - t11*t88 + t82*t83 + t82*t84
    t89 = slope_by_carried_v1_3_by_z10*v1_2_on_boundary_by_z10
    t90 = slope_by_carried_v1_3_by_z20*v1_2_on_boundary_by_z20
    t91 = slope_by_v2_3_on_boundary_by_z10*t85
    t92 = slope_by_v2_3_on_boundary_by_z20*t87
    slope_by_cos_omega2_tau1 = slope_by_v1_3*(t6*v1_2 - t81) + slope_by_v2_3*(t79 - t80) + slope_by_z1_3*(t6*z1_2 - t77) + slope_by_z1_3_on_boundary_by_z10*(t6*z1_2_on_boundary_by_z10 - t73) + slope_by_z1_3_on_boundary_by_z20*(t6*z1_2_on_boundary_by_z20 - t71) + slope_by_z2_3*(p1*z2_2 - t75) + slope_by_z2_3_on_boundary_by_z10*(p1*z2_2_on_boundary_by_z10 - t69) + slope_by_z2_3_on_boundary_by_z20*(p1*z2_2_on_boundary_by_z20 - t67) + t6*t89 + t6*t90 - t91 - t92
    t93 = t6*z2_2_on_boundary_by_z20
    t94 = t6*z2_2_on_boundary_by_z10
    t95 = p1*z1_2_on_boundary_by_z20
    t96 = p1*z1_2_on_boundary_by_z10
    t97 = t6*z2_2
    t98 = p1*z1_2
    t99 = V*t6
    t100 = p1*v1_2
    t101 = p1*t9
    slope_by_sin_omega1_tau1 = slope_by_carried_v1_3_by_z10*(-omega1*t73 - omega1*t96) + slope_by_carried_v1_3_by_z20*(-omega1*t71 - omega1*t95) + slope_by_v1_3*(-omega1*t77 - omega1*t98) + slope_by_v2_3*(-omega1*t75 - omega1*t97) + slope_by_v2_3_on_boundary_by_z10*(-omega1*t69 - omega1*t94) + slope_by_v2_3_on_boundary_by_z20*(-omega1*t67 - omega1*t93) + slope_by_z1_3*(t100*t9 + t81*t9) + slope_by_z2_3*(t80*t9 + t9*t99) + t101*t83 + t101*t84 + t86*t9 + t88*t9
    slope_by_cos_omega1_tau1 = p1*t89 + p1*t90 + slope_by_v1_3*(t100 + t81) + slope_by_v2_3*(t80 + t99) + slope_by_z1_3*(t77 + t98) + slope_by_z1_3_on_boundary_by_z10*(t73 + t96) + slope_by_z1_3_on_boundary_by_z20*(t71 + t95) + slope_by_z2_3*(t75 + t97) + slope_by_z2_3_on_boundary_by_z10*(t69 + t94) + slope_by_z2_3_on_boundary_by_z20*(t67 + t93) + t91 + t92
    # back through: slip-stick for tau, until second-breaks-forward
    t102 = chi*slope_by_rate_2
    slope_by_v1_2 = delay_tau_by_z10*slope_by_z1_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z1_2_on_boundary_by_z20 + slope_by_v1_3*t7 + slope_by_v2_3*t15 + slope_by_z1_3*t13 + slope_by_z2_3*t17 - t102
    t103 = delay_tau_by_z10*slope_by_v1_2_on_boundary_by_z10
    t104 = delay_tau_by_z20*slope_by_v1_2_on_boundary_by_z20
    slope_by_z2_2 = chi*t103 + chi*t104 + slope_by_v1_3*t22 + slope_by_v2_3*t24 + slope_by_z1_3*t8 + slope_by_z2_3*t16
    slope_by_z1_2 = slope_by_v1_3*t21 + slope_by_v2_3*t23 + slope_by_z1_3*t7 + slope_by_z2_3*t15 - t103 - t104
    # back through: functions of tau in slip-stick
    t105 = t37 - z1_1_on_boundary_by_z20
    t106 = t35 - z1_1_on_boundary_by_z10
    t107 = chi*z20 - z10
    slope_by_sin_tau = rate_1*slope_by_z1_2 + slope_by_v1_2*t107 + slope_by_v1_2_on_boundary_by_z10*t106 + slope_by_v1_2_on_boundary_by_z20*t105
    slope_by_cos_tau = rate_1*slope_by_v1_2 - slope_by_carried_z1_2_by_z10*t106 - slope_by_carried_z1_2_by_z20*t105 - slope_by_z1_2*t107
    # trace_gradient
    t108 = cos_omega2_tau1*slope_by_sin_omega2_tau1
    t109 = cos_omega1_tau1*slope_by_sin_omega1_tau1
    t110 = sin_omega2_tau1*slope_by_cos_omega2_tau1
    t111 = sin_omega1_tau1*slope_by_cos_omega1_tau1
    t112 = cos_omega3_tau2*slope_by_sin_omega3_tau2
    t113 = sin_omega3_tau2*slope_by_cos_omega3_tau2
    t114 = sin_omega3_tau2/omega3**2
    t115 = delay_tau2_by_z20*(sin_omega3_tau2*z1_3 - sin_omega3_tau2*z2_3) + slope_by_carried_v2_4_by_z10*(sin_omega3_tau2*z1_3_on_boundary_by_z10 - sin_omega3_tau2*z2_3_on_boundary_by_z10) + slope_by_carried_v2_4_by_z20*(sin_omega3_tau2*z1_3_on_boundary_by_z20 - sin_omega3_tau2*z2_3_on_boundary_by_z20) + slope_by_z2_4*(V*t114 - t114*v2_3) + t112*tau2 - t113*tau2 - t114*v2_3_on_boundary_by_z20
    t116 = -t19 + t20
    t117 = cos_omega1_tau1 - cos_omega2_tau1
    t118 = t116*z1_2_on_boundary_by_z20 + t117*v1_2_on_boundary_by_z20
    t119 = t116*z1_2_on_boundary_by_z10 + t117*v1_2_on_boundary_by_z10
    t120 = t10 - t12
    t121 = t117*z1_2_on_boundary_by_z20 + t120*v1_2_on_boundary_by_z20
    t122 = t117*z1_2_on_boundary_by_z10 + t120*v1_2_on_boundary_by_z10
    t123 = t116*z1_2 + t117*v1_2
    t124 = t117*z1_2 + t120*v1_2
    t125 = slope_by_v2_3*t123 + slope_by_v2_3_on_boundary_by_z10*t119 + slope_by_v2_3_on_boundary_by_z20*t118 + slope_by_z2_3*t124 + slope_by_z2_3_on_boundary_by_z10*t122 + slope_by_z2_3_on_boundary_by_z20*t121
    t126 = slope_by_carried_v1_3_by_z10*t116*z2_2_on_boundary_by_z10 + slope_by_carried_v1_3_by_z20*t116*z2_2_on_boundary_by_z20 + slope_by_v1_3*(V*t117 + t116*z2_2) + slope_by_z1_3*(V*t120 + t117*z2_2) + slope_by_z1_3_on_boundary_by_z10*t117*z2_2_on_boundary_by_z10 + slope_by_z1_3_on_boundary_by_z20*t117*z2_2_on_boundary_by_z20
    t127 = slope_by_carried_v1_3_by_z10*t119 + slope_by_carried_v1_3_by_z20*t118 + slope_by_v1_3*t123 + slope_by_v2_3*(-V*t117 - t116*z2_2) - slope_by_v2_3_on_boundary_by_z10*t116*z2_2_on_boundary_by_z10 - slope_by_v2_3_on_boundary_by_z20*t116*z2_2_on_boundary_by_z20 + slope_by_z1_3*t124 + slope_by_z1_3_on_boundary_by_z10*t122 + slope_by_z1_3_on_boundary_by_z20*t121 + slope_by_z2_3*(-V*t120 - t117*z2_2) - slope_by_z2_3_on_boundary_by_z10*t117*z2_2_on_boundary_by_z10 - slope_by_z2_3_on_boundary_by_z20*t117*z2_2_on_boundary_by_z20
    t128 = 1/omega2**2
    t129 = sin_omega2_tau1*t128
    t130 = t129*t6
    t131 = slope_by_carried_v1_3_by_z10*(sin_omega2_tau1*t73 - sin_omega2_tau1*t74) + slope_by_carried_v1_3_by_z20*(sin_omega2_tau1*t71 - sin_omega2_tau1*t72) + slope_by_v1_3*(sin_omega2_tau1*t77 - sin_omega2_tau1*t78) + slope_by_v2_3*(sin_omega2_tau1*t75 - sin_omega2_tau1*t76) + slope_by_v2_3_on_boundary_by_z10*(sin_omega2_tau1*t69 - sin_omega2_tau1*t70) + slope_by_v2_3_on_boundary_by_z20*(sin_omega2_tau1*t67 - sin_omega2_tau1*t68) + slope_by_z1_3*(-t129*t6*v1_2 + t129*t81) + slope_by_z2_3*(p3*sin_omega2_tau1*t128*v1_2 - t129*t79) + t108*tau1 - t110*tau1 + t129*t86 + t129*t88 - t130*t83 - t130*t84
    t132 = sin_omega1_tau1/omega1**2
    t133 = p1*t132
    t134 = slope_by_carried_v1_3_by_z10*(-sin_omega1_tau1*t73 - sin_omega1_tau1*t96) + slope_by_carried_v1_3_by_z20*(-sin_omega1_tau1*t71 - sin_omega1_tau1*t95) + slope_by_v1_3*(-sin_omega1_tau1*t77 - sin_omega1_tau1*t98) + slope_by_v2_3*(-sin_omega1_tau1*t75 - sin_omega1_tau1*t97) + slope_by_v2_3_on_boundary_by_z10*(-sin_omega1_tau1*t69 - sin_omega1_tau1*t94) + slope_by_v2_3_on_boundary_by_z20*(-sin_omega1_tau1*t67 - sin_omega1_tau1*t93) + slope_by_z1_3*(-t100*t132 - t132*t81) + slope_by_z2_3*(-t132*t80 - t132*t99) + t109*tau1 - t111*tau1 - t132*t86 - t132*t88 - t133*t83 - t133*t84
    t135 = 1 - cos_tau
    t136 = -eta*z2_3 + t42
    t137 = chi*z1_3 - t40
    trace_gradient = [cos_tau*slope_by_z1_2 - sin_tau*slope_by_v1_2, slope_by_v1_2*t2 + slope_by_z1_2*t1 + slope_by_z2_2, V*slope_by_z2_2 + cos_tau*slope_by_sin_tau - sin_tau*slope_by_cos_tau + slope_by_z1_2*t32, omega1*t109 - omega1*t111 + omega2*t108 - omega2*t110, V*slope_by_z1_4 + V*slope_by_z2_4 + omega3*t112 - omega3*t113, 0, -V*slope_by_rate_1 + omega1_by_chi*t134 + omega2_by_chi*t131 + omega3_by_chi*t115 + p1_by_chi*t127 + p2_by_chi*t126 + p3_by_chi*t125 + slope_by_carried_z1_2_by_z10*t135*z2_1_on_boundary_by_z10 + slope_by_carried_z1_2_by_z20*t135*z2_1_on_boundary_by_z20 + slope_by_delay_ta_by_z20*t33 + slope_by_delay_tau_by_z10*t34*(carried_z1_2_by_z10 - z2_1_on_boundary_by_z10) + slope_by_delay_tau_by_z20*t34*(carried_z1_2_by_z20 - z2_1_on_boundary_by_z20) + slope_by_rate_2*(V - v1_2) + slope_by_rate_3*z2_3 + slope_by_rate_4*(t48 - t49) + slope_by_v1_2*(V*t135 + sin_tau*z20) + slope_by_z1_2*(V*(-sin_tau + tau) + t135*z20) + t103*z2_2 + t104*z2_2 + t136*t64 + t136*t65 + t60*z2_1_on_boundary_by_z20 + t61*z2_1_on_boundary_by_z10, omega1_by_eta*t134 + omega2_by_eta*t131 + omega3_by_eta*t115 + p1_by_eta*t127 + p2_by_eta*t126 + p3_by_eta*t125 + slope_by_rate_4*(chi*z1_4 - chi*z2_4) + t137*t64 + t137*t65, delay_ta_by_z10*slope_by_z1_1_on_boundary_by_z10 + delay_ta_by_z10*slope_by_z2_1_on_boundary_by_z10 + delay_ta_by_z20*slope_by_z1_1_on_boundary_by_z20 + delay_ta_by_z20*slope_by_z2_1_on_boundary_by_z20 + delay_tau2_by_z10 + delay_tau2_by_z20*t26 + delay_tau_by_z10*slope_by_z2_2_on_boundary_by_z10 + delay_tau_by_z20*slope_by_z2_2_on_boundary_by_z20 + slope_by_rate_1*(1 - chi) + slope_by_v1_2*(chi + cos_tau - t0) + slope_by_v1_3*t8 + slope_by_v2_3*t16 + slope_by_z1_2*(sin_tau + t3) + slope_by_z1_3*t14 + slope_by_z1_4*tau2 + slope_by_z2_2*tau + slope_by_z2_3*t18 + slope_by_z2_4*t29 + t102, 0]
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
    Operations: 181. Intermediate terms: 50.
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
    t4 = 1 - p1
    t5 = sin_omega1_tau1/omega1
    t6 = sin_omega2_tau1/omega2
    z1_3 = V*(p2*t5 - p2*t6) + v1_2*(p1*t5 + t4*t6) + z1_2*(cos_omega1_tau1*p1 + cos_omega2_tau1*t4) + z2_2*(cos_omega1_tau1*p2 - cos_omega2_tau1*p2)
    t7 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t8 = cos_omega1_tau1*t4 + cos_omega2_tau1*p1
    z2_3 = V*(p1*t6 + t4*t5) + t7*z1_2 + t8*z2_2 + v1_2*(p3*t5 - p3*t6)
    t9 = omega2*sin_omega2_tau1
    t10 = omega1*sin_omega1_tau1
    v2_3 = V*t8 + t7*v1_2 + z1_2*(-p3*t10 + p3*t9) + z2_2*(-p1*t9 - t10*t4)
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
    t16 = V*chi
    t17 = -V + t16
    t18 = chi*z10
    t19 = e2 - t14
    t20 = e2 + t14
    t21 = chi**2
    t22 = t21*z20
    t23 = V*t21 - t16
    t24 = -chi*t15
    t25 = -chi*t17
    t26 = V*p2
    t27 = p2*z2_2
    t28 = omega1*z1_2
    t29 = omega2*z1_2
    t30 = p3*v1_2
    t31 = chi*z1_3
    t32 = chi*(-z1_3 + z2_3)
    t33 = chi*(-V*t12 + t12*v2_3)
    coefficients = [-e1 - t15, -t17, -e1 + t14 - z10, t17, -t18 - t19, 0, t18 - t20, 0, t17, 0, -t17, t15, -t19 - t22, -t23, -t24, -t25, -t20 + t22, t23, t24, t25, -V, 0, p1*v1_2 + t26, -t26 + t4*v1_2, -omega1*t27 - p1*t28, omega2*t27 - t29*t4, -V, 0, V*t4 + t30, V*p1 - t30, -omega1*t4*z2_2 - p3*t28, -omega2*p1*z2_2 + p3*t29, -e1 - t31 + z1_3, -t17, -t32, -t33, -e1 + t31 - z1_3, t17, t32, t33, 0, 0, -V + v2_3, omega3*z1_3 - omega3*z2_3]
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
    Operations: 476. Intermediate terms: 169.
    """
    [chi, eta, V, _] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [z10, z20, tau, tau1, tau2, _] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick for tau, until second-breaks-forward
    t0 = chi*cos_tau
    phi_2_23 = chi - t0
    t1 = chi*tau
    t2 = chi*sin_tau
    phi_2_03 = t1 - t2
    z1_2 = V*phi_2_03 + V*sin_tau + cos_tau*z10 + phi_2_23*z20
    z2_2 = V*tau + z20
    v1_2 = V*cos_tau + V*phi_2_23 - sin_tau*z10 + t2*z20
    # functions of tau1 in slip-slip
    t3 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t3)
    sin_omega1_tau1 = lib.sin(t3)
    t4 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t4)
    sin_omega2_tau1 = lib.sin(t4)
    # slip-slip for tau1, until first-reaches-belt
    t5 = 1 - p1
    t6 = cos_omega1_tau1*p1 + cos_omega2_tau1*t5
    t7 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t8 = sin_omega1_tau1/omega1
    t9 = sin_omega2_tau1/omega2
    t10 = p1*t8 + t5*t9
    t11 = p2*t8 - p2*t9
    z1_3 = V*t11 + t10*v1_2 + t6*z1_2 + t7*z2_2
    t12 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t13 = cos_omega1_tau1*t5 + cos_omega2_tau1*p1
    t14 = p3*t8 - p3*t9
    t15 = p1*t9 + t5*t8
    z2_3 = V*t15 + t12*z1_2 + t13*z2_2 + t14*v1_2
    t16 = omega1*sin_omega1_tau1
    t17 = omega2*sin_omega2_tau1
    t18 = -p1*t16 - t17*t5
    t19 = -p2*t16 + p2*t17
    v1_3 = V*t7 + t18*z1_2 + t19*z2_2 + t6*v1_2
    t20 = -p3*t16 + p3*t17
    t21 = p1*t17
    t22 = t16*t5
    t23 = -t21 - t22
    v2_3 = V*t13 + t12*v1_2 + t20*z1_2 + t23*z2_2
    # functions of tau2 in stick-slip
    t24 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t24)
    sin_omega3_tau2 = lib.sin(t24)
    # stick-slip for tau2, until second-reaches-belt
    z1_4 = V*tau2 + z1_3
    t25 = 1 - cos_omega3_tau2
    t26 = sin_omega3_tau2/omega3
    z2_4 = V*(-t26 + tau2) + cos_omega3_tau2*z2_3 + t25*z1_3 + t26*v2_3
    t27 = omega3*sin_omega3_tau2
    v2_4 = V*t25 + cos_omega3_tau2*v2_3 + t27*z1_3 - t27*z2_3
    # rate of the exit boundary after ta
    t28 = V*chi
    rate_1 = V - t28
    # derivatives of the time to the boundary after ta
    t29 = 1/rate_1
    delay_ta_by_z10 = -t29
    delay_ta_by_z20 = chi*t29
    # perturbation on the boundary after ta
    z2_1_on_boundary_by_z10 = V*delay_ta_by_z10
    z1_1_on_boundary_by_z10 = z2_1_on_boundary_by_z10 + 1
    z1_1_on_boundary_by_z20 = V*delay_ta_by_z20
    z2_1_on_boundary_by_z20 = z1_1_on_boundary_by_z20 + 1
    # Phi along tau
    carried_z1_2_by_z10 = cos_tau*z1_1_on_boundary_by_z10 + phi_2_23*z2_1_on_boundary_by_z10
    carried_z1_2_by_z20 = cos_tau*z1_1_on_boundary_by_z20 + phi_2_23*z2_1_on_boundary_by_z20
    carried_v1_2_by_z10 = -sin_tau*z1_1_on_boundary_by_z10 + t2*z2_1_on_boundary_by_z10
    carried_v1_2_by_z20 = -sin_tau*z1_1_on_boundary_by_z20 + t2*z2_1_on_boundary_by_z20
    # rate of the exit boundary after tau
    rate_2 = -chi*v1_2 + t28
    # derivatives of the time to the boundary after tau
    t30 = 1/rate_2
    delay_tau_by_z10 = t30*(carried_z1_2_by_z10*chi - chi*z2_1_on_boundary_by_z10)
    delay_tau_by_z20 = t30*(carried_z1_2_by_z20*chi - chi*z2_1_on_boundary_by_z20)
    # perturbation on the boundary after tau
    z1_2_on_boundary_by_z10 = carried_z1_2_by_z10 + delay_tau_by_z10*v1_2
    z1_2_on_boundary_by_z20 = carried_z1_2_by_z20 + delay_tau_by_z20*v1_2
    z2_2_on_boundary_by_z10 = V*delay_tau_by_z10 + z2_1_on_boundary_by_z10
    z2_2_on_boundary_by_z20 = V*delay_tau_by_z20 + z2_1_on_boundary_by_z20
    t31 = chi*z2_2
    before_v1_2 = t31 - z1_2
    v1_2_on_boundary_by_z10 = before_v1_2*delay_tau_by_z10 + carried_v1_2_by_z10
    v1_2_on_boundary_by_z20 = before_v1_2*delay_tau_by_z20 + carried_v1_2_by_z20
    # Phi along tau1
    carried_z1_3_by_z10 = t10*v1_2_on_boundary_by_z10 + t6*z1_2_on_boundary_by_z10 + t7*z2_2_on_boundary_by_z10
    carried_z1_3_by_z20 = t10*v1_2_on_boundary_by_z20 + t6*z1_2_on_boundary_by_z20 + t7*z2_2_on_boundary_by_z20
    carried_z2_3_by_z10 = t12*z1_2_on_boundary_by_z10 + t13*z2_2_on_boundary_by_z10 + t14*v1_2_on_boundary_by_z10
    carried_z2_3_by_z20 = t12*z1_2_on_boundary_by_z20 + t13*z2_2_on_boundary_by_z20 + t14*v1_2_on_boundary_by_z20
    carried_v1_3_by_z10 = t18*z1_2_on_boundary_by_z10 + t19*z2_2_on_boundary_by_z10 + t6*v1_2_on_boundary_by_z10
    carried_v1_3_by_z20 = t18*z1_2_on_boundary_by_z20 + t19*z2_2_on_boundary_by_z20 + t6*v1_2_on_boundary_by_z20
    carried_v2_3_by_z10 = t12*v1_2_on_boundary_by_z10 + t20*z1_2_on_boundary_by_z10 + t23*z2_2_on_boundary_by_z10
    carried_v2_3_by_z20 = t12*v1_2_on_boundary_by_z20 + t20*z1_2_on_boundary_by_z20 + t23*z2_2_on_boundary_by_z20
    # rate of the exit boundary after tau1
    t32 = chi*z2_3
    rate_3 = t32 - z1_3
    # derivatives of the time to the boundary after tau1
    t33 = 1/rate_3
    delay_tau1_by_z10 = -carried_v1_3_by_z10*t33
    delay_tau1_by_z20 = -carried_v1_3_by_z20*t33
    # perturbation on the boundary after tau1
    z1_3_on_boundary_by_z10 = carried_z1_3_by_z10 + delay_tau1_by_z10*v1_3
    z1_3_on_boundary_by_z20 = carried_z1_3_by_z20 + delay_tau1_by_z20*v1_3
    z2_3_on_boundary_by_z10 = carried_z2_3_by_z10 + delay_tau1_by_z10*v2_3
    z2_3_on_boundary_by_z20 = carried_z2_3_by_z20 + delay_tau1_by_z20*v2_3
    t34 = chi*eta
    before_v2_3 = -eta*t32 + t34*z1_3
    v2_3_on_boundary_by_z10 = before_v2_3*delay_tau1_by_z10 + carried_v2_3_by_z10
    v2_3_on_boundary_by_z20 = before_v2_3*delay_tau1_by_z20 + carried_v2_3_by_z20
    # Phi along tau2
    carried_z2_4_by_z10 = cos_omega3_tau2*z2_3_on_boundary_by_z10 + t25*z1_3_on_boundary_by_z10 + t26*v2_3_on_boundary_by_z10
    carried_z2_4_by_z20 = cos_omega3_tau2*z2_3_on_boundary_by_z20 + t25*z1_3_on_boundary_by_z20 + t26*v2_3_on_boundary_by_z20
    carried_v2_4_by_z10 = cos_omega3_tau2*v2_3_on_boundary_by_z10 + t27*z1_3_on_boundary_by_z10 - t27*z2_3_on_boundary_by_z10
    carried_v2_4_by_z20 = cos_omega3_tau2*v2_3_on_boundary_by_z20 + t27*z1_3_on_boundary_by_z20 - t27*z2_3_on_boundary_by_z20
    # rate of the exit boundary after tau2
    rate_4 = t34*z1_4 - t34*z2_4
    # derivatives of the time to the boundary after tau2
    t35 = 1/rate_4
    delay_tau2_by_z10 = -carried_v2_4_by_z10*t35
    delay_tau2_by_z20 = -carried_v2_4_by_z20*t35
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
    behind_v2_2 = -eta*t31 + t34*z1_2
    # saltations
    saltation_1_20 = behind_v1_1/rate_1
    saltation_1_21 = -chi*saltation_1_20
    t36 = 0
    t37 = 1/rate_2
    t38 = chi*t37
    t39 = t36*t38
    t40 = behind_v2_2*t38
    t41 = 1/rate_3
    t42 = t41*(V - v1_3)
    t43 = 0
    t44 = (V - v2_4)/rate_4
    saltations = [[1, 0, 0, 0], [0, 1, 0, 0], [saltation_1_20, saltation_1_21, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [-t39, t39, 1, 0], [-t40, t40, 0, 1], [1, 0, t42, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, t43, 1], [1, 0, 0, 0], [0, 1, 0, t44], [0, 0, 1, 0], [0, 0, 0, 0]]
    if outputs == 2:
        return poincare_jacobian, saltations
    # Phi of phase 2
    phi_2_00 = cos_tau + saltation_1_20*sin_tau
    phi_2_01 = chi + saltation_1_21*sin_tau - t0
    phi_2_20 = cos_tau*saltation_1_20 - sin_tau
    phi_2_21 = cos_tau*saltation_1_21 + t2
    # saltation of phase 2
    saltation_2_20 = -phi_2_00*t39 + phi_2_20
    saltation_2_21 = -phi_2_01*t39 + phi_2_21 + t39
    t45 = t36*t37
    saltation_2_22 = cos_tau - t2*t45
    saltation_2_23 = -phi_2_03*t39 + phi_2_23 + t1*t45
    saltation_2_30 = -phi_2_00*t40
    saltation_2_31 = -phi_2_01*t40 + t40
    t46 = behind_v2_2*t37
    saltation_2_32 = -t2*t46
    saltation_2_33 = -phi_2_03*t40 + t1*t46 + 1
    # Phi of phase 3
    phi_3_00 = phi_2_00*t6 + saltation_2_20*t10 + saltation_2_30*t11
    phi_3_01 = phi_2_01*t6 + saltation_2_21*t10 + saltation_2_31*t11 + t7
    phi_3_02 = saltation_2_22*t10 + saltation_2_32*t11 + sin_tau*t6
    phi_3_03 = phi_2_03*t6 + saltation_2_23*t10 + saltation_2_33*t11 + t7*tau
    phi_3_10 = phi_2_00*t12 + saltation_2_20*t14 + saltation_2_30*t15
    phi_3_11 = phi_2_01*t12 + saltation_2_21*t14 + saltation_2_31*t15 + t13
    phi_3_12 = saltation_2_22*t14 + saltation_2_32*t15 + sin_tau*t12
    phi_3_13 = phi_2_03*t12 + saltation_2_23*t14 + saltation_2_33*t15 + t13*tau
    phi_3_20 = phi_2_00*t18 + saltation_2_20*t6 + saltation_2_30*t7
    phi_3_21 = phi_2_01*t18 + saltation_2_21*t6 + saltation_2_31*t7 + t19
    phi_3_22 = saltation_2_22*t6 + saltation_2_32*t7 + sin_tau*t18
    phi_3_23 = phi_2_03*t18 + saltation_2_23*t6 + saltation_2_33*t7 + t19*tau
    phi_3_30 = phi_2_00*t20 + saltation_2_20*t12 + saltation_2_30*t13
    phi_3_31 = phi_2_01*t20 + saltation_2_21*t12 + saltation_2_31*t13 - t21 - t22
    phi_3_32 = saltation_2_22*t12 + saltation_2_32*t13 + sin_tau*t20
    phi_3_33 = phi_2_03*t20 + saltation_2_23*t12 + saltation_2_33*t13 + t23*tau
    # saltation of phase 3
    saltation_3_00 = phi_3_00 + phi_3_20*t42
    saltation_3_01 = phi_3_01 + phi_3_21*t42
    saltation_3_02 = phi_3_02 + phi_3_22*t42
    saltation_3_03 = phi_3_03 + phi_3_23*t42
    saltation_3_30 = phi_3_20*t43 + phi_3_30
    saltation_3_31 = phi_3_21*t43 + phi_3_31
    saltation_3_32 = phi_3_22*t43 + phi_3_32
    saltation_3_33 = phi_3_23*t43 + phi_3_33
    # Phi of phase 4
    phi_4_10 = cos_omega3_tau2*phi_3_10 + saltation_3_00*t25 + saltation_3_30*t26
    phi_4_11 = cos_omega3_tau2*phi_3_11 + saltation_3_01*t25 + saltation_3_31*t26
    phi_4_12 = cos_omega3_tau2*phi_3_12 + saltation_3_02*t25 + saltation_3_32*t26
    phi_4_13 = cos_omega3_tau2*phi_3_13 + saltation_3_03*t25 + saltation_3_33*t26
    phi_4_30 = cos_omega3_tau2*saltation_3_30 - phi_3_10*t27 + saltation_3_00*t27
    phi_4_31 = cos_omega3_tau2*saltation_3_31 - phi_3_11*t27 + saltation_3_01*t27
    phi_4_32 = cos_omega3_tau2*saltation_3_32 - phi_3_12*t27 + saltation_3_02*t27
    phi_4_33 = cos_omega3_tau2*saltation_3_33 - phi_3_13*t27 + saltation_3_03*t27
    # saltation of phase 4
    saltation_4_10 = phi_4_10 + phi_4_30*t44
    saltation_4_11 = phi_4_11 + phi_4_31*t44
    saltation_4_12 = phi_4_12 + phi_4_32*t44
    saltation_4_13 = phi_4_13 + phi_4_33*t44
    monodromy = [[saltation_3_00, saltation_3_01, saltation_3_02, saltation_3_03], [saltation_4_10, saltation_4_11, saltation_4_12, saltation_4_13], [0, 0, 0, 0], [0, 0, 0, 0]]
    return poincare_jacobian, saltations, monodromy


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
    [z1, z2, v1, v2] = state
    # state_after
    t0 = lib.sin(time)
    t1 = chi*t0
    t2 = lib.cos(time)
    t3 = -chi*t2 + chi
    return [t0*v1 + t2*z1 + t3*z2 + v2*(chi*time - t1), time*v2 + z2, -t0*z1 + t1*z2 + t2*v1 + t3*v2, v2]


def solution_ii_flow_slip_slip(parameters, spectrum, time, state, *, lib):
    """State after a time in slip-slip.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes time.
    Takes state (4): z1, z2, v1, v2.
    Gives state_after (4).
    Operations: 77. Intermediate terms: 15.
    """
    [_, omega1, omega2, p1, p2, p3, _] = spectrum
    [z1, z2, v1, v2] = state
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
    return [t10*z1 + t9*z2 + v1*(p1*t2 + t5*t6) + v2*(p2*t2 - p2*t5), t11*z2 + t12*z1 + v1*(p3*t2 - p3*t5) + v2*(p1*t5 + t2*t6), t10*v1 + t9*v2 + z1*(-p1*t14 - t13*t6) + z2*(p2*t13 - p2*t14), t11*v2 + t12*v1 + z1*(p3*t13 - p3*t14) + z2*(-p1*t13 - t14*t6)]


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
    [z1, z2, v1, v2] = state
    # state_after
    t0 = omega3*time
    t1 = lib.sin(t0)
    t2 = t1/omega3
    t3 = lib.cos(t0)
    t4 = 1 - t3
    t5 = omega3*t1
    return [time*v1 + z1, t2*v2 + t3*z2 + t4*z1 + v1*(-t2 + time), v1, t3*v2 + t4*v1 + t5*z1 - t5*z2]


def solution_ii_reduced(parameters, spectrum, reduced, *, lib, outputs=3):
    """All unknowns from the reduced ones; the equations for these and their derivatives.

    Takes parameters (4): chi, eta, V, e2.
    Takes spectrum (7): gap1, omega1, omega2, p1, p2, p3, omega3.
    Takes reduced (3): tau, tau1, e1.
    Gives unknowns (6).
    Gives reduced_residual (3).
    Gives reduced_jacobian (3, 3).
    Operations: 295. Intermediate terms: 100.
    """
    [chi, eta, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [tau, tau1, e1] = reduced
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # z2_1: linear in second-breaks-forward
    t0 = V*tau
    t1 = 1/(chi - 1)
    t2 = cos_tau*t1
    z2_1 = V*sin_tau - e1*t2 - t0 - e2*t1/chi
    # slip-stick for tau
    t3 = chi*z2_1
    t4 = e1 + t3
    t5 = -chi*cos_tau + chi
    z1_2 = V*sin_tau + V*(-chi*sin_tau + chi*tau) + cos_tau*t4 + t5*z2_1
    z2_2 = t0 + z2_1
    v1_2 = V*cos_tau + V*t5 + sin_tau*t3 - sin_tau*t4
    # functions of tau1 in slip-slip
    t6 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t6)
    sin_omega1_tau1 = lib.sin(t6)
    t7 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t7)
    sin_omega2_tau1 = lib.sin(t7)
    # slip-slip for tau1
    t8 = 1 - p1
    t9 = cos_omega1_tau1*p1 + cos_omega2_tau1*t8
    t10 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    t11 = sin_omega1_tau1/omega1
    t12 = sin_omega2_tau1/omega2
    t13 = p1*t11 + t12*t8
    z1_3 = V*(p2*t11 - p2*t12) + t10*z2_2 + t13*v1_2 + t9*z1_2
    t14 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t15 = cos_omega1_tau1*t8 + cos_omega2_tau1*p1
    t16 = p3*t11 - p3*t12
    z2_3 = V*(p1*t12 + t11*t8) + t14*z1_2 + t15*z2_2 + t16*v1_2
    t17 = omega1*sin_omega1_tau1
    t18 = omega2*sin_omega2_tau1
    t19 = -p3*t17 + p3*t18
    t20 = -p1*t18 - t17*t8
    v2_3 = V*t15 + t14*v1_2 + t19*z1_2 + t20*z2_2
    # first return of tau2
    cosine_part_tau2 = -V + v2_3
    sine_part_tau2 = omega3*z1_3 - omega3*z2_3
    # first return of tau2
    amplitude_tau2 = lib.sqrt(cosine_part_tau2**2 + sine_part_tau2**2)
    # first return of tau2
    t21 = 1/amplitude_tau2
    cos_tau2_return = sine_part_tau2*t21
    sin_tau2_return = -cosine_part_tau2*t21
    # tau2: first return
    t22 = 1/omega3
    tau2 = t22*lib.angle(sin_tau2_return, cos_tau2_return)
    # unknowns
    z1_5 = V*tau2 + sine_part_tau2*t22 + z2_3
    z2_5 = -amplitude_tau2*t22 + z1_5
    unknowns = [z1_5, z2_5, tau, tau1, tau2, e1]
    if outputs == 1:
        return unknowns
    # slip-slip for tau1
    t23 = -p1*t17 - t18*t8
    t24 = -p2*t17 + p2*t18
    v1_3 = V*t10 + t23*z1_2 + t24*z2_2 + t9*v1_2
    reduced_residual = [-V + v1_3, -chi*z2_5 - e1 + z1_5, -z2_1 + z2_5]
    if outputs == 2:
        return unknowns, reduced_residual
    # d/dtau of: functions of tau in slip-stick
    cos_tau_by_tau = -sin_tau
    # d/dtau of: z2_1: linear in second-breaks-forward
    t25 = cos_tau_by_tau*e1
    z2_1_by_tau = V*cos_tau - V - t1*t25
    # d/de1 of: z2_1: linear in second-breaks-forward
    z2_1_by_e1 = -t2
    # d/dtau of: slip-stick for tau
    t26 = V*chi
    t27 = V - t26
    z1_2_by_tau = chi*z2_1_by_tau + cos_tau*t27 + t25 + t26
    z2_2_by_tau = V + z2_1_by_tau
    v1_2_by_tau = -cos_tau*e1 + cos_tau_by_tau*t27
    # d/de1 of: slip-stick for tau
    z1_2_by_e1 = chi*z2_1_by_e1 + cos_tau
    v1_2_by_e1 = -sin_tau
    # d/dtau of: slip-slip for tau1
    z1_3_by_tau = t10*z2_2_by_tau + t13*v1_2_by_tau + t9*z1_2_by_tau
    z2_3_by_tau = t14*z1_2_by_tau + t15*z2_2_by_tau + t16*v1_2_by_tau
    v1_3_by_tau = t23*z1_2_by_tau + t24*z2_2_by_tau + t9*v1_2_by_tau
    v2_3_by_tau = t14*v1_2_by_tau + t19*z1_2_by_tau + t20*z2_2_by_tau
    # d/dtau1 of: slip-slip for tau1
    t28 = chi*z2_3
    v1_3_by_tau1 = t28 - z1_3
    v2_3_by_tau1 = chi*eta*z1_3 - eta*t28
    # d/de1 of: slip-slip for tau1
    z1_3_by_e1 = t10*z2_1_by_e1 + t13*v1_2_by_e1 + t9*z1_2_by_e1
    z2_3_by_e1 = t14*z1_2_by_e1 + t15*z2_1_by_e1 + t16*v1_2_by_e1
    v1_3_by_e1 = t23*z1_2_by_e1 + t24*z2_1_by_e1 + t9*v1_2_by_e1
    v2_3_by_e1 = t14*v1_2_by_e1 + t19*z1_2_by_e1 + t20*z2_1_by_e1
    # d/dtau of: first return of tau2
    sine_part_tau2_by_tau = omega3*z1_3_by_tau - omega3*z2_3_by_tau
    # d/dtau1 of: first return of tau2
    sine_part_tau2_by_tau1 = omega3*v1_3 - omega3*v2_3
    # d/de1 of: first return of tau2
    sine_part_tau2_by_e1 = omega3*z1_3_by_e1 - omega3*z2_3_by_e1
    # d/dtau of: first return of tau2
    t29 = 2*cosine_part_tau2
    t30 = 2*sine_part_tau2
    t31 = t21/2
    amplitude_tau2_by_tau = t31*(sine_part_tau2_by_tau*t30 + t29*v2_3_by_tau)
    # d/dtau1 of: first return of tau2
    amplitude_tau2_by_tau1 = t31*(sine_part_tau2_by_tau1*t30 + t29*v2_3_by_tau1)
    # d/de1 of: first return of tau2
    amplitude_tau2_by_e1 = t31*(sine_part_tau2_by_e1*t30 + t29*v2_3_by_e1)
    # d/dtau of: first return of tau2
    t32 = 1/amplitude_tau2**2
    t33 = amplitude_tau2_by_tau*t32
    cos_tau2_return_by_tau = -sine_part_tau2*t33 + sine_part_tau2_by_tau*t21
    sin_tau2_return_by_tau = cosine_part_tau2*t33 - t21*v2_3_by_tau
    # d/dtau1 of: first return of tau2
    t34 = amplitude_tau2_by_tau1*t32
    cos_tau2_return_by_tau1 = -sine_part_tau2*t34 + sine_part_tau2_by_tau1*t21
    sin_tau2_return_by_tau1 = cosine_part_tau2*t34 - t21*v2_3_by_tau1
    # d/de1 of: first return of tau2
    t35 = amplitude_tau2_by_e1*t32
    cos_tau2_return_by_e1 = -sine_part_tau2*t35 + sine_part_tau2_by_e1*t21
    sin_tau2_return_by_e1 = cosine_part_tau2*t35 - t21*v2_3_by_e1
    # d/dtau of: tau2: first return
    t36 = t22/(cos_tau2_return**2 + sin_tau2_return**2)
    t37 = cos_tau2_return*t36
    t38 = sin_tau2_return*t36
    tau2_by_tau = -cos_tau2_return_by_tau*t38 + sin_tau2_return_by_tau*t37
    # d/dtau1 of: tau2: first return
    tau2_by_tau1 = -cos_tau2_return_by_tau1*t38 + sin_tau2_return_by_tau1*t37
    # d/de1 of: tau2: first return
    tau2_by_e1 = -cos_tau2_return_by_e1*t38 + sin_tau2_return_by_e1*t37
    # d/dtau of: stick-stick for no time
    z1_5_by_tau = V*tau2_by_tau + sine_part_tau2_by_tau*t22 + z2_3_by_tau
    z2_5_by_tau = -amplitude_tau2_by_tau*t22 + z1_5_by_tau
    # d/dtau1 of: stick-stick for no time
    z1_5_by_tau1 = V*tau2_by_tau1 + sine_part_tau2_by_tau1*t22 + v2_3
    z2_5_by_tau1 = -amplitude_tau2_by_tau1*t22 + z1_5_by_tau1
    # d/de1 of: stick-stick for no time
    z1_5_by_e1 = V*tau2_by_e1 + sine_part_tau2_by_e1*t22 + z2_3_by_e1
    z2_5_by_e1 = -amplitude_tau2_by_e1*t22 + z1_5_by_e1
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
    Operations: 243. Intermediate terms: 76.
    """
    [chi, _, V, e2] = parameters
    [_, omega1, omega2, p1, p2, p3, omega3] = spectrum
    [_, _, tau, tau1, tau2, e1] = unknowns
    # functions of tau in slip-stick
    cos_tau = lib.cos(tau)
    sin_tau = lib.sin(tau)
    # slip-stick after tau, by the start
    z1_2_by_z20 = -chi*cos_tau + chi
    v1_2_by_z20 = chi*sin_tau
    z1_2_by_v20 = chi*tau - v1_2_by_z20
    v1_2_by_z10 = -sin_tau
    # functions of tau1 in slip-slip
    t0 = omega1*tau1
    cos_omega1_tau1 = lib.cos(t0)
    sin_omega1_tau1 = lib.sin(t0)
    t1 = omega2*tau1
    cos_omega2_tau1 = lib.cos(t1)
    sin_omega2_tau1 = lib.sin(t1)
    # slip-slip after tau1, by the start
    t2 = 1 - p1
    t3 = cos_omega1_tau1*p1 + cos_omega2_tau1*t2
    t4 = cos_tau*t3
    t5 = sin_omega1_tau1/omega1
    t6 = sin_omega2_tau1/omega2
    t7 = p1*t5 + t2*t6
    z1_3_by_z10 = t4 + t7*v1_2_by_z10
    t8 = cos_omega1_tau1*p2 - cos_omega2_tau1*p2
    z1_3_by_z20 = t3*z1_2_by_z20 + t7*v1_2_by_z20 + t8
    z1_3_by_v10 = cos_tau*t7 + sin_tau*t3
    z1_3_by_v20 = p2*t5 - p2*t6 + t3*z1_2_by_v20 + t7*z1_2_by_z20 + t8*tau
    t9 = cos_omega1_tau1*p3 - cos_omega2_tau1*p3
    t10 = cos_tau*t9
    t11 = p3*t5 - p3*t6
    z2_3_by_z10 = t10 + t11*v1_2_by_z10
    t12 = cos_omega1_tau1*t2 + cos_omega2_tau1*p1
    z2_3_by_z20 = t11*v1_2_by_z20 + t12 + t9*z1_2_by_z20
    z2_3_by_v10 = cos_tau*t11 + sin_tau*t9
    z2_3_by_v20 = p1*t6 + t11*z1_2_by_z20 + t12*tau + t2*t5 + t9*z1_2_by_v20
    t13 = omega1*sin_omega1_tau1
    t14 = omega2*sin_omega2_tau1
    t15 = -p1*t13 - t14*t2
    v1_3_by_z10 = cos_tau*t15 + t3*v1_2_by_z10
    t16 = -p2*t13 + p2*t14
    v1_3_by_z20 = t15*z1_2_by_z20 + t16 + t3*v1_2_by_z20
    v1_3_by_v10 = sin_tau*t15 + t4
    v1_3_by_v20 = t15*z1_2_by_v20 + t16*tau + t3*z1_2_by_z20 + t8
    t17 = -p3*t13 + p3*t14
    v2_3_by_z10 = cos_tau*t17 + t9*v1_2_by_z10
    t18 = p1*t14 + t13*t2
    v2_3_by_z20 = t17*z1_2_by_z20 - t18 + t9*v1_2_by_z20
    v2_3_by_v10 = sin_tau*t17 + t10
    v2_3_by_v20 = t12 + t17*z1_2_by_v20 - t18*tau + t9*z1_2_by_z20
    # functions of tau2 in stick-slip
    t19 = omega3*tau2
    cos_omega3_tau2 = lib.cos(t19)
    sin_omega3_tau2 = lib.sin(t19)
    # stick-slip after tau2, by the start
    z1_4_by_z10 = tau2*v1_3_by_z10 + z1_3_by_z10
    z1_4_by_z20 = tau2*v1_3_by_z20 + z1_3_by_z20
    z1_4_by_v10 = tau2*v1_3_by_v10 + z1_3_by_v10
    z1_4_by_v20 = tau2*v1_3_by_v20 + z1_3_by_v20
    t20 = 1 - cos_omega3_tau2
    t21 = sin_omega3_tau2/omega3
    t22 = -t21 + tau2
    z2_4_by_z10 = cos_omega3_tau2*z2_3_by_z10 + t20*z1_3_by_z10 + t21*v2_3_by_z10 + t22*v1_3_by_z10
    z2_4_by_z20 = cos_omega3_tau2*z2_3_by_z20 + t20*z1_3_by_z20 + t21*v2_3_by_z20 + t22*v1_3_by_z20
    z2_4_by_v10 = cos_omega3_tau2*z2_3_by_v10 + t20*z1_3_by_v10 + t21*v2_3_by_v10 + t22*v1_3_by_v10
    z2_4_by_v20 = cos_omega3_tau2*z2_3_by_v20 + t20*z1_3_by_v20 + t21*v2_3_by_v20 + t22*v1_3_by_v20
    t23 = omega3*sin_omega3_tau2
    v2_4_by_z10 = cos_omega3_tau2*v2_3_by_z10 + t20*v1_3_by_z10 + t23*z1_3_by_z10 - t23*z2_3_by_z10
    v2_4_by_z20 = cos_omega3_tau2*v2_3_by_z20 + t20*v1_3_by_z20 + t23*z1_3_by_z20 - t23*z2_3_by_z20
    v2_4_by_v10 = cos_omega3_tau2*v2_3_by_v10 + t20*v1_3_by_v10 + t23*z1_3_by_v10 - t23*z2_3_by_v10
    v2_4_by_v20 = cos_omega3_tau2*v2_3_by_v20 + t20*v1_3_by_v20 + t23*z1_3_by_v20 - t23*z2_3_by_v20
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
    t24 = 1/determinant
    z1_0 = numerator1*t24
    z2_0 = numerator2*t24
    linear_start = [z1_0, z2_0]
    if outputs == 2:
        return period_map, linear_start
    # slip-stick for tau, until second-breaks-forward
    z1_2 = V*sin_tau + V*z1_2_by_v20 + cos_tau*z1_0 + z1_2_by_z20*z2_0
    z2_2 = V*tau + z2_0
    compatibility = [V*v1_3_by_v10 + V*v1_3_by_v20 - V + v1_3_by_z10*z1_0 + v1_3_by_z20*z2_0, V*v2_4_by_v10 + V*v2_4_by_v20 - V + v2_4_by_z10*z1_0 + v2_4_by_z20*z2_0, -chi*z2_0 - e1 + z1_0, -chi*z1_2 + chi*z2_2 - e2]
    return period_map, linear_start, compatibility
