#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "viewer/ui/live/sending_source.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A place on a device's link or, without a device, in the world.
struct CarriedPoint {
  std::string device, link;
  Vec3 at{};  ///< metres, in that space
  bool operator==(const CarriedPoint&) const = default;
};

/// Tells other windows, as an ordinary source, where this one looks from, where it points, and what
/// was drawn and said in it: a `view` of the source's own name, `points`, `line`, `label` and
/// `event`. Only what changed is sent, at most 30 times a second, and restated for those who come
/// later. Main thread.
class Publisher {
 public:
  /// The drawing that is the pointer, and the one that names it.
  static constexpr std::string_view kPointer = "pointer";
  static constexpr std::string_view kPointerName = "pointer-name";

  /// As SendingSource::open().
  static Result<Publisher> open(const Endpoint& to, const SendingSettings& settings);
  static Result<Publisher> into(std::unique_ptr<DatagramSink> sink,
                                const SendingSettings& settings);

  void look(const CameraView& view);
  /// Where the pointer is in the world; empty: nowhere.
  void point(const std::optional<Vec3>& at);
  /// Begins a line, or adds a corner to the last one begun.
  void addCorner(const Vec3& at, bool begins);
  void addLabel(const CarriedPoint& at, const std::string& text);
  /// Erases the lines and labels.
  void eraseDrawn();
  /// An event.
  void say(const std::string& text);
  /// Sends what is left to say, then takes back everything: others forget this window.
  void leave(SteadyTime now, WallTime wall);

  void tick(SteadyTime now, WallTime wall) { sending_.tick(now, wall); }
  void finish(SteadyTime now, WallTime wall) { sending_.finish(now, wall); }

  const Endpoint& endpoint() const { return sending_.endpoint(); }
  const std::string& name() const { return sending_.name(); }
  std::uint64_t sent() const { return sending_.sent(); }
  const std::string& trouble() const { return sending_.trouble(); }
  /// Whether this datagram's SOURCE is this one's, of any run.
  bool isOwn(std::string_view source) const { return source == name(); }

  /// Lines and labels as a receiver has them, for a window that does not hear itself.
  struct Drawn {
    std::string id;
    Drawing drawing;
  };
  const std::vector<Drawn>& drawn() const { return drawn_; }
  /// Each source's own, 0xRRGGBBAA.
  std::uint32_t color() const { return rgba_; }

 private:
  explicit Publisher(SendingSource sending);

  SendingSource sending_;
  std::uint32_t rgba_ = 0;
  std::optional<CameraView> looks_;
  std::optional<Vec3> points_;
  std::vector<Vec3> corners_;  ///< of the last line
  std::vector<Drawn> drawn_;
  std::size_t next_number_ = 1;
};

}  // namespace rocinante
