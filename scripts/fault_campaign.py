#!/usr/bin/env python3
"""What faults leave behind: kills, stops, hanging and lying workers, damaged parts, full and read-only disks.

    /usr/bin/python3 scripts/fault_campaign.py [--programs build/release] [--kills 100] [--seed 1]
                                               [-o results/faults/README.md]

Each trial runs two pipelines of a small scenario in a folder of its own, lets one fault happen, and then looks: at
every file under a final name (whole, or none), at what else lies there, at processes still alive, at what can be
salvaged, and whether a second run completes and equals an undisturbed one outside timing/ and provenance. Exit
code 1 when any of that is not as promised, a program that does not end within a minute included. Full and
read-only file systems are mounted, which takes root; without it they are left out, and the table says so.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from fault_trial import LONG_S, OUT, PIPELINES, REPLAYED, ROOT, SCRIPTED, SHORT_S, Trial, look

BLOCK = 400000  # bytes of a part with a block of rows in it

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


def kill_front_after_a_block(trial):
    """After the first block of both runs."""
    trial.start("-j", "2")
    trial.until(lambda: len(trial.parts(BLOCK)) == len(PIPELINES))
    time.sleep(trial.rng.uniform(0, trial.time_s / 2))
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
    limit_s = f"{2 * trial.time_s + 1:.0f}"
    trial.start("-j", "2", *[f"--set=pipelines.{name}.time_limit_s={limit_s}" for name in PIPELINES])
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
        part = next(iter(trial.until(trial.parts) or []), None)
        trial.hit = bool(part)
        if part:
            damage(part, trial.rng)

    return fault


STRUCTURES = 64000  # about so many bytes at the start of a part; the rest are mostly values


def cut(part, _):
    os.truncate(part, part.stat().st_size // 2)


def overwrite(part, _):
    with open(part, "r+b") as file:
        file.write(b"not yours " * 2000)


def overwrite_some(part, rng):
    with open(part, "r+b") as file:
        file.seek(rng.randrange(min(STRUCTURES, part.stat().st_size)))
        file.write(b"\xff" * 64)


DAMAGING_ENGINE = """\
#!/bin/sh
"PROGRAMS/fissure-engine-f64" "$@" || exit
while [ "$1" != --part ]; do shift; done
case $2 in *0.part)
    head -c 64 /dev/zero | tr '\\0' '\\377' | dd of="$2" bs=1 seek=OFFSET conv=notrunc 2>/dev/null
esac
"""


def damage_whole_part(trial):
    """Of the first run alone, after its worker has ended."""
    engine = DAMAGING_ENGINE.replace("PROGRAMS", str(trial.programs))
    fake_engine(engine.replace("OFFSET", str(trial.rng.randrange(STRUCTURES))))(trial)


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


def remove(folder):
    """A worker may put a file into it meanwhile."""
    while folder.exists():
        shutil.rmtree(folder, ignore_errors=True)


def remove_folder(trial):
    trial.start("-j", "2")
    trial.until(trial.parts)
    remove(trial.folder / "out")


def remove_input(name, motion):
    def fault(trial):
        trial.write_scenario(motion)
        trial.write("log.csv", "t,x,y,z\n0,0,0.062,0\n0.02,0,0.052,0\n1,0,0.052,0\n")
        trial.start("-j", "2")
        trial.until(trial.workers)
        (trial.folder / name).unlink()
        trial.outcome = trial.end()
        trial.write_scenario(SCRIPTED)

    return fault


def run_twice(trial):
    trial.start("-j", "2")
    trial.until(trial.workers)
    trial.outcome = [2, trial.run("run", "s.yaml", "-o", OUT).stderr]
    first = trial.end()
    if first[0] != 0:
        trial.outcome[0] = first[0]
    elif trial.outcome[1] != OUT + ": is being written by another run\n":
        trial.outcome[0] = "not refused"


# What each promises: by exit code of the front what its result may record (a regular expression, None: no
# result), and for faults that leave parts, what these may become.

Promise = collections.namedtuple("Promise", "recorded parts", defaults=[set()])
ANY_PART, WHOLE_PARTS = {"salvaged", "nothing yet"}, {"salvaged"}
FRONT_DIES = {"-9": "no file|ok"}  # killed after the result got its name it is there, and whole
STOPPED = Promise({"130": "no file|interrupted.*", "0": "ok"})  # 0: all was done, the result was being written
TIMEOUT = r"timeout: time limit of [\d.]+ s reached after step N of M"
INPUT_CHANGED = "failed: an input file of the scenario was changed or removed while the runs went on"
NO_LOG = r'failed: resolved\.yaml:\d+: \S+ is "log.csv": no such file, expected a log'
UNDISTURBED = Promise({"0": "ok"})  # the fault came too late
SPACE = Promise({"0": "ok", "3": "no file|failed: .*"})
UNNOTICED = Promise({"0": "ok", "3": "(failed|crashed): .*"})  # what hits values is read as values


def fails(recorded):
    return Promise({"3": recorded})


def shares(kills):
    """Of a worker, of the front, of the front while it writes the result, of both."""
    some = kills // 5
    return 2 * some, some - some // 4, some // 4, some, kills - 4 * some


def faults(kills):
    """What the table calls it, the fault, how often, and what is promised."""
    of_worker, of_front, of_late_front, at_the_end, of_both = shares(kills)
    killed = fails(r"crashed: killed by signal 9 \(SIGKILL\) after step N of M")
    after_a_block = "kill -9 of the front in a long run, after its first block"
    return [
        ("kill -9 of a worker", kill_worker, of_worker, killed),
        ("kill -9 of the front", kill_front, of_front, Promise(FRONT_DIES, ANY_PART)),
        (after_a_block, kill_front_after_a_block, of_late_front, Promise(FRONT_DIES, WHOLE_PARTS)),
        ("kill -9 of the front while it writes the result", kill_front_at_the_end, at_the_end,
         Promise(FRONT_DIES, WHOLE_PARTS)),
        ("kill -9 of front and workers, in any order", kill_both, of_both, Promise(FRONT_DIES, ANY_PART)),
        *other_faults(max(1, kills // 33)),
    ]


def other_faults(few):
    flood = "#!/bin/sh\nwhile :; do head -c 100000 /dev/urandom; head -c 100000 /dev/urandom >&2; done\n"
    brief = ["--set=pipelines.default.time_limit_s=0.5", "--set=pipelines.fukuhara.time_limit_s=0.5"]
    noise = fake_engine("#!/bin/sh\nhead -c 300000 /dev/urandom\n")
    find_part = 'while [ "$1" != --part ]; do shift; done\n'
    liar = fake_engine("#!/bin/sh\n" + find_part + 'head -c 100000 /dev/urandom > "$2"\n')
    no_part = "failed: the worker left no whole part: N.part: "
    gone = r"failed: N\.part: cannot open: No such file or directory"
    return [
        ("SIGTERM to the front", request(signal.SIGTERM), few, STOPPED),
        ("SIGINT to the front", request(signal.SIGINT), few, STOPPED),
        ("worker stopped (SIGSTOP) under a time limit", stop_worker, few, fails(TIMEOUT)),
        ("worker prints noise for ever, under a time limit", fake_engine(flood, options=brief), 1, fails(TIMEOUT)),
        ("worker prints noise and ends with 0", noise, 1, fails(no_part + "no such file")),
        ("worker ends with 0 and leaves no part", fake_engine("#!/bin/sh\nexit 0\n"), 1, fails(no_part + "no such file")),
        ("worker ends with 0 and leaves noise as its part", liar, 1, fails(no_part + "not an HDF5 file.*")),
        ("worker is no program", fake_engine("not a program\n"), 1, fails("failed: cannot start .*: Exec format error")),
        ("worker may not be executed", fake_engine("#!/bin/sh\n", mode=0o644), 1, fails("no file")),
        ("part cut to its half under way", damage_part(cut), few, fails("failed: .*cut the file short|" + no_part + ".*")),
        ("part overwritten from its start under way", damage_part(overwrite), few, fails(r"failed: .*N\.part: .*")),
        ("64 bytes in the first 64 kB of a part overwritten under way", damage_part(overwrite_some), 2 * few, UNNOTICED),
        ("64 bytes in the first 64 kB of a whole part overwritten", damage_whole_part, 4 * few, UNNOTICED),
        ("part removed under way", damage_part(lambda part, rng: part.unlink()), few, fails(gone)),
        ("folder of the parts removed under way", damage_part(lambda part, rng: remove(part.parent)), few,
         fails(gone + r"; failed: resolved\.yaml: cannot be read")),
        ("file size limit (ulimit -f), any", limit_file_size, 2 * few, SPACE),
        ("full disk (tmpfs), any size", fill_disk, 2 * few, SPACE),
        ("read-only output folder (tmpfs)", read_only_folder, 1, Promise({"2": "no file"})),
        ("output folder removed under way", remove_folder, few, fails("no file")),
        ("scenario removed under way", remove_input("s.yaml", SCRIPTED), few, fails(INPUT_CHANGED)),
        ("log of a replay removed under way", remove_input("log.csv", REPLAYED), few,
         fails(f"{INPUT_CHANGED}|{NO_LOG}|{INPUT_CHANGED}; {NO_LOG}")),
        ("second run into the same file meanwhile", run_twice, few, Promise({"2": "ok"})),
    ]


KILLS = {kill_worker, kill_front, kill_front_after_a_block, kill_front_at_the_end, kill_both}
ROOT_ONLY = {fill_disk, read_only_folder}
LONG = {kill_front_after_a_block}


def counted(values):
    counts = collections.Counter(values)
    several = len(counts) > 1
    return "<br>".join(f"{count} x {value}" if several else value for value, count in counts.most_common())


def is_bad(seen, promise):
    recorded = promise.recorded.get(seen["exit"])
    kept = recorded and re.fullmatch(recorded, "; ".join(seen["recorded"])) and set(seen["salvaged"]) <= promise.parts
    lost = promise.parts == WHOLE_PARTS and seen["recorded"] == ["no file"] and not seen["salvaged"]
    return bool(not kept or lost or seen["alive"] or seen["litter"] or len(seen["message"]) > 1 or not seen["again"])


def incomplete_files(trials):
    return sum(seen["recorded"].count("INCOMPLETE") for seen in trials)


def row(name, trials):
    salvaged = counted([word for seen in trials for word in seen["salvaged"]]) or "-"
    again = sum(seen["again"] for seen in trials)
    alive = sum(seen["alive"] for seen in trials)
    litter = sum(len(seen["litter"]) for seen in trials)
    recorded = counted("; ".join(seen["recorded"]) for seen in trials)
    cells = [name, len(trials), counted(seen["exit"] for seen in trials), recorded, incomplete_files(trials), alive,
             litter, salvaged, f"{again} of {len(trials)}", sum(seen["bad"] for seen in trials)]
    return "| " + " | ".join(map(str, cells)) + " |"


HEAD = """\
# What faults leave behind

    /usr/bin/python3 scripts/fault_campaign.py --kills {kills} --seed {seed}

Two pipelines of a small scenario ({steps:,} steps each; {long_steps:,} in long runs), one fault, then a look.
Moments are drawn at random over the length of an undisturbed run ({short_s:.1f} and {long_s:.1f} s here); a kill that
came after the end was drawn again. Exit: of the front, negative for a signal. Recorded: in the result, of each run
that is not ok ("no file": nothing stands under the result's name). Incomplete: files under a final name that are not
whole. Alive: processes five seconds after the front's end. Litter: files that are not documented. Salvaged: parts
that a killed front had left; all that was salvaged is bit by bit the beginning of the undisturbed run, "nothing yet"
is said in one line. Again: second runs that completed, equal an undisturbed one outside timing/ and provenance, and
left nothing else. Bad: trials with anything not as promised: of each fault also the exit, what is recorded and what
becomes of the parts; whatever does not end within a minute is one.

**{trials} trials, {killed} of them kills (and {too_late} that came too late): {incomplete} incomplete files under a final
name, {alive} processes and {litter} undocumented files left behind, {salvaged} parts salvaged of {parts}, {again} of {trials} second
runs as undisturbed; {bad} trials not as promised.**

| fault | times | exit | recorded | incomplete | alive | litter | salvaged | again | bad |
|---|---|---|---|---|---|---|---|---|---|
"""
TAIL = """
Not noticed: values of a part that somebody overwrites in place, because they carry no check sums (its structures do),
and values overwritten in a finished result.
"""


def head(arguments, everything, killed, too_late, references):
    parts = [word for seen in everything for word in seen["salvaged"]]
    return HEAD.format(
        kills=arguments.kills, seed=arguments.seed, steps=round(SHORT_S / 0.001), long_steps=round(LONG_S / 0.001),
        short_s=references[SHORT_S][1], long_s=references[LONG_S][1], trials=len(everything), killed=killed,
        too_late=too_late, incomplete=incomplete_files(everything), alive=sum(seen["alive"] for seen in everything),
        litter=sum(len(seen["litter"]) for seen in everything), salvaged=parts.count("salvaged"), parts=len(parts),
        again=sum(seen["again"] for seen in everything), bad=sum(seen["bad"] for seen in everything))


def undisturbed(folder, programs, duration_s):
    """The result to compare with, and how long it took."""
    trial = Trial(folder, programs, None, duration_s)
    began = time.monotonic()
    if trial.run("run", "s.yaml", "-o", f"{duration_s}.h5", "-j", "2").returncode != 0:
        raise SystemExit("the undisturbed run failed")
    return folder / f"{duration_s}.h5", time.monotonic() - began


def one_trial(fault, programs, rng, references):
    """What was seen, and whether the fault came in time."""
    with tempfile.TemporaryDirectory() as folder:
        trial = Trial(pathlib.Path(folder), programs, rng, LONG_S if fault in LONG else SHORT_S)
        reference, trial.time_s = references[trial.duration_s]
        return look(fault, trial, reference), trial.hit


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/faults/README.md")
    arguments = parser.parse_args()
    rng = random.Random(arguments.seed)
    programs = arguments.programs.resolve()
    everything, rows, left_out, killed, too_late = [], [], [], 0, 0
    with tempfile.TemporaryDirectory() as top:
        references = {seconds: undisturbed(pathlib.Path(top), programs, seconds) for seconds in (SHORT_S, LONG_S)}
        for name, fault, times, promise in faults(arguments.kills):
            if fault in ROOT_ONLY and os.geteuid() != 0:
                left_out.append(name)
                continue
            trials = []
            while len(trials) < times:
                seen, hit = one_trial(fault, programs, rng, references)
                seen["bad"] = is_bad(seen, promise if hit else UNDISTURBED)
                if seen["bad"]:
                    print("NOT AS PROMISED", seen, file=sys.stderr, flush=True)
                if hit or seen["bad"]:
                    trials.append(seen)
                else:
                    too_late += 1
            everything += trials
            killed += len(trials) if fault in KILLS else 0
            rows.append(row(name, trials))
            print(rows[-1], flush=True)
    tail = "".join(f"\nLeft out, it takes root: {name}.\n" for name in left_out) + TAIL
    text = head(arguments, everything, killed, too_late, references) + "\n".join(rows) + "\n" + tail
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    calls = arguments.output.read_text().partition("\n## ")[1:] if arguments.output.exists() else ()
    arguments.output.write_text(text + "".join(calls))  # the section of scripts/fault_calls.py stays
    return 1 if any(seen["bad"] for seen in everything) else 0


if __name__ == "__main__":
    sys.exit(main())
