'use strict';
// The data of the page, and how numbers and elements are made. Everything drawn is in doubles and decides nothing.

const report = JSON.parse(document.getElementById('data').textContent);
const result = report.result;
const parameters = report.parameters || ['u', 'v', 'r', 's'];
const graph = report.graph || result;  // nodes and arcs, where there are any
const nodes = graph.nodes || [];
const arcs = graph.arcs || [];

/** An element with attributes and children; strings become text, never markup. */
function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

function drawing(tag, attributes = {}, ...children) {
  return filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function filled(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) if (value !== null) node.setAttribute(key, value);
  for (const child of children.flat()) if (child !== null) node.append(child);
  return node;
}

/** "1 point", "2 points". */
function counted(number, noun) {
  return `${number} ${noun}${number === 1 ? '' : 's'}`;
}

/** Twelve decimals without trailing zeros. */
function short(x) {
  return String(Number(x.toFixed(12)));
}

/** Three digits, not below x, as the program writes them: "8.40e-07". */
function boundText(x) {
  if (!(x > 0)) return '0';
  let [digits, exponent] = x.toExponential(2).split('e').map(Number);
  digits = Math.round(100 * digits);
  if (Number(`${digits}e${exponent - 2}`) < x) ++digits;
  if (digits === 1000) [digits, exponent] = [100, exponent + 1];
  return `${Math.floor(digits / 100)}.${String(digits % 100).padStart(2, '0')}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
}

/** k if the denominator of "p/q" is 2^k, else -1. */
function powerOfTwoBelow(text) {
  const binary = BigInt(text.split('/')[1] || 1).toString(2);
  return /^10*$/.test(binary) ? binary.length - 1 : -1;
}

/** An exact interval: "= p/q", or [lower, upper], over a common power of two where there is one. */
function exactInterval([lower, upper]) {
  const shown = element('span', {class: 'exact', 'data-lower': lower, 'data-upper': upper});
  if (lower === upper) {
    shown.append(`= ${lower}`);
    return shown;
  }
  const powers = [powerOfTwoBelow(lower), powerOfTwoBelow(upper)];
  const k = Math.max(...powers);
  if (Math.min(...powers) < 0 || k < 8) {
    shown.append(`[${lower}, ${upper}]`);
    return shown;
  }
  const [from, to] = [lower, upper].map((text, i) => BigInt(text.split('/')[0]) * 2n ** BigInt(k - powers[i]));
  shown.append(`[${from}, ${to}]\u202f/\u202f2`, element('sup', {}, String(k)));
  return shown;
}

/** The value of a patch at (u,v), and its derivatives, from its control points. */
function patchAt(points, u, v) {
  const basis = (t) => [(1 - t) * (1 - t), 2 * t * (1 - t), t * t];
  const slope = (t) => [2 * t - 2, 2 - 4 * t, 2 * t];
  const sum = (a, b) => [0, 1, 2].map((k) => points.reduce((total, row, i) =>
    total + a[i] * row.reduce((inner, point, j) => inner + b[j] * point[k], 0), 0));
  return {at: sum(basis(u), basis(v)), first: sum(slope(u), basis(v)), second: sum(basis(u), slope(v))};
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
function unit(a) {
  const length = Math.hypot(...a);
  return length > 0 ? a.map((x) => x / length) : a;
}

/** The double nearest to "p/q", also where p and q are beyond the range of doubles. */
function toDouble(text) {
  const [p, q = '1'] = text.split('/');
  if (p.length < 300 && q.length < 300) return Number(p) / Number(q);
  const cut = Math.min(p.length, q.length) - 40;
  return Number(p.slice(0, p.length - cut)) / Number(q.slice(0, q.length - cut));
}

/** Copies a text; true if the browser let us. */
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element('textarea', {readonly: '', 'aria-hidden': 'true'});
    area.value = text;
    document.body.append(area);
    area.select();
    const copied = document.execCommand('copy');
    area.remove();
    return copied;
  }
}

/** Offers a file made of the given parts. */
function saveFile(filename, type, parts) {
  const link = element('a', {download: filename, href: URL.createObjectURL(new Blob(parts, {type}))});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
