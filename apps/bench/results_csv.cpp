#include "results_csv.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::pair<std::string, std::string>>;  ///< Column and value.

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quotes = "\"";
    for (const char c : text) quotes += c == '"' ? "\"\"" : std::string(1, c);
    return quotes + "\"";
}

void addCells(const std::string& prefix, const Json& object, Cells& cells) {
    for (const auto& [name, value] : object.items()) {
        if (value.is_object())
            addCells(prefix + name + ".", value, cells);
        else
            cells.emplace_back(prefix + name, value.is_string() ? value.get<std::string>() : value.dump());
    }
}

std::vector<std::string> columnsOf(const std::vector<Cells>& rows) {
    std::vector<std::string> columns;
    for (const Cells& row : rows)
        for (const auto& [column, value] : row)
            if (std::ranges::find(columns, column) == columns.end()) columns.push_back(column);
    return columns;
}

std::string lineOf(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) line += (i == 0 ? "" : ",") + quoted(fields[i]);
    return line + "\r\n";
}

}  // namespace

std::string resultsCsv(const std::string& json) {
    const Json results = Json::parse(json);
    std::vector<Cells> rows;
    for (const Json& row : results["results"]) {
        rows.push_back({{"renderer", results["renderer"].get<std::string>()}});
        addCells("", row, rows.back());
    }
    const std::vector<std::string> columns = columnsOf(rows);
    std::string text = lineOf(columns);
    for (const Cells& row : rows) {
        std::vector<std::string> fields;
        for (const std::string& column : columns) {
            const auto cell = std::ranges::find(row, column, [](const auto& entry) { return entry.first; });
            fields.push_back(cell == row.end() ? "" : cell->second);
        }
        text += lineOf(fields);
    }
    return text;
}
