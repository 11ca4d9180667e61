#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/behaviour/fact_recorder.h"
#include "core/behaviour/link_tracks.h"
#include "core/behaviour/number_recorder.h"
#include "core/behaviour/session_track.h"
#include "core/behaviour/unfit_values.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Makes a track of a session's packets, one after another.
class TrackRecorder {
 public:
  /// Borrows both; `track` has its times. `links` as in trackSession().
  TrackRecorder(const Cell& cell, SessionTrack& track, const std::vector<std::string>& links);

  /// What was stated before the first packet.
  void begin(SessionState state);
  /// The next packet in log order.
  void add(LogTime time, const Packet& packet);
  /// Gives the track its samples.
  Status finish();

  /// What noting facts has cost so far, in items and facts that were looked at.
  std::uint64_t factsLooked() const { return facts_.looked(); }

 private:
  /// Rows of a series that are not in the store yet, one after another.
  struct Pending {
    std::vector<double> numbers;
    std::size_t rows = 0;
  };
  /// A value by name, where the model puts it.
  struct NamedValue {
    std::string name;
    std::optional<std::size_t> column;
  };
  struct Recording {
    std::string name;
    const Model* model = nullptr;
    DeviceTrack* track = nullptr;
    Pending pending[2];  ///< by series
    std::size_t joint_columns = 0;
    std::vector<NamedValue> named;
    std::vector<bool> stated_values;  ///< by column: some packet states it
    bool is_pose_stated = false;
    bool has_mimics = false;
    bool has_its_model = false;  ///< packets do not say that it is another one
    std::optional<LinkPlacer> links;
    bool is_stated = false;
    Path carrier;
    // Of the packet that is being folded:
    bool is_touched = false, says_presence = false, says_joints = false, says_pose = false,
         says_all_joints = false;
    std::vector<std::string_view> says_values;
  };

  Recording& recording(const std::string& name, const Model* model);
  const Model* modelOf(std::string_view name) const;
  Recording* touched(std::string_view name);
  void addDevice(const std::string& name, LogTime time);
  void read(const Statement& statement);
  void keep(Recording& device, LogTime time, bool is_restated);
  void addJoints(Recording& device, const DeviceState* state, LogTime time);
  void addPose(Recording& device, const DeviceState* state, LogTime time);
  bool takesJoints(Recording& device, const DeviceState& state);
  void namedValues(Recording& device, const DeviceState& state, double* row);
  void leaveOutUnstated(const Recording& device, double* row) const;
  double* nextRow(Recording& device, std::size_t series, LogTime time);
  void store(Recording& device, std::size_t series);
  void keepStated(Recording& device) const;
  void sayFact() { says_facts_ = looks_everywhere_ = true; }
  void noteFacts(LogTime time);

  const Cell& cell_;
  SessionTrack& track_;
  const std::vector<std::string>& links_;
  SessionState state_;
  UnfitValues::CountsBySource counts_before_;  ///< before the first packet
  std::map<std::string, Recording, std::less<>> recordings_;
  std::vector<Recording*> touched_;
  Recording* last_touched_ = nullptr;
  std::vector<std::string> new_names_;
  FactRecorder facts_{track_.facts};
  SampleStore store_;
  NumberRecorder numbers_{track_.numbers, track_.rhythms, store_};
  UnfitValues unfit_{track_};
  std::vector<double> block_;
  bool says_facts_ = false;
  std::optional<LogTime> facts_due_;  ///< when something was stated that is not noted yet
  bool facts_are_restated_ = false;   ///< all of what is due was
  bool looks_everywhere_ = true;      ///< something that is no signal may state another fact
};

}  // namespace rocinante
