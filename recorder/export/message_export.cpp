#include "recorder/export/message_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/count_text.h"
#include "core/cell/scene_pose_cache.h"
#include "core/math/transform.h"
#include "recorder/export/shown_shapes.h"
#include "recorder/export/statement_census.h"
#include "recorder/export/timed_notes.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kProgressMoments = 1024;
constexpr std::uint64_t kMaxUrdfBytes = std::uint64_t{64} << 20;

bool sameMatrices(const std::vector<Mat4>& a, const std::vector<Mat4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat4)) == 0;
}

class MessageExporter {
 public:
  MessageExporter(const Cell* cell, SessionFormat& format, ExportedMcap& out, bool shapes)
      : cell_(cell), format_(format), out_(out) {
    if (cell != nullptr) poses_.emplace(*cell);
    if (shapes) shapes_.emplace(format, out);
  }

  /// What a packet may have changed besides devices.
  void notice(const Packet& packet) {
    census_.count(packet);
    bool draws = packet.header.part.has_value() || packet.header.reset;
    // A source that restarts has drawn nothing yet.
    const auto kept = kept_.find(packet.header.source);
    if (kept != kept_.end() && kept->second.run != packet.header.run) draws = true;
    for (const Statement& statement : packet.statements) {
      switch (statement.kind) {
        case StatementKind::line:
        case StatementKind::points:
        case StatementKind::label:
        case StatementKind::erase:
          draws = true;
          break;
        case StatementKind::remove:
          all_drawn_ = true;  // with what is drawn on the device
          break;
        default:
          break;
      }
    }
    if (draws) drawn_.insert(std::string(packet.header.source));
  }

  Status moment(LogTime time, const SessionState& state) {
    Status written = descriptions(time);
    if (written) written = cell_ == nullptr ? bareFrames(time, state) : cellFrames(time, state);
    if (written) written = joints(time, state);
    if (written) written = drawings(time, state);
    return written;
  }

  const StatementCensus& census() const { return census_; }
  const std::set<std::string>& carried() const { return carried_; }
  std::vector<std::string> shapeGaps() const {
    return shapes_ ? shapes_->gaps() : std::vector<std::string>{};
  }

 private:
  /// What was said of a device last.
  struct Known {
    std::vector<Mat4> links;  ///< in the world; the first is the device's own
    LogTime frames_said = LogTime::min();
    bool joints_said = false;
  };

  /// The drawings of a source as they were written last.
  struct Drawn {
    std::string run;
    std::vector<std::pair<std::string, Drawing>> drawings;
  };

  bool framesDue(Known& known, std::vector<Mat4> now, bool is_written, LogTime time) const {
    const bool is_first = known.links.empty();
    const bool has_moved = !sameMatrices(known.links, now);
    const Nanoseconds last = format_.framesLast();
    const bool is_old = !is_first && last.count() > 0 && time - known.frames_said >= last;
    if (!is_first && !has_moved && !is_written && !is_old) return false;
    known.links = std::move(now);
    known.frames_said = time;
    return true;
  }

  Status cellFrames(LogTime time, const SessionState& state) {
    const PosedScene scene = poses_->pose(state);
    for (const PosedDevice& device : scene.devices) {
      if (device.ghost) continue;
      const DeviceState* const stated = state.findDevice(device.name);
      std::vector<Mat4> now{device.base};
      now.insert(now.end(), device.link_world.begin(), device.link_world.end());
      if (!framesDue(known_[device.name], std::move(now),
                     stated != nullptr && stated->last_write == time, time)) {
        continue;
      }
      Status written = format_.frames(out_, time, device.name, deviceFrames(device));
      if (!written) return written;
      models_[device.name] = device.model;
    }
    return shapes_ ? shapes_->moment(time, scene) : Status{};
  }

  Status bareFrames(LogTime time, const SessionState& state) {
    for (const auto& [name, device] : state.devices()) {
      if (!device.pose || isRemoved(device)) continue;
      const PoseValue& pose = device.pose->value;
      if (!pose.carrier.second.empty()) carried_.insert(name);
      if (!framesDue(known_[name], {matrixOf(pose.pose)}, device.last_write == time, time))
        continue;
      const FramePose frame{frameName(pose.carrier.first, pose.carrier.second), name, pose.pose};
      if (Status written = format_.frames(out_, time, name, {&frame, 1}); !written) return written;
    }
    return {};
  }

  Status joints(LogTime time, const SessionState& state) {
    for (const auto& [name, device] : state.devices()) {
      if (!hasJoints(device) || isRemoved(device)) continue;
      Known& known = known_[name];
      if (known.joints_said && device.last_write != time) continue;
      known.joints_said = true;
      const auto model = models_.find(name);
      Status written = format_.joints(
          out_, time, name, jointValues(model == models_.end() ? nullptr : model->second, device));
      if (!written) return written;
    }
    return {};
  }

  Status drawings(LogTime time, const SessionState& state) {
    if (!has_begun_ || all_drawn_) {
      for (const auto& [key, drawing] : state.drawings()) drawn_.insert(key.first);
      for (const auto& [source, kept] : kept_) drawn_.insert(source);
    }
    has_begun_ = true;
    all_drawn_ = false;
    for (const std::string& source : drawn_) {
      SessionFormat::Drawings now;
      auto each = state.drawings().lower_bound({source, ""});
      for (; each != state.drawings().end() && each->first.first == source; ++each) {
        now.emplace_back(each->first.second, &each->second);
      }
      const auto stated = state.sources().find(source);
      const auto known = kept_.find(source);
      if (known == kept_.end() && now.empty()) continue;
      Drawn& kept = known == kept_.end() ? kept_[source] : known->second;
      if (stated != state.sources().end()) kept.run = stated->second.run;
      const bool is_same = std::equal(
          now.begin(), now.end(), kept.drawings.begin(), kept.drawings.end(),
          [](const auto& a, const auto& b) { return a.first == b.first && *a.second == b.second; });
      if (is_same) continue;
      kept.drawings.clear();
      for (const auto& [id, drawing] : now) kept.drawings.emplace_back(id, *drawing);
      if (Status written = format_.drawings(out_, time, source, now); !written) return written;
    }
    drawn_.clear();
    return {};
  }

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
  std::optional<ScenePoseCache> poses_;
  std::optional<ShownShapes> shapes_;
  std::map<std::string, Known, std::less<>> known_;
  std::map<std::string, const Model*, std::less<>> models_;
  std::set<std::string> drawn_;  ///< sources whose drawings may have changed
  bool all_drawn_ = false;
  bool has_begun_ = false;
  bool described_ = false;
  std::map<std::string, Drawn, std::less<>> kept_;  ///< by source
  StatementCensus census_;
  std::set<std::string> carried_;  ///< devices on links that no cell places
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

}  // namespace

Result<MessageExportReport> exportMessages(MomentWalk& session, const Cell* cell,
                                           SessionFormat& format, ExportedMcap& out,
                                           const MessageExportOptions& options) {
  Result<TimedNotes> notes = TimedNotes::of(session, options.from, options.until, options.notes);
  if (!notes) return notes.error();
  MessageExporter exporter(cell, format, out, options.shapes);
  std::map<std::string, std::uint64_t> unread;
  std::uint64_t* last_unread = nullptr;  ///< of the topic of the message before
  const LogSummary& log = session.log().summary();
  std::uint64_t moments = 0;
  MomentVisitor visitor;
  visitor.message = [&](const LogMessage& message, const Packet* packet) -> Status {
    Status written = notes->write(format, out, message.log_time - Nanoseconds(1));
    if (!written) return written;
    if (options.raw && message.channel->captured()) {
      if (written = writeRaw(out, message); !written) return written;
    }
    // What was decoded or imported directly follows the octets that it was made of.
    if (last_unread != nullptr && message.channel->decoded()) --*last_unread;
    last_unread = nullptr;
    if (packet != nullptr) {
      exporter.notice(*packet);
    } else if (!options.raw) {
      last_unread = &unread[message.channel->topic];
      ++*last_unread;
    }
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
  for (const auto& [topic, count] : unread) {
    if (count == 0) continue;
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
  report.notes = exporter.census().leftOut();
  return report;
}

}  // namespace rocinante
