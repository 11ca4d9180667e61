#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/mcap/record_probe.h"
#include "core/mcap/record_stepper.h"
#include "recorder/doctor/chunk_rules.h"
#include "recorder/doctor/doctor_facts.h"
#include "recorder/doctor/profile_rules.h"

namespace rocinante {

/// Walks the data section of a file record by record, skipping bytes that are not a record.
class DataWalk {
 public:
  DataWalk(ByteView file, DoctorReport& report, DoctorFacts& facts, Definitions& definitions)
      : file_(file),
        report_(report),
        facts_(facts),
        definitions_(definitions),
        steps_(file, mcap::magic().size()),
        probe_(file) {}

  /// Returns the offset of the summary, after DataEnd. Empty when the file ends earlier, which is a
  /// breach. `progress` is called with the bytes done.
  std::optional<std::uint64_t> run(const std::function<void(std::uint64_t)>& progress);

 private:
  void begin();
  void record(const mcap::Record& record);
  void attachment(const mcap::Record& record);
  void metadata(const mcap::Record& record);
  void dataEnd(const mcap::Record& record);
  bool skipBroken();
  bool endsAsAWholeFile() const;
  std::string cutOff() const;

  ByteView file_;
  DoctorReport& report_;
  DoctorFacts& facts_;
  Definitions& definitions_;
  mcap::RecordStepper steps_;
  RecordProbe probe_;
  std::optional<ProfileRules> profile_;
  std::optional<ChunkRules> chunks_;
  std::uint64_t last_offset_ = 0;  ///< of the previous record
  std::optional<std::uint64_t> summary_start_;
};

}  // namespace rocinante
