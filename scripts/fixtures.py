#!/usr/bin/env python3
"""The fixtures of configs/fixtures on a ladder of difficulty: on which rungs does a pipeline keep every step free of overlap, proved?

    /usr/bin/python3 scripts/fixtures.py               all fixtures; with names: only these, the other fixtures' rows stay as they are
    /usr/bin/python3 scripts/fixtures.py --pictures    the contact sheet alone: a frame of each fixture
    /usr/bin/python3 scripts/fixtures.py --check       validates all fixtures and runs some rungs: exit 1 when a recorded score has changed

Writes results/fixtures/fixtures.csv, README.md and fixtures.png; frames.png with --pictures. A rung is held when its run ends well and
no recorded step is without proof (pipelines that a fixture does not name are not supported with its tool). Exit 1 when a tool meets
tissue in no pipeline of a rung.
"""
import argparse
import csv
import pathlib
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import yaml
from matplotlib.colors import LinearSegmentedColormap
from PIL import Image

from montage import nearest
from references import ROOT, fissure
from scene_table import number, speed_settings, stored_rows

SCENES = ROOT / "configs/fixtures"
FOLDER = ROOT / "results/fixtures"
TABLE = FOLDER / "fixtures.csv"
PIPELINES = ["default_tuned", "raycast", "fukuhara", "swept"]
METHOD = "fukuhara"
HIDDEN_MM = 0.05  # a depth below this looks like none
# The ladder: beside these rungs, FASTER times the speed, and thicknesses where a fixture has them.
FASTER = 10
FINER = {
    "base/ball.yaml": ["bodies.ball.shape.subdivisions=4"],
    "base/lobes.yaml": ["bodies.lobes.shape.edge_m=0.005"],
    "base/common.yaml": ["bodies.vessel.shape.subdivisions=3"],
}
LONG_STEP = ["time.step_s=0.004166666666666667"]
THICKNESSES = {  # fixture: the value of its tool, thickness over it, thicknesses in mm
    "razor": ("tools.razor.shape.size_m.2", 1, [0.2, 2]),
    "needle": ("tools.needle.shape.radius_m", 2, [2]),
    "slit_path": ("tools.probe.shape.radius_m", 2, [1.2]),
    "edge_on": ("tools.blade.shape.size_m.2", 1, [0.2]),
    "corner_first": ("tools.blade.shape.size_m.1", 1, [0.2]),
    "tip_first": ("tools.blade.shape.size_m.1", 1, [0.2]),
    "slit_twist": ("tools.blade.shape.size_m.0", 1, [0.2]),
    "shear": ("tools.blade.shape.size_m.1", 1, [0.2]),
    "withdraw": ("tools.blade.shape.size_m.1", 1, [0.2]),
    "thick_blade": ("tools.blade.shape.size_m.1", 1, [10]),
    "large_plate": ("tools.plate.shape.size_m.1", 1, [0.2]),
    "starts_inside": ("tools.blade.shape.size_m.1", 1, [0.2]),
}
STARTS_INSIDE = {"starts_inside"}  # counted from the first proved step on
CHECKED = [  # quick ones, held and not held
    ("edge_on", "1/240 s"),
    ("large_plate", "10 x speed"),
    ("sheet", "1/240 s"),
    ("shear", "0.2 mm"),
    ("starts_inside", "1/240 s"),
    ("tip_first", "10 x speed"),
    ("withdraw", "10 x speed"),
]
TELLING_S = {"shear": 0.06, "withdraw": 0.226, "slit_path": 0.18}  # for the contact sheet; else the end of the run
HEAD = """# Fixtures

    /usr/bin/python3 scripts/fixtures.py               # these tables, fixtures.csv and fixtures.png
    /usr/bin/python3 scripts/fixtures.py --pictures    # the frames

Short, hard scenes ([configs/fixtures](../../configs/fixtures)) on a ladder: as written; {faster} x the speed of every motion (holds as they
are); finer tissue (triangles halved in length); a step of 1/240 s; other thicknesses of the tool where that makes sense. A rung is
**held** when the run ends well and the end of every recorded step is proved free of overlap (`measure: {{certify: true}}`). Depth: the
worst over all rungs, inverted tissue counted (of `starts_inside` also the 4 mm at its start). Bullet's own contact (`default_tuned`) takes convex, closed tools alone.

"""


def fixture(name):
    return yaml.safe_load((SCENES / f"{name}.yaml").read_text())


def fixture_names():
    return sorted(path.stem for path in SCENES.glob("*.yaml"))


def rungs(name):
    """Name and --set words of each rung of a fixture, the easiest to read first."""
    scenario = fixture(name)
    words = {
        "as written": [],
        f"{FASTER} x speed": [word for word in speed_settings({"time": {}, **scenario}, FASTER) if word != "--set"],
        "finer tissue": FINER[scenario["base"]],
        "1/240 s": LONG_STEP,
    }
    path, factor, thicknesses_mm = THICKNESSES.get(name, ("", 1, []))
    words |= {f"{mm:g} mm": [f"{path}={mm / 1000 / factor!r}"] for mm in thicknesses_mm}
    return {rung: [part for word in sets for part in ("--set", word)] for rung, sets in words.items()}


def proof(name, run):
    """Which of a run's counted steps are proved, and the number of the first that counts."""
    proved = run["certified"][:] == 1 if "certified" in run else np.zeros(0, bool)
    first = int(np.argmax(proved)) if name in STARTS_INSIDE and proved.any() else 0  # never free: no step is proved
    return proved[first:], first


def row_of(name, rung, run_name, run, method_us):
    summary = run["summary"].attrs if "summary" in run else {}
    proved, first = proof(name, run)
    unproved = np.flatnonzero(~proved)
    row = {"scene": name, "rung": rung, "run": run_name, "status": run.attrs["status"]}
    row["held"] = int(run.attrs["status"] == "ok" and len(proved) > 0 and len(unproved) == 0)
    row |= {"counted_steps": len(proved), "certified_steps": int(proved.sum()), "uncertified_steps": len(unproved)}
    row["first_uncertified_step"] = first + int(unproved[0]) if len(unproved) else ""
    row["first_uncertified"] = summary.get("first_uncertified", "") if len(unproved) and first == 0 else ""
    row |= {key: summary.get(f"max_{key}", np.nan) for key in ("penetration_depth_m", "inversion_aware_depth_m")}
    row |= {"passed": summary.get("passed_through_samples", ""), "inverted": summary.get("max_inverted_triangles", "")}
    row |= {"contact_steps": summary.get("contact_steps", 0), "untouched_tools": summary.get("untouched_tools", "")}
    step_us = np.nanmean(run["timing/step_time_us"][:]) if "timing" in run else np.nan
    row["time_ratio"] = f"{step_us / method_us:.2f}"
    return {key: f"{value:.6g}" if isinstance(value, float) else str(value) for key, value in row.items()}


def measure(arguments, name, rung, words):
    with tempfile.TemporaryDirectory() as folder:
        command = ["run", SCENES / f"{name}.yaml", "-o", f"{folder}/result.h5", "--no-frames", "--no-expect", *words]
        fissure(arguments, *command, "-j", arguments.jobs, accept=(0, 3))
        with h5py.File(f"{folder}/result.h5") as result:
            runs = result["pipelines"]
            method = runs[METHOD]
            method_us = np.nanmean(method["timing/step_time_us"][:]) if "timing" in method else np.nan
            order = sorted(runs, key=lambda run: PIPELINES.index(run) if run in PIPELINES else len(PIPELINES))
            return [row_of(name, rung, run_name, runs[run_name], method_us) for run_name in order]


def pipelines_of(rows):
    return [*PIPELINES, *dict.fromkeys(row["run"] for row in rows if row["run"] not in PIPELINES)]


def untouched(rows):
    """Fixture and rung where in no pipeline all tools meet tissue."""
    met = {(row["scene"], row["rung"]) for row in rows if int(row["contact_steps"]) and not row["untouched_tools"]}
    return [key for key in dict.fromkeys((row["scene"], row["rung"]) for row in rows) if key not in met]


def score(rows, **wanted):
    own = [row for row in rows if all(row[key] == value for key, value in wanted.items())]
    return sum(row["held"] == "1" for row in own), len(own), own


def score_cell(rows, name, pipeline):
    held, total, own = score(rows, scene=name, run=pipeline)
    if not total:
        return "not supported"
    depths = [1000 * float(row["inversion_aware_depth_m"]) for row in own]
    worst = max((depth for depth in depths if not np.isnan(depth)), default=np.nan)
    text = f"{held}/{total}" + ("" if np.isnan(worst) else f", {worst:.2f} mm")
    return f"**{text}**" if held == total else text


def score_table(rows):
    pipelines = pipelines_of(rows)
    lines = ["| fixture | " + " | ".join(f"{pipeline}: held, depth" for pipeline in pipelines) + " |", "|---" * (1 + len(pipelines)) + "|"]
    for name in dict.fromkeys(row["scene"] for row in rows):
        lines.append(f"| {name} | " + " | ".join(score_cell(rows, name, pipeline) for pipeline in pipelines) + " |")
    totals = [score(rows, run=pipeline)[:2] for pipeline in pipelines]
    return [*lines, "| **score** | " + " | ".join(f"**{held} of {total}**" for held, total in totals) + " |"]


def hidden(row):
    return row["held"] == "0" and int(row["counted_steps"]) > 0 and 1000 * float(row["penetration_depth_m"]) < HIDDEN_MM


def hidden_table(rows):
    lines = [f"Runs that are not held though their depth never reached {HIDDEN_MM} mm: what the plain depth hid.", ""]
    lines += ["| fixture | rung | run | not proved | first | in its way | depth [mm] | with inversion | passed through | inverted |", "|---" * 10 + "|"]
    for row in filter(hidden, rows):
        cells = [row["scene"], row["rung"], row["run"], f"{row['uncertified_steps']} of {row['counted_steps']}"]
        cells += [row["first_uncertified_step"], row["first_uncertified"]]
        cells += [number(row[key], ".3f", 1e3) for key in ("penetration_depth_m", "inversion_aware_depth_m")]
        cells += [row["passed"], row["inverted"]]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def stress(name):
    """What the first comment of a fixture says that it stresses."""
    comment = []
    for line in (SCENES / f"{name}.yaml").read_text().splitlines():
        if not line.startswith("# "):
            break
        comment.append(line[2:])
    return " ".join(comment).removeprefix("Stresses ")


def write_page(rows):
    lines = HEAD.format(faster=FASTER).split("\n")[:-1]
    lines += score_table(rows)
    lines += ["", "Steps without proof on each rung (a number), and the share of them (colour):", "", "![Scores](fixtures.png)", ""]
    lines += [f"`{METHOD}` as written, in a telling instant:", "", "![A frame of each fixture](frames.png)", ""]
    lines += ["## What is stressed", "", *(f"* `{name}`: {stress(name)}" for name in dict.fromkeys(row["scene"] for row in rows))]
    lines += ["", "## What depth hid", "", *hidden_table(rows)]
    (FOLDER / "README.md").write_text("\n".join(lines) + "\n")


def draw_scores(rows):
    pipelines, names = pipelines_of(rows), list(dict.fromkeys(row["scene"] for row in rows))
    common = list(rungs(names[0]))[:4]
    columns = len(common) + max(len(thicknesses) for _, _, thicknesses in THICKNESSES.values())
    colours = LinearSegmentedColormap.from_list("proved", ["#D55E00", "#F0E442"])
    figure, axes = plt.subplots(1, len(pipelines), figsize=(4.6 * len(pipelines) + 0.8, 0.34 * len(names) + 1.8), sharey=True)
    for axis, pipeline in zip(axes, pipelines):
        for y, name in enumerate(names):
            own = {row["rung"]: row for row in score(rows, scene=name, run=pipeline)[2]}
            if not own:
                axis.text((columns - 1) / 2, y, "not supported", ha="center", va="center", fontsize=7, color="#888888")
            thickness = len(common)
            for rung, row in own.items():
                x = common.index(rung) if rung in common else thickness
                thickness += rung not in common
                share = int(row["certified_steps"]) / max(1, int(row["counted_steps"]))
                colour = "#009E73" if row["held"] == "1" else colours(share)
                axis.add_patch(plt.Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=colour, edgecolor="white"))
                text = row["uncertified_steps"] if row["status"] == "ok" else row["status"]
                axis.text(x, y, text if rung in common else f"{rung}: {text}", ha="center", va="center", fontsize=6)
        held, total, _ = score(rows, run=pipeline)
        axis.set_title(f"{pipeline}: {held} of {total} held", fontsize=10)
        axis.set_xticks(range(columns), [*common, "thickness", *[""] * (columns - len(common) - 1)], fontsize=7, rotation=30, ha="right")
        axis.set_xlim(-0.5, columns - 0.5)
        axis.set_ylim(len(names) - 0.5, -0.5)
        axis.tick_params(length=0)
        axis.set_frame_on(False)
    axes[0].set_yticks(range(len(names)), names, fontsize=8)
    figure.text(0.01, 0.01, "numbers: steps without proof of no overlap; green: none, the rung is held; yellow to red: few to all", fontsize=8)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    figure.savefig(FOLDER / "fixtures.png", dpi=100)
    plt.close(figure)


def frame(arguments, name):
    """A frame, and what stands under it."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["run", SCENES / f"{name}.yaml", "-o", f"{folder}/result.h5", "--no-expect", "--pipeline", METHOD]
        fissure(arguments, *command, "--set", "record.frames.every_s=0.002")
        with h5py.File(f"{folder}/result.h5") as result:
            run = result[f"pipelines/{METHOD}"]
            instant = TELLING_S.get(name, run["time"][-1])
            index = nearest(run["frame_time"][:], instant)
            proved, _ = proof(name, run)
            told = f"{name}, {run['frame_time'][index]:.3f} s: {np.count_nonzero(~proved)} of {len(proved)} steps not proved"
            return run["frames"][index], told


def draw_frames(arguments, names):
    columns = 4
    rows = -(-len(names) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.4 * columns, 2.75 * rows), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for axis, name in zip(axes.flat, names):
        picture, told = frame(arguments, name)
        axis.imshow(picture)
        axis.set_title(told, fontsize=7, y=-0.09)
        print(told, flush=True)
    figure.tight_layout(pad=0.4)
    figure.savefig(FOLDER / "frames.png", dpi=100)
    Image.open(FOLDER / "frames.png").convert("RGB").quantize(256, Image.Quantize.MAXCOVERAGE).save(FOLDER / "frames.png", optimize=True)


def check(arguments):
    """What has changed since the table was written, in words."""
    fissure(arguments, "validate", *(SCENES / f"{name}.yaml" for name in fixture_names()))
    recorded = stored_rows(TABLE)
    known = {(row["scene"], row["rung"]) for row in recorded}
    wanted = {(name, rung) for name in fixture_names() for rung in rungs(name)}
    changed = [f"{name}, {rung}: in the table alone, or not in it" for name, rung in sorted(known ^ wanted)]
    for name, rung in CHECKED:
        for found in measure(arguments, name, rung, rungs(name)[rung]):
            named = f"{name}, {rung}, {found['run']}"
            was = [row for row in recorded if all(row[key] == found[key] for key in ("scene", "rung", "run"))]
            for key in ("status", "held", "uncertified_steps", "first_uncertified_step"):
                if was and was[0][key] != found[key]:
                    changed.append(f"{named}: {key} {found[key]}, recorded {was[0][key]}")
            changed += [] if was else [f"{named}: not in the table"]
            print(f"{named}: {'held' if found['held'] == '1' else found['uncertified_steps'] + ' steps not proved'}", flush=True)
    return changed


def write_table(rows):
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    write_page(rows)
    draw_scores(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", help="names in configs/fixtures; default: all")
    parser.add_argument("--pictures", action="store_true", help="draw the contact sheet, measure nothing")
    parser.add_argument("--check", action="store_true", help="compare some rungs with the table, write nothing")
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    unknown = set(arguments.scenes) - set(fixture_names())
    if unknown:
        parser.error(f"no such fixture: {', '.join(sorted(unknown))}; there are {', '.join(fixture_names())}")
    if arguments.check:
        changed = check(arguments)
        if changed:
            raise SystemExit("\n".join([*changed, "after a deliberate change: scripts/fixtures.py"]))
        return
    FOLDER.mkdir(parents=True, exist_ok=True)
    names = arguments.scenes or fixture_names()
    if arguments.pictures:
        draw_frames(arguments, names)
        return
    rows = [row for row in stored_rows(TABLE) if row["scene"] in fixture_names()]
    for name in names:
        own = []
        for rung, words in rungs(name).items():
            own += measure(arguments, name, rung, words)
            print(f"{name}, {rung}: " + ", ".join(f"{row['run']} {row['uncertified_steps']}" for row in own if row["rung"] == rung), flush=True)
        rows = sorted([row for row in rows if row["scene"] != name] + own, key=lambda row: row["scene"])
        write_table(rows)  # after each fixture, so that nothing is lost
    print("written: results/fixtures/fixtures.csv, README.md, fixtures.png")
    if missed := untouched(rows):
        raise SystemExit("no tool meets tissue in " + "; ".join(f"{name}, {rung}" for name, rung in missed))


if __name__ == "__main__":
    main()
