#pragma once

#include <string_view>

namespace rocinante::shader {

// GLSL 3.30. Arithmetic, sqrt and derivatives only, but for one pow() of highlights: what llvmpipe
// computes the same on every pinned CPU (docs/rendering.md). Colours come and go as display values;
// light is added up in between. No sRGB formats: drivers round them by CPU.
extern const std::string_view kSceneVertex;
extern const std::string_view kSceneFragment;
/// In place of kSceneVertex for what ItemBatch draws: points and normals are moved already.
extern const std::string_view kBatchedVertex;
/// Of kSceneVertex, for depth alone: nothing where the picture is hardly there. Apart, because a
/// shader that may discard tests depth late.
extern const std::string_view kHolesFragment;
extern const std::string_view kBackgroundVertex;
extern const std::string_view kBackgroundFragment;
extern const std::string_view kGridVertex;
extern const std::string_view kGridFragment;
extern const std::string_view kOverlayVertex;
extern const std::string_view kOverlayFragment;

}  // namespace rocinante::shader
