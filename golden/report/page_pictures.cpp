#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/base64.h"
#include "core/base/json_parse.h"
#include "golden/report/report_pictures.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

using PagesJson = nlohmann::json;

/// Five hundred of them take a few megabytes.
constexpr int kListPicturePixels = 112;

std::optional<Picture> pictureIn(const PagesJson& frame, const char* key) {
  const auto found = frame.find(key);
  if (found == frame.end() || !found->is_string()) return std::nullopt;
  const auto bytes = bytesOfBase64(found->get_ref<const std::string&>());
  if (!bytes) return std::nullopt;
  auto picture = decodePng(*bytes, key);
  if (!picture.ok()) return std::nullopt;
  return std::move(*picture);
}

}  // namespace

Picture listPicture(const Picture& picture) { return reducedPicture(picture, kListPicturePixels); }

std::string pagePicturesJson(const SuiteReport& report) {
  PagesJson frames = PagesJson::object();
  for (const JudgedFrame& judged : report.frames) {
    PagesJson frame = PagesJson::object();
    if (judged.thumbnail) frame["small"] = base64Of(encodePng(listPicture(*judged.thumbnail)));
    if (judged.why && !judged.why->blame.mask.rgba.empty()) {
      frame["blame"] = base64Of(encodePng(judged.why->blame.mask));
    }
    if (judged.unmasked && !isFine(judged.verdict)) {
      frame["compared"] = base64Of(encodePng(*judged.unmasked));
    }
    if (judged.areas && canApprove(judged)) {
      frame["areas"] = base64Of(encodePng(*judged.areas));
    }
    if (!frame.empty()) frames[judged.frame.name] = std::move(frame);
  }
  return PagesJson{{"format", 1}, {"frames", std::move(frames)}}.dump() + "\n";
}

void addPagePictures(std::string_view json, SuiteReport& report) {
  const PagesJson root = parseJsonOrDiscard<PagesJson>(json);
  if (!root.is_object() || root.value("format", PagesJson()) != 1) return;
  const auto frames = root.find("frames");
  if (frames == root.end() || !frames->is_object()) return;
  for (JudgedFrame& judged : report.frames) {
    const auto frame = frames->find(judged.frame.name);
    if (frame == frames->end() || !frame->is_object()) continue;
    if (isFine(judged.verdict)) judged.thumbnail = pictureIn(*frame, "small");
    if (!judged.drawn) continue;
    // Decoded over the frame's pixels.
    const auto pictureOver = [&](const char* key) {
      auto over = pictureIn(*frame, key);
      const bool fits =
          over && over->width == judged.drawn->width && over->height == judged.drawn->height;
      return fits ? std::move(over) : std::nullopt;
    };
    judged.unmasked = pictureOver("compared");
    judged.areas = pictureOver("areas");
    auto blame = pictureOver("blame");
    if (!judged.why || !blame) continue;
    auto why = std::make_shared<FrameWhy>(*judged.why);
    why->blame.mask = std::move(*blame);
    judged.why = std::move(why);
  }
}

}  // namespace rocinante
