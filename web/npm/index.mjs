// The npm package as an ES module.
import "./index.js";

export const { sample, stipple } = globalThis[Symbol.for("lacuna")];
