// Which textures of a frame are filtered anisotropically: none on a software renderer, whose
// sampler takes seconds for it at some views, or does not end.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/passes/texture_store.h"
#include "viewer/picture/mipmaps.h"
#include "viewer/picture/picture.h"
#include "viewer/render/renderer.h"

#ifndef GL_TEXTURE_MAX_ANISOTROPY
#define GL_TEXTURE_MAX_ANISOTROPY 0x84FE
#endif

namespace rocinante {
namespace {

using test::colored;
using test::squareMesh;
using test::TestCell;

Picture checkered() {
  Picture picture{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const auto level = static_cast<std::uint8_t>((i + i / 64) % 2 * 255);
    picture.rgba.insert(picture.rgba.end(), {level, level, level, 255});
  }
  return picture;
}

/// All textures and samplers of a context, as GL itself has them.
class ContextFilters {
 public:
  ContextFilters(const RenderContext& context, const GlTable& gl)
      : gl_(gl),
        is_texture_(reinterpret_cast<PFNGLISTEXTUREPROC>(context.procAddress("glIsTexture"))),
        is_sampler_(reinterpret_cast<PFNGLISSAMPLERPROC>(context.procAddress("glIsSampler"))),
        of_texture_(reinterpret_cast<PFNGLGETTEXPARAMETERFVPROC>(
            context.procAddress("glGetTexParameterfv"))),
        of_sampler_(reinterpret_cast<PFNGLGETSAMPLERPARAMETERFVPROC>(
            context.procAddress("glGetSamplerParameterfv"))) {}

  struct Found {
    int textures = 0;
    float strongest = 1;
  };
  Found look() const {
    constexpr GLuint kMostNames = 256;
    Found found;
    for (GLuint name = 1; name < kMostNames; ++name) {
      float strength = 1;
      if (is_texture_(name) == GL_TRUE) {
        ++found.textures;
        gl_.BindTexture(GL_TEXTURE_2D, name);
        of_texture_(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY, &strength);
        found.strongest = std::max(found.strongest, strength);
      }
      if (is_sampler_(name) == GL_TRUE) {
        of_sampler_(name, GL_TEXTURE_MAX_ANISOTROPY, &strength);
        found.strongest = std::max(found.strongest, strength);
      }
    }
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    return found;
  }

 private:
  const GlTable& gl_;
  PFNGLISTEXTUREPROC is_texture_;
  PFNGLISSAMPLERPROC is_sampler_;
  PFNGLGETTEXPARAMETERFVPROC of_texture_;
  PFNGLGETSAMPLERPARAMETERFVPROC of_sampler_;
};

class TextureFilter : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(writePng(folder_ / "checks.png", checkered(), true).has_value());
    auto context = makeOffscreenContext(Profile::fast);
    ASSERT_TRUE(context.has_value()) << context.error().text();
    context_ = std::move(*context);
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<RenderContext> context_;
};

TEST_F(TextureFilter, NoTextureOfAFrameIsAnisotropicOnASoftwareRenderer) {
  Material material = colored(1, 1, 1);
  material.diffuse_map = folder_ / "checks.png";
  TestCell cell;
  cell.cell().scene.grid = true;
  cell.add("floor", squareMesh(8), {0, 0, 0}, material)
      .add("box", squareMesh(2), {2, -1, 2}, colored(1, 0, 0, 0.5F));
  auto renderer = Renderer::create(*context_, cell.cell(), Profile::fast);
  ASSERT_TRUE(renderer.has_value()) << renderer.error().text();
  ASSERT_TRUE(renderer->gl().is_software) << renderer->key().renderer;

  // A frame with every pass that has a texture: surfaces, backdrop, shadows, contact, edges,
  // outlines, labels.
  RenderStyle style;
  for (const char* word : {"shadows", "contact", "edges", "outlined=box", "axes=*", "scale-bar",
                           "measure=box/body@0,0,0~floor/body@0,0,0"}) {
    ASSERT_TRUE(setStyle(style, word).has_value()) << word;
  }
  BackdropPicture backdrop{1, {checkered()}};
  for (Picture& smaller : mipmapsOf(backdrop.levels[0])) backdrop.levels.push_back(smaller);
  const PosedScene scene = cell.scene();
  const ViewChoice choice;
  const FrameExtras extras;
  CameraView view;
  view.eye = {0, -20, 1};
  view.intrinsics = CameraIntrinsics{60, 60, 32, 32, 64, 64};
  SceneFrame frame{&scene, view, &choice, &style, &extras};
  frame.backdrop = &backdrop;
  frame.main_has_backdrop = true;
  const auto target = FrameBuffer::create(renderer->gl(), 160, 160, 4);
  ASSERT_TRUE(target.has_value()) << target.error().text();
  const auto drawn = renderer->draw(frame, *target);
  ASSERT_TRUE(drawn.has_value()) << drawn.error().text();
  ASSERT_TRUE(renderer->identity(frame, *FrameBuffer::create(renderer->gl(), 160, 160, 1)).ok());

  const auto found = ContextFilters(*context_, renderer->gl()).look();
  EXPECT_GE(found.textures, 6);
  EXPECT_EQ(found.strongest, 1);
}

TEST_F(TextureFilter, AGpuGetsItInTheFastProfileOnly) {
  const std::vector<CatalogTexture> files{{folder_ / "checks.png", nullptr, {}}};
  auto gl = fillGlTable([&](const char* name) { return context_->procAddress(name); });
  ASSERT_TRUE(gl.has_value()) << gl.error().text();
  if (!gl->hasExtension("GL_EXT_texture_filter_anisotropic")) GTEST_SKIP() << "no such extension";
  const auto strongest = [&](bool is_software, Profile profile) {
    gl->is_software = is_software;
    InputsHash inputs;
    const TextureStore store(*gl, files, profile, inputs);
    return ContextFilters(*context_, *gl).look().strongest;
  };
  EXPECT_EQ(strongest(true, Profile::fast), 1);
  EXPECT_GT(strongest(false, Profile::fast), 1);
  EXPECT_EQ(strongest(false, Profile::reproducible), 1);
}

}  // namespace
}  // namespace rocinante
