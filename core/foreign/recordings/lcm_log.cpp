#include "core/foreign/recordings/lcm_log.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/foreign/recordings/recording_bytes.h"
#include "core/log/damage_text.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kSync = 0xEDA1DA01;
/// Sync word, event number, time, length of the channel's name, length of the data; big-endian.
constexpr std::size_t kEventHead = 28;
/// LCM's own limit (LCM_MAX_CHANNEL_NAME_LENGTH).
constexpr std::size_t kMaxChannelName = 63;
constexpr std::size_t kMaxEventBytes = std::size_t{256} << 20;
constexpr std::int64_t kMaxMicroseconds = std::numeric_limits<std::int64_t>::max() / 1000;
/// Sentences about damage; the rest is counted.
constexpr std::size_t kMaxSentences = 20;

struct LcmHead {
  std::uint64_t number = 0;
  std::int64_t time_us = 0;
  std::size_t name_bytes = 0, data_bytes = 0;
};

template <class T>
T bigEndianAt(ByteView bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value = static_cast<T>(value << 8U | static_cast<std::uint8_t>(bytes[at + i]));
  }
  return value;
}

/// The head of an event, if it can be one. `head` has at least kEventHead bytes.
std::optional<LcmHead> lcmHead(ByteView head) {
  if (bigEndianAt<std::uint32_t>(head, 0) != kSync) return std::nullopt;
  LcmHead found;
  found.number = bigEndianAt<std::uint64_t>(head, 4);
  found.time_us = static_cast<std::int64_t>(bigEndianAt<std::uint64_t>(head, 12));
  const auto name = static_cast<std::int32_t>(bigEndianAt<std::uint32_t>(head, 20));
  const auto data = static_cast<std::int32_t>(bigEndianAt<std::uint32_t>(head, 24));
  if (name <= 0 || static_cast<std::size_t>(name) > kMaxChannelName || data < 0 ||
      static_cast<std::size_t>(data) > kMaxEventBytes) {
    return std::nullopt;
  }
  found.name_bytes = static_cast<std::size_t>(name);
  found.data_bytes = static_cast<std::size_t>(data);
  return found;
}

class LcmLog final : public ros::BagReader {
 public:
  LcmLog(RecordingBytes bytes, std::string name)
      : bytes_(std::move(bytes)), name_(std::move(name)) {}

  std::string_view kind() const override { return "lcm"; }
  const std::vector<ros::BagTopic>& topics() const override { return topics_; }
  double part() const override {
    return bytes_.size() == 0 ? 1 : static_cast<double>(at_) / static_cast<double>(bytes_.size());
  }
  std::vector<std::string> damage() const override {
    std::vector<std::string> sentences = damage_;
    if (more_damage_ > 0) {
      sentences.push_back(countText(more_damage_, "more damaged place") + " (" + name_ + ")");
    }
    return sentences;
  }
  Result<std::optional<Bytes>> lastOf(std::size_t) override { return std::optional<Bytes>(); }

  Result<std::optional<ros::BagMessage>> next() override {
    while (at_ < bytes_.size()) {
      if (std::optional<ros::BagMessage> message = event()) return message;
    }
    return std::optional<ros::BagMessage>();
  }

 private:
  std::optional<ros::BagMessage> event() {
    std::byte raw[kEventHead];
    const std::optional<LcmHead> head =
        bytes_.read(at_, raw) ? lcmHead(raw) : std::optional<LcmHead>();
    if (!head) {
      resync("no event begins here");
      return std::nullopt;
    }
    const std::size_t whole = kEventHead + head->name_bytes + head->data_bytes;
    if (whole > bytes_.size() - at_) {
      resync("an event is cut");
      return std::nullopt;
    }
    body_.resize(head->name_bytes + head->data_bytes);
    if (!bytes_.read(at_ + kEventHead, body_)) {
      tell("the file has become shorter", at_, bytes_.size());
      at_ = bytes_.size();
      return std::nullopt;
    }
    at_ += whole;
    const ByteView payload = ByteView(body_).subspan(head->name_bytes);
    ros::BagMessage message;
    const auto topic = topicOf(textOf(ByteView(body_).first(head->name_bytes)), payload);
    if (!topic) return std::nullopt;
    message.topic = *topic;
    message.sequence = static_cast<std::uint32_t>(head->number);
    // Beyond what a log holds: the import counts it as left out.
    const bool fits = head->time_us <= kMaxMicroseconds && head->time_us >= -kMaxMicroseconds;
    message.publish_time_ns = fits ? head->time_us * 1000 : std::int64_t{-1};
    message.log_time = LogTime(Nanoseconds(message.publish_time_ns));
    message.payload = payload;
    return message;
  }

  std::optional<std::size_t> topicOf(std::string_view channel, ByteView payload) {
    const auto known = by_name_.find(channel);
    if (known != by_name_.end()) return known->second;
    if (topics_.size() == ros::kMaxBagTopics) {
      tell("events of further channels are left out", at_, at_);
      return std::nullopt;
    }
    ros::BagTopic topic;
    topic.name = isUtf8(bytesOf(channel)) ? std::string(channel) : plainText(channel);
    topic.encoding = textOf(payload).starts_with("RK1 ") ? "rk1" : "lcm";
    topics_.push_back(std::move(topic));
    by_name_.emplace(channel, topics_.size() - 1);
    return topics_.size() - 1;
  }

  /// Goes to the next head that can be one, or to the end.
  void resync(const char* why) {
    const std::size_t from = at_;
    constexpr std::size_t kWindow = std::size_t{64} << 10;
    Bytes window;
    for (std::size_t begin = at_ + 1; begin + kEventHead <= bytes_.size();) {
      window.resize(std::min(kWindow, bytes_.size() - begin));
      if (!bytes_.read(begin, window)) break;
      for (std::size_t i = 0; i + kEventHead <= window.size(); ++i) {
        if (window[i] == std::byte{0xED} && lcmHead(ByteView(window).subspan(i, kEventHead))) {
          at_ = begin + i;
          tell(why, from, at_);
          return;
        }
      }
      begin += window.size() - kEventHead + 1;
    }
    at_ = bytes_.size();
    tell(why, from, at_);
  }

  void tell(const char* what, std::size_t from, std::size_t until) {
    if (damage_.size() == kMaxSentences) {
      ++more_damage_;
      return;
    }
    std::string sentence = what;
    if (until > from) sentence += ": " + countText(until - from, "byte") + " skipped";
    damage_.push_back(damageText(sentence, name_, from));
  }

  RecordingBytes bytes_;
  std::string name_;
  std::size_t at_ = 0;
  Bytes body_;  ///< the channel's name and the data of the last event
  std::vector<ros::BagTopic> topics_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<std::string> damage_;
  std::uint64_t more_damage_ = 0;
};

}  // namespace

bool looksLikeLcm(ByteView first_bytes) {
  return first_bytes.size() >= kEventHead && lcmHead(first_bytes).has_value();
}

Result<std::unique_ptr<ros::BagReader>> openLcmLog(const std::filesystem::path& path) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  return std::unique_ptr<ros::BagReader>(
      std::make_unique<LcmLog>(RecordingBytes(std::move(*file)), path.string()));
}

Result<std::unique_ptr<ros::BagReader>> openLcmBytes(ByteView bytes, std::string name) {
  return std::unique_ptr<ros::BagReader>(
      std::make_unique<LcmLog>(RecordingBytes(bytes), std::move(name)));
}

}  // namespace rocinante
