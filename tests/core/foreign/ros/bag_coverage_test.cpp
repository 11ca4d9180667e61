// Every number of every message of the real bags has a place: in the packet made of the message, or
// in the import's account. The messages are read by the definitions that the bags carry, by no line
// of the code under test but the cursor.

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "core/foreign/ros/bag_import.h"
#include "core/packet/packet_text.h"
#include "tests/core/log/log_support.h"
#include "tests/support/shared_data.h"

namespace rocinante::ros::test {
namespace {

using rocinante::test::openLog;
using rocinante::test::sharedData;

struct DefinedField {
  std::string type, name;
  bool is_array = false;
  std::size_t length = 0;  ///< 0 of an array: in the message
};
using Definitions = std::map<std::string, std::vector<DefinedField>>;

/// "pkg/Type" of "pkg/msg/Type".
std::string shortName(std::string name) {
  if (const std::size_t kind = name.find("/msg/"); kind != name.npos) name.erase(kind, 4);
  return name;
}

/// A definition as bags carry it: that of the type, and behind lines of `=` those that it needs.
Definitions definitionsIn(const std::string& type, const std::string& text) {
  Definitions all;
  std::string current = shortName(type);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.find('#'));
    std::istringstream words(line);
    std::string kind, name, more;
    words >> kind >> name >> more;
    if (kind.starts_with("====")) continue;
    if (kind == "MSG:") {
      current = shortName(name);
      continue;
    }
    const bool is_constant = name.find('=') != name.npos || more.starts_with('=');
    if (kind.empty() || name.empty() || is_constant) continue;
    DefinedField field;
    const std::size_t bracket = kind.find('[');
    field.type = kind.substr(0, kind.find_first_of("[<"));
    field.name = name;
    if (bracket != kind.npos) {
      field.is_array = true;
      const bool is_fixed = isdigit(static_cast<unsigned char>(kind[bracket + 1])) != 0;
      if (is_fixed) field.length = std::stoul(kind.substr(bracket + 1));
    }
    all[current].push_back(field);
  }
  return all;
}

/// Of the bag of sqlite3 whose table of definitions is younger than it.
const std::map<std::string, const char*> kKnownDefinitions = {
    {"geometry_msgs/PoseStamped", "Header header\nfloat64[3] position\nfloat64[4] orientation\n"},
    {"sensor_msgs/Imu",
     "Header header\nQuaternion orientation\nfloat64[9] orientation_covariance\n"
     "Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
     "Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n====\n"
     "MSG: sensor_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n====\n"
     "MSG: sensor_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"},
    {"sensor_msgs/BatteryState",
     "Header header\nfloat32 voltage\nfloat32 temperature\nfloat32 current\nfloat32 "
     "charge\nfloat32 capacity\n"
     "float32 design_capacity\nfloat32 percentage\nuint8 power_supply_status\n"
     "uint8 power_supply_health\nuint8 power_supply_technology\nbool present\n"
     "float32[] cell_voltage\nfloat32[] cell_temperature\nstring location\nstring serial_number\n"},
};

/// The numbers of a message by their paths, "angular_velocity.x", "cell_voltage.0". Not those of
/// headers: the stamp is the packet's TIME, and the counter of ROS 1 the recording's order.
class NumbersOfMessage {
 public:
  NumbersOfMessage(const Definitions& all, std::string type, ByteView message,
                   FieldCursor::Layout layout)
      : all_(all), cursor_(message, layout) {
    read(std::move(type), "");
    EXPECT_TRUE(cursor_.atEnd());
  }
  std::map<std::string, double> numbers;

 private:
  void read(const std::string& type, const std::string& path) {
    if (type == "Header" || type == "std_msgs/Header") {
      readHeader(cursor_);
    } else if (type == "string") {
      cursor_.string();
    } else if (const auto number = primitive(type)) {
      numbers[path] = *number;
    } else {
      const std::string package = type_in_.substr(0, type_in_.find('/') + 1);
      const std::string whole = type.find('/') == type.npos ? package + type : shortName(type);
      const auto found = all_.find(type_in_.empty() ? type : whole);
      ASSERT_NE(found, all_.end()) << type;
      const std::string before = std::exchange(type_in_, found->first);
      for (const DefinedField& field : found->second) readField(field, path);
      type_in_ = before;
    }
  }

  void readField(const DefinedField& field, const std::string& path) {
    const std::string name = path.empty() ? field.name : path + "." + field.name;
    if (!field.is_array) return read(field.type, name);
    const std::size_t count = field.length > 0 ? field.length : cursor_.count(1);
    for (std::size_t i = 0; i < count; ++i) read(field.type, name + "." + std::to_string(i));
  }

  std::optional<double> primitive(const std::string& type) {
    if (type == "bool" || type == "uint8" || type == "byte" || type == "char") {
      return cursor_.number<std::uint8_t>();
    }
    if (type == "int8") return cursor_.number<std::int8_t>();
    if (type == "int16") return cursor_.number<std::int16_t>();
    if (type == "uint16") return cursor_.number<std::uint16_t>();
    if (type == "int32") return cursor_.number<std::int32_t>();
    if (type == "uint32") return cursor_.number<std::uint32_t>();
    if (type == "int64") return static_cast<double>(cursor_.number<std::int64_t>());
    if (type == "uint64") return static_cast<double>(cursor_.number<std::uint64_t>());
    if (type == "float32") return static_cast<double>(cursor_.number<float>());
    if (type == "float64") return cursor_.number<double>();
    return std::nullopt;
  }

  const Definitions& all_;
  FieldCursor cursor_;
  std::string type_in_;
};

/// What the packet of a message states.
struct Stated {
  std::map<std::string, double> signals;  ///< by NAME
  std::map<std::string, double> joints;   ///< by place, as text
  bool has_pose = false;
};

Stated statedBy(std::string_view text) {
  Stated stated;
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(text));
  if (packet == nullptr) return stated;
  for (const Statement& statement : packet->statements) {
    stated.has_pose = stated.has_pose || statement.kind == StatementKind::pose;
    for (std::size_t i = 0; i < statement.names.size(); ++i) {
      if (statement.kind == StatementKind::joint) {
        stated.joints[std::to_string(i)] = statement.numbers[i];
      } else {
        stated.signals[std::string(statement.names[i])] = statement.numbers[i];
      }
    }
  }
  return stated;
}

/// Whether the number is in the packet, by the same name and value.
bool isStated(const Stated& stated, const std::string& path, double value) {
  const std::size_t dot = path.rfind('.');
  const std::string last = path.substr(dot + 1);
  if (path.starts_with("position.") && !stated.joints.empty()) {
    const auto joint = stated.joints.find(last);
    return joint != stated.joints.end() && joint->second == value;
  }
  if (path.starts_with("velocity.") || path.starts_with("effort.")) {
    const std::string ending = "." + path.substr(0, dot);
    std::size_t with_value = 0;
    for (const auto& [name, number] : stated.signals) {
      with_value += name.ends_with(ending) && number == value ? 1 : 0;
    }
    return with_value > 0;
  }
  if (path.starts_with("position.") || path.starts_with("orientation.")) {
    if (stated.has_pose) return true;
  }
  for (const auto& [name, number] : stated.signals) {
    if (!name.ends_with("." + path) && path != "data") continue;
    // A state is in words.
    if (number == value || path.find("power_supply") == 0) return true;
  }
  return false;
}

bool isAccounted(const Account& account, const std::string& topic, const std::string& path) {
  for (const LeftOut& one : account.leftOut()) {
    if (one.kind == "topic" && one.name == topic) return true;
    if (one.kind == "value" && path.find(one.name) != path.npos) return true;
  }
  return false;
}

TEST(BagCoverage, EveryNumberOfTheRealBagsHasAPlace) {
  ROCINANTE_NEEDS_SHARED_DATA("bags");
  std::size_t seen = 0;
  std::set<std::string> types;
  for (const auto& entry : std::filesystem::directory_iterator(sharedData("bags"))) {
    if (!entry.is_regular_file()) continue;
    SCOPED_TRACE(entry.path().filename().string());
    Result<std::unique_ptr<BagReader>> bag = openBag(entry.path());
    if (!bag && bag.error().kind == ErrorKind::unsupported) continue;
    ASSERT_TRUE(bag.ok()) << bag.error().text();
    std::vector<std::unique_ptr<BagReader>> bags;
    bags.push_back(std::move(*bag));
    Bytes log;
    const auto report = importBags(std::move(bags), makeMemorySink(log), "session", {});
    ASSERT_TRUE(report.ok()) << report.error().text();
    std::set<std::string> with_packets;
    for (const ImportedTopic& topic : report->topics) {
      if (topic.packets > 0) {
        with_packets.insert(topic.name);
      } else {
        EXPECT_TRUE(isAccounted(report->account, topic.name, "")) << topic.name;
      }
    }
    std::map<std::string, Definitions> definitions;
    LogReader reader = openLog(log);
    std::optional<NumbersOfMessage> numbers;
    std::string topic;
    while (true) {
      const Result<std::optional<LogMessage>> next = reader.next();
      ASSERT_TRUE(next.ok());
      const bool is_packet = *next && (*next)->channel->topic == "/rocinante/decoded" + topic;
      if (numbers) {
        const Stated stated = is_packet ? statedBy(textOf((*next)->payload)) : Stated();
        for (const auto& [path, value] : numbers->numbers) {
          // Zeros say of a covariance that it is not known.
          const bool is_none = value == 0 && path.find("covariance") != path.npos;
          EXPECT_TRUE(is_none || isStated(stated, path, value) ||
                      isAccounted(report->account, topic, path))
              << topic << " " << path << " " << value;
          ++seen;
        }
        numbers.reset();
      }
      if (!*next) break;
      const LogChannel& channel = *(*next)->channel;
      if (is_packet || !with_packets.contains(channel.topic)) continue;
      topic = channel.topic;
      ASSERT_NE(channel.schema, nullptr);
      const std::string type = shortName(channel.schema->name);
      types.insert(type);
      if (!definitions.contains(type)) {
        const auto known = kKnownDefinitions.find(type);
        const std::string text(channel.schema->data.empty() && known != kKnownDefinitions.end()
                                   ? known->second
                                   : textOf(channel.schema->data));
        definitions[type] = definitionsIn(type, text);
      }
      const bool is_ros1 = channel.encoding == "ros1";
      numbers.emplace(definitions[type], type, (*next)->payload,
                      is_ros1 ? FieldCursor::Layout::ros1 : FieldCursor::Layout::cdr);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(seen, 100'000U);
  EXPECT_GE(types.size(), 5U);
}

}  // namespace
}  // namespace rocinante::ros::test
