#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../common/host.h"

namespace candela_plugins::obj {

/// One line of an OBJ or MTL file: a keyword and its words, read one after another. Numbers are read as in
/// the C locale. Reading beyond the end or a word of the wrong kind throws `Failure`, which names the
/// line and the keyword.
class Statement {
  public:
    /// `file` is the name of a file other than the scene's own, for failures, or empty.
    Statement(std::string_view line, std::size_t lineNumber, const std::string& file);

    std::string_view keyword() const { return keyword_; }
    std::size_t line() const { return lineNumber_; }

    /// The rest of the line: a name, which may hold blanks and '#'.
    std::string_view rest() const { return rest_; }
    /// The next word; none at the end of the line or before a word that begins a comment.
    std::optional<std::string_view> word();
    /// The words left.
    std::size_t wordsLeft() const;

    /// `what` is the expected item, such as "a name".
    std::string_view needWord(const char* what);
    /// The next word as a number from -limit to limit.
    float needNumber(double limit = maxNumber);
    float number(std::string_view word, double limit = maxNumber) const;
    std::int64_t integer(std::string_view word) const;

    /// Such as "line 12" or "stone.mtl, line 12".
    std::string place() const;
    Failure failure(const std::string& reason) const;
    [[noreturn]] void fail(const std::string& reason) const { throw failure(reason); }

    /// The maximum of any number of a scene.
    static constexpr double maxNumber = 3e38;

  private:
    std::string_view keyword_, rest_;
    std::size_t lineNumber_;
    const std::string* file_;
};

/// The number that all of `word` is, if it is one.
std::optional<double> numberIn(std::string_view word);

/// The lines of an OBJ or MTL file. Lines that are continued by a backslash at their end are joined; empty
/// lines, comments and the blanks around a line are omitted.
class Lines {
  public:
    explicit Lines(std::string_view text);

    /// Advances to the next line; false at the end of the text.
    bool next();
    /// Valid until `next`.
    std::string_view line() const { return line_; }
    /// The number of the first line of those joined, from 1.
    std::size_t number() const { return number_; }
    /// The bytes read so far.
    std::size_t position() const { return position_; }

  private:
    std::string_view physicalLine();
    void joinContinued(std::string_view first);

    std::string_view text_, line_;
    std::string joined_;
    std::size_t position_ = 0, linesRead_ = 0, number_ = 0;
};

/// Without the blanks at both ends. A carriage return is a blank.
std::string_view trimmed(std::string_view text);

bool isBlank(char c);

/// The files that "mtllib" names. A name may hold blanks: it ends with a word that ends in ".mtl", or with
/// the line.
std::vector<std::string> libraryNames(std::string_view rest);

/// A file that `owner` (a path relative to the scene's folder) names: relative to the folder of `owner`, and
/// with '/' in place of '\'.
std::string besideFile(const std::string& owner, std::string_view name);

/// Counts the statements of a file that are not drawn or not used, for one note of each kind.
class IgnoredStatements {
  public:
    /// `what` begins the note: "not drawn", "not used"; `kind` is the kind of statement.
    void count(std::string_view what, std::string_view kind, std::size_t line);
    /// `file` is the name of a file other than the scene's own, or empty.
    void note(const Host& host, const std::string& file) const;

  private:
    struct Kind {
        std::string what, name;
        std::size_t count = 0, firstLine = 0;
    };
    std::vector<Kind> kinds_;
    std::size_t others_ = 0;
};

/// Notes the number of corners without texture coordinates of faces that need them.
void noteMissingUvs(std::size_t corners, const Host& host);

}  // namespace candela_plugins::obj
