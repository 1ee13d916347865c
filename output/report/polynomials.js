// Polynomials for reading, and as text that computer algebra systems read.

/** "3/7*x^2*y-z+1"; terms are [coefficient, exponents]. */
function algebraText(terms, variables) {
  if (!terms.length) return '0';
  return terms.map(([coefficient, exponents], i) => {
    const powers = variables.flatMap((name, k) => exponents[k] === 0 ? [] : exponents[k] === 1 ? [name] : [`${name}^${exponents[k]}`]);
    const negative = coefficient.startsWith('-');
    const size = negative ? coefficient.slice(1) : coefficient;
    const factors = size === '1' && powers.length ? powers : [size, ...powers];
    return (negative ? '-' : i > 0 ? '+' : '') + factors.join('*');
  }).join('');
}

/** What each system is given: variables declared, the polynomial named. */
const algebraSystems = {
  Singular: (name, variables, text) => `ring R = 0,(${variables.join(',')}),dp;\npoly ${name} = ${text};\n`,
  Sage: (name, variables, text) => `R.<${variables.join(',')}> = PolynomialRing(QQ)\n${name} = ${text}\n`,
  'PARI/GP': (name, variables, text) => `${name} = ${text};\n`,
};

/** Terms with real superscripts and a true minus sign. */
function readable(terms, variables) {
  const parts = [];
  terms.forEach(([coefficient, exponents], i) => {
    const negative = coefficient.startsWith('-');
    const size = negative ? coefficient.slice(1) : coefficient;
    const constant = exponents.every((e) => e === 0);
    parts.push(negative ? (i ? ' −\u00a0' : '−') : i ? ' +\u00a0' : '');
    if (size !== '1' || constant) parts.push(size, constant ? '' : '\u202f');
    variables.forEach((name, k) => {
      if (exponents[k] > 0) parts.push(element('i', {}, name));
      if (exponents[k] > 1) parts.push(element('sup', {}, String(exponents[k])));
    });
  });
  return parts.length ? parts : ['0'];
}

/** A polynomial with its copy buttons. `identifier` is its name in the copied text. */
function polynomialBox({title, identifier, variables, terms}) {
  const status = element('span', {class: 'note', role: 'status'});
  const buttons = Object.entries(algebraSystems).map(([system, form]) => {
    const button = element('button', {type: 'button', class: 'copy', 'aria-label': `copy ${title} for ${system}`}, system);
    button.addEventListener('click', async () => {
      const copied = await copyText(form(identifier, variables, algebraText(terms, variables)));
      status.textContent = copied ? `copied for ${system}` : 'the browser does not let the page copy';
    });
    return button;
  });
  return element('div', {class: 'polynomial'}, element('div', {class: 'head'}, element('b', {}, title), element('span', {class: 'note screen-only'}, 'copy for'), buttons, status),
    element('div', {class: 'text', tabindex: 0, role: 'group', 'aria-label': title}, readable(terms, variables), ' = 0'));
}

function affineTerms({normal, constant}) {
  return [[normal[0], [1, 0, 0]], [normal[1], [0, 1, 0]], [normal[2], [0, 0, 1]], [constant, [0, 0, 0]]].filter(([c]) => c !== '0');
}

/** Plane, cylinder or second plane, and eliminant of a line. */
function linePolynomials(line) {
  const space = ['x', 'y', 'z'];
  const list = [];
  if (line.plane) list.push({title: 'plane of the line', identifier: 'P', variables: space, terms: affineTerms(line.plane)});
  if (line.second_plane) list.push({title: 'second plane', identifier: 'Q', variables: space, terms: affineTerms(line.second_plane)});
  if (line.cylinder) list.push({title: 'quadratic cylinder', identifier: 'Z', variables: space, terms: line.cylinder.terms});
  const {variable, degree, coefficients} = line.eliminant;
  if (coefficients && coefficients.length)
    list.push({title: `eliminant, degree ${degree}`, identifier: 'R', variables: [variable],
      terms: coefficients.map((c, i) => [c, [i]]).filter(([c]) => c !== '0').reverse()});
  return list.map(polynomialBox);
}
