#!/usr/bin/env python3
"""The stored references of configs/: every scenario run again and compared, or the references written anew.

    scripts/references.py check     exit 1 when a number has changed, a reference is missing or one has no scenario
    scripts/references.py update    rewrites what has changed, and results/reference/README.md: a deliberate act, which the diff shows

Tolerances: results/reference/tolerances.yaml. --program: another fissure than build/release/fissure.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "results/reference"
COLUMNS = {  # summary value: heading, factor, format
    "max_penetration_depth_m": ("worst depth [mm]", 1e3, ".6g"),
    "max_inversion_aware_depth_m": ("with inversion [mm]", 1e3, ".6g"),
    "max_ground_depth_m": ("below ground [mm]", 1e3, ".6g"),
    "passed_through_samples": ("passed through", 1, ".0f"),
    "max_inverted_triangles": ("inverted", 1, ".0f"),
    "uncertified_steps": ("not proved", 1, ".0f"),
    "max_force_N": ("peak force [N]", 1, ".6g"),
    "force_roughness": ("roughness", 1, ".6g"),
    "contacts_total": ("contacts", 1, ".0f"),
    "rays": ("rays", 1, ".0f"),
}
HEAD = """# References

    scripts/references.py check      # every scenario of configs/ against its reference here
    scripts/references.py update     # after a deliberate change of numbers

Small results (every summary value, a few rows of each series) of each scenario in configs/, without pictures, and what they say. Only
forces may differ, by a billionth ([tolerances](tolerances.yaml)). The hash is of all positions and velocities at the end.

"""


def fissure(arguments, *words, accept=(0,)):
    finished = subprocess.run([arguments.program, *map(str, words)], capture_output=True, text=True, check=False)
    if finished.returncode not in accept:
        raise SystemExit(f"fissure {words[0]} failed ({finished.returncode}): {finished.stdout}{finished.stderr}")
    return finished


def rows(name, pipelines):
    for run in pipelines:
        summary = run["summary"]
        cells = [name, run["name"], run["status"]]
        for key, (_, factor, form) in COLUMNS.items():
            cells.append(format(factor * summary[key], form) if summary.get(key) is not None else "-")
        yield "| " + " | ".join([*cells, summary["final_state_hash"]]) + " |\n"


def table(lines):
    heads = ["scenario", "run", "status", *(head for head, _, _ in COLUMNS.values()), "final state"]
    return "| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|\n" + "".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "update"])
    parser.add_argument("--program", default=ROOT / "build/release/fissure")
    arguments = parser.parse_args()
    scenarios = sorted((ROOT / "configs").glob("*.yaml"))
    orphans = {path.stem for path in FOLDER.glob("*.h5")} - {path.stem for path in scenarios}
    if orphans:
        raise SystemExit(f"references without a scenario in configs/: {', '.join(sorted(orphans))}")
    lines, failed = [], []
    with tempfile.TemporaryDirectory() as folder:
        for scenario in scenarios:
            result, reference = f"{folder}/{scenario.stem}.h5", FOLDER / f"{scenario.stem}.h5"
            told = fissure(arguments, "run", scenario, "--no-frames", "--json", "-j", 2, "-o", result)
            lines += rows(scenario.stem, json.loads(told.stdout)["results"][0]["pipelines"])
            if arguments.action == "update":
                print(fissure(arguments, "compare", result, reference, "--update").stdout, end="")
                continue
            compared = fissure(arguments, "compare", result, reference, "--tolerance", FOLDER / "tolerances.yaml", accept=(0, 1))
            print(f"{scenario.stem}\n{compared.stdout}{compared.stderr}", end="")
            if compared.returncode:
                failed.append(scenario.stem)
    page = FOLDER / "README.md"
    if arguments.action == "update":
        page.write_text(HEAD + table(lines))
    elif not page.exists() or page.read_text() != HEAD + table(lines):
        failed.append("results/reference/README.md")
    if failed:
        raise SystemExit(f"differ from their references: {', '.join(failed)} (after a deliberate change: scripts/references.py update)")


if __name__ == "__main__":
    main()
