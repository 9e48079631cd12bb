#!/usr/bin/env python3
"""Whether configs/elastic_press.yaml converges: steps, meshes, pipelines, speeds, materials and repeats; writes results/elastic.

    /usr/bin/python3 scripts/elastic_table.py [-j N]

Writes README.md, convergence.csv and elastic.png.
"""
import argparse
import concurrent.futures
import csv
import math
import os
import pathlib
import tempfile

import h5py
import matplotlib
import numpy as np

from references import ROOT, fissure

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = ROOT / "results/elastic"
SCENARIO = ROOT / "configs/elastic_press.yaml"
PIPELINES = ["swept", "fukuhara", "tissue_alone"]
STEPS_S = [0.004, 0.002, 0.001, 0.0005, 0.00025, 0.000125]
RUNS = [(n, step_s, PIPELINES, None) for n in (2, 3) for step_s in STEPS_S]  # subdivisions, step, pipelines, duration
# The finest mesh until the end of the first hold, at fewer steps and with one run of the other pipelines: it takes minutes a run.
RUNS += [(4, step_s, ["swept"], 0.37) for step_s in (0.004, 0.001, 0.00025)] + [(4, 0.001, PIPELINES[1:], 0.37)]
SETTLED = 0.3  # share of a hold that is left out of its mean
SPEEDS_M_S = [0.02, 0.1, 0.5]  # mean, of every segment
FAST_M_S = [0.5, 1, 1.5, 2, 2.5, 3, 4, 6, 8, 10]  # fastest, of the first segment
WAVE_M_S = math.sqrt(1e4 * (1 - 0.4) / ((1 + 0.4) * (1 - 2 * 0.4)) / 1000)  # of the scene's tissue
JERK = 1.875  # fastest over mean speed of minimum_jerk
MODULI_PA = [10, 100, 1e3, 1e4, 1e5, 1e6, 1e7]
RATIOS = [0, 0.2, 0.4, 0.45, 0.46, 0.49]
INSTRUCTIONS = ["baseline", "avx2", "avx512"]
FORCES = {"held1_N": ("first hold [N]", ".4f"), "held2_N": ("second hold [N]", ".4f"), "peak_N": ("peak [N]", ".4f")}
OTHERS = {
    "law1_N": ("law, first hold [N]", ".3f"),
    "gauge1_mm": ("gauge, first hold [mm]", ".4f"),
    "stored1_mJ": ("stored energy, first hold [mJ]", ".4f"),
    "shape": ("farthest vertex from the finest step's, holds and end [mm]", ".4f"),
    "balance_percent": ("error of the energy balance [%]", ".2g"),
}
COLOURS = {"swept": "#0072B2", "fukuhara": "#D55E00", "tissue_alone": "#009E73"}


PAGE = """# Whether the elastic scene converges

    /usr/bin/python3 scripts/elastic_table.py

[elastic_press](../../configs/elastic_press.yaml): a blade presses a ball of 10 kPa, waits, slides along it, waits and lets go. Steps are 4 to 0.125
ms, meshes have 512, 4,096 and 32,768 tetrahedra, three pipelines. The finest mesh runs until the end of the first hold, with fewer steps: it takes
minutes a run. Means over the holds without their first third; all numbers are in [convergence.csv](convergence.csv).

![Reaction over the step, and inverted elements over the tool's speed](elastic.png)

## Steps and meshes

From 1 ms down the held reactions differ from those of the finest step by at most: {steps} (meshes of 512 and 4,096).

{forces}
Over the step there is no order to observe: contacts and elements work in the substeps that the mesh asks for, whatever the step, and what is left
are differences in the fifth digit. `tissue_alone` glues the vertices that the blade reaches; on a coarse mesh these are few, and its force is
lower.

Over the mesh (`swept`, first hold, 1 ms) the reaction stays within {mesh_spread} %, but the scene is not the same on every mesh, so that no order
is to be had either. Held are the vertices below -20 mm, and the triangles between them cover more of the ball on a finer mesh (the ball's own cap
has 18.8 cm2); a coarse ball is smaller (113.1 cm3). A tool with sharp edges adds a concentration of stress, which meshes resolve slowly. That
meshes converge where the problem is the same on all is shown [beside theory](../theory/README.md).

{meshes}
{others}
The law is a sum over triangles that contacts touch: with each mesh it grows by a factor of about 3.5, and it jumps where a triangle enters or
leaves the sum (`fukuhara` from 0.5 to 0.25 ms). It is no measure of force; the reaction is.

## Nodes beside swept contact

`fukuhara` over `swept`. At 0.5 m/s the ball still swings in the holds.

{nodes}
## Fast tools

The blade's first segment so fast (steps of 0.1 ms, 4,096 tetrahedra, `swept`); P-waves of this tissue make {wave} m/s. No element is inverted by
tools up to {calm} of that speed; those that faster tools invert are back by the end.

{fast}
## Materials

`swept`, 512 tetrahedra, 1 ms, everything else as the file says: the viscosity of 5 Pa s too, which is why the softest tissue is not at rest within
the hold (5 Pa s over 10 Pa are 0.5 s). Above nu 0.45 elements take their pressure from nodal averages: the reaction falls from 0.45 to 0.46, by
what single elements lock on this mesh.

{materials}
## Repeats

{repeats}
"""


def simulated(arguments, words, pipelines, read, accept=(0, 3)):
    """What `read` makes of each of the runs `pipelines`, by name; nothing of each where the program refuses the scenario, if accepted."""
    with tempfile.TemporaryDirectory() as folder:
        result = pathlib.Path(folder) / "result.h5"
        options = [word for name in pipelines for word in ("--pipeline", name)] + [word for text in words for word in ("--set", text)]
        fissure(arguments, "run", SCENARIO, "-o", result, "--no-frames", "--no-expect", "-j", 1, *options, accept=accept)
        if not result.exists():
            return dict.fromkeys(pipelines)
        with h5py.File(result) as file:
            return {name: read(file[f"pipelines/{name}"]) for name in pipelines}


def holds(run):
    """First and last index of each hold of the tool that follows contact, the settling left out."""
    position_m = run["tool_position"][:, 0]
    still = np.append(False, np.linalg.norm(np.diff(position_m, axis=0), axis=1) < 1e-12).astype(int)
    starts, ends = np.flatnonzero(np.diff(still) == 1) + 1, np.flatnonzero(np.diff(np.append(still, 0)) == -1)
    return [(first + round(SETTLED * (last - first)), last) for first, last in zip(starts, ends)]


def row_of(run):
    """The numbers of a run, and its surface at the end of the holds and of the motion."""
    reaction_N, summary = run["reaction_force"][:], run["summary"].attrs
    row = {"status": run.attrs["status"], "peak_N": np.linalg.norm(reaction_N, axis=1).max()}
    instants = []
    for index, (first, last) in enumerate(holds(run), 1):
        held = slice(first, last + 1)
        row[f"held{index}_N"] = np.linalg.norm(reaction_N[held].mean(axis=0))
        row[f"law{index}_N"] = np.linalg.norm(run["force"][0][held].mean(axis=0))
        row[f"gauge{index}_mm"] = 1000 * np.linalg.norm(run["gauge_displacement"][last, 0])
        row[f"stored{index}_mJ"] = 1000 * run["stored_energy"][last]
        instants.append(run["time"][first])
    row["balance_percent"] = 100 * summary["energy_balance_error"]
    row["substeps"], row["inverted"] = int(summary["max_substeps"]), int(summary["max_inverted_elements"])
    row["depth_mm"] = 1000 * summary["max_penetration_depth_m"]
    times = run["snapshot_time"][:]
    shapes = [run["positions"][int(np.searchsorted(times, instant - 1e-9))] for instant in instants] + [run["positions"][-1]]
    return row, np.array(shapes)


def converged(arguments, subdivisions, step_s, pipelines, duration_s):
    """Rows and shapes of one mesh and step, by pipeline."""
    words = [f"bodies.ball.shape.subdivisions={subdivisions}", f"time.step_s={step_s!r}"] + ([f"time.duration_s={duration_s}"] if duration_s else [])
    found = simulated(arguments, words, pipelines, row_of)
    for name, (row, _) in found.items():
        print(subdivisions, step_s, name, row, flush=True)
    return found


def pressed_at(arguments, speed_m_s):
    segments = [f"tools.blade.motion.segments.{index}.speed_m_s={speed_m_s!r}" for index in (0, 2, 4)]
    found = simulated(arguments, segments, PIPELINES[:2], row_of)
    print("speed", speed_m_s, {name: row for name, (row, _) in found.items()}, flush=True)
    return {name: row for name, (row, _) in found.items()}


def struck(arguments, speed_m_s):
    """A run whose first segment is so fast; it ends after the first hold."""

    def read(run):
        inverted = run["inverted_elements"][:]
        summary = run["summary"].attrs
        return {"status": run.attrs["status"], "inverted": int(inverted.max()), "left": int(inverted[-1]), "substeps": int(summary["max_substeps"]),
                "tool_m_s": summary["blade_max_speed_m_s"], "balance_percent": 100 * summary["energy_balance_error"]}

    words = [f"tools.blade.motion.segments.0.speed_m_s={speed_m_s / JERK!r}", "time.step_s=0.0001", "time.duration_s=0.1"]
    found = simulated(arguments, words, ["swept"], read)["swept"]
    print("fast", speed_m_s, found, flush=True)
    return found


def held_surface(arguments, subdivisions):
    """Area of the triangles whose vertices are all held, m2, and the ball's volume, m3."""

    def read(run):
        corners, faces = run["positions"][0], run["faces"][:]
        a, b, c = (corners[faces[:, corner]] for corner in range(3))
        areas_m2 = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        held = (np.maximum(np.maximum(a, b), c)[:, 1] <= -0.02)
        return areas_m2[held].sum(), np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6

    words = [f"bodies.ball.shape.subdivisions={subdivisions}", "time.duration_s=0.001"]
    return simulated(arguments, words, ["swept"], read)["swept"]


def of_material(arguments, modulus_Pa, ratio):
    words = [f"bodies.ball.elastic.{name}={value!r}" for name, value in {"youngs_modulus_Pa": modulus_Pa, "poissons_ratio": ratio}.items()]
    words += ["bodies.ball.shape.subdivisions=2"]
    row, _ = simulated(arguments, words, ["swept"], row_of)["swept"]
    print("material", modulus_Pa, ratio, row, flush=True)
    return row


def hashes(arguments):
    """Hash of the final state by pipeline, of two runs and one of each instruction set; None where this machine has not the set."""

    def read(run):
        return run["summary"].attrs["final_state_hash"]

    found = {}
    for name, instructions in {"first": "", "second": "", **{name: name for name in INSTRUCTIONS}}.items():
        os.environ.pop("FISSURE_INSTRUCTIONS", None)
        if instructions:
            os.environ["FISSURE_INSTRUCTIONS"] = instructions
        found[name] = simulated(arguments, ["bodies.ball.shape.subdivisions=2"], PIPELINES, read, accept=(0, 2, 3))
    os.environ.pop("FISSURE_INSTRUCTIONS", None)
    print(found, flush=True)
    return found


def measured(arguments):
    found = {"hashes": hashes(arguments), "held": {n: held_surface(arguments, n) for n in (2, 3, 4)}}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {
            "speeds": {speed: pool.submit(pressed_at, arguments, speed) for speed in SPEEDS_M_S},
            "fast": {speed: pool.submit(struck, arguments, speed) for speed in FAST_M_S},
            "moduli": {modulus: pool.submit(of_material, arguments, modulus, 0.4) for modulus in MODULI_PA},
            "ratios": {ratio: pool.submit(of_material, arguments, 1e4, ratio) for ratio in RATIOS},
        }
        grid = [(n, step_s, pool.submit(converged, arguments, n, step_s, *more)) for n, step_s, *more in RUNS]
        found |= {name: {key: run.result() for key, run in some.items()} for name, some in runs.items()}
        found["grid"] = {(n, step_s, name): row for n, step_s, run in grid for name, row in run.result().items()}
    return found


def tetrahedra(subdivisions):
    return f"{8**(subdivisions + 1):,}"


def of_step(grid, subdivisions, pipeline):
    """Rows of one mesh and pipeline, by step from the longest; shapes beside them."""
    return {step_s: found for (n, step_s, name), found in sorted(grid.items(), key=lambda item: -item[0][1]) if (n, name) == (subdivisions, pipeline)}


def heading(words, numbers):
    """Both lines of a table's head: columns of words and columns of numbers."""
    return "| " + " | ".join([*words, *numbers]) + " |\n|" + "---|" * len(words) + "--:|" * len(numbers) + "\n"


def convergence_table(grid, names, pipelines):
    lines = [heading(["tetrahedra", "pipeline", "quantity"], [f"{1000 * step_s:g} ms" for step_s in STEPS_S])]
    for subdivisions in sorted({n for n, _, _ in grid}):
        for pipeline in pipelines:
            found = of_step(grid, subdivisions, pipeline)
            finest = found[min(found)][1]
            for name, (head, form) in names.items():
                cells = []
                for step_s in STEPS_S:
                    row, shapes = found.get(step_s, ({}, None))
                    if name == "shape":
                        value = 1000 * np.linalg.norm(shapes - finest, axis=2).max() if row and step_s != min(found) else None
                    else:
                        value = row.get(name)
                    cells.append("-" if value is None else format(value, form))
                if set(cells) != {"-"}:
                    lines.append(f"| {tetrahedra(subdivisions)} | {pipeline} | {head} | " + " | ".join(cells) + " |\n")
    return "".join(lines)


def mesh_table(found):
    names = ["tetrahedra", "held surface [cm2]", "volume [cm3]", "reaction [N]", "stored energy [mJ]", "gauge [mm]", "law [N]"]
    lines = [heading([], names)]
    for subdivisions, (area_m2, volume_m3) in found["held"].items():
        row = found["grid"][subdivisions, 0.001, "swept"][0]
        cells = [f"{1e4 * area_m2:.1f}", f"{1e6 * volume_m3:.1f}", f"{row['held1_N']:.4f}"]
        cells += [f"{row['stored1_mJ']:.3f}", f"{row['gauge1_mm']:.3f}", f"{row['law1_N']:.2f}"]
        lines.append(f"| {tetrahedra(subdivisions)} | " + " | ".join(cells) + " |\n")
    return "".join(lines)


def apart(swept, nodes, name):
    return 100 * (nodes[name] / swept[name] - 1)


def node_table(found):
    lines = [heading([], ["tetrahedra", "step", "speed", "first hold", "second hold", "peak"])]
    grid = found["grid"]
    nodes = {(n, step_s): row for (n, step_s, name), (row, _) in grid.items() if name == "fukuhara"}
    pairs = [(tetrahedra(n), step_s, "as the file says", grid[n, step_s, "swept"][0], row) for (n, step_s), row in nodes.items()]
    pairs += [(tetrahedra(3), 0.001, f"{speed} m/s", rows["swept"], rows["fukuhara"]) for speed, rows in found["speeds"].items()]
    for size, step_s, speed, *both in pairs:
        cells = [f"{apart(*both, name):+.2f} %" if name in both[1] else "-" for name in ("held1_N", "held2_N", "peak_N")]
        lines.append("| " + " | ".join([size, f"{1000 * step_s:g} ms", speed, *cells]) + " |\n")
    return "".join(lines)


def fast_table(fast):
    lines = [heading(["status"], ["fastest tool", "over the P-wave speed", "inverted at most", "at the end", "substeps at most", "balance"])]
    for row in fast.values():
        cells = [row["status"], f"{row['tool_m_s']:.2f} m/s", f"{row['tool_m_s'] / WAVE_M_S:.2f}", row["inverted"], row["left"], row["substeps"]]
        lines.append("| " + " | ".join(map(str, [*cells, f"{row['balance_percent']:.2g} %"])) + " |\n")
    return "".join(lines)


def material_table(found):
    names = ["E [Pa]", "nu", "reaction, first hold [N]", "over E [mm2]", "substeps at most", "inverted", "balance"]
    lines = [heading(["status"], names)]
    rows = [(modulus, 0.4, row) for modulus, row in found["moduli"].items()] + [(1e4, ratio, row) for ratio, row in found["ratios"].items()]
    for modulus, ratio, row in rows:
        held_N = row.get("held1_N", math.nan)
        cells = [row["status"], f"{modulus:g}", f"{ratio:g}", f"{held_N:.4g}", f"{1e6 * held_N / modulus:.2f}"]
        lines.append("| " + " | ".join([*cells, str(row["substeps"]), str(row["inverted"]), f"{row['balance_percent']:.2g} %"]) + " |\n")
    return "".join(lines)


def draw(path, found):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.2))
    for pipeline, colour in COLOURS.items():
        for subdivisions, marker, line in ((2, "s", ":"), (3, "o", "--"), (4, "^", "-")):
            rows = of_step(found["grid"], subdivisions, pipeline)
            label = f"{pipeline}, {tetrahedra(subdivisions)}"
            values = [row["held1_N"] for row, _ in rows.values()]
            left.plot([1000 * step_s for step_s in rows], values, line, marker=marker, color=colour, markersize=4, linewidth=1, label=label)
    left.set_xscale("log")
    left.set_xticks([1000 * step_s for step_s in STEPS_S], [f"{1000 * step_s:g}" for step_s in STEPS_S])
    left.minorticks_off()
    forces_N = [row["held1_N"] for row, _ in found["grid"].values()]
    left.set_ylim(0.85 * min(forces_N), 1.03 * max(forces_N))  # the legend lies below
    left.set_xlabel("step [ms]")
    left.set_ylabel("reaction in the first hold [N]")
    left.legend(frameon=False, fontsize=7, ncol=3, loc="lower center")
    fast = found["fast"].values()
    right.plot([row["tool_m_s"] / WAVE_M_S for row in fast], [row["inverted"] for row in fast], "o-", color="#CC79A7", markersize=4, label="at most")
    right.plot([row["tool_m_s"] / WAVE_M_S for row in fast], [row["left"] for row in fast], "o--", color="#56B4E9", markersize=4, label="at the end")
    right.axvline(0.5, color="black", linewidth=0.8, linestyle=":")
    right.set_xlabel("speed of the tool over that of P-waves")
    right.set_ylabel(f"inverted elements of {tetrahedra(3)}")
    right.legend(frameon=False, fontsize=8)
    for axis in (left, right):
        axis.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def write_rows(path, grid):
    rows = [{"tetrahedra": 8 ** (n + 1), "step_ms": 1000 * step_s, "pipeline": name, **row} for (n, step_s, name), (row, _) in grid.items()]
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n", restval="")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})


def repeats(same):
    sets = [name for name in INSTRUCTIONS if same[name]["swept"]]
    others = [name for name in INSTRUCTIONS if name not in sets]
    different = [f"{name} ({pipeline})" for name in ["second", *sets] for pipeline in PIPELINES if same[name][pipeline] != same["first"][pipeline]]
    text = f"have the same final state, bit by bit, as a first run, under all of {', '.join(PIPELINES)}"
    if different:
        text = f"differ from a first run: {', '.join(different)}"
    missing = f" (the machine of these numbers has no {', '.join(others)})" if others else ""
    return f"A second run and runs with FISSURE_INSTRUCTIONS set to {', '.join(sets)}{missing} {text}."


def write(found):
    grid = found["grid"]
    write_rows(FOLDER / "convergence.csv", grid)
    draw(FOLDER / "elastic.png", found)
    worst = {}
    for name in PIPELINES:
        worst[name] = 0
        for n in (2, 3):
            rows = of_step(grid, n, name)
            finest = rows[min(rows)][0]
            short = [row for step_s, (row, _) in rows.items() if step_s <= 0.001]
            worst[name] = max([worst[name]] + [abs(row[key] / finest[key] - 1) for row in short for key in ("held1_N", "held2_N")])
    held_N = [grid[n, 0.001, "swept"][0]["held1_N"] for n in found["held"]]
    text = PAGE.format(
        meshes=mesh_table(found),
        mesh_spread=f"{100 * np.ptp(held_N) / min(held_N):.1f}",
        forces=convergence_table(grid, FORCES, PIPELINES),
        others=convergence_table(grid, OTHERS, PIPELINES),
        steps="; ".join(f"`{name}` {100 * value:.2f} %" for name, value in worst.items()),
        nodes=node_table(found),
        fast=fast_table(found["fast"]),
        wave=f"{WAVE_M_S:.2f}",
        calm=f"{max(row['tool_m_s'] for row in found['fast'].values() if not row['inverted']) / WAVE_M_S:.2f}",
        materials=material_table(found),
        repeats=repeats(found["hashes"]),
    )
    (FOLDER / "README.md").write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    write(measured(arguments))
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}, convergence.csv, elastic.png")


if __name__ == "__main__":
    main()
