// Pictures: read by the browser, turned and cropped.
const MOST_PIXELS = 4e6; // of a picture; larger ones are scaled down

// Whether the command reads the same numbers: the file is a PNG of up to 8 bits, without alpha.
function isPlainPng(bytes, rgba) {
    const isPng = [0x89, 0x50, 0x4e, 0x47].every((byte, i) => bytes[i] === byte);
    if (!isPng || bytes[24] > 8) return false;
    for (let i = 3; i < rgba.length; i += 4) if (rgba[i] !== 255) return false;
    return true;
}

const stemOf = (name) => name.replace(/\.[^.]*$/, "");
const canvasOf = (width, height) => Object.assign(document.createElement("canvas"), { width, height });

export async function readPicture(blob, name) {
    let bitmap;
    try {
        bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    } catch {
        throw new Error(`${name}: not a picture that this browser can read`);
    }
    const shrink = Math.min(1, Math.sqrt(MOST_PIXELS / (bitmap.width * bitmap.height)));
    const columns = Math.max(1, Math.round(bitmap.width * shrink)), rows = Math.max(1, Math.round(bitmap.height * shrink));
    const canvas = canvasOf(columns, rows);
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, columns, rows);
    const rgba = context.getImageData(0, 0, columns, rows).data;
    const isExact = shrink === 1 && isPlainPng(new Uint8Array(await blob.slice(0, 32).arrayBuffer()), rgba);
    const commandName = isExact ? name : `${stemOf(name)}-as-read.png`;
    return { name, blob, commandName, columns, rows, rgba: rgba.buffer, canvas, isExact, isSmaller: shrink < 1, changes: "" };
}

// The pixels of a part, in percent cut off each side: the first ones, and the numbers of them.
function pixelsOf({ left, right, top, bottom }, columns, rows) {
    for (const [before, after, names] of [[left, right, "left and right"], [top, bottom, "top and bottom"]])
        if (!(before >= 0 && after >= 0 && before + after < 100))
            throw new Error(`crop ${before} % and ${after} %: ${names} must be at least 0 and together under 100 %`);
    const span = (size, before, after) => {
        const first = Math.min(size - 1, Math.round((size * before) / 100));
        return [first, Math.max(1, size - first - Math.round((size * after) / 100))];
    };
    return [span(columns, left, right), span(rows, top, bottom)];
}

// The picture turned right by `turns` quarters, and then without what `cut` cuts off its sides.
export function changed(picture, turns, cut) {
    const { columns: across, rows: down } = picture;
    const [w, h] = turns % 2 ? [down, across] : [across, down];
    const [[left, columns], [top, rows]] = pixelsOf(cut, w, h);
    const isCropped = columns < w || rows < h;
    if (!turns && !isCropped) return { ...picture };
    const at = [(x, y) => y * across + x, (x, y) => (down - 1 - x) * across + y,
        (x, y) => (down - 1 - y) * across + across - 1 - x, (x, y) => x * across + across - 1 - y][turns];
    const from = new Uint32Array(picture.rgba), to = new Uint32Array(columns * rows);
    for (let y = 0, i = 0; y < rows; ++y)
        for (let x = 0; x < columns; ++x) to[i++] = from[at(left + x, top + y)];
    const canvas = canvasOf(columns, rows);
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.putImageData(new ImageData(new Uint8ClampedArray(to.buffer), columns, rows), 0, 0);
    const rgba = context.getImageData(0, 0, columns, rows).data.buffer; // as a saved PNG has it
    const changes = [turns && "turned", isCropped && "cropped"].filter(Boolean).join(" and ");
    // What the command does to the same picture, if it reads the same numbers.
    const options = [turns && ["turn", String(90 * turns)], isCropped && ["crop", `${left},${top},${columns},${rows}`]];
    return { ...picture, commandName: `${stemOf(picture.name)}-${isCropped ? "cropped" : "turned"}.png`,
        columns, rows, rgba, canvas, changes, isExact: false, options: picture.isExact && options.filter(Boolean) };
}

// Shows a whole picture on a canvas, on which the user drags the part that is wanted.
export class Cropper {
    // `take(cut)` is called with what a drag cuts off each side, in percent.
    constructor(canvas, take) {
        Object.assign(this, { canvas, take, picture: null, cut: null, from: null });
        new ResizeObserver(() => this.draw()).observe(canvas);
        canvas.addEventListener("pointerdown", (event) => {
            canvas.setPointerCapture(event.pointerId);
            this.from = this.at(event);
        });
        canvas.addEventListener("pointermove", (event) => this.from && this.reach(this.at(event)));
        canvas.addEventListener("pointerup", (event) => this.end(this.at(event)));
        canvas.addEventListener("pointercancel", () => (this.from = null));
    }

    open(picture, cut) {
        Object.assign(this, { picture, cut, from: null });
        this.canvas.hidden = false;
        this.draw();
    }

    close() {
        this.picture = null;
        this.canvas.hidden = true;
    }

    // Where the picture lies on the canvas: its left upper corner and its sides, in CSS pixels.
    place() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        const scale = Math.min(width / this.picture.columns, height / this.picture.rows);
        const w = this.picture.columns * scale, h = this.picture.rows * scale;
        return { x: (width - w) / 2, y: (height - h) / 2, w, h };
    }

    // The place of an event in the picture, in percent of its sides.
    at(event) {
        if (!this.picture) return null;
        const { x, y, w, h } = this.place();
        const held = (value) => Math.round(1000 * Math.min(1, Math.max(0, value))) / 10;
        return [held((event.offsetX - x) / w), held((event.offsetY - y) / h)];
    }

    reach([x, y]) {
        const [left, right] = [this.from[0], x].sort((a, b) => a - b);
        const [top, bottom] = [this.from[1], y].sort((a, b) => a - b);
        const rest = (value) => Math.round(10 * (100 - value)) / 10;
        this.cut = { left, right: rest(right), top, bottom: rest(bottom) };
        this.draw();
    }

    // A click, and a part that is too small to be meant, change nothing.
    end(to) {
        if (!this.from || !to) return;
        const LEAST = 2; // percent
        const isMeant = to.every((value, i) => Math.abs(value - this.from[i]) >= LEAST);
        if (isMeant) this.reach(to);
        this.from = null;
        if (isMeant) this.take(this.cut);
    }

    draw() {
        const { canvas, picture, cut } = this;
        if (!picture || !canvas.clientWidth) return;
        const ratio = Math.min(2, devicePixelRatio || 1);
        canvas.width = canvas.clientWidth * ratio;
        canvas.height = canvas.clientHeight * ratio;
        const context = canvas.getContext("2d");
        context.scale(ratio, ratio);
        const { x, y, w, h } = this.place();
        context.globalAlpha = 0.35;
        context.drawImage(picture.canvas, x, y, w, h);
        context.globalAlpha = 1;
        const part = [x + (w * cut.left) / 100, y + (h * cut.top) / 100,
            (w * (100 - cut.left - cut.right)) / 100, (h * (100 - cut.top - cut.bottom)) / 100];
        context.save();
        context.beginPath();
        context.rect(...part);
        context.clip();
        context.drawImage(picture.canvas, x, y, w, h);
        context.restore();
        context.strokeStyle = "#c2410c";
        context.lineWidth = 2;
        context.strokeRect(...part);
    }
}
