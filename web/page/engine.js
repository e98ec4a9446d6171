// Passes requests to a worker and returns promises. Cancelling a request terminates the worker. A
// second worker is ready, so that the next request need not wait.

export class Cancelled extends Error {}

export async function fetched(name) {
    const response = await fetch(name);
    if (!response.ok) throw new Error(`${name}: the server says ${response.status}`);
    return response;
}

// The module, and the address of the workers' script. As a blob it needs no server when a worker is
// started later, and the page's Content-Security-Policy holds in the worker, too.
async function loaded() {
    const texts = ["calls.js", "worker.js", "lacuna.js"].map(async (name) => (await fetched(name)).text());
    const wasm = fetched("lacuna.wasm").then((response) => response.arrayBuffer());
    const [bytes, ...parts] = await Promise.all([wasm, ...texts]);
    const module = await WebAssembly.compile(bytes).catch((error) => {
        throw new Error(`this browser cannot run Lacuna, which needs WebAssembly with SIMD and exceptions: ${error.message}`);
    });
    return [module, URL.createObjectURL(new Blob(parts, { type: "text/javascript" }))];
}

export class Engine {
    static async load(onShare) {
        return new Engine(...await loaded(), onShare);
    }

    constructor(module, script, onShare) {
        this.module = module;
        this.script = script;
        this.onShare = onShare;
        this.waiting = new Map();
        this.next = 1;
        this.worker = this.start();
        this.spare = null;
    }

    start() {
        const worker = new Worker(this.script);
        worker.onmessage = ({ data }) => this.take(worker, data);
        worker.onerror = (event) => this.drop(new Error(event.message || "the worker failed"));
        worker.postMessage({ module: this.module });
        return worker;
    }

    take(worker, { ready, id, share, result, error, broken }) {
        if (worker !== this.worker || ready) return;
        const asked = this.waiting.get(id);
        if (!asked) return;
        if (share !== undefined) return this.onShare(share);
        this.waiting.delete(id);
        if (!this.spare) this.spare = this.start();
        if (result) return asked.resolve(result);
        asked.reject(new Error(error));
        if (broken) this.replace();
    }

    ask(verb, options) {
        const id = this.next++;
        this.worker.postMessage({ id, verb, options });
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    }

    get isBusy() {
        return this.waiting.size > 0;
    }

    replace() {
        this.worker.terminate();
        this.worker = this.spare || this.start();
        this.spare = null;
        this.forgotten?.();
    }

    drop(error) {
        const all = [...this.waiting.values()];
        this.waiting.clear();
        this.replace();
        all.forEach((asked) => asked.reject(error));
    }

    cancel() {
        if (this.isBusy) this.drop(new Cancelled("cancelled"));
    }
}
