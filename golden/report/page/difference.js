// Difference of two pictures of one size: the largest of |a - b| over R, G, B and A of each pixel,
// as in the judge (docs/golden-suites.md, "Tolerances").
function pixelDifferences(a, b) {
  const differences = new Uint8Array(a.width * a.height);
  for (let i = 0, p = 0; i < differences.length; ++i, p += 4) {
    differences[i] = Math.max(Math.abs(a.pixels[p] - b.pixels[p]),
      Math.abs(a.pixels[p + 1] - b.pixels[p + 1]), Math.abs(a.pixels[p + 2] - b.pixels[p + 2]),
      Math.abs(a.pixels[p + 3] - b.pixels[p + 3]));
  }
  return differences;
}

function canvasOf(width, height, paint) {
  const canvas = make("canvas", { width, height });
  const context = canvas.getContext("2d");
  const data = context.createImageData(width, height);
  paint(data.data);
  context.putImageData(data, 0, 0);
  return canvas;
}

// The frame in dimmed grey, differing pixels from yellow (slight) to red.
function differenceImage(frame, differences) {
  return canvasOf(frame.width, frame.height, (out) => {
    for (let i = 0, p = 0; i < differences.length; ++i, p += 4) {
      const difference = differences[i];
      if (difference === 0) {
        const grey = 0.21 * frame.pixels[p] + 0.72 * frame.pixels[p + 1] + 0.07 * frame.pixels[p + 2];
        out[p] = out[p + 1] = out[p + 2] = 96 + grey / 4;
      } else {
        out[p] = 255;
        out[p + 1] = Math.max(0, 220 - difference * 4);
      }
      out[p + 3] = 255;
    }
  });
}

// Means of 16x16 pixels around each pixel, by sums over columns and rows.
function tileMeans(differences, width, height) {
  const sums = new Float64Array((width + 1) * (height + 1));
  for (let y = 0; y < height; ++y) {
    let row = 0;
    for (let x = 0; x < width; ++x) {
      row += differences[y * width + x];
      sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
    }
  }
  const means = new Float32Array(width * height);
  for (let y = 0; y < height; ++y) {
    const top = Math.max(0, Math.min(y - 8, height - 16)), bottom = Math.min(height, top + 16);
    for (let x = 0; x < width; ++x) {
      const left = Math.max(0, Math.min(x - 8, width - 16)), right = Math.min(width, left + 16);
      means[y * width + x] = (sums[bottom * (width + 1) + right] - sums[top * (width + 1) + right] -
        sums[bottom * (width + 1) + left] + sums[top * (width + 1) + left]) /
        ((bottom - top) * (right - left));
    }
  }
  return means;
}

// From black over violet and orange to pale yellow, with increasing lightness.
const heatStops = [[0, 0, 4], [87, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];
function heatColor(part) {
  const place = Math.min(0.9999, Math.max(0, part)) * (heatStops.length - 1);
  const [from, to] = [heatStops[Math.floor(place)], heatStops[Math.floor(place) + 1]];
  return from.map((value, i) => value + (to[i] - value) * (place % 1));
}

// Mean difference of each neighbourhood, the measure of a tolerance's tile_mean.
function heatImage(frame, differences) {
  const means = tileMeans(differences, frame.width, frame.height);
  let hottest = 0;
  for (const mean of means) hottest = Math.max(hottest, mean);
  const colors = Array.from({ length: 256 }, (_, i) => heatColor(i / 255));
  const image = canvasOf(frame.width, frame.height, (out) => {
    for (let i = 0, p = 0; i < means.length; ++i, p += 4) {
      const color = colors[hottest > 0 ? Math.round(255 * Math.sqrt(means[i] / hottest)) : 0];
      out[p] = color[0];
      out[p + 1] = color[1];
      out[p + 2] = color[2];
      out[p + 3] = 255;
    }
  });
  return { image, hottest };
}
