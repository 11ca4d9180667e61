#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"
#include "core/series/series_key.h"

namespace rocinante {

/// The names of the values of a device's positional `joints`, in order; empty when its model is not
/// known. `device_state`: what packets state about it.
using PositionalNames = std::function<std::vector<std::string>(std::string_view device,
                                                               const DeviceState& device_state)>;

/// The values of `joints` that a device's state gives to a name, as pictures show them: named ones
/// first, positional ones when there are as many as `names`, or by "1", "2" without names.
std::optional<double> jointStated(const DeviceState& device_state, std::string_view name,
                                  const std::vector<std::string>& names);

/// The number of a signal, a boolean as 1 or 0; empty for a text, and when it is not stated.
std::optional<double> signalStated(const SessionState& state, const SeriesKey& key);

/// The text of a signal that is a boolean or a text; empty for a number, and when it is not stated.
std::optional<std::string> stateStated(const SessionState& state, const SeriesKey& key);

}  // namespace rocinante
