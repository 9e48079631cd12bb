"""The pictures of results/paper, from the results of paper_runs.py."""
import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from montage import COLOURS, nearest

NAMES = {"default": "Bullet's default, stock", "default_tuned": "Bullet's default, tuned", "raycast": "ray casting alone",
         "paper": "both steps, the paper's alone", "fukuhara": "both steps, as fissure has them", "swept": "the whole surface, swept"}


def save(figure, path):
    figure.savefig(path, dpi=72, metadata={"Software": None})  # no version in the file: the same bytes again
    plt.close(figure)


def show_frames(axes, result, run, instants):
    with h5py.File(result.path) as file:
        group = file[f"pipelines/{run}"]
        times = group["frame_time"][:]
        for axis, instant in zip(axes, instants):
            index = nearest(times, min(instant, times[-1]))
            axis.imshow(group["frames"][index])
            axis.set_title(f"{NAMES[run]}, {1000 * times[index]:.0f} ms", fontsize=8)


def frame_grid(figure, rows, columns):
    axes = figure.subplots(rows, columns, squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    return axes


def finish(axis, label):
    axis.set_xlabel("time [s]")
    axis.set_ylabel(label)
    axis.grid(alpha=0.3)
    axis.legend(frameon=False, fontsize=8)


def draw_fast(results, path):
    """Fig. 3 left: fast motion."""
    fast, runs = results["fast"], ("default", "default_tuned", "paper")
    figure = plt.figure(figsize=(10, 9.6), constrained_layout=True)
    upper, lower = figure.subfigures(2, 1, height_ratios=[7, 2.6])
    for axes, run in zip(frame_grid(upper, 3, 3), runs):
        show_frames(axes, fast, run, (0.005, 0.015, 0.25))
    axis = lower.subplots()
    for colour, run in zip(COLOURS, (*runs, "fukuhara", "swept")):
        axis.plot(fast.read(run, "time"), 1000 * fast.read(run, "penetration_depth"), color=colour, label=NAMES[run])
    finish(axis, "penetration depth [mm]")
    save(figure, path)


def draw_unstable(results, path):
    """Fig. 3 right: ray casting without the association of nodes."""
    press, runs = results["press"], ("raycast", "paper", "fukuhara")
    figure = plt.figure(figsize=(10, 9.6), constrained_layout=True)
    upper, lower = figure.subfigures(2, 1, height_ratios=[7, 2.6])
    for axes, run in zip(frame_grid(upper, 3, 3), runs):
        show_frames(axes, press, run, (0.1, 0.2, 0.55))
    left, right = lower.subplots(1, 2)
    for colour, run in zip(COLOURS[2:], (*runs, "swept")):
        time = press.read(run, "time")
        left.plot(time, np.linalg.norm(press.read(run, "force")[0], axis=1), color=colour, label=NAMES[run], linewidth=1)
        right.plot(time, press.read(run, "inverted_triangles"), color=colour, label=NAMES[run], linewidth=1)
    finish(left, "Hunt-Crossley force [N]")
    finish(right, "triangles inside out")
    save(figure, path)


def draw_shapes(results, path):
    """Fig. 4: a convex tool and a clamp."""
    figure = plt.figure(figsize=(10, 12.5), constrained_layout=True)
    axes = frame_grid(figure, 5, 3)
    show_frames(axes[0], results["convex"], "paper", (0.15, 0.25, 0.55))
    show_frames(axes[1], results["convex"], "fukuhara", (0.15, 0.25, 0.55))
    show_frames(axes[2], results["convex"], "swept", (0.15, 0.25, 0.55))
    show_frames(axes[3], results["sphere"], "fukuhara", (0.25, 0.45, 0.9))
    show_frames(axes[4], results["vessel"], "fukuhara", (0.3, 1.0, np.inf))
    save(figure, path)


def draw_grasp(results, path):
    """Fig. 5: the resultant force on the grasped sphere."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.4), constrained_layout=True)
    for axis, (name, run) in zip(axes, (("sphere_paper", "paper"), ("sphere", "fukuhara"))):
        time, left, right, whole = results[name].clamp_force_N(run)
        for colour, label, force in zip(COLOURS[3:], ("left jaw", "right jaw", "resultant"), (left, right, whole)):
            axis.plot(time, force, color=colour, label=label, linewidth=1)
        axis.set_title(NAMES[run], fontsize=9)
        finish(axis, "Hunt-Crossley force [N]")
    save(figure, path)


DRAWINGS = {"fig3_left.png": draw_fast, "fig3_right.png": draw_unstable, "fig4.png": draw_shapes, "fig5.png": draw_grasp}
