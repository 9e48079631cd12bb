"""Walks whole results and fails on anything without units, axes with names, or a stated meaning.

Usage: walk_result.py RESULT...
"""
import re
import sys

import h5py
import numpy as np

UNITS = {"s", "us", "m", "m2", "m3", "m s-1", "N", "J", "kg m s-1", "degree", "Pa", "1"}
ROW_AXES = {"time", "snapshot_time", "frame_time"}
ENDINGS = ("_m", "_N", "_Pa", "_s", "_us", "_hz", "_J", "_m_s", "_m_s2")  # of summary values, which have no units attribute
WITHOUT_UNIT = [r"(force_roughness|roughness_same_triangles|tool_force_roughness)(_\w+)?", r"(tool_)?reaction_roughness", r"collision_share", r"real_time_factor",
                r"node_spacing_over_edge", r"energy_balance_error"]
COUNTS = [r"steps", r"(contact|unsound|oblique|certified|uncertified|truncated|no_room|freeing)_steps", r"rounds|truncated_vertices",
          r"(max_)?substeps|max_inverted_elements", r"steps_per_measurement", r"first_(unsound|uncertified)_step",
          r"rays", r"ray_triangle_tests", r"tool_samples", r"passed_through_samples", r"contacts_total",
          r"max_contact_count", r"max_inverted_triangles", r"displacement_(pushes|sweeps)", r"fixed_vertices",
          r"saturated_steps(_\w+)?", r"(force_)?non_finite_at_step(_\w+)?",
          r"\w+_replay_(samples|held_samples|gaps|jumps|dropped_rows|repeated_rows|saturated_openings|"
          r"rows_beyond_reason|filtered_rows|fast_steps)"]
TEXTS = [r"final_state_hash", r"not_measured", r"repairs", r"untouched_tools", r"unsound_tissue",
         r"first_uncertified", r"laws_of_whole_probes"]


def is_scale(dataset):
    return bool(h5py.h5ds.is_scale(dataset.id))


class Walk:
    def __init__(self, path):
        self.path = path
        self.complaints = []
        self.datasets = 0
        self.values = 0

    def need(self, good, name, what):
        if not good:
            self.complaints.append(f"{self.path}: {name}: {what}")

    def axes(self, name, dataset):
        """Every axis has one scale, named, of its length, in the same group; a scale is its own axis."""
        if is_scale(dataset):
            self.need(dataset.ndim == 1, name, "a scale of more than one axis")
            return [name.rsplit("/")[-1]]
        found = []
        for axis in range(dataset.ndim):
            scales = list(dataset.dims[axis].values())
            self.need(len(scales) == 1, name, f"axis {axis} has {len(scales)} scales")
            for scale in scales[:1]:
                self.need(scale.parent.name == dataset.parent.name, name, f"the scale of axis {axis} lies elsewhere")
                self.need(len(scale) == dataset.shape[axis], name, f"the scale of axis {axis} has another length")
                found.append(scale.name.rsplit("/")[-1])
        return found

    def flags(self, name, dataset, axes):
        if "channel" in axes:  # a picture
            return
        values, meanings = dataset.attrs.get("flag_values"), dataset.attrs.get("flag_meanings", "").split()
        self.need(values is not None and len(values) == len(meanings) > 1, name, "a flag without values and meanings")
        self.need(values is not None and bool(np.isin(dataset[()], values).all()), name, "a value that is no flag")

    def coordinate(self, name, dataset):
        self.need("_FillValue" not in dataset.attrs, name, "a coordinate with missing values")
        if name.rsplit("/")[-1] in ROW_AXES:
            rows = dataset[()]
            self.need(bool(np.isfinite(rows).all() and (np.diff(rows) > 0).all()), name, "rows do not increase")

    def dataset(self, name, dataset):
        self.datasets += 1
        self.need(dataset.attrs.get("units") in UNITS, name, f"units {dataset.attrs.get('units')!r}")
        self.need(bool(dataset.attrs.get("long_name")), name, "no long_name")
        axes = self.axes(name, dataset)
        if dataset.dtype == np.uint8:
            self.flags(name, dataset, axes)
        if is_scale(dataset):
            self.coordinate(name, dataset)
        elif dataset.dtype.kind == "f":
            self.need(np.isnan(dataset.attrs.get("_FillValue", 0)), name, "no _FillValue for what is missing")
        for attribute in dataset.attrs:
            if re.search(r"_(k|c|lambda)$", attribute):
                self.need(bool(dataset.attrs.get(f"{attribute}_units")), name, f"{attribute} has no unit")

    def summary(self, group):
        for name, value in group.attrs.items():
            self.values += 1
            if isinstance(value, str):
                known = TEXTS
            else:
                known = COUNTS if np.issubdtype(type(value), np.integer) else WITHOUT_UNIT
            good = any(re.fullmatch(pattern, name) for pattern in known)
            if not good and np.issubdtype(type(value), np.floating):
                good = name.endswith(ENDINGS)
            self.need(good, f"{group.name}/{name}", "neither a unit nor a known count, ratio or text")

    def visit(self, name, item):
        if isinstance(item, h5py.Group):
            if name.endswith(("/summary", "/timing")):
                self.summary(item)
        elif name.startswith("provenance/"):
            self.need(item.shape == () and h5py.check_string_dtype(item.dtype), name, "no text")
        else:
            self.dataset(name, item)


def main():
    failed = False
    for path in sys.argv[1:]:
        walk = Walk(path)
        with h5py.File(path) as file:
            file.visititems(walk.visit)
        print(f"{path}: {walk.datasets} datasets, {walk.values} summary values")
        print("\n".join(walk.complaints), end="\n" if walk.complaints else "")
        failed |= bool(walk.complaints) or walk.datasets == 0 or walk.values == 0
    sys.exit(1 if failed else 0)


main()
