#include "statement.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace candela_plugins::obj {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

Lines::Lines(std::string_view text) : text_(text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) position_ = byteOrderMark.size();
}

std::string_view Lines::physicalLine() {
    const std::size_t end = text_.find('\n', position_);
    const std::string_view line = text_.substr(position_, end - position_);
    position_ = end == std::string_view::npos ? text_.size() : end + 1;
    ++linesRead_;
    return trimmed(line);
}

void Lines::joinContinued(std::string_view first) {
    joined_.assign(first.substr(0, first.size() - 1));
    bool continues = true;
    while (continues && position_ < text_.size()) {
        std::string_view more = physicalLine();
        continues = more.ends_with('\\');
        if (continues) more.remove_suffix(1);
        joined_ += ' ';
        joined_ += more;
    }
    line_ = trimmed(joined_);
}

bool Lines::next() {
    while (position_ < text_.size()) {
        const std::string_view line = physicalLine();
        number_ = linesRead_;
        // A backslash at the end of a comment, often part of a path, does not continue it.
        if (line.empty() || line.front() == '#') continue;
        line_ = line;
        if (line.ends_with('\\')) joinContinued(line);
        if (!line_.empty()) return true;
    }
    return false;
}

namespace {

std::string_view firstWord(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && !isBlank(text[end])) ++end;
    return text.substr(0, end);
}

std::string quoted(std::string_view text) {
    return "'" + readable(std::string(text)) + "'";
}

std::string_view withoutPlus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

std::optional<double> numberIn(std::string_view word) {
    const std::string_view digits = withoutPlus(word);
    const char* const end = digits.data() + digits.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
        // Overflow and underflow are reported alike, and leave the value unchanged.
        const bool tiny = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
        return tiny ? 0.0 : HUGE_VAL;
    }
    return value;
}

Statement::Statement(std::string_view line, std::size_t lineNumber, const std::string& file)
    : keyword_(firstWord(line)),
      rest_(trimmed(line.substr(keyword_.size()))),
      lineNumber_(lineNumber),
      file_(&file) {}

std::optional<std::string_view> Statement::word() {
    if (rest_.empty() || rest_.front() == '#') return std::nullopt;
    const std::string_view found = firstWord(rest_);
    rest_.remove_prefix(found.size());
    while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
    return found;
}

std::size_t Statement::wordsLeft() const {
    Statement copy(*this);
    std::size_t count = 0;
    while (copy.word()) ++count;
    return count;
}

std::string_view Statement::needWord(const char* what) {
    const auto found = word();
    if (!found) fail(std::string(what) + " was expected, but the line ends");
    return *found;
}

float Statement::needNumber(double limit) {
    return number(needWord("a number"), limit);
}

float Statement::number(std::string_view word, double limit) const {
    const std::optional<double> value = numberIn(word);
    if (!value) fail(quoted(word) + " is not a number");
    if (!(std::abs(*value) <= limit)) {
        char bound[32];
        const auto end = std::to_chars(bound, bound + sizeof bound, limit).ptr;
        fail(quoted(word) + ", but a number of at most " + std::string(bound, end) + " was expected");
    }
    return static_cast<float>(*value);
}

std::int64_t Statement::integer(std::string_view word) const {
    const std::string_view digits = withoutPlus(word);
    const char* const end = digits.data() + digits.size();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) fail(quoted(word) + " is not a whole number");
    if (error == std::errc::result_out_of_range) fail(quoted(word) + " is too large a number");
    return value;
}

std::string Statement::place() const {
    const std::string line = "line " + std::to_string(lineNumber_);
    return file_->empty() ? line : readable(*file_) + ", " + line;
}

Failure Statement::failure(const std::string& reason) const {
    return Failure{place(), readable(std::string(keyword_)) + ": " + reason};
}

namespace {

bool endsInMtl(std::string_view text) {
    constexpr std::string_view ending = ".mtl";
    if (text.size() < ending.size()) return false;
    const std::string_view tail = text.substr(text.size() - ending.size());
    return std::equal(tail.begin(), tail.end(), ending.begin(),
                      [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

}  // namespace

std::vector<std::string> libraryNames(std::string_view rest) {
    std::vector<std::string> names;
    rest = trimmed(rest);
    for (std::size_t end = 0; end < rest.size();) {
        if (++end < rest.size() && !isBlank(rest[end])) continue;
        if (end < rest.size() && !endsInMtl(rest.substr(0, end))) continue;
        names.emplace_back(rest.substr(0, end));
        rest = trimmed(rest.substr(end));
        end = 0;
    }
    return names;
}

std::string besideFile(const std::string& owner, std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::size_t slash = owner.rfind('/');
    return slash == std::string::npos ? path : owner.substr(0, slash + 1) + path;
}

void IgnoredStatements::count(std::string_view what, std::string_view kind, std::size_t line) {
    // A file that is no OBJ file at all has many kinds.
    constexpr std::size_t maxKinds = 32;
    for (Kind& known : kinds_) {
        if (known.what != what || known.name != kind) continue;
        ++known.count;
        return;
    }
    if (kinds_.size() < maxKinds)
        kinds_.push_back({std::string(what), std::string(kind), 1, line});
    else
        ++others_;
}

void IgnoredStatements::note(const Host& host, const std::string& file) const {
    for (const Kind& kind : kinds_) {
        const std::string times =
            kind.count == 1 ? "once, in line " : std::to_string(kind.count) + " times, first in line ";
        host.note(
            kind.what == "not drawn" ? CANDELA_NOTE_MISSING : CANDELA_NOTE_INFORMATION, readable(file),
            kind.what + ": " + readable(kind.name) + " (" + times + std::to_string(kind.firstLine) + ")");
    }
    if (others_ > 0)
        host.note(CANDELA_NOTE_INFORMATION, readable(file),
                  "not known: " + std::to_string(others_) + " statements of other kinds");
}

void noteMissingUvs(std::size_t corners, const Host& host) {
    if (corners > 0)
        host.note(CANDELA_NOTE_REPAIRED, "",
                  std::to_string(corners) + " corners have no texture coordinate and take (0, 0)");
}

}  // namespace candela_plugins::obj
