#include "lines.h"

namespace candela_obj {

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
        // The backslash of a comment, often the end of a path, continues nothing.
        if (line.empty() || line.front() == '#') continue;
        line_ = line;
        if (line.ends_with('\\')) joinContinued(line);
        if (!line_.empty()) return true;
    }
    return false;
}

}  // namespace candela_obj
