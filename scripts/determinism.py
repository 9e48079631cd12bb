#!/usr/bin/python3
"""Whether results have the same bits whatever surrounds a run: every run of a few scenes again, with one thing changed at a time.

    scripts/determinism.py                  all scenes, all changes; a table
    scripts/determinism.py --check          short runs of fewer scenes: what the test `determinism` does
    scripts/determinism.py --json out.json  all hashes besides
    scripts/determinism.py --scene clamp --change no_fma      these alone (may be repeated)
    scripts/determinism.py --debug build/debug/fissure        a debug build too

Changed are: nothing (a second time), the number of workers, the layout of memory, what the heap holds, locale, time zone, working folder, the
processor's features as the C library sees them (whose sine and power are others without fused multiply-add), the vectors that our own elements
use, and the processor itself: engines run on older ones that QEMU plays, which does their arithmetic in software. A hash is of all data of a run but
timing. Of a run that differs the first value is named.

Bullet's runs alone may differ where the C library does. Exit codes: 0 the same; 1 a run differs; 2 bad input; 3 a run failed.
"""
import argparse
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from result_bits import contents, first_difference, hash_of

ROOT = pathlib.Path(__file__).resolve().parent.parent

BLADE = """tools:
  - name: blade
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    nodes: {resolution: [8, 8]}
    motion:
      type: script
      start_m: [0, 0.0616, 0]
      start_orientation: {axis: [1, 2, 3], angle_deg: 7}
      segments:
        - {move_to_m: [0.002, 0.05, 0], duration_s: 0.05, timing: minimum_jerk}
        - {rotate_to: {axis: [0.3, 1, -0.2], angle_deg: 25}, duration_s: 0.05}
force:
  - {name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}
  - {name: fung, model: exponential, k: 0.2, a: 100, c: 1}
"""
TIME = "format: 1\nname: {name}\ntime: {{step_s: 0.001, settle_s: 0.02, duration_s: {duration_s}}}\n"
SHELL = """ground: {height_m: 0, friction: 0.5}
bodies:
  - name: ball
    shape: {type: sphere, radius_m: 0.03, subdivisions: 2}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    bending_distance: 2
    material: {linear_stiffness: 0.5}
    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}
"""
ELASTIC = """world: {gravity_m_s2: [0, 0, 0]}
bodies:
  - name: ball
    shape: {type: sphere, radius_m: 0.03, subdivisions: 2}
    position_m: [0, 0.03, 0]
    model: elastic
    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4, density_kg_m3: 1000, viscosity_Pa_s: 5, friction: 0.5}
    fixed: [{below_m: 0.01}]
"""
RECORD = "record: {snapshots_every_s: 0.01}\nmeasure: {certify: true}\n"


@dataclasses.dataclass
class Scene:
    name: str
    engine: str  # whose elements: explicit (ours) or bullet
    text: str
    is_quick: bool = False


SCENES = [
    Scene("shell", "bullet", SHELL + BLADE + """pipelines:
  - {pipeline: default}
  - {name: default_tuned, pipeline: default, settings: tuned}
  - {name: default_f32, pipeline: default, settings: tuned, precision: f32}
  - {pipeline: raycast}
  - {pipeline: fukuhara}
  - {pipeline: swept}
""", True),
    Scene("clamp", "bullet", SHELL.replace("ball", "vessel").replace("sphere, radius_m: 0.03", "capsule, radius_m: 0.008, length_m: 0.05")
          .replace("0, 0.03, 0", "0, 0.008, 0") + """tools:
  - name: clamp
    shape: {type: box, size_m: [0.004, 0.03, 0.01]}
    clamp: {opening: hinged, hinge_height_m: 0.03, jaw_position_m: [0.002, 0, 0]}
    nodes: {resolution: [8, 4]}
    motion:
      type: script
      start_m: [0, 0.016, 0]
      start_orientation: [0, 0.70710678, 0, 0.70710678]
      start_opening_deg: 40
      segments: [{open_to_deg: 10, duration_s: 0.1, timing: minimum_jerk}]
force: [{name: hc, model: hunt_crossley, deformation: corotated}]
pipelines:
  - {name: default_tuned, pipeline: default, settings: tuned}
  - {pipeline: raycast}
  - {pipeline: fukuhara}
  - {pipeline: swept}
"""),
    Scene("elastic", "explicit", ELASTIC + BLADE + """pipelines:
  - {pipeline: raycast, response: momentum}
  - {pipeline: fukuhara}
  - {pipeline: swept}
  - {pipeline: prescribed}
""", True),
    Scene("coupled", "explicit", ELASTIC + BLADE.replace("    motion:", "    coupling: {mass_kg: 0.05, stiffness_N_m: 500, damping_N_s_m: 5, force: hc}\n"
                                                        "    motion:") + "pipelines: [{pipeline: fukuhara}, {pipeline: swept}]\n"),
    Scene("deformable", "bullet", ELASTIC + BLADE + "pipelines: [{pipeline: deformable, settings: tuned}]\n"),
]


@dataclasses.dataclass
class Change:
    """What surrounds a run, otherwise than in the first one."""
    name: str
    says: str
    environment: dict = dataclasses.field(default_factory=dict)
    before: tuple = ()  # words before the program's name
    workers: int = 1
    elsewhere: bool = False
    program: str = ""
    locale: str = ""  # made by localedef
    processor: str = ""  # that QEMU plays for the engines


NO_FMA = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"
CHANGES = [
    Change("again", "nothing"),
    Change("workers", "-j 2", workers=2),
    Change("no_aslr", "setarch -R: addresses that do not change", before=("setarch", "-R")),
    Change("heap", "fresh and freed memory filled with a pattern", {"MALLOC_PERTURB_": "85"}),
    Change("locale_c", "LC_ALL=C", {"LC_ALL": "C"}),
    Change("locale_de", "a decimal comma", locale="de_DE"),
    Change("locale_tr", "i and I are no pair", locale="tr_TR"),
    Change("zone", "14 hours ahead", {"TZ": "Pacific/Kiritimati"}),
    Change("folder", "another working folder", elsewhere=True),
    Change("no_fma", "the C library without AVX2 and FMA", {"GLIBC_TUNABLES": NO_FMA}),
    Change("baseline", "our elements without AVX", {"FISSURE_INSTRUCTIONS": "baseline"}),
    Change("avx2", "our elements with AVX2", {"FISSURE_INSTRUCTIONS": "avx2"}),
    Change("opteron", "engines on an AMD Opteron of 2003 (SSE2)", processor="Opteron_G1"),
    Change("nehalem", "engines on an Intel Nehalem of 2008 (SSE4.2)", processor="Nehalem"),
    Change("haswell", "engines on an Intel Haswell of 2013 (AVX2, FMA)", processor="Haswell"),
]
MAY_DIFFER = ("no_fma", "opteron", "nehalem")  # for Bullet, which calls the C library (engine/METHOD.md 6): theirs has no FMA


class Failure(Exception):
    def __init__(self, code, line):
        super().__init__(line)
        self.code = code


def last_line(finished):
    return ((finished.stderr.strip() or finished.stdout.strip()) or "it says nothing").splitlines()[-1]


def played_engines(processor, program, folder):
    """A folder of engines that start the real ones on a processor that QEMU plays."""
    made = folder / f"engines_{processor}"
    made.mkdir(exist_ok=True)
    for engine in program.resolve().parent.glob("fissure-engine-*"):
        script = made / engine.name
        script.write_text(f'#!/bin/sh\nexec qemu-x86_64 -cpu {processor} "{engine}" "$@"\n')
        script.chmod(0o755)
    return made


def surroundings(change, folder, program):
    """The environment of a change; a text instead says why this machine cannot make it."""
    environment = {name: value for name, value in os.environ.items() if name not in ("LC_ALL", "GLIBC_TUNABLES", "FISSURE_INSTRUCTIONS")}
    environment.update(change.environment)
    if change.before and (not shutil.which(change.before[0]) or subprocess.run([*change.before, "true"], capture_output=True, check=False).returncode):
        return f"{' '.join(change.before)} is not allowed here"
    if change.locale:
        made = folder / f"{change.locale}.UTF-8"
        command = ["localedef", "--no-archive", "-i", change.locale, "-f", "UTF-8", str(made)]
        if not shutil.which("localedef") or subprocess.run(command, capture_output=True, check=False).returncode:
            return f"localedef cannot make {change.locale}"
        environment.update(LOCPATH=str(folder), LC_ALL=made.name, LANG=made.name)
    if change.processor:
        asked = ["qemu-x86_64", "-cpu", change.processor, "/bin/true"]
        if not shutil.which(asked[0]) or subprocess.run(asked, capture_output=True, check=False).returncode:
            return f"there is no QEMU that plays an {change.processor}"
        environment["FISSURE_ENGINE_DIR"] = str(played_engines(change.processor, program, folder))
    if change.environment.get("FISSURE_INSTRUCTIONS") == "avx2" and not has_feature("avx2"):
        return "this processor has no AVX2"
    if "GLIBC_TUNABLES" in change.environment and sines(environment) == sines(dict(environment, GLIBC_TUNABLES="")):
        return "the C library computes the same without FMA here"
    return environment


def has_feature(name):
    try:
        return name in pathlib.Path("/proc/cpuinfo").read_text().split()
    except OSError:
        return False


def sines(environment):
    """What the C library makes of exp, pow and sin under an environment: Python's are its."""
    code = "import math; print([f(1 + i / 7919) for i in range(4000) for f in (math.exp, math.sin, lambda x: math.pow(x, 1.3))])"
    return subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True).stdout


def run_scene(scene, duration_s, change, environment, options, folder):
    """The contents of each run of a scene, by the run's name."""
    file = folder / f"{scene.name}.yaml"
    file.write_text(TIME.format(name=scene.name, duration_s=duration_s) + scene.text + RECORD)
    result = folder / f"{scene.name}.h5"
    program = change.program or options.program
    words = [*change.before, str(pathlib.Path(program).resolve()), "run", str(file), "--no-frames", "--no-expect", "--force", "-j", str(change.workers),
             "-o", str(result)]
    where = folder / "elsewhere" if change.elsewhere else folder
    where.mkdir(exist_ok=True)
    try:
        finished = subprocess.run(words, env=environment, cwd=where, capture_output=True, text=True, check=False)
    except OSError as error:
        raise Failure(2, str(error)) from error
    if finished.returncode:
        raise Failure(2 if finished.returncode == 2 else 3, f"{scene.name}, {change.name}: {last_line(finished)}")
    runs = {}
    for name, array in contents(result).items():
        parts = name.split("/", 2)
        if parts[0] == "pipelines" and len(parts) > 1:
            run, _, attribute = parts[1].partition("@")
            runs.setdefault(run, {})["/".join(parts[2:]) + ("@" + attribute if attribute else "")] = array
    return runs


def measure(options, scenes, changes, duration_s, folder):
    """Per scene and run the hash of the first time, and per change its hash, the first difference, or why there is none."""
    rows, unmade = [], {}
    environments = {change.name: surroundings(change, folder, options.program) for change in changes}
    plain = Change("first", "")
    environment = surroundings(plain, folder, options.program)
    for scene in scenes:
        first = run_scene(scene, duration_s, plain, environment, options, folder)
        here = {run: {"scene": scene.name, "run": run, "engine": scene.engine, "hash": hash_of(found), "changes": {}} for run, found in first.items()}
        for change in changes:
            if isinstance(environments[change.name], str):
                unmade[change.name] = environments[change.name]
                continue
            again = run_scene(scene, duration_s, change, environments[change.name], options, folder)
            if set(again) != set(first):
                raise Failure(3, f"{scene.name}, {change.name}: runs {sorted(again)}, expected {sorted(first)}")
            for run, found in again.items():
                here[run]["changes"][change.name] = {"hash": hash_of(found), "first_difference": first_difference(first[run], found)}
        rows += here.values()
    return rows, unmade


def table(rows, changes, unmade):
    made = [change for change in changes if change.name not in unmade]
    lines = [["scene", "run", "engine", "hash", *(change.name for change in made)]]
    for row in rows:
        cells = ["same" if row["changes"][change.name]["first_difference"] is None else "DIFFERS" for change in made]
        lines.append([row["scene"], row["run"], row["engine"], row["hash"][:12], *cells])
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines)


def chosen(named, things, what):
    unknown = sorted(set(named or ()) - {thing.name for thing in things})
    if unknown:
        raise Failure(2, f"no {what} is called {unknown[0]}, expected {', '.join(thing.name for thing in things)}")
    return [thing for thing in things if not named or thing.name in named]


def compare(options):
    changes = list(CHANGES)
    if options.debug:
        changes.append(Change("debug", "a debug build", program=str(options.debug)))
    scenes = [scene for scene in SCENES if scene.is_quick] if options.check and not options.scene else SCENES
    if options.check and not options.change:
        changes = [change for change in changes if change.processor in ("", "Opteron_G1")]
    scenes, changes = chosen(options.scene, scenes, "scene"), chosen(options.change, changes, "change")
    with tempfile.TemporaryDirectory() as folder:
        rows, unmade = measure(options, scenes, changes, 0.05 if options.check else 0.12, pathlib.Path(folder))
    print(table(rows, changes, unmade))
    for name, why in unmade.items():
        print(f"not done: {name}, because {why}")
    if options.json:
        says = {change.name: change.says for change in changes}
        options.json.write_text(json.dumps({"format": "fissure-determinism", "changes": says, "not_done": unmade, "runs": rows}, indent=1) + "\n")
    differ = []
    for row in rows:
        for name, found in row["changes"].items():
            if found["first_difference"] is None:
                continue
            line = f"{row['scene']}, {row['run']}, {name}: {found['first_difference']}"
            if row["engine"] == "bullet" and name in MAY_DIFFER:
                print(f"allowed: {line}")
            else:
                differ.append(line)
    if differ:
        raise Failure(1, "\n".join(differ))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="short runs of the quick scenes")
    parser.add_argument("--scene", action="append", metavar="NAME", help="one of: " + ", ".join(scene.name for scene in SCENES))
    parser.add_argument("--change", action="append", metavar="NAME", help="one of: " + ", ".join(change.name for change in CHANGES))
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--debug", type=pathlib.Path, metavar="PROGRAM", help="fissure of a debug build, compared too")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write all hashes")
    options = parser.parse_args()
    try:
        compare(options)
    except Failure as failure:
        for line in str(failure).splitlines():
            print(f"{'differs' if failure.code == 1 else 'error'}: {line}", file=sys.stderr)
        return failure.code
    except (OSError, ValueError) as failure:
        print(f"error: {failure}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
