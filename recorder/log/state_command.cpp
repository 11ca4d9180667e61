#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/cli/opened_session.h"
#include "core/log/damage_text.h"
#include "core/session/moment_name.h"
#include "core/session/timeline.h"
#include "recorder/contents/log_state.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct StateCommandOptions {
  std::string log;
  std::string at, event;
  bool json = false;
};

Result<cli::Exit> runState(StateCommandOptions options) {
  const auto opened = cli::openSession(options.log);
  if (!opened) return opened.error();
  options.log = opened->log.string();
  Result<Timeline> session = Timeline::open(options.log);
  if (!session) return session.error();
  if (session->log().summary().messages == 0) {
    return Error{ErrorKind::not_found, "the log has no messages", options.log};
  }
  const Result<LogTime> moment = options.at.empty() ? momentOfEvent(options.event, *session)
                                                    : parseMoment(options.at, *session);
  if (!moment) return moment.error();
  if (*moment < session->start() || *moment > session->end()) {
    const auto shown = [&](LogTime time) { return secondsText(time - session->origin(), 3); };
    return Error{ErrorKind::bad_argument,
                 fmt::format("{} is outside the log, which covers {} to {} s",
                             options.at.empty() ? options.event : options.at,
                             shown(session->start()), shown(session->end())),
                 options.log};
  }
  StateDamage damage;  // all damage found is reported below
  const Result<const SessionState*> state = session->stateAt(*moment, &damage);
  if (!state) return state.error();
  const ShownState shown{options.log, session->origin(), *moment, *state};
  if (Status printed = toStandardOutput(options.json ? stateJson(shown) : stateText(shown));
      !printed) {
    return printed.error();
  }
  for (const KeyframeFault& fault : session->keyframeFaults()) {
    cli::warn(fmt::format("the keyframe at {} s is ignored: {} ({})",
                          secondsText(fault.time - session->origin(), 3), fault.cause,
                          options.log));
  }
  for (const DamageSpan& span : session->log().damage()) {
    cli::warn(damageText(span, options.log));
  }
  cli::warnOfAccount(options.log, nullptr);
  const bool is_whole = session->log().damage().empty() && session->keyframeFaults().empty();
  return is_whole ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

cli::Subcommand addStateCommand(cli::CommandLine program) {
  auto options = std::make_shared<StateCommandOptions>();
  const cli::CommandLine app = program.addSubcommand("state", "print the state at a moment");
  app.addOption("LOG", options->log, "the log to read").required();
  const cli::CommandLine moment = app.addOneOf("moment", "The moment (one of these)");
  moment
      .addOption("--at", options->at,
                 "a session time (12.5s, -1s, RFC 3339), or the text of an event")
      .valueName("TIME");
  moment.addOption("--event", options->event, "the event whose text matches").valueName("PATTERN");
  app.addFlag("--json", options->json, "print JSON");
  return {app, [options] { return runState(*options); }};
}

}  // namespace rocinante
