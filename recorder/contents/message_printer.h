#pragma once

#include <cstddef>
#include <string>

#include "core/log/log_types.h"

namespace rocinante {

enum class CatFormat { text, json, csv };

/// Writes messages, one a line (docs/programs/log.md, "log cat"). Fields of a stranger come out
/// harmless: a datagram ends no line and moves no cursor.
class MessagePrinter {
 public:
  /// `name` stands before every message, unless it is empty; text counts seconds from `origin`.
  MessagePrinter(CatFormat format, std::string name, LogTime origin)
      : format_(format), name_(std::move(name)), origin_(origin) {}

  /// In text, topics take at least as much room as the widest that was told here.
  void makeRoomFor(const LogChannel& channel);
  void setOrigin(LogTime origin) { origin_ = origin; }

  /// Appends the line that names the columns: CSV has one.
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

}  // namespace rocinante
