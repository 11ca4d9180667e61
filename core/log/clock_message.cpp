#include "core/log/clock_message.h"

#include <nlohmann/json.hpp>

#include "core/base/json_parse.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kNoticed = "noticed_ns";
constexpr const char* kStep = "step_ns";

/// Null when the payload is not a clock step.
Json parseObject(ByteView payload) {
  Json object = parseJsonOrDiscard<Json>(textOf(payload), kSmallJson);
  const auto isCount = [&](const char* key) {
    return object.contains(key) && object[key].is_number_integer();
  };
  if (!object.is_object() || !isCount(kNoticed) || !isCount(kStep)) return nullptr;
  return object;
}

}  // namespace

std::string clockStepText(const ClockStep& step) {
  Json object;
  object[kNoticed] = step.at.time_since_epoch().count();
  object[kStep] = step.step.count();
  return object.dump();
}

std::optional<ClockStep> parseClockStep(ByteView payload) {
  const Json object = parseObject(payload);
  if (object.is_null()) return std::nullopt;
  return ClockStep{LogTime(Nanoseconds(object[kNoticed].get<std::int64_t>())),
                   Nanoseconds(object[kStep].get<std::int64_t>())};
}

std::optional<std::string> shiftedClockText(ByteView payload, Nanoseconds shift) {
  Json object = parseObject(payload);
  std::int64_t noticed = 0;
  if (object.is_null() ||
      __builtin_add_overflow(object[kNoticed].get<std::int64_t>(), shift.count(), &noticed)) {
    return std::nullopt;
  }
  object[kNoticed] = noticed;
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
