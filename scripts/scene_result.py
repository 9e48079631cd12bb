"""A result in memory, for scene_invariants.py: each run with its series, summary and attributes."""
import h5py
import numpy as np

HIDDEN = {"DIMENSION_LIST", "REFERENCE_LIST"}


class Run(dict):
    """Data sets by their path in the group of the run, `attrs`, and `summary`."""

    def __init__(self, name, group):
        super().__init__()
        self.name, self.attrs = name, {key: value for key, value in group.attrs.items() if key not in HIDDEN}
        self.summary = dict(group["summary"].attrs) if "summary" in group else {}
        self.other_attrs, self.axes = {}, {}

        def note(path, item):
            if path != "summary":
                self.other_attrs.update({f"{path}@{key}": np.asarray(value) for key, value in item.attrs.items() if key not in HIDDEN})
            if isinstance(item, h5py.Dataset):
                self[path] = item[()]
                self.axes[path] = [next(iter(axis.values())).name.rsplit("/")[-1] if len(axis) else "" for axis in item.dims]

        group.visititems(note)
        self.pipeline, self.status = self.attrs["pipeline"], self.attrs["status"]

    def settings(self, scenario):
        return next(run for run in scenario["pipelines"] if run["name"] == self.name)

    def over_time(self, path):
        """The axis of a data set that is the steps, or None."""
        axes = self.axes[path]
        return axes.index("time") if "time" in axes and "/" not in path else None

    def texts(self, path):
        return [value.decode() if isinstance(value, bytes) else str(value) for value in self[path]]


def read(path):
    with h5py.File(path) as file:
        runs = {name: Run(name, group) for name, group in file["pipelines"].items()}
        resolved = file["provenance/scenario_resolved"][()]
    return runs, resolved.decode() if isinstance(resolved, bytes) else resolved


def same_bits(a, b):
    a, b = np.asarray(a), np.asarray(b)
    return a.dtype == b.dtype and a.shape == b.shape and (a.tolist() == b.tolist() if a.dtype.kind in "OSU" else a.tobytes() == b.tobytes())


def differences(one, two, apart=()):
    """Names of all of two runs that differs in a bit, outside timing/."""
    keep = lambda run: {path: run[path] for path in run if not path.startswith("timing")}
    parts = [("", keep(one), keep(two)), ("summary@", one.summary, two.summary), ("@", one.attrs, two.attrs),
             ("", {k: v for k, v in one.other_attrs.items() if not k.startswith("timing")},
              {k: v for k, v in two.other_attrs.items() if not k.startswith("timing")})]
    found = []
    for prefix, a, b in parts:
        found += [prefix + name for name in sorted(set(a) ^ set(b))]
        found += [prefix + name for name in sorted(set(a) & set(b)) if not same_bits(a[name], b[name])]
    return [name for name in found if name not in apart]
