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

Roughness of the first force law and of the constraint reaction (README: RMS of the second difference over that of the value), at 1 ms, `swept`
over `fukuhara`; the speed is that of the fastest point of a tool. Jaws: of several tools each by itself, all values together; between two
jaws the sum nearly cancels, and its own roughness compares little with little. **Bold**: swept is rougher. {smoother} of {cells} cells are as
smooth as nodes or smoother.

What is left in spatula_press, a free ball under a blade without friction: at the blade's rim normals point aside and the ball slides out. With
normals of the blade's face at the rim, or with the ball held at one vertex, most of it is gone; the law's set of triangles (largest weight for
their sum, by a triangle's own distance) and the solver's convergence (300 sweeps) change less, and either way. Normals of the face are no remedy
elsewhere: a wedge that parts tissue then pushes with its narrow edge. At 2 and 10 m/s most of what there is comes of the steps in
which the tool strikes, starts or halts.

"""
FLOOR = """
## Without the floor

`fukuhara` stands on Bullet's ground, which gives way by millimetres and takes jolts; that of `swept` does not. The same with the
body held at its vertices below 3 mm and no floor (`ground.height_m: -1`): what is left is the contact's own.

"""


def roughness(arguments, scene, speed, scenario, natural_m_s, body=None):
    """`body`: held below instead of lying on the floor."""
    held = ["--set", f"bodies.{body}.fixed=[{{below_m: 0.003}}]", "--set", "ground.height_m=-1"] if body else []
    with tempfile.TemporaryDirectory() as folder:
        words = speed_words(scenario, speed / natural_m_s, folder)
        finished = fissure(arguments, "run", ROOT / f"configs/{scene}.yaml", "-o", pathlib.Path(folder) / "result.h5", "--no-frames", "--no-expect",
                           "--json", "-j", 1, "--pipeline", "fukuhara", "--pipeline", "swept", "--set", "time.step_s=0.001",
                           "--set", "record.snapshots_every_s=1.0", *words, *held, accept=(0, 3))
    runs = {run["name"]: run["summary"] for run in json.loads(finished.stdout)["results"][0]["pipelines"]}
    found = {}
    for quantity, names in QUANTITIES.items():
        pair = [next((run[name] for name in names if run.get(name) is not None), math.nan) for run in (runs["swept"], runs["fukuhara"])]
        if not all(map(math.isnan, pair)):
            found[quantity] = pair
    print(f"{scene}, {speed} m/s: " + ", ".join(f"{name} {swept:.4f}/{nodes:.4f}" for name, (swept, nodes) in found.items()), flush=True)
    return scene, speed, found


def cell(pair):
    if pair is None or any(map(math.isnan, pair)):
        return "-"
    text = f"{pair[0]:.3g} / {pair[1]:.3g}"
    return f"**{text}**" if pair[0] > pair[1] else text


def table(found):
    """Lines of Markdown, and the pairs of numbers in them."""
    lines, pairs = [], []
    lines.append("| scene | quantity | " + " | ".join(f"{speed} m/s" for speed in SPEEDS_M_S) + " |\n|---|---" + "|--:" * len(SPEEDS_M_S) + "|\n")
    for scene in dict.fromkeys(scene for scene, _ in found):
        for quantity in QUANTITIES:
            own = [found[scene, speed].get(quantity) for speed in SPEEDS_M_S]
            if not any(own):
                continue
            lines.append(f"| {scene} | {quantity} | " + " | ".join(map(cell, own)) + " |\n")
            pairs += [pair for pair in own if pair and not any(map(math.isnan, pair))]
    return lines, pairs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        natural = dict(zip(SCENES, pool.map(lambda scene: natural_speed_m_s(arguments, scene), SCENES)))
        runs = [pool.submit(roughness, arguments, scene, speed, *natural[scene]) for scene in SCENES for speed in SPEEDS_M_S]
        freed = [pool.submit(roughness, arguments, scene, speed, *natural[scene], body) for scene, body in HELD.items() for speed in SPEEDS_M_S]
        tables = [{(scene, speed): values for scene, speed, values in (run.result() for run in some)} for some in (runs, freed)]
    (lines, pairs), (held_lines, _) = (table(found) for found in tables)
    smoother = sum(swept <= nodes for swept, nodes in pairs)
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / "README.md").write_text(HEAD.format(smoother=smoother, cells=len(pairs)) + "".join(lines) + FLOOR + "".join(held_lines))
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}")


if __name__ == "__main__":
    main()
