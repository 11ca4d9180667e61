#pragma once

#include <cstddef>
#include <string>
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

// Of the optional looks (look_shaders.cpp).
extern const std::string_view kFlatVertex;
extern const std::string_view kFlatFragment;
extern const std::string_view kEdgeVertex;
extern const std::string_view kEdgeFragment;
extern const std::string_view kGhostFragment;
extern const std::string_view kOutlineVertex;
extern const std::string_view kOutlineFragment;
extern const std::string_view kShadowLookup;

/// The scene's or the grid's source with SHADOWS defined, and kShadowLookup in it when it is the
/// stage that looks into the map. A variant, not a branch: shadows that are off cost nothing.
std::string withShadows(std::string_view source, bool looks_up);
/// The scene's source with so many lights of the cell's own; none: as it is.
std::string withLights(std::string_view source, std::size_t count);

}  // namespace rocinante::shader
