#include "paraview/xdmf.h"

#include <fmt/core.h>

#include <sstream>

#include "paraview/vtk_file.h"

namespace fissure {

namespace {

std::string dimensions(const PointArray& array, std::size_t points) {
  std::string text = std::to_string(points);
  if (array.components != 1) text.append(" ").append(std::to_string(array.components));
  return text;
}

std::string item(const std::string& shape, const char* number, int bytes, const std::string& where) {
  return fmt::format(
      "<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\" Format=\"HDF\">{}</DataItem>\n", shape,
      number, bytes, where);
}

std::string arrayItem(const PointArray& array, std::size_t points, const std::string& where) {
  const std::string shape = dimensions(array, points);
  if (array.type == ValueType::flag) return item(shape, "UChar", 1, where);
  return array.type == ValueType::count ? item(shape, "Int", 8, where) : item(shape, "Float", 4, where);
}

void writeTopology(std::ostream& out, const MovingMesh& mesh, const std::string& file) {
  if (mesh.corners.empty()) {
    out << "<Topology TopologyType=\"Polyvertex\" NodesPerElement=\"1\" NumberOfElements=\"" << mesh.points
        << "\">\n"
        << item(std::to_string(mesh.points), "Int", 8, file + ":" + vtk_vertices);
  } else {
    const std::string triangles = std::to_string(mesh.corners.size() / 3);
    out << "<Topology TopologyType=\"Triangle\" NumberOfElements=\"" << triangles << "\">\n"
        << item(triangles + " 3", "Int", 8, file + ":" + vtk_triangles);
  }
  out << "</Topology>\n";
}

void writeStep(std::ostream& out, const MovingMesh& mesh, const std::string& file, std::size_t snapshot,
               double time_s) {
  const std::string moving = file + ":/" + snapshotGroup(snapshot) + "/";
  out << "<Grid Name=\"" << mesh.name << "\" GridType=\"Uniform\">\n<Time Value=\"" << time_s << "\"/>\n";
  writeTopology(out, mesh, file);
  out << "<Geometry GeometryType=\"XYZ\">\n"
      << item(dimensions(mesh.positions_m, mesh.points), "Float", 8, moving + mesh.positions_m.name)
      << "</Geometry>\n";
  for (const PointArray& array : mesh.arrays) {
    out << "<Attribute Name=\"" << array.name << "\" AttributeType=\""
        << (array.components == 3 ? "Vector" : "Scalar") << "\" Center=\"Node\">\n"
        << arrayItem(array, mesh.points, (array.moves ? moving : file + ":" + vtk_point_data) + array.name)
        << "</Attribute>\n";
  }
  out << "</Grid>\n";
}

}  // namespace

std::string xdmfText(const MovingMeshes& run, const std::vector<std::string>& files) {
  std::ostringstream out;
  out.precision(17);
  out << "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
  for (std::size_t i = 0; i < run.meshes.size(); ++i) {
    const MovingMesh& mesh = run.meshes[i];
    out << "<Grid Name=\"" << mesh.name << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t snapshot = 0; snapshot < run.times_s.size(); ++snapshot)
      writeStep(out, mesh, files.at(i), snapshot, run.times_s[snapshot]);
    out << "</Grid>\n";
  }
  out << "</Domain>\n</Xdmf>\n";
  return out.str();
}

}  // namespace fissure
