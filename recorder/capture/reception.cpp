#include "recorder/capture/reception.h"

#include "recorder/capture/prompt_thread.h"
#include "recorder/pieces/thread_without_signals.h"

namespace rocinante {
Reception::Reception(const std::vector<DatagramSource*>& sources, InputLoop& loop)
    : sources_(sources),
      loop_(loop),
      start_(std::chrono::steady_clock::now()),
      thread_(threadWithoutSignals("receive", [this] {
        askToRunPromptly();
        received_ = receive();
      })) {}

Status Reception::receive() {
  Status ended;
  while (ended && !stop_.load(std::memory_order_relaxed) && !loop_.ended()) {
    const Result<bool> moved = loop_.pass();
    if (!moved) {
      ended = moved.error();
      over_.store(true);
    } else if (const Nanoseconds pause = loop_.pauseAfter(*moved); pause > Nanoseconds(0)) {
      std::this_thread::sleep_for(pause);
    }
  }
  // Datagrams that have arrived may not be delivered yet.
  std::this_thread::sleep_for(loop_.deliveryDelay());
  Status finished = loop_.finish();
  over_.store(true);
  return ended ? finished : ended;
}

Status Reception::stop() {
  stop_.store(true);
  if (thread_.joinable()) thread_.join();
  return received_;
}

std::vector<std::string> Reception::names() const {
  std::vector<std::string> names;
  for (const DatagramSource* source : sources_) names.push_back(boundText(*source));
  return names;
}

std::unique_ptr<InputLoop> socketLoop(const std::vector<DatagramSource*>& sources, HandOver& queue,
                                      TeeSet& tees, NoteBox& notes) {
  ReceiveLoop::Callbacks callbacks;
  callbacks.note = [&notes](const std::string& note) { notes.say(note); };
  if (!tees.empty()) {
    callbacks.tee = [&tees, &notes](auto batch) {
      tees.forward(batch);
      if (const auto news = tees.circleNews()) notes.say(*news);
    };
  }
  return std::make_unique<ReceiveLoop>(sources, readClocks, queue, std::move(callbacks));
}

}  // namespace rocinante
