// The files that the page makes itself, and how it saves them.
import { pdfOf } from "./pdf.js";
import { diameterOf, drawDots, layersOf, lineWidthOf, ovalOf } from "./view.js";

const POINTS_PER_INCH = 72, MM_PER_INCH = 25.4, PAGE_POINTS = 512;

export function save(blob, name) {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

export const asPng = (canvas) => new Promise((resolve) => canvas.toBlob(resolve, "image/png"));

export function drawn({ set, page }) {
    const scale = 2048 / Math.max(page.width, page.height);
    const canvas = Object.assign(document.createElement("canvas"),
        { width: Math.max(1, Math.round(page.width * scale)), height: Math.max(1, Math.round(page.height * scale)) });
    const context = canvas.getContext("2d");
    const image = context.createImageData(canvas.width, canvas.height);
    drawDots(image, set, page, scale, 0, 0);
    for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
    context.putImageData(image, 0, 0);
    return asPng(canvas);
}

export function asPdf({ set, page }) {
    const scale = page.mm ? (page.mm / MM_PER_INCH) * POINTS_PER_INCH : PAGE_POINTS / Math.max(set.width, set.height);
    const dot = (i) => {
        const one = { x: (page.left + set.points[2 * i]) * scale, y: (page.bottom + set.points[2 * i + 1]) * scale,
            diameter: diameterOf(set, i) * scale };
        if (!set.ellipses) return one;
        const { a, b, angle } = ovalOf(set, i), x = Math.cos(angle) * scale, y = Math.sin(angle) * scale;
        return set.areStrokes ? { ...one, diameter: 2 * b * scale, dx: (a - b) * x, dy: (a - b) * y }
            : { ...one, ax: a * x, ay: a * y, bx: -b * y, by: b * x };
    };
    const layers = layersOf(set).map(({ first, dots, colour, opaque, pen }) => ({ colour, opaque,
        line: set.lineWidth && lineWidthOf(set, page, pen) * scale,
        dots: Array.from({ length: dots }, (_, i) => dot(first + i)) }));
    return pdfOf({ width: page.width * scale, height: page.height * scale, colour: set.paperColour }, layers);
}
