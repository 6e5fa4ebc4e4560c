// Cameras: how the mouse and keys move them, and where points of the scene are in their picture. The same
// arithmetic as renderer/camera.h.
'use strict';

const Vec = {
  add: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
  sub: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
  scaled: (a, s) => [a[0] * s, a[1] * s, a[2] * s],
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  length: (a) => Math.hypot(a[0], a[1], a[2]),
  normalized: (a) => Vec.scaled(a, 1 / Vec.length(a)),
  // About an axis of length 1 (Rodrigues).
  rotated(a, axis, angle) {
    const c = Math.cos(angle), s = Math.sin(angle);
    return Vec.add(Vec.add(Vec.scaled(a, c), Vec.scaled(Vec.cross(axis, a), s)),
                   Vec.scaled(axis, Vec.dot(axis, a) * (1 - c)));
  },
};

// t at which a ray enters and leaves a box, from its origin on; it misses the box where it would leave before.
function intervalIn({min, max}, {origin, direction}) {
  let enter = 0, exit = Infinity;
  for (let axis = 0; axis < 3; ++axis) {
    if (direction[axis] === 0) continue; // a ray in a slice, of a box that the slice cuts
    const [a, b] = [min[axis], max[axis]].map((plane) => (plane - origin[axis]) / direction[axis]);
    enter = Math.max(enter, Math.min(a, b));
    exit = Math.min(exit, Math.max(a, b));
  }
  return [enter, exit];
}

// A camera is {from, at, up, angle}: angle in degrees spans the picture's height.
const Camera = {
  distance: (camera) => Vec.length(Vec.sub(camera.from, camera.at)),

  // Of length 1.
  axes(camera) {
    const forward = Vec.normalized(Vec.sub(camera.at, camera.from));
    const right = Vec.normalized(Vec.cross(forward, camera.up));
    return {forward, right, up: Vec.cross(right, forward)};
  },

  // Around `at`, in radians: to the right as seen from above, and up. Never over the poles.
  orbited(camera, right, up) {
    const axis = Vec.normalized(camera.up);
    const offset = Vec.rotated(Vec.sub(camera.from, camera.at), axis, right);
    const elevation = Math.asin(Math.max(-1, Math.min(1, Vec.dot(Vec.normalized(offset), axis))));
    const limit = Math.PI / 2 - 0.01;
    const turn = Math.max(-limit, Math.min(limit, elevation + up)) - elevation;
    const side = Vec.normalized(Vec.cross(axis, offset));
    return {...camera, from: Vec.add(camera.at, Vec.rotated(offset, side, -turn))};
  },

  // By shares of the picture's height.
  panned(camera, right, up) {
    const axes = Camera.axes(camera);
    const height = 2 * Camera.distance(camera) * Math.tan(camera.angle * Math.PI / 360);
    const move = Vec.add(Vec.scaled(axes.right, right * height), Vec.scaled(axes.up, up * height));
    return {...camera, from: Vec.add(camera.from, move), at: Vec.add(camera.at, move)};
  },

  // The distance becomes `factor` times as large.
  zoomed(camera, factor) {
    const offset = Vec.scaled(Vec.sub(camera.from, camera.at), factor);
    const distance = Vec.length(offset);
    return distance > 1e-9 && distance < 1e9 ? {...camera, from: Vec.add(camera.at, offset)} : camera;
  },

  // Orbits around `point` from now on.
  centered(camera, point) {
    const depth = Vec.dot(Vec.sub(point, camera.from), Camera.axes(camera).forward);
    return depth > 0 ? {...camera, at: point} : camera;
  },

  // A function from points to [x, y, depth]: pixels from the top left, depth along the line of sight.
  projection(camera, width, height) {
    const axes = Camera.axes(camera);
    const toPixels = height / 2 / Math.tan(camera.angle * Math.PI / 360);
    return (point) => {
      const offset = Vec.sub(point, camera.from);
      const depth = Vec.dot(offset, axes.forward);
      return [width / 2 + Vec.dot(offset, axes.right) / depth * toPixels,
              height / 2 - Vec.dot(offset, axes.up) / depth * toPixels, depth];
    };
  },

  same: (a, b) => ['from', 'at', 'up', 'angle'].every((part) => String(a[part]) === String(b[part])),
};
