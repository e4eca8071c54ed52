// Options of importers: their description, and the queries that give them values.
#include "import/plugin_options.h"

#include "expect_error.h"
#include "import/plugin_rules.h"
#include "note_lines.h"
#include "temporary_folder.h"

#include <candela/import.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

class PluginOptions : public testing::Test {
  protected:
    Lines read(const std::string& query) {
        return noteLines(importScene(plugins, folder.write("scene.opt", "").string() + query));
    }
    void expectRefused(const std::string& query, const std::string& text) {
        const std::string expected = (folder.path() / "scene.opt").string() + query + ": query: " + text;
        EXPECT_EQ(expectError([&] { read(query); }, ErrorKind::badInput, ""), expected);
    }

    const PluginRegistry plugins{{fs::path(CANDELA_TEST_FIXTURES) / "importers"}};
    TemporaryFolder folder;
};

TEST_F(PluginOptions, AreReported) {
    const auto& reports = plugins.reports();
    const auto report = std::ranges::find(reports, "option-reader", &PluginReport::name);
    ASSERT_NE(report, reports.end());
    std::vector<std::string> usages;
    for (const PluginOption& option : report->options) usages.push_back(usageOf(option));
    EXPECT_EQ(usages, (std::vector<std::string>{"flip", "level=1..8", "scale=NUMBER", "layer=TEXT",
                                                "color[=red|green]"}));
    EXPECT_EQ(report->options.at(1).help, "how fine");
}

TEST_F(PluginOptions, HaveTheValuesOfTheQuery) {
    EXPECT_EQ(read(""), Lines{});
    EXPECT_EQ(read("?flip"), Lines{"flip 1.000000 '1'"});
    EXPECT_EQ(read("?color=green&level=3&flip=0&scale=-0.5&layer=a b=c"),
              (Lines{"color 1.000000 'green'", "level 3.000000 '3'", "flip 0.000000 '0'",
                     "scale -0.500000 '-0.5'", "layer 0.000000 'a b=c'"}));
    EXPECT_EQ(read("?color&layer="), (Lines{"color 0.000000 'red'", "layer 0.000000 ''"}));
}

TEST_F(PluginOptions, RefuseOtherValues) {
    const std::string all = "flip, level=1..8, scale=NUMBER, layer=TEXT, color[=red|green]";
    expectRefused("?flop", "'flop' is none of the options " + all);
    expectRefused("?", "'' is none of the options " + all);
    expectRefused("?flip&", "'' is none of the options " + all);
    expectRefused("?flip=2", "flip=2, but 0 or 1 was expected");
    expectRefused("?level", "'level' has no value, but an integer from 1 to 8 was expected");
    for (const char* value : {"", "0", "9", "1.5", "x", "3x", " 3", "nan", "1e400"})
        expectRefused(std::string("?level=") + value,
                      std::string("level=") + value + ", but an integer from 1 to 8 was expected");
    expectRefused("?scale=inf", "scale=inf, but a number was expected");
    expectRefused("?color=blue", "color=blue, but red or green was expected");
    expectRefused("?flip&level=2&flip=0", "'flip' is given twice");
}

TEST_F(PluginOptions, DescriptionsAreChecked) {
    const auto faultOf = [](candela_option option, std::uint32_t count = 1) -> std::string {
        const candela_option options[] = {option, option};
        candela_importer importer{};
        importer.option_count = count;
        importer.options = count > 2 ? nullptr : options;
        try {
            checkedOptions(importer);
        } catch (const BrokenRule& broken) {
            return broken.text;
        }
        return "";
    };
    const candela_option good{"one", "helps", CANDELA_OPTION_NUMBER, 0, 0.0, 1.0, nullptr};
    const auto with = [&](auto change) {
        candela_option changed = good;
        change(changed);
        return faultOf(changed);
    };
    EXPECT_EQ(faultOf(good), "");
    EXPECT_EQ(faultOf(good, 2), "it has two options 'one'");
    EXPECT_EQ(faultOf(good, 3), "its option_count is 3, but its options are NULL");
    EXPECT_EQ(with([](auto& o) { o.name = nullptr; }), "the name of its option 0 is NULL");
    EXPECT_EQ(with([](auto& o) { o.name = "A"; }),
              "the name of its option 0 'A' is not made of a to z, 0 to 9, '-' and '_' alone");
    EXPECT_EQ(with([](auto& o) { o.help = "a\nb"; }), "its option 'one': the help is not one line of UTF-8");
    EXPECT_EQ(with([](auto& o) { o.type = static_cast<candela_option_type>(5); }),
              "its option 'one': there is no type 5");
    EXPECT_EQ(with([](auto& o) { o.minimum = 2.0; }),
              "its option 'one': its minimum and its maximum are no range");
    EXPECT_EQ(with([](auto& o) { o.maximum = std::numeric_limits<double>::infinity(); }),
              "its option 'one': its minimum and its maximum are no range");
    EXPECT_EQ(with([](auto& o) { o.type = CANDELA_OPTION_KEYWORD; }),
              "its option 'one' is a keyword, but its keywords are NULL");
    const char* const nothing[] = {nullptr};
    EXPECT_EQ(with([&](auto& o) {
                  o.type = CANDELA_OPTION_KEYWORD;
                  o.keywords = nothing;
              }),
              "its option 'one' is a keyword of nothing");
}

}  // namespace
}  // namespace candela
