#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/ros/field_cursor.h"
#include "core/foreign/ros/ros_translator.h"
#include "core/log/log_types.h"
#include "core/log/log_writer.h"
#include "core/report/account.h"

namespace rocinante::ros {

/// What something beside them says of the messages of some inputs of an import, which follow each
/// other.
struct StatedMessages {
  std::size_t first = 0, inputs = 1;
  std::optional<std::uint64_t> count;
  std::string name;         ///< of them together: "bag_0.db3", "the bag"
  std::string where;        ///< who says it: " (bag/metadata.yaml)"
  std::string compression;  ///< of each message, one that is not read; empty: none
};

class DeviceFinder;

/// Most topics of a bag. Two channels of each must fit into a log.
inline constexpr std::size_t kMaxBagTopics = 32000;

/// A topic of a bag, with all that is known of its messages.
struct BagTopic {
  std::string name;
  std::string type;      ///< "sensor_msgs/msg/JointState"; empty when the bag does not say
  std::string encoding;  ///< "cdr", "ros1", or any other
  std::map<std::string, std::string> metadata;
  std::shared_ptr<const LogSchema> schema;  ///< null: none
  /// Decoder name, if the reader makes the packets; empty: RosTranslator, where it knows the type.
  std::string decoder;

  /// Empty for messages that are neither CDR nor of ROS 1.
  std::optional<FieldCursor::Layout> layout() const;
};

/// A message of a bag. The payload is borrowed until the next call on the reader.
struct BagMessage {
  std::size_t topic = 0;  ///< into BagReader::topics()
  std::uint32_t sequence = 0;
  LogTime log_time{};
  std::int64_t publish_time_ns = 0;
  ByteView payload;
  /// Of a topic with a decoder: its packet text, borrowed like the payload; empty: there is none.
  std::string_view packet = {};
  /// Where and why it does not have the form of its topic; borrowed; empty: it has.
  std::string_view fault = {};
};

/// Reads the messages of another program's recording. Memory does not grow with the file. Not for
/// sharing between threads.
class BagReader {
 public:
  virtual ~BagReader() = default;

  /// Of the metadata `imported`: "ros2-mcap", "ros2-sqlite", "ros1-bag", "lcm", "csv", "json".
  virtual std::string_view kind() const = 0;
  /// May grow while messages are read, never changes.
  virtual const std::vector<BagTopic>& topics() const = 0;
  /// The next message, in order of time as far as the file has it. Empty at the end. Damage is not
  /// an error: it is skipped and listed by damage().
  virtual Result<std::optional<BagMessage>> next() = 0;
  /// The last message of a topic, whatever was read; empty when there is none.
  virtual Result<std::optional<Bytes>> lastOf(std::size_t topic) = 0;
  /// How much of the file was read, 0 to 1.
  virtual double part() const = 0;
  /// What could not be used so far, as sentences with the file's name.
  virtual std::vector<std::string> damage() const = 0;
  /// What became neither a message nor a packet; valid after the last message.
  virtual Account account() const { return {}; }
  /// Copies what the file holds beside messages.
  virtual Status copyExtras(LogWriter&) { return {}; }
  /// For those that make packets themselves: the devices that names belong to. Called once, before
  /// any message; borrowed.
  virtual void useDevices(const DeviceFinder&) {}
  /// Reasons for messages not or partly translated, with counts.
  virtual TranslationNotes notesOf(std::size_t) const { return {}; }
  /// The moment that the log's times are shown from; empty: its first message.
  virtual std::optional<LogTime> origin() const { return std::nullopt; }
};

/// The kinds of files that their first bytes show.
enum class BagKind : std::uint8_t { none, mcap, sqlite, ros1 };
BagKind bagKindOf(ByteView first_bytes);

/// Opens a bag of any kind, told by its content. bad_argument for a log of our own, unsupported for
/// what is none of them or for a kind that this build cannot read; damaged when nothing can be
/// read.
Result<std::unique_ptr<BagReader>> openBag(const std::filesystem::path& path);

/// One kind each. The bytes must outlive the reader.
Result<std::unique_ptr<BagReader>> openMcapBag(const std::filesystem::path& path);
Result<std::unique_ptr<BagReader>> openMcapBytes(ByteView bytes, std::string name);
Result<std::unique_ptr<BagReader>> openSqliteBag(const std::filesystem::path& path);
Result<std::unique_ptr<BagReader>> openRos1Bag(const std::filesystem::path& path);
Result<std::unique_ptr<BagReader>> openRos1Bytes(ByteView bytes, std::string name);

}  // namespace rocinante::ros
