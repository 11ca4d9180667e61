#include "viewer/ui/program/save_files.h"

#include <chrono>
#include <thread>
#include <utility>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

SaveFiles::News newsOf(const LiveSaver::Saved& made) {
  std::string text = "saved: " + made.file.string();
  std::error_code fault;
  const std::uintmax_t bytes = std::filesystem::file_size(made.file, fault);
  if (!fault) text += " (" + sizeText(bytes) + ")";
  if (made.doubt.empty()) return {std::move(text), false};
  return {text + "; " + made.doubt, true};
}

}  // namespace

Status SaveFiles::ask(ViewModel& model, const std::filesystem::path& file) {
  LiveKeeper* const keeper = model.isLive() ? model.feed().keeper() : nullptr;
  if (keeper == nullptr || model.live() == nullptr) {
    return Error{ErrorKind::bad_argument, "only a live session that is kept can be saved", {}};
  }
  std::error_code ignored;
  const auto now = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
  const std::filesystem::path output =
      file.empty() ? freeLiveName(std::filesystem::current_path(ignored), now) : file;
  return saver_.start(*keeper, {shown_.cell, shown_.where, output, model.live()->time});
}

Result<SaveFiles::News> SaveFiles::make(ViewModel& model, const std::filesystem::path& file) {
  if (auto begun = ask(model, file); !begun) return begun.error();
  while (true) {
    if (const auto saved = saver_.look(*model.feed().keeper())) {
      if (!saved->ok()) return saved->error();
      const LiveSaver::Saved& made = **saved;
      if (!made.doubt.empty())
        model.viewer.panels.doubts.push_back(made.file.string() + ": " + made.doubt);
      return newsOf(made);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::optional<SaveFiles::News> SaveFiles::look(ViewModel& model) {
  if (!saver_.active()) return std::nullopt;
  const auto saved = saver_.look(*model.feed().keeper());
  if (!saved) return std::nullopt;
  if (!saved->ok()) return News{"the session was not saved: " + saved->error().text(), true};
  return newsOf(**saved);
}

}  // namespace rocinante
