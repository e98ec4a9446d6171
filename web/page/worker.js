// Runs Lacuna for the page: takes one request at a time and sends its progress and its result.
// engine.js puts calls.js before this and lacuna.js, which cannot be strict, after it.

let verbs = null;
let current = 0; // the id of the current request
let told = 0; // when progress was last sent, in ms

const started = new Promise((resolve) => {
    self.Module = {
        instantiateWasm(imports, done) {
            self.addEventListener("message", ({ data }) => {
                // Requests may come before the module is ready.
                self.addEventListener("message", (event) => started.then(() => serve(event.data)));
                WebAssembly.instantiate(data.module, imports).then((instance) => done(instance));
            }, { once: true });
            return {};
        },
        onRuntimeInitialized() {
            verbs = verbsOf(self.Module);
            resolve();
            postMessage({ ready: true });
        },
        tell(share) {
            const now = performance.now();
            if (now - told < 50) return;
            told = now;
            postMessage({ id: current, share });
        },
    };
});

function serve({ id, verb, options }) {
    current = id;
    try {
        const result = verbs[verb](options);
        const buffers = Object.values(result).filter(ArrayBuffer.isView).map((view) => view.buffer);
        postMessage({ id, result }, buffers);
    } catch (error) {
        // After a trap, for example when memory runs out, the module cannot be used any more.
        postMessage({ id, error: error.message, broken: error instanceof WebAssembly.RuntimeError });
    }
}
