#include "viewer/serve/foxglove_messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "core/base/base64.h"
#include "core/base/json_parse.h"
#include "core/base/plain_text.h"
#include "core/base/version.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

constexpr JsonLimits kRequestJson{64U << 10U, 1U << 15U, 16};

Error refused(std::string sentence) { return {ErrorKind::bad_argument, std::move(sentence), {}}; }

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<std::uint32_t> numberOf(const Json& json) {
  if (!json.is_number_unsigned()) return {};
  const auto number = json.get<std::uint64_t>();
  if (number > 0xFFFFFFFFU) return {};
  return static_cast<std::uint32_t>(number);
}

const Json* listIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_array() ? &*found : nullptr;
}

Result<FoxgloveRequest> subscriptionsOf(const Json& json) {
  const Json* const list = listIn(json, "subscriptions");
  if (list == nullptr) return refused("subscribe needs a list of subscriptions");
  FoxgloveRequest request;
  for (const Json& each : *list) {
    const auto field = [&](const char* name) {
      const auto found = each.find(name);
      return found == each.end() ? std::nullopt : numberOf(*found);
    };
    if (!each.is_object() || !field("id") || !field("channelId")) {
      return refused("a subscription has an id and a channelId, numbers of 32 bits");
    }
    request.subscribe.emplace_back(*field("id"), *field("channelId"));
  }
  return request;
}

Result<FoxgloveRequest> endedOf(const Json& json) {
  const Json* const list = listIn(json, "subscriptionIds");
  if (list == nullptr) return refused("unsubscribe needs a list of subscriptionIds");
  FoxgloveRequest request;
  for (const Json& each : *list) {
    const auto id = numberOf(each);
    if (!id) return refused("a subscriptionId is a number of 32 bits");
    request.unsubscribe.push_back(*id);
  }
  return request;
}

}  // namespace

Result<FoxgloveRequest> parseFoxgloveRequest(std::string_view message) {
  const Json json = parseJsonOrDiscard<Json>(message, kRequestJson);
  if (!json.is_object()) return refused("a message is a JSON object");
  const auto op = json.find("op");
  if (op == json.end() || !op->is_string()) return refused("a message has an op, a text");
  const auto& name = op->get_ref<const std::string&>();
  if (name == "subscribe") return subscriptionsOf(json);
  if (name == "unsubscribe") return endedOf(json);
  return refused(fmt::format("`{}` is not to be had here: only subscribe and unsubscribe are",
                             plainText(std::string_view(name).substr(0, 40))));
}

std::string foxgloveServerInfo(std::string_view session) {
  Json json;
  json["op"] = "serverInfo";
  json["name"] = std::string(version());
  json["capabilities"] = Json::array();
  json["supportedEncodings"] = Json::array();
  json["metadata"] = Json::object();
  json["sessionId"] = session;
  return text(json);
}

std::string foxgloveStatus(FoxgloveLevel level, std::string_view sentence) {
  Json json;
  json["op"] = "status";
  json["level"] = static_cast<int>(level);
  json["message"] = sentence;
  return text(json);
}

std::string foxgloveChannel(std::uint32_t id, std::string_view topic, const MessageSchema& schema) {
  Json json;
  json["id"] = id;
  json["topic"] = topic;
  json["encoding"] = schema.message_encoding;
  json["schemaName"] = schema.name;
  json["schemaEncoding"] = schema.encoding;
  const bool is_binary = schema.encoding == "protobuf";
  json["schema"] = is_binary ? base64Of(schema.data) : std::string(textOf(schema.data));
  return text(json);
}

std::string foxgloveAdvertise(const std::vector<std::string_view>& channels) {
  return fmt::format(R"({{"op":"advertise","channels":[{}]}})", fmt::join(channels, ","));
}

std::string foxgloveUnadvertise(const std::vector<std::uint32_t>& channels) {
  return fmt::format(R"({{"op":"unadvertise","channelIds":[{}]}})", fmt::join(channels, ","));
}

}  // namespace rocinante
