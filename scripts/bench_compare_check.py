#!/usr/bin/env python3
"""Shows what scripts/bench-compare finds and what it does not, and writes results/bench_compare/README.md.

    scripts/bench_compare_check.py [--runs 10] [-o results/bench_compare/README.md]

A throw-away clone of this repository's HEAD gets a commit that makes the detector 10 % slower: NodeContact::step waits,
after its work, for a tenth of the time that the work took. bench-compare then runs ten times for HEAD against itself,
where any warning is a false one, and ten times for HEAD against that commit, where every detect/ case that the
thresholds let through should be called slower; the two kinds of runs take turns. Takes about 40 minutes.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DETECTOR = "src/simulation/contact/node_contact.cpp"
SLOW_PART = """  // Ten percent more, for scripts/bench_compare_check.py.
  const auto end = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - end < (end - start) / 10) {
  }
}
"""


def git(clone, *words):
    finished = subprocess.run(["git", "-C", clone, *words], check=True, capture_output=True, text=True)
    return finished.stdout.strip()


def slow_down(text):
    """The detector's source with 10 % put on top of NodeContact::step."""
    head = text.index("void NodeContact::step(")
    body = text.index("{\n", head) + 2
    end = text.index("\n}\n", body) + 1
    start = "  const auto start = std::chrono::steady_clock::now();\n"
    return text[:body] + start + text[body:end] + SLOW_PART + text[end + 2 :]


def make_clone(folder):
    """A clone with the branches 'plain' (this HEAD) and 'slow'."""
    clone = folder / "clone"
    subprocess.run(["git", "clone", "-q", ROOT, clone], check=True)
    git(clone, "checkout", "-q", "-b", "plain")
    git(clone, "checkout", "-q", "-b", "slow")
    (clone / DETECTOR).write_text(slow_down((clone / DETECTOR).read_text()))
    git(clone, "-c", "user.name=fissure", "-c", "user.email=fissure@localhost", "commit", "-qam", "10 % slower")
    return clone


def compare(clone, head, file):
    command = [clone / "scripts/bench-compare", "plain", head, "--json", file]
    finished = subprocess.run(command, capture_output=True, text=True)
    if finished.returncode:
        raise SystemExit(finished.stderr)
    return json.loads(file.read_text())


def names_with(report, verdict):
    return [line["name"] for line in report["benchmarks"] if line["verdict"] == verdict]


def table(reports, cases):
    """One line a run: what was called slower or faster, and the ratios and p values of `cases`."""
    lines = ["| run | slower: detect/ | slower: step/ of the method | slower: others | faster | "]
    lines[0] += "ratios of detect/ | largest p of detect/ | smallest p of all |"
    lines += ["|--:|--:|--:|---|---|---|--:|--:|"]
    for number, report in enumerate(reports, 1):
        detect = [line for line in report["benchmarks"] if line["name"] in cases]
        slower = set(names_with(report, "slower"))
        method = {name for name in slower if name.startswith("step/") and name.endswith(("fukuhara", "raycast"))}
        others = sorted(slower - set(cases) - method)
        ratios = sorted(line["ratio"] for line in detect)
        largest, smallest = max(line["p"] for line in detect), min(line["p"] for line in report["benchmarks"])
        cells = [number, f"{len(slower & set(cases))} of {len(cases)}", len(method), ", ".join(others) or "none"]
        cells += [", ".join(names_with(report, "faster")) or "none", f"{ratios[0]:.3f} to {ratios[-1]:.3f}"]
        lines.append("| " + " | ".join(map(str, [*cells, f"{largest:.1e}", f"{smallest:.1e}"])) + " |")
    return lines


def page(same, slow):
    cases = [line["name"] for line in same[0]["benchmarks"] if line["name"].startswith("detect/")]
    quiet = sum(not names_with(report, "slower") for report in same)
    found = sum(any(name in cases for name in names_with(report, "slower")) for report in slow)
    all_cases = sum(set(cases) <= set(names_with(report, "slower")) for report in slow)
    first = same[0]
    return "\n".join(
        [
            "# What bench-compare finds",
            "",
            "Made by `scripts/bench_compare_check.py`: a commit against itself, and against one whose detector",
            "(`NodeContact::step`) takes 10 % longer, on two shared cores. Each run: "
            f"{len(first['benchmarks'])} benchmarks, {first['repetitions']} repetitions of each",
            f"commit in turn; a difference counts when p < {first['alpha']:g} (U test), above {first['relative']:.0%} and "
            f"above {first['absolute_us']:g} us a call.",
            "",
            f"* A commit against itself: no warning in {quiet} of {len(same)} runs.",
            f"* 10 % slower: found in {found} of {len(slow)} runs, in all {len(cases)} cases of detect/ in {all_cases}.",
            "",
            "## A commit against itself",
            "",
            *table(same, cases),
            "",
            "## The detector 10 % slower",
            "",
            *table(slow, cases),
            "",
        ]
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "results/bench_compare/README.md")
    options = parser.parse_args()
    same, slow = [], []
    with tempfile.TemporaryDirectory() as folder:
        clone = make_clone(pathlib.Path(folder))
        for run in range(options.runs):
            same.append(compare(clone, "plain", pathlib.Path(folder) / "report.json"))
            slow.append(compare(clone, "slow", pathlib.Path(folder) / "report.json"))
            called = (len(names_with(reports[-1], "slower")) for reports in (same, slow))
            print("run {}: called slower {} against itself, {} of the slower commit".format(run + 1, *called), flush=True)
            options.output.parent.mkdir(parents=True, exist_ok=True)
            options.output.write_text(page(same, slow))


if __name__ == "__main__":
    main()
