#!/usr/bin/env python3
"""Elastic tissue in the scenes of configs/ and some fixtures, side by side: Bullet's own world of tetrahedra (contacts of nodes and of faces,
stock and tuned), fukuhara and swept; writes results/elastic_scenes.

    /usr/bin/python3 scripts/elastic_scenes.py [SCENE...] [-j N]
"""
import argparse
import concurrent.futures
import pathlib
import tempfile

import h5py
import numpy as np
import yaml

from references import ROOT, fissure

FOLDER = ROOT / "results/elastic_scenes"
SCENES = {
    "spatula_press": "a spatula pressed into a ball",
    "plate_press": "a large plate pressed onto a ball",
    "clamp_sphere": "a clamp that grasps a ball",
    "fissure_open": "a spatula that opens a fissure",
    "elastic_organ": "a spatula on a gallbladder from a file",
    "fixtures/razor": "fixture: a razor blade drawn across a ball",
    "fixtures/edge_on": "fixture: a blade with its edge first",
    "fixtures/corner_first": "fixture: a plate with its corner first",
    "fixtures/tip_first": "fixture: a spatula with its tip first",
}
TISSUE = {"youngs_modulus_Pa": 10000, "poissons_ratio": 0.4, "density_kg_m3": 1000, "viscosity_Pa_s": 2, "friction": 0.5}
OF_ELASTIC_BODIES = ("name", "shape", "position_m", "orientation", "margin_m", "fixed", "gauges")
LIMIT_S = 120  # wall time of a run of Bullet's; those of the others take seconds
RUNS = {
    f"{contacts}_{settings}": {"pipeline": "deformable", "contacts": contacts, "settings": settings, "time_limit_s": LIMIT_S}
    for contacts in ("nodes", "faces")
    for settings in ("stock", "tuned")
} | {
    "fukuhara": {"pipeline": "fukuhara"},
    "swept": {"pipeline": "swept"},
}
LAST_S = 0.02  # of the run, over which the final force is the mean
BEYOND_MM = 30  # deeper is no depth in this tissue: it has left its place

PAGE = """# Elastic tissue under Bullet's world of tetrahedra, `fukuhara` and `swept`

    /usr/bin/python3 scripts/elastic_scenes.py

The scenes of [configs](../../configs) with their bodies of springs made elastic ({modulus:g} kPa, nu {ratio:g}, viscosity {viscosity:g} Pa s; each mesh is the scene's own,
a ball of 128 triangles has 512 tetrahedra), in steps of 1 ms: `deformable` with contacts of nodes and of faces, stock and tuned ([Bullet's
world of tetrahedra](../../src/simulation/engine/METHOD.md#5-the-deformable-world)), `fukuhara` with the scene's own nodes, and `swept`; where there is a ground, `fukuhara` and `swept` stand on the
half-space, `deformable` on Bullet's box. One scene at five speeds and three steps: [results/deformable](../deformable/README.md).

**depth**: worst of any tool's samples; **not proved**: recorded steps that are not proved free of overlap; **peak**: largest reaction on all tools
together, of the jaws of a clamp on the one that has more; **final**: its mean over the last {last:g} ms; **lost**: share of the contacts' work on the
tissue, since the tissue has settled, that it has neither stored nor as kinetic energy nor in its weight at the end, with viscosity's part; below 0
the tissue has energy that no booked work of contacts has given it; **step**: median over `swept`'s in the same run. **Tissue lost**: a sample is
deeper than {beyond:g} mm, or a force is above 1 kN. A run of Bullet's that takes longer than {limit:g} s is stopped: the others take seconds.

{table}
## What it says

{words}"""


def scenario_of(arguments, name):
    """The scenario of a file of configs/, composed with what it is based on, made elastic."""
    scenario = yaml.safe_load(fissure(arguments, "plan", "--resolved", ROOT / f"configs/{name}.yaml").stdout)
    body = scenario["bodies"][0]
    if body.get("model") != "elastic":
        scenario["bodies"] = [{**{key: body[key] for key in OF_ELASTIC_BODIES if key in body}, "model": "elastic", "elastic": TISSUE}]
    if scenario.get("ground"):
        scenario["ground"].pop("hardness", None)
    if scenario.get("world"):
        for key in ("air_density_kg_m3", "max_displacement_m"):
            scenario["world"].pop(key, None)
    entries = [{"name": run, **entry} for run, entry in RUNS.items()]
    for entry in entries:
        if entry["pipeline"] == "fukuhara" and scenario.get("ground"):
            entry["ground_contact"] = "half_space"
    scenario["pipelines"] = entries
    scenario["record"] = {}
    scenario["measure"] = {"certify": True}
    for key in ("expect", "force"):
        scenario.pop(key, None)
    return scenario


def reaction_N(run):
    """Size of the force of the tissue on the tools over the steps: on the tool that has most of it."""
    one = run["tool_reaction"][:] if "tool_reaction" in run else run["reaction_force"][:][:, None, :]
    return np.linalg.norm(one, axis=-1).max(axis=1)


def row_of(run):
    if run.attrs["status"] == "timeout":
        return {"status": "timeout", "step_ms": float("nan")}
    summary, time_s = run["summary"].attrs, run["time"][:]
    force_N = reaction_N(run)
    energy_J = sum(run[f"{kind}_energy"][:] for kind in ("stored", "kinetic", "gravity"))
    work_J, gained_J = (series[-1] - series[0] for series in (run["contact_work"][:], energy_J))
    return {
        "status": run.attrs["status"],
        "depth_mm": 1000 * summary["max_penetration_depth_m"],
        "not_proved": int(summary["uncertified_steps"]),
        "steps": len(time_s) - 1,
        "peak_N": float(np.nanmax(force_N)),
        "final_N": float(force_N[time_s >= time_s[-1] - LAST_S].mean()),
        "lost": 1 - gained_J / work_J if work_J > 0 else float("nan"),
        "inverted": int(summary["max_inverted_elements"]),
        "step_ms": float(np.nanmedian(run["timing/step_time_us"][1:])) / 1000,
    }


def run_scene(arguments, name):
    with tempfile.TemporaryDirectory() as folder:
        file, result = pathlib.Path(folder) / "scene.yaml", pathlib.Path(folder) / "scene.h5"
        scenario = scenario_of(arguments, name)
        for shape in [scenario["bodies"][0]["shape"]] + [tool["shape"] for tool in scenario["tools"]]:
            if "file" in shape:
                shape["file"] = str((ROOT / f"configs/{name}.yaml").parent / shape["file"])
        file.write_text(yaml.safe_dump(scenario, sort_keys=False))
        fissure(arguments, "run", file, "-o", result, "--no-frames", "-j", 1, accept=(0, 3))
        with h5py.File(result) as opened:
            rows = {run: row_of(opened[f"pipelines/{run}"]) for run in RUNS}
    for run, row in rows.items():
        row["over_swept"] = row["step_ms"] / rows["swept"]["step_ms"]
        print(name, run, row, flush=True)
    return rows


def is_lost(row):
    return row["status"] != "ok" or not row["depth_mm"] < BEYOND_MM or not row["peak_N"] < 1e3


def cells(name, run, row):
    if row["status"] == "timeout":
        return [name, f"`{run}`", f"not done in {LIMIT_S} s"] + ["-"] * 6
    lost = is_lost(row)
    force = ["-", "-"] if lost else [f"{row['peak_N']:.3f}", f"{row['final_N']:.3f}"]
    share = f"{100 * row['lost']:.0f} %" if abs(row["lost"]) < 10 and not lost else "-"
    return [name, f"`{run}`", "tissue lost" if lost else f"{row['depth_mm']:.2f}", f"{row['not_proved']} of {row['steps']}", *force, share,
            str(row["inverted"]), f"{row['over_swept']:.1f}"]


def table(found):
    heads = ["scene", "run", "depth [mm]", "not proved", "peak [N]", "final [N]", "lost", "inverted elements", "step over swept's"]
    lines = ["| " + " | ".join(heads) + " |\n", "|---|---|" + "--:|" * (len(heads) - 2) + "\n"]
    for name, rows in found.items():
        for run, row in rows.items():
            lines.append("| " + " | ".join(cells(SCENES[name] if run == "nodes_stock" else "", run, row)) + " |\n")
    return "".join(lines)


def words(found):
    lines = []
    for run in RUNS:
        rows = {name: rows[run] for name, rows in found.items()}
        slow = [name for name, row in rows.items() if row["status"] == "timeout"]
        done = {name: row for name, row in rows.items() if name not in slow}
        sound = {name: row for name, row in done.items() if not is_lost(row)}
        held = [name for name, row in sound.items() if row["depth_mm"] <= 0.5]
        proved = [name for name, row in sound.items() if row["not_proved"] == 0]
        borne = [name for name in held if sound[name]["final_N"] >= 0.01 and found[name]["swept"]["final_N"] >= 0.01]
        deviations = [sound[name]["final_N"] / found[name]["swept"]["final_N"] - 1 for name in borne]
        text = f"* `{run}`: to 0.5 mm in {len(held)} of {len(rows)} scenes, every step proved in {len(proved)}, tissue lost in {len(done) - len(sound)}"
        text += f", not done in {LIMIT_S} s in {len(slow)}" if slow else ""
        free = [name for name in held if sound[name]["final_N"] < 0.01 < found[name]["swept"]["final_N"]]
        gained = [-row["lost"] for row in sound.values() if row["lost"] < -0.01]
        if deviations and run != "swept":
            text += f"; where it holds, its final force differs from `swept`'s by {100 * min(deviations):+.1f} to {100 * max(deviations):+.1f} %"
        text += f", and is none though `swept`'s is not: {', '.join(SCENES[name] for name in free)}" if free else ""
        text += f"; more energy than the work of contacts in {len(gained)}, by up to {100 * max(gained):.0f} % of it" if gained else ""
        ratios = [row["over_swept"] for row in done.values()]
        lines.append(text + (f"; a step takes {min(ratios):.1f} to {max(ratios):.1f} times `swept`'s.\n" if run != "swept" and ratios else ".\n"))
    return "".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="some of the scenes; nothing is written then")
    parser.add_argument("-j", dest="jobs", type=int, default=1, help="scenes at a time")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure", help="another fissure than build/release/fissure")
    arguments = parser.parse_args()
    names = arguments.scenes or list(SCENES)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        found = dict(zip(names, pool.map(lambda name: run_scene(arguments, name), names)))
    page = PAGE.format(modulus=TISSUE["youngs_modulus_Pa"] / 1000, ratio=TISSUE["poissons_ratio"], viscosity=TISSUE["viscosity_Pa_s"], last=1000 * LAST_S, beyond=BEYOND_MM, limit=LIMIT_S,
                       table=table(found), words=words(found))
    if arguments.scenes:
        print(page)
        return
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "README.md").write_text(page)


if __name__ == "__main__":
    main()
