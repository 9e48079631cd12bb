#!/usr/bin/env python3
"""scripts/bench_compare_check.py: what its page says of given comparisons, and where it puts the slow-down."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import bench_compare_check as check  # noqa: E402


def report(**verdicts):
    """A comparison: names with two underscores for slashes."""
    lines = [{"name": name.replace("__", "/"), "verdict": verdict, "ratio": 1.1 if verdict == "slower" else 1.0}
             for name, verdict in verdicts.items()]
    return {"benchmarks": lines, "repetitions": 11, "alpha": 0.001, "relative": 0.03, "absolute_us": 0.5, "load": 0.5}


QUIET = report(detect__a="same", detect__b="undecided", detect__swept="same", store__x="same")


class Check(unittest.TestCase):
    def page(self, same, slow):
        return check.page(same, slow, "scripts/bench_compare_check.py")

    def test_false_alarms_are_counted(self):
        alarm = report(detect__a="same", detect__b="same", detect__swept="same", store__x="slower")
        text = self.page([QUIET, QUIET, alarm], {10.0: [QUIET]})
        self.assertIn("* A commit against itself: no warning in 2 of 3 runs; 2 of 12 verdicts \"cannot decide\", 1 wrong (store/x).", text)

    def test_what_is_seen_of_each_slow_down(self):
        found = report(detect__a="slower", detect__b="slower", detect__swept="same", store__x="slower")
        half = report(detect__a="slower", detect__b="undecided", detect__swept="same", store__x="same")
        text = self.page([QUIET], {2.0: [QUIET, QUIET], 10.0: [found, half]})
        self.assertIn("* 2 % slower: seen in 0 of 2 runs.", text)
        self.assertIn("* 10 % slower: seen in 2 of 2 runs.", text)
        self.assertIn("| 2 % | 0 of 2 | 0 of 4 | 2 | 2 | 0 | none | 1.000 to 1.000 |", text)
        self.assertIn("| 10 % | 2 of 2 | 3 of 4 | 1 | 0 | 0 | store/x | 1.000 to 1.100 |", text)

    def test_the_page_says_whether_others_worked_on_the_machine(self):
        self.assertIn("idle but for the check", self.page([QUIET], {}))
        self.assertIn("others worked on it meanwhile", self.page([{**QUIET, "load": 4.0}], {}))

    def test_steps_with_the_detector_are_no_false_alarms(self):
        self.assertTrue(check.uses_detector("step/press/fukuhara"))
        self.assertFalse(check.uses_detector("step/press/swept"))
        self.assertFalse(check.uses_detector("detect/128/swept"))

    def test_the_slow_down_is_the_last_thing_that_the_detector_does(self):
        text = check.slow_down((ROOT / check.DETECTOR).read_text())
        body = re.search(r"\nvoid NodeContact::step\(.*?\n}\n", text, re.DOTALL).group(0)
        self.assertIn("FISSURE_SLOWER_PERCENT", body)
        self.assertTrue(body.endswith(check.END + "}\n"))
        self.assertEqual(text.count("FISSURE_SLOWER_PERCENT"), 1)


if __name__ == "__main__":
    unittest.main()
