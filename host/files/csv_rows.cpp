// Splits the lines of .csv files.
#include "files/csv_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "files/parse.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

char separator_of(std::string_view line) {
    for (const char one : {';', ','})
        if (line.find(one) != std::string_view::npos) return one;
    return '\t';
}

void trim_end(std::string_view& text) {
    while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
}

}  // namespace

bool is_number(std::string_view field) {
    double number = 0;
    return take_number(field, number) != std::errc::invalid_argument && field.empty();
}

CsvRows::CsvRows(std::string_view bytes, const std::string& name)
    : rest_(without_byte_order_mark(bytes)), name_(name) {
    while (!rest_.empty()) {
        const std::string_view line = take_line(rest_);
        ++line_;
        if (is_skipped(line)) continue;
        separator_ = separator_of(line);
        split(line);
        is_waiting_ = fields_.size() == 1 || std::any_of(fields_.begin(), fields_.end(), is_number);
        if (!is_waiting_) names_.assign(fields_.begin(), fields_.end());
        break;
    }
}

bool CsvRows::next() {
    if (!is_waiting_) {
        std::string_view line;
        do {
            if (rest_.empty()) return false;
            line = take_line(rest_);
            ++line_;
        } while (is_skipped(line));
        split(line);
    }
    is_waiting_ = false;
    const std::size_t size = fields_.size();
    if (!row_size_) row_size_ = !names_.empty() && size != names_.size() + 1 ? names_.size() : size;
    if (size != *row_size_)
        refuse(place(), fmt::format("{} column{}: the {} has {}", size, size == 1 ? "" : "s",
                                    names_.empty() ? "first line" : "header", *row_size_));
    if (!names_.empty() && size > names_.size()) fields_.erase(fields_.begin());
    return true;
}

double CsvRows::number(std::size_t column) const {
    double value = 0;
    std::string_view rest = fields_[column];
    if (take_number(rest, value) != std::errc{} || !rest.empty() || !std::isfinite(value))
        refuse(place(),
               fmt::format("column {} is {}: must be a finite number, such as 0.25",
                           names_.empty() ? std::to_string(column + 1) : excerpt(names_[column]),
                           excerpt(fields_[column])));
    return value;
}

std::string CsvRows::place() const {
    return fmt::format("{}:{}", name_, line_);
}

void CsvRows::split(std::string_view line) {
    const auto skip = [&] {
        while (line.starts_with(' ') || (separator_ != '\t' && line.starts_with('\t')))
            line.remove_prefix(1);
    };
    fields_.clear();
    for (;;) {
        skip();
        std::string_view field;
        if (line.starts_with('"')) {
            // A quote within quotes is written twice.
            std::size_t end = line.find('"', 1);
            while (end != std::string_view::npos && line.substr(end + 1).starts_with('"'))
                end = line.find('"', end + 2);
            if (end == std::string_view::npos) refuse(place(), "a quote is not closed");
            field = line.substr(1, end - 1);
            line.remove_prefix(end + 1);
            skip();
            if (!line.empty() && line.front() != separator_)
                refuse(place(), fmt::format("{} follows a closing quote", excerpt(line)));
        } else {
            field = line.substr(0, line.find(separator_));
            line.remove_prefix(field.size());
            trim_end(field);
        }
        fields_.push_back(field);
        if (line.empty()) return;
        line.remove_prefix(1);
    }
}

}  // namespace lacuna::files
