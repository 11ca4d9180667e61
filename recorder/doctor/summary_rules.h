#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/mcap/record_stepper.h"
#include "recorder/doctor/doctor_facts.h"

namespace rocinante {

/// Checks everything after DataEnd against the data section.
class SummaryRules {
 public:
  SummaryRules(ByteView file, DoctorReport& report, const DoctorFacts& facts,
               Definitions& definitions)
      : file_(file), report_(report), facts_(facts), definitions_(definitions) {}

  /// `start` is the offset after DataEnd.
  void run(std::uint64_t start);

 private:
  /// Consecutive records of one kind.
  struct Group {
    mcap::Opcode opcode = mcap::Opcode::invalid;
    std::uint64_t start = 0;
    std::uint64_t end = 0;
    bool pointed_at = false;
  };

  void record(const mcap::Record& record);
  void place(const mcap::Record& record);
  void chunkIndex(const mcap::Record& record);
  void compareWithChunk(const mcap::ChunkIndex& index, const mcap::Record& record);
  void attachmentIndex(const mcap::Record& record);
  void metadataIndex(const mcap::Record& record);
  void statistics(const mcap::Record& record);
  void summaryOffset(const mcap::Record& record);
  void footer(const mcap::Record& record);
  void complete(std::uint64_t offset);
  void compareStatistics();
  /// Marks the record at `pointed` as indexed. False, with a breach, when it is not in `offsets` or
  /// was indexed before.
  bool point(const std::vector<std::uint64_t>& offsets, std::vector<bool>& seen,
             std::uint64_t pointed, std::uint64_t offset, std::string_view rule);
  void missing(const std::vector<std::uint64_t>& offsets, const std::vector<bool>& seen,
               bool required, std::string_view rule, std::string_view what);

  ByteView file_;
  DoctorReport& report_;
  const DoctorFacts& facts_;
  Definitions& definitions_;

  std::uint64_t start_ = 0;
  std::vector<Group> groups_;
  std::optional<mcap::Record> statistics_;
  std::vector<bool> chunks_seen_;
  std::vector<bool> attachments_seen_;
  std::vector<bool> metadata_seen_;
  std::set<std::uint16_t> channels_repeated_;
  bool any_chunk_index_ = false;
  bool any_attachment_index_ = false;
  bool any_metadata_index_ = false;
  bool any_channel_ = false;
};

}  // namespace rocinante
