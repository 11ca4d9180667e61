#pragma once

#include <compare>
#include <filesystem>
#include <set>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/check/rules/finding.h"

namespace rocinante {

/// What a finding is known by from one run to the next: neither counts nor times nor lines, which
/// change with every session and edit.
struct BaselineKey {
  std::string rule;
  std::string subject;
  std::string file;      ///< below the cell's folder as seen from there, else its name alone
  std::string sentence;  ///< the finding's, with `#` for every number that stands alone

  auto operator<=>(const BaselineKey&) const = default;
  std::string text() const;  ///< of all, for hashing
};
BaselineKey baselineKeyOf(const CheckReport& report, const Finding& finding);

/// Findings that are known and accepted: a JSON file (docs/programs/check.md, "Baselines").
class Baseline {
 public:
  /// not_found or unreadable; damaged with the place when it is no baseline. `path` names it.
  static Result<Baseline> read(const std::filesystem::path& path);
  static Result<Baseline> parse(ByteView bytes, const std::string& name);
  /// Errors, warnings, what would fail, and what a baseline accepts already; not the notes that a
  /// baseline is stale.
  static Baseline of(const CheckReport& report);

  /// Marks what it accepts, and adds a note for each entry that nothing matches any more; then the
  /// report needs another conclude().
  void applyTo(CheckReport& report) const;

  /// As read() takes it; sorted, an entry a line, so that two versions differ by what changed.
  std::string text() const;
  std::size_t size() const { return accepted_.size(); }

 private:
  std::string name_;
  std::set<BaselineKey> accepted_;
};

}  // namespace rocinante
