"""One trial of scripts/fault_campaign.py: a front in a folder of its own, and the look at what is left."""
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import time

import h5py

ROOT = pathlib.Path(__file__).resolve().parent.parent
SAME_DATA = ROOT / "scripts/result_bits.py"
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


def fresh_signals():
    """For what is started: background jobs of a shell inherit SIGINT ignored, and Python ignores SIGPIPE."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE):
        signal.signal(number, signal.SIG_DFL)


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

        def prepare():
            fresh_signals()
            if file_bytes:
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))

        self.front = subprocess.Popen(
            [self.programs / "fissure", "run", "s.yaml", "-o", OUT, *options],
            cwd=self.folder, env=environment, preexec_fn=prepare, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def workers(self):
        return [pid for pid, state, name in session(self.front.pid)
                if name.startswith("fissure-engine") and state != "Z"]

    def run(self, *words):
        """A program of ours to its end; one that has none has the exit code "HANGS"."""
        return to_its_end([self.programs / "fissure", *words], self.folder)

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

    def parts(self, at_least=20000):
        """Those that have grown to so many bytes."""
        try:
            return [part for part in (self.folder / "out").glob(".run.h5.*/*.part") if part.stat().st_size > at_least]
        except OSError:  # just removed
            return []

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


def to_its_end(words, folder):
    try:
        return subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=HANG_S, preexec_fn=fresh_signals)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(words, "HANGS", "", "")


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


# What is looked at afterwards.


def result_status(trial, file):
    """Statuses of the runs in a result under a final name, or what is wrong with the file."""
    shown = trial.run("info", str(file), "--json")
    if shown.returncode == "HANGS":
        return "INFO HANGS"
    if shown.returncode != 0:
        return "INCOMPLETE"
    info = json.loads(shown.stdout)
    if not info["complete"] or [run["name"] for run in info["pipelines"]] != PIPELINES:
        return "INCOMPLETE"
    details = {re.sub(r"\b[01]\.part", "N.part", f"{run['status']}: {run['status_detail']}").rstrip(": ")
               for run in info["pipelines"]}
    bad = sorted(details - {"ok"})
    text = re.sub(r"step \d+ of \d+", "step N of M", "; ".join(bad) or "ok")
    return text.replace("before its first step", "after step N of M")


def is_beginning(part, whole):
    """Is all that a part holds, and it holds something, how the whole begins?"""
    with h5py.File(part) as one, h5py.File(whole) as other:
        if any("time" not in group or len(group["time"]) == 0 for group in one["pipelines"].values()):
            return False
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
        elif done.returncode == "HANGS":
            found.append("SALVAGE HANGS")
        else:
            in_one_line = done.returncode == 2 and done.stderr.count("\n") == 1
            found.append("nothing yet" if in_one_line else "SALVAGE FAILED")
    return found


def litter(trial):
    """Names that no document knows. A lock and a folder of parts are left only by a front that was killed."""
    killed = trial.outcome[0] == -signal.SIGKILL
    known = r"run(\.interrupted)?\.h5"
    if killed:
        known += r"|run\.h5\.\d+\.\d+\.tmp|\.run\.h5\.lock|\.run\.h5\.\w{6}"
    out = trial.folder / "out"
    names = [entry.name for entry in out.iterdir()] if out.exists() else []
    return [name for name in names if not re.fullmatch(known, name)]


def look(fault, trial, reference):
    """Lets the fault happen; what is seen after it."""
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
    comparison = [sys.executable, SAME_DATA, reference, trial.folder / OUT]
    same = again.returncode == 0 and to_its_end(comparison, trial.folder).returncode == 0
    names = {entry.name for entry in out.iterdir()} if out.exists() else set()
    seen["again"] = same and names - {"run.interrupted.h5"} == {"run.h5"}
    return seen


