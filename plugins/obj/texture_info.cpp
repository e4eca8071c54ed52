#include "material_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "references.h"

namespace candela_plugins::obj {
namespace {

using Words = std::vector<std::string_view>;

// With a larger offset a coordinate in single precision has no fraction left.
constexpr double maxOffset = 1e6;

/// From the first of `words`, which are views of one text, to the last one.
std::string_view joinedWords(const Words& words, std::size_t first, std::size_t end) {
    const char* const begin = words[first].data();
    return {begin, static_cast<std::size_t>(words[end - 1].data() + words[end - 1].size() - begin)};
}

enum class Values { numbers, switchWord, word };

/// An option of the format and the values that follow it.
struct Option {
    std::string_view name;
    Values values;
    std::size_t maxNumbers;
};

constexpr Option options[] = {
    {"-o", Values::numbers, 3},         {"-s", Values::numbers, 3},        {"-t", Values::numbers, 3},
    {"-mm", Values::numbers, 2},        {"-bm", Values::numbers, 1},       {"-boost", Values::numbers, 1},
    {"-texres", Values::numbers, 1},    {"-clamp", Values::switchWord, 0}, {"-blendu", Values::switchWord, 0},
    {"-blendv", Values::switchWord, 0}, {"-cc", Values::switchWord, 0},    {"-imfchan", Values::word, 0},
    {"-type", Values::word, 0}};

const Option* knownOption(std::string_view word) {
    const auto found = std::find_if(std::begin(options), std::end(options),
                                    [&](const Option& option) { return option.name == word; });
    return found == std::end(options) ? nullptr : found;
}

/// A name may begin with a '-', but hardly with one and a letter behind it.
bool looksLikeOption(std::string_view word) {
    const char second = word.size() > 1 ? static_cast<char>(word[1] | 0x20) : '\0';
    return word[0] == '-' && second >= 'a' && second <= 'z';
}

bool isSwitch(std::string_view word) {
    return word == "on" || word == "off";
}

/// Reads options, of which `texture` gets the values. What is to be noted is collected: words may turn out to
/// be part of the file's name.
class OptionReader {
  public:
    /// Words from `end` on are never values.
    OptionReader(const Words& words, std::size_t end, TextureInfo& texture)
        : words_(words), end_(end), texture_(texture) {}

    /// The option at `at`. Returns the index behind its values.
    std::size_t readKnown(const Option& option, std::size_t at) {
        const std::string_view name = words_[at++];
        if (option.values == Values::numbers) return readNumbers(name, option.maxNumbers, at);
        const bool isSwitchOption = option.values == Values::switchWord;
        // No file is called "on" or "off".
        if (isSwitchOption ? at >= words_.size() || !isSwitch(words_[at]) : at >= end_)
            return skipValue(name, "its value", at);
        if (name == "-clamp") texture_.clamp = words_[at] == "on";
        if (name == "-imfchan") readChannel(words_[at]);
        return at + 1;
    }

    std::vector<std::string> problems, missing;
    std::optional<std::size_t>
        wrongValue;  ///< A word that was skipped, which may be the first one of the name.

  private:
    std::size_t skipValue(std::string_view name, const char* expected, std::size_t at) {
        problems.push_back("option " + std::string(name) + " without " + expected + ", not used");
        if (at >= end_ || looksLikeOption(words_[at])) return at;
        wrongValue = at;
        return at + 1;
    }

    std::size_t readNumbers(std::string_view name, std::size_t max, std::size_t at) {
        std::array<double, 3> values{};
        std::size_t count = 0;
        for (; count < max && at < end_; ++count, ++at) {
            const auto number = numberIn(words_[at]);
            if (!number) break;
            values[count] = *number;
        }
        const bool usable = std::all_of(values.begin(), values.end(),
                                        [](double value) { return std::abs(value) <= maxOffset; });
        constexpr const char* expected = "a number of at most 1e+06";
        if (count == 0) return skipValue(name, expected, at);
        if (usable)
            take(name, values, count);
        else
            problems.push_back("option " + std::string(name) + " without " + expected + ", not used");
        return at;
    }

    void take(std::string_view name, const std::array<double, 3>& values, std::size_t count) {
        const auto takePair = [&](float(&pair)[2]) {
            for (std::size_t i = 0; i < std::min<std::size_t>(count, 2); ++i)
                pair[i] = static_cast<float>(values[i]);
        };
        const bool changesColors = name == "-mm" && (values[0] != 0.0 || (count > 1 && values[1] != 1.0));
        if (name == "-o") takePair(texture_.offset);
        if (name == "-s") takePair(texture_.scale);
        if (name == "-bm") texture_.multiplier = static_cast<float>(values[0]);
        if (name == "-t" || changesColors) missing.push_back("not drawn: option " + std::string(name));
    }

    void readChannel(std::string_view word) {
        constexpr std::string_view letters = "rgbmlz";
        constexpr Channel channels[] = {Channel::red,   Channel::green,     Channel::blue,
                                        Channel::matte, Channel::luminance, Channel::usual};
        const std::size_t letter = word.size() == 1 ? letters.find(word[0]) : letters.npos;
        if (letter == letters.npos)
            problems.emplace_back("option -imfchan other than r, g, b, m, l or z, not used");
        else
            texture_.channel = channels[letter];
    }

    const Words& words_;
    const std::size_t end_;
    TextureInfo& texture_;
};

class TextureParser {
  public:
    TextureParser(const Statement& statement, LineNotes& notes, TextureInfo& texture)
        : words_(wordsOf(statement.rest())), line_(statement.line()), notes_(notes), texture_(texture) {}

    /// Fills `texture`; its names stay empty where no file is named.
    void parse() {
        const std::size_t name = readLeading();
        if (name < words_.size()) readName(name);
    }

  private:
    /// The options before the name. Returns the index of its first word.
    std::size_t readLeading() {
        std::size_t at = 0;
        while (at < words_.size() && looksLikeOption(words_[at])) {
            // The last word is the name, and no value.
            const std::size_t end = words_.size() - 1;
            const Option* const option = knownOption(words_[at]);
            if (!option && at == end) break;
            if (!option) {
                at = skipUnknown(at, end);
                continue;
            }
            OptionReader reader(words_, end, texture_);
            at = reader.readKnown(*option, at);
            note(reader);
            if (reader.wrongValue) addOtherName(*reader.wrongValue);
        }
        return at;
    }

    void addOtherName(std::size_t first) {
        otherNames_.emplace_back(joinedWords(words_, first, words_.size()));
    }

    /// An option that is not known has numbers, a switch or a word as its value, or none: a word may also be
    /// the first one of the name.
    std::size_t skipUnknown(std::size_t at, std::size_t end) {
        notes_.countUnknown("option " + std::string(words_[at++]), line_);
        const std::size_t first = at;
        while (at < end && numberIn(words_[at])) ++at;
        if (at > first || at >= end || looksLikeOption(words_[at])) return at;
        if (!isSwitch(words_[at])) addOtherName(at);
        return at + 1;
    }

    void readName(std::size_t first) {
        const std::string_view all = joinedWords(words_, first, words_.size());
        for (std::size_t at = first + 1; at < words_.size(); ++at) {
            if (!readTrailing(at)) continue;
            texture_.names.emplace_back(joinedWords(words_, first, at));
            break;
        }
        texture_.names.emplace_back(all);
        // An option that is not known, or a comment, may be behind the name.
        const auto behind =
            std::find_if(words_.begin() + static_cast<std::ptrdiff_t>(first) + 1, words_.end(),
                         [](std::string_view word) { return word[0] == '#' || looksLikeOption(word); });
        if (behind != words_.end())
            texture_.names.emplace_back(
                joinedWords(words_, first, static_cast<std::size_t>(behind - words_.begin())));
        texture_.names.insert(texture_.names.end(), otherNames_.begin(), otherNames_.end());
    }

    /// Whether the words from `at` on are options and their values; they are read then.
    bool readTrailing(std::size_t at) {
        TextureInfo texture = texture_;
        OptionReader reader(words_, words_.size(), texture);
        while (at < words_.size()) {
            const Option* const option = knownOption(words_[at]);
            if (!option) return false;
            at = reader.readKnown(*option, at);
        }
        if (!reader.problems.empty()) return false;
        texture_ = texture;
        note(reader);
        return true;
    }

    void note(const OptionReader& reader) {
        for (const std::string& problem : reader.problems)
            notes_.count(CANDELA_NOTE_REPAIRED, problem, line_);
        for (const std::string& missing : reader.missing) notes_.count(CANDELA_NOTE_MISSING, missing, line_);
    }

    const Words words_;
    const std::size_t line_;
    LineNotes& notes_;
    TextureInfo& texture_;
    std::vector<std::string> otherNames_;
};

}  // namespace

bool TextureInfo::hasSameSampling(const TextureInfo& other) const {
    return std::equal(offset, offset + 2, other.offset) && std::equal(scale, scale + 2, other.scale) &&
           clamp == other.clamp;
}

std::optional<TextureInfo> parseTextureInfo(const Statement& statement, const std::string& materialFile,
                                            const Host& host, LineNotes& notes) {
    TextureInfo texture;
    texture.element = statement.place() + ": " + readable(std::string(statement.keyword()));
    texture.owner = materialFile;
    TextureParser(statement, notes, texture).parse();
    if (!texture.names.empty() && !namesNoFile(texture.names.front())) return texture;
    const std::string name = texture.names.empty() ? "" : texture.names.front();
    host.note(CANDELA_NOTE_REPAIRED, texture.element,
              name.empty() ? "no file is named: left out" : inQuotes(name) + " is no file: left out");
    return std::nullopt;
}

}  // namespace candela_plugins::obj
