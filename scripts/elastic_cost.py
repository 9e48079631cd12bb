#!/usr/bin/env python3
"""What elastic tissue costs beside Bullet's shell, and how its cost grows: writes results/elastic_cost.

    /usr/bin/python3 scripts/elastic_cost.py

Runs alternate on one core; a machine with nothing else to do gives the numbers a meaning.
"""
import argparse
import json
import pathlib
import statistics
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from montage import COLOURS
from references import ROOT, fissure

FOLDER = ROOT / "results/elastic_cost"
REPEATS = 5
# A press as in spatula_press: the blade goes 8 mm into a ball of 30 mm, and waits. Bodies: shape, what makes them soft, and what holds them.
SCENE = """format: 1
name: cost
time: {{step_s: 0.001}}
world: {{gravity_m_s2: [0, 0, 0]}}
bodies:
  - name: ball
    shape: {shape}
    fixed: [{{below_m: -0.02}}]
    {body}
tools:
  - name: blade
    shape: {{type: box, size_m: [0.04, 0.002, 0.015]}}
    motion:
      type: script
      start_m: [0, 0.0316, 0]
      segments:
        - {{move_to_m: [0, 0.0235, 0], speed_m_s: 0.1, timing: minimum_jerk}}
        - {{hold_s: {hold_s}}}
pipelines:
  - {pipeline}
"""
SHELL = "material: {linear_stiffness: 0.5}\n    solver: {pose_matching: 0.02, damping: 0.01, position_iterations: 10}"
ELASTIC = "model: elastic\n    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4, density_kg_m3: 1000, viscosity_Pa_s: 1}"
BLOCK = "{type: box, size_m: [0.06, 0.06, 0.06], cells: [26, 26, 26]}"


def ball(subdivisions):
    return f"{{type: sphere, radius_m: 0.03, subdivisions: {subdivisions}}}"


SWEPT, DEFAULT, NODES = "{pipeline: swept}", "{pipeline: default}", "{pipeline: fukuhara}"
# Name, tetrahedra, scene.
RUNS = [
    ("shell of 128 triangles, Bullet's default contact", 0, dict(shape=ball(2), body=SHELL, pipeline=DEFAULT, hold_s=0.2)),
    ("512 tetrahedra, swept", 512, dict(shape=ball(2), body=ELASTIC, pipeline=SWEPT, hold_s=0.2)),
    ("512 tetrahedra, fukuhara", 512, dict(shape=ball(2), body=ELASTIC, pipeline=NODES, hold_s=0.2)),
    ("4,096 tetrahedra, swept", 4096, dict(shape=ball(3), body=ELASTIC, pipeline=SWEPT, hold_s=0.2)),
    ("32,768 tetrahedra, swept", 32768, dict(shape=ball(4), body=ELASTIC, pipeline=SWEPT, hold_s=0.01)),
    ("105,456 tetrahedra, swept", 105456, dict(shape=BLOCK, body=ELASTIC, pipeline=SWEPT, hold_s=0.01)),
]
HEAD = """# What elastic tissue costs

    /usr/bin/python3 scripts/elastic_cost.py

A blade goes 8 mm into a ball of 30 mm radius (105,456 tetrahedra: a block of 60 mm), E 10 kPa, nu 0.4, viscosity 1 Pa s, steps of 1 ms. Medians
of {repeats} runs on one machine, taken in turn; times of different machines do not compare, ratios do. Substeps: as many as the mesh's
fastest vibration asks for. The share of contact is of the whole step.

| run | mean step, of the shell's | p99 step, ms | substeps | contact | mean step, us per tetrahedron and substep |
|---|--:|--:|--:|--:|--:|
"""


def measure(arguments, scene):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "cost.yaml"
        path.write_text(SCENE.format(**scene))
        finished = fissure(arguments, "run", path, "-o", path.with_suffix(".h5"), "--json", "-j", 1, accept=(0, 3))
    [run] = json.loads(finished.stdout)["results"][0]["pipelines"]
    return run["summary"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    arguments = parser.parse_args()
    found = {name: [] for name, _, _ in RUNS}
    for repeat in range(REPEATS):
        for name, _, scene in RUNS:
            found[name].append(measure(arguments, scene))
            print(f"{repeat + 1}/{REPEATS} {name}: {found[name][-1]['timing/mean_step_us']:.0f} us", flush=True)
    median = {name: {key: statistics.median(run[key] for run in runs if key in run)
                     for key in ("timing/mean_step_us", "timing/p99_step_us", "timing/collision_share", "max_substeps") if key in runs[0]}
              for name, runs in found.items()}
    shell_us = median[RUNS[0][0]]["timing/mean_step_us"]
    lines = []
    for name, tetrahedra, _ in RUNS:
        own = median[name]
        substeps = own.get("max_substeps")
        per = own["timing/mean_step_us"] / (tetrahedra * substeps) if substeps else None
        lines.append(f"| {name} | {own['timing/mean_step_us'] / shell_us:.2f} | {own['timing/p99_step_us'] / 1000:.3f} | "
                     f"{substeps if substeps else ''} | {own['timing/collision_share']:.0%} | {f'{per:.4f}' if per else ''} |\n")
    FOLDER.mkdir(parents=True, exist_ok=True)
    draw(median)
    (FOLDER / "README.md").write_text(HEAD.format(repeats=REPEATS) + "".join(lines) + "\n![Time of a step over the number of tetrahedra](growth.png)\n")
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}")


def draw(median):
    points = [(tetrahedra, median[name]) for name, tetrahedra, _ in RUNS if name.endswith("swept")]
    sizes = [tetrahedra for tetrahedra, _ in points]
    unit_us = points[0][1]["timing/mean_step_us"]
    figure, axis = plt.subplots(figsize=(5.5, 4), constrained_layout=True)
    axis.loglog(sizes, [own["timing/mean_step_us"] / unit_us for _, own in points], "o-", color=COLOURS[0], label="step of 1 ms")
    axis.loglog(sizes, [own["timing/mean_step_us"] / own["max_substeps"] / unit_us for _, own in points], "o-", color=COLOURS[1],
                label="one substep of it")
    axis.loglog(sizes, [size / sizes[0] for size in sizes], ":", color="grey", label="in proportion to tetrahedra")
    axis.set_xlabel("tetrahedra")
    axis.set_ylabel("time, 1: a step of 512 tetrahedra")
    axis.grid(alpha=0.3)
    axis.legend(frameon=False, fontsize=8)
    figure.savefig(FOLDER / "growth.png", dpi=90, metadata={"Software": None})
    plt.close(figure)


if __name__ == "__main__":
    main()
