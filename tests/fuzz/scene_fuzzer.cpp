// Any bytes as COLLADA, as binary glTF, and as the JSON of one: the first byte chooses. What comes
// back must be drawable.

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/mesh/mesh_file.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

void requireDrawable(const Mesh& mesh) {
  require(mesh.indices.size() % 3 == 0);
  require(mesh.colors.empty() || mesh.colors.size() == mesh.vertices.size());
  for (const std::uint32_t index : mesh.indices) require(index < mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    require(std::isfinite(vertex.position.x) && std::isfinite(vertex.texture.y));
    require(std::fabs(glm::dot(vertex.normal, vertex.normal) - 1) < 1e-3F);
  }
  for (const MeshPart& part : mesh.parts) require(part.material < mesh.materials.size());
}

void addNumber(Bytes& bytes, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::byte>(number >> shift & 0xFFU));
  }
}

/// A .glb of that JSON with 128 bytes of data.
Bytes binaryOf(ByteView json) {
  constexpr std::size_t kData = 128;
  Bytes bytes;
  const std::size_t padded = (json.size() + 3) / 4 * 4;
  addNumber(bytes, 0x46546C67);
  addNumber(bytes, 2);
  addNumber(bytes, 28 + padded + kData);
  addNumber(bytes, padded);
  addNumber(bytes, 0x4E4F534A);
  bytes.insert(bytes.end(), json.begin(), json.end());
  bytes.resize(20 + padded, std::byte{' '});
  addNumber(bytes, kData);
  addNumber(bytes, 0x004E4942);
  for (std::size_t i = 0; i < kData; ++i) bytes.push_back(static_cast<std::byte>(i * 37 % 11));
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ByteView bytes = std::as_bytes(std::span(data, size)).subspan(1);
  Findings faults;
  MeshReadOptions options;
  options.resolve = [](const std::string&, const std::filesystem::path&) { return FoundFile{}; };
  const Bytes wrapped = data[0] % 3 == 2 ? binaryOf(bytes) : Bytes();
  const Result<Mesh> mesh =
      readMeshBytes(data[0] % 3 == 2 ? ByteView(wrapped) : bytes,
                    data[0] % 3 == 0 ? "fuzz.dae" : "fuzz.glb", options, faults);
  if (mesh) requireDrawable(*mesh);
  return 0;
}
