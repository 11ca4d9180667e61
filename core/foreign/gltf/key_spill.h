#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// Many growing lists of numbers in one unnamed file, so that they can be read list by list. One
/// small block of each is in memory. One thread.
class KeySpill {
 public:
  /// unreadable when no file can be made in `folder`.
  static Result<KeySpill> make(const std::string& folder);
  ~KeySpill();
  KeySpill(KeySpill&& other) noexcept;
  KeySpill& operator=(KeySpill&&) = delete;

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

  KeySpill(int file, std::string folder) : file_(file), folder_(std::move(folder)) {}
  Status writeBlock(List& list);
  Error refusal(const char* what) const;

  int file_;
  std::string folder_;
  std::vector<List> lists_;
  std::uint64_t blocks_ = 0;  ///< in the file
};

}  // namespace rocinante
