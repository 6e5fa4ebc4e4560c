// Where pictures and figures come from: the server that served this page.
'use strict';

// Reads `trace;dur=1.5, rays;desc=300, precision;desc="robust"` as {trace: 1.5, rays: 300, precision: 'robust'}.
function readTiming(header) {
  const values = (header || '').matchAll(/(\w+);\w+=(?:"([^"]*)"|([^,]*))/g);
  return Object.fromEntries(Array.from(values, ([, name, text, number]) => [name, text ?? Number(number)]));
}

// What the server or an export compressed. Of a picture's numbers: float32, rows from the top.
const inflated = (blob) => new Response(blob.stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();

// {image, values, precision, milliseconds: {wait, trace, …, total}, rays}: values of channels that are numbers, an image of
// others; precision: robust, or another one and why; total(milliseconds): of a picture that can be shown.
async function pictureOf(blob, isImage, timing, total) {
  const image = isImage ? await createImageBitmap(blob) : null, values = isImage ? null : new Float32Array(await inflated(blob));
  const {precision, rays, ...milliseconds} = readTiming(timing);
  return {image, values, precision, milliseconds: {...milliseconds, total: total(milliseconds)}, rays};
}

const RETRY_MS = 500; // more each time, up to ten times as long

class Server {
  // lost(is): whether nobody answers.
  constructor(lost) {
    Object.assign(this, {lost, files: null, isLive: true, opensWith: '', statisticsOf: new Map()});
  }

  // What read(response, when it was asked for) makes of it; asked for again until somebody answers. Where that is
  // a gridview of other files the page is loaded anew, for the grids that it knows are others.
  async get(path, parameters, signal, read) {
    const query = new URLSearchParams({...parameters, ...(this.files ? {files: this.files} : {})}).toString();
    for (let failures = 1; ; ++failures) {
      try {
        const begin = performance.now();
        const response = await fetch(query ? path + '?' + query : path, {signal, cache: 'no-store', credentials: 'same-origin'});
        const made = response.ok ? await read(response, begin) : await response.text();
        this.lost(false);
        if (response.ok) return made;
        if (response.status === 409) return new Promise(() => location.reload());
        throw new Error(made.startsWith('{') ? JSON.parse(made).error : response.statusText);
      } catch (error) {
        if (!(error instanceof TypeError)) throw error;
        this.lost(true);
        await new Promise((resolve) => setTimeout(resolve, RETRY_MS * Math.min(10, failures)));
        signal?.throwIfAborted();
      }
    }
  }
  json(path, parameters, signal) { return this.get(path, parameters, signal, (response) => response.json()); }

  async scene() {
    const made = await this.json('api/scene');
    this.files = made.files;
    return withDivisions(made, true);
  }

  static cameraParameters({camera: {from, at, up, angle}, width, height}) {
    return {from: from.join(), at: at.join(), up: up.join(), angle, width, height};
  }
  static viewParameters(view) {
    const {grid, depth, channel, axis, share} = view;
    return {...Server.cameraParameters(view), grid, depth, channel, ...(channel === 'cut' ? {axis, share} : {})};
  }

  // As pictureOf() has it; crop: [x, y, width, height].
  async picture(view, quality, crop, signal) {
    const parameters = {...Server.viewParameters(view), quality, ...(crop ? {crop: crop.join()} : {})};
    const [blob, timing, begin] = await this.get('api/picture', parameters, signal, async (response, asked) =>
      [await response.blob(), response.headers.get('Server-Timing'), asked]);
    return pictureOf(blob, blob.type === 'image/jpeg', timing, ({wait}) => performance.now() - begin - wait);
  }

  counts(view, signal) {
    return this.json('api/counts', {...Server.viewParameters({...view, channel: 'shaded'}), quality: 'still'}, signal);
  }

  // Where a walk can be picked, as shares of the picture: anywhere.
  pixel(shareX, shareY) { return [shareX, shareY]; }

  // {origin, direction, precision} of the camera ray through a pixel's centre.
  ray(view, x, y, signal) { return this.json('api/ray', {...Server.cameraParameters(view), x, y}, signal); }

  // ray: {origin, direction, all, depth}; all: with the rays that it spawns.
  walk(grid, {origin, direction, all, depth, precision}, signal) {
    return this.json('api/walk', {grid, origin: origin.join(), direction: direction.join(), all: all ? 1 : 0, depth,
                                  ...(precision ? {precision} : {})}, signal);
  }

  // Where the ends of a ray in a slice may be: anywhere. By how much a key moves them.
  planeEnds(slice, ends) { return ends; }
  planeStep(slice, step) { return step; }

  // Which slices and rays there are: any.
  sliceAt(plane) { return plane; }
  known(ray) { return ray; }
  slice(grid, axis, share) { return this.json('api/slice', {grid, axis, share}); }

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
