// What the window reads of a log in the background: 10 minutes at 6,000 packets a second of one
// arm. How long until the first strokes of six curves, until all of them are whole, until a part
// shown twenty times larger is as fine as pixels are; and the bare reading and folding of the same
// log; with SIGNALS each packet states two of so many signals too, and a derived curve is asked for
// at last. usage: study_bench [SECONDS [FOLDER [SIGNALS]]]
//        study_bench make LOG [SECONDS]     only writes that log, for other benches
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "core/log/log_reader.h"
#include "core/log/log_writer.h"
#include "core/session/message_folder.h"
#include "tests/bench/bench_support.h"
#include "tests/support/joint_packets.h"
#include "viewer/ui/study/log_study.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 6'000;
constexpr std::size_t kColumns = 1200;

void writeLog(const std::filesystem::path& path, std::int64_t seconds, std::int64_t signals) {
  auto writer = bench::need(LogWriter::create(path, {}, "0123456789abcdef0123456789abcdef"));
  const auto channel = bench::need(writer.addChannel("/udp/19960/arm", "rk1", {}));
  for (std::int64_t i = 0; i < seconds * kRateHz; ++i) {
    std::string text = test::jointPacket(static_cast<std::size_t>(i), kRateHz);
    if (signals > 1) {
      const auto number = [](std::int64_t of) { return 0.001 * static_cast<double>(of % 7919); };
      text += fmt::format("signals arm current.{}={:.3f} current.{}={:.3f}\n", 2 * i % signals,
                          number(i), (2 * i + 1) % signals, number(3 * i));
    }
    const std::int64_t time_ns = kOriginNs + i * 1'000'000'000 / kRateHz;
    bench::need(writer.write(channel, static_cast<std::uint32_t>(i), LogTime(Nanoseconds(time_ns)),
                             time_ns, bytesOf(text)));
  }
  bench::need(writer.close("bench"));
}

struct Stopwatch {
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  double cpu = bench::processSeconds();
  double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
  double cpuSpent() const { return bench::processSeconds() - cpu; }
};

bool anyCurve(const StudyPicture& picture) {
  for (const auto& columns : picture.curves) {
    for (const ValueColumn& column : columns) {
      if (column.bin.hasSample()) return true;
    }
  }
  return false;
}

void awaitWhole(LogStudy& study, const StudyQuery& wish) {
  while (true) {
    const auto picture = study.show(wish);
    if (picture && picture->whole && picture->wish == wish) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void benchStudy(const std::filesystem::path& path, std::int64_t seconds) {
  const Cell cell;
  const LogTime start(Nanoseconds{kOriginNs});
  StudyQuery wish;
  wish.from = start;
  wish.until = start + std::chrono::seconds(seconds);
  wish.columns = wish.strip_columns = kColumns;
  for (int joint = 0; joint < 6; ++joint) {
    wish.keys.push_back({SeriesKey::Kind::joint, "arm", std::to_string(joint + 1)});
  }
  const Stopwatch all;
  LogStudy study(cell, path);
  while (true) {
    const auto picture = study.show(wish);
    if (picture && anyCurve(*picture)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  fmt::print("first strokes       {:6.3f} s\n", all.wall());
  awaitWhole(study, wish);
  fmt::print("whole               {:6.3f} s, {:.3f} s of CPU\n", all.wall(), all.cpuSpent());

  const Stopwatch part;
  wish.from = start + std::chrono::seconds(seconds) / 2;
  wish.until = wish.from + std::chrono::seconds(seconds) / 20;
  awaitWhole(study, wish);
  fmt::print("a twentieth of it   {:6.3f} s, {:.3f} s of CPU\n", part.wall(), part.cpuSpent());

  const Stopwatch more;
  wish.keys.pop_back();
  wish.from = start;
  wish.until = start + std::chrono::seconds(seconds);
  awaitWhole(study, wish);
  fmt::print("another choice      {:6.3f} s\n", more.wall());

  const Stopwatch derived;
  wish.keys.push_back(*parseSeriesKey("mean 0.1 d/dt arm.1"));
  awaitWhole(study, wish);
  fmt::print("a derived curve     {:6.3f} s\n", derived.wall());
}

void benchBareFold(const std::filesystem::path& path) {
  const Stopwatch bare;
  auto reader = bench::need(LogReader::open(path));
  MessageFolder folder;
  SessionState state;
  std::uint64_t messages = 0;
  while (const auto message = bench::need(reader.next())) {
    folder.fold(state, *message);
    ++messages;
  }
  fmt::print("bare reading, fold  {:6.3f} s, {:.3f} s of CPU, {} messages\n", bare.wall(),
             bare.cpuSpent(), messages);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string_view(argv[1]) == "make") {
    writeLog(argv[2], argc > 3 ? std::atoll(argv[3]) : 600, 0);
    return 0;
  }
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 600;
  const std::filesystem::path folder = argc > 2 ? argv[2] : "/tmp";
  if (seconds < 20) {
    fmt::print(stderr, "usage: study_bench [SECONDS [FOLDER [SIGNALS]]], at least 20 s\n");
    return 2;
  }
  const auto path = folder / fmt::format("study_bench.{}.mcap", static_cast<long>(::getpid()));
  writeLog(path, seconds, argc > 3 ? std::atoll(argv[3]) : 0);
  benchBareFold(path);
  benchStudy(path, seconds);
  std::filesystem::remove(path);
  return 0;
}
