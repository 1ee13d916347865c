'use strict';
// The data of the page, and how numbers and elements are made. Everything drawn is in doubles and decides nothing.

const report = JSON.parse(document.getElementById('data').textContent);
const result = report.result;
const parameters = report.parameters || ['u', 'v', 'r', 's'];
const inSpace = (vertex) => vertex.slice(parameters.length);  // vertices are parameters, then coordinates
const equations = report.equations || [];  // of surfaces given by them
const graph = asGraph(report.graph || result);  // nodes and arcs, where there are any
const nodes = graph.nodes || [];
const arcs = graph.arcs || [];

/**
 * Of a result surfaces/1 the graph without parameters, whose points are in space alone; its components are the parts that
 * the page names, or the curves. Any other result is one already.
 */
function asGraph(tree) {
  if (tree.exsect !== 'surfaces/1') return tree;
  const components = report.components || tree.curves.map((curve) => ({...curve, shape: curve.closed ? 'closed' : 'open'}));
  const componentOf = new Map(components.flatMap(({id, arcs}) => arcs.map((arc) => [arc, id])));
  const bounds = (node) => ['first', 'second'].flatMap((which) => (node.bounds ? node.bounds[which] : []).map((name) => `${which}: ${name}`));
  return {...tree, components, overlaps: [], isolated_points: tree.nodes.filter(({kind}) => kind === 'touch').map(({id}) => id),
    nodes: tree.nodes.map((node) => ({...node, kinds: [node.kind], on: bounds(node), wrt: [], free: [], approx: {point: node.approx}})),
    arcs: tree.arcs.map((arc) => ({...arc, component: componentOf.get(arc.id), contact: arc.multiplicity !== 1 ? 'tangential' : 'transversal', on: 'interior', free: []}))};
}

/** What a component is called: a curve by its name, where the components are curves. */
function componentName({id, kind}) {
  return kind ? `${kind === 'general' ? 'curve' : kind} ${id}` : `component ${id}`;
}

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

/** The Bernstein polynomials of degree n at t. */
function bernstein(n, t) {
  let basis = [1];
  for (let k = 1; k <= n; ++k) basis = Array.from({length: k + 1}, (_, i) => (i < k ? (1 - t) * basis[i] : 0) + (i > 0 ? t * basis[i - 1] : 0));
  return basis;
}

/** Their derivatives. */
function bernsteinSlopes(n, t) {
  const lower = bernstein(n - 1, t);
  return Array.from({length: n + 1}, (_, i) => n * ((i > 0 ? lower[i - 1] : 0) - (i < n ? lower[i] : 0)));
}

/** The value of a patch at (u,v), and its derivatives, from its control points [x, y, z] or, with weights, [x, y, z, w]. */
function patchAt(points, u, v) {
  const [m, n] = [points.length - 1, points[0].length - 1];
  const sum = (a, b) => [0, 1, 2, 3].map((k) => points.reduce((total, row, i) =>
    total + a[i] * row.reduce((inner, point, j) => inner + b[j] * (k < 3 ? point[k] : 1) * (point[3] ?? 1), 0), 0));
  const value = sum(bernstein(m, u), bernstein(n, v));
  const at = value.slice(0, 3).map((t) => t / value[3]);
  const slope = (d) => at.map((t, k) => (d[k] - t * d[3]) / value[3]);
  return {at, first: slope(sum(bernsteinSlopes(m, u), bernstein(n, v))), second: slope(sum(bernstein(m, u), bernsteinSlopes(n, v)))};
}

/** Whether the parameter lines of a patch are conics with a plane and a quadratic cylinder of their own. */
const isBiquadratic = ({net, weights}) => !weights && net.length <= 3 && net[0].length <= 3;

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
