// How exactly a recording comes back: rocinante-play beside tcpreplay and lcm-logplayer, the same
// schedule over the same wire (a veth pair in namespaces of its own) to the same listener, by the
// kernel's receive stamps. Each under SCHED_FIFO and without. Needs root; peers that are not
// installed have a line that says so.
// usage: replay_bench [--all | --smoke] [--rate=HZ] [SECONDS]
//   --all      every rate at every speed (half an hour); else the usual ones (six minutes)
//   --smoke    one short row, that it works at all
//   --rate=HZ  only the rows of this rate
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "tests/bench/replay/replay_errors.h"
#include "tests/bench/replay/replay_schedule.h"
#include "tests/bench/replay/replay_wire.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace rocinante;
using namespace rocinante::bench;

struct Row {
  double rate_hz;  ///< on the wire
  bool is_poisson;
  const char* speed;
};

struct Outcome {
  ReplayErrors errors;
  std::uint64_t disorder = 0;
  double cpu_share = 0;
};

struct Player {
  std::string name;
  std::string path;  ///< empty: not installed
};

std::string installed(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::string rest = path != nullptr ? path : "";
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::string candidate = rest.substr(0, colon) + "/" + name;
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
    rest.erase(0, colon + 1);
  }
  return {};
}

/// CPU time over time, or empty when the program failed.
std::optional<double> run(const std::vector<std::string>& words, bool fifo,
                          const std::filesystem::path& said) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const ::pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sched_param parameters{};
    parameters.sched_priority = 10;
    if (fifo && ::sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) ::_exit(126);
    const int out = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::dup2(out, 1);
    ::dup2(out, 2);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return (seconds(usage.ru_utime) + seconds(usage.ru_stime)) / wall.count();
}

class Bench {
 public:
  Bench(ReplayWire& wire, std::vector<Player> players, double seconds)
      : wire_(wire), players_(std::move(players)), seconds_(seconds) {}

  void measure(const Row& row) {
    const PlaybackSpeed speed = PlaybackSpeed::parse(row.speed).value();
    const double log_rate = row.rate_hz / speed.ratio();
    const auto count = static_cast<std::size_t>(
        std::clamp(row.rate_hz * seconds_, 200.0, static_cast<double>(ReplayWire::kMax)));
    const Schedule schedule =
        row.is_poisson ? Schedule::poisson(log_rate, count) : Schedule::regular(log_rate, count);
    if (const Status written = writeMcap(folder_ / "log.mcap", schedule); !written) {
      fmt::print("failed: {}\n", written.error().text());
      return;
    }
    writePcap(folder_ / "log.pcap", schedule, wire_.from(), wire_.to().address);
    writeLcm(folder_ / "log.lcm", schedule);
    fmt::print("{:.0f}/s {}, {}x, {} datagrams\n", row.rate_hz,
               row.is_poisson ? "Poisson" : "regular", row.speed, count);
    for (const bool fifo : {true, false}) {
      std::optional<Outcome> ours;
      for (const Player& player : players_) {
        std::optional<Outcome> outcome;
        if (!player.path.empty()) outcome = play(player, schedule, speed, fifo);
        tell(player, fifo, outcome, ours);
        if (&player == &players_[0]) ours = outcome;
        judge(row, player, fifo, outcome, ours);
      }
    }
    std::fflush(stdout);
  }

  void conclude() const {
    fmt::print("\n{} of {} bars met\n", bars_ - missed_.size(), bars_);
    for (const std::string& line : missed_) fmt::print("  missed: {}\n", line);
  }

 private:
  std::optional<Outcome> play(const Player& player, const Schedule& schedule,
                              const PlaybackSpeed& speed, bool fifo) {
    wire_.clear(schedule.due.size());
    std::vector<std::string> words{player.path};
    const std::string times = fmt::format("{}", speed.ratio());
    if (player.name == "rocinante-play") {
      words.insert(words.end(), {(folder_ / "log.mcap").string(), "--to", wire_.to().text(),
                                 "--speed", speed.text(), "--realtime", fifo ? "on" : "off"});
    } else if (player.name == "tcpreplay") {
      words.insert(words.end(), {"--preload-pcap", "-i", wire_.interface(), "--multiplier", times,
                                 (folder_ / "log.pcap").string()});
    } else {
      words.insert(words.end(),
                   {"--lcm-url", fmt::format("udpm://{}?ttl=1", wire_.to().address.text()),
                    "--speed", times, (folder_ / "log.lcm").string()});
    }
    // Our own asks for what it needs; its reading thread is an ordinary one.
    const bool given = fifo && player.name != "rocinante-play";
    const auto cpu_share = run(words, given, folder_ / "said");
    if (!cpu_share) return std::nullopt;
    wire_.settle(schedule.due.size());
    return Outcome{replayErrors(schedule.due, wire_.arrivals(schedule.due.size()), speed),
                   wire_.disorder(), *cpu_share};
  }

  static void tell(const Player& player, bool fifo, const std::optional<Outcome>& outcome,
                   const std::optional<Outcome>& ours) {
    const std::string who = fmt::format("  {:<15} {:<5}", player.name, fifo ? "fifo" : "other");
    if (!outcome) {
      fmt::print("{} {}\n", who, player.path.empty() ? "not installed" : "failed");
      return;
    }
    const ReplayErrors& errors = outcome->errors;
    fmt::print(
        "{} {:>7} came  p50 {:>9.1f}  p99 {:>9.1f}  max {:>9.1f}  drift {:>9.1f} us  cpu {:>3.0f} "
        "%",
        who, errors.arrived, errors.p50_us, errors.p99_us, errors.max_us, errors.drift_us,
        100 * outcome->cpu_share);
    if (ours) {
      fmt::print("  {:.1f}x {:.1f}x {:.1f}x", errors.p50_us / ours->errors.p50_us,
                 errors.p99_us / ours->errors.p99_us,
                 std::abs(errors.drift_us) / std::max(0.1, std::abs(ours->errors.drift_us)));
    }
    if (outcome->disorder > 0) fmt::print("  {} OUT OF ORDER", outcome->disorder);
    fmt::print("\n");
  }

  void bar(bool met, const std::string& line) {
    ++bars_;
    if (!met) missed_.push_back(line);
  }

  void judge(const Row& row, const Player& player, bool fifo, const std::optional<Outcome>& outcome,
             const std::optional<Outcome>& ours) {
    if (!outcome || !ours) return;
    const std::string where =
        fmt::format("{:.0f}/s {} {}x {}", row.rate_hz, row.is_poisson ? "Poisson" : "regular",
                    row.speed, fifo ? "fifo" : "other");
    const ReplayErrors& errors = outcome->errors;
    const ReplayErrors& own = ours->errors;
    const double drift = std::abs(own.drift_us);
    if (player.name != "rocinante-play") {
      const auto better = [&](const char* what, double we, double they) {
        bar(we < they,
            fmt::format("{}: {} {:.1f} us, {} {:.1f} us", where, what, we, player.name, they));
      };
      better("p50", own.p50_us, errors.p50_us);
      better("p99", own.p99_us, errors.p99_us);
      // Within the width of the bar both are there.
      better("drift", drift <= 10 ? 0 : drift, std::max(0.01, std::abs(errors.drift_us)));
      return;
    }
    bar(outcome->disorder == 0, where + ": order");
    if (!fifo) return;
    bar(drift <= 100, fmt::format("{}: drift {:.1f} us", where, own.drift_us));
    if (row.rate_hz != 1'000 && row.rate_hz != 6'000) return;
    bar(own.p50_us <= 10, fmt::format("{}: p50 {:.1f} us", where, own.p50_us));
    bar(own.p99_us <= 50, fmt::format("{}: p99 {:.1f} us", where, own.p99_us));
    bar(outcome->cpu_share <= 0.5,
        fmt::format("{}: cpu {:.0f} %", where, 100 * outcome->cpu_share));
  }

  ReplayWire& wire_;
  std::vector<Player> players_;
  double seconds_;
  test::TemporaryFolder folder_;
  std::size_t bars_ = 0;
  std::vector<std::string> missed_;
};

std::vector<Row> rowsOf(bool all) {
  std::vector<Row> rows;
  for (const double rate : {100.0, 1'000.0, 6'000.0, 50'000.0}) {
    for (const bool is_poisson : {false, true}) {
      for (const char* speed : {"1", "3", "10", "0.1"}) {
        const bool is_usual = std::string_view(speed) == "1" || (rate == 6'000 && is_poisson);
        if (all || is_usual) rows.push_back({rate, is_poisson, speed});
      }
    }
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  bool all = false;
  bool smoke = false;
  double rate_hz = 0;
  double seconds = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    all = all || word == "--all";
    smoke = smoke || word == "--smoke";
    if (word.starts_with("--rate=")) rate_hz = std::atof(argv[i] + 7);
    if (!word.starts_with("--")) seconds = std::atof(argv[i]);
  }
  if (seconds <= 0) seconds = smoke ? 0.5 : 5;
  const auto wire = ReplayWire::make();
  if (!wire) {
    fmt::print("replay_bench: skipped: {}\n", wire.error().text());
    return 0;
  }
  const auto own = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "rocinante-play";
  std::vector<Player> players{{"rocinante-play", own.string()},
                              {"tcpreplay", installed("tcpreplay")},
                              {"lcm-logplayer", installed("lcm-logplayer")}};
  Bench bench(**wire, std::move(players), seconds);
  fmt::print("error by kernel receive stamps; at the end of a peer's line, how many times ours:\n");
  const std::vector<Row> rows = smoke ? std::vector<Row>{{1'000, true, "1"}} : rowsOf(all);
  for (const Row& row : rows) {
    if (rate_hz == 0 || row.rate_hz == rate_hz) bench.measure(row);
  }
  bench.conclude();
}
