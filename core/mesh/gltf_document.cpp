#include "core/mesh/gltf_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "core/base/base64.h"
#include "core/base/hex_digit.h"
#include "core/base/json_parse.h"
#include "core/base/json_read.h"
#include "core/document/fault_list.h"
#include "core/mesh/glb_container.h"
#include "core/search/file_search.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxBuffersTogether = std::uint64_t{2} << 30;

/// Reads the buffers that are not in the file, each URI once.
class BufferLoader {
 public:
  BufferLoader(GltfDocument& document, const std::filesystem::path& path,
               const ResolveFile& resolve)
      : document_(document), path_(path), resolve_(resolve) {}

  Result<ByteView> load(const std::string& uri, const std::string& place) {
    const auto known = known_.find(uri);
    if (known != known_.end()) return known->second;
    Result<Bytes> bytes = read(uri, place);
    if (!bytes.ok()) return bytes.error();
    together_ += bytes->size();
    if (together_ > kMaxBuffersTogether) {
      return Error{
          ErrorKind::unsupported,
          fmt::format("its buffers are larger than {} GiB together", kMaxBuffersTogether >> 30),
          path_.string()};
    }
    document_.read.push_back(std::move(*bytes));
    return known_[uri] = document_.read.back();
  }

 private:
  Result<Bytes> read(const std::string& uri, const std::string& place) const {
    if (isDataUri(uri)) {
      std::optional<Bytes> bytes = bytesOfDataUri(uri);
      if (bytes) return std::move(*bytes);
      return Error{ErrorKind::damaged, place + ": its data URI is not base64", path_.string()};
    }
    FoundFile found = resolve_(fileNameOfUri(uri), path_.parent_path());
    if (found.path.empty()) found = resolve_(uri, path_.parent_path());
    if (found.path.empty()) {
      return Error{ErrorKind::not_found,
                   "names " + quotedInFault(fileNameOfUri(uri)) +
                       ", which is not found within the search roots",
                   path_.string()};
    }
    return readWholeFile(found.path, kMaxSceneBytes);
  }

  GltfDocument& document_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  std::map<std::string, ByteView> known_;
  std::uint64_t together_ = 0;
};

template <class T>
T valueAt(const std::byte* at) {
  T value{};
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace

const GltfJson& GltfDocument::all(const char* array) const {
  static const GltfJson kEmpty = GltfJson::array();
  const auto found = root.find(array);
  return found == root.end() ? kEmpty : *found;
}

Result<GltfDocument> openGltf(ByteView bytes, const std::filesystem::path& path,
                              const ResolveFile& resolve) {
  const Result<GltfParts> parts = gltfParts(bytes);
  if (!parts.ok()) return Error{parts.error().kind, parts.error().what, path.string()};
  GltfDocument document;
  Result<GltfJson> root = parseJson<GltfJson>(parts->text);
  if (!root.ok()) {
    const bool is_json = root.error().kind != ErrorKind::damaged;
    return Error{root.error().kind, is_json ? root.error().what : "is not valid JSON",
                 path.string()};
  }
  document.root = std::move(*root);
  std::string problem = problemOfGltf(document.root, parts->binary.size());
  if (!problem.empty()) return Error{ErrorKind::damaged, std::move(problem), path.string()};
  const GltfJson& buffers = document.all("buffers");
  document.read.reserve(buffers.size());  // views into them stay valid
  BufferLoader loader(document, path, resolve);
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string place = fmt::format("buffers[{}]", i);
    const auto stated = static_cast<std::size_t>(numberIn<double>(buffers[i], "byteLength", 0));
    ByteView content = parts->binary;
    if (buffers[i].contains("uri")) {
      Result<ByteView> loaded = loader.load(buffers[i]["uri"].get<std::string>(), place);
      if (!loaded.ok()) return loaded.error();
      content = *loaded;
    }
    if (content.size() < stated) {
      return Error{ErrorKind::damaged,
                   fmt::format("{}: states {} bytes, and has {}", place, stated, content.size()),
                   path.string()};
    }
    document.buffers.push_back(content.first(stated));
  }
  return document;
}

bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<Bytes> bytesOfDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return {};
  return bytesOfBase64(uri.substr(comma + 1));
}

std::string fileNameOfUri(std::string_view uri) { return percentDecoded(uri); }

std::optional<std::size_t> gltfIndex(const GltfJson& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::size_t>();
}

const GltfJson* gltfExtension(const GltfJson& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() || !found->is_object() ? nullptr : &*found;
}

std::size_t gltfComponentBytes(std::uint64_t type) {
  switch (type) {
    case 5120:  // signed and unsigned byte
    case 5121:
      return 1;
    case 5122:  // short
    case 5123:
      return 2;
    case 5125:  // unsigned int, float
    case 5126:
      return 4;
    default:
      return 0;
  }
}

std::size_t gltfComponentsOf(std::string_view type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  return type == "MAT4" ? 16 : 0;
}

bool isGltfExtensionRead(std::string_view name) {
  return name == "KHR_texture_transform" || name == "KHR_mesh_quantization" ||
         name == "EXT_mesh_gpu_instancing";
}

GltfAccessor::GltfAccessor(const GltfDocument& document, std::size_t number) {
  const GltfJson& accessor = document.all("accessors")[number];
  count_ = *gltfIndex(accessor, "count");
  type_ = static_cast<unsigned>(*gltfIndex(accessor, "componentType"));
  component_bytes_ = gltfComponentBytes(type_);
  components_ = gltfComponentsOf(accessor["type"].get<std::string>());
  const auto normalized = accessor.find("normalized");
  normalized_ = normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>();
  const std::size_t element_bytes = component_bytes_ * components_;
  if (accessor.contains("bufferView")) base_ = runOf(document, accessor, element_bytes);
  const auto sparse = accessor.find("sparse");
  if (sparse == accessor.end()) return;
  changed_ = runOf(document, (*sparse)["values"], element_bytes);
  std::shared_ptr<const GltfDocument::Changes>& known = document.changes[number];
  if (known) {
    changes_ = known;
    return;
  }
  auto changes = std::make_shared<GltfDocument::Changes>();
  GltfAccessor places(*this);
  places.type_ = static_cast<unsigned>(*gltfIndex((*sparse)["indices"], "componentType"));
  places.component_bytes_ = gltfComponentBytes(places.type_);
  places.base_ = runOf(document, (*sparse)["indices"], places.component_bytes_);
  const std::size_t changed = *gltfIndex(*sparse, "count");
  changes->reserve(changed);
  for (std::size_t i = 0; i < changed; ++i) {
    changes->emplace_back(places.index(i), static_cast<std::uint32_t>(i));
  }
  std::ranges::sort(*changes);
  changes_ = known = std::move(changes);
}

GltfAccessor::Run GltfAccessor::runOf(const GltfDocument& document, const GltfJson& user,
                                      std::size_t element_bytes) const {
  const GltfJson& view = document.all("bufferViews")[*gltfIndex(user, "bufferView")];
  const std::size_t begin = gltfIndex(view, "byteOffset").value_or(0);
  const std::size_t offset = gltfIndex(user, "byteOffset").value_or(0);
  const ByteView all = document.buffers[*gltfIndex(view, "buffer")].subspan(
      begin, gltfIndex(view, "byteLength").value_or(0));
  const std::size_t stride = gltfIndex(view, "byteStride").value_or(0);
  return {all.subspan(offset), stride == 0 ? element_bytes : stride};
}

const std::byte* GltfAccessor::find(std::size_t element, std::size_t component) const {
  const Run* run = &base_;
  if (changes_ != nullptr) {
    const auto at = std::ranges::lower_bound(
        *changes_, std::pair(static_cast<std::uint32_t>(element), std::uint32_t{0}));
    if (at != changes_->end() && at->first == element) {
      run = &changed_;
      element = at->second;
    }
  }
  if (run->bytes.empty()) return nullptr;
  return run->bytes.data() + element * run->stride + component * component_bytes_;
}

double GltfAccessor::number(std::size_t element, std::size_t component) const {
  const std::byte* at = find(element, component);
  if (at == nullptr) return 0;
  const auto signedOf = [&](double value, double most) {
    return normalized_ ? std::max(value / most, -1.0) : value;
  };
  switch (type_) {
    case 5120:
      return signedOf(valueAt<std::int8_t>(at), 127);
    case 5121:
      return signedOf(valueAt<std::uint8_t>(at), 255);
    case 5122:
      return signedOf(valueAt<std::int16_t>(at), 32767);
    case 5123:
      return signedOf(valueAt<std::uint16_t>(at), 65535);
    case 5125:
      return signedOf(valueAt<std::uint32_t>(at), 4294967295.0);
    default:
      return static_cast<double>(valueAt<float>(at));
  }
}

std::uint32_t GltfAccessor::index(std::size_t element, std::size_t component) const {
  const std::byte* at = find(element, component);
  if (at == nullptr) return 0;
  if (component_bytes_ == 1) return valueAt<std::uint8_t>(at);
  if (component_bytes_ == 2) return valueAt<std::uint16_t>(at);
  return valueAt<std::uint32_t>(at);
}

}  // namespace rocinante
