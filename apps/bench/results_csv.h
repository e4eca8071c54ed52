#pragma once

#include <string>

/// The rows of the results of a run as comma-separated values (RFC 4180), with a header. `json` is the text
/// of the results: a column is a number or text of theirs, those of an object being named after both
/// ("ceiling.share"), and `renderer` comes first. A row without a column's value has an empty field.
std::string resultsCsv(const std::string& json);
