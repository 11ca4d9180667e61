// The pictures of the page, each once as base64 in an inert script element, decoded on first use.
// The last few stay decoded.
class PictureStore {
  static kept = 12;

  constructor() {
    this.decoded = new Map();
  }

  address(id) {
    return "data:image/png;base64," + find("picture-" + id).textContent;
  }

  // {width, height, image: a canvas, pixels: RGBA}; null without a picture.
  async get(id) {
    if (id === undefined || id === null) return null;
    let promise = this.decoded.get(id);
    this.decoded.delete(id);
    promise ??= this.decode(id);
    this.decoded.set(id, promise);
    if (this.decoded.size > PictureStore.kept) {
      this.decoded.delete(this.decoded.keys().next().value);
    }
    return promise;
  }

  async decode(id) {
    const element = new Image();
    element.src = this.address(id);
    await element.decode();
    const image = make("canvas", { width: element.naturalWidth, height: element.naturalHeight });
    const context = image.getContext("2d", { willReadFrequently: true });
    context.drawImage(element, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    return { width: image.width, height: image.height, image, pixels };
  }
}
