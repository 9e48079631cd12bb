"""The page of results/paper says what the runs gave: its functions on a tiny result.

Usage: reproduce_test.py SCRIPTS_FOLDER RESULT
"""
import csv
import importlib.machinery
import importlib.util
import pathlib
import sys

import h5py
import numpy as np

scripts, path = pathlib.Path(sys.argv[1]), sys.argv[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(scripts))
loader = importlib.machinery.SourceFileLoader("reproduce", str(scripts / "reproduce"))
reproduce = importlib.util.module_from_spec(importlib.util.spec_from_loader("reproduce", loader))
loader.exec_module(reproduce)
import paper_page  # noqa: E402  beside the script
import paper_runs  # noqa: E402

# Numbers come from the result.
numbers = paper_runs.take_numbers({"sphere": paper_runs.Result(path)})
by_name = {name: value for name, value, _ in numbers}
with h5py.File(path) as file:
    run = file["pipelines/fukuhara"]
    assert by_name["sphere/fukuhara/depth"] == 1000 * run["penetration_depth"][:].max()
    assert by_name["sphere/fukuhara/inverted"] == run["inverted_triangles"][:].max()
    resultant = np.linalg.norm(run["clamp_force"][0, :, 0], axis=1)
    assert by_name["sphere/fukuhara/resultant_largest"] == resultant.max() > 0
    assert by_name["sphere/default/depth"] == 1000 * file["pipelines/default/penetration_depth"][:].max() > 1

# A check finds what has changed, is missing or is no number.
stored = {name: (value, unit) for name, value, unit in numbers}
assert not list(reproduce.differences(numbers, stored))
name, (value, unit) = "sphere/default/depth", stored["sphere/default/depth"]
for other in ((value * (1 + 1e-6), unit), (value, "m"), (float("nan"), unit)):
    found = list(reproduce.differences(numbers, {**stored, name: other}))
    assert len(found) == 1 and found[0].startswith(name), found
assert len(list(reproduce.differences(numbers, {key: stored[key] for key in stored if key != name}))) == 1

# Verdicts follow the numbers: each statement that was found true is found false where its numbers say so.
with open(scripts.parent / "results/paper/numbers.csv", newline="") as file:
    paper = {row["name"]: float(row["value"]) for row in csv.DictReader(file)}
changed = {"press/triangles": 127, "spatula_0.02_1/default_tuned/depth": 0.9, "fast/default_tuned/depth": 5,
           "press/raycast/inverted": 0, "press/paper/depth": 0.6, "convex/unmutual_nodes": 0, "coarse/paper/inverted": 79,
           "vessel/fukuhara/passed": 1, "law/paper/error": 1e-3}
before = list(paper_page.statement_rows(paper))
for key, value in changed.items():
    assert key in paper, key
    after = list(paper_page.statement_rows({**paper, key: value}))
    turned = [new for old, new in zip(before, after)
              if paper_page.REFUTED not in old and paper_page.REFUTED in new]
    assert turned, f"{key} = {value} changes no verdict"
print("the page follows the numbers")
