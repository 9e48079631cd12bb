"""Two runs of a result side by side: how far apart they are, where and since when, and both over time.

    /usr/bin/python3 scripts/examples/compare.py out/spatula_press.h5 default_tuned fukuhara -o compare.png

`fissure compare out/spatula_press.h5:default_tuned :fukuhara` does so for every series, with tolerances.
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import xarray as xr


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("result")
    parser.add_argument("runs", nargs=2)
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    a, b = (xr.open_dataset(arguments.result, group=f"pipelines/{name}") for name in arguments.runs)
    shared = [name for name in a.data_vars if name in b and a[name].dims == ("time",) and a[name].dtype.kind == "f"]
    for name in shared:
        apart = abs(a[name] - b[name])
        if not bool(apart.notnull().any()):
            continue
        when = float(apart.time[int(apart.argmax("time"))])
        print(f"{name}: up to {float(apart.max()):.6g} {a[name].attrs['units']} apart, most at {when:.6g} s")
    moved = ((a.positions - b.positions) ** 2).sum("xyz") ** 0.5 if "positions" in a and "positions" in b else None
    if moved is not None:
        print(f"tissue vertices: up to {1000 * float(moved.max()):.6g} mm apart")
    figure, axes = plt.subplots(1, 2, figsize=(9, 3), constrained_layout=True)
    for name, run in zip(arguments.runs, (a, b)):
        axes[0].plot(run.time, 1000 * run.penetration_depth, label=name)
    axes[0].set_ylabel("penetration depth [mm]")
    axes[0].legend(frameon=False)
    if moved is not None:
        axes[1].plot(moved.snapshot_time, 1000 * moved.max("vertex"), color="black")
        axes[1].set_ylabel("vertices apart, most [mm]")
    for axis in axes:
        axis.set_xlabel("time [s]")
    figure.savefig(arguments.output, dpi=80)


if __name__ == "__main__":
    main()
