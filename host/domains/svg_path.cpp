// Reads SVG's path data, lists of points and transforms.
#include "domains/svg_path.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "domains/rings.h"
#include "domains/svg_words.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

// The number of arguments of a command; empty if the letter is no command.
std::optional<std::size_t> arguments_of(char command) {
    switch (command) {
        case 'z':
            return 0;
        case 'h':
        case 'v':
            return 1;
        case 'm':
        case 'l':
        case 't':
            return 2;
        case 's':
        case 'q':
            return 4;
        case 'c':
            return 6;
        case 'a':
            return 7;
        default:
            return std::nullopt;
    }
}

class PathReader {
public:
    PathReader(std::string_view data, Outline& outline) : words_(data), outline_(outline) {}

    std::optional<std::string> read() {
        char command = 0;
        while (!words_.at_end()) {
            const std::optional<char> letter = words_.take_letter();
            if (!letter && (command == 0 || lower(command) == 'z')) return expected("a command");
            if (letter) command = *letter;
            if (!has_moved_ && lower(command) != 'm')
                return expected("M, which a path begins with");
            const std::optional<std::size_t> count = arguments_of(lower(command));
            if (!count) return fmt::format("{:?} is no command of a path", std::string(1, command));
            if (!take_numbers(*count, lower(command) == 'a')) return expected("a number");
            draw(lower(command), command == lower(command));
            if (outline_.points() > kMostPoints) return std::nullopt;  // the caller refuses it
            // Further points after the first point of a move are the ends of lines.
            if (command == 'm') command = 'l';
            if (command == 'M') command = 'L';
        }
        return std::nullopt;
    }

private:
    static char lower(char letter) { return files::lower_case(letter); }

    std::string expected(std::string_view what) const {
        return fmt::format("{} is expected before {}, at character {}", what,
                           words_.rest().empty() ? "the end" : files::excerpt(words_.rest()),
                           words_.position());
    }

    bool take_numbers(std::size_t count, bool is_arc) {
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_flag = is_arc && (i == 3 || i == 4);
            const std::optional<double> number =
                is_flag ? std::optional<double>(words_.take_flag()) : words_.take_number();
            if (!number) return false;
            numbers_[i] = *number;
        }
        return true;
    }

    // The point whose coordinates are numbers_[i] and numbers_[i + 1].
    Point point(std::size_t i, bool is_relative) const {
        const Point from = is_relative ? outline_.current() : Point{0, 0};
        return {from.x + numbers_[i], from.y + numbers_[i + 1]};
    }

    // Mirrors the previous command's last control point; the current point if it had none.
    Point mirrored(char one, char other) const {
        const Point at = outline_.current();
        if (previous_ != one && previous_ != other) return at;
        return {2 * at.x - control_.x, 2 * at.y - control_.y};
    }

    void draw(char command, bool is_relative) {
        const Point at = outline_.current();
        switch (command) {
            case 'm':
                has_moved_ = true;
                outline_.move_to(point(0, is_relative));
                break;
            case 'z':
                outline_.close();
                break;
            case 'h':
                outline_.line_to({(is_relative ? at.x : 0) + numbers_[0], at.y});
                break;
            case 'v':
                outline_.line_to({at.x, (is_relative ? at.y : 0) + numbers_[0]});
                break;
            case 'l':
                outline_.line_to(point(0, is_relative));
                break;
            case 'a':
                outline_.arc_to({numbers_[0], numbers_[1], numbers_[2]}, numbers_[3] != 0,
                                numbers_[4] != 0, point(5, is_relative));
                break;
            default:
                draw_curve(command, is_relative);
        }
        previous_ = command;
    }

    void draw_curve(char command, bool is_relative) {
        if (command == 'c') {
            control_ = point(2, is_relative);
            outline_.cubic_to(point(0, is_relative), control_, point(4, is_relative));
        } else if (command == 's') {
            const Point first = mirrored('c', 's');
            control_ = point(0, is_relative);
            outline_.cubic_to(first, control_, point(2, is_relative));
        } else {
            control_ = command == 'q' ? point(0, is_relative) : mirrored('q', 't');
            outline_.quadratic_to(control_, point(command == 'q' ? 2 : 0, is_relative));
        }
    }

    SvgWords words_;
    Outline& outline_;
    std::array<double, 7> numbers_{};
    Point control_{};    // the last control point of the previous command
    char previous_ = 0;  // the previous command, in lower case
    bool has_moved_ = false;
};

std::optional<Affine> affine_of(std::string_view name, const std::vector<double>& numbers) {
    const std::size_t count = numbers.size();
    const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
    if (name == "matrix" && count == 6)
        return Affine{numbers[0], numbers[2], numbers[1], numbers[3], numbers[4], numbers[5]};
    if (name == "translate" && (count == 1 || count == 2))
        return Affine{1, 0, 0, 1, numbers[0], count == 2 ? numbers[1] : 0};
    if (name == "scale" && (count == 1 || count == 2))
        return Affine{numbers[0], 0, 0, numbers[count - 1], 0, 0};
    if (name == "rotate" && count == 1) return turned_by(numbers[0]);
    if (name == "rotate" && count == 3)
        return Affine{1, 0, 0, 1, numbers[1], numbers[2]}
            .after(turned_by(numbers[0]))
            .after({1, 0, 0, 1, -numbers[1], -numbers[2]});
    if (name == "skewX" && count == 1) return Affine{1, tangent(numbers[0]), 0, 1, 0, 0};
    if (name == "skewY" && count == 1) return Affine{1, 0, tangent(numbers[0]), 1, 0, 0};
    return std::nullopt;
}

}  // namespace

// Multiples of 90 degrees are exact, so that they change no digit of a drawing. Other angles use
// the C library's sine and cosine.
Affine turned_by(double degrees) {
    const double quarters = std::fmod(degrees, 360) / 90;
    if (quarters == std::floor(quarters)) {
        const double rest = quarters < 0 ? quarters + 4 : quarters;
        const double cosine = rest == 0 ? 1 : rest == 2 ? -1 : 0;
        const double sine = rest == 1 ? 1 : rest == 3 ? -1 : 0;
        return {cosine, -sine, sine, cosine, 0, 0};
    }
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0};
}

std::optional<std::string> draw_path(std::string_view data, Outline& outline) {
    return PathReader(data, outline).read();
}

std::optional<std::string> draw_points(std::string_view points, Outline& outline) {
    SvgWords words(points);
    bool is_first = true;
    while (!words.at_end()) {
        const std::optional<double> x = words.take_number();
        const std::optional<double> y = x ? words.take_number() : std::nullopt;
        if (!y)
            return fmt::format("a number is expected before {} among its points, at character {}",
                               words.rest().empty() ? "the end" : files::excerpt(words.rest()),
                               words.position());
        if (is_first)
            outline.move_to({*x, *y});
        else
            outline.line_to({*x, *y});
        is_first = false;
    }
    return std::nullopt;
}

namespace {

// Appends the numbers between brackets; `take` takes one.
template <typename Take>
bool take_arguments(SvgWords& words, std::vector<double>& numbers, Take take) {
    if (!words.take('(')) return false;
    while (!words.take(')')) {
        const std::optional<double> number = take();
        if (!number || numbers.size() == 6) return false;
        numbers.push_back(*number);
    }
    return true;
}

// A function of CSS by the name and the arguments of SVG.
std::string_view svg_name(std::string_view name, std::vector<double>& numbers) {
    const bool has_one = numbers.size() == 1;
    if (name == "rotate") return has_one ? name : "";
    if (name == "skewx" && has_one) return "skewX";
    if (name == "skewy" && has_one) return "skewY";
    if (name == "skew" && has_one) return "skewX";
    if (name == "matrix" || name == "translate" || name == "scale") return name;
    if (!has_one) return "";
    if (name == "translatex" || name == "translatey") {
        numbers.insert(name.back() == 'x' ? numbers.end() : numbers.begin(), 0);
        return "translate";
    }
    if (name == "scalex" || name == "scaley") {
        numbers.insert(name.back() == 'x' ? numbers.end() : numbers.begin(), 1);
        return "scale";
    }
    return "";
}

// Lengths have a unit unless they are 0, and angles are in degrees.
std::optional<double> take_with_unit(SvgWords& words, std::string_view name) {
    const std::optional<double> number = words.take_number();
    const std::string_view unit = number ? words.take_word() : std::string_view();
    const bool is_length = name.starts_with("translate");
    const bool is_angle = name.starts_with("rotate") || name.starts_with("skew");
    const std::string_view wanted = is_length ? "px" : is_angle ? "deg" : "";
    if (!number || (unit != wanted && (*number != 0 || !unit.empty()))) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::string> read_css_transform(std::string_view text, Affine& transform) {
    SvgWords words(text);
    while (!words.at_end()) {
        const std::string_view name = words.take_word();
        std::vector<double> numbers;
        const bool is_fine =
            take_arguments(words, numbers, [&] { return take_with_unit(words, name); });
        const std::optional<Affine> step =
            is_fine ? affine_of(svg_name(name, numbers), numbers) : std::optional<Affine>{};
        if (!step)
            return fmt::format(
                "transform {} of a style: must be matrix, translate, scale, rotate or skew with "
                "their numbers, lengths in px and angles in deg",
                files::excerpt(text));
        transform = transform.after(*step);
    }
    return std::nullopt;
}

std::optional<std::string> read_transform(std::string_view text, Affine& transform) {
    SvgWords words(text);
    while (!words.at_end()) {
        const std::string_view name = words.take_word();
        std::vector<double> numbers;
        const bool is_fine = take_arguments(words, numbers, [&] { return words.take_number(); });
        const std::optional<Affine> step =
            is_fine ? affine_of(name, numbers) : std::optional<Affine>{};
        if (!step)
            return fmt::format(
                "transform {}: must be matrix, translate, scale, rotate, skewX or skewY with their "
                "numbers",
                files::excerpt(text));
        transform = transform.after(*step);
    }
    return std::nullopt;
}

}  // namespace lacuna::domains
