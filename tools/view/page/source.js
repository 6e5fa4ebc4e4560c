// Where pictures and figures come from: the server that served this page.
'use strict';

// Reads `trace;dur=1.5, rays;desc=300, precision;desc="robust"` as {trace: 1.5, rays: 300, precision: 'robust'}.
function readTiming(header) {
  const values = {};
  for (const [, name, text, number] of (header || '').matchAll(/(\w+);\w+=(?:"([^"]*)"|([^,]*))/g))
    values[name] = text === undefined ? Number(number) : text;
  return values;
}

// What the server or an export compressed. Of a picture's numbers: float32, rows from the top.
const inflated = (blob) => new Response(blob.stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();

class Server {
  constructor() {
    this.statisticsOf = new Map();
    this.isLive = true;
  }

  async get(path, parameters, signal) {
    const query = new URLSearchParams(parameters).toString();
    const response = await fetch(query ? path + '?' + query : path, {signal, cache: 'no-store', credentials: 'same-origin'});
    if (response.ok) return response;
    let why = response.statusText;
    try {
      why = (await response.json()).error;
    } catch { /* no JSON: the status says enough */ }
    throw new Error(why);
  }
  async json(path, parameters, signal) {
    return (await this.get(path, parameters, signal)).json();
  }

  scene() { return this.json('api/scene'); }

  static cameraParameters(view) {
    const {from, at, up, angle} = view.camera;
    return {grid: view.grid, from: from.join(), at: at.join(), up: up.join(), angle, width: view.width,
            height: view.height, depth: view.depth, channel: view.channel,
            ...(view.channel === 'cut' ? {axis: view.axis, share: view.share} : {})};
  }

  // {image, values, precision, milliseconds: {wait, trace, …, total}, rays}: values of channels that are numbers, an
  // image of others; precision: robust, or another one and why. crop: [x, y, width, height].
  async picture(view, quality, crop, signal) {
    const begin = performance.now();
    const parameters = {...Server.cameraParameters(view), quality};
    if (crop) parameters.crop = crop.join();
    const response = await this.get('api/picture', parameters, signal);
    const blob = await response.blob(), isImage = blob.type === 'image/jpeg';
    const image = isImage ? await createImageBitmap(blob) : null, values = isImage ? null : new Float32Array(await inflated(blob));
    const {precision, rays, ...milliseconds} = readTiming(response.headers.get('Server-Timing'));
    return {image, values, precision, milliseconds: {...milliseconds, total: performance.now() - begin - milliseconds.wait}, rays};
  }

  counts(view, signal) {
    return this.json('api/counts', {...Server.cameraParameters({...view, channel: 'shaded'}), quality: 'still'}, signal);
  }

  // Where a walk can be picked, as shares of the picture: anywhere.
  pixel(shareX, shareY) { return [shareX, shareY]; }

  // {origin, direction, precision} of the camera ray through a pixel's centre.
  ray({camera, width, height}, x, y, signal) {
    const {from, at, up, angle} = camera;
    return this.json('api/ray', {from: from.join(), at: at.join(), up: up.join(), angle, width, height, x, y}, signal);
  }

  // ray: {origin, direction, all, depth}; all: with the rays that it spawns.
  walk(grid, {origin, direction, all, depth, precision}, signal) {
    return this.json('api/walk', {grid, origin: origin.join(), direction: direction.join(), all: all ? 1 : 0, depth,
                                  ...(precision ? {precision} : {})}, signal);
  }

  // Where the ends of a ray in a slice may be: anywhere. By how much a key moves them.
  planeEnds(slice, ends) { return ends; }
  planeStep(slice, step) { return step; }

  slice(grid, axis, share, signal) { return this.json('api/slice', {grid, axis, share}, signal); }

  // depth: null for any.
  boxes(grid, depth) { return this.json('api/boxes', {grid, ...(depth === null ? {} : {depth})}); }

  statistics(grid) {
    if (!this.statisticsOf.has(grid)) {
      const made = this.json('api/statistics', {grid});
      made.catch(() => this.statisticsOf.delete(grid));
      this.statisticsOf.set(grid, made);
    }
    return this.statisticsOf.get(grid);
  }
}
