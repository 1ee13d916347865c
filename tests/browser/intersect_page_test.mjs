// The page of `exsect intersect --report`.
import assert from 'node:assert/strict';
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';

import {assertQuiet, canvasPixels, example, exsect, launch, open, report, runTests, sameRational, settled, writeScratch} from './browser.mjs';

const browser = await launch();
const first = report('intersect', example('chapter9-first.json'));
const page = await open(browser, first.path);

/** Ids of the marked rows, marks in the squares and marks in space. */
const marked = () => page.evaluate(() => {
  const ids = (selector) => [...document.querySelectorAll(selector)].map((node) => Number(node.dataset.node ?? node.dataset.arc));
  return {rows: ids('tr.selected'), squares: ids('.square .node.selected, .square .arc.selected'), space: ids('.space .node.selected')};
});
const everywhere = (id) => ({rows: [id], squares: [id, id], space: [id]});
const unmark = () => page.locator('tr.selected').first().click();

/** Exact intervals as they are read on the page: "[a, b] / 2^k", "[p/q, p/q]" or "= p/q". */
function readInterval(text, power) {
  const numbers = text.replace(/\u202f/g, ' ').match(/-?\d+(\/\d+)?/g);
  if (text.startsWith('=')) return [numbers[0], numbers[0]];
  return numbers.slice(0, 2).map((n) => power ? `${n}/${2n ** BigInt(power)}` : n);
}

await runTests({
  async 'one file, one request, no error'() {
    assertQuiet(page);
    assert.ok(first.bytes < 1.5e6, `${first.bytes} bytes`);
    assert.match(first.text, /http-equiv="Content-Security-Policy" content="default-src 'none';/);
    assert.doesNotMatch(first.text, /unsafe-inline|unsafe-eval/);
  },

  async 'a script that is not the page\'s own does not run'() {
    const ran = await page.evaluate(() => {
      const script = document.createElement('script');
      script.textContent = 'window.intruder = true';
      document.body.append(script);
      script.remove();
      return window.intruder === true;
    });
    assert.equal(ran, false);
    assert.equal(page.errors.length, 1);
    page.errors.length = 0;
  },

  async 'the view of space shows both patches and both components'() {
    const pixels = await canvasPixels(page);
    const count = (is) => pixels.filter(is).length;
    assert.ok(count(([r, g, b]) => b > r + 40 && b > 150 && r > 90) > 300, 'first patch');
    assert.ok(count(([r, g, b]) => r > b + 60 && g > b + 30 && r > 190) > 300, 'second patch');
    assert.ok(count(([r, g, b]) => r > 150 && g > 50 && g < 125 && b < 70) > 15, 'component 1');
    assert.ok(count(([r, g, b]) => r < 60 && g > 80 && g < 150 && b > 130) > 3, 'component 0');
    assert.equal(await page.locator('.space .node').count(), first.json.nodes.length);
  },

  async 'rows are the JSON result'() {
    const rows = await page.locator('#nodes tbody tr').evaluateAll((rows) => rows.map((row) => ({
      id: row.querySelector('.pick').textContent, kinds: row.querySelector('.kinds').textContent, place: row.querySelector('.place').textContent,
      decimals: [...row.querySelectorAll('td:not(.point) .decimal')].map((cell) => cell.textContent),
      exact: [...row.querySelectorAll('.exact')].map((cell) => ({text: [...cell.childNodes].filter((c) => c.nodeType === 3).map((c) => c.data).join(''), power: cell.querySelector('sup')?.textContent})),
    })));
    assert.equal(rows.length, first.json.nodes.length);
    first.json.nodes.forEach((node, i) => {
      assert.equal(rows[i].id, String(node.id));
      assert.equal(rows[i].kinds, node.kinds.join(', '));
      assert.equal(rows[i].place, [...node.on, ...node.wrt.map((p) => `turns in ${p}`)].join(', '));
      ['u', 'v', 'r', 's'].forEach((p, k) => {
        assert.equal(Number(rows[i].decimals[k]), node.approx[p]);
        const shown = readInterval(rows[i].exact[k].text.replace(/\u202f\/\u202f2$/, ''), rows[i].exact[k].power);
        assert.ok(sameRational(shown[0], node.box[p][0]) && sameRational(shown[1], node.box[p][1]), `node ${i} ${p}: ${rows[i].exact[k].text}`);
      });
    });
    const arcs = await page.locator('#arcs tbody tr').evaluateAll((rows) => rows.map((row) => ['component', 'from', 'to', 'vertices', 'bound'].map((name) => Number(row.querySelector('.' + name).textContent))));
    assert.equal(arcs.length, first.json.arcs.length);
    first.json.arcs.forEach((arc, i) => {
      assert.deepEqual(arcs[i].slice(0, 4), [arc.component, arc.from, arc.to, arc.polyline.length]);
      assert.ok(arcs[i][4] >= arc.error_bound && arcs[i][4] <= 1.01 * arc.error_bound);
    });
  },

  async 'a click on a row, in a square, in space marks the same node everywhere'() {
    for (const {id} of first.json.nodes.slice(0, 5)) {
      await page.locator(`#nodes tr[data-node="${id}"]`).click();
      assert.deepEqual(await marked(), everywhere(id));
      assert.match(await page.locator('#selection').textContent(), new RegExp(`^Node ${id}\\b`));
      await unmark();
      assert.deepEqual(await marked(), {rows: [], squares: [], space: []});
    }
    for (const square of [0, 1]) {
      await page.locator('.views .square').nth(square).locator('.node[data-node="1"] .hit').click();
      assert.deepEqual(await marked(), everywhere(1));
      await unmark();
    }
    // the node that is furthest from its neighbours in the picture
    const places = await page.locator('.space .node').evaluateAll((marks) => marks.map((mark) => ({id: Number(mark.dataset.node), at: mark.getAttribute('transform').match(/-?[\d.]+/g).map(Number)})));
    const alone = (place) => Math.min(...places.filter((other) => other !== place).map((other) => Math.hypot(other.at[0] - place.at[0], other.at[1] - place.at[1])));
    const chosen = places.sort((a, b) => alone(b) - alone(a))[0];
    await page.locator('.space canvas').click({position: {x: chosen.at[0], y: chosen.at[1]}});
    assert.deepEqual(await marked(), everywhere(chosen.id));
    await unmark();
  },

  async 'an arc is marked everywhere'() {
    const arcs = first.json.arcs;
    const long = arcs.reduce((a, b) => b.polyline.length > a.polyline.length ? b : a).id;
    await page.locator(`#arcs tr[data-arc="${long}"]`).click();
    assert.deepEqual(await marked(), {rows: [long], squares: [long, long], space: []});
    const before = await canvasPixels(page, 3);
    await unmark();
    await settled(page);
    const after = await canvasPixels(page, 3);
    assert.ok(before.filter((pixel, i) => pixel.some((c, k) => Math.abs(c - after[i][k]) > 40)).length > 8, 'the arc is drawn wider in space');
    for (const square of [0, 1]) {
      const hit = page.locator('.views .square').nth(square).locator(`.hit[data-arc="${long}"]`);
      await hit.scrollIntoViewIfNeeded();
      const at = await hit.evaluate((path) => {
        const middle = path.getPointAtLength(path.getTotalLength() / 2).matrixTransform(path.getScreenCTM());
        return [middle.x, middle.y];
      });
      await page.mouse.click(...at);
      assert.deepEqual(await marked(), {rows: [long], squares: [long, long], space: []});
      await unmark();
    }
  },

  async 'nodes are reached and chosen with the keys'() {
    await page.locator('.views .square').first().locator('.node[data-node="0"]').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    assert.deepEqual(await marked(), everywhere(2));
    await page.keyboard.press('Enter');
    await page.locator('#nodes .pick').nth(3).focus();
    await page.keyboard.press('Space');
    assert.deepEqual(await marked(), everywhere(3));
    assert.equal(await page.locator('#nodes .pick[aria-pressed="true"]').count(), 1);
    await page.keyboard.press('Space');
    const before = await canvasPixels(page);
    await page.locator('.space canvas').focus();
    await page.keyboard.press('ArrowLeft');
    await settled(page);
    const after = await canvasPixels(page);
    assert.ok(before.some((pixel, i) => pixel.some((c, k) => c !== after[i][k])), 'the view turns');
    await page.keyboard.press('0');
  },

  async 'the slider shows the exact fibre'() {
    const slider = page.locator('#slider');
    for (const [step, u] of [[2, '1/20'], [14, '7/20'], [40, '1']]) {
      await slider.fill(String(step));
      const line = JSON.parse(exsect('line', example('chapter9-first.json'), '--u', u, '--json', '-'));
      assert.equal(await page.locator('#value').textContent(), `u = ${u}`);
      assert.equal(await page.locator('#fibre tr[data-point]').count(), line.points.length);
      for (const square of [0, 1]) assert.equal(await page.locator('.views .square').nth(square).locator('.fibre-layer .fibre-point').count(), line.points.length);
      assert.equal(await page.locator('.space circle.fibre-point').count(), line.points.length);
      const shown = await page.locator('#fibre .points .decimal').allTextContents();
      assert.deepEqual(shown.map(Number), line.points.flatMap((point) => ['v', 'r', 's'].map((p) => point.approx[p])));
      const bars = await page.locator('#fibre .square [data-feasible]').count();
      assert.equal(bars, line.feasible.reduce((n, {intervals}) => n + intervals.length, 0));
    }
    assert.ok(await page.locator('#show-plane').isChecked() && await page.locator('#show-cylinder').isChecked());
    await slider.focus();
    await page.keyboard.press('ArrowLeft');
    assert.equal(await page.locator('#value').textContent(), 'u = 39/40');
    const x = await page.locator('.views .square').first().locator('.fibre-layer path').getAttribute('d');
    await page.keyboard.press('ArrowLeft');
    assert.notEqual(await page.locator('.views .square').first().locator('.fibre-layer path').getAttribute('d'), x);
  },

  async 'polynomials are copied for computer algebra systems'() {
    await page.locator('#slider').fill('20');
    const line = JSON.parse(exsect('line', example('chapter9-first.json'), '--u', '1/2', '--json', '-'));
    const box = page.locator('.polynomial', {hasText: 'eliminant'});
    await box.getByRole('button', {name: 'PARI/GP'}).click();
    const pari = await page.evaluate(() => navigator.clipboard.readText());
    const c = line.eliminant.coefficients;
    assert.ok(pari.startsWith(`R = ${c[16]}*s^16+${c[15]}*s^15`) && pari.endsWith(`${c[1]}*s+${c[0]};\n`), pari);
    await page.locator('.polynomial', {hasText: 'plane'}).getByRole('button', {name: 'Singular'}).click();
    const n = line.plane.normal;
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), `ring R = 0,(x,y,z),dp;\npoly P = ${n[0]}*x${n[1]}*y${n[2]}*z+${line.plane.constant};\n`);
    await page.locator('.polynomial', {hasText: 'cylinder'}).getByRole('button', {name: 'Sage'}).click();
    assert.match(await page.evaluate(() => navigator.clipboard.readText()), /^R\.<x,y,z> = PolynomialRing\(QQ\)\nZ = -255076307550335209\/8093906648432640000\*x\^2\+/);
    assertQuiet(page);
  },

  async 'pictures and the result are saved as files'() {
    const saved = async (button) => {
      const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
      return readFileSync(await download.path());
    };
    const png = await saved(page.getByRole('button', {name: 'save picture'}));
    assert.equal(png.subarray(1, 4).toString(), 'PNG');
    const canvas = await page.locator('.space').boundingBox();
    assert.ok(Math.abs(png.readUInt32BE(16) - 3 * canvas.width) < 9, 'three pixels for one');
    const svg = (await saved(page.getByRole('button', {name: 'save as SVG'}).first())).toString();
    assert.ok(svg.startsWith('<svg') && svg.includes('xmlns="http://www.w3.org/2000/svg"'));
    assert.ok(!svg.includes('var(') && !svg.includes('class=') && svg.length < 60000, svg.slice(0, 3000));
    assert.deepEqual(JSON.parse(await saved(page.getByRole('button', {name: 'save the result as JSON'}))).nodes, first.json.nodes);
    assertQuiet(page);
  },

  async 'patches are hidden, made opaque, and seen along the axes'() {
    for (const part of ['line', 'plane', 'cylinder']) await page.locator(`#show-${part}`).uncheck();
    const blue = (pixels) => pixels.filter(([r, g, b]) => b > r + 40 && b > 150 && r > 90).length;
    const before = await canvasPixels(page);
    await page.locator('#patch-0').click();
    assert.ok(blue(await canvasPixels(page)) < blue(before) / 4);
    await page.locator('#patch-0').click();
    await page.locator('#solidity').fill('100');
    const solid = await canvasPixels(page);
    assert.ok(solid.some((pixel, i) => pixel.some((c, k) => Math.abs(c - before[i][k]) > 25)));
    await page.locator('#solidity').fill('62');
    for (const [k, name] of ['x', 'y', 'z'].entries()) {
      await page.getByRole('button', {name: `view along ${name}`}).click();
      await settled(page);
      const seen = await page.evaluate((k) => {
        const {low, high} = view.ball;
        const other = [0, 1, 2].filter((m) => m !== k);
        const ends = [low, low.map((t, m) => m === k ? high[m] : t)].map((p) => view.onScreen(p));
        return {along: Math.hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]), inside: view.seen.every((p) => view.onScreen(p).every((t, m) => t >= 0 && t <= view.size[m])), names: [...document.querySelectorAll('.axis-name')].map((text) => text.textContent), other};
      }, k);
      assert.ok(seen.inside, 'everything is in the frame');
      assert.ok(seen.along < 80, `the axis ${name} is seen from its end: ${seen.along}`);
      assert.deepEqual(seen.names, ['x', 'y', 'z'].filter((other) => other !== name));
    }
    await page.getByRole('button', {name: 'turn back'}).click();
    await settled(page);
    assert.ok(await page.locator('.axes .tick').count() >= 3);
    await page.locator('#axes').click();
    await settled(page);
    assert.equal(await page.locator('.axes .tick').count(), 0);
    await page.locator('#axes').click();
    await page.locator('#full-screen').click();
    await page.waitForSelector('figure.large');
    await page.locator('#full-screen').click();
    await page.waitForSelector('figure:not(.large)');
    assertQuiet(page);
  },

  async 'numbers of nodes cover no node'() {
    await page.locator('#numbers').click();
    await settled(page);
    for (const picture of ['.space', '.views .square >> nth=0', '.views .square >> nth=1']) {
      const covered = await page.locator(picture).evaluate((root) => {
        const places = [...root.querySelectorAll('.node')].map((node) => node.getAttribute('transform').match(/-?[\d.]+/g).map(Number));
        return [...root.querySelectorAll('.node')].filter((node, i) => {
          const number = node.querySelector('.number');
          const at = [places[i][0] + Number(number.getAttribute('x')), places[i][1] + Number(number.getAttribute('y')) - 4];
          return places.some((place) => Math.hypot(place[0] - at[0], place[1] - at[1]) < 6);
        }).length;
      });
      assert.equal(covered, 0, picture);
    }
    await page.locator('#numbers').click();
  },

  async 'a square is zoomed with the wheel once it has the focus'() {
    const square = page.locator('.views .square').first();
    await square.scrollIntoViewIfNeeded();
    const domain = () => page.evaluate(() => squares[0].domain.flat());
    const box = await square.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.wheel(0, -100);
    assert.deepEqual(await domain(), [0, 1, 0, 1]);
    await square.focus();
    await square.scrollIntoViewIfNeeded();
    const now = await square.boundingBox();
    await page.mouse.move(now.x + now.width / 2, now.y + now.height / 2);
    await page.mouse.wheel(0, -100);
    await page.waitForFunction(() => squares[0].width() < 0.9);
    const [a, b, c, d] = await domain();
    assert.ok(a > 0 && b < 1 && Math.abs(b - a - (d - c)) < 1e-12);
    await page.locator('#nodes tr[data-node="9"]').click();
    assert.equal(await page.locator('.views .square').nth(1).locator('.node.selected').count(), 1);
    await unmark();
    await square.focus();
    await page.keyboard.press('0');
    assert.deepEqual(await domain(), [0, 1, 0, 1]);
  },

  async 'tables, citation and origin for a paper'() {
    const copied = async (name) => {
      await page.getByRole('button', {name, exact: true}).click();
      return page.evaluate(() => navigator.clipboard.readText());
    };
    const markdown = (await copied('nodes as Markdown')).trim().split('\n').map((line) => line.split('|').slice(1, -1).map((cell) => cell.trim()));
    assert.deepEqual(markdown[0], ['node', 'kind', 'u', 'v', 'r', 's', 'x', 'y', 'z']);
    const patch = JSON.parse(readFileSync(example('chapter9-first.json'), 'utf8')).patches[0].points;
    const number = (text) => text.split('/').map(Number).reduce((p, q) => p / q);
    first.json.nodes.forEach((node, i) => {
      const row = markdown[i + 2];
      assert.equal(row[0], String(node.id));
      ['u', 'v', 'r', 's'].forEach((p, k) => assert.ok(Math.abs(Number(row[2 + k]) - node.approx[p]) <= 2 * 10 ** -(row[2 + k].split('.')[1] || '').length, `${p}: ${row[2 + k]}`));
      const [u, v] = [node.approx.u, node.approx.v].map((t) => [(1 - t) ** 2, 2 * t * (1 - t), t * t]);
      [0, 1, 2].forEach((k) => {
        const exact = patch.reduce((sum, line, m) => sum + u[m] * line.reduce((inner, point, n) => inner + v[n] * number(String(point[k])), 0), 0);
        assert.ok(Math.abs(Number(row[6 + k]) - exact) < 1e-9, `node ${i}: ${row[6 + k]} instead of ${exact}`);
      });
    });
    const latex = await copied('nodes as LaTeX');
    assert.equal(latex.match(/\\\\/g).length, first.json.nodes.length + 1);
    assert.match(latex, /\\begin\{tabular\}\{llrrrrrrr\}/);
    const bibtex = await copied('BibTeX');
    const citation = readFileSync(example('../CITATION.cff'), 'utf8');
    for (const words of ['Chau', 'Oberneder', 'Galligo', 'Intersecting Biquadratic', 'Springer', '2008', citation.match(/^version: (\S+)$/m)[1]]) assert.ok(bibtex.includes(words), words);
    assert.equal(await copied('command line'), `exsect intersect ${example('chapter9-first.json')}\n`);
    const hash = createHash('sha256').update(readFileSync(example('chapter9-first.json'))).digest('hex');
    assert.ok((await page.locator('.origin').textContent()).includes(hash));
  },

  async 'the view of space as lines, hidden ones removed'() {
    const saved = async () => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', {name: 'drawing of space as SVG'}).click()]);
      return readFileSync(await download.path(), 'utf8');
    };
    const svg = await saved();
    assert.ok(svg.startsWith('<svg') && !svg.includes('var(') && !svg.includes('<image') && svg.length < 400000, String(svg.length));
    assert.equal(svg, await saved());
    const ink = (text) => (text.match(/[ML]/g) || []).length;
    await page.locator('#patch-0').click();
    await page.locator('#patch-1').click();
    await settled(page);
    assert.ok(/stroke="#d55e00"/.test(svg) && /stroke="#0072b2"/.test(svg));
    // with one patch less in front more of the other one is seen
    const without = await saved();
    assert.ok(ink(without) < ink(svg));
    await page.locator('#patch-1').click();
    await settled(page);
    const drawnLength = await page.evaluate(() => {
      const map = new DepthMap(view, view.shownSurfaces(), 2);
      const all = view.lines().filter(({visible, userData}) => visible && userData.patch === 1);
      const length = (runs) => runs.reduce((sum, run) => sum + run.slice(1).reduce((s, p, i) => s + Math.hypot(p[0] - run[i][0], p[1] - run[i][1]), 0), 0);
      const alone = all.reduce((sum, {userData}) => sum + length(seenRuns(view, map, userData.points)), 0);
      view.hidden.delete(0);
      const both = new DepthMap(view, view.shownSurfaces(), 2);
      const covered = all.reduce((sum, {userData}) => sum + length(seenRuns(view, both, userData.points)), 0);
      view.repaint();
      return {alone, covered};
    });
    assert.ok(drawnLength.covered < 0.9 * drawnLength.alone && drawnLength.covered > 0.2 * drawnLength.alone, JSON.stringify(drawnLength));
    await page.locator('#patch-0').evaluate((box) => { box.checked = true; });
    assertQuiet(page);
  },

  async 'without a script verdict, counts and picture are there'() {
    const still = await browser.newContext({javaScriptEnabled: false});
    const plain = await still.newPage();
    await plain.goto('file://' + first.path);
    assert.match(await plain.locator('#answer').textContent(), /^Complete, proved\. Patches x and y intersect in 2 components \(1 closed, 1 open\)\.$/);
    assert.match(await plain.locator('#counts').textContent(), /12nodes|nodes12/);
    assert.equal(await plain.locator('#still svg').count(), 1);
    assert.ok((await plain.locator('#still svg').boundingBox()).height > 200);
    await still.close();
  },

  async 'text from files is only text'() {
    const model = JSON.parse(readFileSync(example('chapter9-first.json'), 'utf8'));
    const name = '</script><img src=x onerror="window.hacked=1"><!-- {{data}} \u2028 &amp;';
    model.title = `</title><script>window.hacked=1</script>${name}`;
    model.patches[0].name = name;
    model.patches[1].name = '"><svg onload=window.hacked=1>';
    const {path, json} = report('intersect', writeScratch('names.json', JSON.stringify(model)));
    const named = await open(browser, path);
    assertQuiet(named);
    assert.equal(json.first, name);
    assert.equal(await named.evaluate(() => window.hacked), undefined);
    assert.equal(await named.locator('img').count(), 0);
    assert.equal(await named.locator('h1').textContent(), model.title);
    assert.equal(await named.title(), model.title);
    assert.ok((await named.locator('#answer').textContent()).includes(name));
    assert.equal(await named.locator('.space').locator('text', {hasText: name.slice(0, 20)}).count(), 1);
    await named.context().close();
  },

  async 'without WebGL it says so and the rest works'() {
    const plain = await launch({webgl: false});
    const flat = await open(plain, first.path);
    assert.match(await flat.locator('.space').textContent(), /no WebGL/);
    assert.equal(flat.requests.length, 1);
    assert.ok(flat.errors.every((text) => /WebGL/.test(text)), flat.errors.join('\n'));
    assert.equal(await flat.locator('#nodes tbody tr').count(), first.json.nodes.length);
    await flat.locator('#nodes tr[data-node="3"]').click();
    assert.equal(await flat.locator('.square .node.selected').count(), 2);
    await flat.locator('#slider').fill('10');
    assert.equal(await flat.locator('#value').textContent(), 'u = 1/4');
    await plain.close();
  },

  async 'fits a screen of 400 pixels'() {
    const small = await open(browser, first.path, {viewport: {width: 400, height: 800}, hasTouch: true});
    assertQuiet(small);
    assert.equal(await small.evaluate(() => document.documentElement.scrollWidth), 400);
    const box = await small.locator('.space canvas').boundingBox();
    assert.ok(box.width > 350 && box.x >= 0 && box.x + box.width <= 400);
    const card = await small.locator('#nodes tbody tr').first().boundingBox();
    assert.ok(card.x >= 0 && card.x + card.width <= 400 && card.height > 150, 'a node is a card');
    assert.equal(await small.locator('#nodes').evaluate((table) => table.scrollWidth <= table.clientWidth + 1), true);
    await small.context().close();
  },

  async 'dark, and light again on paper'() {
    const dark = await open(browser, first.path, {colorScheme: 'dark'});
    assertQuiet(dark);
    const brightness = (text) => text.match(/[\d.]+/g).slice(0, 3).reduce((sum, c) => sum + Number(c), 0) / 3;
    const body = () => dark.evaluate(() => ({paper: getComputedStyle(document.body).backgroundColor, ink: getComputedStyle(document.body).color}));
    assert.ok(brightness((await body()).paper) < 40 && brightness((await body()).ink) > 200);
    assert.ok((await canvasPixels(dark))[0].every((c) => c < 50));
    await dark.emulateMedia({media: 'print', colorScheme: 'dark'});
    await settled(dark);
    assert.ok(brightness((await body()).paper) > 250 && brightness((await body()).ink) < 60);
    assert.ok((await canvasPixels(dark))[0].every((c) => c > 250));
    assert.ok((await dark.pdf({format: 'A4', printBackground: true})).length > 20000);
    await dark.context().close();
  },
});

await browser.close();
