"""Opens an export in ParaView and compares what it shows with what the result holds.

Usage: pvpython read_with_paraview.py RESULT PIPELINE EXPORT_FOLDER
"""
import sys

import h5py
import numpy as np
from paraview import servermanager
from paraview.simple import Xdmf3ReaderT, XDMFReader
from vtkmodules.util.numpy_support import vtk_to_numpy


def blocks(data):
    """The meshes by name, or where the reader knows no names (Xdmf3ReaderT) in their order."""
    found = {}
    for i in range(data.GetNumberOfBlocks()):
        name = data.GetMetaData(i).Get(data.NAME()) or ("tissue", "tools", "nodes")[i]
        found[name] = data.GetBlock(i)
    return found


def points(block):
    return vtk_to_numpy(block.GetPoints().GetData())


def cells(block):
    return np.array([[block.GetCell(c).GetPointId(i) for i in range(block.GetCell(c).GetNumberOfPoints())]
                     for c in range(block.GetNumberOfCells())])


def array(block, name):
    return vtk_to_numpy(block.GetPointData().GetArray(name))


def rotated(quaternion, vectors):
    """By matrix, which is another way than the exporter's."""
    x, y, z, w = quaternion
    matrix = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                       [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                       [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    return vectors @ matrix.T


def in_scene(run, what, time):
    """`what` ("vertices" or "nodes") of all tools at that time."""
    row = int(np.argmin(np.abs(run["time"][:] - time)))
    assert run["time"][row] == time, "a snapshot between two steps"
    names = [name.decode() for name in run["tool"][:]]
    return np.concatenate([run["tool_position"][row, i] +
                           rotated(run["tool_quaternion"][row, i], run[f"tools/{name}/{what}"][:])
                           for i, name in enumerate(names)])


def same(shown, held, tolerance=0.0):
    shown, held = np.asarray(shown), np.asarray(held)
    assert shown.shape == held.shape, (shown.shape, held.shape)
    assert np.all(np.isfinite(shown)) and np.max(np.abs(shown - held), initial=0) <= tolerance, (shown, held)


def check_tissue(run, snapshot, block):
    same(points(block), run["positions"][snapshot])
    same(cells(block), run["faces"][:])
    same(array(block, "vertex_contact"), run["vertex_contact"][snapshot])
    same(array(block, "displacement"), run["positions"][snapshot] - run["positions"][0], 1e-8)
    bodies = np.searchsorted(run["first_vertex"][:], np.arange(len(run["vertex"])), side="right") - 1
    same(array(block, "body"), bodies)


def check_tools(run, time, block):
    same(points(block), in_scene(run, "vertices", time), 1e-15)
    names = [name.decode() for name in run["tool"][:]]
    counts = [len(run[f"tools/{name}/vertices"]) for name in names]
    starts = np.cumsum([0] + counts)
    same(cells(block), np.concatenate([starts[i] + run[f"tools/{name}/faces"][:] for i, name in enumerate(names)]))
    same(array(block, "tool"), np.repeat(np.arange(len(names)), counts))


def check_nodes(run, snapshot, time, block):
    same(points(block), in_scene(run, "nodes", time), 1e-15)
    same(cells(block), np.arange(len(run["node"]))[:, None])
    same(array(block, "node_state"), run["node_state"][snapshot])
    same(array(block, "tool"),
         np.searchsorted(run["first_node"][:], np.arange(len(run["node"])), side="right") - 1)


def check(run, reader):
    reader.UpdatePipelineInformation()
    times = run["snapshot_time"][:]
    same(reader.TimestepValues, times)
    for snapshot, time in enumerate(times):
        reader.UpdatePipeline(time)
        shown = blocks(servermanager.Fetch(reader))
        assert set(shown) == {"tissue", "tools"} | ({"nodes"} if "node_state" in run else set()), set(shown)
        check_tissue(run, snapshot, shown["tissue"])
        check_tools(run, time, shown["tools"])
        if "node_state" in run:
            check_nodes(run, snapshot, time, shown["nodes"])
    return len(times)


def main():
    result, pipeline, folder = sys.argv[1:4]
    document = f"{folder}/{pipeline}.xdmf"
    with h5py.File(result) as file:
        run = file[f"pipelines/{pipeline}"]
        count = check(run, XDMFReader(FileNames=[document]))
        check(run, Xdmf3ReaderT(FileName=[document]))
    print(f"{count} times agree")


main()
