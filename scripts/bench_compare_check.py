#!/usr/bin/env python3
"""Shows what scripts/bench-compare sees and what it does not, and writes results/bench_compare/README.md.

    scripts/bench_compare_check.py [--runs 20] [--same-runs 50] [--percent 2 5 10 20] [--filter '^detect/'] [-o PAGE]

A throw-away clone of this repository's HEAD gets a commit whose detector is slower: NodeContact::step waits, in a busy
loop after its work, for a share of the time that the work took. The share is that of FISSURE_SLOWER_PERCENT in the
environment, so that one build serves all. bench-compare runs for HEAD against itself, where any warning is a false one,
and for HEAD against that commit with each of the shares, where every detect/ case should be called slower; the kinds of
runs take turns. The whole of it takes hours; the page is written anew after each turn, so that what is stopped leaves
what it has found.

--scaled builds nothing: both sides are build/release/bench/fissure-bench as it is, and a script around it multiplies
the times of these cases by 1 plus the share. The noise is then that of this machine, and the slow-down is exact. With
--runs 6 --same-runs 12 --filter '^detect/(128|512)/' a quarter of an hour.
"""
import argparse
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DETECTOR = "src/simulation/contact/node_contact.cpp"
START = """  static const double share = [] {
    const char* const percent = std::getenv("FISSURE_SLOWER_PERCENT");
    return percent ? std::atof(percent) / 100 : 0.0;
  }();
  const auto start = std::chrono::steady_clock::now();
"""
END = """  // So much more, for scripts/bench_compare_check.py.
  const auto end = std::chrono::steady_clock::now();
  while (share > 0 && std::chrono::steady_clock::now() - end < (end - start) * share) {
  }
"""


# Of --scaled: the program of both commits, of which one is slower.
SCALED = """#!/usr/bin/python3 -BSE
import json, os, subprocess, sys
finished = subprocess.run([{program!r}, *sys.argv[1:]], capture_output=True, text=True)
sys.stderr.write(finished.stderr)
if finished.returncode or "--benchmark_format=json" not in sys.argv:
    sys.stdout.write(finished.stdout)
    sys.exit(finished.returncode)
found = json.loads(finished.stdout)
factor = 1 + {is_slow} * float(os.environ["FISSURE_SLOWER_PERCENT"]) / 100
for entry in found["benchmarks"]:
    if entry["name"].startswith("detect/") and "/swept/" not in entry["name"]:
        entry["real_time"] *= factor
print(json.dumps(found))
"""
SCALED_CMAKE = """cmake_minimum_required(VERSION 3.25)
project(scaled NONE)
add_custom_target(fissure-bench COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/program bench/fissure-bench)
"""


def git(clone, *words):
    finished = subprocess.run(["git", "-C", clone, *words], check=True, capture_output=True, text=True)
    return finished.stdout.strip()


def slow_down(text):
    """The detector's source with the busy loop at the end of NodeContact::step."""
    head = text.index("void NodeContact::step(")
    body = text.index("{\n", head) + 2
    end = text.index("\n}\n", body) + 1
    return "#include <chrono>\n#include <cstdlib>\n" + text[:body] + START + text[body:end] + END + text[end:]


def make_clone(folder):
    """A clone with the branches 'plain' (this HEAD) and 'slow'."""
    clone = folder / "clone"
    subprocess.run(["git", "clone", "-q", ROOT, clone], check=True)
    git(clone, "checkout", "-q", "-b", "plain")
    git(clone, "checkout", "-q", "-b", "slow")
    (clone / DETECTOR).write_text(slow_down((clone / DETECTOR).read_text()))
    git(clone, "-c", "user.name=fissure", "-c", "user.email=fissure@localhost", "commit", "-qam", "slower")
    return clone


def make_scaled(folder):
    """A repository with those branches whose programs run the one that is built, one of them with scaled times."""
    program = ROOT / "build/release/bench/fissure-bench"
    if not program.exists():
        raise SystemExit(f"{program}: no such file, scripts/build release fissure-bench makes it")
    clone = folder / "clone"
    subprocess.run(["git", "init", "-q", "-b", "plain", clone], check=True)
    (clone / "CMakeLists.txt").write_text(SCALED_CMAKE)
    for branch, is_slow in (("plain", 0), ("slow", 1)):
        if is_slow:
            git(clone, "checkout", "-q", "-b", branch)
        (clone / "program").write_text(SCALED.format(program=str(program), is_slow=is_slow))
        (clone / "program").chmod(0o755)
        git(clone, "add", ".")
        git(clone, "-c", "user.name=fissure", "-c", "user.email=fissure@localhost", "commit", "-qm", branch)
    return clone


def compare(clone, head, percent, pattern):
    file = clone.parent / "report.json"
    command = [ROOT / "scripts/bench-compare", "plain", head, "--repository", clone, "--json", file]
    command += ["--filter", pattern] if pattern else []
    environment = {**os.environ, "FISSURE_SLOWER_PERCENT": str(percent)}
    load = os.getloadavg()[0]
    finished = subprocess.run(command, capture_output=True, text=True, env=environment)
    if finished.returncode:
        raise SystemExit(finished.stderr)
    return {**json.loads(file.read_text()), "load": load}


def names_with(report, verdict):
    return {line["name"] for line in report["benchmarks"] if line["verdict"] == verdict}


def is_case(name):
    """Of the detector alone; the cases of swept contact have another one."""
    return name.startswith("detect/") and not name.endswith("/swept")


def of_detector(report):
    return [line for line in report["benchmarks"] if is_case(line["name"])]


def uses_detector(name):
    """Steps of these pipelines are slower too, by the detector's part in them."""
    return is_case(name) or name.startswith("step/") and name.endswith(("fukuhara", "raycast"))


def summary_row(percent, reports):
    """What became of one kind of runs."""
    lines = [line for report in reports for line in of_detector(report)]
    counts = {verdict: sum(line["verdict"] == verdict for line in lines) for verdict in ("slower", "undecided", "same", "faster")}
    seen = sum(any(line["verdict"] == "slower" for line in of_detector(report)) for report in reports)
    others = [name for report in reports for name in sorted(names_with(report, "slower")) if not uses_detector(name)]
    ratios = sorted(line["ratio"] for line in lines)
    cells = [f"{percent:g} %", f"{seen} of {len(reports)}", f"{counts['slower']} of {len(lines)}", counts["undecided"],
             counts["same"], counts["faster"], ", ".join(others) or "none", f"{ratios[0]:.3f} to {ratios[-1]:.3f}"]
    return "| " + " | ".join(map(str, cells)) + " |"


def own_row(reports):
    """Of a commit against itself: all benchmarks count."""
    lines = [line for report in reports for line in report["benchmarks"]]
    quiet = sum(not names_with(report, "slower") for report in reports)
    wrong = [line["name"] for line in lines if line["verdict"] in ("slower", "faster")]
    undecided = sum(line["verdict"] == "undecided" for line in lines)
    return quiet, wrong, undecided, len(lines)


SLOW_DOWNS = {
    False: ["detector (`NodeContact::step`) waits in a busy loop for a share of its own time."],
    True: ["times of detect/ (without swept contact's) a script multiplies by 1 plus the share; both run the same program."],
}
NOTES = {
    False: ["The share is of the detector's own time: what a case does besides makes its ratio smaller, the two looks at the",
            "clock make that of a short one larger."],
    True: ["The noise is that of the machine, the slow-down is exact."],
}


def page(same, slow, command, scaled=False):
    first = same[0]
    loads = [report["load"] for reports in [same, *slow.values()] for report in reports]
    quiet, wrong, undecided, all_lines = own_row(same)
    return "\n".join(
        [
            "# What bench-compare finds",
            "",
            f"Made by `{command}`: a commit against itself, and against one whose",
            *SLOW_DOWNS[scaled],
            f"{len(first['benchmarks'])} benchmarks, {first['repetitions']} repetitions of each",
            f"commit in turn; a difference counts when p < {first['alpha']:g} (U test), above {first['relative']:.0%} and "
            f"above {first['absolute_us']:g} us a call.",
            f"{os.cpu_count()} cores; before the runs the machine's load was {min(loads):.1f} to {max(loads):.1f} "
            f"({'others worked on it meanwhile' if max(loads) > 1.5 else 'idle but for the check'}).",
            "",
            f"* A commit against itself: no warning in {quiet} of {len(same)} runs; {undecided} of {all_lines} verdicts "
            f"\"cannot decide\", {len(wrong)} wrong ({', '.join(wrong) or 'none'}).",
            *(f"* {percent:g} % slower: seen in "
              f"{sum(any(line['verdict'] == 'slower' for line in of_detector(report)) for report in reports)} of {len(reports)} runs."
              for percent, reports in slow.items()),
            "",
            "| slower by | runs in which a case of detect/ is called so | cases of detect/ called slower | undecided | same | faster "
            "| called slower without a reason | measured ratios of detect/ |",
            "|--:|--:|--:|--:|--:|--:|---|---|",
            summary_row(0, same),
            *(summary_row(percent, reports) for percent, reports in slow.items()),
            "",
            "Without a reason are benchmarks in which the detector has no part.",
            *NOTES[scaled],
            "",
        ]
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=20, help="for each slow-down (default: %(default)s)")
    parser.add_argument("--same-runs", type=int, default=50, help="of a commit against itself (default: %(default)s)")
    parser.add_argument("--percent", type=float, nargs="+", default=[2, 5, 10, 20], help="slow-downs (default: 2 5 10 20)")
    parser.add_argument("--filter", help="regular expression: which benchmarks; default: that of bench-compare")
    parser.add_argument("--scaled", action="store_true", help="scale the times of the program that is built")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/bench_compare/README.md")
    options = parser.parse_args()
    if options.runs < 1 or options.same_runs < 1 or min(options.percent) <= 0:
        parser.error("--runs, --same-runs and --percent: expected more than 0")
    words = [word for word in sys.argv[1:] if word not in ("-o", "--output", str(options.output))]
    command = shlex.join(["scripts/bench_compare_check.py", *words])
    same, slow = [], {percent: [] for percent in options.percent}
    with tempfile.TemporaryDirectory() as folder:
        clone = (make_scaled if options.scaled else make_clone)(pathlib.Path(folder))
        for run in range(max(options.runs, options.same_runs)):
            if run < options.same_runs:
                same.append(compare(clone, "plain", 0, options.filter))
                print(f"run {run + 1}: against itself {len(names_with(same[-1], 'slower'))} called slower", flush=True)
            for percent, reports in slow.items() if run < options.runs else ():
                reports.append(compare(clone, "slow", percent, options.filter))
                called = sum(line["verdict"] == "slower" for line in of_detector(reports[-1]))
                print(f"run {run + 1}: {percent:g} % slower: {called} of {len(of_detector(reports[-1]))} called so", flush=True)
            options.output.parent.mkdir(parents=True, exist_ok=True)
            options.output.write_text(page(same, slow, command, options.scaled))


if __name__ == "__main__":
    main()
