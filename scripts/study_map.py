#!/usr/bin/env python3
"""Draws the maps of a study of stability: study_map.py FOLDER [-o PICTURE] [--map NAME ...]

FOLDER is what `fissure study stability` has filled. A panel is a map through a pipeline: its last axis goes to the right, the other one
up, a dot is a run in the colour of its class, a black bar the boundary between two classes, between the runs nearest to it."""
import argparse
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = {
    "refused": "#4a4a8a",
    "crashed": "#000000", "too_slow": "#7f7f7f", "non_finite": "#8c1515", "unsound_alone": "#9467bd", "passed_through": "#d62728",
    "penetrating": "#ff7f0e", "energy_growing": "#e377c2", "chattering": "#e8c400", "force_out_of_range": "#17becf",
    "untouched": "#ffffff", "stable": "#2ca02c", None: "#dddddd"}
HALF = 0.32     # of a row


def rows_of(panel):
    """The values of the first of two axes, as text, from bottom to top; one row without a name for a single axis."""
    if len(panel["axes"]) == 1:
        return [""]
    return sorted({cell["values"][0] for cell in panel["cells"]}, key=lambda text: (not number(text), number(text) or 0, text))


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def draw(axes, panel):
    rows = rows_of(panel)
    last = panel["axes"][-1]
    places = {text: i for i, text in enumerate(cell["values"][-1] for cell in panel["cells"])} if last["scale"] == "values" else None
    for cell in panel["cells"]:
        row = rows.index(cell["values"][0]) if len(panel["axes"]) > 1 else 0
        x = places[cell["values"][-1]] if places else float(cell["values"][-1])
        axes.plot(x, row, "o", ms=11 if cell["round"] == 0 else 5, color=COLOURS[cell["class"]], mec="black", mew=0.4)
    labelled = []
    for boundary in panel["boundaries"]:
        row = rows.index(boundary["others"][0]) if boundary["others"] else 0
        middle = (boundary["below"] * boundary["above"]) ** 0.5 if boundary["below"] > 0 else (boundary["below"] + boundary["above"]) / 2
        axes.plot([middle, middle], [row - HALF, row + HALF], color="black", lw=1.6)
        labelled.append((row, middle))
    if last["scale"] == "logarithmic":
        axes.set_xscale("log")
    shown = []                              # labels that would cover each other are left out
    for row, middle in sorted(labelled):
        at = axes.transAxes.inverted().transform(axes.transData.transform((middle, row)))[0]
        if not shown or shown[-1][0] != row or at - shown[-1][1] > 0.03:
            axes.annotate(f"{middle:.3g}", (middle, row + HALF), ha="center", va="bottom", fontsize=6, rotation=90)
            shown.append((row, at))
    if places:
        axes.set_xticks(list(places.values()), list(places))
    axes.set_yticks(range(len(rows)), [f"{float(row):g}" if number(row) is not None else row for row in rows])
    axes.set_ylim(-0.6, len(rows) + 0.05)
    axes.set_xlabel(last["path"], fontsize=8)
    axes.set_ylabel(panel["axes"][0]["path"] if len(rows) > 1 else "", fontsize=7)
    axes.set_title(f"{panel['map']}, {panel['pipeline']}", fontsize=9)
    axes.tick_params(which="both", labelsize=7)
    axes.grid(alpha=0.25)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, help="default: maps.png in the folder")
    parser.add_argument("--map", action="append", help="this map alone; may be given again")
    options = parser.parse_args()
    study = json.loads((options.folder / "study.json").read_text(encoding="utf-8"))
    panels = [panel for panel in study["panels"] if not options.map or panel["map"] in options.map]
    if not panels:
        parser.error("no map of this name in study.json, expected one of " + ", ".join(sorted({p["map"] for p in study["panels"]})))
    columns = min(2, len(panels))
    lines = [panels[i:i + columns] for i in range(0, len(panels), columns)]
    heights = [max(len(rows_of(panel)) for panel in line) * 0.5 + 1.1 for line in lines]
    figure, grid = plt.subplots(len(lines), columns, figsize=(6.4 * columns, sum(heights) + 0.6), squeeze=False,
                                gridspec_kw={"height_ratios": heights})
    for line, of_grid in zip(lines, grid):
        for axes in of_grid[len(line):]:
            axes.axis("off")
        for panel, axes in zip(line, of_grid):
            draw(axes, panel)
    seen = {cell["class"] for panel in panels for cell in panel["cells"]}
    marks = [plt.Line2D([], [], marker="o", ls="", color=COLOURS[name], mec="black", mew=0.4, label=name or "not run")
             for name in COLOURS if name in seen]
    figure.legend(handles=marks, loc="upper center", ncol=6, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.5 / figure.get_figheight()))
    output = options.output or options.folder / "maps.png"
    figure.savefig(output, dpi=110)
    print(output)


if __name__ == "__main__":
    main()
