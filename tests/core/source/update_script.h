#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

// Updates of a source as lines of words, which a C program and a C++ one can follow alike. Numbers
// are hexadecimal doubles, so that both read the same. "-" is nothing.

namespace rocinante::test {

/// Random updates from a few names, so that they meet: devices are added, removed, ordered,
/// carried.
class UpdateScript {
 public:
  explicit UpdateScript(std::uint64_t seed) : random_(seed) {}

  std::string next() {
    switch (below(18)) {
      case 0:
        return "add " + device() + " " + pick("puma", "box", "m\xC3\xA9") + (coin() ? " 1f" : " -");
      case 1:
        return "remove " + device();
      case 2:
        return "order " + device() + " " + pick("a b", "b a", "a b c", "grip", "x/y %z");
      case 3:
      case 4:
      case 5:
      case 6:
        return "joints " + device() + numbers(1 + below(4));
      case 7:
        return "pose " + device() + numbers(3) + quaternion() + " " + carrier();
      case 8:
        return "show " + pick("0", "1", "2") + " " + path();
      case 9:
        return "color " + path() + " " + pick("ff0000ff", "00ff0080", "-");
      case 10:
      case 11:
        return points();
      case 12:
        return "label " + id() + " " + carrier() + numbers(3) + " " +
               pick("hi", "\"\\", "\xC3\xA9");
      case 13:
        return "erase " + pick("p", "q", "r", "*");
      case 14:
        return "view " + pick("top", "side") + numbers(3) + " 0x1p+20 0 0 0x1.68p+5" + up() + " " +
               carrier();
      case 15:
      case 16:
        return signal();
      default:
        return "event " + pick("picked", "done");
    }
  }

  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  bool coin() { return below(2) == 0; }

 private:
  template <class... Words>
  std::string pick(Words... words) {
    const std::array<std::string, sizeof...(words)> all = {words...};
    return all[below(sizeof...(words))];
  }
  std::string device() { return pick("arm", "layer", "tr/ay", "g"); }
  std::string id() { return pick("p", "q", "r"); }
  std::string path() {
    return coin() ? device() + " " + pick("-", "link2", "a/b") + " -" : "- - safety";
  }
  std::string carrier() { return coin() ? "- -" : device() + " " + pick("tip", "link2"); }
  std::string up() { return pick(" 0 0 0x1p+0 0", " 0x1p+0 0 0 0", " 0 0x1p-1 0 0x1p+2"); }
  std::string quaternion() {
    return pick(" 0 0 0 0x1p+0", " 0x1p-1 0x1p-1 -0x1p-1 0x1p-1", " 0 0 0x1p+0 0");
  }
  std::string points() {
    const std::uint32_t count = below(8) == 0 ? 1 + below(150) : 1 + below(3);
    return pick("line ", "points ") + id() + " " + pick("ff0000ff", "0000ff40") + " " +
           pick("0x1p+0", "0x1p+1") + " " + carrier() + numbers(3 * count);
  }
  std::string signal() {
    const std::string begin = "signal " + (coin() ? device() + " " + pick("-", "tip") : "- -") +
                              " " + pick("load", "mode", "x/y");
    if (below(4) == 0) return begin + " bool" + pick(" 0", " 1") + " -";
    if (below(4) == 0) return begin + " text " + pick("auto", "\"\\", "\xC3\xA9") + " -";
    if (below(8) == 0) return begin + " default - -";
    return begin + " number" + numbers(1) + " " + pick("-", "-", "kg", "N.m");
  }
  std::string numbers(std::uint32_t count) {
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i) {
      double value = static_cast<double>(static_cast<std::int32_t>(random_())) / 1e9;
      if (below(4) == 0) value = static_cast<double>(below(5)) - 2;
      if (below(50) == 0) value *= 1e15;
      std::array<char, 40> word{};
      std::snprintf(word.data(), word.size(), " %a", value);
      text += word.data();
    }
    return text;
  }

  std::mt19937_64 random_;
};

inline std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace rocinante::test
