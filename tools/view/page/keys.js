// The keyboard: of the page, of a picture and of its cross hair.
'use strict';

const KEY_ORBIT = 0.05, KEY_PAN = 0.03, KEY_ZOOM = 1.08;

function keyOfPicture(pane, event) {
  if (event.key === 'Escape' && !$('keys-list').hidden) return false; // the page's
  if (state.picking && keyOfPicking(pane, event)) return true;
  if (event.key in ARROWS) {
    const [x, y] = ARROWS[event.key];
    const orbit = source.isLive ? KEY_ORBIT : source.step;
    setCamera(event.shiftKey ? Camera.panned(state.camera, x * KEY_PAN, y * KEY_PAN)
                             : Camera.orbited(state.camera, x * orbit, y * orbit));
    return true;
  }
  if (event.key in ZOOMS) setCamera(Camera.zoomed(state.camera, KEY_ZOOM ** -ZOOMS[event.key]));
  else if (event.key in NEXT) announce(NEXT[event.key](pane));
  else if (event.key === 'Enter') setPicking({pane: pane.index, x: 0.5, y: 0.5});
  else if (event.key === 'Escape' && walkPanel.ray) walkPanel.clear();
  else return false;
  return true;
}

// What keys change, in words.
const after = (all, one) => all[(all.indexOf(one) + 1) % all.length];
function setNext(pane, name, all) {
  pane.set({[name]: after(all, pane.settings[name])});
  return pane.settings[name];
}
const NEXT = {
  c: (pane) => `channel ${setNext(pane, 'channel', state.scene.channels)}`,
  w: (pane) => `cells: ${setNext(pane, 'cells', CELLS)}`,
  g(pane) {
    pane.set({grid: pane.division.next(pane.settings.grid)});
    return `grid ${pane.structure.name}`;
  },
  l() {
    setScale(after(['automatic', 'linear', 'logarithmic'], scales.kind));
    return `scale: ${scales.kind}`;
  },
};

// The cross hair, moved by keys.
function setPicking(picking) {
  state.picking = picking;
  for (const pane of panes) pane.stage.classList.toggle('picking', Boolean(picking && picking.pane === pane.index));
  drawOverlays();
  if (picking) announce('Arrow keys move the cross hair, Enter picks, Escape drops it');
}
function keyOfPicking(pane, event) {
  const {x, y} = state.picking;
  if (event.key in ARROWS) {
    const [dx, dy] = ARROWS[event.key];
    const [width, height] = pane.size();
    const pixels = event.shiftKey ? 20 : 2;
    const clamped = (value) => Math.max(0, Math.min(0.99999, value));
    state.picking = {pane: pane.index, x: clamped(x + dx * pixels / width), y: clamped(y - dy * pixels / height)};
    drawOverlays();
  } else if (event.key === 'Enter' || event.key === 'Escape') {
    setPicking(null);
    if (event.key === 'Enter') pick(pane, x, y);
  } else {
    return false;
  }
  return true;
}

function keyOfPage(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  // Lists, sliders and boxes to tick have keys of their own, but not these; numbers have a point.
  const others = event.target.type === 'number' ? ['?', 'Escape'] : [',', '.', '?', 'Escape'];
  if (/^(INPUT|SELECT)$/.test(event.target.tagName) && !others.includes(event.key)) return;
  if (event.key === '?' || (event.key === 'Escape' && !$('keys-list').hidden)) toggleKeys();
  else if (event.key === 'p') togglePlane();
  else if (event.key === 'v' && !state.plane) toggleCompare();
  else if (event.key === 'q') setGuess(!state.guess);
  else if (event.key === 'Home') setCamera(ownCamera(state.scene));
  else if ([',', '.'].includes(event.key) && walkPanel.move(event.key === '.' ? 1 : -1)) { /* a step back or on */ }
  // What has keys of its own keeps them; Enter presses what is focused.
  else if (panes.length > 0 && !event.target.closest('.stage, .scroll') && (event.key !== 'Enter' || event.target === document.body) &&
           keyOfPicture(panes[0], event)) { /* the first picture's */ }
  else return;
  event.preventDefault();
}

function toggleKeys() {
  const list = $('keys-list');
  list.hidden = !list.hidden;
  $('keys').setAttribute('aria-expanded', String(!list.hidden));
}
