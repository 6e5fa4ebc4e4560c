// The address: what the page shows as the fragment of a link, and back.
'use strict';

const ownCamera = ({camera: {from, at, up, angle}}) => ({from, at, up, angle});

// A grid in a link: by its name, or by its hash where another one has that name, too.
function gridKey(scene, grid) {
  const isPlain = !grid.name.includes(',') && scene.grids.filter((one) => one.name === grid.name).length === 1;
  return isPlain || grid.division ? grid.name : grid.hash;
}

// count of them, all finite; null for anything else.
function readNumbers(text, count) {
  const words = (text || '').split(',');
  const numbers = words.map(Number);
  return numbers.length === count && words.every((word) => word.trim()) && numbers.every(Number.isFinite) ? numbers : null;
}

// scene: as /api/scene describes it; then the page's `state`, the kind of the scales, of the WalkPanel {ray, pane, index,
// step}, and the plane's zoom.
function writeAddress(scene, {camera, depth, panes, plane, slice, guess, cost}, scale, walk, zoom) {
  const parts = new URLSearchParams(), own = ownCamera(scene);
  for (const part of ['from', 'at', 'up', 'angle']) {
    if (String(camera[part]) !== String(own[part])) parts.set(part, String(camera[part]));
  }
  if (depth !== 5) parts.set('depth', depth);
  parts.set('grid', (plane || panes.map((pane) => pane.grid)).map((grid) => gridKey(scene, scene.grids[grid])).join());
  if (plane) parts.set('view', 'plane');
  else parts.set('channel', panes.map((pane) => pane.channel).join());
  if (!plane && panes.some((pane) => pane.cells !== 'none')) parts.set('cells', panes.map((pane) => pane.cells).join());
  if (scale !== 'automatic') parts.set('scale', scale);
  const {axis, share, depth: level} = slice;
  if (axis !== 2 || share !== 0.5 || level !== null) parts.set('slice', ['xyz'[axis], share, ...(level === null ? [] : [level])].join());
  if (plane && zoom?.axis === axis) parts.set('zoom', [zoom.u, zoom.v, zoom.scale].join());
  if (guess) parts.set('guess', 1);
  if (String(cost) !== '1,1') parts.set('cost', cost.join());
  if (walk.ray) {
    const {ray, pane, index, step} = walk;
    parts.set('ray', [...ray.origin, ...ray.direction].join());
    if (ray.precision) parts.set('precision', ray.precision);
    if (ray.all) parts.set('all', 1);
    parts.set('walk', [pane, index, ...(step === null ? [] : [step])].join());
  }
  return '#' + parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/');
}

// Whatever of it makes sense: {state, scale, walk, zoom, missing}; walk: {ray, look} of WalkPanel.follow(), or null;
// missing: names of grids that aren't loaded.
function readAddress(scene, text) {
  const parts = new URLSearchParams(text.slice(1)), list = (name) => (parts.get(name) || '').split(',');
  const oneOf = (all, name, usual) => all.includes(name) ? name : usual;
  const camera = ownCamera(scene);
  for (const part of ['from', 'at', 'up']) camera[part] = readNumbers(parts.get(part), 3) || camera[part];
  const angle = Number(parts.get('angle')), number = Number(parts.get('depth'));
  if (angle > 0 && angle < 180) camera.angle = angle;
  const isCamera = Vec.length(Vec.cross(Vec.sub(camera.at, camera.from), camera.up)) > 0;
  const depth = number >= 1 && number <= 32 ? Math.round(number) : 5;
  const [axis, share, level] = list('slice');
  const isSlice = ['x', 'y', 'z'].includes(axis) && share >= 0 && share <= 1;
  const slice = {...(isSlice ? {axis: 'xyz'.indexOf(axis), share: Number(share)} : {axis: 2, share: 0.5}),
    depth: isSlice && /^\d{1,2}$/.test(level) ? Number(level) : null};
  const channels = list('channel'), cells = list('cells'), keys = scene.grids.map((grid) => gridKey(scene, grid));
  const named = list('grid').map((name, i) => (
    {grid: keys.indexOf(name), channel: oneOf(scene.channels, channels[i], 'shaded'), cells: oneOf(CELLS, cells[i], 'none')}));
  const isPlane = parts.get('view') === 'plane', isKnown = ({grid}) => grid >= 0 && (isPlane || grid < scene.pictured);
  const known = named.filter(isKnown), missing = list('grid').filter((name, i) => name && !isKnown(named[i]));
  const plane = !isPlane ? null : known.length > 0 ? known.slice(0, MOST_SLICES).map(({grid}) => grid) : firstGrids(scene);
  const pictured = known.filter(({grid}) => grid < scene.pictured);
  const panes = (pictured.length > 0 ? pictured : [{...named[0], grid: 0}]).slice(0, plane ? 1 : 2);
  const [u, v, times] = readNumbers(parts.get('zoom'), 3) || [], zoom = times > 1 && times <= 1e4 ? {u, v, scale: times, axis: slice.axis} : null;
  const ray = readNumbers(parts.get('ray'), 6), precision = oneOf(['fast', 'robust', 'double'], parts.get('precision'), null);
  const [pane = 0, index = 0, step = null] = list('walk').map((word) => /^\d{1,9}$/.test(word) ? Number(word) : undefined);
  const walk = ray && ray.slice(3).some((part) => part !== 0) ? {
    ray: {origin: ray.slice(0, 3), direction: ray.slice(3), ...(precision ? {precision} : {}), all: parts.get('all') === '1', depth},
    look: {pane: Math.min(pane, (plane || panes).length - 1), index, step}} : null;
  const weights = readNumbers(parts.get('cost'), 2), cost = weights?.every(isWeight) ? weights : [1, 1];
  return {state: {camera: isCamera ? camera : ownCamera(scene), depth, panes, plane, slice, guess: parts.get('guess') === '1', cost},
    scale: oneOf(['linear', 'logarithmic'], parts.get('scale'), 'automatic'), walk, zoom, missing};
}
