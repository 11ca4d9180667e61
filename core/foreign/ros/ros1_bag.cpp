#include <algorithm>

#include "core/base/figure_text.h"
#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/ros1_chunk.h"
#include "core/foreign/ros/ros1_record.h"
#include "core/log/damage_text.h"
#include "core/log/mapped_file.h"
#include "core/mcap/chunk_expander.h"

namespace rocinante::ros {
namespace {

/// Most damages that are reported one by one.
constexpr std::size_t kMaxDamages = 100;

/// Some writers leave a gap of zeros before the index.
bool onlyZeros(ByteView bytes) {
  return std::ranges::all_of(bytes, [](std::byte each) { return each == std::byte{0}; });
}

/// A bag of ROS 1, format 2.0, read from its beginning to its end: chunk after chunk, each in order
/// of time. The index at its end is used for the topics alone.
class Ros1Bag final : public BagReader {
 public:
  Ros1Bag(MappedFile mapped, ByteView bytes, std::string name)
      : mapped_(std::move(mapped)),
        bytes_(bytes.data() != nullptr ? bytes : mapped_.bytes()),
        is_mapped_(bytes.data() == nullptr),
        name_(std::move(name)),
        budget_(bytes_.size()) {}

  Status begin() {
    position_ = kRos1Magic.size();
    const std::optional<Ros1Record> first = ros1RecordAt(bytes_, position_);
    if (!first || first->op != Ros1Op::bag_header) {
      return Error{ErrorKind::damaged, "the bag has no bag header", name_};
    }
    position_ = first->end;
    const std::uint64_t index = first->number<std::uint64_t>("index_pos").value_or(0);
    if (index < position_ || index >= bytes_.size()) {
      damaged(first->offset, "the bag has no index: it was not closed");
      return {};
    }
    end_ = static_cast<std::size_t>(index);
    for (std::size_t at = end_; at < bytes_.size();) {
      const std::optional<Ros1Record> record = ros1RecordAt(bytes_, at);
      if (!record) {
        damaged(at, "the bag's index is cut short");
        break;
      }
      if (record->op == Ros1Op::connection) addConnection(*record);
      at = record->end;
    }
    return {};
  }

  std::string_view kind() const override { return "ros1-bag"; }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  double part() const override {
    return bytes_.empty() ? 1 : static_cast<double>(position_) / static_cast<double>(bytes_.size());
  }
  std::vector<std::string> damage() const override {
    std::vector<std::string> all = damage_;
    if (more_damage_ > 0)
      all.push_back(std::to_string(more_damage_) + " more damages (" + name_ + ")");
    return all;
  }

  Result<std::optional<BagMessage>> next() override {
    while (next_ == messages_.size()) {
      if (!readOn()) return std::optional<BagMessage>();
    }
    const Held& held = messages_[next_++];
    return std::optional(
        BagMessage{held.topic, held.sequence, held.time, nanosecondsOf(held.time), held.payload});
  }

  Result<std::optional<Bytes>> lastOf(std::size_t topic) override {
    Ros1Bag again(MappedFile(), bytes_, name_);
    if (Status begun = again.begin(); !begun) return begun.error();
    std::optional<Bytes> last;
    while (true) {
      const Result<std::optional<BagMessage>> message = again.next();
      if (!message) return message.error();
      if (!*message) return last;
      if ((*message)->topic != topic) continue;
      last.emplace((*message)->payload.begin(), (*message)->payload.end());
    }
  }

 private:
  struct Held {
    std::size_t topic = 0;
    std::uint32_t sequence = 0;
    LogTime time{};
    ByteView payload;
  };

  void damaged(std::size_t at, std::string_view what) {
    if (damage_.size() >= kMaxDamages) {
      ++more_damage_;
      return;
    }
    damage_.push_back(damageText(what, name_, at));
  }

  /// Reads the next chunk, or the next record outside one. False at the end.
  bool readOn() {
    messages_.clear();
    next_ = 0;
    const std::size_t end = end_ != 0 ? end_ : bytes_.size();
    if (position_ >= end) return false;
    const std::string rest = countText(end - position_, "byte");
    if (onlyZeros(bytes_.subspan(position_, end - position_))) {
      // A file system that lost its power has zeros in place of what was written last.
      if (end_ == 0) {
        damaged(position_, "no records follow: the last " + rest + " of the bag are zeros");
      }
      position_ = end;
      return false;
    }
    const std::optional<Ros1Record> record = wholeOrCutRos1RecordAt(bytes_.first(end), position_);
    if (!record || (record->is_cut && record->op != Ros1Op::chunk)) {
      damaged(position_,
              "the bag ends inside a record, or its lengths are wrong: " + rest + " are not read");
      position_ = end;
      return false;
    }
    position_ = record->end;
    if (record->op == Ros1Op::chunk) {
      readChunk(*record);
    } else {
      take(*record, record->offset);
    }
    const auto earlier = [](const Held& a, const Held& b) { return a.time < b.time; };
    std::ranges::stable_sort(messages_, earlier);
    for (Held& held : messages_) held.sequence = sequences_[held.topic]++;
    return true;
  }

  void readChunk(const Ros1Record& record) {
    if (is_mapped_ && !mapped_.whole()) {
      return damaged(record.offset, "the bag became shorter while it was read");
    }
    Result<ByteView> records =
        record.is_cut ? recordsOfCut(record) : expandRos1Chunk(record, budget_, scratch_);
    if (!records) return damaged(record.offset, records.error().what);
    for (std::size_t at = 0; at < records->size();) {
      const std::optional<Ros1Record> inner = ros1RecordAt(*records, at);
      if (!inner && record.is_cut) return;  // that was told
      if (!inner) return damaged(record.offset, "a record reaches past the end of its chunk");
      take(*inner, record.offset);
      at = inner->end;
    }
  }

  /// Without compression the records that are whole can be read.
  Result<ByteView> recordsOfCut(const Ros1Record& chunk) {
    const auto compression = chunk.field("compression");
    if (!compression || textOf(*compression) != "none") {
      return Error{ErrorKind::damaged, "the bag ends inside a compressed chunk, which is lost", {}};
    }
    damaged(chunk.offset, "the bag ends inside a chunk: read up to there");
    return chunk.data;
  }

  void take(const Ros1Record& record, std::size_t place) {
    if (record.op == Ros1Op::connection) return addConnection(record);
    if (record.op != Ros1Op::message) return;
    const auto connection = record.number<std::uint32_t>("conn");
    const auto time = record.number<std::uint64_t>("time");
    if (!connection || !time) return damaged(place, "a message has no connection or no time");
    const auto topic = by_connection_.find(*connection);
    if (topic == by_connection_.end()) {
      return damaged(place, "a message is of a connection that the bag does not describe");
    }
    const std::uint64_t seconds = *time & 0xFFFFFFFFU;
    const std::uint64_t ns = seconds * 1'000'000'000 + (*time >> 32U);
    messages_.push_back(
        {topic->second, 0, LogTime(Nanoseconds(static_cast<std::int64_t>(ns))), record.data});
  }

  void addConnection(const Ros1Record& record) {
    const auto connection = record.number<std::uint32_t>("conn");
    const auto topic_name = record.field("topic");
    if (!connection || !topic_name || by_connection_.contains(*connection)) return;
    if (topics_.size() >= kMaxBagTopics)
      return damaged(record.offset, "the bag has too many topics");
    BagTopic topic;
    topic.name = textOf(*topic_name);
    topic.encoding = "ros1";
    const auto fields = ros1Fields(record.data);
    const auto text = [&](std::string_view name) {
      const auto found = ros1Field(fields, name);
      return found ? std::string(textOf(*found)) : std::string();
    };
    topic.type = text("type");
    for (const char* const key : {"callerid", "latching", "md5sum"}) {
      if (std::string value = text(key); !value.empty()) topic.metadata[key] = std::move(value);
    }
    const std::string definition = text("message_definition");
    const ByteView bytes = bytesOf(definition);
    topic.schema = std::make_shared<const LogSchema>(
        LogSchema{topic.type, "ros1msg", Bytes(bytes.begin(), bytes.end())});
    by_connection_.emplace(*connection, topics_.size());
    topics_.push_back(std::move(topic));
    sequences_.push_back(0);
  }

  MappedFile mapped_;
  ByteView bytes_;
  bool is_mapped_;
  std::string name_;
  std::size_t position_ = 0;
  std::size_t end_ = 0;  ///< of the chunks, where the index begins; 0: there is none
  mcap::ExpansionBudget budget_;
  mcap::Scratch scratch_;
  std::vector<BagTopic> topics_;
  std::vector<std::uint32_t> sequences_;
  std::map<std::uint32_t, std::size_t> by_connection_;
  std::vector<Held> messages_;  ///< of the last chunk
  std::size_t next_ = 0;
  std::vector<std::string> damage_;
  std::uint64_t more_damage_ = 0;
};

Result<std::unique_ptr<BagReader>> begun(std::unique_ptr<Ros1Bag> bag) {
  if (Status started = bag->begin(); !started) return started.error();
  return std::unique_ptr<BagReader>(std::move(bag));
}

}  // namespace

Result<std::unique_ptr<BagReader>> openRos1Bag(const std::filesystem::path& path) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  return begun(std::make_unique<Ros1Bag>(std::move(*file), ByteView(), path.string()));
}

Result<std::unique_ptr<BagReader>> openRos1Bytes(ByteView bytes, std::string name) {
  return begun(std::make_unique<Ros1Bag>(MappedFile(), bytes, std::move(name)));
}

}  // namespace rocinante::ros
