// The command line that makes the same file.

// ISO 216, and ANSI's, in mm: host/cli/commands/paper.cpp has the same.
export const PAPERS = {
    A0: [841, 1189], A1: [594, 841], A2: [420, 594], A3: [297, 420], A4: [210, 297],
    A5: [148, 210], A6: [105, 148], letter: [215.9, 279.4], legal: [215.9, 355.6],
    tabloid: [279.4, 431.8],
};

// As a shell takes it for one word.
function quoted(word) {
    return /^[\w\-./:=,+%@]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

function fileName(name) {
    return quoted(name.startsWith("-") ? `./${name}` : name);
}

// Options in the order of --help, those that differ from the command's own. An svg tells this line,
// as the command's does.
export function stippleCommand(name, o) {
    const words = ["lacuna", "stipple", fileName(name)];
    const add = (isGiven, ...more) => isGiven && words.push(...more);
    add(o.metric !== "auto", "--metric", o.metric);
    add(o.invert, "--invert");
    add(!o.autoLevels && o.black !== 0, "--black", o.black);
    add(!o.autoLevels && o.white !== 1, "--white", o.white);
    add(o.autoLevels, "--auto-levels");
    add(o.gamma !== 1, "--gamma", o.gamma);
    add(o.count !== null, "--count", o.count);
    add(o.seed !== 0, "--seed", o.seed);
    add(o.relax !== 15, "--relax", o.relax);
    add(o.pen !== null, "--dot-size", `${o.pen}mm`);
    add(o.paperName !== "none", "--paper-size", o.paperName);
    add(o.paperName !== "none" && o.margin !== 0, "--margin", `${o.margin}mm`);
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
