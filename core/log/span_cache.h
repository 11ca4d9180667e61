#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"

namespace rocinante {

/// The expanded spans of one file: the last ones used are kept, in bounded memory, so that moving
/// back and forth does not expand them again. A span's damage is listed when it is first read.
class SpanCache {
 public:
  /// `mapped` is the file that contains `file`, or null. All are borrowed and must outlive this;
  /// damage is appended to `damage`, once per span. `channels` is by id, null for an unused id.
  SpanCache(ByteView file, const MappedFile* mapped, const std::vector<MessageSpan>& spans,
            const std::vector<const LogChannel*>& channels, std::vector<DamageSpan>& damage);

  /// `file` and the borrowed lists have grown: spans from `first_changed` on are read again.
  void fileGrew(ByteView file, std::size_t first_changed);

  /// The messages of a span, without those on unknown channels. They live as long as the pointer is
  /// held, independent of later calls.
  std::shared_ptr<const SpanMessages> get(std::uint32_t span);

  const std::vector<MessageSpan>& spans() const { return spans_; }
  const std::vector<const LogChannel*>& channels() const { return channels_; }
  const SpanDecoder& decoder() const { return decoder_; }
  /// Lists damage that was found while using the span.
  void addDamage(DamageSpan damage) { damage_.push_back(std::move(damage)); }

 private:
  struct Kept {
    std::uint32_t span;
    std::shared_ptr<SpanMessages> messages;
  };

  std::shared_ptr<SpanMessages> makeRoom();
  void report(std::uint32_t span, SpanMessages& messages);

  const std::vector<MessageSpan>& spans_;
  const std::vector<const LogChannel*>& channels_;
  std::vector<DamageSpan>& damage_;
  SpanDecoder decoder_;
  std::vector<bool> reported_;  ///< by span: it was read, and its damage listed
  std::vector<bool> faulty_;    ///< by span: it had damage
  std::vector<Kept> kept_;      ///< in order of last use
};

/// The message at a position in a span; its payload is borrowed from `messages`.
LogMessage messageAt(const SpanMessages& messages, const SpanMessages::Place& place,
                     std::uint32_t span, const std::vector<const LogChannel*>& channels);

/// LogMessage::file_offset of the message at `offset` of the expanded span.
inline std::uint64_t placeInFile(std::uint32_t span, std::uint32_t offset) {
  return (std::uint64_t{span} << 32U) | offset;
}

}  // namespace rocinante
