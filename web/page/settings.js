// The settings: the values of all fields, as the text of a link. The steps of a user, to undo them.
// Whatever changes the result is a setting, except the picture.

const fields = () => [...document.querySelectorAll("form :is([data-option], [data-setting])")];
const valueOf = (field) => (field.type === "checkbox" ? field.checked : field.value);
const usualOf = (field) => field.type === "checkbox" ? field.defaultChecked
    : field.defaultValue ?? ([...field.options].find((one) => one.defaultSelected) ?? field.options[0]).value;

// The settings that differ from the usual ones.
export function settings(kind) {
    const all = new URLSearchParams(kind === "stipple" ? {} : { kind });
    for (const field of fields()) if (valueOf(field) !== usualOf(field)) all.set(field.id, valueOf(field));
    return all.toString();
}

export function setFields(all) {
    for (const field of fields()) {
        const value = all.get(field.id) ?? usualOf(field);
        if (field.type === "checkbox") field.checked = String(value) === "true";
        else field.value = value;
    }
}

// The settings after each step of the user. `now()` returns the present ones, `go(text)` sets them.
export class Steps {
    constructor(now, go, onChange) {
        Object.assign(this, { now, go, onChange });
        this.begin();
    }

    begin() {
        this.all = [this.now()];
        this.at = 0;
        this.held = null; // a field whose changes by keys are one step, until it is left
        this.onChange(this);
    }

    take(field = null) {
        const now = this.now();
        if (now === this.all[this.at]) return;
        const isSame = field && field === this.held;
        this.all.length = this.at + 1;
        if (isSame) this.all[this.at] = now;
        else this.at = this.all.push(now) - 1;
        this.held = field;
        this.onChange(this);
    }

    get canUndo() {
        return this.at > 0;
    }
    get canRedo() {
        return this.at < this.all.length - 1;
    }

    undo() {
        this.take();
        this.move(-1);
    }
    redo() {
        this.move(1);
    }

    move(by) {
        if (!(by < 0 ? this.canUndo : this.canRedo)) return;
        this.at += by;
        this.held = null;
        this.go(this.all[this.at]);
        this.onChange(this);
    }
}
