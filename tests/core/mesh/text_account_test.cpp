// The accounts of OBJ, MTL and STL: what is inserted or removed changes what is drawn or told.

#include <sstream>

#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

struct TextCase {
  const char* name;  ///< of the file
  const char* text;
  const char* other = "";  ///< of the material file that the OBJ names, or of the OBJ of an MTL
};

constexpr const char* kTextObj =
    "mtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "vn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 3/3/1\ng part\nusemtl n\ns 1\nf 1 2 4\nf 1 4 3\nl 1 2\ncurv "
    "0 1\n";
constexpr const char* kTextMtl =
    "newmtl m\nKd 1 0 0.5\nKs 0.5 0 0\nKe 0 0 0.25\nNs 9\nd 0.5\nmap_Kd -s 2 2 -clamp on a.png\n"
    "Ka 1 1 1\nbump b.png\nnewmtl n\nKd 0 1 0\n";

std::string toldOfText(const TextCase& given, const std::string& text) {
  const test::TemporaryFolder folder;
  const bool is_mtl = std::string_view(given.name).ends_with(".mtl");
  const auto mesh_file = folder / (is_mtl ? "a.obj" : given.name);
  test::writeFile(folder / given.name, text);
  if (*given.other != '\0') test::writeFile(folder / (is_mtl ? "a.obj" : "a.mtl"), given.other);
  Findings faults;
  const auto mesh = readMeshFile(mesh_file, {}, faults);
  return test::told(mesh, faults);
}

class TextAccount : public ::testing::TestWithParam<TextCase> {};

TEST_P(TextAccount, ALineThatIsRemovedOrUnknownIsSeen) {
  std::vector<std::string> lines;
  std::istringstream stream(GetParam().text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto joined = [&](std::size_t without, std::size_t before, std::string_view more) {
    std::string text;
    for (std::size_t i = 0; i <= lines.size(); ++i) {
      if (i == before) text += std::string(more) + "\n";
      if (i < lines.size() && i != without) text += lines[i] + "\n";
    }
    return text;
  };
  constexpr std::size_t kNoLine = 1000;
  const std::string whole = toldOfText(GetParam(), GetParam().text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    SCOPED_TRACE(lines[i]);
    EXPECT_TRUE(toldOfText(GetParam(), joined(i, kNoLine, "")) != whole) << whole;
  }
  for (std::size_t i = 0; i <= lines.size(); ++i) {
    EXPECT_THAT(toldOfText(GetParam(), joined(kNoLine, i, "surprise 1 2")),
                HasSubstr("`surprise`"));
  }
}

// Of ASCII STL, only the lines of corners: the others repeat what the corners tell.
INSTANTIATE_TEST_SUITE_P(Files, TextAccount,
                         ::testing::Values(TextCase{"a.obj", kTextObj, kTextMtl},
                                           TextCase{"a.mtl", kTextMtl, kTextObj},
                                           TextCase{"a.stl",
                                                    "vertex 0 0 0\nvertex 1 0 0\n"
                                                    "vertex 0 1 0\nendfacet\n"}));

}  // namespace
}  // namespace rocinante
