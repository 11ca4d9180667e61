// A check of a long session: 10 minutes at 6,000 packets a second, of six arms in a cell that lists
// their sources, each restating its order. CPU of one thread, beside reading the same log and
// doing nothing, and beside reading and folding it; and how often judging allocates memory.
// usage: check_bench [SECONDS [FOLDER]]
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "core/check/check.h"
#include "core/check/session_check.h"
#include "core/log/log_writer.h"
#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"
#include "tests/bench/bench_support.h"

namespace {

std::uint64_t allocations = 0;

}  // namespace

void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* const memory = std::malloc(bytes)) return memory;
  std::abort();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 6'000;
constexpr std::size_t kArms = 6, kJoints = 6;
constexpr double kBarSeconds = 3;

void writeLog(const std::filesystem::path& path, std::int64_t packets) {
  SessionWriter writer(bench::need(LogWriter::create(path, {}, "check bench")), {});
  std::vector<ChannelId> channels;
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    channels.push_back(
        bench::need(writer.addChannel(fmt::format("/udp/19960/control{}", arm), "rk1", {})));
  }
  std::string text;
  for (std::int64_t i = 0; i < packets; ++i) {
    const std::size_t arm = static_cast<std::size_t>(i) % kArms;
    const std::int64_t sequence = i / static_cast<std::int64_t>(kArms);
    const std::int64_t ns = i * 1'000'000'000 / kRateHz;
    const double t = static_cast<double>(ns) * 1e-9;
    const bool restates = sequence % 2000 == 0;
    text = fmt::format("RK1 control{}@7f3a {} {:.6f}{}\n", arm, sequence, 1'770'091'506.0 + t,
                       restates && sequence > 0 ? " restated" : "");
    if (restates) text += fmt::format("order arm{} j0 j1 j2 j3 j4 j5\n", arm);
    text += fmt::format("joints arm{}", arm);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const double phase = static_cast<double>(joint);
      text += fmt::format(" {:.5f}", 1.5 * std::sin(t * (0.3 + 0.17 * phase) + phase));
    }
    text += "\n";
    bench::need(writer.write(channels[arm], static_cast<std::uint32_t>(sequence),
                             LogTime(Nanoseconds(kOriginNs + ns + 200'000)), kOriginNs + ns,
                             bytesOf(text)));
  }
  bench::need(writer.log().close("done"));
}

/// Reads the whole log, and folds it when told to.
double floorSeconds(const std::filesystem::path& path, bool folds) {
  LogReader log = bench::need(LogReader::open(path));
  SessionState state;
  const auto decoder = makeDecoder("rk1");
  const double began = bench::processSeconds();
  while (const auto message = bench::need(log.next())) {
    if (!folds || !message->channel->captured()) continue;
    const Packet* const packet = decoder->decode(message->payload);
    if (packet != nullptr) state.apply(message->log_time, *packet);
  }
  return bench::processSeconds() - began;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 600;
  const std::filesystem::path folder =
      argc > 2 ? std::filesystem::path(argv[2])
               : std::filesystem::temp_directory_path() / fmt::format("check_bench_{}", ::getpid());
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / "session.mcap";
  const std::int64_t packets = seconds * kRateHz;
  bench::writeArms(folder, kArms, kJoints);
  writeLog(path, packets);
  const Cell cell = bench::need(loadCell(folder / "cell.toml", {}));

  const double read = floorSeconds(path, false);
  const double folded = floorSeconds(path, true);
  LogReader log = bench::need(LogReader::open(path));
  const std::uint64_t allocated_before = allocations;
  const double began = bench::processSeconds();
  const CheckReport report = bench::need(checkLog(cell, log));
  const double checked = bench::processSeconds() - began;
  const std::uint64_t allocated = allocations - allocated_before;

  fmt::print("{} packets, {:.0f} MB of log, {} findings\n", packets,
             static_cast<double>(std::filesystem::file_size(path)) * 1e-6, report.findings.size());
  fmt::print("read                  {:6.2f} s\n", read);
  fmt::print("read, decode, fold    {:6.2f} s\n", folded);
  fmt::print("check                 {:6.2f} s   {:.2f} x read and fold, {:.2f} M packets/s\n",
             checked, checked / folded, static_cast<double>(packets) * 1e-6 / checked);
  fmt::print("allocations           {:.4f} a packet\n",
             static_cast<double>(allocated) / static_cast<double>(packets));
  if (seconds == 600) {
    fmt::print("bar                   {:6.2f} s   {}\n", kBarSeconds,
               checked <= kBarSeconds ? "met" : "MISSED");
  }
  if (argc <= 2) std::filesystem::remove_all(folder);
  // A bench of a session in which something is wrong measures something else.
  return report.findings.empty() ? 0 : 1;
}
