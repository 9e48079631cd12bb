#!/usr/bin/env python3
"""Kills a sweep at random moments, again and again, and looks whether anything is lost or changed.

    /usr/bin/python3 scripts/sweep_kills.py [--program build/release/fissure] [--kills 50] [--seed 1]
                                            [-o results/sweeps/kills.csv]

One sweep is run without harm. Then the same sweep is started, killed with SIGKILL after a random while (the front,
a worker, or both), started again, and so on; whenever one comes to its end, its table must equal the undisturbed
one bit for bit outside timing/ and provenance, its CSV byte for byte, and a new one is begun, until there were so
many kills. A simulation whose record was whole before a kill must not run again. Exit code 1 when any of that is
not so.
"""
import argparse
import csv
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAME_DATA = ROOT / "scripts/result_bits.py"
SCENARIO = """\
base: {root}/configs/spatula_press.yaml
name: press
time: {{settle_s: 0.02, duration_s: 0.08}}
expect: []
record: {{snapshots_every_s: 0.02}}
"""
SWEEP = """\
format: 1
name: kills
base: press.yaml
pipelines: [default_tuned, fukuhara]
axes:
  - {path: bodies.sphere.mass_kg, values: [0.08, 0.1, 0.12, 0.14]}
  - {path: tools.spatula.motion.segments.0.speed_m_s, values: [0.3, 0.4, 0.5]}
  - {path: force.hc.k, values: [100, 200, 300, 400]}
curves: {quantities: [force, penetration_depth], every_s: 0.01}
keep: results
"""


class Sweep:
    """One sweep in a folder of its own, started as often as it takes."""

    def __init__(self, program, folder, name):
        self.program, self.folder, self.name = program, folder, name
        self.starts = 0

    def start(self):
        self.starts += 1
        command = [self.program, "sweep", "s.yaml", "-o", self.name, "-j", "2"]
        return subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def finished(self):
        """Simulations with a whole record."""
        status = subprocess.run([self.program, "sweep", "status", self.name], cwd=self.folder, capture_output=True,
                                text=True, check=True).stdout
        left, everything = map(int, re.search(r"to do: (\d+) of (\d+)", status).groups())
        return everything - left

    def differs(self):
        """What is not as in the folder `truth`; empty: nothing."""
        same = subprocess.run([sys.executable, SAME_DATA, "truth/sweep.h5", f"{self.name}/sweep.h5"], cwd=self.folder,
                              capture_output=True, text=True)
        problems = [] if same.returncode == 0 else [same.stdout.strip() or same.stderr.strip() or "the tables differ"]
        if (self.folder / "truth/sweep.csv").read_bytes() != (self.folder / self.name / "sweep.csv").read_bytes():
            problems.append("sweep.csv differs")
        names = [{p.name for p in (self.folder / n / "runs").iterdir()} for n in ("truth", self.name)]
        if names[0] != names[1]:
            problems.append(f"files of runs differ: {sorted(names[0] ^ names[1])}")
        return problems


def workers(front):
    children = pathlib.Path(f"/proc/{front.pid}/task/{front.pid}/children")
    try:
        return [int(pid) for pid in children.read_text().split()]
    except OSError:
        return []


def kill(pids):
    for pid in pids:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has ended


def trial(sweep, rng, longest_s):
    """One start and, where it comes to it, one kill. Returns what was killed, and whether the sweep is whole."""
    before = sweep.finished() if sweep.starts else 0
    front = sweep.start()
    time.sleep(rng.uniform(0, longest_s))
    who = rng.choice(["front", "worker", "both"])
    victims = workers(front)[:1] if who != "front" else []
    if who != "worker":
        victims.append(front.pid)
    hit = front.poll() is None and victims
    kill(victims)
    out, err = front.communicate(timeout=120)
    problems = []
    planned = re.search(r"to do: (\d+) of (\d+)", out)
    if planned and int(planned[2]) - int(planned[1]) < before:
        problems.append(f"{before} were finished, but {planned[1]} of {planned[2]} were run")
    if not hit:
        who = "nothing: it had ended"
    if front.returncode not in (0, 3, -signal.SIGKILL):
        problems.append(f"exit code {front.returncode}: {err.strip()}")
    return who, front.returncode == 0, problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/sweeps/kills.csv")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as name:
        rows = campaign(options.program.resolve(), pathlib.Path(name), options.kills, rng)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["killed", "times", "sweeps ended whole", "problems"], *rows])
    for row in rows:
        print("{}: {} times; {} sweeps came to their end; problems: {}".format(*row))
    return 1 if any(row[3] != "none" for row in rows) else 0


def campaign(program, folder, kills, rng):
    (folder / "press.yaml").write_text(SCENARIO.format(root=ROOT))
    (folder / "s.yaml").write_text(SWEEP)
    start = time.monotonic()
    truth = Sweep(program, folder, "truth").start()
    if truth.wait() != 0:
        raise SystemExit(truth.stderr.read())
    longest_s = time.monotonic() - start
    counts, whole, problems = {}, 0, []
    sweep = Sweep(program, folder, "out0")
    while sum(counts.values()) < kills or sweep.starts:
        if sum(counts.values()) < kills:
            who, ended, found = trial(sweep, rng, longest_s * 0.7)
        else:  # the last one comes to its end
            who, found = "nothing: it had ended", []
            ended = sweep.start().wait() == 0
        problems += found
        if not who.startswith("nothing"):
            counts[who] = counts.get(who, 0) + 1
        if ended:
            problems += sweep.differs()
            whole += 1
            sweep = Sweep(program, folder, f"out{whole}")
    return [[who, count, whole, "; ".join(problems) or "none"] for who, count in sorted(counts.items())]


if __name__ == "__main__":
    sys.exit(main())
