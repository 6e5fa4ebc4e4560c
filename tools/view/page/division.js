// Which structure is shown: one of those that were given, or a uniform grid whose division a slider chooses.
'use strict';

const USUAL_DIVISION = 32;

// scene, as the server or an export describes it, with the uniform grids of its divisions behind the grids that were given.
// hasPictures: of those divisions, too.
function withDivisions(scene, hasPictures) {
  const stem = scene.scene.path.replace(/\.scene$/, ''), given = scene.grids.length;
  const divided = scene.divisions.map((division) => {
    const name = `division-${division}`, path = `${stem}-${name}.grid`;
    return {name, path, division, structure: 'grid', merge: 'none', greatest_depth: 0, hash: null, bytes: null,
      made_by: [['gridbuild', scene.scene.path, '-o', path, '--merge', 'none', '--division', String(division)]]};
  });
  return {...scene, given, pictured: hasPictures ? given + divided.length : given, grids: [...scene.grids, ...divided]};
}

// Of a plane: those that were given, and a uniform one where none of them is.
const MOST_SLICES = 4;
function firstGrids({grids, given}) {
  const usual = grids.findIndex(({division}) => division === USUAL_DIVISION), all = grids.slice(0, given);
  const first = all.some(({structure, merge}) => structure === 'grid' && merge === 'none') ? [] : [usual];
  return [...first, ...all.keys()].slice(0, MOST_SLICES);
}

class DivisionSlider {
  // select: gets the grids' names; choose(grid): another one, of scene.grids; end: behind the last one that there may be.
  constructor(select, {grids, given}, end, choose) {
    Object.assign(this, {select, grids, given, index: grids.findIndex(({division}) => division === USUAL_DIVISION)});
    select.append(...grids.slice(0, given).map(({name}, i) => element('option', {value: i}, name)),
                  ...(end > given ? [element('option', {value: given}, 'uniform N³')] : []));
    select.addEventListener('change', () => choose(Number(select.value) < given ? Number(select.value) : this.index));
    this.range = element('input', {type: 'range', min: given, max: end - 1, 'aria-label': 'Division: voxels per axis of the uniform grid',
      oninput: () => choose(Number(this.range.value))});
    this.text = element('output', {'aria-live': 'off'});
    this.root = element('span', {class: 'division', title: 'Voxels per axis of the uniform grid'}, this.range, this.text);
  }

  show(grid) {
    this.root.hidden = grid < this.given;
    this.select.value = Math.min(grid, this.given);
    if (this.root.hidden) return;
    this.range.value = this.index = grid;
    this.text.textContent = `${this.grids[grid].division}³`;
    this.range.setAttribute('aria-valuetext', String(this.grids[grid].division));
  }

  // The next of the select's options.
  next(grid) {
    return grid + 1 < this.given ? grid + 1 : grid < this.given && this.select.length > this.given ? this.index : 0;
  }
}
