#!/usr/bin/env python3
"""What faults leave behind: kills, stops, hanging and lying workers, damaged parts, full and read-only disks.

    /usr/bin/python3 scripts/fault_campaign.py [--programs build/release] [--kills 100] [--seed 1] [-o results/faults/README.md]

Each trial runs two pipelines of a small scenario in a folder of its own, lets one fault happen, and then looks: at every file under
a final name (whole, or none), at what else lies there, at processes still alive, at what can be salvaged, and whether a second run
completes and equals an undisturbed one outside timing/ and provenance. Exit code 1 when any of that is not as promised. Full and
read-only file systems are mounted, which takes root; without it they are left out, and the table says so.
"""
import argparse
import collections
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAME_DATA = ROOT / "tests/programs/same_data.py"
HANG_S = 60
PATIENCE_S = 5
OUT = "out/run.h5"
PIPELINES = ["default", "fukuhara"]
SHORT_S = 1
LONG_S = 4.2  # two blocks of 2,101 rows: the first can be salvaged
SCENARIO = """\
format: 1
name: press
description: A blade pressed into a soft sphere.
time: {step_s: 0.001, settle_s: 0.005, duration_s: DURATION}
ground: {height_m: 0}
bodies:
  - name: sphere
    shape: {type: sphere, radius_m: 0.03, subdivisions: 1}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    material: {linear_stiffness: 0.5}
    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}
tools:
  - name: spatula
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    nodes: {resolution: [4, 4]}
    motion: MOTION
pipelines: [{pipeline: default}, {pipeline: fukuhara}]
force: [{name: hc, model: hunt_crossley}]
record: {snapshots_every_s: 0.01}
"""
SCRIPTED = "{type: script, start_m: [0, 0.062, 0], segments: [{move_to_m: [0, 0.052, 0], speed_m_s: 0.5}]}"
REPLAYED = "{type: replay, file: log.csv, time_column: t, position_columns: [x, y, z], position_unit: m}"


class Trial:
    """One folder, one front in it, one fault."""

    def __init__(self, folder, programs, rng, duration_s):
        self.folder, self.programs, self.rng, self.duration_s = folder, programs, rng, duration_s
        self.time_s = 0  # of an undisturbed run
        self.front = None
        self.outcome = None  # code and message of the front, when the fault has waited for it
        self.hit = True  # a kill that came too late does not count
        self.write_scenario(SCRIPTED)

    def write_scenario(self, motion):
        self.write("s.yaml", SCENARIO.replace("MOTION", motion).replace("DURATION", str(self.duration_s)))

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def start(self, *options, engines=None, file_bytes=None):
        environment = dict(os.environ, **({"FISSURE_ENGINE_DIR": str(engines)} if engines else {}))

        def limit():
            signal.signal(signal.SIGINT, signal.SIG_DFL)  # a shell's background jobs inherit it ignored
            if file_bytes:
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))

        self.front = subprocess.Popen(
            [self.programs / "fissure", "run", "s.yaml", "-o", OUT, *options],
            cwd=self.folder, env=environment, preexec_fn=limit, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def workers(self):
        return [pid for pid, state, name in session(self.front.pid) if name.startswith("fissure-engine") and state != "Z"]

    def run(self, *words):
        """A program of ours to its end."""
        return subprocess.run([self.programs / "fissure", *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=HANG_S)

    def until(self, found):
        """What `found` gives first; None when the front ends before."""
        while self.front.poll() is None:
            value = found()
            if value:
                return value
            time.sleep(0.001)
        return None

    def sometime(self):
        time.sleep(self.rng.uniform(0, self.time_s))

    def part(self):
        found = list((self.folder / "out").glob(".run.h5.*/*.part"))
        return found[0] if found and found[0].stat().st_size > 20000 else None

    def kill(self, pids, number=signal.SIGKILL):
        self.hit = bool(pids) and self.front.poll() is None
        for pid in pids:
            try:
                os.kill(pid, number)
            except ProcessLookupError:
                pass

    def end(self):
        """Code and message of the front, once it and all its workers are gone."""
        try:
            message = self.front.communicate(timeout=HANG_S)[1]
        except subprocess.TimeoutExpired:
            self.kill([self.front.pid])
            self.front.communicate()
            return "HANGS", ""
        return self.front.returncode, message

    def leftovers(self):
        for _ in range(PATIENCE_S * 100):
            alive = [pid for pid, state, _ in session(self.front.pid) if state != "Z"]
            if not alive:
                return 0
            time.sleep(0.01)
        self.kill(alive)
        return len(alive)


def session(leader):
    """(pid, state, name) of every process of a session; the front starts one of its own."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            text = stat.read_text()
        except OSError:
            continue
        name, fields = text[text.index("(") + 1 : text.rindex(")")], text[text.rindex(")") + 2 :].split()
        if int(fields[3]) == leader:
            found.append((int(stat.parent.name), fields[0], name))
    return found


# The faults. Each starts a run and lets it happen.


def kill_worker(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    trial.sometime()
    trial.kill(trial.workers()[:1])


def kill_front(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    trial.sometime()
    trial.kill([trial.front.pid])


def kill_both(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    trial.sometime()
    pids = trial.workers() + [trial.front.pid]
    trial.rng.shuffle(pids)
    trial.kill(pids)


def kill_front_at_the_end(trial):
    trial.start("-j", "2")
    trial.until(lambda: list((trial.folder / "out").glob("*.tmp")))
    time.sleep(trial.rng.uniform(0, 0.02))
    trial.kill([trial.front.pid])


def request(number):
    def fault(trial):
        trial.start("-j", "2")
        trial.until(trial.workers)
        trial.sometime()
        trial.kill([trial.front.pid], number)

    return fault


def stop_worker(trial):
    trial.start("-j", "2", *[f"--set=pipelines.{name}.time_limit_s={2 * trial.time_s + 1:.0f}" for name in PIPELINES])
    trial.until(trial.workers)
    trial.kill(trial.workers()[:1], signal.SIGSTOP)


def fake_engine(text, mode=0o755, options=()):
    def fault(trial):
        trial.write("fissure-engine-f64", text)
        (trial.folder / "fissure-engine-f64").chmod(mode)
        trial.start(*options, engines=trial.folder)

    return fault


def damage_part(damage):
    def fault(trial):
        trial.start()
        part = trial.until(trial.part)
        if part:
            damage(part)

    return fault


def cut(part):
    os.truncate(part, part.stat().st_size // 2)


def overwrite(part):
    with open(part, "r+b") as file:
        file.write(b"not yours " * 2000)


def limit_file_size(trial):
    trial.start("-j", "2", file_bytes=trial.rng.randrange(1000, 1500000))


def mount(trial, *options):
    (trial.folder / "out").mkdir()
    subprocess.run(["mount", "-t", "tmpfs", *options, "tmpfs", trial.folder / "out"], check=True)


def fill_disk(trial):
    mount(trial, "-o", f"size={trial.rng.randrange(8, 2500)}k")
    trial.start("-j", "2")


def read_only_folder(trial):
    mount(trial, "-o", "ro")
    trial.start()


def remove_folder(trial):
    trial.start("-j", "2")
    trial.until(trial.part)
    shutil.rmtree(trial.folder / "out")


def remove_scenario(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    (trial.folder / "s.yaml").unlink()
    trial.outcome = trial.end()
    trial.write_scenario(SCRIPTED)


def remove_log(trial):
    trial.write_scenario(REPLAYED)
    trial.write("log.csv", "t,x,y,z\n0,0,0.062,0\n0.02,0,0.052,0\n1,0,0.052,0\n")
    trial.start("-j", "2")
    trial.until(trial.workers)
    (trial.folder / "log.csv").unlink()
    trial.outcome = trial.end()
    trial.write_scenario(SCRIPTED)


def run_twice(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    trial.outcome = [2, trial.run("run", "s.yaml", "-o", OUT).stderr]
    trial.front.wait(HANG_S)
    if trial.outcome[1] != OUT + ": is being written by another run\n":
        trial.outcome[0] = "not refused"


ROOT_ONLY = {fill_disk, read_only_folder}
LONG = {kill_front}


def faults(kills):
    """What the table calls it, the fault, how often."""
    few = max(1, kills // 33)
    flood = "#!/bin/sh\nwhile :; do head -c 100000 /dev/urandom; head -c 100000 /dev/urandom >&2; done\n"
    brief = ["--set=pipelines.default.time_limit_s=0.5", "--set=pipelines.fukuhara.time_limit_s=0.5"]
    liar = '#!/bin/sh\nwhile [ "$1" != --part ]; do shift; done\nhead -c 100000 /dev/urandom > "$2"\n'
    return [
        ("kill -9 of a worker", kill_worker, kills * 4 // 10),
        ("kill -9 of the front", kill_front, kills // 5),
        ("kill -9 of the front while it writes the result", kill_front_at_the_end, kills // 5),
        ("kill -9 of front and workers, in any order", kill_both, kills - kills * 4 // 10 - kills // 5 - kills // 5),
        ("SIGTERM to the front", request(signal.SIGTERM), few),
        ("SIGINT to the front", request(signal.SIGINT), few),
        ("worker stopped (SIGSTOP) under a time limit", stop_worker, few),
        ("worker prints noise for ever, under a time limit", fake_engine(flood, options=brief), 1),
        ("worker prints noise and ends with 0", fake_engine("#!/bin/sh\nhead -c 300000 /dev/urandom\n"), 1),
        ("worker ends with 0 and leaves no part", fake_engine("#!/bin/sh\nexit 0\n"), 1),
        ("worker ends with 0 and leaves noise as its part", fake_engine(liar), 1),
        ("worker is no program", fake_engine("not a program\n"), 1),
        ("worker may not be executed", fake_engine("#!/bin/sh\n", mode=0o644), 1),
        ("part cut to its half under way", damage_part(cut), few),
        ("part overwritten from its start under way", damage_part(overwrite), few),
        ("part removed under way", damage_part(pathlib.Path.unlink), few),
        ("folder of the parts removed under way", damage_part(lambda part: shutil.rmtree(part.parent)), few),
        ("file size limit (ulimit -f), any", limit_file_size, 2 * few),
        ("full disk (tmpfs), any size", fill_disk, 2 * few),
        ("read-only output folder (tmpfs)", read_only_folder, 1),
        ("output folder removed under way", remove_folder, few),
        ("scenario removed under way", remove_scenario, few),
        ("log of a replay removed under way", remove_log, few),
        ("second run into the same file meanwhile", run_twice, few),
    ]


# What is looked at afterwards.


def result_status(trial, file):
    """Statuses of the runs in a result under a final name, or what is wrong with the file."""
    shown = trial.run("info", str(file), "--json")
    if shown.returncode != 0:
        return "INCOMPLETE"
    info = json.loads(shown.stdout)
    if not info["complete"] or [run["name"] for run in info["pipelines"]] != PIPELINES:
        return "INCOMPLETE"
    details = {f"{run['status']}: {run['status_detail']}".rstrip(": ") for run in info["pipelines"]}
    bad = sorted(details - {"ok"})
    return re.sub(r"step \d+ of \d+", "step N of M", "; ".join(bad) or "ok").replace("before its first step", "after step N of M")


def is_beginning(part, whole):
    with h5py.File(part) as one, h5py.File(whole) as other:
        for name, group in one["pipelines"].items():
            for key, dataset in group.items():
                if not isinstance(dataset, h5py.Dataset) or dataset.dtype.kind not in "fiu":
                    continue
                values, expected = dataset[()], other["pipelines"][name][key][()]
                if values.tobytes() != expected[tuple(slice(0, size) for size in values.shape)].tobytes():
                    return False
    return True


def salvage(trial, reference):
    """What becomes of each part that lies there."""
    found = []
    for number, part in enumerate(sorted((trial.folder / "out").glob(".run.h5.*/*.part"))):
        name = f"salvaged{number}.h5"
        done = trial.run("salvage", str(part.relative_to(trial.folder)), "-o", name)
        if done.returncode == 0:
            found.append("salvaged" if is_beginning(trial.folder / name, reference) else "SALVAGED WRONGLY")
        else:
            found.append("nothing yet" if done.returncode == 2 and done.stderr.count("\n") == 1 else "SALVAGE FAILED")
    return found


def litter(trial):
    """Names that no document knows. A lock and a folder of parts are left only by a front that was killed."""
    killed = trial.outcome[0] == -signal.SIGKILL
    known = r"run(\.interrupted)?\.h5"
    if killed:
        known += r"|run\.h5\.\d+\.\d+\.tmp|\.run\.h5\.lock|\.run\.h5\.\w{6}"
    out = trial.folder / "out"
    return [entry.name for entry in out.iterdir() if not re.fullmatch(known, entry.name)] if out.exists() else []


def run_trial(fault, trial, reference):
    fault(trial)
    trial.outcome = trial.outcome or trial.end()
    out = trial.folder / "out"
    results = sorted(out.glob("*.h5")) if out.exists() else []
    seen = {
        "exit": str(trial.outcome[0]),
        "recorded": [result_status(trial, file) for file in results] or ["no file"],
        "alive": trial.leftovers(),
        "salvaged": salvage(trial, reference),
        "litter": litter(trial),
        "message": [line for line in trial.outcome[1].splitlines() if not re.match(r"\d+/\d+ runs, ", line)],
    }
    if os.path.ismount(out):
        subprocess.run(["umount", out], check=True)
    again = trial.run("run", "s.yaml", "-o", OUT, "-j", "2", "--force")
    same = again.returncode == 0 and subprocess.run(
        [sys.executable, SAME_DATA, reference, trial.folder / OUT], capture_output=True).returncode == 0
    names = {entry.name for entry in out.iterdir()} - {"run.interrupted.h5"}
    seen["again"] = same and names == {"run.h5"}
    return seen


def counted(values):
    counts = collections.Counter(values)
    return "<br>".join(value if len(counts) == 1 else f"{count} x {value}" for value, count in counts.most_common())


def is_bad(seen):
    words = " ".join([seen["exit"], *seen["recorded"], *seen["salvaged"]])
    return bool(seen["alive"] or seen["litter"] or len(seen["message"]) > 1 or not seen["again"]
                or re.search("INCOMPLETE|HANGS|WRONGLY|FAILED|not refused", words))


def row(name, trials):
    incomplete = sum(seen["recorded"].count("INCOMPLETE") for seen in trials)
    salvaged = counted([word for seen in trials for word in seen["salvaged"]]) or "-"
    again = sum(seen["again"] for seen in trials)
    alive = sum(seen["alive"] for seen in trials)
    litter_seen = sum(len(seen["litter"]) for seen in trials)
    cells = [name, len(trials), counted(seen["exit"] for seen in trials), counted("; ".join(seen["recorded"]) for seen in trials),
             incomplete, alive, litter_seen, salvaged, f"{again} of {len(trials)}"]
    return "| " + " | ".join(map(str, cells)) + " |"


HEAD = """\
# What faults leave behind

    /usr/bin/python3 scripts/fault_campaign.py --kills {kills} --seed {seed}

Two pipelines of a small scenario (1,000 steps each; 4,200 for the second row), one fault, then a look; {trials} trials, {kills} of them kills. Moments are drawn at
random over the length of an undisturbed run; a kill that came after the end was drawn again. Exit: of the front, negative for a signal. Recorded: in the result, of each run that is not ok
("no file": nothing stands under the result's name). Incomplete: files under a final name that are not whole. Alive: processes five seconds
after the front's end. Litter: files that are not documented. Salvaged: parts that a killed front had left; all that was salvaged is bit by
bit the beginning of the undisturbed run, "nothing yet" says so in one line. Again: second runs that completed, equal an undisturbed one
outside timing/ and provenance, and left nothing else.

**{incomplete} incomplete files under a final name, {bad} of {trials} trials not as promised.**

| fault | times | exit | recorded | incomplete | alive | litter | salvaged | again |
|---|---|---|---|---|---|---|---|---|
"""
TAIL = """
Not noticed: values of a part that somebody overwrites in place, because they carry no check sums (its structures do), and values overwritten
in a finished result. HDF5 1.10 can crash while it copies a part whose inner structures were overwritten; no file stands under a final name
then.
"""


def undisturbed(folder, programs, duration_s):
    """The result to compare with, and how long it took."""
    trial = Trial(folder, programs, None, duration_s)
    began = time.monotonic()
    if trial.run("run", "s.yaml", "-o", f"{duration_s}.h5", "-j", "2").returncode != 0:
        raise SystemExit("the undisturbed run failed")
    return folder / f"{duration_s}.h5", time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/faults/README.md")
    arguments = parser.parse_args()
    rng = random.Random(arguments.seed)
    everything, rows, left_out = [], [], []
    with tempfile.TemporaryDirectory() as top:
        programs = arguments.programs.resolve()
        references = {duration_s: undisturbed(pathlib.Path(top), programs, duration_s) for duration_s in (SHORT_S, LONG_S)}
        for name, fault, times in faults(arguments.kills):
            if fault in ROOT_ONLY and os.geteuid() != 0:
                left_out.append(name)
                continue
            trials = []
            while len(trials) < times:
                with tempfile.TemporaryDirectory() as folder:
                    trial = Trial(pathlib.Path(folder), programs, rng, LONG_S if fault in LONG else SHORT_S)
                    reference, trial.time_s = references[trial.duration_s]
                    seen = run_trial(fault, trial, reference)
                    if trial.hit:
                        trials.append(seen)
            everything += trials
            rows.append(row(name, trials))
            print(rows[-1], flush=True)
            for seen in filter(is_bad, trials):
                print("NOT AS PROMISED", seen, file=sys.stderr, flush=True)
    bad = sum(map(is_bad, everything))
    incomplete = sum(seen["recorded"].count("INCOMPLETE") for seen in everything)
    head = HEAD.format(kills=arguments.kills, seed=arguments.seed, trials=len(everything), incomplete=incomplete, bad=bad)
    tail = "".join(f"\nLeft out, it takes root: {name}.\n" for name in left_out) + TAIL
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    arguments.output.write_text(head + "\n".join(rows) + "\n" + tail)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
