// Where pictures and figures come from in a page that gridview --export wrote: from the page itself.
'use strict';

class Exported {
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
    const one = all[view.grid];
    const image = new Image();
    image.src = one.image || all[0].image;
    await image.decode();
    return {image, rays: one.rays, precision: one.precision, range: one.range || null, milliseconds: {...one.milliseconds, total: NaN}};
  }

  async counts(view) { return this.data.views[this.index(view.camera)].counts[view.grid]; }
  // Of the pixel in the middle, the only one that there is.
  async ray({camera}) {
    const {origin, direction} = this.data.views[this.index(camera)].walks[0].rays[0];
    return {origin, direction};
  }
  async walk(grid, {origin, direction}) {
    const isSame = ({rays: [first]}) => String([first.origin, first.direction]) === String([origin, direction]);
    const view = this.data.views.find(({walks}) => isSame(walks[0]));
    if (!view) throw new Error('The walk of this ray wasn’t exported.');
    return view.walks[grid];
  }
  async statistics(grid) { return this.data.statistics[grid]; }
  async boxes(grid, depth) { return this.data.boxes[grid][depth === null ? 0 : depth + 1]; }
  async slice(grid, axis, share) {
    const {shares} = this.data;
    const distances = shares.map((one) => Math.abs(one - share));
    return this.data.slices[grid][axis * shares.length + distances.indexOf(Math.min(...distances))];
  }
}
