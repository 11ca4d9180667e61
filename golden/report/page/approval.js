// Cases chosen for approval, as the text that `rocinante golden approve --from` reads: a case, a tab,
// the hash of the shown pixels.
class Approval {
  constructor(frames, runs, command, changed) {
    this.items = [...frames, ...runs];
    this.has_runs = runs.some((run) => run.can_approve);
    this.command = command;
    this.changed = changed;
    this.picked = new Set();
    find("approval-copy").addEventListener("click", (event) => copyText(this.text(), event.currentTarget));
    find("approval-none").addEventListener("click", () => this.set([...this.picked], false));
    find("approval-text").addEventListener("focus", (event) => event.currentTarget.select());
    find("approval").hidden = !command || !this.items.some((item) => item.can_approve);
    this.tell();
  }

  set(indexes, on) {
    for (const index of indexes) {
      if (!this.items[index].can_approve) continue;
      if (on) this.picked.add(index);
      else this.picked.delete(index);
      this.changed(index, on);
    }
    this.tell();
  }

  text() {
    return [...this.picked].sort((a, b) => a - b)
      .map((index) => this.items[index].name + "\t" + (this.items[index].pixels ?? this.items[index].log_bytes) + "\n").join("");
  }

  tell() {
    const count = this.picked.size;
    find("approval-count").textContent = count + (this.has_runs ? "" : count === 1 ? " frame" : " frames") + " to approve";
    find("approval-copy").disabled = find("approval-none").disabled = count === 0;
    find("approval-text").value = this.text();
    find("approval-command").textContent = find("approval-command").title = this.command ?? "";
  }
}
