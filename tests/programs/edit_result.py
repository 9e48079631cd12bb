"""Damages a result in one way: edit_result.py FILE nan|missing|unit|micrometre|escape"""
import sys

import h5py

with h5py.File(sys.argv[1], "r+") as file:
    run = file["pipelines/fukuhara"]
    match sys.argv[2]:
        case "nan":
            run["penetration_depth"][7] = float("nan")
        case "missing":
            del run["contact_count"]
        case "unit":
            run["penetration_depth"].attrs["units"] = "mm"
        case "micrometre":
            run["positions"][2, 3, 1] += 1e-6
        case "escape":
            file["pipelines"].move("fukuhara", "\x1b]0;owned\x07\x9b2J")
        case damage:
            sys.exit(f"no damage {damage}")
