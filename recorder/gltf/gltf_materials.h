#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/report/json_text.h"
#include "recorder/gltf/gltf_binary.h"

namespace rocinante {

/// The linear light of a display value in [0, 1], which srgbOfLinear() turns back into it.
double linearOfSrgb(double shown);

/// Materials and textures of a glTF document. Colours become linear light, gloss becomes roughness,
/// both sides are drawn. Images are taken as they are: PNG and JPEG; a surface with another image,
/// or one that cannot be read, has its colour alone, and a gap says so.
class GltfMaterials {
 public:
  explicit GltfMaterials(GltfBinary& binary) : binary_(binary) {}

  /// Answers the material's number; equal ones share it.
  std::size_t add(const Material& material);
  /// Whether the material of this number has an image.
  bool hasImage(std::size_t number) const { return has_image_[number]; }

  void describe(Json& document) const;
  const std::vector<std::string>& gaps() const { return gaps_; }

 private:
  struct Image {
    std::size_t number = 0;
    bool has_alpha = false;
  };
  using Wrap = std::pair<TextureWrap, TextureWrap>;
  /// Null when it is left out.
  const Image* imageOf(const Material& material);
  /// The number of the texture that shows the image with the material's wrap.
  std::size_t textureOf(std::size_t image, const Material& material);
  std::size_t samplerOf(const Wrap& wrap);

  GltfBinary& binary_;
  std::vector<Material> known_;
  std::vector<bool> has_image_;
  std::map<std::string, std::unique_ptr<Image>> image_by_name_;
  Json materials_ = Json::array();
  std::map<Wrap, std::size_t> samplers_by_wrap_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> textures_by_use_;  // image, sampler
  Json samplers_ = Json::array();
  Json textures_ = Json::array();
  Json images_ = Json::array();
  std::vector<std::string> gaps_;
};

}  // namespace rocinante
