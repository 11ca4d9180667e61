#include "golden/check/check_options.h"

#include "core/base/duration_text.h"
#include "core/cell/cell_rules.h"
#include "core/check/rules/rule_list.h"
#include "core/cli/search_options.h"

namespace rocinante {

namespace {

void declareWatch(cli::CommandLine app, CheckArguments& arguments, cli::Option live) {
  const cli::Option watch =
      app.addFlag("--watch", arguments.watch,
                  "judge for ever: print each finding when it begins and when it ends")
          .needs(live);
  app.addFlag("--until-finding", arguments.until_finding,
              "end when a finding that --fail-on counts begins")
      .needs(watch);
  app.addOption("--on-finding", arguments.on_finding,
                "run this program, without a shell, for each finding that begins or ends:\n"
                "it reads the finding as JSON from its standard input")
      .needs(watch)
      .valueName("CMD");
  app.addOption("--watch-severity", arguments.watch_severity, "pass over less severe findings")
      .needs(watch)
      .oneOf({"note", "warning", "error"})
      .showDefault();
  app.addOption("--hold", arguments.hold, "a finding ends when it has not occurred for TIME")
      .needs(watch)
      .valueName("TIME")
      .showDefault();
}

Severity severityNamed(std::string_view name) {
  for (const Severity severity : {Severity::note, Severity::warning}) {
    if (name == nameOf(severity)) return severity;
  }
  return Severity::error;
}

}  // namespace

void declareCheck(cli::CommandLine app, CheckArguments& arguments) {
  const cli::Option cell =
      app.addOption("CELL", arguments.cell, "a cell, a model file, or a log that carries its cell");
  const cli::Option log = app.addOption("LOG", arguments.log, "a recorded session");
  const cli::Option live =
      app.addOption("--live", arguments.live,
                    "judge live packets received on EP; may be repeated: all of them "
                    "together")
          .valueName("EP")
          .oneEach();
  live.excludes(log).needs(cell);
  app.addOption("--duration", arguments.duration,
                "how long to listen; default 2s, with --watch until it is stopped")
      .needs(live)
      .valueName("TIME");
  app.addOption("--trust", arguments.trust,
                "judge only what is signed with a key of this file (rocinante key)")
      .needs(live)
      .valueName("FILE");
  app.addOption("--decoders", arguments.decoders,
                "judge what is not packet text as this file declares; default: the cell's")
      .valueName("FILE");
  declareWatch(app, arguments, live);
  cli::addSearchOptions(app, arguments);

  app.addOption("--rule", arguments.rules,
                "set a rule's severity, over the cell's: RULE=off|note|warning|error")
      .valueName("RULE=SEVERITY");
  app.addOption("--preset", arguments.preset, "severities for a purpose, below those of --rule: ci")
      .oneOf({"ci"});
  const cli::Option fail_on = app.addOption("--fail-on", arguments.fail_on,
                                            "exit with 1 if a finding is at least this severe")
                                  .oneOf({"note", "warning", "error"})
                                  .showDefault();
  app.addFlag("--strict", arguments.strict, "the same as --fail-on warning").excludes(fail_on);
  const cli::Option baseline =
      app.addOption("--baseline", arguments.baseline, "file of accepted findings");
  app.addFlag("--update-baseline", arguments.update_baseline,
              "write the current findings into the baseline and accept them")
      .needs(baseline)
      .excludes("--watch");

  const cli::Option format =
      app.addOption("--format", arguments.format, "the format of standard output")
          .oneOf({"text", "json", "junit", "sarif", "github"})
          .showDefault();
  app.addFlag("--json", arguments.json, "the same as --format json").excludes(format);
  app.addOption("-o,--output", arguments.outputs,
                "also write text, json, junit, sarif or github to a file; repeatable")
      .valueName("FORMAT=FILE")
      .excludes("--watch");
  app.addFlag("--force", arguments.force, "overwrite files of --output");
  app.addFlag("-q,--quiet", arguments.quiet, "text: only counts and verdict");
  app.addOption("--most", arguments.most_a_rule,
                "text, github: most findings shown per rule; 0: all")
      .showDefault();
  app.addOption("--rule-pages", arguments.rule_pages, "sarif: the URL of docs/rules");

  const cli::Option list =
      app.addFlag("--list-rules", arguments.list_rules, "list every rule with its severity");
  const cli::Option explain =
      app.addOption("--explain", arguments.explain, "explain a rule and what to do")
          .valueName("RULE");
  list.excludes(explain).excludes(cell);
  explain.excludes(cell);
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
  options.json = arguments.printsJson();
  options.quiet = arguments.quiet;
  return options;
}

}  // namespace rocinante
