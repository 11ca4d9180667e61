#include "golden/why/devices_in_front.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

namespace rocinante {
namespace {

/// Of what is covered: who covers less than this stays.
constexpr double kLeastPart = 0.02;

bool isDevice(const IdentityFrame& frame, std::uint32_t id, const std::string& device) {
  return id != 0 && frame.names[id - 1].device == device;
}

}  // namespace

Result<std::vector<std::string>> devicesInFront(FrameMaker& maker, const FrameRequest& request,
                                                const std::string& device) {
  const auto whole = maker.identity(request);
  if (!whole.ok()) return whole.error();
  std::set<std::string> others;
  for (const IdentityName& name : whole->names) {
    if (name.device != device && name.device != "drawing") others.insert(name.device);
  }
  if (others.empty()) return std::vector<std::string>{};
  FrameRequest without = request;
  without.hide.insert(without.hide.end(), others.begin(), others.end());
  const auto alone = maker.identity(without);
  if (!alone.ok()) return alone.error();
  std::size_t pixels = 0, covered = 0;
  std::vector<std::size_t> covered_by(whole->names.size());
  for (std::size_t i = 0; i < alone->ids.size(); ++i) {
    if (!isDevice(*alone, alone->ids[i], device)) continue;
    ++pixels;
    const std::uint32_t owner = whole->ids[i];
    if (owner == 0 || isDevice(*whole, owner, device)) continue;
    ++covered;
    ++covered_by[owner - 1];
  }
  if (2 * covered <= pixels) return std::vector<std::string>{};
  std::map<std::string, std::size_t> by_device;
  for (std::size_t i = 0; i < covered_by.size(); ++i) {
    by_device[whole->names[i].device] += covered_by[i];
  }
  std::vector<std::string> in_front;
  for (const auto& [name, count] : by_device) {
    const bool much = static_cast<double>(count) >= kLeastPart * static_cast<double>(covered);
    if (much && others.contains(name)) in_front.push_back(name);
  }
  return in_front;
}

}  // namespace rocinante
