#!/usr/bin/env python3
"""Where each pipeline holds: one press scenario over tool speeds, time steps and node resolutions.

    /usr/bin/python3 scripts/speed_table.py configs/spatula_press.yaml --tool spatula --nodes 8 16
    /usr/bin/python3 scripts/speed_table.py configs/plate_press.yaml --tool plate --nodes 16 32 --steps 0.001

Writes results/<scenario>/speeds.csv (everything measured), speeds.md (worst depth) and speeds.png. Pipelines without tool nodes are
run once for each speed and step, the others once more for each resolution.
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

from failure_table import ROOT, measured_text

SPEEDS_M_S = [0.02, 0.1, 0.5, 2, 10]
STEPS_S = {"0.001": 0.001, "1/240": 1 / 240, "1/60": 1 / 60}
NODES_ONLY = "fukuhara, nodes only"
COLOURS = {"default": "#E69F00", "default_tuned": "#56B4E9", "raycast": "#CC79A7", "fukuhara": "#009E73", NODES_ONLY: "#0072B2"}
QUANTITIES = [
    "max_penetration_depth_m",
    "final_penetration_depth_m",
    "passed_through_samples",
    "max_inverted_triangles",
    "max_inversion_aware_depth_m",
    "uncertified_steps",
    "max_ground_depth_m",
    "max_force_N",
    "force_roughness",
    "node_switch_rate_hz",
    "contacts_total",
    "non_finite_at_step",
]


def run(arguments, speed, step, resolution, pipelines, extra=()):
    with tempfile.TemporaryDirectory() as folder:
        command = [ROOT / "build/release/fissure", "run", arguments.scenario, "-o", f"{folder}/result.h5"]
        command += ["--json", "--no-frames", "--no-expect", "-j", str(arguments.jobs)]
        settings = {
            f"tools.{arguments.tool}.motion.segments.0.speed_m_s": speed,
            f"tools.{arguments.tool}.nodes.resolution": f"[{resolution}, {resolution}]",
            "time.step_s": repr(step),
            "record.snapshots_every_s": 0.1,
        }
        for path, value in settings.items():
            command += ["--set", f"{path}={value}"]
        for setting in extra:
            command += ["--set", setting]
        for name in pipelines:
            command += ["--pipeline", name]
        finished = subprocess.run(command, stdout=subprocess.PIPE, check=False)
        if finished.returncode not in (0, 3):
            raise SystemExit(f"failed ({finished.returncode}): {' '.join(map(str, command))}")
        return json.loads(finished.stdout)["results"][0]["pipelines"]


def scenario_pipelines(arguments):
    listed = run(arguments, SPEEDS_M_S[-1], STEPS_S["1/60"], 2, [])
    nodes = [p["name"] for p in listed if p["pipeline"] in ("raycast", "fukuhara")]
    return [p["name"] for p in listed if p["name"] not in nodes], nodes


def run_cell(arguments, speed, step, resolution, with_nodes, without_nodes):
    """All pipelines as the scenario has them, and the full method as the paper has it: contacts of nodes alone, which leave velocities."""
    results = run(arguments, speed, step, resolution, with_nodes + without_nodes)
    paper = run(arguments, speed, step, resolution, ["fukuhara"], [f"pipelines.fukuhara.{off}" for off in ("vertex_contacts=false", "response=none")])
    for result in paper:
        result["name"] = NODES_ONLY
    return results + paper


def measure(arguments):
    without_nodes, with_nodes = scenario_pipelines(arguments)
    rows = []
    for step_name in arguments.steps:
        for index, resolution in enumerate(arguments.nodes):
            for speed in SPEEDS_M_S:
                once = without_nodes if index == 0 else []
                for result in run_cell(arguments, speed, STEPS_S[step_name], resolution, with_nodes, once):
                    nodes = "-" if result["name"] in without_nodes else f"{resolution} x {resolution}"
                    row = {"step_s": step_name, "pipeline": result["name"], "nodes": nodes, "speed_m_s": speed}
                    row["status"] = result["status"]
                    row.update({q: result["summary"].get(q) for q in QUANTITIES})
                    rows.append(row)
                print(f"dt {step_name} s, {resolution} x {resolution} nodes, {speed} m/s: done", flush=True)
    return rows


def cell(row):
    if row["status"] != "ok":
        return row["status"]
    return "nan" if row["max_penetration_depth_m"] is None else measured_text(row)


def write_table(path, rows, command):
    keys = []
    for row in rows:
        key = (row["step_s"], row["pipeline"], row["nodes"])
        if key not in keys:
            keys.append(key)
    lines = ["Worst penetration depth over the run, mm; (n): n tool samples passed right through; [n]: up to n tissue triangles"]
    lines += ["were turned inside out or folded into each other, where depth can hide; a/b: a deep, and b where inverted tissue counts as"]
    lines += ["tissue; {n}: n steps whose end is not proved free of overlap.", ""]
    lines += ["| dt [s] | pipeline | nodes a face | " + " | ".join(f"{v:g} m/s" for v in SPEEDS_M_S) + " |"]
    lines += ["|---|---|---|" + "---|" * len(SPEEDS_M_S)]
    for key in sorted(keys, key=lambda k: list(STEPS_S).index(k[0])):
        cells = [cell(r) for r in rows if (r["step_s"], r["pipeline"], r["nodes"]) == key]
        lines.append("| " + " | ".join([*key, *cells]) + " |")
    lines += ["", f"Made by `{command}`."]
    path.write_text("\n".join(lines) + "\n")


def draw(path, rows):
    steps = list(dict.fromkeys(r["step_s"] for r in rows))
    finest = rows[-1]["nodes"]
    figure, axes = plt.subplots(1, len(steps), figsize=(4.2 * len(steps), 3.6), sharey=True, squeeze=False)
    for axis, step in zip(axes[0], steps):
        for name, nodes in dict.fromkeys((r["pipeline"], r["nodes"]) for r in rows):
            line = [r for r in rows if (r["step_s"], r["pipeline"], r["nodes"]) == (step, name, nodes)]
            depths = [float("nan") if r["max_penetration_depth_m"] is None else 1000 * r["max_penetration_depth_m"] for r in line]
            style = "--" if nodes == finest else "-"
            label = name if nodes == "-" else f"{name}, {nodes} nodes"
            axis.plot([r["speed_m_s"] for r in line], depths, style, marker="o", markersize=4, color=COLOURS.get(name), label=label)
        axis.set_xscale("log")
        axis.set_yscale("symlog", linthresh=0.1)
        axis.set_xlabel("tool speed [m/s]")
        axis.set_title(f"dt = {step} s", fontsize=10)
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("worst penetration depth [mm]")
    axes[0][-1].legend(frameon=False, fontsize=7, loc="center left", bbox_to_anchor=(1.02, 0.5))
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenario")
    parser.add_argument("--tool", required=True, help="the tool whose first motion segment gets the speeds")
    parser.add_argument("--nodes", type=int, nargs="+", default=[8, 16], help="nodes along each edge of a large face")
    parser.add_argument("--steps", nargs="+", default=list(STEPS_S), choices=list(STEPS_S), help="time steps in s")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    folder = ROOT / "results" / pathlib.Path(arguments.scenario).stem
    folder.mkdir(parents=True, exist_ok=True)
    rows = measure(arguments)
    with open(folder / "speeds.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    command = f"/usr/bin/python3 scripts/speed_table.py {arguments.scenario} --tool {arguments.tool}"
    command += f" --nodes {' '.join(map(str, arguments.nodes))} --steps {' '.join(arguments.steps)}"
    write_table(folder / "speeds.md", rows, command)
    draw(folder / "speeds.png", rows)
    print(f"written: {folder.relative_to(ROOT)}/speeds.{{csv,md,png}}")


if __name__ == "__main__":
    main()
