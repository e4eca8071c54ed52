#include "statement.h"

#include <charconv>
#include <cmath>

#include "lines.h"

namespace candela_obj {
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
        // Both ends of the range are reported alike, and leave the value alone.
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

}  // namespace candela_obj
