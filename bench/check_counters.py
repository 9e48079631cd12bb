#!/usr/bin/env python3
"""Keeps fissure-bench from rotting: every benchmark is there, and two very brief runs count the same.

    check_counters.py BUILD/bench/fissure-bench
"""
import json
import subprocess
import sys

FAMILIES = {"step": 7, "detect": 16, "measure": 12, "store": 1, "render": 1}
COUNTERS = {
    "detect/128/8x8/manual_time": ("contacts", "rays", "ray_triangle_tests"),
    "measure/128/touching/manual_time": ("samples",),
    "step/spatula_press/fukuhara/iterations:3/manual_time": ("contacts", "rays", "ray_triangle_tests"),
    "store/append/iterations:20000": ("bytes", "columns"),
}


def output(*options):
    return subprocess.run([sys.argv[1], *options], stdout=subprocess.PIPE, check=True, text=True).stdout


def count():
    brief = [f"--benchmark_filter=^({'|'.join(COUNTERS)})$", "--benchmark_min_time=0.001", "--benchmark_format=json"]
    entries = {entry["name"]: entry for entry in json.loads(output(*brief))["benchmarks"]}
    for name, entry in entries.items():
        if entry.get("error_occurred"):
            sys.exit(f"{name}: {entry['error_message']}")
    return {f"{name} {key}": entries[name][key] for name, keys in COUNTERS.items() for key in keys}


def main():
    listed = output("--benchmark_list_tests").split()
    found = {family: sum(name.startswith(family + "/") for name in listed) for family in FAMILIES}
    if found != FAMILIES:
        sys.exit(f"benchmarks listed: {found}, expected {FAMILIES}")
    first, second = count(), count()
    for name, value in first.items():
        if not 0 < value < float("inf") or value != second[name]:
            sys.exit(f"{name}: {value} in one run, {second[name]} in the next, expected the same above 0")


if __name__ == "__main__":
    main()
