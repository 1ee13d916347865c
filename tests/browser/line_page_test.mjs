// The page of `exsect line --report`.
import assert from 'node:assert/strict';

import {assertQuiet, canvasPixels, example, exsect, launch, open, report, runTests, writeScratch} from './browser.mjs';

const browser = await launch();

async function shown(...options) {
  const {path, json} = report('line', ...options);
  const page = await open(browser, path);
  return {page, json};
}

await runTests({
  async 'points, feasible intervals and phantoms of a line'() {
    const {page, json} = await shown(example('chapter9-first.json'), '--u', '1/2');
    assertQuiet(page);
    assert.match(await page.locator('#answer').textContent(), /^Complete, proved\. The line u = 1\/2 meets the other patch in 2 points\.$/);
    assert.deepEqual((await page.locator('.points .decimal').allTextContents()).map(Number), json.points.flatMap((point) => ['v', 'r', 's'].map((p) => point.approx[p])));
    assert.equal(await page.locator('.fibre .square .fibre-point').count(), 4);
    assert.equal(await page.locator('.fibre .square [data-feasible="1"]').count(), 1);
    assert.equal(await page.locator('.fibre .square .phantom').count(), 1);
    for (const curve of ['branch1', 'second', 'start', 'end']) assert.equal(await page.locator(`.fibre .square .curve.${curve}`).count(), 1, curve);
    assert.equal(await page.locator('.space circle.fibre-point').count(), 2);
    assert.equal(await page.locator('.polynomial').count(), 3);
    await page.context().close();
  },

  async 'a click on a row, in the square, in space marks the same point everywhere'() {
    const {page} = await shown(example('chapter9-first.json'), '--u', '1/2');
    const marked = () => page.locator('.selected').evaluateAll((all) => all.map((one) => [one.tagName.toLowerCase(), one.dataset.point]).sort());
    const everywhere = (i) => [['circle', i], ['circle', i], ['circle', i], ['tr', i]];  // in space, in both squares, in the table
    await page.locator('tr[data-point="1"]').click();
    assert.deepEqual(await marked(), everywhere('1'));
    assert.match(await page.locator('#selection').textContent(), /^Point b of the line: u = 0\.5, v = 0\.5336587579289931, /);
    await page.locator('.fibre .square .hit[data-point="0"]').last().click();
    assert.deepEqual(await marked(), everywhere('0'));
    const [x, y] = await page.locator('.space [data-point="1"]').evaluate((mark) => mark.getAttribute('transform').match(/-?[\d.]+/g).map(Number));
    await page.locator('.space canvas').click({position: {x, y}});
    assert.deepEqual(await marked(), everywhere('1'));
    await page.locator('tr[data-point="1"] .pick').press('Enter');
    assert.deepEqual(await marked(), []);
    assertQuiet(page);
    await page.context().close();
  },

  async 'the curves pass through the points'() {
    const {page} = await shown(example('chapter9-first.json'), '--u', '1/2');
    const distances = await page.evaluate(() => [...[...document.querySelectorAll('.fibre .square')].at(-1).querySelectorAll('.fibre-point')].map((point) => ['branch1', 'second'].map((name) => {
      const path = document.querySelector(`.fibre .square .curve.${name}`);
      let least = Infinity;
      for (let t = 0; t <= path.getTotalLength(); t += 0.2) {
        const at = path.getPointAtLength(t);
        least = Math.min(least, Math.hypot(at.x - point.cx.baseVal.value, at.y - point.cy.baseVal.value));
      }
      return least;
    })));
    for (const distance of distances.flat()) assert.ok(distance < 0.6, String(distance));
    await page.context().close();
  },

  async 'plane and cylinder are switched in space'() {
    const {page} = await shown(example('chapter9-first.json'), '--u', '1/2');
    for (const part of ['cylinder', 'plane', 'line']) {
      const before = await canvasPixels(page);
      await page.locator(`#show-${part}`).click();
      const after = await canvasPixels(page);
      assert.ok(before.filter((pixel, i) => pixel.some((c, k) => Math.abs(c - after[i][k]) > 12)).length > 30, part);
    }
    assert.equal(await page.locator('.space circle.fibre-point').count(), 0);
    assertQuiet(page);
    await page.context().close();
  },

  async 'lines of the other patch and of other parameters'() {
    for (const [option, value] of [['--v', '3/10'], ['--r', '1/3'], ['--s', '1']]) {
      const {page, json} = await shown(example('chapter9-first.json'), option, value);
      assertQuiet(page);
      assert.equal(await page.locator('.fibre .square').last().locator('.fibre-point').count(), json.points.length);
      assert.equal(await page.locator('.fibre .square').last().locator('.axis').first().textContent(), json.eliminant.variable);
      await page.context().close();
    }
  },

  async 'straight and collapsed lines, and a line on the other patch'() {
    const flat = [[['0', '0', '0'], ['0', '1', '0']], [['1', '0', '0'], ['1', '1', '0']]];
    const cone = [[['1/2', '1/2', '1'], ['1/2', '1/2', '1']], [['0', '1/4', '-1'], ['1', '3/4', '-1']]];
    const wall = [[['0', '1/2', '0'], ['1', '1/2', '0']], [['0', '1/2', '1'], ['1', '1/2', '1']]];
    const file = writeScratch('shapes.json', JSON.stringify({exsect: 'patches/1', patches: [['flat', flat], ['cone', cone], ['wall', wall]].map(([name, points]) => ({name, degree: [1, 1], points}))}));
    for (const [first, second, u, shape] of [['cone', 'flat', '1/2', 'straight'], ['cone', 'flat', '0', 'point'], ['wall', 'flat', '0', 'straight']]) {
      const {page, json} = await shown(file, '--first', first, '--second', second, '--u', u);
      assertQuiet(page);
      assert.equal(json.shape, shape);
      assert.equal(await page.locator('.points tbody tr').count(), json.points.length);
      if (json.on_patch.length) assert.match(await page.locator('.fibre-facts').textContent(), /The line lies on the other patch for v in \[0, 1\]/);
      await page.context().close();
    }
    assert.ok(exsect('line', file, '--first', 'wall', '--second', 'flat', '--u', '0').includes('on the other patch'));
  },

  async 'lines with weights and cubic lines'() {
    const quarter = {name: 'quarter', degree: [1, 2], points: [[['0', '1', '0'], ['0', '1', '1'], ['0', '0', '1']], [['1', '1', '0'], ['1', '1', '1'], ['1', '0', '1']]], weights: [['1', '1', '2'], ['1', '1', '2']]};
    const twisted = {name: 'twisted', degree: [1, 3], points: ['0', '1'].map((z) => [['0', '0', '-1'], ['1', '2', z], ['2', '-1', '-1'], ['1', '1', '2']])};
    const bent = {name: 'bent', degree: [1, 3], points: ['0', '1'].map((x) => [[x, '-1', '-2'], [x, '0', '2'], [x, '0', '-2'], [x, '1', '2']])};
    const floor = {name: 'floor', degree: [1, 1], points: [[['-3', '-3', '1/2'], ['-3', '3', '1/2']], [['3', '-3', '1/2'], ['3', '3', '1/2']]]};
    const file = writeScratch('kinds.json', JSON.stringify({exsect: 'patches/1', patches: [quarter, twisted, bent, floor]}));
    for (const [first, shape, words] of [['quarter', 'conic', 'a conic, cut out by its plane and a quadratic cylinder'], ['twisted', 'twisted cubic', 'a cubic in no plane'], ['bent', 'plane cubic', 'a cubic, cut out by its plane']]) {
      const {page, json} = await shown(file, '--first', first, '--second', 'floor', '--u', '0');
      assertQuiet(page);
      assert.equal(json.shape, shape);
      assert.ok(json.points.length > 0);
      assert.equal(await page.locator('.points tbody tr').count(), json.points.length);
      assert.ok((await page.locator('.fibre-facts').textContent()).includes(words));
      const legend = await page.locator('.fibre .legend').textContent();
      assert.ok(legend.includes({conic: 'cylinder Z = 0', 'plane cubic': 'cubic', 'twisted cubic': 'quadrics'}[shape]));
      assert.equal(await page.locator('#equations-title').count(), shape === 'twisted cubic' ? 0 : 1);
      await page.context().close();
    }
  },
});

await browser.close();
