#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"

// The statement that says each item of a state again: what restatements and the identity's text
// are made of.
namespace rocinante {

std::string presenceText(std::string_view device, const PresenceValue& value);
std::string poseText(std::string_view device, const PoseValue& value);
std::string jointsText(std::string_view device, const std::vector<double>& values);
/// Without names: takes an order back.
std::string orderText(std::string_view device, const std::vector<std::string>& names);
std::string jointText(std::string_view device, std::string_view name, double value);
std::string visibilityText(const Path& path, const Visibility& value);
std::string colorText(const Path& path, const ColorValue& value);
/// `part` counts from 0 and must have come.
std::string drawingText(std::string_view id, const Drawing& drawing, std::size_t part);
std::string viewText(std::string_view name, const ViewValue& value);
std::string seenText(std::string_view device, LogTime time);

}  // namespace rocinante
