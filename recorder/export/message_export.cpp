#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/foreign/session/moment_messages.h"
#include "recorder/export/exports.h"
#include "recorder/export/session_census.h"
#include "recorder/export/shown_shapes.h"
#include "recorder/export/timed_notes.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kProgressMoments = 1024;
constexpr std::uint64_t kMaxUrdfBytes = std::uint64_t{64} << 20;

/// What an export has beside the messages of each moment.
class MessageExporter {
 public:
  MessageExporter(const Cell* cell, SessionFormat& format, ExportedMcap& out, bool shapes)
      : cell_(cell), format_(format), out_(out), messages_(cell, format) {
    if (!shapes) return;
    shapes_.emplace(format, out);
    messages_.shown = [this](LogTime time, const PosedScene& scene) {
      return shapes_->moment(time, scene);
    };
  }
  MessageExporter(const MessageExporter&) = delete;
  MessageExporter& operator=(const MessageExporter&) = delete;

  void notice(const Packet& packet) { messages_.notice(packet); }

  Status moment(LogTime time, const SessionState& state) {
    Status written = descriptions(time);
    return written ? messages_.moment(out_, time, state) : written;
  }

  const std::set<std::string>& carried() const { return messages_.carried(); }
  std::vector<std::string> shapeGaps() const {
    return shapes_ ? shapes_->gaps() : std::vector<std::string>{};
  }

 private:
  /// The URDF of each device, once: as the format has it, and as an attachment.
  Status descriptions(LogTime time) {
    if (cell_ == nullptr || described_) return {};
    described_ = true;
    for (const CellDevice& device : cell_->devices) {
      const Model* const model = cell_->modelOf(device);
      if (model == nullptr) continue;
      if (std::filesystem::path(model->file).extension() != ".urdf") continue;
      const Result<std::string> urdf = readFile(model->file, kMaxUrdfBytes);
      if (!urdf) return urdf.error();
      Status written = format_.description(out_, time, device.name, *urdf);
      if (!written) return written;
      mcap::Attachment attachment;
      attachment.log_time = attachment.create_time =
          static_cast<std::uint64_t>(nanosecondsOf(time));
      attachment.name = device.name + ".urdf";
      attachment.media_type = "application/xml";
      attachment.data = bytesOf(*urdf);
      written = out_.writeAttachment(attachment);
      if (!written) return written;
    }
    return {};
  }

  const Cell* cell_;
  SessionFormat& format_;
  ExportedMcap& out_;
  MomentMessages messages_;
  std::optional<ShownShapes> shapes_;
  bool described_ = false;
};

Status writeRaw(ExportedMcap& out, const LogMessage& message) {
  mcap::Message raw;
  raw.sequence = message.sequence;
  raw.log_time = static_cast<std::uint64_t>(nanosecondsOf(message.log_time));
  raw.publish_time = static_cast<std::uint64_t>(message.publish_time_ns);
  raw.data = message.payload;
  return out.writeRaw(message.channel->topic, message.channel->encoding, message.channel->metadata,
                      raw);
}

/// Tells the format which signals there are, in a pass of its own. False: it has no place for them.
Result<bool> knowSignals(MomentWalk& session, SessionFormat& format,
                         const MessageExportOptions& options) {
  KnownSignals known;
  const Result<const SessionState*> first = session.stateAt(options.from);
  if (!first) return first.error();
  known.notice(**first);
  MomentVisitor visitor;
  visitor.message = [&](const LogMessage&, const Packet* packet) -> Status {
    if (packet != nullptr) known.notice(*packet);
    return {};
  };
  if (Status seen = session.visit(options.from, options.until, visitor); !seen) return seen.error();
  return format.knowSignals(known);
}

}  // namespace

Result<MessageExportReport> exportMessages(MomentWalk& session, const Cell* cell,
                                           SessionFormat& format, ExportedMcap& out,
                                           const MessageExportOptions& options) {
  Result<TimedNotes> notes = TimedNotes::of(session, options.from, options.until, options.notes);
  if (!notes) return notes.error();
  MessageExporter exporter(cell, format, out, options.shapes);
  const Result<bool> has_signals = knowSignals(session, format, options);
  if (!has_signals) return has_signals.error();
  SessionCensus census;
  const LogSummary& log = session.log().summary();
  std::uint64_t moments = 0;
  MomentVisitor visitor;
  visitor.message = [&](const LogMessage& message, const Packet* packet) -> Status {
    Status written = notes->write(format, out, message.log_time - Nanoseconds(1));
    if (!written) return written;
    if (options.raw && message.channel->captured()) {
      if (written = writeRaw(out, message); !written) return written;
    }
    census.take(message, packet);
    if (packet != nullptr) exporter.notice(*packet);
    return {};
  };
  visitor.moment = [&](LogTime time, const SessionState& state) -> Status {
    Status written = exporter.moment(time, state);
    if (written) written = notes->write(format, out, time);
    if (!written || !options.progress || ++moments % kProgressMoments != 0) return written;
    const double whole = std::max(secondsOf(log.end - log.start), 1e-9);
    return options.progress(std::clamp(secondsOf(time - log.start) / whole, 0.0, 1.0));
  };
  Status done = session.visit(options.from, options.until, visitor);
  if (done) done = notes->write(format, out, LogTime::max());
  if (!done) return done.error();
  MessageExportReport report;
  const auto unread = options.raw ? std::map<std::string, std::uint64_t>() : census.unread();
  for (const auto& [topic, count] : unread) {
    report.gaps.push_back(fmt::format("{} of {} {} no packet, and {} left out (--raw keeps {})",
                                      countText(count, "datagram"), topic,
                                      count == 1 ? "holds" : "hold", count == 1 ? "is" : "are",
                                      count == 1 ? "it" : "them"));
  }
  for (const std::string& device : exporter.carried()) {
    report.gaps.push_back(
        fmt::format("{} is on a link of another device, whose place only a cell knows", device));
  }
  for (std::string& gap : exporter.shapeGaps()) report.gaps.push_back(std::move(gap));
  constexpr std::array kUnknownThere = {StatementKind::show, StatementKind::hide,
                                        StatementKind::color, StatementKind::view};
  census.addStatements(report.left_out, kUnknownThere, "the format has nothing for it");
  constexpr std::array kSignals = {StatementKind::signal, StatementKind::signals};
  if (!*has_signals) census.addStatements(report.left_out, kSignals, "signals are not exported");
  format.addLeftOut(report.left_out);
  out.addLeftOut(report.left_out);
  addAttachments(report.left_out, session.log(), "not exported; `rocinante log extract` writes it");
  return report;
}

}  // namespace rocinante
