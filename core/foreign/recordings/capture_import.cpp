#include "core/foreign/recordings/capture_import.h"

#include <algorithm>
#include <functional>
#include <map>

#include "core/base/figure_text.h"
#include "core/log/import_record.h"
#include "core/packet/decoder.h"
#include "core/pcap/pcap_source.h"
#include "core/recording/capture_blocks.h"
#include "core/recording/capture_writer.h"
#include "core/recording/piece_log.h"

namespace rocinante {
namespace {

/// Two would do: one is filled while the other's last datagrams wait to be sorted.
constexpr std::size_t kBlocks = 4;
/// Datagrams between two calls of `progress`.
constexpr std::uint64_t kProgressDatagrams = 4096;

struct FlowTally {
  std::string topic;
  std::uint64_t datagrams = 0, malformed = 0;
  std::string fault;  ///< of the first malformed one
};

/// What was written, shared with the sink, which the writer owns.
struct CaptureTally {
  std::map<std::size_t, FlowTally> flows;
  std::uint64_t packets = 0;
  std::optional<LogTime> start;
  LogTime end{};
  std::uint64_t bytes = 0;
  /// What is noted in the log at its end; empty before the import runs.
  std::function<ros::ImportReport()> report;
};

/// Why a datagram that begins as packet text is no packet.
std::string faultOf(const CapturedDatagram& datagram, std::uint64_t number) {
  const auto decoder = makeDecoder("rk1");
  std::string text = "datagram " + std::to_string(number);
  if (decoder->decode(datagram.payload) == nullptr && !decoder->faults().empty()) {
    const FaultAt& fault = decoder->faults().front();
    text += ", line " + std::to_string(fault.line) + ": " + std::string(nameOf(fault.fault));
  }
  return text;
}

class CaptureLog final : public CaptureSink {
 public:
  CaptureLog(MadePiece made, const ros::ImportOptions& options, std::shared_ptr<CaptureTally> tally)
      : piece_(std::move(made), options.keyframes), tally_(std::move(tally)) {}

  Status begin(const SessionState& preceding, LogTime moment) override {
    return piece_.begin(preceding, moment, std::nullopt);
  }
  Status write(const CapturedDatagram& datagram) override {
    FlowTally& flow = tally_->flows[datagram.flow];
    if (flow.topic.empty()) flow.topic = datagram.channel->topic;
    ++flow.datagrams;
    if (datagram.packet == nullptr && datagram.channel->encoding == "rk1") {
      if (flow.malformed++ == 0) flow.fault = faultOf(datagram, flow.datagrams);
    }
    tally_->packets += datagram.packet != nullptr ? 1 : 0;
    tally_->start = std::min(tally_->start.value_or(datagram.time), datagram.time);
    tally_->end = std::max(tally_->end, datagram.time);
    return piece_.write(datagram);
  }
  Status writeLoss(const LossSpan& span) override { return piece_.writeLoss(span); }
  Status writeStep(const ClockStep& step) override { return piece_.writeStep(step); }
  Status flush(LogTime, SteadyTime now) override { return piece_.flush(now); }
  Status flushAll() override { return piece_.flushAll(); }
  Status close(const std::string& reason) override {
    if (tally_->report) {
      const ros::ImportReport report = tally_->report();
      if (!report.account.empty() || !ros::importWarnings(report).empty()) {
        if (Status noted = piece_.writeMetadata(ros::warningsRecord(report)); !noted) return noted;
      }
    }
    Status closed = piece_.close(reason);
    tally_->bytes = piece_.bytes();
    return closed;
  }
  std::uint64_t bytesWritten() const override { return piece_.bytes(); }
  std::vector<std::uint64_t> refusedByFlow() const override {
    std::vector<std::uint64_t> refused;
    piece_.addRefused(refused);
    return refused;
  }

 private:
  PieceLog piece_;
  std::shared_ptr<CaptureTally> tally_;
};

/// Fills blocks and passes them to the writer, on one thread.
class CapturePump {
 public:
  CapturePump(DatagramSource& source, std::unique_ptr<CaptureSink> sink)
      : source_(source),
        writer_(std::move(sink), {{source.endpoint(), source.boundAddress()}}, CaptureLimits()) {}

  Status run(const ros::ImportOptions& options) {
    while (!source_.ended() && !writer_.over()) {
      const auto batch = source_.receive();
      if (!batch) {
        // What a capturing program that was killed left behind is imported as far as it goes.
        if (read_ == 0 || batch.error().kind != ErrorKind::damaged) return batch.error();
        cut_ = batch.error().what;
        break;
      }
      for (const ReceivedDatagram& datagram : *batch) keep(datagram);
      if (options.progress && read_ / kProgressDatagrams != reported_) {
        reported_ = read_ / kProgressDatagrams;
        // How long the file is, the capture library does not say.
        if (Status goes_on = options.progress(0); !goes_on) return goes_on;
      }
    }
    blocks_.handOver();
    queue_.finish();
    writeTaken();
    writer_.close(std::string(kImportedEnd), queue_);
    if (writer_.trouble()) return *writer_.trouble();
    return {};
  }

  std::uint64_t read() const { return read_; }
  std::uint64_t truncated() const { return truncated_; }
  Account leftOut() const { return blocks_.leftOut(); }
  const std::string& cut() const { return cut_; }  ///< why the file ended early; else empty

 private:
  void keep(const ReceivedDatagram& datagram) {
    while (!blocks_.keep(datagram)) writeTaken();
    ++read_;
    truncated_ += datagram.truncated ? 1 : 0;
  }

  void writeTaken() { writer_.write(queue_.take(Nanoseconds(0)), queue_); }

  DatagramSource& source_;
  HandOver queue_{kBlocks};
  CaptureWriter writer_;
  CaptureBlocks blocks_{queue_};
  std::uint64_t read_ = 0, reported_ = 0, truncated_ = 0;
  std::string cut_;
};

ros::ImportReport reportOf(const CaptureTally& tally, const CapturePump& pump,
                           const DatagramSource& source, const std::string& name) {
  ros::ImportReport report;
  for (const auto& [flow, kept] : tally.flows) {
    ros::ImportedTopic& topic = report.topics.emplace_back();
    topic.name = kept.topic;
    topic.type = ros::kDatagrams;
    topic.messages = kept.datagrams;
    topic.malformed = kept.malformed;
    topic.fault = kept.fault;
    report.messages += kept.datagrams;
    report.malformed += kept.malformed;
  }
  report.packets = tally.packets;
  report.start = tally.start.value_or(LogTime{});
  report.end = tally.end;
  report.bytes = tally.bytes;
  if (!pump.cut().empty()) report.damage.push_back(pump.cut() + " (" + name + ")");
  if (pump.truncated() > 0) {
    report.damage.push_back(countText(pump.truncated(), "datagram") +
                            " shorter than sent: the capture cut them (" + name + ")");
  }
  const InputCounts counts = source.counts();
  report.lost = counts.malformed + counts.incomplete;
  report.account = source.leftOut();
  report.account.add(pump.leftOut());
  return report;
}

}  // namespace

Result<ros::ImportReport> importCapture(const std::filesystem::path& capture,
                                        std::unique_ptr<ByteSink> sink, std::string session_id,
                                        const ros::ImportOptions& options) {
  Endpoint endpoint;
  endpoint.scheme = Endpoint::Scheme::pcap;
  // As pcap:// writes a file, not an interface.
  endpoint.file = (capture.has_parent_path() ? "" : "./") + capture.string();
  const auto source = openPcap(endpoint, {});
  if (!source) return source.error();
  Result<LogWriter> log = LogWriter::createOn(std::move(sink), options.log, std::move(session_id));
  if (!log) return log.error();
  if (options.bundle != nullptr) {
    if (Status put = AttachedBundle(*options.bundle).writeTo(*log, LogTime{}); !put) {
      return put.error();
    }
  }
  const auto tally = std::make_shared<CaptureTally>();
  MadePiece made{std::move(*log), {}};
  CapturePump pump(**source, std::make_unique<CaptureLog>(std::move(made), options, tally));
  tally->report = [&] { return reportOf(*tally, pump, **source, capture.string()); };
  const Status read = pump.run(options);
  tally->report = {};
  if (!read) return read.error();
  if (pump.read() == 0) {
    const std::string left_out = accountSentence((*source)->leftOut());
    return Error{ErrorKind::not_found,
                 "the capture file contains no UDP datagram" +
                     (left_out.empty() ? std::string() : "; " + left_out),
                 capture.string()};
  }
  return reportOf(*tally, pump, **source, capture.string());
}

}  // namespace rocinante
