#include <array>

#include "document.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

using Counts = std::array<std::size_t, 3>;

Counts countsOf(const Statement& statement, const Tag& tag, std::string_view word) {
    Counts counts{};
    std::size_t slash = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const bool last = i + 1 == counts.size();
        slash = last ? word.size() : word.find('/');
        if (slash == std::string_view::npos || slash == 0)
            throw tag.failure("counts such as 2/1/0 were expected");
        const std::int64_t count = statement.integer(word.substr(0, slash));
        // No line has more words: the sum below does not overflow.
        constexpr std::int64_t maxWords = 1'000'000'000'000;
        if (count < 0 || count > maxWords) throw tag.failure("counts such as 2/1/0 were expected");
        counts[i] = static_cast<std::size_t>(count);
        if (!last) word.remove_prefix(slash + 1);
    }
    return counts;
}

}  // namespace

Tag parseTag(Statement& statement) {
    Tag tag;
    tag.place = statement.place();
    tag.name = statement.needWord("the name of a tag");
    const Counts counts = countsOf(statement, tag, statement.needWord("counts such as 2/1/0"));
    const std::size_t announced = counts[0] + counts[1] + counts[2], present = statement.wordsLeft();
    if (announced > present) {
        throw tag.failure(std::to_string(announced) + " words were expected, but " + std::to_string(present) +
                          (present == 1 ? " follows" : " follow"));
    }
    for (std::size_t i = 0; i < counts[0]; ++i) tag.integers.push_back(statement.integer(*statement.word()));
    for (std::size_t i = 0; i < counts[1]; ++i) tag.numbers.push_back(statement.number(*statement.word()));
    for (std::size_t i = 0; i < counts[2]; ++i) tag.texts.emplace_back(*statement.word());
    tag.surplusWords = statement.wordsLeft();
    return tag;
}

}  // namespace candela_plugins::obj
