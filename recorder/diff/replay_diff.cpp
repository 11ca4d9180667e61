#include "recorder/diff/replay_diff.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/hash.h"
#include "core/base/late_histogram.h"
#include "recorder/diff/message_match.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxAlone = 1'000'000;
constexpr double kOtherSpeed = 0.1;

/// SOURCE, and the endpoint it is mapped to.
using StreamKey = std::pair<std::string, std::string>;

/// "PORT", "GROUP:PORT" or a subject: how a topic names the endpoint.
std::string placeOf(const Endpoint& endpoint) {
  if (endpoint.isNats()) return endpoint.nats.subject;
  return endpoint.isMulticast() ? endpoint.address.text() : std::to_string(endpoint.address.port);
}

std::string placeOfTopic(const std::string& topic) {
  constexpr std::string_view kUdp = "/udp/";
  constexpr std::string_view kNats = "/nats/";
  // The last word of a subject is the SOURCE.
  if (topic.starts_with(kNats)) {
    const std::size_t dot = std::max(topic.rfind('.'), kNats.size());
    return topic.substr(kNats.size(), dot == topic.npos ? topic.npos : dot - kNats.size());
  }
  if (!topic.starts_with(kUdp)) return {};
  return topic.substr(kUdp.size(), topic.find('/', kUdp.size()) - kUdp.size());
}

/// The channels of both logs that correspond.
struct Streams {
  std::map<StreamKey, std::array<std::vector<bool>, 2>> by_key;  ///< in each log, by channel id

  void add(std::size_t side, const LogChannel& channel, std::string place) {
    const auto source = channel.metadata.find("source");
    StreamKey key{source == channel.metadata.end() ? std::string() : source->second,
                  std::move(place)};
    std::vector<bool>& chosen = by_key[std::move(key)][side];
    if (chosen.size() <= channel.id) chosen.resize(channel.id + 1U, false);
    chosen[channel.id] = true;
  }
};

Streams streamsOf(const LogReader& a, const LogReader& b, const std::vector<RouteMap>& maps) {
  Streams streams;
  for (const LogChannel& channel : a.channels()) {
    if (!channel.captured()) continue;
    const auto map = std::ranges::find_if(
        maps, [&](const RouteMap& each) { return each.matches(channel.topic); });
    streams.add(0, channel, map == maps.end() ? std::string() : placeOf(map->to));
  }
  for (const LogChannel& channel : b.channels()) {
    if (!channel.captured()) continue;
    const std::string place = placeOfTopic(channel.topic);
    const bool mapped =
        std::ranges::any_of(maps, [&](const RouteMap& each) { return placeOf(each.to) == place; });
    streams.add(1, channel, mapped ? place : std::string());
  }
  return streams;
}

/// Two times of one message.
struct Moment {
  LogTime a{}, b{};
};

/// Messages of only one log, to be matched with the other out of order.
class Alone {
 public:
  void add(std::size_t side, const MatchItem& item) {
    if (counts_.size() < kMaxAlone || counts_.contains(item.digest)) ++counts_[item.digest][side];
  }
  std::uint64_t inBoth() const {
    std::uint64_t both = 0;
    for (const auto& [digest, counts] : counts_) both += std::min(counts[0], counts[1]);
    return both;
  }

 private:
  std::map<std::array<std::uint64_t, 2>, std::array<std::uint64_t, 2>> counts_;
};

class Comparison {
 public:
  Comparison(LogReader& a, LogReader& b, const ReplayOptions& options,
             const std::function<void(double)>& progress)
      : a_(a), b_(b), options_(options), progress_(progress) {}

  Result<ReplayDiff> run() {
    diff_.name_a = a_.name();
    diff_.name_b = b_.name();
    diff_.origin_a = a_.summary().origin;
    diff_.origin_b = b_.summary().origin;
    diff_.speed = options_.speed.ratio();
    diff_.within = options_.within;
    streams_ = streamsOf(a_, b_, options_.maps);
    if (Status hashed = hashStreams(); !hashed) return hashed.error();
    if (Status aligned = align(); !aligned) return aligned.error();
    for (const auto& [key, channels] : streams_.by_key) {
      if (progress_) {
        progress_(static_cast<double>(diff_.sources.size()) /
                  static_cast<double>(streams_.by_key.size()));
      }
      if (Status compared = compare(key, channels); !compared) return compared.error();
    }
    // A channel may be defined without having messages.
    std::erase_if(diff_.sources, [](const ReplaySource& source) {
      return source.messages_a == 0 && source.messages_b == 0;
    });
    if (first_ && last_.a > first_->a && last_.b > first_->b) {
      diff_.measured_speed = static_cast<double>((last_.a - first_->a).count()) /
                             static_cast<double>((last_.b - first_->b).count());
    }
    for (const LossSpan& loss : b_.losses()) {
      diff_.lost_b += loss.counts.kernel + loss.counts.queue + loss.counts.disk;
    }
    return std::move(diff_);
  }

 private:
  Status hashStreams() {
    for (const auto& [reader, messages, stream] :
         {std::tuple(&a_, &diff_.messages_a, &diff_.stream_a),
          std::tuple(&b_, &diff_.messages_b, &diff_.stream_b)}) {
      if (Status rewound = reader->rewind(); !rewound) return rewound;
      Sha256 hash;
      while (true) {
        const Result<std::optional<LogMessage>> message = reader->next();
        if (!message) return message.error();
        if (!*message) break;
        if (!(*message)->channel->captured()) continue;
        ++*messages;
        hash.add((*message)->payload);
      }
      *stream = hexOf(hash.finish());
    }
    return {};
  }

  Status rewind() {
    if (Status rewound = a_.rewind(); !rewound) return rewound;
    return b_.rewind();
  }

  /// The first message, in the order of a, that both hold.
  Status align() {
    for (const auto& [key, channels] : streams_.by_key) {
      if (channels[0].empty() || channels[1].empty()) continue;
      if (Status rewound = rewind(); !rewound) return rewound;
      MessageMatch match(a_, b_, {channels[0], channels[1]});
      while (true) {
        const Result<std::optional<MessageMatch::Step>> step = match.next();
        if (!step) return step.error();
        if (!*step) break;
        if (!(*step)->a || !(*step)->b) continue;
        const Moment moment{(*step)->a->place.time, (*step)->b->place.time};
        if (!first_ || moment.a < first_->a) first_ = moment;
        break;
      }
    }
    if (first_) last_ = *first_;
    return {};
  }

  Nanoseconds errorOf(const Moment& moment) const {
    return std::chrono::abs((moment.b - first_->b) -
                            options_.speed.realDuration(moment.a - first_->a));
  }

  Status compare(const StreamKey& key, const std::array<std::vector<bool>, 2>& channels) {
    ReplaySource source;
    source.source = key.first;
    source.to = key.second;
    if (Status rewound = rewind(); !rewound) return rewound;
    MessageMatch match(a_, b_, {channels[0], channels[1]});
    Alone alone;
    LateHistogram errors;
    while (true) {
      const Result<std::optional<MessageMatch::Step>> step = match.next();
      if (!step) return step.error();
      if (!*step) break;
      const auto& [in_a, in_b] = **step;
      if (in_a && in_b) {
        ++source.same;
        const Moment moment{in_a->place.time, in_b->place.time};
        errors.add(errorOf(moment));
        if (moment.a >= last_.a) last_ = moment;
      } else if (in_a) {
        ++source.missing;
        alone.add(0, *in_a);
      } else {
        ++source.extra;
        alone.add(1, *in_b);
      }
    }
    source.out_of_order = alone.inBoth();
    source.missing -= source.out_of_order;
    source.extra -= source.out_of_order;
    source.messages_a = match.count(0);
    source.messages_b = match.count(1);
    source.error_p50_us = errors.percentile(0.5);
    source.error_p99_us = errors.percentile(0.99);
    source.error_max_us = errors.max();
    if (match.firstParting()) {
      source.differs = true;
      source.first_a = match.firstParting()->a;
      source.first_b = match.firstParting()->b;
    }
    diff_.sources.push_back(std::move(source));
    return {};
  }

  LogReader& a_;
  LogReader& b_;
  const ReplayOptions& options_;
  const std::function<void(double)>& progress_;
  Streams streams_;
  std::optional<Moment> first_;
  Moment last_;  ///< the last of both, in the order of a
  ReplayDiff diff_;
};

}  // namespace

bool ReplayDiff::same() const {
  return std::ranges::none_of(sources, [&](const ReplaySource& source) {
    const bool late = within && Nanoseconds(std::chrono::microseconds(source.error_max_us)) >
                                    *within + std::chrono::microseconds(1);
    return source.differs || late;
  });
}

bool ReplayDiff::otherSpeed() const {
  return measured_speed && std::abs(*measured_speed / speed - 1) > kOtherSpeed;
}

Result<ReplayDiff> diffReplay(LogReader& a, LogReader& b, const ReplayOptions& options,
                              const std::function<void(double)>& progress) {
  return Comparison(a, b, options, progress).run();
}

}  // namespace rocinante
