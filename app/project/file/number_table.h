#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wend {

/// A table of numbers in a text file: one row a line, columns between commas, semicolons, tabs or blanks, #
/// before remarks, and maybe a header of names.
struct NumberTable {
    std::string path;
    std::vector<std::string> header;  // lower case, without quotes; empty: none
    std::vector<std::vector<double>> rows;
    std::vector<int> lines;  // of the rows, from 1

    /// Returns the column with one of these names.
    std::optional<std::size_t> column(const std::vector<std::string>& names) const;
    [[noreturn]] void failAt(std::size_t row, const std::string& what) const;
};

/// Throws InputError(path, "line 3: …") for a row that is no numbers, and where rows differ in length.
NumberTable readNumberTable(const std::string& path);

}  // namespace wend
