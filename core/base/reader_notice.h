#pragma once

#include <string>
#include <vector>

namespace rocinante {

/// What a reader found that makes everything read doubtful, whatever the program does with it. The
/// reader states it once per input; cli::run() prints what the program did not, and its exit code
/// is then not 0: no program can forget it.
struct ReaderNotice {
  std::string text;  ///< a sentence with its place
  std::string key;   ///< any output with these words has stated it already
};

/// Thread-safe; the first few notices of a process are kept, each once.
void addReaderNotice(ReaderNotice notice);
bool hasReaderNotices();
std::vector<ReaderNotice> readerNotices();

}  // namespace rocinante
