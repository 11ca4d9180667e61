#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/plain_text.h"
#include "core/log/log_types.h"

namespace rocinante {

enum class CatFormat { text, json, csv };

/// Prints messages, one per line (docs/programs/log.md, "log cat"). Untrusted fields are escaped: a
/// datagram cannot end a line or move the cursor.
class MessagePrinter {
 public:
  /// `name` precedes every message unless it is empty; text counts seconds from `origin`.
  MessagePrinter(CatFormat format, std::string name, LogTime origin)
      : format_(format), name_(std::move(name)), origin_(origin) {}

  /// Widens the topic column of text output to fit this channel.
  void makeRoomFor(const LogChannel& channel);
  void setOrigin(LogTime origin) { origin_ = origin; }

  /// Appends the line of column names, for CSV.
  void header(std::string& out) const;
  void message(const LogMessage& message, std::string& out) const;

 private:
  void text(const LogMessage& message, bool is_text, std::string& out) const;
  void json(const LogMessage& message, bool is_text, std::string& out) const;
  void csv(const LogMessage& message, bool is_text, std::string& out) const;

  CatFormat format_;
  std::string name_;
  LogTime origin_;
  std::size_t topic_width_ = 0;
};

/// A payload on one line. Lines of packet text are joined by " | "; other payloads are shown as
/// their first 32 bytes in hexadecimal, with the length.
std::string payloadLine(ByteView payload, bool is_text);

}  // namespace rocinante
