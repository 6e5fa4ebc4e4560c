// The page: what is shown, and how the mouse, fingers and keys change it.
'use strict';

const $ = (id) => document.getElementById(id);

const state = {
  scene: null,           // as /api/scene describes it
  camera: null,
  depth: 5,
  panes: [],             // [{grid, channel, cells}]: one, or two that are compared
  plane: null,           // grids whose slices are shown instead of pictures
  slice: {axis: 2, share: 0.5, depth: null}, // depth: of cells and boxes that are shown, null for all
  pointer: null,         // over a picture: shares of it
  picking: null,         // the cross hair: {pane, x, y}, shares of the picture
};
let slicePanel = null, walkPanel = null, planeView = null, colors = null, scales = null;
const MOST_SLICES = 4;
const CELLS = ['none', 'slice', 'boxes', 'ray'];
const TESTED = '#ff9ecb'; // cells and nodes of a walk in which primitives are tested
const panes = [];        // what is on the page for each of state.panes
let source = null;

// --- What the address holds ----------------------------------------------------------------------------------

function homeCamera() {
  const {from, at, up, angle} = state.scene.camera;
  return {from, at, up, angle};
}

// A grid in an address: by its name, or by its hash where another one has that name, too.
function gridKey(grid) {
  const isPlain = !grid.name.includes(',') && state.scene.grids.filter((one) => one.name === grid.name).length === 1;
  return isPlain ? grid.name : grid.hash;
}

// count of them, all finite; null for anything else.
function readNumbers(text, count) {
  const words = (text || '').split(',');
  const numbers = words.map(Number);
  return numbers.length === count && words.every((word) => word.trim()) && numbers.every(Number.isFinite) ? numbers : null;
}

function fragment() {
  const parts = new URLSearchParams();
  const home = homeCamera();
  for (const part of ['from', 'at', 'up', 'angle']) {
    if (String(state.camera[part]) !== String(home[part])) parts.set(part, String(state.camera[part]));
  }
  if (state.depth !== 5) parts.set('depth', state.depth);
  parts.set('grid', (state.plane || state.panes.map((pane) => pane.grid)).map((grid) => gridKey(state.scene.grids[grid])).join());
  if (state.plane) parts.set('view', 'plane');
  else parts.set('channel', state.panes.map((pane) => pane.channel).join());
  if (!state.plane && state.panes.some((pane) => pane.cells !== 'none')) parts.set('cells', state.panes.map((pane) => pane.cells).join());
  if (scales.kind !== 'automatic') parts.set('scale', scales.kind);
  const {axis, share, depth} = state.slice;
  if (axis !== 2 || share !== 0.5 || depth !== null) parts.set('slice', ['xyz'[axis], share, ...(depth === null ? [] : [depth])].join());
  if (walkPanel && walkPanel.ray) {
    const {ray, pane, index, step} = walkPanel;
    parts.set('ray', [...ray.origin, ...ray.direction].join());
    if (ray.precision) parts.set('precision', ray.precision);
    if (ray.all) parts.set('all', 1);
    parts.set('walk', [pane, index, ...(step === null ? [] : [step])].join());
  }
  return '#' + parts.toString().replaceAll('%2C', ',').replaceAll('%2F', '/');
}

// The walk that the address holds: {ray, look} of WalkPanel.follow(), or null.
function readWalk() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const numbers = readNumbers(parts.get('ray'), 6);
  if (!numbers || numbers.slice(3).every((number) => number === 0)) return null;
  const precision = ['fast', 'robust', 'double'].find((name) => name === parts.get('precision'));
  const ray = {origin: numbers.slice(0, 3), direction: numbers.slice(3), ...(precision ? {precision} : {}),
    all: parts.get('all') === '1', depth: state.depth};
  const [pane = 0, index = 0, step = null] = (parts.get('walk') || '').split(',').map((word) => /^\d{1,9}$/.test(word) ? Number(word) : undefined);
  return {ray, look: {pane: Math.min(pane, (state.plane || state.panes).length - 1), index, step}};
}

// Whatever of it makes sense.
function readFragment() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const camera = homeCamera();
  for (const part of ['from', 'at', 'up']) {
    camera[part] = readNumbers(parts.get(part), 3) || camera[part];
  }
  const angle = Number(parts.get('angle'));
  if (angle > 0 && angle < 180) camera.angle = angle;
  const view = Vec.sub(camera.at, camera.from);
  state.camera = Vec.length(Vec.cross(view, camera.up)) > 0 ? camera : homeCamera();
  if (!source.isLive) state.camera = source.nearest(state.camera);
  state.wish = state.camera;
  const depth = Number(parts.get('depth'));
  state.depth = depth >= 1 && depth <= 32 ? Math.round(depth) : 5;
  scales.kind = ['linear', 'logarithmic'].find((kind) => kind === parts.get('scale')) || 'automatic';
  const grids = (parts.get('grid') || '').split(',').map((name) => state.scene.grids.findIndex((grid) => gridKey(grid) === name));
  const channels = (parts.get('channel') || '').split(',');
  const cells = (parts.get('cells') || '').split(',');
  const [axis, share, level] = (parts.get('slice') || '').split(',');
  const isSlice = ['x', 'y', 'z'].includes(axis) && share >= 0 && share <= 1;
  Object.assign(state.slice, isSlice ? {axis: 'xyz'.indexOf(axis), share: Number(share)} : {axis: 2, share: 0.5},
    {depth: isSlice && /^\d{1,2}$/.test(level) ? Number(level) : null});
  const known = grids.filter((grid) => grid >= 0);
  state.plane = parts.get('view') !== 'plane' ? null : known.length > 0 ? known.slice(0, MOST_SLICES) : allInPlane();
  const made = known.slice(0, state.plane ? 1 : 2).map((grid, i) => ({
    grid, channel: state.scene.channels.includes(channels[i]) ? channels[i] : 'shaded',
    cells: CELLS.includes(cells[i]) ? cells[i] : 'none'}));
  state.panes = made.length > 0 ? made : [{grid: 0, channel: 'shaded', cells: 'none'}];
}

// The first ones.
const allInPlane = () => state.scene.grids.map((grid, i) => i).slice(0, MOST_SLICES);

let addressTimer = 0;
function rememberSoon() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    if (location.hash !== fragment()) history.replaceState(null, '', fragment());
  }, 250);
}

// A grid's name without the ending, where that's enough to tell grids apart; may break at underlines.
function shortName(index) {
  return state.scene.grids[index].name.replace(/\.grid$/, '').replaceAll('_', '_\u200b');
}

// --- Panes ---------------------------------------------------------------------------------------------------

class Pane {
  constructor(index) {
    this.index = index;
    const root = $('picture-template').content.firstElementChild.cloneNode(true);
    this.root = root;
    this.stage = root.querySelector('.stage');
    this.image = root.querySelector('.image');
    this.overlay = new Overlay(root.querySelector('.overlay'));
    this.scale = root.querySelector('.scale');
    this.walkCounts = root.querySelector('.walk-counts');
    this.status = root.querySelector('.status');
    this.problem = root.querySelector('.problem');
    this.gridSelect = root.querySelector('.grid');
    this.channelSelect = root.querySelector('.channel');
    this.cellsSelect = root.querySelector('.cells');
    this.frame = null;
    this.counts = null;
    this.span = null; // {channel, values: of spanOf()} of the picture that is shown
    this.value = root.querySelector('.under-pointer');
    this.scaleKind = root.querySelector('.scale-kind');
    this.scaleSelect = this.scaleKind.querySelector('select');
    this.picture = new Picture(this.image, source, (...numbers) => scales.colored(...numbers), (frame) => this.drawn(frame), (text) => this.failed(text));
    state.scene.grids.forEach((grid, i) => this.gridSelect.append(element('option', {value: i}, grid.name)));
    for (const channel of state.scene.channels) this.channelSelect.append(element('option', {value: channel}, channel));
    for (const cells of CELLS) this.cellsSelect.append(element('option', {value: cells}, cells));
    this.cellsSelect.addEventListener('change', () => this.set({cells: this.cellsSelect.value}));
    this.gridSelect.addEventListener('change', () => this.set({grid: Number(this.gridSelect.value)}));
    this.channelSelect.addEventListener('change', () => this.set({channel: this.channelSelect.value}));
    this.scaleSelect.addEventListener('change', () => setScale(this.scaleSelect.value));
    this.resized = new ResizeObserver(() => this.update());
    this.resized.observe(this.stage);
    controlCamera(this);
  }

  get settings() { return state.panes[this.index]; }
  get structure() { return state.scene.grids[this.settings.grid]; }

  set(change) {
    Object.assign(this.settings, change);
    if ('grid' in change) this.counts = null;
    update();
  }

  // The view's camera; wider where the picture is narrower than the scene's own, so that it holds what that holds.
  camera(width, height) {
    const {camera} = state, own = state.scene.camera;
    const wider = source.isLive ? own.width / own.height / (width / height) : 1;
    if (!(wider > 1)) return camera;
    return {...camera, angle: Math.atan(Math.tan(camera.angle * Math.PI / 360) * wider) * 360 / Math.PI};
  }

  size() {
    if (!source.isLive) return source.size;
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
    this.cellsSelect.value = this.settings.cells;
    this.stage.setAttribute('aria-label', `${state.scene.scene.name} through ${state.scene.grids[this.settings.grid].name}, ${this.settings.channel}. Arrow keys orbit, Enter picks a pixel.`);
    this.picture.show({grid: this.settings.grid, channel: this.settings.channel, camera: this.camera(width, height),
      width, height, depth: state.depth, axis: state.slice.axis, share: state.slice.share});
  }
  get isCut() { return this.settings.channel === 'cut'; }

  drawn(frame) {
    this.frame = frame;
    const {trace, total} = frame.milliseconds;
    const size = `${Math.round(frame.view.width * frame.scale)} × ${Math.round(frame.view.height * frame.scale)}`;
    const what = frame.isSharp ? 'sharp' : frame.share < 1 ? `${Math.round(100 * frame.share)} %` : 'moving';
    const [precision] = (frame.precision || '').split(':');
    this.status.title = frame.precision || '';
    this.status.textContent = source.isLive
      ? `${size} · trace ${Text.milliseconds(trace)} · shown after ${Text.milliseconds(total)} · ${precision} · ${what}`
      : `${size} · trace ${Text.milliseconds(trace)} when it was exported`;
    this.root.dataset.state = frame.isSharp ? 'sharp' : 'moving';
    if (frame.isSharp) this.count(frame.view);
    this.drawOverlay();
    const {values} = this.picture;
    if (frame.isMoving || frame.isSharp) {
      const span = values && spanOf(values.channel, values.data);
      this.span = span && {channel: values.channel, ...span};
      if (span) fitScale(values.channel);
    }
    this.showScale();
    this.showValue();
    showCost();
  }

  // With the camera of the picture that is shown.
  drawOverlay() {
    if (!this.frame) return;
    const {camera, width, height} = this.frame.view;
    const {overlay} = this;
    overlay.begin(camera, width, height);
    if (this.settings.cells === 'slice' || this.isCut) {
      const slice = slicePanel.of(this.settings.grid);
      if (slice) {
        const cells = slicePanel.cellsOf(this.settings.grid);
        if (this.isCut)
          for (const [color, polygons] of sliceColors(slice, cells, colors.reversed(), slicePanel.most())) overlay.fill(polygons, color, 0.85);
        overlay.boxes(cells.slice(0, 20000).map((cell) => sliceBox(slice, cell)), this.isCut ? '#000' : '#fff', 0.8, this.isCut ? 0.4 : 0.55);
        overlay.lines(slice.outline.map(([u0, v0, u1, v1]) => [slicePoint(slice, u0, v0), slicePoint(slice, u1, v1)]), '#ff7a1a', 1.6);
      }
    }
    const boxes = this.settings.cells === 'boxes' && slicePanel.boxesOf(this.settings.grid);
    if (boxes) this.drawBoxes(boxes.boxes);
    const ray = walkPanel.rayOf(this.settings.grid);
    if (ray) this.drawWalk(ray);
    this.walkCounts.hidden = !ray;
    if (ray) this.walkCounts.textContent = `${counted(ray.cells, visited(this.structure))}, ${counted(ray.tests, 'test')}`;
    if (state.picking && state.picking.pane === this.index) overlay.crossHair(state.picking.x, state.picking.y, '#ffd54a');
  }

  // Of several depths: lighter, the deeper.
  drawBoxes(boxes) {
    this.overlay.boxes(boxes, '#000', 2.2, 0.25);
    const depths = [...new Set(boxes.map((box) => box.depth))], deepest = Math.max(...depths);
    for (const depth of depths)
      this.overlay.boxes(boxes.filter((box) => box.depth === depth), depths.length > 1 ? colors.at(0.45 + 0.55 * depth / deepest) : '#7fd1ff', 1, 0.75);
  }

  // Of its own grid.
  drawWalk(ray) {
    const {overlay} = this;
    const at = (t) => Vec.add(ray.origin, Vec.scaled(ray.direction, t));
    if (this.settings.cells === 'ray') {
      this.drawBoxes(ray.steps.map((step) => step.box));
      overlay.boxes(ray.steps.filter((step) => step.tests.length > 0).map((step) => step.box), TESTED, 1.4);
    }
    const step = ray.steps[Math.min(walkPanel.step, ray.steps.length - 1)];
    if (step) {
      overlay.boxes([step.box], '#000', 4, 0.5);
      overlay.boxes([step.box], '#ffd54a', 2);
    }
    const last = ray.steps[ray.steps.length - 1];
    const end = ray.hit ? ray.hit.t : last && last.exit !== null ? last.exit : null;
    if (end !== null) {
      overlay.lines([[ray.origin, at(end)]], '#000', 3, 0.5);
      overlay.lines([[ray.origin, at(end)]], '#ff7a1a', 1.5);
    }
    if (ray.hit) {
      overlay.point(ray.hit.position, '#000', 4.5);
      overlay.point(ray.hit.position, '#ff7a1a', 3.2);
    }
  }

  showScale() {
    const channel = this.frame.view.channel;
    const isNumber = this.span && this.span.channel === channel;
    const isFirst = panes.find((pane) => pane.settings.channel === channel) === this; // the scale is that of all
    this.scaleKind.hidden = !isNumber || !COUNTS.includes(channel);
    this.scaleSelect.value = scales.kind;
    this.scale.hidden = !(isNumber || this.isCut) || !isFirst;
    if (this.scale.hidden) return;
    const {low, high, isLogarithmic} = this.isCut ? {low: 1, high: slicePanel.most(), isLogarithmic: true} : scales.of(channel);
    this.scale.querySelector('.colors').style.backgroundImage = (this.isCut ? colors.reversed() : colors).gradient();
    this.scale.querySelector('.low').textContent = `${{idle: 'idle lanes', cut: 'references'}[channel] || channel} ${this.isCut ? low : Text.number(low)}`;
    this.scale.querySelector('.high').textContent = `${channel === 'depth' ? Text.number(high) : Text.count(high)}${COUNTS.includes(channel) ? ' and more' : ''}${isLogarithmic ? ', log' : ''}`;
  }

  // Under the pointer, which may be over the other picture, or under the cross hair.
  showValue() {
    const {values} = this.picture, at = state.picking || state.pointer;
    const isOver = values && at && at.x >= 0 && at.x < 1 && at.y >= 0 && at.y < 1;
    this.value.hidden = !isOver;
    if (!isOver) return;
    const value = values.data[Math.floor(at.y * values.height) * values.width + Math.floor(at.x * values.width)];
    this.value.textContent = `${values.channel} ${!Number.isFinite(value) ? '∞' : COUNTS.includes(values.channel) ? Text.count(value) : Number(value.toPrecision(values.channel === 'idle' ? 3 : 6))}`;
  }

  // Ray counts of a smaller picture of the same view.
  async count(view) {
    const scale = Math.min(1, Math.sqrt(60000 / (view.width * view.height)));
    const small = {...view, width: Math.max(1, Math.round(view.width * scale)), height: Math.max(1, Math.round(view.height * scale))};
    if (this.counting) this.counting.abort();
    this.counting = new AbortController();
    try {
      this.counts = {...await source.counts(small, this.counting.signal), size: [small.width, small.height]};
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
  const wanted = state.plane ? 0 : state.panes.length;
  while (panes.length > wanted) panes.pop().close();
  while (panes.length < wanted) {
    const pane = new Pane(panes.length);
    panes.push(pane);
    $('pictures').append(pane.root);
  }
  $('compare').setAttribute('aria-pressed', String(panes.length > 1));
  $('plane').setAttribute('aria-pressed', String(Boolean(state.plane)));
  $('pictures').hidden = Boolean(state.plane);
  for (const id of ['compare', 'reset', 'copy-command', 'view-panel', 'cost-panel', 'slice-panel']) $(id).hidden = Boolean(state.plane);
  $('walk-title').textContent = state.plane ? 'Walk of the ray' : 'Walk of a pixel';
  $('walk-all').parentElement.hidden = Boolean(state.plane);
  planeView.show(state.plane || []);
  if (!state.plane) $('slice').prepend(slicePanel.place, slicePanel.depths);
}

function fitScale(channel) {
  const spans = panes.map((pane) => pane.span).filter((span) => span && span.channel === channel);
  if (scales.fit(channel, spans)) recolor();
}
function recolor() {
  for (const pane of panes) {
    pane.picture.recolor();
    if (pane.frame) pane.showScale();
  }
}
function setScale(kind) {
  scales.kind = kind;
  recolor();
  rememberSoon();
}

// After any change of `state`.
function update() {
  showPanes();
  for (const pane of panes) pane.update();
  showView();
  showFigures();
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

// Shares of a picture; an exported one doesn't fill its stage.
function sharesOf(pane, [x, y]) {
  const {clientWidth, clientHeight} = pane.stage, [width, height] = pane.size();
  const scale = Math.min(clientWidth / width, clientHeight / height);
  return {x: 0.5 + (x - clientWidth / 2) / (scale * width), y: 0.5 + (y - clientHeight / 2) / (scale * height)};
}

function showValues(pointer) {
  state.pointer = pointer;
  for (const pane of panes) pane.showValue();
}

function controlCamera(pane) {
  const {stage} = pane, wished = () => state.wish || state.camera;
  const ofHeight = (move) => move.map((pixels) => pixels / stage.clientHeight);
  onGestures(stage, {
    hover: (place) => showValues(sharesOf(pane, place)),
    leave: () => showValues(null),
    drag: (from, to, event) => {
      const [dx, dy] = ofHeight([to[0] - from[0], to[1] - from[1]]);
      setCamera(event.buttons & 6 || event.shiftKey ? Camera.panned(wished(), -dx, dy) : Camera.orbited(wished(), -dx * ORBIT, dy * ORBIT));
    },
    pinch: (factor, middle, move) => {
      const [dx, dy] = ofHeight(move);
      setCamera(Camera.zoomed(Camera.panned(wished(), -dx / 2, dy / 2), 1 / factor));
    },
    wheel: (lines) => setCamera(Camera.zoomed(state.camera, Math.exp(lines * 0.04))),
    click: (place, event) => {
      const {x, y} = sharesOf(pane, place);
      if (!event.shiftKey) pick(pane, x, y);
    },
  });
  stage.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (keyOfPicture(pane, event)) event.preventDefault();
  });
}

function keyOfPicture(pane, event) {
  if (state.picking && keyOfPicking(pane, event)) return true;
  if (event.key in ARROWS) {
    const [x, y] = ARROWS[event.key];
    const orbit = source.isLive ? KEY_ORBIT : source.step;
    setCamera(event.shiftKey ? Camera.panned(state.camera, x * KEY_PAN, y * KEY_PAN)
                             : Camera.orbited(state.camera, x * orbit, y * orbit));
    return true;
  }
  if (event.key === '+' || event.key === '=') setCamera(Camera.zoomed(state.camera, 1 / KEY_ZOOM));
  else if (event.key === '-' || event.key === '_') setCamera(Camera.zoomed(state.camera, KEY_ZOOM));
  else if (event.key in NEXT) announce(NEXT[event.key](pane));
  else if (event.key === 'Enter') setPicking({pane: pane.index, x: 0.5, y: 0.5});
  else if (event.key === 'Escape' && walkPanel.ray) walkPanel.clear();
  else return false;
  return true;
}

// What keys change, in words.
const after = (all, one) => all[(all.indexOf(one) + 1) % all.length];
const NEXT = {
  c(pane) {
    pane.set({channel: after(state.scene.channels, pane.settings.channel)});
    return `channel ${pane.settings.channel}`;
  },
  g(pane) {
    pane.set({grid: (pane.settings.grid + 1) % state.scene.grids.length});
    return `grid ${pane.structure.name}`;
  },
  w(pane) {
    pane.set({cells: after(CELLS, pane.settings.cells)});
    return `cells: ${pane.settings.cells}`;
  },
  l() {
    setScale(after(['automatic', 'linear', 'logarithmic'], scales.kind));
    return `scale: ${scales.kind}`;
  },
};

// The cross hair, moved by keys.
function setPicking(picking) {
  state.picking = picking;
  for (const pane of panes) pane.stage.classList.toggle('picking', Boolean(picking && picking.pane === pane.index));
  drawOverlays();
  if (picking) announce('Arrow keys move the cross hair, Enter picks, Escape drops it');
}
function keyOfPicking(pane, event) {
  const {x, y} = state.picking;
  if (event.key in ARROWS) {
    const [dx, dy] = ARROWS[event.key];
    const [width, height] = pane.size();
    const pixels = event.shiftKey ? 20 : 2;
    const clamped = (value) => Math.max(0, Math.min(0.99999, value));
    state.picking = {pane: pane.index, x: clamped(x + dx * pixels / width), y: clamped(y - dy * pixels / height)};
    drawOverlays();
  } else if (event.key === 'Enter') {
    setPicking(null);
    pick(pane, x, y);
  } else if (event.key === 'Escape') {
    setPicking(null);
  } else {
    return false;
  }
  return true;
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
    if (current && !signal.aborted) announce(`pixel ${x}, ${y}: ${counted(current.cells, visited(walkPanel.structures[walkPanel.pane]))}, ${counted(current.tests, 'test')}`);
  } catch (error) {
    if (error.name !== 'AbortError') walkPanel.failed(error.message);
  }
}

function toggleCompare() {
  if (state.panes.length > 1) {
    state.panes.length = 1;
  } else {
    const first = state.panes[0];
    state.panes.push({...first, grid: (first.grid + 1) % state.scene.grids.length});
  }
  update();
}

function togglePlane() {
  state.plane = state.plane ? null : allInPlane();
  showPanes();
  walkPanel.clear();
  update();
}

function keyOfPage(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  if (event.key === '?') toggleKeys();
  else if (event.key === 'p') togglePlane();
  else if (event.key === 'v' && !state.plane) toggleCompare();
  else if (event.key === 'Home') setCamera(homeCamera());
  else if (event.key === ',' && walkPanel.move(-1)) { /* a step back */ }
  else if (event.key === '.' && walkPanel.move(1)) { /* a step on */ }
  // What has keys of its own keeps them; Enter presses what is focused.
  else if (panes.length > 0 && !event.target.closest('.stage, .scroll') && (event.key !== 'Enter' || event.target === document.body) &&
           keyOfPicture(panes[0], event)) { /* the first picture's */ }
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

let costFrame = 0;
function showCost() {
  if (costFrame) return;
  costFrame = requestAnimationFrame(() => {
    costFrame = 0;
    if (panes.length === 0) return; // the plane, by now
    const shown = panes.map((pane) => ({name: shortName(pane.settings.grid), frame: pane.frame,
      counts: pane.counts, grid: state.scene.grids[pane.settings.grid]}));
    const isOpen = $('cost').querySelector('details')?.open;
    $('cost').replaceChildren(...costTable(shown));
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

// The command that makes the first picture; of a channel its values, and gridrender's own picture of them; of a cut the slice.
function command() {
  const pane = panes[0];
  const {scene, grids, precision} = state.scene;
  if (pane.isCut)
    return `gridstat ${quoted(grids[pane.settings.grid].path)} --slice ${'xyz'[state.slice.axis]}=${100 * state.slice.share}% --outline ${quoted(scene.path)} --lines -o slice.png`;
  const [width, height] = pane.size();
  const {from, at, up, angle} = pane.camera(width, height);
  return ['gridrender', quoted(scene.path), quoted(grids[pane.settings.grid].path), '-o picture.png',
    `--size ${width}x${height}`, `--from=${from.join()}`, `--at=${at.join()}`, `--up=${up.join()}`, `--angle ${angle}`,
    ...(pane.settings.channel === 'shaded' ? [] : [`--channels ${pane.settings.channel.replace('all ', '')}`,
      ...(pane.settings.channel.startsWith('all ') ? ['--all-rays'] : []), '--no-picture', '--sampling centers']),
    ...(state.depth === 5 ? [] : [`--depth ${state.depth}`]),
    ...(precision === 'auto' ? [] : [`--precision ${precision}`])].join(' ');
}

// --- Beginning -----------------------------------------------------------------------------------------------

function describeScene() {
  const {scene, device, version} = state.scene;
  document.title = `${scene.name} – gridview`;
  $('scene-name').textContent = scene.name;
  $('scene-facts').textContent = `${Text.count(scene.primitives)} primitives · ${Text.bytes(scene.bytes)} · ${device} · Masu ${version}`;
}

function openAddress() {
  readFragment();
  showPanes();
  walkPanel.clear();
  update();
  const walk = readWalk();
  if (!walk) return;
  $('walk-all').checked = walk.ray.all;
  walkPanel.follow(walk.ray, walk.look);
}

async function begin() {
  source = typeof EXPORTED === 'undefined' ? new Server() : await Exported.from(EXPORTED);
  document.body.classList.toggle('exported', !source.isLive);
  state.scene = await source.scene();
  state.scene.channels = state.scene.channels.filter((channel) => source.isLive || channel !== 'cut');
  colors = new ColorScale(state.scene.colors);
  scales = new Scales(colors);
  describeScene();
  slicePanel = new SlicePanel($('slice'), source, state.slice, () => panes.filter((pane) => pane.isCut).forEach((pane) => pane.update()), drawOverlays);
  walkPanel = new WalkPanel($('walk'), source, () => planeView && drawOverlays(), (point) => setCamera(Camera.centered(state.camera, point)));
  planeView = new PlaneView($('planes'), state.scene, source, colors, slicePanel, walkPanel, (index, grid) => {
    state.plane[index] = grid;
    update();
  });
  $('walk-all').addEventListener('change', () => walkPanel.followAgain({all: $('walk-all').checked}));
  openAddress();
  $('view-panel').addEventListener('change', changeView);
  $('compare').addEventListener('click', toggleCompare);
  $('plane').addEventListener('click', togglePlane);
  $('reset').addEventListener('click', () => setCamera(homeCamera()));
  $('keys').addEventListener('click', toggleKeys);
  $('copy-link').addEventListener('click', () => copy(location.href.split('#')[0] + fragment(), 'Link'));
  $('copy-command').addEventListener('click', () => copy(command(), 'Command'));
  document.addEventListener('keydown', keyOfPage);
  window.addEventListener('hashchange', openAddress);
}

begin().catch((error) => {
  document.querySelector('main').replaceChildren(element('p', {role: 'alert', class: 'note'}, `gridview: ${error.message}`));
});
