#include "frame_path.h"

#include <string>

namespace {

constexpr std::size_t plainDigits = 4;

std::string padded(int number, std::size_t digits) {
    const std::string text = std::to_string(number);
    return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

}  // namespace

std::filesystem::path framePath(const std::filesystem::path& output, const FrameRange& frames, int frame) {
    std::string name = output.filename().string();
    const std::size_t last = name.find_last_of('#');
    if (last != name.npos) {
        const std::size_t before = name.find_last_not_of('#', last);
        const std::size_t first = before == name.npos ? 0 : before + 1;
        name.replace(first, last - first + 1, padded(frame, last - first + 1));
        return output.parent_path() / name;
    }
    if (frames.first == frames.last) return output;
    std::filesystem::path numbered = output;
    return numbered.replace_extension("." + padded(frame, plainDigits) + output.extension().string());
}
