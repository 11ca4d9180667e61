#include "tests/core/check/rules/rule_example_run.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "core/check/check.h"
#include "core/check/drift/model_drift.h"
#include "core/check/reports/baseline.h"
#include "core/foreign/decode/carried_decoders.h"
#include "core/log/import_record.h"
#include "core/log/log_writer.h"
#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"
#include "core/report/account.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

constexpr LogTime kOrigin{std::chrono::seconds(1'770'091'506)};

LogTime timeOf(double seconds) {
  return kOrigin + Nanoseconds(static_cast<std::int64_t>(seconds * 1e9 + 0.5));
}

/// Writes the text of a `session` block as a log. The folder outlives it.
class SessionText {
 public:
  SessionText(std::filesystem::path log, SessionWriter writer)
      : log_(std::move(log)), writer_(std::move(writer)) {}

  Status take(const std::string& line) {
    if (!line.empty() && line[0] != '@' && line[0] != '!') {
      datagram_ += line + "\n";
      return {};
    }
    if (Status sent = send(); !sent) return sent;
    std::istringstream words(line);
    std::string sign, first;
    words >> sign >> first;
    if (sign == "@") {
      const bool relative = first.starts_with('+');
      seconds_ = (relative ? seconds_ : 0) + std::stod(first);
    }
    return sign == "!" ? execute(first, words) : Status{};
  }

  Status end() {
    if (Status sent = send(); !sent) return sent;
    if (is_open_) {
      // As a killed recorder leaves it: flushed, not closed.
      for (const SteadyTime now : {SteadyTime{}, SteadyTime{std::chrono::hours(1)}}) {
        if (Status flushed = writer_.log().flushIfDue(now); !flushed) return flushed;
      }
      std::filesystem::copy_file(log_, log_.string() + ".open");
    }
    if (Status closed = writer_.log().close("done"); !closed) return closed;
    if (is_open_) std::filesystem::rename(log_.string() + ".open", log_);
    if (damage_at_ > 0) {
      std::fstream file(log_, std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(static_cast<std::streamoff>(damage_at_));
      file.write("damage!!", 8);
    }
    return {};
  }

 private:
  Status send() {
    if (datagram_.empty()) return {};
    const std::string bytes = std::exchange(datagram_, {});
    const std::string encoding =
        encoding_.empty() ? std::string(encodingOf(bytesOf(bytes))) : encoding_;
    std::string source = "me";
    if (encoding == "rk1") {
      std::istringstream header(bytes);
      std::string magic;
      header >> magic >> source;
      source = source.substr(0, source.find('@'));
    }
    const std::string topic =
        encoding == "rk1" ? "/udp/19960/" + source : std::string("/udp/19960/127.0.0.1");
    auto found = channels_.find(topic);
    if (found == channels_.end()) {
      const auto id = writer_.addChannel(topic, encoding, {{"source", source}});
      if (!id) return id.error();
      found = channels_.emplace(topic, *id).first;
    }
    return writer_.write(found->second, sequence_++, timeOf(seconds_), 0, bytesOf(bytes));
  }

  Status execute(const std::string& order, std::istringstream& words) {
    if (order == "loss") {
      LossSpan loss;
      loss.endpoint = "udp://127.0.0.1:19960";
      std::string what;
      std::uint64_t count = 0;
      double from = 0, until = 0;
      words >> what >> count >> from >> until;
      loss.from = timeOf(from);
      loss.until = timeOf(until);
      (what == "kernel"  ? loss.counts.kernel
       : what == "queue" ? loss.counts.queue
       : what == "disk"  ? loss.counts.disk
                         : loss.counts.truncated) = count;
      return writer_.log().writeLoss(loss);
    }
    if (order == "clock-step") {
      double step = 0;
      words >> step;
      const auto id = writer_.addChannel("/rocinante/clock", "json", {});
      if (!id) return id.error();
      const LogTime now = timeOf(seconds_);
      const std::string text =
          fmt::format(R"({{"noticed_ns":{},"step_ns":{}}})", now.time_since_epoch().count(),
                      static_cast<std::int64_t>(step * 1e9));
      return writer_.write(*id, 0, now, now.time_since_epoch().count(), bytesOf(text));
    }
    if (order == "bytes") {
      for (unsigned byte = 0; words >> std::hex >> byte;) datagram_ += static_cast<char>(byte);
      return send();
    }
    if (order == "as") {
      words >> encoding_;
      return {};
    }
    if (order == "import") {
      std::string sentence;
      std::getline(words >> std::ws, sentence);
      return writer_.log().writeMetadata(
          {std::string(kImportRecord), {{std::string(kImportWarningsKey), sentence + "\n"}}});
    }
    if (order == "left-out") {
      Account account;
      LeftOut one;
      words >> one.kind >> one.name;
      std::getline(words >> std::ws, one.reason);
      account.leaveOut(std::move(one));
      return writer_.log().writeMetadata(
          {std::string(kImportRecord), {{std::string(kImportLeftOutKey), accountLines(account)}}});
    }
    if (order == "damage") {
      words >> damage_at_;
      return {};
    }
    if (order == "not-closed") {
      is_open_ = true;
      return {};
    }
    return Error{ErrorKind::bad_argument, "no such order in a session block: " + order, ""};
  }

  std::filesystem::path log_;
  SessionWriter writer_;
  std::map<std::string, ChannelId> channels_;
  std::string datagram_, encoding_;
  double seconds_ = 0;
  std::uint32_t sequence_ = 0;
  std::uint64_t damage_at_ = 0;
  bool is_open_ = false;
};

Status writeLog(const RuleExample& example, const std::filesystem::path& folder,
                const std::filesystem::path& log) {
  // Small uncompressed chunks: damage then costs little, at an offset that a page can name.
  LogWriterOptions options;
  options.compression = LogWriterOptions::Compression::none;
  options.chunk_bytes = 4096;
  Result<LogWriter> writer = LogWriter::create(log, options, "a page of docs/rules");
  if (!writer) return writer.error();
  if (std::filesystem::exists(folder / "recorded")) {
    const Result<CellBundle> bundle = collectCell(folder / "recorded/cell.toml", {});
    if (!bundle) return bundle.error();
    if (Status written = AttachedBundle(*bundle).writeTo(*writer, kOrigin); !written) {
      return written;
    }
  }
  SessionText text(log, SessionWriter(std::move(*writer), {}));
  std::istringstream lines(example.session);
  for (std::string line; std::getline(lines, line);) {
    if (Status taken = text.take(line); !taken) return taken;
  }
  return text.end();
}

}  // namespace

Result<CheckReport> judgeExample(const RuleExample& example) {
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : example.files) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
  // The recorded cell shares all files that it does not have itself.
  for (const auto& [name, bytes] : example.files) {
    const std::filesystem::path recorded = folder / ("recorded/" + name);
    if (!std::filesystem::exists(folder / "recorded") || name.starts_with("recorded/")) continue;
    if (!std::filesystem::exists(recorded)) std::ofstream(recorded, std::ios::binary) << bytes;
  }
  const Result<Cell> cell = loadCell(folder / example.cell, {});
  if (!cell) return cell.error();
  if (!example.has_session) return checkCell(*cell);
  const std::filesystem::path path = folder / "session.mcap";
  if (Status written = writeLog(example, folder.path(), path); !written) return written.error();
  Result<LogReader> log = LogReader::open(path);
  if (!log) return log.error();
  std::optional<decode::DatagramDecoders> decoders;
  OctetPackets packets;
  if (!cell->decoders.empty()) {
    auto opened = decode::DatagramDecoders::open(cell->decoders);
    if (!opened) return opened.error();
    decoders.emplace(std::move(*opened));
    packets = [&](const LogMessage& message, bool) {
      const decode::DecodedPacket* const made = decoders->decode(
          decode::routeOf(*message.channel), message.publish_time_ns, message.payload);
      return DecodedOctets{made == nullptr ? std::string_view() : made->text,
                           decoders->notFinite()};
    };
  }
  Result<CheckReport> report = checkLog(*cell, *log, {}, packets);
  if (!report) return report;
  if (const auto bundle = readAttachedCell(*log); bundle.ok() && *bundle) {
    const Result<Cell> recorded = loadBundle(**bundle, "session.mcap:cell/", {});
    if (!recorded) return recorded.error();
    const Findings drift = modelDrift(*recorded, *cell);
    report->findings.insert(report->findings.end(), drift.begin(), drift.end());
  }
  if (example.files.contains("baseline.json")) {
    const Result<Baseline> baseline = Baseline::read(folder / "baseline.json");
    if (!baseline) return baseline.error();
    baseline->applyTo(*report);
  }
  conclude(*report);
  return report;
}

}  // namespace rocinante::test
