// Reads the numbers in SVG's attributes. They are separated by blanks or a comma, or by nothing
// where a sign or a point begins the next number.
#pragma once

#include <optional>
#include <string_view>
#include <system_error>

#include "files/parse.h"

namespace lacuna::domains {

class SvgWords {
public:
    explicit SvgWords(std::string_view text) : all_(text), rest_(text) {}

    bool at_end() {
        skip_blanks();
        return rest_.empty();
    }
    std::size_t position() const { return all_.size() - rest_.size(); }
    std::string_view rest() const { return rest_; }

    // Takes the next character if it is a letter.
    std::optional<char> take_letter() {
        skip_blanks();
        if (rest_.empty() || !is_letter(rest_.front())) return std::nullopt;
        const char letter = rest_.front();
        rest_.remove_prefix(1);
        return letter;
    }

    // Takes the expected character; false if another one is there.
    bool take(char wanted) {
        skip_blanks();
        if (!rest_.starts_with(wanted)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    // Takes the next number and a comma before it. The number need not be finite.
    std::optional<double> take_number() {
        skip_comma();
        // from_chars also reads inf and nan, which SVG does not allow.
        const std::size_t digit = rest_.find_first_not_of("+-.");
        if (digit == std::string_view::npos || rest_[digit] < '0' || rest_[digit] > '9')
            return std::nullopt;
        double number = 0;
        if (files::take_number(rest_, number) != std::errc{}) return std::nullopt;
        return number;
    }

    // Takes a flag of an arc, 0 or 1, which may stand without separators.
    std::optional<bool> take_flag() {
        skip_comma();
        if (!rest_.starts_with('0') && !rest_.starts_with('1')) return std::nullopt;
        const bool flag = rest_.front() == '1';
        rest_.remove_prefix(1);
        return flag;
    }

    // Takes a word of letters, which may be empty.
    std::string_view take_word() {
        skip_comma();
        std::size_t count = 0;
        while (count < rest_.size() && is_letter(rest_[count])) ++count;
        const std::string_view word = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return word;
    }

private:
    static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

    void skip_blanks() {
        const std::size_t blanks = rest_.find_first_not_of(" \t\n\r\f");
        rest_.remove_prefix(blanks == std::string_view::npos ? rest_.size() : blanks);
    }
    void skip_comma() {
        skip_blanks();
        if (!rest_.starts_with(',')) return;
        rest_.remove_prefix(1);
        skip_blanks();
    }

    std::string_view all_;
    std::string_view rest_;
};

}  // namespace lacuna::domains
