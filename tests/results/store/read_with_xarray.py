"""Reads a result as its users do: xarray (default, h5netcdf and netcdf4 engines), ncdump and h5dump.

Usage: read_with_xarray.py RESULT ROWS SNAPSHOTS FRAMES
The formulas of the values are those of sample_run.h.
"""
import subprocess
import sys

import h5py
import numpy as np
import xarray as xr

DIMENSIONS = {
    "time": ("time",), "penetration_depth": ("time",), "contact_count": ("time",),
    "force": ("law", "time", "xyz"), "force_elastic": ("law", "time"),
    "tool_position": ("time", "tool", "xyz"), "saturated": ("time", "tool"),
    "snapshot_time": ("snapshot_time",), "positions": ("snapshot_time", "vertex", "xyz"),
    "vertex_contact": ("snapshot_time", "vertex"), "node_state": ("snapshot_time", "node"),
    "faces": ("face", "corner"), "first_vertex": ("body",), "first_face": ("body",), "first_node": ("tool",),
    "frame_time": ("frame_time",), "frames": ("frame_time", "image_y", "image_x", "channel"),
    "law": ("law",), "xyz": ("xyz",), "tool": ("tool",), "body": ("body",), "channel": ("channel",),
    "vertex": ("vertex",), "node": ("node",), "face": ("face",), "corner": ("corner",),
    "image_y": ("image_y",), "image_x": ("image_x",),
}
UNITS = {"time": "s", "penetration_depth": "m", "contact_count": "1", "force": "N", "force_elastic": "N",
         "tool_position": "m", "saturated": "1", "snapshot_time": "s", "positions": "m", "frame_time": "s"}
TRACKED = h5py.h5p.CRT_ORDER_TRACKED | h5py.h5p.CRT_ORDER_INDEXED
COORDINATES = {name for name, dims in DIMENSIONS.items() if dims == (name,)}


def same(actual, expected):
    np.testing.assert_allclose(np.asarray(actual), expected, rtol=0, atol=1e-12)


def check_series(data, rows):
    row = np.arange(rows, dtype=float)
    pair = np.arange(2.0)
    axis = np.arange(3.0)
    depth = row / 1000
    depth[1:2] = np.nan
    same(data.time, row / 2)
    same(data.penetration_depth, depth)
    same(data.contact_count, 3 * row)
    same(data.force, 100 * pair[:, None, None] + row[:, None] + axis / 10)
    same(data.force_elastic, 10 * pair[:, None] + row)
    same(data.tool_position, row[:, None, None] + 10 * pair[:, None] + 100 * axis)
    same(data.saturated, (row[:, None] + pair) % 2)
    assert list(data.law.values) == ["hc", "linear"] and list(data.xyz.values) == ["x", "y", "z"]
    assert list(data.tool.values) == ["left", "right"]
    assert data.time.dtype == np.float64, "times are numbers, no timedelta"
    assert data.contact_count.dtype == np.int64, "counts stay whole"
    assert data.saturated.dtype == np.uint8 and data.saturated.attrs["flag_meanings"] == "false true"
    same(data.force.sel(law="linear", xyz="z"), 100 + row + 0.2)
    assert data.force.attrs["hc_model"] == "hunt_crossley" and data.force.attrs["linear_model"] == "linear_elastic"
    assert data.force.attrs["hc_lambda_units"] == "newton second per metre to the power n + 1"
    assert "linear_lambda" not in data.force.attrs
    assert data.force.attrs["hc_deformation"] == "paper" and data.force.attrs["linear_deformation"] == "corotated"
    assert data.force.attrs["hc_per_area"] == "false" and data.force.attrs["linear_per_area"] == "true"
    assert data.force.attrs["hc_k_units"] == "newton per metre to the power n"
    assert data.force.attrs["linear_k_units"] == "newton per cubic metre"


def check_pictures(data, snapshots, frames):
    when = np.arange(snapshots, dtype=float)
    same(data.snapshot_time, when)
    same(data.positions, when[:, None, None] + np.arange(8.0)[:, None] / 10 + np.arange(3.0) / 100)
    same(data.vertex_contact, np.tile(np.arange(8) % 2, (snapshots, 1)))
    same(data.node_state, np.tile(np.arange(4), (snapshots, 1)))
    assert data.node_state.attrs["flag_meanings"] == "free feasible infeasible capped"
    assert list(data.node_state.attrs["flag_values"]) == [0, 1, 2, 3]
    assert data.vertex_contact.attrs["flag_meanings"] == "free contact"
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    same(data.faces, np.concatenate([faces, faces + 4]))
    same(data.first_vertex, [0, 4])
    same(data.first_face, [0, 4])
    same(data.first_node, [0, 2])
    assert list(data.body.values) == ["liver", "kidney"]
    same(data.frame_time, 2.0 * np.arange(frames))
    same(data.frames, pictures(frames))


def pictures(frames):
    frame, y, x, channel = np.ogrid[:frames, :4, :5, :3]
    return 50 * frame + 10 * y + 3 * x + channel


def check_force_inputs(data, rows):
    """A contiguous ragged array: row_size observations a step."""
    assert {key: value.dims for key, value in data.variables.items()} == {
        "time": ("time",), "row_size": ("time",), "law": ("law",), "xyz": ("xyz",), "obs": ("obs",),
        "triangle": ("obs",), "deformation": ("obs", "law"), "deformation_rate": ("obs", "law"),
        "area": ("obs",), "direction": ("obs", "xyz")}
    assert data.row_size.attrs["sample_dimension"] == "obs" and data.row_size.dtype == np.int64
    sizes = np.arange(rows) % 3
    row = np.repeat(np.arange(rows), sizes)
    i = np.concatenate([np.arange(size) for size in sizes]) if rows else np.zeros(0)
    same(data.time, np.arange(rows) / 2)
    same(data.row_size, sizes)
    same(data.obs, np.arange(sizes.sum()))
    same(data.triangle, row + i)
    same(data.deformation, (row + i / 10)[:, None] + np.arange(2) / 100)
    same(data.deformation_rate, -data.deformation)
    same(data.area, 1 + i)
    same(data.direction, np.stack([row, i, -np.ones(len(row))], axis=1))
    assert list(data.law.values) == ["hc", "linear"] and list(data.xyz.values) == ["x", "y", "z"]
    assert [data[name].attrs["units"] for name in ("deformation", "deformation_rate", "area")] == ["m", "m s-1", "m2"]


def check_every_variable(data, where):
    for name, variable in data.variables.items():
        assert "units" in variable.attrs, f"{where}/{name}: no units"
        assert "long_name" in variable.attrs, f"{where}/{name}: no long_name"
        assert "dimensions" not in variable.attrs, f"{where}/{name}: scales not attached"
        assert not any(dim.startswith("phony") for dim in variable.dims), f"{where}/{name}: {variable.dims}"
        assert np.issubdtype(variable.dtype, np.timedelta64) is False, f"{where}/{name}: a timedelta"
    for dim in data.dims:
        assert dim in data.coords, f"{where}: {dim} has no coordinate"


def check_pipeline(path, name, rows, snapshots, frames, **engine):
    where = f"pipelines/{name}"
    with xr.open_dataset(path, group=where, **engine) as data:
        check_every_variable(data, where)
        assert {key: value.dims for key, value in data.variables.items()} == DIMENSIONS
        assert set(data.coords) == COORDINATES
        for variable, units in UNITS.items():
            assert data[variable].attrs["units"] == units, variable
        check_series(data, rows)
        check_pictures(data, snapshots, frames)
        assert list(data.attrs) == ["pipeline", "description", "precision", "status", "status_detail"]
        assert data.attrs["status"] == "ok" and data.attrs["precision"] == "f64"
        assert data.attrs["status_detail"] == ""
    with xr.open_dataset(path, group=f"{where}/timing", **engine) as timing:
        check_every_variable(timing, f"{where}/timing")
        same(timing.step_time_us, 7 * np.arange(rows))
        same(timing.time, np.arange(rows) / 2)
        assert timing.step_time_us.attrs["units"] == "us" and timing.attrs["step_time_p99_us"] == 9.5
    with xr.open_dataset(path, group=f"{where}/force_inputs", **engine) as inputs:
        check_every_variable(inputs, f"{where}/force_inputs")
        check_force_inputs(inputs, rows)
    with xr.open_dataset(path, group=f"{where}/summary", **engine) as summary:
        expected = {"max_penetration_depth_m": 0.25, "steps": 12, "final_state_hash": "abc"}
        assert dict(summary.attrs) == expected
    with xr.open_dataset(path, group=f"{where}/tools/left", **engine) as tool:
        check_every_variable(tool, f"{where}/tools/left")
        assert tool.vertices.dims == ("vertex", "xyz") and tool.nodes.dims == ("node", "xyz")
        same(tool.nodes, [[0, 0, 0.5], [0, 0, -0.5]])
        same(tool.node_partner, [1, -1])
        same(tool.node_thickness, [1, np.nan])
        same(tool.faces, [[0, 1, 2]])
    with xr.open_dataset(path, group=f"{where}/frame_images", **engine) as images:
        check_every_variable(images, f"{where}/frame_images")
        assert [key for key in images.data_vars] == [f"{i:06d}" for i in range(frames)]
        for i in range(frames):
            assert images[f"{i:06d}"].dims == ("image_y", "image_x", "channel")
            same(images[f"{i:06d}"], pictures(frames)[i])


def check_plain(path):
    """What the recipes forbid, seen without netCDF's glasses."""
    with h5py.File(path) as file:
        addresses = set()

        def visit(name, item):
            address = h5py.h5o.get_info(item.id).addr
            assert address not in addresses, f"{name}: a hard-link alias"
            addresses.add(address)
            if isinstance(item, h5py.Dataset):
                assert item.dtype.kind in "fiuO" and item.shape is not None, f"{name}: {item.dtype}"
                assert item.dtype.kind != "O" or h5py.check_string_dtype(item.dtype).encoding == "utf-8", name
                assert item.compression in (None, "gzip"), name
            order = item.id.get_create_plist().get_attr_creation_order()
            assert order == TRACKED, f"{name}: order not tracked"

        file.visititems(visit)
        assert list(file.attrs)[-1] == "complete" and file.attrs["complete"].dtype == np.int32
        assert file.attrs["format"] == "fissure-result" and file.attrs["format_version"] == 1
        assert file["provenance/scenario_source"][()].decode() == "# größer\nname: sample\n"
        assert file["provenance/scenario_resolved"][()].decode() == "name: sample\n"
        assert file["provenance"].attrs["version"] == "0.1.0"
        assert list(file["pipelines"]) == ["paper_method", "default"]
        for image in file["pipelines/default/frame_images"].values():
            if len(image.shape) == 3:
                assert image.is_virtual and bytes(image.attrs["CLASS"]) == b"IMAGE"
        frames = file["pipelines/default/frames"]
        assert frames.chunks == (1, 4, 5, 3) and frames.compression_opts == 1


def check_dump(command):
    done = subprocess.run(command, capture_output=True, check=False)
    assert done.returncode == 0 and done.stderr == b"", (command, done.returncode, done.stderr[:500])
    assert b"phony" not in done.stdout, command


def main():
    path, rows, snapshots, frames = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
    check_plain(path)
    for engine in ({}, {"engine": "h5netcdf"}, {"engine": "netcdf4"}):
        for name in ("paper_method", "default"):
            check_pipeline(path, name, rows, snapshots, frames, **engine)
    check_dump(["ncdump", "-h", path])
    check_dump(["ncdump", path])
    check_dump(["h5dump", "-H", path])
    check_dump(["h5dump", "-A", path])


main()
