// Cases chosen for approval, as the text that `rocinante golden approve --from` reads: a case, a tab,
// the hash of the shown pixels.
class Approval {
  constructor(frames, command, changed) {
    this.frames = frames;
    this.command = command;
    this.changed = changed;
    this.picked = new Set();
    find("approval-copy").addEventListener("click", (event) => copyText(this.text(), event.currentTarget));
    find("approval-none").addEventListener("click", () => this.set([...this.picked], false));
    find("approval-text").addEventListener("focus", (event) => event.currentTarget.select());
    find("approval").hidden = !command || !frames.some((frame) => frame.can_approve);
    this.tell();
  }

  set(indexes, on) {
    for (const index of indexes) {
      if (!this.frames[index].can_approve) continue;
      if (on) this.picked.add(index);
      else this.picked.delete(index);
      this.changed(index, on);
    }
    this.tell();
  }

  text() {
    return [...this.picked].sort((a, b) => a - b)
      .map((index) => this.frames[index].name + "\t" + this.frames[index].pixels + "\n").join("");
  }

  tell() {
    const count = this.picked.size;
    find("approval-count").textContent = count === 1 ? "1 frame to approve" : count + " frames to approve";
    find("approval-copy").disabled = find("approval-none").disabled = count === 0;
    find("approval-text").value = this.text();
    find("approval-command").textContent = this.command ?? "";
  }
}
