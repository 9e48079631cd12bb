#!/usr/bin/env python3
"""The elastic press in one picture: frames, reaction over time, and held reaction over the time step beside Bullet's shell.

    /usr/bin/python3 scripts/elastic_picture.py [-j N]      writes results/elastic/press.png
"""
import argparse
import concurrent.futures
import pathlib
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import yaml

from montage import COLOURS, nearest
from references import ROOT, fissure

CONFIG = ROOT / "configs/elastic_press.yaml"
STEPS_MS = (4, 2, 1, 0.5, 0.25, 0.125)
HOLD_S = (0.55, 0.65)  # the blade waits, 8 mm deep
INSTANTS_S = (0.25, 0.6, 0.8)
SHELL = {"mass_kg": 0.11, "material": {"linear_stiffness": 0.5},
         "solver": {"pose_matching": 0.02, "damping": 0.01, "position_iterations": 10, "dynamic_friction": 0.5}}


def scenario(step_ms, shell):
    scene = yaml.safe_load(CONFIG.read_text())
    scene["time"] = {"step_s": step_ms / 1000, "duration_s": HOLD_S[1]}
    scene["record"] = {}
    del scene["expect"]
    if shell:
        del scene["bodies"][0]["model"], scene["bodies"][0]["elastic"]
        scene["bodies"][0] |= SHELL
    return scene


def held_N(arguments, step_ms, shell):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "press.yaml"
        path.write_text(yaml.safe_dump(scenario(step_ms, shell)))
        fissure(arguments, "run", path, "-o", path.with_suffix(".h5"), "--pipeline", "swept", "-j", 1, accept=(0, 3))
        with h5py.File(path.with_suffix(".h5")) as result:
            run = result["pipelines/swept"]
            held = (run["time"][:] >= HOLD_S[0]) & (run["time"][:] <= HOLD_S[1])
            return float(np.linalg.norm(run["reaction_force"][:][held], axis=1).mean())


def draw(path, held):
    figure = plt.figure(figsize=(12, 7), constrained_layout=True)
    grid = figure.add_gridspec(2, 6, height_ratios=(1, 0.9))
    with h5py.File(path) as result:
        for i, instant_s in enumerate(INSTANTS_S):
            axis = figure.add_subplot(grid[0, 2 * i:2 * i + 2])
            axis.set_axis_off()
            axis.imshow(result["pipelines/swept/frames"][nearest(result["pipelines/swept/frame_time"][:], instant_s)])
        axis = figure.add_subplot(grid[1, :3])
        for colour, (name, run) in zip(COLOURS, result["pipelines"].items()):
            axis.plot(run["time"][:], np.linalg.norm(run["reaction_force"][:], axis=1), color=colour, label=name)
    axis.set_xlabel("time [s]")
    axis.set_ylabel("reaction on the blade [N]")
    axis.legend(frameon=False, fontsize=8)
    axis.grid(alpha=0.3)
    axis = figure.add_subplot(grid[1, 3:])
    for colour, shell, label in ((COLOURS[5], True, "Bullet's shell of springs"), (COLOURS[3], False, "elastic, 10 kPa")):
        forces = [held[step, shell] for step in STEPS_MS]
        axis.loglog(STEPS_MS, forces, "o-", color=colour, label=label)
        for step, force in ((STEPS_MS[0], forces[0]), (STEPS_MS[-1], forces[-1])):
            axis.annotate(f"{force:.3g} N", (step, force), textcoords="offset points", xytext=(0, 7), ha="center", fontsize=8)
    axis.set_xticks(STEPS_MS, [f"{step:g}" for step in STEPS_MS])
    axis.minorticks_off()
    axis.margins(x=0.08, y=0.12)
    axis.set_xlabel("time step [ms]")
    axis.set_ylabel("reaction held 8 mm deep [N]")
    axis.legend(frameon=False, fontsize=8)
    axis.grid(alpha=0.3, which="both")
    output = ROOT / "results/elastic/press.png"
    output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(output, dpi=80, metadata={"Software": None})
    print(f"written: {output.relative_to(ROOT)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        path = pathlib.Path(folder) / "press.h5"
        whole = pool.submit(fissure, arguments, "run", CONFIG, "-o", path, "-j", 1, accept=(0, 3))
        runs = {(step, shell): pool.submit(held_N, arguments, step, shell) for step in STEPS_MS for shell in (True, False)}
        held = {key: run.result() for key, run in runs.items()}
        whole.result()
        for (step, shell), force in held.items():
            print(f"{'shell' if shell else 'elastic'}, {step} ms: {force:.4g} N")
        draw(path, held)


if __name__ == "__main__":
    main()
