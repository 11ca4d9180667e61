// The statement that restates each item of a state: used for restatements and the identity's text.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// True when the statement is about a device whose name matches one of `patterns`
/// (core/base/pattern.h): its joints, its pose, its presence, its look, what it carries or what is
/// drawn on it. False for `erase`, `event`, layers, and whatever is drawn in the world.
bool isAboutDevice(const Statement& statement, std::span<const std::string> patterns);

std::string presenceText(std::string_view device, const PresenceValue& value);
std::string poseText(std::string_view device, const PoseValue& value);
std::string jointsText(std::string_view device, const std::vector<double>& values);
/// An order without names, which removes an order.
std::string orderText(std::string_view device, const std::vector<std::string>& names);
std::string jointText(std::string_view device, std::string_view name, double value);
std::string visibilityText(const Path& path, const Visibility& value);
std::string colorText(const Path& path, const ColorValue& value);
/// `part` counts from 0 and must be present.
std::string drawingText(std::string_view id, const Drawing& drawing, std::size_t part);
std::string viewText(std::string_view name, const ViewValue& value);
std::string seenText(std::string_view device, LogTime time);

}  // namespace rocinante
