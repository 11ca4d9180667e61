// The frames by cause, then those that are fine, in the suite's order. Small pictures are decoded when they come into view.
class CaseList {
  constructor(frames, store, chosen) {
    this.frames = frames;
    const seen = new IntersectionObserver((entries) => {
      for (const entry of entries.filter((each) => each.isIntersecting)) {
        entry.target.src = store.address(entry.target.dataset.picture);
        seen.unobserve(entry.target);
      }
    }, { root: find("cases"), rootMargin: "200px" });
    this.items = frames.map((frame, index) => {
      const image = make("img", { alt: "", width: 80, height: 60 });
      const id = frame.pictures.thumbnail ?? frame.pictures.frame ?? frame.pictures.golden;
      if (id !== undefined) {
        image.dataset.picture = id;
        seen.observe(image);
      }
      const button = make("button", { type: "button" }, image, make("span", {},
        make("span", { className: "name", textContent: frame.name }), make("br"),
        make("span", { className: "state verdict " + frame.verdict, textContent: frame.verdict })));
      button.addEventListener("click", () => chosen(index));
      return make("li", {}, button);
    });
    this.heads = new Map();
    this.items.forEach((item, index) => {
      const cause = frames[index].cause;
      if (cause && !this.heads.has(cause)) {
        this.heads.set(cause, make("li", { className: "cause", textContent: cause }));
        find("cases").append(this.heads.get(cause));
      }
      find("cases").append(item);
    });
  }

  filter(passes) {
    this.visible = this.frames.map((_, index) => index).filter((index) => passes(this.frames[index]));
    const visible = new Set(this.visible);
    this.items.forEach((item, index) => { item.hidden = !visible.has(index); });
    const causes = new Set(this.visible.map((index) => this.frames[index].cause));
    for (const [cause, head] of this.heads) head.hidden = !causes.has(cause);
    find("shown").textContent = `${this.visible.length} of ${this.frames.length} ${this.frames.length === 1 ? "frame" : "frames"} shown`;
  }

  mark(index) {
    this.items.forEach((item, each) => {
      item.firstChild.setAttribute("aria-current", String(each === index));
    });
    this.items[index]?.scrollIntoView({ block: "nearest" });
  }

  markPicked(index, picked) {
    this.items[index].querySelector(".state").classList.toggle("picked", picked);
  }

  // The first visible one of the next cause; by -1, of this cause, or of the previous one from there.
  stepCause(index, by) {
    const firsts = this.visible.filter((each, place) =>
      place === 0 || this.frames[each].cause !== this.frames[this.visible[place - 1]].cause);
    return (by > 0 ? firsts.find((each) => each > index) : firsts.findLast((each) => each < index)) ?? index;
  }

  // The visible one after or before `index`, or `index` itself.
  step(index, by) {
    const visible = by > 0 ? this.visible.filter((each) => each > index) : this.visible.filter((each) => each < index).reverse();
    return visible[0] ?? index;
  }
}
