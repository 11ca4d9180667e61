#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/fault_list.h"
#include "core/mesh/gltf_document.h"
#include "core/mesh/mesh.h"

namespace rocinante {

/// Reads the materials of a glTF document: base colour and its texture with sampler and transform,
/// alpha mode, emission. Colours, which are linear, are encoded as sRGB. Borrows everything.
class GltfMaterialReader {
 public:
  GltfMaterialReader(const GltfDocument& document, const std::filesystem::path& path,
                     const ResolveFile& resolve, FaultList& faults)
      : document_(document), path_(path), resolve_(resolve), faults_(faults) {}

  /// In the order of the file.
  std::vector<Material> readAll();
  /// Of primitives that name none: white and opaque.
  static Material plain();

 private:
  Material read(const GltfJson& given);
  void readAlpha(const GltfJson& given, double opacity, Material& material);
  void readTexture(const GltfJson& info, Material& material);
  void readSampler(const GltfJson& sampler, Material& material);
  void useImage(std::size_t number, Material& material);
  std::shared_ptr<const Bytes> pictureIn(std::size_t view);
  void usePicture(std::size_t number, const GltfJson& image, Material& material);

  const GltfDocument& document_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  FaultList& faults_;
  /// Names and bytes of pictures inside the file, by image.
  std::map<std::size_t, std::pair<std::filesystem::path, std::shared_ptr<const Bytes>>> pictures_;
  std::map<std::size_t, std::shared_ptr<const Bytes>> by_view_;  ///< of those in buffers
  std::size_t copied_ = 0;  ///< bytes; views that overlap must not multiply a file
};

/// The attribute with the texture coordinates that a primitive's material uses: "TEXCOORD_0" when
/// it names none that is there.
std::string gltfTextureAttribute(const GltfDocument& document, const GltfJson& primitive);
/// A display value of a linear one.
float gltfShown(double linear);

}  // namespace rocinante
