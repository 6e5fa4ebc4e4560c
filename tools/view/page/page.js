// The page: what is shown, its panels and its buttons.
'use strict';

const $ = (id) => document.getElementById(id);

const state = {
  scene: null,           // as /api/scene describes it
  camera: null,
  depth: 5,
  panes: [],             // [{grid, channel, cells}]: one, or two that are compared
  plane: null,           // grids whose slices are shown instead of pictures
  slice: {axis: 2, share: 0.5, depth: null}, // depth: of cells and boxes that are shown, null for all
  guess: false,          // hide what a ray costs until it has been guessed
  cost: [1, 1],          // of a test, and of a step
  pointer: null,         // over a picture: shares of it
  picking: null,         // the cross hair: {pane, x, y}, shares of the picture
};
let slicePanel = null, walkPanel = null, planeView = null, colors = null, listColors = null, scales = null, source = null;

const fragment = () => writeAddress(state.scene, state, scales.kind, walkPanel || {}, planeView?.zoom);
let addressTimer = 0;
function rememberSoon() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    if (location.hash !== fragment()) history.replaceState(null, '', fragment());
  }, 250);
}

// A grid's name without the ending, where that's enough to tell grids apart; may break at underlines.
function shortName(index) {
  const {name, division} = state.scene.grids[index];
  return division ? `${division}³` : name.replace(/\.grid$/, '').replaceAll('_', '_\u200b');
}

// After any change of `state`.
function update() {
  showPanes();
  for (const pane of panes) pane.update();
  showView();
  showFigures();
  showCost();
  showSlice();
  showWalk();
  rememberSoon();
}

// Each once.
const shownGrids = () => [...new Set(state.plane || state.panes.map((pane) => pane.grid))];

function showSlice() {
  const shown = shownGrids(), had = slicePanel.hasSlices || slicePanel.hasBoxes;
  slicePanel.hasSlices = state.plane || state.panes.some((pane) => pane.cells === 'slice' || pane.channel === 'cut');
  slicePanel.hasBoxes = !state.plane && state.panes.some((pane) => pane.cells === 'boxes');
  if (!had && (slicePanel.hasSlices || slicePanel.hasBoxes)) $('slice-panel').open = true; // there are the sliders
  slicePanel.show(shown, shown.map(shortName), shown.map((grid) => state.scene.grids[grid]));
  drawOverlays();
}

function showWalk() {
  if (!state.plane) walkPanel.followAgain({depth: state.depth});
  const grids = state.plane || state.panes.map((pane) => pane.grid);
  walkPanel.show(grids, grids.map(shortName), grids.map((grid) => state.scene.grids[grid]));
}

function drawOverlays() {
  for (const pane of panes) {
    pane.drawOverlay();
    pane.showValue();
    if (pane.isCut && pane.frame) pane.showScale();
  }
  planeView.draw();
  rememberSoon();
}

function setCamera(camera) {
  state.wish = camera; // an exported page has a few views alone
  if (!source.isLive) {
    const old = state.camera;
    camera = source.nearest(camera);
    if (Camera.same(old, camera)) return;
  }
  state.camera = camera;
  for (const pane of panes) pane.update();
  showView();
  rememberSoon();
}

// The walk of the camera ray of the pixel at shares x, y of the picture.
let picking = null;
async function pick(pane, shareX, shareY) {
  const [width, height] = pane.size();
  [shareX, shareY] = source.pixel(shareX, shareY);
  const x = Math.max(0, Math.min(width - 1, Math.floor(shareX * width))), y = Math.max(0, Math.min(height - 1, Math.floor(shareY * height)));
  if (picking) picking.abort();
  const {signal} = picking = new AbortController();
  try {
    const ray = await source.ray({camera: pane.camera(width, height), width, height}, x, y, signal);
    await walkPanel.follow({...ray, all: $('walk-all').checked, depth: state.depth}, {pane: pane.index, pixel: {x, y, width, height}});
    $('walk-panel').open = true;
    const {current} = walkPanel;
    if (signal.aborted) return;
    if (current) announce(`pixel ${x}, ${y}: ${counted(current.cells, visited(walkPanel.structures[walkPanel.pane]))}, ${counted(current.tests, 'test')}`);
    else walkPanel.focusGuess();
  } catch (error) {
    if (error.name !== 'AbortError') walkPanel.failed(error.message);
  }
}

function toggleCompare() {
  if (state.panes.length > 1) {
    state.panes.length = 1;
  } else {
    const first = state.panes[0];
    state.panes.push({...first, grid: (first.grid + 1) % state.scene.given});
  }
  keepFocus(update);
}

// Of grids that are compared the slices; back in the pictures their walk goes on.
let walkOfPictures = {};
function togglePlane() {
  const grids = [...new Set(state.panes.map((pane) => pane.grid))], back = state.plane ? walkOfPictures : {};
  const {ray, pane, index, step, pixel, guesses} = walkPanel;
  walkOfPictures = {ray, look: {pane, index, step, pixel, guesses}};
  state.plane = state.plane ? null : grids.length > 1 ? grids : firstGrids(state.scene);
  keepFocus(() => {
    showPanes();
    walkPanel.clear();
    update();
  });
  if (back.ray) walkPanel.follow(back.ray, back.look);
}

const focusView = () => (state.plane ? planeView.plots[0].canvas : panes[0].stage).focus();
// Where change() takes away the picture or the slice that has it.
function keepFocus(change) {
  const had = document.activeElement.closest('#pictures, #planes');
  change();
  if (had && document.activeElement === document.body) focusView();
}

function showView() {
  for (const [name, value] of [['angle', Number(state.camera.angle.toPrecision(6))], ['depth', state.depth]]) {
    const input = $(`view-${name}`);
    if (document.activeElement !== input) input.value = value;
  }
}

function changeView() {
  const angle = Number($('view-angle').value), depth = Math.round(Number($('view-depth').value));
  if (depth >= 1 && depth <= 32) state.depth = depth;
  if (angle > 0 && angle < 180) setCamera({...state.camera, angle});
  update();
}

// Weights that make no sense stay as they were.
function changeCost() {
  state.cost = ['a', 'b'].map((name, i) => ($(`cost-${name}`).value !== '' && isWeight($(`cost-${name}`).valueAsNumber) ? $(`cost-${name}`).valueAsNumber : state.cost[i]));
  walkPanel.draw();
  showCost();
}

function setGuess(guess) {
  state.guess = $('guess').checked = guess;
  walkPanel.draw({guesses: null});
  announce(`guess first: ${guess ? 'on' : 'off'}`);
}

let costFrame = 0;
function showCost() {
  if (costFrame) return;
  costFrame = requestAnimationFrame(() => {
    costFrame = 0;
    if (panes.length === 0) return; // the plane, by now
    const shown = panes.map((pane) => ({name: shortName(pane.settings.grid), frame: pane.of(pane.frame),
      counts: pane.of(pane.counts), grid: state.scene.grids[pane.settings.grid]}));
    const isOpen = $('cost').querySelector('details')?.open;
    $('cost').replaceChildren(...costTable(shown, state.cost));
    $('cost').querySelector('details').open = isOpen;
  });
}

async function showFigures() {
  const shown = shownGrids();
  const names = shown.map(shortName);
  try {
    const all = await Promise.all(shown.map((grid) => source.statistics(grid)));
    if (String(shown) !== String(shownGrids())) return; // others by now
    $('statistics').replaceChildren(element('div', {class: 'scroll wide', tabindex: 0, role: 'group', 'aria-label': 'Statistics of the grids that are shown'}, statisticsTable(names, all)));
    $('histogram').replaceChildren(histogramChart(names, all));
  } catch (error) {
    $('statistics').replaceChildren(element('p', {class: 'note'}, error.message));
  }
}

let announcementTimer = 0;
function announce(text) {
  $('announcement').textContent = text;
  clearTimeout(announcementTimer);
  announcementTimer = setTimeout(() => { $('announcement').textContent = ''; }, 2500);
}

async function copy(text, what) {
  try {
    await navigator.clipboard.writeText(text);
    announce(`${what} copied`);
  } catch { // without permission, and where the page isn't on localhost
    window.prompt(`${what}: copy it from here`, text);
  }
}

const quoted = (word) => (/^[\w@%+=:,.\/-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`);

// The commands that make the pictures; of a channel its values, and gridrender's own picture of them; of a cut the slice.
// Before them what writes the files that were made in memory.
const command = () => [...new Set(panes.flatMap((pane) => [state.scene.scene, state.scene.grids[pane.settings.grid]]
  .flatMap(({made_by}) => made_by.map((words) => words.map(quoted).join(' '))))),
  ...panes.map((pane) => commandOf(pane, pane.index > 0 ? '-2' : ''))].join(' && ');
function commandOf(pane, suffix) {
  const {scene, grids, precision} = state.scene;
  if (pane.isCut)
    return `gridstat ${quoted(grids[pane.settings.grid].path)} --slice ${'xyz'[state.slice.axis]}=${100 * state.slice.share}% --outline ${quoted(scene.path)} --lines -o slice${suffix}.png`;
  const [width, height] = pane.size();
  const {from, at, up, angle} = pane.camera(width, height);
  return ['gridrender', quoted(scene.path), quoted(grids[pane.settings.grid].path), `-o picture${suffix}.png`,
    `--size ${width}x${height}`, `--from=${from.join()}`, `--at=${at.join()}`, `--up=${up.join()}`, `--angle ${angle}`,
    ...(pane.settings.channel === 'shaded' ? [] : [`--channels ${pane.settings.channel.replace('all ', '')}`,
      ...(pane.settings.channel.startsWith('all ') ? ['--all-rays'] : []), '--no-picture', '--sampling centers']),
    ...(state.depth === 5 ? [] : [`--depth ${state.depth}`]),
    ...(precision === 'auto' ? [] : [`--precision ${precision}`])].join(' ');
}

function openAddress() {
  const {state: {slice, ...read}, scale, walk, zoom, missing} = readAddress(state.scene, location.hash || source.opensWith);
  Object.assign(state, read);
  Object.assign(state.slice, slice, source.sliceAt(slice)); // the slice panel's, too
  for (const pane of panes) pane.counts = null; // of another view, perhaps
  planeView.zoom = zoom;
  walkOfPictures = {};
  $('missing').hidden = missing.length === 0;
  $('missing').textContent = `The link names ${missing.join(' and ')}, which isn’t loaded here. Shown: ${shownGrids().map((grid) => state.scene.grids[grid].name).join(', ')} of ${state.scene.scene.name}.`;
  if (!source.isLive) state.camera = source.nearest(state.camera);
  state.wish = state.camera;
  scales.kind = scale;
  $('guess').checked = state.guess;
  [$('cost-a').value, $('cost-b').value] = state.cost;
  showPanes();
  walkPanel.clear();
  update();
  if (!walk) return;
  $('walk-all').checked = walk.ray.all;
  walkPanel.follow(source.known(walk.ray), walk.look);
}

async function begin() {
  source = typeof EXPORTED === 'undefined' ? new Server((is) => { $('lost').hidden = !is; }) : await Exported.from(EXPORTED);
  document.body.classList.toggle('exported', !source.isLive);
  state.scene = await source.scene();
  state.scene.channels = state.scene.channels.filter((channel) => source.isLive || channel !== 'cut');
  colors = new ColorScale(state.scene.colors);
  listColors = new ColorScale(state.scene.list_colors).reversed(); // light is few
  scales = new Scales(colors);
  const {scene, device, version} = state.scene;
  document.title = `${scene.name} – gridview`;
  $('scene-name').textContent = scene.name;
  $('scene-facts').textContent = `${Text.count(scene.primitives)} primitives · ${Text.bytes(scene.bytes)} · ${device} · Masu ${version}`;
  slicePanel = new SlicePanel($('slice'), source, state.slice, () => panes.filter((pane) => pane.isCut).forEach((pane) => pane.update()), drawOverlays);
  walkPanel = new WalkPanel($('walk'), source, state, () => planeView && drawOverlays(), (point) => setCamera(Camera.centered(state.camera, point)));
  planeView = new PlaneView($('planes'), state.scene, source, listColors, slicePanel, walkPanel, (index, grid) => {
    state.plane = state.plane.map((one, i) => (i === index ? grid : one));
    $('missing').hidden = true;
    update();
  }, rememberSoon);
  $('walk-all').addEventListener('change', () => walkPanel.followAgain({all: $('walk-all').checked}));
  openAddress();
  $('guess').addEventListener('change', () => setGuess($('guess').checked));
  for (const name of ['cost-a', 'cost-b']) $(name).addEventListener('input', changeCost);
  $('view-panel').addEventListener('change', changeView);
  const buttons = {skip: focusView, compare: toggleCompare, plane: togglePlane, keys: toggleKeys,
    reset: () => setCamera(ownCamera(state.scene)),
    'copy-link': () => copy(location.href.split('#')[0] + fragment(), 'Link'),
    'copy-command': () => copy(command(), panes.length > 1 ? 'Commands' : 'Command')};
  for (const [id, press] of Object.entries(buttons)) $(id).addEventListener('click', press);
  document.addEventListener('keydown', keyOfPage);
  window.addEventListener('hashchange', openAddress);
}

begin().catch((error) => {
  document.querySelector('main').replaceChildren(element('p', {role: 'alert', class: 'note'}, `gridview: ${error.message}`));
});
