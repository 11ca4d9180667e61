#include "viewer/ui/program/input_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <tuple>
#include <utility>

#include "viewer/ui/commands/script_word.h"
#include "viewer/ui/window/key_name.h"

namespace rocinante {
namespace {

std::string reasonOfWriting() { return std::string("cannot be written: ") + std::strerror(errno); }

void tellHeld(std::string& lines, const FrameInput& before, const FrameInput& seen) {
  // A key that is pressed is down in its frame anyway.
  const auto pressed = [&](int key) {
    return std::ranges::find(seen.presses, key, &KeyPress::key) != seen.presses.end();
  };
  const auto tell = [&](const char* what, const std::vector<int>& now,
                        const std::vector<int>& other) {
    for (const int key : now) {
      const auto name = keyName({key, false, false, false});
      if (!std::ranges::binary_search(other, key) && !pressed(key) && name) {
        lines += fmt::format("{} {}\n", what, *name);
      }
    }
  };
  tell("release", before.held, seen.held);
  tell("hold", seen.held, before.held);
}

/// The text with a blank before it, as much as a line of the window takes; nothing: an empty
/// clipboard.
std::string pastedWord(std::string_view text) {
  constexpr std::size_t kMost = 4096;
  std::string_view taken = text.substr(0, kMost);
  // Not in the middle of a letter.
  while (taken.size() == kMost && text.size() > kMost && !taken.empty() &&
         (static_cast<unsigned char>(text[taken.size()]) & 0xC0U) == 0x80U) {
    taken.remove_suffix(1);
  }
  // What other programs leave there may be anything.
  const std::string word = scriptWord(taken);
  return word.empty() || !textOfWord(word).ok() ? "" : " " + word;
}

}  // namespace

std::string inputLines(const FrameInput& before, const FrameInput& seen) {
  std::string lines;
  if (std::tie(seen.width, seen.height, seen.scale) !=
      std::tie(before.width, before.height, before.scale)) {
    lines += fmt::format("window-size {} {} {}\n", seen.width, seen.height, seen.scale);
  }
  if (seen.mouse != before.mouse) {
    lines += seen.mouse ? fmt::format("mouse {} {}\n", seen.mouse->first, seen.mouse->second)
                        : std::string("mouse-out\n");
  }
  for (std::size_t i = 0; i < seen.down.size(); ++i) {
    if (seen.down[i] == before.down[i]) continue;
    lines += fmt::format("button {} {}{}\n", kMouseButtons[i], seen.down[i] ? "down" : "up",
                         seen.down[i] && seen.again ? " again" : "");
  }
  if (seen.wheel != 0 || seen.wheel_across != 0) {
    lines += fmt::format("wheel {}{}\n", seen.wheel,
                         seen.wheel_across != 0 ? fmt::format(" {}", seen.wheel_across) : "");
  }
  tellHeld(lines, before, seen);
  if (seen.pasted) lines += fmt::format("clipboard{}\n", pastedWord(*seen.pasted));
  for (const KeyPress& press : seen.presses) {
    const auto name = keyName(press);
    if (name) lines += fmt::format("press {}{}\n", *name, press.repeated ? " again" : "");
  }
  if (!seen.typed.empty()) lines += fmt::format("type {}\n", scriptWord(seen.typed));
  return lines;
}

Result<InputRecord> InputRecord::begin(const std::filesystem::path& file) {
  InputRecord record;
  if (file.empty()) return record;
  record.name_ = file;
  record.file_.reset(std::fopen(file.c_str(), "we"));
  const bool begun =
      record.file_ != nullptr &&
      std::fputs("# What was done with a window; `rocinante view ... --script` does it again.\n",
                 record.file_.get()) >= 0 &&
      std::fflush(record.file_.get()) == 0;
  if (!begun) return Error{ErrorKind::refused, reasonOfWriting(), file.string()};
  return record;
}

void InputRecord::write(const std::string& text) {
  if (file_ == nullptr) return;
  if (std::fputs(text.c_str(), file_.get()) >= 0 && std::fflush(file_.get()) == 0) return;
  fault_ = fmt::format("input is no longer recorded: {} {}", name_.string(), reasonOfWriting());
  file_.reset();
}

void InputRecord::add(const FrameInput& seen, SteadyTime now) {
  if (!active()) return;
  if (!began_) began_ = now;
  std::string lines = inputLines(before_, seen);
  // Keys that are pressed stay as they were held until a frame says otherwise.
  const std::vector<int> held_before = std::exchange(before_, seen).held;
  for (const KeyPress& press : seen.presses) {
    std::erase(before_.held, press.key);
    if (std::ranges::binary_search(held_before, press.key)) {
      before_.held.insert(std::ranges::upper_bound(before_.held, press.key), press.key);
    }
  }
  before_.endFrame();
  // Two frames are never at one time.
  Nanoseconds at = now - *began_;
  if (last_) at = std::max(at, *last_ + Nanoseconds(1));
  last_ = at;
  const auto [seconds, rest] = std::lldiv(at.count(), 1'000'000'000);
  write(fmt::format("{}frame-at {}.{:09}s\n", lines, seconds, rest));
}

void InputRecord::addDrop(const std::vector<std::filesystem::path>& files) {
  if (!active() || files.empty()) return;
  std::string line = "drop";
  for (const std::filesystem::path& file : files) line += " " + scriptWord(file.string());
  write(line + "\n");
}

void InputRecord::addFilesCame() {
  if (active()) write("await-files\n");
}

std::optional<std::string> InputRecord::takeFault() { return std::exchange(fault_, std::nullopt); }

}  // namespace rocinante
