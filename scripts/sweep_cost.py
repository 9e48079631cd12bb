#!/usr/bin/env python3
"""What a sweep costs beside its simulations: laws, workers, memory of the front, planning.

    /usr/bin/python3 scripts/sweep_cost.py [--program build/release/fissure] [--count 1000] [--pairs 5]
                                           [-o results/sweeps/cost.md]

Every number is a ratio or a difference within one session on one machine, which should have nothing else to do.
"""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import tempfile
import time

import h5py

ROOT = pathlib.Path(__file__).resolve().parent.parent
DISTINCT = """\
format: 1
name: distinct
base: {root}/configs/spatula_press.yaml
pipelines: [fukuhara]
design: sobol
count: {count}
seed: 1
axes:
  - {{path: tools.spatula.motion.segments.0.speed_m_s, linear: {{from: 0.2, to: 0.4, count: 2}}}}
  - {{path: bodies.sphere.mass_kg, linear: {{from: 0.08, to: 0.12, count: 2}}}}
"""
ONE = """\
format: 1
name: one
base: {root}/configs/spatula_press.yaml
pipelines: [fukuhara]
axes: [{{path: force.hc.k, values: [200]}}]
curves: {{quantities: [force], every_s: 0.01}}
"""
MILLION = """\
format: 1
name: million
base: {root}/configs/spatula_press.yaml
pipelines: [fukuhara]
axes:
  - {{path: force.hc.k, logarithmic: {{from: 20, to: 2000, count: 100}}}}
  - {{path: force.hc.lambda, linear: {{from: 0, to: 1000, count: 100}}}}
  - {{path: force.hc.n, linear: {{from: 1.0, to: 2.9, count: 100}}}}
"""


class Sweeps:
    def __init__(self, program, folder):
        self.program, self.folder, self.number = program, folder, 0

    def run(self, sweep, *options):
        """A sweep into a new folder: its wall time, the front's largest memory in MiB, and the folder."""
        self.number += 1
        out = self.folder / f"out{self.number}"
        start = time.monotonic()
        front = subprocess.Popen([self.program, "sweep", sweep, "-o", out, *options], stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True)
        memory = 0
        while front.poll() is None:
            memory = max(memory, high_water(front.pid))
            time.sleep(0.005)
        wall = time.monotonic() - start
        if front.returncode:
            raise SystemExit(f"{sweep}: exit code {front.returncode}")
        return wall, memory, out

    def write(self, name, text, **values):
        path = self.folder / name
        path.write_text(text.format(root=ROOT, **values))
        return path


def high_water(pid):
    try:
        for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmHWM"):
                return int(line.split()[1]) / 1024
    except OSError:
        pass
    return 0


def laws(sweeps, pairs):
    """A sweep over 10,000 laws over one with a single law: its simulation, all of it, and what it leaves on the disk."""
    one = sweeps.write("one.yaml", ONE)
    many = ROOT / "configs/sweeps/hunt_crossley.yaml"
    simulations, walls, size = [], [], 0
    for _ in range(pairs):
        wall, _, out = sweeps.run(many)
        wall_one, _, out_one = sweeps.run(one)
        walls.append(wall / wall_one)
        simulations.append(simulated_s(out).max() / simulated_s(out_one).max())
        size = sum(p.stat().st_size for p in out.rglob("*") if p.is_file())
    return statistics.median(simulations), statistics.median(walls), size


def simulated_s(folder):
    """Wall time of each run's simulation: its scene and world built, all steps, measures and laws."""
    with h5py.File(folder / "sweep.h5") as table:
        return table["timing/simulation_wall_s"][:]


def workers(sweeps, count, slots):
    """Of `count` simulations: efficiency of `slots` workers against one, overhead of a run in ms for both, memory."""
    sweep = sweeps.write("distinct.yaml", DISTINCT, count=count)
    walls, overheads = [], []
    for jobs in (1, slots):
        wall, memory, out = sweeps.run(sweep, "-j", str(jobs))
        simulated = simulated_s(out).sum()
        walls.append(wall)
        overheads.append(1e3 * (jobs * wall - simulated) / count)
    return walls[0] / (slots * walls[1]), overheads, memory


def million(sweeps):
    """Wall time of a sweep over 10^6 laws, and that of its one simulation with all of them; the folder goes at once."""
    wall, _, out = sweeps.run(sweeps.write("million.yaml", MILLION), "-j", "1", "--yes")
    simulated = simulated_s(out).max()
    shutil.rmtree(out)
    return wall, simulated


def planning(sweeps, count):
    sweep = sweeps.write("planned.yaml", DISTINCT, count=count)
    start = time.monotonic()
    subprocess.run([sweeps.program, "sweep", sweep, "-o", sweeps.folder / "planned", "--dry-run"], check=True,
                   stdout=subprocess.DEVNULL)
    return time.monotonic() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/fissure")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/sweeps/cost.md")
    options = parser.parse_args()
    slots = os.cpu_count()
    with tempfile.TemporaryDirectory() as name:
        sweeps = Sweeps(options.program.resolve(), pathlib.Path(name))
        ratio, whole, size = laws(sweeps, options.pairs)
        small = workers(sweeps, options.count // 10, slots)[2]
        efficiency, overheads, large = workers(sweeps, options.count, slots)
        planned = planning(sweeps, 100000)
        wall, simulated = million(sweeps)
    rows = [
        ("simulation of one press with 10,000 Hunt-Crossley laws over that with one", f"{ratio:.2f}"),
        ("the whole sweep, with planning and output, over that with one law", f"{whole:.2f}"),
        ("what they leave on the disk: journal, table with curves, CSV", f"{size / 1e6:.1f} MB"),
        (f"{options.count} distinct simulations: efficiency of -j {slots} against -j 1", f"{efficiency:.2f}"),
        ("a run over its simulation alone, -j 1", f"{overheads[0]:.1f} ms"),
        (f"a run over its simulation alone, -j {slots} (in time of a worker)", f"{overheads[1]:.1f} ms"),
        (f"largest memory of the front with {options.count // 10} simulations", f"{small:.1f} MiB"),
        (f"with {options.count}", f"{large:.1f} MiB"),
        ("100,000 distinct simulations planned, three of them timed (--dry-run)", f"{planned:.1f} s"),
        ("a million laws over one press: planned, simulated, written", f"{wall:.0f} s"),
        ("of which its simulation with all the laws takes", f"{simulated:.0f} s"),
    ]
    lines = ["# What a sweep costs", "", "Made by `/usr/bin/python3 scripts/sweep_cost.py` on a machine with "
             f"{slots} cores.", "", "| | |", "|---|--:|", *(f"| {what} | {value} |" for what, value in rows)]
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
