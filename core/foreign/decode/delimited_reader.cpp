#include <fmt/format.h>

#include <algorithm>

#include "core/foreign/decode/checksum.h"
#include "core/foreign/decode/field_reader.h"
#include "core/packet/text_number.h"

namespace rocinante::decode {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The first line of the datagram: columns between separators. With a checksum it ends as NMEA 0183
/// has it: `*` and two hexadecimal digits, the sum of the bytes between `$` or `!` and `*`.
class DelimitedReader final : public FieldReader {
 public:
  explicit DelimitedReader(const Decoder& decoder) : decoder_(decoder) {}

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    std::string_view line = firstLine(datagram);
    if (decoder_.checksum && !takeChecksum(line)) return refuse("its checksum is wrong");
    split(line);
    for (std::size_t i = 0; i < decoder_.fields.size(); ++i) {
      const std::size_t column = decoder_.fields[i].column;
      values[i] = column < columns_.size() && !columns_[column].empty()
                      ? FieldValue::of(columns_[column])
                      : FieldValue();
    }
    return true;
  }

  std::vector<FoundField> undeclared(ByteView datagram, std::size_t most) override {
    std::string_view line = firstLine(datagram);
    if (decoder_.checksum) (void)takeChecksum(line);
    split(line);
    std::vector<FoundField> found;
    for (std::size_t column = 0; column < columns_.size() && found.size() < most; ++column) {
      const auto declares = [&](const Field& field) { return field.column == column; };
      if (std::any_of(decoder_.fields.begin(), decoder_.fields.end(), declares)) continue;
      found.push_back({fmt::format("column {}", column), std::string(columns_[column])});
    }
    return found;
  }

 private:
  static std::string_view firstLine(ByteView datagram) {
    const std::string_view text = textOf(datagram);
    std::string_view line = text.substr(0, text.find('\n'));
    while (line.ends_with('\r') || line.ends_with('\0')) line.remove_suffix(1);
    return line;
  }

  /// Takes the sum off the line.
  bool takeChecksum(std::string_view& line) const {
    const std::size_t star = line.rfind('*');
    if (star == line.npos) return false;
    const std::optional<std::uint64_t> sent = readHex(line.substr(star + 1), 2);
    std::string_view summed = line.substr(0, star);
    line = summed;
    if (summed.starts_with('$') || summed.starts_with('!')) summed.remove_prefix(1);
    return sent == checksumOf(decoder_.checksum->kind, rocinante::bytesOf(summed), {});
  }

  void split(std::string_view line) {
    columns_.clear();
    const std::string& separator = decoder_.separator;
    if (separator == " ") {
      while (!(line = trimmed(line)).empty()) {
        const std::size_t end = line.find_first_of(" \t");
        columns_.push_back(line.substr(0, end));
        line.remove_prefix(std::min(end, line.size()));
      }
      return;
    }
    while (true) {
      const std::size_t end = line.find(separator);
      columns_.push_back(trimmed(line.substr(0, end)));
      if (end == line.npos) return;
      line.remove_prefix(end + separator.size());
    }
  }

  const Decoder& decoder_;
  std::vector<std::string_view> columns_;
};

}  // namespace

std::unique_ptr<FieldReader> makeDelimitedReader(const Decoder& decoder) {
  return std::make_unique<DelimitedReader>(decoder);
}

}  // namespace rocinante::decode
