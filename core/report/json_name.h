#pragma once

#include <nlohmann/json_fwd.hpp>

namespace rocinante {

/// Objects keep their keys in the order of insertion. For headers, which need its name alone: who
/// makes or reads one includes core/report/json_text.h.
using Json = nlohmann::ordered_json;

}  // namespace rocinante
