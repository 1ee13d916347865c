// The page of `exsect intersect --report` for a patch and a surface given by its equation.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, launch, open, report, runTests} from './browser.mjs';

const browser = await launch();

await runTests({
  async 'patch and surface in space, one square, exact intervals'() {
    const {path, json} = report('intersect', example('surfaces.json'), '--first', 'saddle', '--second', 'torus');
    const page = await open(browser, path);
    assertQuiet(page);
    assert.match(await page.locator('#answer').textContent(), /^Complete, proved.*Patch saddle and the torus torus intersect in/s);
    assert.deepEqual(await page.locator('.views .axis').allTextContents(), ['u', 'v']);
    assert.equal(await page.locator('#nodes tbody tr').count(), json.nodes.length);
    assert.equal(await page.locator('.space .node').count(), json.nodes.length);
    assert.equal(await page.locator('.views .square .node').count(), json.nodes.length);
    const pixels = await canvasPixels(page);
    const blue = () => pixels.filter(([r, g, b]) => b > r + 40 && b > 150 && r > 90).length;
    const yellow = (all) => all.filter(([r, g, b]) => r > b + 60 && g > b + 30 && r > 190).length;
    assert.ok(blue() > 300, 'patch');
    assert.ok(yellow(pixels) > 300, 'torus');
    await page.locator('#patch-1').uncheck();
    assert.ok(yellow(await canvasPixels(page)) < yellow(pixels) / 4, 'the torus is hidden');
    assert.match(await page.locator('.polynomial .text').first().textContent(), /x4.* = 0$/);
    await page.locator('#nodes tbody tr').first().click();
    assert.equal(await page.locator('.views .square .node.selected').count(), 1);
    assert.equal(await page.locator('.space .node.selected').count(), 1);
    // The line u = 13/40 of the saddle: as many points as its arcs pass it.
    await page.locator('#slider').fill('13');
    const passes = json.arcs.flatMap((arc) => arc.polyline.slice(1).filter((to, k) => (arc.polyline[k][0] - 0.325) * (to[0] - 0.325) < 0)).length;
    assert.equal(await page.locator('.space circle.fibre-point').count(), passes);
    assertQuiet(page);
    await page.context().close();
  },

  async 'every kind of surface'() {
    for (const name of ['floor', 'cone', 'quartic']) {
      const {path, json} = report('intersect', example('surfaces.json'), '--first', name, '--second', 'saddle');
      const page = await open(browser, path);
      assertQuiet(page);
      assert.equal(await page.locator('#arcs tbody tr').count(), json.arcs.length, name);
      const shown = await canvasPixels(page);
      await page.locator('#patch-1').uncheck();
      const hidden = await canvasPixels(page);
      assert.ok(shown.filter(([r, g, b], i) => Math.abs(r - hidden[i][0]) + Math.abs(g - hidden[i][1]) + Math.abs(b - hidden[i][2]) > 30).length > 300, name);
      await page.context().close();
    }
  },
});

await browser.close();
