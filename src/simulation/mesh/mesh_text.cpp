#include "mesh/mesh_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.h"
#include "mesh/ply_layout.h"

namespace fissure {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_bytes = std::uintmax_t{256} << 20;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw InputError(inFile(file), what);
}

MeshFormat formatOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<const char*, 4> endings = {".stl", ".obj", ".ply", ".off"};  // in the enum's order
  const auto found = std::find(endings.begin(), endings.end(), ending);
  if (found == endings.end()) fail(file, "no known kind of mesh, expected .stl, .obj, .ply or .off");
  return static_cast<MeshFormat>(found - endings.begin());
}

std::string readBytes(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) fail(file, "is a folder, expected a mesh file");
  if (!fs::exists(file, error)) fail(file, "no such file, expected a mesh");
  if (!fs::is_regular_file(file, error)) fail(file, "is no regular file, expected a mesh");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size > max_bytes) fail(file, "larger than 256 MiB, expected a smaller mesh");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) fail(file, "cannot be read, expected a mesh file");
  if (bytes.empty()) fail(file, "is empty, expected a mesh");
  return bytes;
}

/// Each vertex and face takes two bytes at least.
void requireRoom(const fs::path& file, const std::string& bytes, const std::string& what, double count) {
  if (count >= 0 && 2 * count <= static_cast<double>(bytes.size())) return;
  std::ostringstream text;
  text << "states " << count << " " << what << ", but has only " << bytes.size() << " bytes";
  fail(file, text.str() + " (a damaged file)");
}

/// Binary: 80 bytes, a count, 50 bytes a triangle. Text: begins with "solid".
void checkStl(const fs::path& file, const std::string& bytes) {
  constexpr std::size_t head = 84, triangle = 50;
  std::uint32_t count = 0;
  if (bytes.size() >= head) std::memcpy(&count, bytes.data() + 80, sizeof count);
  if (bytes.size() >= head && bytes.size() == head + triangle * count) return;
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start != std::string::npos && bytes.compare(start, 5, "solid") == 0) return;
  if (bytes.size() < head) fail(file, "is no STL file, it is too short for one");
  fail(file, "as a binary STL file it would hold " + std::to_string(count) + " triangles in " +
                 std::to_string(head + triangle * std::uintmax_t{count}) + " bytes, but it has " +
                 std::to_string(bytes.size()) + " (a damaged file)");
}

void checkPly(const fs::path& file, const std::string& bytes) {
  try {
    PlyLayout(bytes).requireAll(bytes);
  } catch (const InputError& error) {
    fail(file, error.what());
  }
}

/// The word OFF, after letters that say what else a vertex has, then the counts.
void checkOff(const fs::path& file, const std::string& bytes) {
  std::istringstream stream(bytes.substr(0, std::min<std::size_t>(bytes.size(), 65536)));
  std::string text;
  for (std::string line; std::getline(stream, line);) text += line.substr(0, line.find('#')) + "\n";
  std::istringstream words(text);
  std::string key;
  double vertices = -1, faces = -1;
  if (!(words >> key) || key.size() > 6 || !key.ends_with("OFF")) fail(file, "is no OFF file");
  if (!(words >> vertices >> faces))
    fail(file, "is no OFF file, expected the numbers of vertices and faces after OFF");
  requireRoom(file, bytes, "vertices", vertices);
  requireRoom(file, bytes, "faces", faces);
}

/// Lines about materials would make Assimp look for other files.
void dropMaterials(const fs::path& file, std::string& bytes) {
  if (bytes.find('\0') != std::string::npos) fail(file, "is no OBJ file, it is not text");
  std::string kept;
  kept.reserve(bytes.size());
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string key = line.substr(start, 6);
    if (key != "mtllib" && key != "usemtl") kept += line;
    kept += '\n';
  }
  bytes = std::move(kept);
}

}  // namespace

MeshText readMeshText(const fs::path& file) {
  MeshText text{formatOf(file), readBytes(file)};
  switch (text.format) {
    case MeshFormat::stl:
      checkStl(file, text.bytes);
      break;
    case MeshFormat::obj:
      dropMaterials(file, text.bytes);
      break;
    case MeshFormat::ply:
      checkPly(file, text.bytes);
      break;
    case MeshFormat::off:
      checkOff(file, text.bytes);
      break;
  }
  return text;
}

}  // namespace fissure
