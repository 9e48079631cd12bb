#!/usr/bin/env python3
"""Where each pipeline starts to fail: the press over tool speed, blade thickness and mesh, in both precisions.

    /usr/bin/python3 scripts/failure_table.py

The scene is configs/spatula_press.yaml at dt = 1 ms with 16 x 16 nodes: the blade's lower face goes from 6 mm above the sphere to
25 mm below its first top. Writes results/failure/README.md (table), table.csv (everything measured) and depth.png.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.colors import BoundaryNorm, ListedColormap

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPEEDS_M_S = [0.1, 1, 10]
THICKNESSES_MM = [0.02, 0.2, 2, 20]
SUBDIVISIONS = {2: 128, 3: 512, 4: 2048}
PIPELINES = {
    "default stock": "pipeline: default, settings: stock",
    "default tuned": "pipeline: default, settings: tuned",
    "cluster": "pipeline: cluster",
    "raycast": "pipeline: raycast",
    "fukuhara": "pipeline: fukuhara",
    "swept": "pipeline: swept",
}
IN_BOTH_PRECISIONS = ["default stock", "default tuned", "fukuhara", "swept"]
QUANTITIES = {
    "max_penetration_depth_m": "depth",
    "passed_through_samples": "passed",
    "max_inverted_triangles": "inverted",
    "max_inversion_aware_depth_m": "depth with inverted tissue",
    "uncertified_steps": "not proved",
    "max_ground_depth_m": "below the ground",
    "force_roughness": "roughness",
    "max_force_N": "force",
}
HOLDS_MM = 0.5  # a depth that the main job allows with 8 x 8 nodes
FAR_MM = 5
HIDDEN_MM = 0.05  # by as much inverted tissue must deepen a depth to be shown


def entries():
    for name, fields in PIPELINES.items():
        for precision in ["f64", "f32"] if name in IN_BOTH_PRECISIONS else ["f64"]:
            yield f"{name} {precision}", f"{{name: {name.replace(' ', '_')}_{precision}, {fields}, precision: {precision}}}"


def scenario(speed_m_s, thickness_mm, subdivisions):
    half_m = thickness_mm / 2000
    runs = "\n".join(f"  - {entry}" for _, entry in entries())
    return f"""base: {ROOT}/configs/spatula_press.yaml
name: failure
tools:
  - name: spatula
    shape: {{type: box, size_m: [0.04, {thickness_mm / 1000}, 0.015]}}
    nodes: {{resolution: [16, 16]}}
    motion:
      type: script
      start_m: [0, {0.066 + half_m!r}, 0]
      segments:
        - {{move_to_m: [0, {0.035 + half_m!r}, 0], speed_m_s: {speed_m_s}, timing: constant}}
        - {{hold_s: 0.1}}
bodies:
  - {{name: sphere, shape: {{type: sphere, radius_m: 0.03, subdivisions: {subdivisions}}}}}
pipelines:
{runs}
record: {{}}
"""


def measure(arguments, speed_m_s, thickness_mm, subdivisions):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "failure.yaml"
        file.write_text(scenario(speed_m_s, thickness_mm, subdivisions))
        command = [arguments.program, "run", file, "-o", f"{folder}/result.h5", "--json", "--no-frames", "--no-expect", "-j", arguments.jobs]
        for _, entry in entries():
            command += ["--pipeline", entry.split(",")[0].removeprefix("{name: ")]
        finished = subprocess.run([*map(str, command)], stdout=subprocess.PIPE, check=False)
        if finished.returncode not in (0, 3):
            raise SystemExit(f"failed ({finished.returncode}): {' '.join(map(str, command))}")
        results = json.loads(finished.stdout)["results"][0]["pipelines"]
    for (name, _), result in zip(entries(), results, strict=True):
        row = {"triangles": SUBDIVISIONS[subdivisions], "thickness_mm": thickness_mm, "speed_m_s": speed_m_s, "pipeline": name}
        row["status"] = result["status"]
        row.update({quantity: result["summary"].get(quantity) for quantity in QUANTITIES})
        yield row


def measured_text(row):
    """Worst depth in mm, and what it hides: with inverted tissue counted, passed through, inverted, steps not proved."""
    depth_mm, aware_mm = 1000 * row["max_penetration_depth_m"], 1000 * row["max_inversion_aware_depth_m"]
    text = f"{depth_mm:.2f}" + (f"/{aware_mm:.2f}" if aware_mm > depth_mm + HIDDEN_MM else "")
    for key, marks in (("passed_through_samples", "()"), ("max_inverted_triangles", "[]"), ("uncertified_steps", "{}")):
        text += f" {marks[0]}{row[key]}{marks[1]}" if row[key] else ""
    return text


def cell(row):
    depth = row["max_penetration_depth_m"]
    if row["status"] != "ok" or depth is None:
        return row["status"] if row["status"] != "ok" else "nan"
    text = measured_text(row)
    roughness = row["force_roughness"]
    return text + ("; -" if roughness is None else f"; {roughness:.2g}")


NOTES = """\
# Where each pipeline starts to fail

    /usr/bin/python3 scripts/failure_table.py

Worst penetration depth, mm; roughness of the force (RMS of its second difference over its RMS; -: no force). (n): n tool samples
passed right through; [n]: up to n tissue triangles inverted, where depth can hide; a/b: a deep, and b where inverted tissue counts
as tissue; {n}: n steps whose end is not proved free of overlap.

![Worst depth over speed, thickness and mesh](depth.png)

* A blade 20 mm thick is thicker than it is wide (15 mm): its two largest faces, which carry the nodes, are then its sides, and
  nodes look sideways. That is where the full method, made for thin tools, ends.
* In single precision Bullet's own pose matching would shrink this sphere before any contact, to 0.6 of its volume with 512
  triangles and 0.2 with 2,048: it takes the matrix that it turns the rest shape by for singular below 32 mm radius. Such bodies are
  matched by the program, with that matrix scaled to one: single precision now keeps the tissue's size, and can be read like double.
* At 10 m/s, 10 mm in a step, the full method leaves 0.3 to 1.9 mm on 512 and 2,048 triangles, whose edges (about 7 and 3.5 mm) come
  near the distance of its 16 x 16 nodes (2.7 mm along the blade). On 512 triangles no cell of it is proved at any speed: an edge of
  tissue reaches over the rim in some steps.
* Pipeline swept is proved in every step of every cell, and no triangle turns over.
"""


def write_table(path, rows):
    lines = NOTES.split("\n")
    lines += ["| triangles | blade [mm] | pipeline | " + " | ".join(f"{v:g} m/s" for v in SPEEDS_M_S) + " |"]
    lines += ["|---|---|---|" + "---|" * len(SPEEDS_M_S)]
    for key in dict.fromkeys((r["triangles"], r["thickness_mm"], r["pipeline"]) for r in rows):
        cells = [cell(r) for r in rows if (r["triangles"], r["thickness_mm"], r["pipeline"]) == key]
        lines.append("| " + " | ".join([*map(str, key), *cells]) + " |")
    path.write_text("\n".join(lines) + "\n")


def verdict(row):
    """0: holds and is proved, 1: partly in or not proved, 2: fails; a run without a number fails, and so does tissue turned inside out."""
    depth = row["max_penetration_depth_m"]
    if row["status"] != "ok" or depth is None or 1000 * depth > FAR_MM or row["passed_through_samples"]:
        return 2
    return 1 if 1000 * depth > HOLDS_MM or row["max_inverted_triangles"] or row["uncertified_steps"] else 0


def draw(path, rows):
    names = list(dict.fromkeys(r["pipeline"] for r in rows))
    figure, axes = plt.subplots(1, len(SUBDIVISIONS), figsize=(12, 4.4), sharey=True)
    colours = ListedColormap(["#009E73", "#F0E442", "#D55E00"])
    for axis, triangles in zip(axes, SUBDIVISIONS.values()):
        of_mesh = [r for r in rows if r["triangles"] == triangles]
        grid = [[verdict(r) for r in of_mesh if r["pipeline"] == name] for name in names]
        axis.imshow(grid, cmap=colours, norm=BoundaryNorm([-0.5, 0.5, 1.5, 2.5], 3), aspect="auto")
        for y, name in enumerate(names):
            for x, r in enumerate(r for r in of_mesh if r["pipeline"] == name):
                depth = r["max_penetration_depth_m"]
                axis.text(x, y, "!" if depth is None else f"{1000 * depth:.1f}", ha="center", va="center", fontsize=7)
        columns = [(t, v) for t in THICKNESSES_MM for v in SPEEDS_M_S]
        axis.set_xticks(range(len(columns)), [f"{v:g}" for _, v in columns], fontsize=7)
        for index, thickness in enumerate(THICKNESSES_MM):
            axis.text(index * len(SPEEDS_M_S) + 1, -0.75, f"{thickness:g} mm", ha="center", fontsize=8)
            if index:
                axis.axvline(index * len(SPEEDS_M_S) - 0.5, color="black", linewidth=0.8)
        axis.set_xlabel("tool speed [m/s], by thickness of the blade")
        axis.set_title(f"{triangles} triangles", pad=20, fontsize=10)
    axes[0].set_yticks(range(len(names)), names, fontsize=8)
    figure.text(0.01, 0.01, f"worst depth [mm]; green: at most {HOLDS_MM} mm; yellow: up to {FAR_MM} mm, tissue inverted or a step not proved; red: deeper or passed", fontsize=8)
    figure.tight_layout(rect=(0, 0.04, 1, 1))
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=ROOT / "build/release/fissure")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    folder = ROOT / "results/failure"
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for subdivisions, triangles in SUBDIVISIONS.items():
        for thickness in THICKNESSES_MM:
            for speed in SPEEDS_M_S:
                rows += measure(arguments, speed, thickness, subdivisions)
                print(f"{triangles} triangles, {thickness} mm, {speed} m/s: done", flush=True)
    with open(folder / "table.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    write_table(folder / "README.md", rows)
    draw(folder / "depth.png", rows)
    print("written: results/failure/README.md, table.csv, depth.png")


if __name__ == "__main__":
    main()
