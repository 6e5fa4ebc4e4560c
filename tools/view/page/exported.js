// Where pictures and figures come from in a page that gridview --export wrote: from the page itself.
'use strict';

const nearestTo = (values, wanted) => values.reduce((best, value) => (Math.abs(value - wanted) < Math.abs(best - wanted) ? value : best));

// Of base64.
function blobOf(text) {
  const bytes = atob(text), array = new Uint8Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) array[i] = bytes.charCodeAt(i);
  return new Blob([array]);
}

class Exported {
  static async from(text) { return new Exported(JSON.parse(new TextDecoder().decode(await inflated(blobOf(text))))); }

  constructor(data) {
    this.data = data;
    this.isLive = false;
    this.size = data.size;
    this.step = 2 * Math.PI / data.views.length; // from view to view, in radians
  }

  async scene() { return this.data.scene; }

  // The index of the view from the most similar direction.
  index(camera) {
    const direction = (one) => Vec.normalized(Vec.sub(one.from, one.at));
    const wanted = direction(camera);
    const likeness = this.data.views.map((view) => Vec.dot(direction(view.camera), wanted));
    return likeness.indexOf(Math.max(...likeness));
  }
  nearest(camera) { return this.data.views[this.index(camera)].camera; }

  async picture(view) {
    const all = this.data.views[this.index(view.camera)].channels[view.channel];
    const {timing, jpeg = all[0].jpeg, values = all[0].values} = all[view.grid];
    const {precision, rays, ...milliseconds} = readTiming(timing);
    const blob = blobOf(jpeg ?? values);
    return {image: jpeg ? await createImageBitmap(blob) : null, values: jpeg ? null : new Float32Array(await inflated(blob)), precision, rays, milliseconds: {...milliseconds, total: NaN}};
  }

  async counts(view) { return this.data.views[this.index(view.camera)].counts[view.grid]; }

  // The nearest pixel whose walk was exported, as shares of the picture.
  pixel(shareX, shareY) {
    return [shareX, shareY].map((share, axis) => {
      const middles = this.data.pixels[axis].map((at) => (at + 0.5) / this.size[axis]);
      return nearestTo(middles, share);
    });
  }
  async ray({camera}, x, y) {
    const [columns, rows] = this.data.pixels;
    const {origin, direction} = this.data.views[this.index(camera)].walks[rows.indexOf(y) * columns.length + columns.indexOf(x)];
    return {origin, direction};
  }

  async walk(grid, {origin, direction}) {
    const key = String([origin, direction]);
    if (!this.walks) {
      this.walks = new Map();
      for (const {walks} of this.data.views) for (const one of walks) this.walks.set(String([one.origin, one.direction]), one);
      for (const {points, walks} of this.data.planes) for (const one of walks) {
        const [from, to] = one.ends.map((index) => points[index]);
        this.walks.set(String([from, Vec.sub(to, from)]), one);
      }
    }
    const found = this.walks.get(key);
    if (!found) throw new Error('The walk of this ray wasn’t exported.');
    const {hit, grids} = found, {cells, tests, ended, steps} = grids[grid];
    const ray = {kind: 'camera', origin, direction, cells, tests, hit: hit && {...hit, position: Vec.add(origin, Vec.scaled(direction, hit.t))}, steps: []};
    for (const [written, count, isKept] of steps) {
      const place = this.place(grid, written), [enter, exit] = intervalIn(place.box, ray);
      ray.steps.push({voxels: null, node: null, ...place, enter, exit,
        tests: Array.from({length: count}, (_, k) => ({primitive: null, t: null, kept: k === 0 && isKept}))});
    }
    return {rays: [ray], ended: [ended], more_rays: 0};
  }
  // A cell is written as the corners of its voxels, [first, end].
  place(grid, written) {
    if (!Array.isArray(written)) return written;
    const {min, step} = this.data.layouts[grid], [first, end] = written;
    const corner = (voxel) => voxel.map((at, axis) => min[axis] + at * step[axis]);
    return {voxels: {first, end}, box: {min: corner(first), max: corner(end)}};
  }
  // A slice's points between which walks were exported: on its four sides in turn, each as many.
  planePoints(slice) {
    return this.data.planes.find(({axis, position}) => axis === slice.axis && position === slice.position).points.map((point) => slice.axes.map((axis) => point[axis]));
  }
  // The nearest two of different sides.
  planeEnds(slice, {from, to}) {
    const points = this.planePoints(slice), side = (index) => Math.floor(4 * index / points.length);
    const nearest = ([u, v], isAllowed) => points.map(([pu, pv], index) => [isAllowed(index) ? Math.hypot(pu - u, pv - v) : Infinity, index]).sort((a, b) => a[0] - b[0])[0][1];
    const target = nearest(to, () => true), start = nearest(from, (index) => side(index) !== side(target));
    return {from: points[start], to: points[target]};
  }
  // From point to point.
  planeStep(slice) { return Math.max(...slice.axes.map((axis, k) => slice.voxels[k] * slice.step[k])) / (this.planePoints(slice).length / 4) * 0.75; }

  async statistics(grid) { return this.data.statistics[grid]; }
  async boxes(grid, depth) { return this.data.boxes[grid][depth === null ? 0 : depth + 1]; }
  shareOf(share) { return nearestTo(this.data.shares, share); }
  async slice(grid, axis, share) {
    const {shares} = this.data;
    return this.data.slices[grid][axis * shares.length + shares.indexOf(this.shareOf(share))];
  }
}
