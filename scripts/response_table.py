#!/usr/bin/env python3
"""What contacts do to the tissue's momentum: response none, response momentum, and the tissue alone, compared.

    /usr/bin/python3 scripts/response_table.py
    /usr/bin/python3 scripts/response_table.py --friction      # the press with friction at the tool alone: friction.csv, friction.md
    /usr/bin/python3 scripts/response_table.py --around        # configs/sweeps/force_roughness.yaml: around.md

Writes results/response/press.csv (the press scenarios over speeds, steps and nodes), scenes.csv (bodies at rest on a tool, lifted,
pushed) and table.md. "alone": the same tissue compressed by prescribed vertices (pipeline prescribed).
"""
import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
SPEEDS_M_S = [0.02, 0.1, 0.5, 2, 10]
STEPS_S = {"0.001": 0.001, "1/240": 1 / 240, "1/60": 1 / 60}
RESPONSES = ["none", "momentum"]
PRESSES = {  # scenario: (tool, nodes along an edge, steps, runs)
    "spatula_press": ("spatula", [8, 16], ["0.001", "1/240", "1/60"], RESPONSES),
    "spatula_friction": ("spatula", [8, 16], ["0.001", "1/240", "1/60"], ["momentum"]),
    "plate_press": ("plate", [16, 32], ["0.001", "1/240"], [*RESPONSES, "default_tuned"]),
}
RUBBED = {"spatula_press": [8, 16], "plate_press": [16]}  # scenario of the friction table: nodes
FRICTIONS = [0, 0.1, 0.3, 0.5]  # Coulomb's, tool and tissue together
GROUND_FRICTIONS = [0.25, 1]  # the same of ground and tissue; 0.25: as in the files
TISSUE_FRICTION = 0.5  # dynamic_friction of both press scenarios
WEIGHT_N = 0.981
SCENE = """format: 1
name: scene
description: A soft sphere of 100 g and a box.
time: {{step_s: 0.001, duration_s: {duration}}}
{ground}
bodies:
  - name: sphere
    shape: {{type: sphere, radius_m: 0.03, subdivisions: 2}}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    margin_m: 0.0005
    bending_distance: 2
    material: {{linear_stiffness: 0.5}}
    solver: {{pose_matching: 0.02, damping: 0, dynamic_friction: 1, position_iterations: 10}}
tools:
  - name: box
    shape: {{type: box, size_m: {size}}}
    nodes: {{resolution: [16, 16]}}
    motion: {{type: script, start_m: {start}, segments: {segments}}}
pipelines:
  - {{name: none, pipeline: fukuhara, response: none}}
  - {{name: momentum, pipeline: fukuhara, response: momentum}}
record: {{snapshots_every_s: 0.1}}
"""


def run(arguments, folder, text, pipelines, settings=()):
    """Runs these pipelines of a scenario; their summaries by name, and the result file."""
    (folder / "scenario.yaml").write_text(text)
    command = [arguments.program, "run", folder / "scenario.yaml", "-o", folder / "result.h5", "--force", "--json", "--no-frames", "--no-expect"]
    for setting in settings:
        command += ["--set", setting]
    for name in pipelines:
        command += ["--pipeline", name]
    finished = subprocess.run([*map(str, command), "-j", str(arguments.jobs)], stdout=subprocess.PIPE, check=False)
    if finished.returncode not in (0, 3):
        raise SystemExit(f"failed ({finished.returncode}): {' '.join(map(str, command))}")
    results = json.loads(finished.stdout)["results"][0]["pipelines"]
    return {p["name"]: {"status": p["status"], **p["summary"]} for p in results}, folder / "result.h5"


def press_text(config, responses):
    law = "model: hunt_crossley, k: 200, lambda: 50, n: 1.3"
    entries = "\n".join(f"  - {{name: {name}, pipeline: fukuhara, response: {name}}}" for name in responses)
    return f"""base: {ROOT}/configs/{config}.yaml
name: press
pipelines:
  - {{name: alone, pipeline: prescribed}}
{entries}
force:
  - {{name: hc, {law}}}
  - {{name: hc_velocities, {law}, rate: velocities}}
"""


def reaction_roughness(file, name):
    """RMS of the second difference of the reaction's magnitude over its RMS, as force_roughness."""
    with h5py.File(file) as result:
        reaction = numpy.linalg.norm(result[f"pipelines/{name}/reaction_force"][:], axis=1)
    return float(numpy.sqrt(numpy.mean(numpy.diff(reaction, 2) ** 2) / numpy.mean(reaction**2)))


def press(arguments, folder, config, tool, nodes, step, speed):
    settings = [f"tools.{tool}.motion.segments.0.speed_m_s={speed}", f"tools.{tool}.nodes.resolution=[{nodes}, {nodes}]"]
    settings += [f"time.step_s={STEPS_S[step]!r}", "record.snapshots_every_s=0.1"]
    names = PRESSES[config][3]
    responses = [name for name in names if name in RESPONSES]
    summaries, file = run(arguments, folder, press_text(config, responses), ["alone", *names], settings)
    own = summaries["alone"]
    for name in names:
        s = summaries[name]
        yield {
            "scenario": config,
            "step_s": step,
            "nodes": f"{nodes} x {nodes}" if name in RESPONSES else "-",
            "speed_m_s": speed,
            "response": name,
            "status": s["status"],
            "depth_mm": 1000 * s["max_penetration_depth_m"],
            "passed_through": s["passed_through_samples"],
            "inverted": s["max_inverted_triangles"],
            "max_force_N": s["max_force_hc_N"],
            "roughness": s["force_roughness_hc"],
            "roughness_alone": own["force_roughness_hc"],
            "same_triangles": s["roughness_same_triangles_hc"],
            "same_triangles_alone": own["roughness_same_triangles_hc"],
            "reaction_roughness": reaction_roughness(file, name) if name in RESPONSES else None,
            "roughness_velocities": s["force_roughness_hc_velocities"],
            "max_force_velocities_N": s["max_force_hc_velocities_N"],
            "mean_collision_us": s["timing/mean_collision_us"],
            "mean_step_us": s["timing/mean_step_us"],
        }


def rubbed(arguments, folder, config, tool, nodes, ground, speed):
    """Presses with friction at the tool, dt = 1 ms; the tissue alone sticks in any case."""
    settings = [f"tools.{tool}.motion.segments.0.speed_m_s={speed}", f"tools.{tool}.nodes.resolution=[{nodes}, {nodes}]"]
    settings.append(f"ground.friction={ground / TISSUE_FRICTION}")
    if config == "spatula_press":
        settings.append("pipelines.raycast.response=momentum")  # an entry of the file, not run: it must allow for friction
    text = press_text(config, RESPONSES[1:])
    own = None
    for friction in FRICTIONS:
        names = [*([] if own else ["alone"]), "momentum"]
        summaries, file = run(arguments, folder, text, names, [*settings, f"tools.{tool}.friction={friction / TISSUE_FRICTION}"])
        own = own or summaries["alone"]
        s = summaries["momentum"]
        yield {
            "scenario": config,
            "nodes": f"{nodes} x {nodes}",
            "ground_friction": ground,
            "speed_m_s": speed,
            "friction": friction,
            "status": s["status"],
            "depth_mm": 1000 * s["max_penetration_depth_m"],
            "inverted": s["max_inverted_triangles"],
            "max_force_N": s["max_force_hc_N"],
            "roughness": s["force_roughness_hc"],
            "roughness_alone": own["force_roughness_hc"],
            "same_triangles": s["roughness_same_triangles_hc"],
            "same_triangles_alone": own["roughness_same_triangles_hc"],
            "reaction_roughness": reaction_roughness(file, "momentum"),
            "mean_collision_us": s["timing/mean_collision_us"],
        }


def write_rubbed(path, rows):
    lines = ["Worst depth in mm; roughness of the force over that of the tissue alone, and the same of the triangles that collide in"]
    lines += ["three steps in a row; peak force; roughness of the reaction itself. fukuhara, response momentum, dt = 1 ms.", ""]
    lines += ["| scenario | nodes | friction at the ground | speed [m/s] | " + " | ".join(f"{mu:g} at the tool" for mu in FRICTIONS) + " |"]
    lines += ["|---|---|---|---|" + "---|" * len(FRICTIONS)]
    keys = ("scenario", "nodes", "ground_friction", "speed_m_s")
    for key in dict.fromkeys(tuple(r[k] for k in keys) for r in rows):
        cells = []
        for r in rows:
            if tuple(r[k] for k in keys) != key:
                continue
            text = f"{r['depth_mm']:.2f}" + (f" [{r['inverted']}]" if r["inverted"] else "")
            text += f"; {r['roughness'] / r['roughness_alone']:.1f}, {r['same_triangles'] / r['same_triangles_alone']:.1f}"
            cells.append(f"{text}; {r['max_force_N']:.1f} N; {r['reaction_roughness']:.4f}")
        lines.append("| " + " | ".join([*map(str, key), *cells]) + " |")
    path.write_text("\n".join(lines) + "\n")


def friction_table(arguments, folder, scratch):
    rows = []
    for config, resolutions in RUBBED.items():
        tool = PRESSES[config][0]
        for nodes in resolutions:
            for ground in GROUND_FRICTIONS:
                for speed in SPEEDS_M_S[:4]:
                    rows += rubbed(arguments, scratch, config, tool, nodes, ground, speed)
            print(f"{config}, {nodes} x {nodes} nodes: done", flush=True)
    write(folder / "friction.csv", rows)
    write_rubbed(folder / "friction.md", rows)
    print(f"written: {folder.relative_to(ROOT)}/friction.csv, friction.md")


def around_table(arguments, folder, scratch):
    """The worst of the sweep force_roughness: every run beside that of the tissue alone at the same point."""
    command = [arguments.program, "sweep", ROOT / "configs/sweeps/force_roughness.yaml", "-o", scratch / "sweep", "-j", arguments.jobs]
    subprocess.run([*map(str, command)], stdout=subprocess.DEVNULL, check=True)
    with open(scratch / "sweep/sweep.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    alone = {row["point"]: float(row["force_roughness_hc"]) for row in rows if row["pipeline"] == "tissue_alone"}
    lines = ["The worst of 33 runs each (dt 0.001, 1/240, 1/60 s; 0.02 to 10 m/s): roughness of the force over that of the tissue alone,"]
    lines += ["depth, samples that passed through, inverted triangles.", ""]
    lines += ["| friction at the tool | nodes | roughness | depth [mm] | passed through | inverted |", "|---|---|---|---|---|---|"]
    cells = {}
    for row in rows:
        if row["pipeline"] == "fukuhara":
            cells.setdefault((row["friction"], row["resolution"]), []).append(
                [
                    float(row["force_roughness_hc"]) / alone[row["point"]],
                    1000 * float(row["max_penetration_depth_m"]),
                    int(row["passed_through_samples"]),
                    int(row["max_inverted_triangles"]),
                ]
            )
    for (friction, resolution), values in cells.items():
        worst = numpy.array(values).max(axis=0)  # NaN stays NaN
        text = [f"{float(friction) * TISSUE_FRICTION:g}", resolution.strip("[]").replace(",", " x"), f"{worst[0]:.2f}", f"{worst[1]:.2f}"]
        lines.append("| " + " | ".join([*text, f"{worst[2]:.0f}", f"{worst[3]:.0f}"]) + " |")
    (folder / "around.md").write_text("\n".join(lines) + "\n")
    print(f"written: {folder.relative_to(ROOT)}/around.md")


def scene(arguments, folder, name, duration, ground, size, start, segments):
    text = SCENE.format(duration=duration, ground=ground, size=size, start=start, segments=segments)
    _, file = run(arguments, folder, text, RESPONSES)
    with h5py.File(file) as result:
        for response in RESPONSES:
            group = result[f"pipelines/{response}"]
            time = group["time"][:]
            reaction = group["reaction_force"][:]
            momentum = group["momentum"][:]
            step_s = time[1] - time[0]
            height = group["tool_position"][:, 0, 1]
            lowest = group["positions"][:, :, 1].min(axis=1)
            above = lowest - numpy.interp(group["snapshot_time"][:], time, height)
            row = {"scene": name, "response": response}
            if not ground:
                change = numpy.diff(momentum, axis=0) + step_s * (reaction[1:] + numpy.array([0, WEIGHT_N, 0]))
                row["momentum_residual_kg_m_s"] = numpy.abs(change).max()
                row["reaction_last_second_N"] = -reaction[time > time[-1] - 1, 1].mean()
                moving = (time > 2) & (time <= 3)
                row["reaction_2_to_3_s_N"] = -reaction[moving, 1].mean()
                row["speed_2_to_3_s_m_s"] = momentum[moving, 1].mean() / 0.1
                row["sink_after_1_s_mm"] = 1000 * (above[10] - above[-1])
            else:
                speed = momentum[:, 0] / 0.1
                row["fastest_m_s"] = speed.max()
                row["mean_speed_second_half_m_s"] = speed[len(speed) // 2 :].mean()
            yield row


def scenes(arguments, folder):
    table, top = "[0.2, 0.01, 0.2]", "[0, -0.0056, 0]"
    yield from scene(arguments, folder, "at rest on a fixed plate, 10 s", 10, "", table, top, "[{hold_s: 10}]")
    lift = "[{hold_s: 1}, {move_to_m: [0, 0.1944, 0], speed_m_s: 0.1, timing: constant}, {hold_s: 2}]"
    yield from scene(arguments, folder, "lifted at 0.1 m/s from 1 s to 3 s, held to 5 s", 5, "", table, top, lift)
    for friction in (0, 0.5):
        for speed in (0.1, 1):
            push = f"[{{hold_s: 0.2}}, {{move_to_m: [{3 * speed - 0.04}, 0.03, 0], speed_m_s: {speed}, timing: constant}}]"
            name = f"pushed sideways at {speed} m/s for 3 s, ground friction {friction}"
            ground = f"ground: {{height_m: 0, friction: {friction}}}"
            yield from scene(arguments, folder, name, 3.2, ground, "[0.01, 0.1, 0.4]", "[-0.04, 0.03, 0]", push)


def write(path, rows):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def press_cell(row):
    if row["status"] != "ok":
        return row["status"]
    text = f"{row['depth_mm']:.2f}" + (f" ({row['passed_through']})" if row["passed_through"] else "")
    text += f" [{row['inverted']}]" if row["inverted"] else ""
    text += f"; {row['roughness'] / row['roughness_alone']:.1f}, {row['same_triangles'] / row['same_triangles_alone']:.1f}"
    return text + (f"; {row['reaction_roughness']:.4f}" if row["reaction_roughness"] is not None else "")


def write_tables(path, presses, bodies):
    lines = ["Worst depth in mm; roughness of the force (law hc) over that of the same tissue compressed by prescribed vertices,"]
    lines += ["and the same of the triangles that collide in three steps in a row (roughness_same_triangles);"]
    lines += ["roughness of the reaction itself."]
    lines += ["(n): n tool samples passed through; [n]: up to n triangles inverted.", ""]
    lines += ["| scenario | dt [s] | nodes | response | " + " | ".join(f"{v:g} m/s" for v in SPEEDS_M_S) + " |"]
    lines += ["|---|---|---|---|" + "---|" * len(SPEEDS_M_S)]
    keys = dict.fromkeys((r["scenario"], r["step_s"], r["nodes"], r["response"]) for r in presses)
    for key in keys:
        cells = [press_cell(r) for r in presses if (r["scenario"], r["step_s"], r["nodes"], r["response"]) == key][: len(SPEEDS_M_S)]
        lines.append("| " + " | ".join([*key, *cells]) + " |")
    for row in bodies:
        values = [f"{key} {value:.4g}" for key, value in row.items() if key not in ("scene", "response")]
        lines += ["", f"* {row['scene']}, {row['response']}: " + ", ".join(values)]
    for config in (config for config, (*_, names) in PRESSES.items() if "none" in names):
        ratios = []
        for row in presses:
            if row["scenario"] != config or row["response"] != "momentum":
                continue
            same = ("scenario", "step_s", "nodes", "speed_m_s")
            other = next(r for r in presses if r["response"] == "none" and all(r[k] == row[k] for k in same))
            ratios.append(row["mean_step_us"] / other["mean_step_us"])
        lines += ["", f"* {config}: time of a step with momentum over that with none, median {numpy.median(ratios):.2f}"]
    path.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--friction", action="store_true", help="only the table of friction at the tool")
    parser.add_argument("--around", action="store_true", help="only the sweep around the scene in which tissue does not slide")
    arguments = parser.parse_args()
    folder = ROOT / "results/response"
    folder.mkdir(parents=True, exist_ok=True)
    presses, bodies = [], []
    with tempfile.TemporaryDirectory() as scratch:
        if arguments.friction:
            return friction_table(arguments, folder, pathlib.Path(scratch))
        if arguments.around:
            return around_table(arguments, folder, pathlib.Path(scratch))
        bodies += scenes(arguments, pathlib.Path(scratch))
        write(folder / "scenes.csv", bodies)
        for config, (tool, resolutions, steps, _) in PRESSES.items():
            for step in steps:
                for nodes in resolutions:
                    for speed in SPEEDS_M_S:
                        presses += press(arguments, pathlib.Path(scratch), config, tool, nodes, step, speed)
                    print(f"{config}, dt {step} s, {nodes} x {nodes} nodes: done", flush=True)
    write(folder / "press.csv", presses)
    write_tables(folder / "table.md", presses, bodies)
    print(f"written: {folder.relative_to(ROOT)}/{{press,scenes}}.csv, table.md")


if __name__ == "__main__":
    main()
