#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "viewer/ui/model/line_start.h"

namespace rocinante {

/// A line of a list of files.
struct FileEntry {
  std::string name;        ///< of a folder with a slash behind it
  bool is_folder = false;  ///< to be entered: not a bag, which is shown
  bool operator==(const FileEntry&) const = default;
};

/// True for names of what the window can show: cells, models, logs, bags and captures.
bool canBeShown(std::string_view file_name);
/// Of what can be shown: not for names of cells and models.
bool canBeBeside(std::string_view file_name);

/// The folders and what can be shown, folders first, each by name; hidden ones are left out, and
/// all beyond some thousands. A folder that is a bag is shown. Tables and lines of JSON are there
/// if their first lines are those of a recording, as far as some hundreds of them are read.
/// not_found or refused with the system's reason.
Result<std::vector<FileEntry>> listFolder(const std::filesystem::path& folder);

/// True for what somebody types to connect and not to open a file: an address with its port
/// (HOST:PORT, :PORT), or what begins with the name of a way to receive (udp://).
bool looksLikeEndpoint(std::string_view typed);

/// What was shown before, newest first.
struct RecentContent {
  std::filesystem::path cell;  ///< a log's, if it carries its cell; empty: the log has none
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
  std::filesystem::path log;     ///< the recorded session that is shown; empty: none
  std::filesystem::path before;  ///< a log of the same devices that gave way to it; empty: none
  bool beside = false;           ///< what is chosen is shown beside `log`, and only logs are listed
  bool beside_comes = false;     ///< a log is being read to be shown beside `log`
  bool listens = false;          ///< it tells what is heard at the usual endpoints
  std::array<char, 256> endpoint{};  ///< being typed, NUL-terminated
  /// Endpoints of live sessions behind what is shown, with blanks between; the last shown first.
  std::vector<std::string> left;
  std::string ended;  ///< what became of a live session that was ended, to be said; or empty

  /// Shows the list, of the last folder or else of `where`.
  void open(const std::filesystem::path& where);
  /// The same, for a session beside `log`.
  void openBeside(const std::filesystem::path& where);
  void enter(const std::filesystem::path& where);
  /// What was shown before and is offered again, newest first: for a session beside `log` other
  /// logs alone, each once.
  std::vector<RecentContent> offered() const;
};

}  // namespace rocinante
