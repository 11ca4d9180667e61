#include "golden/check/check_options.h"

#include <CLI/CLI.hpp>

#include "core/cell/cell_rules.h"
#include "core/check/rules/rule_list.h"
#include "core/cli/search_options.h"

namespace rocinante {

void declareCheck(CLI::App& app, CheckArguments& my) {
  auto* cell =
      app.add_option("CELL", my.cell, "a cell, a model file, or a log that carries its cell");
  auto* log = app.add_option("LOG", my.log, "a recorded session");
  auto* live = app.add_option("--live", my.live, "judge what arrives here: udp://HOST:PORT");
  live->excludes(log)->needs(cell);
  app.add_option("--duration", my.duration, "how long to listen")
      ->needs(live)
      ->capture_default_str();
  cli::addSearchOptions(app, my);

  app.add_option("--rule", my.rules, "RULE=off|note|warning|error, over what the cell says")
      ->type_name("RULE=SEVERITY");
  auto* fail_on = app.add_option("--fail-on", my.fail_on, "findings as severe as this say no")
                      ->check(CLI::IsMember({"note", "warning", "error"}))
                      ->capture_default_str();
  app.add_flag("--strict", my.strict, "the same as --fail-on warning")->excludes(fail_on);
  auto* baseline = app.add_option("--baseline", my.baseline, "findings that are accepted: a file");
  app.add_flag("--update-baseline", my.update_baseline,
               "write what is found now into the baseline, and accept it")
      ->needs(baseline);

  auto* format = app.add_option("--format", my.format, "what standard output gets")
                     ->check(CLI::IsMember({"text", "json", "junit", "sarif", "github"}))
                     ->capture_default_str();
  app.add_flag("--json", my.json, "the same as --format json")->excludes(format);
  app.add_option("-o,--output", my.outputs,
                 "text, json, junit, sarif or github into a file, besides; may be repeated")
      ->type_name("FORMAT=FILE");
  app.add_flag("--force", my.force, "overwrite files of --output");
  app.add_flag("-q,--quiet", my.quiet, "text: counts and verdict alone");
  app.add_option("--most", my.most_a_rule, "text, github: findings shown of one rule; 0: all")
      ->capture_default_str();
  app.add_option("--rule-pages", my.rule_pages, "sarif: where docs/rules lies on the web");

  auto* list = app.add_flag("--list-rules", my.list_rules, "every rule, with its severity");
  auto* explain = app.add_option("--explain", my.explain, "what a rule means, and what to do")
                      ->type_name("RULE");
  list->excludes(explain)->excludes(cell);
  explain->excludes(cell);
}

Result<std::vector<CellRule>> readRuleArguments(const CheckArguments& arguments) {
  std::vector<CellRule> rules;
  for (const std::string& text : arguments.rules) {
    const std::size_t equals = text.find('=');
    CellRule rule;
    rule.id = text.substr(0, equals);
    if (findRule(rule.id) == nullptr) {
      return Error{ErrorKind::bad_argument, "there is no such rule (see --list-rules)",
                   "--rule " + text};
    }
    if (equals == text.npos || !readSeverity(text.substr(equals + 1), rule)) {
      return Error{ErrorKind::bad_argument, "a severity is off, note, warning or error",
                   "--rule " + text};
    }
    rules.push_back(std::move(rule));
  }
  return rules;
}

Severity failOn(const CheckArguments& arguments) {
  if (arguments.strict) return Severity::warning;
  for (const Severity severity : {Severity::note, Severity::warning}) {
    if (arguments.fail_on == nameOf(severity)) return severity;
  }
  return Severity::error;
}

}  // namespace rocinante
