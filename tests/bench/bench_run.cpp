#include "bench_run.h"

#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

Json benchOf(std::vector<std::string> arguments) {
    const TemporaryFolder folder;
    const std::string file = folder / "results.json";
    arguments.insert(arguments.end(), {"--size", "160x90", "--frames", "2", "--quiet", "--json", file});
    const CommandResult result = runCommand(arguments, {.folder = folder.path()});
    expectSuccess(result);
    EXPECT_EQ(result.out, "") << "quiet";
    EXPECT_EQ(result.err, "") << "quiet";
    EXPECT_EQ(folder.names(), std::vector<std::string>{"results.json"});
    std::ifstream stream(file);
    return Json::parse(stream);
}

std::vector<Json> resultsOf(const Json& bench, const std::string& technique) {
    std::vector<Json> found;
    for (const Json& result : bench["results"])
        if (result["technique"] == technique) found.push_back(result);
    return found;
}

std::vector<std::string> keysOf(const Json& object) {
    std::vector<std::string> names;
    for (const auto& item : object.items()) names.push_back(item.key());
    return names;
}
