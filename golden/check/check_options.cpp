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
  auto* live = app.add_option("--live", my.live,
                              "judge live packets received on EP; may be repeated: all of them "
                              "together")
                   ->type_name("EP")
                   ->allow_extra_args(false);
  live->excludes(log)->needs(cell);
  app.add_option("--duration", my.duration, "how long to listen")
      ->needs(live)
      ->capture_default_str();
  app.add_option("--trust", my.trust,
                 "judge only what is signed with a key of this file (rocinante key)")
      ->needs(live)
      ->type_name("FILE");
  cli::addSearchOptions(app, my);

  app.add_option("--rule", my.rules,
                 "set a rule's severity, over the cell's: RULE=off|note|warning|error")
      ->type_name("RULE=SEVERITY");
  auto* fail_on =
      app.add_option("--fail-on", my.fail_on, "exit with 1 if a finding is at least this severe")
          ->check(CLI::IsMember({"note", "warning", "error"}))
          ->capture_default_str();
  app.add_flag("--strict", my.strict, "the same as --fail-on warning")->excludes(fail_on);
  auto* baseline = app.add_option("--baseline", my.baseline, "file of accepted findings");
  app.add_flag("--update-baseline", my.update_baseline,
               "write the current findings into the baseline and accept them")
      ->needs(baseline);

  auto* format = app.add_option("--format", my.format, "the format of standard output")
                     ->check(CLI::IsMember({"text", "json", "junit", "sarif", "github"}))
                     ->capture_default_str();
  app.add_flag("--json", my.json, "the same as --format json")->excludes(format);
  app.add_option("-o,--output", my.outputs,
                 "also write text, json, junit, sarif or github to a file; repeatable")
      ->type_name("FORMAT=FILE");
  app.add_flag("--force", my.force, "overwrite files of --output");
  app.add_flag("-q,--quiet", my.quiet, "text: only counts and verdict");
  app.add_option("--most", my.most_a_rule, "text, github: most findings shown per rule; 0: all")
      ->capture_default_str();
  app.add_option("--rule-pages", my.rule_pages, "sarif: the URL of docs/rules");

  auto* list = app.add_flag("--list-rules", my.list_rules, "list every rule with its severity");
  auto* explain =
      app.add_option("--explain", my.explain, "explain a rule and what to do")->type_name("RULE");
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
      return Error{ErrorKind::bad_argument, "unknown rule (see --list-rules)", "--rule " + text};
    }
    if (equals == text.npos || !readSeverity(text.substr(equals + 1), rule)) {
      return Error{ErrorKind::bad_argument, "the severity must be off, note, warning or error",
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
