#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/foreign/session/joint_values.h"
#include "core/foreign/session/known_signals.h"
#include "core/foreign/session/link_frames.h"
#include "core/foreign/session/message_sink.h"
#include "core/packet/session_state.h"
#include "core/report/account.h"

namespace rocinante {

enum class EventLevel : std::uint8_t { info, warning, error };

/// A signal at a moment; borrowed for the call.
struct StatedSignal {
  std::string_view name;
  const SignalValue* value = nullptr;
  bool is_new = false;     ///< said since the last call
  bool in_joints = false;  ///< joints() has it as a speed or an effort
};

/// What a link shows, in its own space: a .glb.
struct LinkShape {
  std::string frame;  ///< of the link
  std::shared_ptr<const Bytes> glb;
};

/// How a family of tools writes what a session holds: which messages on which topics. All of a
/// device, or of a source's drawings, is in each message, so that a reader who jumps to a moment
/// needs only the last message of every topic; but signals, which may be thousands.
class SessionFormat {
 public:
  virtual ~SessionFormat() = default;

  /// MCAP's profile of the file.
  virtual std::string profile() const = 0;
  /// How long readers remember a space that is not said again; 0: for good.
  virtual Nanoseconds framesLast() const = 0;

  virtual Status frames(MessageSink& out, LogTime time, const std::string& device,
                        std::span<const FramePose> frames) = 0;
  virtual Status joints(MessageSink& out, LogTime time, const std::string& device,
                        std::span<const NamedValue> values) = 0;
  /// All drawings of a source, by id; none when it has erased them.
  using Drawings = std::vector<std::pair<std::string, const Drawing*>>;
  virtual Status drawings(MessageSink& out, LogTime time, const std::string& source,
                          const Drawings& drawings) = 0;
  /// Signals of a device, a link or none, when one of them was said or went away, by name.
  /// `all_requested`: all of the owner, as a message of the new ones alone would mislead, since
  /// they are the first or another one has gone. Else the new ones at least, and others only by
  /// chance (all with requestsAllSignals()).
  virtual Status signals(MessageSink&, LogTime, const SignalOwner&, std::span<const StatedSignal>,
                         bool /*all_requested*/) {
    return {};
  }
  /// Whether signals() is called with all of an owner each time. Takes time by their number for
  /// each packet.
  virtual bool requestsAllSignals() const { return false; }
  /// Before the first message, and again when there are more: false for a format that has no place
  /// for signals.
  virtual bool knowSignals(const KnownSignals&) { return false; }
  /// What of the written messages their reader cannot see.
  virtual void addLeftOut(Account&) const {}
  virtual Status event(MessageSink& out, LogTime time, EventLevel level, std::string_view name,
                       std::string_view text) = 0;
  /// All that a device shows, when that changes; nothing where the format has no place for it.
  virtual Status shapes(MessageSink&, LogTime, const std::string& /*device*/,
                        std::span<const LinkShape>) {
    return {};
  }
  /// The URDF of a device, once.
  virtual Status description(MessageSink& out, LogTime time, const std::string& device,
                             std::string_view urdf) = 0;
};

/// PREFIX/NAME.
std::string topicOf(std::string_view prefix, std::string_view name);

/// The runs of points of a line that are connected; every point of a cloud: x y z ..., metres. A
/// missing part ends a run.
std::vector<std::vector<double>> connectedRuns(const Drawing& drawing);

}  // namespace rocinante
