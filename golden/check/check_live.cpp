#include "golden/check/check_live.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <chrono>

#include "core/base/count_text.h"
#include "core/check/check.h"
#include "core/check/session_check.h"
#include "core/cli/program.h"
#include "core/transport/open_source.h"

namespace rocinante {
namespace {

// One endpoint under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 64;
constexpr std::int64_t kLongestWaitMs = 100;

LogTime logTimeOf(WallTime time) { return LogTime(time.time_since_epoch()); }

Result<Sources> openAll(const std::vector<std::string>& texts, const std::string& trust_file) {
  std::vector<Endpoint> endpoints;
  for (const std::string& text : texts) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    endpoints.push_back(*endpoint);
  }
  auto trust = TrustJudge::open(trust_file);
  if (!trust) return trust.error();
  InputOptions listening;
  listening.trust = std::move(*trust);
  return openSources(endpoints, listening);
}

/// Feeds what several sources receive to one SessionCheck.
class Listening {
 public:
  Listening(Sources sources, const Cell& cell)
      : session(cell), sources_(std::move(sources)), received_(sources_.size()) {
    // Shows the bound ports: ":0" takes a free one.
    for (const auto& each : sources_) names_.push_back(boundText(*each));
  }

  bool isFile() const { return !sources_[0]->endpoint().file.empty(); }
  bool ended() const { return sources_[0]->ended(); }
  std::string names() const { return fmt::format("{}", fmt::join(names_, " ")); }

  /// Waits for datagrams, at most this long, and judges those that wait.
  Status pass(std::int64_t wait_ms) {
    std::vector<pollfd> waiting;
    for (const auto& each : sources_) {
      if (const auto said = each->maintain()) cli::warn(*said);
      waiting.push_back({each->fileDescriptor(), POLLIN, 0});
    }
    ::poll(waiting.data(), waiting.size(), static_cast<int>(wait_ms));
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (Status drained = drain(i); !drained) return drained;
    }
    return {};
  }

  /// Reports what the kernel dropped, and endpoints at which nothing arrived.
  void finish() {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const bool others_heard = first.has_value() && sources_.size() > 1;
      if (received_[i] == 0 && others_heard) {
        cli::warn(fmt::format("nothing arrived at {}", names_[i]));
      }
      const auto dropped = sources_[i]->droppedByNow();
      if (!dropped || *dropped == 0) continue;
      LossSpan loss;
      loss.endpoint = names_[i];
      loss.from = first.value_or(LogTime{});
      loss.until = last.value_or(LogTime{});
      loss.counts.kernel = *dropped;
      session.addLoss(loss);
    }
  }

  /// What a trust file refused, by reason; empty without one.
  std::optional<UntrustedCounts> untrusted() const {
    std::optional<UntrustedCounts> all;
    for (const auto& each : sources_) {
      if (const auto one = each->counts().untrusted) {
        if (!all) all.emplace();
        *all += *one;
      }
    }
    return all;
  }

  SessionCheck session;
  std::optional<LogTime> first, last;

 private:
  Status drain(std::size_t index) {
    for (int turn = 0; turn < kBatchesATurn; ++turn) {
      const auto datagrams = sources_[index]->receive();
      if (!datagrams) return datagrams.error();
      if (datagrams->empty()) break;
      received_[index] += datagrams->size();
      for (const ReceivedDatagram& datagram : *datagrams) {
        // Session time must not decrease, but the kernel's clock may be set back, and the times of
        // several sockets are only nearly in order.
        last = std::max(last.value_or(LogTime{}), logTimeOf(datagram.kernel_time));
        if (!first) first = last;
        session.add(*last, encodingOf(datagram.payload), true, datagram.payload);
      }
    }
    return {};
  }

  Sources sources_;
  std::vector<std::uint64_t> received_;
  std::vector<std::string> names_;
};

}  // namespace

Result<CheckReport> checkLive(const Cell& cell, const std::vector<std::string>& endpoints,
                              const std::string& trust_file, Nanoseconds duration) {
  Result<Sources> sources = openAll(endpoints, trust_file);
  if (!sources) return sources.error();
  Listening input(std::move(*sources), cell);
  const bool is_file = input.isFile();
  cli::catchStopSignals();
  cli::warn((is_file ? "reading " : "listening on ") + input.names());
  const auto deadline = std::chrono::steady_clock::now() + duration;
  while (!cli::stopRequested() && !input.ended()) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    // A capture file is always read to its end.
    if (left.count() <= 0 && !is_file) break;
    const auto wait_ms = is_file ? 0 : std::min<std::int64_t>(left.count(), kLongestWaitMs);
    if (Status passed = input.pass(wait_ms); !passed) return passed.error();
  }
  input.finish();
  input.session.settle();
  CheckReport report = checkSession(cell, input.session);
  if (const auto untrusted = input.untrusted()) {
    if (untrusted->total() > 0) {
      cli::warn(fmt::format("{} not trusted: {}", countText(untrusted->total(), "datagram"),
                            untrusted->text()));
    }
    for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
      report.untrusted.emplace_back(nameOf(static_cast<Untrusted>(i)), untrusted->by_reason[i]);
    }
  }
  report.session = input.names();
  report.origin = input.first.value_or(LogTime{});
  report.duration = input.last.value_or(LogTime{}) - input.first.value_or(LogTime{});
  report.interrupted = cli::stopRequested();
  conclude(report);
  return report;
}

}  // namespace rocinante
