#include "core/log/foreign_file.h"

#include <array>
#include <string_view>

namespace rocinante {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view begins;
  std::string_view what;
};

constexpr std::string_view kCapture =
    "it is a network capture: `rocinante log import` makes a log of it";
constexpr std::string_view kCompressed = "it is compressed: expand it first";

constexpr std::array kKinds{
    Kind{"\xd4\xc3\xb2\xa1"sv, kCapture},
    Kind{"\xa1\xb2\xc3\xd4"sv, kCapture},
    Kind{"\x4d\x3c\xb2\xa1"sv, kCapture},  // with nanoseconds
    Kind{"\xa1\xb2\x3c\x4d"sv, kCapture},
    Kind{"\x0a\x0d\x0d\x0a"sv, kCapture},  // pcapng
    Kind{"\x1f\x8b"sv, kCompressed},
    Kind{"\x28\xb5\x2f\xfd"sv, kCompressed},
    Kind{"\xfd\x37zXZ"sv, kCompressed},
    Kind{"PK\x03\x04"sv, kCompressed},
    Kind{"\xed\xa1\xda\x01"sv, "it is an LCM log: `rocinante log import` makes a log of it"},
    Kind{"#ROSBAG V"sv, "it is a ROS bag: `rocinante log import` makes a log of it"},
    Kind{"SQLite format 3"sv,
         "it is a SQLite file, as ROS 2 bags are: `rocinante log import` makes a log of those"},
};

std::string_view whatItIs(ByteView file) {
  for (const Kind& kind : kKinds) {
    if (textOf(file).starts_with(kind.begins)) return kind.what;
  }
  return {};
}

}  // namespace

std::string notALog(ByteView file) {
  if (file.empty()) return "the file is empty";
  std::string sentence = "the file does not start with the MCAP magic";
  const std::string_view what = whatItIs(file);
  return what.empty() ? sentence : sentence.append("; ").append(what);
}

std::string notAFile(const std::filesystem::path& path) {
  std::error_code none;
  std::string sentence = "a log must be a regular file";
  if (std::filesystem::is_regular_file(path / "metadata.yaml", none)) {
    return sentence + "; it is the folder of a ROS 2 bag: `rocinante log import` makes a log of it";
  }
  return sentence;
}

std::string notImportable(ByteView first_bytes) {
  if (first_bytes.empty()) return "the file is empty";
  const std::string_view what = whatItIs(first_bytes);
  return std::string(what.empty() ? "the file is not a recording that can be imported" : what);
}

}  // namespace rocinante
