// A picture that follows the view: coarse while it moves, then sharp. Requests are for the newest view alone; the sharp
// picture is made in bands, and given up as soon as the view moves.
'use strict';

const STILL_MS = 25;         // without a move, before the picture is made sharp
const MOVING_BUDGET_MS = 28; // for a picture while the view moves
const BAND_MS = 100;         // for a band of the sharp picture

class Picture {
  // canvas: what is drawn on; colored(channel, values, width, height) makes an image of numbers; drawn(shown) is called
  // after each change with {view, isMoving, isSharp, share, milliseconds, rays}; failed(text), or '' when all is well again.
  constructor(canvas, source, colored, drawn, failed) {
    Object.assign(this, {canvas, source, colored, drawn, failed, context: canvas.getContext('2d', {alpha: false}), view: null, movedAt: 0,
      isClosed: false, abort: null, wake: () => {}});
    this.values = null; // {channel, width, height, data} of the whole picture, where it is one of numbers
    Object.assign(this, {msPerPixel: 2e-4, stillMsPerPixel: 4e-4}); // of moving pictures, a running mean; of the last sharp one
  }

  // view: {grid, channel, camera, width, height, depth}. False where it is shown already, or on its way.
  show(view) {
    if (JSON.stringify(view) === JSON.stringify(this.view)) return false;
    const isFirst = !this.view;
    this.view = view;
    this.movedAt = performance.now();
    this.abort?.abort();
    this.wake();
    if (isFirst) this.run();
    return true;
  }

  close() {
    this.isClosed = true;
    this.abort?.abort();
    this.wake();
  }

  async run() {
    let coarse = null, sharp = null; // views that were drawn
    let failures = 0;
    while (!this.isClosed) {
      const {view} = this;
      try {
        if (document.hidden) {
          await this.sleep(1000); // nobody looks
        } else if (coarse !== view) {
          await this.drawMoving(view);
          coarse = view;
        } else if (sharp !== view) {
          const left = this.movedAt + STILL_MS - performance.now();
          if (left > 0) await this.sleep(left);
          else if (await this.drawSharp(view)) sharp = view;
        } else {
          await this.sleep(1e6);
        }
        if (failures > 0) this.failed('');
        failures = 0;
      } catch (error) {
        if (error.name === 'AbortError') continue;
        failures += 1;
        this.failed(error.message);
        await this.sleep(Math.min(5000, 500 * failures));
      }
    }
  }

  // Until the time is over or the view moves.
  sleep(milliseconds) {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, Math.min(milliseconds, 0x7fffffff));
      this.wake = () => { clearTimeout(timer); resolve(); };
    });
  }

  // With the colours that numbers have by now.
  recolor() {
    if (!this.values) return;
    const {channel, width, height, data} = this.values;
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(this.colored(channel, data, width, height), 0, 0, this.canvas.width, this.canvas.height);
  }

  fit({width, height}) {
    const {canvas, context} = this, old = newCanvas(canvas.width, canvas.height);
    if (old.width === width && old.height === height) return;
    old.getContext('2d').drawImage(canvas, 0, 0);
    Object.assign(canvas, {width, height});
    context.drawImage(old, 0, 0, width, height);
  }

  async drawMoving(view) {
    const affordable = Math.sqrt(MOVING_BUDGET_MS / (this.msPerPixel * view.width * view.height));
    const scale = this.source.isLive ? Math.min(1, Math.max(0.08, affordable)) : 1;
    const small = {...view, width: Math.max(1, Math.round(view.width * scale)),
                   height: Math.max(1, Math.round(view.height * scale))};
    const got = await this.source.picture(small, 'moving', null, undefined);
    const cost = !this.source.isLive ? 0 : got.milliseconds.total / (small.width * small.height);
    this.msPerPixel += (cost - this.msPerPixel) * (cost > this.msPerPixel ? 0.5 : 0.2);
    if (this.isClosed) return;
    this.fit(view);
    this.values = got.values && {channel: view.channel, width: small.width, height: small.height, data: got.values};
    this.context.imageSmoothingEnabled = view.channel === 'shaded';
    if (got.image) this.context.drawImage(got.image, 0, 0, view.width, view.height);
    else this.recolor();
    if (got.image?.close) got.image.close();
    this.drawn({...got, view, isMoving: true, isSharp: false, scale, share: 1});
  }

  // False where the view has moved meanwhile.
  async drawSharp(view) {
    const pixels = view.width * view.height;
    const estimate = pixels * this.stillMsPerPixel;
    const bands = !this.source.isLive ? 1 : Math.max(1, Math.min(Math.ceil(estimate / BAND_MS), Math.ceil(view.height / 16)));
    const rows = Math.ceil(view.height / bands / 16) * 16; // whole blocks of JPEG
    const sum = {};
    let rays = 0, values = null;
    const begin = performance.now();
    const {signal} = this.abort = new AbortController();
    const asked = (y) => {
      if (y >= view.height) return null;
      const picture = this.source.picture(view, 'still', bands > 1 ? [0, y, view.width, Math.min(rows, view.height - y)] : null, signal);
      picture.catch(() => {}); // where it isn't awaited any more
      return picture;
    };
    // One band is traced while the one before is encoded, sent and drawn.
    let next = asked(0);
    for (let y = 0; y < view.height; y += rows) {
      const height = Math.min(rows, view.height - y), coming = next;
      next = asked(y + rows);
      const got = await coming;
      if (this.view !== view || this.isClosed) return false;
      this.fit(view);
      this.context.drawImage(got.image || this.colored(view.channel, got.values, view.width, height), 0, y, view.width, height);
      if (got.image?.close) got.image.close();
      if (got.values) {
        values = values || new Float32Array(pixels);
        values.set(got.values, y * view.width);
      }
      rays += got.rays;
      for (const [name, value] of Object.entries(got.milliseconds)) sum[name] = (sum[name] || 0) + value;
      const isLast = y + height === view.height;
      if (isLast) {
        this.values = values && {channel: view.channel, width: view.width, height: view.height, data: values};
        this.recolor();
      }
      this.drawn({...got, view, milliseconds: sum, rays, isMoving: false, isSharp: isLast, scale: 1, share: (y + height) / view.height});
    }
    this.stillMsPerPixel = Math.max(1e-6, (performance.now() - begin) / pixels);
    return true;
  }
}
