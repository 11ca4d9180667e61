#include "player/source/csv_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/packet/packet_limits.h"
#include "core/packet/restatement.h"

namespace rocinante {
namespace {

// The longest SEQUENCE and TIME: 20 digits each, and the point.
constexpr std::size_t kNumbersBytes = 41;

Status checkName(const char* option, const std::string& name) {
  if (!name.empty() && name.size() <= limits::kNameBytes) return {};
  return Error{ErrorKind::bad_argument, "a name must be 1 to 255 bytes long", option};
}

/// The largest size of a packet with a line of `line_bytes`.
std::size_t packetBytes(const CsvStream::Options& options, std::size_t line_bytes) {
  PacketHeader header;
  header.source = options.source;
  header.run = options.run;
  return headerText(header).size() + kNumbersBytes + line_bytes + 2;
}

Error tooLarge(std::size_t bytes, const CsvStream::Options& options) {
  return {ErrorKind::bad_argument,
          fmt::format("a packet needs up to {} bytes, but --mtu is {}: choose fewer --columns or "
                      "raise it",
                      bytes, options.mtu_bytes),
          options.device};
}

Statement orderStatement(const std::string& device, const std::vector<std::string_view>& names) {
  Statement statement;
  statement.kind = StatementKind::order;
  statement.name = device;
  statement.names = names;
  return statement;
}

}  // namespace

Result<CsvStream> CsvStream::open(const CsvMotion& motion, Options options) {
  if (const Status name = checkName("--device", options.device); !name) return name.error();
  if (const Status name = checkName("--source", options.source); !name) return name.error();
  if (const Status name = checkName("--run", options.run); !name) return name.error();
  std::size_t longest = 0;
  for (const CsvMotion::Row& row : motion.rows) longest = std::max(longest, row.byte_count);
  const std::vector<std::string_view> names(motion.joints.begin(), motion.joints.end());
  const std::size_t order = statementText(orderStatement(options.device, names)).size();
  const std::size_t joints =
      std::string_view("joints  ").size() + encodeName(options.device).size() + longest;
  const std::size_t bytes = packetBytes(options, std::max(order, joints));
  if (bytes > options.mtu_bytes) return tooLarge(bytes, options);
  return CsvStream(motion, std::move(options));
}

CsvStream::CsvStream(const CsvMotion& motion, Options options)
    : motion_(&motion),
      options_(std::move(options)),
      decoder_(std::make_unique<PacketTextDecoder>()) {
  encoded_device_ = encodeName(options_.device);
  const Nanoseconds span = motion.rows.back().time - motion.rows.front().time;
  const auto steps = static_cast<std::int64_t>(motion.rows.size()) - 1;
  period_ = steps > 0 ? span + span / steps : Nanoseconds(std::chrono::seconds(1));
  next_restatement_ = motion.rows.front().time + options_.restate;
}

Nanoseconds CsvStream::rowTime() const { return motion_->rows[row_].time + period_ * turn_; }

std::optional<std::int64_t> CsvStream::timeToSay(Nanoseconds time) const {
  const Nanoseconds said = options_.wall_now ? options_.wall_now().time_since_epoch() : time;
  // Packet text has no times before the epoch.
  if (said.count() < 0) return std::nullopt;
  return said.count();
}

Result<std::optional<Due>> CsvStream::due() {
  if (row_ == motion_->rows.size()) {
    if (turn_ + 1 == options_.turns) return std::optional<Due>();
    row_ = 0;
    ++turn_;
  }
  restating_ =
      restating_ || (options_.restate.count() > 0 && order_said_ && next_restatement_ <= rowTime());
  if (restating_) return std::optional(Due{LogTime(next_restatement_), turn_, true});
  return std::optional(Due{LogTime(rowTime()), turn_, false});
}

ByteView CsvStream::take() {
  if (restating_) {
    takeRestatement();
  } else {
    takeRow();
  }
  return bytesOf(payload_);
}

void CsvStream::takeRestatement() {
  if (parts_.empty()) {
    const std::string part_id = fmt::format("r{}", ++restatements_);
    RestatementOptions how;
    how.part_id = part_id;
    how.mtu_bytes = options_.mtu_bytes;
    how.first_sequence = sequence_;
    how.time_ns = timeToSay(next_restatement_);
    parts_ = restate(state_, options_.source, how);
    parts_taken_ = 0;
  }
  payload_ = std::move(parts_[parts_taken_++]);
  ++sequence_;
  fold(next_restatement_);
  if (parts_taken_ == parts_.size()) {
    restating_ = false;
    parts_.clear();
    next_restatement_ += options_.restate;
  }
}

void CsvStream::takeRow() {
  const Nanoseconds time = rowTime();
  PacketHeader header;
  header.source = options_.source;
  header.run = options_.run;
  header.sequence = sequence_++;
  header.time_ns = timeToSay(time);
  if (!order_said_) {
    order_said_ = true;
    const std::vector<std::string_view> names(motion_->joints.begin(), motion_->joints.end());
    PacketTextWriter packet(header);
    packet.add(orderStatement(options_.device, names));
    payload_ = packet.text();
  } else {
    payload_ = headerText(header) + "\njoints " + encoded_device_ + " ";
    payload_ += motion_->valuesOf(motion_->rows[row_++]);
    payload_ += "\n";
  }
  fold(time);
}

void CsvStream::fold(Nanoseconds time) {
  if (options_.restate.count() == 0) return;
  if (const Packet* packet = decoder_->decode(bytesOf(payload_))) {
    state_.apply(LogTime(time), *packet);
  }
}

}  // namespace rocinante
