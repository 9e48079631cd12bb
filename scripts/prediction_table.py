#!/usr/bin/env python3
"""Moduli fitted to shallow presses of measured tissue, and what they predict of deeper ones; writes results/prediction.

    /usr/bin/python3 scripts/prediction_table.py [-j N] [--results FOLDER]

Writes README.md and prediction.png. --results keeps the simulations in a folder, and takes those that are there.
"""
import argparse
import concurrent.futures
import csv
import itertools
import json
import math
import pathlib
import tempfile

import h5py
import matplotlib
import numpy as np
import yaml

from references import ROOT, fissure
from theory_table import layer_force

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = ROOT / "results/prediction"
CURVES = ROOT / "configs/curves"
FITTED_M, MODULUS_PA, MARGIN_M = 0.0015, 1e4, 1e-5
FINE_DEEP_M, FINE_WIDE_M, GROWTH = 0.002, 0.004, 1.5
TISSUES = {  # file: name, radius of the tip in mm
    "silicone_phantom": ("silicone", 3.16),
    "liver_region_1": ("liver, region 1", 4.0),
    "liver_2_region_2": ("liver 2, region 2", 4.0),
    "liver_2_region_3": ("liver 2, region 3", 4.0),
}
BASE = {"cell_mm": 0.7, "nu": 0.49, "height_mm": 20, "wide_mm": 32, "material": "neo_hookean"}
COARSE = {"cell_mm": 1.0}
CHANGES = {"nothing": {}, "cells of 1.0 mm": COARSE}
CHANGES_3 = {"cells of 1.0 mm, nu 0.4": COARSE | {"nu": 0.4}, "cells of 1.0 mm, 40 mm thick": COARSE | {"height_mm": 40}, "cells of 1.0 mm, 24 mm wide": COARSE | {"wide_mm": 24}}
OFFSETS = {"F0": "E,F0", "d0": "E,d0"}
COLOURS = {"F0": "#D55E00", "d0": "#0072B2"}
ECOFLEX_KPA = {"00-10": (54.21, 2.38), "00-30": (97.26, 4.16), "00-50": (152.7, 4.8)}

PAGE = """# What a fitted modulus predicts

    /usr/bin/python3 scripts/prediction_table.py

Median forces of palpated tissue ([curves](../../configs/curves), figures taken from github.com/vu-arma-dev/robot-palpation-data) against a slow
simulated press: a frictionless sphere of the probe's radius (3.16 mm for silicone, 4 mm for liver), neo-Hookean tissue of nu 0.49, 20 mm thick,
bonded below, 32 mm wide. Neither thickness, hold, friction nor nu is in the data: they are assumed. `fissure fit CURVE --modulus RESULT
--most-depth 0.0015` fits Young's modulus and one offset to the three points up to 1.5 mm, and predicts the deeper ones. The probing counted depth
from where 0.05 to 0.08 N was felt, so an offset of the depth (d0) is nearer to what happened; one of the force (F0) is what fits of laws have.

{fits}
Intervals are 95 %, from the residuals of three points for two numbers: one degree of freedom, Student's t is 12.7. They say how little three points
hold. They leave out the scatter between probings: the modulus that goes through all lower or all upper quartiles instead is in the last column.

![Measured and predicted forces](prediction.png)

## Where it holds, and where it fails

{verdicts}

{why}

## Silicone beside other moduli

{silicone}
Ecoflex by github.com/abubakardawood/phantom-material-database (CC BY 4.0): {ecoflex}.
What the palpated phantom was cast from is not known; {nearest}. The offset d0 is not free of E: with another one of
the same misfit E would lie elsewhere in its interval.

## What the assumptions change

E with an offset of the depth, by what else was simulated, and the force predicted at the deepest point.

{assumptions}
{mesh}
"""


def axis(cell_m, fine_m, end_m):
    """Coordinates from 0: cells of one size up to fine_m, then each larger by GROWTH, stretched to end at end_m."""
    fine = cell_m * np.arange(math.ceil(fine_m / cell_m) + 1)
    steps = cell_m * GROWTH ** np.arange(1, 40)
    count = int(np.argmax(fine[-1] + np.cumsum(steps) >= end_m)) + 1
    steps = steps[:count] * (end_m - fine[-1]) / steps[:count].sum()
    return np.concatenate([fine, fine[-1] + np.cumsum(steps)])


def write_block(path, cell_m, height_m, wide_m):
    """A block whose upper side is y = 0, of cubes of six tetrahedra, fine around its middle; its own mirror image in x and z."""
    half = axis(cell_m, FINE_WIDE_M, wide_m / 2)
    x, y = np.concatenate([-half[:0:-1], half]), -axis(cell_m, FINE_DEEP_M, height_m)
    points = np.array([[a, b, c] for c in x for b in y for a in x])
    tetrahedra = []
    for k, j, i in itertools.product(range(len(x) - 1), range(len(y) - 1), range(len(x) - 1)):
        for order in itertools.permutations(range(3)):
            corner, corners = [0, 0, 0], []
            for axis_done in (None, *order):
                if axis_done is not None:
                    corner[axis_done] = 1
                a = i + (corner[0] if x[i] > -1e-12 else 1 - corner[0])
                c = k + (corner[2] if x[k] > -1e-12 else 1 - corner[2])
                corners.append((c * len(y) + j + corner[1]) * len(x) + a)
            p = points[corners]
            if np.dot(np.cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) < 0:
                corners[:2] = corners[1::-1]
            tetrahedra.append(corners)
    with open(path, "w") as file:
        file.write(f"# vtk DataFile Version 3.0\nblock\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {len(points)} double\n")
        file.writelines("%.9g %.9g %.9g\n" % tuple(point) for point in points)
        file.write(f"CELLS {len(tetrahedra)} {5 * len(tetrahedra)}\n")
        file.writelines("4 %d %d %d %d\n" % tuple(corners) for corners in tetrahedra)
        file.write(f"CELL_TYPES {len(tetrahedra)}\n" + "10\n" * len(tetrahedra))


def pressed(arguments, folder, radius_mm, change):
    """The result of a sphere that sinks 4 mm into the block."""
    case = {**BASE, **change}
    name = f"r{radius_mm:g}_cell{case['cell_mm']:g}_nu{case['nu']:g}_h{case['height_mm']:g}_w{case['wide_mm']:g}".replace(".", "_")
    result = folder / f"{name}.h5"
    if result.exists():
        return result
    write_block(folder / f"{name}.vtk", case["cell_mm"] / 1000, case["height_mm"] / 1000, case["wide_mm"] / 1000)
    radius_m = radius_mm / 1000
    start_m = radius_m + MARGIN_M + 1e-6
    scenario = {
        "format": 1,
        "name": name,
        "description": "A slow press.",
        "time": {"step_s": 0.0005},
        "world": {"gravity_m_s2": [0, 0, 0]},
        "bodies": [
            {
                "name": "block",
                "shape": {"type": "tetrahedra", "file": f"{name}.vtk", "unit": "m"},
                "model": "elastic",
                "margin_m": MARGIN_M,
                "elastic": {"youngs_modulus_Pa": MODULUS_PA, "poissons_ratio": case["nu"], "material": case["material"], "viscosity_Pa_s": 2},
                "fixed": [{"below_m": 1e-4 - case["height_mm"] / 1000}],
            }
        ],
        "tools": [
            {
                "name": "tip",
                "shape": {"type": "sphere", "radius_m": radius_m, "subdivisions": 4},
                "friction": 0,
                "motion": {
                    "type": "script",
                    "start_m": [0, start_m, 0],
                    "segments": [{"move_to_m": [0, start_m - 0.004, 0], "speed_m_s": 0.025, "timing": "minimum_jerk"}],
                },
            }
        ],
        "pipelines": [{"pipeline": "swept"}],
    }
    (folder / f"{name}.yaml").write_text(yaml.safe_dump(scenario))
    fissure(arguments, "run", folder / f"{name}.yaml", "-o", result, "--no-frames", "-j", 1)
    print(f"simulated: {name}", flush=True)
    return result


def fitted(arguments, curve, result, free):
    return json.loads(fissure(arguments, "fit", curve, "--modulus", result, "--most-depth", FITTED_M, "--free", free, "--json").stdout)["curves"][0]["fits"][0]


def measured(name):
    """Depths in m and forces in N: median, lower and upper quartile."""
    lines = [line for line in (CURVES / f"{name}.csv").read_text().splitlines() if not line.startswith("#")]
    rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]
    return np.array([[row["depth_mm"] / 1000, row["force_N"], row["lower_quartile_N"], row["upper_quartile_N"]] for row in rows]).T


def quartile_fit(arguments, folder, name, quartile, result, free):
    depths_m, median_N, lower_N, upper_N = measured(name)
    path = folder / f"{name}_{quartile}.csv"
    forces_N = lower_N if quartile == "lower" else upper_N
    rows = zip(1000 * depths_m, forces_N, (upper_N - lower_N) / 1.35)
    path.write_text("depth_mm,force_N,sigma_N\n" + "".join(f"{d:g},{f:g},{s:g}\n" for d, f, s in rows))
    return fitted(arguments, path, result, free)["parameters"]["E"]["value"]


def simulated_curve(result):
    """Depth and force of the press, as `fissure fit` counts them."""
    with h5py.File(result) as file:
        run = file["pipelines/swept"]
        height_m, force_N = run["tool_position"][:, 0, 1], run["reaction_force"][:, 1]
    start = max(int(np.argmax(force_N != 0)) - 1, 0)
    return height_m[start] - height_m[start:], force_N[start:]


def theory_fit(name, force):
    """E of force(d) at 1 Pa by weighted least squares with an offset of the depth, over the fitted depths."""
    depths_m, median_N, lower_N, upper_N = measured(name)
    near = depths_m <= FITTED_M + 1e-9
    weights = 1 / (upper_N[near] - lower_N[near]) ** 2
    best = (math.inf, 0, 0)
    for offset_m in np.arange(0, 0.0015, 1e-5):
        unit_N = np.array([force(d + offset_m) for d in depths_m[near]])
        modulus = (weights * unit_N * median_N[near]).sum() / (weights * unit_N**2).sum()
        best = min(best, ((weights * (modulus * unit_N - median_N[near]) ** 2).sum(), modulus, offset_m))
    return best[1], best[2]


def number(value, factor=1.0, digits=3):
    return f"{factor * value:.{digits}g}" if math.isfinite(value) else "unbounded"


def verdict(point):
    if point["predicted_N"] < point["lower_quartile_N"]:
        return "below"
    return "above" if point["predicted_N"] > point["upper_quartile_N"] else "within"


def predicted_cell(point):
    if point is None:
        return "-"
    quartiles = f"{point['measured_N']:.3g} [{point['lower_quartile_N']:.3g}, {point['upper_quartile_N']:.3g}]"
    return f"{point['predicted_N']:.3g}, measured {quartiles}: {verdict(point)}"


def at(fit, depth_m):
    return next((point for point in fit["predictions"] if abs(point["depth_m"] - depth_m) < 1e-9), None)


def heading(*columns):
    return "| " + " | ".join(columns) + " |\n|" + "---|" * len(columns) + "\n"


def fits_table(fits, ranges):
    lines = [heading("tissue", "offset", "E [kPa] (95 %)", "offset fitted", "correlation", "2 mm [N]", "3 mm [N]", "E through quartiles [kPa]")]
    for (name, offset), fit in fits.items():
        modulus, moved = fit["parameters"]["E"], fit["parameters"][offset]
        unit = "N" if offset == "F0" else "mm"
        cells = [TISSUES[name][0], offset]
        cells.append(f"{number(modulus['value'], 1e-3)} ({number(modulus['low'], 1e-3)} to {number(modulus['high'], 1e-3)})")
        cells.append(f"{number(moved['value'], 1 if offset == 'F0' else 1e3)} {unit}")
        cells.append(f"{fit['correlation'][f'E,{offset}']:.2f}")
        cells += [predicted_cell(at(fit, depth_m)) for depth_m in (0.002, 0.003)]
        cells.append(" to ".join(number(value, 1e-3) for value in ranges[name, offset]))
        lines.append("| " + " | ".join(cells) + " |\n")
    return "".join(lines)


def verdicts_text(fits):
    lines = []
    for name, (words, _) in TISSUES.items():
        parts = []
        for offset in OFFSETS:
            for point in fits[name, offset]["predictions"]:
                change = 100 * (point["predicted_N"] / point["measured_N"] - 1)
                parts.append(f"{1000 * point['depth_m']:g} mm, {offset}: {change:+.0f} % of the median, {verdict(point)} the quartiles")
        lines.append(f"* {words}: " + "; ".join(parts) + ".")
    return "\n".join(lines)


def why_text(fits):
    livers = [fit for (name, _), fit in fits.items() if name.startswith("liver")]
    points = [point for fit in livers for point in fit["predictions"]]
    below = sum(verdict(point) == "below" for point in points)
    deep = [point["predicted_N"] / point["measured_N"] - 1 for point in points if abs(point["depth_m"] - 0.003) < 1e-9]
    return (
        f"Liver stiffens: its forces grow as d^2.4 to d^2.95, a neo-Hookean solid's as about d^1.4. Of {len(points)} predictions for liver {below} lie below the\n"
        f"quartiles, those at 3 mm by {-100 * max(deep):.0f} to {-100 * min(deep):.0f} % below the median. A modulus fitted at 1.5 mm is no modulus of liver at 3 mm: no E and no offset mends\n"
        "that; a material that stiffens is needed, which elastic bodies here do not have."
    )


def silicone_table(fits):
    radius_m = TISSUES["silicone_phantom"][1] / 1000
    hertz = lambda d_m: 4 / 3 / (1 - BASE["nu"] ** 2) * math.sqrt(radius_m) * d_m**1.5
    layer = lambda d_m: layer_force(1, BASE["nu"], radius_m, d_m, BASE["height_mm"] / 1000)[0]
    rows = {f"simulation, {offset}": fits["silicone_phantom", offset]["parameters"]["E"]["value"] for offset in OFFSETS}
    rows["Hertz (half-space), d0"] = theory_fit("silicone_phantom", hertz)[0]
    rows["bonded layer of 20 mm, linear theory, d0"] = theory_fit("silicone_phantom", layer)[0]
    return heading("E of", "kPa") + "".join(f"| {name} | {value / 1000:.1f} |\n" for name, value in rows.items())


def nearest_text(fits):
    modulus_kPa = fits["silicone_phantom", "d0"]["parameters"]["E"]["value"] / 1000
    below = [name for name, (kPa, _) in ECOFLEX_KPA.items() if kPa <= modulus_kPa]
    above = [name for name, (kPa, _) in ECOFLEX_KPA.items() if kPa > modulus_kPa]
    if below and above:
        return f"its {modulus_kPa:.0f} kPa lie between those of {below[-1]} and {above[0]}"
    return f"its {modulus_kPa:.0f} kPa lie {'above all' if below else 'below all'} of these"


def assumptions_table(rows):
    lines = [heading("tissue", "changed", "E [kPa]", "d0 [mm]", "RMS of the fit [N]", "predicted at the deepest point [N]")]
    for name, changed, fit in rows:
        parameters, deepest = fit["parameters"], fit["predictions"][-1]
        cells = [TISSUES[name][0], changed, number(parameters["E"]["value"], 1e-3), number(parameters["d0"]["value"], 1e3)]
        cells += [f"{fit['rms_N']:.2g}", f"{deepest['predicted_N']:.3g} ({1000 * deepest['depth_m']:g} mm, measured {deepest['measured_N']:.3g})"]
        lines.append("| " + " | ".join(cells) + " |\n")
    return "".join(lines)


def mesh_text(results):
    lines = []
    for radius_mm in sorted({radius for _, radius in TISSUES.values()}):
        (fine_m, fine_N), (coarse_m, coarse_N) = (simulated_curve(results[radius_mm, name]) for name in list(CHANGES)[:2])
        parts = []
        for depth_mm in (1, 2, 3):
            fine, coarse = np.interp(depth_mm / 1000, fine_m, fine_N), np.interp(depth_mm / 1000, coarse_m, coarse_N)
            exact = layer_force(MODULUS_PA, BASE["nu"], radius_mm / 1000, depth_mm / 1000, BASE["height_mm"] / 1000)[0]
            parts.append(f"at {depth_mm} mm {100 * (coarse / fine - 1):+.1f} % (the fine one {100 * (fine / exact - 1):+.1f} % from linear theory)")
        lines.append(f"Radius {radius_mm:g} mm, force on cells of 1.0 mm instead of {BASE['cell_mm']:g} mm: " + ", ".join(parts) + ".")
    lines.append(
        "\nA mesh of cells as wide as the contact is too stiff, so E at shallow depths is too low by about that. Linear theory of a paraboloid is itself no truth at\n"
        "3 mm of a 3 to 4 mm sphere."
    )
    return "\n".join(lines)


def draw(path, fits, results):
    figure, axes = plt.subplots(1, len(TISSUES), figsize=(15, 3.8))
    for panel, (name, (words, radius_mm)) in zip(axes, TISSUES.items()):
        depths_m, median_N, lower_N, upper_N = measured(name)
        panel.errorbar(1000 * depths_m, median_N, [median_N - lower_N, upper_N - median_N], fmt="ko", markersize=4, capsize=3, label="measured, quartiles")
        curve_m, curve_N = simulated_curve(results[radius_mm, "nothing"])
        for offset, colour in COLOURS.items():
            values = {key: value["value"] for key, value in fits[name, offset]["parameters"].items()}
            d_m = np.linspace(0, depths_m[-1], 200)
            force_N = values["E"] / MODULUS_PA * np.interp(d_m + values["d0"], curve_m, curve_N) + values["F0"]
            near = d_m <= FITTED_M
            panel.plot(1000 * d_m[near], force_N[near], "-", color=colour, label=f"E, {offset}: {values['E'] / 1000:.3g} kPa")
            panel.plot(1000 * d_m[~near], force_N[~near], "--", color=colour)
        panel.axvline(1000 * FITTED_M, color="grey", linewidth=0.8, linestyle=":")
        panel.set(title=f"{words}, tip of {radius_mm:g} mm", xlabel="depth [mm]", ylim=(0, None))
        panel.legend(frameon=False, fontsize=8, loc="upper left")
        panel.grid(alpha=0.3)
    axes[0].set_ylabel("force [N]")
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def make(arguments, folder):
    wanted = {(radius, name): change for radius in sorted({radius for _, radius in TISSUES.values()}) for name, change in CHANGES.items()}
    wanted |= {(TISSUES["silicone_phantom"][1], name): change for name, change in CHANGES_3.items()}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        running = {key: pool.submit(pressed, arguments, folder, key[0], change) for key, change in wanted.items()}
        results = {key: run.result() for key, run in running.items()}
    fits, ranges, assumptions = {}, {}, []
    for name, (_, radius_mm) in TISSUES.items():
        result = results[radius_mm, "nothing"]
        for offset, free in OFFSETS.items():
            fits[name, offset] = fitted(arguments, CURVES / f"{name}.csv", result, free)
            ranges[name, offset] = [quartile_fit(arguments, folder, name, quartile, result, free) for quartile in ("lower", "upper")]
        for (radius, changed), other in results.items():
            if radius == radius_mm:
                assumptions.append((name, changed, fitted(arguments, CURVES / f"{name}.csv", other, "E,d0")))
    ecoflex = ", ".join(f"{name} {kPa:.1f} +- {spread:.1f} kPa" for name, (kPa, spread) in ECOFLEX_KPA.items())
    FOLDER.mkdir(parents=True, exist_ok=True)
    draw(FOLDER / "prediction.png", fits, results)
    page = PAGE.format(
        fits=fits_table(fits, ranges),
        verdicts=verdicts_text(fits),
        why=why_text(fits),
        silicone=silicone_table(fits),
        ecoflex=ecoflex,
        nearest=nearest_text(fits),
        assumptions=assumptions_table(assumptions),
        mesh=mesh_text(results),
    )
    (FOLDER / "README.md").write_text(page)
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}, prediction.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("--results", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.results:
        arguments.results.mkdir(parents=True, exist_ok=True)
        make(arguments, arguments.results.resolve())
    else:
        with tempfile.TemporaryDirectory() as folder:
            make(arguments, pathlib.Path(folder))


if __name__ == "__main__":
    main()
