#include "viewer/ui/interface_context.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>

#include "viewer/render/embedded_font.h"
#include "viewer/ui/panels.h"

namespace rocinante {
namespace {

constexpr float kFontPixels = 15;

}  // namespace

InterfaceContext::InterfaceContext(GLFWwindow* window) : window_(window) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  const ByteView font = embeddedFont();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  io.Fonts->AddFontFromMemoryTTF(const_cast<std::byte*>(font.data()), static_cast<int>(font.size()),
                                 kFontPixels, &config);
  stylePanels();
  if (window_ != nullptr) ImGui_ImplGlfw_InitForOpenGL(window_, true);
}

InterfaceContext::~InterfaceContext() {
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void InterfaceContext::beginFrame(int width, int height) {
  if (window_ != nullptr) {
    ImGui_ImplGlfw_NewFrame();
  } else {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = 1.0F / 60.0F;
  }
  ImGui::NewFrame();
}

}  // namespace rocinante
