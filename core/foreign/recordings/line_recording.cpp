#include "core/foreign/recordings/line_recording.h"

#include <chrono>
#include <utility>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

/// Ten years after 1970: later times are dates.
constexpr LogTime kFirstDate{std::chrono::seconds(315'360'000)};

bool isBlank(std::string_view line) { return line.find_first_not_of(" \t") == line.npos; }

}  // namespace

LineRecording::LineRecording(RecordingBytes bytes, std::string name, const char* topic,
                             const char* decoder, const char* unit)
    : lines_(std::move(bytes)),
      name_(std::move(name)),
      decoder_(decoder),
      unit_(unit),
      topics_(1),
      rows_(topic, decoder, decoder == std::string_view("csv") ? "column" : "key") {
  topics_[0].name = topic;
  topics_[0].encoding = decoder;
  topics_[0].decoder = decoder;
}

std::optional<LogTime> LineRecording::origin() const {
  if (!first_ || *first_ >= kFirstDate) return std::nullopt;
  return LogTime{};
}

Account LineRecording::account() const {
  Account account = rows_.account();
  const OverwrittenRows& overwritten = rows_.overwritten();
  if (overwritten.count() > 0) {
    account.leaveOut({.kind = unit_,
                      .reason = std::string("overwritten by a later ") + unit_ + " of its time",
                      .first = "line " + std::to_string(overwritten.firstLine()),
                      .count = overwritten.count(),
                      .severity = Severity::warning});
  }
  return account;
}

std::vector<std::string> LineRecording::damage() const {
  std::vector<std::string> sentences;
  const auto tell = [&](std::uint64_t count, const char* what, std::size_t line) {
    if (count == 0) return;
    sentences.push_back(countText(count, unit_) + what + " (" + name_ + ", line " +
                        std::to_string(line) + ")");
  };
  tell(timeless_, " without a time left out, the first here", first_timeless_);
  tell(too_long_, " of more than 1 MiB left out, the first here", first_too_long_);
  if (lines_.isCut()) sentences.push_back("the file has become shorter (" + name_ + ")");
  return sentences;
}

bool LineRecording::isRemark(std::string_view line) const { return isBlank(line); }

void LineRecording::skipLines(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) lines_.next();
}

Result<std::optional<ros::BagMessage>> LineRecording::next() {
  while (const auto line = lines_.next()) {
    if (lines_.wasTooLong()) {
      if (too_long_++ == 0) first_too_long_ = lines_.number();
      continue;
    }
    if (isRemark(*line)) continue;
    rows_.atLine(lines_.number());
    const std::optional<Row> row = rowOf(*line);
    if (!row) {
      if (timeless_++ == 0) first_timeless_ = lines_.number();
      continue;
    }
    if (!first_) first_ = LogTime(row->time);
    ros::BagMessage message;
    message.sequence = sequence_++;
    message.log_time = LogTime(row->time);
    message.publish_time_ns = row->time.count();
    message.payload = bytesOf(*line);
    message.packet = row->packet;
    if (!row->fault.empty()) {
      fault_ = "line " + std::to_string(lines_.number()) + ": " + row->fault;
      message.fault = fault_;
    }
    return std::optional(message);
  }
  return std::optional<ros::BagMessage>();
}

}  // namespace rocinante
