#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

namespace rocinante {

/// What the file system answered during a search: asked again, equal answers mean that the search
/// would find the same. Any number of threads at once.
class SearchFacts {
 public:
  enum class Kind : std::uint8_t { missing, file, folder, other };
  struct Answer {
    Kind kind = Kind::missing;
    std::filesystem::path canonical;  ///< without links; empty when missing
    bool operator==(const Answer&) const = default;
  };

  /// The file system's answer now.
  static Answer answerFor(const std::filesystem::path& path);

  /// Asks for `path` and notes the answer.
  void note(const std::filesystem::path& path);
  /// The contents of `path` counted, if it exists; notes its answer too.
  void noteContent(const std::filesystem::path& path);
  /// Something counted that cannot be asked again cheaply, such as the contents of a folder.
  void noteMore();

  /// For one thread, after the search.
  const std::map<std::filesystem::path, Answer>& answers() const { return answers_; }
  const std::set<std::filesystem::path>& contents() const { return contents_; }
  /// False after noteMore().
  bool complete() const { return complete_; }

 private:
  std::mutex mutex_;
  std::map<std::filesystem::path, Answer> answers_;
  std::set<std::filesystem::path> contents_;
  bool complete_ = true;
};

}  // namespace rocinante
