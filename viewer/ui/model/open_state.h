#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/ui/model/file_list.h"
#include "viewer/ui/model/line_start.h"

namespace rocinante {

/// What was shown before, newest first.
struct RecentContent {
  std::filesystem::path cell;  ///< a log's, if it carries its cell
  std::filesystem::path log;   ///< empty: none
  bool operator==(const RecentContent&) const = default;
};

/// The list of files to open: the folder, what is typed, and the chosen line.
struct OpenState {
  bool shown = false;
  bool just_opened = false;  ///< takes the keyboard in the coming frame
  bool used = false;         ///< something was opened here: a fault is not the program's end
  std::filesystem::path folder;
  std::vector<FileEntry> entries;  ///< of the folder
  std::string fault;               ///< why the folder cannot be listed; empty: it can
  std::array<char, 1024> text{};   ///< NUL-terminated
  std::size_t chosen = 0;
  LineStart start;
  std::vector<RecentContent> recent;

  /// Shows the list, of the last folder or else of `where`.
  void open(const std::filesystem::path& where);
  void enter(const std::filesystem::path& where);
};

}  // namespace rocinante
