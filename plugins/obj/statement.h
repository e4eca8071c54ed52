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
    void setKeyword(std::string_view keyword) { keyword_ = keyword; }
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

/// The number that all of `word` is, if it is one; also infinite, or NaN.
std::optional<double> numberIn(std::string_view word);
/// The same of a number with a decimal comma, such as "1,5".
std::optional<double> numberWithCommaIn(std::string_view word);
/// The whole number that all of `word` is, if it is one. Too large ones become the nearest that fits.
std::optional<std::int64_t> integerIn(std::string_view word);

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// The words of a text, which are separated by blanks.
std::vector<std::string_view> wordsOf(std::string_view text);

/// The bytes of a file as text.
std::string_view textOf(const Bytes& file);

/// Whether the bytes are UTF-16 text, with or without a byte order mark.
bool isUtf16(std::string_view text);

/// The lines of an OBJ or MTL file, which end with "\n", "\r\n" or "\r". Lines that are continued by a
/// backslash at their end are joined; empty lines, comments and the blanks around a line are omitted.
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
    std::size_t newline_ = 0;     ///< The first line feed at `position_` or behind it; the size for none.
    std::size_t emptyLines_ = 0;  ///< Before `position_`, not yet part of `linesRead_`.
};

/// Without the blanks at both ends. A carriage return is a blank.
std::string_view trimmed(std::string_view text);

bool isBlank(char c);

/// "'word'", for messages.
std::string inQuotes(std::string_view text);

/// Counts what statements of one file give rise to, for one note of each kind with the number of times and
/// the first line.
class LineNotes {
  public:
    /// `text` names no line: "not drawn: lines (l)".
    void count(candela_note_kind kind, std::string_view text, std::size_t line);
    /// A statement or an option that is not known.
    void countUnknown(std::string_view name, std::size_t line);
    /// `file` is the name of a file other than the scene's own, or empty.
    void add(const Host& host, const std::string& file) const;

  private:
    struct Entry {
        candela_note_kind kind;
        std::string text;
        std::size_t count, firstLine;
    };

    std::vector<Entry> entries_, unknown_;
    std::size_t otherUnknown_ = 0;
};

/// Notes the number of corners without texture coordinates of faces that need them.
void noteMissingUvs(std::size_t corners, const Host& host);

}  // namespace candela_plugins::obj
