#pragma once

#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace candela {

/// A change that breaks one rule, and the expected message.
struct BrokenRule {
    const char* message;
    std::function<void(Scene&)> breakIt;
};

inline void expectMessages(const Scene& sample, const std::vector<BrokenRule>& rules) {
    for (const BrokenRule& rule : rules) {
        Scene scene = sample;
        rule.breakIt(scene);
        try {
            validate(scene);
            ADD_FAILURE() << "nothing was thrown, expected: " << rule.message;
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), rule.message);
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
        }
    }
}

template <typename Enum>
Enum unknown() {
    return static_cast<Enum>(99);
}

}  // namespace candela
