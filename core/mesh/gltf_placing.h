#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/math/vector.h"
#include "core/mesh/gltf_document.h"

namespace rocinante {

/// Where vertices go, and normals beside them.
struct GltfPlacing {
  Mat4 to_root{1.0};
  glm::dmat3 normal_turn{1.0};
  double volume = 1;  ///< negative: mirrored

  explicit GltfPlacing(const Mat4& matrix) : to_root(matrix) {
    const glm::dmat3 turn(matrix);
    volume = glm::determinant(turn);
    normal_turn = volume != 0 ? glm::transpose(glm::inverse(turn)) : turn;
  }
};

/// The joints of a skinned primitive (glTF 2.0, 3.7.3): how each vertex follows them.
struct GltfSkinning {
  const std::vector<Mat4>* joints = nullptr;  ///< to the root, from where they were modelled
  std::vector<std::pair<GltfAccessor, GltfAccessor>> sets;  ///< JOINTS_n and WEIGHTS_n

  /// Empty when the vertex follows no joint.
  std::optional<GltfPlacing> of(std::uint32_t vertex) const;
};

/// A node's own transform.
Mat4 matrixOfGltfNode(const GltfJson& node);
/// Translation, quaternion x y z w, scale.
Mat4 gltfPlacedBy(const std::array<double, 3>& at, const std::array<double, 4>& turn,
                  const std::array<double, 3>& scale);

/// The joints of a skin at rest: `places` are those of all nodes.
std::vector<Mat4> gltfJoints(const GltfDocument& document, const GltfJson& skin,
                             const std::vector<Mat4>& places);
/// `joints` null: the primitive follows none.
GltfSkinning gltfSkinning(const GltfDocument& document, const GltfJson& primitive,
                          const std::vector<Mat4>* joints);
std::optional<GltfAccessor> gltfAttribute(const GltfDocument& document, const GltfJson& primitive,
                                          const std::string& name);

}  // namespace rocinante
