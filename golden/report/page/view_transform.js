// The transform of all panes, so that they zoom and pan together. `scale` is screen pixels per
// picture pixel; (x, y) is the picture's point in the centre of a pane.
class ViewTransform {
  constructor() {
    this.fitted = true;
    this.scale = 1;
    this.x = this.y = 0;
  }

  fit(width, height, pane_width, pane_height) {
    this.fitted = true;
    this.scale = Math.min(pane_width / width, pane_height / height);
    this.x = width / 2;
    this.y = height / 2;
  }

  // The point of the picture below (at_x, at_y), measured from a pane's middle, stays where it is.
  zoom(factor, at_x = 0, at_y = 0) {
    const before = this.scale;
    this.scale = Math.min(64, Math.max(1 / 16, before * factor));
    this.x += at_x / before - at_x / this.scale;
    this.y += at_y / before - at_y / this.scale;
    this.fitted = false;
  }

  pan(right, down, width, height) {
    this.x = Math.min(width, Math.max(0, this.x + right / this.scale));
    this.y = Math.min(height, Math.max(0, this.y + down / this.scale));
    this.fitted = false;
  }

  // Screen coordinates, from a pane's middle, of the picture's top left corner.
  corner() {
    return { left: -this.x * this.scale, top: -this.y * this.scale };
  }

  pictureAt(at_x, at_y) {
    return { x: Math.floor(this.x + at_x / this.scale), y: Math.floor(this.y + at_y / this.scale) };
  }
}
