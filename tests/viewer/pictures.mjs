// Screenshots as numbers, decoded by the browser itself. An area is a range of columns in shares of the width.

/// Runs inside a blank page: decodes PNGs and compares their pixels.
function installReader() {
  window.read = async (base64, [from, to]) => {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const x = Math.floor(from * picture.width);
    return { x, ...{ image: context.getImageData(x, 0, Math.floor(to * picture.width) - x, picture.height) } };
  };
  window.far = (data, i, reference) => [0, 1, 2].some((k) => Math.abs(data[i + k] - reference(k)) > 24);
  window.share = (image, reference) => {
    let count = 0;
    for (let i = 0; i < image.data.length; i += 4) count += window.far(image.data, i, (k) => reference(i + k));
    return count / (image.data.length / 4);
  };
}

export async function openPictureReader(browser) {
  const page = await browser.newPage();
  page.setDefaultTimeout(120000);
  await page.evaluate(installReader);
  const whole = [0, 1];
  return {
    /// A screenshot as base64, taken when the page has drawn what it was asked for.
    async drawn(locator) {
      await locator.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      return (await locator.screenshot()).toString('base64');
    },
    /// Share of the pixels that are not white.
    ink: (picture, area = whole) => page.evaluate(async ([p, a]) => window.share((await window.read(p, a)).image, () => 255), [picture, area]),
    /// Share of the pixels that differ.
    difference: (one, other, area = whole) =>
      page.evaluate(async ([p, q, a]) => {
        const second = (await window.read(q, a)).image.data;
        return window.share((await window.read(p, a)).image, (i) => second[i]);
      }, [one, other, area]),
    /// A place in the magenta of balls and lines of middling confidence, its neighbours too; surfaces have more green.
    find: (picture, area) =>
      page.evaluate(async ([p, a]) => {
        const { x, image } = await window.read(p, a);
        const { data, width } = image;
        const magenta = (i) => Math.min(data[i], data[i + 2]) - data[i + 1] > 35;
        for (let i = 4 * width; i < data.length - 4 * width; i += 4) {
          if (magenta(i) && magenta(i - 4) && magenta(i + 4)) return { x: x + ((i / 4) % width), y: Math.floor(i / 4 / width) };
        }
        return null;
      }, [picture, area]),
  };
}
