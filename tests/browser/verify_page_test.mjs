// The page of verify.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, exsect, launch, open, report, runTests, settled, writeScratch} from './browser.mjs';

const browser = await launch();
const red = ([r, g, b]) => r > g + 60 && r > b + 60 && r > 150;

async function shown(name) {
  const {path, json, bytes} = report('verify', example(`candidates/${name}.candidate.json`), example(`candidates/${name}.json`), '--tolerance', '1e-4');
  assert.ok(bytes < 3e6, `${bytes} bytes`);
  const page = await open(browser, path, {reducedMotion: 'reduce'});
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

  async 'every difference is flown to, in space and in both squares'() {
    const {page, json} = await shown('sisl-parameter-curve-off');
    const ticks = (square) => page.locator('.views .square').nth(square).locator('.soft').allTextContents();
    const whole = [await ticks(0), await ticks(1)];
    for (let id = 0; id < Math.min(3, json.differences.length); ++id) {
      await page.locator('#differences .pick').nth(id).click();
      await settled(page);
      assert.match(await page.locator('#selection').textContent(), new RegExp(`^Difference ${id + 1}, `));
      // the places of the difference fill a good part of either square, and all of them are in it
      const found = await page.evaluate((id) => [0, 1].map((which) => {
        const places = differencePlaces[id].squares[which];
        return {inside: places.every(squares[which].shows), part: extentOf(places) / squares[which].width()};
      }), id);
      for (const {inside, part} of found) assert.ok(inside && (part > 0.4 || part === 0), JSON.stringify(found));
      const onScreen = await page.evaluate((id) => differencePlaces[id].space.every((p) => view.onScreen(p).every((t, k) => t > 0 && t < view.size[k])), id);
      assert.ok(onScreen, 'in the picture of space');
      await page.locator('#differences .pick').nth(id).click();
      assert.deepEqual([await ticks(0), await ticks(1)], whole);
    }
    assertQuiet(page);
    await page.context().close();
  },

  async 'a difference smaller than a pixel has an inset'() {
    const {page} = await shown('sisl-nearly-crossing-lost');
    const small = await page.evaluate(() => [0, 1].map((which) => differencePlaces.filter((places) => side * extentOf(places.squares[which]) < leastSeen).length));
    const insets = await page.evaluate(() => squares.map(({svg}) => svg.querySelectorAll('.inset').length));
    assert.deepEqual(insets, small.map((number) => Math.min(number, 4)));
    // an isolated point that was not claimed
    const lost = await shown('occt-touch-point-lost');
    assert.ok(await lost.page.locator('.views .square .inset').count() > 0);
    await lost.page.locator('.views .square .inset').first().click();
    assert.match(await lost.page.locator('#selection').textContent(), /^Difference 1, /);
    await lost.page.context().close();
    await page.context().close();
  },

  async 'with one surface by its equation, and with two'() {
    for (const [first, second, squares] of [['saddle', 'torus', 1], ['oblique', 'torus', 0]]) {
      const found = JSON.parse(exsect('intersect', example('surfaces.json'), '--first', first, '--second', second, '--json', '-'));
      const curves = found.arcs.slice(1).map(({polyline}) => ({points: polyline.map((v) => v.slice(2 * squares))}));
      const claims = writeScratch('claims.json', JSON.stringify({exsect: 'candidate/1', patches: [first, second], curves, points: [{point: [9, 9, 9]}]}));
      const {path, json} = report('verify', claims, example('surfaces.json'), '--tolerance', '1e-3');
      const page = await open(browser, path, {reducedMotion: 'reduce'});
      assertQuiet(page);
      assert.equal(json.verdict, 'disagrees');
      assert.equal(await page.locator('.views .square').count(), squares);
      assert.equal(await page.locator('#differences tbody tr').count(), json.differences.length);
      assert.equal(await page.locator('#coverage tbody tr').count(), json.components.length);
      assert.ok((await canvasPixels(page)).filter(red).length > 30, 'the gap is marked in space');
      for (let id = 0; id < json.differences.length; ++id) {
        await page.locator('#differences .pick').nth(id).click();
        await settled(page);
        assert.match(await page.locator('#selection').textContent(), new RegExp(`^Difference ${id + 1}, `));
        await page.locator('#differences .pick').nth(id).click();
      }
      assertQuiet(page);
      await page.context().close();
    }
  },
});

await browser.close();
