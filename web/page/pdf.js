// Dots as a PDF (PDF 1.4): each is a line of 0.01 pt with round caps.

async function deflated(text) {
    const bytes = new TextEncoder().encode(text);
    if (!self.CompressionStream) return null;
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

const short = (number) => String(+number.toFixed(3));

// `page` is the size in points, and each dot is {x, y, diameter} in points, y upwards.
export async function pdfOf(page, dots) {
    const lines = ["1 J"];
    let last = null;
    for (const { x, y, diameter } of dots) {
        const width = short(diameter);
        if (width !== last) lines.push(`${(last = width)} w`);
        lines.push(`${short(x)} ${short(y)} m ${short(x + 0.01)} ${short(y)} l S`);
    }
    const text = lines.join("\n");
    const packed = await deflated(text);
    const content = packed ?? new TextEncoder().encode(text);
    const filter = packed ? "/Filter /FlateDecode " : "";
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
    put("%PDF-1.4\n");
    object("<< /Type /Catalog /Pages 2 0 R >>");
    object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
    object(`<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ${short(page.width)} ${short(page.height)}] ` +
        "/Contents 4 0 R /Resources << >> >>");
    offsets.push(size);
    put(`4 0 obj\n<< ${filter}/Length ${content.length} >>\nstream\n`);
    put(content);
    put("\nendstream\nendobj\n");
    const start = size;
    put(`xref\n0 5\n0000000000 65535 f \n${offsets
        .map((at) => `${String(at).padStart(10, "0")} 00000 n \n`).join("")}` +
        `trailer\n<< /Size 5 /Root 1 0 R >>\nstartxref\n${start}\n%%EOF\n`);
    return new Blob(parts, { type: "application/pdf" });
}
