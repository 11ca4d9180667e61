// Writing a session of six-joint packets with full doubles as a table: its CPU beside a bare loop
// that formats and writes the same values, which it has in memory. The table is made of the log, in
// two passes: one finds the columns, one writes the rows. usage: table_bench [ROWS [FOLDER]]
#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/log/log_writer.h"
#include "core/mcap/file_sink.h"
#include "recorder/export/exports.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;

constexpr int kRuns = 3;
constexpr std::size_t kJoints = 6;
constexpr std::int64_t kStart = 1'770'091'506'000'000'000;
constexpr std::int64_t kStep = 2'000'000;

double valueAt(std::size_t row, std::size_t joint) {
  return 1.7 * std::sin(static_cast<double>(row) * 1e-4 * static_cast<double>(joint + 1));
}

void makeLog(const std::filesystem::path& path, std::size_t rows) {
  LogWriterOptions options;
  options.overwrite = true;
  Result<LogWriter> writer = LogWriter::create(path, options, "bench");
  const ChannelId channel = *writer->addChannel("/udp/1/10.0.0.1", "rk1", {});
  std::string text;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto time = static_cast<std::int64_t>(kStart + static_cast<std::int64_t>(row) * kStep);
    text = fmt::format("RK1 arm@bench {} -\njoint arm", row);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      text += fmt::format(" j{}={}", joint + 1, valueAt(row, joint));
    }
    (void)writer->write(channel, static_cast<std::uint32_t>(row), LogTime(Nanoseconds(time)), time,
                        bytesOf(text));
  }
  (void)writer->close("bench");
}

std::unique_ptr<ByteSink> sinkOf(const std::filesystem::path& path) {
  return makeFileSinkOn(::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600),
                        path.string());
}

/// The least that anybody must do: shortest decimals of the same doubles, in blocks to a file.
void bareLoop(const std::vector<double>& values, const std::filesystem::path& out) {
  const std::unique_ptr<ByteSink> sink = sinkOf(out);
  std::string block = "t";
  for (std::size_t joint = 0; joint < kJoints; ++joint) block += fmt::format(",arm.j{}", joint + 1);
  block += '\n';
  char digits[32];
  for (std::size_t row = 0; row < values.size() / kJoints; ++row) {
    const auto seconds = static_cast<double>(row) * (static_cast<double>(kStep) * 1e-9);
    block.append(digits, std::to_chars(digits, digits + sizeof digits, seconds).ptr);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      block += ',';
      const double value = values[row * kJoints + joint];
      block.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    }
    block += '\n';
    if (block.size() < (std::size_t{1} << 16U)) continue;
    (void)sink->append(bytesOf(block));
    block.clear();
  }
  (void)sink->append(bytesOf(block));
  (void)sink->close();
}

void exportTable(const std::filesystem::path& log, const std::filesystem::path& out, bool npz) {
  Result<MomentWalk> session = MomentWalk::open(log);
  SessionTable table(nullptr, {});
  const std::unique_ptr<ByteSink> sink = sinkOf(out);
  const auto writer = npz ? makeNpzTable(*sink, out.parent_path().string())
                          : makeCsvTable([&](ByteView bytes) { return sink->append(bytes); });
  TableOptions options;
  options.from = LogTime::min();
  options.until = LogTime::max();
  const Result<TableReport> report = writeTable(*session, table, *writer, options);
  if (!report) fmt::print("{}\n", report.error().text());
  (void)sink->close();
}

template <class Work>
double leastCpu(const Work& work) {
  double least = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    const double before = bench::processSeconds();
    work();
    least = std::min(least, bench::processSeconds() - before);
  }
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t rows = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500'000;
  const std::filesystem::path folder = argc > 2 ? argv[2] : std::filesystem::temp_directory_path();
  const auto log = folder / "table_bench_log.mcap";
  const auto out = folder / "table_bench_out";
  makeLog(log, rows);
  std::vector<double> values;
  for (std::size_t i = 0; i < rows * kJoints; ++i) {
    values.push_back(valueAt(i / kJoints, i % kJoints));
  }
  const auto count = static_cast<double>(values.size());
  const double bare_s = leastCpu([&] { bareLoop(values, out); });
  fmt::print("bare loop  {:5.2f} M values/s  {:.0f} MB\n", count / bare_s * 1e-6,
             static_cast<double>(std::filesystem::file_size(out)) * 1e-6);
  for (const bool npz : {false, true}) {
    const double table_s = leastCpu([&] { exportTable(log, out, npz); });
    fmt::print("{}  {:5.2f} M values/s  {:.0f} MB  {:.2f} of the bare loop's CPU\n",
               npz ? "table .npz" : "table .csv", count / table_s * 1e-6,
               static_cast<double>(std::filesystem::file_size(out)) * 1e-6, table_s / bare_s);
  }
  std::filesystem::remove(log);
  std::filesystem::remove(out);
}
