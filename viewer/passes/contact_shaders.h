#pragma once

#include <string>
#include <string_view>

namespace rocinante::shader {

// GLSL 3.30 of the look `contact`, by the same rules as that of shader_source.h.
extern const std::string_view kGroundVertex;
extern const std::string_view kWholeVertex;
extern const std::string_view kOpennessFragment;
extern const std::string_view kEvenedFragment;

/// The scene's or the grid's source with CONTACT defined, and with the look-up in the stage that
/// reads the map. A variant, not a branch, so that without the look it costs nothing.
std::string withContact(std::string_view source, bool looks_up);

}  // namespace rocinante::shader
