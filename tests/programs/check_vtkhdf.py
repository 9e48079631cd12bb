"""Checks files against version 2.0 of the VTKHDF format, PolyData with steps, and against a result.

Usage: check_vtkhdf.py RESULT PIPELINE EXPORT_FOLDER
What a step shows is put together here by the format's own rules (counts of parts, offsets of steps), as a reader
does; https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html
"""
import sys

import h5py
import numpy as np

CELLS = ("Vertices", "Lines", "Polygons", "Strips")


def check_head(root):
    kind = root.attrs.get_id("Type")
    text = kind.get_type()
    assert isinstance(text, h5py.h5t.TypeStringID) and not text.is_variable_str(), "Type is no fixed string"
    assert text.get_cset() == h5py.h5t.CSET_ASCII and text.get_size() == len("PolyData"), text.get_size()
    assert kind.get_space().get_simple_extent_type() == h5py.h5s.SCALAR
    assert root.attrs["Type"] == b"PolyData"
    version = root.attrs["Version"]
    assert version.shape == (2,) and version.dtype.kind == "i" and list(version) == [2, 0]


def check_whole_numbers(group, names):
    for name in names:
        assert group[name].dtype.kind == "i", name


def check_lengths(root, steps):
    """Every offset of every step lies within its dataset."""
    count = int(steps.attrs["NSteps"])
    check_whole_numbers(steps, ("NumberOfParts", "PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"))
    assert steps["Values"].shape == (count,) and steps["Values"].dtype.kind == "f"
    assert np.all(np.diff(steps["Values"][:]) > 0), "times do not increase"
    for name in ("NumberOfParts", "PartOffsets", "PointOffsets"):
        assert steps[name].shape == (count,), name
    for name in ("CellOffsets", "ConnectivityIdOffsets"):
        assert steps[name].shape == (count, 4), name
    assert np.all(steps["NumberOfParts"][:] == 1)
    assert root["Points"].ndim == 2 and root["Points"].shape[1] == 3 and root["Points"].dtype == np.float64
    assert set(steps["PointDataOffsets"]) == set(root["PointData"])
    for name in CELLS:
        group = root[name]
        check_whole_numbers(group, ("NumberOfCells", "NumberOfConnectivityIds", "Connectivity", "Offsets"))
        parts = len(root["NumberOfPoints"])
        assert group["NumberOfCells"].shape == group["NumberOfConnectivityIds"].shape == (parts,), name
        assert len(group["Offsets"]) == group["NumberOfCells"][:].sum() + parts, name
        assert len(group["Connectivity"]) == group["NumberOfConnectivityIds"][:].sum(), name


def cut(dataset, first, count):
    assert 0 <= first and first + count <= len(dataset), (dataset.name, first, count, len(dataset))
    return dataset[first:first + count]


def read_step(root, step):
    """Points, the four kinds of cells and the arrays of one step."""
    steps = root["Steps"]
    part = int(steps["PartOffsets"][step])
    points = int(root["NumberOfPoints"][part])
    shown = {"Points": cut(root["Points"], int(steps["PointOffsets"][step]), points)}
    for kind, name in enumerate(CELLS):
        group = root[name]
        cells = int(group["NumberOfCells"][part])
        offsets = cut(group["Offsets"], int(steps["CellOffsets"][step, kind]) + part, cells + 1)
        ids = cut(group["Connectivity"], int(steps["ConnectivityIdOffsets"][step, kind]),
                  int(group["NumberOfConnectivityIds"][part]))
        assert offsets[0] == 0 and offsets[-1] == len(ids), name
        assert np.all((ids >= 0) & (ids < points)), name
        shown[name] = [ids[a:b] for a, b in zip(offsets[:-1], offsets[1:])]
    for name, values in root["PointData"].items():
        shown[name] = cut(values, int(steps["PointDataOffsets"][name][step]), points)
    return shown


def same(shown, held, tolerance=0.0):
    shown, held = np.asarray(shown, dtype=float), np.asarray(held, dtype=float)
    assert shown.shape == held.shape, (shown.shape, held.shape)
    assert np.all(np.isfinite(shown)) and np.max(np.abs(shown - held), initial=0) <= tolerance


def check_views(file, step, shown, moving):
    group = file[f"snapshots/{step:06d}"]
    assert set(group) == moving, set(group)
    for name in moving:
        assert group[name].is_virtual, name
        same(group[name][()], shown[name])


def check_mesh(path, run, moving, check):
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        check_head(root)
        check_lengths(root, root["Steps"])
        same(root["Steps/Values"], run["snapshot_time"])
        for step in range(len(run["snapshot_time"])):
            shown = read_step(root, step)
            check(step, shown)
            check_views(file, step, shown, moving)


def main():
    result, pipeline, folder = sys.argv[1:4]
    with h5py.File(result) as file:
        run = file[f"pipelines/{pipeline}"]

        def tissue(step, shown):
            same(shown["Points"], run["positions"][step])
            same(shown["Polygons"], run["faces"])
            assert not shown["Vertices"] and not shown["Lines"] and not shown["Strips"]
            same(shown["vertex_contact"], run["vertex_contact"][step])
            same(shown["displacement"], run["positions"][step] - run["positions"][0], 1e-8)
            assert shown["displacement"].dtype == np.float32 and shown["vertex_contact"].dtype == np.uint8

        def tools(_, shown):
            assert len(shown["Polygons"]) == sum(len(tool["faces"]) for tool in run["tools"].values())
            assert not shown["Vertices"] and shown["tool"].max() == len(run["tool"]) - 1

        def nodes(step, shown):
            same(shown["node_state"], run["node_state"][step])
            same(shown["Vertices"], np.arange(len(run["node"]))[:, None])
            assert not shown["Polygons"]

        check_mesh(f"{folder}/{pipeline}.tissue.vtkhdf", run, {"Points", "displacement", "vertex_contact"}, tissue)
        check_mesh(f"{folder}/{pipeline}.tools.vtkhdf", run, {"Points"}, tools)
        if "node_state" in run:
            check_mesh(f"{folder}/{pipeline}.nodes.vtkhdf", run, {"Points", "node_state"}, nodes)


main()
