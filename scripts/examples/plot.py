"""Any series of a run over time; vectors by their length, one line for each law, tool or clamp.

    /usr/bin/python3 scripts/examples/plot.py out/spatula_press.h5 fukuhara penetration_depth force -o press.png
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import xarray as xr


def lines(series):
    """(label, values over time) of everything that is drawn of a series."""
    if "xyz" in series.dims:
        series = (series**2).sum("xyz", skipna=False) ** 0.5
    others = [axis for axis in series.dims if axis != "time"]
    if not others:
        return [(series.name, series)]
    flat = series.stack(line=others).transpose("line", "time")
    return [(", ".join(str(part) for part in line.line.item()), line) for line in flat]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("result")
    parser.add_argument("run")
    parser.add_argument("series", nargs="+")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    run = xr.open_dataset(arguments.result, group=f"pipelines/{arguments.run}")
    figure, axes = plt.subplots(len(arguments.series), 1, sharex=True, squeeze=False, constrained_layout=True,
                                figsize=(7, 2.4 * len(arguments.series)))
    for axis, name in zip(axes[:, 0], arguments.series):
        units = run[name].attrs["units"]
        for label, values in lines(run[name].rename(name)):
            axis.plot(run.time, values, label=label, linewidth=1)
        axis.set_ylabel(f"{name} [{units}]")
        axis.legend(frameon=False, fontsize=8)
        axis.grid(alpha=0.3)
    axes[-1, 0].set_xlabel("time [s]")
    figure.savefig(arguments.output, dpi=80)


if __name__ == "__main__":
    main()
