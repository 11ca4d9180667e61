#include "core/log/loss_message.h"

#include <nlohmann/json.hpp>

#include "core/base/json_parse.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

/// A missing count is zero; a malformed one makes the message unusable.
bool readCount(const Json& object, const char* key, std::uint64_t& out) {
  const auto found = object.find(key);
  if (found == object.end()) return true;
  if (!found->is_number_unsigned()) return false;
  out = found->get<std::uint64_t>();
  return true;
}

bool readTime(const Json& object, const char* key, LogTime& out) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_integer()) return false;
  out = LogTime(Nanoseconds(found->get<std::int64_t>()));
  return true;
}

}  // namespace

std::string lossText(const LossSpan& span) {
  Json object;
  object["endpoint"] = span.endpoint;
  object["from_ns"] = span.from.time_since_epoch().count();
  object["until_ns"] = span.until.time_since_epoch().count();
  object["kernel"] = span.counts.kernel;
  object["queue"] = span.counts.queue;
  object["disk"] = span.counts.disk;
  object["truncated"] = span.counts.truncated;
  // An endpoint that is not UTF-8 must not throw: invalid bytes are replaced.
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<LossSpan> parseLoss(ByteView payload) {
  const Json object = parseJsonOrDiscard<Json>(textOf(payload), kSmallJson);
  if (!object.is_object()) return std::nullopt;
  LossSpan span;
  const auto endpoint = object.find("endpoint");
  if (endpoint == object.end() || !endpoint->is_string()) return std::nullopt;
  span.endpoint = endpoint->get<std::string>();
  const bool ok = readTime(object, "from_ns", span.from) &&
                  readTime(object, "until_ns", span.until) &&
                  readCount(object, "kernel", span.counts.kernel) &&
                  readCount(object, "queue", span.counts.queue) &&
                  readCount(object, "disk", span.counts.disk) &&
                  readCount(object, "truncated", span.counts.truncated);
  if (!ok) return std::nullopt;
  return span;
}

}  // namespace rocinante
