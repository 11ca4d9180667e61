#pragma once

#include <compare>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/check/rules/check_report.h"

namespace rocinante {

/// What identifies a finding from one run to the next: no counts, times or lines, which change with
/// every session and edit.
struct BaselineKey {
  std::string rule;
  std::string subject;
  std::string file;      ///< relative to the cell's folder if below it, else the name alone
  std::string sentence;  ///< the finding's, with `#` for every number that is not part of a name

  auto operator<=>(const BaselineKey&) const = default;
  std::string text() const;  ///< all fields, for hashing
};
BaselineKey baselineKeyOf(const CheckReport& report, const Finding& finding);

/// Known and accepted findings, each up to its worst value: a JSON file (docs/programs/check.md,
/// "Baselines").
class Baseline {
 public:
  /// not_found or unreadable; damaged, with the place, when it is not a baseline. `path` names it.
  static Result<Baseline> read(const std::filesystem::path& path);
  static Result<Baseline> parse(ByteView bytes, const std::string& name);
  /// Errors, warnings, findings that would fail, and those already accepted; not the notes that a
  /// baseline is stale.
  static Baseline of(const CheckReport& report);

  /// Marks accepted findings and adds a note for each entry that no longer matches. Call conclude()
  /// afterwards.
  void applyTo(CheckReport& report) const;

  /// The finding of this key, where its worst value (an angle, a distance, a speed) is not beyond
  /// the accepted one. An entry without one, as older versions wrote, accepts any.
  bool accepts(const BaselineKey& key, const Finding& finding) const;

  /// As read() takes it; sorted, one entry per line, so that diffs are small.
  std::string text() const;
  std::size_t size() const { return accepted_.size(); }

 private:
  std::string name_;
  std::map<BaselineKey, std::optional<double>> accepted_;  ///< with the worst value
};

}  // namespace rocinante
