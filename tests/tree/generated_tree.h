#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace candela {

/// A small source tree of its own for one test, removed with it.
class GeneratedTree : public testing::Test {
  protected:
    GeneratedTree() {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        root_ =
            std::filesystem::path(testing::TempDir()) / ("candela_tree_" + name + std::to_string(::getpid()));
        std::filesystem::remove_all(root_);
        std::filesystem::create_directories(root_);
    }

    ~GeneratedTree() override {
        std::error_code ignored;
        std::filesystem::remove_all(root_, ignored);
    }

    void write(const std::string& path, const std::string& text) {
        std::filesystem::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }

    const std::filesystem::path& root() const { return root_; }

  private:
    std::filesystem::path root_;
};

}  // namespace candela
