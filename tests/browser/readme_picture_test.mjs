// docs/images/bump.png is what the page of examples/bump.json shows.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';

import {example, launch, runTests} from './browser.mjs';
import {picture} from './picture.mjs';

const browser = await launch();

/** The share of pixels in which two PNG files differ by more than a shade; 1 for pictures of different sizes. */
async function difference(first, second) {
  const page = await browser.newPage();
  return page.evaluate(async (sources) => {
    const [a, b] = await Promise.all(sources.map(async (source) => {
      const image = new Image();
      image.src = 'data:image/png;base64,' + source;
      await image.decode();
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return 1;
    let count = 0;
    for (let i = 0; i < a.data.length; i += 4) count += [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 24);
    return count / (a.data.length / 4);
  }, [first, second].map((bytes) => bytes.toString('base64')));
}

await runTests({
  async 'the picture is up to date, but for fonts and smoothing'() {
    const kept = readFileSync(example('../docs/images/bump.png'));
    assert.ok(kept.length < 150000);
    const share = await difference(kept, await picture(browser));
    assert.ok(share < 0.04, `${(100 * share).toFixed(1)} % differ: node tests/browser/picture.mjs docs/images/bump.png makes it again`);
  },

  async 'another picture is told from it'() {
    assert.ok(await difference(readFileSync(example('../docs/images/bump.png')), await picture(browser, 'chapter9-first.json')) > 0.1);
  },
});
await browser.close();
