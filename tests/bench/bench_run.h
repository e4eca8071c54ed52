#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

/// Runs candela-bench on small pictures, two frames a median, and returns its JSON. Fails the test when the
/// run does.
Json benchOf(std::vector<std::string> arguments);

/// The results of one technique.
std::vector<Json> resultsOf(const Json& bench, const std::string& technique);

/// The keys of an object, in order.
std::vector<std::string> keysOf(const Json& object);
