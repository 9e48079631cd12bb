#include "mesh/file_mesh.h"

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/mesh_text.h"
#include "mesh/obj_vertices.h"

namespace fissure {
namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 20;

/// A file system for Assimp that has one file, and that in memory: whatever a mesh names, nothing else can be
/// opened.
class OneFile {
 public:
  explicit OneFile(const MeshText& text)
      : name_(nameOf(text.format)), bytes_(text.bytes), system_{&open, &close, data(this)} {}
  OneFile(const OneFile&) = delete;
  OneFile& operator=(const OneFile&) = delete;

  const char* name() const { return name_; }
  aiFileIO* files() { return &system_; }

 private:
  /// An opened file: Assimp's functions, and how far it was read.
  struct Opened {
    aiFile file{};
    const std::string* bytes = nullptr;
    std::size_t at = 0;
  };

  static const char* nameOf(MeshFormat format) {
    constexpr const char* names[] = {"mesh.stl", "mesh.obj", "mesh.ply", "mesh.off"};
    return names[static_cast<std::size_t>(format)];
  }
  template <class T>
  static char* data(T* object) {
    return reinterpret_cast<char*>(object);
  }
  static Opened& opened(aiFile* file) { return *reinterpret_cast<Opened*>(file->UserData); }

  static aiFile* open(aiFileIO* system, const char* name, const char* mode) {
    const OneFile& here = *reinterpret_cast<OneFile*>(system->UserData);
    if (std::strcmp(name, here.name_) != 0 || mode[0] != 'r') return nullptr;
    auto made = std::make_unique<Opened>();
    made->bytes = &here.bytes_;
    made->file = {&read, &write, &tell, &size, &seek, &flush, data(made.get())};
    return &made.release()->file;
  }
  static void close(aiFileIO*, aiFile* file) { delete &opened(file); }
  static std::size_t read(aiFile* file, char* to, std::size_t size, std::size_t count) {
    Opened& from = opened(file);
    const std::size_t items = size == 0 ? 0 : std::min(count, (from.bytes->size() - from.at) / size);
    std::copy_n(from.bytes->data() + from.at, items * size, to);
    from.at += items * size;
    return items;
  }
  static std::size_t write(aiFile*, const char*, std::size_t, std::size_t) { return 0; }
  static std::size_t tell(aiFile* file) { return opened(file).at; }
  static std::size_t size(aiFile* file) { return opened(file).bytes->size(); }
  static aiReturn seek(aiFile* file, std::size_t offset, aiOrigin origin) {
    Opened& in = opened(file);
    const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? in.at : in.bytes->size();
    const std::size_t to = from + offset;  // an offset back wraps around, as it should
    if (to > in.bytes->size()) return aiReturn_FAILURE;
    in.at = to;
    return aiReturn_SUCCESS;
  }
  static void flush(aiFile*) {}

  const char* name_;
  const std::string& bytes_;
  aiFileIO system_;
};

/// Assimp, loaded when the first mesh is read: linked, it would cost every start of every program 6 ms.
class Assimp {
 public:
  Assimp()
      : library_(dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)),  // it may leave exit handlers behind
        import_(find<decltype(import_)>("aiImportFileEx")),
        triangulate_(find<decltype(triangulate_)>("aiApplyPostProcessing")),
        error_(find<decltype(error_)>("aiGetErrorString")),
        release_(find<decltype(release_)>("aiReleaseImport")),
        attach_(find<decltype(attach_)>("aiAttachLogStream")),
        detach_(find<decltype(detach_)>("aiDetachLogStream")) {
    attach_(&log_);
  }
  ~Assimp() { detach_(&log_); }
  Assimp(const Assimp&) = delete;
  Assimp& operator=(const Assimp&) = delete;

  using Scene = std::unique_ptr<const aiScene, decltype(&aiReleaseImport)>;

  /// Null when it failed; then and otherwise, complaint() says what was wrong.
  Scene read(const MeshText& text) {
    OneFile only(text);
    Scene scene(import_(only.name(), 0, only.files()), release_);
    if (!scene && complaint_.empty()) complaint_ = error_();
    return scene;
  }
  /// Splits polygons; afterwards complaint() says whether some could not be split.
  void triangulate(Scene& scene) {
    if (triangulate_(scene.get(), aiProcess_Triangulate) != nullptr) return;
    (void)scene.release();  // Assimp has freed it
    throw RunError("Assimp cannot split polygons");
  }
  /// The first error or warning; empty: none.
  const std::string& complaint() const { return complaint_; }

 private:
  static constexpr const char* name = "libassimp.so.5";

  template <class Function>
  Function find(const char* function) {
    void* address = library_ ? dlsym(library_, function) : nullptr;
    if (!address)
      throw InputError(
          fmt::format("meshes cannot be read without {} and its {}, expected Debian's package libassimp5",
                      name, function));
    return reinterpret_cast<Function>(address);
  }

  /// Assimp's lines are "Warn,  T0: text".
  static void note(const char* message, char* complaint) {
    const std::string line(message);
    auto& first = *reinterpret_cast<std::string*>(complaint);
    const bool bad = line.starts_with("Error,") || line.starts_with("Warn,");
    if (bad && first.empty()) first = line.substr(std::min(line.find(": ") + 2, line.size()));
  }

  std::string complaint_;
  void* library_;
  decltype(&aiImportFileEx) import_;
  decltype(&aiApplyPostProcessing) triangulate_;
  decltype(&aiGetErrorString) error_;
  decltype(&aiReleaseImport) release_;
  decltype(&aiAttachLogStream) attach_;
  decltype(&aiDetachLogStream) detach_;
  aiLogStream log_{&note, reinterpret_cast<char*>(&complaint_)};
};

/// Its first line, and of a long one (Assimp may quote the whole file) the beginning.
std::string shortened(const std::string& complaint) {
  constexpr std::size_t longest = 120;
  std::string line = complaint.substr(0, complaint.find('\n'));
  if (line.size() > longest) line.replace(longest, std::string::npos, "...");
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, ' ');
  return line;
}

/// Faces that cannot be split into triangles.
void refuseBadFaces(const std::string& file, const aiScene& scene) {
  std::size_t faces = 0, few = 0, beyond = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    for (const aiFace* face = part.mFaces; face != part.mFaces + part.mNumFaces; ++face) {
      ++faces;
      if (face->mNumIndices < 3) ++few;
      beyond += std::any_of(face->mIndices, face->mIndices + face->mNumIndices,
                            [&](unsigned index) { return index >= part.mNumVertices; });
    }
  }
  if (faces == 0) throw InputError(inFile(file), "has no faces, expected a surface");
  if (few > 0)
    throw InputError(
        inFile(file),
        fmt::format("{} of its {} faces have fewer than three corners, expected triangles or polygons", few,
                    faces));
  if (beyond > 0)
    throw InputError(
        inFile(file),
        fmt::format("{} of its {} faces name a vertex that does not exist (a damaged file)", beyond, faces));
}

/// How far the corners of a polygon lie off the plane through their middle, as a share of its extent.
double bend(const aiMesh& part, const aiFace& face) {
  std::vector<Vec3> corners;
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
  for (unsigned i = 0; i < face.mNumIndices; ++i) {
    const aiVector3D& p = part.mVertices[face.mIndices[i]];
    corners.emplace_back(p.x, p.y, p.z);
    middle += corners.back() / face.mNumIndices;
  }
  double off = 0, extent = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - middle).cross(corners[(i + 1) % corners.size()] - middle);
  for (const Vec3& corner : corners) {
    off = std::max(off, std::abs(normal.normalized().dot(corner - middle)));
    extent = std::max(extent, 2 * (corner - middle).norm());
  }
  return extent > 0 ? off / extent : 0;
}

/// A polygon bent by more than this share of its extent is not planar: far more than rounding to single
/// precision does.
constexpr double largest_bend = 1e-3;

void noteBentPolygons(const aiScene& scene, std::vector<Defect>& oddities) {
  std::size_t faces = 0, bent = 0, first = 0;
  double first_bend = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    for (const aiFace* face = part.mFaces; face != part.mFaces + part.mNumFaces; ++face, ++faces) {
      const double share = face->mNumIndices > 3 ? bend(part, *face) : 0;
      if (!(share > largest_bend) || ++bent > 1) continue;
      first = faces;
      first_bend = share;
    }
  }
  if (bent == 0) return;
  oddities.push_back({DefectKind::non_planar_polygons, bent,
                      fmt::format("{} (their triangles are the reader's choice; the first is face {} of the "
                                  "file, counted from 0, bent by {:.3g} % of its extent)",
                                  counted(bent, "non-planar polygon"), first, 100 * first_bend)});
}

void noteUnused(std::size_t count, const std::string& first, std::vector<Defect>& oddities) {
  if (count == 0) return;
  oddities.push_back({DefectKind::unused_vertices, count,
                      fmt::format("{} of the file in no face (the first is {})",
                                  counted(count, "vertex", "vertices"), first)});
}

/// OBJ's are not in the mesh: Assimp leaves them out.
void noteUnusedVertices(const MeshText& text, const TriangleMesh& mesh, std::vector<Defect>& oddities) {
  if (text.format == MeshFormat::obj) {
    const UnusedVertices unused = unusedVertices(text.bytes);
    return noteUnused(unused.count, "in line " + std::to_string(unused.first_line), oddities);
  }
  std::vector<char> used(mesh.vertices_m.size(), 0);
  for (const Face& face : mesh.faces)
    for (const int v : face) used[static_cast<std::size_t>(v)] = 1;
  const auto first = std::find(used.begin(), used.end(), 0);
  noteUnused(static_cast<std::size_t>(std::count(first, used.end(), 0)),
             fmt::format("vertex {}, counted from 0", first - used.begin()), oddities);
}

bool hasPolygons(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    if (std::any_of(part.mFaces, part.mFaces + part.mNumFaces,
                    [](const aiFace& face) { return face.mNumIndices > 3; }))
      return true;
  }
  return false;
}

void append(const aiMesh& part, TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices_m.size());
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D& p = part.mVertices[v];
    mesh.vertices_m.emplace_back(p.x, p.y, p.z);
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const unsigned* index = part.mFaces[f].mIndices;
    const auto corner = [&](int k) { return first + static_cast<int>(index[k]); };
    mesh.faces.push_back({corner(0), corner(1), corner(2)});
  }
}

}  // namespace

FileMesh readMeshFile(const std::filesystem::path& file) {
  const MeshText text = readMeshText(file);
  Assimp assimp;
  const auto requireGood = [&](bool read) {
    if (!read || !assimp.complaint().empty())
      throw InputError(inFile(file), "cannot be read as a mesh (" + shortened(assimp.complaint()) + ")");
  };
  Assimp::Scene scene = assimp.read(text);
  requireGood(scene != nullptr);
  refuseBadFaces(file.string(), *scene);
  FileMesh file_mesh;
  TriangleMesh& mesh = file_mesh.mesh;
  noteBentPolygons(*scene, file_mesh.oddities);
  if (hasPolygons(*scene)) assimp.triangulate(scene);
  requireGood(true);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) append(*scene->mMeshes[m], mesh);
  if (mesh.faces.size() > max_triangles)
    throw InputError(inFile(file),
                     fmt::format("has {} triangles, expected at most {}", mesh.faces.size(), max_triangles));
  noteUnusedVertices(text, mesh, file_mesh.oddities);
  return file_mesh;
}

}  // namespace fissure
