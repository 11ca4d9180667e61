#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace rocinante::ros {

/// Why messages were not translated, or not whole, by sentence: "NaN joint values" and how often.
using TranslationNotes = std::map<std::string, std::uint64_t, std::less<>>;

}  // namespace rocinante::ros
