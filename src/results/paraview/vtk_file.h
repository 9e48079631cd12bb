#pragma once

#include <string>
#include <vector>

#include "hdf5/h5.h"
#include "paraview/moving_mesh.h"

namespace fissure {

/// Writes a mesh at all its times into an empty HDF5 file. The group VTKHDF has version 2.0 of that format
/// (PolyData with Steps, one part, topology once), which ParaView reads from 5.12 on. The groups
/// snapshots/000000 and so on have a virtual dataset of each moving array at each time, for readers of XDMF,
/// which cannot read a part of a dataset. Positions are f64, other real arrays f32. Throws RunError when
/// writing fails, and what the mesh throws.
void writeVtkFile(hid_t file, const MovingMesh& mesh, const std::vector<double>& times_s);

/// The group of one snapshot in such a file: "snapshots/000012".
std::string snapshotGroup(std::size_t snapshot);

/// Absolute names of datasets in such a file.
inline constexpr const char* vtk_triangles = "/VTKHDF/Polygons/Connectivity";
inline constexpr const char* vtk_vertices = "/VTKHDF/Vertices/Connectivity";
inline constexpr const char* vtk_point_data = "/VTKHDF/PointData/";

}  // namespace fissure
