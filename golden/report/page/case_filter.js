// Which cases are shown: by verdict, tag, and words that their name, rule or links contain.
class CaseFilter {
  constructor(frames, changed) {
    this.verdicts = [...new Set(frames.map((frame) => frame.verdict))];
    this.boxes = this.verdicts.map((verdict) => {
      const box = make("input", { type: "checkbox", checked: true, value: verdict, name: "verdict" });
      find("filter-verdicts").append(make("label", {}, box, " ", make("span", { className: "verdict " + verdict, textContent: verdict })));
      return box;
    });
    const tags = [...new Set(frames.flatMap((frame) => frame.tags))].sort();
    find("filter-tag").append(...tags.map((tag) => make("option", { value: tag, textContent: tag })));
    find("filter-tag-label").hidden = tags.length === 0;
    for (const frame of frames) {
      frame.words = [frame.name, frame.rule, ...(frame.why?.rows.map((row) => row.name + " " + row.what) ?? [])]
        .join("\n").toLowerCase();
    }
    find("filters").addEventListener("input", changed);
    find("filters").addEventListener("submit", (event) => event.preventDefault());
  }

  // Failures are shown first; without any, everything is shown.
  showOnly(verdicts) {
    for (const box of this.boxes) box.checked = verdicts.length === 0 || verdicts.includes(box.value);
  }

  passes(frame) {
    const words = find("filter-text").value.toLowerCase().split(/\s+/).filter(Boolean);
    const tag = find("filter-tag").value;
    return this.boxes.some((box) => box.checked && box.value === frame.verdict) &&
      (tag === "" || frame.tags.includes(tag)) && words.every((word) => frame.words.includes(word));
  }
}
