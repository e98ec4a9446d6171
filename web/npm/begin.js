// The beginning of the npm package: reads the module, for lacuna.js, which web/CMakeLists.txt puts
// after it.
const self = globalThis.self ?? { location: { href: "" } }; // lacuna.js looks where a worker lies

const file = new URL("lacuna.wasm", import.meta.url);
const wasm =
    file.protocol === "file:"
        ? (await import(/* webpackIgnore: true */ /* @vite-ignore */ "node:fs")).readFileSync(file)
        : await (await fetch(file)).arrayBuffer();
let begin;
const begun = new Promise((resolve) => (begin = resolve));
var Module = {
    instantiateWasm(imports, done) {
        WebAssembly.instantiate(wasm, imports).then(({ instance }) => done(instance));
        return {};
    },
    onRuntimeInitialized: () => begin(),
    tell() {},
};
