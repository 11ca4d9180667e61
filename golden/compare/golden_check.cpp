#include "golden/compare/golden_check.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <ostream>

#include "golden/compare/comparison_text.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// The variable's value; empty when it is not set.
std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

bool isOn(const std::string& value) { return !value.empty() && value != "0" && value != "false"; }

bool isGoldenName(std::string_view name) {
  return !name.empty() && name.front() != '.' &&
         name.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
             "0123456789_-.") == std::string_view::npos;
}

Picture copyOf(const PictureView& view) {
  Picture picture{view.width, view.height, {}};
  const std::size_t row = static_cast<std::size_t>(view.width) * 4;
  picture.rgba.resize(row * static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y) {
    std::memcpy(picture.rgba.data() + static_cast<std::size_t>(y) * row,
                view.rgba + y * view.row_bytes, row);
  }
  return picture;
}

/// Writes a picture, creating its folder if necessary; returns a line that says so.
std::string written(const char* what, const fs::path& path, const Picture& picture) {
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
  const Status status = writePng(path, picture);
  return status.ok() ? fmt::format("{}: {}\n", what, path.string())
                     : fmt::format("{} could not be written: {}\n", what, status.error().text());
}

GoldenAnswer approved(const Picture& frame, const fs::path& golden_file) {
  std::error_code fault;
  fs::create_directories(golden_file.parent_path(), fault);
  const Status status = writePng(golden_file, frame);
  if (!status.ok()) return {false, "the golden could not be written: " + status.error().text()};
  fmt::print(stderr, "approved {}\n", golden_file.string());
  return {true, "approved"};
}

}  // namespace

PictureView viewOf(const Picture& picture) {
  return {picture.width, picture.height, std::ptrdiff_t{picture.width} * 4, picture.rgba.data()};
}

void PrintTo(const PictureView& view, std::ostream* out) {
  *out << "a picture of " << view.width << "x" << view.height << " pixels";
}

Result<GoldenPlace> GoldenPlace::fromEnvironment(const char* compiled_in) {
  GoldenPlace place;
  place.goldens = environment("ROCINANTE_GOLDEN_DIR");
  if (place.goldens.empty() && compiled_in != nullptr) place.goldens = compiled_in;
  if (place.goldens.empty()) {
    return Error{ErrorKind::bad_argument, "no golden folder: define or set ROCINANTE_GOLDEN_DIR",
                 ""};
  }
  place.results = environment("ROCINANTE_GOLDEN_RESULTS");
  if (place.results.empty()) place.results = "golden-results";
  place.approve = isOn(environment("ROCINANTE_APPROVE"));
  if (place.approve && isOn(environment("CI"))) {
    return Error{ErrorKind::bad_argument,
                 "ROCINANTE_APPROVE is refused where CI is set: people accept goldens", ""};
  }
  return place;
}

GoldenAnswer checkGolden(const PictureView& frame, std::string_view name,
                         const Tolerance& tolerance, const GoldenPlace& place) {
  if (!isGoldenName(name)) {
    return {false,
            fmt::format("\"{}\" is not a valid golden name: use letters, digits, _ - .", name)};
  }
  if (frame.width <= 0 || frame.height <= 0 || frame.rgba == nullptr ||
      std::abs(frame.row_bytes) < std::ptrdiff_t{frame.width} * 4) {
    return {false, "the frame has no pixels"};
  }
  FinePicture fine;
  fine.picture = copyOf(frame);
  const Picture& shown = fine.picture;
  const fs::path golden_file = place.goldens / (std::string(name) + ".png");
  const std::string stem = (place.results / name).string();
  const auto golden = readFinePicture(golden_file);
  if (!golden.ok()) {
    if (place.approve) return approved(shown, golden_file);
    if (golden.error().kind != ErrorKind::not_found) {
      return {false, "the golden cannot be read: " + golden.error().text()};
    }
    return {false, fmt::format("no golden was accepted yet: {}\n", golden_file.string()) +
                       written("frame", stem + ".frame.png", shown) +
                       "look at it, then accept it with ROCINANTE_APPROVE=1\n"};
  }
  const Comparison found = compareFine(fine, *golden, tolerance);
  if (found.verdict == Verdict::same) return {true, found.rule};
  if (place.approve) return approved(shown, golden_file);
  std::string text = fmt::format("{}: {}\n", nameOf(found.verdict), found.rule);
  const bool comparable = found.verdict == Verdict::different;
  if (comparable) text += differenceText(found, shown, golden->picture);
  text += fmt::format("golden: {}\n", golden_file.string());
  text += written("frame", stem + ".frame.png", shown);
  if (comparable) {
    text +=
        written("difference", stem + ".difference.png", differencePicture(shown, golden->picture));
  }
  return {false, text};
}

}  // namespace rocinante
