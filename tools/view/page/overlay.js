// Cells over the picture: lines of the scene, projected with the picture's own camera.
'use strict';

const newCanvas = (width, height) => Object.assign(document.createElement('canvas'), {width, height});

// Adds lines through points [x, y] to a path.
function addLines(path, points) {
  points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  return path;
}

class Overlay {
  constructor(canvas) {
    Object.assign(this, {canvas, context: canvas.getContext('2d')});
  }

  // camera, width and height: of the picture that is shown.
  begin(camera, width, height) {
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, {width, height});
    this.context.clearRect(0, 0, width, height);
    this.camera = camera;
    this.axes = Camera.axes(camera);
    this.near = 1e-3 * Camera.distance(camera);
    this.project = Camera.projection(camera, width, height);
    this.unit = Math.max(1, width / Math.max(1, this.canvas.clientWidth)); // pixels of the canvas for one of the page
  }

  // How far a point lies beyond the nearest plane that is drawn; where a segment meets that plane, by these of its ends.
  depth(point) { return Vec.dot(Vec.sub(point, this.camera.from), this.axes.forward) - this.near; }
  static meeting(a, b, da, db) { return Vec.add(a, Vec.scaled(Vec.sub(b, a), da / (da - db))); }

  // The part of a segment in front of the camera.
  segment(path, a, b) {
    const da = this.depth(a), db = this.depth(b);
    if (da < 0 && db < 0) return;
    addLines(path, [da < 0 ? Overlay.meeting(a, b, da, db) : a, db < 0 ? Overlay.meeting(a, b, da, db) : b].map(this.project));
  }

  stroke(path, color, width, alpha = 1) {
    const {context} = this;
    context.globalAlpha = alpha;
    context.strokeStyle = color;
    context.lineWidth = width * this.unit;
    context.stroke(path);
    context.globalAlpha = 1;
  }

  // boxes: [{min, max}], also without thickness.
  boxes(boxes, color, width, alpha) {
    const path = new Path2D();
    for (const {min, max} of boxes) {
      const corner = (i) => [i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]];
      const flat = [1, 2, 4].filter((bit, axis) => min[axis] === max[axis]).reduce((bits, bit) => bits | bit, 0);
      for (let i = 0; i < 8; ++i) {
        for (const bit of [1, 2, 4]) {
          if (!((i | bit) & flat) && !(i & bit)) this.segment(path, corner(i), corner(i | bit));
        }
      }
    }
    this.stroke(path, color, width, alpha);
  }

  // polygons: their corners.
  fill(polygons, color, alpha) {
    const path = new Path2D();
    for (const corners of polygons) {
      const seen = corners.flatMap((a, i) => { // in front of the camera
        const b = corners[(i + 1) % corners.length], da = this.depth(a), db = this.depth(b);
        return [...(da >= 0 ? [a] : []), ...(da * db < 0 ? [Overlay.meeting(a, b, da, db)] : [])];
      });
      if (seen.length > 0) addLines(path, seen.map(this.project)).closePath();
    }
    this.context.globalAlpha = alpha;
    this.context.fillStyle = color;
    this.context.fill(path);
    this.context.globalAlpha = 1;
  }

  lines(lines, color, width, alpha) {
    const path = new Path2D();
    for (const [a, b] of lines) this.segment(path, a, b);
    this.stroke(path, color, width, alpha);
  }

  point(point, color, radius) {
    const [x, y, depth] = this.project(point);
    if (depth < this.near) return;
    const {context} = this;
    context.fillStyle = color;
    context.beginPath();
    context.arc(x, y, radius * this.unit, 0, 7);
    context.fill();
  }

  // x, y: shares of the picture.
  crossHair(x, y, color) {
    const {canvas} = this;
    const px = x * canvas.width, py = y * canvas.height, gap = 5 * this.unit, arm = 16 * this.unit;
    const path = new Path2D();
    for (const [dx, dy] of Object.values(ARROWS)) addLines(path, [gap, arm].map((away) => [px + dx * away, py + dy * away]));
    this.stroke(path, '#000', 3, 0.6);
    this.stroke(path, color, 1.5);
  }
}
