#pragma once

#include <cstdint>
#include <vector>

#include "core/mcap/chunk_expander.h"
#include "core/mcap/record_stepper.h"
#include "recorder/doctor/doctor_facts.h"
#include "recorder/doctor/profile_rules.h"

namespace rocinante {

/// Checks each chunk and the message indexes that follow it. Holds one chunk.
class ChunkRules {
 public:
  /// `profile` is null for files of another profile. All are borrowed.
  ChunkRules(DoctorReport& report, DoctorFacts& facts, Definitions& definitions,
             ProfileRules* profile, std::uint64_t file_bytes)
      : report_(report),
        facts_(facts),
        definitions_(definitions),
        profile_(profile),
        budget_(file_bytes) {}

  /// Checks a Chunk record.
  void chunk(const mcap::Record& record);
  /// Checks a MessageIndex after the chunk.
  void index(const mcap::Record& record);
  /// Call after the chunk's last index.
  void end();

  /// Checks and counts a message inside or outside a chunk.
  void message(const mcap::Record& record, std::uint64_t offset);

 private:
  /// A message of the chunk, as its index must list it.
  struct Entry {
    std::uint16_t channel;
    std::uint64_t time;
    std::uint64_t offset;  ///< in the chunk
    auto operator<=>(const Entry&) const = default;
  };

  std::uint64_t number() const { return facts_.chunk_offsets.size(); }
  /// Notes a chunk whose messages cannot be read.
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
