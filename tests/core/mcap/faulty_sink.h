#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>

#include "core/mcap/byte_sink.h"

namespace rocinante::test {

/// How a disk in memory fails.
struct DiskFaults {
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  std::size_t room = kNever;        ///< its total size in bytes
  bool preallocates = true;         ///< false: a file system without fallocate
  std::size_t fails_at = kNever;    ///< the number of the write (append or overwrite) that fails
  bool fails_from_then_on = false;  ///< a disk that went away, not one write
  bool takes_half = false;          ///< the first half of a failing write is written
  bool truncates = true;            ///< false: truncating fails after the failing write
};

/// A sink in memory that fails according to `faults`, and counts its writes in `writes`.
class FaultySink final : public ByteSink {
 public:
  FaultySink(Bytes& out, const DiskFaults& faults, std::size_t& writes)
      : out_(out), faults_(faults), writes_(writes) {}

  Status append(ByteView bytes) override {
    const std::size_t free = std::max(faults_.room, out_.size()) - out_.size();
    std::size_t fits = std::min(bytes.size(), free);
    const bool broken = fails();
    if (broken) fits = std::min(fits, faults_.takes_half ? bytes.size() / 2 : 0);
    out_.insert(out_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(fits));
    if (broken) return disappeared();
    if (fits < bytes.size()) return full();
    return {};
  }

  Status truncate(std::uint64_t size_bytes) override {
    if (gone_ && !faults_.truncates) return disappeared();
    out_.resize(static_cast<std::size_t>(size_bytes));
    return {};
  }

  bool overwritable() const override { return true; }
  Status overwriteAt(std::uint64_t offset, ByteView bytes) override {
    const bool broken = fails();
    const std::size_t fits = broken ? (faults_.takes_half ? bytes.size() / 2 : 0) : bytes.size();
    std::memcpy(out_.data() + offset, bytes.data(), fits);
    if (broken) return disappeared();
    return {};
  }

  Status reserve(std::uint64_t size_bytes) override {
    if (!faults_.preallocates || size_bytes <= faults_.room) return {};
    return full();
  }

  Status close() override {
    if (gone_ && faults_.fails_from_then_on) return disappeared();
    return {};
  }
  const std::string& name() const override { return name_; }

 private:
  bool fails() {
    const std::size_t number = writes_++;
    const bool now =
        number == faults_.fails_at || (faults_.fails_from_then_on && number > faults_.fails_at);
    gone_ = gone_ || now;
    return now;
  }
  Error full() const {
    return {ErrorKind::unreadable, "cannot write to the file: No space left on device", name_};
  }
  Error disappeared() const {
    return {ErrorKind::unreadable, "cannot write to the file: Input/output error", name_};
  }

  Bytes& out_;
  DiskFaults faults_;
  std::size_t& writes_;
  bool gone_ = false;
  std::string name_ = "disk";
};

}  // namespace rocinante::test
