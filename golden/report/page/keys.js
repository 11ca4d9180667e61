// Keyboard bindings. Ignores keys with a modifier and keys typed into a field.
class Keys {
  constructor(bindings) {
    this.byKey = new Map();
    for (const { keys, what, act } of bindings) {
      for (const key of keys) this.byKey.set(key, act);
      const names = keys.map((key) => make("kbd", { textContent: Keys.nameOf(key) }));
      find("keys").tBodies[0].append(make("tr", {},
        make("td", {}, ...names.flatMap((name) => [name, " "])), make("td", { textContent: what })));
    }
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
      const field = event.target;
      if (event.key === "Escape" && field === find("filter-text")) return field.blur();
      const types = field.matches("textarea, select, input:not([type=checkbox]):not([type=radio])");
      const arrows = event.key.startsWith("Arrow");
      if (types || (arrows && !find("stage").contains(field))) return;
      const act = this.byKey.get(event.key);
      if (!act) return;
      event.preventDefault();
      act();
    });
  }

  static nameOf(key) {
    return { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓" }[key] ?? key;
  }
}
