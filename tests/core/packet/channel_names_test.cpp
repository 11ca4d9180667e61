#include "core/packet/channel_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace rocinante {
namespace {

TEST(ChannelNames, ComeBackAsTheyAre) {
  const std::vector<ChannelNames> all = {
      {"arm", "", "load", "kg"}, {"arm", "tool0", "a b", ""},
      {"", "", "estop", ""},     {"-", "", "odd", ""},
      {"a/b", "", "x", "N.m"},   {"a", "b", "x", "N.m"},
      {"arm 1", "", "", ""},     {std::string(255, ' '), std::string(255, '='), "\xC3\xA4", "%"}};
  for (const ChannelNames& names : all) {
    const ChannelMetadata metadata = channelMetadata(names);
    EXPECT_TRUE(hasChannelNames(metadata));
    const auto back = channelNamesIn(metadata);
    ASSERT_TRUE(back.has_value()) << metadata.begin()->second;
    EXPECT_EQ(*back, names);
  }
}

TEST(ChannelNames, AreWrittenAsInPacketText) {
  EXPECT_EQ(channelMetadata({"arm 1", "tool0", "load", "kg"}),
            (ChannelMetadata{{"rocinante.name", "load"},
                             {"rocinante.path", "arm%201/tool0"},
                             {"rocinante.unit", "kg"}}));
  EXPECT_EQ(channelMetadata({"arm", "", "", ""}), (ChannelMetadata{{"rocinante.path", "arm"}}));
}

TEST(ChannelNames, OfAStrangerAreWhatPacketsMaySay) {
  EXPECT_FALSE(hasChannelNames({{"offered_qos_profiles", ""}}));
  EXPECT_FALSE(channelNamesIn({{"rocinante.name", "x"}}).has_value());
  const std::string kLong(100'000, 'a');
  for (const std::string& bad : {std::string(), std::string("a b"), std::string("a\nremove arm"),
                                 std::string("a/b/c"), std::string("layer/x"), std::string("%zz"),
                                 std::string("a\0b", 3), std::string("\xFF"), kLong}) {
    EXPECT_FALSE(channelNamesIn({{"rocinante.path", bad}, {"rocinante.name", "x"}}).has_value())
        << bad.substr(0, 20);
  }
  for (const std::string& bad : {std::string(), std::string("x 1"), std::string("x=1 y"),
                                 std::string("x\nremove arm"), kLong}) {
    EXPECT_FALSE(channelNamesIn({{"rocinante.path", "arm"}, {"rocinante.name", bad}}).has_value());
  }
  for (const std::string& bad : {std::string("k\"g"), std::string("kg g"), kLong}) {
    EXPECT_FALSE(channelNamesIn(
                     {{"rocinante.path", "arm"}, {"rocinante.name", "x"}, {"rocinante.unit", bad}})
                     .has_value());
  }
  // Joint states are a device's.
  EXPECT_FALSE(channelNamesIn({{"rocinante.path", "arm/tool0"}}).has_value());
  EXPECT_FALSE(channelNamesIn({{"rocinante.path", "-"}}).has_value());
}

}  // namespace
}  // namespace rocinante
