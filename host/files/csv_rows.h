// The rows of a .csv: fields between commas, semicolons or tabs, which may stand in quotes, below a
// header of names or without one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna::files {

// Whether a field is a number.
bool is_number(std::string_view field);

class CsvRows {
public:
    // `bytes` and `name`, which stands for the file in messages, must outlive the rows. The first
    // line decides the separator: a semicolon if it has one, else a comma, else a tab. It is a
    // header if none of its fields is a number.
    CsvRows(std::string_view bytes, const std::string& name);

    // The names of the columns; empty if there is no header.
    const std::vector<std::string>& names() const { return names_; }
    // Moves to the next row; false at the end. Blank lines and lines that begin with # are skipped.
    // Where rows have one field more than the header, as R writes them, the first is the row's
    // name and no column. Throws FileError if a row has another number of fields.
    bool next();
    std::size_t columns() const { return fields_.size(); }
    std::string_view field(std::size_t column) const { return fields_[column]; }
    // The field, which must be a finite number. Throws FileError.
    double number(std::size_t column) const;

    // The file and the line of the row, for messages.
    std::string place() const;

private:
    void split(std::string_view line);

    std::string_view rest_;
    const std::string& name_;
    char separator_ = ',';
    std::vector<std::string> names_;
    std::vector<std::string_view> fields_;
    std::size_t line_ = 0;     // number of the line that was read last
    bool is_waiting_ = false;  // whether the first line is a row, which next() has not returned
    std::optional<std::size_t> row_size_;  // how many fields each row has
};

}  // namespace lacuna::files
