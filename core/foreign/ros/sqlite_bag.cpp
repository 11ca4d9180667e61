#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/base/plain_text.h"
#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/expanded_messages.h"

namespace rocinante::ros {
namespace {

/// Most bytes of one value; the schema of a bag and its messages are far smaller.
constexpr int kMaxValueBytes = 256 << 20;
/// Memory for pages that were read, in KiB.
constexpr const char* kPragmas =
    "PRAGMA query_only=1; PRAGMA trusted_schema=0; PRAGMA cell_size_check=1; "
    "PRAGMA cache_size=-8192; PRAGMA mmap_size=0; PRAGMA temp_store=1;";

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct FinishStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Query = std::unique_ptr<sqlite3_stmt, FinishStatement>;

std::string textAt(sqlite3_stmt* row, int column) {
  const unsigned char* const text = sqlite3_column_text(row, column);
  const int bytes = sqlite3_column_bytes(row, column);
  if (text == nullptr || bytes <= 0) return {};
  return std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes));
}

/// A closed bag is opened as immutable: no lock, and no file beside it. Where the writer was
/// killed, its newest messages are in the journal beside it.
std::string uriOf(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char byte : path.string()) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    if (byte == '?' || byte == '#' || byte == '%') {
      uri += '%';
      uri += kDigits[value >> 4U];
      uri += kDigits[value & 15U];
    } else {
      uri += byte;
    }
  }
  std::error_code none;
  const auto journal_bytes = std::filesystem::file_size(path.string() + "-wal", none);
  const bool has_journal = !none && journal_bytes > 0;
  return uri + (has_journal ? "?mode=ro" : "?mode=ro&immutable=1");
}

/// Whether the file is shorter than its head says. SQLite itself only notices when it needs a page
/// that is gone.
bool isCut(const std::filesystem::path& path) {
  std::array<unsigned char, 100> head{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(head.data()), head.size())) return false;
  const auto bigEndian = [&](std::size_t at, std::size_t bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i) number = number << 8U | head[at + i];
    return number;
  };
  // The count of pages is believed only when its writer set it.
  if (bigEndian(24, 4) != bigEndian(92, 4)) return false;
  const std::uint64_t page_bytes = bigEndian(16, 2) == 1 ? 65536 : bigEndian(16, 2);
  std::error_code none;
  const std::uint64_t size = std::filesystem::file_size(path, none);
  return !none && size < page_bytes * bigEndian(28, 4);
}

/// A bag of rosbag2's sqlite3 storage: the tables `topics` and `messages`.
class SqliteBag final : public BagReader {
 public:
  SqliteBag(Database database, std::string name)
      : database_(std::move(database)), name_(std::move(name)) {}

  std::string_view kind() const override { return "ros2-sqlite"; }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  double part() const override {
    return total_ == 0 ? 0
                       : std::min(1.0, static_cast<double>(seen_) / static_cast<double>(total_));
  }
  std::vector<std::string> damage() const override { return damage_; }

  Status begin() {
    if (isCut(name_)) damage_.push_back("the file is shorter than its head says (" + name_ + ")");
    if (Status tables = checkTables(); !tables) return tables;
    if (Status read = readTopics(); !read) return read;
    Result<Query> count = prepare("SELECT max(rowid) FROM messages");
    if (!count) return count.error();
    if (sqlite3_step(count->get()) == SQLITE_ROW) {
      total_ = static_cast<std::uint64_t>(
          std::max<sqlite3_int64>(0, sqlite3_column_int64(count->get(), 0)));
    }
    // The index on timestamp that rosbag2 makes gives this order without sorting.
    Result<Query> messages =
        prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, rowid");
    if (!messages) return messages.error();
    messages_ = std::move(*messages);
    return {};
  }

  Result<std::optional<BagMessage>> next() override {
    while (messages_ != nullptr) {
      const int step = sqlite3_step(messages_.get());
      if (step != SQLITE_ROW) {
        if (step != SQLITE_DONE) {
          damage_.push_back(std::string("reading stopped after ") + std::to_string(seen_) +
                            " messages: " + sqlite3_errmsg(database_.get()) + " (" + name_ + ")");
        }
        messages_.reset();
        break;
      }
      ++seen_;
      if (std::optional<BagMessage> message = taken()) return message;
    }
    return std::optional<BagMessage>();
  }

  Result<std::optional<Bytes>> lastOf(std::size_t topic) override {
    Result<Query> query = prepare(
        "SELECT data FROM messages WHERE topic_id = ? ORDER BY timestamp DESC, rowid DESC LIMIT 1");
    if (!query) return query.error();
    for (const auto& [id, number] : by_id_) {
      if (number == topic) sqlite3_bind_int64(query->get(), 1, id);
    }
    if (sqlite3_step(query->get()) != SQLITE_ROW) return std::optional<Bytes>();
    const ByteView data = blobAt(query->get(), 0);
    return std::optional(Bytes(data.begin(), data.end()));
  }

 private:
  Error fault(const std::string& what) const {
    return Error{ErrorKind::damaged, what + ": " + sqlite3_errmsg(database_.get()), name_};
  }

  Result<Query> prepare(const char* text) {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database_.get(), text, -1, &made, nullptr) != SQLITE_OK) {
      return fault("this SQLite file is not a ROS 2 bag");
    }
    return Query(made);
  }

  static ByteView blobAt(sqlite3_stmt* row, int column) {
    const void* const data = sqlite3_column_blob(row, column);
    const int bytes = sqlite3_column_bytes(row, column);
    if (data == nullptr || bytes <= 0) return {};
    return {static_cast<const std::byte*>(data), static_cast<std::size_t>(bytes)};
  }

  /// A view can have rows without end.
  Status checkTables() {
    Result<Query> others = prepare(
        "SELECT name FROM sqlite_master WHERE type <> 'table' AND "
        "name COLLATE NOCASE IN ('topics', 'messages', 'message_definitions')");
    if (!others) return others.error();
    if (sqlite3_step(others->get()) != SQLITE_ROW) return {};
    return Error{ErrorKind::damaged,
                 "this SQLite file is not a ROS 2 bag: its " + plainText(textAt(others->get(), 0)) +
                     " is not a table",
                 name_};
  }

  Status readTopics() {
    Result<Query> query = prepare("SELECT * FROM topics ORDER BY id");
    if (!query) return query.error();
    sqlite3_stmt* const row = query->get();
    const auto column = [&](std::string_view wanted) {
      for (int i = 0; i < sqlite3_column_count(row); ++i) {
        if (sqlite3_column_name(row, i) == wanted) return i;
      }
      return -1;
    };
    const int id = column("id"), name = column("name"), type = column("type");
    const int format = column("serialization_format"), qos = column("offered_qos_profiles");
    if (id < 0 || name < 0 || type < 0 || format < 0) {
      return Error{ErrorKind::damaged,
                   "this SQLite file is not a ROS 2 bag: its table of topics lacks a column",
                   name_};
    }
    int step = sqlite3_step(row);
    for (; step == SQLITE_ROW && topics_.size() < kMaxBagTopics; step = sqlite3_step(row)) {
      BagTopic topic;
      topic.name = textAt(row, name);
      topic.type = textAt(row, type);
      topic.encoding = textAt(row, format);
      if (qos >= 0 && !textAt(row, qos).empty()) {
        topic.metadata["offered_qos_profiles"] = textAt(row, qos);
      }
      topic.schema = schemaOf(topic.type);
      by_id_.emplace(sqlite3_column_int64(row, id), topics_.size());
      topics_.push_back(std::move(topic));
      sequences_.push_back(0);
    }
    if (step != SQLITE_DONE) return fault("the topics of the bag cannot be read");
    return {};
  }

  /// Older bags have no definitions: then the name alone says what the bytes mean.
  std::shared_ptr<const LogSchema> schemaOf(const std::string& type) {
    LogSchema schema{type, "", {}};
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database_.get(),
                           "SELECT encoding, encoded_message_definition FROM message_definitions "
                           "WHERE topic_type = ?",
                           -1, &made, nullptr) == SQLITE_OK) {
      const Query query(made);
      sqlite3_bind_text(made, 1, type.data(), static_cast<int>(type.size()), SQLITE_TRANSIENT);
      if (sqlite3_step(made) == SQLITE_ROW && !textAt(made, 0).empty()) {
        schema.encoding = textAt(made, 0);
        const std::string definition = textAt(made, 1);
        const ByteView bytes = bytesOf(definition);
        schema.data.assign(bytes.begin(), bytes.end());
      }
    }
    return std::make_shared<const LogSchema>(std::move(schema));
  }

  std::optional<BagMessage> taken() {
    sqlite3_stmt* const row = messages_.get();
    const auto topic = by_id_.find(sqlite3_column_int64(row, 0));
    const sqlite3_int64 time = sqlite3_column_int64(row, 1);
    if (topic == by_id_.end()) {
      tellOnce(no_topic_, "messages of topics that the bag does not list are left out");
      return std::nullopt;
    }
    BagMessage message;
    message.topic = topic->second;
    message.sequence = sequences_[topic->second]++;
    message.log_time = LogTime(Nanoseconds(time));
    message.publish_time_ns = time;
    message.payload = blobAt(row, 2);
    return message;
  }

  void tellOnce(bool& is_reported, const char* sentence) {
    if (!is_reported) damage_.push_back(std::string(sentence) + " (" + name_ + ")");
    is_reported = true;
  }

  Database database_;
  Query messages_;  // after the database: it is finished first
  std::string name_;
  std::vector<BagTopic> topics_;
  std::vector<std::uint32_t> sequences_;
  std::map<sqlite3_int64, std::size_t> by_id_;
  std::uint64_t total_ = 0, seen_ = 0;
  std::vector<std::string> damage_;
  bool no_topic_ = false;
};

}  // namespace

Result<std::unique_ptr<BagReader>> openSqliteBag(const std::filesystem::path& path) {
  sqlite3* opened = nullptr;
  const int status =
      sqlite3_open_v2(uriOf(path).c_str(), &opened,
                      SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_URI, nullptr);
  Database database(opened);
  if (status != SQLITE_OK) {
    return Error{ErrorKind::unreadable,
                 std::string("the bag cannot be opened: ") + sqlite3_errstr(status), path.string()};
  }
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (sqlite3_exec(opened, kPragmas, nullptr, nullptr, nullptr) != SQLITE_OK) {
    return Error{ErrorKind::damaged,
                 std::string("the bag cannot be read: ") + sqlite3_errmsg(opened), path.string()};
  }
  auto bag = std::make_unique<SqliteBag>(std::move(database), path.string());
  if (Status begun = bag->begin(); !begun) return begun.error();
  std::error_code none;
  const std::uint64_t file_bytes = std::filesystem::file_size(path, none);
  return withExpandedMessages(std::move(bag), none ? 0 : file_bytes);
}

}  // namespace rocinante::ros
