#pragma once

#include <signal.h>
#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// What a child reads and writes: descriptors of ours, which stay ours; -1: /dev/null.
struct ChildStreams {
  int in = -1;
  int out = -1;
  int err = -1;
};

/// Starts a program: words[0], searched in PATH when it has no slash, with the other words as its
/// arguments. It gets no other descriptor of ours that is marked close-on-exec. `own_group`: in a
/// process group of its own, so that Ctrl-C reaches only us. Whoever starts it waits for it
/// (waitForChild()). not_found when there is no such program, else refused; the sentence is the
/// system's.
Result<pid_t> startChild(const std::vector<std::string>& words, const ChildStreams& streams,
                         bool own_group = false);

/// How a child ended.
struct ChildEnd {
  bool by_signal = false;
  int code = 0;  ///< the exit code, or the signal

  bool ok() const { return !by_signal && code == 0; }
  std::string text() const;  ///< "exit 2", "signal 9"
};
/// Waits until this child of ours has ended.
ChildEnd waitForChild(pid_t child);

/// A program that runs beside us. Its standard error is kept in memory unless Options say
/// otherwise, so that nobody has to read it for the program to go on. One thread.
class ChildProcess {
 public:
  /// Which of its streams has its other end here, as stream().
  enum class Ours { none, input, output };
  struct Options {
    int in = -1, out = -1;     ///< as in ChildStreams, of those that are not ours
    std::optional<int> err{};  ///< the same; empty: kept for errorOutput()
    /// What it reads, from memory; with neither `in` nor `ours`.
    std::optional<std::string> input_text{};
    Ours ours = Ours::none;
    bool own_group = false;
    /// Sent when this is destroyed before the program ended; 0: the program goes on without us.
    int last_signal = SIGTERM;
  };
  using End = ChildEnd;

  /// Errors as startChild(); refused when there is no memory for a stream, or no stream.
  static Result<ChildProcess> start(const std::vector<std::string>& words, const Options& options);
  /// Waits until the program has ended, unless it goes on without us.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  /// Empty while it runs. Does not wait.
  std::optional<End> poll() { return look(false); }
  End wait() { return *look(true); }
  /// The end of what it wrote to its standard error, at most so much, without trailing blanks.
  std::string errorOutput(std::size_t most_bytes = 65536) const;
  /// How much that is so far, in memory of ours.
  std::uint64_t errorBytes() const;

  /// Our end of what Options::ours names, closed with this: a pipe to read its output from, or a
  /// socket to send() its input to, which needs no SIGPIPE. -1: none, or closed.
  int stream() const { return stream_; }
  /// The end of its input; or its output is wanted no more.
  void closeStream();

 private:
  ChildProcess() = default;
  std::optional<End> look(bool wait);
  void swap(ChildProcess& other);

  pid_t process_ = -1;
  int error_output_ = -1;  ///< a file in memory
  int stream_ = -1;
  int last_signal_ = SIGTERM;
  End end_;
};

/// The program of this name in the folder of the one that runs; the name alone, for PATH, when it
/// is not there.
std::string programBeside(const std::string& name);

/// Several lines as one, "; " between them, safe to print.
std::string onOneLine(std::string text);

}  // namespace rocinante
