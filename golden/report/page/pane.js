// One canvas of the stage, as sharp as the screen.
class Pane {
  constructor(caption, label) {
    this.canvas = make("canvas", { role: "img", "aria-label": label });
    this.figure = make("figure", {}, this.canvas, make("figcaption", { textContent: caption }));
  }

  get width() { return this.canvas.clientWidth; }
  get height() { return this.canvas.clientHeight; }

  // `layers`: {image, from, until}; from and until are parts of the pane's width, 0 to 1.
  draw(transform, layers, divider = null) {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.width * ratio));
    const height = Math.max(1, Math.round(this.height * ratio));
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    const context = this.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    const { left, top } = transform.corner();
    for (const { image, from = 0, until = 1, is_reduced = false } of layers) {
      if (!image) continue;
      context.save();
      context.beginPath();
      context.rect(from * width, 0, (until - from) * width, height);
      context.clip();
      // Judged pixels stay squares when enlarged by hand or by a whole number.
      const scale = transform.scale * ratio;
      const is_uneven = transform.fitted && !Number.isInteger(scale);
      context.imageSmoothingEnabled = is_reduced || is_uneven || scale < 1;
      context.imageSmoothingQuality = "high";
      context.drawImage(image, Math.round(width / 2 + left * ratio), Math.round(height / 2 + top * ratio),
        Math.round(image.width * transform.scale * ratio), Math.round(image.height * transform.scale * ratio));
      context.restore();
    }
    if (divider !== null) {
      context.fillStyle = "#fff";
      context.fillRect(divider * width - 1.5 * ratio, 0, 3 * ratio, height);
      context.fillStyle = "#000";
      context.fillRect(divider * width - 0.5 * ratio, 0, ratio, height);
    }
  }

  // Coordinates of a pointer from the middle of this pane.
  fromMiddle(event) {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left - box.width / 2, y: event.clientY - box.top - box.height / 2 };
  }
}
