#include "viewer/ui/program/live_saver.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/child_process.h"
#include "core/cli/search_options.h"
#include "core/recording/record_path.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

fs::path logProgram() {
  std::error_code ignored;
  const fs::path beside =
      fs::read_symlink("/proc/self/exe", ignored).parent_path() / "rocinante-log";
  return fs::exists(beside, ignored) ? beside : fs::path("rocinante-log");
}

/// The last line that the program said, without its name.
std::string lastLine(int said) {
  std::array<char, 4096> buffer{};
  const ssize_t got = ::read(said, buffer.data(), buffer.size());
  std::string text(buffer.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (const std::size_t line = text.rfind('\n'); line != std::string::npos) text.erase(0, line + 1);
  constexpr std::string_view kName = "rocinante-log: ";
  if (text.starts_with(kName)) text.erase(0, kName.size());
  return text;
}

}  // namespace

LiveSaver::~LiveSaver() {
  if (process_ > 0) {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }
  if (said_ >= 0) ::close(said_);
}

Status LiveSaver::start(LiveKeeper& keeper, Request request) {
  if (active()) return Error{ErrorKind::refused, "the session is already being saved", {}};
  std::error_code ignored;
  if (fs::exists(request.output, ignored)) {
    return Error{ErrorKind::refused, "the file exists; choose another name",
                 request.output.string()};
  }
  keeper.hold(true);
  keeper.finishUpTo(request.until);
  request_ = std::move(request);
  merged_ = keeper.folder() / "saved.part";
  doubt_.clear();
  step_ = Step::finishing;
  return {};
}

Status LiveSaver::run(const std::vector<std::string>& words) {
  std::vector<std::string> all{logProgram().string()};
  all.insert(all.end(), words.begin(), words.end());
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Error{
        ErrorKind::refused, std::string("cannot create a pipe: ") + std::strerror(errno), {}};
  }
  // What it says beyond the pipe's buffer must not stop it.
  ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
  const Result<pid_t> process = startChild(all, {-1, -1, ends[1]});
  ::close(ends[1]);
  if (!process) {
    ::close(ends[0]);
    return Error{ErrorKind::refused, "cannot start rocinante-log: " + process.error().what,
                 all.front()};
  }
  process_ = *process;
  said_ = ends[0];
  return {};
}

Status LiveSaver::merge(const KeptProgress& kept) {
  if (kept.finished.empty()) {
    return Error{ErrorKind::bad_argument, "nothing of this live session has been kept yet", {}};
  }
  if (kept.finished.size() == 1) return attach(kept.finished.front());
  std::vector<std::string> words{"merge"};
  for (const fs::path& piece : kept.finished) words.push_back(piece.string());
  words.insert(words.end(), {"-o", merged_.string()});
  step_ = Step::merging;
  return run(words);
}

Status LiveSaver::attach(const fs::path& log) {
  std::vector<std::string> words{"attach", log.string(), "--cell", request_.cell.string()};
  const std::vector<std::string> where = cli::searchWords(request_.where);
  words.insert(words.end(), where.begin(), where.end());
  words.insert(words.end(), {"-o", request_.output.string()});
  step_ = Step::attaching;
  return run(words);
}

std::optional<int> LiveSaver::ended() {
  int outcome = 0;
  const pid_t gone = ::waitpid(process_, &outcome, WNOHANG);
  if (gone == 0) return std::nullopt;
  process_ = -1;
  return gone > 0 && WIFEXITED(outcome) ? WEXITSTATUS(outcome) : 2;
}

Result<LiveSaver::Saved> LiveSaver::end(LiveKeeper& keeper, std::optional<Error> fault) {
  step_ = Step::none;
  keeper.hold(false);
  std::error_code ignored;
  fs::remove(merged_, ignored);
  if (fault) return *fault;
  return Saved{request_.output, doubt_};
}

std::optional<Result<LiveSaver::Saved>> LiveSaver::look(LiveKeeper& keeper) {
  if (step_ == Step::none) return std::nullopt;
  if (step_ == Step::finishing) {
    const KeptProgress kept = keeper.progress();
    if (kept.finished_until <= request_.until) return std::nullopt;
    if (Status begun = merge(kept); !begun) return end(keeper, begun.error());
    return std::nullopt;
  }
  const std::optional<int> code = ended();
  if (!code) return std::nullopt;
  const std::string said = lastLine(said_);
  ::close(std::exchange(said_, -1));
  if (*code > 1) {
    return end(keeper, Error{ErrorKind::refused,
                             said.empty() ? "rocinante-log failed without a message" : said,
                             {}});
  }
  if (*code == 1) doubt_ = said;
  if (step_ == Step::merging) {
    if (Status begun = attach(merged_); !begun) return end(keeper, begun.error());
    return std::nullopt;
  }
  return end(keeper, std::nullopt);
}

fs::path freeLiveName(const fs::path& folder, WallTime now) {
  const auto name = recordPath("live-%Y%m%dT%H%M%SZ.mcap", now);
  const fs::path first = folder / (name.ok() ? *name : fs::path("live.mcap"));
  std::error_code ignored;
  fs::path path = first;
  for (std::uint64_t number = 2; fs::exists(path, ignored); ++number) {
    path = folder / fmt::format("{}-{}.mcap", first.stem().string(), number);
  }
  return path;
}

}  // namespace rocinante
