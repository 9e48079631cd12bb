#!/usr/bin/env python3
"""The picture of a study of accuracy and cost: error over cost, its fronts, and how well the reference is known.

    fissure study tradeoff configs/studies/tradeoff_quick.yaml
    /usr/bin/python3 scripts/study_front.py out/tradeoff_quick -o front.png
    /usr/bin/python3 scripts/study_front.py out/tradeoff_quick --tables          # as Markdown, on standard output; no picture

One panel for each quantity. Points are medians over repeats, bars reach from the lower to the upper quartile. The line joins the front of the
panel: what no cheaper setting beats. Below the grey line is less than the reference's own error: nothing there is told apart, and the front ends on
it. A quantity whose reference was refused has no points, and says why.
"""
import argparse
import json
import pathlib
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

MILLI = {"m": (1e3, "mm"), "N": (1, "N")}
MARKERS = "os^DvPX*<>hp"


def front(points):
    """Of (cost, error): those that no other beats, from the cheapest on; errors within a percent are the same."""
    best, found = None, []
    for cost, error in sorted(points):
        if best is None or error < best / 1.01:
            best = error
            found.append((cost, error))
    return found


def judged(study, quantity):
    """(pipeline, cost, low, high, error) of each setting with both."""
    for setting in study["settings"]:
        cost, error = setting["cost"][study["cost"]], setting["errors"][quantity]["counts"]
        if cost["median"] is not None and error is not None:
            yield setting["pipeline"], cost["median"], cost["low"], cost["high"], error


def draw(axes, study, quantity, colours):
    references = [r for r in study["references"] if r["quantity"] == quantity]
    scale, unit = MILLI[references[0]["units"]]
    axes.set_title(quantity)
    axes.set_xlabel("step time for a simulated ms, us" + (" (p99)" if study["cost"].startswith("p99") else ""))
    axes.set_ylabel(f"error ({references[0]['measure']}), {unit}")
    kept = [r for r in references if not r["refused"]]
    if not kept:
        axes.set(xticks=[], yticks=[], xlabel="", ylabel="")
        axes.minorticks_off()
        why = "reference refused:\n" + "\n".join(textwrap.wrap(references[0]["refused"], 42))
        axes.text(0.5, 0.5, why, ha="center", va="center", transform=axes.transAxes, fontsize=9, color="0.3")
        return
    axes.set_xscale("log")
    points = [(name, cost, low, high, error * scale) for name, cost, low, high, error in judged(study, quantity)]
    floors = [r["own_error"] * scale for r in kept]
    above = [p[4] for p in points if p[4] > 0] + [floor for floor in floors if floor > 0]
    least = min(above, default=1) / 2
    axes.set_yscale("symlog", linthresh=least)
    for name in colours:
        own = [p for p in points if p[0] == name]
        if not own:
            continue
        colour, marker = colours[name]
        x = [p[1] for p in own]
        bars = [[p[1] - p[2] for p in own], [p[3] - p[1] for p in own]]
        axes.errorbar(x, [p[4] for p in own], xerr=bars, fmt=marker, color=colour, ms=6, lw=1, alpha=0.8)
    floor_of = {r["pipeline"]: floor for r, floor in zip(kept, floors)}
    line = front([(p[1], max(p[4], floor_of.get(p[0], floors[0]))) for p in points])
    axes.plot(*zip(*line), color="black", lw=1, drawstyle="steps-post", zorder=0)
    for floor in set(floors):
        axes.axhline(floor, color="0.6", ls="--", lw=1)
        axes.axhspan(0, floor, color="0.92", zorder=-1)
    axes.set_ylim(bottom=-least / 3)
    if not above:  # all are 0
        axes.set(yscale="linear", ylim=(-1, 1), yticks=[0])
    axes.grid(alpha=0.25)


def text_of(value, scale=1.0):
    return "-" if value is None else f"{scale * value:.3g}"


def print_references(study):
    print("| quantity | pipeline | peak | own error | order | |\n|---|---|---|---|---|---|")
    for r in study["references"]:
        scale, unit = MILLI[r["units"]]
        own = "" if r["refused"] else f"{text_of(r['own_error'], scale)} {unit}"
        order = "" if r["refused"] else text_of(r["order"])
        print(f"| {r['quantity']} | {r['pipeline']} | {text_of(r['peak'], scale)} {unit} | {own} | {order} | {r['refused']} |")


def print_settings(study):
    """A row for each setting, the cheapest first; errors of refused references are differences, in brackets."""
    refused = {r["quantity"] for r in study["references"] if r["refused"]}
    units = {r["quantity"]: MILLI[r["units"]] for r in study["references"]}
    paths = list(study["settings"][0]["values"])
    head = ["pipeline"] + paths + ["us per ms", "p99 of a step, us", "MiB"] + [f"{q}, {unit}" for q, (_, unit) in units.items()] + ["front"]
    print("\n| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    cost = study["cost"]
    for s in sorted(study["settings"], key=lambda s: (s["cost"][cost]["median"] is None, s["cost"][cost]["median"])):
        spread = s["cost"][cost]
        cells = [s["pipeline"]] + [s["values"][path] for path in paths]
        cells += [f"{text_of(spread['median'])} ({text_of(spread['low'])} to {text_of(spread['high'])})"]
        cells += [text_of(s["cost"]["p99_us_per_step"]["median"]), text_of(s["cost"]["memory_mib"]["median"])]
        for quantity, (scale, _) in units.items():
            error = text_of(s["errors"][quantity]["counts"], scale)
            cells.append(f"({text_of(s['errors'][quantity]['rms'], scale)})" if quantity in refused else error)
        print("| " + " | ".join(cells + ["yes" if s["front"] else ""]) + " |")


def print_orders(study):
    known = [o for o in study["orders"] if o["order"]["median"] is not None]
    if known:
        print("\n| error of | pipeline | along | order |\n|---|---|---|---|")
    for o in known:
        print(f"| {o['quantity']} | {o['pipeline']} | {o['path']} | {text_of(o['order']['median'])} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", type=pathlib.Path, help="folder of a study, or its tradeoff.json")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="picture; default: front.png in the folder")
    parser.add_argument("--tables", action="store_true", help="references, settings and orders as Markdown, instead of the picture")
    options = parser.parse_args()
    file = options.study / "tradeoff.json" if options.study.is_dir() else options.study
    try:
        study = json.loads(file.read_text())
        quantities = list(dict.fromkeys(r["quantity"] for r in study["references"]))
    except (OSError, ValueError, KeyError, TypeError) as error:
        parser.error(f"{file}: expected what fissure study tradeoff writes ({error})")
    if options.tables:
        print_references(study)
        print_settings(study)
        print_orders(study)
        return
    names = list(dict.fromkeys(s["pipeline"] for s in study["settings"]))
    colours = {name: (f"C{i % 10}", MARKERS[i % len(MARKERS)]) for i, name in enumerate(names)}
    columns = min(2, len(quantities))
    rows = -(-len(quantities) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(5.6 * columns, 4 * rows + 0.6), squeeze=False)
    for panel in axes.flat[len(quantities):]:
        panel.set_axis_off()
    for panel, quantity in zip(axes.flat, quantities):
        draw(panel, study, quantity, colours)
    handles = [Line2D([], [], color=c, marker=m, ls="") for c, m in colours.values()]
    handles += [Line2D([], [], color="black", lw=1), Line2D([], [], color="0.6", ls="--", lw=1)]
    figure.legend(handles, names + ["front", "the reference's own error"], loc="lower center",
                  ncol=min(6, len(handles)), frameon=False, fontsize=9)
    figure.suptitle(f"{study['study']}: {study['description']}", fontsize=11)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    output = options.output or file.parent / "front.png"
    output.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(output, dpi=110)
    print(output)


if __name__ == "__main__":
    main()
