"""Reads a sweep's table and its CSV as users do: xarray (all engines), pandas, ncdump, and as a cube.

Usage: read_sweep.py SWEEP.h5 SWEEP.csv RUNS TIMES EXAMPLES
The formulas of the values are those of sample_sweep.h.
"""
import subprocess
import sys

import h5py
import numpy as np
import pandas as pd
import xarray as xr

PATH, CSV, RUNS, TIMES = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
sys.path.insert(0, sys.argv[5])
RUN = np.arange(RUNS)
POINT = RUN // 2
NAMES = ["max_penetration_depth_m", "steps", "depth", "force"]
FILES = [f"runs/größe {run}.h5" for run in RUN]
DETAILS = [f'at step {run}, "late"\nor not' if run % 7 == 3 else "" for run in RUN]


def check_table(data):
    depths = np.where(RUN == 1, np.nan, RUN / 1000)
    np.testing.assert_array_equal(data["run"], RUN)
    np.testing.assert_array_equal(data["point"], POINT)
    np.testing.assert_array_equal(data["repeat"], 0 * RUN)
    np.testing.assert_array_equal(data["k"], 100.0 * (POINT % 5 + 1))
    np.testing.assert_array_equal(data["n"], 1 + (POINT // 5) / 10)
    np.testing.assert_array_equal(data["max_penetration_depth_m"], depths)
    np.testing.assert_array_equal(data["steps"], 3.0 * RUN)
    assert list(data["pipeline"]) == [["default", "full"][run % 2] for run in RUN]
    assert list(data["status"]) == ["non_finite" if run % 7 == 3 else "ok" for run in RUN]
    assert list(data["shape"]) == ['[0.1, blade, "a,b"]'] * RUNS
    assert list(data["file"]) == FILES


def check_xarray(engine):
    with xr.open_dataset(PATH, **engine) as data:
        check_table({name: column.values for name, column in data.variables.items()})
        assert list(data.status_detail.values) == DETAILS
        assert set(data.coords) >= {"run", "point", "pipeline", "repeat", "k", "n", "shape"}, data.coords
        assert data.k.attrs["path"] == "force.hc.k" and data.point.dtype == np.int64
        assert data.max_penetration_depth_m.attrs["units"] == "m" and data.steps.attrs["units"] == "1"
        assert data.attrs["format"] == "fissure-sweep" and data.attrs["design"] == "grid"
        assert data.attrs["complete"] == 1 and data.attrs["title"] == "sample"
        for name, column in data.variables.items():
            assert "units" in column.attrs and "long_name" in column.attrs, name
            assert not any(dim.startswith("phony") for dim in column.dims), name
        if TIMES == 0:
            assert "curve_time" not in data.variables and "force" not in data.variables
            return
        time = np.arange(TIMES)
        depth = RUN[:, None] + time / 128
        depth[2::3, (TIMES + 1) // 2:] = np.nan
        assert data.depth.dims == ("run", "curve_time") and data.force.dims == ("run", "law", "curve_time")
        np.testing.assert_array_equal(data.curve_time, time / 64)
        np.testing.assert_array_equal(data.depth, depth)
        law = np.array([0, 1000])
        np.testing.assert_array_equal(data.force, RUN[:, None, None] + law[:, None] + time / 128)
        assert list(data.law.values) == ["hc", "linear"] and data.force.attrs["units"] == "N"
    with xr.open_dataset(PATH, group="timing", **engine) as timing:
        np.testing.assert_array_equal(timing.step_time_us, RUN / 8)
        assert timing.step_time_us.attrs["units"] == "us" and timing.step_time_us.dims == ("run",)


def check_cube(engine):
    import sweep_cube
    cube = sweep_cube.sweep_cube(PATH, **engine)
    values = cube.max_penetration_depth_m
    if RUNS < 20:
        return
    assert {"k", "n", "pipeline"} >= set(values.dims) >= {"k", "pipeline"}, values.dims
    one = values.sel(k=300, pipeline="full")
    assert (one.sel(n=1.1) if "n" in one.dims else one).item() == (15 / 1000 if "n" in one.dims else 5 / 1000)
    table = xr.load_dataset(PATH, **engine)
    good = table.sel(run=table.status == "ok").max_penetration_depth_m.groupby("pipeline").max()
    assert good.sel(pipeline="default") == (RUN[(RUN % 7 != 3) & (RUN % 2 == 0)].max() / 1000)
    by_hand = table.drop_vars(["point", "repeat"]).set_index(run=["k", "n", "pipeline"]).unstack("run")
    assert by_hand.max_penetration_depth_m.sizes["pipeline"] == 2


def main():
    for engine in ({}, {"engine": "netcdf4"}, {"engine": "h5netcdf"}):
        check_xarray(engine)
        check_cube(engine)
    table = pd.read_csv(CSV, keep_default_na=False, na_values={name: [""] for name in NAMES})
    check_table(table)
    assert list(table["status_detail"]) == DETAILS
    assert list(table.columns) == ["run", "point", "pipeline", "repeat", "k", "n", "shape", "status",
                                   "status_detail", "file", "max_penetration_depth_m", "steps"]
    with h5py.File(PATH) as file:
        assert file["provenance/sweep_source"][()].decode() == "# größer\nformat: 1\n"
        assert list(file.attrs)[-1] == "complete"
        assert file["pipeline"].asstr()[0] == "default"
    for command in (["ncdump", PATH], ["h5dump", "-H", PATH]):
        done = subprocess.run(command, capture_output=True, check=False)
        assert done.returncode == 0 and done.stderr == b"", (command, done.stderr[:500])


main()
