#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "core/log/log_reader.h"
#include "core/packet/packet.h"
#include "core/report/account.h"

namespace rocinante {

/// Counts what a log holds, so that an export can account for what another format has no place for
/// (docs/decisions/030).
class SessionCensus {
 public:
  /// Each folded message with its packet, in order: MomentVisitor::message.
  void take(const LogMessage& message, const Packet* packet);

  /// Datagrams that hold no packet, by topic.
  std::map<std::string, std::uint64_t> unread() const;

  /// Adds the statements of these kinds that came: warnings.
  void addStatements(Account& account, std::span<const StatementKind> kinds,
                     std::string_view reason) const;
  /// Adds the datagrams that hold no packet.
  void addUnread(Account& account, std::string_view reason) const;

 private:
  std::array<std::uint64_t, static_cast<std::size_t>(StatementKind::seen) + 1> counts_{};
  std::map<std::string, std::uint64_t> unread_;
  std::uint64_t* last_unread_ = nullptr;  ///< of the topic of the message before
};

/// Adds the log's attachments but its cell, by which it is exported.
void addAttachments(Account& account, const LogReader& log, std::string_view reason);
/// Adds the topics on which the log has marks, losses and steps of the clock.
void addOwnTopics(Account& account, const LogReader& log, std::string_view reason);

}  // namespace rocinante
