#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/finding.h"
#include "core/report/json_name.h"

namespace rocinante {

// What comes in is used or named (docs/decisions/030): whatever reads, imports, filters or exports
// returns beside its result an account of what it was given and did not use. The words:
//
//   kind    what sort of thing:  element, attribute, extension, primitive, topic, message, column,
//           row, datagram, file, statement, value
//   name    which one:           "pbr", "KHR_materials_clearcoat", "/camera/image", "IPv6 fragment"
//   reason  why it is not used:  "maps of <pbr> are not drawn"
//
// A comment, padding, or what the format itself defines as ignorable is not in an account. What a
// page of docs/ says is ignored is, as a note: the page says why, the account that this file has
// it.

/// One kind of thing that was left out.
struct LeftOut {
  std::string kind{};
  std::string name{};    ///< may be empty
  std::string reason{};  ///< a clause without a full stop
  std::string first{};  ///< the place of the first: "arm.sdf:12", "row 3", "frame 17"; may be empty
  std::uint64_t count = 1;
  /// note: documented as ignored; warning: whoever gave it will miss it. Changes no exit code.
  Severity severity = Severity::note;

  /// "3 elements `pbr` (maps of <pbr> are not drawn; the first at arm.sdf:12)"
  std::string text() const;
};

/// Counts what a door left out, by kind, name and reason, in order of the first. Bounded: beyond
/// kMaxListed kinds only a total is kept, so that a hostile file cannot fill the memory. A plain
/// value; not for sharing between threads.
class Account {
 public:
  static constexpr std::size_t kMaxListed = 256;

  /// Adds to the count of the same kind, name and reason, whose first place stays.
  void leaveOut(LeftOut left_out);
  void add(const Account& other);

  const std::vector<LeftOut>& leftOut() const { return left_out_; }
  bool empty() const { return left_out_.empty(); }
  /// Of all things, listed or not.
  std::uint64_t total() const { return total_; }
  /// Of those beyond kMaxListed.
  std::uint64_t unlisted() const { return unlisted_; }

 private:
  std::vector<LeftOut> left_out_;
  std::uint64_t total_ = 0, unlisted_ = 0;
};

/// The finding's text, with what was left out in front: "element `pbr` is left out 2 times: maps of
/// <pbr> are not drawn".
std::string sentenceOf(const Finding& finding);

/// The account of files whose readers return findings: those that state what was left out, with
/// their places and counts.
Account accountOf(const Findings& findings);

/// "left out: 3 elements `pbr` (...), 1 topic `/camera/image` (...), and 17 things more";
/// empty for an empty account.
std::string accountSentence(const Account& account, std::size_t most_listed = 4);

/// As text, a line for each kind, for a file that another program reads later; and back. A line
/// that is none is passed over.
std::string accountLines(const Account& account);
Account accountOfLines(std::string_view lines);

/// "44 `illum`, 54 `Ka` and 19 things more are left out", without reasons and places, where room is
/// scarce; empty for an empty account.
std::string accountBrief(const Account& account, std::size_t most_listed = 3);

/// For every program's JSON, under the key `left_out`:
/// {"total": 20, "unlisted": 0, "items": [{"kind", "name", "reason", "first", "count",
/// "severity"}]}. `total` counts things; those beyond kMaxListed kinds are in `unlisted` and in no
/// item.
Json leftOutJson(const Account& account);

}  // namespace rocinante
