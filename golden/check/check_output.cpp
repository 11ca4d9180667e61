#include "golden/check/check_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/check/rules/rule_list.h"
#include "core/check/rules/rule_page.h"
#include "core/cli/terminal.h"
#include "core/cli/text_table.h"

namespace rocinante {
namespace {

constexpr std::array<std::string_view, 5> kFormats = {"text", "json", "junit", "sarif", "github"};

std::string inFormat(const CheckReport& report, std::string_view format,
                     const CheckArguments& arguments, const TextStyle& style) {
  if (format == "json") return checkJson(report);
  if (format == "junit") return checkJunit(report);
  if (format == "sarif") return checkSarif(report, arguments.rule_pages);
  if (format == "github") return checkGithub(report, arguments.most_a_rule);
  return checkText(report, style);
}

}  // namespace

Result<std::vector<CheckOutput>> readOutputs(const CheckArguments& arguments) {
  std::vector<CheckOutput> outputs;
  for (const std::string& text : arguments.outputs) {
    const std::size_t equals = text.find('=');
    CheckOutput output;
    if (equals != text.npos) output = {text.substr(0, equals), text.substr(equals + 1)};
    const bool is_known =
        std::find(kFormats.begin(), kFormats.end(), output.format) != kFormats.end();
    if (!is_known || output.file.empty()) {
      return Error{ErrorKind::bad_argument,
                   "must be FORMAT=FILE with text, json, junit, sarif or github",
                   "--output " + text};
    }
    std::error_code ignored;
    if (!arguments.force && std::filesystem::exists(output.file, ignored)) {
      return Error{ErrorKind::refused, "the file exists (--force overwrites it)", output.file};
    }
    outputs.push_back(std::move(output));
  }
  return outputs;
}

Status writeReport(const CheckReport& report, const CheckArguments& arguments,
                   const std::vector<CheckOutput>& outputs) {
  TextStyle style;
  style.most_a_rule = arguments.most_a_rule;
  style.quiet = arguments.quiet;
  for (const CheckOutput& output : outputs) {
    const std::string text = inFormat(report, output.format, arguments, style);
    if (Status written = writeFileWhole(output.file, bytesOf(text), arguments.force); !written) {
      return written;
    }
  }
  const cli::OutputTerminal terminal = cli::outputTerminal();
  style.color = terminal.color;
  style.unicode = terminal.unicode;
  style.columns = terminal.columns;
  const std::string_view format = arguments.json ? "json" : std::string_view(arguments.format);
  std::fputs(inFormat(report, format, arguments, style).c_str(), stdout);
  return {};
}

void printRules(bool as_json) {
  if (as_json) {
    nlohmann::ordered_json json;
    json["format"] = 1;
    for (const Rule& rule : allRules()) {
      nlohmann::ordered_json each;
      each["rule"] = std::string(rule.id);
      each["severity"] = std::string(nameOf(rule.severity));
      each["title"] = std::string(rule.title);
      if (!rule.threshold.key.empty()) {
        each["threshold"] = {{"key", std::string(rule.threshold.key)},
                             {"value", rule.threshold.value}};
      }
      json["rules"].push_back(each);
    }
    std::fputs((json.dump(2) + "\n").c_str(), stdout);
    return;
  }
  cli::TextTable table;
  table.is_number = {false, false, false};
  for (const Rule& rule : allRules()) {
    table.rows.push_back(
        {std::string(rule.id), std::string(nameOf(rule.severity)), std::string(rule.title)});
  }
  std::fputs(table.text(cli::outputTerminal().columns).c_str(), stdout);
}

Status explainRule(const std::string& rule) {
  const RulePage* const page = findRulePage(rule);
  if (page == nullptr) {
    return Error{ErrorKind::not_found, "unknown rule (see --list-rules)", rule};
  }
  std::fputs(explanationOf(*page).c_str(), stdout);
  return {};
}

}  // namespace rocinante
