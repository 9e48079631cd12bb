#include "volume/tetgen.h"

#include <fmt/core.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.h"
#include "base/reproducible.h"
#include "files/temporary_folder.h"
#include "files/write_file.h"
#include "process/fed_process.h"
#include "process/interrupt.h"
#include "process/system_program.h"
#include "scenario/shapes.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double most_filling_s = 120;

/// TetGen's format .smesh: vertices, facets, and no holes.
void writeSurface(const TriangleMesh& surface, const fs::path& file) {
  std::ostringstream out;
  out.precision(17);
  out << surface.vertices_m.size() << " 3 0 0\n";
  for (std::size_t v = 0; v < surface.vertices_m.size(); ++v) {
    const Vec3& vertex_m = surface.vertices_m[v];
    out << v << ' ' << vertex_m.x() << ' ' << vertex_m.y() << ' ' << vertex_m.z() << '\n';
  }
  out << surface.faces.size() << " 0\n";
  for (const Face& face : surface.faces) out << "3 " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
  out << "0\n0\n";
  writeFile(file, out.str());
}

/// TetGen's switches: a constrained mesh of bounded quality, optimised in all its ways as often as it can.
std::string switchesOf(const FillSettings& settings) {
  std::ostringstream text;
  text << "-pq" << settings.radius_edge_ratio << "/" << settings.least_dihedral_deg << "O9/7";
  // A regular tetrahedron of edge a has the volume a^3 / (6 sqrt(2)). TetGen reads no exponents.
  if (settings.max_edge_m)
    text << "a" << std::fixed << std::setprecision(24)
         << reproducible::pow(*settings.max_edge_m, 3) / (6 * std::sqrt(2.0));
  if (settings.keep_surface) text << "Y";
  return text.str() + "S1000000Q";
}

/// Rows of numbers after a header whose first is their count; each row begins with its own index.
template <class Value>
std::vector<std::vector<Value>> readRows(const fs::path& file, std::size_t columns) {
  std::ifstream in(file);
  std::string line;
  std::size_t count = 0;
  std::getline(in, line);
  std::istringstream(line) >> count;
  std::vector<std::vector<Value>> rows;
  while (rows.size() < count && std::getline(in, line)) {
    std::istringstream numbers(line);
    std::size_t index = 0;
    std::vector<Value> row(columns);
    numbers >> index;
    for (Value& value : row) numbers >> value;
    if (!numbers || index != rows.size()) break;
    rows.push_back(std::move(row));
  }
  if (rows.empty() || rows.size() != count)
    throw RunError("TetGen has left no whole mesh in " + file.parent_path().string() + ", as on a full disk");
  return rows;
}

TetrahedralMesh readMesh(const fs::path& folder) {
  TetrahedralMesh mesh;
  for (const std::vector<double>& row : readRows<double>(folder / "surface.1.node", 3))
    mesh.vertices_m.emplace_back(row[0], row[1], row[2]);
  for (const std::vector<int>& row : readRows<int>(folder / "surface.1.ele", 4)) {
    for (const int v : row)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices_m.size())
        throw RunError("TetGen has left a corner that does not exist");
    mesh.tetrahedra.push_back({row[0], row[1], row[2], row[3]});
  }
  if (static_cast<double>(mesh.tetrahedra.size()) > most_tetrahedra)
    throw InputError(
        fmt::format("TetGen fills it with {} tetrahedra, expected at most 2097152: a larger fill.max_edge_m "
                    "or radius_edge_ratio",
                    mesh.tetrahedra.size()));
  return mesh;
}

/// TetGen does not say why it could not write. Throws RunError when nobody can.
void requireSpace(const fs::path& folder) {
  constexpr std::size_t some_bytes = 1 << 20;
  writeFile(folder / "space", std::string(some_bytes, ' '));
}

void runTetgen(const FillSettings& settings, const fs::path& folder) {
  const std::optional<fs::path> program = programOnPath("tetgen");
  if (!program) throw RunError("filling a surface with tetrahedra needs TetGen (Debian's package tetgen)");
  const InputError refusal(
      "TetGen cannot fill it with tetrahedra, expected a surface that neither crosses nor touches itself");
  const Descriptor requests = heldBackRequests();
  ProgramOutcome outcome;
  try {
    outcome = runProgram(*program, {switchesOf(settings), (folder / "surface.smesh").string()},
                         most_filling_s, requests.number());
  } catch (const KilledProgram& killed) {
    if (killed.signal() == SIGABRT || killed.signal() == SIGSEGV) throw refusal;  // where it gives up
    throw;
  }
  if (!outcome.in_time)
    throw InputError(
        "TetGen does not fill it within 120 s, expected larger fill.radius_edge_ratio and "
        "fill.max_edge_m, or a smaller fill.least_dihedral_deg");
  if (outcome.code == 0 && fs::exists(folder / "surface.1.ele")) return;
  requireSpace(folder);
  throw refusal;
}

}  // namespace

BoundedVolume fillWithTetrahedra(const TriangleMesh& surface, const FillSettings& settings) {
  const RequestsHeldBack held_back;  // until the folder is gone
  const TemporaryFolder folder;
  writeSurface(surface, folder.path() / "surface.smesh");
  runTetgen(settings, folder.path());
  TetrahedralMesh mesh = readMesh(folder.path());
  if (!settings.keep_surface) {
    BoundedVolume volume = boundedBySurface(std::move(mesh));
    volume.notes.clear();  // TetGen's corners run as it likes, which says nothing about the surface
    return volume;
  }
  BoundedVolume volume{.surface = surface, .mesh = boundedBySurface(std::move(mesh)).mesh};
  if (volume.mesh.vertices_m.size() < surface.vertices_m.size())
    throw InputError(
        "TetGen leaves out vertices of the surface, expected each of them to be part of the inside");
  // Their text has 17 digits, and is read as it was written; the surface's own numbers all the same.
  std::copy(surface.vertices_m.begin(), surface.vertices_m.end(), volume.mesh.vertices_m.begin());
  return volume;
}

}  // namespace fissure
