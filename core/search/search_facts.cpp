#include "core/search/search_facts.h"

#include <system_error>

namespace rocinante {

namespace fs = std::filesystem;

SearchFacts::Answer SearchFacts::answerFor(const fs::path& path) {
  std::error_code error;
  Answer answer{Kind::other, fs::canonical(path, error)};
  if (error) return {};
  const fs::file_status status = fs::status(answer.canonical, error);
  if (fs::is_regular_file(status)) answer.kind = Kind::file;
  if (fs::is_directory(status)) answer.kind = Kind::folder;
  return answer;
}

void SearchFacts::note(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  const auto [known, is_new] = answers_.try_emplace(path);
  if (is_new) known->second = answerFor(path);
}

void SearchFacts::noteContent(const fs::path& path) {
  note(path);
  const std::lock_guard lock(mutex_);
  if (answers_.at(path).kind == Kind::file) contents_.insert(path);
}

void SearchFacts::noteMore() {
  const std::lock_guard lock(mutex_);
  complete_ = false;
}

}  // namespace rocinante
