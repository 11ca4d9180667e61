#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/math/vector.h"

namespace rocinante {

/// What the opacity of a surface means (glTF 2.0, 3.9.4).
enum class AlphaMode : std::uint8_t {
  blend,   ///< drawn over what lies behind it; also what OBJ, COLLADA and SDF mean
  opaque,  ///< opacity is ignored
  mask,    ///< drawn whole where opacity >= alpha_cutoff, elsewhere not at all
};

/// What a picture shows outside [0, 1] of its coordinates.
enum class TextureWrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// Material::missing_map of an image that no reader reads, wherever it lies.
inline constexpr const char* kUnreadImage = "a kind of image that is not read";

/// How a surface looks. Colours are display values (sRGB-encoded) in [0, 1], as MTL and URDF write
/// them.
struct Material {
  std::string name;
  glm::vec4 diffuse{0.8F, 0.8F, 0.8F, 1.0F};  ///< rgb and opacity
  glm::vec3 specular{0.0F, 0.0F, 0.0F};
  glm::vec3 emission{0.0F, 0.0F, 0.0F};
  float shininess = 0.0F;             ///< MTL's Ns, 0 to 1000
  std::filesystem::path diffuse_map;  ///< resolved file; empty: none
  std::string missing_map;  ///< the name of an image that is not used; diffuse_map is then empty
  /// The image's bytes (PNG, JPEG ...) when it is embedded in the mesh's file; diffuse_map is then
  /// not a file but a name for it: "arm.glb#2".
  std::shared_ptr<const Bytes> diffuse_bytes;
  glm::vec2 map_scale{1.0F, 1.0F};   ///< map_Kd -s
  glm::vec2 map_offset{0.0F, 0.0F};  ///< map_Kd -o
  /// Radians, counter-clockwise about (0, 0) with v up: after map_scale, before map_offset.
  float map_rotation = 0.0F;
  TextureWrap wrap_u = TextureWrap::repeat;
  TextureWrap wrap_v = TextureWrap::repeat;
  AlphaMode alpha_mode = AlphaMode::blend;
  float alpha_cutoff = 0.5F;  ///< of AlphaMode::mask
  bool operator==(const Material&) const = default;
};

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 texture;  ///< v up, as OBJ has it: (0, 0) is the image's bottom left
};
static_assert(sizeof(Vertex) == 32);

/// A run of triangles of one group and one material.
struct MeshPart {
  std::string group;              ///< OBJ `g` (or `o`) name; empty when none was given
  std::uint32_t material = 0;     ///< into Mesh::materials
  std::uint32_t first_index = 0;  ///< into Mesh::indices
  std::uint32_t index_count = 0;  ///< three per triangle
};

struct Bounds {
  Vec3 min{1e300, 1e300, 1e300};
  Vec3 max{-1e300, -1e300, -1e300};
  bool empty() const { return min.x > max.x; }
  void add(const Vec3& point);
  void add(const Bounds& other);
};

/// A shape by its kind and sizes in metres: sides of a box; three times the radius of a sphere;
/// radius, radius and length of the others.
struct ShapeSize {
  enum class Kind : std::uint8_t { box, sphere, cylinder, capsule };
  Kind kind = Kind::box;
  std::array<double, 3> size{};
  auto operator<=>(const ShapeSize&) const = default;
};

/// Triangles with everything needed to draw them, in metres, z up: the reader applies the file's
/// unit and up axis. Counter-clockwise triangles face outward. Normals are unit length.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  /// 0xRRGGBBAA by vertex, which multiplies the material's diffuse colour (the opacity is not
  /// drawn); empty: none.
  std::vector<std::uint32_t> colors;
  std::vector<MeshPart> parts;  ///< in the order of the file
  std::vector<Material> materials;
  Bounds bounds;
  /// The shape that the triangles approximate; empty for those of a file.
  std::optional<ShapeSize> shape{};

  std::size_t triangleCount() const { return indices.size() / 3; }
};

/// How a material's image lies on texture coordinates: scaled, turned, then moved.
struct MapPlacing {
  glm::vec2 along_u{1.0F, 0.0F}, along_v{0.0F, 1.0F}, offset{0.0F, 0.0F};

  explicit MapPlacing(const Material& material);
  /// Sums in this order, as shaders do: without a turn it is scale and offset to the bit.
  glm::vec2 of(const glm::vec2& texture) const {
    return texture.x * along_u + texture.y * along_v + offset;
  }
  bool operator==(const MapPlacing&) const = default;
};

}  // namespace rocinante
