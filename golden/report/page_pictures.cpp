#include "golden/report/page_pictures.h"

#include <sodium/utils.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/json_parse.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

using PagesJson = nlohmann::json;

/// Five hundred of them take a few megabytes.
constexpr int kListPicturePixels = 112;

std::optional<Picture> pictureIn(const PagesJson& frame, const char* key) {
  const auto found = frame.find(key);
  if (found == frame.end() || !found->is_string()) return std::nullopt;
  const std::string& text = found->get_ref<const std::string&>();
  Bytes bytes(text.size() / 4 * 3);
  std::size_t size = 0;
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &size, nullptr,
                        sodium_base64_VARIANT_ORIGINAL) != 0) {
    return std::nullopt;
  }
  auto picture = decodePng(ByteView(bytes).first(size), key);
  if (!picture.ok()) return std::nullopt;
  return std::move(*picture);
}

}  // namespace

Picture listPicture(const Picture& picture) { return reducedPicture(picture, kListPicturePixels); }

std::string base64Text(ByteView bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.resize(std::char_traits<char>::length(text.c_str()));
  return text;
}

std::string pagePicturesJson(const SuiteReport& report) {
  PagesJson frames = PagesJson::object();
  for (const JudgedFrame& judged : report.frames) {
    PagesJson frame = PagesJson::object();
    if (judged.thumbnail) frame["small"] = base64Text(encodePng(listPicture(*judged.thumbnail)));
    if (judged.why && !judged.why->blame.mask.rgba.empty()) {
      frame["blame"] = base64Text(encodePng(judged.why->blame.mask));
    }
    if (judged.unmasked && !isFine(judged.verdict)) {
      frame["compared"] = base64Text(encodePng(*judged.unmasked));
    }
    if (judged.areas && canApprove(judged)) {
      frame["areas"] = base64Text(encodePng(*judged.areas));
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
