#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/record_stepper.h"
#include "tests/core/log/log_support.h"

// The worked example of docs/log-format.md: ROCINANTE_UPDATE=1 rewrites it there.
namespace rocinante::test {
namespace {

using mcap::Opcode;

constexpr std::string_view kBegin = "<!-- the example begins -->\n";
constexpr std::string_view kEnd = "<!-- the example ends -->\n";

/// Prints bytes one field per line: file offset, bytes, meaning.
class Listing {
 public:
  explicit Listing(ByteView file) : file_(file) {}

  std::uint64_t position() const { return position_; }
  std::string take() { return std::move(text_); }
  void goTo(std::uint64_t offset) { position_ = offset; }

  void magic() { line(8, "magic"); }
  template <class T>
  T number(std::string_view what) {
    T value = 0;
    std::memcpy(&value, file_.data() + position_, sizeof(T));
    const bool open = sizeof(T) == 8 && value == std::numeric_limits<T>::max();
    line(sizeof(T), fmt::format("{} {}", what, open ? "not known yet" : std::to_string(value)));
    return value;
  }
  std::uint32_t checksum(std::string_view what) {
    std::uint32_t value = 0;
    std::memcpy(&value, file_.data() + position_, sizeof(value));
    line(sizeof(value), fmt::format("{} {:08x}", what, value));
    return value;
  }
  void string(std::string_view what) {
    std::uint32_t size = 0;
    std::memcpy(&size, file_.data() + position_, sizeof(size));
    const std::string_view found = textOf(file_.subspan(position_ + 4, size));
    line(4 + size, fmt::format("{} \"{}\"", what, found));
  }
  void payload(std::uint64_t size) {
    std::string shown;
    for (const char c : textOf(file_.subspan(position_, size))) {
      shown += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    line(size, fmt::format("  data \"{}\"", shown));
  }
  /// Opcode and length; the record's end.
  std::uint64_t prefix() {
    const auto opcode = static_cast<Opcode>(file_[position_]);
    std::uint64_t length = 0;
    std::memcpy(&length, file_.data() + position_ + 1, sizeof(length));
    const bool open = length == ~std::uint64_t{0};
    line(9, fmt::format("{}, {} bytes", mcap::nameOf(opcode),
                        open ? "an open number of" : std::to_string(length)));
    return open ? file_.size() : position_ + length;
  }

 private:
  void line(std::uint64_t size, std::string_view what) {
    constexpr std::uint64_t kBytesALine = 16;
    for (std::uint64_t at = 0; at < size; at += kBytesALine) {
      const std::uint64_t some = std::min(kBytesALine, size - at);
      std::string hex;
      for (const std::byte byte : file_.subspan(position_ + at, some)) {
        hex += fmt::format("{:02x} ", std::to_integer<unsigned>(byte));
      }
      if (at + some < size) {
        text_ += fmt::format("{:04x}  {}\n", position_ + at, hex.substr(0, hex.size() - 1));
      } else {
        text_ += fmt::format("{:04x}  {:<48}{}\n", position_ + at, hex, what);
      }
    }
    position_ += size;
  }

  ByteView file_;
  std::uint64_t position_ = 0;
  std::string text_;
};

void listMap(Listing& list) {
  std::uint64_t end = list.number<std::uint32_t>("  map, bytes");
  for (end += list.position(); list.position() < end;) {
    list.string("    key");
    list.string("    value");
  }
}

void listCounts(Listing& list, std::string_view what) {
  std::uint64_t end = list.number<std::uint32_t>("  map, bytes");
  for (end += list.position(); list.position() < end;) {
    list.number<std::uint16_t>("    channel");
    list.number<std::uint64_t>(what);
  }
}

/// The fields of a chunk before its records.
void listChunkHead(Listing& list) {
  list.number<std::uint64_t>("  message_start_time");
  list.number<std::uint64_t>("  message_end_time");
  list.number<std::uint64_t>("  uncompressed_size");
  list.checksum("  uncompressed_crc");
  list.string("  compression");
  list.number<std::uint64_t>("  records, bytes");
}

void listRecord(Listing& list, Opcode opcode, std::uint64_t end) {
  switch (opcode) {
    case Opcode::header:
      list.string("  profile");
      list.string("  library");
      break;
    case Opcode::metadata:
      list.string("  name");
      listMap(list);
      break;
    case Opcode::chunk:
      listChunkHead(list);
      break;
    case Opcode::channel:
      list.number<std::uint16_t>("  id");
      list.number<std::uint16_t>("  schema_id");
      list.string("  topic");
      list.string("  message_encoding");
      listMap(list);
      break;
    case Opcode::message:
      list.number<std::uint16_t>("  channel_id");
      list.number<std::uint32_t>("  sequence");
      list.number<std::uint64_t>("  log_time");
      list.number<std::uint64_t>("  publish_time");
      list.payload(end - list.position());
      break;
    case Opcode::message_index:
      list.number<std::uint16_t>("  channel_id");
      list.number<std::uint32_t>("  records, bytes");
      while (list.position() < end) {
        list.number<std::uint64_t>("    log_time");
        list.number<std::uint64_t>("    offset in the chunk");
      }
      break;
    case Opcode::data_end:
      list.checksum("  data_section_crc");
      break;
    case Opcode::statistics:
      list.number<std::uint64_t>("  message_count");
      list.number<std::uint16_t>("  schema_count");
      list.number<std::uint32_t>("  channel_count");
      list.number<std::uint32_t>("  attachment_count");
      list.number<std::uint32_t>("  metadata_count");
      list.number<std::uint32_t>("  chunk_count");
      list.number<std::uint64_t>("  message_start_time");
      list.number<std::uint64_t>("  message_end_time");
      listCounts(list, "    messages");
      break;
    case Opcode::chunk_index:
      list.number<std::uint64_t>("  message_start_time");
      list.number<std::uint64_t>("  message_end_time");
      list.number<std::uint64_t>("  chunk_start_offset");
      list.number<std::uint64_t>("  chunk_length");
      listCounts(list, "    offset of its MessageIndex");
      list.number<std::uint64_t>("  message_index_length");
      list.string("  compression");
      list.number<std::uint64_t>("  compressed_size");
      list.number<std::uint64_t>("  uncompressed_size");
      break;
    case Opcode::metadata_index:
      list.number<std::uint64_t>("  offset");
      list.number<std::uint64_t>("  length");
      list.string("  name");
      break;
    case Opcode::summary_offset:
      list.number<std::uint8_t>("  group_opcode");
      list.number<std::uint64_t>("  group_start");
      list.number<std::uint64_t>("  group_length");
      break;
    case Opcode::footer:
      list.number<std::uint64_t>("  summary_start");
      list.number<std::uint64_t>("  summary_offset_start");
      list.checksum("  summary_crc");
      break;
    default:
      FAIL() << "the example has no " << mcap::nameOf(opcode);
  }
}

std::string listed(const Bytes& file) {
  Listing list(file);
  list.magic();
  while (list.position() + mcap::magic().size() < file.size()) {
    const auto opcode = static_cast<Opcode>(file[list.position()]);
    const std::uint64_t end = list.prefix();
    listRecord(list, opcode, end);
    // The records of a chunk follow its head, as records do.
    if (opcode != Opcode::chunk) {
      EXPECT_EQ(list.position(), end);
    }
  }
  list.magic();
  return list.take();
}

std::string example() {
  constexpr std::int64_t kOrigin = 1'770'091'506'000'000'000;
  Bytes file;
  LogWriterOptions options;
  options.compression = LogWriterOptions::Compression::none;
  LogWriter writer = makeWriter(file, options);
  const ChannelId channel = *writer.addChannel("/udp/19960/arm", "rk1", {{"source", "arm"}});
  EXPECT_TRUE(
      writer.write(channel, 0, at(kOrigin), kOrigin, bytesOf("RK1 arm - -\njoint arm a=1\n")).ok());
  EXPECT_TRUE(writer.flushIfDue(SteadyTime(options.sync)).ok());
  const Bytes flushed = file;
  EXPECT_TRUE(writer
                  .write(channel, 1, at(kOrigin + 20'000'000), kOrigin + 20'000'000,
                         bytesOf("RK1 arm - -\njoint arm a=2\n"))
                  .ok());
  EXPECT_TRUE(writer.close("interrupted").ok());

  // Only the head of the chunk differs between the two.
  std::size_t chunk = 0;
  for (std::uint64_t at = 8; static_cast<Opcode>(file[at]) != Opcode::chunk;) {
    at = mcap::recordAt(file, at)->end();
    chunk = static_cast<std::size_t>(at);
  }
  Listing open(flushed);
  open.goTo(chunk);
  open.prefix();
  listChunkHead(open);

  return fmt::format(
      R"(Two datagrams of one source, uncompressed; numbers have their least significant byte first. After
the first datagram was flushed, the file ends with an open chunk, whose head is

```
{}```

and whose records, a Channel and a Message, end the file. When the second had come and the recording
was over, it was this:

```
{}```
)",
      open.take(), listed(file));
}

TEST(LogFormatPage, ItsWorkedExampleIsWhatTheWriterWrites) {
  const std::filesystem::path path =
      std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "log-format.md";
  std::string page = *readFile(path);
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  ASSERT_NE(begin, page.npos);
  ASSERT_LT(begin, end);
  const std::size_t from = begin + kBegin.size();
  const std::string shown = page.substr(from, end - from);
  if (std::getenv("ROCINANTE_UPDATE") != nullptr) {
    page.replace(from, shown.size(), example());
    ASSERT_TRUE(writeFileWhole(path, bytesOf(page), true).ok());
    FAIL() << "updated: read the difference, then run again without ROCINANTE_UPDATE";
  }
  EXPECT_EQ(shown, example());
}

}  // namespace
}  // namespace rocinante::test
