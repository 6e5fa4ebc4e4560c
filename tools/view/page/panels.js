// The panels beside the picture: costs, statistics, histogram, slice, walk.
'use strict';

// element('td', {class: 'x', style: {color: 'red'}, onclick: f}, 'text', child…)
function element(name, attributes = {}, ...children) {
  const isDrawing = ['svg', 'rect', 'line', 'text', 'g', 'title', 'path'].includes(name);
  const made = isDrawing ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') made.addEventListener(key.slice(2), value);
    else if (key === 'style') Object.entries(value).forEach((part) => made.style.setProperty(...part));
    else made.setAttribute(key, value === true && !key.startsWith('aria-') ? '' : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// --- Numbers as text -----------------------------------------------------------------------------------------

const Text = {
  count: (value) => (value === null || value === undefined ? '–'
    : Math.round(value).toLocaleString('en-US').replaceAll(',', '\u2009')),
  // Three or four digits.
  number(value) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    if (size === 0) return '0';
    if (size >= 1e7 || size < 1e-3) return value.toExponential(2);
    if (size >= 1000) return Text.count(value);
    return value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
  },
  // Of weighted counts.
  cost: (value) => (Number.isInteger(value) ? Text.count(value) : Text.number(value)),
  // 0 where it is nothing beside the extent of all places.
  place: (value, extent) => Text.number(Math.abs(value) < 1e-4 * extent ? 0 : value),
  // Two digits.
  times: (value) => (value >= 9.95 ? Text.count(value) : value.toFixed(value >= 1.95 ? 1 : 2)),
  bytes(value) {
    if (value === null || value === undefined) return '–';
    const units = ['B', 'kB', 'MB', 'GB', 'TB'];
    let unit = 0;
    while (value >= 1000 && unit + 1 < units.length) { value /= 1000; unit += 1; }
    return `${unit === 0 ? value : Text.number(value)} ${units[unit]}`;
  },
  milliseconds: (value) => Number.isFinite(value) ? `${Text.number(value)} ms` : '–',
  seconds: (value) => (value === null || value === undefined ? '–' : value < 1 ? Text.milliseconds(value * 1e3) : `${Text.number(value)} s`),
  percent: (value) => `${Text.number(value)} %`,
  vector: (value) => value.map((x) => Number(x.toPrecision(6))).join(', '),
  division: (value) => value.map(Text.count).join('\u2009×\u2009'),
};

const counted = (count, what) => `${Text.count(count)} ${what}${count === 1 ? '' : 's'}`;

// --- Tables --------------------------------------------------------------------------------------------------

// What rays visit in structures of scene.grids: cells of grids, nodes of hierarchies.
const visited = (grid) => grid.structure === 'bvh' ? 'node' : 'cell';
const visitedNames = (grids) => [...new Set(grids.map((grid) => `${visited(grid)}s`))].join(', ');

// What a ray costs: a · tests + b · steps, of cost [a, b]. A step is a cell, or each of the eight boxes that a node tests,
// so that grids and hierarchies compare.
const BOXES_PER_NODE = 8;
const COST_TITLE = 'a · tests + b · steps: a step is a cell, or each of the eight boxes of a node';
const isWeight = (weight) => weight >= 0 && weight <= 1e6;
const stepsOf = (grid, visits) => visits * (grid.structure === 'bvh' ? BOXES_PER_NODE : 1);
const costOf = ([a, b], grid, visits, tests) => a * tests + b * stepsOf(grid, visits);

// A value of each; null where it isn't known, or where a structure has none.
function column(all, get) {
  return all.map((one) => {
    try {
      return get(one) ?? null;
    } catch {
      return null;
    }
  });
}

// rows: [name, values, {text, less}], left out where there are none, or [heading]. A column a name; where `less` is a
// word, the smallest of several values is marked, and of two the last column says how many times it is less: 8 × fewer.
function table(names, rows, caption) {
  const body = element('tbody'), shown = rows.filter(([, values]) => !values || values.some((value) => value !== null));
  for (const [i, [name, values, {text = String, less = null, title = null} = {}]] of shown.entries()) {
    if (!values && !shown[i + 1]?.[1]) continue; // a heading of none
    if (!values) {
      body.append(element('tr', {class: 'head'}, element('th', {scope: 'rowgroup', colspan: names.length + (names.length === 2 ? 2 : 1)}, name)));
      continue;
    }
    const numbers = values.filter((value) => Number.isFinite(value));
    const least = Math.min(...numbers);
    const best = less && numbers.length > 1 && Math.max(...numbers) >= 1.005 * least && least < Math.max(...numbers) ? least : null;
    body.append(element('tr', {}, element('th', {scope: 'row', title}, name), ...values.map((value) =>
      element('td', {class: value === best && best !== null ? 'better' : null}, value === null ? '–' : text(value))),
      ...(names.length === 2 ? [element('td', {class: 'ratio'}, best > 0 ? `${Text.times(Math.max(...numbers) / best)} × ${less}` : '')] : [])));
  }
  return element('table', {'aria-label': caption, class: names.length > 3 ? 'many' : null}, element('thead', {}, element('tr', {}, element('td'),
    ...names.map((name) => element('th', {scope: 'col'}, name)), names.length === 2 ? element('td') : null)), body);
}

// --- Cost of a view ------------------------------------------------------------------------------------------

const EXPLAINED = {
  cells: 'Steps of a ray: cells of a grid or nodes of a hierarchy, one after the other',
  empty: 'Cells in which nothing is listed: steps without a test',
  tests: 'Intersections of a ray with one primitive',
  idle: 'Lanes of a GPU’s warp whose rays have ended while its others go on, on average: shown with the channel idle',
  skipped: 'Smallest voxels that the ray passes without a step of their own',
};

// shown: [{name, frame, counts, grid}] a picture each; frame as Picture reports it, counts as gridrender --stats; cost: [a, b].
function costTable(shown, cost) {
  const of = (get) => column(shown, get);
  const rays = (c) => c.eye_rays + c.shadow_rays + c.reflection_rays + c.refraction_rays;
  const tests = (c) => Object.values(c.intersection_tests).reduce((a, b) => a + b, 0);
  const time = {text: Text.milliseconds};
  const perRay = (title) => ({text: Text.number, less: 'fewer', title});
  const cells = visitedNames(shown.map((one) => one.grid));
  const ofCells = (get) => of((one) => visited(one.grid) === 'cell' ? get(one.counts) : null);
  const size = shown[0].counts && shown[0].counts.size; // of a smaller picture of the view
  const areSharp = shown.every((one) => one.frame && one.frame.isSharp && one.frame.view.channel === shown[0].frame.view.channel);
  const costs = table(shown.map((one) => one.name), [
    ['picture', of((one) => `${one.frame.view.width} × ${one.frame.view.height}`), {}],
    ['trace', of((one) => one.frame.milliseconds.trace), {text: Text.milliseconds, less: areSharp ? 'faster' : null}],
    ['camera rays', of((one) => one.frame.rays / one.frame.milliseconds.trace / 1e3), {text: (v) => `${Text.number(v)} M/s`, title: 'Camera rays a second, with all rays that they spawn'}],
    ['copy from device', of((one) => one.frame.milliseconds.copy || null), time],
    ['rows, encoding', of((one) => one.frame.milliseconds.rows + one.frame.milliseconds.encode), time],
    ['until shown', of((one) => one.frame.milliseconds.total), {...time, title: 'From the request to the picture on the page, without the time that it waited for its turn'}],
    ['idle lanes, of 32', of((one) => 32 - one.frame.milliseconds.busy_lanes / one.frame.milliseconds.turns || null), {text: Text.number, less: 'fewer', title: EXPLAINED.idle}],
    [`All rays${size ? `, of ${size.join(' × ')} pixels` : ''}`],
    [`${cells} per ray`, of((one) => one.counts.cells_visited / rays(one.counts)), perRay(EXPLAINED.cells)],
    ['empty cells', ofCells((c) => c.empty_cells_visited / rays(c)), perRay(EXPLAINED.empty)],
    ['tests per ray', of((one) => tests(one.counts) / rays(one.counts)), perRay(EXPLAINED.tests)],
    ['cost per ray', of(({grid, counts: c}) => costOf(cost, grid, c.cells_visited / rays(c), tests(c) / rays(c))), {text: Text.number, less: 'less', title: COST_TITLE}],
    ['voxels skipped', ofCells((c) => c.voxels_skipped / rays(c)), {text: Text.number, title: `${EXPLAINED.skipped}, per ray`}],
    ['shadow rays', of((one) => one.counts.shadow_rays / one.counts.eye_rays), {text: Text.number, title: 'Shadow rays per camera ray'}],
    ['reflected, refracted', of((one) => (one.counts.reflection_rays + one.counts.refraction_rays) / one.counts.eye_rays), {text: Text.number, title: 'Reflection and refraction rays per camera ray'}],
    ['File'],
    ['file', of((one) => one.grid.bytes), {text: Text.bytes, less: 'smaller'}],
  ], 'Cost of this view by grid');
  const explained = element('details', {class: 'note'}, element('summary', {}, 'What the rows are'), element('p', {},
    `Cells or nodes per ray: ${EXPLAINED.cells.toLowerCase()}. Empty cells: ${EXPLAINED.empty.slice(6).toLowerCase()}. ` +
    `Tests: ${EXPLAINED.tests.toLowerCase()}. Voxels skipped: ${EXPLAINED.skipped.toLowerCase()}. ` +
    'Shadow rays look for a light. Trace is the time of the picture; until shown, all from the request on.'));
  return [costs, explained];
}

// --- Statistics of grids and hierarchies ---------------------------------------------------------------------

// As gridstat prints them; a column a structure.
function statisticsTable(names, all) {
  const of = (get) => column(all, get);
  const count = {text: Text.count}, number = {text: Text.number};
  // Of figures that are called as they are shown.
  const rows = (called, figures, how) => called.map((name) => [name, of((s) => figures(s)[name.replace(' ', '_')]), how]);
  return table(names, [
    ['structure', of((s) => s.structure || (s.merge === 'none' ? 'uniform' : s.merge)), {}],
    ['division', of((s) => Text.division(s.division)), {}],
    ['smallest voxels', of((s) => s.smallest_division[0] > s.division[0] ? `${Text.count(s.smallest_division[0] / s.division[0])} × finer` : null), {}],
    ['overlap test', of((s) => s.overlap), {}],
    ['occupied voxels', of((s) => s.occupancy_percent), {text: Text.percent}],
    ...rows(['cells', 'occupied cells', 'expanded cells', 'nodes'], (s) => s, count),
    ['deepest node', of((s) => s.depth - 1 >= 0 ? s.depth - 1 : null), count],
    ['boxes per node', of((s) => s.boxes_a_node), number],
    ['boxes of nodes', of((s) => s.node_boxes), count],
    ['boxes of references', of((s) => s.reference_boxes), count],
    ['references', of((s) => s.references), count],
    ['References per occupied cell or box'],
    ['mean', of((s) => s.references_per_occupied_cell?.mean ?? s.references / s.reference_boxes), number],
    ['standard deviation', of((s) => s.references_per_occupied_cell.stddev), number],
    ['median', of((s) => s.references_per_occupied_cell.median), number],
    ['99 %', of((s) => s.references_per_occupied_cell.p99), count],
    ['most', of((s) => Math.max(...s.histogram.map(([references]) => references))), count],
    ['Expected for a random line'],
    ...rows(['cells', 'nodes', 'tests'], (s) => s.expected_per_ray, {...number, less: 'fewer'}),
    ...rows(['voxels skipped'], (s) => s.expected_per_ray, number),
    ['Memory'],
    ['file', of((s) => s.bytes.file), {text: Text.bytes, less: 'smaller'}],
    ...rows(['voxel map', 'cells', 'nodes', 'references'], (s) => s.bytes, {text: Text.bytes}),
    ['map loads per point', of((s) => s.map.mean_loads), number],
    ['build', of((s) => s.build_seconds), {text: Text.seconds}],
  ], 'Statistics of the grids');
}

// --- Histogram -----------------------------------------------------------------------------------------------

// Cells or boxes by their number of references: bins 1, 2, 3, 4, 5-6, 7-8, … with equal widths on a logarithmic axis.
function binned(histogram) {
  const bins = new Map();
  for (const [references, cells] of histogram || []) {
    const bin = references <= 4 ? references - 1 : Math.floor(4 * Math.log2(references)) - 4;
    bins.set(bin, (bins.get(bin) || 0) + cells);
  }
  const sum = [...bins.values()].reduce((a, b) => a + b, 0) || 1;
  return new Map([...bins].map(([bin, cells]) => [bin, {share: cells / sum, cells}]));
}
const binBegin = (bin) => (bin < 4 ? bin + 1 : Math.ceil(2 ** ((bin + 4) / 4)));

// Shares of the occupied cells or boxes, for up to four grids.
function histogramChart(names, all) {
  const shares = all.map((s) => binned(s.histogram));
  const last = Math.max(4, ...shares.flatMap((bins) => [...bins.keys()]));
  const most = Math.max(1e-9, ...shares.flatMap((bins) => [...bins.values()].map((value) => value.share)));
  const width = 350, height = 130, left = 40, bottom = 16;
  const chart = element('svg', {class: 'chart', viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': `Occupied cells or boxes by number of references: ${names.map((name, i) => `${name}: most ${Math.max(0, ...(all[i].histogram || []).map(([references]) => references))}`).join('; ')}`});
  const step = (width - left) / (last + 1);
  for (const part of [0, 0.5, 1]) {
    const y = 6 + (height - bottom - 6) * (1 - part);
    chart.append(element('line', {x1: left, x2: width, y1: y, y2: y}),
                 element('text', {x: left - 4, y: y + 3, 'text-anchor': 'end'}, `${Text.number(100 * most * part)}%`));
  }
  let labelled = -Infinity;
  for (let bin = 0; bin <= last; ++bin) {
    const x = left + bin * step;
    if (binBegin(bin) < binBegin(bin + 1) && x - labelled > 26) {
      chart.append(element('text', {x: x + step / 2, y: height - 4, 'text-anchor': 'middle'}, String(binBegin(bin))));
      labelled = x;
    }
    shares.forEach((bins, i) => {
      const value = bins.get(bin);
      if (!value) return;
      const bar = (step - 1) / shares.length, tall = Math.max(0.8, (height - bottom - 6) * value.share / most);
      const end = binBegin(bin + 1) - 1;
      chart.append(element('rect', {class: 'abcd'[i], x: x + i * bar, y: height - bottom - tall, width: Math.max(0.6, bar - 0.3), height: tall},
        element('title', {}, `${names[i]}: ${Text.count(value.cells)} with ${binBegin(bin)}${end > binBegin(bin) ? '–' + end : ''} references`)));
    });
  }
  const keys = element('p', {class: 'note'}, ...names.flatMap((name, i) => [element('span', {class: `key ${'abcd'[i]}`}, name), ' ']));
  return element('div', {}, chart, names.length > 1 ? keys : null,
                 element('p', {class: 'note'}, 'Share of occupied cells or boxes by the number of primitives that they list.'));
}
