#include "viewer/shown/short_names.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/bytes.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

using Names = std::vector<std::string>;

/// Every character as wide as another.
float characters(std::string_view text) {
  const auto begins = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return static_cast<float>(std::count_if(text.begin(), text.end(), begins));
}

/// Of a font in which they are not.
float ofAFont(std::string_view text) {
  float sum = 0;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if ((value & 0xC0U) != 0x80U) sum += 4 + static_cast<float>(value % 7);
  }
  return sum;
}

Names shown(const Names& names, float room) { return shortNames(names, room, characters); }

const Names kUr10{"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                  "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};

TEST(ShortNames, AreWholeWhereAllHaveRoom) { EXPECT_EQ(shown(kUr10, 19), kUr10); }

TEST(ShortNames, DropTheWordsThatAllEndWith) {
  EXPECT_EQ(shown(kUr10, 13),
            (Names{"shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"}));
}

TEST(ShortNames, DropTheWordsThatAllBeginWith) {
  EXPECT_EQ(shown({"robot_station_03_left", "robot_station_04_left"}, 10),
            (Names{"03_left", "04_left"}));
  EXPECT_EQ(shown({"panda_joint1", "panda_joint2", "panda_finger"}, 8),
            (Names{"joint1", "joint2", "finger"}))
      << "not inside of a word";
}

TEST(ShortNames, DropBothWhereTheyMust) {
  EXPECT_EQ(shown({"ur10_03.shoulder_pan_joint", "ur10_03.elbow_joint"}, 12),
            (Names{"shoulder_pan", "elbow"}));
  EXPECT_EQ(shown({"wrist_1_joint", "wrist_2_joint"}, 7), (Names{"wrist_1", "wrist_2"}))
      << "no more than that";
}

TEST(ShortNames, LeaveSomethingOfEachName) {
  EXPECT_EQ(shown({"arm_", "arm_left"}, 4), (Names{"arm_", "ar…t"}));
  EXPECT_EQ(shown({"arm", "arm_joint"}, 5), (Names{"arm", "ar…nt"}));
  EXPECT_EQ(shown({"", "arm"}, 2), (Names{"", "a…"}));
}

TEST(ShortNames, OfAloneNameAreCutInTheMiddle) {
  EXPECT_EQ(shown({"universal_robot_03_left"}, 12), (Names{"univer…_left"}));
  EXPECT_EQ(cutInMiddle("universal_robot_03_left", 12, characters), "univer…_left");
  EXPECT_EQ(cutInMiddle("universal", 1, characters), "…");
  EXPECT_EQ(cutInMiddle("universal", 0, characters), "");
  EXPECT_EQ(cutInMiddle("universal", std::numeric_limits<float>::quiet_NaN(), characters), "");
}

TEST(ShortNames, ShowWhatDiffersWithinTheMiddle) {
  EXPECT_EQ(shown({"aaaaaaaaaaaa3bbbbbbbbbbbb", "aaaaaaaaaaaa4bbbbbbbbbbbb"}, 7),
            (Names{"…aa3bb…", "…aa4bb…"}));
}

TEST(ShortNames, OfALinkCutItsDeviceFirst) {
  EXPECT_EQ(cutPath("universal_robot_03", "wrist_1_link", 40, characters),
            "universal_robot_03/wrist_1_link");
  EXPECT_EQ(cutPath("universal_robot_03", "wrist_1_link", 20, characters), "uni…_03/wrist_1_link");
  EXPECT_EQ(cutPath("universal_robot_03", "wrist_1_link", 9, characters), "univ…link");
  EXPECT_EQ(cutPath("universal_robot_03", "", 9, characters), "univ…t_03");
}

TEST(ShortNames, AreComputedAnewWhenAListOrItsRoomChanged) {
  ShortNameLists lists;
  int measured = 0;
  const TextWidth width = [&](std::string_view text) {
    ++measured;
    return characters(text);
  };
  EXPECT_EQ(lists.of("joints", kUr10, 13, width).at(2), "elbow");
  const int first = measured;
  EXPECT_EQ(lists.of("joints", kUr10, 13, width).at(2), "elbow");
  EXPECT_LE(measured, first + 1);
  EXPECT_EQ(lists.of("joints", kUr10, 19, width).at(2), "elbow_joint");
  EXPECT_EQ(lists.of("links", {"base"}, 19, width), Names{"base"});
  EXPECT_EQ(lists.of("joints", {"base"}, 19, width), Names{"base"});
}

TEST(ShortNames, OfTenThousandDevicesAreThereAtOnce) {
  Names many;
  for (int i = 0; i < 10'000; ++i)
    many.push_back("a_robot_of_this_hall_" + std::to_string(i) + "_x");
  many.push_back("floor");
  int measured = 0;
  const auto short_ones = shortNames(many, 14, [&](std::string_view text) {
    ++measured;
    return characters(text);
  });
  EXPECT_EQ(std::set(short_ones.begin(), short_ones.end()).size(), many.size());
  EXPECT_LT(measured, 2'000'000);
}

/// Names of a machine: words of a few, so that much is common, and letters of several bytes.
rc::Gen<std::string> names() {
  const auto word = rc::gen::element<std::string>("robot", "arm", "joint", "_", "/", ".", "1", "22",
                                                  "é", "Ж", "…", "腕", "x");
  return rc::gen::map(rc::gen::resize(8, rc::gen::container<Names>(word)), [](const Names& words) {
    std::string name;
    for (const std::string& each : words) name += each;
    return name;
  });
}

void holds(const char* what, const std::function<void()>& property) {
  EXPECT_TRUE(rc::check(what, property));
}

TEST(ShortNamesProperty, HaveRoomAndAreWholeCharacters) {
  holds("fits, UTF-8", [] {
    const auto list = *rc::gen::container<Names>(names());
    const auto room = static_cast<float>(*rc::gen::inRange(0, 160));
    const Names short_ones = shortNames(list, room, ofAFont);
    RC_ASSERT(short_ones.size() == list.size());
    for (const std::string& one : short_ones) {
      RC_ASSERT(ofAFont(one) <= room);
      RC_ASSERT(isUtf8(bytesOf(one)));
    }
  });
}

TEST(ShortNamesProperty, DifferWhereNamesDo) {
  holds("different, and equal", [] {
    const auto list = *rc::gen::container<Names>(names());
    const auto room = ofAFont("…9999") + static_cast<float>(*rc::gen::inRange(0, 60));
    const Names short_ones = shortNames(list, room, ofAFont);
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        RC_ASSERT((list[i] == list[k]) == (short_ones[i] == short_ones[k]));
      }
    }
  });
}

TEST(ShortNamesProperty, ArePartsOfTheirNames) {
  holds("parts, in order", [] {
    const auto list = *rc::gen::container<Names>(names());
    // With so much room no name needs a number.
    const Names short_ones = shortNames(list, 60, ofAFont);
    for (std::size_t i = 0; i < list.size(); ++i) {
      std::size_t at = 0;
      std::string_view left = short_ones[i];
      while (!left.empty()) {
        const std::size_t cut = std::min(left.find("…"), left.size());
        const std::size_t found = list[i].find(left.substr(0, cut), at);
        const bool numbered = left.find_first_not_of("0123456789") == std::string_view::npos;
        RC_ASSERT(found != std::string::npos || numbered);
        at = found == std::string::npos ? list[i].size() : found + cut;
        left.remove_prefix(std::min(cut + std::string_view("…").size(), left.size()));
      }
    }
  });
}

TEST(ShortNamesProperty, OfAnyBytesEndNowhereElse) {
  holds("any bytes", [] {
    const auto list = *rc::gen::container<Names>(rc::gen::arbitrary<std::string>());
    const auto room = static_cast<float>(*rc::gen::inRange(-5, 20));
    const Names short_ones = shortNames(list, room, characters);
    for (const std::string& one : short_ones) RC_ASSERT(one.empty() || characters(one) <= room);
  });
}

}  // namespace
}  // namespace rocinante
