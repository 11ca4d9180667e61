#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/mcap/record_stepper.h"

namespace rocinante::test {

using Json = nlohmann::ordered_json;

/// A record as the public MCAP conformance suite writes it: {"type": NAME, "fields": [[name,
/// value],
/// ...]}, names in alphabetic order, numbers as strings, bytes as arrays of them. Empty for records
/// that the suite leaves out (Chunk, MessageIndex, unknown ones).
std::optional<Json> recordJson(const mcap::Record& record);
Json messageJson(const mcap::Message& message);

/// Reads a whole file; prints why on stderr and exits with 2 when that fails.
std::string readWhole(const char* path);

}  // namespace rocinante::test
