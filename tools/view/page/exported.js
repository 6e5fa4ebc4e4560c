// Where pictures and figures come from in a page that gridview --export wrote: from the page itself.
'use strict';

// The first of those that are least away.
const nearestOf = (all, away) => all.reduce((best, one) => (away(one) < away(best) ? one : best), all[0]);

// Of base64.
function blobOf(text) {
  const bytes = atob(text), array = new Uint8Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) array[i] = bytes.charCodeAt(i);
  return new Blob([array]);
}

class Exported {
  static async from(text) { return new Exported(JSON.parse(new TextDecoder().decode(await inflated(blobOf(text))))); }

  constructor(data) {
    const step = 2 * Math.PI / data.views.length; // from view to view, in radians
    Object.assign(this, {data, isLive: false, opensWith: data.opens_with, size: data.size, step});
  }

  async scene() { return withDivisions(this.data.scene, false); }

  // From the most similar direction.
  view(camera) {
    const direction = ({from, at}) => Vec.normalized(Vec.sub(from, at)), wanted = direction(camera);
    return nearestOf(this.data.views, (view) => -Vec.dot(direction(view.camera), wanted));
  }
  nearest(camera) { return this.view(camera).camera; }

  async picture(view) {
    const all = this.view(view.camera).channels[view.channel];
    const {timing, jpeg = all[0].jpeg, values = all[0].values} = all[view.grid];
    return pictureOf(blobOf(jpeg ?? values), jpeg !== undefined, timing, () => NaN);
  }

  async counts(view) { return this.view(view.camera).counts[view.grid]; }

  // The nearest pixel whose walk was exported, as shares of the picture.
  pixel(shareX, shareY) {
    return [shareX, shareY].map((share, axis) =>
      nearestOf(this.data.pixels[axis].map((at) => (at + 0.5) / this.size[axis]), (at) => Math.abs(at - share)));
  }
  async ray({camera}, x, y) {
    const [columns, rows] = this.data.pixels;
    const {origin, direction} = this.view(camera).walks[rows.indexOf(y) * columns.length + columns.indexOf(x)];
    return {origin, direction};
  }

  // Of a ray, if it was exported.
  walksOf({origin, direction}) {
    if (!this.walks) {
      this.walks = new Map();
      for (const {walks} of this.data.views) for (const one of walks) this.walks.set(String([one.origin, one.direction]), one);
      for (const {points, walks} of this.data.planes) for (const one of walks) {
        const [from, to] = one.ends.map((index) => points[index]);
        this.walks.set(String([from, Vec.sub(to, from)]), one);
      }
    }
    return this.walks.get(String([origin, direction]));
  }
  // The nearest ray whose walk was exported, of those in a slice's plane.
  known(ray) {
    const {origin, direction} = ray, plane = [0, 1, 2].filter((axis) => direction[axis] === 0).map((axis) => this.plane({axis, position: origin[axis]})).find(Boolean);
    if (!plane || this.walksOf(ray)) return ray;
    const [from, to] = this.nearestEnds(plane, origin, Vec.add(origin, direction));
    return {...ray, origin: from, direction: Vec.sub(to, from)};
  }

  async walk(grid, {origin, direction}) {
    const found = this.walksOf({origin, direction});
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
  plane(slice) {
    return nearestOf(this.data.planes.filter(({axis}) => axis === slice.axis), ({position}) => Math.abs(position - slice.position));
  }
  // Of the plane's rays.
  nearestEnds({points, walks}, from, to) {
    const away = ({ends}) => Vec.length(Vec.sub(points[ends[0]], from)) ** 2 + Vec.length(Vec.sub(points[ends[1]], to)) ** 2;
    return nearestOf(walks, away).ends.map((index) => points[index]);
  }
  planeEnds(slice, {from, to}) {
    const ends = this.nearestEnds(this.plane(slice), ...[from, to].map(([u, v]) => slicePoint(slice, u, v)));
    const [start, end] = ends.map((point) => slice.axes.map((axis) => point[axis]));
    return {from: start, to: end};
  }
  // From point to point.
  planeStep(slice) { return Math.max(...sliceSides(slice)) / this.data.points_per_side * 0.75; }

  async statistics(grid) { return this.data.statistics[grid]; }
  async boxes(grid, depth) { return this.data.boxes[grid][depth === null ? 0 : depth + 1]; }
  // The nearest of the same axis, or of any where it has none.
  sliceAt({axis, share}) {
    const {planes} = this.data, same = planes.filter((plane) => plane.axis === axis), all = same.length > 0 ? same : planes;
    const nearest = nearestOf(all, (plane) => Math.abs(plane.share - share));
    return {axis: nearest.axis, share: nearest.share};
  }
  async slice(grid, axis, share) {
    const index = this.data.planes.findIndex((plane) => plane.axis === axis && plane.share === share);
    return {...this.data.slices[0][index], ...this.data.slices[grid][index]}; // with the first one's outline
  }
}
