"""scripts/soak on one short scenario: quiet where nothing differs, one line where a bit does. Usage: soak_test.py FISSURE"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FISSURE = pathlib.Path(sys.argv.pop(1)).resolve()
SCENARIO = """format: 1
name: press
time: {step_s: 0.001, duration_s: 0.01}
bodies: [{name: sphere, shape: {type: sphere, radius_m: 0.03, subdivisions: 1}, position_m: [0, 0.03, 0], mass_kg: 0.1}]
tools:
  - name: spatula
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    motion: {type: script, start_m: [0, 0.062, 0], segments: [{move_to_m: [0, 0.057, 0], speed_m_s: 0.5}]}
pipelines: [{pipeline: fukuhara}]
force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}]
"""
SWEEP = "format: 1\nname: soak\nbase: press.yaml\naxes: [{path: force.hc.k, values: [100, 300]}]\n"
# A fissure whose third result (one a round) has one bit of one value turned, or another hash of its final state.
WRAPPER = """#!/usr/bin/python3 -B
import pathlib, subprocess, sys
import h5py
code = subprocess.run([{fissure!r}, *sys.argv[1:]]).returncode
if sys.argv[1] == {verb!r}:
    count = pathlib.Path({count!r})
    number = len(count.read_text()) + 1 if count.exists() else 1
    count.write_text(number * "x")
    if number == 3:
        target = sys.argv[sys.argv.index("-o") + 1]
        with h5py.File(target + ({verb!r} == "sweep") * "/sweep.h5", "r+") as file:
            {change}
sys.exit(code)
"""
ONE_BIT = """import numpy
            item = file[{name!r}]
            values = item[()]
            values.view(numpy.uint64).ravel()[{at}] ^= numpy.uint64(1)
            item[...] = values"""


class Soak(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "press.yaml").write_text(SCENARIO)
        (self.folder / "s.yaml").write_text(SWEEP)

    def soak(self, *words, program=FISSURE):
        command = [ROOT / "scripts/soak", *words, "-o", "soak", "--program", program, "--scenario", "press.yaml", "--sweep", "s.yaml"]
        finished = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        return finished.returncode, finished.stdout, finished.stderr

    def wrapper(self, change, verb="run"):
        program = self.folder / "wrapper"
        program.write_text(WRAPPER.format(fissure=str(FISSURE), verb=verb, count=str(self.folder / "count"), change=change))
        program.chmod(0o755)
        return program

    def assert_differs(self, pattern, program):
        code, out, err = self.soak("5", program=program)
        self.assertEqual((code, out), (1, ""), err)
        self.assertRegex(err, "^differs: round 3: " + pattern + r" \(soak/1/\S+, soak/3/\S+\)\n$")
        self.assertTrue((self.folder / "soak/1/press.h5").exists() and (self.folder / "soak/3/press.h5").exists())

    def test_nothing_differs(self):
        code, out, err = self.soak("3")
        self.assertEqual((code, err), (0, ""))
        self.assertRegex(out, "^3 rounds of 1 scenarios and a sweep: the same to the last bit, [0-9]+ values each\n$")
        self.assertFalse((self.folder / "soak").exists())

    def test_one_bit_of_one_value_is_named(self):
        change = ONE_BIT.format(name="pipelines/fukuhara/penetration_depth", at=4)
        self.assert_differs(r"press: pipelines/fukuhara/penetration_depth differs in 1 of \d+ values, first at \[4\]: \S+ and \S+",
                            self.wrapper(change))

    def test_another_hash_is_named(self):
        change = "file['pipelines/fukuhara/summary'].attrs['final_state_hash'] = 'none'"
        self.assert_differs(r"press: pipelines/fukuhara/summary@final_state_hash differs in 1 of 1 values, first: \S+ and \S+",
                            self.wrapper(change))

    def test_a_dataset_that_is_missing_is_named(self):
        self.assert_differs("press: pipelines/fukuhara/penetration_depth is in one of them alone",
                            self.wrapper("del file['pipelines/fukuhara/penetration_depth']"))

    def test_the_sweep_counts_too(self):
        change = ONE_BIT.format(name="max_force_N", at=1)
        self.assert_differs(r"sweep: max_force_N differs in 1 of 2 values, first at \[1\]: \S+ and \S+",
                            self.wrapper(change, "sweep"))

    def test_timing_does_not_count(self):
        change = "file['pipelines/fukuhara/timing'].attrs['x'] = 1"
        code, out, err = self.soak("3", program=self.wrapper(change))
        self.assertEqual((code, err), (0, ""))

    def assert_refused(self, code, words, *arguments, program=FISSURE):
        found, out, err = self.soak(*arguments, program=program)
        self.assertEqual((found, out), (code, ""), err)
        self.assertIn(words, err)
        return err

    def test_bad_input(self):
        self.assert_refused(2, "1 rounds: expected 2 or more", "1")
        self.assert_refused(2, "No such file", "2", program="no_such_program")
        os.makedirs(self.folder / "soak", exist_ok=True)
        (self.folder / "soak/thesis.txt").write_text("mine")
        self.assertRegex(self.assert_refused(2, "soak: holds something", "2"), r"^error: [^\n]*\n$")
        self.assertEqual((self.folder / "soak/thesis.txt").read_text(), "mine")
        (self.folder / "soak/thesis.txt").unlink()
        (self.folder / "press.yaml").write_text("")
        self.assertRegex(self.assert_refused(2, "press.yaml", "2"), r"^error: fissure run press.yaml: [^\n]*\n$")


if __name__ == "__main__":
    unittest.main()
