#!/usr/bin/python3
"""How building, steps and memory grow with the mesh, and which mesh holds a millisecond: writes results/large_meshes.

    /usr/bin/python3 scripts/large_meshes.py            over a quarter of an hour; --program: another fissure than build/release/fissure

A machine with nothing else to do gives the times a meaning.
"""
import argparse
import json
import math
import pathlib
import statistics
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from montage import COLOURS
from references import ROOT, fissure

FOLDER = ROOT / "results/large_meshes"
REPEATS = 3
LIMIT_US = 1000
# A plate meets a ball at its top: 12 mm at 0.5 m/s, the last 6 of them in tissue, then it waits.
SCENE = """format: 1
name: large
time: {{step_s: 0.001}}
world: {{gravity_m_s2: [0, 0, 0]}}
bodies:
  - name: ball
    shape: {{type: sphere, radius_m: 0.03, subdivisions: {subdivisions}}}
    {body}
tools:
  - name: plate
    shape: {{type: box, size_m: [0.08, 0.005, 0.08]}}
    nodes: {{resolution: [16, 16]}}
    motion:
      type: script
      start_m: [0, 0.0385, 0]
      segments:
        - {{move_to_m: [0, 0.0265, 0], speed_m_s: 0.5, timing: constant}}
        - {{hold_s: {hold_s}}}
pipelines:
  - {pipeline}
"""
SHELL = """mass_kg: 0.1
    margin_m: 0.002
    fixed: [{below_m: -0.02}]
    material: {linear_stiffness: 0.5}
    solver: {pose_matching: 0.02, damping: 0.01, position_iterations: 10}"""
ELASTIC = """model: elastic
    fixed: [{below_m: -0.02}]
    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4, density_kg_m3: 1000, viscosity_Pa_s: 1}"""
DEFAULT = "{name: default_tuned, pipeline: default, settings: tuned}"
NODES, SWEPT = "{pipeline: fukuhara}", "{pipeline: swept}"
# Tissue, pipeline, its entry, subdivisions from the coarsest to the finest mesh that the program takes.
RUNS = [("shell", "default_tuned", DEFAULT, range(2, 8)), ("shell", "fukuhara", NODES, range(2, 8)), ("shell", "swept", SWEPT, range(2, 8)),
        ("elastic", "fukuhara", NODES, range(2, 6)), ("elastic", "swept", SWEPT, range(2, 6))]
HEAD = """# Meshes a thousand times larger

    /usr/bin/python3 scripts/large_meshes.py

A plate of 80 mm presses a ball of 30 mm radius by 6 mm in steps of 1 ms, its surface divided ever finer: Bullet's shell, and elastic tissue (E 10 kPa,
nu 0.4), whose ball has as many tetrahedra as said. Nothing but the summary is recorded. Times are of one machine, medians of {repeats} runs in turn, one at a time.
Not measured, because the program refuses it: a shell above 131,072 triangles, tissue above 500,000 tetrahedra.

## Which mesh holds a millisecond

The largest mesh of this ladder whose steps, 99 of 100, take less than a millisecond each, and the first that does not: over 400 steps in contact. A
step is engine and contact; what is measured of it comes on top ([how much](../../bench/README.md)). What limits is the larger part of the mean step.

| tissue | run | largest | p99 | next | p99 | its contact | what limits |
|---|---|--:|--:|--:|--:|--:|---|
"""
GROWTH = """
## Growth

Of a run of 40 steps: the mean step, what measuring penetration and the certificate take of each step beside it, and building, which is the
rest: all before the first step, the ball's mesh included, and the end. From four runs each, with and without the certificate, measured in every step and in the first
and last alone. Exponents: of the time as a power of the size, from the row before to this; 1 is in proportion. Memory: of the process, beyond that
with the coarsest mesh, per triangle (tetrahedron) beyond those of that. Elastic tissue needs substeps in proportion to the cube root of its number of tetrahedra,
so that there 1.33 is each substep in proportion. Measuring and the certificate are differences of runs: on coarse meshes, and of the certificate everywhere, as
large as the noise of the machine.

![Time of a step, of measuring and of building over the size of the mesh](growth.png)

| tissue | run | size | step, ns each | exponent | measuring | exponent | certificate | exponent | build, us each | exponent | memory, bytes each |
|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
"""
STEPS = 40
SWEEP = """format: 1
name: growth
base: {base}
axes:
  - {{path: measure.every, values: [1, 1000000]}}
  - {{path: measure.certify, values: [false, true]}}
"""
COLUMNS = ("step_s", "measure_s", "certify_s", "build_s")


def size_of(tissue, subdivisions):
    """Triangles of the shell, tetrahedra of the tissue."""
    return 8 * 4**subdivisions if tissue == "shell" else 512 * 8 ** (subdivisions - 2)


class Runs:
    def __init__(self, arguments, folder):
        self.arguments, self.folder, self.count = arguments, folder, 0

    def write(self, tissue, entry, subdivisions, hold_s):
        path = self.folder / "large.yaml"
        path.write_text(SCENE.format(subdivisions=subdivisions, body=SHELL if tissue == "shell" else ELASTIC, hold_s=hold_s, pipeline=entry))
        return path

    def summary(self, tissue, entry, subdivisions):
        path = self.write(tissue, entry, subdivisions, 0.4)
        words = ("run", path, "-o", path.with_suffix(".h5"), "--force", "--json", "--no-frames")
        [run] = json.loads(fissure(self.arguments, *words).stdout)["results"][0]["pipelines"]
        if run["status"] != "ok":
            raise SystemExit(f"{tissue}, {entry}, {subdivisions}: {run['status']}")
        return run["summary"]

    def growth(self, tissue, entry, subdivisions):
        """Seconds by COLUMNS, and MiB of the process."""
        path = self.write(tissue, entry, subdivisions, 0.016)
        sweep, out = path.with_name("growth_sweep.yaml"), self.folder / f"growth{self.count}"
        self.count += 1
        sweep.write_text(SWEEP.format(base=path))
        fissure(self.arguments, "sweep", sweep, "-o", out, "-j", 1)
        with h5py.File(out / "sweep.h5") as table:
            step_s = 1e-6 * statistics.median(table["timing/mean_step_us"][:])
            beside = table["timing/simulation_wall_s"][:] - 1e-6 * STEPS * table["timing/mean_step_us"][:]
            by_point = dict(zip(zip(table["every"][:], table["certify"].asstr()[:]), beside))
            memory_mib = max(table["timing/worker_memory_mb"][:])
        measured, certified, bare = by_point[1, "false"], by_point[1, "true"], by_point[1000000, "false"]
        return {"step_s": step_s, "measure_s": (measured - bare) / (STEPS - 1), "certify_s": (certified - measured) / STEPS, "build_s": bare,
                "memory_mib": memory_mib, "size": size_of(tissue, subdivisions)}


def ladder(runs, tissue, name, entry, sizes):
    """(subdivisions, p99 in us, share of contact) from the coarsest mesh to the first above the limit."""
    found = []
    for subdivisions in sizes:
        summaries = [runs.summary(tissue, entry, subdivisions) for _ in range(REPEATS)]
        median = {key: statistics.median(one[key] for one in summaries) for key in ("timing/p99_step_us", "timing/collision_share")}
        found.append((subdivisions, median["timing/p99_step_us"], median["timing/collision_share"]))
        print(f"{tissue} {name} {size_of(tissue, subdivisions):,}: p99 {found[-1][1]:.0f} us", flush=True)
        if found[-1][1] > LIMIT_US:
            break
    return found


def limit_rows(runs):
    for tissue, name, entry, sizes in RUNS:
        found = ladder(runs, tissue, name, entry, sizes)
        good = [one for one in found if one[1] <= LIMIT_US]
        bad = [one for one in found if one[1] > LIMIT_US]
        largest = (f"{size_of(tissue, good[-1][0]):,}", f"{good[-1][1] / 1000:.2f} ms") if good else ("none", "")
        following, what = ("", "", ""), ""
        if bad:
            subdivisions, p99_us, share = bad[0]
            following = (f"{size_of(tissue, subdivisions):,}", f"{p99_us / 1000:.2f} ms", f"{share:.0%}")
            what = "contact" if share > 0.5 else "the tissue's solver" if tissue == "elastic" else "Bullet's solver"
        yield "| " + " | ".join([tissue, name, *largest, *following, what]) + " |\n"


def measure_growth(runs):
    """{(tissue, run): what Runs.growth gives, from the coarsest mesh to the finest}"""
    found = {}
    for tissue, name, entry, sizes in RUNS:
        for subdivisions in sizes:
            one = runs.growth(tissue, entry, subdivisions)
            found.setdefault((tissue, name), []).append(one)
            print(f"growth {tissue} {name} {one['size']:,}: {1000 * one['step_s']:.2f} ms", flush=True)
    return found


def exponent(column, before, now):
    if not before or before[column] <= 0 or now[column] <= 0:
        return ""
    return f"{math.log(now[column] / before[column]) / math.log(now['size'] / before['size']):.2f}"


def growth_rows(found):
    for (tissue, name), rows in found.items():
        for before, now in zip([None, *rows], rows):
            cells = [tissue, name, f"{now['size']:,}"]
            for column in COLUMNS:
                each = now[column] / now["size"]
                cells += [f"{1e6 * each:.1f}" if column == "build_s" else f"{1e9 * each:.0f}", exponent(column, before, now)]
            more = now["size"] - rows[0]["size"]
            cells.append(f"{1048576 * (now['memory_mib'] - rows[0]['memory_mib']) / more:,.0f}" if more else "")
            yield "| " + " | ".join(cells) + " |\n"


def draw(found):
    figure, axes = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    for colour, ((tissue, name), rows) in zip(COLOURS, found.items()):
        style = "o-" if tissue == "shell" else "s--"
        for axis, column in zip(axes, ("step_s", "measure_s", "build_s")):
            axis.loglog([row["size"] for row in rows], [1000 * row[column] for row in rows], style, color=colour, markersize=4, label=f"{tissue}, {name}")
    for axis, what in zip(axes, ("step", "measuring, per step", "building")):
        low, high = axis.get_xlim()
        bottom = axis.get_ylim()[0]
        axis.loglog((low, high), (bottom, bottom * high / low), ":", color="grey", label="in proportion")
        axis.set_ylabel(f"{what}, ms")
        axis.set_xlabel("triangles (shell), tetrahedra (elastic)")
        axis.grid(alpha=0.3)
    axes[0].axhline(1, color="black", linewidth=0.8)
    axes[0].legend(frameon=False, fontsize=8)
    figure.savefig(FOLDER / "growth.png", dpi=90, metadata={"Software": None})
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(arguments, pathlib.Path(folder))
        limits = "".join(limit_rows(runs))
        found = measure_growth(runs)
    FOLDER.mkdir(parents=True, exist_ok=True)
    draw(found)
    (FOLDER / "README.md").write_text(HEAD.format(repeats=REPEATS) + limits + GROWTH + "".join(growth_rows(found)))
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}")


if __name__ == "__main__":
    main()
