#!/usr/bin/env python3
"""How far the certificate can be trusted, and what it costs: asks it millions of questions, writes results/certificate/README.md.

    /usr/bin/python3 scripts/certificate_table.py     ten minutes
"""
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
QUERIES = 10_000_000
SEQUENCES = 10_000
TEXT = """# The certificate: answers against exact truth, and cost

    /usr/bin/python3 scripts/certificate_table.py

Continuous collision detection of eight moving points against exact arithmetic, and the certificate on sequences of moving tissue and
tools against an exact overlap test. A missed meeting, or a step proved that ends in overlap, fails the test that asks; there is none
below. On the safe side: answers "may meet" (or steps not proved) where truth says apart.

* Published queries: Wang and others (2021), [sample queries](https://github.com/Continuous-Collision-Detection/Sample-Queries) with
  rational truth. All false meetings are between spikes that nearly touch.
* Random primitives: integral coordinates, so that 128-bit and big integers decide; not decided: those that stay in one plane, and
  grazing ones.
* An adversary's: each has a rational witness: at rest, coplanar, collinear, without area, grazing with a double root, sharing a point,
  touching at either end of the step; scaled from 1e-271 to 1e271, shifted by a billion times their size, carried along as far.
* Sequences: spheres, boxes, needles, blades and open sheets, one or two of each, turned and deformed, {sequences} of 12 steps. Steps
  on the safe side are those that jumped through.

| asked | queries | meet | missed | not decided | on the safe side |
|---|--:|--:|--:|--:|--:|
{rows}

Medians of a whole run, in one process:

| run | certifying a step [us] | the step itself [us] | share |
|---|--:|--:|--:|
{costs}
"""


def truths():
    subprocess.run([ROOT / "scripts/build", "release", "test_surface", "test_measure", "fissure-bench"], stdout=subprocess.DEVNULL, check=True)
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        environment = os.environ | {"FISSURE_CERTIFICATE_TABLE": str(table), "FISSURE_CCD_QUERIES": str(QUERIES),
                                    "FISSURE_CERTIFICATE_SEQUENCES": str(SEQUENCES)}
        for program, tests in (("test_surface", "ContinuousCollision.Misses*"), ("test_measure", "Certifier.NeverProvesAnOverlap")):
            subprocess.run([ROOT / "build/release/tests" / program, f"--gtest_filter={tests}"], env=environment, check=True)
        for line in table.read_text().splitlines():
            asked, queries, meet, undecided, safe = line.split(",")
            yield f"| {asked} | {int(queries):,} | {int(meet):,} | 0 | {int(undecided):,} | {int(safe):,} |"


def costs():
    command = [ROOT / "build/release/bench/fissure-bench", "--benchmark_filter=^certify/", "--benchmark_format=json"]
    found = subprocess.run(command, capture_output=True, check=True).stdout
    for entry in json.loads(found)["benchmarks"]:
        name, certify_us, step_us = entry["name"].split("/iterations")[0], entry["real_time"], entry["step_us"]
        yield f"| {name.removeprefix('certify/')} | {certify_us:.1f} | {step_us:.1f} | {certify_us / step_us:.2f} |"


def main():
    page = ROOT / "results/certificate/README.md"
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(TEXT.format(sequences=f"{SEQUENCES:,}", rows="\n".join(truths()), costs="\n".join(costs())))
    print(f"written: {page.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
