#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "golden/compare/compare.h"
#include "golden/why/explain_pictures.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante::test {

/// A cell and what was said of it, which a regression changes.
struct RegressionScene {
  Cell cell;
  std::vector<std::string> statements;  ///< packets of one moment
  FrameRequest request;
};

/// Something that went wrong, on purpose.
struct Regression {
  std::string name;
  /// Whose the most differing pixels must be; empty: nobody's in particular.
  std::set<std::string> guilty;
  bool geometric = false;  ///< something stands elsewhere, or is another shape, or gone
  std::function<void(RegressionScene&)> apply;
  std::function<void(Picture&)> retouch;  ///< of the finished frame instead
};

/// What the judge and the explanation made of it.
struct RegressionAnswer {
  Comparison exact, rounding, cpu, loose;
  std::string blamed, blamed_by_guess;  ///< the first rows' names
  std::string what;
};

/// Draws scenes, each in a maker of its own, and keeps the sound one.
class RegressionBench {
 public:
  explicit RegressionBench(RegressionScene sound);

  const Picture& golden() const { return golden_; }
  /// Empty, with a test failure, when something could not be drawn.
  std::optional<RegressionAnswer> answer(const Regression& regression);
  const RegressionScene& sound() const { return sound_; }

 private:
  Result<FrameMaker> makerOf(const RegressionScene& scene, const std::string& name);

  TemporaryFolder folder_;
  RegressionScene sound_;
  std::optional<FrameMaker> maker_;
  Picture golden_;
};

/// The model of a cell's device as a copy of its own, which only that device has.
Model& ownModel(Cell& cell, const std::string& device);
/// A link's first visual, and its mesh as a copy of its own.
Visual& visualOf(Cell& cell, const std::string& device, const std::string& link);
Mesh& ownMesh(Cell& cell, const std::string& device, const std::string& link);
/// "device/link" of a joint's child and all below it.
std::set<std::string> linksBelow(const Cell& cell, const std::string& device,
                                 const std::string& joint);

/// The rows of the table that was printed, by what they must be.
struct RegressionTally {
  int all = 0, caught = 0, rounded = 0;  ///< rounded: the tier `rounding` passes it
  int geometric = 0, blamed = 0, guessed = 0;
  void add(const Regression& regression, const RegressionAnswer& answer);
};

}  // namespace rocinante::test
