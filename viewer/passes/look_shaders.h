#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rocinante::shader {

// GLSL 3.30 of the optional looks, by the same rules as that of shader_source.h.
extern const std::string_view kFlatVertex;
extern const std::string_view kFlatFragment;
extern const std::string_view kEdgeVertex;
extern const std::string_view kEdgeFragment;
extern const std::string_view kGhostFragment;
extern const std::string_view kOutlineVertex;
extern const std::string_view kOutlineFragment;
extern const std::string_view kShadowLookup;

/// The scene's or the grid's source with SHADOWS defined, and with kShadowLookup in the stage that
/// reads the map. A variant, not a branch, so that disabled shadows cost nothing.
std::string withShadows(std::string_view source, bool looks_up);
/// The scene's source with `count` lights of the cell; unchanged for none.
std::string withLights(std::string_view source, std::size_t count);

}  // namespace rocinante::shader
