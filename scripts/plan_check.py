#!/usr/bin/env python3
"""Whether `fissure plan --pilot` foretells how long runs take; writes results/plan.

    /usr/bin/python3 scripts/plan_check.py [--pilot 3] [--repeats 3] [--scene NAME ...]

Each pipeline entry of each scene is planned and then run, in turns. Writes README.md and times.csv. Both sides are processor time of the
worker, so that what else the machine does disturbs little; on a machine that does nothing else it is the time by the clock.
"""
import argparse
import csv
import pathlib
import re
import resource
import statistics
import subprocess
import tempfile
import time

from references import ROOT

FOLDER = ROOT / "results/plan"
SCENES = ["elastic_organ", "elastic_press", "elastic_inclusion", "spatula_press", "plate_press", "clamp_sphere", "fissure_open", "replay_tracker"]
WITHIN = 20  # percent
UNITS = {"s": 1, "min": 60, "h": 3600}
LINE = re.compile(r"^  time: (?:about )?(.+?)(?: to (.+?))? \(pilot of (\d+) of (\d+) steps took (.+)\)$", re.M)

PAGE = """# Whether a pilot foretells how long a run takes

    /usr/bin/python3 scripts/plan_check.py --pilot {pilot} --repeats {repeats}

`fissure plan SCENARIO --pilot {pilot}` simulates about one step of {pilot}, with the tools on the same path, and says how long each run takes. Here each
pipeline entry of some scenes is planned and then run in turns, as often as `--repeats` says. Predicted is what plan printed (of a range the middle), true the
time of the worker of `fissure run`, both as processor time, medians of the repeats; the error is that of the medians, worst that of a single
pair. To put a result together takes `fissure run` about a tenth of a second more. {verdict} All numbers are in [times.csv](times.csv).

| scene | run | steps of the pilot | it took | predicted | true | error | worst |
|---|---|--:|--:|--:|--:|--:|--:|
{rows}"""


def seconds(text):
    words = text.split()
    return sum(float(number) * UNITS[unit] for number, unit in zip(words[::2], words[1::2]))


def measured(words):
    """Standard output, processor time with all children and time by the clock of a program that must end well."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    finished = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if finished.returncode not in (0, 1):
        raise SystemExit(f"{words}: {finished.returncode}: {finished.stdout}{finished.stderr}")
    return finished.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def runs_of(program, scene):
    text, _, _ = measured([program, "plan", scene])
    return re.findall(r"^run (\S+) \(", text, re.M)


def compare(program, scene, run, pilot, folder):
    """One plan and one run: a row of the table."""
    text, _, wall_plan = measured([program, "plan", scene, "--pipeline", run, "--pilot", pilot])
    low, high, steps, of, took = LINE.search(text).groups()
    low, high = seconds(low), seconds(high or low)
    engine = program.parent / "fissure-engine-f64"
    words = [engine, "--scenario", scene, "--directory", scene.parent, "--pipeline", run, "--part", folder / "run.part"]
    _, true, wall = measured(words)
    (folder / "run.part").unlink()
    return {"scene": scene.stem, "run": run, "pilot_steps": int(steps), "run_steps": int(of), "pilot_s": seconds(took), "plan_wall_s": wall_plan,
            "low_s": low, "high_s": high, "predicted_s": (low + high) / 2, "true_s": true, "true_wall_s": wall}


def error(predicted, true):
    return 100 * (predicted / true - 1)


def line(rows):
    predicted, true = (statistics.median(row[key] for row in rows) for key in ("predicted_s", "true_s"))
    errors = [error(row["predicted_s"], row["true_s"]) for row in rows]
    of_medians = error(predicted, true)
    cells = [rows[0]["scene"], rows[0]["run"], f"{rows[0]['pilot_steps']} of {rows[0]['run_steps']}",
             f"{statistics.median(row['pilot_s'] for row in rows):.2f} s", f"{predicted:.2f} s", f"{true:.2f} s", f"{of_medians:+.0f} %",
             f"{max(errors, key=abs):+.0f} %"]
    return "| " + " | ".join(cells) + " |\n", of_medians


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--pilot", type=int, default=3)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--scene", action="append", help="of configs/; default: " + ", ".join(SCENES))
    parser.add_argument("-o", "--output", type=pathlib.Path, default=FOLDER)
    arguments = parser.parse_args()
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.scene or SCENES:
            scene = ROOT / f"configs/{name}.yaml"
            for run in runs_of(arguments.program, scene):
                found[name, run] = [compare(arguments.program, scene, run, arguments.pilot, pathlib.Path(folder)) for _ in range(arguments.repeats)]
                print(line(found[name, run])[0], end="", flush=True)
    lines, errors = zip(*map(line, found.values()))
    missed = [f"`{run}` of {scene}" for (scene, run), of in zip(found, errors) if abs(of) > WITHIN]
    verdict = (f"Of {len(errors)} runs {len(errors) - len(missed)} are within {WITHIN} %" + (f"; not {', '.join(missed)}." if missed else "."))
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "README.md").write_text(
        PAGE.format(pilot=arguments.pilot, repeats=arguments.repeats, verdict=verdict, rows="".join(lines)))
    with open(arguments.output / "times.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, next(iter(found.values()))[0].keys(), lineterminator="\n")
        writer.writeheader()
        for rows in found.values():
            writer.writerows({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()} for row in rows)


if __name__ == "__main__":
    main()
