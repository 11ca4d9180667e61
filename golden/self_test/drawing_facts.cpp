#include "golden/self_test/drawing_facts.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>

#include "golden/compare/compare.h"
#include "golden/self_test/test_frame.h"
#include "viewer/detail/detail_cache.h"
#include "viewer/gl/gl_table.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/gl/renderer_key.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;

constexpr const char* kReport =
    "please report it, with the picture of `rocinante self-test draw -o frame.png`";

SelfTestFact unknownFact(const char* name, const char* first) {
  return {name, State::missing, "not known", fmt::format("fix {} first", first)};
}

std::string versionsOf(const RendererKey& key) {
  std::string text;
  if (!key.mesa.empty()) text += ", Mesa " + key.mesa;
  if (!key.llvm.empty()) text += ", LLVM " + key.llvm;
  return text;
}

SelfTestFact drawFrame(Picture* drawn) {
  const auto refused = [](const Error& error) {
    return SelfTestFact{"frame", State::missing, error.text(), kReport};
  };
  auto cell = testCell();
  if (!cell) return refused(cell.error());
  auto maker = FrameMaker::open(std::move(*cell), std::nullopt, Profile::reproducible);
  if (!maker) return refused(maker.error());
  auto picture = maker->frame(testFrameRequest());
  if (!picture) return refused(picture.error());
  SelfTestFact fact = judgeTestFrame(*picture, maker->key().text());
  if (drawn != nullptr) *drawn = std::move(*picture);
  return fact;
}

}  // namespace

SelfTestFact judgeTestFrame(const Picture& drawn, const std::string& key) {
  const std::string sha256 = pictureSha256(drawn);
  const auto known = knownFrames();
  const auto by_key = std::find_if(known.begin(), known.end(),
                                   [&](const KnownFrame& each) { return each.key == key; });
  const auto by_bits = std::find_if(known.begin(), known.end(),
                                    [&](const KnownFrame& each) { return each.sha256 == sha256; });
  if (by_key != known.end()) {
    if (by_key->sha256 == sha256) {
      return {"frame", State::ok, fmt::format("{}: as on every {}", sha256, by_key->where), ""};
    }
    return {"frame", State::missing,
            fmt::format("{}, and this renderer draws {} on every {}", sha256, by_key->sha256,
                        by_key->where),
            std::string("goldens of other machines will differ here: ") + kReport};
  }
  if (by_bits != known.end()) {
    return {"frame", State::ok,
            fmt::format("{}: this renderer is not known, but draws the same frame as {}", sha256,
                        by_bits->where),
            ""};
  }
  const auto reference = referenceFrame();
  if (!reference) return {"frame", State::missing, reference.error().text(), kReport};
  const Comparison difference = compare(drawn, *reference, Tolerance::rounding());
  const std::string what = fmt::format(
      "{}: this renderer is not known; of {} pixels {} differ from {}, by at most {} of 255",
      sha256, drawn.rgba.size() / 4, difference.differing, known.front().where, difference.max);
  if (difference.verdict != Verdict::same) return {"frame", State::missing, what, kReport};
  return {"frame", State::limited, what + ", within rounding",
          "goldens of other machines are judged within rounding here; for exact equality approve "
          "them here too (rocinante golden approve)"};
}

std::vector<SelfTestFact> drawingFacts(Picture* drawn) {
  auto context = makeOffscreenContext(Profile::reproducible);
  if (!context) {
    return {{"context", State::missing, context.error().text(),
             "install Mesa's software renderer, then run this again"},
            unknownFact("key", "context"),
            unknownFact("frame", "context")};
  }
  const auto gl = fillGlTable([&](const char* name) { return (*context)->procAddress(name); });
  if (!gl) {
    return {{"context", State::missing, gl.error().text(), "install Mesa's llvmpipe"},
            unknownFact("key", "context"),
            unknownFact("frame", "context")};
  }
  const RendererKey key = rendererKey(*gl);
  std::vector<SelfTestFact> facts{
      {"context", State::ok, std::string((*context)->name()) + versionsOf(key), ""}};
  if (Status fit = requireReproducible(key); !fit) {
    facts.push_back({"key", State::missing, fit.error().text(),
                     "install Mesa with llvmpipe; `render --profile fast` draws with any driver"});
    facts.push_back(unknownFact("frame", "key"));
    return facts;
  }
  facts.push_back({"key", State::ok, key.text(), ""});
  context->reset();
  facts.push_back(drawFrame(drawn));
  return facts;
}

SelfTestFact picturesFact() {
  const auto picture = decodePicture(testPictureFile(), "built in");
  if (!picture) {
    return {"pictures", State::limited, picture.error().text(),
            "install the package that has it (rocinante built with OpenImageIO), or use PNG"};
  }
  return {"pictures", State::ok, "PNG, JPEG, TIFF, EXR and others can be read", ""};
}

SelfTestFact cacheFact() {
  const std::filesystem::path folder = DetailCache::ofUser().folder();
  const char* advice = "set XDG_CACHE_HOME to a folder that you may write to";
  if (folder.empty()) {
    return {"cache", State::limited, "no cache folder: view rebuilds coarser meshes at every start",
            advice};
  }
  // It is created on first use: check whether it can be created.
  std::filesystem::path there = folder;
  std::error_code fault;
  while (!std::filesystem::exists(there, fault) && there.has_relative_path()) {
    there = there.parent_path();
  }
  if (::access(there.c_str(), W_OK | X_OK) == 0 && std::filesystem::is_directory(there, fault)) {
    return {"cache", State::ok, folder.string(), ""};
  }
  return {"cache", State::limited,
          fmt::format("{}: {}: view rebuilds coarser meshes at every start", folder.string(),
                      errno != 0 ? std::strerror(errno) : "not a folder"),
          advice};
}

}  // namespace rocinante
