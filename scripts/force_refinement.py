#!/usr/bin/env python3
"""What the total force becomes as the tissue's mesh is refined, for the paper's law and those beyond it.

    /usr/bin/python3 scripts/force_refinement.py

Presses the spatula of configs/spatula_press.yaml to one depth into spheres of 128 to 8,192 triangles, with the tool's nodes
as dense against the tissue's edges on every mesh, and compares the force held at the end. The coefficients of the laws per
area are the paper's over the mean triangle of the coarsest mesh, so that both begin at about the same force. Beside it, from a test,
the laws alone on a prescribed deformation. Writes results/force_refinement/README.md (tables), refinement.{csv,png} and
prescribed.{csv,png}.
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
K, LAMBDA, N = 200, 50, 1.3
SPHERE_M2 = 4 * math.pi * 0.03**2
AREA_M2 = SPHERE_M2 / 128
LAWS = {
    "paper": {"k": K, "lambda": LAMBDA},
    "per_area": {"k": K / AREA_M2, "lambda": LAMBDA / AREA_M2, "per_area": True},
    "corotated": {"k": K, "lambda": LAMBDA, "deformation": "corotated"},
    "corotated_per_area": {"k": K / AREA_M2, "lambda": LAMBDA / AREA_M2, "deformation": "corotated", "per_area": True},
}
COLOURS = {"paper": "#D55E00", "per_area": "#0072B2", "corotated": "#E69F00", "corotated_per_area": "#009E73"}
TEST = "PerArea.ConvergesToTheSurfaceIntegralWhileThePapersSumGrows"
HELD_S = 0.1  # of the hold at the end, averaged


def run(subdivisions):
    nodes = 8 * 2 ** (subdivisions - 2)
    laws = [{"name": name, "model": "hunt_crossley", "n": N} | law for name, law in LAWS.items()]
    settings = {
        "bodies.sphere.shape.subdivisions": subdivisions,
        "tools.spatula.nodes.resolution": f"[{nodes}, {nodes}]",
        "force": json.dumps(laws),
        "record.snapshots_every_s": 1,
    }
    with tempfile.TemporaryDirectory() as folder:
        command = [ROOT / "build/release/fissure", "run", ROOT / "configs/spatula_press.yaml", "-o", f"{folder}/result.h5"]
        command += ["--no-frames", "--no-expect", "--pipeline", "fukuhara"]
        for path, value in settings.items():
            command += ["--set", f"{path}={value}"]
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        with h5py.File(f"{folder}/result.h5") as file:
            return held(file["pipelines/fukuhara"], subdivisions, nodes)


def held(data, subdivisions, nodes):
    """One row: means over the end of the hold."""
    time = data["time"][:]
    end = time > time[-1] - HELD_S
    row = {"triangles": 8 * 4**subdivisions, "nodes": f"{nodes} x {nodes}"}
    row["worst_depth_mm"] = 1000 * data["penetration_depth"][:].max()
    row["colliding_triangles"] = data["colliding_triangles"][:][end].mean()
    row["colliding_area_cm2"] = 1e4 * SPHERE_M2 * row["colliding_triangles"] / row["triangles"]
    for index, law in enumerate(LAWS):
        row[f"{law}_N"] = np.linalg.norm(data["force"][index][end].mean(axis=0))
    for law in ("paper", "corotated"):
        row[f"{law}_mean_deformation_mm"] = 1000 * data["deformation_mean"][list(LAWS).index(law)][end].mean()
    if not all(np.isfinite(value) for value in row.values() if not isinstance(value, str)):
        raise SystemExit(f"{row['triangles']} triangles: not finite: {row}")
    return row


def table(rows):
    lines = ["| triangles | nodes a face | colliding | their area | mean deformation, paper | corotated | " + " | ".join(LAWS) + " |"]
    lines += ["|---|---|---|---|---|---|" + "---|" * len(LAWS)]
    last = None
    for row in rows:
        cells = [str(row["triangles"]), row["nodes"], f"{row['colliding_triangles']:.0f}"]
        cells += [f"{row['colliding_area_cm2']:.1f} cm2"]
        cells += [f"{row['paper_mean_deformation_mm']:.2f} mm", f"{row['corotated_mean_deformation_mm']:.2f} mm"]
        for law in LAWS:
            force = row[f"{law}_N"]
            factor = "" if last is None else f" (x {force / last[f'{law}_N']:.2f})"
            cells.append(f"{force:.2f} N{factor}")
        lines.append("| " + " | ".join(cells) + " |")
        last = row
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


def save(path, figure, axis, rows, force):
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
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def draw_prescribed(path, rows):
    figure, axis = plt.subplots(figsize=(6.4, 4.2))
    triangles = [row["triangles"] for row in rows]
    axis.plot(triangles, [row["paper_N"] for row in rows], "-", marker="o", color=COLOURS["paper"], label="paper")
    axis.plot(triangles, [row["per_area_N"] for row in rows], "-", marker="o", color=COLOURS["per_area"], label="per_area")
    axis.axhline(rows[0]["exact_N"], color="black", linewidth=0.8, linestyle=":", label="surface integral of the law")
    save(path, figure, axis, rows, "force on a prescribed deformation")


def write(folder, rows, prescribed):
    with open(folder / "refinement.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: value if isinstance(value, str) else f"{value:.6g}" for key, value in row.items()})
    coefficients = f"k {K} N/m^{N:g} and lambda {LAMBDA} N s/m^{N + 1:g}"
    per_area = f"k {LAWS['per_area']['k']:.3g} N/m^{N + 2:g} and lambda {LAWS['per_area']['lambda']:.3g} N s/m^{N + 3:g}"
    text = f"""# Force under refinement of the tissue's mesh

`{COMMAND}`

`configs/spatula_press.yaml`, pipeline `fukuhara`: the spatula held 25 mm deep, the tool's nodes refined with the tissue.
Hunt-Crossley with n {N}: `paper` and `corotated` with {coefficients} a triangle, the laws
per area with {per_area}. Magnitude of the mean force over the last {HELD_S} s;
in brackets: over that of the row above.

{table(rows)}

![Held force over the number of triangles](refinement.png)

The paper's sum grows with the mesh, corotated or not. The sum per area does not: per_area falls by
differences that become smaller, corotated_per_area unevenly. The reason is which triangles count: all with at least one vertex in contact, so that the area that counts is the blade's
face (6 cm2) and a strip around it about two edges wide, which each refinement halves: an error of first order in the edge length.

These are runs of the whole simulation: with the mesh the tissue changes too, a shell of springs of one stiffness whatever their
length, and with it how far it is displaced (the two columns of deformation). A limit of the whole is therefore not shown here.

## The laws alone

The same sphere with its top pushed in by a prescribed map (tests/simulation/contact/per_area_test.cpp), which a mesh can only follow better: the sum
per area converges to the surface integral of the law, with second order; the paper's sum grows with the number of triangles. (With
first order where tissue moves beyond the edge of contact too.)

{prescribed_table(prescribed)}

![Force on prescribed deformation over the number of triangles](prescribed.png)
"""
    (folder / "README.md").write_text(text)


def draw(path, rows):
    figure, axis = plt.subplots(figsize=(6.4, 4.2))
    triangles = [row["triangles"] for row in rows]
    for law in LAWS:
        style = "--" if law.startswith("corotated") else "-"
        axis.plot(triangles, [row[f"{law}_N"] for row in rows], style, marker="o", color=COLOURS[law], label=law)
    start = rows[0]["paper_N"]
    axis.plot(triangles, [start * n / triangles[0] for n in triangles], ":", color="grey", label="number of triangles")
    save(path, figure, axis, rows, "held force")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--subdivisions", type=int, nargs="+", default=[2, 3, 4, 5])
    arguments = parser.parse_args()
    folder = ROOT / "results/force_refinement"
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for subdivisions in arguments.subdivisions:
        rows.append(run(subdivisions))
        print(f"{rows[-1]['triangles']} triangles: done", flush=True)
    prescribed = prescribed_rows(folder)
    write(folder, rows, prescribed)
    draw(folder / "refinement.png", rows)
    draw_prescribed(folder / "prescribed.png", prescribed)
    print("written: results/force_refinement/README.md, refinement.{csv,png}, prescribed.{csv,png}")


if __name__ == "__main__":
    main()
