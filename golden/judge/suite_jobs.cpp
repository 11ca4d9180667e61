#include "golden/judge/suite_jobs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "core/base/child_process.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxMessageBytes = std::uint64_t{4} << 30U;
/// A context and its uploads cost as much as this many small frames.
constexpr std::size_t kFramesThatPayForAJob = 12;

/// Shared by parent and jobs: the next frame in log order.
struct Shared {
  std::atomic<std::uint32_t> next{0};
  std::atomic<bool> stop{false};
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "shared between processes");

class SharedMemory {
 public:
  SharedMemory() {
    void* memory =
        ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED) shared_ = new (memory) Shared;
  }
  ~SharedMemory() {
    if (shared_ != nullptr) ::munmap(shared_, sizeof(Shared));
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  Shared* get() const { return shared_; }

 private:
  Shared* shared_ = nullptr;
};

/// Header of each message: its frame and length.
struct MessageHead {
  enum Kind : std::uint32_t { begun, judged, failed, finished };
  std::uint32_t kind = begun;
  std::uint32_t place = 0;
  std::uint64_t bytes = 0;
};

bool writeFully(int pipe, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(pipe, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool send(int pipe, MessageHead::Kind kind, std::size_t place, ByteView body) {
  const MessageHead head{kind, static_cast<std::uint32_t>(place), body.size()};
  return writeFully(pipe, &head, sizeof head) && writeFully(pipe, body.data(), body.size());
}

/// Main function of a job: judges the next frame until none is left.
void workInJob(SuiteSession& session, const std::vector<std::size_t>& order, Shared& shared,
               int pipe) {
  while (!shared.stop.load()) {
    const std::uint32_t turn = shared.next.fetch_add(1);
    if (turn >= order.size()) break;
    const std::size_t place = order[turn];
    if (!send(pipe, MessageHead::begun, place, {})) return;
    const auto judged = session.judge(session.frames()[place]);
    if (!judged.ok()) {
      shared.stop.store(true);
      send(pipe, MessageHead::failed, place, bytesOf(judged.error().text()));
      return;
    }
    if (!send(pipe, MessageHead::judged, place, wireBytes(*judged))) return;
  }
  send(pipe, MessageHead::finished, 0, {});
}

/// The parent's data of a job.
struct Job {
  ::pid_t pid = -1;
  int pipe = -1;
  Bytes received;
  std::optional<std::size_t> at;  ///< the frame being judged
  bool finished = false;
};

/// Collects the results of jobs and reports them in suite order.
class Gatherer {
 public:
  Gatherer(const SuiteSession& session, const JobOptions& options)
      : session_(session),
        options_(options),
        judged_(session.frames().size()),
        done_(session.frames().size()) {}

  void put(std::size_t place, JudgedFrame judged) {
    judged_[place] = std::move(judged);
    done_[place] = true;
    ++count_;
    if (options_.progress) options_.progress(count_, judged_.size());
    for (; reported_ < judged_.size() && done_[reported_]; ++reported_) {
      if (options_.tell) options_.tell(judged_[reported_]);
    }
  }

  /// A frame's data before it is judged.
  JudgedFrame begin(std::size_t place) const {
    JudgedFrame judged;
    judged.frame = session_.frames()[place];
    judged.tolerance = judged.frame.suite_case->tolerance;
    judged.limit_from = judged.frame.suite_case->limit_from;
    judged.session = session_.sessionHash();
    judged.decoded = session_.decodedHash();
    judged.own_masks = judged.frame.suite_case->mask.size();
    if (judged.frame.suite_case->expect_different) {
      judged.expectation = judged.frame.suite_case->reason;
    }
    return judged;
  }

  void giveUp(std::size_t place, std::string why) {
    JudgedFrame judged = begin(place);
    judged.rule = std::move(why);
    put(place, std::move(judged));
  }

  bool has(std::size_t place) const { return done_[place]; }
  std::vector<JudgedFrame> take() { return std::move(judged_); }

 private:
  const SuiteSession& session_;
  const JobOptions& options_;
  std::vector<JudgedFrame> judged_;
  std::vector<bool> done_;
  std::size_t count_ = 0, reported_ = 0;
};

class JobRunner {
 public:
  JobRunner(SuiteSession& session, const JobOptions& options)
      : session_(session),
        options_(options),
        order_(inLogOrder(session.frames())),
        gatherer_(session, options) {}

  ~JobRunner() {
    for (Job& job : jobs_) {
      if (job.pipe >= 0) ::close(job.pipe);
      if (job.pid <= 0) continue;
      if (job.finished) {
        ::waitpid(job.pid, nullptr, WNOHANG);
        continue;
      }
      ::kill(job.pid, SIGKILL);
      waitForChild(job.pid);
    }
  }

  Result<std::vector<JudgedFrame>> run() {
    if (memory_.get() == nullptr) {
      return Error{ErrorKind::refused, "no memory to share with jobs", {}};
    }
    if (auto started = startJobs(); !started) return started.error();
    while (std::ranges::any_of(jobs_, [](const Job& job) { return job.pipe >= 0; })) {
      if (options_.stop && options_.stop()) return interrupted();
      if (auto received = receiveSome(); !received) return received.error();
    }
    if (options_.stop && options_.stop()) return interrupted();
    for (std::size_t place = 0; place < order_.size(); ++place) {
      if (!gatherer_.has(place)) gatherer_.giveUp(place, "every job died before judging it");
    }
    return gatherer_.take();
  }

  Error interrupted() const {
    return {ErrorKind::refused, "interrupted: nothing was judged", session_.suite().file.string()};
  }

 private:
  Status startJobs() {
    std::fflush(nullptr);  // each job would write the buffered output again
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    const unsigned threads = std::max(1U, processors / static_cast<unsigned>(options_.jobs));
    for (int i = 0; i < options_.jobs; ++i) {
      std::array<int, 2> ends{};
      if (::pipe2(ends.data(), O_CLOEXEC) != 0) return cannotStart();
      const ::pid_t pid = ::fork();
      if (pid < 0) {
        ::close(ends[0]);
        ::close(ends[1]);
        return cannotStart();
      }
      if (pid == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::close(ends[0]);
        // Divide the cores among the jobs, so that their threads do not compete.
        ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
        workInJob(session_, order_, *memory_.get(), ends[1]);
        ::_exit(0);
      }
      ::close(ends[1]);
      jobs_.emplace_back();
      jobs_.back().pid = pid;
      jobs_.back().pipe = ends[0];
    }
    return {};
  }

  static Error cannotStart() {
    return {ErrorKind::refused, std::string("cannot start a job: ") + std::strerror(errno), {}};
  }

  Status receiveSome() {
    std::vector<::pollfd> waiting;
    std::vector<Job*> whose;
    for (Job& job : jobs_) {
      if (job.pipe < 0) continue;
      waiting.push_back({job.pipe, POLLIN, 0});
      whose.push_back(&job);
    }
    // Short enough to answer Ctrl-C promptly.
    if (::poll(waiting.data(), waiting.size(), 200) < 0 && errno != EINTR) {
      return Error{ErrorKind::refused, std::string("cannot wait: ") + std::strerror(errno), {}};
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].revents == 0) continue;
      if (auto received = receive(*whose[i]); !received) return received;
    }
    return {};
  }

  Status receive(Job& job) {
    std::array<std::byte, 1 << 16> buffer;
    const ssize_t got = ::read(job.pipe, buffer.data(), buffer.size());
    if (got < 0) return {};  // interrupted: poll reports the data again
    if (got == 0) {
      ended(job);
      return {};
    }
    job.received.insert(job.received.end(), buffer.begin(), buffer.begin() + got);
    std::size_t used = 0;
    while (job.received.size() - used >= sizeof(MessageHead)) {
      MessageHead head;
      std::memcpy(&head, job.received.data() + used, sizeof head);
      if (head.place >= order_.size() || head.bytes > kMaxMessageBytes) {
        return Error{ErrorKind::damaged, "a job sent an invalid message", {}};
      }
      if (job.received.size() - used - sizeof head < head.bytes) break;
      const ByteView body(job.received.data() + used + sizeof head, head.bytes);
      if (auto taken = take(job, head, body); !taken) return taken;
      used += sizeof head + head.bytes;
    }
    job.received.erase(job.received.begin(),
                       job.received.begin() + static_cast<std::ptrdiff_t>(used));
    // Do not wait for its exit: Mesa's lowest-priority threads may take seconds to end on a busy
    // machine.
    if (job.finished) ::close(std::exchange(job.pipe, -1));
    return {};
  }

  Status take(Job& job, const MessageHead& head, ByteView body) {
    switch (head.kind) {
      case MessageHead::begun:
        job.at = head.place;
        return {};
      case MessageHead::judged: {
        JudgedFrame judged = gatherer_.begin(head.place);
        if (auto read = readWire(body, judged); !read) return read;
        gatherer_.put(head.place, std::move(judged));
        job.at.reset();
        return {};
      }
      case MessageHead::failed:
        return Error{ErrorKind::refused, std::string(textOf(body)), {}};
      case MessageHead::finished:
        job.finished = true;
        return {};
      default:
        return Error{ErrorKind::damaged, "a job sent an invalid message", {}};
    }
  }

  void ended(Job& job) {
    ::close(std::exchange(job.pipe, -1));
    const ChildEnd end = waitForChild(std::exchange(job.pid, -1));
    if (job.at) {
      gatherer_.giveUp(*job.at, fmt::format("the job that drew it died ({})", end.text()));
    }
  }

  SuiteSession& session_;
  const JobOptions& options_;
  std::vector<std::size_t> order_;
  Gatherer gatherer_;
  SharedMemory memory_;
  std::vector<Job> jobs_;
};

}  // namespace

Result<std::vector<JudgedFrame>> judgeAll(SuiteSession& session, const JobOptions& options) {
  const int jobs = static_cast<int>(std::min<std::size_t>(
      static_cast<std::size_t>(std::max(1, options.jobs)), session.frames().size()));
  JobOptions own = options;
  own.jobs = jobs;
  if (jobs > 1) return JobRunner(session, own).run();
  Gatherer gatherer(session, own);
  for (const std::size_t place : inLogOrder(session.frames())) {
    if (own.stop && own.stop()) {
      return Error{ErrorKind::refused, "interrupted: nothing was judged",
                   session.suite().file.string()};
    }
    auto judged = session.judge(session.frames()[place]);
    if (!judged.ok()) return judged.error();
    gatherer.put(place, std::move(*judged));
  }
  return gatherer.take();
}

int usefulJobs(std::size_t frames, unsigned processors) {
  const std::size_t jobs = std::min<std::size_t>(std::max(1U, processors), 16);
  return static_cast<int>(std::clamp<std::size_t>(frames / kFramesThatPayForAJob, 1, jobs));
}

}  // namespace rocinante
