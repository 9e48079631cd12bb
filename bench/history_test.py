#!/usr/bin/env python3
"""scripts/bench_history.py: what its files hold, how they are called, and what they do not say."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import bench_history  # noqa: E402


def entry(name, repetition, time, unit="us", **counters):
    return {"name": name, "run_name": name + "/iterations:5/manual_time", "run_type": "iteration", "family_index": 0,
            "per_family_instance_index": 0, "repetition_index": repetition, "repetitions": 2, "threads": 1,
            "iterations": 5, "real_time": time, "cpu_time": 0.5, "time_unit": unit, **counters}


class History(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.repository = self.folder / "repository"
        self.repository.mkdir()
        (self.repository / "file").write_text("1")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "one")
        (self.folder / "CMakeCache.txt").write_text(
            "//Words\nCMAKE_BUILD_TYPE:STRING=Release\nCMAKE_CXX_COMPILER:FILEPATH=/usr/bin/c++\n"
            "CMAKE_CXX_FLAGS:STRING=-Wall\nCMAKE_CXX_FLAGS_RELEASE:STRING=-O3 -DNDEBUG\n")

    def git(self, *words):
        environment = {**os.environ, "GIT_COMMITTER_DATE": "2026-01-31T13:00:00 +0100"}
        subprocess.run(["git", "-c", "user.name=t", "-c", "user.email=t@t", "-C", self.repository, *words], check=True,
                       env=environment)

    def history(self, *entries):
        return bench_history.history_of(list(entries), self.repository, self.folder)

    def test_the_layout_of_the_book(self):
        median = {**entry("step/a", 0, 3.0), "run_type": "aggregate", "aggregate_name": "median"}
        found = self.history(entry("step/a", 0, 2.0, rays=64, rays_us=1.5), entry("step/a", 1, 0.004, "ms", rays=64), median)
        self.assertEqual(list(found), ["format", "format_version", "commit", "commit_date", "modified", "machine", "build",
                                       "benchmarks"])
        self.assertEqual((found["format"], found["format_version"]), ("fissure-bench", 1))
        self.assertRegex(found["commit"], "^[0-9a-f]{40}$")
        self.assertEqual(found["commit_date"], "2026-01-31T12:00:00Z")
        self.assertEqual(list(found["machine"]), ["cpu", "cores"])
        self.assertEqual(found["build"]["flags"], "-Wall -O3 -DNDEBUG")
        self.assertEqual(found["build"]["type"], "Release")
        self.assertTrue(found["build"]["compiler"])
        self.assertEqual(found["benchmarks"], [{"name": "step/a", "time_us": [2.0, 4.0], "counters": {"rays": 64}}])

    def test_it_names_no_host(self):
        text = json.dumps(self.history(entry("step/a", 0, 2.0)))
        self.assertNotIn("host", text)
        self.assertNotIn(str(self.folder), text)

    def test_one_file_a_commit_and_machine(self):
        history = self.history(entry("step/a", 0, 2.0))
        file = bench_history.write(history, self.folder / "out")
        again = bench_history.write(self.history(entry("step/a", 0, 3.0)), self.folder / "out")
        self.assertEqual(file, again)
        self.assertEqual(json.loads(file.read_text())["benchmarks"][0]["time_us"], [3.0])
        self.assertTrue(file.name.startswith(history["commit"][:12]))
        (self.repository / "file").write_text("2")
        changed = self.history(entry("step/a", 0, 2.0))
        self.assertTrue(changed["modified"])
        bench_history.write(changed, self.folder / "out")
        bench_history.write({**history, "machine": {**history["machine"], "cores": 999}}, self.folder / "out")
        self.assertEqual(len(list((self.folder / "out").iterdir())), 3)

    def test_a_number_that_is_not_finite_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "step/a: nan, expected finite numbers"):
            self.history(entry("step/a", 0, 2.0, rays=float("nan")))


if __name__ == "__main__":
    unittest.main()
