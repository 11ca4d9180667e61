#include "core/foreign/gltf/gltf_materials.h"

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
  Json texture;
  texture["sampler"] = 0;
  texture["source"] = images_.size() - 1;
  textures_.push_back(std::move(texture));
  known->second = std::make_unique<Image>(Image{textures_.size() - 1, pngHasAlpha(*bytes)});
  return known->second.get();
}

std::size_t GltfMaterials::add(const Material& material) {
  const auto known = std::find(known_.begin(), known_.end(), material);
  if (known != known_.end()) return static_cast<std::size_t>(known - known_.begin());
  const Image* const image = material.diffuse_map.empty() ? nullptr : imageOf(material);
  const double opacity = std::clamp(static_cast<double>(material.diffuse.a), 0.0, 1.0);
  Json surface;
  surface["baseColorFactor"] = linearColor(glm::vec3(material.diffuse));
  surface["baseColorFactor"].push_back(opacity);
  if (image != nullptr) surface["baseColorTexture"]["index"] = image->texture;
  surface["metallicFactor"] = 0;
  surface["roughnessFactor"] = roughnessOf(material);
  Json made;
  if (!material.name.empty()) made["name"] = material.name;
  made["pbrMetallicRoughness"] = std::move(surface);
  if (material.emission != glm::vec3(0.0F)) {
    made["emissiveFactor"] = linearColor(material.emission);
  }
  if (opacity < 1 || (image != nullptr && image->has_alpha)) made["alphaMode"] = "BLEND";
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
  // Linear, with mipmaps, repeating.
  Json sampler;
  sampler["magFilter"] = 9729;
  sampler["minFilter"] = 9987;
  sampler["wrapS"] = 10497;
  sampler["wrapT"] = 10497;
  document["samplers"] = Json::array();
  document["samplers"].push_back(std::move(sampler));
}

}  // namespace rocinante
