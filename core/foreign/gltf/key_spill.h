#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/unnamed_file.h"

namespace rocinante {

/// Many growing lists of numbers in one unnamed file, so that they can be read list by list. One
/// small block of each is in memory. One thread.
class KeySpill {
 public:
  /// unreadable when no file can be made in `folder`.
  static Result<KeySpill> make(const std::string& folder);

  /// A new, empty list.
  std::size_t addList();
  Status append(std::size_t list, std::span<const float> numbers);
  std::uint64_t bytesOf(std::size_t list) const;

  /// Gives the list's bytes in order, in pieces that are borrowed for the call.
  Status read(std::size_t list, const std::function<Status(ByteView)>& use) const;

 private:
  struct List {
    std::vector<std::uint64_t> blocks;  ///< places in the file, in blocks
    std::vector<float> open;            ///< what is not in the file yet
  };

  explicit KeySpill(UnnamedFile file) : file_(std::move(file)) {}
  Status writeBlock(List& list);

  UnnamedFile file_;
  std::vector<List> lists_;
  std::uint64_t blocks_ = 0;  ///< in the file
};

}  // namespace rocinante
