#!/usr/bin/env python3
"""Random valid scenes, and what must hold of each: an end, no missing number, proof and depth, forces, balances, symmetry, bits.

    /usr/bin/python3 scripts/random_scenes.py --check                   a few fixed scenes, a minute of two cores: one of the tests
    /usr/bin/python3 scripts/random_scenes.py --count 1000 --seed 5 -j 2 [-o FOLDER]
    /usr/bin/python3 scripts/random_scenes.py --seed 5 --only 17        one scene of a seed
    /usr/bin/python3 scripts/random_scenes.py --again FOLDER            a scene that was written because it broke something
    /usr/bin/python3 scripts/random_scenes.py --judge-again -o FOLDER   all that an earlier run broke, after a mend: FOLDER/summary.json anew

Scenes are drawn by scene_generator.py, invariants stand in scene_invariants.py. A scene that breaks one is made smaller while it still
does and written to a folder below FOLDER (out/scenes): scene.yaml with its files, scene.json, and why.txt with seed, invariant and command.
summary.json holds the counts. What does not hold for a stated reason is counted as explained. Each invariant is also shown a result that
was changed, and must say so. Exit 1 when something is broken, or (with --check) an invariant was never asked or missed its change.
"""
import argparse
import collections
import concurrent.futures
import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import traceback
import warnings

import numpy as np
import yaml

import scene_generator as generator
import scene_invariants as invariants
import scene_transforms as transforms
from scene_result import read

ROOT = pathlib.Path(__file__).resolve().parent.parent
HANG_S = 120  # of a front whose runs are limited to 10 s each
SHRINKS = 40
CHECKED = (7, 48)  # seed and number of scenes of --check


class Hangs(Exception):
    """A front that does not end."""


class Case:
    """A scene and its result in a folder, and those of its variants, made when they are asked for."""

    def __init__(self, scene, folder, program, variants):
        self.scene, self.folder, self.program, self.variants = scene, folder, pathlib.Path(program).resolve(), variants
        self.scenario, self.size_m = scene["scenario"], scene["size_m"]
        self.margin_m = max(body["margin_m"] for body in self.scenario["bodies"])
        self.steps = round(self.scenario["time"]["duration_s"] / self.scenario["time"]["step_s"])
        self.results = {}
        done = self.run(generator.write(scene, folder))
        self.code, self.stderr = done.returncode, done.stderr
        self.runs, self.resolved = read(folder / "scene.h5") if self.code in (0, 3) else ({}, "")

    def run(self, path, **environment):
        command = [self.program, "run", path.name, "-o", f"{path.stem}.h5", "--force"]
        try:
            return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=HANG_S, stdin=subprocess.DEVNULL,
                                  env={**os.environ, **environment}, check=False)
        except subprocess.TimeoutExpired as late:
            raise Hangs(f"{path.stem}: no end within {HANG_S} s") from late

    def finished(self):
        return [run for run in self.runs.values() if run.status in ("ok", "non_finite")]

    def make(self, name):
        """The path of a variant's scenario; None where the scene has no such variant."""
        scene = self.scene
        if name == "resolved":
            path = self.folder / "resolved.yaml"
            path.write_text(self.resolved)
            return path
        if name in transforms.MADE and "settle_s" in self.scenario["time"]:
            return None  # its first state is not at rest
        if name == "scaled":
            texts = json.dumps(scene["scenario"])
            if not invariants.elastic(self.scenario) or "preset" in texts or "tissue" in texts or '"file"' in texts:
                return None
        double = [run for run in self.finished() if run.settings(self.scenario).get("precision") != "f32"]
        exact = (double or self.finished())[0]  # whose meshes are not rounded, where there is such a run
        made = {"thinned": lambda: transforms.thinned_scene(scene, 3), "turned": lambda: transforms.turned_scene(scene),
                "mirrored": lambda: transforms.mirrored_scene(scene, exact), "scaled": lambda: transforms.scaled_scene(scene),
                "renumbered": lambda: transforms.renumbered_scene(scene, exact, 1)}[name]()
        return generator.write(made, self.folder, name)

    def other(self, name):
        """The runs of a variant; None where it is not asked for, or the scene has none. The same bits again are asked of other memory."""
        if name not in self.variants or not self.finished():
            return None
        if name not in self.results:
            path = self.make(name)
            done = self.run(path, **({"MALLOC_PERTURB_": "165"} if name == "resolved" else {})) if path else None
            if done and done.returncode not in (0, 3):
                raise RuntimeError(f"{name}: exit code {done.returncode}: {done.stderr}")
            self.results[name] = read(self.folder / f"{name}.h5")[0] if done else None
        return self.results[name]

    def laws(self):
        """With what `tissue` stands for."""
        return yaml.safe_load(self.resolved)["force"]

    def bodies(self):
        """With all defaults."""
        return yaml.safe_load(self.resolved)["bodies"]

    def mass_kg(self, run):
        """Mass of all tissue, or None where it is a preset's."""
        body = self.scenario["bodies"][0]
        if not invariants.elastic(self.scenario):
            return sum(body["mass_kg"] for body in self.scenario["bodies"])
        if "density_kg_m3" not in body["elastic"]:
            return None
        corners = run[f"volumes/{body['name']}/vertices"][run[f"volumes/{body['name']}/tetrahedra"]]
        volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        return body["elastic"]["density_kg_m3"] * float(np.abs(volumes).sum())

    def least_momentum(self):
        """A momentum that matters: of some mass that goes its size in the run."""
        mass_kg = self.scenario["bodies"][0].get("mass_kg") or 1000 * self.size_m ** 3
        return mass_kg * self.size_m / self.scenario["time"]["duration_s"]

    def copy(self):
        made = copy.copy(self)
        made.runs, made.results = copy.deepcopy(self.runs), copy.deepcopy(self.results)
        return made


def verdicts(case, name):
    """(run, complaint, explanation) of one invariant."""
    try:
        return list(invariants.INVARIANTS[name](case))
    except (Hangs, RuntimeError) as problem:
        return [("", str(problem), "")]


def notices(case, name, run):
    """Whether the invariant complains of this run once it is changed."""
    changed = case.copy()
    if name == "null_is_default" or run:
        invariants.CHANGES[name](changed, changed.runs[run])
    of_bullet = name == "far_is_free"  # whose contacts far away are explained, and so found
    return any(complaint and (of_bullet or not why) for _, complaint, why in verdicts(changed, name))


def look(job):
    """One scene: what became of it, in plain data."""
    seed, number, program, variants = job
    scene = generator.draw_scene(seed, number)
    seen = {"number": number, "kinds": scene["kinds"], "verdicts": [], "noticed": {}, "runs": []}
    warnings.simplefilter("ignore", RuntimeWarning)  # numbers that overflow are what is looked for
    with tempfile.TemporaryDirectory() as folder:
        try:
            case = Case(scene, pathlib.Path(folder), program, variants)
        except Hangs as problem:
            seen["verdicts"].append(("ends", "", "", str(problem), ""))
            return seen
        for run in case.runs.values():
            touched = run.status == "ok" and "contact_count" in run and bool((run["contact_count"] > 0).any())
            proved = "certified" in run and bool(run["certified"].all())
            deep = run.status == "ok" and "penetration_depth" in run and bool(np.nanmax(run["penetration_depth"]) > 0.01 * case.size_m)
            seen["runs"].append((run.pipeline, run.status, touched, proved, deep))
        for name in invariants.INVARIANTS:
            for run, complaint, why in verdicts(case, name):
                seen["verdicts"].append((name, run, case.runs[run].pipeline if run else "", complaint, why))
                if not complaint and run and not seen["noticed"].get(name):
                    seen["noticed"][name] = notices(case, name, run)
    return seen


def safe_look(job):
    try:
        return look(job)
    except Exception:  # a fault of these scripts is a finding too
        return {"number": job[1], "kinds": [], "verdicts": [("ends", "", "", traceback.format_exc(limit=-3), "")], "noticed": {}, "runs": []}


# Making smaller.


def reductions(scene):
    """Scenes that are a little smaller."""
    scenario = scene["scenario"]

    def made(edit):
        smaller = copy.deepcopy(scene)
        edit(smaller["scenario"])
        if "force" not in smaller["scenario"]:
            smaller["scenario"]["record"].pop("force_inputs", None)
        return smaller

    for key in ("tools", "bodies", "pipelines", "force"):
        items = scenario.get(key, [])
        for i in range(len(items)):
            if len(items) > 1 or key in ("tools", "force"):
                yield made(lambda s, key=key, i=i: s[key].pop(i) if len(s[key]) > 1 else s.pop(key))
    if "ground" in scenario:
        yield made(lambda s: s.pop("ground"))
    if scenario["time"]["duration_s"] > 2.5 * scenario["time"]["step_s"]:
        def shorten(s):
            s["time"]["duration_s"] = s["time"]["step_s"] * max(1, round(s["time"]["duration_s"] / s["time"]["step_s"]) * 2 // 3)
        yield made(shorten)
    if any(scenario["world"]["gravity_m_s2"]):
        yield made(lambda s: s["world"].update(gravity_m_s2=[0.0, 0.0, 0.0]))
    for group, keep in (("bodies", {"name", "shape", "position_m", "margin_m", "model", "elastic", "mass_kg", "solver", "material"}),
                        ("tools", {"name", "shape", "motion", "clamp", "friction"})):
        for i, item in enumerate(scenario.get(group, [])):
            for key in item:
                if key not in keep:
                    yield made(lambda s, group=group, i=i, key=key: s[group][i].pop(key))
            for part in ("elastic", "solver"):
                for key in item.get(part, {}):
                    yield made(lambda s, i=i, part=part, key=key: s["bodies"][i][part].pop(key))
            if item["shape"].get("subdivisions"):
                yield made(lambda s, group=group, i=i: s[group][i]["shape"].update(subdivisions=s[group][i]["shape"]["subdivisions"] - 1))
            if item.get("motion", {}).get("segments"):
                yield made(lambda s, i=i: s["tools"][i]["motion"]["segments"].pop())


def breaks(scene, name, program):
    variants = [invariants.VARIANT[name]] if name in invariants.VARIANT else []
    with tempfile.TemporaryDirectory() as folder:
        try:
            case = Case(scene, pathlib.Path(folder), program, variants)
        except Hangs:
            return name == "ends"
        if case.code == 2:  # made smaller, it is no valid scene
            return False
        return any(complaint and not why for _, complaint, why in verdicts(case, name))


def shrink(scene, name, program):
    """The smallest scene that was found in some tries and still breaks the invariant."""
    tries, again = 0, True
    while again and tries < SHRINKS:
        again = False
        for smaller in reductions(scene):
            tries += 1
            if tries > SHRINKS:
                break
            try:
                good = breaks(smaller, name, program)
            except Exception:  # a reduction that makes no sense
                good = False
            if good:
                scene, again = smaller, True
                break
    return scene


def keep(arguments, number, name, complaint):
    """Writes a broken scene, made smaller."""
    folder = arguments.output / f"{arguments.seed}_{number}_{name}"
    scene = generator.draw_scene(arguments.seed, number)
    if name != "ends" or "exit code 2" not in complaint:
        scene = shrink(scene, name, arguments.program)
    generator.write(scene, folder)
    (folder / "scene.json").write_text(json.dumps(scene))
    (folder / "why.txt").write_text(f"{name}: {' '.join(invariants.INVARIANTS[name].__doc__.split())}\n{complaint}\nseed {arguments.seed}, scene {number}\n"
                                    f"/usr/bin/python3 scripts/random_scenes.py --again {folder}\n")
    return folder


# The command line.


def again(arguments):
    """A kept scene once more: 1 where something is still broken."""
    scene = json.loads((arguments.again / "scene.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        case = Case(scene, pathlib.Path(folder), arguments.program, list(invariants.VARIANT.values()))
        found = [(name, *verdict) for name in invariants.INVARIANTS for verdict in verdicts(case, name)]
    for name, run, complaint, why in found:
        if complaint:
            print(f"{name} {run}: {complaint}" + (f" ({why})" if why else ""))
    return 1 if any(complaint and not why for *_, complaint, why in found) else 0


def judge_again(arguments):
    """The scenes that a summary names as broken once more, with what has become of each."""
    path = arguments.output / "summary.json"
    summary = json.loads(path.read_text())
    explained, still = collections.Counter(summary["explained"]), []
    seen = {number: safe_look((summary["seed"], number, arguments.program, chosen_variants(number))) for number in {number for number, *_ in summary["broken"]}}
    for number, name, complaint in summary["broken"]:
        of_run = [(now, why) for of, run, pipeline, now, why in seen[number]["verdicts"] if of == name and complaint.startswith(f"{run} ({pipeline})")]
        if not of_run or any(now and not why for now, why in of_run):
            still.append([number, name, complaint])
            continue
        whys = [why for _, why in of_run if why]
        summary["invariants"][name]["broken"] -= 1
        summary["invariants"][name]["explained" if whys else "held"] += 1
        explained.update(f"{name}: {why}" for why in whys[:1])
    summary.update(broken=still, explained=dict(explained))
    path.write_text(json.dumps(summary, indent=1) + "\n")
    show(summary)
    return 1 if still else 0


def chosen_variants(number):
    """Each scene has one variant, so that a thousand of them have each a hundred times."""
    names = list(invariants.VARIANT.values())
    return [names[number % len(names)]]


def summarise(arguments, everything):
    counts, kinds, reasons, broken, noticed, runs = (collections.Counter() for _ in range(6))
    faults = []
    for seen in everything:
        kinds.update(seen["kinds"])
        for pipeline, status, touched, proved, deep in seen["runs"]:
            runs.update({"all": 1, "with contact": touched, "proved": proved, "proved with contact": proved and touched, "deep": deep, status: 1})
        for name, run, pipeline, complaint, why in seen["verdicts"]:
            counts[name, "explained" if why else "broken" if complaint else "held"] += 1
            if why:
                reasons[f"{name}: {why}"] += 1
            elif complaint:
                faults.append((seen["number"], name, f"{run} ({pipeline}): {complaint}"))
        for name, good in seen["noticed"].items():
            noticed[name, good] += 1
    table = {name: {of: counts[name, of] for of in ("held", "explained", "broken")} | {"changes noticed": noticed[name, True], "changes missed": noticed[name, False]}
             for name in invariants.INVARIANTS}
    return {"seed": arguments.seed, "scenes": len(everything), "kinds": dict(sorted(kinds.items())), "runs": dict(runs), "invariants": table,
            "explained": dict(reasons), "broken": [list(fault) for fault in faults]}


def show(summary):
    runs = summary["runs"]
    share = lambda name: f"{runs.get(name, 0)} {name}"
    print(f"{summary['scenes']} scenes, {runs.get('all', 0)} runs: " + ", ".join(share(name) for name in ("with contact", "deep", "proved", "proved with contact", "non_finite", "timeout")))
    print("kinds: " + ", ".join(f"{name} {count}" for name, count in summary["kinds"].items()))
    for name, row in summary["invariants"].items():
        print(f"{name:24s} " + ", ".join(f"{of} {count}" for of, count in row.items()))
    for reason, count in summary["explained"].items():
        print(f"explained {count}: {reason}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--check", action="store_true", help="the fixed scenes of the test")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="one scene of the seed")
    parser.add_argument("--again", type=pathlib.Path, help="a folder of a scene that broke an invariant")
    parser.add_argument("--judge-again", action="store_true", help="what the summary in OUTPUT calls broken, once more")
    parser.add_argument("-j", type=int, default=2, help="scenes at a time")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "out/scenes")
    arguments = parser.parse_args()
    if arguments.again:
        return again(arguments)
    if arguments.judge_again:
        return judge_again(arguments)
    if arguments.check:
        arguments.seed, arguments.count = CHECKED
    numbers = [arguments.only] if arguments.only is not None else range(arguments.count)
    every = list(invariants.VARIANT.values())
    jobs = [(arguments.seed, number, arguments.program, every if arguments.only is not None else chosen_variants(number)) for number in numbers]
    everything = []
    with concurrent.futures.ProcessPoolExecutor(arguments.j) as pool:
        for seen in pool.map(safe_look, jobs):
            everything.append(seen)
            for name, run, pipeline, complaint, why in seen["verdicts"]:
                if complaint and not why:
                    print(f"scene {seen['number']}: {name}: {run} {pipeline}: {complaint}", flush=True)
    summary = summarise(arguments, everything)
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "summary.json").write_text(json.dumps(summary, indent=1) + "\n")
    show(summary)
    for number, name, complaint in summary["broken"]:
        print("kept: " + str(keep(arguments, number, name, complaint)))
    missed = [name for name, row in summary["invariants"].items() if row["changes missed"] or arguments.check and not row["changes noticed"]]
    for name in missed:
        print(f"{name}: was not asked, or did not notice a change of a result")
    return 1 if summary["broken"] or missed else 0


if __name__ == "__main__":
    sys.exit(main())
