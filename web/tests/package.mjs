// Compares the npm package with the command and with tests/pinned.txt:
// node web/tests/package.mjs PACKAGE_FOLDER PROGRAM
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";

const [folder, program] = process.argv.slice(2).map((argument) => path.resolve(argument));
const required = createRequire(import.meta.url)(folder);
const entry = JSON.parse(readFileSync(path.join(folder, "package.json"))).exports.import;
const { sample, stipple } = await import(path.join(folder, entry));
assert.ok(required.sample === sample && required.stipple === stipple);
const scratch = mkdtempSync(path.join(tmpdir(), "lacuna-"));

// The coordinates that the command writes; an .npy ends with them.
function written(words, count) {
    const file = path.join(scratch, "points.npy");
    execFileSync(program, [...words, "--quiet", "-o", file]);
    const bytes = readFileSync(file);
    const header = 10 + bytes.readUInt16LE(8);
    assert.equal(bytes.length - header, 16 * count);
    return new Float64Array(bytes.buffer.slice(bytes.byteOffset + header, bytes.byteOffset + bytes.length));
}

// The options of a request's words: --lines-per-radius 3 is linesPerRadius: "3".
function optionsOf(words) {
    const options = {};
    for (let i = 0; i < words.length; ++i) {
        const name = words[i].slice(2).replace(/-(.)/g, (_, letter) => letter.toUpperCase());
        options[name] = i + 1 === words.length || words[i + 1].startsWith("--") ? true : words[++i];
    }
    return options;
}

// The .npy of N points, as the command writes it.
function npyOf(points) {
    const shape = `{'descr': '<f8', 'fortran_order': False, 'shape': (${points.length / 2}, 2), }`;
    const text = shape.padEnd(Math.ceil((shape.length + 11) / 64) * 64 - 11) + "\n";
    const start = Buffer.from("\x93NUMPY\x01\x00\x00\x00" + text, "latin1");
    start.writeUInt16LE(text.length, 8);
    return Buffer.concat([start, Buffer.from(points.buffer, points.byteOffset, points.byteLength)]);
}

function checkPinned() {
    const table = new URL("../../tests/pinned.txt", import.meta.url);
    const rows = readFileSync(table, "utf8").split("\n").map((row) => row.split(" "));
    const own = rows.filter(([hash, doors]) => hash !== "#" && /^b?p?n$/.test(doors ?? ""));
    assert.ok(own.length > 10);
    for (const [hash, , command, ...words] of own) {
        assert.equal(command, "sample");
        const made = createHash("sha256").update(npyOf(sample(optionsOf(words)).points)).digest("hex");
        assert.equal(made, hash, words.join(" "));
    }
    return own.length;
}

try {
    const pinned = checkPinned();
    const made = sample({ radius: 0.02, torus: true, seed: 1n, relax: undefined, snap: false });
    const count = made.points.length / 2;
    assert.ok(count > 1500 && made.width === 1 && made.height === 1 && made.radius === 0.02);
    const words = ["sample", "--radius", "0.02", "--torus", "--seed", "1"];
    assert.deepEqual(made.points, written(words, count));

    const pixels = sample({ onPixels: "8x4", count: 5 });
    assert.deepEqual(pixels.points, written(["sample", "--on-pixels", "8x4", "--count", "5"], 5));
    assert.equal(pixels.width, 8);

    const [width, height] = [40, 30];
    const data = new Uint8ClampedArray(4 * width * height).fill(255);
    const rgb = [];
    for (let i = 0; i < width * height; ++i)
        for (let channel = 0; channel < 3; ++channel)
            rgb.push((data[4 * i + channel] = (i * (7 + channel)) % 256));
    const picture = path.join(scratch, "picture.ppm");
    writeFileSync(picture, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), Buffer.from(rgb)]));
    const image = { width, height, data };
    const dots = stipple(image, { count: 500, autoLevels: true });
    assert.equal(dots.points.length, 1000);
    assert.deepEqual(
        dots.points,
        written(["stipple", picture, "--count", "500", "--auto-levels"], 500),
    );
    const inks = stipple(image, { count: 300, inks: ["black", "red"], sizeByTone: 1 });
    assert.equal(inks.diameters.length, 300);
    assert.equal(inks.layers.reduce((sum, { dots }) => sum + dots, 0), 300);

    for (const [options, message] of [
        [{ radius: -1 }, "radius -1: must be a finite number greater than 0"],
        [{ radius: true }, "radius given: must have a value"],
        [{ radius: 0.1, torus: 5 }, "torus 5: must have no value"],
        [{ radius: 0.1, inside: "a.svg" }, "inside a.svg: is possible with the program lacuna alone"],
        [{ lightYears: 1 }, "light-years 1: is no option of this command"],
        [
            { radius: 0.1, mask: new Uint8Array(9) },
            "mask: is a file, which is possible with the program lacuna alone",
        ],
        [
            { radius: new Float64Array(1) },
            "radius: must be a text, a number, true or a list, not Float64Array",
        ],
        [{ radius: null }, "radius: must be a text, a number, true or a list, not null"],
    ])
        assert.throws(() => sample(options), { message });
    assert.throws(() => sample({ radius: "0.1\ntorus\n" }), /one line/);
    assert.throws(() => stipple({ width, height, data: data.subarray(4) }), /must be 4800 bytes/);
    assert.throws(() => stipple({ width: 0.5, height, data }), /must be whole numbers/);
    assert.equal(sample({ radius: 0.1, seed: 5 }).diameters, null);
    // The types list what the functions accept.
    const types = readFileSync(path.join(folder, "index.d.ts"), "utf8");
    const keysOf = (name) => {
        const [, more, body] = types.match(new RegExp(`interface ${name}( extends .*)? {([^}]*)}`));
        const own = [...body.matchAll(/(\w+)\?:/g)].map(([, key]) => key);
        return more ? [...keysOf("Options"), ...own].filter((key) => !more.includes(`"${key}"`)) : own;
    };
    for (const [name, command, make] of [
        ["SampleOptions", "sample", sample],
        ["StippleOptions", "stipple", (options) => stipple(image, options)],
    ]) {
        const help = execFileSync(program, [command, "--help-all"], { encoding: "utf8" });
        const accepted = [...help.matchAll(/^ +(?:-\w,)?--([a-z-]+)/gm)]
            .map(([, option]) => option.replace(/-(.)/g, (_, letter) => letter.toUpperCase()))
            .filter((key) => {
                try {
                    make({ [key]: 1 });
                } catch ({ message }) {
                    return !/with the program lacuna alone|is no option|without --field/.test(message);
                }
                return true;
            });
        assert.deepEqual(keysOf(name).sort(), accepted.sort());
    }
    console.log(`web: the npm package makes ${count} points, 500 dots and ${pinned} pinned sets with the command's bytes`);
} finally {
    rmSync(scratch, { recursive: true });
}
