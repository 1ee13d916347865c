// The page of `exsect self --report`, and pages of overlaps, tangential arcs and incomplete results.
import assert from 'node:assert/strict';
import {join} from 'node:path';

import {assertQuiet, canvasPixels, example, launch, open, report, runTests} from './browser.mjs';

const browser = await launch();
const cases = process.env.EXSECT_CASES;

await runTests({
  async 'where a patch meets itself'() {
    const {path, json} = report('self', example('chapter9-second.json'), '--patch', 'y');
    const page = await open(browser, path);
    assertQuiet(page);
    assert.match(await page.locator('#answer').textContent(), /Patch y meets itself in 3 components \(3 open\)\./);
    assert.equal(await page.locator('#nodes tbody tr').count(), json.nodes.length);
    assert.deepEqual(await page.locator('.views .axis').allTextContents(), ['u1', 'v1', 'u2', 'v2']);
    const cusp = json.nodes.find((node) => node.kinds.includes('cusp'));
    await page.locator(`#nodes tr[data-node="${cusp.id}"]`).click();
    assert.equal(await page.locator('.views .square .node.selected').count(), 2);
    assert.equal(await page.locator('.space .node.selected').count(), 1);
    const pixels = await canvasPixels(page);
    assert.ok(pixels.filter(([r, g, b]) => b > r + 40 && b > 150 && r > 90).length > 300);
    // over u1 = 33/40 there is one pair of component 1 by the first parameter
    await page.locator('#slider').fill('33');
    assert.equal(await page.locator('#value').textContent(), 'u1 = 0.825');
    const crossings = json.arcs.flatMap((arc) => [0, 2].flatMap((i) => arc.polyline.slice(1).filter((to, k) => (arc.polyline[k][i] - 0.825) * (to[i] - 0.825) < 0))).length;
    assert.equal(await page.locator('.space circle.fibre-point').count(), crossings);
    assertQuiet(page);
    await page.context().close();
  },

  async 'an overlap is hatched, with its rim in space'() {
    const {path, json} = report('intersect', join(cases, 'overlap.json'));
    const page = await open(browser, path);
    assertQuiet(page);
    assert.equal(json.overlaps.length, 1);
    assert.equal(await page.locator('.views .square .overlap').count(), 2);
    assert.match(await page.locator('#answer').textContent(), /1 overlap/);
    await page.context().close();
  },

  async 'crossings, tangential arcs, arcs on sides, incomplete results'() {
    for (const file of [example('touching-curve.json'), ...['crossing', 'double-cover', 'shared-side', 'side-and-arc'].map((name) => join(cases, `${name}.json`))]) {
      const {path, json} = report('intersect', file);
      const page = await open(browser, path);
      assertQuiet(page);
      assert.equal(await page.locator('#nodes tbody tr').count(), json.nodes.length);
      assert.match(await page.locator('#answer').textContent(), json.status === 'complete' ? /^Complete, proved/ : /^Incomplete/);
      assert.equal(await page.locator('.proofs .incomplete').count(), json.incomplete.length);
      await page.context().close();
    }
  },
});

await browser.close();
