// Dots as a PDF (PDF 1.4): each is a line of 0.01 pt with round caps, or a longer one if it is a
// stroke; an ellipse is four curves, and a line through all dots is a line. Each ink is a group of its own,
// which multiplies what lies under it or, if it is opaque, covers it.
import { numbersOf } from "./view.js";

async function deflated(text) {
    const bytes = new TextEncoder().encode(text);
    if (!self.CompressionStream) return null;
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

const short = (number) => String(+number.toFixed(3));
const rgb = (colour) => numbersOf(colour).map(short).join(" ");

// An ellipse around (x, y) of four curves; (ax, ay) and (bx, by) are its half axes.
function ellipse({ x, y, ax, ay, bx, by }) {
    const K = 0.5523; // of a half axis: how far a quarter's controls are
    const at = (a, b) => `${short(x + a * ax + b * bx)} ${short(y + a * ay + b * by)}`;
    return `${at(1, 0)} m ${at(1, K)} ${at(K, 1)} ${at(0, 1)} c ${at(-K, 1)} ${at(-1, K)} ${at(-1, 0)} c ` +
        `${at(-1, -K)} ${at(-K, -1)} ${at(0, -1)} c ${at(K, -1)} ${at(1, -K)} ${at(1, 0)} c f`;
}

function marks({ colour, dots, line }) {
    const lines = ["1 J 1 j", `${rgb(colour)} RG ${rgb(colour)} rg`];
    let last = null;
    if (line)
        return [...lines, `${short(line)} w`, ...dots.map(({ x, y }, i) => `${short(x)} ${short(y)} ${i ? "l" : "m"}`), "S"].join("\n");
    for (const dot of dots) {
        const { x, y, diameter, dx = 0, dy = 0 } = dot, width = short(diameter);
        if (dot.bx !== undefined) {
            lines.push(ellipse(dot));
            continue;
        }
        if (width !== last) lines.push(`${(last = width)} w`);
        lines.push(`${short(x - dx)} ${short(y - dy)} m ${short(x + dx + 0.01)} ${short(y + dy)} l S`);
    }
    return lines.join("\n");
}

// Lengths are in points, y upwards; the page and each layer have a colour, 0xrrggbb, and each layer
// has dots: {x, y, diameter}. Strokes have dx and dy to their end, too, and ellipses their half axes
// (ax, ay) and (bx, by). A layer of one line through its dots has the line's width in `line`.
export async function pdfOf(page, layers) {
    const parts = [];
    const offsets = [];
    let size = 0;
    const put = (part) => {
        parts.push(part);
        size += part.length; // in bytes, because texts are ASCII
    };
    const object = (text) => {
        offsets.push(size);
        put(`${offsets.length} 0 obj\n${text}\nendobj\n`);
    };
    const stream = async (text, entries) => {
        const packed = await deflated(text);
        const content = packed ?? new TextEncoder().encode(text);
        offsets.push(size);
        put(`${offsets.length} 0 obj\n<< ${entries}${packed ? "/Filter /FlateDecode " : ""}/Length ${content.length} >>\nstream\n`);
        put(content);
        put("\nendstream\nendobj\n");
    };
    const box = `[0 0 ${short(page.width)} ${short(page.height)}]`;
    const names = layers.map((_, i) => `/L${i}`);
    const firstLayer = 5;
    put("%PDF-1.4\n");
    object("<< /Type /Catalog /Pages 2 0 R >>");
    object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
    object(`<< /Type /Page /Parent 2 0 R /MediaBox ${box} /Contents 4 0 R ` +
        "/Resources << /ExtGState << /M << /BM /Multiply >> /N << /BM /Normal >> >> " +
        `/XObject << ${names.map((name, i) => `${name} ${firstLayer + i} 0 R`).join(" ")} >> >> >>`);
    const paint = page.colour === 0xffffff ? "" : `${rgb(page.colour)} rg\n0 0 ${short(page.width)} ${short(page.height)} re f\n`;
    await stream(paint + layers.map(({ opaque }, i) => `${opaque ? "/N" : "/M"} gs\n${names[i]} Do`).join("\n"), "");
    for (const layer of layers)
        await stream(marks(layer), `/Type /XObject /Subtype /Form /BBox ${box} ` +
            "/Group << /S /Transparency /CS /DeviceRGB >> /Resources << >> ");
    const start = size;
    put(`xref\n0 ${offsets.length + 1}\n0000000000 65535 f \n${offsets
        .map((at) => `${String(at).padStart(10, "0")} 00000 n \n`).join("")}` +
        `trailer\n<< /Size ${offsets.length + 1} /Root 1 0 R >>\nstartxref\n${start}\n%%EOF\n`);
    return new Blob(parts, { type: "application/pdf" });
}
