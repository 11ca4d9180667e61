#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/datagram_sink.h"
#include "viewer/view/hand_joints.h"

namespace rocinante {

/// How a window that drives devices names itself as a source.
struct DriveSettings {
  std::string source = "hand";  ///< SOURCE
  std::string run;              ///< RUN; empty: a random one
};

/// Sends the joints that the hand has moved, and no other, as a source of its own: `joint DEVICE
/// NAME=q`, so that a datagram alone says which joint it moves (docs/decisions/036). Values may be
/// set as often as a mouse moves; at most 30 datagrams a second leave, and everything is restated
/// every two seconds. Ends without a word when it is destroyed. Main thread.
class HandDrive {
 public:
  /// Fails as openSink() does; bad_argument for an invalid SOURCE.
  static Result<HandDrive> open(const Endpoint& to, const DriveSettings& settings);
  /// The same into a sink that is already open.
  static Result<HandDrive> into(std::unique_ptr<DatagramSink> sink, const DriveSettings& settings);

  /// A finite value of a joint, to be sent when it is due. trouble() names one that no packet can
  /// hold.
  void set(const std::string& device, const std::string& joint, double value);
  /// The hand lets go: nothing is sent of them any more, and receivers forget what was. Unknown
  /// ones are ignored.
  void release(const std::string& device, const std::string& joint);
  void release(const std::string& device);
  void releaseAll();

  /// Sends what is due at `now`; `wall` becomes TIME. To be called at least ten times a second.
  void tick(SteadyTime now, WallTime wall);

  const Endpoint& endpoint() const { return sink_->endpoint(); }
  const std::string& source() const { return settings_.source; }
  std::uint64_t sent() const { return sequence_; }
  /// What is sent.
  const JointsByDevice& joints() const { return joints_; }
  /// Why the last datagram was not sent, or values were refused; empty when all is well.
  const std::string& trouble() const { return trouble_; }

 private:
  HandDrive(std::unique_ptr<DatagramSink> sink, DriveSettings settings)
      : sink_(std::move(sink)), settings_(std::move(settings)) {}

  void sendChanged(WallTime wall);
  void restateAll(WallTime wall);
  void send(const std::string& text);

  std::unique_ptr<DatagramSink> sink_;
  DriveSettings settings_;
  JointsByDevice joints_;
  std::set<std::string> changed_;  ///< devices
  bool released_ = false;          ///< something since the last restatement
  std::uint64_t sequence_ = 0, restatements_ = 0;
  std::optional<SteadyTime> sent_at_, restated_at_;
  std::string trouble_;
};

}  // namespace rocinante
