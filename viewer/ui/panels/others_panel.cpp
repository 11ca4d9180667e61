#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "core/base/plain_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

void drawViewpoints(ViewModel& model) {
  const std::string watched = model.watched();
  for (const std::string& name : model.viewsOfOthers()) {
    ImGui::PushID(name.c_str());
    const bool here = name == watched;
    if (ImGui::SmallButton(here ? "stop" : "watch")) {
      here ? model.stopWatching() : model.useCamera(name);
    }
    explain(here ? "stay here, without following" : "see what they see (Z: the next one)");
    ImGui::SameLine();
    if (model.others().isSilent(name)) {
      ImGui::TextDisabled("%s: silent", plainText(name).c_str());
      explain("nothing arrives from this window any more: it was killed, or the network loses it");
    } else {
      ImGui::TextUnformatted(plainText(name).c_str());
    }
    ImGui::PopID();
  }
}

void drawBeginning(Publishing& publishing) {
  if (publishing.endpoint_text[0] == 0) {
    std::snprintf(publishing.endpoint_text.data(), publishing.endpoint_text.size(), "%s",
                  Endpoint::standard().text().c_str());
  }
  ImGui::SetNextItemWidth(px(-40));
  ImGui::InputText("to", publishing.endpoint_text.data(), publishing.endpoint_text.size());
  explain("an endpoint that the others hear: 192.168.0.7:19960, udp://GROUP:PORT?interface=lo");
  ImGui::SetNextItemWidth(px(-90));
  const bool entered =
      ImGui::InputTextWithHint("##name", "your name", publishing.name_text.data(),
                               publishing.name_text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("publish", ImVec2(-1, 0)) || entered) {
    const Status begun =
        publishing.begin(publishing.endpoint_text.data(), publishing.name_text.data(),
                         std::chrono::steady_clock::now(), std::chrono::system_clock::now());
    publishing.trouble = begun ? std::string() : begun.error().text();
  }
  explain("others see where this window looks and points");
  if (publishing.trouble.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(panelInk(PanelColor::fault), "%s", linesOf(publishing.trouble).c_str());
  ImGui::PopTextWrapPos();
}

void drawPublished(Publishing& publishing) {
  bool pointer = publishing.points();
  if (ImGui::Checkbox("pointer", &pointer)) publishing.setPointer(pointer);
  explain("others see where the mouse points");
  ImGui::SameLine();
  if (ImGui::SmallButton(publishing.drawsLine() ? "end line" : "line")) {
    publishing.drawsLine() ? publishing.endClicks() : publishing.beginLine();
  }
  explain("clicks draw a line");
  ImGui::SameLine();
  if (ImGui::SmallButton("erase")) publishing.eraseDrawn();
  explain("the lines and labels of this window");
  ImGui::SameLine();
  if (ImGui::SmallButton("end"))
    return publishing.end(std::chrono::steady_clock::now(), std::chrono::system_clock::now());
  explain("publish nothing more");
  auto& text = publishing.message_text;
  ImGui::SetNextItemWidth(px(-90));
  const bool entered = ImGui::InputTextWithHint("##said", "a text for others", text.data(),
                                                text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  const bool sends = ImGui::SmallButton("say") || entered;
  explain("as an event (Enter)");
  ImGui::SameLine();
  const bool labels = ImGui::SmallButton("label");
  explain("as a label, where the next click is");
  if (text[0] == 0) return;
  if (sends) publishing.say(text.data());
  if (labels) publishing.beginLabel(text.data());
  if (sends || labels) text[0] = 0;
}

}  // namespace

OthersBanner othersBanner(const ViewModel& model) {
  OthersBanner banner;
  const Publishing& publishing = model.publishing;
  const bool with_others = model.isLive() || publishing.active() != nullptr;
  if (const std::string watched = model.watched(); with_others && !watched.empty()) {
    banner.what = fmt::format("the view is that of {}", plainText(watched));
    banner.hint = model.others().isSilent(watched) ? "it is silent: closed, or cannot be heard"
                                                   : "Z or a drag ends it";
  }
  const Publisher* const publisher = publishing.active();
  if (publisher == nullptr) return banner;
  if (banner.what.empty()) {
    banner.what = fmt::format("others see this window as `{}` at {}", plainText(publisher->name()),
                              publisher->endpoint().text());
  } else {
    banner.hint +=
        fmt::format("; until then, others see `{}` where it was", plainText(publisher->name()));
  }
  if (publishing.drawsLine()) {
    banner.hint = "click the corners of the line; Esc ends it";
  } else if (publishing.takesClicks()) {
    banner.hint = fmt::format("click where `{}` goes; Esc: nowhere", plainText(publishing.label()));
  }
  if (!publisher->trouble().empty()) {
    banner.hint = publisher->trouble();
    banner.is_fault = true;
  }
  return banner;
}

void drawOthers(ViewModel& model) {
  const bool publishes = model.publishing.active() != nullptr;
  if (!publishes && !model.isLive()) return;
  if (!ImGui::CollapsingHeader("Others", publishes ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return;
  ImGui::PushID("others");
  drawViewpoints(model);
  publishes ? drawPublished(model.publishing) : drawBeginning(model.publishing);
  ImGui::PopID();
}

}  // namespace rocinante
