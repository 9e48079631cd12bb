#!/usr/bin/env python3
"""The file that scripts/bench leaves of a commit on a machine; its layout stands in bench/README.md."""
import datetime
import hashlib
import json
import math
import os
import pathlib
import re
import statistics
import subprocess

FORMAT, VERSION = "fissure-bench", 1
GOOGLES_OWN = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations"}
GOOGLES_OWN |= {"real_time", "cpu_time"}
TO_US = {"ns": 1e-3, "us": 1.0, "ms": 1e3, "s": 1e6}


def output_of(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout.strip()


def processor():
    """Its model as Linux names it."""
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return re.sub(r"\s+", " ", line.split(":", 1)[1]).strip()
    return os.uname().machine


def build_of(folder):
    """Compiler and flags of a configured build folder."""
    cache = dict(re.findall(r"^([A-Za-z_]+):[A-Z]+=(.*)$", (folder / "CMakeCache.txt").read_text(), re.MULTILINE))
    kind = cache["CMAKE_BUILD_TYPE"]
    flags = " ".join([cache.get("CMAKE_CXX_FLAGS", ""), cache.get(f"CMAKE_CXX_FLAGS_{kind.upper()}", "")])
    compiler = output_of(cache["CMAKE_CXX_COMPILER"], "--version").splitlines()[0]
    return {"type": kind, "compiler": compiler, "flags": flags.strip()}


def commit_of(repository):
    """The commit that is checked out, its date, and whether files that git knows differ from it."""
    seconds = int(output_of("git", "-C", repository, "show", "-s", "--format=%ct", "HEAD"))
    date = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    return {
        "commit": output_of("git", "-C", repository, "rev-parse", "HEAD"),
        "commit_date": date.strftime("%Y-%m-%dT%H:%M:%SZ"),
        "modified": bool(output_of("git", "-C", repository, "status", "--porcelain", "--untracked-files=no")),
    }


def benchmarks_of(entries):
    """Of Google Benchmark's entries: each benchmark with the time of each repetition and what it counts."""
    found = {}
    for entry in sorted(entries, key=lambda e: (e["family_index"], e["per_family_instance_index"], e.get("repetition_index", 0))):
        if entry["run_type"] != "iteration":
            continue
        one = found.setdefault(re.sub(r"/iterations:.*", "", entry["run_name"]), {"time_us": [], "counted": []})
        one["time_us"].append(entry["real_time"] * TO_US[entry["time_unit"]])
        one["counted"].append({key: value for key, value in sorted(entry.items())
                               if isinstance(value, (int, float)) and key not in GOOGLES_OWN and not key.endswith("_us")})
    result = []
    for name, one in found.items():
        counters = {key: statistics.median(counted[key] for counted in one["counted"]) for key in one["counted"][0]}
        for value in [*one["time_us"], *counters.values()]:
            if not math.isfinite(value):
                raise SystemExit(f"{name}: {value}, expected finite numbers")
        result.append({"name": name, "time_us": one["time_us"], "counters": counters})
    return result


def history_of(entries, repository, build):
    machine = {"cpu": processor(), "cores": os.cpu_count()}
    return {"format": FORMAT, "format_version": VERSION, **commit_of(repository), "machine": machine,
            "build": build_of(build), "benchmarks": benchmarks_of(entries)}


def name_of(history):
    """One file a commit and machine, where other flags or another compiler are another machine."""
    machine = json.dumps([history["machine"], history["build"]], sort_keys=True)
    changed = "-modified" if history["modified"] else ""
    return f"{history['commit'][:12]}{changed}-{hashlib.sha256(machine.encode()).hexdigest()[:8]}.json"


def write(history, folder):
    """Replaces an earlier file of the same commit and machine; whole or not at all. Returns its path."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / name_of(history)
    made = file.with_suffix(".part")
    made.write_text(json.dumps(history, indent=1) + "\n")
    made.replace(file)
    return file
