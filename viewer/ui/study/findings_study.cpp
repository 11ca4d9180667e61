#include "viewer/ui/study/findings_study.h"

#include <atomic>
#include <thread>
#include <utility>

#include "core/check/check.h"
#include "viewer/ui/study/study_thread.h"

namespace rocinante {

struct FindingsStudy::Impl {
  Impl(const Cell& the_cell, std::filesystem::path path) : cell(the_cell), log(std::move(path)) {}

  void work(const std::stop_token& stop) {
    lowerPriority();
    auto reader = LogReader::open(log);
    if (reader.ok()) {
      auto judged = checkLog(cell, *reader, [&](double part) {
        done = part;
        return !stop.stop_requested();
      });
      if (judged.ok()) {
        report = std::move(*judged);
      } else {
        fault = judged.error().text();
      }
    } else {
      fault = reader.error().text();
    }
    done = 1;
    finished = true;
    finished.notify_all();
  }

  const Cell& cell;
  std::filesystem::path log;
  std::atomic<double> done{0};
  std::atomic<bool> finished{false};
  // Written before `finished`, read after it.
  CheckReport report;
  std::string fault;
  std::jthread thread;  // last: it ends first
};

FindingsStudy::FindingsStudy(const Cell& cell, std::filesystem::path log)
    : impl_(std::make_unique<Impl>(cell, std::move(log))) {
  Impl& my = *impl_;
  my.thread = std::jthread([&my](const std::stop_token& stop) { my.work(stop); });
}

FindingsStudy::~FindingsStudy() = default;

double FindingsStudy::progress() const { return impl_->done; }
bool FindingsStudy::isFinished() const { return impl_->finished; }
void FindingsStudy::wait() { impl_->finished.wait(false); }

const CheckReport* FindingsStudy::report() const {
  return impl_->finished && impl_->fault.empty() ? &impl_->report : nullptr;
}

std::string FindingsStudy::fault() const { return impl_->finished ? impl_->fault : std::string(); }

}  // namespace rocinante
