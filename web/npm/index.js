// The functions of the npm package. web/CMakeLists.txt puts begin.js, lacuna.js and calls.js before
// them.
const verbs = verbsOf(Module);

// { sizeByTone: 0.5, invert: true } is --size-by-tone 0.5 --invert.
function make(command, options) {
    const words = [command];
    for (const [name, value] of Object.entries(options)) {
        if (value === undefined || value === false) continue;
        if (name === "mask") throw new Error("mask: is a file, which is possible with the program lacuna alone");
        if (typeof value === "object" && !Array.isArray(value))
            throw new TypeError(`${name}: must be a text, a number, true or a list, not ${value?.constructor.name ?? value}`);
        words.push(name.replace(/[A-Z]/g, (letter) => "-" + letter.toLowerCase()));
        words.push(value === true ? "" : String(value));
    }
    if (words.some((word) => word.includes("\n"))) throw new Error("options: each must be one line");
    return verbs.make({ form: words.map((word) => word + "\n").join("") });
}

function sample(options = {}) {
    return make("sample", options);
}

function stipple({ width, height, data }, options = {}) {
    const pixels = width * height;
    if (!(Number.isInteger(width) && Number.isInteger(height) && pixels > 0))
        throw new RangeError(`image: ${width} x ${height}: must be whole numbers of at least 1`);
    if (data.BYTES_PER_ELEMENT !== 1 || data.length !== 4 * pixels)
        throw new RangeError(`image.data: must be ${4 * pixels} bytes: red, green, blue, alpha of each pixel`);
    verbs.picture({ columns: width, rows: height, rgba: data });
    return make("stipple", options);
}

// An ES module that imports this file finds the functions in the global object: a file that node
// can require has no exports of ES modules.
globalThis[Symbol.for("lacuna")] = { sample, stipple };
if (typeof module === "object") module.exports = { sample, stipple };
