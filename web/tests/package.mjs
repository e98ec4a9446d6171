// Compares the npm package with the command: node web/tests/package.mjs PACKAGE_FOLDER PROGRAM
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";

const [folder, program] = process.argv.slice(2).map((argument) => path.resolve(argument));
const { sample, stipple } = await import(path.join(folder, "index.js"));
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

try {
    const made = sample({ radius: 0.02, torus: true, seed: 1n, relax: undefined, snap: false });
    const count = made.points.length / 2;
    assert.ok(count > 1500 && made.width === 1 && made.height === 1 && made.radius === 0.02);
    const words = ["sample", "--radius", "0.02", "--torus", "--seed", "1"];
    assert.deepEqual(made.points, written(words, count));

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
    ])
        assert.throws(() => sample(options), { message });
    assert.throws(() => sample({ radius: "0.1\ntorus\n" }), /one line/);
    assert.throws(() => stipple({ width, height, data: data.subarray(4) }), /must be 4800 bytes/);
    assert.throws(() => stipple({ width: 0.5, height, data }), /must be whole numbers/);
    assert.equal(sample({ radius: 0.1, seed: 5 }).diameters, null);
    console.log(`web: the npm package makes ${count} points and 500 dots with the command's bytes`);
} finally {
    rmSync(scratch, { recursive: true });
}
