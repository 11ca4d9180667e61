#include "viewer/ui/model/publishing.h"

#include <algorithm>

#include "core/math/transform.h"

namespace rocinante {

Status Publishing::begin(const std::string& endpoint, const std::string& name, SteadyTime now,
                         WallTime wall) {
  const auto to = Endpoint::parse(endpoint);
  if (!to) return to.error();
  if (name.empty()) {
    return Error{ErrorKind::bad_argument, "others need a name for this window", {}};
  }
  auto opened = Publisher::open(*to, {name, {}});
  if (!opened) return opened.error();
  end(now, wall);
  publisher_.emplace(std::move(*opened));
  changed_ = true;
  return {};
}

Status Publishing::begin(std::unique_ptr<DatagramSink> sink, const SendingSettings& settings) {
  auto opened = Publisher::into(std::move(sink), settings);
  if (!opened) return opened.error();
  publisher_.emplace(std::move(*opened));
  changed_ = true;
  return {};
}

void Publishing::end(SteadyTime now, WallTime wall) {
  endClicks();
  if (!publisher_) return;
  publisher_->leave(now, wall);
  publisher_.reset();
  changed_ = true;
}

void Publishing::setPointer(bool wanted) {
  pointer_wanted_ = wanted;
  if (!wanted) point(std::nullopt);
}

void Publishing::point(const std::optional<Vec3>& at) {
  if (publisher_) publisher_->point(at);
}

void Publishing::beginLine() {
  drawing_ = Drawing::line;
  line_begun_ = false;
}

void Publishing::beginLabel(std::string text) {
  drawing_ = Drawing::label;
  label_ = std::move(text);
}

void Publishing::endClicks() {
  drawing_ = Drawing::nothing;
  label_.clear();
}

void Publishing::clicked(const PosedScene& scene, const Selection& link, const Vec3& at) {
  if (!publisher_ || !takesClicks()) return;
  changed_ = true;
  if (drawing_ == Drawing::line) {
    publisher_->addCorner(at, !std::exchange(line_begun_, true));
    return;
  }
  CarriedPoint place{{}, {}, at};
  // Packets carry by a link, never by a device alone.
  if (const auto space =
          link.link.empty() ? std::optional<Mat4>() : scene.find(link.device, link.link)) {
    place = {link.device, link.link, transformPoint(inverseOfRigid(*space), at)};
  }
  publisher_->addLabel(place, label_);
  endClicks();
}

void Publishing::eraseDrawn() {
  endClicks();
  if (!publisher_) return;
  publisher_->eraseDrawn();
  changed_ = true;
}

void Publishing::say(const std::string& text) {
  if (publisher_) publisher_->say(text);
}

void Publishing::sendDue(const std::optional<CameraView>& view, SteadyTime now, WallTime wall) {
  if (!publisher_) return;
  if (view) publisher_->look(*view);
  publisher_->tick(now, wall);
}

void Publishing::addTo(PosedScene& scene) {
  if (!publisher_) return;
  const std::string& own = publisher_->name();
  std::erase_if(scene.cameras,
                [&](const PosedCamera& camera) { return camera.of_session && camera.name == own; });
  std::erase_if(scene.drawings, [&](const PosedDrawing& drawing) {
    return drawing.source == own &&
           (drawing.id == Publisher::kPointer || drawing.id == Publisher::kPointerName);
  });
  const auto heard = std::ranges::find(scene.drawings, own, &PosedDrawing::source);
  if (heard != scene.drawings.end()) return;
  shown_ = publisher_->drawn();
  for (const Publisher::Drawn& drawn : shown_) {
    const Path& carrier = drawn.drawing.carrier;
    std::optional<Mat4> space(Mat4(1.0));
    if (!carrier.first.empty()) space = scene.find(carrier.first, carrier.second);
    if (space) scene.drawings.push_back({own, drawn.id, &drawn.drawing, *space});
  }
}

}  // namespace rocinante
