#include "core/foreign/recordings/json_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/foreign/recordings/line_recording.h"
#include "core/foreign/table/table_column.h"

namespace rocinante {
namespace {

constexpr const char* kJsonTopic = "/json";
constexpr const char* kJsonDecoder = "json";
/// Numbers of a line; a packet of them would not fit a datagram.
constexpr std::size_t kMaxNumbers = 100'000;
constexpr std::size_t kMaxDepth = 16;
constexpr double kJsonBound = 0x1p53;

/// What a line says, taken while it is parsed, so that times keep all their digits.
class JsonRow : public nlohmann::json::json_sax_t {
 public:
  std::optional<Nanoseconds> time;
  std::vector<std::string> names;
  std::vector<double> numbers;
  bool is_object = false;

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t number) override {
    return takeNumber(static_cast<double>(number), std::to_string(number));
  }
  bool number_unsigned(number_unsigned_t number) override {
    return takeNumber(static_cast<double>(number), std::to_string(number));
  }
  bool number_float(number_float_t number, const string_t& digits) override {
    return takeNumber(number, digits);
  }
  bool string(string_t& text) override {
    if (depth_ == 1 && !in_array_) {
      if (key_ == "device") device_ = text;
      if (key_ == "joint" || key_ == "name") joint_ = text;
    }
    if (in_array_ && key_ == "name") listed_names_.push_back(text);
    return value();
  }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override {
    if (depth_ == 0) is_object = true;
    if (in_array_ || depth_ == kMaxDepth) return false;
    if (depth_ > 0) path_.push_back(key_);
    ++depth_;
    return true;
  }
  bool key(string_t& text) override {
    key_ = text;
    return true;
  }
  bool end_object() override {
    --depth_;
    if (!path_.empty()) {
      key_ = path_.back();
      path_.pop_back();
    }
    return true;
  }
  bool start_array(std::size_t) override {
    // Arrays hold no objects and no arrays.
    if (in_array_ || depth_ == 0) return false;
    in_array_ = true;
    return true;
  }
  bool end_array() override {
    in_array_ = false;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

  /// Names what was said in pairs. False when it does not fit together.
  bool finish(const std::string& device) {
    const std::string of = device_.empty() ? device : device_;
    const std::string before = of.empty() ? std::string() : of + ".";
    if (!listed_names_.empty() || !listed_numbers_.empty()) {
      if (listed_names_.size() != listed_numbers_.size()) return false;
      for (std::size_t i = 0; i < listed_names_.size(); ++i) {
        names.push_back(before + listed_names_[i]);
        numbers.push_back(listed_numbers_[i]);
      }
    }
    if (joint_.empty()) return true;
    // {"joint": NAME, "value": NUMBER}
    for (std::string& name : names) {
      if (name == "value" || name == "position") name = before + joint_;
    }
    return true;
  }

 private:
  bool value() { return depth_ > 0; }

  bool takeNumber(double number, const std::string& digits) {
    if (depth_ == 0) return false;
    const bool fits = std::abs(number) < kJsonBound;
    if (in_array_) {
      if (key_ != "position") return true;
      listed_numbers_.push_back(number);
      return fits && listed_numbers_.size() <= kMaxNumbers;
    }
    if (depth_ == 1 && (key_ == "t" || key_ == "time")) {
      if (!is_exact_) time = tableSeconds(digits);
      return true;
    }
    if (depth_ == 1 && (key_ == "t_ns" || key_ == "time_ns")) {
      is_exact_ = true;
      time = tableSeconds(digits + "e-9");
      return true;
    }
    std::string name;
    for (const std::string& part : path_) name += part + ".";
    names.push_back(name + key_);
    numbers.push_back(number);
    return fits && names.size() <= kMaxNumbers;
  }

  std::size_t depth_ = 0;
  bool in_array_ = false, is_exact_ = false;
  std::string key_, device_, joint_;
  std::vector<std::string> path_;  ///< of the objects around
  std::vector<std::string> listed_names_;
  std::vector<double> listed_numbers_;
};

bool parseRow(std::string_view line, JsonRow& row) {
  return nlohmann::json::sax_parse(line.begin(), line.end(), &row) && row.is_object;
}

class JsonLines final : public LineRecording {
 public:
  JsonLines(RecordingBytes bytes, std::string name, std::string device)
      : LineRecording(std::move(bytes), std::move(name), kJsonTopic, kJsonDecoder, "line"),
        device_(std::move(device)) {
    topic().type = "JSON lines";
  }

 protected:
  std::optional<Row> rowOf(std::string_view line) override {
    JsonRow said;
    const bool fits = parseRow(line, said);
    if (!said.time) return std::nullopt;
    if (!fits || !said.finish(device_)) return Row{*said.time, {}, true};
    rows().setNames(said.names);
    const RowTranslation::Outcome outcome = rows().translate(*said.time, said.numbers);
    return Row{*said.time, outcome.packet, outcome.malformed};
  }

 private:
  std::string device_;
};

}  // namespace

bool looksLikeJsonLines(std::string_view text) {
  RecordingLines lines{RecordingBytes(bytesOf(text))};
  const auto line = lines.next();
  if (!line || !line->starts_with('{')) return false;
  JsonRow row;
  return parseRow(*line, row) && row.time.has_value();
}

Result<std::unique_ptr<ros::BagReader>> openJsonLines(const std::filesystem::path& path,
                                                      const std::string& device) {
  Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  return std::unique_ptr<ros::BagReader>(
      std::make_unique<JsonLines>(RecordingBytes(std::move(*file)), path.string(), device));
}

Result<std::unique_ptr<ros::BagReader>> openJsonBytes(ByteView bytes, std::string name,
                                                      const std::string& device) {
  return std::unique_ptr<ros::BagReader>(
      std::make_unique<JsonLines>(RecordingBytes(bytes), std::move(name), device));
}

}  // namespace rocinante
