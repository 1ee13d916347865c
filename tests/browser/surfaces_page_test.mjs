// The page of `exsect intersect --report` for two surfaces given by their equations.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, launch, open, report, runTests, writeScratch} from './browser.mjs';

const browser = await launch();
const changed = (before, after) => before.filter((p, i) => p.some((c, k) => Math.abs(c - after[i][k]) > 20)).length;

await runTests({
  async 'both surfaces in space, curves by name, exact intervals of x, y and z'() {
    const {path, json} = report('intersect', example('surfaces.json'), '--first', 'ball', '--second', 'torus');
    const page = await open(browser, path);
    assertQuiet(page);
    assert.match(await page.locator('#answer').textContent(), /^Complete, proved.*the sphere ball and the torus torus: 1 general curve/s);
    assert.equal(await page.locator('.views .square').count(), 0);
    assert.equal(await page.locator('#slider').count(), 0);
    assert.equal(await page.locator('#nodes tbody tr').count(), json.nodes.length);
    assert.equal(await page.locator('.space .node').count(), json.nodes.length);
    assert.equal(await page.locator('#curves tbody tr').count(), json.curves.length);
    assert.equal(await page.locator('#nodes tbody tr').first().locator('.exact').count(), 3);
    assert.equal(await page.locator('.polynomial').count(), 2);
    for (const which of [0, 1]) {
      const shown = await canvasPixels(page);
      await page.locator(`#patch-${which}`).uncheck();
      assert.ok(changed(shown, await canvasPixels(page)) > 300, `surface ${which} is hidden`);
      await page.locator(`#patch-${which}`).check();
    }
    await page.locator('#arcs tbody tr').first().click();
    assert.match(await page.locator('#selection').textContent(), /^Arc 0 of curve 0, from node/);
    await page.locator('#nodes tbody tr').first().click();
    assert.match(await page.locator('#selection').textContent(), /^Node 0, joint: \(x, y, z\) = /);
    await page.locator('button', {hasText: 'nodes as Markdown'}).click();
    const table = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(table, /^\| node \| kind \| x \| y \| z \|/);
    assert.equal(table.trim().split('\n').length, 2 + json.nodes.length);
    assertQuiet(page);
    await page.context().close();
  },

  async 'every kind of pair, one surface twice, and surfaces that are apart'() {
    for (const [first, second] of [['floor', 'oblique'], ['cone', 'quartic'], ['quartic', 'ball'], ['torus', 'cone'], ['floor', 'torus']]) {
      const {path, json} = report('intersect', example('surfaces.json'), '--first', first, '--second', second);
      const page = await open(browser, path);
      assertQuiet(page);
      assert.equal(await page.locator('#arcs tbody tr').count(), json.arcs.length, `${first} and ${second}`);
      assert.equal(await page.locator('#patch-1').count(), 1);
      await page.context().close();
    }
    const twice = writeScratch('twice.json', JSON.stringify({exsect: 'patches/1', patches: ['a', 'b'].map((name) => ({name, type: 'plane', point: ['0', '0', '0'], normal: ['0', '0', '1']}))}));
    const page = await open(browser, report('intersect', twice).path);
    assertQuiet(page);
    assert.match(await page.locator('#answer').textContent(), /one surface/);
    await page.context().close();
  },

  async 'touch points, crossings and circles have their marks and words'() {
    const pair = writeScratch('crossing.json', JSON.stringify({exsect: 'patches/1', patches: [
      {name: 'a', type: 'cylinder', point: ['0', '0', '0'], axis: ['0', '0', '1'], radius: '1'}, {name: 'b', type: 'cylinder', point: ['0', '0', '0'], axis: ['1', '0', '0'], radius: '1'}]}));
    const {path, json} = report('intersect', pair);
    const page = await open(browser, path);
    assertQuiet(page);
    assert.deepEqual(await page.locator('#curves tbody tr td:nth-child(2)').allTextContents(), ['ellipse', 'ellipse']);
    assert.equal(json.nodes.filter(({kind}) => kind === 'crossing').length, 2);
    const legend = await page.locator('.legend').allTextContents();
    assert.match(legend.join(' '), /ellipse 0, closed/);
    assert.match(legend.join(' '), /crossing/);
    await page.context().close();
  },
});

await browser.close();
