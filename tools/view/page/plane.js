// The plane: slices of up to four grids and hierarchies beside each other, and a ray in it that is dragged through all
// of them and followed step by step.
'use strict';

// One meaning a colour: cells and boxes that list primitives are violet (listColors).
const OUTLINE = '#dc2626'; // of the geometry
const VISITED = '#0b5cad', CURRENT = '#ffc61a', RAY = '#c2185b';
const FATES = {met: '#1a7f37', missed: '#6b6b66', beyond: '#e07b00'};
const KIN = '#1d1d1b'; // boxes around the one under the pointer, and those in it
const LEGEND = [['visited', VISITED], ['current', CURRENT], ['boxes met', FATES.met], ['missed', FATES.missed], ['beyond the hit', FATES.beyond], ['geometry', OUTLINE]];

// Of a hierarchy's box: those around it, from the nearest on, and those of the node in it.
function kin(cells, [, , , , , , inner, number]) {
  const nodeOf = (box) => Math.floor(box / BOXES_PER_NODE); // a box's number says its node and slot
  const around = (node) => {
    const box = node > 0 && cells.find((one) => one[6] === node);
    return box ? [box, ...around(nodeOf(box[7]))] : [];
  };
  return {around: around(nodeOf(number)), within: inner > 0 ? cells.filter((one) => nodeOf(one[7]) === inner) : []};
}

// {u, v, scale}: a window's middle, and how much larger it is; zoom: also the axis of its slices; of others, and null: all of a slice.
const zoomOf = (slice, zoom) => {
  const [u, v] = sliceSides(slice).map((side, k) => slice.min[k] + side / 2);
  return zoom?.axis === slice.axis ? zoom : {u, v, scale: 1};
};

// One slice. Draws cells or boxes once for each window, and the ray over them.
class SlicePlot {
  constructor(index, scene, colors, choose) {
    Object.assign(this, {index, colors, cells: document.createElement('canvas'), key: '', hovered: null, pixel: 1});
    this.gridSelect = element('select');
    this.division = new DivisionSlider(this.gridSelect, scene, scene.grids.length, (grid) => choose(index, grid));
    this.facts = element('output', {class: 'status', 'aria-live': 'off'});
    this.canvas = element('canvas', {class: 'slice', tabindex: 0, role: 'application', 'aria-roledescription': 'slice'});
    this.counts = element('p', {class: 'walk-counts', hidden: true});
    this.costText = element('span');
    this.costBar = element('span', {class: 'cost-bar', 'aria-hidden': true},
      ...[colors.at(0.6), VISITED].map((color) => element('span', {style: {background: color}})));
    this.cost = element('div', {class: 'row walk-cost unused'}, this.costText, this.costBar);
    this.sentence = element('p', {class: 'walk-sentence', hidden: true});
    this.root = element('figure', {class: 'picture'},
      element('div', {class: 'bar'}, element('div', {class: 'row'}, element('label', {}, 'Grid ', this.gridSelect), this.division.root), this.facts, this.cost),
      element('div', {class: 'plot'}, this.canvas, this.counts, this.sentence));
  }

  // Pixels of the canvas from scene units and back.
  window(slice, zoom) {
    const {canvas} = this;
    const [w, h] = sliceSides(slice), {u, v, scale: larger} = zoomOf(slice, zoom);
    const high = Math.max(canvas.height / 3, canvas.height - 60 * this.pixel); // between what is said above and below
    const scale = larger * Math.min((canvas.width - 24) / w, high / h);
    return {scale, x: (at) => canvas.width / 2 + (at - u) * scale, y: (at) => canvas.height / 2 - (at - v) * scale,
            u: (x) => u + (x - canvas.width / 2) / scale, v: (y) => v - (y - canvas.height / 2) / scale};
  }

  // True where the size changed.
  fit() {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map((side) => Math.max(48, Math.round(side * ratio)));
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, {width, height});
    this.pixel = ratio;
  }

  // most: references that the darkest colour stands for.
  drawCells(slice, cells, most, zoom) {
    const {canvas, colors} = this;
    const key = [slice.axis, slice.position, cells.length, most, canvas.width, canvas.height, zoom && Object.values(zoom)].join();
    if (this.key === key && this.slice === slice) return;
    Object.assign(this, {key, slice});
    Object.assign(this.cells, {width: canvas.width, height: canvas.height});
    const context = this.cells.getContext('2d', {alpha: false});
    const at = this.window(slice, zoom);
    context.fillStyle = '#fff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    const lines = new Path2D();
    for (const [u0, v0, u1, v1, references] of cells) {
      const left = at.x(sliceU(slice, u0)), right = at.x(sliceU(slice, u1)), top = at.y(sliceV(slice, v1)), bottom = at.y(sliceV(slice, v0));
      if (right < 0 || left > canvas.width || bottom < 0 || top > canvas.height) continue;
      if (references > 0) {
        context.fillStyle = colors.at(Math.log(references) / Math.log(Math.max(2, most)));
        context.fillRect(left, top, right - left + 0.5, bottom - top + 0.5);
      }
      if (right - left > 3 && bottom - top > 3) lines.rect(left, top, right - left, bottom - top);
    }
    this.stroke(context, lines, 'rgba(0, 0, 0, 0.35)', 0.7);
    const outline = new Path2D();
    for (const [u0, v0, u1, v1] of slice.outline) addLines(outline, [[at.x(u0), at.y(v0)], [at.x(u1), at.y(v1)]]);
    this.stroke(context, outline, OUTLINE, 1.4);
  }

  stroke(context, path, style, width, dash = []) {
    context.strokeStyle = style;
    context.lineWidth = width * this.pixel;
    context.setLineDash(dash);
    context.stroke(path);
    context.setLineDash([]);
  }

  // ends: {from, to} in the plane; ray: its walk, or null; step: the last one that is drawn.
  draw(slice, cells, zoom, ends, ray, step) {
    const {canvas, pixel} = this;
    const context = canvas.getContext('2d', {alpha: false});
    context.drawImage(this.cells, 0, 0);
    const at = this.window(slice, zoom);
    const [i, j] = slice.axes;
    const rectangle = ({min, max}) => [at.x(min[i]), at.y(max[j]), (max[i] - min[i]) * at.scale, (max[j] - min[j]) * at.scale];
    const pathOf = (boxes) => boxes.reduce((path, box) => (path.rect(...rectangle(box)), path), new Path2D());
    const stroke = (...how) => this.stroke(context, ...how);
    const segment = (...points) => addLines(new Path2D(), points.map(([u, v]) => [at.x(u), at.y(v)]));
    if (ray) {
      const visited = ray.steps.slice(0, step + 1).map(({box}) => box);
      context.fillStyle = 'rgba(40, 130, 255, 0.16)';
      for (const box of visited) context.fillRect(...rectangle(box)); // darker where boxes overlap
      stroke(pathOf(visited), VISITED, 1.4);
      // What becomes of the boxes of a hierarchy's node; those that the plane doesn't cut are missed.
      for (const [fate, boxes] of Object.entries(this.fates(slice, cells, ray, step)))
        stroke(pathOf(boxes), FATES[fate], 2, fate === 'met' ? [] : [4 * pixel, 3 * pixel]);
      const current = pathOf(ray.steps[step] ? [ray.steps[step].box] : []);
      stroke(current, '#000', 5);
      stroke(current, CURRENT, 3);
    }
    if (this.hovered && this.isHierarchy) {
      const {around, within} = kin(slice.cells, this.hovered);
      const path = (boxes) => pathOf(boxes.map((box) => sliceBox(slice, box)));
      around.forEach((box, i) => {
        context.globalAlpha = Math.max(0.25, 0.85 - 0.15 * i);
        stroke(path([box]), KIN, 2);
      });
      context.globalAlpha = 1;
      context.fillStyle = 'rgba(0, 0, 0, 0.10)';
      context.fill(path(within));
      stroke(path(within), KIN, 1.2, [4 * pixel, 3 * pixel]);
      stroke(path([this.hovered]), KIN, 3.5);
    }
    const far = [ends.from[0] + 9 * (ends.to[0] - ends.from[0]), ends.from[1] + 9 * (ends.to[1] - ends.from[1])];
    stroke(segment(ends.from, far), 'rgba(0, 0, 0, 0.45)', 1, [3 * pixel, 4 * pixel]);
    if (ray) {
      // As far as the steps that are drawn lead: to the hit only with the last of them.
      const last = ray.steps[Math.min(step, ray.steps.length - 1)];
      const isEnd = step >= ray.steps.length - 1;
      const t = isEnd && ray.hit ? ray.hit.t : last ? last.exit ?? last.enter : 0;
      const end = [i, j].map((axis) => ray.origin[axis] + t * ray.direction[axis]);
      stroke(segment(ends.from, end), '#fff', 4);
      stroke(segment(ends.from, end), RAY, 2.2);
      if (isEnd && ray.hit) this.dot(context, at.x(ray.hit.position[i]), at.y(ray.hit.position[j]), 4.5, RAY);
    }
    this.dot(context, at.x(ends.from[0]), at.y(ends.from[1]), 7, '#1d1d1b');
    this.arrow(context, at, ends);
  }

  // cost: {tests, steps} of [a, b] each, null where it isn't known; highest: that of the longest bar.
  showCost(cost, [a, b], highest) {
    this.cost.classList.toggle('unused', !cost); // its room stays
    if (!cost) return;
    this.costText.textContent = `cost ${a} · ${Text.count(cost.tests)} + ${b} · ${Text.count(cost.steps)} = ${Text.cost(a * cost.tests + b * cost.steps)}`;
    [a * cost.tests, b * cost.steps].forEach((part, i) => { this.costBar.children[i].style.width = `${highest > 0 ? 100 * part / highest : 0}%`; });
  }

  // Of the boxes of the node that is visited: {met, missed, beyond}, beyond the hit that is known by then.
  fates(slice, cells, ray, step) {
    const fates = {met: [], missed: [], beyond: []}, {node} = ray.steps[step] || {};
    if (!node) return fates;
    const before = ray.steps.slice(0, step).flatMap(({tests}) => tests.filter((test) => test.kept));
    const hit = before.length === 0 ? Infinity : before[before.length - 1].t ?? ray.hit.t;
    for (const cell of cells) {
      if (Math.floor(cell[7] / BOXES_PER_NODE) !== node.index) continue;
      const box = sliceBox(slice, cell);
      const [enter, exit] = intervalIn(box, ray);
      fates[enter > exit ? 'missed' : enter > hit ? 'beyond' : 'met'].push(box);
    }
    return fates;
  }

  // With a white edge.
  mark(context, path, color) {
    context.fillStyle = color;
    context.fill(path);
    this.stroke(context, path, '#fff', 2);
  }

  dot(context, x, y, radius, color) {
    const path = new Path2D();
    path.arc(x, y, radius * this.pixel, 0, 7);
    this.mark(context, path, color);
  }

  arrow(context, at, {from, to}) {
    const [x, y] = [at.x(to[0]), at.y(to[1])], angle = Math.atan2(y - at.y(from[1]), x - at.x(from[0]));
    const path = addLines(new Path2D(), [0, 2.5, -2.5].map((turn) => [x + 11 * this.pixel * Math.cos(angle + turn), y + 11 * this.pixel * Math.sin(angle + turn)]));
    path.closePath();
    this.mark(context, path, '#1d1d1b');
  }
}

class PlaneView {
  // scene: as /api/scene has it; choose(index, grid): another structure for a slice; zoomChanged().
  constructor(root, scene, source, colors, slicePanel, walkPanel, choose, zoomChanged) {
    Object.assign(this, {root, scene, source, colors, slicePanel, walkPanel, choose, zoomChanged,
      plots: [], grids: [], zoom: null, ends: null, wish: null, isFollowing: false});
    this.step = element('input', {class: 'step', type: 'range', min: 0, 'aria-label': 'Step of the walks',
      oninput: () => walkPanel.select(Number(this.step.value))});
    this.stepText = element('output', {'aria-live': 'off'}); // the walk's panel says it
    this.most = element('span');
    this.places = element('div', {class: 'controls places'});
    this.list = element('div', {class: 'plots'});
    root.append(element('div', {class: 'bar plane-bar'}, this.places,
      element('div', {class: 'controls'},
        element('button', {type: 'button', title: 'Every walk a step back (,)', onclick: () => walkPanel.move(-1)}, '◂'),
        element('button', {type: 'button', title: 'Every walk a step on (.)', onclick: () => walkPanel.move(1)}, '▸'), walkPanel.plays[1],
        this.step, this.stepText),
      element('div', {class: 'slice-scale'}, 'references 1',
        element('span', {class: 'colors', 'aria-hidden': true, style: {background: colors.gradient()}}), this.most),
      element('div', {class: 'legend'},
        ...LEGEND.map(([name, color]) => element('span', {style: {'--swatch': color}}, name)))), this.list);
    this.resized = new ResizeObserver(() => this.draw());
  }

  // grids: their indices, none where the plane isn't shown.
  show(grids) {
    this.grids = grids;
    this.root.hidden = grids.length === 0;
    while (this.plots.length > grids.length) {
      const plot = this.plots.pop();
      this.resized.unobserve(plot.canvas);
      plot.root.remove();
    }
    while (this.plots.length < grids.length) {
      const plot = new SlicePlot(this.plots.length, this.scene, this.colors, this.choose);
      this.plots.push(plot);
      this.list.append(plot.root);
      this.control(plot);
      this.resized.observe(plot.canvas);
    }
    this.list.dataset.count = grids.length;
    if (!this.root.hidden) this.places.append(this.slicePanel.place, this.slicePanel.depths);
  }

  get slice() { return this.grids.length > 0 ? this.slicePanel.of(this.grids[0]) : null; }

  // A ray through the whole slice, where there is none in this plane; the same one where only the plane moved.
  fitRay() {
    const {slice, walkPanel: {ray}} = this;
    const [i, j] = slice.axes, isParallel = ray && ray.direction[slice.axis] === 0;
    const isIn = isParallel && ray.origin[slice.axis] === slice.position;
    if (isParallel && !this.wish) {
      this.ends = {from: [ray.origin[i], ray.origin[j]], to: [ray.origin[i] + ray.direction[i], ray.origin[j] + ray.direction[j]]};
    } else if (this.axis !== slice.axis || !this.ends) {
      // From the left through the middle of the geometry, in shares of the slice.
      const sides = sliceSides(slice), from = [0.0213, 0.7519]; // on no voxel's face
      const [u, v] = sides.map((side, k) => {
        const all = slice.outline.map((line) => (line[k] - slice.min[k]) / side).sort((a, b) => a - b);
        return Math.max(0.1, all[all.length >> 1] ?? 0.5);
      });
      const far = Math.min(0.96 / (u - from[0]), v < from[1] ? (from[1] - 0.02) / (from[1] - v) : (0.98 - from[1]) / (v - from[1]));
      const at = (shares) => shares.map((share, k) => slice.min[k] + share * sides[k]);
      this.ends = {from: at(from), to: at([from[0] + far * (u - from[0]), from[1] + far * (v - from[1])])};
    }
    this.axis = slice.axis;
    if (!isIn && !this.isFollowing) this.follow();
  }

  // The walks of the newest ray, one at a time.
  async follow(ends = this.ends) {
    this.ends = this.wish = this.source.planeEnds(this.slice, ends);
    const isFollowing = this.isFollowing;
    this.isFollowing = true;
    this.draw();
    if (isFollowing) return;
    while (this.wish && this.slice) {
      const {slice, wish} = this, [origin, end] = [wish.from, wish.to].map(([u, v]) => slicePoint(slice, u, v));
      await this.walkPanel.follow({origin, direction: Vec.sub(end, origin), all: false, depth: 5}, {pane: Math.min(this.walkPanel.pane, this.grids.length - 1)});
      if (this.wish === wish) this.wish = null;
    }
    this.wish = null;
    this.isFollowing = false;
    if (this.walkPanel.ray) this.draw(); // the slice may be another one by now
  }

  draw() {
    const {slice} = this;
    if (!slice) return;
    if (!this.ends || this.slicePanel.isCurrent) this.fitRay(); // a link's ray isn't in the slice of before
    const {slicePanel, walkPanel} = this, {cost} = walkPanel.settings;
    const most = slicePanel.most();
    this.most.textContent = Text.count(most);
    const rays = this.grids.map((grid) => walkPanel.rayOf(grid));
    // While the next ray is on its way the last one's walks stay.
    if (rays.every(Boolean)) this.last = {grids: String(this.grids), rays};
    const shown = this.last?.grids === String(this.grids) && !walkPanel.isAsking ? this.last.rays : rays;
    const step = walkPanel.step ?? Infinity, last = Math.max(0, ...shown.map((ray) => ray ? ray.steps.length - 1 : 0));
    this.step.max = last;
    this.step.value = Math.min(step, last);
    this.stepText.textContent = walkPanel.isAsking ? '' : `step ${Math.min(step, last) + 1} of ${last + 1}`;
    this.step.setAttribute('aria-valuetext', this.stepText.textContent);
    const costs = shown.map((ray, i) => ray && this.costUntil(ray, step, this.scene.grids[this.grids[i]]));
    const highest = Math.max(...shown.map((ray, i) => ray ? costOf(cost, this.scene.grids[this.grids[i]], ray.cells, ray.tests) : 0));
    this.plots.forEach((plot, i) => {
      const grid = this.grids[i], own = slicePanel.of(grid), ray = shown[i];
      plot.division.show(grid);
      plot.isHierarchy = this.scene.grids[grid].structure === 'bvh';
      if (!own) return;
      plot.fit();
      const cells = slicePanel.cellsOf(grid);
      plot.drawCells(own, cells, most, this.zoom);
      plot.draw(own, cells, this.zoom, this.ends, ray, Math.min(step, ray ? ray.steps.length - 1 : 0));
      const facts = sliceFacts(own, cells, this.scene.grids[grid]);
      if (!plot.under) plot.facts.textContent = facts;
      plot.counts.hidden = !ray;
      plot.showCost(costs[i], cost, highest);
      plot.sentence.textContent = walkPanel.sentenceOf(grid);
      plot.sentence.hidden = !plot.sentence.textContent;
      plot.counts.textContent = ray ? this.progress(ray, step, last, visited(this.scene.grids[grid]), costs[i].tests) + walkPanel.guessOf(grid) : '';
      plot.canvas.setAttribute('aria-label', `${this.scene.grids[grid].name}: ${facts}. ${ray ? `${plot.counts.textContent}. ${plot.costText.textContent}. ` : ''}Arrow keys move the ray’s end, with Shift its origin${walkPanel.isAsking ? ', Enter leads to the guess' : ''}.`);
    });
  }

  // {tests, steps} of a ray up to a step.
  costUntil(ray, step, grid) {
    if (step >= ray.steps.length - 1) return {tests: ray.tests, steps: stepsOf(grid, ray.cells)};
    return {tests: ray.steps.slice(0, step + 1).reduce((sum, {tests}) => sum + tests.length, 0), steps: stepsOf(grid, step + 1)};
  }

  progress(ray, step, last, what, tests) {
    const all = `${counted(ray.cells, what)}, ${counted(ray.tests, 'test')}`;
    if (step >= ray.steps.length - 1) return step < last && step > ray.steps.length - 1 ? `${all}: ended` : all;
    const {node} = ray.steps[step];
    const boxes = node ? `; boxes: ${node.boxes_met} met, ${node.boxes_missed} missed, ${node.boxes_beyond} beyond the hit` : '';
    return `${what} ${step + 1} of ${Text.count(ray.cells)}: ${counted(ray.steps[step].tests.length, 'test')}, ${Text.count(tests)} so far${boxes}`;
  }

  zoomed(plot, factor, u, v) {
    const {slice} = this;
    const old = zoomOf(slice, this.zoom), scale = Math.max(1, Math.min(1e4, old.scale * factor)), share = old.scale / scale;
    this.setZoom(scale === 1 ? null : {u: u + (old.u - u) * share, v: v + (old.v - v) * share, scale, axis: slice.axis});
  }
  setZoom(zoom) {
    this.zoom = zoom;
    this.draw();
    this.zoomChanged();
  }

  // The mouse, fingers and keys of a slice.
  control(plot) {
    const {canvas} = plot;
    let held = null; // 'from', 'to', 'ray' or 'window'
    const pixels = ([x, y]) => { // of the canvas
      const {width, height} = canvas.getBoundingClientRect();
      return [x * canvas.width / width, y * canvas.height / height];
    };
    const nearest = (place, event) => {
      const reach = (event.pointerType === 'touch' ? 26 : 16) * plot.pixel, [x, y] = pixels(place);
      const at = plot.window(plot.slice, this.zoom);
      const [fx, fy, tx, ty] = [at.x(this.ends.from[0]), at.y(this.ends.from[1]), at.x(this.ends.to[0]), at.y(this.ends.to[1])];
      if (Math.hypot(tx - x, ty - y) < reach) return 'to';
      if (Math.hypot(fx - x, fy - y) < reach) return 'from';
      const length = Math.hypot(tx - fx, ty - fy), along = ((x - fx) * (tx - fx) + (y - fy) * (ty - fy)) / length;
      const across = Math.abs((x - fx) * (ty - fy) - (y - fy) * (tx - fx)) / length;
      return along > 0 && along < length && across < reach / 2 ? 'ray' : 'window';
    };
    const inScene = (place) => {
      const at = plot.window(plot.slice, this.zoom), [x, y] = pixels(place);
      return [at.u(x), at.v(y)];
    };
    onGestures(canvas, {
      down: (place, event) => { held = plot.slice && event.button === 0 ? nearest(place, event) : null; },
      hover: (place, event, isDown) => {
        if (!plot.slice) return;
        this.hover(plot, ...inScene(place));
        if (!isDown) canvas.style.cursor = {from: 'move', to: 'move', ray: 'grab', window: 'crosshair'}[nearest(place, event)];
      },
      drag: (from, to) => {
        if (!held) return;
        const [a, b] = [inScene(from), inScene(to)], move = [b[0] - a[0], b[1] - a[1]];
        if (held !== 'window') this.move(held, move, held === 'ray' ? null : b);
        else if (this.zoom?.axis === plot.slice.axis) this.setZoom({...this.zoom, u: this.zoom.u - move[0], v: this.zoom.v - move[1]});
      },
      pinch: (factor, middle) => plot.slice && this.zoomed(plot, factor, ...inScene(middle)),
      wheel: (lines, place) => plot.slice && this.zoomed(plot, Math.exp(-lines * 0.06), ...inScene(place)),
      leave: () => {
        Object.assign(plot, {under: '', hovered: null});
        this.draw();
      },
    });
    canvas.addEventListener('dblclick', () => this.setZoom(null));
    canvas.addEventListener('keydown', (event) => {
      if (!plot.slice || event.ctrlKey || event.altKey || event.metaKey) return;
      const at = plot.window(plot.slice, this.zoom), [u, v] = [at.u(canvas.width / 2), at.v(canvas.height / 2)];
      if (event.key in ARROWS) {
        const by = ARROWS[event.key].map((part) => part * this.source.planeStep(this.slice, 0.01 * Math.min(canvas.width, canvas.height) / at.scale));
        this.move(event.shiftKey ? 'from' : 'to', by, null);
      } else if (event.key in ZOOMS) this.zoomed(plot, 1.25 ** ZOOMS[event.key], u, v);
      else if (event.key === '0') this.zoomed(plot, 0, u, v);
      else if (event.key === 'Enter' && this.walkPanel.isAsking) this.walkPanel.focusGuess();
      else return;
      event.preventDefault();
    });
  }

  // An end of the ray, or both, by a vector; to a point where one is given.
  move(end, by, to) {
    const moved = (name) => (end === name && to ? to : end === name || end === 'ray' ? [0, 1].map((k) => this.ends[name][k] + by[k]) : this.ends[name]);
    const ends = {from: moved('from'), to: moved('to')};
    if (Math.hypot(ends.to[0] - ends.from[0], ends.to[1] - ends.from[1]) > 0) this.follow(ends);
  }

  hover(plot, u, v) {
    const {slice} = plot;
    const [cu, cv] = [(u - slice.min[0]) / slice.step[0], (v - slice.min[1]) / slice.step[1]];
    const cell = this.slicePanel.cellsOf(this.grids[plot.index]).findLast(([u0, v0, u1, v1]) => cu >= u0 && cu < u1 && cv >= v0 && cv < v1); // of boxes the innermost
    const [i, j] = slice.axes.map((axis) => 'xyz'[axis]);
    const holds = () => cell[6] > 0 && plot.isHierarchy ? `around ${counted(kin(slice.cells, cell).within.length, 'box').replace(/xs$/, 'xes')} here` : counted(cell[4], 'reference');
    const [atU, atV] = sliceSides(slice).map((side, k) => Text.place([u, v][k], side));
    const what = !cell ? 'nothing' : plot.isHierarchy ? `box ${cell[7]}, depth ${cell[5]}` : `voxels ${cell[0]}–${cell[2] - 1}, ${cell[1]}–${cell[3] - 1}`;
    plot.facts.textContent = plot.under = `${i} ${atU}, ${j} ${atV}: ${what}${cell ? `, ${holds()}` : ''}`;
    if (plot.hovered === (cell ?? null)) return;
    plot.hovered = cell ?? null;
    if (plot.isHierarchy) this.draw();
  }
}
