#!/usr/bin/python3
"""Short runs of each pipeline, a shell and finite elements, with the worker under valgrind's memcheck; and the front's readers.

    scripts/valgrind_runs.py [--program build/release/fissure] [--pipeline swept]

20 to 30 steps each, in which the tool comes to touch the tissue. `fissure run` starts the worker as always, only that valgrind stands between
them; the front's own part of a run stays outside, because its limits on the time and memory of reading a file would end it. What is Bullet's
or HDF5's is listed with reasons in scripts/valgrind.supp. Exit codes: 0 no error; 1 an error, which is printed.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHELL = """format: 1
name: shell
time: {step_s: 0.001}
ground: {height_m: 0, friction: 0.5}
bodies:
  - name: sphere
    shape: {type: sphere, radius_m: 0.03, subdivisions: 2}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    margin_m: 0.0005
    material: {linear_stiffness: 0.5}
    clusters: {count: 8}
    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}
tools:
  - name: spatula
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    nodes: {resolution: [8, 8]}
    motion:
      {type: script, start_m: [0, 0.0617, 0], segments: [{move_to_m: [0, 0.0577, 0], speed_m_s: 0.2, timing: constant}, {hold_s: 0.01}]}
pipelines:
  - {name: stock, pipeline: default, settings: stock}
  - {name: tuned, pipeline: default, settings: tuned}
  - {name: nothing_else, pipeline: "null"}
  - {pipeline: cluster}
  - {pipeline: raycast}
  - {pipeline: fukuhara}
  - {pipeline: swept}
force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}]
record: {snapshots_every_s: 0.01}
measure: {certify: true}
"""
ELASTIC = """format: 1
name: elastic
time: {step_s: 0.001}
world: {gravity_m_s2: [0, 0, 0]}
bodies:
  - name: ball
    shape: {type: sphere, radius_m: 0.03, subdivisions: 2}
    model: elastic
    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4, density_kg_m3: 1000, viscosity_Pa_s: 5, friction: 0.5}
    fixed: [{below_m: -0.02}]
    gauges: [{name: flank, box: {min_m: [0.029, -0.001, -0.001], max_m: [0.031, 0.001, 0.001]}}]
tools:
  - name: blade
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    friction: 0.6
    nodes: {resolution: [8, 8]}
    motion:
      {type: script, start_m: [0, 0.0317, 0], segments: [{move_to_m: [0, 0.0287, 0], speed_m_s: 0.15, timing: constant}, {hold_s: 0.01}]}
pipelines:
  - {name: elastic_fukuhara, pipeline: fukuhara}
  - {name: elastic_swept, pipeline: swept}
  - {pipeline: prescribed}
  - {name: deformable_faces, pipeline: deformable, contacts: faces}
  - {name: deformable_nodes, pipeline: deformable, contacts: nodes}
force: [{model: hunt_crossley, k: 30, lambda: 3, n: 1.3}]
record: {snapshots_every_s: 0.01}
measure: {certify: true}
"""
READERS = [["list"], ["schema"], ["explain", "tools"], ["validate"], ["plan"]]  # the last two read the scenario


def checked(words, folder):
    """Runs a command; its output, or the log of what valgrind found, as text where it failed."""
    finished = subprocess.run(words, capture_output=True, text=True, cwd=folder, check=False)
    logs = "".join(log.read_text() for log in sorted(folder.glob("*.log")))
    return "" if finished.returncode == 0 and not logs else f"{finished.stderr}{logs}exit code {finished.returncode}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--pipeline", help="only the run of this name; no readers")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    failed = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        valgrind = ["valgrind", "--quiet", "--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite",
                    "--show-leak-kinds=definite", f"--suppressions={ROOT / 'scripts/valgrind.supp'}", f"--log-file={folder}/%p.log"]
        # The front starts the worker that lies beside it.
        front = folder / "fissure"
        front.write_bytes(program.read_bytes())
        worker = folder / "fissure-engine-f64"
        worker.write_text(f"#!/bin/sh\nexec {' '.join(valgrind)} {program.parent / worker.name} \"$@\"\n")
        for file in front, worker:
            os.chmod(file, 0o755)
        scenarios = {"shell": SHELL, "elastic": ELASTIC}
        jobs = {}
        for title, text in scenarios.items():
            (folder / f"{title}.yaml").write_text(text)
            if arguments.pipeline is None:
                for words in READERS:
                    file = [f"{title}.yaml"] if words[0] in ("validate", "plan") else []
                    jobs[" ".join(words + file)] = [*valgrind, str(program), *words, *file]
            for line in text[text.index("pipelines:"):text.index("force:")].splitlines()[1:]:
                run = line.split("name: ")[-1] if "name: " in line else line.split("pipeline: ")[-1]
                run = run.split(",")[0].rstrip("}")
                if arguments.pipeline in (None, run):
                    jobs[run] = [str(front), "run", f"{title}.yaml", "--pipeline", run, "-o", f"{run}.h5"]
        if not jobs:
            raise SystemExit(f"scripts/valgrind_runs.py: no run is named {arguments.pipeline}")
        for title, words in jobs.items():
            found = checked(words, folder)
            print(f"{title}: {'errors' if found else 'clean'}\n{found}", end="", flush=True)
            if found:
                failed.append(title)
            for log in folder.glob("*.log"):
                log.unlink()
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
