// How components and kinds of nodes look: by colour, and by dashes and shape for readers who see no colour.

const dashPatterns = ['', '9 4', '2.5 3', '10 3 2.5 3', '16 4', '5 3 5 8', '1.5 5'];

/** Colours are custom properties of page.css; they differ between light and dark. */
function componentColour(component) {
  return `var(--c${Math.max(component, 0) % 7})`;
}

/** Every component has another dash pattern until they repeat; the first is solid. */
function componentDashes(component) {
  return dashPatterns[Math.max(component, 0) % dashPatterns.length];
}

/** The value of a custom property, now. */
function colour(property) {
  return getComputedStyle(document.documentElement).getPropertyValue(property).trim();
}

/** What is rarer stands later and is drawn on top. */
const glyphs = {
  point: {path: 'M-2.6,0A2.6,2.6 0 1 0 2.6,0A2.6,2.6 0 1 0 -2.6,0Z', filled: true, text: 'turning point of the other square'},
  plain: {path: 'M-4,0A4,4 0 1 0 4,0A4,4 0 1 0 -4,0Z', filled: true, text: 'point of the graph'},
  turning: {path: 'M-4.4,0A4.4,4.4 0 1 0 4.4,0A4.4,4.4 0 1 0 -4.4,0Z', filled: false, text: 'turning point'},
  boundary: {path: 'M-4.5,-4.5H4.5V4.5H-4.5Z', filled: true, text: 'boundary point'},
  end: {path: 'M-4.5,-4.5H4.5V4.5H-4.5Z', filled: true, text: 'end, in an apex or on a box'},
  corner: {path: 'M0,-6.5L6.5,0L0,6.5L-6.5,0Z', filled: true, text: 'corner'},
  'end-of-overlap': {path: 'M-4.5,0A4.5,4.5 0 1 0 4.5,0A4.5,4.5 0 1 0 -4.5,0ZM-1.6,0A1.6,1.6 0 1 1 1.6,0A1.6,1.6 0 1 1 -1.6,0Z', filled: true, text: 'end of overlap'},
  touch: {path: 'M-6.5,-1.5H-1.5V-6.5H1.5V-1.5H6.5V1.5H1.5V6.5H-1.5V1.5H-6.5Z', filled: true, text: 'touch'},
  crossing: {path: 'M-5.6,-3.6L-3.6,-5.6L0,-2L3.6,-5.6L5.6,-3.6L2,0L5.6,3.6L3.6,5.6L0,2L-3.6,5.6L-5.6,3.6L-2,0Z', filled: true, text: 'crossing'},
  cusp: {path: 'M0,-6.8L6.2,4.6H-6.2Z', filled: true, text: 'cusp'},
  singular: {path: 'M0,-6.8L6.2,4.6H-6.2Z', filled: true, text: 'singular point'},
};
const glyphOrder = Object.keys(glyphs);

/** The glyph of the rarest kind of a node; in a square it shows whether a turning point turns there. */
function glyphName(node, square = -1) {
  const kinds = node.kinds.filter((kind) => kind in glyphs);
  if (graph.isolated_points && graph.isolated_points.includes(node.id)) kinds.push('touch');
  if (kinds.length === 0) return 'plain';
  const best = kinds.sort((a, b) => glyphOrder.indexOf(b) - glyphOrder.indexOf(a))[0];
  const own = square < 0 || node.wrt.some((p) => Math.floor(parameters.indexOf(p) / 2) === square);
  return best === 'turning' && !own ? 'point' : best;
}

/** Components that end in each node, in the order of the arcs. */
const componentsAt = nodes.map(() => []);
for (const arc of arcs)
  for (const id of [arc.from, arc.to])
    if (!componentsAt[id].includes(arc.component)) componentsAt[id].push(arc.component);

function nodeColour(node) {
  const of = componentsAt[node.id];
  return of.length === 1 ? componentColour(of[0]) : 'var(--ink)';
}

/** An SVG path of a glyph. */
function glyphPath(name, paint, attributes = {}) {
  const glyph = glyphs[name];
  return drawing('path', {class: 'glyph', d: glyph.path, fill: glyph.filled ? paint : 'var(--paper)', 'fill-rule': 'evenodd',
    stroke: glyph.filled ? 'var(--paper)' : paint, 'stroke-width': glyph.filled ? 1.2 : 2.2, ...attributes});
}

/** Calls back when light and dark, or screen and print, change. */
function onColoursChanged(callback) {
  for (const query of ['(prefers-color-scheme: dark)', 'print'])
    matchMedia(query).addEventListener('change', callback);
}
