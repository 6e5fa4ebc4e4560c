// Slices: the cells or boxes that a plane cuts, with the outline of the geometry; and which boxes lie over the pictures.
'use strict';

// As points of the scene: corners of a slice's rectangles.
const slicePoint = ({axis, axes, position}, u, v) =>
  [0, 1, 2].map((one) => (one === axis ? position : one === axes[0] ? u : v));
// A cell's or box's rectangle, as a box without thickness.
const sliceBox = (slice, [u0, v0, u1, v1]) => ({min: slicePoint(slice, sliceU(slice, u0), sliceV(slice, v0)), max: slicePoint(slice, sliceU(slice, u1), sliceV(slice, v1))});
const sliceSides = ({voxels, step}) => [voxels[0] * step[0], voxels[1] * step[1]];
const sliceU = (slice, voxel) => slice.min[0] + voxel * slice.step[0];
const sliceV = (slice, voxel) => slice.min[1] + voxel * slice.step[1];

class SlicePanel {
  // moved(): other settings; changed(): slices or boxes were loaded; settings: {axis, share, depth} of the page, depth null for any.
  constructor(root, source, settings, moved, changed) {
    Object.assign(this, {root, source, settings, moved, changed, loaded: new Map(), slices: new Map(), boxes: new Map()});
    this.axis = element('select', {'aria-label': 'Axis of the slice', onchange: () => this.set({axis: Number(this.axis.value)})},
      ...['x', 'y', 'z'].map((name, i) => element('option', {value: i}, name)));
    this.slider = element('input', {type: 'range', min: 0, max: 1, step: 0.0025, 'aria-label': 'Position of the slice',
      oninput: () => this.set({share: Number(this.slider.value)})});
    this.depth = element('input', {class: 'depth', type: 'range', min: -1, step: 1,
      'aria-label': 'Depth of cells and boxes; the least: all',
      oninput: () => this.set({depth: this.depth.value < 0 ? null : Number(this.depth.value)})});
    this.depthText = element('output', {});
    this.depths = element('label', {class: 'controls'}, 'Depth', this.depth, this.depthText);
    this.position = element('output', {});
    this.boxesText = element('p', {class: 'note'});
    this.place = element('div', {class: 'controls'}, this.axis, this.slider, this.position);
    root.append(this.place, this.depths, this.boxesText);
  }

  set(change) {
    Object.assign(this.settings, change);
    Object.assign(this.settings, this.source.sliceAt(this.settings));
    this.moved();
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
      ...(this.hasSlices // nobody looks at them otherwise
        ? [{grid, kind: 'slices', key: `slice ${grid} ${axis} ${share}`, get: () => this.source.slice(grid, axis, share)}] : []),
      ...(this.hasBoxes ? [{grid, kind: 'boxes', key: `boxes ${grid} ${this.depthOf(grid)}`, get: () => this.source.boxes(grid, this.depthOf(grid))}] : [])]);
  }

  keyOf(parts) { return `${this.settings.depth} ${parts.map(({key}) => key).join()}`; }
  // Whether what is loaded is what is wanted.
  get isCurrent() { return this.shownKey === this.keyOf(this.parts()); }

  // The newest wish, one at a time.
  async load() {
    this.axis.value = this.settings.axis;
    this.slider.value = this.settings.share;
    this.depth.max = Math.max(...this.structures.map((one) => one.greatest_depth));
    this.depth.value = this.settings.depth ?? -1;
    this.depthText.textContent = this.settings.depth ?? 'all';
    this.depth.setAttribute('aria-valuetext', this.depthText.textContent);
    this.place.hidden = !this.hasSlices;
    this.depths.hidden = !(this.depth.max > 0 && (this.hasSlices || this.hasBoxes));
    if (!this.hasBoxes) this.boxesText.textContent = this.hasSlices ? '' : 'Cells: slice or boxes draws them over the picture.';
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
        const shownKey = this.keyOf(parts);
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

  // The most references of what is shown: one range of colours for all slices.
  most() {
    return this.grids.filter((grid) => this.of(grid)).flatMap((grid) => this.cellsOf(grid)).reduce((sofar, cell) => Math.max(sofar, cell[4]), 1);
  }

  draw() {
    const inOrder = (kind) => this.grids.map((grid, i) => [grid, i]).filter(([grid]) => this[kind].has(grid));
    if (this.boxes.size > 0) this.boxesText.textContent = inOrder('boxes').map(([grid, i]) => {
      const {boxes, count, depth} = this.boxes.get(grid), isReduced = depth !== this.depthOf(grid); // all would be too many
      return `${this.names[i]}: ${isReduced || boxes.length === count ? '' : `${Text.count(boxes.length)} of `}${Text.count(isReduced ? boxes.length : count)} boxes over the picture` +
        (isReduced ? `, down to depth ${depth}: all are ${Text.count(count)}` : '');
    }).join('; ') + (this.settings.depth !== 0 ? '; lighter, the deeper' : '');
    const [shown] = inOrder('slices');
    if (!shown) return;
    const {axis, position, range} = this.of(shown[0]);
    const [at, low, high] = [position, ...range].map((value) => Text.place(value, range[1] - range[0]));
    this.position.textContent = `${'xyz'[axis]} = ${at} of ${low} to ${high}`;
  }
}

// Its cells that list something, as polygons of the scene by their colour; most: references of the darkest.
function sliceColors(slice, cells, colors, most) {
  const byColor = new Map();
  for (const cell of cells.filter(([, , , , references]) => references > 0)) {
    const {min, max} = sliceBox(slice, cell), [i, j] = slice.axes, corner = (u, v) => slicePoint(slice, u[i], v[j]);
    const color = colors.at(Math.log(cell[4]) / Math.log(Math.max(2, most)));
    byColor.set(color, [...byColor.get(color) || [], [corner(min, min), corner(max, min), corner(max, max), corner(min, max)]]);
  }
  return byColor;
}

// In words; cells: of the depth that is shown.
function sliceFacts(slice, cells, structure) {
  const isHierarchy = structure.structure === 'bvh';
  const occupied = cells.filter((cell) => cell[4] > 0).length;
  return `${Text.count(occupied)} of ${counted(cells.length, isHierarchy ? 'box' : 'cell').replace(/xs$/, 'xes')} list primitives, ` +
    `at most ${Text.count(cells.reduce((sofar, cell) => Math.max(sofar, cell[4]), 0))}` +
    `${slice.without_empty ? '; the empty ones are too many to be drawn' : ''}${slice.truncated ? '; not all are drawn' : ''}`;
}
