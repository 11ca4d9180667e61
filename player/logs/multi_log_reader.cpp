#include "player/logs/multi_log_reader.h"

#include <algorithm>
#include <utility>

#include "core/base/pattern.h"
#include "core/log/log_profile.h"

namespace rocinante {
namespace {

constexpr TapePosition kEnd{LogTime::max(), ~std::uint32_t{0}, ~std::uint64_t{0}};

}  // namespace

bool ChannelChoice::holds(const LogChannel& channel) const {
  const std::string_view topic = profile::capturedTopic(channel.topic);
  if (!imported && only.empty() && channel.imported()) return false;
  return (only.empty() || anyPatternMatches(only, topic)) && !anyPatternMatches(muted, topic);
}

Result<MultiLogReader> MultiLogReader::open(const std::vector<std::filesystem::path>& paths,
                                            ChannelChoice choice) {
  MultiLogReader merge;
  merge.inputs_.reserve(paths.size());
  bool any_origin = false;
  for (const auto& path : paths) {
    Result<LogReader> reader = LogReader::open(path);
    if (!reader) return reader.error();
    const LogSummary& summary = reader->summary();
    if (summary.messages > 0) {
      merge.origin_ = any_origin ? std::min(merge.origin_, summary.origin) : summary.origin;
      any_origin = true;
    }
    std::vector<bool> chosen;
    for (const LogChannel& channel : reader->channels()) {
      if (chosen.size() <= channel.id) chosen.resize(channel.id + 1U);
      chosen[channel.id] = choice.holds(channel);
    }
    if (choice.isAll() && summary.messages > 0) {
      merge.start_ = merge.empty_ ? summary.start : std::min(merge.start_, summary.start);
      merge.end_ = merge.empty_ ? summary.end : std::max(merge.end_, summary.end);
      merge.empty_ = false;
    }
    merge.inputs_.push_back({std::move(*reader), std::move(chosen), std::nullopt});
  }
  if (!choice.isAll()) {
    if (const Status found = merge.findRange(); !found) return found.error();
  }
  return merge;
}

Status MultiLogReader::findRange() {
  if (const Status put = seek(TapePosition::at(LogTime::min()), Which::captured); !put) return put;
  const Result<std::optional<LogMessage>> first = next();
  if (!first) return first.error();
  empty_ = !*first;
  if (empty_) return {};
  start_ = (*first)->log_time;
  const Result<Earlier> last = back(kEnd, 1, LogTime::min());
  if (!last) return last.error();
  end_ = last->place.time;
  return {};
}

bool MultiLogReader::anyImported() const {
  return std::ranges::any_of(inputs_, [](const Input& input) {
    return std::ranges::any_of(input.reader.channels(), &LogChannel::imported);
  });
}

bool MultiLogReader::chosen(std::size_t log, ChannelId channel) const {
  const std::vector<bool>& chosen = inputs_[log].chosen;
  return channel < chosen.size() && chosen[channel];
}

std::set<std::string> MultiLogReader::sources() const {
  std::set<std::string> names;
  for (std::size_t log = 0; log < inputs_.size(); ++log) {
    for (const LogChannel& channel : channels(log)) {
      if (!channel.folded() || !chosen(log, channel.id)) continue;
      const auto source = channel.metadata.find("source");
      if (source != channel.metadata.end() && !source->second.empty()) names.insert(source->second);
    }
  }
  return names;
}

std::vector<std::string> MultiLogReader::damage() const {
  std::vector<std::string> sentences;
  for (const Input& input : inputs_) {
    for (const DamageSpan& span : input.reader.damage()) {
      const std::string place = span.to > span.from ? "bytes " + std::to_string(span.from) +
                                                          " to " + std::to_string(span.to)
                                                    : "byte " + std::to_string(span.from);
      const std::string cost =
          span.messages_lost ? ": " + std::to_string(*span.messages_lost) + " messages lost" : "";
      sentences.push_back(span.cause + cost + " (" + input.reader.name() + ", " + place + ")");
    }
  }
  return sentences;
}

bool MultiLogReader::wanted(const Input& input, const LogMessage& message) const {
  const LogChannel& channel = *message.channel;
  if (channel.id >= input.chosen.size() || !input.chosen[channel.id]) return false;
  switch (which_) {
    case Which::captured:
      return channel.captured();
    case Which::received:
      return channel.received();
    case Which::folded:
      return channel.folded();
  }
  return false;
}

Status MultiLogReader::advance(Input& input) {
  while (true) {
    Result<std::optional<LogMessage>> message = input.reader.next();
    if (!message) return message.error();
    input.head = *message;
    if (!input.head || wanted(input, *input.head)) return {};
  }
}

Status MultiLogReader::seekInputs(TapePosition place) {
  taken_ = nullptr;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    LogReader& reader = inputs_[i].reader;
    Status put;
    if (i == place.log && place.file_offset > 0) {
      put = reader.seekAfter({place.time, place.file_offset - 1});
    } else if (i >= place.log) {
      put = reader.seek(place.time);
    } else {
      // At equal times the log named first goes first; its messages are behind this place.
      put = reader.seekAfter({place.time, ~std::uint64_t{0}});
    }
    if (!put) return put;
    inputs_[i].head.reset();
  }
  return {};
}

Status MultiLogReader::seek(TapePosition place, Which which) {
  which_ = which;
  if (const Status put = seekInputs(place); !put) return put;
  for (Input& input : inputs_) {
    if (const Status read = advance(input); !read) return read;
  }
  return {};
}

Result<std::optional<LogMessage>> MultiLogReader::next() {
  if (taken_ != nullptr) {
    if (const Status read = advance(*std::exchange(taken_, nullptr)); !read) return read.error();
  }
  for (Input& input : inputs_) {
    // Not <=: at equal times the log named first goes first.
    if (input.head && (taken_ == nullptr || input.head->log_time < taken_->head->log_time)) {
      taken_ = &input;
    }
  }
  if (taken_ == nullptr) return std::optional<LogMessage>();
  return taken_->head;
}

TapePosition MultiLogReader::place() const {
  if (taken_ == nullptr) return kEnd;
  return {taken_->head->log_time, static_cast<std::uint32_t>(taken_ - inputs_.data()),
          taken_->head->file_offset};
}

/// The heads are each log's last message before this place.
Result<std::optional<TapePosition>> MultiLogReader::previous() {
  const auto goBack = [this](Input& input) -> Status {
    while (true) {
      Result<std::optional<LogMessage>> message = input.reader.previous();
      if (!message) return message.error();
      input.head = *message;
      if (!input.head || wanted(input, *input.head)) return {};
    }
  };
  if (taken_ == nullptr) {
    for (Input& input : inputs_) {
      if (const Status read = goBack(input); !read) return read.error();
    }
  } else if (const Status read = goBack(*taken_); !read) {
    return read.error();
  }
  taken_ = nullptr;
  for (Input& input : inputs_) {
    if (input.head && (taken_ == nullptr || input.head->log_time >= taken_->head->log_time)) {
      taken_ = &input;
    }
  }
  if (taken_ == nullptr) return std::optional<TapePosition>();
  return std::optional(place());
}

Result<MultiLogReader::Earlier> MultiLogReader::back(TapePosition from, std::uint64_t count,
                                                     LogTime floor) {
  which_ = Which::captured;
  if (const Status put = seekInputs(from); !put) return put.error();
  Earlier earlier{0, from, std::nullopt};
  while (true) {
    const Result<std::optional<TapePosition>> found = previous();
    if (!found) return found.error();
    if (!*found || (*found)->time < floor) return earlier;
    if (earlier.messages == count) {
      earlier.before = (*found)->time;
      return earlier;
    }
    ++earlier.messages;
    earlier.place = **found;
  }
}

}  // namespace rocinante
