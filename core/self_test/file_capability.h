#pragma once

#include <filesystem>
#include <optional>

#include "core/base/bytes.h"

namespace rocinante {

/// Whether the extended attribute `security.capability` of a program (linux/capability.h: struct
/// vfs_cap_data) gives it this capability (CAP_NET_RAW is 13) from its start.
bool givesCapability(ByteView attribute, int capability);

/// The same of a file; false where it has no such attribute or there is no such file.
bool fileHasCapability(const std::filesystem::path& program, int capability);

}  // namespace rocinante
