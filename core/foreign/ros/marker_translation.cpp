#include <cmath>
#include <map>
#include <vector>

#include "core/base/plain_text.h"
#include "core/foreign/ros/names.h"
#include "core/foreign/ros/topic_translation.h"
#include "core/math/transform.h"
#include "core/packet/packet_limits.h"

namespace rocinante::ros {
namespace {

using Outcome = RosTranslator::Outcome;

/// Most markers of a topic that are remembered for erasing them.
constexpr std::size_t kMaxMarkers = limits::kDrawings;

bool allFinite(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

/// visualization_msgs/Marker and MarkerArray: lines, points and text become drawings.
class MarkerTranslation final : public TopicTranslation {
 public:
  MarkerTranslation(std::string_view topic, const DeviceFinder& devices, FrameTree& frames,
                    bool in_array)
      : TopicTranslation(topic, devices, frames), in_array_(in_array) {}

  Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime time,
                    Translated& out) override {
    const bool ros1 = layout == FieldCursor::Layout::ros1;
    // What the definition was when the bag was made is seen by what fits.
    if (!readAll(message, layout, textured_ && !ros1)) {
      if (ros1 || !readAll(message, layout, !textured_)) return Outcome::malformed;
      textured_ = !textured_;
    }
    begin(markers_.empty() ? 0 : markers_.front().header.stamp_ns);
    eraseExpired(time);
    for (const Marker& marker : markers_) take(marker, time);
    return end(out);
  }

  void addLeftOut(Account& account) const override {
    addValues(account, "scale", "drawings have sizes in pixels", sizes_);
  }

 private:
  struct Drawn {
    std::size_t parts = 0;  ///< drawings ID, ID/2, ID/3 ...
    LogTime until = LogTime::max();
  };

  bool readAll(ByteView message, FieldCursor::Layout layout, bool textured) {
    FieldCursor cursor(message, layout);
    const std::uint32_t count = in_array_ ? cursor.count(kLeastMarkerBytes) : 1;
    markers_.resize(count);
    for (Marker& marker : markers_) {
      if (!cursor.ok()) break;
      readMarker(cursor, textured, marker);
    }
    return cursor.atEnd();
  }

  static std::string idOf(const Marker& marker) {
    std::string id(marker.space);
    if (!id.empty()) id += '/';
    return id + std::to_string(marker.id);
  }

  static std::string partId(const std::string& id, std::size_t part) {
    return part == 0 ? id : id + "/" + std::to_string(part + 1);
  }

  void take(const Marker& marker, LogTime time) {
    if (marker.action == Marker::erase_all) {
      Statement erase;
      erase.kind = StatementKind::erase;
      add(erase);
      drawn_.clear();
      mortal_ = 0;
      return;
    }
    const std::string id = idOf(marker);
    // Room for the numbers of its parts.
    if (id.size() > limits::kNameBytes - 12 || !isName(id)) return note("markers with a bad name");
    if (marker.action == Marker::erase) return eraseFrom(id, 0);
    if (marker.action != Marker::add) return note("markers with an unknown action");
    if (!isUsable(marker.pose, "markers")) return;
    const std::optional<FrameTree::Place> place =
        frames_.placeIn(marker.header.frame, marker.pose, {});
    if (!place) return note("markers in a frame without a place", marker.header.frame);
    if (!drawn_.contains(id) && drawn_.size() >= kMaxMarkers) {
      return note("markers beyond 65536 of a topic");
    }
    const std::size_t parts = draw(marker, id, *place);
    eraseFrom(id, parts);
    if (parts == 0) return;
    if (marker.has_size) ++sizes_;
    Drawn& drawn = drawn_[id];
    drawn.parts = parts;
    drawn.until = marker.lifetime_ns > 0 && marker.lifetime_ns < (LogTime::max() - time).count()
                      ? time + Nanoseconds(marker.lifetime_ns)
                      : LogTime::max();
    if (drawn.until != LogTime::max()) ++mortal_;
  }

  /// How many drawings it became.
  std::size_t draw(const Marker& marker, const std::string& id, const FrameTree::Place& place) {
    const Mat4 to_place = matrixOf(place.pose);
    switch (marker.type) {
      case Marker::line_strip:
        return drawPart(StatementKind::line, id, marker, place,
                        pointsOf(marker, to_place, 0, marker.points_m.size()))
                   ? 1
                   : 0;
      case Marker::points:
        return drawPart(StatementKind::points, id, marker, place,
                        pointsOf(marker, to_place, 0, marker.points_m.size()))
                   ? 1
                   : 0;
      case Marker::line_list:
        return drawSegments(marker, id, place, to_place);
      case Marker::text:
        return drawLabel(marker, id, place, to_place) ? 1 : 0;
      default:
        note("markers other than lines, points and text");
        return 0;
    }
  }

  /// Every second point begins a segment; segments that touch become one line.
  std::size_t drawSegments(const Marker& marker, const std::string& id,
                           const FrameTree::Place& place, const Mat4& to_place) {
    const std::vector<Vec3>& points = marker.points_m;
    std::size_t parts = 0;
    for (std::size_t i = 0; i + 1 < points.size();) {
      std::vector<double> numbers = pointsOf(marker, to_place, i, i + 2);
      std::size_t last = i + 1;
      while (last + 2 < points.size() && points[last + 1] == points[last]) {
        const std::vector<double> next = pointsOf(marker, to_place, last + 2, last + 3);
        numbers.insert(numbers.end(), next.begin(), next.end());
        last += 2;
      }
      i = last + 1;
      if (parts >= limits::kDrawings) break;
      if (drawPart(StatementKind::line, partId(id, parts), marker, place, numbers)) ++parts;
    }
    return parts;
  }

  static std::vector<double> pointsOf(const Marker& marker, const Mat4& to_place, std::size_t from,
                                      std::size_t to) {
    std::vector<double> numbers;
    numbers.reserve(3 * (to - from));
    for (std::size_t i = from; i < to; ++i) {
      const Vec3 point = transformPoint(to_place, marker.points_m[i]);
      numbers.insert(numbers.end(), {point.x, point.y, point.z});
    }
    return numbers;
  }

  bool drawPart(StatementKind kind, const std::string& id, const Marker& marker,
                const FrameTree::Place& place, const std::vector<double>& numbers) {
    if (numbers.empty()) return false;
    if (!allFinite(numbers)) {
      note("markers with points that are not finite");
      return false;
    }
    if (marker.many_colors) note("markers of several colours, drawn in the first");
    Statement statement;
    statement.kind = kind;
    statement.name = id;
    statement.rgba = marker.rgba;
    statement.carrier = {place.device, place.link, false};
    statement.numbers = numbers;
    add(statement);
    return true;
  }

  bool drawLabel(const Marker& marker, const std::string& id, const FrameTree::Place& place,
                 const Mat4& to_place) {
    const Vec3 at = positionOf(to_place);
    const double numbers[] = {at.x, at.y, at.z};
    if (marker.label.size() > limits::kStringBytes || !isUtf8(bytesOf(marker.label))) {
      note("markers with a text over 4096 bytes or not UTF-8");
      return false;
    }
    Statement statement;
    statement.kind = StatementKind::label;
    statement.name = id;
    statement.carrier = {place.device, place.link, false};
    statement.numbers = numbers;
    statement.text = marker.label;
    add(statement);
    return true;
  }

  /// Erases the drawings of a marker from number `kept` on.
  void eraseFrom(const std::string& id, std::size_t kept) {
    const auto found = drawn_.find(id);
    if (found == drawn_.end()) return;
    if (found->second.until != LogTime::max()) --mortal_;
    for (std::size_t part = kept; part < found->second.parts; ++part) {
      const std::string name = partId(id, part);
      Statement erase;
      erase.kind = StatementKind::erase;
      erase.name = name;
      add(erase);
    }
    drawn_.erase(found);
  }

  void eraseExpired(LogTime time) {
    if (mortal_ == 0) return;
    std::vector<std::string> expired;
    for (const auto& [id, drawn] : drawn_) {
      if (drawn.until <= time) expired.push_back(id);
    }
    for (const std::string& id : expired) eraseFrom(id, 0);
  }

  bool in_array_;
  bool textured_ = true;
  std::vector<Marker> markers_;
  std::map<std::string, Drawn> drawn_;
  std::uint64_t sizes_ = 0;
  std::size_t mortal_ = 0;  ///< of `drawn_`: those with a lifetime
};

}  // namespace

std::unique_ptr<TopicTranslation> makeMarkerTranslation(std::string_view topic,
                                                        const DeviceFinder& devices,
                                                        FrameTree& frames, bool in_array) {
  return std::make_unique<MarkerTranslation>(topic, devices, frames, in_array);
}

}  // namespace rocinante::ros
