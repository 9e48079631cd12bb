"""What scripts/fault_calls.py lets fail: programs in small folders, and the look at what is left of their files."""
import csv
import ctypes
import dataclasses
import hashlib
import json
import mmap
import os
import pathlib
import re
import resource
import shutil
import subprocess

import h5py

from fault_trial import HANG_S, fresh_signals
from result_bits import contents, first_difference

KINDS = ("open", "write", "truncate", "sync", "close", "rename", "remove", "mkdir", "link", "lock")
SCENARIO = """\
format: 1
name: press
description: A blade pressed into a soft sphere.
time: {step_s: 0.001, settle_s: 0.002, duration_s: 0.01}
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
    motion: {type: script, start_m: [0, 0.062, 0], segments: [{move_to_m: [0, 0.057, 0], speed_m_s: 0.5}]}
pipelines: [{pipeline: fukuhara, time_limit_s: 50}]
force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}]
"""
SWEEP = """\
format: 1
name: speeds
base: s.yaml
KEEP
axes:
  - {path: tools.spatula.motion.segments.0.speed_m_s, values: [0.5, 0.4]}
"""
STABILITY = """\
format: 1
name: maps
base: s.yaml
press: {steps: 50}
criteria: {force_N: 6, depth_m: 1, depth_of_thickness: 1e6, proved: false}
maps:
  - {name: weight, axes: [{path: bodies.sphere.mass_kg, values: [0.1, 1]}]}
"""
TRADEOFF = """\
format: 1
name: costs
base: s.yaml
pipelines: [fukuhara]
axes:
  - {path: time.step_s, values: [0.002]}
reference:
  pipeline: fukuhara
  ladder: {path: time.step_s, values: [0.001, 0.0005, 0.00025]}
errors:
  - {quantity: depth, tolerance: 0.1mm}
repeats: 1
"""


class Control(ctypes.Structure):
    """The control file of tests/faults/fault_injector.cpp."""
    _fields_ = [("calls", ctypes.c_uint64), ("failed", ctypes.c_uint64), ("first", ctypes.c_uint64),
                ("kinds", ctypes.c_uint64), ("again", ctypes.c_uint64), ("error", ctypes.c_int64),
                ("shorten", ctypes.c_uint64), ("clock_reads", ctypes.c_uint64), ("clock_from", ctypes.c_uint64),
                ("clock_shift_s", ctypes.c_int64), ("folder", ctypes.c_char * 4096), ("among", ctypes.c_char * 4096),
                ("what", ctypes.c_char * 4096)]


def bits(*kinds):
    return sum(1 << KINDS.index(kind) for kind in kinds)


@dataclasses.dataclass
class Case:
    """One command in a folder that other commands have filled before."""
    name: str
    before: list  # commands
    words: list
    again: list  # commands that complete what the first has not
    files: dict  # to write before
    kept: tuple = ()  # patterns of files that the command must leave as they are


def cases():
    run = ["run", "s.yaml", "-o", "out/run.h5"]
    scenario = {"s.yaml": SCENARIO}
    sweep = {**scenario, "sweep.yaml": SWEEP.replace("KEEP\n", "")}
    keeping = {**scenario, "sweep.yaml": SWEEP.replace("KEEP", "keep: results").replace(", 0.4", "")}
    two_kept = {**scenario, "sweep.yaml": SWEEP.replace("KEEP", "keep: results")}
    start, shard = ["sweep", "sweep.yaml", "-o", "d"], ["sweep", "sweep.yaml", "-o", "d", "--shard"]
    stability = ["study", "stability", "study.yaml", "-o", "d"]
    tradeoff = ["study", "tradeoff", "study.yaml", "-o", "d"]
    replaced = [*run, "--force"]
    earlier = ["run", "s.yaml", "-o", "out/earlier.h5"]
    in_runs = ("d/runs/*", "d/journals/*")
    return [
        Case("run", [earlier], run, [replaced], scenario, ("out/earlier.h5",)),
        Case("run --force", [run], replaced, [replaced], scenario),
        Case("sweep", [earlier], start, [start], sweep, ("out/earlier.h5",)),
        Case("sweep, keep: results", [], start, [start], keeping),
        Case("sweep, resumed", [[*shard, "1/2"]], ["sweep", "d"], [["sweep", "d"]], two_kept, in_runs),
        Case("sweep merge", [[*shard, "1/2"], [*shard, "2/2"]], ["sweep", "merge", "d"], [["sweep", "merge", "d"]], two_kept, in_runs),
        Case("study stability", [], stability, [stability], {**scenario, "study.yaml": STABILITY}),
        Case("study tradeoff", [], tradeoff, [tradeoff], {**scenario, "study.yaml": TRADEOFF}),
        Case("report of a result", [run], ["report", "out/run.h5"], [["report", "out/run.h5", "--force"]], scenario, ("out/run.h5",)),
        Case("report of a sweep", [start], ["report", "d"], [["report", "d", "--force"]], sweep, ("d/*.h5", "d/*.csv", "d/journals/*")),
        Case("report of a study", [stability], ["report", "d"], [["report", "d", "--force"]], {**scenario, "study.yaml": STABILITY},
             ("d/*/*/runs/*", "d/*.json", "d/*.csv")),
    ]


class Workshop:
    """Folders of cases as they are before a command and after an undisturbed one."""

    def __init__(self, top, programs):
        self.top, self.programs = pathlib.Path(top).resolve(), programs
        self.control_file = self.top / "control"
        self.control_file.write_bytes(bytes(ctypes.sizeof(Control)))
        with open(self.control_file, "r+b") as file:
            self.control = Control.from_buffer(mmap.mmap(file.fileno(), 0))

    def prepare(self, case):
        """The folder before; afterwards `folder` is what a trial may spoil, always of the same name."""
        self.folder, self.before, self.after = self.top / "trial", self.top / "before", self.top / "after"
        for folder in (self.folder, self.before, self.after):
            shutil.rmtree(folder, ignore_errors=True)
        self.folder.mkdir()
        (self.folder / "tmp").mkdir()
        for name, text in case.files.items():
            (self.folder / name).write_text(text)
        for words in case.before:
            assert self.run(words).returncode == 0, words
        shutil.copytree(self.folder, self.before)
        self.arm()
        self.undisturbed = self.run(case.words)
        assert self.undisturbed.returncode == 0, self.undisturbed
        self.calls, self.clock_reads = self.control.calls, self.control.clock_reads
        shutil.copytree(self.folder, self.after)
        self.names = set(names(self.after))
        self.replaces = self.names == set(names(self.before))

    def renew(self):
        shutil.rmtree(self.folder)
        shutil.copytree(self.before, self.folder)

    def arm(self, first=0, kinds=0, again=0, error=0, shorten=0, among="", clock_from=0, clock_shift_s=0):
        """`first`: the call that fails, from 1, of those of `kinds` on files with `among` in their paths; 0: none."""
        fields = {"first": first, "kinds": kinds or bits(*KINDS), "again": again, "error": error, "shorten": shorten,
                  "clock_from": clock_from, "clock_shift_s": clock_shift_s, "folder": str(self.folder).encode(), "among": among.encode(),
                  "what": b"", "calls": 0, "failed": 0, "clock_reads": 0}
        for name, value in fields.items():
            setattr(self.control, name, value)

    def start(self, words, engines=None, address_space=None, program="fissure"):
        """A program under whatever is armed, in a session of its own."""
        environment = dict(os.environ, LD_PRELOAD=str(self.programs / "libfault_injector.so"),
                           FISSURE_FAULTS=str(self.control_file), TMPDIR=str(self.folder / "tmp"))
        if engines:
            environment["FISSURE_ENGINE_DIR"] = str(engines)

        def prepare():
            fresh_signals()
            if address_space:
                resource.setrlimit(resource.RLIMIT_AS, (address_space, address_space))

        return subprocess.Popen([self.programs / program, *words], cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", preexec_fn=prepare,
                                start_new_session=True)

    def end(self, started):
        """What becomes of it; exit code "HANGS" where it has none within a minute."""
        try:
            out, err = started.communicate(timeout=HANG_S)
        except subprocess.TimeoutExpired:
            started.kill()
            started.communicate()
            return subprocess.CompletedProcess(started.args, "HANGS", "", "")
        return subprocess.CompletedProcess(started.args, started.returncode, out, err)

    def run(self, words, **how):
        return self.end(self.start(words, **how))


def names(folder):
    """All files, relative to the folder. Journals, whose names are drawn by chance, have the same name in each run."""
    found = []
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            found.append(re.sub(r"(journals/)\w{6}(\.journal)$", r"\1X\2", str(path.relative_to(folder))))
    return found


def json_without_times(item):
    if isinstance(item, dict):
        return {key: json_without_times(value) for key, value in item.items() if key not in ("wall_s", "cost", "front", "recorded_s")}
    return [json_without_times(value) for value in item] if isinstance(item, list) else item


def csv_without_times(text):
    lines = list(csv.reader(text.splitlines()))
    timed = {at for at, name in enumerate(lines[0] if lines else []) if re.search(r"wall_s|us_per|processor|memory|^front$|weighed", name)}
    return [[field for at, field in enumerate(line) if at not in timed] for line in lines]


def is_same(file, other):
    """Whether two files of the same name hold the same, outside of times and provenance."""
    if file.read_bytes() == other.read_bytes():
        return True
    try:
        if file.suffix == ".h5":
            return first_difference(contents(file), contents(other)) is None
        if file.suffix == ".json":
            return json_without_times(json.loads(file.read_text())) == json_without_times(json.loads(other.read_text()))
        if file.suffix == ".csv":
            return csv_without_times(file.read_text()) == csv_without_times(other.read_text())
    except (OSError, ValueError, KeyError):
        pass
    return False


def digest(folder, pattern):
    return {path: hashlib.sha256((folder / path).read_bytes()).digest() for path in
            sorted(str(path.relative_to(folder)) for path in folder.glob(pattern)) if (folder / path).is_file()}


def unlike(folder, reference):
    """Names that are in one alone, or differ. Journals hold times: their records are judged by the tables of them."""
    here, there = set(names(folder)), set(names(reference))
    same = {name for name in here & there if name.endswith(".journal") or is_same(folder / name, reference / name)}
    return sorted((here | there) - same)


def is_whole(shop, name):
    """Whether a file under a final name is complete in itself."""
    file = shop.folder / name
    try:
        if file.suffix == ".h5":
            with h5py.File(file) as opened:
                return bool(opened.attrs.get("complete", 1))
        if file.suffix == ".json":
            json.loads(file.read_text())
        if file.suffix == ".html":
            return file.read_text().rstrip().endswith("</html>")
        if file.suffix == ".csv":
            text = file.read_text()
            return text.endswith("\n") and len({len(fields) for fields in csv.reader(text.splitlines())}) == 1
        if file.suffix == ".yaml":
            return any((known / name).exists() and is_same(file, known / name) for known in (shop.before, shop.after))
    except (OSError, ValueError):
        return False
    return True
