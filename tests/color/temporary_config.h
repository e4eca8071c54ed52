#pragma once

#include <candela/color.h>
#include <candela/error.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace candela::test {

/// A config file that is deleted with this object.
class TemporaryConfig {
  public:
    explicit TemporaryConfig(const std::string& text)
        : path_(std::filesystem::temp_directory_path() /
                ("candela_" + std::to_string(getpid()) + "_" + std::to_string(++count) + ".ocio")) {
        std::ofstream(path_) << text;
    }
    TemporaryConfig(const TemporaryConfig&) = delete;
    TemporaryConfig& operator=(const TemporaryConfig&) = delete;
    ~TemporaryConfig() { std::filesystem::remove(path_); }

    std::string path() const { return path_; }

  private:
    static inline int count = 0;
    std::filesystem::path path_;
};

/// A small config around the given roles and colour spaces (YAML, two spaces deep); its only display,
/// "Monitor", shows the space "raw".
inline std::string configText(const std::string& roles, const std::string& spaces,
                              const std::string& more = "") {
    return "ocio_profile_version: 2\nenvironment: {}\nsearch_path: .\n"
           "roles:\n  default: raw\n" +
           roles +
           "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n"
           "displays:\n  Monitor:\n    - !<View> {name: Raw, colorspace: raw}\n" +
           more + "colorspaces:\n  - !<ColorSpace> {name: raw, isdata: true}\n" + spaces;
}

/// The message of the `Error` that `action` must throw; its kind must be badInput.
template <typename Action>
std::string messageOf(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "the message is one line";
        return error.what();
    }
    ADD_FAILURE() << "no candela::Error was thrown";
    return "";
}

}  // namespace candela::test
