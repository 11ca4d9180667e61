#include "viewer/serve/foxglove_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "viewer/serve/client_queue.h"
#include "viewer/serve/foxglove_messages.h"

namespace rocinante {
namespace {

/// Of channels in one message.
constexpr std::size_t kAdvertiseBytes = 256 * 1024;

void append(Bytes& bytes, std::uint64_t number, unsigned count) {
  for (unsigned i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(number >> (8 * i)));
}

FoxgloveClient::Outgoing textOf(std::string_view text) {
  FoxgloveClient::Outgoing out{true, SharedMessage::begin()};
  const ByteView bytes = bytesOf(text);
  out.bytes.insert(out.bytes.end(), bytes.begin(), bytes.end());
  return out;
}

FoxgloveClient::Outgoing messageOf(std::uint32_t id, const FoxgloveDesk::Message& message) {
  constexpr std::uint64_t kMessageData = 1;
  FoxgloveClient::Outgoing out{false, SharedMessage::begin()};
  append(out.bytes, kMessageData, 1);
  append(out.bytes, id, 4);
  append(out.bytes, static_cast<std::uint64_t>(nanosecondsOf(message.time)), 8);
  out.bytes.insert(out.bytes.end(), message.bytes.begin(), message.bytes.end());
  return out;
}

}  // namespace

FoxgloveClient::FoxgloveClient(const FoxgloveDesk& desk) : desk_(desk) {
  answer(foxgloveServerInfo(desk.session()));
}

void FoxgloveClient::answer(std::string text) {
  if (texts_.size() < kMostTexts) texts_.push_back(std::move(text));
}

void FoxgloveClient::subscribe(std::uint32_t id, std::uint32_t channel) {
  const auto refuse = [&](std::string_view why) {
    answer(foxgloveStatus(FoxgloveLevel::warning,
                          fmt::format("subscription {} of channel {}: {}", id, channel, why)));
  };
  if (channel >= desk_.channels().size()) return refuse("there is no such channel");
  if (channels_.contains(id)) return refuse("the subscription is there already");
  if (subscriptions_.contains(channel)) return refuse("the channel is subscribed to already");
  channels_[id] = channel;
  // The newest message at once, for it is whole; events from now on.
  const FoxgloveDesk::Channel& from = desk_.channels()[channel];
  const bool skips = from.keeps_all && !from.messages.empty();
  subscriptions_[channel] = {id, skips ? from.messages.back().number : 0};
}

void FoxgloveClient::receive(std::string_view message, bool is_binary) {
  if (is_binary) {
    return answer(foxgloveStatus(FoxgloveLevel::error, "binary messages are not to be had here"));
  }
  const auto request = parseFoxgloveRequest(message);
  if (!request) return answer(foxgloveStatus(FoxgloveLevel::error, request.error().what));
  for (const auto& [id, channel] : request->subscribe) subscribe(id, channel);
  for (const std::uint32_t id : request->unsubscribe) {
    const auto found = channels_.find(id);
    if (found == channels_.end()) {
      answer(
          foxgloveStatus(FoxgloveLevel::warning, fmt::format("there is no subscription {}", id)));
      continue;
    }
    subscriptions_.erase(found->second);
    channels_.erase(found);
  }
}

/// A subscription of such a channel stays until the client ends it, without messages.
std::optional<FoxgloveClient::Outgoing> FoxgloveClient::withdrawal() {
  std::vector<std::uint32_t> ended;
  for (; withdrawn_ < desk_.replaced().size(); ++withdrawn_) {
    const std::uint32_t channel = desk_.replaced()[withdrawn_];
    if (channel < advertised_) ended.push_back(channel);
  }
  if (ended.empty()) return {};
  return textOf(foxgloveUnadvertise(ended));
}

std::optional<FoxgloveClient::Outgoing> FoxgloveClient::advertisement() {
  const auto& channels = desk_.channels();
  std::vector<std::string_view> texts;
  for (std::size_t bytes = 0; advertised_ < channels.size() && bytes < kAdvertiseBytes;
       ++advertised_) {
    if (channels[advertised_].isReplaced()) continue;
    texts.emplace_back(channels[advertised_].advertised);
    bytes += texts.back().size();
  }
  if (texts.empty()) return {};
  return textOf(foxgloveAdvertise(texts));
}

std::optional<FoxgloveClient::Outgoing> FoxgloveClient::nextMessage() {
  auto each = subscriptions_.lower_bound(turn_);
  for (std::size_t i = 0; i < subscriptions_.size(); ++i, ++each) {
    if (each == subscriptions_.end()) each = subscriptions_.begin();
    auto& [channel, subscription] = *each;
    const auto& messages = desk_.channels()[channel].messages;
    const auto message = std::ranges::find_if(
        messages, [seen = subscription.seen](const auto& one) { return one.number > seen; });
    if (message == messages.end()) continue;
    subscription.seen = message->number;
    turn_ = channel + 1;
    return messageOf(subscription.id, *message);
  }
  return {};
}

std::optional<FoxgloveClient::Outgoing> FoxgloveClient::next() {
  if (!texts_.empty()) {
    std::string text = std::move(texts_.front());
    texts_.pop_front();
    return textOf(text);
  }
  if (auto channels = withdrawal()) return channels;
  if (auto channels = advertisement()) return channels;
  return nextMessage();
}

}  // namespace rocinante
