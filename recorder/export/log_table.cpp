#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string>
#include <utility>

#include "recorder/export/exports.h"
#include "recorder/export/session_census.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMomentsATell = 1024;

/// Tells the progress of one of two passes now and then.
class PassProgress {
 public:
  PassProgress(const TableOptions& options, const LogSummary& log, double begins_at)
      : options_(options), begins_at_(begins_at) {
    from_ = std::max(options.from, log.start);
    span_ = std::max(secondsOf(std::min(options.until, log.end) - from_), 1e-9);
  }

  Status at(LogTime moment) {
    if (!options_.progress || ++count_ % kMomentsATell != 0) return {};
    const double part = std::clamp(secondsOf(moment - from_) / span_, 0.0, 1.0);
    return options_.progress(begins_at_ + part / 2);
  }

 private:
  const TableOptions& options_;
  double begins_at_;
  LogTime from_;
  double span_ = 1;
  std::uint64_t count_ = 0;
};

void addSeveralUnits(Account& account, const SessionTable& table, LogTime origin) {
  const auto word = [](const std::string& unit) { return unit.empty() ? "no unit" : unit; };
  for (const SessionTable::SeveralUnits& each : table.severalUnits()) {
    account.leaveOut({.kind = "unit",
                      .name = each.column,
                      .reason = fmt::format("its column has numbers in {} and in {}",
                                            word(each.first), word(each.other)),
                      .first = fmt::format("{:.3f} s", secondsOf(each.other_at - origin)),
                      .severity = Severity::warning});
  }
}

bool sameBits(const std::vector<double>& a, const std::vector<double>& b) {
  // NaN equals NaN here: both are empty fields.
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

Result<TableReport> writeTable(MomentWalk& session, SessionTable& table, TableWriter& writer,
                               const TableOptions& options) {
  const LogSummary& log = session.log().summary();
  ClearanceColumns* const clearances = options.clearances;
  LinkColumns* const links = options.links;
  DerivedColumns* const derived = options.derived;
  const bool is_grid = options.rows == TableOptions::Rows::grid;
  if (is_grid || options.from > log.start) {
    // What was said before the first row holds there.
    const Result<const SessionState*> first = session.stateAt(options.from);
    if (!first) return first.error();
    table.noticeAll(**first);
    if (clearances != nullptr) clearances->notice(**first);
  }
  if (derived != nullptr) {
    const Result<const SessionState*> first = session.stateAt(std::max(options.from, log.start));
    if (!first) return first.error();
    derived->notice(**first);
  }
  PassProgress finding(options, log, 0);
  const auto notice = [&](LogTime moment, const SessionState& state) -> Status {
    table.notice(state, moment);
    if (clearances != nullptr) clearances->notice(state);
    return finding.at(moment);
  };
  SessionCensus census;
  const auto count = [&](const LogMessage& message, const Packet* packet) -> Status {
    census.take(message, packet);
    if (derived != nullptr) derived->notice(message);
    return {};
  };
  if (Status found = session.visit(options.from, options.until, {count, notice}); !found) {
    return found.error();
  }
  table.layOut();
  if (derived != nullptr) {
    if (Status known = derived->layOut(table.columns()); !known) return known.error();
  }
  if (table.columns().empty() && links == nullptr && derived == nullptr) {
    return Error{ErrorKind::not_found,
                 std::string(options.signals ? "no chosen device has joints, a pose or numbers"
                                             : "no chosen device has joints or a pose") +
                     table.otherDevices(),
                 session.log().name()};
  }
  TableReport report;
  report.columns = table.columns();
  const auto addColumns = [&report](const std::vector<std::string>& more) {
    report.columns.insert(report.columns.end(), more.begin(), more.end());
  };
  if (links != nullptr) addColumns(links->columns());
  if (derived != nullptr) addColumns(derived->columns());
  if (clearances != nullptr) {
    clearances->layOut();
    addColumns(clearances->columns());
  }
  if (Status begun = writer.begin(report.columns); !begun) return begun.error();
  const std::size_t of_table = table.columns().size();
  const std::size_t of_links = links == nullptr ? 0 : links->columns().size();
  const std::size_t of_derived = derived == nullptr ? 0 : derived->columns().size();
  std::vector<double> values(report.columns.size());
  std::vector<double> former;
  if (derived != nullptr) {
    if (Status begun = derived->begin(session, options.from); !begun) return begun.error();
  }
  PassProgress writing(options, log, 0.5);
  const auto write = [&](LogTime moment, const SessionState& state) -> Status {
    table.fill(state, std::span(values).first(of_table));
    const std::span behind = std::span(values).subspan(of_table);
    if (links != nullptr) links->fill(state, behind.first(of_links));
    if (derived != nullptr) derived->fill(behind.subspan(of_links, of_derived));
    if (clearances != nullptr) clearances->fill(state, behind.subspan(of_links + of_derived));
    if (options.rows == TableOptions::Rows::changed) {
      if (report.rows > 0 && sameBits(values, former)) return {};
      former = values;
    }
    table.noticeUnits(state, moment);
    ++report.rows;
    return writer.row(moment - log.origin, values);
  };
  if (is_grid) {
    for (LogTime moment = options.from; moment < options.until; moment += options.every) {
      const Result<const SessionState*> state = session.stateAt(moment);
      if (!state) return state.error();
      Status written = derived == nullptr ? Status() : derived->moveTo(moment);
      if (written) written = write(moment, **state);
      if (written) written = writing.at(moment);
      if (!written) return written.error();
      if (options.until - moment <= options.every) break;
    }
  } else {
    const auto row = [&](LogTime moment, const SessionState& state) -> Status {
      // The table remembers what it was asked about last: it is asked in any case.
      const bool is_written = table.wasWritten(state, moment);
      if (derived != nullptr) {
        if (Status moved = derived->moveTo(moment); !moved) return moved;
      }
      if (is_written || (derived != nullptr && derived->wereSampled()) ||
          (links != nullptr && links->wereMoved(state, moment))) {
        if (Status written = write(moment, state); !written) return written;
      }
      return writing.at(moment);
    };
    if (Status done = session.visit(options.from, options.until, {{}, row}); !done) {
      return done.error();
    }
  }
  if (Status ended = writer.end(); !ended) return ended.error();
  // The first that is named: it is in the numbers.
  addSeveralUnits(report.left_out, table, log.origin);
  const std::vector<StatementKind> without_column = {
      StatementKind::show,   StatementKind::hide,  StatementKind::color, StatementKind::line,
      StatementKind::points, StatementKind::label, StatementKind::event, StatementKind::view};
  const char* const reason =
      options.signals ? "a table has joints, poses and numbers" : "a table has joints and poses";
  if (!options.signals) {
    const std::array signals = {StatementKind::signal, StatementKind::signals};
    census.addStatements(report.left_out, signals, "columns with --signals");
  }
  census.addStatements(report.left_out, without_column, reason);
  for (const std::string& name : table.texts()) {
    report.left_out.leaveOut({.kind = "signal",
                              .name = name,
                              .reason = "its texts are no numbers",
                              .first = {},
                              .count = 1});
  }
  census.addUnread(report.left_out, "holds no packet");
  addOwnTopics(report.left_out, session.log(), reason);
  addAttachments(report.left_out, session.log(), reason);
  return report;
}

}  // namespace rocinante
