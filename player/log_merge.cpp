#include "player/log_merge.h"

#include <algorithm>
#include <utility>

namespace rocinante {

Result<LogMerge> LogMerge::open(const std::vector<std::filesystem::path>& paths) {
  LogMerge merge;
  merge.inputs_.reserve(paths.size());
  bool any_origin = false;
  for (const auto& path : paths) {
    Result<LogReader> reader = LogReader::open(path);
    if (!reader) return reader.error();
    const LogSummary& summary = reader->summary();
    if (summary.messages > 0) {
      const bool first = merge.messages_ == 0;
      merge.start_ = first ? summary.start : std::min(merge.start_, summary.start);
      merge.end_ = first ? summary.end : std::max(merge.end_, summary.end);
      merge.origin_ = any_origin ? std::min(merge.origin_, summary.origin) : summary.origin;
      any_origin = true;
      merge.messages_ += summary.messages;
    }
    merge.inputs_.push_back({std::move(*reader), std::nullopt});
  }
  return merge;
}

std::set<std::string> LogMerge::sources() const {
  std::set<std::string> names;
  for (const Input& input : inputs_) {
    for (const LogChannel& channel : input.reader.channels()) {
      if (!channel.folded()) continue;
      const auto source = channel.metadata.find("source");
      if (source != channel.metadata.end() && !source->second.empty()) names.insert(source->second);
    }
  }
  return names;
}

std::vector<std::string> LogMerge::damage() const {
  std::vector<std::string> sentences;
  for (const Input& input : inputs_) {
    for (const DamageSpan& span : input.reader.damage()) {
      const std::string place = input.reader.name() + ", bytes " + std::to_string(span.from) +
                                " to " + std::to_string(span.to);
      const std::string cost =
          span.messages_lost ? ": " + std::to_string(*span.messages_lost) + " messages lost" : "";
      sentences.push_back(span.cause + cost + " (" + place + ")");
    }
  }
  return sentences;
}

Status LogMerge::advance(Input& input) {
  while (true) {
    Result<std::optional<LogMessage>> message = input.reader.next();
    if (!message) return message.error();
    input.head = *message;
    if (!input.head) return {};
    const LogChannel& channel = *input.head->channel;
    if (which_ == Which::captured ? channel.captured() : channel.folded()) return {};
  }
}

Status LogMerge::seek(LogTime moment, Which which) {
  which_ = which;
  taken_ = nullptr;
  for (Input& input : inputs_) {
    if (Status found = input.reader.seek(moment); !found) return found;
    if (Status read = advance(input); !read) return read;
  }
  return {};
}

Result<std::optional<LogMessage>> LogMerge::next() {
  if (taken_ != nullptr) {
    if (const Status read = advance(*std::exchange(taken_, nullptr)); !read) return read.error();
  }
  for (Input& input : inputs_) {
    // Not <=: of equal times, the log named first goes first.
    if (input.head && (taken_ == nullptr || input.head->log_time < taken_->head->log_time)) {
      taken_ = &input;
    }
  }
  if (taken_ == nullptr) return std::optional<LogMessage>();
  return taken_->head;
}

}  // namespace rocinante
