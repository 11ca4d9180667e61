#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante::test {

/// One example of a rule: a cell and a session. docs/rules/README.md, "How a page is written",
/// defines the notation.
struct RuleExample {
  std::map<std::string, std::string> files;  ///< by name, as bytes
  std::string cell = "cell.toml";            ///< which of them is the cell
  std::string session;                       ///< text of the `session` block
  bool has_session = false;
  std::vector<std::string> also;  ///< other rules that the example fires too
  std::string cannot_show;        ///< why there is no example; empty where there is one
};

/// What a page has below the heading of one rule.
struct RuleText {
  std::string rule;      ///< the heading
  std::string severity;  ///< "error", as the first paragraph begins
  std::string summary;   ///< the rest of that paragraph, without its period
  std::string text;      ///< all of it
  RuleExample fires, silent;
};

/// Reads docs/rules/FAMILY.md, in its order. `defaults` are the blocks that neither the rule nor
/// the head of the page has: those of docs/rules/README.md. An error names the page and line.
Result<std::vector<RuleText>> readRulePage(const std::filesystem::path& path,
                                           const RuleExample& defaults);

/// The blocks of docs/rules/README.md before its first section.
Result<RuleExample> readRuleDefaults(const std::filesystem::path& readme);

}  // namespace rocinante::test
