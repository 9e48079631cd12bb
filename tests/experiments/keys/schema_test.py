"""The schemas of `fissure schema` against the files of configs/ and what must be refused: schema_test.py FISSURE. Skips (77) where
there is no jsonschema."""
import copy
import json
import pathlib
import re
import subprocess
import sys

import yaml

try:
    import jsonschema
except ImportError:
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = sys.argv[1]


def validator(kind):
    text = subprocess.run([PROGRAM, "schema", kind], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


class Loader(yaml.SafeLoader):
    """Reads numbers as fissure does: PyYAML takes 1e4 for a text."""


Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers if tag != "tag:yaml.org,2002:float"]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
}
Loader.add_implicit_resolver("tag:yaml.org,2002:float",
                             re.compile(r"^[-+]?(\d+\.\d*|\.\d+|\d+)([eE][-+]?\d+)?$"), list("-+.0123456789"))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))


def load(path):
    return yaml.load(path.read_text(), Loader)


def put(data, path, value):
    """A copy of `data` with another value at a path of keys and indices; None removes the key."""
    changed = copy.deepcopy(data)
    place = changed
    for part in path[:-1]:
        place = place[part]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return changed


failures = []


def expect(good, what):
    if not good:
        failures.append(what)


scenario, sweep, tolerances = validator("scenario"), validator("sweep"), validator("tolerances")
stability, tradeoff = validator("stability"), validator("tradeoff")
everything = sorted((ROOT / "configs").rglob("*.yaml"))
maps = [path for path in everything if "maps" in load(path)]
costs = sorted((ROOT / "configs/studies").glob("tradeoff*.yaml"))
sweeps = [path for path in everything if "axes" in load(path) and path not in costs]
scenarios = [path for path in everything
             if path not in sweeps + maps + costs and path.parent.name != "base"]      # a base need not be whole
for files, schema, least in ((scenarios, scenario, 55), (sweeps, sweep, 6), (maps, stability, 2), (costs, tradeoff, 4),
                             (sorted((ROOT / "results").rglob("tolerances.yaml")), tolerances, 1)):
    expect(len(files) >= least, f"only {len(files)} files where {least} were expected")
    for path in files:
        error = next(schema.iter_errors(load(path)), None)
        expect(error is None, f"{path}: {error and error.message}")

# What the program refuses one value at a time is refused here too.
press = load(ROOT / "configs/spatula_press.yaml")
plan = load(ROOT / "configs/sweeps/speed_thickness.yaml")
trade = load(ROOT / "configs/studies/tradeoff_quick.yaml")
rules = load(ROOT / "results/reference/tolerances.yaml")
refused = [
    (scenario, press, ["bodies", 0, "mas_kg"], 0.1, "a misspelt key"),
    (scenario, press, ["pipelines", 3, "pair_nodes"], True, "a key that was removed"),
    (scenario, press, ["bodies", 0, "solver", "damping"], 1.5, "a value above its range"),
    (scenario, press, ["time", "step_s"], 0, "the open end of a range"),
    (scenario, press, ["bodies", 0, "bending_distance"], 1, "a value between two ranges"),
    (scenario, press, ["bodies", 0, "position_m"], [0, 1], "a short vector"),
    (scenario, press, ["bodies", 0, "shape", "type"], "shpere", "an unknown type"),
    (scenario, press, ["bodies", 0, "shape", "size_m"], [1, 1, 1], "a key of another type"),
    (scenario, press, ["bodies", 0, "shape", "radius_m"], None, "a missing key"),
    (scenario, press, ["pipelines", 0, "pipeline"], "fukuhra", "an unknown pipeline"),
    (scenario, press, ["pipelines"], [], "no run"),
    (scenario, press, ["name"], "a b", "a bad name"),
    (scenario, press, ["bodies", 0, "bending_distance"], 2.5, "a fraction for a count"),
    (scenario, press, ["bodies", 0, "mass_kg"], "heavy", "a text for a number"),
    (scenario, {"base": "spatula_press.yaml", "name": "b"}, ["tme"], {}, "a misspelt key over a base"),
    (scenario, {"base": "spatula_press.yaml", "name": "b"}, ["time"], {"step_s": -1}, "a bad value over a base"),
    (sweep, plan, ["axes", 0, "vales"], [1], "a misspelt key of an axis"),
    (sweep, plan, ["axes", 0, "zip"], [{"path": "a", "values": [1]}], "zip beside an axis"),
    (sweep, plan, ["repeats"], 0, "no repeat"),
    (sweep, plan, ["design"], "girds", "an unknown design"),
    (tradeoff, trade, ["reference", "pipelin"], "swept", "a misspelt key of a reference"),
    (tradeoff, trade, ["errors", 0, "quantity"], "dept", "an unknown quantity"),
    (tolerances, rules, ["tolerances", 0, "relative"], -1, "a negative tolerance"),
    (tolerances, rules, ["format"], 2, "another format"),
]
for schema, data, path, value, what in refused:
    expect(schema.is_valid(data), f"{what}: the file itself is refused")
    expect(not schema.is_valid(put(data, path, value)), f"{what} passes")
good = [
    (scenario, press, ["bodies", 0, "bending_distance"], 0, "no bending links"),
    (scenario, {"base": "spatula_press.yaml", "name": "b"}, ["bodies"], [{"name": "sphere", "mass_kg": 1}], "an item over a base"),
    (sweep, plan, ["axes", 0], {"zip": [{"path": "a", "values": [1, "b", [1]]}]}, "zip"),
]
for schema, data, path, value, what in good:
    expect(schema.is_valid(put(data, path, value)), f"{what} is refused")

# Editors show what a key means.
elastic = scenario.schema["else"]["properties"]["bodies"]["items"]["properties"]["elastic"]["properties"]
expect(elastic["youngs_modulus_Pa"]["description"].startswith("Young's modulus at small strain.\nUnit: Pa\nDefault: 10000"),
       "youngs_modulus_Pa has no description")
expect(elastic["youngs_modulus_Pa"]["default"] == 10000, "youngs_modulus_Pa has no default")

print("\n".join(failures))
sys.exit(1 if failures else 0)
