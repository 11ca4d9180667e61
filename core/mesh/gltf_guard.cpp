#include "core/mesh/gltf_guard.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/json_parse.h"
#include "core/mesh/glb_container.h"

namespace rocinante {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepestNodes = 100;           // nodes below nodes
constexpr std::uint64_t kMaxBufferBytes = 1U << 29;  // of one buffer

std::size_t componentBytes(std::uint64_t type) {
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

std::size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  return type == "MAT4" ? 16 : 0;
}

/// Checks every index and length of the document against what it refers to. Keeps the first
/// problem.
class GltfJudge {
 public:
  GltfJudge(Json& root, ByteView binary) : root_(root), binary_(binary) {}

  std::string problem() {
    buffers();
    each("bufferViews", [&](Json& view, const std::string& place) { bufferView(view, place); });
    each("accessors", [&](Json& accessor, const std::string& place) { check(accessor, place); });
    each("images", [&](Json& image, const std::string& place) {
      if (image.contains("bufferView")) indexIn(image, "bufferView", "bufferViews", place);
      requireText(image, "uri", place);
    });
    each("textures", [&](Json& texture, const std::string& place) {
      if (texture.contains("source")) indexIn(texture, "source", "images", place);
      if (texture.contains("sampler")) indexIn(texture, "sampler", "samplers", place);
    });
    each("samplers", [](Json&, const std::string&) {});
    each("materials", [&](Json& material, const std::string& place) { textures(material, place); });
    each("meshes", [&](Json& mesh, const std::string& place) { checkMesh(mesh, place); });
    nodes();
    each("scenes", [&](Json& scene, const std::string& place) {
      if (scene.contains("nodes")) indices(scene["nodes"], "nodes", place);
    });
    if (root_.contains("scene")) indexIn(root_, "scene", "scenes", "the file");
    return problem_;
  }

 private:
  void fail(std::string sentence) {
    if (problem_.empty()) problem_ = std::move(sentence);
  }

  std::size_t countOf(const char* array) const {
    const auto found = root_.find(array);
    return found != root_.end() && found->is_array() ? found->size() : 0;
  }

  /// A whole number that is not negative; `fallback` where there is none.
  std::uint64_t number(const Json& object, const char* key, std::uint64_t fallback,
                       const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return fallback;
    if (found->is_number_unsigned() && found->get<std::uint64_t>() <= kMaxBufferBytes) {
      return found->get<std::uint64_t>();
    }
    fail(fmt::format("{}: `{}` is not a valid number", place, key));
    return fallback;
  }

  std::optional<std::size_t> indexIn(const Json& object, const char* key, const char* array,
                                     const std::string& place) {
    const std::uint64_t index = number(object, key, kMaxBufferBytes, place);
    if (index < countOf(array)) return static_cast<std::size_t>(index);
    fail(fmt::format("{}: `{}` is not an index into the {} {}", place, key, countOf(array), array));
    return std::nullopt;
  }

  void indices(const Json& list, const char* array, const std::string& place) {
    if (!list.is_array()) return fail(fmt::format("{}: `{}` is not an array", place, array));
    for (const Json& index : list) {
      if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= countOf(array)) {
        return fail(fmt::format("{}: holds something that is not an index into the {} {}", place,
                                countOf(array), array));
      }
    }
  }

  void requireText(const Json& object, const char* key, const std::string& place) {
    const auto found = object.find(key);
    if (found != object.end() && !found->is_string()) {
      fail(fmt::format("{}: `{}` is not a string", place, key));
    }
  }

  template <class Each>
  void each(const char* array, const Each& judge) {
    const auto found = root_.find(array);
    if (found == root_.end()) return;
    if (!found->is_array()) return fail(fmt::format("`{}` is not an array", array));
    for (std::size_t i = 0; i < found->size() && problem_.empty(); ++i) {
      const std::string place = fmt::format("{}[{}]", array, i);
      if (!(*found)[i].is_object()) return fail(place + " is not an object");
      (*found)[i].erase("extras");
      if (std::string_view(array) != "textures" && std::string_view(array) != "materials") {
        (*found)[i].erase("extensions");
      }
      requireText((*found)[i], "name", place);
      judge((*found)[i], place);
    }
  }

  void buffers() {
    each("buffers", [&](Json& buffer, const std::string& place) {
      const std::uint64_t bytes = number(buffer, "byteLength", 0, place);
      requireText(buffer, "uri", place);
      buffer_bytes_.push_back(bytes);
      if (!buffer.contains("uri") && bytes > binary_.size()) {
        fail(fmt::format("{}: says {} bytes, and the binary chunk has {}", place, bytes,
                         binary_.size()));
      }
    });
  }

  void bufferView(const Json& view, const std::string& place) {
    const auto buffer = indexIn(view, "buffer", "buffers", place);
    const std::uint64_t offset = number(view, "byteOffset", 0, place);
    const std::uint64_t bytes = number(view, "byteLength", 0, place);
    const std::uint64_t stride = number(view, "byteStride", 0, place);
    if (buffer && offset + bytes > buffer_bytes_[*buffer]) {
      fail(fmt::format("{}: goes past the end of its buffer", place));
    }
    if (stride > 252) fail(fmt::format("{}: a stride of {} bytes", place, stride));
    views_.push_back({bytes, stride});
  }

  struct View {
    std::uint64_t bytes, stride;
  };
  struct Accessor {
    std::uint64_t count, component;
    std::size_t components;
  };

  void check(const Json& accessor, const std::string& place) {
    const std::uint64_t component = number(accessor, "componentType", 0, place);
    requireText(accessor, "type", place);
    const std::size_t components =
        problem_.empty() ? componentsOf(accessor.value("type", std::string())) : 0;
    const std::uint64_t count = number(accessor, "count", 0, place);
    const std::size_t bytes = componentBytes(component) * components;
    if (bytes == 0 || count == 0) return fail(place + ": has no type or no count");
    accessors_.push_back({count, component, components});
    if (accessor.contains("bufferView")) {
      spans(accessor, count, bytes, place);
    } else if (count * bytes > kMaxBufferBytes) {
      fail(place + ": is too large");
    }
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end()) return;
    if (!sparse->is_object() || !sparse->contains("indices") || !sparse->contains("values") ||
        !(*sparse)["indices"].is_object() || !(*sparse)["values"].is_object()) {
      return fail(place + ": `sparse` lacks its parts");
    }
    const std::uint64_t changed = number(*sparse, "count", 0, place);
    const std::size_t index_bytes =
        componentBytes(number((*sparse)["indices"], "componentType", 0, place));
    if (changed == 0 || changed > count || index_bytes == 0) {
      return fail(place + ": `sparse` has no valid count or type");
    }
    spans((*sparse)["indices"], changed, index_bytes, place);
    spans((*sparse)["values"], changed, bytes, place);
    // Only the bytes say which elements change, and assimp writes wherever they point.
    fail(place + ": is sparse, which is not read");
  }

  void spans(const Json& user, std::uint64_t count, std::size_t bytes, const std::string& place) {
    const auto view = indexIn(user, "bufferView", "bufferViews", place);
    const std::uint64_t offset = number(user, "byteOffset", 0, place);
    if (!view) return;
    const std::uint64_t stride = views_[*view].stride == 0 ? bytes : views_[*view].stride;
    if (stride < bytes || offset + stride * (count - 1) + bytes > views_[*view].bytes) {
      fail(place + ": goes past the end of its bufferView");
    }
  }

  void textures(Json& object, const std::string& place) {
    for (auto& [key, value] : object.items()) {
      if (!value.is_object()) continue;
      if (key.ends_with("Texture")) {
        indexIn(value, "index", "textures", place);
        if (number(value, "texCoord", 0, place) > 7) fail(place + ": `texCoord` is above 7");
        keepTransform(value);
      } else if (key == "pbrMetallicRoughness") {
        textures(value, place);
      }
    }
    object.erase("extensions");
  }

  static void keepTransform(Json& texture) {
    Json kept = Json::object();
    if (texture.contains("extensions") && texture["extensions"].is_object() &&
        texture["extensions"].contains("KHR_texture_transform")) {
      kept["KHR_texture_transform"] = texture["extensions"]["KHR_texture_transform"];
    }
    texture["extensions"] = std::move(kept);
  }

  void checkMesh(Json& mesh, const std::string& place) {
    mesh.erase("weights");
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) return fail(place + ": no primitives");
    for (Json& primitive : *primitives) {
      if (!primitive.is_object()) return fail(place + ": a primitive is not an object");
      for (const char* key : {"targets", "extensions", "extras"}) primitive.erase(key);
      if (primitive.contains("material")) indexIn(primitive, "material", "materials", place);
      if (number(primitive, "mode", 4, place) > 6) fail(place + ": an unknown kind of primitive");
      attributes(primitive, place);
      if (!problem_.empty() || !primitive.contains("indices")) continue;
      const auto index = indexIn(primitive, "indices", "accessors", place);
      if (index && (accessors_[*index].components != 1 || accessors_[*index].component == 5126 ||
                    accessors_[*index].component == 5120 || accessors_[*index].component == 5122)) {
        fail(place + ": indices are whole numbers from 0");
      }
    }
  }

  void attributes(Json& primitive, const std::string& place) {
    const auto found = primitive.find("attributes");
    if (found == primitive.end() || !found->is_object() || !found->contains("POSITION")) {
      return fail(place + ": a primitive without positions");
    }
    Json kept = Json::object();
    for (const std::string_view key :
         {"POSITION", "NORMAL", "COLOR_0", "TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3",
          "TEXCOORD_4", "TEXCOORD_5", "TEXCOORD_6", "TEXCOORD_7"}) {
      const std::string name(key);
      if (!found->contains(name)) continue;
      const auto index = indexIn(*found, name.c_str(), "accessors", place);
      if (!index) return;
      const Accessor& accessor = accessors_[*index];
      const bool sound = key == "POSITION" || key == "NORMAL"
                             ? accessor.components == 3 && accessor.component == 5126
                         : key == "COLOR_0" ? accessor.components == 3 || accessor.components == 4
                                            : accessor.components == 2;
      if (!sound) return fail(fmt::format("{}: {} has the wrong type", place, key));
      kept[name] = *index;
      if (accessor.count != accessors_[kept["POSITION"].get<std::size_t>()].count) {
        return fail(fmt::format("{}: {} and POSITION differ in count", place, key));
      }
    }
    *found = std::move(kept);
  }

  void nodes() {
    std::vector<std::vector<std::size_t>> below(countOf("nodes"));
    std::vector<bool> has_parent(below.size(), false);
    std::size_t number_of = 0;
    each("nodes", [&](Json& node, const std::string& place) {
      for (const char* key : {"skin", "camera", "weights"}) node.erase(key);
      if (node.contains("mesh")) indexIn(node, "mesh", "meshes", place);
      for (const auto& [key, count] :
           {std::pair{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}) {
        if (node.contains(key)) numbers(node[key], static_cast<std::size_t>(count), place);
      }
      const std::size_t self = number_of++;
      if (!node.contains("children")) return;
      indices(node["children"], "nodes", place);
      if (!problem_.empty()) return;
      for (const Json& child : node["children"]) {
        below[self].push_back(child.get<std::size_t>());
        if (has_parent[below[self].back()]) fail(place + ": a child has two parents");
        has_parent[below[self].back()] = true;
      }
    });
    if (problem_.empty()) checkDepth(below, has_parent);
  }

  /// Each node has one parent, so a node that no walk from a root reaches is part of a cycle.
  void checkDepth(const std::vector<std::vector<std::size_t>>& below,
                  const std::vector<bool>& has_parent) {
    std::vector<std::size_t> level;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (!has_parent[i]) level.push_back(i);
    }
    for (std::size_t depth = 0; !level.empty(); ++depth) {
      if (depth >= kDeepestNodes) {
        return fail(fmt::format("nodes are nested deeper than {}", kDeepestNodes));
      }
      reached += level.size();
      std::vector<std::size_t> next;
      for (const std::size_t node : level) {
        next.insert(next.end(), below[node].begin(), below[node].end());
      }
      level = std::move(next);
    }
    if (reached < below.size()) fail("a node is its own descendant");
  }

  void numbers(const Json& list, std::size_t count, const std::string& place) {
    bool sound = list.is_array() && list.size() == count;
    for (std::size_t i = 0; sound && i < count; ++i) sound = list[i].is_number();
    if (!sound) fail(fmt::format("{}: a transform is not {} numbers", place, count));
  }

  Json& root_;
  ByteView binary_;
  std::vector<std::uint64_t> buffer_bytes_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::string problem_;
};

std::string judge(Json& root, ByteView binary) {
  if (!root.is_object()) return "is not a JSON object";
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string()) {
    return "is not glTF: it states no version";
  }
  if (!(*asset)["version"].get<std::string>().starts_with("2")) {
    return "is glTF " + (*asset)["version"].get<std::string>().substr(0, 10) + "; only 2 is read";
  }
  root["asset"] = {{"version", "2.0"}};
  if (const auto required = root.find("extensionsRequired"); required != root.end()) {
    if (!required->is_array()) return "`extensionsRequired` is not an array";
    for (const Json& name : *required) {
      if (name == "KHR_texture_transform") continue;
      const std::string text = name.is_string() ? name.get<std::string>().substr(0, 60) : "?";
      return "requires " + text + ", which is not read";
    }
  }
  for (const char* key : {"animations", "skins", "cameras", "extensions", "extras"}) {
    root.erase(key);
  }
  root.erase("extensionsRequired");
  root["extensionsUsed"] = Json::array({"KHR_texture_transform"});
  return GltfJudge(root, binary).problem();
}

}  // namespace

Result<Bytes> sanitizedGltf(ByteView bytes) {
  const Result<GltfParts> parts = gltfParts(bytes);
  if (!parts.ok()) return parts.error();
  Result<Json> parsed = parseJson<Json>(parts->text);
  if (!parsed.ok() && parsed.error().kind == ErrorKind::damaged) {
    return Error{ErrorKind::damaged, "is not valid JSON", {}};
  }
  if (!parsed.ok()) return parsed.error();
  Json& root = *parsed;
  if (std::string problem = judge(root, parts->binary); !problem.empty()) {
    return Error{ErrorKind::damaged, std::move(problem), {}};
  }
  const std::string kept = root.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!isGlb(bytes)) {
    const ByteView json = bytesOf(kept);
    return Bytes(json.begin(), json.end());
  }
  return glbOf({kept, parts->binary});
}

}  // namespace rocinante
