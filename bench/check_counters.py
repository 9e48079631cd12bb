#!/usr/bin/env python3
"""Runs all benchmarks briefly and compares what they count with the counts committed beside this file.

    check_counters.py BUILD/bench/fissure-bench             exit 1 when a counter grew, is missing, or is no finite number
    check_counters.py BUILD/bench/fissure-bench --update    makes the counts of this build the committed ones

Counters are work, exact and the same on every machine with the same libraries: one that grew is work that was not there
before. When that is meant, --update says so, and the diff of counters.json shows it. One that shrank is only
reported. Counters whose name ends in _us are times, and times never fail.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys

REFERENCE = pathlib.Path(__file__).with_name("counters.json")
GOOGLES_OWN = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations"}
GOOGLES_OWN |= {"real_time", "cpu_time"}
QUICK = "^(step|detect|store)/"  # counted twice


def count(program, *options):
    """Counters of each benchmark, by its name without what Google Benchmark adds."""
    finished = subprocess.run([program, "--benchmark_format=json", *options], capture_output=True, text=True)
    if finished.returncode:
        raise SystemExit(f"{program} failed: {finished.stderr.strip()}")
    found = {}
    for entry in json.loads(finished.stdout)["benchmarks"]:
        if entry.get("error_occurred"):
            raise SystemExit(f"{entry['name']}: {entry['error_message']}")
        found[re.sub(r"/iterations:.*", "", entry["name"])] = {
            key: value
            for key, value in sorted(entry.items())
            if isinstance(value, (int, float)) and key not in GOOGLES_OWN and not key.endswith("_us")
        }
    return found


def compare(found, reference):
    """(failures, improvements), each a list of lines."""
    failures, improvements = [], []
    for name in sorted(found.keys() | reference.keys()):
        if name not in found or name not in reference:
            side = "this build" if name not in found else REFERENCE.name
            failures.append(f"{name}: not in {side}")
            continue
        for key in sorted(found[name].keys() | reference[name].keys()):
            now, was = found[name].get(key, "missing"), reference[name].get(key, "missing")
            line = f"{name} {key}: from {was} to {now}"
            if not all(isinstance(value, (int, float)) and math.isfinite(value) for value in (now, was)):
                failures.append(f"{line}, expected finite numbers on both sides")
            elif now > was:
                failures.append(f"{line}: it grew")
            elif now < was:
                improvements.append(line)
    return failures, improvements


def load(reference):
    try:
        return json.loads(reference.read_text())
    except (OSError, ValueError) as error:
        raise SystemExit(f"{reference}: {error}; expected counters as --update writes them")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--reference", type=pathlib.Path, default=REFERENCE)
    parser.add_argument("--update", action="store_true", help="rewrite the reference")
    return parser.parse_args()


def main():
    options = parse()
    found = count(options.program)
    again = count(options.program, f"--benchmark_filter={QUICK}")
    for name, counters in again.items():
        if counters != found[name]:
            raise SystemExit(f"{name}: {found[name]} in one run, {counters} in the next, expected the same")
    if options.update:
        options.reference.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
        return
    failures, improvements = compare(found, load(options.reference))
    for line in improvements:
        print(f"{line}: it shrank (--update keeps that)")
    if failures:
        raise SystemExit("\n".join([*failures, "When that is meant: bench/check_counters.py PROGRAM --update"]))
    print(f"{sum(map(len, found.values()))} counters of {len(found)} benchmarks, none grew")


if __name__ == "__main__":
    main()
