// Mouse, fingers and wheel over an element; the keys that are arrows.
'use strict';

const CLICK_REACH = 4; // pixels that a pointer may move between down and up
const ZOOMS = {'+': 1, '=': 1, '-': -1, _: -1}; // nearer, or farther away
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

// Places are [x, y] in pixels from the element's top left. down(place, event), hover(place, event, is down), drag(from, to,
// event), of two fingers pinch(factor, middle, move), wheel(lines, place), click(place, event), leave().
function onGestures(element, {down, hover, drag, pinch, wheel, click, leave}) {
  const pointers = new Map(); // by id: places
  let moved = 0;
  const placeOf = (event) => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const between = (a, b) => [b[0] - a[0], b[1] - a[1]];
  element.addEventListener('pointerdown', (event) => {
    if (event.button > 2) return;
    element.focus({preventScroll: true});
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, placeOf(event));
    moved = pointers.size > 1 ? Infinity : 0;
    down?.(placeOf(event), event);
    event.preventDefault();
  });
  element.addEventListener('pointermove', (event) => {
    const now = placeOf(event), old = pointers.get(event.pointerId);
    hover(now, event, Boolean(old));
    if (!old) return;
    const move = between(old, now);
    moved += Math.hypot(...move);
    if (moved < CLICK_REACH) return;
    pointers.set(event.pointerId, now);
    if (pointers.size !== 2) return drag(old, now, event);
    const [, other] = [...pointers].find(([id]) => id !== event.pointerId);
    const before = Math.hypot(...between(old, other)), after = Math.hypot(...between(now, other));
    pinch(before > 0 && after > 0 ? after / before : 1, [0, 1].map((k) => (now[k] + other[k]) / 2), move);
  });
  const end = (event) => {
    if (pointers.delete(event.pointerId) && event.type === 'pointerup' && moved < CLICK_REACH && event.button === 0) click?.(placeOf(event), event);
  };
  element.addEventListener('pointerup', end);
  element.addEventListener('pointercancel', end);
  element.addEventListener('pointerleave', leave);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    wheel(Math.max(-8, Math.min(8, event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY)), placeOf(event));
  }, {passive: false});
}
