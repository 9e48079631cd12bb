#!/usr/bin/env python3
"""Opens a sweep's table as a cube, one dimension an axis, and says where each pipeline is deepest.

    /usr/bin/python3 scripts/examples/sweep_cube.py sweep.h5 [QUANTITY]

Needs python3-xarray, python3-pandas and python3-netcdf4 or python3-h5netcdf. A cube fits grids; sampled designs
(random, Latin hypercube, Sobol) stay a table: `xarray.load_dataset("sweep.h5")`.
"""
import sys

import xarray as xr


def sweep_cube(path, **engine):
    """The runs of a grid over their axes, pipeline and, where there are several, repeat."""
    runs = xr.load_dataset(path, **engine)
    axes = [name for name, column in runs.coords.items() if "path" in column.attrs]
    keys = axes + ["pipeline"] + (["repeat"] if len(set(runs.repeat.values)) > 1 else [])
    keys = [key for key in keys if len(set(runs[key].values)) > 1]
    if len(keys) < 2:
        return runs.swap_dims(run=keys[0]) if keys else runs
    counts = [name for name in ("point", "repeat") if name not in keys]
    return runs.drop_vars(counts).set_index(run=keys).unstack("run")


def main():
    path = sys.argv[1]
    quantity = sys.argv[2] if len(sys.argv) > 2 else "max_penetration_depth_m"
    cube = sweep_cube(path)
    if not (cube.status == "ok").any():
        print(f"{path}: no run has ended well")
        return
    if quantity not in cube:
        print(f"{path} has no {quantity}")
        return
    values = cube[quantity]
    print(f"{quantity} in {values.attrs['units']} over", ", ".join(f"{k}: {n}" for k, n in values.sizes.items()))
    for pipeline in values.coords["pipeline"].values.flat if "pipeline" in values.dims else [None]:
        mine = values if pipeline is None else values.sel(pipeline=pipeline)
        if mine.isnull().all():
            print(f"{pipeline or 'all runs'}: no value")
            continue
        where = mine.isel(mine.argmax(dim=mine.dims)) if mine.dims else mine
        at = ", ".join(f"{name} = {where[name].item()}" for name in mine.dims) or "the only point"
        print(f"{pipeline or 'all runs'}: {where.item():.6g} at {at}")


if __name__ == "__main__":
    main()
