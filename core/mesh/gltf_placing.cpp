#include "core/mesh/gltf_placing.h"

#include <fmt/format.h>

#include <cmath>

#include "core/math/transform.h"

namespace rocinante {
namespace {

template <std::size_t N>
std::array<double, N> numbersOf(const GltfJson& object, const char* key,
                                const std::array<double, N>& otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) numbers[i] = (*found)[i].template get<double>();
  return numbers;
}

}  // namespace

Mat4 gltfPlacedBy(const std::array<double, 3>& at, const std::array<double, 4>& turn,
                  const std::array<double, 3>& scale) {
  const Quat rotation =
      normalized(Quat(turn[3], turn[0], turn[1], turn[2])).value_or(Quat(1, 0, 0, 0));
  return translationMatrix({at[0], at[1], at[2]}) * rotationMatrix(rotation) *
         scaleMatrix({scale[0], scale[1], scale[2]});
}

Mat4 matrixOfGltfNode(const GltfJson& node) {
  if (node.contains("matrix")) {
    const auto m = numbersOf<16>(node, "matrix", {});
    return Mat4(Vec4(m[0], m[1], m[2], m[3]), Vec4(m[4], m[5], m[6], m[7]),
                Vec4(m[8], m[9], m[10], m[11]), Vec4(m[12], m[13], m[14], m[15]));
  }
  return gltfPlacedBy(numbersOf<3>(node, "translation", {0, 0, 0}),
                      numbersOf<4>(node, "rotation", {0, 0, 0, 1}),
                      numbersOf<3>(node, "scale", {1, 1, 1}));
}

std::optional<GltfPlacing> GltfSkinning::of(std::uint32_t vertex) const {
  Mat4 sum(0.0);
  double whole = 0;
  for (const auto& [numbers, weights] : sets) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double weight = weights.number(vertex, i);
      const std::uint32_t joint = numbers.index(vertex, i);
      if (!(weight > 0) || joint >= joints->size()) continue;
      sum += (*joints)[joint] * weight;
      whole += weight;
    }
  }
  if (!(whole > 0) || !std::isfinite(whole)) return std::nullopt;
  return GltfPlacing(sum * (1 / whole));
}

std::vector<Mat4> gltfJoints(const GltfDocument& document, const GltfJson& skin,
                             const std::vector<Mat4>& places) {
  std::optional<GltfAccessor> binds;
  if (const auto given = gltfIndex(skin, "inverseBindMatrices")) binds.emplace(document, *given);
  std::vector<Mat4> joints;
  for (std::size_t i = 0; i < skin["joints"].size(); ++i) {
    Mat4 bind(1.0);
    for (std::size_t k = 0; binds && k < 16; ++k) {
      bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = binds->number(i, k);
    }
    joints.push_back(places[skin["joints"][i].get<std::size_t>()] * bind);
  }
  return joints;
}

std::optional<GltfAccessor> gltfAttribute(const GltfDocument& document, const GltfJson& primitive,
                                          const std::string& name) {
  const auto accessor = gltfIndex(primitive["attributes"], name.c_str());
  return accessor ? std::optional(GltfAccessor(document, *accessor)) : std::nullopt;
}

GltfSkinning gltfSkinning(const GltfDocument& document, const GltfJson& primitive,
                          const std::vector<Mat4>* joints) {
  GltfSkinning skinning;
  if (joints == nullptr) return skinning;
  skinning.joints = joints;
  for (int set = 0;; ++set) {
    const auto numbers = gltfAttribute(document, primitive, fmt::format("JOINTS_{}", set));
    const auto weights = gltfAttribute(document, primitive, fmt::format("WEIGHTS_{}", set));
    if (!numbers || !weights) return skinning;
    skinning.sets.emplace_back(*numbers, *weights);
  }
}

}  // namespace rocinante
