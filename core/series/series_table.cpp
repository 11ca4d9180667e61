#include "core/series/series_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/bytes.h"
#include "core/base/duration_text.h"
#include "core/series/derived_value.h"
#include "core/series/placed_links.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kAskEvery = 4096;  // messages

/// A field of RFC 4180: quoted where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n ") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

/// The rows of one table.
class Rows {
 public:
  explicit Rows(const SeriesTable& table) : table_(table), names_(table.keys.size()) {
    text_ = "t";
    if (table.cell != nullptr) links_.emplace(*table.cell);
    for (const SeriesKey& key : table.keys) {
      text_ += ',' + field(key.text());
      if (key.kind != SeriesKey::Kind::link) {
        devices_.insert(key.name);
        link_.push_back(0);
      } else {
        link_.push_back(links_ ? links_->add(key) : 0);
      }
    }
    text_ += '\n';
  }

  bool isAbout(const Packet& packet) const {
    // A restatement may forget what it does not name.
    if (packet.header.restated) return true;
    return std::ranges::any_of(packet.statements, [this](const Statement& statement) {
      if (links_ && links_->isMovedBy(statement)) return true;
      return isSignal(statement.kind)
                 ? devices_.contains(statement.path.first)
                 : movesDevice(statement.kind) && devices_.contains(statement.name);
    });
  }

  /// Adds a row, unless no value is stated. `derived`: null when no column is.
  void add(const SessionState& state, const SeriesScan* derived, Nanoseconds since_origin) {
    const std::size_t begin = text_.size();
    text_ += secondsText(since_origin);
    if (links_) links_->place(state);
    bool any = false;
    for (std::size_t i = 0; i < table_.keys.size(); ++i) {
      text_ += ',';
      const bool is_derived = table_.keys[i].kind == SeriesKey::Kind::derived;
      const auto value = is_derived ? derived->newest(table_.keys[i]) : valueOf(state, i);
      if (value) {
        fmt::format_to(std::back_inserter(text_), "{}", *value);
        any = true;
      }
    }
    text_ += '\n';
    if (any) {
      ++count_;
    } else {
      text_.resize(begin);
    }
  }

  const std::string& text() const { return text_; }
  std::uint64_t count() const { return count_; }

 private:
  std::optional<double> valueOf(const SessionState& state, std::size_t column) {
    const SeriesKey& key = table_.keys[column];
    if (key.kind == SeriesKey::Kind::signal) return signalStated(state, key);
    if (key.kind == SeriesKey::Kind::link) {
      const auto part = posePart(key.part);
      if (!links_ || !part || !links_->poses()[link_[column]]) return std::nullopt;
      return poseNumbers(*links_->poses()[link_[column]])[*part];
    }
    const DeviceState* const device_state = state.findDevice(key.name);
    if (device_state == nullptr) return std::nullopt;
    if (key.kind == SeriesKey::Kind::pose) {
      const auto part = posePart(key.part);
      if (!device_state->pose || !part) return std::nullopt;
      return poseNumbers(device_state->pose->value.pose)[*part];
    }
    auto& names = names_[column];
    if (!names)
      names = table_.names ? table_.names(key.name, *device_state) : std::vector<std::string>();
    return jointStated(*device_state, key.part, *names);
  }

  const SeriesTable& table_;
  std::set<std::string, std::less<>> devices_;
  std::optional<PlacedLinks> links_;
  std::vector<std::size_t> link_;                               ///< by column: into poses()
  std::vector<std::optional<std::vector<std::string>>> names_;  ///< by column, once known
  std::string text_;
  std::uint64_t count_ = 0;
};

/// What is derived as the table's rows are made, which begins where the log is read from; null:
/// nothing.
std::unique_ptr<SeriesScan> derivedScan(const SeriesTable& table) {
  std::set<SeriesKey> keys;
  for (const SeriesKey& key : table.keys) {
    if (key.kind == SeriesKey::Kind::derived) keys.insert(key);
  }
  if (keys.empty()) return nullptr;
  SeriesScan::Options options;
  options.from = table.lead ? table.lead->first : table.from;
  options.until = table.until;
  options.names = table.names;
  options.cell = table.cell;
  options.max_bins = 64;  // only the newest counts
  options.only = std::move(keys);
  options.states = false;
  auto scan = std::make_unique<SeriesScan>(std::move(options));
  if (table.lead) scan->beginWith(table.lead->second, table.lead->first);
  return scan;
}

}  // namespace

Result<std::uint64_t> writeSeriesTable(const SeriesTable& table, SessionState before,
                                       LogReader& log, const std::filesystem::path& path) {
  for (const SeriesKey& key : table.keys) {
    if (!key.isValue()) {
      return Error{ErrorKind::bad_argument, "a table has joints, poses and signals only",
                   key.text()};
    }
  }
  if (table.keys.empty()) {
    return Error{ErrorKind::bad_argument, "a table needs a value that is a number", ""};
  }
  if (Status may = mayWriteFile(path, true); !may) return may.error();
  const std::unique_ptr<SeriesScan> derived = derivedScan(table);
  const LogTime begin = table.lead ? table.lead->first : table.from;
  const bool reads_all = derived != nullptr && !table.lead;
  const Status there = reads_all ? log.rewind() : log.seek(begin + Nanoseconds(1));
  if (!there) return there.error();
  const LogTime origin = log.summary().origin;
  Rows rows(table);
  SessionState state = std::move(before);
  MessageFolder folder;
  bool has_begun = false;
  const auto beginRows = [&] {
    if (std::exchange(has_begun, true)) return;
    if (derived != nullptr) derived->settle(table.from);
    rows.add(state, derived.get(), table.from - origin);
  };
  for (std::uint64_t messages = 1;; ++messages) {
    const auto message = log.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time > table.until) break;
    if ((*message)->log_time > table.from) beginRows();
    const std::uint64_t samples = derived == nullptr ? 0 : derived->derivedSamples();
    if (derived != nullptr) derived->add(**message);
    const bool is_sampled = derived != nullptr && derived->derivedSamples() != samples;
    const MessageFolder::Folded folded =
        has_begun ? folder.fold(state, **message) : MessageFolder::Folded();
    if (folded.applied && (is_sampled || rows.isAbout(*folded.packet))) {
      if (derived != nullptr) derived->settle((*message)->log_time);
      rows.add(state, derived.get(), (*message)->log_time - origin);
    }
    if (rows.text().size() > kMaxTableBytes) {
      return Error{ErrorKind::bad_argument,
                   fmt::format("the table would be larger than {} MiB: take a shorter time or "
                               "fewer values",
                               kMaxTableBytes >> 20U),
                   path.string()};
    }
    if (messages % kAskEvery == 0 && table.goes_on && !table.goes_on()) {
      return Error{ErrorKind::refused, "stopped before the table was whole", path.string()};
    }
  }
  beginRows();
  if (rows.count() == 0) {
    return Error{ErrorKind::bad_argument, "no packet states any of these values there",
                 path.string()};
  }
  if (Status written = writeFileWhole(path, bytesOf(rows.text()), true); !written) {
    return written.error();
  }
  return rows.count();
}

}  // namespace rocinante
