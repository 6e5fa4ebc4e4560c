// Slices: the cells or boxes that a plane cuts, coloured by what they list, with the outline of the geometry; and
// which boxes lie over the pictures.
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
  reversed() { return new ColorScale([...this.samples].reverse()); }
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

// The edges of cells of a slice as segments of the scene, each once where neighbours share it whole.
function sliceLines(slice, cells, most) {
  const lines = [];
  const seen = new Set();
  const add = (u0, v0, u1, v1) => {
    const key = `${u0},${v0},${u1},${v1}`;
    if (seen.has(key)) return;
    seen.add(key);
    lines.push([slicePoint(slice, sliceU(slice, u0), sliceV(slice, v0)), slicePoint(slice, sliceU(slice, u1), sliceV(slice, v1))]);
  };
  for (const [u0, v0, u1, v1] of cells) {
    if (lines.length >= most) break;
    add(u0, v0, u1, v0);
    add(u0, v1, u1, v1);
    add(u0, v0, u0, v1);
    add(u1, v0, u1, v1);
  }
  return lines;
}

class SlicePanel {
  // changed(): slices or boxes were loaded; settings: {axis, share, depth} of the page, depth null for any.
  constructor(root, source, colors, settings, changed) {
    Object.assign(this, {root, source, colors: colors.reversed(), settings, changed, loaded: new Map(), slices: new Map(), boxes: new Map()});
    this.axis = element('select', {'aria-label': 'Axis of the slice', onchange: () => this.set({axis: Number(this.axis.value)})},
      ...['x', 'y', 'z'].map((name, i) => element('option', {value: i}, name)));
    this.slider = element('input', {type: 'range', min: 0, max: 1, step: 0.0025, 'aria-label': 'Position of the slice',
      oninput: () => this.set({share: Number(this.slider.value)})});
    this.depth = element('input', {class: 'depth', type: 'range', min: -1, step: 1, oninput: () => {
      const depth = Number(this.depth.value);
      this.set({depth: depth < 0 ? null : depth});
    }});
    this.depthText = element('output', {});
    this.depths = element('label', {class: 'controls'}, 'Depth', this.depth, this.depthText);
    this.position = element('output', {});
    this.boxesText = element('p', {class: 'note'});
    this.plots = element('div');
    root.append(element('div', {class: 'controls'}, this.axis, this.slider), this.depths, this.boxesText, this.position, this.plots);
  }

  set(change) {
    Object.assign(this.settings, change);
    this.load();
  }

  // grids: indices of the grids that are shown, their names, and scene.grids of each.
  show(grids, names, structures) {
    Object.assign(this, {grids, names, structures});
    this.load();
  }

  // Of a grid's cells or boxes that are shown, null for any: a grid whose cells have one depth shows all of them.
  depthOf(grid) { return this.structures[this.grids.indexOf(grid)]?.greatest_depth > 0 ? this.settings.depth : null; }

  // What is shown, and how it is loaded: {grid, kind, key, get}.
  parts() {
    const {axis, share} = this.settings;
    return this.grids.flatMap((grid) => [
      ...(this.isOverlaid || this.root.parentElement.open // nobody looks at it otherwise
        ? [{grid, kind: 'slices', key: `slice ${grid} ${axis} ${share}`, get: () => this.source.slice(grid, axis, share)}] : []),
      ...(this.hasBoxes ? [{grid, kind: 'boxes', key: `boxes ${grid} ${this.depthOf(grid)}`, get: () => this.source.boxes(grid, this.depthOf(grid))}] : [])]);
  }

  // The newest wish, one at a time.
  async load() {
    this.axis.value = this.settings.axis;
    this.slider.value = this.settings.share;
    this.depth.max = Math.max(...this.structures.map((one) => one.greatest_depth));
    this.depth.value = this.settings.depth ?? -1;
    this.depthText.textContent = this.settings.depth ?? 'all';
    this.depth.setAttribute('aria-label', 'Depth of cells and boxes; the least: all');
    this.depth.setAttribute('aria-valuetext', this.depthText.textContent);
    this.depths.hidden = !(this.depth.max > 0);
    if (this.isLoading) return;
    this.isLoading = true;
    try {
      for (;;) {
        const parts = this.parts();
        const missing = parts.find(({key}) => !this.loaded.has(key));
        if (missing) {
          this.loaded.set(missing.key, await missing.get());
          continue;
        }
        const shownKey = `${this.settings.depth} ${parts.map(({key}) => key).join()}`;
        if (parts.length === 0 || shownKey === this.shownKey) break;
        this.shownKey = shownKey;
        this.loaded = new Map(parts.map(({key}) => [key, this.loaded.get(key)]));
        for (const kind of ['slices', 'boxes'])
          this[kind] = new Map(parts.filter((part) => part.kind === kind).map(({grid, key}) => [grid, this.loaded.get(key)]));
        this.draw();
        this.changed();
      }
    } catch (error) {
      this.position.textContent = error.message;
    } finally {
      this.isLoading = false;
    }
  }

  // Null where it isn't loaded.
  of(grid) { return this.slices.get(grid) || null; }
  boxesOf(grid) { return this.boxes.get(grid) || null; }
  // Of a grid's slice those of the depth that is shown.
  cellsOf(grid) {
    const depth = this.depthOf(grid);
    return this.of(grid).cells.filter((cell) => depth === null || cell[5] === depth);
  }

  draw() {
    const inOrder = (kind) => this.grids.map((grid, i) => [grid, i]).filter(([grid]) => this[kind].has(grid));
    this.boxesText.textContent = inOrder('boxes').map(([grid, i]) => {
      const {boxes, count} = this.boxes.get(grid);
      return `${this.names[i]}: ${count > boxes.length ? `the first ${Text.count(boxes.length)} of ` : ''}${Text.count(count)} boxes over the picture`;
    }).join('; ');
    const shown = inOrder('slices');
    if (shown.length === 0) return;
    const first = this.of(shown[0][0]);
    const axis = 'xyz'[first.axis];
    this.position.textContent = `${axis} = ${Text.number(first.position)} of ${Text.number(first.range[0])} to ${Text.number(first.range[1])}`;
    // One range of colours for all.
    const most = shown.flatMap(([grid]) => this.cellsOf(grid)).reduce((sofar, cell) => Math.max(sofar, cell[4]), 1);
    const scale = element('div', {class: 'slice-scale'}, 'references 0', element('span', {class: 'colors', 'aria-hidden': true}), Text.count(most));
    scale.querySelector('.colors').style.backgroundImage = this.colors.gradient();
    this.plots.replaceChildren(scale, ...shown.flatMap(([grid, i]) => this.plot(this.of(grid), this.cellsOf(grid), most, this.names[i], this.structures[i])));
  }

  plot(slice, cells, most, name, structure) {
    const [width, height] = [slice.voxels[0] * slice.step[0], slice.voxels[1] * slice.step[1]];
    const pixels = 700;
    const scale = Math.min(pixels / width, pixels / height);
    const canvas = element('canvas', {class: 'slice', role: 'img'});
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext('2d', {alpha: false});
    context.fillStyle = '#fff';
    context.fillRect(0, 0, canvas.width, canvas.height);
    const x = (voxel) => voxel * slice.step[0] * scale, y = (voxel) => canvas.height - voxel * slice.step[1] * scale;
    const lines = new Path2D();
    for (const [u0, v0, u1, v1, references] of cells) {
      const [left, top, w, h] = [x(u0), y(v1), x(u1) - x(u0), y(v0) - y(v1)];
      if (references > 0) {
        context.fillStyle = this.colors.at(Math.log(1 + references) / Math.log(1 + most));
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
    const occupied = cells.filter((cell) => cell[4] > 0).length;
    const [u, v] = slice.axes.map((axis) => 'xyz'[axis]);
    const isHierarchy = structure.structure === 'bvh';
    const facts = `${name}: ${Text.count(cells.length)} ${isHierarchy ? 'boxes' : 'cells'}, ${Text.count(occupied)} ${isHierarchy ? 'of references' : 'occupied'}, at most ${Text.count(cells.reduce((sofar, cell) => Math.max(sofar, cell[4]), 0))} references${slice.without_empty ? '; the empty ones are too many to be drawn' : ''}${slice.truncated ? '; not all are drawn' : ''}`;
    canvas.setAttribute('aria-label', facts);
    const hover = element('p', {class: 'note'}, `${u} to the right, ${v} up; darker: more references; orange: the geometry`);
    const usual = hover.textContent;
    canvas.addEventListener('pointermove', (event) => {
      const box = canvas.getBoundingClientRect();
      const cu = (event.clientX - box.left) / box.width * slice.voxels[0], cv = (1 - (event.clientY - box.top) / box.height) * slice.voxels[1];
      const cell = cells.findLast(([u0, v0, u1, v1]) => cu >= u0 && cu < u1 && cv >= v0 && cv < v1); // of boxes the innermost
      const place = !cell ? 'empty' : isHierarchy ? `box ${cell[7]}, depth ${cell[5]}` : `voxels ${cell[0]}–${cell[2] - 1}, ${cell[1]}–${cell[3] - 1}`;
      hover.textContent = `${u} = ${Text.number(sliceU(slice, cu))}, ${v} = ${Text.number(sliceV(slice, cv))}: ${place}${cell && (cell[4] > 0 || !isHierarchy) ? `, ${cell[4]} references` : ''}`;
    });
    canvas.addEventListener('pointerleave', () => { hover.textContent = usual; });
    return [element('p', {class: 'facts-line'}, facts), canvas, hover];
  }
}
