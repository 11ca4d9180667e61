#include "player/control/control_thread.h"

#include <utility>

namespace rocinante {

ControlThread::ControlThread(CommandSlot& slot, std::vector<std::unique_ptr<ControlInput>> inputs)
    : slot_(slot), inputs_(std::move(inputs)) {
  if (!inputs_.empty()) thread_ = std::thread([this] { serveUntilClosed(); });
}

ControlThread::~ControlThread() {
  if (!thread_.joinable()) return;
  slot_.close();
  thread_.join();
}

void ControlThread::serveUntilClosed() {
  const auto ask = [this](std::string line) { return slot_.ask(std::move(line)); };
  std::vector<pollfd> descriptors;
  while (!slot_.closed()) {
    descriptors.assign(1, {slot_.announced(), POLLIN, 0});
    for (const auto& input : inputs_) input->addDescriptors(descriptors);
    if (::poll(descriptors.data(), descriptors.size(), -1) < 0) continue;
    for (const std::string& line : slot_.takeAnnounced()) {
      for (const auto& input : inputs_) input->tell(line);
    }
    for (const auto& input : inputs_) input->serve(ask);
  }
}

}  // namespace rocinante
