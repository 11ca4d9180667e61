#include "tests/golden/why/regression_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante::test {

RegressionBench::RegressionBench(RegressionScene sound) : sound_(std::move(sound)) {
  auto maker = makerOf(sound_, "sound");
  if (!maker.ok()) {
    ADD_FAILURE() << maker.error().text();
    return;
  }
  maker_ = std::move(*maker);
  auto golden = maker_->frame(sound_.request);
  if (golden.ok()) {
    golden_ = std::move(*golden);
  } else {
    ADD_FAILURE() << golden.error().text();
  }
}

Result<FrameMaker> RegressionBench::makerOf(const RegressionScene& scene, const std::string& name) {
  const auto log = folder_ / (name + ".mcap");
  std::string statements;
  for (const std::string& statement : scene.statements) statements += statement + "\n";
  writeSession(log, {{0, statements}, {100, "event \"end\"\n"}});
  auto session = Timeline::open(log);
  if (!session.ok()) return session.error();
  return FrameMaker::open(scene.cell, std::move(*session), Profile::reproducible);
}

std::optional<RegressionAnswer> RegressionBench::answer(const Regression& regression) {
  RegressionScene scene = sound_;
  if (regression.apply) regression.apply(scene);
  auto maker = makerOf(scene, regression.name);
  if (!maker.ok()) {
    ADD_FAILURE() << regression.name << ": " << maker.error().text();
    return std::nullopt;
  }
  auto frame = maker->frame(scene.request);
  if (!frame.ok()) {
    ADD_FAILURE() << regression.name << ": " << frame.error().text();
    return std::nullopt;
  }
  if (regression.retouch) regression.retouch(*frame);
  RegressionAnswer answer;
  answer.exact = compare(*frame, golden_, Tolerance::exactly());
  answer.rounding = compare(*frame, golden_, Tolerance::rounding());
  answer.cpu = compare(*frame, golden_, Tolerance::cpu());
  answer.loose = compare(*frame, golden_, Tolerance::loose());
  if (answer.exact.verdict == Verdict::same) return answer;
  SceneDrawer golden_drawer(*maker_), drawer(*maker);
  const DrawableSide frame_side{drawer, scene.request};
  const auto why = explainBoth(golden_, {golden_drawer, sound_.request}, *frame, frame_side);
  const auto guess = explainByGuess(golden_, *frame, frame_side);
  if (!why.ok() || !guess.ok()) {
    ADD_FAILURE() << regression.name << ": " << (why.ok() ? guess : why).error().text();
    return std::nullopt;
  }
  if (!why->blame.changes.empty()) {
    answer.blamed = nameText(why->blame.changes.front().name);
    answer.what = whatText(why->blame.changes.front());
  }
  if (!guess->blame.changes.empty()) {
    answer.blamed_by_guess = nameText(guess->blame.changes.front().name);
  }
  return answer;
}

Model& ownModel(Cell& cell, const std::string& device) {
  const auto its = std::ranges::find(cell.devices, device, &CellDevice::name);
  auto copy = std::make_shared<Model>(*cell.modelOf(*its));
  its->dressed = copy;
  return *copy;
}

Visual& visualOf(Cell& cell, const std::string& device, const std::string& link) {
  Model& model = ownModel(cell, device);
  return model.links[*model.findLink(link)].visuals.front();
}

Mesh& ownMesh(Cell& cell, const std::string& device, const std::string& link) {
  Visual& visual = visualOf(cell, device, link);
  auto copy = std::make_shared<Mesh>(*visual.mesh);
  visual.mesh = copy;
  return *copy;
}

std::set<std::string> linksBelow(const Cell& cell, const std::string& device,
                                 const std::string& joint) {
  const Model& model = *cell.modelOf(*cell.findDevice(device));
  std::set<std::string> names;
  std::vector<std::size_t> open = {model.joints[*model.findJoint(joint)].child};
  while (!open.empty()) {
    const std::size_t link = open.back();
    open.pop_back();
    names.insert(device + "/" + model.links[link].name);
    for (const Joint& each : model.joints) {
      if (each.parent == link) open.push_back(each.child);
    }
  }
  return names;
}

void RegressionTally::add(const Regression& regression, const RegressionAnswer& answer) {
  const bool is_different = answer.exact.verdict == Verdict::different;
  ++all;
  caught += is_different;
  rounded += is_different && answer.rounding.verdict == Verdict::same;
  const bool is_right = regression.guilty.contains(answer.blamed);
  const bool guessed_right = regression.guilty.contains(answer.blamed_by_guess);
  if (regression.geometric && is_different) {
    ++geometric;
    blamed += is_right;
    guessed += guessed_right;
  }
  fmt::print("{:<30} {:>6} px by {:>3}, tile {:>6.2f}/{:>3}  {}  {} {} {}\n", regression.name,
             answer.exact.differing, answer.exact.max, answer.exact.worst_tile_mean,
             answer.exact.worst_tile_over,
             answer.cpu.verdict == Verdict::different ? "cpu: different" : "cpu: same     ",
             regression.guilty.empty() ? " "
             : is_right                ? "+"
                                       : "-",
             answer.blamed, answer.what);
}

}  // namespace rocinante::test
