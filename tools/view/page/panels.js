// The panels beside the picture: costs, statistics, histogram, slice, walk.
'use strict';

// element('td', {class: 'x', onclick: f}, 'text', child…)
function element(name, attributes = {}, ...children) {
  const isDrawing = ['svg', 'rect', 'line', 'text', 'g', 'title', 'path'].includes(name);
  const made = isDrawing ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') made.addEventListener(key.slice(2), value);
    else made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// --- Numbers as text -----------------------------------------------------------------------------------------

const Text = {
  count(value) {
    if (value === null || value === undefined) return '–';
    return Math.round(value).toLocaleString('en-US').replaceAll(',', '\u2009');
  },
  // Three or four digits.
  number(value) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    if (size === 0) return '0';
    if (size >= 1e7 || size < 1e-3) return value.toExponential(2);
    if (size >= 1000) return Text.count(value);
    return value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
  },
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
  division: (value) => value.map(Text.count).join(' × '),
};

const counted = (count, what) => `${Text.count(count)} ${what}${count === 1 ? '' : 's'}`;

// --- Tables --------------------------------------------------------------------------------------------------

// rows: [name, values, {text, less}] or [heading]. A column a name; where `less`, the smallest of several values
// is marked.
function table(names, rows, caption) {
  const body = element('tbody');
  for (const [name, values, {text = String, less = false, title = null} = {}] of rows) {
    if (!values) {
      body.append(element('tr', {class: 'head'}, element('th', {scope: 'rowgroup', colspan: names.length + 1}, name)));
      continue;
    }
    const numbers = values.filter((value) => Number.isFinite(value));
    const best = less && numbers.length > 1 && Math.min(...numbers) < Math.max(...numbers) ? Math.min(...numbers) : null;
    body.append(element('tr', {}, element('th', {scope: 'row', title}, name), ...values.map((value) =>
      element('td', {class: value === best && best !== null ? 'better' : null}, text(value)))));
  }
  return element('table', {'aria-label': caption}, element('thead', {}, element('tr', {}, element('td'),
    ...names.map((name) => element('th', {scope: 'col'}, name)))), body);
}

// --- Cost of a view ------------------------------------------------------------------------------------------

// shown: [{name, frame, counts, grid}] a picture each; frame as Picture reports it, counts as gridrender --stats.
function costTable(shown) {
  const column = (get) => shown.map((one) => {
    try {
      return get(one);
    } catch {
      return null; // not known yet
    }
  });
  const rays = (c) => c.eye_rays + c.shadow_rays + c.reflection_rays + c.refraction_rays;
  const tests = (c) => Object.values(c.intersection_tests).reduce((a, b) => a + b, 0);
  const time = {text: Text.milliseconds};
  const perRay = {text: Text.number, less: true};
  const areSharp = shown.every((one) => one.frame && one.frame.isSharp && one.frame.view.channel === shown[0].frame.view.channel);
  return table(shown.map((one) => one.name), [
    ['picture', column((one) => `${one.frame.view.width} × ${one.frame.view.height}`), {text: (t) => t || '–'}],
    ['trace', column((one) => one.frame.milliseconds.trace), {text: Text.milliseconds, less: areSharp}],
    ['camera rays', column((one) => one.frame.rays / one.frame.milliseconds.trace / 1e3), {text: (v) => `${Text.number(v)} M/s`, title: 'Camera rays a second, with all rays that they spawn'}],
    ['copy from device', column((one) => one.frame.milliseconds.copy), time],
    ['rows, JPEG', column((one) => one.frame.milliseconds.rows + one.frame.milliseconds.encode), time],
    ['until shown', column((one) => one.frame.milliseconds.total), time],
    ['All rays of the picture'],
    ['cells a ray', column((one) => one.counts.cells_visited / rays(one.counts)), perRay],
    ['empty cells a ray', column((one) => one.counts.empty_cells_visited / rays(one.counts)), perRay],
    ['tests a ray', column((one) => tests(one.counts) / rays(one.counts)), perRay],
    ['voxels skipped a ray', column((one) => one.counts.voxels_skipped / rays(one.counts)), {text: Text.number}],
    ['shadow rays a camera ray', column((one) => one.counts.shadow_rays / one.counts.eye_rays), {text: Text.number}],
    ['reflected, refracted', column((one) => (one.counts.reflection_rays + one.counts.refraction_rays) / one.counts.eye_rays), {text: Text.number, title: 'Reflection and refraction rays a camera ray'}],
    ['Grid'],
    ['file', column((one) => one.grid.bytes), {text: Text.bytes, less: true}],
  ], 'Cost of this view by grid');
}

// --- Statistics of grids -------------------------------------------------------------------------------------

// As gridstat prints them; a column a grid.
function statisticsTable(names, all) {
  const column = (get) => all.map(get);
  const count = {text: Text.count}, number = {text: Text.number};
  return table(names, [
    ['merge', column((s) => s.merge), {}],
    ['division', column((s) => Text.division(s.division)), {}],
    ['smallest voxels', column((s) => Text.division(s.smallest_division)), {}],
    ['overlap test', column((s) => s.overlap), {}],
    ['occupied voxels', column((s) => s.occupancy_percent), {text: Text.percent}],
    ['cells', column((s) => s.cells), count],
    ['occupied cells', column((s) => s.occupied_cells), count],
    ['expanded cells', column((s) => s.expanded_cells), count],
    ['references', column((s) => s.references), count],
    ['References per occupied cell'],
    ['mean', column((s) => s.references_per_occupied_cell.mean), number],
    ['standard deviation', column((s) => s.references_per_occupied_cell.stddev), number],
    ['median', column((s) => s.references_per_occupied_cell.median), number],
    ['99 %', column((s) => s.references_per_occupied_cell.p99), count],
    ['most', column((s) => s.references_per_occupied_cell.max), count],
    ['Expected for a random line'],
    ['cells', column((s) => s.expected_per_ray.cells), {text: Text.number, less: true}],
    ['tests', column((s) => s.expected_per_ray.tests), {text: Text.number, less: true}],
    ['voxels skipped', column((s) => s.expected_per_ray.voxels_skipped), number],
    ['Memory'],
    ['file', column((s) => s.bytes.file), {text: Text.bytes, less: true}],
    ['voxel map', column((s) => s.bytes.voxel_map), {text: Text.bytes}],
    ['cells', column((s) => s.bytes.cells), {text: Text.bytes}],
    ['references', column((s) => s.bytes.references), {text: Text.bytes}],
    ['map loads a point', column((s) => s.map.mean_loads), number],
    ['build', column((s) => s.build_seconds), {text: Text.seconds}],
  ], 'Statistics of the grids');
}

// --- Histogram -----------------------------------------------------------------------------------------------

// Cells by their number of references: bins 1, 2, 3, 4, 5-6, 7-8, … with equal widths on a logarithmic axis.
function binned(histogram) {
  const bins = new Map();
  for (const [references, cells] of histogram || []) {
    const bin = references <= 4 ? references - 1 : Math.floor(4 * Math.log2(references)) - 4;
    bins.set(bin, (bins.get(bin) || 0) + cells);
  }
  return bins;
}
function binBegin(bin) {
  return bin < 4 ? bin + 1 : Math.ceil(2 ** ((bin + 4) / 4));
}

// Shares of the occupied cells, for one grid or two.
function histogramChart(names, all) {
  const shares = all.map((s) => {
    const bins = binned(s.histogram);
    const sum = [...bins.values()].reduce((a, b) => a + b, 0) || 1;
    return new Map([...bins].map(([bin, cells]) => [bin, {share: cells / sum, cells}]));
  });
  const last = Math.max(4, ...shares.flatMap((bins) => [...bins.keys()]));
  const most = Math.max(1e-9, ...shares.flatMap((bins) => [...bins.values()].map((value) => value.share)));
  const width = 350, height = 130, left = 34, bottom = 16;
  const chart = element('svg', {class: 'chart', viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': `Occupied cells by number of references: ${names.map((name, i) => `${name}: mean ${Text.number(all[i].references_per_occupied_cell.mean)}, most ${all[i].references_per_occupied_cell.max}`).join('; ')}`});
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
      chart.append(element('rect', {class: 'ab'[i % 2], x: x + i * bar, y: height - bottom - tall, width: Math.max(0.6, bar - 0.3), height: tall},
        element('title', {}, `${names[i]}: ${Text.count(value.cells)} cells with ${binBegin(bin)}${end > binBegin(bin) ? '–' + end : ''} references`)));
    });
  }
  const keys = element('p', {class: 'note'}, ...names.flatMap((name, i) => [element('span', {class: i % 2 ? 'key b' : 'key'}, name), ' ']));
  return element('div', {}, chart, names.length > 1 ? keys : null,
                 element('p', {class: 'note'}, 'Share of occupied cells by the number of primitives that they list.'));
}
