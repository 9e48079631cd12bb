#!/usr/bin/env python3
"""scripts/bench-compare on a throw-away repository whose fissure-bench is a script that prints given times."""
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent / "scripts/bench-compare"

# The program of a commit. It notes that it ran, and its times wander by 2 % from run to run.
PROGRAM = """#!/usr/bin/python3 -BSE
import json, os, random, re, sys
TIMES_US, COUNTERS, ERROR = {times}, {counters}, {error!r}
options = dict(word.lstrip("-").split("=", 1) for word in sys.argv[1:] if "=" in word)
names = [name for name in TIMES_US if re.search(options["benchmark_filter"], name)]
if "--benchmark_list_tests" in sys.argv:
    print("\\n".join(names))
    sys.exit(0 if names else 2)
if ERROR:
    sys.exit(ERROR)
with open(os.environ["RUNS"], "a+") as runs:
    runs.seek(0)
    before = runs.read().split()
    noise = random.Random(before.count({tag!r}))
    machine = (1, 2, 3, 1.5)[len(before) // 4 % 4] if "DRIFT" in os.environ else 1
    print({tag!r}, file=runs)
entries = []
for name in names:
    time_us = machine * TIMES_US[name] * noise.uniform(0.99, 1.01) * (noise.uniform(1, 9) if "noisy" in name else 1)
    entries.append({{"name": name, "run_name": name, "run_type": "iteration", "real_time": time_us,
                    "cpu_time": time_us, "time_unit": "us", "iterations": 1, "a_us": time_us, **COUNTERS}})
print(json.dumps({{"context": {{}}, "benchmarks": entries}}))
"""
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(fake NONE)
add_custom_target(fissure-bench COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/program bench/fissure-bench)
"""


def load_script():
    loader = importlib.machinery.SourceFileLoader("bench_compare", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("bench_compare", loader))
    loader.exec_module(module)
    return module


class Interval(unittest.TestCase):
    """Of the shift between two samples; U as in the table of Mann and Whitney (1947)."""

    def test_the_distribution_of_u(self):
        ways = load_script().ways_of_u
        self.assertEqual(ways(2, 2), [1, 1, 2, 1, 1])
        self.assertEqual(sum(ways(5, 5)), 252)
        self.assertEqual(ways(5, 5)[:3], [1, 1, 2])  # P(U <= 2) = 4 / 252 = 0.016 < 0.025, with 3 it is 0.028

    def test_it_leaves_out_as_many_ratios_as_the_test_does(self):
        interval = load_script().interval
        pairs = [(1.0, 1.0 + 0.01 * i) for i in range(5)]  # 25 ratios, five of each; u up to 2 is left out
        self.assertEqual(interval(pairs, 0.05), (1.0, 1.04))
        ratios = sorted(head / base for base in (1, 2, 3, 4, 5) for head in (1, 2, 3, 4, 5))
        self.assertEqual(interval([(i, i) for i in (1, 2, 3, 4, 5)], 0.05), (ratios[2], ratios[22]))
        self.assertEqual(interval([(1.0, 2.0), (1.0, 4.0)], 0.001), (2.0, 4.0), "too few: the widest")

    def test_it_holds_the_ratio_in_95_of_100(self):
        interval, noise = load_script().interval, random.Random(1)
        held = 0
        for _ in range(400):
            pairs = [(100 * noise.uniform(0.9, 1.1), 105 * noise.uniform(0.9, 1.1)) for _ in range(8)]
            low, high = interval(pairs, 0.05)
            held += low <= 1.05 <= high
        self.assertGreater(held, 370)
        self.assertLess(held, 399)


class BenchCompare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.repository = pathlib.Path(folder.name) / "repository"
        cls.git("init", "-q", cls.repository)
        base = {"detect/a": 100.0, "detect/fast": 2.0, "detect/noisy": 100.0}
        base |= {f"step/{other}": 50.0 for other in "bcdefg"}
        cls.commit("base", base, {"rays": 64})
        cls.commit("slower", {**base, "detect/a": 110.0}, {"rays": 65})
        cls.commit("faster", {**base, "detect/a": 90.0}, {"rays": 64})
        cls.commit("a_little_slower", {**base, "detect/a": 104.0}, {"rays": 64})
        cls.commit("fast_one_slower", {**base, "detect/fast": 2.4}, {"rays": 64})
        cls.commit("noisy_one_slower", {**base, "detect/noisy": 115.0}, {"rays": 64})
        cls.commit("another", {"detect/a": 100.0, "store/b": 1.0}, {"rays": 64})
        cls.commit("nothing_in_common", {"store/b": 1.0}, {})
        cls.commit("fails", base, {}, error="no such scenario")
        cls.commit("unbuildable", base, {}, cmake=CMAKE + "message(FATAL_ERROR broken)\n")

    @classmethod
    def git(cls, *words, **options):
        subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@t", *words], check=True, **options)

    @classmethod
    def commit(cls, tag, times, counters, error="", cmake=CMAKE):
        named = {name + "/iterations:1/manual_time": time for name, time in times.items()}
        program = cls.repository / "program"
        program.write_text(PROGRAM.format(tag=tag, times=named, counters=counters, error=error))
        program.chmod(0o755)
        (cls.repository / "CMakeLists.txt").write_text(cmake)
        cls.git("add", ".", cwd=cls.repository)
        cls.git("commit", "-q", "-m", tag, cwd=cls.repository)
        cls.git("tag", tag, cwd=cls.repository)

    def compare(self, base, head, *options, drift=False):
        """Exit code, output, and the written comparison."""
        file = self.repository.parent / "report.json"
        file.unlink(missing_ok=True)
        runs = self.repository.parent / "runs"
        runs.unlink(missing_ok=True)
        command = [sys.executable, "-B", SCRIPT, base, head, "--repository", self.repository, "--json", file]
        command += ["--repetitions", "8", *options]
        environment = {**os.environ, "RUNS": str(runs), **({"DRIFT": ""} if drift else {})}
        finished = subprocess.run(command, capture_output=True, text=True, env=environment)
        self.runs = runs.read_text().split() if runs.exists() else []
        report = json.loads(file.read_text()) if file.exists() else None
        return finished.returncode, finished.stdout + finished.stderr, report

    def verdicts(self, base, head, *options, drift=False):
        code, output, report = self.compare(base, head, *options, drift=drift)
        self.assertEqual(code, 0, output)
        return {line["name"]: line["verdict"] for line in report["benchmarks"]}

    def test_a_commit_against_itself_gives_no_warning(self):
        code, output, report = self.compare("base", "base", "--fail-on-warning")
        self.assertEqual(code, 0, output)
        noisy = {line["name"] for line in report["benchmarks"] if line["verdict"] == "undecided"}
        self.assertEqual(noisy, {"detect/noisy"}, "its times differ by a factor of nine")
        self.assertEqual({line["verdict"] for line in report["benchmarks"]}, {"same", "undecided"})
        self.assertIn("cannot decide: 1 of 9 benchmarks", output)
        self.assertIn("no warning", output)

    def test_ten_percent_are_found_and_fail_only_when_asked(self):
        code, output, report = self.compare("base", "slower")
        self.assertEqual(code, 0, output)
        self.assertIn("warning: detect/a is slower: +", output)
        line = next(line for line in report["benchmarks"] if line["name"] == "detect/a")
        self.assertAlmostEqual(line["ratio"], 1.1, delta=0.02)
        self.assertAlmostEqual(line["difference_us"], 10, delta=2)
        self.assertLess(line["p"], 2e-4)
        self.assertEqual(self.compare("base", "slower", "--fail-on-warning")[0], 1)

    def test_counters_that_differ_are_named_and_times_among_them_are_not(self):
        report = self.compare("base", "slower")[2]
        self.assertIn("detect/a rays: 64 -> 65", report["counters"])
        self.assertFalse([line for line in report["counters"] if "_us" in line])
        self.assertEqual(self.compare("base", "faster")[2]["counters"], [])

    def test_faster_is_no_warning(self):
        self.assertEqual(self.verdicts("base", "faster")["detect/a"], "faster")
        self.assertEqual(self.compare("base", "faster", "--fail-on-warning")[0], 0)

    def test_a_difference_below_one_of_the_thresholds_is_none(self):
        self.assertEqual(self.verdicts("base", "a_little_slower", "--relative", "0.1")["detect/a"], "same")
        self.assertEqual(self.verdicts("base", "a_little_slower")["detect/a"], "slower")
        self.assertEqual(self.verdicts("base", "fast_one_slower")["detect/fast"], "same")
        self.assertEqual(self.verdicts("base", "fast_one_slower", "--absolute-us", "0.1")["detect/fast"], "slower")

    def test_a_difference_that_is_not_significant_cannot_be_decided(self):
        code, output, report = self.compare("base", "noisy_one_slower", "--relative", "0.02", "--fail-on-warning")
        self.assertEqual(code, 0, output)
        line = next(line for line in report["benchmarks"] if line["name"] == "detect/noisy")
        self.assertEqual(line["verdict"], "undecided")
        self.assertLess(line["low"], 1)
        self.assertGreater(line["high"], 1.02)
        self.assertRegex(output, "detect/noisy .*cannot decide\n")

    def test_a_difference_about_as_large_as_the_limit_cannot_be_decided(self):
        verdicts = self.verdicts("base", "a_little_slower", "--relative", "0.042")
        self.assertEqual(verdicts["detect/a"], "undecided")

    def test_the_interval_holds_the_difference_and_leaves_out_none(self):
        report = self.compare("base", "slower")[2]
        line = next(line for line in report["benchmarks"] if line["name"] == "detect/a")
        self.assertLess(1, line["low"])
        self.assertLess(line["low"], 1.1)
        self.assertLess(1.1, line["high"])
        self.assertLess(line["high"], 1.14)

    def test_benchmarks_of_one_commit_are_named(self):
        code, output, report = self.compare("base", "another")
        self.assertEqual(code, 0, output)
        self.assertIn("only in base: detect/noisy/iterations:1/manual_time", output)
        self.assertIn("only in head: store/b/iterations:1/manual_time", output)
        self.assertEqual([line["name"] for line in report["benchmarks"]], ["detect/a"])

    def test_the_commits_change_places(self):
        self.compare("base", "faster", "--filter", "^detect/")
        self.assertEqual(self.runs, 4 * ["base", "faster", "faster", "base"])
        self.compare("base", "faster")
        two_families = ["base", "faster", "base", "faster", "faster", "base", "faster", "base"]
        self.assertEqual(self.runs, 4 * two_families, "a process for each family")

    def test_a_machine_that_is_slower_now_and_then_hides_nothing(self):
        self.assertEqual(self.verdicts("base", "slower", drift=True)["detect/a"], "slower")
        verdicts = self.verdicts("base", "base", drift=True)
        self.assertEqual({name for name, verdict in verdicts.items() if verdict != "same"}, {"detect/noisy"})

    def test_a_benchmark_has_no_part_in_its_own_correction(self):
        verdicts = self.verdicts("base", "slower", "--filter", "detect/a", drift=True)
        self.assertEqual(verdicts, {"detect/a": "undecided"})

    def assert_refused(self, line, *arguments):
        code, output, report = self.compare(*arguments)
        self.assertEqual((code, report), (2, None), output)
        self.assertRegex(output, r"^error: [^\n]*\n$")
        self.assertIn(line, output)

    def test_bad_input_is_one_line_and_exit_code_2(self):
        self.assert_refused("no_such: no commit of ", "no_such", "base")
        self.assert_refused("no_such: no commit of ", "base", "no_such")
        self.assert_refused("unbuildable does not build, see ", "base", "unbuildable")
        self.assert_refused("have no benchmark in common that fits", "base", "nothing_in_common")
        self.assert_refused("have no benchmark in common that fits '^x'", "base", "slower", "--filter", "^x")
        self.assert_refused("fissure-bench of fails fails: no such scenario", "base", "fails")
        self.assert_refused("--alpha 2.0: expected a number between 0 and 1", "base", "base", "--alpha", "2")
        self.assert_refused("the U test cannot reach --alpha 0.001", "base", "base", "--repetitions", "5")
        self.assert_refused("--relative and --absolute-us: expected 0 or more", "base", "base", "--relative", "nan")
        self.assert_refused("its folder does not exist", "base", "base", "--json", "no/such/file")
        self.assert_refused("unrecognized arguments: --fliter", "base", "base", "--fliter", "x")


if __name__ == "__main__":
    unittest.main()
