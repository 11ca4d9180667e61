#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/records.h"
#include "core/mcap/writer.h"

namespace rocinante::test {

/// Makes files like those of other writers, record by record.
class FileMaker {
 public:
  explicit FileMaker(std::string profile = "") {
    bytes_.assign(mcap::magic().begin(), mcap::magic().end());
    add(mcap::Header{std::move(profile), "test"});
  }
  template <class T>
  FileMaker& add(const T& record) {
    append(bytes_, record);
    return *this;
  }
  FileMaker& addUnknown(std::uint8_t opcode, std::size_t size) {
    bytes_.push_back(std::byte{opcode});
    for (std::size_t i = 0; i < 8; ++i)
      bytes_.push_back(std::byte{i == 0 ? std::uint8_t(size) : std::uint8_t(0)});
    bytes_.resize(bytes_.size() + size);
    return *this;
  }
  /// DataEnd, Footer without a summary, magic.
  Bytes end() {
    add(mcap::DataEnd{}).add(mcap::Footer{});
    bytes_.insert(bytes_.end(), mcap::magic().begin(), mcap::magic().end());
    return bytes_;
  }

 private:
  Bytes bytes_;
};

/// An uncompressed chunk of messages (time, payload) on channel 1, which it defines.
inline mcap::Chunk makeChunk(Bytes& records,
                             const std::vector<std::pair<std::uint64_t, std::string>>& messages) {
  records.clear();
  append(records, mcap::Channel{1, 0, "/udp/1/a", "octets", {}});
  mcap::Chunk chunk;
  chunk.message_start_time = ~std::uint64_t{0};
  for (const auto& [time, payload] : messages) {
    append(records, mcap::Message{1, 0, time, time, bytesOf(payload)});
    chunk.message_start_time = std::min(chunk.message_start_time, time);
    chunk.message_end_time = std::max(chunk.message_end_time, time);
  }
  chunk.uncompressed_size = records.size();
  chunk.uncompressed_crc = crc32(records);
  chunk.records = records;
  return chunk;
}

}  // namespace rocinante::test
