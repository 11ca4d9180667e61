// Runs the examples of docs/packet-format.md, so that the normative text stays true.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

struct Block {
  std::string kind;  ///< after the opening fence
  std::size_t line = 0;
  std::string text;
};

std::ifstream openDocument() {
  return std::ifstream(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "packet-format.md");
}

std::vector<Block> blocksOfDocument() {
  std::ifstream file = openDocument();
  std::vector<Block> blocks;
  std::string line;
  bool is_inside = false;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      if (is_inside) blocks.push_back({line.substr(3), number, {}});
    } else if (is_inside) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

/// The text of the block after `index` when it is of `kind`, else nothing.
std::string followingBlock(const std::vector<Block>& blocks, std::size_t index,
                           std::string_view kind) {
  const bool follows = index + 1 < blocks.size() && blocks[index + 1].kind == kind;
  return follows ? blocks[index + 1].text : std::string();
}

/// Folds datagrams, each after a line "at SECONDS".
std::string identityOf(const std::string& session) {
  test::TextFold fold;
  std::istringstream lines(session);
  std::string datagram;
  double seconds = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("at ")) {
      if (!datagram.empty()) fold.fold(seconds, datagram);
      datagram.clear();
      seconds = std::stod(line.substr(3));
    } else {
      datagram += line + '\n';
    }
  }
  fold.fold(seconds, datagram);
  return fold.state.identityText();
}

/// As the document's tables write a word, up to the byte after it.
std::string quoted(std::string_view word, char after) {
  std::string text("`");
  text.append(word).push_back(after);
  return text;
}

TEST(PacketFormatDocument, ItsExamplesAreTrue) {
  const std::vector<Block> blocks = blocksOfDocument();
  std::size_t packets = 0;
  std::size_t sessions = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    SCOPED_TRACE("docs/packet-format.md line " + std::to_string(blocks[i].line));
    if (blocks[i].kind == "rk1") {
      ++packets;
      EXPECT_EQ(test::faultsOf(blocks[i].text), followingBlock(blocks, i, "faults"));
    } else if (blocks[i].kind == "fold") {
      ++sessions;
      EXPECT_EQ(identityOf(blocks[i].text), followingBlock(blocks, i, "identity"));
    } else {
      EXPECT_TRUE(blocks[i].kind == "faults" || blocks[i].kind == "identity") << blocks[i].kind;
    }
  }
  EXPECT_GE(packets, 8U);
  EXPECT_GE(sessions, 3U);
}

TEST(PacketFormatDocument, EveryFaultAndStatementIsInIt) {
  std::ifstream file = openDocument();
  std::ostringstream text;
  text << file.rdbuf();
  for (std::size_t i = 0; i < kPacketFaultCount; ++i) {
    const std::string name = quoted(nameOf(static_cast<PacketFault>(i)), '`');
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
  for (int i = 0; i <= static_cast<int>(StatementKind::seen); ++i) {
    const std::string name = quoted(nameOf(static_cast<StatementKind>(i)), ' ');
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace rocinante
