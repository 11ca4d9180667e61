#include "core/mesh/mesh_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/document/fault_list.h"
#include "core/mesh/mesh_readers.h"

namespace rocinante {
namespace {

/// The file's ending in lower case: ".obj".
std::string endingOfMesh(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending;
}

/// A whole file in its own memory. Not a mapped file: the program would crash if it shrank
/// meanwhile. In huge pages where available, since allocating a hundred megabytes of small pages
/// takes longer than filling them.
class WholeFile {
 public:
  static constexpr std::uint64_t kLargestBytes = std::uint64_t{1} << 32U;

  WholeFile() = default;
  ~WholeFile() {
    if (memory_ != MAP_FAILED) ::munmap(memory_, capacity_);
    if (file_ >= 0) ::close(file_);
  }
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  Status read(const std::filesystem::path& path) {
    file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_ < 0) return systemError("cannot open", path);
    struct stat facts {};
    if (::fstat(file_, &facts) != 0) return systemError("cannot read", path);
    if (!S_ISREG(facts.st_mode)) {
      return Error{ErrorKind::unreadable, "is not a regular file", path.string()};
    }
    if (static_cast<std::uint64_t>(facts.st_size) > kLargestBytes) {
      return Error{ErrorKind::unsupported, "the file is larger than the 4 GiB that are read",
                   path.string()};
    }
    // Never of zero bytes, which mmap refuses.
    capacity_ = static_cast<std::size_t>(facts.st_size) + 1;
    memory_ =
        ::mmap(nullptr, capacity_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory_ == MAP_FAILED) return systemError("no memory to read", path);
    ::madvise(memory_, capacity_, MADV_HUGEPAGE);
    while (size_ < capacity_) {
      const ssize_t got =
          ::read(file_, static_cast<std::byte*>(memory_) + size_, capacity_ - size_);
      if (got == 0) break;
      if (got < 0 && errno != EINTR) return systemError("cannot read", path);
      if (got > 0) size_ += static_cast<std::size_t>(got);
    }
    return {};
  }

  ByteView bytes() const { return {static_cast<const std::byte*>(memory_), size_}; }

 private:
  static Error systemError(std::string what, const std::filesystem::path& path) {
    const int code = errno;
    return {code == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable,
            std::move(what) + ": " + std::strerror(code), path.string()};
  }

  int file_ = -1;
  void* memory_ = MAP_FAILED;
  std::size_t capacity_ = 0, size_ = 0;
};

/// Every export has some triangles without area; one in a hundred is worth a note.
void judgeTriangles(const Mesh& mesh, FaultList& faults) {
  std::size_t flat = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[mesh.indices[i]].position);
    const Vec3 b(mesh.vertices[mesh.indices[i + 1]].position);
    const Vec3 c(mesh.vertices[mesh.indices[i + 2]].position);
    if (glm::cross(b - a, c - a) == Vec3(0.0)) ++flat;
  }
  if (flat * 100 < mesh.triangleCount() || flat == 0) return;
  faults.note("mesh.degenerate-triangles", {},
              fmt::format("{} of the {} triangles have no area", flat, mesh.triangleCount()),
              "they are invisible; remove them where the mesh is made");
}

Result<Mesh> readByEnding(ByteView bytes, const std::filesystem::path& path,
                          const MeshReadOptions& options, FaultList& mesh_faults) {
  const std::string ending = endingOfMesh(path);
  if (ending == ".obj") return readObj(bytes, path, options, mesh_faults);
  if (ending == ".stl" || ending == ".stlb") return readStl(bytes, path, options, mesh_faults);
  if (ending == ".dae") return readCollada(bytes, path, options, mesh_faults);
  if (ending == ".gltf" || ending == ".glb") return readGltf(bytes, path, options, mesh_faults);
  return Error{ErrorKind::unsupported,
               "is not a mesh that can be read: .obj, .stl, .dae, .gltf and .glb are, not " +
                   (ending.empty() ? "a file without an ending" : quotedInFault(ending)),
               path.string()};
}

}  // namespace

bool statesUnit(const std::filesystem::path& path) {
  const std::string ending = endingOfMesh(path);
  return ending == ".dae" || ending == ".gltf" || ending == ".glb";
}

bool isMeshFile(const std::filesystem::path& path) {
  const std::string ending = endingOfMesh(path);
  return ending == ".obj" || ending == ".stl" || ending == ".stlb" || statesUnit(path);
}

Result<Mesh> readMeshBytes(ByteView bytes, const std::filesystem::path& path,
                           const MeshReadOptions& options, Findings& faults) {
  FaultList mesh_faults(faults, path.string());
  Result<Mesh> mesh = readByEnding(bytes, path, options, mesh_faults);
  if (mesh.ok()) judgeTriangles(*mesh, mesh_faults);
  return mesh;
}

Result<Mesh> readMeshFile(const std::filesystem::path& path, const MeshReadOptions& options,
                          Findings& faults) {
  WholeFile file;
  if (Status read = file.read(path); !read) return read.error();
  return readMeshBytes(file.bytes(), path, options, faults);
}

}  // namespace rocinante
