#include "volume/tetgen.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.h"
#include "process/fed_process.h"
#include "process/system_program.h"
#include "scenario/shapes.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr double most_filling_s = 120;

/// A folder of its own for files between two programs, gone with this object.
class ExchangeFolder {
 public:
  ExchangeFolder() {
    std::string name = (fs::temp_directory_path() / "fissure-tetgen-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw RunError("cannot make a folder for TetGen: " + name);
    path_ = name;
  }
  ~ExchangeFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ExchangeFolder(const ExchangeFolder&) = delete;
  ExchangeFolder& operator=(const ExchangeFolder&) = delete;

  fs::path file(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// TetGen's format .smesh: vertices, facets, and no holes.
void writeSurface(const TriangleMesh& surface, const fs::path& file) {
  std::ofstream out(file);
  out.precision(17);
  out << surface.vertices_m.size() << " 3 0 0\n";
  for (std::size_t v = 0; v < surface.vertices_m.size(); ++v) {
    const Vec3& vertex_m = surface.vertices_m[v];
    out << v << ' ' << vertex_m.x() << ' ' << vertex_m.y() << ' ' << vertex_m.z() << '\n';
  }
  out << surface.faces.size() << " 0\n";
  for (const Face& face : surface.faces) out << "3 " << face[0] << ' ' << face[1] << ' ' << face[2] << '\n';
  out << "0\n0\n";
  out.flush();
  if (!out) throw RunError("cannot write for TetGen: " + file.string());
}

/// TetGen's switches: a constrained mesh of bounded quality, optimised in all its ways as often as it can.
std::string switchesOf(const FillSettings& settings) {
  std::ostringstream text;
  text << "-pq" << settings.radius_edge_ratio << "/" << settings.least_dihedral_deg << "O9/7";
  // A regular tetrahedron of edge a has the volume a^3 / (6 sqrt(2)). TetGen reads no exponents.
  if (settings.max_edge_m)
    text << "a" << std::fixed << std::setprecision(24)
         << std::pow(*settings.max_edge_m, 3) / (6 * std::sqrt(2.0));
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
  if (rows.empty() || rows.size() != count) throw RunError("TetGen has left no whole mesh");
  return rows;
}

TetrahedralMesh readMesh(const ExchangeFolder& folder) {
  TetrahedralMesh mesh;
  for (const std::vector<double>& row : readRows<double>(folder.file("surface.1.node"), 3))
    mesh.vertices_m.emplace_back(row[0], row[1], row[2]);
  for (const std::vector<int>& row : readRows<int>(folder.file("surface.1.ele"), 4)) {
    for (const int v : row)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices_m.size())
        throw RunError("TetGen has left a corner that does not exist");
    mesh.tetrahedra.push_back({row[0], row[1], row[2], row[3]});
  }
  if (static_cast<double>(mesh.tetrahedra.size()) > most_tetrahedra)
    throw InputError("TetGen fills it with " + std::to_string(mesh.tetrahedra.size()) +
                     " tetrahedra, expected at most 2097152: a larger fill.max_edge_m or radius_edge_ratio");
  return mesh;
}

void runTetgen(const FillSettings& settings, const ExchangeFolder& folder) {
  const std::optional<fs::path> program = programOnPath("tetgen");
  if (!program) throw RunError("filling a surface with tetrahedra needs TetGen (Debian's package tetgen)");
  const char* const hint = ", expected a surface that neither crosses nor touches itself";
  ProgramOutcome outcome;
  try {
    outcome =
        runProgram(*program, {switchesOf(settings), folder.file("surface.smesh").string()}, most_filling_s);
  } catch (const RunError&) {  // it aborts where it gives up
    throw InputError(std::string("TetGen cannot fill it with tetrahedra") + hint);
  }
  if (!outcome.in_time)
    throw InputError(
        "TetGen does not fill it within 120 s, expected larger fill.radius_edge_ratio and "
        "fill.max_edge_m, or a smaller fill.least_dihedral_deg");
  if (outcome.code != 0 || !fs::exists(folder.file("surface.1.ele")))
    throw InputError(std::string("TetGen cannot fill it with tetrahedra") + hint);
}

}  // namespace

BoundedVolume fillWithTetrahedra(const TriangleMesh& surface, const FillSettings& settings) {
  const ExchangeFolder folder;
  writeSurface(surface, folder.file("surface.smesh"));
  runTetgen(settings, folder);
  TetrahedralMesh mesh = readMesh(folder);
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
