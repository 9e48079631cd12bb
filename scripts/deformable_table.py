#!/usr/bin/env python3
"""Bullet's own world of tetrahedra beside fukuhara and swept on configs/elastic_press.yaml: contacts of nodes and faces, stock and tuned, at
five speeds and three steps; writes results/deformable.

    /usr/bin/python3 scripts/deformable_table.py [-j N]

Writes README.md, deformable.csv and deformable.png; --redraw: the page and the picture from the numbers in deformable.csv.
"""
import argparse
import concurrent.futures
import csv
import math
import pathlib
import tempfile

import h5py
import matplotlib
import numpy as np
import yaml

from references import ROOT, fissure

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = ROOT / "results/deformable"
SCENARIO = ROOT / "configs/elastic_press.yaml"
SPEEDS_M_S = [0.02, 0.1, 0.5, 2, 10]
STEPS_S = {"1 ms": 0.001, "1/240 s": 1 / 240, "1/60 s": 1 / 60}
HOLD_S = 0.1
SUBDIVISIONS = {512: 2, 4096: 3}  # by tetrahedra; the finer mesh is the scene's own, at one speed: it takes minutes a run
FINE, FINE_M_S = 4096, 0.1
RADIUS_M = 0.03  # of the ball: a blade that deep is in no tissue
HOLDS_MM = 0.5
SETTLED = 0.3  # share of the hold that is left out of its mean
OURS = {"swept": {"pipeline": "swept"}, "fukuhara": {"pipeline": "fukuhara"}}
BULLETS = {
    f"{contacts}_{settings}": {"pipeline": "deformable", "contacts": contacts, "settings": settings}
    for contacts in ("nodes", "faces")
    for settings in ("stock", "tuned")
}
MATERIALS = {
    "neo_hookean": {**OURS, **BULLETS},
    "linear_corotated": {name: entry for name, entry in {**OURS, **BULLETS}.items() if not name.endswith("tuned")},
}
COLOURS = {"swept": "#0072B2", "fukuhara": "#D55E00", "nodes_stock": "#CC79A7", "nodes_tuned": "#E69F00", "faces_stock": "#56B4E9",
           "faces_tuned": "#009E73"}
HEADS = ["tetrahedra", "material", "step", "tool [m/s]", "run", "worst depth [mm]", "steps not proved", "held [N]", "its spread [N]", "lost of the work",
         "inverted", "substeps", "step [ms]", "over swept"]

PAGE = """# Bullet's world of tetrahedra as a baseline

    /usr/bin/python3 scripts/deformable_table.py

[elastic_press](../../configs/elastic_press.yaml) with its blade 8.1 mm into the ball at a constant speed, then {hold} s of hold: the same
tetrahedra in Bullet's btDeformableMultiBodyDynamicsWorld with Bullet's own contact (pipeline `deformable`), and in the explicit engine with
`fukuhara` and `swept`. `nodes` tests tissue vertices in the blade's signed distance field, `faces` tissue triangles by GJK. Stock is what Bullet's
examples of the material have, tuned the best that was found (the fields of [pipeline `deformable`](../../src/simulation/engine/METHOD.md#5-the-deformable-world)).
The ball has 512 tetrahedra, whose reaction is within 1 % of finer ones', and the scene's own 4,096 at {fine} m/s. All numbers are in
[deformable.csv](deformable.csv).

![Worst depth over the speed, and held reaction](deformable.png)

{summary}
## What fails

Deeper than {holds} mm, or the tissue lost (it left all bounds, or the blade stands deeper than the ball's radius):

{failures}
## All runs

What the columns say: **worst depth** of the blade's samples in the tissue; **steps not proved** free of overlap (`measure: {{certify: true}}`), of all;
**held**, mean reaction over the last {share:.0f} % of the hold, and its standard deviation; **lost of the work**, what of the contacts' work is at
the end neither stored nor kinetic, viscosity's share too: negative where energy came from nowhere; **inverted** elements at most; **substeps** at
most; **step**, median wall time, and over that of `swept` in the same run. A reaction in *italics* is of a run that ended early or lost the tissue.
The press at 0.49 m/s and more takes a single step of 1/60 s, at 1.9 m/s and more of 1/240 s and at 8.1 m/s and more of 1 ms: substeps go the
blade's way in parts.

{table}"""


def entry_text(entries):
    return [{"name": name, **entry} for name, entry in entries.items()]


def scenario_of(tetrahedra, material, speed_m_s, step_s):
    scenario = yaml.safe_load(SCENARIO.read_text())
    scenario["time"]["step_s"] = step_s
    scenario["bodies"][0]["shape"]["subdivisions"] = SUBDIVISIONS[tetrahedra]
    scenario["bodies"][0]["elastic"]["material"] = material
    press, hold = scenario["tools"][0]["motion"]["segments"][:2]
    press |= {"speed_m_s": speed_m_s, "timing": "constant"}
    hold["hold_s"] = HOLD_S
    scenario["tools"][0]["motion"]["segments"] = [press, hold]
    scenario["pipelines"] = entry_text(MATERIALS[material])
    scenario["record"] = {}
    scenario.pop("expect")
    return scenario


def row_of(run):
    """The numbers of one run."""
    summary, status = run["summary"].attrs, run.attrs["status"]
    position_m = run["tool_position"][:, 0]
    still = np.linalg.norm(np.diff(position_m, axis=0), axis=1) < 1e-12
    first = int(np.flatnonzero(still)[0]) + 1 if still.any() else len(position_m) - 1
    held_N = run["reaction_force"][first + round(SETTLED * (len(position_m) - first)):, 1]
    work_J, left_J = run["contact_work"][-1], run["stored_energy"][-1] + run["kinetic_energy"][-1]
    return {
        "status": status,
        "depth_mm": 1000 * summary["max_penetration_depth_m"],
        "not_proved": int(summary["uncertified_steps"]),
        "steps": len(position_m) - 1,
        "held_N": float(held_N.mean()),
        "spread_N": float(held_N.std()),
        "lost": 1 - left_J / work_J if work_J > 0 else math.nan,
        "inverted": int(summary["max_inverted_elements"]),
        "substeps": int(summary["max_substeps"]),
        "step_ms": float(np.nanmedian(run["timing/step_time_us"][1:])) / 1000,
    }


def pressed(arguments, tetrahedra, material, step, speed_m_s):
    """Rows by run of one mesh, material, step and speed: all runs one after another in one call of the program."""
    with tempfile.TemporaryDirectory() as folder:
        file, result = pathlib.Path(folder) / "press.yaml", pathlib.Path(folder) / "press.h5"
        file.write_text(yaml.safe_dump(scenario_of(tetrahedra, material, speed_m_s, STEPS_S[step]), sort_keys=False))
        fissure(arguments, "run", file, "-o", result, "--no-frames", "-j", 1, accept=(0, 3))
        with h5py.File(result) as opened:
            rows = {name: row_of(opened[f"pipelines/{name}"]) for name in MATERIALS[material]}
    for name, row in rows.items():
        row["over_swept"] = row["step_ms"] / rows["swept"]["step_ms"]
        print(tetrahedra, material, step, speed_m_s, name, row, flush=True)
    return rows


def measured(arguments):
    cases = [(FINE, material, step, FINE_M_S) for material in MATERIALS for step in STEPS_S]  # the longest first
    cases += [(512, material, step, speed) for material in MATERIALS for step in STEPS_S for speed in SPEEDS_M_S]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {case: pool.submit(pressed, arguments, *case) for case in cases}
        found = {(*case, name): row for case, run in runs.items() for name, row in run.result().items()}
    return dict(sorted(found.items(), key=lambda item: item[0][0]))  # the coarse mesh first


def stored():
    """The rows of deformable.csv."""
    number = {"status": str, **dict.fromkeys(("not_proved", "steps", "inverted", "substeps"), int)}
    found = {}
    with open(FOLDER / "deformable.csv", newline="") as file:
        for row in csv.DictReader(file):
            case = (int(row.pop("tetrahedra")), row.pop("material"), row.pop("step"), float(row.pop("tool_m_s")), row.pop("run"))
            found[case] = {key: number.get(key, float)(value) for key, value in row.items()}
    return found


def is_lost(row):
    """Whether the run ended early, or its tissue has left all bounds."""
    return row["status"] != "ok" or not row["spread_N"] < 1e3 or not row["depth_mm"] < 1000 * RADIUS_M


def cells_of(case, row):
    held = f"{row['held_N']:.3f}" if abs(row["held_N"]) < 1e4 else f"{row['held_N']:.1e}"
    spread = f"{row['spread_N']:.3f}" if row["spread_N"] < 1e4 else f"{row['spread_N']:.1e}"
    lost = f"{100 * row['lost']:.0f} %" if abs(row["lost"]) < 100 else "-"
    return [f"{case[0]:,}", case[1], case[2], f"{case[3]:g}", f"`{case[4]}`", f"{row['depth_mm']:.2f}", f"{row['not_proved']} of {row['steps']}",
            f"*{held}*" if is_lost(row) else held, spread, lost, str(row["inverted"]), str(row["substeps"]), f"{row['step_ms']:.3g}",
            f"{row['over_swept']:.1f}"]


def table(found):
    lines = ["| " + " | ".join(HEADS) + " |\n", "|--:|---|---|--:|---|" + "--:|" * (len(HEADS) - 5) + "\n"]
    return "".join(lines + ["| " + " | ".join(cells_of(case, row)) + " |\n" for case, row in found.items()])


def summary(found):
    """One line a run and material."""
    lines = [f"| material | run | cases | held ({HOLDS_MM} mm) | every step proved | deepest [mm] | held force beside swept's, up to 0.1 m/s | step over swept's |\n",
             "|---|---|--:|--:|--:|--:|--:|--:|\n"]
    for material, entries in MATERIALS.items():
        for name in entries:
            rows = {case: row for case, row in found.items() if case[1] == material and case[4] == name}
            sound = [row for row in rows.values() if not is_lost(row)]
            slow = [(found[case]["held_N"] / found[(*case[:4], "swept")]["held_N"] - 1) for case in rows if case[3] <= FINE_M_S and
                    not is_lost(found[case])]
            deviation = f"{100 * min(slow):+.1f} to {100 * max(slow):+.1f} %" if slow else "-"
            ratios = [row["over_swept"] for row in rows.values()]
            held = sum(row["depth_mm"] <= HOLDS_MM for row in sound)
            proved = sum(row["not_proved"] == 0 for row in sound)
            deepest = max(row["depth_mm"] for row in rows.values())
            lines.append(f"| {material} | `{name}` | {len(rows)} | {held} | {proved} | {deepest:.2f} | {deviation} | "
                         f"{min(ratios):.1f} to {max(ratios):.1f} |\n")
    return "".join(lines)


def failures(found):
    """Where each of Bullet's runs does not hold, a line each."""
    lines = []
    for material, entries in MATERIALS.items():
        for name in entries:
            if name in OURS:
                continue
            steps = []
            for step in STEPS_S:
                rows = {case: row for case, row in found.items() if case[1:3] == (material, step) and case[4] == name}
                bad = {case: row for case, row in rows.items() if is_lost(row) or row["depth_mm"] > HOLDS_MM}
                if not bad:
                    continue
                lost = sum(is_lost(row) for row in bad.values())
                where = "everywhere" if len(bad) == len(rows) else "at " + ", ".join(sorted({f"{case[3]:g}" for case in bad}, key=float)) + " m/s"
                depths = [row["depth_mm"] for row in bad.values() if not is_lost(row)]
                text = f"{step} {where}" + (f" ({min(depths):.2f} to {max(depths):.2f} mm)" if depths else "")
                steps.append(text + (f", {lost} of {len(rows)} with the tissue lost" if lost else ""))
            lines.append(f"* {material}, `{name}`: " + ("; ".join(steps) if steps else "nowhere") + ".\n")
    return "".join(lines)


def draw(path, found):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.2))
    for name, colour in COLOURS.items():
        for step, marker, line in zip(STEPS_S, "os^", ("-", "--", ":")):
            rows = [found[512, "neo_hookean", step, speed, name] for speed in SPEEDS_M_S]
            label = f"{name}, {step}"
            left.plot(SPEEDS_M_S, [row["depth_mm"] for row in rows], line, marker=marker, color=colour, markersize=4, linewidth=1, label=label)
            right.plot(SPEEDS_M_S, [math.nan if is_lost(row) else row["held_N"] for row in rows], line, marker=marker, color=colour, markersize=4,
                       linewidth=1)
    for axis in (left, right):
        axis.set_xscale("log")
        axis.set_xlabel("speed of the blade [m/s]")
        axis.grid(alpha=0.3)
    left.set_yscale("symlog", linthresh=0.1)
    left.set_ylim(bottom=0)
    left.set_ylabel("worst depth [mm]")
    right.set_ylabel("held reaction [N]")
    right.set_ylim(0, 2.5)
    figure.legend(*left.get_legend_handles_labels(), frameon=False, fontsize=7, ncol=6, loc="lower center")
    figure.tight_layout(rect=(0, 0.14, 1, 1))
    figure.savefig(path, dpi=90)
    plt.close(figure)


def write(found):
    with open(FOLDER / "deformable.csv", "w", newline="") as file:
        rows = [{"tetrahedra": case[0], "material": case[1], "step": case[2], "tool_m_s": case[3], "run": case[4], **row} for case, row in found.items()]
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})
    draw(FOLDER / "deformable.png", found)
    text = PAGE.format(hold=HOLD_S, fine=FINE_M_S, share=100 * (1 - SETTLED), holds=HOLDS_MM, summary=summary(found), failures=failures(found), table=table(found))
    (FOLDER / "README.md").write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--redraw", action="store_true", help="page and picture from deformable.csv, measure nothing")
    arguments = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    write(stored() if arguments.redraw else measured(arguments))
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}, deformable.csv, deformable.png")


if __name__ == "__main__":
    main()
