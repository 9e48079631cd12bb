#!/usr/bin/env python3
"""Very long runs and a very large sweep: is memory flat, does a step keep its time, is anything lost?

    /usr/bin/python3 scripts/endurance.py [--steps 10000000] [--simulations 10000] [--kills 20] [--seed 1] [-j 2]
                                          [--program build/release/fissure] [-o out/endurance]

Runs: a blade taps tissue for so many steps, each pipeline in a run of its own, a thousand of them recorded. The
memory of the worker is looked at all the time; what it grew by is that of the last tenth of the run over that of the second
tenth. The time of a step is the median of the last tenth of the rows over that of the second tenth.
Sweep: so many simulations of 40 steps, killed with SIGKILL at random moments and started again. In the end each simulation
must be there once, and a hundred of them, drawn at random, must give the same bits in their summaries when they are run alone.
Writes endurance.json into the folder. Exit code 1 when memory grew by more than 5 % and 4 MiB, a run did not end well, or
anything of the sweep is missing or differs.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import random
import shutil
import signal
import statistics
import subprocess
import sys
import time

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
LOG_HZ, PERIOD_S = 10, 3.7                   # samples of the tool's way, and of a tap
GROWTH, GROWTH_KIB = 0.05, 4096              # of memory, beyond which it is not flat

TOOL = """\
tools:
  - name: blade
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    nodes: {resolution: [4, 4]}
    motion: {type: replay, file: taps.csv, rate_hz: %d}
""" % LOG_HZ
SHELL = """\
format: 1
name: shell
time: {step_s: 0.001, duration_s: %(duration_s)r}
bodies:
  - {name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, mass_kg: 0.1, margin_m: 0.0005, pose_volume: true,
     pose_frame: true, material: {linear_stiffness: 0.5}, solver: {pose_matching: 0.02, volume_conservation: 0, damping: 0.01},
     fixed: [{below_m: -0.02}]}
""" + TOOL + """\
pipelines:
  - {pipeline: default, settings: tuned, time_limit_s: 1e6}
  - {pipeline: fukuhara, time_limit_s: 1e6}
  - {pipeline: swept, time_limit_s: 1e6}
force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}]
record: {every: %(every)d}
measure: {every: %(every)d}
"""
ELASTIC = """\
format: 1
name: elastic
time: {step_s: 0.001, duration_s: %(duration_s)r}
bodies:
  - {name: ball, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, model: elastic, fixed: [{below_m: -0.02}],
     elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4, density_kg_m3: 1000, viscosity_Pa_s: 5, friction: 0.5}}
""" + TOOL + """\
pipelines: [{pipeline: swept, time_limit_s: 1e6}]
record: {every: %(every)d}
measure: {every: %(every)d}
"""
SHORT = """\
base: %s/configs/spatula_press.yaml
name: short
time: {settle_s: 0, duration_s: 0.04}
tools: [{name: spatula, motion: {type: script, start_m: [0, 0.0312, 0], segments: [{move_to_m: [0, 0.02, 0], speed_m_s: 0.5}]}}]
expect: []
"""
SWEEP = """\
format: 1
name: many
base: short.yaml
pipelines: [fukuhara]
axes:
  - {path: bodies.sphere.mass_kg, linear: {from: 0.05, to: 0.15, count: %d}}
  - {path: tools.spatula.motion.segments.0.speed_m_s, linear: {from: 0.2, to: 0.8, count: %d}}
"""


def children(pid):
    """Processes below a process, without those that have ended."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
            except (OSError, IndexError, ValueError):
                continue
            if parent == pid:
                found.append(int(entry.name))
    return found


def resident_kib(pid):
    try:
        for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1])
    except OSError:
        pass
    return 0


def watch(command, folder, errors, every_s=0.2):
    """Runs a command; memory of itself and its largest child at even times, KiB, and its exit code."""
    with errors.open("wb") as stream:
        front = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=stream)
        own, worker = [], []
        while front.poll() is None:
            own.append(resident_kib(front.pid))
            worker.append(max((resident_kib(child) for child in children(front.pid)), default=0))
            time.sleep(every_s)
    return front.returncode, own, [kib for kib in worker if kib > 0]


def tenths(values):
    """The median of the second and of the last tenth of values."""
    tenth = max(1, len(values) // 10)
    return statistics.median(values[tenth:2 * tenth] or values), statistics.median(values[-tenth:])


def is_flat(first_kib, last_kib):
    return last_kib <= first_kib * (1 + GROWTH) or last_kib <= first_kib + GROWTH_KIB


def long_run(program, folder, scenario, pipeline, steps):
    print(f"{scenario}, {pipeline}: {steps} steps", flush=True)
    began = time.monotonic()
    result = f"{scenario}_{pipeline}.h5"
    code, _, worker = watch([program, "run", f"{scenario}.yaml", "--pipeline", pipeline, "-o", result, "--force"], folder,
                            folder / f"{scenario}_{pipeline}.txt")
    row = {"scenario": scenario, "pipeline": pipeline, "steps": steps, "exit": code, "wall_s": time.monotonic() - began}
    if code != 0 or len(worker) < 20:
        row["bad"] = (folder / f"{scenario}_{pipeline}.txt").read_text(errors="replace")[-300:] or "too short to be looked at"
        return row
    with h5py.File(folder / result, "r") as file:
        run = file["pipelines"][pipeline]
        times_us = np.asarray(run["timing/step_time_us"][:])
        positions_m = np.asarray(run["tool_position"][:])
        row["steps_done"] = int(run["summary"].attrs["steps"])
        row["contacts_total"] = int(run["summary"].attrs["contacts_total"])
    times_us = times_us[np.isfinite(times_us)]
    row["first_kib"], row["last_kib"] = tenths(worker)
    row["first_us"], row["last_us"] = tenths(list(times_us))
    if row["steps_done"] != steps or not np.isfinite(positions_m).all() or row["contacts_total"] == 0:
        row["bad"] = "steps are missing, the tool is nowhere, or it never touched"
    elif not is_flat(row["first_kib"], row["last_kib"]):
        row["bad"] = "memory grew"
    return row


def write_taps(path, duration_s):
    """A tap of 3 mm into the ball and 1 mm out of it again."""
    with path.open("w", encoding="ascii") as stream:
        stream.write("x,y,z\n")
        for i in range(int(duration_s * LOG_HZ) + 2):
            height_m = 0.030 + 0.002 * math.cos(2 * math.pi * i / LOG_HZ / PERIOD_S)
            stream.write(f"0,{height_m:.6f},0\n")



def large_sweep(program, folder, simulations, kills, jobs, drawn):
    count = max(2, round(math.sqrt(simulations)))
    (folder / "short.yaml").write_text(SHORT % ROOT, encoding="utf-8")
    (folder / "many.yaml").write_text(SWEEP % (count, count), encoding="utf-8")
    out = folder / "many"
    shutil.rmtree(out, ignore_errors=True)
    command = [program, "sweep", "many.yaml", "-o", "many", "-j", str(jobs)]
    row = {"simulations": count * count, "kills": 0}
    began = time.monotonic()
    while row["kills"] < kills:
        front = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        try:
            front.wait(drawn.uniform(0.5, 4))
            break
        except subprocess.TimeoutExpired:
            os.killpg(front.pid, signal.SIGKILL)
            front.wait()
            row["kills"] += 1
    row["killed_s"] = time.monotonic() - began
    began = time.monotonic()
    code, own, _ = watch(command, folder, folder / "many.txt")
    row["exit"], row["last_s"] = code, time.monotonic() - began
    if code != 0:
        row["bad"] = (folder / "many.txt").read_text(errors="replace")[-300:]
        return row
    row["first_kib"], row["last_kib"] = tenths(own)
    with h5py.File(out / "sweep.h5", "r") as table:
        columns = {name: item[:] for name, item in table.items() if isinstance(item, h5py.Dataset)}
    status = [value.decode() if isinstance(value, bytes) else str(value) for value in columns["status"]]
    masses, speeds = columns["mass_kg"], columns["speed_m_s"]
    row["ok"] = collections.Counter(status)["ok"]
    if len(status) != row["simulations"] or row["ok"] != row["simulations"] or len(set(zip(masses, speeds))) != len(status):
        row["bad"] = "a simulation is missing, there twice, or not ok"
        return row
    row["compared"], row["differ"] = 0, 0
    for i in drawn.sample(range(len(status)), min(100, len(status))):
        alone = subprocess.run(
            [program, "run", "short.yaml", "--pipeline", "fukuhara", "-o", "alone.h5", "--force", "--no-frames", "--set",
             f"bodies.sphere.mass_kg={masses[i]!r}", "--set", f"tools.spatula.motion.segments.0.speed_m_s={speeds[i]!r}"],
            cwd=folder, capture_output=True, check=False)
        row["compared"] += 1
        if alone.returncode != 0:
            row["differ"] += 1
            continue
        with h5py.File(folder / "alone.h5", "r") as file:
            summary = dict(file["pipelines/fukuhara/summary"].attrs)
        numbers = [name for name, values in columns.items() if name in summary and np.issubdtype(values.dtype, np.number)]
        row["quantities"] = len(numbers)
        row["differ"] += not numbers or any(np.float64(summary[name]).tobytes() != np.float64(columns[name][i]).tobytes() for name in numbers)
    if row["differ"]:
        row["bad"] = "simulations differ when they are run alone"
    elif not is_flat(row["first_kib"], row["last_kib"]):
        row["bad"] = "memory of the front grew"
    elif row["kills"] < kills:
        row["bad"] = "it ended before it was killed so often"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--steps", type=int, default=10_000_000)
    parser.add_argument("--simulations", type=int, default=10_000)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("--program", default=str(ROOT / "build/release/fissure"))
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "out/endurance")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    folder = options.output
    folder.mkdir(parents=True, exist_ok=True)
    every = max(1, options.steps // 1000)
    steps = options.steps // every * every
    write_taps(folder / "taps.csv", steps * 0.001)
    sizes = {"duration_s": steps * 0.001, "every": every}
    (folder / "shell.yaml").write_text(SHELL % sizes, encoding="utf-8")
    (folder / "elastic.yaml").write_text(ELASTIC % sizes, encoding="utf-8")
    runs = [long_run(program, folder, scenario, pipeline, steps)
            for scenario, pipeline in (("shell", "default"), ("shell", "fukuhara"), ("shell", "swept"), ("elastic", "swept"))]
    sweep = large_sweep(program, folder, options.simulations, options.kills, options.jobs, random.Random(options.seed))
    (folder / "endurance.json").write_text(json.dumps({"runs": runs, "sweep": sweep}, indent=1) + "\n", encoding="utf-8")
    for row in [*runs, sweep]:
        print(json.dumps(row))
    return 1 if any("bad" in row for row in [*runs, sweep]) else 0


if __name__ == "__main__":
    sys.exit(main())
