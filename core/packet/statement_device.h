#pragma once

#include <span>
#include <string>

#include "core/packet/packet.h"

namespace rocinante {

/// True when the statement is about a device whose name matches one of `patterns`
/// (core/base/pattern.h): its joints, its pose, its presence, its look, what it carries or what is
/// drawn on it. False for `erase`, `event`, layers, and whatever is drawn in the world.
bool isAboutDevice(const Statement& statement, std::span<const std::string> patterns);

}  // namespace rocinante
