#include "core/source/source.h"

#include <array>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

// Every byte is the C header's; only this file sees its functions.
#define RK_SOURCE_STATIC
#define RK_SOURCE_IMPLEMENTATION
#include "core/source/rocinante/rocinante_source.h"

namespace rocinante {
namespace {

SourceResult resultOf(int result) { return static_cast<SourceResult>(result); }

/// A string with a NUL behind it, as C wants it; null when it is longer than `most_bytes` or has a
/// NUL inside, which no name or text may have.
template <std::size_t most_bytes>
class CText {
 public:
  explicit CText(std::string_view text) {
    if (text.size() > most_bytes || text.find('\0') != text.npos) return;
    text.copy(bytes_.data(), text.size());
    bytes_[text.size()] = '\0';
    is_valid_ = true;
  }
  const char* get() const { return is_valid_ ? bytes_.data() : nullptr; }
  /// The same, but a refused text is an empty name, which C refuses.
  const char* name() const { return is_valid_ ? bytes_.data() : ""; }

 private:
  std::array<char, most_bytes + 1> bytes_;
  bool is_valid_ = false;
};
using CName = CText<RK_NAME_BYTES>;
using CString = CText<RK_STRING_BYTES>;

/// A path in C's form.
class CPath {
 public:
  explicit CPath(const PathView& path) : first_(path.first), second_(path.second) {
    if (path.is_layer) {
      path_.layer = second_.name();
    } else if (!path.first.empty() || !path.second.empty()) {
      path_.device = first_.name();
      if (!path.second.empty()) path_.link = second_.name();
    }
  }
  CPath(const CPath&) = delete;
  CPath& operator=(const CPath&) = delete;
  operator rk_path() const { return path_; }

 private:
  CName first_, second_;
  rk_path path_ = rk_world();
};

static_assert(sizeof(Vec3) == 3 * sizeof(double));
const double* numbersOf(std::span<const Vec3> points) {
  return points.empty() ? nullptr : &points.front().x;
}

int sendDatagram(void* context, char* bytes, std::size_t size) {
  auto& send = *static_cast<Source::Send*>(context);
  return send(std::as_writable_bytes(std::span(bytes, size))) ? 0 : 1;
}

}  // namespace

std::string_view sentenceOf(SourceResult result) {
  return rk_result_text(static_cast<int>(result));
}

struct Source::State {
  std::unique_ptr<std::byte[]> memory;
  Send send;
  // The names of an order, each with a NUL; those that fit a datagram fit here.
  std::vector<char> names;
  std::vector<const char*> name_pointers;
  rk_source* source = nullptr;
};

Source::Source(std::unique_ptr<State> state) : state_(std::move(state)) {}
Source::Source(Source&&) noexcept = default;
Source& Source::operator=(Source&&) noexcept = default;
Source::~Source() = default;

Result<Source> Source::open(const SourceSettings& settings, Send send) {
  const CName source(settings.source);
  const CName run(settings.run);
  const std::size_t most_bytes = settings.max_datagram;
  auto state = std::make_unique<State>();
  state->memory = std::make_unique<std::byte[]>(settings.memory_bytes);
  state->send = std::move(send);
  state->names.reserve(2 * most_bytes);
  state->name_pointers.reserve(most_bytes);

  rk_source_config config{};
  config.source = source.name();
  config.run = settings.run.empty() ? nullptr : run.name();
  config.restate_ns = settings.restate.count();
  config.max_datagram = most_bytes;
  config.reserved_bytes = settings.reserved_bytes;
  config.send = sendDatagram;
  config.context = &state->send;
  int result = RK_OK;
  state->source = rk_source_open(state->memory.get(), settings.memory_bytes, &config, &result);
  if (state->source == nullptr) {
    const char* const sentence =
        result == RK_BAD_ARGUMENT
            ? "the largest datagram of a source leaves no room for a statement, or exceeds 65507"
            : rk_result_text(result);
    return Error{ErrorKind::bad_argument, sentence, std::string(settings.source)};
  }
  return Source(std::move(state));
}

SourceDevice Source::device(std::string_view name) {
  return {rk_source_device(state_->source, CName(name).name())};
}

SourceResult Source::add(SourceDevice device, std::string_view model,
                         std::optional<std::uint64_t> kinematics) {
  return resultOf(rk_source_add(state_->source, device.handle, CName(model).name(),
                                kinematics ? &*kinematics : nullptr));
}

SourceResult Source::remove(SourceDevice device) {
  return resultOf(rk_source_remove(state_->source, device.handle));
}

SourceResult Source::forget(SourceDevice device) {
  return resultOf(rk_source_forget(state_->source, device.handle));
}

SourceResult Source::setOrder(SourceDevice device, std::span<const std::string_view> joints) {
  std::vector<char>& names = state_->names;
  std::vector<const char*>& pointers = state_->name_pointers;
  names.clear();
  pointers.clear();
  for (const std::string_view joint : joints) {
    if (joint.find('\0') != joint.npos) return SourceResult::bad_name;
    const bool is_full = names.size() + joint.size() + 1 > names.capacity() ||
                         pointers.size() == pointers.capacity();
    if (is_full) return SourceResult::too_long;
    pointers.push_back(names.data() + names.size());
    names.insert(names.end(), joint.begin(), joint.end());
    names.push_back('\0');
  }
  return resultOf(rk_source_order(state_->source, device.handle, pointers.data(), pointers.size()));
}

SourceResult Source::setJoints(SourceDevice device, std::span<const double> values) {
  return resultOf(rk_source_joints(state_->source, device.handle, values.data(), values.size()));
}

SourceResult Source::setPose(SourceDevice device, const Pose& pose, PathView carrier) {
  const Vec3& at = pose.position;
  const Quat& turn = pose.orientation;
  const std::array<double, 7> numbers = {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w};
  return resultOf(rk_source_pose(state_->source, device.handle, numbers.data(), CPath(carrier)));
}

SourceResult Source::repeat(SourceDevice device) {
  return resultOf(rk_source_repeat(state_->source, device.handle));
}

SourceResult Source::setVisibility(PathView path, Visibility visibility) {
  return resultOf(rk_source_show(state_->source, CPath(path), static_cast<rk_shown>(visibility)));
}

SourceResult Source::setColor(PathView path, std::optional<std::uint32_t> rgba) {
  return resultOf(rgba ? rk_source_color(state_->source, CPath(path), *rgba)
                       : rk_source_color_default(state_->source, CPath(path)));
}

SourceResult Source::setSignal(PathView path, std::string_view name, double value,
                               std::string_view unit, double deadband) {
  const CText<RK_UNIT_BYTES> unit_text(unit);
  if (unit_text.get() == nullptr) return SourceResult::bad_text;
  return resultOf(rk_source_signal(state_->source, CPath(path), CName(name).name(), value,
                                   unit.empty() ? nullptr : unit_text.get(), deadband));
}

SourceResult Source::setSignal(PathView path, std::string_view name, bool value) {
  return resultOf(
      rk_source_signal_bool(state_->source, CPath(path), CName(name).name(), value ? 1 : 0));
}

SourceResult Source::setSignal(PathView path, std::string_view name, std::string_view text) {
  return resultOf(
      rk_source_signal_text(state_->source, CPath(path), CName(name).name(), CString(text).get()));
}

SourceResult Source::cancelSignal(PathView path, std::string_view name) {
  return resultOf(rk_source_signal_default(state_->source, CPath(path), CName(name).name()));
}

SourceResult Source::drawLine(std::string_view id, std::uint32_t rgba, std::span<const Vec3> points,
                              double width_px, PathView carrier) {
  return resultOf(rk_source_line(state_->source, CName(id).name(), rgba, width_px, CPath(carrier),
                                 numbersOf(points), points.size()));
}

SourceResult Source::drawPoints(std::string_view id, std::uint32_t rgba,
                                std::span<const Vec3> points, double size_px, PathView carrier) {
  return resultOf(rk_source_points(state_->source, CName(id).name(), rgba, size_px, CPath(carrier),
                                   numbersOf(points), points.size()));
}

SourceResult Source::drawLabel(std::string_view id, const Vec3& at, std::string_view text,
                               PathView carrier) {
  return resultOf(rk_source_label(state_->source, CName(id).name(), CPath(carrier), &at.x,
                                  CString(text).get()));
}

SourceResult Source::erase(std::string_view id) {
  return resultOf(rk_source_erase(state_->source, CName(id).name()));
}

SourceResult Source::eraseAll() { return resultOf(rk_source_erase(state_->source, nullptr)); }

SourceResult Source::setView(std::string_view name, const View& view, PathView carrier) {
  const rk_view numbers = {{view.eye.x, view.eye.y, view.eye.z},
                           {view.target.x, view.target.y, view.target.z},
                           view.fov_deg,
                           {view.up.x, view.up.y, view.up.z},
                           view.ortho_height_m.value_or(0)};
  if (view.ortho_height_m == 0.0) return SourceResult::bad_argument;
  return resultOf(rk_source_view(state_->source, CName(name).name(), &numbers, CPath(carrier)));
}

SourceResult Source::event(std::string_view text) {
  return resultOf(rk_source_event(state_->source, CString(text).get()));
}

SourceResult Source::flush(WallTime now) {
  return resultOf(rk_source_flush(state_->source, now.time_since_epoch().count()));
}

SourceResult Source::flush(Nanoseconds now, std::optional<WallTime> time) {
  return resultOf(rk_source_flush_at(state_->source, now.count(),
                                     time ? time->time_since_epoch().count() : -1));
}

std::optional<Nanoseconds> Source::due() const {
  const std::int64_t due = rk_source_due(state_->source);
  if (due == std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  return Nanoseconds(due);
}

std::uint64_t Source::sent() const { return rk_source_sent(state_->source); }

}  // namespace rocinante
