// Writing a log of six-joint packets to a file: the CPU of all threads beside bare ZSTD_compress2
// of the same records in 1 MiB buffers, and its size beside those buffers and 16 bytes a message of
// index; beside it, what it costs when it comes at 6,000/s and is flushed every 50 ms. Keyframes
// are another matter. usage: log_write_bench [MESSAGES [FOLDER]]
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/log/log_writer.h"
#include "core/mcap/append_record.h"
#include "core/mcap/records.h"
#include "tests/bench/bench_support.h"
#include "tests/support/joint_packets.h"

namespace {

using namespace rocinante;

constexpr double kRateHz = 6'000;
constexpr std::size_t kMessagesALook = 60;  // 10 ms
constexpr std::size_t kBufferBytes = std::size_t{1} << 20U;
constexpr int kRuns = 5;
constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;

/// What a recorder gets, laid out before the clock starts.
struct Session {
  struct Piece {
    std::uint64_t offset;
    std::uint32_t size;
  };
  std::string text;
  std::vector<Piece> pieces;

  explicit Session(std::size_t messages) {
    for (std::size_t i = 0; i < messages; ++i) {
      const std::string packet = test::jointPacket(i, kRateHz);
      pieces.push_back({text.size(), static_cast<std::uint32_t>(packet.size())});
      text += packet;
    }
  }
  ByteView payload(std::size_t i) const {
    return bytesOf(std::string_view(text).substr(pieces[i].offset, pieces[i].size));
  }
  /// A period, and the unrest of a kernel's stamps.
  static std::int64_t logTimeNs(std::size_t i) {
    const auto sent_ns = static_cast<std::int64_t>(static_cast<double>(i) * 1e9 / kRateHz);
    return kOriginNs + sent_ns + static_cast<std::int64_t>(i * 2'654'435'761U % 50'000U);
  }
  static std::int64_t publishTimeNs(std::size_t i) {
    const auto sent_us = static_cast<std::int64_t>(static_cast<double>(i) * 1e6 / kRateHz);
    return kOriginNs + sent_us * 1000;
  }
};

/// The Message records of the session.
Bytes recordsOf(const Session& session) {
  Bytes records;
  for (std::size_t i = 0; i < session.pieces.size(); ++i) {
    mcap::append(records, mcap::Message{0, static_cast<std::uint32_t>(i),
                                        static_cast<std::uint64_t>(Session::logTimeNs(i)),
                                        static_cast<std::uint64_t>(Session::publishTimeNs(i)),
                                        session.payload(i)});
  }
  return records;
}

/// The least CPU of a few runs, and the bytes made.
struct Cost {
  double cpu_s = 1e9;
  std::uint64_t bytes = 0;

  template <class Work>
  void measure(Work work) {
    const double start = bench::processSeconds();
    bytes = work();
    cpu_s = std::min(cpu_s, bench::processSeconds() - start);
  }
};

std::uint64_t compressBare(const Bytes& records, Bytes& out) {
  ZSTD_CCtx* const zstd = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(zstd, ZSTD_c_compressionLevel, 1);
  std::uint64_t bytes = 0;
  for (std::size_t at = 0; at < records.size(); at += kBufferBytes) {
    const std::size_t size = std::min(kBufferBytes, records.size() - at);
    bytes += ZSTD_compress2(zstd, out.data(), out.size(), records.data() + at, size);
  }
  ZSTD_freeCCtx(zstd);
  return bytes;
}

std::uint64_t fail(const Error& error) {
  fmt::print(stderr, "{}\n", error.text());
  std::exit(2);
}

std::uint64_t writeLog(const Session& session, LogWriterOptions options,
                       const std::filesystem::path& path, bool flushed = false) {
  options.overwrite = true;
  Result<LogWriter> log = LogWriter::create(path, options, "bench");
  if (!log) return fail(log.error());
  const Result<ChannelId> channel = log->addChannel("/udp/19960/arm", "rk1", {});
  for (std::size_t i = 0; i < session.pieces.size(); ++i) {
    const Status written = log->write(*channel, static_cast<std::uint32_t>(i),
                                      LogTime(Nanoseconds(Session::logTimeNs(i))),
                                      Session::publishTimeNs(i), session.payload(i));
    if (!written) return fail(written.error());
    // As often as the recorder looks, in the session's own time.
    if (flushed && i % kMessagesALook == 0) {
      const SteadyTime now(Nanoseconds(Session::logTimeNs(i)));
      if (Status brought = log->flushIfDue(now); !brought) return fail(brought.error());
    }
  }
  if (Status closed = log->close("finished"); !closed) return fail(closed.error());
  return std::filesystem::file_size(path);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t messages = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1'000'000;
  const std::filesystem::path folder =
      argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path();
  const std::filesystem::path path =
      folder / fmt::format("log_write_bench.{}.mcap", static_cast<long>(::getpid()));
  const Session session(messages);
  const Bytes records = recordsOf(session);
  Bytes out(ZSTD_compressBound(kBufferBytes));
  LogWriterOptions plain;
  plain.compression = LogWriterOptions::Compression::none;

  Cost bare, zstd, none, slow;
  for (int run = 0; run < kRuns; ++run) {
    bare.measure([&] { return compressBare(records, out); });
    zstd.measure([&] { return writeLog(session, {}, path); });
    none.measure([&] { return writeLog(session, plain, path); });
    slow.measure([&] { return writeLog(session, {}, path, true); });
  }
  std::error_code ignored;
  std::filesystem::remove(path, ignored);

  const auto count = static_cast<double>(messages);
  const auto report = [&](const char* name, const Cost& cost) {
    fmt::print("{:<14} {:6.0f} ns a message, {:5.2f} M messages/CPU-s, {:5.1f} bytes a message\n",
               name, cost.cpu_s / count * 1e9, count / cost.cpu_s * 1e-6,
               static_cast<double>(cost.bytes) / count);
  };
  fmt::print("{} packets of {:.0f} bytes, least of {} runs\n", messages,
             static_cast<double>(session.text.size()) / count, kRuns);
  report("bare zstd 1", bare);
  report("log, zstd 1", zstd);
  report("log, none", none);
  report("log, 6,000/s", slow);
  fmt::print("log, zstd 1 / bare: {:.2f} (bar 1.40)\n", zstd.cpu_s / bare.cpu_s);
  fmt::print("log, none: {:.2f} M messages/CPU-s (bar 5.00)\n", count / none.cpu_s * 1e-6);
  fmt::print("size / (bare + 16 a message): {:.3f} (bar 1.050)\n",
             static_cast<double>(zstd.bytes) / (static_cast<double>(bare.bytes) + 16 * count));
  return 0;
}
