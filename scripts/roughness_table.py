#!/usr/bin/env python3
"""How rough the force of swept contact is beside that of nodes: laws and reaction over the tool's speed; writes results/roughness/README.md.

    /usr/bin/python3 scripts/roughness_table.py [-j N]
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import tempfile

from references import ROOT, fissure
from swept_table import SPEEDS_M_S, natural_speed_m_s, speed_words

SCENES = ["spatula_friction", "plate_press", "convex_spatula", "organ_press", "clamp_sphere", "clamp_vessel", "clamp_lift",
          "clamp_scissors", "lift_two_plates", "forceps_press", "fissure_open", "fissure_retract", "spatula_press"]
QUANTITIES = {"law": ("force_roughness_hc", "force_roughness"), "law, jaws": ("tool_force_roughness_hc", "tool_force_roughness"),
              "reaction": ("reaction_roughness",), "reaction, jaws": ("tool_reaction_roughness",)}
HELD = {"spatula_friction": "sphere", "plate_press": "sphere", "organ_press": "gallbladder", "spatula_press": "sphere"}  # scenes, and their bodies
FOLDER = ROOT / "results/roughness"
HEAD = """# How rough the force is: swept contact beside nodes

    /usr/bin/python3 scripts/roughness_table.py

Roughness of the first force law and of the constraint reaction ([RMS of the second difference over that of the value](../../src/judgement/measure/METHOD.md#5-roughness)), at 1 ms, `swept`
over `fukuhara`; the speed is that of the fastest point of a tool. Jaws: of several tools each by itself, all values together; between two
jaws the sum nearly cancels, and its own roughness compares little with little. **Bold**: swept is rougher.

"""
SAME = """## On the same ground

`fukuhara` with `ground_contact: half_space` stands on what `swept` stands on. {smoother} of {cells} cells are as smooth as nodes or smoother,
{near} are rougher by at most a tenth; up to 2 m/s {slow} of {slow_cells} are rougher by more.

"""
BULLETS = """
## fukuhara on Bullet's ground

As `fukuhara` runs where nothing is said: Bullet's ground gives way by millimetres under load, and is softer than any contact on it.
{smoother} of {cells} cells are as smooth or smoother, {near} are rougher by at most a tenth; up to 2 m/s {slow} of {slow_cells} are rougher by more.

"""
BELOW = """
## Below the floor

Deepest tissue below the floor in these runs, mm: `swept` / `fukuhara` on the same ground / `fukuhara` on Bullet's.

"""
FLOOR = """
## Without the floor

The same with the body held at its vertices below 3 mm and no floor (`ground.height_m: -1`): what is left is the contact's own.

"""
CAUSES = """
## What is left, and its causes

Each by the same runs with the cause switched off, `swept` over `fukuhara` on the same ground, where `swept` is rougher as it is:

* fissure_retract, each blade: slit and blades overlap by 0.25 mm a side, so that a blade's narrow face presses the rim down before this slips
  to the side, all at once. Nodes stand on the large faces alone, and the rim passes them.
* clamp_lift: of the frictionless clamp, whose sphere slips out between its jaws.
* 10 m/s: the strike, in steps of 10 mm; forceps_press at 0.5 m/s likewise.
* spatula_press is a free ball under a blade without friction, and slides out from under its rim, where normals point aside. With normals of the
  blade's face there, or with the ball held at one vertex, most of it is gone. Normals of the face are no remedy elsewhere: a wedge that parts
  tissue then pushes with its narrow edge.
* Not the solver: with 300 sweeps in place of 30 the numbers of each jaw change by at most a tenth, either way, but for the law of fissure_retract
  at 0.1 m/s (0.00336 to 0.00194). A warm start or a tolerance would end nearer to the same solution.
* No cause was found for lift_two_plates at 0.02 (the law's sum, which nearly cancels) and 0.5 m/s, and for the sum of clamp_scissors at 2 m/s:
  steps of 0.25 ms leave each jaw's reaction at 0.000191 / 0.000115 and the sum at 0.112 / 0.0562.

| scene | switched off by | quantity | m/s | as it is | switched off |
|---|---|---|--:|--:|--:|
"""
SWITCHES = [  # scene, speeds, settings, and what they are
    ("fissure_retract", (0.1, 0.5, 2), ["bodies.lobes.shape.slit_width_m=0.005"], "a slit of 5 mm"),
    ("clamp_lift", (0.1, 0.5, 2), ["tools.smooth.friction=1"], "friction at both clamps"),
    ("forceps_press", (0.5,), ["time.step_s=0.00025"], "steps of 0.25 ms"),
    ("lift_two_plates", (10,), ["time.step_s=0.0001"], "steps of 0.1 ms"),
    ("clamp_scissors", (10,), ["time.step_s=0.0001"], "steps of 0.1 ms"),
    ("convex_spatula", (10,), ["time.step_s=0.0001"], "steps of 0.1 ms"),
    ("spatula_friction", (10,), ["time.step_s=0.0001"], "steps of 0.1 ms"),
]
SWEPT, SAME_GROUND, BULLETS_GROUND = "swept", "fukuhara on the half-space", "fukuhara"


def summaries(arguments, scene, words):
    """Summary values of each of the three runs."""
    found = {}
    common = [ROOT / f"configs/{scene}.yaml", "--no-frames", "--no-expect", "--json", "-j", 1, "--set", "time.step_s=0.001",
              "--set", "record.snapshots_every_s=1.0", *words]
    half_space = ["--set", "pipelines.fukuhara.ground_contact=half_space"]
    for names, more in (((SWEPT, SAME_GROUND), ["--pipeline", "swept", *half_space]), ((BULLETS_GROUND,), [])):
        with tempfile.TemporaryDirectory() as folder:
            finished = fissure(arguments, "run", *common, "-o", pathlib.Path(folder) / "result.h5", "--pipeline", "fukuhara", *more, accept=(0, 3))
        runs = {run["name"]: run["summary"] for run in json.loads(finished.stdout)["results"][0]["pipelines"]}
        found |= {name: runs["swept" if name == SWEPT else "fukuhara"] for name in names}
    return found


def measured(arguments, scene, speed, natural, sets=()):
    """Scene, speed and each run's summary, with these settings in place of the scene's."""
    scenario, natural_m_s = natural
    with tempfile.TemporaryDirectory() as folder:
        words = speed_words(scenario, speed / natural_m_s, folder)
        found = summaries(arguments, scene, [*words, *(word for one in sets for word in ("--set", one))])
    print(f"{scene}, {speed} m/s", *sets, flush=True)
    return scene, speed, found


def value(summary, names):
    return next((summary[name] for name in names if summary.get(name) is not None), math.nan)


def cell(pair):
    if any(map(math.isnan, pair)):
        return "-"
    text = f"{pair[0]:.3g} / {pair[1]:.3g}"
    return f"**{text}**" if pair[0] > pair[1] else text


def heads(first):
    return f"| {first} | " + " | ".join(f"{speed} m/s" for speed in SPEEDS_M_S) + " |\n" + "|---" * (first.count("|") + 1) + "|--:" * len(SPEEDS_M_S) + "|\n"


def table(found, beside):
    """Lines of Markdown with swept over the run `beside`, and the numbers in them: speed, of swept, beside it."""
    lines, pairs = [heads("scene | quantity")], []
    for scene in dict.fromkeys(scene for scene, _ in found):
        for quantity, names in QUANTITIES.items():
            own = [tuple(value(found[scene, speed][run], names) for run in (SWEPT, beside)) for speed in SPEEDS_M_S]
            good = [(speed, *pair) for speed, pair in zip(SPEEDS_M_S, own) if not any(map(math.isnan, pair))]
            if good:
                lines.append(f"| {scene} | {quantity} | " + " | ".join(map(cell, own)) + " |\n")
            pairs += good
    return lines, pairs


def counts(rows):
    """How many cells are how rough; `rows`: speed, value of swept and of nodes."""
    near, slow = 1.1, [(swept, nodes) for speed, swept, nodes in rows if speed <= 2]
    return {
        "cells": len(rows),
        "smoother": sum(swept <= nodes for _, swept, nodes in rows),
        "near": sum(nodes < swept <= near * nodes for _, swept, nodes in rows),
        "slow": sum(swept > near * nodes for swept, nodes in slow),
        "slow_cells": len(slow),
    }


def switched_rows(found, switched):
    for (scene, _, _, text), runs in zip(SWITCHES, switched):
        for speed, run in runs.items():
            for quantity, names in QUANTITIES.items():
                was, now = (tuple(value(one[name], names) for name in (SWEPT, SAME_GROUND)) for one in (found[scene, speed], run))
                if was[0] > was[1]:
                    yield f"| {scene} | {text} | {quantity} | {speed} | {cell(was)} | {cell(now)} |\n"


def depths(found):
    lines = [heads("scene")]
    for scene in dict.fromkeys(scene for scene, _ in found):
        cells = []
        for speed in SPEEDS_M_S:
            below_mm = [1e3 * value(found[scene, speed][run], ["max_ground_depth_m"]) for run in (SWEPT, SAME_GROUND, BULLETS_GROUND)]
            cells.append(" / ".join(f"{mm:.2f}" for mm in below_mm))
        lines.append(f"| {scene} | " + " | ".join(cells) + " |\n")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--folder", default=FOLDER, type=pathlib.Path, help="where the page goes")
    arguments = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        natural = dict(zip(SCENES, pool.map(lambda scene: natural_speed_m_s(arguments, scene), SCENES)))

        def submit(scene, speed, sets=()):
            return pool.submit(measured, arguments, scene, speed, natural[scene], sets)

        runs = [submit(scene, speed) for scene in SCENES for speed in SPEEDS_M_S]
        without = {scene: [f"bodies.{body}.fixed=[{{below_m: 0.003}}]", "ground.height_m=-1"] for scene, body in HELD.items()}
        freed = [submit(scene, speed, sets) for scene, sets in without.items() for speed in SPEEDS_M_S]
        switched = [{speed: submit(scene, speed, sets) for speed in speeds} for scene, speeds, sets, _ in SWITCHES]
        switched = [{speed: run.result()[2] for speed, run in runs_of.items()} for runs_of in switched]
        found, held = ({(scene, speed): values for scene, speed, values in (run.result() for run in some)} for some in (runs, freed))
    page = HEAD
    for text, run in ((SAME, SAME_GROUND), (BULLETS, BULLETS_GROUND)):
        lines, pairs = table(found, run)
        page += text.format(**counts(pairs)) + "".join(lines)
    page += CAUSES + "".join(switched_rows(found, switched)) + BELOW + "".join(depths(found)) + FLOOR + "".join(table(held, BULLETS_GROUND)[0])
    arguments.folder.mkdir(parents=True, exist_ok=True)
    (arguments.folder / "README.md").write_text(page)
    print(f"written: {arguments.folder / 'README.md'}")


if __name__ == "__main__":
    main()
