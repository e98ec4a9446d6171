// The list of inks: their colours, and which of them the screen shows.

const PART = /^([^=:]*)(=[^:]*)?(:.*)?$/; // NAME[=#rrggbb][:PEN]
const hexOf = (colour) => `#${colour.toString(16).padStart(6, "0")}`;

// The inks of an --inks text, each as a text. Those of cmyk get their colours from `layers`.
function partsOf(text, layers) {
    if (text === "") return ["black"];
    if (!/^cmyk(:|$)/.test(text)) return text.split(",");
    const names = ["cyan", "magenta", "yellow", "black"];
    return names.map((name, i) => `${name}=${hexOf(layers[(i * layers.length) / names.length].colour)}${text.slice(4)}`);
}

// Whether one of the inks counts as black, as in separator.cpp.
export function hasBlack(text) {
    const MOST = 89; // of a channel
    return text.split(",").some((part) => {
        const [, name, colour] = part.match(PART) ?? [];
        const digits = (colour ?? name)?.match(/^=?#([0-9a-f]{6})$/i)?.[1];
        return digits ? digits.match(/../g).every((two) => parseInt(two, 16) <= MOST) : ["cmyk", "black"].includes(name);
    });
}

// The --inks text with another colour of the ink that the layer at `index` is drawn in. A name that
// stands for a colour makes way for the new colour, and a name that has one stays.
function recoloured(text, layers, index, colour) {
    const parts = partsOf(text, layers);
    const ink = Math.floor((index * parts.length) / layers.length);
    parts[ink] = parts[ink].replace(PART, (_, name, old, pen = "") => (old ? `${name}=` : "") + colour + pen);
    return parts.join(",");
}

export class InkList {
    // `text()` is the present --inks text; `take(text)` is called with another one, `onHide()` if
    // the eyes have changed.
    constructor(list, text, take, onHide) {
        Object.assign(this, { list, layers: [], hidden: new Set(), isPicking: false });
        list.addEventListener("change", () => (this.isPicking = false));
        list.addEventListener("input", (event) => {
            event.stopPropagation();
            const index = [...list.children].indexOf(event.target.closest("li"));
            this.isPicking = event.target.type === "color";
            if (this.isPicking) return take(recoloured(text(), this.layers, index, event.target.value));
            if (event.target.checked) this.hidden.delete(index);
            else this.hidden.add(index);
            onHide();
        });
    }

    // Rows stay, so that a colour's dialog stays open while dots follow it.
    show(layers, all) {
        if (layers.length !== this.layers.length) this.hidden.clear();
        this.layers = layers.length ? layers : [{ name: "", dots: all, colour: 0 }];
        while (this.list.children.length > this.layers.length) this.list.lastChild.remove();
        while (this.list.children.length < this.layers.length) this.list.append(this.row());
        this.layers.forEach(({ name, dots, colour }, i) => {
            const [eye, picker, label] = ["[type=checkbox]", "[type=color]", "span"].map((one) => this.list.children[i].querySelector(one));
            const called = name.startsWith("#") ? `ink ${i + 1}` : name || "black";
            eye.checked = !this.hidden.has(i);
            eye.hidden = layers.length < 2;
            eye.setAttribute("aria-label", `Show ${called}`);
            if (!this.isPicking) picker.value = hexOf(colour);
            picker.setAttribute("aria-label", `Colour of ${called}`);
            label.textContent = `${called}, ${dots.toLocaleString("en")} dots`;
        });
    }

    row() {
        const row = document.createElement("li");
        row.innerHTML = '<input type="checkbox" class="eye"><input type="color"><span></span>';
        return row;
    }
}
