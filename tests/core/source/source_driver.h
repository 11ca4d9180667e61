#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/source/source.h"
#include "tests/core/source/update_script.h"

namespace rocinante::test {

/// `word` as a view; nothing for "-".
inline std::string_view viewOf(const std::string& word) {
  return word == "-" ? std::string_view() : std::string_view(word);
}

inline std::vector<double> numbersOf(const std::vector<std::string>& words, std::size_t from,
                                     std::size_t end) {
  std::vector<double> numbers;
  for (std::size_t i = from; i < end; ++i)
    numbers.push_back(std::strtod(words[i].c_str(), nullptr));
  return numbers;
}

inline std::vector<Vec3> pointsOf(const std::vector<double>& numbers) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

inline std::uint32_t rgbaOf(const std::string& word) {
  return static_cast<std::uint32_t>(std::strtoul(word.c_str(), nullptr, 16));
}

inline PathView pathOf(const std::vector<std::string>& words, std::size_t at) {
  if (words[at + 2] != "-") return {"layer", words[at + 2], true};
  return {viewOf(words[at]), viewOf(words[at + 1]), false};
}

inline PathView carrierOf(const std::vector<std::string>& words, std::size_t at) {
  return {viewOf(words[at]), viewOf(words[at + 1]), false};
}

/// Follows one line of an UpdateScript.
inline SourceResult follow(Source& source, const std::vector<std::string>& words) {
  const std::string& verb = words[0];
  const std::size_t count = words.size();
  const auto device = [&] { return source.device(words[1]); };
  if (verb == "add") {
    std::optional<std::uint64_t> kinematics;
    if (words[3] != "-") kinematics = std::strtoul(words[3].c_str(), nullptr, 16);
    return source.add(device(), words[2], kinematics);
  }
  if (verb == "remove") return source.remove(device());
  if (verb == "order") {
    const std::vector<std::string_view> names(words.begin() + 2, words.end());
    return source.setOrder(device(), names);
  }
  if (verb == "joints") return source.setJoints(device(), numbersOf(words, 2, count));
  if (verb == "pose") {
    const auto n = numbersOf(words, 2, 9);
    return source.setPose(device(), {{n[0], n[1], n[2]}, Quat(n[6], n[3], n[4], n[5])},
                          carrierOf(words, 9));
  }
  if (verb == "show") {
    return source.setVisibility(pathOf(words, 2),
                                static_cast<Source::Visibility>(std::atoi(words[1].c_str())));
  }
  if (verb == "color") {
    std::optional<std::uint32_t> rgba;
    if (words[4] != "-") rgba = rgbaOf(words[4]);
    return source.setColor(pathOf(words, 1), rgba);
  }
  if (verb == "signal") {
    const PathView path = carrierOf(words, 1);
    if (words[4] == "bool") return source.setSignal(path, words[3], words[5] == "1");
    if (words[4] == "text") return source.setSignal(path, words[3], std::string_view(words[5]));
    if (words[4] == "default") return source.cancelSignal(path, words[3]);
    return source.setSignal(path, words[3], numbersOf(words, 5, 6)[0], viewOf(words[6]));
  }
  if (verb == "line" || verb == "points") {
    const auto points = pointsOf(numbersOf(words, 6, count));
    const double size = std::strtod(words[3].c_str(), nullptr);
    return verb == "line"
               ? source.drawLine(words[1], rgbaOf(words[2]), points, size, carrierOf(words, 4))
               : source.drawPoints(words[1], rgbaOf(words[2]), points, size, carrierOf(words, 4));
  }
  if (verb == "label") {
    const auto n = numbersOf(words, 4, 7);
    return source.drawLabel(words[1], {n[0], n[1], n[2]}, words[7], carrierOf(words, 2));
  }
  if (verb == "erase") return words[1] == "*" ? source.eraseAll() : source.erase(words[1]);
  if (verb == "view") {
    const auto n = numbersOf(words, 2, 13);
    Source::View view;
    view.eye = {n[0], n[1], n[2]};
    view.target = {n[3], n[4], n[5]};
    view.fov_deg = n[6];
    view.up = {n[7], n[8], n[9]};
    if (n[10] != 0) view.ortho_height_m = n[10];
    return source.setView(words[1], view, carrierOf(words, 13));
  }
  if (verb == "event") return source.event(words[1]);
  return source.flush(WallTime(Nanoseconds(std::strtoll(words[1].c_str(), nullptr, 10))));
}

/// What receivers must have after an update: the fold of its statement, written without the Source.
class ExpectedState {
 public:
  void apply(const std::vector<std::string>& words) {
    Statement s;
    std::vector<double> numbers;
    std::vector<std::string_view> names;
    SignalKind kind{};
    const std::string& verb = words[0];
    const std::size_t count = words.size();
    s.name = words[1];
    if (verb == "add") {
      s.kind = StatementKind::add;
      s.text = words[2];
      if (words[3] != "-") s.kinematics = std::strtoul(words[3].c_str(), nullptr, 16);
    } else if (verb == "remove") {
      s.kind = StatementKind::remove;
    } else if (verb == "order") {
      s.kind = StatementKind::order;
      names.assign(words.begin() + 2, words.end());
    } else if (verb == "joints") {
      s.kind = StatementKind::joints;
      numbers = numbersOf(words, 2, count);
    } else if (verb == "pose") {
      s.kind = StatementKind::pose;
      numbers = numbersOf(words, 2, 9);
      s.carrier = carrierOf(words, 9);
    } else if (verb == "show") {
      s.kind = words[1] == "1" ? StatementKind::hide : StatementKind::show;
      s.is_default = words[1] == "2";
      s.path = pathOf(words, 2);
    } else if (verb == "color") {
      s.kind = StatementKind::color;
      s.path = pathOf(words, 1);
      s.is_default = words[4] == "-";
      s.rgba = rgbaOf(words[4]);
    } else if (verb == "signal") {
      // A number without a unit keeps the one that it has.
      const bool keeps_unit = words[4] == "number" && words[6] == "-";
      s.kind = keeps_unit ? StatementKind::signals : StatementKind::signal;
      s.name = {};
      s.path = carrierOf(words, 1);
      s.is_default = words[4] == "default";
      names = {words[3]};
      numbers = {0};
      kind = SignalKind::text;
      if (words[4] == "text") s.text = words[5];
      if (words[4] == "bool") kind = SignalKind::boolean;
      if (words[4] == "bool") numbers[0] = words[5] == "1" ? 1 : 0;
      if (words[4] == "number") kind = SignalKind::number;
      if (words[4] == "number") numbers[0] = std::strtod(words[5].c_str(), nullptr);
      if (words[4] == "number") s.unit = viewOf(words[6]);
      s.signal_kinds = std::span(&kind, 1);
    } else if (verb == "line" || verb == "points") {
      s.kind = verb == "line" ? StatementKind::line : StatementKind::points;
      s.rgba = rgbaOf(words[2]);
      s.size_px = std::strtod(words[3].c_str(), nullptr);
      s.carrier = carrierOf(words, 4);
      numbers = numbersOf(words, 6, count);
    } else if (verb == "label") {
      s.kind = StatementKind::label;
      s.carrier = carrierOf(words, 2);
      numbers = numbersOf(words, 4, 7);
      s.text = words[7];
    } else if (verb == "erase") {
      s.kind = StatementKind::erase;
      if (words[1] == "*") s.name = {};
    } else if (verb == "view") {
      s.kind = StatementKind::view;
      numbers = numbersOf(words, 2, 12);
      const double height = std::strtod(words[12].c_str(), nullptr);
      if (height != 0) s.ortho_height_m = height;
      s.carrier = carrierOf(words, 13);
    } else {
      return;
    }
    for (double& number : numbers) number = nineDecimals(number);
    s.numbers = numbers;
    s.names = names;
    Packet packet;
    packet.header.source = "s";
    packet.statements = std::span(&s, 1);
    state_.apply({}, packet);
  }

  const SessionState& state() const { return state_; }

  /// The double that a receiver reads, by the standard library.
  static double nineDecimals(double number) {
    std::array<char, 400> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, 9);
    double read = 0;
    std::from_chars(text.data(), end.ptr, read);
    return read + 0.0;
  }

 private:
  SessionState state_;
};

/// The lines of items in identityText(), with the parts of long drawings joined: how a drawing is
/// divided is the sender's affair.
inline std::string itemsOf(const SessionState& state) {
  std::string text;
  std::istringstream lines(state.identityText());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("item ")) continue;
    const bool is_drawing = line.starts_with("item s line ") || line.starts_with("item s points ");
    if (!is_drawing) text += line + "\n";
  }
  for (const auto& [key, drawing] : state.drawings()) {
    if (drawing.kind == StatementKind::label) continue;
    text += "drawing " + key.second + " " + std::string(nameOf(drawing.kind)) + " " +
            std::to_string(drawing.rgba) + " " + std::to_string(drawing.size_px) + " " +
            drawing.carrier.first + "/" + drawing.carrier.second;
    for (const auto& part : drawing.parts) {
      if (!part) text += " gap";
      for (const double number : part.value_or(std::vector<double>())) {
        std::array<char, 40> word{};
        std::snprintf(word.data(), word.size(), " %.17g", number);
        text += word.data();
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace rocinante::test
