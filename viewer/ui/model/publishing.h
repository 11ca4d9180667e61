#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/ui/live/publisher.h"
#include "viewer/ui/model/selection.h"

namespace rocinante {

/// What a person shows others who look at the same cell in windows of their own. Main thread.
class Publishing {
 public:
  /// Begins, in place of what was published before. bad_argument for an endpoint or a name that
  /// there cannot be.
  Status begin(const std::string& endpoint, const std::string& name, SteadyTime now, WallTime wall);
  /// The same into a sink that is already open.
  Status begin(std::unique_ptr<DatagramSink> sink, const SendingSettings& settings);
  void end(SteadyTime now, WallTime wall);
  /// Null while nothing is published.
  const Publisher* active() const { return publisher_ ? &*publisher_ : nullptr; }

  /// The mouse is a pointer for others, too.
  bool points() const { return publisher_.has_value() && pointer_wanted_; }
  void setPointer(bool wanted);
  void point(const std::optional<Vec3>& at);

  /// Clicks become corners of a line, until endClicks().
  void beginLine();
  /// The next click is the place of this text.
  void beginLabel(std::string text);
  void endClicks();
  bool takesClicks() const { return drawing_ != Drawing::nothing; }
  bool drawsLine() const { return drawing_ == Drawing::line; }
  const std::string& label() const { return label_; }
  /// A click on a surface, in the world, while clicks are taken. A label stays on the link.
  void clicked(const PosedScene& scene, const Selection& link, const Vec3& at);

  void eraseDrawn();
  void say(const std::string& text);

  /// Sends what is due. `view`: from where the window looks; empty: nothing is said of it.
  void sendDue(const std::optional<CameraView>& view, SteadyTime now, WallTime wall);
  /// Something changed since the last call.
  bool takeChanged() { return std::exchange(changed_, false); }
  /// Makes the scene what this window shows of it: without its own pointer and viewpoint, which it
  /// may hear, and with what was drawn here, unless it is heard. Stays valid until the next call.
  void addTo(PosedScene& scene);

  std::array<char, 128> endpoint_text{};  ///< being typed; NUL-terminated
  std::array<char, 64> name_text{};       ///< the same
  std::array<char, 256> message_text{};   ///< the same
  std::string trouble;                    ///< why publishing did not begin; a sentence

 private:
  enum class Drawing { nothing, line, label };

  std::optional<Publisher> publisher_;
  bool pointer_wanted_ = true;
  Drawing drawing_ = Drawing::nothing;
  bool line_begun_ = false;
  std::string label_;
  bool changed_ = false;
  std::vector<Publisher::Drawn> shown_;  // the scene borrows from it
};

}  // namespace rocinante
