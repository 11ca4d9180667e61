// A real robot's motion through the real programs: source, record, play, record again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/foreign/table/csv_line.h"
#include "core/log/log_reader.h"
#include "core/packet/packet_text.h"
#include "player/source/csv_motion.h"
#include "tests/support/programs.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

using test::Program;
using test::ProgramResult;

constexpr const char* kPanda = "recordings/panda_exciting_trajectory/panda_joints.csv";

struct Recorded {
  std::vector<std::string> payloads;
  std::vector<LogTime> times;
};

Recorded readLog(const std::filesystem::path& path) {
  Recorded recorded;
  auto reader = LogReader::open(path);
  EXPECT_TRUE(reader.ok());
  if (!reader.ok()) return recorded;
  while (true) {
    const auto message = reader->next();
    EXPECT_TRUE(message.ok());
    if (!message.ok() || !*message) return recorded;
    if (!(*message)->channel->captured()) continue;
    recorded.payloads.emplace_back(textOf((*message)->payload));
    recorded.times.push_back((*message)->log_time);
  }
}

/// A recorder at a free port of this machine.
class Recording {
 public:
  explicit Recording(const std::filesystem::path& log)
      : program_(Program::start("rocinante-record", {"127.0.0.1:0", "-o", log.string()})) {
    const std::string line = program_.waitForLine("recording udp://");
    const std::size_t begin = line.find("udp://");
    if (begin != line.npos) endpoint_ = line.substr(begin, line.find(' ', begin) - begin);
  }
  const std::string& endpoint() const { return endpoint_; }
  void end() {
    const ProgramResult result = program_.stop();
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }

 private:
  Program program_;
  std::string endpoint_;
};

nlohmann::json runSender(const std::string& name, const std::vector<std::string>& arguments) {
  const ProgramResult result = test::runProgram(name, arguments, {}, Program::Milliseconds(90'000));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  auto report = nlohmann::json::parse(result.out, nullptr, false);
  EXPECT_FALSE(report.is_discarded()) << result.out;
  return report;
}

std::string sha256Of(const std::vector<std::string>& payloads) {
  Sha256 hash;
  for (const std::string& payload : payloads) hash.add(bytesOf(payload));
  return hexOf(hash.finish());
}

/// Time errors of the arrivals of `later` against those of `first` played at `speed`, in
/// microseconds, relative to the median, so that the transit time of the first one does not count.
struct TimingError {
  double p50, p99, max;
};
TimingError timingError(const std::vector<Nanoseconds>& schedule, const std::vector<LogTime>& came,
                        double speed) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < came.size(); ++i) {
    const auto due = static_cast<double>((schedule[i] - schedule[0]).count()) / speed;
    errors.push_back((static_cast<double>((came[i] - came[0]).count()) - due) / 1e3);
  }
  std::vector<double> sorted = errors;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  for (double& error : errors) error = std::abs(error - median);
  std::sort(errors.begin(), errors.end());
  return {errors[errors.size() / 2], errors[errors.size() * 99 / 100], errors.back()};
}

void show(const std::string& what, const nlohmann::json& report, const TimingError& error) {
  fmt::print(
      "{:<12} sent {} at {:.0f}/s; sender late p50 {} p99 {} max {} us, drift {:.1f} us "
      "({}, {}); arrival off by p50 {:.1f} p99 {:.1f} max {:.1f} us\n",
      what, report["sent"].get<int>(), report["achieved_rate_hz"].get<double>(),
      report["late_us"]["p50"].get<int>(), report["late_us"]["p99"].get<int>(),
      report["late_us"]["max"].get<int>(), report["drift_us"].get<double>(),
      report["timing_source"].get<std::string>(), report["scheduling"].get<std::string>(),
      error.p50, error.p99, error.max);
}

bool isRestated(const std::string& payload) {
  return payload.find(" restated") < payload.find('\n');
}

/// The numbers of a row as a source sends them: nine decimals without trailing zeros.
std::string sentText(const std::string& row) {
  std::string text;
  std::istringstream fields(row);
  for (std::string field; std::getline(fields, field, ',');) {
    std::string number = fmt::format("{:.9f}", std::stod(field));
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.')) number.pop_back();
    text += (text.empty() ? "" : ",") + (number == "-0" ? "0" : number);
  }
  return text;
}

/// The rows of the file, parsed independently of the source.
void expectEveryRowInOrder(const std::vector<std::string>& payloads, const std::string& csv) {
  std::size_t next = 0;
  std::string_view rest = csv;
  takeLine(rest);
  PacketTextDecoder decoder;
  for (const std::string& payload : payloads) {
    const std::size_t body = payload.find("\njoints panda ");
    if (body == payload.npos || isRestated(payload)) continue;
    std::string row(takeLine(rest).value_or("missing"));
    std::string said = payload.substr(body + std::string_view("\njoints panda ").size());
    said.pop_back();
    std::replace(said.begin(), said.end(), ' ', ',');
    ASSERT_EQ(sentText(row.substr(row.find(',') + 1)), said) << "row " << next;
    const PacketHeader* header = decoder.decodeHeader(bytesOf(payload));
    ASSERT_NE(header, nullptr);
    // The file gives six decimals.
    const std::string time = row.substr(0, row.find(','));
    EXPECT_EQ(header->time_ns,
              std::stoll(time.substr(0, time.find('.')) + time.substr(time.find('.') + 1)) * 1000);
    ++next;
  }
  EXPECT_EQ(next, 20'544U);
}

/// Sends the file at `source_speed` into a log and plays that at each of `speeds`.
void checkSession(const std::string& source_speed, const std::vector<std::string>& speeds) {
  const test::TemporaryFolder folder;
  const std::string csv = readFile(test::sharedData(kPanda)).value();
  const auto motion = readCsvMotion(csv, "panda_joints.csv", "panda", {}).value();

  Recording first(folder / "first.mcap");
  const auto sent = runSender(
      "rocinante-source", {"--csv", test::sharedData(kPanda).string(), "--device", "panda", "--to",
                           first.endpoint(), "--speed", source_speed, "--json"});
  first.end();
  const Recorded session = readLog(folder / "first.mcap");
  ASSERT_EQ(sent["sent"], 20'545);
  ASSERT_EQ(session.payloads.size(), 20'545U + sent["restatements"].get<std::size_t>());
  expectEveryRowInOrder(session.payloads, csv);

  std::vector<Nanoseconds> rows;
  std::vector<LogTime> arrivals;
  for (std::size_t i = 0; i < session.payloads.size(); ++i) {
    if (session.payloads[i].find("\njoints panda ") == std::string::npos) continue;
    if (isRestated(session.payloads[i])) continue;
    rows.push_back(motion.times[rows.size()]);
    arrivals.push_back(session.times[i]);
  }
  show("source " + source_speed + "x", sent, timingError(rows, arrivals, std::stod(source_speed)));

  std::vector<Nanoseconds> schedule;
  for (const LogTime time : session.times) schedule.push_back(time - session.times[0]);
  for (const std::string& speed : speeds) {
    SCOPED_TRACE(speed);
    const auto log = folder / (speed + ".mcap");
    Recording again(log);
    const auto played =
        runSender("rocinante-play", {(folder / "first.mcap").string(), "--to", again.endpoint(),
                                     "--speed", speed, "--report", "-"});
    again.end();
    const Recorded replay = readLog(log);
    ASSERT_EQ(replay.payloads.size(), session.payloads.size());
    EXPECT_TRUE(replay.payloads == session.payloads);
    EXPECT_EQ(played["sent"], session.payloads.size());
    EXPECT_EQ(played["stream_sha256"], sha256Of(session.payloads));
    EXPECT_EQ(played["spans"].size(), 1U);
    EXPECT_EQ(played["spans"][0]["from_ns"], session.times.front().time_since_epoch().count());
    EXPECT_EQ(played["spans"][0]["until_ns"], session.times.back().time_since_epoch().count() + 1);
    EXPECT_GE(played["restatements"], 1);
    const TimingError error = timingError(schedule, replay.times, std::stod(speed));
    show("play " + speed + "x", played, error);
    // A machine without real-time scheduling, busy with other tests, is allowed this much.
    EXPECT_LT(error.p50, 10'000);
  }
}

TEST(PandaSession, ComesBackByteForByteAtEverySpeed) {
  ROCINANTE_NEEDS_SHARED_DATA(kPanda);
  // Ten times faster than it was recorded: two seconds instead of twenty-one.
  checkSession("10", {"1", "3", "10"});
}

TEST(PandaSession, ComesBackByteForByteInItsOwnTime) {
  if (std::getenv("ROCINANTE_LONG") == nullptr) {
    GTEST_SKIP() << "takes 55 s; ROCINANTE_LONG=1 runs it";
  }
  ROCINANTE_NEEDS_SHARED_DATA(kPanda);
  checkSession("1", {"1", "3", "10"});
}

}  // namespace
}  // namespace rocinante
