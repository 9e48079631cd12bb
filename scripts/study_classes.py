#!/usr/bin/env python3
"""Draws one cell of each class of studies of stability: study_classes.py FOLDER... [-o PICTURE]

FOLDERs are what `fissure study stability` has filled. The middle one of a class's cells whose result is kept is drawn, by the quantity that the
class looks at: depth, kinetic energy, or the largest force. A class whose cells leave no result is drawn as its reason."""
import argparse
import json
import pathlib
import textwrap

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from study_map import COLOURS


def cells_of(folders):
    """For each class a cell: the middle one of those with a result, else the first."""
    found, order = {}, []
    for folder in folders:
        study = json.loads((folder / "study.json").read_text(encoding="utf-8"))
        order = order or [name if isinstance(name, str) else name["name"] for name in study["classes"]]
        for panel in study["panels"]:
            for cell in panel["cells"]:
                found.setdefault(cell["class"], []).append((folder, panel, cell))
    chosen = []
    for kind in order:
        kept = [one for one in found.get(kind, []) if "result" in one[2]]
        if kind in found:
            chosen.append((kind, *(kept[len(kept) // 2] if kept else found[kind][0])))
    return chosen


def magnitude(values):
    return np.linalg.norm(values.reshape(len(values), -1, 3), axis=2).max(axis=1)


def curve(run, kind, reason):
    """The quantity by which a class is seen: its values, its name and unit, and whether it is drawn logarithmically."""
    if kind in ("energy_growing", "unsound_alone", "non_finite"):
        return np.asarray(run["kinetic_energy"][:]).reshape(len(run["time"]), -1).sum(axis=1), "kinetic energy, J", True
    if kind in ("penetrating", "passed_through"):
        return 1000 * np.asarray(run["penetration_depth"][:]).reshape(len(run["time"]), -1).max(axis=1), "depth, mm", False
    law = reason.split()[0]
    if "force" in run and law in list(run["law"].asstr()[:]):
        at = list(run["law"].asstr()[:]).index(law)
        return np.linalg.norm(np.asarray(run["force"][at]), axis=1), f"force of law {law}, N", False
    return magnitude(np.asarray(run["reaction_force"][:])), "reaction, N", False


def draw(axes, kind, folder, panel, cell):
    values = ", ".join(f"{axis['path'].split('.')[-1]} {value}" for axis, value in zip(panel["axes"], cell["values"]))
    reason = "" if "result" not in cell else "\n" + textwrap.shorten(cell["reason"], 75, placeholder=" ...")
    axes.set_title(f"{kind}: {panel['map']}, {panel['pipeline']}\n{values}{reason}", fontsize=7)
    axes.tick_params(labelsize=7)
    if "result" not in cell:
        axes.text(0.5, 0.5, "\n".join(textwrap.wrap(cell["reason"], 44)), ha="center", va="center", fontsize=8, transform=axes.transAxes)
        axes.set_xticks([])
        axes.set_yticks([])
        return
    with h5py.File(folder / cell["result"], "r") as file:
        run = file["pipelines"][panel["pipeline"]]
        times_s = np.asarray(run["time"][:])
        shown, name, logarithmic = curve(run, kind, cell["reason"])
    axes.plot(times_s, shown, color=COLOURS[kind], lw=1.2)
    if logarithmic and (shown > 0).any():
        axes.set_yscale("log")
    axes.set_ylabel(name, fontsize=7)
    axes.set_xlabel("time, s", fontsize=7)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", type=pathlib.Path, nargs="+")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="default: classes.png in the first folder")
    options = parser.parse_args()
    cells = cells_of(options.folders)
    columns = 3
    figure, places = plt.subplots(-(-len(cells) // columns), columns, figsize=(12, 2.6 * -(-len(cells) // columns)), squeeze=False)
    for axes in places.flat[len(cells):]:
        axes.axis("off")
    for axes, cell in zip(places.flat, cells):
        draw(axes, *cell)
    figure.tight_layout()
    output = options.output or options.folders[0] / "classes.png"
    figure.savefig(output, dpi=110)
    print(output)


if __name__ == "__main__":
    main()
