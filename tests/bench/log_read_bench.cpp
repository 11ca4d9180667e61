// Reading logs of 10 million messages of 100 bytes in chunks of 1 MiB, zstd and uncompressed: in
// time order both ways, beside a bare loop over the same chunks; opening; seeking; opening one that
// was cut. usage: log_read_bench [MESSAGES]
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "core/log/log_writer.h"
#include "core/log/mapped_file.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;
using Compression = LogWriterOptions::Compression;

constexpr std::int64_t kFirst_ns = 1'770'000'000'000'000'000;
constexpr std::int64_t kStep_ns = 166'667;  // 6,000 a second

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "log_read_bench: %s\n", what.c_str());
  std::exit(2);
}

template <class T>
T must(Result<T> result) {
  if (!result) fail(result.error().text());
  return std::move(*result);
}

template <class Work>
double wallMilliseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Of this process, in MB, without what is mapped from files.
double anonymousMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kilobytes = 0;
    if (word == "RssAnon:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

void writeLog(const std::filesystem::path& path, Compression compression, std::int64_t messages) {
  LogWriterOptions options;
  options.compression = compression;
  LogWriter writer = must(LogWriter::create(path, options, "bench"));
  const ChannelId channel = must(writer.addChannel("/udp/19960/arm", "rk1", {}));
  std::mt19937_64 random(7);
  std::string payload;
  for (std::int64_t i = 0; i < messages; ++i) {
    payload.clear();
    fmt::format_to(std::back_inserter(payload), "RK1 arm@7f3a {} {}.{:06}\njoints arm", i,
                   kFirst_ns / 1'000'000'000 + i / 6000, i % 6000 * 166);
    const std::uint64_t bits = random();
    for (unsigned joint = 0; joint < 6; ++joint) {
      fmt::format_to(std::back_inserter(payload), " {}.{:04}", joint % 3,
                     (bits >> (10 * joint)) % 10000);
    }
    payload.resize(100, '\n');
    const Status written =
        writer.write(channel, static_cast<std::uint32_t>(i),
                     LogTime(Nanoseconds(kFirst_ns + i * kStep_ns)), 0, bytesOf(payload));
    if (!written) fail(written.error().text());
  }
  if (const Status closed = writer.close("finished"); !closed) fail(closed.error().text());
}

/// In a process of its own, so that the memory it took is not counted as the reader's.
void writeLogApart(const std::filesystem::path& path, Compression compression,
                   std::int64_t messages) {
  const pid_t child = ::fork();
  if (child < 0) fail("cannot fork");
  if (child == 0) {
    writeLog(path, compression, messages);
    ::_exit(0);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child || status != 0) fail("the log could not be written");
}

/// Nothing but expanding every chunk, its checksum, and a look at each message.
double floorCpuSeconds(const std::filesystem::path& path) {
  const MappedFile mapped = must(MappedFile::open(path));
  const ByteView file = mapped.bytes();
  const double start = bench::processSeconds();
  Bytes expanded;
  std::uint64_t sum = 0;
  ZSTD_DCtx* const context = ZSTD_createDCtx();
  for (std::uint64_t position = 8; position < file.size();) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, position);
    if (!record) break;
    position = record->end();
    mcap::Chunk chunk;
    if (record->opcode != mcap::Opcode::chunk || !mcap::parse(record->content, chunk)) continue;
    ByteView records = chunk.records;
    if (!chunk.compression.empty()) {
      expanded.resize(chunk.uncompressed_size);
      const std::size_t made = ZSTD_decompressDCtx(context, expanded.data(), expanded.size(),
                                                   records.data(), records.size());
      if (ZSTD_isError(made) != 0U) fail("a chunk does not decompress");
      records = expanded;
    }
    if (crc32(records) != chunk.uncompressed_crc) fail("a chunk fails its checksum");
    for (std::uint64_t at = 0; at < records.size();) {
      const std::optional<mcap::Record> message = mcap::recordAt(records, at);
      sum += std::to_integer<unsigned>(message->content.back());
      at = message->end();
    }
  }
  ZSTD_freeDCtx(context);
  if (sum == 0) fail("the log is empty");
  return bench::processSeconds() - start;
}

void report(const char* what, double value, const char* unit, const std::string& more = {}) {
  std::printf("  %-44s %8.2f %s%s\n", what, value, unit, more.c_str());
  std::fflush(stdout);
}

/// Reads everything, one way or the other, and checks that it is in order.
void readThrough(const std::filesystem::path& path, std::int64_t messages, bool backwards,
                 double floor_s) {
  LogReader reader = must(LogReader::open(path));
  if (backwards) (void)reader.seek(LogTime::max());
  const double start = bench::processSeconds();
  std::int64_t count = 0;
  double most_mb = 0;
  LogTime last = backwards ? LogTime::max() : LogTime::min();
  while (const std::optional<LogMessage> message =
             must(backwards ? reader.previous() : reader.next())) {
    if (backwards ? message->log_time > last : message->log_time < last) fail("out of order");
    last = message->log_time;
    if (++count % 200'000 == 0) most_mb = std::max(most_mb, anonymousMegabytes());
  }
  const double used_s = bench::processSeconds() - start;
  if (count != messages || !reader.damage().empty()) fail("not everything was read");
  report(backwards ? "read backwards" : "read in time order",
         static_cast<double>(messages) / used_s / 1e6, "M messages/CPU-s",
         fmt::format(", {:.2f}x the bare loop, anonymous memory {:.0f} MB", used_s / floor_s,
                     most_mb));
}

void openInTheMiddle(const std::filesystem::path& path, std::int64_t messages) {
  const LogTime middle{Nanoseconds(kFirst_ns + messages / 2 * kStep_ns)};
  const auto openAndRead = [&] {
    LogReader reader = must(LogReader::open(path));
    (void)reader.seek(middle);
    if (!must(reader.next()) || reader.summary().messages != static_cast<std::uint64_t>(messages)) {
      fail("there is no middle");
    }
  };
  const int file = ::open(path.c_str(), O_RDONLY);
  ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
  ::close(file);
  const double cold_ms = wallMilliseconds(openAndRead);
  std::vector<double> warm_ms;
  for (int i = 0; i < 21; ++i) warm_ms.push_back(wallMilliseconds(openAndRead));
  std::ranges::sort(warm_ms);
  report("open + first message in the middle", warm_ms[10], "ms",
         fmt::format(", worst of 21 {:.2f}, with a cold cache {:.1f}", warm_ms.back(), cold_ms));
}

void seekAround(const std::filesystem::path& path, std::int64_t messages) {
  LogReader reader = must(LogReader::open(path));
  std::mt19937_64 random(11);
  std::vector<double> each_ms;
  double sum_ms = 0;
  const double start_s = bench::processSeconds();
  for (int i = 0; i < 1000; ++i) {
    const auto to = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(messages));
    each_ms.push_back(wallMilliseconds([&] {
      (void)reader.seek(LogTime(Nanoseconds(kFirst_ns + to * kStep_ns)));
      const std::optional<LogMessage> message = must(reader.next());
      if (!message || message->sequence != static_cast<std::uint32_t>(to)) fail("lost its way");
    }));
    sum_ms += each_ms.back();
  }
  std::ranges::sort(each_ms);
  report("random seek + first message, mean", sum_ms / 1000, "ms",
         fmt::format(", p99 {:.2f}, worst {:.2f}, {:.2f} CPU-ms each", each_ms[989], each_ms.back(),
                     bench::processSeconds() - start_s));
}

void openCut(const std::filesystem::path& path) {
  const std::uint64_t whole = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, std::min<std::uint64_t>(500'000'000, whole - whole / 20));
  std::vector<double> each_ms;
  std::uint64_t messages = 0;
  for (int i = 0; i < 11; ++i) {
    each_ms.push_back(
        wallMilliseconds([&] { messages = must(LogReader::open(path)).summary().messages; }));
  }
  std::ranges::sort(each_ms);
  report("open when cut", each_ms[5], "ms",
         fmt::format(", worst of 11 {:.1f}, {:.0f} MB, {} messages", each_ms.back(),
                     static_cast<double>(std::filesystem::file_size(path)) / 1e6, messages));
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t messages = argc > 1 ? std::atoll(argv[1]) : 10'000'000;
  if (messages < 100'000) fail("at least 100,000 messages are needed");
  std::string folder = (std::filesystem::temp_directory_path() / "log_read_bench.XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) fail("cannot make a folder");
  for (const Compression compression : {Compression::none, Compression::zstd}) {
    const std::filesystem::path path = std::filesystem::path(folder) / "session.mcap";
    writeLogApart(path, compression, messages);
    std::printf("%s, %.1f M messages, %.0f MB\n",
                compression == Compression::none ? "uncompressed" : "zstd",
                static_cast<double>(messages) / 1e6,
                static_cast<double>(std::filesystem::file_size(path)) / 1e6);
    (void)floorCpuSeconds(path);
    const double floor_s = floorCpuSeconds(path);
    report("bare loop", static_cast<double>(messages) / floor_s / 1e6, "M messages/CPU-s");
    readThrough(path, messages, false, floor_s);
    readThrough(path, messages, true, floor_s);
    openInTheMiddle(path, messages);
    seekAround(path, messages);
    openCut(path);
    std::filesystem::remove(path);
  }
  std::filesystem::remove(folder);
}
