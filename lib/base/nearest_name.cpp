#include <candela/nearest_name.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <vector>

namespace candela {
namespace {

/// Shorter texts begin too many names.
constexpr std::size_t minPrefix = 3;

/// Longer texts are no names; comparing them would take long.
constexpr std::size_t maxLength = 100;

std::string lowered(std::string_view text) {
    std::string letters(text);
    std::ranges::transform(letters, letters.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return letters;
}

/// The optimal string alignment distance. Source: Boytsov, "Indexing methods for approximate dictionary
/// searching", 2011, 2.2.
std::size_t distanceOf(std::string_view a, std::string_view b) {
    // Rows of the table of distances between the beginnings of both: the last two, and the current one.
    std::array<std::vector<std::size_t>, 3> rows;
    for (auto& row : rows) row.resize(b.size() + 1);
    std::iota(rows[1].begin(), rows[1].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        const std::vector<std::size_t>& last = rows[0];
        const std::vector<std::size_t>& before = rows[1];
        std::vector<std::size_t>& current = rows[2];
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({before[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], last[j - 2] + 1);
        }
        std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    }
    return rows[1].back();
}

}  // namespace

std::optional<std::string> nearestName(std::string_view text, std::span<const std::string> names) {
    if (text.empty() || text.size() > maxLength) return std::nullopt;
    const std::string wanted = lowered(text);
    std::size_t least = std::max<std::size_t>(text.size() / 3, 1) + 1;
    std::optional<std::string> nearest;
    for (const std::string& name : names) {
        if (name.empty() || name.size() > maxLength) continue;
        const std::string letters = lowered(name);
        const bool isPrefix = wanted.size() >= minPrefix && letters.starts_with(wanted);
        const std::size_t distance = isPrefix ? 1 : distanceOf(wanted, letters);
        if (distance >= least) continue;
        least = distance;
        nearest = name;
    }
    return nearest;
}

std::string didYouMean(std::string_view text, std::span<const std::string> names) {
    const std::optional<std::string> name = nearestName(text, names);
    return name ? " (did you mean " + *name + "?)" : "";
}

}  // namespace candela
