#include "core/series/series_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/atomic_file.h"
#include "core/base/bytes.h"
#include "core/base/duration_text.h"
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

  /// Adds a row, unless no value is stated.
  void add(const SessionState& state, Nanoseconds since_origin) {
    const std::size_t begin = text_.size();
    text_ += secondsText(since_origin);
    if (links_) links_->place(state);
    bool any = false;
    for (std::size_t i = 0; i < table_.keys.size(); ++i) {
      text_ += ',';
      if (const auto value = valueOf(state, i)) {
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
    if (key.kind == SeriesKey::Kind::signal) return signalSaid(state, key);
    if (key.kind == SeriesKey::Kind::link) {
      const auto part = posePart(key.part);
      if (!links_ || !part || !links_->poses()[link_[column]]) return std::nullopt;
      return poseNumbers(*links_->poses()[link_[column]])[*part];
    }
    const DeviceState* const said = state.findDevice(key.name);
    if (said == nullptr) return std::nullopt;
    if (key.kind == SeriesKey::Kind::pose) {
      const auto part = posePart(key.part);
      if (!said->pose || !part) return std::nullopt;
      return poseNumbers(said->pose->value.pose)[*part];
    }
    auto& names = names_[column];
    if (!names) names = table_.names ? table_.names(key.name, *said) : std::vector<std::string>();
    return jointSaid(*said, key.part, *names);
  }

  const SeriesTable& table_;
  std::set<std::string, std::less<>> devices_;
  std::optional<PlacedLinks> links_;
  std::vector<std::size_t> link_;                               ///< by column: into poses()
  std::vector<std::optional<std::vector<std::string>>> names_;  ///< by column, once known
  std::string text_;
  std::uint64_t count_ = 0;
};

}  // namespace

Result<std::uint64_t> writeSeriesTable(const SeriesTable& table, SessionState before,
                                       LogReader& log, const std::filesystem::path& path) {
  for (const SeriesKey& key : table.keys) {
    if (!key.isValue() || key.kind == SeriesKey::Kind::derived) {
      return Error{ErrorKind::bad_argument, "a table has joints, poses and signals only",
                   key.text()};
    }
  }
  if (table.keys.empty()) {
    return Error{ErrorKind::bad_argument, "a table needs a value that is a number", ""};
  }
  if (Status may = mayWriteFile(path, true); !may) return may.error();
  if (Status there = log.seek(table.from + Nanoseconds(1)); !there) return there.error();
  const LogTime origin = log.summary().origin;
  Rows rows(table);
  rows.add(before, table.from - origin);
  SessionState state = std::move(before);
  MessageFolder folder;
  for (std::uint64_t messages = 1;; ++messages) {
    const auto message = log.next();
    if (!message) return message.error();
    if (!*message || (*message)->log_time > table.until) break;
    const MessageFolder::Folded folded = folder.fold(state, **message);
    if (folded.applied && rows.isAbout(*folded.packet)) {
      rows.add(state, (*message)->log_time - origin);
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
