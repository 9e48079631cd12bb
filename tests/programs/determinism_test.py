"""scripts/determinism.py on one scene: quiet where nothing differs, and it names what does. Usage: determinism_test.py FISSURE"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FISSURE = pathlib.Path(sys.argv.pop(1)).resolve()
# A fissure that turns one bit of one value where the surroundings are those of a change.
WRAPPER = """#!/usr/bin/python3 -B
import os, subprocess, sys
import h5py, numpy
code = subprocess.run([{fissure!r}, *sys.argv[1:]]).returncode
if {when}:
    with h5py.File(sys.argv[sys.argv.index("-o") + 1], "r+") as file:
        item = file["pipelines/swept/kinetic_energy"]
        values = item[()]
        values.view(numpy.uint64).ravel()[7] ^= numpy.uint64(1)
        item[...] = values
sys.exit(code)
"""
SAME = r"^scene +run +engine +hash +{0}\ncoupled +fukuhara +explicit +[0-9a-f]{{12}} +{1}\ncoupled +swept +explicit +[0-9a-f]{{12}} +{2}\n$"


class Determinism(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def determinism(self, *words, program=FISSURE, scene="coupled"):
        command = [ROOT / "scripts/determinism.py", "--check", "--scene", scene, "--program", program, *words]
        finished = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        return finished.returncode, finished.stdout, finished.stderr

    def wrapper(self, when):
        program = self.folder / "wrapper"
        program.write_text(WRAPPER.format(fissure=str(FISSURE), when=when))
        program.chmod(0o755)
        return program

    def test_nothing_differs(self):
        code, out, err = self.determinism("--change", "again", "--json", "out.json")
        self.assertEqual((code, err), (0, ""))
        self.assertRegex(out, SAME.format("again", "same", "same"))
        runs = json.loads((self.folder / "out.json").read_text())["runs"]
        self.assertEqual([run["run"] for run in runs], ["fukuhara", "swept"])
        for run in runs:
            self.assertEqual(run["changes"]["again"], {"hash": run["hash"], "first_difference": None})
        self.assertNotEqual(runs[0]["hash"], runs[1]["hash"])

    def assert_seen(self, change, when):
        code, out, err = self.determinism("--change", change, "--json", "out.json", program=self.wrapper(when))
        self.assertEqual(code, 1, err)
        self.assertRegex(out, SAME.format(change, "same", "DIFFERS"))
        self.assertRegex(err, rf"^differs: coupled, swept, {change}: kinetic_energy differs in 1 of \d+ values, first at \[7\]: \S+ and \S+\n$")
        run = json.loads((self.folder / "out.json").read_text())["runs"][1]
        self.assertNotEqual(run["changes"][change]["hash"], run["hash"])

    def test_one_bit_is_named_with_the_change_that_turned_it(self):
        self.assert_seen("zone", "os.environ.get('TZ') == 'Pacific/Kiritimati'")

    def test_the_surroundings_reach_the_program(self):
        self.assert_seen("heap", "os.environ.get('MALLOC_PERTURB_') == '85'")
        self.assert_seen("folder", "os.getcwd().endswith('elsewhere')")
        self.assert_seen("workers", "sys.argv[sys.argv.index('-j') + 1] == '2'")

    def test_bad_input(self):
        for words, says in ((["--change", "moon"], "error: no change is called moon, expected again, "), (["--program", "none"], "error: ")):
            code, out, err = self.determinism(*words)
            self.assertEqual((code, out), (2, ""))
            self.assertIn(says, err)
            self.assertEqual(err.count("\n"), 1)
        self.assertEqual(self.determinism(scene="mars")[0], 2)


if __name__ == "__main__":
    unittest.main()
