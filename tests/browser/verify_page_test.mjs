// The page of verify.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, launch, open, report, runTests} from './browser.mjs';

const browser = await launch();
const red = ([r, g, b]) => r > g + 60 && r > b + 60 && r > 150;

async function shown(name) {
  const {path, json, bytes} = report('verify', example(`candidates/${name}.candidate.json`), example(`candidates/${name}.json`), '--tolerance', '1e-4');
  assert.ok(bytes < 3e6, `${bytes} bytes`);
  const page = await open(browser, path);
  assertQuiet(page);
  return {page, json};
}

await runTests({
  async 'a candidate that is right'() {
    const {page, json} = await shown('sisl-right');
    assert.equal(json.verdict, 'agrees');
    assert.match(await page.locator('#answer').textContent(), /^Agrees, proved\./);
    assert.equal(await page.locator('#differences').count(), 0);
    assert.equal(await page.locator('#claimed-curves tbody tr').count(), json.curves.length);
    assert.equal(await page.locator('.square .claimed').count(), 2 * json.curves.length);
    await page.context().close();
  },

  async 'a candidate that is wrong'() {
    const {page, json} = await shown('sisl-lost-curve');
    assert.match(await page.locator('#answer').textContent(), /^Disagrees, proved\./);
    assert.deepEqual(await page.locator('#differences tbody tr').evaluateAll((rows) => rows.map((row) => [row.dataset.kind, row.querySelector('.statement').textContent])),
      json.differences.map(({kind, text}) => [kind, text]));
    assert.ok(await page.locator('.square .gap').count() >= 2);
    assert.ok((await canvasPixels(page)).filter(red).length > 100, 'the lost curve is marked in space');
    await page.context().close();
  },
});

await browser.close();
