#include "player/source/csv_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

Pose poseOf(std::span<const double> row, const std::vector<std::size_t>& columns) {
  const auto at = [&](std::size_t part) { return row[columns[part]]; };
  return {{at(0), at(1), at(2)}, Quat(at(6), at(3), at(4), at(5))};
}

bool isRestated(std::string_view datagram) {
  // Names have no spaces in packet text.
  return datagram.substr(0, datagram.find('\n')).find(" restated") != datagram.npos;
}

/// Of a source, for the signals and their longest texts.
std::size_t memoryOf(const CsvSignals& signals) {
  std::vector<std::size_t> texts(signals.columns().size());
  for (const CsvSignals::Change& change : signals.changes()) {
    if (change.kind != SignalKind::text) continue;
    texts[change.index] = std::max(texts[change.index], signals.textOf(change).size());
  }
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto& [device, name] = signals.columns()[i].signal;
    bytes += 512 + 4 * (signalNameText(device, name).size() + texts[i]);
  }
  return bytes;
}

}  // namespace

Result<CsvStream> CsvStream::open(const CsvMotion& motion, Options options) {
  // Every row is set once before anything is sent: what a source refuses is an error of the table.
  CsvStream trial(motion, options);
  if (const Status opened = trial.openSource(); !opened) return opened.error();
  for (std::size_t row = 0; row < motion.rowCount(); ++row) {
    if (const Status set = trial.setRow(row); !set) return set.error();
  }
  CsvStream stream(motion, std::move(options));
  if (const Status opened = stream.openSource(); !opened) return opened.error();
  return stream;
}

CsvStream::CsvStream(const CsvMotion& motion, Options options)
    : motion_(&motion), options_(std::move(options)) {
  const Nanoseconds span = motion.times.back() - motion.times.front();
  const auto steps = static_cast<std::int64_t>(motion.rowCount()) - 1;
  period_ = steps > 0 ? span + span / steps : Nanoseconds(std::chrono::seconds(1));
  for (std::size_t row = 0; row < motion.rowCount() && !speaks_again_; ++row) {
    speaks_again_ = statesDevices(row) || motion.signals.changesAgain(row);
  }
}

Error CsvStream::refusal(SourceResult result, const std::string& where) const {
  if (result != SourceResult::too_long) {
    return {ErrorKind::bad_argument, std::string(sentenceOf(result)), where};
  }
  return {ErrorKind::bad_argument,
          fmt::format("a packet does not fit, --mtu is {}: choose fewer --columns or raise it",
                      options_.mtu_bytes),
          where};
}

Status CsvStream::openSource() {
  SourceSettings settings;
  settings.source = options_.source;
  settings.run = options_.run;
  settings.restate = options_.restate;
  settings.max_datagram = options_.mtu_bytes;
  settings.memory_bytes = (std::size_t{1} << 18U) + 16 * options_.mtu_bytes +
                          motion_->devices.size() * 4096 + motion_->column_count * 512 +
                          memoryOf(motion_->signals);
  const auto keep = [made = made_.get()](std::span<std::byte> datagram) {
    made->emplace_back(textOf(datagram));
    return true;
  };
  Result<Source> source = Source::open(settings, keep);
  if (!source) {
    // A wrong name, unless a larger datagram would do.
    settings.max_datagram = 65'507;
    settings.memory_bytes = std::size_t{1} << 20U;
    return Source::open(settings, keep) ? refusal(SourceResult::too_long, options_.source)
                                        : source.error();
  }
  source_.emplace(std::move(*source));
  for (const CsvMotion::Device& device : motion_->devices) {
    devices_.push_back(source_->device(device.name));
    if (device.joints.empty()) continue;
    const std::vector<std::string_view> names(device.joints.begin(), device.joints.end());
    const SourceResult ordered = source_->setOrder(devices_.back(), names);
    if (ordered != SourceResult::done) return refusal(ordered, device.name);
  }
  return {};
}

Status CsvStream::setRow(std::size_t row) {
  const std::span<const double> numbers = motion_->row(row);
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    const CsvMotion::Device& device = motion_->devices[i];
    SourceResult result = SourceResult::done;
    const bool has_joints = hasValues(numbers, device.joint_columns);
    const bool has_pose = hasValues(numbers, device.pose_columns);
    if (!has_joints && !has_pose) continue;
    values_.clear();
    for (const std::size_t column : device.joint_columns) values_.push_back(numbers[column]);
    if (has_joints) result = source_->setJoints(devices_[i], values_);
    if (result == SourceResult::done && has_pose) {
      result = source_->setPose(devices_[i], poseOf(numbers, device.pose_columns));
    }
    if (result == SourceResult::done) result = source_->repeat(devices_[i]);
    if (result == SourceResult::done) continue;
    return refusal(result, fmt::format("{}, row {}", device.name, row + 1));
  }
  return setSignals(row);
}

Status CsvStream::setSignals(std::size_t row) {
  for (const CsvSignals::Change& change : motion_->signals.of(row)) {
    const auto& [device, name] = motion_->signals.columns()[change.index].signal;
    const PathView path{device, name.link};
    SourceResult result{};
    switch (change.kind) {
      case SignalKind::number:
        result = source_->setSignal(path, name.name, change.number);
        break;
      case SignalKind::boolean:
        result = source_->setSignal(path, name.name, change.number != 0);
        break;
      case SignalKind::text:
        result = source_->setSignal(path, name.name, motion_->signals.textOf(change));
    }
    if (result == SourceResult::done) continue;
    return refusal(result, fmt::format("{}, row {}", signalNameText(device, name), row + 1));
  }
  return {};
}

/// Joints and poses are said in each row that has them.
bool CsvStream::statesDevices(std::size_t row) const {
  const std::span<const double> numbers = motion_->row(row);
  return std::ranges::any_of(motion_->devices, [&](const CsvMotion::Device& device) {
    return hasValues(numbers, device.joint_columns) || hasValues(numbers, device.pose_columns);
  });
}

/// Goes on to the next row that says something; false: no row does.
bool CsvStream::findRow() {
  while (true) {
    for (; row_ < motion_->rowCount(); ++row_) {
      if (statesDevices(row_)) return true;
      if (turn_ == 0 ? !motion_->signals.of(row_).empty() : motion_->signals.changesAgain(row_)) {
        return true;
      }
    }
    if (turn_ + 1 == options_.turns || !speaks_again_) return false;
    row_ = 0;
    ++turn_;
  }
}

/// Behind the last row that says anything: the end of all turns.
Nanoseconds CsvStream::rowTime() const {
  if (row_ < motion_->rowCount()) return motion_->times[row_] + period_ * turn_;
  if (options_.turns == 0) return Nanoseconds::max();
  return motion_->times.front() + period_ * options_.turns;
}

/// In the motion's time, which rounding must not turn back.
std::optional<Nanoseconds> CsvStream::restatementTime() const {
  const auto due = source_->due();
  if (!due) return std::nullopt;
  return std::max(motion_->times.front() + options_.speed.logDuration(*due), made_at_);
}

Result<std::optional<Due>> CsvStream::due() {
  if (!made_->empty()) {
    return std::optional(Due{LogTime(made_at_), turn_, isRestated(made_->front())});
  }
  const bool has_row = findRow();
  if (!has_row && turn_ + 1 == options_.turns) return std::optional<Due>();
  const auto restatement = restatementTime();
  if (restatement && *restatement <= rowTime() && (has_row || *restatement < rowTime())) {
    return std::optional(Due{LogTime(*restatement), turn_, true});
  }
  if (!has_row) return std::optional<Due>();
  return std::optional(Due{LogTime(rowTime()), turn_, false});
}

ByteView CsvStream::take() {
  if (made_->empty()) makeNext();
  payload_ = std::move(made_->front());
  made_->pop_front();
  return bytesOf(payload_);
}

void CsvStream::makeNext() {
  const auto restatement = restatementTime();
  if (restatement && *restatement <= rowTime()) return flush(*restatement, *source_->due());
  if (!order_written_) {
    order_written_ = true;
    flush(rowTime(), {});
    if (!made_->empty()) return;  // else there are only poses
  }
  // open() has set every row once: none is refused.
  static_cast<void>(setRow(row_));
  flush(rowTime(), {});
  ++row_;
}

/// `not_before` is on the source's own clock, which counts real time from the first row.
void CsvStream::flush(Nanoseconds time, Nanoseconds not_before) {
  made_at_ = time;
  const Nanoseconds played = options_.speed.realDuration(time - motion_->times.front());
  real_time_ = std::max({real_time_, played, not_before});
  const WallTime wall_time = options_.wall_now ? options_.wall_now() : WallTime(time);
  // Packet text has no times before the epoch. Keeping a datagram cannot fail.
  const bool has_wall_time = wall_time.time_since_epoch().count() >= 0;
  static_cast<void>(
      source_->flush(real_time_, has_wall_time ? std::optional(wall_time) : std::nullopt));
}

}  // namespace rocinante
