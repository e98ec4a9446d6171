// Numbers as decimal texts, by JavaScript: see charconv.
#include <emscripten.h>

#include <charconv>
#include <string>

namespace {

EM_JS(double, number_of_text, (const char* text), { return Number(UTF8ToString(text)); });

// clang-format takes this for C++.
// clang-format off
// toFixed() writes at most 100 decimals, and only numbers under 1e21.
EM_JS(void, text_of_number, (double value, char* text, int room), {
    const parts = value.toExponential().split("e");  // such as -1.5 and +7
    let shortest = String(value).toLowerCase().replace("infinity", "inf");
    if (parts[1]) {
        const scientific = parts[0] + "e" + parts[1][0] + parts[1].slice(1).padStart(2, "0");
        const digits = parts[0].split("").filter(c => c >= "0").length;
        const decimals = Math.max(0, digits - 1 - parts[1]);
        let fixed = Math.abs(value) < 1e21 ? value.toFixed(Math.min(decimals, 100))
                                           : String(BigInt(value));
        if (Object.is(value, -0)) fixed = "-0";
        shortest = decimals <= 100 && fixed.length <= scientific.length ? fixed : scientific;
    }
    stringToUTF8(shortest, text, room);
});
// clang-format on

}  // namespace

namespace lacuna::compat {

std::string shortest_text(double value) {
    char text[400];
    text_of_number(value, text, sizeof text);
    return text;
}

double number_of(const std::string& text) {
    return number_of_text(text.c_str());
}

}  // namespace lacuna::compat
