#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

#include "core/base/json_read.h"
#include "core/math/transform.h"
#include "core/mesh/gltf_document.h"
#include "core/mesh/gltf_materials.h"
#include "core/mesh/gltf_primitive.h"

namespace rocinante {
namespace {

using Keys = std::initializer_list<std::string_view>;

/// Why a property of glTF 2.0 that we know is not used; empty: not known.
std::string_view reasonOfProperty(std::string_view key) {
  struct Reason {
    std::string_view key, reason;
  };
  static constexpr Reason kReasons[] = {
      {"weights", "morph targets are not drawn"},
      {"targets", "morph targets are not drawn"},
      {"camera", "cameras are not used"},
      {"metallicFactor", "metal is drawn as paint of its base colour"},
      {"roughnessFactor", "surfaces are drawn without gloss"},
      {"normalTexture", "normal maps are not drawn"},
      {"occlusionTexture", "occlusion maps are not drawn"},
      {"emissiveTexture", "emission with a map is not drawn"},
      {"metallicRoughnessTexture", "maps of metal and roughness are not drawn"},
      {"magFilter", "textures are filtered linearly"},
      {"minFilter", "textures are filtered linearly"},
  };
  const auto found = std::ranges::find(kReasons, key, &Reason::key);
  return found == std::end(kReasons) ? std::string_view() : found->reason;
}

std::string_view reasonOfExtension(std::string_view name) {
  struct Reason {
    std::string_view start, reason;
  };
  static constexpr Reason kReasons[] = {
      {"KHR_lights_", "lights are the cell's"},
      {"KHR_materials_unlit", "surfaces are lit like others"},
      {"KHR_materials_pbrSpecularGlossiness", "its colours and maps are not read"},
      {"KHR_materials_variants", "the first look is drawn"},
      {"KHR_materials_", "it is not drawn"},
      {"KHR_draco_", "what is compressed is not read"},
      {"EXT_meshopt_", "what is compressed is not read"},
      {"KHR_texture_basisu", "KTX2 images are not read"},
      {"EXT_texture_", "its image is not read"},
  };
  const auto found = std::ranges::find_if(
      kReasons, [&](const Reason& one) { return name.starts_with(one.start); });
  return found == std::end(kReasons) ? std::string_view("it is not read") : found->reason;
}

/// What somebody will miss in the picture.
Severity severityOf(std::string_view name) {
  static constexpr std::string_view kMissed[] = {"KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_draco_", "EXT_meshopt_", "targets"};
  const bool is_missed = std::ranges::any_of(
      kMissed, [&](std::string_view missed) { return name.starts_with(missed); });
  return is_missed ? Severity::warning : Severity::note;
}

class GltfAccount {
 public:
  GltfAccount(const GltfDocument& document, const std::vector<bool>& is_drawn, FaultList& faults)
      : document_(document), is_drawn_(is_drawn), faults_(faults) {}

  void nameAll() {
    nameRoot();
    const GltfJson& root = document_.root;
    name(root["asset"], "asset", {"version", "minVersion", "generator", "copyright"});
    each("scenes", {"nodes"});
    each("nodes", {"mesh", "skin", "children", "matrix", "translation", "rotation", "scale"});
    each("meshes", {"primitives"});
    each("materials",
         {"pbrMetallicRoughness", "emissiveFactor", "alphaMode", "alphaCutoff", "doubleSided"});
    each("textures", {"sampler", "source"});
    each("samplers", {"wrapS", "wrapT", "magFilter", "minFilter"});
    each("images", {"uri", "bufferView", "mimeType"});
    each("skins", {"joints", "inverseBindMatrices", "skeleton"});
    each("accessors", {"bufferView", "byteOffset", "componentType", "normalized", "count", "type",
                       "min", "max", "sparse"});
    each("bufferViews", {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
    each("buffers", {"byteLength", "uri"});
    nameSparse();
    nameNodes();
    nameMeshes();
    nameMaterials();
    nameSamplers();
    nameScenes();
    for (const GltfJson& used : document_.all("extensionsUsed")) {
      if (!used.is_string()) continue;
      const auto& extension = used.get_ref<const std::string&>();
      if (!isGltfExtensionRead(extension) && !met_.contains(extension)) {
        leaveOut("extension", extension, "extensionsUsed", reasonOfExtension(extension));
      }
    }
  }

 private:
  void leaveOut(std::string_view kind, std::string_view what, std::string_view place,
                std::string_view reason) {
    leaveOut(kind, what, place, reason, severityOf(what));
  }
  void leaveOut(std::string_view kind, std::string_view what, std::string_view place,
                std::string_view reason, Severity severity) {
    faults_.leaveOut(kind, what, {}, fmt::format("{}: {}", place, reason), severity);
  }

  /// Every key that is not in `used`, and every extension that is not read here.
  void name(const GltfJson& object, const std::string& place, Keys used,
            std::string_view read_extension = {}) {
    if (!object.is_object()) return;
    for (const auto& [key, value] : object.items()) {
      if (key == "extras" || key == "name") continue;
      if (key == "extensions") {
        if (value.is_object()) nameExtensions(value, place, read_extension);
        continue;
      }
      if (std::ranges::find(used, std::string_view(key)) != used.end()) continue;
      const std::string_view reason = reasonOfProperty(key);
      leaveOut("field", key, place, reason.empty() ? "it is not known" : reason);
    }
  }

  void nameExtensions(const GltfJson& extensions, const std::string& place,
                      std::string_view read_extension) {
    for (const auto& [extension, value] : extensions.items()) {
      if (extension == read_extension && value.is_object()) continue;
      met_.insert(extension);
      leaveOut("extension", extension, place, reasonOfExtension(extension));
    }
  }

  void each(const char* array, Keys used) {
    const GltfJson& all = document_.all(array);
    const std::string_view read =
        std::string_view(array) == "nodes" ? "EXT_mesh_gpu_instancing" : "";
    for (std::size_t i = 0; i < all.size(); ++i) {
      name(all[i], fmt::format("{}[{}]", array, i), used, read);
    }
  }

  void nameRoot() {
    const GltfJson& root = document_.root;
    name(root, "the file",
         {"asset", "scene", "scenes", "nodes", "meshes", "materials", "textures", "images",
          "samplers", "skins", "accessors", "bufferViews", "buffers", "animations", "cameras",
          "extensionsUsed", "extensionsRequired"});
    for (const auto& [array, kind, reason] :
         {std::tuple{"animations", "animation", "animations are not played"},
          {"cameras", "camera", "cameras are not used"}}) {
      const auto found = root.find(array);
      if (found == root.end()) continue;
      for (std::size_t i = 0; i < found->size(); ++i) {
        leaveOut(kind, "", fmt::format("{}[{}]", array, i), reason);
      }
    }
  }

  void nameSparse() {
    const GltfJson& accessors = document_.all("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      const auto sparse = accessors[i].find("sparse");
      if (sparse == accessors[i].end()) continue;
      const std::string place = fmt::format("accessors[{}]", i);
      name(*sparse, place, {"count", "indices", "values"});
      name((*sparse)["indices"], place, {"bufferView", "byteOffset", "componentType"});
      name((*sparse)["values"], place, {"bufferView", "byteOffset"});
    }
  }

  void nameRotation(const GltfJson& node, const std::string& place) {
    const auto q = node.find("rotation");
    if (q == node.end() || node.contains("matrix")) return;
    const auto part = [&](std::size_t i) { return (*q)[i].get<double>(); };
    const double length = lengthOf(Quat(part(3), part(0), part(1), part(2)));
    if (std::abs(length - 1) <= kUnitLengthTolerance) return;
    leaveOut("length", "rotation", place,
             length > 0 ? "it is off 1 by more than 0.001, and the quaternion is normalised"
                        : "it is 0, which is no rotation",
             Severity::warning);
  }

  void nameNodes() {
    const GltfJson& nodes = document_.all("nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::string place = fmt::format("nodes[{}]", i);
      if (!is_drawn_[i] && nodes[i].contains("mesh")) {
        leaveOut("node", textIn(nodes[i], "name"), place, "it is not in the scene that is drawn");
      }
      nameRotation(nodes[i], place);
      const bool has_skin = nodes[i].contains("skin");
      if (has_skin && !nodes[i].contains("mesh")) {
        leaveOut("field", "skin", place, "the node has no mesh");
      }
      const GltfJson* const instances = gltfExtension(nodes[i], "EXT_mesh_gpu_instancing");
      if (instances == nullptr) continue;
      if (has_skin || !nodes[i].contains("mesh")) {
        leaveOut("extension", "EXT_mesh_gpu_instancing", place,
                 has_skin ? "a skinned mesh is drawn once" : "the node has no mesh");
      }
      name(*instances, place, {"attributes"});
      for (const auto& [key, value] : (*instances)["attributes"].items()) {
        if (key == "TRANSLATION" || key == "ROTATION" || key == "SCALE") continue;
        leaveOut("attribute", key, place, "instances have no attributes but their place");
      }
    }
  }

  void nameMeshes() {
    const GltfJson& meshes = document_.all("meshes");
    std::vector<bool> is_shown(meshes.size(), false);
    for (const GltfJson& node : document_.all("nodes")) {
      if (const auto mesh = gltfIndex(node, "mesh")) is_shown[*mesh] = true;
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const std::string place = fmt::format("meshes[{}]", i);
      if (!is_shown[i]) leaveOut("shape", textIn(meshes[i], "name"), place, "no node shows it");
      for (const GltfJson& primitive : meshes[i]["primitives"]) namePrimitive(primitive, place);
    }
  }

  void namePrimitive(const GltfJson& primitive, const std::string& place) {
    name(primitive, place, {"attributes", "indices", "material", "mode"});
    const std::string_view flat = gltfFlatKind(primitive);
    const std::size_t positions = *gltfIndex(primitive["attributes"], "POSITION");
    if (!flat.empty()) {
      leaveOut("primitive", flat, place, "only triangles are drawn", Severity::warning);
    } else if (!GltfAccessor(document_, positions).hasBytes()) {
      leaveOut("primitive", "", place, "its vertices are compressed, or not in the file",
               Severity::warning);
    }
    const std::string texture_set = gltfTextureAttribute(document_, primitive);
    for (const auto& [key, value] : primitive["attributes"].items()) {
      const bool is_joint = key.starts_with("JOINTS_") || key.starts_with("WEIGHTS_");
      if (key == "POSITION" || key == "NORMAL" || key == "COLOR_0" || key == texture_set ||
          is_joint) {
        continue;
      }
      leaveOut("attribute", key, place,
               key.starts_with("TEXCOORD_") ? "the material's texture uses another set"
               : key == "TANGENT"           ? "normal maps are not drawn"
                                            : "it is not drawn");
    }
  }

  void nameMaterials() {
    const GltfJson& materials = document_.all("materials");
    for (std::size_t i = 0; i < materials.size(); ++i) {
      const std::string place = fmt::format("materials[{}]", i);
      const auto surface = materials[i].find("pbrMetallicRoughness");
      if (surface == materials[i].end() || !surface->is_object()) continue;
      // These are as surfaces are drawn.
      const bool is_paint = numberIn<double>(*surface, "metallicFactor", 0) == 0;
      const bool is_rough = numberIn<double>(*surface, "roughnessFactor", 1) == 1;
      name(*surface, place,
           {"baseColorFactor", "baseColorTexture", is_paint ? "metallicFactor" : "",
            is_rough ? "roughnessFactor" : ""});
      const auto texture = surface->find("baseColorTexture");
      if (texture == surface->end()) continue;
      name(*texture, place, {"index", "texCoord"}, "KHR_texture_transform");
      const GltfJson* const placed = gltfExtension(*texture, "KHR_texture_transform");
      if (placed != nullptr) name(*placed, place, {"offset", "rotation", "scale", "texCoord"});
    }
  }

  void nameSamplers() {
    const GltfJson& samplers = document_.all("samplers");
    for (std::size_t i = 0; i < samplers.size(); ++i) {
      for (const char* key : {"magFilter", "minFilter"}) {
        const std::size_t filter = gltfIndex(samplers[i], key).value_or(9729);
        const bool is_linear = filter == 9729 || filter == 9985 || filter == 9987;
        if (is_linear) continue;
        leaveOut("field", key, fmt::format("samplers[{}]", i), reasonOfProperty(key));
      }
    }
  }

  void nameScenes() {
    const GltfJson& scenes = document_.all("scenes");
    const std::size_t drawn = gltfIndex(document_.root, "scene").value_or(0);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const bool is_empty = !scenes[i].contains("nodes") || scenes[i]["nodes"].empty();
      if (i == drawn || is_empty) continue;
      leaveOut("scene", textIn(scenes[i], "name"), fmt::format("scenes[{}]", i),
               "one scene of a file is drawn");
    }
  }

  const GltfDocument& document_;
  const std::vector<bool>& is_drawn_;
  FaultList& faults_;
  std::set<std::string, std::less<>> met_;  // extensions that were named
};

}  // namespace

void nameWhatGltfLeavesOut(const GltfDocument& document, const std::vector<bool>& is_drawn,
                           FaultList& faults) {
  GltfAccount(document, is_drawn, faults).nameAll();
}

}  // namespace rocinante
