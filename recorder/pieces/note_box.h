#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace rocinante {

/// What a recording that goes on has to say to people, handed from its threads to the caller's.
class NoteBox {
 public:
  struct Note {
    std::string text;
    bool is_trouble = false;  ///< something was not done that was asked for
  };

  void say(std::string text) { add({std::move(text), false}); }
  void warn(std::string text) { add({std::move(text), true}); }
  std::vector<Note> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(notes_, {});
  }

 private:
  // A program that never asks must not fill the memory.
  static constexpr std::size_t kMax = 10'000;

  void add(Note note) {
    const std::lock_guard lock(mutex_);
    if (notes_.size() < kMax) notes_.push_back(std::move(note));
  }

  std::mutex mutex_;
  std::vector<Note> notes_;
};

}  // namespace rocinante
