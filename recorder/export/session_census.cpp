#include "recorder/export/session_census.h"

#include "core/log/log_profile.h"

namespace rocinante {

void SessionCensus::take(const LogMessage& message, const Packet* packet) {
  // What was decoded or imported directly follows the octets that it was made of.
  if (last_unread_ != nullptr && message.channel->decoded()) --*last_unread_;
  last_unread_ = nullptr;
  if (packet == nullptr) {
    last_unread_ = &unread_[message.channel->topic];
    ++*last_unread_;
    return;
  }
  for (const Statement& statement : packet->statements) {
    ++counts_[static_cast<std::size_t>(statement.kind)];
  }
}

std::map<std::string, std::uint64_t> SessionCensus::unread() const {
  std::map<std::string, std::uint64_t> unread = unread_;
  std::erase_if(unread, [](const auto& topic) { return topic.second == 0; });
  return unread;
}

void SessionCensus::addStatements(Account& account, std::span<const StatementKind> kinds,
                                  std::string_view reason) const {
  for (const StatementKind kind : kinds) {
    const std::uint64_t count = counts_[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    account.leaveOut({.kind = "statement",
                      .name = std::string(nameOf(kind)),
                      .reason = std::string(reason),
                      .count = count,
                      .severity = Severity::warning});
  }
}

void SessionCensus::addUnread(Account& account, std::string_view reason) const {
  for (const auto& [topic, count] : unread()) {
    account.leaveOut({.kind = "datagram",
                      .name = topic,
                      .reason = std::string(reason),
                      .count = count,
                      .severity = Severity::warning});
  }
}

void addAttachments(Account& account, const LogReader& log, std::string_view reason) {
  for (const LogAttachment& each : log.attachments()) {
    if (each.name == profile::kCellManifest || each.name.starts_with(profile::kCellFolder)) {
      continue;
    }
    account.leaveOut({.kind = "attachment", .name = each.name, .reason = std::string(reason)});
  }
}

void addOwnTopics(Account& account, const LogReader& log, std::string_view reason) {
  for (const LogChannel& channel : log.channels()) {
    if (channel.topic != profile::kMarkTopic && channel.topic != profile::kLossTopic &&
        channel.topic != profile::kClockTopic) {
      continue;
    }
    account.leaveOut({.kind = "topic", .name = channel.topic, .reason = std::string(reason)});
  }
}

}  // namespace rocinante
