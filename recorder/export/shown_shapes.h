#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/foreign/session/session_format.h"

namespace rocinante {

/// Writes what devices show, whenever a link appears, disappears or changes its colour. Each look
/// of a link is made once and kept in memory. Borrows format and file.
class ShownShapes {
 public:
  ShownShapes(SessionFormat& format, MessageSink& out) : format_(format), out_(out) {}

  Status moment(LogTime time, const PosedScene& scene);
  const std::vector<std::string>& gaps() const { return gaps_; }

 private:
  struct Look {
    const Model* model = nullptr;  ///< null: it is not there
    std::vector<bool> shown;
    std::vector<std::optional<std::uint32_t>> colors;
    bool operator==(const Look&) const = default;
  };
  using ShapeKey = std::tuple<std::string, const Model*, std::size_t, std::optional<std::uint32_t>>;

  Status write(LogTime time, const PosedDevice& device);
  Result<std::shared_ptr<const Bytes>> shapeOf(const PosedDevice& device, std::size_t link);

  SessionFormat& format_;
  MessageSink& out_;
  std::map<std::string, Look> looks_;
  std::map<ShapeKey, std::shared_ptr<const Bytes>> shapes_;
  std::vector<std::string> gaps_;
};

}  // namespace rocinante
