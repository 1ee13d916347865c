// Chromium, the program, and what every page must satisfy. Exits with 77, skipped, where Chromium or playwright-core is
// missing; with EXSECT_BROWSER=required in the environment that is a failure.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {accessSync, constants, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const missing = (what) => {
  const required = process.env.EXSECT_BROWSER === 'required';
  console.log(`${required ? 'FAILED' : 'SKIPPED'}: ${what} is missing; ./setup.sh test installs it`);
  process.exit(required ? 1 : 77);
};

const playwright = await import('playwright-core').catch(() => missing('playwright-core (npm ci in tests/browser)'));
const program = process.env.EXSECT_PROGRAM;
const chromium = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) => {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}) || missing('chromium');

export const scratch = mkdtempSync(join(tmpdir(), 'exsect-browser-'));
process.on('exit', () => rmSync(scratch, {recursive: true, force: true}));

export const example = (name) => join(process.env.EXSECT_EXAMPLES, name);

/** Runs the program; a status other than 0, 1 and 3 throws. */
export function exsect(...options) {
  try {
    return execFileSync(program, options, {encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe']});
  } catch (error) {
    if (error.status === 1 || error.status === 3) return error.stdout;
    throw error;
  }
}

/** The page and the JSON result of one run. */
export function report(...options) {
  const path = join(scratch, `report-${Math.random().toString(36).slice(2)}.html`);
  const json = JSON.parse(exsect(...options, '--report', path, '--json', '-'));
  return {path, json, bytes: statSync(path).size, text: readFileSync(path, 'utf8')};
}

export function writeScratch(name, text) {
  const path = join(scratch, name);
  writeFileSync(path, text);
  return path;
}

const withGl = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const withoutGl = ['--disable-gpu', '--disable-3d-apis'];

export function launch({webgl = true} = {}) {
  return playwright.chromium.launch({executablePath: chromium, chromiumSandbox: false, args: webgl ? withGl : withoutGl});
}

/** Opens a page file; `page.errors` and `page.requests` collect what must not happen. */
export async function open(browser, path, options = {}) {
  const context = await browser.newContext({viewport: {width: 1280, height: 900}, permissions: ['clipboard-read', 'clipboard-write'], ...options});
  context.setDefaultTimeout(180000);
  const page = await context.newPage();
  page.errors = [];
  page.requests = [];
  page.on('console', (message) => {
    if (message.type() === 'error') page.errors.push(message.text());
  });
  page.on('pageerror', (error) => page.errors.push(error.message));
  page.on('request', (request) => page.requests.push(request.url()));
  await page.goto('file://' + path);
  await page.waitForSelector('html[data-ready]', {timeout: 180000});
  await settled(page);
  return page;
}

/** Some frames later everything that was asked for is drawn. */
export function settled(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
}

export function assertQuiet(page) {
  assert.deepEqual(page.errors, []);
  assert.equal(page.requests.length, 1, page.requests.join('\n'));
}

/** Pixels of the canvas as [red, green, blue], one in `step`. */
export async function canvasPixels(page, step = 7) {
  await settled(page);
  const numbers = await page.evaluate((step) => {
    const canvas = document.querySelector('.space canvas');
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const {data} = context.getImageData(0, 0, copy.width, copy.height);
    const numbers = [];
    for (let i = 0; i < data.length; i += 4 * step) numbers.push(data[i], data[i + 1], data[i + 2]);
    return numbers.join(' ');  // much faster than a list
  }, step);
  const flat = numbers.split(' ').map(Number);
  return Array.from({length: flat.length / 3}, (_, i) => flat.slice(3 * i, 3 * i + 3));
}

/** Whether a/b = c/d; "p" is p/1. */
export function sameRational(x, y) {
  const [a, b] = x.split('/').map(BigInt);
  const [c, d] = y.split('/').map(BigInt);
  return a * (d ?? 1n) === c * (b ?? 1n);
}

/** Runs the tests of a file one after the other and says which failed. */
export async function runTests(tests) {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    const start = Date.now();
    try {
      await test();
      console.log(`ok      ${name} (${Date.now() - start} ms)`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
  }
  console.log(`${Object.keys(tests).length - failed} passed, ${failed} failed`);
  process.exitCode = failed ? 1 : 0;
}
