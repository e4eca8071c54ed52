#include "face_parser.h"

#include <array>

namespace candela_obj {
namespace {

/// The three parts of "v/t/n" as they are written.
struct Parts {
    std::array<std::string_view, 3> texts;

    /// Which of texture coordinate and normal are there.
    bool operator==(const Parts& other) const {
        return texts[1].empty() == other.texts[1].empty() && texts[2].empty() == other.texts[2].empty();
    }
};

[[noreturn]] void failForm(const Statement& statement, std::string_view word) {
    statement.fail("'" + readable(std::string(word)) + "', but v, v/t, v//n or v/t/n was expected");
}

Parts partsOf(const Statement& statement, std::string_view word) {
    Parts parts;
    std::size_t begin = 0, count = 0;
    for (std::size_t i = 0; i <= word.size(); ++i) {
        if (i < word.size() && word[i] != '/') continue;
        if (count == parts.texts.size()) failForm(statement, word);
        parts.texts[count++] = word.substr(begin, i - begin);
        begin = i + 1;
    }
    if (parts.texts[0].empty()) failForm(statement, word);
    return parts;
}

std::string countOf(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " is there" : " are there");
}

/// None when it is out of range; the reason then goes to `reason`.
std::uint32_t resolved(std::int64_t index, std::size_t count, const char* what, std::string& reason) {
    const auto signedCount = static_cast<std::int64_t>(count);
    if (index > 0 && index <= signedCount) return static_cast<std::uint32_t>(index - 1);
    if (index < 0 && index >= -signedCount) return static_cast<std::uint32_t>(signedCount + index);
    reason = std::string(what) + " " + std::to_string(index) + ", but " +
             (index == 0 ? "they count from 1" : countOf(count));
    return none;
}

class CornerReader {
  public:
    CornerReader(const Statement& statement, Document& document)
        : statement_(statement), document_(document) {}

    Corner read(const Parts& parts) {
        Corner corner;
        corner.vertex = need(parts.texts[0], document_.positions.size(), "vertex");
        if (!parts.texts[1].empty())
            corner.uv = need(parts.texts[1], document_.uvs.size(), "texture coordinate");
        if (!parts.texts[2].empty()) corner.normal = normal(parts.texts[2]);
        return corner;
    }

  private:
    std::uint32_t need(std::string_view text, std::size_t count, const char* what) const {
        std::string reason;
        const std::uint32_t index = resolved(statement_.integer(text), count, what, reason);
        if (index == none) statement_.fail(reason);
        return index;
    }

    std::uint32_t normal(std::string_view text) {
        std::string reason;
        const std::uint32_t index =
            resolved(statement_.integer(text), document_.normals.size(), "normal", reason);
        if (index == none && !document_.normalFault) document_.normalFault = statement_.failure(reason);
        return index;
    }

    const Statement& statement_;
    Document& document_;
};

}  // namespace

void parseCorners(Statement& statement, Document& document) {
    CornerReader reader(statement, document);
    std::optional<Parts> form;
    std::size_t count = 0;
    for (; const auto word = statement.word(); ++count) {
        const Parts parts = partsOf(statement, *word);
        if (form && !(parts == *form)) statement.fail("all corners of a face must have the same form");
        form = parts;
        document.corners.push_back(reader.read(parts));
    }
    if (count < 3) statement.fail(std::to_string(count) + " corners, but 3 or more were expected");
}

}  // namespace candela_obj
