#pragma once

#include <candela/error.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

/// Expects `action` to throw an `Error` of `kind` whose message is one line and contains `part`. Returns the
/// message.
inline std::string expectError(const std::function<void()>& action, candela::ErrorKind kind,
                               const std::string& part) {
    try {
        action();
    } catch (const candela::Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << text;
        EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nfound: " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        return text;
    }
    ADD_FAILURE() << "no error was thrown; expected: " << part;
    return {};
}
