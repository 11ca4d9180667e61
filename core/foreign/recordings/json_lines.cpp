#include "core/foreign/recordings/json_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/plain_text.h"
#include "core/foreign/recordings/line_recording.h"
#include "core/foreign/table/table_fields.h"

namespace rocinante {
namespace {

constexpr const char* kJsonTopic = "/json";
constexpr const char* kJsonDecoder = "json";
/// Numbers of a line; a packet of them would not fit a datagram.
constexpr std::size_t kMaxNumbers = 100'000;
constexpr std::size_t kMaxDepth = 16;
/// In the sentence of a refusal.
constexpr std::size_t kMaxKeys = 8;
constexpr double kJsonBound = 0x1p53;
constexpr const char* kNoObject = "it is no object";
constexpr const char* kBeyond = "a number is beyond 2^53";
constexpr const char* kTooMany = "it has more than 100,000 numbers";

/// What a line says, taken while it is parsed, so that times keep all their digits.
class JsonRow : public nlohmann::json::json_sax_t {
 public:
  /// `times`: those of the whole file, in the unit that its first one shows.
  explicit JsonRow(TableTimes& times) : times_(&times) {}

  struct LeftOutKey {
    std::string name;
    const char* reason;
  };
  std::optional<Nanoseconds> time;
  std::vector<std::string> names;
  std::vector<double> numbers;
  std::vector<RowTranslation::Word> words;
  std::vector<LeftOutKey> left_out;
  std::vector<std::string> keys;  ///< of the object itself
  bool is_object = false;
  std::string fault;  ///< why it was not read to its end

  bool null() override { return takeNothing(); }
  bool boolean(bool truth) override {
    return takeWord({SignalKind::boolean, truth ? 1.0 : 0.0, {}, {}});
  }
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
      if (key_ == "device" || key_ == "joint" || key_ == "name") return true;
    }
    if (in_array_ && key_ == "name") {
      listed_names_.push_back(text);
      return true;
    }
    return takeText(text);
  }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override {
    if (depth_ == 0) is_object = true;
    if (in_array_) return refuse("an array has an object");
    if (depth_ == kMaxDepth) return refuse("more than 16 objects are inside each other");
    if (depth_ > 0) path_.push_back(key_);
    ++depth_;
    return true;
  }
  bool key(string_t& text) override {
    key_ = text;
    if (depth_ == 1 && keys.size() < kMaxKeys) keys.push_back(text);
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
    if (in_array_) return refuse("an array has an array");
    if (depth_ == 0) return refuse(kNoObject);
    if (key_ != "name" && key_ != "position") leaveOut("an array");
    in_array_ = true;
    return true;
  }
  bool end_array() override {
    in_array_ = false;
    return true;
  }
  bool parse_error(std::size_t column, const std::string&,
                   const nlohmann::json::exception&) override {
    return refuse("no JSON from column " + std::to_string(column) + " on");
  }

  /// Names what was said in pairs. False when it does not fit together.
  bool finish(const std::string& device) {
    if (!is_object) return refuse(kNoObject);
    const std::string of = device_.empty() ? device : device_;
    const std::string before = of.empty() ? std::string() : of + ".";
    if (!listed_names_.empty() || !listed_numbers_.empty()) {
      if (listed_names_.size() != listed_numbers_.size()) {
        return refuse("`name` and `position` have different lengths");
      }
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
  bool refuse(std::string why) {
    fault = std::move(why);
    return false;
  }
  bool value() { return depth_ > 0 || refuse(kNoObject); }

  std::string fullName() const {
    std::string name;
    for (const std::string& part : path_) name += part + ".";
    return name + key_;
  }
  void leaveOut(const char* reason) {
    if (depth_ > 0) left_out.push_back({fullName(), reason});
  }

  /// The unit of the time that the key names; names that cannot be one are cheap.
  std::optional<TimeUnit> timeUnit() const {
    constexpr std::string_view kFirst = "tTsS_%";
    if (depth_ != 1 || key_.empty() || kFirst.find(key_[0]) == kFirst.npos) return std::nullopt;
    return timeUnitOf(key_);
  }

  void takeTime(TimeUnit unit, std::string_view digits) {
    // Nanoseconds are exact where both are given.
    if (is_exact_ && unit != TimeUnit::nanoseconds) return;
    is_exact_ = unit == TimeUnit::nanoseconds;
    TableTimes known(unit);
    time = unit == TimeUnit::unknown ? times_->read(digits) : known.read(digits);
  }

  bool takeNumber(double number, const std::string& digits) {
    if (depth_ == 0) return refuse(kNoObject);
    const auto fits = [&](const std::vector<double>& listed) {
      if (!(std::abs(number) < kJsonBound)) return refuse(kBeyond);
      return listed.size() <= kMaxNumbers || refuse(kTooMany);
    };
    if (in_array_) {
      if (key_ != "position") return true;
      listed_numbers_.push_back(number);
      return fits(listed_numbers_);
    }
    if (const auto unit = timeUnit()) {
      takeTime(*unit, digits);
      return true;
    }
    if (!(std::abs(number) < kJsonBound)) return takeWord({SignalKind::number, number, {}, {}});
    names.push_back(fullName());
    numbers.push_back(number);
    return fits(numbers);
  }

  /// null, or a word for it: the key has no value yet.
  bool takeNothing() {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    if (in_array_ && key_ == "position") listed_numbers_.push_back(kNothing);
    if (!in_array_ && depth_ > 0) {
      names.push_back(fullName());
      numbers.push_back(kNothing);
    }
    if (names.size() > kMaxNumbers || listed_numbers_.size() > kMaxNumbers) return refuse(kTooMany);
    return value();
  }

  /// Some programs write numbers as text.
  bool takeText(const std::string& text) {
    if (const auto unit = timeUnit(); unit && !in_array_) {
      takeTime(*unit, text);
      return true;
    }
    double number = 0;
    switch (TableNumbers(',').read(text, number)) {
      case TableValue::number:
        return takeNumber(number, text);
      case TableValue::nothing:
        return takeNothing();
      case TableValue::text:
        break;
    }
    if (in_array_) return key_ != "position" || refuse("`position` has text");
    return takeWord({SignalKind::text, 0, text, {}});
  }

  /// What is no number, or none that a joint can have.
  bool takeWord(SignalValue word) {
    if (!in_array_ && depth_ > 0) {
      words.push_back({names.size(), std::move(word)});
      names.push_back(fullName());
      numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    if (names.size() > kMaxNumbers) return refuse(kTooMany);
    return value();
  }

  TableTimes* times_;
  std::size_t depth_ = 0;
  bool in_array_ = false, is_exact_ = false;
  std::string key_, device_, joint_;
  std::vector<std::string> path_;  ///< of the objects around
  std::vector<std::string> listed_names_;
  std::vector<double> listed_numbers_;
};

/// The line with `null` for NaN and Infinity, which Python writes although JSON has no such words.
std::string withoutNan(std::string_view line) {
  constexpr std::array<std::string_view, 4> kWords = {"NaN", "-Infinity", "Infinity", "nan"};
  std::string plain;
  bool in_text = false;
  for (std::size_t at = 0; at < line.size();) {
    if (in_text && line[at] == '\\' && at + 1 < line.size()) {
      plain += line.substr(at, 2);
      at += 2;
      continue;
    }
    if (line[at] == '"') in_text = !in_text;
    const auto word = std::ranges::find_if(kWords, [&](std::string_view each) {
      return !in_text && line.substr(at).starts_with(each);
    });
    if (word == kWords.end()) {
      plain += line[at++];
    } else {
      plain += "null";
      at += word->size();
    }
  }
  return plain;
}

/// False for what is no object; `row` then has what came before the fault.
bool parseRow(std::string_view line, TableTimes& times, JsonRow& row) {
  if (nlohmann::json::sax_parse(line.begin(), line.end(), &row)) return row.is_object;
  // Only what is wrong is looked at twice.
  if (line.find("NaN") == line.npos && line.find("Infinity") == line.npos &&
      line.find("nan") == line.npos) {
    return false;
  }
  const std::string plain = withoutNan(line);
  JsonRow again(times);
  if (!nlohmann::json::sax_parse(plain, &again)) return false;
  row = std::move(again);
  return row.is_object;
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
    JsonRow json_row(times_);
    const bool fits = parseRow(line, times_, json_row);
    if (!json_row.time) return std::nullopt;
    if (!fits || !json_row.finish(device_))
      return Row{*json_row.time, {}, std::move(json_row.fault)};
    for (const JsonRow::LeftOutKey& each : json_row.left_out) {
      rows().leaveOut(each.name, each.reason, Severity::note);
    }
    rows().setNames(json_row.names);
    const bool is_joint_beyond = std::ranges::any_of(json_row.words, [&](const auto& word) {
      return word.value.kind == SignalKind::number && !rows().isSignal(word.place);
    });
    if (is_joint_beyond) return Row{*json_row.time, {}, kBeyond};
    const RowTranslation::Outcome outcome =
        rows().translate(*json_row.time, json_row.numbers, json_row.words);
    return Row{*json_row.time, outcome.packet, outcome.malformed ? kPartOfPoseAlone : ""};
  }

 private:
  std::string device_;
  TableTimes times_{TimeUnit::unknown};
};

}  // namespace

bool looksLikeJsonLines(std::string_view text) {
  RecordingLines lines{RecordingBytes(bytesOf(text))};
  const auto line = lines.next();
  if (!line || !line->starts_with('{')) return false;
  TableTimes times(TimeUnit::unknown);
  JsonRow row(times);
  return parseRow(*line, times, row) && row.time.has_value();
}

std::optional<std::string> jsonLinesRefusal(std::string_view text) {
  RecordingLines lines{RecordingBytes(bytesOf(text))};
  const auto line = lines.next();
  if (!line || !line->starts_with('{')) return std::nullopt;
  TableTimes times(TimeUnit::unknown);
  JsonRow row(times);
  if (!parseRow(*line, times, row) || row.time) return std::nullopt;
  std::string keys;
  for (const std::string& key : row.keys) {
    keys += (keys.empty() ? "`" : ", `") + plainText(key.substr(0, 64)) + "`";
  }
  return "the JSON lines cannot be read: no key is the time (" + std::string(kTimeNames) +
         "): the keys are " + (keys.empty() ? "none" : keys);
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
