#include "recorder/gltf/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/math/srgb.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxImageBytes = std::uint64_t{1} << 28;

const char* mediaTypeOf(ByteView image) {
  const std::string_view text = textOf(image);
  if (text.starts_with("\x89PNG\r\n\x1A\n")) return "image/png";
  if (text.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  return nullptr;
}

/// Whether a PNG has an alpha channel or transparent colours (ISO/IEC 15948, 11.2.2 and 11.3.2.1).
bool pngHasAlpha(ByteView image) {
  constexpr std::size_t kColorType = 25;
  const std::string_view text = textOf(image);
  if (text.size() <= kColorType || !text.starts_with("\x89PNG")) return false;
  if ((static_cast<unsigned char>(text[kColorType]) & 4U) != 0) return true;
  const std::size_t pixels = text.find("IDAT");
  return text.substr(0, pixels).find("tRNS") != std::string_view::npos;
}

int numberOfWrap(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::mirrored_repeat:
      return 33648;
    case TextureWrap::clamp_to_edge:
      return 33071;
    default:
      return 10497;
  }
}

/// Beckmann's roughness of Phong's exponent, as glTF squares it.
double roughnessOf(const Material& material) {
  const glm::vec3& specular = material.specular;
  const bool is_glossy =
      material.shininess > 0 && std::max({specular.r, specular.g, specular.b}) > 0;
  if (!is_glossy) return 1;
  return std::sqrt(std::sqrt(2.0 / (static_cast<double>(material.shininess) + 2.0)));
}

Json linearColor(const glm::vec3& shown) {
  Json color = Json::array();
  for (int i = 0; i < 3; ++i) color.push_back(linearOfSrgb(static_cast<double>(shown[i])));
  return color;
}

}  // namespace

double linearOfSrgb(double shown) {
  if (!(shown > 0)) return 0;
  if (shown >= 1) return 1;
  double below = 0, above = 1;
  // Halving 52 times leaves what a double tells apart.
  for (int i = 0; i < 52; ++i) {
    const double middle = (below + above) / 2;
    (srgbOfLinear(middle) < shown ? below : above) = middle;
  }
  return (below + above) / 2;
}

const GltfMaterials::Image* GltfMaterials::imageOf(const Material& material) {
  const std::string name = material.diffuse_map.string();
  const auto [known, is_new] = image_by_name_.try_emplace(name);
  if (!is_new) return known->second.get();
  std::shared_ptr<const Bytes> bytes = material.diffuse_bytes;
  if (!bytes) {
    const Result<std::string> read = readFile(material.diffuse_map, kMaxImageBytes);
    if (!read) {
      gaps_.push_back(fmt::format("the image {} is left out: {}", name, read.error().what));
      return nullptr;
    }
    const ByteView content = bytesOf(*read);
    bytes = std::make_shared<const Bytes>(content.begin(), content.end());
  }
  const char* const type = mediaTypeOf(*bytes);
  if (type == nullptr) {
    gaps_.push_back(fmt::format("the image {} is left out: glTF has PNG and JPEG", name));
    return nullptr;
  }
  const std::size_t view = binary_.addView(bytes->size(), GltfBinary::Target::none, 0,
                                           [bytes](const UseBytes& use) { return use(*bytes); });
  Json image;
  image["name"] = material.diffuse_map.filename().string();
  image["mimeType"] = type;
  image["bufferView"] = view;
  images_.push_back(std::move(image));
  known->second = std::make_unique<Image>(Image{images_.size() - 1, pngHasAlpha(*bytes)});
  return known->second.get();
}

std::size_t GltfMaterials::textureOf(std::size_t image, const Material& material) {
  const std::size_t sampler = samplerOf({material.wrap_u, material.wrap_v});
  const auto [known, is_new] =
      textures_by_use_.try_emplace({image, sampler}, textures_by_use_.size());
  if (is_new) {
    Json texture;
    texture["sampler"] = sampler;
    texture["source"] = image;
    textures_.push_back(std::move(texture));
  }
  return known->second;
}

std::size_t GltfMaterials::samplerOf(const Wrap& wrap) {
  const auto [known, is_new] = samplers_by_wrap_.try_emplace(wrap, samplers_by_wrap_.size());
  if (is_new) {
    // Linear, with mipmaps.
    Json sampler;
    sampler["magFilter"] = 9729;
    sampler["minFilter"] = 9987;
    sampler["wrapS"] = numberOfWrap(wrap.first);
    sampler["wrapT"] = numberOfWrap(wrap.second);
    samplers_.push_back(std::move(sampler));
  }
  return known->second;
}

std::size_t GltfMaterials::add(const Material& material) {
  const auto known = std::find(known_.begin(), known_.end(), material);
  if (known != known_.end()) return static_cast<std::size_t>(known - known_.begin());
  const Image* const image = material.diffuse_map.empty() ? nullptr : imageOf(material);
  const bool is_opaque = material.alpha_mode == AlphaMode::opaque;
  const double opacity =
      is_opaque ? 1.0 : std::clamp(static_cast<double>(material.diffuse.a), 0.0, 1.0);
  Json surface;
  surface["baseColorFactor"] = linearColor(glm::vec3(material.diffuse));
  surface["baseColorFactor"].push_back(opacity);
  if (image != nullptr) {
    surface["baseColorTexture"]["index"] = textureOf(image->number, material);
  }
  surface["metallicFactor"] = 0;
  surface["roughnessFactor"] = roughnessOf(material);
  Json made;
  if (!material.name.empty()) made["name"] = material.name;
  made["pbrMetallicRoughness"] = std::move(surface);
  if (material.emission != glm::vec3(0.0F)) {
    made["emissiveFactor"] = linearColor(material.emission);
  }
  if (material.alpha_mode == AlphaMode::mask) {
    made["alphaMode"] = "MASK";
    made["alphaCutoff"] = std::max(static_cast<double>(material.alpha_cutoff), 0.0);
  } else if (opacity < 1 || (!is_opaque && image != nullptr && image->has_alpha)) {
    made["alphaMode"] = "BLEND";
  }
  made["doubleSided"] = true;
  materials_.push_back(std::move(made));
  known_.push_back(material);
  has_image_.push_back(image != nullptr);
  return known_.size() - 1;
}

void GltfMaterials::describe(Json& document) const {
  if (!materials_.empty()) document["materials"] = materials_;
  if (images_.empty()) return;
  document["textures"] = textures_;
  document["images"] = images_;
  document["samplers"] = samplers_;
}

}  // namespace rocinante
