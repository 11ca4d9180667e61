#include <fmt/format.h>
#include <sodium/utils.h>

#include <kainjow/mustache.hpp>

#include "core/duration_text.h"
#include "golden/report.h"

namespace rocinante {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::list;
using kainjow::mustache::mustache;
using kainjow::mustache::object;

// Values are escaped by {{ }}; the page needs nothing from outside.
constexpr char kPage[] = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{verdict}}: {{suite}}</title>
<style>
:root { color-scheme: light dark; --ink: #1d232b; --soft: #5b6673; --paper: #f6f7f9; --card: #ffffff;
  --line: #d8dde3; --same: #1a7f4b; --bad: #b3261e; --unsure: #8a5a00; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ed; --soft: #9aa5b1; --paper: #14181d;
  --card: #1d232a; --line: #343c46; --same: #57c28a; --bad: #ff8a80; --unsure: #f0b95a; } }
body { margin: 0; font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: var(--ink);
  background: var(--paper); }
main { max-width: 1280px; margin: 0 auto; padding: 24px; }
h1 { font-size: 22px; margin: 0 0 4px; } h2 { font-size: 17px; margin: 0; }
.soft { color: var(--soft); } code, .figures { font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.verdict { font-weight: 600; } .same { color: var(--same); }
.different, .missing, .unstable { color: var(--bad); } .incomparable { color: var(--unsure); }
.counts { display: flex; flex-wrap: wrap; gap: 10px 22px; margin: 14px 0; padding: 0; list-style: none; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 16px; margin: 14px 0; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 16px;
  margin: 16px 0; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(280px, 1fr)); gap: 12px;
  margin-top: 12px; }
figure { margin: 0; } figcaption { color: var(--soft); font-size: 13px; }
img { max-width: 100%; height: auto; border: 1px solid var(--line); display: block; }
pre { overflow-x: auto; margin: 12px 0 0; } .filters label { margin-right: 14px; }
.command { user-select: all; }
</style>
</head>
<body>
<main>
<h1>Golden frames: <span class="verdict {{verdict}}">{{verdict}}</span></h1>
<p class="soft">{{suite}} &middot; {{made_at}}</p>
<ul class="counts">{{#counts}}<li><span class="verdict {{name}}">{{count}}</span> {{name}}</li>{{/counts}}</ul>
<dl>
<dt>cell</dt><dd>{{cell}}</dd>
{{#has_log}}<dt>log</dt><dd>{{log}}</dd><dt>session</dt><dd><code>{{session}}</code></dd>{{/has_log}}
<dt>renderer</dt><dd><code>{{renderer}}</code></dd>
<dt>run again</dt><dd><code class="command">{{run_command}}</code></dd>
<dt>approve</dt><dd><code class="command">{{approve_command}}</code></dd>
</dl>
<p class="filters"><label><input type="checkbox" id="hide-same"> only what is not the same</label></p>
{{#frames}}
<article class="frame" data-verdict="{{verdict}}" id="{{name}}">
<h2>{{name}} <span class="verdict {{verdict}}">{{verdict}}</span></h2>
<div>{{rule}}</div>
<div class="figures soft">{{figures}}</div>
<div class="soft">{{facts}}</div>
{{#map}}<pre aria-label="where the pictures differ">{{lines}}</pre>{{/map}}
<div class="pictures">
{{#pictures}}<figure><img alt="{{caption}} of {{name}}" src="data:image/png;base64,{{{png}}}"><figcaption>{{caption}}</figcaption></figure>{{/pictures}}
</div>
</article>
{{/frames}}
</main>
<script>
const box = document.getElementById("hide-same");
box.addEventListener("change", () => {
  for (const frame of document.querySelectorAll("article.frame")) {
    frame.hidden = box.checked && frame.dataset.verdict === "same";
  }
});
</script>
</body>
</html>
)html";

std::string base64(ByteView bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.resize(std::char_traits<char>::length(text.c_str()));
  return text;
}

data pictureData(const char* caption, const std::string& name, const Picture& picture) {
  return object{
      {"caption", std::string(caption)}, {"name", name}, {"png", base64(encodePng(picture))}};
}

std::string factsOf(const JudgedFrame& judged) {
  std::string facts;
  if (judged.golden) {
    const AcceptedPicture& golden = *judged.golden;
    facts = fmt::format("golden {} accepted by {} on {}: {}", golden.picture, golden.accepted_by,
                        golden.accepted_at, golden.reason);
    if (judged.verdict != FrameVerdict::same) {
      facts += golden.inputs == judged.inputs
                   ? "; textures, glyphs and geometry are the same as then"
                   : "; the inputs differ: textures, glyphs or geometry have changed since";
      if (golden.session != judged.session) facts += "; it is another recording";
    }
  }
  return facts;
}

data frameData(const JudgedFrame& judged) {
  const Comparison& found = judged.comparison;
  list pictures;
  std::string map;
  if (judged.drawn && judged.verdict != FrameVerdict::same) {
    if (judged.accepted) {
      pictures.push_back(pictureData("golden", judged.frame.name, *judged.accepted));
    }
    pictures.push_back(pictureData("frame", judged.frame.name, *judged.drawn));
    if (judged.accepted && judged.accepted->width == judged.drawn->width &&
        judged.accepted->height == judged.drawn->height) {
      pictures.push_back(pictureData("difference", judged.frame.name,
                                     differencePicture(*judged.drawn, *judged.accepted)));
      for (const std::string& line : differenceMap(*judged.drawn, *judged.accepted)) {
        map += "|" + line + "|\n";
      }
    }
  } else if (judged.drawn) {
    pictures.push_back(pictureData("frame", judged.frame.name, *judged.drawn));
  } else if (judged.thumbnail) {
    pictures.push_back(pictureData("frame, reduced", judged.frame.name, *judged.thumbnail));
  }
  std::string figures;
  if (found.differing > 0) {
    figures = fmt::format(
        "{} pixels differ; over 1/2/8/32: {}/{}/{}/{}; largest {} at ({}, {}); worst tile's mean "
        "{:.2f}",
        found.differing, found.over_1, found.over_2, found.over_8, found.over_32, found.max,
        found.worst_x, found.worst_y, found.worst_tile_mean);
  }
  object made{{"name", judged.frame.name}, {"verdict", std::string(nameOf(judged.verdict))},
              {"rule", judged.rule},       {"figures", figures},
              {"facts", factsOf(judged)},  {"pictures", pictures}};
  if (!map.empty()) made["map"] = object{{"lines", map}};
  return made;
}

}  // namespace

std::string reportHtml(const SuiteReport& report) {
  list counts;
  for (const FrameVerdict verdict :
       {FrameVerdict::same, FrameVerdict::different, FrameVerdict::missing, FrameVerdict::unstable,
        FrameVerdict::incomparable}) {
    counts.push_back(object{{"name", std::string(nameOf(verdict))},
                            {"count", std::to_string(report.count(verdict))}});
  }
  list frames;
  for (const JudgedFrame& judged : report.frames) frames.push_back(frameData(judged));
  object page{{"verdict", std::string(nameOf(report.verdict()))},
              {"suite", report.suite},
              {"cell", report.cell},
              {"log", report.log},
              {"session", report.session},
              {"renderer", report.renderer},
              {"made_at", report.made_at},
              {"run_command", report.run_command},
              {"approve_command", report.approve_command},
              {"counts", counts},
              {"frames", frames}};
  page["has_log"] = report.log.empty() ? data(data::type::bool_false) : data(data::type::bool_true);
  mustache page_template{std::string(kPage)};
  return page_template.render(data(page));
}

}  // namespace rocinante
