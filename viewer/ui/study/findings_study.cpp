#include "viewer/ui/study/findings_study.h"

#include <utility>

#include "core/check/check.h"

namespace rocinante {

FindingsStudy::FindingsStudy(const Cell& cell, std::filesystem::path log)
    : worker_([this, &cell](const std::filesystem::path& path,
                            const std::stop_token& stop) -> Result<CheckReport> {
        auto reader = LogReader::open(path);
        if (!reader.ok()) return reader.error();
        auto judged = checkLog(cell, *reader, [&](double part) {
          done_ = part;
          return !stop.stop_requested();
        });
        done_ = 1;
        return judged;
      }) {
  worker_.ask(std::move(log));
}

const CheckReport* FindingsStudy::report() const {
  // Nothing else is asked: the worker keeps it.
  const auto found = worker_.found();
  return found && found->ok() ? &**found : nullptr;
}

std::string FindingsStudy::fault() const {
  const auto found = worker_.found();
  return found && !found->ok() ? found->error().text() : std::string();
}

}  // namespace rocinante
