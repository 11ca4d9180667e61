#include "viewer/ui/program/frame_journal.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace rocinante {
namespace {

Error cannotWriteJournal(const std::filesystem::path& file) {
  return Error{ErrorKind::refused, std::string("cannot be written: ") + std::strerror(errno),
               file.string()};
}

}  // namespace

Status FrameJournal::begin(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, Closer> opened(std::fopen(file.c_str(), "we"));
  if (!opened) return cannotWriteJournal(file);
  const bool written = std::fputs(
                           "shown_ns,wall_ns,moment_ns,loaded,drawn,level,whole,app_ms,cull_ms,"
                           "draw_ms,ui_ms\n",
                           opened.get()) >= 0 &&
                       std::fflush(opened.get()) == 0;
  return written ? Status() : Status(cannotWriteJournal(file));
}

Result<FrameJournal> FrameJournal::open(const std::filesystem::path& file) {
  FrameJournal journal;
  if (file.empty()) return journal;
  journal.file_.reset(std::fopen(file.c_str(), "ae"));
  if (!journal.file_) return cannotWriteJournal(file);
  // By lines: whoever measures reads along, and a killed window loses nothing.
  std::setvbuf(journal.file_.get(), nullptr, _IOLBF, 4096);
  return journal;
}

void FrameJournal::add(const ShownFrame& frame) {
  if (!file_) return;
  const auto count = [](auto time) { return time.time_since_epoch().count(); };
  const FrameTimes& times = frame.times;
  fmt::print(file_.get(), "{},{},{},{:d},{:d},{},{:d},{:.3f},{:.3f},{:.3f},{:.3f}\n",
             count(frame.shown_at), count(frame.shown_wall), count(frame.moment), frame.loaded,
             frame.drawn, frame.level, frame.whole, times.app, times.cull, times.draw, times.ui);
}

}  // namespace rocinante
