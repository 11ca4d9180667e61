#pragma once

#include <string_view>

namespace rocinante::shader {

// GLSL 3.30. Arithmetic, sqrt and derivatives only, but for one pow() of highlights: what llvmpipe
// computes the same on every pinned CPU (docs/rendering.md). Colours come and go as display values;
// light is added up in between. No sRGB formats: drivers round them by CPU.
extern const std::string_view kSceneVertex;
extern const std::string_view kSceneFragment;
extern const std::string_view kBackgroundVertex;
extern const std::string_view kBackgroundFragment;
extern const std::string_view kGridVertex;
extern const std::string_view kGridFragment;
extern const std::string_view kOverlayVertex;
extern const std::string_view kOverlayFragment;

}  // namespace rocinante::shader
