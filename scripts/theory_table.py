#!/usr/bin/env python3
"""Elastic bodies against closed forms: a sphere on a bonded layer, and a ball that falls on the ground; writes results/theory.

    /usr/bin/python3 scripts/theory_table.py [-j N]

Writes README.md, layer.csv, drop.csv and theory.png.
"""
import argparse
import concurrent.futures
import csv
import math
import pathlib
import tempfile

import h5py
import matplotlib
import numpy as np
import yaml

from references import ROOT, fissure

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = ROOT / "results/theory"
HEIGHT_M, MARGIN_M = 0.06, 1e-5
REACH = 4  # contact radii to each side, at least
LAYERS = [3, 6, 9]  # cells over the height
FINEST = 12  # of some series: minutes
LOADING_S, HOLD_S = 0.3, 0.12  # at 10 kPa; as long in transits of a shear wave at other moduli
STEPS_S = {3: 0.003, 6: 0.0016, 9: 0.00105, 12: 0.0008}  # one substep a step at nu 0.3
FINE = [{}, {"R_m": 0.2}]
BASE = {"R_m": 0.4, "d_m": 0.0015, "E_Pa": 1e4, "nu": 0.3, "material": "neo_hookean", "layers": 6}
SERIES = [  # what a convergence is shown for
    {"nu": 0.1},
    {},
    {"nu": 0.45},
    {"nu": 0.451},
    {"nu": 0.49},
    {"R_m": 0.2},
    {"R_m": 0.2, "d_m": 0.003},
    {"material": "linear_corotated"},
]
SINGLES = {  # one mesh, beside BASE on the same
    "R 100 mm, d 3 mm": {"R_m": 0.1, "d_m": 0.003},
    "R 200 mm, d 6 mm": {"R_m": 0.2, "d_m": 0.006},
    "R 200 mm, d 3 mm, linear_corotated": {"R_m": 0.2, "d_m": 0.003, "material": "linear_corotated"},
    "R 800 mm, d 0.75 mm": {"R_m": 0.8, "d_m": 0.00075},
    "E 1 kPa": {"E_Pa": 1e3},
    "E 1 MPa": {"E_Pa": 1e6},
    "layer 360 mm wide instead of 240 mm": {"side_m": 0.36},
    "loaded in half the time": {"loading": 0.5},
    "loaded in twice the time": {"loading": 2},
    "no viscosity": {"viscosity": 0},
    "linear_corotated": {"material": "linear_corotated"},
    "margin 0.5 mm": {"margin_m": 5e-4},
    "tool of half as many rings": {"rings": 10},
    "step 0.8 ms": {"step_s": 0.0008},
}
DROP_STEPS_S = [0.004, 0.002, 0.001, 0.0005, 0.00025]
VISCOSITIES_PA_S = [0, 2]
COLOURS = {0.1: "#0072B2", 0.3: "#009E73", 0.45: "#E69F00", 0.451: "#CC79A7", 0.49: "#D55E00"}


PAGE = """# Elastic bodies against theory

    /usr/bin/python3 scripts/theory_table.py

## A sphere on a bonded layer

A frictionless rigid sphere of radius R sinks d deep into a layer that is 60 mm high, held below and free at its sides, at least four contact radii
to each side; pipeline `swept`, no gravity, E 10 kPa unless said otherwise. Cells are cubes of six tetrahedra, at most {tetrahedra} of these. The
tool is the part of the sphere around its lowest point, 20 rings of triangles; R and d count the contact's margin of 0.01 mm. It sinks for 0.3 s
(minimum jerk) and rests; the force is the mean reaction of the rest, in which it swings by at most {swing}. Elements inverted in all runs together:
{inverted}; the energy balance of each closes to {balance}.

**The exact solution** is the linear theory's: the Fredholm equation of Lebedev and Ufliand (1958) with the kernel of a bonded layer, solved for a
sphere in the script. Dimitriadis et al. 2002 expand it in chi = sqrt(R d)/h (for nu 0.5: 1 + 1.133 chi + 1.283 chi^2 + 0.769 chi^3 + 0.098 chi^4;
their general formula, used here, says -0.098). Both have the same first term; the expansion falls below the solution as chi grows: at chi 0.41 by
2.9 % at nu 0.3 and 5.2 % at nu 0.49, at 0.58 by 5 and 10 %. Errors are from the exact solution; the last column is what they would be from the
expansion.

{series}
Order and limit are those of F + C cell^order through the three finest meshes. Limits are {limits} from the exact solution, the finest meshes
{finest}. The error goes with the contact radius over the cell (plot), for all R, d and nu alike: a mesh knows the contact's edge to a cell, and one
of three cells over the height does not resolve the contact.

![Force over the contact radius in cells, and limits beside theory](theory.png)

## What else changes the force

The layer of R 400 mm, d 1.5 mm, nu 0.3 on cells of 10 mm with one change each.

{singles}
The modulus scales the force and nothing else (times go with the transit of shear waves). What width, loading, viscosity, margin, step and the
tool's rings change is below the errors of the mesh. `linear_corotated` is softer than `neo_hookean` under compression by a share that grows with
d/h, so that both meet at small strain, 0.8 % apart at d/h 0.025 and 1.7 % at 0.05.

## Nearly incompressible tissue

Above nu 0.45 elements take their pressure from nodal averages of the volume ratio (src/simulation/elastic/elastic_tissue.h), at 0.45 each has its
own. The rows of 0.45 and 0.451, between which theory changes the force by {ratio_theory:.2f} %, show what averaging takes away: {averaged}. At nu
0.49 the error is no larger than at 0.3 on the same mesh: nothing locks.

## A ball that falls and rebounds

A ball of 30 mm (4,096 tetrahedra, E 10 kPa, nu 0.4) falls 30 mm on the ground. Shares of the fall's energy at the top of the rebound; vibration is
kinetic and stored energy then; the last column is the greatest error of the balance up to 0.32 s.

{drops}
The rebound differs by {rebound} between steps of 4 and 0.25 ms. The balance closes to {balance_worst:.2f} % in every
run, those without viscosity included, where the ball vibrates on and its number of substeps rises with its stretch.
"""


def series_factor(nu, chi):
    """Force over Hertz's as Dimitriadis et al. 2002 (Biophysical Journal 82) expand it for a bonded layer."""
    a0 = -(1.2876 - 1.4678 * nu + 1.3442 * nu**2) / (1 - nu)
    b0 = (0.6387 - 1.0277 * nu + 1.5164 * nu**2) / (1 - nu)
    pi = math.pi
    terms = [1, -2 * a0 / pi, 4 * a0**2 / pi**2, -8 / pi**3 * (a0**3 + 4 * pi**2 / 15 * b0), 16 * a0 / pi**4 * (a0**3 + 3 * pi**2 / 5 * b0)]
    return sum(term * chi**power for power, term in enumerate(terms))


def compliance(u, nu):
    """Surface compliance of a bonded layer over that of the half-space, of the wave number times the height."""
    kappa, e = 3 - 4 * nu, np.exp(-2 * u)
    return (2 * kappa * (1 - e * e) - 8 * u * e) / (2 * kappa * (1 + e * e) + 2 * e * (4 * u * u + 1 + kappa**2))


def layer_force(E_Pa, nu, R_m, d_m, h_m=HEIGHT_M, points=48):
    """Force, N, and contact radius, m, of a frictionless rigid sphere on a bonded layer, linear elasticity: the Fredholm equation of
    Lebedev and Ufliand (1958) with the layer's kernel, collocated at Gauss points; the radius is where the pressure ends at zero."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    u, u_weights = 20 * (nodes + 1), 20 * weights * (1 - compliance(20 * (nodes + 1), nu))
    nodes, weights = np.polynomial.legendre.leggauss(points)

    def solved(a_m):
        x = np.append(a_m * (nodes + 1) / 2, a_m)
        waves = np.cos(np.outer(x / h_m, u))
        kernel = 2 / (math.pi * h_m) * (waves * u_weights) @ waves[:-1].T * (a_m * weights / 2)
        given = d_m - x * np.arctanh(x / R_m)
        density = np.linalg.solve(np.eye(points) - kernel[:-1], given[:-1])
        return given[-1] + kernel[-1] @ density, 2 * E_Pa / (1 - nu**2) * (a_m * weights / 2) @ density

    low_m, high_m = 0, min(3 * math.sqrt(R_m * d_m), 0.99 * R_m)
    for _ in range(60):
        a_m = (low_m + high_m) / 2
        low_m, high_m = (a_m, high_m) if solved(a_m)[0] > 0 else (low_m, a_m)
    return solved(a_m)[1], a_m


def hertz_N(case):
    return 4 * case["E_Pa"] * math.sqrt(case["R_m"]) * case["d_m"] ** 1.5 / (3 * (1 - case["nu"] ** 2))


def simulated(arguments, scenario):
    """The swept run of a scenario: its attributes, and its series as arrays."""
    scenario = {"format": 1, "name": "theory", "description": "Theory.", "pipelines": [{"pipeline": "swept"}], **scenario}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "theory.yaml").write_text(yaml.safe_dump(scenario))
        fissure(arguments, "run", folder / "theory.yaml", "-o", folder / "result.h5", "--no-frames", "-j", 1)
        with h5py.File(folder / "result.h5") as file:
            run = file["pipelines/swept"]
            return dict(run["summary"].attrs), {name: run[name][:] for name in run if isinstance(run[name], h5py.Dataset)}


def lens(radius_m, reach_m, rings):
    """The part of a sphere around its lowest point, which is the origin, `reach_m` to each side, and its mirror image above."""
    points, first = [[0, 0, 0]], [0]
    for ring in range(1, rings + 1):
        first.append(len(points))
        r = reach_m * ring / rings
        angles = 2 * math.pi * np.arange(6 * ring) / (6 * ring)
        points += [[r * math.cos(a), radius_m - math.sqrt(radius_m**2 - r**2), r * math.sin(a)] for a in angles]
    faces = []
    for ring in range(1, rings + 1):
        inner, outer = max(6 * (ring - 1), 1), 6 * ring
        for sector in range(6):
            for i in range(ring):
                a, b = (first[ring] + (sector * ring + i + step) % outer for step in (0, 1))
                c, d = (first[ring - 1] + (sector * (ring - 1) + i + step) % inner for step in (-1, 0))
                faces.append([a, b, d])
                if i:
                    faces.append([c, a, d])
    rim_m, count = points[-1][1], first[-1]
    points += [[x, 2 * rim_m - y, z] for x, y, z in points[:count]]
    mirrored = [[v if v >= count else v + first[-1] + 6 * rings for v in reversed(face)] for face in faces]
    return {"type": "triangles", "vertices_m": np.array(points, float).tolist(), "faces": faces + mirrored}


def pressed(arguments, change):
    """One row: a sphere of radius R - margin sinks into the layer until, with the margin, it is d deep, and stays."""
    case = {**BASE, "loading": 1, "viscosity": 1, "margin_m": MARGIN_M, "rings": 20, **change}
    exact_N, contact_m = layer_force(case["E_Pa"], case["nu"], case["R_m"], case["d_m"])
    side_m = change.get("side_m", 0.04 * math.ceil(2 * REACH * contact_m / 0.04))  # an even number of cells on all meshes
    scale = math.sqrt(1e4 / case["E_Pa"])
    cell_m = HEIGHT_M / case["layers"]
    across = round(side_m / cell_m)
    radius_m, loading_s = case["R_m"] - case["margin_m"], LOADING_S * case["loading"] * scale
    start_m = HEIGHT_M + case["margin_m"] + 1e-6
    end_m = HEIGHT_M + case["margin_m"] - case["d_m"]
    summary, run = simulated(
        arguments,
        {
            "time": {"step_s": change.get("step_s", STEPS_S[case["layers"]]) * scale},
            "world": {"gravity_m_s2": [0, 0, 0]},
            "bodies": [
                {
                    "name": "layer",
                    "shape": {"type": "box", "size_m": [side_m, HEIGHT_M, side_m], "cells": [across, case["layers"], across]},
                    "position_m": [0, HEIGHT_M / 2, 0],
                    "model": "elastic",
                    "margin_m": case["margin_m"],
                    "elastic": {
                        "youngs_modulus_Pa": case["E_Pa"],
                        "poissons_ratio": case["nu"],
                        "material": case["material"],
                        "viscosity_Pa_s": case["viscosity"] * case["E_Pa"] / 1e4 * scale,
                    },
                    "fixed": [{"below_m": 1e-4}],
                }
            ],
            "tools": [
                {
                    "name": "sphere",
                    "shape": lens(radius_m, 1.6 * contact_m, case["rings"]),
                    "friction": 0,
                    "motion": {
                        "type": "script",
                        "start_m": [0, start_m, 0],
                        "segments": [
                            {"move_to_m": [0, end_m, 0], "speed_m_s": (start_m - end_m) / loading_s, "timing": "minimum_jerk"},
                            {"hold_s": HOLD_S * scale},
                        ],
                    },
                }
            ],
        },
    )
    held = run["time"] > run["time"][-1] - (HOLD_S - 0.01) * scale
    forces_N = np.linalg.norm(run["reaction_force"][held], axis=1)
    row = {name: case[name] for name in BASE}
    row |= {"cell_mm": 1000 * cell_m, "side_mm": 1000 * side_m, "tetrahedra": 6 * across * across * case["layers"]}
    row |= {"chi": math.sqrt(case["R_m"] * case["d_m"]) / HEIGHT_M, "contact_over_cell": contact_m / cell_m}
    row |= {"force_N": forces_N.mean(), "swing_percent": 100 * np.ptp(forces_N) / forces_N.mean()}
    row |= {"hertz_N": hertz_N(case), "exact_N": exact_N, "series_N": hertz_N(case) * series_factor(case["nu"], row["chi"])}
    row |= {"error_percent": 100 * (row["force_N"] / exact_N - 1), "energy_error_percent": 100 * summary["energy_balance_error"]}
    row |= {"inverted": int(summary["max_inverted_elements"])}
    print(f"{change}: {row['force_N']:.5g} N, {row['error_percent']:+.2f} %", flush=True)
    return row


def limit(rows):
    """Force of infinitely small cells, N, and the order, of the three finest: F + C cell^order through them."""
    (h0, f0), (h1, f1), (h2, f2) = [(row["cell_mm"], row["force_N"]) for row in rows[-3:]]
    if (f0 - f1) * (f1 - f2) <= 0:
        return math.nan, math.nan
    low, high = 0.05, 8.0
    for _ in range(80):
        order = (low + high) / 2
        found = (h0**order - h1**order) / (h1**order - h2**order)
        low, high = (order, high) if found < (f0 - f1) / (f1 - f2) else (low, order)
    return f2 - (f1 - f2) * h2**order / (h1**order - h2**order), order


def dropped(arguments, viscosity, step_s):
    """One row: a ball of 30 mm falls 30 mm on the ground and rebounds."""
    summary, run = simulated(
        arguments,
        {
            "time": {"step_s": step_s},
            "ground": {"height_m": 0},
            "bodies": [
                {
                    "name": "ball",
                    "shape": {"type": "sphere", "radius_m": 0.03, "subdivisions": 3},
                    "position_m": [0, 0.0605, 0],
                    "model": "elastic",
                    "elastic": {"youngs_modulus_Pa": 1e4, "poissons_ratio": 0.4, "viscosity_Pa_s": viscosity},
                }
            ],
            "tools": [
                {
                    "name": "far",
                    "shape": {"type": "box", "size_m": [0.01, 0.01, 0.01]},
                    "motion": {"type": "script", "start_m": [1, 1, 0], "segments": [{"hold_s": 0.32}]},
                }
            ],
        },
    )
    gravity_J, contact_J = run["gravity_energy"], run["contact_work"]
    lowest = int(gravity_J.argmin())
    fall_J = gravity_J[0] - gravity_J[lowest]
    top = lowest + int(gravity_J[lowest:].argmax())
    row = {"viscosity_Pa_s": viscosity, "step_ms": 1000 * step_s}
    row["rebound_percent"] = 100 * (gravity_J[top] - gravity_J[lowest]) / fall_J
    row["vibration_percent"] = 100 * (run["kinetic_energy"] + run["stored_energy"])[top] / fall_J
    row["viscous_percent"] = 100 * run["viscous_loss"][top] / fall_J
    row["contact_loss_percent"] = -100 * contact_J[top] / fall_J
    row["balance_percent"] = 100 * np.abs(run["energy_error"]).max() / fall_J
    row["ground_depth_mm"] = 1000 * summary.get("max_ground_depth_m", math.nan)
    print(f"drop, {viscosity} Pa s, {1000 * step_s} ms: {row}", flush=True)
    return row


def write_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})


def heading(words, numbers):
    """Both lines of a table's head: columns of words and columns of numbers."""
    return "| " + " | ".join([*words, *numbers]) + " |\n|" + "---|" * len(words) + "--:|" * len(numbers) + "\n"


def series_table(series):
    meshes = [f"{n} cells" for n in [*LAYERS, FINEST]]
    lines = [heading(["material"], ["nu", "R [mm]", "d [mm]", "chi", *meshes, "order", "limit", "limit over the expansion"])]
    for rows in series:
        first = rows[0]
        force_N, order = limit(rows)
        cells = [first["material"], f"{first['nu']:g}", f"{1000 * first['R_m']:g}", f"{1000 * first['d_m']:g}", f"{first['chi']:.2f}"]
        cells += [f"{row['error_percent']:+.1f} %" for row in rows] + ["-"] * (len(LAYERS) + 1 - len(rows))
        cells += [f"{order:.1f}"] + [f"{100 * (force_N / first[name] - 1):+.1f} %" for name in ("exact_N", "series_N")]
        lines.append("| " + " | ".join(cells) + " |\n")
    return "".join(lines)


def single_table(singles, base):
    lines = [heading(["changed"], ["force [N]", "over the exact solution", "beside the first row"])]
    for name, row in {"nothing": base, **singles}.items():
        beside = 100 * ((1 + row["error_percent"] / 100) / (1 + base["error_percent"] / 100) - 1)
        lines.append(f"| {name} | {row['force_N']:.5g} | {row['error_percent']:+.2f} % | {beside:+.2f} % |\n")
    return "".join(lines)


def drop_table(drops):
    names = ["viscosity", "step [ms]", "rebound", "vibration", "viscous loss", "loss in contact", "sum", "greatest error of the balance"]
    lines = [heading([], names)]
    for row in drops:
        parts = [row[f"{name}_percent"] for name in ("rebound", "vibration", "viscous", "contact_loss")]
        cells = [f"{row['viscosity_Pa_s']:g} Pa s", f"{row['step_ms']:g}"]
        cells += [f"{part:.2f} %" for part in [*parts, sum(parts), row["balance_percent"]]]
        lines.append("| " + " | ".join(cells) + " |\n")
    return "".join(lines)


def averaged(series):
    """How much lower nodal averages make the force, by mesh, in words."""
    own, nodal = ({row["layers"]: row["error_percent"] for rows in series for row in rows if row["nu"] == nu} for nu in (0.45, 0.451))
    shares = ", ".join(f"{own[n] - nodal[n]:.1f}" for n in LAYERS)
    return f"{shares} points with {', '.join(map(str, LAYERS))} cells over the height"


def draw(path, series):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.2))
    for rows in series:
        first = rows[0]
        plain = all(first[name] == BASE[name] for name in ("R_m", "d_m", "material"))
        label = f"nu {first['nu']:g}" if plain else None
        style = {"color": COLOURS[first["nu"]], "alpha": 1 if plain else 0.35, "linewidth": 1.2}
        left.plot([row["contact_over_cell"] for row in rows], [row["error_percent"] for row in rows], "o-", markersize=4, label=label, **style)
        right.plot(first["chi"], limit(rows)[0] / first["hertz_N"], "o", markersize=5, color=COLOURS[first["nu"]])
    left.axhspan(-3, 3, color="grey", alpha=0.2, linewidth=0)
    left.set_xscale("log")
    left.set_xticks([1, 2, 3, 4, 6], ["1", "2", "3", "4", "6"])
    left.minorticks_off()
    left.set_xlabel("contact radius over cell")
    left.set_ylabel("force over the exact solution [%]")
    left.legend(frameon=False, fontsize=8)
    chi = np.linspace(0.01, 0.7, 40)
    for nu, colour in COLOURS.items():
        if nu == 0.451:  # lies on that of 0.45
            continue
        exact = [layer_force(1, nu, 100 * HEIGHT_M, (x * HEIGHT_M) ** 2 / (100 * HEIGHT_M))[0] for x in chi]
        hertz = [hertz_N({"E_Pa": 1, "nu": nu, "R_m": 100 * HEIGHT_M, "d_m": (x * HEIGHT_M) ** 2 / (100 * HEIGHT_M)}) for x in chi]
        right.plot(chi, np.array(exact) / hertz, "-", color=colour, linewidth=1.2, label=f"nu {nu:g}")
        right.plot(chi, [series_factor(nu, x) for x in chi], ":", color=colour, linewidth=1.2)
    right.plot([], [], ":", color="black", label="expansion of Dimitriadis et al.")
    right.plot([], [], "o", color="black", markersize=5, label="limit of the meshes")
    right.set_xlabel("chi = sqrt(R d) / h")
    right.set_ylabel("force over Hertz's")
    right.legend(frameon=False, fontsize=8)
    for axis in (left, right):
        axis.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def write(series, singles, drops):
    write_rows(FOLDER / "layer.csv", [row for rows in series for row in rows] + list(singles.values()))
    write_rows(FOLDER / "drop.csv", drops)
    draw(FOLDER / "theory.png", series)
    base = next(row for rows in series for row in rows if all(row[name] == value for name, value in BASE.items()))
    tables = {"series": series_table(series), "singles": single_table(singles, base), "drops": drop_table(drops)}
    finest = [rows[-1]["error_percent"] for rows in series]
    limits = [100 * (limit(rows)[0] / rows[0]["exact_N"] - 1) for rows in series]
    heights = {v: [row["rebound_percent"] for row in drops if row["viscosity_Pa_s"] == v] for v in VISCOSITIES_PA_S}
    numbers = {
        "finest": f"{min(finest):+.1f} to {max(finest):+.1f} %",
        "limits": f"{min(limits):+.1f} to {max(limits):+.1f} %",
        "swing": f"{max(row['swing_percent'] for rows in series for row in rows):.1f} %",
        "balance": f"{max(row['energy_error_percent'] for rows in series for row in rows):.2f} %",
        "tetrahedra": f"{max(row['tetrahedra'] for rows in series for row in rows):,}",
        "inverted": sum(row["inverted"] for rows in series for row in rows),
        "ratio_theory": 100 * (layer_force(1, 0.451, BASE["R_m"], BASE["d_m"])[0] / layer_force(1, 0.45, BASE["R_m"], BASE["d_m"])[0] - 1),
        "averaged": averaged(series),
        "rebound": ", ".join(f"{np.ptp(rebounds):.2f} points ({viscosity} Pa s)" for viscosity, rebounds in heights.items()),
        "balance_worst": max(row["balance_percent"] for row in drops),
    }
    (FOLDER / "README.md").write_text(PAGE.format(**tables, **numbers))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure", type=pathlib.Path)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    arguments = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        meshes = [[*LAYERS, *([FINEST] if change in FINE else [])] for change in SERIES]
        series = [[pool.submit(pressed, arguments, {**change, "layers": n}) for n in some] for change, some in zip(SERIES, meshes)]
        drops = [pool.submit(dropped, arguments, viscosity, step_s) for viscosity in VISCOSITIES_PA_S for step_s in DROP_STEPS_S]
        singles = {name: pool.submit(pressed, arguments, change) for name, change in SINGLES.items()}
        series = [[run.result() for run in runs] for runs in series]
        singles = {name: run.result() for name, run in singles.items()}
        drops = [run.result() for run in drops]
    write(series, singles, drops)
    print(f"written: {(FOLDER / 'README.md').relative_to(ROOT)}, layer.csv, drop.csv, theory.png")


if __name__ == "__main__":
    main()
