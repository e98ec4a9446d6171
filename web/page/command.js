// The command line that makes the same file.

// Papers of ISO 216 and ANSI in mm, the same as in host/recipes/read.cpp.
export const PAPERS = {
    A0: [841, 1189], A1: [594, 841], A2: [420, 594], A3: [297, 420], A4: [210, 297],
    A5: [148, 210], A6: [105, 148], letter: [215.9, 279.4], legal: [215.9, 355.6],
    tabloid: [279.4, 431.8],
};

// The whole number that a text means, or null. The command has the same rule, in
// host/recipes/read.cpp, and tests/recipes/whole_numbers.json tests both: 20000, 2e4, 20k, 1.5M,
// or 20,000 with a comma, an underscore, an apostrophe or a blank between groups of three digits.
export function wholeNumber(text) {
    const isGrouped = /^\d{1,3}([,_' ])\d{3}(\1\d{3})*$/.test(text);
    const plain = isGrouped ? text.replace(/\D/g, "")
        : text.replace(/[kKMG]$/, (suffix) => ({ k: "e3", K: "e3", M: "e6", G: "e9" })[suffix]);
    const value = /^(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
    return Number.isSafeInteger(value) ? value : null;
}

// Quotes `word` so that a shell reads it as one word.
function quoted(word) {
    return /^[\w\-./:=,+%@]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

function fileName(name) {
    return quoted(name.startsWith("-") ? `./${name}` : name);
}

// Only options that differ from the command's defaults, in the order of --help. An svg contains
// this line, and the command writes the same line.
export function stippleCommand(name, o) {
    const words = ["lacuna", "stipple", fileName(name)];
    const add = (isGiven, ...more) => isGiven && words.push(...more);
    add(o.metric !== "auto", "--metric", o.metric);
    add(o.invert, "--invert");
    add(!o.autoLevels && o.black !== 0, "--black", o.black);
    add(!o.autoLevels && o.white !== 1, "--white", o.white);
    add(o.autoLevels, "--auto-levels");
    add(o.sharpen !== 0, "--sharpen", o.sharpen);
    add(o.gamma !== 1, "--gamma", o.gamma);
    add(o.count !== null, "--count", o.count);
    add(o.inks !== "", "--inks", quoted(o.inks));
    add(o.seed !== 0, "--seed", o.seed);
    add(o.relax !== 15, "--relax", o.relax);
    add(o.pen !== null, "--dot-size", `${o.pen}mm`);
    add(o.paperName !== "none", "--paper-size", o.paperName);
    add(o.paperName !== "none" && o.margin !== 0, "--margin", `${o.margin}mm`);
    add(o.sizeByTone !== 0, "--size-by-tone", o.sizeByTone);
    add(o.keepInside, "--keep-inside");
    add(o.penPath, "--pen-path");
    return words.join(" ");
}

export function sampleCommand(o) {
    const words = ["lacuna", "sample"];
    const add = (isGiven, ...more) => isGiven && words.push(...more);
    add(o.radius !== null, "--radius", o.radius);
    add(o.count !== null, "--count", o.count);
    add(o.torus, "--torus");
    add(o.seed !== 0, "--seed", o.seed);
    add(o.relax !== 0, "--relax", o.relax);
    add(o.mode !== "exact", "--mode", o.mode);
    return words.join(" ");
}

export function withOutput(command, name) {
    return `${command} -o ${fileName(name)}`;
}
