// Importing a ROS 2 MCAP of six-joint JointStates with full doubles into a log with keyframes: of
// positions alone its CPU beside a bare loop that reads the same messages, prints the same text and
// writes both into a log without fold and checks; then of positions, velocities and efforts.
// usage: import_bench [MESSAGES [FOLDER]]
// import_bench --memory GB [FOLDER]: imports a bag of that size (joint states, and pictures of 1 MB
// that do not compress), and prints the most memory that the process ever had. Needs 2 GB of disk
// for each.
// import_bench --bag GB FILE: makes a bag of that size, half of it joint states (tests/memory/run).
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>
#include <string_view>

#include "core/foreign/ros/bag_import.h"
#include "core/log/log_reader.h"
#include "core/log/new_log_file.h"
#include "core/mcap/writer.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;

constexpr int kRuns = 3;
constexpr std::size_t kJoints = 6;
constexpr const char* kNames[kJoints] = {"shoulder_pan_joint", "shoulder_lift_joint",
                                         "elbow_joint",        "wrist_1_joint",
                                         "wrist_2_joint",      "wrist_3_joint"};

/// CDR, little-endian.
class Cdr {
 public:
  template <class T>
  void number(T value) {
    while ((bytes.size() - 4) % sizeof(T) != 0) bytes.push_back(std::byte{0});
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(T));
    std::memcpy(bytes.data() + at, &value, sizeof(T));
  }
  void string(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    const ByteView raw = bytesOf(text);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
    bytes.push_back(std::byte{0});
  }
  Bytes bytes{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
};

Bytes jointState(std::size_t i, std::int64_t time_ns, int quantities) {
  Cdr made;
  made.number(static_cast<std::int32_t>(time_ns / 1'000'000'000));
  made.number(static_cast<std::uint32_t>(time_ns % 1'000'000'000));
  made.string("");
  made.number(static_cast<std::uint32_t>(kJoints));
  for (const char* const name : kNames) made.string(name);
  for (int part = 0; part < 3; ++part) {
    made.number(static_cast<std::uint32_t>(part < quantities ? kJoints : 0));
    if (part >= quantities) continue;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const auto angle = static_cast<double>(i) * 1e-4 * static_cast<double>(joint + 1);
      made.number(part == 0 ? 1.7 * std::sin(angle) : part == 1 ? 0.3 * std::cos(angle) : 0.0);
    }
  }
  return made.bytes;
}

/// What a bag has beside its joint states, and how it is stored.
struct BagShape {
  std::size_t picture_bytes = 0;   ///< 0: no pictures
  std::size_t picture_every = 10;  ///< joint states
  bool compressed = true;
  int quantities = 3;  ///< of joints: positions, velocities, efforts
};

/// Streamed to the file.
void makeBag(const std::filesystem::path& path, std::size_t messages, const BagShape& shape = {}) {
  Result<NewLogFile> file = NewLogFile::make(path, true);
  mcap::WriterOptions options;
  if (!shape.compressed) options.zstd_level.reset();
  Result<mcap::Writer> writer = mcap::Writer::start(file->takeSink(), options, {"ros2", "bench"});
  writer->addSchema({1, "sensor_msgs/msg/JointState", "ros2msg", {}});
  writer->addChannel({0, 1, "/joint_states", "cdr", {}});
  if (shape.picture_bytes > 0) writer->addChannel({1, 0, "/camera", "cdr", {}});
  Bytes picture(shape.picture_bytes);
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < messages; ++i) {
    const auto time = static_cast<std::int64_t>(1'770'091'506'000'000'000 + i * 2'000'000);
    const Bytes payload = jointState(i, time - 150'000, shape.quantities);
    mcap::Message message;
    message.sequence = static_cast<std::uint32_t>(i);
    message.log_time = static_cast<std::uint64_t>(time);
    message.publish_time = static_cast<std::uint64_t>(time);
    message.data = payload;
    (void)writer->write(message);
    if (picture.empty() || (i + 1) % shape.picture_every != 0) continue;
    for (std::size_t at = 0; at + 8 <= picture.size(); at += 8) {
      const std::uint64_t bits = random();
      std::memcpy(picture.data() + at, &bits, sizeof bits);
    }
    message.channel_id = 1;
    message.data = picture;
    (void)writer->write(message);
  }
  (void)writer->finish();
  (void)file->publish();
}

/// Knows where everything is in these messages.
void bareLoop(const std::filesystem::path& bag, const std::filesystem::path& out) {
  Result<LogReader> reader = LogReader::open(bag);
  LogWriterOptions options;
  options.overwrite = true;
  Result<LogWriter> writer = LogWriter::create(out, options, "bare");
  const ChannelId copy = *writer->addChannel("/joint_states", "cdr", {});
  const ChannelId made = *writer->addChannel("/rocinante/decoded/joint_states", "rk1", {});
  // The positions follow the stamp, the frame, the names and their own count; the counts of the
  // other two follow them.
  const Bytes example = jointState(0, 0, 1);
  const std::size_t positions =
      example.size() - 2 * sizeof(std::uint32_t) - kJoints * sizeof(double);
  std::string text;
  while (true) {
    const Result<std::optional<LogMessage>> next = reader->next();
    if (!*next) break;
    const LogMessage& message = **next;
    std::int32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
    double values[kJoints];
    std::memcpy(&seconds, message.payload.data() + 4, sizeof seconds);
    std::memcpy(&nanoseconds, message.payload.data() + 8, sizeof nanoseconds);
    std::memcpy(values, message.payload.data() + positions, sizeof values);
    char digits[32];
    text = "RK1 decoded:ros:joint_states - ";
    const auto whole = std::to_chars(digits, digits + sizeof digits, seconds);
    text.append(digits, whole.ptr);
    const auto part = std::to_chars(digits, digits + sizeof digits, 1'000'000'000U + nanoseconds);
    digits[0] = '.';
    text.append(digits, part.ptr).append("\njoint robot");
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto number = std::to_chars(digits, digits + sizeof digits, values[i]);
      text.append(" ").append(kNames[i]).append("=").append(digits, number.ptr);
    }
    text += '\n';
    (void)writer->write(copy, message.sequence, message.log_time, message.publish_time_ns,
                        message.payload);
    (void)writer->write(made, message.sequence, message.log_time, message.publish_time_ns,
                        bytesOf(text));
  }
  (void)writer->close("bench");
}

void import(const std::filesystem::path& bag, const std::filesystem::path& out) {
  std::vector<std::unique_ptr<ros::BagReader>> bags;
  bags.push_back(std::move(*ros::openBag(bag)));
  Result<NewLogFile> file = NewLogFile::make(out, true);
  const auto report = ros::importBags(std::move(bags), file->takeSink(), "bench", {});
  if (!report) fmt::print("{}\n", report.error().text());
  (void)file->publish();
}

template <class Work>
double leastCpu(const Work& work) {
  double least = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    const double before = bench::processSeconds();
    work();
    least = std::min(least, bench::processSeconds() - before);
  }
  return least;
}

/// The most memory that the process ever had, in MB: all of it, with pages of files.
double peakMegabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 * 1e-6;
}

constexpr std::size_t kPictureBytes = 1'000'000;

/// As many bytes of joint states, with what MCAP adds, as of pictures.
int makeMixedBag(double gigabytes, const std::filesystem::path& bag) {
  constexpr double kStateBytes = 360;
  BagShape shape;
  shape.picture_bytes = kPictureBytes;
  shape.picture_every = static_cast<std::size_t>(kPictureBytes / kStateBytes);
  shape.compressed = false;
  makeBag(bag, static_cast<std::size_t>(gigabytes * 0.5e9 / kStateBytes), shape);
  return std::filesystem::exists(bag) ? 0 : 2;
}

int measureMemory(double gigabytes, const std::filesystem::path& folder) {
  const auto bag = folder / "import_bench_big.mcap";
  const auto out = folder / "import_bench_big_log.mcap";
  BagShape shape;
  shape.picture_bytes = kPictureBytes;
  makeBag(bag, static_cast<std::size_t>(gigabytes * 1e4), shape);
  const double before = peakMegabytes();
  import(bag, out);
  fmt::print("bag {:.2f} GB, log {:.2f} GB; peak memory {:.0f} MB ({:.0f} MB before the import)\n",
             static_cast<double>(std::filesystem::file_size(bag)) * 1e-9,
             static_cast<double>(std::filesystem::file_size(out)) * 1e-9, peakMegabytes(), before);
  std::filesystem::remove(bag);
  std::filesystem::remove(out);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string_view(argv[1]) == "--memory") {
    return measureMemory(std::strtod(argv[2], nullptr),
                         argc > 3 ? argv[3] : std::filesystem::temp_directory_path());
  }
  if (argc == 4 && std::string_view(argv[1]) == "--bag") {
    return makeMixedBag(std::strtod(argv[2], nullptr), argv[3]);
  }
  const std::size_t messages = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::filesystem::path folder = argc > 2 ? argv[2] : std::filesystem::temp_directory_path();
  const auto bag = folder / "import_bench_bag.mcap";
  const auto out = folder / "import_bench_log.mcap";
  BagShape positions_alone;
  positions_alone.quantities = 1;
  makeBag(bag, messages, positions_alone);
  const double bare_s = leastCpu([&] { bareLoop(bag, out); });
  const auto bare_bytes = std::filesystem::file_size(out);
  const double import_s = leastCpu([&] { import(bag, out); });
  const auto count = static_cast<double>(messages);
  fmt::print("bare loop  {:9.0f} messages/s  {:5.1f} bytes each\n", count / bare_s,
             static_cast<double>(bare_bytes) / count);
  fmt::print("import     {:9.0f} messages/s  {:5.1f} bytes each  {:.2f} of the bare loop's CPU\n",
             count / import_s, static_cast<double>(std::filesystem::file_size(out)) / count,
             import_s / bare_s);
  makeBag(bag, messages);
  const double signals_s = leastCpu([&] { import(bag, out); });
  fmt::print("  with velocities and efforts  {:9.0f} messages/s  {:5.1f} bytes each\n",
             count / signals_s, static_cast<double>(std::filesystem::file_size(out)) / count);
  std::filesystem::remove(bag);
  std::filesystem::remove(out);
}
