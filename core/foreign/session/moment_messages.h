#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/scene_pose_cache.h"
#include "core/foreign/session/session_format.h"
#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Writes what a session says from one moment to the next as the messages of a format: spaces and
/// joints of a device when they are written or it moves, signals when they are said, the drawings
/// of a source when they change. Borrows cell and format. One thread.
class MomentMessages {
 public:
  /// Without a cell (null) there are no links, and only joints that packets name.
  MomentMessages(const Cell* cell, SessionFormat& format);

  /// Sees what each moment shows; only with a cell. Empty: nobody looks.
  std::function<Status(LogTime, const PosedScene&)> shown;

  /// What an applied packet may have changed besides devices.
  void notice(const Packet& packet);
  /// The state at `time`, which is later than the last call's, and after all packets so far.
  Status moment(MessageSink& out, LogTime time, const SessionState& state);

  /// Devices on links that no cell places.
  const std::set<std::string>& carried() const { return carried_; }

 private:
  /// What was said of a device last.
  struct Known {
    std::vector<Mat4> links;  ///< in the world; the first is the device's own
    LogTime frames_written = LogTime::min();
    bool joints_written = false;
    std::set<std::string, std::less<>> in_joints;  ///< signals that joints have
  };
  /// The signals of an owner as they were written last.
  struct StatedSignals {
    std::uint64_t newest = 0;  ///< packet
    std::map<std::string, Item<SignalValue>, std::less<>> by_name;

    /// Whether it was said since it was taken last, or has changed.
    bool take(const std::string& name, const Item<SignalValue>& item, bool counts_anew);
  };
  /// The drawings of a source as they were written last.
  struct Drawn {
    std::string run;
    std::vector<std::pair<std::string, Drawing>> drawings;
  };

  void forgetGone(const SessionState& state);
  bool isWritten(const DeviceState& device) const { return device.last_write > before_; }
  bool framesDue(Known& known, std::vector<Mat4> now, bool is_written, LogTime time) const;
  Status cellFrames(MessageSink& out, LogTime time, const SessionState& state);
  Status bareFrames(MessageSink& out, LogTime time, const SessionState& state);
  Status joints(MessageSink& out, LogTime time, const SessionState& state);
  Status signals(MessageSink& out, LogTime time, const SessionState& state);
  Status signalsOf(MessageSink& out, LogTime time, const std::string& device,
                   const Signals& signals);
  void noticeSignals(const Statement& statement);
  /// No other signal came, changed or went since the last moment than noticed ones.
  bool areNoticed(const SessionState& state) const;
  Status noticedSignals(MessageSink& out, LogTime time, const SessionState& state);
  bool isInJoints(const SignalOwner& owner, std::string_view name) const;
  Status drawings(MessageSink& out, LogTime time, const SessionState& state);

  const Cell* cell_;
  SessionFormat& format_;
  std::optional<ScenePoseCache> poses_;
  std::map<std::string, Known, std::less<>> known_;
  std::map<std::string, const Model*, std::less<>> models_;
  std::map<SignalOwner, StatedSignals> stated_signals_;
  std::size_t stated_count_ = 0;  ///< signals in stated_signals_
  /// Of packets since the last moment.
  std::map<SignalOwner, std::set<std::string, std::less<>>> noticed_;
  std::size_t noticed_count_ = 0;  ///< names in noticed_, at most limits::kSignals
  bool all_noticed_ = false;       ///< they were more
  std::uint64_t packets_ = 0;      ///< noticed since the last moment
  bool is_bare_stated_ = true;     ///< signals of no device may have changed
  std::size_t bare_signals_ = 0;   ///< how many there were at the last moment
  std::uint64_t applied_ = 0;      ///< packets, as of the last moment
  std::set<std::string> drawn_;    ///< sources whose drawings may have changed
  bool all_drawn_ = false;
  bool has_begun_ = false;
  LogTime before_ = LogTime::min();                 ///< the last moment
  std::map<std::string, Drawn, std::less<>> kept_;  ///< by source
  std::set<std::string> carried_;
};

}  // namespace rocinante
