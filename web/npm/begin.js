// The beginning of the npm package, for lacuna.js, which web/CMakeLists.txt puts after it. WASM is
// the module as a text, so that it begins at once, in node and browsers alike, whichever way the
// package is loaded.
const self = globalThis.self ?? { location: { href: "" } }; // lacuna.js looks where a worker lies

var Module = {
    instantiateWasm(imports, done) {
        const bytes = Uint8Array.from(atob(WASM), (one) => one.charCodeAt(0));
        const instance = new WebAssembly.Instance(new WebAssembly.Module(bytes), imports);
        done(instance);
        return instance.exports;
    },
    tell() {},
};
