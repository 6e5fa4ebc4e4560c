// The page: what is shown, and how the mouse, fingers and keys change it.
'use strict';

const $ = (id) => document.getElementById(id);

const state = {
  scene: null,           // as /api/scene describes it
  camera: null,
  depth: 5,
  panes: [],             // [{grid, channel, cells}]: one, or two that are compared
};
const panes = [];        // what is on the page for each of state.panes
let source = null;

// --- What the address holds ----------------------------------------------------------------------------------

function homeCamera() {
  const {from, at, up, angle} = state.scene.camera;
  return {from, at, up, angle};
}

function fragment() {
  const parts = new URLSearchParams();
  const home = homeCamera();
  for (const part of ['from', 'at', 'up', 'angle']) {
    if (String(state.camera[part]) !== String(home[part])) parts.set(part, String(state.camera[part]));
  }
  if (state.depth !== 5) parts.set('depth', state.depth);
  parts.set('grid', state.panes.map((pane) => state.scene.grids[pane.grid].name).join());
  parts.set('channel', state.panes.map((pane) => pane.channel).join());
  return '#' + parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/');
}

// Whatever of it makes sense.
function readFragment() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const camera = homeCamera();
  for (const part of ['from', 'at', 'up']) {
    const numbers = (parts.get(part) || '').split(',').map(Number);
    if (parts.has(part) && numbers.length === 3 && numbers.every(Number.isFinite)) camera[part] = numbers;
  }
  const angle = Number(parts.get('angle'));
  if (angle > 0 && angle < 180) camera.angle = angle;
  const view = Vec.sub(camera.at, camera.from);
  state.camera = Vec.length(Vec.cross(view, camera.up)) > 0 ? camera : homeCamera();
  const depth = Number(parts.get('depth'));
  state.depth = depth >= 1 && depth <= 32 ? Math.round(depth) : 5;
  const grids = (parts.get('grid') || '').split(',').map((name) => state.scene.grids.findIndex((grid) => grid.name === name));
  const channels = (parts.get('channel') || '').split(',');
  const made = grids.filter((grid) => grid >= 0).slice(0, 2).map((grid, i) => ({
    grid, channel: state.scene.channels.includes(channels[i]) ? channels[i] : 'shaded', cells: 'none'}));
  state.panes = made.length > 0 ? made : [{grid: 0, channel: 'shaded', cells: 'none'}];
}

let addressTimer = 0;
function rememberSoon() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    if (location.hash !== fragment()) history.replaceState(null, '', fragment());
  }, 250);
}

// --- Panes ---------------------------------------------------------------------------------------------------

class Pane {
  constructor(index) {
    this.index = index;
    const root = $('picture-template').content.firstElementChild.cloneNode(true);
    this.root = root;
    this.stage = root.querySelector('.stage');
    this.image = root.querySelector('.image');
    this.overlay = root.querySelector('.overlay');
    this.status = root.querySelector('.status');
    this.problem = root.querySelector('.problem');
    this.gridSelect = root.querySelector('.grid');
    this.channelSelect = root.querySelector('.channel');
    this.cellsSelect = root.querySelector('.cells');
    this.frame = null;
    this.counts = null;
    this.picture = new Picture(this.image, source, (frame) => this.drawn(frame), (text) => this.failed(text));
    state.scene.grids.forEach((grid, i) => this.gridSelect.append(element('option', {value: i}, grid.name)));
    for (const channel of state.scene.channels) this.channelSelect.append(element('option', {value: channel}, channel));
    this.gridSelect.addEventListener('change', () => this.set({grid: Number(this.gridSelect.value)}));
    this.channelSelect.addEventListener('change', () => this.set({channel: this.channelSelect.value}));
    this.resized = new ResizeObserver(() => this.update());
    this.resized.observe(this.stage);
    controlCamera(this);
  }

  get settings() { return state.panes[this.index]; }

  set(change) {
    Object.assign(this.settings, change);
    this.counts = null;
    update();
  }

  size() {
    const ratio = window.devicePixelRatio || 1;
    let width = Math.max(16, Math.round(this.stage.clientWidth * ratio));
    let height = Math.max(16, Math.round(this.stage.clientHeight * ratio));
    const scale = Math.min(1, Math.sqrt(4e6 / (width * height)));
    return [Math.round(width * scale), Math.round(height * scale)];
  }

  update() {
    const [width, height] = this.size();
    this.gridSelect.value = this.settings.grid;
    this.channelSelect.value = this.settings.channel;
    this.stage.setAttribute('aria-label', `${state.scene.scene.name} through ${state.scene.grids[this.settings.grid].name}, ${this.settings.channel}. Arrow keys orbit, Enter picks a pixel.`);
    this.picture.show({grid: this.settings.grid, channel: this.settings.channel, camera: state.camera, width, height, depth: state.depth});
  }

  drawn(frame) {
    this.frame = frame;
    const {trace, total} = frame.milliseconds;
    const size = `${Math.round(frame.view.width * frame.scale)} × ${Math.round(frame.view.height * frame.scale)}`;
    const what = frame.isSharp ? 'sharp' : frame.share < 1 ? `${Math.round(100 * frame.share)} %` : 'moving';
    this.status.textContent = `${size} · trace ${Text.milliseconds(trace)} · shown after ${Text.milliseconds(total)} · ${what}`;
    this.root.dataset.state = frame.isSharp ? 'sharp' : 'moving';
    if (frame.isSharp) this.count(frame.view);
    showCost();
  }

  // Ray counts of a smaller picture of the same view.
  async count(view) {
    if (!source.isLive) return;
    const scale = Math.min(1, Math.sqrt(60000 / (view.width * view.height)));
    const small = {...view, width: Math.max(1, Math.round(view.width * scale)), height: Math.max(1, Math.round(view.height * scale))};
    if (this.counting) this.counting.abort();
    this.counting = new AbortController();
    try {
      this.counts = await source.counts(small, this.counting.signal);
      showCost();
    } catch (error) {
      if (error.name !== 'AbortError') this.failed(error.message);
    }
  }

  failed(text) {
    this.problem.textContent = text;
    this.problem.hidden = text === '';
  }

  close() {
    this.picture.close();
    if (this.counting) this.counting.abort();
    this.resized.disconnect();
    this.root.remove();
  }
}

function showPanes() {
  while (panes.length > state.panes.length) panes.pop().close();
  while (panes.length < state.panes.length) {
    const pane = new Pane(panes.length);
    panes.push(pane);
    $('pictures').append(pane.root);
  }
  $('compare').setAttribute('aria-pressed', String(panes.length > 1));
}

// After any change of `state`.
function update() {
  showPanes();
  for (const pane of panes) pane.update();
  showView();
  showFigures();
  rememberSoon();
}

function setCamera(camera) {
  state.camera = camera;
  for (const pane of panes) {
    if (pane.counting) pane.counting.abort();
    pane.update();
  }
  showView();
  rememberSoon();
}

// --- Mouse, fingers, keys ------------------------------------------------------------------------------------

const ORBIT = 2.6;     // radians for a drag over the picture's height
const KEY_ORBIT = 0.05, KEY_PAN = 0.03, KEY_ZOOM = 1.08;

function controlCamera(pane) {
  const {stage} = pane;
  const pointers = new Map(); // id to {x, y}
  let moved = 0, button = 0;

  stage.addEventListener('pointerdown', (event) => {
    if (event.button > 2) return;
    stage.focus({preventScroll: true});
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    moved = pointers.size > 1 ? 100 : 0;
    button = event.button;
    event.preventDefault();
  });
  stage.addEventListener('pointermove', (event) => {
    const old = pointers.get(event.pointerId);
    if (!old) return;
    const now = {x: event.clientX, y: event.clientY};
    const height = stage.clientHeight;
    const dx = (now.x - old.x) / height, dy = (now.y - old.y) / height;
    moved += Math.abs(now.x - old.x) + Math.abs(now.y - old.y);
    if (moved < 4) return;
    let camera = state.camera;
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
      const before = Math.hypot(old.x - other.x, old.y - other.y), after = Math.hypot(now.x - other.x, now.y - other.y);
      camera = Camera.panned(camera, -dx / 2, dy / 2);
      if (before > 0 && after > 0) camera = Camera.zoomed(camera, before / after);
    } else if (button === 2 || button === 1 || event.shiftKey) {
      camera = Camera.panned(camera, -dx, dy);
    } else {
      camera = Camera.orbited(camera, -dx * ORBIT, dy * ORBIT);
    }
    pointers.set(event.pointerId, now);
    setCamera(camera);
  });
  const end = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === 'pointerup' && moved < 4 && button === 0 && !event.shiftKey) {
      const box = stage.getBoundingClientRect();
      pick(pane, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    }
  };
  stage.addEventListener('pointerup', end);
  stage.addEventListener('pointercancel', end);
  stage.addEventListener('contextmenu', (event) => event.preventDefault());
  stage.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY;
    setCamera(Camera.zoomed(state.camera, Math.exp(Math.max(-8, Math.min(8, lines)) * 0.04)));
  }, {passive: false});
  stage.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (keyOfPicture(pane, event)) event.preventDefault();
  });
}

function keyOfPicture(pane, event) {
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  if (event.key in arrows) {
    const [x, y] = arrows[event.key];
    setCamera(event.shiftKey ? Camera.panned(state.camera, x * KEY_PAN, y * KEY_PAN)
                             : Camera.orbited(state.camera, x * KEY_ORBIT, y * KEY_ORBIT));
    return true;
  }
  if (event.key === '+' || event.key === '=') setCamera(Camera.zoomed(state.camera, 1 / KEY_ZOOM));
  else if (event.key === '-' || event.key === '_') setCamera(Camera.zoomed(state.camera, KEY_ZOOM));
  else if (event.key === 'c') nextChannel(pane);
  else if (event.key === 'g') nextGrid(pane);
  else return false;
  return true;
}

function nextChannel(pane) {
  const all = state.scene.channels;
  pane.set({channel: all[(all.indexOf(pane.settings.channel) + 1) % all.length]});
  announce(`channel ${pane.settings.channel}`);
}
function nextGrid(pane) {
  pane.set({grid: (pane.settings.grid + 1) % state.scene.grids.length});
  announce(`grid ${state.scene.grids[pane.settings.grid].name}`);
}

function pick() {}

function toggleCompare() {
  if (state.panes.length > 1) {
    state.panes.length = 1;
  } else {
    const first = state.panes[0];
    state.panes.push({...first, grid: (first.grid + 1) % state.scene.grids.length});
  }
  update();
}

function keyOfPage(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  if (event.key === '?') toggleKeys();
  else if (event.key === 'v') toggleCompare();
  else if (event.key === 'Home') setCamera(homeCamera());
  else return;
  event.preventDefault();
}

function toggleKeys() {
  const list = $('keys-list');
  list.hidden = !list.hidden;
  $('keys').setAttribute('aria-expanded', String(!list.hidden));
}

// --- Panels --------------------------------------------------------------------------------------------------

function showView() {
  const rows = [['from', 'Vector x, y, z'], ['at', 'The point that the camera orbits'], ['up', 'Vector x, y, z']];
  const panel = $('view-rows');
  if (panel.childElementCount === 0) {
    for (const [name, title] of rows) {
      const input = element('input', {id: `view-${name}`, type: 'text', title, spellcheck: 'false', autocomplete: 'off',
        onchange: () => changeVector(name)});
      panel.append(element('label', {class: 'name', for: `view-${name}`}, name), input);
    }
    panel.append(element('label', {class: 'name', for: 'view-angle'}, 'angle, degrees'),
      element('input', {id: 'view-angle', type: 'number', min: 0.1, max: 179, step: 'any', onchange: () => {
        const angle = Number($('view-angle').value);
        if (angle > 0 && angle < 180) setCamera({...state.camera, angle});
        else showView();
      }}),
      element('label', {class: 'name', for: 'view-depth'}, 'ray depth'),
      element('input', {id: 'view-depth', type: 'number', min: 1, max: 32, step: 1, onchange: () => {
        const depth = Math.round(Number($('view-depth').value));
        if (depth >= 1 && depth <= 32) state.depth = depth;
        update();
      }}));
  }
  for (const [name] of rows) {
    const input = $(`view-${name}`);
    if (document.activeElement !== input) input.value = Text.vector(state.camera[name]);
  }
  if (document.activeElement !== $('view-angle')) $('view-angle').value = Number(state.camera.angle.toPrecision(6));
  if (document.activeElement !== $('view-depth')) $('view-depth').value = state.depth;
}

function changeVector(name) {
  const numbers = $(`view-${name}`).value.split(/[\s,]+/).filter(Boolean).map(Number);
  const camera = {...state.camera, [name]: numbers};
  const sees = numbers.length === 3 && numbers.every(Number.isFinite) &&
    Vec.length(Vec.cross(Vec.sub(camera.at, camera.from), camera.up)) > 0;
  if (sees) setCamera(camera);
  else announce(`${name} isn’t a vector x, y, z by which the camera can see`);
  $(`view-${name}`).value = Text.vector(state.camera[name]);
}

let costFrame = 0;
function showCost() {
  if (costFrame) return;
  costFrame = requestAnimationFrame(() => {
    costFrame = 0;
    const shown = panes.map((pane) => ({name: state.scene.grids[pane.settings.grid].name, frame: pane.frame,
      counts: pane.counts, grid: state.scene.grids[pane.settings.grid]}));
    $('cost').replaceChildren(costTable(shown));
  });
}

async function showFigures() {
  const names = state.scene.grids.map((grid) => grid.name);
  try {
    const all = await Promise.all(names.map((name, i) => source.statistics(i)));
    $('statistics').replaceChildren(element('div', {class: 'scroll wide', tabindex: 0, role: 'group', 'aria-label': 'Statistics of the grids'}, statisticsTable(names, all)));
    const shown = [...new Set(state.panes.map((pane) => pane.grid))];
    $('histogram').replaceChildren(histogramChart(shown.map((i) => names[i]), shown.map((i) => all[i])));
  } catch (error) {
    $('statistics').replaceChildren(element('p', {class: 'note'}, error.message));
  }
}

// --- Buttons -------------------------------------------------------------------------------------------------

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

function quoted(word) {
  return /^[\w@%+=:,.\/-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}

// The command that makes the first picture.
function command() {
  const pane = panes[0];
  const {scene, grids, precision} = state.scene;
  const [width, height] = pane.size();
  const {from, at, up, angle} = state.camera;
  return ['gridrender', quoted(scene.path), quoted(grids[pane.settings.grid].path), '-o picture.png',
    `--size ${width}x${height}`, `--from=${from.join()}`, `--at=${at.join()}`, `--up=${up.join()}`, `--angle ${angle}`,
    ...(state.depth === 5 ? [] : [`--depth ${state.depth}`]),
    ...(precision === 'robust' ? [] : [`--precision ${precision}`])].join(' ');
}

// --- Beginning -----------------------------------------------------------------------------------------------

function describeScene() {
  const {scene, device, precision, version} = state.scene;
  document.title = `${scene.name} – gridview`;
  $('scene-name').textContent = scene.name;
  $('scene-facts').textContent = `${Text.count(scene.primitives)} primitives · ${Text.bytes(scene.bytes)} · ${precision} · ${device} · Masu ${version}`;
}

async function begin() {
  source = new Server();
  state.scene = await source.scene();
  state.scene.channels = state.scene.channels || ['shaded'];
  describeScene();
  readFragment();
  update();
  $('compare').addEventListener('click', toggleCompare);
  $('reset').addEventListener('click', () => setCamera(homeCamera()));
  $('keys').addEventListener('click', toggleKeys);
  $('copy-link').addEventListener('click', () => copy(location.href.split('#')[0] + fragment(), 'Link'));
  $('copy-command').addEventListener('click', () => copy(command(), 'Command'));
  document.addEventListener('keydown', keyOfPage);
  window.addEventListener('hashchange', () => { readFragment(); update(); });
}

begin().catch((error) => {
  document.querySelector('main').replaceChildren(element('p', {role: 'alert', class: 'note'}, `gridview: ${error.message}`));
});
