#include "recorder/copy/clock_message.h"

#include <nlohmann/json.hpp>

namespace rocinante {

std::optional<std::string> shiftedClockText(ByteView payload, Nanoseconds shift) {
  using Json = nlohmann::ordered_json;
  constexpr const char* kNoticed = "noticed_ns";
  const std::string_view text = textOf(payload);
  Json step = Json::parse(text.begin(), text.end(), nullptr, false);
  if (!step.is_object() || !step.contains(kNoticed) || !step[kNoticed].is_number_integer()) {
    return std::nullopt;
  }
  std::int64_t noticed = 0;
  if (__builtin_add_overflow(step[kNoticed].get<std::int64_t>(), shift.count(), &noticed)) {
    return std::nullopt;
  }
  step[kNoticed] = noticed;
  return step.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
