#include "viewer/gl/gl_name.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace rocinante {
namespace {

GLuint next_name = 1;
std::multiset<GLuint> alive_names;

GLuint made() {
  alive_names.insert(next_name);
  return next_name++;
}

GlTable countingTable() {
  alive_names.clear();
  GlTable gl;
  gl.GenTextures = [](GLsizei, GLuint* name) { *name = made(); };
  gl.DeleteTextures = [](GLsizei, const GLuint* name) { EXPECT_EQ(alive_names.erase(*name), 1U); };
  gl.CreateShader = [](GLenum) { return made(); };
  gl.DeleteShader = [](GLuint name) { EXPECT_EQ(alive_names.erase(name), 1U); };
  return gl;
}

TEST(GlName, IsDeletedOnceWhereverItWent) {
  const GlTable gl = countingTable();
  {
    EXPECT_EQ(GlTexture(), 0U);
    GlTexture first(gl);
    const GLuint name = first;
    EXPECT_NE(name, 0U);
    GlTexture second(std::move(first));
    EXPECT_EQ(first, 0U);
    EXPECT_EQ(second, name);
    std::vector<GlTexture> all;
    for (int i = 0; i < 10; ++i) all.emplace_back(gl);
    all.erase(all.begin());
    all.push_back(std::move(second));
    EXPECT_EQ(all.back(), name);
    EXPECT_EQ(alive_names.size(), 10U);
    all.back() = GlTexture(gl);
    EXPECT_EQ(alive_names.count(name), 0U);
    all.back() = {};
    EXPECT_EQ(alive_names.size(), 9U);
  }
  EXPECT_TRUE(alive_names.empty());
}

TEST(GlName, MayBeMadeAndDeletedOneByOne) {
  const GlTable gl = countingTable();
  { const GlShader shader(gl, GL_VERTEX_SHADER); }
  EXPECT_TRUE(alive_names.empty());
  EXPECT_GT(next_name, 1U);
}

}  // namespace
}  // namespace rocinante
