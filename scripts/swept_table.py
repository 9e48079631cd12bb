#!/usr/bin/env python3
"""Pipeline swept over scenes, speeds and steps: what is not free of overlap, proved, and in order, and why.

    /usr/bin/python3 scripts/swept_table.py [-j N]     all scenes of configs/, and a bar from a file; with names: only these, the
                                                       other scenes' rows stay as they are
    /usr/bin/python3 scripts/swept_table.py --check    some cells, nothing is written

Every scene runs with its motion as fast or slow as SPEEDS_M_S says of the fastest point of its tools, and with each of STEPS_S. Holds last
as long as they do, replayed logs are played faster. Writes results/swept/table.csv and README.md. Exit 1 where an exception has no cause.
"""
import argparse
import concurrent.futures
import csv
import math
import pathlib
import tempfile

import h5py
import numpy as np
import yaml

from references import ROOT, fissure
from scene_table import mean_edge_m, rotated, scene_names, speed_settings, stored_rows

FOLDER = ROOT / "results/swept"
TABLE = FOLDER / "table.csv"
SPEEDS_M_S = [0.02, 0.1, 0.5, 2, 10]
STEPS_S = {"1 ms": 0.001, "1/240 s": 1 / 240, "1/60 s": 1 / 60}
BAR_SPEEDS_M_S = [0.05, 0.5, 3]
BAR_STEPS_S = {"1 ms": 0.001, "1/240 s": 1 / 240}
DEPTH_MM = FLOOR_MM = 0.01  # the page says it of both
EDGES = 0.5  # a tool that moves more tissue edges than this in a step may turn tissue inside out
SAGGING = 0.9  # of its height as it is put: lower, and tissue has sunk into itself
NAMED = 8  # of the runs without a cause
FINER = 4  # a step that many times as short tells the shell's own softness in long steps from contact
CHECKED = [
    ("fissure_open", "1/240 s", 0.5),
    ("bar, poke, 512", "1 ms", 3),
    ("bar, edge-on, 128", "1/240 s", 0.5),
    ("bar, drag, 512", "1/240 s", 3),
    ("bar, twist, 128", "1 ms", 0.5),
    ("bar, tilt, 512", "1/240 s", 0.5),
]
# Folds of tissue at contacts, where the tool is slow: scene, and what was measured of it.
REASONS = {
    "fissure_retract": "the blades push the walls of the slit 10 mm aside, farther than the triangles behind the walls' rim are wide, 6.7 mm: "
    "these are crushed to a tenth of their area or less and lie flat on the blade. The blades overlap the slit by 0.25 mm a side and press its "
    "rims down with their narrow faces, and without friction the rims slide on them, from 7.1 to 10.3 mm off their middles, round their corners: "
    "with friction 1 at the blades 6 are inverted, in a slit of 5 mm 12, with both none (0.5 m/s); steps of 1/8 ms leave all 23. With 9 mm none is "
    "inverted, with finer tissue (7 and 5 mm) none folds at a contact; under `fukuhara`, whose nodes stand on the large faces alone, 2 are inverted "
    "with 12 mm and 55 with 14 mm (swept: 8 and 7)",
}
HEAD = """# Pipeline swept: scenes x speeds x steps

    /usr/bin/python3 scripts/swept_table.py            # these tables and table.csv
    /usr/bin/python3 scripts/swept_table.py --check    # some cells, in the tests too

Every scene of configs/ with a tool, its motion so fast that the fastest point of a tool makes {speeds} m/s (holds last as they do,
replayed logs are played faster or slower), with steps of 1 ms, 1/240 and 1/60 s; and a bar with a hole from a file, 90 x 12 x 1.5 mm of
slivers, poked tip first, pressed edge-on, dragged, twisted and tilted into spheres and a gallbladder from a file. The certificate is on.

**Exceptions**: a depth or tissue below the floor of more than {depth} mm, samples that passed through, steps whose end is not proved free
of overlap, inverted triangles, tools that meet no tissue, runs that do not end well. Tissue against itself and against other tissue is
not covered by any contact here: triangles of tissue that lies in itself count as inverted.

"""


def speed_words(scenario, factor, folder):
    """--set words that make all motions `factor` times as fast; logs are written anew, with their times divided."""
    words = speed_settings(scenario, factor)
    if words is not None:
        return words
    words = []
    for tool in scenario["tools"]:
        motion, path = tool["motion"], f"tools.{tool['name']}.motion"
        words += ["--set", f"{path}.max_gap_s={motion['max_gap_s'] / factor!r}"]
        if "rate_hz" in motion:
            words += ["--set", f"{path}.rate_hz={motion['rate_hz'] * factor!r}"]
            continue
        with open(ROOT / "configs" / motion["file"], newline="") as file:
            lines = list(csv.reader(file))
        column = lines[0].index(motion["time_column"])
        for line in lines[1:]:
            line[column] = repr(float(line[column]) / factor)
        log = pathlib.Path(folder) / f"{tool['name']}.csv"
        with open(log, "w", newline="") as file:
            csv.writer(file).writerows(lines)
        words += ["--set", f"{path}.file={log}"]
    return words


def turned(axis, degrees, by=(0, 0, 0, 1)):
    """The quaternion x, y, z, w of a turn about an axis, after the turn `by`."""
    half = math.radians(degrees) / 2
    vector, w = math.sin(half) * np.array(axis, float), math.cos(half)
    before, w_before = np.array(by[:3], float), by[3]
    product = w * before + w_before * vector + np.cross(vector, before)
    return [*product.tolist(), float(w * w_before - vector @ before)]


def bar_motion(kind, top_m, depth_m, speed_m_s):
    """The bar lies along x from its origin, 1.5 mm high and 12 mm wide; the tissue's top is above the scene's origin."""
    half_thick_m, half_wide_m, half_long_m = 0.00075, 0.006, 0.045
    above_m = 0.002

    def way(x_m, below_m, orientation, *more):
        low_m = top_m + below_m
        segments = [{"move_to_m": [x_m, low_m - depth_m, 0], "speed_m_s": speed_m_s}, *more, {"hold_s": 0.05}]
        return {"type": "script", "start_m": [x_m, low_m + above_m, 0], "start_orientation": orientation, "segments": segments}

    def turn(axis, degrees, by):
        return {"rotate_to": turned(axis, degrees, by), "duration_s": math.radians(degrees) * half_wide_m / speed_m_s}

    upright, flat, on_edge = turned([0, 0, 1], 90), [0, 0, 0, 1], turned([1, 0, 0], 90)
    if kind == "poke":
        return way(0.001, 0, upright)
    if kind == "twist":
        return way(0.001, 0, upright, turn([0, 1, 0], 60, upright))
    if kind == "edge-on":
        return way(-half_long_m, half_wide_m, on_edge)
    if kind == "tilt":
        return way(-half_long_m, half_thick_m, flat, turn([1, 0, 0], 40, flat))
    aside = {"move_to_m": [-half_long_m, top_m + half_thick_m - depth_m, 0.02], "speed_m_s": speed_m_s}
    return way(-half_long_m, half_thick_m, flat, aside)


def bar_bodies(name):
    """A sphere that lies in its bed, or the gallbladder in its own, with the height of its top and how deep the bar goes."""
    if name == "organ":
        body = yaml.safe_load((ROOT / "configs/organ_press.yaml").read_text())["bodies"][0]
        body["shape"]["file"] = str(ROOT / "configs" / body["shape"]["file"])
        return {**body, "fixed": [{"below_m": 0.01}]}, 0.0275, 0.008
    body = yaml.safe_load((ROOT / "configs/fixtures/base/ball.yaml").read_text())["bodies"][0]
    body["shape"]["subdivisions"] = {"128": 2, "512": 3}[name]
    return body, 0.06, 0.012


def bar_scenario(scene, speed_m_s):
    kind, tissue = scene.split(", ")[1:]
    body, top_m, depth_m = bar_bodies(tissue)
    depth_m *= {"poke": 1, "edge-on": 1, "twist": 0.7, "drag": 0.5, "tilt": 0.5}[kind]
    tool = {"name": "bar", "shape": {"type": "file", "file": str(ROOT / "configs/meshes/flat_bar.obj"), "unit": "mm"}}
    tool["motion"] = bar_motion(kind, top_m, depth_m, speed_m_s)
    scenario = {"base": str(ROOT / "configs/fixtures/base/common.yaml"), "name": "bar", "description": "A bar from a file meets tissue."}
    return {**scenario, "bodies": [body], "tools": [tool]}


def bar_scenes():
    return [f"bar, {kind}, {tissue}" for kind in ("poke", "edge-on", "drag", "twist", "tilt") for tissue in ("128", "512", "organ")]


def cells(scene):
    """Step and speed of each run of a scene."""
    steps, speeds = (BAR_STEPS_S, BAR_SPEEDS_M_S) if scene in bar_scenes() else (STEPS_S, SPEEDS_M_S)
    return [(scene, step, speed) for step in steps for speed in speeds]


def simulated(arguments, scenario, folder, words, step_s=0.001, every_s=1.0):
    """The swept run of a scenario file, opened."""
    result = pathlib.Path(folder) / "result.h5"
    command = ["run", scenario, "-o", result, "--force", "--no-frames", "--no-expect", "--pipeline", "swept", "-j", 1]
    sets = ["measure.certify=true", f"record.snapshots_every_s={every_s!r}", f"time.step_s={step_s!r}"]
    fissure(arguments, *command, *(word for text in sets for word in ("--set", text)), *words, accept=(0, 3))
    return h5py.File(result)


def tool_ways_m(run):
    """One a step: the longest way that a corner of a tool made in it."""
    ways = np.zeros(len(run["time"]) - 1)
    for index, name in enumerate(run["tool"].asstr()[:]):
        points = rotated(run["tool_quaternion"][:, index], run[f"tools/{name}/vertices"][:])
        points += run["tool_position"][:, index][:, None]
        ways = np.maximum(ways, np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1))
    return ways


def natural_speed_m_s(arguments, scene):
    """The resolved scenario, and the speed of the fastest point of its tools as the file says it."""
    with tempfile.TemporaryDirectory() as folder, simulated(arguments, ROOT / f"configs/{scene}.yaml", folder, []) as result:
        run = result["pipelines/swept"]
        scenario = yaml.safe_load(result["provenance/scenario_resolved"].asstr()[()])
        return scenario, float((tool_ways_m(run) / np.diff(run["time"][:])).max())


def beneath(triangles, points, own):
    """The winding number of a closed surface just beneath a point of each of its triangles `own`."""
    sums = np.empty(len(points))
    for first in range(0, len(points), 128):
        of = slice(first, first + 128)
        a, b, c = (triangles[None, :, corner] - points[of, None] for corner in range(3))
        la, lb, lc = (np.linalg.norm(arm, axis=2) for arm in (a, b, c))
        dots = la * lb * lc + (a * b).sum(2) * lc + (b * c).sum(2) * la + (c * a).sum(2) * lb
        angles = np.arctan2((a * np.cross(b, c)).sum(2), dots)
        angles[np.arange(len(angles)), own[of]] = np.pi / 2
        sums[of] = angles.sum(1) / (2 * np.pi)
    return np.rint(sums)


def kinds(run, snapshot):
    """How many inverted triangles lie in their own body's tissue, are folded where a contact is, and are folded away from contacts."""
    faces, positions = run["faces"][:], run["positions"][snapshot]
    contact = run["vertex_contact"][snapshot] != 0
    bounds = [*run["first_face"][:], len(faces)]
    buried = touched = alone = 0
    for first, last in zip(bounds, bounds[1:]):
        own = faces[first:last]
        triangles = positions[own]
        middles = triangles.mean(axis=1)
        places = [middles, *(triangles[:, j] + 1e-3 * (middles - triangles[:, j]) for j in range(3))]
        windings = np.array([beneath(triangles, place, np.arange(len(own))) for place in places])
        folded = (windings < 1).any(axis=0)
        buried += int(((windings > 1).any(axis=0) & ~folded).sum())
        touched += int((folded & contact[own].any(axis=1)).sum())
        alone += int((folded & ~contact[own].any(axis=1)).sum())
    return buried, touched, alone


def inversion(run_again, row, inverted, contacts, step_s):
    """What the inverted triangles of a run are, at their most, and how many there are with a finer step: columns of its row."""
    first_contact = int(np.argmax(contacts > 0)) if (contacts > 0).any() else len(contacts)
    row["inverted_before_contact"] = int(inverted[:first_contact].max(initial=0))
    if float(row["edges_a_step"]) > EDGES:
        return
    with run_again(step_s, step_s) as result:
        run = result["pipelines/swept"]
        snapshot = int(np.argmin(np.abs(run["snapshot_time"][:] - run["time"][int(inverted.argmax())])))
        row["buried"], row["folded_at_contact"], row["folded_alone"] = kinds(run, snapshot)
    if row["folded_at_contact"] or not row["buried"] + row["folded_alone"]:
        with run_again(step_s / FINER, 1.0) as result:
            row["inverted_finer_step"] = int(result["pipelines/swept/inverted_triangles"][:].max())


def height_share(arguments, scenario, folder, words, step_s):
    """The least height of the tissue over the height at which it is put."""
    heights_m = []
    for settling in ([], ["--set", "time.settle_s=0"]):
        with simulated(arguments, scenario, folder, [*words, *settling], step_s, 0.05) as result:
            heights_m.append(np.ptp(result["pipelines/swept/positions"][:, :, 1], axis=1))
    return heights_m[0].min() / heights_m[1][0]


def row_of(arguments, cell, scenario, folder, words, step_s):
    scene, step, speed = cell
    row = {"scene": scene, "step": step, "speed_m_s": speed}
    with simulated(arguments, scenario, folder, words, step_s) as result:
        run = result["pipelines/swept"]
        row["status"] = run.attrs["status"]
        summary = run["summary"].attrs
        contacts, inverted, proved = (run[name][:] for name in ("contact_count", "inverted_triangles", "certified"))
        row["edges_a_step"] = tool_ways_m(run).max() / mean_edge_m(run)
        row["depth_mm"] = 1000 * np.nanmax([run["penetration_depth"][:], run["inversion_aware_depth"][:]])
        free = int(np.argmax(proved == 1))  # 0 also where no step is proved
        row["starts_inside_steps"] = free
        row["depth_once_free_mm"] = 1000 * np.nanmax([run["penetration_depth"][free:], run["inversion_aware_depth"][free:]], initial=0)
        row["floor_mm"] = 1000 * max(summary.get("max_ground_depth_m", 0), 0)
        row["not_proved"] = int((proved[free:] != 1).sum())
        for name in ("truncated_steps", "truncated_vertices", "no_room_steps", "passed_through_samples"):
            row[name] = int(summary[name])
        row["inverted"] = int(inverted.max())
        row["contact_steps"] = int((contacts > 0).sum())
        settle_s = yaml.safe_load(result["provenance/scenario_resolved"].asstr()[()])["time"]["settle_s"]
        row["rounds_a_step"] = summary["rounds"] / (summary["steps"] + round(settle_s / step_s))
    if row["inverted"]:
        inversion(lambda *steps: simulated(arguments, scenario, folder, words, *steps), row, inverted, contacts, step_s)
    if not row["contact_steps"]:
        row["height_share"] = height_share(arguments, scenario, folder, words, step_s)
    return {key: f"{value:.6g}" if isinstance(value, float) else str(value) for key, value in row.items()}


def measure(arguments, cell, natural):
    scene, step, speed = cell
    with tempfile.TemporaryDirectory() as folder:
        if natural is None:
            step_s, scenario, words = BAR_STEPS_S[step], pathlib.Path(folder) / "bar.yaml", []
            scenario.write_text(yaml.safe_dump(bar_scenario(scene, speed)))
        else:
            step_s, scenario = STEPS_S[step], ROOT / f"configs/{scene}.yaml"
            words = speed_words(natural[0], speed / natural[1], folder)
        row = row_of(arguments, cell, scenario, folder, words, step_s)
    print(f"{scene}, {step}, {speed} m/s: " + ("; ".join(found(row)) or "held, proved, in order"), flush=True)
    return row


def found(row):
    """The exceptions of a run, each with its cause after a colon; empty after it: none is known."""
    number = {key: float(value) for key, value in row.items() if key not in ("scene", "step", "status") and value != ""}
    no_room = f"no room in {row['no_room_steps']} steps" if number["no_room_steps"] >= max(number["not_proved"], 1) else ""
    if row["status"] != "ok":
        yield f"ended as {row['status']}: "
    if not number["contact_steps"]:
        sunk = f"the tissue has sunk {row['floor_mm']} mm below the floor" if number["floor_mm"] > FLOOR_MM else ""
        sags = number.get("height_share", 1) < SAGGING
        sagged = f"in steps so long the shell sags to {number['height_share']:.0%} of its height" if sags else ""
        yield f"no tool meets tissue: {before_contact(row, number) or sunk or sagged}"
    if number["starts_inside_steps"] and number["depth_mm"] <= DEPTH_MM:
        yield f"{row['starts_inside_steps']} steps at the start not proved: "
    elif number["starts_inside_steps"]:
        yield f"{number['depth_mm']:.2f} mm deep at the start: the tool starts inside tissue, free in step {row['starts_inside_steps']}"
    if number["depth_once_free_mm"] > DEPTH_MM:
        yield f"{number['depth_once_free_mm']:.2f} mm deep: {no_room}"
    if number["floor_mm"] > FLOOR_MM:
        yield f"{number['floor_mm']:.2f} mm below the floor: "
    if number["passed_through_samples"]:
        yield f"{row['passed_through_samples']} samples passed through: {no_room}"
    if number["not_proved"]:
        yield f"{row['not_proved']} steps not proved: {no_room}"
    if number["inverted"]:
        yield f"{row['inverted']} triangles inverted: {inverted_cause(row, number)}"


def before_contact(row, number):
    return f"{row['inverted_before_contact']} inverted before any contact" if number.get("inverted_before_contact") else ""


def inverted_cause(row, number):
    parts = [before_contact(row, number)] if number["inverted_before_contact"] else []
    if number["edges_a_step"] > EDGES:
        return ", ".join([*parts, f"the tool moves {number['edges_a_step']:.1f} tissue edges in a step"])
    if number["buried"]:
        parts.append(f"{row['buried']} in other tissue of their body")
    if number["folded_alone"]:
        parts.append(f"{row['folded_alone']} folded where no contact is")
    unclear = not number["buried"] + number["folded_alone"] + number["folded_at_contact"]
    if (number["folded_at_contact"] or unclear) and 2 * number["inverted_before_contact"] < number["inverted"]:
        slack = f"with a step of 1/{FINER} none is: the shell gives way in longer ones" if not number["inverted_finer_step"] else ""
        if not (reason := slack or REASONS.get(row["scene"], "")):
            return ""
        folded = "by less than a thousandth of a triangle" if unclear else f"{row['folded_at_contact']} folded at contacts"
        parts.append(f"{folded} ({reason})")
    return ", ".join(parts)


def unexplained(row):
    return [text for text in found(row) if text.endswith(": ")]


def scene_lines(rows):
    heads = ["scene", "runs", "depth [mm]", "floor [mm]", "not proved", "passed through", "truncated steps", "vertices", "no room"]
    heads += ["inverted, slow", "inverted, fast", "rounds a step", "without exception"]
    yield "| " + " | ".join(heads) + " |"
    yield "|---|" + "--:|" * (len(heads) - 1)
    for scene in dict.fromkeys(row["scene"] for row in rows):
        own = [row for row in rows if row["scene"] == scene]

        def total(key):
            return f"{sum(int(row[key]) for row in own):,}"

        def worst(key, of=own):
            return max((float(row[key]) for row in of), default=0)

        fast = [float(row["edges_a_step"]) > EDGES for row in own]
        values = [scene, str(len(own)), f"{worst('depth_once_free_mm'):.2f}", f"{worst('floor_mm'):.2f}", total("not_proved")]
        values += [total("passed_through_samples"), total("truncated_steps"), total("truncated_vertices"), total("no_room_steps")]
        values += [f"{worst('inverted', [row for row, quick in zip(own, fast) if quick == which]):.0f}" for which in (False, True)]
        values += [f"{np.mean([float(row['rounds_a_step']) for row in own]):.2f}", str(sum(not list(found(row)) for row in own))]
        yield "| " + " | ".join(values) + " |"


def exception_lines(rows):
    yield "| scene | step | speed [m/s] | tissue edges a step | exception | cause |"
    yield "|---|---|--:|--:|---|---|"
    for row in rows:
        for text in found(row):
            what, cause = text.split(": ", 1)
            cells_of = [row["scene"], row["step"], row["speed_m_s"], f"{float(row['edges_a_step']):.2f}", what, cause or "**none known**"]
            yield "| " + " | ".join(cells_of) + " |"


def write_page(rows):
    runs, held = len(rows), sum(not list(found(row)) for row in rows)
    lines = HEAD.format(speeds=", ".join(f"{speed:g}" for speed in SPEEDS_M_S), depth=DEPTH_MM).split("\n")[:-1]
    lines += [f"{held} of {runs} runs are without exception; {sum(bool(unexplained(row)) for row in rows)} have one without a known cause.", ""]
    lines += ["Slow: a tool that moves at most half a tissue edge in a step; fast: others. Worst of all runs, or sums over them.", ""]
    lines += [*scene_lines(rows), "", "## Exceptions", "", *exception_lines(rows)]
    (FOLDER / "README.md").write_text("\n".join(lines) + "\n")


def write_table(rows):
    FOLDER.mkdir(parents=True, exist_ok=True)
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, list(dict.fromkeys(key for row in rows for key in row)), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    write_page(rows)


def measured(arguments, wanted):
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        own = [scene for scene in dict.fromkeys(scene for scene, _, _ in wanted) if scene not in bar_scenes()]
        natural = dict(zip(own, pool.map(lambda scene: natural_speed_m_s(arguments, scene), own)))
        return list(pool.map(lambda cell: measure(arguments, cell, natural.get(cell[0])), wanted))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    known = [*scene_names(), *bar_scenes()]
    parser.add_argument("scenes", nargs="*", help="names in configs/, or \"bar, KIND, TISSUE\"; default: all")
    parser.add_argument("--check", action="store_true", help="measure some cells, write nothing")
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    if unknown := set(arguments.scenes) - set(known):
        parser.error(f"no such scene: {'; '.join(sorted(unknown))}; there are {'; '.join(known)}")
    if arguments.check:
        rows = measured(arguments, CHECKED)
    else:
        names = arguments.scenes or known
        rows = [row for row in stored_rows(TABLE) if row["scene"] in known and row["scene"] not in names]
        rows += measured(arguments, [cell for name in names for cell in cells(name)])
        rows.sort(key=lambda row: known.index(row["scene"]))
        write_table(rows)
        print("written: results/swept/README.md, table.csv")
    if bad := [row for row in rows if unexplained(row)]:
        names = [f"{row['scene']}, {row['step']}, {row['speed_m_s']} m/s" for row in bad[:NAMED]]
        raise SystemExit(f"exceptions without a cause in {len(bad)} runs: " + "; ".join([*names, "..."] if len(bad) > NAMED else names))


if __name__ == "__main__":
    main()
