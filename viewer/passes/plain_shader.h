#pragma once

#include <string_view>

namespace rocinante::shader {

// The scene with Shading::plain and without shadows: the key light and uniform ambient light,
// computed per vertex in display values and multiplied with the texture. Both sides of a triangle
// are lit alike, so its winding does not matter. GLSL 3.30, the inputs of kSceneVertex.
extern const std::string_view kPlainVertex;
/// Replaces kPlainVertex for ItemBatch.
extern const std::string_view kBatchedPlainVertex;
/// For surfaces without and with a texture.
extern const std::string_view kPlainFragment;
extern const std::string_view kPlainMappedFragment;

}  // namespace rocinante::shader
