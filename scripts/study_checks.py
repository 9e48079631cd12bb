#!/usr/bin/env python3
"""The quick study of stability against what is known without running it.

    /usr/bin/python3 scripts/study_checks.py FOLDER                       prints the tables of results/studies/README.md
    /usr/bin/python3 scripts/study_checks.py --check --program FISSURE    runs the study, kills it once, and checks

FOLDER is what `fissure study stability configs/studies/stability_quick.yaml` has filled. A tool of mass m on a spring K and a damper C,
integrated by implicit Euler, is pushed back by s k x of the step before, where k is a law's coefficient and s the law's newtons per
metre and per k. Its way is x[n+1] (m/h^2 + C/h + K) - x[n] (2 m/h^2 + C/h - s k) + x[n-1] m/h^2 = 0, whose roots leave the unit circle, at -1,
where s k = 4 m/h^2 + 2 C/h + K. s is measured in the last stable run, of steps in which the tool turns round each time: tissue that
neighbours the blade follows a slow press but not that. Without a damper, below that limit, the tool rings at the angle of these roots.
Explicit integration without damping is stable up to 2 over the highest frequency of the mesh, which `fissure plan` names.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
STUDY = ROOT / "configs/studies/stability_quick.yaml"
MASS_KG, STIFFNESS_N_M, DAMPING_N_S_M = 0.05, 1e5, 20      # of scenes/ball_stuck.yaml
TURNS_M = (1e-9, 2e-6)                                     # steps of such a way say what s is


def panels(folder, name):
    study = json.loads((folder / "study.json").read_text(encoding="utf-8"))
    return [panel for panel in study["panels"] if panel["map"] == name]


def spectral_radius(s_k, step_s):
    a = MASS_KG / step_s**2
    return np.abs(np.roots([a + DAMPING_N_S_M / step_s + STIFFNESS_N_M, s_k - 2 * a - DAMPING_N_S_M / step_s, a])).max()


def critical_s_k(step_s):
    """By the roots; 4 m/h^2 + 2 C/h + K says the same."""
    below, above = 1.0, 1e9
    while above / below > 1 + 1e-12:
        middle = math.sqrt(below * above)
        below, above = (middle, above) if spectral_radius(middle, step_s) <= 1 else (below, middle)
    return below


def turning_slope(result, k):
    run = h5py.File(result, "r")["pipelines/prescribed"]
    law = list(run["law"].asstr()[:]).index("lin")
    way, force = np.diff(run["tool_position"][:, 0, 1]), np.diff(run["force"][law][:, 1])
    turns = [i for i in range(5, len(way)) if TURNS_M[0] < abs(way[i]) < TURNS_M[1] and way[i] * way[i - 1] < 0]
    return float(np.median([-force[i] / way[i] / k for i in turns])), len(turns)


def late_law(folder):
    """A row for each step: h, s, predicted k, measured k below and above."""
    rows = []
    panel = panels(folder, "late_law")[0]
    for step in sorted({cell["values"][0] for cell in panel["cells"]}, key=float):
        first = min((b for b in panel["boundaries"] if b["others"] == [step]), key=lambda b: b["below"])
        cell = min((c for c in panel["cells"] if c["values"][0] == step), key=lambda c: abs(float(c["values"][1]) - first["below"]))
        s, _ = turning_slope(folder / cell["result"], float(cell["values"][1]))
        rows.append((float(step), s, critical_s_k(float(step)) / s, first["below"], first["above"]))
    return rows


def modulus_forces(folder):
    """Largest reaction over the modulus, m2, for each modulus: what is scaled in stress has scaled forces."""
    rows = []
    for cell in panels(folder, "elastic_modulus")[0]["cells"]:
        run = h5py.File(folder / cell["result"], "r")["pipelines/swept"]
        rows.append((float(cell["values"][0]), float(np.linalg.norm(run["reaction_force"][:], axis=1)[-1]) / float(cell["values"][0])))
    return sorted(rows)


def ringing(folder):
    """A row for each cell: K, s k of the tool at rest, the frequency of the roots, the frequency measured."""
    rows = []
    for cell in panels(folder, "oscillator")[0]["cells"]:
        stiffness_N_m, k = map(float, cell["values"])
        step_s, s = resting_slope(folder / cell["result"], k)
        a = MASS_KG / step_s**2
        root = np.roots([a + stiffness_N_m, s * k - 2 * a, a])[0]
        measured_Hz = float(cell["frequency_Hz"]) if cell["class"] == "chattering" else math.nan
        rows.append((stiffness_N_m, s * k, abs(np.angle(root)) / (2 * math.pi * step_s), measured_Hz))
    return rows


def resting_slope(result, k):
    """The step, and the law's newtons per metre and per k in the second half of a run, in which the tool swings a little."""
    run = h5py.File(result, "r")["pipelines/prescribed"]
    law = list(run["law"].asstr()[:]).index("lin")
    half = len(run["time"]) // 2
    way, force = run["tool_position"][half:, 0, 1], run["force"][law][half:, 1]
    return float(run["time"][1] - run["time"][0]), float(-np.polyfit(way, force, 1)[0] / k)


def explicit_limits(folder, program):
    """A row for each modulus: the step that `fissure plan` allows, the last step below and the first above which tissue alone gives way."""
    rows = []
    scene = str(ROOT / "configs/studies/scenes/ball_explicit.yaml")
    panel = panels(folder, "explicit_limit")[0]
    for modulus in sorted({cell["values"][0] for cell in panel["cells"]}, key=float):
        plan = subprocess.run([program, "plan", scene, "--set", f"bodies.ball.elastic.youngs_modulus_Pa={modulus}"],
                              capture_output=True, text=True, check=True).stdout
        allowed, unit = re.search(r"fastest vibration of the mesh allows (\S+) (\S+);", plan).groups()
        broken = {"unsound_alone", "too_slow", "non_finite"}   # Bullet's solver takes ever longer where values grow
        steps = [(float(cell["values"][1]), cell["class"] in broken) for cell in panel["cells"] if cell["values"][0] == modulus]
        rows.append((float(modulus), float(allowed) * {"s": 1, "ms": 1e-3, "us": 1e-6}[unit], max(s for s, bad in steps if not bad),
                     min(s for s, bad in steps if bad)))
    return rows


def print_tables(folder, program):
    """Those whose maps the study has."""
    tables = [
        ("late_law", "| h, ms | s | k by the roots | k measured, stable to unstable |\n|---|---|---|---|", late_law,
         lambda h, s, predicted, below, above: f"| {1000 * h:g} | {s:.3f} | {predicted:.4g} | {below:.4g} to {above:.4g} |"),
        ("elastic_modulus", "| E, Pa | last reaction / E, mm2 |\n|---|---|", modulus_forces,
         lambda modulus, area: f"| {modulus:.4g} | {1e6 * area:.2f} |"),
        ("oscillator", "| K, N/m | s k, N/m | frequency by the roots, Hz | measured, Hz |\n|---|---|---|---|", ringing,
         lambda stiffness, s_k, predicted, measured: f"| {stiffness:g} | {s_k:.4g} | {predicted:.2f} | {measured:.2f} |"),
        ("explicit_limit", "| E, Pa | 2 over the highest frequency, ms | measured, sound to unsound, ms |\n|---|---|---|",
         lambda of: explicit_limits(of, program),
         lambda modulus, allowed, below, above: f"| {modulus:.4g} | {1000 * allowed:.4g} | {1000 * below:.4g} to {1000 * above:.4g} |"),
    ]
    for name, head, rows, line in tables:
        if panels(folder, name):
            print("\n".join([head, *(line(*row) for row in rows(folder))]) + "\n")


def without_times(path):
    with path.open(encoding="utf-8") as stream:
        return [{key: value for key, value in row.items() if key != "wall_s"} for row in csv.DictReader(stream)]


def check(program):
    failures = []

    def expect(good, what):
        if not good:
            failures.append(what)

    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place) / "quick"
        command = [program, "study", "stability", str(STUDY), "-o", str(folder), "-j", "2"]
        killed = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(8)
        killed.send_signal(signal.SIGKILL)
        killed.wait()
        again = subprocess.run(command, capture_output=True, text=True, check=False)
        expect(again.returncode == 0, f"exit {again.returncode}: {again.stderr[-300:]}")
        rows = without_times(folder / "cells.csv")
        for row in rows:
            expect(row["class"] and row["reason"], f"a cell without class or reason: {row}")
        third = subprocess.run(command, capture_output=True, text=True, check=False)
        expect(third.returncode == 0 and without_times(folder / "cells.csv") == rows, "a finished study is not the same again")

        for step_s, s, predicted, below, above in late_law(folder):
            expect(below / 1.05 < predicted < above * 1.05, f"late law at {step_s} s: {predicted:.4g}, measured {below:.4g} to {above:.4g}")
            expect(abs(critical_s_k(step_s) - (4 * MASS_KG / step_s**2 + 2 * DAMPING_N_S_M / step_s + STIFFNESS_N_M)) < 1e-6 * s * predicted,
                   f"roots and closed form at {step_s} s")
        for stiffness, _, predicted, measured in ringing(folder):
            expect(abs(measured - predicted) < 0.02 * predicted, f"ringing at {stiffness} N/m: {predicted:.4g} Hz, measured {measured:.4g} Hz")
        for modulus, allowed, below, above in explicit_limits(folder, program):
            expect(below / 1.02 < allowed < above * 1.02, f"explicit limit of {modulus} Pa: {allowed:.4g} s, measured {below:.4g} to {above:.4g} s")
        areas = [area for modulus, area in modulus_forces(folder) if modulus >= 1e5]
        expect(max(areas) < 1.02 * min(areas), f"reaction over modulus: {areas}")
        for row in rows:
            if row["map"].startswith("shell") and row["pipeline"] != "default":
                expect(row["class"] == "stable", f"known to hold: {row}")
            if row["map"] == "shell_thickness" and row["pipeline"] == "default":
                expect(row["class"] == "penetrating", f"known to let the blade in: {row}")
        for scenario in sorted((folder / "typical").glob("*.yaml")):
            ran = subprocess.run([program, "run", str(scenario), "-o", str(folder / "again.h5"), "--no-frames", "--force"],
                                 capture_output=True, text=True, check=False)
            codes = {"non_finite": [3], "crashed": [3], "too_slow": [0, 3]}   # a machine with nothing else to do may be fast enough
            expect(ran.returncode in codes.get(scenario.stem, [0]),
                   f"{scenario.name}: exit {ran.returncode}: {ran.stderr[-300:]}")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path, nargs="?")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--program", default=str(ROOT / "build/release/fissure"))
    options = parser.parse_args()
    if options.check:
        return check(options.program)
    if not options.folder:
        parser.error("no folder, expected what `fissure study stability` has filled")
    print_tables(options.folder, options.program)
    return 0


if __name__ == "__main__":
    sys.exit(main())
