#include "core/mesh/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/json_read.h"
#include "core/math/srgb.h"
#include "core/math/trigonometry.h"
#include "core/mesh/mtl_reader.h"

namespace rocinante {
namespace {

const GltfJson* baseTextureOf(const GltfJson& material) {
  const auto surface = material.find("pbrMetallicRoughness");
  if (surface == material.end() || !surface->is_object()) return nullptr;
  const auto texture = surface->find("baseColorTexture");
  return texture == surface->end() || !texture->is_object() ? nullptr : &*texture;
}

double elementOf(const GltfJson& object, const char* key, std::size_t element, double otherwise) {
  const auto found = object.find(key);
  return found == object.end() ? otherwise : (*found)[element].get<double>();
}

/// A float that shaders can use.
float finiteOr(double value, float otherwise) {
  const auto single = static_cast<float>(value);
  return std::isfinite(single) ? single : otherwise;
}

}  // namespace

float gltfShown(double linear) {
  const float component = static_cast<float>(linear);
  if (!std::isfinite(component)) return 0;
  return static_cast<float>(srgbOfLinear(static_cast<double>(std::clamp(component, 0.0F, 1.0F))));
}

std::string gltfTextureAttribute(const GltfDocument& document, const GltfJson& primitive) {
  const auto material = gltfIndex(primitive, "material");
  const GltfJson* const texture =
      material ? baseTextureOf(document.all("materials")[*material]) : nullptr;
  if (texture == nullptr) return "TEXCOORD_0";
  const GltfJson* const placed = gltfExtension(*texture, "KHR_texture_transform");
  const auto own = gltfIndex(*texture, "texCoord");
  const auto other = placed != nullptr ? gltfIndex(*placed, "texCoord") : std::nullopt;
  std::string name = fmt::format("TEXCOORD_{}", other.value_or(own.value_or(0)));
  return primitive["attributes"].contains(name) ? name : "TEXCOORD_0";
}

Material GltfMaterialReader::plain() {
  Material material;
  material.diffuse = glm::vec4(1.0F);
  material.alpha_mode = AlphaMode::opaque;
  return material;
}

std::vector<Material> GltfMaterialReader::readAll() {
  std::vector<Material> materials;
  for (const GltfJson& given : document_.all("materials")) materials.push_back(read(given));
  return materials;
}

Material GltfMaterialReader::read(const GltfJson& given) {
  Material material = plain();
  material.name = textIn(given, "name");
  double opacity = 1;
  const auto surface = given.find("pbrMetallicRoughness");
  if (surface != given.end() && surface->is_object()) {
    for (int i = 0; i < 3; ++i) {
      material.diffuse[i] =
          gltfShown(elementOf(*surface, "baseColorFactor", static_cast<std::size_t>(i), 1));
    }
    opacity = elementOf(*surface, "baseColorFactor", 3, 1);
  }
  readAlpha(given, opacity, material);
  // An emission with a texture would light the whole surface without it.
  if (!given.contains("emissiveTexture")) {
    for (int i = 0; i < 3; ++i) {
      material.emission[i] =
          gltfShown(elementOf(given, "emissiveFactor", static_cast<std::size_t>(i), 0));
    }
  }
  if (const GltfJson* const texture = baseTextureOf(given)) readTexture(*texture, material);
  return material;
}

void GltfMaterialReader::readAlpha(const GltfJson& given, double opacity, Material& material) {
  const auto found = given.find("alphaMode");
  const std::string mode = found == given.end() ? "OPAQUE"
                           : found->is_string() ? found->get<std::string>()
                                                : "?";
  if (mode == "BLEND") {
    material.alpha_mode = AlphaMode::blend;
  } else if (mode == "MASK") {
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = finiteOr(numberIn<double>(given, "alphaCutoff", 0.5), 1e30F);
  } else if (mode != "OPAQUE") {
    faults_.leaveOut(
        "value", mode, {},
        "no known `alphaMode`: material " + quotedInFault(material.name) + " is drawn opaque",
        Severity::warning);
  }
  if (material.alpha_mode == AlphaMode::opaque) return;
  material.diffuse.a = static_cast<float>(opacity > 0 ? std::min(opacity, 1.0) : 0.0);
}

void GltfMaterialReader::readTexture(const GltfJson& info, Material& material) {
  const GltfJson& texture = document_.all("textures")[*gltfIndex(info, "index")];
  if (const auto sampler = gltfIndex(texture, "sampler")) {
    readSampler(document_.all("samplers")[*sampler], material);
  }
  if (const GltfJson* const placed = gltfExtension(info, "KHR_texture_transform")) {
    const double width = elementOf(*placed, "scale", 0, 1);
    const double height = elementOf(*placed, "scale", 1, 1);
    const double x = elementOf(*placed, "offset", 0, 0), y = elementOf(*placed, "offset", 1, 0);
    const double angle = numberIn<double>(*placed, "rotation", 0);
    // Around the picture's top left corner with v down; ours is around the bottom left, v up.
    const SineCosine turn = sineCosine(angle);
    material.map_scale = {finiteOr(width, 1), finiteOr(height, 1)};
    material.map_rotation = finiteOr(angle, 0);
    material.map_offset = {finiteOr(x + turn.sine * height, 0),
                           finiteOr(1 - y - turn.cosine * height, 0)};
  }
  if (const auto source = gltfIndex(texture, "source")) {
    useImage(*source, material);
  } else {
    material.missing_map = kUnreadImage;
    faults_.warning("mesh.missing-texture", {},
                    fmt::format("the texture of material {} has only an image of an extension",
                                quotedInFault(material.name)),
                    "export it with PNG or JPEG images");
  }
}

void GltfMaterialReader::readSampler(const GltfJson& sampler, Material& material) {
  const auto wrapOf = [&](const char* key) {
    const std::size_t wrap = gltfIndex(sampler, key).value_or(10497);
    if (wrap == 33071) return TextureWrap::clamp_to_edge;
    if (wrap == 33648) return TextureWrap::mirrored_repeat;
    if (wrap != 10497) {
      faults_.leaveOut("value", std::to_string(wrap), {},
                       fmt::format("no known `{}`: the picture repeats", key), Severity::warning);
    }
    return TextureWrap::repeat;
  };
  material.wrap_u = wrapOf("wrapS");
  material.wrap_v = wrapOf("wrapT");
}

void GltfMaterialReader::useImage(std::size_t number, Material& material) {
  const GltfJson& image = document_.all("images")[number];
  const auto uri = image.find("uri");
  if (uri == image.end() || isDataUri(uri->get_ref<const std::string&>())) {
    usePicture(number, image, material);
    return;
  }
  const auto& name = uri->get_ref<const std::string&>();
  const std::string plain_name = fileNameOfUri(name);
  const bool is_plain = !textureFile(resolve_, plain_name, path_.parent_path()).path.empty();
  const bool is_raw = !is_plain && !textureFile(resolve_, name, path_.parent_path()).path.empty();
  useTexture(resolve_, is_raw ? name : plain_name, path_.parent_path(), "mesh.missing-texture", {},
             faults_, material);
}

std::shared_ptr<const Bytes> GltfMaterialReader::pictureIn(std::size_t view) {
  std::shared_ptr<const Bytes>& known = by_view_[view];
  if (known) return known;
  const GltfJson& run = document_.all("bufferViews")[view];
  const ByteView buffer = document_.buffers[*gltfIndex(run, "buffer")];
  const ByteView content = buffer.subspan(gltfIndex(run, "byteOffset").value_or(0),
                                          gltfIndex(run, "byteLength").value_or(0));
  std::size_t all = 0;
  for (const ByteView each : document_.buffers) all += each.size();
  if (content.size() > all - copied_) return nullptr;
  copied_ += content.size();
  return known = std::make_shared<const Bytes>(content.begin(), content.end());
}

void GltfMaterialReader::usePicture(std::size_t number, const GltfJson& image, Material& material) {
  auto [known, is_new] = pictures_.try_emplace(number);
  auto& [name, bytes] = known->second;
  if (is_new) {
    name = path_;
    name += fmt::format("#{}", pictures_.size());
    if (const auto view = gltfIndex(image, "bufferView")) {
      bytes = pictureIn(*view);
    } else if (image.contains("uri")) {
      std::optional<Bytes> content = bytesOfDataUri(image["uri"].get_ref<const std::string&>());
      if (content) bytes = std::make_shared<const Bytes>(std::move(*content));
    }
  }
  if (bytes && !bytes->empty()) {
    material.diffuse_map = name;
    material.diffuse_bytes = bytes;
    return;
  }
  faults_.warning("mesh.missing-texture", {},
                  fmt::format("the picture inside the file for material {} is empty",
                              quotedInFault(material.name)));
}

}  // namespace rocinante
