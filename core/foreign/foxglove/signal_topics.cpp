#include "core/foreign/foxglove/signal_topics.h"

namespace rocinante {

std::string SignalTopics::nameOf(const SignalOwner& owner) {
  const std::string wanted = topicOf("/signals", ownerText(owner));
  std::string given = given_.take(wanted);
  if (given != wanted) {
    const auto& [device, link] = owner;
    const std::string whose =
        link.empty() ? "device `" + device + "`" : "link `" + link + "` of `" + device + "`";
    left_out_.leaveOut(
        {.kind = "topic",
         .name = wanted,
         .reason = "it is another owner's: the signals of " + whose + " are on " + given});
  }
  return given;
}

void SignalTopics::know(const KnownSignals& known) {
  for (const auto& [owner, signals] : known.byOwner()) {
    Topic& topic = topics_[owner];
    if (topic.name.empty()) topic.name = nameOf(owner);
    if (topic.json.isOf(signals)) continue;
    topic.json = SignalJson(signals);
    topic.schema.reset();
  }
  if (known.beyond().values == 0) return;
  left_out_.leaveOut({.kind = "value",
                      .name = "signal",
                      .reason = "of signals beyond the first 65,536, which have no field",
                      .count = known.beyond().values});
}

Status SignalTopics::write(MessageSink& out, LogTime time, const SignalOwner& owner,
                           std::span<const StatedSignal> signals, bool all_requested) {
  const auto found = topics_.find(owner);
  if (found == topics_.end()) return {};
  Topic& topic = found->second;
  const std::string message = topic.json.message(signals, !all_requested);
  if (!all_requested && message == "{}") return {};
  if (!topic.schema) {
    const std::string text = topic.json.schema();
    const ByteView bytes = bytesOf(text);
    topic.schema = MessageSchema{"rocinante" + topic.name, "jsonschema",
                                 Bytes(bytes.begin(), bytes.end()), "json"};
  }
  return out.write(topic.name, *topic.schema, time, bytesOf(message));
}

}  // namespace rocinante
