#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

using GltfJson = nlohmann::json;

/// A glTF 2 file that is safe to read: every index, length and type of `root` was checked
/// (gltf_guard.cpp), and every buffer is at hand.
struct GltfDocument {
  /// Of a sparse accessor: its changed elements and their places among the values, sorted.
  using Changes = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  GltfJson root;
  std::vector<ByteView> buffers;  ///< of the file, or of `read`
  std::vector<Bytes> read;        ///< from other files and data URIs
  /// By accessor, each found once: many primitives may share one. One thread.
  mutable std::map<std::size_t, std::shared_ptr<const Changes>> changes{};

  /// A top-level array; an empty one when it is not there.
  const GltfJson& all(const char* array) const;
};

/// Opens a .gltf or .glb. `bytes` are borrowed by the document. Buffers in other files are read
/// only through `resolve`; not_found names the one that it does not find.
Result<GltfDocument> openGltf(ByteView bytes, const std::filesystem::path& path,
                              const ResolveFile& resolve);

/// The content of a data URI (RFC 2397); empty when it is not base64. Not a data URI: see
/// isDataUri.
std::optional<Bytes> bytesOfDataUri(std::string_view uri);
bool isDataUri(std::string_view uri);
/// The file name that a relative URI writes, %20 for a blank; the name itself when that is how the
/// file is called.
std::string fileNameOfUri(std::string_view uri);

/// Empty unless it is a whole number from 0.
std::optional<std::size_t> gltfIndex(const GltfJson& object, const char* key);
/// The extension of an object, or null.
const GltfJson* gltfExtension(const GltfJson& object, const char* name);

/// Of a component type's number (5120 to 5126); 0 for others.
std::size_t gltfComponentBytes(std::uint64_t type);
/// "VEC3" has 3; 0 for unknown ones.
std::size_t gltfComponentsOf(std::string_view type);
/// Whether the reader does what an extension of this name means.
bool isGltfExtensionRead(std::string_view name);

/// What an accessor holds (glTF 2.0, 3.6.2), number by number; nothing is copied but the places of
/// sparse changes. Borrows the document.
class GltfAccessor {
 public:
  GltfAccessor(const GltfDocument& document, std::size_t number);

  std::size_t count() const { return count_; }
  std::size_t components() const { return components_; }
  /// Whether the file has any of its bytes; else every number is 0 (or compressed elsewhere).
  bool hasBytes() const { return !base_.bytes.empty() || changes_ != nullptr; }
  /// Normalised integers are in [-1, 1]. In range: element < count(), component < components().
  double number(std::size_t element, std::size_t component) const;
  float single(std::size_t element, std::size_t component) const {
    return static_cast<float>(number(element, component));
  }
  /// A whole number from 0, of an accessor of indices or joints.
  std::uint32_t index(std::size_t element, std::size_t component = 0) const;

 private:
  struct Run {
    ByteView bytes{};
    std::size_t stride = 0;
  };
  Run runOf(const GltfDocument& document, const GltfJson& user, std::size_t element_bytes) const;
  const std::byte* find(std::size_t element, std::size_t component) const;

  std::size_t count_ = 0, components_ = 0, component_bytes_ = 0;
  unsigned type_ = 0;
  bool normalized_ = false;
  Run base_, changed_;
  std::shared_ptr<const GltfDocument::Changes> changes_;  ///< null: not sparse
};

/// Names everything of a checked document that readGltf() does not use, known or not: each
/// property, attribute, extension, primitive, scene and node. `is_drawn` is by node. Not named is
/// what glTF defines as ignorable: extras, and who made the file.
void nameWhatGltfLeavesOut(const GltfDocument& document, const std::vector<bool>& is_drawn,
                           FaultList& faults);

/// What is wrong with a glTF document, in a sentence without its place; empty when every index,
/// length and type that the reader follows is sound: bufferViews lie in buffers, accessors in
/// bufferViews, nodes form trees that are not too deep. Refuses other versions than 2 and required
/// extensions that are not read. `binary_bytes` is the size of a .glb's binary chunk.
std::string problemOfGltf(const nlohmann::json& root, std::size_t binary_bytes);

}  // namespace rocinante
