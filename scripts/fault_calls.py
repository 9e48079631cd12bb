#!/usr/bin/env python3
"""What is left when calls that change files fail, one after another, and after other faults of the system.

    /usr/bin/python3 scripts/fault_calls.py [--programs build/release] [--seed 1] [--every 1] [--every-study K] [--every-other 8]
                                            [--few 6] [--case NAME ...] [-o results/faults/README.md]
    /usr/bin/python3 scripts/fault_calls.py --check

Each trial runs one command in a small folder; a preloaded library (tests/faults) lets the N-th call fail that
opens, writes, truncates, syncs, closes, renames, removes or locks a file below that folder, in the front or in a
worker, for N = 1, 2, ... until there is no such call. Then it looks at what is left, and runs the command again.
Writes its section of the page, in which the rows of other commands than --case stay as they are; --check runs a few
trials of each and writes nothing. Exit code 1 when anything is not as promised.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import errno
import os
import pathlib
import random
import re
import sys
import tempfile

from fault_cases import KINDS, Workshop, bits, cases, digest, is_whole, names, unlike
from fault_system import system_faults
from fault_trial import ROOT

HEADING = "## Calls that fail, and other faults of the system\n"
FULL = bits("open", "write", "truncate", "sync", "mkdir")  # what needs room


@dataclasses.dataclass
class Mode:
    """How calls fail; `arm` is what Workshop.arm() takes."""
    name: str
    arm: dict
    harmless: bool = False  # nothing may be lost


EVERY_CALL = Mode("EIO, once", {"error": errno.EIO})
OTHER_MODES = [
    Mode("ENOSPC, from then on", {"error": errno.ENOSPC, "again": FULL}),
    Mode("half a write, then ENOSPC", {"error": errno.ENOSPC, "again": FULL, "kinds": bits("write"), "shorten": 1}),
    Mode("half a write, once", {"error": errno.ENOSPC, "kinds": bits("write"), "shorten": 1}, harmless=True),
    Mode("EIO, all from then on", {"error": errno.EIO, "again": bits(*KINDS)}),
]
# Single calls for --check, each of which a version of the program did not stand: the command, how and which calls fail.
SINGLE = [
    ("sweep merge", EVERY_CALL, "lock", ".starting"),
    ("sweep merge", EVERY_CALL, "rename", ".journal"),
    ("sweep merge", OTHER_MODES[0], "open", "sweep.csv"),
    ("study stability", EVERY_CALL, "open", ".order"),
    ("study stability", EVERY_CALL, "write", ".part"),
    ("study stability", OTHER_MODES[1], "write", "study.json"),
    ("study stability", OTHER_MODES[1], "write", "cells.csv"),
    ("study stability", OTHER_MODES[1], "write", "fukuhara.yaml"),
    ("study tradeoff", EVERY_CALL, "write", ".record"),
    ("report of a result", EVERY_CALL, "lock", ".lock"),
    ("report of a result", OTHER_MODES[3], "write remove", ".tmp"),
]
# Leftovers that the next run removes, or takes over; those of a command that could not remove what it had made.
UNREMOVED = r".*\.lock|out/\.run\.h5\.\w{6}/.*|.*\.tmp|.*\.part|.*\.work/.*|.*/journals/.*|tmp/.*"


@dataclasses.dataclass
class Seen:
    """After one trial."""
    kind: str  # of the first call that failed
    call: str
    exit: int
    lost: list  # files that are missing, or other than undisturbed
    litter: list
    incomplete: list
    changed: list  # what the command should have left as it was
    message: list
    again: bool | None     # whether a second run completed as undisturbed; None: it had nothing to do
    bad: list = dataclasses.field(default_factory=list)


def message_of(ended):
    """What is said of a failure: lines that are neither progress nor a warning."""
    return [line for line in ended.stderr.splitlines() if line and not re.match(r"round \d+: |\S+: warning: |\d+/\d+ ", line)]


def names_what_failed(line):
    return "memory" in line or re.search(r"[\w-]+\.(h5|part|yaml|csv|json|html|journal|tmp|order|record)\b|\b(d|out)(/\w+)*: ", line) is not None


def look(shop, case, ended, kind="", call="", mode=Mode("", {})):
    """At what `ended` has left; runs the case again."""
    different = unlike(shop.folder, shop.after)
    kept = {pattern: digest(shop.before, pattern) for pattern in case.kept}
    changed = [path for pattern, files in kept.items() for path, hashed in files.items()
               if digest(shop.folder, pattern).get(path) != hashed]
    seen = Seen(kind, call, ended.returncode, [name for name in different if name in shop.names],
                [name for name in different if name not in shop.names],
                [name for name in names(shop.folder) if name in shop.names and not is_whole(shop, name)],
                changed, message_of(ended), None)
    recorded = re.search(r"\b(failed|crashed|timeout)\b", ended.stdout) is not None
    reason = os.strerror(shop.control.error) if shop.control.error else ""
    complete = not different and not any(name.endswith(".journal") for name in shop.names)
    if not complete and unlike(shop.folder, shop.before):  # else the second run has nothing to do, or is the undisturbed one
        shop.arm()
        codes = [shop.run(words).returncode for words in case.again]
        seen.again = not any(codes) and not unlike(shop.folder, shop.after)
    judge(seen, recorded, reason)
    judge_by_mode(seen, mode, shop.replaces)
    return seen


def judge(seen, recorded, reason):
    """`recorded`: the command has shown a run that failed. `reason`: what the system says of the call that failed."""
    if seen.exit == "HANGS" or seen.exit < 0:
        seen.bad.append("no exit code")
    if seen.exit == 0 and seen.lost:
        seen.bad.append("false success")
    if seen.exit != 0 and not recorded and (len(seen.message) != 1 or not names_what_failed(seen.message[0])):
        seen.bad.append("no clear line")
    if seen.kind and seen.message and reason not in seen.message[0]:
        seen.bad.append("another reason")
    if len(seen.message) > 1 or (seen.exit == 0 and seen.message):
        seen.bad.append("lines too many")
    if seen.incomplete:
        seen.bad.append("incomplete file")
    if seen.changed:
        seen.bad.append("finished file changed")
    if seen.again is False:
        seen.bad.append("second run differs")


def judge_by_mode(seen, mode, replaces):
    """Only where removing fails may anything lie there that no document knows; cleaning up that fails once is no failure. `replaces`: what the command
    makes was there before, and so tells nothing about what it did."""
    if seen.exit != 0 and not seen.lost and not replaces and seen.kind in ("remove", "lock") and not mode.arm.get("again"):
        seen.bad.append("false alarm")
    excused = seen.kind in ("remove", "close") or mode.arm.get("again", 0) & bits("remove")
    if any(not (excused and re.fullmatch(UNREMOVED, name)) for name in seen.litter):
        seen.bad.append("litter")


def one_call(shop, case, mode, first, **only):
    """What is seen after the call of this number has failed; None: there is no such call."""
    shop.renew()
    shop.arm(first=first, **{**mode.arm, **only})
    ended = shop.run(case.words)
    if shop.control.failed == 0:
        return None
    kind, _, call = shop.control.what.decode(errors="replace").partition(" ")
    seen = look(shop, case, ended, kind, call, mode)
    if mode.harmless and ended.returncode != 0:
        seen.bad.append("false alarm")
    return seen


def calls_in_turn(shop, case, mode, every, rng):
    first, found = rng.randint(1, every), []
    while True:
        seen = one_call(shop, case, mode, first)
        if seen is None:
            return found
        report(shop, case.name, mode.name, first, seen)
        found.append(seen)
        first += every


def report(shop, case, fault, number, seen):
    if seen.bad:
        call = seen.call.replace(str(shop.folder) + "/", "")
        print(f"NOT AS PROMISED: {case}, {fault}, {number} ({seen.kind} {call}): {', '.join(seen.bad)}; {seen}",
              file=sys.stderr, flush=True)


def counted(words):
    return ", ".join(f"{count} {word}" for word, count in collections.Counter(words).most_common())


def row(case, fault, calls, found):
    """A line of the table; `calls`: of the undisturbed command."""
    kinds = counted(seen.kind for seen in found if seen.kind)
    count = lambda test: sum(1 for seen in found if test(seen))
    cells = [case, fault, calls, f"{len(found)}" + (f": {kinds}" if kinds else ""), counted(str(seen.exit) for seen in found),
             count(lambda seen: seen.lost), count(lambda seen: "false success" in seen.bad), count(lambda seen: seen.incomplete),
             count(lambda seen: seen.changed), count(lambda seen: seen.litter), f"{count(lambda seen: seen.again)} of {count(lambda seen: seen.again is not None)}",
             count(lambda seen: seen.bad)]
    return "| " + " | ".join(map(str, cells)) + " |"


TEXT = """
    {command}

One command in a small folder (a scenario of 10 steps, sweeps and studies of a few), and one fault. A preloaded library counts
the calls below that folder that open a file for writing, write, truncate, sync, close, rename, remove, link, make a folder or
lock, of the front and its workers together, and lets the N-th fail: {every} in turn with EIO{of_studies}, and
{every_other} in the other ways. Once: that call alone. From then on: ENOSPC whatever needs room,
EIO everything, cleaning up included. Calls: of the undisturbed command. Failed: trials, by the first call that failed. Exit: how
often which code. Lost: trials after which a final file is missing or other than undisturbed, of which **falsely** with exit
code 0. Incomplete: a file under a final name that is not whole. Changed: results that were finished before, and are not bit by
bit the same. Litter: trials that left what a command removes at its end, because removing itself failed; the second run
removes it. Again: second runs without a fault that completed and equal the undisturbed one in all files, outside
timing/ and provenance, of those that had something to do. Bad: trials with anything not as promised: also a failure without one line that names the file and the
system's reason, an alarm though all is there, or no end within a minute.

**{trials} trials: {lost} lost something, {falsely} of them falsely; {incomplete} incomplete files, {changed} changed results, {again} of {seconds} second runs
as undisturbed, {bad} not as promised.**

| command | fault | calls | failed | exit | lost | falsely | incomplete | changed | litter | again | bad |
|---|---|--:|---|---|--:|--:|--:|--:|--:|---|--:|
"""


def nth(every):
    return "each" if every == 1 else f"one in {every}"


def in_order(rows, page):
    """Those rows in the order of the commands, with those of other commands that the page has."""
    table = re.findall(r"^\| .*\|$", page.read_text(encoding="utf-8").partition(HEADING)[2], re.MULTILINE)[1:] if page.exists() else []
    names_of = [case.name for case in cases()]
    name_of = lambda line: line.split(" | ")[0].removeprefix("| ")
    again = {name_of(line) for line in rows}
    return sorted([line for line in table if name_of(line) in names_of and name_of(line) not in again] + rows, key=lambda line: names_of.index(name_of(line)))


def section(arguments, rows):
    def total(column, part=0):
        return sum(int(re.findall(r"\d+", line.split(" | ")[column])[part]) for line in rows)
    command = (f"/usr/bin/python3 scripts/fault_calls.py --every {arguments.every} --every-study {arguments.every_study} "
               f"--every-other {arguments.every_other} "
               f"--few {arguments.few} --seed {arguments.seed} -o results/faults/README.md")
    of_studies = "" if arguments.every_study == arguments.every else f" (of studies {nth(arguments.every_study)})"
    return HEADING + TEXT.format(
        command=command, every=nth(arguments.every), of_studies=of_studies, every_other=nth(arguments.every_other),
        trials=total(3), lost=total(5), falsely=total(6), incomplete=total(7), changed=total(8), again=total(10), seconds=total(10, 1),
        bad=total(11)) + "\n".join(rows) + "\n"


def write_section(page, text):
    """Puts the text in the place of the section of before; what stands above it is that of scripts/fault_campaign.py."""
    page.parent.mkdir(parents=True, exist_ok=True)
    above = page.read_text().partition(HEADING)[0].rstrip() if page.exists() else ""
    page.write_text(above + "\n\n" + text)


def part(arguments, case_name, mode):
    """Rows and what was seen of one command under one way to fail, or (without a mode) under the other faults, in a folder of its own."""
    case = next(case for case in cases() if case.name == case_name)
    rng = random.Random(f"{arguments.seed} {case_name} {mode.name if mode else ''}")
    with tempfile.TemporaryDirectory() as top:
        shop = Workshop(top, arguments.programs.resolve())
        shop.prepare(case)
        if mode:
            of_case = arguments.every_study if case_name.startswith("study") else arguments.every
            every = of_case if mode == EVERY_CALL else arguments.every_other
            found = [(mode.name, shop.calls, calls_in_turn(shop, case, mode, every, rng))]
        else:
            found = [(fault, "", seen) for fault, seen in system_faults(shop, case, arguments.few, rng, look, report)]
    return [row(case.name, fault, calls, seen) for fault, calls, seen in found], [one for _, _, seen in found for one in seen]


def campaign(arguments):
    """Rows of the table, and all that was seen."""
    rows, everything = [], []
    with concurrent.futures.ProcessPoolExecutor(arguments.jobs) as pool:
        parts = [pool.submit(part, arguments, case.name, mode) for case in cases() if not arguments.case or case.name in arguments.case
                 for mode in (EVERY_CALL, *OTHER_MODES, None)]
        for done in parts:
            of_part, seen = done.result()
            rows += of_part
            everything += seen
            print("\n".join(of_part), flush=True)
    return rows, everything


def check(shop, rng):
    """A few trials, the same each time: single calls, and some of the commands that do most."""
    everything = []
    for case in cases():
        single = [words[1:] for words in SINGLE if words[0] == case.name]
        if not single and case.name not in ("run", "sweep"):
            continue
        shop.prepare(case)
        for mode, kind, among in single:
            seen = one_call(shop, case, mode, 1, kinds=bits(*kind.split()), among=among)
            assert seen, f"{case.name}: nothing is to {kind} of {among}"
            report(shop, case.name, mode.name, f"first {kind} of {among}", seen)
            everything.append(seen)
        if not single:
            for mode, every in [(EVERY_CALL, 40)] + [(mode, 150) for mode in OTHER_MODES]:
                everything += calls_in_turn(shop, case, mode, every, rng)
            for _, found in system_faults(shop, case, 1, rng, look, report):
                everything += found
    print(f"{len(everything)} trials, {sum(1 for seen in everything if seen.bad)} not as promised")
    return everything


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=int, default=1, help="let every K-th call fail with EIO, from one drawn by the seed")
    parser.add_argument("--every-study", type=int, help="the same for studies, which make thousands of calls (as --every)")
    parser.add_argument("--every-other", type=int, default=8, help="the same for the other ways to fail")
    parser.add_argument("--few", type=int, default=6, help="trials of each other fault")
    parser.add_argument("--case", action="append", help="this command alone (repeatable)")
    parser.add_argument("--check", action="store_true", help="a few trials, no page")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="the page; without it no page")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), help="commands side by side")
    arguments = parser.parse_args()
    arguments.every_study = arguments.every_study or arguments.every
    if arguments.check:
        with tempfile.TemporaryDirectory() as top:
            shop = Workshop(top, arguments.programs.resolve())
            return 1 if any(seen.bad for seen in check(shop, random.Random(arguments.seed))) else 0
    rows, everything = campaign(arguments)
    if arguments.output:
        write_section(arguments.output, section(arguments, in_order(rows, arguments.output)))
    return 1 if any(seen.bad for seen in everything) else 0


if __name__ == "__main__":
    sys.exit(main())
