// The page: turns its controls into requests, and shows and saves the results.
import { Cancelled, Engine, fetched } from "./engine.js";
import { asPdf, asPng, drawn, save } from "./files.js";
import { hasBlack, InkList } from "./inks.js";
import { changed, Cropper, readPicture } from "./picture.js";
import { setFields, settings, Steps } from "./settings.js";
import { drawSpectrum, pageOf, radialPath, View } from "./view.js";

const $ = (id) => document.getElementById(id);
const MOST_FOR_SPECTRUM = 100000; // points; the spectrum of more would take too long
const CROP_HINT = "Drag over the part to keep. Crop … once more, or Escape, leaves it as it was.";
const FREQUENCIES = 1.5; // largest frequency of the spectrum, in units of sqrt(count)
const QUICK_RELAX = 2; // iterations of the preview
const SIDES = ["left", "right", "top", "bottom"], WHOLE = { left: 0, right: 0, top: 0, bottom: 0 };
const state = document.documentElement.dataset;

let kind = "stipple";
let whole = null; // the picture as it was read: see picture.js
let picture = null; // the same, turned and cropped
let pictures = 0;
let said = ""; // before CROP_HINT
let keepsCrop = false; // whether the next picture is cropped as the link says
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

const inkText = () => $("ink-kind").value === "own" ? $("inks").value : $("ink-kind").value;

const inkList = new InkList($("ink-list"), inkText, (text) => {
    $("ink-kind").value = "own";
    $("inks").value = text;
    update();
}, showEyes);

const cropper = new Cropper($("cropper"), (cut) => {
    setCrop(turnsNow(), cut);
    changePicture();
});

const steps = new Steps(() => settings(kind), recall, ({ canUndo, canRedo }) => {
    $("undo").setAttribute("aria-disabled", !canUndo);
    $("redo").setAttribute("aria-disabled", !canRedo);
});

// --- requests
class Refused extends Error {}

const usesPicture = () => kind === "stipple" || $("mask").checked;

const controls = () => [...$(`controls-${kind}`).querySelectorAll("[data-option]")];

// The text of a control's option. Paper that lies as the user says is given by its sides.
function textOf(control) {
    const lies = $("paper-lies").value, { size } = control.selectedOptions?.[0].dataset ?? {};
    if (control.id !== "paper" || lies === "" || !size) return control.value.trim();
    const [short, long] = size.split(" ");
    return lies === "portrait" ? `${short}x${long}mm` : `${long}x${short}mm`;
}

// The options that the controls give, as [name, text]. See index.html.
function optionsNow() {
    if (usesPicture()) prepare();
    const { name, commandName, options: changes } = picture ?? {};
    const options = kind !== "stipple" ? [] : changes ? [["IMAGE", name], ...changes] : [["IMAGE", commandName]];
    for (const control of controls()) {
        const { option, usual, unit = "", flag } = control.dataset;
        if (option === "" || control.disabled || control.closest("[hidden]")) continue;
        const isBox = control.type === "checkbox", isFlag = isBox || flag, text = textOf(control);
        if (isBox ? !control.checked : flag ? text !== flag : text === usual) continue;
        if (text === "") throw new Refused(`${option} empty: must have a value`);
        options.push([option, control.id === "mask" ? picture.commandName : isFlag ? "" : text + unit]);
    }
    return options;
}

const has = (o, option) => o.some(([name]) => name === option);
const controlOf = (option) => controls().find((control) => control.dataset.option === option);
const relaxOf = (o) => has(o, "along") ? 0 : Number(o.find(([name]) => name === "relax")?.[1] ?? controlOf("relax").dataset.usual);
// The same set, placed roughly, and without a path unless it is drawn along one.
const quick = (o) => [...o.filter(([name]) => name !== "relax" && name !== "pen-path"), ["relax", String(QUICK_RELAX)],
    ...(has(o, "path-line") || has(o, "plot-time") ? [] : [["no-pen-path", ""]])];
const formOf = (o) => [kind, ...o.flat()].map((text) => `${text}\n`).join("");
const keyOf = (o) => JSON.stringify([kind, usesPicture() && picture.number, o]);
const baseName = () => (kind === "stipple" ? picture.name.replace(/\.[^.]*$/, "") || "dots" : "points");
const grouped = (n) => n.toLocaleString("en");

// --- settings in the page's address, so that a link or a reload has them; the picture is not in it
function remember() {
    const all = settings(kind);
    history.replaceState(null, "", all ? `#${all}` : location.pathname + location.search);
}

function recall(text) {
    const all = new URLSearchParams(text);
    endCrop();
    setFields(all);
    for (const id of ["count-slider", "amount-slider"]) $(id).dispatchEvent(new Event("place"));
    update();
    const wanted = all.get("kind") === "sample" ? "sample" : "stipple";
    if (wanted !== kind) select(wanted);
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
    const note = ["png", "pdf"].includes(format)
        ? "The same dots; this file is drawn by the browser, so its bytes differ." : "The same bytes.";
    $("command-note").textContent = !usesPicture() || picture.isExact || (kind === "stipple" && picture.options) ? note
        : `${note} ${picture.commandName} is the picture as it was ${picture.changes || "read"} here: save it, under ${kind === "sample" ? "Stipple" : "Picture"}.`;
}

// --- making of sets
async function make(o, isFinal) {
    held = "";
    const pixels = kind === "stipple" && picture.options ? whole : picture; // which the options turn and cut
    if (usesPicture() && sent !== pixels) {
        sent = pixels;
        await engine.ask("picture", { columns: pixels.columns, rows: pixels.rows, rgba: pixels.rgba });
    }
    return engine.ask("make", { form: formOf(isFinal ? o : quick(o)) });
}

function show(key, set) {
    const isFirst = !shown;
    shown = { key, set, page: pageOf(set) };
    if (kind === "stipple") inkList.show(set.layers, set.points.length / 2);
    showEyes();
    view.show(set, shown.page);
    if (isFirst) requestAnimationFrame(() => setTimeout(() => (state.first = Math.round(performance.now()))));
}

// Hides layers on the screen, and says that files have them.
function showEyes() {
    const isStipple = kind === "stipple";
    view.hidden = isStipple ? inkList.hidden : new Set();
    $("hidden-note").hidden = view.hidden.size === 0;
    view.draw();
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
        if (!engine || (usesPicture() && !whole)) return;
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
    const isSmall = set.points.length / 2 <= MOST_FOR_SPECTRUM && !has(o, "mask");
    $("spectrum").classList.toggle("none", !isSmall);
    $("spectrum").querySelector("figcaption").textContent = isSmall ? "Power by frequency: random points have 1 everywhere."
        : `The spectrum is shown for up to ${grouped(MOST_FOR_SPECTRUM)} points, and without a mask.`;
    if (!isSmall) return;
    const spectrum = await engine.ask("spectrum", { most: FREQUENCIES });
    if (isOld()) return;
    drawSpectrum($("powers"), spectrum);
    $("radial").setAttribute("d", radialPath(spectrum.radial, FREQUENCIES));
}

// --- pictures
const turnsNow = () => Number($("turn").value) / 90;
const cutNow = () => Object.fromEntries(SIDES.map((side) => [side, Number($(`crop-${side}`).value)]));

function setCrop(turns, cut) {
    $("turn").value = String(90 * turns);
    SIDES.forEach((side) => ($(`crop-${side}`).value = cut[side]));
}

// Turns and crops the picture, if it is not as the settings say.
function prepare() {
    const turns = turnsNow(), cut = cutNow(), key = JSON.stringify([turns, cut]);
    if (picture?.whole === whole && picture.key === key) return;
    picture = { ...changed(whole, turns, cut), whole, key, number: ++pictures };
    const changes = [picture.isSmaller && "made smaller", picture.changes].filter(Boolean).join(", ");
    $("picture-note").textContent = `${grouped(picture.columns)} × ${grouped(picture.rows)} pixels${changes ? `, ${changes}` : ""}.`;
    $("picture-as-read").hidden = picture.isExact;
    $("whole").hidden = !picture.changes;
    view.picture = picture.canvas;
}

// The crop stays on the same part.
function turn() {
    const { left, right, top, bottom } = cutNow();
    setCrop((turnsNow() + 1) % 4, { left: bottom, right: top, top: left, bottom: right });
    changePicture();
}

// After the picture has been turned or cropped.
function changePicture() {
    endCrop();
    view.reset();
    update();
    steps.take();
}

function beginCrop() {
    if (!whole) return;
    cropper.open(changed(whole, turnsNow(), WHOLE), cutNow());
    $("crop").setAttribute("aria-pressed", true);
    said = $("status").textContent;
    say(CROP_HINT);
}

function endCrop() {
    if ($("status").textContent === CROP_HINT) say(said);
    cropper.close();
    $("crop").setAttribute("aria-pressed", false);
}

async function take(blob, name) {
    try {
        whole = await readPicture(blob, name);
    } catch (error) {
        return complain(error);
    }
    if (!keepsCrop) setCrop(0, WHOLE);
    keepsCrop = false;
    endCrop();
    $("picture-name").textContent = whole.name;
    select("stipple");
    steps.take();
}

// An example is fetched once, when the page starts: the page needs no server later.
const examples = {};

async function example(name) {
    return examples[name] ??= await (await fetched(name)).blob();
}

async function takeExample(name, inks) {
    const blob = await example(name).catch(complain);
    if (!blob) return;
    $("ink-kind").value = inks;
    update();
    await take(blob, name);
}

// --- saving
// The bytes of an .svg with the SHA-256 of the picture that its command reads, as the command writes it.
async function withHash(bytes) {
    if (kind !== "stipple" || !crypto.subtle) return bytes;
    const file = picture.isExact || picture.options ? whole.blob : await asPng(picture.canvas);
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", await file.arrayBuffer()));
    const hex = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
    return new TextEncoder().encode(new TextDecoder().decode(bytes)
        .replace("</dc:source>", `$&<dc:relation>sha256:${hex}</dc:relation>`));
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
        const written = (await engine.ask("encode", { format })).bytes;
        const bytes = format === "svg" ? await withHash(written) : written;
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
    endCrop();
    view.picture = kind === "stipple" ? picture?.canvas : null;
    document.title = `Lacuna: ${kind === "stipple" ? "stipple a picture" : "sample points"}`;
    view.reset();
    schedule();
}

function update() {
    for (const id of ["relax", "black-ink", "along", "black", "white", "gamma", "sharpen", "size-by-tone", "sample-relax"]) $(`${id}-value`).textContent = $(id).value;
    const isAlong = $("drawn").value === "along", isLine = $("drawn").value === "line";
    const several = $("pen-kind").querySelector("[value=pens]");
    several.disabled = isAlong || isLine; // strokes and a line are of one pen
    if (several.disabled && several.selected) $("pen-kind").value = "radius";
    const pens = $("pen-kind").value;
    $("pen-row").hidden = pens !== "pen";
    $("pens-row").hidden = pens !== "pens";
    const hide = (rows, isHidden) => document.querySelectorAll(rows).forEach((row) => (row.hidden = isHidden));
    hide("#pen-path-row", pens !== "radius" || isLine); // the dots of pens are ordered
    hide(".tone-row", pens !== "radius" || isLine);
    hide(".along-row", !isAlong);
    hide(".relax-row, #ink-kind-row, #ink-list", isAlong); // long dots are black and not relaxed
    hide("#keep-inside-row", isLine || (isAlong && pens === "pen"));
    $("count").disabled = $("count-slider").disabled = $("plot-time").value !== "";
    $("ink-row").hidden = isAlong || $("ink-kind").value !== "own";
    // White inks want dark paper, and the usual inks get theirs back.
    const isLight = $("ink-kind").value.startsWith("white"), paper = $("paper-colour");
    if (isLight && paper.value === "#ffffff") paper.value = "#000000";
    if (!isLight && hadLightInks && paper.value === "#000000") paper.value = "#ffffff";
    hadLightInks = isLight;
    $("ink-kind").dataset.option = $("ink-kind").value === "own" ? "" : "inks";
    hide(".black-ink-row", isAlong || paper.value !== "#ffffff" || !hasBlack(inkText()));
    $("sample-relax").disabled = $("mask").checked; // relaxed points leave a mask
    $("amount").dataset.option = $("by").value;
    $("amount-label").textContent = $("by").value === "radius" ? "Radius" : "Number";
    $("metric-row").hidden = isAlong || $("ink-kind").value !== "";
    $("margin").disabled = $("paper-lies").disabled = $("paper").value === "none";
    $("black").disabled = $("white").disabled = $("auto-levels").checked;
    schedule();
}

function onKey(event) {
    if (event.key === "Escape") return cropper.picture ? endCrop() : engine?.cancel();
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !["z", "y"].includes(key)) return;
    if (event.target.matches("input[type=text], input[type=number]")) return; // the browser undoes typing
    event.preventDefault();
    if (key === "y" || event.shiftKey) steps.redo();
    else steps.undo();
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
        // A slider that keys move makes one step until it is left.
        $(form).addEventListener("change", ({ target }) => steps.take(["range", "number"].includes(target.type) ? target : null));
        for (const end of ["pointerdown", "focusout"]) $(form).addEventListener(end, () => (steps.held = null));
    }
    const tabs = ["stipple", "sample"];
    for (const one of tabs) {
        $(`tab-${one}`).addEventListener("click", () => (select(one), steps.take()));
        $(`tab-${one}`).addEventListener("keydown", (event) => {
            if (!["ArrowLeft", "ArrowRight"].includes(event.key)) return;
            const other = tabs[1 - tabs.indexOf(one)];
            select(other);
            steps.take();
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
    document.addEventListener("keydown", onKey);
    $("undo").addEventListener("click", () => steps.undo());
    $("redo").addEventListener("click", () => steps.redo());
    $("reset").addEventListener("click", () => (recall(kind === "sample" ? "kind=sample" : ""), steps.take()));
    addEventListener("hashchange", () => (recall(location.hash.slice(1)), steps.take()));
    $("turn-right").addEventListener("click", turn);
    $("crop").addEventListener("click", () => (cropper.picture ? endCrop() : beginCrop()));
    $("whole").addEventListener("click", () => (setCrop(0, WHOLE), changePicture()));
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

async function start() {
    listen();
    document.body.classList.add("at-rest");
    try {
        const loading = [Engine.load((share) => ($("progress").value = share)), example("raccoon.png")];
        example("hopper.jpg").catch(() => {}); // a click on it says what failed
        const [loaded, raccoon] = await Promise.all(loading);
        engine = loaded;
        engine.forgotten = () => ((sent = null), (held = ""));
        if (whole) schedule(); // given by the user meanwhile
        else {
            const text = location.hash.slice(1), all = new URLSearchParams(text);
            recall(text);
            keepsCrop = true; // both of the raccoon and of the picture that is given next
            await take(raccoon, "raccoon.png");
            keepsCrop = [...all.keys()].some((name) => /^(turn|crop-)/.test(name));
            if (all.get("kind") === "sample") select("sample");
            steps.begin();
        }
    } catch (error) {
        complain(error);
    }
}

start();
