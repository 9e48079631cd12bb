#!/usr/bin/env python3
"""What each total force becomes as the tissue's mesh is refined: four laws, four ways to sum them, the reaction and the pressure.

    /usr/bin/python3 scripts/force_refinement.py

Presses a blade to one depth into balls of 128 to 8,192 triangles, on a shell of springs (configs/spatula_press.yaml) and on elastic
tissue (configs/studies/scenes/tradeoff_ball.yaml), with the tool's nodes as dense against the tissue's edges on every mesh, and compares
the forces held at the end. The coefficients of the laws per area are the others' over the mean triangle of the coarsest mesh, so that both
begin at about the same force. Beside it, from a test, the laws alone on a prescribed deformation. Writes results/force_refinement/README.md
(tables), shell.csv, elastic.csv, refinement.png and prescribed.{csv,png}.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = "/usr/bin/python3 scripts/force_refinement.py"
SPHERE_M2 = 4 * math.pi * 0.03**2
AREA_M2 = SPHERE_M2 / 128
# Coefficients per triangle, which give about half a newton each at 10 mm; rates are zero where forces are held.
MODELS = {
    "hunt_crossley": {"k": 200, "lambda": 50, "n": 1.3},
    "linear_elastic": {"k": 50},
    "kelvin_voigt": {"k": 50, "c": 0.1},
    "exponential": {"k": 0.3, "a": 100, "c": 0.1},
}
WAYS = {
    "paper": {},
    "per_area": {"per_area": True},
    "corotated": {"deformation": "corotated"},
    "corotated_per_area": {"deformation": "corotated", "per_area": True},
}
COLOURS = {"paper": "#D55E00", "per_area": "#0072B2", "corotated": "#E69F00", "corotated_per_area": "#009E73", "reaction": "black"}
TEST = "PerArea.ConvergesToTheSurfaceIntegralWhileThePapersSumGrows"
HELD_S = 0.1  # of the hold at the end, averaged
SLOW = 0.3    # farther than this share from its limit nothing is said of it


def of_law(model, way):
    per_area = {name: value / AREA_M2 if name in ("k", "lambda", "c") else value for name, value in MODELS[model].items()}
    coefficients = per_area if "per_area" in way else MODELS[model]
    return {"name": f"{model}_{way}", "model": model} | coefficients | WAYS[way]


LAWS = [of_law(model, way) for model in MODELS for way in WAYS]
SHELL = {"scene": "configs/spatula_press.yaml", "body": "sphere", "tool": "spatula", "pipeline": "fukuhara", "settings": {}}
ELASTIC = {"scene": "configs/studies/scenes/tradeoff_ball.yaml", "body": "ball", "tool": "blade", "pipeline": "swept",
           "settings": {"tools.blade.motion.segments.1.hold_s": 0.3}}


def run(tissue, subdivisions):
    nodes = 8 * 2 ** (subdivisions - 2)
    settings = {
        f"bodies.{tissue['body']}.shape.subdivisions": subdivisions,
        f"tools.{tissue['tool']}.nodes.resolution": f"[{nodes}, {nodes}]",
        "force": json.dumps(LAWS),
        "record.snapshots_every_s": 10,
    } | tissue["settings"]
    with tempfile.TemporaryDirectory() as folder:
        command = [ROOT / "build/release/fissure", "run", ROOT / tissue["scene"], "-o", f"{folder}/result.h5"]
        command += ["--no-frames", "--no-expect", "--pipeline", tissue["pipeline"]]
        for path, value in settings.items():
            command += ["--set", f"{path}={value}"]
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        with h5py.File(f"{folder}/result.h5") as file:
            return held(file["pipelines"][tissue["pipeline"]], subdivisions)


def held(data, subdivisions):
    """One row: means over the end of the hold."""
    time = data["time"][:]
    end = time > time[-1] - HELD_S
    row = {"triangles": 8 * 4**subdivisions}
    row["worst_depth_mm"] = 1000 * data["penetration_depth"][:].max()
    row["colliding_triangles"] = data["colliding_triangles"][:][end].mean()
    row["colliding_area_cm2"] = 1e4 * SPHERE_M2 * row["colliding_triangles"] / row["triangles"]
    for way in ("paper", "corotated"):
        index = [law["name"] for law in LAWS].index(f"hunt_crossley_{way}")
        row[f"{way}_mean_deformation_mm"] = 1000 * data["deformation_mean"][index][end].mean()
    for index, law in enumerate(LAWS):
        row[f"{law['name']}_N"] = np.linalg.norm(data["force"][index][end].mean(axis=0))
    row["reaction_N"] = np.linalg.norm(data["reaction_force"][:][end].mean(axis=0))
    if "max_pressure" in data:
        row["max_pressure_kPa"] = 1e-3 * data["max_pressure"][:][end].mean()
    if not all(np.isfinite(value) for value in row.values()):
        raise SystemExit(f"{row['triangles']} triangles: not finite: {row}")
    return row


def convergence(values):
    """What the last three of a series under halving of the edges say: the verdict or order, the limit, and the finest mesh's distance to it."""
    before, last = values[-2] - values[-3], values[-1] - values[-2]
    spread = f"{100 * (max(values[-3:]) / min(values[-3:]) - 1):.1f} % spread" if min(values[-3:]) > 0 else ""
    if last == before == 0:
        return "the same", f"{values[-1]:.4g}", "0 %"
    if last * before <= 0:
        return "up and down", "", spread
    if abs(last) >= abs(before):
        return ("grows" if last > 0 else "falls on"), "", spread
    order = math.log2(before / last)
    limit = values[-1] + last / (2**min(order, 2) - 1)  # more than linear elements and lumped forces can have is no order
    if abs(values[-1] - limit) > SLOW * abs(values[-1]):
        return f"{order:.2f}: slow", "", spread
    return f"{order:.2f}", f"{limit:.4g}", f"{100 * abs(values[-1] / limit - 1):.1f} %"


def table(rows):
    """A row for each total: its value on each mesh, and what the last three say."""
    lines = ["| total | " + " | ".join(f"{row['triangles']:,}" for row in rows) + " | order | limit | from it |"]
    lines += ["|---|" + "---|" * (len(rows) + 3)]
    totals = [(f"{law['name']}_N", f"`{law['model']}`, {law['name'][len(law['model']) + 1:].replace('_', ' ')}") for law in LAWS]
    totals += [("reaction_N", "reaction")] + [("max_pressure_kPa", "largest pressure, kPa")] * ("max_pressure_kPa" in rows[0])
    for key, title in totals:
        values = [row[key] for row in rows]
        lines.append(f"| {title} | " + " | ".join(f"{value:.4g}" for value in values) + " | " + " | ".join(convergence(values)) + " |")
    return "\n".join(lines)


def contact_table(rows):
    lines = ["| triangles | worst depth | colliding | their area | mean deformation, paper | corotated |", "|---|---|---|---|---|---|"]
    for row in rows:
        cells = [f"{row['triangles']:,}", f"{row['worst_depth_mm']:.3f} mm", f"{row['colliding_triangles']:.0f}"]
        cells += [f"{row['colliding_area_cm2']:.1f} cm2", f"{row['paper_mean_deformation_mm']:.2f} mm"]
        lines.append("| " + " | ".join(cells + [f"{row['corotated_mean_deformation_mm']:.2f} mm"]) + " |")
    return "\n".join(lines)


def prescribed_rows(folder):
    """The laws alone: the test of their convergence keeps its table."""
    subprocess.run([ROOT / "scripts/build", "release", "test_contact"], stdout=subprocess.DEVNULL, check=True)
    command = [ROOT / "build/release/tests/test_contact", f"--gtest_filter={TEST}"]
    environment = os.environ | {"FISSURE_PER_AREA_TABLE": str(folder / "prescribed.csv")}
    subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, check=True)
    with open(folder / "prescribed.csv", newline="") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def prescribed_table(rows):
    lines = ["| triangles | per_area | its error | paper |", "|---|---|---|---|"]
    for row in rows:
        error = 100 * (row["per_area_N"] / row["exact_N"] - 1)
        lines.append(f"| {row['triangles']:.0f} | {row['per_area_N']:.4f} N | {error:.2f} % | {row['paper_N']:.1f} N |")
    return "\n".join(lines)


def scale(axis, rows, force):
    """Axes of a force over the number of triangles, once the curves are drawn."""
    triangles = [row["triangles"] for row in rows]
    axis.set_xscale("log", base=2)
    axis.set_yscale("log")
    axis.set_xticks(triangles, [f"{n:,.0f}" for n in triangles])
    axis.minorticks_off()
    axis.set_xlabel("triangles of the sphere")
    axis.set_ylabel(f"{force} [N]")
    axis.grid(alpha=0.3)
    axis.legend(frameon=False, fontsize=8)


def draw_prescribed(path, rows):
    figure, axis = plt.subplots(figsize=(6.4, 4.2))
    triangles = [row["triangles"] for row in rows]
    axis.plot(triangles, [row["paper_N"] for row in rows], "-", marker="o", color=COLOURS["paper"], label="paper")
    axis.plot(triangles, [row["per_area_N"] for row in rows], "-", marker="o", color=COLOURS["per_area"], label="per_area")
    axis.axhline(rows[0]["exact_N"], color="black", linewidth=0.8, linestyle=":", label="surface integral of the law")
    scale(axis, rows, "force on a prescribed deformation")
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def save_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" for key, value in row.items()})


def read_rows(path):
    with open(path, newline="") as file:
        return [{key: int(value) if key == "triangles" else float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def write(folder, shell, elastic, prescribed):
    text = f"""# Force under refinement of the tissue's mesh

`{COMMAND}`

A blade held in a ball of 30 mm, on meshes whose edges are halved from column to column; the tool's nodes are refined with the tissue.
Magnitude of the mean force over the last {HELD_S} s, in newtons. Coefficients per triangle: {coefficient_text()}; those per area are these over
the mean triangle of 128. "Order" is that of the last three meshes (2 where an error falls as the square of the edge), "limit" what they
extrapolate to with it, or with 2 where it is more, "from it" the error of the finest mesh by that. Where they go up and down, go on with the same differences, or where the
finest is still more than {100 * SLOW:.0f} % from the limit, there is no limit to speak of, and the spread of the three stands there.

## A shell of springs

`{SHELL['scene']}`, pipeline `{SHELL['pipeline']}`, held 25 mm deep.

{table(shell)}

{contact_table(shell)}

## Elastic tissue

`{ELASTIC['scene']}`, pipeline `{ELASTIC['pipeline']}`, held 6 mm deep in tissue of 10 kPa.

{table(elastic)}

{contact_table(elastic)}

![Held forces of Hunt and Crossley's law and the reaction over the number of triangles](refinement.png)

* A sum over triangles grows with their number, on both tissues, with every law and with `corotated`: it is no force of the tissue.
* Per area it falls to a limit on the shell, with nearly second order for the paper's deformation; for the corotated one the meshes are still far
  apart. On elastic tissue it still falls at 8,192 triangles: which triangles count (all with a vertex in contact) is a strip around the blade two
  edges wide, an error of first order, and here that strip is not small beside the contact.
* Kelvin and Voigt's law is the linear one where forces are held.
* The reaction of a shell has a limit over meshes at one step, but grows as 1/dt^2 with the step. That of elastic tissue is the one total that is the same on all
  meshes, within the spread of its row.
* The largest pressure lies at the blade's edges, where it has no limit.

## The laws alone

The same sphere with its top pushed in by a prescribed map (tests/simulation/contact/per_area_test.cpp), which a mesh can only follow better: the sum
per area converges to the surface integral of the law, with second order; the paper's sum grows with the number of triangles. (With
first order where tissue moves beyond the edge of contact too.)

{prescribed_table(prescribed)}

![Force on prescribed deformation over the number of triangles](prescribed.png)
"""
    (folder / "README.md").write_text(text)


def coefficient_text():
    return "; ".join(f"`{model}` " + ", ".join(f"{name} {value:g}" for name, value in of.items()) for model, of in MODELS.items())


def draw(path, shell, elastic):
    figure, both = plt.subplots(1, 2, figsize=(10, 4.2))
    for axis, rows, title in zip(both, (shell, elastic), ("shell of springs", "elastic tissue")):
        for way in WAYS:
            style = "--" if way.startswith("corotated") else "-"
            axis.plot([row["triangles"] for row in rows], [row[f"hunt_crossley_{way}_N"] for row in rows], style, marker="o",
                      color=COLOURS[way], label=way)
        axis.plot([row["triangles"] for row in rows], [row["reaction_N"] for row in rows], ":", marker="s", color=COLOURS["reaction"],
                  label="reaction")
        axis.set_title(title)
        scale(axis, rows, "held force")
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--subdivisions", type=int, nargs="+", default=[2, 3, 4, 5])
    parser.add_argument("--redraw", action="store_true", help="from the numbers that are there, without runs")
    arguments = parser.parse_args()
    if len(arguments.subdivisions) < 3:
        parser.error("--subdivisions: fewer than three meshes, expected at least three, from which an order follows")
    folder = ROOT / "results/force_refinement"
    folder.mkdir(parents=True, exist_ok=True)
    tables = []
    for name, tissue in (("shell", SHELL), ("elastic", ELASTIC)):
        rows = read_rows(folder / f"{name}.csv") if arguments.redraw else []
        for subdivisions in [] if arguments.redraw else arguments.subdivisions:
            rows.append(run(tissue, subdivisions))
            print(f"{name}, {rows[-1]['triangles']} triangles: done", flush=True)
        save_rows(folder / f"{name}.csv", rows)
        tables.append(rows)
    prescribed = prescribed_rows(folder)
    write(folder, *tables, prescribed)
    draw(folder / "refinement.png", *tables)
    draw_prescribed(folder / "prescribed.png", prescribed)
    print("written: results/force_refinement/README.md, shell.csv, elastic.csv, refinement.png, prescribed.{csv,png}")


if __name__ == "__main__":
    main()
