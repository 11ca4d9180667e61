#pragma once

#include <gtest/gtest.h>
#include <zstd.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/mcap/append_record.h"
#include "core/mcap/records.h"
#include "tests/core/log/log_support.h"
#include "tests/core/mcap/file_maker.h"

namespace rocinante::test {

/// A recorder's change to a file, write by write.
class WriteHistory {
 public:
  struct Write {
    std::optional<std::size_t> offset;  ///< empty: at the end
    Bytes bytes;
    std::size_t messages = 0;  ///< that must be read once it is done
  };

  explicit WriteHistory(bool compressed) : compressed_(compressed) {
    Bytes begin(mcap::magic().begin(), mcap::magic().end());
    mcap::append(begin, mcap::Header{std::string(profile::kName), "test"});
    mcap::Metadata session;
    session.name = profile::kSession;
    session.metadata = {{"format", "1"}, {"session_id", "s"}, {"origin_ns", "1000"}};
    mcap::append(begin, session);
    append(std::move(begin));
  }
  ~WriteHistory() { ZSTD_freeCCtx(zstd_); }
  WriteHistory(const WriteHistory&) = delete;
  WriteHistory& operator=(const WriteHistory&) = delete;

  void beginOpenChunk() {
    beginRecords();
    chunk_offset_ = size_;
    Bytes whole;
    mcap::append(whole, chunk());
    Bytes begin(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(headBytes()));
    // Length, end time, size, checksum, length of the records: docs/log-format.md.
    std::fill_n(begin.begin() + 1, 8, std::byte{0xFF});
    std::fill_n(begin.begin() + 17, 16, std::byte{0xFF});
    std::fill_n(begin.begin() + 33, 4, std::byte{0});
    std::fill_n(begin.end() - 8, 8, std::byte{0xFF});
    append(std::move(begin));
    ZSTD_CCtx_reset(zstd_, ZSTD_reset_session_only);
    stored_.clear();
  }
  void addMessages(int count) {
    append(pieceOf(count, ZSTD_e_flush));
    writes_.back().messages = messages_.size();
  }
  void endOpenChunk(int count) {
    Bytes rest = pieceOf(count, ZSTD_e_end);
    if (!rest.empty()) {
      append(std::move(rest));
      writes_.back().messages = messages_.size();
    }
    Bytes whole;
    mcap::append(whole, chunk());
    whole.resize(headBytes());
    writes_.push_back({chunk_offset_, std::move(whole), messages_.size()});
    appendIndexes();
  }
  void addWholeChunk(int count) {
    beginRecords();
    ZSTD_CCtx_reset(zstd_, ZSTD_reset_session_only);
    stored_.clear();
    (void)pieceOf(count, ZSTD_e_end);
    Bytes whole;
    mcap::append(whole, chunk());
    append(std::move(whole));
    writes_.back().messages = messages_.size();
    appendIndexes();
  }
  void addAttachment() {
    Bytes bytes;
    const std::string data(200, 'a');
    mcap::Attachment attachment;
    attachment.name = "cell.toml";
    attachment.data = bytesOf(data);
    mcap::append(bytes, attachment);
    append(std::move(bytes));
  }
  void finish() {
    Bytes end;
    mcap::append(end, mcap::Metadata{std::string(profile::kEnd), {{"reason", "stopped"}}});
    mcap::append(end, mcap::DataEnd{0});
    mcap::append(end, mcap::Statistics{});
    mcap::append(end, mcap::Footer{});
    end.insert(end.end(), mcap::magic().begin(), mcap::magic().end());
    append(std::move(end));
  }

  const std::vector<Write>& writes() const { return writes_; }
  const std::vector<KeptMessage>& messages() const { return messages_; }

  /// The file after the first `count` writes.
  Bytes after(std::size_t count) const {
    Bytes file;
    for (std::size_t i = 0; i < count; ++i) apply(file, writes_[i]);
    return file;
  }
  static void apply(Bytes& file, const Write& write) {
    const std::size_t offset = write.offset.value_or(file.size());
    file.resize(std::max(file.size(), offset + write.bytes.size()));
    std::copy(write.bytes.begin(), write.bytes.end(),
              file.begin() + static_cast<std::ptrdiff_t>(offset));
  }

 private:
  void append(Bytes bytes) {
    size_ += bytes.size();
    writes_.push_back({std::nullopt, std::move(bytes), messages_.size()});
  }
  void beginRecords() {
    records_.clear();
    indexes_ = {mcap::MessageIndex{7, {}}, mcap::MessageIndex{8, {}}};
    times_.clear();
  }
  void appendIndexes() {
    Bytes bytes;
    for (const mcap::MessageIndex& index : indexes_) {
      if (!index.records.empty()) mcap::append(bytes, index);
    }
    append(std::move(bytes));
  }
  std::size_t headBytes() const { return 9 + 8 + 8 + 8 + 4 + 4 + (compressed_ ? 4 : 0) + 8; }
  mcap::Chunk chunk() const {
    mcap::Chunk chunk;
    if (!times_.empty()) {
      chunk.message_start_time = times_.front();
      chunk.message_end_time = times_.back();
    }
    chunk.uncompressed_size = records_.size();
    chunk.uncompressed_crc = crc32(records_);
    chunk.compression = compressed_ ? "zstd" : "";
    chunk.records = stored_;
    return chunk;
  }
  /// `count` more messages of the chunk, as stored.
  Bytes pieceOf(int count, ZSTD_EndDirective how) {
    Bytes plain;
    const std::array<std::string, 2> topics{"/udp/1/arm", "/udp/1/hand"};
    for (std::uint16_t i = 0; i < 2 && records_.empty(); ++i) {
      mcap::append(plain, mcap::Channel{indexes_[i].channel_id, 0, topics[i], "rk1", {}});
    }
    for (int i = 0; i < count; ++i) {
      const auto n = static_cast<std::uint32_t>(messages_.size());
      // Their bytes look like records: only their length tells them apart.
      const std::string payload = "RK1 arm " + std::to_string(n) + " -\n" +
                                  std::string(n * 7 % 40, n % 2 == 0 ? '\x05' : '\x07');
      mcap::MessageIndex& index = indexes_[n % 3 == 1 ? 1 : 0];
      index.records.emplace_back(times_.emplace_back(1000 + n), records_.size() + plain.size());
      mcap::append(plain, mcap::Message{index.channel_id, n, 1000 + n, 900 + n, bytesOf(payload)});
      messages_.push_back({topics[n % 3 == 1 ? 1 : 0], n, 1000 + n, 900 + n, payload});
    }
    records_.insert(records_.end(), plain.begin(), plain.end());
    Bytes piece = plain;
    if (compressed_) {
      piece.resize(ZSTD_compressBound(plain.size()) + 64);
      ZSTD_inBuffer in{plain.data(), plain.size(), 0};
      ZSTD_outBuffer out{piece.data(), piece.size(), 0};
      EXPECT_EQ(ZSTD_compressStream2(zstd_, &out, &in, how), 0U);
      piece.resize(out.pos);
    }
    stored_.insert(stored_.end(), piece.begin(), piece.end());
    return piece;
  }

  bool compressed_;
  ZSTD_CCtx* zstd_ = ZSTD_createCCtx();
  std::vector<Write> writes_;
  std::vector<KeptMessage> messages_;
  std::size_t size_ = 0;
  std::size_t chunk_offset_ = 0;
  // Of the current chunk.
  Bytes records_;
  Bytes stored_;
  std::array<mcap::MessageIndex, 2> indexes_;
  std::vector<std::uint64_t> times_;
};

inline void record(WriteHistory& history) {
  history.beginOpenChunk();
  history.addMessages(1);
  history.addMessages(5);
  history.addMessages(2);
  history.endOpenChunk(3);
  history.addAttachment();
  history.addWholeChunk(4);
  history.beginOpenChunk();
  history.addMessages(3);
  history.endOpenChunk(0);
  history.finish();
}

}  // namespace rocinante::test
