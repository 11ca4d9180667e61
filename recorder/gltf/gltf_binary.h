#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/mcap/byte_sink.h"
#include "core/report/json_text.h"

namespace rocinante {

/// Receives a section's bytes, borrowed for the call.
using UseBytes = std::function<Status(ByteView)>;

/// The binary chunk of a .glb: sections whose sizes are known before their bytes are made, with the
/// bufferViews and accessors that describe them (glTF 2.0, "Buffers and Buffer Views",
/// "Accessors").
class GltfBinary {
 public:
  /// The use of a section, as glTF numbers it.
  enum class Target { none = 0, vertices = 34962, indices = 34963 };

  /// A section of `bytes`, which `make` gives once the file is written. `stride`: bytes from one
  /// element to the next; 0: packed. Answers the bufferView.
  std::size_t addView(std::uint64_t bytes, Target target, std::size_t stride,
                      std::function<Status(const UseBytes&)> make);
  /// Answers the accessor. `component` as glTF numbers it: 5126 float, 5125 uint32. `range` has min
  /// and max, or is null.
  std::size_t addAccessor(std::size_t view, std::uint64_t offset, int component, const char* type,
                          std::uint64_t count, const Json& range = nullptr);

  std::uint64_t bytes() const { return bytes_; }
  /// Puts buffers, bufferViews and accessors into `document`.
  void describe(Json& document) const;
  /// A .glb of `document`, described already. unsupported beyond 2 GiB, which many readers refuse;
  /// then nothing is written. `sink` stays open.
  Status write(ByteSink& sink, const Json& document) const;

 private:
  struct Section {
    std::uint64_t bytes = 0;
    std::function<Status(const UseBytes&)> make;
  };

  std::vector<Section> sections_;
  std::uint64_t bytes_ = 0;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

/// min and max of an accessor, from as many numbers as a component list has.
Json accessorRange(std::span<const float> min, std::span<const float> max);

inline constexpr int kGltfFloat = 5126;
inline constexpr int kGltfUint32 = 5125;

}  // namespace rocinante
