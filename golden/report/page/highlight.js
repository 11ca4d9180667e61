// The mask of a case is a picture whose bytes are rows of the attribution table (0: none): red, the
// row of a differing pixel; green, the surface that the frame shows there; blue, the one that the
// golden showed.
function highlightImage(mask, row) {
  const { width, height, pixels } = mask;
  const isOf = (component, x, y) =>
    x >= 0 && y >= 0 && x < width && y < height && pixels[(y * width + x) * 4 + component] === row;
  const isEdge = (component, x, y) => isOf(component, x, y) &&
    !(isOf(component, x - 1, y) && isOf(component, x + 1, y) && isOf(component, x, y - 1) && isOf(component, x, y + 1));
  return canvasOf(width, height, (out) => {
    const put = (p, r, g, b, a) => { out[p] = r; out[p + 1] = g; out[p + 2] = b; out[p + 3] = a; };
    for (let y = 0, p = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, p += 4) {
        if (isEdge(1, x, y)) put(p, 0, 229, 255, 255);       // where it is: cyan
        else if (isEdge(2, x, y)) put(p, 255, 64, 255, 255); // where it was: magenta
        else if (pixels[p] === row) put(p, 255, 221, 0, 150);
      }
    }
  });
}
