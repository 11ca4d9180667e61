#include "viewer/ui/program/live_saver.h"

#include <fmt/format.h>

#include <utility>

#include "core/cli/search_options.h"
#include "core/recording/record_path.h"
#include "viewer/ui/program/evidence.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "rocinante-log";

}  // namespace

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
  std::vector<std::string> all{programBeside(kProgram)};
  all.insert(all.end(), words.begin(), words.end());
  Result<ChildProcess> process = ChildProcess::start(all, {});
  if (!process) {
    return Error{ErrorKind::refused, "cannot start rocinante-log: " + process.error().what,
                 all.front()};
  }
  process_.emplace(std::move(*process));
  return {};
}

Status LiveSaver::merge(const KeptProgress& kept) {
  if (kept.finished.empty()) {
    return Error{ErrorKind::bad_argument, "nothing of this live session has been kept yet", {}};
  }
  const bool is_bare = request_.cell.empty();
  if (kept.finished.size() == 1 && !is_bare) return attach(kept.finished.front());
  std::vector<std::string> words{"merge"};
  for (const fs::path& piece : kept.finished) words.push_back(piece.string());
  words.insert(words.end(), {"-o", (is_bare ? request_.output : merged_).string()});
  // Without a cell nothing is attached: this is the last step.
  step_ = is_bare ? Step::attaching : Step::merging;
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
  const auto ended = process_->poll();
  if (!ended) return std::nullopt;
  const std::string message = lastSentence(process_->errorOutput(), kProgram);
  process_.reset();
  if (ended->by_signal || ended->code > 1) {
    return end(keeper, Error{ErrorKind::refused,
                             message.empty() ? "rocinante-log failed without a message" : message,
                             {}});
  }
  if (ended->code == 1) doubt_ = message;
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
