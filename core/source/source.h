#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/math/vector.h"
#include "core/packet/packet.h"

namespace rocinante {

/// What a Source answers: done, or why it refused; it then changed nothing.
enum class [[nodiscard]] SourceResult : std::int32_t{
    done = 0,
    bad_name = -1,      ///< not 1 to 255 bytes of UTF-8 without control characters
    bad_number = -2,    ///< not finite, or (but for signals) not below 2^53
    bad_text = -3,      ///< over 4,096 bytes, not UTF-8, or with control characters; a bad unit
    bad_pose = -4,      ///< the quaternion's length differs from 1 by more than 0.001
    bad_argument = -5,  ///< missing or out of range
    no_device = -6,     ///< forgotten, or never declared
    wrong_count = -7,   ///< of joints: the order has another
    order_fixed = -8,   ///< it cannot change before the device is removed
    too_long = -9,      ///< the statement does not fit one datagram
    full = -10,         ///< `memory_bytes` are used up
    not_sent = -11,     ///< `send` refused a datagram
    gone = -12,         ///< the device was removed and not added again
};

/// A sentence for a result, without a full stop.
std::string_view sentenceOf(SourceResult result);

/// A device of a Source, from Source::device(). One that was refused is refused by all functions
/// with the same result.
struct SourceDevice {
  std::int32_t handle = static_cast<std::int32_t>(SourceResult::no_device);
  bool ok() const { return handle >= 0; }
};

/// How a source names itself and paces what it sends.
struct SourceSettings {
  std::string_view source;                        ///< SOURCE: who speaks
  std::string_view run;                           ///< RUN, chosen anew at each start; empty: none
  Nanoseconds restate = std::chrono::seconds(2);  ///< between restatements; 0: never
  std::size_t max_datagram = 1200;                ///< bytes
  std::size_t reserved_bytes = 0;  ///< writable behind each datagram, beyond max_datagram
  /// For the whole state: about 1 KB a device, 100 bytes a joint, 24 a point, and 16 KB. Never
  /// grows.
  std::size_t memory_bytes = std::size_t{1} << 20U;
};

/// Sends the state of devices as packet text (docs/packet-format.md): what changed at each flush(),
/// and every `restate` everything again, spread over half a second, so that late joiners and lossy
/// networks end up with the same state.
///
/// Metres, radians; numbers have nine decimals, correctly rounded (ties to even), without trailing
/// zeros; those of signals the fewest digits that read back as the same. After open() nothing
/// allocates, throws or reads a clock: time is O(values) to set, O(changes) to flush, and O(items)
/// in the flush that begins a restatement. One thread at a time. The same in C, byte for byte:
/// rocinante_source.h.
class Source {
 public:
  /// Sends one datagram; false when it could not. It is then lost like any other, and the next
  /// restatement makes up for it. The bytes are valid during the call; `reserved_bytes` behind them
  /// may be written, for example by a signature.
  using Send = std::function<bool(std::span<std::byte> datagram)>;

  /// bad_argument when a name is invalid, or max_datagram or memory_bytes too small.
  static Result<Source> open(const SourceSettings& settings, Send send);

  Source(Source&&) noexcept;
  Source& operator=(Source&&) noexcept;
  ~Source();

  /// The device of this name, declared when it is new; nothing is said by that. At most 65,536.
  SourceDevice device(std::string_view name);
  /// The device exists; `model` is a name that the cell knows, `kinematics` the hash of its
  /// kinematics.
  SourceResult add(SourceDevice device, std::string_view model,
                   std::optional<std::uint64_t> kinematics = std::nullopt);
  /// The device is gone with everything said about it, by any source. Nothing else can be said
  /// about it before it is added again.
  SourceResult remove(SourceDevice device);
  /// Says nothing about the device any more and frees its memory: receivers forget what this source
  /// said about it with the next restatement. remove() it first if it is gone.
  SourceResult forget(SourceDevice device);

  /// Which joints setJoints() means, by name and all different: once, before the first joints, and
  /// anew after remove(). Without it values are positions in the model's file.
  SourceResult setOrder(SourceDevice device, std::span<const std::string_view> joints);
  SourceResult setJoints(SourceDevice device, std::span<const double> values);
  /// In the world, or in a link that carries the device.
  SourceResult setPose(SourceDevice device, const Pose& pose, PathView carrier = {});

  /// Says the joints and the pose of the device with the next flush although they did not change: a
  /// sign of life.
  SourceResult repeat(SourceDevice device);

  enum class Visibility : std::uint8_t { shown, hidden, as_the_cell };
  SourceResult setVisibility(PathView path, Visibility visibility);
  /// 0xRRGGBBAA; empty: the cell's own.
  SourceResult setColor(PathView path, std::optional<std::uint32_t> rgba);

  /// What the machine says beside where it is, of a device, a link, or (an empty path) of neither.
  /// A number goes out when it differs by more than `deadband` from the one sent last, and is
  /// restated as it is; `unit` is 1 to 32 printable ASCII bytes without spaces and quotes, or empty
  /// for the one that the signal has.
  SourceResult setSignal(PathView path, std::string_view name, double value,
                         std::string_view unit = {}, double deadband = 0);
  SourceResult setSignal(PathView path, std::string_view name, bool value);
  SourceResult setSignal(PathView path, std::string_view name, std::string_view text);
  SourceResult setSignal(PathView path, std::string_view name, const char* text) {
    return setSignal(path, name, std::string_view(text));
  }
  /// An integer is a number, not a truth.
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) SourceResult
      setSignal(PathView path, std::string_view name, Number value, std::string_view unit = {},
                double deadband = 0) {
    return setSignal(path, name, static_cast<double>(value), unit, deadband);
  }
  /// Says nothing about the signal any more; receivers may have one of an earlier run.
  SourceResult cancelSignal(PathView path, std::string_view name);

  /// Drawings share their ids; drawing one again replaces it. Long ones are sent in parts, at most
  /// 4,096. At least one point; pixels above 0.
  SourceResult drawLine(std::string_view id, std::uint32_t rgba, std::span<const Vec3> points,
                        double width_px = 1, PathView carrier = {});
  SourceResult drawPoints(std::string_view id, std::uint32_t rgba, std::span<const Vec3> points,
                          double size_px = 3, PathView carrier = {});
  SourceResult drawLabel(std::string_view id, const Vec3& at, std::string_view text,
                         PathView carrier = {});
  /// A drawing that does not exist is erased as well: receivers may have one of an earlier run.
  SourceResult erase(std::string_view id);
  SourceResult eraseAll();

  struct View {
    Vec3 eye{}, target{};  ///< at least 2e-9 m apart
    double fov_deg = 45;   ///< vertical, over 0 and under 180
    Vec3 up{0, 0, 1};
    std::optional<double> ortho_height_m;  ///< orthographic
  };
  SourceResult setView(std::string_view name, const View& view, PathView carrier = {});

  /// Sent with the next flush, once.
  SourceResult event(std::string_view text);

  /// Sends what changed, then the parts of a restatement that are due. `now` becomes TIME. To be
  /// called at least ten times a second, or restatements come in bursts.
  SourceResult flush(WallTime now);
  /// The same with another TIME than the clock that restatements are timed by; none before 1970.
  SourceResult flush(Nanoseconds now, std::optional<WallTime> time);

  /// When the next part of a restatement is due, on the clock of `now`; empty: not known yet.
  std::optional<Nanoseconds> due() const;
  /// Datagrams given to `send` so far: the next SEQUENCE.
  std::uint64_t sent() const;

 private:
  struct State;
  explicit Source(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace rocinante
