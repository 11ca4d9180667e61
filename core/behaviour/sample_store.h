#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/unnamed_file.h"
#include "core/log/mapped_file.h"

namespace rocinante {

/// Numbers of a track: in memory, or of a file that is mapped.
class SampleBytes {
 public:
  SampleBytes() = default;
  explicit SampleBytes(Bytes bytes) : bytes_(std::move(bytes)), view_(bytes_) {}
  /// The first `size` bytes of the file.
  SampleBytes(MappedFile file, std::size_t size)
      : file_(std::move(file)), view_(file_.bytes().first(size)) {}
  SampleBytes(const SampleBytes&) = delete;
  SampleBytes& operator=(const SampleBytes&) = delete;

  ByteView view() const { return view_; }

 private:
  Bytes bytes_;
  MappedFile file_;
  ByteView view_;
};

/// Takes bytes one after another and gives them back at once. From 64 MB on they are kept in a file
/// without a name in the folder for temporary files, so that the system can page them out. One
/// thread.
class SampleStore {
 public:
  std::uint64_t size() const { return in_file_ + bytes_.size(); }
  void append(ByteView bytes);
  /// unreadable when the file could not be made, written or mapped.
  Result<std::shared_ptr<const SampleBytes>> finish();

 private:
  Status flush();

  Bytes bytes_;
  std::uint64_t in_file_ = 0;
  std::optional<UnnamedFile> file_;
  Status done_;  ///< of the first flush that failed
};

inline constexpr std::size_t kBlockRows = 256;
/// In place of a value that a packet does not state.
inline constexpr double kNotHere = std::numeric_limits<double>::infinity();

}  // namespace rocinante
