#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/log/log_types.h"
#include "core/log/octets_before.h"
#include "core/mcap/records.h"
#include "core/packet/session_state.h"
#include "core/session/keyframe.h"
#include "core/session/message_folder.h"
#include "recorder/doctor/doctor_report.h"

namespace rocinante {

/// Checks the rules of the profile `rocinante` (docs/log-format.md) on the records of a data
/// section, given in file order.
class ProfileRules {
 public:
  explicit ProfileRules(DoctorReport& report) : report_(report) {}

  void channel(const mcap::Channel& channel, std::uint64_t offset);
  void message(const mcap::Message& message, std::uint64_t offset);
  void metadata(const mcap::Metadata& metadata, std::uint64_t offset);
  /// Messages are missing here, so the session's state is no longer known.
  void gap() {
    fold_known_ = false;
    after_gap_ = true;
  }
  /// The data section ends at `offset`; its last record is at `last_offset`.
  void end(std::uint64_t offset, std::uint64_t last_offset);

 private:
  struct Known {
    LogChannel channel;
    Decoder* decoder = nullptr;  ///< see MessageFolder::decoderOf()
  };

  void session(const mcap::Metadata& metadata, std::uint64_t offset);
  void closing(const mcap::Metadata& metadata, std::uint64_t offset);
  void captured(const Known& known, const mcap::Message& message, std::uint64_t offset);
  void fold(const Known& known, const mcap::Message& message, std::uint64_t offset);
  void keyframe(const mcap::Message& message, std::uint64_t offset);
  void octets(const Known& known, const mcap::Message& message, std::uint64_t offset);
  void own(const Known& known, const mcap::Message& message, std::uint64_t offset);

  DoctorReport& report_;
  std::map<std::uint16_t, Known> channels_;
  MessageFolder folder_;

  std::optional<std::map<std::string, std::string>> session_;
  std::optional<std::uint64_t> end_offset_;
  bool any_captured_ = false;
  std::uint64_t last_time_ = 0;
  std::uint64_t last_other_time_ = 0;  ///< of messages other than keyframes

  OctetsBefore octets_before_;

  SessionState state_;
  KeyframeReader keyframe_reader_;
  bool after_gap_ = false;  ///< the octets of the next message may be missing
  bool fold_known_ = true;
  bool fold_ordered_ = true;
  std::optional<std::uint64_t> last_folded_time_;
  std::optional<std::uint16_t> keyframe_channel_;
};

}  // namespace rocinante
