#!/usr/bin/env python3
"""What each rule about the nodes of a tool of triangles does, on configs/convex_spatula.yaml: writes results/nodes/README.md.

    /usr/bin/python3 scripts/node_table.py [--program PROGRAM]
"""
import argparse
import json
import pathlib
import tempfile

from references import ROOT, fissure

LONE = "tools.spatula.nodes.lone_nodes=true"
SHORT = "pipelines.fukuhara.ray_length_m=0.005"
ROWS = [
    ("as it is", []),
    ("no nodes on the rim, where those of a side end", ["tools.spatula.nodes.rim_nodes=false"]),
    ("nodes also where the pairing ray runs along the tool, beyond `pairing_limit`", [LONE]),
    ("the same, with the other reading of the paper's limit", [LONE, SHORT]),
    ("that other limit alone", [SHORT]),
    ("tissue of 128 triangles, with edges as long as the spatula is wide", ["bodies.sphere.shape.subdivisions=2"]),
]
HEAD = """# Nodes of a tool of triangles

    /usr/bin/python3 scripts/node_table.py

Each row is `fissure run configs/convex_spatula.yaml --pipeline fukuhara` with these `--set`: a convex spatula, bevelled to an edge of a
hundredth of its thickness, pressed 25 mm deep at 0.1 m/s.

| | `--set` | worst depth [mm] | samples passed through | triangles inside out | steps not proved |
|---|---|--:|--:|--:|--:|
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/fissure")
    arguments = parser.parse_args()
    table = HEAD
    with tempfile.TemporaryDirectory() as folder:
        for number, (what, overrides) in enumerate(ROWS):
            words = [word for override in overrides for word in ("--set", override)]
            finished = fissure(arguments, "run", ROOT / "configs/convex_spatula.yaml", "-o", pathlib.Path(folder) / f"{number}.h5",
                               "--pipeline", "fukuhara", "--no-frames", "--no-expect", "--json", *words)
            summary = json.loads(finished.stdout)["results"][0]["pipelines"][0]["summary"]
            table += (f"| {what} | {', '.join(f'`{o}`' for o in overrides)} | {1000 * summary['max_penetration_depth_m']:.2f} "
                      f"| {summary['passed_through_samples']} | {summary['max_inverted_triangles']} | {summary['uncertified_steps']} |\n")
    target = ROOT / "results/nodes/README.md"
    target.parent.mkdir(exist_ok=True)
    target.write_text(table)
    print(f"written: {target.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
