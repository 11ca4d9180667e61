// Clearances of a long session: 10 minutes at 50 Hz of a cell of 10 devices and 50,000 triangles,
// three arms and a sled that all move among six bodies that do not. CPU of one thread, beside a
// check of the same session without clearances; and over its first steps the distance between all
// links at each, and where that is below the allowed one at four moments of each step, which must
// not be below what the check reports. usage: clearance_bench [SECONDS]
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/check/check.h"
#include "core/clearance/clearance_session.h"
#include "core/log/log_writer.h"
#include "core/math/transform.h"
#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"
#include "tests/bench/bench_support.h"

namespace {

using namespace rocinante;

constexpr std::int64_t kOriginNs = 1'770'091'506'000'000'000;
constexpr std::int64_t kRateHz = 50;
constexpr double kBarSeconds = 10, kExact_m = 1e-4;
constexpr std::int64_t kComparedSteps = 12;
constexpr int kArms = 3, kLinks = 6;

/// A round body with dents, along x: 2 * around * along triangles.
void writeBody(const std::filesystem::path& path, double length, double radius, int around,
               int along) {
  std::ofstream out(path);
  for (int i = 0; i <= along; ++i) {
    const double share = static_cast<double>(i) / along;
    const double bulge = radius * std::sqrt(std::max(0.02, 1 - std::pow(2 * share - 1, 6)));
    for (int j = 0; j < around; ++j) {
      const double angle = 6.283185307179586 * j / around;
      const double r = bulge * (1 + 0.1 * std::sin(5 * angle) * std::sin(20 * share));
      out << fmt::format("v {:.6f} {:.6f} {:.6f}\n", length * share, r * std::cos(angle),
                         r * std::sin(angle));
    }
  }
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const int a = i * around + j + 1, b = i * around + (j + 1) % around + 1;
      out << fmt::format("f {} {} {}\nf {} {} {}\n", a, b, b + around, a, b + around, a + around);
    }
  }
}

std::string linkWith(const std::string& name, const std::string& mesh) {
  return fmt::format(
      "<link name=\"{}\"><visual><geometry><mesh filename=\"{}\"/></geometry></visual></link>\n",
      name, mesh);
}

void writeCell(const std::filesystem::path& folder) {
  writeBody(folder / "limb.obj", 0.45, 0.07, 32, 24);  // 1,536 triangles
  writeBody(folder / "tank.obj", 1.2, 0.3, 48, 32);    // 3,072
  std::ofstream arm(folder / "arm.urdf");
  arm << "<robot name=\"arm\">" << linkWith("link0", "limb.obj");
  for (int i = 0; i < kLinks; ++i) {
    arm << linkWith(fmt::format("link{}", i + 1), "limb.obj")
        << fmt::format(
               "<joint name=\"j{0}\" type=\"revolute\"><parent link=\"link{0}\"/><child "
               "link=\"link{1}\"/><origin xyz=\"0.5 0 0\"/><axis xyz=\"{2}\"/><limit lower=\"-3\" "
               "upper=\"3\" effort=\"1\" velocity=\"9\"/></joint>\n",
               i, i + 1, i % 2 == 0 ? "0 0 1" : "0 1 0");
  }
  arm << "</robot>\n";
  std::ofstream sled(folder / "sled.urdf");
  sled << "<robot name=\"sled\"><link name=\"rail\"/>" << linkWith("sled", "tank.obj")
       << "<joint name=\"x\" type=\"prismatic\"><parent link=\"rail\"/><child link=\"sled\"/><axis "
          "xyz=\"1 0 0\"/><limit lower=\"-9\" upper=\"9\" effort=\"1\" "
          "velocity=\"9\"/></joint></robot>\n";
  std::ofstream(folder / "tank.urdf")
      << "<robot name=\"tank\">" << linkWith("tank", "tank.obj") << "</robot>\n";
  std::ofstream cell(folder / "cell.toml");
  cell << "format = 1\n";
  const auto device = [&](const std::string& name, const std::string& model, double x, double y,
                          double z) {
    cell << fmt::format(
        "[[device]]\nname = \"{}\"\nmodel = \"{}.urdf\"\npose = {{ xyz = [{}, {}, {}] }}\n", name,
        model, x, y, z);
  };
  for (int i = 0; i < kArms; ++i) device(fmt::format("arm{}", i), "arm", 0, 2.5 * i, 1);
  device("sled", "sled", 0, 1.2, -1);
  for (int i = 0; i < 6; ++i)
    device(fmt::format("tank{}", i), "tank", i % 2 == 0 ? 2.5 : -2.5, 1.6 * i - 2, 0.5);
  std::ofstream(folder / "without.toml") << std::ifstream(folder / "cell.toml").rdbuf();
  cell << "[[clearance]]\nbetween = [\"*\", \"*\"]\nmin_m = 0.02\n"
          "[[clearance]]\nself = \"arm*\"\nmin_m = 0.01\n";
  cell.close();
  std::ifstream whole(folder / "cell.toml");
  std::string text((std::istreambuf_iterator<char>(whole)), {});
  std::ofstream(folder / "without.toml") << text.substr(0, text.find("[[clearance]]"));
}

std::string joints(int device, double t) {
  if (device == kArms) return fmt::format("joints sled {:.5f}\n", 2 * std::sin(0.3 * t));
  std::string text = fmt::format("joints arm{}", device);
  for (int joint = 0; joint < kLinks; ++joint) {
    text += fmt::format(" {:.5f}", 0.7 * std::sin(t * (0.5 + 0.11 * joint) + joint + device));
  }
  return text + "\n";
}

void writeLog(const std::filesystem::path& path, std::int64_t packets) {
  SessionWriter writer(bench::need(LogWriter::create(path, {}, "clearance bench")), {});
  std::vector<ChannelId> channels;
  for (int i = 0; i <= kArms; ++i) {
    channels.push_back(bench::need(writer.addChannel(fmt::format("/udp/19960/s{}", i), "rk1", {})));
  }
  for (std::int64_t i = 0; i < packets; ++i) {
    const std::int64_t ns = i * 1'000'000'000 / kRateHz;
    for (int device = 0; device <= kArms; ++device) {
      const std::int64_t at = ns + device * 3'000'000;
      const std::string text = fmt::format("RK1 s{}@7f3a {} -\n{}", device, i,
                                           joints(device, static_cast<double>(at) * 1e-9));
      bench::need(writer.write(channels[static_cast<std::size_t>(device)],
                               static_cast<std::uint32_t>(i), LogTime(Nanoseconds(kOriginNs + at)),
                               kOriginNs + at, bytesOf(text)));
    }
  }
  bench::need(writer.log().close("done"));
}

CheckReport checked(const std::filesystem::path& folder, const char* name, double& seconds) {
  const Cell cell = bench::need(loadCell(folder / name, {}));
  LogReader log = bench::need(LogReader::open(folder / "session.mcap"));
  const double began = bench::processSeconds();
  CheckReport report = bench::need(checkLog(cell, log));
  seconds = bench::processSeconds() - began;
  return report;
}

/// Distances of all pairs of links at the first steps; and at three moments between, for those
/// below the allowed distance.
bool agreesWithAllPairs(const Cell& cell) {
  ClearanceJudge judge(cell);
  SessionState state;
  const auto decoder = makeDecoder("rk1");
  std::map<std::pair<std::string, std::string>, double> least;
  BodyStore bodies;
  std::vector<ClearancePair> pairs;
  CellPlacement before;
  std::vector<TreeContact> contacts;
  const auto measureAll = [&](const CellPlacement& now, bool is_between) {
    contacts.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const ClearancePair& pair = pairs[i];
      const auto place = [&](LinkId id) { return now.devices[id.device].link_world[id.link]; };
      double& known =
          least.try_emplace({now.devices[pair.a.device].name, now.devices[pair.b.device].name}, 1e9)
              .first->second;
      contacts[i] = treeDistance(*pair.body_a, *pair.body_b,
                                 inverseOfRigid(place(pair.b)) * place(pair.a), &contacts[i]);
      const double apart = contacts[i].distance_m;
      if (is_between && apart >= cell.clearances[pair.clearance].min_m) continue;
      known = std::min(known, apart);
    }
  };
  for (std::int64_t i = 0; i < kComparedSteps; ++i) {
    std::string text = fmt::format("RK1 s@7f3a {} -\n", i);
    for (int device = 0; device <= kArms; ++device) {
      text += joints(device, static_cast<double>(i) / kRateHz);
    }
    state.apply(LogTime(Nanoseconds(i * 20'000'000)), *decoder->decode(bytesOf(text)));
    const PosedScene scene = poseScene(cell, state);
    CellPlacement now = placementOf(scene, state);
    if (i == 0) {
      judge.begin({}, scene, now);
      pairs = clearancePairs(cell, scene, now, bodies).pairs;
    } else {
      judge.step(LogTime(Nanoseconds(i * 20'000'000)), now);
      const CellPlacement middle = halfWay(before, now);
      measureAll(halfWay(before, middle), true);
      measureAll(middle, true);
      measureAll(halfWay(middle, now), true);
    }
    measureAll(now, false);
    before = std::move(now);
  }
  double worst = 0;
  for (const ClearanceOutcome& outcome : judge.outcomes()) {
    const double expected = least.at({outcome.device_a, outcome.device_b});
    worst = std::max(worst, outcome.least.distance_m - expected);
  }
  fmt::print("all pairs of links    at most {:.4f} mm nearer than reported, {} of them\n",
             worst * 1e3, pairs.size());
  return worst <= kExact_m;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t seconds = argc > 1 ? std::atoll(argv[1]) : 600;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("clearance_bench_{}", ::getpid());
  std::filesystem::create_directories(folder);
  writeCell(folder);
  writeLog(folder / "session.mcap", seconds * kRateHz);
  double with = 0, without = 0;
  const CheckReport report = checked(folder, "cell.toml", with);
  checked(folder, "without.toml", without);
  const Cell cell = bench::need(loadCell(folder / "cell.toml", {}));
  std::size_t triangles = 0, near = 0;
  for (const CellDevice& device : cell.devices) {
    for (const Link& link : cell.modelOf(device)->links) {
      for (const Visual& visual : link.visuals) triangles += visual.mesh->triangleCount();
    }
  }
  for (const CheckedClearance& each : report.clearances) near += each.violations;
  fmt::print("{} devices, {} triangles, {} s at {} Hz, {} violations\n", cell.devices.size(),
             triangles, seconds, kRateHz, near);
  fmt::print("check without         {:6.2f} s\n", without);
  fmt::print("check with clearances {:6.2f} s\n", with);
  const bool is_exact = agreesWithAllPairs(cell);
  if (seconds == 600) {
    fmt::print("bar                   {:6.2f} s   {}\n", kBarSeconds,
               with <= kBarSeconds && is_exact ? "met" : "MISSED");
  }
  std::filesystem::remove_all(folder);
  return is_exact ? 0 : 1;
}
