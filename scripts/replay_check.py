#!/usr/bin/env python3
"""Replays real device logs over the soft sphere and checks every tool pose in the result against the log.

    /usr/bin/python3 scripts/replay_check.py FOLDER

FOLDER holds falcon_session_A.csv (a Novint Falcon session, github.com/prisma-lab/ndt2_arm_control) and palpation_trial5.csv (a da Vinci
arm palpating a phantom, github.com/vu-arma-dev/robot-palpation-data). Neither states a licence, so neither is part of this project. The
expected poses are computed here, from the text of the log, independently of the program. Writes results/replay/check.md.
Fails when a position is off by more than 1e-9 m.
"""
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMIT_M = 1e-9


def rotation_of(axes):
    """Scene axes as rows: which signed device axis each is."""
    rows = []
    for axis in axes:
        row = np.zeros(3)
        row["xyz".index(axis[-1])] = -1 if axis[0] == "-" else 1
        rows.append(row)
    return np.array(rows)


def multiply(a, b):
    """Hamilton product of x, y, z, w quaternions."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    return np.array(
        [
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        ]
    )


def quaternion_of(rotation):
    w = np.sqrt(max(0.0, 1 + np.trace(rotation))) / 2
    x = (rotation[2, 1] - rotation[1, 2]) / (4 * w)
    y = (rotation[0, 2] - rotation[2, 0]) / (4 * w)
    z = (rotation[1, 0] - rotation[0, 1]) / (4 * w)
    return np.array([x, y, z, w])


FALCON = {
    "file": "falcon_session_A.csv",
    "what": "Falcon, 100 Hz, metres, mirrored upside down, scaled by 0.45",
    "columns": ["x_m", "y_m", "z_m"],
    "unit": "m",
    "time": "t_s_nominal100Hz",
    "quaternion": None,
    "axes": ["x", "-y", "-z"],
    "scale": 0.45,
    "origin_device_m": [0, -0.0547, 0.1047],
    "origin_scene_m": [0, 0.071, 0],
    "end_s": 1.5,
}
PALPATION = {
    "file": "palpation_trial5.csv",
    "what": "da Vinci arm, irregular 14 to 120 ms, millimetres, quaternions, scaled by 4",
    "columns": ["x_mm", "y_mm", "z_mm"],
    "unit": "mm",
    "time": "t_s",
    "quaternion": ["q1", "q2", "q3", "q0"],
    "axes": ["x", "z", "-y"],
    "scale": 4,
    "origin_device_m": [-0.0065, -0.0127, -0.1312],
    "origin_scene_m": [0, 0.066, 0],
    "end_s": 10,
}


def read_log(path, case):
    table = np.genfromtxt(path, delimiter=",", names=True)
    unit = 1e-3 if case["unit"] == "mm" else 1.0
    positions = unit * np.column_stack([table[c] for c in case["columns"]])
    times = table[case["time"]] - table[case["time"]][0]
    quaternions = None
    if case["quaternion"]:
        quaternions = np.column_stack([table[c] for c in case["quaternion"]])
        quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    return times, positions, quaternions


def mount_of(case, quaternions):
    """The tool lies flat, as the box is defined, in the log's first pose."""
    if quaternions is None:
        return np.array([0.0, 0, 0, 1])
    x, y, z, w = multiply(quaternion_of(rotation_of(case["axes"])), quaternions[0])
    return np.array([-x, -y, -z, w])


def run(path, case, mount, output):
    motion = {"type": "replay", "file": str(path), "time_column": case["time"], "position_unit": case["unit"]}
    fields = [f"{key}: {value}" for key, value in motion.items()]
    fields.append(f"position_columns: [{', '.join(case['columns'])}]")
    if case["quaternion"]:
        fields.append(f"quaternion_columns: [{', '.join(case['quaternion'])}]")
    mapping = [f"axes: [{', '.join(case['axes'])}]", f"scale: {case['scale']}"]
    for key in ("origin_device_m", "origin_scene_m"):
        mapping.append(f"{key}: {case[key]}")
    mapping.append(f"mount: {[float(q) for q in mount]}")
    fields += ["mapping: {" + ", ".join(mapping) + "}", f"end_s: {case['end_s']}"]
    command = [ROOT / "build/release/fissure", "run", ROOT / "configs/replay_falcon.yaml", "--no-expect", "-o", output, "-j", "2"]
    command += ["--set", "tools.spatula.motion={" + ", ".join(fields) + "}"]
    if subprocess.run(command, check=False).returncode != 0:
        raise SystemExit(f"{case['file']}: the run failed")


def check(folder, case):
    path = (pathlib.Path(folder) / case["file"]).resolve()
    times, positions, quaternions = read_log(path, case)
    mount = mount_of(case, quaternions)
    rotation = rotation_of(case["axes"])
    mapped = np.array(case["origin_scene_m"]) + case["scale"] * (positions - case["origin_device_m"]) @ rotation.T
    rows = []
    with tempfile.TemporaryDirectory() as temporary:
        output = f"{temporary}/replay.h5"
        run(path, case, mount, output)
        with h5py.File(output) as result:
            for name, group in result["pipelines"].items():
                stamps, found = group["time"][:], group["tool_position"][:, 0]
                expected = np.column_stack([np.interp(stamps, times, mapped[:, i]) for i in range(3)])
                error = np.abs(found - expected).max()
                turn = 0.0
                on_sample = np.isclose(stamps[:, None], times[None, times <= case["end_s"]], rtol=0, atol=1e-9)
                if quaternions is not None:
                    for step, sample in zip(*np.nonzero(on_sample)):
                        whole = multiply(multiply(quaternion_of(rotation), quaternions[sample]), mount)
                        turn = max(turn, 1 - abs(whole @ group["tool_quaternion"][step, 0]))
                depth = 1000 * np.nanmax(group["penetration_depth"][:])
                rows.append((case, name, len(stamps), int(on_sample.sum()), error, turn, depth))
    return rows


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    rows = check(sys.argv[1], FALCON) + check(sys.argv[1], PALPATION)
    lines = ["Tool poses in the result against the log through the stated mapping (linear interpolation), at every step.", ""]
    lines += ["| log | pipeline | steps | of these at a sample | worst position error [m] | worst 1 - abs(q . q') | worst depth [mm] |"]
    lines += ["|---|---|---|---|---|---|---|"]
    for case, name, steps, samples, error, turn, depth in rows:
        lines.append(
            f"| {case['file']}: {case['what']} | {name} | {steps} | {samples} | {error:.1e} | {turn:.1e} | {depth:.2f} |"
        )
    lines += ["", "Made by `/usr/bin/python3 scripts/replay_check.py FOLDER`, with the logs in FOLDER."]
    folder = ROOT / "results/replay"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "check.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    if not all(error <= LIMIT_M and turn <= 1e-9 for _, _, _, _, error, turn, _ in rows):  # NaN fails too
        raise SystemExit("a pose differs from its log")


if __name__ == "__main__":
    main()
