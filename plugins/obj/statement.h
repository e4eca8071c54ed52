#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "failure.h"

namespace candela_obj {

/// One line of an OBJ or MTL file: a keyword and its words, read one after another. Numbers are read as in
/// the C locale. What reads beyond the end or meets a word of the wrong kind throws `Failure`, which names
/// the line and the keyword.
class Statement {
  public:
    /// `file` is the name of a file other than the scene's own, for failures, or empty.
    Statement(std::string_view line, std::size_t lineNumber, const std::string& file);

    std::string_view keyword() const { return keyword_; }
    std::size_t line() const { return lineNumber_; }

    /// What is left, up to the end of the line: a name, which may hold blanks and '#'.
    std::string_view rest() const { return rest_; }
    /// The next word; none at the end of the line or before a word that begins a comment.
    std::optional<std::string_view> word();
    /// The words left.
    std::size_t wordsLeft() const;

    /// `what` says what was expected: "a name".
    std::string_view needWord(const char* what);
    /// The next word as a number from -limit to limit.
    float needNumber(double limit = maxNumber);
    float number(std::string_view word, double limit = maxNumber) const;
    std::int64_t integer(std::string_view word) const;

    /// Such as "line 12" or "stone.mtl, line 12".
    std::string place() const;
    Failure failure(const std::string& reason) const;
    [[noreturn]] void fail(const std::string& reason) const { throw failure(reason); }

    /// The greatest number that a scene may hold anywhere.
    static constexpr double maxNumber = 3e38;

  private:
    std::string_view keyword_, rest_;
    std::size_t lineNumber_;
    const std::string* file_;
};

/// The number that all of `word` is, if it is one.
std::optional<double> numberIn(std::string_view word);

}  // namespace candela_obj
