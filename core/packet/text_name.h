#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// Memory for names and strings that do not stand in the datagram as they mean. Never moves what
/// it gave out: begin() reserves as much as the datagram could ever need, and only when asked for.
class TextArena {
 public:
  /// Forgets all. At most `bytes` will be appended until the next begin().
  void begin(std::size_t bytes) {
    memory_.clear();
    most_bytes_ = bytes;
  }
  /// Where the next append() goes; the view from here to end() is what was appended since.
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

/// The name that `raw` writes, or nothing when it is none: empty, longer than 255 bytes, a byte
/// that had to be percent-encoded, a control character, or not UTF-8. Borrowed from `raw` or
/// `arena`.
std::optional<std::string_view> decodeName(std::string_view raw, TextArena& arena);

/// The string whose opening quote stands at `at`; on success `at` is after the closing one.
/// Escapes are \" \\ \n; any other backslash, a control character but tab, bytes that are no UTF-8,
/// and more than 4,096 bytes are refused.
std::optional<std::string_view> decodeString(const char*& at, const char* end, TextArena& arena);

/// Appends `name` percent-encoded where it must be.
void appendName(std::string& text, std::string_view name);

/// Appends `string` quoted and escaped. What a string cannot hold becomes U+FFFD.
void appendString(std::string& text, std::string_view string);

/// The bytes of the UTF-8 sequence at the start of `text`, or 0 when there is no valid one.
std::size_t utf8Length(std::string_view text);

}  // namespace rocinante
