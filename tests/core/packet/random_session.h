#pragma once

#include <random>
#include <string>
#include <vector>

namespace rocinante::test {

/// Writes packets in which few sources, devices and names are shared, so that they collide:
/// restarts, late and lost packets, restatements whole and broken, everything that the fold has a
/// rule for.
class RandomSession {
 public:
  explicit RandomSession(std::uint64_t seed) : random_(seed) {}

  struct Datagram {
    double seconds = 0;
    std::string text;
  };

  Datagram next() {
    static const char* const kSources[] = {"a", "b", "z%20z"};
    Source& source = sources_[below(3)];
    const char* const name = kSources[static_cast<std::size_t>(&source - sources_)];
    seconds_ += below(20) == 0 ? 0.7 : 0.01;
    Datagram datagram{seconds_, header(source, name)};
    const std::size_t statements = below(5);
    for (std::size_t i = 0; i < statements; ++i) datagram.text += statement() + '\n';
    return datagram;
  }

  /// A number from 0 to `count` - 1.
  std::size_t below(std::size_t count) { return random_() % count; }

 private:
  struct Source {
    std::uint64_t sequence = 0;
    int run = 0;
    std::size_t part = 0;
    std::size_t parts = 0;
    int restatement = 0;
  };

  std::string header(Source& source, const std::string& name) {
    if (below(40) == 0) source = {0, source.run + 1, 0, 0, source.restatement};
    if (below(60) == 0) source.sequence = 0;
    std::uint64_t sequence = source.sequence++;
    if (below(15) == 0) source.sequence += below(4);
    if (below(15) == 0) sequence -= std::min<std::uint64_t>(sequence, below(90));
    std::string text = "RK1 " + name;
    if (source.run > 0) text += "@r" + std::to_string(source.run);
    text += ' ' + (below(12) == 0 ? std::string("-") : std::to_string(sequence));
    text += ' ' + (below(6) == 0 ? std::string("-") : std::to_string(seconds_));
    if (source.parts == 0 && below(6) == 0) {
      source.parts = 1 + below(3);
      source.part = 0;
      ++source.restatement;
    }
    if (source.parts != 0 && below(3) != 0) {
      text += " restated part=i" + std::to_string(source.restatement) + ':' +
              std::to_string(++source.part) + '/' + std::to_string(source.parts);
      if (source.part == source.parts) source.parts = 0;
      if (below(8) == 0) text += " by=relay";
      if (below(8) == 0) text += " reset";
    }
    if (below(20) == 0) text += " via=relay:" + std::to_string(below(100));
    return text + '\n';
  }

  std::string pick(std::initializer_list<const char*> words) {
    return *(words.begin() + below(words.size()));
  }
  std::string number() { return std::to_string(static_cast<int>(below(2001)) - 1000) + ".125"; }
  std::string numbers(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += ' ' + number();
    return text;
  }
  std::string device() { return pick({"arm", "tank", "layer", "t%2F1"}); }
  std::string joint() { return pick({"j1", "j2", "grip"}); }
  std::string path() {
    return pick({"arm", "arm/l1", "arm/l2", "tank", "%6Cayer/l1", "layer/x", "layer/y", "layer"});
  }
  std::string signalPath() {
    return pick({"-", "arm", "arm/l1", "tank", "%6Cayer/l1", "layer", "%2D", "-/l1"});
  }
  std::string carrier() { return below(3) == 0 ? " in " + device() + "/l1" : ""; }
  /// The elements of a list in braces are made from left to right, as the operands of + need not
  /// be: every compiler draws the same session.
  static std::string joined(std::initializer_list<std::string> parts) {
    std::string text;
    for (const std::string& part : parts) text += part;
    return text;
  }
  std::string id() { return pick({"p", "q", "r:1"}); }
  std::string color() { return pick({"#ff0000", "#00ff0080", "#123456"}); }
  std::string part() { return pick({"", "", ":1/2", ":2/2", ":1/3", ":3/3"}); }

  std::string statement() {
    switch (below(20)) {
      case 0:
      case 1:
        return joined({"joints ", device(), numbers(1 + below(3))});
      case 2:
        return joined({"order ", device(), pick({"", " j1", " j1 j2", " grip j1 j2"})});
      case 3:
        return joined(
            {"joint ", device(), " ", joint(), "=", number(), " ", joint(), "=", number()});
      case 4:
        return joined({"pose ", device(), numbers(7), carrier()});
      case 5:
        return joined({"add ", device(), pick({" puma", " kuka kin=00000000000000ff"})});
      case 6:
        return joined({"remove ", device()});
      case 7:
        return joined({"show ", path(), pick({"", " default"})});
      case 8:
        return joined({"hide ", path()});
      case 9:
        return joined({"color ", path(), " ", pick({"default", "#ff0000", "#00ff0080"})});
      case 10:
        return joined({"line ", id(), part(), " ", color(), pick({"", " width=2"}), carrier(),
                       numbers(3 * (1 + below(3)))});
      case 11:
        return joined({"points ", id(), part(), " ", color(), carrier(), numbers(3)});
      case 12:
        return joined({"label ", id(), carrier(), numbers(3), " \"say \\\"hi\\\"\\n\""});
      case 13:
        return joined({"erase ", below(3) == 0 ? std::string("*") : id()});
      case 14:
        return joined({"view ", pick({"top", "side"}), numbers(6), " 45",
                       pick({"", " up 0 1 0", " ortho 3"}), carrier()});
      case 15:
        return "event \"e\"";
      case 16:
        return joined(
            {"signal ", signalPath(), " ", joint(), " ",
             pick({"1.5", "-2 kg", "7 N.m", "true", "false", "\"auto\"", "\"\"", "default"})});
      case 17:
      case 18:
        return joined({"signals ", signalPath(), " ", joint(), "=", number(), " ", joint(), "=",
                       pick({"true", "0", "3"})});
      default:
        return pick({"wave", "joints arm nan", "seen arm 5", "# nothing"});
    }
  }

  std::mt19937_64 random_;
  Source sources_[3];
  double seconds_ = 1;
};

}  // namespace rocinante::test
