#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "core/mcap/records.h"
#include "core/mcap/stream_reader.h"
#include "recorder/doctor/doctor_report.h"

namespace rocinante {

/// What the data section of a file holds, for the summary to be held against it.
struct DoctorFacts {
  bool ours = false;                                ///< of the profile `rocinante`
  bool all_read = true;                             ///< false: messages are missing in the counts
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

/// Schemas and channels of the whole file, each id with one meaning.
class Definitions {
 public:
  explicit Definitions(DoctorReport& report) : report_(report) {}

  /// Reads the record, says what is wrong with it, keeps what it defines. Empty when it cannot be
  /// read.
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
  /// By what they say, so that a file of very long definitions takes no memory.
  std::map<std::uint16_t, Digest> channels_;
  std::map<std::uint16_t, Digest> schemas_;
  Bytes scratch_;
};

/// Says where a text is no UTF-8.
void checkText(DoctorReport& report, std::uint64_t offset, std::string_view text);
/// Says where a map of strings has one key twice; `content` from the map's length on.
void checkStringMap(DoctorReport& report, std::uint64_t offset, ByteView content);
/// The same for a map from channels to numbers.
void checkNumberMap(DoctorReport& report, std::uint64_t offset, ByteView content);

}  // namespace rocinante
