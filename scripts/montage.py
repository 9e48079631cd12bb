#!/usr/bin/env python3
"""Frames of all pipelines of a result side by side, over their penetration depth and force.

    /usr/bin/python3 scripts/montage.py out/spatula_press.h5 -o results/spatula_press.png [--at 0.1 0.2 0.55] [--reaction]

--reaction: the reaction on all tools together in place of the first force law.
"""
import argparse

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

# Okabe and Ito's colours, which colour-blind readers can tell apart.
COLOURS = ["#E69F00", "#56B4E9", "#CC79A7", "#009E73", "#0072B2", "#D55E00"]


def nearest(times, wanted):
    return int(np.argmin(np.abs(times - wanted)))


def draw_frames(axes, result, names, instants):
    for row, name in enumerate(names):
        group = result[f"pipelines/{name}"]
        for column, instant in enumerate(instants):
            axis = axes[row][column]
            axis.set_axis_off()
            if "frames" in group:
                axis.imshow(group["frames"][nearest(group["frame_time"][:], instant)])


def draw_curves(depth_axis, force_axis, result, names, reaction):
    for colour, name in zip(COLOURS, names):
        run = result[f"pipelines/{name}"]
        time_s = run["time"][:]
        depth_axis.plot(time_s, 1000 * run["penetration_depth"][:], color=colour, label=name)
        force_N = run["reaction_force"][:] if reaction else run["force"][0]
        force_axis.plot(time_s, np.linalg.norm(force_N, axis=-1), color=colour, label=name)
        law = "" if reaction else run["law"].asstr()[0]
    depth_axis.set_ylabel("penetration depth [mm]")
    force_axis.set_ylabel("reaction [N]" if reaction else f"force, {law} [N]")
    if not reaction:
        force_axis.set_yscale("symlog", linthresh=1)
    for axis in (depth_axis, force_axis):
        axis.set_xlabel("time [s]")
        axis.grid(alpha=0.3)
        axis.legend(frameon=False, fontsize=8)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("result")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--reaction", action="store_true", help="the reaction in place of the first force law")
    parser.add_argument("--at", type=float, nargs="+", help="instants in s (default: three of the run)")
    arguments = parser.parse_args()
    with h5py.File(arguments.result) as result:
        names = [n for n, g in result["pipelines"].items() if "time" in g]
        end = max(result[f"pipelines/{n}/time"][-1] for n in names)
        instants = arguments.at or [0.3 * end, 0.55 * end, end]
        figure = plt.figure(figsize=(4 * len(instants), 3 * len(names) + 3.2), constrained_layout=True)
        upper, lower = figure.subfigures(2, 1, height_ratios=[3 * len(names), 3.2])
        draw_frames(upper.subplots(len(names), len(instants), squeeze=False), result, names, instants)
        draw_curves(*lower.subplots(1, 2), result, names, arguments.reaction)
        figure.savefig(arguments.output, dpi=80)
    print(f"picture: {arguments.output}")


if __name__ == "__main__":
    main()
