// A slice: the cells that a plane cuts, coloured by what they list, with the outline of the geometry.
'use strict';

// Colours of numbers, as the server has them.
class ColorScale {
  constructor(samples) { this.samples = samples; }
  // position: 0 to 1.
  at(position) {
    const last = this.samples.length - 1;
    return this.samples[Math.round(last * Math.max(0, Math.min(1, position)))];
  }
  gradient() { return `linear-gradient(to right, ${this.samples.join()})`; }
}

// As points of the scene: corners of a slice's rectangles.
function slicePoint(slice, u, v) {
  const point = [0, 0, 0];
  point[slice.axis] = slice.position;
  point[slice.axes[0]] = u;
  point[slice.axes[1]] = v;
  return point;
}
const sliceU = (slice, voxel) => slice.min[0] + voxel * slice.step[0];
const sliceV = (slice, voxel) => slice.min[1] + voxel * slice.step[1];

// The edges of its cells as segments of the scene, each once where neighbours share it whole.
function sliceLines(slice, most) {
  const lines = [];
  const seen = new Set();
  const add = (u0, v0, u1, v1) => {
    const key = `${u0},${v0},${u1},${v1}`;
    if (seen.has(key)) return;
    seen.add(key);
    lines.push([slicePoint(slice, sliceU(slice, u0), sliceV(slice, v0)), slicePoint(slice, sliceU(slice, u1), sliceV(slice, v1))]);
  };
  for (const [u0, v0, u1, v1] of slice.cells) {
    if (lines.length >= most) break;
    add(u0, v0, u1, v0);
    add(u0, v1, u1, v1);
    add(u0, v0, u0, v1);
    add(u1, v0, u1, v1);
  }
  return lines;
}

class SlicePanel {
  // changed(slice): a slice was loaded; settings: {axis, share} of the page.
  constructor(root, source, colors, settings, changed) {
    Object.assign(this, {root, source, colors, settings, changed, slices: new Map(), abort: null});
    this.axis = element('select', {'aria-label': 'Axis of the slice', onchange: () => this.set({axis: Number(this.axis.value)})},
      ...['x', 'y', 'z'].map((name, i) => element('option', {value: i}, name)));
    this.slider = element('input', {type: 'range', min: 0, max: 1, step: 0.0025, 'aria-label': 'Position of the slice',
      oninput: () => this.set({share: Number(this.slider.value)})});
    this.position = element('output', {});
    this.plots = element('div');
    root.append(element('div', {class: 'controls'}, this.axis, this.slider), this.position, this.plots);
  }

  set(change) {
    Object.assign(this.settings, change);
    this.load();
  }

  // grids: indices of the grids that are shown, and their names.
  show(grids, names) {
    this.grids = grids;
    this.names = names;
    this.load();
  }

  key() { return `${this.settings.axis} ${this.settings.share} ${this.grids.join()}`; }

  // The newest wish, one at a time.
  async load() {
    this.axis.value = this.settings.axis;
    this.slider.value = this.settings.share;
    if (this.isLoading) return;
    this.isLoading = true;
    try {
      while (this.wanted() && this.shownKey !== this.key()) {
        const key = this.key();
        const loaded = [];
        for (const grid of this.grids) loaded.push(await this.source.slice(grid, this.settings.axis, this.settings.share));
        this.shownKey = key;
        this.slices = new Map(this.grids.map((grid, i) => [grid, loaded[i]]));
        this.draw();
        this.changed();
      }
    } catch (error) {
      this.position.textContent = error.message;
    } finally {
      this.isLoading = false;
    }
  }

  // Nobody looks at it otherwise.
  wanted() { return this.root.parentElement.open || this.isOverlaid; }

  of(grid) { return this.slices.get(grid); }

  draw() {
    const first = this.slices.values().next().value;
    const axis = 'xyz'[first.axis];
    this.position.textContent = `${axis} = ${Text.number(first.position)} of ${Text.number(first.range[0])} to ${Text.number(first.range[1])}`;
    this.plots.replaceChildren(...this.grids.flatMap((grid, i) => this.plot(this.slices.get(grid), this.names[i])));
  }

  plot(slice, name) {
    const [width, height] = [slice.voxels[0] * slice.step[0], slice.voxels[1] * slice.step[1]];
    const pixels = 700;
    const scale = Math.min(pixels / width, pixels / height);
    const canvas = element('canvas', {class: 'slice', role: 'img'});
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext('2d', {alpha: false});
    context.fillStyle = '#fff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    const most = slice.cells.reduce((sofar, cell) => Math.max(sofar, cell[4]), 1);
    const x = (voxel) => voxel * slice.step[0] * scale, y = (voxel) => canvas.height - voxel * slice.step[1] * scale;
    const lines = new Path2D();
    for (const [u0, v0, u1, v1, references] of slice.cells) {
      const [left, top, w, h] = [x(u0), y(v1), x(u1) - x(u0), y(v0) - y(v1)];
      if (references > 0) {
        context.fillStyle = this.colors.at(1 - Math.log(1 + references) / Math.log(1 + most));
        context.fillRect(left, top, w + 0.5, h + 0.5);
      }
      if (w > 3 && h > 3) lines.rect(left, top, w, h);
    }
    context.strokeStyle = 'rgba(0, 0, 0, 0.35)';
    context.lineWidth = 0.7;
    context.stroke(lines);
    const outline = new Path2D();
    for (const [u0, v0, u1, v1] of slice.outline) {
      outline.moveTo((u0 - slice.min[0]) * scale, canvas.height - (v0 - slice.min[1]) * scale);
      outline.lineTo((u1 - slice.min[0]) * scale, canvas.height - (v1 - slice.min[1]) * scale);
    }
    context.strokeStyle = '#d9480f';
    context.lineWidth = 1.2;
    context.stroke(outline);
    const occupied = slice.cells.filter((cell) => cell[4] > 0).length;
    const [u, v] = slice.axes.map((axis) => 'xyz'[axis]);
    const facts = `${name}: ${Text.count(slice.cells.length)} cells${occupied < slice.cells.length ? `, ${Text.count(occupied)} occupied` : ' occupied'}, at most ${Text.count(most)} references${slice.truncated ? '; not all are drawn' : ''}`;
    canvas.setAttribute('aria-label', facts);
    const hover = element('p', {class: 'note'}, `${u} to the right, ${v} up; darker: more references; orange: the geometry`);
    const usual = hover.textContent;
    canvas.addEventListener('pointermove', (event) => {
      const box = canvas.getBoundingClientRect();
      const cu = (event.clientX - box.left) / box.width * slice.voxels[0], cv = (1 - (event.clientY - box.top) / box.height) * slice.voxels[1];
      const cell = slice.cells.find(([u0, v0, u1, v1]) => cu >= u0 && cu < u1 && cv >= v0 && cv < v1);
      hover.textContent = `${u} = ${Text.number(sliceU(slice, cu))}, ${v} = ${Text.number(sliceV(slice, cv))}: ` +
        (cell ? `voxels ${cell[0]}–${cell[2] - 1}, ${cell[1]}–${cell[3] - 1}, ${cell[4]} references` : 'empty');
    });
    canvas.addEventListener('pointerleave', () => { hover.textContent = usual; });
    return [element('p', {class: 'facts-line'}, facts), canvas, hover];
  }
}
