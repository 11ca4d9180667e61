#pragma once

#include <string>
#include <string_view>

namespace rocinante::shader {

// GLSL 3.30. Only arithmetic, sqrt and derivatives, except one pow() for highlights: llvmpipe
// computes these the same on every pinned CPU (docs/rendering.md). Input and output colours are
// display values; light is summed in between. No sRGB formats: drivers round them differently by
// CPU.
extern const std::string_view kSceneVertex;
extern const std::string_view kSceneFragment;
/// Replaces kSceneVertex for ItemBatch: points and normals are already transformed.
extern const std::string_view kBatchedVertex;
/// Positions as kSceneVertex has them, and places in the texture, for passes without light.
extern const std::string_view kMappedVertex;
/// For kSceneVertex and kMappedVertex, depth only: discards where the texture's alpha is below
/// `cutoff`. A separate shader, because a shader with discard tests depth late.
extern const std::string_view kHolesFragment;
/// A fragment shader of surfaces for those with AlphaMode::mask: discards below `cutoff`.
std::string withCutout(std::string_view source);
extern const std::string_view kBackgroundVertex;
extern const std::string_view kBackgroundFragment;
extern const std::string_view kGridVertex;
extern const std::string_view kGridFragment;
extern const std::string_view kOverlayVertex;
extern const std::string_view kOverlayFragment;

}  // namespace rocinante::shader
