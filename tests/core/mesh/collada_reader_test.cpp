// COLLADA: what is drawn, what the account names, and files that mean harm.

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>

#include "core/report/account.h"
#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using test::expectSound;
using test::ReadMesh;
using test::readMesh;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// A file with one of everything that is read: every primitive, transforms, instances, a skin,
/// colours by point, two sets of texture coordinates, parameters, and an image.
constexpr const char* kEverything = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><contributor><author>us</author></contributor><unit name="cm" meter="0.01"/><up_axis>X_UP</up_axis></asset>
<library_images><image id="img"><init_from>skin.png</init_from></image></library_images>
<library_effects>
<effect id="painted"><profile_COMMON>
<newparam sid="surface"><surface type="2D"><init_from>img</init_from></surface></newparam>
<newparam sid="sampler"><sampler2D><source>surface</source><wrap_s>CLAMP</wrap_s><wrap_t>MIRROR</wrap_t></sampler2D></newparam>
<technique sid="common"><lambert><diffuse><texture texture="sampler" texcoord="UVB"/></diffuse></lambert></technique>
</profile_COMMON></effect>
<effect id="glossy"><profile_COMMON><newparam sid="tint"><float4>0.25 0.5 0.75 1</float4></newparam>
<technique sid="common"><phong><emission><color>0.1 0.2 0.3 1</color></emission>
<diffuse><param ref="tint"/></diffuse><specular><color>0.5 0.25 0.5 1</color></specular>
<shininess><float>32</float></shininess><transparent opaque="RGB_ZERO"><color>0.5 0.5 0.5 1</color></transparent>
<transparency><float>0.5</float></transparency></phong></technique></profile_COMMON></effect>
</library_effects>
<library_materials><material id="m1" name="paint"><instance_effect url="#painted"/></material>
<material id="m2" name="gloss"><instance_effect url="#glossy"/></material></library_materials>
<library_geometries>
<geometry id="quad"><mesh>
<source id="qp"><float_array id="qpa" count="12">0 0 0 4 0 0 4 4 0 0 4 0</float_array><technique_common>
<accessor source="#qpa" count="4" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>
<source id="qn"><float_array id="qna" count="3">0 0 1</float_array><technique_common>
<accessor source="#qna" count="1" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>
<source id="q1"><float_array id="q1a" count="8">0 0 1 0 1 1 0 1</float_array><technique_common>
<accessor source="#q1a" count="4" stride="2"><param name="S"/><param name="T"/></accessor></technique_common></source>
<vertices id="qv"><input semantic="POSITION" source="#qp"/></vertices>
<polylist material="M" count="1"><input semantic="VERTEX" source="#qv" offset="0"/><input semantic="NORMAL" source="#qn" offset="1"/>
<input semantic="TEXCOORD" source="#q1" offset="0" set="1"/><vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>
</mesh></geometry>
<geometry id="many"><mesh>
<source id="mp"><float_array id="mpa" count="33">0 0 0 3 0 0 3 3 0 0 3 0 1 1 0 2 1 0 2 2 0 1 2 0 5 0 0 6 0 0 6 1 0</float_array><technique_common>
<accessor source="#mpa" count="11" stride="3"><param name="X"/><param name="Y"/><param name="Z"/></accessor></technique_common></source>
<source id="mc"><float_array id="mca" count="6">1 0 0 0 0 1</float_array><technique_common>
<accessor source="#mca" count="2" stride="3"><param name="R"/><param name="G"/><param name="B"/></accessor></technique_common></source>
<vertices id="mv"><input semantic="POSITION" source="#mp"/></vertices>
<triangles material="N" count="1"><input semantic="VERTEX" source="#mv" offset="0"/><input semantic="COLOR" source="#mc" offset="1"/><p>8 0 9 1 10 1</p></triangles>
<polygons material="N" count="2"><input semantic="VERTEX" source="#mv" offset="0"/><p>0 1 2 3</p><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons>
<tristrips material="N" count="1"><input semantic="VERTEX" source="#mv" offset="0"/><p>0 1 3 2</p></tristrips>
<trifans material="N" count="1"><input semantic="VERTEX" source="#mv" offset="0"/><p>0 1 2 3</p></trifans>
</mesh></geometry>
</library_geometries>
<library_nodes><node id="lib" name="lib"><translate>0 0 7</translate><instance_geometry url="#quad"><bind_material><technique_common>
<instance_material symbol="M" target="#m2"/></technique_common></bind_material></instance_geometry></node></library_nodes>
<library_visual_scenes><visual_scene id="S">
<node name="a"><matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix><rotate>0 0 1 90</rotate><skew>20 0 1 0 0 0 1</skew><scale>1 2 -1</scale>
<instance_geometry url="#quad"><bind_material><technique_common><instance_material symbol="M" target="#m1">
<bind_vertex_input semantic="UVB" input_semantic="TEXCOORD" input_set="1"/></instance_material></technique_common></bind_material></instance_geometry>
<node name="b"><lookat>1 2 3 0 0 0 0 1 0</lookat><instance_geometry url="#many"><bind_material><technique_common>
<instance_material symbol="N" target="#m2"/></technique_common></bind_material></instance_geometry></node></node>
<node name="c"><instance_node url="#lib"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#S"/></scene></COLLADA>)";

/// Everything that a picture or a terminal would show of it.
std::string toldOf(std::string_view text) {
  Findings faults;
  MeshReadOptions options;
  options.resolve = [](const std::string& name, const std::filesystem::path&) {
    FoundFile found;
    found.why = FoundFile::Why::found;
    found.path = "/images/" + name;
    return found;
  };
  const auto mesh = readMeshBytes(bytesOf(text), "a.dae", options, faults);
  return test::told(mesh, faults);
}

std::vector<std::string> leftOutOf(const Findings& faults) {
  std::vector<std::string> left_out;
  for (const Finding& fault : faults) {
    if (!fault.left_out.empty()) left_out.push_back(fault.left_out);
  }
  return left_out;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Calls `change` with each element of the file, each time in a fresh copy, and `check` with the
/// text that comes of it.
void forEachElement(const std::function<bool(tinyxml2::XMLElement&)>& change,
                    const std::function<void(const std::string&)>& check) {
  for (std::size_t wanted = 0;; ++wanted) {
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(kEverything), tinyxml2::XML_SUCCESS);
    std::size_t number = 0;
    tinyxml2::XMLElement* element = document.RootElement();
    while (element != nullptr && number < wanted) {
      tinyxml2::XMLElement* next = element->FirstChildElement();
      while (next == nullptr && element != nullptr) {
        next = element->NextSiblingElement();
        if (next == nullptr) element = element->Parent()->ToElement();
      }
      element = next;
      ++number;
    }
    if (element == nullptr) return;
    SCOPED_TRACE(fmt::format("element {}: {}", wanted, element->Name()));
    if (!change(*element)) continue;
    tinyxml2::XMLPrinter printer(nullptr, true);
    document.Print(&printer);
    check(printer.CStr());
  }
}

TEST(ColladaAccount, AFileOfWhatIsReadLeavesNothingOut) {
  const ReadMesh read = readMesh(replaced(kEverything, "skin.png", "no.png"), "a.dae");
  EXPECT_THAT(read.rules(), UnorderedElementsAre("mesh.up-axis", "mesh.missing-texture"));
  EXPECT_THAT(toldOf(kEverything), HasSubstr("skin.png  2 1 1 0\n"));
}

TEST(ColladaAccount, WhatIsRemovedChangesWhatIsDrawnOrTold) {
  const std::string whole = toldOf(kEverything);
  std::size_t checked = 0;
  // The quad has one set of texture coordinates, which its image gets with or without a binding.
  const std::set<std::string_view> changes_nothing = {"contributor", "author", "bind_vertex_input"};
  forEachElement(
      [&](tinyxml2::XMLElement& element) {
        if (element.Parent()->ToElement() == nullptr || changes_nothing.contains(element.Name())) {
          return false;
        }
        element.Parent()->DeleteChild(&element);
        return true;
      },
      [&](const std::string& text) {
        ++checked;
        EXPECT_TRUE(toldOf(text) != whole);
      });
  EXPECT_GT(checked, 80U);
}

TEST(ColladaAccount, AnUnknownElementOrAttributeIsNamedWhereverItStands) {
  forEachElement(
      [](tinyxml2::XMLElement& element) {
        for (const tinyxml2::XMLNode* above = &element; above != nullptr; above = above->Parent()) {
          const auto* const named = above->ToElement();
          if (named != nullptr && std::string_view(named->Name()) == "contributor") return false;
        }
        element.InsertNewChildElement("surprise");
        element.SetAttribute("astonishing", 1);
        return true;
      },
      [](const std::string& text) {
        Findings faults;
        (void)readMeshBytes(bytesOf(text), "a.dae", {}, faults);
        EXPECT_THAT(leftOutOf(faults), Contains("element `surprise`"));
        EXPECT_THAT(leftOutOf(faults), Contains("attribute `astonishing`"));
      });
}

TEST(ColladaAccount, ADocumentOfEverythingIgnoredNamesIt) {
  std::string text = replaced(
      kEverything, "<library_nodes>",
      "<library_animations><animation id=\"x\"/><animation id=\"y\"/></library_animations>"
      "<library_cameras><camera id=\"eye\"/></library_cameras><library_lights/>"
      "<library_physics_scenes><physics_scene/></library_physics_scenes>"
      "<library_kinematics_models><kinematics_model/></library_kinematics_models><library_nodes>");
  text = replaced(text, "<triangles", "<lines count=\"1\"/><triangles");
  text = replaced(text, "<lambert>", "<lambert><ambient><color>1 1 1 1</color></ambient>");
  text = replaced(text, "<scene>", "<extra><technique profile=\"MAX3D\"/></extra><scene>");
  const ReadMesh read = readMesh(text, "a.dae");
  EXPECT_THAT(leftOutOf(read.faults),
              UnorderedElementsAre("element `animation`", "element `camera`",
                                   "element `physics_scene`", "element `kinematics_model`",
                                   "element `lines`", "element `ambient`", "extension `MAX3D`"));
  EXPECT_EQ(accountOf(read.faults).total(), 8U);
}

TEST(ColladaReader, ASkinIsDrawnAsItsMeshAndIsInTheAccount) {
  const std::string skin =
      "<library_controllers><controller id=\"c\"><skin source=\"#quad\"><vertex_weights "
      "count=\"4\"><v> 0 0 letters 99999999999999999999</v></vertex_weights></skin></controller>"
      "</library_controllers><library_nodes>";
  std::string text = replaced(kEverything, "<library_nodes>", skin);
  text = replaced(text, "<node name=\"a\">",
                  "<node name=\"z\"><instance_controller url=\"#c\"><skeleton>#none</skeleton>"
                  "</instance_controller></node><node name=\"a\">");
  const ReadMesh read = readMesh(text, "a.dae");
  EXPECT_EQ(read.mesh.parts.at(0).group, "z");
  EXPECT_THAT(leftOutOf(read.faults), UnorderedElementsAre("element `skin`"));
}

TEST(ColladaReader, ReferencesThatLeadToThemselvesEnd) {
  std::string text = replaced(
      kEverything, "<library_nodes>",
      "<library_controllers><controller id=\"c\"><skin source=\"#d\"/></controller><controller "
      "id=\"d\"><morph source=\"#c\"/></controller></library_controllers><library_nodes>");
  text = replaced(text, "<node name=\"a\">",
                  "<node name=\"z\"><instance_controller url=\"#c\"/></node><node name=\"a\">");
  text = replaced(text, "<source>surface</source>", "<source>sampler</source>");
  text = replaced(text, "<init_from>img</init_from>", "<init_from>surface</init_from>");
  const ReadMesh read = readMesh(text, "a.dae");
  EXPECT_THAT(
      read.rules(),
      UnorderedElementsAre("mesh.up-axis", "collada.bad-reference", "collada.bad-reference",
                           "model.left-out", "model.left-out", "model.left-out", "model.left-out"));
}

TEST(ColladaReader, NamesTheHullOfAnotherGeometry) {
  const auto withHull = [](const std::string& hull) {
    std::string text =
        replaced(kEverything, "<library_geometries>",
                 "<library_geometries><geometry id=\"hull\">" + hull + "</geometry>");
    return readMesh(replaced(text, "<node name=\"a\">",
                             "<node name=\"h\"><instance_geometry url=\"#hull\"/></node>"
                             "<node name=\"a\">"),
                    "a.dae");
  };
  const ReadMesh read = withHull("<convex_mesh convex_hull_of=\"#quad\"/>");
  const auto named = std::ranges::find(read.faults, "element `convex_mesh`", &Finding::left_out);
  ASSERT_NE(named, read.faults.end());
  EXPECT_EQ(named->severity, Severity::warning);
  EXPECT_GT(named->line, 0);
  // One with triangles of its own is drawn.
  const std::string_view all = kEverything;
  const std::size_t from = all.find("<mesh>") + 6;
  const std::string own(all.substr(from, all.find("</mesh>") - from));
  const ReadMesh drawn = withHull("<convex_mesh>" + own + "</convex_mesh>");
  EXPECT_GT(drawn.mesh.triangleCount(), read.mesh.triangleCount());
  EXPECT_THAT(drawn.leftOut(), ::testing::Not(Contains("element `convex_mesh`")));
}

TEST(ColladaReader, EveryReferenceMayNameAnythingOrNothing) {
  for (const std::string to : {"", "#", "#qp", "#none", "other.dae#qp", "#S", "#m1", "#qpa"}) {
    forEachElement(
        [&](tinyxml2::XMLElement& element) {
          bool changed = false;
          for (const char* each : {"url", "source", "target"}) {
            if (element.Attribute(each) == nullptr) continue;
            element.SetAttribute(each, to.c_str());
            changed = true;
          }
          return changed;
        },
        [](const std::string& text) { EXPECT_FALSE(toldOf(text).empty()); });
  }
}

TEST(ColladaReader, NumbersMayBeAnything) {
  for (const char* numbers :
       {"", " ", "x", "1", "-1 -1 -1", "99999999999999999999 1 2 3", "nan nan nan nan", "1e999",
        "4294967295 4294967295 4294967295", "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 x"}) {
    forEachElement(
        [&](tinyxml2::XMLElement& element) {
          if (element.FirstChildElement() != nullptr) return false;
          element.SetText(numbers);
          return true;
        },
        [](const std::string& text) { EXPECT_FALSE(toldOf(text).empty()); });
  }
}

TEST(ColladaReader, CountsMayBeAnything) {
  for (const char* number : {"", "x", "-1", "0", "1", "2", "1000000", "18446744073709551615"}) {
    forEachElement(
        [&](tinyxml2::XMLElement& element) {
          bool changed = false;
          for (const char* each : {"count", "stride", "offset", "set", "input_set", "meter"}) {
            if (element.Attribute(each) == nullptr) continue;
            element.SetAttribute(each, number);
            changed = true;
          }
          return changed;
        },
        [](const std::string& text) { EXPECT_FALSE(toldOf(text).empty()); });
  }
}

TEST(ColladaReader, SurvivesEveryPrefix) {
  const std::string whole = kEverything;
  for (std::size_t length = 0; length < whole.rfind("</COLLADA>"); ++length) {
    Findings faults;
    EXPECT_FALSE(readMeshBytes(bytesOf(whole.substr(0, length)), "a.dae", {}, faults).ok());
  }
}

TEST(ColladaReader, SurvivesEveryByteChanged) {
  const std::string whole = kEverything;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char c : {'\0', ' ', '9', '<', '"', '\x80'}) {
      std::string text = whole;
      text[at] = c;
      Findings faults;
      const auto mesh = readMeshBytes(bytesOf(text), "a.dae", {}, faults);
      if (mesh) expectSound(*mesh);
    }
  }
}

TEST(ColladaReader, WorkIsBoundedWhateverIsRepeated) {
  // Each of these repeats something within something repeated.
  const auto repeat = [](std::string_view text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  const std::string lists =
      repeat("<input semantic=\"TEXCOORD\" source=\"#q1\" offset=\"0\" set=\"7\"/>", 20000);
  const std::string instances = repeat("<instance_node url=\"#lib\"/>", 100000);
  const std::string parameters = repeat("<newparam sid=\"p\"><float>1</float></newparam>", 20000);
  const std::string polygons = repeat(
      "<polygons material=\"N\" count=\"1\"><input semantic=\"VERTEX\" source=\"#mv\" "
      "offset=\"0\"/><p>0 1 2</p></polygons>",
      20000);
  for (const std::string& text :
       {replaced(replaced(kEverything, "<vcount>4", lists + "<vcount>4"),
                 "<instance_node url=\"#lib\"/>", instances),
        replaced(kEverything, "<newparam sid=\"tint\">", parameters + "<newparam sid=\"tint\">"),
        replaced(kEverything, "<tristrips", polygons + "<tristrips"),
        replaced(kEverything, "<float4>0.25", "<float4>" + repeat("<!--x-->", 100000) + "0.25"),
        replaced(kEverything, "<author>us", "<author>" + repeat("<a b=''/>", 100000))}) {
    Findings faults;
    const auto begin = std::chrono::steady_clock::now();
    (void)readMeshBytes(bytesOf(text), "a.dae", {}, faults);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  }
}

TEST(ColladaReader, OneBadPolygonIsLeftOutAndTheRestIsDrawn) {
  const std::size_t whole = readMesh(kEverything, "a.dae").mesh.triangleCount();
  struct Case {
    const char* from;
    const char* to;
    const char* rule;
    std::size_t lost;
  };
  for (const Case& each : {
           Case{"<p>8 0 9 1 10 1</p>", "<p>8 0 x 1 10 1</p>", "collada.bad-index", 1},
           {"<p>8 0 9 1 10 1</p>", "<p>8 0 9 1 11 1</p>", "collada.bad-index", 1},
           {"<p>8 0 9 1 10 1</p>", "<p>8 0 9 1 10</p>", "collada.bad-count", 1},
           {"<vcount>4</vcount>", "<vcount>5</vcount>", "collada.bad-count", 4},
           {"<vcount>4</vcount>", "<vcount>3</vcount>", "collada.bad-count", 2},
           {"6 0 0 6 1 0<", "6 0 0 6 nan 0<", "mesh.bad-triangle", 1},
           {"6 0 0 6 1 0<", "6 0 0 6 x 0<", "collada.bad-value", 1},
           {"6 0 0 6 1 0<", "6 0 0<", "collada.bad-count", 1},
           {"count=\"11\" stride", "count=\"12\" stride", "collada.bad-count", 0},
       }) {
    SCOPED_TRACE(each.to);
    const ReadMesh read = readMesh(replaced(kEverything, each.from, each.to), "a.dae");
    EXPECT_THAT(read.rules(), Contains(each.rule));
    EXPECT_EQ(read.mesh.triangleCount(), whole - each.lost);
    EXPECT_TRUE(firstError(read.faults) != nullptr);
  }
}

TEST(ColladaReader, AnAccessorOfAnArrayWithoutNumbersIsAnErrorOfItsOwn) {
  const ReadMesh read =
      readMesh(replaced(kEverything, "stride=\"3\"", "stride=\"18446744073709551615\""), "a.dae");
  EXPECT_THAT(firstError(read.faults)->text,
              HasSubstr("an <accessor> reads 4 times 18446744073709551615 numbers of an array"));
}

}  // namespace
}  // namespace rocinante
