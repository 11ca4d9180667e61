#include "viewer/ui/live/hand_drive.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/plain_text.h"
#include "core/base/random_id.h"
#include "core/packet/packet_text.h"
#include "core/packet/restatement.h"
#include "core/transport/open_sink.h"
#include "viewer/ui/live/sending_source.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kRestate = std::chrono::seconds(2);
/// Of a datagram, unless the joints of one device need more: they stay together.
constexpr std::size_t kMostBytes = 1200;
constexpr std::size_t kLargestDatagram = 60'000;

PacketHeader headerOf(const DriveSettings& settings, std::uint64_t sequence, WallTime wall) {
  PacketHeader header;
  header.source = settings.source;
  header.run = settings.run;
  header.sequence = sequence;
  header.time_ns = wall.time_since_epoch().count();
  return header;
}

/// Whether a decoder reads the text as it was meant.
bool isReadable(const std::string& text) {
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(text));
  return packet != nullptr && decoder.faults().empty();
}

}  // namespace

Result<HandDrive> HandDrive::open(const Endpoint& to, const DriveSettings& settings) {
  auto sink = openSink(to);
  if (!sink) return sink.error();
  return into(std::move(*sink), settings);
}

Result<HandDrive> HandDrive::into(std::unique_ptr<DatagramSink> sink,
                                  const DriveSettings& settings) {
  DriveSettings own = settings;
  if (own.run.empty()) own.run = randomId(5);
  if (own.source.empty() || own.source.size() > kMostBytes ||
      !isReadable(PacketTextWriter(headerOf(own, 0, WallTime{})).text())) {
    return Error{ErrorKind::bad_argument,
                 "a source has a name of 1 to 255 bytes of UTF-8 without control characters",
                 plainText(own.source)};
  }
  return HandDrive(std::move(sink), std::move(own));
}

void HandDrive::set(const std::string& device, const std::string& joint, double value) {
  auto& values = joints_[device];
  const auto known = values.find(joint);
  if (known != values.end() && known->second == value) return;
  values[joint] = value;
  PacketTextWriter packet(headerOf(settings_, sequence_, WallTime{}));
  JointStatements statements({{device, values}});
  for (const Statement& statement : statements.all()) packet.add(statement);
  if (device.empty() || joint.empty() || packet.byteCount() > kLargestDatagram ||
      !isReadable(packet.text())) {
    values.erase(joint);
    if (values.empty()) joints_.erase(device);
    trouble_ = fmt::format("{}/{} is not sent: no packet can hold it", plainText(device),
                           plainText(joint));
    return;
  }
  changed_.insert(device);
}

void HandDrive::release(const std::string& device, const std::string& joint) {
  const auto driven = joints_.find(device);
  if (driven == joints_.end() || driven->second.erase(joint) == 0) return;
  released_ = true;
  if (driven->second.empty()) joints_.erase(driven);
}

void HandDrive::release(const std::string& device) {
  if (joints_.erase(device) > 0) released_ = true;
}

void HandDrive::releaseAll() {
  released_ = released_ || !joints_.empty();
  joints_.clear();
}

void HandDrive::tick(SteadyTime now, WallTime wall) {
  if (sent_at_ && now - *sent_at_ < SendingSource::kPeriod) return;
  const bool restates =
      released_ || (!joints_.empty() && restated_at_ && now - *restated_at_ >= kRestate);
  if (!restates && changed_.empty()) return;
  // Also what changed: a restatement has the newest values.
  restates ? restateAll(wall) : sendChanged(wall);
  sent_at_ = now;
  if (restates || !restated_at_) restated_at_ = now;
  changed_.clear();
  released_ = false;
}

void HandDrive::sendChanged(WallTime wall) {
  for (const std::string& device : changed_) {
    const auto driven = joints_.find(device);
    if (driven == joints_.end()) continue;
    PacketTextWriter packet(headerOf(settings_, sequence_, wall));
    JointStatements statements({{device, driven->second}});
    for (const Statement& statement : statements.all()) packet.add(statement);
    send(packet.text());
  }
}

/// One that states nothing once all joints were let go.
void HandDrive::restateAll(WallTime wall) {
  const JointStatements statements(joints_);
  Packet packet;
  packet.header = headerOf(settings_, sequence_, wall);
  packet.statements = statements.all();
  SessionState own;
  own.apply(LogTime{}, packet);
  const std::string id = fmt::format("r{}", restatements_++);
  RestatementOptions how;
  how.part_id = id;
  how.mtu_bytes = kMostBytes;
  how.first_sequence = sequence_;
  how.time_ns = packet.header.time_ns;
  for (const std::string& text : restate(own, settings_.source, how)) send(text);
}

void HandDrive::send(const std::string& text) {
  ++sequence_;
  const std::array payloads{bytesOf(text)};
  const auto sent = sink_->sendWithoutWaiting(payloads);
  if (!sent) {
    trouble_ = sent.error().text();
  } else if (*sent == 0) {
    trouble_ = "the system has no room for more datagrams";
  } else {
    trouble_.clear();
  }
}

}  // namespace rocinante
