// The pages of implicitize, revolve and compare.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, launch, open, report, runTests, settled} from './browser.mjs';

const browser = await launch();

async function shown(...options) {
  const {path, json, bytes} = report(...options);
  assert.ok(bytes < 1.5e6, `${bytes} bytes`);
  const page = await open(browser, path);
  assertQuiet(page);
  assert.match(await page.locator('#answer').textContent(), json.status !== 'complete' ? /^Incomplete/ : json.exact === false ? /^Approximate; distance proved|^Approximate; bounds proved/ : /^Complete/);
  return {page, json};
}

/** Statements and equations are those of the JSON result. */
async function assertStatements(page, json) {
  assert.deepEqual(await page.locator('#statements tbody tr').evaluateAll((rows) => rows.map((row) => [row.dataset.statement, row.querySelector('.statement').textContent])),
    json.proved.map(({name, statement}) => [name, statement]));
  assert.deepEqual(await page.locator('#statements .exact').allTextContents(), json.proved.filter(({value}) => value !== undefined && value !== null).map(({value}) => `= ${value}`));
  assert.equal(await page.locator('.polynomial').count(), json.equations.length);
  for (const {name, text} of json.equations.filter(({text}) => text.length < 20000)) {
    await page.locator('.polynomial', {hasText: `${name}, degree`}).getByRole('button', {name: 'PARI/GP'}).click();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied.replace(/\s/g, ''), `${name}=${text};`.replace(/\s/g, ''));
  }
}

const orange = ([r, g, b]) => r > b + 60 && g > b + 30 && r > 170;
const blue = ([r, g, b]) => b > r + 40 && b > 140;

await runTests({
  async 'a fitted planar curve'() {
    const {page, json} = await shown('implicitize', example('profile.json'), '--degree', '3', '--variables', 'r,z');
    await assertStatements(page, json);
    assert.equal(await page.locator('.space').count(), 0);
    assert.ok(await page.locator('.picture svg path').count() > 5);
    await page.context().close();
  },

  async 'two surfaces through a curve of space'() {
    const {page, json} = await shown('implicitize', example('space-cubic.json'), '--degree', '3');
    await assertStatements(page, json);
    const pixels = await canvasPixels(page);
    assert.ok(pixels.filter(orange).length > 200 && pixels.filter(blue).length > 200);
    assert.ok(await page.locator('.picture svg').count() === 1);
    await page.context().close();
  },

  async 'a quartic near a patch'() {
    const {page, json} = await shown('implicitize', example('chapter9-first.json'), '--patch', 'x', '--degree', '4');
    await assertStatements(page, json);
    const pixels = await canvasPixels(page);
    assert.ok(pixels.filter(orange).length > 200, 'zero set');
    assert.equal(await page.locator('.picture').count(), 0);
    await page.context().close();
  },

  async 'a surface of revolution with rings, phantoms and a patch'() {
    const {page, json} = await shown('revolve', example('profile.json'), '--method', 'product', '--degree', '3', '--region', '2,0,2');
    await assertStatements(page, json);
    assert.equal(await page.locator('#rings tbody tr').count(), json.rings.length);
    assert.equal(await page.locator('#branches tbody tr').count(), json.branches.counts.length);
    const before = await canvasPixels(page);
    assert.ok(before.filter(orange).length > 200);
    await page.locator('#phantoms').click();
    await settled(page);
    const after = await canvasPixels(page);
    assert.ok(after.filter((pixel, i) => pixel.some((c, k) => Math.abs(c - before[i][k]) > 8)).length > 50);
    await page.context().close();
    const on = await shown('revolve', example('profile.json'), '--method', 'elimination', '--patch-file', example('chapter9-first.json'), '--patch', 'x', '--u', '1/2');
    // the patch inside, and the curve on it, are seen through the surface
    assert.ok((await canvasPixels(on.page)).filter(([r, g, b]) => g > r + 4 && b > 80).length > 10);
    assert.match(await on.page.locator('.legend').textContent(), /the surface on the patch/);
    await on.page.context().close();
  },

  async 'three methods side by side'() {
    const {page, json} = await shown('compare', example('chapter9-first.json'), '--lines', '16');
    const rows = await page.locator('#methods tbody tr').evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map((row) => row.slice(0, 4)), json.methods.map(({method, detail, answer, found}) => [method, detail, answer, String(found.number)]));
    assert.deepEqual(rows.map((row) => row.slice(8, 11).map(Number)), json.methods.map(({points}) => [points.exact, points.certified, points.missed]));
    assert.equal(await page.locator('#nodes tbody tr').count(), 12);
    await page.locator('#nodes tr[data-node="4"]').click();
    assert.equal(await page.locator('.views .square .node.selected').count(), 2);
    assert.equal(await page.locator('.picture svg').count(), 1);
    await page.context().close();
  },
});

await browser.close();
