// Numbers as colours: the scale that all pictures of a channel share.
'use strict';

// Colours of numbers, as the server has them.
class ColorScale {
  constructor(samples) { this.samples = samples; }
  // position: 0 to 1.
  at(position) {
    return this.samples[Math.round((this.samples.length - 1) * Math.max(0, Math.min(1, position)))];
  }
  // A colour of many as the four bytes of a canvas.
  bytes(count) {
    const last = this.samples.length - 1;
    const part = (color, channel) => parseInt(color.slice(1 + 2 * channel, 3 + 2 * channel), 16);
    return Uint32Array.from({length: count}, (_, i) => {
      const at = last * i / (count - 1), first = Math.min(last - 1, Math.floor(at)), share = at - first;
      const [r, g, b] = [0, 1, 2].map((channel) => Math.round((1 - share) * part(this.samples[first], channel) + share * part(this.samples[first + 1], channel)));
      return (255 << 24 | b << 16 | g << 8 | r) >>> 0;
    });
  }
  gradient() { return `linear-gradient(to right, ${this.samples.join()})`; }
  reversed() { return new ColorScale([...this.samples].reverse()); }
}

// What values span: {low, high, median}. Of counts from 0 to what one in a thousand exceeds, of at most some 20000 of
// them. Null where none is finite.
function spanOf(channel, values) {
  const step = Math.max(1, Math.floor(values.length / 20000));
  const finite = values.filter((value, i) => i % step === 0 && Number.isFinite(value)).sort();
  if (finite.length === 0) return null;
  const at = (share) => finite[Math.floor(share * (finite.length - 1))];
  return {low: channel === 'depth' ? at(0) : 0, high: channel === 'depth' ? at(1) : at(0.999), median: at(0.5)};
}

const COUNTS = ['cells', 'tests', 'all cells', 'all tests']; // whose scale may be logarithmic

// The scales of channels: {low, high, isLogarithmic}. Idle lanes are of 32.
class Scales {
  constructor(colors) {
    Object.assign(this, {bytes: colors.bytes(1024), kind: 'automatic', fitted: new Map()});
  }

  // Round numbers around the spans of all pictures of a channel, kept while they fit fairly, so that colours don't
  // flicker while the view moves. True where they changed.
  fit(channel, spans) {
    const low = Math.min(...spans.map((span) => span.low)), high = Math.max(...spans.map((span) => span.high));
    if (channel === 'idle') return false;
    const isWide = channel !== 'depth' && high > 50 && spans.some((span) => span.median < high / 10); // as gridrender judges
    const old = this.fitted.get(channel);
    if (old && old.isWide === isWide && low >= old.low && high <= old.high && high - low > 0.45 * (old.high - old.low)) return false;
    const step = 10 ** Math.floor(Math.log10(Math.max(high - low, 1e-30))) / 2;
    const [first, end] = [Math.floor(low / step), Math.max(Math.ceil(high / step), Math.floor(low / step) + 1)];
    const made = {low: channel === 'depth' ? Number((first * step).toPrecision(6)) : 0, high: Number((end * step).toPrecision(6)), isWide};
    this.fitted.set(channel, made);
    return !old || old.low !== made.low || old.high !== made.high || old.isWide !== isWide;
  }

  of(channel) {
    const {low, high, isWide} = this.fitted.get(channel) || {low: 0, high: channel === 'idle' ? 32 : 1, isWide: false};
    return {low, high, isLogarithmic: COUNTS.includes(channel) && (this.kind === 'automatic' ? isWide : this.kind === 'logarithmic')};
  }

  // A canvas; white where a value isn't finite.
  colored(channel, values, width, height) {
    const {low, high, isLogarithmic} = this.of(channel), {bytes} = this, last = bytes.length - 1;
    const scale = isLogarithmic ? last / Math.log1p(high) : last / (high - low);
    const canvas = newCanvas(width, height);
    const context = canvas.getContext('2d'), image = context.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    for (let i = 0; i < pixels.length; ++i) {
      const value = values[i];
      const at = scale * (isLogarithmic ? Math.log1p(value) : value - low);
      pixels[i] = Number.isFinite(value) ? bytes[Math.max(0, Math.min(last, Math.round(at)))] : 0xffffffff;
    }
    context.putImageData(image, 0, 0);
    return canvas;
  }
}
