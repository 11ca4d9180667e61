#pragma once

#include <string_view>

namespace rocinante::shader {

// The scene with Shading::plain and without shadows: the key light and an even rest, reckoned at
// the corners of the triangles in display values; a picture multiplies it. Both sides of a triangle
// are lit alike, so that it does not matter which way it turns. GLSL 3.30, the inputs of
// kSceneVertex.
extern const std::string_view kPlainVertex;
/// In place of kPlainVertex for what ItemBatch draws.
extern const std::string_view kBatchedPlainVertex;
/// Of surfaces without a picture, and with one.
extern const std::string_view kPlainFragment;
extern const std::string_view kPlainMappedFragment;

}  // namespace rocinante::shader
