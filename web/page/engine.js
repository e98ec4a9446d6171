// Passes requests to a worker and returns promises. Cancelling a request terminates the worker. A
// second worker is ready, so that the next request need not wait.

export class Cancelled extends Error {}

export class Engine {
    constructor(module, onShare) {
        this.module = module;
        this.onShare = onShare;
        this.waiting = new Map();
        this.next = 1;
        this.worker = this.start();
        this.spare = null;
    }

    start() {
        const worker = new Worker("worker.js");
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
