#!/usr/bin/env python3
"""check_counters.py says no when it must: against programs that print what fissure-bench would."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).with_name("check_counters.py")
COUNTED = {"detect/128/8x8": {"rays": 64.0, "contacts": 26.0}, "store/append": {"bytes": 564.5}}


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.reference = self.folder / "counters.json"
        self.reference.write_text(json.dumps(COUNTED))

    def check(self, counted, *options, time_us=1.5, counted_again=None):
        """Exit code and output of the checker for a program that counts like this."""
        program = self.folder / "program"
        printed = [
            json.dumps({"benchmarks": [self.entry(name, counters, time_us) for name, counters in counts.items()]})
            for counts in (counted, counted if counted_again is None else counted_again)
        ]
        program.write_text(f"#!/bin/sh\ncase \"$*\" in *filter*) echo '{printed[1]}';; *) echo '{printed[0]}';; esac\n")
        program.chmod(0o755)
        command = [sys.executable, "-B", CHECKER, program, "--reference", self.reference, *options]
        finished = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return finished.returncode, finished.stdout

    @staticmethod
    def entry(name, counters, time_us):
        google = {"family_index": 3, "iterations": 1, "real_time": time_us, "cpu_time": time_us, "time_unit": "us"}
        return {"name": name + "/iterations:1/manual_time", **google, "rays_us": time_us, **counters}

    def changed(self, **counters):
        return {**COUNTED, "detect/128/8x8": {**COUNTED["detect/128/8x8"], **counters}}

    def assert_fails(self, outcome, line):
        self.assertEqual(outcome[0], 1, outcome[1])
        self.assertIn(line, outcome[1])
        self.assertNotIn("Traceback", outcome[1])

    def test_the_same_counts_pass_whatever_the_times(self):
        for time_us in (0.001, 1e9):
            code, output = self.check(COUNTED, time_us=time_us)
            self.assertEqual((code, output), (0, "3 counters of 2 benchmarks, none grew\n"))

    def test_a_counter_that_grew_fails(self):
        self.assert_fails(self.check(self.changed(rays=65.0)), "detect/128/8x8 rays: from 64.0 to 65.0: it grew")

    def test_the_least_growth_fails(self):
        self.assert_fails(self.check(self.changed(rays=64.00000000000001)), "it grew")

    def test_a_counter_that_shrank_is_reported(self):
        code, output = self.check(self.changed(rays=63.0))
        self.assertEqual(code, 0, output)
        self.assertIn("detect/128/8x8 rays: from 64.0 to 63.0: it shrank", output)

    def test_a_missing_counter_fails_on_either_side(self):
        line = "detect/128/8x8 {}: from {} to {}, expected finite numbers on both sides"
        without = {**COUNTED, "detect/128/8x8": {"rays": 64.0}}
        self.assert_fails(self.check(without), line.format("contacts", "26.0", "missing"))
        self.assert_fails(self.check(self.changed(pushes=1.0)), line.format("pushes", "missing", "1.0"))

    def test_a_missing_benchmark_fails_on_either_side(self):
        self.assert_fails(self.check({"store/append": {"bytes": 564.5}}), "detect/128/8x8: not in this build")
        self.assert_fails(self.check({**COUNTED, "render/1x1": {}}), "render/1x1: not in counters.json")

    def test_what_is_no_finite_number_fails_on_either_side(self):
        for value in (float("nan"), float("inf"), float("-inf")):
            self.assert_fails(self.check(self.changed(rays=value), counted_again={}), f"from 64.0 to {value}")
            self.reference.write_text(json.dumps(self.changed(rays=value)))
            self.assert_fails(self.check(COUNTED), f"from {value} to 64.0")
            self.setUp()
        self.reference.write_text(json.dumps(self.changed(rays="64")))
        self.assert_fails(self.check(COUNTED), "expected finite numbers")

    def test_a_count_that_changes_from_run_to_run_fails(self):
        self.assert_fails(self.check(COUNTED, counted_again=self.changed(rays=63.0)), "expected the same")

    def test_a_benchmark_with_an_error_fails(self):
        broken = self.changed(error_occurred=True, error_message="contact before the first step")
        self.assert_fails(self.check(broken), "detect/128/8x8/iterations:1/manual_time: contact before the first step")

    def test_a_program_that_fails_fails(self):
        command = [sys.executable, "-B", CHECKER, "/bin/false", "--reference", self.reference]
        finished = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assert_fails((finished.returncode, finished.stdout), "/bin/false failed")

    def test_a_reference_that_is_not_there_or_no_json_fails(self):
        self.reference.write_text("{")
        self.assert_fails(self.check(COUNTED), "expected counters as --update writes them")
        self.reference.unlink()
        self.assert_fails(self.check(COUNTED), "expected counters as --update writes them")

    def test_update_makes_these_counts_the_reference(self):
        grown = self.changed(rays=65.0)
        self.assertEqual(self.check(grown, "--update"), (0, ""))
        self.assertEqual(json.loads(self.reference.read_text()), grown)
        self.assertEqual(self.check(grown)[0], 0)
        self.assert_fails(self.check(self.changed(rays=66.0)), "from 65.0 to 66.0")


if __name__ == "__main__":
    unittest.main()
