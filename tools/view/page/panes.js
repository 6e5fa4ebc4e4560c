// The panes: one picture, or two side by side with one camera, and what is drawn and said over each.
'use strict';

const CELLS = ['none', 'slice', 'boxes', 'ray'];
const OVERLAY_MS = 30; // for what is drawn over a picture while the view moves
const TESTED = '#ff9ecb'; // cells and nodes of a walk in which primitives are tested
const panes = [];        // what is on the page for each of state.panes

class Pane {
  constructor(index) {
    this.index = index;
    const root = $('picture-template').content.firstElementChild.cloneNode(true), part = (name) => root.querySelector(`.${name}`);
    Object.assign(this, {root, stage: part('stage'), overlay: new Overlay(part('overlay')), scale: part('scale'), walkCounts: part('walk-counts'),
      status: part('status'), problem: part('problem'), gridSelect: part('grid'), channelSelect: part('channel'), cellsSelect: part('cells'),
      value: part('under-pointer'), scaleKind: part('scale-kind'), scaleSelect: part('scale-kind select'), frame: null, counts: null});
    this.span = null; // {channel, values: of spanOf()} of the picture that is shown
    this.picture = new Picture(part('image'), source, (...numbers) => scales.colored(...numbers), (frame) => this.drawn(frame), (text) => this.failed(text));
    this.division = new DivisionSlider(this.gridSelect, state.scene, state.scene.pictured, (grid) => this.set({grid}));
    this.status.before(this.division.root);
    for (const channel of state.scene.channels) this.channelSelect.append(element('option', {value: channel}, channel));
    for (const cells of CELLS) this.cellsSelect.append(element('option', {value: cells}, cells));
    this.cellsSelect.addEventListener('change', () => this.set({cells: this.cellsSelect.value}));
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
    if ('grid' in change) $('missing').hidden = true;
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
    const width = Math.max(16, Math.round(this.stage.clientWidth * ratio));
    const height = Math.max(16, Math.round(this.stage.clientHeight * ratio));
    const scale = Math.min(1, Math.sqrt(4e6 / (width * height)));
    return [Math.round(width * scale), Math.round(height * scale)];
  }

  update() {
    const [width, height] = this.size();
    this.division.show(this.settings.grid);
    this.channelSelect.value = this.settings.channel;
    this.cellsSelect.value = this.settings.cells;
    this.stage.setAttribute('aria-label', `${state.scene.scene.name} through ${state.scene.grids[this.settings.grid].name}, ${this.settings.channel}. Arrow keys orbit, Enter picks a pixel.`);
    const isNew = this.picture.show({grid: this.settings.grid, channel: this.settings.channel, camera: this.camera(width, height),
      width, height, depth: state.depth, ...(this.isCut ? {axis: state.slice.axis, share: state.slice.share} : {})});
    if (isNew && this.counting) this.counting.abort();
  }
  // The newest frame and counts, of the grid that is chosen; null where they are still another one's.
  of(figures) { return figures && figures.grid === this.settings.grid ? figures : null; }
  get isCut() { return this.settings.channel === 'cut'; }

  drawn(frame) {
    this.frame = frame;
    frame.grid = frame.view.grid;
    const {trace, total} = frame.milliseconds;
    const size = `${Math.round(frame.view.width * frame.scale)} × ${Math.round(frame.view.height * frame.scale)}`;
    const what = frame.isSharp ? 'sharp' : frame.share < 1 ? `${Math.round(100 * frame.share)} %` : 'moving';
    const [precision] = (frame.precision || '').split(':');
    this.status.title = frame.precision || '';
    this.status.textContent = source.isLive
      ? `${what} · ${size} · trace ${Text.milliseconds(trace)} · shown after ${Text.milliseconds(total)} · ${precision}`
      : `${size} · trace ${Text.milliseconds(trace)} when it was exported`;
    this.root.dataset.state = frame.isSharp ? 'sharp' : 'moving';
    if (frame.isSharp) this.count(frame.view);
    // Once for each view; what takes long, when it stands.
    if (frame.view !== this.overlaid) {
      if (frame.isMoving && this.overlayMs > OVERLAY_MS) this.overlay.begin(frame.view.camera, frame.view.width, frame.view.height);
      else this.drawOverlay();
    }
    const {values} = this.picture;
    if (frame.isMoving || frame.isSharp) {
      const span = values && spanOf(values.channel, values.data);
      this.span = span && {channel: values.channel, ...span};
      const spans = panes.map((pane) => pane.span).filter((one) => one && one.channel === values?.channel);
      if (span && scales.fit(values.channel, spans)) recolor();
    }
    this.showScale();
    this.showValue();
    showCost();
  }

  // With the camera of the picture that is shown.
  drawOverlay() {
    if (!this.frame) return;
    const {camera, width, height} = this.frame.view;
    const {overlay} = this, begin = performance.now();
    this.overlaid = this.frame.view;
    overlay.begin(camera, width, height);
    if (this.settings.cells === 'slice' || this.isCut) {
      const slice = slicePanel.of(this.settings.grid);
      if (slice) {
        const cells = slicePanel.cellsOf(this.settings.grid);
        if (this.isCut)
          for (const [color, polygons] of sliceColors(slice, cells, listColors, slicePanel.most())) overlay.fill(polygons, color, 0.85);
        const boxes = cells.slice(0, 20000).map((cell) => sliceBox(slice, cell));
        overlay.boxes(boxes, '#000', this.isCut ? 0.8 : 1.8, 0.4);
        if (!this.isCut) overlay.boxes(boxes, '#fff', 0.8, 0.75);
        overlay.lines(slice.outline.map(([u0, v0, u1, v1]) => [slicePoint(slice, u0, v0), slicePoint(slice, u1, v1)]), OUTLINE, 1.6);
      }
    }
    const boxes = this.settings.cells === 'boxes' && slicePanel.boxesOf(this.settings.grid);
    if (boxes) this.drawBoxes(boxes.boxes);
    const ray = walkPanel.rayOf(this.settings.grid);
    if (ray) this.drawWalk(ray);
    this.walkCounts.hidden = !ray;
    if (ray) this.walkCounts.textContent = `${counted(ray.cells, visited(this.structure))}, ${counted(ray.tests, 'test')}${walkPanel.guessOf(this.settings.grid)}`;
    if (state.picking && state.picking.pane === this.index) overlay.crossHair(state.picking.x, state.picking.y, '#ffd54a');
    this.overlayMs = performance.now() - begin;
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
    this.scaleKind.classList.toggle('unused', !isNumber || !COUNTS.includes(channel));
    this.scaleSelect.value = scales.kind;
    this.scale.hidden = !(isNumber || this.isCut) || !isFirst;
    if (this.scale.hidden) return;
    const {low, high, isLogarithmic} = this.isCut ? {low: 1, high: slicePanel.most(), isLogarithmic: true} : scales.of(channel);
    this.scale.querySelector('.colors').style.backgroundImage = (this.isCut ? listColors : colors).gradient();
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
      this.counts = {...await source.counts(small, this.counting.signal), grid: view.grid, size: [small.width, small.height]};
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

const ORBIT = 2.6;     // radians for a drag over the picture's height

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
