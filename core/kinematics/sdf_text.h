#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"
#include "core/document/xml_document.h"

namespace rocinante {

/// The text with its `<include>`s blanked out, since libsdformat would open the files that they
/// name; places stay. Empty with a fault when it is nested too deep, or more than libsdformat makes
/// in half a minute.
std::optional<std::string> sdfWithoutIncludes(std::string text, FaultList& faults);

/// Judges an SDF whose root is <sdf> before libsdformat reads it, since libsdformat names neither
/// the value nor, often, the place: the version, and every value of an element that is read. Adds
/// to the account what the reader does not use. False: with an error, for which libsdformat refuses
/// the file.
bool judgeSdf(const XmlDocument& document, FaultList& faults);

/// The `<uri>`s of meshes.
std::vector<std::string> sdfMeshes(std::string_view text);

}  // namespace rocinante
