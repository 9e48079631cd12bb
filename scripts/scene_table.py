#!/usr/bin/env python3
"""Every scene of configs/ with a tool x its pipelines x speeds: depth, passing through, force, roughness, step time; and pictures.

    /usr/bin/python3 scripts/scene_table.py               all scenes; with names: only these, the other scenes' rows stay as they are
    /usr/bin/python3 scripts/scene_table.py --pictures    the strips alone: first contact, halfway and end of fukuhara's run

Scripted motions run with every segment's speed times each of FACTORS (durations divided, holds as they are), replayed ones as they are.
Writes results/scenes/scenes.csv, README.md and <scene>.png. Exit 1 when fukuhara breaks its limits in a scene without a reason in
REASONS.
"""
import argparse
import csv
import pathlib
import tempfile

import h5py
import numpy as np
import yaml
from PIL import Image

from montage import nearest
from references import ROOT, fissure

FOLDER = ROOT / "results/scenes"
FACTORS = [0.2, 1, 5]
LIMIT_MM = 0.5
METHOD = "fukuhara"
RETREAT = "spatula_withdraw"
STRIP_PX = (320, 240)
SUMMARY = {
    "max_penetration_depth_m": "depth_m",
    "passed_through_samples": "passed",
    "max_inverted_triangles": "inverted",
    "max_inversion_aware_depth_m": "aware_depth_m",
    "max_ground_depth_m": "ground_m",
    "uncertified_steps": "not_proved",
    "max_force_N": "force_N",
    "force_roughness": "roughness",
}
REASONS = {
    "replay_falcon": "a lone edge of tissue across the rim of the blade, between two nodes. Pressed 24 mm deep the body shifts while the "
    "blade holds still, until one edge (15 mm long) crosses the long rim in the middle of the 5.7 mm between two nodes, where nodes see "
    "nothing. The contact of its own that such an edge has gives way over 10 ms, and more than two margins deep it lets the edge go; the "
    "deepest point, 0.56 mm, lies on the rim, for 30 ms in all. With 60 sweeps instead of 30 it is 0.14 mm (300: 0.28), with a margin "
    "of 1 mm 0.00, with 12 x 8 or 8 x 16 nodes 0.01 or 0.00. `narrow_rows` is no remedy: in so "
    "deep a press it tears the tissue over the rim, 1.2 to 2.6 mm deep.",
}
HEAD = """# Scenes x pipelines x speeds

    /usr/bin/python3 scripts/scene_table.py               # these tables and scenes.csv, eight minutes on two cores
    /usr/bin/python3 scripts/scene_table.py --pictures    # the strips: first contact, halfway and end, `fukuhara`, speeds as in configs/

Every scene of configs/ that has a tool. x: factor on the speeds of all motion segments (durations divided, holds as they are); replayed
logs run as they are. Speed: the fastest that any point of a tool moves. Depth: the worst of the run; with inverted: where
inverted tissue counts as tissue. Below ground: of tissue, in Bullet's ground contact, and with `swept` in its own. Not proved: steps whose end is not proved free
of overlap between tool and tissue. Force: peak of the scene's first law. Time: mean step over that of the scene's first run at this speed; runs shared two cores, so only a factor of two says something.
Spacing: the widest between neighbouring nodes, over the tissue's mean edge; the method promises its depth up to 0.5.
**Bold**: `fukuhara` deeper than {limit} mm (inverted tissue counted), with samples that passed through, or not finished.

"""
RETREAT_NOTE = """\
Letting go, from the first step in which the blade moves up. Forces are those on the blade, upwards: negative would be tissue that
holds it back. Let go: the first step without contact (inf: never). Contact after that is the body bouncing against the blade, or,
where it ends high up, hanging on it. Rise: of the middle of the body's vertices. `fukuhara` is never held back and always comes back
to the ground; how high it springs is the tissue's own push, which a slower blade goes along with.
"""


def scene_names():
    return [path.stem for path in sorted((ROOT / "configs").glob("*.yaml")) if "\ntools:" in path.read_text()]


def speed_settings(scenario, factor):
    """--set words for all motion segments of a resolved scenario; None where a log moves a tool."""
    words = []
    if "duration_s" in scenario["time"]:
        words += ["--set", f"time.duration_s={scenario['time']['duration_s'] / min(factor, 1)!r}"]
    for tool in scenario["tools"]:
        if tool["motion"]["type"] == "replay":
            return None
        for index, segment in enumerate(tool["motion"]["segments"]):
            path = f"tools.{tool['name']}.motion.segments.{index}"
            if "speed_m_s" in segment:
                words += ["--set", f"{path}.speed_m_s={segment['speed_m_s'] * factor!r}"]
            if "duration_s" in segment:
                words += ["--set", f"{path}.duration_s={segment['duration_s'] / factor!r}"]
    return words


def rotated(quaternions, points):
    """Points (p, 3) turned by each x, y, z, w quaternion (t, 4): (t, p, 3)."""
    axis, w = quaternions[:, None, :3], quaternions[:, None, 3:]
    twice = 2 * np.cross(axis, points[None])
    return points[None] + w * twice + np.cross(axis, twice)


def top_speed_m_s(run):
    speeds = []
    for index, name in enumerate(run["tool"].asstr()[:]):
        points = rotated(run["tool_quaternion"][:, index], run[f"tools/{name}/vertices"][:])
        points += run["tool_position"][:, index][:, None]
        ways = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1)
        speeds.append(np.max(ways / np.diff(run["time"][:])))
    return max(speeds)


def widest_gap_m(points):
    """The longest edge of the points' minimal spanning tree: on a grid the larger of its two spacings."""
    nearest_m = np.linalg.norm(points - points[0], axis=1)
    reached = np.zeros(len(points), bool)
    widest = 0.0
    for _ in points:
        best = int(np.argmin(np.where(reached, np.inf, nearest_m)))
        widest, reached[best] = max(widest, nearest_m[best]), True
        nearest_m = np.minimum(nearest_m, np.linalg.norm(points - points[best], axis=1))
    return widest


def node_spacing_m(run):
    """The widest over all tools; face by face where a tool has flat ones, else over all its nodes."""
    gaps = []
    for tool in run["tools"].values():
        nodes, normals = tool["nodes"][:], np.round(tool["node_normals"][:], 3)
        faces = np.unique(normals + 0.0, axis=0)
        groups = [nodes[(normals == face).all(axis=1)] for face in faces] if len(faces) <= 6 else [nodes]
        gaps += [widest_gap_m(group) for group in groups]
    return max(gaps)


def mean_edge_m(run):
    faces, positions = run["faces"][:], run["positions"][0]
    edges = np.unique(np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
    return np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1).mean()


def retreat(run):
    """Of a tool that goes straight up at the end: does tissue hold it back (negative force along y), how long, how high does it rise?"""
    height = run["tool_position"][:, 0, 1]
    leaves = int(np.flatnonzero(height <= height.min() + 1e-9)[-1])
    touching = run["contact_count"][leaves + 1 :] > 0
    after_s = np.append(run["time"][leaves + 1 :], np.inf) - run["time"][leaves]
    summary = run["summary"].attrs
    return {
        "retreat_least_force_N": run["force"][0, leaves + 1 :, 1].min(),
        "retreat_least_reaction_N": run["reaction_force"][leaves + 1 :, 1].min(),
        "retreat_let_go_s": after_s[np.flatnonzero(~np.append(touching, False))[0]],
        "retreat_last_contact_s": max(after_s[:-1][touching], default=0.0),
        "rise_max_m": summary["gauge_whole_y_max_m"],
        "rise_final_m": summary["gauge_whole_y_final_m"],
    }


def rows_of(name, factor, result):
    pipelines = result["pipelines"]
    first_us = None
    geometry = pipelines[METHOD]
    for run_name, run in pipelines.items():
        row = {"scene": name, "run": run_name, "factor": factor, "top_speed_m_s": top_speed_m_s(run), "status": run.attrs["status"]}
        row |= {column: run["summary"].attrs.get(key, np.nan) for key, column in SUMMARY.items()}
        step_us = np.nanmean(run["timing/step_time_us"][:])
        first_us = first_us or step_us
        row["time_ratio"] = f"{step_us / first_us:.2f}"
        row |= {"node_spacing_m": node_spacing_m(geometry), "edge_m": mean_edge_m(geometry)}
        row |= retreat(run) if name == RETREAT else {}
        yield {key: f"{value:.6g}" if isinstance(value, float) else str(value) for key, value in row.items()}


def measure(arguments, name):
    rows, scenario = [], None
    with tempfile.TemporaryDirectory() as folder:
        for factor in sorted(FACTORS, key=lambda f: f != 1):  # first as it is: its result holds the resolved scenario
            words = [] if factor == 1 else speed_settings(scenario, factor)
            if words is None:
                continue
            command = ["run", ROOT / f"configs/{name}.yaml", "-o", f"{folder}/result.h5", "--force", "--no-frames", "--no-expect"]
            fissure(arguments, *command, "-j", arguments.jobs, *words, accept=(0, 3))
            with h5py.File(f"{folder}/result.h5") as result:
                scenario = scenario or yaml.safe_load(result["provenance/scenario_resolved"].asstr()[()])
                rows += rows_of(name, factor, result)
            print(f"{name}, speeds x {factor:g}: done", flush=True)
    return sorted(rows, key=lambda row: float(row["factor"]))


def number(text, form, factor=1):
    value = factor * float(text)
    return "-" if np.isnan(value) else format(value + 0.0, form)  # + 0.0: no negative zero


def broken(row):
    deep = not 1000 * max(float(row["depth_m"]), float(row["aware_depth_m"])) <= LIMIT_MM  # NaN is deep
    return row["run"] == METHOD and (row["status"] != "ok" or deep or float(row["passed"]) > 0)


def scene_table(rows):
    heads = ["run", "x", "speed [m/s]", "depth [mm]", "with inverted [mm]", "passed through", "inverted", "below ground [mm]", "not proved"]
    heads += ["force [N]", "roughness", "time", "status"]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for row in rows:
        cells = [row["run"], row["factor"], number(row["top_speed_m_s"], ".3g"), number(row["depth_m"], ".2f", 1e3)]
        cells += [number(row["aware_depth_m"], ".2f", 1e3), row["passed"], row["inverted"], number(row["ground_m"], ".2f", 1e3)]
        cells += [row["not_proved"], number(row["force_N"], ".3g"), number(row["roughness"], ".2g")]
        cells += [row["time_ratio"], row["status"]]
        lines.append("| " + " | ".join(f"**{cell}**" if broken(row) else cell for cell in cells) + " |")
    return lines


def retreat_table(rows):
    heads = ["run", "x", "least force [N]", "least reaction [N]", "let go after [ms]", "last contact after [ms]", "rise, most [mm]", "rise, end [mm]"]
    lines = [*RETREAT_NOTE.split("\n"), "| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for row in rows:
        cells = [row["run"], row["factor"], number(row["retreat_least_force_N"], ".3g"), number(row["retreat_least_reaction_N"], ".3g")]
        cells += [number(row[key], ".3g", 1e3) for key in ("retreat_let_go_s", "retreat_last_contact_s", "rise_max_m", "rise_final_m")]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def write_page(rows):
    """Returns the scenes that break the limits without a reason."""
    lines = HEAD.format(limit=LIMIT_MM).split("\n")[:-1]
    exceptions = list(dict.fromkeys(row["scene"] for row in rows if broken(row)))
    lines += ["## Exceptions", ""]
    lines += [f"* `{name}`: {REASONS.get(name, 'no reason known')}" for name in exceptions] or ["None."]
    for name in dict.fromkeys(row["scene"] for row in rows):
        own = [row for row in rows if row["scene"] == name]
        spacing_mm, edge_mm = (1000 * float(own[0][key]) for key in ("node_spacing_m", "edge_m"))
        lines += ["", f"## {name}", "", f"Spacing {spacing_mm:.2f} mm over an edge of {edge_mm:.2f} mm: {spacing_mm / edge_mm:.2f}."]
        lines += ["", f"![{name}: first contact, halfway, end]({name}.png)", "", *scene_table(own)]
        lines += ["", *retreat_table(own)] if name == RETREAT else []
    (FOLDER / "README.md").write_text("\n".join(lines) + "\n")
    return [name for name in exceptions if name not in REASONS]


def draw(arguments, name):
    with tempfile.TemporaryDirectory() as folder:
        command = ["run", ROOT / f"configs/{name}.yaml", "-o", f"{folder}/result.h5", "--no-expect", "--pipeline", METHOD]
        fissure(arguments, *command, "--set", "record.frames.every_s=0.02", "--set", "record.frames.size_px=[640, 480]")
        with h5py.File(f"{folder}/result.h5") as result:
            run = result[f"pipelines/{METHOD}"]
            time = run["time"][:]
            first = time[np.flatnonzero(run["contact_count"][:])[0]]
            instants = [first, (first + time[-1]) / 2, time[-1]]
            frames = [run["frames"][nearest(run["frame_time"][:], instant)] for instant in instants]
    strip = Image.new("RGB", (len(frames) * STRIP_PX[0], STRIP_PX[1]))
    for index, frame in enumerate(frames):
        strip.paste(Image.fromarray(frame).resize(STRIP_PX, Image.Resampling.LANCZOS), (index * STRIP_PX[0], 0))
    strip.quantize(128, Image.Quantize.MAXCOVERAGE).save(FOLDER / f"{name}.png", optimize=True)
    print(f"{name}: " + ", ".join(f"{instant:.3f} s" for instant in instants), flush=True)


def stored_rows(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", help="names in configs/; default: all with a tool")
    parser.add_argument("--pictures", action="store_true", help="draw the strips, measure nothing")
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    names = arguments.scenes or scene_names()
    if arguments.pictures:
        for name in names:
            draw(arguments, name)
        return
    table = FOLDER / "scenes.csv"
    rows = [row for row in stored_rows(table) if row["scene"] in scene_names() and row["scene"] not in names]
    for name in names:
        rows += measure(arguments, name)
    rows.sort(key=lambda row: row["scene"])
    with open(table, "w", newline="") as file:
        columns = dict.fromkeys(key for row in rows for key in row)
        writer = csv.DictWriter(file, fieldnames=list(columns), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    unexplained = write_page(rows)
    print("written: results/scenes/README.md, scenes.csv")
    if unexplained:
        raise SystemExit(f"{METHOD} breaks its limits without a reason in REASONS: {', '.join(unexplained)}")


if __name__ == "__main__":
    main()
