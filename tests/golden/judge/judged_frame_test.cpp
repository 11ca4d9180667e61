#include "golden/judge/judged_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <concepts>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/report/account.h"

namespace rocinante {
namespace {

// What a judged frame consists of, apart from the lists in judged_frame.cpp: a new member does not
// compile here either, and one that is bound but not written there arrives with its default.

template <class T, class Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

auto membersOf(Is<Picture> auto& picture) {
  auto& [width, height, rgba] = picture;
  return std::tie(width, height, rgba);
}

auto membersOf(Is<PictureMask::Part> auto& part) {
  auto& [name, pixels] = part;
  return std::tie(name, pixels);
}

auto membersOf(Is<Tolerance> auto& tolerance) {
  auto& [name, exact, tile_mean, tile_over, level, percent] = tolerance;
  return std::tie(name, exact, tile_mean, tile_over, level, percent);
}

auto membersOf(Is<Comparison> auto& comparison) {
  auto& [verdict, rule, max, worst_x, worst_y, worst_frame, worst_golden, worst_tile_mean,
         worst_tile_x, worst_tile_y, worst_tile_over, differing, over_1, over_2, over_8, over_32,
         masked, fine_differing, fine_max] = comparison;
  return std::tie(verdict, rule, max, worst_x, worst_y, worst_frame, worst_golden, worst_tile_mean,
                  worst_tile_x, worst_tile_y, worst_tile_over, differing, over_1, over_2, over_8,
                  over_32, masked, fine_differing, fine_max);
}

auto membersOf(Is<AcceptedPicture> auto& accepted) {
  auto& [key, picture, pixels, inputs, session, accepted_by, accepted_at, reason, areas,
         areas_pixels, cell, decoded, coverage] = accepted;
  return std::tie(key, picture, pixels, inputs, session, accepted_by, accepted_at, reason, areas,
                  areas_pixels, cell, decoded, coverage);
}

auto membersOf(Is<RunCoverage> auto& coverage) {
  auto& [judged, lost, masked, left_out, unstated] = coverage;
  return std::tie(judged, lost, masked, left_out, unstated);
}

/// Without what the receiver has or finds out itself: the frame, and why it differs.
auto membersOf(Is<JudgedFrame> auto& judged) {
  auto& [frame, verdict, rule, tolerance, limit_from, expectation, comparison, masks, own_masks,
         coverage, lacks, key, pixels, inputs, session, decoded, golden, drawn, accepted, unmasked,
         areas, thumbnail, why, run_command, approve_command, page, render_ms, judge_ms] = judged;
  return std::tie(verdict, rule, tolerance, limit_from, expectation, comparison, masks, own_masks,
                  coverage, lacks, key, pixels, inputs, session, decoded, golden, drawn, accepted,
                  unmasked, areas, thumbnail, run_command, approve_command, page, render_ms,
                  judge_ms);
}

/// Changes every member; texts and numbers also differ from each other.
class Filler {
 public:
  template <class T>
  void fill(T& value) {
    if constexpr (requires { membersOf(value); }) {
      std::apply([this](auto&... members) { (this->fill(members), ...); }, membersOf(value));
    } else if constexpr (std::is_enum_v<T>) {
      value = value == T{} ? T{1} : T{};
    } else if constexpr (std::same_as<T, bool>) {
      value = !value;
    } else {
      value = static_cast<T>(value + static_cast<T>(++count_));
    }
  }
  void fill(std::string& text) { text = "text " + std::to_string(++count_); }
  template <class T>
  void fill(std::optional<T>& value) {
    fill(value.emplace());
  }
  template <class T>
  void fill(std::vector<T>& values) {
    fill(values.emplace_back());
  }
  template <class T, std::size_t N>
  void fill(std::array<T, N>& values) {
    for (T& value : values) fill(value);
  }
  void fill(std::set<std::string>& texts) {
    std::string text;
    fill(text);
    texts.insert(text);
  }
  void fill(Account& account) {
    LeftOut one;
    for (std::string* text : {&one.kind, &one.name, &one.reason, &one.first}) fill(*text);
    one.count = 3;
    one.severity = Severity::warning;
    account.leaveOut(one);
  }

 private:
  int count_ = 0;
};

template <class T>
void expectSame(const T& sent, const T& received, const std::string& place) {
  if constexpr (requires { membersOf(sent); }) {
    const auto all_sent = membersOf(sent);
    const auto all_received = membersOf(received);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (expectSame(std::get<I>(all_sent), std::get<I>(all_received),
                  place + ", member " + std::to_string(I)),
       ...);
    }
    (std::make_index_sequence<std::tuple_size_v<std::remove_const_t<decltype(all_sent)>>>());
  } else if constexpr (requires { membersOf(*sent); }) {
    ASSERT_EQ(sent.has_value(), received.has_value()) << place;
    if (sent) expectSame(*sent, *received, place);
  } else if constexpr (requires { membersOf(sent[0]); }) {
    ASSERT_EQ(sent.size(), received.size()) << place;
    for (std::size_t i = 0; i < sent.size(); ++i) expectSame(sent[i], received[i], place);
  } else if constexpr (std::same_as<T, Account>) {
    EXPECT_EQ(accountLines(sent), accountLines(received)) << place;
  } else {
    EXPECT_EQ(sent, received) << place;
  }
}

TEST(JudgedFrame, PassesBetweenProcessesWithEveryMember) {
  JudgedFrame sent;
  Filler().fill(sent);
  JudgedFrame received;
  ASSERT_TRUE(readWire(wireBytes(sent), received).ok());
  expectSame(sent, received, "JudgedFrame");
}

}  // namespace
}  // namespace rocinante
