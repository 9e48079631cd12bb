#!/usr/bin/env python3
"""Writes results/robustness/README.md from what the tools of its parts have measured.

    /usr/bin/python3 scripts/robustness_page.py [--folder out/robustness] [-o results/robustness]

The folder holds fuzz.json (scripts/fuzz), coverage.json (scripts/coverage), scenes/summary.json (scripts/random_scenes.py), endurance/endurance.json
(scripts/endurance.py) and determinism.json (scripts/determinism.py); the page names the commands. A part whose file is missing stays as the
page has it, so that each may be measured on its own. Faults have a page of their own, whose totals are quoted.
"""
import argparse
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMANDS = """\
    mkdir -p out/robustness
    scripts/fuzz --seconds 2400 --seed 11 > out/robustness/fuzz.json
    scripts/coverage > out/robustness/coverage.json
    /usr/bin/python3 scripts/random_scenes.py --count 2000 --seed 8 -o out/robustness/scenes
    /usr/bin/python3 scripts/endurance.py -o out/robustness/endurance
    /usr/bin/python3 scripts/determinism.py --json out/robustness/determinism.json
    /usr/bin/python3 scripts/robustness_page.py"""


def read(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def fuzzed(found):
    rows = [(one["target"], f"{one['seconds']:.0f}", f"{one['executions']:,}", f"{one['edges']:,}", f"{one['features']:,}", one["crashes"])
            for one in found["fuzzed"]]
    executions = sum(one["executions"] for one in found["fuzzed"])
    crashes = sum(one["crashes"] for one in found["fuzzed"])
    return (f"**{executions:,} inputs, {crashes} crashes, broken promises or endless reads left.** Edges: places of the program's code reached, of "
            f"{found['fuzzed'][0]['edges_of_program']:,} in all that reads.\n\n"
            + table(("target", "seconds", "inputs", "edges", "features", "crashes"), rows))


def scenes(found):
    runs, broken = found["runs"], len(found["broken"])
    rows = [(name.replace("_", " "), row["held"], row["explained"], row["broken"]) for name, row in found["invariants"].items()]
    text = (f"**{found['scenes']:,} scenes (seed {found['seed']}), {runs.get('all', 0):,} runs, {runs.get('with contact', 0):,} with contact, "
            f"{runs.get('deep', 0):,} of them deep; {broken} invariants broken.**\n\n" + table(("invariant", "held", "explained", "broken"), rows))
    if found["broken"]:
        text += "\n\nBroken:\n\n" + "\n".join(f"* scene {number}, {name.replace('_', ' ')}: {complaint}" for number, name, complaint in found["broken"])
    if found["explained"]:
        text += "\n\nExplained:\n\n" + "\n".join(f"* {count} x {reason}" for reason, count in sorted(found["explained"].items(), key=lambda one: -one[1]))
    return text


def endured(found):
    rows = []
    for one in found["runs"]:
        if "last_kib" in one:
            rows.append((one["scenario"], one["pipeline"], f"{one['steps']:,}", f"{one['wall_s'] / 60:.1f}", f"{one['first_kib'] / 1024:.1f} to "
                         f"{one['last_kib'] / 1024:.1f}", f"{one['first_us']:.1f} to {one['last_us']:.1f}", one.get("bad", "")))
        else:
            rows.append((one["scenario"], one["pipeline"], f"{one['steps']:,}", "", "", "", one.get("bad", "")))
    sweep = found["sweep"]
    text = table(("scene", "pipeline", "steps", "minutes", "memory, MiB", "a step, us", "not as promised"), rows)
    text += "\n\nMemory and times: medians of the second and of the last tenth of the run; times are of a shared machine."
    text += (f"\n\n**A sweep of {sweep['simulations']:,} simulations, killed {sweep['kills']} times at random moments and resumed: {sweep.get('ok', 0):,} "
             f"are there once and ok; {sweep.get('differ', '-')} of {sweep.get('compared', '-')} drawn at random differ in a bit of "
             f"{sweep.get('quantities', '-')} quantities when they are run alone.**")
    if "last_kib" in sweep:
        text += f" Memory of the front: {sweep['first_kib'] / 1024:.1f} to {sweep['last_kib'] / 1024:.1f} MiB."
    if "bad" in sweep:
        text += f" Not as promised: {sweep['bad']}."
    return text


def determined(found):
    names = list(found["changes"])
    rows = []
    for row in found["runs"]:
        cells = []
        for name in names:
            change = row["changes"].get(name)
            cells.append("-" if change is None else "same" if change["first_difference"] is None else "**differs**")
        rows.append((row["scene"], row["run"], row["engine"], *cells))
    text = table(("scene", "run", "engine", *names), rows)
    text += "\n\n" + "\n".join(f"* `{name}`: {says}" for name, says in found["changes"].items())
    if found["not_done"]:
        text += "\n\nNot done: " + "; ".join(f"{name}, because {why}" for name, why in found["not_done"].items()) + "."
    return text


def faults():
    page = ROOT / "results/faults/README.md"
    totals = re.findall(r"\*\*(\d[\d,]* trials.*?)\*\*", page.read_text(encoding="utf-8"), re.DOTALL)
    return "\n".join("* " + " ".join(total.split()) for total in totals) + "\n\n[All of them, by kind](../faults/README.md)."


def share(counts, what):
    total = counts[f"{what}_total"]
    return f"{100 * counts[f'{what}_covered'] / total:.1f}" if total else "-"


def covered(found):
    whole = {key: sum(counts[key] for counts in found["rooms"].values()) for key in next(iter(found["rooms"].values()))}
    rows = [(room, f"{counts['line_total']:,}", share(counts, "line"), share(counts, "branch")) for room, counts in found["rooms"].items()]
    return (f"**{share(whole, 'line')} % of {whole['line_total']:,} lines, {share(whole, 'branch')} % of {whole['branch_total']:,} branches.**\n\n"
            + table(("room", "lines", "reached, %", "branches, %"), rows))


PARTS = (
    ("Inputs of strangers", "fuzz.json", fuzzed, """\
Everything that the program reads is fuzzed (libFuzzer, address and undefined-behaviour sanitizers), each input held to a promise: it is good, and
what is written of it reads back equal, or it is refused in one line that names the file."""),
    ("Random scenes", "scenes/summary.json", scenes, """\
Valid scenes over all shapes, tissues, tools, motions, pipelines and laws, and what must hold of every run. What is explained is not held, for the reason
below."""),
    ("Faults of the system", None, faults, ""),
    ("What the tests reach", "coverage.json", covered, """\
Lines that the compiler made code of, and branches without those of exceptions that the standard library may throw. Tests of speed, books, browsers
and clusters, of whole scenes and studies, fuzzers and campaigns are left out, and programs that tests kill do not write what they reached. `build/coverage/missed.txt` names the lines."""),
    ("Endurance", "endurance/endurance.json", endured, ""),
    ("The same bits", "determinism.json", determined, "Hashes of all data but times and provenance, with one thing changed at a time."))


def part(title, name, text, introduction, folder, old):
    """A part of the page; the one of the old page where it was not measured again."""
    found = read(folder / name) if name else None
    if name and not found:
        return old.get(title, "Not measured.")
    return "\n\n".join(filter(None, (introduction, text(found) if name else text())))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "out/robustness")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/robustness")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    page = options.output / "README.md"
    old = dict(re.findall(r"^## (.*?)\n\n(.*?)\s*(?=^## |\Z)", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)) if page.is_file() else {}
    parts = "\n\n".join(f"## {title}\n\n{part(title, name, text, introduction, options.folder, old)}" for title, name, text, introduction in PARTS)
    page.write_text(f"""# What was tried to break it

{COMMANDS}

Four hours of two cores; each command does the same for longer: `--seconds` of fuzzing, `--count` of scenes, `--steps` and `--simulations` of endurance.

{parts}
""", encoding="utf-8")
    print(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
