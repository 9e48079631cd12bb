#include "mesh/mesh_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "files/input_file.h"
#include "mesh/ply_layout.h"

namespace fissure {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_bytes = std::uintmax_t{256} << 20;

/// Each of them ends a line to Assimp, and so does NUL.
constexpr std::string_view line_ends = "\n\r\f";

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
  std::string bytes = readInputFile(file, "a mesh", max_bytes);
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
  fail(file,
       fmt::format(
           "as a binary STL file it would hold {} triangles in {} bytes, but it has {} (a damaged file)",
           count, head + triangle * std::uintmax_t{count}, bytes.size()));
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
  std::string text = bytes.substr(0, std::min<std::size_t>(bytes.size(), 65536));
  for (std::size_t at = 0; (at = text.find('#', at)) != std::string::npos;)
    text.erase(at, text.find_first_of(line_ends, at) - at);
  std::istringstream words(text);
  std::string key;
  double vertices = -1, faces = -1;
  if (!(words >> key) || key.size() > 6 || !key.ends_with("OFF")) fail(file, "is no OFF file");
  if (!(words >> vertices >> faces))
    fail(file, "is no OFF file, expected the numbers of vertices and faces after OFF");
  requireRoom(file, bytes, "vertices", vertices);
  requireRoom(file, bytes, "faces", faces);
}

/// Lines about materials, which concern other files, become comments.
void hideMaterials(const fs::path& file, std::string& bytes) {
  if (bytes.find('\0') != std::string::npos) fail(file, "is no OBJ file, it is not text");
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::size_t start = bytes.find_first_not_of(" \t", at);
    if (start == std::string::npos) return;
    const bool material = bytes.compare(start, 6, "mtllib") == 0 || bytes.compare(start, 6, "usemtl") == 0;
    if (material) bytes[start] = '#';
    at = std::min(bytes.find_first_of(line_ends, start), bytes.size());
  }
}

}  // namespace

MeshText readMeshText(const fs::path& file) {
  MeshText text{formatOf(file), readBytes(file)};
  switch (text.format) {
    case MeshFormat::stl:
      checkStl(file, text.bytes);
      break;
    case MeshFormat::obj:
      hideMaterials(file, text.bytes);
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
