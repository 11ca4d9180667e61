#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "core/mcap/record_stepper.h"
#include "core/mcap/records.h"
#include "recorder/doctor/doctor_report.h"

namespace rocinante {

/// Contents of a file's data section, to compare the summary with.
struct DoctorFacts {
  bool ours = false;                                ///< the profile is `rocinante`
  bool all_read = true;                             ///< false: the counts lack messages
  std::vector<std::uint64_t> chunk_offsets;         ///< ascending
  std::vector<std::uint64_t> attachment_offsets;    ///< ascending
  std::vector<std::uint64_t> metadata_offsets;      ///< ascending
  std::map<std::uint16_t, std::uint64_t> messages;  ///< by channel
  std::uint64_t message_count = 0;
  std::uint64_t loose_messages = 0;
  std::uint64_t first_loose_offset = 0;
  std::uint64_t start_time = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t end_time = 0;
};

/// Schemas and channels of the whole file. An id must not change its meaning.
class Definitions {
 public:
  explicit Definitions(DoctorReport& report) : report_(report) {}

  /// Reads and checks the record, and keeps its definition. Empty when it cannot be read.
  std::optional<mcap::Channel> addChannel(const mcap::Record& record, std::uint64_t offset);
  bool addSchema(const mcap::Record& record, std::uint64_t offset);

  bool hasChannel(std::uint16_t id) const { return channels_.contains(id); }
  std::size_t channels() const { return channels_.size(); }
  std::size_t schemas() const { return schemas_.size(); }
  bool hasSchema(std::uint16_t id) const { return schemas_.contains(id); }

 private:
  using Digest = std::array<std::byte, 16>;
  template <class T>
  bool define(std::map<std::uint16_t, Digest>& known, std::uint16_t id, const T& definition);

  DoctorReport& report_;
  /// Digests of the definitions, so that very long ones take no memory.
  std::map<std::uint16_t, Digest> channels_;
  std::map<std::uint16_t, Digest> schemas_;
  Bytes scratch_;
};

/// Reports text that is not UTF-8.
void checkText(DoctorReport& report, std::uint64_t offset, std::string_view text);
/// Reports duplicate keys in a map of strings; `content` begins with the map's length.
void checkStringMap(DoctorReport& report, std::uint64_t offset, ByteView content);
/// The same for a map from channels to numbers.
void checkNumberMap(DoctorReport& report, std::uint64_t offset, ByteView content);

}  // namespace rocinante
