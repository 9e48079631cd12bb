#include "volume/tetrahedra_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "base/counted.h"
#include "base/error.h"
#include "files/input_file.h"
#include "mesh/tetrahedra.h"
#include "mesh/tetrahedron.h"
#include "process/interrupt.h"
#include "process/system_program.h"
#include "scenario/shapes.h"
#include "volume/read_tetrahedra.h"

namespace fissure {

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;
constexpr double most_reading_s = 300;

std::string formatOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".msh") return "gmsh";
  if (ending == ".vtk") return "vtk";
  throw InputError(inFile(file), "no known file of tetrahedra, expected .msh or .vtk");
}

/// What the script has written, taken piece by piece.
class Bytes {
 public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}

  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) throw std::length_error("no line");
    std::string text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  template <class Value>
  std::vector<Value> rows(std::size_t count, std::size_t width) {
    if ((bytes_.size() - at_) / sizeof(Value) / width < count) throw std::length_error("too few bytes");
    std::vector<Value> values(count * width);
    if (count > 0) std::memcpy(values.data(), bytes_.data() + at_, values.size() * sizeof(Value));
    at_ += values.size() * sizeof(Value);
    return values;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

struct Counts {
  std::size_t vertices = 0, tetrahedra = 0, quadratic = 0;
  bool tagged = false;
};

TetrahedralMesh unpacked(Bytes& bytes, const Counts& counts, double unit_m) {
  TetrahedralMesh mesh;
  const std::vector<double> coordinates = bytes.rows<double>(counts.vertices, 3);
  for (std::size_t v = 0; v < counts.vertices; ++v)
    mesh.vertices_m.push_back(unit_m *
                              Vec3(coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]));
  const std::vector<std::int32_t> corners = bytes.rows<std::int32_t>(counts.tetrahedra, 4);
  for (const std::int32_t v : corners)
    if (v < 0 || static_cast<std::size_t>(v) >= counts.vertices) throw std::length_error("no such corner");
  for (std::size_t t = 0; t < counts.tetrahedra; ++t)
    mesh.tetrahedra.push_back({corners[4 * t], corners[4 * t + 1], corners[4 * t + 2], corners[4 * t + 3]});
  if (counts.tagged)
    for (const std::int32_t tag : bytes.rows<std::int32_t>(counts.tetrahedra, 1)) mesh.tags.push_back(tag);
  return mesh;
}

/// Standard output of the script over the file.
std::string readApart(const std::filesystem::path& file) {
  const std::string format = formatOf(file);
  requireInputFile(file, "a mesh");
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size == 0) throw InputError(inFile(file), "is empty, expected a mesh");
  if (size > most_bytes) throw InputError(inFile(file), "is larger than 256 MiB, expected a smaller mesh");
  const Descriptor requests = heldBackRequests();
  ProgramOutcome outcome;
  try {
    outcome = runProgram("/usr/bin/python3",
                         {"-I", "-c", std::string(assets::read_tetrahedra_py), file.string(), format},
                         most_reading_s, requests.number());
  } catch (const KilledProgram& killed) {
    throw RunError("reading " + file.string() + ": " + killed.what());
  }
  if (!outcome.in_time) throw InputError(inFile(file), "is not read within 300 s, expected a smaller mesh");
  if (outcome.code == 3)
    throw RunError(
        fmt::format("reading {} needs Debian's package python3-meshio: {}", file.string(), outcome.error));
  if (outcome.code != 0) throw InputError(inFile(file), outcome.error);
  return outcome.output;
}

void turnInverted(TetrahedralMesh& mesh, std::vector<std::string>& notes) {
  std::size_t turned = 0;
  for (Tetrahedron& tetrahedron : mesh.tetrahedra) {
    if (!(signedVolume(cornersOf(mesh, tetrahedron)) < 0)) continue;
    std::swap(tetrahedron[0], tetrahedron[1]);
    ++turned;
  }
  if (turned > 0)
    notes.push_back(counted(turned, "tetrahedron", "tetrahedra") +
                    " turned, whose corners ran the other way round");
}

}  // namespace

BoundedVolume boundedBySurface(TetrahedralMesh mesh) {
  BoundedVolume volume;
  turnInverted(mesh, volume.notes);
  std::vector<Face> boundary = boundaryFaces(mesh);
  enum Place : char { unused, inside, on_surface };
  std::vector<Place> places(mesh.vertices_m.size(), unused);
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (const int v : tetrahedron) places[static_cast<std::size_t>(v)] = inside;
  for (const Face& face : boundary)
    for (const int v : face) places[static_cast<std::size_t>(v)] = on_surface;
  std::vector<int> numbers(places.size(), -1);
  for (const Place place : {on_surface, inside}) {
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (places[v] != place) continue;
      numbers[v] = static_cast<int>(volume.mesh.vertices_m.size());
      volume.mesh.vertices_m.push_back(mesh.vertices_m[v]);
    }
    if (place == on_surface) volume.surface.vertices_m = volume.mesh.vertices_m;
  }
  const auto numbered = [&](auto corners) {
    for (int& v : corners) v = numbers[static_cast<std::size_t>(v)];
    return corners;
  };
  for (const Face& face : boundary) volume.surface.faces.push_back(numbered(face));
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    volume.mesh.tetrahedra.push_back(numbered(tetrahedron));
  volume.mesh.tags = std::move(mesh.tags);
  const auto dropped = static_cast<std::size_t>(std::count(places.begin(), places.end(), unused));
  if (dropped > 0)
    volume.notes.push_back(counted(dropped, "vertex", "vertices") + " of no tetrahedron left out");
  return volume;
}

BoundedVolume unpackedTetrahedra(const std::string& output, const std::filesystem::path& file,
                                 double unit_m) {
  Bytes bytes(output);
  Counts counts;
  TetrahedralMesh mesh;
  try {
    std::istringstream(bytes.line()) >> counts.vertices >> counts.tetrahedra >> counts.quadratic >>
        counts.tagged;
    if (static_cast<double>(counts.tetrahedra) > most_tetrahedra)
      throw InputError(inFile(file),
                       fmt::format("has {} tetrahedra, expected at most 2097152", counts.tetrahedra));
    mesh = unpacked(bytes, counts, unit_m);
    if (mesh.tetrahedra.empty()) throw std::length_error("no tetrahedra");
  } catch (const std::length_error&) {
    throw RunError("reading " + file.string() + " ended before its time");
  }
  BoundedVolume volume = boundedBySurface(std::move(mesh));
  if (counts.quadratic > 0)
    volume.notes.push_back(counted(counts.quadratic, "quadratic tetrahedron", "quadratic tetrahedra") +
                           " taken as linear, by their corners");
  return volume;
}

BoundedVolume readTetrahedra(const std::filesystem::path& file, double unit_m) {
  return unpackedTetrahedra(readApart(file), file, unit_m);
}

}  // namespace fissure
