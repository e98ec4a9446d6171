// Draws dots, the picture and spectra on canvases; zooms and moves the view.

// Draws a round dot into `bare`, the share of paper that no dot covers, with smooth edges; the sum
// of its ink is its area. Dots of a few pixels lie beside each other: what they cover is added.
function splat(bare, width, height, x, y, r) {
    const reach = r + 0.5;
    const left = Math.max(0, Math.floor(x - reach)), right = Math.min(width - 1, Math.ceil(x + reach));
    const top = Math.max(0, Math.floor(y - reach)), bottom = Math.min(height - 1, Math.ceil(y + reach));
    let share = 1;
    if (r < 0.5) share = (3 * r * r) / (reach * reach * reach);
    else if (r < 1.5) share = (r * r) / (r * r + 1 / 12);
    for (let row = top; row <= bottom; ++row) {
        const dy = row + 0.5 - y;
        for (let column = left; column <= right; ++column) {
            const dx = column + 0.5 - x;
            const cover = reach - Math.sqrt(dx * dx + dy * dy);
            if (cover <= 0) continue;
            const ink = share * Math.min(1, cover), at = row * width + column;
            bare[at] = r < 1.5 ? Math.max(0, bare[at] - ink) : bare[at] * (1 - ink);
        }
    }
}

// The page and the domain's position on it, in units of the domain; as in host/drawing/page.cpp.
export function pageOf(set) {
    if (!set.paper) return { width: set.width, height: set.height, left: 0, bottom: 0, mm: null };
    const [w, h, margin] = set.paper;
    const mm = Math.min((w - 2 * margin) / set.width, (h - 2 * margin) / set.height);
    return { width: w / mm, height: h / mm, mm,
        left: (w / mm - set.width) / 2, bottom: (h / mm - set.height) / 2 };
}

// The diameter of a dot; by default two thirds of the radius, as in the command.
export function diameterOf(set, i) {
    if (set.diameters) return set.diameters[i];
    const count = Math.max(1, set.points.length / 2);
    const radius = set.radius > 0 ? set.radius : Math.sqrt(0.69656 * set.width * (set.height / count));
    return (Math.min(radius, set.width, set.height) / 3) * 2;
}

// The inks of a set: the index of the first dot, the number of dots, and the colour, 0xrrggbb.
export function layersOf(set) {
    let first = 0;
    const layers = set.layers?.length ? set.layers : [{ dots: set.points.length / 2, colour: 0, opaque: 0 }];
    return layers.map((layer) => ({ ...layer, first: (first += layer.dots) - layer.dots }));
}

// Red, green and blue of 0xrrggbb, 0 to 1.
export const numbersOf = (colour) => [16, 8, 0].map((shift) => ((colour >> shift) & 255) / 255);

const MM_OF_PAGE = (512 / 72) * 25.4; // the longer side without paper: 512 pt
const mmPerUnit = (set, page) => page.mm ?? MM_OF_PAGE / Math.max(set.width, set.height);

// The width of a layer's line, in the domain's unit: its pen's, if it has one.
export const lineWidthOf = (set, page, pen) => (pen ? pen / mmPerUnit(set, page) : set.lineWidth);

// The radii and the angle of a dot's ellipse, as drawn. A stroke is 2 a long and 2 b wide.
export function ovalOf(set, i) {
    const [a, b, angle] = set.ellipses.subarray(3 * i, 3 * i + 3);
    const r = diameterOf(set, i) / 2;
    return set.areStrokes ? { a, b, angle } : { a: r * Math.sqrt(a / b), b: r * Math.sqrt(b / a), angle };
}

// Sets `bare` to the share of paper that a layer's ellipses, strokes or line leave, by the browser's drawing.
function drawMarks(bare, { first, dots, pen }, set, page, place, scale, width, height) {
    const AT_ONCE = 500; // marks in a path: one of all marks takes long
    const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d", { willReadFrequently: true });
    context.lineCap = context.lineJoin = "round";
    if (set.lineWidth) context.lineWidth = lineWidthOf(set, page, pen) * scale;
    for (let begin = first; begin < first + dots; begin += AT_ONCE) {
        context.beginPath();
        for (let i = begin; i < Math.min(begin + AT_ONCE + (set.lineWidth ? 1 : 0), first + dots); ++i) {
            const [x, y] = place(i);
            if (set.lineWidth) {
                context.lineTo(x, y);
                continue;
            }
            const { a, b, angle } = ovalOf(set, i), away = set.areStrokes ? a - b : a;
            const dx = away * scale * Math.cos(angle), dy = -away * scale * Math.sin(angle);
            context.moveTo(x + dx, y + dy);
            if (set.areStrokes) context.lineTo(x - dx, y - dy);
            else context.ellipse(x, y, a * scale, b * scale, -angle, 0, 2 * Math.PI);
            context.lineWidth = 2 * b * scale;
        }
        if (set.lineWidth || set.areStrokes) context.stroke();
        else context.fill();
    }
    const { data } = context.getImageData(0, 0, width, height);
    for (let i = 0; i < bare.length; ++i) bare[i] = 1 - data[4 * i + 3] / 255;
}

// Fills an ImageData with dots; `scale`: pixels per unit; (x, y): the page's upper left corner.
// Layers whose index is in `hidden` are left out.
// Transparent inks multiply what lies under them, and opaque ones cover it, in numbers of sRGB, as
// every viewer makes a picture smaller.
export function drawDots(image, set, page, scale, x, y, hidden = new Set()) {
    const { width, height, data } = image;
    const place = (i) => [x + (page.left + set.points[2 * i]) * scale,
        y + (page.height - page.bottom - set.points[2 * i + 1]) * scale];
    const bare = new Float32Array(width * height);
    const channels = numbersOf(set.paperColour).map((paper) => new Float32Array(width * height).fill(paper));
    for (const [index, layer] of layersOf(set).entries()) {
        if (hidden.has(index)) continue;
        const { first, dots, colour, opaque } = layer;
        const isDrawn = set.lineWidth || set.ellipses;
        if (isDrawn) drawMarks(bare, layer, set, page, place, scale, width, height);
        else bare.fill(1);
        for (let i = first; i < first + dots && !isDrawn; ++i) {
            const [px, py] = place(i);
            const r = (diameterOf(set, i) / 2) * scale;
            if (px > -r - 1 && py > -r - 1 && px < width + r + 1 && py < height + r + 1)
                splat(bare, width, height, px, py, r);
        }
        numbersOf(colour).forEach((ink, c) => {
            const channel = channels[c];
            for (let i = 0; i < bare.length; ++i)
                channel[i] = opaque ? channel[i] * bare[i] + ink * (1 - bare[i]) : channel[i] * (ink + (1 - ink) * bare[i]);
        });
    }
    channels.forEach((channel, c) => {
        for (let i = 0; i < channel.length; ++i) data[4 * i + c] = 255 * channel[i];
    });
    const inside = (row, column) => column + 0.5 > x && row + 0.5 > y &&
        column + 0.5 < x + page.width * scale && row + 0.5 < y + page.height * scale;
    for (let row = 0, i = 0; row < height; ++row)
        for (let column = 0; column < width; ++column, ++i) data[4 * i + 3] = inside(row, column) ? 255 : 0;
}

export class View {
    constructor(canvas, onZoom) {
        this.canvas = canvas;
        this.onZoom = onZoom;
        this.set = null;
        this.page = null;
        this.picture = null; // drawn over the left part; `share` is that part's width, 0 to 1
        this.share = 0;
        this.hidden = new Set(); // the indices of layers that are not drawn
        this.reset();
        this.pointers = new Map();
        new ResizeObserver(() => this.draw()).observe(canvas);
        canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
        canvas.addEventListener("pointerdown", (event) => this.onDown(event));
        canvas.addEventListener("pointermove", (event) => this.onMove(event));
        for (const name of ["pointerup", "pointercancel"])
            canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
        canvas.addEventListener("keydown", (event) => this.onKey(event));
    }

    reset() {
        this.zoom = 1;
        this.middle = [0.5, 0.5]; // the page's point in the canvas' middle, in the page's sides
        this.draw();
    }

    show(set, page) {
        this.set = set;
        this.page = page;
        this.draw();
    }

    draw() {
        if (this.asked) return;
        this.asked = requestAnimationFrame(() => {
            this.asked = 0;
            this.paint();
        });
    }

    place() {
        const { width, height } = this.canvas;
        const scale = Math.min(width / this.page.width, height / this.page.height) * this.zoom;
        return { scale, x: width / 2 - this.middle[0] * this.page.width * scale,
            y: height / 2 - this.middle[1] * this.page.height * scale };
    }

    paint() {
        const { canvas, set, page } = this;
        const ratio = Math.min(2, devicePixelRatio || 1);
        canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
        canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
        if (!set) return;
        const context = canvas.getContext("2d");
        const { scale, x, y } = this.place();
        const image = context.createImageData(canvas.width, canvas.height);
        drawDots(image, set, page, scale, x, y, this.hidden);
        context.putImageData(image, 0, 0);
        if (!this.picture || this.share <= 0) return;
        const left = x + page.left * scale, top = y + (page.height - page.bottom - set.height) * scale;
        const edge = left + set.width * scale * this.share;
        context.save();
        context.beginPath();
        context.rect(left, top, edge - left, set.height * scale);
        context.clip();
        context.drawImage(this.picture, left, top, set.width * scale, set.height * scale);
        context.restore();
        context.fillStyle = "#c2410c";
        context.fillRect(edge - ratio, top, 2 * ratio, set.height * scale);
    }

    // The point of the page at (px, py), in pixels of the canvas, stays where it is.
    zoomBy(factor, px = this.canvas.width / 2, py = this.canvas.height / 2) {
        if (!this.set) return;
        const before = this.place();
        const at = [(px - before.x) / before.scale / this.page.width,
            (py - before.y) / before.scale / this.page.height];
        this.zoom = Math.min(64, Math.max(1, this.zoom * factor));
        const after = this.place();
        this.moveBy(px - (after.x + at[0] * this.page.width * after.scale),
            py - (after.y + at[1] * this.page.height * after.scale));
        this.onZoom?.(this.zoom);
    }

    moveBy(dx, dy) {
        if (!this.set) return;
        const { scale } = this.place();
        const room = 0.5 - 0.5 / this.zoom;
        const held = (value) => Math.min(0.5 + room, Math.max(0.5 - room, value));
        this.middle = [held(this.middle[0] - dx / scale / this.page.width),
            held(this.middle[1] - dy / scale / this.page.height)];
        this.draw();
    }

    at(event) {
        const ratio = this.canvas.width / this.canvas.clientWidth;
        return [event.offsetX * ratio, event.offsetY * ratio];
    }

    onWheel(event) {
        if (!event.ctrlKey && this.zoom === 1 && event.deltaY > 0) return; // the page scrolls
        event.preventDefault();
        this.zoomBy(Math.exp(-event.deltaY / 400), ...this.at(event));
    }

    onDown(event) {
        this.pointers.set(event.pointerId, this.at(event));
        this.canvas.setPointerCapture(event.pointerId);
    }

    onMove(event) {
        const before = this.pointers.get(event.pointerId);
        if (!before) return;
        const now = this.at(event);
        const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
        if (other) {
            const apart = (a) => Math.hypot(a[0] - other[0], a[1] - other[1]);
            this.zoomBy(apart(now) / Math.max(1, apart(before)),
                (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
        } else {
            this.moveBy(now[0] - before[0], now[1] - before[1]);
        }
        this.pointers.set(event.pointerId, now);
    }

    onKey(event) {
        const step = 0.1 * this.canvas.width;
        const moves = { ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (moves[event.key]) this.moveBy(...moves[event.key]);
        else if (event.key === "+" || event.key === "=") this.zoomBy(1.5);
        else if (event.key === "-") this.zoomBy(1 / 1.5);
        else if (event.key === "0") this.reset(), this.onZoom?.(1);
        else return;
        event.preventDefault();
    }
}

// Brightness is power: white is about 3.2 times the mean power of random points.
export function drawSpectrum(canvas, { side, powers }) {
    canvas.width = canvas.height = side;
    const context = canvas.getContext("2d");
    const image = context.createImageData(side, side);
    powers.forEach((power, i) => {
        image.data[4 * i] = image.data[4 * i + 1] = image.data[4 * i + 2] = Math.min(255, power * 80);
        image.data[4 * i + 3] = 255;
    });
    context.putImageData(image, 0, 0);
}

// The radial mean as an svg path in a box of 300 x 120, frequencies up to `most`, powers up to 2.
export function radialPath(radial, most) {
    let path = "";
    for (let i = 0; i < radial.length; i += 2)
        if (radial[i] <= most)
            path += `${path ? "L" : "M"}${((radial[i] / most) * 300).toFixed(1)} ` +
                (120 - Math.min(2, radial[i + 1]) * 60).toFixed(1);
    return path;
}
