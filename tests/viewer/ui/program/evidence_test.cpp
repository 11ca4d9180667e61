#include "viewer/ui/program/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/support/temporary_folder.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

std::string lineOf(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += line.empty() ? word : " " + word;
  return line;
}

EvidenceRequest someRequest() {
  EvidenceRequest request;
  request.cell = "cell.toml";
  request.log = "session.mcap";
  request.at = "7.880000000";
  request.width = 1280;
  request.height = 720;
  request.output = "out.png";
  return request;
}

TEST(EvidenceArguments, SayAllThatThePictureIsAFunctionOf) {
  EvidenceRequest request = someRequest();
  request.view.eye = {0.1, -4, 3};
  request.view.target = {0, 0, 0.5};
  request.hide = {"layer/labels"};
  request.scale = 1.5;
  request.insets = {*parseInset("map:top-left")};
  request.style.shadows = true;
  request.style.edges = EdgeStyle::only;
  request.search = {"models"};
  request.search_environment = true;
  EXPECT_EQ(lineOf(evidenceArguments(request)),
            "cell.toml session.mcap --at 7.880000000 "
            "--camera=@0.1,-4,3/0,0,0.5/fov=45 --size 1280x720 --scale 1.5 --samples 4 "
            "--hide layer/labels "
            "--inset map:top-left --shadows=on --edges=only --search models --search-env "
            "-o out.png");
}

TEST(EvidenceArguments, ANamedCameraIsNamedAndNoInsetIsSaid) {
  EvidenceRequest request = someRequest();
  request.camera = "overview";
  request.log.clear();
  request.at.clear();
  request.insets.emplace();
  EXPECT_EQ(lineOf(evidenceArguments(request)),
            "cell.toml --camera=overview --size 1280x720 --samples 4 --no-insets -o out.png");
}

TEST(CaseArguments, SayTheSameTermsToGolden) {
  EvidenceRequest request = someRequest();
  request.camera = "overview";
  request.hide = {"layer/labels"};
  request.scale = 1.5;
  request.insets.emplace();
  request.style.shadows = true;
  EXPECT_EQ(lineOf(caseArguments(request, "view.suite.toml", "first")),
            "add view.suite.toml --case first --cell cell.toml --log session.mcap --at "
            "7.880000000s --camera=overview --size 1280x720 --scale 1.5 --samples 4 --hide "
            "layer/labels --no-insets --style shadows=on");
}

TEST(EvidenceNames, AreNeverTaken) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(freeEvidenceName(folder.path(), "demo", "7.880").filename(),
            "evidence-demo-7.880s.png");
  std::ofstream(folder / "evidence-demo-7.880s.png") << "x";
  EXPECT_EQ(freeEvidenceName(folder.path(), "demo", "7.880").filename(),
            "evidence-demo-7.880s-2.png");
  EXPECT_EQ(freeEvidenceName(folder.path(), "demo", "").filename(), "evidence-demo.png");
}

TEST(EvidenceRun, RefusalsAreToldInRendersOwnWords) {
  const test::TemporaryFolder folder;
  EvidenceRequest request = someRequest();
  request.cell = folder / "missing.urdf";
  request.log.clear();
  request.at.clear();
  request.output = folder / "out.png";
  auto run = EvidenceRun::start(request);
  if (!run.ok()) GTEST_SKIP() << "rocinante-render is neither beside this program nor in PATH";
  const auto made = run->wait();
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().text().find("missing.urdf"), std::string::npos) << made.error().text();
  EXPECT_FALSE(std::filesystem::exists(request.output));
}

}  // namespace
}  // namespace rocinante
