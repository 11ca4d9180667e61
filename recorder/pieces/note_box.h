#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace rocinante {

/// Notes for the user, handed from the threads of a running recording to the caller's.
class NoteBox {
 public:
  struct Note {
    std::string text;
    bool is_trouble = false;  ///< a requested operation failed
  };

  void say(std::string text) { add({std::move(text), false}); }
  void warn(std::string text) { add({std::move(text), true}); }
  std::vector<Note> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(notes_, {});
  }

 private:
  // Bounds the memory when the program never calls take().
  static constexpr std::size_t kMax = 10'000;

  void add(Note note) {
    const std::lock_guard lock(mutex_);
    if (notes_.size() < kMax) notes_.push_back(std::move(note));
  }

  std::mutex mutex_;
  std::vector<Note> notes_;
};

}  // namespace rocinante
