#include "golden/check/check_live.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/base/figure_text.h"
#include "core/check/check.h"
#include "core/check/judges/tally.h"
#include "core/check/session_check.h"
#include "core/cli/program.h"
#include "golden/check/live_input.h"

namespace rocinante {
namespace {

constexpr std::int64_t kLongestWaitMs = 100;

}  // namespace

void tellDecoded(const decode::DecodeAccount& decoded, CheckReport& report) {
  cli::warn(
      fmt::format("decoded {} of {}:", decoded.decoded(), countText(decoded.octets, "datagram")));
  cli::tell(decode::accountText(decoded));
  if (decoded.left_out.empty()) return;
  report.findings.push_back(makeFinding("log.left-out", "", accountSentence(decoded.left_out)));
  report.findings.back().count = decoded.left_out.total();
}

Result<CheckReport> checkLive(const Cell& cell, const LiveCheckOptions& options) {
  SessionCheck session(cell);
  Result<LiveInput> opened = LiveInput::open(
      options.endpoints, options.trust_file, options.decoders, LiveTime::arrival,
      [&](LogTime time, const LiveDatagram& datagram) { judge(session, time, datagram); });
  if (!opened) return opened.error();
  LiveInput& input = *opened;
  const bool is_file = input.isFile();
  cli::catchStopSignals();
  cli::warn((is_file ? "reading " : "listening on ") + input.names());
  const auto deadline = std::chrono::steady_clock::now() + options.duration;
  while (!cli::stopRequested() && !input.ended()) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    // A capture file is always read to its end.
    if (left.count() <= 0 && !is_file) break;
    const auto wait_ms = is_file ? 0 : std::min<std::int64_t>(left.count(), kLongestWaitMs);
    if (Status passed = input.pass(wait_ms); !passed) return passed.error();
  }
  input.warnOfSilence();
  for (const LossSpan& loss : input.takeLosses()) session.addLoss(loss);
  session.settle();
  CheckReport report = checkSession(cell, session);
  if (const auto untrusted = input.untrusted()) {
    if (untrusted->total() > 0) {
      cli::warn(fmt::format("{} not trusted: {}", countText(untrusted->total(), "datagram"),
                            untrusted->text()));
    }
    for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
      report.untrusted.emplace_back(nameOf(static_cast<Untrusted>(i)), untrusted->by_reason[i]);
    }
  }
  if (const auto decoded = input.decoded()) {
    tellDecoded(*decoded, report);
  }
  report.session = input.names();
  report.origin = input.first().value_or(LogTime{});
  report.duration = input.last().value_or(LogTime{}) - input.first().value_or(LogTime{});
  report.interrupted = cli::stopRequested();
  conclude(report);
  return report;
}

}  // namespace rocinante
