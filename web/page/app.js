// The page: turns its controls into requests, and shows and saves the results.
import { Cancelled, Engine } from "./engine.js";
import { pdfOf } from "./pdf.js";
import { diameterOf, drawDots, layersOf, drawSpectrum, pageOf, radialPath, View } from "./view.js";

const $ = (id) => document.getElementById(id);
const MOST_PIXELS = 4e6; // of a picture; larger ones are scaled down
const MOST_FOR_SPECTRUM = 100000; // points; the spectrum of more would take too long
const FREQUENCIES = 1.5; // largest frequency of the spectrum, in units of sqrt(count)
const QUICK_RELAX = 2; // iterations of the preview
const POINTS_PER_INCH = 72, MM_PER_INCH = 25.4, PAGE_POINTS = 512;
const state = document.documentElement.dataset;

let kind = "stipple";
let picture = null; // { name, columns, rows, rgba, canvas, isExact }
let sent = null; // the picture that the worker has
let held = ""; // the key of the set that the worker has
let shown = null; // { key, set, page } on the canvas
let runs = 0;
let isQuick = false, isWaiting = false, hadLightInks = false;
let timer = 0;
let engine = null;

const view = new View($("view"), (zoom) => {
    $("zoom-all").textContent = `${Math.round(zoom * 100)} %`;
    document.body.classList.toggle("at-rest", zoom === 1);
});

// --- requests
class Refused extends Error {}

const controls = () => [...$(`controls-${kind}`).querySelectorAll("[data-option]")];

// The options that the controls give, as [name, text]. See index.html.
function optionsNow() {
    const options = kind === "stipple" ? [["IMAGE", picture.commandName]] : [];
    for (const control of controls()) {
        const { option, usual, unit = "" } = control.dataset;
        if (option === "" || control.disabled || control.closest("[hidden]")) continue;
        const isFlag = control.type === "checkbox", text = control.value.trim();
        if (isFlag ? !control.checked : text === usual) continue;
        if (text === "") throw new Refused(`${option} empty: must have a value`);
        options.push([option, isFlag ? "" : text + unit]);
    }
    return options;
}

const has = (o, option) => o.some(([name]) => name === option);
const controlOf = (option) => controls().find((control) => control.dataset.option === option);
const relaxOf = (o) => Number(o.find(([name]) => name === "relax")?.[1] ?? controlOf("relax").dataset.usual);
// The same set, placed roughly.
const quick = (o) => [...o.filter(([name]) => name !== "relax" && name !== "pen-path"), ["relax", String(QUICK_RELAX)]];
const formOf = (o) => [kind, ...o.flat()].map((text) => `${text}\n`).join("");
const keyOf = (o) => JSON.stringify([kind, kind === "stipple" && picture.number, o]);
const baseName = () => (kind === "stipple" ? picture.name.replace(/\.[^.]*$/, "") || "dots" : "points");
const grouped = (n) => n.toLocaleString("en");

// --- settings in the page's address, so that a link or a reload has them; the picture is not in it
const fields = () => [...document.querySelectorAll("form input[data-option], form select")];
const defaultOf = (field) => field.type === "checkbox" ? field.defaultChecked
    : field.defaultValue ?? ([...field.options].find((one) => one.defaultSelected) ?? field.options[0]).value;

function remember() {
    const all = new URLSearchParams(kind === "stipple" ? {} : { kind });
    for (const field of fields()) {
        const value = field.type === "checkbox" ? field.checked : field.value;
        if (value !== defaultOf(field)) all.set(field.id, value);
    }
    history.replaceState(null, "", all.toString() ? `#${all}` : location.pathname + location.search);
}

function recall(all) {
    for (const field of fields()) {
        const value = all.get(field.id) ?? defaultOf(field);
        if (field.type === "checkbox") field.checked = String(value) === "true";
        else field.value = value;
    }
    for (const id of ["count-slider", "amount-slider"]) $(id).dispatchEvent(new Event("place"));
    update();
}

// --- messages
function say(text) {
    $("status").textContent = text;
}

function complain(error) {
    document.querySelectorAll("[aria-invalid]").forEach((field) => field.removeAttribute("aria-invalid"));
    $("error").hidden = !error;
    $("error").textContent = error ? error.message : "";
    if (!error) return;
    controlOf(error.message.split(" ")[0])?.setAttribute("aria-invalid", "true");
    say("Nothing was made.");
    state.state = "failed";
}

function busy(isBusy) {
    $("cancel").hidden = $("progress").hidden = !isBusy;
    $("progress").value = 0;
    if (isBusy) state.state = "working";
}

async function showCommand(o) {
    const format = $("format").value;
    const { command } = await engine.ask("command", { form: formOf(o), file: `${baseName()}.${format}` });
    // Lines break only between words of the command.
    const words = command.split(" ");
    $("command").replaceChildren(...words.flatMap((word) =>
        [Object.assign(document.createElement("span"), { textContent: word }), " "]).slice(0, -1));
    $("command-note").textContent = ["png", "pdf"].includes(format)
        ? "The same dots; this file is drawn by the browser, so its bytes differ." : "The same bytes.";
}

// --- making of sets
async function make(o, isFinal) {
    held = "";
    if (kind === "stipple" && sent !== picture) {
        sent = picture;
        await engine.ask("picture", { columns: picture.columns, rows: picture.rows, rgba: picture.rgba });
    }
    return engine.ask("make", { form: formOf(isFinal ? o : quick(o)) });
}

function show(key, set) {
    const isFirst = !shown;
    shown = { key, set, page: pageOf(set) };
    view.show(set, shown.page);
    if (isFirst) requestAnimationFrame(() => setTimeout(() => (state.first = Math.round(performance.now()))));
}

function summary(set, o, seconds) {
    const made = `${grouped(set.points.length / 2)} ${kind === "stipple" ? "dots" : "points"}`;
    const relaxed = relaxOf(o) ? `, relaxed ${relaxOf(o)} times` : "";
    const radius = kind === "sample" && set.radius ? `, radius ${+set.radius.toPrecision(4)}` : "";
    return `${made}${relaxed}${radius}, ${seconds.toFixed(2)} s${set.plot ? `; ${set.plot}` : ""}`;
}

async function run() {
    const mine = ++runs;
    clearTimeout(timer);
    isWaiting = false;
    engine.cancel();
    const isOld = () => mine !== runs;
    const begin = performance.now();
    try {
        const o = optionsNow();
        const key = keyOf(o);
        remember();
        complain(null);
        busy(true);
        await showCommand(o);
        if (isOld()) return;
        if (kind === "stipple" && relaxOf(o) > 2 * QUICK_RELAX) {
            isQuick = true;
            say("Placing the dots …");
            const set = await make(o, false);
            isQuick = false;
            if (isOld()) return;
            show(key, set);
            if (isWaiting) return run();
        }
        say("Working …");
        const set = await make(o, true);
        if (isOld()) return;
        held = key;
        show(key, set);
        say(summary(set, o, (performance.now() - begin) / 1000));
        if (kind === "sample") await judge(set, o, isOld);
        if (isOld()) return;
        busy(false);
        state.state = "done";
    } catch (error) {
        isQuick = false;
        if (isOld()) return;
        if (isWaiting) return run();
        busy(false);
        if (!(error instanceof Cancelled)) return complain(error);
        say("Cancelled.");
        state.state = "cancelled";
    }
}

// While a slider moves, the current preview is finished, and the next one uses the newest values.
function schedule() {
    clearTimeout(timer);
    timer = setTimeout(() => {
        if (!engine || (kind === "stipple" && !picture)) return;
        if (isQuick && engine.isBusy) isWaiting = true;
        else run();
    }, 40);
}

// Shows the verdict and the spectrum of a set.
async function judge(set, o, isOld) {
    if (relaxOf(o)) $("verdict").textContent = "Relaxed points promise no least distance.";
    else {
        const proof = await engine.ask("prove", { radius: set.radius });
        if (isOld()) return;
        const short = (value) => (value === null ? "none" : +value.toPrecision(5));
        $("verdict").textContent = (proof.kept ? `✓ No two points are closer than the radius: the least distance is ${short(proof.least)}.\n`
            : `✗ Two points are closer than the radius: ${short(proof.least)} apart.\n`) +
            (proof.covered ? "✓ No room is left for one more point." : has(o, "count") ? "There is room for more points, because their number was given."
                : `✗ There is room for more points: a spot is ${short(proof.largestGap)} from every point.`);
    }
    const isSmall = set.points.length / 2 <= MOST_FOR_SPECTRUM;
    $("spectrum").classList.toggle("none", !isSmall);
    $("spectrum").querySelector("figcaption").textContent = isSmall ? "Power by frequency: random points have 1 everywhere."
        : `The spectrum is shown for up to ${grouped(MOST_FOR_SPECTRUM)} points.`;
    if (!isSmall) return;
    const spectrum = await engine.ask("spectrum", { most: FREQUENCIES });
    if (isOld()) return;
    drawSpectrum($("powers"), spectrum);
    $("radial").setAttribute("d", radialPath(spectrum.radial, FREQUENCIES));
}

// --- pictures
// Whether the command reads the same numbers: the file is a PNG of up to 8 bits, without alpha.
function isPlainPng(bytes, rgba) {
    const isPng = [0x89, 0x50, 0x4e, 0x47].every((byte, i) => bytes[i] === byte);
    if (!isPng || bytes[24] > 8) return false;
    for (let i = 3; i < rgba.length; i += 4) if (rgba[i] !== 255) return false;
    return true;
}

async function readPicture(blob, name) {
    let bitmap;
    try {
        bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    } catch {
        throw new Error(`${name}: not a picture that this browser can read`);
    }
    const shrink = Math.min(1, Math.sqrt(MOST_PIXELS / (bitmap.width * bitmap.height)));
    const columns = Math.max(1, Math.round(bitmap.width * shrink)), rows = Math.max(1, Math.round(bitmap.height * shrink));
    const canvas = Object.assign(document.createElement("canvas"), { width: columns, height: rows });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, columns, rows);
    const rgba = context.getImageData(0, 0, columns, rows).data;
    const isExact = shrink === 1 && isPlainPng(new Uint8Array(await blob.slice(0, 32).arrayBuffer()), rgba);
    const commandName = isExact ? name : `${name.replace(/\.[^.]*$/, "")}-as-read.png`;
    return { name, commandName, columns, rows, rgba: rgba.buffer, canvas, isExact, isSmaller: shrink < 1,
        number: (picture?.number ?? 0) + 1 };
}

async function take(blob, name) {
    try {
        picture = await readPicture(blob, name);
    } catch (error) {
        return complain(error);
    }
    $("picture-name").textContent = picture.name;
    $("picture-note").textContent = `${grouped(picture.columns)} × ${grouped(picture.rows)} pixels${picture.isSmaller ? ", made smaller" : ""}.`;
    $("picture-as-read").hidden = picture.isExact;
    view.picture = picture.canvas;
    view.reset();
    select("stipple");
}

async function fetched(name) {
    const response = await fetch(name);
    if (!response.ok) throw new Error(`${name}: the server says ${response.status}`);
    return response;
}

async function takeExample(name, inks) {
    const blob = await fetched(name).then((response) => response.blob()).catch(complain);
    if (!blob) return;
    $("ink-kind").value = inks;
    update();
    await take(blob, name);
}

// --- saving
function save(blob, name) {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const asPng = (canvas) => new Promise((resolve) => canvas.toBlob(resolve, "image/png"));

function drawn({ set, page }) {
    const scale = 2048 / Math.max(page.width, page.height);
    const canvas = Object.assign(document.createElement("canvas"),
        { width: Math.max(1, Math.round(page.width * scale)), height: Math.max(1, Math.round(page.height * scale)) });
    const context = canvas.getContext("2d");
    const image = context.createImageData(canvas.width, canvas.height);
    drawDots(image, set, page, scale, 0, 0);
    for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
    context.putImageData(image, 0, 0);
    return asPng(canvas);
}

function asPdf({ set, page }) {
    const scale = page.mm ? (page.mm / MM_PER_INCH) * POINTS_PER_INCH : PAGE_POINTS / Math.max(set.width, set.height);
    const dot = (i) => ({
        x: (page.left + set.points[2 * i]) * scale, y: (page.bottom + set.points[2 * i + 1]) * scale,
        diameter: diameterOf(set, i) * scale });
    const layers = layersOf(set).map(({ first, dots, colour, opaque }) =>
        ({ colour, opaque, dots: Array.from({ length: dots }, (_, i) => dot(first + i)) }));
    return pdfOf({ width: page.width * scale, height: page.height * scale, colour: set.paperColour }, layers);
}

async function download() {
    const format = $("format").value;
    try {
        const o = optionsNow();
        if (held !== keyOf(o)) await run();
        if (held !== keyOf(o)) return; // cancelled, refused, or the controls have changed meanwhile
        const name = `${baseName()}.${format}`;
        if (format === "png") return save(await drawn(shown), name);
        if (format === "pdf") return save(await asPdf(shown), name);
        const { bytes } = await engine.ask("encode", { format });
        save(new Blob([bytes]), name);
        say(`${name}: ${grouped(bytes.length)} bytes.`);
    } catch (error) {
        if (!(error instanceof Cancelled)) complain(error);
    }
}

// --- controls
// Links a slider with a logarithmic scale, from `least` to `most`, to a text field.
function ratioSlider(slider, field, range, digits, onChange) {
    const place = () => {
        const [least, most] = range();
        const value = Number(field.value.replace(/[\s,_']/g, ""));
        if (value > 0) slider.value = (1000 * Math.log(value / least)) / Math.log(most / least);
        slider.setAttribute("aria-valuetext", field.value);
    };
    slider.addEventListener("input", () => {
        const [least, most] = range();
        field.value = String(Number((least * (most / least) ** (slider.value / 1000)).toPrecision(digits)));
        slider.setAttribute("aria-valuetext", field.value);
        onChange();
    });
    field.addEventListener("input", () => (place(), onChange()));
    slider.addEventListener("place", place);
    place();
    return place;
}

function select(wanted) {
    kind = wanted;
    for (const one of ["stipple", "sample"]) {
        const isWanted = one === kind;
        $(`controls-${one}`).hidden = !isWanted;
        $(`tab-${one}`).setAttribute("aria-selected", isWanted);
        $(`tab-${one}`).tabIndex = isWanted ? 0 : -1;
    }
    $("spectrum").hidden = kind !== "sample";
    document.querySelector(".compare").hidden = kind !== "stipple";
    document.body.classList.toggle("sampling", kind === "sample");
    view.picture = kind === "stipple" ? picture?.canvas : null;
    document.title = `Lacuna: ${kind === "stipple" ? "stipple a picture" : "sample points"}`;
    view.reset();
    schedule();
}

function update() {
    for (const id of ["relax", "black", "white", "gamma", "sharpen", "size-by-tone", "sample-relax"]) $(`${id}-value`).textContent = $(id).value;
    const pens = $("pen-kind").value;
    $("pen-row").hidden = pens !== "pen";
    $("pens-row").hidden = pens !== "pens";
    document.querySelectorAll(".tone-row").forEach((part) => (part.hidden = pens !== "radius"));
    $("count").disabled = $("count-slider").disabled = $("plot-time").value !== "";
    $("ink-row").hidden = $("ink-kind").value !== "own";
    // White inks want dark paper, and the usual inks get theirs back.
    const isLight = $("ink-kind").value.startsWith("white"), paper = $("paper-colour");
    if (isLight && paper.value === "#ffffff") paper.value = "#000000";
    if (!isLight && hadLightInks && paper.value === "#000000") paper.value = "#ffffff";
    hadLightInks = isLight;
    $("ink-kind").dataset.option = $("ink-row").hidden ? "inks" : "";
    $("amount").dataset.option = $("by").value;
    $("amount-label").textContent = $("by").value === "radius" ? "Radius" : "Number";
    $("metric-row").hidden = $("ink-kind").value !== "";
    $("margin").disabled = $("paper").value === "none";
    $("black").disabled = $("white").disabled = $("auto-levels").checked;
    schedule();
}

function listen() {
    ratioSlider($("count-slider"), $("count"), () => [100, 250000], 3, schedule);
    const place = ratioSlider($("amount-slider"), $("amount"), () => ($("by").value === "radius" ? [0.2, 0.003] : [20, 100000]), 3, schedule);
    $("by").addEventListener("change", () => {
        const isRadius = $("by").value === "radius";
        $("amount").value = isRadius ? "0.02" : "2000";
        place();
    });
    for (const form of ["controls-stipple", "controls-sample"]) {
        $(form).addEventListener("input", (event) => event.target.id !== "file" && update());
        $(form).addEventListener("submit", (event) => event.preventDefault());
    }
    const tabs = ["stipple", "sample"];
    for (const one of tabs) {
        $(`tab-${one}`).addEventListener("click", () => select(one));
        $(`tab-${one}`).addEventListener("keydown", (event) => {
            if (!["ArrowLeft", "ArrowRight"].includes(event.key)) return;
            const other = tabs[1 - tabs.indexOf(one)];
            select(other);
            $(`tab-${other}`).focus();
        });
    }
    for (const [name, file, inks] of [["raccoon", "raccoon.png", ""], ["hopper", "hopper.jpg", "cmyk"]])
        $(`example-${name}`).addEventListener("click", () => takeExample(file, inks));
    $("file").addEventListener("change", () => $("file").files[0] && take($("file").files[0], $("file").files[0].name));
    document.addEventListener("paste", (event) => {
        const file = [...event.clipboardData.files][0];
        if (file) take(file, file.name || "pasted.png");
    });
    document.addEventListener("dragover", (event) => (event.preventDefault(), document.body.classList.add("dropping")));
    document.addEventListener("dragleave", (event) => event.relatedTarget || document.body.classList.remove("dropping"));
    document.addEventListener("drop", (event) => {
        event.preventDefault();
        document.body.classList.remove("dropping");
        const file = event.dataTransfer.files[0];
        if (file) take(file, file.name);
    });
    $("share").addEventListener("input", () => ((view.share = $("share").value / 100), view.draw()));
    $("zoom-in").addEventListener("click", () => view.zoomBy(1.5));
    $("zoom-out").addEventListener("click", () => view.zoomBy(1 / 1.5));
    $("zoom-all").addEventListener("click", () => (view.reset(), view.onZoom(1)));
    $("cancel").addEventListener("click", () => engine.cancel());
    document.addEventListener("keydown", (event) => event.key === "Escape" && engine?.cancel());
    $("reset").addEventListener("click", () => recall(new URLSearchParams()));
    $("format").addEventListener("change", async () => {
        try {
            await showCommand(optionsNow());
        } catch {} // run() has shown the message
    });
    $("download").addEventListener("click", download);
    $("copy").addEventListener("click", async () => {
        getSelection().selectAllChildren($("command"));
        await navigator.clipboard?.writeText($("command").textContent).then(() => say("Copied."), () => {});
    });
    $("save-picture").addEventListener("click", async () => save(await asPng(picture.canvas), picture.commandName));
}

async function compiled() {
    const bytes = await (await fetched("lacuna.wasm")).arrayBuffer();
    return WebAssembly.compile(bytes).catch((error) => {
        throw new Error(`this browser cannot run Lacuna, which needs WebAssembly with SIMD and exceptions: ${error.message}`);
    });
}

async function start() {
    listen();
    document.body.classList.add("at-rest");
    try {
        const [module, response] = await Promise.all([compiled(), fetch("raccoon.png")]);
        engine = new Engine(module, (share) => ($("progress").value = share));
        engine.forgotten = () => ((sent = null), (held = ""));
        if (picture) schedule(); // given by the user meanwhile
        else {
            const all = new URLSearchParams(location.hash.slice(1));
            recall(all);
            await take(await response.blob(), "raccoon.png");
            if (all.get("kind") === "sample") select("sample");
        }
    } catch (error) {
        complain(error);
    }
}

start();
