#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/document/xml_document.h"
#include "core/kinematics/model.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// Most bytes of an SDF file; more is refused.
inline constexpr std::size_t kMaxSdfBytes = std::size_t{64} << 20;

/// Reads the first model of an SDF file (docs/meshes.md, section "SDF") by libsdformat, which sits
/// in a module (librocinante_sdformat.so): linking it would cost every program 26 ms at start.
/// Everything valid is returned, as with readUrdf; empty with an error where there is no module.
/// `<include>` is not followed. For one thread at a time.
std::optional<Model> readSdf(ByteView bytes, const std::filesystem::path& path, MeshStore& meshes,
                             Findings& faults);

/// Judges an SDF whose root is <sdf> before libsdformat reads it, since libsdformat names neither
/// the value nor, often, the place: the version, and every value of an element that is read. Adds
/// to the account what the reader does not use. False: with an error, for which libsdformat refuses
/// the file.
bool judgeSdf(const XmlDocument& document, FaultList& faults);

/// The text with its `<include>`s blanked out, since libsdformat would open the files that they
/// name; places stay. Empty with a fault when it is nested too deep, or more than libsdformat makes
/// in half a minute.
std::optional<std::string> sdfWithoutIncludes(std::string text, FaultList& faults);

/// The `<uri>`s of meshes.
std::vector<std::string> sdfMeshes(std::string_view text);

}  // namespace rocinante
