"""What a result holds: its runs, their series with units and axes, and what came out.

    /usr/bin/python3 scripts/examples/load.py out/spatula_press.h5
"""
import sys

import h5py
import xarray as xr


def runs(path):
    """Names of the runs, in the scenario's order; xarray opens one group at a time, so h5py lists them."""
    with h5py.File(path) as file:
        return list(file["pipelines"])


def main(path):
    for name in runs(path):
        run = xr.open_dataset(path, group=f"pipelines/{name}")
        summary = xr.open_dataset(path, group=f"pipelines/{name}/summary").attrs
        print(f"{name}: {run.attrs['description']}, {run.attrs['status']}")
        for key in ("max_penetration_depth_m", "max_force_N", "steps"):
            if key in summary:
                print(f"  {key} = {summary[key]:.6g}")
        for variable in run.data_vars.values():
            axes = " x ".join(f"{axis} {length}" for axis, length in variable.sizes.items())
            print(f"  {variable.name}({axes}) [{variable.attrs['units']}]: {variable.attrs['long_name']}")
        if "force" in run:  # by name: no index has to be known
            peak = run.force.isel(law=0).sel(xyz="y").max("time")
            print(f"  largest upward force of law {str(run.law.values[0])}: {float(peak):.6g} N")


if __name__ == "__main__":
    main(sys.argv[1])
