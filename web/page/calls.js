// What the page's worker and the npm package ask of the module.

function verbsOf(lacuna) {
    function fail() {
        throw new Error(lacuna.UTF8ToString(lacuna._lacuna_message()));
    }

    function check(done) {
        if (!done) fail();
    }

    // What the module has written, and that as JSON.
    function text() {
        return lacuna.UTF8ToString(lacuna._lacuna_text());
    }
    function written() {
        return JSON.parse(text());
    }

    function doubles(pointer, count) {
        return pointer ? lacuna.HEAPF64.slice(pointer >> 3, (pointer >> 3) + count) : null;
    }

    // Calls use(pointer, ...) with the texts as C strings.
    function withTexts(texts, use) {
        const pointers = texts.map((text) => {
            const size = 4 * text.length + 1;
            const pointer = lacuna._malloc(size);
            lacuna.stringToUTF8(text, pointer, size);
            return pointer;
        });
        try {
            return use(...pointers);
        } finally {
            pointers.forEach((pointer) => lacuna._free(pointer));
        }
    }

    function takePicture({ columns, rows, rgba }) {
        const room = lacuna._lacuna_room_for_pixels(columns, rows);
        if (!room) fail();
        lacuna.HEAPU8.set(new Uint8Array(rgba), room);
    }

    function made() {
        const count = lacuna._lacuna_count();
        return {
            points: doubles(lacuna._lacuna_points(), 2 * count),
            diameters: doubles(lacuna._lacuna_diameters(), count),
            ellipses: doubles(lacuna._lacuna_ellipses(), 3 * count),
            areStrokes: Boolean(lacuna._lacuna_are_strokes()),
            lineWidth: lacuna._lacuna_line_width(),
            layers: written(lacuna._lacuna_layers()),
            paper: written(lacuna._lacuna_paper()),
            paperColour: lacuna._lacuna_paper_colour(),
            plot: text(lacuna._lacuna_plot()),
            width: lacuna._lacuna_width(),
            height: lacuna._lacuna_height(),
            radius: lacuna._lacuna_radius(),
        };
    }

    return {
        picture(picture) {
            takePicture(picture);
            return {};
        },
        // The command line of a form with a file that it writes.
        command({ form, file }) {
            check(withTexts([form, file], (a, b) => lacuna._lacuna_command(a, b)));
            return { command: text() };
        },
        make({ form }) {
            check(withTexts([form], (a) => lacuna._lacuna_make(a)));
            return made();
        },
        prove({ radius }) {
            return written(check(lacuna._lacuna_prove(radius)));
        },
        spectrum({ most }) {
            check(lacuna._lacuna_spectrum(most));
            const side = lacuna._lacuna_spectrum_side();
            const at = lacuna._lacuna_powers() >> 2;
            return {
                side,
                powers: lacuna.HEAPF32.slice(at, at + side * side),
                radial: doubles(lacuna._lacuna_radial(), lacuna._lacuna_radial_size()),
            };
        },
        encode({ format }) {
            check(withTexts([format], (a) => lacuna._lacuna_encode(a)));
            const at = lacuna._lacuna_text();
            return { bytes: lacuna.HEAPU8.slice(at, at + lacuna._lacuna_text_size()) };
        },
    };
}
