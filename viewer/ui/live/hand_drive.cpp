#include "viewer/ui/live/hand_drive.h"

#include <algorithm>
#include <utility>

namespace rocinante {

Result<HandDrive> HandDrive::open(const Endpoint& to, const DriveSettings& settings) {
  auto sending = SendingSource::open(to, {settings.source, settings.run});
  if (!sending) return sending.error();
  return HandDrive(std::move(*sending));
}

Result<HandDrive> HandDrive::into(std::unique_ptr<DatagramSink> sink,
                                  const DriveSettings& settings) {
  auto sending = SendingSource::into(std::move(sink), {settings.source, settings.run});
  if (!sending) return sending.error();
  return HandDrive(std::move(*sending));
}

void HandDrive::set(const std::string& device, std::span<const double> values) {
  auto known = devices_.find(device);
  if (known == devices_.end()) {
    known = devices_.emplace(device, Driven{sending_.source().device(device), {}}).first;
  } else if (std::ranges::equal(known->second.values, values)) {
    return;
  }
  known->second.values.assign(values.begin(), values.end());
  sending_.said(sending_.source().setJoints(known->second.device, values), device);
}

std::vector<std::string> HandDrive::devices() const {
  std::vector<std::string> names;
  for (const auto& [name, driven] : devices_) names.push_back(name);
  return names;
}

}  // namespace rocinante
