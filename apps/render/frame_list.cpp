#include "options.h"

#include "common/parse.h"

#include <algorithm>

namespace {

constexpr int lastFrameNumber = 9'999'999;
constexpr std::size_t plainDigits = 4;

std::string padded(int number, std::size_t digits) {
    const std::string text = std::to_string(number);
    return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

int parseFrame(const std::string& text, int min) {
    return static_cast<int>(parseInteger("--frames", text, min, lastFrameNumber));
}

}  // namespace

FrameList FrameList::parse(const std::string& text) {
    FrameList list;
    for (const std::string& part : splitAtCommas(text)) {
        const std::size_t dash = part.find('-');
        const std::size_t cross = part.find('x');
        if (part.empty() || (cross != part.npos && (dash == part.npos || dash > cross)))
            throw UsageError("--frames \"" + text + "\": expected frames such as 7, 0-47, 0-100x5 or 3,7,9");
        Run run{parseFrame(part.substr(0, dash), 0)};
        if (dash != part.npos) {
            const int last = parseFrame(part.substr(dash + 1, cross - dash - 1), run.first);
            if (cross != part.npos) run.step = parseFrame(part.substr(cross + 1), 1);
            run.count = static_cast<std::uint64_t>((last - run.first) / run.step) + 1;
        }
        list.add(run);
    }
    return list;
}

void FrameList::add(const Run& run) {
    runs_.push_back(run);
    count_ += run.count;
}

int FrameList::operator[](std::uint64_t index) const {
    auto run = runs_.begin();
    for (; index >= run->count; ++run) index -= run->count;
    return run->first + run->step * static_cast<int>(index);
}

int FrameList::max() const {
    int largest = 0;
    for (const Run& run : runs_)
        largest = std::max(largest, run.first + run.step * static_cast<int>(run.count - 1));
    return largest;
}

std::filesystem::path framePath(const std::filesystem::path& output, int frame) {
    std::string name = output.filename().string();
    const std::size_t last = name.find_last_of('#');
    if (last != name.npos) {
        const std::size_t before = name.find_last_not_of('#', last);
        const std::size_t first = before == name.npos ? 0 : before + 1;
        name.replace(first, last - first + 1, padded(frame, last - first + 1));
        return output.parent_path() / name;
    }
    std::filesystem::path numbered = output;
    return numbered.replace_extension("." + padded(frame, plainDigits) + output.extension().string());
}
