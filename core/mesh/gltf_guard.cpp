#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <vector>

#include "core/mesh/gltf_document.h"

namespace rocinante {
namespace {

constexpr std::size_t kDeepestNodes = 100;           // nodes below nodes
constexpr std::uint64_t kMaxBufferBytes = 1U << 29;  // of one buffer

/// Elements of a sparse accessor without a bufferView: zeros that no byte of the file stands for.
constexpr std::uint64_t kMaxImpliedElements = 1U << 20;

/// Checks every index and length of the document against what it refers to. Keeps the first
/// problem.
class GltfJudge {
 public:
  GltfJudge(const GltfJson& root, std::size_t binary_bytes)
      : root_(root), binary_bytes_(binary_bytes) {}

  std::string problem() {
    buffers();
    each("bufferViews",
         [&](const GltfJson& view, const std::string& place) { bufferView(view, place); });
    each("accessors",
         [&](const GltfJson& accessor, const std::string& place) { check(accessor, place); });
    each("images", [&](const GltfJson& image, const std::string& place) {
      if (image.contains("bufferView")) indexIn(image, "bufferView", "bufferViews", place);
      requireText(image, "uri", place);
    });
    each("textures", [&](const GltfJson& texture, const std::string& place) {
      if (texture.contains("source")) indexIn(texture, "source", "images", place);
      if (texture.contains("sampler")) indexIn(texture, "sampler", "samplers", place);
    });
    each("samplers", [](const GltfJson&, const std::string&) {});
    each("materials",
         [&](const GltfJson& material, const std::string& place) { textures(material, place); });
    each("meshes", [&](const GltfJson& mesh, const std::string& place) { checkMesh(mesh, place); });
    each("skins", [&](const GltfJson& given, const std::string& place) { skin(given, place); });
    nodes();
    each("scenes", [&](const GltfJson& scene, const std::string& place) {
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
  std::uint64_t number(const GltfJson& object, const char* key, std::uint64_t fallback,
                       const std::string& place) {
    const auto found = object.find(key);
    if (found == object.end()) return fallback;
    if (found->is_number_unsigned() && found->get<std::uint64_t>() <= kMaxBufferBytes) {
      return found->get<std::uint64_t>();
    }
    fail(fmt::format("{}: `{}` is not a valid number", place, key));
    return fallback;
  }

  std::optional<std::size_t> indexIn(const GltfJson& object, const char* key, const char* array,
                                     const std::string& place) {
    const std::uint64_t index = number(object, key, kMaxBufferBytes, place);
    if (index < countOf(array)) return static_cast<std::size_t>(index);
    fail(fmt::format("{}: `{}` is not an index into the {} {}", place, key, countOf(array), array));
    return std::nullopt;
  }

  void indices(const GltfJson& list, const char* array, const std::string& place) {
    if (!list.is_array()) return fail(fmt::format("{}: `{}` is not an array", place, array));
    for (const GltfJson& index : list) {
      if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= countOf(array)) {
        return fail(fmt::format("{}: holds something that is not an index into the {} {}", place,
                                countOf(array), array));
      }
    }
  }

  void requireText(const GltfJson& object, const char* key, const std::string& place) {
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
      requireText((*found)[i], "name", place);
      judge((*found)[i], place);
    }
  }

  void buffers() {
    each("buffers", [&](const GltfJson& buffer, const std::string& place) {
      const std::uint64_t bytes = number(buffer, "byteLength", 0, place);
      requireText(buffer, "uri", place);
      buffer_bytes_.push_back(bytes);
      if (!buffer.contains("uri") && bytes > binary_bytes_) {
        fail(fmt::format("{}: says {} bytes, and the binary chunk has {}", place, bytes,
                         binary_bytes_));
      }
    });
  }

  void bufferView(const GltfJson& view, const std::string& place) {
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

  void check(const GltfJson& accessor, const std::string& place) {
    const std::uint64_t component = number(accessor, "componentType", 0, place);
    requireText(accessor, "type", place);
    const std::size_t components =
        problem_.empty() ? gltfComponentsOf(accessor.value("type", std::string())) : 0;
    const std::uint64_t count = number(accessor, "count", 0, place);
    const std::size_t bytes = gltfComponentBytes(component) * components;
    if (bytes == 0 || count == 0) return fail(place + ": has no type or no count");
    accessors_.push_back({count, component, components});
    if (accessor.contains("bufferView")) spans(accessor, count, bytes, place);
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end()) return;
    if (!sparse->is_object() || !sparse->contains("indices") || !sparse->contains("values") ||
        !(*sparse)["indices"].is_object() || !(*sparse)["values"].is_object()) {
      return fail(place + ": `sparse` lacks its parts");
    }
    const std::uint64_t changed = number(*sparse, "count", 0, place);
    const std::size_t index_bytes =
        gltfComponentBytes(number((*sparse)["indices"], "componentType", 0, place));
    if (changed == 0 || changed > count || index_bytes == 0) {
      return fail(place + ": `sparse` has no valid count or type");
    }
    if (!accessor.contains("bufferView") && count > kMaxImpliedElements) {
      return fail(fmt::format("{}: has {} elements without bytes, and {} are read", place, count,
                              kMaxImpliedElements));
    }
    spans((*sparse)["indices"], changed, index_bytes, place);
    spans((*sparse)["values"], changed, bytes, place);
  }

  void spans(const GltfJson& user, std::uint64_t count, std::size_t bytes,
             const std::string& place) {
    const auto view = indexIn(user, "bufferView", "bufferViews", place);
    const std::uint64_t offset = number(user, "byteOffset", 0, place);
    if (!view) return;
    const std::uint64_t stride = views_[*view].stride == 0 ? bytes : views_[*view].stride;
    if (stride < bytes || offset + stride * (count - 1) + bytes > views_[*view].bytes) {
      fail(place + ": goes past the end of its bufferView");
    }
  }

  void textures(const GltfJson& object, const std::string& place) {
    for (const auto& [key, value] : object.items()) {
      if (!value.is_object()) continue;
      if (key.ends_with("Texture")) {
        indexIn(value, "index", "textures", place);
        if (number(value, "texCoord", 0, place) > 7) fail(place + ": `texCoord` is above 7");
        transform(value, place);
      } else if (key == "pbrMetallicRoughness") {
        if (value.contains("baseColorFactor")) {
          numbers(value["baseColorFactor"], 4, "`baseColorFactor`", place);
        }
        textures(value, place);
      }
    }
    if (object.contains("emissiveFactor")) {
      numbers(object["emissiveFactor"], 3, "`emissiveFactor`", place);
    }
  }

  void transform(const GltfJson& texture, const std::string& place) {
    const GltfJson* const given = gltfExtension(texture, "KHR_texture_transform");
    if (given == nullptr) return;
    for (const char* key : {"offset", "scale"}) {
      if (given->contains(key)) numbers((*given)[key], 2, "a texture transform", place);
    }
    if (number(*given, "texCoord", 0, place) > 7) fail(place + ": `texCoord` is above 7");
  }

  void checkMesh(const GltfJson& mesh, const std::string& place) {
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) return fail(place + ": no primitives");
    for (const GltfJson& primitive : *primitives) {
      if (!primitive.is_object()) return fail(place + ": a primitive is not an object");
      if (primitive.contains("material")) indexIn(primitive, "material", "materials", place);
      if (number(primitive, "mode", 4, place) > 6) fail(place + ": an unknown kind of primitive");
      attributes(primitive, place);
      if (!problem_.empty() || !primitive.contains("indices")) continue;
      const auto index = indexIn(primitive, "indices", "accessors", place);
      if (index && (accessors_[*index].components != 1 || !isWholeFromZero(*index))) {
        fail(place + ": indices are whole numbers from 0");
      }
    }
  }

  bool isWholeFromZero(std::size_t accessor) const {
    const std::uint64_t type = accessors_[accessor].component;
    return type == 5121 || type == 5123 || type == 5125;
  }

  /// Of the types that core glTF and KHR_mesh_quantization allow, and a few more that can be read.
  void attributes(const GltfJson& primitive, const std::string& place) {
    const auto found = primitive.find("attributes");
    if (found == primitive.end() || !found->is_object() || !found->contains("POSITION")) {
      return fail(place + ": a primitive without positions");
    }
    const auto positions = indexIn(*found, "POSITION", "accessors", place);
    if (!positions) return;
    for (const auto& [key, value] : found->items()) {
      const bool is_places = key.starts_with("TEXCOORD_");
      const bool is_joints = key.starts_with("JOINTS_");
      const bool is_weights = key.starts_with("WEIGHTS_");
      const bool is_point = key == "POSITION" || key == "NORMAL";
      if (!is_places && !is_joints && !is_weights && !is_point && key != "COLOR_0") continue;
      const auto index = indexIn(*found, key.c_str(), "accessors", place);
      if (!index) return;
      const Accessor& accessor = accessors_[*index];
      const bool is_whole = accessor.component == 5125;
      const bool sound = is_point     ? accessor.components == 3 && !is_whole
                         : is_places  ? accessor.components == 2 && !is_whole
                         : is_joints  ? accessor.components == 4 && isWholeFromZero(*index)
                         : is_weights ? accessor.components == 4
                                      : accessor.components == 3 || accessor.components == 4;
      if (!sound) return fail(fmt::format("{}: {} has the wrong type", place, key));
      if (accessor.count != accessors_[*positions].count) {
        return fail(fmt::format("{}: {} and POSITION differ in count", place, key));
      }
    }
  }

  void nodes() {
    std::vector<std::vector<std::size_t>> below(countOf("nodes"));
    std::vector<bool> has_parent(below.size(), false);
    std::size_t number_of = 0;
    each("nodes", [&](const GltfJson& node, const std::string& place) {
      if (node.contains("mesh")) indexIn(node, "mesh", "meshes", place);
      for (const auto& [key, count] :
           {std::pair{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}) {
        if (node.contains(key)) {
          numbers(node[key], static_cast<std::size_t>(count), "a transform", place);
        }
      }
      if (node.contains("skin")) indexIn(node, "skin", "skins", place);
      instances(node, place);
      const std::size_t self = number_of++;
      if (!node.contains("children")) return;
      indices(node["children"], "nodes", place);
      if (!problem_.empty()) return;
      for (const GltfJson& child : node["children"]) {
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

  void instances(const GltfJson& node, const std::string& place) {
    const GltfJson* const instancing = gltfExtension(node, "EXT_mesh_gpu_instancing");
    if (instancing == nullptr) return;
    const auto given = instancing->find("attributes");
    if (given == instancing->end() || !given->is_object()) {
      return fail(place + ": instances without attributes");
    }
    std::optional<std::uint64_t> count;
    for (const auto& [key, components] :
         {std::pair{"TRANSLATION", 3U}, {"ROTATION", 4U}, {"SCALE", 3U}}) {
      if (!given->contains(key)) continue;
      const auto index = indexIn(*given, key, "accessors", place);
      if (!index) return;
      const Accessor& accessor = accessors_[*index];
      if (accessor.components != components || accessor.component == 5125) {
        return fail(fmt::format("{}: {} of the instances has the wrong type", place, key));
      }
      if (count.value_or(accessor.count) != accessor.count) {
        return fail(place + ": the attributes of the instances differ in count");
      }
      count = accessor.count;
    }
  }

  void skin(const GltfJson& skin, const std::string& place) {
    const auto joints = skin.find("joints");
    if (joints == skin.end()) return fail(place + ": has no joints");
    indices(*joints, "nodes", place);
    if (!problem_.empty() || !skin.contains("inverseBindMatrices")) return;
    const auto index = indexIn(skin, "inverseBindMatrices", "accessors", place);
    if (!index) return;
    const Accessor& accessor = accessors_[*index];
    if (accessor.components != 16 || accessor.component != 5126 ||
        accessor.count < joints->size()) {
      fail(place + ": `inverseBindMatrices` has the wrong type, or fewer than its joints");
    }
  }

  void numbers(const GltfJson& list, std::size_t count, const char* what,
               const std::string& place) {
    bool sound = list.is_array() && list.size() == count;
    for (std::size_t i = 0; sound && i < count; ++i) sound = list[i].is_number();
    if (!sound) fail(fmt::format("{}: {} is not {} numbers", place, what, count));
  }

  const GltfJson& root_;
  std::size_t binary_bytes_;
  std::vector<std::uint64_t> buffer_bytes_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::string problem_;
};

}  // namespace

std::string problemOfGltf(const GltfJson& root, std::size_t binary_bytes) {
  if (!root.is_object()) return "is not a JSON object";
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string()) {
    return "is not glTF: it states no version";
  }
  for (const char* key : {"version", "minVersion"}) {
    const auto found = asset->find(key);
    if (found == asset->end() || !found->is_string()) continue;
    const std::string version = found->get<std::string>().substr(0, 10);
    const bool is_read =
        std::string_view(key) == "version" ? version.starts_with("2") : version == "2.0";
    if (!is_read) return "is glTF " + version + "; only 2 is read";
  }
  if (const auto required = root.find("extensionsRequired"); required != root.end()) {
    if (!required->is_array()) return "`extensionsRequired` is not an array";
    for (const GltfJson& name : *required) {
      const std::string text = name.is_string() ? name.get<std::string>().substr(0, 60) : "?";
      if (!isGltfExtensionRead(text)) return "requires " + text + ", which is not read";
    }
  }
  return GltfJudge(root, binary_bytes).problem();
}

}  // namespace rocinante
