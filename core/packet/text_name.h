#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// Memory for names and strings that differ from their bytes in the datagram. Never moves what it
/// returned: begin() reserves as much as the datagram could ever need, but only when memory is
/// first requested.
class TextArena {
 public:
  /// Clears everything. At most `bytes` will be appended until the next begin().
  void begin(std::size_t bytes) {
    memory_.clear();
    most_bytes_ = bytes;
  }
  /// The position of the next append(); the view from here to end() is what was appended since.
  std::size_t mark() {
    if (memory_.capacity() < most_bytes_) memory_.reserve(most_bytes_);
    return memory_.size();
  }
  void append(char byte) { memory_.push_back(byte); }
  std::string_view since(std::size_t mark) const {
    return {memory_.data() + mark, memory_.size() - mark};
  }

 private:
  std::vector<char> memory_;
  std::size_t most_bytes_ = 0;
};

/// True for A-Z a-z 0-9 _ . - : which stand for themselves in a name.
bool isNameByte(char byte);

/// The name written as `raw`, or nothing when it is not a name: empty, longer than 255 bytes, a
/// byte that needs percent-encoding, a control character, or not UTF-8. Borrowed from `raw` or
/// `arena`.
std::optional<std::string_view> decodeName(std::string_view raw, TextArena& arena);

/// Reads the string whose opening quote is at `at`; on success `at` is after the closing one.
/// Escapes are \" \\ \n; refuses any other backslash, a control character except tab, bytes that
/// are not UTF-8, and more than 4,096 bytes.
std::optional<std::string_view> decodeString(const char*& at, const char* end, TextArena& arena);

/// Appends `name`, percent-encoded where necessary.
void appendName(std::string& text, std::string_view name);

/// Appends `string` quoted and escaped. Characters that a string cannot hold become U+FFFD.
void appendString(std::string& text, std::string_view string);
}  // namespace rocinante
