// The walk of a pixel's ray: its cells as a list, step by step.
'use strict';

class WalkPanel {
  // changed(): another step or another walk; center(point): orbit around it from now on.
  constructor(root, changed, center) {
    Object.assign(this, {root, changed, center, walk: null, pixel: null, ray: 0, step: 0});
    this.clear();
  }

  clear() {
    this.walk = null;
    this.pixel = null;
    this.root.replaceChildren(element('p', {class: 'note'}, 'Click a pixel, or press Enter in the picture, to follow its ray through the grid.'));
    this.changed();
  }

  failed(text) {
    this.clear();
    this.root.append(element('p', {class: 'note', role: 'alert'}, text));
  }

  // walk: as gridrender --walk writes it; pixel: {x, y, width, height, name}.
  show(walk, pixel) {
    this.walk = walk;
    this.pixel = pixel;
    this.ray = 0;
    const steps = walk.rays[0].steps;
    this.step = Math.max(0, steps.length - 1);
    this.draw();
  }

  get current() { return this.walk ? this.walk.rays[this.ray] : null; }

  move(by) {
    if (!this.walk || this.current.steps.length === 0) return false;
    this.select(Math.max(0, Math.min(this.current.steps.length - 1, this.step + by)));
    return true;
  }

  select(step) {
    this.step = step;
    for (const row of this.body.rows) row.setAttribute('aria-selected', String(Number(row.dataset.step) === step));
    const row = this.body.rows[step];
    if (row) {
      const list = this.list.getBoundingClientRect(), at = row.getBoundingClientRect();
      if (at.top < list.top + 22 || at.bottom > list.bottom) this.list.scrollTop += at.top - list.top - list.height / 2;
      this.list.setAttribute('aria-activedescendant', row.id);
    }
    this.changed();
  }

  draw() {
    const {walk, pixel, current} = this;
    const range = (first, end) => first === end - 1 ? `${first}` : `${first}–${end - 1}`;
    const voxels = (box) => box ? [0, 1, 2].map((i) => range(box.first[i], box.end[i])).join(' ') : 'everything';
    const hit = current.hit;
    const summary = element('div', {class: 'rows'},
      ...[['pixel', `${pixel.x}, ${pixel.y} of ${pixel.width} × ${pixel.height}`],
          ['grid', pixel.name],
          ['cells, tests', `${Text.count(current.cells)}, ${Text.count(current.tests)}`],
          ['hit', hit ? `object ${hit.object}, primitive ${hit.primitive}, t ${Number(hit.t.toPrecision(7))}` : 'nothing'],
          ...(hit ? [['at', Text.vector(hit.position)]] : []),
          ['ended', current.end]].flatMap(([name, value]) =>
        [element('span', {class: 'name'}, name), element('span', {class: 'value'}, value)]));
    const choice = walk.rays.length < 2 ? null : element('label', {}, 'Ray ', element('select', {
      onchange: (event) => { this.ray = Number(event.target.value); this.step = Math.max(0, this.current.steps.length - 1); this.draw(); }},
      ...walk.rays.map((ray, i) => element('option', {value: i, selected: i === this.ray}, `${i}: ${ray.kind}, ${ray.cells} cells, ${ray.tests} tests`))));
    this.body = element('tbody');
    current.steps.forEach((step, i) => {
      const kept = step.tests.filter((test) => test.kept).length;
      this.body.append(element('tr', {id: `walk-step-${i}`, 'data-step': i, role: 'option', 'aria-selected': i === this.step,
        onclick: () => this.select(i), title: step.tests.map((test) => `primitive ${test.primitive}: ${test.t === null ? 'missed' : `t ${test.t}${test.kept ? ', kept' : ''}`}`).join('\n')},
        element('td', {}, String(i)), element('td', {}, voxels(step.voxels)), element('td', {}, Text.number(step.enter)),
        element('td', {}, step.exit === null ? '∞' : Text.number(step.exit)), element('td', {class: kept ? 'hit' : null}, `${step.references}${kept ? ' hit' : ''}`)));
    });
    const head = ['cell', 'voxels x y z', 't in', 't out', 'tests'].map((name) => element('th', {scope: 'col'}, name));
    this.list = element('div', {class: 'scroll', tabindex: 0, role: 'listbox', 'aria-label': 'Cells that the ray visits', onkeydown: (event) => {
      const by = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -1e9, End: 1e9}[event.key];
      if (by && this.move(by)) { event.preventDefault(); event.stopPropagation(); }
    }}, element('table', {class: 'walk-steps', role: 'presentation'}, element('thead', {'aria-hidden': true}, element('tr', {}, ...head)), this.body));
    const buttons = element('div', {class: 'controls'},
      element('button', {type: 'button', title: 'The cell before (,)', onclick: () => this.move(-1)}, '◂ step'),
      element('button', {type: 'button', title: 'The next cell (.)', onclick: () => this.move(1)}, 'step ▸'),
      hit ? element('button', {type: 'button', title: 'The camera orbits around the hit', onclick: () => this.center(hit.position)}, 'Orbit here') : null,
      element('button', {type: 'button', title: 'Drops the walk (Esc)', onclick: () => this.clear()}, 'Clear'));
    this.root.replaceChildren(...[summary, choice, buttons, this.list].filter(Boolean));
    this.select(this.step);
  }
}
