#pragma once

#include <cstdint>
#include <vector>

#include "core/mcap/chunk_expander.h"
#include "core/mcap/stream_reader.h"
#include "recorder/doctor/doctor_facts.h"
#include "recorder/doctor/profile_rules.h"

namespace rocinante {

/// Looks at one chunk after another, and at the message indexes that follow each. Holds one chunk.
class ChunkRules {
 public:
  /// `profile` is null for files that are not ours. All are borrowed.
  ChunkRules(DoctorReport& report, DoctorFacts& facts, Definitions& definitions,
             ProfileRules* profile, std::uint64_t file_bytes)
      : report_(report),
        facts_(facts),
        definitions_(definitions),
        profile_(profile),
        budget_(file_bytes) {}

  /// A Chunk record at its place in the file.
  void chunk(const mcap::Record& record);
  /// A MessageIndex that follows it, or another of them.
  void index(const mcap::Record& record);
  /// All its indexes were given.
  void end();

  /// A message of a chunk, or one outside: of a channel that is known, counted.
  void message(const mcap::Record& record, std::uint64_t offset);

 private:
  /// A message of the chunk, as its index must have it.
  struct Entry {
    std::uint16_t channel;
    std::uint64_t time;
    std::uint64_t offset;  ///< in the chunk
    auto operator<=>(const Entry&) const = default;
  };

  std::uint64_t number() const { return facts_.chunk_offsets.size(); }
  /// Its messages cannot be known.
  void unreadable();
  void records(const mcap::Chunk& chunk, ByteView records);
  void times(const mcap::Chunk& chunk);

  DoctorReport& report_;
  DoctorFacts& facts_;
  Definitions& definitions_;
  ProfileRules* profile_;
  mcap::ExpansionBudget budget_;
  mcap::ChunkExpander expander_;
  mcap::Scratch scratch_;

  std::uint64_t offset_ = 0;  ///< of the chunk
  bool open_ = false;         ///< its indexes may follow
  bool readable_ = false;
  bool any_index_ = false;
  std::vector<Entry> entries_;  ///< sorted when the first index comes
  /// By channel id: the number of the last chunk that defined it, and of the last whose index came.
  class LastChunk {
   public:
    std::uint64_t& operator[](std::uint16_t id) {
      if (id >= numbers_.size()) numbers_.resize(id + 1U);
      return numbers_[id];
    }

   private:
    std::vector<std::uint64_t> numbers_;
  };
  LastChunk defined_in_;
  LastChunk indexed_in_;
};

}  // namespace rocinante
