#include "player/play/play.h"

#include <algorithm>
#include <utility>

#include "core/base/duration_text.h"
#include "core/session/timeline.h"
#include "core/signing/signed_datagram.h"
#include "player/logs/played_span.h"
#include "player/logs/tape_finder.h"
#include "player/playhead/play_line_text.h"
#include "player/playhead/playhead.h"
#include "player/send/live_line.h"
#include "player/send/udp_send_port.h"

namespace rocinante {
namespace {

std::string namesOf(const std::vector<std::filesystem::path>& paths) {
  std::string names;
  for (const auto& path : paths) names += (names.empty() ? "" : ", ") + path.string();
  return names;
}

Status checkSpan(TapeFinder& finder, const MultiLogReader& logs, const PlayedSpan& span,
                 const PlayOptions& options) {
  if (logs.empty()) {
    return Error{ErrorKind::not_found,
                 options.channels.isAll() ? "nothing to play: no captured message"
                                          : "nothing to play: no message on the chosen channels",
                 namesOf(options.logs)};
  }
  bool any = false;
  if (span.from < span.until) {
    const Result<bool> found = finder.anyIn(span.from, span.until);
    if (!found) return found.error();
    any = *found;
  }
  if (any) return {};
  std::string sentence = "nothing to play: no captured message";
  if (logs.start() <= logs.end()) {
    sentence += " from " + secondsText(span.from - logs.origin()) + " s until " +
                secondsText(span.until - logs.origin()) + " s";
  }
  if (const auto damage = finder.damage(); !damage.empty()) sentence += "; " + damage.front();
  return Error{ErrorKind::not_found, sentence, namesOf(options.logs)};
}

Result<std::optional<PlayedSpan>> loopOf(TapeFinder& finder, const MultiLogReader& logs,
                                         const PlayedSpan& span, const PlayOptions& options) {
  if (!options.loop) return std::optional<PlayedSpan>();
  const Result<PlayedSpan> asked = parseLoop(*options.loop, logs.origin(), logs.end());
  if (!asked) return asked.error();
  const PlayedSpan loop{std::max(asked->from, span.from), std::min(asked->until, span.until)};
  bool any = false;
  if (loop.from < loop.until) {
    const Result<bool> found = finder.anyIn(loop.from, loop.until);
    if (!found) return found.error();
    any = *found;
  }
  if (!any) {
    return Error{ErrorKind::not_found, "nothing to play: no captured message in the loop",
                 *options.loop};
  }
  return std::optional(loop);
}

std::string mannerOf(const PlayOptions& options) {
  if (options.lockstep) return " in lockstep";
  return options.at_once ? std::string(" at once") : " at " + options.speed.text() + "x";
}

}  // namespace

Result<PlayedSpan> parseLoop(std::string_view text, LogTime origin, LogTime end) {
  // Negative times and dates contain hyphens too: use the first split that parses.
  for (std::size_t cut = text.find('-', 1); cut < text.size(); cut = text.find('-', cut + 1)) {
    const auto from = parseSessionTime(text.substr(0, cut), origin, end);
    const auto until = parseSessionTime(text.substr(cut + 1), origin, end);
    if (from && until && *from < *until) return PlayedSpan{*from, *until};
  }
  return Error{ErrorKind::bad_argument,
               "a loop is a number of turns, or A-B with session times, as in 2s-4.5s",
               std::string(text)};
}

Result<PlayReport> play(const PlayOptions& options, const SendSurroundings& surroundings,
                        const PlayControl& control) {
  Result<MultiLogReader> logs = MultiLogReader::open(options.logs, options.channels);
  if (!logs) return logs.error();
  ChannelChoice channels = options.channels;
  if (channels.only.empty() && logs->anyImported()) {
    channels.imported = false;
    logs = MultiLogReader::open(options.logs, channels);
    if (!logs) return logs.error();
    if (logs->empty()) {
      return Error{ErrorKind::not_found,
                   "nothing to play: the messages were imported from another format; send their "
                   "packets with `rocinante source --log LOG`, or name channels with --channel",
                   namesOf(options.logs)};
    }
  }
  Result<TapeFinder> finder = TapeFinder::open(options.logs, channels);
  if (!finder) return finder.error();
  const Result<PlayedSpan> span = playedSpan(*logs, options.from, options.until);
  if (!span) return span.error();
  if (Status judged = checkSpan(*finder, *logs, *span, options); !judged) return judged.error();
  const auto loop = loopOf(*finder, *logs, *span, options);
  if (!loop) return loop.error();
  const Result<PlayRoutes> routes = makeRoutes(*logs, options.to, options.maps, options.keep_ports);
  if (!routes) return routes.error();

  PlayheadOptions how;
  how.span = *span;
  // Looping a part begins with the part.
  if (*loop && !options.from) how.start = (*loop)->from;
  how.turns = options.turns;
  how.loop = *loop;
  how.origin = logs->origin();
  how.end = logs->end();
  how.speed = options.speed;
  if (options.at_once || options.lockstep) how.speed.reset();
  how.start_paused = options.start_paused;
  how.lockstep = options.lockstep;
  how.restate = options.restate;
  how.repeat = options.repeat;
  how.gap_limit = options.gap_limit;
  std::optional<DatagramSigner> signer;
  if (!options.key.empty()) {
    Result<SigningKey> key = SigningKey::read(options.key);
    if (!key) return key.error();
    signer.emplace(std::move(*key), [] { return WallTime(std::chrono::system_clock::now()); });
    how.restated_bytes -= kSignatureBytes;
  }

  Result<UdpSendPort> port =
      UdpSendPort::open(routes->all, how.speed ? options.realtime : Realtime::off,
                        surroundings.stop, control.wake, surroundings.notify);
  if (!port) return port.error();
  surroundings.notify("playing " + namesOf(options.logs) + " to " + options.to.text() +
                      mannerOf(options));
  Result<std::unique_ptr<Playhead>> playhead =
      Playhead::open(*logs, *finder, *routes, how, port->now());
  if (!playhead) return playhead.error();

  PlayReport report;
  PlayJournal journal(span->from, span->until);
  const PlayheadRules rules{options.stays,
                            logs->origin(),
                            logs->end(),
                            options.ack_timeout,
                            signer ? &*signer : nullptr,
                            surroundings.notify};
  Result<SendEnd> end = SendEnd::finished;
  {
    PlayStatus status;
    const LogTime shown_end = std::min(span->until, logs->end());
    const LiveLine line(
        [&] {
          return playLineText(status, logs->origin(), shown_end, std::chrono::steady_clock::now());
        },
        options.progress);
    end = sendPlayhead(**playhead, rules, *port, journal, control.commands, status);
  }
  if (!end) report.failure = end.error();
  if (Status flushed = port->flush(); end && !flushed) report.failure = flushed.error();
  report.to = options.to.text();
  report.speed = (*playhead)->speed();
  playhead->reset();
  report.timing_source = port->timingSource();
  report.scheduling = port->scheduling();
  report.interrupted = end && *end == SendEnd::stopped;
  journal.writeTo(report, end && *end == SendEnd::finished);
  for (const auto& log : options.logs) report.inputs.push_back(log.string());
  report.damage = logs->damage();
  if (!finder->stateDamage().empty()) {
    report.damage.push_back("a restated state may be outdated: " + finder->stateDamage().text());
  }
  return report;
}

}  // namespace rocinante
