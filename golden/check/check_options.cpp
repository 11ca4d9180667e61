#include "golden/check/check_options.h"

#include <CLI/CLI.hpp>

#include "core/base/duration_text.h"
#include "core/cell/cell_rules.h"
#include "core/check/rules/rule_list.h"
#include "core/cli/search_options.h"

namespace rocinante {

namespace {

void declareWatch(CLI::App& app, CheckArguments& my, CLI::Option* live) {
  auto* watch = app.add_flag("--watch", my.watch,
                             "judge for ever: print each finding when it begins and when it ends")
                    ->needs(live);
  app.add_flag("--until-finding", my.until_finding,
               "end when a finding that --fail-on counts begins")
      ->needs(watch);
  app.add_option("--on-finding", my.on_finding,
                 "run this program, without a shell, for each finding that begins or ends:\n"
                 "it reads the finding as JSON from its standard input")
      ->needs(watch)
      ->type_name("CMD");
  app.add_option("--watch-severity", my.watch_severity, "pass over less severe findings")
      ->needs(watch)
      ->check(CLI::IsMember({"note", "warning", "error"}))
      ->capture_default_str();
  app.add_option("--hold", my.hold, "a finding ends when it has not occurred for TIME")
      ->needs(watch)
      ->type_name("TIME")
      ->capture_default_str();
}

Severity severityNamed(std::string_view name) {
  for (const Severity severity : {Severity::note, Severity::warning}) {
    if (name == nameOf(severity)) return severity;
  }
  return Severity::error;
}

}  // namespace

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
  app.add_option("--duration", my.duration,
                 "how long to listen; default 2s, with --watch until it is stopped")
      ->needs(live)
      ->type_name("TIME");
  app.add_option("--trust", my.trust,
                 "judge only what is signed with a key of this file (rocinante key)")
      ->needs(live)
      ->type_name("FILE");
  app.add_option("--decoders", my.decoders,
                 "judge what is not packet text as this file declares; default: the cell's")
      ->type_name("FILE");
  declareWatch(app, my, live);
  cli::addSearchOptions(app, my);

  app.add_option("--rule", my.rules,
                 "set a rule's severity, over the cell's: RULE=off|note|warning|error")
      ->type_name("RULE=SEVERITY");
  app.add_option("--preset", my.preset, "severities for a purpose, below those of --rule: ci")
      ->check(CLI::IsMember({"ci"}));
  auto* fail_on =
      app.add_option("--fail-on", my.fail_on, "exit with 1 if a finding is at least this severe")
          ->check(CLI::IsMember({"note", "warning", "error"}))
          ->capture_default_str();
  app.add_flag("--strict", my.strict, "the same as --fail-on warning")->excludes(fail_on);
  auto* baseline = app.add_option("--baseline", my.baseline, "file of accepted findings");
  app.add_flag("--update-baseline", my.update_baseline,
               "write the current findings into the baseline and accept them")
      ->needs(baseline)
      ->excludes("--watch");

  auto* format = app.add_option("--format", my.format, "the format of standard output")
                     ->check(CLI::IsMember({"text", "json", "junit", "sarif", "github"}))
                     ->capture_default_str();
  app.add_flag("--json", my.json, "the same as --format json")->excludes(format);
  app.add_option("-o,--output", my.outputs,
                 "also write text, json, junit, sarif or github to a file; repeatable")
      ->type_name("FORMAT=FILE")
      ->excludes("--watch");
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
  if (arguments.preset == "ci") {
    // Nobody looks at the picture: what a robot cannot have done fails.
    CellRule& jump = rules.emplace_back();
    jump.id = "joint.jump";
    jump.severity = Severity::error;
  }
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
  return arguments.strict ? Severity::warning : severityNamed(arguments.fail_on);
}

Result<Nanoseconds> readPositive(const std::string& text, const char* option) {
  const Result<Nanoseconds> duration = parseDuration(text);
  if (!duration) return duration.error();
  if (duration->count() <= 0) {
    return Error{ErrorKind::bad_argument, "must be greater than zero", option};
  }
  return *duration;
}

Result<CheckWatchOptions> readWatchArguments(const CheckArguments& arguments) {
  CheckWatchOptions options;
  if (arguments.format != "text" && arguments.format != "json") {
    return Error{ErrorKind::bad_argument, "a watch prints text or json",
                 "--format " + arguments.format};
  }
  const Result<Nanoseconds> hold = readPositive(arguments.hold, "--hold");
  if (!hold) return hold.error();
  options.hold = *hold;
  if (!arguments.duration.empty()) {
    const Result<Nanoseconds> duration = readPositive(arguments.duration, "--duration");
    if (!duration) return duration.error();
    options.duration = *duration;
  }
  options.endpoints = arguments.live;
  options.trust_file = arguments.trust;
  options.least = severityNamed(arguments.watch_severity);
  options.fail_on = failOn(arguments);
  options.until_finding = arguments.until_finding;
  options.command = arguments.on_finding;
  options.json = arguments.wantsJson();
  options.quiet = arguments.quiet;
  return options;
}

}  // namespace rocinante
