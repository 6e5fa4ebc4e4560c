// The walk of a ray through each grid or hierarchy that is shown: its cells or nodes as a list, step by step. The ray stays where it
// is in the scene when the camera moves, another grid is chosen or the window changes.
'use strict';

const PLAY_MS = 1500; // a step

// What happens at a step of a ray's walk, and whether it goes on, by the walk's numbers; ended: why the walk ended.
function stepSentence(ray, index, what, ended) {
  const {tests, node, exit} = ray.steps[index], keeps = (step) => step.tests.some(({kept}) => kept);
  const nearest = ray.steps.slice(0, index + 1).flatMap((step) => step.tests.filter(({kept}) => kept)).pop();
  // An exported page knows where the last hit is.
  const t = nearest && (nearest.t ?? (ray.steps.slice(index + 1).some(keeps) ? null : ray.hit.t));
  const hit = nearest && `the ${keeps(ray.steps[index]) ? 'new ' : ''}hit${t === null ? '' : ` at ${Text.number(t)}`}`;
  const parts = [counted(tests.length, 'test')];
  if (node) parts.unshift(`${node.boxes_met} of ${node.boxes_met + node.boxes_missed + node.boxes_beyond} boxes met${node.boxes_met > 1 ? ', the nearest first' : ''}`,
    ...(node.boxes_beyond > 0 ? [`${node.boxes_beyond} beyond the hit`] : []));
  if (index === ray.cells - 1) parts.push(hit && ray.kind !== 'shadow' ? `${hit}: nothing nearer can follow` : ended);
  else if (!hit) parts.push('no hit yet: go on');
  else if (node) parts.push(`${hit}: go on with boxes before it`);
  else parts.push(`${hit} lies ${t === null || t > exit ? 'beyond' : 'within rounding at'} this cell’s end, ${Text.number(exit)}: go on`);
  return `${what} ${index + 1}: ${parts.join('; ')}`;
}

class WalkPanel {
  // settings: {guess, cost} of the page; changed(): another ray, walk or step; center(point): orbit around it from now on.
  constructor(root, source, settings, changed, center) {
    Object.assign(this, {root, source, settings, changed, center, grids: [], names: [], structures: []});
    this.plays = [0, 1].map(() => element('button', {type: 'button', title: 'Goes on step by step', onclick: () => this.play(!this.timer)})); // here, and in the plane
    root.after(this.spoken = element('p', {class: 'unseen', role: 'status'})); // a step, for those who don't see it
    this.clear();
  }

  clear() {
    if (this.abort) this.abort.abort();
    this.play(false);
    // ray: {origin, direction, all, depth}, the camera's or a given one; pixel: where it was picked; pane: whose
    // walk is listed; index: of the ray among those that it spawned; step: of all walks, which have ended before it
    // or not, null for the last of the longest; walks: by grid; guesses: of what it visits, by grid, null where none was made.
    Object.assign(this, {ray: null, pixel: null, pane: 0, index: 0, step: null, walks: new Map(), guesses: null, drawn: '', abort: null});
    this.root.replaceChildren(element('p', {class: 'note'}, 'Click a pixel, or press Enter in the picture, to follow its ray through the grid or the hierarchy. Plane has a ray to drag.'));
    this.changed();
  }

  failed(text) {
    this.clear();
    this.root.append(element('p', {class: 'note', role: 'alert'}, text));
  }

  // Whether the ray's walks are hidden, for they are to be guessed first.
  get isAsking() { return Boolean(this.settings.guess && this.ray && !this.guesses); }
  guessOf(grid) { return this.guesses?.has(grid) ? `; guessed ${Text.count(this.guesses.get(grid))}` : ''; }

  // Of a grid, the ray that is looked at; null where there is none, where it isn't loaded, or hidden.
  rayOf(grid) {
    const walk = !this.isAsking && this.walks.get(grid);
    return walk && walk.rays[this.index] || null;
  }
  get walk() { return this.walks.get(this.grids[this.pane]) || null; }
  get current() { return this.rayOf(this.grids[this.pane]); }

  // {pane, index, step, pixel}: what of the ray is looked at.
  follow(ray, look) {
    this.play(false);
    Object.assign(this, {ray, pixel: null, index: 0, step: null, walks: new Map(), guesses: null, drawn: ''}, look);
    return this.load();
  }
  // With the rays that it spawns or without, to another depth.
  followAgain(change) {
    if (!this.ray || Object.entries(change).every(([name, value]) => this.ray[name] === value)) return;
    const {pixel, guesses, index} = this;
    this.follow({...this.ray, ...change}, {pixel, guesses, ...(change.all === false ? {} : {index})});
  }

  // grids: of the panes, their names, and scene.grids of each.
  show(grids, names, structures) {
    if (String(grids) !== String(this.grids) && this.step === this.lastStep) this.step = null; // the last one of others, too
    if (this.pane >= grids.length || (this.grids.length > 0 && grids[this.pane] !== this.grids[this.pane])) this.step = null;
    this.pane = Math.min(this.pane, grids.length - 1);
    Object.assign(this, {grids, names, structures});
    return this.load();
  }

  // The walks that are missing.
  async load() {
    if (!this.ray || this.grids.length === 0) return;
    const missing = [...new Set(this.grids)].filter((grid) => !this.walks.has(grid));
    if (this.abort) this.abort.abort();
    const {signal} = this.abort = new AbortController();
    try {
      const made = await Promise.all(missing.map((grid) => this.source.walk(grid, this.ray, signal)));
      if (signal.aborted) return;
      missing.forEach((grid, i) => this.walks.set(grid, made[i]));
      if (this.drawn !== this.grids.join()) this.draw();
      this.drawn = this.grids.join();
    } catch (error) {
      if (error.name !== 'AbortError') this.failed(error.message);
    }
  }

  // Of the longest walk that is shown.
  get lastStep() { return Math.max(0, ...this.grids.map((grid) => this.rayOf(grid)).map((ray) => ray ? ray.steps.length - 1 : 0)); }

  move(by) {
    const {current} = this;
    if (!current || current.steps.length === 0) return false;
    this.select(Math.max(0, Math.min(this.lastStep, this.step + by)));
    const {cells} = this.body.rows[Math.min(this.step, this.body.rows.length - 1)], count = parseInt(cells[cells.length - 1].textContent, 10);
    this.spoken.textContent = `step ${this.step + 1} of ${this.lastStep + 1}: ${visited(this.structures[this.pane])} ${cells[1].textContent}, ${counted(count, 'test')}${cells[cells.length - 1].className && ', hit'}`;
    return true;
  }

  // Until the longest walk ends; from the beginning where it has.
  play(isPlaying) {
    clearInterval(this.timer);
    this.timer = null;
    if (isPlaying && this.current) {
      if (this.step >= this.lastStep) this.select(0);
      this.timer = setInterval(() => {
        if (!this.move(1) || this.step >= this.lastStep) this.play(false);
      }, PLAY_MS);
    }
    for (const button of this.plays) button.textContent = this.timer ? 'Pause' : 'Play';
  }

  // Of a grid's ray at the step, or where its walk has ended; empty while the walk is on its way.
  sentenceOf(grid) {
    const ray = this.rayOf(grid), i = this.grids.indexOf(grid);
    if (!ray || ray.steps.length === 0) return '';
    return stepSentence(ray, Math.min(this.step ?? Infinity, ray.steps.length - 1), visited(this.structures[i]), this.walks.get(grid).ended[this.index]);
  }

  // A ray that is hidden has no steps.
  select(step) {
    if (!this.current) return;
    this.step = step;
    this.sentence.textContent = this.sentenceOf(this.grids[this.pane]);
    const row = this.body.rows[Math.min(step, this.body.rows.length - 1)];
    for (const one of this.body.rows) one.setAttribute('aria-selected', String(one === row));
    if (row) {
      const list = this.list.getBoundingClientRect(), at = row.getBoundingClientRect();
      if (at.top < list.top + 22 || at.bottom > list.bottom) this.list.scrollTop += at.top - list.top - list.height / 2;
      this.list.setAttribute('aria-activedescendant', row.id);
    }
    this.changed();
  }

  // Another pane's walk, or another ray of the same one.
  look(change) {
    Object.assign(this, {step: null}, change);
    this.draw();
  }

  // What to guess, and a button that shows it.
  ask() {
    this.guessed = this.grids.map((grid, i) => element('input', {type: 'number', min: 0, 'aria-label': `Guess: ${visited(this.structures[i])}s of ${this.names[i]}`}));
    this.root.replaceChildren(element('form', {class: 'guess', onsubmit: (event) => { event.preventDefault(); this.answer(); }},
      element('p', {}, `How many ${visitedNames(this.structures).replace(', ', ' or ')} will this ray visit?`),
      element('div', {class: 'rows'}, ...this.guessed.flatMap((input, i) => [element('span', {class: 'name'}, this.names[i]), element('span', {class: 'value'}, input)])),
      element('button', {type: 'submit', title: 'Shows what it visits (Enter)'}, 'Show')));
    this.spoken.textContent = ''; // of another ray
    this.changed();
  }
  focusGuess() { if (this.isAsking) this.guessed?.[0].focus(); }
  answer() {
    const made = this.grids.map((grid, i) => [grid, this.guessed[i].valueAsNumber]);
    this.draw({guesses: new Map(made.filter(([, guess]) => guess >= 0))});
    this.spoken.textContent = this.grids.map((grid, i) => `${this.names[i]}: ${counted(this.rayOf(grid).cells, visited(this.structures[i]))}${this.guessOf(grid)}`).join('. ');
    focusView();
  }

  draw(change = {}) {
    Object.assign(this, change);
    if (!this.walk) return;
    if (this.isAsking) return this.ask();
    this.index = Math.min(this.index, this.walk.rays.length - 1);
    const {walk, pixel, current} = this;
    const what = visited(this.structures[this.pane]);
    this.step = Math.min(this.step ?? Infinity, this.lastStep);
    const t = (value) => Text.number(Math.max(0, value)); // rounded, it may lie before the ray's origin
    const range = (first, end) => first === end - 1 ? `${first}` : `${first}–${end - 1}`;
    // A cell's voxels, or a node and what became of its boxes.
    const placeOf = ({voxels, node}) => node
      ? [`${node.index}`, `${node.depth}`, [node.boxes_met, node.boxes_missed, node.boxes_beyond].join(' · ')]
      : [[0, 1, 2].map((i) => range(voxels.first[i], voxels.end[i])).join(' ')];
    const titleOf = ({tests}) => tests.filter(({primitive}) => primitive !== null)
      .map((test) => `primitive ${test.primitive}: ${test.t === null ? 'missed' : `t ${test.t}${test.kept ? ', kept' : ''}`}`).join('\n');
    const hit = current.hit;
    const summary = element('div', {class: 'rows'},
      ...[...(pixel ? [['pixel', `${pixel.x}, ${pixel.y} of ${pixel.width} × ${pixel.height}`]] : []),
          ['from', Text.vector(current.origin)],
          ['direction', Text.vector(current.direction)],
          ['hit', hit ? `object ${hit.object}, primitive ${hit.primitive}, t ${Number(hit.t.toPrecision(7))}` : 'nothing'],
          ...(hit ? [['at', Text.vector(hit.position)]] : []),
          ['ended', walk.ended[this.index]]].flatMap(([name, value]) =>
        [element('span', {class: 'name'}, name), element('span', {class: 'value'}, value)]));
    const shown = this.grids.map((grid) => this.rayOf(grid));
    const costs = table(this.names, [
      [visitedNames(this.structures), shown.map((one) => one && one.cells), {text: Text.count, less: 'fewer'}],
      ['guessed', this.grids.map((grid) => this.guesses?.get(grid) ?? null), {text: Text.count}],
      ['tests', shown.map((one) => one && one.tests), {text: Text.count, less: 'fewer'}],
      ['cost', shown.map((one, i) => one && costOf(this.settings.cost, this.structures[i], one.cells, one.tests)), {text: Text.cost, less: 'less', title: COST_TITLE}],
    ], 'What the ray costs in each grid');
    // Of several one to look at: this.pane or this.index.
    const choice = (label, name, part, all) => all.length < 2 ? null : element('label', {}, label, element('select', {class: name,
      onchange: (event) => this.look({[part]: Number(event.target.value)})},
      ...all.map((text, i) => element('option', {value: i, selected: i === this[part]}, text))));
    const panes = choice('List of ', 'walk-pane', 'pane', this.names);
    const rays = choice('Ray ', 'walk-ray', 'index', walk.rays.map((one, i) => `${i}: ${one.kind}, ${one.cells} ${what}s, ${one.tests} tests`));
    const more = walk.more_rays === 0 ? null : element('p', {class: 'note walk-more'},
      `and ${walk.ended_early ? 'more than ' : ''}${Text.count(walk.more_rays)} more rays, which aren’t listed`);
    const choices = element('div', {class: 'controls'}, panes, rays);
    this.body = element('tbody');
    current.steps.forEach((step, i) => {
      const kept = step.tests.filter((test) => test.kept).length;
      this.body.append(element('tr', {id: `walk-step-${i}`, 'data-step': i, role: 'option', 'aria-selected': i === this.step,
        onclick: () => this.select(i), title: titleOf(step)},
        ...[String(i), ...placeOf(step), t(step.enter), step.exit === null ? '∞' : t(step.exit)].map((text) => element('td', {}, text)),
        element('td', {class: kept ? 'hit' : null}, `${step.tests.length}${kept ? ' hit' : ''}`)));
    });
    const places = what === 'node' ? ['step', 'node', 'depth', 'boxes'] : ['cell', 'voxels x y z'];
    const head = [...places, 't in', 't out', 'tests'].map((name) => element('th', {scope: 'col'}, name));
    const boxes = what === 'node' ? element('p', {class: 'note'}, 'Boxes of a node: met (visited or tested, now or later) · missed · entered beyond the hit') : null;
    this.list = element('div', {class: 'scroll', tabindex: 0, role: 'listbox', 'aria-label': `${what === 'node' ? 'Nodes' : 'Cells'} of ${this.names[this.pane]} that the ray visits`, onkeydown: (event) => {
      const by = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -1e9, End: 1e9}[event.key];
      if (by && this.move(by)) { event.preventDefault(); event.stopPropagation(); }
    }}, element('table', {class: 'walk-steps', role: 'presentation'}, element('thead', {'aria-hidden': true}, element('tr', {}, ...head)), this.body));
    const moreCells = current.cells === current.steps.length ? null : element('p', {class: 'note'},
      `and ${Text.count(current.cells - current.steps.length)} more ${what}s, which aren’t listed`);
    this.sentence = element('p', {class: 'note of-pictures'});
    const buttons = element('div', {class: 'controls'},
      element('button', {type: 'button', title: `The ${what} before (,)`, onclick: () => this.move(-1)}, '◂ step'),
      element('button', {type: 'button', title: `The next ${what} (.)`, onclick: () => this.move(1)}, 'step ▸'), this.plays[0],
      hit ? element('button', {class: 'of-pictures', type: 'button', title: 'The camera orbits around the hit', onclick: () => this.center(hit.position)}, 'Orbit here') : null,
      element('button', {class: 'of-pictures', type: 'button', title: 'Drops the walk (Esc)', onclick: () => this.clear()}, 'Clear'));
    this.root.replaceChildren(...[costs, choices, more, buttons, this.sentence, this.list, boxes, moreCells, summary].filter(Boolean));
    this.select(this.step);
  }
}
